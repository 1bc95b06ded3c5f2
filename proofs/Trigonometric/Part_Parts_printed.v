(* Statements of trigonometric, Part Parts. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module angle_third.
(* trigonometric/angle.third, Parts
   printed: sin y = 3 sin(y/3) - 4 sin³(y/3)
   stated: sin(y) == 3*sin(y/3) - 4*sin(y/3)^3 *)
Definition statement : Prop :=
forall (y : R),
  sin y = 3 * sin (y / 3) - 4 * sin (y / 3) ^ 3.
End angle_third.

Module angle_parts.
(* trigonometric/angle.parts, Parts
   printed: 2 sin(y/2 + z/3) cos(y/2 - z/3) = sin y + sin(2z/3)
   stated: 2*sin(y/2 + z/3)*cos(y/2 - z/3) == sin(y) + sin(2*z/3) *)
Definition statement : Prop :=
forall (y : R) (z : R),
  2 * sin (y / 2 + z / 3) * cos (y / 2 - z / 3) = sin y + sin (2 * z / 3).
End angle_parts.

Module angle_rate.
(* trigonometric/angle.rate, Parts
   printed: the second derivative of sin(y/2) is -sin(y/2)/4
   stated: D(sin(y/2), y, 2) == -sin(y/2)/4 *)
Definition statement : Prop :=
forall (y : R),
  Derive_n (fun y => sin (y / 2)) 2 y = - sin (y / 2) / 4.
End angle_rate.
