(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_B_printed Part_B_proofs.
Open Scope R_scope.

Module uniform_bezier.
Import Splines.Part_B_printed.uniform_bezier.
Theorem proved : statement.
Proof. follows Splines.Part_B_proofs.uniform_bezier.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_B_proofs.uniform_bezier.met. Qed.
End uniform_bezier.
