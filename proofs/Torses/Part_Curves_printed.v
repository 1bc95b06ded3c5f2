(* Statements of torses, Part Curves. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition C_ (c : R -> list R) (phi : R -> R) (u : R) : list R :=
  c (phi u).
End Definitions.
Import Definitions.

Module curve_chain.
(* torses/curve.chain, Curves
   printed: C'' = c''(φ) φ'² + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u)^2 + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  vDerive 3 (fun u => C_ c phi u) 2 u = vadd (vscale (Derive_n (fun x => phi x) 1 u ^ 2) (vDerive 3 (fun x => c x) 2 (phi u))) (vscale (Derive_n (fun x => phi x) 2 u) (vDerive 3 (fun x => c x) 1 (phi u))).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi.
End curve_chain.

Module curve_chain_slip.
(* torses/curve.chain.slip, Curves
   printed: A slip: C'' = c''(φ) φ' + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u) + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  vDerive 3 (fun u => C_ c phi u) 2 u = vadd (vscale (Derive_n (fun x => phi x) 1 u) (vDerive 3 (fun x => c x) 2 (phi u))) (vscale (Derive_n (fun x => phi x) 2 u) (vDerive 3 (fun x => c x) 1 (phi u))).
End curve_chain_slip.

Module curve_chain_slip_corrected.
(* torses/curve.chain.slip (corrected), Curves
   printed: A slip: C'' = c''(φ) φ' + c'(φ) φ''
   stated: C''(u) == c''(phi(u))*phi'(u)^2 + c'(phi(u))*phi''(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  vDerive 3 (fun u => C_ c phi u) 2 u = vadd (vscale (Derive_n (fun x => phi x) 1 u ^ 2) (vDerive 3 (fun x => c x) 2 (phi u))) (vscale (Derive_n (fun x => phi x) 2 u) (vDerive 3 (fun x => c x) 1 (phi u))).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi.
End curve_chain_slip_corrected.

Module curve_curvature.
(* torses/curve.curvature, Curves
   printed: The square of the curvature, (c' × c'')²/(c' · c')^3, does not depend on the parameter.
   stated: dot(cross(C'(u), C''(u)), cross(C'(u), C''(u)))/dot(C'(u), C'(u))^3 == k2(phi(u)) *)
Definition k2 (c : R -> list R) (u : R) : R :=
  dot (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) / dot (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 1 u) ^ 3.
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  dot (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 1 (phi u)) > 0 ->
  Derive_n (fun x => phi x) 1 u <> 0 ->
  dot (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 1 u) ^ 3 <> 0 ->
  dot (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 1 (phi u)) ^ 3 <> 0 ->
  dot (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) / dot (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 1 u) ^ 3 = k2 c (phi u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi /\
  dot (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 1 (phi u)) > 0 /\
  Derive_n (fun x => phi x) 1 u <> 0 /\
  dot (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 1 u) ^ 3 <> 0 /\
  dot (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 1 (phi u)) ^ 3 <> 0.
End curve_curvature.

Module curve_torsion.
(* torses/curve.torsion, Curves
   printed: Nor does the torsion.
   stated: det([C'(u), C''(u), C'''(u)])/dot(cross(C'(u), C''(u)), cross(C'(u), C''(u))) == tau(phi(u)) *)
Definition tau (c : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u; vDerive 3 (fun x => c x) 3 u] / dot (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)) (cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u)).
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth phi ->
  dot (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) > 0 ->
  Derive_n (fun x => phi x) 1 u <> 0 ->
  dot (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) <> 0 ->
  dot (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) <> 0 ->
  det [vDerive 3 (fun u => C_ c phi u) 1 u; vDerive 3 (fun u => C_ c phi u) 2 u; vDerive 3 (fun u => C_ c phi u) 3 u] / dot (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) = tau c (phi u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (phi : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth phi /\
  dot (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) > 0 /\
  Derive_n (fun x => phi x) 1 u <> 0 /\
  dot (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) (cross (vDerive 3 (fun u => C_ c phi u) 1 u) (vDerive 3 (fun u => C_ c phi u) 2 u)) <> 0 /\
  dot (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) (cross (vDerive 3 (fun x => c x) 1 (phi u)) (vDerive 3 (fun x => c x) 2 (phi u))) <> 0.
End curve_torsion.

Module curve_straight.
(* torses/curve.straight, Curves
   printed: Where the curvature is zero so is det(c', c'', c''').
   stated: det([c'(u), c''(u), c'''(u)]) == 0 *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u) = zeros 3 ->
  det [vDerive 3 (fun x => c x) 1 u; vDerive 3 (fun x => c x) 2 u; vDerive 3 (fun x => c x) 3 u] = 0.
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (u : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  cross (vDerive 3 (fun x => c x) 1 u) (vDerive 3 (fun x => c x) 2 u) = zeros 3.
End curve_straight.
