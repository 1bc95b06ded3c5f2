(* Statements of torses, Part Central. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition s (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  - dot (cross c'_u_ r_u_) (cross r'_u_ r_u_) / dot (cross r'_u_ r_u_) (cross r'_u_ r_u_).
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition s1 (c''_u_ : list R) (c'_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (u : R) : R :=
  - dot (vadd c'_u_ (vscale (1 * u) c''_u_)) (vadd r'_u_ (vscale (1 * u) r''_u_)) / dot (vadd r'_u_ (vscale (1 * u) r''_u_)) (vadd r'_u_ (vscale (1 * u) r''_u_)).
Definition S1 (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (u_ : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (s1 c''_u_ c'_u_ r''_u_ r'_u_ u_) (vadd r_u_ (vscale (1 * u_) r'_u_))).
End Definitions.
Import Definitions.

Module striction_shortest.
(* torses/striction.shortest, Central point
   printed: N · N has the derivative zero by v at v = s(u).
   stated: at(D(dot(N(u, v), N(u, v)), v), v, s(u)) == 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  (let v := s c'_u_ r'_u_ r_u_ in Derive_n (fun v_ => let v__ := v + v_ in dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v__) (N_ c'_u_ c_u_ r'_u_ r_u_ u v__)) 1 0) = 0.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End striction_shortest.

Module striction_growth.
(* torses/striction.growth, Central point
   printed: N · N is smallest there: its second derivative by v is not negative.
   stated: D(dot(N(u, v), N(u, v)), v, 2) >= 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  Derive_n (fun v_ => let v__ := v + v_ in dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v__) (N_ c'_u_ c_u_ r'_u_ r_u_ u v__)) 2 0 >= 0.
End striction_growth.

Module striction_length.
(* torses/striction.length, Central point
   printed: At the central point |N|² |r' × r|² = δ² |r|².
   stated: at(dot(N(u, v), N(u, v)), v, s(u))*dot(cross(r'(u), r(u)), cross(r'(u), r(u))) == delta(u)^2*dot(r(u), r(u)) *)
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  (let v := s c'_u_ r'_u_ r_u_ in dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v)) * dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) = delta c'_u_ r'_u_ r_u_ ^ 2 * dot r_u_ r_u_.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End striction_length.

Module striction_scaled.
(* torses/striction.scaled, Central point
   printed: With directions a r instead of r the central points are the same.
   stated: -dot(cross(c'(u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u)))/dot(cross(D(a(u)*r(u), u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u)))*a(u) == s(u) *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  a_u_ <> 0 ->
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) <> 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  - dot (cross c'_u_ (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) / dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) * a_u_ = s c'_u_ r'_u_ r_u_.
Definition instance : Prop :=
exists (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  a_u_ <> 0 /\
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0) (vscale a_u_ r_u_)) <> 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End striction_scaled.

Module striction_unit.
(* torses/striction.unit, Central point
   printed: For |r| = 1 the curve of striction S_1 is at right angles to r': S_1' · r' = 0.
   stated: dot(S1'(u), r'(u)) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot r_u_ r'_u_ = 0 ->
  dot r'_u_ r'_u_ > 0 ->
  locally 0 (fun u_ => dot (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r'_u_ (vscale (1 * u_) r''_u_)) <> 0) ->
  dot (vDerive 3 (fun u_ => S1 c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ (u + u_) u_) 1 0) r'_u_ = 0.
Definition instance : Prop :=
exists (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot r_u_ r'_u_ = 0 /\
  dot r'_u_ r'_u_ > 0 /\
  locally 0 (fun u_ => dot (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r'_u_ (vscale (1 * u_) r''_u_)) <> 0).
End striction_unit.

Module striction_unit_slip.
(* torses/striction.unit.slip, Central point
   printed: A slip: S_1' · r' = 0 for rulings of any length.
   stated: dot(S1'(u), r'(u)) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  locally 0 (fun u_ => dot (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r'_u_ (vscale (1 * u_) r''_u_)) <> 0) ->
  dot (vDerive 3 (fun u_ => S1 c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ (u + u_) u_) 1 0) r'_u_ = 0.
End striction_unit_slip.
