(* Statements of torses, Part Curvature. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module Definitions.
Definition X (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  vadd (c u) (vscale v (r u)).
Definition N_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition K (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v => X c r u v) 2 v) (N_ c r u v).
Definition M (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v => vDerive 3 (fun u => X c r u v) 1 u) 1 v) (N_ c r u v).
Definition delta (c : R -> list R) (r : R -> list R) (u : R) : R :=
  det [vDerive 3 (fun x => c x) 1 u; r u; vDerive 3 (fun x => r x) 1 u].
Definition E_ (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun u => X c r u v) 1 u).
Definition G (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun v => X c r u v) 1 v) (vDerive 3 (fun v => X c r u v) 1 v).
Definition F (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u => X c r u v) 1 u) (vDerive 3 (fun v => X c r u v) 1 v).
Definition L (c : R -> list R) (r : R -> list R) (u : R) (v : R) : R :=
  dot (vDerive 3 (fun u => X c r u v) 2 u) (N_ c r u v).
End Definitions.
Import Definitions.

Module ruled_asymptotic.
(* torses/ruled.asymptotic, Curvature
   printed: The rulings are asymptotic lines: X_vv · N = 0.
   stated: K(u, v) == 0 *)
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
  K c r u v = 0.
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
End ruled_asymptotic.

Module ruled_mixed.
(* torses/ruled.mixed, Curvature
   printed: X_uv · N = δ
   stated: M(u, v) == delta(u) *)
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
  M c r u v = delta c r u.
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
End ruled_mixed.

Module ruled_lagrange.
(* torses/ruled.lagrange, Curvature
   printed: E G - F² = N · N
   stated: E(u, v)*G(u, v) - F(u, v)^2 == dot(N(u, v), N(u, v)) *)
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
  E_ c r u v * G c r u v - F c r u v ^ 2 = dot (N_ c r u v) (N_ c r u v).
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
End ruled_lagrange.

Module ruled_gauss.
(* torses/ruled.gauss, Curvature
   printed: The numerator of the Gauss curvature: (X_uu · N)(X_vv · N) - (X_uv · N)² = -δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == -delta(u)^2 *)
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
  L c r u v * K c r u v - M c r u v ^ 2 = - delta c r u ^ 2.
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
End ruled_gauss.

Module ruled_gauss_curvature.
(* torses/ruled.gauss.curvature, Curvature
   printed: Where N is not zero the Gauss curvature is -δ²/(N · N)².
   stated: (L(u, v)*K(u, v) - M(u, v)^2)/(E(u, v)*G(u, v) - F(u, v)^2)^2 == -delta(u)^2/dot(N(u, v), N(u, v))^2 *)
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
  dot (N_ c r u v) (N_ c r u v) > 0 ->
  (E_ c r u v * G c r u v - F c r u v ^ 2) ^ 2 <> 0 ->
  dot (N_ c r u v) (N_ c r u v) ^ 2 <> 0 ->
  (L c r u v * K c r u v - M c r u v ^ 2) / (E_ c r u v * G c r u v - F c r u v ^ 2) ^ 2 = - delta c r u ^ 2 / dot (N_ c r u v) (N_ c r u v) ^ 2.
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
  dot (N_ c r u v) (N_ c r u v) > 0 /\
  (E_ c r u v * G c r u v - F c r u v ^ 2) ^ 2 <> 0 /\
  dot (N_ c r u v) (N_ c r u v) ^ 2 <> 0.
End ruled_gauss_curvature.

Module ruled_gauss_sign.
(* torses/ruled.gauss.sign, Curvature
   printed: No ruled surface has a point of positive Gauss curvature.
   stated: L(u, v)*K(u, v) - M(u, v)^2 <= 0 *)
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
  L c r u v * K c r u v - M c r u v ^ 2 <= 0.
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
End ruled_gauss_sign.

Module ruled_gauss_slip.
(* torses/ruled.gauss.slip, Curvature
   printed: A slip: (X_uu · N)(X_vv · N) - (X_uv · N)² = δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == delta(u)^2 *)
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
  L c r u v * K c r u v - M c r u v ^ 2 = delta c r u ^ 2.
End ruled_gauss_slip.

Module ruled_gauss_slip_corrected.
(* torses/ruled.gauss.slip (corrected), Curvature
   printed: A slip: (X_uu · N)(X_vv · N) - (X_uv · N)² = δ²
   stated: L(u, v)*K(u, v) - M(u, v)^2 == -delta(u)^2 *)
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
  L c r u v * K c r u v - M c r u v ^ 2 = - delta c r u ^ 2.
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
End ruled_gauss_slip_corrected.
