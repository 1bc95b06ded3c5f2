(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
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
Definition blend5_closed := ltac:(closed_once blend5).
#[export] Instance blend5_is : Closed blend5 _ := blend5_closed.
Definition hermite4_closed := ltac:(stage quartic_basis; stage blend5; closed_once hermite4).
#[export] Instance hermite4_is : Closed hermite4 _ := hermite4_closed.
Definition quartic_criterion__closed := ltac:(closed_once quartic_criterion_).
#[export] Instance quartic_criterion__is : Closed quartic_criterion_ _ := quartic_criterion__closed.
Definition A36_closed := ltac:(closed_once A36).
#[export] Instance A36_is : Closed A36 _ := A36_closed.
Definition q4_closed := ltac:(stage hermite4; closed_once q4).
#[export] Instance q4_is : Closed q4 _ := q4_closed.
Definition p4_closed := ltac:(stage hermite4; closed_once p4).
#[export] Instance p4_is : Closed p4 _ := p4_closed.
Definition quartic_gap_closed := ltac:(stage q4; stage p4; closed_once quartic_gap).
#[export] Instance quartic_gap_is : Closed quartic_gap _ := quartic_gap_closed.
Definition quartic_part_closed := ltac:(stage quartic_gap; closed_at quartic_part [0; 1; 2; 3; 4]%Z).
#[export] Instance quartic_part_is : Closed quartic_part _ := quartic_part_closed.
Definition quartic_system_closed := ltac:(stage quartic_part; closed_once quartic_system).
#[export] Instance quartic_system_is : Closed quartic_system _ := quartic_system_closed.
Definition quartic_criterion_closed := ltac:(stage quartic_part; closed_once quartic_criterion).
#[export] Instance quartic_criterion_is : Closed quartic_criterion _ := quartic_criterion_closed.
Definition quartic_criterion___closed := ltac:(stage quartic_part; closed_once quartic_criterion__).
#[export] Instance quartic_criterion___is : Closed quartic_criterion__ _ := quartic_criterion___closed.
Definition quartic_criterion____closed := ltac:(stage quartic_part; closed_once quartic_criterion___).
#[export] Instance quartic_criterion____is : Closed quartic_criterion___ _ := quartic_criterion____closed.
Definition quartic_criterion_____closed := ltac:(stage quartic_part; closed_once quartic_criterion____).
#[export] Instance quartic_criterion_____is : Closed quartic_criterion____ _ := quartic_criterion_____closed.
Definition quartic_criterion______closed := ltac:(stage quartic_part; closed_once quartic_criterion_____).
#[export] Instance quartic_criterion______is : Closed quartic_criterion_____ _ := quartic_criterion______closed.
