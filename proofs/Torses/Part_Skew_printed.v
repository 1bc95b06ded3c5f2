(* Statements of torses, Part Skew. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module binormals_skew.
(* torses/binormals.skew, Skew surfaces
   printed: The binormals c' × c'' form a torse where det(c', c'', c''') = 0.
   stated: det([c'(u), cross(c'(u), c''(u)), D(cross(c'(u), c''(u)), u)]) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u; vDerive 3 (fun x => c x) 3 u] = 0 ->
  det [vDerive 3 (fun x => c x) 1 u; cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u); vDerive 3 (fun u => cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) 1 u] = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u; vDerive 3 (fun x => c x) 3 u] = 0.
End binormals_skew.

Module conoid_skew.
(* torses/conoid.skew, Skew surfaces
   printed: A right conoid with the points [0, 0, a] of its axis and the rulings [cos u, sin u, 0]: the determinant is a'.
   stated: det([D([0, 0, a(u)], u), [cos(u), sin(u), 0], [-sin(u), cos(u), 0]]) == a'(u) *)
Definition statement : Prop :=
forall (a : R -> R) (u : R),
  smooth a ->
  det [vDerive 3 (fun u => [0; 0; a u]) 1 u; [cos u; sin u; 0]; [- sin u; cos u; 0]] = Derive_n (fun x => a x) 1 u.
Definition instance : Prop :=
exists (a : R -> R) (u : R),
  smooth a.
End conoid_skew.
