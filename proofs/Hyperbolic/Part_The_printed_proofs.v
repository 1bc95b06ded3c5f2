(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_The_printed Part_The_proofs.
Open Scope R_scope.

Module quadratic_unity.
Import Hyperbolic.Part_The_printed.quadratic_unity.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_unity.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_unity.met. Qed.
End quadratic_unity.

Module quadratic_symmetry.
Import Hyperbolic.Part_The_printed.quadratic_symmetry.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_symmetry.met. Qed.
End quadratic_symmetry.

Module quadratic_ends.
Import Hyperbolic.Part_The_printed.quadratic_ends.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_ends.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_ends.met. Qed.
End quadratic_ends.

Module quadratic_nonnegative.
Import Hyperbolic.Part_The_printed.quadratic_nonnegative.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_nonnegative.met. Qed.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
Import Hyperbolic.Part_The_printed.quadratic_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_nonnegative_slip.refuted. Qed.
End quadratic_nonnegative_slip.

Module quadratic_decreasing.
Import Hyperbolic.Part_The_printed.quadratic_decreasing.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_decreasing.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_decreasing.met. Qed.
End quadratic_decreasing.

Module quadratic_largest.
Import Hyperbolic.Part_The_printed.quadratic_largest.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_largest.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_largest.met. Qed.
End quadratic_largest.

Module quadratic_space.
Import Hyperbolic.Part_The_printed.quadratic_space.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_space.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.quadratic_space.met. Qed.
End quadratic_space.

Module shape_unity.
Import Hyperbolic.Part_The_printed.shape_unity.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.shape_unity.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.shape_unity.met. Qed.
End shape_unity.

Module shape_symmetry.
Import Hyperbolic.Part_The_printed.shape_symmetry.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.shape_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.shape_symmetry.met. Qed.
End shape_symmetry.

Module shape_nonnegative.
Import Hyperbolic.Part_The_printed.shape_nonnegative.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_The_proofs.shape_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_The_proofs.shape_nonnegative.met. Qed.
End shape_nonnegative.
