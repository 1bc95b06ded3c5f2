(* Statements of torses, Part Rectifying. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module rectifying_contains.
(* torses/rectifying.contains, Rectifying developable
   printed: The planes through c at right angles to the principal normals H: their envelope contains the curve, (H · c)' = H' · c.
   stated: D(dot(H(u), c(u)), u) == dot(H'(u), c(u)) *)
Definition H (c'''_u_ : list R) (c''_u_ : list R) (c'_u_ : list R) (u : R) : list R :=
  cross (cross (vadd c'_u_ (vscale (1 * u) c''_u_)) (vadd c''_u_ (vscale (1 * u) c'''_u_))) (vadd c'_u_ (vscale (1 * u) c''_u_)).
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  Derive_n (fun u_ => let u__ := u + u_ in dot (H c'''_u_ c''_u_ c'_u_ u_) (vadd c_u_ (vscale (1 * u_) c'_u_))) 1 0 = dot (vDerive 3 (fun u_ => H c'''_u_ c''_u_ c'_u_ u_) 1 0) c_u_.
End rectifying_contains.

Module rectifying_geodesic.
(* torses/rectifying.geodesic, Rectifying developable
   printed: On it the curve is a geodesic: det(c', c'', H) = 0.
   stated: det([c'(u), c''(u), H(u)]) == 0 *)
Definition H (c''_u_ : list R) (c'_u_ : list R) : list R :=
  cross (cross c'_u_ c''_u_) c'_u_.
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  det [c'_u_; c''_u_; H c''_u_ c'_u_] = 0.
End rectifying_geodesic.
