(* Statements of gbt-surfaces, Section 3 5. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition section (A : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * A k).
Definition trajectory (B : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * B l).
Definition T (A : Z -> R) (B : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  trajectory B mu1 n nu1 z1 + section A m mu nu z.
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition S1 : list (list R) :=
  [[2; 0; 2]; [1; 0; 3]; [5; 0; 4]; [6; 0; 3]].
Definition S2 : list (list R) :=
  [[6; 0; 3]; [7; 0; 2]; [3; 0; 1]; [2; 0; 2]].
Definition T1 : list (list R) :=
  [[4; 0; 0]; [0; 1; 0]; [0; 2; 0]; [4; 3; 0]].
Definition T2 : list (list R) :=
  [[4; 3; 0]; [8; 4; 0]; [8; 5; 0]; [4; 6; 0]].
Definition second (mu1 : R) (nu1 : R) (M : list (list R)) (z : R) : list R :=
  vsum 3 0%Z 3%Z (fun k => vscale (f z mu1 nu1 k 3%Z) (row M (Z.to_nat (k + 1)%Z))).
Definition first (mu : R) (nu : R) (M : list (list R)) (z : R) : list R :=
  vsum 3 0%Z 3%Z (fun k => vscale (f z mu nu k 3%Z) (row M (Z.to_nat (k + 1)%Z))).
Definition gap (mu : R) (mu1 : R) (nu : R) (nu1 : R) (M : list (list R)) (N_ : list (list R)) (r : Z) : list R :=
  vsub ((fun z : R => vDerive 3 (fun z => second mu1 nu1 N_ z) (Z.to_nat r) z) 0) ((fun z : R => vDerive 3 (fun z => first mu nu M z) (Z.to_nat r) z) 1).
End Definitions.
Import Definitions.

Module eq_27.
(* gbt-surfaces/eq-27, Sect. 3.5, eq. (27)
   printed: F_m(z;μ,ν) = sum_{k=0}^{m} f_{k,m}(z) Q_{k,m}, 0 ≤ z ≤ 1; F_n(z_1;μ_1,ν_1) = sum_{l=0}^{n} f_{l,n}(z_1) Q_{l,n}, 0 ≤ z_1 ≤ 1
   read as: The formulas, and the ends of the curves. The points of the two curves are kept apart.
   stated: section(z) == sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) and section(0) == A[0] and section(1) == A[m] and trajectory(z1) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*B[l]) and trajectory(0) == B[0] and trajectory(1) == B[n] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  section A m mu nu z = sum 0%Z m (fun k => f z mu nu k m * A k) /\ section A m mu nu 0 = A 0%Z /\ section A m mu nu 1 = A m /\ trajectory B mu1 n nu1 z1 = sum 0%Z n (fun l => f z1 mu1 nu1 l n * B l) /\ trajectory B mu1 n nu1 0 = B 0%Z /\ trajectory B mu1 n nu1 1 = B n.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_27.

Module sec_3_5_categories.
(* gbt-surfaces/sec-3.5.categories, Sect. 3.5, two bullet items
   printed: M(z_1) is an identity matrix, which for all z_1 and F_m(z) is just translated by F_n(z_1). / M(z_1) is not an identity matrix.
   read as: The first case, for a point p of the section and a point q of the trajectory.
   stated: q + identity(3)*p == q + p *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  vadd q (mvec (identity 3) p) = vadd q p.
End sec_3_5_categories.

Module sec_3_5_not_expressible_sine.
(* gbt-surfaces/sec-3.5.not-expressible.sine, Sect. 3.5, paragraph after eq. (28)
   printed: With both shape parameters -1 the cubic of (0, 0), (1, 0), (0, 1), (1, 1) is the graph of sin^2(π/2 x).
   stated: f[1,3](z, -1, -1) + f[3,3](z, -1, -1) == z and f[2,3](z, -1, -1) + f[3,3](z, -1, -1) == sin(pi/2*z)^2 *)
Definition statement : Prop :=
forall (z : R),
  0 <= z <= 1 ->
  f z (- 1) (- 1) 1%Z 3%Z + f z (- 1) (- 1) 3%Z 3%Z = z /\ f z (- 1) (- 1) 2%Z 3%Z + f z (- 1) (- 1) 3%Z 3%Z = sin (PI / 2 * z) ^ 2.
Definition instance : Prop :=
exists (z : R),
  0 <= z <= 1.
End sec_3_5_not_expressible_sine.

Module eq_29.
(* gbt-surfaces/eq-29, Sect. 3.5, eq. (29)
   printed: T_swept(z,z_1;μ,ν,μ_1,ν_1) = F_n(z_1) + F_m(z)
   read as: (28) with the identity matrix.
   stated: moved(identity(3)) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*B3[l]) + sum(k, 0, m, f[k,m](z, mu, nu)*A3[k]) *)
Definition moved (A3 : Z -> list R) (B3 : Z -> list R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) (M : list (list R)) : list R :=
  vadd (vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) (B3 l))) (mvec M (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (A3 k)))).
Definition statement : Prop :=
forall (m : Z) (n : Z) (A3'1 A3'2 A3'3 : Z -> R) (B3'1 B3'2 B3'3 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  let A3 := fun i0 => [A3'1 i0; A3'2 i0; A3'3 i0] in
  let B3 := fun i0 => [B3'1 i0; B3'2 i0; B3'3 i0] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  moved A3 B3 m mu mu1 n nu nu1 z z1 (identity 3) = vadd (vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) (B3 l))) (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (A3 k))).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A3'1 A3'2 A3'3 : Z -> R) (B3'1 B3'2 B3'3 : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  let A3 := fun i0 => [A3'1 i0; A3'2 i0; A3'3 i0] in
  let B3 := fun i0 => [B3'1 i0; B3'2 i0; B3'3 i0] in
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_29.

Module eq_30.
(* gbt-surfaces/eq-30, Sect. 3.5, Theorem 5, eq. (30)
   printed: T_swept(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{n} f_{k,m}(z) f_{l,n}(z_1) Qhat_{k,l}, z, z_1 ∈ [0,1], Qhat_{k,l} = Q_{k,m} + Q_{l,n} (k = 0, 1, ..., m; l = 0, 1, ..., n)
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(A[k] + B[l]))) == T(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (A k + B l))) = T A B m mu mu1 n nu nu1 z z1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_30.

Module eq_31_2.
(* gbt-surfaces/eq-31.2, Sect. 3.5, proof of Theorem 5, eq. (31), second line
   printed: F_n(z_1) + F_m(z) = sum_{l=0}^{n} Q_{l,n} f_{l,n}(z_1) + sum_{k=0}^{m} Q_{k,m} f_{k,m}(z)
   stated: T(z, z1) == sum(l, 0, n, B[l]*f[l,n](z1, mu1, nu1)) + sum(k, 0, m, A[k]*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T A B m mu mu1 n nu nu1 z z1 = sum 0%Z n (fun l => B l * f z1 mu1 nu1 l n) + sum 0%Z m (fun k => A k * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_31_2.

Module eq_31_3.
(* gbt-surfaces/eq-31.3, Sect. 3.5, proof of Theorem 5, eq. (31), third line
   printed: = sum_{k=0}^{m} f_{k,m}(z) sum_{l=0}^{n} Q_{l,n} f_{l,n}(z_1) + sum_{l=0}^{n} f_{l,n}(z_1) sum_{k=0}^{m} Q_{k,m} f_{k,m}(z)
   stated: sum(l, 0, n, B[l]*f[l,n](z1, mu1, nu1)) + sum(k, 0, m, A[k]*f[k,m](z, mu, nu)) == sum(k, 0, m, f[k,m](z, mu, nu))*sum(l, 0, n, B[l]*f[l,n](z1, mu1, nu1)) + sum(l, 0, n, f[l,n](z1, mu1, nu1))*sum(k, 0, m, A[k]*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z n (fun l => B l * f z1 mu1 nu1 l n) + sum 0%Z m (fun k => A k * f z mu nu k m) = sum 0%Z m (fun k => f z mu nu k m) * sum 0%Z n (fun l => B l * f z1 mu1 nu1 l n) + sum 0%Z n (fun l => f z1 mu1 nu1 l n) * sum 0%Z m (fun k => A k * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_31_3.

Module eq_31_4.
(* gbt-surfaces/eq-31.4, Sect. 3.5, proof of Theorem 5, eq. (31), fourth line
   printed: = sum_{k=0}^{m} sum_{l=0}^{n} f_{k,m}(z) f_{l,n}(z_1) Q_{l,n} + sum_{k=0}^{m} sum_{l=0}^{n} f_{k,m}(z) f_{l,n}(z_1) Q_{k,m}
   stated: sum(k, 0, m, f[k,m](z, mu, nu))*sum(l, 0, n, B[l]*f[l,n](z1, mu1, nu1)) + sum(l, 0, n, f[l,n](z1, mu1, nu1))*sum(k, 0, m, A[k]*f[k,m](z, mu, nu)) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*B[l])) + sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*A[k])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => f z mu nu k m) * sum 0%Z n (fun l => B l * f z1 mu1 nu1 l n) + sum 0%Z n (fun l => f z1 mu1 nu1 l n) * sum 0%Z m (fun k => A k * f z mu nu k m) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * B l)) + sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * A k)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_31_4.

Module eq_31_5.
(* gbt-surfaces/eq-31.5, Sect. 3.5, proof of Theorem 5, eq. (31), fifth and sixth line
   printed: = sum_{k=0}^{m} sum_{l=0}^{n} f_{k,m}(z) f_{l,n}(z_1) (Q_{l,n} + Q_{k,m}) = sum_{k=0}^{m} sum_{l=0}^{n} f_{k,m}(z) f_{l,n}(z_1) Qhat_{k,l}
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*B[l])) + sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*A[k])) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(B[l] + A[k]))) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * B l)) + sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * A k)) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (B l + A k))).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_31_5.

Module prop_3_7_1_a.
(* gbt-surfaces/prop-3.7.1.a, Sect. 3.5, Proposition 3.7, item 1
   printed: As the tensor product GBT-Bézier surface is used to express the GBT-Bézier swept surface, so it holds all the characteristics and benefits of the GBT-Bézier surface.
   read as: Convex hull and affine invariance (nonnegative weights that sum to one) and interpolation of the corners.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, n, f[l,n](z1, mu1, nu1))) == 1 and T(0, 0) == A[0] + B[0] and T(1, 0) == A[m] + B[0] and T(0, 1) == A[0] + B[n] and T(1, 1) == A[m] + B[n] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n)) = 1 /\ T A B m mu mu1 n nu nu1 0 0 = A 0%Z + B 0%Z /\ T A B m mu mu1 n nu nu1 1 0 = A m + B 0%Z /\ T A B m mu mu1 n nu nu1 0 1 = A 0%Z + B n /\ T A B m mu mu1 n nu nu1 1 1 = A m + B n.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_7_1_a.

Module prop_3_7_2a.
(* gbt-surfaces/prop-3.7.2a, Sect. 3.5, Proposition 3.7, item 2, first sentence
   printed: By keeping control mesh fixed and varying the values of shape control parameters, the shape of the GBT-Bézier swept surface can be modified.
   stated: fails(D(at(D(T(z, z1), z), z, 0), mu) == 0) and fails(D(at(D(T(z, z1), z), z, 1), nu) == 0) and fails(D(at(D(T(z, z1), z1), z1, 0), mu1) == 0) and fails(D(at(D(T(z, z1), z1), z1, 1), nu1) == 0) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => (fun z : R => Derive_n (fun z => T A B m mu mu1 n nu nu1 z z1) 1 z) 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => (fun z : R => Derive_n (fun z => T A B m mu mu1 n nu nu1 z z1) 1 z) 1) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu1 => (fun z1 : R => Derive_n (fun z1 => T A B m mu mu1 n nu nu1 z z1) 1 z1) 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu1 => (fun z1 : R => Derive_n (fun z1 => T A B m mu mu1 n nu nu1 z z1) 1 z1) 1) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_7_2a.

Module prop_3_7_2b.
(* gbt-surfaces/prop-3.7.2b, Sect. 3.5, Proposition 3.7, item 2, second sentence
   printed: the composite GBT-Bézier swept surfaces can also be constructed like the previous surfaces
   read as: The jump of each derivative of the surface is the jump of the sections (trajectories), so it vanishes if and only if that does.
   stated: along_sections(0) == jump_section(0) and along_sections(1) == jump_section(1) and along_sections(2) == jump_section(2) and along_trajectories(0) == jump_trajectory(0) and along_trajectories(1) == jump_trajectory(1) and along_trajectories(2) == jump_trajectory(2) *)
Definition section2 (A2 : Z -> R) (mu2 : R) (n : Z) (nu2 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu2 nu2 k n * A2 k).
Definition trajectory2 (B2 : Z -> R) (m : Z) (mu2 : R) (nu2 : R) (z1 : R) : R :=
  sum 0%Z m (fun l => f z1 mu2 nu2 l m * B2 l).
Definition along_sections (A : Z -> R) (A2 : Z -> R) (W : R) (m : Z) (mu : R) (mu2 : R) (n : Z) (nu : R) (nu2 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => section2 A2 mu2 n nu2 z + W) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => section A m mu nu z + W) (Z.to_nat r) z) 1.
Definition jump_section (A : Z -> R) (A2 : Z -> R) (m : Z) (mu : R) (mu2 : R) (n : Z) (nu : R) (nu2 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => section2 A2 mu2 n nu2 z) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => section A m mu nu z) (Z.to_nat r) z) 1.
Definition along_trajectories (B : Z -> R) (B2 : Z -> R) (W : R) (m : Z) (mu1 : R) (mu2 : R) (n : Z) (nu1 : R) (nu2 : R) (r : Z) : R :=
  (fun z1 : R => Derive_n (fun z1 => W + trajectory2 B2 m mu2 nu2 z1) (Z.to_nat r) z1) 0 - (fun z1 : R => Derive_n (fun z1 => W + trajectory B mu1 n nu1 z1) (Z.to_nat r) z1) 1.
Definition jump_trajectory (B : Z -> R) (B2 : Z -> R) (m : Z) (mu1 : R) (mu2 : R) (n : Z) (nu1 : R) (nu2 : R) (r : Z) : R :=
  (fun z1 : R => Derive_n (fun z1 => trajectory2 B2 m mu2 nu2 z1) (Z.to_nat r) z1) 0 - (fun z1 : R => Derive_n (fun z1 => trajectory B mu1 n nu1 z1) (Z.to_nat r) z1) 1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (A2 : Z -> R) (B : Z -> R) (B2 : Z -> R) (W : R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  along_sections A A2 W m mu mu2 n nu nu2 0%Z = jump_section A A2 m mu mu2 n nu nu2 0%Z /\ along_sections A A2 W m mu mu2 n nu nu2 1%Z = jump_section A A2 m mu mu2 n nu nu2 1%Z /\ along_sections A A2 W m mu mu2 n nu nu2 2%Z = jump_section A A2 m mu mu2 n nu nu2 2%Z /\ along_trajectories B B2 W m mu1 mu2 n nu1 nu2 0%Z = jump_trajectory B B2 m mu1 mu2 n nu1 nu2 0%Z /\ along_trajectories B B2 W m mu1 mu2 n nu1 nu2 1%Z = jump_trajectory B B2 m mu1 mu2 n nu1 nu2 1%Z /\ along_trajectories B B2 W m mu1 mu2 n nu1 nu2 2%Z = jump_trajectory B B2 m mu1 mu2 n nu1 nu2 2%Z.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (A2 : Z -> R) (B : Z -> R) (B2 : Z -> R) (W : R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1.
End prop_3_7_2b.

Module alg_5_a.
(* gbt-surfaces/alg-5.a, Sect. 3.5, Algorithm 5, steps 1 to 4
   printed: 1. Consider a SC which sweeps to the trajectory curve (both GBT-Bézier curves). 2. Construct by using (30). 3. Follow the pattern Qhat_{k,l} = Q_{k,m} + Q_{l,n} (k = 0, 1, ..., m; l = 0, 1, ..., n), where Q_{k,m}, Q_{l,n} are the control points of section and TCs. 4. Draw with different values of μ, ν in [-1, 1].
   read as: The pattern of step 3 gives the swept surface.
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(A[k] + B[l]))) == T(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (A k + B l))) = T A B m mu mu1 n nu nu1 z z1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : Z -> R) (B : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End alg_5_a.

Module alg_5_b.
(* gbt-surfaces/alg-5.b, Sect. 3.5, Algorithm 5, step 5
   printed: 5. Two adjacent GBT-Bézier swept surfaces can be connected by C1 and C2 continuity conditions given in Theorem 2.
   read as: The sections F and F_1 are joined with Theorem 2 as printed, with one trajectory, of which W is a point.
   stated: after(0) == before(1) and after'(0) == before'(1) and after''(0) == before''(1) *)
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
Definition F1 (Q1 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Q1 k).
Definition after (Q1 : Z -> R) (W : R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  F1 Q1 mu1 n nu1 z + W.
Definition before (Q : Z -> R) (W : R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  F Q m mu nu z + W.
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (Q1 : Z -> R) (W : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R),
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
  after Q1 W mu1 n nu1 0 = before Q W m mu nu 1 /\ Derive_n (fun z => after Q1 W mu1 n nu1 z) 1 0 = Derive_n (fun z => before Q W m mu nu z) 1 1 /\ Derive_n (fun z => after Q1 W mu1 n nu1 z) 2 0 = Derive_n (fun z => before Q W m mu nu z) 2 1.
End alg_5_b.

Module ex_3_5_sections.
(* gbt-surfaces/ex-3.5.sections, Sect. 3.5, Example 3.5, data
   printed: (2, 0, 2), (1, 0, 3), (5, 0, 4), (6, 0, 3) and (6, 0, 3), (7, 0, 2), (3, 0, 1), (2, 0, 2)
   read as: The curves are contiguous and lie in the plane XOZ.
   stated: S1[4] == S2[1] and S1*[0, 1, 0] == [0, 0, 0, 0] and S2*[0, 1, 0] == [0, 0, 0, 0] *)
Definition statement : Prop :=
  row S1 4 = row S2 1 /\ mvec S1 [0; 1; 0] = [0; 0; 0; 0] /\ mvec S2 [0; 1; 0] = [0; 0; 0; 0].
End ex_3_5_sections.

Module ex_3_5_trajectories.
(* gbt-surfaces/ex-3.5.trajectories, Sect. 3.5, Example 3.5, data
   printed: (4, 0, 0), (0, 1, 0), (0, 2, 0), (4, 3, 0) and (4, 3, 0), (8, 4, 0), (8, 5, 0), (4, 6, 0)
   read as: The curves are contiguous and lie in the plane XOY.
   stated: T1[4] == T2[1] and T1*[0, 0, 1] == [0, 0, 0, 0] and T2*[0, 0, 1] == [0, 0, 0, 0] *)
Definition statement : Prop :=
  row T1 4 = row T2 1 /\ mvec T1 [0; 0; 1] = [0; 0; 0; 0] /\ mvec T2 [0; 0; 1] = [0; 0; 0; 0].
End ex_3_5_trajectories.

Module ex_3_5_c1_sections.
(* gbt-surfaces/ex-3.5.c1-sections, Sect. 3.5, Example 3.5, last sentence (C1, section curves)
   printed: Figure 19 and Fig. 20 depict the composite curves of two contiguous GBT-Bézier swept surfaces with different shape parameters which can be connected by C1 and C2 continuity constraints, respectively.
   read as: There are admissible shape parameters: mu_1 of the second section from nu of the first.
   stated: gap(S1, S2, 0) == 0 and mu1 == nu and -1 <= mu1 and mu1 <= 1 *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  gap mu mu1 nu nu1 S1 S2 1%Z = zeros 3 ->
  gap mu mu1 nu nu1 S1 S2 0%Z = zeros 3 /\ mu1 = nu /\ - 1 <= mu1 /\ mu1 <= 1.
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) /\
  gap mu mu1 nu nu1 S1 S2 1%Z = zeros 3.
End ex_3_5_c1_sections.

Module ex_3_5_c1_trajectories.
(* gbt-surfaces/ex-3.5.c1-trajectories, Sect. 3.5, Example 3.5, last sentence (C1, trajectory curves)
   printed: Figure 19 and Fig. 20 depict the composite curves of two contiguous GBT-Bézier swept surfaces with different shape parameters which can be connected by C1 and C2 continuity constraints, respectively.
   read as: There are admissible shape parameters: mu_1 of the second trajectory from nu of the first.
   stated: gap(T1, T2, 0) == 0 and mu1 == nu and -1 <= mu1 and mu1 <= 1 *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  gap mu mu1 nu nu1 T1 T2 1%Z = zeros 3 ->
  gap mu mu1 nu nu1 T1 T2 0%Z = zeros 3 /\ mu1 = nu /\ - 1 <= mu1 /\ mu1 <= 1.
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) /\
  gap mu mu1 nu nu1 T1 T2 1%Z = zeros 3.
End ex_3_5_c1_trajectories.

Module ex_3_5_c2_sections.
(* gbt-surfaces/ex-3.5.c2-sections, Sect. 3.5, Example 3.5, last sentence (C2, section curves)
   printed: Figure 19 and Fig. 20 depict the composite curves of two contiguous GBT-Bézier swept surfaces with different shape parameters which can be connected by C1 and C2 continuity constraints, respectively.
   read as: There are admissible shape parameters: mu_1, nu and nu_1 from the conditions for C1 and C2, for any mu.
   stated: gap(S1, S2, 0) == 0 and nu == -2/(2 + pi) and mu1 == nu and -1 <= nu and nu <= 1 and nu1 == mu and -1 <= nu1 and nu1 <= 1 *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  gap mu mu1 nu nu1 S1 S2 1%Z = zeros 3 ->
  gap mu mu1 nu nu1 S1 S2 2%Z = zeros 3 ->
  2 + PI <> 0 ->
  gap mu mu1 nu nu1 S1 S2 0%Z = zeros 3 /\ nu = - 2 / (2 + PI) /\ mu1 = nu /\ - 1 <= nu /\ nu <= 1 /\ nu1 = mu /\ - 1 <= nu1 /\ nu1 <= 1.
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) /\
  gap mu mu1 nu nu1 S1 S2 1%Z = zeros 3 /\
  gap mu mu1 nu nu1 S1 S2 2%Z = zeros 3 /\
  2 + PI <> 0.
End ex_3_5_c2_sections.

Module ex_3_5_c2_trajectories.
(* gbt-surfaces/ex-3.5.c2-trajectories, Sect. 3.5, Example 3.5, last sentence (C2, trajectory curves)
   printed: Figure 19 and Fig. 20 depict the composite curves of two contiguous GBT-Bézier swept surfaces with different shape parameters which can be connected by C1 and C2 continuity constraints, respectively.
   read as: There are admissible shape parameters: mu_1, nu and nu_1 from the conditions for C1 and C2, for any mu.
   stated: gap(T1, T2, 0) == 0 and -1 <= nu and nu <= 1 and nu1 <= 1 *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  gap mu mu1 nu nu1 T1 T2 1%Z = zeros 3 ->
  gap mu mu1 nu nu1 T1 T2 2%Z = zeros 3 ->
  gap mu mu1 nu nu1 T1 T2 0%Z = zeros 3 /\ - 1 <= nu /\ nu <= 1 /\ nu1 <= 1.
End ex_3_5_c2_trajectories.

Module ex_3_5_c2_trajectories_true.
(* gbt-surfaces/ex-3.5.c2-trajectories.true, Sect. 3.5, Example 3.5, last sentence (C2, trajectory curves)
   printed: The shape parameters with which the trajectories would join with C2: the last is outside of its range for every μ.
   stated: nu == -2/(2 + pi) and mu1 == nu and nu1 == 2 + 8/(2 + pi) - mu and nu1 > 1 *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  gap mu mu1 nu nu1 T1 T2 1%Z = zeros 3 ->
  gap mu mu1 nu nu1 T1 T2 2%Z = zeros 3 ->
  2 + PI <> 0 ->
  nu = - 2 / (2 + PI) /\ mu1 = nu /\ nu1 = 2 + 8 / (2 + PI) - mu /\ nu1 > 1.
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) /\
  gap mu mu1 nu nu1 T1 T2 1%Z = zeros 3 /\
  gap mu mu1 nu nu1 T1 T2 2%Z = zeros 3 /\
  2 + PI <> 0.
End ex_3_5_c2_trajectories_true.

Module ex_3_5_contiguous_each_with_its_own.
(* gbt-surfaces/ex-3.5.contiguous.each with its own, Sect. 3.5, Example 3.5
   printed: two contiguous GBT-Bézier swept surfaces
   read as: The first section goes along the first trajectory, the second along the second; contiguous surfaces share a boundary curve.
   stated: first(S1, 1) + first(T1, z1) == second(S2, 0) + second(T2, z1) *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  vadd (first mu nu S1 1) (first mu nu T1 z1) = vadd (second mu1 nu1 S2 0) (second mu1 nu1 T2 z1).
End ex_3_5_contiguous_each_with_its_own.

Module ex_3_5_contiguous_one_trajectory.
(* gbt-surfaces/ex-3.5.contiguous.one trajectory, Sect. 3.5, Example 3.5
   printed: two contiguous GBT-Bézier swept surfaces
   read as: Both sections go along the first trajectory.
   stated: first(S1, 1) + first(T1, z1) == second(S2, 0) + first(T1, z1) *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  vadd (first mu nu S1 1) (first mu nu T1 z1) = vadd (second mu1 nu1 S2 0) (first mu nu T1 z1).
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z).
End ex_3_5_contiguous_one_trajectory.

Module ex_3_5_contiguous_one_section.
(* gbt-surfaces/ex-3.5.contiguous.one section, Sect. 3.5, Example 3.5
   printed: two contiguous GBT-Bézier swept surfaces
   read as: The first section goes along both trajectories.
   stated: first(S1, z) + first(T1, 1) == first(S1, z) + second(T2, 0) *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z) ->
  vadd (first mu nu S1 z) (first mu nu T1 1) = vadd (first mu nu S1 z) (second mu1 nu1 T2 0).
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= 3)%Z -> (1 <= (k + 1) <= 4)%Z).
End ex_3_5_contiguous_one_section.

Module sec_3_5_unnecessary.
(* gbt-surfaces/sec-3.5.unnecessary, Sect. 3.5, sentence after eq. (28)
   printed: Normally, equation (28) can generate an unnecessary surface with degeneracy and without continuity.
   read as: The matrix S(z_1) is not restricted: with a multiple s of the unit matrix the surface is (28) with s F_m, for s = 0 it is a curve, and where the multiple jumps from s to t the surface jumps by the same multiple of F_m.
   stated: D(by(s), z) == s*D(F(z), z) and D(by(0), z) == 0 and by(t) - by(s) == (t - s)*F(z) *)
Definition by_ (P : R) (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) (s : R) : R :=
  P + s * F Q m mu nu z.
Definition statement : Prop :=
forall (m : Z) (P : R) (Q : Z -> R) (mu : R) (nu : R) (s : R) (t : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  Derive_n (fun z => by_ P Q m mu nu z s) 1 z = s * Derive_n (fun z => F Q m mu nu z) 1 z /\ Derive_n (fun z => by_ P Q m mu nu z 0) 1 z = 0 /\ by_ P Q m mu nu z t - by_ P Q m mu nu z s = (t - s) * F Q m mu nu z.
Definition instance : Prop :=
exists (m : Z) (P : R) (Q : Z -> R) (mu : R) (nu : R) (s : R) (t : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End sec_3_5_unnecessary.
