(* Statements of bezier, Part Divisors. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module reach_interval_open.
(* bezier/reach.interval.open, Divisors
   printed: (s - y)/(y - r) > 0 for y in (r, s)
   stated: (s - y)/(y - r) > 0 *)
Definition statement : Prop :=
forall (r : R) (s : R) (y : R),
  r < y ->
  y < s ->
  y - r <> 0 ->
  (s - y) / (y - r) > 0.
Definition instance : Prop :=
exists (r : R) (s : R) (y : R),
  r < y /\
  y < s /\
  y - r <> 0.
End reach_interval_open.

Module reach_interval_closed.
(* bezier/reach.interval.closed, Divisors
   printed: (s - y)/(y - r) >= 0 for y in [r, s]
   stated: (s - y)/(y - r) >= 0 *)
Definition statement : Prop :=
forall (r : R) (s : R) (y : R),
  r <= y ->
  y <= s ->
  y - r <> 0 ->
  r - y <> 0 ->
  (s - y) / (y - r) >= 0.
Definition instance : Prop :=
exists (r : R) (s : R) (y : R),
  r <= y /\
  y <= s /\
  y - r <> 0 /\
  r - y <> 0.
End reach_interval_closed.

Module reach_positive.
(* bezier/reach.positive, Divisors
   printed: y/(y² + 1) + 1/(y² + 1) = (y + 1)/(y² + 1)
   stated: y/(y^2 + 1) + 1/(y^2 + 1) == (y + 1)/(y^2 + 1) *)
Definition statement : Prop :=
forall (y : R),
  y ^ 2 + 1 <> 0 ->
  y / (y ^ 2 + 1) + 1 / (y ^ 2 + 1) = (y + 1) / (y ^ 2 + 1).
Definition instance : Prop :=
exists (y : R),
  y ^ 2 + 1 <> 0.
End reach_positive.

Module reach_open.
(* bezier/reach.open, Divisors
   printed: sin² φ/(1 - cos φ) = 1 + cos φ for φ in (0, π)
   stated: sin(phi)^2/(1 - cos(phi)) == 1 + cos(phi) *)
Definition statement : Prop :=
forall (phi : R),
  0 < phi < 1 * PI ->
  1 - cos phi <> 0 ->
  sin phi ^ 2 / (1 - cos phi) = 1 + cos phi.
Definition instance : Prop :=
exists (phi : R),
  0 < phi < 1 * PI /\
  1 - cos phi <> 0.
End reach_open.

Module reach_ordered.
(* bezier/reach.ordered, Divisors
   printed: (t - y)/(t - r) + (y - r)/(t - r) = 1 for r < s < t
   stated: (t - y)/(t - r) + (y - r)/(t - r) == 1 *)
Definition statement : Prop :=
forall (r : R) (s : R) (t : R) (y : R),
  r < s ->
  s < t ->
  t - r <> 0 ->
  (t - y) / (t - r) + (y - r) / (t - r) = 1.
Definition instance : Prop :=
exists (r : R) (s : R) (t : R) (y : R),
  r < s /\
  s < t /\
  t - r <> 0.
End reach_ordered.

Module reach_vector.
(* bezier/reach.vector, Divisors
   printed: The part of q along p ≠ 0 is (p·q)/(p·p) p: the rest is orthogonal to p.
   stated: dot(q - dot(p, q)/dot(p, p)*p, p) == 0 *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  p <> [0; 0; 0] ->
  dot p p <> 0 ->
  dot (vsub q (vscale (dot p q / dot p p) p)) p = 0.
Definition instance : Prop :=
exists (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  p <> [0; 0; 0] /\
  dot p p <> 0.
End reach_vector.
