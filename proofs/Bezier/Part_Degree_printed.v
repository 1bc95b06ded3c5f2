(* Statements of bezier, Part Degree. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
End Definitions.
Import Definitions.

Module bernstein_elevation.
(* bezier/bernstein.elevation, Degree elevation
   printed: (m + 1) B_{i,m}(x) = (m + 1 - i) B_{i,m+1}(x) + (i + 1) B_{i+1,m+1}(x)
   stated: (m + 1)*B[i,m](x) == (m + 1 - i)*B[i,m+1](x) + (i + 1)*B[i+1,m+1](x) *)
Definition statement : Prop :=
forall (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z ->
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z ->
  (0 <= m + 1)%Z ->
  (IZR m + 1) * B x i m = (IZR m + 1 - IZR i) * B x i (m + 1)%Z + (IZR i + 1) * B x (i + 1)%Z (m + 1)%Z.
Definition instance : Prop :=
exists (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z /\
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (0 <= m)%Z /\
  (0 <= m + 1)%Z.
End bernstein_elevation.

Module curve_elevation.
(* bezier/curve.elevation, Degree elevation
   printed: C(x) = sum_{i=0}^{m+1} B_{i,m+1}(x) (i/(m+1) P_{i-1} + (1 - i/(m+1)) P_i)
   read as: P_{-1} and P_{m+1} have the factor zero.
   stated: C(x) == sum(i, 0, m + 1, B[i,m+1](x)*(i/(m + 1)*P[i-1] + (1 - i/(m + 1))*P[i])) *)
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (-1 <= i <= m + 1)%Z) ->
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (0 <= m + 1)%Z) ->
  (forall i : Z, (0 <= i <= (m + 1))%Z -> IZR m + 1 <> 0) ->
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (-1 <= i - 1 <= m + 1)%Z) ->
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (-1 <= i <= m + 1)%Z) ->
  C_ P m x = sum 0%Z (m + 1)%Z (fun i => B x i (m + 1)%Z * (IZR i / (IZR m + 1) * P (i - 1)%Z + (1 - IZR i / (IZR m + 1)) * P i)).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (-1 <= i <= m + 1)%Z) /\
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (0 <= m + 1)%Z) /\
  (forall i : Z, (0 <= i <= (m + 1))%Z -> IZR m + 1 <> 0) /\
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (-1 <= i - 1 <= m + 1)%Z) /\
  (forall i : Z, (0 <= i <= (m + 1))%Z -> (-1 <= i <= m + 1)%Z).
End curve_elevation.
