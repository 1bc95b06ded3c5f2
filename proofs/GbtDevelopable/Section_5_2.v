(* Statements of gbt-developable, Section 5 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : Z) : R :=
  sum 0%Z l (fun i => g (IZR x) mu2 nu2 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : Z) : R :=
  sum 0%Z k (fun i => g (IZR x) mu1 nu1 i k * P1 i).
Definition H2_ (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition H1_ (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
Definition c (k : Z) (l : Z) (mu2 : R) (nu1 : R) : R :=
  (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition ck (k : Z) (nu1 : R) : R :=
  4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)).
Definition cl (l : Z) (mu2 : R) : R :=
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)).
Definition farin_boehm (P1 : Z -> R) (k : Z) (l : Z) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (2 * PI ^ 2 * nu1 + c k l mu2 nu1 * (cl l mu2 + 2 * PI ^ 2 * mu2)) * (P1 k - P1 (k - 1)%Z)).
End Definitions.
Import Definitions.

Module eq_5_11.
(* gbt-developable/eq-5.11, Sect. 5.2, eq. (5.11)
   printed: H_2(0, μ_2, ν_2) = H_1(1, μ_1, ν_1);  H'_2(0, μ_2, ν_2) = H'_1(1, μ_1, ν_1);  H''_2(0, μ_2, ν_2) = H''_1(1, μ_1, ν_1)
   read as: The differences of both sides are compared with those of (5.13) and (5.15), in which the paper uses them.
   stated: H2(0) - H1(1) == P2[0] - P1[k] and 2*(H2'(0) - H1'(1)) == (2*(l - 2) + pi*(1 + mu2))*(P2[1] - P2[0]) - (2*(k - 2) + pi*(1 + nu1))*(P1[k] - P1[k-1]) and 4*(H2''(0) - H1''(1)) == 4*(l - 2)*(l - 3 + pi*(1 + mu2))*(P2[0] - 2*P2[1] + P2[2]) + 2*pi^2*mu2*(P2[0] - P2[1]) - pi^2*(1 - nu2)*(P2[1] - P2[2]) - (4*(k - 2)*(k - 3 + pi*(1 + nu1))*(P1[k-2] - 2*P1[k-1] + P1[k]) + pi^2*(1 - mu1)*(P1[k-2] - P1[k-1]) - 2*pi^2*nu1*(P1[k-1] - P1[k])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  (0 <= k - 2 <= k)%Z ->
  H2 P2 l mu2 nu2 0%Z - H1 P1 k mu1 nu1 1%Z = P2 0%Z - P1 k /\ 2 * ((let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) - (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_))) = (2 * (IZR l - 2) + PI * (1 + mu2)) * (P2 1%Z - P2 0%Z) - (2 * (IZR k - 2) + PI * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) /\ 4 * ((let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) - (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___))) = 4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z) - (4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) * (P1 (k - 2)%Z - 2 * P1 (k - 1)%Z + P1 k) + PI ^ 2 * (1 - mu1) * (P1 (k - 2)%Z - P1 (k - 1)%Z) - 2 * PI ^ 2 * nu1 * (P1 (k - 1)%Z - P1 k)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 2 <= l)%Z /\
  (0 <= k - 2 <= k)%Z.
End eq_5_11.

Module sec_5_2_meaning.
(* gbt-developable/sec-5.2.meaning, Sect. 5.2, sentence after (5.11)
   printed: ... represents that the developable GBT-Bézier surfaces defined by H_1(x, μ_1, ν_1), H_2(x, μ_2, ν_2) need to have the same tangent plane, characteristic point, and generator at the joint
   read as: Tangent plane (by its point nearest to the origin), generator (Plücker coordinates) and characteristic point.
   stated: midpoint(h2) == midpoint(h) and direction(h2, d2) == direction(h, d) and moment(h2, d2) == moment(h, d) and meet(h2, d2, dd2) == meet(h, d, dd) *)
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = h ->
  d2 = d ->
  dd2 = dd ->
  dot (normal h2) (normal h2) <> 0 ->
  dot (normal h) (normal h) <> 0 ->
  det [normal h2; normal d2; normal dd2] <> 0 ->
  det [normal h; normal d; normal dd] <> 0 ->
  entry d 1 * entry dd 2 * entry h 3 - entry d 1 * entry dd 3 * entry h 2 - entry d 2 * entry dd 1 * entry h 3 + entry d 2 * entry dd 3 * entry h 1 + entry d 3 * entry dd 1 * entry h 2 - entry d 3 * entry dd 2 * entry h 1 <> 0 ->
  entry h 1 ^ 2 + entry h 2 ^ 2 + entry h 3 ^ 2 <> 0 ->
  midpoint h2 = midpoint h /\ direction h2 d2 = direction h d /\ moment h2 d2 = moment h d /\ meet h2 d2 dd2 = meet h d dd.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = h /\
  d2 = d /\
  dd2 = dd /\
  dot (normal h2) (normal h2) <> 0 /\
  dot (normal h) (normal h) <> 0 /\
  det [normal h2; normal d2; normal dd2] <> 0 /\
  det [normal h; normal d; normal dd] <> 0 /\
  entry d 1 * entry dd 2 * entry h 3 - entry d 1 * entry dd 3 * entry h 2 - entry d 2 * entry dd 1 * entry h 3 + entry d 2 * entry dd 3 * entry h 1 + entry d 3 * entry dd 1 * entry h 2 - entry d 3 * entry dd 2 * entry h 1 <> 0 /\
  entry h 1 ^ 2 + entry h 2 ^ 2 + entry h 3 ^ 2 <> 0.
End sec_5_2_meaning.

Module sec_5_2_ref.
(* gbt-developable/sec-5.2.ref, Sect. 5.2, sentence after (5.11)
   printed: Equation (5.2) represents that the developable GBT-Bézier surfaces ... need to have the same tangent plane, characteristic point, and generator at the joint
   read as: (5.2) names the two families and asks nothing of them: any two would agree, in the end plane to begin with.
   stated: H2(0) == H1(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z.
End sec_5_2_ref.

Module sec_5_2_ref_true.
(* gbt-developable/sec-5.2.ref.true, Sect. 5.2, sentence after (5.11)
   printed: (5.11) asks for the same tangent plane, generator and characteristic point.
   stated: midpoint(h2) == midpoint(h) and direction(h2, d2) == direction(h, d) and moment(h2, d2) == moment(h, d) and meet(h2, d2, dd2) == meet(h, d, dd) *)
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = h ->
  d2 = d ->
  dd2 = dd ->
  dot (normal h2) (normal h2) <> 0 ->
  dot (normal h) (normal h) <> 0 ->
  det [normal h2; normal d2; normal dd2] <> 0 ->
  det [normal h; normal d; normal dd] <> 0 ->
  entry d 1 * entry dd 2 * entry h 3 - entry d 1 * entry dd 3 * entry h 2 - entry d 2 * entry dd 1 * entry h 3 + entry d 2 * entry dd 3 * entry h 1 + entry d 3 * entry dd 1 * entry h 2 - entry d 3 * entry dd 2 * entry h 1 <> 0 ->
  entry h 1 ^ 2 + entry h 2 ^ 2 + entry h 3 ^ 2 <> 0 ->
  midpoint h2 = midpoint h /\ direction h2 d2 = direction h d /\ moment h2 d2 = moment h d /\ meet h2 d2 dd2 = meet h d dd.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = h /\
  d2 = d /\
  dd2 = dd /\
  dot (normal h2) (normal h2) <> 0 /\
  dot (normal h) (normal h) <> 0 /\
  det [normal h2; normal d2; normal dd2] <> 0 /\
  det [normal h; normal d; normal dd] <> 0 /\
  entry d 1 * entry dd 2 * entry h 3 - entry d 1 * entry dd 3 * entry h 2 - entry d 2 * entry dd 1 * entry h 3 + entry d 2 * entry dd 3 * entry h 1 + entry d 3 * entry dd 1 * entry h 2 - entry d 3 * entry dd 2 * entry h 1 <> 0 /\
  entry h 1 ^ 2 + entry h 2 ^ 2 + entry h 3 ^ 2 <> 0.
End sec_5_2_ref_true.

Module sec_5_2_index.
(* gbt-developable/sec-5.2.index, Sect. 5.2, first paragraph (twice)
   printed: control planes Q_{i,j} (i = 1, 2, ..., k; j = 1, 2)
   read as: The first family is made of the control planes with these indices.
   stated: H1(x) == sum(i, 1, k, g[i,k](x, mu1, nu1)*P1[i]) *)
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition statement : Prop :=
forall (k : Z) (P1 : Z -> R) (mu1 : R) (nu1 : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (1 <= i <= k)%Z -> (0 <= i <= k)%Z) ->
  H1 P1 k mu1 nu1 x = sum 1%Z k (fun i => g x mu1 nu1 i k * P1 i).
End sec_5_2_index.

Module thm_3_consts.
(* gbt-developable/thm-3.consts, Sect. 5.2, Theorem 3, line after (5.12)
   printed: c = (2(k−2) + π(1+ν_1))/(2(l−2) + π(1+μ_2)), c_k = 4(k−2)(k−3+π(1+ν_1)), c_l = 4(l−2)(l−3+π(1+μ_2))
   read as: Compared with the constants that (5.12) and (5.16) are stated with, and c with the factor of (5.5).
   stated: c == (2*(k - 2) + pi*(1 + nu1))/(2*(l - 2) + pi*(1 + mu2)) and ck == 4*(k - 2)*(k - 3 + pi*(1 + nu1)) and cl == 4*(l - 2)*(l - 3 + pi*(1 + mu2)) and c == (k - 2 + pi/2*(1 + nu1))/(l - 2 + pi/2*(1 + mu2)) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (mu2 : R) (nu1 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  c k l mu2 nu1 = (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) /\ ck k nu1 = 4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) /\ cl l mu2 = 4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) /\ c k l mu2 nu1 = (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (mu2 : R) (nu1 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0.
End thm_3_consts.

Module thm_3_a.
(* gbt-developable/thm-3.a, Sect. 5.2, Theorem 3, eq. (5.12), first line
   printed: Q_{0,2} = Q_{k,1}
   stated: P2[0] == P1[k] *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z.
End thm_3_a.

Module thm_3_b.
(* gbt-developable/thm-3.b, Sect. 5.2, Theorem 3, eq. (5.12), second line
   printed: Q_{1,2} = Q_{k,1} + c (Q_{k,1} − Q_{k−1,1})
   stated: P2[1] == P1[k] + c*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (0 <= 1 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) /\
  (0 <= 1 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z.
End thm_3_b.

Module thm_3_c.
(* gbt-developable/thm-3.c, Sect. 5.2, Theorem 3, eq. (5.12), third line
   printed: Q_{2,2} = Q_{k,1} + c (Q_{k,1} − Q_{k−1,1}) + 1/(c_l + π²(1−ν_2)) [c_k (Q_{k,1} − 2 Q_{k−1,1} + Q_{k−2,1}) − π²(1−μ_1) × (Q_{k−1,1} − Q_{k−2,1}) + (2π² ν_1 + c (c_l + 2π² μ_2)) (Q_{k,1} − Q_{k−1,1})]
   stated: P2[2] == P1[k] + c*(P1[k] - P1[k-1]) + 1/(cl + pi^2*(1 - nu2))*(ck*(P1[k] - 2*P1[k-1] + P1[k-2]) - pi^2*(1 - mu1)*(P1[k-1] - P1[k-2]) + (2*pi^2*nu1 + c*(cl + 2*pi^2*mu2))*(P1[k] - P1[k-1])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) ->
  (0 <= 2 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 2%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (2 * PI ^ 2 * nu1 + c k l mu2 nu1 * (cl l mu2 + 2 * PI ^ 2 * mu2)) * (P1 k - P1 (k - 1)%Z)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) /\
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) /\
  (0 <= 2 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_3_c.

Module thm_3_sufficient.
(* gbt-developable/thm-3.sufficient, Sect. 5.2, Theorem 3, the word 'satisfactory'
   printed: The essential and satisfactory requirements for achieving Farin–Boehm G2 continuity betwixt two contiguous developable GBT-Bézier surfaces ... at the connection are (5.12)
   read as: (5.12) gives (5.11), and the common generator, the line of Q_{k-1,1} and Q_{k,1}, is there.
   stated: H2(0) == H1(1) and H2'(0) == H1'(1) and H2''(0) == H1''(1) and P1[k-1] == H2(0) - H2'(0)/(k - 2 + pi/2*(1 + nu1)) *)
Definition farin_boehm (P1 : Z -> R) (k : Z) (l : Z) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (2 * PI ^ 2 * nu1 + c k l mu2 nu1 * (cl l mu2 + 2 * PI ^ 2 * mu2)) * (P1 k - P1 (k - 1)%Z)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2 ->
  IZR k - 2 + PI / 2 * (1 + nu1) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\ (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) /\ (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) /\ P1 (k - 1)%Z = H2 P2 l mu2 nu2 0%Z - (let x____ := 0%Z in Derive_n (fun x_____ => H2_ P2 l mu2 nu2 x_____) 1 (IZR x____)) / (IZR k - 2 + PI / 2 * (1 + nu1)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2 /\
  IZR k - 2 + PI / 2 * (1 + nu1) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_3_sufficient.

Module thm_3_necessary_families.
(* gbt-developable/thm-3.necessary.families, Sect. 5.2, Theorem 3, the word 'essential'
   printed: The essential ... requirements for achieving Farin–Boehm G2 continuity betwixt two contiguous developable GBT-Bézier surfaces ... are (5.12)
   read as: Farin–Boehm G2 continuity is (5.11), which 'they must satisfy'.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + c*(P1[k] - P1[k-1]) and P2[2] == farin_boehm *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\ P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) /\
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_3_necessary_families.

Module thm_3_necessary_surfaces.
(* gbt-developable/thm-3.necessary.surfaces, Sect. 5.2, Theorem 3, the word 'essential'
   printed: The essential ... requirements for achieving Farin–Boehm G2 continuity betwixt two contiguous developable GBT-Bézier surfaces ... are (5.12)
   read as: Farin–Boehm G2 continuity is a matter of the surfaces: tangent plane, generator, characteristic point and curvature agree. A factor rho of all coordinates is enough to refute.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + c*(P1[k] - P1[k-1]) and P2[2] == farin_boehm *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  1 <= rho <= 2 ->
  H2 P2 l mu2 nu2 0%Z = rho * H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = rho * (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = rho * (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\ P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2.
End thm_3_necessary_surfaces.

Module eq_5_13.
(* gbt-developable/eq-5.13, Sect. 5.2, eq. (5.13)
   printed: Q_{0,2} = Q_{k,1};  Q_{1,2} = Q_{k,1} + (2(k−2) + π(1+ν_1))/(2(l−2) + π(1+μ_2)) (Q_{k,1} − Q_{k−1,1})
   stated: P2[0] == P1[k] and P2[1] == P1[k] + (2*(k - 2) + pi*(1 + nu1))/(2*(l - 2) + pi*(1 + mu2))*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z /\
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z.
End eq_5_13.

Module eq_5_15.
(* gbt-developable/eq-5.15, Sect. 5.2, eqs. (5.14), (5.15)
   printed: 4(l−2)(l−3+π(1+μ_2))(Q_{0,2} − 2Q_{1,2} + Q_{2,2}) + 2π²μ_2 (Q_{0,2} − Q_{1,2}) − π²(1−ν_2)(Q_{1,2} − Q_{2,2}) = 4(k−2) × (k−3+π(1+ν_1))(Q_{k−2,1} − 2Q_{k−1,1} + Q_{k,1}) + π²(1−μ_1)(Q_{k−2,1} − Q_{k−1,1}) − 2π²ν_1 (Q_{k−1,1} − Q_{k,1})
   stated: 4*(H2''(0) - H1''(1)) == 4*(l - 2)*(l - 3 + pi*(1 + mu2))*(P2[0] - 2*P2[1] + P2[2]) + 2*pi^2*mu2*(P2[0] - P2[1]) - pi^2*(1 - nu2)*(P2[1] - P2[2]) - (4*(k - 2)*(k - 3 + pi*(1 + nu1))*(P1[k-2] - 2*P1[k-1] + P1[k]) + pi^2*(1 - mu1)*(P1[k-2] - P1[k-1]) - 2*pi^2*nu1*(P1[k-1] - P1[k])) *)
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= 1 <= l)%Z ->
  (0 <= 2 <= l)%Z ->
  (0 <= k - 2 <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k <= k)%Z ->
  4 * ((let x := 0%Z in Derive_n (fun x_ => H2 P2 l mu2 nu2 x_) 2 (IZR x)) - (let x_ := 1%Z in Derive_n (fun x__ => H1 P1 k mu1 nu1 x__) 2 (IZR x_))) = 4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z) - (4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) * (P1 (k - 2)%Z - 2 * P1 (k - 1)%Z + P1 k) + PI ^ 2 * (1 - mu1) * (P1 (k - 2)%Z - P1 (k - 1)%Z) - 2 * PI ^ 2 * nu1 * (P1 (k - 1)%Z - P1 k)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= 1 <= l)%Z /\
  (0 <= 2 <= l)%Z /\
  (0 <= k - 2 <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k <= k)%Z.
End eq_5_15.

Module thm_3_proofref.
(* gbt-developable/thm-3.proofref, Sect. 5.2, proof of Theorem 3, last sentence
   printed: Simply by using the values of Q_{0,2}, Q_{1,2} from expression (5.6) into expression (5.8), we can get the required Farin–Boehm G2 continuity requirements (5.5).
   stated: P2[1] == P1[k] + c*(P1[k] - P1[k-1]) and P2[2] == farin_boehm *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\ P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2.
End thm_3_proofref.

Module thm_3_proofref_true.
(* gbt-developable/thm-3.proofref.true, Sect. 5.2, proof of Theorem 3, last sentence
   printed: (5.13) put into (5.15) gives (5.12).
   stated: P2[2] == farin_boehm *)
Definition farin_boehm (P1 : Z -> R) (k : Z) (l : Z) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (2 * PI ^ 2 * nu1 + c k l mu2 nu1 * (cl l mu2 + 2 * PI ^ 2 * mu2)) * (P1 k - P1 (k - 1)%Z)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) ->
  (0 <= 2 <= l)%Z ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z) = 4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) * (P1 (k - 2)%Z - 2 * P1 (k - 1)%Z + P1 k) + PI ^ 2 * (1 - mu1) * (P1 (k - 2)%Z - P1 (k - 1)%Z) - 2 * PI ^ 2 * nu1 * (P1 (k - 1)%Z - P1 k) ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\
  (0 <= 2 <= l)%Z /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z) = 4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) * (P1 (k - 2)%Z - 2 * P1 (k - 1)%Z + P1 k) + PI ^ 2 * (1 - mu1) * (P1 (k - 2)%Z - P1 (k - 1)%Z) - 2 * PI ^ 2 * nu1 * (P1 (k - 1)%Z - P1 k) /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_3_proofref_true.
