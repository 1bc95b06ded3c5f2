(* Statements of torses, Part Freedom. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition delta (c'_phi_u__ : list R) (r'_phi_u__ : list R) (r_phi_u__ : list R) : R :=
  det [c'_phi_u__; r_phi_u__; r'_phi_u__].
End Definitions.
Import Definitions.

Module ruled_directrix.
(* torses/ruled.directrix, Freedom
   printed: δ is the same for every other directrix c + a r on the surface.
   stated: det([D(c(u) + a(u)*r(u), u), r(u), r'(u)]) == delta(u) *)
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  det [vDerive 3 (fun u_ => let u__ := u + u_ in vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_)))) 1 0; r_u_; r'_u_] = delta c'_u_ r'_u_ r_u_.
End ruled_directrix.

Module ruled_scaled.
(* torses/ruled.scaled, Freedom
   printed: With directions a r instead of r, δ becomes a² δ.
   stated: det([c'(u), a(u)*r(u), D(a(u)*r(u), u)]) == a(u)^2*delta(u) *)
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  det [c'_u_; vscale a_u_ r_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd r_u_ (vscale (1 * u_) r'_u_))) 1 0] = a_u_ ^ 2 * delta c'_u_ r'_u_ r_u_.
End ruled_scaled.

Module ruled_parameter.
(* torses/ruled.parameter, Freedom
   printed: With φ(u) for u, δ becomes φ'² δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)^2*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi'_u_ : R) (phi_u_ : R) (r'_phi_u__'1 r'_phi_u__'2 r'_phi_u__'3 : R) (r_phi_u__'1 r_phi_u__'2 r_phi_u__'3 : R) (u : R),
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  let r'_phi_u__ := [r'_phi_u__'1; r'_phi_u__'2; r'_phi_u__'3] in
  let r_phi_u__ := [r_phi_u__'1; r_phi_u__'2; r_phi_u__'3] in
  det [vDerive 3 (fun u_ => let u__ := u + u_ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0; r_phi_u__; vDerive 3 (fun u_ => let u__ := u + u_ in vadd r_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) r'_phi_u__)) 1 0] = phi'_u_ ^ 2 * delta c'_phi_u__ r'_phi_u__ r_phi_u__.
End ruled_parameter.

Module ruled_parameter_slip.
(* torses/ruled.parameter.slip, Freedom
   printed: A slip: with φ(u) for u, δ becomes φ' δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi'_u_ : R) (phi_u_ : R) (r'_phi_u__'1 r'_phi_u__'2 r'_phi_u__'3 : R) (r_phi_u__'1 r_phi_u__'2 r_phi_u__'3 : R) (u : R),
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  let r'_phi_u__ := [r'_phi_u__'1; r'_phi_u__'2; r'_phi_u__'3] in
  let r_phi_u__ := [r_phi_u__'1; r_phi_u__'2; r_phi_u__'3] in
  det [vDerive 3 (fun u_ => let u__ := u + u_ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0; r_phi_u__; vDerive 3 (fun u_ => let u__ := u + u_ in vadd r_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) r'_phi_u__)) 1 0] = phi'_u_ * delta c'_phi_u__ r'_phi_u__ r_phi_u__.
End ruled_parameter_slip.

Module ruled_parameter_slip_corrected.
(* torses/ruled.parameter.slip (corrected), Freedom
   printed: A slip: with φ(u) for u, δ becomes φ' δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)^2*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 : R) (c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 : R) (phi'_u_ : R) (phi_u_ : R) (r'_phi_u__'1 r'_phi_u__'2 r'_phi_u__'3 : R) (r_phi_u__'1 r_phi_u__'2 r_phi_u__'3 : R) (u : R),
  let c'_phi_u__ := [c'_phi_u__'1; c'_phi_u__'2; c'_phi_u__'3] in
  let c_phi_u__ := [c_phi_u__'1; c_phi_u__'2; c_phi_u__'3] in
  let r'_phi_u__ := [r'_phi_u__'1; r'_phi_u__'2; r'_phi_u__'3] in
  let r_phi_u__ := [r_phi_u__'1; r_phi_u__'2; r_phi_u__'3] in
  det [vDerive 3 (fun u_ => let u__ := u + u_ in vadd c_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) c'_phi_u__)) 1 0; r_phi_u__; vDerive 3 (fun u_ => let u__ := u + u_ in vadd r_phi_u__ (vscale (1 * (phi_u_ + 1 * u_ * phi'_u_ - phi_u_)) r'_phi_u__)) 1 0] = phi'_u_ ^ 2 * delta c'_phi_u__ r'_phi_u__ r_phi_u__.
End ruled_parameter_slip_corrected.

Module ruled_ends.
(* torses/ruled.ends, Freedom
   printed: Between two curves b and c, with the rulings b - c: det(c', b - c, (b - c)') = det(c', b - c, b').
   stated: det([c'(u), b(u) - c(u), D(b(u) - c(u), u)]) == det([c'(u), b(u) - c(u), b'(u)]) *)
Definition statement : Prop :=
forall (b'_u_'1 b'_u_'2 b'_u_'3 : R) (b_u_'1 b_u_'2 b_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R),
  let b'_u_ := [b'_u_'1; b'_u_'2; b'_u_'3] in
  let b_u_ := [b_u_'1; b_u_'2; b_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  det [c'_u_; vsub b_u_ c_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vsub (vadd b_u_ (vscale (1 * u_) b'_u_)) (vadd c_u_ (vscale (1 * u_) c'_u_))) 1 0] = det [c'_u_; vsub b_u_ c_u_; b'_u_].
End ruled_ends.

Module ruled_start.
(* torses/ruled.start, Freedom
   printed: At u = 0 the function c · r has the derivative c'(0) · r(0) + c(0) · r'(0).
   stated: at(D(dot(c(u), r(u)), u), u, 0) == dot(c'(0), r(0)) + dot(c(0), r'(0)) *)
Definition statement : Prop :=
forall (c'_0_'1 c'_0_'2 c'_0_'3 : R) (c_0_'1 c_0_'2 c_0_'3 : R) (r'_0_'1 r'_0_'2 r'_0_'3 : R) (r_0_'1 r_0_'2 r_0_'3 : R),
  let c'_0_ := [c'_0_'1; c'_0_'2; c'_0_'3] in
  let c_0_ := [c_0_'1; c_0_'2; c_0_'3] in
  let r'_0_ := [r'_0_'1; r'_0_'2; r'_0_'3] in
  let r_0_ := [r_0_'1; r_0_'2; r_0_'3] in
  (let u := 0%Z in Derive_n (fun u_ => let u__ := IZR u + u_ in dot (vadd c_0_ (vscale (1 * u_) c'_0_)) (vadd r_0_ (vscale (1 * u_) r'_0_))) 1 0) = dot c'_0_ r_0_ + dot c_0_ r'_0_.
End ruled_start.
