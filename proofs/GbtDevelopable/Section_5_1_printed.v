(* Statements of gbt-developable, Section 5 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition E1_0 : list R :=
  [0; - 20; 10; 400].
Definition E1_1 : list R :=
  [0; - 10; 20; 400].
Definition E1_2 : list R :=
  [0; 10; 20; 400].
Definition E1_3 : list R :=
  [0; 20; 10; 400].
Definition F1 (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x 1 1 0%Z 3%Z) E1_0) (vscale (g x 1 1 1%Z 3%Z) E1_1)) (vscale (g x 1 1 2%Z 3%Z) E1_2)) (vscale (g x 1 1 3%Z 3%Z) E1_3).
Definition kappa2 (l : Z) (mu2 : R) : R :=
  IZR l - 2 + PI / 2 * (1 + mu2).
Definition c (k : Z) (l : Z) (mu2 : R) (nu1 : R) : R :=
  (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
End Definitions.
Import Definitions.

Module eq_5_3_b.
(* gbt-developable/eq-5.3.b, Sect. 5.1, eq. (5.3), second line, and the text after it
   printed: Ĝ_2(x, μ_2, ν_2) = Σ_{j=0}^{l} g_{j,l}(x, μ_2, ν_2) R̂_{j,2}, R̂_{j,2} = (ω_{j,2} Q_{j,2}, ω_{j,2})
   read as: The first components of the control points: by (5.1) on the left, as printed here on the right.
   stated: omega_2[j]*R_2[j] == omega_2[j]*Q_2[j] *)
Definition statement : Prop :=
forall (j : Z) (l : Z) (Q_2 : Z -> R) (R_2 : Z -> R) (omega_2 : Z -> R),
  (0 <= j <= l)%Z ->
  (2 <= l)%Z ->
  omega_2 j * R_2 j = omega_2 j * Q_2 j.
End eq_5_3_b.

Module eq_5_3_b_corrected.
(* gbt-developable/eq-5.3.b (corrected), Sect. 5.1, eq. (5.3), second line, and the text after it
   printed: Ĝ_2(x, μ_2, ν_2) = Σ_{j=0}^{l} g_{j,l}(x, μ_2, ν_2) R̂_{j,2}, R̂_{j,2} = (ω_{j,2} Q_{j,2}, ω_{j,2})
   read as: The first components of the control points: by (5.1) on the left, as printed here on the right.
   stated: omega_2[j]*R_2[j] == omega_2[j]*R_2[j] *)
Definition statement : Prop :=
forall (j : Z) (l : Z) (R_2 : Z -> R) (omega_2 : Z -> R),
  (0 <= j <= l)%Z ->
  (2 <= l)%Z ->
  omega_2 j * R_2 j = omega_2 j * R_2 j.
Definition instance : Prop :=
exists (j : Z) (l : Z) (R_2 : Z -> R) (omega_2 : Z -> R),
  (0 <= j <= l)%Z /\
  (2 <= l)%Z.
End eq_5_3_b_corrected.

Module eq_5_4.
(* gbt-developable/eq-5.4, Sect. 5.1, eq. (5.4)
   printed: Ĝ_2(0, μ_2, ν_2) = Ĝ_1(1, μ_1, ν_1);  Ĝ'_2(0, μ_2, ν_2) = γ Ĝ'_1(1, μ_1, ν_1), where γ > 0 is a constant
   read as: With the control planes for the control points: the differences of both sides are compared with those of (5.6) and (5.9), in which the paper uses them.
   stated: H2(0) - H1(1) == P2[0] - P1[k] and gamma*H1'(1) - H2'(0) == gamma*(k - 2 + pi/2*(1 + nu1))*(P1[k] - P1[k-1]) - (l - 2 + pi/2*(1 + mu2))*(P2[1] - P2[0]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  H2 P2 l mu2 nu2 0 - H1 P1 k mu1 nu1 1 = P2 0%Z - P1 k /\ gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 - Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) - (IZR l - 2 + PI / 2 * (1 + mu2)) * (P2 1%Z - P2 0%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 1 <= l)%Z.
End eq_5_4.

Module eq_5_4_nec_suf_curves_of_four_coordinates.
(* gbt-developable/eq-5.4.nec-suf.curves of four coordinates, Sect. 5.1, sentence before (5.4)
   printed: from the definition of G1 continuity among two parametric curves, the adequate and essential requirements for G1 continuous connection among two or more contiguous weighted GBT-Bézier curves Ĝ_1(x) and Ĝ_2(x) are (5.4)
   read as: 'G1 continuity among two or more weighted GBT-Bézier curves in a 4D homogeneous space': same point and same direction there. d and d2 are the derivatives; their directions agree where Cauchy's inequality is an equality, that is where d2 has no part across d, so that it is a multiple of d.
   stated: dot(d2, d2)*dot(d, d) - dot(d2, d)^2 == dot(across, across)*dot(d, d) and d2 - across == dot(d2, d)/dot(d, d)*d *)
Definition across (d : list R) (d2 : list R) : list R :=
  vsub d2 (vscale (dot d2 d / dot d d) d).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  dot d d <> 0 ->
  entry d 1 ^ 2 + entry d 2 ^ 2 + entry d 3 ^ 2 + entry d 4 ^ 2 <> 0 ->
  dot d2 d2 * dot d d - dot d2 d ^ 2 = dot (across d d2) (across d d2) * dot d d /\ vsub d2 (across d d2) = vscale (dot d2 d / dot d d) d.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  dot d d <> 0 /\
  entry d 1 ^ 2 + entry d 2 ^ 2 + entry d 3 ^ 2 + entry d 4 ^ 2 <> 0.
End eq_5_4_nec_suf_curves_of_four_coordinates.

Module eq_5_4_nec_suf_curves_in_space.
(* gbt-developable/eq-5.4.nec-suf.curves in space, Sect. 5.1, sentence before (5.4)
   printed: from the definition of G1 continuity among two parametric curves, the adequate and essential requirements for G1 continuous connection among two or more contiguous weighted GBT-Bézier curves Ĝ_1(x) and Ĝ_2(x) are (5.4)
   read as: The curves after division by the weight, which (5.1) is for. h and d are the homogeneous point and derivative of the first curve, r h and r gamma d + s h those of the second: they give the same point and the same tangent.
   stated: point(r*h) == point(h) and velocity(r*h, r*gamma*d + s*h) == gamma*velocity(h, d) and r*h == h and r*gamma*d + s*h == gamma*d *)
Definition point (p : list R) : list R :=
  vdiv [entry p 1; entry p 2; entry p 3] (entry p 4).
Definition velocity (p : list R) (dp : list R) : list R :=
  vdiv (vsub (vscale (entry p 4) [entry dp 1; entry dp 2; entry dp 3]) (vscale (entry dp 4) [entry p 1; entry p 2; entry p 3])) (entry p 4 ^ 2).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (r : R) (s : R),
  let d := [d'1; d'2; d'3; d'4] in
  let h := [h'1; h'2; h'3; h'4] in
  0 < gamma ->
  0 < r ->
  1 <= entry h 4 ->
  entry h 4 <= 2 ->
  entry (vscale r h) 4 <> 0 ->
  entry h 4 <> 0 ->
  entry (vscale r h) 4 ^ 2 <> 0 ->
  entry h 4 ^ 2 <> 0 ->
  point (vscale r h) = point h /\ velocity (vscale r h) (vadd (vscale (r * gamma) d) (vscale s h)) = vscale gamma (velocity h d) /\ vscale r h = h /\ vadd (vscale (r * gamma) d) (vscale s h) = vscale gamma d.
End eq_5_4_nec_suf_curves_in_space.

Module sec_5_1_certify.
(* gbt-developable/sec-5.1.certify, Sect. 5.1, sentence before Theorem 2
   printed: the geometric continuity among two curves in a 4D homogeneous space certifies the geometric continuity among two conforming developable surfaces developed by using the duality principle in a 3D Euclidean space
   read as: h, d and the plane (n, ...) are the plane of the first family at the joint and its first two derivatives, h2, d2 and (n2, ...) those of the second; JA and JB the rulings (3.7) of both surfaces, start the point of the generator. The surfaces have the generator in common, and their tangent vectors across it are multiples of each other with the factor (e1 e2/γ)/e1², which is positive: the second sheet continues the first.
   stated: JB(0) == JA(0) and cross(direction(h, d), JB'(0)) == e1*e2/gamma/e1^2*cross(direction(h, d), JA'(0)) and e1*e2/gamma > 0 *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition start (d : list R) (h : list R) (x1 : R) : list R :=
  vadd (vscale x1 (direction h d)) (foot h d).
Definition dd2 (d : list R) (e2 : R) (h : list R) (n2 : list R) (x1 : R) : list R :=
  [entry n2 1; entry n2 2; entry n2 3; dot n2 (start d h x1) + e2].
Definition O_ (d : list R) (d2 : list R) (e2 : R) (h : list R) (h2 : list R) (n2 : list R) (x1 : R) (e : R) : list R :=
  vadd (vadd h2 (vscale e d2)) (vscale (e ^ 2 / 2) (dd2 d e2 h n2 x1)).
Definition dd (d : list R) (e1 : R) (h : list R) (n : list R) (x1 : R) : list R :=
  [entry n 1; entry n 2; entry n 3; dot n (start d h x1) + e1].
Definition P (d : list R) (e1 : R) (h : list R) (n : list R) (x1 : R) (e : R) : list R :=
  vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) (dd d e1 h n x1)).
Definition JB (d : list R) (d2 : list R) (e2 : R) (gamma : R) (h : list R) (h2 : list R) (n2 : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale (x1 / gamma) (direction (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e))) (foot (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e)).
Definition JA (d : list R) (e1 : R) (h : list R) (n : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (direction (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e))) (foot (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e)).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (e1 : R) (e2 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (n'1 n'2 n'3 : R) (n2'1 n2'2 n2'3 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  let n := [n'1; n'2; n'3] in
  let n2 := [n2'1; n2'2; n2'3] in
  0 < gamma ->
  dot (direction h d) (direction h d) <> 0 ->
  e1 * e2 > 0 ->
  h2 = h ->
  d2 = vscale gamma d ->
  gamma <> 0 ->
  dot (direction (O_ d d2 e2 h h2 n2 x1 0) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 0)) (direction (O_ d d2 e2 h h2 n2 x1 0) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 0)) <> 0 ->
  dot (direction (P d e1 h n x1 0) (vDerive 4 (fun e => P d e1 h n x1 e) 1 0)) (direction (P d e1 h n x1 0) (vDerive 4 (fun e => P d e1 h n x1 e) 1 0)) <> 0 ->
  locally 0 (fun e => dot (direction (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e)) (direction (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e)) <> 0) ->
  e1 ^ 2 <> 0 ->
  locally 0 (fun e => dot (direction (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e)) (direction (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e)) <> 0) ->
  JB d d2 e2 gamma h h2 n2 x1 0 = JA d e1 h n x1 0 /\ cross (direction h d) (vDerive 3 (fun e => JB d d2 e2 gamma h h2 n2 x1 e) 1 0) = vscale (e1 * e2 / gamma / e1 ^ 2) (cross (direction h d) (vDerive 3 (fun e => JA d e1 h n x1 e) 1 0)) /\ e1 * e2 / gamma > 0.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (e1 : R) (e2 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (n'1 n'2 n'3 : R) (n2'1 n2'2 n2'3 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  let n := [n'1; n'2; n'3] in
  let n2 := [n2'1; n2'2; n2'3] in
  0 < gamma /\
  dot (direction h d) (direction h d) <> 0 /\
  e1 * e2 > 0 /\
  h2 = h /\
  d2 = vscale gamma d /\
  gamma <> 0 /\
  dot (direction (O_ d d2 e2 h h2 n2 x1 0) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 0)) (direction (O_ d d2 e2 h h2 n2 x1 0) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 0)) <> 0 /\
  dot (direction (P d e1 h n x1 0) (vDerive 4 (fun e => P d e1 h n x1 e) 1 0)) (direction (P d e1 h n x1 0) (vDerive 4 (fun e => P d e1 h n x1 e) 1 0)) <> 0 /\
  locally 0 (fun e => dot (direction (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e)) (direction (O_ d d2 e2 h h2 n2 x1 e) (vDerive 4 (fun e => O_ d d2 e2 h h2 n2 x1 e) 1 e)) <> 0) /\
  e1 ^ 2 <> 0 /\
  locally 0 (fun e => dot (direction (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e)) (direction (P d e1 h n x1 e) (vDerive 4 (fun e => P d e1 h n x1 e) 1 e)) <> 0).
End sec_5_1_certify.

Module sec_5_1_certify_sheets.
(* gbt-developable/sec-5.1.certify.sheets, Sect. 5.1, sentence before Theorem 2
   printed: Two families that satisfy (5.4): on which side of the generator both surfaces are.
   stated: direction(h2, d2) == gamma*direction(h, d) and foot(h2, d2) == foot(h, d) and cross(direction(h, d), JA'(0)) == -e1*normal(h) and cross(direction(h, d), JB'(0)) == -e2/gamma*normal(h) *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition P (d : list R) (dd : list R) (h : list R) (e : R) : list R :=
  vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition JA (d : list R) (dd : list R) (h : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e))) (foot (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)).
Definition O_ (d2 : list R) (dd2 : list R) (h2 : list R) (e : R) : list R :=
  vadd (vadd h2 (vscale e d2)) (vscale (e ^ 2 / 2) dd2).
Definition JB (d2 : list R) (dd2 : list R) (gamma : R) (h2 : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale (x1 / gamma) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e))) (foot (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)).
Definition e1 (d : list R) (dd : list R) (h : list R) (x1 : R) : R :=
  entry dd 4 - dot (normal dd) (JA d dd h x1 0).
Definition e2 (d : list R) (dd : list R) (dd2 : list R) (h : list R) (x1 : R) : R :=
  entry dd2 4 - dot (normal dd2) (JA d dd h x1 0).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma ->
  h2 = h ->
  d2 = vscale gamma d ->
  dot (direction h2 d2) (direction h2 d2) <> 0 ->
  dot (direction h d) (direction h d) <> 0 ->
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) ->
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 ->
  gamma <> 0 ->
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  direction h2 d2 = vscale gamma (direction h d) /\ foot h2 d2 = foot h d /\ cross (direction h d) (vDerive 3 (fun e => JA d dd h x1 e) 1 0) = vscale (- e1 d dd h x1) (normal h) /\ cross (direction h d) (vDerive 3 (fun e => JB d2 dd2 gamma h2 x1 e) 1 0) = vscale (- e2 d dd dd2 h x1 / gamma) (normal h).
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma /\
  h2 = h /\
  d2 = vscale gamma d /\
  dot (direction h2 d2) (direction h2 d2) <> 0 /\
  dot (direction h d) (direction h d) <> 0 /\
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) /\
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 /\
  gamma <> 0 /\
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0.
End sec_5_1_certify_sheets.

Module sec_5_1_certify_cusp.
(* gbt-developable/sec-5.1.certify.cusp, Sect. 5.1, sentence before Theorem 2
   printed: Two families that satisfy (5.4) and (5.5), whose surfaces fold back at the joint.
   stated: F2(0) == F1(1) and F2'(0) == F1'(1) and profile1(1) == profile2(0) and cross(profile1'(1), profile2'(0)) == 0 and dot(profile1'(1), profile2'(0)) < 0 *)
Definition F2 (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x 1 1 0%Z 3%Z) [0; 20; 10; 400]) (vscale (g x 1 1 1%Z 3%Z) [0; 30; 0; 400])) (vscale (g x 1 1 2%Z 3%Z) [0; 50; 0; 400])) (vscale (g x 1 1 3%Z 3%Z) [0; 60; - 20; 400]).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition profile1 (x : R) : list R :=
  foot (F1 x) (vDerive 4 (fun x => F1 x) 1 x).
Definition profile2 (x : R) : list R :=
  foot (F2 x) (vDerive 4 (fun x => F2 x) 1 x).
Definition statement : Prop :=
  dot (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) <> 0 ->
  dot (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) <> 0 ->
  locally 1 (fun x => dot (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) <> 0) ->
  locally 0 (fun x => dot (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) <> 0) ->
  F2 0 = F1 1 /\ vDerive 4 (fun x => F2 x) 1 0 = vDerive 4 (fun x => F1 x) 1 1 /\ profile1 1 = profile2 0 /\ cross (vDerive 3 (fun x => profile1 x) 1 1) (vDerive 3 (fun x => profile2 x) 1 0) = zeros 3 /\ dot (vDerive 3 (fun x => profile1 x) 1 1) (vDerive 3 (fun x => profile2 x) 1 0) < 0.
Definition instance : Prop :=
  dot (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) <> 0 /\
  dot (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) <> 0 /\
  locally 1 (fun x => dot (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) <> 0) /\
  locally 0 (fun x => dot (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) <> 0).
End sec_5_1_certify_cusp.

Module thm_2_inflection.
(* gbt-developable/thm-2.inflection, Sect. 5.1, Theorem 2
   printed: Two families with γ = −1, whose surfaces have a smooth joint.
   stated: F2(0) == F1(1) and F2'(0) == -F1'(1) and profile1(1) == profile2(0) and profile1'(1) == profile2'(0) and dot(profile1'(1), profile2'(0)) > 0 *)
Definition F2 (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x 1 1 0%Z 3%Z) [0; 20; 10; 400]) (vscale (g x 1 1 1%Z 3%Z) [0; 10; 20; 400])) (vscale (g x 1 1 2%Z 3%Z) [0; 10; 40; 400])) (vscale (g x 1 1 3%Z 3%Z) [0; 0; 30; 400]).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition profile1 (x : R) : list R :=
  foot (F1 x) (vDerive 4 (fun x => F1 x) 1 x).
Definition profile2 (x : R) : list R :=
  foot (F2 x) (vDerive 4 (fun x => F2 x) 1 x).
Definition statement : Prop :=
  dot (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) <> 0 ->
  dot (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) <> 0 ->
  locally 1 (fun x => dot (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) <> 0) ->
  locally 0 (fun x => dot (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) <> 0) ->
  F2 0 = F1 1 /\ vDerive 4 (fun x => F2 x) 1 0 = vopp (vDerive 4 (fun x => F1 x) 1 1) /\ profile1 1 = profile2 0 /\ vDerive 3 (fun x => profile1 x) 1 1 = vDerive 3 (fun x => profile2 x) 1 0 /\ dot (vDerive 3 (fun x => profile1 x) 1 1) (vDerive 3 (fun x => profile2 x) 1 0) > 0.
Definition instance : Prop :=
  dot (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) (direction (F1 1) (vDerive 4 (fun x => F1 x) 1 1)) <> 0 /\
  dot (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) (direction (F2 0) (vDerive 4 (fun x => F2 x) 1 0)) <> 0 /\
  locally 1 (fun x => dot (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) (direction (F1 x) (vDerive 4 (fun x => F1 x) 1 x)) <> 0) /\
  locally 0 (fun x => dot (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) (direction (F2 x) (vDerive 4 (fun x => F2 x) 1 x)) <> 0).
End thm_2_inflection.

Module sec_5_1_G0_families.
(* gbt-developable/sec-5.1.G0.families, Sect. 5.1, proof of Theorem 2, first sentence, eq. (5.6)
   printed: it is compulsory that H_1(x, μ_1, ν_1) and H_2(x, μ_2, ν_2) reach G0 continuity at the common first, which implies Q_{0,2} = Q_{k,1}
   read as: G0 continuity of the families as curves of four coordinates: equal ends.
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
End sec_5_1_G0_families.

Module sec_5_1_G0_surfaces.
(* gbt-developable/sec-5.1.G0.surfaces, Sect. 5.1, proof of Theorem 2, first sentence, eq. (5.6)
   printed: it is compulsory that H_1(x, μ_1, ν_1) and H_2(x, μ_2, ν_2) reach G0 continuity at the common first, which implies Q_{0,2} = Q_{k,1}
   read as: G0 continuity of the surfaces: they contain the same generator. h and d are the end plane and the derivative of the first, h2 and d2 those of the second.
   stated: h2 == h *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (r : R) (s : R) (u : R) (v : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < r ->
  dot (direction h d) (direction h d) > 0 ->
  r * v - s * u > 0 ->
  h2 = vadd (vscale r h) (vscale s d) ->
  d2 = vadd (vscale u h) (vscale v d) ->
  h2 = h.
End sec_5_1_G0_surfaces.

Module thm_2_a.
(* gbt-developable/thm-2.a, Sect. 5.1, Theorem 2, eq. (5.5), first line; also eq. (5.6)
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
End thm_2_a.

Module thm_2_b.
(* gbt-developable/thm-2.b, Sect. 5.1, Theorem 2, eq. (5.5), second line
   printed: Q_{1,2} = Q_{k,1} + γ (k − 2 + π/2 (1 + ν_1))/(l − 2 + π/2 (1 + μ_2)) (Q_{k,1} − Q_{k−1,1})
   stated: P2[1] == P1[k] + gamma*(k - 2 + pi/2*(1 + nu1))/(l - 2 + pi/2*(1 + mu2))*(P1[k] - P1[k-1]) *)
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
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z).
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
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End thm_2_b.

Module eq_5_7_requirement.
(* gbt-developable/eq-5.7.requirement, Sect. 5.1, proof of Theorem 2, eq. (5.7)
   printed: want to share a common tangent plane at connection, that is to say, H'_2(0, μ_2, ν_2) = γ H'_1(1, μ_1, ν_1)
   read as: The requirements (5.6) and (5.7) together: the surfaces have the tangent plane and the generator in common.
   stated: midpoint(h2) == midpoint(h) and foot(h2, d2) == foot(h, d) and cross(direction(h2, d2), direction(h, d)) == 0 *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma ->
  h2 = h ->
  d2 = vscale gamma d ->
  dot (normal h2) (normal h2) <> 0 ->
  dot (normal h) (normal h) <> 0 ->
  dot (direction h2 d2) (direction h2 d2) <> 0 ->
  dot (direction h d) (direction h d) <> 0 ->
  entry d 1 ^ 2 * entry h2 2 ^ 2 + entry d 1 ^ 2 * entry h2 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h2 1 * entry h2 2 - 2 * entry d 1 * entry d 3 * entry h2 1 * entry h2 3 + entry d 2 ^ 2 * entry h2 1 ^ 2 + entry d 2 ^ 2 * entry h2 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h2 2 * entry h2 3 + entry d 3 ^ 2 * entry h2 1 ^ 2 + entry d 3 ^ 2 * entry h2 2 ^ 2 <> 0 ->
  entry h2 1 ^ 2 + entry h2 2 ^ 2 + entry h2 3 ^ 2 <> 0 ->
  midpoint h2 = midpoint h /\ foot h2 d2 = foot h d /\ cross (direction h2 d2) (direction h d) = zeros 3.
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma /\
  h2 = h /\
  d2 = vscale gamma d /\
  dot (normal h2) (normal h2) <> 0 /\
  dot (normal h) (normal h) <> 0 /\
  dot (direction h2 d2) (direction h2 d2) <> 0 /\
  dot (direction h d) (direction h d) <> 0 /\
  entry d 1 ^ 2 * entry h2 2 ^ 2 + entry d 1 ^ 2 * entry h2 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h2 1 * entry h2 2 - 2 * entry d 1 * entry d 3 * entry h2 1 * entry h2 3 + entry d 2 ^ 2 * entry h2 1 ^ 2 + entry d 2 ^ 2 * entry h2 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h2 2 * entry h2 3 + entry d 3 ^ 2 * entry h2 1 ^ 2 + entry d 3 ^ 2 * entry h2 2 ^ 2 <> 0 /\
  entry h2 1 ^ 2 + entry h2 2 ^ 2 + entry h2 3 ^ 2 <> 0.
End eq_5_7_requirement.

Module eq_5_7_equivalence.
(* gbt-developable/eq-5.7.equivalence, Sect. 5.1, proof of Theorem 2, eq. (5.7)
   printed: want to share a common tangent plane at connection, that is to say, H'_2(0, μ_2, ν_2) = γ H'_1(1, μ_1, ν_1)
   read as: A common tangent plane, H_2(0) = H_1(1), is the same as (5.7).
   stated: d2 == gamma*d *)
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma ->
  h2 = h ->
  d2 = vscale gamma d.
End eq_5_7_equivalence.

Module eq_5_8_a.
(* gbt-developable/eq-5.8.a, Sect. 5.1, eq. (5.8), first line
   printed: H'_1(1, μ_1, ν_1) = (k − 2 + π/2 (1 + ν_1)) (Q_{k,1} − Q_{k−1,1})
   stated: H1'(1) == (k - 2 + pi/2*(1 + nu1))*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (P1 : Z -> R) (mu1 : R) (nu1 : R),
  (2 <= k)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 = (IZR k - 2 + PI / 2 * (1 + nu1)) * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (P1 : Z -> R) (mu1 : R) (nu1 : R),
  (2 <= k)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z.
End eq_5_8_a.

Module eq_5_8_b.
(* gbt-developable/eq-5.8.b, Sect. 5.1, eq. (5.8), second line
   printed: H'_2(0, μ_2, ν_2) = (l − 2 + π/2 (1 + μ_2)) (Q_{1,2} − Q_{0,2})
   stated: H2'(0) == (l - 2 + pi/2*(1 + mu2))*(P2[1] - P2[0]) *)
Definition statement : Prop :=
forall (l : Z) (P2 : Z -> R) (mu2 : R) (nu2 : R),
  (2 <= l)%Z ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= 1 <= l)%Z ->
  (0 <= 0 <= l)%Z ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = (IZR l - 2 + PI / 2 * (1 + mu2)) * (P2 1%Z - P2 0%Z).
Definition instance : Prop :=
exists (l : Z) (P2 : Z -> R) (mu2 : R) (nu2 : R),
  (2 <= l)%Z /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= 1 <= l)%Z /\
  (0 <= 0 <= l)%Z.
End eq_5_8_b.

Module eq_5_9.
(* gbt-developable/eq-5.9, Sect. 5.1, eq. (5.9)
   printed: γ (k − 2 + π/2 (1 + ν_1)) (Q_{k,1} − Q_{k−1,1}) = (l − 2 + π/2 (1 + μ_2)) (Q_{1,2} − Q_{0,2})
   stated: gamma*H1'(1) - H2'(0) == gamma*(k - 2 + pi/2*(1 + nu1))*(P1[k] - P1[k-1]) - (l - 2 + pi/2*(1 + mu2))*(P2[1] - P2[0]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  (0 <= 0 <= l)%Z ->
  gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 - Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) - (IZR l - 2 + PI / 2 * (1 + mu2)) * (P2 1%Z - P2 0%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  (0 <= 0 <= l)%Z.
End eq_5_9.

Module eq_5_10.
(* gbt-developable/eq-5.10, Sect. 5.1, eq. (5.10)
   printed: Q_{1,2} = Q_{k,1} + γ (k − 2 + π/2 (1 + ν_1))/(l − 2 + π/2 (1 + μ_2)) (Q_{k,1} − Q_{k−1,1})
   stated: P2[1] == P1[k] + gamma*(k - 2 + pi/2*(1 + nu1))/(l - 2 + pi/2*(1 + mu2))*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu2 : R) (nu1 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) = (IZR l - 2 + PI / 2 * (1 + mu2)) * (P2 1%Z - P2 0%Z) ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu2 : R) (nu1 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) * (P1 k - P1 (k - 1)%Z) = (IZR l - 2 + PI / 2 * (1 + mu2)) * (P2 1%Z - P2 0%Z) /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End eq_5_10.

Module thm_2_sufficient.
(* gbt-developable/thm-2.sufficient, Sect. 5.1, Theorem 2, the word 'adequate'
   printed: Adequate ... requirements for G1 smooth connection among two contiguous developable GBT-Bézier surfaces ... are (5.5)
   read as: (5.5) makes the end planes equal and the derivatives proportional, and the common generator is the line of Q_{k-1,1} and Q_{k,1}. With h, d, dd for H_1(1), H'_1(1), H''_1(1) and h2, d2, dd2 for H_2(0), H'_2(0), H''_2(0) the rulings JA and JB of both surfaces are the same there, and the second sheet continues the first.
   stated: H2(0) == H1(1) and H2'(0) == gamma*H1'(1) and P1[k-1] == H2(0) - H2'(0)/(gamma*(k - 2 + pi/2*(1 + nu1))) and JB(0) == JA(0) and cross(direction(h, d), JB'(0)) == e2/(gamma*e1)*cross(direction(h, d), JA'(0)) *)
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
Definition O_ (d2 : list R) (dd2 : list R) (h2 : list R) (e : R) : list R :=
  vadd (vadd h2 (vscale e d2)) (vscale (e ^ 2 / 2) dd2).
Definition JB (d2 : list R) (dd2 : list R) (gamma : R) (h2 : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale (x1 / gamma) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e))) (foot (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 ->
  e1 d dd h x1 * e2 d dd dd2 h x1 > 0 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) ->
  h2 = h ->
  d2 = vscale gamma d ->
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) <> 0 ->
  gamma <> 0 ->
  dot (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) <> 0 ->
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) ->
  gamma * e1 d dd h x1 <> 0 ->
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) ->
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ P1 (k - 1)%Z = H2 P2 l mu2 nu2 0 - Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 / (gamma * (IZR k - 2 + PI / 2 * (1 + nu1))) /\ JB d2 dd2 gamma h2 x1 0 = JA d dd h x1 0 /\ cross (direction h d) (vDerive 3 (fun e => JB d2 dd2 gamma h2 x1 e) 1 0) = vscale (e2 d dd dd2 h x1 / (gamma * e1 d dd h x1)) (cross (direction h d) (vDerive 3 (fun e => JA d dd h x1 e) 1 0)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (gamma : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 /\
  e1 d dd h x1 * e2 d dd dd2 h x1 > 0 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) /\
  h2 = h /\
  d2 = vscale gamma d /\
  gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) <> 0 /\
  gamma <> 0 /\
  dot (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) <> 0 /\
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) /\
  gamma * e1 d dd h x1 <> 0 /\
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) /\
  2 * (IZR k - 2) + PI * (1 + nu1) <> 0 /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End thm_2_sufficient.

Module thm_2_necessary_families.
(* gbt-developable/thm-2.necessary.families, Sect. 5.1, Theorem 2, the word 'essential'
   printed: ... essential requirements for G1 smooth connection among two contiguous developable GBT-Bézier surfaces ... are (5.5)
   read as: G1 smooth connection is (5.4) for the families, as the proof takes it.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + gamma*(k - 2 + pi/2*(1 + nu1))/(l - 2 + pi/2*(1 + mu2))*(P1[k] - P1[k-1]) *)
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
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z).
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
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End thm_2_necessary_families.

Module thm_2_necessary_surfaces.
(* gbt-developable/thm-2.necessary.surfaces, Sect. 5.1, Theorem 2, the word 'essential'
   printed: ... essential requirements for G1 smooth connection among two contiguous developable GBT-Bézier surfaces ... are (5.5)
   read as: G1 smooth connection is what it is for surfaces: same generator, same tangent plane along it.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + gamma*(k - 2 + pi/2*(1 + nu1))/(l - 2 + pi/2*(1 + mu2))*(P1[k] - P1[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  1 <= rho <= 2 ->
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z).
End thm_2_necessary_surfaces.

Module thm_2_true_necessary.
(* gbt-developable/thm-2.true.necessary, Sect. 5.1, Theorem 2
   printed: Two surfaces with the same end generator and the same tangent plane along it: what this asks of the control planes, with the constants ρ, γ and s.
   stated: P2[0] == rho*P1[k] and P2[1] == rho*P1[k] + rho*gamma*c*(P1[k] - P1[k-1]) + s/kappa2*P1[k] *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  kappa2 l mu2 <> 0 ->
  P2 0%Z = rho * P1 k /\ P2 1%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  kappa2 l mu2 <> 0.
End thm_2_true_necessary.

Module thm_2_true_sufficient.
(* gbt-developable/thm-2.true.sufficient, Sect. 5.1, Theorem 2
   printed: Control planes with constants ρ, γ and s: the surfaces have the same end generator and the same tangent plane along it.
   stated: H2(0) == rho*H1(1) and H2'(0) == rho*gamma*H1'(1) + s*H1(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R),
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
  H2 P2 l mu2 nu2 0 = rho * H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = rho * gamma * Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 + s * H1 P1 k mu1 nu1 1.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (rho : R) (s : R),
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
  P2 1%Z = rho * P1 k + rho * gamma * c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + s / kappa2 l mu2 * P1 k.
End thm_2_true_sufficient.

Module thm_2_true_generator.
(* gbt-developable/thm-2.true.generator, Sect. 5.1, Theorem 2
   printed: A plane through the generator of two planes is a combination of them.
   stated: n == alpha*normal(d) + omega*normal(h) + dot(n, direction(h, d))/dot(direction(h, d), direction(h, d))*direction(h, d) and d2[4] == alpha*d[4] + omega*h[4] + (d2[4] - dot(n, foot(h, d))) *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition hh (h : list R) : R :=
  dot (normal h) (normal h).
Definition d0 (d : list R) : R :=
  dot (normal d) (normal d).
Definition hd (d : list R) (h : list R) : R :=
  dot (normal h) (normal d).
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition n (d2 : list R) : list R :=
  normal d2.
Definition alpha (d : list R) (d2 : list R) (h : list R) : R :=
  (dot (n d2) (normal d) * hh h - dot (n d2) (normal h) * hd d h) / (hh h * d0 d - hd d h ^ 2).
Definition omega (d : list R) (d2 : list R) (h : list R) : R :=
  (dot (n d2) (normal h) * d0 d - dot (n d2) (normal d) * hd d h) / (hh h * d0 d - hd d h ^ 2).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition statement : Prop :=
forall (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (h'1 h'2 h'3 h'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  hh h * d0 d - hd d h ^ 2 <> 0 ->
  dot (direction h d) (direction h d) <> 0 ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  n d2 = vadd (vadd (vscale (alpha d d2 h) (normal d)) (vscale (omega d d2 h) (normal h))) (vscale (dot (n d2) (direction h d) / dot (direction h d) (direction h d)) (direction h d)) /\ entry d2 4 = alpha d d2 h * entry d 4 + omega d d2 h * entry h 4 + (entry d2 4 - dot (n d2) (foot h d)).
Definition instance : Prop :=
exists (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (h'1 h'2 h'3 h'4 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  hh h * d0 d - hd d h ^ 2 <> 0 /\
  dot (direction h d) (direction h d) <> 0 /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0.
End thm_2_true_generator.

Module thm_2_true_sheets.
(* gbt-developable/thm-2.true.sheets, Sect. 5.1, Theorem 2
   printed: Two surfaces with the same end generator and the same tangent plane along it: the condition that excludes a cusp.
   stated: JB(0) == JA(0) and cross(direction(h, d), JA'(0)) == -e1*normal(h) and cross(direction(h, d), JB'(0)) == -e2/alpha*normal(h) *)
Definition O_ (d2 : list R) (dd2 : list R) (h2 : list R) (e : R) : list R :=
  vadd (vadd h2 (vscale e d2)) (vscale (e ^ 2 / 2) dd2).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition P (d : list R) (dd : list R) (h : list R) (e : R) : list R :=
  vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition JA (d : list R) (dd : list R) (h : list R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e))) (foot (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)).
Definition JB (alpha : R) (d2 : list R) (dd2 : list R) (h2 : list R) (rho : R) (x1 : R) (e : R) : list R :=
  vadd (vscale (x1 / (rho * alpha)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e))) (foot (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)).
Definition e1 (d : list R) (dd : list R) (h : list R) (x1 : R) : R :=
  entry dd 4 - dot (normal dd) (JA d dd h x1 0).
Definition e2 (d : list R) (dd : list R) (dd2 : list R) (h : list R) (x1 : R) : R :=
  entry dd2 4 - dot (normal dd2) (JA d dd h x1 0).
Definition statement : Prop :=
forall (alpha : R) (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (rho : R) (s : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = vscale rho h ->
  d2 = vadd (vscale alpha d) (vscale s h) ->
  rho * alpha <> 0 ->
  dot (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) <> 0 ->
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 ->
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) ->
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) ->
  alpha <> 0 ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  rho <> 0 ->
  JB alpha d2 dd2 h2 rho x1 0 = JA d dd h x1 0 /\ cross (direction h d) (vDerive 3 (fun e => JA d dd h x1 e) 1 0) = vscale (- e1 d dd h x1) (normal h) /\ cross (direction h d) (vDerive 3 (fun e => JB alpha d2 dd2 h2 rho x1 e) 1 0) = vscale (- e2 d dd dd2 h x1 / alpha) (normal h).
Definition instance : Prop :=
exists (alpha : R) (d'1 d'2 d'3 d'4 : R) (d2'1 d2'2 d2'3 d2'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (dd2'1 dd2'2 dd2'3 dd2'4 : R) (h'1 h'2 h'3 h'4 : R) (h2'1 h2'2 h2'3 h2'4 : R) (rho : R) (s : R) (x1 : R),
  let d := [d'1; d'2; d'3; d'4] in
  let d2 := [d2'1; d2'2; d2'3; d2'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let dd2 := [dd2'1; dd2'2; dd2'3; dd2'4] in
  let h := [h'1; h'2; h'3; h'4] in
  let h2 := [h2'1; h2'2; h2'3; h2'4] in
  h2 = vscale rho h /\
  d2 = vadd (vscale alpha d) (vscale s h) /\
  rho * alpha <> 0 /\
  dot (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) (direction (O_ d2 dd2 h2 0) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 0)) <> 0 /\
  dot (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun e => P d dd h e) 1 0)) <> 0 /\
  locally 0 (fun e => dot (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) (direction (P d dd h e) (vDerive 4 (fun e => P d dd h e) 1 e)) <> 0) /\
  locally 0 (fun e => dot (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) (direction (O_ d2 dd2 h2 e) (vDerive 4 (fun e => O_ d2 dd2 h2 e) 1 e)) <> 0) /\
  alpha <> 0 /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 /\
  rho <> 0.
End thm_2_true_sheets.
