(* Statements of bezier, Part Numbers. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module exists_quotient_any.
(* bezier/exists.quotient.any, Numbers that there are
   printed: There is an r with r a = b: for all a but 0.
   stated: r*a == b *)
Definition statement : Prop :=
forall (a : R) (b : R),
  a <> 0 ->
  exists (r : R), r * a = b.
Definition instance : Prop :=
exists (a : R) (b : R),
  a <> 0.
End exists_quotient_any.

Module exists_above.
(* bezier/exists.above, Numbers that there are
   printed: For every a there is a number w > 0 with w > a.
   stated: w > a *)
Definition statement : Prop :=
forall (a : R),
  exists (w : R), 0 < w /\ w > a.
End exists_above.

Module exists_root.
(* bezier/exists.root, Numbers that there are
   printed: Every square is the square of a number k >= 0.
   stated: k^2 == a^2 *)
Definition statement : Prop :=
forall (a : R),
  exists (k : R), 0 <= k /\ k ^ 2 = a ^ 2.
End exists_root.

Module exists_none.
(* bezier/exists.none, Numbers that there are
   printed: A common slip: there is an r with r² = -1.
   stated: r^2 == -1 *)
Definition statement : Prop :=
  exists (r : R), r ^ 2 = - 1.
End exists_none.

Module exists_parallel.
(* bezier/exists.parallel, Numbers that there are
   printed: If p ≠ 0, and p and q are linearly dependent, then q = r p with an r.
   stated: q == r*p *)
Definition statement : Prop :=
forall (p'1 p'2 : R) (q'1 q'2 : R),
  let p := [p'1; p'2] in
  let q := [q'1; q'2] in
  dot p p > 0 ->
  entry p 1 * entry q 2 = entry p 2 * entry q 1 ->
  exists (r : R), q = vscale r p.
Definition instance : Prop :=
exists (p'1 p'2 : R) (q'1 q'2 : R),
  let p := [p'1; p'2] in
  let q := [q'1; q'2] in
  dot p p > 0 /\
  entry p 1 * entry q 2 = entry p 2 * entry q 1.
End exists_parallel.

Module exists_parallel_only.
(* bezier/exists.parallel.only, Numbers that there are
   printed: and if q = r p with an r they are linearly dependent.
   stated: p[1]*q[2] == p[2]*q[1] *)
Definition statement : Prop :=
forall (p'1 p'2 : R) (q'1 q'2 : R) (r : R),
  let p := [p'1; p'2] in
  let q := [q'1; q'2] in
  q = vscale r p ->
  entry p 1 * entry q 2 = entry p 2 * entry q 1.
Definition instance : Prop :=
exists (p'1 p'2 : R) (q'1 q'2 : R) (r : R),
  let p := [p'1; p'2] in
  let q := [q'1; q'2] in
  q = vscale r p.
End exists_parallel_only.
