(* Statements of splines, Part Partition. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
End Definitions.
Import Definitions.

Module uniform_unity.
(* splines/uniform.unity, Partition of unity
   printed: The functions of degree 2, and those of degree 3, add up to 1.
   stated: sum(i, 0, 2, U[i,2](s)) == 1 and sum(i, 0, 3, U[i,3](s)) == 1 *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  sum 0%Z 2%Z (fun i => U s i 2%Z) = 1 /\ sum 0%Z 3%Z (fun i => U s i 3%Z) = 1.
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_unity.

Module knots_unity_quadratic.
(* splines/knots.unity.quadratic, Partition of unity
   printed: The functions of degree 2 on the span of t_2 and t_3 add up to 1.
   stated: sum(i, 0, 2, N[i,2](x, 2)) == 1 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0) ->
  sum 0%Z 2%Z (fun i => N_ t x 2%Z i 2%Z) = 1.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0).
End knots_unity_quadratic.

Module knots_unity_cubic.
(* splines/knots.unity.cubic, Partition of unity
   printed: The functions of degree 3 on the span of t_3 and t_4 add up to 1.
   stated: sum(i, 0, 3, N[i,3](x, 3)) == 1 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 4%Z < t 5%Z ->
  t 5%Z < t 6%Z ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 3%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 3%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 6%Z - t 3%Z <> 0) ->
  sum 0%Z 3%Z (fun i => N_ t x 3%Z i 3%Z) = 1.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 4%Z < t 5%Z /\
  t 5%Z < t 6%Z /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 3%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 3%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 6%Z - t 3%Z <> 0).
End knots_unity_cubic.

Module knots_unity_equal.
(* splines/knots.unity.equal, Partition of unity
   printed: If knots may be equal, the functions of degree 2 add up to 1 where the divisors do not vanish.
   stated: sum(i, 0, 2, N[i,2](x, 2)) == 1 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0) ->
  t 1%Z - t 3%Z <> 0 ->
  t 2%Z - t 3%Z <> 0 ->
  t 2%Z - t 4%Z <> 0 ->
  sum 0%Z 2%Z (fun i => N_ t x 2%Z i 2%Z) = 1.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0) /\
  t 1%Z - t 3%Z <> 0 /\
  t 2%Z - t 3%Z <> 0 /\
  t 2%Z - t 4%Z <> 0.
End knots_unity_equal.
