(* Statements of torses, Part Tangent. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition T (c : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (vDerive 3 (fun x => c x) 1 u)).
Definition NT (c : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => T c u v) 1 u) (vDerive 3 (fun v => T c u v) 1 v).
End Definitions.
Import Definitions.

Module tangents_torse.
(* torses/tangents.torse, Tangent surface
   printed: det(c', c', c'') = 0
   stated: det([c'(u), c'(u), c''(u)]) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u] = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End tangents_torse.

Module tangents_normal.
(* torses/tangents.normal, Tangent surface
   printed: Its normal is v c'' × c'.
   stated: NT(u, v) == v*cross(c''(u), c'(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  NT c u v = vscale v (cross (vDerive 3 (fun x => c x) 2 u) (vDerive 3 (fun x => c x) 1 u)).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End tangents_normal.

Module tangents_edge.
(* torses/tangents.edge, Tangent surface
   printed: It is singular along the curve: the normal is zero at v = 0.
   stated: NT(u, 0) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  NT c u 0 = zeros 3.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End tangents_edge.

Module tangents_osculating.
(* torses/tangents.osculating, Tangent surface
   printed: The osculating planes of c touch it.
   stated: cross(NT(u, v), cross(c'(u), c''(u))) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  cross (NT c u v) (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) = zeros 3.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End tangents_osculating.

Module tangents_metric.
(* torses/tangents.metric, Tangent surface
   printed: If u is the arc length, T_u · T_u = 1 + v² c'' · c'': curvature alone counts when it is unrolled.
   stated: dot(D(T)(u, v), D(T)(u, v)) == 1 + v^2*dot(c''(u), c''(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 1 u) = 1 ->
  dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u) = 0 ->
  dot (vDerive 3 (fun u => T c u v) 1 u) (vDerive 3 (fun u => T c u v) 1 u) = 1 + v ^ 2 * dot (vDerive 3 (fun x => c x) 2 u) (vDerive 3 (fun x => c x) 2 u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 1 u) = 1 /\
  dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u) = 0.
End tangents_metric.

Module tangents_metric_slip.
(* torses/tangents.metric.slip, Tangent surface
   printed: A slip: for any parameter T_u · T_u = c' · c' + v² c'' · c''.
   stated: dot(D(T)(u, v), D(T)(u, v)) == dot(c'(u), c'(u)) + v^2*dot(c''(u), c''(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  dot (vDerive 3 (fun u => T c u v) 1 u) (vDerive 3 (fun u => T c u v) 1 u) = dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 1 u) + v ^ 2 * dot (vDerive 3 (fun x => c x) 2 u) (vDerive 3 (fun x => c x) 2 u).
End tangents_metric_slip.
