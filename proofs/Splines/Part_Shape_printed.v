(* Statements of splines, Part Shape. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module uniform_line.
(* splines/uniform.line, Shape
   printed: If P_0, ..., P_3 are equally spaced points of a line, F(s) runs through it at constant speed: F(s) = P_1 + s(P_1 - P_0).
   stated: F(s) == P[1] + s*(P[1] - P[0]) *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition F (P : Z -> R) (s : R) : R :=
  sum 0%Z 3%Z (fun i => U s i 3%Z * P i).
Definition statement : Prop :=
forall (P : Z -> R) (s : R),
  0 <= s <= 1 ->
  P 2%Z = 2 * P 1%Z - P 0%Z ->
  P 3%Z = 3 * P 1%Z - 2 * P 0%Z ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  F P s = P 1%Z + s * (P 1%Z - P 0%Z).
Definition instance : Prop :=
exists (P : Z -> R) (s : R),
  0 <= s <= 1 /\
  P 2%Z = 2 * P 1%Z - P 0%Z /\
  P 3%Z = 3 * P 1%Z - 2 * P 0%Z /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_line.
