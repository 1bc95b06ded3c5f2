(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_5.
Import HermiteDevelopable.Section_5.Definitions.
Open Scope R_scope.
Definition quintic_closed := ltac:(closed_once quintic).
#[export] Instance quintic_is : Closed quintic _ := quintic_closed.
Definition quintic__closed := ltac:(closed_once quintic_).
#[export] Instance quintic__is : Closed quintic_ _ := quintic__closed.
Definition quintic_data_closed := ltac:(stage quintic; stage quintic_; closed_once quintic_data).
#[export] Instance quintic_data_is : Closed quintic_data _ := quintic_data_closed.
Definition quintic_basis_closed := ltac:(stage quintic_data; closed_once quintic_basis).
#[export] Instance quintic_basis_is : Closed quintic_basis _ := quintic_basis_closed.
Definition blend6_closed := ltac:(closed_once blend6).
#[export] Instance blend6_is : Closed blend6 _ := blend6_closed.
Definition hermite5_closed := ltac:(stage quintic_basis; stage blend6; closed_once hermite5).
#[export] Instance hermite5_is : Closed hermite5 _ := hermite5_closed.
Definition quintic_criterion__closed := ltac:(closed_once quintic_criterion_).
#[export] Instance quintic_criterion__is : Closed quintic_criterion_ _ := quintic_criterion__closed.
Definition q0_closed := ltac:(closed_once q0).
#[export] Instance q0_is : Closed q0 _ := q0_closed.
Definition q1_closed := ltac:(closed_once q1).
#[export] Instance q1_is : Closed q1 _ := q1_closed.
Definition q0u_closed := ltac:(closed_once q0u).
#[export] Instance q0u_is : Closed q0u _ := q0u_closed.
Definition q1u_closed := ltac:(closed_once q1u).
#[export] Instance q1u_is : Closed q1u _ := q1u_closed.
Definition p0_closed := ltac:(closed_once p0).
#[export] Instance p0_is : Closed p0 _ := p0_closed.
Definition pm_closed := ltac:(closed_once pm).
#[export] Instance pm_is : Closed pm _ := pm_closed.
Definition pu_closed := ltac:(closed_once pu).
#[export] Instance pu_is : Closed pu _ := pu_closed.
Definition p5_closed := ltac:(stage hermite5; closed_once p5).
#[export] Instance p5_is : Closed p5 _ := p5_closed.
Definition q5_closed := ltac:(stage hermite5; closed_once q5).
#[export] Instance q5_is : Closed q5 _ := q5_closed.
Definition quintic_gap_closed := ltac:(stage q5; stage p5; closed_once quintic_gap).
#[export] Instance quintic_gap_is : Closed quintic_gap _ := quintic_gap_closed.
Definition quintic_part_closed := ltac:(stage quintic_gap; closed_at quintic_part [0; 1; 2; 3; 4; 5]%Z).
#[export] Instance quintic_part_is : Closed quintic_part _ := quintic_part_closed.
Definition quintic_criterion_closed := ltac:(stage quintic_part; closed_once quintic_criterion).
#[export] Instance quintic_criterion_is : Closed quintic_criterion _ := quintic_criterion_closed.
Definition quintic_criterion___closed := ltac:(stage quintic_part; closed_once quintic_criterion__).
#[export] Instance quintic_criterion___is : Closed quintic_criterion__ _ := quintic_criterion___closed.
Definition quintic_criterion____closed := ltac:(stage quintic_part; closed_once quintic_criterion___).
#[export] Instance quintic_criterion____is : Closed quintic_criterion___ _ := quintic_criterion____closed.
Definition quintic_criterion_____closed := ltac:(stage quintic_part; closed_once quintic_criterion____).
#[export] Instance quintic_criterion_____is : Closed quintic_criterion____ _ := quintic_criterion_____closed.
Definition quintic_criterion______closed := ltac:(stage quintic_part; closed_once quintic_criterion_____).
#[export] Instance quintic_criterion______is : Closed quintic_criterion_____ _ := quintic_criterion______closed.
Definition quintic_criterion_______closed := ltac:(stage quintic_part; closed_once quintic_criterion______).
#[export] Instance quintic_criterion_______is : Closed quintic_criterion______ _ := quintic_criterion_______closed.
