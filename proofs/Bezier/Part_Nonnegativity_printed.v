(* Statements of bezier, Part Nonnegativity. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
End Definitions.
Import Definitions.

Module bernstein_nonnegative.
(* bezier/bernstein.nonnegative, Nonnegativity
   printed: B_{i,m}(x) >= 0 for x in [0, 1]
   stated: nonnegative(B) *)
Definition statement : Prop :=
  forall x : R, 0 <= x <= 1 -> forall i k : Z, (0 <= k)%Z -> 0 <= B x i k.
End bernstein_nonnegative.

Module bernstein_nonnegative_slip.
(* bezier/bernstein.nonnegative.slip, Nonnegativity
   printed: A common slip: B_{2,3}(x) >= 0 for x in [0, 2] as well
   stated: B[2,3](x) >= 0 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 2 ->
  B x 2%Z 3%Z >= 0.
End bernstein_nonnegative_slip.

Module trigonometric_nonnegative.
(* bezier/trigonometric.nonnegative, Nonnegativity
   printed: The four functions are nonnegative for λ, μ in [-2, 1].
   stated: T[0,3](x) >= 0 and T[1,3](x) >= 0 and T[2,3](x) >= 0 and T[3,3](x) >= 0 *)
Definition statement : Prop :=
forall (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  T x lambda mu 0%Z 3%Z >= 0 /\ T x lambda mu 1%Z 3%Z >= 0 /\ T x lambda mu 2%Z 3%Z >= 0 /\ T x lambda mu 3%Z 3%Z >= 0.
Definition instance : Prop :=
exists (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1 /\
  0 <= x <= 1.
End trigonometric_nonnegative.

Module trigonometric_nonnegative_slip.
(* bezier/trigonometric.nonnegative.slip, Nonnegativity
   printed: A common slip: the first function is nonnegative for λ in [-2, 2].
   stated: T[0,3](x) >= 0 *)
Definition statement : Prop :=
forall (lambda : R) (mu : R) (x : R),
  (-2) <= lambda <= 2 ->
  (-2) <= mu <= 1 ->
  0 <= x <= 1 ->
  T x lambda mu 0%Z 3%Z >= 0.
End trigonometric_nonnegative_slip.
