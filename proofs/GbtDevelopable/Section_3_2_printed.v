(* Statements of gbt-developable, Section 3 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition HT (T : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) (T i)).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition W (X : R) (Y : R) (Z_ : R) : list R :=
  [X; Y; Z_].
Definition F (T : Z -> list R) (X : R) (Y : R) (Z_ : R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  dot (normal (HT T k mu nu x)) (W X Y Z_) - entry (HT T k mu nu x) 4.
Definition a (a0 : R) (a1 : R) (a2 : R) : list R :=
  [a0; a1; a2].
Definition a' (a0' : R) (a1' : R) (a2' : R) : list R :=
  [a0'; a1'; a2'].
Definition phi (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) : list R :=
  cross (a a0 a1 a2) (a' a0' a1' a2').
Definition theta (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) : list R :=
  vsub (vscale a3' (a a0 a1 a2)) (vscale a3 (a' a0' a1' a2')).
Definition psi (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) : list R :=
  vdiv (cross (phi a0 a0' a1 a1' a2 a2') (theta a0 a0' a1 a1' a2 a2' a3 a3')) (dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2')).
End Definitions.
Import Definitions.

Module eq_3_5.
(* gbt-developable/eq-3.5, Sect. 3.2, eq. (3.5)
   printed: a0(x) X + a1(x) Y + a2(x) Z = a3(x)
   read as: The difference of both sides is compared with the function F whose derivatives are the equations after it.
   stated: F(x) == HT(x)[1]*X + HT(x)[2]*Y + HT(x)[3]*Z - HT(x)[4] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  F T X Y Z_ k mu nu x = entry (HT T k mu nu x) 1 * X + entry (HT T k mu nu x) 2 * Y + entry (HT T k mu nu x) 3 * Z_ - entry (HT T k mu nu x) 4.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_5.

Module eq_3_6.
(* gbt-developable/eq-3.6, Sect. 3.2, eq. (3.6)
   printed: a'_0(x) X + a'_1(x) Y + a'_2(x) Z = a'_3(x)
   stated: F'(x) == HT'(x)[1]*X + HT'(x)[2]*Y + HT'(x)[3]*Z - HT'(x)[4] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun x => F T X Y Z_ k mu nu x) 1 x = entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 1 * X + entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 2 * Y + entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 3 * Z_ - entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 4.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_6.

Module sec_3_2_phi.
(* gbt-developable/sec-3.2.phi, Sect. 3.2, display after (3.6), second line
   printed: φ = a(x) × a'(x)
   stated: dot(phi, a) == 0 and dot(phi, a') == 0 *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R),
  dot (phi a0 a0' a1 a1' a2 a2') (a a0 a1 a2) = 0 /\ dot (phi a0 a0' a1 a1' a2 a2') (a' a0' a1' a2') = 0.
End sec_3_2_phi.

Module sec_3_2_theta.
(* gbt-developable/sec-3.2.theta, Sect. 3.2, display after (3.6), first and third line
   printed: J(x; μ, ν) = (φ, θ),  θ = a'_3(x) a(x) − a3(x) a'(x)
   stated: cross(W, phi) == theta *)
Definition statement : Prop :=
forall (X : R) (Y : R) (Z_ : R) (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  a3 = dot (a a0 a1 a2) (W X Y Z_) ->
  a3' = dot (a' a0' a1' a2') (W X Y Z_) ->
  cross (W X Y Z_) (phi a0 a0' a1 a1' a2 a2') = theta a0 a0' a1 a1' a2 a2' a3 a3'.
Definition instance : Prop :=
exists (X : R) (Y : R) (Z_ : R) (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  a3 = dot (a a0 a1 a2) (W X Y Z_) /\
  a3' = dot (a' a0' a1' a2') (W X Y Z_).
End sec_3_2_theta.

Module sec_3_2_phi_exp.
(* gbt-developable/sec-3.2.phi-exp, Sect. 3.2, expanded φ
   printed: φ = {a1 a'_2 − a2 a'_1, a2 a'_0 − a0 a'_2, a0 a'_1 − a1 a'_0}
   stated: phi == [a1*a2' - a2*a1', a2*a0' - a0*a2', a0*a1' - a1*a0'] *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R),
  phi a0 a0' a1 a1' a2 a2' = [a1 * a2' - a2 * a1'; a2 * a0' - a0 * a2'; a0 * a1' - a1 * a0'].
End sec_3_2_phi_exp.

Module sec_3_2_psi_vec.
(* gbt-developable/sec-3.2.psi-vec, Sect. 3.2, first formula for ψ
   printed: ψ(x) = (φ × θ) / (φ . φ)
   read as: ψ is a point of both planes, (3.5) and (3.6).
   stated: dot(a, psi) == a3 and dot(a', psi) == a3' *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 ->
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0 ->
  dot (a a0 a1 a2) (psi a0 a0' a1 a1' a2 a2' a3 a3') = a3 /\ dot (a' a0' a1' a2') (psi a0 a0' a1 a1' a2 a2' a3 a3') = a3'.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 /\
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0.
End sec_3_2_psi_vec.

Module sec_3_2_psi_nearest.
(* gbt-developable/sec-3.2.psi-nearest, Sect. 3.2, sentence before ψ
   printed: Let ψ(x) indicate the nearest point on the generator J(x; μ, ν) to the origin
   stated: dot(a, psi) == a3 and dot(a', psi) == a3' and dot(psi + s*phi, psi + s*phi) - dot(psi, psi) == s^2*dot(phi, phi) *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) (s : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 ->
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0 ->
  dot (a a0 a1 a2) (psi a0 a0' a1 a1' a2 a2' a3 a3') = a3 /\ dot (a' a0' a1' a2') (psi a0 a0' a1 a1' a2 a2' a3 a3') = a3' /\ dot (vadd (psi a0 a0' a1 a1' a2 a2' a3 a3') (vscale s (phi a0 a0' a1 a1' a2 a2'))) (vadd (psi a0 a0' a1 a1' a2 a2' a3 a3') (vscale s (phi a0 a0' a1 a1' a2 a2'))) - dot (psi a0 a0' a1 a1' a2 a2' a3 a3') (psi a0 a0' a1 a1' a2 a2' a3 a3') = s ^ 2 * dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2').
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) (s : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 /\
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0.
End sec_3_2_psi_nearest.

Module sec_3_2_psi_x.
(* gbt-developable/sec-3.2.psi-x, Sect. 3.2, expanded ψ, numerator, first component
   printed: [a2 a'_0 − a0 a'_2][a2 a'_3 − a3 a'_2] − [a0 a'_1 − a1 a'_0][a1 a'_3 − a3 a'_1]
   stated: cross(phi, theta)[1] == (a2*a0' - a0*a2')*(a2*a3' - a3*a2') - (a0*a1' - a1*a0')*(a1*a3' - a3*a1') *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  entry (cross (phi a0 a0' a1 a1' a2 a2') (theta a0 a0' a1 a1' a2 a2' a3 a3')) 1 = (a2 * a0' - a0 * a2') * (a2 * a3' - a3 * a2') - (a0 * a1' - a1 * a0') * (a1 * a3' - a3 * a1').
End sec_3_2_psi_x.

Module sec_3_2_psi_y.
(* gbt-developable/sec-3.2.psi-y, Sect. 3.2, expanded ψ, numerator, second component
   printed: [a0 a'_1 − a1 a'_0][a0 a'_3 − a3 a'_0] − [a1 a'_2 − a2 a'_1][a2 a'_3 − a3 a'_2]
   stated: cross(phi, theta)[2] == (a0*a1' - a1*a0')*(a0*a3' - a3*a0') - (a1*a2' - a2*a1')*(a2*a3' - a3*a2') *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  entry (cross (phi a0 a0' a1 a1' a2 a2') (theta a0 a0' a1 a1' a2 a2' a3 a3')) 2 = (a0 * a1' - a1 * a0') * (a0 * a3' - a3 * a0') - (a1 * a2' - a2 * a1') * (a2 * a3' - a3 * a2').
End sec_3_2_psi_y.

Module sec_3_2_psi_z.
(* gbt-developable/sec-3.2.psi-z, Sect. 3.2, expanded ψ, numerator, third component
   printed: [a1 a'_2 − a2 a'_1][a1 a'_3 − a3 a'_1] − [a2 a'_0 − a0 a'_2][a2 a'_0 − a0 a'_2]
   stated: cross(phi, theta)[3] == (a1*a2' - a2*a1')*(a1*a3' - a3*a1') - (a2*a0' - a0*a2')*(a2*a0' - a0*a2') *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  entry (cross (phi a0 a0' a1 a1' a2 a2') (theta a0 a0' a1 a1' a2 a2' a3 a3')) 3 = (a1 * a2' - a2 * a1') * (a1 * a3' - a3 * a1') - (a2 * a0' - a0 * a2') * (a2 * a0' - a0 * a2').
End sec_3_2_psi_z.

Module sec_3_2_psi_z_corrected.
(* gbt-developable/sec-3.2.psi-z (corrected), Sect. 3.2, expanded ψ, numerator, third component
   printed: [a1 a'_2 − a2 a'_1][a1 a'_3 − a3 a'_1] − [a2 a'_0 − a0 a'_2][a2 a'_0 − a0 a'_2]
   stated: cross(phi, theta)[3] == (a1*a2' - a2*a1')*(a1*a3' - a3*a1') - (a2*a0' - a0*a2')*(a0*a3' - a3*a0') *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R),
  entry (cross (phi a0 a0' a1 a1' a2 a2') (theta a0 a0' a1 a1' a2 a2' a3 a3')) 3 = (a1 * a2' - a2 * a1') * (a1 * a3' - a3 * a1') - (a2 * a0' - a0 * a2') * (a0 * a3' - a3 * a0').
End sec_3_2_psi_z_corrected.

Module sec_3_2_psi_den.
(* gbt-developable/sec-3.2.psi-den, Sect. 3.2, expanded ψ, denominator
   printed: [a1 a'_2 − a2 a'_1]^2 + [a2 a'_0 − a0 a'_2]^2 + [a0 a'_1 − a1 a'_0]^2
   stated: dot(phi, phi) == (a1*a2' - a2*a1')^2 + (a2*a0' - a0*a2')^2 + (a0*a1' - a1*a0')^2 *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') = (a1 * a2' - a2 * a1') ^ 2 + (a2 * a0' - a0 * a2') ^ 2 + (a0 * a1' - a1 * a0') ^ 2.
End sec_3_2_psi_den.

Module eq_3_7.
(* gbt-developable/eq-3.7, Sect. 3.2, eq. (3.7)
   printed: J(x1, x; μ, ν) = x1 φ(x) + ψ(x), μ, ν ∈ [−1, 1], x ∈ [0, 1], x1 ∈ [−∞, ∞]
   stated: dot(a, x1*phi + psi) == a3 and dot(a', x1*phi + psi) == a3' and W - (dot(W, phi)/dot(phi, phi)*phi + foot([a0, a1, a2, dot(a, W)], [a0', a1', a2', dot(a', W)])) == 0 *)
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition statement : Prop :=
forall (X : R) (Y : R) (Z_ : R) (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) (x1 : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 ->
  dot (direction [a0; a1; a2; dot (a a0 a1 a2) (W X Y Z_)] [a0'; a1'; a2'; dot (a' a0' a1' a2') (W X Y Z_)]) (direction [a0; a1; a2; dot (a a0 a1 a2) (W X Y Z_)] [a0'; a1'; a2'; dot (a' a0' a1' a2') (W X Y Z_)]) <> 0 ->
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0 ->
  dot (a a0 a1 a2) (vadd (vscale x1 (phi a0 a0' a1 a1' a2 a2')) (psi a0 a0' a1 a1' a2 a2' a3 a3')) = a3 /\ dot (a' a0' a1' a2') (vadd (vscale x1 (phi a0 a0' a1 a1' a2 a2')) (psi a0 a0' a1 a1' a2 a2' a3 a3')) = a3' /\ vsub (W X Y Z_) (vadd (vscale (dot (W X Y Z_) (phi a0 a0' a1 a1' a2 a2') / dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2')) (phi a0 a0' a1 a1' a2 a2')) (foot [a0; a1; a2; dot (a a0 a1 a2) (W X Y Z_)] [a0'; a1'; a2'; dot (a' a0' a1' a2') (W X Y Z_)])) = zeros 3.
Definition instance : Prop :=
exists (X : R) (Y : R) (Z_ : R) (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) (a3 : R) (a3' : R) (x1 : R),
  dot (phi a0 a0' a1 a1' a2 a2') (phi a0 a0' a1 a1' a2 a2') <> 0 /\
  dot (direction [a0; a1; a2; dot (a a0 a1 a2) (W X Y Z_)] [a0'; a1'; a2'; dot (a' a0' a1' a2') (W X Y Z_)]) (direction [a0; a1; a2; dot (a a0 a1 a2) (W X Y Z_)] [a0'; a1'; a2'; dot (a' a0' a1' a2') (W X Y Z_)]) <> 0 /\
  a0 ^ 2 * a1' ^ 2 + a0 ^ 2 * a2' ^ 2 - 2 * a0 * a0' * a1 * a1' - 2 * a0 * a0' * a2 * a2' + a0' ^ 2 * a1 ^ 2 + a0' ^ 2 * a2 ^ 2 + a1 ^ 2 * a2' ^ 2 - 2 * a1 * a1' * a2 * a2' + a1' ^ 2 * a2 ^ 2 <> 0.
End eq_3_7.

Module sec_3_2_envelope.
(* gbt-developable/sec-3.2.envelope, Sect. 3.2, after (3.7)
   printed: For distinct values of family parameter x in its given value range, all generators J(x; μ, ν) construct an enveloping developable GBT-Bézier surface having μ, ν as shape parameters.
   read as: (3.7) is a surface with a tangent plane, and this is the plane (3.5) along each generator, for every x1. First derivatives of (3.7) need no more than the second derivatives of the plane.
   stated: dot(a, phi) == 0 and dot(a, J'(0)) == 0 and cross(phi, J'(0))/(dot(a'', J(0)) - a3'') == a *)
Definition a'' (a0'' : R) (a1'' : R) (a2'' : R) : list R :=
  [a0''; a1''; a2''].
Definition A (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (e : R) : list R :=
  vadd (vadd (a a0 a1 a2) (vscale e (a' a0' a1' a2'))) (vscale (e ^ 2 / 2) (a'' a0'' a1'' a2'')).
Definition A3 (a3 : R) (a3' : R) (a3'' : R) (e : R) : R :=
  a3 + e * a3' + e ^ 2 / 2 * a3''.
Definition J (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R) (e : R) : list R :=
  vadd (vscale x1 (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e))) (vdiv (cross (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (vsub (vscale (Derive_n (fun e => A3 a3 a3' a3'' e) 1 e) (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e)) (vscale (A3 a3 a3' a3'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)))) (dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)))).
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R),
  dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' 0) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' 0) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0)) <> 0 ->
  a3'' <> dot (a'' a0'' a1'' a2'') (J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0) ->
  locally 0 (fun e => dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) <> 0) ->
  dot (a'' a0'' a1'' a2'') (J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0) - a3'' <> 0 ->
  dot (a a0 a1 a2) (phi a0 a0' a1 a1' a2 a2') = 0 /\ dot (a a0 a1 a2) (vDerive 3 (fun e => J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 e) 1 0) = 0 /\ vdiv (cross (phi a0 a0' a1 a1' a2 a2') (vDerive 3 (fun e => J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 e) 1 0)) (dot (a'' a0'' a1'' a2'') (J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0) - a3'') = a a0 a1 a2.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) (x1 : R),
  dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' 0) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' 0) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 0)) <> 0 /\
  a3'' <> dot (a'' a0'' a1'' a2'') (J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0) /\
  locally 0 (fun e => dot (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) (cross (A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) (vDerive 3 (fun e => A a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' e) 1 e)) <> 0) /\
  dot (a'' a0'' a1'' a2'') (J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0) - a3'' <> 0.
End sec_3_2_envelope.
