(* Statements of hermite-developable, Section 3 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition first (a1 : R) (b1 : R) (c1 : R) (d1 : R) (u : R) : R :=
  a1 * u ^ 3 + b1 * u ^ 2 + c1 * u + d1.
Definition second (a2 : R) (b2 : R) (c2 : R) (d2 : R) (u : R) : R :=
  a2 * u ^ 3 + b2 * u ^ 2 + c2 * u + d2.
Definition cubic (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : R :=
  A * u ^ 3 + B * u ^ 2 + C_ * u + E_.
Definition cubic_data (A : R) (B : R) (C_ : R) (E_ : R) : list (list R) :=
  [[Derive_n (fun A => cubic A B C_ E_ 0) 1 A; Derive_n (fun B => cubic A B C_ E_ 0) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 0) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 0) 1 E_]; [Derive_n (fun A => cubic A B C_ E_ 1) 1 A; Derive_n (fun B => cubic A B C_ E_ 1) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 1) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 1) 1 E_]; [Derive_n (fun A => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 E_]; [Derive_n (fun A => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 E_]].
Definition cubic_basis (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  mvec (transpose (inverse (cubic_data A B C_ E_))) [u ^ 3; u ^ 2; u; 1].
Definition blend4 (w : list R) (a : R) (b : R) (c : R) (d : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d.
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : R) (b : R) (s : R) (t : R) : R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) : R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition A35 (k : R) : list (list R) :=
  [[2 * k; - k; - k; - 2 * k]; [3 * k; - k; - 2 * k; - 3 * k]; [- 6 * k; 3 * k; 2 * k; 6 * k]; [0; - k; 0; - k]].
Definition right_ (c1 : R) (c2 : R) (c3 : R) (c4 : R) : list R :=
  [c1; c2; c3; c4].
Definition x (x1 : R) (x2 : R) (x3 : R) (x4 : R) : list R :=
  [x1; x2; x3; x4].
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) : R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) : R :=
  q3 A B C_ E_ q0 q0u q1 q1u u + Derive_n (fun u => q3 A B C_ E_ q0 q0u q1 q1u u) 1 u - k * (p3 A B C_ E_ p0 p0u p1 p1u u + Derive_n (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u) - (1 - k) * o.
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => cubic_gap A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u u) (Z.to_nat n) u / factorial n) 0.
Definition cubic_system (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) : list (list R) :=
  [[Derive_n (fun p1 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z) 1 p1; Derive_n (fun p0u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z) 1 p0u; Derive_n (fun p1u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z) 1 p1u; Derive_n (fun p0 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z) 1 p0]; [Derive_n (fun p1 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z) 1 p1; Derive_n (fun p0u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z) 1 p0u; Derive_n (fun p1u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z) 1 p1u; Derive_n (fun p0 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z) 1 p0]; [Derive_n (fun p1 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z) 1 p1; Derive_n (fun p0u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z) 1 p0u; Derive_n (fun p1u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z) 1 p1u; Derive_n (fun p0 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z) 1 p0]; [Derive_n (fun p1 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z) 1 p1; Derive_n (fun p0u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z) 1 p0u; Derive_n (fun p1u => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z) 1 p1u; Derive_n (fun p0 => cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z) 1 p0]].
End Definitions.
Import Definitions.

Module sec_3_1_polynomials.
(* hermite-developable/sec-3.1.polynomials, Sect. 3.1, first sentence (display missing)
   printed: Two cubic Hermite curves p_3(u) and q_3(u) in the parallel plane Gamma_1 / Gamma_2 are presented in the polynomial formula and their first derivations, respectively, as follows [display missing in our copy]
   read as: p_3 = a_1 u^3 + b_1 u^2 + c_1 u + d_1, p_3' = 3 a_1 u^2 + 2 b_1 u + c_1, and q_3, q_3' with index 2: the only reading that gives the next display
   stated: first'(u) == 3*a1*u^2 + 2*b1*u + c1 and second'(u) == 3*a2*u^2 + 2*b2*u + c2 *)
Definition statement : Prop :=
forall (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (u : R),
  0 < u < 1 ->
  Derive_n (fun u => first a1 b1 c1 d1 u) 1 u = 3 * a1 * u ^ 2 + 2 * b1 * u + c1 /\ Derive_n (fun u => second a2 b2 c2 d2 u) 1 u = 3 * a2 * u ^ 2 + 2 * b2 * u + c2.
Definition instance : Prop :=
exists (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (u : R),
  0 < u < 1.
End sec_3_1_polynomials.

Module sec_3_1_substituted.
(* hermite-developable/sec-3.1.substituted, Sect. 3.1, unnumbered display
   printed: a_2 u^3 + (b_2 + 3 a_2) u^2 + (c_2 + 2 b_2) u + (d_2 + c_2) = k [a_1 u^3 + (b_1 + 3 a_1) u^2 + (c_1 + 2 b_1) u + (d_1 + c_1)] + (1 - k) o
   stated: second(u) + second'(u) - k*(first(u) + first'(u)) - (1 - k)*o == a2*u^3 + (b2 + 3*a2)*u^2 + (c2 + 2*b2)*u + (d2 + c2) - k*(a1*u^3 + (b1 + 3*a1)*u^2 + (c1 + 2*b1)*u + (d1 + c1)) - (1 - k)*o *)
Definition statement : Prop :=
forall (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R) (u : R),
  0 < u < 1 ->
  second a2 b2 c2 d2 u + Derive_n (fun u => second a2 b2 c2 d2 u) 1 u - k * (first a1 b1 c1 d1 u + Derive_n (fun u => first a1 b1 c1 d1 u) 1 u) - (1 - k) * o = a2 * u ^ 3 + (b2 + 3 * a2) * u ^ 2 + (c2 + 2 * b2) * u + (d2 + c2) - k * (a1 * u ^ 3 + (b1 + 3 * a1) * u ^ 2 + (c1 + 2 * b1) * u + (d1 + c1)) - (1 - k) * o.
Definition instance : Prop :=
exists (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R) (u : R),
  0 < u < 1.
End sec_3_1_substituted.

Module sec_3_1_coefficients.
(* hermite-developable/sec-3.1.coefficients, Sect. 3.1, four coefficient equations
   printed: a_2 = k . a_1; b_2 + 3 a_2 = k . (b_1 + 3 a_1); c_2 + 2 b_2 = k . (c_1 + 2 b_1); d_2 + c_2 = k . (d_1 + c_1) + (1 - k) o
   read as: in the third equation our copy repeats a meaningless run 'k b_1 + 3 a_2 = k b_2 + 3 a_2 = ...' between 'c_2 + 2 b_2 =' and 'k.(c_1 + 2 b_1)'; the run is an artefact of the extraction and is left out
   stated: part(3) == a2 - k*a1 and part(2) == b2 + 3*a2 - k*(b1 + 3*a1) and part(1) == c2 + 2*b2 - k*(c1 + 2*b1) and part(0) == d2 + c2 - k*(d1 + c1) - (1 - k)*o *)
Definition gap (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R) (u : R) : R :=
  second a2 b2 c2 d2 u + Derive_n (fun u => second a2 b2 c2 d2 u) 1 u - k * (first a1 b1 c1 d1 u + Derive_n (fun u => first a1 b1 c1 d1 u) 1 u) - (1 - k) * o.
Definition part (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => gap a1 a2 b1 b2 c1 c2 d1 d2 k o u) (Z.to_nat n) u / factorial n) 0.
Definition statement : Prop :=
forall (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R),
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part a1 a2 b1 b2 c1 c2 d1 d2 k o 3%Z = a2 - k * a1 /\ part a1 a2 b1 b2 c1 c2 d1 d2 k o 2%Z = b2 + 3 * a2 - k * (b1 + 3 * a1) /\ part a1 a2 b1 b2 c1 c2 d1 d2 k o 1%Z = c2 + 2 * b2 - k * (c1 + 2 * b1) /\ part a1 a2 b1 b2 c1 c2 d1 d2 k o 0%Z = d2 + c2 - k * (d1 + c1) - (1 - k) * o.
Definition instance : Prop :=
exists (a1 : R) (a2 : R) (b1 : R) (b2 : R) (c1 : R) (c2 : R) (d1 : R) (d2 : R) (k : R) (o : R),
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End sec_3_1_coefficients.

Module sec_3_1_hermite_1.
(* hermite-developable/sec-3.1.hermite.1, Sect. 3.1, equations with points and tangent vectors, first
   printed: 2 q_0 - 2 q_1 + q_0^u + q_1^u = k (2 p_0 - 2 p_1 + p_0^u + p_1^u)
   stated: cubic_part(3) == 2*q0 - 2*q1 + q0u + q1u - k*(2*p0 - 2*p1 + p0u + p1u) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 2 * q0 - 2 * q1 + q0u + q1u - k * (2 * p0 - 2 * p1 + p0u + p1u).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0.
End sec_3_1_hermite_1.

Module sec_3_1_hermite_2.
(* hermite-developable/sec-3.1.hermite.2, Sect. 3.1, equations with points and tangent vectors, second
   printed: 3 q_0 - 3 q_1 + q_0^u + 2 q_1^u = k (3 p_0 - 3 p_1 + p_0^u + 2 p_1^u)
   read as: the copy runs the three equations together on one line; they are split before each left-hand side
   stated: cubic_part(2) == 3*q0 - 3*q1 + q0u + 2*q1u - k*(3*p0 - 3*p1 + p0u + 2*p1u) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 3 * q0 - 3 * q1 + q0u + 2 * q1u - k * (3 * p0 - 3 * p1 + p0u + 2 * p1u).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0.
End sec_3_1_hermite_2.

Module sec_3_1_hermite_3.
(* hermite-developable/sec-3.1.hermite.3, Sect. 3.1, equations with points and tangent vectors, third
   printed: -6 q_0 + 6 q_1 - 3 q_0^u - 2 q_1^u = k (-6 p_0 + 6 p_1 - 3 p_0^u - 2 p_1^u)
   stated: cubic_part(1) == -6*q0 + 6*q1 - 3*q0u - 2*q1u - k*(-6*p0 + 6*p1 - 3*p0u - 2*p1u) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = - 6 * q0 + 6 * q1 - 3 * q0u - 2 * q1u - k * (- 6 * p0 + 6 * p1 - 3 * p0u - 2 * p1u).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0.
End sec_3_1_hermite_3.

Module sec_3_1_hermite_4.
(* hermite-developable/sec-3.1.hermite.4, Sect. 3.1, equations with points and tangent vectors, fourth
   printed: q_0 + q_0^u = k (p_0 + p_0^u) + (1 - k) o
   stated: cubic_part(0) == q0 + q0u - k*(p0 + p0u) - (1 - k)*o *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = q0 + q0u - k * (p0 + p0u) - (1 - k) * o.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End sec_3_1_hermite_4.

Module eq_3_5_A_r1.
(* hermite-developable/eq-3.5.A.r1, Sect. 3.1, eq. (3.5), matrix A, row 1
   printed: (2k, -k, -k, -2k)
   read as: the copy merges two columns: '2k - k & -k & -2k'
   stated: cubic_system[1] == [2*k, -k, -k, -2*k] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) 1 = [2 * k; - k; - k; - 2 * k].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_A_r1.

Module eq_3_5_A_r2.
(* hermite-developable/eq-3.5.A.r2, Sect. 3.1, eq. (3.5), matrix A, row 2
   printed: (3k, -k, -2k, -3k)
   read as: the copy merges two columns: '3k - k & -2k & -3k'
   stated: cubic_system[2] == [3*k, -k, -2*k, -3*k] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) 2 = [3 * k; - k; - 2 * k; - 3 * k].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_A_r2.

Module eq_3_5_A_r3.
(* hermite-developable/eq-3.5.A.r3, Sect. 3.1, eq. (3.5), matrix A, row 3
   printed: (-6k, 3k, 2k, 6k)
   stated: cubic_system[3] == [-6*k, 3*k, 2*k, 6*k] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) 3 = [- 6 * k; 3 * k; 2 * k; 6 * k].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_A_r3.

Module eq_3_5_A_r4.
(* hermite-developable/eq-3.5.A.r4, Sect. 3.1, eq. (3.5), matrix A, row 4
   printed: (0, -k, 0, -k)
   stated: cubic_system[4] == [0, -k, 0, -k] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) 4 = [0; - k; 0; - k].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_A_r4.

Module eq_3_5_B.
(* hermite-developable/eq-3.5.B, Sect. 3.1, eq. (3.5), column of unknowns
   printed: B = (p_1, p_0^u, p_1^u, p_0^u)
   stated: cubic_system*[p1, p0u, p1u, p0] == A35*[p1, p0u, p1u, p0u] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  0 < k ->
  k <> 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  mvec (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) [p1; p0u; p1u; p0] = mvec (A35 k) [p1; p0u; p1u; p0u].
End eq_3_5_B.

Module eq_3_5_B_corrected.
(* hermite-developable/eq-3.5.B (corrected), Sect. 3.1, eq. (3.5), column of unknowns
   printed: B = (p_1, p_0^u, p_1^u, p_0^u)
   stated: cubic_system*[p1, p0u, p1u, p0] == A35*[p1, p0u, p1u, p0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  0 < k ->
  k <> 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  mvec (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) [p1; p0u; p1u; p0] = mvec (A35 k) [p1; p0u; p1u; p0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  0 < k /\
  k <> 1 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_B_corrected.

Module eq_3_5_C_r1.
(* hermite-developable/eq-3.5.C.r1, Sect. 3.1, eq. (3.5), right-hand side, row 1
   printed: 2 q_1 - 2 q_0 - q_0^u - q_1^u
   stated: blend4(A35[1], p1, p0u, p1u, p0) - cubic_part(3) == 2*q1 - 2*q0 - q0u - q1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  blend4 (row (A35 k) 1) p1 p0u p1u p0 - cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 2 * q1 - 2 * q0 - q0u - q1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0.
End eq_3_5_C_r1.

Module eq_3_5_C_r2.
(* hermite-developable/eq-3.5.C.r2, Sect. 3.1, eq. (3.5), right-hand side, row 2
   printed: 3 q_1 - 3 q_0 - q_0^u - 2 q_1^u
   stated: blend4(A35[2], p1, p0u, p1u, p0) - cubic_part(2) == 3*q1 - 3*q0 - q0u - 2*q1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  blend4 (row (A35 k) 2) p1 p0u p1u p0 - cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 3 * q1 - 3 * q0 - q0u - 2 * q1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0.
End eq_3_5_C_r2.

Module eq_3_5_C_r3.
(* hermite-developable/eq-3.5.C.r3, Sect. 3.1, eq. (3.5), right-hand side, row 3
   printed: -6 q_1 + 6 q_0 + 3 q_0^u + 2 q_1^u
   stated: blend4(A35[3], p1, p0u, p1u, p0) - cubic_part(1) == -6*q1 + 6*q0 + 3*q0u + 2*q1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  blend4 (row (A35 k) 3) p1 p0u p1u p0 - cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = - 6 * q1 + 6 * q0 + 3 * q0u + 2 * q1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0.
End eq_3_5_C_r3.

Module eq_3_5_C_r4.
(* hermite-developable/eq-3.5.C.r4, Sect. 3.1, eq. (3.5), right-hand side, row 4
   printed: (1 - k) o - q_0 - q_0^u
   stated: blend4(A35[4], p1, p0u, p1u, p0) - cubic_part(0) == (1 - k)*o - q0 - q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  blend4 (row (A35 k) 4) p1 p0u p1u p0 - cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = (1 - k) * o - q0 - q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_5_C_r4.

Module eq_3_5_unique.
(* hermite-developable/eq-3.5.unique, Sect. 3.1, sentence after (3.5)
   printed: This equation system (3.5) has a unique solution if the determinant value of the coefficient matrix A is different from zero
   read as: one coordinate of each vector: the system is the same in all of them
   stated: A35*solve(A35, right) == right and solve(A35, A35*x) == x *)
Definition statement : Prop :=
forall (c1 : R) (c2 : R) (c3 : R) (c4 : R) (k : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R),
  det (A35 k) <> 0 ->
  mvec (A35 k) (solve (A35 k) (right_ c1 c2 c3 c4)) = right_ c1 c2 c3 c4 /\ solve (A35 k) (mvec (A35 k) (x x1 x2 x3 x4)) = x x1 x2 x3 x4.
Definition instance : Prop :=
exists (c1 : R) (c2 : R) (c3 : R) (c4 : R) (k : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R),
  det (A35 k) <> 0.
End eq_3_5_unique.

Module eq_3_5_det.
(* hermite-developable/eq-3.5.det, Sect. 3.1, sentence after (3.5)
   printed: det(A) = k^4
   stated: det(A35) == k^4 *)
Definition statement : Prop :=
forall (k : R),
  det (A35 k) = k ^ 4.
End eq_3_5_det.

Module eq_3_5_k.
(* hermite-developable/eq-3.5.k, Sect. 3.1, sentence after (3.5)
   printed: Due to det(A) = k^4 and the defined developable surfaces are positioned in the same side to the summit point O, we elect the value k > 0 and k != 1
   read as: the points of both curves on one generatrix are on the same side of the summit for k > 0, and only then; the curves are apart for k != 1, and only then
   stated: dot(q3(u) - o, p3(u) - o) == k*dot(p3(u) - o, p3(u) - o) and cross(q3(u) - o, p3(u) - o) == 0 and q3(u) - p3(u) == (k - 1)*(p3(u) - o) *)
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ q0 q0u q1 q1u u) (vDerive 3 (fun u => q3 A B C_ E_ q0 q0u q1 q1u u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = zeros 3 ->
  dot (vsub (q3 A B C_ E_ q0 q0u q1 q1u u) o) (vsub (p3 A B C_ E_ p0 p0u p1 p1u u) o) = k * dot (vsub (p3 A B C_ E_ p0 p0u p1 p1u u) o) (vsub (p3 A B C_ E_ p0 p0u p1 p1u u) o) /\ cross (vsub (q3 A B C_ E_ q0 q0u q1 q1u u) o) (vsub (p3 A B C_ E_ p0 p0u p1 p1u u) o) = zeros 3 /\ vsub (q3 A B C_ E_ q0 q0u q1 q1u u) (p3 A B C_ E_ p0 p0u p1 p1u u) = vscale (k - 1) (vsub (p3 A B C_ E_ p0 p0u p1 p1u u) o).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  0 < u < 1 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = zeros 3).
End eq_3_5_k.

Module eq_3_5_sol_p1.
(* hermite-developable/eq-3.5.sol.p1, Sect. 3.1, solutions of (3.5)
   printed: p_1 = (q_1 + (k - 1) o)/k
   stated: p1 == (q1 + (k - 1)*o)/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p1 = (q1 + (k - 1) * o) / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0.
End eq_3_5_sol_p1.

Module eq_3_5_sol_p0u.
(* hermite-developable/eq-3.5.sol.p0u, Sect. 3.1, solutions of (3.5)
   printed: p_0^u = q_0^u/k
   stated: p0u == q0u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p0u = q0u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0.
End eq_3_5_sol_p0u.

Module eq_3_5_sol_p1u.
(* hermite-developable/eq-3.5.sol.p1u, Sect. 3.1, solutions of (3.5)
   printed: p_1^u = q_1^u/k
   stated: p1u == q1u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p1u = q1u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0.
End eq_3_5_sol_p1u.

Module eq_3_5_sol_p0.
(* hermite-developable/eq-3.5.sol.p0, Sect. 3.1, solutions of (3.5)
   printed: p_0 = (q_0 + (k - 1) o)/k
   stated: p0 == (q0 + (k - 1)*o)/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p0 = (q0 + (k - 1) * o) / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0.
End eq_3_5_sol_p0.

Module sec_3_1_conclusion.
(* hermite-developable/sec-3.1.conclusion, Sect. 3.1, paragraph 'It can conclude that'
   printed: using two cubic Hermite curves p_3(u) and q_3(u) in the parallel planes Gamma_1 // Gamma_2, correspondingly, can be designed a cubic developable Hermite surface D_3(u, v) = (1 - v) p_3(u) + v q_3(u) through the steps
   read as: in coordinates in which the parallel planes are planes x = const: q has free data in the plane x = h, p follows by step 3
   stated: q3'(u)[1] == 0 and p3'(u)[1] == 0 and h - p3(u)[1] == (1 - 1/k)*(h - o[1]) and det([p3'(u), q3'(u), q3(u) - p3(u)]) == 0 *)
Definition q0 (h : R) (y0 : R) (z0 : R) : list R :=
  [h; y0; z0].
Definition q1 (h : R) (y1 : R) (z1 : R) : list R :=
  [h; y1; z1].
Definition q0u (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition q1u (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (h : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (u : R) : list R :=
  hermite3 A B C_ E_ u (q0 h y0 z0) (q1 h y1 z1) (q0u y2 z2) (q1u y3 z3).
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (h : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) (vDerive 3 (fun u => q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (h : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (h : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  0 < u < 1 ->
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 3%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 2%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 1%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 0%Z = zeros 3 ->
  k <> 0 ->
  entry (vDerive 3 (fun u => q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u) 1 = 0 /\ h - entry (p3 A B C_ E_ p0 p0u p1 p1u u) 1 = (1 - 1 / k) * (h - entry o 1) /\ det [vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u; vDerive 3 (fun u => q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) 1 u; vsub (q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) (p3 A B C_ E_ p0 p0u p1 p1u u)] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (h : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  0 < u < 1 /\
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 3%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 2%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 1%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 0%Z = zeros 3) /\
  k <> 0.
End sec_3_1_conclusion.

Module alg_3_1_step1.
(* hermite-developable/alg-3.1.step1, Sect. 3.1, step 1
   printed: 1. Substitute p_3(u), p'(u), q_3(u), q'(u) in the developable surface criteria of Equation (3.3)
   read as: the result of the step are the four equations printed above the steps
   stated: cubic_gap(u) == (2*q0 - 2*q1 + q0u + q1u - k*(2*p0 - 2*p1 + p0u + p1u))*u^3 + (3*q0 - 3*q1 + q0u + 2*q1u - k*(3*p0 - 3*p1 + p0u + 2*p1u))*u^2 + (-6*q0 + 6*q1 - 3*q0u - 2*q1u - k*(-6*p0 + 6*p1 - 3*p0u - 2*p1u))*u + (q0 + q0u - k*(p0 + p0u) - (1 - k)*o) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  cubic_gap A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u u = (2 * q0 - 2 * q1 + q0u + q1u - k * (2 * p0 - 2 * p1 + p0u + p1u)) * u ^ 3 + (3 * q0 - 3 * q1 + q0u + 2 * q1u - k * (3 * p0 - 3 * p1 + p0u + 2 * p1u)) * u ^ 2 + (- 6 * q0 + 6 * q1 - 3 * q0u - 2 * q1u - k * (- 6 * p0 + 6 * p1 - 3 * p0u - 2 * p1u)) * u + (q0 + q0u - k * (p0 + p0u) - (1 - k) * o).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < u < 1 /\
  det (cubic_data A B C_ E_) <> 0.
End alg_3_1_step1.

Module alg_3_1_step2.
(* hermite-developable/alg-3.1.step2, Sect. 3.1, step 2
   printed: 2. Determine the values for the summit point O, the control points and the tangent vectors q_0, q_1, q_0^u, q_1^u in the polynomial coefficient equations of the step result (1)
   read as: these five vectors may be any: for each choice the four equations determine the four data of p
   stated: cubic_system*solve(cubic_system, right) == right and solve(cubic_system, cubic_system*x) == x *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  det (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) <> 0 ->
  mvec (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) (solve (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) (right_ c1 c2 c3 c4)) = right_ c1 c2 c3 c4 /\ solve (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) (mvec (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) (x x1 x2 x3 x4)) = x x1 x2 x3 x4.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  det (cubic_system A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u) <> 0.
End alg_3_1_step2.

Module alg_3_1_step3.
(* hermite-developable/alg-3.1.step3, Sect. 3.1, step 3
   printed: 3. Determine the value k > 0 and k != 1, after that, calculate Equation (3.5) to find the control points p_0, p_1 and the tangent vectors p_0^u, p_1^u
   read as: one coordinate of each vector: the system is the same in all of them
   stated: q3(u) + q3'(u) == k*(p(u) + p'(u)) + (1 - k)*o *)
Definition X (k : R) (o : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) : list R :=
  solve (A35 k) [2 * q1 - 2 * q0 - q0u - q1u; 3 * q1 - 3 * q0 - q0u - 2 * q1u; - 6 * q1 + 6 * q0 + 3 * q0u + 2 * q1u; (1 - k) * o - q0 - q0u].
Definition p (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) : R :=
  hermite3 A B C_ E_ u (entry (X k o q0 q0u q1 q1u) 4) (entry (X k o q0 q0u q1 q1u) 1) (entry (X k o q0 q0u q1 q1u) 2) (entry (X k o q0 q0u q1 q1u) 3).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < k ->
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  det (A35 k) <> 0 ->
  q3 A B C_ E_ q0 q0u q1 q1u u + Derive_n (fun u => q3 A B C_ E_ q0 q0u q1 q1u u) 1 u = k * (p A B C_ E_ k o q0 q0u q1 q1u u + Derive_n (fun u => p A B C_ E_ k o q0 q0u q1 q1u u) 1 u) + (1 - k) * o.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < k /\
  0 < u < 1 /\
  det (cubic_data A B C_ E_) <> 0 /\
  det (A35 k) <> 0.
End alg_3_1_step3.

Module sec_3_1_tension.
(* hermite-developable/sec-3.1.tension, Sect. 3.1, paragraph after the steps
   printed: q_0^{u*} = k_1 q_0^u and q_1^{u*} = k_2 q_1^u, then in step (3), it finds the values p_0^u = [k_1 q_0^u]/k and p_1^u = [k_2 q_1^u]/k
   stated: p0u == k1*q0u/k and p1u == k2*q1u/k *)
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) : R :=
  hermite3 A B C_ E_ u q0 q1 (k1 * q0u) (k2 * q1u).
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (k1 : R) (k2 : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) : R :=
  q3 A B C_ E_ k1 k2 q0 q0u q1 q1u u + Derive_n (fun u => q3 A B C_ E_ k1 k2 q0 q0u q1 q1u u) 1 u - k * (p3 A B C_ E_ p0 p0u p1 p1u u + Derive_n (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u) - (1 - k) * o.
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (k1 : R) (k2 : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => cubic_gap A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u u) (Z.to_nat n) u / factorial n) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (k1 : R) (k2 : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p0u = k1 * q0u / k /\ p1u = k2 * q1u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (k1 : R) (k2 : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k k1 k2 o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0.
End sec_3_1_tension.

Module ex_3_1_arrange.
(* hermite-developable/ex-3.1.arrange, Sect. 3.1, last paragraph
   printed: the determination of the point O and the parameter k can arrange the position of control points p_0, p_1, and the measure of generatrix g between the parallel planes Gamma_1 // Gamma_2
   stated: p0 == solved0 and p1 == solved1 and coefficients([p0, p1], [o]) == [[(k - 1)/k], [(k - 1)/k]] and fails(D(solved0, k) == 0) and fails(D(solved1, k) == 0) and q3(u) - p3(u) == (1 - 1/k)*(q3(u) - o) *)
Definition solved0 (k : R) (o : R) (q0 : R) : R :=
  (q0 + (k - 1) * o) / k.
Definition solved1 (k : R) (o : R) (q1 : R) : R :=
  (q1 + (k - 1) * o) / k.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) (p1_of_o : R -> R) (p0u_of_o : R -> R) (p1u_of_o : R -> R) (p0_of_o : R -> R),
  0 < u < 1 ->
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  k <> 0 ->
  p1_of_o o = p1 ->
  p0u_of_o o = p0u ->
  p1u_of_o o = p1u ->
  p0_of_o o = p0 ->
  (forall o : R, cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 0%Z = 0) ->
  p0 = solved0 k o q0 /\ p1 = solved1 k o q1 /\ [[Derive_n (fun o => p0_of_o o) 1 o]; [Derive_n (fun o => p1_of_o o) 1 o]] = [[(k - 1) / k]; [(k - 1) / k]] /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < u < 1 ->
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  locally k (fun k => k <> 0) ->
  Derive_n (fun k => solved0 k o q0) 1 k = 0) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R),
  0 < u < 1 ->
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0 ->
  locally k (fun k => k <> 0) ->
  Derive_n (fun k => solved1 k o q1) 1 k = 0) /\ q3 A B C_ E_ q0 q0u q1 q1u u - p3 A B C_ E_ p0 p0u p1 p1u u = (1 - 1 / k) * (q3 A B C_ E_ q0 q0u q1 q1u u - o).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (u : R) (p1_of_o : R -> R) (p0u_of_o : R -> R) (p1u_of_o : R -> R) (p0_of_o : R -> R),
  0 < u < 1 /\
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u 0%Z = 0) /\
  k <> 0 /\
  p1_of_o o = p1 /\
  p0u_of_o o = p0u /\
  p1u_of_o o = p1u /\
  p0_of_o o = p0 /\
  (forall o : R, cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 3%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 2%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 1%Z = 0 /\ cubic_part A B C_ E_ k o (p0_of_o o) (p0u_of_o o) (p1_of_o o) (p1u_of_o o) q0 q0u q1 q1u 0%Z = 0).
End ex_3_1_arrange.

Module ex_3_1_tension_effect.
(* hermite-developable/ex-3.1.tension-effect, Sect. 3.1, last sentence
   printed: giving tensions to the tangent vectors q_0^u and q_1^u will effect the surface tangent form, sharply or weakly, in area near the control points q_0 and q_1 (Figure (2d))
   read as: the bending of the boundary curve q: the curvature at q_0 is |q' x q''| / |q'|^3, and so at q_1
   stated: tense'(0) == k1*q0u and start == k1*at(start, k1, 1) and fails(at(start, k1, 1) == 0) and tense'(1) == k2*q1u and end == k2*at(end, k2, 1) and fails(at(end, k2, 1) == 0) *)
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition tense (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 (vscale k1 q0u) (vscale k2 q1u).
Definition start (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) : list R :=
  cross (vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 1 0) (vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 2 0).
Definition end_ (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) : list R :=
  cross (vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 1 1) (vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 2 1).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R),
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 1 0 = vscale k1 q0u /\ start A B C_ E_ k1 k2 q0 q0u q1 q1u = vscale k1 ((fun k1 : R => start A B C_ E_ k1 k2 q0 q0u q1 q1u) 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R),
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (fun k1 : R => start A B C_ E_ k1 k2 q0 q0u q1 q1u) 1 = zeros 3) /\ vDerive 3 (fun u => tense A B C_ E_ k1 k2 q0 q0u q1 q1u u) 1 1 = vscale k2 q1u /\ end_ A B C_ E_ k1 k2 q0 q0u q1 q1u = vscale k2 ((fun k2 : R => end_ A B C_ E_ k1 k2 q0 q0u q1 q1u) 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R),
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (fun k2 : R => end_ A B C_ E_ k1 k2 q0 q0u q1 q1u) 1 = zeros 3).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k1 : R) (k2 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R),
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  det (cubic_data A B C_ E_) <> 0.
End ex_3_1_tension_effect.

Module ex_3_1_p1.
(* hermite-developable/ex-3.1.p1, Sect. 3.1, example
   printed: p_1 = < 75, -25, 45 >
   stated: agrees(p1, [75, -25, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [170; 0; 45].
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ p0 p0u p1 p1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3 ->
  (entry p1 1 = 75 /\ entry p1 2 = (-25)) /\ entry p1 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3).
End ex_3_1_p1.

Module ex_3_1_p0u.
(* hermite-developable/ex-3.1.p0u, Sect. 3.1, example
   printed: p_0^u = < 0, -15, 30 >
   stated: agrees(p0u, [0, -15, 30]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [170; 0; 45].
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ p0 p0u p1 p1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3 ->
  (entry p0u 1 = 0 /\ entry p0u 2 = (-15)) /\ entry p0u 3 = 30.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3).
End ex_3_1_p0u.

Module ex_3_1_p1u.
(* hermite-developable/ex-3.1.p1u, Sect. 3.1, example
   printed: p_1^u = < 0, -25, -30 >
   stated: agrees(p1u, [0, -25, -30]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [170; 0; 45].
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ p0 p0u p1 p1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3 ->
  (entry p1u 1 = 0 /\ entry p1u 2 = (-25)) /\ entry p1u 3 = (-30).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3).
End ex_3_1_p1u.

Module ex_3_1_p0.
(* hermite-developable/ex-3.1.p0, Sect. 3.1, example
   printed: p_0 = < 75, 30, 45 >
   stated: agrees(p0, [75, 30, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [170; 0; 45].
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ p0 p0u p1 p1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3 ->
  (entry p0 1 = 75 /\ entry p0 2 = 30) /\ entry p0 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3).
End ex_3_1_p0.

Module ex_3_1_parallel.
(* hermite-developable/ex-3.1.parallel, Sect. 3.1, example, with the section's assumption Gamma_1 // Gamma_2
   printed: Two cubic Hermite curves p_3(u) and q_3(u) in the parallel plane [...] between the parallel planes Gamma_1 // Gamma_2
   read as: all four data sets of Fig. 2: q_0 is the same in them; q_1 is in the plane x = -20, the tangent vectors have no x-coordinate, the summit and k > 0 are any
   stated: q3'(u)[1] == 0 and p3'(u)[1] == 0 and p3(0)[1] == o[1] + (-20 - o[1])/k *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 (y1 : R) (z1 : R) : list R :=
  [- 20; y1; z1].
Definition q0u (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition q1u (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (y1 : R) (y2 : R) (y3 : R) (z1 : R) (z2 : R) (z3 : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 (q1 y1 z1) (q0u y2 z2) (q1u y3 z3).
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (y1 : R) (y2 : R) (y3 : R) (z1 : R) (z2 : R) (z3 : R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ y1 y2 y3 z1 z2 z3 u) (vDerive 3 (fun u => q3 A B C_ E_ y1 y2 y3 z1 z2 z3 u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (y1 : R) (y2 : R) (y3 : R) (z1 : R) (z2 : R) (z3 : R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  0 < u < 1 ->
  k > 0 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 3%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 2%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 1%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 0%Z = zeros 3 ->
  k <> 0 ->
  entry (vDerive 3 (fun u => q3 A B C_ E_ y1 y2 y3 z1 z2 z3 u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u) 1 = 0 /\ entry (p3 A B C_ E_ p0 p0u p1 p1u 0) 1 = entry o 1 + (- 20 - entry o 1) / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  0 < u < 1 /\
  k > 0 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 3%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 2%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 1%Z = zeros 3 /\ cubic_part A B C_ E_ k o p0 p0u p1 p1u y1 y2 y3 z1 z2 z3 0%Z = zeros 3) /\
  k <> 0.
End ex_3_1_parallel.

Module ex_3_1_width.
(* hermite-developable/ex-3.1.width, Sect. 3.1, example, k = 3/2
   printed: If we determine k = 3/2, then the surface's width (generatrix measure) changes as shown in Figure (2b)
   stated: q3(u) - narrow(u) == 2/3*(q3(u) - p3(u)) and dot(q3(u) - narrow(u), q3(u) - narrow(u)) < dot(q3(u) - p3(u), q3(u) - p3(u)) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [170; 0; 45].
Definition cubic_gap (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale k (vadd (p3 A B C_ E_ p0 p0u p1 p1u u) (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition cubic_part (A : R) (B : R) (C_ : R) (E_ : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => cubic_gap A B C_ E_ p0 p0u p1 p1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition narrow (A : R) (B : R) (C_ : R) (E_ : R) (w0 : list R) (w0u : list R) (w1 : list R) (w1u : list R) (u : R) : list R :=
  hermite3 A B C_ E_ u w0 w1 w0u w1u.
Definition narrow_gap (A : R) (B : R) (C_ : R) (E_ : R) (w0 : list R) (w0u : list R) (w1 : list R) (w1u : list R) (u : R) : list R :=
  vsub (vsub (vadd (q3 A B C_ E_ u) (vDerive 3 (fun u => q3 A B C_ E_ u) 1 u)) (vscale (3 / 2) (vadd (narrow A B C_ E_ w0 w0u w1 w1u u) (vDerive 3 (fun u => narrow A B C_ E_ w0 w0u w1 w1u u) 1 u)))) (vscale (1 - 3 / 2) o).
Definition narrow_part (A : R) (B : R) (C_ : R) (E_ : R) (w0 : list R) (w0u : list R) (w1 : list R) (w1u : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => narrow_gap A B C_ E_ w0 w0u w1 w1u u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (w0'1 w0'2 w0'3 : R) (w0u'1 w0u'2 w0u'3 : R) (w1'1 w1'2 w1'3 : R) (w1u'1 w1u'2 w1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let w0 := [w0'1; w0'2; w0'3] in
  let w0u := [w0u'1; w0u'2; w0u'3] in
  let w1 := [w1'1; w1'2; w1'3] in
  let w1u := [w1u'1; w1u'2; w1u'3] in
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3 ->
  narrow_part A B C_ E_ w0 w0u w1 w1u 3%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 2%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 1%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 0%Z = zeros 3 ->
  vsub (q3 A B C_ E_ u) (narrow A B C_ E_ w0 w0u w1 w1u u) = vscale (2 / 3) (vsub (q3 A B C_ E_ u) (p3 A B C_ E_ p0 p0u p1 p1u u)) /\ dot (vsub (q3 A B C_ E_ u) (narrow A B C_ E_ w0 w0u w1 w1u u)) (vsub (q3 A B C_ E_ u) (narrow A B C_ E_ w0 w0u w1 w1u u)) < dot (vsub (q3 A B C_ E_ u) (p3 A B C_ E_ p0 p0u p1 p1u u)) (vsub (q3 A B C_ E_ u) (p3 A B C_ E_ p0 p0u p1 p1u u)).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (u : R) (w0'1 w0'2 w0'3 : R) (w0u'1 w0u'2 w0u'3 : R) (w1'1 w1'2 w1'3 : R) (w1u'1 w1u'2 w1u'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let w0 := [w0'1; w0'2; w0'3] in
  let w0u := [w0u'1; w0u'2; w0u'3] in
  let w1 := [w1'1; w1'2; w1'3] in
  let w1u := [w1u'1; w1u'2; w1u'3] in
  0 < u < 1 /\
  det (cubic_data A B C_ E_) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (cubic_part A B C_ E_ p0 p0u p1 p1u 3%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 2%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 1%Z = zeros 3 /\ cubic_part A B C_ E_ p0 p0u p1 p1u 0%Z = zeros 3) /\
  (narrow_part A B C_ E_ w0 w0u w1 w1u 3%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 2%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 1%Z = zeros 3 /\ narrow_part A B C_ E_ w0 w0u w1 w1u 0%Z = zeros 3).
End ex_3_1_width.

Module ex_3_1_shapes.
(* hermite-developable/ex-3.1.shapes, Sect. 3.1, last paragraph
   printed: the choices of different tangent vectors q_0^u and q_1^u will produce various shapes of the surfaces as presented in Figure (2a) and Figure (2c)
   stated: fails(q2a(u) == q2c(u)) and fails(coefficients([generic(u)], [s]) == 0) and fails(coefficients([generic(u)], [t]) == 0) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend4 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition q3 (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 q1 q0u q1u.
Definition q2a (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  q3 A B C_ E_ u.
Definition q2c (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  hermite3 A B C_ E_ u q0 [- 20; - 65; 40] [0; - 30; - 80] q1u.
Definition blend4_ (w : list R) (a : R) (b : R) (c : R) (d : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d.
Definition hermite3_ (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : R) (b : R) (s : R) (t : R) : R :=
  blend4_ (cubic_basis A B C_ E_ u) a b s t.
Definition generic (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R) : R :=
  hermite3_ A B C_ E_ u a b s t.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R),
  0 < u < 1 ->
  ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  q2a A B C_ E_ u = q2c A B C_ E_ u) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun s => generic A B C_ E_ a b s t u) 1 s]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun t => generic A B C_ E_ a b s t u) 1 t]] = mzeros 1 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (a : R) (b : R) (s : R) (t : R) (u : R),
  0 < u < 1.
End ex_3_1_shapes.
