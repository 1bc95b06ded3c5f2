(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_One_printed Part_One_proofs.
Open Scope R_scope.

Module clamped_bernstein.
Import Splines.Part_One_printed.clamped_bernstein.
Theorem proved : statement.
Proof. follows Splines.Part_One_proofs.clamped_bernstein.proved. Qed.
End clamped_bernstein.
