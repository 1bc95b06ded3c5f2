(* Statements of splines, Part Cubic. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
End Definitions.
Import Definitions.

Module uniform_cubic.
(* splines/uniform.cubic, Cubic
   printed: The pieces are (1 - s)³/6, (3s³ - 6s² + 4)/6, (-3s³ + 3s² + 3s + 1)/6, s³/6.
   stated: [U[0,3](s), U[1,3](s), U[2,3](s), U[3,3](s)] == [(1 - s)^3/6, (3*s^3 - 6*s^2 + 4)/6, (-3*s^3 + 3*s^2 + 3*s + 1)/6, s^3/6] *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  [U s 0%Z 3%Z; U s 1%Z 3%Z; U s 2%Z 3%Z; U s 3%Z 3%Z] = [(1 - s) ^ 3 / 6; (3 * s ^ 3 - 6 * s ^ 2 + 4) / 6; (- 3 * s ^ 3 + 3 * s ^ 2 + 3 * s + 1) / 6; s ^ 3 / 6].
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_cubic.

Module uniform_cubic_slip.
(* splines/uniform.cubic.slip, Cubic
   printed: A common slip in the second piece: (3s³ - 6s² + 3)/6
   stated: U[1,3](s) == (3*s^3 - 6*s^2 + 3)/6 *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  U s 1%Z 3%Z = (3 * s ^ 3 - 6 * s ^ 2 + 3) / 6.
End uniform_cubic_slip.

Module uniform_cubic_slip_corrected.
(* splines/uniform.cubic.slip (corrected), Cubic
   printed: A common slip in the second piece: (3s³ - 6s² + 3)/6
   stated: U[1,3](s) == (3*s^3 - 6*s^2 + 4)/6 *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  U s 1%Z 3%Z = (3 * s ^ 3 - 6 * s ^ 2 + 4) / 6.
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_cubic_slip_corrected.
