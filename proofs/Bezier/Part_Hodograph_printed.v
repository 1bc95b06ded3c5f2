(* Statements of bezier, Part Hodograph. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module curve_hodograph.
(* bezier/curve.hodograph, Hodograph
   printed: C'(x) = m sum_{i=0}^{m-1} B_{i,m-1}(x) (P_{i+1} - P_i)
   stated: C'(x) == m*sum(i, 0, m - 1, B[i,m-1](x)*(P[i+1] - P[i])) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= m - 1)%Z) ->
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= i + 1 <= m)%Z) ->
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= i <= m)%Z) ->
  Derive_n (fun x => C_ P m x) 1 x = IZR m * sum 0%Z (m - 1)%Z (fun i => B x i (m - 1)%Z * (P (i + 1)%Z - P i)).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= m - 1)%Z) /\
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= i + 1 <= m)%Z) /\
  (forall i : Z, (0 <= i <= (m - 1))%Z -> (0 <= i <= m)%Z).
End curve_hodograph.
