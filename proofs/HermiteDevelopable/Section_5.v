(* Statements of hermite-developable, Section 5. Nothing is proved here. *)
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
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition quintic_criterion_ : R :=
  0.
Definition q0 (h : R) (y2 : R) (z2 : R) : list R :=
  [h; y2; z2].
Definition q1 (h : R) (y3 : R) (z3 : R) : list R :=
  [h; y3; z3].
Definition q0u (y4 : R) (z4 : R) : list R :=
  [0; y4; z4].
Definition q1u (y5 : R) (z5 : R) : list R :=
  [0; y5; z5].
Definition p0 (l : R) (y0 : R) (z0 : R) : list R :=
  [l; y0; z0].
Definition pm (l : R) (y1 : R) (z1 : R) : list R :=
  [l; y1; z1].
Definition pu (y6 : R) (z6 : R) : list R :=
  [0; y6; z6].
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (q0u : list R) (q1 : list R) (q1u : list R) (qm : list R) (qu : list R) : list R :=
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z.
End Definitions.
Import Definitions.

Module sec_5_criteria_a.
(* hermite-developable/sec-5.criteria.a, Sect. 5, first paragraph
   printed: It has formulated the mathematics equations of the developable surface criteria that can be used to model the cubic, quartic, and quintic developable Hermite surfaces. [...] this formula can design the desired forms of the surfaces
   read as: first half; p is any Hermite curve of degree 5, cubic and quartic ones included: the curve q that the criterion (3.3) gives bounds a developable patch with it
   stated: det([p5'(u), q5'(u), q5(u) - p5(u)]) == 0 *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
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
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 ->
  det [vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u; vDerive 3 (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u; vsub (q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
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
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3).
End sec_5_criteria_a.

Module sec_5_criteria_reach.
(* hermite-developable/sec-5.criteria.reach, Sect. 5, first paragraph
   printed: What the criterion (3.3) can reach with Hermite curves: pieces of cones whose boundary curves are images of each other under a homothety with centre o and factor k. A cylinder, q = p + c, is among them only if p is a point or c is 0, and no tangent surface is.
   stated: q5(u) - o == k*(p5(u) - o) and q5'(u) - p5'(u) == (k - 1)*p5'(u) and q5(u) - p5(u) == (k - 1)*(p5(u) - o) *)
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
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
  quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 ->
  vsub (q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u) o = vscale k (vsub (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) o) /\ vsub (vDerive 3 (fun u_ => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u_) 1 u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) = vscale (k - 1) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u) /\ vsub (q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) = vscale (k - 1) (vsub (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) o).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o'1 o'2 o'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let o := [o'1; o'2; o'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
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
  (quintic_criterion A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu = zeros 3).
End sec_5_criteria_reach.

Module sec_5_planes_a.
(* hermite-developable/sec-5.planes.a, Sect. 5, second paragraph
   printed: The construction methods of the developable surface laid between two parallel and oblique planes have been presented
   read as: between parallel planes: the quintic patch of Sect. 3.3, which contains those of lower degree; the given data of q are in a plane x = h, those of p in a plane x = l, the rest is solved for
   stated: q5'(u)[1] == 0 and p5'(u)[1] == 0 and det([p5'(u), q5'(u), q5(u) - p5(u)]) == 0 *)
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (qm : list R) (qu : list R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (q0 h y2 z2) qm (q1 h y3 z3) (q0u y4 z4) qu (q1u y5 z5).
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (l : R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (y6 : R) (z0 : R) (z1 : R) (z6 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (p0 l y0 z0) (pm l y1 z1) p1 p0u (pu y6 z6) p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
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
  quintic_criterion A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 ->
  entry (vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u) 1 = 0 /\ det [vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u; vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u; vsub (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u)] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
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
  (quintic_criterion A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3).
End sec_5_planes_a.

Module sec_5_planes_parallel.
(* hermite-developable/sec-5.planes.parallel, Sect. 5, second paragraph
   printed: The patches of Sects. 3.1 to 3.3, those of order five, which contain the others, are developable between parallel planes.
   stated: q5'(u)[1] == 0 and p5'(u)[1] == 0 and det([p5'(u), q5'(u), q5(u) - p5(u)]) == 0 *)
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (qm : list R) (qu : list R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (q0 h y2 z2) qm (q1 h y3 z3) (q0u y4 z4) qu (q1u y5 z5).
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (l : R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (y6 : R) (z0 : R) (z1 : R) (z6 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (p0 l y0 z0) (pm l y1 z1) p1 p0u (pu y6 z6) p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) : list R :=
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 0%Z.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
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
  quintic_criterion A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 ->
  entry (vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u) 1 = 0 /\ det [vDerive 3 (fun u_ => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u_) 1 u; vDerive 3 (fun u_ => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u_) 1 u; vsub (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u)] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
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
  (quintic_criterion A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion__ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion___ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3 /\ quintic_criterion______ A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 = zeros 3).
End sec_5_planes_parallel.

Module sec_5_planes_b.
(* hermite-developable/sec-5.planes.b, Sect. 5, second paragraph
   printed: The construction methods of the developable surface laid between two parallel and oblique planes have been presented
   read as: between oblique planes: the patch of Sect. 4, decided on the example of that section, with its first plane
   stated: det([p5'(u), r5'(u), r5(u) - p5(u)]) == 0 *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition qm : list R :=
  [- 20; 5; 35].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition qu : list R :=
  [0; - 50; 70].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition k : R :=
  2.
Definition o : list R :=
  [100; 20; 45].
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G u) (vDerive 3 (fun u_ => q5 A B C_ E_ F G u_) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) (vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => quintic_gap A B C_ E_ F G p0 p0u p1 p1u pm pu u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition quintic_criterion (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z.
Definition quintic_criterion__ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z.
Definition quintic_criterion___ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z.
Definition quintic_criterion____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z.
Definition quintic_criterion_____ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z.
Definition quintic_criterion______ (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) : list R :=
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z.
Definition normal : list R :=
  cross [- 30; - 200; 0] [0; 0; 200].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 (image qm) (image q1) (vsub (image (vadd q0 q0u)) q0) (vsub (image (vadd qm qu)) (image qm)) (vsub (image (vadd q1 q1u)) (image q1)).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (u : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  quintic_criterion A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 /\ quintic_criterion__ A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 /\ quintic_criterion___ A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 /\ quintic_criterion____ A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 /\ quintic_criterion_____ A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 /\ quintic_criterion______ A B C_ E_ F G p0 p0u p1 p1u pm pu = zeros 3 ->
  dot (vsub qm o) normal <> 0 ->
  dot (vsub q1 o) normal <> 0 ->
  dot (vsub (vadd q0 q0u) o) normal <> 0 ->
  dot (vsub (vadd qm qu) o) normal <> 0 ->
  dot (vsub (vadd q1 q1u) o) normal <> 0 ->
  det [vDerive 3 (fun u_ => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u_) 1 u; vDerive 3 (fun u_ => r5 A B C_ E_ F G u_) 1 u; vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
End sec_5_planes_b.
