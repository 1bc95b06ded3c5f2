(* Statements of hyperbolic, Part Values. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module fn_number.
(* hyperbolic/fn.number, Values
   printed: (e^(1/2))² = e, and e = 2.71828
   stated: exp(1/2)^2 == exp(1) and agrees(exp(1), 2.71828) *)
Definition statement : Prop :=
  exp (1 / 2) ^ 2 = exp 1 /\ agrees_up (exp 1) (67957 / 25000) 5.
End fn_number.

Module fn_value.
(* hyperbolic/fn.value, Values
   printed: cosh 1 = 1.54308
   stated: agrees(cosh(1), 1.54308) *)
Definition statement : Prop :=
  agrees_up ((exp 1 + exp (- 1)) / 2) (38577 / 25000) 5.
End fn_value.
