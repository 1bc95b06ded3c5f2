(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Quadratic_printed Part_Quadratic_proofs.
Open Scope R_scope.

Module uniform_quadratic.
Import Splines.Part_Quadratic_printed.uniform_quadratic.
Theorem proved : statement.
Proof. follows Splines.Part_Quadratic_proofs.uniform_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Quadratic_proofs.uniform_quadratic.met. Qed.
End uniform_quadratic.
