(* Statements of torses, Part Curves. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module curve_chain.
(* torses/curve.chain, Curves
   printed: C'' = c''(φ) φ'² + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u)^2 + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0 = vadd (vscale (phi'_u_ ^ 2) c''_phi_u__) (vscale phi''_u_ c'_phi_u__).
End curve_chain.

Module curve_chain_slip.
(* torses/curve.chain.slip, Curves
   printed: A slip: C'' = c''(φ) φ' + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u) + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0 = vadd (vscale phi'_u_ c''_phi_u__) (vscale phi''_u_ c'_phi_u__).
End curve_chain_slip.

Module curve_chain_slip_corrected.
(* torses/curve.chain.slip (corrected), Curves
   printed: A slip: C'' = c''(φ) φ' + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u)^2 + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0 = vadd (vscale (phi'_u_ ^ 2) c''_phi_u__) (vscale phi''_u_ c'_phi_u__).
End curve_chain_slip_corrected.

Module curve_curvature.
(* torses/curve.curvature, Curves
   printed: The square of the curvature, (c' × c'')²/(c' · c')^3, does not depend on the parameter.
   stated: dot(cross(C'(u), C''(u)), cross(C'(u), C''(u)))/dot(C'(u), C'(u))^3 == k2(phi(u)) *)
Definition k2 (c''_phi_u__ : list R) (c'_phi_u__ : list R) : R :=
  dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__) / dot c'_phi_u__ c'_phi_u__ ^ 3.
Definition statement : Prop :=
forall (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  dot c'_phi_u__ c'_phi_u__ > 0 ->
  phi'_u_ <> 0 ->
  dot (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) ^ 3 <> 0 ->
  dot c'_phi_u__ c'_phi_u__ ^ 3 <> 0 ->
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) / dot (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) ^ 3 = k2 c''_phi_u__ c'_phi_u__.
Definition instance : Prop :=
exists (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  dot c'_phi_u__ c'_phi_u__ > 0 /\
  phi'_u_ <> 0 /\
  dot (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) ^ 3 <> 0 /\
  dot c'_phi_u__ c'_phi_u__ ^ 3 <> 0.
End curve_curvature.

Module curve_torsion.
(* torses/curve.torsion, Curves
   printed: Nor does the torsion.
   stated: det([C'(u), C''(u), C'''(u)])/dot(cross(C'(u), C''(u)), cross(C'(u), C''(u))) == tau(phi(u)) *)
Definition tau (c'''_phi_u__ : list R) (c''_phi_u__ : list R) (c'_phi_u__ : list R) : R :=
  det [c'_phi_u__; c''_phi_u__; c'''_phi_u__] / dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__).
Definition statement : Prop :=
forall (c'''_phi_u__'1 c'''_phi_u__'2 c'''_phi_u__'3 : R) (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi'''_u_ : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c'''_phi_u__ := [c'''_phi_u__'1; c'''_phi_u__'2; c'''_phi_u__'3] in
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__) > 0 ->
  phi'_u_ <> 0 ->
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) <> 0 ->
  dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__) <> 0 ->
  det [vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0; vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0; vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ + 1 / 6 * u_ ^ 3 * phi'''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ + 1 / 6 * u_ ^ 3 * phi'''_u_ - phi_u_) ^ 2) c''_phi_u__)) (vscale (1 / 6 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ + 1 / 6 * u_ ^ 3 * phi'''_u_ - phi_u_) ^ 3) c'''_phi_u__)) 3 0] / dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) = tau c'''_phi_u__ c''_phi_u__ c'_phi_u__.
Definition instance : Prop :=
exists (c'''_phi_u__'1 c'''_phi_u__'2 c'''_phi_u__'3 : R) (c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 : R) (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi'''_u_ : R) (phi''_u_ : R) (phi'_u_ : R) (phi_u_ : R) (u : R),
  let c'''_phi_u__ := [c'''_phi_u__'1; c'''_phi_u__'2; c'''_phi_u__'3] in
  let c''_phi_u__ := [c''_phi_u__'1; c''_phi_u__'2; c''_phi_u__'3] in
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__) > 0 /\
  phi'_u_ <> 0 /\
  dot (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) (cross (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0) (vDerive 3 (fun u_ => let u__ := u + u_ in let u___ := u__ in vadd (vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_)) c'_phi_u__)) (vscale (1 / 2 * (phi_u_ + 1 * u_ * phi'_u_ + 1 / 2 * u_ ^ 2 * phi''_u_ - phi_u_) ^ 2) c''_phi_u__)) 2 0)) <> 0 /\
  dot (cross c'_phi_u__ c''_phi_u__) (cross c'_phi_u__ c''_phi_u__) <> 0.
End curve_torsion.

Module curve_straight.
(* torses/curve.straight, Curves
   printed: Where the curvature is zero so is det(c', c'', c''').
   stated: det([c'(u), c''(u), c'''(u)]) == 0 *)
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  cross c'_u_ c''_u_ = zeros 3 ->
  det [c'_u_; c''_u_; c'''_u_] = 0.
Definition instance : Prop :=
exists (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  cross c'_u_ c''_u_ = zeros 3.
End curve_straight.
