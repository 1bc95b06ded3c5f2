(* Statements of splines, Part One. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module clamped_bernstein.
(* splines/clamped.bernstein, One span
   printed: The functions of degree 3 are (1 - x)³, 3x(1 - x)², 3x²(1 - x), x³.
   stated: [B[0,3](x), B[1,3](x), B[2,3](x), B[3,3](x)] == [(1 - x)^3, 3*x*(1 - x)^2, 3*x^2*(1 - x), x^3] *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  counted (fun i k => 1 - x) (fun i k => x) [1] i k.
Definition statement : Prop :=
forall (x : R),
  [B x 0%Z 3%Z; B x 1%Z 3%Z; B x 2%Z 3%Z; B x 3%Z 3%Z] = [(1 - x) ^ 3; 3 * x * (1 - x) ^ 2; 3 * x ^ 2 * (1 - x); x ^ 3].
End clamped_bernstein.
