(* Statements of bezier, Part Definition. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module bernstein_recursion.
(* bezier/bernstein.recursion, Definition
   printed: B_{i,m}(x) = (1 - x) B_{i,m-1}(x) + x B_{i-1,m-1}(x), B_{0,0} = 1
   stated: B[i,m](x) == (1 - x)*B[i,m-1](x) + x*B[i-1,m-1](x) and B[0,0](x) == 1 *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z ->
  (1 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z ->
  (0 <= m - 1)%Z ->
  B x i m = (1 - x) * B x i (m - 1)%Z + x * B x (i - 1)%Z (m - 1)%Z /\ B x 0%Z 0%Z = 1.
Definition instance : Prop :=
exists (i : Z) (m : Z) (x : R),
  (0 <= i <= m)%Z /\
  (1 <= m)%Z /\
  0 <= x <= 1 /\
  (0 <= m)%Z /\
  (0 <= m - 1)%Z.
End bernstein_recursion.
