(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3.
Import HermiteDevelopable.Section_3.Definitions.
Open Scope R_scope.
Definition f_closed := ltac:(closed_once f).
#[export] Instance f_is : Closed f _ := f_closed.
Definition part_closed := ltac:(closed_at part [0; 1; 2; 3; 4; 5]%Z).
#[export] Instance part_is : Closed part _ := part_closed.
