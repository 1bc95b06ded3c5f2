(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Normal.
Import Torses.Part_Normal.Definitions.
Open Scope R_scope.
Definition X_closed := ltac:(closed_once X).
#[export] Instance X_is : Closed X _ := X_closed.
Definition X__closed := ltac:(closed_once X_).
#[export] Instance X__is : Closed X_ _ := X__closed.
Definition N__closed := ltac:(stage X; stage X_; closed_once N_).
#[export] Instance N__is : Closed N_ _ := N__closed.
Definition delta_closed := ltac:(closed_once delta).
#[export] Instance delta_is : Closed delta _ := delta_closed.
