(* Statements of bezier, Part Reflection. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module curve_reflection.
(* bezier/curve.reflection, Reflection
   printed: The reversed control polygon gives the same curve, run through backwards.
   stated: sum(i, 0, m, B[i,m](x)*P[m-i]) == C(1 - x) *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition C_ (P : Z -> R) (m : Z) (x : R) : R :=
  sum 0%Z m (fun i => B x i m * P i).
Definition statement : Prop :=
forall (m : Z) (P : Z -> R) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) ->
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m - i <= m)%Z) ->
  sum 0%Z m (fun i => B x i m * P (m - i)%Z) = C_ P m (1 - x).
Definition instance : Prop :=
exists (m : Z) (P : Z -> R) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m)%Z) /\
  (forall i : Z, (0 <= i <= m)%Z -> (0 <= m - i <= m)%Z).
End curve_reflection.
