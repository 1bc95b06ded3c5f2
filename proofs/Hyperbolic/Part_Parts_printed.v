(* Statements of hyperbolic, Part Parts. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module fn_half.
(* hyperbolic/fn.half, Parts
   printed: cosh y = 1 + 2 sinh²(y/2)
   stated: cosh(y) == 1 + 2*sinh(y/2)^2 *)
Definition statement : Prop :=
forall (y : R),
  (exp y + exp (- y)) / 2 = 1 + 2 * ((exp (y / 2) - exp (- (y / 2))) / 2) ^ 2.
End fn_half.

Module fn_half_slip.
(* hyperbolic/fn.half.slip, Parts
   printed: A common slip, the sign of the circle: cosh y = 1 - 2 sinh²(y/2)
   stated: cosh(y) == 1 - 2*sinh(y/2)^2 *)
Definition statement : Prop :=
forall (y : R),
  (exp y + exp (- y)) / 2 = 1 - 2 * ((exp (y / 2) - exp (- (y / 2))) / 2) ^ 2.
End fn_half_slip.

Module fn_half_slip_corrected.
(* hyperbolic/fn.half.slip (corrected), Parts
   printed: A common slip, the sign of the circle: cosh y = 1 - 2 sinh²(y/2)
   stated: cosh(y) == 1 + 2*sinh(y/2)^2 *)
Definition statement : Prop :=
forall (y : R),
  (exp y + exp (- y)) / 2 = 1 + 2 * ((exp (y / 2) - exp (- (y / 2))) / 2) ^ 2.
End fn_half_slip_corrected.

Module fn_third.
(* hyperbolic/fn.third, Parts
   printed: sinh y = 3 sinh(y/3) + 4 sinh³(y/3)
   stated: sinh(y) == 3*sinh(y/3) + 4*sinh(y/3)^3 *)
Definition statement : Prop :=
forall (y : R),
  (exp y - exp (- y)) / 2 = 3 * ((exp (y / 3) - exp (- (y / 3))) / 2) + 4 * ((exp (y / 3) - exp (- (y / 3))) / 2) ^ 3.
End fn_third.

Module fn_tangent.
(* hyperbolic/fn.tangent, Parts
   printed: tanh(y/2) = sinh y/(1 + cosh y)
   stated: tanh(y/2) == sinh(y)/(1 + cosh(y)) *)
Definition statement : Prop :=
forall (y : R),
  exp (y / 2) + exp (- (y / 2)) <> 0 ->
  1 + (exp y + exp (- y)) / 2 <> 0 ->
  (exp (y / 2) - exp (- (y / 2))) / (exp (y / 2) + exp (- (y / 2))) = (exp y - exp (- y)) / 2 / (1 + (exp y + exp (- y)) / 2).
Definition instance : Prop :=
exists (y : R),
  exp (y / 2) + exp (- (y / 2)) <> 0 /\
  1 + (exp y + exp (- y)) / 2 <> 0.
End fn_tangent.
