(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Curves_printed Part_Curves_proofs.
Open Scope R_scope.

Module quadratic_ends.
Import Trigonometric.Part_Curves_printed.quadratic_ends.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_ends.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_ends.met. Qed.
End quadratic_ends.

Module quadratic_d1.
Import Trigonometric.Part_Curves_printed.quadratic_d1.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d1.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d1.met. Qed.
End quadratic_d1.

Module quadratic_d2.
Import Trigonometric.Part_Curves_printed.quadratic_d2.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d2.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d2.met. Qed.
End quadratic_d2.

Module quadratic_d1_slip.
Import Trigonometric.Part_Curves_printed.quadratic_d1_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted. Qed.
End quadratic_d1_slip.

Module quadratic_d1_slip_corrected.
Import Trigonometric.Part_Curves_printed.quadratic_d1_slip_corrected.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met. Qed.
End quadratic_d1_slip_corrected.
