(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Tangent.
Import Torses.Part_Tangent.Definitions.
Open Scope R_scope.
Definition T_closed := ltac:(closed_once T).
#[export] Instance T_is : Closed T _ := T_closed.
Definition T__closed := ltac:(closed_once T_).
#[export] Instance T__is : Closed T_ _ := T__closed.
Definition NT_closed := ltac:(stage T; stage T_; closed_once NT).
#[export] Instance NT_is : Closed NT _ := NT_closed.
