(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Edge.
Import Torses.Part_Edge.Definitions.
Open Scope R_scope.
Definition delta_closed := ltac:(closed_once delta).
#[export] Instance delta_is : Closed delta _ := delta_closed.
Definition s_closed := ltac:(closed_once s).
#[export] Instance s_is : Closed s _ := s_closed.
