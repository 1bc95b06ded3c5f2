(* Statements of splines, Part At. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition A (P : Z -> R) (s : R) : R :=
  sum 0%Z 2%Z (fun i => U s i 2%Z * P i).
Definition B (P : Z -> R) (s : R) : R :=
  sum 0%Z 2%Z (fun i => U s i 2%Z * P (i + 1)%Z).
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
Definition F (P : Z -> R) (s : R) : R :=
  sum 0%Z 3%Z (fun i => U s i 3%Z * P i).
Definition G (P : Z -> R) (s : R) : R :=
  sum 0%Z 3%Z (fun i => U s i 3%Z * P (i + 1)%Z).
End Definitions.
Import Definitions.

Module uniform_C1.
(* splines/uniform.C1, At a knot
   printed: Quadratic: A(1) = B(0), A'(1) = B'(0)
   stated: A(1) == B(0) and A'(1) == B'(0) *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 4)%Z) ->
  A P 1 = B P 0 /\ Derive_n (fun s => A P s) 1 1 = Derive_n (fun s => B P s) 1 0.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 4)%Z).
End uniform_C1.

Module uniform_C1_slip.
(* splines/uniform.C1.slip, At a knot
   printed: A common slip: A''(1) = B''(0) for degree 2
   stated: A''(1) == B''(0) *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 4)%Z) ->
  Derive_n (fun s => A P s) 2 1 = Derive_n (fun s => B P s) 2 0.
End uniform_C1_slip.

Module uniform_C1_slip_corrected.
(* splines/uniform.C1.slip (corrected), At a knot
   printed: A common slip: A''(1) = B''(0) for degree 2
   stated: A''(1) == A''(0) *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) ->
  Derive_n (fun s => A P s) 2 1 = Derive_n (fun s => A P s) 2 0.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z).
End uniform_C1_slip_corrected.

Module uniform_C2.
(* splines/uniform.C2, At a knot
   printed: Cubic: F(1) = G(0), F'(1) = G'(0), F''(1) = G''(0)
   stated: F(1) == G(0) and F'(1) == G'(0) and F''(1) == G''(0) *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 4)%Z) ->
  F P 1 = G P 0 /\ Derive_n (fun s => F P s) 1 1 = Derive_n (fun s => G P s) 1 0 /\ Derive_n (fun s => F P s) 2 1 = Derive_n (fun s => G P s) 2 0.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 4)%Z).
End uniform_C2.

Module uniform_jump.
(* splines/uniform.jump, At a knot
   printed: G'''(0) - F'''(1) = P_0 - 4P_1 + 6P_2 - 4P_3 + P_4
   stated: G'''(0) - F'''(1) == P[0] - 4*P[1] + 6*P[2] - 4*P[3] + P[4] *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 4)%Z) ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  Derive_n (fun s => G P s) 3 0 - Derive_n (fun s => F P s) 3 1 = P 0%Z - 4 * P 1%Z + 6 * P 2%Z - 4 * P 3%Z + P 4%Z.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 4)%Z) /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_jump.

Module uniform_knot.
(* splines/uniform.knot, At a knot
   printed: F(0) = (P_0 + 4P_1 + P_2)/6, F'(0) = (P_2 - P_0)/2, F''(0) = P_0 - 2P_1 + P_2
   stated: F(0) == (P[0] + 4*P[1] + P[2])/6 and F'(0) == (P[2] - P[0])/2 and F''(0) == P[0] - 2*P[1] + P[2] *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  F P 0 = (P 0%Z + 4 * P 1%Z + P 2%Z) / 6 /\ Derive_n (fun s => F P s) 1 0 = (P 2%Z - P 0%Z) / 2 /\ Derive_n (fun s => F P s) 2 0 = P 0%Z - 2 * P 1%Z + P 2%Z.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_knot.

Module uniform_knot_slip.
(* splines/uniform.knot.slip, At a knot
   printed: A common slip: F(0) = (P_0 + 2P_1 + P_2)/4
   stated: F(0) == (P[0] + 2*P[1] + P[2])/4 *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  F P 0 = (P 0%Z + 2 * P 1%Z + P 2%Z) / 4.
End uniform_knot_slip.

Module uniform_knot_slip_corrected.
(* splines/uniform.knot.slip (corrected), At a knot
   printed: A common slip: F(0) = (P_0 + 2P_1 + P_2)/4
   stated: F(0) == (P[0] + 2*(2*P[1]) + P[2])/6 *)
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  F P 0 = (P 0%Z + 2 * (2 * P 1%Z) + P 2%Z) / 6.
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_knot_slip_corrected.

Module knots_C1.
(* splines/knots.C1, At a knot
   printed: Quadratic: F(t_3) = G(t_3), F'(t_3) = G'(t_3)
   stated: F(t[3]) == G(t[3]) and F'(t[3]) == G'(t[3]) *)
Definition F (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 2%Z 0%Z 2%Z * P 0%Z + N_ t x 2%Z 1%Z 2%Z * P 1%Z + N_ t x 2%Z 2%Z 2%Z * P 2%Z.
Definition G (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 3%Z 0%Z 2%Z * P 1%Z + N_ t x 3%Z 1%Z 2%Z * P 2%Z + N_ t x 3%Z 2%Z 2%Z * P 3%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 0%Z < t 1%Z ->
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 4%Z < t 5%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 4%Z - t 3%Z <> 0 ->
  t 5%Z - t 3%Z <> 0 ->
  F P t (t 3%Z) = G P t (t 3%Z) /\ Derive_n (fun x => F P t x) 1 (t 3%Z) = Derive_n (fun x => G P t x) 1 (t 3%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : Z -> R),
  t 0%Z < t 1%Z /\
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 4%Z < t 5%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  t 4%Z - t 3%Z <> 0 /\
  t 5%Z - t 3%Z <> 0.
End knots_C1.

Module knots_C1_value.
(* splines/knots.C1.value, At a knot
   printed: F'(t_3) = 2(P_2 - P_1)/(t_4 - t_2)
   stated: F'(t[3]) == 2*(P[2] - P[1])/(t[4] - t[2]) *)
Definition F (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 2%Z 0%Z 2%Z * P 0%Z + N_ t x 2%Z 1%Z 2%Z * P 1%Z + N_ t x 2%Z 2%Z 2%Z * P 2%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  Derive_n (fun x => F P t x) 1 (t 3%Z) = 2 * (P 2%Z - P 1%Z) / (t 4%Z - t 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0.
End knots_C1_value.

Module knots_C1_value_slip.
(* splines/knots.C1.value.slip, At a knot
   printed: A common slip: F'(t_3) = 2(P_2 - P_1)/(t_4 - t_3)
   stated: F'(t[3]) == 2*(P[2] - P[1])/(t[4] - t[3]) *)
Definition F (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 2%Z 0%Z 2%Z * P 0%Z + N_ t x 2%Z 1%Z 2%Z * P 1%Z + N_ t x 2%Z 2%Z 2%Z * P 2%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 4%Z - t 3%Z <> 0 ->
  Derive_n (fun x => F P t x) 1 (t 3%Z) = 2 * (P 2%Z - P 1%Z) / (t 4%Z - t 3%Z).
End knots_C1_value_slip.

Module knots_C1_value_slip_corrected.
(* splines/knots.C1.value.slip (corrected), At a knot
   printed: A common slip: F'(t_3) = 2(P_2 - P_1)/(t_4 - t_3)
   stated: F'(t[3]) == 2*(P[2] - P[1])/(t[4] - t[3-1]) *)
Definition F (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 2%Z 0%Z 2%Z * P 0%Z + N_ t x 2%Z 1%Z 2%Z * P 1%Z + N_ t x 2%Z 2%Z 2%Z * P 2%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 4%Z - t (3 - 1)%Z <> 0 ->
  Derive_n (fun x => F P t x) 1 (t 3%Z) = 2 * (P 2%Z - P 1%Z) / (t 4%Z - t (3 - 1)%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  t 4%Z - t (3 - 1)%Z <> 0.
End knots_C1_value_slip_corrected.

Module knots_C2.
(* splines/knots.C2, At a knot
   printed: Cubic: C(t_4) = E(t_4), C'(t_4) = E'(t_4), C''(t_4) = E''(t_4)
   stated: C(t[4]) == E(t[4]) and C'(t[4]) == E'(t[4]) and C''(t[4]) == E''(t[4]) *)
Definition C_ (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 3%Z 0%Z 3%Z * P 0%Z + N_ t x 3%Z 1%Z 3%Z * P 1%Z + N_ t x 3%Z 2%Z 3%Z * P 2%Z + N_ t x 3%Z 3%Z 3%Z * P 3%Z.
Definition E_ (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 4%Z 0%Z 3%Z * P 1%Z + N_ t x 4%Z 1%Z 3%Z * P 2%Z + N_ t x 4%Z 2%Z 3%Z * P 3%Z + N_ t x 4%Z 3%Z 3%Z * P 4%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 4%Z < t 5%Z ->
  t 5%Z < t 6%Z ->
  t 6%Z < t 7%Z ->
  t 4%Z - t 3%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  t 5%Z - t 3%Z <> 0 ->
  t 4%Z - t 1%Z <> 0 ->
  t 5%Z - t 2%Z <> 0 ->
  t 6%Z - t 3%Z <> 0 ->
  t 5%Z - t 4%Z <> 0 ->
  t 6%Z - t 4%Z <> 0 ->
  t 7%Z - t 4%Z <> 0 ->
  C_ P t (t 4%Z) = E_ P t (t 4%Z) /\ Derive_n (fun x => C_ P t x) 1 (t 4%Z) = Derive_n (fun x => E_ P t x) 1 (t 4%Z) /\ Derive_n (fun x => C_ P t x) 2 (t 4%Z) = Derive_n (fun x => E_ P t x) 2 (t 4%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 4%Z < t 5%Z /\
  t 5%Z < t 6%Z /\
  t 6%Z < t 7%Z /\
  t 4%Z - t 3%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  t 5%Z - t 3%Z <> 0 /\
  t 4%Z - t 1%Z <> 0 /\
  t 5%Z - t 2%Z <> 0 /\
  t 6%Z - t 3%Z <> 0 /\
  t 5%Z - t 4%Z <> 0 /\
  t 6%Z - t 4%Z <> 0 /\
  t 7%Z - t 4%Z <> 0.
End knots_C2.

Module knots_convex.
(* splines/knots.convex, At a knot
   printed: F(t_3) = ((t_4 - t_3)P_1 + (t_3 - t_2)P_2)/(t_4 - t_2)
   stated: F(t[3]) == ((t[4] - t[3])*P[1] + (t[3] - t[2])*P[2])/(t[4] - t[2]) *)
Definition F (P : Z -> R) (t : Z -> R) (x : R) : R :=
  N_ t x 2%Z 0%Z 2%Z * P 0%Z + N_ t x 2%Z 1%Z 2%Z * P 1%Z + N_ t x 2%Z 2%Z 2%Z * P 2%Z.
Definition statement : Prop :=
forall (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  F P t (t 3%Z) = ((t 4%Z - t 3%Z) * P 1%Z + (t 3%Z - t 2%Z) * P 2%Z) / (t 4%Z - t 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : Z -> R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0.
End knots_convex.
