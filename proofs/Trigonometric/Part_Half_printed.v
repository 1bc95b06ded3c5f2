(* Statements of trigonometric, Part Half. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition E_ (P : Z -> R) (t : R) : R :=
  cos (t / 2) ^ 4 * P 0%Z + 2 * sin (t / 2) ^ 2 * cos (t / 2) ^ 2 * P 1%Z + sin (t / 2) ^ 4 * P 2%Z.
End Definitions.
Import Definitions.

Module angle_half_sine.
(* trigonometric/angle.half.sine, Half angles
   printed: sin²(y/2) = (1 - cos y)/2
   stated: sin(y/2)^2 == (1 - cos(y))/2 *)
Definition statement : Prop :=
forall (y : R),
  sin (y / 2) ^ 2 = (1 - cos y) / 2.
End angle_half_sine.

Module angle_half_cosine.
(* trigonometric/angle.half.cosine, Half angles
   printed: cos y = 2 cos²(y/2) - 1
   stated: cos(y) == 2*cos(y/2)^2 - 1 *)
Definition statement : Prop :=
forall (y : R),
  cos y = 2 * cos (y / 2) ^ 2 - 1.
End angle_half_cosine.

Module angle_half_slip.
(* trigonometric/angle.half.slip, Half angles
   printed: A common slip: 1 - cos y = sin²(y/2)
   stated: 1 - cos(y) == sin(y/2)^2 *)
Definition statement : Prop :=
forall (y : R),
  1 - cos y = sin (y / 2) ^ 2.
End angle_half_slip.

Module angle_half_slip_corrected.
(* trigonometric/angle.half.slip (corrected), Half angles
   printed: A common slip: 1 - cos y = sin²(y/2)
   stated: 1 - cos(y) == 2*sin(y/2)^2 *)
Definition statement : Prop :=
forall (y : R),
  1 - cos y = 2 * sin (y / 2) ^ 2.
End angle_half_slip_corrected.

Module half_unity.
(* trigonometric/half.unity, Half angles, the functions
   printed: cos^4(t/2) + 2 sin²(t/2) cos²(t/2) + sin^4(t/2) = 1
   stated: cos(t/2)^4 + 2*sin(t/2)^2*cos(t/2)^2 + sin(t/2)^4 == 1 *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 * PI ->
  cos (t / 2) ^ 4 + 2 * sin (t / 2) ^ 2 * cos (t / 2) ^ 2 + sin (t / 2) ^ 4 = 1.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 * PI.
End half_unity.

Module half_middle.
(* trigonometric/half.middle, Half angles, the functions
   printed: 2 sin²(t/2) cos²(t/2) = sin² t/2
   stated: 2*sin(t/2)^2*cos(t/2)^2 == sin(t)^2/2 *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 * PI ->
  2 * sin (t / 2) ^ 2 * cos (t / 2) ^ 2 = sin t ^ 2 / 2.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 * PI.
End half_middle.

Module half_sine.
(* trigonometric/half.sine, Half angles, the functions
   printed: 2 sin(t/2) >= sin t on [0, π]
   stated: 2*sin(t/2) >= sin(t) *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 * PI ->
  2 * sin (t / 2) >= sin t.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 * PI.
End half_sine.

Module half_cosine.
(* trigonometric/half.cosine, Half angles, the functions
   printed: cos(t/2) >= 0 on [0, π]
   stated: cos(t/2) >= 0 *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 * PI ->
  cos (t / 2) >= 0.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 * PI.
End half_cosine.

Module half_cosine_slip.
(* trigonometric/half.cosine.slip, Half angles, the functions
   printed: A common slip: cos(t/2) > 0 on [0, π]
   stated: cos(t/2) > 0 *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 * PI ->
  cos (t / 2) > 0.
End half_cosine_slip.

Module half_powers.
(* trigonometric/half.powers, Half angles, curves
   printed: E(t) = (P_0 + 2P_1 + P_2)/4 + cos t/2 (P_0 - P_2) + cos² t/4 (P_0 - 2P_1 + P_2)
   stated: E(t) == (P[0] + 2*P[1] + P[2])/4 + cos(t)/2*(P[0] - P[2]) + cos(t)^2/4*(P[0] - 2*P[1] + P[2]) *)
Definition statement : Prop :=
forall (P : Z -> R) (t : R),
  0 <= t <= 1 * PI ->
  E_ P t = (P 0%Z + 2 * P 1%Z + P 2%Z) / 4 + cos t / 2 * (P 0%Z - P 2%Z) + cos t ^ 2 / 4 * (P 0%Z - 2 * P 1%Z + P 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (t : R),
  0 <= t <= 1 * PI.
End half_powers.

Module half_d1.
(* trigonometric/half.d1, Half angles, curves
   printed: E'(t) = sin t (cos²(t/2) (P_1 - P_0) + sin²(t/2) (P_2 - P_1))
   stated: E'(t) == sin(t)*(cos(t/2)^2*(P[1] - P[0]) + sin(t/2)^2*(P[2] - P[1])) *)
Definition statement : Prop :=
forall (P : Z -> R) (t : R),
  0 <= t <= 1 * PI ->
  Derive_n (fun t => E_ P t) 1 t = sin t * (cos (t / 2) ^ 2 * (P 1%Z - P 0%Z) + sin (t / 2) ^ 2 * (P 2%Z - P 1%Z)).
Definition instance : Prop :=
exists (P : Z -> R) (t : R),
  0 <= t <= 1 * PI.
End half_d1.

Module half_d1_slip.
(* trigonometric/half.d1.slip, Half angles, curves
   printed: A common slip: E'(t) = 2 sin t (cos²(t/2) (P_1 - P_0) + sin²(t/2) (P_2 - P_1))
   stated: E'(t) == 2*sin(t)*(cos(t/2)^2*(P[1] - P[0]) + sin(t/2)^2*(P[2] - P[1])) *)
Definition statement : Prop :=
forall (P : Z -> R) (t : R),
  0 <= t <= 1 * PI ->
  Derive_n (fun t => E_ P t) 1 t = 2 * sin t * (cos (t / 2) ^ 2 * (P 1%Z - P 0%Z) + sin (t / 2) ^ 2 * (P 2%Z - P 1%Z)).
End half_d1_slip.

Module half_d1_slip_corrected.
(* trigonometric/half.d1.slip (corrected), Half angles, curves
   printed: A common slip: E'(t) = 2 sin t (cos²(t/2) (P_1 - P_0) + sin²(t/2) (P_2 - P_1))
   stated: E'(t) == sin(t)*(cos(t/2)^2*(P[1] - P[0]) + sin(t/2)^2*(P[2] - P[1])) *)
Definition statement : Prop :=
forall (P : Z -> R) (t : R),
  0 <= t <= 1 * PI ->
  Derive_n (fun t => E_ P t) 1 t = sin t * (cos (t / 2) ^ 2 * (P 1%Z - P 0%Z) + sin (t / 2) ^ 2 * (P 2%Z - P 1%Z)).
Definition instance : Prop :=
exists (P : Z -> R) (t : R),
  0 <= t <= 1 * PI.
End half_d1_slip_corrected.
