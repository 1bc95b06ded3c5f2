(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_2_3.
Import GbtDevelopable.Section_2_3.Definitions.
Open Scope R_scope.
Definition g_closed := ltac:(closed_once g).
#[export] Instance g_is : Closed g _ := g_closed.
