(* Statements of torses, Part Skew. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module binormals_skew.
(* torses/binormals.skew, Skew surfaces
   printed: The binormals c' × c'' form a torse where det(c', c'', c''') = 0.
   stated: det([c'(u), cross(c'(u), c''(u)), D(cross(c'(u), c''(u)), u)]) == 0 *)
Definition statement : Prop :=
forall (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  det [c'_u_; c''_u_; c'''_u_] = 0 ->
  det [c'_u_; cross c'_u_ c''_u_; vDerive 3 (fun u_ => let u__ := u + u_ in cross (vadd c'_u_ (vscale (1 * u_) c''_u_)) (vadd c''_u_ (vscale (1 * u_) c'''_u_))) 1 0] = 0.
Definition instance : Prop :=
exists (c'''_u_'1 c'''_u_'2 c'''_u_'3 : R) (c''_u_'1 c''_u_'2 c''_u_'3 : R) (c'_u_'1 c'_u_'2 c'_u_'3 : R) (u : R),
  let c'''_u_ := [c'''_u_'1; c'''_u_'2; c'''_u_'3] in
  let c''_u_ := [c''_u_'1; c''_u_'2; c''_u_'3] in
  let c'_u_ := [c'_u_'1; c'_u_'2; c'_u_'3] in
  det [c'_u_; c''_u_; c'''_u_] = 0.
End binormals_skew.

Module conoid_skew.
(* torses/conoid.skew, Skew surfaces
   printed: A right conoid with the points [0, 0, a] of its axis and the rulings [cos u, sin u, 0]: the determinant is a'.
   stated: det([D([0, 0, a(u)], u), [cos(u), sin(u), 0], [-sin(u), cos(u), 0]]) == a'(u) *)
Definition statement : Prop :=
forall (a'_u_ : R) (a_u_ : R) (u : R),
  det [vDerive 3 (fun u_ => let u__ := u + u_ in [0; 0; a_u_ + 1 * u_ * a'_u_]) 1 0; [cos u; sin u; 0]; [- sin u; cos u; 0]] = a'_u_.
End conoid_skew.
