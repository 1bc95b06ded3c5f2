(* Statements of gbt-developable, Section 5 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition c (k : Z) (l : Z) (mu2 : R) (nu1 : R) : R :=
  (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition cl (l : Z) (mu2 : R) : R :=
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)).
Definition ck (k : Z) (nu1 : R) : R :=
  4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)).
Definition beta (P1 : Z -> R) (gamma : R) (k : Z) (l : Z) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + lambda * (IZR k - 2 + PI / 2 * (1 + nu1))) * (P1 k - P1 (k - 1)%Z)).
End Definitions.
Import Definitions.

Module alg_5_4_s1.
(* gbt-developable/alg-5.4.s1, Sect. 5.4, Step 1
   printed: Preliminary developable GBT-Bézier surface H_1(x; μ_1, ν_1), its control planes Q_{i,1} (i = 0, 1, 2, 3), and shape parameters μ_1, ν_1 can be given openly.
   read as: Whether (5.17) can be solved for the planes of the second surface does not depend on the first surface: neither its control planes nor its shape parameters occur in the determinant of the equations.
   stated: D(det(matrix), mu1) == 0 and D(det(matrix), nu1) == 0 and det(matrix) == pi/8*(2 + pi*(1 + mu2))*(4*(1 + mu2) + pi*(1 - nu2)) *)
Definition matrix (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) : list (list R) :=
  [[Derive_n (fun t => H2 (update1 P2 0%Z t) l mu2 nu2 0) 1 (P2 0%Z); Derive_n (fun t => H2 (update1 P2 1%Z t) l mu2 nu2 0) 1 (P2 1%Z); Derive_n (fun t => H2 (update1 P2 2%Z t) l mu2 nu2 0) 1 (P2 2%Z)]; [Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 0%Z t) l mu2 nu2 x) 1 0) 1 (P2 0%Z); Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 1%Z t) l mu2 nu2 x) 1 0) 1 (P2 1%Z); Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 2%Z t) l mu2 nu2 x) 1 0) 1 (P2 2%Z)]; [Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 0%Z t) l mu2 nu2 x) 2 0) 1 (P2 0%Z); Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 1%Z t) l mu2 nu2 x) 2 0) 1 (P2 1%Z); Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 2%Z t) l mu2 nu2 x) 2 0) 1 (P2 2%Z)]].
Definition statement : Prop :=
forall (k : Z) (l : Z) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (0 <= 0 <= l)%Z ->
  (0 <= 1 <= l)%Z ->
  (0 <= 2 <= l)%Z ->
  Derive_n (fun mu1 => det (matrix P2 l mu2 nu2)) 1 mu1 = 0 /\ Derive_n (fun nu1 => det (matrix P2 l mu2 nu2)) 1 nu1 = 0 /\ det (matrix P2 l mu2 nu2) = PI / 8 * (2 + PI * (1 + mu2)) * (4 * (1 + mu2) + PI * (1 - nu2)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  (0 <= 0 <= l)%Z /\
  (0 <= 1 <= l)%Z /\
  (0 <= 2 <= l)%Z.
End alg_5_4_s1.

Module alg_5_4_s2_families.
(* gbt-developable/alg-5.4.s2.families, Sect. 5.4, Step 2
   printed: Let Q_{k,1} = Q_{0,2}, or in other words, the developable GBT-Bézier surfaces ... have a combined control plane to fulfil the G0 continuity condition.
   read as: G0 continuity of the families as curves of four coordinates: they have the plane in common.
   stated: H2(0) == H1(1) *)
Definition H2 (P2 : Z -> list R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : list R :=
  vsum 4 0%Z l (fun i => vscale (g x mu2 nu2 i l) (P2 i)).
Definition H1 (P1 : Z -> list R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu1 nu1 i k) (P1 i)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1'1 P1'2 P1'3 P1'4 : Z -> R) (P2'1 P2'2 P2'3 P2'4 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let P1 := fun i0 => [P1'1 i0; P1'2 i0; P1'3 i0; P1'4 i0] in
  let P2 := fun i0 => [P2'1 i0; P2'2 i0; P2'3 i0; P2'4 i0] in
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1'1 P1'2 P1'3 P1'4 : Z -> R) (P2'1 P2'2 P2'3 P2'4 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let P1 := fun i0 => [P1'1 i0; P1'2 i0; P1'3 i0; P1'4 i0] in
  let P2 := fun i0 => [P2'1 i0; P2'2 i0; P2'3 i0; P2'4 i0] in
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k.
End alg_5_4_s2_families.

Module alg_5_4_s2_surfaces.
(* gbt-developable/alg-5.4.s2.surfaces, Sect. 5.4, Step 2
   printed: Let Q_{k,1} = Q_{0,2}, or in other words, the developable GBT-Bézier surfaces ... have a combined control plane to fulfil the G0 continuity condition.
   read as: G0 continuity of the surfaces: the end generators are one line; stated is that they are parallel.
   stated: cross(direction(H1(1), H1'(1)), direction(H2(0), H2'(0))) == 0 *)
Definition H1 (P1 : Z -> list R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu1 nu1 i k) (P1 i)).
Definition H2 (P2 : Z -> list R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : list R :=
  vsum 4 0%Z l (fun i => vscale (g x mu2 nu2 i l) (P2 i)).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1'1 P1'2 P1'3 P1'4 : Z -> R) (P2'1 P2'2 P2'3 P2'4 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let P1 := fun i0 => [P1'1 i0; P1'2 i0; P1'3 i0; P1'4 i0] in
  let P2 := fun i0 => [P2'1 i0; P2'2 i0; P2'3 i0; P2'4 i0] in
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  cross (direction (H1 P1 k mu1 nu1 1) (vDerive 4 (fun x => H1 P1 k mu1 nu1 x) 1 1)) (direction (H2 P2 l mu2 nu2 0) (vDerive 4 (fun x => H2 P2 l mu2 nu2 x) 1 0)) = zeros 3.
End alg_5_4_s2_surfaces.

Module alg_5_4_s3.
(* gbt-developable/alg-5.4.s3, Sect. 5.4, Step 3
   printed: For any provided values of μ_2, ν_2 and constant γ > 0, the 2nd control plane Q_{1,2} of the developable GBT-Bézier surface H_2(x; μ_2, ν_2) can be calculated from the second equation of (5.16).
   stated: P2[1] == P1[k] + c*gamma*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= 1 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  (0 <= 1 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z.
End alg_5_4_s3.

Module alg_5_4_s4.
(* gbt-developable/alg-5.4.s4, Sect. 5.4, Step 4
   printed: From the 3rd equation of (5.16), the control plane Q_{2,2} of the developable GBT-Bézier surface H_2(x; μ_2, ν_2) can be determined on the bases of Step 2 and Step 3 for a defined value of constant λ.
   read as: The plane of the third equation of (5.16) completes a G2 beta join: (5.17) holds with a constant, which is λ/4.
   stated: H2(0) == H1(1) and H2'(0) == gamma*H1'(1) and H2''(0) == gamma^2*H1''(1) + lambda/4*H1'(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 ->
  4 * (1 + mu2) + PI * (1 - nu2) <> 0 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda / 4 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 /\
  4 * (1 + mu2) + PI * (1 - nu2) <> 0.
End alg_5_4_s4.

Module alg_5_4_s5.
(* gbt-developable/alg-5.4.s5, Sect. 5.4, Step 5
   printed: The last control plane Q_{3,2} of H_2(x; μ_2, ν_2) can be selected openly
   read as: Q_{3,2} does not occur in the plane and the two derivatives at the joint.
   stated: coefficients([H2(0), H2'(0), H2''(0)], [P2[3]]) == 0 *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P2 : Z -> R) (mu2 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (0 <= 3 <= l)%Z ->
  [[Derive_n (fun t => H2 (update1 P2 3%Z t) l mu2 nu2 0) 1 (P2 3%Z)]; [Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 3%Z t) l mu2 nu2 x) 1 0) 1 (P2 3%Z)]; [Derive_n (fun t => Derive_n (fun x => H2 (update1 P2 3%Z t) l mu2 nu2 x) 2 0) 1 (P2 3%Z)]] = mzeros 3 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P2 : Z -> R) (mu2 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  (0 <= 3 <= l)%Z.
End alg_5_4_s5.

Module alg_5_4_iterate.
(* gbt-developable/alg-5.4.iterate, Sect. 5.4, last paragraph
   printed: From iteration of the above steps among two developable GBT-Bézier surfaces, G2 beta smooth continuity can be attained among multiple developable GBT-Bézier surfaces, and it can also be applied on other continuity conditions in the same manners.
   read as: The steps done twice, with the planes printed in (5.16) for the second surface and again for the third: both joints satisfy (5.17). As printed (5.16) does so with λ/4 for λ. G1 and Farin–Boehm G2 are parts of it.
   stated: H2(0) == H1(1) and H2'(0) == gamma*H1'(1) and H2''(0) == gamma^2*H1''(1) + lambda/4*H1'(1) and H3(0) == H2(1) and H3'(0) == gamma2*H2'(1) and H3''(0) == gamma2^2*H2''(1) + lambda2/4*H2'(1) *)
Definition c3 (mu3 : R) (nu2 : R) : R :=
  (2 + PI * (1 + nu2)) / (2 + PI * (1 + mu3)).
Definition H3 (P3 : Z -> R) (mu3 : R) (nu3 : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x mu3 nu3 i 3%Z * P3 i).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (P3 : Z -> R) (gamma : R) (gamma2 : R) (lambda : R) (lambda2 : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R),
  0 < gamma ->
  0 < gamma2 ->
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
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 ->
  (0 <= 3 <= l)%Z ->
  P3 0%Z = P2 3%Z ->
  2 + PI * (1 + mu3) <> 0 ->
  P3 1%Z = P2 3%Z + c3 mu3 nu2 * gamma2 * (P2 3%Z - P2 2%Z) ->
  4 * PI * (1 + mu3) + PI ^ 2 * (1 - nu3) <> 0 ->
  P3 2%Z = P2 3%Z + c3 mu3 nu2 * gamma2 * (P2 3%Z - P2 2%Z) + 1 / (4 * PI * (1 + mu3) + PI ^ 2 * (1 - nu3)) * (4 * PI * (1 + nu2) * gamma2 ^ 2 * (P2 3%Z - 2 * P2 2%Z + P2 1%Z) - PI ^ 2 * gamma2 ^ 2 * (1 - mu2) * (P2 2%Z - P2 1%Z) + (gamma2 * (2 * PI ^ 2 * nu2 * gamma2 + c3 mu3 nu2 * 4 * PI * (1 + mu3) + 2 * c3 mu3 nu2 * PI ^ 2 * mu3) + lambda2 * (1 + PI / 2 * (1 + nu2))) * (P2 3%Z - P2 2%Z)) ->
  4 * (1 + mu2) + PI * (1 - nu2) <> 0 ->
  4 * (1 + mu3) + PI * (1 - nu3) <> 0 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda / 4 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ H3 P3 mu3 nu3 0 = H2 P2 l mu2 nu2 1 /\ Derive_n (fun x => H3 P3 mu3 nu3 x) 1 0 = gamma2 * Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 1 /\ Derive_n (fun x => H3 P3 mu3 nu3 x) 2 0 = gamma2 ^ 2 * Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 1 + lambda2 / 4 * Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (P3 : Z -> R) (gamma : R) (gamma2 : R) (lambda : R) (lambda2 : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R),
  0 < gamma /\
  0 < gamma2 /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= mu3 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (-1) <= nu3 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 /\
  (0 <= 3 <= l)%Z /\
  P3 0%Z = P2 3%Z /\
  2 + PI * (1 + mu3) <> 0 /\
  P3 1%Z = P2 3%Z + c3 mu3 nu2 * gamma2 * (P2 3%Z - P2 2%Z) /\
  4 * PI * (1 + mu3) + PI ^ 2 * (1 - nu3) <> 0 /\
  P3 2%Z = P2 3%Z + c3 mu3 nu2 * gamma2 * (P2 3%Z - P2 2%Z) + 1 / (4 * PI * (1 + mu3) + PI ^ 2 * (1 - nu3)) * (4 * PI * (1 + nu2) * gamma2 ^ 2 * (P2 3%Z - 2 * P2 2%Z + P2 1%Z) - PI ^ 2 * gamma2 ^ 2 * (1 - mu2) * (P2 2%Z - P2 1%Z) + (gamma2 * (2 * PI ^ 2 * nu2 * gamma2 + c3 mu3 nu2 * 4 * PI * (1 + mu3) + 2 * c3 mu3 nu2 * PI ^ 2 * mu3) + lambda2 * (1 + PI / 2 * (1 + nu2))) * (P2 3%Z - P2 2%Z)) /\
  4 * (1 + mu2) + PI * (1 - nu2) <> 0 /\
  4 * (1 + mu3) + PI * (1 - nu3) <> 0.
End alg_5_4_iterate.
