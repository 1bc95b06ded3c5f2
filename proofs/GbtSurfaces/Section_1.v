(* Statements of gbt-surfaces, Section 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
End Definitions.
Import Definitions.

Module sec_1_contrib_1.
(* gbt-surfaces/sec-1.contrib-1, Sect. 1, contributions, item 1
   printed: Construction of a tensor product GBT-Bézier surface by a new set of GBTB functions with two shape parameters
   read as: The tangents of the surface at the corners change with the shape parameters of their direction, two in each.
   stated: fails(D(Tz0(0), mu) == 0) and fails(D(Tz1end(0), nu) == 0) and fails(D(Tz1(0), mu1) == 0) and fails(D(Tzz1end(0), nu1) == 0) *)
Definition Tz0 (G : Z -> Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (mu : R) (z1 : Z) : R :=
  sum 0%Z n (fun l => f (IZR z1) mu1 nu1 l n * (let z := 0%Z in Derive_n (fun z_ => sum 0%Z m (fun k => f z_ mu nu k m * G k l)) 1 (IZR z))).
Definition Tz1end (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu1 : R) (nu : R) (z1 : Z) : R :=
  sum 0%Z n (fun l => f (IZR z1) mu1 nu1 l n * (let z := 1%Z in Derive_n (fun z_ => sum 0%Z m (fun k => f z_ mu nu k m * G k l)) 1 (IZR z))).
Definition Tz1 (G : Z -> Z -> R) (m : Z) (mu : R) (n : Z) (nu : R) (nu1 : R) (mu1 : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * (let z1 := 0%Z in Derive_n (fun z1_ => sum 0%Z n (fun l => f z1_ mu1 nu1 l n * G k l)) 1 (IZR z1))).
Definition Tzz1end (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * (let z1 := 1%Z in Derive_n (fun z1_ => sum 0%Z n (fun l => f z1_ mu1 nu1 l n * G k l)) 1 (IZR z1))).
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun mu_ => Tz0 G m mu1 n nu nu1 mu_ 0%Z) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun nu_ => Tz1end G m mu mu1 n nu1 nu_ 0%Z) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun mu1_ => Tz1 G m mu n nu nu1 mu1_ 0%Z) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun nu1_ => Tzz1end G m mu mu1 n nu nu1_ 0%Z) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End sec_1_contrib_1.

Module sec_1_contrib_2.
(* gbt-surfaces/sec-1.contrib-2, Sect. 1, contributions, item 2
   printed: Construction of some computer-based engineering surfaces using GBT-Bézier with shape parameters
   read as: The tangents of the surfaces change with mu and nu. In the rotation surface u and v are the cosine and the sine of the angle; of the bi-linear surface (16) the boundary z_1 = 0 is taken.
   stated: fails(D(at(D(cylinder(F(z), z1), z), z, 0), mu) == 0) and fails(D(at(D(cylinder(F(z), z1), z), z, 1), nu) == 0) and fails(D(at(D(ruled(F(z), G(z), z1), z), z, 0), mu) == 0) and fails(D(at(D(ruled(F(z), G(z), z1), z), z, 1), nu) == 0) and fails(D(at(D(swept(F(z)), z), z, 0), mu) == 0) and fails(D(at(D(swept(F(z)), z), z, 1), nu) == 0) and fails(D(at(D(swung(FX(z), FZ(z)), z), z, 0), mu) == 0) and fails(D(at(D(swung(FX(z), FZ(z)), z), z, 1), nu) == 0) and fails(D(at(D([u*FX(z), v*FX(z), FZ(z)], z), z, 0), mu) == 0) and fails(D(at(D([u*FX(z), v*FX(z), FZ(z)], z), z, 1), nu) == 0) and fails(D(at(D(N(z), z), z, 0), mu) == 0) and fails(D(at(D(N(z), z), z, 1), nu) == 0) *)
Definition F (Q : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition cylinder (V : R) (alpha : R) (C_ : R) (z1 : R) : R :=
  C_ + z1 * alpha * V.
Definition G (P : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * P k).
Definition ruled (C_ : R) (E_ : R) (z1 : R) : R :=
  (1 - z1) * C_ + z1 * E_.
Definition G_ (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * P k).
Definition swept (W : R) (C_ : R) : R :=
  C_ + W.
Definition FX (X : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition swung (lambda : R) (u : R) (v : R) (x : R) (w : R) : list R :=
  [lambda * x * u; lambda * x * v; w].
Definition FX_ (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ_ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition N_ (N2 : Z -> Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * N2 k 0%Z).
Definition N__ (N2 : Z -> Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * N2 k 0%Z).
Definition statement : Prop :=
forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => cylinder V alpha (F Q m nu mu_ z_) z1) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => cylinder V alpha (F_ Q m mu nu_ z_) z1) 1 (IZR z)) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => ruled (F Q m nu mu_ z_) (G P m nu mu_ z_) z1) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => ruled (F_ Q m mu nu_ z_) (G_ P m mu nu_ z_) z1) 1 (IZR z)) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => swept W (F Q m nu mu_ z_)) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => swept W (F_ Q m mu nu_ z_)) 1 (IZR z)) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun mu_ => let z := 0%Z in vDerive 3 (fun z_ => swung lambda u v (FX X m nu mu_ z_) (FZ Z_ m nu mu_ z_)) 1 (IZR z)) 1 mu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun nu_ => let z := 1%Z in vDerive 3 (fun z_ => swung lambda u v (FX_ X m mu nu_ z_) (FZ_ Z_ m mu nu_ z_)) 1 (IZR z)) 1 nu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun mu_ => let z := 0%Z in vDerive 3 (fun z_ => [u * FX X m nu mu_ z_; v * FX X m nu mu_ z_; FZ Z_ m nu mu_ z_]) 1 (IZR z)) 1 mu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun nu_ => let z := 1%Z in vDerive 3 (fun z_ => [u * FX_ X m mu nu_ z_; v * FX_ X m mu nu_ z_; FZ_ Z_ m mu nu_ z_]) 1 (IZR z)) 1 nu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => N_ N2 m nu mu_ z_) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => N__ N2 m mu nu_ z_) 1 (IZR z)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha /\
  0 < lambda /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  0 <= z1 <= 1.
End sec_1_contrib_2.

Module sec_1_contrib_3_by_the_printed_conditions.
(* gbt-surfaces/sec-1.contrib-3.by the printed conditions, Sect. 1, contributions, item 3
   printed: The complex computer-based engineering surfaces using GBT-Bézier patches are composed by Ck (k = 1, 2, 3) continuity conditions
   read as: The compositions are made with Theorem 2 as printed.
   stated: F1'(0) == F'(1) and F1''(0) == F''(1) and F1'''(0) == F'''(1) *)
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition printed11 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
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
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
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
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F1 Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F Q m mu nu z____) 2 (IZR z___)) /\ (let z____ := 0%Z in Derive_n (fun z_____ => F1 Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F Q m mu nu z______) 3 (IZR z_____)).
End sec_1_contrib_3_by_the_printed_conditions.

Module sec_1_contrib_3_there_are_such_compositions.
(* gbt-surfaces/sec-1.contrib-3.there are such compositions, Sect. 1, contributions, item 3
   printed: The complex computer-based engineering surfaces using GBT-Bézier patches are composed by Ck (k = 1, 2, 3) continuity conditions
   read as: Such compositions can be made: exhibited for every first curve, with a cubic of vanishing shape parameters for the second.
   stated: at(onF(z), z, 0) == at(F(z), z, 1) and at(D(onF(z), z, 1), z, 0) == at(D(F(z), z, 1), z, 1) and at(D(onF(z), z, 2), z, 0) == at(D(F(z), z, 2), z, 1) and at(D(onF(z), z, 3), z, 0) == at(D(F(z), z, 3), z, 1) *)
Definition a1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + IZR mu1)) + PI ^ 2 * (1 - IZR nu1).
Definition b1 (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - IZR nu1).
Definition a (m : Z) (nu : R) (n : Z) (mu1 : Z) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + IZR mu1)).
Definition join1 (m : Z) (nu : R) (n : Z) (mu1 : Z) (p : R) (q : R) : R :=
  p + a m nu n mu1 * (p - q).
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
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition next_ (m : Z) (mu : R) (nu : R) (p : R) (q : R) (r : R) (s : R) (t : R) : R :=
  f t 0 0 0%Z 3%Z * p + f t 0 0 1%Z 3%Z * join1 m nu 3%Z 0%Z p q + f t 0 0 2%Z 3%Z * join2 m mu nu 3%Z 0%Z 0%Z p q r + f t 0 0 3%Z 3%Z * join3 m mu nu 3%Z 0%Z 0%Z p q r s.
Definition onF_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  next_ m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z.
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
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
  onF Q m mu nu 0%Z = F Q m mu nu 1%Z /\ (let z := 0%Z in Derive_n (fun z_ => onF_ Q m mu nu z_) 1 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => F_ Q m mu nu z_) 1 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => onF_ Q m mu nu z_) 2 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => F_ Q m mu nu z_) 2 (IZR z)) /\ (let z := 0%Z in Derive_n (fun z_ => onF_ Q m mu nu z_) 3 (IZR z)) = (let z := 1%Z in Derive_n (fun z_ => F_ Q m mu nu z_) 3 (IZR z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
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
End sec_1_contrib_3_there_are_such_compositions.
