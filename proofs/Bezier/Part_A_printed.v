(* Statements of bezier, Part A. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module trigonometric_circle.
(* bezier/trigonometric.circle, A circle
   printed: With λ = μ = 0 and the control points (1, 0), (1, 1/2), (1/2, 1), (0, 1) the curve is a quarter of the unit circle.
   stated: Q(x) == [cos(pi/2*x), sin(pi/2*x)] and dot(Q(x), Q(x)) == 1 *)
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
Definition Q (x : R) : list R :=
  vadd (vadd (vadd (vscale (T x 0 0 0%Z 3%Z) [1; 0]) (vscale (T x 0 0 1%Z 3%Z) [1; 1 / 2])) (vscale (T x 0 0 2%Z 3%Z) [1 / 2; 1])) (vscale (T x 0 0 3%Z 3%Z) [0; 1]).
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  Q x = [cos (PI / 2 * x); sin (PI / 2 * x)] /\ dot (Q x) (Q x) = 1.
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End trigonometric_circle.
