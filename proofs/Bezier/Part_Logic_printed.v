(* Statements of bezier, Part Logic. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module reach_implies.
(* bezier/reach.implies, Logic
   printed: If a² + b² = 0, then a = b = 0.
   stated: a^2 + b^2 == 0 implies a == 0 and b == 0 *)
Definition statement : Prop :=
forall (a : R) (b : R),
  a ^ 2 + b ^ 2 = 0 -> a = 0 /\ b = 0.
End reach_implies.

Module reach_length_zero.
(* bezier/reach.length.zero, Logic
   printed: A vector of length zero is the zero vector.
   stated: dot(p, p) == 0 implies p == [0, 0, 0] *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R),
  let p := [p'1; p'2; p'3] in
  dot p p = 0 -> p = [0; 0; 0].
End reach_length_zero.

Module reach_product_zero.
(* bezier/reach.product.zero, Logic
   printed: a b = 0 if and only if a = 0 or b = 0
   stated: (a*b == 0 implies a == 0 or b == 0) and (a == 0 or b == 0 implies a*b == 0) *)
Definition statement : Prop :=
forall (a : R) (b : R),
  (a * b = 0 -> a = 0 \/ b = 0) /\ (a = 0 \/ b = 0 -> a * b = 0).
End reach_product_zero.

Module reach_roots.
(* bezier/reach.roots, Logic
   printed: y² = 4 only for y = 2 and y = -2
   stated: y^2 == 4 implies y == 2 or y == -2 *)
Definition statement : Prop :=
forall (y : R),
  y ^ 2 = 4 -> y = 2 \/ y = - 2.
End reach_roots.

Module reach_roots_slip.
(* bezier/reach.roots.slip, Logic
   printed: A common slip: y² = 4 only for y = 2
   stated: y^2 == 4 implies y == 2 *)
Definition statement : Prop :=
forall (y : R),
  y ^ 2 = 4 -> y = 2.
End reach_roots_slip.

Module reach_weights_zero.
(* bezier/reach.weights.zero, Logic
   printed: If A + B + C = 0 for weights A, B, C >= 0, then A = B = C = 0.
   stated: A == 0 and B == 0 and C == 0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R),
  0 <= A ->
  0 <= B ->
  0 <= C_ ->
  A + B + C_ = 0 ->
  A = 0 /\ B = 0 /\ C_ = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R),
  0 <= A /\
  0 <= B /\
  0 <= C_ /\
  A + B + C_ = 0.
End reach_weights_zero.

Module reach_circle_bound.
(* bezier/reach.circle.bound, Logic
   printed: On the unit circle a + b is at most √2.
   stated: (a + b)^2 <= 2 *)
Definition statement : Prop :=
forall (a : R) (b : R),
  a ^ 2 + b ^ 2 = 1 ->
  (a + b) ^ 2 <= 2.
Definition instance : Prop :=
exists (a : R) (b : R),
  a ^ 2 + b ^ 2 = 1.
End reach_circle_bound.
