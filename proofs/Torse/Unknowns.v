(* Equations that determine unknowns one after the other: nobody has to read it.
   What is solved already is put in as it stands: normal forms of quotients would pile up. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations.
From Coq Require Import Lra Lia.
Open Scope R_scope.

Ltac put_in := repeat match goal with
  | M : unknown_value ?x, E : ?x = ?t |- _ => clear M; subst x
  | M : unknown_value ?x, E : ?t = ?x |- _ => clear M; subst x
  end.
Ltac finished ::= put_in; repeat solve_one; parts; first [assumption | lra | field; different | atoms; equal].
