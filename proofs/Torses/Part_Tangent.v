(* Statements of torses, Part Tangent. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition T (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd c'_u_ (vscale (1 * u) c''_u_))).
Definition T_ (c'_u_ : list R) (c_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v c'_u_).
Definition NT (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) (vDerive 3 (fun v_ => T_ c'_u_ c_u_ (v + v_)) 1 0).
End Definitions.
Import Definitions.

Module tangents_torse.
(* torses/tangents.torse, Tangent surface
   printed: det(c', c', c'') = 0
   stated: det([c'(u), c'(u), c''(u)]) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  det [c'_u_; c'_u_; c''_u_] = 0.
End tangents_torse.

Module tangents_normal.
(* torses/tangents.normal, Tangent surface
   printed: Its normal is v c'' × c'.
   stated: NT(u, v) == v*cross(c''(u), c'(u)) *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  NT c''_u_ c'_u_ c_u_ u v = vscale v (cross c''_u_ c'_u_).
End tangents_normal.

Module tangents_edge.
(* torses/tangents.edge, Tangent surface
   printed: It is singular along the curve: the normal is zero at v = 0.
   stated: NT(u, 0) == 0 *)
Definition T (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (v : Z) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale (IZR v) (vadd c'_u_ (vscale (1 * u) c''_u_))).
Definition NT (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (u : R) (v : Z) : list R :=
  cross (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) (vDerive 3 (fun v_ => T_ c'_u_ c_u_ (IZR v + v_)) 1 0).
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  NT c''_u_ c'_u_ c_u_ u 0%Z = zeros 3.
End tangents_edge.

Module tangents_osculating.
(* torses/tangents.osculating, Tangent surface
   printed: The osculating planes of c touch it.
   stated: cross(NT(u, v), cross(c'(u), c''(u))) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  cross (NT c''_u_ c'_u_ c_u_ u v) (cross c'_u_ c''_u_) = zeros 3.
End tangents_osculating.

Module tangents_metric.
(* torses/tangents.metric, Tangent surface
   printed: If u is the arc length, T_u · T_u = 1 + v² c'' · c'': curvature alone counts when it is unrolled.
   stated: dot(D(T)(u, v), D(T)(u, v)) == 1 + v^2*dot(c''(u), c''(u)) *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  dot c'_u_ c'_u_ = 1 ->
  dot c'_u_ c''_u_ = 0 ->
  dot (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) = 1 + v ^ 2 * dot c''_u_ c''_u_.
Definition instance : Prop :=
exists (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  dot c'_u_ c'_u_ = 1 /\
  dot c'_u_ c''_u_ = 0.
End tangents_metric.

Module tangents_metric_slip.
(* torses/tangents.metric.slip, Tangent surface
   printed: A slip: for any parameter T_u · T_u = c' · c' + v² c'' · c''.
   stated: dot(D(T)(u, v), D(T)(u, v)) == dot(c'(u), c'(u)) + v^2*dot(c''(u), c''(u)) *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  dot (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) (vDerive 3 (fun u_ => T c''_u_ c'_u_ c_u_ v u_) 1 0) = dot c'_u_ c'_u_ + v ^ 2 * dot c''_u_ c''_u_.
End tangents_metric_slip.
