(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Curvature.
Import Torses.Part_Curvature.Definitions.
Open Scope R_scope.
Definition X_closed := ltac:(closed_once X).
#[export] Instance X_is : Closed X _ := X_closed.
Definition X__closed := ltac:(closed_once X_).
#[export] Instance X__is : Closed X_ _ := X__closed.
Definition delta_closed := ltac:(closed_once delta).
#[export] Instance delta_is : Closed delta _ := delta_closed.
Definition X___closed := ltac:(closed_once X__).
#[export] Instance X___is : Closed X__ _ := X___closed.
Definition N__closed := ltac:(stage X_; stage X__; closed_once N_).
#[export] Instance N__is : Closed N_ _ := N__closed.
Definition K_closed := ltac:(stage X__; stage N_; closed_once K).
#[export] Instance K_is : Closed K _ := K_closed.
Definition M_closed := ltac:(stage X_; stage N_; closed_once M).
#[export] Instance M_is : Closed M _ := M_closed.
Definition L_closed := ltac:(stage X; stage N_; closed_once L).
#[export] Instance L_is : Closed L _ := L_closed.
