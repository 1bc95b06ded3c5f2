(* Statements of hermite-developable, Section 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition q (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (u ^ 5) b5) (vscale (u ^ 4) b4)) (vscale (u ^ 3) b3)) (vscale (u ^ 2) b2)) (vscale u b1)) b0.
Definition dq (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition dp (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition q_ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : Z) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (IZR u ^ 5) b5) (vscale (IZR u ^ 4) b4)) (vscale (IZR u ^ 3) b3)) (vscale (IZR u ^ 2) b2)) (vscale (IZR u) b1)) b0.
Definition p_ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (u : Z) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (IZR u ^ 5) a5) (vscale (IZR u ^ 4) a4)) (vscale (IZR u ^ 3) a3)) (vscale (IZR u ^ 2) a2)) (vscale (IZR u) a1)) a0.
Definition criterion_ : R :=
  0.
Definition Q (P : list R) (lam : R) (o : list R) : list R :=
  vadd o (vscale lam (vsub P o)).
Definition P (o : list R) (x : list R) : list R :=
  vadd o x.
Definition f (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (u : R) : R :=
  f5 * u ^ 5 + f4 * u ^ 4 + f3 * u ^ 3 + f2 * u ^ 2 + f1 * u + f0.
Definition cone_normal (dx : list R) (x : list R) : list R :=
  cross dx x.
Definition cone_gap (dlam : R) (dx : list R) (k : R) (lam : R) (x : list R) : list R :=
  vsub (vadd (vscale lam x) (vadd (vscale dlam x) (vscale lam dx))) (vscale k (vadd x dx)).
Definition p (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (u : R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (u ^ 5) a5) (vscale (u ^ 4) a4)) (vscale (u ^ 3) a3)) (vscale (u ^ 2) a2)) (vscale u a1)) a0.
Definition g (g0 : list R) (g1 : list R) (g2 : list R) (g3 : list R) (g4 : list R) (g5 : list R) (u : R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (u ^ 5) g5) (vscale (u ^ 4) g4)) (vscale (u ^ 3) g3)) (vscale (u ^ 2) g2)) (vscale u g1)) g0.
Definition ruled (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (g0 : list R) (g1 : list R) (g2 : list R) (g3 : list R) (g4 : list R) (g5 : list R) (u : R) (v : R) : list R :=
  vadd (p a0 a1 a2 a3 a4 a5 u) (vscale v (g g0 g1 g2 g3 g4 g5 u)).
Definition gap (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) (u : R) : list R :=
  vsub (vsub (vadd (q b0 b1 b2 b3 b4 b5 u) (vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u)) (vscale k (vadd (p a0 a1 a2 a3 a4 a5 u) (vDerive 3 (fun u_ => p a0 a1 a2 a3 a4 a5 u_) 1 u)))) (vscale (1 - k) o).
Definition part (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => gap a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition criterion (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 5%Z.
Definition criterion__ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 4%Z.
Definition criterion___ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 3%Z.
Definition criterion____ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 2%Z.
Definition criterion_____ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 1%Z.
Definition criterion______ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (k : R) (o : list R) : list R :=
  part a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o 0%Z.
End Definitions.
Import Definitions.

Module def_3_1.
(* hermite-developable/def-3.1, Sect. 3, Definition 3.1
   printed: A regular ruled surface R(u,v) is a surface constructed by a one parameter of lines R(u,v) = p(u) + v . g(u) with p(u) and g(u) of class C^n and [(p'(u) + v . g'(u)) /\ g(u)] != 0
   stated: D(ruled(u, v), v, 2) == 0 and ruled(u, 0) == p(u) *)
Definition ruled_ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (g0 : list R) (g1 : list R) (g2 : list R) (g3 : list R) (g4 : list R) (g5 : list R) (u : R) (v : Z) : list R :=
  vadd (p a0 a1 a2 a3 a4 a5 u) (vscale (IZR v) (g g0 g1 g2 g3 g4 g5 u)).
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (g0'1 g0'2 g0'3 : R) (g1'1 g1'2 g1'3 : R) (g2'1 g2'2 g2'3 : R) (g3'1 g3'2 g3'3 : R) (g4'1 g4'2 g4'3 : R) (g5'1 g5'2 g5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let g0 := [g0'1; g0'2; g0'3] in
  let g1 := [g1'1; g1'2; g1'3] in
  let g2 := [g2'1; g2'2; g2'3] in
  let g3 := [g3'1; g3'2; g3'3] in
  let g4 := [g4'1; g4'2; g4'3] in
  let g5 := [g5'1; g5'2; g5'3] in
  0 < u < 1 ->
  vDerive 3 (fun v_ => ruled a0 a1 a2 a3 a4 a5 g0 g1 g2 g3 g4 g5 u v_) 2 v = zeros 3 /\ ruled_ a0 a1 a2 a3 a4 a5 g0 g1 g2 g3 g4 g5 u 0%Z = p a0 a1 a2 a3 a4 a5 u.
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (g0'1 g0'2 g0'3 : R) (g1'1 g1'2 g1'3 : R) (g2'1 g2'2 g2'3 : R) (g3'1 g3'2 g3'3 : R) (g4'1 g4'2 g4'3 : R) (g5'1 g5'2 g5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let g0 := [g0'1; g0'2; g0'3] in
  let g1 := [g1'1; g1'2; g1'3] in
  let g2 := [g2'1; g2'2; g2'3] in
  let g3 := [g3'1; g3'2; g3'3] in
  let g4 := [g4'1; g4'2; g4'3] in
  let g5 := [g5'1; g5'2; g5'3] in
  0 < u < 1.
End def_3_1.

Module def_3_1_normal.
(* hermite-developable/def-3.1.normal, Sect. 3, Definition 3.1, the vector that must not vanish
   printed: [(p'(u) + v . g'(u)) /\ g(u)] != 0
   read as: the vector that must not vanish is the normal vector of R: the vector product of its derivatives by u and by v
   stated: cross(D(ruled(u, v), u), D(ruled(u, v), v)) == cross(p'(u) + v*g'(u), g(u)) *)
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (g0'1 g0'2 g0'3 : R) (g1'1 g1'2 g1'3 : R) (g2'1 g2'2 g2'3 : R) (g3'1 g3'2 g3'3 : R) (g4'1 g4'2 g4'3 : R) (g5'1 g5'2 g5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let g0 := [g0'1; g0'2; g0'3] in
  let g1 := [g1'1; g1'2; g1'3] in
  let g2 := [g2'1; g2'2; g2'3] in
  let g3 := [g3'1; g3'2; g3'3] in
  let g4 := [g4'1; g4'2; g4'3] in
  let g5 := [g5'1; g5'2; g5'3] in
  0 < u < 1 ->
  cross (vDerive 3 (fun u_ => ruled a0 a1 a2 a3 a4 a5 g0 g1 g2 g3 g4 g5 u_ v) 1 u) (vDerive 3 (fun v_ => ruled a0 a1 a2 a3 a4 a5 g0 g1 g2 g3 g4 g5 u v_) 1 v) = cross (vadd (vDerive 3 (fun u_ => p a0 a1 a2 a3 a4 a5 u_) 1 u) (vscale v (vDerive 3 (fun u_ => g g0 g1 g2 g3 g4 g5 u_) 1 u))) (g g0 g1 g2 g3 g4 g5 u).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (g0'1 g0'2 g0'3 : R) (g1'1 g1'2 g1'3 : R) (g2'1 g2'2 g2'3 : R) (g3'1 g3'2 g3'3 : R) (g4'1 g4'2 g4'3 : R) (g5'1 g5'2 g5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let g0 := [g0'1; g0'2; g0'3] in
  let g1 := [g1'1; g1'2; g1'3] in
  let g2 := [g2'1; g2'2; g2'3] in
  let g3 := [g3'1; g3'2; g3'3] in
  let g4 := [g4'1; g4'2; g4'3] in
  let g5 := [g5'1; g5'2; g5'3] in
  0 < u < 1.
End def_3_1_normal.

Module def_3_2.
(* hermite-developable/def-3.2, Sect. 3, Definition 3.2
   printed: The ruled surface R(u,v) = p(u) + v.g is developable, if the tangent plane along each generatrix is constant that is the vectors [g'(u), p'(u), g] are coplanar
   stated: cross(normal(v), normal(w)) == (v - w)*det([dg, dp, ruling])*ruling *)
Definition normal (dg : list R) (dp : list R) (ruling : list R) (v : R) : list R :=
  cross (vadd dp (vscale v dg)) ruling.
Definition statement : Prop :=
forall (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (ruling'1 ruling'2 ruling'3 : R) (v : R) (w : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  cross (normal dg dp ruling v) (normal dg dp ruling w) = vscale ((v - w) * det [dg; dp; ruling]) ruling.
End def_3_2.

Module def_3_2_lincomb.
(* hermite-developable/def-3.2.lincomb, Sect. 3, paragraph after Definition 3.2
   printed: R(u,v) is developable if the vector g'(u) can be presented in linear combination of the vectors p'(u) and g(u) such that g'(u) = alpha(u) p'(u) + beta(u) g(u) with alpha(u) and beta(u) of real scalars
   stated: det([alpha*dp + beta*ruling, dp, ruling]) == 0 *)
Definition statement : Prop :=
forall (alpha : R) (beta : R) (dp'1 dp'2 dp'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dp := [dp'1; dp'2; dp'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  det [vadd (vscale alpha dp) (vscale beta ruling); dp; ruling] = 0.
End def_3_2_lincomb.

Module sec_3_g_boundary.
(* hermite-developable/sec-3.g-boundary, Sect. 3, paragraph before (3.1)
   printed: g(u) = q(u) - p(u)
   stated: ruled(u, 1) == q(u) and ruled(u, v) == (1 - v)*p(u) + v*q(u) *)
Definition g (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) : list R :=
  vsub (q b0 b1 b2 b3 b4 b5 u) (p a0 a1 a2 a3 a4 a5 u).
Definition ruled (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) (v : Z) : list R :=
  vadd (p a0 a1 a2 a3 a4 a5 u) (vscale (IZR v) (g a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u)).
Definition ruled_ (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) (v : R) : list R :=
  vadd (p a0 a1 a2 a3 a4 a5 u) (vscale v (g a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u)).
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1 ->
  ruled a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u 1%Z = q b0 b1 b2 b3 b4 b5 u /\ ruled_ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u v = vadd (vscale (1 - v) (p a0 a1 a2 a3 a4 a5 u)) (vscale v (q b0 b1 b2 b3 b4 b5 u)).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1.
End sec_3_g_boundary.

Module sec_3_g_prime.
(* hermite-developable/sec-3.g-prime, Sect. 3, formula in the text just before (3.1)
   printed: g'(u) = [alpha(u) + 1] p'(u) + beta(u) g(u)
   stated: (alpha + 1)*dp + beta*ruling == dg *)
Definition statement : Prop :=
forall (alpha : R) (beta : R) (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dg = vadd (vscale alpha dp) (vscale beta ruling) ->
  dq = vadd dp dg ->
  vadd (vscale (alpha + 1) dp) (vscale beta ruling) = dg.
End sec_3_g_prime.

Module sec_3_g_prime_corrected.
(* hermite-developable/sec-3.g-prime (corrected), Sect. 3, formula in the text just before (3.1)
   printed: g'(u) = [alpha(u) + 1] p'(u) + beta(u) g(u)
   stated: (alpha + 1)*dp + beta*ruling == dq *)
Definition statement : Prop :=
forall (alpha : R) (beta : R) (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dg = vadd (vscale alpha dp) (vscale beta ruling) ->
  dq = vadd dp dg ->
  vadd (vscale (alpha + 1) dp) (vscale beta ruling) = dq.
Definition instance : Prop :=
exists (alpha : R) (beta : R) (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dg = vadd (vscale alpha dp) (vscale beta ruling) /\
  dq = vadd dp dg.
End sec_3_g_prime_corrected.

Module eq_3_1.
(* hermite-developable/eq-3.1, Sect. 3, eq. (3.1)
   printed: q'(u) = rho(u) p'(u) + beta(u) g(u), with rho(u) and beta(u) of real scalars
   stated: dq == rho*dp + beta*ruling and det([rho*dp + beta*ruling - dp, dp, ruling]) == 0 *)
Definition rho (alpha : R) : R :=
  alpha + 1.
Definition statement : Prop :=
forall (alpha : R) (beta : R) (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dg = vadd (vscale alpha dp) (vscale beta ruling) ->
  dq = vadd dp dg ->
  dq = vadd (vscale (rho alpha) dp) (vscale beta ruling) /\ det [vsub (vadd (vscale (rho alpha) dp) (vscale beta ruling)) dp; dp; ruling] = 0.
Definition instance : Prop :=
exists (alpha : R) (beta : R) (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dg = vadd (vscale alpha dp) (vscale beta ruling) /\
  dq = vadd dp dg.
End eq_3_1.

Module eq_3_1_must.
(* hermite-developable/eq-3.1.must, Sect. 3, sentence before (3.1)
   printed: Consequently, this developable criteria of the surface R(u,v) must be [...] q'(u) = rho(u) p'(u) + beta(u) g(u)
   read as: on a regular surface: the vector of Definition 3.1 does not vanish at v = 0
   stated: dq == rho*dp + beta*ruling + det([dp, ruling, dq])/dot(normal, normal)*normal *)
Definition normal (dp : list R) (ruling : list R) : list R :=
  cross dp ruling.
Definition rho (dp : list R) (dq : list R) (ruling : list R) : R :=
  dot (cross dq ruling) (normal dp ruling) / dot (normal dp ruling) (normal dp ruling).
Definition beta (dp : list R) (dq : list R) (ruling : list R) : R :=
  dot (cross dp dq) (normal dp ruling) / dot (normal dp ruling) (normal dp ruling).
Definition statement : Prop :=
forall (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dot (normal dp ruling) (normal dp ruling) <> 0 ->
  dq = vadd (vadd (vscale (rho dp dq ruling) dp) (vscale (beta dp dq ruling) ruling)) (vscale (det [dp; ruling; dq] / dot (normal dp ruling) (normal dp ruling)) (normal dp ruling)).
Definition instance : Prop :=
exists (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dot (normal dp ruling) (normal dp ruling) <> 0.
End eq_3_1_must.

Module eq_3_1_types_a.
(* hermite-developable/eq-3.1.types.a, Sect. 3, first sentence after (3.1)
   printed: In general, Equation 3.1 defines the developable surfaces of the cylinder, cone, or tangent lines surface types
   read as: first half: curves on a cylinder, a cone, a tangent surface satisfy (3.1)
   stated: d_cylinder == dp + dlam/lam*(cylinder - P) and d_cone == lam*dp + dlam/(lam - 1)*(cone - P) and d_second == mu/lam*d_first + (1 + dmu - mu/lam*(1 + dlam))/(mu - lam)*(second - first) *)
Definition d_cylinder (c : list R) (dlam : R) (dp : list R) : list R :=
  vadd dp (vscale dlam c).
Definition cylinder (P : list R) (c : list R) (lam : R) : list R :=
  vadd P (vscale lam c).
Definition d_cone (P : list R) (dlam : R) (dp : list R) (lam : R) (o : list R) : list R :=
  vadd (vscale dlam (vsub P o)) (vscale lam dp).
Definition cone (P : list R) (lam : R) (o : list R) : list R :=
  vadd o (vscale lam (vsub P o)).
Definition d_second (ddp : list R) (dmu : R) (dp : list R) (mu : R) : list R :=
  vadd (vadd dp (vscale dmu dp)) (vscale mu ddp).
Definition d_first (ddp : list R) (dlam : R) (dp : list R) (lam : R) : list R :=
  vadd (vadd dp (vscale dlam dp)) (vscale lam ddp).
Definition second (P : list R) (dp : list R) (mu : R) : list R :=
  vadd P (vscale mu dp).
Definition first (P : list R) (dp : list R) (lam : R) : list R :=
  vadd P (vscale lam dp).
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (c'1 c'2 c'3 : R) (ddp'1 ddp'2 ddp'3 : R) (dlam : R) (dmu : R) (dp'1 dp'2 dp'3 : R) (lam : R) (mu : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let c := [c'1; c'2; c'3] in
  let ddp := [ddp'1; ddp'2; ddp'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let o := [o'1; o'2; o'3] in
  lam <> 0 ->
  lam <> 1 ->
  lam <> mu ->
  lam - 1 <> 0 ->
  mu - lam <> 0 ->
  d_cylinder c dlam dp = vadd dp (vscale (dlam / lam) (vsub (cylinder P c lam) P)) /\ d_cone P dlam dp lam o = vadd (vscale lam dp) (vscale (dlam / (lam - 1)) (vsub (cone P lam o) P)) /\ d_second ddp dmu dp mu = vadd (vscale (mu / lam) (d_first ddp dlam dp lam)) (vscale ((1 + dmu - mu / lam * (1 + dlam)) / (mu - lam)) (vsub (second P dp mu) (first P dp lam))).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (c'1 c'2 c'3 : R) (ddp'1 ddp'2 ddp'3 : R) (dlam : R) (dmu : R) (dp'1 dp'2 dp'3 : R) (lam : R) (mu : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let c := [c'1; c'2; c'3] in
  let ddp := [ddp'1; ddp'2; ddp'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let o := [o'1; o'2; o'3] in
  lam <> 0 /\
  lam <> 1 /\
  lam <> mu /\
  lam - 1 <> 0 /\
  mu - lam <> 0.
End eq_3_1_types_a.

Module eq_3_1_types_b.
(* hermite-developable/eq-3.1.types.b, Sect. 3, first sentence after (3.1)
   printed: In general, Equation 3.1 defines the developable surfaces of the cylinder, cone, or tangent lines surface types
   read as: second half: what (3.1) defines is of these types; 'in general' leaves patches aside that change their type. With g = q - p, g' = (rho - 1) p' + beta g, and the point e = ((rho - 1) p - g)/(rho - 1) of the generatrix, in homogeneous coordinates
   stated: weight*d_point - drho*point == (drho - weight*beta)*ruling and at(dg, rho, 1) == beta*ruling *)
Definition weight (rho : R) : R :=
  rho - 1.
Definition dg (beta : R) (dp : list R) (rho : R) (ruling : list R) : list R :=
  vadd (vscale (rho - 1) dp) (vscale beta ruling).
Definition d_point (P : list R) (beta : R) (dp : list R) (drho : R) (rho : R) (ruling : list R) : list R :=
  vsub (vadd (vscale drho P) (vscale (rho - 1) dp)) (dg beta dp rho ruling).
Definition point (P : list R) (rho : R) (ruling : list R) : list R :=
  vsub (vscale (rho - 1) P) ruling.
Definition dg_ (beta : R) (dp : list R) (ruling : list R) (rho : Z) : list R :=
  vadd (vscale (IZR rho - 1) dp) (vscale beta ruling).
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (beta : R) (dp'1 dp'2 dp'3 : R) (drho : R) (rho : R) (ruling'1 ruling'2 ruling'3 : R),
  let P := [P'1; P'2; P'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  vsub (vscale (weight rho) (d_point P beta dp drho rho ruling)) (vscale drho (point P rho ruling)) = vscale (drho - weight rho * beta) ruling /\ dg_ beta dp ruling 1%Z = vscale beta ruling.
End eq_3_1_types_b.

Module eq_3_1_parallel_planes.
(* hermite-developable/eq-3.1.parallel-planes, Sect. 3, second sentence after (3.1) (on Frey and Bindschadler [4])
   printed: Employing the tangent vector criteria q'(u) = rho(u) p'(u) of Equation (3.1), [...] developable [...] surfaces with the boundary curves in parallel planes
   stated: beta == 0 *)
Definition dq (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition dp (y1 : R) (z1 : R) : list R :=
  [0; y1; z1].
Definition ruling (gy : R) (gz : R) (h : R) : list R :=
  [h; gy; gz].
Definition statement : Prop :=
forall (beta : R) (gy : R) (gz : R) (h : R) (rho : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  h <> 0 ->
  entry (dq y2 z2) 1 = rho * entry (dp y1 z1) 1 + beta * entry (ruling gy gz h) 1 ->
  beta = 0.
Definition instance : Prop :=
exists (beta : R) (gy : R) (gz : R) (h : R) (rho : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  h <> 0 /\
  entry (dq y2 z2) 1 = rho * entry (dp y1 z1) 1 + beta * entry (ruling gy gz h) 1.
End eq_3_1_parallel_planes.

Module eq_3_1_rho_constant.
(* hermite-developable/eq-3.1.rho-constant, Sect. 3, third sentence after (3.1)
   printed: rho(u) real constant for modeling a cylinder and cone Hermite surfaces
   stated: q(u) - p(u) == q(0) - rho*p(0) - (1 - rho)*p(u) *)
Definition parallel (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (rho : R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => vsub (let u__ := u_ in vDerive 3 (fun u___ => q b0 b1 b2 b3 b4 b5 u___) 1 u__) (vscale rho (let u___ := u_ in vDerive 3 (fun u____ => p a0 a1 a2 a3 a4 a5 u____) 1 u___))) (Z.to_nat n) (IZR u)) (factorial n).
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (rho : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 4%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 3%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 2%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 1%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 0%Z = zeros 3 ->
  vsub (q b0 b1 b2 b3 b4 b5 u) (p a0 a1 a2 a3 a4 a5 u) = vsub (vsub (q_ b0 b1 b2 b3 b4 b5 0%Z) (vscale rho (p_ a0 a1 a2 a3 a4 a5 0%Z))) (vscale (1 - rho) (p a0 a1 a2 a3 a4 a5 u)).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (rho : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 4%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 3%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 2%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 1%Z = zeros 3 /\ parallel a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 rho 0%Z = zeros 3).
End eq_3_1_rho_constant.

Module eq_3_1_rho_quadratic.
(* hermite-developable/eq-3.1.rho-quadratic, Sect. 3, second sentence after (3.1)
   printed: Then, Kusno [8] use these criteria with rho(u) real constant, linear, and quadratic for modeling the developable Bézier
   read as: Where q'(u) = rho(u) p'(u) with a quadratic rho, a linear and a constant one among them, the patch is developable by Definition 3.2: the determinant of p', q' and q - p is zero.
   stated: det([dp, (r0 + r1*u + r2*u^2)*dp, Q - P]) == 0 *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (r0 : R) (r1 : R) (r2 : R) (u : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  0 < u < 1 ->
  det [dp; vscale (r0 + r1 * u + r2 * u ^ 2) dp; vsub Q P] = 0.
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (r0 : R) (r1 : R) (r2 : R) (u : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  0 < u < 1.
End eq_3_1_rho_quadratic.

Module eq_3_1_difficulties_same.
(* hermite-developable/eq-3.1.difficulties.same, Sect. 3, fourth sentence after (3.1)
   printed: The criterion (3.3) ties the points of both curves in the same way as the tangent vector criterion with rho = k constant: its Hermite curves are those with q' = k p' whose start points satisfy q(0) - o = k (p(0) - o).
   stated: q'(u) == k*p'(u) and q(0) - o == k*(p(0) - o) and q(1/2) - q(0) == k*(p(1/2) - p(0)) and q(1) - q(0) == k*(p(1) - p(0)) *)
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 ->
  vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u = vscale k (vDerive 3 (fun u_ => p a0 a1 a2 a3 a4 a5 u_) 1 u) /\ vsub (q_ b0 b1 b2 b3 b4 b5 0%Z) o = vscale k (vsub (p_ a0 a1 a2 a3 a4 a5 0%Z) o) /\ vsub (q b0 b1 b2 b3 b4 b5 (1 / 2)) (q_ b0 b1 b2 b3 b4 b5 0%Z) = vscale k (vsub (p a0 a1 a2 a3 a4 a5 (1 / 2)) (p_ a0 a1 a2 a3 a4 a5 0%Z)) /\ vsub (q_ b0 b1 b2 b3 b4 b5 1%Z) (q_ b0 b1 b2 b3 b4 b5 0%Z) = vscale k (vsub (p_ a0 a1 a2 a3 a4 a5 1%Z) (p_ a0 a1 a2 a3 a4 a5 0%Z)).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3).
End eq_3_1_difficulties_same.

Module eq_3_2.
(* hermite-developable/eq-3.2, Sect. 3, eq. (3.2)
   printed: q'(u) = k p'(u) - g(u), with k constant
   read as: with g = q - p, the generatrix of (3.1)
   stated: det([dq - dp, dp, ruling]) == 0 *)
Definition statement : Prop :=
forall (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (ruling'1 ruling'2 ruling'3 : R),
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling ->
  det [vsub dq dp; dp; ruling] = 0.
Definition instance : Prop :=
exists (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (ruling'1 ruling'2 ruling'3 : R),
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling.
End eq_3_2.

Module eq_3_2_edge.
(* hermite-developable/eq-3.2.edge, Sect. 3, eq. (3.2)
   printed: Curves that satisfy (3.2) with g = q - p and k != 1 lie on a tangent surface, never on a cone: its generatrices are the tangents of the curve p - g/(k - 1), whose derivative is g/(k - 1).
   stated: dp - dg/(k - 1) == ruling/(k - 1) *)
Definition statement : Prop :=
forall (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  k <> 1 ->
  dq = vsub (vscale k dp) ruling ->
  dg = vsub dq dp ->
  k - 1 <> 0 ->
  vsub dp (vdiv dg (k - 1)) = vdiv ruling (k - 1).
Definition instance : Prop :=
exists (dg'1 dg'2 dg'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (ruling'1 ruling'2 ruling'3 : R),
  let dg := [dg'1; dg'2; dg'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  k <> 1 /\
  dq = vsub (vscale k dp) ruling /\
  dg = vsub dq dp /\
  k - 1 <> 0.
End eq_3_2_edge.

Module eq_3_2_planes_a_generatrix.
(* hermite-developable/eq-3.2.planes.a.generatrix, Sect. 3, sentence before (3.2)
   printed: To control the position and shapes of a developable surface bounded by two parallel and oblique planes, we introduce the new developable criteria [...]. These criteria can facilitate to arrange the boundary curves' tangent vectors and the surface's generatrix with both boundary curves placed in the different planes, that is q'(u) = k p'(u) - g(u)
   read as: g is q - p, as it is defined before (3.1) and used in (3.4)
   stated: fails(h == 0) *)
Definition Q (h : R) (x0 : R) (y1 : R) (z1 : R) : list R :=
  [x0 + h; y1; z1].
Definition P (x0 : R) (y0 : R) (z0 : R) : list R :=
  [x0; y0; z0].
Definition statement : Prop :=
forall (h : R) (k : R) (x0 : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  0 < k ->
  k <> 1 ->
  dq y3 z3 = vsub (vscale k (dp y2 z2)) (vsub (Q h x0 y1 z1) (P x0 y0 z0)) ->
  ~ (forall (h : R) (k : R) (x0 : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  0 < k ->
  k <> 1 ->
  dq y3 z3 = vsub (vscale k (dp y2 z2)) (vsub (Q h x0 y1 z1) (P x0 y0 z0)) ->
  h = 0).
End eq_3_2_planes_a_generatrix.

Module eq_3_2_planes_a_direction.
(* hermite-developable/eq-3.2.planes.a.direction, Sect. 3, sentence before (3.2)
   printed: To control the position and shapes of a developable surface bounded by two parallel and oblique planes, we introduce the new developable criteria [...]. These criteria can facilitate to arrange the boundary curves' tangent vectors and the surface's generatrix with both boundary curves placed in the different planes, that is q'(u) = k p'(u) - g(u)
   read as: g is the vector that the next sentence determines
   stated: fails(h == 0) *)
Definition Q (h : R) (x0 : R) (y1 : R) (z1 : R) : list R :=
  [x0 + h; y1; z1].
Definition P (x0 : R) (y0 : R) (z0 : R) : list R :=
  [x0; y0; z0].
Definition statement : Prop :=
forall (h : R) (k : R) (o'1 o'2 o'3 : R) (x0 : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  0 < k ->
  k <> 1 ->
  dq y3 z3 = vsub (vscale k (dp y2 z2)) (vsub (vsub (Q h x0 y1 z1) o) (vscale k (vsub (P x0 y0 z0) o))) ->
  ~ (forall (h : R) (k : R) (o'1_ o'2_ o'3_ : R) (x0 : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1_; o'2_; o'3_] in
  0 < k ->
  k <> 1 ->
  dq y3 z3 = vsub (vscale k (dp y2 z2)) (vsub (vsub (Q h x0 y1 z1) o) (vscale k (vsub (P x0 y0 z0) o))) ->
  h = 0).
Definition instance : Prop :=
exists (h : R) (k : R) (o'1 o'2 o'3 : R) (x0 : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R),
  let o := [o'1; o'2; o'3] in
  0 < k /\
  k <> 1 /\
  dq y3 z3 = vsub (vscale k (dp y2 z2)) (vsub (vsub (Q h x0 y1 z1) o) (vscale k (vsub (P x0 y0 z0) o))).
End eq_3_2_planes_a_direction.

Module eq_3_2_planes_b_generatrix.
(* hermite-developable/eq-3.2.planes.b.generatrix, Sect. 3, sentence before (3.2)
   printed: To control the position and shapes of a developable surface bounded by two parallel and oblique planes, we introduce the new developable criteria [...]. These criteria can facilitate to arrange the boundary curves' tangent vectors and the surface's generatrix with both boundary curves placed in the different planes, that is q'(u) = k p'(u) - g(u)
   read as: g is q - p, as it is defined before (3.1) and used in (3.4): the component of (3.2) across the plane of q is f + k f' = 0
   stated: fails(f'(u) == 0) *)
Definition across (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (u : R) : R :=
  f f0 f1 f2 f3 f4 f5 u + k * Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u.
Definition part (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => across f0 f1 f2 f3 f4 f5 k u_) (Z.to_nat n) (IZR u) / factorial n.
Definition statement : Prop :=
forall (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (u : R),
  0 < k ->
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part f0 f1 f2 f3 f4 f5 k 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 0%Z = 0 ->
  ~ (forall (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (u : R),
  0 < k ->
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part f0 f1 f2 f3 f4 f5 k 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k 0%Z = 0 ->
  Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u = 0).
End eq_3_2_planes_b_generatrix.

Module eq_3_2_planes_b_direction.
(* hermite-developable/eq-3.2.planes.b.direction, Sect. 3, sentence before (3.2)
   printed: To control the position and shapes of a developable surface bounded by two parallel and oblique planes, we introduce the new developable criteria [...]. These criteria can facilitate to arrange the boundary curves' tangent vectors and the surface's generatrix with both boundary curves placed in the different planes, that is q'(u) = k p'(u) - g(u)
   read as: g is the vector that the next sentence determines: the component of (3.2) across the plane of q is k f + k f' = (1 - k) s, where s is the distance of that plane from the summit
   stated: fails(f'(u) == 0) *)
Definition across (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R) : R :=
  k * f f0 f1 f2 f3 f4 f5 u + k * Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u - (1 - k) * s.
Definition part (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => across f0 f1 f2 f3 f4 f5 k s u_) (Z.to_nat n) (IZR u) / factorial n.
Definition statement : Prop :=
forall (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R),
  0 < k ->
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part f0 f1 f2 f3 f4 f5 k s 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 0%Z = 0 ->
  ~ (forall (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R),
  0 < k ->
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part f0 f1 f2 f3 f4 f5 k s 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 0%Z = 0 ->
  Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u = 0).
End eq_3_2_planes_b_direction.

Module eq_3_2_planes_parallel.
(* hermite-developable/eq-3.2.planes.parallel, Sect. 3, sentence before (3.2)
   printed: With h = (q - o) - k (p - o) in the place of g the criterion (3.2) puts the Hermite curve p into a plane parallel to that of a plane Hermite curve q, at (k - 1)/k of the way to the parallel plane through the summit.
   stated: f'(u) == 0 and f(u) == (k - 1)/k*s *)
Definition across (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R) : R :=
  k * Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u - (0 - s - k * (f f0 f1 f2 f3 f4 f5 u - s)).
Definition part (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (n : Z) : R :=
  let u := 0%Z in Derive_n (fun u_ => across f0 f1 f2 f3 f4 f5 k s u_) (Z.to_nat n) (IZR u) / factorial n.
Definition statement : Prop :=
forall (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R),
  0 < u < 1 ->
  k > 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  part f0 f1 f2 f3 f4 f5 k s 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 0%Z = 0 ->
  k <> 0 ->
  Derive_n (fun u_ => f f0 f1 f2 f3 f4 f5 u_) 1 u = 0 /\ f f0 f1 f2 f3 f4 f5 u = (k - 1) / k * s.
Definition instance : Prop :=
exists (f0 : R) (f1 : R) (f2 : R) (f3 : R) (f4 : R) (f5 : R) (k : R) (s : R) (u : R),
  0 < u < 1 /\
  k > 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (part f0 f1 f2 f3 f4 f5 k s 5%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 4%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 3%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 2%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 1%Z = 0 /\ part f0 f1 f2 f3 f4 f5 k s 0%Z = 0) /\
  k <> 0.
End eq_3_2_planes_parallel.

Module eq_3_2_with_h.
(* hermite-developable/eq-3.2.with-h, Sect. 3, eqs. (3.2) and (3.3)
   printed: With h = (q - o) - k (p - o) in the place of g (3.2) is (3.3); on a cone with the summit o it is of the form (3.1).
   stated: Q - o + dq == k*(P - o + dp) and Q + dq == k*(P + dp) + (1 - k)*o and (lam - 1)*(lam*(P - o) - k*(P - o)) == (lam - k)*(o + lam*(P - o) - P) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (hv'1 hv'2 hv'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let hv := [hv'1; hv'2; hv'3] in
  let o := [o'1; o'2; o'3] in
  hv = vsub (vsub Q o) (vscale k (vsub P o)) ->
  dq = vsub (vscale k dp) hv ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) /\ vadd Q dq = vadd (vscale k (vadd P dp)) (vscale (1 - k) o) /\ vscale (lam - 1) (vsub (vscale lam (vsub P o)) (vscale k (vsub P o))) = vscale (lam - k) (vsub (vadd o (vscale lam (vsub P o))) P).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (hv'1 hv'2 hv'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let hv := [hv'1; hv'2; hv'3] in
  let o := [o'1; o'2; o'3] in
  hv = vsub (vsub Q o) (vscale k (vsub P o)) /\
  dq = vsub (vscale k dp) hv.
End eq_3_2_with_h.

Module eq_3_2_across.
(* hermite-developable/eq-3.2.across, Sect. 3, eq. (3.2)
   printed: With q in the plane through a point c across a vector m, the component of (3.2), g = q - p, across that plane is f + k f' = 0 for the distance f of p from it.
   stated: dot(m, P - c) + k*dot(m, dp) == dot(m, Q - c) + dot(m, dq) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (c'1 c'2 c'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (m'1 m'2 m'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let c := [c'1; c'2; c'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let m := [m'1; m'2; m'3] in
  dq = vsub (vscale k dp) (vsub Q P) ->
  dot m (vsub P c) + k * dot m dp = dot m (vsub Q c) + dot m dq.
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (c'1 c'2 c'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (m'1 m'2 m'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let c := [c'1; c'2; c'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let m := [m'1; m'2; m'3] in
  dq = vsub (vscale k dp) (vsub Q P).
End eq_3_2_across.

Module eq_3_2_across_summit.
(* hermite-developable/eq-3.2.across.summit, Sect. 3, eq. (3.2)
   printed: With q in the plane through a point c across a vector m, the component of (3.2), g = (q - o) - k (p - o), across that plane is k f + k f' = (1 - k) s for the distances f of p from it and s of it from o.
   stated: k*dot(m, P - c) + k*dot(m, dp) - (1 - k)*dot(m, c - o) == dot(m, Q - c) + dot(m, dq) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (c'1 c'2 c'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (m'1 m'2 m'3 : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let c := [c'1; c'2; c'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let m := [m'1; m'2; m'3] in
  let o := [o'1; o'2; o'3] in
  dq = vsub (vscale k dp) (vsub (vsub Q o) (vscale k (vsub P o))) ->
  k * dot m (vsub P c) + k * dot m dp - (1 - k) * dot m (vsub c o) = dot m (vsub Q c) + dot m dq.
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (c'1 c'2 c'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (m'1 m'2 m'3 : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let c := [c'1; c'2; c'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let m := [m'1; m'2; m'3] in
  let o := [o'1; o'2; o'3] in
  dq = vsub (vscale k dp) (vsub (vsub Q o) (vscale k (vsub P o))).
End eq_3_2_across_summit.

Module eq_3_2_every_degree.
(* hermite-developable/eq-3.2.every-degree, Sect. 3, eqs. (3.2), (3.3)
   printed: A polynomial f with f + c f' = 0 for a number c vanishes: the leading coefficient of f + c f' is that of f, at every degree.
   stated: leading(c) == d[n] *)
Definition H (d : Z -> R) (n : Z) (s : Z) (u : Z) : R :=
  sum 0%Z n (fun i => binom (IZR n) i * powerRZ (IZR s) (n - i)%Z * powerRZ (IZR u) i * d i).
Definition H_ (d : Z -> R) (n : Z) (s : Z) (u : R) : R :=
  sum 0%Z n (fun i => binom (IZR n) i * powerRZ (IZR s) (n - i)%Z * powerRZ u i * d i).
Definition leading (d : Z -> R) (n : Z) (c : R) : R :=
  let u := 1%Z in let s := 0%Z in H d n s u + c * IZR s * Derive_n (fun u_ => H_ d n s u_) 1 (IZR u).
Definition statement : Prop :=
forall (n : Z) (c : R) (d : Z -> R),
  (1 <= n)%Z ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= (n - i)%Z)%Z \/ IZR 0%Z <> 0) ->
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= i)%Z \/ IZR 1%Z <> 0) ->
  locally (IZR 1%Z) (fun u => forall i : Z, (0 <= i <= n)%Z -> (0 <= i)%Z \/ u <> 0) ->
  (0 <= n <= n)%Z ->
  leading d n c = d n.
Definition instance : Prop :=
exists (n : Z) (c : R) (d : Z -> R),
  (1 <= n)%Z /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= (n - i)%Z)%Z \/ IZR 0%Z <> 0) /\
  (forall i : Z, (0 <= i <= n)%Z -> (0 <= i)%Z \/ IZR 1%Z <> 0) /\
  locally (IZR 1%Z) (fun u => forall i : Z, (0 <= i <= n)%Z -> (0 <= i)%Z \/ u <> 0) /\
  (0 <= n <= n)%Z.
End eq_3_2_every_degree.

Module eq_3_3_g_generatrix.
(* hermite-developable/eq-3.3.g.generatrix, Sect. 3, sentence before (3.3a)
   printed: If the generatrix lines g(u) of developable surface are defined from the summit point O of the cone developable surface [...], then we can determine g(u) = [q(u) - o] - k [p(u) - o]
   read as: g is q - p, as it is defined before (3.1) and used in (3.4); q is on the cone through p with the summit o
   stated: Q - P == Q - o - k*(P - o) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (dp'1 dp'2 dp'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let o := [o'1; o'2; o'3] in
  0 < k ->
  lam > 0 ->
  k <> 1 ->
  dot (cross dp (vsub (Q P lam o) P)) (cross dp (vsub (Q P lam o) P)) <> 0 ->
  vsub (Q P lam o) P = vsub (vsub (Q P lam o) o) (vscale k (vsub P o)).
End eq_3_3_g_generatrix.

Module eq_3_3_g_direction.
(* hermite-developable/eq-3.3.g.direction, Sect. 3, sentence before (3.3a)
   printed: If the generatrix lines g(u) of developable surface are defined from the summit point O of the cone developable surface [...], then we can determine g(u) = [q(u) - o] - k [p(u) - o]
   read as: g is any vector along the generatrix of the cone
   stated: cross(Q - o - k*(P - o), Q - P) == 0 *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let o := [o'1; o'2; o'3] in
  cross (vsub (vsub (Q P lam o) o) (vscale k (vsub P o))) (vsub (Q P lam o) P) = zeros 3.
End eq_3_3_g_direction.

Module eq_3_3_g_true.
(* hermite-developable/eq-3.3.g.true, Sect. 3, sentence before (3.3a)
   printed: On a cone with the summit o, q - o = lam (p - o), the generatrix is q - p = (q - o) - (p - o) = (lam - 1) (p - o); the vector (q - o) - k (p - o) is (lam - k) (p - o).
   stated: Q - P == (lam - 1)*(P - o) and Q - P == Q - o - (P - o) and Q - o - k*(P - o) == (lam - k)*(P - o) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let o := [o'1; o'2; o'3] in
  vsub (Q P lam o) P = vscale (lam - 1) (vsub P o) /\ vsub (Q P lam o) P = vsub (vsub (Q P lam o) o) (vsub P o) /\ vsub (vsub (Q P lam o) o) (vscale k (vsub P o)) = vscale (lam - k) (vsub P o).
End eq_3_3_g_true.

Module eq_3_3a.
(* hermite-developable/eq-3.3a, Sect. 3, eq. (3.3a)
   printed: [(q(u) - o) + q'(u)] = k [(p(u) - o) + p'(u)]
   stated: Q - o + dq == k*(P - o + dp) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling ->
  ruling = vsub (vsub Q o) (vscale k (vsub P o)) ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling /\
  ruling = vsub (vsub Q o) (vscale k (vsub P o)).
End eq_3_3a.

Module eq_3_3b.
(* hermite-developable/eq-3.3b, Sect. 3, eq. (3.3b)
   printed: [(q(u) + q'(u)] = k [p(u) + p'(u)] + (1 - k) o
   read as: one round bracket is opened and never closed; read [q(u) + q'(u)] = k [p(u) + p'(u)] + (1 - k) o
   stated: Q + dq == k*(P + dp) + (1 - k)*o *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) ->
  vadd Q dq = vadd (vscale k (vadd P dp)) (vscale (1 - k) o).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp).
End eq_3_3b.

Module eq_3_3_same_as_3_2_generatrix.
(* hermite-developable/eq-3.3.same-as-3.2.generatrix, Sect. 3, sentence between (3.2) and (3.3a), with (3.4)
   printed: Therefore, it can state this developable criteria (3.2) in the form (3.3a) or (3.3b)
   read as: g is q - p, as it is defined before (3.1) and used in (3.4)
   stated: Q - o + dq == k*(P - o + dp) and Q + dq == k*(P + dp) + (1 - k)*o *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  0 < k ->
  k <> 1 ->
  dot (cross dp (vsub Q P)) (cross dp (vsub Q P)) <> 0 ->
  dq = vsub (vscale k dp) (vsub Q P) ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) /\ vadd Q dq = vadd (vscale k (vadd P dp)) (vscale (1 - k) o).
End eq_3_3_same_as_3_2_generatrix.

Module eq_3_3_same_as_3_2_direction.
(* hermite-developable/eq-3.3.same-as-3.2.direction, Sect. 3, sentence between (3.2) and (3.3a), with (3.4)
   printed: Therefore, it can state this developable criteria (3.2) in the form (3.3a) or (3.3b)
   read as: g is the vector that the sentence before determines
   stated: Q - o + dq == k*(P - o + dp) and Q + dq == k*(P + dp) + (1 - k)*o *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling ->
  ruling = vsub (vsub Q o) (vscale k (vsub P o)) ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) /\ vadd Q dq = vadd (vscale k (vadd P dp)) (vscale (1 - k) o).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R) (ruling'1 ruling'2 ruling'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  let ruling := [ruling'1; ruling'2; ruling'3] in
  dq = vsub (vscale k dp) ruling /\
  ruling = vsub (vsub Q o) (vscale k (vsub P o)).
End eq_3_3_same_as_3_2_direction.

Module eq_3_3_same_as_3_2_true.
(* hermite-developable/eq-3.3.same-as-3.2.true, Sect. 3, sentence between (3.2) and (3.3a)
   printed: For curves with (3.2), g = q - p, the two sides of (3.3) differ by (1 - k) (p - o): both criteria are met for k = 1, or where p is the summit, and nowhere else.
   stated: Q + dq - (k*(P + dp) + (1 - k)*o) == (1 - k)*(P - o) *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  dq = vsub (vscale k dp) (vsub Q P) ->
  vsub (vadd Q dq) (vadd (vscale k (vadd P dp)) (vscale (1 - k) o)) = vscale (1 - k) (vsub P o).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  dq = vsub (vscale k dp) (vsub Q P).
End eq_3_3_same_as_3_2_true.

Module eq_3_3_developable_Hermite.
(* hermite-developable/eq-3.3.developable.Hermite, Sect. 3, (3.3) used as 'developable surface criteria' throughout Sects. 3.1-3.3
   printed: developable surface criteria of Equation (3.3)
   read as: p and q are Hermite curves, as where the criterion is used; q is what the criterion gives for p, and the patch a cone
   stated: det([p'(u), q'(u), q(u) - p(u)]) == 0 and cross(q(u) - p(u), p(u) - o) == 0 *)
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 ->
  det [vDerive 3 (fun u_ => p a0 a1 a2 a3 a4 a5 u_) 1 u; vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u; vsub (q b0 b1 b2 b3 b4 b5 u) (p a0 a1 a2 a3 a4 a5 u)] = 0 /\ cross (vsub (q b0 b1 b2 b3 b4 b5 u) (p a0 a1 a2 a3 a4 a5 u)) (vsub (p a0 a1 a2 a3 a4 a5 u) o) = zeros 3.
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3).
End eq_3_3_developable_Hermite.

Module eq_3_3_developable_any.
(* hermite-developable/eq-3.3.developable.any, Sect. 3, (3.3) used as 'developable surface criteria' throughout Sects. 3.1-3.3
   printed: developable surface criteria of Equation (3.3)
   read as: p and q are any curves of class C^n, as in Definition 3.1
   stated: det([dp, dq, Q - P]) == 0 *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  0 < k ->
  k <> 1 ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) ->
  det [dp; dq; vsub Q P] = 0.
End eq_3_3_developable_any.

Module eq_3_3_exact.
(* hermite-developable/eq-3.3.exact, Sect. 3, eq. (3.3)
   printed: What (3.3) is worth for all curves of class C^1: with d = (q - o) - k (p - o) the determinant of Definition 3.2 is (1 - k) times that of p', d, p - o. The patch is developable exactly where these are coplanar (or k = 1), in particular where q - o = k (p - o).
   stated: det([dp, dq, Q - P]) == (1 - k)*det([dp, gap, P - o]) and dq - k*dp == -gap *)
Definition gap (P : list R) (Q : list R) (k : R) (o : list R) : list R :=
  vsub (vsub Q o) (vscale k (vsub P o)).
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) ->
  det [dp; dq; vsub Q P] = (1 - k) * det [dp; gap P Q k o; vsub P o] /\ vsub dq (vscale k dp) = vopp (gap P Q k o).
Definition instance : Prop :=
exists (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp).
End eq_3_3_exact.

Module eq_3_3_multiples_cone.
(* hermite-developable/eq-3.3.multiples.cone, Sect. 3, first sentence after (3.3b)
   printed: Equation (3.3a) shows that the vectors oq and q'(u) are orderly the multiplication of the vectors op and p'(u)
   read as: the curves are on a regular cone with the summit O, as the sentence before presupposes: q - o = lam x, p - o = x; (3.3a) is multiplied by x and by its derivative, and by the normal of the cone
   stated: lam*x == k*x and dlam*x + lam*dx == k*dx *)
Definition statement : Prop :=
forall (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let x := [x'1; x'2; x'3] in
  dot (cone_normal dx x) (cone_normal dx x) <> 0 ->
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 ->
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0 ->
  vscale lam x = vscale k x /\ vadd (vscale dlam x) (vscale lam dx) = vscale k dx.
Definition instance : Prop :=
exists (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let x := [x'1; x'2; x'3] in
  dot (cone_normal dx x) (cone_normal dx x) <> 0 /\
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 /\
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0.
End eq_3_3_multiples_cone.

Module eq_3_3_multiples_Hermite.
(* hermite-developable/eq-3.3.multiples.Hermite, Sect. 3, first sentence after (3.3b)
   printed: Equation (3.3a) shows that the vectors oq and q'(u) are orderly the multiplication of the vectors op and p'(u)
   read as: p and q are Hermite curves, no cone is presupposed
   stated: q(u) - o == k*(p(u) - o) and q'(u) == k*p'(u) *)
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 ->
  vsub (q b0 b1 b2 b3 b4 b5 u) o = vscale k (vsub (p a0 a1 a2 a3 a4 a5 u) o) /\ vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u = vscale k (vDerive 3 (fun u_ => p a0 a1 a2 a3 a4 a5 u_) 1 u).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (k : R) (o'1 o'2 o'3 : R) (u : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < u < 1 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (criterion a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion__ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion___ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion_____ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3 /\ criterion______ a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 k o = zeros 3).
End eq_3_3_multiples_Hermite.

Module eq_3_3_multiples_any.
(* hermite-developable/eq-3.3.multiples.any, Sect. 3, first sentence after (3.3b)
   printed: Equation (3.3a) shows that the vectors oq and q'(u) are orderly the multiplication of the vectors op and p'(u)
   read as: p and q are any curves of class C^n, no cone is presupposed
   stated: cross(Q - o, P - o) == 0 and cross(dq, dp) == 0 *)
Definition statement : Prop :=
forall (P'1 P'2 P'3 : R) (Q'1 Q'2 Q'3 : R) (dp'1 dp'2 dp'3 : R) (dq'1 dq'2 dq'3 : R) (k : R) (o'1 o'2 o'3 : R),
  let P := [P'1; P'2; P'3] in
  let Q := [Q'1; Q'2; Q'3] in
  let dp := [dp'1; dp'2; dp'3] in
  let dq := [dq'1; dq'2; dq'3] in
  let o := [o'1; o'2; o'3] in
  0 < k ->
  k <> 1 ->
  dot (cross dp (vsub Q P)) (cross dp (vsub Q P)) <> 0 ->
  vadd (vsub Q o) dq = vscale k (vadd (vsub P o) dp) ->
  cross (vsub Q o) (vsub P o) = zeros 3 /\ cross dq dp = zeros 3.
End eq_3_3_multiples_any.

Module eq_3_3_k_below_1.
(* hermite-developable/eq-3.3.k-below-1, Sect. 3, second sentence after (3.3b)
   printed: If the value k is in interval 0 < k < 1 the curve q(u) will lay between the summit point O and the curve p(u)
   read as: the curves are on the cone with the summit O, q - o = lam (p - o); x is p - o at one u; (3.3a) is multiplied by x and by its derivative, and by the normal of the cone. Between: on the line through both, and seen from q in opposite directions
   stated: cross(o - Q, P - Q) == 0 and dot(o - Q, P - Q) < 0 *)
Definition Q (lam : R) (o : list R) (x : list R) : list R :=
  vadd o (vscale lam x).
Definition statement : Prop :=
forall (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  0 < k < 1 ->
  dot (cone_normal dx x) (cone_normal dx x) <> 0 ->
  dot x x > 0 ->
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 ->
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0 ->
  cross (vsub o (Q lam o x)) (vsub (P o x) (Q lam o x)) = zeros 3 /\ dot (vsub o (Q lam o x)) (vsub (P o x) (Q lam o x)) < 0.
Definition instance : Prop :=
exists (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  0 < k < 1 /\
  dot (cone_normal dx x) (cone_normal dx x) <> 0 /\
  dot x x > 0 /\
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 /\
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0.
End eq_3_3_k_below_1.

Module eq_3_3_k_equal_1.
(* hermite-developable/eq-3.3.k-equal-1, Sect. 3, third sentence after (3.3b)
   printed: When k = 1, both curves p(u) and q(u) will be identical
   read as: the curves are on the cone with the summit O, q - o = lam (p - o); x is p - o at one u; (3.3a) is multiplied by x and by its derivative, and by the normal of the cone
   stated: Q == P *)
Definition Q (lam : R) (o : list R) (x : list R) : list R :=
  vadd o (vscale lam x).
Definition statement : Prop :=
forall (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  dot (cone_normal dx x) (cone_normal dx x) <> 0 ->
  dot x x > 0 ->
  k = 1 ->
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 ->
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0 ->
  Q lam o x = P o x.
Definition instance : Prop :=
exists (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  dot (cone_normal dx x) (cone_normal dx x) <> 0 /\
  dot x x > 0 /\
  k = 1 /\
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 /\
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0.
End eq_3_3_k_equal_1.

Module eq_3_3_k_above_1.
(* hermite-developable/eq-3.3.k-above-1, Sect. 3, fourth sentence after (3.3b)
   printed: If k > 1, then the curve p(u) will be placed between the summit point O and the curve q(u)
   read as: the curves are on the cone with the summit O, q - o = lam (p - o); x is p - o at one u; (3.3a) is multiplied by x and by its derivative, and by the normal of the cone. Between: on the line through both, and seen from p in opposite directions
   stated: cross(o - P, Q - P) == 0 and dot(o - P, Q - P) < 0 *)
Definition Q (lam : R) (o : list R) (x : list R) : list R :=
  vadd o (vscale lam x).
Definition statement : Prop :=
forall (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  1 < k ->
  dot (cone_normal dx x) (cone_normal dx x) <> 0 ->
  dot x x > 0 ->
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 ->
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0 ->
  cross (vsub o (P o x)) (vsub (Q lam o x) (P o x)) = zeros 3 /\ dot (vsub o (P o x)) (vsub (Q lam o x) (P o x)) < 0.
Definition instance : Prop :=
exists (dlam : R) (dx'1 dx'2 dx'3 : R) (k : R) (lam : R) (o'1 o'2 o'3 : R) (x'1 x'2 x'3 : R),
  let dx := [dx'1; dx'2; dx'3] in
  let o := [o'1; o'2; o'3] in
  let x := [x'1; x'2; x'3] in
  1 < k /\
  dot (cone_normal dx x) (cone_normal dx x) <> 0 /\
  dot x x > 0 /\
  dot (cross (cone_gap dlam dx k lam x) x) (cone_normal dx x) = 0 /\
  dot (cross (cone_gap dlam dx k lam x) dx) (cone_normal dx x) = 0.
End eq_3_3_k_above_1.

Module sec_3_summit_outside.
(* hermite-developable/sec-3.summit-outside, Sect. 3, paragraph before (3.4)
   printed: the curves p(u) and q(u) respectively placed in the parallel planes Gamma_1 // Gamma_2 with the summit point O of the cone developable surface positioned outer the planes
   read as: the summit is not between the planes nor on them: both planes are on one side of it; with the k > 0 that the paper elects
   stated: q'(u)[1] == 0 and (p(u)[1] - o[1])*(q(u)[1] - o[1]) > 0 *)
Definition a5 (y5 : R) (z5 : R) : list R :=
  [0; y5; z5].
Definition a4 (y4 : R) (z4 : R) : list R :=
  [0; y4; z4].
Definition a3 (y3 : R) (z3 : R) : list R :=
  [0; y3; z3].
Definition a2 (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition a1 (y1 : R) (z1 : R) : list R :=
  [0; y1; z1].
Definition a0 (h : R) (o : list R) (y0 : R) (z0 : R) : list R :=
  [entry o 1 + h; y0; z0].
Definition p (h : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  vadd (vadd (vadd (vadd (vadd (vscale (u ^ 5) (a5 y5 z5)) (vscale (u ^ 4) (a4 y4 z4))) (vscale (u ^ 3) (a3 y3 z3))) (vscale (u ^ 2) (a2 y2 z2))) (vscale u (a1 y1 z1))) (a0 h o y0 z0).
Definition gap (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (u : R) : list R :=
  vsub (vsub (vadd (q b0 b1 b2 b3 b4 b5 u) (vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u)) (vscale k (vadd (p h o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 u) (vDerive 3 (fun u_ => p h o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 u_) 1 u)))) (vscale (1 - k) o).
Definition part (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) (n : Z) : list R :=
  let u := 0%Z in vdiv (vDerive 3 (fun u_ => gap b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 u_) (Z.to_nat n) (IZR u)) (factorial n).
Definition criterion (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 5%Z.
Definition criterion__ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 4%Z.
Definition criterion___ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 3%Z.
Definition criterion____ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 2%Z.
Definition criterion_____ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 1%Z.
Definition criterion______ (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (h : R) (k : R) (o : list R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R) : list R :=
  part b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 0%Z.
Definition statement : Prop :=
forall (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (h : R) (k : R) (o'1 o'2 o'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < k ->
  0 < u < 1 ->
  h ^ 2 > 0 ->
  (0 <= 5%Z)%Z ->
  factorial 5%Z <> 0 ->
  (0 <= 4%Z)%Z ->
  factorial 4%Z <> 0 ->
  (0 <= 3%Z)%Z ->
  factorial 3%Z <> 0 ->
  (0 <= 2%Z)%Z ->
  factorial 2%Z <> 0 ->
  (0 <= 1%Z)%Z ->
  factorial 1%Z <> 0 ->
  (0 <= 0%Z)%Z ->
  factorial 0%Z <> 0 ->
  criterion b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion__ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion___ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion____ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion_____ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion______ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 ->
  entry (vDerive 3 (fun u_ => q b0 b1 b2 b3 b4 b5 u_) 1 u) 1 = 0 /\ (entry (p h o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 u) 1 - entry o 1) * (entry (q b0 b1 b2 b3 b4 b5 u) 1 - entry o 1) > 0.
Definition instance : Prop :=
exists (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (h : R) (k : R) (o'1 o'2 o'3 : R) (u : R) (y0 : R) (y1 : R) (y2 : R) (y3 : R) (y4 : R) (y5 : R) (z0 : R) (z1 : R) (z2 : R) (z3 : R) (z4 : R) (z5 : R),
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  let o := [o'1; o'2; o'3] in
  0 < k /\
  0 < u < 1 /\
  h ^ 2 > 0 /\
  (0 <= 5%Z)%Z /\
  factorial 5%Z <> 0 /\
  (0 <= 4%Z)%Z /\
  factorial 4%Z <> 0 /\
  (0 <= 3%Z)%Z /\
  factorial 3%Z <> 0 /\
  (0 <= 2%Z)%Z /\
  factorial 2%Z <> 0 /\
  (0 <= 1%Z)%Z /\
  factorial 1%Z <> 0 /\
  (0 <= 0%Z)%Z /\
  factorial 0%Z <> 0 /\
  (criterion b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion__ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion___ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion____ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion_____ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3 /\ criterion______ b0 b1 b2 b3 b4 b5 h k o y0 y1 y2 y3 y4 y5 z0 z1 z2 z3 z4 z5 = zeros 3).
End sec_3_summit_outside.

Module eq_3_4.
(* hermite-developable/eq-3.4, Sect. 3, eq. (3.4)
   printed: D(u,v) = p(u) + v . g = (1 - v) p(u) + v q(u)
   read as: g is the generatrix q - p of the paragraph before (3.1), not the vector (q - o) - k (p - o) of the sentence before (3.3a)
   stated: ruled(u, v) == (1 - v)*p(u) + v*q(u) *)
Definition g (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) : list R :=
  vsub (q b0 b1 b2 b3 b4 b5 u) (p a0 a1 a2 a3 a4 a5 u).
Definition ruled (a0 : list R) (a1 : list R) (a2 : list R) (a3 : list R) (a4 : list R) (a5 : list R) (b0 : list R) (b1 : list R) (b2 : list R) (b3 : list R) (b4 : list R) (b5 : list R) (u : R) (v : R) : list R :=
  vadd (p a0 a1 a2 a3 a4 a5 u) (vscale v (g a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u)).
Definition statement : Prop :=
forall (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1 ->
  ruled a0 a1 a2 a3 a4 a5 b0 b1 b2 b3 b4 b5 u v = vadd (vscale (1 - v) (p a0 a1 a2 a3 a4 a5 u)) (vscale v (q b0 b1 b2 b3 b4 b5 u)).
Definition instance : Prop :=
exists (a0'1 a0'2 a0'3 : R) (a1'1 a1'2 a1'3 : R) (a2'1 a2'2 a2'3 : R) (a3'1 a3'2 a3'3 : R) (a4'1 a4'2 a4'3 : R) (a5'1 a5'2 a5'3 : R) (b0'1 b0'2 b0'3 : R) (b1'1 b1'2 b1'3 : R) (b2'1 b2'2 b2'3 : R) (b3'1 b3'2 b3'3 : R) (b4'1 b4'2 b4'3 : R) (b5'1 b5'2 b5'3 : R) (u : R) (v : R),
  let a0 := [a0'1; a0'2; a0'3] in
  let a1 := [a1'1; a1'2; a1'3] in
  let a2 := [a2'1; a2'2; a2'3] in
  let a3 := [a3'1; a3'2; a3'3] in
  let a4 := [a4'1; a4'2; a4'3] in
  let a5 := [a5'1; a5'2; a5'3] in
  let b0 := [b0'1; b0'2; b0'3] in
  let b1 := [b1'1; b1'2; b1'3] in
  let b2 := [b2'1; b2'2; b2'3] in
  let b3 := [b3'1; b3'2; b3'3] in
  let b4 := [b4'1; b4'2; b4'3] in
  let b5 := [b5'1; b5'2; b5'3] in
  0 < u < 1.
End eq_3_4.
