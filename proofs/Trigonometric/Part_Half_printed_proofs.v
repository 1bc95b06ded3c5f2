(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Half_printed Part_Half_proofs.
Open Scope R_scope.

Module angle_half_sine.
Import Trigonometric.Part_Half_printed.angle_half_sine.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.angle_half_sine.proved. Qed.
End angle_half_sine.

Module angle_half_cosine.
Import Trigonometric.Part_Half_printed.angle_half_cosine.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.angle_half_cosine.proved. Qed.
End angle_half_cosine.

Module angle_half_slip.
Import Trigonometric.Part_Half_printed.angle_half_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Half_proofs.angle_half_slip.refuted. Qed.
End angle_half_slip.

Module angle_half_slip_corrected.
Import Trigonometric.Part_Half_printed.angle_half_slip_corrected.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.angle_half_slip_corrected.proved. Qed.
End angle_half_slip_corrected.

Module half_unity.
Import Trigonometric.Part_Half_printed.half_unity.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_unity.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_unity.met. Qed.
End half_unity.

Module half_middle.
Import Trigonometric.Part_Half_printed.half_middle.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_middle.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_middle.met. Qed.
End half_middle.

Module half_sine.
Import Trigonometric.Part_Half_printed.half_sine.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_sine.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_sine.met. Qed.
End half_sine.

Module half_cosine.
Import Trigonometric.Part_Half_printed.half_cosine.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_cosine.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_cosine.met. Qed.
End half_cosine.

Module half_cosine_slip.
Import Trigonometric.Part_Half_printed.half_cosine_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Half_proofs.half_cosine_slip.refuted. Qed.
End half_cosine_slip.

Module half_powers.
Import Trigonometric.Part_Half_printed.half_powers.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_powers.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_powers.met. Qed.
End half_powers.

Module half_d1.
Import Trigonometric.Part_Half_printed.half_d1.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_d1.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_d1.met. Qed.
End half_d1.

Module half_d1_slip.
Import Trigonometric.Part_Half_printed.half_d1_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Half_proofs.half_d1_slip.refuted. Qed.
End half_d1_slip.

Module half_d1_slip_corrected.
Import Trigonometric.Part_Half_printed.half_d1_slip_corrected.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Half_proofs.half_d1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Half_proofs.half_d1_slip_corrected.met. Qed.
End half_d1_slip_corrected.
