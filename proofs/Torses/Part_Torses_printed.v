(* Statements of torses, Part Torses. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
End Definitions.
Import Definitions.

Module ruled_torse_sufficient.
(* torses/ruled.torse.sufficient, Torses
   printed: If δ = 0, the normal has one direction along the ruling: N(u, v_1) × N(u, v_2) = 0.
   stated: cross(N(u, v1), N(u, v2)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  delta c r u = 0 ->
  cross (N_ c r u v1) (N_ c r u v2) = zeros 3.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  delta c r u = 0.
End ruled_torse_sufficient.

Module ruled_torse_necessary.
(* torses/ruled.torse.necessary, Torses
   printed: If the normals at the points v_1 and v_2 of a ruling are parallel, (v_1 - v_2) δ |r|² = 0: so δ = 0, if the points differ.
   stated: (v1 - v2)*delta(u)*dot(r(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  cross (N_ c r u v1) (N_ c r u v2) = zeros 3 ->
  (v1 - v2) * delta c r u * dot (r u) (r u) = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  cross (N_ c r u v1) (N_ c r u v2) = zeros 3.
End ruled_torse_necessary.

Module ruled_rodrigues.
(* torses/ruled.rodrigues, Torses
   printed: The rulings are curvature lines of torses: N_v × N = δ(u) r, zero if δ = 0.
   stated: cross(D(N, v)(u, v), N(u, v)) == delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  cross (vDerive 3 (fun v => N_ c r u v) 1 v) (N_ c r u v) = vscale (delta c r u) (r u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_rodrigues.
