(* Statements of bezier, Part C. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition S_ (R_ : Z -> R) (n : Z) (x : R) : R :=
  sum 0%Z n (fun i => B x i n * R_ i).
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition d1 (P : Z -> R) (m : Z) : R :=
  P m - P (m - 1)%Z.
Definition d2 (P : Z -> R) (m : Z) : R :=
  P m - 2 * P (m - 1)%Z + P (m - 2)%Z.
Definition T (x : R) (lambda : R) (mu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) ^ 2 * (1 - lambda * sin (PI / 2 * x)); sin (PI / 2 * x) * (1 - sin (PI / 2 * x)) * (2 + lambda - lambda * sin (PI / 2 * x)); cos (PI / 2 * x) * (1 - cos (PI / 2 * x)) * (2 + mu - mu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) ^ 2 * (1 - mu * cos (PI / 2 * x))] i k.
Definition G (R_ : Z -> R) (lambda2 : R) (mu2 : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => T x lambda2 mu2 i 3%Z * R_ i).
Definition F (P : Z -> R) (lambda : R) (mu : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => T x lambda mu i 3%Z * P i).
End Definitions.
Import Definitions.

Module join_C0.
(* bezier/join.C0, C0
   printed: R_0 = P_m
   stated: R[0] == P[m] *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  R_ 0%Z = P m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z.
End join_C0.

Module join_C1.
(* bezier/join.C1, C1
   printed: R_1 = P_m + (m/n) (P_m - P_{m-1})
   stated: R[1] == P[m] + m/n*(P[m] - P[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + IZR m / IZR n * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z.
End join_C1.

Module join_C1_slip.
(* bezier/join.C1.slip, C1
   printed: A common slip: R_1 = P_m + (n/m) (P_m - P_{m-1})
   stated: R[1] == P[m] + n/m*(P[m] - P[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR m <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + IZR n / IZR m * (P m - P (m - 1)%Z).
End join_C1_slip.

Module join_C1_slip_corrected.
(* bezier/join.C1.slip (corrected), C1
   printed: A common slip: R_1 = P_m + (n/m) (P_m - P_{m-1})
   stated: R[1] == P[m] + m/n*(P[m] - P[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + IZR m / IZR n * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z.
End join_C1_slip_corrected.

Module join_C2.
(* bezier/join.C2, C2
   printed: R_2 = P_m + 2 (m/n) Δ_1 + m(m-1)/(n(n-1)) Δ_2
   stated: R[2] == P[m] + 2*m/n*d1 + m*(m - 1)/(n*(n - 1))*d2 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  R_ 2%Z = P m + 2 * IZR m / IZR n * d1 P m + IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  IZR n * (IZR n - 1) <> 0 /\
  (0 <= m - 2 <= m)%Z.
End join_C2.

Module join_C2_slip.
(* bezier/join.C2.slip, C2
   printed: A common slip: R_2 = P_m + (m/n) Δ_1 + m(m-1)/(n(n-1)) Δ_2
   stated: R[2] == P[m] + m/n*d1 + m*(m - 1)/(n*(n - 1))*d2 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  R_ 2%Z = P m + IZR m / IZR n * d1 P m + IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m.
End join_C2_slip.

Module join_C2_slip_corrected.
(* bezier/join.C2.slip (corrected), C2
   printed: A common slip: R_2 = P_m + (m/n) Δ_1 + m(m-1)/(n(n-1)) Δ_2
   stated: R[2] == P[m] + 2*(m/n*d1) + m*(m - 1)/(n*(n - 1))*d2 *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  R_ 2%Z = P m + 2 * (IZR m / IZR n * d1 P m) + IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  IZR n * (IZR n - 1) <> 0 /\
  (0 <= m - 2 <= m)%Z.
End join_C2_slip_corrected.

Module join_C3.
(* bezier/join.C3, C3
   printed: R_3 = P_m + 3 (m/n) Δ_1 + 3 m(m-1)/(n(n-1)) Δ_2 + m(m-1)(m-2)/(n(n-1)(n-2)) Δ_3
   stated: R[3] == P[m] + 3*m/n*d1 + 3*m*(m - 1)/(n*(n - 1))*d2 + m*(m - 1)*(m - 2)/(n*(n - 1)*(n - 2))*d3 *)
Definition d3 (P : Z -> R) (m : Z) : R :=
  P m - 3 * P (m - 1)%Z + 3 * P (m - 2)%Z - P (m - 3)%Z.
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 ->
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 ->
  Derive_n (fun x => S_ R_ n x) 3 0 = Derive_n (fun x => C_ P m x) 3 1 ->
  (0 <= 3 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  IZR n * (IZR n - 1) * (IZR n - 2) <> 0 ->
  (0 <= m - 3 <= m)%Z ->
  R_ 3%Z = P m + 3 * IZR m / IZR n * d1 P m + 3 * IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m + IZR m * (IZR m - 1) * (IZR m - 2) / (IZR n * (IZR n - 1) * (IZR n - 2)) * d3 P m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\
  Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1 /\
  Derive_n (fun x => S_ R_ n x) 3 0 = Derive_n (fun x => C_ P m x) 3 1 /\
  (0 <= 3 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  IZR n * (IZR n - 1) <> 0 /\
  (0 <= m - 2 <= m)%Z /\
  IZR n * (IZR n - 1) * (IZR n - 2) <> 0 /\
  (0 <= m - 3 <= m)%Z.
End join_C3.

Module join_C2_sufficient.
(* bezier/join.C2.sufficient, C2, sufficiency
   printed: With these R_0, R_1, R_2 the two curves have the same derivatives up to order 2.
   stated: S(0) == C(1) and S'(0) == C'(1) and S''(0) == C''(1) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (0 <= 0 <= n)%Z ->
  (0 <= m <= m)%Z ->
  R_ 0%Z = P m ->
  (0 <= 1 <= n)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + IZR m / IZR n * d1 P m ->
  (0 <= 2 <= n)%Z ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 2 <= m)%Z ->
  R_ 2%Z = P m + 2 * IZR m / IZR n * d1 P m + IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 /\ Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => C_ P m x) 1 1 /\ Derive_n (fun x => S_ R_ n x) 2 0 = Derive_n (fun x => C_ P m x) 2 1.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (0 <= 0 <= n)%Z /\
  (0 <= m <= m)%Z /\
  R_ 0%Z = P m /\
  (0 <= 1 <= n)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  R_ 1%Z = P m + IZR m / IZR n * d1 P m /\
  (0 <= 2 <= n)%Z /\
  IZR n * (IZR n - 1) <> 0 /\
  (0 <= m - 2 <= m)%Z /\
  R_ 2%Z = P m + 2 * IZR m / IZR n * d1 P m + IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z).
End join_C2_sufficient.

Module join_knot.
(* bezier/join.knot, C1 with a knot ratio
   printed: R_1 = P_m + (m/n) (b/a) (P_m - P_{m-1}) for parameter intervals of the lengths a and b
   stated: R[1] == P[m] + m/n*b/a*(P[m] - P[m-1]) *)
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  b <> 0 ->
  a <> 0 ->
  1 / b * Derive_n (fun x => S_ R_ n x) 1 0 = 1 / a * Derive_n (fun x => C_ P m x) 1 1 ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + IZR m / IZR n * b / a * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  b <> 0 /\
  a <> 0 /\
  1 / b * Derive_n (fun x => S_ R_ n x) 1 0 = 1 / a * Derive_n (fun x => C_ P m x) 1 1 /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  (0 <= m - 1 <= m)%Z.
End join_knot.

Module trigonometric_C1.
(* bezier/trigonometric.C1, C1
   printed: R_1 = P_3 + (2 + μ)/(2 + λ_2) (P_3 - P_2)
   stated: R[1] == P[3] + (2 + mu)/(2 + lambda2)*(P[3] - P[2]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-2) <= lambda <= 1 ->
  (-2) <= lambda2 <= 1 ->
  (-2) <= mu <= 1 ->
  (-2) <= mu2 <= 1 ->
  G R_ lambda2 mu2 0 = F P lambda mu 1 ->
  Derive_n (fun x => G R_ lambda2 mu2 x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 ->
  2 + lambda2 <> 0 ->
  lambda2 + 2 <> 0 ->
  R_ 1%Z = P 3%Z + (2 + mu) / (2 + lambda2) * (P 3%Z - P 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-2) <= lambda <= 1 /\
  (-2) <= lambda2 <= 1 /\
  (-2) <= mu <= 1 /\
  (-2) <= mu2 <= 1 /\
  G R_ lambda2 mu2 0 = F P lambda mu 1 /\
  Derive_n (fun x => G R_ lambda2 mu2 x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 /\
  2 + lambda2 <> 0 /\
  lambda2 + 2 <> 0.
End trigonometric_C1.

Module trigonometric_C1_inside.
(* bezier/trigonometric.C1.inside, C1
   printed: R_1 = P_3 + (2 + μ)/(2 + λ_2) (P_3 - P_2) for λ_2 > -2
   stated: R[1] == P[3] + (2 + mu)/(2 + lambda2)*(P[3] - P[2]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-2) <= lambda <= 1 ->
  (-2) <= lambda2 <= 1 ->
  (-2) <= mu <= 1 ->
  (-2) <= mu2 <= 1 ->
  lambda2 > - 2 ->
  G R_ lambda2 mu2 0 = F P lambda mu 1 ->
  Derive_n (fun x => G R_ lambda2 mu2 x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 ->
  2 + lambda2 <> 0 ->
  R_ 1%Z = P 3%Z + (2 + mu) / (2 + lambda2) * (P 3%Z - P 2%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-2) <= lambda <= 1 /\
  (-2) <= lambda2 <= 1 /\
  (-2) <= mu <= 1 /\
  (-2) <= mu2 <= 1 /\
  lambda2 > - 2 /\
  G R_ lambda2 mu2 0 = F P lambda mu 1 /\
  Derive_n (fun x => G R_ lambda2 mu2 x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 /\
  2 + lambda2 <> 0.
End trigonometric_C1_inside.

Module trigonometric_bezier.
(* bezier/trigonometric.bezier, C1 with a classical curve
   printed: A Bézier curve of degree n continues the trigonometric one with R_1 = P_3 + π (2 + μ)/(2 n) (P_3 - P_2).
   stated: R[1] == P[3] + pi*(2 + mu)/(2*n)*(P[3] - P[2]) *)
Definition statement : Prop :=
forall (n : Z) (P : Z -> R) (R_ : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 ->
  (-2) <= mu <= 1 ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  S_ R_ n 0 = F P lambda mu 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 ->
  (0 <= 1 <= n)%Z ->
  2 * IZR n <> 0 ->
  R_ 1%Z = P 3%Z + PI * (2 + mu) / (2 * IZR n) * (P 3%Z - P 2%Z).
Definition instance : Prop :=
exists (n : Z) (P : Z -> R) (R_ : Z -> R) (lambda : R) (mu : R),
  (-2) <= lambda <= 1 /\
  (-2) <= mu <= 1 /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  S_ R_ n 0 = F P lambda mu 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = Derive_n (fun x => F P lambda mu x) 1 1 /\
  (0 <= 1 <= n)%Z /\
  2 * IZR n <> 0.
End trigonometric_bezier.
