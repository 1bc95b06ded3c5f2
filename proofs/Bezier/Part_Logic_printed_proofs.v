(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Logic_printed Part_Logic_proofs.
Open Scope R_scope.

Module reach_implies.
Import Bezier.Part_Logic_printed.reach_implies.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_implies.proved. Qed.
End reach_implies.

Module reach_length_zero.
Import Bezier.Part_Logic_printed.reach_length_zero.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_length_zero.proved. Qed.
End reach_length_zero.

Module reach_product_zero.
Import Bezier.Part_Logic_printed.reach_product_zero.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_product_zero.proved. Qed.
End reach_product_zero.

Module reach_roots.
Import Bezier.Part_Logic_printed.reach_roots.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_roots.proved. Qed.
End reach_roots.

Module reach_roots_slip.
Import Bezier.Part_Logic_printed.reach_roots_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Logic_proofs.reach_roots_slip.refuted. Qed.
End reach_roots_slip.

Module reach_weights_zero.
Import Bezier.Part_Logic_printed.reach_weights_zero.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_weights_zero.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Logic_proofs.reach_weights_zero.met. Qed.
End reach_weights_zero.

Module reach_circle_bound.
Import Bezier.Part_Logic_printed.reach_circle_bound.
Theorem proved : statement.
Proof. follows Bezier.Part_Logic_proofs.reach_circle_bound.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Logic_proofs.reach_circle_bound.met. Qed.
End reach_circle_bound.
