(* Statements of torses, Part Normal. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
End Definitions.
Import Definitions.

Module ruled_normal.
(* torses/ruled.normal, Normal
   printed: N = c' × r + v r' × r
   stated: N(u, v) == cross(c'(u), r(u)) + v*cross(r'(u), r(u)) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  N_ c'_u_ c_u_ r'_u_ r_u_ u v = vadd (cross c'_u_ r_u_) (vscale v (cross r'_u_ r_u_)).
End ruled_normal.

Module ruled_turn.
(* torses/ruled.turn, Normal
   printed: The normal turns along a ruling by δ: N(u, v_1) × N(u, v_2) = (v_1 - v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 - v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = vscale ((v1 - v2) * delta c'_u_ r'_u_ r_u_) r_u_.
End ruled_turn.

Module ruled_turn_slip.
(* torses/ruled.turn.slip, Normal
   printed: A slip: N(u, v_1) × N(u, v_2) = (v_1 + v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 + v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = vscale ((v1 + v2) * delta c'_u_ r'_u_ r_u_) r_u_.
End ruled_turn_slip.

Module ruled_turn_slip_corrected.
(* torses/ruled.turn.slip (corrected), Normal
   printed: A slip: N(u, v_1) × N(u, v_2) = (v_1 + v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 - v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = vscale ((v1 - v2) * delta c'_u_ r'_u_ r_u_) r_u_.
End ruled_turn_slip_corrected.

Module ruled_chasles.
(* torses/ruled.chasles, Normal
   printed: |N(u, v_1) × N(u, v_2)|² = (v_1 - v_2)² δ² |r|²
   stated: dot(cross(N(u, v1), N(u, v2)), cross(N(u, v1), N(u, v2))) == (v1 - v2)^2*delta(u)^2*dot(r(u), r(u)) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2)) (cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2)) = (v1 - v2) ^ 2 * delta c'_u_ r'_u_ r_u_ ^ 2 * dot r_u_ r_u_.
End ruled_chasles.
