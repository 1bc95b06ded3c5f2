(* Statements of splines, Part Derivatives. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
End Definitions.
Import Definitions.

Module uniform_rate.
(* splines/uniform.rate, Derivatives
   printed: U_{2,3}' = U_{1,2} - U_{2,2}
   stated: D(U[2,3](s), s) == U[1,2](s) - U[2,2](s) *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  Derive_n (fun s => U s 2%Z 3%Z) 1 s = U s 1%Z 2%Z - U s 2%Z 2%Z.
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_rate.

Module knots_rate.
(* splines/knots.rate, Derivatives
   printed: N_{1,2}' = 2(N_{0,1}/(t_3 - t_1) - N_{1,1}/(t_4 - t_2)) on the span of t_2 and t_3
   stated: D(N[1,2](x, 2), x) == 2*(N[0,1](x, 2)/(t[3] - t[1]) - N[1,1](x, 2)/(t[4] - t[2])) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  Derive_n (fun x => N_ t x 2%Z 1%Z 2%Z) 1 x = 2 * (N_ t x 2%Z 0%Z 1%Z / (t 3%Z - t 1%Z) - N_ t x 2%Z 1%Z 1%Z / (t 4%Z - t 2%Z)).
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0.
End knots_rate.

Module knots_rate_slip.
(* splines/knots.rate.slip, Derivatives
   printed: A common slip: N_{1,2}' = 2(N_{0,1}/(t_3 - t_2) - N_{1,1}/(t_4 - t_2))
   stated: D(N[1,2](x, 2), x) == 2*(N[0,1](x, 2)/(t[3] - t[2]) - N[1,1](x, 2)/(t[4] - t[2])) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  Derive_n (fun x => N_ t x 2%Z 1%Z 2%Z) 1 x = 2 * (N_ t x 2%Z 0%Z 1%Z / (t 3%Z - t 2%Z) - N_ t x 2%Z 1%Z 1%Z / (t 4%Z - t 2%Z)).
End knots_rate_slip.

Module knots_rate_slip_corrected.
(* splines/knots.rate.slip (corrected), Derivatives
   printed: A common slip: N_{1,2}' = 2(N_{0,1}/(t_3 - t_2) - N_{1,1}/(t_4 - t_2))
   stated: D(N[1,2](x, 2), x) == 2*(N[0,1](x, 2)/(t[3] - t[2-1]) - N[1,1](x, 2)/(t[4] - t[2])) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 3%Z - t (2 - 1)%Z <> 0 ->
  Derive_n (fun x => N_ t x 2%Z 1%Z 2%Z) 1 x = 2 * (N_ t x 2%Z 0%Z 1%Z / (t 3%Z - t (2 - 1)%Z) - N_ t x 2%Z 1%Z 1%Z / (t 4%Z - t 2%Z)).
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  t 3%Z - t (2 - 1)%Z <> 0.
End knots_rate_slip_corrected.
