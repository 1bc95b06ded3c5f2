(* Statements of hyperbolic, Part Catenary. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition K (t : R) : list R :=
  [t; (exp t + exp (- t)) / 2].
End Definitions.
Import Definitions.

Module catenary_speed.
(* hyperbolic/catenary.speed, Catenary
   printed: K'·K' = cosh² t
   stated: dot(K'(t), K'(t)) == cosh(t)^2 *)
Definition statement : Prop :=
forall (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) = ((exp t + exp (- t)) / 2) ^ 2.
End catenary_speed.

Module catenary_length.
(* hyperbolic/catenary.length, Catenary
   printed: The arc from 0 to t is sinh t long: (sinh t)'² = K'·K'
   stated: D(sinh(t), t)^2 == dot(K'(t), K'(t)) *)
Definition statement : Prop :=
forall (t : R),
  Derive_n (fun t => (exp t - exp (- t)) / 2) 1 t ^ 2 = dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t).
End catenary_length.

Module catenary_curvature.
(* hyperbolic/catenary.curvature, Catenary
   printed: The square of the curvature: det(K', K'')^2/(K'·K')^3 = 1/cosh^4 t
   stated: det([K'(t), K''(t)])^2/dot(K'(t), K'(t))^3 == 1/cosh(t)^4 *)
Definition statement : Prop :=
forall (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 ->
  ((exp t + exp (- t)) / 2) ^ 4 <> 0 ->
  det [vDerive 2 (fun t => K t) 1 t; vDerive 2 (fun t => K t) 2 t] ^ 2 / dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2) ^ 4.
Definition instance : Prop :=
exists (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 /\
  ((exp t + exp (- t)) / 2) ^ 4 <> 0.
End catenary_curvature.

Module catenary_curvature_slip.
(* hyperbolic/catenary.curvature.slip, Catenary
   printed: A common slip: det(K', K'')^2/(K'·K')^3 = 1/cosh² t
   stated: det([K'(t), K''(t)])^2/dot(K'(t), K'(t))^3 == 1/cosh(t)^2 *)
Definition statement : Prop :=
forall (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 ->
  ((exp t + exp (- t)) / 2) ^ 2 <> 0 ->
  det [vDerive 2 (fun t => K t) 1 t; vDerive 2 (fun t => K t) 2 t] ^ 2 / dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2) ^ 2.
End catenary_curvature_slip.

Module catenary_curvature_slip_corrected.
(* hyperbolic/catenary.curvature.slip (corrected), Catenary
   printed: A common slip: det(K', K'')^2/(K'·K')^3 = 1/cosh² t
   stated: det([K'(t), K''(t)])^2/dot(K'(t), K'(t))^3 == 1/cosh(t)^4 *)
Definition statement : Prop :=
forall (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 ->
  ((exp t + exp (- t)) / 2) ^ 4 <> 0 ->
  det [vDerive 2 (fun t => K t) 1 t; vDerive 2 (fun t => K t) 2 t] ^ 2 / dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2) ^ 4.
Definition instance : Prop :=
exists (t : R),
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 /\
  ((exp t + exp (- t)) / 2) ^ 4 <> 0.
End catenary_curvature_slip_corrected.

Module catenary_load.
(* hyperbolic/catenary.load, Catenary
   printed: The slope grows like the arc: (cosh'' t)² = 1 + (cosh' t)²
   stated: D(cosh(t), t, 2)^2 == 1 + D(cosh(t), t)^2 *)
Definition statement : Prop :=
forall (t : R),
  Derive_n (fun t => (exp t + exp (- t)) / 2) 2 t ^ 2 = 1 + Derive_n (fun t => (exp t + exp (- t)) / 2) 1 t ^ 2.
End catenary_load.
