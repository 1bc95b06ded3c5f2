(* Statements of hermite-developable, Section 3 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module eq_3_7_A_r1.
(* hermite-developable/eq-3.7.A.r1, Sect. 3.3, eq. (3.7), matrix A, row 1
   printed: (-4k, 16, -4k, 0, 24k, 0)
   stated: quintic_system[1] == [-4*k, 16, -4*k, 0, 24*k, 0] *)
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

Module eq_3_7_C_r1.
(* hermite-developable/eq-3.7.C.r1, Sect. 3.3, eq. (3.7), right-hand side, row 1
   printed: 24 k p_0 + 24 q_1 - 24 q_0 - 4 q_0^u - 4 q_1^u + 16 k p^u
   stated: blend6(A37[1], p0u, qu, p1u, qm, p1, o) - quintic_part(5) == 24*k*p0 + 24*q1 - 24*q0 - 4*q0u - 4*q1u + 16*k*pu *)
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u) / factorial n.
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
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
Definition statement : Prop :=
forall (k : R),
  det (A37 k) = 256 * k ^ 3 * (k - 1).
End eq_3_7_det.

Module eq_3_7_k_needed.
(* hermite-developable/eq-3.7.k.needed, Sect. 3.3, sentence before the solutions
   printed: Both exclusions are needed: at k = 0 and at k = 1 the system of the criterion has no unique solution.
   stated: at(det(quintic_system), k, 0) == 0 and at(det(quintic_system), k, 1) == 0 *)
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
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
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

Module eq_3_7_system.
(* hermite-developable/eq-3.7.system, Sect. 3.3, solutions of (3.7)
   printed: The printed matrix and right-hand side, with o for the last unknown, have the printed solutions.
   stated: solve(A37, right) == [q0u/k, k*pu, q1u/k, -k*p0 + q0 + k*pm, (k*p0 + q1 - q0)/k, (k*p0 - q0)/(k - 1)] *)
Definition A37 (k : R) : list (list R) :=
  [[- 4 * k; 16; - 4 * k; 0; 24 * k; 0]; [- 8 * k; 40; - 12 * k; 16; 68 * k; 0]; [35 * k; - 128; 27 * k; 32; - 174 * k; 0]; [- 33 * k; 88; - 14 * k; - 80; 95 * k; 0]; [11 * k; - 16; 2 * k; 32; - 14 * k; 0]; [- k; 0; 0; 0; 0; k - 1]].
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
