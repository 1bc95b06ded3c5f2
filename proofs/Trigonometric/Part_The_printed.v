(* Statements of trigonometric, Part The. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition a (t : R) (lambda : R) : R :=
  (1 - sin t) * (1 - lambda * sin t).
Definition c (t : R) (mu : R) : R :=
  (1 - cos t) * (1 - mu * cos t).
Definition b (t : R) (lambda : R) (mu : R) : R :=
  1 - a t lambda - c t mu.
End Definitions.
Import Definitions.

Module quadratic_middle.
(* trigonometric/quadratic.middle, The functions
   printed: b = (1 + λ) sin t + (1 + μ) cos t - λ sin² t - μ cos² t - 1
   stated: b(t, lambda, mu) == (1 + lambda)*sin(t) + (1 + mu)*cos(t) - lambda*sin(t)^2 - mu*cos(t)^2 - 1 *)
Definition statement : Prop :=
forall (lambda : R) (mu : R) (t : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  0 <= t <= 1 / 2 * PI ->
  b t lambda mu = (1 + lambda) * sin t + (1 + mu) * cos t - lambda * sin t ^ 2 - mu * cos t ^ 2 - 1.
Definition instance : Prop :=
exists (lambda : R) (mu : R) (t : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1 /\
  0 <= t <= 1 / 2 * PI.
End quadratic_middle.

Module quadratic_nonnegative.
(* trigonometric/quadratic.nonnegative, The functions
   printed: a, b, c >= 0 on [0, π/2] for λ, μ in [-1, 1]
   stated: a(t, lambda) >= 0 and b(t, lambda, mu) >= 0 and c(t, mu) >= 0 *)
Definition statement : Prop :=
forall (lambda : R) (mu : R) (t : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  0 <= t <= 1 / 2 * PI ->
  a t lambda >= 0 /\ b t lambda mu >= 0 /\ c t mu >= 0.
Definition instance : Prop :=
exists (lambda : R) (mu : R) (t : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1 /\
  0 <= t <= 1 / 2 * PI.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
(* trigonometric/quadratic.nonnegative.slip, The functions
   printed: A common slip: a >= 0 on [0, π/2] for λ in [-1, 2]
   stated: a(t, lambda) >= 0 *)
Definition statement : Prop :=
forall (lambda : R) (t : R),
  (-1) <= lambda <= 2 ->
  0 <= t <= 1 / 2 * PI ->
  a t lambda >= 0.
End quadratic_nonnegative_slip.

Module quadratic_symmetry.
(* trigonometric/quadratic.symmetry, The functions
   printed: c(π/2 - t, λ) = a(t, λ)
   stated: c(pi/2 - t, lambda) == a(t, lambda) *)
Definition statement : Prop :=
forall (lambda : R) (t : R),
  (-1) <= lambda <= 1 ->
  0 <= t <= 1 / 2 * PI ->
  c (PI / 2 - t) lambda = a t lambda.
Definition instance : Prop :=
exists (lambda : R) (t : R),
  (-1) <= lambda <= 1 /\
  0 <= t <= 1 / 2 * PI.
End quadratic_symmetry.

Module quadratic_decreasing.
(* trigonometric/quadratic.decreasing, The functions
   printed: a decreases on [0, π/2]: a' <= 0
   stated: a'(t, lambda) <= 0 *)
Definition statement : Prop :=
forall (lambda : R) (t : R),
  (-1) <= lambda <= 1 ->
  0 <= t <= 1 / 2 * PI ->
  Derive_n (fun t => a t lambda) 1 t <= 0.
Definition instance : Prop :=
exists (lambda : R) (t : R),
  (-1) <= lambda <= 1 /\
  0 <= t <= 1 / 2 * PI.
End quadratic_decreasing.
