(* Statements of hyperbolic, Part Curves. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (t : R) (a : R) : R :=
  ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition g (t : R) (a : R) : R :=
  2 * ((exp (a / 2) + exp (- (a / 2))) / 2) * ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) * ((exp (t / 2) - exp (- (t / 2))) / 2) / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition h (t : R) (a : R) : R :=
  ((exp (t / 2) - exp (- (t / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition F (P : Z -> R) (a : R) (t : R) : R :=
  f t a * P 0%Z + g t a * P 1%Z + h t a * P 2%Z.
Definition s (omega : R) : R :=
  omega * ((exp (omega / 2) + exp (- (omega / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2).
End Definitions.
Import Definitions.

Module curve_ends.
(* hyperbolic/curve.ends, Curves
   printed: F(0) = P_0, F(a) = P_2
   stated: F(0) == P[0] and F(a) == P[2] *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  F P a 0 = P 0%Z /\ F P a a = P 2%Z.
Definition instance : Prop :=
exists (P : Z -> R) (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End curve_ends.

Module curve_d1.
(* hyperbolic/curve.d1, Curves
   printed: F'(0) = coth(a/2)(P_1 - P_0), F'(a) = coth(a/2)(P_2 - P_1)
   stated: F'(0) == cosh(a/2)/sinh(a/2)*(P[1] - P[0]) and F'(a) == cosh(a/2)/sinh(a/2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  (exp (a / 2) - exp (- (a / 2))) / 2 <> 0 ->
  Derive_n (fun t => F P a t) 1 0 = (exp (a / 2) + exp (- (a / 2))) / 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) * (P 1%Z - P 0%Z) /\ Derive_n (fun t => F P a t) 1 a = (exp (a / 2) + exp (- (a / 2))) / 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  (exp (a / 2) - exp (- (a / 2))) / 2 <> 0.
End curve_d1.

Module curve_d1_slip.
(* hyperbolic/curve.d1.slip, Curves
   printed: A common slip: F'(0) = tanh(a/2)(P_1 - P_0)
   stated: F'(0) == sinh(a/2)/cosh(a/2)*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  (exp (a / 2) + exp (- (a / 2))) / 2 <> 0 ->
  Derive_n (fun t => F P a t) 1 0 = (exp (a / 2) - exp (- (a / 2))) / 2 / ((exp (a / 2) + exp (- (a / 2))) / 2) * (P 1%Z - P 0%Z).
End curve_d1_slip.

Module curve_d1_slip_corrected.
(* hyperbolic/curve.d1.slip (corrected), Curves
   printed: A common slip: F'(0) = tanh(a/2)(P_1 - P_0)
   stated: F'(0) == cosh(a/2)/sinh(a/2)*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  (exp (a / 2) - exp (- (a / 2))) / 2 <> 0 ->
  Derive_n (fun t => F P a t) 1 0 = (exp (a / 2) + exp (- (a / 2))) / 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) * (P 1%Z - P 0%Z).
Definition instance : Prop :=
exists (P : Z -> R) (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  (exp (a / 2) - exp (- (a / 2))) / 2 <> 0.
End curve_d1_slip_corrected.

Module curve_d2.
(* hyperbolic/curve.d2, Curves
   printed: F''(0) = (cosh a (P_0 - P_1) + P_2 - P_1)/(2 sinh²(a/2))
   stated: F''(0) == (cosh(a)*(P[0] - P[1]) + P[2] - P[1])/(2*sinh(a/2)^2) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  2 * ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  Derive_n (fun t => F P a t) 2 0 = ((exp a + exp (- a)) / 2 * (P 0%Z - P 1%Z) + P 2%Z - P 1%Z) / (2 * ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2).
Definition instance : Prop :=
exists (P : Z -> R) (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  2 * ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End curve_d2.

Module curve_middle.
(* hyperbolic/curve.middle, Curves
   printed: F(a/2) = (P_0 + 2 cosh(a/2) P_1 + P_2)/(2 + 2 cosh(a/2))
   stated: F(a/2) == (P[0] + 2*cosh(a/2)*P[1] + P[2])/(2 + 2*cosh(a/2)) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  2 + 2 * ((exp (a / 2) + exp (- (a / 2))) / 2) <> 0 ->
  F P a (a / 2) = (P 0%Z + 2 * ((exp (a / 2) + exp (- (a / 2))) / 2) * P 1%Z + P 2%Z) / (2 + 2 * ((exp (a / 2) + exp (- (a / 2))) / 2)).
Definition instance : Prop :=
exists (P : Z -> R) (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  2 + 2 * ((exp (a / 2) + exp (- (a / 2))) / 2) <> 0.
End curve_middle.

Module curve_middle_slip.
(* hyperbolic/curve.middle.slip, Curves
   printed: A common slip: F(a/2) = (P_0 + 2 cosh a P_1 + P_2)/(2 + 2 cosh a)
   stated: F(a/2) == (P[0] + 2*cosh(a)*P[1] + P[2])/(2 + 2*cosh(a)) *)
Definition statement : Prop :=
forall (P : Z -> R) (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  2 + 2 * ((exp a + exp (- a)) / 2) <> 0 ->
  F P a (a / 2) = (P 0%Z + 2 * ((exp a + exp (- a)) / 2) * P 1%Z + P 2%Z) / (2 + 2 * ((exp a + exp (- a)) / 2)).
End curve_middle_slip.

Module shape_ends.
(* hyperbolic/shape.ends, Curves
   printed: F(0) = P_0, F(1) = P_m
   stated: F(0) == P[0] and F(1) == P[m] *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition F (P : Z -> R) (m : Z) (omega : R) (u : R) : R :=
  sum 0%Z m (fun i => h u omega i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (omega : R),
  (2 <= m)%Z ->
  0 < omega ->
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  F P m omega 0 = P 0%Z /\ F P m omega 1 = P m.
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (omega : R),
  (2 <= m)%Z /\
  0 < omega /\
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z.
End shape_ends.

Module shape_d1.
(* hyperbolic/shape.d1, Curves
   printed: F'(0) = (m - 2 + s)(P_1 - P_0), F'(1) = (m - 2 + s)(P_m - P_{m-1}) with s = ω coth(ω/2)
   stated: F'(0) == (m - 2 + s)*(P[1] - P[0]) and F'(1) == (m - 2 + s)*(P[m] - P[m-1]) *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition F (P : Z -> R) (m : Z) (omega : R) (u : R) : R :=
  sum 0%Z m (fun i => h u omega i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (omega : R),
  (2 <= m)%Z ->
  0 < omega ->
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) ->
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 ->
  (0 <= 1 <= m)%Z ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  Derive_n (fun u => F P m omega u) 1 0 = (IZR m - 2 + s omega) * (P 1%Z - P 0%Z) /\ Derive_n (fun u => F P m omega u) 1 1 = (IZR m - 2 + s omega) * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (omega : R),
  (2 <= m)%Z /\
  0 < omega /\
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) /\
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 /\
  (0 <= 1 <= m)%Z /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z.
End shape_d1.

Module shape_d1_slip.
(* hyperbolic/shape.d1.slip, Curves
   printed: A common slip: F'(0) = (m + s)(P_1 - P_0)
   stated: F'(0) == (m + s)*(P[1] - P[0]) *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition F (P : Z -> R) (m : Z) (omega : R) (u : R) : R :=
  sum 0%Z m (fun i => h u omega i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (omega : R),
  (2 <= m)%Z ->
  0 < omega ->
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) ->
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 ->
  (0 <= 1 <= m)%Z ->
  (0 <= 0 <= m)%Z ->
  Derive_n (fun u => F P m omega u) 1 0 = (IZR m + s omega) * (P 1%Z - P 0%Z).
End shape_d1_slip.

Module shape_slope.
(* hyperbolic/shape.slope, Curves
   printed: s > 0
   stated: s > 0 *)
Definition statement : Prop :=
forall (omega : R),
  0 < omega ->
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 ->
  s omega > 0.
Definition instance : Prop :=
exists (omega : R),
  0 < omega /\
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0.
End shape_slope.
