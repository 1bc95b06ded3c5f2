(* Statements of torses, Part Polar. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module polar_first.
(* torses/polar.first, Polar developable
   printed: The normal planes c' · (p - c) = 0: the derivative by u is c'' · (p - c) - c' · c'.
   stated: D(dot(c'(u), p - c(u)), u) == dot(c''(u), p - c(u)) - dot(c'(u), c'(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  Derive_n (fun u => dot (vDerive 3 (fun x => c x) 1 u) (vsub p (c u))) 1 u = dot (vDerive 3 (fun x => c x) 2 u) (vsub p (c u)) - dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 1 u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End polar_first.

Module polar_second.
(* torses/polar.second, Polar developable
   printed: The edge of regression, the centres of the osculating spheres: the second derivative is c''' · (p - c) - 3 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 3*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  Derive_n (fun u => dot (vDerive 3 (fun x => c x) 1 u) (vsub p (c u))) 2 u = dot (vDerive 3 (fun x => c x) 3 u) (vsub p (c u)) - 3 * dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End polar_second.

Module polar_second_slip.
(* torses/polar.second.slip, Polar developable
   printed: A slip: the second derivative is c''' · (p - c) - 2 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 2*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  Derive_n (fun u => dot (vDerive 3 (fun x => c x) 1 u) (vsub p (c u))) 2 u = dot (vDerive 3 (fun x => c x) 3 u) (vsub p (c u)) - 2 * dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u).
End polar_second_slip.

Module polar_second_slip_corrected.
(* torses/polar.second.slip (corrected), Polar developable
   printed: A slip: the second derivative is c''' · (p - c) - 2 c' · c''.
   stated: D(dot(c'(u), p - c(u)), u, 2) == dot(c'''(u), p - c(u)) - 3*dot(c'(u), c''(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  Derive_n (fun u => dot (vDerive 3 (fun x => c x) 1 u) (vsub p (c u))) 2 u = dot (vDerive 3 (fun x => c x) 3 u) (vsub p (c u)) - 3 * dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (p'1 p'2 p'3 : R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let p := [p'1; p'2; p'3] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End polar_second_slip_corrected.
