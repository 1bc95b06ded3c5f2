(* Statements of bezier, Part Partition. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module bernstein_unity.
(* bezier/bernstein.unity, Partition of unity
   printed: The Bernstein polynomials of degree m sum to one.
   stated: sum(i, 0, m, B[i,m](x)) == 1 *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (m : Z) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  sum 0%Z m (fun i => B x i m) = 1.
Definition instance : Prop :=
exists (m : Z) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z).
End bernstein_unity.

Module trigonometric_unity.
(* bezier/trigonometric.unity, Partition of unity
   printed: The four functions sum to one.
   stated: sum(i, 0, 3, T[i,3](x)) == 1 *)
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
Definition statement : Prop :=
forall (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z 3%Z (fun i => T x lambda mu i 3%Z) = 1.
Definition instance : Prop :=
exists (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1 /\
  0 <= x <= 1.
End trigonometric_unity.
