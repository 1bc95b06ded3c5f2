(* Statements of gbt-surfaces, Section 3 2. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition N0 (z : R) : R :=
  (1 - z) / (1 - 0).
Definition N1 (z : R) : R :=
  (z - 0) / (1 - 0).
Definition bilinear (G : Z -> Z -> R) (z : R) (z1 : R) : R :=
  N0 z * N0 z1 * G 0%Z 0%Z + N1 z * N0 z1 * G 1%Z 0%Z + N0 z * N1 z1 * G 0%Z 1%Z + N1 z * N1 z1 * G 1%Z 1%Z.
Definition b (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - z) ^ 1 * z ^ 0; (1 - z) ^ 0 * z ^ 1] i k.
Definition product (G : Z -> Z -> R) (z : R) (z1 : R) : R :=
  sum 0%Z 1%Z (fun k => sum 0%Z 1%Z (fun l => G k l * b z k 1%Z * b z1 l 1%Z)).
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition T (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * sum 0%Z m (fun k => f z mu nu k m * G k l)).
Definition R_ (G : Z -> Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (z : R) (z1 : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n * G k l)).
Definition Q00 : list R :=
  [0; 0; 0].
Definition Q10 : list R :=
  [1; 0; 0].
Definition Q20 : list R :=
  [2; 0; 0].
Definition Q30 : list R :=
  [3; 0; 0].
Definition Q01 : list R :=
  [0; 1; 0].
Definition Q11 : list R :=
  [1; 1; 3].
Definition Q21 : list R :=
  [2; 1; 3].
Definition Q31 : list R :=
  [3; 2; 0].
Definition Q02 : list R :=
  [0; 2; 0].
Definition Q12 : list R :=
  [1; 2; 3].
Definition Q22 : list R :=
  [2; 2; 3].
Definition Q32 : list R :=
  [3; 2; 0].
Definition Q03 : list R :=
  [0; 3; 0].
Definition Q13 : list R :=
  [1; 3; 0].
Definition Q23 : list R :=
  [2; 3; 0].
Definition Q33 : list R :=
  [3; 3; 0].
Definition row_ (mu : R) (nu : R) (z : R) (p : list R) (q : list R) (r : list R) (s : list R) : list R :=
  vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) p) (vscale (f z mu nu 1%Z 3%Z) q)) (vscale (f z mu nu 2%Z 3%Z) r)) (vscale (f z mu nu 3%Z 3%Z) s).
Definition sixteen (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R) : list R :=
  vadd (vadd (vadd (vscale (f z1 mu1 nu1 0%Z 3%Z) (row_ mu nu z Q00 Q10 Q20 Q30)) (vscale (f z1 mu1 nu1 1%Z 3%Z) (row_ mu nu z Q01 Q11 Q21 Q31))) (vscale (f z1 mu1 nu1 2%Z 3%Z) (row_ mu nu z Q02 Q12 Q22 Q32))) (vscale (f z1 mu1 nu1 3%Z 3%Z) (row_ mu nu z Q03 Q13 Q23 Q33)).
End Definitions.
Import Definitions.

Module eq_14.
(* gbt-surfaces/eq-14, Sect. 3.2, eq. (14)
   printed: T_bi-linear(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{1} sum_{l=0}^{1} Q_{k,l} N_{k,1}(z) N_{l,1}(z_1), z, z_1 ∈ [0,1], Z = Z_1 = {0, 0, 1, 1} the node vector
   read as: The B-spline functions of degree one over the nodes 0, 0, 1, 1 interpolate linearly, in one direction and then in the other.
   stated: bilinear(z, z1) == (1 - z)*((1 - z1)*G[0,0] + z1*G[0,1]) + z*((1 - z1)*G[1,0] + z1*G[1,1]) and (N0(z) + N1(z))*(N0(z1) + N1(z1)) == 1 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  bilinear G z z1 = (1 - z) * ((1 - z1) * G 0%Z 0%Z + z1 * G 0%Z 1%Z) + z * ((1 - z1) * G 1%Z 0%Z + z1 * G 1%Z 1%Z) /\ (N0 z + N1 z) * (N0 z1 + N1 z1) = 1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End eq_14.

Module sec_3_2_segments.
(* gbt-surfaces/sec-3.2.segments, Sect. 3.2, first sentence
   printed: bi-linearly interpolating among four line segments, Q_{0,0}Q_{1,0}, Q_{0,1}Q_{1,1}, Q_{0,0}Q_{0,1}, and Q_{1,0}Q_{1,1}
   stated: bilinear(z, 0) == (1 - z)*G[0,0] + z*G[1,0] and bilinear(z, 1) == (1 - z)*G[0,1] + z*G[1,1] and bilinear(0, z1) == (1 - z1)*G[0,0] + z1*G[0,1] and bilinear(1, z1) == (1 - z1)*G[1,0] + z1*G[1,1] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  bilinear G z 0 = (1 - z) * G 0%Z 0%Z + z * G 1%Z 0%Z /\ bilinear G z 1 = (1 - z) * G 0%Z 1%Z + z * G 1%Z 1%Z /\ bilinear G 0 z1 = (1 - z1) * G 0%Z 0%Z + z1 * G 0%Z 1%Z /\ bilinear G 1 z1 = (1 - z1) * G 1%Z 0%Z + z1 * G 1%Z 1%Z.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End sec_3_2_segments.

Module sec_3_2_linear.
(* gbt-surfaces/sec-3.2.linear, Sect. 3.2, sentence after eq. (14)
   printed: Among opposite boundary lines, the bi-linear surface (14) performs a clear linear interpolation in both direction
   stated: bilinear(z, z1) == (1 - z1)*bilinear(z, 0) + z1*bilinear(z, 1) and bilinear(z, z1) == (1 - z)*bilinear(0, z1) + z*bilinear(1, z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  bilinear G z z1 = (1 - z1) * bilinear G z 0 + z1 * bilinear G z 1 /\ bilinear G z z1 = (1 - z) * bilinear G 0 z1 + z * bilinear G 1 z1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End sec_3_2_linear.

Module prop_3_2_a.
(* gbt-surfaces/prop-3.2.a, Sect. 3.2, Proposition 3.2 (a)
   printed: given angular points are interpolated by the surface
   stated: bilinear(0, 0) == G[0,0] and bilinear(1, 0) == G[1,0] and bilinear(0, 1) == G[0,1] and bilinear(1, 1) == G[1,1] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  bilinear G 0 0 = G 0%Z 0%Z /\ bilinear G 1 0 = G 1%Z 0%Z /\ bilinear G 0 1 = G 0%Z 1%Z /\ bilinear G 1 1 = G 1%Z 1%Z.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End prop_3_2_a.

Module prop_3_2_b.
(* gbt-surfaces/prop-3.2.b, Sect. 3.2, Proposition 3.2 (b)
   printed: line segments are taken as boundary curves
   stated: D(bilinear(z, 0), z, 2) == 0 and D(bilinear(z, 1), z, 2) == 0 and D(bilinear(0, z1), z1, 2) == 0 and D(bilinear(1, z1), z1, 2) == 0 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  Derive_n (fun z => bilinear G z 0) 2 z = 0 /\ Derive_n (fun z => bilinear G z 1) 2 z = 0 /\ Derive_n (fun z1 => bilinear G 0 z1) 2 z1 = 0 /\ Derive_n (fun z1 => bilinear G 1 z1) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End prop_3_2_b.

Module prop_3_2_c.
(* gbt-surfaces/prop-3.2.c, Sect. 3.2, Proposition 3.2 (c)
   printed: the curves T(z,z_1) or T(z,z_1) are the line segments for fixed z or z_1
   read as: The second of the two equal symbols is read as the curve for fixed z_1.
   stated: D(bilinear(z, z1), z, 2) == 0 and D(bilinear(z, z1), z1, 2) == 0 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  Derive_n (fun z => bilinear G z z1) 2 z = 0 /\ Derive_n (fun z1 => bilinear G z z1) 2 z1 = 0.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End prop_3_2_c.

Module eq_15.
(* gbt-surfaces/eq-15, Sect. 3.2, Proposition 3.2, eq. (15)
   printed: T_bi-linear(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{1} sum_{l=0}^{1} Q_{k,l} f_{k,1}(z) f_{l,1}(z_1), z, z_1 ∈ [0,1]
   stated: bilinear(z, z1) == product(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= l <= n)%Z) ->
  bilinear G z z1 = product G z z1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z /\
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= l <= n)%Z).
End eq_15.

Module sec_3_2_fixed.
(* gbt-surfaces/sec-3.2.fixed, Sect. 3.2, sentence after eq. (15)
   printed: the bi-linear surfaces described in (14) and (15) cannot be modified. This inconvenience of shape adjustment is due to the given four angular points.
   read as: The surface is determined by its four angular points: there is nothing else to change.
   stated: product(z, z1) == (1 - z)*(1 - z1)*p00 + z*(1 - z1)*p10 + (1 - z)*z1*p01 + z*z1*p11 and bilinear(z, z1) == product(z, z1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (G : Z -> Z -> R) (p00 : R) (p01 : R) (p10 : R) (p11 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= l <= n)%Z) ->
  product G 0 0 = p00 ->
  product G 1 0 = p10 ->
  product G 0 1 = p01 ->
  product G 1 1 = p11 ->
  (0 <= 0 <= m)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= 1 <= m)%Z ->
  (0 <= 1 <= n)%Z ->
  product G z z1 = (1 - z) * (1 - z1) * p00 + z * (1 - z1) * p10 + (1 - z) * z1 * p01 + z * z1 * p11 /\ bilinear G z z1 = product G z z1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (G : Z -> Z -> R) (p00 : R) (p01 : R) (p10 : R) (p11 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= 1)%Z -> forall l : Z, (0 <= l <= 1)%Z -> (0 <= l <= n)%Z) /\
  product G 0 0 = p00 /\
  product G 1 0 = p10 /\
  product G 0 1 = p01 /\
  product G 1 1 = p11 /\
  (0 <= 0 <= m)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= 1 <= m)%Z /\
  (0 <= 1 <= n)%Z.
End sec_3_2_fixed.

Module sec_3_2_list_1.
(* gbt-surfaces/sec-3.2.list-1, Sect. 3.2, properties of GBT-Bezier bi-linear surfaces, item 1
   printed: Angular points are interpolated by the surface
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
End sec_3_2_list_1.

Module sec_3_2_list_2.
(* gbt-surfaces/sec-3.2.list-2, Sect. 3.2, properties of GBT-Bezier bi-linear surfaces, item 2
   printed: Line segments are taken as the boundary curves of the surface
   read as: Each boundary is the curve of its exterior points. For points A + t_k (B - A) on a line that curve is A + s (B - A), where s is a combination of the t_k with nonnegative weights that sum to one: for a division of the segment, 0 <= t_k <= 1, it stays on the segment.
   stated: R(z, 0) == sum(k, 0, m, f[k,m](z, mu, nu)*G[k,0]) and R(z, 1) == sum(k, 0, m, f[k,m](z, mu, nu)*G[k,n]) and T(0, z1) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*G[0,l]) and T(1, z1) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*G[m,l]) and sum(k, 0, m, f[k,m](z, mu, nu)*(A + t[k]*(B - A))) == A + sum(k, 0, m, f[k,m](z, mu, nu)*t[k])*(B - A) and nonnegative(f) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (A : R) (B : R) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (t : Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= n <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 0 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= m <= m)%Z) ->
  R_ G m mu mu1 n nu nu1 z 0 = sum 0%Z m (fun k => f z mu nu k m * G k 0%Z) /\ R_ G m mu mu1 n nu nu1 z 1 = sum 0%Z m (fun k => f z mu nu k m * G k n) /\ T G m mu mu1 n nu nu1 0 z1 = sum 0%Z n (fun l => f z1 mu1 nu1 l n * G 0%Z l) /\ T G m mu mu1 n nu nu1 1 z1 = sum 0%Z n (fun l => f z1 mu1 nu1 l n * G m l) /\ sum 0%Z m (fun k => f z mu nu k m * (A + t k * (B - A))) = A + sum 0%Z m (fun k => f z mu nu k m * t k) * (B - A) /\ (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k).
Definition instance : Prop :=
exists (m : Z) (n : Z) (A : R) (B : R) (G : Z -> Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (t : Z -> R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= n <= n)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 0 <= m)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= m <= m)%Z).
End sec_3_2_list_2.

Module sec_3_2_list_3.
(* gbt-surfaces/sec-3.2.list-3, Sect. 3.2, properties of GBT-Bezier bi-linear surfaces, item 3
   printed: T_{m,n}(z,z_1) or T_{m,n}(z,z_1) is a GBT-Bézier curve for fixed z or z_1
   read as: The second of the two equal symbols is read as the curve for fixed z_1.
   stated: T(z, z1) == R(z, z1) *)
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
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z) ->
  T G m mu mu1 n nu nu1 z z1 = R_ G m mu mu1 n nu nu1 z z1.
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
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= n)%Z -> (0 <= k <= m)%Z).
End sec_3_2_list_3.

Module alg_2_1.
(* gbt-surfaces/alg-2.1, Sect. 3.2, Algorithm 2, step 1
   printed: In a 3D space, take Q_{0,0}, Q_{m,0}, Q_{0,n}, Q_{m,n} to be the four control points. These points are used as the angular points of the GBT-Bézier surface.
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
End alg_2_1.

Module alg_2_2.
(* gbt-surfaces/alg-2.2, Sect. 3.2, Algorithm 2, step 2
   printed: Split the line segments Q_{0,0}Q_{m,0}, Q_{0,n}Q_{m,n} and Q_{0,0}Q_{0,n}, Q_{m,0}Q_{m,n} into m and n same parts (an irregular division can also be made) accordingly and indicate the central partition points as Q_{1,0}, Q_{2,0}, ..., Q_{m-1,0}, Q_{1,n}, Q_{2,n}, ..., Q_{m-1,n} and Q_{0,1}, Q_{0,2}, ..., Q_{0,n-1}, Q_{m,1}, Q_{m,2}, ..., Q_{m,n-1}; these and the corners are the exterior control mesh points
   read as: The points of all four sides are equally spaced, and the boundary curves of (16) with them stay on the sides.
   stated: point(0, K00, Km0, m) == K00 and point(m, K00, Km0, m) == Km0 and point(k, K00, Km0, m) - point(k - 1, K00, Km0, m) == (Km0 - K00)/m and point(0, K0n, Kmn, m) == K0n and point(m, K0n, Kmn, m) == Kmn and point(k, K0n, Kmn, m) - point(k - 1, K0n, Kmn, m) == (Kmn - K0n)/m and point(0, K00, K0n, n) == K00 and point(n, K00, K0n, n) == K0n and point(l, K00, K0n, n) - point(l - 1, K00, K0n, n) == (K0n - K00)/n and point(0, Km0, Kmn, n) == Km0 and point(n, Km0, Kmn, n) == Kmn and point(l, Km0, Kmn, n) - point(l - 1, Km0, Kmn, n) == (Kmn - Km0)/n and sum(k, 0, m, f[k,m](z, mu, nu)*point(k, K00, Km0, m)) == K00 + sum(k, 0, m, f[k,m](z, mu, nu)*k/m)*(Km0 - K00) and sum(k, 0, m, f[k,m](z, mu, nu)*point(k, K0n, Kmn, m)) == K0n + sum(k, 0, m, f[k,m](z, mu, nu)*k/m)*(Kmn - K0n) and sum(l, 0, n, f[l,n](z1, mu1, nu1)*point(l, K00, K0n, n)) == K00 + sum(l, 0, n, f[l,n](z1, mu1, nu1)*l/n)*(K0n - K00) and sum(l, 0, n, f[l,n](z1, mu1, nu1)*point(l, Km0, Kmn, n)) == Km0 + sum(l, 0, n, f[l,n](z1, mu1, nu1)*l/n)*(Kmn - Km0) *)
Definition point (k : R) (A : R) (B : R) (parts : R) : R :=
  A + k / parts * (B - A).
Definition statement : Prop :=
forall (k : Z) (l : Z) (m : Z) (n : Z) (K00 : R) (K0n : R) (Km0 : R) (Kmn : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (1 <= k <= m)%Z ->
  (1 <= l <= n)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  IZR m <> 0 ->
  IZR n <> 0 ->
  point 0 K00 Km0 (IZR m) = K00 /\ point (IZR m) K00 Km0 (IZR m) = Km0 /\ point (IZR k) K00 Km0 (IZR m) - point (IZR (k - 1)%Z) K00 Km0 (IZR m) = (Km0 - K00) / IZR m /\ point 0 K0n Kmn (IZR m) = K0n /\ point (IZR m) K0n Kmn (IZR m) = Kmn /\ point (IZR k) K0n Kmn (IZR m) - point (IZR (k - 1)%Z) K0n Kmn (IZR m) = (Kmn - K0n) / IZR m /\ point 0 K00 K0n (IZR n) = K00 /\ point (IZR n) K00 K0n (IZR n) = K0n /\ point (IZR l) K00 K0n (IZR n) - point (IZR (l - 1)%Z) K00 K0n (IZR n) = (K0n - K00) / IZR n /\ point 0 Km0 Kmn (IZR n) = Km0 /\ point (IZR n) Km0 Kmn (IZR n) = Kmn /\ point (IZR l) Km0 Kmn (IZR n) - point (IZR (l - 1)%Z) Km0 Kmn (IZR n) = (Kmn - Km0) / IZR n /\ sum 0%Z m (fun k => f z mu nu k m * point (IZR k) K00 Km0 (IZR m)) = K00 + sum 0%Z m (fun k => f z mu nu k m * IZR k / IZR m) * (Km0 - K00) /\ sum 0%Z m (fun k => f z mu nu k m * point (IZR k) K0n Kmn (IZR m)) = K0n + sum 0%Z m (fun k => f z mu nu k m * IZR k / IZR m) * (Kmn - K0n) /\ sum 0%Z n (fun l => f z1 mu1 nu1 l n * point (IZR l) K00 K0n (IZR n)) = K00 + sum 0%Z n (fun l => f z1 mu1 nu1 l n * IZR l / IZR n) * (K0n - K00) /\ sum 0%Z n (fun l => f z1 mu1 nu1 l n * point (IZR l) Km0 Kmn (IZR n)) = Km0 + sum 0%Z n (fun l => f z1 mu1 nu1 l n * IZR l / IZR n) * (Kmn - Km0).
Definition instance : Prop :=
exists (k : Z) (l : Z) (m : Z) (n : Z) (K00 : R) (K0n : R) (Km0 : R) (Kmn : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (1 <= k <= m)%Z /\
  (1 <= l <= n)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1 /\
  IZR m <> 0 /\
  IZR n <> 0.
End alg_2_2.

Module alg_2_2_irregular.
(* gbt-surfaces/alg-2.2.irregular, Sect. 3.2, Algorithm 2, step 2, parenthesis
   printed: (an irregular division can also be made)
   read as: For one of the segments, with ends A and B, and any division numbers t_k: the boundary is A + s (B - A), where s is a combination of the t_k with nonnegative weights that sum to one.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*(A + t[k]*(B - A))) == A + sum(k, 0, m, f[k,m](z, mu, nu)*t[k])*(B - A) and nonnegative(f) and sum(k, 0, m, f[k,m](z, mu, nu)) == 1 *)
Definition statement : Prop :=
forall (m : Z) (A : R) (B : R) (mu : R) (nu : R) (t : Z -> R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  sum 0%Z m (fun k => f z mu nu k m * (A + t k * (B - A))) = A + sum 0%Z m (fun k => f z mu nu k m * t k) * (B - A) /\ (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m) = 1.
Definition instance : Prop :=
exists (m : Z) (A : R) (B : R) (mu : R) (nu : R) (t : Z -> R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End alg_2_2_irregular.

Module eq_16.
(* gbt-surfaces/eq-16, Sect. 3.2, Algorithm 2, step 3, eq. (16)
   printed: T_bi-linear(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{n} Q_{k,l} f_{k,m}(z) f_{l,n}(z_1), z, z_1 ∈ [0,1]
   read as: (16) is the surface (7), and the interior points are free: the boundary curves depend on the exterior points alone.
   stated: sum(k, 0, m, sum(l, 0, n, G[k,l]*f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1))) == T(z, z1) and R(z, 0) == sum(k, 0, m, f[k,m](z, mu, nu)*G[k,0]) and R(z, 1) == sum(k, 0, m, f[k,m](z, mu, nu)*G[k,n]) and T(0, z1) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*G[0,l]) and T(1, z1) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*G[m,l]) *)
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
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= n <= n)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 0 <= m)%Z) ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= m <= m)%Z) ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => G k l * f z mu nu k m * f z1 mu1 nu1 l n)) = T G m mu mu1 n nu nu1 z z1 /\ R_ G m mu mu1 n nu nu1 z 0 = sum 0%Z m (fun k => f z mu nu k m * G k 0%Z) /\ R_ G m mu mu1 n nu nu1 z 1 = sum 0%Z m (fun k => f z mu nu k m * G k n) /\ T G m mu mu1 n nu nu1 0 z1 = sum 0%Z n (fun l => f z1 mu1 nu1 l n * G 0%Z l) /\ T G m mu mu1 n nu nu1 1 z1 = sum 0%Z n (fun l => f z1 mu1 nu1 l n * G m l).
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
  (forall l : Z, (0 <= l <= n)%Z -> forall k : Z, (0 <= k <= m)%Z -> (0 <= l <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= 0 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (0 <= n <= n)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 0 <= m)%Z) /\
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= m <= m)%Z).
End eq_16.

Module ex_3_2_corners.
(* gbt-surfaces/ex-3.2.corners, Sect. 3.2, Example 3.2, data
   printed: Q_{0,0} = (0, 0, 0), Q_{3,0} = (3, 0, 0), Q_{0,3} = (0, 3, 0), Q_{3,3} = (3, 3, 0)
   read as: The surface of the sixteen points interpolates these four, as its angular points.
   stated: at(at(sixteen, z, 0), z1, 0) == [0, 0, 0] and at(at(sixteen, z, 1), z1, 0) == [3, 0, 0] and at(at(sixteen, z, 0), z1, 1) == [0, 3, 0] and at(at(sixteen, z, 1), z1, 1) == [3, 3, 0] *)
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (fun z1 : R => (fun z : R => sixteen mu mu1 nu nu1 z z1) 0) 0 = [0; 0; 0] /\ (fun z1 : R => (fun z : R => sixteen mu mu1 nu nu1 z z1) 1) 0 = [3; 0; 0] /\ (fun z1 : R => (fun z : R => sixteen mu mu1 nu nu1 z z1) 0) 1 = [0; 3; 0] /\ (fun z1 : R => (fun z : R => sixteen mu mu1 nu nu1 z z1) 1) 1 = [3; 3; 0].
Definition instance : Prop :=
exists (mu : R) (mu1 : R) (nu : R) (nu1 : R),
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End ex_3_2_corners.

Module ex_3_2_division_z_lines.
(* gbt-surfaces/ex-3.2.division.z-lines, Sect. 3.2, Example 3.2, data, first line of the brace
   printed: Q_{1,0} = (1, 0, 0), Q_{2,0} = (2, 0, 0), Q_{1,3} = (1, 3, 0), Q_{2,3} = (2, 3, 0)
   stated: Q00 + 1/3*(Q30 - Q00) == Q10 and Q00 + 2/3*(Q30 - Q00) == Q20 and Q03 + 1/3*(Q33 - Q03) == Q13 and Q03 + 2/3*(Q33 - Q03) == Q23 *)
Definition statement : Prop :=
  vadd Q00 (vscale (1 / 3) (vsub Q30 Q00)) = Q10 /\ vadd Q00 (vscale (2 / 3) (vsub Q30 Q00)) = Q20 /\ vadd Q03 (vscale (1 / 3) (vsub Q33 Q03)) = Q13 /\ vadd Q03 (vscale (2 / 3) (vsub Q33 Q03)) = Q23.
End ex_3_2_division_z_lines.

Module ex_3_2_division_Q0l.
(* gbt-surfaces/ex-3.2.division.Q0l, Sect. 3.2, Example 3.2, data, second line of the brace
   printed: Q_{0,1} = (0, 1, 0), Q_{0,2} = (0, 2, 0)
   stated: Q00 + 1/3*(Q03 - Q00) == Q01 and Q00 + 2/3*(Q03 - Q00) == Q02 *)
Definition statement : Prop :=
  vadd Q00 (vscale (1 / 3) (vsub Q03 Q00)) = Q01 /\ vadd Q00 (vscale (2 / 3) (vsub Q03 Q00)) = Q02.
End ex_3_2_division_Q0l.

Module ex_3_2_division_Q3l.
(* gbt-surfaces/ex-3.2.division.Q3l, Sect. 3.2, Example 3.2, data, second line of the brace
   printed: Q_{3,1} = (3, 2, 0), Q_{3,2} = (3, 2, 0)
   stated: Q30 + 1/3*(Q33 - Q30) == [3, 2, 0] and Q30 + 2/3*(Q33 - Q30) == [3, 2, 0] *)
Definition statement : Prop :=
  vadd Q30 (vscale (1 / 3) (vsub Q33 Q30)) = [3; 2; 0] /\ vadd Q30 (vscale (2 / 3) (vsub Q33 Q30)) = [3; 2; 0].
End ex_3_2_division_Q3l.

Module ex_3_2_division_Q3l_corrected.
(* gbt-surfaces/ex-3.2.division.Q3l (corrected), Sect. 3.2, Example 3.2, data, second line of the brace
   printed: Q_{3,1} = (3, 2, 0), Q_{3,2} = (3, 2, 0)
   stated: Q30 + 1/3*(Q33 - Q30) == [3, 1, 0] and Q30 + 2/3*(Q33 - Q30) == [3, 2, 0] *)
Definition statement : Prop :=
  vadd Q30 (vscale (1 / 3) (vsub Q33 Q30)) = [3; 1; 0] /\ vadd Q30 (vscale (2 / 3) (vsub Q33 Q30)) = [3; 2; 0].
End ex_3_2_division_Q3l_corrected.

Module ex_3_2_equal_parts_a.
(* gbt-surfaces/ex-3.2.equal-parts.a, Sect. 3.2, Example 3.2
   printed: the eight central partition points produced by dividing the line segments Q_{0,0}Q_{3,0}, Q_{0,3}Q_{3,3}, Q_{0,0}Q_{0,3}, and Q_{3,0}Q_{3,3} into three equal parts
   read as: The side from Q_{0,0} to Q_{3,0}.
   stated: Q10 - Q00 == Q20 - Q10 and Q20 - Q10 == Q30 - Q20 *)
Definition statement : Prop :=
  vsub Q10 Q00 = vsub Q20 Q10 /\ vsub Q20 Q10 = vsub Q30 Q20.
End ex_3_2_equal_parts_a.

Module ex_3_2_equal_parts_b.
(* gbt-surfaces/ex-3.2.equal-parts.b, Sect. 3.2, Example 3.2
   printed: the eight central partition points produced by dividing the line segments Q_{0,0}Q_{3,0}, Q_{0,3}Q_{3,3}, Q_{0,0}Q_{0,3}, and Q_{3,0}Q_{3,3} into three equal parts
   read as: The side from Q_{0,3} to Q_{3,3}.
   stated: Q13 - Q03 == Q23 - Q13 and Q23 - Q13 == Q33 - Q23 *)
Definition statement : Prop :=
  vsub Q13 Q03 = vsub Q23 Q13 /\ vsub Q23 Q13 = vsub Q33 Q23.
End ex_3_2_equal_parts_b.

Module ex_3_2_equal_parts_c.
(* gbt-surfaces/ex-3.2.equal-parts.c, Sect. 3.2, Example 3.2
   printed: the eight central partition points produced by dividing the line segments Q_{0,0}Q_{3,0}, Q_{0,3}Q_{3,3}, Q_{0,0}Q_{0,3}, and Q_{3,0}Q_{3,3} into three equal parts
   read as: The side from Q_{0,0} to Q_{0,3}.
   stated: Q01 - Q00 == Q02 - Q01 and Q02 - Q01 == Q03 - Q02 *)
Definition statement : Prop :=
  vsub Q01 Q00 = vsub Q02 Q01 /\ vsub Q02 Q01 = vsub Q03 Q02.
End ex_3_2_equal_parts_c.

Module ex_3_2_equal_parts_d.
(* gbt-surfaces/ex-3.2.equal-parts.d, Sect. 3.2, Example 3.2
   printed: the eight central partition points produced by dividing the line segments Q_{0,0}Q_{3,0}, Q_{0,3}Q_{3,3}, Q_{0,0}Q_{0,3}, and Q_{3,0}Q_{3,3} into three equal parts
   read as: The side from Q_{3,0} to Q_{3,3}, with the printed Q_{3,1} and Q_{3,2}.
   stated: Q30 + 1/3*(Q33 - Q30) == [3, 2, 0] and Q30 + 2/3*(Q33 - Q30) == [3, 2, 0] *)
Definition statement : Prop :=
  vadd Q30 (vscale (1 / 3) (vsub Q33 Q30)) = [3; 2; 0] /\ vadd Q30 (vscale (2 / 3) (vsub Q33 Q30)) = [3; 2; 0].
End ex_3_2_equal_parts_d.

Module ex_3_2_equal_parts_d_corrected.
(* gbt-surfaces/ex-3.2.equal-parts.d (corrected), Sect. 3.2, Example 3.2
   printed: the eight central partition points produced by dividing the line segments Q_{0,0}Q_{3,0}, Q_{0,3}Q_{3,3}, Q_{0,0}Q_{0,3}, and Q_{3,0}Q_{3,3} into three equal parts
   read as: The side from Q_{3,0} to Q_{3,3}, with the printed Q_{3,1} and Q_{3,2}.
   stated: Q30 + 1/3*(Q33 - Q30) == [3, 1, 0] and Q30 + 2/3*(Q33 - Q30) == [3, 2, 0] *)
Definition statement : Prop :=
  vadd Q30 (vscale (1 / 3) (vsub Q33 Q30)) = [3; 1; 0] /\ vadd Q30 (vscale (2 / 3) (vsub Q33 Q30)) = [3; 2; 0].
End ex_3_2_equal_parts_d_corrected.

Module ex_3_2_interior.
(* gbt-surfaces/ex-3.2.interior, Sect. 3.2, Example 3.2, data
   printed: Q_{1,1} = (1, 1, 3), Q_{2,1} = (2, 1, 3), Q_{1,2} = (1, 2, 3), Q_{2,2} = (2, 2, 3)
   read as: The points are chosen freely; they lie 3 above the points of the square that the partition points mark.
   stated: Q10 + Q01 + [0, 0, 3] == [1, 1, 3] and Q20 + Q01 + [0, 0, 3] == [2, 1, 3] and Q10 + Q02 + [0, 0, 3] == [1, 2, 3] and Q20 + Q02 + [0, 0, 3] == [2, 2, 3] *)
Definition statement : Prop :=
  vadd (vadd Q10 Q01) [0; 0; 3] = [1; 1; 3] /\ vadd (vadd Q20 Q01) [0; 0; 3] = [2; 1; 3] /\ vadd (vadd Q10 Q02) [0; 0; 3] = [1; 2; 3] /\ vadd (vadd Q20 Q02) [0; 0; 3] = [2; 2; 3].
End ex_3_2_interior.

Module ex_3_2_equation.
(* gbt-surfaces/ex-3.2.equation, Sect. 3.2, Example 3.2, sentence after the data
   printed: By using control points and equation (15), the GBT-Bézier bi-linear surface can be designed
   read as: The surface of the sixteen control points is said to be (15), the surface of four.
   stated: sixteen == four *)
Definition four (z : R) (z1 : R) : list R :=
  vadd (vadd (vadd (vscale (b z 0%Z 1%Z * b z1 0%Z 1%Z) Q00) (vscale (b z 1%Z 1%Z * b z1 0%Z 1%Z) Q30)) (vscale (b z 0%Z 1%Z * b z1 1%Z 1%Z) Q03)) (vscale (b z 1%Z 1%Z * b z1 1%Z 1%Z) Q33).
Definition statement : Prop :=
forall (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sixteen mu mu1 nu nu1 z z1 = four z z1.
End ex_3_2_equation.

Module ex_3_2_sixteen.
(* gbt-surfaces/ex-3.2.sixteen, Sect. 3.2, Example 3.2, last paragraph
   printed: Bi-linear surfaces have sixteen control points
   read as: The points of the net of a third degree surface (16).
   stated: sum(k, 0, 3, sum(l, 0, 3, 1)) == 16 *)
Definition statement : Prop :=
  sum 0%Z 3%Z (fun k => sum 0%Z 3%Z (fun l => 1)) = 16.
End ex_3_2_sixteen.

Module ex_3_2_coplanar.
(* gbt-surfaces/ex-3.2.coplanar, Sect. 3.2, Example 3.2, last paragraph
   printed: in which the exterior twelve control mesh points are coplanar
   stated: dot([0, 0, 1], Q00) == 0 and dot([0, 0, 1], Q10) == 0 and dot([0, 0, 1], Q20) == 0 and dot([0, 0, 1], Q30) == 0 and dot([0, 0, 1], Q03) == 0 and dot([0, 0, 1], Q13) == 0 and dot([0, 0, 1], Q23) == 0 and dot([0, 0, 1], Q33) == 0 and dot([0, 0, 1], Q01) == 0 and dot([0, 0, 1], Q02) == 0 and dot([0, 0, 1], Q31) == 0 and dot([0, 0, 1], Q32) == 0 *)
Definition statement : Prop :=
  dot [0; 0; 1] Q00 = 0 /\ dot [0; 0; 1] Q10 = 0 /\ dot [0; 0; 1] Q20 = 0 /\ dot [0; 0; 1] Q30 = 0 /\ dot [0; 0; 1] Q03 = 0 /\ dot [0; 0; 1] Q13 = 0 /\ dot [0; 0; 1] Q23 = 0 /\ dot [0; 0; 1] Q33 = 0 /\ dot [0; 0; 1] Q01 = 0 /\ dot [0; 0; 1] Q02 = 0 /\ dot [0; 0; 1] Q31 = 0 /\ dot [0; 0; 1] Q32 = 0.
End ex_3_2_coplanar.

Module ex_3_2_noncoplanar_possible.
(* gbt-surfaces/ex-3.2.noncoplanar.possible, Sect. 3.2, Example 3.2, last sentence
   printed: There are such surfaces: the four angular points need not lie in a plane, and all four boundaries are straight all the same.
   stated: fails(det([Km0 - K00, K0n - K00, Kmn - K00]) == 0) and sum(k, 0, m, f[k,m](z, mu, nu)*(K00 + t[k]*(Km0 - K00))) == K00 + sum(k, 0, m, f[k,m](z, mu, nu)*t[k])*(Km0 - K00) and sum(k, 0, m, f[k,m](z, mu, nu)*(K0n + t[k]*(Kmn - K0n))) == K0n + sum(k, 0, m, f[k,m](z, mu, nu)*t[k])*(Kmn - K0n) and sum(l, 0, n, f[l,n](z1, mu1, nu1)*(K00 + t[l]*(K0n - K00))) == K00 + sum(l, 0, n, f[l,n](z1, mu1, nu1)*t[l])*(K0n - K00) and sum(l, 0, n, f[l,n](z1, mu1, nu1)*(Km0 + t[l]*(Kmn - Km0))) == Km0 + sum(l, 0, n, f[l,n](z1, mu1, nu1)*t[l])*(Kmn - Km0) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (K00'1 K00'2 K00'3 : R) (K0n'1 K0n'2 K0n'3 : R) (Km0'1 Km0'2 Km0'3 : R) (Kmn'1 Kmn'2 Kmn'3 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (t : Z -> R) (z : R) (z1 : R),
  let K00 := [K00'1; K00'2; K00'3] in
  let K0n := [K0n'1; K0n'2; K0n'3] in
  let Km0 := [Km0'1; Km0'2; Km0'3] in
  let Kmn := [Kmn'1; Kmn'2; Kmn'3] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (K00'1 K00'2 K00'3 : R) (K0n'1 K0n'2 K0n'3 : R) (Km0'1 Km0'2 Km0'3 : R) (Kmn'1 Kmn'2 Kmn'3 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (t : Z -> R) (z : R) (z1 : R),
  let K00 := [K00'1; K00'2; K00'3] in
  let K0n := [K0n'1; K0n'2; K0n'3] in
  let Km0 := [Km0'1; Km0'2; Km0'3] in
  let Kmn := [Kmn'1; Kmn'2; Kmn'3] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  det [vsub Km0 K00; vsub K0n K00; vsub Kmn K00] = 0) /\ vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (vadd K00 (vscale (t k) (vsub Km0 K00)))) = vadd K00 (vscale (sum 0%Z m (fun k => f z mu nu k m * t k)) (vsub Km0 K00)) /\ vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (vadd K0n (vscale (t k) (vsub Kmn K0n)))) = vadd K0n (vscale (sum 0%Z m (fun k => f z mu nu k m * t k)) (vsub Kmn K0n)) /\ vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) (vadd K00 (vscale (t l) (vsub K0n K00)))) = vadd K00 (vscale (sum 0%Z n (fun l => f z1 mu1 nu1 l n * t l)) (vsub K0n K00)) /\ vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) (vadd Km0 (vscale (t l) (vsub Kmn Km0)))) = vadd Km0 (vscale (sum 0%Z n (fun l => f z1 mu1 nu1 l n * t l)) (vsub Kmn Km0)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (K00'1 K00'2 K00'3 : R) (K0n'1 K0n'2 K0n'3 : R) (Km0'1 Km0'2 Km0'3 : R) (Kmn'1 Kmn'2 Kmn'3 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (t : Z -> R) (z : R) (z1 : R),
  let K00 := [K00'1; K00'2; K00'3] in
  let K0n := [K0n'1; K0n'2; K0n'3] in
  let Km0 := [Km0'1; Km0'2; Km0'3] in
  let Kmn := [Kmn'1; Kmn'2; Kmn'3] in
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End ex_3_2_noncoplanar_possible.
