(* Statements of gbt-surfaces, Section 3 6. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition printed_ (phi : R) (psi : R) : list (list R) :=
  [[cos phi; - sin phi; 0]; [sin phi; cos psi; 0]; [0; 0; 1]].
Definition f (z : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] i k.
Definition FX (X : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun k => f z mu nu k m * X k).
Definition FZ (Z_ : Z -> R) (m : Z) (mu : R) (nu : R) (z : R) : R :=
  sum 0%Z m (fun l => f z mu nu l m * Z_ l).
Definition cosine (t : R) : R :=
  (1 - 2 * t) / (2 * t ^ 2 - 2 * t + 1).
Definition sine (t : R) : R :=
  (2 * t - 2 * t ^ 2) / (2 * t ^ 2 - 2 * t + 1).
Definition at_angle (q : R) : R :=
  sin (PI / 2 * q) / (sin (PI / 2 * q) + cos (PI / 2 * q)).
Definition T (x : R) (w : R) (t : R) : list R :=
  [cosine t * x; sine t * x; w].
Definition Tm (x : R) (w : R) (t : R) : list R :=
  [cosine t * x; - sine t * x; w].
Definition Q36 : list (list R) :=
  [[4; 0; 15]; [0; 0; 13]; [0; 0; 10]; [10; 0; 5]; [4; 0; 0]].
Definition F4 (mu : R) (nu : R) (z : R) : list R :=
  vsum 3 0%Z 4%Z (fun k => vscale (f z mu nu k 4%Z) (row Q36 (Z.to_nat (k + 1)%Z))).
End Definitions.
Import Definitions.

Module eq_32_matrix.
(* gbt-surfaces/eq-32.matrix, Sect. 3.6, eq. (32), first line
   printed: R_rotation(z,φ) = [[cosφ, -sinφ, 0], [sinφ, cos zφ, 0], [0, 0, 1]] F_m(z)
   read as: The entry in row 2, column 2 is 'cos zφ' in our copy; psi stands for that angle. The matrix is to be that of the rotation by φ about the Z axis.
   stated: printed == [[cos(phi), -sin(phi), 0], [sin(phi), cos(phi), 0], [0, 0, 1]] *)
Definition statement : Prop :=
forall (phi : R) (psi : R),
  0 < phi <= 2 * PI ->
  printed_ phi psi = [[cos phi; - sin phi; 0]; [sin phi; cos phi; 0]; [0; 0; 1]].
End eq_32_matrix.

Module eq_32_matrix_corrected.
(* gbt-surfaces/eq-32.matrix (corrected), Sect. 3.6, eq. (32), first line
   printed: R_rotation(z,φ) = [[cosφ, -sinφ, 0], [sinφ, cos zφ, 0], [0, 0, 1]] F_m(z)
   read as: The entry in row 2, column 2 is 'cos zφ' in our copy; psi stands for that angle. The matrix is to be that of the rotation by φ about the Z axis.
   stated: [[cos(phi), -sin(phi), 0], [sin(phi), cos(phi), 0], [0, 0, 1]] == [[cos(phi), -sin(phi), 0], [sin(phi), cos(phi), 0], [0, 0, 1]] *)
Definition statement : Prop :=
forall (phi : R),
  0 < phi <= 2 * PI ->
  [[cos phi; - sin phi; 0]; [sin phi; cos phi; 0]; [0; 0; 1]] = [[cos phi; - sin phi; 0]; [sin phi; cos phi; 0]; [0; 0; 1]].
Definition instance : Prop :=
exists (phi : R),
  0 < phi <= 2 * PI.
End eq_32_matrix_corrected.

Module eq_32_components.
(* gbt-surfaces/eq-32.components, Sect. 3.6, eq. (32), second line
   printed: = [X_m(z) cosφ, X_m(z) sinφ, Z_m(z)]^T, where F_m(z) = [X_m(z), 0, Z_m(z)]^T, z ∈ [0,1]
   stated: printed*[FX(z), 0, FZ(z)] == [FX(z)*cos(phi), FX(z)*sin(phi), FZ(z)] *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (phi : R) (psi : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 < phi <= 2 * PI ->
  0 <= z <= 1 ->
  mvec (printed_ phi psi) [FX X m mu nu z; 0; FZ Z_ m mu nu z] = [FX X m mu nu z * cos phi; FX X m mu nu z * sin phi; FZ Z_ m mu nu z].
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (phi : R) (psi : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 < phi <= 2 * PI /\
  0 <= z <= 1.
End eq_32_components.

Module sec_3_6_rounding_rational.
(* gbt-surfaces/sec-3.6.rounding.rational, Sect. 3.6, paragraph after eq. (32)
   printed: The functions of the angle in (32) can be replaced by rational ones: with t = z_1/(1 - z_1) these are (1 - t^2)/(1 + t^2) and 2t/(1 + t^2). The generating line itself is made of sines and cosines.
   stated: cosine(z1) == ((1 - z1)^2 - z1^2)/((1 - z1)^2 + z1^2) and sine(z1) == 2*z1*(1 - z1)/((1 - z1)^2 + z1^2) *)
Definition statement : Prop :=
forall (z1 : R),
  0 <= z1 <= 1 ->
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0 ->
  (1 - z1) ^ 2 + z1 ^ 2 <> 0 ->
  cosine z1 = ((1 - z1) ^ 2 - z1 ^ 2) / ((1 - z1) ^ 2 + z1 ^ 2) /\ sine z1 = 2 * z1 * (1 - z1) / ((1 - z1) ^ 2 + z1 ^ 2).
Definition instance : Prop :=
exists (z1 : R),
  0 <= z1 <= 1 /\
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0 /\
  (1 - z1) ^ 2 + z1 ^ 2 <> 0.
End sec_3_6_rounding_rational.

Module sec_3_6_c1c2.
(* gbt-surfaces/sec-3.6.c1c2, Sect. 3.6, first paragraph
   printed: This portion is especially focused on how to develop a C1 or C2 continuous 3D mathematical model of GBT-Bézier rotation surface by taking a combined GBT-Bézier curve.
   read as: The jump of each derivative of the surface is the turned jump of the generating lines, so it vanishes with that; c and s are the cosine and the sine of the angle.
   stated: jump(0) == turned(jumpX(0), jumpZ(0)) and jump(1) == turned(jumpX(1), jumpZ(1)) and jump(2) == turned(jumpX(2), jumpZ(2)) *)
Definition line2X (X2 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * X2 k).
Definition line2Z (Z2 : Z -> R) (mu1 : R) (n : Z) (nu1 : R) (z : R) : R :=
  sum 0%Z n (fun k => f z mu1 nu1 k n * Z2 k).
Definition turned (c : R) (s : R) (x : R) (w : R) : list R :=
  [c * x; s * x; w].
Definition jumpX (X : Z -> R) (X2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => line2X X2 mu1 n nu1 z) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => FX X m mu nu z) (Z.to_nat r) z) 1.
Definition jumpZ (Z_ : Z -> R) (Z2 : Z -> R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (r : Z) : R :=
  (fun z : R => Derive_n (fun z => line2Z Z2 mu1 n nu1 z) (Z.to_nat r) z) 0 - (fun z : R => Derive_n (fun z => FZ Z_ m mu nu z) (Z.to_nat r) z) 1.
Definition jump (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (c : R) (m : Z) (mu : R) (mu1 : R) (n : Z) (nu : R) (nu1 : R) (s : R) (r : Z) : list R :=
  vsub ((fun z : R => vDerive 3 (fun z => turned c s (line2X X2 mu1 n nu1 z) (line2Z Z2 mu1 n nu1 z)) (Z.to_nat r) z) 0) ((fun z : R => vDerive 3 (fun z => turned c s (FX X m mu nu z) (FZ Z_ m mu nu z)) (Z.to_nat r) z) 1).
Definition statement : Prop :=
forall (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (c : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (s : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= mu1 <= 1 ->
  (2 <= n)%Z ->
  (-1) <= nu <= 1 ->
  (-1) <= nu1 <= 1 ->
  jump X X2 Z_ Z2 c m mu mu1 n nu nu1 s 0%Z = turned c s (jumpX X X2 m mu mu1 n nu nu1 0%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 0%Z) /\ jump X X2 Z_ Z2 c m mu mu1 n nu nu1 s 1%Z = turned c s (jumpX X X2 m mu mu1 n nu nu1 1%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 1%Z) /\ jump X X2 Z_ Z2 c m mu mu1 n nu nu1 s 2%Z = turned c s (jumpX X X2 m mu mu1 n nu nu1 2%Z) (jumpZ Z_ Z2 m mu mu1 n nu nu1 2%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (X : Z -> R) (X2 : Z -> R) (Z_ : Z -> R) (Z2 : Z -> R) (c : R) (mu : R) (mu1 : R) (nu : R) (nu1 : R) (s : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= mu1 <= 1 /\
  (2 <= n)%Z /\
  (-1) <= nu <= 1 /\
  (-1) <= nu1 <= 1.
End sec_3_6_c1c2.

Module eq_33_T.
(* gbt-surfaces/eq-33.T, Sect. 3.6, Theorem 6, eq. (33), first line
   printed: T^Z_rotation(z,z_1,μ,ν) = { (1 - 2z_1)/(2z_1^2 - 2z_1 + 1) X_m(z), (2z_1 - 2z_1^2)/(2z_1^2 - 2z_1 + 1) X_m(z), Z_m(z) }
   read as: A rotation surface of the line (X, 0, Z) about the Z axis: at the parameter at_angle(q), which goes from 0 to 1 with q, the line is turned by πq, counterclockwise.
   stated: T(x, w, at_angle(q)) == [cos(pi*q)*x, sin(pi*q)*x, w] and at_angle(0) == 0 and at_angle(1) == 1 and 0 <= at_angle(q) <= 1 *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 ->
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 ->
  T x w (at_angle q) = [cos (PI * q) * x; sin (PI * q) * x; w] /\ at_angle 0 = 0 /\ at_angle 1 = 1 /\ 0 <= at_angle q /\ at_angle q <= 1.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 /\
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0.
End eq_33_T.

Module eq_33_Ttilde.
(* gbt-surfaces/eq-33.Ttilde, Sect. 3.6, Theorem 6, eq. (33), second line
   printed: T~^Z_rotation(z,z_1,μ,ν) = { (1 - 2z_1)/(2z_1^2 - 2z_1 + 1) X_m(z), - (2z_1 - 2z_1^2)/(2z_1^2 - 2z_1 + 1) X_m(z), Z_m(z) }
   read as: A rotation surface of the line (X, 0, Z) about the Z axis: at the parameter at_angle(q), which goes from 0 to 1 with q, the line is turned by πq, clockwise.
   stated: Tm(x, w, at_angle(q)) == [cos(pi*q)*x, -sin(pi*q)*x, w] and at_angle(0) == 0 and at_angle(1) == 1 and 0 <= at_angle(q) <= 1 *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 ->
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 ->
  Tm x w (at_angle q) = [cos (PI * q) * x; - sin (PI * q) * x; w] /\ at_angle 0 = 0 /\ at_angle 1 = 1 /\ 0 <= at_angle q /\ at_angle q <= 1.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 /\
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0.
End eq_33_Ttilde.

Module eq_33_circle.
(* gbt-surfaces/eq-33.circle, Sect. 3.6, Theorem 6, eq. (33)
   printed: the coefficients (1 - 2z_1)/(2z_1^2 - 2z_1 + 1), (2z_1 - 2z_1^2)/(2z_1^2 - 2z_1 + 1) of X_m(z) in (33)
   stated: ((1 - 2*z1)/(2*z1^2 - 2*z1 + 1))^2 + ((2*z1 - 2*z1^2)/(2*z1^2 - 2*z1 + 1))^2 == 1 and (2*z1 - 2*z1^2)/(2*z1^2 - 2*z1 + 1) >= 0 *)
Definition statement : Prop :=
forall (z1 : R),
  0 <= z1 <= 1 ->
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0 ->
  ((1 - 2 * z1) / (2 * z1 ^ 2 - 2 * z1 + 1)) ^ 2 + ((2 * z1 - 2 * z1 ^ 2) / (2 * z1 ^ 2 - 2 * z1 + 1)) ^ 2 = 1 /\ (2 * z1 - 2 * z1 ^ 2) / (2 * z1 ^ 2 - 2 * z1 + 1) >= 0.
Definition instance : Prop :=
exists (z1 : R),
  0 <= z1 <= 1 /\
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0.
End eq_33_circle.

Module thm_6_symmetric.
(* gbt-surfaces/thm-6.symmetric, Sect. 3.6, Theorem 6, sentence after eq. (33)
   printed: T^Z_rotation and T~^Z_rotation are symmetric about the XOZ plane
   stated: [[1, 0, 0], [0, -1, 0], [0, 0, 1]]*T(x, w, z1) == Tm(x, w, z1) *)
Definition statement : Prop :=
forall (w : R) (x : R) (z1 : R),
  0 <= z1 <= 1 ->
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0 ->
  mvec [[1; 0; 0]; [0; - 1; 0]; [0; 0; 1]] (T x w z1) = Tm x w z1.
Definition instance : Prop :=
exists (w : R) (x : R) (z1 : R),
  0 <= z1 <= 1 /\
  2 * z1 ^ 2 - 2 * z1 + 1 <> 0.
End thm_6_symmetric.

Module thm_6_complete.
(* gbt-surfaces/thm-6.complete, Sect. 3.6, Theorem 6, sentence after eq. (33)
   printed: by combining these two terms, we can get a complete GBT-Bézier rotation surface   (the expression for entire rotation surfaces generated by rotating the generating line F_m(z) around Z-axis in one rotation)
   read as: For every angle πq of a half turn the line is turned by it in the one half, and by the opposite angle in the other: each position of the whole turn once.
   stated: T(x, w, at_angle(q)) == [cos(pi*q)*x, sin(pi*q)*x, w] and Tm(x, w, at_angle(q)) == [cos(pi*q)*x, -sin(pi*q)*x, w] and 0 <= at_angle(q) <= 1 and D(at_angle(q), q) > 0 *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0) ->
  T x w (at_angle q) = [cos (PI * q) * x; sin (PI * q) * x; w] /\ Tm x w (at_angle q) = [cos (PI * q) * x; - sin (PI * q) * x; w] /\ 0 <= at_angle q /\ at_angle q <= 1 /\ Derive_n (fun q => at_angle q) 1 q > 0.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0).
End thm_6_complete.

Module eq_34.
(* gbt-surfaces/eq-34, Sect. 3.6, Theorem 6, eq. (34)
   printed: X_m(z) = sum_{k=0}^{m} f_{k,m}(z) X_k, z ∈ [0,1]; Z_m(z) = sum_{l=0}^{m} f_{l,m}(z) Z_l, z ∈ [0,1]
   stated: sum(k, 0, m, f[k,m](z, mu, nu)*[X[k], 0, Z[k]]) == [sum(k, 0, m, f[k,m](z)*X[k]), 0, sum(l, 0, m, f[l,m](z)*Z[l])] *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  vsum 3 0%Z m (fun k => vscale (f z mu nu k m) [X k; 0; Z_ k]) = [sum 0%Z m (fun k => f z mu nu k m * X k); 0; sum 0%Z m (fun l => f z mu nu l m * Z_ l)].
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End eq_34.

Module sec_3_6_other_axes.
(* gbt-surfaces/sec-3.6.other-axes, Sect. 3.6, sentence after the proof of Theorem 6
   printed: using the same results, we can develop a rotation surface if the generating line and the rotation axis are XOY or YOZ and X-axis or Y-axis, respectively
   read as: At the parameter of the angle πq a line (X, Y, 0) is turned by it about the X axis, and a line (0, Y, Z) about the Y axis; with the other sign of the sine, back.
   stated: aboutX(at_angle(q), 1) == [x, cos(pi*q)*y, sin(pi*q)*y] and aboutX(at_angle(q), -1) == [x, cos(pi*q)*y, -sin(pi*q)*y] and aboutY(at_angle(q), 1) == [sin(pi*q)*w, y, cos(pi*q)*w] and aboutY(at_angle(q), -1) == [-sin(pi*q)*w, y, cos(pi*q)*w] and at_angle(0) == 0 and at_angle(1) == 1 *)
Definition aboutX (x : R) (y : R) (t : R) (sign : R) : list R :=
  [x; cosine t * y; sign * sine t * y].
Definition aboutY (w : R) (y : R) (t : R) (sign : R) : list R :=
  [sign * sine t * w; y; cosine t * w].
Definition statement : Prop :=
forall (q : R) (w : R) (x : R) (y : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 ->
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 ->
  aboutX x y (at_angle q) 1 = [x; cos (PI * q) * y; sin (PI * q) * y] /\ aboutX x y (at_angle q) (- 1) = [x; cos (PI * q) * y; - sin (PI * q) * y] /\ aboutY w y (at_angle q) 1 = [sin (PI * q) * w; y; cos (PI * q) * w] /\ aboutY w y (at_angle q) (- 1) = [- sin (PI * q) * w; y; cos (PI * q) * w] /\ at_angle 0 = 0 /\ at_angle 1 = 1.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R) (y : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 /\
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0.
End sec_3_6_other_axes.

Module prop_3_8_a_linear.
(* gbt-surfaces/prop-3.8.a.linear, Sect. 3.6, Proposition 3.8 (a)
   printed: With 0 ≤ z_1 ≤ φ/π the line is not turned by φ.
   stated: fails(T(x, w, q) == [cos(pi*q)*x, sin(pi*q)*x, w]) *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  ~ (forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  2 * q ^ 2 - 2 * q + 1 <> 0 ->
  T x w q = [cos (PI * q) * x; sin (PI * q) * x; w]).
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1.
End prop_3_8_a_linear.

Module prop_3_8_a_true.
(* gbt-surfaces/prop-3.8.a.true, Sect. 3.6, Proposition 3.8 (a)
   printed: For a turn by φ = π q, at most a half turn, the parameter goes from 0 to sin(φ/2)/(sin(φ/2) + cos(φ/2)).
   stated: T(x, w, at_angle(q)) == [cos(pi*q)*x, sin(pi*q)*x, w] and at_angle(0) == 0 and at_angle(1) == 1 and D(at_angle(q), q) > 0 *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 ->
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 ->
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0) ->
  T x w (at_angle q) = [cos (PI * q) * x; sin (PI * q) * x; w] /\ at_angle 0 = 0 /\ at_angle 1 = 1 /\ Derive_n (fun q => at_angle q) 1 q > 0.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 /\
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 /\
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0).
End prop_3_8_a_true.

Module prop_3_8_b.
(* gbt-surfaces/prop-3.8.b, Sect. 3.6, Proposition 3.8 (b)
   printed: If 0 < φ ≤ 2π, where φ is the rotation angle, we can utilize T^Z_rotation to construct the first half and then utilize T~^Z_rotation to construct the remaining according to the technique in (a), with (2π - φ)/π ≤ z ≤ 1 value range of parameter z.
   read as: The parameter that is called z here is z_1. The second half begins at the parameter q = (2π - φ)/π, that is φ = π (2 - q): the point of T~ there should be the line turned by φ.
   stated: Tm(x, w, q) == [cos(pi*(2 - q))*x, sin(pi*(2 - q))*x, w] *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  2 * q ^ 2 - 2 * q + 1 <> 0 ->
  Tm x w q = [cos (PI * (2 - q)) * x; sin (PI * (2 - q)) * x; w].
End prop_3_8_b.

Module prop_3_8_b_true.
(* gbt-surfaces/prop-3.8.b.true, Sect. 3.6, Proposition 3.8 (b)
   printed: For a turn by φ = π(2 - q) the second half begins at the parameter sin(π q/2)/(sin(π q/2) + cos(π q/2)).
   stated: Tm(x, w, at_angle(q)) == [cos(pi*(2 - q))*x, sin(pi*(2 - q))*x, w] and at_angle(0) == 0 and at_angle(1) == 1 and D(at_angle(q), q) > 0 *)
Definition statement : Prop :=
forall (q : R) (w : R) (x : R),
  0 <= q <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 ->
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 ->
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0) ->
  Tm x w (at_angle q) = [cos (PI * (2 - q)) * x; sin (PI * (2 - q)) * x; w] /\ at_angle 0 = 0 /\ at_angle 1 = 1 /\ Derive_n (fun q => at_angle q) 1 q > 0.
Definition instance : Prop :=
exists (q : R) (w : R) (x : R),
  0 <= q <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 /\
  sin (PI / 2 * 0) + cos (PI / 2 * 0) <> 0 /\
  sin (PI / 2 * 1) + cos (PI / 2 * 1) <> 0 /\
  locally q (fun q => sin (PI / 2 * q) + cos (PI / 2 * q) <> 0).
End prop_3_8_b_true.

Module prop_3_8_b_exact.
(* gbt-surfaces/prop-3.8.b.exact, Sect. 3.6, Proposition 3.8 (b)
   printed: The printed range is exact for the whole turn, three quarters and a half.
   stated: Tm(x, w, 0) == [cos(2*pi)*x, sin(2*pi)*x, w] and Tm(x, w, 1/2) == [cos(3/2*pi)*x, sin(3/2*pi)*x, w] and Tm(x, w, 1) == [cos(pi)*x, sin(pi)*x, w] *)
Definition statement : Prop :=
forall (w : R) (x : R),
  2 * 0 ^ 2 - 2 * 0 + 1 <> 0 ->
  2 * (1 / 2) ^ 2 - 2 * (1 / 2) + 1 <> 0 ->
  2 * 1 ^ 2 - 2 * 1 + 1 <> 0 ->
  Tm x w 0 = [cos (2 * PI) * x; sin (2 * PI) * x; w] /\ Tm x w (1 / 2) = [cos (3 / 2 * PI) * x; sin (3 / 2 * PI) * x; w] /\ Tm x w 1 = [cos PI * x; sin PI * x; w].
Definition instance : Prop :=
exists (w : R) (x : R),
  2 * 0 ^ 2 - 2 * 0 + 1 <> 0 /\
  2 * (1 / 2) ^ 2 - 2 * (1 / 2) + 1 <> 0 /\
  2 * 1 ^ 2 - 2 * 1 + 1 <> 0.
End prop_3_8_b_exact.

Module prop_3_9_a_composite_line.
(* gbt-surfaces/prop-3.9.a.composite line, Sect. 3.6, Proposition 3.9, first sentence
   printed: From the reality of GBT-Bézier rotation surfaces which have various independent shape parameters, we can generate the desired shape of a rotation surface both locally and globally, by modifying shape control parameters.
   read as: Of a composite generating line each segment changes with its own shape parameters.
   stated: fails(D(FX'(0), mu) == 0) and fails(D(FX'(1), nu) == 0) *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => Derive_n (fun z => FX X m mu nu z) 1 0) 1 mu = 0) /\ ~ (forall (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun nu => Derive_n (fun z => FX X m mu nu z) 1 1) 1 nu = 0).
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1.
End prop_3_9_a_composite_line.

Module prop_3_9_a_one_segment.
(* gbt-surfaces/prop-3.9.a.one segment, Sect. 3.6, Proposition 3.9, first sentence
   printed: From the reality of GBT-Bézier rotation surfaces which have various independent shape parameters, we can generate the desired shape of a rotation surface both locally and globally, by modifying shape control parameters.
   read as: Of one segment a shape parameter changes a part and leaves another: μ the part at its end of the line, and not the point of the parameter 2/3.
   stated: fails(D(FX'(0), mu) == 0) and at(D(FX(z), mu), z, 2/3) == 0 *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  ~ (forall (m : Z) (X : Z -> R) (mu : R) (nu : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (forall k : Z, (0 <= k <= m)%Z -> (2 <= m)%Z) ->
  Derive_n (fun mu => Derive_n (fun z => FX X m mu nu z) 1 0) 1 mu = 0) /\ (fun z : R => Derive_n (fun mu => FX X m mu nu z) 1 mu) (2 / 3) = 0.
End prop_3_9_a_one_segment.

Module prop_3_9_b.
(* gbt-surfaces/prop-3.9.b, Sect. 3.6, Proposition 3.9, second sentence
   printed: translational and rotation transformation allows us to transfer the GBT-Bézier rotation surfaces in any direction to a particular position
   read as: Any affine map, rigid motions among them; c and s are the two coefficients of (33).
   stated: A*[c*FX(z), s*FX(z), FZ(z)] + r == sum(k, 0, m, f[k,m](z, mu, nu)*(A*[c*X[k], s*X[k], Z[k]] + r)) *)
Definition A (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) : list (list R) :=
  [[c11; c12; c13]; [c21; c22; c23]; [c31; c32; c33]].
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (c : R) (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) (mu : R) (nu : R) (r'1 r'2 r'3 : R) (s : R) (z : R),
  let r := [r'1; r'2; r'3] in
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  vadd (mvec (A c11 c12 c13 c21 c22 c23 c31 c32 c33) [c * FX X m mu nu z; s * FX X m mu nu z; FZ Z_ m mu nu z]) r = vsum 3 0%Z m (fun k => vscale (f z mu nu k m) (vadd (mvec (A c11 c12 c13 c21 c22 c23 c31 c32 c33) [c * X k; s * X k; Z_ k]) r)).
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (c : R) (c11 : R) (c12 : R) (c13 : R) (c21 : R) (c22 : R) (c23 : R) (c31 : R) (c32 : R) (c33 : R) (mu : R) (nu : R) (r'1 r'2 r'3 : R) (s : R) (z : R),
  let r := [r'1; r'2; r'3] in
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1.
End prop_3_9_b.

Module alg_6.
(* gbt-surfaces/alg-6, Sect. 3.6, Algorithm 6
   printed: 1. Take GBTB functions with shape parameters μ,ν ∈ [-1, 1]. 2. Consider the control points {X_k, 0, Z_k} (k = 0, 1, ..., m) in the 3D plane. 3. Select μ, ν from [-1, 1]. 4. Calculate X_m(z) and Z_m(z) by (34). 5. Substitute into (33). 6. Plot these two functions and join them to obtain GBT-Bézier rotation surfaces in the XOZ plane.
   read as: Steps 4 to 6: for every point of the line (34) and every angle πq of a half turn one half is the line turned by it, the other the line turned back; together the whole turn.
   stated: T(FX(z), FZ(z), at_angle(q)) == [cos(pi*q)*FX(z), sin(pi*q)*FX(z), FZ(z)] and Tm(FX(z), FZ(z), at_angle(q)) == [cos(pi*q)*FX(z), -sin(pi*q)*FX(z), FZ(z)] *)
Definition statement : Prop :=
forall (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (q : R) (z : R),
  (2 <= m)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= q <= 1 ->
  0 <= z <= 1 ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  T (FX X m mu nu z) (FZ Z_ m mu nu z) (at_angle q) = [cos (PI * q) * FX X m mu nu z; sin (PI * q) * FX X m mu nu z; FZ Z_ m mu nu z] /\ Tm (FX X m mu nu z) (FZ Z_ m mu nu z) (at_angle q) = [cos (PI * q) * FX X m mu nu z; - sin (PI * q) * FX X m mu nu z; FZ Z_ m mu nu z].
Definition instance : Prop :=
exists (m : Z) (X : Z -> R) (Z_ : Z -> R) (mu : R) (nu : R) (q : R) (z : R),
  (2 <= m)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= q <= 1 /\
  0 <= z <= 1 /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0.
End alg_6.

Module eq_35.
(* gbt-surfaces/eq-35, Sect. 3.6, Example 3.6, eq. (35)
   printed: Q_0 = (4, 0, 15), Q_1 = (0, 0, 13), Q_2 = (0, 0, 10), Q_3 = (10, 0, 5), Q_4 = (4, 0, 0); control points Q_l (1 = 0, 1, 2, 3, 4) in the XOZ plane
   read as: The index list reads '(1 = 0, 1, 2, 3, 4)' in our copy. Stated: the points lie in the plane XOZ.
   stated: Q36*[0, 1, 0] == [0, 0, 0, 0, 0] *)
Definition statement : Prop :=
  mvec Q36 [0; 1; 0] = [0; 0; 0; 0; 0].
End eq_35.

Module ex_3_6_curve.
(* gbt-surfaces/ex-3.6.curve, Sect. 3.6, Example 3.6, display before eq. (36)
   printed: F_4(z,μ,ν) = {X_4(z), 0, Z_4(z)} (0 ≤ z ≤ 1)
   stated: F4(z)[2] == 0 and F4(0) == [4, 0, 15] and F4(1) == [4, 0, 0] *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z) ->
  entry (F4 mu nu z) 2 = 0 /\ F4 mu nu 0 = [4; 0; 15] /\ F4 mu nu 1 = [4; 0; 0].
Definition instance : Prop :=
exists (mu : R) (nu : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z).
End ex_3_6_curve.

Module eq_36.
(* gbt-surfaces/eq-36, Sect. 3.6, Example 3.6, eq. (36)
   printed: T^Z_rotation = { (1 - 2z_1)/(2z_1^2 - 2z_1 + 1) X_4(z), (2z_1 - 2z_1^2)/(2z_1^2 - 2z_1 + 1) X_4(z), Z_4(z) }, T~^Z_rotation = { (1 - 2z_1)/(2z_1^2 - 2z_1 + 1) X_4(z), - (2z_1 - 2z_1^2)/(2z_1^2 - 2z_1 + 1) X_4(z), Z_4(z) }
   read as: For every angle πq of a half turn one half is the line turned by it, the other the line turned back.
   stated: T(F4(z)[1], F4(z)[3], at_angle(q)) == [cos(pi*q)*F4(z)[1], sin(pi*q)*F4(z)[1], F4(z)[3]] and Tm(F4(z)[1], F4(z)[3], at_angle(q)) == [cos(pi*q)*F4(z)[1], -sin(pi*q)*F4(z)[1], F4(z)[3]] *)
Definition statement : Prop :=
forall (mu : R) (nu : R) (q : R) (z : R),
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= q <= 1 ->
  0 <= z <= 1 ->
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z) ->
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0 ->
  T (entry (F4 mu nu z) 1) (entry (F4 mu nu z) 3) (at_angle q) = [cos (PI * q) * entry (F4 mu nu z) 1; sin (PI * q) * entry (F4 mu nu z) 1; entry (F4 mu nu z) 3] /\ Tm (entry (F4 mu nu z) 1) (entry (F4 mu nu z) 3) (at_angle q) = [cos (PI * q) * entry (F4 mu nu z) 1; - sin (PI * q) * entry (F4 mu nu z) 1; entry (F4 mu nu z) 3].
Definition instance : Prop :=
exists (mu : R) (nu : R) (q : R) (z : R),
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= q <= 1 /\
  0 <= z <= 1 /\
  (forall k : Z, (0 <= k <= 4)%Z -> (1 <= (k + 1) <= 5)%Z) /\
  sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 /\
  2 * (at_angle q) ^ 2 - 2 * (at_angle q) + 1 <> 0.
End eq_36.
