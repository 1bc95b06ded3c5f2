(* Statements of torses, Part Normal. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
End Definitions.
Import Definitions.

Module ruled_normal.
(* torses/ruled.normal, Normal
   printed: N = c' × r + v r' × r
   stated: N(u, v) == cross(c'(u), r(u)) + v*cross(r'(u), r(u)) *)
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
  N_ c r u v = vadd (cross (vDerive 3 (fun x => c x) 1 u) (r u)) (vscale v (cross (vDerive 3 (fun x => r x) 1 u) (r u))).
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
End ruled_normal.

Module ruled_turn.
(* torses/ruled.turn, Normal
   printed: The normal turns along a ruling by δ: N(u, v_1) × N(u, v_2) = (v_1 - v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 - v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  cross (N_ c r u v1) (N_ c r u v2) = vscale ((v1 - v2) * delta c r u) (r u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_turn.

Module ruled_turn_slip.
(* torses/ruled.turn.slip, Normal
   printed: A slip: N(u, v_1) × N(u, v_2) = (v_1 + v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 + v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  cross (N_ c r u v1) (N_ c r u v2) = vscale ((v1 + v2) * delta c r u) (r u).
End ruled_turn_slip.

Module ruled_turn_slip_corrected.
(* torses/ruled.turn.slip (corrected), Normal
   printed: A slip: N(u, v_1) × N(u, v_2) = (v_1 + v_2) δ r
   stated: cross(N(u, v1), N(u, v2)) == (v1 - v2)*delta(u)*r(u) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  cross (N_ c r u v1) (N_ c r u v2) = vscale ((v1 - v2) * delta c r u) (r u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_turn_slip_corrected.

Module ruled_chasles.
(* torses/ruled.chasles, Normal
   printed: |N(u, v_1) × N(u, v_2)|² = (v_1 - v_2)² δ² |r|²
   stated: dot(cross(N(u, v1), N(u, v2)), cross(N(u, v1), N(u, v2))) == (v1 - v2)^2*delta(u)^2*dot(r(u), r(u)) *)
Definition statement : Prop :=
forall (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 ->
  smooth c'2 ->
  smooth c'3 ->
  smooth r'1 ->
  smooth r'2 ->
  smooth r'3 ->
  dot (cross (N_ c r u v1) (N_ c r u v2)) (cross (N_ c r u v1) (N_ c r u v2)) = (v1 - v2) ^ 2 * delta c r u ^ 2 * dot (r u) (r u).
Definition instance : Prop :=
exists (c'1 c'2 c'3 : R -> R) (r'1 r'2 r'3 : R -> R) (u : R) (v1 : R) (v2 : R),
  let c := fun t => [c'1 t; c'2 t; c'3 t] in
  let r := fun t => [r'1 t; r'2 t; r'3 t] in
  smooth c'1 /\
  smooth c'2 /\
  smooth c'3 /\
  smooth r'1 /\
  smooth r'2 /\
  smooth r'3.
End ruled_chasles.
