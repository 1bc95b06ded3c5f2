(* Statements of torses, Part Distribution. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition p (c : R -> list R) (r : R -> list R) (u : R) : R :=
  dot (r u) (r u) * delta c r u / dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)).
End Definitions.
Import Definitions.

Module striction_parameter.
(* torses/striction.parameter, Distribution
   printed: The parameter of distribution p = |r|² δ/|r' × r|² does not depend on the length of r.
   stated: a(u)^2*dot(r(u), r(u))*det([c'(u), a(u)*r(u), D(a(u)*r(u), u)])/dot(cross(D(a(u)*r(u), u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u))) == p(u) *)
Definition statement : Prop :=
forall (a : R -> R) (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth a ->
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  a u <> 0 ->
  dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) <> 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  a u ^ 2 * dot (r u) (r u) * det [vDerive 3 (fun x => c x) 1 u; vscale (a u) (r u); vDerive 3 (fun u => vscale (a u) (r u)) 1 u] / dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) = p c r u.
Definition instance : Prop :=
exists (a : R -> R) (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth a /\
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  a u <> 0 /\
  dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) <> 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End striction_parameter.

Module striction_curvature.
(* torses/striction.curvature, Distribution
   printed: At the central point, for |r| = 1, |N|² = p² |r' × r|².
   stated: at(dot(N(u, v), N(u, v)), v, s(u)) == p(u)^2*dot(cross(r'(u), r(u)), cross(r'(u), r(u))) *)
Definition s (c : R -> list R) (r : R -> list R) (u : R) : R :=
  - dot (cross (vDerive 3 (fun x => c x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) / dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)).
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
  dot (r u) (r u) = 1 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  (fun v : R => dot (N_ c r u v) (N_ c r u v)) (s c r u) = p c r u ^ 2 * dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)).
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
  dot (r u) (r u) = 1 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End striction_curvature.
