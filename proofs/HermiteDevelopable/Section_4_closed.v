(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_4.
Import HermiteDevelopable.Section_4.Definitions.
Open Scope R_scope.
Definition quintic_closed := ltac:(closed_once quintic).
#[export] Instance quintic_is : Closed quintic _ := quintic_closed.
Definition quintic__closed := ltac:(closed_once quintic_).
#[export] Instance quintic__is : Closed quintic_ _ := quintic__closed.
Definition quintic_data_closed := ltac:(stage quintic; stage quintic_; closed_once quintic_data).
#[export] Instance quintic_data_is : Closed quintic_data _ := quintic_data_closed.
Definition quintic_basis_closed := ltac:(stage quintic_data; closed_once quintic_basis).
#[export] Instance quintic_basis_is : Closed quintic_basis _ := quintic_basis_closed.
Definition r0_closed := ltac:(closed_once r0).
#[export] Instance r0_is : Closed r0 _ := r0_closed.
Definition normal_closed := ltac:(closed_once normal).
#[export] Instance normal_is : Closed normal _ := normal_closed.
Definition image_closed := ltac:(stage normal; closed_once image).
#[export] Instance image_is : Closed image _ := image_closed.
Definition r_closed := ltac:(stage image; closed_once r).
#[export] Instance r_is : Closed r _ := r_closed.
Definition r1_closed := ltac:(stage image; closed_once r1).
#[export] Instance r1_is : Closed r1 _ := r1_closed.
Definition r0u_closed := ltac:(stage normal; closed_once r0u).
#[export] Instance r0u_is : Closed r0u _ := r0u_closed.
Definition r1u_closed := ltac:(stage normal; stage r1; closed_once r1u).
#[export] Instance r1u_is : Closed r1u _ := r1u_closed.
Definition ru_closed := ltac:(stage normal; stage r; closed_once ru).
#[export] Instance ru_is : Closed ru _ := ru_closed.
