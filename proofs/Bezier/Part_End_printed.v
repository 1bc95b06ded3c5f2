(* Statements of bezier, Part End. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
Definition F (P : Z -> R) (lambda : R) (mu : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => T x lambda mu i 3%Z * P i).
End Definitions.
Import Definitions.

Module curve_ends.
(* bezier/curve.ends, End points
   printed: The curve begins at its first and ends at its last control point.
   stated: C(0) == P[0] and C(1) == P[m] *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  C_ P m 0 = P 0%Z /\ C_ P m 1 = P m.
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z.
End curve_ends.

Module curve_d1.
(* bezier/curve.d1, End derivatives
   printed: C'(0) = m (P_1 - P_0),  C'(1) = m (P_m - P_{m-1})
   stated: C'(0) == m*(P[1] - P[0]) and C'(1) == m*(P[m] - P[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 1 <= m)%Z ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  Derive_n (fun x => C_ P m x) 1 0 = IZR m * (P 1%Z - P 0%Z) /\ Derive_n (fun x => C_ P m x) 1 1 = IZR m * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (0 <= 1 <= m)%Z /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z.
End curve_d1.

Module curve_d2.
(* bezier/curve.d2, End derivatives
   printed: C''(0) = m(m-1) (P_0 - 2P_1 + P_2),  C''(1) = m(m-1) (P_m - 2P_{m-1} + P_{m-2})
   stated: C''(0) == m*(m - 1)*(P[0] - 2*P[1] + P[2]) and C''(1) == m*(m - 1)*(P[m] - 2*P[m-1] + P[m-2]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  Derive_n (fun x => C_ P m x) 2 0 = IZR m * (IZR m - 1) * (P 0%Z - 2 * P 1%Z + P 2%Z) /\ Derive_n (fun x => C_ P m x) 2 1 = IZR m * (IZR m - 1) * (P m - 2 * P (m - 1)%Z + P (m - 2)%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 2 <= m)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z.
End curve_d2.

Module curve_d2_slip.
(* bezier/curve.d2.slip, End derivatives
   printed: A common slip: C''(0) = m² (P_0 - 2P_1 + P_2)
   stated: C''(0) == m^2*(P[0] - 2*P[1] + P[2]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  Derive_n (fun x => C_ P m x) 2 0 = IZR m ^ 2 * (P 0%Z - 2 * P 1%Z + P 2%Z).
End curve_d2_slip.

Module curve_d2_slip_corrected.
(* bezier/curve.d2.slip (corrected), End derivatives
   printed: A common slip: C''(0) = m² (P_0 - 2P_1 + P_2)
   stated: C''(0) == m*(m - 1)*(P[0] - 2*P[1] + P[2]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  Derive_n (fun x => C_ P m x) 2 0 = IZR m * (IZR m - 1) * (P 0%Z - 2 * P 1%Z + P 2%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 2 <= m)%Z.
End curve_d2_slip_corrected.

Module curve_d3.
(* bezier/curve.d3, End derivatives
   printed: C'''(0) = m(m-1)(m-2) (P_3 - 3P_2 + 3P_1 - P_0),  C'''(1) = m(m-1)(m-2) (P_m - 3P_{m-1} + 3P_{m-2} - P_{m-3})
   stated: C'''(0) == m*(m - 1)*(m - 2)*(P[3] - 3*P[2] + 3*P[1] - P[0]) and C'''(1) == m*(m - 1)*(m - 2)*(P[m] - 3*P[m-1] + 3*P[m-2] - P[m-3]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (0 <= 3 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  Derive_n (fun x => C_ P m x) 3 0 = IZR m * (IZR m - 1) * (IZR m - 2) * (P 3%Z - 3 * P 2%Z + 3 * P 1%Z - P 0%Z) /\ Derive_n (fun x => C_ P m x) 3 1 = IZR m * (IZR m - 1) * (IZR m - 2) * (P m - 3 * P (m - 1)%Z + 3 * P (m - 2)%Z - P (m - 3)%Z).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (0 <= 3 <= m)%Z /\
  (0 <= 2 <= m)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z.
End curve_d3.

Module trigonometric_d1.
(* bezier/trigonometric.d1, End derivatives
   printed: F'(0) = π/2 (2 + λ) (P_1 - P_0),  F'(1) = π/2 (2 + μ) (P_3 - P_2)
   stated: F'(0) == pi/2*(2 + lambda)*(P[1] - P[0]) and F'(1) == pi/2*(2 + mu)*(P[3] - P[2]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  Derive_n (fun x => F P lambda mu x) 1 0 = PI / 2 * (2 + lambda) * (P 1%Z - P 0%Z) /\ Derive_n (fun x => F P lambda mu x) 1 1 = PI / 2 * (2 + mu) * (P 3%Z - P 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1.
End trigonometric_d1.

Module trigonometric_d1_slip.
(* bezier/trigonometric.d1.slip, End derivatives
   printed: A common slip, the factor of t = π/2 x forgotten: F'(0) = (2 + λ) (P_1 - P_0)
   stated: F'(0) == (2 + lambda)*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  Derive_n (fun x => F P lambda mu x) 1 0 = (2 + lambda) * (P 1%Z - P 0%Z).
End trigonometric_d1_slip.

Module trigonometric_d1_slip_corrected.
(* bezier/trigonometric.d1.slip (corrected), End derivatives
   printed: A common slip, the factor of t = π/2 x forgotten: F'(0) = (2 + λ) (P_1 - P_0)
   stated: F'(0) == pi*(1/2*((2 + lambda)*(P[1] - P[0]))) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  Derive_n (fun x => F P lambda mu x) 1 0 = PI * (1 / 2 * ((2 + lambda) * (P 1%Z - P 0%Z))).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1.
End trigonometric_d1_slip_corrected.

Module trigonometric_d2.
(* bezier/trigonometric.d2, End derivatives
   printed: F''(0) = π²/2 ((1 + 2λ) P_0 - 2(1 + λ) P_1 + P_2)
   stated: F''(0) == pi^2/2*((1 + 2*lambda)*P[0] - 2*(1 + lambda)*P[1] + P[2]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  Derive_n (fun x => F P lambda mu x) 2 0 = PI ^ 2 / 2 * ((1 + 2 * lambda) * P 0%Z - 2 * (1 + lambda) * P 1%Z + P 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1.
End trigonometric_d2.
