(* Statements of hermite-developable, Section 3 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition quintic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : Z) : R :=
  A * IZR u ^ 5 + B * IZR u ^ 4 + C_ * IZR u ^ 3 + E_ * IZR u ^ 2 + F * IZR u + G.
Definition quintic_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : R :=
  A * u ^ 5 + B * u ^ 4 + C_ * u ^ 3 + E_ * u ^ 2 + F * u + G.
Definition quintic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : list (list R) :=
  [[Derive_n (fun A => quintic A B C_ E_ F G 0%Z) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 0%Z) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 0%Z) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 0%Z) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 0%Z) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 0%Z) 1 G]; [Derive_n (fun A => quintic_ A B C_ E_ F G (1 / 2)) 1 A; Derive_n (fun B => quintic_ A B C_ E_ F G (1 / 2)) 1 B; Derive_n (fun C_ => quintic_ A B C_ E_ F G (1 / 2)) 1 C_; Derive_n (fun E_ => quintic_ A B C_ E_ F G (1 / 2)) 1 E_; Derive_n (fun F => quintic_ A B C_ E_ F G (1 / 2)) 1 F; Derive_n (fun G => quintic_ A B C_ E_ F G (1 / 2)) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G 1%Z) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 1%Z) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 1%Z) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 1%Z) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 1%Z) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 1%Z) 1 G]; [Derive_n (fun A => let u := 0%Z in Derive_n (fun u_ => quintic_ A B C_ E_ F G u_) 1 (IZR u)) 1 A; Derive_n (fun B => let u_ := 0%Z in Derive_n (fun u__ => quintic_ A B C_ E_ F G u__) 1 (IZR u_)) 1 B; Derive_n (fun C_ => let u__ := 0%Z in Derive_n (fun u___ => quintic_ A B C_ E_ F G u___) 1 (IZR u__)) 1 C_; Derive_n (fun E_ => let u___ := 0%Z in Derive_n (fun u____ => quintic_ A B C_ E_ F G u____) 1 (IZR u___)) 1 E_; Derive_n (fun F => let u____ := 0%Z in Derive_n (fun u_____ => quintic_ A B C_ E_ F G u_____) 1 (IZR u____)) 1 F; Derive_n (fun G => let u_____ := 0%Z in Derive_n (fun u______ => quintic_ A B C_ E_ F G u______) 1 (IZR u_____)) 1 G]; [Derive_n (fun A => let u______ := 1 / 2 in Derive_n (fun u_______ => quintic_ A B C_ E_ F G u_______) 1 u______) 1 A; Derive_n (fun B => let u_______ := 1 / 2 in Derive_n (fun u________ => quintic_ A B C_ E_ F G u________) 1 u_______) 1 B; Derive_n (fun C_ => let u________ := 1 / 2 in Derive_n (fun u_________ => quintic_ A B C_ E_ F G u_________) 1 u________) 1 C_; Derive_n (fun E_ => let u_________ := 1 / 2 in Derive_n (fun u__________ => quintic_ A B C_ E_ F G u__________) 1 u_________) 1 E_; Derive_n (fun F => let u__________ := 1 / 2 in Derive_n (fun u___________ => quintic_ A B C_ E_ F G u___________) 1 u__________) 1 F; Derive_n (fun G => let u___________ := 1 / 2 in Derive_n (fun u____________ => quintic_ A B C_ E_ F G u____________) 1 u___________) 1 G]; [Derive_n (fun A => let u____________ := 1%Z in Derive_n (fun u_____________ => quintic_ A B C_ E_ F G u_____________) 1 (IZR u____________)) 1 A; Derive_n (fun B => let u_____________ := 1%Z in Derive_n (fun u______________ => quintic_ A B C_ E_ F G u______________) 1 (IZR u_____________)) 1 B; Derive_n (fun C_ => let u______________ := 1%Z in Derive_n (fun u_______________ => quintic_ A B C_ E_ F G u_______________) 1 (IZR u______________)) 1 C_; Derive_n (fun E_ => let u_______________ := 1%Z in Derive_n (fun u________________ => quintic_ A B C_ E_ F G u________________) 1 (IZR u_______________)) 1 E_; Derive_n (fun F => let u________________ := 1%Z in Derive_n (fun u_________________ => quintic_ A B C_ E_ F G u_________________) 1 (IZR u________________)) 1 F; Derive_n (fun G => let u_________________ := 1%Z in Derive_n (fun u__________________ => quintic_ A B C_ E_ F G u__________________) 1 (IZR u_________________)) 1 G]].
Definition quintic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [u ^ 5; u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend6 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) (f : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e + entry w 6 * f.
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : R) (m : R) (b : R) (s : R) (r : R) (t : R) : R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
Definition quintic_criterion_ : R :=
  0.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
Definition quintic_system (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : list (list R) :=
  [[Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z) 1 o]].
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) : R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z.
End Definitions.
Import Definitions.

Module sec_3_3_curves.
(* hermite-developable/sec-3.3.curves, Sect. 3.3, first sentences
   printed: p_5(u) = a_1 u^5 + b_1 u^4 + c_1 u^3 + d_1 u^2 + e_1 u + f_1 and q_5(u) = a_2 u^5 + b_2 u^4 + c_2 u^3 + d_2 u^2 + e_2 u + f_2 in the parallel plane Gamma_1 // Gamma_2; D(u,v) = (1-v) p_5(u) + v q_5(u); posing p_0, p, q_0^u, q_1, q_0, q_1^u, and p''
   read as: p'' is read as p^u (the superscript u seen as two strokes): the example lists p^u as the seventh datum and no second derivative occurs in the paper. The seven data named last are given, the six others follow: the equations of the criterion determine them
   stated: quintic_system*solve(quintic_system, right) == right and solve(quintic_system, quintic_system*x) == x *)
Definition right_ (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) (c6 : R) : list R :=
  [c1; c2; c3; c4; c5; c6].
Definition x (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R) (x6 : R) : list R :=
  [x1; x2; x3; x4; x5; x6].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) (c6 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R) (x6 : R),
  0 < k ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  det (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) <> 0 ->
  mvec (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) (solve (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) (right_ c1 c2 c3 c4 c5 c6)) = right_ c1 c2 c3 c4 c5 c6 /\ solve (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) (mvec (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) (x x1 x2 x3 x4 x5 x6)) = x x1 x2 x3 x4 x5 x6.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) (c6 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R) (x6 : R),
  0 < k /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  det (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) <> 0.
End sec_3_3_curves.

Module eq_3_7_A_r1.
(* hermite-developable/eq-3.7.A.r1, Sect. 3.3, eq. (3.7), matrix A, row 1
   printed: (-4k, 16, -4k, 0, 24k, 0)
   stated: quintic_system[1] == [-4*k, 16, -4*k, 0, 24*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 1 = [- 4 * k; 16; - 4 * k; 0; 24 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r1.

Module eq_3_7_A_r2.
(* hermite-developable/eq-3.7.A.r2, Sect. 3.3, eq. (3.7), matrix A, row 2
   printed: (-8k, 40, -12k, 16, 68k, 0)
   stated: quintic_system[2] == [-8*k, 40, -12*k, 16, 68*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 2 = [- 8 * k; 40; - 12 * k; 16; 68 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r2.

Module eq_3_7_A_r3.
(* hermite-developable/eq-3.7.A.r3, Sect. 3.3, eq. (3.7), matrix A, row 3
   printed: (35k, -128, 27k, 32, -174k, 0)
   stated: quintic_system[3] == [35*k, -128, 27*k, 32, -174*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 3 = [35 * k; - 128; 27 * k; 32; - 174 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r3.

Module eq_3_7_A_r4.
(* hermite-developable/eq-3.7.A.r4, Sect. 3.3, eq. (3.7), matrix A, row 4
   printed: (-33k, 88, -14k, -80, 95k, 0)
   read as: the copy merges two columns: '-33k & 88 & -14k - 80 & 95k & 0'
   stated: quintic_system[4] == [-33*k, 88, -14*k, -80, 95*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 4 = [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r4.

Module eq_3_7_A_r5.
(* hermite-developable/eq-3.7.A.r5, Sect. 3.3, eq. (3.7), matrix A, row 5
   printed: (11k, -16, 2k, 32, -14k, 0)
   stated: quintic_system[5] == [11*k, -16, 2*k, 32, -14*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 5 = [11 * k; - 16; 2 * k; 32; - 14 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r5.

Module eq_3_7_A_r6.
(* hermite-developable/eq-3.7.A.r6, Sect. 3.3, eq. (3.7), matrix A, row 6
   printed: (-k, 0, 0, 0, 0, k - 1)
   read as: the copy has five entries '-k & 0 & 0 & 0 & k - 1' in a matrix of six columns; one 0 is taken as lost, the first and the last entry keep their places
   stated: quintic_system[6] == [-k, 0, 0, 0, 0, k - 1] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  row (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) 6 = [- k; 0; 0; 0; 0; k - 1].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_A_r6.

Module eq_3_7_B.
(* hermite-developable/eq-3.7.B, Sect. 3.3, eq. (3.7), column of unknowns
   printed: B = (p_0^u, q^u, p_1^u, q, p_1, q)
   stated: quintic_system*[p0u, qu, p1u, qm, p1, o] == A37*[p0u, qu, p1u, qm, p1, qm] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  0 < k ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  mvec (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) [p0u; qu; p1u; qm; p1; o] = mvec (A37 k) [p0u; qu; p1u; qm; p1; qm].
End eq_3_7_B.

Module eq_3_7_B_corrected.
(* hermite-developable/eq-3.7.B (corrected), Sect. 3.3, eq. (3.7), column of unknowns
   printed: B = (p_0^u, q^u, p_1^u, q, p_1, q)
   stated: quintic_system*[p0u, qu, p1u, qm, p1, o] == A37*[p0u, qu, p1u, qm, p1, o] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  0 < k ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  mvec (quintic_system A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu) [p0u; qu; p1u; qm; p1; o] = mvec (A37 k) [p0u; qu; p1u; qm; p1; o].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  0 < k /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_B_corrected.

Module eq_3_7_C_r1.
(* hermite-developable/eq-3.7.C.r1, Sect. 3.3, eq. (3.7), right-hand side, row 1
   printed: 24 k p_0 + 24 q_1 - 24 q_0 - 4 q_0^u - 4 q_1^u + 16 k p^u
   stated: blend6(A37[1], p0u, qu, p1u, qm, p1, o) - quintic_part(5) == 24*k*p0 + 24*q1 - 24*q0 - 4*q0u - 4*q1u + 16*k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  blend6 (row (A37 k) 1) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z = 24 * k * p0 + 24 * q1 - 24 * q0 - 4 * q0u - 4 * q1u + 16 * k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0.
End eq_3_7_C_r1.

Module eq_3_7_C_r2.
(* hermite-developable/eq-3.7.C.r2, Sect. 3.3, eq. (3.7), right-hand side, row 2
   printed: 52 k p_0 + 16 k p + 68 q_1 - 52 q_0 - 8 q_0^u - 12 q_1^u + 40 k p^u
   stated: blend6(A37[2], p0u, qu, p1u, qm, p1, o) - quintic_part(4) == 52*k*p0 + 16*k*pm + 68*q1 - 52*q0 - 8*q0u - 12*q1u + 40*k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  blend6 (row (A37 k) 2) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z = 52 * k * p0 + 16 * k * pm + 68 * q1 - 52 * q0 - 8 * q0u - 12 * q1u + 40 * k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0.
End eq_3_7_C_r2.

Module eq_3_7_C_r3.
(* hermite-developable/eq-3.7.C.r3, Sect. 3.3, eq. (3.7), right-hand side, row 3
   printed: -206 k p_0 + 32 k p - 174 q_1 + 206 q_0 + 35 q_0^u + 27 q_1^u - 128 k p^u
   stated: blend6(A37[3], p0u, qu, p1u, qm, p1, o) - quintic_part(3) == -206*k*p0 + 32*k*pm - 174*q1 + 206*q0 + 35*q0u + 27*q1u - 128*k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  blend6 (row (A37 k) 3) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z = - 206 * k * p0 + 32 * k * pm - 174 * q1 + 206 * q0 + 35 * q0u + 27 * q1u - 128 * k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0.
End eq_3_7_C_r3.

Module eq_3_7_C_r4.
(* hermite-developable/eq-3.7.C.r4, Sect. 3.3, eq. (3.7), right-hand side, row 4
   printed: 175 k p_0 - 80 k p + 95 q_1 - 175 q_0 - 33 q_0^u - 14 q_1^u + 88 k p^u
   stated: blend6(A37[4], p0u, qu, p1u, qm, p1, o) - quintic_part(2) == 175*k*p0 - 80*k*pm + 95*q1 - 175*q0 - 33*q0u - 14*q1u + 88*k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  blend6 (row (A37 k) 4) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z = 175 * k * p0 - 80 * k * pm + 95 * q1 - 175 * q0 - 33 * q0u - 14 * q1u + 88 * k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0.
End eq_3_7_C_r4.

Module eq_3_7_C_r5.
(* hermite-developable/eq-3.7.C.r5, Sect. 3.3, eq. (3.7), right-hand side, row 5
   printed: -46 k p_0 + 32 k p - 14 q_1 + 46 q_0 + 11 q_0^u + 2 q_1^u - 16 k p^u
   stated: blend6(A37[5], p0u, qu, p1u, qm, p1, o) - quintic_part(1) == -46*k*p0 + 32*k*pm - 14*q1 + 46*q0 + 11*q0u + 2*q1u - 16*k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  blend6 (row (A37 k) 5) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z = - 46 * k * p0 + 32 * k * pm - 14 * q1 + 46 * q0 + 11 * q0u + 2 * q1u - 16 * k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0.
End eq_3_7_C_r5.

Module eq_3_7_C_r6.
(* hermite-developable/eq-3.7.C.r6, Sect. 3.3, eq. (3.7), right-hand side, row 6
   printed: k p_0 - q_0 - q_0^u
   stated: blend6(A37[6], p0u, qu, p1u, qm, p1, o) - quintic_part(0) == k*p0 - q0 - q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  blend6 (row (A37 k) 6) p0u qu p1u qm p1 o - quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z = k * p0 - q0 - q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_C_r6.

Module eq_3_7_det.
(* hermite-developable/eq-3.7.det, Sect. 3.3, sentence after (3.7)
   printed: det(A) = 256 k^3 (k - 1)
   stated: det(A37) == 256*k^3*(k - 1) *)
Definition statement : Prop :=
forall (k : R),
  det (A37 k) = 256 * k ^ 3 * (k - 1).
End eq_3_7_det.

Module eq_3_7_k.
(* hermite-developable/eq-3.7.k, Sect. 3.3, sentence before the solutions
   printed: If we determine k > 0 and k != 1, then it finds the solutions
   stated: p0u == q0u/k and qu == k*pu and p1u == q1u/k and qm == -k*p0 + q0 + k*pm and p1 == (k*p0 + q1 - q0)/k and o == (k*p0 - q0)/(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  k <> 0 ->
  k - 1 <> 0 ->
  p0u = q0u / k /\ qu = k * pu /\ p1u = q1u / k /\ qm = - k * p0 + q0 + k * pm /\ p1 = (k * p0 + q1 - q0) / k /\ o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_7_k.

Module eq_3_7_k_needed.
(* hermite-developable/eq-3.7.k.needed, Sect. 3.3, sentence before the solutions
   printed: Both exclusions are needed: at k = 0 and at k = 1 the system of the criterion has no unique solution.
   stated: at(det(quintic_system), k, 0) == 0 and at(det(quintic_system), k, 1) == 0 *)
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (k : Z) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - IZR k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - IZR k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (k : Z) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k u_) (Z.to_nat n) (IZR u) / factorial n.
Definition quintic_system (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (k : Z) : list (list R) :=
  [[Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 5%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 4%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 3%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 2%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 1%Z) 1 o]; [Derive_n (fun p0u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 p0u; Derive_n (fun qu => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 qu; Derive_n (fun p1u => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 p1u; Derive_n (fun qm => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 qm; Derive_n (fun p1 => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 p1; Derive_n (fun o => quintic_part A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k 0%Z) 1 o]].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  (let k := 0%Z in det (quintic_system A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k)) = 0 /\ (let k := 1%Z in det (quintic_system A B C_ E_ F G o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu k)) = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_7_k_needed.

Module eq_3_7_sol_p0u.
(* hermite-developable/eq-3.7.sol.p0u, Sect. 3.3, solutions of (3.7)
   printed: p_0^u = (q_0^u)/k
   stated: p0u == q0u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  k <> 0 ->
  p0u = q0u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  k <> 0.
End eq_3_7_sol_p0u.

Module eq_3_7_sol_qu.
(* hermite-developable/eq-3.7.sol.qu, Sect. 3.3, solutions of (3.7)
   printed: q^u = k p^u
   stated: qu == k*pu *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  qu = k * pu.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_).
End eq_3_7_sol_qu.

Module eq_3_7_sol_p1u.
(* hermite-developable/eq-3.7.sol.p1u, Sect. 3.3, solutions of (3.7)
   printed: p_1^u = q_1^u/k
   stated: p1u == q1u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  k <> 0 ->
  p1u = q1u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  k <> 0.
End eq_3_7_sol_p1u.

Module eq_3_7_sol_q.
(* hermite-developable/eq-3.7.sol.q, Sect. 3.3, solutions of (3.7)
   printed: q = -k p_0 + q_0 + k p
   stated: qm == -k*p0 + q0 + k*pm *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  qm = - k * p0 + q0 + k * pm.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_).
End eq_3_7_sol_q.

Module eq_3_7_sol_p1.
(* hermite-developable/eq-3.7.sol.p1, Sect. 3.3, solutions of (3.7)
   printed: p_1 = (k p_0 + q_1 - q_0)/k
   stated: p1 == (k*p0 + q1 - q0)/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  k <> 0 ->
  p1 = (k * p0 + q1 - q0) / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  k <> 0.
End eq_3_7_sol_p1.

Module eq_3_7_sol_o.
(* hermite-developable/eq-3.7.sol.o, Sect. 3.3, solutions of (3.7)
   printed: o = (k p_0 - q_0)/(k - 1)
   stated: o == (k*p0 - q0)/(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  k - 1 <> 0 ->
  o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R),
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  k - 1 <> 0.
End eq_3_7_sol_o.

Module eq_3_7_system.
(* hermite-developable/eq-3.7.system, Sect. 3.3, solutions of (3.7)
   printed: The printed matrix and right-hand side, with o for the last unknown, have the printed solutions.
   stated: solve(A37, right) == [q0u/k, k*pu, q1u/k, -k*p0 + q0 + k*pm, (k*p0 + q1 - q0)/k, (k*p0 - q0)/(k - 1)] *)
Definition right_ (k : R) (p0 : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) : list R :=
  [24 * k * p0 + 24 * q1 - 24 * q0 - 4 * q0u - 4 * q1u + 16 * k * pu; 52 * k * p0 + 16 * k * pm + 68 * q1 - 52 * q0 - 8 * q0u - 12 * q1u + 40 * k * pu; - 206 * k * p0 + 32 * k * pm - 174 * q1 + 206 * q0 + 35 * q0u + 27 * q1u - 128 * k * pu; 175 * k * p0 - 80 * k * pm + 95 * q1 - 175 * q0 - 33 * q0u - 14 * q1u + 88 * k * pu; - 46 * k * p0 + 32 * k * pm - 14 * q1 + 46 * q0 + 11 * q0u + 2 * q1u - 16 * k * pu; k * p0 - q0 - q0u].
Definition statement : Prop :=
forall (k : R) (p0 : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  k <> 1 ->
  det (A37 k) <> 0 ->
  k <> 0 ->
  k - 1 <> 0 ->
  solve (A37 k) (right_ k p0 pm pu q0 q0u q1 q1u) = [q0u / k; k * pu; q1u / k; - k * p0 + q0 + k * pm; (k * p0 + q1 - q0) / k; (k * p0 - q0) / (k - 1)].
Definition instance : Prop :=
exists (k : R) (p0 : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  k <> 1 /\
  det (A37 k) <> 0 /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_7_system.

Module sec_3_3_advantage.
(* hermite-developable/sec-3.3.advantage, Sect. 3.3, last sentence
   printed: the choice of vector tangent p^u can modify straightforward the surface shape in the middle part of the surface (Figure (4b) and (4c))
   stated: coefficients([p5(u), q5(u)], [pu]) == [[wave(u)], [k*wave(u)]] and wave(0) == 0 and wave(1) == 0 and wave'(0) == 0 and wave'(1) == 0 and wave(1/2) == 0 and wave'(1/2) == 1 *)
Definition wave (u : R) : R :=
  8 * u ^ 2 * (1 - u) ^ 2 * (2 * u - 1).
Definition wave_ (u : Z) : R :=
  8 * IZR u ^ 2 * (1 - IZR u) ^ 2 * (2 * IZR u - 1).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) (p0u_of_pu : R -> R) (qu_of_pu : R -> R) (p1u_of_pu : R -> R) (qm_of_pu : R -> R) (p1_of_pu : R -> R) (o_of_pu : R -> R),
  0 < u < 1 ->
  k > 0 ->
  k <> 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ ->
  p0u_of_pu pu = p0u ->
  qu_of_pu pu = qu ->
  p1u_of_pu pu = p1u ->
  qm_of_pu pu = qm ->
  p1_of_pu pu = p1 ->
  o_of_pu pu = o ->
  (forall pu : R, quintic_criterion A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_) ->
  [[Derive_n (fun pu => p5 A B C_ E_ F G p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu u) 1 pu]; [Derive_n (fun pu => q5 A B C_ E_ F G q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) u) 1 pu]] = [[wave u]; [k * wave u]] /\ wave_ 0%Z = 0 /\ wave_ 1%Z = 0 /\ (let u_ := 0%Z in Derive_n (fun u__ => wave u__) 1 (IZR u_)) = 0 /\ (let u__ := 1%Z in Derive_n (fun u___ => wave u___) 1 (IZR u__)) = 0 /\ wave (1 / 2) = 0 /\ (let u___ := 1 / 2 in Derive_n (fun u____ => wave u____) 1 u___) = 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) (p0u_of_pu : R -> R) (qu_of_pu : R -> R) (p1u_of_pu : R -> R) (qm_of_pu : R -> R) (p1_of_pu : R -> R) (o_of_pu : R -> R),
  0 < u < 1 /\
  k > 0 /\
  k <> 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = quintic_criterion_) /\
  p0u_of_pu pu = p0u /\
  qu_of_pu pu = qu /\
  p1u_of_pu pu = p1u /\
  qm_of_pu pu = qm /\
  p1_of_pu pu = p1 /\
  o_of_pu pu = o /\
  (forall pu : R, quintic_criterion A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion__ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion___ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion____ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion_____ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_ /\ quintic_criterion______ A B C_ E_ F G k (o_of_pu pu) p0 (p0u_of_pu pu) (p1_of_pu pu) (p1u_of_pu pu) pm pu q0 q0u q1 q1u (qm_of_pu pu) (qu_of_pu pu) = quintic_criterion_).
End sec_3_3_advantage.

Module ex_3_3_equation.
(* hermite-developable/ex-3.3.equation, Sect. 3.3, example
   printed: Equation (3.6) gives the solution
   stated: q4'(1/2) == [0, -50, 70] *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition quartic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : Z) : R :=
  A * IZR u ^ 4 + B * IZR u ^ 3 + C_ * IZR u ^ 2 + E_ * IZR u + F.
Definition quartic_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : R :=
  A * u ^ 4 + B * u ^ 3 + C_ * u ^ 2 + E_ * u + F.
Definition quartic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : list (list R) :=
  [[Derive_n (fun A => quartic A B C_ E_ F 0%Z) 1 A; Derive_n (fun B => quartic A B C_ E_ F 0%Z) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 0%Z) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 0%Z) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 0%Z) 1 F]; [Derive_n (fun A => quartic_ A B C_ E_ F (1 / 2)) 1 A; Derive_n (fun B => quartic_ A B C_ E_ F (1 / 2)) 1 B; Derive_n (fun C_ => quartic_ A B C_ E_ F (1 / 2)) 1 C_; Derive_n (fun E_ => quartic_ A B C_ E_ F (1 / 2)) 1 E_; Derive_n (fun F => quartic_ A B C_ E_ F (1 / 2)) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F 1%Z) 1 A; Derive_n (fun B => quartic A B C_ E_ F 1%Z) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 1%Z) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 1%Z) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 1%Z) 1 F]; [Derive_n (fun A => let u := 0%Z in Derive_n (fun u_ => quartic_ A B C_ E_ F u_) 1 (IZR u)) 1 A; Derive_n (fun B => let u_ := 0%Z in Derive_n (fun u__ => quartic_ A B C_ E_ F u__) 1 (IZR u_)) 1 B; Derive_n (fun C_ => let u__ := 0%Z in Derive_n (fun u___ => quartic_ A B C_ E_ F u___) 1 (IZR u__)) 1 C_; Derive_n (fun E_ => let u___ := 0%Z in Derive_n (fun u____ => quartic_ A B C_ E_ F u____) 1 (IZR u___)) 1 E_; Derive_n (fun F => let u____ := 0%Z in Derive_n (fun u_____ => quartic_ A B C_ E_ F u_____) 1 (IZR u____)) 1 F]; [Derive_n (fun A => let u_____ := 1%Z in Derive_n (fun u______ => quartic_ A B C_ E_ F u______) 1 (IZR u_____)) 1 A; Derive_n (fun B => let u______ := 1%Z in Derive_n (fun u_______ => quartic_ A B C_ E_ F u_______) 1 (IZR u______)) 1 B; Derive_n (fun C_ => let u_______ := 1%Z in Derive_n (fun u________ => quartic_ A B C_ E_ F u________) 1 (IZR u_______)) 1 C_; Derive_n (fun E_ => let u________ := 1%Z in Derive_n (fun u_________ => quartic_ A B C_ E_ F u_________) 1 (IZR u________)) 1 E_; Derive_n (fun F => let u_________ := 1%Z in Derive_n (fun u__________ => quartic_ A B C_ E_ F u__________) 1 (IZR u_________)) 1 F]].
Definition quartic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  mvec (transpose (inverse (quartic_data A B C_ E_ F))) [u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition k : R :=
  2.
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u_ => q4 A B C_ E_ F qm u_) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u_ => p4 A B C_ E_ F p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quartic_gap A B C_ E_ F o p0u p1 p1u qm u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quartic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) : list R :=
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z.
Definition quartic_criterion_ : R :=
  0.
Definition quartic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) : list R :=
  quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z.
Definition quartic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) : list R :=
  quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z.
Definition quartic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) : list R :=
  quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z.
Definition quartic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) : list R :=
  quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quartic_criterion A B C_ E_ F o p0u p1 p1u qm = zeros 3 /\ quartic_criterion__ A B C_ E_ F o p0u p1 p1u qm = zeros 3 /\ quartic_criterion___ A B C_ E_ F o p0u p1 p1u qm = zeros 3 /\ quartic_criterion____ A B C_ E_ F o p0u p1 p1u qm = zeros 3 /\ quartic_criterion_____ A B C_ E_ F o p0u p1 p1u qm = zeros 3 ->
  (let u := 1 / 2 in vDerive 3 (fun u_ => q4 A B C_ E_ F qm u_) 1 u) = [0; - 50; 70].
End ex_3_3_equation.

Module ex_3_3_equation_true.
(* hermite-developable/ex-3.3.equation.true, Sect. 3.3, example
   printed: The system (3.7) gives all six printed vectors.
   stated: p0u == [0, -30, 45] and qu == [0, -50, 70] and p1u == [0, -25, -15] and qm == [-20, 5, 35] and p1 == [40, -15, 45] and o == [100, 20, 45] *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  p0u = [0; - 30; 45] /\ qu = [0; - 50; 70] /\ p1u = [0; - 25; - 15] /\ qm = [- 20; 5; 35] /\ p1 = [40; - 15; 45] /\ o = [100; 20; 45].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_equation_true.

Module ex_3_3_p0u.
(* hermite-developable/ex-3.3.p0u, Sect. 3.3, example
   printed: p_0^u = <0, -30, 45>
   stated: agrees(p0u, [0, -30, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry p0u 1 = 0 /\ entry p0u 2 = (-30)) /\ entry p0u 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_p0u.

Module ex_3_3_qu.
(* hermite-developable/ex-3.3.qu, Sect. 3.3, example
   printed: q^u = <0, -50, 70>
   stated: agrees(qu, [0, -50, 70]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry qu 1 = 0 /\ entry qu 2 = (-50)) /\ entry qu 3 = 70.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_qu.

Module ex_3_3_p1u.
(* hermite-developable/ex-3.3.p1u, Sect. 3.3, example
   printed: p_1^u = <0, -25, -15>
   stated: agrees(p1u, [0, -25, -15]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry p1u 1 = 0 /\ entry p1u 2 = (-25)) /\ entry p1u 3 = (-15).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_p1u.

Module ex_3_3_q.
(* hermite-developable/ex-3.3.q, Sect. 3.3, example
   printed: q = <-20, 5, 35>
   stated: agrees(qm, [-20, 5, 35]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry qm 1 = (-20) /\ entry qm 2 = 5) /\ entry qm 3 = 35.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_q.

Module ex_3_3_p1.
(* hermite-developable/ex-3.3.p1, Sect. 3.3, example
   printed: p_1 = <40, -15, 45>
   stated: agrees(p1, [40, -15, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry p1 1 = 40 /\ entry p1 2 = (-15)) /\ entry p1 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_p1.

Module ex_3_3_o.
(* hermite-developable/ex-3.3.o, Sect. 3.3, example
   printed: o = <100, 20, 45>
   stated: agrees(o, [100, 20, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  (entry o 1 = 100 /\ entry o 2 = 20) /\ entry o 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End ex_3_3_o.

Module ex_3_3_parallel.
(* hermite-developable/ex-3.3.parallel, Sect. 3.3, example, with the section's assumption Gamma_1 // Gamma_2
   printed: in the parallel plane Gamma_1 // Gamma_2
   stated: p5'(u)[1] == 0 and q5'(u)[1] == 0 *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu (y1 : R) (z1 : R) : list R :=
  [0; y1; z1].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (y2 : R) (z2 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu (q1u y2 z2).
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (y1 : R) (z1 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u (pu y1 z1) p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu y2 z2 u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu y2 z2 u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u y1 z1 u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u y1 z1 u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y1 : R) (y2 : R) (z1 : R) (z2 : R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 ->
  entry (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u y1 z1 u_) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu y2 z2 u_) 1 u) 1 = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu y1 y2 z1 z2 = zeros 3).
End ex_3_3_parallel.

Module fig_4d_constant.
(* hermite-developable/fig-4d.constant, Sect. 3.3, sentence on Fig. 4d
   printed: the tangent planes a long the generatrix of the developable surfaces of Figure (4b) are constant
   stated: cross(at(normal(v), v, 0), normal(v)) == 0 *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; - 35].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0u p1 p1u u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z.
Definition patch (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) (v : Z) : list R :=
  vadd (vscale (1 - IZR v) (p5 A B C_ E_ F G p0u p1 p1u u)) (vscale (IZR v) (q5 A B C_ E_ F G qm qu u)).
Definition patch_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) (v : R) : list R :=
  vadd (vscale (1 - v) (p5 A B C_ E_ F G p0u p1 p1u u)) (vscale v (q5 A B C_ E_ F G qm qu u)).
Definition normal (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) (v : Z) : list R :=
  cross (vDerive 3 (fun u_ => patch A B C_ E_ F G p0u p1 p1u qm qu u_ v) 1 u) (vDerive 3 (fun v_ => patch_ A B C_ E_ F G p0u p1 p1u qm qu u v_) 1 (IZR v)).
Definition normal_ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) (v : R) : list R :=
  cross (vDerive 3 (fun u_ => patch_ A B C_ E_ F G p0u p1 p1u qm qu u_ v) 1 u) (vDerive 3 (fun v_ => patch_ A B C_ E_ F G p0u p1 p1u qm qu u v_) 1 v).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (v : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 ->
  cross (normal A B C_ E_ F G p0u p1 p1u qm qu u 0%Z) (normal_ A B C_ E_ F G p0u p1 p1u qm qu u v) = zeros 3.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (v : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 /\
  det (quintic_data A B C_ E_ F G) <> 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (quintic_criterion A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G o p0u p1 p1u qm qu = zeros 3).
End fig_4d_constant.
