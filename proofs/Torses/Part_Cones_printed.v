(* Statements of torses, Part Cones. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition Y (a : R -> R) (p : list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (vadd p (vscale (a u) (r u))) (vscale v (r u)).
End Definitions.
Import Definitions.

Module cone_torse.
(* torses/cone.torse, Cones
   printed: With the apex p on all rulings, and p + a r for the directrix, the surface is a torse.
   stated: det([D(p + a(u)*r(u), u), r(u), r'(u)]) == 0 *)
Definition statement : Prop :=
forall (a : R -> R) (r'1 r'2 r'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth a ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  det [vDerive 3 (fun u => vadd p (vscale (a u) (r u))) 1 u; r u; vDerive 3 (fun x => r x) 1 u] = 0.
Definition instance : Prop :=
exists (a : R -> R) (r'1 r'2 r'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth a /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End cone_torse.

Module cone_apex.
(* torses/cone.apex, Cones
   printed: There the surface is singular: its normal is zero at v = -a(u).
   stated: at(cross(D(Y)(u, v), D(Y, v)(u, v)), v, -a(u)) == 0 *)
Definition statement : Prop :=
forall (a : R -> R) (r'1 r'2 r'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth a ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  (fun v : R => cross (vDerive 3 (fun u => Y a p r u v) 1 u) (vDerive 3 (fun v => Y a p r u v) 1 v)) (- a u) = zeros 3.
Definition instance : Prop :=
exists (a : R -> R) (r'1 r'2 r'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth a /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End cone_apex.

Module cone_apex_slip.
(* torses/cone.apex.slip, Cones
   printed: A slip: its normal is zero at v = a(u).
   stated: at(cross(D(Y)(u, v), D(Y, v)(u, v)), v, a(u)) == 0 *)
Definition statement : Prop :=
forall (a : R -> R) (r'1 r'2 r'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth a ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  (fun v : R => cross (vDerive 3 (fun u => Y a p r u v) 1 u) (vDerive 3 (fun v => Y a p r u v) 1 v)) (a u) = zeros 3.
End cone_apex_slip.

Module planes_cone.
(* torses/planes.cone, Cones
   printed: Planes through one point x envelop a cone: the edge of regression is this point.
   stated: ex(u) == x *)
Definition W (n : R -> list R) (u : R) : R :=
  det [n u; vDerive 3 (fun x => n x) 1 u; vDerive 3 (fun x => n x) 2 u].
Definition dx (n : R -> list R) (x : list R) (u : R) : R :=
  dot (n u) x.
Definition ex (n : R -> list R) (x : list R) (u : R) : list R :=
  vdiv (vadd (vadd (vscale (dx n x u) (cross (vDerive 3 (fun x => n x) 1 u) (vDerive 3 (fun x => n x) 2 u))) (vscale (Derive_n (fun u => dx n x u) 1 u) (cross (vDerive 3 (fun x => n x) 2 u) (n u)))) (vscale (Derive_n (fun u => dx n x u) 2 u) (cross (n u) (vDerive 3 (fun x => n x) 1 u)))) (W n u).
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R) (x'1 x'2 x'3 : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  let x := [x'1; x'2; x'3] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u <> 0 ->
  ex n x u = x.
Definition instance : Prop :=
exists (n'1 n'2 n'3 : R -> R) (u : R) (x'1 x'2 x'3 : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  let x := [x'1; x'2; x'3] in
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u <> 0.
End planes_cone.
