(* Statements of gbt-surfaces, Section 3 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition FX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * Z_ k).
Definition FU (U : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * U l).
Definition FV (V : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) : R :=
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * V l).
Definition swung (lambda : R) (x : R) (w : R) (u : R) (v : R) : list R :=
  [lambda * x * u; lambda * x * v; w].
Definition turn (theta : R) : list (list R) :=
  [[cos theta; - sin theta; 0]; [sin theta; cos theta; 0]; [0; 0; 1]].
Definition net (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (k : Z) (l : Z) : list R :=
  [lambda * X k * U l; lambda * X k * V l; Z_ k].
Definition FX2 (X2 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * X2 k).
Definition FZ2 (Z2 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Z2 k).
Definition along_profiles (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (u : R) (v : R) (r : Z) : list R :=
  vsub ((fun z : R => vDerive 3 (fun z => swung lambda (FX2 X2 mu1 n nu1 z) (FZ2 Z2 mu1 n nu1 z) u v) (Z.to_nat r) z) 0) ((fun z : R => vDerive 3 (fun z => swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) u v) (Z.to_nat r) z) 1).
Definition a (m : Z) (mu1 : R) (n : Z) (nu : R) : R :=
  (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)).
End Definitions.
Import Definitions.

Module eq_20_profile.
(* gbt-surfaces/eq-20.profile, Sect. 3.4, eq. (20), first line
   printed: F_m(z,μ,ν) = sum_{k=0}^{m} f_{k,m}(z) Q_{k,0}, 0 ≤ z ≤ 1, Q_{k,0} = (Q^X_{k,0}, 0, Q^Z_{k,0})
   read as: The formula, whose curve lies in the plane XOZ.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]) == [FX(z), 0, FZ(z)] and dot(sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]), [0, 1, 0]) == 0 *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k]) = [FX X m mu nu z; 0; FZ Z_ m mu nu z] /\ dot (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k])) [0; 1; 0] = 0.
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_20_profile.

Module eq_20_trajectory.
(* gbt-surfaces/eq-20.trajectory, Sect. 3.4, eq. (20), second line, and the line after it
   printed: F_n(z_1,μ_1,ν_1) = sum_{l=0}^{n} f_{l,n}(z_1) Q_{1,l}, 0 ≤ z_1 ≤ 1, where Q_{l,1} = (Q^X_{l,1}, Q^Y_{l,1}, 0)
   read as: The curve of the control points Q_{l,1} of the line below (20) and of (24), against the printed sum over Q_{1,l}.
   stated: sum(l, 0, n, f[l,n](z1, mu1, nu1)*P[l,1]) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*P[1,l]) *)
Definition statement : Prop :=
forall (n : Z) (P : Z -> Z -> R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 1 <= n)%Z) ->
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * P l 1%Z) = sum 0%Z n (fun l => f z1 mu1 nu1 l n * P 1%Z l).
End eq_20_trajectory.

Module eq_20_trajectory_corrected.
(* gbt-surfaces/eq-20.trajectory (corrected), Sect. 3.4, eq. (20), second line, and the line after it
   printed: F_n(z_1,μ_1,ν_1) = sum_{l=0}^{n} f_{l,n}(z_1) Q_{1,l}, 0 ≤ z_1 ≤ 1, where Q_{l,1} = (Q^X_{l,1}, Q^Y_{l,1}, 0)
   read as: The curve of the control points Q_{l,1} of the line below (20) and of (24), against the printed sum over Q_{1,l}.
   stated: sum(l, 0, n, f[l,n](z1, mu1, nu1)*P[l,1]) == sum(l, 0, n, f[l,n](z1, mu1, nu1)*P[l,1]) *)
Definition statement : Prop :=
forall (n : Z) (P : Z -> Z -> R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 1 <= n)%Z) ->
  sum 0%Z n (fun l => f z1 mu1 nu1 l n * P l 1%Z) = sum 0%Z n (fun l => f z1 mu1 nu1 l n * P l 1%Z).
Definition instance : Prop :=
exists (n : Z) (P : Z -> Z -> R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  0 <= z1 <= 1 /\
  (forall l : Z, (0 <= l <= n)%Z -> (0 <= 1 <= n)%Z).
End eq_20_trajectory_corrected.

Module eq_21.
(* gbt-surfaces/eq-21, Sect. 3.4, eq. (21)
   printed: F_m(z,μ,ν) = {F^X_m(z), 0, F^Z_m(z)}, F_n(z_1,μ_1,ν_1) = {F^X_n(z_1), F^Y_n(z_1), 0}
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]) == [FX(z), 0, FZ(z)] and sum(l, 0, n, f[l,n](z1, mu1, nu1)*[U[l], V[l], 0]) == [FU(z1), FV(z1), 0] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k]) = [FX X m mu nu z; 0; FZ Z_ m mu nu z] /\ vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) [U l; V l; 0]) = [FU U mu1 n nu1 z1; FV V mu1 n nu1 z1; 0].
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_21.

Module eq_22.
(* gbt-surfaces/eq-22, Sect. 3.4, eq. (22)
   printed: T_swung(z,z_1) = (λ F^X_m(z) F^X_n(z_1), λ F^X_m(z) F^Y_n(z_1), F^Z_m(z)), λ (λ > 0) an arbitrary scaling factor
   read as: The formula, with the coordinates of the curves (20) in the vectors (21).
   stated: [lambda*profile[1]*trajectory[1], lambda*profile[1]*trajectory[2], profile[3]] == swung(FX(z), FZ(z), FU(z1), FV(z1)) *)
Definition profile (X : Z -> R) (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : list R :=
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k]).
Definition trajectory (U : Z -> R) (V : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z1 : R) : list R :=
  vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) [U l; V l; 0]).
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  [lambda * entry (profile X Z_ m mu nu z) 1 * entry (trajectory U V mu1 n nu1 z1) 1; lambda * entry (profile X Z_ m mu nu z) 1 * entry (trajectory U V mu1 n nu1 z1) 2; entry (profile X Z_ m mu nu z) 3] = swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) (FU U mu1 n nu1 z1) (FV V mu1 n nu1 z1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_22.

Module prop_3_5.
(* gbt-surfaces/prop-3.5, Sect. 3.4, Proposition 3.5
   printed: if the profile curve F_m(z) is swung about z-axis and re-scale in the X and Y directions, the swung surface T_swung(z,z_1) is achieved in Fig. 13 with different values of scaling factor λ
   read as: A point (x, 0, w) of the profile, scaled by lambda r in X and Y and turned by theta about the Z axis, where (r, theta) are the polar coordinates of the point of the trajectory.
   stated: swung(x, w, r*cos(theta), r*sin(theta)) == turn*[lambda*r*x, 0, w] *)
Definition statement : Prop :=
forall (lambda : R) (r : R) (theta : R) (w : R) (x : R),
  0 < lambda ->
  0 <= r ->
  swung lambda x w (r * cos theta) (r * sin theta) = mvec (turn theta) [lambda * r * x; 0; w].
Definition instance : Prop :=
exists (lambda : R) (r : R) (theta : R) (w : R) (x : R),
  0 < lambda /\
  0 <= r.
End prop_3_5.

Module prop_3_6_1.
(* gbt-surfaces/prop-3.6.1, Sect. 3.4, Proposition 3.6, item 1
   printed: If the z line is fixed, the curves T_swung(z,z_1) which have identical trajectory curve F_n(z_1) but are scaled as λF^X_m(z) in X and Y directions are produced.
   stated: swung(x, w, u, v) == lambda*x*[u, v, 0] + [0, 0, w] *)
Definition statement : Prop :=
forall (lambda : R) (u : R) (v : R) (w : R) (x : R),
  0 < lambda ->
  swung lambda x w u v = vadd (vscale (lambda * x) [u; v; 0]) [0; 0; w].
Definition instance : Prop :=
exists (lambda : R) (u : R) (v : R) (w : R) (x : R),
  0 < lambda.
End prop_3_6_1.

Module prop_3_6_2.
(* gbt-surfaces/prop-3.6.2, Sect. 3.4, Proposition 3.6, item 2
   printed: The fixed z_1 line produces curves Z_swung(z,z_1) with the same profile curve F_m(z), and ... the resulting curves T_swung(z,z_1) are achieved by rotating the PCs F_m(z) into the plane with the vector (F^X_n(z_1), F^Y_n(z_1), 0), and use the scale factor λ|F_n(z_1)| to scale the rotated curve along X and Y coordinates while Z coordinate stays unscaled.
   read as: 'Zswung' is read as T_swung. The point of the trajectory is r (cos theta, sin theta), so |F_n| = r.
   stated: dot([r*cos(theta), r*sin(theta)], [r*cos(theta), r*sin(theta)]) == r^2 and swung(x, w, r*cos(theta), r*sin(theta)) == turn*[lambda*r*x, 0, w] *)
Definition statement : Prop :=
forall (lambda : R) (r : R) (theta : R) (w : R) (x : R),
  0 < lambda ->
  0 <= r ->
  dot [r * cos theta; r * sin theta] [r * cos theta; r * sin theta] = r ^ 2 /\ swung lambda x w (r * cos theta) (r * sin theta) = mvec (turn theta) [lambda * r * x; 0; w].
Definition instance : Prop :=
exists (lambda : R) (r : R) (theta : R) (w : R) (x : R),
  0 < lambda /\
  0 <= r.
End prop_3_6_2.

Module eq_23.
(* gbt-surfaces/eq-23, Sect. 3.4, Theorem 4, eq. (23)
   printed: T_swung(z,z_1,μ,ν,μ_1,ν_1) = sum_{k=0}^{m} sum_{l=0}^{n} Q_{k,l} f_{k,m}(z) f_{l,n}(z_1), Q_{k,l} = (λQ^X_{k,0}Q^X_{l,1}, λQ^X_{k,0}Q^Y_{l,1}, Q^Z_{k,0}), k = 0, 1, ..., m; l = 0, 1, ..., n
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*net(k, l))) == swung(FX(z), FZ(z), FU(z1), FV(z1)) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  vsum 3 0%Z m (fun k => vsum 3 0%Z n (fun l => vscale (f z mu nu k m * f z1 mu1 nu1 l n) (net U V X Z_ lambda k l))) = swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) (FU U mu1 n nu1 z1) (FV V mu1 n nu1 z1).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_23.

Module thm_4_elements.
(* gbt-surfaces/thm-4.elements, Sect. 3.4, Theorem 4, line after eq. (23); repeated in Algorithm 4, step 3
   printed: Q^X_{k,0}, Q^Z_{k,0} and Q^X_{l,1}, Q^Y_{k,1} are elements of the control points Q_{k,0} and Q_{l,1}
   read as: The net of (23), with which it is the swung surface, against the net with the printed index, whose second coordinate is λ Q^X_{k,0} Q^Y_{k,1}.
   stated: net(k, l) == [lambda*X[k]*U[l], lambda*X[k]*V[k], Z[k]] *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R),
  (0 <= k <= m)%Z ->
  (0 <= l <= n)%Z ->
  0 < lambda ->
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  net U V X Z_ lambda k l = [lambda * X k * U l; lambda * X k * V k; Z_ k].
End thm_4_elements.

Module thm_4_elements_corrected.
(* gbt-surfaces/thm-4.elements (corrected), Sect. 3.4, Theorem 4, line after eq. (23); repeated in Algorithm 4, step 3
   printed: Q^X_{k,0}, Q^Z_{k,0} and Q^X_{l,1}, Q^Y_{k,1} are elements of the control points Q_{k,0} and Q_{l,1}
   read as: The net of (23), with which it is the swung surface, against the net with the printed index, whose second coordinate is λ Q^X_{k,0} Q^Y_{k,1}.
   stated: net(k, l) == [lambda*X[k]*U[l], lambda*X[k]*V[l], Z[k]] *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R),
  (0 <= k <= m)%Z ->
  (0 <= l <= n)%Z ->
  0 < lambda ->
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  net U V X Z_ lambda k l = [lambda * X k * U l; lambda * X k * V l; Z_ k].
Definition instance : Prop :=
exists (k : Z) (l : Z) (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R),
  (0 <= k <= m)%Z /\
  (0 <= l <= n)%Z /\
  0 < lambda /\
  (2 <= m)%Z /\
  (2 <= n)%Z.
End thm_4_elements_corrected.

Module thm_4_parameters.
(* gbt-surfaces/thm-4.parameters, Sect. 3.4, Theorem 4, last sentence
   printed: The shapes of profile and trajectory curve are controlled by the shape parameters μ, ν and μ_1, ν_1, respectively.
   stated: fails(D(FX'(0), mu) == 0) and fails(D(FX'(1), nu) == 0) and D(FX(z), mu1) == 0 and D(FX(z), nu1) == 0 and D(FZ(z), mu1) == 0 and D(FZ(z), nu1) == 0 and fails(D(FU'(0), mu1) == 0) and fails(D(FU'(1), nu1) == 0) and D(FU(z1), mu) == 0 and D(FU(z1), nu) == 0 and D(FV(z1), mu) == 0 and D(FV(z1), nu) == 0 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => Derive_n (fun z => FX X m mu nu z) 1 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => Derive_n (fun z => FX X m mu nu z) 1 1) 1 nu = 0) /\ Derive_n (fun mu1 => FX X m mu nu z) 1 mu1 = 0 /\ Derive_n (fun nu1 => FX X m mu nu z) 1 nu1 = 0 /\ Derive_n (fun mu1 => FZ Z_ m mu nu z) 1 mu1 = 0 /\ Derive_n (fun nu1 => FZ Z_ m mu nu z) 1 nu1 = 0 /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  Derive_n (fun mu1 => Derive_n (fun z1 => FU U mu1 n nu1 z1) 1 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  Derive_n (fun nu1 => Derive_n (fun z1 => FU U mu1 n nu1 z1) 1 1) 1 nu1 = 0) /\ Derive_n (fun mu => FU U mu1 n nu1 z1) 1 mu = 0 /\ Derive_n (fun nu => FU U mu1 n nu1 z1) 1 nu = 0 /\ Derive_n (fun mu => FV V mu1 n nu1 z1) 1 mu = 0 /\ Derive_n (fun nu => FV V mu1 n nu1 z1) 1 nu = 0.
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End thm_4_parameters.

Module eq_24.
(* gbt-surfaces/eq-24, Sect. 3.4, proof of Theorem 4, eq. (24)
   printed: F^X_m(z) = sum_{k=0}^{m} Q^X_{k,0} f_{k,m}(z), F^Z_m(z) = sum_{k=0}^{m} Q^Z_{k,0} f_{k,m}(z), F^X_n(z_1) = sum_{l=0}^{n} Q^X_{l,1} f_{l,n}(z_1), F^Y_n(z_1) = sum_{l=0}^{n} Q^Y_{l,1} f_{l,n}(z_1)
   stated: [FX(z), 0, FZ(z)] == sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]) and [FU(z1), FV(z1), 0] == sum(l, 0, n, f[l,n](z1, mu1, nu1)*[U[l], V[l], 0]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  [FX X m mu nu z; 0; FZ Z_ m mu nu z] = vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k]) /\ [FU U mu1 n nu1 z1; FV V mu1 n nu1 z1; 0] = vsum 3 0%Z n (fun l => vscale (f z1 mu1 nu1 l n) [U l; V l; 0]).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_24.

Module thm_4_unity.
(* gbt-surfaces/thm-4.unity, Sect. 3.4, proof of Theorem 4, sentence before eq. (25)
   printed: using the partition of unity property sum_{k=0}^{m} f_{k,m}(z) = 1
   stated: sum(k, 0, m, f[k,m](z, mu, nu)) == 1 *)
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
End thm_4_unity.

Module eq_25_1.
(* gbt-surfaces/eq-25.1, Sect. 3.4, proof of Theorem 4, eq. (25), first line
   printed: T_swung(z,z_1) = (λF^X_m(z)F^X_n(z_1), λF^X_m(z)F^Y_n(z_1), F^Z_m(z))
   read as: (22), which is linear in the profile, for the profile (20).
   stated: [[lambda*FU(z1), 0, 0], [lambda*FV(z1), 0, 0], [0, 0, 1]]*sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]) == [lambda*FX(z)*FU(z1), lambda*FX(z)*FV(z1), FZ(z)] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  mvec [[lambda * FU U mu1 n nu1 z1; 0; 0]; [lambda * FV V mu1 n nu1 z1; 0; 0]; [0; 0; 1]] (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k])) = [lambda * FX X m mu nu z * FU U mu1 n nu1 z1; lambda * FX X m mu nu z * FV V mu1 n nu1 z1; FZ Z_ m mu nu z].
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_25_1.

Module eq_25_2_a.
(* gbt-surfaces/eq-25.2.a, Sect. 3.4, proof of Theorem 4, eq. (25), second line
   printed: λ sum_{k=0}^{m} Q^X_{k,0} f_{k,m}(z) sum_{l=0}^{n} Q^X_{l,0} f_{l,n}(z_1)
   read as: The first coordinate, for any value x of F^X_m(z). By (24) F^X_n is the sum over Q^X_{l,1}.
   stated: lambda*x*sum(l, 0, n, U[l]*f[l,n](z1, mu1, nu1)) == lambda*x*sum(l, 0, n, f[l,n](z1, mu1, nu1)*X[l]) *)
Definition statement : Prop :=
forall (n : Z) (U : Z -> R) (X : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  lambda * x * sum 0%Z n (fun l => U l * f z1 mu1 nu1 l n) = lambda * x * sum 0%Z n (fun l => f z1 mu1 nu1 l n * X l).
End eq_25_2_a.

Module eq_25_2_a_corrected.
(* gbt-surfaces/eq-25.2.a (corrected), Sect. 3.4, proof of Theorem 4, eq. (25), second line
   printed: λ sum_{k=0}^{m} Q^X_{k,0} f_{k,m}(z) sum_{l=0}^{n} Q^X_{l,0} f_{l,n}(z_1)
   read as: The first coordinate, for any value x of F^X_m(z). By (24) F^X_n is the sum over Q^X_{l,1}.
   stated: lambda*x*sum(l, 0, n, U[l]*f[l,n](z1, mu1, nu1)) == lambda*x*sum(l, 0, n, f[l,n](z1, mu1, nu1)*U[l]) *)
Definition statement : Prop :=
forall (n : Z) (U : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  lambda * x * sum 0%Z n (fun l => U l * f z1 mu1 nu1 l n) = lambda * x * sum 0%Z n (fun l => f z1 mu1 nu1 l n * U l).
Definition instance : Prop :=
exists (n : Z) (U : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  0 <= z1 <= 1.
End eq_25_2_a_corrected.

Module eq_25_2_b.
(* gbt-surfaces/eq-25.2.b, Sect. 3.4, proof of Theorem 4, eq. (25), second line
   printed: λ sum_{k=0}^{m} Q^X_{k,0} f_{k,m}(z) sum_{l=0}^{n} Q^Y_{l,0} f_{l,n}(z_1)
   read as: The second coordinate, for any value x of F^X_m(z). By (24) F^Y_n is the sum over Q^Y_{l,1}; Y_l stands for Q^Y_{l,0}.
   stated: lambda*x*sum(l, 0, n, V[l]*f[l,n](z1, mu1, nu1)) == lambda*x*sum(l, 0, n, f[l,n](z1, mu1, nu1)*Y[l]) *)
Definition statement : Prop :=
forall (n : Z) (V : Z -> R) (Y : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  lambda * x * sum 0%Z n (fun l => V l * f z1 mu1 nu1 l n) = lambda * x * sum 0%Z n (fun l => f z1 mu1 nu1 l n * Y l).
End eq_25_2_b.

Module eq_25_2_b_corrected.
(* gbt-surfaces/eq-25.2.b (corrected), Sect. 3.4, proof of Theorem 4, eq. (25), second line
   printed: λ sum_{k=0}^{m} Q^X_{k,0} f_{k,m}(z) sum_{l=0}^{n} Q^Y_{l,0} f_{l,n}(z_1)
   read as: The second coordinate, for any value x of F^X_m(z). By (24) F^Y_n is the sum over Q^Y_{l,1}; Y_l stands for Q^Y_{l,0}.
   stated: lambda*x*sum(l, 0, n, V[l]*f[l,n](z1, mu1, nu1)) == lambda*x*sum(l, 0, n, f[l,n](z1, mu1, nu1)*V[l]) *)
Definition statement : Prop :=
forall (n : Z) (V : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  lambda * x * sum 0%Z n (fun l => V l * f z1 mu1 nu1 l n) = lambda * x * sum 0%Z n (fun l => f z1 mu1 nu1 l n * V l).
Definition instance : Prop :=
exists (n : Z) (V : Z -> R) (lambda : R) (mu1 : R) (nu1 : R) (x : R) (z1 : R),
  0 < lambda /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu1 <= 1 /\
  0 <= z1 <= 1.
End eq_25_2_b_corrected.

Module eq_25_2_c.
(* gbt-surfaces/eq-25.2.c, Sect. 3.4, proof of Theorem 4, eq. (25), second line
   printed: sum_{k=0}^{m} Q^Z_{k,0} f_{k,m}(z)
   read as: The third coordinate.
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]])[3] == sum(k, 0, m, Z[k]*f[k,m](z, mu, nu)) *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  entry (vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k])) 3 = sum 0%Z m (fun k => Z_ k * f z mu nu k m).
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_25_2_c.

Module eq_25_3.
(* gbt-surfaces/eq-25.3, Sect. 3.4, proof of Theorem 4, eq. (25), third line
   printed: = ( sum_k sum_l f_{k,m}(z) f_{l,n}(z_1) (λQ^X_{k,0}Q^X_{l,0}), sum_k sum_l f_{k,m}(z) f_{l,n}(z_1) (λQ^X_{k,0}Q^Y_{l,0}), sum_k sum_l f_{k,m}(z) f_{l,n}(z_1) Q^z_{k,0} )
   read as: From the second line of (25) to the third, with the printed labels; Y_l stands for Q^Y_{l,0}. 'Q^z' is read as Q^Z.
   stated: [lambda*FX(z)*sum(l, 0, n, f[l,n](z1, mu1, nu1)*X[l]), lambda*FX(z)*sum(l, 0, n, f[l,n](z1, mu1, nu1)*Y[l]), FZ(z)] == [sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(lambda*X[k]*X[l]))), sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*(lambda*X[k]*Y[l]))), sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*Z[k]))] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (Y : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  [lambda * FX X m mu nu z * sum 0%Z n (fun l => f z1 mu1 nu1 l n * X l); lambda * FX X m mu nu z * sum 0%Z n (fun l => f z1 mu1 nu1 l n * Y l); FZ Z_ m mu nu z] = [sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (lambda * X k * X l))); sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * (lambda * X k * Y l))); sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * Z_ k))].
Definition instance : Prop :=
exists (m : Z) (n : Z) (X : Z -> R) (Y : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_25_3.

Module eq_25_4_a.
(* gbt-surfaces/eq-25.4.a, Sect. 3.4, proof of Theorem 4, eq. (25), last line
   printed: λQ^X_{k,0}Q^X_{l,0}
   read as: The last line is to be (23): the first coordinate of its net.
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*U[l])) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*X[l])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (X : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * U l)) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * X l)).
End eq_25_4_a.

Module eq_25_4_a_corrected.
(* gbt-surfaces/eq-25.4.a (corrected), Sect. 3.4, proof of Theorem 4, eq. (25), last line
   printed: λQ^X_{k,0}Q^X_{l,0}
   read as: The last line is to be (23): the first coordinate of its net.
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*U[l])) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*U[l])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (X : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * U l)) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * U l)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (X : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_25_4_a_corrected.

Module eq_25_4_b.
(* gbt-surfaces/eq-25.4.b, Sect. 3.4, proof of Theorem 4, eq. (25), last line
   printed: λQ^X_{k,0}Q^Y_{l,0}
   read as: The second coordinate; Y_l stands for Q^Y_{l,0}.
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*V[l])) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*Y[l])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (V : Z -> R) (X : Z -> R) (Y : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * V l)) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * Y l)).
End eq_25_4_b.

Module eq_25_4_b_corrected.
(* gbt-surfaces/eq-25.4.b (corrected), Sect. 3.4, proof of Theorem 4, eq. (25), last line
   printed: λQ^X_{k,0}Q^Y_{l,0}
   read as: The second coordinate; Y_l stands for Q^Y_{l,0}.
   stated: sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*V[l])) == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*lambda*X[k]*V[l])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (V : Z -> R) (X : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * V l)) = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * lambda * X k * V l)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (V : Z -> R) (X : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_25_4_b_corrected.

Module eq_25_4_c.
(* gbt-surfaces/eq-25.4.c, Sect. 3.4, proof of Theorem 4, eq. (25), last line
   printed: Q^Z_{k,0}
   read as: The third coordinate.
   stated: swung(FX(z), FZ(z), FU(z1), FV(z1))[3] == sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*Z[k])) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  entry (swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) (FU U mu1 n nu1 z1) (FV V mu1 n nu1 z1)) 3 = sum 0%Z m (fun k => sum 0%Z n (fun l => f z mu nu k m * f z1 mu1 nu1 l n * Z_ k)).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End eq_25_4_c.

Module sec_3_4_features_a.
(* gbt-surfaces/sec-3.4.features.a, Sect. 3.4, paragraph after the proof
   printed: the GBT-Bézier swung surface carried all the characteristics and benefits of GBT-Bézier surface. The shape parameters are used to modify GBT-Bézier swung surface by keeping control net points fixed.
   read as: Convex hull and affine invariance (nonnegative weights that sum to one), interpolation of the corners, change with the shape parameters.
   stated: nonnegative(f) and sum(k, 0, m, f[k,m](z, mu, nu)*sum(l, 0, n, f[l,n](z1, mu1, nu1))) == 1 and swung(FX(0), FZ(0), FU(0), FV(0)) == net(0, 0) and swung(FX(1), FZ(1), FU(0), FV(0)) == net(m, 0) and swung(FX(0), FZ(0), FU(1), FV(1)) == net(0, n) and swung(FX(1), FZ(1), FU(1), FV(1)) == net(m, n) and fails(D(FX'(0), mu) == 0) and fails(D(FX'(1), nu) == 0) and fails(D(FU'(0), mu1) == 0) and fails(D(FU'(1), nu1) == 0) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall z : R, 0 <= z <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= f z mu nu i k) /\ sum 0%Z m (fun k => f z mu nu k m * sum 0%Z n (fun l => f z1 mu1 nu1 l n)) = 1 /\ swung lambda (FX X m mu nu 0) (FZ Z_ m mu nu 0) (FU U mu1 n nu1 0) (FV V mu1 n nu1 0) = net U V X Z_ lambda 0%Z 0%Z /\ swung lambda (FX X m mu nu 1) (FZ Z_ m mu nu 1) (FU U mu1 n nu1 0) (FV V mu1 n nu1 0) = net U V X Z_ lambda m 0%Z /\ swung lambda (FX X m mu nu 0) (FZ Z_ m mu nu 0) (FU U mu1 n nu1 1) (FV V mu1 n nu1 1) = net U V X Z_ lambda 0%Z n /\ swung lambda (FX X m mu nu 1) (FZ Z_ m mu nu 1) (FU U mu1 n nu1 1) (FV V mu1 n nu1 1) = net U V X Z_ lambda m n /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => Derive_n (fun z => FX X m mu nu z) 1 0) 1 mu = 0) /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => Derive_n (fun z => FX X m mu nu z) 1 1) 1 nu = 0) /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  Derive_n (fun mu1 => Derive_n (fun z1 => FU U mu1 n nu1 z1) 1 0) 1 mu1 = 0) /\ ~ (forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (forall l : Z, (0 <= l <= n)%Z -> (2 <= n)%Z) ->
  Derive_n (fun nu1 => Derive_n (fun z1 => FU U mu1 n nu1 z1) 1 1) 1 nu1 = 0).
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End sec_3_4_features_a.

Module sec_3_4_continuity_pc.
(* gbt-surfaces/sec-3.4.continuity-pc, Sect. 3.4, paragraph after the proof
   printed: if the PCs or the TCs are combined by C1 or C2 continuity for GBT-Bézier curve, then the resulting GBT-Bézier swung surface is also a C1 or C2 continuous surface in the direction of profile or trajectory curve   (profile curves)
   read as: With one trajectory and one lambda the jump of each derivative by z is the swung image of the jump of the profiles, so it vanishes with that.
   stated: along_profiles(0) == swung(jumpX(0), jumpZ(0), u, v) and along_profiles(1) == swung(jumpX(1), jumpZ(1), u, v) and along_profiles(2) == swung(jumpX(2), jumpZ(2), u, v) *)
Definition jumpX (X : Z -> R) (X2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => FX2 X2 mu1 n nu1 z) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => FX X m mu nu z) (Z.to_nat r) z) 1.
Definition jumpZ (Z_ : Z -> R) (Z2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => FZ2 Z2 mu1 n nu1 z) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => FZ Z_ m mu nu z) (Z.to_nat r) z) 1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R) (v : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  along_profiles X X2 Z_ Z2 lambda m mu mu1 n nu nu1 u v 0%Z = swung lambda (jumpX X X2 m mu mu1 n nu nu1 0%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 0%Z) u v /\ along_profiles X X2 Z_ Z2 lambda m mu mu1 n nu nu1 u v 1%Z = swung lambda (jumpX X X2 m mu mu1 n nu nu1 1%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 1%Z) u v /\ along_profiles X X2 Z_ Z2 lambda m mu mu1 n nu nu1 u v 2%Z = swung lambda (jumpX X X2 m mu mu1 n nu nu1 2%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 2%Z) u v.
Definition instance : Prop :=
exists (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R) (v : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End sec_3_4_continuity_pc.

Module sec_3_4_continuity_tc.
(* gbt-surfaces/sec-3.4.continuity-tc, Sect. 3.4, paragraph after the proof
   printed: if the PCs or the TCs are combined by C1 or C2 continuity for GBT-Bézier curve, then the resulting GBT-Bézier swung surface is also a C1 or C2 continuous surface in the direction of profile or trajectory curve   (trajectory curves)
   read as: With one profile and one lambda the jump of each derivative by z_1 is a multiple of the jump of the trajectories, so it vanishes with that.
   stated: along_trajectories(0) == lambda*x*[jumpU(0), jumpV(0), 0] and along_trajectories(1) == lambda*x*[jumpU(1), jumpV(1), 0] and along_trajectories(2) == lambda*x*[jumpU(2), jumpV(2), 0] *)
Definition FU2 (U2 : Z -> R) (m : Z) (mu : R) (nu : R) (z1 : R) : R :=
  sum 0%Z m (fun k => f z1 mu nu k m * U2 k).
Definition FV2 (V2 : Z -> R) (m : Z) (mu : R) (nu : R) (z1 : R) : R :=
  sum 0%Z m (fun k => f z1 mu nu k m * V2 k).
Definition along_trajectories (U : Z -> R) (U2 : Z -> R) (V : Z -> R) (V2 : Z -> R) (lambda : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (w : R) (x : R) (r : Z) : list R :=
  vsub ((fun z1 : R => vDerive 3 (fun z1 => swung lambda x w (FU2 U2 m mu nu z1) (FV2 V2 m mu nu z1)) (Z.to_nat r) z1) 0) ((fun z1 : R => vDerive 3 (fun z1 => swung lambda x w (FU U mu1 n nu1 z1) (FV V mu1 n nu1 z1)) (Z.to_nat r) z1) 1).
Definition jumpU (U : Z -> R) (U2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z1 : R => Derive_n (fun z1 => FU2 U2 m mu nu z1) (Z.to_nat r) z1) 0 - (fun z1 : R => Derive_n (fun z1 => FU U mu1 n nu1 z1) (Z.to_nat r) z1) 1.
Definition jumpV (V : Z -> R) (V2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z1 : R => Derive_n (fun z1 => FV2 V2 m mu nu z1) (Z.to_nat r) z1) 0 - (fun z1 : R => Derive_n (fun z1 => FV V mu1 n nu1 z1) (Z.to_nat r) z1) 1.
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (U2 : Z -> R) (V : Z -> R) (V2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (w : R) (x : R),
  0 < lambda ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  along_trajectories U U2 V V2 lambda m mu mu1 n nu nu1 w x 0%Z = vscale (lambda * x) [jumpU U U2 m mu mu1 n nu nu1 0%Z; jumpV V V2 m mu mu1 n nu nu1 0%Z; 0] /\ along_trajectories U U2 V V2 lambda m mu mu1 n nu nu1 w x 1%Z = vscale (lambda * x) [jumpU U U2 m mu mu1 n nu nu1 1%Z; jumpV V V2 m mu mu1 n nu nu1 1%Z; 0] /\ along_trajectories U U2 V V2 lambda m mu mu1 n nu nu1 w x 2%Z = vscale (lambda * x) [jumpU U U2 m mu mu1 n nu nu1 2%Z; jumpV V V2 m mu mu1 n nu nu1 2%Z; 0].
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (U2 : Z -> R) (V : Z -> R) (V2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (w : R) (x : R),
  0 < lambda /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End sec_3_4_continuity_tc.

Module sec_3_4_closed.
(* gbt-surfaces/sec-3.4.closed, Sect. 3.4, paragraph after the proof
   printed: if the swung surface T_swung(z,z_1) is either open or close in z and z_1 directions, then the corresponding profile curve F_m(z) and the trajectory curve F_n(z_1) both will be either open or closed
   read as: Where the surface is closed in z, at a point of the trajectory with polar coordinates (r, theta), the profile from (x0, w0) to (x1, w1) is closed; where it is closed in z_1, at a point (x, w) of the profile, the trajectory from (u0, v0) to (u1, v1) is. If the curves are closed, so is the surface: it is open only if they are.
   stated: x1 == x0 and w1 == w0 and u1 == u0 and v1 == v0 and at(at(gapz, x1, x0), w1, w0) == 0 and at(at(gapz1, u1, u0), v1, v0) == 0 *)
Definition gapz (lambda : R) (r : R) (theta : R) (w0 : R) (w1 : R) (x0 : R) (x1 : R) : list R :=
  vsub (swung lambda x1 w1 (r * cos theta) (r * sin theta)) (swung lambda x0 w0 (r * cos theta) (r * sin theta)).
Definition gapz1 (lambda : R) (u0 : R) (u1 : R) (v0 : R) (v1 : R) (w : R) (x : R) : list R :=
  vsub (swung lambda x w u1 v1) (swung lambda x w u0 v0).
Definition statement : Prop :=
forall (lambda : R) (r : R) (theta : R) (u0 : R) (u1 : R) (v0 : R) (v1 : R) (w : R) (w0 : R) (w1 : R) (x : R) (x0 : R) (x1 : R),
  0 < lambda ->
  0 <= r ->
  dot (gapz lambda r theta w0 w1 x0 x1) [cos theta; sin theta; 0] = 0 ->
  entry (gapz lambda r theta w0 w1 x0 x1) 3 = 0 ->
  entry (gapz1 lambda u0 u1 v0 v1 w x) 1 = 0 ->
  entry (gapz1 lambda u0 u1 v0 v1 w x) 2 = 0 ->
  r <> 0 ->
  x <> 0 ->
  x1 = x0 /\ w1 = w0 /\ u1 = u0 /\ v1 = v0 /\ (fun w1 : R => (fun x1 : R => gapz lambda r theta w0 w1 x0 x1) x0) w0 = zeros 3 /\ (fun v1 : R => (fun u1 : R => gapz1 lambda u0 u1 v0 v1 w x) u0) v0 = zeros 3.
Definition instance : Prop :=
exists (lambda : R) (r : R) (theta : R) (u0 : R) (u1 : R) (v0 : R) (v1 : R) (w : R) (w0 : R) (w1 : R) (x : R) (x0 : R) (x1 : R),
  0 < lambda /\
  0 <= r /\
  dot (gapz lambda r theta w0 w1 x0 x1) [cos theta; sin theta; 0] = 0 /\
  entry (gapz lambda r theta w0 w1 x0 x1) 3 = 0 /\
  entry (gapz1 lambda u0 u1 v0 v1 w x) 1 = 0 /\
  entry (gapz1 lambda u0 u1 v0 v1 w x) 2 = 0 /\
  r <> 0 /\
  x <> 0.
End sec_3_4_closed.

Module sec_3_4_revolution.
(* gbt-surfaces/sec-3.4.revolution, Sect. 3.4, paragraph after the proof
   printed: if the scale factor λ = 1 and the trajectory curve F_n(z_1) circle with a unit radius with a center at the origin, then the GBT-Bézier swung surface is a surface of revolution
   stated: swung(x, w, cos(theta), sin(theta)) == turn*[x, 0, w] *)
Definition statement : Prop :=
forall (lambda : R) (theta : R) (w : R) (x : R),
  0 < lambda ->
  lambda = 1 ->
  swung lambda x w (cos theta) (sin theta) = mvec (turn theta) [x; 0; w].
Definition instance : Prop :=
exists (lambda : R) (theta : R) (w : R) (x : R),
  0 < lambda /\
  lambda = 1.
End sec_3_4_revolution.

Module sec_3_4_revolution_not_tensor_quarter.
(* gbt-surfaces/sec-3.4.revolution-not-tensor.quarter, Sect. 3.4, paragraph after the proof
   printed: A quarter of every surface of revolution is a tensor product swung surface: the quarter of the unit circle is the curve of (1, 0), (1, 1), (0, 1) of order 2 with vanishing shape parameters. Four patches make the whole surface.
   stated: f[0,2](z1, 0, 0)*swung(x, w, 1, 0) + f[1,2](z1, 0, 0)*swung(x, w, 1, 1) + f[2,2](z1, 0, 0)*swung(x, w, 0, 1) == [lambda*x*cos(pi/2*z1), lambda*x*sin(pi/2*z1), w] *)
Definition statement : Prop :=
forall (lambda : R) (w : R) (x : R) (z1 : R),
  0 < lambda ->
  0 <= z1 <= 1 ->
  vadd (vadd (vscale (f z1 0 0 0%Z 2%Z) (swung lambda x w 1 0)) (vscale (f z1 0 0 1%Z 2%Z) (swung lambda x w 1 1))) (vscale (f z1 0 0 2%Z 2%Z) (swung lambda x w 0 1)) = [lambda * x * cos (PI / 2 * z1); lambda * x * sin (PI / 2 * z1); w].
Definition instance : Prop :=
exists (lambda : R) (w : R) (x : R) (z1 : R),
  0 < lambda /\
  0 <= z1 <= 1.
End sec_3_4_revolution_not_tensor_quarter.

Module sec_3_4_revolution_not_tensor_cubic.
(* gbt-surfaces/sec-3.4.revolution-not-tensor.cubic, Sect. 3.4, paragraph after the proof
   printed: A trajectory of order 3 that leaves the point (1, 0) of the unit circle along the circle and comes back to it along the circle does not leave the line X = 1: it is no circle.
   stated: K(z1) == 1 *)
Definition K (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu1 : R) (nu1 : R) (t : R) : R :=
  f t mu1 nu1 0%Z 3%Z * c0 + f t mu1 nu1 1%Z 3%Z * c1 + f t mu1 nu1 2%Z 3%Z * c2 + f t mu1 nu1 3%Z 3%Z * c3.
Definition statement : Prop :=
forall (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z1 <= 1 ->
  K c0 c1 c2 c3 mu1 nu1 0 = 1 ->
  Derive_n (fun t => K c0 c1 c2 c3 mu1 nu1 t) 1 0 = 0 ->
  Derive_n (fun t => K c0 c1 c2 c3 mu1 nu1 t) 1 1 = 0 ->
  K c0 c1 c2 c3 mu1 nu1 1 = 1 ->
  K c0 c1 c2 c3 mu1 nu1 z1 = 1.
Definition instance : Prop :=
exists (c0 : R) (c1 : R) (c2 : R) (c3 : R) (mu1 : R) (nu1 : R) (z1 : R),
  (-1) <= mu1 <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z1 <= 1 /\
  K c0 c1 c2 c3 mu1 nu1 0 = 1 /\
  Derive_n (fun t => K c0 c1 c2 c3 mu1 nu1 t) 1 0 = 0 /\
  Derive_n (fun t => K c0 c1 c2 c3 mu1 nu1 t) 1 1 = 0 /\
  K c0 c1 c2 c3 mu1 nu1 1 = 1.
End sec_3_4_revolution_not_tensor_cubic.

Module alg_4_a.
(* gbt-surfaces/alg-4.a, Sect. 3.4, Algorithm 4, steps 1 to 4
   printed: 1. Take a profile curve in XOZ and a trajectory curve in the XOY plane in the form of GBT-Bézier curves. 2. Define a GBT-Bézier swung surface by using (23). 3. Take the control net points in the pattern Q_{k,l} = (λQ^X_{k,0}Q^X_{l,1}, λQ^X_{k,0}Q^Y_{l,1}, Q^Z_{k,0}), where Q^X_{k,0}, Q^Z_{k,0} and Q^X_{l,1}, Q^Y_{k,1} are elements of Q_{k,0} and Q_{l,1}. 4. Construct with suitable λ, μ, ν, μ_1, ν_1.
   read as: The pattern of step 3 gives the swung surface for every scale factor; the index of Q^Y_{k,1} in the explanation of step 3 is gbt-surfaces/thm-4.elements.
   stated: at(sum(k, 0, m, sum(l, 0, n, f[k,m](z, mu, nu)*f[l,n](z1, mu1, nu1)*net(k, l))), lambda, lambda2) == at(swung(FX(z), FZ(z), FU(z1), FV(z1)), lambda, lambda2) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda2 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda2 ->
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  0 <= z <= 1 ->
  0 <= z1 <= 1 ->
  (fun lambda : R => vsum 3 0%Z m (fun k => vsum 3 0%Z n (fun l => vscale (f z mu nu k m * f z1 mu1 nu1 l n) (net U V X Z_ lambda k l)))) lambda2 = (fun lambda : R => swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) (FU U mu1 n nu1 z1) (FV V mu1 n nu1 z1)) lambda2.
Definition instance : Prop :=
exists (m : Z) (n : Z) (U : Z -> R) (V : Z -> R) (X : Z -> R) (Z_ : Z -> R) (lambda2 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (z : R) (z1 : R),
  0 < lambda2 /\
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  0 <= z <= 1 /\
  0 <= z1 <= 1.
End alg_4_a.

Module alg_4_b.
(* gbt-surfaces/alg-4.b, Sect. 3.4, Algorithm 4, step 5
   printed: 5. Two adjacent GBT-Bézier swung surfaces can be connected by C1 and C2 continuity conditions given in Theorem 2.
   read as: The profiles are joined with Theorem 2 as printed, with one trajectory and one λ.
   stated: second(0) == first(1) and second'(0) == first'(1) and second''(0) == first''(1) *)
Definition a1 (mu1 : R) (n : Z) (nu1 : R) : R :=
  4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1).
Definition a2 (m : Z) (nu : R) : R :=
  4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)).
Definition a3 (mu1 : R) (n : Z) (nu : R) (nu1 : R) : R :=
  2 * a1 mu1 n nu1 + PI ^ 2 * (1 + 2 * mu1 - nu1) + 2 * PI ^ 2 * nu.
Definition third (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (p : R) (q : R) (r : R) : R :=
  p + 1 / a1 mu1 n nu1 * (a2 m nu * (p - 2 * q + r) - PI ^ 2 * (1 - mu) * (q - r) + a3 mu1 n nu nu1 * (p - q)).
Definition second (X2 : Z -> R) (Z2 : Z -> R) (lambda : R) (mu1 : R) (n : Z) (nu1 : R) (u : R) (v : R) (z : R) : list R :=
  swung lambda (FX2 X2 mu1 n nu1 z) (FZ2 Z2 mu1 n nu1 z) u v.
Definition first (X : Z -> R) (Z_ : Z -> R) (lambda : R) (m : Z) (mu : R) (nu : R) (u : R) (v : R) (z : R) : list R :=
  swung lambda (FX X m mu nu z) (FZ Z_ m mu nu z) u v.
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R) (v : R),
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  X2 0%Z = X m ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  X2 1%Z = X m + a m mu1 n nu * (X m - X (m - 1)%Z) ->
  a1 mu1 n nu1 <> 0 ->
  X2 2%Z = third m mu mu1 n nu nu1 (X m) (X (m - 1)%Z) (X (m - 2)%Z) ->
  Z2 0%Z = Z_ m ->
  Z2 1%Z = Z_ m + a m mu1 n nu * (Z_ m - Z_ (m - 1)%Z) ->
  Z2 2%Z = third m mu mu1 n nu nu1 (Z_ m) (Z_ (m - 1)%Z) (Z_ (m - 2)%Z) ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  second X2 Z2 lambda mu1 n nu1 u v 0 = first X Z_ lambda m mu nu u v 1 /\ vDerive 3 (fun z => second X2 Z2 lambda mu1 n nu1 u v z) 1 0 = vDerive 3 (fun z => first X Z_ lambda m mu nu u v z) 1 1 /\ vDerive 3 (fun z => second X2 Z2 lambda mu1 n nu1 u v z) 2 0 = vDerive 3 (fun z => first X Z_ lambda m mu nu u v z) 2 1.
End alg_4_b.

Module eq_26.
(* gbt-surfaces/eq-26, Sect. 3.4, Example 3.4, eq. (26)
   printed: Q_{0,0} = (3, 0, 5), Q_{1,0} = (1, 0, 3), Q_{2,0} = (1, 0, 2), Q_{3,0} = (4, 0, 1), Q_{0,1} = (4, 1, 0), Q_{1,1} = (1, 2, 0), Q_{2,1} = (1, 4, 0), Q_{3,1} = (5, 5, 0)
   read as: The profile lies in the plane XOZ and the trajectory in XOY, as (20) asks.
   stated: profile*[0, 1, 0] == [0, 0, 0, 0] and trajectory*[0, 0, 1] == [0, 0, 0, 0] *)
Definition profile : list (list R) :=
  [[3; 0; 5]; [1; 0; 3]; [1; 0; 2]; [4; 0; 1]].
Definition trajectory : list (list R) :=
  [[4; 1; 0]; [1; 2; 0]; [1; 4; 0]; [5; 5; 0]].
Definition statement : Prop :=
  mvec profile [0; 1; 0] = [0; 0; 0; 0] /\ mvec trajectory [0; 0; 1] = [0; 0; 0; 0].
End eq_26.

Module ex_3_4_scaling.
(* gbt-surfaces/ex-3.4.scaling, Sect. 3.4, Example 3.4
   printed: the scaling of swung surfaces in both directions is handled by scale factor λ keeping shape parameters μ and ν same and fixed
   read as: Another scale factor scales the surface in both directions of the plane XOY, and leaves the heights.
   stated: at(swung(x, w, u, v), lambda, lambda2) == [[lambda2/lambda, 0, 0], [0, lambda2/lambda, 0], [0, 0, 1]]*swung(x, w, u, v) *)
Definition statement : Prop :=
forall (lambda : R) (lambda2 : R) (u : R) (v : R) (w : R) (x : R),
  0 < lambda ->
  0 < lambda2 ->
  lambda <> 0 ->
  (fun lambda : R => swung lambda x w u v) lambda2 = mvec [[lambda2 / lambda; 0; 0]; [0; lambda2 / lambda; 0]; [0; 0; 1]] (swung lambda x w u v).
Definition instance : Prop :=
exists (lambda : R) (lambda2 : R) (u : R) (v : R) (w : R) (x : R),
  0 < lambda /\
  0 < lambda2 /\
  lambda <> 0.
End ex_3_4_scaling.

Module fig_16_lambda_between_the_panels.
(* gbt-surfaces/fig-16.lambda.between the panels, Sect. 3.4, caption of Figure 16
   printed: C1 continuous connection among two GBT-Bézier swung surfaces with different scale factor λ
   read as: Each panel has one λ; profiles that join with (4) give surfaces that join with C1.
   stated: along_profiles(0) == 0 and along_profiles(1) == 0 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R) (v : R),
  0 < lambda ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  X2 0%Z = X m ->
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  X2 1%Z = X m + a m mu1 n nu * (X m - X (m - 1)%Z) ->
  Z2 0%Z = Z_ m ->
  Z2 1%Z = Z_ m + a m mu1 n nu * (Z_ m - Z_ (m - 1)%Z) ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  along_profiles X X2 Z_ Z2 lambda m mu mu1 n nu nu1 u v 0%Z = zeros 3 /\ along_profiles X X2 Z_ Z2 lambda m mu mu1 n nu nu1 u v 1%Z = zeros 3.
Definition instance : Prop :=
exists (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (lambda : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R) (v : R),
  0 < lambda /\
  (3 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (3 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1 /\
  X2 0%Z = X m /\
  2 * (IZR n - 2) + PI * (1 + mu1) <> 0 /\
  X2 1%Z = X m + a m mu1 n nu * (X m - X (m - 1)%Z) /\
  Z2 0%Z = Z_ m /\
  Z2 1%Z = Z_ m + a m mu1 n nu * (Z_ m - Z_ (m - 1)%Z) /\
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) /\
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z).
End fig_16_lambda_between_the_panels.

Module fig_16_lambda_between_the_surfaces.
(* gbt-surfaces/fig-16.lambda.between the surfaces, Sect. 3.4, caption of Figure 16
   printed: C1 continuous connection among two GBT-Bézier swung surfaces with different scale factor λ
   read as: The two adjacent surfaces have different λ and profiles that join.
   stated: lambda2*FX2(0)*u == lambda*FX(1)*u *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (u : R),
  0 < lambda ->
  0 < lambda2 ->
  (3 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (3 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  X2 0%Z = X m ->
  (forall k : Z, (0 <= k <= n)%Z -> (2 <= n)%Z) ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  lambda2 * FX2 X2 mu1 n nu1 0 * u = lambda * FX X m mu nu 1 * u.
End fig_16_lambda_between_the_surfaces.
