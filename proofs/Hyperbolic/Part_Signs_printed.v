(* Statements of hyperbolic, Part Signs. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module fn_positive.
(* hyperbolic/fn.positive, Signs
   printed: e^y > 0 and cosh y >= 1
   stated: exp(y) > 0 and cosh(y) >= 1 *)
Definition statement : Prop :=
forall (y : R),
  exp y > 0 /\ (exp y + exp (- y)) / 2 >= 1.
End fn_positive.

Module fn_strict_slip.
(* hyperbolic/fn.strict.slip, Signs
   printed: A common slip: cosh y > 1
   stated: cosh(y) > 1 *)
Definition statement : Prop :=
forall (y : R),
  (exp y + exp (- y)) / 2 > 1.
End fn_strict_slip.

Module fn_bounded.
(* hyperbolic/fn.bounded, Signs
   printed: -1 < tanh y < 1
   stated: -1 < tanh(y) and tanh(y) < 1 *)
Definition statement : Prop :=
forall (y : R),
  exp y + exp (- y) <> 0 ->
  - 1 < (exp y - exp (- y)) / (exp y + exp (- y)) /\ (exp y - exp (- y)) / (exp y + exp (- y)) < 1.
Definition instance : Prop :=
exists (y : R),
  exp y + exp (- y) <> 0.
End fn_bounded.

Module fn_tangent_line.
(* hyperbolic/fn.tangent.line, Signs
   printed: e^y >= 1 + y
   stated: exp(y) >= 1 + y *)
Definition statement : Prop :=
forall (y : R),
  exp y >= 1 + y.
End fn_tangent_line.

Module fn_unit.
(* hyperbolic/fn.unit, Signs
   printed: 1 <= e^x <= e on [0, 1]
   stated: 1 <= exp(x) and exp(x) <= exp(1) *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  1 <= exp x /\ exp x <= exp 1.
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End fn_unit.
