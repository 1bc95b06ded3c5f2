(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Closed_printed Part_Closed_proofs.
Open Scope R_scope.

Module bernstein_formula.
Import Bezier.Part_Closed_printed.bernstein_formula.
Theorem proved : statement.
Proof. follows Bezier.Part_Closed_proofs.bernstein_formula.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Closed_proofs.bernstein_formula.met. Qed.
End bernstein_formula.
