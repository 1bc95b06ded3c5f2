(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Polynomials_printed Part_Polynomials_proofs.
Open Scope R_scope.

Module uniform_greville.
Import Splines.Part_Polynomials_printed.uniform_greville.
Theorem proved : statement.
Proof. follows Splines.Part_Polynomials_proofs.uniform_greville.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Polynomials_proofs.uniform_greville.met. Qed.
End uniform_greville.

Module uniform_marsden.
Import Splines.Part_Polynomials_printed.uniform_marsden.
Theorem proved : statement.
Proof. follows Splines.Part_Polynomials_proofs.uniform_marsden.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Polynomials_proofs.uniform_marsden.met. Qed.
End uniform_marsden.

Module uniform_marsden_slip.
Import Splines.Part_Polynomials_printed.uniform_marsden_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Polynomials_proofs.uniform_marsden_slip.refuted. Qed.
End uniform_marsden_slip.

Module knots_greville.
Import Splines.Part_Polynomials_printed.knots_greville.
Theorem proved : statement.
Proof. follows Splines.Part_Polynomials_proofs.knots_greville.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Polynomials_proofs.knots_greville.met. Qed.
End knots_greville.

Module knots_marsden.
Import Splines.Part_Polynomials_printed.knots_marsden.
Theorem proved : statement.
Proof. follows Splines.Part_Polynomials_proofs.knots_marsden.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Polynomials_proofs.knots_marsden.met. Qed.
End knots_marsden.

Module knots_marsden_cubic.
Import Splines.Part_Polynomials_printed.knots_marsden_cubic.
Theorem proved : statement.
Proof. follows Splines.Part_Polynomials_proofs.knots_marsden_cubic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Polynomials_proofs.knots_marsden_cubic.met. Qed.
End knots_marsden_cubic.
