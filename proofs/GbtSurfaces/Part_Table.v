(* Statements of gbt-surfaces, Part Table. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + IZR mu1)) + PI ^ 2 * (1 - IZR nu1).
Definition b1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - IZR nu1).
Definition a (m : Z) (nu : R) (n : Z) (mu1 : Z) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + IZR mu1)).
Definition join1 (m : Z) (nu : R) (n : Z) (mu1 : Z) (p : R) (q : R) : R :=
  p + a m nu n mu1 * (p - q).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3_true (m : Z) (nu : R) (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  a m nu n mu1 * (2 * a1 n nu1 mu1 - PI ^ 2 * (1 - 2 * IZR mu1 - IZR nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (nu : R) (n : Z) (nu1 : Z) (mu1 : Z) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 n nu1 mu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m nu n nu1 mu1 * (p - q)).
Definition b2_true (m : Z) (mu : R) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
Definition c1 (n : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)).
Definition b3_true (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  3 * c1 n mu1 + 12 * (IZR n - 2) * PI ^ 2 * (1 + IZR mu1 - IZR nu1).
Definition b5_true (m : Z) (mu : R) (nu : R) : R :=
  6 * (IZR m - 2) * PI ^ 2 * (mu + 2 * nu - 1).
Definition b4_true (m : Z) (nu : R) (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  a m nu n mu1 * (3 * c1 n mu1 + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * IZR mu1 - IZR nu1) - PI ^ 3 * (1 + IZR mu1)) - a3_true m nu n nu1 mu1 * b3_true n nu1 mu1 / a1 n nu1 mu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (nu : R) (n : Z) (nu1 : Z) (mu1 : Z) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 n nu1 mu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 n nu1 mu1 * b3_true n nu1 mu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true n nu1 mu1 / a1 n nu1 mu1 * (q - r) - b4_true m nu n nu1 mu1 * (p - q)).
Definition next (m : Z) (mu : R) (nu : R) (p : R) (q : R) (r : R) (s : R) (t : Z) : R :=
  f (IZR t) 0 0 0%Z 3%Z * p + f (IZR t) 0 0 1%Z 3%Z * join1 m nu 3%Z 0%Z p q + f (IZR t) 0 0 2%Z 3%Z * join2 m mu nu 3%Z 0%Z 0%Z p q r + f (IZR t) 0 0 3%Z 3%Z * join3 m mu nu 3%Z 0%Z 0%Z p q r s.
Definition onF (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z.
Definition next_ (m : Z) (mu : R) (nu : R) (p : R) (q : R) (r : R) (s : R) (t : R) : R :=
  f t 0 0 0%Z 3%Z * p + f t 0 0 1%Z 3%Z * join1 m nu 3%Z 0%Z p q + f t 0 0 2%Z 3%Z * join2 m mu nu 3%Z 0%Z 0%Z p q r + f t 0 0 3%Z 3%Z * join3 m mu nu 3%Z 0%Z 0%Z p q r s.
Definition onF_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next_ m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z.
End Definitions.
Import Definitions.

Module tab_1_1_proposed.
(* gbt-surfaces/tab-1.1.proposed, Table 1, row 1, proposed method
   printed: The GBTB functions are constructed with only two shape parameters.
   read as: The curve, whose coefficients are the functions of its order, changes with both shape parameters; the formulas (1) and (2) have no other.
   stated: fails(D(F'(0), mu) == 0) and fails(D(F'(1), nu) == 0) *)
Definition F (Q : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => F Q m nu mu_ z_) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu_ z__) 1 (IZR z_)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End tab_1_1_proposed.

Module tab_1_2_proposed.
(* gbt-surfaces/tab-1.2.proposed, Table 1, row 2, proposed method
   printed: Two GBT-Bézier general cylinders can be connected by higher C2 continuity smoothness.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(cylinder(onF(z), z1), z, 0) == at(cylinder(F(z), z1), z, 1) and at(D(cylinder(onF(z), z1), z, 1), z, 0) == at(D(cylinder(F(z), z1), z, 1), z, 1) and at(D(cylinder(onF(z), z1), z, 2), z, 0) == at(D(cylinder(F(z), z1), z, 2), z, 1) *)
Definition cylinder (V : R) (alpha : R) (C_ : R) (z1 : R) : R :=
  C_ + z1 * alpha * V.
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 3%Z 0%Z 0%Z <> 0 ->
  b1 3%Z 0%Z 0%Z <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  cylinder V alpha (onF Q m mu nu 0%Z) z1 = cylinder V alpha (F Q m mu nu 1%Z) z1 /\ (let z := 0%Z in Derive_n (fun z_ => cylinder V alpha (onF_ Q m mu nu z_) z1) 1 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => cylinder V alpha (F_ Q m mu nu z_) z1) 1 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => cylinder V alpha (onF_ Q m mu nu z_) z1) 2 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => cylinder V alpha (F_ Q m mu nu z_) z1) 2 (IZR z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 3%Z 0%Z 0%Z <> 0 /\
  b1 3%Z 0%Z 0%Z <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_2_proposed.

Module tab_1_3_proposed.
(* gbt-surfaces/tab-1.3.proposed, Table 1, row 3, proposed method
   printed: Two GBT-Bézier ruled surfaces can be connected by higher Ck (k = 2, 3) continuity constraints.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(ruled(onF(z), onG(z), z1), z, 0) == at(ruled(F(z), G(z), z1), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 1), z, 0) == at(D(ruled(F(z), G(z), z1), z, 1), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 2), z, 0) == at(D(ruled(F(z), G(z), z1), z, 2), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 3), z, 0) == at(D(ruled(F(z), G(z), z1), z, 3), z, 1) *)
Definition onG (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  next m mu nu (P m) (P (m - 1)%Z) (P (m - 2)%Z) (P (m - 3)%Z) z.
Definition G (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * P k).
Definition onG_ (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next_ m mu nu (P m) (P (m - 1)%Z) (P (m - 2)%Z) (P (m - 3)%Z) z.
Definition G_ (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * P k).
Definition ruled (C_ : R) (E_ : R) (z1 : R) : R :=
  (1 - z1) * C_ + z1 * E_.
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (Q : Z -> R) (mu : R) (nu : R) (z1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 3%Z 0%Z 0%Z <> 0 ->
  b1 3%Z 0%Z 0%Z <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  ruled (onF Q m mu nu 0%Z) (onG P m mu nu 0%Z) z1 = ruled (F Q m mu nu 1%Z) (G P m mu nu 1%Z) z1 /\ (let z := 0%Z in Derive_n (fun z_ => ruled (onF_ Q m mu nu z_) (onG_ P m mu nu z_) z1) 1 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => ruled (F_ Q m mu nu z_) (G_ P m mu nu z_) z1) 1 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => ruled (onF_ Q m mu nu z_) (onG_ P m mu nu z_) z1) 2 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => ruled (F_ Q m mu nu z_) (G_ P m mu nu z_) z1) 2 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => ruled (onF_ Q m mu nu z_) (onG_ P m mu nu z_) z1) 3 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => ruled (F_ Q m mu nu z_) (G_ P m mu nu z_) z1) 3 (IZR z)).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (Q : Z -> R) (mu : R) (nu : R) (z1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 3%Z 0%Z 0%Z <> 0 /\
  b1 3%Z 0%Z 0%Z <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_3_proposed.

Module tab_1_4_proposed.
(* gbt-surfaces/tab-1.4.proposed, Table 1, row 4, proposed method
   printed: Two adjacent GBT-Bézier swung surfaces can be connected by higher C2 continuity conditions.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(swung(onX(z), onZ(z)), z, 0) == at(swung(FX(z), FZ(z)), z, 1) and at(D(swung(onX(z), onZ(z)), z, 1), z, 0) == at(D(swung(FX(z), FZ(z)), z, 1), z, 1) and at(D(swung(onX(z), onZ(z)), z, 2), z, 0) == at(D(swung(FX(z), FZ(z)), z, 2), z, 1) *)
Definition onX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  next m mu nu (X m) (X (m - 1)%Z) (X (m - 2)%Z) (X (m - 3)%Z) z.
Definition onZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  next m mu nu (Z_ m) (Z_ (m - 1)%Z) (Z_ (m - 2)%Z) (Z_ (m - 3)%Z) z.
Definition FX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Z_ k).
Definition onX_ (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next_ m mu nu (X m) (X (m - 1)%Z) (X (m - 2)%Z) (X (m - 3)%Z) z.
Definition onZ_ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next_ m mu nu (Z_ m) (Z_ (m - 1)%Z) (Z_ (m - 2)%Z) (Z_ (m - 3)%Z) z.
Definition FX_ (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ_ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition swung (lambda : R) (u : R) (v : R) (x : R) (w : R) : list R :=
  [lambda * x * u; lambda * x * v; w].
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R),
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 3%Z 0%Z 0%Z <> 0 ->
  b1 3%Z 0%Z 0%Z <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  swung lambda u v (onX X m mu nu 0%Z) (onZ Z_ m mu nu 0%Z) = swung lambda u v (FX X m mu nu 1%Z) (FZ Z_ m mu nu 1%Z) /\ (let z := 0%Z in vDerive 3 (fun z_ => swung lambda u v (onX_ X m mu nu z_) (onZ_ Z_ m mu nu z_)) 1 (IZR z)) = (let z := 1%Z in vDerive 3 (fun z_ => swung lambda u v (FX_ X m mu nu z_) (FZ_ Z_ m mu nu z_)) 1 (IZR z)) /\ (let z := 0%Z in vDerive 3 (fun z_ => swung lambda u v (onX_ X m mu nu z_) (onZ_ Z_ m mu nu z_)) 2 (IZR z)) = (let z := 1%Z in vDerive 3 (fun z_ => swung lambda u v (FX_ X m mu nu z_) (FZ_ Z_ m mu nu z_)) 2 (IZR z)).
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R),
  0 < lambda /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 3%Z 0%Z 0%Z <> 0 /\
  b1 3%Z 0%Z 0%Z <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_4_proposed.

Module tab_1_5_proposed.
(* gbt-surfaces/tab-1.5.proposed, Table 1, row 5, proposed method
   printed: Two adjacent GBT-Bézier swept surfaces can be connected by higher C1 and C2 continuity smoothness.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(swept(onF(z)), z, 0) == at(swept(F(z)), z, 1) and at(D(swept(onF(z)), z, 1), z, 0) == at(D(swept(F(z)), z, 1), z, 1) and at(D(swept(onF(z)), z, 2), z, 0) == at(D(swept(F(z)), z, 2), z, 1) *)
Definition swept (W : R) (C_ : R) : R :=
  C_ + W.
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (W : R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 ->
  a1 3%Z 0%Z 0%Z <> 0 ->
  b1 3%Z 0%Z 0%Z <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  swept W (onF Q m mu nu 0%Z) = swept W (F Q m mu nu 1%Z) /\ (let z := 0%Z in Derive_n (fun z_ => swept W (onF_ Q m mu nu z_)) 1 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => swept W (F_ Q m mu nu z_)) 1 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => swept W (onF_ Q m mu nu z_)) 2 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => swept W (F_ Q m mu nu z_)) 2 (IZR z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (W : R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  2 * (IZR 3%Z - 2) + PI * (1 + IZR 0%Z) <> 0 /\
  a1 3%Z 0%Z 0%Z <> 0 /\
  b1 3%Z 0%Z 0%Z <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_5_proposed.
