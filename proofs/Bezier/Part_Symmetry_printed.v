(* Statements of bezier, Part Symmetry. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
End Definitions.
Import Definitions.

Module bernstein_symmetry.
(* bezier/bernstein.symmetry, Symmetry
   printed: B_{m-i,m}(x) = B_{i,m}(1 - x)
   stated: B[m-i,m](x) == B[i,m](1 - x) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z ->
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z ->
  B x (m - i)%Z m = B (1 - x) i m.
Definition instance : Prop :=
exists (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z /\
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (0 <= m)%Z.
End bernstein_symmetry.

Module trigonometric_symmetry.
(* bezier/trigonometric.symmetry, Symmetry
   printed: T_{3-i}(x; λ, μ) = T_i(1 - x; μ, λ)
   stated: sum(i, 0, 3, T[3-i,3](x, lambda, mu)*P[i]) == sum(i, 0, 3, T[i,3](1 - x, mu, lambda)*P[i]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z 3%Z (fun i => T x lambda mu (3 - i)%Z 3%Z * P i) = sum 0%Z 3%Z (fun i => T (1 - x) mu lambda i 3%Z * P i).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1 /\
  0 <= x <= 1.
End trigonometric_symmetry.

Module trigonometric_symmetry_slip.
(* bezier/trigonometric.symmetry.slip, Symmetry
   printed: A common slip: T_{3-i}(x; λ, μ) = T_i(1 - x; λ, μ)
   stated: sum(i, 0, 3, T[3-i,3](x, lambda, mu)*P[i]) == sum(i, 0, 3, T[i,3](1 - x, lambda, mu)*P[i]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z 3%Z (fun i => T x lambda mu (3 - i)%Z 3%Z * P i) = sum 0%Z 3%Z (fun i => T (1 - x) lambda mu i 3%Z * P i).
End trigonometric_symmetry_slip.

Module trigonometric_symmetry_slip_corrected.
(* bezier/trigonometric.symmetry.slip (corrected), Symmetry
   printed: A common slip: T_{3-i}(x; λ, μ) = T_i(1 - x; λ, μ)
   stated: sum(i, 0, 3, T[3-i,3](x, lambda, mu)*P[i]) == sum(i, 0, 3, T[i,3](1 - x, mu, lambda)*P[i]) *)
Definition statement : Prop :=
forall (P : Z -> R) (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z 3%Z (fun i => T x lambda mu (3 - i)%Z 3%Z * P i) = sum 0%Z 3%Z (fun i => T (1 - x) mu lambda i 3%Z * P i).
Definition instance : Prop :=
exists (P : Z -> R) (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1 /\
  0 <= x <= 1.
End trigonometric_symmetry_slip_corrected.
