(* Statements of bezier, Part Roots. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module reach_unit.
(* bezier/reach.unit, Roots
   printed: p/|p| is one long, for p ≠ 0.
   stated: norm(p/norm(p)) == 1 *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R),
  let p := [p'1; p'2; p'3] in
  p <> [0; 0; 0] ->
  norm p <> 0 ->
  norm (vdiv p (norm p)) = 1.
Definition instance : Prop :=
exists (p'1 p'2 p'3 : R),
  let p := [p'1; p'2; p'3] in
  p <> [0; 0; 0] /\
  norm p <> 0.
End reach_unit.

Module reach_unit_zero.
(* bezier/reach.unit.zero, Roots
   printed: p/|p| is one long.
   stated: norm(p/norm(p)) == 1 *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R),
  let p := [p'1; p'2; p'3] in
  norm p <> 0 ->
  entry p 1 ^ 2 + entry p 2 ^ 2 + entry p 3 ^ 2 <> 0 ->
  norm (vdiv p (norm p)) = 1.
Definition instance : Prop :=
exists (p'1 p'2 p'3 : R),
  let p := [p'1; p'2; p'3] in
  norm p <> 0 /\
  entry p 1 ^ 2 + entry p 2 ^ 2 + entry p 3 ^ 2 <> 0.
End reach_unit_zero.

Module reach_size.
(* bezier/reach.size, Roots
   printed: |y z| = |y| |z|, and |y| = √(y²)
   stated: abs(y*z) == abs(y)*abs(z) and abs(y) == sqrt(y^2) *)
Definition statement : Prop :=
forall (y : R) (z : R),
  0 <= y * z * (y * z) ->
  0 <= y * y ->
  0 <= z * z ->
  0 <= y ^ 2 ->
  sqrt (y * z * (y * z)) = sqrt (y * y) * sqrt (z * z) /\ sqrt (y * y) = sqrt (y ^ 2).
Definition instance : Prop :=
exists (y : R) (z : R),
  0 <= y * z * (y * z) /\
  0 <= y * y /\
  0 <= z * z /\
  0 <= y ^ 2.
End reach_size.

Module reach_size_slip.
(* bezier/reach.size.slip, Roots
   printed: A common slip: √(y²) = y
   stated: sqrt(y^2) == y *)
Definition statement : Prop :=
forall (y : R),
  0 <= y ^ 2 ->
  sqrt (y ^ 2) = y.
End reach_size_slip.

Module reach_product.
(* bezier/reach.product, Roots
   printed: √A √B = √(A B) for A, B >= 0
   stated: sqrt(A)*sqrt(B) == sqrt(A*B) *)
Definition statement : Prop :=
forall (A : R) (B : R),
  0 <= A ->
  0 <= B ->
  0 <= A * B ->
  sqrt A * sqrt B = sqrt (A * B).
Definition instance : Prop :=
exists (A : R) (B : R),
  0 <= A /\
  0 <= B /\
  0 <= A * B.
End reach_product.

Module reach_least.
(* bezier/reach.least, Roots
   printed: √(y² + 1) > 0 and |y| >= 0
   stated: sqrt(y^2 + 1) > 0 and abs(y) >= 0 *)
Definition statement : Prop :=
forall (y : R),
  0 <= y ^ 2 + 1 ->
  0 <= y * y ->
  sqrt (y ^ 2 + 1) > 0 /\ sqrt (y * y) >= 0.
Definition instance : Prop :=
exists (y : R),
  0 <= y ^ 2 + 1 /\
  0 <= y * y.
End reach_least.

Module reach_triangle.
(* bezier/reach.triangle, Roots
   printed: |p + q| <= |p| + |q|
   stated: norm(p + q) <= norm(p) + norm(q) *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  norm (vadd p q) <= norm p + norm q.
End reach_triangle.

Module reach_triangle_slip.
(* bezier/reach.triangle.slip, Roots
   printed: A common slip: |p + q| < |p| + |q|
   stated: norm(p + q) < norm(p) + norm(q) *)
Definition statement : Prop :=
forall (p'1 p'2 p'3 : R) (q'1 q'2 q'3 : R),
  let p := [p'1; p'2; p'3] in
  let q := [q'1; q'2; q'3] in
  norm (vadd p q) < norm p + norm q.
End reach_triangle_slip.

Module reach_subadditive.
(* bezier/reach.subadditive, Roots
   printed: √(A + B) <= √A + √B for A, B >= 0
   stated: sqrt(A + B) <= sqrt(A) + sqrt(B) *)
Definition statement : Prop :=
forall (A : R) (B : R),
  0 <= A ->
  0 <= B ->
  0 <= A + B ->
  sqrt (A + B) <= sqrt A + sqrt B.
Definition instance : Prop :=
exists (A : R) (B : R),
  0 <= A /\
  0 <= B /\
  0 <= A + B.
End reach_subadditive.

Module reach_above.
(* bezier/reach.above, Roots
   printed: √(y² + 1) > |y| >= y
   stated: sqrt(y^2 + 1) > abs(y) and abs(y) >= y *)
Definition statement : Prop :=
forall (y : R),
  0 <= y ^ 2 + 1 ->
  0 <= y * y ->
  sqrt (y ^ 2 + 1) > sqrt (y * y) /\ sqrt (y * y) >= y.
Definition instance : Prop :=
exists (y : R),
  0 <= y ^ 2 + 1 /\
  0 <= y * y.
End reach_above.
