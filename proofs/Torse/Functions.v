(* What a declared function is: read with Defs.v where a statement has functions. *)
From Torse Require Import Defs.
Open Scope R_scope.

(* it has derivatives of every order everywhere *)
Definition smooth (f : R -> R) : Prop := forall n x, ex_derive_n f n x.
