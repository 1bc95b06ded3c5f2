(* Statements of torses, Part Cylinders. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
End Definitions.
Import Definitions.

Module cylinder_torse.
(* torses/cylinder.torse, Cylinders
   printed: If the rulings are parallel, r × r' = 0, the surface is a torse.
   stated: delta(u) == 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross r_u_ r'_u_ = zeros 3 ->
  delta c'_u_ r'_u_ r_u_ = 0.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross r_u_ r'_u_ = zeros 3.
End cylinder_torse.

Module cylinder_normal.
(* torses/cylinder.normal, Cylinders
   printed: On a cylinder, r' = 0, the normal is the same at all points of a ruling.
   stated: N(u, v1) == N(u, v2) *)
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  r'_u_ = [0; 0; 0] ->
  N_ c'_u_ c_u_ r'_u_ r_u_ u v1 = N_ c'_u_ c_u_ r'_u_ r_u_ u v2.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  r'_u_ = [0; 0; 0].
End cylinder_normal.

Module cylinder_converse_slip.
(* torses/cylinder.converse.slip, Cylinders
   printed: A slip: only cylinders are torses.
   stated: cross(r(u), r'(u)) == 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 ->
  cross r_u_ r'_u_ = zeros 3.
End cylinder_converse_slip.
