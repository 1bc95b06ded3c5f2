(* Statements of gbt-surfaces, Part Abstract. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition b2_true (m : Z) (mu : R) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) + 6 * (IZR m - 2) * PI ^ 2 * (1 - mu).
Definition b5_true (m : Z) (mu : R) (nu : R) : R :=
  6 * (IZR m - 2) * PI ^ 2 * (mu + 2 * nu - 1).
End Definitions.
Import Definitions.

Module abs_basis_a.
(* gbt-surfaces/abs.basis.a, Abstract, second sentence
   printed: GBTB basis functions with two shape parameters are derived in explicit expression which satisfied the basic geometric features of the traditional Bernstein basis functions
   read as: The features of Theorem 1 but the degeneracy, which is a claim of its own: nonnegativity, partition of unity, symmetry for equal shape parameters; and the values at the ends.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z)) == 1 and f[m-k,m](z, mu, mu) == f[k,m](1 - z, mu, mu) and f[0,m](0) == 1 and f[m,m](1) == 1 *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall i k_ : Z, (2 <= k_)%Z -> 0 <= f z mu nu i k_) /\ sum 0%Z m (fun k__ => f z mu nu k__ m) = 1 /\ f z mu mu (m - k)%Z m = f (1 - z) mu mu k m /\ f 0 mu nu 0%Z m = 1 /\ f 1 mu nu m m = 1.
Definition instance : Prop :=
exists (k : Z) (m : Z) (mu : R) (nu : R) (z : R),
  (0 <= k <= m)%Z /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End abs_basis_a.

Module abs_basis_b_name.
(* gbt-surfaces/abs.basis.b.name, Abstract, second sentence
   printed: GBTB basis functions with two shape parameters
   read as: Basis functions are what the field calls the functions with which points are weighted: they sum to one. Two shape parameters, of any values, are in them.
   stated: sum(k, 0, m, f[k,m](z)) == 1 *)
Definition statement : Prop :=
forall (m : Z) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  sum 0%Z m (fun k => f z mu nu k m) = 1.
Definition instance : Prop :=
exists (m : Z) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End abs_basis_b_name.

Module abs_basis_b_basis.
(* gbt-surfaces/abs.basis.b.basis, Abstract, second sentence
   printed: GBTB basis functions with two shape parameters
   read as: A basis is linearly independent; the shape parameters are all of the range -1 to 1.
   stated: independent(f) *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  forall (k : Z) (c : Z -> R), (2 <= k)%Z -> (forall z : R, 0 <= z <= 1 -> sum 0 k (fun i => c i * (f z mu nu i k)) = 0) -> forall i : Z, (0 <= i <= k)%Z -> c i = 0.
End abs_basis_b_basis.

Module abs_basis_order_2.
(* gbt-surfaces/abs.basis.order-2, Abstract, second sentence
   printed: The functions of order 2 are independent for μ > -1, and by symmetry for ν > -1.
   stated: c0 == 0 and c1 == 0 and c2 == 0 *)
Definition K (c0 : R) (c1 : R) (c2 : R) (mu : R) (nu : R) (z : Z) : R :=
  f (IZR z) mu nu 0%Z 2%Z * c0 + f (IZR z) mu nu 1%Z 2%Z * c1 + f (IZR z) mu nu 2%Z 2%Z * c2.
Definition K_ (c0 : R) (c1 : R) (c2 : R) (mu : R) (nu : R) (z : R) : R :=
  f z mu nu 0%Z 2%Z * c0 + f z mu nu 1%Z 2%Z * c1 + f z mu nu 2%Z 2%Z * c2.
Definition statement : Prop :=
forall (c0 : R) (c1 : R) (c2 : R) (mu : R) (nu : R),
  (-1) < mu <= 1 ->
  (-1) <= nu <= 1 ->
  K c0 c1 c2 mu nu 0%Z = 0 ->
  (let z := 0%Z in Derive_n (fun z_ => K_ c0 c1 c2 mu nu z_) 1 (IZR z)) = 0 ->
  K c0 c1 c2 mu nu 1%Z = 0 ->
  c0 = 0 /\ c1 = 0 /\ c2 = 0.
Definition instance : Prop :=
exists (c0 : R) (c1 : R) (c2 : R) (mu : R) (nu : R),
  (-1) < mu <= 1 /\
  (-1) <= nu <= 1 /\
  K c0 c1 c2 mu nu 0%Z = 0 /\
  (let z := 0%Z in Derive_n (fun z_ => K_ c0 c1 c2 mu nu z_) 1 (IZR z)) = 0 /\
  K c0 c1 c2 mu nu 1%Z = 0.
End abs_basis_order_2.

Module abs_basis_cubic.
(* gbt-surfaces/abs.basis.cubic, Abstract, second sentence
   printed: The functions of order 3 are independent for all shape parameters.
   stated: c0 == 0 and c1 == 0 and c2 == 0 and c3 == 0 *)
Definition K (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu : R) (nu : R) (z : Z) : R :=
  f (IZR z) mu nu 0%Z 3%Z * c0 + f (IZR z) mu nu 1%Z 3%Z * c1 + f (IZR z) mu nu 2%Z 3%Z * c2 + f (IZR z) mu nu 3%Z 3%Z * c3.
Definition K_ (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu : R) (nu : R) (z : R) : R :=
  f z mu nu 0%Z 3%Z * c0 + f z mu nu 1%Z 3%Z * c1 + f z mu nu 2%Z 3%Z * c2 + f z mu nu 3%Z 3%Z * c3.
Definition statement : Prop :=
forall (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu : R) (nu : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  K c0 c1 c2 c3 mu nu 0%Z = 0 ->
  (let z := 0%Z in Derive_n (fun z_ => K_ c0 c1 c2 c3 mu nu z_) 1 (IZR z)) = 0 ->
  (let z_ := 1%Z in Derive_n (fun z__ => K_ c0 c1 c2 c3 mu nu z__) 1 (IZR z_)) = 0 ->
  K c0 c1 c2 c3 mu nu 1%Z = 0 ->
  c0 = 0 /\ c1 = 0 /\ c2 = 0 /\ c3 = 0.
Definition instance : Prop :=
exists (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu : R) (nu : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  K c0 c1 c2 c3 mu nu 0%Z = 0 /\
  (let z := 0%Z in Derive_n (fun z_ => K_ c0 c1 c2 c3 mu nu z_) 1 (IZR z)) = 0 /\
  (let z_ := 1%Z in Derive_n (fun z__ => K_ c0 c1 c2 c3 mu nu z__) 1 (IZR z_)) = 0 /\
  K c0 c1 c2 c3 mu nu 1%Z = 0.
End abs_basis_cubic.

Module abs_basis_all.
(* gbt-surfaces/abs.basis.all, Abstract, second sentence
   printed: What a curve of order m ≥ 3 is made of: three polynomials, a function of the sine and one of the cosine.
   stated: F(z) == A + ((1 + mu)*sin(pi/2*z) - mu*sin(pi/2*z)^2)*(B - A) + (1 - (1 + nu)*cos(pi/2*z) + nu*cos(pi/2*z)^2)*(C - B) *)
Definition F (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
Definition e (z : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [1] i k.
Definition A (Q : Z -> R) (m : Z) (z : R) : R :=
  sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * Q k).
Definition B (Q : Z -> R) (m : Z) (z : R) : R :=
  sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * Q (k + 1)%Z).
Definition C_ (Q : Z -> R) (m : Z) (z : R) : R :=
  sum 0%Z (m - 2)%Z (fun k => e z k (m - 2)%Z * Q (k + 2)%Z).
Definition statement : Prop :=
forall (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 1 <= m)%Z) ->
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 2 <= m)%Z) ->
  F Q m mu nu z = A Q m z + ((1 + mu) * sin (PI / 2 * z) - mu * sin (PI / 2 * z) ^ 2) * (B Q m z - A Q m z) + (1 - (1 + nu) * cos (PI / 2 * z) + nu * cos (PI / 2 * z) ^ 2) * (C_ Q m z - B Q m z).
Definition instance : Prop :=
exists (m : Z) (Q : Z -> R) (mu : R) (nu : R) (z : R),
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= m - 2)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 1 <= m)%Z) /\
  (forall k : Z, (0 <= k <= (m - 2))%Z -> (0 <= k + 2 <= m)%Z).
End abs_basis_all.

Module abs_continuity_a.
(* gbt-surfaces/abs.continuity.a, Abstract
   printed: two adjacent GBT-Bézier surfaces segments are connected by higher C2 and C3 continuity constraints
   read as: A line of parameter z of a surface is a curve, whose control points are combinations of those of the net; such a line of the second patch continues that of the first with three derivatives. Exhibited for every first patch, with a cubic of vanishing shape parameters for the second.
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
Definition c1 (n : Z) (mu1 : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + IZR mu1)).
Definition b3_true (n : Z) (nu1 : Z) (mu1 : Z) : R :=
  3 * c1 n mu1 + 12 * (IZR n - 2) * PI ^ 2 * (1 + IZR mu1 - IZR nu1).
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
Definition F_ (Q : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Q k).
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
End abs_continuity_a.

Module abs_continuity_rows.
(* gbt-surfaces/abs.continuity.rows, Abstract
   printed: The derivatives of two patches at their joint are those of Theorem 2 with the lines of the nets for the control points, so two patches join with C1, C2 or C3 if and only if every column of their nets does.
   stated: second(0) == s(0) and first(1) == r(m) and 2*second'(0) == (2*(n - 2) + pi*(1 + mu1))*(s(1) - s(0)) and 2*first'(1) == (2*(m - 2) + pi*(1 + nu))*(r(m) - r(m - 1)) and 4*second''(0) == a1*(s(2) - s(0)) - (2*a1 - pi^2*(1 - 2*mu1 - nu1))*(s(1) - s(0)) and 4*first''(1) == a2*(r(m) - 2*r(m - 1) + r(m - 2)) - pi^2*(1 - mu)*(r(m - 1) - r(m - 2)) + 2*pi^2*nu*(r(m) - r(m - 1)) and 8*second'''(0) == b1*(s(3) - s(0)) - b3_true*(s(2) - s(0)) + (3*c1 + 6*(n - 2)*pi^2*(1 + 4*mu1 - nu1) - pi^3*(1 + mu1))*(s(1) - s(0)) and 8*first'''(1) == b2_true*(r(m) - 3*r(m - 1) + 3*r(m - 2) - r(m - 3)) + b5_true*(r(m) - 2*r(m - 1) + r(m - 2)) - pi^3*(1 + nu)*(r(m) - r(m - 1)) *)
Definition second (H : Z -> Z -> R) (N_ : Z) (mu1 : R) (mu2 : R) (n : Z) (nu1 : R) (nu2 : R) (z1 : R) (z : Z) : R :=
  sum 0%Z n (fun k => f (IZR z) mu1 nu1 k n * sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * H k l)).
Definition s (H : Z -> Z -> R) (N_ : Z) (mu2 : R) (nu2 : R) (z1 : R) (k : Z) : R :=
  sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * H k l).
Definition first (G : Z -> Z -> R) (N_ : Z) (m : Z) (mu : R) (mu2 : R) (nu : R) (nu2 : R) (z1 : R) (z : Z) : R :=
  sum 0%Z m (fun k => f (IZR z) mu nu k m * sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * G k l)).
Definition r (G : Z -> Z -> R) (N_ : Z) (mu2 : R) (nu2 : R) (z1 : R) (k : Z) : R :=
  sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * G k l).
Definition second_ (H : Z -> Z -> R) (N_ : Z) (mu1 : R) (mu2 : R) (n : Z) (nu1 : R) (nu2 : R) (z1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * H k l)).
Definition first_ (G : Z -> Z -> R) (N_ : Z) (m : Z) (mu : R) (mu2 : R) (nu : R) (nu2 : R) (z1 : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * sum 0%Z N_ (fun l => f z1 mu2 nu2 l N_ * G k l)).
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition b1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) + 6 * (IZR n - 2) * PI ^ 2 * (1 - nu1).
Definition c1 (mu1 : R) (n : Z) : R :=
  4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)).
Definition b3_true (mu1 : R) (n : Z) (nu1 : R) : R :=
  3 * c1 mu1 n + 12 * (IZR n - 2) * PI ^ 2 * (1 + mu1 - nu1).
Definition statement : Prop :=
forall (N_ : Z) (m : Z) (n : Z) (G : Z -> Z -> R) (H : Z -> Z -> R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R) (z1 : R),
  (2 <= N_)%Z ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= n)%Z -> forall l : Z, (0 <= l <= N_)%Z -> (0 <= k <= n)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 0 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= N_)%Z -> (0 <= k <= m)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= m <= m)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 1 <= n)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 1)%Z <= m)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 2 <= n)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 2)%Z <= m)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 3 <= n)%Z) ->
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 3)%Z <= m)%Z) ->
  second H N_ mu1 mu2 n nu1 nu2 z1 0%Z = s H N_ mu2 nu2 z1 0%Z /\ first G N_ m mu mu2 nu nu2 z1 1%Z = r G N_ mu2 nu2 z1 m /\ 2 * (let z := 0%Z in Derive_n (fun z_ => second_ H N_ mu1 mu2 n nu1 nu2 z1 z_) 1 (IZR z)) = (2 * (IZR n - 2) + PI * (1 + mu1)) * (s H N_ mu2 nu2 z1 1%Z - s H N_ mu2 nu2 z1 0%Z) /\ 2 * (let z_ := 1%Z in Derive_n (fun z__ => first_ G N_ m mu mu2 nu nu2 z1 z__) 1 (IZR z_)) = (2 * (IZR m - 2) + PI * (1 + nu)) * (r G N_ mu2 nu2 z1 m - r G N_ mu2 nu2 z1 (m - 1)%Z) /\ 4 * (let z__ := 0%Z in Derive_n (fun z___ => second_ H N_ mu1 mu2 n nu1 nu2 z1 z___) 2 (IZR z__)) = a1 mu1 n nu1 * (s H N_ mu2 nu2 z1 2%Z - s H N_ mu2 nu2 z1 0%Z) - (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) * (s H N_ mu2 nu2 z1 1%Z - s H N_ mu2 nu2 z1 0%Z) /\ 4 * (let z___ := 1%Z in Derive_n (fun z____ => first_ G N_ m mu mu2 nu nu2 z1 z____) 2 (IZR z___)) = a2 m nu * (r G N_ mu2 nu2 z1 m - 2 * r G N_ mu2 nu2 z1 (m - 1)%Z + r G N_ mu2 nu2 z1 (m - 2)%Z) - PI ^ 2 * (1 - mu) * (r G N_ mu2 nu2 z1 (m - 1)%Z - r G N_ mu2 nu2 z1 (m - 2)%Z) + 2 * PI ^ 2 * nu * (r G N_ mu2 nu2 z1 m - r G N_ mu2 nu2 z1 (m - 1)%Z) /\ 8 * (let z____ := 0%Z in Derive_n (fun z_____ => second_ H N_ mu1 mu2 n nu1 nu2 z1 z_____) 3 (IZR z____)) = b1 mu1 n nu1 * (s H N_ mu2 nu2 z1 3%Z - s H N_ mu2 nu2 z1 0%Z) - b3_true mu1 n nu1 * (s H N_ mu2 nu2 z1 2%Z - s H N_ mu2 nu2 z1 0%Z) + (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) * (s H N_ mu2 nu2 z1 1%Z - s H N_ mu2 nu2 z1 0%Z) /\ 8 * (let z_____ := 1%Z in Derive_n (fun z______ => first_ G N_ m mu mu2 nu nu2 z1 z______) 3 (IZR z_____)) = b2_true m mu nu * (r G N_ mu2 nu2 z1 m - 3 * r G N_ mu2 nu2 z1 (m - 1)%Z + 3 * r G N_ mu2 nu2 z1 (m - 2)%Z - r G N_ mu2 nu2 z1 (m - 3)%Z) + b5_true m mu nu * (r G N_ mu2 nu2 z1 m - 2 * r G N_ mu2 nu2 z1 (m - 1)%Z + r G N_ mu2 nu2 z1 (m - 2)%Z) - PI ^ 3 * (1 + nu) * (r G N_ mu2 nu2 z1 m - r G N_ mu2 nu2 z1 (m - 1)%Z).
Definition instance : Prop :=
exists (N_ : Z) (m : Z) (n : Z) (G : Z -> Z -> R) (H : Z -> Z -> R) (mu : R) (mu1 : R) (mu2 : R) (nu : R) (nu1 : R) (nu2 : R) (z1 : R),
  (2 <= N_)%Z /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  0 <= z1 <= 1 /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= n)%Z -> forall l : Z, (0 <= l <= N_)%Z -> (0 <= k <= n)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 0 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> forall l : Z, (0 <= l <= N_)%Z -> (0 <= k <= m)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= m <= m)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 1 <= n)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 1)%Z <= m)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 2 <= n)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 2)%Z <= m)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= 3 <= n)%Z) /\
  (forall l : Z, (0 <= l <= N_)%Z -> (0 <= (m - 3)%Z <= m)%Z).
End abs_continuity_rows.
