(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Joins_printed Part_Joins_proofs.
Open Scope R_scope.

Module quadratic_join.
Import Trigonometric.Part_Joins_printed.quadratic_join.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Joins_proofs.quadratic_join.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Joins_proofs.quadratic_join.met. Qed.
End quadratic_join.

Module quadratic_join_slip.
Import Trigonometric.Part_Joins_printed.quadratic_join_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted. Qed.
End quadratic_join_slip.

Module quadratic_join_slip_corrected.
Import Trigonometric.Part_Joins_printed.quadratic_join_slip_corrected.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met. Qed.
End quadratic_join_slip_corrected.
