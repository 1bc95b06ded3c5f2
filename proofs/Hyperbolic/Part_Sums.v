(* Statements of hyperbolic, Part Sums. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module fn_pythagoras.
(* hyperbolic/fn.pythagoras, Sums
   printed: cosh² y - sinh² y = 1
   stated: cosh(y)^2 - sinh(y)^2 == 1 *)
Definition statement : Prop :=
forall (y : R),
  ((exp y + exp (- y)) / 2) ^ 2 - ((exp y - exp (- y)) / 2) ^ 2 = 1.
End fn_pythagoras.

Module fn_pythagoras_slip.
(* hyperbolic/fn.pythagoras.slip, Sums
   printed: A common slip: cosh² y + sinh² y = 1
   stated: cosh(y)^2 + sinh(y)^2 == 1 *)
Definition statement : Prop :=
forall (y : R),
  ((exp y + exp (- y)) / 2) ^ 2 + ((exp y - exp (- y)) / 2) ^ 2 = 1.
End fn_pythagoras_slip.

Module fn_pythagoras_slip_corrected.
(* hyperbolic/fn.pythagoras.slip (corrected), Sums
   printed: A common slip: cosh² y + sinh² y = 1
   stated: cosh(y)^2 - sinh(y)^2 == 1 *)
Definition statement : Prop :=
forall (y : R),
  ((exp y + exp (- y)) / 2) ^ 2 - ((exp y - exp (- y)) / 2) ^ 2 = 1.
End fn_pythagoras_slip_corrected.

Module fn_sum.
(* hyperbolic/fn.sum, Sums
   printed: cosh(y + z) = cosh y cosh z + sinh y sinh z
   stated: cosh(y + z) == cosh(y)*cosh(z) + sinh(y)*sinh(z) *)
Definition statement : Prop :=
forall (y : R) (z : R),
  (exp (y + z) + exp (- (y + z))) / 2 = (exp y + exp (- y)) / 2 * ((exp z + exp (- z)) / 2) + (exp y - exp (- y)) / 2 * ((exp z - exp (- z)) / 2).
End fn_sum.

Module fn_difference.
(* hyperbolic/fn.difference, Sums
   printed: sinh(y - z) = sinh y cosh z - cosh y sinh z
   stated: sinh(y - z) == sinh(y)*cosh(z) - cosh(y)*sinh(z) *)
Definition statement : Prop :=
forall (y : R) (z : R),
  (exp (y - z) - exp (- (y - z))) / 2 = (exp y - exp (- y)) / 2 * ((exp z + exp (- z)) / 2) - (exp y + exp (- y)) / 2 * ((exp z - exp (- z)) / 2).
End fn_difference.
