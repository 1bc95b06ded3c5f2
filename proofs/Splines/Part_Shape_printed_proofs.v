(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Shape_printed Part_Shape_proofs.
Open Scope R_scope.

Module uniform_line.
Import Splines.Part_Shape_printed.uniform_line.
Theorem proved : statement.
Proof. follows Splines.Part_Shape_proofs.uniform_line.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Shape_proofs.uniform_line.met. Qed.
End uniform_line.
