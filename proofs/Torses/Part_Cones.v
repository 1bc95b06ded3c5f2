(* Statements of torses, Part Cones. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition Y (a'_u_ : R) (a_u_ : R) (p : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd p (vscale (a_u_ + 1 * u * a'_u_) (vadd r_u_ (vscale (1 * u) r'_u_)))) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition Y_ (a_u_ : R) (p : list R) (r_u_ : list R) (v : R) : list R :=
  vadd (vadd p (vscale a_u_ r_u_)) (vscale v r_u_).
End Definitions.
Import Definitions.

Module cone_torse.
(* torses/cone.torse, Cones
   printed: With the apex p on all rulings, and p + a r for the directrix, the surface is a torse.
   stated: det([D(p + a(u)*r(u), u), r(u), r'(u)]) == 0 *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (p'1 p'2 p'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let p := [p'1; p'2; p'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  det [vDerive 3 (fun u_ => let u__ := u + u_ in vadd p (vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_)))) 1 0; r_u_; r'_u_] = 0.
End cone_torse.

Module cone_apex.
(* torses/cone.apex, Cones
   printed: There the surface is singular: its normal is zero at v = -a(u).
   stated: at(cross(D(Y)(u, v), D(Y, v)(u, v)), v, -a(u)) == 0 *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (p'1 p'2 p'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let p := [p'1; p'2; p'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  (let v := - a_u_ in cross (vDerive 3 (fun u_ => Y a'_u_ a_u_ p r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => Y_ a_u_ p r_u_ (v + v_)) 1 0)) = zeros 3.
End cone_apex.

Module cone_apex_slip.
(* torses/cone.apex.slip, Cones
   printed: A slip: its normal is zero at v = a(u).
   stated: at(cross(D(Y)(u, v), D(Y, v)(u, v)), v, a(u)) == 0 *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (p'1 p'2 p'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let p := [p'1; p'2; p'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  (let v := a_u_ in cross (vDerive 3 (fun u_ => Y a'_u_ a_u_ p r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => Y_ a_u_ p r_u_ (v + v_)) 1 0)) = zeros 3.
End cone_apex_slip.

Module planes_cone.
(* torses/planes.cone, Cones
   printed: Planes through one point x envelop a cone: the edge of regression is this point.
   stated: ex(u) == x *)
Definition W (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) : R :=
  det [n_u_; n'_u_; n''_u_].
Definition dx (n_u_ : list R) (x : list R) : R :=
  dot n_u_ x.
Definition dx_ (n'_u_ : list R) (n_u_ : list R) (x : list R) (u : R) : R :=
  dot (vadd n_u_ (vscale (1 * u) n'_u_)) x.
Definition dx__ (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (x : list R) (u : R) : R :=
  dot (vadd (vadd n_u_ (vscale (1 * u) n'_u_)) (vscale (1 / 2 * u ^ 2) n''_u_)) x.
Definition ex (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (x : list R) (u : R) : list R :=
  vdiv (vadd (vadd (vscale (dx n_u_ x) (cross n'_u_ n''_u_)) (vscale (Derive_n (fun u_ => dx_ n'_u_ n_u_ x u_) 1 0) (cross n''_u_ n_u_))) (vscale (Derive_n (fun u_ => dx__ n''_u_ n'_u_ n_u_ x u_) 2 0) (cross n_u_ n'_u_))) (W n''_u_ n'_u_ n_u_).
Definition statement : Prop :=
forall (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  let x := [x'1; x'2; x'3] in
  W n''_u_ n'_u_ n_u_ <> 0 ->
  ex n''_u_ n'_u_ n_u_ x u = x.
Definition instance : Prop :=
exists (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  let x := [x'1; x'2; x'3] in
  W n''_u_ n'_u_ n_u_ <> 0.
End planes_cone.
