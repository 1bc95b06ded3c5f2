(* Statements of bezier, Part README. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module language_numbers.
(* bezier/language.numbers, README, functions of numbers
   printed: The examples of sum, binom, factorial, sqrt, sin and cos.
   stated: sum(i, 1, 4, i^2) == 30 and binom(m, 2) == m*(m - 1)/2 and factorial(5) == 120 and sqrt(8) == 2*sqrt(2) and sqrt(2)*sqrt(3) == sqrt(6) and sin(pi/6) == 1/2 and sin(pi*x) == 2*sin(pi/2*x)*cos(pi/2*x) *)
Definition statement : Prop :=
forall (m : Z) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  sum 1%Z 4%Z (fun i => IZR i ^ 2) = 30 /\ binom (IZR m) 2%Z = IZR m * (IZR m - 1) / 2 /\ factorial 5%Z = 120 /\ sqrt 8 = 2 * sqrt 2 /\ sqrt 2 * sqrt 3 = sqrt 6 /\ sin (PI / 6) = 1 / 2 /\ sin (PI * x) = 2 * sin (PI / 2 * x) * cos (PI / 2 * x).
Definition instance : Prop :=
exists (m : Z) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1.
End language_numbers.

Module language_calculus.
(* bezier/language.calculus, README, derivatives
   printed: The examples of D, primes and at.
   stated: D(x^3*y, x, 2) == 6*x*y and D(E, y)(x, y) == x^2 and E''(x, y) == 2*y and at(x^2 + y, x, 1/2) == 1/4 + y *)
Definition E_ (x : R) (y : R) : R :=
  x ^ 2 * y.
Definition statement : Prop :=
forall (x : R) (y : R),
  0 <= x <= 1 ->
  Derive_n (fun x => x ^ 3 * y) 2 x = 6 * x * y /\ Derive_n (fun y => E_ x y) 1 y = x ^ 2 /\ Derive_n (fun x => E_ x y) 2 x = 2 * y /\ (fun x : R => x ^ 2 + y) (1 / 2) = 1 / 4 + y.
Definition instance : Prop :=
exists (x : R) (y : R),
  0 <= x <= 1.
End language_calculus.

Module language_vectors.
(* bezier/language.vectors, README, vectors
   printed: The examples of dot, cross, norm and entries.
   stated: dot([1, 2, 3], [4, 5, 6]) == 32 and cross(p, q) == -cross(q, p) and norm([3, 4]) == 5 and norm([1, 1]) == sqrt(2) and [5, 6][1] == 5 and p[1]^2 + p[2]^2 + p[3]^2 == dot(p, p) *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  dot [1; 2; 3] [4; 5; 6] = 32 /\ cross p q = vopp (cross q p) /\ norm [3; 4] = 5 /\ norm [1; 1] = sqrt 2 /\ entry [5; 6] 1 = 5 /\ entry p 1 ^ 2 + entry p 2 ^ 2 + entry p 3 ^ 2 = dot p p.
End language_vectors.

Module language_matrices.
(* bezier/language.matrices, README, matrices
   printed: The examples of det, transpose, inverse, solve, identity and coefficients.
   stated: det([p, q, p + 2*q]) == 0 and transpose([[1, 2], [3, 4]]) == [[1, 3], [2, 4]] and inverse([[1, y], [0, 1]]) == [[1, -y], [0, 1]] and solve([[2, 0], [0, 4]], [2, 2]) == [1, 1/2] and identity(2) == [[1, 0], [0, 1]] and coefficients([3*g - h], [g, h]) == [[3, -1]] *)
Definition statement : Prop :=
forall (g : R) (h : R) (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R) (y : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  det [[1; y]; [0; 1]] <> 0 ->
  det [[2; 0]; [0; 4]] <> 0 ->
  det [p; q; vadd p (vscale 2 q)] = 0 /\ transpose [[1; 2]; [3; 4]] = [[1; 3]; [2; 4]] /\ inverse [[1; y]; [0; 1]] = [[1; - y]; [0; 1]] /\ solve [[2; 0]; [0; 4]] [2; 2] = [1; 1 / 2] /\ identity 2 = [[1; 0]; [0; 1]] /\ [[Derive_n (fun g => 3 * g - h) 1 g; Derive_n (fun h => 3 * g - h) 1 h]] = [[3; - 1]].
Definition instance : Prop :=
exists (g : R) (h : R) (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R) (y : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  det [[1; y]; [0; 1]] <> 0 /\
  det [[2; 0]; [0; 4]] <> 0.
End language_matrices.

Module language_decimals.
(* bezier/language.decimals, README, printed decimals
   printed: The examples of agrees.
   stated: agrees(pi, 3.14) and agrees([1/3, 2/3], [0.33, 0.67]) and agrees(2/3, 0.66) and agrees(2/3, 0.67) *)
Definition statement : Prop :=
  agrees_up PI (157 / 50) 2 /\ (agrees_up (entry [1 / 3; 2 / 3] 1) (33 / 100) 2 /\ agrees_up (entry [1 / 3; 2 / 3] 2) (67 / 100) 2) /\ agrees_up (2 / 3) (33 / 50) 2 /\ agrees_up (2 / 3) (67 / 100) 2.
End language_decimals.

Module language_divisor.
(* bezier/language.divisor, README, conditions
   printed: A divisor is a condition: y/y = 1.
   stated: y/y == 1 *)
Definition statement : Prop :=
forall (y : R),
  y <> 0 ->
  y / y = 1.
Definition instance : Prop :=
exists (y : R),
  y <> 0.
End language_divisor.

Module language_degree.
(* bezier/language.degree, README, symbolic degree
   printed: A rational curve with equal weights, and scalars as control points.
   stated: sum(i, 0, m, B[i,m](x)*w[i])/sum(i, 0, m, B[i,m](x)) == sum(i, 0, m, B[i,m](x)*w[i]) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (m : Z) (w : Z -> R) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  sum 0%Z m (fun i => B x i m) <> 0 ->
  sum 0%Z m (fun i => B x i m * w i) / sum 0%Z m (fun i => B x i m) = sum 0%Z m (fun i => B x i m * w i).
Definition instance : Prop :=
exists (m : Z) (w : Z -> R) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  sum 0%Z m (fun i => B x i m) <> 0.
End language_degree.

Module language_order.
(* bezier/language.order, README, decisions
   printed: The examples of order: 0 <= x <= 1, x^2 - x + 1 > 0.
   stated: 0 <= x <= 1 and x^2 - x + 1 > 0 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  0 <= x /\ x <= 1 /\ x ^ 2 - x + 1 > 0.
Definition instance : Prop :=
exists (x : R),
  0 <= x <= 1.
End language_order.

Module language_order_false.
(* bezier/language.order.false, README, decisions
   printed: A common slip: x > 0 on [0, 1].
   stated: x > 0 *)
Definition statement : Prop :=
forall (x : R),
  0 <= x <= 1 ->
  x > 0.
End language_order_false.

Module language_assumed.
(* bezier/language.assumed, README, assume
   printed: An assumption discharges a condition: y/y = 1 for y > 0.
   stated: y/y == 1 *)
Definition statement : Prop :=
forall (y : R),
  y > 0 ->
  y <> 0 ->
  y / y = 1.
Definition instance : Prop :=
exists (y : R),
  y > 0 /\
  y <> 0.
End language_assumed.

Module language_declared.
(* bezier/language.declared, README, assume
   printed: A declared range discharges a condition: y/y = 1 for y in (5, inf).
   stated: y/y == 1 *)
Definition statement : Prop :=
forall (y : R),
  5 < y ->
  y <> 0 ->
  y / y = 1.
Definition instance : Prop :=
exists (y : R),
  5 < y /\
  y <> 0.
End language_declared.

Module language_decimals_false.
(* bezier/language.decimals.false, README, printed decimals
   printed: A common slip: 2/3 = 0.68
   stated: agrees(2/3, 0.68) *)
Definition statement : Prop :=
  agrees_up (2 / 3) (17 / 25) 2.
End language_decimals_false.
