(* Statements of trigonometric, Part Cycloid. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (t : R) : list R :=
  [t - sin t; 1 - cos t].
End Definitions.
Import Definitions.

Module cycloid_speed.
(* trigonometric/cycloid.speed, Cycloid
   printed: X'·X' = 4 sin²(t/2)
   stated: dot(X'(t), X'(t)) == 4*sin(t/2)^2 *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  dot (vDerive 2 (fun t => X t) 1 t) (vDerive 2 (fun t => X t) 1 t) = 4 * sin (t / 2) ^ 2.
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI.
End cycloid_speed.

Module cycloid_regular.
(* trigonometric/cycloid.regular, Cycloid
   printed: The cycloid is regular for 0 < t < 2π: X'·X' > 0
   stated: dot(X'(t), X'(t)) > 0 *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  dot (vDerive 2 (fun t => X t) 1 t) (vDerive 2 (fun t => X t) 1 t) > 0.
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI.
End cycloid_regular.

Module cycloid_slope.
(* trigonometric/cycloid.slope, Cycloid
   printed: X'_2/X'_1 = cos(t/2)/sin(t/2)
   stated: X'(t)[2]/X'(t)[1] == cos(t/2)/sin(t/2) *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  entry (vDerive 2 (fun t => X t) 1 t) 1 <> 0 ->
  sin (t / 2) <> 0 ->
  entry (vDerive 2 (fun t => X t) 1 t) 2 / entry (vDerive 2 (fun t => X t) 1 t) 1 = cos (t / 2) / sin (t / 2).
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI /\
  entry (vDerive 2 (fun t => X t) 1 t) 1 <> 0 /\
  sin (t / 2) <> 0.
End cycloid_slope.

Module cycloid_slope_slip.
(* trigonometric/cycloid.slope.slip, Cycloid
   printed: A common slip: X'_2/X'_1 = sin(t/2)/cos(t/2)
   stated: X'(t)[2]/X'(t)[1] == sin(t/2)/cos(t/2) *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  entry (vDerive 2 (fun t => X t) 1 t) 1 <> 0 ->
  cos (t / 2) <> 0 ->
  entry (vDerive 2 (fun t => X t) 1 t) 2 / entry (vDerive 2 (fun t => X t) 1 t) 1 = sin (t / 2) / cos (t / 2).
End cycloid_slope_slip.

Module cycloid_slope_slip_corrected.
(* trigonometric/cycloid.slope.slip (corrected), Cycloid
   printed: A common slip: X'_2/X'_1 = sin(t/2)/cos(t/2)
   stated: X'(t)[2]/X'(t)[1] == cos(t/2)/sin(t/2) *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  entry (vDerive 2 (fun t => X t) 1 t) 1 <> 0 ->
  sin (t / 2) <> 0 ->
  entry (vDerive 2 (fun t => X t) 1 t) 2 / entry (vDerive 2 (fun t => X t) 1 t) 1 = cos (t / 2) / sin (t / 2).
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI /\
  entry (vDerive 2 (fun t => X t) 1 t) 1 <> 0 /\
  sin (t / 2) <> 0.
End cycloid_slope_slip_corrected.

Module cycloid_bend.
(* trigonometric/cycloid.bend, Cycloid
   printed: The cycloid turns to the right for 0 < t < 2π: det(X', X'') < 0
   stated: det([X'(t), X''(t)]) < 0 *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  det [vDerive 2 (fun t => X t) 1 t; vDerive 2 (fun t => X t) 2 t] < 0.
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI.
End cycloid_bend.

Module cycloid_curvature.
(* trigonometric/cycloid.curvature, Cycloid
   printed: The square of the curvature: det(X', X'')^2/(X'·X')^3 = 1/(16 sin²(t/2))
   stated: det([X'(t), X''(t)])^2/dot(X'(t), X'(t))^3 == 1/(16*sin(t/2)^2) *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  dot (vDerive 2 (fun t => X t) 1 t) (vDerive 2 (fun t => X t) 1 t) ^ 3 <> 0 ->
  16 * sin (t / 2) ^ 2 <> 0 ->
  det [vDerive 2 (fun t => X t) 1 t; vDerive 2 (fun t => X t) 2 t] ^ 2 / dot (vDerive 2 (fun t => X t) 1 t) (vDerive 2 (fun t => X t) 1 t) ^ 3 = 1 / (16 * sin (t / 2) ^ 2).
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI /\
  dot (vDerive 2 (fun t => X t) 1 t) (vDerive 2 (fun t => X t) 1 t) ^ 3 <> 0 /\
  16 * sin (t / 2) ^ 2 <> 0.
End cycloid_curvature.
