(* Statements of trigonometric, Part Cardioid. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition K (t : R) : list R :=
  [(1 + cos t) * cos t; (1 + cos t) * sin t].
End Definitions.
Import Definitions.

Module cardioid_speed.
(* trigonometric/cardioid.speed, Cardioid
   printed: K'·K' = 4 cos²(t/2)
   stated: dot(K'(t), K'(t)) == 4*cos(t/2)^2 *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 2 * PI ->
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) = 4 * cos (t / 2) ^ 2.
Definition instance : Prop :=
exists (t : R),
  0 < t < 2 * PI.
End cardioid_speed.

Module cardioid_cusp.
(* trigonometric/cardioid.cusp, Cardioid
   printed: K'(π) = 0
   stated: K'(pi) == [0, 0] *)
Definition statement : Prop :=
  vDerive 2 (fun t => K t) 1 PI = [0; 0].
End cardioid_cusp.

Module cardioid_curvature.
(* trigonometric/cardioid.curvature, Cardioid
   printed: The square of the curvature for 0 < t < π: det(K', K'')^2/(K'·K')^3 = 9/(16 cos²(t/2))
   stated: det([K'(t), K''(t)])^2/dot(K'(t), K'(t))^3 == 9/(16*cos(t/2)^2) *)
Definition statement : Prop :=
forall (t : R),
  0 < t < 1 * PI ->
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 ->
  16 * cos (t / 2) ^ 2 <> 0 ->
  det [vDerive 2 (fun t => K t) 1 t; vDerive 2 (fun t => K t) 2 t] ^ 2 / dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 = 9 / (16 * cos (t / 2) ^ 2).
Definition instance : Prop :=
exists (t : R),
  0 < t < 1 * PI /\
  dot (vDerive 2 (fun t => K t) 1 t) (vDerive 2 (fun t => K t) 1 t) ^ 3 <> 0 /\
  16 * cos (t / 2) ^ 2 <> 0.
End cardioid_curvature.
