(* Statements of hyperbolic, Part Spiral. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition L (d : R) (r : R) (t : R) : list R :=
  [exp (r * t) * cos t; exp (r * t) * sin t; d * exp (r * t)].
End Definitions.
Import Definitions.

Module cone_slope.
(* hyperbolic/cone.slope, Spiral on a cone
   printed: L lies on the cone x² + y² = z²/d², and its tangents have one slope: L_3'² (1 + r² + d² r²) = d² r² L'·L'
   stated: L(t)[1]^2 + L(t)[2]^2 == L(t)[3]^2/d^2 and L'(t)[3]^2*(1 + r^2 + d^2*r^2) == d^2*r^2*dot(L'(t), L'(t)) *)
Definition statement : Prop :=
forall (d : R) (r : R) (t : R),
  0 < d ->
  d ^ 2 <> 0 ->
  entry (L d r t) 1 ^ 2 + entry (L d r t) 2 ^ 2 = entry (L d r t) 3 ^ 2 / d ^ 2 /\ entry (vDerive 3 (fun t => L d r t) 1 t) 3 ^ 2 * (1 + r ^ 2 + d ^ 2 * r ^ 2) = d ^ 2 * r ^ 2 * dot (vDerive 3 (fun t => L d r t) 1 t) (vDerive 3 (fun t => L d r t) 1 t).
Definition instance : Prop :=
exists (d : R) (r : R) (t : R),
  0 < d /\
  d ^ 2 <> 0.
End cone_slope.

Module cone_torsion.
(* hyperbolic/cone.torsion, Spiral on a cone
   printed: det(L', L'', L''') = d r (1 + r²) e^(3 r t)
   stated: det([L'(t), L''(t), L'''(t)]) == d*r*(1 + r^2)*exp(3*r*t) *)
Definition statement : Prop :=
forall (d : R) (r : R) (t : R),
  0 < d ->
  det [vDerive 3 (fun t => L d r t) 1 t; vDerive 3 (fun t => L d r t) 2 t; vDerive 3 (fun t => L d r t) 3 t] = d * r * (1 + r ^ 2) * exp (3 * r * t).
Definition instance : Prop :=
exists (d : R) (r : R) (t : R),
  0 < d.
End cone_torsion.

Module cone_torse.
(* hyperbolic/cone.torse, Spiral on a cone
   printed: The tangents of L form a torse: det(L', L', L'') = 0
   stated: det([L'(t), L'(t), L''(t)]) == 0 *)
Definition statement : Prop :=
forall (d : R) (r : R) (t : R),
  0 < d ->
  det [vDerive 3 (fun t => L d r t) 1 t; vDerive 3 (fun t => L d r t) 1 t; vDerive 3 (fun t => L d r t) 2 t] = 0.
Definition instance : Prop :=
exists (d : R) (r : R) (t : R),
  0 < d.
End cone_torse.
