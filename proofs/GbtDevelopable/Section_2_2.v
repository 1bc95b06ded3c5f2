(* Statements of gbt-developable, Section 2 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
End Definitions.
Import Definitions.

Module def_2_dim_one_letter.
(* gbt-developable/def-2.dim.one letter, Sect. 2.2, Definition 2
   printed: For any defined control points R_i ∈ R^k (k = 2, 3; i = 0, 1, ..., k)
   read as: The dimension of the space is the degree of the curve, 2 or 3.
   stated: k <= 3 *)
Definition statement : Prop :=
forall (k : Z),
  (2 <= k)%Z ->
  IZR k <= 3.
End def_2_dim_one_letter.

Module def_2_dim_two_letters.
(* gbt-developable/def-2.dim.two letters, Sect. 2.2, Definition 2
   printed: For any defined control points R_i ∈ R^k (k = 2, 3; i = 0, 1, ..., k)
   read as: The k of R^k is the dimension, 2 or 3, and the k of i = 0, ..., k the degree: (2.2) is meant coordinate by coordinate.
   stated: HT(x)[1] == sum(i, 0, k, g[i,k](x)*T[i][1]) and HT(x)[2] == sum(i, 0, k, g[i,k](x)*T[i][2]) and HT(x)[3] == sum(i, 0, k, g[i,k](x)*T[i][3]) *)
Definition HT (T : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) (T i)).
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  entry (HT T k mu nu x) 1 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 1) /\ entry (HT T k mu nu x) 2 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 2) /\ entry (HT T k mu nu x) 3 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 3).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_2_dim_two_letters.

Module sec_2_2_endpoints.
(* gbt-developable/sec-2.2.endpoints, Sect. 2.2, last sentence
   printed: These features specify that the GBT-Bézier curves interpolate to the end points of its convex hull
   read as: 'end points of its convex hull' read as the first and last control point: G(0) = R_0, G(1) = R_k.
   stated: G(0) == R[0] and G(1) == R[k] *)
Definition G (R_ : Z -> R) (k : Z) (mu : R) (nu : R) (x : Z) : R :=
  sum 0%Z k (fun i => g (IZR x) mu nu i k * R_ i).
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= k <= k)%Z ->
  G R_ k mu nu 0%Z = R_ 0%Z /\ G R_ k mu nu 1%Z = R_ k.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= k <= k)%Z.
End sec_2_2_endpoints.

Module sec_2_2_convexity.
(* gbt-developable/sec-2.2.convexity, Sect. 2.2, paragraph after Definition 2
   printed: ... convexity ...
   stated: sum(i, 0, k, g[i,k](x)) == 1 and nonnegative(g) *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z k (fun i => g x mu nu i k) = 1 /\ (forall i k_ : Z, (2 <= k_)%Z -> 0 <= g x mu nu i k_).
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_2_convexity.

Module sec_2_2_symmetry.
(* gbt-developable/sec-2.2.symmetry, Sect. 2.2, paragraph after Definition 2
   printed: ... symmetry ...
   read as: 'the aforementioned features of GBTB basis functions demonstrate': the symmetry of Theorem 1, item 4, and its μ = ν. The reversed polygon gives the same curve, run backwards.
   stated: sum(i, 0, k, g[i,k](x, mu, nu)*R[k-i]) == sum(i, 0, k, g[i,k](1 - x, mu, nu)*R[i]) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  mu = nu ->
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k - i <= k)%Z) ->
  sum 0%Z k (fun i => g x mu nu i k * R_ (k - i)%Z) = sum 0%Z k (fun i => g (1 - x) mu nu i k * R_ i).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  mu = nu /\
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k - i <= k)%Z).
End sec_2_2_symmetry.

Module sec_2_2_symmetry_exchange.
(* gbt-developable/sec-2.2.symmetry.exchange, Sect. 2.2, paragraph after Definition 2
   printed: The symmetry of the curves for all shape parameters, with μ and ν exchanged.
   stated: sum(i, 0, k, g[i,k](x, mu, nu)*R[k-i]) == sum(i, 0, k, g[i,k](1 - x, nu, mu)*R[i]) *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k - i <= k)%Z) ->
  sum 0%Z k (fun i => g x mu nu i k * R_ (k - i)%Z) = sum 0%Z k (fun i => g (1 - x) nu mu i k * R_ i).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k - i <= k)%Z).
End sec_2_2_symmetry_exchange.

Module sec_2_2_vd_quadratic.
(* gbt-developable/sec-2.2.vd.quadratic, Sect. 2.2, paragraph after Definition 2
   printed: The variation diminishing feature at k = 2: two Wronskians are positive.
   stated: D(g[0,2](x), x, 2)*D(g[2,2](x), x) - D(g[0,2](x), x)*D(g[2,2](x), x, 2) > 0 and D(g[2,2](x) - g[0,2](x), x) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) < mu < 1 ->
  (-1) < nu < 1 ->
  0 < x < 1 ->
  Derive_n (fun x_ => g x_ mu nu 0%Z 2%Z) 2 x * Derive_n (fun x_ => g x_ mu nu 2%Z 2%Z) 1 x - Derive_n (fun x_ => g x_ mu nu 0%Z 2%Z) 1 x * Derive_n (fun x_ => g x_ mu nu 2%Z 2%Z) 2 x > 0 /\ Derive_n (fun x_ => g x_ mu nu 2%Z 2%Z - g x_ mu nu 0%Z 2%Z) 1 x > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) < mu < 1 /\
  (-1) < nu < 1 /\
  0 < x < 1.
End sec_2_2_vd_quadratic.

Module sec_2_2_vd_operator.
(* gbt-developable/sec-2.2.vd.operator, Sect. 2.2, paragraph after Definition 2
   printed: Every curve is made of the Bézier curve of the same control points and its first two derivatives.
   stated: G(x) == F(x) + first/k*F'(x) + second/(k*(k - 1))*F''(x) *)
Definition G (R_ : Z -> R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * R_ i).
Definition b (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition F (R_ : Z -> R) (k : Z) (x : R) : R :=
  sum 0%Z k (fun i => b x i k * R_ i).
Definition first (mu : R) (nu : R) (x : R) : R :=
  1 - g x mu nu 0%Z 2%Z + g x mu nu 2%Z 2%Z - 2 * x.
Definition second (mu : R) (nu : R) (x : R) : R :=
  x ^ 2 - x + x * g x mu nu 0%Z 2%Z + (1 - x) * g x mu nu 2%Z 2%Z.
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k)%Z) ->
  IZR k <> 0 ->
  IZR k * (IZR k - 1) <> 0 ->
  G R_ k mu nu x = F R_ k x + first mu nu x / IZR k * Derive_n (fun x_ => F R_ k x_) 1 x + second mu nu x / (IZR k * (IZR k - 1)) * Derive_n (fun x_ => F R_ k x_) 2 x.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= k)%Z -> (0 <= k)%Z) /\
  IZR k <> 0 /\
  IZR k * (IZR k - 1) <> 0.
End sec_2_2_vd_operator.

Module sec_2_2_vd_cubic.
(* gbt-developable/sec-2.2.vd.cubic, Sect. 2.2, paragraph after Definition 2
   printed: The variation diminishing feature at k = 3 for |μ|, |ν| ≤ 3/4: three determinants are positive.
   stated: det([[D(l1, x), D(l2, x)], [D(l1, x, 2), D(l2, x, 2)]]) == 2*second and det([[D(l1, x), D(l2, x), D(l3, x)], [D(l1, x, 2), D(l2, x, 2), D(l3, x, 2)], [D(l1, x, 3), D(l2, x, 3), D(l3, x, 3)]]) == 12*third and first > 0 and second > 0 and third > 0 *)
Definition f (mu : R) (nu : R) (x : R) : R :=
  1 - g x mu nu 0%Z 2%Z + g x mu nu 2%Z 2%Z - 2 * x.
Definition l1 (mu : R) (nu : R) (x : R) : R :=
  x + f mu nu x / 3.
Definition s (mu : R) (nu : R) (x : R) : R :=
  x ^ 2 - x + x * g x mu nu 0%Z 2%Z + (1 - x) * g x mu nu 2%Z 2%Z.
Definition l2 (mu : R) (nu : R) (x : R) : R :=
  x ^ 2 + 2 * f mu nu x / 3 * x + s mu nu x / 3.
Definition second (mu : R) (nu : R) (x : R) : R :=
  det [[Derive_n (fun x_ => f mu nu x_) 1 x / 3 + 1; Derive_n (fun x_ => s mu nu x_) 1 x / 3 + 2 / 3 * f mu nu x]; [Derive_n (fun x_ => f mu nu x_) 2 x / 6; Derive_n (fun x_ => s mu nu x_) 2 x / 6 + 2 / 3 * Derive_n (fun x_ => f mu nu x_) 1 x + 1]].
Definition l3 (mu : R) (nu : R) (x : R) : R :=
  x ^ 3 + f mu nu x * x ^ 2 + s mu nu x * x.
Definition third (mu : R) (nu : R) (x : R) : R :=
  det [[Derive_n (fun x_ => f mu nu x_) 1 x / 3 + 1; Derive_n (fun x_ => s mu nu x_) 1 x / 3 + 2 / 3 * f mu nu x; s mu nu x]; [Derive_n (fun x_ => f mu nu x_) 2 x / 6; Derive_n (fun x_ => s mu nu x_) 2 x / 6 + 2 / 3 * Derive_n (fun x_ => f mu nu x_) 1 x + 1; Derive_n (fun x_ => s mu nu x_) 1 x + f mu nu x]; [Derive_n (fun x_ => f mu nu x_) 3 x / 18; Derive_n (fun x_ => s mu nu x_) 3 x / 18 + Derive_n (fun x_ => f mu nu x_) 2 x / 3; Derive_n (fun x_ => s mu nu x_) 2 x / 2 + Derive_n (fun x_ => f mu nu x_) 1 x + 1]].
Definition first (mu : R) (nu : R) (x : R) : R :=
  Derive_n (fun x_ => l1 mu nu x_) 1 x.
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-3) / 4 <= mu <= 3 / 4 ->
  (-3) / 4 <= nu <= 3 / 4 ->
  0 <= x <= 1 ->
  det [[Derive_n (fun x_ => l1 mu nu x_) 1 x; Derive_n (fun x_ => l2 mu nu x_) 1 x]; [Derive_n (fun x_ => l1 mu nu x_) 2 x; Derive_n (fun x_ => l2 mu nu x_) 2 x]] = 2 * second mu nu x /\ det [[Derive_n (fun x_ => l1 mu nu x_) 1 x; Derive_n (fun x_ => l2 mu nu x_) 1 x; Derive_n (fun x_ => l3 mu nu x_) 1 x]; [Derive_n (fun x_ => l1 mu nu x_) 2 x; Derive_n (fun x_ => l2 mu nu x_) 2 x; Derive_n (fun x_ => l3 mu nu x_) 2 x]; [Derive_n (fun x_ => l1 mu nu x_) 3 x; Derive_n (fun x_ => l2 mu nu x_) 3 x; Derive_n (fun x_ => l3 mu nu x_) 3 x]] = 12 * third mu nu x /\ first mu nu x > 0 /\ second mu nu x > 0 /\ third mu nu x > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-3) / 4 <= mu <= 3 / 4 /\
  (-3) / 4 <= nu <= 3 / 4 /\
  0 <= x <= 1.
End sec_2_2_vd_cubic.

Module sec_2_2_geominv.
(* gbt-developable/sec-2.2.geominv, Sect. 2.2, paragraph after Definition 2
   printed: ... geometric invariance feature
   read as: The curve of the images of the control points under an affine map is the image of the curve.
   stated: sum(i, 0, k, g[i,k](x)*(M*R[i] + shift)) == M*G(x) + shift *)
Definition M (m1 : list R) (m2 : list R) (m3 : list R) : list (list R) :=
  [m1; m2; m3].
Definition G (R_ : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 3 0%Z k (fun i => vscale (g x mu nu i k) (R_ i)).
Definition statement : Prop :=
forall (k : Z) (R_'1 R_'2 R_'3 : Z -> R) (m1'1 m1'2 m1'3 : R) (m2'1 m2'2 m2'3 : R) (m3'1 m3'2 m3'3 : R) (mu : R) (nu : R) (shift'1 shift'2 shift'3 : R) (x : R),
  let R_ := fun i0 => [R_'1 i0; R_'2 i0; R_'3 i0] in
  let m1 := [m1'1; m1'2; m1'3] in
  let m2 := [m2'1; m2'2; m2'3] in
  let m3 := [m3'1; m3'2; m3'3] in
  let shift := [shift'1; shift'2; shift'3] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  vsum 3 0%Z k (fun i => vscale (g x mu nu i k) (vadd (mvec (M m1 m2 m3) (R_ i)) shift)) = vadd (mvec (M m1 m2 m3) (G R_ k mu nu x)) shift.
Definition instance : Prop :=
exists (k : Z) (R_'1 R_'2 R_'3 : Z -> R) (m1'1 m1'2 m1'3 : R) (m2'1 m2'2 m2'3 : R) (m3'1 m3'2 m3'3 : R) (mu : R) (nu : R) (shift'1 shift'2 shift'3 : R) (x : R),
  let R_ := fun i0 => [R_'1 i0; R_'2 i0; R_'3 i0] in
  let m1 := [m1'1; m1'2; m1'3] in
  let m2 := [m2'1; m2'2; m2'3] in
  let m3 := [m3'1; m3'2; m3'3] in
  let shift := [shift'1; shift'2; shift'3] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End sec_2_2_geominv.
