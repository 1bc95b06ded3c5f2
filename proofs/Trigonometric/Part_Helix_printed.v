(* Statements of trigonometric, Part Helix. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (h : R) (r : R) (t : R) : list R :=
  [r * cos t; r * sin t; h * t].
End Definitions.
Import Definitions.

Module helix_speed.
(* trigonometric/helix.speed, Helix
   printed: X'·X' = r² + h²
   stated: dot(X'(t), X'(t)) == r^2 + h^2 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  dot (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 1 t) = r ^ 2 + h ^ 2.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r.
End helix_speed.

Module helix_torsion.
(* trigonometric/helix.torsion, Helix
   printed: det(X', X'', X''') = r² h
   stated: det([X'(t), X''(t), X'''(t)]) == r^2*h *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  det [vDerive 3 (fun t => X h r t) 1 t; vDerive 3 (fun t => X h r t) 2 t; vDerive 3 (fun t => X h r t) 3 t] = r ^ 2 * h.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r.
End helix_torsion.

Module helix_curvature.
(* trigonometric/helix.curvature, Helix
   printed: The square of the curvature: (X' × X'')·(X' × X'')/(X'·X')^3 = r²/(r² + h²)²
   stated: dot(cross(X'(t), X''(t)), cross(X'(t), X''(t)))/dot(X'(t), X'(t))^3 == r^2/(r^2 + h^2)^2 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  dot (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 1 t) ^ 3 <> 0 ->
  (r ^ 2 + h ^ 2) ^ 2 <> 0 ->
  dot (cross (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 2 t)) (cross (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 2 t)) / dot (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 1 t) ^ 3 = r ^ 2 / (r ^ 2 + h ^ 2) ^ 2.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r /\
  dot (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 1 t) ^ 3 <> 0 /\
  (r ^ 2 + h ^ 2) ^ 2 <> 0.
End helix_curvature.
