(* Statements of trigonometric, Part Tangent. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (h : R) (r : R) (t : R) : list R :=
  [r * cos t; r * sin t; h * t].
End Definitions.
Import Definitions.

Module helix_torse.
(* trigonometric/helix.torse, Tangent surface
   printed: The tangent surface is developable: det(X', X', X'') = 0
   stated: det([X'(t), X'(t), X''(t)]) == 0 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  det [vDerive 3 (fun t => X h r t) 1 t; vDerive 3 (fun t => X h r t) 1 t; vDerive 3 (fun t => X h r t) 2 t] = 0.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r.
End helix_torse.

Module helix_normal.
(* trigonometric/helix.normal, Tangent surface
   printed: Its normal (X' + v X'') × X' is v times X'' × X', the same along a ruling but for a factor.
   stated: cross(X'(t) + v*X''(t), X'(t)) == v*cross(X''(t), X'(t)) *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R) (v : R),
  0 < h ->
  0 < r ->
  cross (vadd (vDerive 3 (fun t => X h r t) 1 t) (vscale v (vDerive 3 (fun t => X h r t) 2 t))) (vDerive 3 (fun t => X h r t) 1 t) = vscale v (cross (vDerive 3 (fun t => X h r t) 2 t) (vDerive 3 (fun t => X h r t) 1 t)).
Definition instance : Prop :=
exists (h : R) (r : R) (t : R) (v : R),
  0 < h /\
  0 < r.
End helix_normal.

Module helix_regular.
(* trigonometric/helix.regular, Tangent surface
   printed: X'' × X' is nowhere zero: its square is positive.
   stated: dot(cross(X''(t), X'(t)), cross(X''(t), X'(t))) > 0 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  dot (cross (vDerive 3 (fun t => X h r t) 2 t) (vDerive 3 (fun t => X h r t) 1 t)) (cross (vDerive 3 (fun t => X h r t) 2 t) (vDerive 3 (fun t => X h r t) 1 t)) > 0.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r.
End helix_regular.
