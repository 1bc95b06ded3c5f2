(* Statements of gbt-developable, Section 5. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition hat (U : Z -> list R) (k : Z) (mu : R) (nu : R) (w : Z -> R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) [w i * entry (U i) 1; w i * entry (U i) 2; w i * entry (U i) 3; w i]).
End Definitions.
Import Definitions.

Module eq_5_1.
(* gbt-developable/eq-5.1, Sect. 5, eq. (5.1) and the line after it
   printed: Ĝ(x, μ, ν) = Σ_{i=0}^{k} g_{i,k}(x, μ, ν) R̂_i, 0 ≤ x ≤ 1, where g_{i,k}(z, μ, ν) (i = 0, 1, ..., k) are kth order GBTB basis functions; R̂_i = (ω_i R_i, ω_i)
   read as: g(z) only names the functions, with another letter for the variable. Stated: the first three coordinates of the curve in four are those of the weighted points, the last one is the sum of the weights.
   stated: [hat(x)[1], hat(x)[2], hat(x)[3]] == sum(i, 0, k, g[i,k](x)*w[i]*U[i]) and hat(x)[4] == sum(i, 0, k, g[i,k](x)*w[i]) *)
Definition statement : Prop :=
forall (k : Z) (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (w : Z -> R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  [entry (hat U k mu nu w x) 1; entry (hat U k mu nu w x) 2; entry (hat U k mu nu w x) 3] = vsum 3 0%Z k (fun i => vscale (g x mu nu i k * w i) (U i)) /\ entry (hat U k mu nu w x) 4 = sum 0%Z k (fun i => g x mu nu i k * w i).
Definition instance : Prop :=
exists (k : Z) (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (w : Z -> R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_5_1.

Module sec_5_weighted_a.
(* gbt-developable/sec-5.weighted.a, Sect. 5, paragraph after (5.1), for the interpolation of the end points
   printed: It is understood that the weighted GBT-Bézier curve share the basic features with GBT-Bézier curves.
   read as: 'weighted curve' read as the curve obtained from (5.1) by dividing by the last homogeneous coordinate. Here the feature that its end points are the first and the last control point, for every degree: U_i are the weighted points ω_i R_i, w_i the weights.
   stated: rational(0) == R[0] and rational(1) == R[k] *)
Definition rational (U : Z -> R) (k : Z) (mu : R) (nu : R) (w : Z -> R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * U i) / sum 0%Z k (fun i => g x mu nu i k * w i).
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (U : Z -> R) (mu : R) (nu : R) (w : Z -> R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  U 0%Z = w 0%Z * R_ 0%Z ->
  (0 <= k <= k)%Z ->
  U k = w k * R_ k ->
  sum 0%Z k (fun i => g 0 mu nu i k * w i) <> 0 ->
  sum 0%Z k (fun i => g 1 mu nu i k * w i) <> 0 ->
  w 0%Z <> 0 ->
  w k <> 0 ->
  rational U k mu nu w 0 = R_ 0%Z /\ rational U k mu nu w 1 = R_ k.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (U : Z -> R) (mu : R) (nu : R) (w : Z -> R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  U 0%Z = w 0%Z * R_ 0%Z /\
  (0 <= k <= k)%Z /\
  U k = w k * R_ k /\
  sum 0%Z k (fun i => g 0 mu nu i k * w i) <> 0 /\
  sum 0%Z k (fun i => g 1 mu nu i k * w i) <> 0 /\
  w 0%Z <> 0 /\
  w k <> 0.
End sec_5_weighted_a.

Module sec_5_weighted_b_four_coordinates.
(* gbt-developable/sec-5.weighted.b.four coordinates, Sect. 5, paragraph after (5.1), for the linearity in the shape parameters
   printed: It is understood that the weighted GBT-Bézier curve share the basic features with GBT-Bézier curves.
   read as: The weighted curve is (5.1), with the points R̂_i of four coordinates, for every degree.
   stated: D(hat(x), mu, 2) == 0 and D(hat(x), nu, 2) == 0 *)
Definition statement : Prop :=
forall (k : Z) (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (w : Z -> R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  vDerive 4 (fun mu => hat U k mu nu w x) 2 mu = zeros 4 /\ vDerive 4 (fun nu => hat U k mu nu w x) 2 nu = zeros 4.
Definition instance : Prop :=
exists (k : Z) (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (w : Z -> R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_5_weighted_b_four_coordinates.

Module sec_5_weighted_b_after_division.
(* gbt-developable/sec-5.weighted.b.after division, Sect. 5, paragraph after (5.1), for the linearity in the shape parameters
   printed: It is understood that the weighted GBT-Bézier curve share the basic features with GBT-Bézier curves.
   read as: The weighted curve is obtained from (5.1) by dividing by the last homogeneous coordinate, for positive weights ω_i; degree 2 and weights from 1 to 2 are enough to refute.
   stated: D(rational(x), mu, 2) == 0 *)
Definition rational (R_ : Z -> R) (mu : R) (nu : R) (w0 : R) (w1 : R) (w2 : R) (x : R) : R :=
  (g x mu nu 0%Z 2%Z * w0 * R_ 0%Z + g x mu nu 1%Z 2%Z * w1 * R_ 1%Z + g x mu nu 2%Z 2%Z * w2 * R_ 2%Z) / (g x mu nu 0%Z 2%Z * w0 + g x mu nu 1%Z 2%Z * w1 + g x mu nu 2%Z 2%Z * w2).
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (w0 : R) (w1 : R) (w2 : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  1 <= w0 <= 2 ->
  1 <= w1 <= 2 ->
  1 <= w2 <= 2 ->
  0 <= x <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  locally mu (fun mu => g x mu nu 0%Z 2%Z * w0 + g x mu nu 1%Z 2%Z * w1 + g x mu nu 2%Z 2%Z * w2 <> 0) ->
  Derive_n (fun mu => rational R_ mu nu w0 w1 w2 x) 2 mu = 0.
End sec_5_weighted_b_after_division.

Module eq_5_2.
(* gbt-developable/eq-5.2, Sect. 5, eq. (5.2)
   printed: {Π_{x,1}}: H_1(x; μ_1, ν_1) = a_{0,1}(x), a_{1,1}(x), a_{2,1}(x), a_{3,1}(x);  {Π_{x,2}}: H_2(x; μ_2, ν_2) = a_{0,2}(x), a_{1,2}(x), a_{2,2}(x), a_{3,2}(x), 0 ≤ x ≤ 1
   read as: The coordinates are those of (3.3) for the control planes Q_{i,1} (i = 0, ..., k) and Q_{j,2} (j = 0, ..., l), compared with the vector sums that all statements on joins use.
   stated: H1(x) == [sum(i, 0, k, g[i,k](x, mu1, nu1)*P1[i][1]), sum(i, 0, k, g[i,k](x, mu1, nu1)*P1[i][2]), sum(i, 0, k, g[i,k](x, mu1, nu1)*P1[i][3]), sum(i, 0, k, g[i,k](x, mu1, nu1)*P1[i][4])] and H2(x) == [sum(i, 0, l, g[i,l](x, mu2, nu2)*P2[i][1]), sum(i, 0, l, g[i,l](x, mu2, nu2)*P2[i][2]), sum(i, 0, l, g[i,l](x, mu2, nu2)*P2[i][3]), sum(i, 0, l, g[i,l](x, mu2, nu2)*P2[i][4])] *)
Definition H1 (P1 : Z -> list R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu1 nu1 i k) (P1 i)).
Definition H2 (P2 : Z -> list R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : list R :=
  vsum 4 0%Z l (fun i => vscale (g x mu2 nu2 i l) (P2 i)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1'1 P1'2 P1'3 P1'4 : Z -> R) (P2'1 P2'2 P2'3 P2'4 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x : R),
  let P1 := fun i0 => [P1'1 i0; P1'2 i0; P1'3 i0; P1'4 i0] in
  let P2 := fun i0 => [P2'1 i0; P2'2 i0; P2'3 i0; P2'4 i0] in
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  0 <= x <= 1 ->
  H1 P1 k mu1 nu1 x = [sum 0%Z k (fun i => g x mu1 nu1 i k * entry (P1 i) 1); sum 0%Z k (fun i => g x mu1 nu1 i k * entry (P1 i) 2); sum 0%Z k (fun i => g x mu1 nu1 i k * entry (P1 i) 3); sum 0%Z k (fun i => g x mu1 nu1 i k * entry (P1 i) 4)] /\ H2 P2 l mu2 nu2 x = [sum 0%Z l (fun i => g x mu2 nu2 i l * entry (P2 i) 1); sum 0%Z l (fun i => g x mu2 nu2 i l * entry (P2 i) 2); sum 0%Z l (fun i => g x mu2 nu2 i l * entry (P2 i) 3); sum 0%Z l (fun i => g x mu2 nu2 i l * entry (P2 i) 4)].
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1'1 P1'2 P1'3 P1'4 : Z -> R) (P2'1 P2'2 P2'3 P2'4 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x : R),
  let P1 := fun i0 => [P1'1 i0; P1'2 i0; P1'3 i0; P1'4 i0] in
  let P2 := fun i0 => [P2'1 i0; P2'2 i0; P2'3 i0; P2'4 i0] in
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  0 <= x <= 1.
End eq_5_2.
