(* Statements of torses, Part Edge. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition delta (c'_u_ : list R) (r'_u_ : list R) (r_u_ : list R) : R :=
  det [c'_u_; r_u_; r'_u_].
Definition s (c''_u_ : list R) (c'_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) : R :=
  - dot (cross (vadd c'_u_ (vscale (1 * u) c''_u_)) (vadd r_u_ (vscale (1 * u) r'_u_))) (cross (vadd r'_u_ (vscale (1 * u) r''_u_)) (vadd r_u_ (vscale (1 * u) r'_u_))) / dot (cross (vadd r'_u_ (vscale (1 * u) r''_u_)) (vadd r_u_ (vscale (1 * u) r'_u_))) (cross (vadd r'_u_ (vscale (1 * u) r''_u_)) (vadd r_u_ (vscale (1 * u) r'_u_))).
Definition S_ (c''_u_ : list R) (c'_u_ : list R) (c_u_ : list R) (r''_u_ : list R) (r'_u_ : list R) (r_u_ : list R) (u : R) (u_ : R) : list R :=
  vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (s c''_u_ c'_u_ r''_u_ r'_u_ r_u_ u_) (vadd r_u_ (vscale (1 * u_) r'_u_))).
Definition W (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) : R :=
  det [n_u_; n'_u_; n''_u_].
Definition edge (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (u : R) : list R :=
  vdiv (vadd (vadd (vscale d_u_ (cross n'_u_ n''_u_)) (vscale d'_u_ (cross n''_u_ n_u_))) (vscale d''_u_ (cross n_u_ n'_u_))) (W n''_u_ n'_u_ n_u_).
End Definitions.
Import Definitions.

Module regression_singular.
(* torses/regression.singular, Edge of regression
   printed: On a torse the normal is zero at the central point.
   stated: N(u, s(u)) == 0 *)
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
  delta c'_u_ r'_u_ r_u_ = 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0 ->
  N_ c'_u_ c_u_ r'_u_ r_u_ u (s c'_u_ r'_u_ r_u_) = zeros 3.
Definition instance : Prop :=
exists (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) <> 0.
End regression_singular.

Module regression_tangent.
(* torses/regression.tangent, Edge of regression
   printed: A torse consists of the tangents of its edge of regression: S' × r = 0.
   stated: cross(S'(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 ->
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 ->
  locally 0 (fun u_ => dot (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) <> 0) ->
  cross (vDerive 3 (fun u_ => S_ c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ (u + u_) u_) 1 0) r_u_ = zeros 3.
Definition instance : Prop :=
exists (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  delta c'_u_ r'_u_ r_u_ = 0 /\
  dot (cross r'_u_ r_u_) (cross r'_u_ r_u_) > 0 /\
  locally 0 (fun u_ => dot (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) <> 0).
End regression_tangent.

Module regression_tangent_slip.
(* torses/regression.tangent.slip, Edge of regression
   printed: A slip: S' × r = 0 on every ruled surface.
   stated: cross(S'(u), r(u)) == 0 *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (r''_u_'1 r''_u_'2 r''_u_'3 : R) (r'_u_'1 r'_u_'2 r'_u_'3 : R) (r_u_'1 r_u_'2 r_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let r''_u_ := [r''_u_'1; r''_u_'2; r''_u_'3] in
  let r'_u_ := [r'_u_'1; r'_u_'2; r'_u_'3] in
  let r_u_ := [r_u_'1; r_u_'2; r_u_'3] in
  locally 0 (fun u_ => dot (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) (cross (vadd r'_u_ (vscale (1 * u_) r''_u_)) (vadd r_u_ (vscale (1 * u_) r'_u_))) <> 0) ->
  cross (vDerive 3 (fun u_ => S_ c''_u_ c'_u_ c_u_ r''_u_ r'_u_ r_u_ (u + u_) u_) 1 0) r_u_ = zeros 3.
End regression_tangent_slip.

Module planes_edge.
(* torses/planes.edge, Edge of regression
   printed: The point of three planes: x = (d n' × n'' + d' n'' × n + d'' n × n')/det(n, n', n'')
   stated: x == edge(u) *)
Definition statement : Prop :=
forall (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  let x := [x'1; x'2; x'3] in
  W n''_u_ n'_u_ n_u_ <> 0 ->
  dot n_u_ x = d_u_ ->
  dot n'_u_ x = d'_u_ ->
  dot n''_u_ x = d''_u_ ->
  x = edge d''_u_ d'_u_ d_u_ n''_u_ n'_u_ n_u_ u.
Definition instance : Prop :=
exists (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  let x := [x'1; x'2; x'3] in
  W n''_u_ n'_u_ n_u_ <> 0 /\
  dot n_u_ x = d_u_ /\
  dot n'_u_ x = d'_u_ /\
  dot n''_u_ x = d''_u_.
End planes_edge.

Module planes_edge_in.
(* torses/planes.edge.in, Edge of regression
   printed: The point is in the plane and on the ruling: n · e = d, n' · e = d'.
   stated: [dot(n(u), edge(u)), dot(n'(u), edge(u))] == [d(u), d'(u)] *)
Definition statement : Prop :=
forall (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0 ->
  [dot n_u_ (edge d''_u_ d'_u_ d_u_ n''_u_ n'_u_ n_u_ u); dot n'_u_ (edge d''_u_ d'_u_ d_u_ n''_u_ n'_u_ n_u_ u)] = [d_u_; d'_u_].
Definition instance : Prop :=
exists (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0.
End planes_edge_in.

Module planes_edge_tangent.
(* torses/planes.edge.tangent, Edge of regression
   printed: Its tangents are the rulings: n · e' = 0, n' · e' = 0.
   stated: [dot(n(u), edge'(u)), dot(n'(u), edge'(u))] == 0 *)
Definition W_ (n'''_u_ : list R) (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (u : R) : R :=
  det [vadd n_u_ (vscale (1 * u) n'_u_); vadd n'_u_ (vscale (1 * u) n''_u_); vadd n''_u_ (vscale (1 * u) n'''_u_)].
Definition edge (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n'''_u_ : list R) (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (u : R) (u_ : R) : list R :=
  vdiv (vadd (vadd (vscale (d_u_ + 1 * u_ * d'_u_) (cross (vadd n'_u_ (vscale (1 * u_) n''_u_)) (vadd n''_u_ (vscale (1 * u_) n'''_u_)))) (vscale (d'_u_ + 1 * u_ * d''_u_) (cross (vadd n''_u_ (vscale (1 * u_) n'''_u_)) (vadd n_u_ (vscale (1 * u_) n'_u_))))) (vscale (d''_u_ + 1 * u_ * d'''_u_) (cross (vadd n_u_ (vscale (1 * u_) n'_u_)) (vadd n'_u_ (vscale (1 * u_) n''_u_))))) (W_ n'''_u_ n''_u_ n'_u_ n_u_ u_).
Definition statement : Prop :=
forall (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n'''_u_'1 n'''_u_'2 n'''_u_'3 : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n'''_u_ := [n'''_u_'1; n'''_u_'2; n'''_u_'3] in
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0 ->
  locally 0 (fun u_ => W_ n'''_u_ n''_u_ n'_u_ n_u_ u_ <> 0) ->
  [dot n_u_ (vDerive 3 (fun u_ => edge d'''_u_ d''_u_ d'_u_ d_u_ n'''_u_ n''_u_ n'_u_ n_u_ (u + u_) u_) 1 0); dot n'_u_ (vDerive 3 (fun u_ => edge d'''_u_ d''_u_ d'_u_ d_u_ n'''_u_ n''_u_ n'_u_ n_u_ (u + u_) u_) 1 0)] = zeros 2.
Definition instance : Prop :=
exists (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n'''_u_'1 n'''_u_'2 n'''_u_'3 : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n'''_u_ := [n'''_u_'1; n'''_u_'2; n'''_u_'3] in
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0 /\
  locally 0 (fun u_ => W_ n'''_u_ n''_u_ n'_u_ n_u_ u_ <> 0).
End planes_edge_tangent.

Module planes_edge_osculating.
(* torses/planes.edge.osculating, Edge of regression
   printed: Its osculating planes are the planes: n · e'' = 0.
   stated: dot(n(u), edge''(u)) == 0 *)
Definition W_ (n''''_u_ : list R) (n'''_u_ : list R) (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (u : R) : R :=
  det [vadd (vadd n_u_ (vscale (1 * u) n'_u_)) (vscale (1 / 2 * u ^ 2) n''_u_); vadd (vadd n'_u_ (vscale (1 * u) n''_u_)) (vscale (1 / 2 * u ^ 2) n'''_u_); vadd (vadd n''_u_ (vscale (1 * u) n'''_u_)) (vscale (1 / 2 * u ^ 2) n''''_u_)].
Definition edge (d''''_u_ : R) (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''''_u_ : list R) (n'''_u_ : list R) (n''_u_ : list R) (n'_u_ : list R) (n_u_ : list R) (u : R) (u_ : R) : list R :=
  vdiv (vadd (vadd (vscale (d_u_ + 1 * u_ * d'_u_ + 1 / 2 * u_ ^ 2 * d''_u_) (cross (vadd (vadd n'_u_ (vscale (1 * u_) n''_u_)) (vscale (1 / 2 * u_ ^ 2) n'''_u_)) (vadd (vadd n''_u_ (vscale (1 * u_) n'''_u_)) (vscale (1 / 2 * u_ ^ 2) n''''_u_)))) (vscale (d'_u_ + 1 * u_ * d''_u_ + 1 / 2 * u_ ^ 2 * d'''_u_) (cross (vadd (vadd n''_u_ (vscale (1 * u_) n'''_u_)) (vscale (1 / 2 * u_ ^ 2) n''''_u_)) (vadd (vadd n_u_ (vscale (1 * u_) n'_u_)) (vscale (1 / 2 * u_ ^ 2) n''_u_))))) (vscale (d''_u_ + 1 * u_ * d'''_u_ + 1 / 2 * u_ ^ 2 * d''''_u_) (cross (vadd (vadd n_u_ (vscale (1 * u_) n'_u_)) (vscale (1 / 2 * u_ ^ 2) n''_u_)) (vadd (vadd n'_u_ (vscale (1 * u_) n''_u_)) (vscale (1 / 2 * u_ ^ 2) n'''_u_))))) (W_ n''''_u_ n'''_u_ n''_u_ n'_u_ n_u_ u_).
Definition statement : Prop :=
forall (d''''_u_ : R) (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''''_u_'1 n''''_u_'2 n''''_u_'3 : R) (n'''_u_'1 n'''_u_'2 n'''_u_'3 : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''''_u_ := [n''''_u_'1; n''''_u_'2; n''''_u_'3] in
  let n'''_u_ := [n'''_u_'1; n'''_u_'2; n'''_u_'3] in
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0 ->
  locally 0 (fun u_ => W_ n''''_u_ n'''_u_ n''_u_ n'_u_ n_u_ u_ <> 0) ->
  dot n_u_ (vDerive 3 (fun u_ => edge d''''_u_ d'''_u_ d''_u_ d'_u_ d_u_ n''''_u_ n'''_u_ n''_u_ n'_u_ n_u_ (u + u_) u_) 2 0) = 0.
Definition instance : Prop :=
exists (d''''_u_ : R) (d'''_u_ : R) (d''_u_ : R) (d'_u_ : R) (d_u_ : R) (n''''_u_'1 n''''_u_'2 n''''_u_'3 : R) (n'''_u_'1 n'''_u_'2 n'''_u_'3 : R) (n''_u_'1 n''_u_'2 n''_u_'3 : R) (n'_u_'1 n'_u_'2 n'_u_'3 : R) (n_u_'1 n_u_'2 n_u_'3 : R) (u : R),
  let n''''_u_ := [n''''_u_'1; n''''_u_'2; n''''_u_'3] in
  let n'''_u_ := [n'''_u_'1; n'''_u_'2; n'''_u_'3] in
  let n''_u_ := [n''_u_'1; n''_u_'2; n''_u_'3] in
  let n'_u_ := [n'_u_'1; n'_u_'2; n'_u_'3] in
  let n_u_ := [n_u_'1; n_u_'2; n_u_'3] in
  W n''_u_ n'_u_ n_u_ <> 0 /\
  locally 0 (fun u_ => W_ n''''_u_ n'''_u_ n''_u_ n'_u_ n_u_ u_ <> 0).
End planes_edge_osculating.
