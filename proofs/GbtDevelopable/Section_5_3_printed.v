(* Statements of gbt-developable, Section 5 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition c (k : Z) (l : Z) (mu2 : R) (nu1 : R) : R :=
  (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition ck (k : Z) (nu1 : R) : R :=
  4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)).
Definition cl (l : Z) (mu2 : R) : R :=
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition kappa2 (l : Z) (mu2 : R) : R :=
  IZR l - 2 + PI / 2 * (1 + mu2).
Definition kappa1 (k : Z) (nu1 : R) : R :=
  IZR k - 2 + PI / 2 * (1 + nu1).
Definition P (d : list R) (dd : list R) (h : list R) (e : R) : list R :=
  vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition JA (d : list R) (dd : list R) (h : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e))) (foot (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)).
Definition e1 (d : list R) (dd : list R) (h : list R) (x1 : R) : R :=
  entry dd 4 - dot (normal dd) (JA d dd h x1 0).
Definition e2 (d : list R) (dd : list R) (dd2 : list R) (h : list R) (x1 : R) : R :=
  entry dd2 4 - dot (normal dd2) (JA d dd h x1 0).
End Definitions.
Import Definitions.

Module thm_4_consts.
(* gbt-developable/thm-4.consts, Sect. 5.3, Theorem 4, line after (5.16)
   printed: c = (2(k−2) + π(1+ν_1))/(2(l−2) + π(1+μ_2)), c_k = 4(k−2)(k−3+π(1+ν_1)), c_l = 4(l−2)(l−3+π(1+μ_2))
   read as: Compared with the constants that (5.12) and (5.16) are stated with, and c_k, c_l with the factors of (5.15).
   stated: c == (2*(k - 2) + pi*(1 + nu1))/(2*(l - 2) + pi*(1 + mu2)) and ck == 4*(k - 2)*(k - 3 + pi*(1 + nu1)) and cl == 4*(l - 2)*(l - 3 + pi*(1 + mu2)) and 4*H2''(0) == cl*(P2[0] - 2*P2[1] + P2[2]) + 2*pi^2*mu2*(P2[0] - P2[1]) - pi^2*(1 - nu2)*(P2[1] - P2[2]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P2 : Z -> R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= 0 <= l)%Z ->
  (0 <= 1 <= l)%Z ->
  (0 <= 2 <= l)%Z ->
  c k l mu2 nu1 = (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) /\ ck k nu1 = 4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)) /\ cl l mu2 = 4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) /\ 4 * Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = cl l mu2 * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P2 : Z -> R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= 0 <= l)%Z /\
  (0 <= 1 <= l)%Z /\
  (0 <= 2 <= l)%Z.
End thm_4_consts.

Module thm_4_a.
(* gbt-developable/thm-4.a, Sect. 5.3, Theorem 4, eq. (5.16), first line
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
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
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
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z.
End thm_4_a.

Module thm_4_b.
(* gbt-developable/thm-4.b, Sect. 5.3, Theorem 4, eq. (5.16), second line
   printed: Q_{1,2} = Q_{k,1} + c γ (Q_{k,1} − Q_{k−1,1})
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
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  (0 <= 1 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z.
End thm_4_b.

Module thm_4_c.
(* gbt-developable/thm-4.c, Sect. 5.3, Theorem 4, eq. (5.16), third line
   printed: Q_{2,2} = Q_{k,1} + c γ (Q_{k,1} − Q_{k−1,1}) + 1/(c_l + π²(1−ν_2)) [c_k γ² (Q_{k,1} − 2 Q_{k−1,1} + Q_{k−2,1}) − π² γ² (1−μ_1) × (Q_{k−1,1} − Q_{k−2,1}) + (γ (2π² ν_1 γ + c c_l + 2 c π² μ_2) + λ (k − 2 + π/2 (1+ν_1))) (Q_{k,1} − Q_{k−1,1})]
   stated: P2[2] == P1[k] + c*gamma*(P1[k] - P1[k-1]) + 1/(cl + pi^2*(1 - nu2))*(ck*gamma^2*(P1[k] - 2*P1[k-1] + P1[k-2]) - pi^2*gamma^2*(1 - mu1)*(P1[k-1] - P1[k-2]) + (gamma*(2*pi^2*nu1*gamma + c*cl + 2*c*pi^2*mu2) + lambda*(k - 2 + pi/2*(1 + nu1)))*(P1[k] - P1[k-1])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= 2 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + lambda * (IZR k - 2 + PI / 2 * (1 + nu1))) * (P1 k - P1 (k - 1)%Z)).
End thm_4_c.

Module thm_4_c_corrected.
(* gbt-developable/thm-4.c (corrected), Sect. 5.3, Theorem 4, eq. (5.16), third line
   printed: Q_{2,2} = Q_{k,1} + c γ (Q_{k,1} − Q_{k−1,1}) + 1/(c_l + π²(1−ν_2)) [c_k γ² (Q_{k,1} − 2 Q_{k−1,1} + Q_{k−2,1}) − π² γ² (1−μ_1) × (Q_{k−1,1} − Q_{k−2,1}) + (γ (2π² ν_1 γ + c c_l + 2 c π² μ_2) + λ (k − 2 + π/2 (1+ν_1))) (Q_{k,1} − Q_{k−1,1})]
   stated: P2[2] == P1[k] + c*gamma*(P1[k] - P1[k-1]) + 1/(cl + pi^2*(1 - nu2))*(ck*gamma^2*(P1[k] - 2*P1[k-1] + P1[k-2]) - pi^2*gamma^2*(1 - mu1)*(P1[k-1] - P1[k-2]) + (gamma*(2*pi^2*nu1*gamma + c*cl + 2*c*pi^2*mu2) + 4*(lambda*(k - 2 + pi/2*(1 + nu1))))*(P1[k] - P1[k-1])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= 2 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 2%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + 4 * (lambda * (IZR k - 2 + PI / 2 * (1 + nu1)))) * (P1 k - P1 (k - 1)%Z)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  (0 <= 2 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_c_corrected.

Module thm_4_c_true.
(* gbt-developable/thm-4.c.true, Sect. 5.3, Theorem 4, eq. (5.16), third line
   printed: The third line of (5.16) with 4λ in place of λ.
   stated: P2[2] == P1[k] + c*gamma*(P1[k] - P1[k-1]) + 1/(cl + pi^2*(1 - nu2))*(ck*gamma^2*(P1[k] - 2*P1[k-1] + P1[k-2]) - pi^2*gamma^2*(1 - mu1)*(P1[k-1] - P1[k-2]) + (gamma*(2*pi^2*nu1*gamma + c*cl + 2*c*pi^2*mu2) + 4*lambda*(k - 2 + pi/2*(1 + nu1)))*(P1[k] - P1[k-1])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= 2 <= l)%Z ->
  (0 <= k <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 2%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + 4 * lambda * (IZR k - 2 + PI / 2 * (1 + nu1))) * (P1 k - P1 (k - 1)%Z)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  (0 <= 2 <= l)%Z /\
  (0 <= k <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_c_true.

Module eq_5_17.
(* gbt-developable/eq-5.17, Sect. 5.3, eq. (5.17)
   printed: Q_{0,2} = H_2(0, μ_2, ν_2) = H_1(1, μ_1, ν_1) = Q_{k,1};  H'_2(0, μ_2, ν_2) = γ H'_1(1, μ_1, ν_1), γ > 0;  H''_2(0, μ_2, ν_2) = γ² H''_1(1, μ_1, ν_1) + λ H'_1(1, μ_1, ν_1), where γ > 0 and λ are constants
   read as: The outer equations of the first line, and (5.17) with 'expressions (3.11) and (3.12)' put in, as the proof does.
   stated: H2(0) == P2[0] and H1(1) == P1[k] and 2*(H2'(0) - gamma*H1'(1)) == (2*(l - 2) + pi*(1 + mu2))*(P2[1] - P2[0]) - gamma*(2*(k - 2) + pi*(1 + nu1))*(P1[k] - P1[k-1]) and 4*(H2''(0) - gamma^2*H1''(1) - lambda*H1'(1)) == cl*(P2[0] - 2*P2[1] + P2[2]) + 2*pi^2*mu2*(P2[0] - P2[1]) - pi^2*(1 - nu2)*(P2[1] - P2[2]) - gamma^2*(ck*(P1[k-2] - 2*P1[k-1] + P1[k]) + pi^2*(1 - mu1)*(P1[k-2] - P1[k-1]) - 2*pi^2*nu1*(P1[k-1] - P1[k])) - 2*lambda*(2*(k - 2) + pi*(1 + nu1))*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
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
  H2 P2 l mu2 nu2 0 = P2 0%Z /\ H1 P1 k mu1 nu1 1 = P1 k /\ 2 * (Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 - gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1) = (2 * (IZR l - 2) + PI * (1 + mu2)) * (P2 1%Z - P2 0%Z) - gamma * (2 * (IZR k - 2) + PI * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) /\ 4 * (Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 - gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 - lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1) = cl l mu2 * (P2 0%Z - 2 * P2 1%Z + P2 2%Z) + 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) - PI ^ 2 * (1 - nu2) * (P2 1%Z - P2 2%Z) - gamma ^ 2 * (ck k nu1 * (P1 (k - 2)%Z - 2 * P1 (k - 1)%Z + P1 k) + PI ^ 2 * (1 - mu1) * (P1 (k - 2)%Z - P1 (k - 1)%Z) - 2 * PI ^ 2 * nu1 * (P1 (k - 1)%Z - P1 k)) - 2 * lambda * (2 * (IZR k - 2) + PI * (1 + nu1)) * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
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
End eq_5_17.

Module thm_4_sufficient.
(* gbt-developable/thm-4.sufficient, Sect. 5.3, Theorem 4, the word 'sufficient'
   printed: For a smooth continuous connection among two adjoining developable GBT-Bézier surfaces ... the necessary and sufficient G2 beta continuity requirements are (5.16)
   read as: λ is a constant that (5.17) leaves open: (5.16) as printed gives (5.17) with λ/4 in place of λ. The common generator, the line of Q_{k-1,1} and Q_{k,1}, is there.
   stated: H2(0) == H1(1) and H2'(0) == gamma*H1'(1) and H2''(0) == gamma^2*H1''(1) + lambda/4*H1'(1) and P1[k-1] == H2(0) - H2'(0)/(gamma*(k - 2 + pi/2*(1 + nu1))) *)
Definition beta (P1 : Z -> R) (gamma : R) (k : Z) (l : Z) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + lambda * (IZR k - 2 + PI / 2 * (1 + nu1))) * (P1 k - P1 (k - 1)%Z)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
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
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 ->
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda / 4 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ P1 (k - 1)%Z = H2 P2 l mu2 nu2 0 - Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 / (gamma * (IZR k - 2 + PI / 2 * (1 + nu1))).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
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
  P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  P2 2%Z = beta P1 gamma k l lambda mu1 mu2 nu1 nu2 /\
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_sufficient.

Module thm_4_necessary_families.
(* gbt-developable/thm-4.necessary.families, Sect. 5.3, Theorem 4, the word 'necessary'
   printed: For a smooth continuous connection among two adjoining developable GBT-Bézier surfaces ... the necessary and sufficient G2 beta continuity requirements are (5.16)
   read as: G2 beta continuity is (5.17). The constant λ of (5.16) is four times that of (5.17).
   stated: P2[0] == P1[k] and P2[1] == P1[k] + c*gamma*(P1[k] - P1[k-1]) and P2[2] == at(beta, lambda, 4*lambda) *)
Definition beta (P1 : Z -> R) (gamma : R) (k : Z) (l : Z) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * gamma ^ 2 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * gamma ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (gamma * (2 * PI ^ 2 * nu1 * gamma + c k l mu2 nu1 * cl l mu2 + 2 * c k l mu2 nu1 * PI ^ 2 * mu2) + lambda * (IZR k - 2 + PI / 2 * (1 + nu1))) * (P1 k - P1 (k - 1)%Z)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z) /\ P2 2%Z = (fun lambda : R => beta P1 gamma k l lambda mu1 mu2 nu1 nu2) (4 * lambda).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_necessary_families.

Module thm_4_necessary_surfaces.
(* gbt-developable/thm-4.necessary.surfaces, Sect. 5.3, Theorem 4, the word 'necessary'
   printed: For a smooth continuous connection among two adjoining developable GBT-Bézier surfaces ... the necessary and sufficient G2 beta continuity requirements are (5.16)
   read as: G2 continuity is a matter of the surfaces: tangent plane, generator, characteristic point and curvature agree. The first two lines of (5.16) are stated; a factor rho of all coordinates is enough to refute.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + c*gamma*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (lambda : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  1 <= rho <= 2 ->
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = rho * (gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + lambda * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1) ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + c k l mu2 nu1 * gamma * (P1 k - P1 (k - 1)%Z).
End thm_4_necessary_surfaces.

Module thm_4_true_necessary.
(* gbt-developable/thm-4.true.necessary, Sect. 5.3, Theorem 4
   printed: Two surfaces with the same tangent plane, generator, characteristic point and curvature: what this asks of the control planes, with the constants ρ, γ, s, u and v.
   stated: P2[0] == rho*P1[k] and P2[1] == rho*P1[k] + rho*gamma*c*(P1[k] - P1[k-1]) + s/kappa2*P1[k] and P2[2] == rho*P1[k] + rho*gamma*c*(P1[k] - P1[k-1]) + s/kappa2*P1[k] + 1/(cl + pi^2*(1 - nu2))*(rho*gamma^2*(ck*(P1[k] - 2*P1[k-1] + P1[k-2]) - pi^2*(1 - mu1)*(P1[k-1] - P1[k-2]) + 2*pi^2*nu1*(P1[k] - P1[k-1])) + 4*v*kappa1*(P1[k] - P1[k-1]) + 4*u*P1[k] + (cl + 2*pi^2*mu2)*(rho*gamma*c*(P1[k] - P1[k-1]) + s/kappa2*P1[k])) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R) (u : R) (v : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = rho * gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + v * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + u * H1 P1 k mu1 nu1 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  kappa2 l mu2 <> 0 ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 0%Z = rho * P1 k /\ P2 1%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k /\ P2 2%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (rho * gamma ^ 2 * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + 2 * PI ^ 2 * nu1 * (P1 k - P1 (k - 1)%Z)) + 4 * v * kappa1 k nu1 * (P1 k - P1 (k - 1)%Z) + 4 * u * P1 k + (cl l mu2 + 2 * PI ^ 2 * mu2) * (rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R) (u : R) (v : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = rho * gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + v * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + u * H1 P1 k mu1 nu1 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  kappa2 l mu2 <> 0 /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_true_necessary.

Module thm_4_true_sufficient.
(* gbt-developable/thm-4.true.sufficient, Sect. 5.3, Theorem 4
   printed: Control planes with constants ρ, γ, s, u and v: the families agree up to the second derivative, a change of speed and a factor.
   stated: H2(0) == rho*H1(1) and H2'(0) == rho*gamma*H1'(1) + s*H1(1) and H2''(0) == rho*gamma^2*H1''(1) + v*H1'(1) + u*H1(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R) (u : R) (v : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = rho * P1 k ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  kappa2 l mu2 <> 0 ->
  P2 1%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  P2 2%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (rho * gamma ^ 2 * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + 2 * PI ^ 2 * nu1 * (P1 k - P1 (k - 1)%Z)) + 4 * v * kappa1 k nu1 * (P1 k - P1 (k - 1)%Z) + 4 * u * P1 k + (cl l mu2 + 2 * PI ^ 2 * mu2) * (rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k)) ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = rho * gamma ^ 2 * Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 + v * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + u * H1 P1 k mu1 nu1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R) (u : R) (v : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = rho * P1 k /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  kappa2 l mu2 <> 0 /\
  P2 1%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  P2 2%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (rho * gamma ^ 2 * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + 2 * PI ^ 2 * nu1 * (P1 k - P1 (k - 1)%Z)) + 4 * v * kappa1 k nu1 * (P1 k - P1 (k - 1)%Z) + 4 * u * P1 k + (cl l mu2 + 2 * PI ^ 2 * mu2) * (rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k)) /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End thm_4_true_sufficient.

Module thm_4_true_sheets.
(* gbt-developable/thm-4.true.sheets, Sect. 5.3, Theorem 4
   printed: Two surfaces of a G2 join continue each other: there is no cusp.
   stated: dot(normal(d), JA'(0)) == e1 and e2 == rho*gamma^2*e1 *)
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (rho : R) (u : R) (v : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  0 < gamma ->
  dd2 = vadd (vadd (vscale (rho * gamma ^ 2) dd) (vscale v d)) (vscale u h) ->
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) ->
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  dot (normal d) (vDerive 3 (fun e => JA d dd h x1 e) 1 0) = e1 d dd h x1 /\ e2 d dd dd2 h x1 = rho * gamma ^ 2 * e1 d dd h x1.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (rho : R) (u : R) (v : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  0 < gamma /\
  dd2 = vadd (vadd (vscale (rho * gamma ^ 2) dd) (vscale v d)) (vscale u h) /\
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) /\
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0.
End thm_4_true_sheets.

Module thm_4_true_curvature.
(* gbt-developable/thm-4.true.curvature, Sect. 5.3, Theorem 4
   printed: Two surfaces with the same tangent plane, generator and characteristic point: when their curvatures agree.
   stated: e2 == w*e1 and dot(direction(h2, d2), direction(h2, d2)) == (rho^2*gamma)^2*dot(direction(h, d), direction(h, d)) and dot(normal(h2), normal(h2)) == rho^2*dot(normal(h), normal(h)) *)
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (rho : R) (s : R) (u : R) (v : R) (w : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma ->
  h2 = vscale rho h ->
  d2 = vadd (vscale (rho * gamma) d) (vscale s h) ->
  dd2 = vadd (vadd (vscale w dd) (vscale v d)) (vscale u h) ->
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  e2 d dd dd2 h x1 = w * e1 d dd h x1 /\ dot (direction h2 d2) (direction h2 d2) = (rho ^ 2 * gamma) ^ 2 * dot (direction h d) (direction h d) /\ dot (normal h2) (normal h2) = rho ^ 2 * dot (normal h) (normal h).
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (rho : R) (s : R) (u : R) (v : R) (w : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma /\
  h2 = vscale rho h /\
  d2 = vadd (vscale (rho * gamma) d) (vscale s h) /\
  dd2 = vadd (vadd (vscale w dd) (vscale v d)) (vscale u h) /\
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0.
End thm_4_true_curvature.
