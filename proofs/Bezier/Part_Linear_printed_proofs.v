(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Linear_printed Part_Linear_proofs.
Open Scope R_scope.

Module bernstein_precision.
Import Bezier.Part_Linear_printed.bernstein_precision.
Theorem proved : statement.
Proof. follows Bezier.Part_Linear_proofs.bernstein_precision.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Linear_proofs.bernstein_precision.met. Qed.
End bernstein_precision.
