(* Statements of bezier, Part Derivative. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
End Definitions.
Import Definitions.

Module bernstein_derivative.
(* bezier/bernstein.derivative, Derivative
   printed: B'_{i,m}(x) = m (B_{i-1,m-1}(x) - B_{i,m-1}(x))
   stated: D(B[i,m](x), x) == m*(B[i-1,m-1](x) - B[i,m-1](x)) *)
Definition statement : Prop :=
forall (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z ->
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z ->
  (0 <= m - 1)%Z ->
  Derive_n (fun x => B x i m) 1 x = IZR m * (B x (i - 1)%Z (m - 1)%Z - B x i (m - 1)%Z).
Definition instance : Prop :=
exists (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z /\
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (0 <= m)%Z /\
  (0 <= m - 1)%Z.
End bernstein_derivative.

Module bernstein_derivative_slip.
(* bezier/bernstein.derivative.slip, Derivative
   printed: A common slip: B'_{1,3}(x) = 3 (B_{1,2}(x) - B_{0,2}(x))
   stated: D(B[1,3](x), x) == 3*(B[1,2](x) - B[0,2](x)) *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  Derive_n (fun x => B x 1%Z 3%Z) 1 x = 3 * (B x 1%Z 2%Z - B x 0%Z 2%Z).
End bernstein_derivative_slip.

Module bernstein_derivative_slip_corrected.
(* bezier/bernstein.derivative.slip (corrected), Derivative
   printed: A common slip: B'_{1,3}(x) = 3 (B_{1,2}(x) - B_{0,2}(x))
   stated: D(B[1,3](x), x) == -(3*(B[1,2](x) - B[0,2](x))) *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  Derive_n (fun x => B x 1%Z 3%Z) 1 x = - (3 * (B x 1%Z 2%Z - B x 0%Z 2%Z)).
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End bernstein_derivative_slip_corrected.
