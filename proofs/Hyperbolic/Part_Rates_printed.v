(* Statements of hyperbolic, Part Rates. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module fn_rate.
(* hyperbolic/fn.rate, Rates
   printed: the derivative of tanh y is 1 - tanh² y
   stated: D(tanh(y), y) == 1 - tanh(y)^2 *)
Definition statement : Prop :=
forall (y : R),
  locally y (fun y => exp y + exp (- y) <> 0) ->
  exp y + exp (- y) <> 0 ->
  Derive_n (fun y => (exp y - exp (- y)) / (exp y + exp (- y))) 1 y = 1 - ((exp y - exp (- y)) / (exp y + exp (- y))) ^ 2.
Definition instance : Prop :=
exists (y : R),
  locally y (fun y => exp y + exp (- y) <> 0) /\
  exp y + exp (- y) <> 0.
End fn_rate.

Module fn_growth.
(* hyperbolic/fn.growth, Rates
   printed: the second derivative of e^(c y) by y is c² e^(c y), the first by c is y e^(c y)
   stated: D(exp(c*y), y, 2) == c^2*exp(c*y) and D(exp(c*y), c) == y*exp(c*y) *)
Definition statement : Prop :=
forall (c : R) (y : R),
  Derive_n (fun y => exp (c * y)) 2 y = c ^ 2 * exp (c * y) /\ Derive_n (fun c => exp (c * y)) 1 c = y * exp (c * y).
End fn_growth.

Module fn_bell.
(* hyperbolic/fn.bell, Rates
   printed: the second derivative of exp(-y²/2) is y² - 1 times exp(-y²/2)
   stated: D(exp(-y^2/2), y, 2) == (y^2 - 1)*exp(-y^2/2) *)
Definition statement : Prop :=
forall (y : R),
  Derive_n (fun y => exp (- y ^ 2 / 2)) 2 y = (y ^ 2 - 1) * exp (- y ^ 2 / 2).
End fn_bell.

Module fn_damped.
(* hyperbolic/fn.damped, Rates
   printed: the second derivative of e^(-y) sin y is -2 e^(-y) cos y
   stated: D(exp(-y)*sin(y), y, 2) == -2*exp(-y)*cos(y) *)
Definition statement : Prop :=
forall (y : R),
  Derive_n (fun y => exp (- y) * sin y) 2 y = - 2 * exp (- y) * cos y.
End fn_damped.

Module fn_damped_slip.
(* hyperbolic/fn.damped.slip, Rates
   printed: A common slip: the second derivative of e^(-y) sin y is -2 e^(-y) sin y
   stated: D(exp(-y)*sin(y), y, 2) == -2*exp(-y)*sin(y) *)
Definition statement : Prop :=
forall (y : R),
  Derive_n (fun y => exp (- y) * sin y) 2 y = - 2 * exp (- y) * sin y.
End fn_damped_slip.

Module fn_damped_slip_corrected.
(* hyperbolic/fn.damped.slip (corrected), Rates
   printed: A common slip: the second derivative of e^(-y) sin y is -2 e^(-y) sin y
   stated: D(exp(-y)*sin(y), y, 2) == -2*exp(-y)*cos(y) *)
Definition statement : Prop :=
forall (y : R),
  Derive_n (fun y => exp (- y) * sin y) 2 y = - 2 * exp (- y) * cos y.
End fn_damped_slip_corrected.
