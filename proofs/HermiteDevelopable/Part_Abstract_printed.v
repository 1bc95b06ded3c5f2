(* Statements of hermite-developable, Part Abstract. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
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
Definition quintic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : R :=
  A * u ^ 5 + B * u ^ 4 + C_ * u ^ 3 + E_ * u ^ 2 + F * u + G.
Definition quintic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : list (list R) :=
  [[Derive_n (fun A => quintic A B C_ E_ F G 0) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 0) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 0) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 0) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 0) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 0) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G (1 / 2)) 1 A; Derive_n (fun B => quintic A B C_ E_ F G (1 / 2)) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G (1 / 2)) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G (1 / 2)) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G (1 / 2)) 1 F; Derive_n (fun G => quintic A B C_ E_ F G (1 / 2)) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G 1) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 1) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 1) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 1) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 1) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 1) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 G]].
Definition quintic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [u ^ 5; u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
End Definitions.
Import Definitions.

Module abs_construct_a.
(* hermite-developable/abs.construct.a, Abstract, second and last-but-one sentences
   printed: this paper introduces the construction of cubic, quartic, and quintic developable Hermite surfaces with their boundary curves placed in two parallel and oblique planes
   read as: cubic patches between parallel planes, by the system (3.5): q has free data in a plane x = h, p is solved for
   stated: q3'(u)[1] == 0 and p3'(u)[1] == 0 and det([p3'(u), q3'(u), q3(u) - p3(u)]) == 0 *)
Definition q0 (h : R) (y0 : R) (z0 : R) : list R :=
  [h; y0; z0].
Definition q1 (h : R) (y1 : R) (z1 : R) : list R :=
  [h; y1; z1].
Definition q0u (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition q1u (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition cubic (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : R :=
  A * u ^ 3 + B * u ^ 2 + C_ * u + E_.
Definition cubic_data (A : R) (B : R) (C_ : R) (E_ : R) : list (list R) :=
  [[Derive_n (fun A => cubic A B C_ E_ 0) 1 A; Derive_n (fun B => cubic A B C_ E_ 0) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 0) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 0) 1 E_]; [Derive_n (fun A => cubic A B C_ E_ 1) 1 A; Derive_n (fun B => cubic A B C_ E_ 1) 1 B; Derive_n (fun C_ => cubic A B C_ E_ 1) 1 C_; Derive_n (fun E_ => cubic A B C_ E_ 1) 1 E_]; [Derive_n (fun A => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => cubic A B C_ E_ u) 1 0) 1 E_]; [Derive_n (fun A => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => cubic A B C_ E_ u) 1 1) 1 E_]].
Definition cubic_basis (A : R) (B : R) (C_ : R) (E_ : R) (u : R) : list R :=
  mvec (transpose (inverse (cubic_data A B C_ E_))) [u ^ 3; u ^ 2; u; 1].
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
  entry (vDerive 3 (fun u => q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u) 1 = 0 /\ det [vDerive 3 (fun u => p3 A B C_ E_ p0 p0u p1 p1u u) 1 u; vDerive 3 (fun u => q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) 1 u; vsub (q3 A B C_ E_ h y0 y1 y2 y3 z0 z1 z2 z3 u) (p3 A B C_ E_ p0 p0u p1 p1u u)] = 0.
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
  (cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 3%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 2%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 1%Z = zeros 3 /\ cubic_part A B C_ E_ h k o p0 p0u p1 p1u y0 y1 y2 y3 z0 z1 z2 z3 0%Z = zeros 3).
End abs_construct_a.

Module abs_construct_b.
(* hermite-developable/abs.construct.b, Abstract, second and last-but-one sentences
   printed: this paper introduces the construction of cubic, quartic, and quintic developable Hermite surfaces with their boundary curves placed in two parallel and oblique planes
   read as: quartic patches between parallel planes, by the system (3.6): the given data of q are in a plane x = h, those of p in a plane x = l, the rest is solved for
   stated: q4'(u)[1] == 0 and p4'(u)[1] == 0 and det([p4'(u), q4'(u), q4(u) - p4(u)]) == 0 *)
Definition quartic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : R :=
  A * u ^ 4 + B * u ^ 3 + C_ * u ^ 2 + E_ * u + F.
Definition quartic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) : list (list R) :=
  [[Derive_n (fun A => quartic A B C_ E_ F 0) 1 A; Derive_n (fun B => quartic A B C_ E_ F 0) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 0) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 0) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 0) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F (1 / 2)) 1 A; Derive_n (fun B => quartic A B C_ E_ F (1 / 2)) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F (1 / 2)) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F (1 / 2)) 1 E_; Derive_n (fun F => quartic A B C_ E_ F (1 / 2)) 1 F]; [Derive_n (fun A => quartic A B C_ E_ F 1) 1 A; Derive_n (fun B => quartic A B C_ E_ F 1) 1 B; Derive_n (fun C_ => quartic A B C_ E_ F 1) 1 C_; Derive_n (fun E_ => quartic A B C_ E_ F 1) 1 E_; Derive_n (fun F => quartic A B C_ E_ F 1) 1 F]; [Derive_n (fun A => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 E_; Derive_n (fun F => Derive_n (fun u => quartic A B C_ E_ F u) 1 0) 1 F]; [Derive_n (fun A => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 E_; Derive_n (fun F => Derive_n (fun u => quartic A B C_ E_ F u) 1 1) 1 F]].
Definition quartic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) : list R :=
  mvec (transpose (inverse (quartic_data A B C_ E_ F))) [u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend5 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) : list R :=
  vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e).
Definition hermite4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (t : list R) : list R :=
  blend5 (quartic_basis A B C_ E_ F u) a m b s t.
Definition q4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (h : R) (qm : list R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite4 A B C_ E_ F u (q0 h y2 z2) qm (q1 h y3 z3) (q0u y4 z4) (q1u y5 z5).
Definition p4 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (l : R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (z0 : R) (z1 : R) (u : R) : list R :=
  hermite4 A B C_ E_ F u (p0 l y0 z0) (pm l y1 z1) p1 p0u p1u.
Definition quartic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  vsub (vsub (vadd (q4 A B C_ E_ F h qm y2 y3 y4 y5 z2 z3 z4 z5 u) (vDerive 3 (fun u => q4 A B C_ E_ F h qm y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u)) (vscale k (vadd (p4 A B C_ E_ F l p0u p1 p1u y0 y1 z0 z1 u) (vDerive 3 (fun u => p4 A B C_ E_ F l p0u p1 p1u y0 y1 z0 z1 u) 1 u)))) (vscale (1 - k) o).
Definition quartic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quartic_gap A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 u) (Z.to_nat n) u) (factorial n)) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
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
  quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 4%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 3%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 2%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 1%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 0%Z = zeros 3 ->
  entry (vDerive 3 (fun u => q4 A B C_ E_ F h qm y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => p4 A B C_ E_ F l p0u p1 p1u y0 y1 z0 z1 u) 1 u) 1 = 0 /\ det [vDerive 3 (fun u => p4 A B C_ E_ F l p0u p1 p1u y0 y1 z0 z1 u) 1 u; vDerive 3 (fun u => q4 A B C_ E_ F h qm y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u; vsub (q4 A B C_ E_ F h qm y2 y3 y4 y5 z2 z3 z4 z5 u) (p4 A B C_ E_ F l p0u p1 p1u y0 y1 z0 z1 u)] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (h : R) (k : R) (l : R) (o'1 o'2 o'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (qm'1 qm'2 qm'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  let o := [o'1; o'2; o'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
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
  (quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 4%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 3%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 2%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 1%Z = zeros 3 /\ quartic_part A B C_ E_ F h k l o p0u p1 p1u qm y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 0%Z = zeros 3).
End abs_construct_b.

Module abs_construct_c.
(* hermite-developable/abs.construct.c, Abstract, second and last-but-one sentences
   printed: this paper introduces the construction of cubic, quartic, and quintic developable Hermite surfaces with their boundary curves placed in two parallel and oblique planes
   read as: quintic patches between parallel planes, by the system (3.7): the given data of q are in a plane x = h, those of p in a plane x = l, the rest is solved for
   stated: q5'(u)[1] == 0 and p5'(u)[1] == 0 and det([p5'(u), q5'(u), q5(u) - p5(u)]) == 0 *)
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (qm : list R) (qu : list R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (q0 h y2 z2) qm (q1 h y3 z3) (q0u y4 z4) qu (q1u y5 z5).
Definition pu (y6 : R) (z6 : R) : list R :=
  [0; y6; z6].
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (l : R) (p0u : list R) (p1 : list R) (p1u : list R) (y0 : R) (y1 : R) (y6 : R) (z0 : R) (z1 : R) (z6 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (p0 l y0 z0) (pm l y1 z1) p1 p0u (pu y6 z6) p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (vDerive 3 (fun u => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) (vDerive 3 (fun u => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (h : R) (k : R) (l : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (y6 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (z6 : R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quintic_gap A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 u) (Z.to_nat n) u) (factorial n)) 0.
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
  quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 0%Z = zeros 3 ->
  entry (vDerive 3 (fun u => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u) 1 = 0 /\ entry (vDerive 3 (fun u => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) 1 u) 1 = 0 /\ det [vDerive 3 (fun u => p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u) 1 u; vDerive 3 (fun u => q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) 1 u; vsub (q5 A B C_ E_ F G h qm qu y2 y3 y4 y5 z2 z3 z4 z5 u) (p5 A B C_ E_ F G l p0u p1 p1u y0 y1 y6 z0 z1 z6 u)] = 0.
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
  (quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G h k l o p0u p1 p1u qm qu y0 y1 y2 y3 y4 y5 y6 z0 z1 z2 z3 z4 z5 z6 0%Z = zeros 3).
End abs_construct_c.

Module abs_construct_d.
(* hermite-developable/abs.construct.d, Abstract, second sentence
   printed: this paper introduces the construction of cubic, quartic, and quintic developable Hermite surfaces with their boundary curves placed in two parallel and oblique planes
   read as: patches between oblique planes, by the construction of Sect. 4; decided on the example of that section, with its first plane
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
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition k : R :=
  2.
Definition o : list R :=
  [100; 20; 45].
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G u) (vDerive 3 (fun u => q5 A B C_ E_ F G u) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quintic_gap A B C_ E_ F G p0 p0u p1 p1u pm pu u) (Z.to_nat n) u) (factorial n)) 0.
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
  quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3 ->
  dot (vsub qm o) normal <> 0 ->
  dot (vsub q1 o) normal <> 0 ->
  dot (vsub (vadd q0 q0u) o) normal <> 0 ->
  dot (vsub (vadd qm qu) o) normal <> 0 ->
  dot (vsub (vadd q1 q1u) o) normal <> 0 ->
  det [vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u; vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u; vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
End abs_construct_d.
