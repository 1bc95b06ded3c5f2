(* Statements of gbt-surfaces, Section 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition b1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition c1 (mu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
End Definitions.
Import Definitions.

Module sec_1_contrib_1.
(* gbt-surfaces/sec-1.contrib-1, Sect. 1, contributions, item 1
   printed: Construction of a tensor product GBT-Bézier surface by a new set of GBTB functions with two shape parameters
   read as: The tangents of the surface at the corners change with the shape parameters of their direction, two in each.
   stated: fails(D(Tz0(0), mu) == 0) and fails(D(Tz1end(0), nu) == 0) and fails(D(Tz1(0), mu1) == 0) and fails(D(Tzz1end(0), nu1) == 0) *)
Definition Tz0 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * (fun z : R => Derive_n (fun z => sum 0%Z m (fun k => f z mu nu k m * G k l)) 1 z) 0).
Definition Tz1end (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * (fun z : R => Derive_n (fun z => sum 0%Z m (fun k => f z mu nu k m * G k l)) 1 z) 1).
Definition Tz1 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (fun z1 : R => Derive_n (fun z1 => sum 0%Z n (fun l => f z1 mu1 nu1 l n * G k l)) 1 z1) 0).
Definition Tzz1end (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (fun z1 : R => Derive_n (fun z1 => sum 0%Z n (fun l => f z1 mu1 nu1 l n * G k l)) 1 z1) 1).
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
  Derive_n (fun mu => Tz0 G m mu mu1 n nu nu1 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun nu => Tz1end G m mu mu1 n nu nu1 0) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun mu1 => Tz1 G m mu mu1 n nu nu1 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun nu1 => Tzz1end G m mu mu1 n nu nu1 0) 1 nu1 = 0).
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
Definition cylinder (V : R) (alpha : R) (C_ : R) (z1 : R) : R :=
  C_ + z1 * alpha * V.
Definition G (P : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * P k).
Definition ruled (C_ : R) (E_ : R) (z1 : R) : R :=
  (1 - z1) * C_ + z1 * E_.
Definition swept (W : R) (C_ : R) : R :=
  C_ + W.
Definition FX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition swung (lambda : R) (u : R) (v : R) (x : R) (w : R) : list R :=
  [lambda * x * u; lambda * x * v; w].
Definition N_ (N2 : Z -> Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
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
  Derive_n (fun mu => (fun z : R => Derive_n (fun z => cylinder V alpha (F Q m mu nu z) z1) 1 z) 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => (fun z : R => Derive_n (fun z => cylinder V alpha (F Q m mu nu z) z1) 1 z) 1) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => (fun z : R => Derive_n (fun z => ruled (F Q m mu nu z) (G P m mu nu z) z1) 1 z) 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => (fun z : R => Derive_n (fun z => ruled (F Q m mu nu z) (G P m mu nu z) z1) 1 z) 1) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => (fun z : R => Derive_n (fun z => swept W (F Q m mu nu z)) 1 z) 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => (fun z : R => Derive_n (fun z => swept W (F Q m mu nu z)) 1 z) 1) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun mu => (fun z : R => vDerive 3 (fun z => swung lambda u v (FX X m mu nu z) (FZ Z_ m mu nu z)) 1 z) 0) 1 mu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun nu => (fun z : R => vDerive 3 (fun z => swung lambda u v (FX X m mu nu z) (FZ Z_ m mu nu z)) 1 z) 1) 1 nu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun mu => (fun z : R => vDerive 3 (fun z => [u * FX X m mu nu z; v * FX X m mu nu z; FZ Z_ m mu nu z]) 1 z) 0) 1 mu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  vDerive 3 (fun nu => (fun z : R => vDerive 3 (fun z => [u * FX X m mu nu z; v * FX X m mu nu z; FZ Z_ m mu nu z]) 1 z) 1) 1 nu = zeros 3) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  Derive_n (fun mu => (fun z : R => Derive_n (fun z => N_ N2 m mu nu z) 1 z) 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (N2 : Z -> Z -> R) (P : Z -> R) (Q : Z -> R) (V : R) (W : R) (X : Z -> R) (Z_ : Z -> R) (alpha : R) (lambda : R) (mu : R) (nu : R) (u : R) (v : R) (z1 : R),
  0 < alpha ->
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  Derive_n (fun nu => (fun z : R => Derive_n (fun z => N_ N2 m mu nu z) 1 z) 1) 1 nu = 0).
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
Definition printed11 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z).
Definition a3 (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  2 * a1 mu1 n nu1 + PI ^ 2 * (1 + 2 * mu1 - nu1) + 2 * PI ^ 2 * nu.
Definition printed12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + a3 mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition b2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)).
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - nu1).
Definition b4 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3 mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
Definition printed13 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / b1 mu1 n nu1 * (b2 m nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (Q (m - 1)%Z - Q (m - 2)%Z) - b4 m mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
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
  Derive_n (fun z => F1 Q1 mu1 n nu1 z) 1 0 = Derive_n (fun z => F Q m mu nu z) 1 1 /\ Derive_n (fun z => F1 Q1 mu1 n nu1 z) 2 0 = Derive_n (fun z => F Q m mu nu z) 2 1 /\ Derive_n (fun z => F1 Q1 mu1 n nu1 z) 3 0 = Derive_n (fun z => F Q m mu nu z) 3 1.
End sec_1_contrib_3_by_the_printed_conditions.

Module sec_1_contrib_3_there_are_such_compositions.
(* gbt-surfaces/sec-1.contrib-3.there are such compositions, Sect. 1, contributions, item 3
   printed: The complex computer-based engineering surfaces using GBT-Bézier patches are composed by Ck (k = 1, 2, 3) continuity conditions
   read as: Such compositions can be made: exhibited for every first curve, with a cubic of vanishing shape parameters for the second.
   stated: at(onF(z), z, 0) == at(F(z), z, 1) and at(D(onF(z), z, 1), z, 0) == at(D(F(z), z, 1), z, 1) and at(D(onF(z), z, 2), z, 0) == at(D(F(z), z, 2), z, 1) and at(D(onF(z), z, 3), z, 0) == at(D(F(z), z, 3), z, 1) *)
Definition join1 (m : Z) (mu1 : R) (n : Z) (nu : R) (p : R) (q : R) : R :=
  p + a m mu1 n nu * (p - q).
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition b2_true (m : Z) (mu : R) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
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
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
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
  (fun z : R => onF Q m mu nu z) 0 = (fun z : R => F Q m mu nu z) 1 /\ (fun z : R => Derive_n (fun z => onF Q m mu nu z) 1 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 1 z) 1 /\ (fun z : R => Derive_n (fun z => onF Q m mu nu z) 2 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 2 z) 1 /\ (fun z : R => Derive_n (fun z => onF Q m mu nu z) 3 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 3 z) 1.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
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
End sec_1_contrib_3_there_are_such_compositions.
