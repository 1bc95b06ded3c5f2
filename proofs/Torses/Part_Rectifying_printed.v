(* Statements of torses, Part Rectifying. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition H (c : R -> list R) (u : R) : list R :=
  cross (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) (vDerive 3 (fun x => c x) 1 u).
End Definitions.
Import Definitions.

Module rectifying_contains.
(* torses/rectifying.contains, Rectifying developable
   printed: The planes through c at right angles to the principal normals H: their envelope contains the curve, (H · c)' = H' · c.
   stated: D(dot(H(u), c(u)), u) == dot(H'(u), c(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  Derive_n (fun u => dot (H c u) (c u)) 1 u = dot (vDerive 3 (fun u => H c u) 1 u) (c u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End rectifying_contains.

Module rectifying_geodesic.
(* torses/rectifying.geodesic, Rectifying developable
   printed: On it the curve is a geodesic: det(c', c'', H) = 0.
   stated: det([c'(u), c''(u), H(u)]) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u; H c u] = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End rectifying_geodesic.
