(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_G_printed Part_G_proofs.
Open Scope R_scope.

Module join_G2.
Import Bezier.Part_G_printed.join_G2.
Theorem proved : statement.
Proof. follows Bezier.Part_G_proofs.join_G2.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_G_proofs.join_G2.met. Qed.
End join_G2.
