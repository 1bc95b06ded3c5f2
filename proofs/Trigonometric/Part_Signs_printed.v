(* Statements of trigonometric, Part Signs. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module angle_first.
(* trigonometric/angle.first, Signs
   printed: sin t + cos t >= 1 for t in [0, π/2]
   stated: sin(t) + cos(t) >= 1 *)
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 / 2 * PI ->
  sin t + cos t >= 1.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 / 2 * PI.
End angle_first.

Module angle_first_turned.
(* trigonometric/angle.first.turned, Signs
   printed: sin(π/2 x) + cos(π/2 x) >= 1 for x in [0, 1]
   stated: sin(pi/2*x) + cos(pi/2*x) >= 1 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  sin (PI / 2 * x) + cos (PI / 2 * x) >= 1.
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End angle_first_turned.

Module angle_symmetric.
(* trigonometric/angle.symmetric, Signs
   printed: cos u >= 1/2 for u in [-π/3, π/3]
   stated: cos(u) >= 1/2 *)
Definition statement : Prop :=
forall (u : R),
  (-1) / 3 * PI <= u <= 1 / 3 * PI ->
  cos u >= 1 / 2.
Definition instance : Prop :=
exists (u : R),
  (-1) / 3 * PI <= u <= 1 / 3 * PI.
End angle_symmetric.

Module angle_symmetric_slip.
(* trigonometric/angle.symmetric.slip, Signs
   printed: A common slip: cos u >= 1/2 for u in [-π/2, π/2]
   stated: cos(u) >= 1/2 *)
Definition statement : Prop :=
forall (u : R),
  (-1) / 2 * PI <= u <= 1 / 2 * PI ->
  cos u >= 1 / 2.
End angle_symmetric_slip.

Module angle_turn.
(* trigonometric/angle.turn, Signs
   printed: 3 + sin y + 2 cos y > 0
   stated: 3 + sin(y) + 2*cos(y) > 0 *)
Definition statement : Prop :=
forall (y : R),
  3 + sin y + 2 * cos y > 0.
End angle_turn.
