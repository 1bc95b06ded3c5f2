(* Statements of hermite-developable, Section 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition quintic (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : R :=
  A * u ^ 5 + B * u ^ 4 + C_ * u ^ 3 + E_ * u ^ 2 + F * u + G.
Definition quintic_data (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) : list (list R) :=
  [[Derive_n (fun A => quintic A B C_ E_ F G 0) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 0) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 0) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 0) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 0) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 0) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G (1 / 2)) 1 A; Derive_n (fun B => quintic A B C_ E_ F G (1 / 2)) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G (1 / 2)) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G (1 / 2)) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G (1 / 2)) 1 F; Derive_n (fun G => quintic A B C_ E_ F G (1 / 2)) 1 G]; [Derive_n (fun A => quintic A B C_ E_ F G 1) 1 A; Derive_n (fun B => quintic A B C_ E_ F G 1) 1 B; Derive_n (fun C_ => quintic A B C_ E_ F G 1) 1 C_; Derive_n (fun E_ => quintic A B C_ E_ F G 1) 1 E_; Derive_n (fun F => quintic A B C_ E_ F G 1) 1 F; Derive_n (fun G => quintic A B C_ E_ F G 1) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 0) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 (1 / 2)) 1 G]; [Derive_n (fun A => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 A; Derive_n (fun B => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 B; Derive_n (fun C_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 C_; Derive_n (fun E_ => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 E_; Derive_n (fun F => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 F; Derive_n (fun G => Derive_n (fun u => quintic A B C_ E_ F G u) 1 1) 1 G]].
Definition quintic_basis (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  mvec (transpose (inverse (quintic_data A B C_ E_ F G))) [u ^ 5; u ^ 4; u ^ 3; u ^ 2; u; 1].
Definition blend6 (w : list R) (a : list R) (b : list R) (c : list R) (d : list R) (e : list R) (f : list R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d)) (vscale (entry w 5) e)) (vscale (entry w 6) f).
Definition r0 (q0 : list R) : list R :=
  q0.
Definition chord (c : list R) (dc : list R) (x : R) : list R :=
  vadd c (vscale x dc).
Definition last (q1 : list R) (q1u : list R) (x : R) : list R :=
  vadd q1 (vscale x q1u).
Definition a : list R :=
  [- 30; - 200; 0].
Definition d : list R :=
  [0; 0; 200].
Definition normal (a : list R) (d : list R) : list R :=
  cross a d.
Definition image (a : list R) (d : list R) (o : list R) (q0 : list R) (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) (normal a d) / dot (vsub x o) (normal a d)) (vsub x o)).
Definition r1 (a : list R) (d : list R) (o : list R) (q0 : list R) (q1 : list R) : list R :=
  image a d o q0 q1.
Definition r0u (a : list R) (d : list R) (o : list R) (q0 : list R) (q0u : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub q0 o) q0u) (normal a d)) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition r1u (a : list R) (d : list R) (o : list R) (q0 : list R) (q1 : list R) (q1u : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub q1 o) q1u) (normal a d)) (vadd (vsub q1 o) q1u)) (vsub (r1 a d o q0 q1) o).
End Definitions.
Import Definitions.

Module sec_4_cone.
(* hermite-developable/sec-4.cone, Sect. 4, first sentence
   printed: a quintic developable Hermite surface of cone surface type D_5(u,v) = (1-v) p_5(u) + v q_5(u), [...] with p_5(u) and q_5(u) in the planes Gamma_1 // Gamma_2, respectively, and the summit of this cone surface at the point O
   stated: q5(u) - o == k*(p5(u) - o) *)
Definition blend6 (w : list R) (a : R) (b : R) (c : R) (d : R) (e : R) (f : R) : R :=
  entry w 1 * a + entry w 2 * b + entry w 3 * c + entry w 4 * d + entry w 5 * e + entry w 6 * f.
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : R) (m : R) (b : R) (s : R) (r : R) (t : R) : R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (u : R) : R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R) : R :=
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u + Derive_n (fun u => q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u) 1 u - k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u + Derive_n (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) - (1 - k) * o.
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (n : Z) : R :=
  (fun u : R => Derive_n (fun u => quintic_gap A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu u) (Z.to_nat n) u / factorial n) 0.
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R),
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
  quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z = 0 ->
  q5 A B C_ E_ F G q0 q0u q1 q1u qm qu u - o = k * (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u - o).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (o : R) (p0 : R) (p0u : R) (p1 : R) (p1u : R) (pm : R) (pu : R) (q0 : R) (q0u : R) (q1 : R) (q1u : R) (qm : R) (qu : R) (u : R),
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
  (quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 5%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 4%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 3%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 2%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 1%Z = 0 /\ quintic_part A B C_ E_ F G k o p0 p0u p1 p1u pm pu q0 q0u q1 q1u qm qu 0%Z = 0).
End sec_4_cone.

Module eq_4_1.
(* hermite-developable/eq-4.1, Sect. 4, eq. (4.1)
   printed: Gamma_3(u,v) = q_0 + u a + v d
   read as: q_0 is a point of the plane, a and d are directions in it
   stated: oblique(0, 0) == q0 and dot(oblique(u, v) - q0, normal) == 0 *)
Definition oblique (a : list R) (d : list R) (q0 : list R) (u : R) (v : R) : list R :=
  vadd (vadd q0 (vscale u a)) (vscale v d).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (q0'1 q0'2 q0'3 : R) (u : R) (v : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  0 < u < 1 ->
  oblique a d q0 0 0 = q0 /\ dot (vsub (oblique a d q0 u v) q0) (normal a d) = 0.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (q0'1 q0'2 q0'3 : R) (u : R) (v : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  0 < u < 1.
End eq_4_1.

Module sec_4_goal_designed.
(* hermite-developable/sec-4.goal.designed, Sect. 4, paragraph after (4.1)
   printed: the transformation of the curve q_5(u) in Gamma_2 to the curve image r_5(u) in Gamma_3 relative to the summit point O of the cone surface D_5(u,v) such that p_5(u), q_5(u), and r_5(u) construct the developable surface
   read as: r_5 is the Hermite curve designed from the six projected data; in affine coordinates with the summit at 0, q in the plane x = 1 with q_0 = <1, 0, 0>, and the oblique plane x + y = 1: every case is of this form, since affine maps keep planes, Hermite curves, projections and developable patches; p = q/k by the criterion
   stated: det([p5'(u), r5'(u), r5(u) - p5(u)]) == 0 *)
Definition q0 : list R :=
  [1; 0; 0].
Definition qm (y1 : R) (z1 : R) : list R :=
  [1; y1; z1].
Definition q1 (y2 : R) (z2 : R) : list R :=
  [1; y2; z2].
Definition q0u (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition qu (y4 : R) (z4 : R) : list R :=
  [0; y4; z4].
Definition q1u (y5 : R) (z5 : R) : list R :=
  [0; y5; z5].
Definition o : list R :=
  [0; 0; 0].
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 (qm y1 z1) (q1 y2 z2) (q0u y3 z3) (qu y4 z4) (q1u y5 z5).
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  vadd o (vscale (1 / k) (vsub (q5 A B C_ E_ F G y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) o)).
Definition r0 : list R :=
  q0.
Definition normal : list R :=
  [1; 1; 0].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r (y1 : R) (z1 : R) : list R :=
  image (qm y1 z1).
Definition r1 (y2 : R) (z2 : R) : list R :=
  image (q1 y2 z2).
Definition r0u (y3 : R) (z3 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) (q0u y3 z3)) normal) (vadd (vsub q0 o) (q0u y3 z3))) (vsub q0 o).
Definition ru (y1 : R) (y4 : R) (z1 : R) (z4 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub (qm y1 z1) o) (qu y4 z4)) normal) (vadd (vsub (qm y1 z1) o) (qu y4 z4))) (vsub (r y1 z1) o).
Definition r1u (y2 : R) (y5 : R) (z2 : R) (z5 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub (q1 y2 z2) o) (q1u y5 z5)) normal) (vadd (vsub (q1 y2 z2) o) (q1u y5 z5))) (vsub (r1 y2 z2) o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 (r y1 z1) (r1 y2 z2) (r0u y3 z3) (ru y1 y4 z1 z4) (r1u y2 y5 z2 z5).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (k : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  0 < u < 1 ->
  k > 0 ->
  k <> 1 ->
  k <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  dot (vsub (qm y1 z1) o) normal <> 0 ->
  dot (vsub (q1 y2 z2) o) normal <> 0 ->
  dot (vadd (vsub q0 o) (q0u y3 z3)) normal <> 0 ->
  dot (vadd (vsub (qm y1 z1) o) (qu y4 z4)) normal <> 0 ->
  dot (vadd (vsub (q1 y2 z2) o) (q1u y5 z5)) normal <> 0 ->
  det [vDerive 3 (fun u => p5 A B C_ E_ F G k y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) 1 u; vDerive 3 (fun u => r5 A B C_ E_ F G y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) 1 u; vsub (r5 A B C_ E_ F G y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) (p5 A B C_ E_ F G k y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u)] = 0.
End sec_4_goal_designed.

Module sec_4_goal_image.
(* hermite-developable/sec-4.goal.image, Sect. 4, paragraph after (4.1)
   printed: the transformation of the curve q_5(u) in Gamma_2 to the curve image r_5(u) in Gamma_3 relative to the summit point O of the cone surface D_5(u,v) such that p_5(u), q_5(u), and r_5(u) construct the developable surface
   read as: r_5 is the image of q_5 under the projection from O to the plane; c and dc are q_5 and its derivative at one u, p is q seen from the summit
   stated: det([dp, dr, image(c) - p]) == 0 and dot(image(c) - q0, normal) == 0 and cross(image(c) - o, c - o) == 0 *)
Definition dp (dc : list R) (k : R) : list R :=
  vdiv dc k.
Definition dr (a : list R) (c : list R) (d : list R) (dc : list R) (o : list R) (q0 : list R) : list R :=
  (fun x : R => vDerive 3 (fun x => image a d o q0 (chord c dc x)) 1 x) 0.
Definition p (c : list R) (k : R) (o : list R) : list R :=
  vadd o (vdiv (vsub c o) k).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (dc'1 dc'2 dc'3 : R) (k : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let dc := [dc'1; dc'2; dc'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub c o) (normal a d) <> 0 ->
  k <> 0 ->
  locally 0 (fun x => dot (vsub (chord c dc x) o) (normal a d) <> 0) ->
  det [dp dc k; dr a c d dc o q0; vsub (image a d o q0 c) (p c k o)] = 0 /\ dot (vsub (image a d o q0 c) q0) (normal a d) = 0 /\ cross (vsub (image a d o q0 c) o) (vsub c o) = zeros 3.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (dc'1 dc'2 dc'3 : R) (k : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let dc := [dc'1; dc'2; dc'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub c o) (normal a d) <> 0 /\
  k <> 0 /\
  locally 0 (fun x => dot (vsub (chord c dc x) o) (normal a d) <> 0).
End sec_4_goal_image.

Module sec_4_goal_leaves.
(* hermite-developable/sec-4.goal.leaves, Sect. 4, paragraph after (4.1)
   printed: The Hermite curve of the projected data is not on the cone in general: between u = 0, 1/2 and 1 it leaves the generatrices.
   read as: in affine coordinates with the summit at 0, q in the plane x = 1 with q_0 = <1, 0, 0>, and the oblique plane x + y = 1: every case is of this form, since affine maps keep planes, Hermite curves, projections and developable patches
   stated: fails(cross(r5(u) - o, q5(u) - o) == 0) *)
Definition q0 : list R :=
  [1; 0; 0].
Definition r0 : list R :=
  q0.
Definition qm (y1 : R) (z1 : R) : list R :=
  [1; y1; z1].
Definition o : list R :=
  [0; 0; 0].
Definition normal : list R :=
  [1; 1; 0].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r (y1 : R) (z1 : R) : list R :=
  image (qm y1 z1).
Definition q1 (y2 : R) (z2 : R) : list R :=
  [1; y2; z2].
Definition r1 (y2 : R) (z2 : R) : list R :=
  image (q1 y2 z2).
Definition q0u (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition r0u (y3 : R) (z3 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) (q0u y3 z3)) normal) (vadd (vsub q0 o) (q0u y3 z3))) (vsub q0 o).
Definition qu (y4 : R) (z4 : R) : list R :=
  [0; y4; z4].
Definition ru (y1 : R) (y4 : R) (z1 : R) (z4 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub (qm y1 z1) o) (qu y4 z4)) normal) (vadd (vsub (qm y1 z1) o) (qu y4 z4))) (vsub (r y1 z1) o).
Definition q1u (y5 : R) (z5 : R) : list R :=
  [0; y5; z5].
Definition r1u (y2 : R) (y5 : R) (z2 : R) (z5 : R) : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub (q1 y2 z2) o) (q1u y5 z5)) normal) (vadd (vsub (q1 y2 z2) o) (q1u y5 z5))) (vsub (r1 y2 z2) o).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 (r y1 z1) (r1 y2 z2) (r0u y3 z3) (ru y1 y4 z1 z4) (r1u y2 y5 z2 z5).
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 (qm y1 z1) (q1 y2 z2) (q0u y3 z3) (qu y4 z4) (q1u y5 z5).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  0 < u < 1 ->
  ~ (forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  0 < u < 1 ->
  dot (vsub (qm y1 z1) o) normal <> 0 ->
  dot (vsub (q1 y2 z2) o) normal <> 0 ->
  dot (vadd (vsub q0 o) (q0u y3 z3)) normal <> 0 ->
  dot (vadd (vsub (qm y1 z1) o) (qu y4 z4)) normal <> 0 ->
  dot (vadd (vsub (q1 y2 z2) o) (q1u y5 z5)) normal <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  cross (vsub (r5 A B C_ E_ F G y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) o) (vsub (q5 A B C_ E_ F G y1 y2 y3 y4 y5 z1 z2 z3 z4 z5 u) o) = zeros 3).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  0 < u < 1.
End sec_4_goal_leaves.

Module sec_4_goal_nodes.
(* hermite-developable/sec-4.goal.nodes, Sect. 4, paragraph after (4.1)
   printed: What (4.2) to (4.4) reach: at u = 0, 1/2 and 1 the tangent vectors of p and r and the generatrix are coplanar, so that the patch has one tangent plane along each of these three generatrices.
   stated: det([q0u, r0u, r0 - o]) == 0 and det([qu, ru, r - o]) == 0 and det([q1u, r1u, r1 - o]) == 0 *)
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition ru (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) (qu : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  det [q0u; r0u a d o q0 q0u; vsub (r0 q0) o] = 0 /\ det [qu; ru a d o q0 qm qu; vsub (r a d o q0 qm) o] = 0 /\ det [q1u; r1u a d o q0 q1 q1u; vsub (r1 a d o q0 q1) o] = 0.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  dot (vsub qm o) (normal a d) <> 0 /\
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 /\
  dot (vsub q1 o) (normal a d) <> 0 /\
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0.
End sec_4_goal_nodes.

Module sec_4_goal_only.
(* hermite-developable/sec-4.goal.only, Sect. 4, paragraph after (4.1)
   printed: The only curve in the oblique plane whose points are on the generatrices of the cone is the central image of q, a rational curve: r - o is q - o times (q_0 - o).n / (q - o).n with n = a /\ d.
   stated: o + w*(c - o) == image(c) and dot(c - o, normal)*(o + w*(c - o) - o) == dot(q0 - o, normal)*(c - o) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (w : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub c o) (normal a d) <> 0 ->
  dot (vsub (vadd o (vscale w (vsub c o))) q0) (normal a d) = 0 ->
  vadd o (vscale w (vsub c o)) = image a d o q0 c /\ vscale (dot (vsub c o) (normal a d)) (vsub (vadd o (vscale w (vsub c o))) o) = vscale (dot (vsub q0 o) (normal a d)) (vsub c o).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (w : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub c o) (normal a d) <> 0 /\
  dot (vsub (vadd o (vscale w (vsub c o))) q0) (normal a d) = 0.
End sec_4_goal_only.

Module sec_4_goal_parallel.
(* hermite-developable/sec-4.goal.parallel, Sect. 4, paragraph after (4.1)
   printed: Hermite curves in oblique planes that bound a developable patch exist for every p and every direction c across the oblique plane: the projection along c takes the points and tangent vectors of p to those of its image, and the patch is a cylinder.
   stated: r(u) == shadow(p5(u)) and dot(r(u) - q0, normal) == 0 and cross(r(u) - p5(u), c) == 0 and det([x, turned(x), c]) == 0 *)
Definition shadow (a : list R) (c : list R) (d : list R) (q0 : list R) (x : list R) : list R :=
  vsub x (vscale (dot (vsub x q0) (normal a d) / dot c (normal a d)) c).
Definition turned (a : list R) (c : list R) (d : list R) (x : list R) : list R :=
  vsub x (vscale (dot x (normal a d) / dot c (normal a d)) c).
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition r (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (a : list R) (c : list R) (d : list R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (q0 : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u (shadow a c d q0 p0) (shadow a c d q0 pm) (shadow a c d q0 p1) (turned a c d p0u) (turned a c d pu) (turned a c d p1u).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let x := [x'1; x'2; x'3] in
  0 < u < 1 ->
  dot c (normal a d) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  r A B C_ E_ F G a c d p0 p0u p1 p1u pm pu q0 u = shadow a c d q0 (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) /\ dot (vsub (r A B C_ E_ F G a c d p0 p0u p1 p1u pm pu q0 u) q0) (normal a d) = 0 /\ cross (vsub (r A B C_ E_ F G a c d p0 p0u p1 p1u pm pu q0 u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)) c = zeros 3 /\ det [x; turned a c d x; c] = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (q0'1 q0'2 q0'3 : R) (u : R) (x'1 x'2 x'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let x := [x'1; x'2; x'3] in
  0 < u < 1 /\
  dot c (normal a d) <> 0 /\
  det (quintic_data A B C_ E_ F G) <> 0.
End sec_4_goal_parallel.

Module sec_4_in_plane.
(* hermite-developable/sec-4.in-plane, Sect. 4, paragraph after (4.1)
   printed: we have to find the control points and the tangent vectors r_0, r, r_1, r_0^u, r^u, and r_1^u in Gamma_3 as the projection images of the q_0, q, q_1, q_0^u, q^u, and q_1^u in Gamma_2, correspondingly, for designing the curve r_5(u)
   stated: dot(r0 - q0, normal) == 0 and dot(r - q0, normal) == 0 and dot(r1 - q0, normal) == 0 and dot(r0u, normal) == 0 and dot(ru, normal) == 0 and dot(r1u, normal) == 0 and quintic_basis(u)[1] + quintic_basis(u)[2] + quintic_basis(u)[3] == 1 *)
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition ru (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) (qu : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 ->
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  det (quintic_data A B C_ E_ F G) <> 0 ->
  dot (vsub (r0 q0) q0) (normal a d) = 0 /\ dot (vsub (r a d o q0 qm) q0) (normal a d) = 0 /\ dot (vsub (r1 a d o q0 q1) q0) (normal a d) = 0 /\ dot (r0u a d o q0 q0u) (normal a d) = 0 /\ dot (ru a d o q0 qm qu) (normal a d) = 0 /\ dot (r1u a d o q0 q1 q1u) (normal a d) = 0 /\ entry (quintic_basis A B C_ E_ F G u) 1 + entry (quintic_basis A B C_ E_ F G u) 2 + entry (quintic_basis A B C_ E_ F G u) 3 = 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (u : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  0 < u < 1 /\
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  dot (vsub qm o) (normal a d) <> 0 /\
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 /\
  dot (vsub q1 o) (normal a d) <> 0 /\
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 /\
  det (quintic_data A B C_ E_ F G) <> 0.
End sec_4_in_plane.

Module sec_4_r0.
(* hermite-developable/sec-4.r0, Sect. 4, paragraph 'We determine'
   printed: r_0 = q_0
   stated: image(q0) == r0 *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub q0 o) (normal a d) <> 0 ->
  image a d o q0 q0 = r0 q0.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  dot (vsub q0 o) (normal a d) <> 0.
End sec_4_r0.

Module sec_4_I1.
(* hermite-developable/sec-4.I1, Sect. 4, paragraph 'We determine'
   printed: I_1 = o + w[(q_0 - o) + q_0^u] = q_0 + u a + v d
   read as: x1, x2 are the parameters u, v of the plane at the point of intersection
   stated: w == dot(q0 - o, normal)/dot(q0 - o + q0u, normal) and dot(o + w*(q0 - o + q0u) - q0, normal) == 0 *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  w = dot (vsub q0 o) (normal a d) / dot (vadd (vsub q0 o) q0u) (normal a d) /\ dot (vsub (vadd o (vscale w (vadd (vsub q0 o) q0u))) q0) (normal a d) = 0.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d).
End sec_4_I1.

Module sec_4_w.
(* hermite-developable/sec-4.w, Sect. 4, paragraph 'We determine'
   printed: w = [(q_0 - o).(a /\ d)]/[((q_0 - o) + q_0^u).(a /\ d)]
   read as: x1, x2 are the parameters u, v of the plane at the point of intersection
   stated: w == dot(q0 - o, cross(a, d))/dot(q0 - o + q0u, cross(a, d)) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vadd (vsub q0 o) q0u) (cross a d) <> 0 ->
  w = dot (vsub q0 o) (cross a d) / dot (vadd (vsub q0 o) q0u) (cross a d).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vadd (vsub q0 o) q0u) (cross a d) <> 0.
End sec_4_w.

Module eq_4_2.
(* hermite-developable/eq-4.2, Sect. 4, eq. (4.2)
   printed: r_0^u = [ (q_0 - o).(a /\ d) / (((q_0 - o) + q_0^u).(a /\ d)) ] [(q_0 - o) + q_0^u] - (q_0 - o)
   read as: r_0^u is the vector from r_0 = q_0 to I_1; x1, x2 are the parameters u, v of the plane there
   stated: o + w*(q0 - o + q0u) - q0 == dot(q0 - o, cross(a, d))/dot(q0 - o + q0u, cross(a, d))*(q0 - o + q0u) - (q0 - o) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vadd (vsub q0 o) q0u) (cross a d) <> 0 ->
  vsub (vadd o (vscale w (vadd (vsub q0 o) q0u))) q0 = vsub (vscale (dot (vsub q0 o) (cross a d) / dot (vadd (vsub q0 o) q0u) (cross a d)) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R) (w : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  vadd o (vscale w (vadd (vsub q0 o) q0u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vadd (vsub q0 o) q0u) (cross a d) <> 0.
End eq_4_2.

Module eq_4_2_tangent_derivative.
(* hermite-developable/eq-4.2.tangent.derivative, Sect. 4, sentence before (4.2)
   printed: The projection of tangent vector q_0^u in Gamma_2 to r_0^u in Gamma_3
   read as: r_0^u is the tangent vector of the projected curve at u = 0; it depends on q_0 and q_0^u only, so that the line q_0 + x q_0^u stands for q
   stated: at(D(image(chord(x)), x), x, 0) == r0u *)
Definition chord (q0 : list R) (q0u : list R) (x : R) : list R :=
  vadd q0 (vscale x q0u).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  dot (vsub q0 o) (normal a d) <> 0 ->
  locally 0 (fun x => dot (vsub (chord q0 q0u x) o) (normal a d) <> 0) ->
  (fun x : R => vDerive 3 (fun x => image a d o q0 (chord q0 q0u x)) 1 x) 0 = r0u a d o q0 q0u.
End eq_4_2_tangent_derivative.

Module eq_4_2_tangent_end_point.
(* hermite-developable/eq-4.2.tangent.end point, Sect. 4, sentence before (4.2)
   printed: The projection of tangent vector q_0^u in Gamma_2 to r_0^u in Gamma_3
   read as: r_0^u is the vector from r_0 to the image of the end point of q_0^u
   stated: image(q0 + q0u) - r0 == r0u *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  dot (vsub (vadd q0 q0u) o) (normal a d) <> 0 ->
  vsub (image a d o q0 (vadd q0 q0u)) (r0 q0) = r0u a d o q0 q0u.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  dot (vsub (vadd q0 q0u) o) (normal a d) <> 0.
End eq_4_2_tangent_end_point.

Module eq_4_2_tangent_parallel.
(* hermite-developable/eq-4.2.tangent.parallel, Sect. 4, eq. (4.2)
   printed: The vector (4.2) is the tangent vector of the projected curve times (q_0 - o).(a /\ d) / ((q_0 - o) + q_0^u).(a /\ d): it has its direction, and its length only if q_0^u is parallel to the plane.
   stated: r0u == dot(q0 - o, normal)/dot(q0 - o + q0u, normal)*at(D(image(chord(x)), x), x, 0) *)
Definition chord (q0 : list R) (q0u : list R) (x : R) : list R :=
  vadd q0 (vscale x q0u).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 ->
  dot (vsub q0 o) (normal a d) <> 0 ->
  locally 0 (fun x => dot (vsub (chord q0 q0u x) o) (normal a d) <> 0) ->
  r0u a d o q0 q0u = vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub q0 o) q0u) (normal a d)) ((fun x : R => vDerive 3 (fun x => image a d o q0 (chord q0 q0u x)) 1 x) 0).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vadd (vsub q0 o) q0u) (normal a d) <> 0 /\
  dot (vsub q0 o) (normal a d) <> 0 /\
  locally 0 (fun x => dot (vsub (chord q0 q0u x) o) (normal a d) <> 0).
End eq_4_2_tangent_parallel.

Module eq_4_2_tangent_true.
(* hermite-developable/eq-4.2.tangent.true, Sect. 4, eqs. (4.2), (4.4)
   printed: The tangent vector at the image of a point c of q with the tangent vector dc is (q_0 - o).n / (c - o).n times dc - (dc.n / (c - o).n) (c - o), with n = a /\ d. At q_0 it is q_0^u - (q_0^u.n / (q_0 - o).n) (q_0 - o).
   stated: at(D(image(chord(x)), x), x, 0) == dot(q0 - o, normal)/dot(c - o, normal)*(dc - dot(dc, normal)/dot(c - o, normal)*(c - o)) and at(D(image(first(x)), x), x, 0) == q0u - dot(q0u, normal)/dot(q0 - o, normal)*(q0 - o) *)
Definition first (q0 : list R) (q0u : list R) (x : R) : list R :=
  vadd q0 (vscale x q0u).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (dc'1 dc'2 dc'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let dc := [dc'1; dc'2; dc'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vsub c o) (normal a d) <> 0 ->
  dot (vsub q0 o) (normal a d) <> 0 ->
  locally 0 (fun x => dot (vsub (chord c dc x) o) (normal a d) <> 0) ->
  locally 0 (fun x => dot (vsub (first q0 q0u x) o) (normal a d) <> 0) ->
  (fun x : R => vDerive 3 (fun x => image a d o q0 (chord c dc x)) 1 x) 0 = vscale (dot (vsub q0 o) (normal a d) / dot (vsub c o) (normal a d)) (vsub dc (vscale (dot dc (normal a d) / dot (vsub c o) (normal a d)) (vsub c o))) /\ (fun x : R => vDerive 3 (fun x => image a d o q0 (first q0 q0u x)) 1 x) 0 = vsub q0u (vscale (dot q0u (normal a d) / dot (vsub q0 o) (normal a d)) (vsub q0 o)).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (c'1 c'2 c'3 : R) (d'1 d'2 d'3 : R) (dc'1 dc'2 dc'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q0u'1 q0u'2 q0u'3 : R),
  let a := [a'1; a'2; a'3] in
  let c := [c'1; c'2; c'3] in
  let d := [d'1; d'2; d'3] in
  let dc := [dc'1; dc'2; dc'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q0u := [q0u'1; q0u'2; q0u'3] in
  dot (vsub c o) (normal a d) <> 0 /\
  dot (vsub q0 o) (normal a d) <> 0 /\
  locally 0 (fun x => dot (vsub (chord c dc x) o) (normal a d) <> 0) /\
  locally 0 (fun x => dot (vsub (first q0 q0u x) o) (normal a d) <> 0).
End eq_4_2_tangent_true.

Module sec_4_s.
(* hermite-developable/sec-4.s, Sect. 4, before (4.3)
   printed: r = o + s(q - o) = q_0 + u a + v d and s = [(q_0 - o).(a /\ d)]/[(q - o).(a /\ d)]
   read as: the copy sets the digit 0 for o in this sentence; x1, x2 are the parameters u, v of the plane at r
   stated: s == dot(q0 - o, cross(a, d))/dot(qm - o, cross(a, d)) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (s : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  vadd o (vscale s (vsub qm o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vsub qm o) (cross a d) <> 0 ->
  s = dot (vsub q0 o) (cross a d) / dot (vsub qm o) (cross a d).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (s : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  dot (vsub qm o) (normal a d) <> 0 /\
  vadd o (vscale s (vsub qm o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vsub qm o) (cross a d) <> 0.
End sec_4_s.

Module eq_4_3.
(* hermite-developable/eq-4.3, Sect. 4, eq. (4.3)
   printed: r = o + [ (q_0 - o).(a /\ d) / ((q - o).(a /\ d)) ] (q - o)
   read as: x1, x2 are the parameters u, v of the plane at r
   stated: o + s*(qm - o) == o + dot(q0 - o, cross(a, d))/dot(qm - o, cross(a, d))*(qm - o) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (s : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  vadd o (vscale s (vsub qm o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vsub qm o) (cross a d) <> 0 ->
  vadd o (vscale s (vsub qm o)) = vadd o (vscale (dot (vsub q0 o) (cross a d) / dot (vsub qm o) (cross a d)) (vsub qm o)).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (s : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  dot (vsub qm o) (normal a d) <> 0 /\
  vadd o (vscale s (vsub qm o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vsub qm o) (cross a d) <> 0.
End eq_4_3.

Module eq_4_4_ru.
(* hermite-developable/eq-4.4.ru, Sect. 4, eq. (4.4), first
   printed: r^u = t[(q - o) + q^u] - (r - o), t = [ (q_0 - o).(a /\ d) / (((q - o) + q^u).(a /\ d)) ]
   read as: r is the image of q by (4.3), t the ray parameter of the projection of q + q^u, and r^u the vector from r to it; x1, x2 are the parameters of the plane there
   stated: o + t*(qm - o + qu) - r == dot(q0 - o, cross(a, d))/dot(qm - o + qu, cross(a, d))*(qm - o + qu) - (r - o) *)
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (t : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  vadd o (vscale t (vadd (vsub qm o) qu)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vadd (vsub qm o) qu) (cross a d) <> 0 ->
  vsub (vadd o (vscale t (vadd (vsub qm o) qu))) (r a d o q0 qm) = vsub (vscale (dot (vsub q0 o) (cross a d) / dot (vadd (vsub qm o) qu) (cross a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R) (t : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 /\
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 /\
  vadd o (vscale t (vadd (vsub qm o) qu)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vadd (vsub qm o) qu) (cross a d) <> 0.
End eq_4_4_ru.

Module eq_4_4_r1.
(* hermite-developable/eq-4.4.r1, Sect. 4, eq. (4.4), second
   printed: r_1 = o + n (q_1 - o), n = [ (q_0 - o).(a /\ d) / ((q_1 - o).(a /\ d)) ]
   read as: x1, x2 are the parameters u, v of the plane at r_1
   stated: o + n*(q1 - o) == o + dot(q0 - o, cross(a, d))/dot(q1 - o, cross(a, d))*(q1 - o) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (n : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  dot (vsub q1 o) (normal a d) <> 0 ->
  vadd o (vscale n (vsub q1 o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vsub q1 o) (cross a d) <> 0 ->
  vadd o (vscale n (vsub q1 o)) = vadd o (vscale (dot (vsub q0 o) (cross a d) / dot (vsub q1 o) (cross a d)) (vsub q1 o)).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (n : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  dot (vsub q1 o) (normal a d) <> 0 /\
  vadd o (vscale n (vsub q1 o)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vsub q1 o) (cross a d) <> 0.
End eq_4_4_r1.

Module eq_4_4_r1u.
(* hermite-developable/eq-4.4.r1u, Sect. 4, eq. (4.4), third
   printed: r_1^u = m[(q_1 - o) + q_1^u] - (r_1 - o), m = [ (q_0 - o).(a /\ d) / (((q_1 - o) + q_1^u).(a /\ d)) ]
   read as: m is the ray parameter of the projection of q_1 + q_1^u, and r_1^u the vector from r_1 to it; x1, x2 are the parameters of the plane there
   stated: o + m*(q1 - o + q1u) - r1 == dot(q0 - o, cross(a, d))/dot(q1 - o + q1u, cross(a, d))*(q1 - o + q1u) - (r1 - o) *)
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (m : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  vadd o (vscale m (vadd (vsub q1 o) q1u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) ->
  dot (vadd (vsub q1 o) q1u) (cross a d) <> 0 ->
  vsub (vadd o (vscale m (vadd (vsub q1 o) q1u))) (r1 a d o q0 q1) = vsub (vscale (dot (vsub q0 o) (cross a d) / dot (vadd (vsub q1 o) q1u) (cross a d)) (vadd (vsub q1 o) q1u)) (vsub (r1 a d o q0 q1) o).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (m : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (x1 : R) (x2 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  dot (vsub q1 o) (normal a d) <> 0 /\
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 /\
  vadd o (vscale m (vadd (vsub q1 o) q1u)) = vadd (vadd q0 (vscale x1 a)) (vscale x2 d) /\
  dot (vadd (vsub q1 o) q1u) (cross a d) <> 0.
End eq_4_4_r1u.

Module eq_4_4_tangent_derivative.
(* hermite-developable/eq-4.4.tangent.derivative, Sect. 4, sentence before (4.4)
   printed: Applying this method of computation, it can be found r^u, r_1, and r_1^u
   read as: r^u and r_1^u are the tangent vectors of the projected curve at u = 1/2 and u = 1; the lines q + x q^u and q_1 + x q_1^u stand for q there
   stated: at(D(image(chord(x)), x), x, 0) == ru and at(D(image(last(x)), x), x, 0) == r1u *)
Definition chord (qm : list R) (qu : list R) (x : R) : list R :=
  vadd qm (vscale x qu).
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition ru (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) (qu : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  locally 0 (fun x => dot (vsub (chord qm qu x) o) (normal a d) <> 0) ->
  locally 0 (fun x => dot (vsub (last q1 q1u x) o) (normal a d) <> 0) ->
  (fun x : R => vDerive 3 (fun x => image a d o q0 (chord qm qu x)) 1 x) 0 = ru a d o q0 qm qu /\ (fun x : R => vDerive 3 (fun x => image a d o q0 (last q1 q1u x)) 1 x) 0 = r1u a d o q0 q1 q1u.
End eq_4_4_tangent_derivative.

Module eq_4_4_tangent_end_point.
(* hermite-developable/eq-4.4.tangent.end point, Sect. 4, sentence before (4.4)
   printed: Applying this method of computation, it can be found r^u, r_1, and r_1^u
   read as: r^u and r_1^u are the vectors from r and r_1 to the images of the end points of q^u and q_1^u
   stated: image(qm + qu) - r == ru and image(q1 + q1u) - r1 == r1u *)
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition ru (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) (qu : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  dot (vsub (vadd qm qu) o) (normal a d) <> 0 ->
  dot (vsub (vadd q1 q1u) o) (normal a d) <> 0 ->
  vsub (image a d o q0 (vadd qm qu)) (r a d o q0 qm) = ru a d o q0 qm qu /\ vsub (image a d o q0 (vadd q1 q1u)) (r1 a d o q0 q1) = r1u a d o q0 q1 q1u.
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 /\
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 /\
  dot (vsub q1 o) (normal a d) <> 0 /\
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 /\
  dot (vsub (vadd qm qu) o) (normal a d) <> 0 /\
  dot (vsub (vadd q1 q1u) o) (normal a d) <> 0.
End eq_4_4_tangent_end_point.

Module eq_4_4_tangent_parallel.
(* hermite-developable/eq-4.4.tangent.parallel, Sect. 4, eq. (4.4)
   printed: The vectors (4.4) are the tangent vectors of the projected curve times (q - o).(a /\ d) / ((q - o) + q^u).(a /\ d), and so with q_1 and q_1^u: they have the directions, and the lengths only for vectors parallel to the plane.
   stated: ru == dot(qm - o, normal)/dot(qm - o + qu, normal)*at(D(image(chord(x)), x), x, 0) and r1u == dot(q1 - o, normal)/dot(q1 - o + q1u, normal)*at(D(image(last(x)), x), x, 0) *)
Definition chord (qm : list R) (qu : list R) (x : R) : list R :=
  vadd qm (vscale x qu).
Definition r (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) : list R :=
  image a d o q0 qm.
Definition ru (a : list R) (d : list R) (o : list R) (q0 : list R) (qm : list R) (qu : list R) : list R :=
  vsub (vscale (dot (vsub q0 o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) (vadd (vsub qm o) qu)) (vsub (r a d o q0 qm) o).
Definition statement : Prop :=
forall (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 ->
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 ->
  dot (vsub q1 o) (normal a d) <> 0 ->
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 ->
  locally 0 (fun x => dot (vsub (chord qm qu x) o) (normal a d) <> 0) ->
  locally 0 (fun x => dot (vsub (last q1 q1u x) o) (normal a d) <> 0) ->
  ru a d o q0 qm qu = vscale (dot (vsub qm o) (normal a d) / dot (vadd (vsub qm o) qu) (normal a d)) ((fun x : R => vDerive 3 (fun x => image a d o q0 (chord qm qu x)) 1 x) 0) /\ r1u a d o q0 q1 q1u = vscale (dot (vsub q1 o) (normal a d) / dot (vadd (vsub q1 o) q1u) (normal a d)) ((fun x : R => vDerive 3 (fun x => image a d o q0 (last q1 q1u x)) 1 x) 0).
Definition instance : Prop :=
exists (a'1 a'2 a'3 : R) (d'1 d'2 d'3 : R) (o'1 o'2 o'3 : R) (q0'1 q0'2 q0'3 : R) (q1'1 q1'2 q1'3 : R) (q1u'1 q1u'2 q1u'3 : R) (qm'1 qm'2 qm'3 : R) (qu'1 qu'2 qu'3 : R),
  let a := [a'1; a'2; a'3] in
  let d := [d'1; d'2; d'3] in
  let o := [o'1; o'2; o'3] in
  let q0 := [q0'1; q0'2; q0'3] in
  let q1 := [q1'1; q1'2; q1'3] in
  let q1u := [q1u'1; q1u'2; q1u'3] in
  let qm := [qm'1; qm'2; qm'3] in
  let qu := [qu'1; qu'2; qu'3] in
  dot (vsub qm o) (normal a d) <> 0 /\
  dot (vadd (vsub qm o) qu) (normal a d) <> 0 /\
  dot (vsub q1 o) (normal a d) <> 0 /\
  dot (vadd (vsub q1 o) q1u) (normal a d) <> 0 /\
  locally 0 (fun x => dot (vsub (chord qm qu x) o) (normal a d) <> 0) /\
  locally 0 (fun x => dot (vsub (last q1 q1u x) o) (normal a d) <> 0).
End eq_4_4_tangent_parallel.

Module sec_4_oblique.
(* hermite-developable/sec-4.oblique, Sect. 4, after (4.1)
   printed: Gamma_3 is in oblique position to the plane Gamma_1 and Gamma_2, i.e., Gamma_3 not// Gamma_1 and Gamma_3 not// Gamma_2
   read as: the second 'not parallel' sign appears in our copy as a crossed single stroke
   stated: fails(cross(normal, [1, 0, 0]) == 0) and fails(cross(normal2, [1, 0, 0]) == 0) *)
Definition normal : list R :=
  cross a d.
Definition normal2 : list R :=
  cross [- 60; - 200; 0] d.
Definition statement : Prop :=
  ~ (  cross normal [1; 0; 0] = zeros 3) /\ ~ (  cross normal2 [1; 0; 0] = zeros 3).
End sec_4_oblique.

Module ex_4_data.
(* hermite-developable/ex-4.data, Sect. 4, example
   printed: Using quintic developable Hermite surface data of Figure (4a) in section 3.3, it has o = < 100, 20, 45 >, q_0 = <-20, 60, 45>, q_u^u = <0, -60, 90>, q = <-20, 5, 35>, q^u = <0, -50, 70>, q_1 = <-20, -50, 45>, q_1^u = <0, -50, -30>
   read as: q_u^u is read as q_0^u, the only one of the six vectors of q not otherwise listed
   stated: o == [100, 20, 45] and q5(0) == [-20, 60, 45] and q5'(0) == [0, -60, 90] and q5(1/2) == [-20, 5, 35] and q5'(1/2) == [0, -50, 70] and q5(1) == [-20, -50, 45] and q5'(1) == [0, -50, -30] *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
Definition q5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (qm : list R) (qu : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u q0 qm q1 q0u qu q1u.
Definition p0 : list R :=
  [40; 40; 45].
Definition pm : list R :=
  [40; 25 / 2; 40].
Definition pu : list R :=
  [0; - 25; 35].
Definition p5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0u : list R) (p1 : list R) (p1u : list R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u p0 pm p1 p0u pu p1u.
Definition k : R :=
  2.
Definition quintic_gap (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (u : R) : list R :=
  vsub (vsub (vadd (q5 A B C_ E_ F G qm qu u) (vDerive 3 (fun u => q5 A B C_ E_ F G qm qu u) 1 u)) (vscale k (vadd (p5 A B C_ E_ F G p0u p1 p1u u) (vDerive 3 (fun u => p5 A B C_ E_ F G p0u p1 p1u u) 1 u)))) (vscale (1 - k) o).
Definition quintic_part (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (o : list R) (p0u : list R) (p1 : list R) (p1u : list R) (qm : list R) (qu : list R) (n : Z) : list R :=
  (fun u : R => vdiv (vDerive 3 (fun u => quintic_gap A B C_ E_ F G o p0u p1 p1u qm qu u) (Z.to_nat n) u) (factorial n)) 0.
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
  quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z = zeros 3 ->
  o = [100; 20; 45] /\ q5 A B C_ E_ F G qm qu 0 = [- 20; 60; 45] /\ vDerive 3 (fun u => q5 A B C_ E_ F G qm qu u) 1 0 = [0; - 60; 90] /\ q5 A B C_ E_ F G qm qu (1 / 2) = [- 20; 5; 35] /\ vDerive 3 (fun u => q5 A B C_ E_ F G qm qu u) 1 (1 / 2) = [0; - 50; 70] /\ q5 A B C_ E_ F G qm qu 1 = [- 20; - 50; 45] /\ vDerive 3 (fun u => q5 A B C_ E_ F G qm qu u) 1 1 = [0; - 50; - 30].
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
  (quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G o p0u p1 p1u qm qu 0%Z = zeros 3).
End ex_4_data.

Module ex_4_r0.
(* hermite-developable/ex-4.r0, Sect. 4, example, first plane
   printed: r_0 = <-20, 60, 45>
   read as: r_0 is q_0, and so the image of q_0
   stated: agrees(image(q0), [-20, 60, 45]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition o : list R :=
  [100; 20; 45].
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition statement : Prop :=
  dot (vsub q0 o) normal <> 0 ->
  (entry (image q0) 1 = (-20) /\ entry (image q0) 2 = 60) /\ entry (image q0) 3 = 45.
Definition instance : Prop :=
  dot (vsub q0 o) normal <> 0.
End ex_4_r0.

Module ex_4_r0u.
(* hermite-developable/ex-4.r0u, Sect. 4, example, first plane
   printed: r_0^u = <-7.6, -50.6, 63.8>
   stated: agrees(r0u, [-7.6, -50.6, 63.8]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition o : list R :=
  [100; 20; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition normal : list R :=
  cross a d.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition statement : Prop :=
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  (agrees_down (entry r0u 1) ((-38) / 5) 1 /\ agrees_down (entry r0u 2) ((-253) / 5) 1) /\ agrees_up (entry r0u 3) (319 / 5) 1.
End ex_4_r0u.

Module ex_4_r.
(* hermite-developable/ex-4.r, Sect. 4, example, first plane
   printed: r = <-28.4, 3.9, 34.3>
   stated: agrees(r, [-28.4, 3.9, 34.3]) *)
Definition qm : list R :=
  [- 20; 5; 35].
Definition o : list R :=
  [100; 20; 45].
Definition normal : list R :=
  cross a d.
Definition q0 : list R :=
  [- 20; 60; 45].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition statement : Prop :=
  dot (vsub qm o) normal <> 0 ->
  (agrees_down (entry r 1) ((-142) / 5) 1 /\ agrees_up (entry r 2) (39 / 10) 1) /\ agrees_up (entry r 3) (343 / 10) 1.
Definition instance : Prop :=
  dot (vsub qm o) normal <> 0.
End ex_4_r.

Module ex_4_ru.
(* hermite-developable/ex-4.ru, Sect. 4, example, first plane
   printed: r^u = <-10.6, -70.8, 91, 8>
   read as: '91, 8' is read as 91.8 (a vector has three coordinates)
   stated: agrees(ru, [-10.6, -70.8, 91.8]) *)
Definition qm : list R :=
  [- 20; 5; 35].
Definition o : list R :=
  [100; 20; 45].
Definition qu : list R :=
  [0; - 50; 70].
Definition normal : list R :=
  cross a d.
Definition q0 : list R :=
  [- 20; 60; 45].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition statement : Prop :=
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vsub qm o) normal <> 0 ->
  (agrees_down (entry ru 1) ((-53) / 5) 1 /\ agrees_down (entry ru 2) ((-354) / 5) 1) /\ agrees_up (entry ru 3) (459 / 5) 1.
End ex_4_ru.

Module ex_4_r1.
(* hermite-developable/ex-4.r1, Sect. 4, example, first plane
   printed: r_1 = <-38, -60.5, 45>
   stated: agrees(r1, [-38, -60.5, 45]) *)
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition o : list R :=
  [100; 20; 45].
Definition normal : list R :=
  cross a d.
Definition q0 : list R :=
  [- 20; 60; 45].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r1 : list R :=
  image q1.
Definition statement : Prop :=
  dot (vsub q1 o) normal <> 0 ->
  (agrees_down (entry r1 1) (-38) 1 /\ agrees_down (entry r1 2) ((-121) / 2) 1) /\ agrees_up (entry r1 3) 45 1.
Definition instance : Prop :=
  dot (vsub q1 o) normal <> 0.
End ex_4_r1.

Module ex_4_r1_rounding.
(* hermite-developable/ex-4.r1.rounding, Sect. 4, example, first plane
   printed: The first coordinate of r_1 is -38.082. The printed -38 is cut off, while the other coordinates of the example are rounded to one decimal; rounded it is -38.1.
   stated: agrees(r1[1], -38.1) and agrees(r1[1], -38.082) *)
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition o : list R :=
  [100; 20; 45].
Definition normal : list R :=
  cross a d.
Definition q0 : list R :=
  [- 20; 60; 45].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r1 : list R :=
  image q1.
Definition statement : Prop :=
  dot (vsub q1 o) normal <> 0 ->
  agrees_down (entry r1 1) ((-381) / 10) 1 /\ agrees_down (entry r1 1) ((-19041) / 500) 3.
Definition instance : Prop :=
  dot (vsub q1 o) normal <> 0.
End ex_4_r1_rounding.

Module ex_4_r1u.
(* hermite-developable/ex-4.r1u, Sect. 4, example, first plane
   printed: r_1^u = <-10.2, -67.7, -74.1>
   stated: agrees(r1u, [-10.2, -67.7, -74.1]) *)
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition o : list R :=
  [100; 20; 45].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition normal : list R :=
  cross a d.
Definition q0 : list R :=
  [- 20; 60; 45].
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r1 : list R :=
  image q1.
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition statement : Prop :=
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  dot (vsub q1 o) normal <> 0 ->
  (agrees_down (entry r1u 1) ((-51) / 5) 1 /\ agrees_down (entry r1u 2) ((-677) / 10) 1) /\ agrees_down (entry r1u 3) ((-741) / 10) 1.
End ex_4_r1u.

Module ex_4_other_data.
(* hermite-developable/ex-4.other-data, Sect. 4, example, first plane
   printed: The three printed tangent vectors that do not follow from the stated data are those of one other set of tangent vectors of q: q_0^u = <0, -50, 60>, q^u = <0, -60, 80>, q_1^u = <0, -50, -60>.
   stated: agrees(r0u, [-7.6, -50.6, 63.8]) and agrees(ru, [-10.6, -70.8, 91.8]) and agrees(r1u, [-10.2, -67.7, -74.1]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition o : list R :=
  [100; 20; 45].
Definition q0u : list R :=
  [0; - 50; 60].
Definition normal : list R :=
  cross a d.
Definition qm : list R :=
  [- 20; 5; 35].
Definition qu : list R :=
  [0; - 60; 80].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1 : list R :=
  image q1.
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition statement : Prop :=
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vsub qm o) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  dot (vsub q1 o) normal <> 0 ->
  ((agrees_down (entry r0u 1) ((-38) / 5) 1 /\ agrees_down (entry r0u 2) ((-253) / 5) 1) /\ agrees_up (entry r0u 3) (319 / 5) 1) /\ ((agrees_down (entry ru 1) ((-53) / 5) 1 /\ agrees_down (entry ru 2) ((-354) / 5) 1) /\ agrees_up (entry ru 3) (459 / 5) 1) /\ (agrees_down (entry r1u 1) ((-51) / 5) 1 /\ agrees_down (entry r1u 2) ((-677) / 10) 1) /\ agrees_down (entry r1u 3) ((-741) / 10) 1.
Definition instance : Prop :=
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vsub qm o) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0 /\
  dot (vsub q1 o) normal <> 0.
End ex_4_other_data.

Module ex_4_other_data_twist.
(* hermite-developable/ex-4.other-data.twist, Sect. 4, example, first plane
   printed: The patch of that other set of data is not developable either: the angle between the tangent planes at the two ends of one generatrix has a sine of more than 0.06 at u = 3/8, 3.4 degrees.
   stated: turn(3/8) > (6/100)^2*size(3/8) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition qm : list R :=
  [- 20; 5; 35].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q0u : list R :=
  [0; - 50; 60].
Definition qu : list R :=
  [0; - 60; 80].
Definition q1u : list R :=
  [0; - 50; - 60].
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
Definition near (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition far (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition turn (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)) (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition size (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) * dot (far A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  turn A B C_ E_ F G p0 p0u p1 p1u pm pu (3 / 8) > (6 / 100) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu (3 / 8).
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  (quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3) /\
  dot (vsub qm o) normal <> 0 /\
  dot (vsub q1 o) normal <> 0 /\
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0.
End ex_4_other_data_twist.

Module ex_4_stated_data.
(* hermite-developable/ex-4.stated-data, Sect. 4, example, first plane
   printed: For the stated data (4.2) and (4.4) give r_0^u = <-9.2, -61.5, 96.9>, r^u = <-8.7, -58.2, 79.3>, r_1^u = <-10.2, -67.7, -37.1>.
   stated: agrees(r0u, [-9.2, -61.5, 96.9]) and agrees(ru, [-8.7, -58.2, 79.3]) and agrees(r1u, [-10.2, -67.7, -37.1]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition o : list R :=
  [100; 20; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition normal : list R :=
  cross a d.
Definition qm : list R :=
  [- 20; 5; 35].
Definition qu : list R :=
  [0; - 50; 70].
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1 : list R :=
  image q1.
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition statement : Prop :=
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vsub qm o) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  dot (vsub q1 o) normal <> 0 ->
  ((agrees_down (entry r0u 1) ((-46) / 5) 1 /\ agrees_down (entry r0u 2) ((-123) / 2) 1) /\ agrees_up (entry r0u 3) (969 / 10) 1) /\ ((agrees_down (entry ru 1) ((-87) / 10) 1 /\ agrees_down (entry ru 2) ((-291) / 5) 1) /\ agrees_up (entry ru 3) (793 / 10) 1) /\ (agrees_down (entry r1u 1) ((-51) / 5) 1 /\ agrees_down (entry r1u 2) ((-677) / 10) 1) /\ agrees_down (entry r1u 3) ((-371) / 10) 1.
Definition instance : Prop :=
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vsub qm o) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0 /\
  dot (vsub q1 o) normal <> 0.
End ex_4_stated_data.

Module ex_4_true_tangents.
(* hermite-developable/ex-4.true-tangents, Sect. 4, example, first plane
   printed: The tangent vectors of the projected curve itself at u = 0, 1/2 and 1 are <-8.6, -57.1, 90>, <-8.2, -54.5, 74.2> and <-9.5, -63.1, -34.5>.
   stated: agrees(at(D(image(first(x)), x), x, 0), [-8.6, -57.1, 90.0]) and agrees(at(D(image(middle(x)), x), x, 0), [-8.2, -54.5, 74.2]) and agrees(at(D(image(last(x)), x), x, 0), [-9.5, -63.1, -34.5]) *)
Definition q0 : list R :=
  [- 20; 60; 45].
Definition q0u : list R :=
  [0; - 60; 90].
Definition first (x : R) : list R :=
  vadd q0 (vscale x q0u).
Definition o : list R :=
  [100; 20; 45].
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition qm : list R :=
  [- 20; 5; 35].
Definition qu : list R :=
  [0; - 50; 70].
Definition middle (x : R) : list R :=
  vadd qm (vscale x qu).
Definition q1 : list R :=
  [- 20; - 50; 45].
Definition q1u : list R :=
  [0; - 50; - 30].
Definition last (x : R) : list R :=
  vadd q1 (vscale x q1u).
Definition statement : Prop :=
  locally 0 (fun x => dot (vsub (first x) o) normal <> 0) ->
  locally 0 (fun x => dot (vsub (middle x) o) normal <> 0) ->
  locally 0 (fun x => dot (vsub (last x) o) normal <> 0) ->
  ((agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (first x)) 1 x) 0) 1) ((-43) / 5) 1 /\ agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (first x)) 1 x) 0) 2) ((-571) / 10) 1) /\ agrees_up (entry ((fun x : R => vDerive 3 (fun x => image (first x)) 1 x) 0) 3) 90 1) /\ ((agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (middle x)) 1 x) 0) 1) ((-41) / 5) 1 /\ agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (middle x)) 1 x) 0) 2) ((-109) / 2) 1) /\ agrees_up (entry ((fun x : R => vDerive 3 (fun x => image (middle x)) 1 x) 0) 3) (371 / 5) 1) /\ (agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (last x)) 1 x) 0) 1) ((-19) / 2) 1 /\ agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (last x)) 1 x) 0) 2) ((-631) / 10) 1) /\ agrees_down (entry ((fun x : R => vDerive 3 (fun x => image (last x)) 1 x) 0) 3) ((-69) / 2) 1.
Definition instance : Prop :=
  locally 0 (fun x => dot (vsub (first x) o) normal <> 0) /\
  locally 0 (fun x => dot (vsub (middle x) o) normal <> 0) /\
  locally 0 (fun x => dot (vsub (last x) o) normal <> 0).
End ex_4_true_tangents.

Module ex_4_a_developable_computed.
(* hermite-developable/ex-4.a.developable.computed, Sect. 4, example, first plane
   printed: It constructs the quintic developable Hermite surface presented in Figure (5a)
   read as: r_5 is the curve of the data that (4.2) to (4.4) give for the stated data of q
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  det [vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u; vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u; vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
End ex_4_a_developable_computed.

Module ex_4_a_developable_printed.
(* hermite-developable/ex-4.a.developable.printed, Sect. 4, example, first plane
   printed: It constructs the quintic developable Hermite surface presented in Figure (5a)
   read as: r_5 is the curve of the printed data
   stated: det([p5'(u), rp'(u), rp(u) - p5(u)]) == 0 *)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition rp (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u [- 20; 60; 45] [- (142 / 5); 39 / 10; 343 / 10] [- 38; - (121 / 2); 45] [- (38 / 5); - (253 / 5); 319 / 5] [- (53 / 5); - (354 / 5); 459 / 5] [- (51 / 5); - (677 / 10); - (741 / 10)].
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
  det [vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u; vDerive 3 (fun u => rp A B C_ E_ F G u) 1 u; vsub (rp A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
End ex_4_a_developable_printed.

Module ex_4_a_twist.
(* hermite-developable/ex-4.a.twist, Sect. 4, example, first plane
   printed: On the patch of Fig. 5a the tangent planes at the two ends of one generatrix make an angle whose sine is more than 0.060 at u = 2/5, 3.4 degrees; at u = 0, 1/2 and 1 they agree.
   stated: turn(2/5) > (60/1000)^2*size(2/5) and turn(0) == 0 and turn(1/2) == 0 and turn(1) == 0 *)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
Definition near (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition far (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition turn (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)) (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition size (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) * dot (far A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  turn A B C_ E_ F G p0 p0u p1 p1u pm pu (2 / 5) > (60 / 1000) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu (2 / 5) /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu 0 = 0 /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2) = 0 /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu 1 = 0.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  (quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3) /\
  dot (vsub qm o) normal <> 0 /\
  dot (vsub q1 o) normal <> 0 /\
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0.
End ex_4_a_twist.

Module ex_4_a_twist_most.
(* hermite-developable/ex-4.a.twist.most, Sect. 4, example, first plane
   printed: Nowhere on the patch of Fig. 5a is the sine of this angle as large as 0.061, 3.5 degrees.
   stated: turn(u) < (61/1000)^2*size(u) *)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
Definition near (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition far (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition turn (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)) (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition size (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) * dot (far A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u).
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  turn A B C_ E_ F G p0 p0u p1 p1u pm pu u < (61 / 1000) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (u : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  (quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3) /\
  dot (vsub qm o) normal <> 0 /\
  dot (vsub q1 o) normal <> 0 /\
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0.
End ex_4_a_twist_most.

Module ex_4_a_twist_printed.
(* hermite-developable/ex-4.a.twist.printed, Sect. 4, example, first plane
   printed: With the printed vectors of r and the stated data of q the tangent planes at the two ends of one generatrix differ at u = 0, 1/2 and 1 too; at u = 1 the sine of their angle is more than 0.333, 19.4 degrees.
   stated: turn(0) > 0 and turn(1/2) > 0 and turn(1) > (333/1000)^2*size(1) *)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition rp (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u [- 20; 60; 45] [- (142 / 5); 39 / 10; 343 / 10] [- 38; - (121 / 2); 45] [- (38 / 5); - (253 / 5); 319 / 5] [- (53 / 5); - (354 / 5); 459 / 5] [- (51 / 5); - (677 / 10); - (741 / 10)].
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  rp A B C_ E_ F G u.
Definition near (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition far (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition turn (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)) (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition size (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) * dot (far A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u).
Definition statement : Prop :=
forall (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  turn A B C_ E_ F G p0 p0u p1 p1u pm pu 0 > 0 /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu (1 / 2) > 0 /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu 1 > (333 / 1000) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu 1.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  (quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3).
End ex_4_a_twist_printed.

Module ex_4_b_developable.
(* hermite-developable/ex-4.b.developable, Sect. 4, example, second plane
   printed: [the second plane] gives the quintic developable Hermite surface in Figure (5b)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition a : list R :=
  [- 60; - 200; 0].
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  det [vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u; vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u; vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)] = 0.
End ex_4_b_developable.

Module ex_4_b_twist.
(* hermite-developable/ex-4.b.twist, Sect. 4, example, second plane
   printed: On the patch of Fig. 5b the sine of this angle is more than 0.123 at u = 39/100, 7.0 degrees, and less than 0.125, 7.2 degrees, everywhere.
   stated: turn(39/100) > (123/1000)^2*size(39/100) and turn(u) < (125/1000)^2*size(u) *)
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
Definition hermite5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) (a : list R) (m : list R) (b : list R) (s : list R) (r : list R) (t : list R) : list R :=
  blend6 (quintic_basis A B C_ E_ F G u) a m b s r t.
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
Definition r0 : list R :=
  q0.
Definition a : list R :=
  [- 60; - 200; 0].
Definition normal : list R :=
  cross a d.
Definition image (x : list R) : list R :=
  vadd o (vscale (dot (vsub q0 o) normal / dot (vsub x o) normal) (vsub x o)).
Definition r : list R :=
  image qm.
Definition r1 : list R :=
  image q1.
Definition r0u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q0 o) q0u) normal) (vadd (vsub q0 o) q0u)) (vsub q0 o).
Definition ru : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub qm o) qu) normal) (vadd (vsub qm o) qu)) (vsub r o).
Definition r1u : list R :=
  vsub (vscale (dot (vsub q0 o) normal / dot (vadd (vsub q1 o) q1u) normal) (vadd (vsub q1 o) q1u)) (vsub r1 o).
Definition r5 (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (u : R) : list R :=
  hermite5 A B C_ E_ F G u r0 r r1 r0u ru r1u.
Definition near (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition far (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : list R :=
  cross (vDerive 3 (fun u => r5 A B C_ E_ F G u) 1 u) (vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition turn (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)) (cross (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u)).
Definition size (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0 : list R) (p0u : list R) (p1 : list R) (p1u : list R) (pm : list R) (pu : list R) (u : R) : R :=
  dot (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) (near A B C_ E_ F G p0 p0u p1 p1u pm pu u) * dot (far A B C_ E_ F G p0 p0u p1 p1u pm pu u) (far A B C_ E_ F G p0 p0u p1 p1u pm pu u).
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
  dot (vadd (vsub q0 o) q0u) normal <> 0 ->
  dot (vadd (vsub qm o) qu) normal <> 0 ->
  dot (vadd (vsub q1 o) q1u) normal <> 0 ->
  turn A B C_ E_ F G p0 p0u p1 p1u pm pu (39 / 100) > (123 / 1000) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu (39 / 100) /\ turn A B C_ E_ F G p0 p0u p1 p1u pm pu u < (125 / 1000) ^ 2 * size A B C_ E_ F G p0 p0u p1 p1u pm pu u.
Definition instance : Prop :=
exists (A : R) (B : R) (C_ : R) (E_ : R) (F : R) (G : R) (p0'1 p0'2 p0'3 : R) (p0u'1 p0u'2 p0u'3 : R) (p1'1 p1'2 p1'3 : R) (p1u'1 p1u'2 p1u'3 : R) (pm'1 pm'2 pm'3 : R) (pu'1 pu'2 pu'3 : R) (u : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p0u := [p0u'1; p0u'2; p0u'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p1u := [p1u'1; p1u'2; p1u'3] in
  let pm := [pm'1; pm'2; pm'3] in
  let pu := [pu'1; pu'2; pu'3] in
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
  (quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 5%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 4%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 3%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 2%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 1%Z = zeros 3 /\ quintic_part A B C_ E_ F G p0 p0u p1 p1u pm pu 0%Z = zeros 3) /\
  dot (vsub qm o) normal <> 0 /\
  dot (vsub q1 o) normal <> 0 /\
  dot (vadd (vsub q0 o) q0u) normal <> 0 /\
  dot (vadd (vsub qm o) qu) normal <> 0 /\
  dot (vadd (vsub q1 o) q1u) normal <> 0.
End ex_4_b_twist.
