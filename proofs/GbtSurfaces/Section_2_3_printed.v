(* Statements of gbt-surfaces, Section 2 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition T (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * sum 0%Z m (fun k => f z mu nu k m * G k l)).
Definition Tz0 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * (fun z : R => Derive_n (fun z => sum 0%Z m (fun k => f z mu nu k m * G k l)) 1 z) 0).
Definition Tz1 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * (fun z : R => Derive_n (fun z => sum 0%Z m (fun k => f z mu nu k m * G k l)) 1 z) 1).
Definition Tu0 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (fun z1 : R => Derive_n (fun z1 => sum 0%Z n (fun l => f z1 mu1 nu1 l n * G k l)) 1 z1) 0).
Definition Tu1 (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (fun z1 : R => Derive_n (fun z1 => sum 0%Z n (fun l => f z1 mu1 nu1 l n * G k l)) 1 z1) 1).
End Definitions.
Import Definitions.

Module eq_7.
(* gbt-surfaces/eq-7, Sect. 2.3, Definition 3, eq. (7)
   printed: T_{m,n}(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{n} Q_{k,l} f_{k,m}(z) f_{l,n}(z_1), z, z_1 ∈ [0,1]
   read as: The formula: a curve of curves. The weights of the control points sum to one, so the surface does not depend on the origin.
   stated: sum(k, 0, m, sum(l, 0, n, G[k,l]*f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1))) == T(z, z1) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, n, f[l,n](z1, mu1, nu1))) == 1 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => G k l * f z mu nu k m * f z1 mu1 nu1 l n)) = T G m mu mu1 n nu nu1 z z1 /\ sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n)) = 1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z).
End eq_7.

Module sec_2_3_features_a.
(* gbt-surfaces/sec-2.3.features.a, Sect. 2.3, sentence after eq. (7)
   printed: As the GBT-Bézier surfaces are defined on the bases of GBT-Bézier curves, so they have all the features that the GBT-Bézier curves have.
   read as: Convex hull and affine invariance: nonnegative weights that sum to one.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, n, f[l,n](z1, mu1, nu1))) == 1 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n)) = 1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_2_3_features_a.

Module sec_2_3_features_b.
(* gbt-surfaces/sec-2.3.features.b, Sect. 2.3, sentence after eq. (7)
   printed: As the GBT-Bézier surfaces are defined on the bases of GBT-Bézier curves, so they have all the features that the GBT-Bézier curves have.
   read as: End points: the surface interpolates the corners of its net.
   stated: T(0, 0) == G[0,0] and T(1, 0) == G[m,0] and T(0, 1) == G[0,n] and T(1, 1) == G[m,n] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= n <= n)%Z ->
  T G m mu mu1 n nu nu1 0 0 = G 0%Z 0%Z /\ T G m mu mu1 n nu nu1 1 0 = G m 0%Z /\ T G m mu mu1 n nu nu1 0 1 = G 0%Z n /\ T G m mu mu1 n nu nu1 1 1 = G m n.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= n <= n)%Z.
End sec_2_3_features_b.

Module sec_2_3_features_c.
(* gbt-surfaces/sec-2.3.features.c, Sect. 2.3, sentence after eq. (7)
   printed: As the GBT-Bézier surfaces are defined on the bases of GBT-Bézier curves, so they have all the features that the GBT-Bézier curves have.
   read as: The tangents at the corners change with all four shape parameters.
   stated: fails(D(Tz0(0), mu) == 0) and fails(D(Tz1(0), nu) == 0) and fails(D(Tu0(0), mu1) == 0) and fails(D(Tu1(0), nu1) == 0) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun mu => Tz0 G m mu mu1 n nu nu1 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun nu => Tz1 G m mu mu1 n nu nu1 0) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun mu1 => Tu0 G m mu mu1 n nu nu1 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun nu1 => Tu1 G m mu mu1 n nu nu1 0) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End sec_2_3_features_c.

Module sec_2_3_features_d.
(* gbt-surfaces/sec-2.3.features.d, Sect. 2.3, sentence after eq. (7)
   printed: As the GBT-Bézier surfaces are defined on the bases of GBT-Bézier curves, so they have all the features that the GBT-Bézier curves have.
   read as: Symmetry: the net in reverse order in one direction, with the parameters of that direction exchanged, gives the same surface, run through backwards.
   stated: sum(l, 0, n, f[l,n](z1, mu1, nu1)*sum(k, 0, m, f[k,m](z, nu, mu)*G[m-k,l])) == T(1 - z, z1) and sum(l, 0, n, f[l,n](z1, nu1, mu1)*sum(k, 0, m, f[k,m](z, mu, nu)*G[k,n-l])) == T(z, 1 - z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= n - l <= n)%Z) ->
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * sum 0%Z m (fun k => f z nu mu k m * G (m - k)%Z l)) = T G m mu mu1 n nu nu1 (1 - z) z1 /\ sum 0%Z n (fun l => f z1 nu1 mu1 l n * sum 0%Z m (fun k => f z mu nu k m * G k (n - l)%Z)) = T G m mu mu1 n nu nu1 z (1 - z1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= n - l <= n)%Z).
End sec_2_3_features_d.

Module sec_2_3_classical_the_features_of_Sect__2_2.
(* gbt-surfaces/sec-2.3.classical.the features of Sect. 2.2, Sect. 2.3, paragraph after eq. (7)
   printed: The tensor product GBT-Bézier surfaces shares all the properties with classical tensor product Bézier surfaces except for the shape adjustable property which is superior to the properties of classical tensor product Bézier surfaces.
   read as: The properties are those that Sect. 2.2 lists for curves, but for variation diminution: convex hull, affine invariance, interpolation of the corners, symmetry with the parameters exchanged; and the tangents at the corners change with the shape parameters.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, n, f[l,n](z1, mu1, nu1))) == 1 and T(0, 0) == G[0,0] and T(1, 0) == G[m,0] and T(0, 1) == G[0,n] and T(1, 1) == G[m,n] and sum(l, 0, n, f[l,n](z1, mu1, nu1)*sum(k, 0, m, f[k,m](z, nu, mu)*G[m-k,l])) == T(1 - z, z1) and fails(D(Tz0(0), mu) == 0) and fails(D(Tz1(0), nu) == 0) and fails(D(Tu0(0), mu1) == 0) and fails(D(Tu1(0), nu1) == 0) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= n <= n)%Z ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) ->
  (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n)) = 1 /\ T G m mu mu1 n nu nu1 0 0 = G 0%Z 0%Z /\ T G m mu mu1 n nu nu1 1 0 = G m 0%Z /\ T G m mu mu1 n nu nu1 0 1 = G 0%Z n /\ T G m mu mu1 n nu nu1 1 1 = G m n /\ sum 0%Z n (fun l => f z1 mu1 nu1 l n * sum 0%Z m (fun k => f z nu mu k m * G (m - k)%Z l)) = T G m mu mu1 n nu nu1 (1 - z) z1 /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun mu => Tz0 G m mu mu1 n nu nu1 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  Derive_n (fun nu => Tz1 G m mu mu1 n nu nu1 0) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun mu1 => Tu0 G m mu mu1 n nu nu1 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  Derive_n (fun nu1 => Tu1 G m mu mu1 n nu nu1 0) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= n <= n)%Z /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z).
End sec_2_3_classical_the_features_of_Sect__2_2.

Module sec_2_3_classical_every_property.
(* gbt-surfaces/sec-2.3.classical.every property, Sect. 2.3, paragraph after eq. (7)
   printed: The tensor product GBT-Bézier surfaces shares all the properties with classical tensor product Bézier surfaces except for the shape adjustable property which is superior to the properties of classical tensor product Bézier surfaces.
   read as: A Bézier surface over an evenly spaced net of a plane has the parameters as coordinates (linear precision).
   stated: sum(l, 0, n, f[l,n](z1, mu1, nu1)*sum(k, 0, m, f[k,m](z, mu, nu)*[k/m, l/n])) == [z, z1] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> IZR m <> 0) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> IZR n <> 0) ->
  vsum 2 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) (vsum 2 0%Z m (fun k => vscale (f z mu nu k m) [IZR k / IZR m; IZR l / IZR n]))) = [z; z1].
End sec_2_3_classical_every_property.
