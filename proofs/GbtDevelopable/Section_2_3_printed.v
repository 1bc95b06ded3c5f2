(* Statements of gbt-developable, Section 2 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition G (R_ : Z -> R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * R_ i).
End Definitions.
Import Definitions.

Module sec_2_3_local_part_of_a_curve.
(* gbt-developable/sec-2.3.local.part of a curve, Sect. 2.3, first paragraph
   printed: every GBT-Bézier curve assigns two local shape parameters μ, ν
   read as: Changing one parameter leaves part of the curve (an interval of x) unchanged. The curve is analytic in x, so its derivative by mu would vanish everywhere.
   stated: D(G, mu)(x) == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun mu => G R_ k mu nu x) 1 mu = 0.
End sec_2_3_local_part_of_a_curve.

Module sec_2_3_local_part_of_a_composite.
(* gbt-developable/sec-2.3.local.part of a composite, Sect. 2.3, first paragraph
   printed: every GBT-Bézier curve assigns two local shape parameters μ, ν
   read as: Each curve of a composite has its own two parameters; changing them leaves the other curves unchanged.
   stated: D(H1(x), mu2) == 0 and D(H1(x), nu2) == 0 and D(H2(x), mu1) == 0 and D(H2(x), nu1) == 0 *)
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun mu2 => H1 P1 k mu1 nu1 x) 1 mu2 = 0 /\ Derive_n (fun nu2 => H1 P1 k mu1 nu1 x) 1 nu2 = 0 /\ Derive_n (fun mu1 => H2 P2 l mu2 nu2 x) 1 mu1 = 0 /\ Derive_n (fun nu1 => H2 P2 l mu2 nu2 x) 1 nu1 = 0.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  0 <= x <= 1.
End sec_2_3_local_part_of_a_composite.

Module sec_2_3_linear.
(* gbt-developable/sec-2.3.linear, Sect. 2.3, first paragraph
   printed: From Definition 2, we acknowledge that the curve G(x; μ, ν) is a linear function of every shape parameter μ, ν
   stated: D(G, mu, 2)(x) == 0 and D(G, nu, 2)(x) == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun mu => G R_ k mu nu x) 2 mu = 0 /\ Derive_n (fun nu => G R_ k mu nu x) 2 nu = 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_3_linear.

Module eq_2_3.
(* gbt-developable/eq-2.3, Sect. 2.3, eq. (2.3)
   printed: ∂G(x)/∂μ = binom(k − 2, i) (1 − sin(π/2 x))^(k−1−i) (sin(π/2 x))^(i+1) (R_{i+1} − R_i,   i = 0, 1, ..., k − 2
   read as: No summation sign and no closing bracket after R_i are printed. The left side is one vector, so the line is read as summed over the stated i.
   stated: D(G, mu)(x) == sum(i, 0, k - 2, binom(k - 2, i)*(1 - sin(pi/2*x))^(k - 1 - i)*sin(pi/2*x)^(i + 1)*(R[i+1] - R[i])) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - sin (PI / 2 * x) <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (i + 1)%Z)%Z \/ sin (PI / 2 * x) <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) ->
  Derive_n (fun mu => G R_ k mu nu x) 1 mu = sum 0%Z (k - 2)%Z (fun i => binom (IZR k - 2) i * powerRZ (1 - sin (PI / 2 * x)) (k - 1 - i)%Z * powerRZ (sin (PI / 2 * x)) (i + 1)%Z * (R_ (i + 1)%Z - R_ i)).
End eq_2_3.

Module eq_2_3_corrected.
(* gbt-developable/eq-2.3 (corrected), Sect. 2.3, eq. (2.3)
   printed: ∂G(x)/∂μ = binom(k − 2, i) (1 − sin(π/2 x))^(k−1−i) (sin(π/2 x))^(i+1) (R_{i+1} − R_i,   i = 0, 1, ..., k − 2
   read as: No summation sign and no closing bracket after R_i are printed. The left side is one vector, so the line is read as summed over the stated i.
   stated: D(G, mu)(x) == sum(i, 0, k - 2, binom(k - 2, i)*((1 - sin(pi/2*x))*(1 - x)^(k - 2 - i))*(sin(pi/2*x)*x^i)*(R[i+1] - R[i])) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (k - 2 - i)%Z)%Z \/ 1 - x <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i)%Z \/ x <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) ->
  Derive_n (fun mu => G R_ k mu nu x) 1 mu = sum 0%Z (k - 2)%Z (fun i => binom (IZR k - 2) i * ((1 - sin (PI / 2 * x)) * powerRZ (1 - x) (k - 2 - i)%Z) * (sin (PI / 2 * x) * powerRZ x i) * (R_ (i + 1)%Z - R_ i)).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (k - 2 - i)%Z)%Z \/ 1 - x <> 0) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i)%Z \/ x <> 0) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z).
End eq_2_3_corrected.

Module eq_2_4.
(* gbt-developable/eq-2.4, Sect. 2.3, eq. (2.4)
   printed: ∂G(x)/∂ν = binom(k − 2, i − 1) cos(π/2 x) (sin(π/2 x))^(i−1) (1 − cos(π/2 x)) (1 − sin(π/2 x))^(k−1−i) × (R_i − R_{i+1}),   i = 1, 2, ..., k − 1
   read as: No summation sign is printed; read as summed over the stated i, as for (2.3).
   stated: D(G, nu)(x) == sum(i, 1, k - 1, binom(k - 2, i - 1)*cos(pi/2*x)*sin(pi/2*x)^(i - 1)*(1 - cos(pi/2*x))*(1 - sin(pi/2*x))^(k - 1 - i)*(R[i] - R[i+1])) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (i - 1)%Z)%Z \/ sin (PI / 2 * x) <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - sin (PI / 2 * x) <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i <= k)%Z) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i + 1 <= k)%Z) ->
  Derive_n (fun nu => G R_ k mu nu x) 1 nu = sum 1%Z (k - 1)%Z (fun i => binom (IZR k - 2) (i - 1)%Z * cos (PI / 2 * x) * powerRZ (sin (PI / 2 * x)) (i - 1)%Z * (1 - cos (PI / 2 * x)) * powerRZ (1 - sin (PI / 2 * x)) (k - 1 - i)%Z * (R_ i - R_ (i + 1)%Z)).
End eq_2_4.

Module eq_2_4_corrected.
(* gbt-developable/eq-2.4 (corrected), Sect. 2.3, eq. (2.4)
   printed: ∂G(x)/∂ν = binom(k − 2, i − 1) cos(π/2 x) (sin(π/2 x))^(i−1) (1 − cos(π/2 x)) (1 − sin(π/2 x))^(k−1−i) × (R_i − R_{i+1}),   i = 1, 2, ..., k − 1
   read as: No summation sign is printed; read as summed over the stated i, as for (2.3).
   stated: D(G, nu)(x) == sum(i, 1, k - 1, binom(k - 2, i - 1)*cos(pi/2*x)*x^(i - 1)*(1 - cos(pi/2*x))*(1 - x)^(k - 1 - i)*(R[i] - R[i+1])) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (i - 1)%Z)%Z \/ x <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - x <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i <= k)%Z) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i + 1 <= k)%Z) ->
  Derive_n (fun nu => G R_ k mu nu x) 1 nu = sum 1%Z (k - 1)%Z (fun i => binom (IZR k - 2) (i - 1)%Z * cos (PI / 2 * x) * powerRZ x (i - 1)%Z * (1 - cos (PI / 2 * x)) * powerRZ (1 - x) (k - 1 - i)%Z * (R_ i - R_ (i + 1)%Z)).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (i - 1)%Z)%Z \/ x <> 0) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - x <> 0) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i <= k)%Z) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i + 1 <= k)%Z).
End eq_2_4_corrected.

Module sec_2_3_indep_mu.
(* gbt-developable/sec-2.3.indep-mu, Sect. 2.3, after (2.4)
   printed: there is no relationship among ∂G(x)/∂μ and μ
   stated: D(D(G, mu)(x), mu) == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun mu => Derive_n (fun mu => G R_ k mu nu x) 1 mu) 1 mu = 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_3_indep_mu.

Module sec_2_3_indep_nu.
(* gbt-developable/sec-2.3.indep-nu, Sect. 2.3, after (2.4)
   printed: [there is no relationship among] ∂G(x)/∂ν and ν
   stated: D(D(G, nu)(x), nu) == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun nu => Derive_n (fun nu => G R_ k mu nu x) 1 nu) 1 nu = 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_3_indep_nu.

Module sec_2_3_move.
(* gbt-developable/sec-2.3.move, Sect. 2.3, after (2.4)
   printed: modifying one shape parameter μ or ν, the point R(x) on the curve moves linearly for a fixed convex hull and defined value of x
   read as: R(x) read as the curve point G(x).
   stated: C(x, mu2, nu) - C(x, mu1, nu) == (mu2 - mu1)*D(G, mu)(x) and C(x, mu, nu2) - C(x, mu, nu1) == (nu2 - nu1)*D(G, nu)(x) *)
Definition C_ (R_ : Z -> R) (k : Z) (x : R) (mu : R) (nu : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * R_ i).
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  0 <= x <= 1 ->
  C_ R_ k x mu2 nu - C_ R_ k x mu1 nu = (mu2 - mu1) * Derive_n (fun mu => G R_ k mu nu x) 1 mu /\ C_ R_ k x mu nu2 - C_ R_ k x mu nu1 = (nu2 - nu1) * Derive_n (fun nu => G R_ k mu nu x) 1 nu.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  0 <= x <= 1.
End sec_2_3_move.

Module sec_2_3_dir_mu.
(* gbt-developable/sec-2.3.dir-mu, Sect. 2.3, unnumbered display after (2.4), first line
   printed: the alternation of direction is given by R_i R_{i+1}, i = 0, 1, ..., k − 2 for μ
   read as: R_i R_{i+1} read as the vector from R_i to R_{i+1}; 'given by' several of them: a combination of them with non-negative weights. The weights are those of (2.3) as corrected.
   stated: D(G, mu)(x) == sum(i, 0, k - 2, binom(k - 2, i)*(1 - x)^(k - 2 - i)*x^i*sin(pi/2*x)*(1 - sin(pi/2*x))*(R[i+1] - R[i])) and sin(pi/2*x)*(1 - sin(pi/2*x)) >= 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (k - 2 - i)%Z)%Z \/ 1 - x <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i)%Z \/ x <> 0) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) ->
  Derive_n (fun mu => G R_ k mu nu x) 1 mu = sum 0%Z (k - 2)%Z (fun i => binom (IZR k - 2) i * powerRZ (1 - x) (k - 2 - i)%Z * powerRZ x i * sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (R_ (i + 1)%Z - R_ i)) /\ sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) >= 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= (k - 2 - i)%Z)%Z \/ 1 - x <> 0) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i)%Z \/ x <> 0) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z).
End sec_2_3_dir_mu.

Module sec_2_3_dir_mu_single.
(* gbt-developable/sec-2.3.dir-mu.single, Sect. 2.3, unnumbered display after (2.4), first line
   printed: The point of a quadratic curve moves along a leg of the control polygon, that of a cubic along none of the listed vectors.
   stated: cross(D(quadratic(x), mu), U[1] - U[0]) == 0 and cross(D(quadratic(x), nu), U[1] - U[2]) == 0 and change[1]*2 - change[2]*1 == 1/4 and change[1]*1 - change[2]*2 == -1/2 *)
Definition quadratic (U : Z -> list R) (mu : R) (nu : R) (x : R) : list R :=
  vsum 3 0%Z 2%Z (fun i => vscale (g x mu nu i 2%Z) (U i)).
Definition cubic (mu : R) (nu : R) (x : R) : list R :=
  vadd (vadd (vscale (g x mu nu 1%Z 3%Z) [1; 2]) (vscale (g x mu nu 2%Z 3%Z) [3; 3])) (vscale (g x mu nu 3%Z 3%Z) [4; 0]).
Definition change (mu : R) (nu : R) : list R :=
  (fun x : R => vDerive 2 (fun mu => cubic mu nu x) 1 mu) (1 / 3).
Definition statement : Prop :=
forall (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  cross (vDerive 3 (fun mu => quadratic U mu nu x) 1 mu) (vsub (U 1%Z) (U 0%Z)) = zeros 3 /\ cross (vDerive 3 (fun nu => quadratic U mu nu x) 1 nu) (vsub (U 1%Z) (U 2%Z)) = zeros 3 /\ entry (change mu nu) 1 * 2 - entry (change mu nu) 2 * 1 = 1 / 4 /\ entry (change mu nu) 1 * 1 - entry (change mu nu) 2 * 2 = - 1 / 2.
Definition instance : Prop :=
exists (U'1 U'2 U'3 : Z -> R) (mu : R) (nu : R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0] in
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_3_dir_mu_single.

Module sec_2_3_dir_nu.
(* gbt-developable/sec-2.3.dir-nu, Sect. 2.3, unnumbered display after (2.4), second line
   printed: R_{i+1} R_i, i = 1, 2, ..., k − 1 for ν
   read as: As for μ: a combination of the vectors from R_{i+1} to R_i with non-negative weights, those of (2.4) as corrected.
   stated: D(G, nu)(x) == sum(i, 1, k - 1, binom(k - 2, i - 1)*(1 - x)^(k - 1 - i)*x^(i - 1)*cos(pi/2*x)*(1 - cos(pi/2*x))*(R[i] - R[i+1])) and cos(pi/2*x)*(1 - cos(pi/2*x)) >= 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - x <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (i - 1)%Z)%Z \/ x <> 0) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i <= k)%Z) ->
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i + 1 <= k)%Z) ->
  Derive_n (fun nu => G R_ k mu nu x) 1 nu = sum 1%Z (k - 1)%Z (fun i => binom (IZR k - 2) (i - 1)%Z * powerRZ (1 - x) (k - 1 - i)%Z * powerRZ x (i - 1)%Z * cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (R_ i - R_ (i + 1)%Z)) /\ cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) >= 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (k - 1 - i)%Z)%Z \/ 1 - x <> 0) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= (i - 1)%Z)%Z \/ x <> 0) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i <= k)%Z) /\
  (forall i : Z, (1 <= i <= (k - 1))%Z -> (0 <= i + 1 <= k)%Z).
End sec_2_3_dir_nu.

Module sec_2_3_range.
(* gbt-developable/sec-2.3.range, Sect. 2.3, paragraph on Fig. 2
   printed: When the shape parameters μ, ν take different values in their defined value range [0, 1]
   stated: 0 <= mu and mu <= 1 and 0 <= nu and nu <= 1 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= mu /\ mu <= 1 /\ 0 <= nu /\ nu <= 1.
End sec_2_3_range.

Module sec_2_3_concl_1.
(* gbt-developable/sec-2.3.concl-1, Sect. 2.3, numbered conclusion 1
   printed: By modifying the values of shape parameter either μ or ν or both, the points on the curves change linearly.
   stated: D(G, mu, 2)(x) == 0 and D(G, nu, 2)(x) == 0 and D(D(G, mu)(x), nu) == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun mu => G R_ k mu nu x) 2 mu = 0 /\ Derive_n (fun nu => G R_ k mu nu x) 2 nu = 0 /\ Derive_n (fun nu => Derive_n (fun mu => G R_ k mu nu x) 1 mu) 1 nu = 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_3_concl_1.

Module sec_2_3_concl_2_boundary_of_the_hull.
(* gbt-developable/sec-2.3.concl-2.boundary of the hull, Sect. 2.3, numbered conclusion 2
   printed: With simultaneous increase in the values of shape parameters μ, ν, the GBT-Bézier curves gradually move towards their convex hull.
   read as: No point of a curve gets farther from the boundary of the hull. Tried on the control points (0,0), (10,1), (20,0), (30,1): the distance of the point at x = 1/3 from the nearest side, Y = 0.
   stated: D(to_hull, t) <= 0 *)
Definition zigzag (t : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x t t 0%Z 3%Z) [0; 0]) (vscale (g x t t 1%Z 3%Z) [10; 1])) (vscale (g x t t 2%Z 3%Z) [20; 0])) (vscale (g x t t 3%Z 3%Z) [30; 1]).
Definition to_hull (t : R) : R :=
  entry (zigzag t (1 / 3)) 2.
Definition statement : Prop :=
forall (t : R),
  (-1) <= t <= (-1) / 2 ->
  Derive_n (fun t => to_hull t) 1 t <= 0.
End sec_2_3_concl_2_boundary_of_the_hull.

Module sec_2_3_concl_2_control_polygon.
(* gbt-developable/sec-2.3.concl-2.control polygon, Sect. 2.3, numbered conclusion 2
   printed: With simultaneous increase in the values of shape parameters μ, ν, the GBT-Bézier curves gradually move towards their convex hull.
   read as: No point of a curve gets farther from the control polygon. Tried on the control points (-1,0), (3,2), (-3,2), (1,0): the square of the distance of the point at x = 1/2 from the nearest leg, X + 1 = 2 Y.
   stated: D(to_leg2, t) <= 0 *)
Definition loop (t : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x t t 0%Z 3%Z) [- 1; 0]) (vscale (g x t t 1%Z 3%Z) [3; 2])) (vscale (g x t t 2%Z 3%Z) [- 3; 2])) (vscale (g x t t 3%Z 3%Z) [1; 0]).
Definition to_leg2 (t : R) : R :=
  (entry (loop t (1 / 2)) 1 + 1 - 2 * entry (loop t (1 / 2)) 2) ^ 2 / 5.
Definition statement : Prop :=
forall (t : R),
  (-1) <= t <= (-1) / 2 ->
  Derive_n (fun t => to_leg2 t) 1 t <= 0.
End sec_2_3_concl_2_control_polygon.

Module sec_2_3_concl_2_quadratic.
(* gbt-developable/sec-2.3.concl-2.quadratic, Sect. 2.3, numbered conclusion 2
   printed: At k = 2 the curves move towards their control polygon when μ = ν increases.
   stated: D(g[0,2](x, t, t), t) <= 0 and D(g[2,2](x, t, t), t) <= 0 and D(g[1,2](x, t, t), t) >= 0 *)
Definition statement : Prop :=
forall (t : R) (x : R),
  (-1) <= t <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun t => g x t t 0%Z 2%Z) 1 t <= 0 /\ Derive_n (fun t => g x t t 2%Z 2%Z) 1 t <= 0 /\ Derive_n (fun t => g x t t 1%Z 2%Z) 1 t >= 0.
Definition instance : Prop :=
exists (t : R) (x : R),
  (-1) <= t <= 1 /\
  0 <= x <= 1.
End sec_2_3_concl_2_quadratic.

Module sec_2_3_concl_2_mean.
(* gbt-developable/sec-2.3.concl-2.mean, Sect. 2.3, numbered conclusion 2
   printed: A curve of order k is a mean of the k - 1 curves of order 2 of three consecutive control points each, with the Bernstein functions for weights.
   stated: G(x) == sum(i, 0, k - 2, b[i,k-2](x)*(g[0,2](x)*R[i] + g[1,2](x)*R[i+1] + g[2,2](x)*R[i+2])) *)
Definition b (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= k - 2)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 2 <= k)%Z) ->
  G R_ k mu nu x = sum 0%Z (k - 2)%Z (fun i => b x i (k - 2)%Z * (g x mu nu 0%Z 2%Z * R_ i + g x mu nu 1%Z 2%Z * R_ (i + 1)%Z + g x mu nu 2%Z 2%Z * R_ (i + 2)%Z)).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= k - 2)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 2 <= k)%Z).
End sec_2_3_concl_2_mean.
