(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtSurfaces Require Section_3_5.
Import GbtSurfaces.Section_3_5.Definitions.
Open Scope R_scope.
Definition f_closed := ltac:(closed_once f).
#[export] Instance f_is : Closed f _ := f_closed.
Definition S1_closed := ltac:(closed_once S1).
#[export] Instance S1_is : Closed S1 _ := S1_closed.
Definition S2_closed := ltac:(closed_once S2).
#[export] Instance S2_is : Closed S2 _ := S2_closed.
Definition T1_closed := ltac:(closed_once T1).
#[export] Instance T1_is : Closed T1 _ := T1_closed.
Definition T2_closed := ltac:(closed_once T2).
#[export] Instance T2_is : Closed T2 _ := T2_closed.
Definition second_closed := ltac:(stage f; closed_once second).
#[export] Instance second_is : Closed second _ := second_closed.
Definition first_closed := ltac:(stage f; closed_once first).
#[export] Instance first_is : Closed first _ := first_closed.
Definition gap_closed := ltac:(stage second; stage first; closed_once gap).
#[export] Instance gap_is : Closed gap _ := gap_closed.
