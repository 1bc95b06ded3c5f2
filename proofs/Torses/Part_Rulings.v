(* Statements of torses, Part Rulings. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition W (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) : R :=
  det [n_u_; n'_u_; n''_u_].
End Definitions.
Import Definitions.

Module planes_ruling.
(* torses/planes.ruling, Rulings
   printed: n × n' is the direction of the ruling: it is at right angles to n and n'.
   stated: [dot(n(u), cross(n(u), n'(u))), dot(n'(u), cross(n(u), n'(u)))] == 0 *)
Definition statement : Prop :=
forall (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R),
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  [dot n_u_ (cross n_u_ n'_u_); dot n'_u_ (cross n_u_ n'_u_)] = zeros 2.
End planes_ruling.

Module planes_turn.
(* torses/planes.turn, Rulings
   printed: (n × n') × (n × n')' = det(n, n', n'') n: the planes are those that the rulings and their changes span.
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n(u) *)
Definition statement : Prop :=
forall (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  cross (cross n_u_ n'_u_) (vDerive 3 (fun u_ => let u__ := u + u_ in cross (vadd n_u_ (vscale (1 * u_) n'_u_)) (vadd n'_u_ (vscale (1 * u_) n''_u_))) 1 0) = vscale (W n''_u_ n'_u_ n_u_) n_u_.
End planes_turn.

Module planes_turn_slip.
(* torses/planes.turn.slip, Rulings
   printed: A slip: (n × n') × (n × n')' = det(n, n', n'') n'
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n'(u) *)
Definition statement : Prop :=
forall (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  cross (cross n_u_ n'_u_) (vDerive 3 (fun u_ => let u__ := u + u_ in cross (vadd n_u_ (vscale (1 * u_) n'_u_)) (vadd n'_u_ (vscale (1 * u_) n''_u_))) 1 0) = vscale (W n''_u_ n'_u_ n_u_) n'_u_.
End planes_turn_slip.

Module planes_turn_slip_corrected.
(* torses/planes.turn.slip (corrected), Rulings
   printed: A slip: (n × n') × (n × n')' = det(n, n', n'') n'
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n(u) *)
Definition statement : Prop :=
forall (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  cross (cross n_u_ n'_u_) (vDerive 3 (fun u_ => let u__ := u + u_ in cross (vadd n_u_ (vscale (1 * u_) n'_u_)) (vadd n'_u_ (vscale (1 * u_) n''_u_))) 1 0) = vscale (W n''_u_ n'_u_ n_u_) n_u_.
End planes_turn_slip_corrected.

Module planes_cylinder.
(* torses/planes.cylinder, Rulings
   printed: If det(n, n', n'') = 0 the rulings are parallel: the envelope is a cylinder.
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == 0 *)
Definition statement : Prop :=
forall (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ = 0 ->
  cross (cross n_u_ n'_u_) (vDerive 3 (fun u_ => let u__ := u + u_ in cross (vadd n_u_ (vscale (1 * u_) n'_u_)) (vadd n'_u_ (vscale (1 * u_) n''_u_))) 1 0) = zeros 3.
Definition instance : Prop :=
exists (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ = 0.
End planes_cylinder.

Module planes_scaled.
(* torses/planes.scaled, Rulings
   printed: With a n for n, which makes the same planes, det(n, n', n'') becomes a^3 det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^3*W(u) *)
Definition statement : Prop :=
forall (a''_u_ : R) (a'_u_ : R) (a_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  det [vscale a_u_ n_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd n_u_ (vscale (1 * u_) n'_u_))) 1 0; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_ + 1 / 2 * u_ ^ 2 * a''_u_) (vadd (vadd n_u_ (vscale (1 * u_) n'_u_)) (vscale (1 / 2 * u_ ^ 2) n''_u_))) 2 0] = a_u_ ^ 3 * W n''_u_ n'_u_ n_u_.
End planes_scaled.

Module planes_scaled_slip.
(* torses/planes.scaled.slip, Rulings
   printed: A slip: with a n for n, det(n, n', n'') becomes a² det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^2*W(u) *)
Definition statement : Prop :=
forall (a''_u_ : R) (a'_u_ : R) (a_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  det [vscale a_u_ n_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd n_u_ (vscale (1 * u_) n'_u_))) 1 0; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_ + 1 / 2 * u_ ^ 2 * a''_u_) (vadd (vadd n_u_ (vscale (1 * u_) n'_u_)) (vscale (1 / 2 * u_ ^ 2) n''_u_))) 2 0] = a_u_ ^ 2 * W n''_u_ n'_u_ n_u_.
End planes_scaled_slip.

Module planes_scaled_slip_corrected.
(* torses/planes.scaled.slip (corrected), Rulings
   printed: A slip: with a n for n, det(n, n', n'') becomes a² det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^3*W(u) *)
Definition statement : Prop :=
forall (a''_u_ : R) (a'_u_ : R) (a_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  det [vscale a_u_ n_u_; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_) (vadd n_u_ (vscale (1 * u_) n'_u_))) 1 0; vDerive 3 (fun u_ => let u__ := u + u_ in vscale (a_u_ + 1 * u_ * a'_u_ + 1 / 2 * u_ ^ 2 * a''_u_) (vadd (vadd n_u_ (vscale (1 * u_) n'_u_)) (vscale (1 / 2 * u_ ^ 2) n''_u_))) 2 0] = a_u_ ^ 3 * W n''_u_ n'_u_ n_u_.
End planes_scaled_slip_corrected.

Module planes_dual.
(* torses/planes.dual, Rulings
   printed: Where δ = 0 the surface touches along the ruling the plane at right angles to c' × r: (c' × r) · X_u = 0.
   stated: dot(cross(c'(u), r(u)), D(X)(u, v)) == 0 *)
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition X (c'_u_ : list R) (c_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (v : R) (u : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u) c'_u_)) (vscale v (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition statement : Prop :=
forall (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 ->
  dot (cross c'_u_ r_u_) (vDerive 3 (fun u_ => X c'_u_ c_u_ r'_u_ r_u_ v u_) 1 0) = 0.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R) (v : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0.
End planes_dual.
