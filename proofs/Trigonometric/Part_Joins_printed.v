(* Statements of trigonometric, Part Joins. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition a (t : R) (lambda : R) : R :=
  (1 - sin t) * (1 - lambda * sin t).
Definition c (t : R) (mu : R) : R :=
  (1 - cos t) * (1 - mu * cos t).
Definition b (t : R) (lambda : R) (mu : R) : R :=
  1 - a t lambda - c t mu.
Definition G (R_ : Z -> R) (lambda2 : R) (mu2 : R) (t : R) : R :=
  a t lambda2 * R_ 0%Z + b t lambda2 mu2 * R_ 1%Z + c t mu2 * R_ 2%Z.
Definition F (P : Z -> R) (lambda : R) (mu : R) (t : R) : R :=
  a t lambda * P 0%Z + b t lambda mu * P 1%Z + c t mu * P 2%Z.
End Definitions.
Import Definitions.

Module quadratic_join.
(* trigonometric/quadratic.join, Joins
   printed: R_1 = P_2 + (1 + μ)/(1 + λ_2) (P_2 - P_1)
   stated: R[1] == P[2] + (1 + mu)/(1 + lambda2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-1) <= lambda <= 1 ->
  (-1) < lambda2 <= 1 ->
  (-1) <= mu <= 1 ->
  (-1) <= mu2 <= 1 ->
  G R_ lambda2 mu2 0 = F P lambda mu (PI / 2) ->
  Derive_n (fun t => G R_ lambda2 mu2 t) 1 0 = Derive_n (fun t => F P lambda mu t) 1 (PI / 2) ->
  1 + lambda2 <> 0 ->
  R_ 1%Z = P 2%Z + (1 + mu) / (1 + lambda2) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-1) <= lambda <= 1 /\
  (-1) < lambda2 <= 1 /\
  (-1) <= mu <= 1 /\
  (-1) <= mu2 <= 1 /\
  G R_ lambda2 mu2 0 = F P lambda mu (PI / 2) /\
  Derive_n (fun t => G R_ lambda2 mu2 t) 1 0 = Derive_n (fun t => F P lambda mu t) 1 (PI / 2) /\
  1 + lambda2 <> 0.
End quadratic_join.

Module quadratic_join_slip.
(* trigonometric/quadratic.join.slip, Joins
   printed: A common slip: R_1 = P_2 + (1 + λ_2)/(1 + μ) (P_2 - P_1)
   stated: R[1] == P[2] + (1 + lambda2)/(1 + mu)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-1) <= lambda <= 1 ->
  (-1) < lambda2 <= 1 ->
  (-1) <= mu <= 1 ->
  (-1) <= mu2 <= 1 ->
  G R_ lambda2 mu2 0 = F P lambda mu (PI / 2) ->
  Derive_n (fun t => G R_ lambda2 mu2 t) 1 0 = Derive_n (fun t => F P lambda mu t) 1 (PI / 2) ->
  1 + mu <> 0 ->
  R_ 1%Z = P 2%Z + (1 + lambda2) / (1 + mu) * (P 2%Z - P 1%Z).
End quadratic_join_slip.

Module quadratic_join_slip_corrected.
(* trigonometric/quadratic.join.slip (corrected), Joins
   printed: A common slip: R_1 = P_2 + (1 + λ_2)/(1 + μ) (P_2 - P_1)
   stated: R[1] == P[2] + (1 + mu)/(1 + lambda2)*(P[2] - P[1]) *)
Definition statement : Prop :=
forall (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-1) <= lambda <= 1 ->
  (-1) < lambda2 <= 1 ->
  (-1) <= mu <= 1 ->
  (-1) <= mu2 <= 1 ->
  G R_ lambda2 mu2 0 = F P lambda mu (PI / 2) ->
  Derive_n (fun t => G R_ lambda2 mu2 t) 1 0 = Derive_n (fun t => F P lambda mu t) 1 (PI / 2) ->
  1 + lambda2 <> 0 ->
  R_ 1%Z = P 2%Z + (1 + mu) / (1 + lambda2) * (P 2%Z - P 1%Z).
Definition instance : Prop :=
exists (P : Z -> R) (R_ : Z -> R) (lambda : R) (lambda2 : R) (mu : R) (mu2 : R),
  (-1) <= lambda <= 1 /\
  (-1) < lambda2 <= 1 /\
  (-1) <= mu <= 1 /\
  (-1) <= mu2 <= 1 /\
  G R_ lambda2 mu2 0 = F P lambda mu (PI / 2) /\
  Derive_n (fun t => G R_ lambda2 mu2 t) 1 0 = Derive_n (fun t => F P lambda mu t) 1 (PI / 2) /\
  1 + lambda2 <> 0.
End quadratic_join_slip_corrected.
