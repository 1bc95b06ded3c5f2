(* Statements of torses, Part Freedom. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
End Definitions.
Import Definitions.

Module ruled_directrix.
(* torses/ruled.directrix, Freedom
   printed: δ is the same for every other directrix c + a r on the surface.
   stated: det([D(c(u) + a(u)*r(u), u), r(u), r'(u)]) == delta(u) *)
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
  det [vDerive 3 (fun u => vadd (c u) (vscale (a u) (r u))) 1 u; r u; vDerive 3 (fun x => r x) 1 u] = delta c r u.
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
  smooth r'3.
End ruled_directrix.

Module ruled_scaled.
(* torses/ruled.scaled, Freedom
   printed: With directions a r instead of r, δ becomes a² δ.
   stated: det([c'(u), a(u)*r(u), D(a(u)*r(u), u)]) == a(u)^2*delta(u) *)
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
  det [vDerive 3 (fun x => c x) 1 u; vscale (a u) (r u); vDerive 3 (fun u => vscale (a u) (r u)) 1 u] = a u ^ 2 * delta c r u.
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
  smooth r'3.
End ruled_scaled.

Module ruled_parameter.
(* torses/ruled.parameter, Freedom
   printed: With φ(u) for u, δ becomes φ'² δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)^2*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  det [vDerive 3 (fun u => c (phi u)) 1 u; r (phi u); vDerive 3 (fun u => r (phi u)) 1 u] = Derive_n (fun x => phi x) 1 u ^ 2 * delta c r (phi u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_parameter.

Module ruled_parameter_slip.
(* torses/ruled.parameter.slip, Freedom
   printed: A slip: with φ(u) for u, δ becomes φ' δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  det [vDerive 3 (fun u => c (phi u)) 1 u; r (phi u); vDerive 3 (fun u => r (phi u)) 1 u] = Derive_n (fun x => phi x) 1 u * delta c r (phi u).
End ruled_parameter_slip.

Module ruled_parameter_slip_corrected.
(* torses/ruled.parameter.slip (corrected), Freedom
   printed: A slip: with φ(u) for u, δ becomes φ' δ(φ).
   stated: det([D(c(phi(u)), u), r(phi(u)), D(r(phi(u)), u)]) == phi'(u)^2*delta(phi(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  det [vDerive 3 (fun u => c (phi u)) 1 u; r (phi u); vDerive 3 (fun u => r (phi u)) 1 u] = Derive_n (fun x => phi x) 1 u ^ 2 * delta c r (phi u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (r'1 r'2 r'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_parameter_slip_corrected.

Module ruled_ends.
(* torses/ruled.ends, Freedom
   printed: Between two curves b and c, with the rulings b - c: det(c', b - c, (b - c)') = det(c', b - c, b').
   stated: det([c'(u), b(u) - c(u), D(b(u) - c(u), u)]) == det([c'(u), b(u) - c(u), b'(u)]) *)
Definition statement : Prop :=
forall (b'1 b'2 b'3 : R -> R) (c'1 c'2 c'3 : R -> R) (u : R),
  let b := fun t => [b'1 t; b'2 t; b'3 t] in
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth b'1 ->
  smooth b'2 ->
  smooth b'3 ->
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  det [vDerive 3 (fun x => c x) 1 u; vsub (b u) (c u); vDerive 3 (fun u => vsub (b u) (c u)) 1 u] = det [vDerive 3 (fun x => c x) 1 u; vsub (b u) (c u); vDerive 3 (fun x => b x) 1 u].
Definition instance : Prop :=
exists (b'1 b'2 b'3 : R -> R) (c'1 c'2 c'3 : R -> R) (u : R),
  let b := fun t => [b'1 t; b'2 t; b'3 t] in
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth b'1 /\
  smooth b'2 /\
  smooth b'3 /\
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3.
End ruled_ends.

Module ruled_start.
(* torses/ruled.start, Freedom
   printed: At u = 0 the function c · r has the derivative c'(0) · r(0) + c(0) · r'(0).
   stated: at(D(dot(c(u), r(u)), u), u, 0) == dot(c'(0), r(0)) + dot(c(0), r'(0)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  (fun u : R => Derive_n (fun u => dot (c u) (r u)) 1 u) 0 = dot (vDerive 3 (fun x => c x) 1 0) (r 0) + dot (c 0) (vDerive 3 (fun x => r x) 1 0).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_start.
