(* Statements of torses, Part Contact. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module ruled_touch.
(* torses/ruled.touch, Contact
   printed: Two ruled surfaces with a ruling in common that touch at three of its points touch along all of it: the product of their normals is a polynomial of second degree in v, with the highest coefficient (r' × r) × (q' × q).
   stated: D(cross(N(u, v), cross(D(b(u) + v*q(u), u), q(u))), v, 2) == 2*cross(cross(r'(u), r(u)), cross(q'(u), q(u))) *)
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition statement : Prop :=
forall (b'_u_'1 b'_u_'2 b'_u_'3 : R) (b_u_'1 b_u_'2 b_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (q'_u_'1 q'_u_'2 q'_u_'3 : R) (q_u_'1 q_u_'2 q_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let b'_u_ := [b'_u_'1; b'_u_'2; b'_u_'3] in
  let b_u_ := [b_u_'1; b_u_'2; b_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let q'_u_ := [q'_u_'1; q'_u_'2; q'_u_'3] in
  let q_u_ := [q_u_'1; q_u_'2; q_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  b_u_ = c_u_ ->
  q_u_ = r_u_ ->
  vDerive 3 (fun v_ => let v__ := v + v_ in cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v__) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vadd (vadd b_u_ (vscale (1 * u_) b'_u_)) (vscale v__ (vadd q_u_ (vscale (1 * u_) q'_u_)))) 1 0) q_u_)) 2 0 = vscale 2 (cross (cross r'_u_ r_u_) (cross q'_u_ q_u_)).
Definition instance : Prop :=
exists (b'_u_'1 b'_u_'2 b'_u_'3 : R) (b_u_'1 b_u_'2 b_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (q'_u_'1 q'_u_'2 q'_u_'3 : R) (q_u_'1 q_u_'2 q_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let b'_u_ := [b'_u_'1; b'_u_'2; b'_u_'3] in
  let b_u_ := [b_u_'1; b_u_'2; b_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let q'_u_ := [q'_u_'1; q'_u_'2; q'_u_'3] in
  let q_u_ := [q_u_'1; q_u_'2; q_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  b_u_ = c_u_ /\
  q_u_ = r_u_.
End ruled_touch.
