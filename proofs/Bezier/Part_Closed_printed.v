(* Statements of bezier, Part Closed. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module bernstein_formula.
(* bezier/bernstein.formula, Closed form
   printed: B_{i,m}(x) = binom(m, i) x^i (1 - x)^(m - i)
   read as: As coefficients of the control points: both sides give the same curve for all control points.
   stated: C(x) == sum(i, 0, m, binom(m, i)*x^i*(1 - x)^(m - i)*P[i]) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (x : R),
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= i)%Z \/ x <> 0) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= (m - i)%Z)%Z \/ 1 - x <> 0) ->
  C_ P m x = sum 0%Z m (fun i => binom (IZR m) i * powerRZ x i * powerRZ (1 - x) (m - i)%Z * P i).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (x : R),
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= i)%Z \/ x <> 0) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= (m - i)%Z)%Z \/ 1 - x <> 0).
End bernstein_formula.
