(* Statements of torses, Part Distribution. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition p (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) : R :=
  dot r_u_ r_u_ * delta c'_u_ r'_u_ r_u_ / dot (cross r'_u_ r_u_) (cross r'_u_ r_u_).
End Definitions.
Import Definitions.

Module striction_parameter.
(* torses/striction.parameter, Distribution
   printed: The parameter of distribution p = |r|² δ/|r' × r|² does not depend on the length of r.
   stated: a(u)^2*dot(r(u), r(u))*det([c'(u), a(u)*r(u), D(a(u)*r(u), u)])/dot(cross(D(a(u)*r(u), u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u))) == p(u) *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  a_u_ <> 0 ->
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) <> 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  a_u_ ^ 2 * dot r_u_ r_u_ * det [c'_u_; vscale a_u_ r_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0] / dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) = p c'_u_ r'_u_ r_u_ u.
Definition instance : Prop :=
exists (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  a_u_ <> 0 /\
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) <> 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End striction_parameter.

Module striction_curvature.
(* torses/striction.curvature, Distribution
   printed: At the central point, for |r| = 1, |N|² = p² |r' × r|².
   stated: at(dot(N(u, v), N(u, v)), v, s(u)) == p(u)^2*dot(cross(r'(u), r(u)), cross(r'(u), r(u))) *)
Definition s (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  - dot (cross c'_u_ r_u_) (cross r'_u_ r_u_) / dot (cross r'_u_ r_u_) (cross r'_u_ r_u_).
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot r_u_ r_u_ = 1 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  (let v := s c'_u_ r'_u_ r_u_ in dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v)) = p c'_u_ r'_u_ r_u_ u ^ 2 * dot (cross r'_u_ r_u_) (cross r'_u_ r_u_).
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot r_u_ r_u_ = 1 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End striction_curvature.
