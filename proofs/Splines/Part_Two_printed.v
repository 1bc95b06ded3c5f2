(* Statements of splines, Part Two. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition A (P : Z -> R) (s : R) : R :=
  sum 0%Z 2%Z (fun i => U s i 2%Z * P i).
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
Definition G (P : Z -> R) (m : R) (x : R) : R :=
  (1 - x) ^ 2 / (1 - m) * P 1%Z + ((x - m) * (1 - x) / (1 - m) ^ 2 + (1 - x) * x / (1 - m)) * P 2%Z + (x - m) ^ 2 / (1 - m) ^ 2 * P 3%Z.
End Definitions.
Import Definitions.

Module uniform_two_scale_quadratic.
(* splines/uniform.two.scale.quadratic, Two scales
   printed: Chaikin: A(s/2) is the spline with the points (3P_0 + P_1)/4, (P_0 + 3P_1)/4, (3P_1 + P_2)/4.
   stated: A(s/2) == U[0,2](s)*(3*P[0] + P[1])/4 + U[1,2](s)*(P[0] + 3*P[1])/4 + U[2,2](s)*(3*P[1] + P[2])/4 *)
Definition statement : Prop :=
forall (P : Z -> R) (s : R),
  0 <= s <= 1 ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) ->
  A P (s / 2) = U s 0%Z 2%Z * (3 * P 0%Z + P 1%Z) / 4 + U s 1%Z 2%Z * (P 0%Z + 3 * P 1%Z) / 4 + U s 2%Z 2%Z * (3 * P 1%Z + P 2%Z) / 4.
Definition instance : Prop :=
exists (P : Z -> R) (s : R),
  0 <= s <= 1 /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z).
End uniform_two_scale_quadratic.

Module uniform_two_scale_cubic.
(* splines/uniform.two.scale.cubic, Two scales
   printed: F(s/2) is the spline with the points (P_0 + P_1)/2, (P_0 + 6P_1 + P_2)/8, (P_1 + P_2)/2, (P_1 + 6P_2 + P_3)/8.
   stated: F(s/2) == U[0,3](s)*(P[0] + P[1])/2 + U[1,3](s)*(P[0] + 6*P[1] + P[2])/8 + U[2,3](s)*(P[1] + P[2])/2 + U[3,3](s)*(P[1] + 6*P[2] + P[3])/8 *)
Definition F (P : Z -> R) (s : R) : R :=
  sum 0%Z 3%Z (fun i => U s i 3%Z * P i).
Definition statement : Prop :=
forall (P : Z -> R) (s : R),
  0 <= s <= 1 ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  F P (s / 2) = U s 0%Z 3%Z * (P 0%Z + P 1%Z) / 2 + U s 1%Z 3%Z * (P 0%Z + 6 * P 1%Z + P 2%Z) / 8 + U s 2%Z 3%Z * (P 1%Z + P 2%Z) / 2 + U s 3%Z 3%Z * (P 1%Z + 6 * P 2%Z + P 3%Z) / 8.
Definition instance : Prop :=
exists (P : Z -> R) (s : R),
  0 <= s <= 1 /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_two_scale_cubic.

Module uniform_two_scale_slip.
(* splines/uniform.two.scale.slip, Two scales
   printed: A common slip: the points of A(s/2) are (2P_0 + P_1)/3, (P_0 + 2P_1)/3, (2P_1 + P_2)/3.
   stated: A(s/2) == U[0,2](s)*(2*P[0] + P[1])/3 + U[1,2](s)*(P[0] + 2*P[1])/3 + U[2,2](s)*(2*P[1] + P[2])/3 *)
Definition statement : Prop :=
forall (P : Z -> R) (s : R),
  0 <= s <= 1 ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i <= 4)%Z) ->
  A P (s / 2) = U s 0%Z 2%Z * (2 * P 0%Z + P 1%Z) / 3 + U s 1%Z 2%Z * (P 0%Z + 2 * P 1%Z) / 3 + U s 2%Z 2%Z * (2 * P 1%Z + P 2%Z) / 3.
End uniform_two_scale_slip.

Module clamped_unity.
(* splines/clamped.unity, Two spans
   printed: At a place x of either span, with the inner knot m, the functions add up to 1.
   stated: (m - x)^2/m^2 + (m - x)*x/m^2 + (1 - x)*x/m + x^2/m == 1 and (1 - x)^2/(1 - m) + (x - m)*(1 - x)/(1 - m)^2 + (1 - x)*x/(1 - m) + (x - m)^2/(1 - m)^2 == 1 *)
Definition statement : Prop :=
forall (m : R) (x : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  (m - x) ^ 2 / m ^ 2 + (m - x) * x / m ^ 2 + (1 - x) * x / m + x ^ 2 / m = 1 /\ (1 - x) ^ 2 / (1 - m) + (x - m) * (1 - x) / (1 - m) ^ 2 + (1 - x) * x / (1 - m) + (x - m) ^ 2 / (1 - m) ^ 2 = 1.
Definition instance : Prop :=
exists (m : R) (x : R),
  0 < m < 1 /\
  m ^ 2 <> 0 /\
  m <> 0 /\
  1 - m <> 0 /\
  (1 - m) ^ 2 <> 0.
End clamped_unity.

Module clamped_ends.
(* splines/clamped.ends, Two spans
   printed: F(0) = P_0, G(1) = P_3
   stated: F(0) == P[0] and G(1) == P[3] *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  F P m 0 = P 0%Z /\ G P m 1 = P 3%Z.
Definition instance : Prop :=
exists (P : Z -> R) (m : R),
  0 < m < 1 /\
  m ^ 2 <> 0 /\
  m <> 0 /\
  1 - m <> 0 /\
  (1 - m) ^ 2 <> 0.
End clamped_ends.

Module clamped_tangents.
(* splines/clamped.tangents, Two spans
   printed: F'(0) = 2(P_1 - P_0)/m, G'(1) = 2(P_3 - P_2)/(1 - m)
   stated: F'(0) == 2*(P[1] - P[0])/m and G'(1) == 2*(P[3] - P[2])/(1 - m) *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  Derive_n (fun x => F P m x) 1 0 = 2 * (P 1%Z - P 0%Z) / m /\ Derive_n (fun x => G P m x) 1 1 = 2 * (P 3%Z - P 2%Z) / (1 - m).
Definition instance : Prop :=
exists (P : Z -> R) (m : R),
  0 < m < 1 /\
  m ^ 2 <> 0 /\
  m <> 0 /\
  1 - m <> 0 /\
  (1 - m) ^ 2 <> 0.
End clamped_tangents.

Module clamped_tangents_slip.
(* splines/clamped.tangents.slip, Two spans
   printed: A common slip: F'(0) = 2(P_1 - P_0)
   stated: F'(0) == 2*(P[1] - P[0]) *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  Derive_n (fun x => F P m x) 1 0 = 2 * (P 1%Z - P 0%Z).
End clamped_tangents_slip.

Module clamped_C1.
(* splines/clamped.C1, Two spans
   printed: F(m) = G(m), F'(m) = G'(m)
   stated: F(m) == G(m) and F'(m) == G'(m) *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  F P m m = G P m m /\ Derive_n (fun x => F P m x) 1 m = Derive_n (fun x => G P m x) 1 m.
Definition instance : Prop :=
exists (P : Z -> R) (m : R),
  0 < m < 1 /\
  m ^ 2 <> 0 /\
  m <> 0 /\
  1 - m <> 0 /\
  (1 - m) ^ 2 <> 0.
End clamped_C1.

Module clamped_knot.
(* splines/clamped.knot, Two spans
   printed: F(m) = (1 - m)P_1 + m P_2
   stated: F(m) == (1 - m)*P[1] + m*P[2] *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  F P m m = (1 - m) * P 1%Z + m * P 2%Z.
Definition instance : Prop :=
exists (P : Z -> R) (m : R),
  0 < m < 1 /\
  m ^ 2 <> 0 /\
  m <> 0.
End clamped_knot.

Module clamped_C2.
(* splines/clamped.C2, Two spans
   printed: A common slip: F''(m) = G''(m)
   stated: F''(m) == G''(m) *)
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  Derive_n (fun x => F P m x) 2 m = Derive_n (fun x => G P m x) 2 m.
End clamped_C2.
