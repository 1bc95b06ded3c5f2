(* Statements of bezier, Part The. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition kappa : R :=
  4 / 3 * (sqrt 2 - 1).
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition arc (x : R) : list R :=
  vadd (vadd (vadd (vscale (B x 0%Z 3%Z) [1; 0]) (vscale (B x 1%Z 3%Z) [1; kappa])) (vscale (B x 2%Z 3%Z) [kappa; 1])) (vscale (B x 3%Z 3%Z) [0; 1]).
End Definitions.
Import Definitions.

Module circle_kappa.
(* bezier/circle.kappa, The handle
   printed: κ = 4/3 (√2 - 1) = 0.5523
   stated: agrees(kappa, 0.5523) *)
Definition statement : Prop :=
  agrees_up kappa (5523 / 10000) 4.
End circle_kappa.

Module circle_kappa_cut.
(* bezier/circle.kappa.cut, The handle
   printed: κ = 4/3 (√2 - 1) = 0.5522
   stated: agrees(kappa, 0.5522) *)
Definition statement : Prop :=
  agrees_up kappa (2761 / 5000) 4.
End circle_kappa_cut.

Module circle_kappa_slip.
(* bezier/circle.kappa.slip, The handle
   printed: A common slip: κ = 0.5532
   stated: agrees(kappa, 0.5532) *)
Definition statement : Prop :=
  agrees_up kappa (1383 / 2500) 4.
End circle_kappa_slip.

Module circle_middle.
(* bezier/circle.middle, The middle
   printed: The cubic meets the circle at its middle, with the tangent of the circle.
   stated: dot(arc(1/2), arc(1/2)) == 1 and dot(arc(1/2), arc'(1/2)) == 0 *)
Definition statement : Prop :=
  dot (arc (1 / 2)) (arc (1 / 2)) = 1 /\ dot (arc (1 / 2)) (vDerive 2 (fun x => arc x) 1 (1 / 2)) = 0.
End circle_middle.

Module circle_outside.
(* bezier/circle.outside, The error
   printed: The cubic never runs inside the circle.
   stated: dot(arc(x), arc(x)) - 1 == 2*(17 - 12*sqrt(2))*x^2*(1 - x)^2*(1 - 2*x)^2 and 17 - 12*sqrt(2) > 0 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  dot (arc x) (arc x) - 1 = 2 * (17 - 12 * sqrt 2) * x ^ 2 * (1 - x) ^ 2 * (1 - 2 * x) ^ 2 /\ 17 - 12 * sqrt 2 > 0.
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End circle_outside.

Module circle_exact_slip.
(* bezier/circle.exact.slip, The error
   printed: A common slip: the cubic is a quarter of the circle.
   stated: dot(arc(x), arc(x)) == 1 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  dot (arc x) (arc x) = 1.
End circle_exact_slip.

Module reach_definite.
(* bezier/reach.definite, The whole line
   printed: y² + y z + z² >= 0 and y^4 + 1 > 0
   stated: y^2 + y*z + z^2 >= 0 and y^4 + 1 > 0 *)
Definition statement : Prop :=
forall (y : R) (z : R),
  y ^ 2 + y * z + z ^ 2 >= 0 /\ y ^ 4 + 1 > 0.
End reach_definite.

Module reach_cauchy.
(* bezier/reach.cauchy, The whole line
   printed: (p·q)² <= (p·p)(q·q)
   stated: dot(p, q)^2 <= dot(p, p)*dot(q, q) *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  dot p q ^ 2 <= dot p p * dot q q.
End reach_cauchy.
