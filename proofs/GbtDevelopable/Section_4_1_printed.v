(* Statements of gbt-developable, Section 4 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition E1_0 : list R :=
  [0; - 20; 10; 400].
Definition E1_1 : list R :=
  [0; - 10; 20; 400].
Definition E1_2 : list R :=
  [0; 10; 20; 400].
Definition E1_3 : list R :=
  [0; 20; 10; 400].
Definition E1 (mu : R) (nu : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x mu nu 0%Z 3%Z) E1_0) (vscale (g x mu nu 1%Z 3%Z) E1_1)) (vscale (g x mu nu 2%Z 3%Z) E1_2)) (vscale (g x mu nu 3%Z 3%Z) E1_3).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition distance2 (P : list R) : R :=
  entry P 4 ^ 2 / dot (normal P) (normal P).
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition length2 (P : list R) (D_ : list R) : R :=
  dot (direction P D_) (direction P D_).
Definition len (mu : R) (nu : R) : R :=
  length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0).
Definition E2_0 : list R :=
  [5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_1 : list R :=
  [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_2 : list R :=
  [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_3 : list R :=
  [5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2 (mu : R) (nu : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x mu nu 0%Z 3%Z) E2_0) (vscale (g x mu nu 1%Z 3%Z) E2_1)) (vscale (g x mu nu 2%Z 3%Z) E2_2)) (vscale (g x mu nu 3%Z 3%Z) E2_3).
End Definitions.
Import Definitions.

Module ex_4_1_Q0.
(* gbt-developable/ex-4.1.Q0, Sect. 4.1, Example 4.1, control planes
   printed: Q_0 = (0, −20, 10, 400)
   read as: Compared with the plane that the statements on Example 4.1 use, which is the family at x = 0.
   stated: E1(0) == [0, -20, 10, 400] and E1_0 == E1(0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  E1 mu nu 0 = [0; - 20; 10; 400] /\ E1_0 = E1 mu nu 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End ex_4_1_Q0.

Module ex_4_1_Q1.
(* gbt-developable/ex-4.1.Q1, Sect. 4.1, Example 4.1, control planes
   printed: Q_1 = (0, −10, 20, 400)
   read as: Compared with the plane that the statements on Example 4.1 use, and with what the text says of it: its midpoint is as far from the origin as that of Q_0.
   stated: E1_1 == [0, -10, 20, 400] and distance2([0, -10, 20, 400]) == distance2(E1(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [0; - 10; 20; 400]) (normal [0; - 10; 20; 400]) <> 0 ->
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0 ->
  E1_1 = [0; - 10; 20; 400] /\ distance2 [0; - 10; 20; 400] = distance2 (E1 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [0; - 10; 20; 400]) (normal [0; - 10; 20; 400]) <> 0 /\
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0.
End ex_4_1_Q1.

Module ex_4_1_Q2.
(* gbt-developable/ex-4.1.Q2, Sect. 4.1, Example 4.1, control planes
   printed: Q_2 = (0, 10, 20, 400)
   read as: Compared with the plane that the statements on Example 4.1 use, and with what the text says of it: its midpoint is as far from the origin as that of Q_0.
   stated: E1_2 == [0, 10, 20, 400] and distance2([0, 10, 20, 400]) == distance2(E1(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [0; 10; 20; 400]) (normal [0; 10; 20; 400]) <> 0 ->
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0 ->
  E1_2 = [0; 10; 20; 400] /\ distance2 [0; 10; 20; 400] = distance2 (E1 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [0; 10; 20; 400]) (normal [0; 10; 20; 400]) <> 0 /\
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0.
End ex_4_1_Q2.

Module ex_4_1_Q3.
(* gbt-developable/ex-4.1.Q3, Sect. 4.1, Example 4.1, control planes
   printed: Q_3 = (0, 20, 10, 400)
   read as: Compared with the plane that the statements on Example 4.1 use, which is the family at x = 1, and with what the text says of it: its midpoint is as far from the origin as that of Q_0.
   stated: E1(1) == [0, 20, 10, 400] and distance2([0, 20, 10, 400]) == distance2(E1(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [0; 20; 10; 400]) (normal [0; 20; 10; 400]) <> 0 ->
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0 ->
  E1 mu nu 1 = [0; 20; 10; 400] /\ distance2 [0; 20; 10; 400] = distance2 (E1 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [0; 20; 10; 400]) (normal [0; 20; 10; 400]) <> 0 /\
  dot (normal (E1 mu nu 0)) (normal (E1 mu nu 0)) <> 0.
End ex_4_1_Q3.

Module ex_4_1_distance.
(* gbt-developable/ex-4.1.distance, Sect. 4.1, Example 4.1
   printed: the midpoints of the four control planes of a cubic enveloping developable GBT-Bézier surface have the same distance from the origin
   stated: distance2(E1_0) == distance2(E1_1) == distance2(E1_2) == distance2(E1_3) *)
Definition statement : Prop :=
  dot (normal E1_0) (normal E1_0) <> 0 ->
  dot (normal E1_1) (normal E1_1) <> 0 ->
  dot (normal E1_2) (normal E1_2) <> 0 ->
  dot (normal E1_3) (normal E1_3) <> 0 ->
  distance2 E1_0 = distance2 E1_1 /\ distance2 E1_1 = distance2 E1_2 /\ distance2 E1_2 = distance2 E1_3.
Definition instance : Prop :=
  dot (normal E1_0) (normal E1_0) <> 0 /\
  dot (normal E1_1) (normal E1_1) <> 0 /\
  dot (normal E1_2) (normal E1_2) <> 0 /\
  dot (normal E1_3) (normal E1_3) <> 0.
End ex_4_1_distance.

Module ex_4_1_coplanar.
(* gbt-developable/ex-4.1.coplanar, Sect. 4.1, Example 4.1
   printed: [the midpoints] are laid in the same plane
   stated: volume(E1_0, E1_1, E1_2, E1_3) == 0 *)
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition volume (A : list R) (B : list R) (C_ : list R) (D_ : list R) : R :=
  det [vsub (midpoint B) (midpoint A); vsub (midpoint C_) (midpoint A); vsub (midpoint D_) (midpoint A)].
Definition statement : Prop :=
  dot (normal E1_1) (normal E1_1) <> 0 ->
  dot (normal E1_0) (normal E1_0) <> 0 ->
  dot (normal E1_2) (normal E1_2) <> 0 ->
  dot (normal E1_3) (normal E1_3) <> 0 ->
  volume E1_0 E1_1 E1_2 E1_3 = 0.
Definition instance : Prop :=
  dot (normal E1_1) (normal E1_1) <> 0 /\
  dot (normal E1_0) (normal E1_0) <> 0 /\
  dot (normal E1_2) (normal E1_2) <> 0 /\
  dot (normal E1_3) (normal E1_3) <> 0.
End ex_4_1_coplanar.

Module ex_4_1_c1_a.
(* gbt-developable/ex-4.1.c1.a, Sect. 4.1, Example 4.1, conclusion 1
   printed: Whenever the values of μ stay unchanged, the location of the starting generator J(0; μ, ν) ... will not modify with modifying the value of ν
   read as: 'location' is the line itself: its point nearest to the origin and its direction.
   stated: D(foot(E1(0), E1'(0)), nu) == 0 and cross(direction(E1(0), E1'(0)), D(direction(E1(0), E1'(0)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally nu (fun nu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0) ->
  vDerive 3 (fun nu => foot (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu = zeros 3 /\ cross (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (vDerive 3 (fun nu => direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally nu (fun nu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0).
End ex_4_1_c1_a.

Module ex_4_1_lengths.
(* gbt-developable/ex-4.1.lengths, Sect. 4.1, Example 4.1
   printed: Example 4.1: the lengths of both end generators.
   stated: length2(E1(0), E1'(0)) == (150*(2 + pi*(1 + mu)))^2 and length2(E1(1), E1'(1)) == (150*(2 + pi*(1 + nu)))^2 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0) = (150 * (2 + PI * (1 + mu))) ^ 2 /\ length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1) = (150 * (2 + PI * (1 + nu))) ^ 2.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End ex_4_1_lengths.

Module ex_4_1_lengths_exchanged.
(* gbt-developable/ex-4.1.lengths.exchanged, Sect. 4.1, Example 4.1
   printed: Example 4.1: conclusions 1 and 2 are true with starting and ending generator exchanged.
   stated: D(length2(E1(0), E1'(0)), nu) == 0 and D(length2(E1(1), E1'(1)), nu) > 0 and D(length2(E1(1), E1'(1)), mu) == 0 and D(length2(E1(0), E1'(0)), mu) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu = 0 /\ Derive_n (fun nu => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu > 0 /\ Derive_n (fun mu => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu = 0 /\ Derive_n (fun mu => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 mu > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End ex_4_1_lengths_exchanged.

Module ex_4_1_c1_b.
(* gbt-developable/ex-4.1.c1.b, Sect. 4.1, Example 4.1, conclusion 1
   printed: [with μ unchanged,] the ... location of the ending generator J(1; μ, ν) will not modify with modifying the value of ν
   stated: D(foot(E1(1), E1'(1)), nu) == 0 and cross(direction(E1(1), E1'(1)), D(direction(E1(1), E1'(1)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally nu (fun nu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun nu => foot (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu = zeros 3 /\ cross (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (vDerive 3 (fun nu => direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally nu (fun nu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0).
End ex_4_1_c1_b.

Module ex_4_1_c1_c.
(* gbt-developable/ex-4.1.c1.c, Sect. 4.1, Example 4.1, conclusion 1
   printed: [with μ unchanged,] the length ... of the ending generator J(1; μ, ν) will not modify with modifying the value of ν
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E1(1), E1'(1)), nu) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu = 0.
End ex_4_1_c1_c.

Module ex_4_1_c1_d.
(* gbt-developable/ex-4.1.c1.d, Sect. 4.1, Example 4.1, conclusion 1
   printed: however the length of the starting generator J(0; μ, ν) will modify
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length. With μ unchanged and ν changed, as the sentence before says.
   stated: fails(D(length2(E1(0), E1'(0)), nu) == 0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu = 0).
End ex_4_1_c1_d.

Module ex_4_1_c1_e.
(* gbt-developable/ex-4.1.c1.e, Sect. 4.1, Example 4.1, conclusion 1
   printed: increasing the value of ν will bring an increase in the length of the starting generator
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E1(0), E1'(0)), nu) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu > 0.
End ex_4_1_c1_e.

Module ex_4_1_c1_f_there_and_nowhere_else.
(* gbt-developable/ex-4.1.c1.f.there and nowhere else, Sect. 4.1, Example 4.1, conclusion 1
   printed: Particularly at ν = 1, the length of J(0; μ, ν) becomes maximum, see Fig. 6.
   read as: For every other ν the length is smaller, as an increase with ν would make it.
   stated: at(len, nu, n) < at(len, nu, 1) *)
Definition statement : Prop :=
forall (mu : R) (n : R),
  (-1) <= mu <= 1 ->
  (-1) <= n < 1 ->
  (fun nu : R => len mu nu) n < (fun nu : R => len mu nu) 1.
End ex_4_1_c1_f_there_and_nowhere_else.

Module ex_4_1_c1_f_there_at_least.
(* gbt-developable/ex-4.1.c1.f.there at least, Sect. 4.1, Example 4.1, conclusion 1
   printed: Particularly at ν = 1, the length of J(0; μ, ν) becomes maximum, see Fig. 6.
   read as: For no other ν is the length greater.
   stated: at(len, nu, n) <= at(len, nu, 1) *)
Definition statement : Prop :=
forall (mu : R) (n : R),
  (-1) <= mu <= 1 ->
  (-1) <= n < 1 ->
  (fun nu : R => len mu nu) n <= (fun nu : R => len mu nu) 1.
Definition instance : Prop :=
exists (mu : R) (n : R),
  (-1) <= mu <= 1 /\
  (-1) <= n < 1.
End ex_4_1_c1_f_there_at_least.

Module ex_4_1_c2_a.
(* gbt-developable/ex-4.1.c2.a, Sect. 4.1, Example 4.1, conclusion 2
   printed: For fixed values of ν, the location of J(0; μ, ν) ... will not fluctuate with fluctuating values of μ
   stated: D(foot(E1(0), E1'(0)), mu) == 0 and cross(direction(E1(0), E1'(0)), D(direction(E1(0), E1'(0)), mu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0) ->
  vDerive 3 (fun mu => foot (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 mu = zeros 3 /\ cross (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (vDerive 3 (fun mu => direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 mu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally mu (fun mu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0).
End ex_4_1_c2_a.

Module ex_4_1_c2_b.
(* gbt-developable/ex-4.1.c2.b, Sect. 4.1, Example 4.1, conclusion 2
   printed: For fixed values of ν, the location of ... J(1; μ, ν) will not fluctuate with fluctuating values of μ
   stated: D(foot(E1(1), E1'(1)), mu) == 0 and cross(direction(E1(1), E1'(1)), D(direction(E1(1), E1'(1)), mu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun mu => foot (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu = zeros 3 /\ cross (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (vDerive 3 (fun mu => direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally mu (fun mu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0).
End ex_4_1_c2_b.

Module ex_4_1_c2_c.
(* gbt-developable/ex-4.1.c2.c, Sect. 4.1, Example 4.1, conclusion 2
   printed: but the lengths of ending generators J(1; μ, ν) will modify
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length. With ν fixed and μ changed, as the sentence before says.
   stated: fails(D(length2(E1(1), E1'(1)), mu) == 0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun mu => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu = 0).
End ex_4_1_c2_c.

Module ex_4_1_c2_d.
(* gbt-developable/ex-4.1.c2.d, Sect. 4.1, Example 4.1, conclusion 2
   printed: the length of generators J(1; μ, ν) increases with increasing value of μ
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E1(1), E1'(1)), mu) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun mu => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu > 0.
End ex_4_1_c2_d.

Module ex_4_1_c2_e_there_and_nowhere_else.
(* gbt-developable/ex-4.1.c2.e.there and nowhere else, Sect. 4.1, Example 4.1, conclusion 2
   printed: and will be maximum at μ = 1, see Fig. 7
   read as: For every other μ the length is smaller, as an increase with μ would make it.
   stated: at(len, mu, n) < at(len, mu, 1) *)
Definition len (mu : R) (nu : R) : R :=
  length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1).
Definition statement : Prop :=
forall (n : R) (nu : R),
  (-1) <= n < 1 ->
  (-1) <= nu <= 1 ->
  (fun mu : R => len mu nu) n < (fun mu : R => len mu nu) 1.
End ex_4_1_c2_e_there_and_nowhere_else.

Module ex_4_1_c2_e_there_at_least.
(* gbt-developable/ex-4.1.c2.e.there at least, Sect. 4.1, Example 4.1, conclusion 2
   printed: and will be maximum at μ = 1, see Fig. 7
   read as: For no other μ is the length greater.
   stated: at(len, mu, n) <= at(len, mu, 1) *)
Definition len (mu : R) (nu : R) : R :=
  length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1).
Definition statement : Prop :=
forall (n : R) (nu : R),
  (-1) <= n < 1 ->
  (-1) <= nu <= 1 ->
  (fun mu : R => len mu nu) n <= (fun mu : R => len mu nu) 1.
Definition instance : Prop :=
exists (n : R) (nu : R),
  (-1) <= n < 1 /\
  (-1) <= nu <= 1.
End ex_4_1_c2_e_there_at_least.

Module ex_4_1_c3_a.
(* gbt-developable/ex-4.1.c3.a, Sect. 4.1, Example 4.1, conclusion 3
   printed: For identical values of μ, ν, the ... location of both starting J(0; μ, ν) and ending J(1; μ, ν) generators will modify with modifying values of μ, ν.
   read as: 'location' is the line itself. Refuted is already that one of the two lines moves for some change of μ and ν.
   stated: fails(D(foot(E1(0), E1'(0)), mu) == 0 and D(foot(E1(0), E1'(0)), nu) == 0 and cross(direction(E1(0), E1'(0)), D(direction(E1(0), E1'(0)), mu)) == 0 and cross(direction(E1(0), E1'(0)), D(direction(E1(0), E1'(0)), nu)) == 0 and D(foot(E1(1), E1'(1)), mu) == 0 and D(foot(E1(1), E1'(1)), nu) == 0 and cross(direction(E1(1), E1'(1)), D(direction(E1(1), E1'(1)), mu)) == 0 and cross(direction(E1(1), E1'(1)), D(direction(E1(1), E1'(1)), nu)) == 0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0) ->
  locally nu (fun nu => dot (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) <> 0) ->
  locally mu (fun mu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0) ->
  locally nu (fun nu => dot (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun mu => foot (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu = zeros 3 /\ cross (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (vDerive 3 (fun mu => direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 mu) = zeros 3 /\ cross (direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) (vDerive 3 (fun nu => direction (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 1 nu) = zeros 3 /\ vDerive 3 (fun mu => foot (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu = zeros 3 /\ cross (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (vDerive 3 (fun mu => direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 mu) = zeros 3 /\ cross (direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) (vDerive 3 (fun nu => direction (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 1 nu) = zeros 3).
End ex_4_1_c3_a.

Module ex_4_1_c3_b.
(* gbt-developable/ex-4.1.c3.b, Sect. 4.1, Example 4.1, conclusion 3
   printed: For identical values of μ, ν, the length ... of both starting J(0; μ, ν) and ending J(1; μ, ν) generators will modify
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: fails(D(at(length2(E1(0), E1'(0)), mu, nu), nu) == 0) and fails(D(at(length2(E1(1), E1'(1)), mu, nu), nu) == 0) *)
Definition statement : Prop :=
forall (nu : R),
  (-1) <= nu <= 1 ->
  ~ (forall (nu : R),
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => (fun mu : R => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) nu) 1 nu = 0) /\ ~ (forall (nu : R),
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => (fun mu : R => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) nu) 1 nu = 0).
Definition instance : Prop :=
exists (nu : R),
  (-1) <= nu <= 1.
End ex_4_1_c3_b.

Module ex_4_1_c3_c.
(* gbt-developable/ex-4.1.c3.c, Sect. 4.1, Example 4.1, conclusion 3
   printed: With increasing values of μ, ν, the length of both generators increases.
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length. Both parameters altered together: mu = nu.
   stated: D(at(length2(E1(0), E1'(0)), mu, nu), nu) > 0 and D(at(length2(E1(1), E1'(1)), mu, nu), nu) > 0 *)
Definition statement : Prop :=
forall (nu : R),
  (-1) <= nu <= 1 ->
  Derive_n (fun nu => (fun mu : R => length2 (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) nu) 1 nu > 0 /\ Derive_n (fun nu => (fun mu : R => length2 (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) nu) 1 nu > 0.
Definition instance : Prop :=
exists (nu : R),
  (-1) <= nu <= 1.
End ex_4_1_c3_c.

Module ex_4_1_c3_d.
(* gbt-developable/ex-4.1.c3.d, Sect. 4.1, Example 4.1, conclusion 3
   printed: the structure of the enveloping developable surface will also modify as the height enveloping developable GBT-Bézier surface increases with decreasing values of μ, ν, see Fig. 8
   read as: 'height' read as the Z extent of the surface, which for these planes is the Z extent of the profile ψ(x): from its ends to its top at x = 1/2, see the remark. The derivative is that along mu = nu.
   stated: D(height, nu) < 0 and D(other, nu) < 0 *)
Definition height (nu : R) : R :=
  (fun mu : R => entry (foot (E1 mu nu (1 / 2)) (vDerive 4 (fun x => E1 mu nu x) 1 (1 / 2))) 3 - entry (foot (E1 mu nu 0) (vDerive 4 (fun x => E1 mu nu x) 1 0)) 3) nu.
Definition other (nu : R) : R :=
  (fun mu : R => entry (foot (E1 mu nu (1 / 2)) (vDerive 4 (fun x => E1 mu nu x) 1 (1 / 2))) 3 - entry (foot (E1 mu nu 1) (vDerive 4 (fun x => E1 mu nu x) 1 1)) 3) nu.
Definition statement : Prop :=
forall (nu : R),
  (-1) <= nu <= 1 ->
  locally nu (fun nu => dot (direction (E1 nu nu (1 / 2)) (vDerive 4 (fun x => E1 nu nu x) 1 (1 / 2))) (direction (E1 nu nu (1 / 2)) (vDerive 4 (fun x => E1 nu nu x) 1 (1 / 2))) <> 0) ->
  locally nu (fun nu => dot (direction (E1 nu nu 0) (vDerive 4 (fun x => E1 nu nu x) 1 0)) (direction (E1 nu nu 0) (vDerive 4 (fun x => E1 nu nu x) 1 0)) <> 0) ->
  locally nu (fun nu => dot (direction (E1 nu nu 1) (vDerive 4 (fun x => E1 nu nu x) 1 1)) (direction (E1 nu nu 1) (vDerive 4 (fun x => E1 nu nu x) 1 1)) <> 0) ->
  Derive_n (fun nu => height nu) 1 nu < 0 /\ Derive_n (fun nu => other nu) 1 nu < 0.
Definition instance : Prop :=
exists (nu : R),
  (-1) <= nu <= 1 /\
  locally nu (fun nu => dot (direction (E1 nu nu (1 / 2)) (vDerive 4 (fun x => E1 nu nu x) 1 (1 / 2))) (direction (E1 nu nu (1 / 2)) (vDerive 4 (fun x => E1 nu nu x) 1 (1 / 2))) <> 0) /\
  locally nu (fun nu => dot (direction (E1 nu nu 0) (vDerive 4 (fun x => E1 nu nu x) 1 0)) (direction (E1 nu nu 0) (vDerive 4 (fun x => E1 nu nu x) 1 0)) <> 0) /\
  locally nu (fun nu => dot (direction (E1 nu nu 1) (vDerive 4 (fun x => E1 nu nu x) 1 1)) (direction (E1 nu nu 1) (vDerive 4 (fun x => E1 nu nu x) 1 1)) <> 0).
End ex_4_1_c3_d.

Module ex_4_1_c3_d_top.
(* gbt-developable/ex-4.1.c3.d.top, Sect. 4.1, Example 4.1, conclusion 3
   printed: Example 4.1: for μ = ν the profile has its top at x = 1/2.
   stated: z == 400*D(q, x)/(D(q, x)*r - q*D(r, x)) and D(400*D(q, x)/(D(q, x)*r - q*D(r, x)), x) == 400*q*(D(q, x)*D(r, x, 2) - D(q, x, 2)*D(r, x))/(D(q, x)*r - q*D(r, x))^2 and D(q, x)*D(r, x, 2) - D(q, x, 2)*D(r, x) <= 0 and D(q, x) >= 0 and at(q, x, 1/2) == 0 and D(q, x)*r - q*D(r, x) > 0 *)
Definition q (nu : R) (x : R) : R :=
  (fun mu : R => entry (E1 mu nu x) 2) nu.
Definition r (nu : R) (x : R) : R :=
  (fun mu : R => entry (E1 mu nu x) 3) nu.
Definition z (nu : R) (x : R) : R :=
  (fun mu : R => entry (foot (E1 mu nu x) (vDerive 4 (fun x => E1 mu nu x) 1 x)) 3) nu.
Definition statement : Prop :=
forall (nu : R) (x : R),
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  dot (direction (E1 nu nu x) (vDerive 4 (fun x => E1 nu nu x) 1 x)) (direction (E1 nu nu x) (vDerive 4 (fun x => E1 nu nu x) 1 x)) <> 0 ->
  Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x <> 0 ->
  locally x (fun x => Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x <> 0) ->
  (Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x) ^ 2 <> 0 ->
  z nu x = 400 * Derive_n (fun x => q nu x) 1 x / (Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x) /\ Derive_n (fun x => 400 * Derive_n (fun x => q nu x) 1 x / (Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x)) 1 x = 400 * q nu x * (Derive_n (fun x => q nu x) 1 x * Derive_n (fun x => r nu x) 2 x - Derive_n (fun x => q nu x) 2 x * Derive_n (fun x => r nu x) 1 x) / (Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x) ^ 2 /\ Derive_n (fun x => q nu x) 1 x * Derive_n (fun x => r nu x) 2 x - Derive_n (fun x => q nu x) 2 x * Derive_n (fun x => r nu x) 1 x <= 0 /\ Derive_n (fun x => q nu x) 1 x >= 0 /\ (fun x : R => q nu x) (1 / 2) = 0 /\ Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x > 0.
Definition instance : Prop :=
exists (nu : R) (x : R),
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  dot (direction (E1 nu nu x) (vDerive 4 (fun x => E1 nu nu x) 1 x)) (direction (E1 nu nu x) (vDerive 4 (fun x => E1 nu nu x) 1 x)) <> 0 /\
  Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x <> 0 /\
  locally x (fun x => Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x <> 0) /\
  (Derive_n (fun x => q nu x) 1 x * r nu x - q nu x * Derive_n (fun x => r nu x) 1 x) ^ 2 <> 0.
End ex_4_1_c3_d_top.

Module ex_4_2_Q0.
(* gbt-developable/ex-4.2.Q0, Sect. 4.1, Example 4.2, control planes
   printed: Q_0 = (5√2, −5√2, 5, 125)
   read as: Compared with the plane that the statements on Example 4.2 use, which is the family at x = 0.
   stated: E2(0) == [5*sqrt(2), -5*sqrt(2), 5, 125] and E2_0 == E2(0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  E2 mu nu 0 = [5 * sqrt 2; - 5 * sqrt 2; 5; 125] /\ E2_0 = E2 mu nu 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End ex_4_2_Q0.

Module ex_4_2_Q1.
(* gbt-developable/ex-4.2.Q1, Sect. 4.1, Example 4.2, control planes
   printed: Q_1 = (−5√2, −5√2, 5, 125)
   read as: Compared with the plane that the statements on Example 4.2 use, and with the rule of Sect. 4: its midpoint is as far from the origin as that of Q_0.
   stated: E2_1 == [-5*sqrt(2), -5*sqrt(2), 5, 125] and distance2([-5*sqrt(2), -5*sqrt(2), 5, 125]) == distance2(E2(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 ->
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0 ->
  E2_1 = [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125] /\ distance2 [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125] = distance2 (E2 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 /\
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0.
End ex_4_2_Q1.

Module ex_4_2_Q2.
(* gbt-developable/ex-4.2.Q2, Sect. 4.1, Example 4.2, control planes
   printed: Q_2 = (−5√2, −5√2, 5, 125)
   read as: Compared with the plane that the statements on Example 4.2 use, and with the rule of Sect. 4: its midpoint is as far from the origin as that of Q_0.
   stated: E2_2 == [-5*sqrt(2), -5*sqrt(2), 5, 125] and distance2([-5*sqrt(2), -5*sqrt(2), 5, 125]) == distance2(E2(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 ->
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0 ->
  E2_2 = [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125] /\ distance2 [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125] = distance2 (E2 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 /\
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0.
End ex_4_2_Q2.

Module ex_4_2_Q3.
(* gbt-developable/ex-4.2.Q3, Sect. 4.1, Example 4.2, control planes
   printed: Q_3 = (5√2, −5√2, 5, 125)
   read as: Compared with the plane that the statements on Example 4.2 use, which is the family at x = 1, and with the rule of Sect. 4: its midpoint is as far from the origin as that of Q_0.
   stated: E2(1) == [5*sqrt(2), -5*sqrt(2), 5, 125] and distance2([5*sqrt(2), -5*sqrt(2), 5, 125]) == distance2(E2(0)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  dot (normal [5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 ->
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0 ->
  E2 mu nu 1 = [5 * sqrt 2; - 5 * sqrt 2; 5; 125] /\ distance2 [5 * sqrt 2; - 5 * sqrt 2; 5; 125] = distance2 (E2 mu nu 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  dot (normal [5 * sqrt 2; - 5 * sqrt 2; 5; 125]) (normal [5 * sqrt 2; - 5 * sqrt 2; 5; 125]) <> 0 /\
  dot (normal (E2 mu nu 0)) (normal (E2 mu nu 0)) <> 0.
End ex_4_2_Q3.

Module ex_4_2_class.
(* gbt-developable/ex-4.2.class, Sect. 4.1, Example 4.2, paragraph after the planes
   printed: with fluctuating values of shape parameters μ, ν, a class of enveloping developable GBT-Bézier surfaces can be designed on the requirement of provided control planes
   read as: (3.7) is a surface at some point at least: for some shape parameters, some x and some x1 its two tangent vectors are not parallel.
   stated: fails(cross(direction(E2(x), E2'(x)), J'(x)) == 0) *)
Definition J (mu : R) (nu : R) (x1 : R) (x : R) : list R :=
  vadd (vscale x1 (direction (E2 mu nu x) (vDerive 4 (fun x => E2 mu nu x) 1 x))) (foot (E2 mu nu x) (vDerive 4 (fun x => E2 mu nu x) 1 x)).
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R) (x1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  ~ (forall (mu : R) (nu : R) (x : R) (x1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  locally x (fun x_ => dot (direction (E2 mu nu x_) (vDerive 4 (fun x => E2 mu nu x) 1 x_)) (direction (E2 mu nu x_) (vDerive 4 (fun x => E2 mu nu x) 1 x_)) <> 0) ->
  cross (direction (E2 mu nu x) (vDerive 4 (fun x => E2 mu nu x) 1 x)) (vDerive 3 (fun x => J mu nu x1 x) 1 x) = zeros 3).
End ex_4_2_class.

Module ex_4_2_pencil.
(* gbt-developable/ex-4.2.pencil, Sect. 4.1, Example 4.2
   printed: Example 4.2: all planes contain one line.
   stated: dot(normal(E2(x)), [0, y, 25 + sqrt(2)*y]) == E2(x)[4] *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R) (y : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  dot (normal (E2 mu nu x)) [0; y; 25 + sqrt 2 * y] = entry (E2 mu nu x) 4.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R) (y : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End ex_4_2_pencil.

Module ex_4_2_lengths.
(* gbt-developable/ex-4.2.lengths, Sect. 4.1, Example 4.2
   printed: Example 4.2: the lengths of both end generators.
   stated: length2(E2(0), E2'(0)) == 3750*(2 + pi*(1 + mu))^2 and length2(E2(1), E2'(1)) == 3750*(2 + pi*(1 + nu))^2 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  length2 (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0) = 3750 * (2 + PI * (1 + mu)) ^ 2 /\ length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1) = 3750 * (2 + PI * (1 + nu)) ^ 2.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End ex_4_2_lengths.

Module ex_4_2_c1_a.
(* gbt-developable/ex-4.2.c1.a, Sect. 4.1, Example 4.2, conclusion 1
   printed: When we fix the value of ν, the length of generator J(1; μ, ν) will modify ... with fluctuating values of μ
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: fails(D(length2(E2(1), E2'(1)), mu) == 0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun mu => length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu = 0).
End ex_4_2_c1_a.

Module ex_4_2_c1_b.
(* gbt-developable/ex-4.2.c1.b, Sect. 4.1, Example 4.2, conclusion 1
   printed: [ν fixed] the location of generator J(1; μ, ν) ... will not modify with fluctuating values of μ
   stated: D(foot(E2(1), E2'(1)), mu) == 0 and cross(direction(E2(1), E2'(1)), D(direction(E2(1), E2'(1)), mu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu = zeros 3 /\ cross (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (vDerive 3 (fun mu => direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0).
End ex_4_2_c1_b.

Module ex_4_2_c1_c.
(* gbt-developable/ex-4.2.c1.c, Sect. 4.1, Example 4.2, conclusion 1
   printed: [ν fixed] the ... location of generator J(0; μ, ν) will not modify with fluctuating values of μ
   stated: D(foot(E2(0), E2'(0)), mu) == 0 and cross(direction(E2(0), E2'(0)), D(direction(E2(0), E2'(0)), mu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu = zeros 3 /\ cross (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (vDerive 3 (fun mu => direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0).
End ex_4_2_c1_c.

Module ex_4_2_c1_d.
(* gbt-developable/ex-4.2.c1.d, Sect. 4.1, Example 4.2, conclusion 1
   printed: [ν fixed] the length ... of generator J(0; μ, ν) will not modify with fluctuating values of μ
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E2(0), E2'(0)), mu) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun mu => length2 (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu = 0.
End ex_4_2_c1_d.

Module ex_4_2_c1_e.
(* gbt-developable/ex-4.2.c1.e, Sect. 4.1, Example 4.2, conclusion 1
   printed: the length of the ending generator will increase simultaneously with an increase in the value of μ, see Figs. 9–10
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E2(1), E2'(1)), mu) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  Derive_n (fun mu => length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu > 0.
End ex_4_2_c1_e.

Module ex_4_2_c2_a.
(* gbt-developable/ex-4.2.c2.a, Sect. 4.1, Example 4.2, conclusion 2
   printed: When we take positive values of μ, ν, the length ... of J(0; μ, ν) ... will not alter with the altering values of μ, ν
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: D(length2(E2(0), E2'(0)), mu) == 0 and D(length2(E2(0), E2'(0)), nu) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  0 < mu <= 1 ->
  0 < nu <= 1 ->
  Derive_n (fun mu => length2 (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu = 0 /\ Derive_n (fun nu => length2 (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 nu = 0.
End ex_4_2_c2_a.

Module ex_4_2_c2_b.
(* gbt-developable/ex-4.2.c2.b, Sect. 4.1, Example 4.2, conclusion 2
   printed: [positive μ, ν] the ... location of J(0; μ, ν) ... will not alter
   stated: D(foot(E2(0), E2'(0)), mu) == 0 and D(foot(E2(0), E2'(0)), nu) == 0 and cross(direction(E2(0), E2'(0)), D(direction(E2(0), E2'(0)), mu)) == 0 and cross(direction(E2(0), E2'(0)), D(direction(E2(0), E2'(0)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  0 < mu <= 1 ->
  0 < nu <= 1 ->
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) ->
  locally nu (fun nu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 nu = zeros 3 /\ cross (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (vDerive 3 (fun mu => direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu) = zeros 3 /\ cross (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (vDerive 3 (fun nu => direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  0 < mu <= 1 /\
  0 < nu <= 1 /\
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) /\
  locally nu (fun nu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0).
End ex_4_2_c2_b.

Module ex_4_2_c2_c.
(* gbt-developable/ex-4.2.c2.c, Sect. 4.1, Example 4.2, conclusion 2
   printed: [positive μ, ν] ... location of J(1; μ, ν) will not alter
   stated: D(foot(E2(1), E2'(1)), mu) == 0 and D(foot(E2(1), E2'(1)), nu) == 0 and cross(direction(E2(1), E2'(1)), D(direction(E2(1), E2'(1)), mu)) == 0 and cross(direction(E2(1), E2'(1)), D(direction(E2(1), E2'(1)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  0 < mu <= 1 ->
  0 < nu <= 1 ->
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) ->
  locally nu (fun nu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 nu = zeros 3 /\ cross (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (vDerive 3 (fun mu => direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu) = zeros 3 /\ cross (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (vDerive 3 (fun nu => direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  0 < mu <= 1 /\
  0 < nu <= 1 /\
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) /\
  locally nu (fun nu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0).
End ex_4_2_c2_c.

Module ex_4_2_c2_d.
(* gbt-developable/ex-4.2.c2.d, Sect. 4.1, Example 4.2, conclusion 2
   printed: but the length of the ending generator J(1; μ, ν) will modify, see Fig. 11
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length.
   stated: fails(D(length2(E2(1), E2'(1)), mu) == 0 and D(length2(E2(1), E2'(1)), nu) == 0) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  0 < mu <= 1 ->
  0 < nu <= 1 ->
  ~ (forall (mu : R) (nu : R),
  0 < mu <= 1 ->
  0 < nu <= 1 ->
  Derive_n (fun mu => length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu = 0 /\ Derive_n (fun nu => length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 nu = 0).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  0 < mu <= 1 /\
  0 < nu <= 1.
End ex_4_2_c2_d.

Module ex_4_2_c3_a.
(* gbt-developable/ex-4.2.c3.a, Sect. 4.1, Example 4.2, conclusion 3
   printed: When we take negative values of μ, ν, the location of J(0; μ, ν) ... will not fluctuate
   stated: D(foot(E2(0), E2'(0)), mu) == 0 and D(foot(E2(0), E2'(0)), nu) == 0 and cross(direction(E2(0), E2'(0)), D(direction(E2(0), E2'(0)), mu)) == 0 and cross(direction(E2(0), E2'(0)), D(direction(E2(0), E2'(0)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu < 0 ->
  (-1) <= nu < 0 ->
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) ->
  locally nu (fun nu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 nu = zeros 3 /\ cross (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (vDerive 3 (fun mu => direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 mu) = zeros 3 /\ cross (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (vDerive 3 (fun nu => direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu < 0 /\
  (-1) <= nu < 0 /\
  locally mu (fun mu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0) /\
  locally nu (fun nu => dot (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) (direction (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) <> 0).
End ex_4_2_c3_a.

Module ex_4_2_c3_b.
(* gbt-developable/ex-4.2.c3.b, Sect. 4.1, Example 4.2, conclusion 3
   printed: When we take negative values of μ, ν, the location of ... J(1; μ, ν) will not fluctuate
   stated: D(foot(E2(1), E2'(1)), mu) == 0 and D(foot(E2(1), E2'(1)), nu) == 0 and cross(direction(E2(1), E2'(1)), D(direction(E2(1), E2'(1)), mu)) == 0 and cross(direction(E2(1), E2'(1)), D(direction(E2(1), E2'(1)), nu)) == 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu < 0 ->
  (-1) <= nu < 0 ->
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) ->
  locally nu (fun nu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) ->
  vDerive 3 (fun mu => foot (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu = zeros 3 /\ vDerive 3 (fun nu => foot (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 nu = zeros 3 /\ cross (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (vDerive 3 (fun mu => direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 mu) = zeros 3 /\ cross (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (vDerive 3 (fun nu => direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) 1 nu) = zeros 3.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu < 0 /\
  (-1) <= nu < 0 /\
  locally mu (fun mu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0) /\
  locally nu (fun nu => dot (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) (direction (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) <> 0).
End ex_4_2_c3_b.

Module ex_4_2_c3_c.
(* gbt-developable/ex-4.2.c3.c, Sect. 4.1, Example 4.2, conclusion 3
   printed: however, the length of the ending and starting generator will modify
   read as: The length of a generator is |φ| times the length of one fixed interval of x1 in (3.7): the paper gives no range for x1, and a line has no length. Both parameters altered together.
   stated: fails(D(at(length2(E2(1), E2'(1)), mu, nu), nu) == 0) and fails(D(at(length2(E2(0), E2'(0)), mu, nu), nu) == 0) *)
Definition statement : Prop :=
forall (nu : R),
  (-1) <= nu < 0 ->
  ~ (forall (nu : R),
  (-1) <= nu < 0 ->
  Derive_n (fun nu => (fun mu : R => length2 (E2 mu nu 1) (vDerive 4 (fun x => E2 mu nu x) 1 1)) nu) 1 nu = 0) /\ ~ (forall (nu : R),
  (-1) <= nu < 0 ->
  Derive_n (fun nu => (fun mu : R => length2 (E2 mu nu 0) (vDerive 4 (fun x => E2 mu nu x) 1 0)) nu) 1 nu = 0).
Definition instance : Prop :=
exists (nu : R),
  (-1) <= nu < 0.
End ex_4_2_c3_c.

Module ex_4_2_c3_d.
(* gbt-developable/ex-4.2.c3.d, Sect. 4.1, Example 4.2, conclusion 3
   printed: ... will modify along with the shape of the enveloping developable GBT-Bézier surface, see Fig. 12
   read as: The shape is the set of the generators; refuted is already that one of them moves when μ = ν changes.
   stated: fails(D(line(x), nu) == 0 and cross(along(x), D(along(x), nu)) == 0) *)
Definition line (nu : R) (x : R) : list R :=
  (fun mu : R => foot (E2 mu nu x) (vDerive 4 (fun x => E2 mu nu x) 1 x)) nu.
Definition along (nu : R) (x : R) : list R :=
  (fun mu : R => direction (E2 mu nu x) (vDerive 4 (fun x => E2 mu nu x) 1 x)) nu.
Definition statement : Prop :=
forall (nu : R) (x : R),
  (-1) <= nu < 0 ->
  0 <= x <= 1 ->
  ~ (forall (nu : R) (x : R),
  (-1) <= nu < 0 ->
  0 <= x <= 1 ->
  locally nu (fun nu => dot (direction (E2 nu nu x) (vDerive 4 (fun x => E2 nu nu x) 1 x)) (direction (E2 nu nu x) (vDerive 4 (fun x => E2 nu nu x) 1 x)) <> 0) ->
  vDerive 3 (fun nu => line nu x) 1 nu = zeros 3 /\ cross (along nu x) (vDerive 3 (fun nu => along nu x) 1 nu) = zeros 3).
End ex_4_2_c3_d.
