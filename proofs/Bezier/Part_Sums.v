(* Statements of bezier, Part Sums. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module sum_powers.
(* bezier/sum.powers, Sums
   printed: Σ j^3 = (m (m + 1)/2)^2, j from 1 to m
   stated: sum(j, 1, m, j^3) == (m*(m + 1)/2)^2 *)
Definition statement : Prop :=
forall (m : Z),
  (3 <= m)%Z ->
  sum 1%Z m (fun j => IZR j ^ 3) = (IZR m * (IZR m + 1) / 2) ^ 2.
Definition instance : Prop :=
exists (m : Z),
  (3 <= m)%Z.
End sum_powers.

Module sum_powers_slip.
(* bezier/sum.powers.slip, Sums
   printed: A common slip: Σ j² = m (m + 1)(2 m + 1)/3, j from 1 to m
   stated: sum(j, 1, m, j^2) == m*(m + 1)*(2*m + 1)/3 *)
Definition statement : Prop :=
forall (m : Z),
  (3 <= m)%Z ->
  sum 1%Z m (fun j => IZR j ^ 2) = IZR m * (IZR m + 1) * (2 * IZR m + 1) / 3.
End sum_powers_slip.

Module sum_powers_slip_corrected.
(* bezier/sum.powers.slip (corrected), Sums
   printed: A common slip: Σ j² = m (m + 1)(2 m + 1)/3, j from 1 to m
   stated: sum(j, 1, m, j^2) == m*(m + 1)*(2*m + 1)/6 *)
Definition statement : Prop :=
forall (m : Z),
  (3 <= m)%Z ->
  sum 1%Z m (fun j => IZR j ^ 2) = IZR m * (IZR m + 1) * (2 * IZR m + 1) / 6.
Definition instance : Prop :=
exists (m : Z),
  (3 <= m)%Z.
End sum_powers_slip_corrected.

Module sum_swap.
(* bezier/sum.swap, Sums
   printed: Σ_j Σ_{l<=j} P_l = Σ_j (m + 1 - j) P_j
   stated: sum(j, 0, m, sum(l, 0, j, P[l])) == sum(j, 0, m, (m + 1 - j)*P[j]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall j : Z, (0 <= j <= m)%Z -> forall l : Z, (0 <= l <= j)%Z -> (0 <= l <= m)%Z) ->
  sum 0%Z m (fun j => sum 0%Z j (fun l => P l)) = sum 0%Z m (fun j => (IZR m + 1 - IZR j) * P j).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall j : Z, (0 <= j <= m)%Z -> forall l : Z, (0 <= l <= j)%Z -> (0 <= l <= m)%Z).
End sum_swap.

Module sum_swap_weighted.
(* bezier/sum.swap.weighted, Sums
   printed: Σ_j Σ_{l<=j} (j - l) P_l = Σ_j (m - j)(m + 1 - j)/2 P_j
   stated: sum(j, 0, m, sum(l, 0, j, (j - l)*P[l])) == sum(j, 0, m, (m - j)*(m + 1 - j)/2*P[j]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall j : Z, (0 <= j <= m)%Z -> forall l : Z, (0 <= l <= j)%Z -> (0 <= l <= m)%Z) ->
  sum 0%Z m (fun j => sum 0%Z j (fun l => (IZR j - IZR l) * P l)) = sum 0%Z m (fun j => (IZR m - IZR j) * (IZR m + 1 - IZR j) / 2 * P j).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R),
  (3 <= m)%Z /\
  (forall j : Z, (0 <= j <= m)%Z -> forall l : Z, (0 <= l <= j)%Z -> (0 <= l <= m)%Z).
End sum_swap_weighted.

Module sum_swap_slip.
(* bezier/sum.swap.slip, Sums
   printed: A common slip: Σ_j Σ_{l<=j} P_l = Σ_j (m - j) P_j
   stated: sum(j, 0, m, sum(l, 0, j, P[l])) == sum(j, 0, m, (m - j)*P[j]) *)
Definition statement : Prop :=
forall (m : Z) (P : Z -> R),
  (3 <= m)%Z ->
  (forall j : Z, (0 <= j <= m)%Z -> forall l : Z, (0 <= l <= j)%Z -> (0 <= l <= m)%Z) ->
  sum 0%Z m (fun j => sum 0%Z j (fun l => P l)) = sum 0%Z m (fun j => (IZR m - IZR j) * P j).
End sum_swap_slip.
