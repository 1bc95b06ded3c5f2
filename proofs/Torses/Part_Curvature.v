(* Statements of torses, Part Curvature. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale (1 / 2 * u ^ 2) c''_u_)) (vscale v (vadd (vadd r_u_ (vscale (1 * u) r'_u_)) (vscale (1 / 2 * u ^ 2) r''_u_))).
Definition X_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition X__ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X_ c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X__ c_u_ r_u_ (v + v_)) 1 0).
Definition K (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => X__ c_u_ r_u_ (v + v_)) 2 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition M (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => let v__ := v + v_ in let v___ := v__ in vDerive 3 (fun u_ => X_ c'_u_ c_u_ r'_u_ r_u_ v___ u_) 1 0) 1 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition L (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ v u_) 2 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
End Definitions.
Import Definitions.

Module ruled_asymptotic.
(* torses/ruled.asymptotic, Curvature
   printed: The rulings are asymptotic lines: X_vv · N = 0.
   stated: K(u, v) == 0 *)
Definition X (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X_ c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X c_u_ r_u_ (v + v_)) 1 0).
Definition K (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => X c_u_ r_u_ (v + v_)) 2 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  K c'_u_ c_u_ r'_u_ r_u_ u v = 0.
End ruled_asymptotic.

Module ruled_mixed.
(* torses/ruled.mixed, Curvature
   printed: X_uv · N = δ
   stated: M(u, v) == delta(u) *)
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition M (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => let v__ := v + v_ in let v___ := v__ in vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v___ u_) 1 0) 1 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  M c'_u_ c_u_ r'_u_ r_u_ u v = delta c'_u_ r'_u_ r_u_.
End ruled_mixed.

Module ruled_lagrange.
(* torses/ruled.lagrange, Curvature
   printed: E G - F² = N · N
   stated: E(u, v)*G(u, v) - F(u, v)^2 == dot(N(u, v), N(u, v)) *)
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition E_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition G (c_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition F (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  E_ c'_u_ c_u_ r'_u_ r_u_ u v * G c_u_ r_u_ u v - F c'_u_ c_u_ r'_u_ r_u_ u v ^ 2 = dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
End ruled_lagrange.

Module ruled_gauss.
(* torses/ruled.gauss, Curvature
   printed: The numerator of the Gauss curvature: (X_uu · N)(X_vv · N) - (X_uv · N)² = -δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == -delta(u)^2 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  L c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ u v * K c'_u_ c_u_ r'_u_ r_u_ u v - M c'_u_ c_u_ r'_u_ r_u_ u v ^ 2 = - delta c'_u_ r'_u_ r_u_ ^ 2.
End ruled_gauss.

Module ruled_gauss_curvature.
(* torses/ruled.gauss.curvature, Curvature
   printed: Where N is not zero the Gauss curvature is -δ²/(N · N)².
   stated: (L(u, v)*K(u, v) - M(u, v)^2)/(E(u, v)*G(u, v) - F(u, v)^2)^2 == -delta(u)^2/dot(N(u, v), N(u, v))^2 *)
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition X_ (c_u_ : list R) (r_u_ : list R) (v : R) : list R :=
  vadd c_u_ (vscale v r_u_).
Definition N_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition E_ (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0).
Definition G (c_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition F (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 1 0).
Definition X__ (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale (1 / 2 * u ^ 2) c''_u_)) (vscale v (vadd (vadd r_u_ (vscale (1 * u) r'_u_)) (vscale (1 / 2 * u ^ 2) r''_u_))).
Definition L (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u_ => X__ c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ v u_) 2 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition K (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => X_ c_u_ r_u_ (v + v_)) 2 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition M (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v_ => let v__ := v + v_ in let v___ := v__ in vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v___ u_) 1 0) 1 0) (N_ c'_u_ c_u_ r'_u_ r_u_ u v).
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) > 0 ->
  (E_ c'_u_ c_u_ r'_u_ r_u_ u v * G c_u_ r_u_ u v - F c'_u_ c_u_ r'_u_ r_u_ u v ^ 2) ^ 2 <> 0 ->
  dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) ^ 2 <> 0 ->
  (L c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ u v * K c'_u_ c_u_ r'_u_ r_u_ u v - M c'_u_ c_u_ r'_u_ r_u_ u v ^ 2) / (E_ c'_u_ c_u_ r'_u_ r_u_ u v * G c_u_ r_u_ u v - F c'_u_ c_u_ r'_u_ r_u_ u v ^ 2) ^ 2 = - delta c'_u_ r'_u_ r_u_ ^ 2 / dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) ^ 2.
Definition instance : Prop :=
exists (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) > 0 /\
  (E_ c'_u_ c_u_ r'_u_ r_u_ u v * G c_u_ r_u_ u v - F c'_u_ c_u_ r'_u_ r_u_ u v ^ 2) ^ 2 <> 0 /\
  dot (N_ c'_u_ c_u_ r'_u_ r_u_ u v) (N_ c'_u_ c_u_ r'_u_ r_u_ u v) ^ 2 <> 0.
End ruled_gauss_curvature.

Module ruled_gauss_sign.
(* torses/ruled.gauss.sign, Curvature
   printed: No ruled surface has a point of positive Gauss curvature.
   stated: L(u, v)*K(u, v) - M(u, v)^2 <= 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  L c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ u v * K c'_u_ c_u_ r'_u_ r_u_ u v - M c'_u_ c_u_ r'_u_ r_u_ u v ^ 2 <= 0.
End ruled_gauss_sign.

Module ruled_gauss_slip.
(* torses/ruled.gauss.slip, Curvature
   printed: A slip: (X_uu · N)(X_vv · N) - (X_uv · N)² = δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == delta(u)^2 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  L c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ u v * K c'_u_ c_u_ r'_u_ r_u_ u v - M c'_u_ c_u_ r'_u_ r_u_ u v ^ 2 = delta c'_u_ r'_u_ r_u_ ^ 2.
End ruled_gauss_slip.

Module ruled_gauss_slip_corrected.
(* torses/ruled.gauss.slip (corrected), Curvature
   printed: A slip: (X_uu · N)(X_vv · N) - (X_uv · N)² = δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == -delta(u)^2 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  L c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ u v * K c'_u_ c_u_ r'_u_ r_u_ u v - M c'_u_ c_u_ r'_u_ r_u_ u v ^ 2 = - delta c'_u_ r'_u_ r_u_ ^ 2.
End ruled_gauss_slip_corrected.
