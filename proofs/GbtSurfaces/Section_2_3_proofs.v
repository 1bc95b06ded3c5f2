(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtSurfaces Require Section_2_3.
Open Scope R_scope.

Module sec_2_3_classical_every_property.
Import GbtSurfaces.Section_2_3.sec_2_3_classical_every_property.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z ((2))%Z (1) (1) (1) (1) (1/3) (1/2)). Qed.
End sec_2_3_classical_every_property.
