(* Statements of hyperbolic, Part Joins. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (t : R) (a : R) : R :=
  ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition g (t : R) (a : R) : R :=
  2 * ((exp (a / 2) + exp (- (a / 2))) / 2) * ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) * ((exp (t / 2) - exp (- (t / 2))) / 2) / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition h (t : R) (a : R) : R :=
  ((exp (t / 2) - exp (- (t / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition G (R_ : Z -> R) (b : R) (t : R) : R :=
  f t b * R_ 0%Z + g t b * R_ 1%Z + h t b * R_ 2%Z.
Definition F (P : Z -> R) (a : R) (t : R) : R :=
  f t a * P 0%Z + g t a * P 1%Z + h t a * P 2%Z.
End Definitions.
Import Definitions.

Module join_C1.
(* hyperbolic/join.C1, Joins
   printed: R_1 = P_2 + tanh(b/2)/tanh(a/2) (P_2 - P_1)
   stated: R[1] == P[2] + tanh(b/2)/tanh(a/2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a ->
  0 < b ->
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  G R_ b 0 = F P a a ->
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a ->
  exp (b / 2) + exp (- (b / 2)) <> 0 ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2))) <> 0 ->
  R_ 1%Z = P 2%Z + (exp (b / 2) - exp (- (b / 2))) / (exp (b / 2) + exp (- (b / 2))) / ((exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2)))) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a /\
  0 < b /\
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  G R_ b 0 = F P a a /\
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a /\
  exp (b / 2) + exp (- (b / 2)) <> 0 /\
  exp (a / 2) + exp (- (a / 2)) <> 0 /\
  (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2))) <> 0.
End join_C1.

Module join_C1_slip.
(* hyperbolic/join.C1.slip, Joins
   printed: A common slip: R_1 = P_2 + tanh(a/2)/tanh(b/2) (P_2 - P_1)
   stated: R[1] == P[2] + tanh(a/2)/tanh(b/2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a ->
  0 < b ->
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  G R_ b 0 = F P a a ->
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  exp (b / 2) + exp (- (b / 2)) <> 0 ->
  (exp (b / 2) - exp (- (b / 2))) / (exp (b / 2) + exp (- (b / 2))) <> 0 ->
  R_ 1%Z = P 2%Z + (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2))) / ((exp (b / 2) - exp (- (b / 2))) / (exp (b / 2) + exp (- (b / 2)))) * (P 2%Z - P 1%Z).
End join_C1_slip.

Module join_C1_slip_corrected.
(* hyperbolic/join.C1.slip (corrected), Joins
   printed: A common slip: R_1 = P_2 + tanh(a/2)/tanh(b/2) (P_2 - P_1)
   stated: R[1] == P[2] + tanh(b/2)/tanh(a/2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a ->
  0 < b ->
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  G R_ b 0 = F P a a ->
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a ->
  exp (b / 2) + exp (- (b / 2)) <> 0 ->
  exp (a / 2) + exp (- (a / 2)) <> 0 ->
  (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2))) <> 0 ->
  R_ 1%Z = P 2%Z + (exp (b / 2) - exp (- (b / 2))) / (exp (b / 2) + exp (- (b / 2))) / ((exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2)))) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a /\
  0 < b /\
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  G R_ b 0 = F P a a /\
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a /\
  exp (b / 2) + exp (- (b / 2)) <> 0 /\
  exp (a / 2) + exp (- (a / 2)) <> 0 /\
  (exp (a / 2) - exp (- (a / 2))) / (exp (a / 2) + exp (- (a / 2))) <> 0.
End join_C1_slip_corrected.

Module join_C2.
(* hyperbolic/join.C2, Joins
   printed: R_2 = R_1 + cosh b (R_1 - P_2) + sinh²(b/2)/sinh²(a/2) (P_0 - P_1 + cosh a (P_2 - P_1))
   stated: R[2] == R[1] + cosh(b)*(R[1] - P[2]) + sinh(b/2)^2/sinh(a/2)^2*(P[0] - P[1] + cosh(a)*(P[2] - P[1])) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a ->
  0 < b ->
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  G R_ b 0 = F P a a ->
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a ->
  Derive_n (fun t => G R_ b t) 2 0 = Derive_n (fun t => F P a t) 2 a ->
  R_ 2%Z = R_ 1%Z + (exp b + exp (- b)) / 2 * (R_ 1%Z - P 2%Z) + ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 * (P 0%Z - P 1%Z + (exp a + exp (- a)) / 2 * (P 2%Z - P 1%Z)).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (a : R) (b : R),
  0 < a /\
  0 < b /\
  ((exp (b / 2) - exp (- (b / 2))) / 2) ^ 2 <> 0 /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 /\
  G R_ b 0 = F P a a /\
  Derive_n (fun t => G R_ b t) 1 0 = Derive_n (fun t => F P a t) 1 a /\
  Derive_n (fun t => G R_ b t) 2 0 = Derive_n (fun t => F P a t) 2 a.
End join_C2.

Module shape_join.
(* hyperbolic/shape.join, Joins
   printed: R_1 = P_m + (m - 2 + s)/(n - 2 + s_2)(P_m - P_{m-1})
   stated: R[1] == P[m] + (m - 2 + s)/(n - 2 + s2)*(P[m] - P[m-1]) *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition G (R_ : Z -> R) (n : Z) (omega2 : R) (u : R) : R :=
  sum 0%Z n (fun i => h u omega2 i n * R_ i).
Definition F (P : Z -> R) (m : Z) (omega : R) (u : R) : R :=
  sum 0%Z m (fun i => h u omega i m * P i).
Definition s2 (omega2 : R) : R :=
  omega2 * ((exp (omega2 / 2) + exp (- (omega2 / 2))) / 2) / ((exp (omega2 / 2) - exp (- (omega2 / 2))) / 2).
Definition s (omega : R) : R :=
  omega * ((exp (omega / 2) + exp (- (omega / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2).
Definition statement : Prop :=
forall (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (omega : R) (omega2 : R),
  (2 <= m)%Z ->
  (2 <= n)%Z ->
  0 < omega ->
  0 < omega2 ->
  (forall i : Z, (0 <= i <= n)%Z -> ((exp (omega2 / 2) - exp (- (omega2 / 2))) / 2) ^ 2 <> 0) ->
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) ->
  G R_ n omega2 0 = F P m omega 1 ->
  Derive_n (fun u => G R_ n omega2 u) 1 0 = Derive_n (fun u => F P m omega u) 1 1 ->
  (0 <= 1 <= n)%Z ->
  (0 <= m <= m)%Z ->
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 ->
  (exp (omega2 / 2) - exp (- (omega2 / 2))) / 2 <> 0 ->
  IZR n - 2 + s2 omega2 <> 0 ->
  (0 <= m - 1 <= m)%Z ->
  R_ 1%Z = P m + (IZR m - 2 + s omega) / (IZR n - 2 + s2 omega2) * (P m - P (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (n : Z) (P : Z -> R) (R_ : Z -> R) (omega : R) (omega2 : R),
  (2 <= m)%Z /\
  (2 <= n)%Z /\
  0 < omega /\
  0 < omega2 /\
  (forall i : Z, (0 <= i <= n)%Z -> ((exp (omega2 / 2) - exp (- (omega2 / 2))) / 2) ^ 2 <> 0) /\
  (forall i : Z, (0 <= i <= m)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) /\
  G R_ n omega2 0 = F P m omega 1 /\
  Derive_n (fun u => G R_ n omega2 u) 1 0 = Derive_n (fun u => F P m omega u) 1 1 /\
  (0 <= 1 <= n)%Z /\
  (0 <= m <= m)%Z /\
  (exp (omega / 2) - exp (- (omega / 2))) / 2 <> 0 /\
  (exp (omega2 / 2) - exp (- (omega2 / 2))) / 2 <> 0 /\
  IZR n - 2 + s2 omega2 <> 0 /\
  (0 <= m - 1 <= m)%Z.
End shape_join.
