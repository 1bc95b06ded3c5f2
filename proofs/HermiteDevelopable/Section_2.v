(* Statements of hermite-developable, Section 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition cubic (A : R) (B : R) (C_ : R) (E_ : R) (u : Z) : R :=
  A * IZR u ^ 3 + B * IZR u ^ 2 + C_ * IZR u + E_.
Definition cubic_ (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : R :=
  A * u ^ 3 + B * u ^ 2 + C_ * u + E_.
Definition cubic_data (A : R) (B : R) (C_ : R) (E_ : R) : list (list R) :=
  [[Derive_n (fun A => cubic A B C_ E_ 0%Z) 1 A; Derive_n (fun B => cubic A B C_ E_ 0%Z) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 0%Z) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 0%Z) 1 E_]; [Derive_n (fun A => cubic A B C_ E_ 1%Z) 1 A; Derive_n (fun B => cubic A B C_ E_ 1%Z) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 1%Z) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 1%Z) 1 E_]; [Derive_n (fun A => let u := 0%Z in Derive_n (fun u_ => cubic_ A B C_ E_ u_) 1 (IZR u)) 1 A; Derive_n (fun B => let u_ := 0%Z in Derive_n (fun u__ => cubic_ A B C_ E_ u__) 1 (IZR u_)) 1 B; Derive_n (fun C_ => let u__ := 0%Z in Derive_n (fun u___ => cubic_ A B C_ E_ u___) 1 (IZR u__)) 1 C_; Derive_n (fun E_ => let u___ := 0%Z in Derive_n (fun u____ => cubic_ A B C_ E_ u____) 1 (IZR u___)) 1 E_]; [Derive_n (fun A => let u____ := 1%Z in Derive_n (fun u_____ => cubic_ A B C_ E_ u_____) 1 (IZR u____)) 1 A; Derive_n (fun B => let u_____ := 1%Z in Derive_n (fun u______ => cubic_ A B C_ E_ u______) 1 (IZR u_____)) 1 B; Derive_n (fun C_ => let u______ := 1%Z in Derive_n (fun u_______ => cubic_ A B C_ E_ u_______) 1 (IZR u______)) 1 C_; Derive_n (fun E_ => let u_______ := 1%Z in Derive_n (fun u________ => cubic_ A B C_ E_ u________) 1 (IZR u_______)) 1 E_]].
Definition cubic_basis (A : R) (B : R) (C_ : R) (E_ : R) (u : Z) : list R :=
  mvec (transpose (inverse (cubic_data A B C_ E_))) [IZR u ^ 3; IZR u ^ 2; IZR u; 1].
Definition cubic_basis_ (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  mvec (transpose (inverse (cubic_data A B C_ E_))) [u ^ 3; u ^ 2; u; 1].
Definition blend4 (w : list R) (a : R) (b : R) (c : R) (d : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d.
Definition hermite3 (A : R) (B : R) (C_ : R) (E_ : R) (u : Z) (a : R) (b : R) (s : R) (t : R) : R :=
  blend4 (cubic_basis A B C_ E_ u) a b s t.
Definition p3 (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : Z) : R :=
  hermite3 A B C_ E_ u p0 p1 p0u p1u.
Definition cubic_conditions (A : R) (B : R) (C_ : R) (E_ : R) : R :=
  cubic A B C_ E_ 0%Z.
Definition cubic_conditions_ (p0 : R) : R :=
  p0.
Definition cubic_conditions__ (A : R) (B : R) (C_ : R) (E_ : R) : R :=
  cubic A B C_ E_ 1%Z.
Definition cubic_conditions___ (p1 : R) : R :=
  p1.
Definition cubic_conditions____ (A : R) (B : R) (C_ : R) (E_ : R) : R :=
  let u := 0%Z in Derive_n (fun u_ => cubic_ A B C_ E_ u_) 1 (IZR u).
Definition cubic_conditions_____ (p0u : R) : R :=
  p0u.
Definition cubic_conditions______ (A : R) (B : R) (C_ : R) (E_ : R) : R :=
  let u := 1%Z in Derive_n (fun u_ => cubic_ A B C_ E_ u_) 1 (IZR u).
Definition cubic_conditions_______ (p1u : R) : R :=
  p1u.
Definition H1 (u : R) : R :=
  - 8 * u ^ 4 + 18 * u ^ 3 - 11 * u ^ 2 + 1.
Definition H2 (u : R) : R :=
  16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2.
Definition H3 (u : R) : R :=
  - 8 * u ^ 4 + 14 * u ^ 3 - 5 * u ^ 2.
Definition H4 (u : R) : R :=
  - 2 * u ^ 4 + 5 * u ^ 3 - 4 * u ^ 2 + u.
Definition quartic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) : R :=
  A * IZR u ^ 4 + B * IZR u ^ 3 + C_ * IZR u ^ 2 + E_ * IZR u + F.
Definition quartic_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : R :=
  A * u ^ 4 + B * u ^ 3 + C_ * u ^ 2 + E_ * u + F.
Definition quartic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : list (list R) :=
  [[Derive_n (fun A => quartic A B C_ E_ F 0%Z) 1 A; Derive_n (fun B => quartic A B C_ E_ F 0%Z) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 0%Z) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 0%Z) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 0%Z) 1 F]; [Derive_n (fun A => quartic_ A B C_ E_ F (1 / 2)) 1 A; Derive_n (fun B => quartic_ A B C_ E_ F (1 / 2)) 1 B; Derive_n (fun C_ => quartic_ A B C_ E_ F (1 / 2)) 1 C_; Derive_n (fun E_ => quartic_ A B C_ E_ F (1 / 2)) 1 E_; Derive_n (fun F => quartic_ A B C_ E_ F (1 / 2)) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F 1%Z) 1 A; Derive_n (fun B => quartic A B C_ E_ F 1%Z) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 1%Z) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 1%Z) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 1%Z) 1 F]; [Derive_n (fun A => let u := 0%Z in Derive_n (fun u_ => quartic_ A B C_ E_ F u_) 1 (IZR u)) 1 A; Derive_n (fun B => let u_ := 0%Z in Derive_n (fun u__ => quartic_ A B C_ E_ F u__) 1 (IZR u_)) 1 B; Derive_n (fun C_ => let u__ := 0%Z in Derive_n (fun u___ => quartic_ A B C_ E_ F u___) 1 (IZR u__)) 1 C_; Derive_n (fun E_ => let u___ := 0%Z in Derive_n (fun u____ => quartic_ A B C_ E_ F u____) 1 (IZR u___)) 1 E_; Derive_n (fun F => let u____ := 0%Z in Derive_n (fun u_____ => quartic_ A B C_ E_ F u_____) 1 (IZR u____)) 1 F]; [Derive_n (fun A => let u_____ := 1%Z in Derive_n (fun u______ => quartic_ A B C_ E_ F u______) 1 (IZR u_____)) 1 A; Derive_n (fun B => let u______ := 1%Z in Derive_n (fun u_______ => quartic_ A B C_ E_ F u_______) 1 (IZR u______)) 1 B; Derive_n (fun C_ => let u_______ := 1%Z in Derive_n (fun u________ => quartic_ A B C_ E_ F u________) 1 (IZR u_______)) 1 C_; Derive_n (fun E_ => let u________ := 1%Z in Derive_n (fun u_________ => quartic_ A B C_ E_ F u_________) 1 (IZR u________)) 1 E_; Derive_n (fun F => let u_________ := 1%Z in Derive_n (fun u__________ => quartic_ A B C_ E_ F u__________) 1 (IZR u_________)) 1 F]].
Definition quartic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) : list R :=
  mvec (transpose (inverse (quartic_data A B C_ E_ F))) [IZR u ^ 4; IZR u ^ 3; IZR u ^ 2; IZR u; 1].
Definition quartic_basis_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  mvec (transpose (inverse (quartic_data A B C_ E_ F))) [u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend5 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e.
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) (a : R) (m : R) (b : R) (s : R) (t : R) : R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : Z) : R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition hermite4_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : R) (m : R) (b : R) (s : R) (t : R) : R :=
  blend5 (quartic_basis_ A B C_ E_ F u) a m b s t.
Definition p4_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) : R :=
  hermite4_ A B C_ E_ F u p0 pm p1 p0u p1u.
Definition quartic_conditions (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : R :=
  quartic A B C_ E_ F 0%Z.
Definition quartic_conditions_ (p0 : R) : R :=
  p0.
Definition quartic_conditions__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : R :=
  quartic_ A B C_ E_ F (1 / 2).
Definition quartic_conditions___ (pm : R) : R :=
  pm.
Definition quartic_conditions____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : R :=
  quartic A B C_ E_ F 1%Z.
Definition quartic_conditions_____ (p1 : R) : R :=
  p1.
Definition quartic_conditions______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : R :=
  let u := 0%Z in Derive_n (fun u_ => quartic_ A B C_ E_ F u_) 1 (IZR u).
Definition quartic_conditions_______ (p0u : R) : R :=
  p0u.
Definition quartic_conditions________ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : R :=
  let u := 1%Z in Derive_n (fun u_ => quartic_ A B C_ E_ F u_) 1 (IZR u).
Definition quartic_conditions_________ (p1u : R) : R :=
  p1u.
Definition H5 (u : R) : R :=
  2 * u ^ 4 - 3 * u ^ 3 + u ^ 2.
Definition quintic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) : R :=
  A * IZR u ^ 5 + B * IZR u ^ 4 + C_ * IZR u ^ 3 + E_ * IZR u ^ 2 + F * IZR u + G.
Definition quintic_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : R :=
  A * u ^ 5 + B * u ^ 4 + C_ * u ^ 3 + E_ * u ^ 2 + F * u + G.
Definition quintic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : list (list R) :=
  [[Derive_n (fun A => quintic A B C_ E_ F G 0%Z) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 0%Z) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 0%Z) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 0%Z) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 0%Z) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 0%Z) 1 G]; [Derive_n (fun A => quintic_ A B C_ E_ F G (1 / 2)) 1 A; Derive_n (fun B => quintic_ A B C_ E_ F G (1 / 2)) 1 B; Derive_n (fun C_ => quintic_ A B C_ E_ F G (1 / 2)) 1 C_; Derive_n (fun E_ => quintic_ A B C_ E_ F G (1 / 2)) 1 E_; Derive_n (fun F => quintic_ A B C_ E_ F G (1 / 2)) 1 F; Derive_n (fun G => quintic_ A B C_ E_ F G (1 / 2)) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G 1%Z) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 1%Z) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 1%Z) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 1%Z) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 1%Z) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 1%Z) 1 G]; [Derive_n (fun A => let u := 0%Z in Derive_n (fun u_ => quintic_ A B C_ E_ F G u_) 1 (IZR u)) 1 A; Derive_n (fun B => let u_ := 0%Z in Derive_n (fun u__ => quintic_ A B C_ E_ F G u__) 1 (IZR u_)) 1 B; Derive_n (fun C_ => let u__ := 0%Z in Derive_n (fun u___ => quintic_ A B C_ E_ F G u___) 1 (IZR u__)) 1 C_; Derive_n (fun E_ => let u___ := 0%Z in Derive_n (fun u____ => quintic_ A B C_ E_ F G u____) 1 (IZR u___)) 1 E_; Derive_n (fun F => let u____ := 0%Z in Derive_n (fun u_____ => quintic_ A B C_ E_ F G u_____) 1 (IZR u____)) 1 F; Derive_n (fun G => let u_____ := 0%Z in Derive_n (fun u______ => quintic_ A B C_ E_ F G u______) 1 (IZR u_____)) 1 G]; [Derive_n (fun A => let u______ := 1 / 2 in Derive_n (fun u_______ => quintic_ A B C_ E_ F G u_______) 1 u______) 1 A; Derive_n (fun B => let u_______ := 1 / 2 in Derive_n (fun u________ => quintic_ A B C_ E_ F G u________) 1 u_______) 1 B; Derive_n (fun C_ => let u________ := 1 / 2 in Derive_n (fun u_________ => quintic_ A B C_ E_ F G u_________) 1 u________) 1 C_; Derive_n (fun E_ => let u_________ := 1 / 2 in Derive_n (fun u__________ => quintic_ A B C_ E_ F G u__________) 1 u_________) 1 E_; Derive_n (fun F => let u__________ := 1 / 2 in Derive_n (fun u___________ => quintic_ A B C_ E_ F G u___________) 1 u__________) 1 F; Derive_n (fun G => let u___________ := 1 / 2 in Derive_n (fun u____________ => quintic_ A B C_ E_ F G u____________) 1 u___________) 1 G]; [Derive_n (fun A => let u____________ := 1%Z in Derive_n (fun u_____________ => quintic_ A B C_ E_ F G u_____________) 1 (IZR u____________)) 1 A; Derive_n (fun B => let u_____________ := 1%Z in Derive_n (fun u______________ => quintic_ A B C_ E_ F G u______________) 1 (IZR u_____________)) 1 B; Derive_n (fun C_ => let u______________ := 1%Z in Derive_n (fun u_______________ => quintic_ A B C_ E_ F G u_______________) 1 (IZR u______________)) 1 C_; Derive_n (fun E_ => let u_______________ := 1%Z in Derive_n (fun u________________ => quintic_ A B C_ E_ F G u________________) 1 (IZR u_______________)) 1 E_; Derive_n (fun F => let u________________ := 1%Z in Derive_n (fun u_________________ => quintic_ A B C_ E_ F G u_________________) 1 (IZR u________________)) 1 F; Derive_n (fun G => let u_________________ := 1%Z in Derive_n (fun u__________________ => quintic_ A B C_ E_ F G u__________________) 1 (IZR u_________________)) 1 G]].
Definition quintic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [IZR u ^ 5; IZR u ^ 4; IZR u ^ 3; IZR u ^ 2; IZR u; 1].
Definition quintic_basis_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [u ^ 5; u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend6 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) (f : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e + entry w 6 * f.
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) (a : R) (m : R) (b : R) (s : R) (r : R) (t : R) : R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : Z) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition hermite5_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : R) (m : R) (b : R) (s : R) (r : R) (t : R) : R :=
  blend6 (quintic_basis_ A B C_ E_ F G u) a m b s r t.
Definition p5_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5_ A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_conditions (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  quintic A B C_ E_ F G 0%Z.
Definition quintic_conditions_ (p0 : R) : R :=
  p0.
Definition quintic_conditions__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  quintic_ A B C_ E_ F G (1 / 2).
Definition quintic_conditions___ (pm : R) : R :=
  pm.
Definition quintic_conditions____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  quintic A B C_ E_ F G 1%Z.
Definition quintic_conditions_____ (p1 : R) : R :=
  p1.
Definition quintic_conditions______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_ A B C_ E_ F G u_) 1 (IZR u).
Definition quintic_conditions_______ (p0u : R) : R :=
  p0u.
Definition quintic_conditions________ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  let u := 1 / 2 in Derive_n (fun u_ => quintic_ A B C_ E_ F G u_) 1 u.
Definition quintic_conditions_________ (pu : R) : R :=
  pu.
Definition quintic_conditions__________ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : R :=
  let u := 1%Z in Derive_n (fun u_ => quintic_ A B C_ E_ F G u_) 1 (IZR u).
Definition quintic_conditions___________ (p1u : R) : R :=
  p1u.
End Definitions.
Import Definitions.

Module sec_2_cubic_conditions.
(* hermite-developable/sec-2.cubic.conditions, Sect. 2, first paragraph
   printed: p_3(u) = a_1 u^3 + b_1 u^2 + c_1 u + d_1 with p_3(0) = p_0, p_3(1) = p_1, p_3^u(0) = p_0^u, p_3^u(1) = p_1^u, u in interval 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(cubic_data) != 0 and p3(0) == p0 and p3(1) == p1 and p3'(0) == p0u and p3'(1) == p1u *)
Definition hermite3_ (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : R) (b : R) (s : R) (t : R) : R :=
  blend4 (cubic_basis_ A B C_ E_ u) a b s t.
Definition p3_ (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) : R :=
  hermite3_ A B C_ E_ u p0 p1 p0u p1u.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  det (cubic_data A B C_ E_) <> 0 ->
  det (cubic_data A B C_ E_) <> 0 /\ p3 A B C_ E_ p0 p0u p1 p1u 0%Z = p0 /\ p3 A B C_ E_ p0 p0u p1 p1u 1%Z = p1 /\ (let u := 0%Z in Derive_n (fun u_ => p3_ A B C_ E_ p0 p0u p1 p1u u_) 1 (IZR u)) = p0u /\ (let u_ := 1%Z in Derive_n (fun u__ => p3_ A B C_ E_ p0 p0u p1 p1u u__) 1 (IZR u_)) = p1u.
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
  cubic A B C_ E_ 0%Z = E_ /\ cubic A B C_ E_ 1%Z = A + B + C_ + E_ /\ (let u := 0%Z in Derive_n (fun u_ => cubic_ A B C_ E_ u_) 1 (IZR u)) = C_ /\ (let u_ := 1%Z in Derive_n (fun u__ => cubic_ A B C_ E_ u__) 1 (IZR u_)) = 3 * A + 2 * B + C_.
End sec_2_cubic_equations.

Module sec_2_cubic_a1.
(* hermite-developable/sec-2.cubic.a1, Sect. 2, first paragraph, solution of the system
   printed: a_1 = 2 p_0 - 2 p_1 + p_0^u + p_1^u
   stated: A == 2*p0 - 2*p1 + p0u + p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  A = 2 * p0 - 2 * p1 + p0u + p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
End sec_2_cubic_a1.

Module sec_2_cubic_b1.
(* hermite-developable/sec-2.cubic.b1, Sect. 2, first paragraph, solution of the system
   printed: b_1 = -3 p_0 + 3 p_1 - 2 p_0^u - p_1^u
   stated: B == -3*p0 + 3*p1 - 2*p0u - p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  B = - 3 * p0 + 3 * p1 - 2 * p0u - p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
End sec_2_cubic_b1.

Module sec_2_cubic_c1.
(* hermite-developable/sec-2.cubic.c1, Sect. 2, first paragraph, solution of the system
   printed: c_1 = p_0^u
   stated: C == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  C_ = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
End sec_2_cubic_c1.

Module sec_2_cubic_d1.
(* hermite-developable/sec-2.cubic.d1, Sect. 2, first paragraph, solution of the system
   printed: d_1 = p_0
   stated: E == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  E_ = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R),
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
End sec_2_cubic_d1.

Module eq_2_1a.
(* hermite-developable/eq-2.1a, Sect. 2, eq. (2.1a)
   printed: p_3(u) = (2 p_0 - 2 p_1 + p_0^u + p_1^u) u^3 + (-3 p_0 + 3 p_1 - 2 p_0^u - p_1^u) u^2 + p_0^u u + p_0
   read as: the copy sets the first p_0 of the u^2 bracket with a letter o as subscript (p_o); read as p_0, since p_o occurs nowhere else and the sentence before has the same bracket with p_0
   stated: cubic(u) == (2*p0 - 2*p1 + p0u + p1u)*u^3 + (-3*p0 + 3*p1 - 2*p0u - p1u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 ->
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  cubic_ A B C_ E_ u = (2 * p0 - 2 * p1 + p0u + p1u) * u ^ 3 + (- 3 * p0 + 3 * p1 - 2 * p0u - p1u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
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
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  cubic_ A B C_ E_ u = H1 u * p0 + H2 u * p1 + H3 u * p0u + H4 u * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u).
End eq_2_1b.

Module eq_2_1b_H1.
(* hermite-developable/eq-2.1b.H1, Sect. 2, basis functions of (2.1b)
   printed: H_1(u) = 2 u^3 - 3 u^2 + 1
   stated: coefficients([cubic(u)], [p0])[1,1] == 2*u^3 - 3*u^2 + 1 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R),
  0 < u < 1 ->
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  A_of_p0 p0 = A ->
  B_of_p0 p0 = B ->
  C__of_p0 p0 = C_ ->
  E__of_p0 p0 = E_ ->
  (forall p0 : R, cubic_conditions (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_______ p1u) ->
  entry (row [[Derive_n (fun p0 => cubic_ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) u) 1 p0]] 1) 1 = 2 * u ^ 3 - 3 * u ^ 2 + 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u) /\
  A_of_p0 p0 = A /\
  B_of_p0 p0 = B /\
  C__of_p0 p0 = C_ /\
  E__of_p0 p0 = E_ /\
  (forall p0 : R, cubic_conditions (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) = cubic_conditions_______ p1u).
End eq_2_1b_H1.

Module eq_2_1b_H2.
(* hermite-developable/eq-2.1b.H2, Sect. 2, basis functions of (2.1b)
   printed: H_2(u) = -2 u^3 + 3 u^2
   stated: coefficients([cubic(u)], [p1])[1,1] == -2*u^3 + 3*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R),
  0 < u < 1 ->
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  A_of_p1 p1 = A ->
  B_of_p1 p1 = B ->
  C__of_p1 p1 = C_ ->
  E__of_p1 p1 = E_ ->
  (forall p1 : R, cubic_conditions (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_______ p1u) ->
  entry (row [[Derive_n (fun p1 => cubic_ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) u) 1 p1]] 1) 1 = - 2 * u ^ 3 + 3 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u) /\
  A_of_p1 p1 = A /\
  B_of_p1 p1 = B /\
  C__of_p1 p1 = C_ /\
  E__of_p1 p1 = E_ /\
  (forall p1 : R, cubic_conditions (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) = cubic_conditions_______ p1u).
End eq_2_1b_H2.

Module eq_2_1b_H3.
(* hermite-developable/eq-2.1b.H3, Sect. 2, basis functions of (2.1b)
   printed: H_3(u) = u^3 - 2 u^2 + u
   stated: coefficients([cubic(u)], [p0u])[1,1] == u^3 - 2*u^2 + u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R),
  0 < u < 1 ->
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  A_of_p0u p0u = A ->
  B_of_p0u p0u = B ->
  C__of_p0u p0u = C_ ->
  E__of_p0u p0u = E_ ->
  (forall p0u : R, cubic_conditions (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_______ p1u) ->
  entry (row [[Derive_n (fun p0u => cubic_ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) u) 1 p0u]] 1) 1 = u ^ 3 - 2 * u ^ 2 + u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u) /\
  A_of_p0u p0u = A /\
  B_of_p0u p0u = B /\
  C__of_p0u p0u = C_ /\
  E__of_p0u p0u = E_ /\
  (forall p0u : R, cubic_conditions (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) = cubic_conditions_______ p1u).
End eq_2_1b_H3.

Module eq_2_1b_H4.
(* hermite-developable/eq-2.1b.H4, Sect. 2, basis functions of (2.1b)
   printed: H_4(u) = u^3 - u^2
   stated: coefficients([cubic(u)], [p1u])[1,1] == u^3 - u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R),
  0 < u < 1 ->
  cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u ->
  A_of_p1u p1u = A ->
  B_of_p1u p1u = B ->
  C__of_p1u p1u = C_ ->
  E__of_p1u p1u = E_ ->
  (forall p1u : R, cubic_conditions (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_______ p1u) ->
  entry (row [[Derive_n (fun p1u => cubic_ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) u) 1 p1u]] 1) 1 = u ^ 3 - u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R),
  0 < u < 1 /\
  (cubic_conditions A B C_ E_ = cubic_conditions_ p0 /\ cubic_conditions__ A B C_ E_ = cubic_conditions___ p1 /\ cubic_conditions____ A B C_ E_ = cubic_conditions_____ p0u /\ cubic_conditions______ A B C_ E_ = cubic_conditions_______ p1u) /\
  A_of_p1u p1u = A /\
  B_of_p1u p1u = B /\
  C__of_p1u p1u = C_ /\
  E__of_p1u p1u = E_ /\
  (forall p1u : R, cubic_conditions (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_ p0 /\ cubic_conditions__ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions___ p1 /\ cubic_conditions____ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_____ p0u /\ cubic_conditions______ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) = cubic_conditions_______ p1u).
End eq_2_1b_H4.

Module sec_2_quartic_conditions.
(* hermite-developable/sec-2.quartic.conditions, Sect. 2, paragraph on the quartic
   printed: p_4(u) = a_1 u^4 + b_1 u^3 + c_1 u^2 + d_1 u + e_1 with p_4(0) = p_0, p_4(0.5) = p, p_4(1) = p_1, p_4^u(0) = p_0^u, p_4^u(1) = p_1^u, 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(quartic_data) != 0 and p4(0) == p0 and p4(1/2) == pm and p4(1) == p1 and p4'(0) == p0u and p4'(1) == p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  det (quartic_data A B C_ E_ F) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 /\ p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z = p0 /\ p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2) = pm /\ p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z = p1 /\ (let u := 0%Z in Derive_n (fun u_ => p4_ A B C_ E_ F p0 p0u p1 p1u pm u_) 1 (IZR u)) = p0u /\ (let u_ := 1%Z in Derive_n (fun u__ => p4_ A B C_ E_ F p0 p0u p1 p1u pm u__) 1 (IZR u_)) = p1u.
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
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A = - 8 * p1 - 8 * p0 + 16 * pm + 2 * p1u - 2 * p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End sec_2_quartic_a1.

Module sec_2_quartic_b1.
(* hermite-developable/sec-2.quartic.b1, Sect. 2, quartic coefficient vectors, second
   printed: b_1 = 14 p_1 + 18 p_0 - 32 p - 3 p_1^u + 5 p_0^u
   stated: B == 14*p1 + 18*p0 - 32*pm - 3*p1u + 5*p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  B = 14 * p1 + 18 * p0 - 32 * pm - 3 * p1u + 5 * p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End sec_2_quartic_b1.

Module sec_2_quartic_third.
(* hermite-developable/sec-2.quartic.third, Sect. 2, quartic coefficient vectors, third (first of the displayed line)
   printed: e_1 = -5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u
   stated: -5*p1 - 11*p0 + 16*pm + p1u - 4*p0u == F *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  - 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u = F.
End sec_2_quartic_third.

Module sec_2_quartic_third_corrected.
(* hermite-developable/sec-2.quartic.third (corrected), Sect. 2, quartic coefficient vectors, third (first of the displayed line)
   printed: e_1 = -5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u
   stated: -5*p1 - 11*p0 + 16*pm + p1u - 4*p0u == C *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  - 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u = C_.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End sec_2_quartic_third_corrected.

Module sec_2_quartic_d1.
(* hermite-developable/sec-2.quartic.d1, Sect. 2, quartic coefficient vectors, fourth
   printed: d_1 = p_0^u
   stated: E == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  E_ = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End sec_2_quartic_d1.

Module sec_2_quartic_e1.
(* hermite-developable/sec-2.quartic.e1, Sect. 2, quartic coefficient vectors, fifth
   printed: e_1 = p_0
   stated: F == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  F = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R),
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End sec_2_quartic_e1.

Module eq_2_2.
(* hermite-developable/eq-2.2, Sect. 2, eq. (2.2)
   printed: p_4(u) = (-8 p_1 - 8 p_0 + 16 p + 2 p_1^u - 2 p_0^u) u^4 + (14 p_1 + 18 p_0 - 32 p - 3 p_1^u + 5 p_0^u) u^3 + (-5 p_1 - 11 p_0 + 16 p + p_1^u - 4 p_0^u) u^2 + p_0^u u + p_0
   stated: quartic(u) == (-8*p1 - 8*p0 + 16*pm + 2*p1u - 2*p0u)*u^4 + (14*p1 + 18*p0 - 32*pm - 3*p1u + 5*p0u)*u^3 + (-5*p1 - 11*p0 + 16*pm + p1u - 4*p0u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  quartic_ A B C_ E_ F u = (- 8 * p1 - 8 * p0 + 16 * pm + 2 * p1u - 2 * p0u) * u ^ 4 + (14 * p1 + 18 * p0 - 32 * pm - 3 * p1u + 5 * p0u) * u ^ 3 + (- 5 * p1 - 11 * p0 + 16 * pm + p1u - 4 * p0u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End eq_2_2.

Module eq_2_3.
(* hermite-developable/eq-2.3, Sect. 2, eq. (2.3)
   printed: p_4(u) = H_1(u) p_0 + H_2(u) p_1 + H_3(u) p_1 + H_4(u) p_0^u + H_5(u) p_1^u
   stated: quartic(u) == H1(u)*p0 + H2(u)*p1 + H3(u)*p1 + H4(u)*p0u + H5(u)*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  quartic_ A B C_ E_ F u = H1 u * p0 + H2 u * p1 + H3 u * p1 + H4 u * p0u + H5 u * p1u.
End eq_2_3.

Module eq_2_3_corrected.
(* hermite-developable/eq-2.3 (corrected), Sect. 2, eq. (2.3)
   printed: p_4(u) = H_1(u) p_0 + H_2(u) p_1 + H_3(u) p_1 + H_4(u) p_0^u + H_5(u) p_1^u
   stated: quartic(u) == H1(u)*p0 + H2(u)*pm + H3(u)*p1 + H4(u)*p0u + H5(u)*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  quartic_ A B C_ E_ F u = H1 u * p0 + H2 u * pm + H3 u * p1 + H4 u * p0u + H5 u * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u).
End eq_2_3_corrected.

Module eq_2_3_H1.
(* hermite-developable/eq-2.3.H1, Sect. 2, basis functions of (2.3)
   printed: H_1(u) = -8 u^4 + 18 u^3 - 11 u^2 + 1
   stated: coefficients([quartic(u)], [p0])[1,1] == -8*u^4 + 18*u^3 - 11*u^2 + 1 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R) (F_of_p0 : R -> R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A_of_p0 p0 = A ->
  B_of_p0 p0 = B ->
  C__of_p0 p0 = C_ ->
  E__of_p0 p0 = E_ ->
  F_of_p0 p0 = F ->
  (forall p0 : R, quartic_conditions (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_________ p1u) ->
  entry (row [[Derive_n (fun p0 => quartic_ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) u) 1 p0]] 1) 1 = - 8 * u ^ 4 + 18 * u ^ 3 - 11 * u ^ 2 + 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0 : R -> R) (B_of_p0 : R -> R) (C__of_p0 : R -> R) (E__of_p0 : R -> R) (F_of_p0 : R -> R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u) /\
  A_of_p0 p0 = A /\
  B_of_p0 p0 = B /\
  C__of_p0 p0 = C_ /\
  E__of_p0 p0 = E_ /\
  F_of_p0 p0 = F /\
  (forall p0 : R, quartic_conditions (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p0 p0) (B_of_p0 p0) (C__of_p0 p0) (E__of_p0 p0) (F_of_p0 p0) = quartic_conditions_________ p1u).
End eq_2_3_H1.

Module eq_2_3_H2.
(* hermite-developable/eq-2.3.H2, Sect. 2, basis functions of (2.3)
   printed: H_2(u) = 16 u^4 - 32 u^3 + 16 u^2
   stated: coefficients([quartic(u)], [pm])[1,1] == 16*u^4 - 32*u^3 + 16*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_pm : R -> R) (B_of_pm : R -> R) (C__of_pm : R -> R) (E__of_pm : R -> R) (F_of_pm : R -> R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A_of_pm pm = A ->
  B_of_pm pm = B ->
  C__of_pm pm = C_ ->
  E__of_pm pm = E_ ->
  F_of_pm pm = F ->
  (forall pm : R, quartic_conditions (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_________ p1u) ->
  entry (row [[Derive_n (fun pm => quartic_ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) u) 1 pm]] 1) 1 = 16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_pm : R -> R) (B_of_pm : R -> R) (C__of_pm : R -> R) (E__of_pm : R -> R) (F_of_pm : R -> R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u) /\
  A_of_pm pm = A /\
  B_of_pm pm = B /\
  C__of_pm pm = C_ /\
  E__of_pm pm = E_ /\
  F_of_pm pm = F /\
  (forall pm : R, quartic_conditions (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_pm pm) (B_of_pm pm) (C__of_pm pm) (E__of_pm pm) (F_of_pm pm) = quartic_conditions_________ p1u).
End eq_2_3_H2.

Module eq_2_3_H3.
(* hermite-developable/eq-2.3.H3, Sect. 2, basis functions of (2.3)
   printed: H_3(u) = -8 u^4 + 14 u^3 - 5 u^2
   stated: coefficients([quartic(u)], [p1])[1,1] == -8*u^4 + 14*u^3 - 5*u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R) (F_of_p1 : R -> R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A_of_p1 p1 = A ->
  B_of_p1 p1 = B ->
  C__of_p1 p1 = C_ ->
  E__of_p1 p1 = E_ ->
  F_of_p1 p1 = F ->
  (forall p1 : R, quartic_conditions (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_________ p1u) ->
  entry (row [[Derive_n (fun p1 => quartic_ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) u) 1 p1]] 1) 1 = - 8 * u ^ 4 + 14 * u ^ 3 - 5 * u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1 : R -> R) (B_of_p1 : R -> R) (C__of_p1 : R -> R) (E__of_p1 : R -> R) (F_of_p1 : R -> R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u) /\
  A_of_p1 p1 = A /\
  B_of_p1 p1 = B /\
  C__of_p1 p1 = C_ /\
  E__of_p1 p1 = E_ /\
  F_of_p1 p1 = F /\
  (forall p1 : R, quartic_conditions (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p1 p1) (B_of_p1 p1) (C__of_p1 p1) (E__of_p1 p1) (F_of_p1 p1) = quartic_conditions_________ p1u).
End eq_2_3_H3.

Module eq_2_3_H4.
(* hermite-developable/eq-2.3.H4, Sect. 2, basis functions of (2.3)
   printed: H_4(u) = -2 u^4 + 5 u^3 - 4 u^2 + u
   stated: coefficients([quartic(u)], [p0u])[1,1] == -2*u^4 + 5*u^3 - 4*u^2 + u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R) (F_of_p0u : R -> R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A_of_p0u p0u = A ->
  B_of_p0u p0u = B ->
  C__of_p0u p0u = C_ ->
  E__of_p0u p0u = E_ ->
  F_of_p0u p0u = F ->
  (forall p0u : R, quartic_conditions (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_________ p1u) ->
  entry (row [[Derive_n (fun p0u => quartic_ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) u) 1 p0u]] 1) 1 = - 2 * u ^ 4 + 5 * u ^ 3 - 4 * u ^ 2 + u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p0u : R -> R) (B_of_p0u : R -> R) (C__of_p0u : R -> R) (E__of_p0u : R -> R) (F_of_p0u : R -> R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u) /\
  A_of_p0u p0u = A /\
  B_of_p0u p0u = B /\
  C__of_p0u p0u = C_ /\
  E__of_p0u p0u = E_ /\
  F_of_p0u p0u = F /\
  (forall p0u : R, quartic_conditions (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p0u p0u) (B_of_p0u p0u) (C__of_p0u p0u) (E__of_p0u p0u) (F_of_p0u p0u) = quartic_conditions_________ p1u).
End eq_2_3_H4.

Module eq_2_3_H5.
(* hermite-developable/eq-2.3.H5, Sect. 2, basis functions of (2.3)
   printed: H_5(u) = 2 u^4 - 3 u^3 + u^2
   stated: coefficients([quartic(u)], [p1u])[1,1] == 2*u^4 - 3*u^3 + u^2 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R) (F_of_p1u : R -> R),
  0 < u < 1 ->
  quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u ->
  A_of_p1u p1u = A ->
  B_of_p1u p1u = B ->
  C__of_p1u p1u = C_ ->
  E__of_p1u p1u = E_ ->
  F_of_p1u p1u = F ->
  (forall p1u : R, quartic_conditions (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_________ p1u) ->
  entry (row [[Derive_n (fun p1u => quartic_ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) u) 1 p1u]] 1) 1 = 2 * u ^ 4 - 3 * u ^ 3 + u ^ 2.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) (A_of_p1u : R -> R) (B_of_p1u : R -> R) (C__of_p1u : R -> R) (E__of_p1u : R -> R) (F_of_p1u : R -> R),
  0 < u < 1 /\
  (quartic_conditions A B C_ E_ F = quartic_conditions_ p0 /\ quartic_conditions__ A B C_ E_ F = quartic_conditions___ pm /\ quartic_conditions____ A B C_ E_ F = quartic_conditions_____ p1 /\ quartic_conditions______ A B C_ E_ F = quartic_conditions_______ p0u /\ quartic_conditions________ A B C_ E_ F = quartic_conditions_________ p1u) /\
  A_of_p1u p1u = A /\
  B_of_p1u p1u = B /\
  C__of_p1u p1u = C_ /\
  E__of_p1u p1u = E_ /\
  F_of_p1u p1u = F /\
  (forall p1u : R, quartic_conditions (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_ p0 /\ quartic_conditions__ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions___ pm /\ quartic_conditions____ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_____ p1 /\ quartic_conditions______ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_______ p0u /\ quartic_conditions________ (A_of_p1u p1u) (B_of_p1u p1u) (C__of_p1u p1u) (E__of_p1u p1u) (F_of_p1u p1u) = quartic_conditions_________ p1u).
End eq_2_3_H5.

Module sec_2_quintic_conditions.
(* hermite-developable/sec-2.quintic.conditions, Sect. 2, paragraph on the quintic
   printed: p_5(u) = a_1 u^5 + b_1 u^4 + c_1 u^3 + d_1 u^2 + e_1 u + f_1 with p_5(0) = P_0, p_5(0.5) = p, p_5(1) = p_1, p_5^u(0) = p_0^u, p_5^u(0.5) = p^u, p_5^u(1) = p_1^u in interval 0 < u < 1
   read as: the conditions at the ends u = 0 and u = 1 of the printed open interval belong to it
   stated: det(quintic_data) != 0 and p5(0) == p0 and p5(1/2) == pm and p5(1) == p1 and p5'(0) == p0u and p5'(1/2) == pu and p5'(1) == p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 /\ p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = p0 /\ p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2) = pm /\ p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = p1 /\ (let u := 0%Z in Derive_n (fun u_ => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 (IZR u)) = p0u /\ (let u_ := 1 / 2 in Derive_n (fun u__ => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u__) 1 u_) = pu /\ (let u__ := 1%Z in Derive_n (fun u___ => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u___) 1 (IZR u__)) = p1u.
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
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  A = - 24 * p1 + 24 * p0 + 16 * pu + 4 * p0u + 4 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_a1.

Module sec_2_quintic_b1.
(* hermite-developable/sec-2.quintic.b1, Sect. 2, quintic coefficient vectors, second
   printed: b_1 = 52 p_1 - 68 p_0 + 16 p - 40 p^u - 12 p_0^u - 8 p_1^u
   stated: B == 52*p1 - 68*p0 + 16*pm - 40*pu - 12*p0u - 8*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  B = 52 * p1 - 68 * p0 + 16 * pm - 40 * pu - 12 * p0u - 8 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_b1.

Module sec_2_quintic_c1.
(* hermite-developable/sec-2.quintic.c1, Sect. 2, quintic coefficient vectors, third
   printed: c_1 = -34 p_1 + 66 p_0 - 32 p + 32 p^u + 13 p_0^u + 5 p_1^u
   stated: C == -34*p1 + 66*p0 - 32*pm + 32*pu + 13*p0u + 5*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  C_ = - 34 * p1 + 66 * p0 - 32 * pm + 32 * pu + 13 * p0u + 5 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_c1.

Module sec_2_quintic_d1.
(* hermite-developable/sec-2.quintic.d1, Sect. 2, quintic coefficient vectors, fourth
   printed: d_1 = 7 p_1 - 23 p_0 + 16 p - 8 p^u - 6 p_0^u - 1 p_1^u
   stated: E == 7*p1 - 23*p0 + 16*pm - 8*pu - 6*p0u - 1*p1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  E_ = 7 * p1 - 23 * p0 + 16 * pm - 8 * pu - 6 * p0u - 1 * p1u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_d1.

Module sec_2_quintic_e1.
(* hermite-developable/sec-2.quintic.e1, Sect. 2, quintic coefficient vectors, fifth
   printed: e_1 = p_0^u
   stated: F == p0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  F = p0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_e1.

Module sec_2_quintic_f1.
(* hermite-developable/sec-2.quintic.f1, Sect. 2, quintic coefficient vectors, sixth
   printed: f_1 = P_0
   read as: P_0 (capital, also in the condition p_5(0) = P_0) is taken as the same point as p_0
   stated: G == p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  G = p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R),
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End sec_2_quintic_f1.

Module eq_2_4.
(* hermite-developable/eq-2.4, Sect. 2, eq. (2.4)
   printed: p_5(u) = (-24 p_1 + 24 p_0 + 16 p^u + 4 p_0^u + 4 p_1^u) u^5 + (52 p_1 - 68 p_0 + 16 p - 40 p^u - 12 p_0^u - 8 p_1^u) u^4 + (-34 p_1 + 66 p_0 - 32 p + 32 p^u + 13 p_0^u + 5 p_1^u) u^3 + (7 p_1 - 23 p_0 + 16 p - 8 p^u - 6 p_0^u - p_1^u) u^2 + (p_0^u) u + p_0
   stated: quintic(u) == (-24*p1 + 24*p0 + 16*pu + 4*p0u + 4*p1u)*u^5 + (52*p1 - 68*p0 + 16*pm - 40*pu - 12*p0u - 8*p1u)*u^4 + (-34*p1 + 66*p0 - 32*pm + 32*pu + 13*p0u + 5*p1u)*u^3 + (7*p1 - 23*p0 + 16*pm - 8*pu - 6*p0u - p1u)*u^2 + p0u*u + p0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u ->
  quintic_ A B C_ E_ F G u = (- 24 * p1 + 24 * p0 + 16 * pu + 4 * p0u + 4 * p1u) * u ^ 5 + (52 * p1 - 68 * p0 + 16 * pm - 40 * pu - 12 * p0u - 8 * p1u) * u ^ 4 + (- 34 * p1 + 66 * p0 - 32 * pm + 32 * pu + 13 * p0u + 5 * p1u) * u ^ 3 + (7 * p1 - 23 * p0 + 16 * pm - 8 * pu - 6 * p0u - p1u) * u ^ 2 + p0u * u + p0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 /\
  (quintic_conditions A B C_ E_ F G = quintic_conditions_ p0 /\ quintic_conditions__ A B C_ E_ F G = quintic_conditions___ pm /\ quintic_conditions____ A B C_ E_ F G = quintic_conditions_____ p1 /\ quintic_conditions______ A B C_ E_ F G = quintic_conditions_______ p0u /\ quintic_conditions________ A B C_ E_ F G = quintic_conditions_________ pu /\ quintic_conditions__________ A B C_ E_ F G = quintic_conditions___________ p1u).
End eq_2_4.

Module sec_2_control.
(* hermite-developable/sec-2.control, Sect. 2, sentence after (2.4)
   printed: Arranging the position of these curves in space can use the control points p_0, p, and p_1 meanwhile, the shapes of the curves can be designed by the tangent vectors p_0^u, p^u, and p_1^u at these control points, respectively
   read as: the cubic has the points p_0, p_1 and the tangent vectors at them, the quartic p besides, the quintic all six
   stated: coefficients([p3(0), p3(1)], [p0, p1]) == identity(2) and coefficients([p4(0), p4(1/2), p4(1)], [p0, pm, p1]) == identity(3) and coefficients([p5(0), p5(1/2), p5(1)], [p0, pm, p1]) == identity(3) and coefficients([p3(0), p3(1)], [p0u, p1u]) == 0 and coefficients([p4(0), p4(1/2), p4(1)], [p0u, p1u]) == 0 and coefficients([p5(0), p5(1/2), p5(1)], [p0u, pu, p1u]) == 0 and fails(coefficients([p3(u)], [p0u]) == 0) and fails(coefficients([p3(u)], [p1u]) == 0) and fails(coefficients([p4(u)], [p0u]) == 0) and fails(coefficients([p4(u)], [p1u]) == 0) and fails(coefficients([p5(u)], [p0u]) == 0) and fails(coefficients([p5(u)], [pu]) == 0) and fails(coefficients([p5(u)], [p1u]) == 0) *)
Definition hermite3_ (A : R) (B : R) (C_ : R) (E_ : R) (u : R) (a : R) (b : R) (s : R) (t : R) : R :=
  blend4 (cubic_basis_ A B C_ E_ u) a b s t.
Definition p3_ (A : R) (B : R) (C_ : R) (E_ : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (u : R) : R :=
  hermite3_ A B C_ E_ u p0 p1 p0u p1u.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p0 => p3 A B C_ E_ p0 p0u p1 p1u 0%Z) 1 p0; Derive_n (fun p1 => p3 A B C_ E_ p0 p0u p1 p1u 0%Z) 1 p1]; [Derive_n (fun p0 => p3 A B C_ E_ p0 p0u p1 p1u 1%Z) 1 p0; Derive_n (fun p1 => p3 A B C_ E_ p0 p0u p1 p1u 1%Z) 1 p1]] = identity 2 /\ [[Derive_n (fun p0 => p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z) 1 p0; Derive_n (fun pm => p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z) 1 pm; Derive_n (fun p1 => p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z) 1 p1]; [Derive_n (fun p0 => p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p0; Derive_n (fun pm => p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 pm; Derive_n (fun p1 => p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p1]; [Derive_n (fun p0 => p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z) 1 p0; Derive_n (fun pm => p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z) 1 pm; Derive_n (fun p1 => p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z) 1 p1]] = identity 3 /\ [[Derive_n (fun p0 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 p0; Derive_n (fun pm => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 pm; Derive_n (fun p1 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 p1]; [Derive_n (fun p0 => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p0; Derive_n (fun pm => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 pm; Derive_n (fun p1 => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p1]; [Derive_n (fun p0 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 p0; Derive_n (fun pm => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 pm; Derive_n (fun p1 => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 p1]] = identity 3 /\ [[Derive_n (fun p0u => p3 A B C_ E_ p0 p0u p1 p1u 0%Z) 1 p0u; Derive_n (fun p1u => p3 A B C_ E_ p0 p0u p1 p1u 0%Z) 1 p1u]; [Derive_n (fun p0u => p3 A B C_ E_ p0 p0u p1 p1u 1%Z) 1 p0u; Derive_n (fun p1u => p3 A B C_ E_ p0 p0u p1 p1u 1%Z) 1 p1u]] = mzeros 2 2 /\ [[Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z) 1 p0u; Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm 0%Z) 1 p1u]; [Derive_n (fun p0u => p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p0u; Derive_n (fun p1u => p4_ A B C_ E_ F p0 p0u p1 p1u pm (1 / 2)) 1 p1u]; [Derive_n (fun p0u => p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z) 1 p0u; Derive_n (fun p1u => p4 A B C_ E_ F p0 p0u p1 p1u pm 1%Z) 1 p1u]] = mzeros 3 2 /\ [[Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 p0u; Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 pu; Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z) 1 p1u]; [Derive_n (fun p0u => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p0u; Derive_n (fun pu => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 pu; Derive_n (fun p1u => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2)) 1 p1u]; [Derive_n (fun p0u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 p0u; Derive_n (fun pu => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 pu; Derive_n (fun p1u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z) 1 p1u]] = mzeros 3 3 /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun p0u => p3_ A B C_ E_ p0 p0u p1 p1u u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (cubic_data A B C_ E_) <> 0 ->
  [[Derive_n (fun p1u => p3_ A B C_ E_ p0 p0u p1 p1u u) 1 p1u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  [[Derive_n (fun p0u => p4_ A B C_ E_ F p0 p0u p1 p1u pm u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  [[Derive_n (fun p1u => p4_ A B C_ E_ F p0 p0u p1 p1u pm u) 1 p1u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p0u => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 p0u]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun pu => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 pu]] = mzeros 1 1) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  [[Derive_n (fun p1u => p5_ A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 p1u]] = mzeros 1 1).
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition fig1b (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) : list R :=
  hermite5 A B C_ E_ F G u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [60; 5; 60] [10; - 60; 80].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition fig1a (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) : list R :=
  hermite4 A B C_ E_ F u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [10; - 60; 80].
Definition hermite5_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis_ A B C_ E_ F G u) a m b s r t.
Definition fig1b_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5_ A B C_ E_ F G u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [60; 5; 60] [10; - 60; 80].
Definition hermite4_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis_ A B C_ E_ F u) a m b s t.
Definition fig1a_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  hermite4_ A B C_ E_ F u [- 20; 40; 5] [- 20; 20; 40] [- 20; - 50; 25] [40; 0; 80] [10; - 60; 80].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  fig1b A B C_ E_ F G 0%Z = fig1a A B C_ E_ F 0%Z /\ (let u_ := 0%Z in vDerive 3 (fun u__ => fig1b_ A B C_ E_ F G u__) 1 (IZR u_)) = (let u__ := 0%Z in vDerive 3 (fun u___ => fig1a_ A B C_ E_ F u___) 1 (IZR u__)) /\ fig1b A B C_ E_ F G 1%Z = fig1a A B C_ E_ F 1%Z /\ (let u___ := 1%Z in vDerive 3 (fun u____ => fig1b_ A B C_ E_ F G u____) 1 (IZR u___)) = (let u____ := 1%Z in vDerive 3 (fun u_____ => fig1a_ A B C_ E_ F u_____) 1 (IZR u____)) /\ vsub (fig1b_ A B C_ E_ F G u) (fig1a_ A B C_ E_ F u) = vscale (8 * u ^ 2 * (1 - u) ^ 2 * (2 * u - 1)) (vsub [60; 5; 60] (let u_____ := 1 / 2 in vDerive 3 (fun u______ => fig1a_ A B C_ E_ F u______) 1 u_____)) /\ ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  (let u______ := 1 / 2 in vDerive 3 (fun u_______ => fig1b_ A B C_ E_ F G u_______) 1 u______) = (let u_______ := 1 / 2 in vDerive 3 (fun u________ => fig1a_ A B C_ E_ F u________) 1 u_______)).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R),
  0 < u < 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  det (quartic_data A B C_ E_ F) <> 0.
End fig_1b_middle.
