(* Statements of splines, Part Symmetry. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module uniform_symmetry.
(* splines/uniform.symmetry, Symmetry
   printed: U_{i,3}(1 - s) = U_{3-i,3}(s) for 0 <= i <= 3
   stated: U[i,3](1 - s) == U[3-i,3](s) *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition statement : Prop :=
forall (i : Z) (s : R),
  (0 <= i <= 3)%Z ->
  0 <= s <= 1 ->
  U (1 - s) i 3%Z = U s (3 - i)%Z 3%Z.
Definition instance : Prop :=
exists (i : Z) (s : R),
  (0 <= i <= 3)%Z /\
  0 <= s <= 1.
End uniform_symmetry.
