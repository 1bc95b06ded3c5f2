(* Statements of torses, Part Polar. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module polar_first.
(* torses/polar.first, Polar developable
   printed: The normal planes c' · (p - c) = 0: the derivative by u is c'' · (p - c) - c' · c'.
   stated: D(dot(c'(u), p - c(u)), u) == dot(c''(u), p - c(u)) - dot(c'(u), c'(u)) *)
Definition statement : Prop :=
forall (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (p'1 p'2 p'3 : R) (u : R),
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let p := [p'1; p'2; p'3] in
  Derive_n (fun u_ => let u__ := u + u_ in dot (vadd c'_u_ (vscale (1 * u_) c''_u_)) (vsub p (vadd c_u_ (vscale (1 * u_) c'_u_)))) 1 0 = dot c''_u_ (vsub p c_u_) - dot c'_u_ c'_u_.
End polar_first.

Module polar_second.
(* torses/polar.second, Polar developable
   printed: The edge of regression, the centres of the osculating spheres: the second derivative is c''' · (p - c) - 3 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 3*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (p'1 p'2 p'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let p := [p'1; p'2; p'3] in
  Derive_n (fun u_ => let u__ := u + u_ in dot (vadd (vadd c'_u_ (vscale (1 * u_) c''_u_)) (vscale (1 / 2 * u_ ^ 2) c'''_u_)) (vsub p (vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (1 / 2 * u_ ^ 2) c''_u_)))) 2 0 = dot c'''_u_ (vsub p c_u_) - 3 * dot c'_u_ c''_u_.
End polar_second.

Module polar_second_slip.
(* torses/polar.second.slip, Polar developable
   printed: A slip: the second derivative is c''' · (p - c) - 2 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 2*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (p'1 p'2 p'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let p := [p'1; p'2; p'3] in
  Derive_n (fun u_ => let u__ := u + u_ in dot (vadd (vadd c'_u_ (vscale (1 * u_) c''_u_)) (vscale (1 / 2 * u_ ^ 2) c'''_u_)) (vsub p (vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (1 / 2 * u_ ^ 2) c''_u_)))) 2 0 = dot c'''_u_ (vsub p c_u_) - 2 * dot c'_u_ c''_u_.
End polar_second_slip.

Module polar_second_slip_corrected.
(* torses/polar.second.slip (corrected), Polar developable
   printed: A slip: the second derivative is c''' · (p - c) - 2 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 3*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (c_u_'1 c_u_'2 c_u_'3 : R) (p'1 p'2 p'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  let c_u_ := [c_u_'1; c_u_'2; c_u_'3] in
  let p := [p'1; p'2; p'3] in
  Derive_n (fun u_ => let u__ := u + u_ in dot (vadd (vadd c'_u_ (vscale (1 * u_) c''_u_)) (vscale (1 / 2 * u_ ^ 2) c'''_u_)) (vsub p (vadd (vadd c_u_ (vscale (1 * u_) c'_u_)) (vscale (1 / 2 * u_ ^ 2) c''_u_)))) 2 0 = dot c'''_u_ (vsub p c_u_) - 3 * dot c'_u_ c''_u_.
End polar_second_slip_corrected.
