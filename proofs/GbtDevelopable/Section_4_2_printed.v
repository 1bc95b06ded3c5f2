(* Statements of gbt-developable, Section 4 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition E3_0 : list R :=
  [13 / 2; 13 / 2; 13 / 2 * sqrt 2; 169].
Definition E3_1 : list R :=
  [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225].
Definition E3_2 : list R :=
  [- 10; - 10; 10 * sqrt 2; 400].
Definition E3_3 : list R :=
  [25 / 2; - (25 / 2); 25 / 2 * sqrt 2; 625].
Definition E3 (mu : R) (nu : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x mu nu 0%Z 3%Z) E3_0) (vscale (g x mu nu 1%Z 3%Z) E3_1)) (vscale (g x mu nu 2%Z 3%Z) E3_2)) (vscale (g x mu nu 3%Z 3%Z) E3_3).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition distance2 (P : list R) : R :=
  entry P 4 ^ 2 / dot (normal P) (normal P).
End Definitions.
Import Definitions.

Module sec_4_2_Q0.
(* gbt-developable/sec-4.2.Q0, Sect. 4.2, control planes
   printed: Q_0 = (6.5, 6.5, 6.5√2, 169)
   read as: Compared with the plane that the statements of Sect. 4.2 use, which is the family at x = 0, and with what the text says of it: its central point is in quadrant I.
   stated: E3(0) == [6.5, 6.5, 6.5*sqrt(2), 169] and midpoint(E3(0))[1] > 0 and midpoint(E3(0))[2] > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal (E3 mu nu 0)) (normal (E3 mu nu 0)) <> 0 ->
  E3 mu nu 0 = [13 / 2; 13 / 2; 13 / 2 * sqrt 2; 169] /\ entry (midpoint (E3 mu nu 0)) 1 > 0 /\ entry (midpoint (E3 mu nu 0)) 2 > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal (E3 mu nu 0)) (normal (E3 mu nu 0)) <> 0.
End sec_4_2_Q0.

Module sec_4_2_Q1.
(* gbt-developable/sec-4.2.Q1, Sect. 4.2, control planes
   printed: Q_1 = (−5.5, 7.5, 7.5√2, 225)
   read as: Compared with the plane that the statements of Sect. 4.2 use, and with what the text says of it: its central point is in quadrant II, and farther from the origin than that of Q_0.
   stated: E3_1 == [-5.5, 7.5, 7.5*sqrt(2), 225] and midpoint([-5.5, 7.5, 7.5*sqrt(2), 225])[1] < 0 and midpoint([-5.5, 7.5, 7.5*sqrt(2), 225])[2] > 0 and distance2([-5.5, 7.5, 7.5*sqrt(2), 225]) > distance2(E3(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) (normal [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) <> 0 ->
  dot (normal (E3 mu nu 0)) (normal (E3 mu nu 0)) <> 0 ->
  E3_1 = [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225] /\ entry (midpoint [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) 1 < 0 /\ entry (midpoint [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) 2 > 0 /\ distance2 [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225] > distance2 (E3 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) (normal [- (11 / 2); 15 / 2; 15 / 2 * sqrt 2; 225]) <> 0 /\
  dot (normal (E3 mu nu 0)) (normal (E3 mu nu 0)) <> 0.
End sec_4_2_Q1.

Module sec_4_2_Q1_lengths.
(* gbt-developable/sec-4.2.Q1.lengths, Sect. 4.2, control planes
   printed: The squares of the lengths of the four normals of Sect. 4.2.
   stated: dot(normal(E3_0), normal(E3_0)) == E3_0[4] and dot(normal(E3_1), normal(E3_1)) == 199 and (-7.5)^2 + E3_1[2]^2 + E3_1[3]^2 == E3_1[4] and dot(normal(E3_2), normal(E3_2)) == E3_2[4] and dot(normal(E3_3), normal(E3_3)) == E3_3[4] *)
Definition statement : Prop :=
  dot (normal E3_0) (normal E3_0) = entry E3_0 4 /\ dot (normal E3_1) (normal E3_1) = 199 /\ (- (15 / 2)) ^ 2 + entry E3_1 2 ^ 2 + entry E3_1 3 ^ 2 = entry E3_1 4 /\ dot (normal E3_2) (normal E3_2) = entry E3_2 4 /\ dot (normal E3_3) (normal E3_3) = entry E3_3 4.
End sec_4_2_Q1_lengths.

Module sec_4_2_Q2.
(* gbt-developable/sec-4.2.Q2, Sect. 4.2, control planes
   printed: Q_2 = (−10, −10, 10√2400)
   read as: Our copy prints '10 √ 2400' without a comma, so three entries; read as (−10, −10, 10√2, 400), four entries as in the other rows. Compared with the plane that the statements of Sect. 4.2 use, and with what the text says of it: its central point is in quadrant III.
   stated: E3_2 == [-10, -10, 10*sqrt(2), 400] and midpoint([-10, -10, 10*sqrt(2), 400])[1] < 0 and midpoint([-10, -10, 10*sqrt(2), 400])[2] < 0 *)
Definition statement : Prop :=
  dot (normal [- 10; - 10; 10 * sqrt 2; 400]) (normal [- 10; - 10; 10 * sqrt 2; 400]) <> 0 ->
  E3_2 = [- 10; - 10; 10 * sqrt 2; 400] /\ entry (midpoint [- 10; - 10; 10 * sqrt 2; 400]) 1 < 0 /\ entry (midpoint [- 10; - 10; 10 * sqrt 2; 400]) 2 < 0.
Definition instance : Prop :=
  dot (normal [- 10; - 10; 10 * sqrt 2; 400]) (normal [- 10; - 10; 10 * sqrt 2; 400]) <> 0.
End sec_4_2_Q2.

Module sec_4_2_Q3.
(* gbt-developable/sec-4.2.Q3, Sect. 4.2, control planes
   printed: Q_3 = (12.5, −12.5, 12.5√2, 625)
   read as: Compared with the plane that the statements of Sect. 4.2 use, which is the family at x = 1, and with what the text says of it: its central point is in quadrant IV.
   stated: E3(1) == [12.5, -12.5, 12.5*sqrt(2), 625] and midpoint(E3(1))[1] > 0 and midpoint(E3(1))[2] < 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal (E3 mu nu 1)) (normal (E3 mu nu 1)) <> 0 ->
  E3 mu nu 1 = [25 / 2; - (25 / 2); 25 / 2 * sqrt 2; 625] /\ entry (midpoint (E3 mu nu 1)) 1 > 0 /\ entry (midpoint (E3 mu nu 1)) 2 < 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal (E3 mu nu 1)) (normal (E3 mu nu 1)) <> 0.
End sec_4_2_Q3.

Module sec_4_2_quadrants.
(* gbt-developable/sec-4.2.quadrants, Sect. 4.2, sentence before the planes
   printed: the central points of the control planes ... are taken in four different quadrants I, II, III, IV
   stated: midpoint(E3_0)[1] > 0 and midpoint(E3_0)[2] > 0 and midpoint(E3_1)[1] < 0 and midpoint(E3_1)[2] > 0 and midpoint(E3_2)[1] < 0 and midpoint(E3_2)[2] < 0 and midpoint(E3_3)[1] > 0 and midpoint(E3_3)[2] < 0 *)
Definition statement : Prop :=
  dot (normal E3_0) (normal E3_0) <> 0 ->
  dot (normal E3_1) (normal E3_1) <> 0 ->
  dot (normal E3_2) (normal E3_2) <> 0 ->
  dot (normal E3_3) (normal E3_3) <> 0 ->
  entry (midpoint E3_0) 1 > 0 /\ entry (midpoint E3_0) 2 > 0 /\ entry (midpoint E3_1) 1 < 0 /\ entry (midpoint E3_1) 2 > 0 /\ entry (midpoint E3_2) 1 < 0 /\ entry (midpoint E3_2) 2 < 0 /\ entry (midpoint E3_3) 1 > 0 /\ entry (midpoint E3_3) 2 < 0.
Definition instance : Prop :=
  dot (normal E3_0) (normal E3_0) <> 0 /\
  dot (normal E3_1) (normal E3_1) <> 0 /\
  dot (normal E3_2) (normal E3_2) <> 0 /\
  dot (normal E3_3) (normal E3_3) <> 0.
End sec_4_2_quadrants.

Module sec_4_2_distances.
(* gbt-developable/sec-4.2.distances, Sect. 4.2, sentence before the planes
   printed: ... with nonidentical distance from the origin
   stated: distance2(E3_0) < distance2(E3_1) and distance2(E3_1) < distance2(E3_2) and distance2(E3_2) < distance2(E3_3) *)
Definition statement : Prop :=
  dot (normal E3_0) (normal E3_0) <> 0 ->
  dot (normal E3_1) (normal E3_1) <> 0 ->
  dot (normal E3_2) (normal E3_2) <> 0 ->
  dot (normal E3_3) (normal E3_3) <> 0 ->
  distance2 E3_0 < distance2 E3_1 /\ distance2 E3_1 < distance2 E3_2 /\ distance2 E3_2 < distance2 E3_3.
Definition instance : Prop :=
  dot (normal E3_0) (normal E3_0) <> 0 /\
  dot (normal E3_1) (normal E3_1) <> 0 /\
  dot (normal E3_2) (normal E3_2) <> 0 /\
  dot (normal E3_3) (normal E3_3) <> 0.
End sec_4_2_distances.

Module sec_4_2_class.
(* gbt-developable/sec-4.2.class, Sect. 4.2, after the planes
   printed: With different values of shape parameters μ and ν, a class of cubic spine curve developable GBT-Bézier surfaces can be designed on the requirement of provided control planes Q_0, Q_1, Q_2, Q_3 in Fig. 13 and Fig. 14 respectively, with distinct shapes.
   read as: The surface is there and is no cone, for all shape parameters: near x = 1/2 the characteristic point exists and its velocity is not zero. It changes with each shape parameter.
   stated: det([normal(E3(1/2)), normal(E3'(1/2)), normal(E3''(1/2))]) > 0 and det([E3(1/2), E3'(1/2), E3''(1/2), E3'''(1/2)]) > 0 and fails(D(middle, mu) == 0) and fails(D(middle, nu) == 0) *)
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
Definition middle (mu : R) (nu : R) : list R :=
  meet (E3 mu nu (1 / 2)) (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)) (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2)).
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  det [normal (E3 mu nu (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2))] > 0 /\ det [E3 mu nu (1 / 2); vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2); vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2); vDerive 4 (fun x => E3 mu nu x) 3 (1 / 2)] > 0 /\ ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => det [normal (E3 mu nu (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2))] <> 0) ->
  vDerive 3 (fun mu => middle mu nu) 1 mu = zeros 3) /\ ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally nu (fun nu => det [normal (E3 mu nu (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)); normal (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2))] <> 0) ->
  vDerive 3 (fun nu => middle mu nu) 1 nu = zeros 3).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End sec_4_2_class.

Module sec_4_2_class_interior.
(* gbt-developable/sec-4.2.class.interior, Sect. 4.2
   printed: The spine curve of Sect. 4.2 exists for all shape parameters and all x between the ends.
   stated: det([normal(E3(x)), normal(E3'(x)), normal(E3''(x))]) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 < x < 1 ->
  det [normal (E3 mu nu x); normal (vDerive 4 (fun x => E3 mu nu x) 1 x); normal (vDerive 4 (fun x => E3 mu nu x) 2 x)] > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 < x < 1.
End sec_4_2_class_interior.

Module sec_4_2_class_ends.
(* gbt-developable/sec-4.2.class.ends, Sect. 4.2
   printed: The ends of the spine curve of Sect. 4.2: where there is none, and where its velocity is zero.
   stated: det([normal(E3(0)), normal(E3'(0)), normal(E3''(0))]) == 1/8*pi*(2 + pi*(1 + mu))*(4*(1 + mu) + pi*(1 - nu))*det([normal(E3_0), normal(E3_1), normal(E3_2)]) and det([E3(0), E3'(0), E3''(0), E3'''(0)]) == 463125/16*sqrt(2)*pi^3*(1 - nu)*(2 + pi*(1 + mu))*(4*(1 + mu) + pi*(1 - nu)) and det([normal(E3(1)), normal(E3'(1)), normal(E3''(1))]) == 1/8*pi*(2 + pi*(1 + nu))*(4*(1 + nu) + pi*(1 - mu))*det([normal(E3_1), normal(E3_2), normal(E3_3)]) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  det [normal (E3 mu nu 0); normal (vDerive 4 (fun x => E3 mu nu x) 1 0); normal (vDerive 4 (fun x => E3 mu nu x) 2 0)] = 1 / 8 * PI * (2 + PI * (1 + mu)) * (4 * (1 + mu) + PI * (1 - nu)) * det [normal E3_0; normal E3_1; normal E3_2] /\ det [E3 mu nu 0; vDerive 4 (fun x => E3 mu nu x) 1 0; vDerive 4 (fun x => E3 mu nu x) 2 0; vDerive 4 (fun x => E3 mu nu x) 3 0] = 463125 / 16 * sqrt 2 * PI ^ 3 * (1 - nu) * (2 + PI * (1 + mu)) * (4 * (1 + mu) + PI * (1 - nu)) /\ det [normal (E3 mu nu 1); normal (vDerive 4 (fun x => E3 mu nu x) 1 1); normal (vDerive 4 (fun x => E3 mu nu x) 2 1)] = 1 / 8 * PI * (2 + PI * (1 + nu)) * (4 * (1 + nu) + PI * (1 - mu)) * det [normal E3_1; normal E3_2; normal E3_3].
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End sec_4_2_class_ends.
