(* Statements of hermite-developable, Section 3 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
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
Definition A36 (k : R) : list (list R) :=
  [[16; 8 * k; 2 * k; - 2 * k; 0]; [32; 18 * k; 3 * k; - 5 * k; 0]; [- 80; - 37 * k; - 11 * k; 8 * k; 0]; [32; 10 * k; 7 * k; - 2 * k; 0]; [0; 0; - k; 0; k - 1]].
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (u : R) : R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (u : R) : R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (u : R) : R :=
  q4 A B C_ E_ F q0 q0u q1 q1u qm u + Derive_n (fun u => q4 A B C_ E_ F q0 q0u q1 q1u qm u) 1 u - k * (p4 A B C_ E_ F p0 p0u p1 p1u pm u + Derive_n (fun u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 u) - (1 - k) * o.
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => quartic_gap A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm u) (Z.to_nat n) u / factorial n) 0.
Definition quartic_system (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) : list (list R) :=
  [[Derive_n (fun qm => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z) 1 qm; Derive_n (fun p1 => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z) 1 p1; Derive_n (fun p0u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z) 1 p0u; Derive_n (fun p1u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z) 1 p1u; Derive_n (fun o => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z) 1 o]; [Derive_n (fun qm => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z) 1 qm; Derive_n (fun p1 => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z) 1 p1; Derive_n (fun p0u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z) 1 p0u; Derive_n (fun p1u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z) 1 p1u; Derive_n (fun o => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z) 1 o]; [Derive_n (fun qm => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z) 1 qm; Derive_n (fun p1 => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z) 1 p1; Derive_n (fun p0u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z) 1 p0u; Derive_n (fun p1u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z) 1 p1u; Derive_n (fun o => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z) 1 o]; [Derive_n (fun qm => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z) 1 qm; Derive_n (fun p1 => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z) 1 p1; Derive_n (fun p0u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z) 1 p0u; Derive_n (fun p1u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z) 1 p1u; Derive_n (fun o => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z) 1 o]; [Derive_n (fun qm => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z) 1 qm; Derive_n (fun p1 => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z) 1 p1; Derive_n (fun p0u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z) 1 p0u; Derive_n (fun p1u => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z) 1 p1u; Derive_n (fun o => quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z) 1 o]].
End Definitions.
Import Definitions.

Module sec_3_2_curves.
(* hermite-developable/sec-3.2.curves, Sect. 3.2, first sentences
   printed: p_4(u) = a_1 u^4 + b_1 u^3 + c_1 u^2 + d_1 u + e_1 and q_4(u) = a_2 u^4 + b_2 u^3 + c_2 u^2 + d_2 u + e_2 in the parallel plane Gamma_1 // Gamma_2; D(u,v) = (1-v) p_4(u) + v q_4(u); determining q_0, q_1, q_0^u, q_1^u, p_0, and p
   read as: the six data named last are given, the five others follow: the equations of the criterion determine them
   stated: quartic_system*solve(quartic_system, right) == right and solve(quartic_system, quartic_system*x) == x *)
Definition right_ (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) : list R :=
  [c1; c2; c3; c4; c5].
Definition x (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R) : list R :=
  [x1; x2; x3; x4; x5].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R),
  0 < k ->
  k <> 1 ->
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
  det (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) <> 0 ->
  mvec (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) (solve (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) (right_ c1 c2 c3 c4 c5)) = right_ c1 c2 c3 c4 c5 /\ solve (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) (mvec (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) (x x1 x2 x3 x4 x5)) = x x1 x2 x3 x4 x5.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (c1 : R) (c2 : R) (c3 : R) (c4 : R) (c5 : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (x1 : R) (x2 : R) (x3 : R) (x4 : R) (x5 : R),
  0 < k /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  det (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) <> 0.
End sec_3_2_curves.

Module eq_3_6_A_r1.
(* hermite-developable/eq-3.6.A.r1, Sect. 3.2, eq. (3.6), matrix A, row 1
   printed: (16, 8k, 2k, -2k, 0)
   stated: quartic_system[1] == [16, 8*k, 2*k, -2*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  row (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) 1 = [16; 8 * k; 2 * k; - 2 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_A_r1.

Module eq_3_6_A_r2.
(* hermite-developable/eq-3.6.A.r2, Sect. 3.2, eq. (3.6), matrix A, row 2
   printed: (32, 18k, 3k, -5k, 0)
   stated: quartic_system[2] == [32, 18*k, 3*k, -5*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  row (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) 2 = [32; 18 * k; 3 * k; - 5 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_A_r2.

Module eq_3_6_A_r3.
(* hermite-developable/eq-3.6.A.r3, Sect. 3.2, eq. (3.6), matrix A, row 3
   printed: (-80, -37k, -11k, 8k, 0)
   read as: the copy merges three columns: '-80 - 37k - 11k & 8k & 0'
   stated: quartic_system[3] == [-80, -37*k, -11*k, 8*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  row (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) 3 = [- 80; - 37 * k; - 11 * k; 8 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_A_r3.

Module eq_3_6_A_r4.
(* hermite-developable/eq-3.6.A.r4, Sect. 3.2, eq. (3.6), matrix A, row 4
   printed: (32, 10k, 7k, -2k, 0)
   stated: quartic_system[4] == [32, 10*k, 7*k, -2*k, 0] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  row (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) 4 = [32; 10 * k; 7 * k; - 2 * k; 0].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_A_r4.

Module eq_3_6_A_r5.
(* hermite-developable/eq-3.6.A.r5, Sect. 3.2, eq. (3.6), matrix A, row 5
   printed: (0, 0, -k, 0, k - 1)
   stated: quartic_system[5] == [0, 0, -k, 0, k - 1] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  row (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) 5 = [0; 0; - k; 0; k - 1].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_A_r5.

Module eq_3_6_B.
(* hermite-developable/eq-3.6.B, Sect. 3.2, eq. (3.6), column of unknowns
   printed: B = (q, p_1, p_1^u, q)
   read as: the copy lists four symbols for a matrix of five columns; at least one line is lost. The solutions are printed below the system in the order q, p_1, p_0^u, p_1^u, o
   stated: quartic_system*[qm, p1, p0u, p1u, o] == A36*[qm, p1, p0u, p1u, qm] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
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
  mvec (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) [qm; p1; p0u; p1u; o] = mvec (A36 k) [qm; p1; p0u; p1u; qm].
End eq_3_6_B.

Module eq_3_6_B_corrected.
(* hermite-developable/eq-3.6.B (corrected), Sect. 3.2, eq. (3.6), column of unknowns
   printed: B = (q, p_1, p_1^u, q)
   read as: the copy lists four symbols for a matrix of five columns; at least one line is lost. The solutions are printed below the system in the order q, p_1, p_0^u, p_1^u, o
   stated: quartic_system*[qm, p1, p0u, p1u, o] == A36*[qm, p1, p0u, p1u, o] *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
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
  mvec (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) [qm; p1; p0u; p1u; o] = mvec (A36 k) [qm; p1; p0u; p1u; o].
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_B_corrected.

Module eq_3_6_C_r1.
(* hermite-developable/eq-3.6.C.r1, Sect. 3.2, eq. (3.6), right-hand side, row 1
   printed: -8 k p_0 + 16 k p + 8 q_1 + 8 q_0 - 2 q_1^u + 2 q_0^u
   stated: blend5(A36[1], qm, p1, p0u, p1u, o) - quartic_part(4) == -8*k*p0 + 16*k*pm + 8*q1 + 8*q0 - 2*q1u + 2*q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  blend5 (row (A36 k) 1) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = - 8 * k * p0 + 16 * k * pm + 8 * q1 + 8 * q0 - 2 * q1u + 2 * q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0.
End eq_3_6_C_r1.

Module eq_3_6_C_r2.
(* hermite-developable/eq-3.6.C.r2, Sect. 3.2, eq. (3.6), right-hand side, row 2
   printed: -14 p_0 + 32 k p + 18 q_1 + 14 q_0 - 5 q_1^u + 3 q_0^u
   stated: blend5(A36[2], qm, p1, p0u, p1u, o) - quartic_part(3) == -14*p0 + 32*k*pm + 18*q1 + 14*q0 - 5*q1u + 3*q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  blend5 (row (A36 k) 2) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = - 14 * p0 + 32 * k * pm + 18 * q1 + 14 * q0 - 5 * q1u + 3 * q0u.
End eq_3_6_C_r2.

Module eq_3_6_C_r2_corrected.
(* hermite-developable/eq-3.6.C.r2 (corrected), Sect. 3.2, eq. (3.6), right-hand side, row 2
   printed: -14 p_0 + 32 k p + 18 q_1 + 14 q_0 - 5 q_1^u + 3 q_0^u
   stated: blend5(A36[2], qm, p1, p0u, p1u, o) - quartic_part(3) == k*(-14*p0) + 32*k*pm + 18*q1 + 14*q0 - 5*q1u + 3*q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  blend5 (row (A36 k) 2) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = k * (- 14 * p0) + 32 * k * pm + 18 * q1 + 14 * q0 - 5 * q1u + 3 * q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0.
End eq_3_6_C_r2_corrected.

Module eq_3_6_C_r3.
(* hermite-developable/eq-3.6.C.r3, Sect. 3.2, eq. (3.6), right-hand side, row 3
   printed: 43 k p_0 - 80 k p - 37 q_1 - 43 q_0 + 8 q_1^u - 11 q_0^u
   stated: blend5(A36[3], qm, p1, p0u, p1u, o) - quartic_part(2) == 43*k*p0 - 80*k*pm - 37*q1 - 43*q0 + 8*q1u - 11*q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  blend5 (row (A36 k) 3) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 43 * k * p0 - 80 * k * pm - 37 * q1 - 43 * q0 + 8 * q1u - 11 * q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0.
End eq_3_6_C_r3.

Module eq_3_6_C_r4.
(* hermite-developable/eq-3.6.C.r4, Sect. 3.2, eq. (3.6), right-hand side, row 4
   printed: -22 k p_0 + 32 k p + 10 q_1 + 22 q_0 - 2 q_1^u + 7 q_0^u
   stated: blend5(A36[4], qm, p1, p0u, p1u, o) - quartic_part(1) == -22*k*p0 + 32*k*pm + 10*q1 + 22*q0 - 2*q1u + 7*q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  blend5 (row (A36 k) 4) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = - 22 * k * p0 + 32 * k * pm + 10 * q1 + 22 * q0 - 2 * q1u + 7 * q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0.
End eq_3_6_C_r4.

Module eq_3_6_C_r5.
(* hermite-developable/eq-3.6.C.r5, Sect. 3.2, eq. (3.6), right-hand side, row 5
   printed: k p_0 - q_0 - q_1^u
   stated: blend5(A36[5], qm, p1, p0u, p1u, o) - quartic_part(0) == k*p0 - q0 - q1u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  blend5 (row (A36 k) 5) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = k * p0 - q0 - q1u.
End eq_3_6_C_r5.

Module eq_3_6_C_r5_corrected.
(* hermite-developable/eq-3.6.C.r5 (corrected), Sect. 3.2, eq. (3.6), right-hand side, row 5
   printed: k p_0 - q_0 - q_1^u
   stated: blend5(A36[5], qm, p1, p0u, p1u, o) - quartic_part(0) == k*p0 - q0 - q0u *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k ->
  k <> 1 ->
  det (quartic_data A B C_ E_ F) <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  blend5 (row (A36 k) 5) qm p1 p0u p1u o - quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = k * p0 - q0 - q0u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  0 < k /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0.
End eq_3_6_C_r5_corrected.

Module eq_3_6_det.
(* hermite-developable/eq-3.6.det, Sect. 3.2, sentence after (3.6)
   printed: det(A) = -2176 k^5 + 4336 k^4 - 2160 k^3
   stated: det(A36) == -2176*k^5 + 4336*k^4 - 2160*k^3 *)
Definition statement : Prop :=
forall (k : R),
  det (A36 k) = - 2176 * k ^ 5 + 4336 * k ^ 4 - 2160 * k ^ 3.
End eq_3_6_det.

Module eq_3_6_det_corrected.
(* hermite-developable/eq-3.6.det (corrected), Sect. 3.2, sentence after (3.6)
   printed: det(A) = -2176 k^5 + 4336 k^4 - 2160 k^3
   stated: det(A36) == 16*k^3*(1 - k) *)
Definition statement : Prop :=
forall (k : R),
  det (A36 k) = 16 * k ^ 3 * (1 - k).
End eq_3_6_det_corrected.

Module eq_3_6_det_true.
(* hermite-developable/eq-3.6.det.true, Sect. 3.2, sentence after (3.6)
   printed: The determinant of the printed matrix, which is that of the criterion, is -16 k^3 (k - 1): it has degree 4 and vanishes at k = 0 and k = 1 only.
   stated: det(A36) == -16*k^3*(k - 1) and det(quartic_system) == -16*k^3*(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  det (A36 k) = - 16 * k ^ 3 * (k - 1) /\ det (quartic_system A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm) = - 16 * k ^ 3 * (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
End eq_3_6_det_true.

Module eq_3_6_det_slip.
(* hermite-developable/eq-3.6.det.slip, Sect. 3.2, sentence after (3.6)
   printed: With 32 k for 32 in entry (2, 1) and -80 k for -80 in entry (3, 1) the determinant of the matrix is the printed polynomial, exactly.
   stated: det(slip) == -2176*k^5 + 4336*k^4 - 2160*k^3 *)
Definition slip (k : R) : list (list R) :=
  [[16; 8 * k; 2 * k; - 2 * k; 0]; [32 * k; 18 * k; 3 * k; - 5 * k; 0]; [- 80 * k; - 37 * k; - 11 * k; 8 * k; 0]; [32; 10 * k; 7 * k; - 2 * k; 0]; [0; 0; - k; 0; k - 1]].
Definition statement : Prop :=
forall (k : R),
  det (slip k) = - 2176 * k ^ 5 + 4336 * k ^ 4 - 2160 * k ^ 3.
End eq_3_6_det_slip.

Module eq_3_6_det_factored.
(* hermite-developable/eq-3.6.det-factored, Sect. 3.2, sentence after (3.6), second equality
   printed: -2176 k^5 + 4336 k^4 - 2160 k^3 = -16 k^3 (136 k - 135) (k - 1)
   stated: -2176*k^5 + 4336*k^4 - 2160*k^3 == -16*k^3*(136*k - 135)*(k - 1) *)
Definition statement : Prop :=
forall (k : R),
  - 2176 * k ^ 5 + 4336 * k ^ 4 - 2160 * k ^ 3 = - 16 * k ^ 3 * (136 * k - 135) * (k - 1).
End eq_3_6_det_factored.

Module eq_3_6_k.
(* hermite-developable/eq-3.6.k, Sect. 3.2, sentence before the solutions
   printed: If we choice k > 0, k != 1 and k != (135/136), then it obtains the solutions
   stated: qm == -k*p0 + q0 + k*pm and p1 == (k*p0 + q1 - q0)/k and p0u == q0u/k and p1u == q1u/k and o == (k*p0 - q0)/(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
  136 * k - 135 <> 0 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  k - 1 <> 0 ->
  qm = - k * p0 + q0 + k * pm /\ p1 = (k * p0 + q1 - q0) / k /\ p0u = q0u / k /\ p1u = q1u / k /\ o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  136 * k - 135 <> 0 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_6_k.

Module eq_3_6_k_every.
(* hermite-developable/eq-3.6.k.every, Sect. 3.2, sentence before the solutions
   printed: The third exclusion is not needed: the solutions hold for every k > 0 other than 1, at k = 135/136 too.
   stated: qm == -k*p0 + q0 + k*pm and p1 == (k*p0 + q1 - q0)/k and p0u == q0u/k and p1u == q1u/k and o == (k*p0 - q0)/(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  k - 1 <> 0 ->
  qm = - k * p0 + q0 + k * pm /\ p1 = (k * p0 + q1 - q0) / k /\ p0u = q0u / k /\ p1u = q1u / k /\ o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_6_k_every.

Module eq_3_6_k_135_136.
(* hermite-developable/eq-3.6.k.135-136, Sect. 3.2, sentence before the solutions
   printed: At k = 135/136 the system has one solution, the printed one.
   stated: det(A36) != 0 and qm == -k*p0 + q0 + k*pm and p1 == (k*p0 + q1 - q0)/k and p0u == q0u/k and p1u == q1u/k and o == (k*p0 - q0)/(k - 1) *)
Definition k : R :=
  135 / 136.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (u : R) : R :=
  q4 A B C_ E_ F q0 q0u q1 q1u qm u + Derive_n (fun u => q4 A B C_ E_ F q0 q0u q1 q1u qm u) 1 u - k * (p4 A B C_ E_ F p0 p0u p1 p1u pm u + Derive_n (fun u => p4 A B C_ E_ F p0 p0u p1 p1u pm u) 1 u) - (1 - k) * o.
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => quartic_gap A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm u) (Z.to_nat n) u / factorial n) 0.
Definition A36 : list (list R) :=
  [[16; 8 * k; 2 * k; - 2 * k; 0]; [32; 18 * k; 3 * k; - 5 * k; 0]; [- 80; - 37 * k; - 11 * k; 8 * k; 0]; [32; 10 * k; 7 * k; - 2 * k; 0]; [0; 0; - k; 0; k - 1]].
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
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
  quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  k - 1 <> 0 ->
  det A36 <> 0 /\ qm = - k * p0 + q0 + k * pm /\ p1 = (k * p0 + q1 - q0) / k /\ p0u = q0u / k /\ p1u = q1u / k /\ o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_6_k_135_136.

Module eq_3_6_sol_q.
(* hermite-developable/eq-3.6.sol.q, Sect. 3.2, solutions of (3.6)
   printed: q = -k p_0 + q_0 + k p
   stated: qm == -k*p0 + q0 + k*pm *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  qm = - k * p0 + q0 + k * pm.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0).
End eq_3_6_sol_q.

Module eq_3_6_sol_p1.
(* hermite-developable/eq-3.6.sol.p1, Sect. 3.2, solutions of (3.6)
   printed: p_1 = (k p_0 + q_1 - q_0)/k
   stated: p1 == (k*p0 + q1 - q0)/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  p1 = (k * p0 + q1 - q0) / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0.
End eq_3_6_sol_p1.

Module eq_3_6_sol_p0u.
(* hermite-developable/eq-3.6.sol.p0u, Sect. 3.2, solutions of (3.6)
   printed: p_0^u = (q_0^u)/k
   stated: p0u == q0u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  p0u = q0u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0.
End eq_3_6_sol_p0u.

Module eq_3_6_sol_p1u.
(* hermite-developable/eq-3.6.sol.p1u, Sect. 3.2, solutions of (3.6)
   printed: p_1^u = q_1^u/k
   stated: p1u == q1u/k *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k <> 0 ->
  p1u = q1u / k.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k <> 0.
End eq_3_6_sol_p1u.

Module eq_3_6_sol_o.
(* hermite-developable/eq-3.6.sol.o, Sect. 3.2, solutions of (3.6)
   printed: o = (k p_0 - q_0)/(k - 1)
   stated: o == (k*p0 - q0)/(k - 1) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  k - 1 <> 0 ->
  o = (k * p0 - q0) / (k - 1).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R),
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  k - 1 <> 0.
End eq_3_6_sol_o.

Module eq_3_6_system.
(* hermite-developable/eq-3.6.system, Sect. 3.2, solutions of (3.6)
   printed: With k p_0 for p_0 in row 2 and q_0^u for q_1^u in row 5 of the right-hand side the printed system has the printed solutions; as it stands its first unknown has another value, by 133/4 (k - 1) p_0.
   stated: solve(A36, right(k*p0, q0u)) == [-k*p0 + q0 + k*pm, (k*p0 + q1 - q0)/k, q0u/k, q1u/k, (k*p0 - q0)/(k - 1)] and solve(A36, right(p0, q1u))[1] == -k*p0 + q0 + k*pm + 133/4*(k - 1)*p0 *)
Definition right_ (k : R) (p0 : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (first : R) (last : R) : list R :=
  [- 8 * k * p0 + 16 * k * pm + 8 * q1 + 8 * q0 - 2 * q1u + 2 * q0u; - 14 * first + 32 * k * pm + 18 * q1 + 14 * q0 - 5 * q1u + 3 * q0u; 43 * k * p0 - 80 * k * pm - 37 * q1 - 43 * q0 + 8 * q1u - 11 * q0u; - 22 * k * p0 + 32 * k * pm + 10 * q1 + 22 * q0 - 2 * q1u + 7 * q0u; k * p0 - q0 - last].
Definition statement : Prop :=
forall (k : R) (p0 : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 ->
  k <> 1 ->
  det (A36 k) <> 0 ->
  k <> 0 ->
  k - 1 <> 0 ->
  solve (A36 k) (right_ k p0 pm q0 q0u q1 q1u (k * p0) q0u) = [- k * p0 + q0 + k * pm; (k * p0 + q1 - q0) / k; q0u / k; q1u / k; (k * p0 - q0) / (k - 1)] /\ entry (solve (A36 k) (right_ k p0 pm q0 q0u q1 q1u p0 q1u)) 1 = - k * p0 + q0 + k * pm + 133 / 4 * (k - 1) * p0.
Definition instance : Prop :=
exists (k : R) (p0 : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R),
  k > 0 /\
  k <> 1 /\
  det (A36 k) <> 0 /\
  k <> 0 /\
  k - 1 <> 0.
End eq_3_6_system.

Module sec_3_2_advantage.
(* hermite-developable/sec-3.2.advantage, Sect. 3.2, last sentence
   printed: we can move the intermediate control point p or q for changing the shape of the middle part of the developable surface (Figure (3b))
   stated: coefficients([p4(u), q4(u)], [pm]) == [[bump(u)], [k*bump(u)]] and bump(0) == 0 and bump(1) == 0 and bump'(0) == 0 and bump'(1) == 0 and bump(1/2) == 1 and 0 <= bump(u) <= 1 *)
Definition bump (u : R) : R :=
  16 * u ^ 2 * (1 - u) ^ 2.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (u : R) (qm_of_pm : R -> R) (p1_of_pm : R -> R) (p0u_of_pm : R -> R) (p1u_of_pm : R -> R) (o_of_pm : R -> R),
  0 < u < 1 ->
  k > 0 ->
  k <> 1 ->
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
  quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0 ->
  qm_of_pm pm = qm ->
  p1_of_pm pm = p1 ->
  p0u_of_pm pm = p0u ->
  p1u_of_pm pm = p1u ->
  o_of_pm pm = o ->
  (forall pm : R, quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 4%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 3%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 2%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 1%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 0%Z = 0) ->
  [[Derive_n (fun pm => p4 A B C_ E_ F p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm u) 1 pm]; [Derive_n (fun pm => q4 A B C_ E_ F q0 q0u q1 q1u (qm_of_pm pm) u) 1 pm]] = [[bump u]; [k * bump u]] /\ bump 0 = 0 /\ bump 1 = 0 /\ Derive_n (fun u => bump u) 1 0 = 0 /\ Derive_n (fun u => bump u) 1 1 = 0 /\ bump (1 / 2) = 1 /\ 0 <= bump u /\ bump u <= 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (u : R) (qm_of_pm : R -> R) (p1_of_pm : R -> R) (p0u_of_pm : R -> R) (p1u_of_pm : R -> R) (o_of_pm : R -> R),
  0 < u < 1 /\
  k > 0 /\
  k <> 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 4%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 3%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 2%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 1%Z = 0 /\ quartic_part A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm 0%Z = 0) /\
  qm_of_pm pm = qm /\
  p1_of_pm pm = p1 /\
  p0u_of_pm pm = p0u /\
  p1u_of_pm pm = p1u /\
  o_of_pm pm = o /\
  (forall pm : R, quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 4%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 3%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 2%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 1%Z = 0 /\ quartic_part A B C_ E_ F k (o_of_pm pm) p0 (p0u_of_pm pm) (p1_of_pm pm) (p1u_of_pm pm) pm q0 q0u q1 q1u (qm_of_pm pm) 0%Z = 0).
End sec_3_2_advantage.

Module ex_3_2_q.
(* hermite-developable/ex-3.2.q, Sect. 3.2, example
   printed: q = <-20, 5, 75>
   stated: agrees(qm, [-20, 5, 75]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 60].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm u) (Z.to_nat n) u) (factorial n)) 0.
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3 ->
  (entry qm 1 = (-20) /\ entry qm 2 = 5) /\ entry qm 3 = 75.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3).
End ex_3_2_q.

Module ex_3_2_p1.
(* hermite-developable/ex-3.2.p1, Sect. 3.2, example
   printed: p_1 = <40, -15, 45>
   stated: agrees(p1, [40, -15, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 60].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm u) (Z.to_nat n) u) (factorial n)) 0.
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3 ->
  (entry p1 1 = 40 /\ entry p1 2 = (-15)) /\ entry p1 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3).
End ex_3_2_p1.

Module ex_3_2_p0u.
(* hermite-developable/ex-3.2.p0u, Sect. 3.2, example
   printed: p_0^u = <0, -15, 30>
   stated: agrees(p0u, [0, -15, 30]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 60].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm u) (Z.to_nat n) u) (factorial n)) 0.
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3 ->
  (entry p0u 1 = 0 /\ entry p0u 2 = (-15)) /\ entry p0u 3 = 30.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3).
End ex_3_2_p0u.

Module ex_3_2_p1u.
(* hermite-developable/ex-3.2.p1u, Sect. 3.2, example
   printed: p_1^u = <0, -25, -30>
   stated: agrees(p1u, [0, -25, -30]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 60].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm u) (Z.to_nat n) u) (factorial n)) 0.
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3 ->
  (entry p1u 1 = 0 /\ entry p1u 2 = (-25)) /\ entry p1u 3 = (-30).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3).
End ex_3_2_p1u.

Module ex_3_2_o.
(* hermite-developable/ex-3.2.o, Sect. 3.2, example
   printed: o = <100, 20, 45>
   stated: agrees(o, [100, 20, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 60].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 pm p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm u) (Z.to_nat n) u) (factorial n)) 0.
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3 ->
  (entry o 1 = 100 /\ entry o 2 = 20) /\ entry o 3 = 45.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm 0%Z = zeros 3).
End ex_3_2_o.

Module ex_3_2_parallel.
(* hermite-developable/ex-3.2.parallel, Sect. 3.2, example, with the section's assumption Gamma_1 // Gamma_2
   printed: in the parallel plane Gamma_1 // Gamma_2
   stated: p4'(u)[1] == 0 and q4'(u)[1] == 0 *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 30; 60].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (qm : list R) (u : R) : list R :=
  hermite4 A B C_ E_ F u q0 qm q1 q0u q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm (y : R) (z : R) : list R :=
  [40; y; z].
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (p0u : list R) (p1 : list R) (p1u : list R) (y : R) (z : R) (u : R) : list R :=
  hermite4 A B C_ E_ F u p0 (pm y z) p1 p0u p1u.
Definition k : R :=
  2.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (y : R) (z : R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F qm u) (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F p0u p1 p1u y z u) (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u y z u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (y : R) (z : R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F o p0u p1 p1u qm y z u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (u : R) (y : R) (z : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  0 < u < 1 ->
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
  quartic_part A B C_ E_ F o p0u p1 p1u qm y z 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 0%Z = zeros 3 ->
  entry (vDerive 3 (fun u => p4 A B C_ E_ F p0u p1 p1u y z u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => q4 A B C_ E_ F qm u) 1 u) 1 = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (u : R) (y : R) (z : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  0 < u < 1 /\
  det (quartic_data A B C_ E_ F) <> 0 /\
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
  (quartic_part A B C_ E_ F o p0u p1 p1u qm y z 4%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 3%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 2%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 1%Z = zeros 3 /\ quartic_part A B C_ E_ F o p0u p1 p1u qm y z 0%Z = zeros 3).
End ex_3_2_parallel.
