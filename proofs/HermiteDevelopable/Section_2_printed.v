(* Statements of hermite-developable, Section 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
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
Definition H1 (u : R) : R :=
  - 8 * u ^ 4 + 18 * u ^ 3 - 11 * u ^ 2 + 1.
Definition H2 (u : R) : R :=
  16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2.
Definition H3 (u : R) : R :=
  - 8 * u ^ 4 + 14 * u ^ 3 - 5 * u ^ 2.
Definition H4 (u : R) : R :=
  - 2 * u ^ 4 + 5 * u ^ 3 - 4 * u ^ 2 + u.
Definition quartic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : R :=
  A * u ^ 4 + B * u ^ 3 + C_ * u ^ 2 + E_ * u + F.
Definition quartic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : list (list R) :=
  [[Derive_n (fun A => quartic A B C_ E_ F 0) 1 A; Derive_n (fun B => quartic A B C_ E_ F 0) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 0) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 0) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 0) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F (1 / 2)) 1 A; Derive_n (fun B => quartic A B C_ E_ F (1 / 2)) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F (1 / 2)) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F (1 / 2)) 1 E_; Derive_n (fun F => quartic A B C_ E_ F (1 / 2)) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F 1) 1 A; Derive_n (fun B => quartic A B C_ E_ F 1) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 1) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 1) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 1) 1 F]; [Derive_n (fun A => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 E_; Derive_n (fun F => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 F]; [Derive_n (fun A => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 E_; Derive_n (fun F => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 F]].
Definition quartic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  mvec (transpose (inverse (quartic_data A B C_ E_ F))) [u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend5 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e.
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : R) (m : R) (b : R) (s : R) (t : R) : R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) : R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition H5 (u : R) : R :=
  2 * u ^ 4 - 3 * u ^ 3 + u ^ 2.
Definition quintic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : R :=
  A * u ^ 5 + B * u ^ 4 + C_ * u ^ 3 + E_ * u ^ 2 + F * u + G.
Definition quintic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : list (list R) :=
  [[Derive_n (fun A => quintic A B C_ E_ F G 0) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 0) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 0) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 0) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 0) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 0) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G (1 / 2)) 1 A; Derive_n (fun B => quintic A B C_ E_ F G (1 / 2)) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G (1 / 2)) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G (1 / 2)) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G (1 / 2)) 1 F; Derive_n (fun G => quintic A B C_ E_ F G (1 / 2)) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G 1) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 1) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 1) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 1) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 1) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 1) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 G]].
Definition quintic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [u ^ 5; u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend6 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) (f : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e + entry w 6 * f.
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : R) (m : R) (b : R) (s : R) (r : R) (t : R) : R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
End Definitions.
Import Definitions.

Module sec_2_cubic_conditions.
(* hermite-developable/sec-2.cubic.conditions, Sect. 2, first paragraph
   printed: p_3(u) = a_1 u^3 + b_1 u^2 + c_1 u + d_1 with p_3(0) = p_0, p_3(1) = p_1, p_3^u(0) = p_0^u, p_3^u(1) = p_1^u, u in interval 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(cubic_data) != 0 and p3(0) == p0 and p3(1) == p1 and p3'(0) == p0u and p3'(1) == p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  det (cubic_data A B C_ E_) <> 0 /\ p3 A B C_ E_ p0 p0u p1 p1u 0 = p0 /\ p3 A B C_ E_ p0 p0u p1 p1u 1 = p1 /\ Derive_n (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 0 = p0u /\ Derive_n (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 1 = p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  det (cubic_data A B C_ E_) <> 0.
End sec_2_cubic_conditions.

Module sec_2_cubic_equations.
(* hermite-developable/sec-2.cubic.equations, Sect. 2, first paragraph, four equations
   printed: p_0 = d_1, p_1 = a_1 + b_1 + c_1 + d_1, p_3^u(0) = c_1, p_3^u(1) = 3 a_1 + 2 b_1 + c_1
   stated: cubic(0) == E and cubic(1) == A + B + C + E and cubic'(0) == C and cubic'(1) == 3*A + 2*B + C *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R),
  cubic A B C_ E_ 0 = E_ /\ cubic A B C_ E_ 1 = A + B + C_ + E_ /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = C_ /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = 3 * A + 2 * B + C_.
End sec_2_cubic_equations.

Module sec_2_cubic_a1.
(* hermite-developable/sec-2.cubic.a1, Sect. 2, first paragraph, solution of the system
   printed: a_1 = 2 p_0 - 2 p_1 + p_0^u + p_1^u
   stated: A == 2*p0 - 2*p1 + p0u + p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  A = 2 * p0 - 2 * p1 + p0u + p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End sec_2_cubic_a1.

Module sec_2_cubic_b1.
(* hermite-developable/sec-2.cubic.b1, Sect. 2, first paragraph, solution of the system
   printed: b_1 = -3 p_0 + 3 p_1 - 2 p_0^u - p_1^u
   stated: B == -3*p0 + 3*p1 - 2*p0u - p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  B = - 3 * p0 + 3 * p1 - 2 * p0u - p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End sec_2_cubic_b1.

Module sec_2_cubic_c1.
(* hermite-developable/sec-2.cubic.c1, Sect. 2, first paragraph, solution of the system
   printed: c_1 = p_0^u
   stated: C == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  C_ = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End sec_2_cubic_c1.

Module sec_2_cubic_d1.
(* hermite-developable/sec-2.cubic.d1, Sect. 2, first paragraph, solution of the system
   printed: d_1 = p_0
   stated: E == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  E_ = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End sec_2_cubic_d1.

Module eq_2_1a.
(* hermite-developable/eq-2.1a, Sect. 2, eq. (2.1a)
   printed: p_3(u) = (2 p_0 - 2 p_1 + p_0^u + p_1^u) u^3 + (-3 p_0 + 3 p_1 - 2 p_0^u - p_1^u) u^2 + p_0^u u + p_0
   read as: the copy sets the first p_0 of the u^2 bracket with a letter o as subscript (p_o); read as p_0, since p_o occurs nowhere else and the sentence before has the same bracket with p_0
   stated: cubic(u) == (2*p0 - 2*p1 + p0u + p1u)*u^3 + (-3*p0 + 3*p1 - 2*p0u - p1u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  cubic A B C_ E_ u = (2 * p0 - 2 * p1 + p0u + p1u) * u ^ 3 + (- 3 * p0 + 3 * p1 - 2 * p0u - p1u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End eq_2_1a.

Module eq_2_1b.
(* hermite-developable/eq-2.1b, Sect. 2, unnumbered display after (2.1a); the label (2.1b) stands alone at the end of the section in our copy
   printed: p_3(u) = H_1(u) p_0 + H_2(u) p_1 + H_3(u) p_0^u + H_4(u) p_1^u
   read as: the stray label (2.1b) is taken to belong to this display
   stated: cubic(u) == H1(u)*p0 + H2(u)*p1 + H3(u)*p0u + H4(u)*p1u *)
Definition H1 (u : R) : R :=
  2 * u ^ 3 - 3 * u ^ 2 + 1.
Definition H2 (u : R) : R :=
  - 2 * u ^ 3 + 3 * u ^ 2.
Definition H3 (u : R) : R :=
  u ^ 3 - 2 * u ^ 2 + u.
Definition H4 (u : R) : R :=
  u ^ 3 - u ^ 2.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  cubic A B C_ E_ u = H1 u * p0 + H2 u * p1 + H3 u * p0u + H4 u * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u).
End eq_2_1b.

Module eq_2_1b_H1.
(* hermite-developable/eq-2.1b.H1, Sect. 2, basis functions of (2.1b)
   printed: H_1(u) = 2 u^3 - 3 u^2 + 1
   stated: coefficients([cubic(u)], [p0])[1,1] == 2*u^3 - 3*u^2 + 1 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  A_of_p0 p0 = A ->
  B_of_p0 p0 = B ->
  C__of_p0 p0 = C_ ->
  E__of_p0 p0 = E_ ->
  (forall p0 : R, cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) 0 = p0 /\ cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p0 => cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 p0]] 1) 1 = 2 * u ^ 3 - 3 * u ^ 2 + 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u) /\
  A_of_p0 p0 = A /\
  B_of_p0 p0 = B /\
  C__of_p0 p0 = C_ /\
  E__of_p0 p0 = E_ /\
  (forall p0 : R, cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) 0 = p0 /\ cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 1 = p1u).
End eq_2_1b_H1.

Module eq_2_1b_H2.
(* hermite-developable/eq-2.1b.H2, Sect. 2, basis functions of (2.1b)
   printed: H_2(u) = -2 u^3 + 3 u^2
   stated: coefficients([cubic(u)], [p1])[1,1] == -2*u^3 + 3*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  A_of_p1 p1 = A ->
  B_of_p1 p1 = B ->
  C__of_p1 p1 = C_ ->
  E__of_p1 p1 = E_ ->
  (forall p1 : R, cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) 0 = p0 /\ cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p1 => cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 p1]] 1) 1 = - 2 * u ^ 3 + 3 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u) /\
  A_of_p1 p1 = A /\
  B_of_p1 p1 = B /\
  C__of_p1 p1 = C_ /\
  E__of_p1 p1 = E_ /\
  (forall p1 : R, cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) 0 = p0 /\ cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 1 = p1u).
End eq_2_1b_H2.

Module eq_2_1b_H3.
(* hermite-developable/eq-2.1b.H3, Sect. 2, basis functions of (2.1b)
   printed: H_3(u) = u^3 - 2 u^2 + u
   stated: coefficients([cubic(u)], [p0u])[1,1] == u^3 - 2*u^2 + u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  A_of_p0u p0u = A ->
  B_of_p0u p0u = B ->
  C__of_p0u p0u = C_ ->
  E__of_p0u p0u = E_ ->
  (forall p0u : R, cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) 0 = p0 /\ cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p0u => cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 p0u]] 1) 1 = u ^ 3 - 2 * u ^ 2 + u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u) /\
  A_of_p0u p0u = A /\
  B_of_p0u p0u = B /\
  C__of_p0u p0u = C_ /\
  E__of_p0u p0u = E_ /\
  (forall p0u : R, cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) 0 = p0 /\ cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 1 = p1u).
End eq_2_1b_H3.

Module eq_2_1b_H4.
(* hermite-developable/eq-2.1b.H4, Sect. 2, basis functions of (2.1b)
   printed: H_4(u) = u^3 - u^2
   stated: coefficients([cubic(u)], [p1u])[1,1] == u^3 - u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R),
  0 < u < 1 ->
  cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u ->
  A_of_p1u p1u = A ->
  B_of_p1u p1u = B ->
  C__of_p1u p1u = C_ ->
  E__of_p1u p1u = E_ ->
  (forall p1u : R, cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) 0 = p0 /\ cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p1u => cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 p1u]] 1) 1 = u ^ 3 - u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R),
  0 < u < 1 /\
  (cubic A B C_ E_ 0 = p0 /\ cubic A B C_ E_ 1 = p1 /\ Derive_n (fun u => cubic A B C_ E_ u) 1 0 = p0u /\ Derive_n (fun u => cubic A B C_ E_ u) 1 1 = p1u) /\
  A_of_p1u p1u = A /\
  B_of_p1u p1u = B /\
  C__of_p1u p1u = C_ /\
  E__of_p1u p1u = E_ /\
  (forall p1u : R, cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) 0 = p0 /\ cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) 1 = p1 /\ Derive_n (fun u => cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 0 = p0u /\ Derive_n (fun u => cubic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 1 = p1u).
End eq_2_1b_H4.

Module sec_2_quartic_conditions.
(* hermite-developable/sec-2.quartic.conditions, Sect. 2, paragraph on the quartic
   printed: p_4(u) = a_1 u^4 + b_1 u^3 + c_1 u^2 + d_1 u + e_1 with p_4(0) = p_0, p_4(0.5) = p, p_4(1) = p_1, p_4^u(0) = p_0^u, p_4^u(1) = p_1^u, 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(quartic_data) != 0 and p4(0) == p0 and p4(1/2) == pm and p4(1) == p1 and p4'(0) == p0u and p4'(1) == p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  det (quartic_data A B C_ E_ F) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 /\ p4 A B C_ E_ F p0 p0u p1 p1u pm 0 = p0 /\ p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2) = pm /\ p4 A B C_ E_ F p0 p0u p1 p1u pm 1 = p1 /\ Derive_n (fun u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 0 = p0u /\ Derive_n (fun u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 1 = p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  det (quartic_data A B C_ E_ F) <> 0.
End sec_2_quartic_conditions.

Module sec_2_quartic_solvable.
(* hermite-developable/sec-2.quartic.solvable, Sect. 2, paragraph on the quartic
   printed: It gives five equations with the solutions for the coefficient vectors
   stated: det(quartic_data) != 0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R),
  det (quartic_data A B C_ E_ F) <> 0.
End sec_2_quartic_solvable.

Module sec_2_quartic_a1.
(* hermite-developable/sec-2.quartic.a1, Sect. 2, quartic coefficient vectors, first
   printed: a_1 = -8 p_1 - 8 p_0 + 16 p + 2 p_1^u - 2 p_0^u
   stated: A == -8*p1 - 8*p0 + 16*pm + 2*p1u - 2*p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A = - 8 * p1 - 8 * p0 + 16 * pm + 2 * p1u - 2 * p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End sec_2_quartic_a1.

Module sec_2_quartic_b1.
(* hermite-developable/sec-2.quartic.b1, Sect. 2, quartic coefficient vectors, second
   printed: b_1 = 14 p_1 + 18 p_0 - 32 p - 3 p_1^u + 5 p_0^u
   stated: B == 14*p1 + 18*p0 - 32*pm - 3*p1u + 5*p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  B = 14 * p1 + 18 * p0 - 32 * pm - 3 * p1u + 5 * p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End sec_2_quartic_b1.

Module sec_2_quartic_third.
(* hermite-developable/sec-2.quartic.third, Sect. 2, quartic coefficient vectors, third (first of the displayed line)
   printed: e_1 = -5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u
   stated: -5*p1 - 11*p0 + 16*pm + p1u - 4*p0u == F *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  - 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u = F.
End sec_2_quartic_third.

Module sec_2_quartic_third_corrected.
(* hermite-developable/sec-2.quartic.third (corrected), Sect. 2, quartic coefficient vectors, third (first of the displayed line)
   printed: e_1 = -5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u
   stated: -5*p1 - 11*p0 + 16*pm + p1u - 4*p0u == C *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  - 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u = C_.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End sec_2_quartic_third_corrected.

Module sec_2_quartic_d1.
(* hermite-developable/sec-2.quartic.d1, Sect. 2, quartic coefficient vectors, fourth
   printed: d_1 = p_0^u
   stated: E == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  E_ = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End sec_2_quartic_d1.

Module sec_2_quartic_e1.
(* hermite-developable/sec-2.quartic.e1, Sect. 2, quartic coefficient vectors, fifth
   printed: e_1 = p_0
   stated: F == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  F = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End sec_2_quartic_e1.

Module eq_2_2.
(* hermite-developable/eq-2.2, Sect. 2, eq. (2.2)
   printed: p_4(u) = (-8 p_1 - 8 p_0 + 16 p + 2 p_1^u - 2 p_0^u) u^4 + (14 p_1 + 18 p_0 - 32 p - 3 p_1^u + 5 p_0^u) u^3 + (-5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u) u^2 + p_0^u u + p_0
   stated: quartic(u) == (-8*p1 - 8*p0 + 16*pm + 2*p1u - 2*p0u)*u^4 + (14*p1 + 18*p0 - 32*pm - 3*p1u + 5*p0u)*u^3 + (-5*p1 - 11*p0 + 16*pm + p1u - 4*p0u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  quartic A B C_ E_ F u = (- 8 * p1 - 8 * p0 + 16 * pm + 2 * p1u - 2 * p0u) * u ^ 4 + (14 * p1 + 18 * p0 - 32 * pm - 3 * p1u + 5 * p0u) * u ^ 3 + (- 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End eq_2_2.

Module eq_2_3.
(* hermite-developable/eq-2.3, Sect. 2, eq. (2.3)
   printed: p_4(u) = H_1(u) p_0 + H_2(u) p_1 + H_3(u) p_1 + H_4(u) p_0^u + H_5(u) p_1^u
   stated: quartic(u) == H1(u)*p0 + H2(u)*p1 + H3(u)*p1 + H4(u)*p0u + H5(u)*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  quartic A B C_ E_ F u = H1 u * p0 + H2 u * p1 + H3 u * p1 + H4 u * p0u + H5 u * p1u.
End eq_2_3.

Module eq_2_3_corrected.
(* hermite-developable/eq-2.3 (corrected), Sect. 2, eq. (2.3)
   printed: p_4(u) = H_1(u) p_0 + H_2(u) p_1 + H_3(u) p_1 + H_4(u) p_0^u + H_5(u) p_1^u
   stated: quartic(u) == H1(u)*p0 + H2(u)*pm + H3(u)*p1 + H4(u)*p0u + H5(u)*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  quartic A B C_ E_ F u = H1 u * p0 + H2 u * pm + H3 u * p1 + H4 u * p0u + H5 u * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u).
End eq_2_3_corrected.

Module eq_2_3_H1.
(* hermite-developable/eq-2.3.H1, Sect. 2, basis functions of (2.3)
   printed: H_1(u) = -8 u^4 + 18 u^3 - 11 u^2 + 1
   stated: coefficients([quartic(u)], [p0])[1,1] == -8*u^4 + 18*u^3 - 11*u^2 + 1 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R) (F_of_p0 : R -> R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A_of_p0 p0 = A ->
  B_of_p0 p0 = B ->
  C__of_p0 p0 = C_ ->
  E__of_p0 p0 = E_ ->
  F_of_p0 p0 = F ->
  (forall p0 : R, quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) 0 = p0 /\ quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) (1 / 2) = pm /\ quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p0 => quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 p0]] 1) 1 = - 8 * u ^ 4 + 18 * u ^ 3 - 11 * u ^ 2 + 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R) (F_of_p0 : R -> R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u) /\
  A_of_p0 p0 = A /\
  B_of_p0 p0 = B /\
  C__of_p0 p0 = C_ /\
  E__of_p0 p0 = E_ /\
  F_of_p0 p0 = F /\
  (forall p0 : R, quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) 0 = p0 /\ quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) (1 / 2) = pm /\ quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 1 = p1u).
End eq_2_3_H1.

Module eq_2_3_H2.
(* hermite-developable/eq-2.3.H2, Sect. 2, basis functions of (2.3)
   printed: H_2(u) = 16 u^4 - 32 u^3 + 16 u^2
   stated: coefficients([quartic(u)], [pm])[1,1] == 16*u^4 - 32*u^3 + 16*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_pm : R -> R) (B_of_pm : R -> R) (C__of_pm : R -> R) (E__of_pm : R -> R) (F_of_pm : R -> R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A_of_pm pm = A ->
  B_of_pm pm = B ->
  C__of_pm pm = C_ ->
  E__of_pm pm = E_ ->
  F_of_pm pm = F ->
  (forall pm : R, quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) 0 = p0 /\ quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) (1 / 2) = pm /\ quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) 1 = p1 /\ Derive_n (fun u => quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun pm => quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 pm]] 1) 1 = 16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_pm : R -> R) (B_of_pm : R -> R) (C__of_pm : R -> R) (E__of_pm : R -> R) (F_of_pm : R -> R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u) /\
  A_of_pm pm = A /\
  B_of_pm pm = B /\
  C__of_pm pm = C_ /\
  E__of_pm pm = E_ /\
  F_of_pm pm = F /\
  (forall pm : R, quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) 0 = p0 /\ quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) (1 / 2) = pm /\ quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) 1 = p1 /\ Derive_n (fun u => quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 1 = p1u).
End eq_2_3_H2.

Module eq_2_3_H3.
(* hermite-developable/eq-2.3.H3, Sect. 2, basis functions of (2.3)
   printed: H_3(u) = -8 u^4 + 14 u^3 - 5 u^2
   stated: coefficients([quartic(u)], [p1])[1,1] == -8*u^4 + 14*u^3 - 5*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R) (F_of_p1 : R -> R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A_of_p1 p1 = A ->
  B_of_p1 p1 = B ->
  C__of_p1 p1 = C_ ->
  E__of_p1 p1 = E_ ->
  F_of_p1 p1 = F ->
  (forall p1 : R, quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) 0 = p0 /\ quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) (1 / 2) = pm /\ quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p1 => quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 p1]] 1) 1 = - 8 * u ^ 4 + 14 * u ^ 3 - 5 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R) (F_of_p1 : R -> R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u) /\
  A_of_p1 p1 = A /\
  B_of_p1 p1 = B /\
  C__of_p1 p1 = C_ /\
  E__of_p1 p1 = E_ /\
  F_of_p1 p1 = F /\
  (forall p1 : R, quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) 0 = p0 /\ quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) (1 / 2) = pm /\ quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 1 = p1u).
End eq_2_3_H3.

Module eq_2_3_H4.
(* hermite-developable/eq-2.3.H4, Sect. 2, basis functions of (2.3)
   printed: H_4(u) = -2 u^4 + 5 u^3 - 4 u^2 + u
   stated: coefficients([quartic(u)], [p0u])[1,1] == -2*u^4 + 5*u^3 - 4*u^2 + u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R) (F_of_p0u : R -> R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A_of_p0u p0u = A ->
  B_of_p0u p0u = B ->
  C__of_p0u p0u = C_ ->
  E__of_p0u p0u = E_ ->
  F_of_p0u p0u = F ->
  (forall p0u : R, quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) 0 = p0 /\ quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) (1 / 2) = pm /\ quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p0u => quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 p0u]] 1) 1 = - 2 * u ^ 4 + 5 * u ^ 3 - 4 * u ^ 2 + u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R) (F_of_p0u : R -> R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u) /\
  A_of_p0u p0u = A /\
  B_of_p0u p0u = B /\
  C__of_p0u p0u = C_ /\
  E__of_p0u p0u = E_ /\
  F_of_p0u p0u = F /\
  (forall p0u : R, quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) 0 = p0 /\ quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) (1 / 2) = pm /\ quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 1 = p1u).
End eq_2_3_H4.

Module eq_2_3_H5.
(* hermite-developable/eq-2.3.H5, Sect. 2, basis functions of (2.3)
   printed: H_5(u) = 2 u^4 - 3 u^3 + u^2
   stated: coefficients([quartic(u)], [p1u])[1,1] == 2*u^4 - 3*u^3 + u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R) (F_of_p1u : R -> R),
  0 < u < 1 ->
  quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u ->
  A_of_p1u p1u = A ->
  B_of_p1u p1u = B ->
  C__of_p1u p1u = C_ ->
  E__of_p1u p1u = E_ ->
  F_of_p1u p1u = F ->
  (forall p1u : R, quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) 0 = p0 /\ quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) (1 / 2) = pm /\ quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 1 = p1u) ->
  entry (row [[Derive_n (fun p1u => quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 p1u]] 1) 1 = 2 * u ^ 4 - 3 * u ^ 3 + u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R) (F_of_p1u : R -> R),
  0 < u < 1 /\
  (quartic A B C_ E_ F 0 = p0 /\ quartic A B C_ E_ F (1 / 2) = pm /\ quartic A B C_ E_ F 1 = p1 /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 0 = p0u /\ Derive_n (fun u => quartic A B C_ E_ F u) 1 1 = p1u) /\
  A_of_p1u p1u = A /\
  B_of_p1u p1u = B /\
  C__of_p1u p1u = C_ /\
  E__of_p1u p1u = E_ /\
  F_of_p1u p1u = F /\
  (forall p1u : R, quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) 0 = p0 /\ quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) (1 / 2) = pm /\ quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) 1 = p1 /\ Derive_n (fun u => quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 0 = p0u /\ Derive_n (fun u => quartic (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 1 = p1u).
End eq_2_3_H5.

Module sec_2_quintic_conditions.
(* hermite-developable/sec-2.quintic.conditions, Sect. 2, paragraph on the quintic
   printed: p_5(u) = a_1 u^5 + b_1 u^4 + c_1 u^3 + d_1 u^2 + e_1 u + f_1 with p_5(0) = P_0, p_5(0.5) = p, p_5(1) = p_1, p_5^u(0) = p_0^u, p_5^u(0.5) = p^u, p_5^u(1) = p_1^u in interval 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(quintic_data) != 0 and p5(0) == p0 and p5(1/2) == pm and p5(1) == p1 and p5'(0) == p0u and p5'(1/2) == pu and p5'(1) == p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 /\ p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0 = p0 /\ p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2) = pm /\ p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1 = p1 /\ Derive_n (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 0 = p0u /\ Derive_n (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 (1 / 2) = pu /\ Derive_n (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 1 = p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  det (quintic_data A B C_ E_ F G) <> 0.
End sec_2_quintic_conditions.

Module sec_2_quintic_a1.
(* hermite-developable/sec-2.quintic.a1, Sect. 2, quintic coefficient vectors, first
   printed: a_1 = -24 p_1 + 24 p_0 + 16 p^u + 4 p_0^u + 4 p_1^u
   stated: A == -24*p1 + 24*p0 + 16*pu + 4*p0u + 4*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  A = - 24 * p1 + 24 * p0 + 16 * pu + 4 * p0u + 4 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_a1.

Module sec_2_quintic_b1.
(* hermite-developable/sec-2.quintic.b1, Sect. 2, quintic coefficient vectors, second
   printed: b_1 = 52 p_1 - 68 p_0 + 16 p - 40 p^u - 12 p_0^u - 8 p_1^u
   stated: B == 52*p1 - 68*p0 + 16*pm - 40*pu - 12*p0u - 8*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  B = 52 * p1 - 68 * p0 + 16 * pm - 40 * pu - 12 * p0u - 8 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_b1.

Module sec_2_quintic_c1.
(* hermite-developable/sec-2.quintic.c1, Sect. 2, quintic coefficient vectors, third
   printed: c_1 = -34 p_1 + 66 p_0 - 32 p + 32 p^u + 13 p_0^u + 5 p_1^u
   stated: C == -34*p1 + 66*p0 - 32*pm + 32*pu + 13*p0u + 5*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  C_ = - 34 * p1 + 66 * p0 - 32 * pm + 32 * pu + 13 * p0u + 5 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_c1.

Module sec_2_quintic_d1.
(* hermite-developable/sec-2.quintic.d1, Sect. 2, quintic coefficient vectors, fourth
   printed: d_1 = 7 p_1 - 23 p_0 + 16 p - 8 p^u - 6 p_0^u - 1 p_1^u
   stated: E == 7*p1 - 23*p0 + 16*pm - 8*pu - 6*p0u - 1*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  E_ = 7 * p1 - 23 * p0 + 16 * pm - 8 * pu - 6 * p0u - 1 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_d1.

Module sec_2_quintic_e1.
(* hermite-developable/sec-2.quintic.e1, Sect. 2, quintic coefficient vectors, fifth
   printed: e_1 = p_0^u
   stated: F == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  F = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_e1.

Module sec_2_quintic_f1.
(* hermite-developable/sec-2.quintic.f1, Sect. 2, quintic coefficient vectors, sixth
   printed: f_1 = P_0
   read as: P_0 (capital, also in the condition p_5(0) = P_0) is taken as the same point as p_0
   stated: G == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  G = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End sec_2_quintic_f1.

Module eq_2_4.
(* hermite-developable/eq-2.4, Sect. 2, eq. (2.4)
   printed: p_5(u) = (-24 p_1 + 24 p_0 + 16 p^u + 4 p_0^u + 4 p_1^u) u^5 + (52 p_1 - 68 p_0 + 16 p - 40 p^u - 12 p_0^u - 8 p_1^u) u^4 + (-34 p_1 + 66 p_0 - 32 p + 32 p^u + 13 p_0^u + 5 p_1^u) u^3 + (7 p_1 - 23 p_0 + 16 p - 8 p^u - 6 p_0^u - p_1^u) u^2 + (p_0^u) u + p_0
   stated: quintic(u) == (-24*p1 + 24*p0 + 16*pu + 4*p0u + 4*p1u)*u^5 + (52*p1 - 68*p0 + 16*pm - 40*pu - 12*p0u - 8*p1u)*u^4 + (-34*p1 + 66*p0 - 32*pm + 32*pu + 13*p0u + 5*p1u)*u^3 + (7*p1 - 23*p0 + 16*pm - 8*pu - 6*p0u - p1u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u ->
  quintic A B C_ E_ F G u = (- 24 * p1 + 24 * p0 + 16 * pu + 4 * p0u + 4 * p1u) * u ^ 5 + (52 * p1 - 68 * p0 + 16 * pm - 40 * pu - 12 * p0u - 8 * p1u) * u ^ 4 + (- 34 * p1 + 66 * p0 - 32 * pm + 32 * pu + 13 * p0u + 5 * p1u) * u ^ 3 + (7 * p1 - 23 * p0 + 16 * pm - 8 * pu - 6 * p0u - p1u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 /\
  (quintic A B C_ E_ F G 0 = p0 /\ quintic A B C_ E_ F G (1 / 2) = pm /\ quintic A B C_ E_ F G 1 = p1 /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 0 = p0u /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2) = pu /\ Derive_n (fun u => quintic A B C_ E_ F G u) 1 1 = p1u).
End eq_2_4.

Module sec_2_control.
(* hermite-developable/sec-2.control, Sect. 2, sentence after (2.4)
   printed: Arranging the position of these curves in space can use the control points p_0, p, and p_1 meanwhile, the shapes of the curves can be designed by the tangent vectors p_0^u, p^u, and p_1^u at these control points, respectively
   read as: the cubic has the points p_0, p_1 and the tangent vectors at them, the quartic p besides, the quintic all six
   stated: coefficients([p3(0), p3(1)], [p0, p1]) == identity(2) and coefficients([p4(0), p4(1/2), p4(1)], [p0, pm, p1]) == identity(3) and coefficients([p5(0), p5(1/2), p5(1)], [p0, pm, p1]) == identity(3) and coefficients([p3(0), p3(1)], [p0u, p1u]) == 0 and coefficients([p4(0), p4(1/2), p4(1)], [p0u, p1u]) == 0 and coefficients([p5(0), p5(1/2), p5(1)], [p0u, pu, p1u]) == 0 and fails(coefficients([p3(u)], [p0u]) == 0) and fails(coefficients([p3(u)], [p1u]) == 0) and fails(coefficients([p4(u)], [p0u]) == 0) and fails(coefficients([p4(u)], [p1u]) == 0) and fails(coefficients([p5(u)], [p0u]) == 0) and fails(coefficients([p5(u)], [pu]) == 0) and fails(coefficients([p5(u)], [p1u]) == 0) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p0 => p3 A B C_ E_ p0 p0u p1 p1u 0) 1 p0; Derive_n (fun p1 => p3 A B C_ E_ p0 p0u p1 p1u 0) 1 p1]; [Derive_n (fun p0 => p3 A B C_ E_ p0 p0u p1 p1u 1) 1 p0; Derive_n (fun p1 => p3 A B C_ E_ p0 p0u p1 p1u 1) 1 p1]] = identity 2 /\ [[Derive_n (fun p0 => p4 A B C_ E_ F p0 p0u p1 p1u pm 0) 1 p0; Derive_n (fun pm => p4 A B C_ E_ F p0 p0u p1 p1u pm 0) 1 pm; Derive_n (fun p1 => p4 A B C_ E_ F p0 p0u p1 p1u pm 0) 1 p1]; [Derive_n (fun p0 => p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p0; Derive_n (fun pm => p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 pm; Derive_n (fun p1 => p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p1]; [Derive_n (fun p0 => p4 A B C_ E_ F p0 p0u p1 p1u pm 1) 1 p0; Derive_n (fun pm => p4 A B C_ E_ F p0 p0u p1 p1u pm 1) 1 pm; Derive_n (fun p1 => p4 A B C_ E_ F p0 p0u p1 p1u pm 1) 1 p1]] = identity 3 /\ [[Derive_n (fun p0 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 p0; Derive_n (fun pm => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 pm; Derive_n (fun p1 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 p1]; [Derive_n (fun p0 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p0; Derive_n (fun pm => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 pm; Derive_n (fun p1 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p1]; [Derive_n (fun p0 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 p0; Derive_n (fun pm => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 pm; Derive_n (fun p1 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 p1]] = identity 3 /\ [[Derive_n (fun p0u => p3 A B C_ E_ p0 p0u p1 p1u 0) 1 p0u; Derive_n (fun p1u => p3 A B C_ E_ p0 p0u p1 p1u 0) 1 p1u]; [Derive_n (fun p0u => p3 A B C_ E_ p0 p0u p1 p1u 1) 1 p0u; Derive_n (fun p1u => p3 A B C_ E_ p0 p0u p1 p1u 1) 1 p1u]] = mzeros 2 2 /\ [[Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm 0) 1 p0u; Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm 0) 1 p1u]; [Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p0u; Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p1u]; [Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm 1) 1 p0u; Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm 1) 1 p1u]] = mzeros 3 2 /\ [[Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 p0u; Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 pu; Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0) 1 p1u]; [Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p0u; Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 pu; Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p1u]; [Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 p0u; Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 pu; Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1) 1 p1u]] = mzeros 3 3 /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun p0u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun p1u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 p1u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  [[Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  [[Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 p1u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 pu]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 p1u]] = mzeros 1 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 /\
  det (cubic_data A B C_ E_) <> 0 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
  det (quintic_data A B C_ E_ F G) <> 0.
End sec_2_control.

Module fig_1b_middle.
(* hermite-developable/fig-1b.middle, Sect. 2, last paragraph
   printed: It shows that this tangent vector p^u changes the shape of the curve in the middle part
   stated: fig1b(0) == fig1a(0) and fig1b'(0) == fig1a'(0) and fig1b(1) == fig1a(1) and fig1b'(1) == fig1a'(1) and fig1b(u) - fig1a(u) == 8*u^2*(1 - u)^2*(2*u - 1)*([60, 5, 60] - fig1a'(1/2)) and fails(fig1b'(1/2) == fig1a'(1/2)) *)
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition fig1b (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [60; 5; 60] [10; - 60; 80].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition fig1a (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  hermite4 A B C_ E_ F u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [10; - 60; 80].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  fig1b A B C_ E_ F G 0 = fig1a A B C_ E_ F 0 /\ vDerive 3 (fun u => fig1b A B C_ E_ F G u) 1 0 = vDerive 3 (fun u => fig1a A B C_ E_ F u) 1 0 /\ fig1b A B C_ E_ F G 1 = fig1a A B C_ E_ F 1 /\ vDerive 3 (fun u => fig1b A B C_ E_ F G u) 1 1 = vDerive 3 (fun u => fig1a A B C_ E_ F u) 1 1 /\ vsub (fig1b A B C_ E_ F G u) (fig1a A B C_ E_ F u) = vscale (8 * u ^ 2 * (1 - u) ^ 2 * (2 * u - 1)) (vsub [60; 5; 60] (vDerive 3 (fun u => fig1a A B C_ E_ F u) 1 (1 / 2))) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  vDerive 3 (fun u => fig1b A B C_ E_ F G u) 1 (1 / 2) = vDerive 3 (fun u => fig1a A B C_ E_ F u) 1 (1 / 2)).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  det (quartic_data A B C_ E_ F) <> 0.
End fig_1b_middle.
