(* Statements of bezier, Part Subdivision. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module curve_midpoint.
(* bezier/curve.midpoint, Subdivision of a cubic at 1/2
   printed: C(1/2) = (P_0 + 3P_1 + 3P_2 + P_3)/8
   stated: K(1/2) == 1/8*(P[0] + 3*P[1] + 3*P[2] + P[3]) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition K (P : Z -> R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => B x i 3%Z * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  (0 <= 3 <= m)%Z ->
  K P (1 / 2) = 1 / 8 * (P 0%Z + 3 * P 1%Z + 3 * P 2%Z + P 3%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 2 <= m)%Z /\
  (0 <= 3 <= m)%Z.
End curve_midpoint.
