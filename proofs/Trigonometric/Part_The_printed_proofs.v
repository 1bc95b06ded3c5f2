(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_The_printed Part_The_proofs.
Open Scope R_scope.

Module quadratic_middle.
Import Trigonometric.Part_The_printed.quadratic_middle.
Theorem proved : statement.
Proof. follows Trigonometric.Part_The_proofs.quadratic_middle.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_The_proofs.quadratic_middle.met. Qed.
End quadratic_middle.

Module quadratic_nonnegative.
Import Trigonometric.Part_The_printed.quadratic_nonnegative.
Theorem proved : statement.
Proof. follows Trigonometric.Part_The_proofs.quadratic_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_The_proofs.quadratic_nonnegative.met. Qed.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
Import Trigonometric.Part_The_printed.quadratic_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_The_proofs.quadratic_nonnegative_slip.refuted. Qed.
End quadratic_nonnegative_slip.

Module quadratic_symmetry.
Import Trigonometric.Part_The_printed.quadratic_symmetry.
Theorem proved : statement.
Proof. follows Trigonometric.Part_The_proofs.quadratic_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_The_proofs.quadratic_symmetry.met. Qed.
End quadratic_symmetry.

Module quadratic_decreasing.
Import Trigonometric.Part_The_printed.quadratic_decreasing.
Theorem proved : statement.
Proof. follows Trigonometric.Part_The_proofs.quadratic_decreasing.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_The_proofs.quadratic_decreasing.met. Qed.
End quadratic_decreasing.
