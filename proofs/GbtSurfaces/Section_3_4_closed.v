(* Closed forms of the definitions of a section: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtSurfaces Require Section_3_4.
Import GbtSurfaces.Section_3_4.Definitions.
Open Scope R_scope.
Definition f_closed := ltac:(closed_once f).
#[export] Instance f_is : Closed f _ := f_closed.
Definition FX_closed := ltac:(stage f; closed_once FX).
#[export] Instance FX_is : Closed FX _ := FX_closed.
Definition FZ_closed := ltac:(stage f; closed_once FZ).
#[export] Instance FZ_is : Closed FZ _ := FZ_closed.
Definition swung_closed := ltac:(closed_once swung).
#[export] Instance swung_is : Closed swung _ := swung_closed.
Definition FX2_closed := ltac:(stage f; closed_once FX2).
#[export] Instance FX2_is : Closed FX2 _ := FX2_closed.
Definition FZ2_closed := ltac:(stage f; closed_once FZ2).
#[export] Instance FZ2_is : Closed FZ2 _ := FZ2_closed.
Definition along_profiles_closed := ltac:(stage FX2; stage FZ2; stage FX; stage FZ; stage swung; closed_at along_profiles [0; 1; 2]%Z).
#[export] Instance along_profiles_is : Closed along_profiles _ := along_profiles_closed.
Definition a_closed := ltac:(closed_once a).
#[export] Instance a_is : Closed a _ := a_closed.
