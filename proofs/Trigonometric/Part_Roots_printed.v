(* Statements of trigonometric, Part Roots. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (h : R) (r : R) (t : R) : list R :=
  [r * cos t; r * sin t; h * t].
Definition Z_ (r : R) (t : R) (v : R) : list R :=
  [r * cos t; r * sin t; v].
End Definitions.
Import Definitions.

Module helix_length.
(* trigonometric/helix.length, Roots
   printed: |X'| = √(r² + h²)
   stated: norm(X'(t)) == sqrt(r^2 + h^2) *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  0 <= r ^ 2 + h ^ 2 ->
  norm (vDerive 3 (fun t => X h r t) 1 t) = sqrt (r ^ 2 + h ^ 2).
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r /\
  0 <= r ^ 2 + h ^ 2.
End helix_length.

Module helix_bend.
(* trigonometric/helix.bend, Roots
   printed: The curvature: |X' × X''|/|X'|³ = r/(r² + h²)
   stated: norm(cross(X'(t), X''(t)))/norm(X'(t))^3 == r/(r^2 + h^2) *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  norm (vDerive 3 (fun t => X h r t) 1 t) ^ 3 <> 0 ->
  r ^ 2 + h ^ 2 <> 0 ->
  norm (cross (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 2 t)) / norm (vDerive 3 (fun t => X h r t) 1 t) ^ 3 = r / (r ^ 2 + h ^ 2).
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r /\
  norm (vDerive 3 (fun t => X h r t) 1 t) ^ 3 <> 0 /\
  r ^ 2 + h ^ 2 <> 0.
End helix_bend.

Module helix_bend_slip.
(* trigonometric/helix.bend.slip, Roots
   printed: A common slip, the square root forgotten: |X' × X''|/|X'|³ = r²/(r² + h²)²
   stated: norm(cross(X'(t), X''(t)))/norm(X'(t))^3 == r^2/(r^2 + h^2)^2 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  norm (vDerive 3 (fun t => X h r t) 1 t) ^ 3 <> 0 ->
  (r ^ 2 + h ^ 2) ^ 2 <> 0 ->
  norm (cross (vDerive 3 (fun t => X h r t) 1 t) (vDerive 3 (fun t => X h r t) 2 t)) / norm (vDerive 3 (fun t => X h r t) 1 t) ^ 3 = r ^ 2 / (r ^ 2 + h ^ 2) ^ 2.
End helix_bend_slip.

Module cylinder_normal.
(* trigonometric/cylinder.normal, Roots
   printed: The unit normal of the cylinder Z(t, v) = (r cos t, r sin t, v) is N.
   stated: cross(D(Z)(t, v), D(Z, v)(t, v))/norm(cross(D(Z)(t, v), D(Z, v)(t, v))) == N(t) *)
Definition N_ (t : R) : list R :=
  [cos t; sin t; 0].
Definition statement : Prop :=
forall (r : R) (t : R) (v : R),
  0 < r ->
  norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)) <> 0 ->
  vdiv (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)) (norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v))) = N_ t.
Definition instance : Prop :=
exists (r : R) (t : R) (v : R),
  0 < r /\
  norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)) <> 0.
End cylinder_normal.

Module cylinder_offset.
(* trigonometric/cylinder.offset, Roots
   printed: Its offset at the distance h is the cylinder of radius r + h.
   stated: Z(t, v) + h*cross(D(Z)(t, v), D(Z, v)(t, v))/norm(cross(D(Z)(t, v), D(Z, v)(t, v))) == [(r + h)*cos(t), (r + h)*sin(t), v] *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R) (v : R),
  0 < h ->
  0 < r ->
  norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)) <> 0 ->
  vadd (Z_ r t v) (vdiv (vscale h (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v))) (norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)))) = [(r + h) * cos t; (r + h) * sin t; v].
Definition instance : Prop :=
exists (h : R) (r : R) (t : R) (v : R),
  0 < h /\
  0 < r /\
  norm (cross (vDerive 3 (fun t => Z_ r t v) 1 t) (vDerive 3 (fun v => Z_ r t v) 1 v)) <> 0.
End cylinder_offset.
