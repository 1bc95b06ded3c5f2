(* Statements of torses, Part Contact. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module ruled_touch.
(* torses/ruled.touch, Contact
   printed: Two ruled surfaces with a ruling in common that touch at three of its points touch along all of it: the product of their normals is a polynomial of second degree in v, with the highest coefficient (r' × r) × (q' × q).
   stated: D(cross(N(u, v), cross(D(b(u) + v*q(u), u), q(u))), v, 2) == 2*cross(cross(r'(u), r(u)), cross(q'(u), q(u))) *)
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition statement : Prop :=
forall (b'1 b'2 b'3 : R -> R) (c'1 c'2 c'3 : R -> R) (q'1 q'2 q'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let b := fun t => [b'1 t; b'2 t; b'3 t] in
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let q := fun t => [q'1 t; q'2 t; q'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth b'1 ->
  smooth b'2 ->
  smooth b'3 ->
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth q'1 ->
  smooth q'2 ->
  smooth q'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  b u = c u ->
  q u = r u ->
  vDerive 3 (fun v => cross (N_ c r u v) (cross (vDerive 3 (fun u => vadd (b u) (vscale v (q u))) 1 u) (q u))) 2 v = vscale 2 (cross (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => q x) 1 u) (q u))).
Definition instance : Prop :=
exists (b'1 b'2 b'3 : R -> R) (c'1 c'2 c'3 : R -> R) (q'1 q'2 q'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let b := fun t => [b'1 t; b'2 t; b'3 t] in
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let q := fun t => [q'1 t; q'2 t; q'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth b'1 /\
  smooth b'2 /\
  smooth b'3 /\
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth q'1 /\
  smooth q'2 /\
  smooth q'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  b u = c u /\
  q u = r u.
End ruled_touch.
