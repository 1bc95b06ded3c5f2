(* Statements of gbt-surfaces, Section 2 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition start (m : Z) (mu : R) (nu : R) (j : Z) (r : Z) : R :=
  let z := 0%Z in Derive_n (fun z_ => f z_ mu nu j m) (Z.to_nat r) (IZR z).
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition p0 (mu : R) : R :=
  PI ^ 2 / 2 * mu.
Definition p2 (nu : R) : R :=
  PI ^ 2 / 4 * (1 - nu).
Definition r0 (nu : R) : R :=
  PI ^ 2 / 2 * nu.
Definition r2 (mu : R) : R :=
  PI ^ 2 / 4 * (1 - mu).
End Definitions.
Import Definitions.

Module eq_1_f0.
(* gbt-surfaces/eq-1.f0, Sect. 2.1, eq. (1), first line
   printed: f_{0,2}(z) = (1 - sin(π/2 z))(1 - μ sin(π/2 z))
   read as: The printed formula against the third line of (1), of which Theorem 1 makes it the mirror image.
   stated: (1 - sin(pi/2*z))*(1 - mu*sin(pi/2*z)) == f[2,2](1 - z, nu, mu) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) = f (1 - z) nu mu 2%Z 2%Z.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_1_f0.

Module eq_1_f1.
(* gbt-surfaces/eq-1.f1, Sect. 2.1, eq. (1), second line
   printed: f_{1,2}(z) = (1 - f_{0,2}(z) - f_{2,2}(z))
   read as: The printed formula, and that it is its own mirror image, as Theorem 1 asks.
   stated: 1 - f[0,2](z) - f[2,2](z) == f[1,2](z) and f[1,2](z, mu, nu) == f[1,2](1 - z, nu, mu) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  1 - f z mu nu 0%Z 2%Z - f z mu nu 2%Z 2%Z = f z mu nu 1%Z 2%Z /\ f z mu nu 1%Z 2%Z = f (1 - z) nu mu 1%Z 2%Z.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_1_f1.

Module eq_1_f2.
(* gbt-surfaces/eq-1.f2, Sect. 2.1, eq. (1), third line
   printed: f_{2,2}(z) = (1 - cos(π/2 z))(1 - ν cos(π/2 z)) [...] are known as second order GBTB basis functions with shape parameters μ, ν
   read as: The printed formula against the first line of (1), of which Theorem 1 makes it the mirror image.
   stated: (1 - cos(pi/2*z))*(1 - nu*cos(pi/2*z)) == f[0,2](1 - z, nu, mu) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)) = f (1 - z) nu mu 0%Z 2%Z.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_1_f2.

Module eq_2.
(* gbt-surfaces/eq-2, Sect. 2.1, eq. (2)
   printed: f_{k,m}(z) = (1 - z) f_{k,m-1}(z) + z f_{k-1,m-1}(z), m ≥ 3, k = 0, 1, 2, ..., m
   read as: The printed step against Theorem 1, by which its result is the mirror image of the function m - k.
   stated: (1 - z)*f[k,m-1](z, mu, nu) + z*f[k-1,m-1](z, mu, nu) == f[m-k,m](1 - z, nu, mu) *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (2 <= m - 1)%Z ->
  (2 <= m)%Z ->
  (1 - z) * f z mu nu k (m - 1)%Z + z * f z mu nu (k - 1)%Z (m - 1)%Z = f (1 - z) nu mu (m - k)%Z m.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (2 <= m - 1)%Z /\
  (2 <= m)%Z.
End eq_2.

Module eq_2_zero.
(* gbt-surfaces/eq-2.zero, Sect. 2.1, sentence after eq. (2)
   printed: when k = -1 or k > n, the functions f_{k,m}(z) = 0
   read as: The bound n is a number of its own, which the definition does not name.
   stated: f[-1,m](z) == 0 and f[n+j,m](z) == 0 *)
Definition statement : Prop :=
forall (j : Z) (m : Z) (n : Z) (mu : R) (nu : R) (z : R),
  (1 <= j)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  f z mu nu (- 1)%Z m = 0 /\ f z mu nu (n + j)%Z m = 0.
End eq_2_zero.

Module eq_2_zero_true.
(* gbt-surfaces/eq-2.zero.true, Sect. 2.1, sentence after eq. (2)
   printed: The functions of order m with the index -1 or an index above m are zero.
   stated: f[-1,m](z) == 0 and f[m+j,m](z) == 0 *)
Definition statement : Prop :=
forall (j : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (1 <= j)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  f z mu nu (- 1)%Z m = 0 /\ f z mu nu (m + j)%Z m = 0.
Definition instance : Prop :=
exists (j : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (1 <= j)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_2_zero_true.

Module thm_1_1_formal.
(* gbt-surfaces/thm-1.1.formal, Sect. 2.1, Theorem 1, item 1 (Degeneracy)
   printed: GBTB basis functions of order m become just like the classical Bernstein basis functions of order m by setting μ,ν = 1 and sin(π/2 z), 1 - cos(π/2 z) = z
   read as: In (1) with μ = ν = 1 the letters sin(π/2 z) and 1 - cos(π/2 z) are replaced by z.
   stated: g[k,m](z, mu, nu, sin(pi/2*z), cos(pi/2*z)) == f[k,m](z, mu, nu) and g[k,m](z, 1, 1, z, 1 - z) == b[k,m](z) *)
Definition g (z : R) (mu : R) (nu : R) (s : R) (c : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - s) * (1 - mu * s); 1 - (1 - s) * (1 - mu * s) - (1 - c) * (1 - nu * c); (1 - c) * (1 - nu * c)] i k.
Definition b (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - z) ^ 1 * z ^ 0; (1 - z) ^ 0 * z ^ 1] i k.
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (1 <= m)%Z ->
  g z mu nu (sin (PI / 2 * z)) (cos (PI / 2 * z)) k m = f z mu nu k m /\ g z 1 1 z (1 - z) k m = b z k m.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (1 <= m)%Z.
End thm_1_1_formal.

Module thm_1_1_as_functions.
(* gbt-surfaces/thm-1.1.as functions, Sect. 2.1, Theorem 1, item 1 (Degeneracy)
   printed: GBTB basis functions of order m become just like the classical Bernstein basis functions of order m by setting μ,ν = 1 and sin(π/2 z), 1 - cos(π/2 z) = z
   read as: With μ = ν = 1 the functions are those of Bernstein in sin(π/2 z), and 1 - cos(π/2 z) is the same. For order 2.
   stated: f[0,2](z) == (1 - sin(pi/2*z))^2 and f[1,2](z) == 2*sin(pi/2*z)*(1 - sin(pi/2*z)) and f[2,2](z) == sin(pi/2*z)^2 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  mu = 1 ->
  nu = 1 ->
  f z mu nu 0%Z 2%Z = (1 - sin (PI / 2 * z)) ^ 2 /\ f z mu nu 1%Z 2%Z = 2 * sin (PI / 2 * z) * (1 - sin (PI / 2 * z)) /\ f z mu nu 2%Z 2%Z = sin (PI / 2 * z) ^ 2.
End thm_1_1_as_functions.

Module thm_1_1_true.
(* gbt-surfaces/thm-1.1.true, Sect. 2.1, Theorem 1, item 1 (Degeneracy)
   printed: The functions of order 2 are those of Bernstein in sin(π/2 z) for μ = 1, ν = -1.
   stated: f[0,2](z) == (1 - sin(pi/2*z))^2 and f[1,2](z) == 2*sin(pi/2*z)*(1 - sin(pi/2*z)) and f[2,2](z) == sin(pi/2*z)^2 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  mu = 1 ->
  nu = - 1 ->
  f z mu nu 0%Z 2%Z = (1 - sin (PI / 2 * z)) ^ 2 /\ f z mu nu 1%Z 2%Z = 2 * sin (PI / 2 * z) * (1 - sin (PI / 2 * z)) /\ f z mu nu 2%Z 2%Z = sin (PI / 2 * z) ^ 2.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  mu = 1 /\
  nu = - 1.
End thm_1_1_true.

Module thm_1_1_blend.
(* gbt-surfaces/thm-1.1.blend, Sect. 2.1, Theorem 1, item 1 (Degeneracy)
   printed: For μ = 1, ν = -1 a curve of order m is made in two steps with sin(π/2 z) and m - 2 steps with z.
   stated: sum(k, 0, m, f[k,m](z)*Q[k]) == sum(k, 0, m - 2, e[k,m-2](z)*((1 - sin(pi/2*z))^2*Q[k] + 2*sin(pi/2*z)*(1 - sin(pi/2*z))*Q[k+1] + sin(pi/2*z)^2*Q[k+2])) *)
Definition e (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [1] i k.
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  mu = 1 ->
  nu = - 1 ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 1 <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 2 <= m)%Z) ->
  sum 0%Z m (fun k => f z mu nu k m * Q k) = sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * ((1 - sin (PI / 2 * z)) ^ 2 * Q k + 2 * sin (PI / 2 * z) * (1 - sin (PI / 2 * z)) * Q (k + 1)%Z + sin (PI / 2 * z) ^ 2 * Q (k + 2)%Z)).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  mu = 1 /\
  nu = - 1 /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 1 <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 2 <= m)%Z).
End thm_1_1_blend.

Module thm_1_2_Definition_1.
(* gbt-surfaces/thm-1.2.Definition 1, Sect. 2.1, Theorem 1, item 2 (Nonnegativity)
   printed: ∀μ,ν (-1 ≤ μ,ν ≤ 1), the functions f_{k,m}(z) ≥ 0 (k = 0, 1, 2, ..., m)
   read as: The range of z is that of Definition 1, from -1 to 1: z and -z for z in [0, 1]. Of the functions of order 2 the middle one is examined.
   stated: f[1,2](z, mu, nu) >= 0 and f[1,2](-z, mu, nu) >= 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  f z mu nu 1%Z 2%Z >= 0 /\ f (- z) mu nu 1%Z 2%Z >= 0.
End thm_1_2_Definition_1.

Module thm_1_2_where_curves_are_defined.
(* gbt-surfaces/thm-1.2.where curves are defined, Sect. 2.1, Theorem 1, item 2 (Nonnegativity)
   printed: ∀μ,ν (-1 ≤ μ,ν ≤ 1), the functions f_{k,m}(z) ≥ 0 (k = 0, 1, 2, ..., m)
   read as: The range of z is that of (3) and of all surfaces, from 0 to 1.
   stated: nonnegative(f) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k.
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End thm_1_2_where_curves_are_defined.

Module thm_1_3.
(* gbt-surfaces/thm-1.3, Sect. 2.1, Theorem 1, item 3 (Partition of unity)
   printed: The sum of all GBTB basis functions of degree m is equal to one.
   stated: sum(k, 0, m, f[k,m](z)) == 1 *)
Definition statement : Prop :=
forall (m : Z) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  sum 0%Z m (fun k => f z mu nu k m) = 1.
Definition instance : Prop :=
exists (m : Z) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End thm_1_3.

Module thm_1_4.
(* gbt-surfaces/thm-1.4, Sect. 2.1, Theorem 1, item 4 (Symmetry)
   printed: The functions f_{k,m}(z) (k = 0, 1, 2, ..., m) are symmetric when μ = ν, i.e., f_{m-k,m}(z,μ,ν) = f_{k,m}(1 - z,μ,ν).
   stated: f[m-k,m](z, mu, nu) == f[k,m](1 - z, mu, nu) *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  mu = nu ->
  f z mu nu (m - k)%Z m = f (1 - z) mu nu k m.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  mu = nu.
End thm_1_4.

Module thm_1_5_d1_0_values.
(* gbt-surfaces/thm-1.5.d1-0.values, Sect. 2.1, Theorem 1, item 5
   printed: The first derivatives at 0 of the functions (1)-(2), for every order.
   stated: start(0, 1) == -(m - 2) - pi/2*(1 + mu) and start(1, 1) == m - 2 + pi/2*(1 + mu) and start(k, 1) == 0 *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R),
  (2 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  start m mu nu 0%Z 1%Z = - (IZR m - 2) - PI / 2 * (1 + mu) /\ start m mu nu 1%Z 1%Z = IZR m - 2 + PI / 2 * (1 + mu) /\ start m mu nu k 1%Z = 0.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R),
  (2 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_5_d1_0_values.

Module thm_1_5_d1_1_values.
(* gbt-surfaces/thm-1.5.d1-1.values, Sect. 2.1, Theorem 1, item 5
   printed: The first derivatives at 1 of the functions (1)-(2), for every order.
   read as: The derivative of f_{k,m} is the coefficient of Q_k.
   stated: F'(1) == (m - 2 + pi/2*(1 + nu))*(Q[m] - Q[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (let z := 1%Z in Derive_n (fun z_ => F Q m mu nu z_) 1 (IZR z)) = (IZR m - 2 + PI / 2 * (1 + nu)) * (Q m - Q (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z.
End thm_1_5_d1_1_values.

Module thm_1_5_d2_0_values.
(* gbt-surfaces/thm-1.5.d2-0.values, Sect. 2.1, Theorem 1, item 5
   printed: The second derivatives at 0 of the functions (1)-(2), for every order.
   stated: start(0, 2) == second + p0 and start(1, 2) == -2*second - p0 - p2 and start(2, 2) == second + p2 and start(k, 2) == 0 *)
Definition second (m : Z) (mu : R) : R :=
  (IZR m - 2) * (IZR m - 3 + PI * (1 + mu)).
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R),
  (3 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  start m mu nu 0%Z 2%Z = second m mu + p0 mu /\ start m mu nu 1%Z 2%Z = - 2 * second m mu - p0 mu - p2 nu /\ start m mu nu 2%Z 2%Z = second m mu + p2 nu /\ start m mu nu k 2%Z = 0.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R),
  (3 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_5_d2_0_values.

Module thm_1_5_d2_1_values.
(* gbt-surfaces/thm-1.5.d2-1.values, Sect. 2.1, Theorem 1, item 5
   printed: The second derivatives at 1 of the functions (1)-(2), for every order.
   read as: The derivative of f_{k,m} is the coefficient of Q_k.
   stated: F''(1) == (second1 + r0)*Q[m] - (2*second1 + r0 + r2)*Q[m-1] + (second1 + r2)*Q[m-2] *)
Definition second1 (m : Z) (nu : R) : R :=
  (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= m <= m)%Z ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  (let z := 1%Z in Derive_n (fun z_ => F Q m mu nu z_) 2 (IZR z)) = (second1 m nu + r0 nu) * Q m - (2 * second1 m nu + r0 nu + r2 mu) * Q (m - 1)%Z + (second1 m nu + r2 mu) * Q (m - 2)%Z.
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= m <= m)%Z /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z.
End thm_1_5_d2_1_values.

Module thm_1_5_d3_0_values.
(* gbt-surfaces/thm-1.5.d3-0.values, Sect. 2.1, Theorem 1, item 5
   printed: The third derivatives at 0 of the functions (1)-(2), for every order.
   stated: start(0, 3) == -third - 3*(m - 2)*p0 + pi^3/8*(1 + mu) and start(1, 3) == 3*third + 3*(m - 2)*(2*p0 + p2) - pi^3/8*(1 + mu) and start(2, 3) == -3*third - 3*(m - 2)*(p0 + 2*p2) and start(3, 3) == third + 3*(m - 2)*p2 and start(k, 3) == 0 *)
Definition third (m : Z) (mu : R) : R :=
  (IZR m - 2) * (IZR m - 3) * (IZR m - 4 + 3 / 2 * PI * (1 + mu)).
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R),
  (4 <= k <= m)%Z ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (2 <= m)%Z ->
  start m mu nu 0%Z 3%Z = - third m mu - 3 * (IZR m - 2) * p0 mu + PI ^ 3 / 8 * (1 + mu) /\ start m mu nu 1%Z 3%Z = 3 * third m mu + 3 * (IZR m - 2) * (2 * p0 mu + p2 nu) - PI ^ 3 / 8 * (1 + mu) /\ start m mu nu 2%Z 3%Z = - 3 * third m mu - 3 * (IZR m - 2) * (p0 mu + 2 * p2 nu) /\ start m mu nu 3%Z 3%Z = third m mu + 3 * (IZR m - 2) * p2 nu /\ start m mu nu k 3%Z = 0.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R),
  (4 <= k <= m)%Z /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (2 <= m)%Z.
End thm_1_5_d3_0_values.

Module thm_1_5_d3_1_values.
(* gbt-surfaces/thm-1.5.d3-1.values, Sect. 2.1, Theorem 1, item 5
   printed: The third derivatives at 1 of the functions (1)-(2), for every order.
   read as: The derivative of f_{k,m} is the coefficient of Q_k.
   stated: F'''(1) == (third1 + 3*(m - 2)*r0 - pi^3/8*(1 + nu))*Q[m] - (3*third1 + 3*(m - 2)*(2*r0 + r2) - pi^3/8*(1 + nu))*Q[m-1] + (3*third1 + 3*(m - 2)*(r0 + 2*r2))*Q[m-2] - (third1 + 3*(m - 2)*r2)*Q[m-3] *)
Definition third1 (m : Z) (nu : R) : R :=
  (IZR m - 2) * (IZR m - 3) * (IZR m - 4 + 3 / 2 * PI * (1 + nu)).
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
  (let z := 1%Z in Derive_n (fun z_ => F Q m mu nu z_) 3 (IZR z)) = (third1 m nu + 3 * (IZR m - 2) * r0 nu - PI ^ 3 / 8 * (1 + nu)) * Q m - (3 * third1 m nu + 3 * (IZR m - 2) * (2 * r0 nu + r2 mu) - PI ^ 3 / 8 * (1 + nu)) * Q (m - 1)%Z + (3 * third1 m nu + 3 * (IZR m - 2) * (r0 nu + 2 * r2 mu)) * Q (m - 2)%Z - (third1 m nu + 3 * (IZR m - 2) * r2 mu) * Q (m - 3)%Z.
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
End thm_1_5_d3_1_values.
