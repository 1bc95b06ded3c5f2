(* Statements of torses, Part Rulings. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition W (n : R -> list R) (u : R) : R :=
  det [n u; vDerive 3 (fun x => n x) 1 u; vDerive 3 (fun x => n x) 2 u].
End Definitions.
Import Definitions.

Module planes_ruling.
(* torses/planes.ruling, Rulings
   printed: n × n' is the direction of the ruling: it is at right angles to n and n'.
   stated: [dot(n(u), cross(n(u), n'(u))), dot(n'(u), cross(n(u), n'(u)))] == 0 *)
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  [dot (n u) (cross (n u) (vDerive 3 (fun x => n x) 1 u)); dot (vDerive 3 (fun x => n x) 1 u) (cross (n u) (vDerive 3 (fun x => n x) 1 u))] = zeros 2.
Definition instance : Prop :=
exists (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3.
End planes_ruling.

Module planes_turn.
(* torses/planes.turn, Rulings
   printed: (n × n') × (n × n')' = det(n, n', n'') n: the planes are those that the rulings and their changes span.
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n(u) *)
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  cross (cross (n u) (vDerive 3 (fun x => n x) 1 u)) (vDerive 3 (fun u => cross (n u) (vDerive 3 (fun x => n x) 1 u)) 1 u) = vscale (W n u) (n u).
Definition instance : Prop :=
exists (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3.
End planes_turn.

Module planes_turn_slip.
(* torses/planes.turn.slip, Rulings
   printed: A slip: (n × n') × (n × n')' = det(n, n', n'') n'
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n'(u) *)
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  cross (cross (n u) (vDerive 3 (fun x => n x) 1 u)) (vDerive 3 (fun u => cross (n u) (vDerive 3 (fun x => n x) 1 u)) 1 u) = vscale (W n u) (vDerive 3 (fun x => n x) 1 u).
End planes_turn_slip.

Module planes_turn_slip_corrected.
(* torses/planes.turn.slip (corrected), Rulings
   printed: A slip: (n × n') × (n × n')' = det(n, n', n'') n'
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == W(u)*n(u) *)
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  cross (cross (n u) (vDerive 3 (fun x => n x) 1 u)) (vDerive 3 (fun u => cross (n u) (vDerive 3 (fun x => n x) 1 u)) 1 u) = vscale (W n u) (n u).
Definition instance : Prop :=
exists (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3.
End planes_turn_slip_corrected.

Module planes_cylinder.
(* torses/planes.cylinder, Rulings
   printed: If det(n, n', n'') = 0 the rulings are parallel: the envelope is a cylinder.
   stated: cross(cross(n(u), n'(u)), D(cross(n(u), n'(u)), u)) == 0 *)
Definition statement : Prop :=
forall (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  W n u = 0 ->
  cross (cross (n u) (vDerive 3 (fun x => n x) 1 u)) (vDerive 3 (fun u => cross (n u) (vDerive 3 (fun x => n x) 1 u)) 1 u) = zeros 3.
Definition instance : Prop :=
exists (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3 /\
  W n u = 0.
End planes_cylinder.

Module planes_scaled.
(* torses/planes.scaled, Rulings
   printed: With a n for n, which makes the same planes, det(n, n', n'') becomes a^3 det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^3*W(u) *)
Definition statement : Prop :=
forall (a : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth a ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  det [vscale (a u) (n u); vDerive 3 (fun u => vscale (a u) (n u)) 1 u; vDerive 3 (fun u => vscale (a u) (n u)) 2 u] = a u ^ 3 * W n u.
Definition instance : Prop :=
exists (a : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth a /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3.
End planes_scaled.

Module planes_scaled_slip.
(* torses/planes.scaled.slip, Rulings
   printed: A slip: with a n for n, det(n, n', n'') becomes a² det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^2*W(u) *)
Definition statement : Prop :=
forall (a : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth a ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  det [vscale (a u) (n u); vDerive 3 (fun u => vscale (a u) (n u)) 1 u; vDerive 3 (fun u => vscale (a u) (n u)) 2 u] = a u ^ 2 * W n u.
End planes_scaled_slip.

Module planes_scaled_slip_corrected.
(* torses/planes.scaled.slip (corrected), Rulings
   printed: A slip: with a n for n, det(n, n', n'') becomes a² det(n, n', n'').
   stated: det([a(u)*n(u), D(a(u)*n(u), u), D(a(u)*n(u), u, 2)]) == a(u)^3*W(u) *)
Definition statement : Prop :=
forall (a : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth a ->
  smooth n'1 ->
  smooth n'2 ->
  smooth n'3 ->
  det [vscale (a u) (n u); vDerive 3 (fun u => vscale (a u) (n u)) 1 u; vDerive 3 (fun u => vscale (a u) (n u)) 2 u] = a u ^ 3 * W n u.
Definition instance : Prop :=
exists (a : R -> R) (n'1 n'2 n'3 : R -> R) (u : R),
  let n := fun t => [n'1 t; n'2 t; n'3 t] in
  smooth a /\
  smooth n'1 /\
  smooth n'2 /\
  smooth n'3.
End planes_scaled_slip_corrected.

Module planes_dual.
(* torses/planes.dual, Rulings
   printed: Where δ = 0 the surface touches along the ruling the plane at right angles to c' × r: (c' × r) · X_u = 0.
   stated: dot(cross(c'(u), r(u)), D(X)(u, v)) == 0 *)
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
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
  delta c r u = 0 ->
  dot (cross (vDerive 3 (fun x => c x) 1 u) (r u)) (vDerive 3 (fun u => X c r u v) 1 u) = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3 /\
  delta c r u = 0.
End planes_dual.
