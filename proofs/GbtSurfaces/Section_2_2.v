(* Statements of gbt-surfaces, Section 2 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : Z) : R :=
  sum 0%Z n (fun k => f (IZR z) mu1 nu1 k n * Q1 k).
Definition F1_ (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition printed11 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition a3 (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  2 * a1 mu1 n nu1 + PI ^ 2 * (1 + 2 * mu1 - nu1) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
Definition printed12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + a3 mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition join1 (m : Z) (mu1 : R) (n : Z) (nu : R) (p : R) (q : R) : R :=
  p + a m mu1 n nu * (p - q).
Definition join11 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  join1 m mu1 n nu (Q m) (Q (m - 1)%Z).
Definition b1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition b2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)).
Definition c1 (mu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
Definition b2_true (m : Z) (mu : R) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
Definition b3_true (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 + mu1 - nu1).
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - nu1).
Definition b4 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3 mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
Definition printed13 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / b1 mu1 n nu1 * (b2 m nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (Q (m - 1)%Z - Q (m - 2)%Z) - b4 m mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition b5_true (m : Z) (mu : R) (nu : R) : R :=
  6 * (IZR m - 2) * PI ^ 2 * (mu + 2 * nu - 1).
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
End Definitions.
Import Definitions.

Module def_2_points_one_letter.
(* gbt-surfaces/def-2.points.one letter, Sect. 2.2, Definition 2, first line
   printed: For any control points Q_k ∈ R^m, m = 2, 3; k = 0, 1, ..., m
   read as: The dimension of the space is the degree of the curve, 2 or 3.
   stated: m <= 3 *)
Definition statement : Prop :=
forall (m : Z),
  (2 <= m)%Z ->
  IZR m <= 3.
End def_2_points_one_letter.

Module def_2_points_two_letters.
(* gbt-surfaces/def-2.points.two letters, Sect. 2.2, Definition 2, first line
   printed: For any control points Q_k ∈ R^m, m = 2, 3; k = 0, 1, ..., m
   read as: The m of R^m is the dimension, 2 or 3, and the m of k = 0, ..., m the degree: (3) is meant coordinate by coordinate.
   stated: sum(k, 0, m, f[k,m](z)*P[k]) == [sum(k, 0, m, f[k,m](z)*P[k][1]), sum(k, 0, m, f[k,m](z)*P[k][2]), sum(k, 0, m, f[k,m](z)*P[k][3])] *)
Definition statement : Prop :=
forall (m : Z) (P'1 P'2 P'3 : Z -> R) (mu : R) (nu : R) (z : R),
  let P := fun i0 => [P'1 i0; P'2 i0; P'3 i0] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (P k)) = [sum 0%Z m (fun k => f z mu nu k m * entry (P k) 1); sum 0%Z m (fun k => f z mu nu k m * entry (P k) 2); sum 0%Z m (fun k => f z mu nu k m * entry (P k) 3)].
Definition instance : Prop :=
exists (m : Z) (P'1 P'2 P'3 : Z -> R) (mu : R) (nu : R) (z : R),
  let P := fun i0 => [P'1 i0; P'2 i0; P'3 i0] in
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End def_2_points_two_letters.

Module eq_3.
(* gbt-surfaces/eq-3, Sect. 2.2, eq. (3)
   printed: F_m(z;μ,ν) = sum_{k=0}^{m} f_{k,m}(z) Q_k, 0 ≤ z ≤ 1
   read as: The formula, and what the step (2) makes of it: two curves of one degree less.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*Q[k]) == (1 - z)*sum(k, 0, m - 1, f[k,m-1](z, mu, nu)*Q[k]) + z*sum(k, 0, m - 1, f[k,m-1](z, mu, nu)*Q[k+1]) and sum(k, 0, m, f[k,m](z, mu, nu)*Q[k]) == F(z) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (2 <= m - 1)%Z) ->
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (0 <= k + 1 <= m)%Z) ->
  sum 0%Z m (fun k => f z mu nu k m * Q k) = (1 - z) * sum 0%Z (m - 1)%Z (fun k => f z mu nu k (m - 1)%Z * Q k) + z * sum 0%Z (m - 1)%Z (fun k => f z mu nu k (m - 1)%Z * Q (k + 1)%Z) /\ sum 0%Z m (fun k => f z mu nu k m * Q k) = F Q m mu nu z.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (2 <= m - 1)%Z) /\
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 1))%Z -> (0 <= k + 1 <= m)%Z).
End eq_3.

Module sec_2_2_symmetry_as_in_Theorem_1.
(* gbt-surfaces/sec-2.2.symmetry.as in Theorem 1, Sect. 2.2, sentence after eq. (3)
   printed: The GBT-Bézier curves take over most advantageous features of the traditional Bézier curves, including symmetry
   read as: Symmetry is item 4 of Theorem 1, where μ = ν: the reversed polygon gives the same curve, run through backwards.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*Q[m-k]) == F(1 - z) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  mu = nu ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) ->
  sum 0%Z m (fun k => f z mu nu k m * Q (m - k)%Z) = F Q m mu nu (1 - z).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  mu = nu /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z).
End sec_2_2_symmetry_as_in_Theorem_1.

Module sec_2_2_symmetry_parameters_exchanged.
(* gbt-surfaces/sec-2.2.symmetry.parameters exchanged, Sect. 2.2, sentence after eq. (3)
   printed: The GBT-Bézier curves take over most advantageous features of the traditional Bézier curves, including symmetry
   read as: The reversed polygon with μ and ν exchanged gives the same curve.
   stated: sum(k, 0, m, f[k,m](z, nu, mu)*Q[m-k]) == F(1 - z) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) ->
  sum 0%Z m (fun k => f z nu mu k m * Q (m - k)%Z) = F Q m mu nu (1 - z).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z).
End sec_2_2_symmetry_parameters_exchanged.

Module sec_2_2_symmetry_as_for_B_zier_curves.
(* gbt-surfaces/sec-2.2.symmetry.as for Bézier curves, Sect. 2.2, sentence after eq. (3)
   printed: The GBT-Bézier curves take over most advantageous features of the traditional Bézier curves, including symmetry
   read as: The reversed polygon gives the same curve, for all shape parameters.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*Q[m-k]) == F(1 - z) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= m - k <= m)%Z) ->
  sum 0%Z m (fun k => f z mu nu k m * Q (m - k)%Z) = F Q m mu nu (1 - z).
End sec_2_2_symmetry_as_for_B_zier_curves.

Module sec_2_2_convex_hull.
(* gbt-surfaces/sec-2.2.convex-hull, Sect. 2.2, sentence after eq. (3)
   printed: ... including ... convex hull property
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z)) == 1 *)
Definition statement : Prop :=
forall (m : Z) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k_ => f z mu nu k_ m) = 1.
Definition instance : Prop :=
exists (m : Z) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End sec_2_2_convex_hull.

Module sec_2_2_variation_diminishing_order_2.
(* gbt-surfaces/sec-2.2.variation-diminishing.order-2, Sect. 2.2, sentence after eq. (3)
   printed: The quotients of the functions of order 2 do not decrease: the Wronskians of all pairs, and that of all three functions, are not negative.
   stated: w(0, 1) >= 0 and w(1, 2) >= 0 and w(0, 2) >= 0 and det([[f[0,2](z), f[1,2](z), f[2,2](z)], [D(f[0,2](z), z), D(f[1,2](z), z), D(f[2,2](z), z)], [D(f[0,2](z), z, 2), D(f[1,2](z), z, 2), D(f[2,2](z), z, 2)]]) >= 0 *)
Definition w (mu : R) (nu : R) (z : R) (i : Z) (j : Z) : R :=
  f z mu nu i 2%Z * Derive_n (fun z_ => f z_ mu nu j 2%Z) 1 z - f z mu nu j 2%Z * Derive_n (fun z_ => f z_ mu nu i 2%Z) 1 z.
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  w mu nu z 0%Z 1%Z >= 0 /\ w mu nu z 1%Z 2%Z >= 0 /\ w mu nu z 0%Z 2%Z >= 0 /\ det [[f z mu nu 0%Z 2%Z; f z mu nu 1%Z 2%Z; f z mu nu 2%Z 2%Z]; [Derive_n (fun z_ => f z_ mu nu 0%Z 2%Z) 1 z; Derive_n (fun z_ => f z_ mu nu 1%Z 2%Z) 1 z; Derive_n (fun z_ => f z_ mu nu 2%Z 2%Z) 1 z]; [Derive_n (fun z_ => f z_ mu nu 0%Z 2%Z) 2 z; Derive_n (fun z_ => f z_ mu nu 1%Z 2%Z) 2 z; Derive_n (fun z_ => f z_ mu nu 2%Z 2%Z) 2 z]] >= 0.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End sec_2_2_variation_diminishing_order_2.

Module sec_2_2_invariance.
(* gbt-surfaces/sec-2.2.invariance, Sect. 2.2, sentence after eq. (3)
   printed: ... including ... geometric invariance
   stated: sum(k, 0, m, f[k,m](z)*(A*P[k] + r)) == A*sum(k, 0, m, f[k,m](z)*P[k]) + r *)
Definition A (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) : list (list R) :=
  [[c11; c12; c13]; [c21; c22; c23]; [c31; c32; c33]].
Definition statement : Prop :=
forall (m : Z) (P'1 P'2 P'3 : Z -> R) (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) (mu : R) (nu : R) (r'1 r'2 r'3 : R) (z : R),
  let P := fun i0 => [P'1 i0; P'2 i0; P'3 i0] in
  let r := [r'1; r'2; r'3] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (vadd (mvec (A c11 c12 c13 c21 c22 c23 c31 c32 c33) (P k)) r)) = vadd (mvec (A c11 c12 c13 c21 c22 c23 c31 c32 c33) (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (P k)))) r.
Definition instance : Prop :=
exists (m : Z) (P'1 P'2 P'3 : Z -> R) (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) (mu : R) (nu : R) (r'1 r'2 r'3 : R) (z : R),
  let P := fun i0 => [P'1 i0; P'2 i0; P'3 i0] in
  let r := [r'1; r'2; r'3] in
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End sec_2_2_invariance.

Module sec_2_2_shape_adjustable.
(* gbt-surfaces/sec-2.2.shape-adjustable, Sect. 2.2, sentence after eq. (3)
   printed: ... including ... shape adjustable property
   stated: fails(D(F'(0), mu) == 0) and fails(D(F'(1), nu) == 0) *)
Definition F (Q : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => F Q m nu mu_ z_) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu_ z__) 1 (IZR z_)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End sec_2_2_shape_adjustable.

Module sec_2_2_terminal_0_values.
(* gbt-surfaces/sec-2.2.terminal-0.values, Sect. 2.2, sentence after eq. (3)
   printed: The values of the curve and of its first three derivatives at the start, from (1) to (3), for every order from 3 on.
   stated: F(0) == Q[0] and F'(0) == 1/2*(2*(m - 2) + pi*(1 + mu))*(Q[1] - Q[0]) and F''(0) == 1/4*(4*(m - 2)*(m - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi^2*mu*(Q[0] - Q[1]) - pi^2*(1 - nu)*(Q[1] - Q[2])) and F'''(0) == 1/8*(4*(m - 2)*(m - 3)*(2*(m - 4) + 3*pi*(1 + mu))*(Q[3] - 3*Q[2] + 3*Q[1] - Q[0]) + 12*(m - 2)*pi^2*mu*(2*Q[1] - Q[0] - Q[2]) + 6*(m - 2)*pi^2*(1 - nu)*(Q[3] - 2*Q[2] + Q[1]) - pi^3*(1 + mu)*(Q[1] - Q[0])) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 2 <= m)%Z ->
  (0 <= 3 <= m)%Z ->
  F Q m mu nu 0%Z = Q 0%Z /\ (let z := 0%Z in Derive_n (fun z_ => F_ Q m mu nu z_) 1 (IZR z)) = 1 / 2 * (2 * (IZR m - 2) + PI * (1 + mu)) * (Q 1%Z - Q 0%Z) /\ (let z_ := 0%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 2 (IZR z_)) = 1 / 4 * (4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + mu)) * (Q 0%Z - 2 * Q 1%Z + Q 2%Z) + 2 * PI ^ 2 * mu * (Q 0%Z - Q 1%Z) - PI ^ 2 * (1 - nu) * (Q 1%Z - Q 2%Z)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F_ Q m mu nu z___) 3 (IZR z__)) = 1 / 8 * (4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + mu)) * (Q 3%Z - 3 * Q 2%Z + 3 * Q 1%Z - Q 0%Z) + 12 * (IZR m - 2) * PI ^ 2 * mu * (2 * Q 1%Z - Q 0%Z - Q 2%Z) + 6 * (IZR m - 2) * PI ^ 2 * (1 - nu) * (Q 3%Z - 2 * Q 2%Z + Q 1%Z) - PI ^ 3 * (1 + mu) * (Q 1%Z - Q 0%Z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 2 <= m)%Z /\
  (0 <= 3 <= m)%Z.
End sec_2_2_terminal_0_values.

Module sec_2_2_terminal_1_values.
(* gbt-surfaces/sec-2.2.terminal-1.values, Sect. 2.2, sentence after eq. (3)
   printed: The values of the curve and of its first three derivatives at the end, from (1) to (3), for every order from 3 on.
   stated: F(1) == Q[m] and F'(1) == 1/2*(2*(m - 2) + pi*(1 + nu))*(Q[m] - Q[m-1]) and F''(1) == 1/4*(4*(m - 2)*(m - 3 + pi*(1 + nu))*(Q[m] - 2*Q[m-1] + Q[m-2]) + 2*pi^2*nu*(Q[m] - Q[m-1]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2])) and F'''(1) == 1/8*(4*(m - 2)*(m - 3)*(2*(m - 4) + 3*pi*(1 + nu))*(Q[m] - 3*Q[m-1] + 3*Q[m-2] - Q[m-3]) + 12*(m - 2)*pi^2*nu*(Q[m] - 2*Q[m-1] + Q[m-2]) - 6*(m - 2)*pi^2*(1 - mu)*(Q[m-1] - 2*Q[m-2] + Q[m-3]) - pi^3*(1 + nu)*(Q[m] - Q[m-1])) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  F Q m mu nu 1%Z = Q m /\ (let z := 1%Z in Derive_n (fun z_ => F_ Q m mu nu z_) 1 (IZR z)) = 1 / 2 * (2 * (IZR m - 2) + PI * (1 + nu)) * (Q m - Q (m - 1)%Z) /\ (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 2 (IZR z_)) = 1 / 4 * (4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)) * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) + 2 * PI ^ 2 * nu * (Q m - Q (m - 1)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z)) /\ (let z__ := 1%Z in Derive_n (fun z___ => F_ Q m mu nu z___) 3 (IZR z__)) = 1 / 8 * (4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + 12 * (IZR m - 2) * PI ^ 2 * nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - 6 * (IZR m - 2) * PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - 2 * Q (m - 2)%Z + Q (m - 3)%Z) - PI ^ 3 * (1 + nu) * (Q m - Q (m - 1)%Z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z.
End sec_2_2_terminal_1_values.

Module sec_2_2_interpolation.
(* gbt-surfaces/sec-2.2.interpolation, Sect. 2.2, paragraph after eq. (3)
   printed: the GBT-Bézier curve segments interpolate to the both end points of their convex hull
   stated: F(0) == Q[0] and F(1) == Q[m] *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  F Q m mu nu 0%Z = Q 0%Z /\ F Q m mu nu 1%Z = Q m.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z.
End sec_2_2_interpolation.

Module sec_2_2_end_derivatives.
(* gbt-surfaces/sec-2.2.end-derivatives, Sect. 2.2, paragraph after eq. (3)
   printed: the values of their derivatives at both end points on GBT-Bézier curves will be easily modified by adjusting the shape parameters μ, ν in their respective value range
   stated: fails(D(F'(0), mu) == 0) and fails(D(F'(1), nu) == 0) and fails(D(F''(0), nu) == 0) and fails(D(F''(1), mu) == 0) and fails(D(F'''(0), mu) == 0) and fails(D(F'''(1), nu) == 0) *)
Definition F (Q : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => F Q m nu mu_ z_) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu_ z__) 1 (IZR z_)) 1 nu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z__ := 0%Z in Derive_n (fun z___ => F_ Q m mu nu_ z___) 2 (IZR z__)) 1 nu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z___ := 1%Z in Derive_n (fun z____ => F Q m nu mu_ z____) 2 (IZR z___)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z____ := 0%Z in Derive_n (fun z_____ => F Q m nu mu_ z_____) 3 (IZR z____)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu_ z______) 3 (IZR z_____)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End sec_2_2_end_derivatives.

Module thm_2_setting.
(* gbt-surfaces/thm-2.setting, Sect. 2.2, Theorem 2, first sentence
   printed: The necessary and sufficient C3 continuity conditions among two GBT-Bézier curve segments F(z;μ,ν) = sum_{k=0}^{m} Q_k f_{k,m}(z) and F_1(z;μ_1,ν_1) = sum_{k=0}^{n} Q_{1k} f_{k,n}(z) with control points Q_0, ..., Q_m, m ≥ 3, and Q_{10}, Q_{11}, Q_{12}, ..., Q_{1n}, n ≥ 3
   read as: Q10, Q11, ... in our copy are read as double-index names Q_{1,0}, Q_{1,1}, ... of the second segment; the functions f_{k,n} of the second segment have the shape parameters that its left side names. The two segments and the ends that meet.
   stated: F(z) == sum(k, 0, m, Q[k]*f[k,m](z, mu, nu)) and F1(z) == sum(k, 0, n, Q1[k]*f[k,n](z, mu1, nu1)) and F(1) == Q[m] and F1(0) == Q1[0] *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition F1_ (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : Z) : R :=
  sum 0%Z n (fun k => f (IZR z) mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= m <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  F Q m mu nu z = sum 0%Z m (fun k => Q k * f z mu nu k m) /\ F1 Q1 mu1 n nu1 z = sum 0%Z n (fun k => Q1 k * f z mu1 nu1 k n) /\ F_ Q m mu nu 1%Z = Q m /\ F1_ Q1 mu1 n nu1 0%Z = Q1 0%Z.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= m <= m)%Z /\
  (0 <= 0 <= n)%Z.
End thm_2_setting.

Module thm_2_1.
(* gbt-surfaces/thm-2.1, Sect. 2.2, Theorem 2, item 1
   printed: Q_m = Q_{10} for C0 continuity
   stated: F1(0) - F(1) == Q1[0] - Q[m] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  F1 Q1 mu1 n nu1 0%Z - F Q m mu nu 1%Z = Q1 0%Z - Q m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z.
End thm_2_1.

Module eq_4_Q11.
(* gbt-surfaces/eq-4.Q11, Sect. 2.2, Theorem 2, item 2, eq. (4), second line
   printed: Q_{11} = Q_m + (2(m-2) + π(1+ν)) / (2(n-2) + π(1+μ_1)) (Q_m - Q_{m-1})
   stated: Q1[1] == Q[m] + (2*(m - 2) + pi*(1 + nu))/(2*(n - 2) + pi*(1 + mu1))*(Q[m] - Q[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  Q1 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  (0 <= m - 1 <= m)%Z.
End eq_4_Q11.

Module thm_2_2.
(* gbt-surfaces/thm-2.2, Sect. 2.2, Theorem 2, item 2, eq. (4) as a system
   printed: For C1 continuity, Q_{10} = Q_m, Q_{11} = Q_m + (2(m-2) + π(1+ν)) / (2(n-2) + π(1+μ_1)) (Q_m - Q_{m-1})   (necessary and sufficient)
   stated: F1'(0) - F'(1) == 1/2*(2*(n - 2) + pi*(1 + mu1))*(Q1[1] - printed11) and 2*(n - 2) + pi*(1 + mu1) > 0 *)
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
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 1 <= n)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 1 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 1 (IZR z_)) = 1 / 2 * (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q1 1%Z - printed11 Q m mu1 n nu) /\ 2 * (IZR n - 2) + PI * (1 + mu1) > 0.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 1 <= n)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  (0 <= m - 1 <= m)%Z.
End thm_2_2.

Module eq_5_Q12.
(* gbt-surfaces/eq-5.Q12, Sect. 2.2, Theorem 2, item 3, eq. (5), third line
   printed: Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]
   stated: Q1[2] == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + a3*(Q[m] - Q[m-1])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  Q1 2%Z = Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + a3 mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
End eq_5_Q12.

Module eq_5_Q12_corrected.
(* gbt-surfaces/eq-5.Q12 (corrected), Sect. 2.2, Theorem 2, item 3, eq. (5), third line
   printed: Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]
   stated: Q1[2] == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + (a*(2*a1 - pi^2*(1 - 2*mu1 - nu1)) + 2*pi^2*nu)*(Q[m] - Q[m-1])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 2%Z = Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + (a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu) * (Q m - Q (m - 1)%Z)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0.
End eq_5_Q12_corrected.

Module eq_5_Q12_true.
(* gbt-surfaces/eq-5.Q12.true, Sect. 2.2, Theorem 2, item 3, eq. (5), third line
   printed: The control point Q_{12} that a C2 join has.
   stated: Q1[2] == join12 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 2%Z = join12 Q m mu mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0.
End eq_5_Q12_true.

Module thm_2_3_a.
(* gbt-surfaces/thm-2.3.a, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: For C2 continuity, Q_{10} = Q_m, Q_{11} as in (4), Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]   (necessary and sufficient)
   read as: Sufficient: segments with the printed control points join with two continuous derivatives.
   stated: F1'(0) == F'(1) and F1''(0) == F''(1) *)
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
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F1 Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F Q m mu nu z____) 2 (IZR z___)).
End thm_2_3_a.

Module thm_2_3_b.
(* gbt-surfaces/thm-2.3.b, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: For C2 continuity, Q_{10} = Q_m, Q_{11} as in (4), Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]   (necessary and sufficient)
   read as: Necessary: segments that join with two continuous derivatives have the printed control points.
   stated: Q1[0] == Q[m] and Q1[1] == printed11 and Q1[2] == printed12 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= 2 <= n)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  Q1 0%Z = Q m /\ Q1 1%Z = printed11 Q m mu1 n nu /\ Q1 2%Z = printed12 Q m mu mu1 n nu nu1.
End thm_2_3_b.

Module thm_2_3_true.
(* gbt-surfaces/thm-2.3.true, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: Segments that meet join with C2 if and only if, beside (4), the right side vanishes: without a division, for all degrees and shape parameters.
   stated: 4*(F1''(0) - F''(1)) == a1*(Q1[2] - Q[m]) - (2*a1 - pi^2*(1 - 2*mu1 - nu1))*(Q1[1] - Q[m]) - (a2*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + 2*pi^2*nu*(Q[m] - Q[m-1])) *)
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
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 2 <= n)%Z ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  4 * ((let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 2 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 2 (IZR z_))) = a1 mu1 n nu1 * (Q1 2%Z - Q m) - (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) * (Q1 1%Z - Q m) - (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + 2 * PI ^ 2 * nu * (Q m - Q (m - 1)%Z)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 2 <= n)%Z /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z.
End thm_2_3_true.

Module thm_2_3_iff.
(* gbt-surfaces/thm-2.3.iff, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: With the first two control points of (5) the second derivative jumps by a_1/4 times what Q_{12} lies beside the point `join12`: this point is necessary and sufficient.
   stated: F1''(0) - F''(1) == a1/4*(Q1[2] - join12) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
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
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 2 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 2 (IZR z_)) = a1 mu1 n nu1 / 4 * (Q1 2%Z - join12 Q m mu mu1 n nu nu1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0.
End thm_2_3_iff.

Module thm_2_3_necessary.
(* gbt-surfaces/thm-2.3.necessary, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: The control points of every C2 join.
   stated: Q1[0] == Q[m] and Q1[1] == join11 and Q1[2] == join12 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 0%Z = Q m /\ Q1 1%Z = join11 Q m mu1 n nu /\ Q1 2%Z = join12 Q m mu mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0.
End thm_2_3_necessary.

Module thm_2_3_sufficient.
(* gbt-surfaces/thm-2.3.sufficient, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: A second segment of degree 4 or more with these control points joins with C2, for all shape parameters.
   stated: F1'(0) == F'(1) and F1''(0) == F''(1) *)
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (4 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  Q1 0%Z = Q m ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F1 Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F Q m mu nu z____) 2 (IZR z___)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (4 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End thm_2_3_sufficient.

Module thm_2_3_jump.
(* gbt-surfaces/thm-2.3.jump, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: The jump that the printed (5) leaves.
   stated: 4*(F1''(0) - F''(1)) == (a3 - a3_true)*(Q[m] - Q[m-1]) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
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
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  Q1 2%Z = printed12 Q m mu mu1 n nu nu1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  4 * ((let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 2 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 2 (IZR z_))) = (a3 mu1 n nu nu1 - a3_true m mu1 n nu nu1) * (Q m - Q (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (0 <= 2 <= n)%Z /\
  a1 mu1 n nu1 <> 0 /\
  (0 <= m - 2 <= m)%Z /\
  Q1 2%Z = printed12 Q m mu mu1 n nu nu1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End thm_2_3_jump.

Module thm_2_3_when.
(* gbt-surfaces/thm-2.3.when, Sect. 2.2, Theorem 2, item 3, eq. (5) as a system
   printed: The printed coefficient is the right one for two segments of one degree with ν = μ_1 and ν_1 = 1.
   stated: a3_true == a3 *)
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition statement : Prop :=
forall (m : Z) (n : Z) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  IZR n = IZR m ->
  nu = mu1 ->
  nu1 = 1 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  a3_true m mu1 n nu nu1 = a3 mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  IZR n = IZR m /\
  nu = mu1 /\
  nu1 = 1 /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0.
End thm_2_3_when.

Module eq_6_Q11.
(* gbt-surfaces/eq-6.Q11, Sect. 2.2, Theorem 2, item 4, eq. (6), second line
   printed: Q_{11} = Q_m + a (Q_m - Q_{m-1})
   stated: Q1[1] == Q[m] + a*(Q[m] - Q[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  Q1 1%Z = Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  (0 <= m - 1 <= m)%Z.
End eq_6_Q11.

Module eq_6_Q12.
(* gbt-surfaces/eq-6.Q12, Sect. 2.2, Theorem 2, item 4, eq. (6), third line
   printed: Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]
   stated: Q1[2] == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + a3*(Q[m] - Q[m-1])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  Q1 2%Z = Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + a3 mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
End eq_6_Q12.

Module eq_6_Q12_corrected.
(* gbt-surfaces/eq-6.Q12 (corrected), Sect. 2.2, Theorem 2, item 4, eq. (6), third line
   printed: Q_{12} = Q_m + 1/a_1 [a_2 (Q_m - 2Q_{m-1} + Q_{m-2}) - π^2 (1-μ)(Q_{m-1} - Q_{m-2}) + a_3 (Q_m - Q_{m-1})]
   stated: Q1[2] == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + (a*(2*a1 - pi^2*(1 - 2*mu1 - nu1)) + 2*pi^2*nu)*(Q[m] - Q[m-1])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 2%Z = Q m + 1 / a1 mu1 n nu1 * (a2 m nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z) + (a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu) * (Q m - Q (m - 1)%Z)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0.
End eq_6_Q12_corrected.

Module eq_6_Q13.
(* gbt-surfaces/eq-6.Q13, Sect. 2.2, Theorem 2, item 4, eq. (6), fourth line
   printed: Q_{13} = Q_m + 1/b_1 [b_2 (Q_m - 3Q_{m-1} + 3Q_{m-2} - Q_{m-3}) + (a_2/a_1) b_3 (Q_m - 2Q_{m-1} + Q_{m-2}) - (π^2 (1-μ_1) b_3 / a_1)(Q_{m-1} - Q_{m-2}) - b_4 (Q_m - Q_{m-1})]
   read as: 'a2 / a1' stacked over two lines before b3 is read as the factor a_2/a_1, and 'π2(1-μ1)b3 / a1' as the fraction π^2(1-μ_1)b_3/a_1
   stated: Q1[3] == printed13 *)
Definition b4 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3 mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
Definition printed13 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / b1 mu1 n nu1 * (b2 m nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (Q (m - 1)%Z - Q (m - 2)%Z) - b4 m mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 3%Z = printed13 Q m mu1 n nu nu1.
End eq_6_Q13.

Module eq_6_Q13_true.
(* gbt-surfaces/eq-6.Q13.true, Sect. 2.2, Theorem 2, item 4, eq. (6), fourth line
   printed: The control point Q_{13} that a C3 join has.
   stated: Q1[3] == join13 *)
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition join13 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join3 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 3%Z = join13 Q m mu mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) /\
  (0 <= 3 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  b1 mu1 n nu1 <> 0 /\
  a1 mu1 n nu1 <> 0 /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0.
End eq_6_Q13_true.

Module thm_2_4_a.
(* gbt-surfaces/thm-2.4.a, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: For C3 continuity, (6)   (necessary and sufficient)
   read as: Sufficient: segments with the printed control points join with three continuous derivatives.
   stated: F1'(0) == F'(1) and F1''(0) == F''(1) and F1'''(0) == F'''(1) *)
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
End thm_2_4_a.

Module thm_2_4_c.
(* gbt-surfaces/thm-2.4.c, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: For C3 continuity, (6)   (necessary and sufficient)
   read as: Sufficient, the third derivative alone: whatever the first and second do, the third derivatives of segments with the printed control points agree.
   stated: F1'''(0) == F'''(1) *)
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
  IZR m = 3 ->
  IZR n = 3 ->
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
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 3 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 3 (IZR z_)).
End thm_2_4_c.

Module thm_2_4_b.
(* gbt-surfaces/thm-2.4.b, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: For C3 continuity, (6)   (necessary and sufficient)
   read as: Necessary: segments that join with three continuous derivatives have the printed control points.
   stated: Q1[0] == Q[m] and Q1[1] == printed11 and Q1[2] == printed12 and Q1[3] == printed13 *)
Definition b4 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3 mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
Definition printed13 (Q : Z -> R) (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  Q m + 1 / b1 mu1 n nu1 * (b2 m nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + a2 m nu / a1 mu1 n nu1 * b3 mu1 n nu1 * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 2 * (1 - mu1) * b3 mu1 n nu1 / a1 mu1 n nu1 * (Q (m - 1)%Z - Q (m - 2)%Z) - b4 m mu1 n nu nu1 * (Q m - Q (m - 1)%Z)).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= 2 <= n)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= 3 <= n)%Z ->
  b1 mu1 n nu1 <> 0 ->
  (0 <= m - 3 <= m)%Z ->
  Q1 0%Z = Q m /\ Q1 1%Z = printed11 Q m mu1 n nu /\ Q1 2%Z = printed12 Q m mu mu1 n nu nu1 /\ Q1 3%Z = printed13 Q m mu1 n nu nu1.
End thm_2_4_b.

Module thm_2_4_true.
(* gbt-surfaces/thm-2.4.true, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: Segments that join with C2 join with C3 if and only if the right side vanishes: without a division, for all degrees and shape parameters.
   stated: 8*(F1'''(0) - F'''(1)) == b1*(Q1[3] - Q[m]) - b3_true*(Q1[2] - Q[m]) + (3*c1 + 6*(n - 2)*pi^2*(1 + 4*mu1 - nu1) - pi^3*(1 + mu1))*(Q1[1] - Q[m]) - (b2_true*(Q[m] - 3*Q[m-1] + 3*Q[m-2] - Q[m-3]) + b5_true*(Q[m] - 2*Q[m-1] + Q[m-2]) - pi^3*(1 + nu)*(Q[m] - Q[m-1])) *)
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
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 3 <= n)%Z ->
  (0 <= 2 <= n)%Z ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  8 * ((let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 3 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 3 (IZR z_))) = b1 mu1 n nu1 * (Q1 3%Z - Q m) - b3_true mu1 n nu1 * (Q1 2%Z - Q m) + (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) * (Q1 1%Z - Q m) - (b2_true m mu nu * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z) + b5_true m mu nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z) - PI ^ 3 * (1 + nu) * (Q m - Q (m - 1)%Z)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 3 <= n)%Z /\
  (0 <= 2 <= n)%Z /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z.
End thm_2_4_true.

Module thm_2_4_iff.
(* gbt-surfaces/thm-2.4.iff, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: With the first three control points of a C2 join the third derivative jumps by b_1/8 times what Q_{13} lies beside the point `join13`: this point is necessary and sufficient.
   stated: F1'''(0) - F'''(1) == b1/8*(Q1[3] - join13) *)
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition join13 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join3 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z).
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
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m - 3 <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  (let z := 0%Z in Derive_n (fun z_ => F1 Q1 mu1 n nu1 z_) 3 (IZR z)) - (let z_ := 1%Z in Derive_n (fun z__ => F Q m mu nu z__) 3 (IZR z_)) = b1 mu1 n nu1 / 8 * (Q1 3%Z - join13 Q m mu mu1 n nu nu1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= 3 <= n)%Z /\
  (0 <= m - 3 <= m)%Z /\
  b1 mu1 n nu1 <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0.
End thm_2_4_iff.

Module thm_2_4_necessary.
(* gbt-surfaces/thm-2.4.necessary, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: The control points of every C3 join.
   stated: Q1[0] == Q[m] and Q1[1] == join11 and Q1[2] == join12 and Q1[3] == join13 *)
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition join13 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join3 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  (0 <= 3 <= n)%Z ->
  (0 <= m - 3 <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  Q1 0%Z = Q m /\ Q1 1%Z = join11 Q m mu1 n nu /\ Q1 2%Z = join12 Q m mu mu1 n nu nu1 /\ Q1 3%Z = join13 Q m mu mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  (0 <= 3 <= n)%Z /\
  (0 <= m - 3 <= m)%Z /\
  b1 mu1 n nu1 <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0.
End thm_2_4_necessary.

Module thm_2_4_sufficient.
(* gbt-surfaces/thm-2.4.sufficient, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: Segments with these control points join with C3.
   stated: F1(0) == F(1) and F1'(0) == F'(1) and F1''(0) == F''(1) and F1'''(0) == F'''(1) *)
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition join13 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join3 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z).
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
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 ->
  (0 <= 3 <= n)%Z ->
  (0 <= m - 3 <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  Q1 3%Z = join13 Q m mu mu1 n nu nu1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\ (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\ (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 /\
  (0 <= 3 <= n)%Z /\
  (0 <= m - 3 <= m)%Z /\
  b1 mu1 n nu1 <> 0 /\
  Q1 3%Z = join13 Q m mu mu1 n nu nu1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0.
End thm_2_4_sufficient.

Module thm_2_4_sufficient_quintic.
(* gbt-surfaces/thm-2.4.sufficient.quintic, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: A second segment of degree 5 or more with these control points joins with C3, for all shape parameters.
   stated: F1(0) == F(1) and F1'(0) == F'(1) and F1''(0) == F''(1) and F1'''(0) == F'''(1) *)
Definition a3_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition join2 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3_true m mu1 n nu nu1 * (p - q)).
Definition join12 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join2 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z).
Definition b4_true (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a m mu1 n nu * (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) - a3_true m mu1 n nu nu1 * b3_true mu1 n nu1 / a1 mu1 n nu1 + PI ^ 3 * (1 + nu).
Definition join3 (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) (s : R) : R :=
  p + 1 / b1 mu1 n nu1 * (b2_true m mu nu * (p - 3 * q + 3 * r - s) + (a2 m nu / a1 mu1 n nu1 * b3_true mu1 n nu1 + b5_true m mu nu) * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * b3_true mu1 n nu1 / a1 mu1 n nu1 * (q - r) - b4_true m mu1 n nu nu1 * (p - q)).
Definition join13 (Q : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  join3 m mu mu1 n nu nu1 (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) (Q (m - 3)%Z).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (5 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  Q1 0%Z = Q m ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1 1%Z = join11 Q m mu1 n nu ->
  (0 <= 2 <= n)%Z ->
  (0 <= m - 2 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 ->
  (0 <= 3 <= n)%Z ->
  (0 <= m - 3 <= m)%Z ->
  b1 mu1 n nu1 <> 0 ->
  Q1 3%Z = join13 Q m mu mu1 n nu nu1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\ (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\ (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\ (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (5 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  Q1 0%Z = Q m /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1 1%Z = join11 Q m mu1 n nu /\
  (0 <= 2 <= n)%Z /\
  (0 <= m - 2 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  Q1 2%Z = join12 Q m mu mu1 n nu nu1 /\
  (0 <= 3 <= n)%Z /\
  (0 <= m - 3 <= m)%Z /\
  b1 mu1 n nu1 <> 0 /\
  Q1 3%Z = join13 Q m mu mu1 n nu nu1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End thm_2_4_sufficient_quintic.

Module thm_2_4_cubic.
(* gbt-surfaces/thm-2.4.cubic, Sect. 2.2, Theorem 2, item 4, eq. (6) as a system
   printed: For a cubic second segment with ν_1 = 1 the divisor b_1 of (6) is zero: the third derivative at its start does not contain Q_{13}.
   stated: b1 == 0 and coefficients([F1'''(0)], [Q1[3]])[1,1] == 0 *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  IZR n = 3 ->
  nu1 = 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 3 <= n)%Z ->
  b1 mu1 n nu1 = 0 /\ entry (row [[Derive_n (fun t => let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 3%Z t) mu1 n nu1 z_) 3 (IZR z)) 1 (Q1 3%Z)]] 1) 1 = 0.
Definition instance : Prop :=
exists (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  IZR n = 3 /\
  nu1 = 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= 3 <= n)%Z.
End thm_2_4_cubic.

Module thm_2_a.
(* gbt-surfaces/thm-2.a, Sect. 2.2, coefficients after eq. (6)
   printed: a = (2(m-2) + π(1+ν)) / (2(n-2) + π(1+μ_1))
   stated: -coefficients([Q1[1]], [Q[m-1]])[1,1] == (2*(m - 2) + pi*(1 + nu))/(2*(n - 2) + pi*(1 + mu1)) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (0 <= 1 <= n)%Z ->
  (0 <= m - 1 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z ->
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z ->
  (forall t : R, F1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) ->
  (forall t : R, (let z__ := 0%Z in Derive_n (fun z___ => F1_ (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) mu1 n nu1 z___) 1 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ (update1 Q (m - 1)%Z t) m mu nu z____) 1 (IZR z___))) ->
  - entry (row [[Derive_n (fun t => (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 1%Z) 1 (Q (m - 1)%Z)]] 1) 1 = (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (0 <= 1 <= n)%Z /\
  (0 <= m - 1 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z /\
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z /\
  (forall t : R, F1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) /\
  (forall t : R, (let z__ := 0%Z in Derive_n (fun z___ => F1_ (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) mu1 n nu1 z___) 1 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ (update1 Q (m - 1)%Z t) m mu nu z____) 1 (IZR z___))).
End thm_2_a.

Module thm_2_a1.
(* gbt-surfaces/thm-2.a1, Sect. 2.2, coefficients after eq. (6)
   printed: a_1 = 4(n-2)(n-3 + π(1+μ_1)) + π^2 (1-ν_1)
   read as: The coefficient of Q_{12} in four times the second derivative, the factor with which (5) has it.
   stated: coefficients([4*F1''(0)], [Q1[2]])[1,1] == 4*(n - 2)*(n - 3 + pi*(1 + mu1)) + pi^2*(1 - nu1) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 2 <= n)%Z ->
  entry (row [[Derive_n (fun t => 4 * (let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 2%Z t) mu1 n nu1 z_) 2 (IZR z))) 1 (Q1 2%Z)]] 1) 1 = 4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition instance : Prop :=
exists (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= 2 <= n)%Z.
End thm_2_a1.

Module thm_2_a1_sign.
(* gbt-surfaces/thm-2.a1.sign, Sect. 2.2, coefficients after eq. (6)
   printed: The divisor a_1 of (5) is positive where the second segment has degree 4 or more; at degree 3 it is zero for μ_1 = -1, ν_1 = 1 alone.
   stated: a1 > 0 and at(a1, n, 3) == 4*pi*(1 + mu1) + pi^2*(1 - nu1) *)
Definition a1_ (mu1 : R) (nu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition statement : Prop :=
forall (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (4 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  a1 mu1 n nu1 > 0 /\ a1_ mu1 nu1 3%Z = 4 * PI * (1 + mu1) + PI ^ 2 * (1 - nu1).
Definition instance : Prop :=
exists (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (4 <= n)%Z /\
  (-1) <= nu1 <= 1.
End thm_2_a1_sign.

Module thm_2_a2.
(* gbt-surfaces/thm-2.a2, Sect. 2.2, coefficients after eq. (6)
   printed: a_2 = 4(m-2)(m-3 + π(1+ν))
   read as: The coefficient of the second difference in four times the second derivative; the term with 1 - mu stands apart, as in (5).
   stated: coefficients([4*F''(1) + pi^2*(1 - mu)*(Q[m-1] - Q[m-2])], [Q[m-2]])[1,1] == 4*(m - 2)*(m - 3 + pi*(1 + nu)) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  entry (row [[Derive_n (fun t => 4 * (let z := 1%Z in Derive_n (fun z_ => F (update1 Q (m - 2)%Z t) m mu nu z_) 2 (IZR z)) + PI ^ 2 * (1 - mu) * ((update1 Q (m - 2)%Z t) (m - 1)%Z - (update1 Q (m - 2)%Z t) (m - 2)%Z)) 1 (Q (m - 2)%Z)]] 1) 1 = 4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z.
End thm_2_a2.

Module thm_2_a3.
(* gbt-surfaces/thm-2.a3, Sect. 2.2, coefficients after eq. (6)
   printed: a_3 = (2a_1 + π^2 (1 + 2μ_1 - ν_1) + 2π^2 ν)
   read as: The bracket of (5) solved for the coefficient of Q_m - Q_{m-1}, with Q_{12} from the join itself.
   stated: coefficients([a1*(Q1[2] - Q[m]) - a2*(Q[m] - 2*Q[m-1] + Q[m-2]) + pi^2*(1 - mu)*(Q[m-1] - Q[m-2])], [Q[m]])[1,1] == 2*a1 + pi^2*(1 + 2*mu1 - nu1) + 2*pi^2*nu *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  Q1_0_of_t (Q m) = Q1 0%Z ->
  Q1_1_of_t (Q m) = Q1 1%Z ->
  Q1_2_of_t (Q m) = Q1 2%Z ->
  (forall t : R, F1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 0%Z = F (update1 Q m t) m mu nu 1%Z) ->
  (forall t : R, (let z____ := 0%Z in Derive_n (fun z_____ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_____) 1 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ (update1 Q m t) m mu nu z______) 1 (IZR z_____))) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_______) 2 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q m t) m mu nu z________) 2 (IZR z_______))) ->
  entry (row [[Derive_n (fun t => a1 mu1 n nu1 * ((update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 2%Z - (update1 Q m t) m) - a2 m nu * ((update1 Q m t) m - 2 * (update1 Q m t) (m - 1)%Z + (update1 Q m t) (m - 2)%Z) + PI ^ 2 * (1 - mu) * ((update1 Q m t) (m - 1)%Z - (update1 Q m t) (m - 2)%Z)) 1 (Q m)]] 1) 1 = 2 * a1 mu1 n nu1 + PI ^ 2 * (1 + 2 * mu1 - nu1) + 2 * PI ^ 2 * nu.
End thm_2_a3.

Module thm_2_a3_corrected.
(* gbt-surfaces/thm-2.a3 (corrected), Sect. 2.2, coefficients after eq. (6)
   printed: a_3 = (2a_1 + π^2 (1 + 2μ_1 - ν_1) + 2π^2 ν)
   read as: The bracket of (5) solved for the coefficient of Q_m - Q_{m-1}, with Q_{12} from the join itself.
   stated: coefficients([a1*(Q1[2] - Q[m]) - a2*(Q[m] - 2*Q[m-1] + Q[m-2]) + pi^2*(1 - mu)*(Q[m-1] - Q[m-2])], [Q[m]])[1,1] == a*(2*a1 - pi^2*(1 - 2*mu1 - nu1)) + 2*pi^2*nu *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1_0_of_t (Q m) = Q1 0%Z ->
  Q1_1_of_t (Q m) = Q1 1%Z ->
  Q1_2_of_t (Q m) = Q1 2%Z ->
  (forall t : R, F1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 0%Z = F (update1 Q m t) m mu nu 1%Z) ->
  (forall t : R, (let z____ := 0%Z in Derive_n (fun z_____ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_____) 1 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ (update1 Q m t) m mu nu z______) 1 (IZR z_____))) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_______) 2 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q m t) m mu nu z________) 2 (IZR z_______))) ->
  entry (row [[Derive_n (fun t => a1 mu1 n nu1 * ((update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 2%Z - (update1 Q m t) m) - a2 m nu * ((update1 Q m t) m - 2 * (update1 Q m t) (m - 1)%Z + (update1 Q m t) (m - 2)%Z) + PI ^ 2 * (1 - mu) * ((update1 Q m t) (m - 1)%Z - (update1 Q m t) (m - 2)%Z)) 1 (Q m)]] 1) 1 = a m mu1 n nu * (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) + 2 * PI ^ 2 * nu.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  Q1_0_of_t (Q m) = Q1 0%Z /\
  Q1_1_of_t (Q m) = Q1 1%Z /\
  Q1_2_of_t (Q m) = Q1 2%Z /\
  (forall t : R, F1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 0%Z = F (update1 Q m t) m mu nu 1%Z) /\
  (forall t : R, (let z____ := 0%Z in Derive_n (fun z_____ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_____) 1 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ (update1 Q m t) m mu nu z______) 1 (IZR z_____))) /\
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_______) 2 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q m t) m mu nu z________) 2 (IZR z_______))).
End thm_2_a3_corrected.

Module thm_2_a3_true.
(* gbt-surfaces/thm-2.a3.true, Sect. 2.2, coefficients after eq. (6)
   printed: The coefficient that the C2 join has.
   stated: coefficients([a1*(Q1[2] - Q[m]) - a2*(Q[m] - 2*Q[m-1] + Q[m-2]) + pi^2*(1 - mu)*(Q[m-1] - Q[m-2])], [Q[m]])[1,1] == a3_true *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  Q1_0_of_t (Q m) = Q1 0%Z ->
  Q1_1_of_t (Q m) = Q1 1%Z ->
  Q1_2_of_t (Q m) = Q1 2%Z ->
  (forall t : R, F1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 0%Z = F (update1 Q m t) m mu nu 1%Z) ->
  (forall t : R, (let z____ := 0%Z in Derive_n (fun z_____ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_____) 1 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ (update1 Q m t) m mu nu z______) 1 (IZR z_____))) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_______) 2 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q m t) m mu nu z________) 2 (IZR z_______))) ->
  entry (row [[Derive_n (fun t => a1 mu1 n nu1 * ((update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 2%Z - (update1 Q m t) m) - a2 m nu * ((update1 Q m t) m - 2 * (update1 Q m t) (m - 1)%Z + (update1 Q m t) (m - 2)%Z) + PI ^ 2 * (1 - mu) * ((update1 Q m t) (m - 1)%Z - (update1 Q m t) (m - 2)%Z)) 1 (Q m)]] 1) 1 = a3_true m mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  Q1_0_of_t (Q m) = Q1 0%Z /\
  Q1_1_of_t (Q m) = Q1 1%Z /\
  Q1_2_of_t (Q m) = Q1 2%Z /\
  (forall t : R, F1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 0%Z = F (update1 Q m t) m mu nu 1%Z) /\
  (forall t : R, (let z____ := 0%Z in Derive_n (fun z_____ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_____) 1 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ (update1 Q m t) m mu nu z______) 1 (IZR z_____))) /\
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) mu1 n nu1 z_______) 2 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q m t) m mu nu z________) 2 (IZR z_______))).
End thm_2_a3_true.

Module thm_2_b1.
(* gbt-surfaces/thm-2.b1, Sect. 2.2, coefficients after eq. (6)
   printed: b_1 = 4(n-2)(n-3)(2(n-4) + 3π(1+μ_1)) + 6(n-2)π^2 (1-ν_1)
   read as: The coefficient of Q_{13} in eight times the third derivative, the factor with which (6) has it.
   stated: coefficients([8*F1'''(0)], [Q1[3]])[1,1] == 4*(n - 2)*(n - 3)*(2*(n - 4) + 3*pi*(1 + mu1)) + 6*(n - 2)*pi^2*(1 - nu1) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 3 <= n)%Z ->
  entry (row [[Derive_n (fun t => 8 * (let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 3%Z t) mu1 n nu1 z_) 3 (IZR z))) 1 (Q1 3%Z)]] 1) 1 = 4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition instance : Prop :=
exists (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= 3 <= n)%Z.
End thm_2_b1.

Module thm_2_b1_sign.
(* gbt-surfaces/thm-2.b1.sign, Sect. 2.2, coefficients after eq. (6)
   printed: The divisor b_1 of (6) is positive where the second segment has degree 5 or more; it is zero at degree 3 for ν_1 = 1 and at degree 4 for μ_1 = -1, ν_1 = 1 alone.
   stated: b1 > 0 and at(b1, n, 3) == 6*pi^2*(1 - nu1) and at(b1, n, 4) == 24*pi*(1 + mu1) + 12*pi^2*(1 - nu1) *)
Definition b1_ (mu1 : R) (nu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition statement : Prop :=
forall (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (5 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  b1 mu1 n nu1 > 0 /\ b1_ mu1 nu1 3%Z = 6 * PI ^ 2 * (1 - nu1) /\ b1_ mu1 nu1 4%Z = 24 * PI * (1 + mu1) + 12 * PI ^ 2 * (1 - nu1).
Definition instance : Prop :=
exists (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (5 <= n)%Z /\
  (-1) <= nu1 <= 1.
End thm_2_b1_sign.

Module thm_2_b2.
(* gbt-surfaces/thm-2.b2, Sect. 2.2, coefficients after eq. (6)
   printed: b_2 = 4(m-2)(m-3)(2(m-4) + 3π(1+ν))
   read as: In (6) the third difference alone contains Q_{m-3}: b_2 is minus its coefficient in eight times the third derivative.
   stated: -coefficients([8*F'''(1)], [Q[m-3]])[1,1] == 4*(m - 2)*(m - 3)*(2*(m - 4) + 3*pi*(1 + nu)) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= m - 3 <= m)%Z ->
  - entry (row [[Derive_n (fun t => 8 * (let z := 1%Z in Derive_n (fun z_ => F (update1 Q (m - 3)%Z t) m mu nu z_) 3 (IZR z))) 1 (Q (m - 3)%Z)]] 1) 1 = 4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)).
End thm_2_b2.

Module thm_2_b2_true.
(* gbt-surfaces/thm-2.b2.true, Sect. 2.2, coefficients after eq. (6)
   printed: The coefficient of the third difference that the C3 join has.
   stated: -coefficients([8*F'''(1)], [Q[m-3]])[1,1] == b2_true *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (0 <= m - 3 <= m)%Z ->
  - entry (row [[Derive_n (fun t => 8 * (let z := 1%Z in Derive_n (fun z_ => F (update1 Q (m - 3)%Z t) m mu nu z_) 3 (IZR z))) 1 (Q (m - 3)%Z)]] 1) 1 = b2_true m mu nu.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (0 <= m - 3 <= m)%Z.
End thm_2_b2_true.

Module thm_2_b3.
(* gbt-surfaces/thm-2.b3, Sect. 2.2, coefficients after eq. (6)
   printed: b_3 = (3c_1 + 12(n-2)π^2 (1 - μ_1 - ν_1))
   read as: Minus the coefficient of Q_{12} in eight times the third derivative.
   stated: -coefficients([8*F1'''(0)], [Q1[2]])[1,1] == 3*c1 + 12*(n - 2)*pi^2*(1 - mu1 - nu1) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 2 <= n)%Z ->
  - entry (row [[Derive_n (fun t => 8 * (let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 2%Z t) mu1 n nu1 z_) 3 (IZR z))) 1 (Q1 2%Z)]] 1) 1 = 3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - nu1).
End thm_2_b3.

Module thm_2_b3_corrected.
(* gbt-surfaces/thm-2.b3 (corrected), Sect. 2.2, coefficients after eq. (6)
   printed: b_3 = (3c_1 + 12(n-2)π^2 (1 - μ_1 - ν_1))
   read as: Minus the coefficient of Q_{12} in eight times the third derivative.
   stated: -coefficients([8*F1'''(0)], [Q1[2]])[1,1] == 3*c1 + 12*(n - 2)*pi^2*(1 + mu1 - nu1) *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 2 <= n)%Z ->
  - entry (row [[Derive_n (fun t => 8 * (let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 2%Z t) mu1 n nu1 z_) 3 (IZR z))) 1 (Q1 2%Z)]] 1) 1 = 3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 + mu1 - nu1).
Definition instance : Prop :=
exists (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= 2 <= n)%Z.
End thm_2_b3_corrected.

Module thm_2_b3_true.
(* gbt-surfaces/thm-2.b3.true, Sect. 2.2, coefficients after eq. (6)
   printed: The coefficient that the C3 join has.
   stated: -coefficients([8*F1'''(0)], [Q1[2]])[1,1] == b3_true *)
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition statement : Prop :=
forall (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (0 <= 2 <= n)%Z ->
  - entry (row [[Derive_n (fun t => 8 * (let z := 0%Z in Derive_n (fun z_ => F1 (update1 Q1 2%Z t) mu1 n nu1 z_) 3 (IZR z))) 1 (Q1 2%Z)]] 1) 1 = b3_true mu1 n nu1.
Definition instance : Prop :=
exists (n : Z) (Q1 : Z -> R) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (0 <= 2 <= n)%Z.
End thm_2_b3_true.

Module thm_2_b4.
(* gbt-surfaces/thm-2.b4, Sect. 2.2, coefficients after eq. (6)
   printed: b_4 = a_3 b_3 / a_1 - a (c_1 + 12(n-2)π^2 (1 - μ_1 - 4ν_1) + π^3 (1+μ_1)) + π^3 (1+ν)
   read as: The bracket of (6) on evenly spaced points, where the second and third differences vanish, with the a_3 and b_3 that the join has and with mu in the term with Q_{m-1} - Q_{m-2}: what is left is b_4.
   stated: (coefficients([b1*(Q1[3] - Q[m])], [Q[m-1], Q[m-2], Q[m-3]])*[1, 2, 3])[1] - pi^2*(1 - mu)*b3/a1 == a3*b3/a1 - a*(c1 + 12*(n - 2)*pi^2*(1 - mu1 - 4*nu1) + pi^3*(1 + mu1)) + pi^3*(1 + nu) *)
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  b3_true mu1 n nu1.
Definition a3 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3_true m mu1 n nu nu1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R) (Q1_3_of_t : R -> R) (Q1_0_of_t_ : R -> R) (Q1_1_of_t_ : R -> R) (Q1_2_of_t_ : R -> R) (Q1_3_of_t_ : R -> R) (Q1_0_of_t__ : R -> R) (Q1_1_of_t__ : R -> R) (Q1_2_of_t__ : R -> R) (Q1_3_of_t__ : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z ->
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z ->
  Q1_2_of_t (Q (m - 1)%Z) = Q1 2%Z ->
  Q1_3_of_t (Q (m - 1)%Z) = Q1 3%Z ->
  (forall t : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_______) 1 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q (m - 1)%Z t) m mu nu z________) 1 (IZR z_______))) ->
  (forall t : R, (let z________ := 0%Z in Derive_n (fun z_________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_________) 2 (IZR z________)) = (let z_________ := 1%Z in Derive_n (fun z__________ => F_ (update1 Q (m - 1)%Z t) m mu nu z__________) 2 (IZR z_________))) ->
  (forall t : R, (let z__________ := 0%Z in Derive_n (fun z___________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z___________) 3 (IZR z__________)) = (let z___________ := 1%Z in Derive_n (fun z____________ => F_ (update1 Q (m - 1)%Z t) m mu nu z____________) 3 (IZR z___________))) ->
  Q1_0_of_t_ (Q (m - 2)%Z) = Q1 0%Z ->
  Q1_1_of_t_ (Q (m - 2)%Z) = Q1 1%Z ->
  Q1_2_of_t_ (Q (m - 2)%Z) = Q1 2%Z ->
  Q1_3_of_t_ (Q (m - 2)%Z) = Q1 3%Z ->
  (forall t_ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 0%Z = F (update1 Q (m - 2)%Z t_) m mu nu 1%Z) ->
  (forall t_ : R, (let z____________ := 0%Z in Derive_n (fun z_____________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_____________) 1 (IZR z____________)) = (let z_____________ := 1%Z in Derive_n (fun z______________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z______________) 1 (IZR z_____________))) ->
  (forall t_ : R, (let z______________ := 0%Z in Derive_n (fun z_______________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_______________) 2 (IZR z______________)) = (let z_______________ := 1%Z in Derive_n (fun z________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z________________) 2 (IZR z_______________))) ->
  (forall t_ : R, (let z________________ := 0%Z in Derive_n (fun z_________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_________________) 3 (IZR z________________)) = (let z_________________ := 1%Z in Derive_n (fun z__________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z__________________) 3 (IZR z_________________))) ->
  Q1_0_of_t__ (Q (m - 3)%Z) = Q1 0%Z ->
  Q1_1_of_t__ (Q (m - 3)%Z) = Q1 1%Z ->
  Q1_2_of_t__ (Q (m - 3)%Z) = Q1 2%Z ->
  Q1_3_of_t__ (Q (m - 3)%Z) = Q1 3%Z ->
  (forall t__ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 0%Z = F (update1 Q (m - 3)%Z t__) m mu nu 1%Z) ->
  (forall t__ : R, (let z__________________ := 0%Z in Derive_n (fun z___________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z___________________) 1 (IZR z__________________)) = (let z___________________ := 1%Z in Derive_n (fun z____________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z____________________) 1 (IZR z___________________))) ->
  (forall t__ : R, (let z____________________ := 0%Z in Derive_n (fun z_____________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_____________________) 2 (IZR z____________________)) = (let z_____________________ := 1%Z in Derive_n (fun z______________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z______________________) 2 (IZR z_____________________))) ->
  (forall t__ : R, (let z______________________ := 0%Z in Derive_n (fun z_______________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_______________________) 3 (IZR z______________________)) = (let z_______________________ := 1%Z in Derive_n (fun z________________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z________________________) 3 (IZR z_______________________))) ->
  entry (mvec [[Derive_n (fun t => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) 3%Z - (update1 Q (m - 1)%Z t) m)) 1 (Q (m - 1)%Z); Derive_n (fun t_ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) 3%Z - (update1 Q (m - 2)%Z t_) m)) 1 (Q (m - 2)%Z); Derive_n (fun t__ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) 3%Z - (update1 Q (m - 3)%Z t__) m)) 1 (Q (m - 3)%Z)]] [1; 2; 3]) 1 - PI ^ 2 * (1 - mu) * b3 mu1 n nu1 / a1 mu1 n nu1 = a3 m mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 - a m mu1 n nu * (c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 - mu1 - 4 * nu1) + PI ^ 3 * (1 + mu1)) + PI ^ 3 * (1 + nu).
End thm_2_b4.

Module thm_2_b4_corrected.
(* gbt-surfaces/thm-2.b4 (corrected), Sect. 2.2, coefficients after eq. (6)
   printed: b_4 = a_3 b_3 / a_1 - a (c_1 + 12(n-2)π^2 (1 - μ_1 - 4ν_1) + π^3 (1+μ_1)) + π^3 (1+ν)
   read as: The bracket of (6) on evenly spaced points, where the second and third differences vanish, with the a_3 and b_3 that the join has and with mu in the term with Q_{m-1} - Q_{m-2}: what is left is b_4.
   stated: (coefficients([b1*(Q1[3] - Q[m])], [Q[m-1], Q[m-2], Q[m-3]])*[1, 2, 3])[1] - pi^2*(1 - mu)*b3/a1 == 3*a*c1 - a3*b3/a1 + pi^2*(a*(6*n*(1 + 4*mu1 - nu1) + (12*nu1 - 12 - 48*mu1 - pi*(1 + mu1))) + pi*(1 + nu)) *)
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  b3_true mu1 n nu1.
Definition a3 (m : Z) (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  a3_true m mu1 n nu nu1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R) (Q1_3_of_t : R -> R) (Q1_0_of_t_ : R -> R) (Q1_1_of_t_ : R -> R) (Q1_2_of_t_ : R -> R) (Q1_3_of_t_ : R -> R) (Q1_0_of_t__ : R -> R) (Q1_1_of_t__ : R -> R) (Q1_2_of_t__ : R -> R) (Q1_3_of_t__ : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z ->
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z ->
  Q1_2_of_t (Q (m - 1)%Z) = Q1 2%Z ->
  Q1_3_of_t (Q (m - 1)%Z) = Q1 3%Z ->
  (forall t : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_______) 1 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q (m - 1)%Z t) m mu nu z________) 1 (IZR z_______))) ->
  (forall t : R, (let z________ := 0%Z in Derive_n (fun z_________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_________) 2 (IZR z________)) = (let z_________ := 1%Z in Derive_n (fun z__________ => F_ (update1 Q (m - 1)%Z t) m mu nu z__________) 2 (IZR z_________))) ->
  (forall t : R, (let z__________ := 0%Z in Derive_n (fun z___________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z___________) 3 (IZR z__________)) = (let z___________ := 1%Z in Derive_n (fun z____________ => F_ (update1 Q (m - 1)%Z t) m mu nu z____________) 3 (IZR z___________))) ->
  Q1_0_of_t_ (Q (m - 2)%Z) = Q1 0%Z ->
  Q1_1_of_t_ (Q (m - 2)%Z) = Q1 1%Z ->
  Q1_2_of_t_ (Q (m - 2)%Z) = Q1 2%Z ->
  Q1_3_of_t_ (Q (m - 2)%Z) = Q1 3%Z ->
  (forall t_ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 0%Z = F (update1 Q (m - 2)%Z t_) m mu nu 1%Z) ->
  (forall t_ : R, (let z____________ := 0%Z in Derive_n (fun z_____________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_____________) 1 (IZR z____________)) = (let z_____________ := 1%Z in Derive_n (fun z______________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z______________) 1 (IZR z_____________))) ->
  (forall t_ : R, (let z______________ := 0%Z in Derive_n (fun z_______________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_______________) 2 (IZR z______________)) = (let z_______________ := 1%Z in Derive_n (fun z________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z________________) 2 (IZR z_______________))) ->
  (forall t_ : R, (let z________________ := 0%Z in Derive_n (fun z_________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_________________) 3 (IZR z________________)) = (let z_________________ := 1%Z in Derive_n (fun z__________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z__________________) 3 (IZR z_________________))) ->
  Q1_0_of_t__ (Q (m - 3)%Z) = Q1 0%Z ->
  Q1_1_of_t__ (Q (m - 3)%Z) = Q1 1%Z ->
  Q1_2_of_t__ (Q (m - 3)%Z) = Q1 2%Z ->
  Q1_3_of_t__ (Q (m - 3)%Z) = Q1 3%Z ->
  (forall t__ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 0%Z = F (update1 Q (m - 3)%Z t__) m mu nu 1%Z) ->
  (forall t__ : R, (let z__________________ := 0%Z in Derive_n (fun z___________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z___________________) 1 (IZR z__________________)) = (let z___________________ := 1%Z in Derive_n (fun z____________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z____________________) 1 (IZR z___________________))) ->
  (forall t__ : R, (let z____________________ := 0%Z in Derive_n (fun z_____________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_____________________) 2 (IZR z____________________)) = (let z_____________________ := 1%Z in Derive_n (fun z______________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z______________________) 2 (IZR z_____________________))) ->
  (forall t__ : R, (let z______________________ := 0%Z in Derive_n (fun z_______________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_______________________) 3 (IZR z______________________)) = (let z_______________________ := 1%Z in Derive_n (fun z________________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z________________________) 3 (IZR z_______________________))) ->
  entry (mvec [[Derive_n (fun t => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) 3%Z - (update1 Q (m - 1)%Z t) m)) 1 (Q (m - 1)%Z); Derive_n (fun t_ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) 3%Z - (update1 Q (m - 2)%Z t_) m)) 1 (Q (m - 2)%Z); Derive_n (fun t__ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) 3%Z - (update1 Q (m - 3)%Z t__) m)) 1 (Q (m - 3)%Z)]] [1; 2; 3]) 1 - PI ^ 2 * (1 - mu) * b3 mu1 n nu1 / a1 mu1 n nu1 = 3 * a m mu1 n nu * c1 mu1 n - a3 m mu1 n nu nu1 * b3 mu1 n nu1 / a1 mu1 n nu1 + PI ^ 2 * (a m mu1 n nu * (6 * IZR n * (1 + 4 * mu1 - nu1) + (12 * nu1 - 12 - 48 * mu1 - PI * (1 + mu1))) + PI * (1 + nu)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R) (Q1_3_of_t : R -> R) (Q1_0_of_t_ : R -> R) (Q1_1_of_t_ : R -> R) (Q1_2_of_t_ : R -> R) (Q1_3_of_t_ : R -> R) (Q1_0_of_t__ : R -> R) (Q1_1_of_t__ : R -> R) (Q1_2_of_t__ : R -> R) (Q1_3_of_t__ : R -> R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) /\
  (0 <= 3 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 /\
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z /\
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z /\
  Q1_2_of_t (Q (m - 1)%Z) = Q1 2%Z /\
  Q1_3_of_t (Q (m - 1)%Z) = Q1 3%Z /\
  (forall t : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) /\
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_______) 1 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q (m - 1)%Z t) m mu nu z________) 1 (IZR z_______))) /\
  (forall t : R, (let z________ := 0%Z in Derive_n (fun z_________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_________) 2 (IZR z________)) = (let z_________ := 1%Z in Derive_n (fun z__________ => F_ (update1 Q (m - 1)%Z t) m mu nu z__________) 2 (IZR z_________))) /\
  (forall t : R, (let z__________ := 0%Z in Derive_n (fun z___________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z___________) 3 (IZR z__________)) = (let z___________ := 1%Z in Derive_n (fun z____________ => F_ (update1 Q (m - 1)%Z t) m mu nu z____________) 3 (IZR z___________))) /\
  Q1_0_of_t_ (Q (m - 2)%Z) = Q1 0%Z /\
  Q1_1_of_t_ (Q (m - 2)%Z) = Q1 1%Z /\
  Q1_2_of_t_ (Q (m - 2)%Z) = Q1 2%Z /\
  Q1_3_of_t_ (Q (m - 2)%Z) = Q1 3%Z /\
  (forall t_ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 0%Z = F (update1 Q (m - 2)%Z t_) m mu nu 1%Z) /\
  (forall t_ : R, (let z____________ := 0%Z in Derive_n (fun z_____________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_____________) 1 (IZR z____________)) = (let z_____________ := 1%Z in Derive_n (fun z______________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z______________) 1 (IZR z_____________))) /\
  (forall t_ : R, (let z______________ := 0%Z in Derive_n (fun z_______________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_______________) 2 (IZR z______________)) = (let z_______________ := 1%Z in Derive_n (fun z________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z________________) 2 (IZR z_______________))) /\
  (forall t_ : R, (let z________________ := 0%Z in Derive_n (fun z_________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_________________) 3 (IZR z________________)) = (let z_________________ := 1%Z in Derive_n (fun z__________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z__________________) 3 (IZR z_________________))) /\
  Q1_0_of_t__ (Q (m - 3)%Z) = Q1 0%Z /\
  Q1_1_of_t__ (Q (m - 3)%Z) = Q1 1%Z /\
  Q1_2_of_t__ (Q (m - 3)%Z) = Q1 2%Z /\
  Q1_3_of_t__ (Q (m - 3)%Z) = Q1 3%Z /\
  (forall t__ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 0%Z = F (update1 Q (m - 3)%Z t__) m mu nu 1%Z) /\
  (forall t__ : R, (let z__________________ := 0%Z in Derive_n (fun z___________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z___________________) 1 (IZR z__________________)) = (let z___________________ := 1%Z in Derive_n (fun z____________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z____________________) 1 (IZR z___________________))) /\
  (forall t__ : R, (let z____________________ := 0%Z in Derive_n (fun z_____________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_____________________) 2 (IZR z____________________)) = (let z_____________________ := 1%Z in Derive_n (fun z______________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z______________________) 2 (IZR z_____________________))) /\
  (forall t__ : R, (let z______________________ := 0%Z in Derive_n (fun z_______________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_______________________) 3 (IZR z______________________)) = (let z_______________________ := 1%Z in Derive_n (fun z________________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z________________________) 3 (IZR z_______________________))).
End thm_2_b4_corrected.

Module thm_2_b4_true.
(* gbt-surfaces/thm-2.b4.true, Sect. 2.2, coefficients after eq. (6)
   printed: The coefficient that the C3 join has.
   stated: (coefficients([b1*(Q1[3] - Q[m])], [Q[m-1], Q[m-2], Q[m-3]])*[1, 2, 3])[1] - pi^2*(1 - mu)*b3/a1 == b4_true *)
Definition b3 (mu1 : R) (n : Z) (nu1 : R) : R :=
  b3_true mu1 n nu1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R) (Q1_3_of_t : R -> R) (Q1_0_of_t_ : R -> R) (Q1_1_of_t_ : R -> R) (Q1_2_of_t_ : R -> R) (Q1_3_of_t_ : R -> R) (Q1_0_of_t__ : R -> R) (Q1_1_of_t__ : R -> R) (Q1_2_of_t__ : R -> R) (Q1_3_of_t__ : R -> R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z ->
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) ->
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) ->
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (0 <= m - 3 <= m)%Z ->
  a1 mu1 n nu1 <> 0 ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 ->
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 ->
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z ->
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z ->
  Q1_2_of_t (Q (m - 1)%Z) = Q1 2%Z ->
  Q1_3_of_t (Q (m - 1)%Z) = Q1 3%Z ->
  (forall t : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) ->
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_______) 1 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q (m - 1)%Z t) m mu nu z________) 1 (IZR z_______))) ->
  (forall t : R, (let z________ := 0%Z in Derive_n (fun z_________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_________) 2 (IZR z________)) = (let z_________ := 1%Z in Derive_n (fun z__________ => F_ (update1 Q (m - 1)%Z t) m mu nu z__________) 2 (IZR z_________))) ->
  (forall t : R, (let z__________ := 0%Z in Derive_n (fun z___________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z___________) 3 (IZR z__________)) = (let z___________ := 1%Z in Derive_n (fun z____________ => F_ (update1 Q (m - 1)%Z t) m mu nu z____________) 3 (IZR z___________))) ->
  Q1_0_of_t_ (Q (m - 2)%Z) = Q1 0%Z ->
  Q1_1_of_t_ (Q (m - 2)%Z) = Q1 1%Z ->
  Q1_2_of_t_ (Q (m - 2)%Z) = Q1 2%Z ->
  Q1_3_of_t_ (Q (m - 2)%Z) = Q1 3%Z ->
  (forall t_ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 0%Z = F (update1 Q (m - 2)%Z t_) m mu nu 1%Z) ->
  (forall t_ : R, (let z____________ := 0%Z in Derive_n (fun z_____________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_____________) 1 (IZR z____________)) = (let z_____________ := 1%Z in Derive_n (fun z______________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z______________) 1 (IZR z_____________))) ->
  (forall t_ : R, (let z______________ := 0%Z in Derive_n (fun z_______________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_______________) 2 (IZR z______________)) = (let z_______________ := 1%Z in Derive_n (fun z________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z________________) 2 (IZR z_______________))) ->
  (forall t_ : R, (let z________________ := 0%Z in Derive_n (fun z_________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_________________) 3 (IZR z________________)) = (let z_________________ := 1%Z in Derive_n (fun z__________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z__________________) 3 (IZR z_________________))) ->
  Q1_0_of_t__ (Q (m - 3)%Z) = Q1 0%Z ->
  Q1_1_of_t__ (Q (m - 3)%Z) = Q1 1%Z ->
  Q1_2_of_t__ (Q (m - 3)%Z) = Q1 2%Z ->
  Q1_3_of_t__ (Q (m - 3)%Z) = Q1 3%Z ->
  (forall t__ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 0%Z = F (update1 Q (m - 3)%Z t__) m mu nu 1%Z) ->
  (forall t__ : R, (let z__________________ := 0%Z in Derive_n (fun z___________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z___________________) 1 (IZR z__________________)) = (let z___________________ := 1%Z in Derive_n (fun z____________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z____________________) 1 (IZR z___________________))) ->
  (forall t__ : R, (let z____________________ := 0%Z in Derive_n (fun z_____________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_____________________) 2 (IZR z____________________)) = (let z_____________________ := 1%Z in Derive_n (fun z______________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z______________________) 2 (IZR z_____________________))) ->
  (forall t__ : R, (let z______________________ := 0%Z in Derive_n (fun z_______________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_______________________) 3 (IZR z______________________)) = (let z_______________________ := 1%Z in Derive_n (fun z________________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z________________________) 3 (IZR z_______________________))) ->
  entry (mvec [[Derive_n (fun t => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) 3%Z - (update1 Q (m - 1)%Z t) m)) 1 (Q (m - 1)%Z); Derive_n (fun t_ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) 3%Z - (update1 Q (m - 2)%Z t_) m)) 1 (Q (m - 2)%Z); Derive_n (fun t__ => b1 mu1 n nu1 * ((update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) 3%Z - (update1 Q (m - 3)%Z t__) m)) 1 (Q (m - 3)%Z)]] [1; 2; 3]) 1 - PI ^ 2 * (1 - mu) * b3 mu1 n nu1 / a1 mu1 n nu1 = b4_true m mu1 n nu nu1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (Q1_0_of_t : R -> R) (Q1_1_of_t : R -> R) (Q1_2_of_t : R -> R) (Q1_3_of_t : R -> R) (Q1_0_of_t_ : R -> R) (Q1_1_of_t_ : R -> R) (Q1_2_of_t_ : R -> R) (Q1_3_of_t_ : R -> R) (Q1_0_of_t__ : R -> R) (Q1_1_of_t__ : R -> R) (Q1_2_of_t__ : R -> R) (Q1_3_of_t__ : R -> R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  F1 Q1 mu1 n nu1 0%Z = F Q m mu nu 1%Z /\
  (let z := 0%Z in Derive_n (fun z_ => F1_ Q1 mu1 n nu1 z_) 1 (IZR z)) = (let z_ := 1%Z in Derive_n (fun z__ => F_ Q m mu nu z__) 1 (IZR z_)) /\
  (let z__ := 0%Z in Derive_n (fun z___ => F1_ Q1 mu1 n nu1 z___) 2 (IZR z__)) = (let z___ := 1%Z in Derive_n (fun z____ => F_ Q m mu nu z____) 2 (IZR z___)) /\
  (let z____ := 0%Z in Derive_n (fun z_____ => F1_ Q1 mu1 n nu1 z_____) 3 (IZR z____)) = (let z_____ := 1%Z in Derive_n (fun z______ => F_ Q m mu nu z______) 3 (IZR z_____)) /\
  (0 <= 3 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z /\
  (0 <= m - 3 <= m)%Z /\
  a1 mu1 n nu1 <> 0 /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  4 * (IZR n - 2) * (IZR n - 3) + 4 * PI * (1 + mu1) * (IZR n - 2) + PI ^ 2 * (1 - nu1) <> 0 /\
  4 * (IZR n - 3) * (IZR n - 4) + 6 * PI * (1 + mu1) * (IZR n - 3) + 3 * PI ^ 2 * (1 - nu1) <> 0 /\
  Q1_0_of_t (Q (m - 1)%Z) = Q1 0%Z /\
  Q1_1_of_t (Q (m - 1)%Z) = Q1 1%Z /\
  Q1_2_of_t (Q (m - 1)%Z) = Q1 2%Z /\
  Q1_3_of_t (Q (m - 1)%Z) = Q1 3%Z /\
  (forall t : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 0%Z = F (update1 Q (m - 1)%Z t) m mu nu 1%Z) /\
  (forall t : R, (let z______ := 0%Z in Derive_n (fun z_______ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_______) 1 (IZR z______)) = (let z_______ := 1%Z in Derive_n (fun z________ => F_ (update1 Q (m - 1)%Z t) m mu nu z________) 1 (IZR z_______))) /\
  (forall t : R, (let z________ := 0%Z in Derive_n (fun z_________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z_________) 2 (IZR z________)) = (let z_________ := 1%Z in Derive_n (fun z__________ => F_ (update1 Q (m - 1)%Z t) m mu nu z__________) 2 (IZR z_________))) /\
  (forall t : R, (let z__________ := 0%Z in Derive_n (fun z___________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t t)) 1%Z (Q1_1_of_t t)) 2%Z (Q1_2_of_t t)) 3%Z (Q1_3_of_t t)) mu1 n nu1 z___________) 3 (IZR z__________)) = (let z___________ := 1%Z in Derive_n (fun z____________ => F_ (update1 Q (m - 1)%Z t) m mu nu z____________) 3 (IZR z___________))) /\
  Q1_0_of_t_ (Q (m - 2)%Z) = Q1 0%Z /\
  Q1_1_of_t_ (Q (m - 2)%Z) = Q1 1%Z /\
  Q1_2_of_t_ (Q (m - 2)%Z) = Q1 2%Z /\
  Q1_3_of_t_ (Q (m - 2)%Z) = Q1 3%Z /\
  (forall t_ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 0%Z = F (update1 Q (m - 2)%Z t_) m mu nu 1%Z) /\
  (forall t_ : R, (let z____________ := 0%Z in Derive_n (fun z_____________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_____________) 1 (IZR z____________)) = (let z_____________ := 1%Z in Derive_n (fun z______________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z______________) 1 (IZR z_____________))) /\
  (forall t_ : R, (let z______________ := 0%Z in Derive_n (fun z_______________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_______________) 2 (IZR z______________)) = (let z_______________ := 1%Z in Derive_n (fun z________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z________________) 2 (IZR z_______________))) /\
  (forall t_ : R, (let z________________ := 0%Z in Derive_n (fun z_________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t_ t_)) 1%Z (Q1_1_of_t_ t_)) 2%Z (Q1_2_of_t_ t_)) 3%Z (Q1_3_of_t_ t_)) mu1 n nu1 z_________________) 3 (IZR z________________)) = (let z_________________ := 1%Z in Derive_n (fun z__________________ => F_ (update1 Q (m - 2)%Z t_) m mu nu z__________________) 3 (IZR z_________________))) /\
  Q1_0_of_t__ (Q (m - 3)%Z) = Q1 0%Z /\
  Q1_1_of_t__ (Q (m - 3)%Z) = Q1 1%Z /\
  Q1_2_of_t__ (Q (m - 3)%Z) = Q1 2%Z /\
  Q1_3_of_t__ (Q (m - 3)%Z) = Q1 3%Z /\
  (forall t__ : R, F1 (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 0%Z = F (update1 Q (m - 3)%Z t__) m mu nu 1%Z) /\
  (forall t__ : R, (let z__________________ := 0%Z in Derive_n (fun z___________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z___________________) 1 (IZR z__________________)) = (let z___________________ := 1%Z in Derive_n (fun z____________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z____________________) 1 (IZR z___________________))) /\
  (forall t__ : R, (let z____________________ := 0%Z in Derive_n (fun z_____________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_____________________) 2 (IZR z____________________)) = (let z_____________________ := 1%Z in Derive_n (fun z______________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z______________________) 2 (IZR z_____________________))) /\
  (forall t__ : R, (let z______________________ := 0%Z in Derive_n (fun z_______________________ => F1_ (update1 (update1 (update1 (update1 Q1 0%Z (Q1_0_of_t__ t__)) 1%Z (Q1_1_of_t__ t__)) 2%Z (Q1_2_of_t__ t__)) 3%Z (Q1_3_of_t__ t__)) mu1 n nu1 z_______________________) 3 (IZR z______________________)) = (let z_______________________ := 1%Z in Derive_n (fun z________________________ => F_ (update1 Q (m - 3)%Z t__) m mu nu z________________________) 3 (IZR z_______________________))).
End thm_2_b4_true.

Module thm_2_c1.
(* gbt-surfaces/thm-2.c1, Sect. 2.2, coefficients after eq. (6)
   printed: c_1 = 4(n-2)(n-3)(2(n-4) + 3π(1+μ_1))
   read as: What b_1 has beside its last term.
   stated: b1 - 6*(n - 2)*pi^2*(1 - nu1) == 4*(n - 2)*(n - 3)*(2*(n - 4) + 3*pi*(1 + mu1)) *)
Definition statement : Prop :=
forall (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  b1 mu1 n nu1 - 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1) = 4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
Definition instance : Prop :=
exists (n : Z) (mu1 : R) (nu1 : R),
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu1 <= 1.
End thm_2_c1.
