(* Statements of trigonometric, Part Circles. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module quadratic_circle.
(* trigonometric/quadratic.circle, Circles
   printed: λ = μ = 0 and the points (1, 0), (1, 1), (0, 1) give an arc of the circle x² + y² = 1.
   stated: at(at(dot([a(t, lambda) + b(t, lambda, mu), b(t, lambda, mu) + c(t, mu)], [a(t, lambda) + b(t, lambda, mu), b(t, lambda, mu) + c(t, mu)]), lambda, 0), mu, 0) == 1 *)
Definition a (t : R) (lambda : R) : R :=
  (1 - sin t) * (1 - lambda * sin t).
Definition c (t : R) (mu : R) : R :=
  (1 - cos t) * (1 - mu * cos t).
Definition b (t : R) (lambda : R) (mu : R) : R :=
  1 - a t lambda - c t mu.
Definition statement : Prop :=
forall (t : R),
  0 <= t <= 1 / 2 * PI ->
  (fun mu : R => (fun lambda : R => dot [a t lambda + b t lambda mu; b t lambda mu + c t mu] [a t lambda + b t lambda mu; b t lambda mu + c t mu]) 0) 0 = 1.
Definition instance : Prop :=
exists (t : R),
  0 <= t <= 1 / 2 * PI.
End quadratic_circle.
