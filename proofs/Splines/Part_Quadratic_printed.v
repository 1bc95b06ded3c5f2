(* Statements of splines, Part Quadratic. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module uniform_quadratic.
(* splines/uniform.quadratic, Quadratic
   printed: The pieces are (1 - s)²/2, 1/2 + s(1 - s), s²/2.
   stated: [U[0,2](s), U[1,2](s), U[2,2](s)] == [(1 - s)^2/2, 1/2 + s*(1 - s), s^2/2] *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  [U s 0%Z 2%Z; U s 1%Z 2%Z; U s 2%Z 2%Z] = [(1 - s) ^ 2 / 2; 1 / 2 + s * (1 - s); s ^ 2 / 2].
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_quadratic.
