(* Statements of hyperbolic, Part Logarithmic. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition S_ (r : R) (t : R) : list R :=
  [exp (r * t) * cos t; exp (r * t) * sin t].
End Definitions.
Import Definitions.

Module spiral_angle.
(* hyperbolic/spiral.angle, Logarithmic spiral
   printed: Radius and tangent make one angle: (1 + r²)(S·S')² = r² (S·S)(S'·S')
   stated: (1 + r^2)*dot(S(t), S'(t))^2 == r^2*dot(S(t), S(t))*dot(S'(t), S'(t)) *)
Definition statement : Prop :=
forall (r : R) (t : R),
  (1 + r ^ 2) * dot (S_ r t) (vDerive 2 (fun t => S_ r t) 1 t) ^ 2 = r ^ 2 * dot (S_ r t) (S_ r t) * dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t).
End spiral_angle.

Module spiral_angle_slip.
(* hyperbolic/spiral.angle.slip, Logarithmic spiral
   printed: A common slip: (S·S')² = r² (S·S)(S'·S')
   stated: dot(S(t), S'(t))^2 == r^2*dot(S(t), S(t))*dot(S'(t), S'(t)) *)
Definition statement : Prop :=
forall (r : R) (t : R),
  dot (S_ r t) (vDerive 2 (fun t => S_ r t) 1 t) ^ 2 = r ^ 2 * dot (S_ r t) (S_ r t) * dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t).
End spiral_angle_slip.

Module spiral_regular.
(* hyperbolic/spiral.regular, Logarithmic spiral
   printed: S'·S' > 0
   stated: dot(S'(t), S'(t)) > 0 *)
Definition statement : Prop :=
forall (r : R) (t : R),
  dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t) > 0.
End spiral_regular.

Module spiral_curvature.
(* hyperbolic/spiral.curvature, Logarithmic spiral
   printed: det(S', S'')^2/(S'·S')^3 = e^(-2 r t)/(1 + r²)
   stated: det([S'(t), S''(t)])^2/dot(S'(t), S'(t))^3 == exp(-2*r*t)/(1 + r^2) *)
Definition statement : Prop :=
forall (r : R) (t : R),
  dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t) ^ 3 <> 0 ->
  1 + r ^ 2 <> 0 ->
  det [vDerive 2 (fun t => S_ r t) 1 t; vDerive 2 (fun t => S_ r t) 2 t] ^ 2 / dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t) ^ 3 = exp (- 2 * r * t) / (1 + r ^ 2).
Definition instance : Prop :=
exists (r : R) (t : R),
  dot (vDerive 2 (fun t => S_ r t) 1 t) (vDerive 2 (fun t => S_ r t) 1 t) ^ 3 <> 0 /\
  1 + r ^ 2 <> 0.
End spiral_curvature.
