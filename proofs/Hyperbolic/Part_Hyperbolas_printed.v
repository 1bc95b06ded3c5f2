(* Statements of hyperbolic, Part Hyperbolas. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (t : R) (a : R) : R :=
  ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition g (t : R) (a : R) : R :=
  2 * ((exp (a / 2) + exp (- (a / 2))) / 2) * ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) * ((exp (t / 2) - exp (- (t / 2))) / 2) / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition h (t : R) (a : R) : R :=
  ((exp (t / 2) - exp (- (t / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition E_ (a : R) (t : R) : list R :=
  vadd (vadd (vscale (f t a) [1; 0]) (vscale (g t a) [1; (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2)))])) (vscale (h t a) [(exp a + exp (- a)) / 2; (exp a - exp (- a)) / 2]).
End Definitions.
Import Definitions.

Module curve_hyperbola.
(* hyperbolic/curve.hyperbola, Hyperbolas
   printed: The points (1, 0), (1, tanh(a/2)), (cosh a, sinh a) give (cosh t, sinh t).
   stated: E(t) == [cosh(t), sinh(t)] *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  E_ a t = [(exp t + exp (- t)) / 2; (exp t - exp (- t)) / 2].
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  exp (a / 2) + exp (- (a / 2)) <> 0.
End curve_hyperbola.

Module curve_hyperbola_implicit.
(* hyperbolic/curve.hyperbola.implicit, Hyperbolas
   printed: E_1² - E_2² = 1
   stated: E(t)[1]^2 - E(t)[2]^2 == 1 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  entry (E_ a t) 1 ^ 2 - entry (E_ a t) 2 ^ 2 = 1.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  exp (a / 2) + exp (- (a / 2)) <> 0.
End curve_hyperbola_implicit.

Module curve_hyperbola_tangent.
(* hyperbolic/curve.hyperbola.tangent, Hyperbolas
   printed: The middle point lies on the tangents at both ends: det(E'(a), E(a) - E_1) = 0 with E_1 = (1, tanh(a/2))
   stated: det([E'(a), E(a) - [1, tanh(a/2)]]) == 0 *)
Definition statement : Prop :=
forall (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  det [vDerive 2 (fun t => E_ a t) 1 a; vsub (E_ a a) [1; (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2)))]] = 0.
Definition instance : Prop :=
exists (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  exp (a / 2) + exp (- (a / 2)) <> 0.
End curve_hyperbola_tangent.
