(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Definition_printed Part_Definition_proofs.
Open Scope R_scope.

Module bernstein_recursion.
Import Bezier.Part_Definition_printed.bernstein_recursion.
Theorem proved : statement.
Proof. follows Bezier.Part_Definition_proofs.bernstein_recursion.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Definition_proofs.bernstein_recursion.met. Qed.
End bernstein_recursion.
