(* Statements of gbt-surfaces, Section 3 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition L0 (A : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * A k).
Definition L1 (B : Z -> R) (m : Z) (mu1 : R) (nu1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition S_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  (1 - z1) * L0 A m mu nu z + z1 * L1 B m mu1 nu1 z.
Definition S__ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  (1 - z1) * L0 A m mu nu z + z1 * L1 B m mu1 nu1 z.
Definition b (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - z) ^ 1 * z ^ 0; (1 - z) ^ 0 * z ^ 1] i k.
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition tensor (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => f z mu nu k m * b z1 l 1%Z * ((1 - IZR l) * A k + IZR l * B k))).
Definition own4 (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k).
End Definitions.
Import Definitions.

Module sec_3_3_generatrix.
(* gbt-surfaces/sec-3.3.generatrix, Sect. 3.3, first paragraph
   printed: a ruled surface has an astonishing property that, for fixed z, T(z,z_1) is a line segment joining points b_1(z) and b_2(z)
   read as: b_1 and b_2 are the guide lines (17), interpolated linearly.
   stated: S(z, 0) == L0(z) and S(z, 1) == L1(z) and D(S(z, z1), z1, 2) == 0 *)
Definition S_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  (1 - IZR z1) * L0 A m mu nu z + IZR z1 * L1 B m mu1 nu1 z.
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  S_ A B m mu mu1 nu nu1 z 0%Z = L0 A m mu nu z /\ S_ A B m mu mu1 nu nu1 z 1%Z = L1 B m mu1 nu1 z /\ Derive_n (fun z1_ => S__ A B m mu mu1 nu nu1 z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_3_generatrix.

Module sec_3_3_same_degree_literal.
(* gbt-surfaces/sec-3.3.same-degree.literal, Sect. 3.3, paragraph before eq. (17)
   printed: The necessary condition to express the ruled surface into tensor product form is that both should have the same degree.
   read as: Guide lines of degrees that differ never give a tensor product surface. Tried with a cubic of the points P, R, R, W and any quartic, all shape parameters -1.
   stated: fails((1 - z1)*cubic(z) + z1*quartic(z) == b[0,1](z1)*raised(z) + b[1,1](z1)*quartic(z)) *)
Definition cubic (P : R) (R_ : R) (W : R) (z : R) : R :=
  f z (- 1) (- 1) 0%Z 3%Z * P + f z (- 1) (- 1) 1%Z 3%Z * R_ + f z (- 1) (- 1) 2%Z 3%Z * R_ + f z (- 1) (- 1) 3%Z 3%Z * W.
Definition quartic (B : Z -> R) (z : R) : R :=
  sum 0%Z 4%Z (fun k => f z (- 1) (- 1) k 4%Z * B k).
Definition raised (P : R) (R_ : R) (W : R) (z : R) : R :=
  f z (- 1) (- 1) 0%Z 4%Z * P + f z (- 1) (- 1) 1%Z 4%Z * (P + R_) / 2 + f z (- 1) (- 1) 2%Z 4%Z * R_ + f z (- 1) (- 1) 3%Z 4%Z * (R_ + W) / 2 + f z (- 1) (- 1) 4%Z 4%Z * W.
Definition statement : Prop :=
forall (B : Z -> R) (P : R) (R_ : R) (W : R) (z : R) (z1 : R),
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (B : Z -> R) (P : R) (R_ : R) (W : R) (z : R) (z1 : R),
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (1 - z1) * cubic P R_ W z + z1 * quartic B z = b z1 0%Z 1%Z * raised P R_ W z + b z1 1%Z 1%Z * quartic B z).
End sec_3_3_same_degree_literal.

Module sec_3_3_same_degree_in_general.
(* gbt-surfaces/sec-3.3.same-degree.in general, Sect. 3.3, paragraph before eq. (17)
   printed: The necessary condition to express the ruled surface into tensor product form is that both should have the same degree.
   read as: Guide lines of degrees that differ do not in general give one, since a cubic is no quartic with the same shape parameters. Shown for vanishing shape parameters: the ends, the tangents there and a second derivative determine the quartic.
   stated: fails(cubic(z) == quartic(z)) *)
Definition quartic (C_ : Z -> R) (z : Z) : R :=
  sum 0%Z 4%Z (fun k => f (IZR z) 0 0 k 4%Z * C_ k).
Definition cubic (A : Z -> R) (z : Z) : R :=
  sum 0%Z 3%Z (fun k => f (IZR z) 0 0 k 3%Z * A k).
Definition quartic_ (C_ : Z -> R) (z : R) : R :=
  sum 0%Z 4%Z (fun k => f z 0 0 k 4%Z * C_ k).
Definition cubic_ (A : Z -> R) (z : R) : R :=
  sum 0%Z 3%Z (fun k => f z 0 0 k 3%Z * A k).
Definition statement : Prop :=
forall (A : Z -> R) (C_ : Z -> R) (z : R),
  0 <= z <= 1 ->
  quartic C_ 0%Z = cubic A 0%Z ->
  (let z_ := 0%Z in Derive_n (fun z__ => quartic_ C_ z__) 1 (IZR z_)) = (let z__ := 0%Z in Derive_n (fun z___ => cubic_ A z___) 1 (IZR z__)) ->
  (let z___ := 0%Z in Derive_n (fun z____ => quartic_ C_ z____) 2 (IZR z___)) = (let z____ := 0%Z in Derive_n (fun z_____ => cubic_ A z_____) 2 (IZR z____)) ->
  quartic C_ 1%Z = cubic A 1%Z ->
  (let z_____ := 1%Z in Derive_n (fun z______ => quartic_ C_ z______) 1 (IZR z_____)) = (let z______ := 1%Z in Derive_n (fun z_______ => cubic_ A z_______) 1 (IZR z______)) ->
  ~ (forall (A : Z -> R) (C_ : Z -> R) (z : R),
  0 <= z <= 1 ->
  quartic C_ 0%Z = cubic A 0%Z ->
  (let z_______ := 0%Z in Derive_n (fun z________ => quartic_ C_ z________) 1 (IZR z_______)) = (let z________ := 0%Z in Derive_n (fun z_________ => cubic_ A z_________) 1 (IZR z________)) ->
  (let z_________ := 0%Z in Derive_n (fun z__________ => quartic_ C_ z__________) 2 (IZR z_________)) = (let z__________ := 0%Z in Derive_n (fun z___________ => cubic_ A z___________) 2 (IZR z__________)) ->
  quartic C_ 1%Z = cubic A 1%Z ->
  (let z___________ := 1%Z in Derive_n (fun z____________ => quartic_ C_ z____________) 1 (IZR z___________)) = (let z____________ := 1%Z in Derive_n (fun z_____________ => cubic_ A z_____________) 1 (IZR z____________)) ->
  cubic_ A z = quartic_ C_ z).
Definition instance : Prop :=
exists (A : Z -> R) (C_ : Z -> R) (z : R),
  0 <= z <= 1 /\
  quartic C_ 0%Z = cubic A 0%Z /\
  (let z_ := 0%Z in Derive_n (fun z__ => quartic_ C_ z__) 1 (IZR z_)) = (let z__ := 0%Z in Derive_n (fun z___ => cubic_ A z___) 1 (IZR z__)) /\
  (let z___ := 0%Z in Derive_n (fun z____ => quartic_ C_ z____) 2 (IZR z___)) = (let z____ := 0%Z in Derive_n (fun z_____ => cubic_ A z_____) 2 (IZR z____)) /\
  quartic C_ 1%Z = cubic A 1%Z /\
  (let z_____ := 1%Z in Derive_n (fun z______ => quartic_ C_ z______) 1 (IZR z_____)) = (let z______ := 1%Z in Derive_n (fun z_______ => cubic_ A z_______) 1 (IZR z______)).
End sec_3_3_same_degree_in_general.

Module eq_17_0.
(* gbt-surfaces/eq-17.0, Sect. 3.3, eq. (17), first line
   printed: F_{m,0}(z,μ,ν) = sum_{k=0}^{m} f^0_{k,m}(z) Q_{0,k}, 0 ≤ z ≤ 1
   read as: The formula, and the ends between which the first boundary of the surface runs.
   stated: L0(z) == sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) and L0(0) == A[0] and L0(1) == A[m] *)
Definition L0_ (A : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * A k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  L0 A m mu nu z = sum 0%Z m (fun k => f z mu nu k m * A k) /\ L0_ A m mu nu 0%Z = A 0%Z /\ L0_ A m mu nu 1%Z = A m.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_17_0.

Module eq_17_1.
(* gbt-surfaces/eq-17.1, Sect. 3.3, eq. (17), second line
   printed: F_{m,1}(z,μ_1,ν_1) = sum_{k=0}^{m} f^1_{k,m}(z) Q_{1,k}, 0 ≤ z ≤ 1
   read as: The formula, and the ends between which the second boundary of the surface runs.
   stated: L1(z) == sum(k, 0, m, f[k,m](z, mu1, nu1)*B[k]) and L1(0) == B[0] and L1(1) == B[m] *)
Definition L1_ (B : Z -> R) (m : Z) (mu1 : R) (nu1 : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu1 nu1 k m * B k).
Definition statement : Prop :=
forall (m : Z) (B : Z -> R) (mu1 : R) (nu1 : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  L1 B m mu1 nu1 z = sum 0%Z m (fun k => f z mu1 nu1 k m * B k) /\ L1_ B m mu1 nu1 0%Z = B 0%Z /\ L1_ B m mu1 nu1 1%Z = B m.
Definition instance : Prop :=
exists (m : Z) (B : Z -> R) (mu1 : R) (nu1 : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1.
End eq_17_1.

Module sec_3_3_condition_1.
(* gbt-surfaces/sec-3.3.condition-1, Sect. 3.3, condition (1) before eq. (18)
   printed: For fixed value of z, the curve T_ruled(z,z_1) is a line segment.
   read as: With one set of functions for both guide lines, and with a set for each.
   stated: D(printed(z, z1), z1, 2) == 0 and D(with_own(z, z1), z1, 2) == 0 *)
Definition with_own (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  Derive_n (fun z1_ => printed_ A B m mu nu z z1_) 2 z1 = 0 /\ Derive_n (fun z1_ => with_own A B m mu mu1 nu nu1 z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_3_condition_1.

Module sec_3_3_condition_2.
(* gbt-surfaces/sec-3.3.condition-2, Sect. 3.3, condition (2) before eq. (18)
   printed: The guild lines fulfil the T_ruled(z,0) = F_{m,0}(z,μ,ν) and T_ruled(z,1) = F_{m,1}(z,μ_1,ν_1).
   read as: (18) has one set of functions f_{k,m} for both guide lines.
   stated: printed(z, 0) == L0(z) and printed(z, 1) == L1(z) *)
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  printed_ A B m mu nu z 0%Z = L0 A m mu nu z /\ printed_ A B m mu nu z 1%Z = L1 B m mu1 nu1 z.
End sec_3_3_condition_2.

Module eq_18.
(* gbt-surfaces/eq-18, Sect. 3.3, eq. (18)
   printed: T_ruled(z,z_1,μ,ν,μ_1,ν_1) = sum_{l=0}^{1} ( f_{l,1}(z_1) sum_{k=0}^{m} f_{k,m}(z) Q_{l,k} ), 0 ≤ z, z_1 ≤ 1
   read as: The formula against the linear interpolation of the guide lines (17).
   stated: printed(z, z1) == S(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  printed_ A B m mu nu z z1 = S_ A B m mu mu1 nu nu1 z z1.
End eq_18.

Module eq_18_corrected.
(* gbt-surfaces/eq-18 (corrected), Sect. 3.3, eq. (18)
   printed: T_ruled(z,z_1,μ,ν,μ_1,ν_1) = sum_{l=0}^{1} ( f_{l,1}(z_1) sum_{k=0}^{m} f_{k,m}(z) Q_{l,k} ), 0 ≤ z, z_1 ≤ 1
   read as: The formula against the linear interpolation of the guide lines (17).
   stated: b[0,1](z1)*sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) + b[1,1](z1)*sum(k, 0, m, f[k,m](z, mu1, nu1)*B[k]) == S(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k) = S_ A B m mu mu1 nu nu1 z z1.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_18_corrected.

Module eq_18_true.
(* gbt-surfaces/eq-18.true, Sect. 3.3, eq. (18)
   printed: With a set of functions for each guide line (18) meets both conditions.
   stated: with_own(z, 0) == L0(z) and with_own(z, 1) == L1(z) and D(with_own(z, z1), z1, 2) == 0 *)
Definition with_own (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition with_own_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  with_own A B m mu mu1 nu nu1 z 0%Z = L0 A m mu nu z /\ with_own A B m mu mu1 nu nu1 z 1%Z = L1 B m mu1 nu1 z /\ Derive_n (fun z1_ => with_own_ A B m mu mu1 nu nu1 z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_18_true.

Module eq_18_sufficient.
(* gbt-surfaces/eq-18.sufficient, Sect. 3.3, eq. (18)
   printed: As printed it meets them if both guide lines have the same shape parameters.
   stated: printed(z, 0) == L0(z) and printed(z, 1) == L1(z) and D(printed(z, z1), z1, 2) == 0 *)
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition printed__ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  mu1 = mu ->
  nu1 = nu ->
  printed_ A B m mu nu z 0%Z = L0 A m mu nu z /\ printed_ A B m mu nu z 1%Z = L1 B m mu1 nu1 z /\ Derive_n (fun z1_ => printed__ A B m mu nu z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  mu1 = mu /\
  nu1 = nu.
End eq_18_sufficient.

Module eq_18_necessary.
(* gbt-surfaces/eq-18.necessary, Sect. 3.3, eq. (18)
   printed: How far the printed surface departs from the second guide line at its ends: it contains that line only if μ_1 = μ, or B_1 = B_0, and ν_1 = ν, or B_m = B_{m-1}.
   stated: at(D(printed(z, 1) - L1(z), z), z, 0) == pi/2*(mu - mu1)*(B[1] - B[0]) and at(D(printed(z, 1) - L1(z), z), z, 1) == pi/2*(nu - nu1)*(B[m] - B[m-1]) *)
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (let z := 0%Z in Derive_n (fun z_ => printed_ A B m mu nu z_ 1%Z - L1 B m mu1 nu1 z_) 1 (IZR z)) = PI / 2 * (mu - mu1) * (B 1%Z - B 0%Z) /\ (let z := 1%Z in Derive_n (fun z_ => printed_ A B m mu nu z_ 1%Z - L1 B m mu1 nu1 z_) 1 (IZR z)) = PI / 2 * (nu - nu1) * (B m - B (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End eq_18_necessary.

Module eq_18_defect.
(* gbt-surfaces/eq-18.defect, Sect. 3.3, eq. (18)
   printed: What the printed (18) lacks of the surface between the guide lines, for every order.
   stated: printed(z, z1) - S(z, z1) == z1*((mu - mu1)*sin(pi/2*z)*(1 - sin(pi/2*z))*sum(k, 0, m - 2, e[k,m-2](z)*(B[k+1] - B[k])) - (nu - nu1)*cos(pi/2*z)*(1 - cos(pi/2*z))*sum(k, 0, m - 2, e[k,m-2](z)*(B[k+2] - B[k+1]))) *)
Definition e (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [1] i k.
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z) ->
  printed_ A B m mu nu z z1 - S_ A B m mu mu1 nu nu1 z z1 = z1 * ((mu - mu1) * sin (PI / 2 * z) * (1 - sin (PI / 2 * z)) * sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * (B (k + 1)%Z - B k)) - (nu - nu1) * cos (PI / 2 * z) * (1 - cos (PI / 2 * z)) * sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * (B (k + 2)%Z - B (k + 1)%Z))).
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z).
End eq_18_defect.

Module eq_18_tensor.
(* gbt-surfaces/eq-18.tensor, Sect. 3.3, sentence after eq. (18)
   printed: Equation (18) represents the tensor product GBT-Bézier surface in the form of a GBT-Bézier modified ruled surface.
   read as: (18) has one set of functions f_{k,m} for both guide lines.
   stated: printed(z, z1) == tensor(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  printed_ A B m mu nu z z1 = tensor A B m mu nu z z1.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_18_tensor.

Module sec_3_3_benefits_a.
(* gbt-surfaces/sec-3.3.benefits.a, Sect. 3.3, paragraph after eq. (18)
   printed: The GBT-Bézier ruled surfaces defined in (18) take over all characteristics and benefits of GBT-Bézier surfaces because these surfaces are expressed in the form of tensor product GBT-Bézier surfaces and the GLs are two GBT-Bézier curves that have the same degree.
   read as: Convex hull and affine invariance (nonnegative weights that sum to one), interpolation of the corners, change with the shape parameters; with one set of functions for both guide lines, and with a set for each.
   stated: nonnegative(f) and nonnegative(b) and b[0,1](z1)*sum(k, 0, m, f[k,m](z, mu, nu)) + b[1,1](z1)*sum(k, 0, m, f[k,m](z, mu, nu)) == 1 and b[0,1](z1)*sum(k, 0, m, f[k,m](z, mu, nu)) + b[1,1](z1)*sum(k, 0, m, f[k,m](z, mu1, nu1)) == 1 and printed(0, 0) == A[0] and printed(1, 0) == A[m] and printed(0, 1) == B[0] and printed(1, 1) == B[m] and with_own(0, 0) == A[0] and with_own(1, 0) == A[m] and with_own(0, 1) == B[0] and with_own(1, 1) == B[m] and fails(D(at(D(printed(z, z1), z), z, 0), mu) == 0) and fails(D(at(D(printed(z, z1), z), z, 1), nu) == 0) and fails(D(at(D(with_own(z, z1), z), z, 0), mu) == 0) and fails(D(at(D(with_own(z, z1), z), z, 1), nu) == 0) and fails(D(at(D(with_own(z, z1), z), z, 0), mu1) == 0) and fails(D(at(D(with_own(z, z1), z), z, 1), nu1) == 0) *)
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f (IZR z) mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f (IZR z) mu nu k m * B k).
Definition with_own (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : Z) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f (IZR z) mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f (IZR z) mu1 nu1 k m * B k).
Definition printed__ (A : Z -> R) (B : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition printed___ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition with_own_ (A : Z -> R) (B : Z -> R) (m : Z) (mu1 : R) (nu : R) (nu1 : R) (mu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition with_own__ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu1 : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition with_own___ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (nu1 : R) (mu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition with_own____ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ (forall i_ k_ : Z, (1 <= k_)%Z -> 0 <= b z i_ k_) /\ b z1 0%Z 1%Z * sum 0%Z m (fun k__ => f z mu nu k__ m) + b z1 1%Z 1%Z * sum 0%Z m (fun k__ => f z mu nu k__ m) = 1 /\ b z1 0%Z 1%Z * sum 0%Z m (fun k__ => f z mu nu k__ m) + b z1 1%Z 1%Z * sum 0%Z m (fun k__ => f z mu1 nu1 k__ m) = 1 /\ printed_ A B m mu nu 0%Z 0%Z = A 0%Z /\ printed_ A B m mu nu 1%Z 0%Z = A m /\ printed_ A B m mu nu 0%Z 1%Z = B 0%Z /\ printed_ A B m mu nu 1%Z 1%Z = B m /\ with_own A B m mu mu1 nu nu1 0%Z 0%Z = A 0%Z /\ with_own A B m mu mu1 nu nu1 1%Z 0%Z = A m /\ with_own A B m mu mu1 nu nu1 0%Z 1%Z = B 0%Z /\ with_own A B m mu mu1 nu nu1 1%Z 1%Z = B m /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z_ := 0%Z in Derive_n (fun z__ => printed__ A B m nu mu_ z__ z1) 1 (IZR z_)) 1 mu = 0) /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_ := 1%Z in Derive_n (fun z__ => printed___ A B m mu nu_ z__ z1) 1 (IZR z_)) 1 nu = 0) /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z_ := 0%Z in Derive_n (fun z__ => with_own_ A B m mu1 nu nu1 mu_ z__ z1) 1 (IZR z_)) 1 mu = 0) /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_ := 1%Z in Derive_n (fun z__ => with_own__ A B m mu mu1 nu1 nu_ z__ z1) 1 (IZR z_)) 1 nu = 0) /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu1_ => let z_ := 0%Z in Derive_n (fun z__ => with_own___ A B m mu nu nu1 mu1_ z__ z1) 1 (IZR z_)) 1 mu1 = 0) /\ ~ (forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k__ : Z, (0 <= k__ <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu1_ => let z_ := 1%Z in Derive_n (fun z__ => with_own____ A B m mu mu1 nu nu1_ z__ z1) 1 (IZR z_)) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_3_benefits_a.

Module prop_3_3_a.
(* gbt-surfaces/prop-3.3.a, Sect. 3.3, Proposition 3.3, first sentence
   printed: the straight generatrices of a GBT-Bézier ruled surfaces are the straight lines that are obtained by joining iso-parametric points, instead of joining the same length of an arc of the two GLs
   stated: S(z, 0) == L0(z) and S(z, 1) == L1(z) and D(S(z, z1), z1, 2) == 0 *)
Definition S_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  (1 - IZR z1) * L0 A m mu nu z + IZR z1 * L1 B m mu1 nu1 z.
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  S_ A B m mu mu1 nu nu1 z 0%Z = L0 A m mu nu z /\ S_ A B m mu mu1 nu nu1 z 1%Z = L1 B m mu1 nu1 z /\ Derive_n (fun z1_ => S__ A B m mu mu1 nu nu1 z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_3_a.

Module prop_3_3_b.
(* gbt-surfaces/prop-3.3.b, Sect. 3.3, Proposition 3.3, second sentence
   printed: Generally, joining the same length of an arc of any two GLs gives us a different ruled surface.
   read as: Two straight guide lines of degree 2 with evenly spaced control points: the expressions are the lengths of arc from the start, as parts of the whole, at equal parameters.
   stated: fails(f[1,2](z, mu, nu)/2 + f[2,2](z, mu, nu) == f[1,2](z, mu1, nu1)/2 + f[2,2](z, mu1, nu1)) *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  ~ (forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  f z mu nu 1%Z 2%Z / 2 + f z mu nu 2%Z 2%Z = f z mu1 nu1 1%Z 2%Z / 2 + f z mu1 nu1 2%Z 2%Z).
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1.
End prop_3_3_b.

Module prop_3_4_a.
(* gbt-surfaces/prop-3.4.a, Sect. 3.3, Proposition 3.4, first sentence
   printed: the GBT-Bézier ruled surface is a special case of tensor product GBT-Bézier surface
   read as: (18) has one set of functions f_{k,m} for both guide lines.
   stated: printed(z, z1) == tensor(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  printed_ A B m mu nu z z1 = tensor A B m mu nu z z1.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_4_a.

Module prop_3_4_a_net.
(* gbt-surfaces/prop-3.4.a.net, Sect. 3.3, Proposition 3.4, first sentence
   printed: With a set of functions for each guide line no other net helps: the second guide line of order 2 is no curve with the functions of the first. The net is determined by the ends and one end tangent.
   stated: fails(line(z) == any(z)) *)
Definition any (C_ : Z -> R) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z 2%Z (fun k => f (IZR z) mu nu k 2%Z * C_ k).
Definition line (B : Z -> R) (mu1 : R) (nu1 : R) (z : Z) : R :=
  sum 0%Z 2%Z (fun k => f (IZR z) mu1 nu1 k 2%Z * B k).
Definition any_ (C_ : Z -> R) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z 2%Z (fun k => f z mu nu k 2%Z * C_ k).
Definition line_ (B : Z -> R) (mu1 : R) (nu1 : R) (z : R) : R :=
  sum 0%Z 2%Z (fun k => f z mu1 nu1 k 2%Z * B k).
Definition statement : Prop :=
forall (B : Z -> R) (C_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) < mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  any C_ mu nu 0%Z = line B mu1 nu1 0%Z ->
  (let z_ := 0%Z in Derive_n (fun z__ => any_ C_ mu nu z__) 1 (IZR z_)) = (let z__ := 0%Z in Derive_n (fun z___ => line_ B mu1 nu1 z___) 1 (IZR z__)) ->
  any C_ mu nu 1%Z = line B mu1 nu1 1%Z ->
  ~ (forall (B : Z -> R) (C_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) < mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  any C_ mu nu 0%Z = line B mu1 nu1 0%Z ->
  (let z___ := 0%Z in Derive_n (fun z____ => any_ C_ mu nu z____) 1 (IZR z___)) = (let z____ := 0%Z in Derive_n (fun z_____ => line_ B mu1 nu1 z_____) 1 (IZR z____)) ->
  any C_ mu nu 1%Z = line B mu1 nu1 1%Z ->
  line_ B mu1 nu1 z = any_ C_ mu nu z).
Definition instance : Prop :=
exists (B : Z -> R) (C_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) < mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  any C_ mu nu 0%Z = line B mu1 nu1 0%Z /\
  (let z_ := 0%Z in Derive_n (fun z__ => any_ C_ mu nu z__) 1 (IZR z_)) = (let z__ := 0%Z in Derive_n (fun z___ => line_ B mu1 nu1 z___) 1 (IZR z__)) /\
  any C_ mu nu 1%Z = line B mu1 nu1 1%Z.
End prop_3_4_a_net.

Module prop_3_4_b.
(* gbt-surfaces/prop-3.4.b, Sect. 3.3, Proposition 3.4, second sentence
   printed: the two adjacent GBT-Bézier ruled surfaces satisfy C1, C2, and C3 continuity conditions because both GLs of the ruled surfaces satisfy these conditions (see Fig. 10 and Fig. 11)
   read as: The jump of each derivative of the surface is the interpolation of the jumps of the guide lines, so it vanishes if and only if both of them do.
   stated: jump(0) == (1 - z1)*jump0(0) + z1*jump1(0) and at(jump(0), z1, 0) == jump0(0) and at(jump(0), z1, 1) == jump1(0) and jump(1) == (1 - z1)*jump0(1) + z1*jump1(1) and at(jump(1), z1, 0) == jump0(1) and at(jump(1), z1, 1) == jump1(1) and jump(2) == (1 - z1)*jump0(2) + z1*jump1(2) and at(jump(2), z1, 0) == jump0(2) and at(jump(2), z1, 1) == jump1(2) and jump(3) == (1 - z1)*jump0(3) + z1*jump1(3) and at(jump(3), z1, 0) == jump0(3) and at(jump(3), z1, 1) == jump1(3) *)
Definition M0 (C_ : Z -> R) (mu2 : R) (n : Z) (nu2 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu2 nu2 k n * C_ k).
Definition M1 (E_ : Z -> R) (mu3 : R) (n : Z) (nu3 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu3 nu3 k n * E_ k).
Definition S2 (C_ : Z -> R) (E_ : Z -> R) (mu2 : R) (mu3 : R) (n : Z) (nu2 : R) (nu3 : R) (z : R) (z1 : R) : R :=
  (1 - z1) * M0 C_ mu2 n nu2 z + z1 * M1 E_ mu3 n nu3 z.
Definition jump (A : Z -> R) (B : Z -> R) (C_ : Z -> R) (E_ : Z -> R) (m : Z) (mu : R) (mu1 : R) (mu2 : R) (mu3 : R) (n : Z) (nu : R) (nu1 : R) (nu2 : R) (nu3 : R) (z1 : R) (r : Z) : R :=
  (let z := 0%Z in Derive_n (fun z_ => S2 C_ E_ mu2 mu3 n nu2 nu3 z_ z1) (Z.to_nat r) (IZR z)) - (let z := 1%Z in Derive_n (fun z_ => S_ A B m mu mu1 nu nu1 z_ z1) (Z.to_nat r) (IZR z)).
Definition jump0 (A : Z -> R) (C_ : Z -> R) (m : Z) (mu : R) (mu2 : R) (n : Z) (nu : R) (nu2 : R) (r : Z) : R :=
  (let z := 0%Z in Derive_n (fun z_ => M0 C_ mu2 n nu2 z_) (Z.to_nat r) (IZR z)) - (let z := 1%Z in Derive_n (fun z_ => L0 A m mu nu z_) (Z.to_nat r) (IZR z)).
Definition jump1 (B : Z -> R) (E_ : Z -> R) (m : Z) (mu1 : R) (mu3 : R) (n : Z) (nu1 : R) (nu3 : R) (r : Z) : R :=
  (let z := 0%Z in Derive_n (fun z_ => M1 E_ mu3 n nu3 z_) (Z.to_nat r) (IZR z)) - (let z := 1%Z in Derive_n (fun z_ => L1 B m mu1 nu1 z_) (Z.to_nat r) (IZR z)).
Definition S2_ (C_ : Z -> R) (E_ : Z -> R) (mu2 : R) (mu3 : R) (n : Z) (nu2 : R) (nu3 : R) (z : R) (z1 : Z) : R :=
  (1 - IZR z1) * M0 C_ mu2 n nu2 z + IZR z1 * M1 E_ mu3 n nu3 z.
Definition S__ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  (1 - IZR z1) * L0 A m mu nu z + IZR z1 * L1 B m mu1 nu1 z.
Definition jump_ (A : Z -> R) (B : Z -> R) (C_ : Z -> R) (E_ : Z -> R) (m : Z) (mu : R) (mu1 : R) (mu2 : R) (mu3 : R) (n : Z) (nu : R) (nu1 : R) (nu2 : R) (nu3 : R) (z1 : Z) (r : Z) : R :=
  (let z := 0%Z in Derive_n (fun z_ => S2_ C_ E_ mu2 mu3 n nu2 nu3 z_ z1) (Z.to_nat r) (IZR z)) - (let z := 1%Z in Derive_n (fun z_ => S__ A B m mu mu1 nu nu1 z_ z1) (Z.to_nat r) (IZR z)).
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (C_ : Z -> R) (E_ : Z -> R) (mu : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu : R) (nu1 : R) (nu2 : R) (nu3 : R) (z1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (-1) <= nu3 <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  jump A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 z1 0%Z = (1 - z1) * jump0 A C_ m mu mu2 n nu nu2 0%Z + z1 * jump1 B E_ m mu1 mu3 n nu1 nu3 0%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 0%Z 0%Z = jump0 A C_ m mu mu2 n nu nu2 0%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 1%Z 0%Z = jump1 B E_ m mu1 mu3 n nu1 nu3 0%Z /\ jump A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 z1 1%Z = (1 - z1) * jump0 A C_ m mu mu2 n nu nu2 1%Z + z1 * jump1 B E_ m mu1 mu3 n nu1 nu3 1%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 0%Z 1%Z = jump0 A C_ m mu mu2 n nu nu2 1%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 1%Z 1%Z = jump1 B E_ m mu1 mu3 n nu1 nu3 1%Z /\ jump A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 z1 2%Z = (1 - z1) * jump0 A C_ m mu mu2 n nu nu2 2%Z + z1 * jump1 B E_ m mu1 mu3 n nu1 nu3 2%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 0%Z 2%Z = jump0 A C_ m mu mu2 n nu nu2 2%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 1%Z 2%Z = jump1 B E_ m mu1 mu3 n nu1 nu3 2%Z /\ jump A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 z1 3%Z = (1 - z1) * jump0 A C_ m mu mu2 n nu nu2 3%Z + z1 * jump1 B E_ m mu1 mu3 n nu1 nu3 3%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 0%Z 3%Z = jump0 A C_ m mu mu2 n nu nu2 3%Z /\ jump_ A B C_ E_ m mu mu1 mu2 mu3 n nu nu1 nu2 nu3 1%Z 3%Z = jump1 B E_ m mu1 mu3 n nu1 nu3 3%Z.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (C_ : Z -> R) (E_ : Z -> R) (mu : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu : R) (nu1 : R) (nu2 : R) (nu3 : R) (z1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= mu3 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  (-1) <= nu3 <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End prop_3_4_b.

Module alg_3_a.
(* gbt-surfaces/alg-3.a, Sect. 3.3, Algorithm 3, steps 1 to 5
   printed: 1. Consider any two GLs in the form of GBT-Bézier curves. 2. Use tensor product form of the GBT-Bézier ruled surface as given in (18). 3. The guild lines must satisfy the conditions T_ruled(z,0) = F_{m,0}(z,μ,ν) and T_ruled(z,1) = F_{m,1}(z,μ_1,ν_1). 4. Take the control points Q_{i,j} in a 3D plane according to designer choice. 5. Draw.
   read as: Steps 2 and 3: the surface (18), with one set of functions for both guide lines, meets the conditions.
   stated: printed(z, 0) == L0(z) and printed(z, 1) == L1(z) *)
Definition printed_ (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  b (IZR z1) 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b (IZR z1) 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  printed_ A B m mu nu z 0%Z = L0 A m mu nu z /\ printed_ A B m mu nu z 1%Z = L1 B m mu1 nu1 z.
End alg_3_a.

Module alg_3_a_corrected.
(* gbt-surfaces/alg-3.a (corrected), Sect. 3.3, Algorithm 3, steps 1 to 5
   printed: 1. Consider any two GLs in the form of GBT-Bézier curves. 2. Use tensor product form of the GBT-Bézier ruled surface as given in (18). 3. The guild lines must satisfy the conditions T_ruled(z,0) = F_{m,0}(z,μ,ν) and T_ruled(z,1) = F_{m,1}(z,μ_1,ν_1). 4. Take the control points Q_{i,j} in a 3D plane according to designer choice. 5. Draw.
   read as: Steps 2 and 3: the surface (18), with one set of functions for both guide lines, meets the conditions.
   stated: b[0,1](0)*sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) + b[1,1](0)*sum(k, 0, m, f[k,m](z, mu1, nu1)*B[k]) == L0(z) and b[0,1](1)*sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) + b[1,1](1)*sum(k, 0, m, f[k,m](z, mu1, nu1)*B[k]) == L1(z) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  b 0 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b 0 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k) = L0 A m mu nu z /\ b 1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b 1 1%Z 1%Z * sum 0%Z m (fun k => f z mu1 nu1 k m * B k) = L1 B m mu1 nu1 z.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1.
End alg_3_a_corrected.

Module alg_3_b.
(* gbt-surfaces/alg-3.b, Sect. 3.3, Algorithm 3, step 6
   printed: 6. Two adjacent GBT-Bézier ruled surfaces can be connected by C1, C2, and C3 continuity conditions given in Theorem 2.
   read as: The guide lines are joined with Theorem 2 as printed.
   stated: other(0) == pair(1) and other'(0) == pair'(1) and other''(0) == pair''(1) and other'''(0) == pair'''(1) *)
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition printed11 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3 (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  2 * a1 mu1 n nu1 + PI ^ 2 * (1 + 2 * mu1 - nu1) + 2 * PI ^ 2 * nu.
Definition printed12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + a3 mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition b1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition b2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)).
Definition c1 (mu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - nu1).
Definition b4 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3 mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
Definition printed13 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / b1 mu1 n nu1 * (b2 m nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (Q (m - 1)%Z - Q (m - 2)%Z) - b4 m mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition third (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3 mu1 n nu nu1 * (p - q)).
Definition fourth (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2 m nu * (p - 3 * q + 3 * r - s) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (p - 2 * q + r) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4 m mu1 n nu nu1 * (p - q)).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : Z) : R :=
  sum 0%Z n (fun k => f (IZR z) mu1 nu1 k n * Q1 k).
Definition other (E_ : Z -> R) (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) (z : Z) : R :=
  (1 - z1) * F1 Q1 mu1 n nu1 z + z1 * sum 0%Z n (fun k => f (IZR z) mu1 nu1 k n * E_ k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition pair (B : Z -> R) (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z1 : R) (z : Z) : R :=
  (1 - z1) * F Q m mu nu z + z1 * sum 0%Z m (fun k => f (IZR z) mu nu k m * B k).
Definition F1_ (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition other_ (E_ : Z -> R) (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) (z : R) : R :=
  (1 - z1) * F1_ Q1 mu1 n nu1 z + z1 * sum 0%Z n (fun k => f z mu1 nu1 k n * E_ k).
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition pair_ (B : Z -> R) (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z1 : R) (z : R) : R :=
  (1 - z1) * F_ Q m mu nu z + z1 * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition statement : Prop :=
forall (m : Z) (n : Z) (B : Z -> R) (E_ : Z -> R) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  Q1 0%Z = Q m ->
  (0 <= 1 <= n)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  Q1 1%Z = printed11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  Q1 2%Z = printed12 Q m mu mu1 n nu nu1 ->
  (0 <= 3 <= n)%Z ->
  b1 mu1 n nu1 <> 0 ->
  (0 <= m - 3 <= m)%Z ->
  Q1 3%Z = printed13 Q m mu1 n nu nu1 ->
  E_ 0%Z = B m ->
  E_ 1%Z = B m + a m mu1 n nu * (B m - B (m - 1)%Z) ->
  E_ 2%Z = third m mu mu1 n nu nu1 (B m) (B (m - 1)%Z) (B (m - 2)%Z) ->
  E_ 3%Z = fourth m mu1 n nu nu1 (B m) (B (m - 1)%Z) (B (m - 2)%Z) (B (m - 3)%Z) ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  other E_ Q1 mu1 n nu1 z1 0%Z = pair B Q m mu nu z1 1%Z /\ (let z := 0%Z in Derive_n (fun z_ => other_ E_ Q1 mu1 n nu1 z1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => pair_ B Q m mu nu z1 z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => other_ E_ Q1 mu1 n nu1 z1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => pair_ B Q m mu nu z1 z____) 2 (IZR z___)) /\ (let z____ := 0%Z in Derive_n (fun z_____ => other_ E_ Q1 mu1 n nu1 z1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => pair_ B Q m mu nu z1 z______) 3 (IZR z_____)).
End alg_3_b.

Module ex_3_3_curves.
(* gbt-surfaces/ex-3.3.curves, Sect. 3.3, Example 3.3, first line
   printed: Let F_{4,l}(z,μ_1,ν_1) (l = 0, 1) be two GBT-Bézier curves of degree 4 in a 3-dimensional space
   read as: The two curves, both with the shape parameters mu_1 and nu_1, against the guide lines of (19), which have a pair each; those of the first are mu and nu here.
   stated: own4(z, 0) == sum(k, 0, 4, f[k,4](z, mu1, nu1)*A[k]) and own4(z, 1) == sum(k, 0, 4, f[k,4](z, mu1, nu1)*B[k]) *)
Definition statement : Prop :=
forall (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  own4 A B mu mu1 nu nu1 z 0%Z = sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * A k) /\ own4 A B mu mu1 nu nu1 z 1%Z = sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k).
End ex_3_3_curves.

Module ex_3_3_curves_corrected.
(* gbt-surfaces/ex-3.3.curves (corrected), Sect. 3.3, Example 3.3, first line
   printed: Let F_{4,l}(z,μ_1,ν_1) (l = 0, 1) be two GBT-Bézier curves of degree 4 in a 3-dimensional space
   read as: The two curves, both with the shape parameters mu_1 and nu_1, against the guide lines of (19), which have a pair each; those of the first are mu and nu here.
   stated: own4(z, 0) == sum(k, 0, 4, f[k,4](z, mu, nu)*A[k]) and own4(z, 1) == sum(k, 0, 4, f[k,4](z, mu1, nu1)*B[k]) *)
Definition statement : Prop :=
forall (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  own4 A B mu mu1 nu nu1 z 0%Z = sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k) /\ own4 A B mu mu1 nu nu1 z 1%Z = sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k).
Definition instance : Prop :=
exists (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1.
End ex_3_3_curves_corrected.

Module eq_19_literal.
(* gbt-surfaces/eq-19.literal, Sect. 3.3, Example 3.3, eq. (19)
   printed: T_ruled(z,z_1,μ_0,ν_0,μ_1,ν_1) = sum_{l=0}^{1} ( f_{l,1}(z_1) sum_{k=0}^{4} f^l_{k,m}(z) Q_{l,k} ), 0 ≤ z, z_1 ≤ 1
   read as: The order m of the functions is any, as in (17) and (18); the guide lines are the curves of degree 4 all the same.
   stated: sum(k, 0, 4, f[k,m](z, mu, nu)*A[k]) == sum(k, 0, 4, f[k,4](z, mu, nu)*A[k]) *)
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  sum 0%Z 4%Z (fun k => f z mu nu k m * A k) = sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k).
End eq_19_literal.

Module eq_19_m_is_4.
(* gbt-surfaces/eq-19.m is 4, Sect. 3.3, Example 3.3, eq. (19)
   printed: T_ruled(z,z_1,μ_0,ν_0,μ_1,ν_1) = sum_{l=0}^{1} ( f_{l,1}(z_1) sum_{k=0}^{4} f^l_{k,m}(z) Q_{l,k} ), 0 ≤ z, z_1 ≤ 1
   read as: The order m of the functions is 4, the degree of the curves; the shape parameters of the first guide line are mu and nu here.
   stated: own4(z, 0) == sum(k, 0, 4, f[k,4](z, mu, nu)*A[k]) and own4(z, 1) == sum(k, 0, 4, f[k,4](z, mu1, nu1)*B[k]) and D(own4(z, z1), z1, 2) == 0 *)
Definition own4_ (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k) + b z1 1%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k).
Definition statement : Prop :=
forall (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  own4 A B mu mu1 nu nu1 z 0%Z = sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k) /\ own4 A B mu mu1 nu nu1 z 1%Z = sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k) /\ Derive_n (fun z1_ => own4_ A B mu mu1 nu nu1 z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_19_m_is_4.

Module eq_19_tensor.
(* gbt-surfaces/eq-19.tensor, Sect. 3.3, Example 3.3: (19) is introduced as 'from equation (18)'
   printed: then from equation (18) the equation of the GBT-Bézier ruled surfaces formed by these GBT-Bézier curves as the GLs is given by (19)
   read as: (19) is (18) for degree 4, with one set of functions for both guide lines.
   stated: own4(z, z1) == tensor4(z, z1) *)
Definition own4 (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k) + b z1 1%Z 1%Z * sum 0%Z 4%Z (fun k => f z mu1 nu1 k 4%Z * B k).
Definition tensor4 (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z 4%Z (fun k => sum 0%Z 1%Z (fun l => f z mu nu k 4%Z * b z1 l 1%Z * ((1 - IZR l) * A k + IZR l * B k))).
Definition statement : Prop :=
forall (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  own4 A B mu mu1 nu nu1 z z1 = tensor4 A B mu nu z z1.
End eq_19_tensor.

Module ex_3_3_gl_0.
(* gbt-surfaces/ex-3.3.gl-0, Sect. 3.3, Example 3.3, data, first two lines of the brace
   printed: Q_{1,0} = (1, 0, 4), Q_{0,1} = (2, 0, 8), Q_{0,2} = (4, 0, 8), Q_{0,3} = (5, 0, 4), Q_{0,4} = (6, 0, 8)
   read as: The first guide line (17), whose points are Q_{0,0} to Q_{0,4}, against the curve of the points as they are labelled here.
   stated: f[0,4](z, mu, nu)*Q00 + f[1,4](z, mu, nu)*Q01 + f[2,4](z, mu, nu)*Q02 + f[3,4](z, mu, nu)*Q03 + f[4,4](z, mu, nu)*Q04 == f[0,4](z, mu, nu)*Q10 + f[1,4](z, mu, nu)*Q01 + f[2,4](z, mu, nu)*Q02 + f[3,4](z, mu, nu)*Q03 + f[4,4](z, mu, nu)*Q04 *)
Definition statement : Prop :=
forall (Q00 : R) (Q01 : R) (Q02 : R) (Q03 : R) (Q04 : R) (Q10 : R) (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  f z mu nu 0%Z 4%Z * Q00 + f z mu nu 1%Z 4%Z * Q01 + f z mu nu 2%Z 4%Z * Q02 + f z mu nu 3%Z 4%Z * Q03 + f z mu nu 4%Z 4%Z * Q04 = f z mu nu 0%Z 4%Z * Q10 + f z mu nu 1%Z 4%Z * Q01 + f z mu nu 2%Z 4%Z * Q02 + f z mu nu 3%Z 4%Z * Q03 + f z mu nu 4%Z 4%Z * Q04.
End ex_3_3_gl_0.

Module ex_3_3_gl_0_corrected.
(* gbt-surfaces/ex-3.3.gl-0 (corrected), Sect. 3.3, Example 3.3, data, first two lines of the brace
   printed: Q_{1,0} = (1, 0, 4), Q_{0,1} = (2, 0, 8), Q_{0,2} = (4, 0, 8), Q_{0,3} = (5, 0, 4), Q_{0,4} = (6, 0, 8)
   read as: The first guide line (17), whose points are Q_{0,0} to Q_{0,4}, against the curve of the points as they are labelled here.
   stated: f[0,4](z, mu, nu)*Q00 + f[1,4](z, mu, nu)*Q01 + f[2,4](z, mu, nu)*Q02 + f[3,4](z, mu, nu)*Q03 + f[4,4](z, mu, nu)*Q04 == f[0,4](z, mu, nu)*Q00 + f[1,4](z, mu, nu)*Q01 + f[2,4](z, mu, nu)*Q02 + f[3,4](z, mu, nu)*Q03 + f[4,4](z, mu, nu)*Q04 *)
Definition statement : Prop :=
forall (Q00 : R) (Q01 : R) (Q02 : R) (Q03 : R) (Q04 : R) (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  f z mu nu 0%Z 4%Z * Q00 + f z mu nu 1%Z 4%Z * Q01 + f z mu nu 2%Z 4%Z * Q02 + f z mu nu 3%Z 4%Z * Q03 + f z mu nu 4%Z 4%Z * Q04 = f z mu nu 0%Z 4%Z * Q00 + f z mu nu 1%Z 4%Z * Q01 + f z mu nu 2%Z 4%Z * Q02 + f z mu nu 3%Z 4%Z * Q03 + f z mu nu 4%Z 4%Z * Q04.
Definition instance : Prop :=
exists (Q00 : R) (Q01 : R) (Q02 : R) (Q03 : R) (Q04 : R) (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End ex_3_3_gl_0_corrected.

Module ex_3_3_gl_1.
(* gbt-surfaces/ex-3.3.gl-1, Sect. 3.3, Example 3.3, data, last two lines of the brace
   printed: Q_{0,1} = (1, 6, 4), Q_{1,1} = (2, 6, 0), Q_{1,2} = (4, 6, 0), Q_{1,3} = (6, 6, 4), Q_{1,4} = (7, 6, 2)
   read as: The second guide line (17), whose points are Q_{1,0} to Q_{1,4}, against the curve of the points as they are labelled here.
   stated: f[0,4](z, mu1, nu1)*Q10 + f[1,4](z, mu1, nu1)*Q11 + f[2,4](z, mu1, nu1)*Q12 + f[3,4](z, mu1, nu1)*Q13 + f[4,4](z, mu1, nu1)*Q14 == f[0,4](z, mu1, nu1)*Q01 + f[1,4](z, mu1, nu1)*Q11 + f[2,4](z, mu1, nu1)*Q12 + f[3,4](z, mu1, nu1)*Q13 + f[4,4](z, mu1, nu1)*Q14 *)
Definition statement : Prop :=
forall (Q01 : R) (Q10 : R) (Q11 : R) (Q12 : R) (Q13 : R) (Q14 : R) (mu1 : R) (nu1 : R) (z : R),
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  f z mu1 nu1 0%Z 4%Z * Q10 + f z mu1 nu1 1%Z 4%Z * Q11 + f z mu1 nu1 2%Z 4%Z * Q12 + f z mu1 nu1 3%Z 4%Z * Q13 + f z mu1 nu1 4%Z 4%Z * Q14 = f z mu1 nu1 0%Z 4%Z * Q01 + f z mu1 nu1 1%Z 4%Z * Q11 + f z mu1 nu1 2%Z 4%Z * Q12 + f z mu1 nu1 3%Z 4%Z * Q13 + f z mu1 nu1 4%Z 4%Z * Q14.
End ex_3_3_gl_1.

Module ex_3_3_gl_1_corrected.
(* gbt-surfaces/ex-3.3.gl-1 (corrected), Sect. 3.3, Example 3.3, data, last two lines of the brace
   printed: Q_{0,1} = (1, 6, 4), Q_{1,1} = (2, 6, 0), Q_{1,2} = (4, 6, 0), Q_{1,3} = (6, 6, 4), Q_{1,4} = (7, 6, 2)
   read as: The second guide line (17), whose points are Q_{1,0} to Q_{1,4}, against the curve of the points as they are labelled here.
   stated: f[0,4](z, mu1, nu1)*Q10 + f[1,4](z, mu1, nu1)*Q11 + f[2,4](z, mu1, nu1)*Q12 + f[3,4](z, mu1, nu1)*Q13 + f[4,4](z, mu1, nu1)*Q14 == f[0,4](z, mu1, nu1)*Q10 + f[1,4](z, mu1, nu1)*Q11 + f[2,4](z, mu1, nu1)*Q12 + f[3,4](z, mu1, nu1)*Q13 + f[4,4](z, mu1, nu1)*Q14 *)
Definition statement : Prop :=
forall (Q10 : R) (Q11 : R) (Q12 : R) (Q13 : R) (Q14 : R) (mu1 : R) (nu1 : R) (z : R),
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  f z mu1 nu1 0%Z 4%Z * Q10 + f z mu1 nu1 1%Z 4%Z * Q11 + f z mu1 nu1 2%Z 4%Z * Q12 + f z mu1 nu1 3%Z 4%Z * Q13 + f z mu1 nu1 4%Z 4%Z * Q14 = f z mu1 nu1 0%Z 4%Z * Q10 + f z mu1 nu1 1%Z 4%Z * Q11 + f z mu1 nu1 2%Z 4%Z * Q12 + f z mu1 nu1 3%Z 4%Z * Q13 + f z mu1 nu1 4%Z 4%Z * Q14.
Definition instance : Prop :=
exists (Q10 : R) (Q11 : R) (Q12 : R) (Q13 : R) (Q14 : R) (mu1 : R) (nu1 : R) (z : R),
  (-1) <= mu1 <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1.
End ex_3_3_gl_1_corrected.

Module ex_3_3_composite.
(* gbt-surfaces/ex-3.3.composite, Sect. 3.3, last paragraph of Example 3.3
   printed: Two adjacent GBT-Bézier ruled surfaces satisfying the C1 and C2 continuity in z direction can be presented in Figs. 10 and 11 with third and fourth degree GBT-Bézier curves taken as GLs of the right and left GBT-Bézier ruled surface, respectively. Figure 12 shows the C3 continuity of two adjacent GBT-Bézier ruled surfaces that have forth degree GBT-Bézier curves as GLs in z direction.
   read as: The guide lines can join: for every quartic on the left, a cubic on the right joins with C2 and a quartic with C3, exhibited with vanishing shape parameters; the surfaces join with them.
   stated: cubic(0) == left(1) and cubic'(0) == left'(1) and cubic''(0) == left''(1) and quartic(0) == left(1) and quartic'(0) == left'(1) and quartic''(0) == left''(1) and quartic'''(0) == left'''(1) *)
Definition a1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + IZR mu1)) + PI ^ 2 * (1 - IZR nu1).
Definition b1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - IZR nu1).
Definition a (nu : R) (m : Z) (n : Z) (mu1 : Z) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + IZR mu1)).
Definition join1 (nu : R) (m : Z) (n : Z) (mu1 : Z) (p : R) (q : R) : R :=
  p + a nu m n mu1 * (p - q).
Definition a2 (nu : R) (m : Z) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3_true (nu : R) (m : Z) (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  a nu m n mu1 * (2 * a1 n nu1 mu1 - PI ^ 2 * (1 - 2 * IZR mu1 - IZR nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (mu : R) (nu : R) (m : Z) (n : Z) (nu1 : Z) (mu1 : Z) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 n nu1 mu1 * (a2 nu m * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true nu m n nu1 mu1 * (p - q)).
Definition b2_true (mu : R) (nu : R) (m : Z) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
Definition c1 (n : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)).
Definition b3_true (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  3 * c1 n mu1 + 12 * (IZR n - 2) * PI ^ 2 * (1 + IZR mu1 - IZR nu1).
Definition b5_true (mu : R) (nu : R) (m : Z) : R :=
  6 * (IZR m - 2) * PI ^ 2 * (mu + 2 * nu - 1).
Definition b4_true (nu : R) (m : Z) (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  a nu m n mu1 * (3 * c1 n mu1 + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * IZR mu1 - IZR nu1) - PI ^ 3 * (1 + IZR mu1)) - a3_true nu m n nu1 mu1 * b3_true n nu1 mu1 / a1 n nu1 mu1 + PI ^ 3 * (1 + nu).
Definition join3 (mu : R) (nu : R) (m : Z) (n : Z) (nu1 : Z) (mu1 : Z) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 n nu1 mu1 * (b2_true mu nu m * (p - 3 * q + 3 * r - s) + (a2 nu m / a1 n nu1 mu1 * b3_true n nu1 mu1 + b5_true mu nu m) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true n nu1 mu1 / a1 n nu1 mu1 * (q - r) - b4_true nu m n nu1 mu1 * (p - q)).
Definition next (mu : R) (nu : R) (m : Z) (p : R) (q : R) (r : R) (s : R) (t : Z) : R :=
  f (IZR t) 0 0 0%Z 3%Z * p + f (IZR t) 0 0 1%Z 3%Z * join1 nu m 3%Z 0%Z p q + f (IZR t) 0 0 2%Z 3%Z * join2 mu nu m 3%Z 0%Z 0%Z p q r + f (IZR t) 0 0 3%Z 3%Z * join3 mu nu m 3%Z 0%Z 0%Z p q r s.
Definition cubic (A : Z -> R) (mu : R) (nu : R) (t : Z) : R :=
  next mu nu 4%Z (A 4%Z) (A 3%Z) (A 2%Z) (A 1%Z) t.
Definition left_ (A : Z -> R) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z 4%Z (fun k => f (IZR z) mu nu k 4%Z * A k).
Definition next_ (mu : R) (nu : R) (m : Z) (p : R) (q : R) (r : R) (s : R) (t : R) : R :=
  f t 0 0 0%Z 3%Z * p + f t 0 0 1%Z 3%Z * join1 nu m 3%Z 0%Z p q + f t 0 0 2%Z 3%Z * join2 mu nu m 3%Z 0%Z 0%Z p q r + f t 0 0 3%Z 3%Z * join3 mu nu m 3%Z 0%Z 0%Z p q r s.
Definition cubic_ (A : Z -> R) (mu : R) (nu : R) (t : R) : R :=
  next_ mu nu 4%Z (A 4%Z) (A 3%Z) (A 2%Z) (A 1%Z) t.
Definition left__ (A : Z -> R) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z 4%Z (fun k => f z mu nu k 4%Z * A k).
Definition quartic (A : Z -> R) (E_ : Z -> R) (mu : R) (nu : R) (t : Z) : R :=
  f (IZR t) 0 0 0%Z 4%Z * A 4%Z + f (IZR t) 0 0 1%Z 4%Z * join1 nu 4%Z 4%Z 0%Z (A 4%Z) (A 3%Z) + f (IZR t) 0 0 2%Z 4%Z * join2 mu nu 4%Z 4%Z 0%Z 0%Z (A 4%Z) (A 3%Z) (A 2%Z) + f (IZR t) 0 0 3%Z 4%Z * join3 mu nu 4%Z 4%Z 0%Z 0%Z (A 4%Z) (A 3%Z) (A 2%Z) (A 1%Z) + f (IZR t) 0 0 4%Z 4%Z * E_ 4%Z.
Definition quartic_ (A : Z -> R) (E_ : Z -> R) (mu : R) (nu : R) (t : R) : R :=
  f t 0 0 0%Z 4%Z * A 4%Z + f t 0 0 1%Z 4%Z * join1 nu 4%Z 4%Z 0%Z (A 4%Z) (A 3%Z) + f t 0 0 2%Z 4%Z * join2 mu nu 4%Z 4%Z 0%Z 0%Z (A 4%Z) (A 3%Z) (A 2%Z) + f t 0 0 3%Z 4%Z * join3 mu nu 4%Z 4%Z 0%Z 0%Z (A 4%Z) (A 3%Z) (A 2%Z) (A 1%Z) + f t 0 0 4%Z 4%Z * E_ 4%Z.
Definition statement : Prop :=
forall (A : Z -> R) (E_ : Z -> R) (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 3%Z 0%Z 0%Z <> 0 ->
  b1 3%Z 0%Z 0%Z <> 0 ->
  2 * (IZR 4%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 4%Z 0%Z 0%Z <> 0 ->
  b1 4%Z 0%Z 0%Z <> 0 ->
  cubic A mu nu 0%Z = left_ A mu nu 1%Z /\ (let t := 0%Z in Derive_n (fun t_ => cubic_ A mu nu t_) 1 (IZR t)) = (let z := 1%Z in Derive_n (fun z_ => left__ A mu nu z_) 1 (IZR z)) /\ (let t_ := 0%Z in Derive_n (fun t__ => cubic_ A mu nu t__) 2 (IZR t_)) = (let z_ := 1%Z in Derive_n (fun z__ => left__ A mu nu z__) 2 (IZR z_)) /\ quartic A E_ mu nu 0%Z = left_ A mu nu 1%Z /\ (let t__ := 0%Z in Derive_n (fun t___ => quartic_ A E_ mu nu t___) 1 (IZR t__)) = (let z__ := 1%Z in Derive_n (fun z___ => left__ A mu nu z___) 1 (IZR z__)) /\ (let t___ := 0%Z in Derive_n (fun t____ => quartic_ A E_ mu nu t____) 2 (IZR t___)) = (let z___ := 1%Z in Derive_n (fun z____ => left__ A mu nu z____) 2 (IZR z___)) /\ (let t____ := 0%Z in Derive_n (fun t_____ => quartic_ A E_ mu nu t_____) 3 (IZR t____)) = (let z____ := 1%Z in Derive_n (fun z_____ => left__ A mu nu z_____) 3 (IZR z____)).
Definition instance : Prop :=
exists (A : Z -> R) (E_ : Z -> R) (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 3%Z 0%Z 0%Z <> 0 /\
  b1 3%Z 0%Z 0%Z <> 0 /\
  2 * (IZR 4%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 4%Z 0%Z 0%Z <> 0 /\
  b1 4%Z 0%Z 0%Z <> 0.
End ex_3_3_composite.
