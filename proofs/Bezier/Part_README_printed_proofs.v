(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_README_printed Part_README_proofs.
Open Scope R_scope.

Module language_numbers.
Import Bezier.Part_README_printed.language_numbers.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_numbers.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_numbers.met. Qed.
End language_numbers.

Module language_calculus.
Import Bezier.Part_README_printed.language_calculus.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_calculus.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_calculus.met. Qed.
End language_calculus.

Module language_vectors.
Import Bezier.Part_README_printed.language_vectors.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_vectors.proved. Qed.
End language_vectors.

Module language_matrices.
Import Bezier.Part_README_printed.language_matrices.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_matrices.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_matrices.met. Qed.
End language_matrices.

Module language_decimals.
Import Bezier.Part_README_printed.language_decimals.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_decimals.proved. Qed.
End language_decimals.

Module language_divisor.
Import Bezier.Part_README_printed.language_divisor.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_divisor.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_divisor.met. Qed.
End language_divisor.

Module language_degree.
Import Bezier.Part_README_printed.language_degree.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_degree.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_degree.met. Qed.
End language_degree.

Module language_order.
Import Bezier.Part_README_printed.language_order.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_order.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_order.met. Qed.
End language_order.

Module language_order_false.
Import Bezier.Part_README_printed.language_order_false.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_README_proofs.language_order_false.refuted. Qed.
End language_order_false.

Module language_assumed.
Import Bezier.Part_README_printed.language_assumed.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_assumed.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_assumed.met. Qed.
End language_assumed.

Module language_declared.
Import Bezier.Part_README_printed.language_declared.
Theorem proved : statement.
Proof. follows Bezier.Part_README_proofs.language_declared.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_README_proofs.language_declared.met. Qed.
End language_declared.

Module language_decimals_false.
Import Bezier.Part_README_printed.language_decimals_false.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_README_proofs.language_decimals_false.refuted. Qed.
End language_decimals_false.
