(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From HermiteDevelopable Require Section_3.
Import HermiteDevelopable.Section_3.Definitions.
Open Scope R_scope.
Definition q_closed := ltac:(closed_once q).
#[export] Instance q_is : Closed q _ := q_closed.
Definition q__closed := ltac:(closed_once q_).
#[export] Instance q__is : Closed q_ _ := q__closed.
Definition p__closed := ltac:(closed_once p_).
#[export] Instance p__is : Closed p_ _ := p__closed.
Definition p_closed := ltac:(closed_once p).
#[export] Instance p_is : Closed p _ := p_closed.
