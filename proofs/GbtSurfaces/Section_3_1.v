(* Statements of gbt-surfaces, Section 3 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition T (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition T_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m).
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition net (Q : Z -> R) (V : R) (alpha : R) (k : Z) (l : Z) : R :=
  Q k + IZR l * alpha * V.
Definition b (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - z) ^ 1 * z ^ 0; (1 - z) ^ 0 * z ^ 1] i k.
Definition tensor (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition tensor_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition V31 : list R :=
  [0; 0; 1].
Definition alpha31 : R :=
  20.
Definition Q31 : list (list R) :=
  [[5; 2; 0]; [0; 12; 0]; [10; 20; 0]; [20; 12; 0]; [15; 2; 0]].
End Definitions.
Import Definitions.

Module sec_3_1_i.
(* gbt-surfaces/sec-3.1.i, Sect. 3.1, requirement (i)
   printed: The curve T(z,z_1,μ,ν) is a straight line segment from point F_m(z,μ,ν) to F_m(z,μ,ν) + αV for fixed z (0 ≤ z ≤ 1)
   stated: T(z, 0) == F(z) and T(z, 1) == F(z) + alpha*V and D(T(z, z1), z1, 2) == 0 *)
Definition T (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  sum 0%Z m (fun k => (Q k + IZR z1 * alpha * V) * f z mu nu k m).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z 0%Z = F Q m mu nu z /\ T Q V alpha m mu nu z 1%Z = F Q m mu nu z + alpha * V /\ Derive_n (fun z1_ => T_ Q V alpha m mu nu z z1_) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_1_i.

Module eq_8_1.
(* gbt-surfaces/eq-8.1, Sect. 3.1, requirement (ii), eq. (8), first line
   printed: T(z,z_1,μ,ν) = F_m(z,μ,ν) + z_1 αV   for fixed z_1 (0 ≤ z_1 ≤ 1)
   stated: T(z, z1) - F(z) == z1*alpha*V *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z z1 - F Q m mu nu z = z1 * alpha * V.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_8_1.

Module eq_8_2.
(* gbt-surfaces/eq-8.2, Sect. 3.1, requirement (ii), eq. (8), second line
   printed: F_m(z,μ,ν) + z_1 αV = sum_{k=0}^{m} (Q_k + z_1 αV) f_{k,m}(z)
   stated: F(z) + z1*alpha*V == sum(k, 0, m, (Q[k] + z1*alpha*V)*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  F Q m mu nu z + z1 * alpha * V = sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_8_2.

Module prop_3_1.
(* gbt-surfaces/prop-3.1, Sect. 3.1, Proposition 3.1, eq. (9)
   printed: T_cylinder(z,z_1,μ,ν) = sum_{k=0}^{m} (Q_k + z_1 αV) f_{k,m}(z), z, z_1 ∈ [0,1], α > 0 a certain real constant
   stated: T(z, 0) == F(z) and T(z, 1) == F(z) + alpha*V and D(T(z, z1), z1, 2) == 0 and T(z, z1) == F(z) + z1*alpha*V *)
Definition T (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  sum 0%Z m (fun k => (Q k + IZR z1 * alpha * V) * f z mu nu k m).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z 0%Z = F Q m mu nu z /\ T Q V alpha m mu nu z 1%Z = F Q m mu nu z + alpha * V /\ Derive_n (fun z1_ => T_ Q V alpha m mu nu z z1_) 2 z1 = 0 /\ T_ Q V alpha m mu nu z z1 = F Q m mu nu z + z1 * alpha * V.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_1.

Module sec_3_1_translating.
(* gbt-surfaces/sec-3.1.translating, Sect. 3.1, paragraph after Figure 3
   printed: the GBT-Bézier cylinder T_cylinder is a surface which is generated by translating a small portion of the straight line from F_m(0) to F_m(0) + αV along an assigned curve F_m(z,μ,ν)
   stated: T(z, z1) == F(0) + z1*alpha*V + (F(z) - F(0)) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z z1 = F Q m mu nu 0%Z + z1 * alpha * V + (F_ Q m mu nu z - F Q m mu nu 0%Z).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_1_translating.

Module sec_3_1_not_tensor_literal.
(* gbt-surfaces/sec-3.1.not-tensor.literal, Sect. 3.1, paragraph after Figure 3
   printed: the cylinder in (9) leads to some complications in designing GBT-Bézier curves and surfaces as it is not a tensor product GBT-Bézier surface
   read as: The cylinder is no tensor product surface of the functions (1)-(2). Tried with the net Q_k, Q_k + αV, Q_k, Q_k + αV and the functions of order 3 in z_1 with both shape parameters -1.
   stated: fails(T(z, z1) == sum(k, 0, m, f[k,m](z, mu, nu)*(f[0,3](z1, -1, -1)*net3(k, 0) + f[1,3](z1, -1, -1)*net3(k, 1) + f[2,3](z1, -1, -1)*net3(k, 0) + f[3,3](z1, -1, -1)*net3(k, 1)))) *)
Definition net3 (Q : Z -> R) (V : R) (alpha : R) (k : Z) (a : Z) : R :=
  Q k + IZR a * alpha * V.
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  T Q V alpha m mu nu z z1 = sum 0%Z m (fun k => f z mu nu k m * (f z1 (- 1) (- 1) 0%Z 3%Z * net3 Q V alpha k 0%Z + f z1 (- 1) (- 1) 1%Z 3%Z * net3 Q V alpha k 1%Z + f z1 (- 1) (- 1) 2%Z 3%Z * net3 Q V alpha k 0%Z + f z1 (- 1) (- 1) 3%Z 3%Z * net3 Q V alpha k 1%Z))).
End sec_3_1_not_tensor_literal.

Module sec_3_1_not_tensor_as_it_stands.
(* gbt-surfaces/sec-3.1.not-tensor.as it stands, Sect. 3.1, paragraph after Figure 3
   printed: the cylinder in (9) leads to some complications in designing GBT-Bézier curves and surfaces as it is not a tensor product GBT-Bézier surface
   read as: With its own two rows of control points, Q_k and Q_k + αV, and the functions of (2), whose order is 2 or more, the cylinder is no tensor product surface: for every order and all shape parameters that surface shrinks to the origin for z_1 = 1, the cylinder does not.
   stated: rows(z, 1) == 0 and T(z, 1) == F(z) + alpha*V and fails(T(z, z1) == rows(z, z1)) *)
Definition rows (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : Z) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (f (IZR z1) mu1 nu1 0%Z n * net Q V alpha k 0%Z + f (IZR z1) mu1 nu1 1%Z n * net Q V alpha k 1%Z)).
Definition T (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  sum 0%Z m (fun k => (Q k + IZR z1 * alpha * V) * f z mu nu k m).
Definition rows_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (f z1 mu1 nu1 0%Z n * net Q V alpha k 0%Z + f z1 mu1 nu1 1%Z n * net Q V alpha k 1%Z)).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  rows Q V alpha m mu mu1 n nu nu1 z 1%Z = 0 /\ T Q V alpha m mu nu z 1%Z = F Q m mu nu z + alpha * V /\ ~ (forall (m : Z) (n : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= n)%Z) ->
  T_ Q V alpha m mu nu z z1 = rows_ Q V alpha m mu mu1 n nu nu1 z z1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_1_not_tensor_as_it_stands.

Module sec_3_1_order_one_missing_none.
(* gbt-surfaces/sec-3.1.order-one-missing.none, Sect. 3.1, paragraph before eq. (10)
   printed: No functions of order one lead to (1) by the step (2): the first and the last line would give f_{0,1} = f_{0,2}/(1 - z) and f_{1,1} = f_{2,2}/z, which do not give f_{1,2}.
   stated: fails(f[1,2](z) == (1 - z)*(f[2,2](z)/z) + z*(f[0,2](z)/(1 - z))) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  ~ (forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  z <> 0 ->
  1 - z <> 0 ->
  f z mu nu 1%Z 2%Z = (1 - z) * (f z mu nu 2%Z 2%Z / z) + z * (f z mu nu 0%Z 2%Z / (1 - z))).
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End sec_3_1_order_one_missing_none.

Module eq_10.
(* gbt-surfaces/eq-10, Sect. 3.1, eq. (10)
   printed: f_{k,1}(z) = (1 - z)^{1-k} z^k (k = 0, 1)
   read as: The printed formulas: each is the mirror image of the other, and they sum to one, as Theorem 1 asks.
   stated: (1 - z)^(1 - 0)*z^0 == b[1,1](1 - z) and (1 - z)^(1 - 1)*z^1 == b[0,1](1 - z) and (1 - z)^(1 - 0)*z^0 + (1 - z)^(1 - 1)*z^1 == 1 *)
Definition statement : Prop :=
forall (z : R),
  0 <= z <= 1 ->
  (1 - z) ^ 1 * z ^ 0 = b (1 - z) 1%Z 1%Z /\ (1 - z) ^ 0 * z ^ 1 = b (1 - z) 0%Z 1%Z /\ (1 - z) ^ 1 * z ^ 0 + (1 - z) ^ 0 * z ^ 1 = 1.
Definition instance : Prop :=
exists (z : R),
  0 <= z <= 1.
End eq_10.

Module eq_10_bernstein.
(* gbt-surfaces/eq-10.bernstein, Sect. 3.1, sentence after eq. (10)
   printed: Expression (10) shows that the GBTB basis functions of order one are the traditional Bernstein basis functions of order one.
   stated: sum(k, 0, 1, binom(1, k)*(1 - z)^(1 - k)*z^k*Q[k]) == sum(k, 0, 1, b[k,1](z)*Q[k]) and b[0,1](z) == 1 - z and b[1,1](z) == z *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (z : R),
  (2 <= m)%Z ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= (1 - k)%Z)%Z \/ 1 - z <> 0) ->
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= k)%Z \/ z <> 0) ->
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= k <= m)%Z) ->
  sum 0%Z 1%Z (fun k => binom 1 k * powerRZ (1 - z) (1 - k)%Z * powerRZ z k * Q k) = sum 0%Z 1%Z (fun k => b z k 1%Z * Q k) /\ b z 0%Z 1%Z = 1 - z /\ b z 1%Z 1%Z = z.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (z : R),
  (2 <= m)%Z /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= (1 - k)%Z)%Z \/ 1 - z <> 0) /\
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= k)%Z \/ z <> 0) /\
  (forall k : Z, (0 <= k <= 1)%Z -> (0 <= k <= m)%Z).
End eq_10_bernstein.

Module eq_10_extending.
(* gbt-surfaces/eq-10.extending, Sect. 3.1, sentence before eq. (10)
   printed: Thus, extending the definition of GBTB basis functions, we describe the first-degree GBTB basis functions as (10)
   read as: The properties of Theorem 1 hold for order one as well.
   stated: b[0,1](z) + b[1,1](z) == 1 and b[0,1](z) >= 0 and b[1,1](z) >= 0 and b[1,1](z) == b[0,1](1 - z) and b[0,1](0) == 1 and b[1,1](1) == 1 *)
Definition statement : Prop :=
forall (z : R),
  0 <= z <= 1 ->
  b z 0%Z 1%Z + b z 1%Z 1%Z = 1 /\ b z 0%Z 1%Z >= 0 /\ b z 1%Z 1%Z >= 0 /\ b z 1%Z 1%Z = b (1 - z) 0%Z 1%Z /\ b 0 0%Z 1%Z = 1 /\ b 1 1%Z 1%Z = 1.
Definition instance : Prop :=
exists (z : R),
  0 <= z <= 1.
End eq_10_extending.

Module eq_11.
(* gbt-surfaces/eq-11, Sect. 3.1, Theorem 3, eq. (11)
   printed: T_cylinder(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{1} Q_{k,l} f_{k,m}(z) f_{l,n}(z_1), z, z_1 ∈ [0,1]
   stated: T(z, z1) == printed(z, z1) *)
Definition printed_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * (f z1 mu1 nu1 0%Z n * net Q V alpha k 0%Z + f z1 mu1 nu1 1%Z n * net Q V alpha k 1%Z)).
Definition statement : Prop :=
forall (m : Z) (n : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z z1 = printed_ Q V alpha m mu mu1 n nu nu1 z z1.
End eq_11.

Module eq_11_corrected.
(* gbt-surfaces/eq-11 (corrected), Sect. 3.1, Theorem 3, eq. (11)
   printed: T_cylinder(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{1} Q_{k,l} f_{k,m}(z) f_{l,n}(z_1), z, z_1 ∈ [0,1]
   stated: T(z, z1) == sum(k, 0, m, f[k,m](z, mu, nu)*(b[0,1](z1)*net(k, 0) + b[1,1](z1)*net(k, 1))) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  T Q V alpha m mu nu z z1 = sum 0%Z m (fun k => f z mu nu k m * (b z1 0%Z 1%Z * net Q V alpha k 0%Z + b z1 1%Z 1%Z * net Q V alpha k 1%Z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_11_corrected.

Module eq_11_points.
(* gbt-surfaces/eq-11.points, Sect. 3.1, Theorem 3, line after eq. (11)
   printed: Q_{k,0} = Q_k, Q_{k,1} = Q_k + dV, k = 0, 1, ..., m
   read as: The letter d is nowhere explained; it is taken as a number of its own.
   stated: sum(k, 0, m, (Q[k] + z1*alpha*V)*f[k,m](z, mu, nu)) == sum(k, 0, m, f[k,m](z, mu, nu)*(b[0,1](z1)*Q[k] + b[1,1](z1)*(Q[k] + d*V))) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (d : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m) = sum 0%Z m (fun k => f z mu nu k m * (b z1 0%Z 1%Z * Q k + b z1 1%Z 1%Z * (Q k + d * V))).
End eq_11_points.

Module eq_11_points_corrected.
(* gbt-surfaces/eq-11.points (corrected), Sect. 3.1, Theorem 3, line after eq. (11)
   printed: Q_{k,0} = Q_k, Q_{k,1} = Q_k + dV, k = 0, 1, ..., m
   read as: The letter d is nowhere explained; it is taken as a number of its own.
   stated: sum(k, 0, m, (Q[k] + z1*alpha*V)*f[k,m](z, mu, nu)) == sum(k, 0, m, f[k,m](z, mu, nu)*(b[0,1](z1)*Q[k] + b[1,1](z1)*(Q[k] + alpha*V))) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m) = sum 0%Z m (fun k => f z mu nu k m * (b z1 0%Z 1%Z * Q k + b z1 1%Z 1%Z * (Q k + alpha * V))).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_11_points_corrected.

Module eq_11_parameters.
(* gbt-surfaces/eq-11.parameters, Sect. 3.1, Theorem 3, left side of eq. (11) and last line of the statement
   printed: T_cylinder(z,z_1,μ,ν,μ_1,ν_1) ..., and μ, ν are shape control parameters
   read as: The surface changes with mu and with nu.
   stated: fails(D(at(D(tensor(z, z1), z), z, 0), mu) == 0) and fails(D(at(D(tensor(z, z1), z), z, 1), nu) == 0) *)
Definition tensor (Q : Z -> R) (V : R) (alpha : R) (m : Z) (nu : R) (mu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => tensor Q V alpha m nu mu_ z_ z1) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => tensor_ Q V alpha m mu nu_ z_ z1) 1 (IZR z)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z1 <= 1.
End eq_11_parameters.

Module eq_12_1.
(* gbt-surfaces/eq-12.1, Sect. 3.1, proof of Theorem 3, eq. (12), first line
   printed: T_cylinder(z,z_1,μ,ν) = sum_{k=0}^{m} (Q_k + z_1 dV) f_{k,m}(z)
   read as: The letter d is nowhere explained; it is taken as a number of its own.
   stated: F(z) + z1*alpha*V == sum(k, 0, m, (Q[k] + z1*d*V)*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (d : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  F Q m mu nu z + z1 * alpha * V = sum 0%Z m (fun k => (Q k + z1 * d * V) * f z mu nu k m).
End eq_12_1.

Module eq_12_1_corrected.
(* gbt-surfaces/eq-12.1 (corrected), Sect. 3.1, proof of Theorem 3, eq. (12), first line
   printed: T_cylinder(z,z_1,μ,ν) = sum_{k=0}^{m} (Q_k + z_1 dV) f_{k,m}(z)
   read as: The letter d is nowhere explained; it is taken as a number of its own.
   stated: F(z) + z1*alpha*V == sum(k, 0, m, (Q[k] + z1*alpha*V)*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  F Q m mu nu z + z1 * alpha * V = sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_12_1_corrected.

Module eq_12_2.
(* gbt-surfaces/eq-12.2, Sect. 3.1, proof of Theorem 3, eq. (12), second line
   printed: = sum_{k=0}^{m} [Q_{k,0} + z_1 (Q_{k,1} - Q_{k,0})] f_{k,m}(z)
   stated: sum(k, 0, m, (Q[k] + z1*alpha*V)*f[k,m](z, mu, nu)) == sum(k, 0, m, (net(k, 0) + z1*(net(k, 1) - net(k, 0)))*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m) = sum 0%Z m (fun k => (net Q V alpha k 0%Z + z1 * (net Q V alpha k 1%Z - net Q V alpha k 0%Z)) * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_12_2.

Module eq_12_3.
(* gbt-surfaces/eq-12.3, Sect. 3.1, proof of Theorem 3, eq. (12), third line
   printed: = sum_{k=0}^{m} [(1 - z_1) Q_{k,0} + z_1 Q_{k,1}] f_{k,m}(z)
   stated: sum(k, 0, m, (net(k, 0) + z1*(net(k, 1) - net(k, 0)))*f[k,m](z, mu, nu)) == sum(k, 0, m, ((1 - z1)*net(k, 0) + z1*net(k, 1))*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => (net Q V alpha k 0%Z + z1 * (net Q V alpha k 1%Z - net Q V alpha k 0%Z)) * f z mu nu k m) = sum 0%Z m (fun k => ((1 - z1) * net Q V alpha k 0%Z + z1 * net Q V alpha k 1%Z) * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_12_3.

Module eq_12_4.
(* gbt-surfaces/eq-12.4, Sect. 3.1, proof of Theorem 3, eq. (12), fourth line
   printed: = sum_{k=0}^{m} sum_{l=0}^{1} Q_{k,l} f_{k,m}(z) f_{l,1}(z_1)
   stated: sum(k, 0, m, ((1 - z1)*net(k, 0) + z1*net(k, 1))*f[k,m](z, mu, nu)) == tensor(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  sum 0%Z m (fun k => ((1 - z1) * net Q V alpha k 0%Z + z1 * net Q V alpha k 1%Z) * f z mu nu k m) = tensor Q V alpha m mu nu z z1.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z).
End eq_12_4.

Module thm_3.
(* gbt-surfaces/thm-3, Sect. 3.1, Theorem 3 and last sentence of its proof
   printed: GBT-Bézier cylinder in (9) can be exactly expressed in terms of a tensor product GBT-Bézier surface of degree (m, 1)
   stated: T(z, z1) == tensor(z, z1) *)
Definition tensor (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  T Q V alpha m mu nu z z1 = tensor Q V alpha m mu nu z z1.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z).
End thm_3.

Module sec_3_1_benefits.
(* gbt-surfaces/sec-3.1.benefits, Sect. 3.1, paragraph before Algorithm 1
   printed: Since a GBT-Bézier curve is the directrix of a GBT-Bézier cylinder, it carries some remarkable benefits of the general Bézier cylinder.
   read as: Straight generators, convex hull and affine invariance (nonnegative weights that sum to one), interpolation of the corners.
   stated: D(tensor(z, z1), z1, 2) == 0 and nonnegative(f) and nonnegative(b) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, 1, b[l,1](z1))) == 1 and tensor(0, 0) == Q[0] and tensor(1, 0) == Q[m] and tensor(0, 1) == Q[0] + alpha*V and tensor(1, 1) == Q[m] + alpha*V *)
Definition tensor_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : Z) (z1 : Z) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f (IZR z) mu nu k m * b (IZR z1) l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (0 <= 0 <= m)%Z ->
  (0 <= m <= m)%Z ->
  Derive_n (fun z1_ => tensor Q V alpha m mu nu z z1_) 2 z1 = 0 /\ (forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ (forall i_ k_ : Z, (1 <= k_)%Z -> 0 <= b z i_ k_) /\ sum 0%Z m (fun k__ => f z mu nu k__ m * sum 0%Z 1%Z (fun l => b z1 l 1%Z)) = 1 /\ tensor_ Q V alpha m mu nu 0%Z 0%Z = Q 0%Z /\ tensor_ Q V alpha m mu nu 1%Z 0%Z = Q m /\ tensor_ Q V alpha m mu nu 0%Z 1%Z = Q 0%Z + alpha * V /\ tensor_ Q V alpha m mu nu 1%Z 1%Z = Q m + alpha * V.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) /\
  (0 <= 0 <= m)%Z /\
  (0 <= m <= m)%Z.
End sec_3_1_benefits.

Module sec_3_1_any_shape_literal.
(* gbt-surfaces/sec-3.1.any-shape.literal, Sect. 3.1, paragraph before Algorithm 1
   printed: by keeping the control mesh unchanged, the GBT-Bézier cylinder can be transformed into any shape merely by changing the shape parameters
   read as: Any shape: also one whose corner is any point W.
   stated: tensor(0, 0) == W *)
Definition tensor (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : Z) (z1 : Z) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f (IZR z) mu nu k m * b (IZR z1) l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (W : R) (alpha : R) (mu : R) (nu : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  tensor Q V alpha m mu nu 0%Z 0%Z = W.
End sec_3_1_any_shape_literal.

Module sec_3_1_any_shape_the_shape_changes.
(* gbt-surfaces/sec-3.1.any-shape.the shape changes, Sect. 3.1, paragraph before Algorithm 1
   printed: by keeping the control mesh unchanged, the GBT-Bézier cylinder can be transformed into any shape merely by changing the shape parameters
   read as: The shape changes with the shape parameters while the net does not.
   stated: fails(D(at(D(tensor(z, z1), z), z, 0), mu) == 0) and fails(D(at(D(tensor(z, z1), z), z, 1), nu) == 0) *)
Definition tensor (Q : Z -> R) (V : R) (alpha : R) (m : Z) (nu : R) (mu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu_ => let z := 0%Z in Derive_n (fun z_ => tensor Q V alpha m nu mu_ z_ z1) 1 (IZR z)) 1 mu = 0) /\ ~ (forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu_ => let z := 1%Z in Derive_n (fun z_ => tensor_ Q V alpha m mu nu_ z_ z1) 1 (IZR z)) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z1 <= 1.
End sec_3_1_any_shape_the_shape_changes.

Module alg_1.
(* gbt-surfaces/alg-1, Sect. 3.1, Algorithm 1
   printed: 1. Choose an arbitrary 3D unit vector V and a GBT-Bézier curve as the directrix. 2. Describe a GBT-Bézier cylinder as in (11). 3. Take control points Q_{k,0} = Q_k, Q_{k,1} = Q_k + αV (k = 0, 1, 2, ..., m), where α is the distance along a normal vector of the plane. 4. Select the distance α and draw with different shape parameters. 5. Can also be drawn with varying values of α, shape parameters unchanged.
   read as: U are the three coordinates of V. Steps 1 to 3 give the cylinder (9), whose ends are the distance alpha apart; step 5 moves each point along V.
   stated: tensor(z, z1) == T(z, z1) and tensor(z, 1) - tensor(z, 0) == alpha*V and dot(alpha*U, alpha*U) == alpha^2 and D(tensor(z, z1), alpha) == z1*V *)
Definition tensor_ (Q : Z -> R) (V : R) (alpha : R) (m : Z) (mu : R) (nu : R) (z : R) (z1 : Z) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b (IZR z1) l 1%Z)).
Definition tensor__ (Q : Z -> R) (V : R) (m : Z) (mu : R) (nu : R) (alpha : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => sum 0%Z 1%Z (fun l => net Q V alpha k l * f z mu nu k m * b z1 l 1%Z)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (U'1 U'2 U'3 : R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  let U := [U'1; U'2; U'3] in
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  dot U U = 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  tensor Q V alpha m mu nu z z1 = T Q V alpha m mu nu z z1 /\ tensor_ Q V alpha m mu nu z 1%Z - tensor_ Q V alpha m mu nu z 0%Z = alpha * V /\ dot (vscale alpha U) (vscale alpha U) = alpha ^ 2 /\ Derive_n (fun alpha_ => tensor__ Q V m mu nu alpha_ z z1) 1 alpha = z1 * V.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (U'1 U'2 U'3 : R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  let U := [U'1; U'2; U'3] in
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  dot U U = 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z).
End alg_1.

Module ex_3_1_points.
(* gbt-surfaces/ex-3.1.points, Sect. 3.1, Example 3.1, data
   printed: Q_0 = (5, 2, 0), Q_1 = (0, 12, 0), Q_2 = (10, 20, 0), Q_3 = (20, 12, 0), Q_4 = (15, 2, 0); α = 20, V = (0, 0, 1)
   read as: V is a unit vector and alpha is positive, as Section 3.1 asks of them; the points are used in gbt-surfaces/ex-3.1.normal and gbt-surfaces/eq-13.
   stated: dot(V31, V31) == 1 and alpha31 > 0 *)
Definition statement : Prop :=
  dot V31 V31 = 1 /\ alpha31 > 0.
End ex_3_1_points.

Module ex_3_1_normal.
(* gbt-surfaces/ex-3.1.normal, Sect. 3.1, Example 3.1
   printed: interpreting F_4(z;μ,ν) a distance α with the normal vector of the plane (here α = 20, V = (0, 0, 1))
   stated: dot(V31, Q31[2] - Q31[1]) == 0 and dot(V31, Q31[3] - Q31[1]) == 0 and dot(V31, Q31[4] - Q31[1]) == 0 and dot(V31, Q31[5] - Q31[1]) == 0 and norm(V31) == 1 *)
Definition statement : Prop :=
  dot V31 (vsub (row Q31 2) (row Q31 1)) = 0 /\ dot V31 (vsub (row Q31 3) (row Q31 1)) = 0 /\ dot V31 (vsub (row Q31 4) (row Q31 1)) = 0 /\ dot V31 (vsub (row Q31 5) (row Q31 1)) = 0 /\ norm V31 = 1.
End ex_3_1_normal.

Module eq_13.
(* gbt-surfaces/eq-13, Sect. 3.1, Example 3.1, eq. (13)
   printed: T_cylinder(z,z_1,μ,ν) = sum_{k=0}^{4} sum_{l=0}^{1} Q_{k,l} f_{k,4}(z) f_{l,1}(z_1), z, z_1 ∈ [0,1]
   stated: sum(k, 0, 4, f[k,4](z, mu, nu)*Q31[k+1]) + z1*alpha31*V31 == sum(k, 0, 4, sum(l, 0, 1, (Q31[k+1] + l*[0, 0, 20])*f[k,4](z, mu, nu)*b[l,1](z1))) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z) ->
  (forall k : Z, (0 <= k <= 4)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (1 <= (k + 1) <= 5)%Z) ->
  vadd (vsum 3 0%Z 4%Z (fun k => vscale (f z mu nu k 4%Z) (row Q31 (Z.to_nat (k + 1)%Z)))) (vscale (z1 * alpha31) V31) = vsum 3 0%Z 4%Z (fun k => vsum 3 0%Z 1%Z (fun l => vscale (b z1 l 1%Z) (vscale (f z mu nu k 4%Z) (vadd (row Q31 (Z.to_nat (k + 1)%Z)) (vscale (IZR l) [0; 0; 20]))))).
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z) /\
  (forall k : Z, (0 <= k <= 4)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (1 <= (k + 1) <= 5)%Z).
End eq_13.

Module ex_3_1_net.
(* gbt-surfaces/ex-3.1.net, Sect. 3.1, Example 3.1, line after eq. (13)
   printed: Q_{k,0} = Q_k, Q_{k,1} = Q_k + (0, 0, 20) (k = 0, 1, ..., 4)
   stated: alpha31*V31 == [0, 0, 20] *)
Definition statement : Prop :=
  vscale alpha31 V31 = [0; 0; 20].
End ex_3_1_net.

Module ex_3_1_mesh_count.
(* gbt-surfaces/ex-3.1.mesh-count, Sect. 3.1, Example 3.1
   printed: the GBT-Bézier cylinders with 10 mesh points for fixed values of α = 20
   read as: The points of the net that (13) sums over.
   stated: sum(k, 0, 4, sum(l, 0, 1, 1)) == 10 *)
Definition statement : Prop :=
  sum 0%Z 4%Z (fun k => sum 0%Z 1%Z (fun l => 1)) = 10.
End ex_3_1_mesh_count.

Module ex_3_1_hull.
(* gbt-surfaces/ex-3.1.hull, Sect. 3.1, Example 3.1
   printed: GBT-Bézier cylinders with 10 mesh points for fixed values of α = 20 and different shape parameters μ, ν which clearly make its confined convex hull
   read as: The cylinders stay in the convex hull of the ten points, for all shape parameters.
   stated: nonnegative(f) and nonnegative(b) and sum(k, 0, 4, f[k,4](z, mu, nu)*sum(l, 0, 1, b[l,1](z1))) == 1 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ (forall i_ k_ : Z, (1 <= k_)%Z -> 0 <= b z i_ k_) /\ sum 0%Z 4%Z (fun k__ => f z mu nu k__ 4%Z * sum 0%Z 1%Z (fun l => b z1 l 1%Z)) = 1.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End ex_3_1_hull.

Module sec_3_1_effect.
(* gbt-surfaces/sec-3.1.effect, Sect. 3.1, last sentence
   printed: Figures 4, 5, and 6 present that the effect of shape parameters on GBT-Bézier cylinders (open or close) is the same as the effect on GBT-Bézier curves and surfaces.
   stated: D(T(z, z1), mu) == D(F(z), mu) and D(T(z, z1), nu) == D(F(z), nu) *)
Definition T (Q : Z -> R) (V : R) (alpha : R) (m : Z) (nu : R) (mu : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => (Q k + z1 * alpha * V) * f z mu nu k m).
Definition F (Q : Z -> R) (m : Z) (nu : R) (mu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  Derive_n (fun mu_ => T Q V alpha m nu mu_ z z1) 1 mu = Derive_n (fun mu_ => F Q m nu mu_ z) 1 mu /\ Derive_n (fun nu_ => T_ Q V alpha m mu nu_ z z1) 1 nu = Derive_n (fun nu_ => F_ Q m mu nu_ z) 1 nu.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_1_effect.

Module prop_3_1_translation.
(* gbt-surfaces/prop-3.1.translation, Sect. 3.1, Proposition 3.1, first sentence
   printed: The translational invariance property is used to define GBT-Bézier curves in (8).
   read as: The curve of the points moved by a vector is the curve moved by it, here by z_1 αV.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*(Q[k] + z1*alpha*V)) == F(z) + z1*alpha*V *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => f z mu nu k m * (Q k + z1 * alpha * V)) = F Q m mu nu z + z1 * alpha * V.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (V : R) (alpha : R) (mu : R) (nu : R) (z : R) (z1 : R),
  0 < alpha /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End prop_3_1_translation.
