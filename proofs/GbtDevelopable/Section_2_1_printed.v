(* Statements of gbt-developable, Section 2 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition b (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition G (R_ : Z -> R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * R_ i).
End Definitions.
Import Definitions.

Module def_1_g0.
(* gbt-developable/def-1.g0, Sect. 2.1, Definition 1, first line
   printed: g_{0,2}(x) = (1 − sin(π/2 x)) (1 − μ sin(π/2 x))
   stated: g[0,2](x) == (1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  g x mu nu 0%Z 2%Z = (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)).
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_1_g0.

Module def_1_g1.
(* gbt-developable/def-1.g1, Sect. 2.1, Definition 1, second line
   printed: g_{1,2}(x) = (1 − g_{0,2}(x) − g_{2,2}(x))
   stated: g[1,2](x) == 1 - g[0,2](x) - g[2,2](x) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  g x mu nu 1%Z 2%Z = 1 - g x mu nu 0%Z 2%Z - g x mu nu 2%Z 2%Z.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_1_g1.

Module def_1_g2.
(* gbt-developable/def-1.g2, Sect. 2.1, Definition 1, third line
   printed: g_{2,2}(x) = (1 − cos(π/2 x)) (1 − ν cos(π/2 x))
   stated: g[2,2](x) == (1 - cos(pi/2*x))*(1 - nu*cos(pi/2*x)) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  g x mu nu 2%Z 2%Z = (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)).
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_1_g2.

Module def_1_range.
(* gbt-developable/def-1.range, Sect. 2.1, Definition 1
   printed: μ, ν ∈ [−1, 1] and x ∈ [0, 1]
   read as: The html copy drops minus signs ([1,1]); the pdf copy prints [–1, 1]. Compared with the ranges that all other statements use.
   stated: -1 <= mu and mu <= 1 and -1 <= nu and nu <= 1 and 0 <= x and x <= 1 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  - 1 <= mu /\ mu <= 1 /\ - 1 <= nu /\ nu <= 1 /\ 0 <= x /\ x <= 1.
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_1_range.

Module eq_2_1.
(* gbt-developable/eq-2.1, Sect. 2.1, eq. (2.1)
   printed: for all integers k (k ≥ 3): g_{i,k}(x) = (1 − x) g_{i,k−1}(x) + x g_{i−1,k−1}(x)   (i = 0, 1, ..., k)
   stated: g[i,k](x) == (1 - x)*g[i,k-1](x) + x*g[i-1,k-1](x) *)
Definition statement : Prop :=
forall (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z ->
  (3 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (2 <= k)%Z ->
  (2 <= k - 1)%Z ->
  g x mu nu i k = (1 - x) * g x mu nu i (k - 1)%Z + x * g x mu nu (i - 1)%Z (k - 1)%Z.
Definition instance : Prop :=
exists (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z /\
  (3 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (2 <= k)%Z /\
  (2 <= k - 1)%Z.
End eq_2_1.

Module def_1_zero.
(* gbt-developable/def-1.zero, Sect. 2.1, sentence after (2.1)
   printed: g_{i,k}(x) = 0 for i = −1 or i > k
   read as: The html copy prints i = 1 (lost minus); the pdf copy prints i = –1.
   stated: g[-1,k](x) == 0 and g[k+j,k](x) == 0 *)
Definition statement : Prop :=
forall (j : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (1 <= j)%Z ->
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  g x mu nu (- 1)%Z k = 0 /\ g x mu nu (k + j)%Z k = 0.
Definition instance : Prop :=
exists (j : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (1 <= j)%Z /\
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End def_1_zero.

Module thm_1_1_k2_functions.
(* gbt-developable/thm-1.1.k2.functions, Sect. 2.1, Theorem 1, item 1, at k = 2
   printed: For μ, ν = 1 and sin(π/2 x), 1 − cos(π/2 x) = z, the kth degree GBTB basis functions are just like the traditional kth degree Bernstein basis functions (g_{i,k}(x) = B_{i,k}(x), i = 0, 1, ..., k; k ≥ 2).
   read as: The functions of x are the Bernstein functions of z = sin(π/2 x).
   stated: g[0,2](x) == (1 - sin(pi/2*x))^2 and g[1,2](x) == 2*sin(pi/2*x)*(1 - sin(pi/2*x)) and g[2,2](x) == sin(pi/2*x)^2 *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  mu = 1 ->
  nu = 1 ->
  g x mu nu 0%Z 2%Z = (1 - sin (PI / 2 * x)) ^ 2 /\ g x mu nu 1%Z 2%Z = 2 * sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) /\ g x mu nu 2%Z 2%Z = sin (PI / 2 * x) ^ 2.
End thm_1_1_k2_functions.

Module thm_1_1_k2_substitution.
(* gbt-developable/thm-1.1.k2.substitution, Sect. 2.1, Theorem 1, item 1, at k = 2
   printed: For μ, ν = 1 and sin(π/2 x), 1 − cos(π/2 x) = z, the kth degree GBTB basis functions are just like the traditional kth degree Bernstein basis functions (g_{i,k}(x) = B_{i,k}(x), i = 0, 1, ..., k; k ≥ 2).
   read as: The letter z is written for sin(π/2 x) and for 1 − cos(π/2 x), without asking whether any x makes both equal.
   stated: g[0,2](x) == first(sin(pi/2*x)) and g[2,2](x) == last(cos(pi/2*x)) and first(z) == (1 - z)^2 and last(1 - z) == z^2 and 1 - first(z) - last(1 - z) == 2*z*(1 - z) *)
Definition first (mu : R) (s : R) : R :=
  (1 - s) * (1 - mu * s).
Definition last (nu : R) (c : R) : R :=
  (1 - c) * (1 - nu * c).
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  0 <= z <= 1 ->
  mu = 1 ->
  nu = 1 ->
  g x mu nu 0%Z 2%Z = first mu (sin (PI / 2 * x)) /\ g x mu nu 2%Z 2%Z = last nu (cos (PI / 2 * x)) /\ first mu z = (1 - z) ^ 2 /\ last nu (1 - z) = z ^ 2 /\ 1 - first mu z - last nu (1 - z) = 2 * z * (1 - z).
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  0 <= z <= 1 /\
  mu = 1 /\
  nu = 1.
End thm_1_1_k2_substitution.

Module thm_1_1_k3plus_functions.
(* gbt-developable/thm-1.1.k3plus.functions, Sect. 2.1, Theorem 1, item 1, at k ≥ 3
   printed: (same sentence) ... g_{i,k}(x) = B_{i,k}(x), i = 0, 1, ..., k; k ≥ 2
   read as: The functions of x are the Bernstein functions of z = sin(π/2 x); first and last function are stated.
   stated: g[0,k](x) == (1 - sin(pi/2*x))^k and g[k,k](x) == sin(pi/2*x)^k *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R) (x : R),
  (3 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  mu = 1 ->
  nu = 1 ->
  (2 <= k)%Z ->
  (0 <= k)%Z \/ 1 - sin (PI / 2 * x) <> 0 ->
  (0 <= k)%Z \/ sin (PI / 2 * x) <> 0 ->
  g x mu nu 0%Z k = powerRZ (1 - sin (PI / 2 * x)) k /\ g x mu nu k k = powerRZ (sin (PI / 2 * x)) k.
End thm_1_1_k3plus_functions.

Module thm_1_1_k3plus_substitution.
(* gbt-developable/thm-1.1.k3plus.substitution, Sect. 2.1, Theorem 1, item 1, at k ≥ 3
   printed: (same sentence) ... g_{i,k}(x) = B_{i,k}(x), i = 0, 1, ..., k; k ≥ 2
   read as: The letter z is written for both expressions in the functions of degree 2, and the step (2.1) is left as it is; the first function of degree 3 is stated.
   stated: g[0,3](x) == (1 - x)*seed0(sin(pi/2*x)) and (1 - x)*seed0(z) == (1 - z)^3 *)
Definition seed0 (mu : R) (s : R) : R :=
  (1 - s) * (1 - mu * s).
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  0 <= z <= 1 ->
  mu = 1 ->
  nu = 1 ->
  g x mu nu 0%Z 3%Z = (1 - x) * seed0 mu (sin (PI / 2 * x)) /\ (1 - x) * seed0 mu z = (1 - z) ^ 3.
End thm_1_1_k3plus_substitution.

Module thm_1_1_k3plus_letters.
(* gbt-developable/thm-1.1.k3plus.letters, Sect. 2.1, Theorem 1, item 1, at k ≥ 3
   printed: (same sentence) ... g_{i,k}(x) = B_{i,k}(x), i = 0, 1, ..., k; k ≥ 2
   read as: The letter x is written for both expressions, as g_{i,k}(x) = B_{i,k}(x) has it, without asking whether any x makes both equal to x.
   stated: formal[i,k](x, mu, nu, sin(pi/2*x), cos(pi/2*x)) == g[i,k](x) and formal[i,k](x, mu, nu, x, 1 - x) == b[i,k](x) *)
Definition formal (x : R) (mu : R) (nu : R) (sine : R) (cosine : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sine) * (1 - mu * sine); 1 - (1 - sine) * (1 - mu * sine) - (1 - cosine) * (1 - nu * cosine); (1 - cosine) * (1 - nu * cosine)] i k.
Definition statement : Prop :=
forall (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z ->
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  mu = 1 ->
  nu = 1 ->
  (0 <= k)%Z ->
  formal x mu nu (sin (PI / 2 * x)) (cos (PI / 2 * x)) i k = g x mu nu i k /\ formal x mu nu x (1 - x) i k = b x i k.
Definition instance : Prop :=
exists (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z /\
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  mu = 1 /\
  nu = 1 /\
  (0 <= k)%Z.
End thm_1_1_k3plus_letters.

Module thm_1_1_degeneration.
(* gbt-developable/thm-1.1.degeneration, Sect. 2.1, Theorem 1, item 1
   printed: At k = 2 the functions are the Bernstein functions of sin(π/2 x) for (μ, ν) = (1, −1), and of 1 − cos(π/2 x) for (μ, ν) = (−1, 1).
   stated: f0(1) == (1 - s)^2 and f2(-1) == s^2 and 1 - f0(1) - f2(-1) == 2*s*(1 - s) and f0(-1) == (1 - c)^2 and f2(1) == c^2 and 1 - f0(-1) - f2(1) == 2*c*(1 - c) *)
Definition f0 (nu : R) (x : R) (m : R) : R :=
  (fun mu : R => g x mu nu 0%Z 2%Z) m.
Definition s (x : R) : R :=
  sin (PI / 2 * x).
Definition f2 (mu : R) (x : R) (n : R) : R :=
  (fun nu : R => g x mu nu 2%Z 2%Z) n.
Definition c (x : R) : R :=
  1 - cos (PI / 2 * x).
Definition statement : Prop :=
forall (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  f0 nu x 1 = (1 - s x) ^ 2 /\ f2 mu x (- 1) = s x ^ 2 /\ 1 - f0 nu x 1 - f2 mu x (- 1) = 2 * s x * (1 - s x) /\ f0 nu x (- 1) = (1 - c x) ^ 2 /\ f2 mu x 1 = c x ^ 2 /\ 1 - f0 nu x (- 1) - f2 mu x 1 = 2 * c x * (1 - c x).
Definition instance : Prop :=
exists (mu : R) (nu : R) (x : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End thm_1_1_degeneration.

Module thm_1_1_degeneration_only.
(* gbt-developable/thm-1.1.degeneration-only, Sect. 2.1, Theorem 1, item 1
   printed: At k = 2 the functions are Bernstein functions of some z for no other shape parameters.
   stated: 2*at0 == pi^2*((1 + mu)^2 - 2*(1 - nu)) and 2*at1 == pi^2*((1 + nu)^2 - 2*(1 - mu)) and (1 + mu)^2 - 2*(1 - nu) - ((1 + nu)^2 - 2*(1 - mu)) == (mu - nu)*(mu + nu) and at(middle, nu, mu) == 1 - 2*(1 - sqrt(2)/2)*(2 - sqrt(2)*mu) *)
Definition at0 (mu : R) (nu : R) : R :=
  (fun x : R => Derive_n (fun x => g x mu nu 1%Z 2%Z ^ 2 - 4 * g x mu nu 0%Z 2%Z * g x mu nu 2%Z 2%Z) 2 x) 0.
Definition at1 (mu : R) (nu : R) : R :=
  (fun x : R => Derive_n (fun x => g x mu nu 1%Z 2%Z ^ 2 - 4 * g x mu nu 0%Z 2%Z * g x mu nu 2%Z 2%Z) 2 x) 1.
Definition middle (mu : R) (nu : R) : R :=
  (fun x : R => g x mu nu 1%Z 2%Z ^ 2 - 4 * g x mu nu 0%Z 2%Z * g x mu nu 2%Z 2%Z) (1 / 2).
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  2 * at0 mu nu = PI ^ 2 * ((1 + mu) ^ 2 - 2 * (1 - nu)) /\ 2 * at1 mu nu = PI ^ 2 * ((1 + nu) ^ 2 - 2 * (1 - mu)) /\ (1 + mu) ^ 2 - 2 * (1 - nu) - ((1 + nu) ^ 2 - 2 * (1 - mu)) = (mu - nu) * (mu + nu) /\ (fun nu : R => middle mu nu) mu = 1 - 2 * (1 - sqrt 2 / 2) * (2 - sqrt 2 * mu).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_1_degeneration_only.

Module thm_1_1_no_degeneration.
(* gbt-developable/thm-1.1.no-degeneration, Sect. 2.1, Theorem 1, item 1
   printed: At k ≥ 3 the functions are Bernstein functions of some z for no shape parameters at all.
   stated: k*(k - 1)*(k - 2)*(p - 1)^3 == 0 *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R) (p : R),
  (3 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  IZR k - 2 + PI / 2 * (1 + mu) = IZR k * p ->
  (IZR k - 2) * (IZR k - 3) + (IZR k - 2) * PI * (1 + mu) + PI ^ 2 / 4 * (1 - nu) = IZR k * (IZR k - 1) * p ^ 2 ->
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4) + 3 / 2 * (IZR k - 2) * (IZR k - 3) * PI * (1 + mu) + 3 / 4 * (IZR k - 2) * PI ^ 2 * (1 - nu) = IZR k * (IZR k - 1) * (IZR k - 2) * p ^ 3 ->
  IZR k * (IZR k - 1) * (IZR k - 2) * (p - 1) ^ 3 = 0.
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R) (p : R),
  (3 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  IZR k - 2 + PI / 2 * (1 + mu) = IZR k * p /\
  (IZR k - 2) * (IZR k - 3) + (IZR k - 2) * PI * (1 + mu) + PI ^ 2 / 4 * (1 - nu) = IZR k * (IZR k - 1) * p ^ 2 /\
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4) + 3 / 2 * (IZR k - 2) * (IZR k - 3) * PI * (1 + mu) + 3 / 4 * (IZR k - 2) * PI ^ 2 * (1 - nu) = IZR k * (IZR k - 1) * (IZR k - 2) * p ^ 3.
End thm_1_1_no_degeneration.

Module thm_1_1_jets.
(* gbt-developable/thm-1.1.jets, Sect. 2.1, Theorem 1, item 1
   printed: The derivatives of the functions at x = 0, at k ≥ 3.
   stated: at(D(g[1,k](x), x), x, 0) == k - 2 + pi/2*(1 + mu) and at(D(g[2,k](x), x, 2), x, 0) == (k - 2)*(k - 3) + (k - 2)*pi*(1 + mu) + pi^2/4*(1 - nu) and at(D(g[3,k](x), x, 3), x, 0) == (k - 2)*(k - 3)*(k - 4) + 3/2*(k - 2)*(k - 3)*pi*(1 + mu) + 3/4*(k - 2)*pi^2*(1 - nu) *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R),
  (3 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (2 <= k)%Z ->
  (fun x : R => Derive_n (fun x => g x mu nu 1%Z k) 1 x) 0 = IZR k - 2 + PI / 2 * (1 + mu) /\ (fun x : R => Derive_n (fun x => g x mu nu 2%Z k) 2 x) 0 = (IZR k - 2) * (IZR k - 3) + (IZR k - 2) * PI * (1 + mu) + PI ^ 2 / 4 * (1 - nu) /\ (fun x : R => Derive_n (fun x => g x mu nu 3%Z k) 3 x) 0 = (IZR k - 2) * (IZR k - 3) * (IZR k - 4) + 3 / 2 * (IZR k - 2) * (IZR k - 3) * PI * (1 + mu) + 3 / 4 * (IZR k - 2) * PI ^ 2 * (1 - nu).
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R),
  (3 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (2 <= k)%Z.
End thm_1_1_jets.

Module thm_1_2.
(* gbt-developable/thm-1.2, Sect. 2.1, Theorem 1, item 2
   printed: Non-negativity: g_{i,k}(x) ≥ 0 (i = 0, 1, 2, ..., k) for any value of μ, ν ∈ [−1, 1].
   stated: nonnegative(g) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  forall x : R, 0 <= x <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= g x mu nu i k.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_2.

Module thm_1_3.
(* gbt-developable/thm-1.3, Sect. 2.1, Theorem 1, item 3
   printed: Partition of unity: Σ_{i=0}^{k} g_{i,k}(x) = 1.
   stated: sum(i, 0, k, g[i,k](x)) == 1 *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  sum 0%Z k (fun i => g x mu nu i k) = 1.
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End thm_1_3.

Module thm_1_4.
(* gbt-developable/thm-1.4, Sect. 2.1, Theorem 1, item 4
   printed: Symmetry: For every μ = ν, g_{i,k}(x) (i = 0, 1, 2, ..., k) are symmetric i.e. g_{k−i,k}(x, μ, ν) = g_{i,k}(1 − x, μ, ν).
   stated: g[k-i,k](x, mu, nu) == g[i,k](1 - x, mu, nu) *)
Definition statement : Prop :=
forall (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z ->
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  mu = nu ->
  g x mu nu (k - i)%Z k = g (1 - x) mu nu i k.
Definition instance : Prop :=
exists (i : Z) (k : Z) (mu : R) (nu : R) (x : R),
  (0 <= i <= k)%Z /\
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  mu = nu.
End thm_1_4.

Module thm_1_5.
(* gbt-developable/thm-1.5, Sect. 2.1, Theorem 1, item 5
   printed: Linear independence: For any μ, ν ∈ [−1, 1], the kth order GBTB basis functions are linearly independent.
   stated: independent(g) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  forall (k : Z) (c : Z -> R), (2 <= k)%Z -> (forall x : R, 0 <= x <= 1 -> sum 0 k (fun i => c i * (g x mu nu i k)) = 0) -> forall i : Z, (0 <= i <= k)%Z -> c i = 0.
End thm_1_5.

Module thm_1_5_quadratic.
(* gbt-developable/thm-1.5.quadratic, Sect. 2.1, Theorem 1, item 5
   printed: At k = 2 the functions are dependent for μ = ν = −1 only.
   stated: g[0,2](0) == 1 and g[1,2](0) == 0 and g[2,2](0) == 0 and g[0,2](1) == 0 and g[1,2](1) == 0 and g[2,2](1) == 1 and g[1,2](1/2) == (sqrt(2) - 1)/2*(2 + mu + nu) *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  g 0 mu nu 0%Z 2%Z = 1 /\ g 0 mu nu 1%Z 2%Z = 0 /\ g 0 mu nu 2%Z 2%Z = 0 /\ g 1 mu nu 0%Z 2%Z = 0 /\ g 1 mu nu 1%Z 2%Z = 0 /\ g 1 mu nu 2%Z 2%Z = 1 /\ g (1 / 2) mu nu 1%Z 2%Z = (sqrt 2 - 1) / 2 * (2 + mu + nu).
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_5_quadratic.

Module thm_1_5_cubic.
(* gbt-developable/thm-1.5.cubic, Sect. 2.1, Theorem 1, item 5
   printed: At k = 3 the functions are linearly independent for all shape parameters.
   stated: det([[g[1,3](1/3), g[2,3](1/3)], [g[1,3](2/3), g[2,3](2/3)]]) > 0 *)
Definition statement : Prop :=
forall (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  det [[g (1 / 3) mu nu 1%Z 3%Z; g (1 / 3) mu nu 2%Z 3%Z]; [g (2 / 3) mu nu 1%Z 3%Z; g (2 / 3) mu nu 2%Z 3%Z]] > 0.
Definition instance : Prop :=
exists (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_5_cubic.

Module thm_1_5_all.
(* gbt-developable/thm-1.5.all, Sect. 2.1, Theorem 1, item 5
   printed: At k ≥ 3 the functions are linearly independent for all shape parameters: what the curves are made of.
   stated: G(x) == A + ((1 + mu)*sin(pi/2*x) - mu*sin(pi/2*x)^2)*(B - A) + (1 - (1 + nu)*cos(pi/2*x) + nu*cos(pi/2*x)^2)*(C - B) *)
Definition A (R_ : Z -> R) (k : Z) (x : R) : R :=
  sum 0%Z (k - 2)%Z (fun i => b x i (k - 2)%Z * R_ i).
Definition B (R_ : Z -> R) (k : Z) (x : R) : R :=
  sum 0%Z (k - 2)%Z (fun i => b x i (k - 2)%Z * R_ (i + 1)%Z).
Definition C_ (R_ : Z -> R) (k : Z) (x : R) : R :=
  sum 0%Z (k - 2)%Z (fun i => b x i (k - 2)%Z * R_ (i + 2)%Z).
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= k - 2)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) ->
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 2 <= k)%Z) ->
  G R_ k mu nu x = A R_ k x + ((1 + mu) * sin (PI / 2 * x) - mu * sin (PI / 2 * x) ^ 2) * (B R_ k x - A R_ k x) + (1 - (1 + nu) * cos (PI / 2 * x) + nu * cos (PI / 2 * x) ^ 2) * (C_ R_ k x - B R_ k x).
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R) (x : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= k - 2)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 1 <= k)%Z) /\
  (forall i : Z, (0 <= i <= (k - 2))%Z -> (0 <= i + 2 <= k)%Z).
End thm_1_5_all.

Module thm_1_6_a.
(* gbt-developable/thm-1.6.a, Sect. 2.1, Theorem 1, item 6
   printed: g_{0,k}(0) = 1   (k ≥ 2)
   stated: g[0,k](0) == 1 *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  g 0 mu nu 0%Z k = 1.
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_6_a.

Module thm_1_6_b.
(* gbt-developable/thm-1.6.b, Sect. 2.1, Theorem 1, item 6
   printed: g_{k,k}(1) = 1   (k ≥ 2)
   stated: g[k,k](1) == 1 *)
Definition statement : Prop :=
forall (k : Z) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  g 1 mu nu k k = 1.
Definition instance : Prop :=
exists (k : Z) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_6_b.

Module thm_1_6_c.
(* gbt-developable/thm-1.6.c, Sect. 2.1, Theorem 1, item 6
   printed: g_{i,k}(0) = 0 (i = 1, 2, ..., k)
   stated: g[i,k](0) == 0 *)
Definition statement : Prop :=
forall (i : Z) (k : Z) (mu : R) (nu : R),
  (1 <= i <= k)%Z ->
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  g 0 mu nu i k = 0.
Definition instance : Prop :=
exists (i : Z) (k : Z) (mu : R) (nu : R),
  (1 <= i <= k)%Z /\
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End thm_1_6_c.

Module thm_1_6_d.
(* gbt-developable/thm-1.6.d, Sect. 2.1, Theorem 1, item 6
   printed: g_{i,k}(1) = 0 (i = 0, 1, ..., k − 1)
   stated: G(1) - g[k,k](1)*R[k] == 0 *)
Definition statement : Prop :=
forall (k : Z) (R_ : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  G R_ k mu nu 1 - g 1 mu nu k k * R_ k = 0.
Definition instance : Prop :=
exists (k : Z) (R_ : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z.
End thm_1_6_d.
