(* Statements of torses, Part Cylinders. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
End Definitions.
Import Definitions.

Module cylinder_torse.
(* torses/cylinder.torse, Cylinders
   printed: If the rulings are parallel, r × r' = 0, the surface is a torse.
   stated: delta(u) == 0 *)
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
  cross (r u) (vDerive 3 (fun x => r x) 1 u) = zeros 3 ->
  delta c r u = 0.
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
  cross (r u) (vDerive 3 (fun x => r x) 1 u) = zeros 3.
End cylinder_torse.

Module cylinder_normal.
(* torses/cylinder.normal, Cylinders
   printed: On a cylinder, r' = 0, the normal is the same at all points of a ruling.
   stated: N(u, v1) == N(u, v2) *)
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
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
  vDerive 3 (fun x => r x) 1 u = [0; 0; 0] ->
  N_ c r u v1 = N_ c r u v2.
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
  vDerive 3 (fun x => r x) 1 u = [0; 0; 0].
End cylinder_normal.

Module cylinder_converse_slip.
(* torses/cylinder.converse.slip, Cylinders
   printed: A slip: only cylinders are torses.
   stated: cross(r(u), r'(u)) == 0 *)
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
  cross (r u) (vDerive 3 (fun x => r x) 1 u) = zeros 3.
End cylinder_converse_slip.
