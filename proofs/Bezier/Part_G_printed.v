(* Statements of bezier, Part G. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module join_G2.
(* bezier/join.G2, G2, beta constraints
   printed: R_2 = P_m + (2 m β_1/n + m β_2/(n(n-1))) Δ_1 + β_1² m(m-1)/(n(n-1)) Δ_2
   stated: R[2] == P[m] + (2*m*beta1/n + m*beta2/(n*(n - 1)))*d1 + beta1^2*m*(m - 1)/(n*(n - 1))*d2 *)
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
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (beta1 : R) (beta2 : R),
  0 < beta1 ->
  (3 <= m)%Z ->
  (3 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  S_ R_ n 0 = C_ P m 1 ->
  Derive_n (fun x => S_ R_ n x) 1 0 = beta1 * Derive_n (fun x => C_ P m x) 1 1 ->
  Derive_n (fun x => S_ R_ n x) 2 0 = beta1 ^ 2 * Derive_n (fun x => C_ P m x) 2 1 + beta2 * Derive_n (fun x => C_ P m x) 1 1 ->
  (0 <= 2 <= n)%Z ->
  (0 <= m <= m)%Z ->
  IZR n <> 0 ->
  IZR n * (IZR n - 1) <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  (0 <= m - 2 <= m)%Z ->
  R_ 2%Z = P m + (2 * IZR m * beta1 / IZR n + IZR m * beta2 / (IZR n * (IZR n - 1))) * d1 P m + beta1 ^ 2 * IZR m * (IZR m - 1) / (IZR n * (IZR n - 1)) * d2 P m.
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (beta1 : R) (beta2 : R),
  0 < beta1 /\
  (3 <= m)%Z /\
  (3 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= n)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  S_ R_ n 0 = C_ P m 1 /\
  Derive_n (fun x => S_ R_ n x) 1 0 = beta1 * Derive_n (fun x => C_ P m x) 1 1 /\
  Derive_n (fun x => S_ R_ n x) 2 0 = beta1 ^ 2 * Derive_n (fun x => C_ P m x) 2 1 + beta2 * Derive_n (fun x => C_ P m x) 1 1 /\
  (0 <= 2 <= n)%Z /\
  (0 <= m <= m)%Z /\
  IZR n <> 0 /\
  IZR n * (IZR n - 1) <> 0 /\
  (0 <= m - 1 <= m)%Z /\
  (0 <= m - 2 <= m)%Z.
End join_G2.
