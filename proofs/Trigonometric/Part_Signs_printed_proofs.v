(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Signs_printed Part_Signs_proofs.
Open Scope R_scope.

Module angle_first.
Import Trigonometric.Part_Signs_printed.angle_first.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Signs_proofs.angle_first.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Signs_proofs.angle_first.met. Qed.
End angle_first.

Module angle_first_turned.
Import Trigonometric.Part_Signs_printed.angle_first_turned.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Signs_proofs.angle_first_turned.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Signs_proofs.angle_first_turned.met. Qed.
End angle_first_turned.

Module angle_symmetric.
Import Trigonometric.Part_Signs_printed.angle_symmetric.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Signs_proofs.angle_symmetric.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Signs_proofs.angle_symmetric.met. Qed.
End angle_symmetric.

Module angle_symmetric_slip.
Import Trigonometric.Part_Signs_printed.angle_symmetric_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted. Qed.
End angle_symmetric_slip.

Module angle_turn.
Import Trigonometric.Part_Signs_printed.angle_turn.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Signs_proofs.angle_turn.proved. Qed.
End angle_turn.
