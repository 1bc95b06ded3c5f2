(* Statements of gbt-developable, Part Abstract. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
End Definitions.
Import Definitions.

Module abs_conics_planes.
(* gbt-developable/abs-conics.planes, Abstract, second sentence
   printed: Developable Bézier surfaces ..., due to polynomial depiction and having no shape parameter, they cannot describe conics exactly and can only handle a few shapes.
   read as: 'they' are the developable Bézier surfaces of this paper's kind, (3.1) with Bernstein polynomials in place of the GBTB functions: the family with the control planes (1,0,0,1), (1,1,0,1), (0,2,0,2) has no arc of the unit circle as its section Z = 0.
   stated: fails(profile[1]^2 + profile[2]^2 == 1 and profile[3] == 0) *)
Definition bernstein_family (u : R) : list R :=
  vadd (vadd (vscale ((1 - u) ^ 2) [1; 0; 0; 1]) (vscale (2 * u * (1 - u)) [1; 1; 0; 1])) (vscale (u ^ 2) [0; 2; 0; 2]).
Definition profile (u : R) : list R :=
  foot (bernstein_family u) (vDerive 4 (fun u => bernstein_family u) 1 u).
Definition statement : Prop :=
forall (u : R),
  0 <= u <= 1 ->
  ~ (forall (u : R),
  0 <= u <= 1 ->
  dot (direction (bernstein_family u) (vDerive 4 (fun u => bernstein_family u) 1 u)) (direction (bernstein_family u) (vDerive 4 (fun u => bernstein_family u) 1 u)) <> 0 ->
  entry (profile u) 1 ^ 2 + entry (profile u) 2 ^ 2 = 1 /\ entry (profile u) 3 = 0).
End abs_conics_planes.

Module abs_conics_points.
(* gbt-developable/abs-conics.points, Abstract, second sentence
   printed: Developable Bézier surfaces ..., due to polynomial depiction and having no shape parameter, they cannot describe conics exactly and can only handle a few shapes.
   read as: 'they' are surfaces with polynomial coordinates of their points: a quadratic curve p0 + t p1 + t² p2 on a sphere has p2 = 0, since the fourth derivative of the square of its length is 24 |p2|².
   stated: D(dot(points(u), points(u)), u, 4) == 24*dot(p2, p2) *)
Definition points (p0 : list R) (p1 : list R) (p2 : list R) (t : R) : list R :=
  vadd (vadd p0 (vscale t p1)) (vscale (t ^ 2) p2).
Definition statement : Prop :=
forall (p0'1 p0'2 p0'3 : R) (p1'1 p1'2 p1'3 : R) (p2'1 p2'2 p2'3 : R) (u : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p2 := [p2'1; p2'2; p2'3] in
  0 <= u <= 1 ->
  Derive_n (fun u => dot (points p0 p1 p2 u) (points p0 p1 p2 u)) 4 u = 24 * dot p2 p2.
Definition instance : Prop :=
exists (p0'1 p0'2 p0'3 : R) (p1'1 p1'2 p1'3 : R) (p2'1 p2'2 p2'3 : R) (u : R),
  let p0 := [p0'1; p0'2; p0'3] in
  let p1 := [p1'1; p1'2; p1'3] in
  let p2 := [p2'1; p2'2; p2'3] in
  0 <= u <= 1.
End abs_conics_points.

Module abs_4d_factor.
(* gbt-developable/abs-4d.factor, Abstract
   printed: A plane and its multiples are one plane.
   stated: foot(factor*A, B) == foot(A, B) and midpoint(factor*A) == midpoint(A) *)
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition statement : Prop :=
forall (A'1 A'2 A'3 A'4 : R) (B'1 B'2 B'3 B'4 : R) (factor : R),
  let A := [A'1; A'2; A'3; A'4] in
  let B := [B'1; B'2; B'3; B'4] in
  0 < factor ->
  dot (direction (vscale factor A) B) (direction (vscale factor A) B) <> 0 ->
  dot (direction A B) (direction A B) <> 0 ->
  dot (normal (vscale factor A)) (normal (vscale factor A)) <> 0 ->
  dot (normal A) (normal A) <> 0 ->
  entry A 1 ^ 2 + entry A 2 ^ 2 + entry A 3 ^ 2 <> 0 ->
  entry A 1 ^ 2 * entry B 2 ^ 2 + entry A 1 ^ 2 * entry B 3 ^ 2 - 2 * entry A 1 * entry A 2 * entry B 1 * entry B 2 - 2 * entry A 1 * entry A 3 * entry B 1 * entry B 3 + entry A 2 ^ 2 * entry B 1 ^ 2 + entry A 2 ^ 2 * entry B 3 ^ 2 - 2 * entry A 2 * entry A 3 * entry B 2 * entry B 3 + entry A 3 ^ 2 * entry B 1 ^ 2 + entry A 3 ^ 2 * entry B 2 ^ 2 <> 0 ->
  foot (vscale factor A) B = foot A B /\ midpoint (vscale factor A) = midpoint A.
Definition instance : Prop :=
exists (A'1 A'2 A'3 A'4 : R) (B'1 B'2 B'3 B'4 : R) (factor : R),
  let A := [A'1; A'2; A'3; A'4] in
  let B := [B'1; B'2; B'3; B'4] in
  0 < factor /\
  dot (direction (vscale factor A) B) (direction (vscale factor A) B) <> 0 /\
  dot (direction A B) (direction A B) <> 0 /\
  dot (normal (vscale factor A)) (normal (vscale factor A)) <> 0 /\
  dot (normal A) (normal A) <> 0 /\
  entry A 1 ^ 2 + entry A 2 ^ 2 + entry A 3 ^ 2 <> 0 /\
  entry A 1 ^ 2 * entry B 2 ^ 2 + entry A 1 ^ 2 * entry B 3 ^ 2 - 2 * entry A 1 * entry A 2 * entry B 1 * entry B 2 - 2 * entry A 1 * entry A 3 * entry B 1 * entry B 3 + entry A 2 ^ 2 * entry B 1 ^ 2 + entry A 2 ^ 2 * entry B 3 ^ 2 - 2 * entry A 2 * entry A 3 * entry B 2 * entry B 3 + entry A 3 ^ 2 * entry B 1 ^ 2 + entry A 3 ^ 2 * entry B 2 ^ 2 <> 0.
End abs_4d_factor.
