(* Statements of torses, Part Torses. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
End Definitions.
Import Definitions.

Module ruled_torse_sufficient.
(* torses/ruled.torse.sufficient, Torses
   printed: If δ = 0, the normal has one direction along the ruling: N(u, v_1) × N(u, v_2) = 0.
   stated: cross(N(u, v1), N(u, v2)) == 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 ->
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = zeros 3.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0.
End ruled_torse_sufficient.

Module ruled_torse_necessary.
(* torses/ruled.torse.necessary, Torses
   printed: If the normals at the points v_1 and v_2 of a ruling are parallel, (v_1 - v_2) δ |r|² = 0: so δ = 0, if the points differ.
   stated: (v1 - v2)*delta(u)*dot(r(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = zeros 3 ->
  (v1 - v2) * delta c'_u_ r'_u_ r_u_ * dot r_u_ r_u_ = 0.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v1 : R) (v2 : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (N_ c'_u_ c_u_ r'_u_ r_u_ u v1) (N_ c'_u_ c_u_ r'_u_ r_u_ u v2) = zeros 3.
End ruled_torse_necessary.

Module ruled_rodrigues.
(* torses/ruled.rodrigues, Torses
   printed: The rulings are curvature lines of torses: N_v × N = δ(u) r, zero if δ = 0.
   stated: cross(D(N, v)(u, v), N(u, v)) == delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  cross (vDerive 3 (fun v_ => N_ c'_u_ c_u_ r'_u_ r_u_ u (v + v_)) 1 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) = vscale (delta c'_u_ r'_u_ r_u_) r_u_.
End ruled_rodrigues.
