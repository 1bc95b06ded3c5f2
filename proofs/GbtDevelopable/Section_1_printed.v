(* Statements of gbt-developable, Section 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition ratio (gamma : R) (l : Z) (mu2 : R) (mu3 : R) : R :=
  gamma * (2 * (IZR l - 2) + PI * (1 + mu3)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition N2 (P2 : Z -> R) (l : Z) (mu3 : R) (nu3 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu3 nu3 i l * P2 i).
End Definitions.
Import Definitions.

Module intro_continuity_free_a.
(* gbt-developable/intro-continuity-free.a, Sect. 1, list of contributions, last item, for the smooth connection (5.5)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: 'smooth connection' is checked for each of the paper's three conditions: (5.5), (5.12), (5.16). Here (5.5): the shape parameters of the second family are changed from mu2, nu2 to mu3, nu3, and (5.5) is met again, with another gamma.
   stated: N2(0) == H1(1) and N2'(0) == ratio*H1'(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu3 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu3 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  N2 P2 l mu3 nu3 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => N2 P2 l mu3 nu3 x) 1 0 = ratio gamma l mu2 mu3 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu3 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= mu3 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu3 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End intro_continuity_free_a.

Module intro_continuity_free_b_any_values.
(* gbt-developable/intro-continuity-free.b.any values, Sect. 1, list of contributions, last item, for the smooth connection (5.12)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: Whatever values the shape parameters of the second family get, the derivatives still agree.
   stated: N2'(0) == H1'(1) and N2''(0) == H1''(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (-1) <= nu3 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 ->
  Derive_n (fun x => N2 P2 l mu3 nu3 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ Derive_n (fun x => N2 P2 l mu3 nu3 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1.
End intro_continuity_free_b_any_values.

Module intro_continuity_free_b_suitable_values.
(* gbt-developable/intro-continuity-free.b.suitable values, Sect. 1, list of contributions, last item, for the smooth connection (5.12)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: There are other values with which the connection stays: exhibited for cubic families that join with all shape parameters 0, of which all four are changed together, along a curve with the parameter t.
   stated: N2(0) == N1(1) and N2'(0) == N1'(1) and N2''(0) == N1''(1) and -1 <= inner and inner <= 1 and -1 <= outer and outer <= 1 and fails(inner == 0) and fails(outer == 0) *)
Definition F2 (B : Z -> R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x 0 0 i 3%Z * B i).
Definition F1 (A : Z -> R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x 0 0 i 3%Z * A i).
Definition inner (t : R) : R :=
  (t * (2 + PI) - 2) / PI - 1.
Definition outer (t : R) : R :=
  1 - ((4 + PI) / 8 * ((4 + 2 * PI) * (2 * t * (2 + PI) - 4) - 4 * PI ^ 2) - 4 * (t * (2 + PI) - 2)) / PI ^ 2.
Definition N2 (B : Z -> R) (t : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x (inner t) (outer t) i 3%Z * B i).
Definition N1 (A : Z -> R) (t : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x (outer t) (inner t) i 3%Z * A i).
Definition statement : Prop :=
forall (A : Z -> R) (B : Z -> R) (t : R),
  19 / 20 <= t <= 21 / 20 ->
  F2 B 0 = F1 A 1 ->
  Derive_n (fun x => F2 B x) 1 0 = Derive_n (fun x => F1 A x) 1 1 ->
  Derive_n (fun x => F2 B x) 2 0 = Derive_n (fun x => F1 A x) 2 1 ->
  N2 B t 0 = N1 A t 1 /\ Derive_n (fun x => N2 B t x) 1 0 = Derive_n (fun x => N1 A t x) 1 1 /\ Derive_n (fun x => N2 B t x) 2 0 = Derive_n (fun x => N1 A t x) 2 1 /\ - 1 <= inner t /\ inner t <= 1 /\ - 1 <= outer t /\ outer t <= 1 /\ ~ (forall (A : Z -> R) (B : Z -> R) (t : R),
  19 / 20 <= t <= 21 / 20 ->
  F2 B 0 = F1 A 1 ->
  Derive_n (fun x => F2 B x) 1 0 = Derive_n (fun x => F1 A x) 1 1 ->
  Derive_n (fun x => F2 B x) 2 0 = Derive_n (fun x => F1 A x) 2 1 ->
  inner t = 0) /\ ~ (forall (A : Z -> R) (B : Z -> R) (t : R),
  19 / 20 <= t <= 21 / 20 ->
  F2 B 0 = F1 A 1 ->
  Derive_n (fun x => F2 B x) 1 0 = Derive_n (fun x => F1 A x) 1 1 ->
  Derive_n (fun x => F2 B x) 2 0 = Derive_n (fun x => F1 A x) 2 1 ->
  outer t = 0).
Definition instance : Prop :=
exists (A : Z -> R) (B : Z -> R) (t : R),
  19 / 20 <= t <= 21 / 20 /\
  F2 B 0 = F1 A 1 /\
  Derive_n (fun x => F2 B x) 1 0 = Derive_n (fun x => F1 A x) 1 1 /\
  Derive_n (fun x => F2 B x) 2 0 = Derive_n (fun x => F1 A x) 2 1.
End intro_continuity_free_b_suitable_values.

Module intro_continuity_free_c_any_values.
(* gbt-developable/intro-continuity-free.c.any values, Sect. 1, list of contributions, last item, for the smooth connection (5.16)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: The shape parameters of the second family are changed from mu2, nu2 to any mu3, nu3. The first derivatives then have the ratio `ratio`, and the second derivative needs the square of it before that of the first family; what is free besides are multiples of the end plane and of the first derivative, in which Q_{k-2,1} does not occur.
   stated: coefficients([N2''(0)], [P1[k-2]]) == ratio^2*coefficients([H1''(1)], [P1[k-2]]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R) (P2_0_of_t : R -> R) (P2_1_of_t : R -> R) (P2_2_of_t : R -> R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (-1) <= nu3 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= k - 2 <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  P2_0_of_t (P1 (k - 2)%Z) = P2 0%Z ->
  P2_1_of_t (P1 (k - 2)%Z) = P2 1%Z ->
  P2_2_of_t (P1 (k - 2)%Z) = P2 2%Z ->
  (forall t : R, H2 (update1 (update1 (update1 P2 0%Z (P2_0_of_t t)) 1%Z (P2_1_of_t t)) 2%Z (P2_2_of_t t)) l mu2 nu2 0 = H1 (update1 P1 (k - 2)%Z t) k mu1 nu1 1) ->
  (forall t : R, Derive_n (fun x => H2 (update1 (update1 (update1 P2 0%Z (P2_0_of_t t)) 1%Z (P2_1_of_t t)) 2%Z (P2_2_of_t t)) l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 (update1 P1 (k - 2)%Z t) k mu1 nu1 x) 1 1) ->
  (forall t : R, Derive_n (fun x => H2 (update1 (update1 (update1 P2 0%Z (P2_0_of_t t)) 1%Z (P2_1_of_t t)) 2%Z (P2_2_of_t t)) l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 (update1 P1 (k - 2)%Z t) k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 (update1 P1 (k - 2)%Z t) k mu1 nu1 x) 1 1) ->
  [[Derive_n (fun t => Derive_n (fun x => N2 (update1 (update1 (update1 P2 0%Z (P2_0_of_t t)) 1%Z (P2_1_of_t t)) 2%Z (P2_2_of_t t)) l mu3 nu3 x) 2 0) 1 (P1 (k - 2)%Z)]] = mscale (ratio gamma l mu2 mu3 ^ 2) [[Derive_n (fun t => Derive_n (fun x => H1 (update1 P1 (k - 2)%Z t) k mu1 nu1 x) 2 1) 1 (P1 (k - 2)%Z)]].
End intro_continuity_free_c_any_values.

Module intro_contrib_4.
(* gbt-developable/intro-contrib-4, Sect. 1, list of contributions, fourth item
   printed: Our described developable GBT-Bézier surfaces take over the most advantageous features of the classical developable Bézier surfaces. Moreover, the shape adjustment property is additional to that of classical developable Bézier surfaces
   read as: The features that carry over to the family of planes (3.1): the functions sum to one, the first and last plane are control planes; and the family changes with both shape parameters.
   stated: sum(i, 0, k, g[i,k](x)) == 1 and H(0) == Q[0] and H(1) == Q[k] and fails(D(H(x), mu) == 0) and fails(D(H(x), nu) == 0) *)
Definition H (Q : Z -> R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * Q i).
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= k <= k)%Z ->
  sum 0%Z k (fun i => g x mu nu i k) = 1 /\ H Q k mu nu 0 = Q 0%Z /\ H Q k mu nu 1 = Q k /\ ~ (forall (k : Z) (Q : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= k)%Z -> (2 <= k)%Z) ->
  Derive_n (fun mu => H Q k mu nu x) 1 mu = 0) /\ ~ (forall (k : Z) (Q : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= k)%Z -> (2 <= k)%Z) ->
  Derive_n (fun nu => H Q k mu nu x) 1 nu = 0).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= k <= k)%Z.
End intro_contrib_4.

Module intro_gauss.
(* gbt-developable/intro-gauss, Sect. 1, first paragraph, of (3.7)
   printed: a smooth surface having zero Gaussian curvature at each point on it is known as a developable surface
   read as: (3.7) is developable in this sense. It is linear in x1, so that the first coefficient of its second fundamental form is zero; the second is the part of φ' across the tangent plane, which is along a, and is zero too: so is the determinant of the form.
   stated: direction_at'(0) == cross(a, a'') and dot(a, phi) == 0 and dot(a, J'(0)) == 0 and dot(a, direction_at'(0)) == 0 *)
Definition a (a0 : R) (a1 : R) (a2 : R) : list R :=
  [a0; a1; a2].
Definition a' (a0' : R) (a1' : R) (a2' : R) : list R :=
  [a0'; a1'; a2'].
Definition a'' (a0'' : R) (a1'' : R) (a2'' : R) : list R :=
  [a0''; a1''; a2''].
Definition A (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (e : R) : list R :=
  vadd (vadd (a a0 a1 a2) (vscale e (a' a0' a1' a2'))) (vscale (e ^ 2 / 2) (a'' a0'' a1'' a2'')).
Definition direction_at (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (e : R) : list R :=
  cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e).
Definition A3 (a3 : R) (a3' : R) (a3'' : R) (e : R) : R :=
  a3 + e * a3' + e ^ 2 / 2 * a3''.
Definition J (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e))) (vdiv (cross (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (vsub (vscale (Derive_n (fun e => A3 a3 a3' a3'' e) 1 e) (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e)) (vscale (A3 a3 a3' a3'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)))) (dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)))).
Definition phi (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) : list R :=
  cross (a a0 a1 a2) (a' a0' a1' a2').
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R),
  locally 0 (fun e => dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) <> 0) ->
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0 ->
  vDerive 3 (fun e => direction_at a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0 = cross (a a0 a1 a2) (a'' a0'' a1'' a2'') /\ dot (a a0 a1 a2) (phi a0 a0' a1 a1' a2 a2') = 0 /\ dot (a a0 a1 a2) (vDerive 3 (fun e => J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 e) 1 0) = 0 /\ dot (a a0 a1 a2) (vDerive 3 (fun e => direction_at a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0) = 0.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R),
  locally 0 (fun e => dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) <> 0) /\
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0.
End intro_gauss.
