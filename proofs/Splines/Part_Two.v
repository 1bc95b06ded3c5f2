(* Statements of splines, Part Two. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

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
Definition F (P : Z -> R) (m : R) (x : Z) : R :=
  (m - IZR x) ^ 2 / m ^ 2 * P 0%Z + ((m - IZR x) * IZR x / m ^ 2 + (1 - IZR x) * IZR x / m) * P 1%Z + IZR x ^ 2 / m * P 2%Z.
Definition G (P : Z -> R) (m : R) (x : Z) : R :=
  (1 - IZR x) ^ 2 / (1 - m) * P 1%Z + ((IZR x - m) * (1 - IZR x) / (1 - m) ^ 2 + (1 - IZR x) * IZR x / (1 - m)) * P 2%Z + (IZR x - m) ^ 2 / (1 - m) ^ 2 * P 3%Z.
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  F P m 0%Z = P 0%Z /\ G P m 1%Z = P 3%Z.
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
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
Definition G (P : Z -> R) (m : R) (x : R) : R :=
  (1 - x) ^ 2 / (1 - m) * P 1%Z + ((x - m) * (1 - x) / (1 - m) ^ 2 + (1 - x) * x / (1 - m)) * P 2%Z + (x - m) ^ 2 / (1 - m) ^ 2 * P 3%Z.
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  (let x := 0%Z in Derive_n (fun x_ => F P m x_) 1 (IZR x)) = 2 * (P 1%Z - P 0%Z) / m /\ (let x_ := 1%Z in Derive_n (fun x__ => G P m x__) 1 (IZR x_)) = 2 * (P 3%Z - P 2%Z) / (1 - m).
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
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  (let x := 0%Z in Derive_n (fun x_ => F P m x_) 1 (IZR x)) = 2 * (P 1%Z - P 0%Z).
End clamped_tangents_slip.

Module clamped_C1.
(* splines/clamped.C1, Two spans
   printed: F(m) = G(m), F'(m) = G'(m)
   stated: F(m) == G(m) and F'(m) == G'(m) *)
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
Definition G (P : Z -> R) (m : R) (x : R) : R :=
  (1 - x) ^ 2 / (1 - m) * P 1%Z + ((x - m) * (1 - x) / (1 - m) ^ 2 + (1 - x) * x / (1 - m)) * P 2%Z + (x - m) ^ 2 / (1 - m) ^ 2 * P 3%Z.
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
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
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
Definition F (P : Z -> R) (m : R) (x : R) : R :=
  (m - x) ^ 2 / m ^ 2 * P 0%Z + ((m - x) * x / m ^ 2 + (1 - x) * x / m) * P 1%Z + x ^ 2 / m * P 2%Z.
Definition G (P : Z -> R) (m : R) (x : R) : R :=
  (1 - x) ^ 2 / (1 - m) * P 1%Z + ((x - m) * (1 - x) / (1 - m) ^ 2 + (1 - x) * x / (1 - m)) * P 2%Z + (x - m) ^ 2 / (1 - m) ^ 2 * P 3%Z.
Definition statement : Prop :=
forall (P : Z -> R) (m : R),
  0 < m < 1 ->
  m ^ 2 <> 0 ->
  m <> 0 ->
  1 - m <> 0 ->
  (1 - m) ^ 2 <> 0 ->
  Derive_n (fun x => F P m x) 2 m = Derive_n (fun x => G P m x) 2 m.
End clamped_C2.
