(* Statements of gbt-surfaces, Part Table. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition b1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition join1 (m : Z) (mu1 : R) (n : Z) (nu : R) (p : R) (q : R) : R :=
  p + a m mu1 n nu * (p - q).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition b2_true (m : Z) (mu : R) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
Definition c1 (mu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
Definition b3_true (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 + mu1 - nu1).
Definition b5_true (m : Z) (mu : R) (nu : R) : R :=
  6 * (IZR m - 2) * PI ^ 2 * (mu + 2 * nu - 1).
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition next (m : Z) (mu : R) (nu : R) (p : R) (q : R) (r : R) (s : R) (t : R) : R :=
  f t 0 0 0%Z 3%Z * p + f t 0 0 1%Z 3%Z * (fun n : Z => (fun mu1 : R => join1 m mu1 n nu p q) 0) 3%Z + f t 0 0 2%Z 3%Z * (fun n : Z => (fun nu1 : R => (fun mu1 : R => join2 m mu mu1 n nu nu1 p q r) 0) 0) 3%Z + f t 0 0 3%Z 3%Z * (fun n : Z => (fun nu1 : R => (fun mu1 : R => join3 m mu mu1 n nu nu1 p q r s) 0) 0) 3%Z.
Definition onF (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z.
End Definitions.
Import Definitions.

Module tab_1_1_proposed.
(* gbt-surfaces/tab-1.1.proposed, Table 1, row 1, proposed method
   printed: The GBTB functions are constructed with only two shape parameters.
   read as: The curve, whose coefficients are the functions of its order, changes with both shape parameters; the formulas (1) and (2) have no other.
   stated: fails(D(F'(0), mu) == 0) and fails(D(F'(1), nu) == 0) *)
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
  Derive_n (fun mu => Derive_n (fun z => F Q m mu nu z) 1 0) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => Derive_n (fun z => F Q m mu nu z) 1 1) 1 nu = 0).
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
  2 * (3 - 2) + PI * (1 + 0) <> 0 ->
  a1 0 3%Z 0 <> 0 ->
  b1 0 3%Z 0 <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (fun z : R => cylinder V alpha (onF Q m mu nu z) z1) 0 = (fun z : R => cylinder V alpha (F Q m mu nu z) z1) 1 /\ (fun z : R => Derive_n (fun z => cylinder V alpha (onF Q m mu nu z) z1) 1 z) 0 = (fun z : R => Derive_n (fun z => cylinder V alpha (F Q m mu nu z) z1) 1 z) 1 /\ (fun z : R => Derive_n (fun z => cylinder V alpha (onF Q m mu nu z) z1) 2 z) 0 = (fun z : R => Derive_n (fun z => cylinder V alpha (F Q m mu nu z) z1) 2 z) 1.
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
  2 * (3 - 2) + PI * (1 + 0) <> 0 /\
  a1 0 3%Z 0 <> 0 /\
  b1 0 3%Z 0 <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_2_proposed.

Module tab_1_3_proposed.
(* gbt-surfaces/tab-1.3.proposed, Table 1, row 3, proposed method
   printed: Two GBT-Bézier ruled surfaces can be connected by higher Ck (k = 2, 3) continuity constraints.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(ruled(onF(z), onG(z), z1), z, 0) == at(ruled(F(z), G(z), z1), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 1), z, 0) == at(D(ruled(F(z), G(z), z1), z, 1), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 2), z, 0) == at(D(ruled(F(z), G(z), z1), z, 2), z, 1) and at(D(ruled(onF(z), onG(z), z1), z, 3), z, 0) == at(D(ruled(F(z), G(z), z1), z, 3), z, 1) *)
Definition onG (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next m mu nu (P m) (P (m - 1)%Z) (P (m - 2)%Z) (P (m - 3)%Z) z.
Definition G (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
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
  2 * (3 - 2) + PI * (1 + 0) <> 0 ->
  a1 0 3%Z 0 <> 0 ->
  b1 0 3%Z 0 <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (fun z : R => ruled (onF Q m mu nu z) (onG P m mu nu z) z1) 0 = (fun z : R => ruled (F Q m mu nu z) (G P m mu nu z) z1) 1 /\ (fun z : R => Derive_n (fun z => ruled (onF Q m mu nu z) (onG P m mu nu z) z1) 1 z) 0 = (fun z : R => Derive_n (fun z => ruled (F Q m mu nu z) (G P m mu nu z) z1) 1 z) 1 /\ (fun z : R => Derive_n (fun z => ruled (onF Q m mu nu z) (onG P m mu nu z) z1) 2 z) 0 = (fun z : R => Derive_n (fun z => ruled (F Q m mu nu z) (G P m mu nu z) z1) 2 z) 1 /\ (fun z : R => Derive_n (fun z => ruled (onF Q m mu nu z) (onG P m mu nu z) z1) 3 z) 0 = (fun z : R => Derive_n (fun z => ruled (F Q m mu nu z) (G P m mu nu z) z1) 3 z) 1.
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
  2 * (3 - 2) + PI * (1 + 0) <> 0 /\
  a1 0 3%Z 0 <> 0 /\
  b1 0 3%Z 0 <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_3_proposed.

Module tab_1_4_proposed.
(* gbt-surfaces/tab-1.4.proposed, Table 1, row 4, proposed method
   printed: Two adjacent GBT-Bézier swung surfaces can be connected by higher C2 continuity conditions.
   read as: Exhibited for every first surface, with a cubic of vanishing shape parameters for the second: the derivatives of the surface across the joint are compared.
   stated: at(swung(onX(z), onZ(z)), z, 0) == at(swung(FX(z), FZ(z)), z, 1) and at(D(swung(onX(z), onZ(z)), z, 1), z, 0) == at(D(swung(FX(z), FZ(z)), z, 1), z, 1) and at(D(swung(onX(z), onZ(z)), z, 2), z, 0) == at(D(swung(FX(z), FZ(z)), z, 2), z, 1) *)
Definition onX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next m mu nu (X m) (X (m - 1)%Z) (X (m - 2)%Z) (X (m - 3)%Z) z.
Definition onZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next m mu nu (Z_ m) (Z_ (m - 1)%Z) (Z_ (m - 2)%Z) (Z_ (m - 3)%Z) z.
Definition FX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition swung (lambda : R) (u : R) (v : R) (x : R) (w : R) : list R :=
  [lambda * x * u; lambda * x * v; w].
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R),
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  2 * (3 - 2) + PI * (1 + 0) <> 0 ->
  a1 0 3%Z 0 <> 0 ->
  b1 0 3%Z 0 <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (fun z : R => swung lambda u v (onX X m mu nu z) (onZ Z_ m mu nu z)) 0 = (fun z : R => swung lambda u v (FX X m mu nu z) (FZ Z_ m mu nu z)) 1 /\ (fun z : R => vDerive 3 (fun z => swung lambda u v (onX X m mu nu z) (onZ Z_ m mu nu z)) 1 z) 0 = (fun z : R => vDerive 3 (fun z => swung lambda u v (FX X m mu nu z) (FZ Z_ m mu nu z)) 1 z) 1 /\ (fun z : R => vDerive 3 (fun z => swung lambda u v (onX X m mu nu z) (onZ Z_ m mu nu z)) 2 z) 0 = (fun z : R => vDerive 3 (fun z => swung lambda u v (FX X m mu nu z) (FZ Z_ m mu nu z)) 2 z) 1.
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R),
  0 < lambda /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  2 * (3 - 2) + PI * (1 + 0) <> 0 /\
  a1 0 3%Z 0 <> 0 /\
  b1 0 3%Z 0 <> 0 /\
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
  2 * (3 - 2) + PI * (1 + 0) <> 0 ->
  a1 0 3%Z 0 <> 0 ->
  b1 0 3%Z 0 <> 0 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (fun z : R => swept W (onF Q m mu nu z)) 0 = (fun z : R => swept W (F Q m mu nu z)) 1 /\ (fun z : R => Derive_n (fun z => swept W (onF Q m mu nu z)) 1 z) 0 = (fun z : R => Derive_n (fun z => swept W (F Q m mu nu z)) 1 z) 1 /\ (fun z : R => Derive_n (fun z => swept W (onF Q m mu nu z)) 2 z) 0 = (fun z : R => Derive_n (fun z => swept W (F Q m mu nu z)) 2 z) 1.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (W : R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  2 * (3 - 2) + PI * (1 + 0) <> 0 /\
  a1 0 3%Z 0 <> 0 /\
  b1 0 3%Z 0 <> 0 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End tab_1_5_proposed.
