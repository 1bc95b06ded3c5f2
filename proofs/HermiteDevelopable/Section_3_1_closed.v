(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3_1.
Import HermiteDevelopable.Section_3_1.Definitions.
Open Scope R_scope.
Definition first_closed := ltac:(closed_once first).
#[export] Instance first_is : Closed first _ := first_closed.
Definition second_closed := ltac:(closed_once second).
#[export] Instance second_is : Closed second _ := second_closed.
Definition cubic_closed := ltac:(closed_once cubic).
#[export] Instance cubic_is : Closed cubic _ := cubic_closed.
Definition cubic__closed := ltac:(closed_once cubic_).
#[export] Instance cubic__is : Closed cubic_ _ := cubic__closed.
Definition cubic_data_closed := ltac:(stage cubic; stage cubic_; closed_once cubic_data).
#[export] Instance cubic_data_is : Closed cubic_data _ := cubic_data_closed.
Definition cubic_basis_closed := ltac:(stage cubic_data; closed_once cubic_basis).
#[export] Instance cubic_basis_is : Closed cubic_basis _ := cubic_basis_closed.
Definition blend4_closed := ltac:(closed_once blend4).
#[export] Instance blend4_is : Closed blend4 _ := blend4_closed.
Definition hermite3_closed := ltac:(stage cubic_basis; stage blend4; closed_once hermite3).
#[export] Instance hermite3_is : Closed hermite3 _ := hermite3_closed.
Definition p3_closed := ltac:(stage hermite3; closed_once p3).
#[export] Instance p3_is : Closed p3 _ := p3_closed.
Definition q3_closed := ltac:(stage hermite3; closed_once q3).
#[export] Instance q3_is : Closed q3 _ := q3_closed.
Definition cubic_gap_closed := ltac:(stage q3; stage p3; closed_once cubic_gap).
#[export] Instance cubic_gap_is : Closed cubic_gap _ := cubic_gap_closed.
Definition cubic_part_closed := ltac:(stage cubic_gap; closed_at cubic_part [0; 1; 2; 3]%Z).
#[export] Instance cubic_part_is : Closed cubic_part _ := cubic_part_closed.
