(* Statements of torses, Part Edge. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition s (c : R -> list R) (r : R -> list R) (u : R) : R :=
  - dot (cross (vDerive 3 (fun x => c x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) / dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)).
Definition S_ (c : R -> list R) (r : R -> list R) (u : R) : list R :=
  vadd (c u) (vscale (s c r u) (r u)).
Definition W (n : R -> list R) (u : R) : R :=
  det [n u; vDerive 3 (fun x => n x) 1 u; vDerive 3 (fun x => n x) 2 u].
Definition edge (d : R -> R) (n : R -> list R) (u : R) : list R :=
  vdiv (vadd (vadd (vscale (d u) (cross (vDerive 3 (fun x => n x) 1 u) (vDerive 3 (fun x => n x) 2 u))) (vscale (Derive_n (fun x => d x) 1 u) (cross (vDerive 3 (fun x => n x) 2 u) (n u)))) (vscale (Derive_n (fun x => d x) 2 u) (cross (n u) (vDerive 3 (fun x => n x) 1 u)))) (W n u).
End Definitions.
Import Definitions.

Module regression_singular.
(* torses/regression.singular, Edge of regression
   printed: On a torse the normal is zero at the central point.
   stated: N(u, s(u)) == 0 *)
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  delta c r u = 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  N_ c r u (s c r u) = zeros 3.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  delta c r u = 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End regression_singular.

Module regression_tangent.
(* torses/regression.tangent, Edge of regression
   printed: A torse consists of the tangents of its edge of regression: S' × r = 0.
   stated: cross(S'(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  delta c r u = 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  locally u (fun u_ => dot (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) <> 0) ->
  cross (vDerive 3 (fun u => S_ c r u) 1 u) (r u) = zeros 3.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  delta c r u = 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  locally u (fun u_ => dot (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) <> 0).
End regression_tangent.

Module regression_tangent_slip.
(* torses/regression.tangent.slip, Edge of regression
   printed: A slip: S' × r = 0 on every ruled surface.
   stated: cross(S'(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  locally u (fun u_ => dot (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) (cross (vDerive 3 (fun x => r x) 1 u_) (r u_)) <> 0) ->
  cross (vDerive 3 (fun u => S_ c r u) 1 u) (r u) = zeros 3.
End regression_tangent_slip.

Module planes_edge.
(* torses/planes.edge, Edge of regression
   printed: The point of three planes: x = (d n' × n'' + d' n'' × n + d'' n × n')/det(n, n', n'')
   stated: x == edge(u) *)
Definition statement : Prop :=
forall (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R) (x'1 x'2 x'3 : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  let x := [x'1; x'2; x'3] in
  smooth d ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u <> 0 ->
  dot (n u) x = d u ->
  dot (vDerive 3 (fun x => n x) 1 u) x = Derive_n (fun x => d x) 1 u ->
  dot (vDerive 3 (fun x => n x) 2 u) x = Derive_n (fun x => d x) 2 u ->
  x = edge d n u.
Definition instance : Prop :=
exists (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R) (x'1 x'2 x'3 : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  let x := [x'1; x'2; x'3] in
  smooth d /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u <> 0 /\
  dot (n u) x = d u /\
  dot (vDerive 3 (fun x => n x) 1 u) x = Derive_n (fun x => d x) 1 u /\
  dot (vDerive 3 (fun x => n x) 2 u) x = Derive_n (fun x => d x) 2 u.
End planes_edge.

Module planes_edge_in.
(* torses/planes.edge.in, Edge of regression
   printed: The point is in the plane and on the ruling: n · e = d, n' · e = d'.
   stated: [dot(n(u), edge(u)), dot(n'(u), edge(u))] == [d(u), d'(u)] *)
Definition statement : Prop :=
forall (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u <> 0 ->
  [dot (n u) (edge d n u); dot (vDerive 3 (fun x => n x) 1 u) (edge d n u)] = [d u; Derive_n (fun x => d x) 1 u].
Definition instance : Prop :=
exists (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u <> 0.
End planes_edge_in.

Module planes_edge_tangent.
(* torses/planes.edge.tangent, Edge of regression
   printed: Its tangents are the rulings: n · e' = 0, n' · e' = 0.
   stated: [dot(n(u), edge'(u)), dot(n'(u), edge'(u))] == 0 *)
Definition statement : Prop :=
forall (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u <> 0 ->
  locally u (fun u_ => W n u_ <> 0) ->
  [dot (n u) (vDerive 3 (fun u => edge d n u) 1 u); dot (vDerive 3 (fun x => n x) 1 u) (vDerive 3 (fun u => edge d n u) 1 u)] = zeros 2.
Definition instance : Prop :=
exists (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u <> 0 /\
  locally u (fun u_ => W n u_ <> 0).
End planes_edge_tangent.

Module planes_edge_osculating.
(* torses/planes.edge.osculating, Edge of regression
   printed: Its osculating planes are the planes: n · e'' = 0.
   stated: dot(n(u), edge''(u)) == 0 *)
Definition statement : Prop :=
forall (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u <> 0 ->
  locally u (fun u_ => W n u_ <> 0) ->
  dot (n u) (vDerive 3 (fun u => edge d n u) 2 u) = 0.
Definition instance : Prop :=
exists (d : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth d /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u <> 0 /\
  locally u (fun u_ => W n u_ <> 0).
End planes_edge_osculating.
