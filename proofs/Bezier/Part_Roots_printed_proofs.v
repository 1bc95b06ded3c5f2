(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Roots_printed Part_Roots_proofs.
Open Scope R_scope.

Module reach_unit.
Import Bezier.Part_Roots_printed.reach_unit.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_unit.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_unit.met. Qed.
End reach_unit.

Module reach_unit_zero.
Import Bezier.Part_Roots_printed.reach_unit_zero.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_unit_zero.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_unit_zero.met. Qed.
End reach_unit_zero.

Module reach_size.
Import Bezier.Part_Roots_printed.reach_size.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_size.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_size.met. Qed.
End reach_size.

Module reach_size_slip.
Import Bezier.Part_Roots_printed.reach_size_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Roots_proofs.reach_size_slip.refuted. Qed.
End reach_size_slip.

Module reach_product.
Import Bezier.Part_Roots_printed.reach_product.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_product.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_product.met. Qed.
End reach_product.

Module reach_least.
Import Bezier.Part_Roots_printed.reach_least.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_least.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_least.met. Qed.
End reach_least.

Module reach_triangle.
Import Bezier.Part_Roots_printed.reach_triangle.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_triangle.proved. Qed.
End reach_triangle.

Module reach_triangle_slip.
Import Bezier.Part_Roots_printed.reach_triangle_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Roots_proofs.reach_triangle_slip.refuted. Qed.
End reach_triangle_slip.

Module reach_subadditive.
Import Bezier.Part_Roots_printed.reach_subadditive.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_subadditive.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_subadditive.met. Qed.
End reach_subadditive.

Module reach_above.
Import Bezier.Part_Roots_printed.reach_above.
Theorem proved : statement.
Proof. follows Bezier.Part_Roots_proofs.reach_above.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Roots_proofs.reach_above.met. Qed.
End reach_above.
