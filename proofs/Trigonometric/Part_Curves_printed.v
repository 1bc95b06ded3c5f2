(* Statements of trigonometric, Part Curves. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition a (t : R) (lambda : R) : R :=
  (1 - sin t) * (1 - lambda * sin t).
Definition c (t : R) (mu : R) : R :=
  (1 - cos t) * (1 - mu * cos t).
Definition b (t : R) (lambda : R) (mu : R) : R :=
  1 - a t lambda - c t mu.
Definition F (P : Z -> R) (lambda : R) (mu : R) (t : R) : R :=
  a t lambda * P 0%Z + b t lambda mu * P 1%Z + c t mu * P 2%Z.
End Definitions.
Import Definitions.

Module quadratic_ends.
(* trigonometric/quadratic.ends, Curves
   printed: F(0) = P_0, F(π/2) = P_2
   stated: F(0) == P[0] and F(pi/2) == P[2] *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  F P lambda mu 0 = P 0%Z /\ F P lambda mu (PI / 2) = P 2%Z.
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1.
End quadratic_ends.

Module quadratic_d1.
(* trigonometric/quadratic.d1, Curves
   printed: F'(0) = (1 + λ)(P_1 - P_0), F'(π/2) = (1 + μ)(P_2 - P_1)
   stated: F'(0) == (1 + lambda)*(P[1] - P[0]) and F'(pi/2) == (1 + mu)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  Derive_n (fun t => F P lambda mu t) 1 0 = (1 + lambda) * (P 1%Z - P 0%Z) /\ Derive_n (fun t => F P lambda mu t) 1 (PI / 2) = (1 + mu) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1.
End quadratic_d1.

Module quadratic_d2.
(* trigonometric/quadratic.d2, Curves
   printed: F''(0) = 2λ(P_0 - P_1) + (1 - μ)(P_2 - P_1)
   stated: F''(0) == 2*lambda*(P[0] - P[1]) + (1 - mu)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  Derive_n (fun t => F P lambda mu t) 2 0 = 2 * lambda * (P 0%Z - P 1%Z) + (1 - mu) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1.
End quadratic_d2.

Module quadratic_d1_slip.
(* trigonometric/quadratic.d1.slip, Curves
   printed: A common slip, the factor of t = π/2 x is kept: F'(0) = π/2 (1 + λ)(P_1 - P_0)
   stated: F'(0) == pi/2*(1 + lambda)*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  Derive_n (fun t => F P lambda mu t) 1 0 = PI / 2 * (1 + lambda) * (P 1%Z - P 0%Z).
End quadratic_d1_slip.

Module quadratic_d1_slip_corrected.
(* trigonometric/quadratic.d1.slip (corrected), Curves
   printed: A common slip, the factor of t = π/2 x is kept: F'(0) = π/2 (1 + λ)(P_1 - P_0)
   stated: F'(0) == (1 + lambda)*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 ->
  (-1) <= mu <= 1 ->
  Derive_n (fun t => F P lambda mu t) 1 0 = (1 + lambda) * (P 1%Z - P 0%Z).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R),
  (-1) <= lambda <= 1 /\
  (-1) <= mu <= 1.
End quadratic_d1_slip_corrected.
