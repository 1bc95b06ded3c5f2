(* Statements of bezier, Part Algebraic. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module reach_root.
(* bezier/reach.root, Algebraic hypotheses
   printed: If w² = a² + b², then (a/w)² + (b/w)² = 1.
   stated: (a/w)^2 + (b/w)^2 == 1 *)
Definition statement : Prop :=
forall (a : R) (b : R) (w : R),
  0 < w ->
  w ^ 2 = a ^ 2 + b ^ 2 ->
  w <> 0 ->
  (a / w) ^ 2 + (b / w) ^ 2 = 1.
Definition instance : Prop :=
exists (a : R) (b : R) (w : R),
  0 < w /\
  w ^ 2 = a ^ 2 + b ^ 2 /\
  w <> 0.
End reach_root.

Module reach_square.
(* bezier/reach.square, Algebraic hypotheses
   printed: If w² = 1/2, then w^4 = 1/4.
   stated: w^4 == 1/4 *)
Definition statement : Prop :=
forall (w : R),
  0 < w ->
  w ^ 2 = 1 / 2 ->
  w ^ 4 = 1 / 4.
Definition instance : Prop :=
exists (w : R),
  0 < w /\
  w ^ 2 = 1 / 2.
End reach_square.
