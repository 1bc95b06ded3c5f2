(* Statements of splines, Part Signs. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
End Definitions.
Import Definitions.

Module uniform_nonnegative.
(* splines/uniform.nonnegative, Signs
   printed: U_{i,3}(s) >= 0 for 0 <= i <= 3 and 0 <= s <= 1
   stated: U[i,3](s) >= 0 *)
Definition statement : Prop :=
forall (i : Z) (s : R),
  (0 <= i <= 3)%Z ->
  0 <= s <= 1 ->
  U s i 3%Z >= 0.
Definition instance : Prop :=
exists (i : Z) (s : R),
  (0 <= i <= 3)%Z /\
  0 <= s <= 1.
End uniform_nonnegative.

Module uniform_bound.
(* splines/uniform.bound, Signs
   printed: U_{i,3}(s) <= 2/3 for 0 <= i <= 3 and 0 <= s <= 1
   stated: U[i,3](s) <= 2/3 *)
Definition statement : Prop :=
forall (i : Z) (s : R),
  (0 <= i <= 3)%Z ->
  0 <= s <= 1 ->
  U s i 3%Z <= 2 / 3.
Definition instance : Prop :=
exists (i : Z) (s : R),
  (0 <= i <= 3)%Z /\
  0 <= s <= 1.
End uniform_bound.

Module uniform_bound_slip.
(* splines/uniform.bound.slip, Signs
   printed: A common slip: U_{i,3}(s) <= 1/2
   stated: U[i,3](s) <= 1/2 *)
Definition statement : Prop :=
forall (i : Z) (s : R),
  (0 <= i <= 3)%Z ->
  0 <= s <= 1 ->
  U s i 3%Z <= 1 / 2.
End uniform_bound_slip.

Module knots_nonnegative_ends.
(* splines/knots.nonnegative.ends, Signs
   printed: N_{0,2}, N_{2,2} >= 0 on the span of t_2 and t_3
   stated: N[0,2](x, 2) >= 0 and N[2,2](x, 2) >= 0 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 2%Z <= x ->
  x <= t 3%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  N_ t x 2%Z 0%Z 2%Z >= 0 /\ N_ t x 2%Z 2%Z 2%Z >= 0.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 2%Z <= x /\
  x <= t 3%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0.
End knots_nonnegative_ends.

Module knots_nonnegative_middle.
(* splines/knots.nonnegative.middle, Signs
   printed: N_{1,2} > 0 inside the span of t_2 and t_3, by the gaps p, q, r, v > 0 between t_1, t_2, x, t_3, t_4
   stated: N[1,2](x, 2) > 0 *)
Definition statement : Prop :=
forall (p : R) (q : R) (r : R) (t : Z -> R) (v : R) (x : R),
  0 < p ->
  0 < q ->
  0 < r ->
  0 < v ->
  t 2%Z = t 1%Z + p ->
  x = t 2%Z + q ->
  t 3%Z = x + r ->
  t 4%Z = t 3%Z + v ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  N_ t x 2%Z 1%Z 2%Z > 0.
Definition instance : Prop :=
exists (p : R) (q : R) (r : R) (t : Z -> R) (v : R) (x : R),
  0 < p /\
  0 < q /\
  0 < r /\
  0 < v /\
  t 2%Z = t 1%Z + p /\
  x = t 2%Z + q /\
  t 3%Z = x + r /\
  t 4%Z = t 3%Z + v /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0.
End knots_nonnegative_middle.

Module knots_nonnegative_outside.
(* splines/knots.nonnegative.outside, Signs
   printed: A common slip: N_{1,2} >= 0 for all x between t_1 and t_4
   stated: N[1,2](x, 2) >= 0 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 1%Z <= x ->
  x <= t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  N_ t x 2%Z 1%Z 2%Z >= 0.
End knots_nonnegative_outside.

Module knots_nonnegative_cubic.
(* splines/knots.nonnegative.cubic, Signs
   printed: N_{0,3}, N_{3,3} >= 0 on the span of t_3 and t_4
   stated: N[0,3](x, 3) >= 0 and N[3,3](x, 3) >= 0 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 4%Z < t 5%Z ->
  t 5%Z < t 6%Z ->
  t 3%Z <= x ->
  x <= t 4%Z ->
  t 4%Z - t 3%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 5%Z - t 3%Z <> 0 ->
  t 4%Z - t 1%Z <> 0 ->
  t 5%Z - t 2%Z <> 0 ->
  t 6%Z - t 3%Z <> 0 ->
  N_ t x 3%Z 0%Z 3%Z >= 0 /\ N_ t x 3%Z 3%Z 3%Z >= 0.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 4%Z < t 5%Z /\
  t 5%Z < t 6%Z /\
  t 3%Z <= x /\
  x <= t 4%Z /\
  t 4%Z - t 3%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  t 5%Z - t 3%Z <> 0 /\
  t 4%Z - t 1%Z <> 0 /\
  t 5%Z - t 2%Z <> 0 /\
  t 6%Z - t 3%Z <> 0.
End knots_nonnegative_cubic.
