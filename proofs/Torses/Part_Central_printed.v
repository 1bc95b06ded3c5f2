(* Statements of torses, Part Central. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition s (c : R -> list R) (r : R -> list R) (u : R) : R :=
  - dot (cross (vDerive 3 (fun x => c x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) / dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)).
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition s1 (c : R -> list R) (r : R -> list R) (u : R) : R :=
  - dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => r x) 1 u) / dot (vDerive 3 (fun x => r x) 1 u) (vDerive 3 (fun x => r x) 1 u).
Definition S1 (c : R -> list R) (r : R -> list R) (u : R) : list R :=
  vadd (c u) (vscale (s1 c r u) (r u)).
End Definitions.
Import Definitions.

Module striction_shortest.
(* torses/striction.shortest, Central point
   printed: N · N has the derivative zero by v at v = s(u).
   stated: at(D(dot(N(u, v), N(u, v)), v), v, s(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  (fun v : R => Derive_n (fun v => dot (N_ c r u v) (N_ c r u v)) 1 v) (s c r u) = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End striction_shortest.

Module striction_growth.
(* torses/striction.growth, Central point
   printed: N · N is smallest there: its second derivative by v is not negative.
   stated: D(dot(N(u, v), N(u, v)), v, 2) >= 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  Derive_n (fun v => dot (N_ c r u v) (N_ c r u v)) 2 v >= 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End striction_growth.

Module striction_length.
(* torses/striction.length, Central point
   printed: At the central point |N|² |r' × r|² = δ² |r|².
   stated: at(dot(N(u, v), N(u, v)), v, s(u))*dot(cross(r'(u), r(u)), cross(r'(u), r(u))) == delta(u)^2*dot(r(u), r(u)) *)
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  (fun v : R => dot (N_ c r u v) (N_ c r u v)) (s c r u) * dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) = delta c r u ^ 2 * dot (r u) (r u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End striction_length.

Module striction_scaled.
(* torses/striction.scaled, Central point
   printed: With directions a r instead of r the central points are the same.
   stated: -dot(cross(c'(u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u)))/dot(cross(D(a(u)*r(u), u), a(u)*r(u)), cross(D(a(u)*r(u), u), a(u)*r(u)))*a(u) == s(u) *)
Definition statement : Prop :=
forall (a : R -> R) (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth a ->
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 ->
  a u <> 0 ->
  dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) <> 0 ->
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0 ->
  - dot (cross (vDerive 3 (fun x => c x) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) / dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) * a u = s c r u.
Definition instance : Prop :=
exists (a : R -> R) (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth a /\
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) > 0 /\
  a u <> 0 /\
  dot (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) (cross (vDerive 3 (fun u => vscale (a u) (r u)) 1 u) (vscale (a u) (r u))) <> 0 /\
  dot (cross (vDerive 3 (fun x => r x) 1 u) (r u)) (cross (vDerive 3 (fun x => r x) 1 u) (r u)) <> 0.
End striction_scaled.

Module striction_unit.
(* torses/striction.unit, Central point
   printed: For |r| = 1 the curve of striction S_1 is at right angles to r': S_1' · r' = 0.
   stated: dot(S1'(u), r'(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (r u) (vDerive 3 (fun x => r x) 1 u) = 0 ->
  dot (vDerive 3 (fun x => r x) 1 u) (vDerive 3 (fun x => r x) 1 u) > 0 ->
  locally u (fun u_ => dot (vDerive 3 (fun x => r x) 1 u_) (vDerive 3 (fun x => r x) 1 u_) <> 0) ->
  dot (vDerive 3 (fun u => S1 c r u) 1 u) (vDerive 3 (fun x => r x) 1 u) = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  dot (r u) (vDerive 3 (fun x => r x) 1 u) = 0 /\
  dot (vDerive 3 (fun x => r x) 1 u) (vDerive 3 (fun x => r x) 1 u) > 0 /\
  locally u (fun u_ => dot (vDerive 3 (fun x => r x) 1 u_) (vDerive 3 (fun x => r x) 1 u_) <> 0).
End striction_unit.

Module striction_unit_slip.
(* torses/striction.unit.slip, Central point
   printed: A slip: S_1' · r' = 0 for rulings of any length.
   stated: dot(S1'(u), r'(u)) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  locally u (fun u_ => dot (vDerive 3 (fun x => r x) 1 u_) (vDerive 3 (fun x => r x) 1 u_) <> 0) ->
  dot (vDerive 3 (fun u => S1 c r u) 1 u) (vDerive 3 (fun x => r x) 1 u) = 0.
End striction_unit_slip.
