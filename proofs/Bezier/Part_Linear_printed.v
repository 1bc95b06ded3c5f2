(* Statements of bezier, Part Linear. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module bernstein_precision.
(* bezier/bernstein.precision, Linear precision
   printed: sum_{i=0}^{m} (i/m) B_{i,m}(x) = x
   stated: sum(i, 0, m, i/m*B[i,m](x)) == x *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (m : Z) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> IZR m <> 0) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  sum 0%Z m (fun i => IZR i / IZR m * B x i m) = x.
Definition instance : Prop :=
exists (m : Z) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> IZR m <> 0) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z).
End bernstein_precision.
