(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3_3.
Import HermiteDevelopable.Section_3_3.Definitions.
Open Scope R_scope.
Definition quintic_closed := ltac:(closed_once quintic).
#[export] Instance quintic_is : Closed quintic _ := quintic_closed.
Definition quintic__closed := ltac:(closed_once quintic_).
#[export] Instance quintic__is : Closed quintic_ _ := quintic__closed.
Definition quintic_data_closed := ltac:(stage quintic; stage quintic_; closed_once quintic_data).
#[export] Instance quintic_data_is : Closed quintic_data _ := quintic_data_closed.
Definition quintic_basis_closed := ltac:(stage quintic_data; closed_once quintic_basis).
#[export] Instance quintic_basis_is : Closed quintic_basis _ := quintic_basis_closed.
