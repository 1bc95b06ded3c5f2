(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3_2.
Import HermiteDevelopable.Section_3_2.Definitions.
Open Scope R_scope.
Definition quartic_closed := ltac:(closed_once quartic).
#[export] Instance quartic_is : Closed quartic _ := quartic_closed.
Definition quartic__closed := ltac:(closed_once quartic_).
#[export] Instance quartic__is : Closed quartic_ _ := quartic__closed.
Definition quartic_data_closed := ltac:(stage quartic; stage quartic_; closed_once quartic_data).
#[export] Instance quartic_data_is : Closed quartic_data _ := quartic_data_closed.
Definition quartic_basis_closed := ltac:(stage quartic_data; closed_once quartic_basis).
#[export] Instance quartic_basis_is : Closed quartic_basis _ := quartic_basis_closed.
