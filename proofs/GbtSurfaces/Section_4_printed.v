(* Statements of gbt-surfaces, Section 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition b (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - z) ^ 1 * z ^ 0; (1 - z) ^ 0 * z ^ 1] i k.
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

Module abs_features_the_features_of_Sect__2_2.
(* gbt-surfaces/abs.features.the features of Sect. 2.2, Abstract; repeated in Sect. 4
   printed: All geometric features of the proposed GBT-Bézier curves and surfaces are similar to the traditional Bézier curves and surfaces, but the shape-adjustment is the additional feature that the traditional Bézier curves and surfaces do not hold
   read as: The features are those that Sect. 2.2 lists, but for variation diminution, which is a claim of its own: convex hull, affine invariance, end points, symmetry for equal parameters; and the shape changes.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z)) == 1 and F(0) == Q[0] and F(1) == Q[m] and f[m-k,m](z, mu, mu) == f[k,m](1 - z, mu, mu) and fails(D(F'(0), mu) == 0) *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m) = 1 /\ F Q m mu nu 0 = Q 0%Z /\ F Q m mu nu 1 = Q m /\ f z mu mu (m - k)%Z m = f (1 - z) mu mu k m /\ ~ (forall (k : Z) (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => Derive_n (fun z => F Q m mu nu z) 1 0) 1 mu = 0).
Definition instance : Prop :=
exists (k : Z) (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z.
End abs_features_the_features_of_Sect__2_2.

Module abs_features_every_feature.
(* gbt-surfaces/abs.features.every feature, Abstract; repeated in Sect. 4
   printed: All geometric features of the proposed GBT-Bézier curves and surfaces are similar to the traditional Bézier curves and surfaces, but the shape-adjustment is the additional feature that the traditional Bézier curves and surfaces do not hold
   read as: Every feature of Bézier curves, linear precision among them: evenly spaced points of a segment give the segment with even speed.
   stated: sum(k, 0, m, b[k,m](z)*k/m) == z and sum(k, 0, m, f[k,m](z, mu, nu)*k/m) == z *)
Definition statement : Prop :=
forall (m : Z) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (1 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> IZR m <> 0) ->
  sum 0%Z m (fun k => b z k m * IZR k / IZR m) = z /\ sum 0%Z m (fun k => f z mu nu k m * IZR k / IZR m) = z.
End abs_features_every_feature.

Module sec_4_six_tensor_with_rotation_surfaces.
(* gbt-surfaces/sec-4.six-tensor.with rotation surfaces, Sect. 4, first paragraph
   printed: six different types of tensor product GBT-Bézier engineering surfaces including GBT-Bézier cylinders, GBT-Bézier bilinear surfaces, GBT-Bézier ruled surfaces, GBT-Bézier swung surfaces, GBT-Bézier swept, and GBT-Bézier rotation surfaces are constructed
   read as: The rotation surface (33) is a tensor product surface: its coefficient is a combination of the functions of order 3 in z_1, determined by values and derivatives at the ends.
   stated: cosine(z1) == blend(z1) *)
Definition blend (k0 : R) (k1 : R) (k2 : R) (k3 : R) (mu1 : R) (nu1 : R) (t : R) : R :=
  f t mu1 nu1 0%Z 3%Z * k0 + f t mu1 nu1 1%Z 3%Z * k1 + f t mu1 nu1 2%Z 3%Z * k2 + f t mu1 nu1 3%Z 3%Z * k3.
Definition cosine (t : R) : R :=
  (1 - 2 * t) / (2 * t ^ 2 - 2 * t + 1).
Definition statement : Prop :=
forall (k0 : R) (k1 : R) (k2 : R) (k3 : R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  2 * 0 ^ 2 - 2 * 0 + 1 <> 0 ->
  blend k0 k1 k2 k3 mu1 nu1 0 = cosine 0 ->
  locally 0 (fun t => 2 * t ^ 2 - 2 * t + 1 <> 0) ->
  Derive_n (fun t => blend k0 k1 k2 k3 mu1 nu1 t) 1 0 = Derive_n (fun t => cosine t) 1 0 ->
  locally 1 (fun t => 2 * t ^ 2 - 2 * t + 1 <> 0) ->
  Derive_n (fun t => blend k0 k1 k2 k3 mu1 nu1 t) 1 1 = Derive_n (fun t => cosine t) 1 1 ->
  2 * 1 ^ 2 - 2 * 1 + 1 <> 0 ->
  blend k0 k1 k2 k3 mu1 nu1 1 = cosine 1 ->
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0 ->
  cosine z1 = blend k0 k1 k2 k3 mu1 nu1 z1.
End sec_4_six_tensor_with_rotation_surfaces.

Module sec_4_six_tensor_without.
(* gbt-surfaces/sec-4.six-tensor.without, Sect. 4, first paragraph
   printed: six different types of tensor product GBT-Bézier engineering surfaces including GBT-Bézier cylinders, GBT-Bézier bilinear surfaces, GBT-Bézier ruled surfaces, GBT-Bézier swung surfaces, GBT-Bézier swept, and GBT-Bézier rotation surfaces are constructed
   read as: As the last sentence of the paragraph says, the rotation surfaces are excepted: cylinder, ruled surface (18) as printed, swung surface, in its first coordinate, which is as the second, and in its third, and swept surface; the bi-linear surface (16) is one by its formula.
   stated: sum(k, 0, m, (Q[k] + z1*V)*f[k,m](z, mu, nu)) == sum(k, 0, m, sum(l, 0, 1, (Q[k] + l*V)*f[k,m](z, mu, nu)*b[l,1](z1))) and printed18(z, z1) == tensor(z, z1) and sum(k, 0, m, f[k,m](z, mu, nu)*X[k])*sum(l, 0, n, f[l,n](z1, mu1, nu1)*U[l]) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*X[k]*U[l])) and sum(k, 0, m, f[k,m](z, mu, nu)*Z[k]) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*Z[k])) and sum(l, 0, n, f[l,n](z1, mu1, nu1)*B[l]) + sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(A[k] + B[l]))) *)
Definition printed18 (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition tensor (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => f z mu nu k m * b z1 l 1%Z * ((1 - IZR l) * A k + IZR l * B k))).
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (Q : Z -> R) (U : Z -> R) (V : R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  sum 0%Z m (fun k => (Q k + z1 * V) * f z mu nu k m) = sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => (Q k + IZR l * V) * f z mu nu k m * b z1 l 1%Z)) /\ printed18 A B m mu nu z z1 = tensor A B m mu nu z z1 /\ sum 0%Z m (fun k => f z mu nu k m * X k) * sum 0%Z n (fun l => f z1 mu1 nu1 l n * U l) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * X k * U l)) /\ sum 0%Z m (fun k => f z mu nu k m * Z_ k) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * Z_ k)) /\ sum 0%Z n (fun l => f z1 mu1 nu1 l n * B l) + sum 0%Z m (fun k => f z mu nu k m * A k) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (A k + B l))).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (Q : Z -> R) (U : Z -> R) (V : R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z).
End sec_4_six_tensor_without.

Module sec_4_composite_by_the_printed_conditions.
(* gbt-surfaces/sec-4.composite.by the printed conditions, Sect. 4, first paragraph
   printed: the construction of composite GBT-Bézier surfaces with C1, C2, and C3 continuous connection is also presented
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
End sec_4_composite_by_the_printed_conditions.

Module sec_4_composite_there_are_such_compositions.
(* gbt-surfaces/sec-4.composite.there are such compositions, Sect. 4, first paragraph
   printed: the construction of composite GBT-Bézier surfaces with C1, C2, and C3 continuous connection is also presented
   read as: Such compositions can be made: exhibited for every first curve, with a cubic of vanishing shape parameters for the second.
   stated: at(next(Q[m], Q[m-1], Q[m-2], Q[m-3], z), z, 0) == at(F(z), z, 1) and at(D(next(Q[m], Q[m-1], Q[m-2], Q[m-3], z), z, 1), z, 0) == at(D(F(z), z, 1), z, 1) and at(D(next(Q[m], Q[m-1], Q[m-2], Q[m-3], z), z, 2), z, 0) == at(D(F(z), z, 2), z, 1) and at(D(next(Q[m], Q[m-1], Q[m-2], Q[m-3], z), z, 3), z, 0) == at(D(F(z), z, 3), z, 1) *)
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
  (fun z : R => next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z) 0 = (fun z : R => F Q m mu nu z) 1 /\ (fun z : R => Derive_n (fun z => next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z) 1 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 1 z) 1 /\ (fun z : R => Derive_n (fun z => next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z) 2 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 2 z) 1 /\ (fun z : R => Derive_n (fun z => next m mu nu (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z) z) 3 z) 0 = (fun z : R => Derive_n (fun z => F Q m mu nu z) 3 z) 1.
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
End sec_4_composite_there_are_such_compositions.

Module sec_4_tensor.
(* gbt-surfaces/sec-4.tensor, Sect. 4, first paragraph, last sentence
   printed: These special engineering surfaces not only have some parameters for their shape control but can also be expressed in terms of tensor product GBT-Bézier surface design (excluding rotation surfaces).
   read as: Of the classes that are not excluded the ruled surface is examined: (18) has one set of functions f_{k,m} for both guide lines.
   stated: printed18(z, z1) == tensor(z, z1) *)
Definition printed18 (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  b z1 0%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * A k) + b z1 1%Z 1%Z * sum 0%Z m (fun k => f z mu nu k m * B k).
Definition tensor (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => f z mu nu k m * b z1 l 1%Z * ((1 - IZR l) * A k + IZR l * B k))).
Definition statement : Prop :=
forall (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  printed18 A B m mu nu z z1 = tensor A B m mu nu z z1.
Definition instance : Prop :=
exists (m : Z) (A : Z -> R) (B : Z -> R) (mu : R) (nu : R) (z : R) (z1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z).
End sec_4_tensor.

Module sec_4_convex_hull.
(* gbt-surfaces/sec-4.convex-hull, Sect. 4, second paragraph
   printed: the designed GBT-Bézier surfaces can approach their convex hull better than the traditional Bézier surfaces approaches
   read as: They can: exhibited with all shape parameters 1 in the middle, where the inner control points have more weight than in the Bézier curve and surface of the same net: curves of degrees 2 and 3, surfaces of degrees (2, 2) and (3, 3).
   stated: f[0,2](1/2, 1, 1) < b[0,2](1/2) and f[2,2](1/2, 1, 1) < b[2,2](1/2) and f[1,2](1/2, 1, 1) > b[1,2](1/2) and f[1,3](1/2, 1, 1) + f[2,3](1/2, 1, 1) > b[1,3](1/2) + b[2,3](1/2) and f[1,2](1/2, 1, 1)^2 > b[1,2](1/2)^2 and (f[1,3](1/2, 1, 1) + f[2,3](1/2, 1, 1))^2 > (b[1,3](1/2) + b[2,3](1/2))^2 *)
Definition statement : Prop :=
  f (1 / 2) 1 1 0%Z 2%Z < b (1 / 2) 0%Z 2%Z /\ f (1 / 2) 1 1 2%Z 2%Z < b (1 / 2) 2%Z 2%Z /\ f (1 / 2) 1 1 1%Z 2%Z > b (1 / 2) 1%Z 2%Z /\ f (1 / 2) 1 1 1%Z 3%Z + f (1 / 2) 1 1 2%Z 3%Z > b (1 / 2) 1%Z 3%Z + b (1 / 2) 2%Z 3%Z /\ f (1 / 2) 1 1 1%Z 2%Z ^ 2 > b (1 / 2) 1%Z 2%Z ^ 2 /\ (f (1 / 2) 1 1 1%Z 3%Z + f (1 / 2) 1 1 2%Z 3%Z) ^ 2 > (b (1 / 2) 1%Z 3%Z + b (1 / 2) 2%Z 3%Z) ^ 2.
End sec_4_convex_hull.
