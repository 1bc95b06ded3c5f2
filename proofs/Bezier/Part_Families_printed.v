(* Statements of bezier, Part Families. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition Q (K : Z -> R) (a : R) (j : Z) : R :=
  (1 - a) * K j + a * K (j + 1)%Z.
End Definitions.
Import Definitions.

Module family_corner.
(* bezier/family.corner, Families
   printed: With Q_j = (1 - a) K_j + a K_{j+1}: Σ B_{j,m}(x) Q_j = (1 - a) Σ B_{j,m}(x) K_j + a Σ B_{j,m}(x) K_{j+1}
   stated: sum(j, 0, m, B[j,m](x)*Q[j]) == (1 - a)*sum(j, 0, m, B[j,m](x)*K[j]) + a*sum(j, 0, m, B[j,m](x)*K[j+1]) *)
Definition statement : Prop :=
forall (m : Z) (K : Z -> R) (a : R) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j + 1 <= m + 1)%Z) ->
  sum 0%Z m (fun j => B x j m * Q K a j) = (1 - a) * sum 0%Z m (fun j => B x j m * K j) + a * sum 0%Z m (fun j => B x j m * K (j + 1)%Z).
Definition instance : Prop :=
exists (m : Z) (K : Z -> R) (a : R) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j <= m + 1)%Z) /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j + 1 <= m + 1)%Z).
End family_corner.

Module family_casteljau.
(* bezier/family.casteljau, Families
   printed: With Q_j = (1 - a) K_j + a K_{j+1} at a = x: Σ B_{j,m}(x) Q_j = Σ B_{j,m+1}(x) K_j
   stated: sum(j, 0, m, B[j,m](x)*Q[j]) == sum(j, 0, m + 1, B[j,m+1](x)*K[j]) *)
Definition statement : Prop :=
forall (m : Z) (K : Z -> R) (a : R) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  a = x ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j + 1 <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= j <= m + 1)%Z) ->
  sum 0%Z m (fun j => B x j m * Q K a j) = sum 0%Z (m + 1)%Z (fun j => B x j (m + 1)%Z * K j).
Definition instance : Prop :=
exists (m : Z) (K : Z -> R) (a : R) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  a = x /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j <= m + 1)%Z) /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j + 1 <= m + 1)%Z) /\
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= m + 1)%Z) /\
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= j <= m + 1)%Z).
End family_casteljau.

Module family_casteljau_slip.
(* bezier/family.casteljau.slip, Families
   printed: A common slip: Σ B_{j,m}(x) Q_j = Σ B_{j,m+1}(x) K_j for all a
   stated: sum(j, 0, m, B[j,m](x)*Q[j]) == sum(j, 0, m + 1, B[j,m+1](x)*K[j]) *)
Definition statement : Prop :=
forall (m : Z) (K : Z -> R) (a : R) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j + 1 <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= m + 1)%Z) ->
  (forall j : Z, (0 <= j <= (m + 1))%Z -> (0 <= j <= m + 1)%Z) ->
  sum 0%Z m (fun j => B x j m * Q K a j) = sum 0%Z (m + 1)%Z (fun j => B x j (m + 1)%Z * K j).
End family_casteljau_slip.

Module family_weights.
(* bezier/family.weights, Families
   printed: A rational curve does not change if all weights are multiplied with a number b.
   stated: sum(j, 0, m, W[j]*B[j,m](x)*P[j])*sum(j, 0, m, w[j]*B[j,m](x)) == sum(j, 0, m, w[j]*B[j,m](x)*P[j])*sum(j, 0, m, W[j]*B[j,m](x)) *)
Definition W (b : R) (w : Z -> R) (j : Z) : R :=
  b * w j.
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (b : R) (w : Z -> R) (x : R),
  0 < b ->
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z) ->
  sum 0%Z m (fun j => W b w j * B x j m * P j) * sum 0%Z m (fun j => w j * B x j m) = sum 0%Z m (fun j => w j * B x j m * P j) * sum 0%Z m (fun j => W b w j * B x j m).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (b : R) (w : Z -> R) (x : R),
  0 < b /\
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= m)%Z).
End family_weights.
