(* Statements of bezier, Part Bounds. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module reach_surd.
(* bezier/reach.surd, Bounds
   printed: If a <= √2, then √2 a <= 2.
   stated: sqrt(2)*a <= 2 *)
Definition statement : Prop :=
forall (a : R),
  a <= sqrt 2 ->
  sqrt 2 * a <= 2.
Definition instance : Prop :=
exists (a : R),
  a <= sqrt 2.
End reach_surd.

Module reach_simplex.
(* bezier/reach.simplex, Bounds
   printed: u A + v B + (1 - u - v) C >= 0 for u + v <= 1
   stated: u*A + v*B + (1 - u - v)*C >= 0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (u : R) (v : R),
  0 <= A ->
  0 <= B ->
  0 <= C_ ->
  0 <= u <= 1 ->
  0 <= v <= 1 ->
  u + v <= 1 ->
  u * A + v * B + (1 - u - v) * C_ >= 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (u : R) (v : R),
  0 <= A /\
  0 <= B /\
  0 <= C_ /\
  0 <= u <= 1 /\
  0 <= v <= 1 /\
  u + v <= 1.
End reach_simplex.

Module reach_between.
(* bezier/reach.between, Bounds
   printed: (t - y)(y - r) >= 0 for r <= s <= y <= t
   stated: (t - y)*(y - r) >= 0 *)
Definition statement : Prop :=
forall (r : R) (s : R) (t : R) (y : R),
  r <= s ->
  s <= y ->
  y <= t ->
  (t - y) * (y - r) >= 0.
Definition instance : Prop :=
exists (r : R) (s : R) (t : R) (y : R),
  r <= s /\
  s <= y /\
  y <= t.
End reach_between.

Module reach_interval.
(* bezier/reach.interval, Bounds
   printed: (s - y)(y - r) >= 0 for y in [r, s]
   stated: (s - y)*(y - r) >= 0 *)
Definition statement : Prop :=
forall (r : R) (s : R) (y : R),
  r <= y ->
  y <= s ->
  (s - y) * (y - r) >= 0.
Definition instance : Prop :=
exists (r : R) (s : R) (y : R),
  r <= y /\
  y <= s.
End reach_interval.

Module reach_interval_basis.
(* bezier/reach.interval.basis, Bounds
   printed: For y in [r, s], r < s, the middle quadratic Bernstein polynomial lies between 0 and 1/2.
   stated: 0 <= 2*(s - y)*(y - r)/(s - r)^2 <= 1/2 *)
Definition statement : Prop :=
forall (r : R) (s : R) (y : R),
  r < s ->
  r <= y ->
  y <= s ->
  (s - r) ^ 2 <> 0 ->
  0 <= 2 * (s - y) * (y - r) / (s - r) ^ 2 /\ 2 * (s - y) * (y - r) / (s - r) ^ 2 <= 1 / 2.
Definition instance : Prop :=
exists (r : R) (s : R) (y : R),
  r < s /\
  r <= y /\
  y <= s /\
  (s - r) ^ 2 <> 0.
End reach_interval_basis.
