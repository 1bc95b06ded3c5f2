(* Statements of trigonometric, Part Known. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module angle_known.
(* trigonometric/angle.known, Known angles
   printed: sin(π/12) = (√6 - √2)/4
   stated: sin(pi/12) == (sqrt(6) - sqrt(2))/4 *)
Definition statement : Prop :=
  sin (PI / 12) = (sqrt 6 - sqrt 2) / 4.
End angle_known.
