(* Statements of gbt-developable, Section 3 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition HT (T : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) (T i)).
End Definitions.
Import Definitions.

Module sec_3_1_space.
(* gbt-developable/sec-3.1.space, Sect. 3.1
   printed: Q_i = (p_i, q_i, r_i, s_i), p_i, q_i, r_i, s_i ∈ R (i = 0, 1, 2, ..., k) are the coordinates of the control points of a GBT-Bézier curve in a 3D projective space
   read as: What makes the space a projective one is compared with the use of the coordinates in Sect. 3.2: a multiple of (p, q, r, s) is the same plane. The generator of two planes and the point of a plane nearest to the origin do not depend on the factors.
   stated: foot(factor*A, factor2*B) == foot(A, B) and cross(direction(factor*A, factor2*B), direction(A, B)) == 0 and midpoint(factor*A) == midpoint(A) *)
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition statement : Prop :=
forall (A'1 A'2 A'3 A'4 : R) (B'1 B'2 B'3 B'4 : R) (factor : R) (factor2 : R),
  let A := [A'1; A'2; A'3; A'4] in
  let B := [B'1; B'2; B'3; B'4] in
  0 < factor ->
  0 < factor2 ->
  dot (direction (vscale factor A) (vscale factor2 B)) (direction (vscale factor A) (vscale factor2 B)) <> 0 ->
  dot (direction A B) (direction A B) <> 0 ->
  dot (normal (vscale factor A)) (normal (vscale factor A)) <> 0 ->
  dot (normal A) (normal A) <> 0 ->
  entry A 1 ^ 2 + entry A 2 ^ 2 + entry A 3 ^ 2 <> 0 ->
  entry A 1 ^ 2 * entry B 2 ^ 2 + entry A 1 ^ 2 * entry B 3 ^ 2 - 2 * entry A 1 * entry A 2 * entry B 1 * entry B 2 - 2 * entry A 1 * entry A 3 * entry B 1 * entry B 3 + entry A 2 ^ 2 * entry B 1 ^ 2 + entry A 2 ^ 2 * entry B 3 ^ 2 - 2 * entry A 2 * entry A 3 * entry B 2 * entry B 3 + entry A 3 ^ 2 * entry B 1 ^ 2 + entry A 3 ^ 2 * entry B 2 ^ 2 <> 0 ->
  foot (vscale factor A) (vscale factor2 B) = foot A B /\ cross (direction (vscale factor A) (vscale factor2 B)) (direction A B) = zeros 3 /\ midpoint (vscale factor A) = midpoint A.
Definition instance : Prop :=
exists (A'1 A'2 A'3 A'4 : R) (B'1 B'2 B'3 B'4 : R) (factor : R) (factor2 : R),
  let A := [A'1; A'2; A'3; A'4] in
  let B := [B'1; B'2; B'3; B'4] in
  0 < factor /\
  0 < factor2 /\
  dot (direction (vscale factor A) (vscale factor2 B)) (direction (vscale factor A) (vscale factor2 B)) <> 0 /\
  dot (direction A B) (direction A B) <> 0 /\
  dot (normal (vscale factor A)) (normal (vscale factor A)) <> 0 /\
  dot (normal A) (normal A) <> 0 /\
  entry A 1 ^ 2 + entry A 2 ^ 2 + entry A 3 ^ 2 <> 0 /\
  entry A 1 ^ 2 * entry B 2 ^ 2 + entry A 1 ^ 2 * entry B 3 ^ 2 - 2 * entry A 1 * entry A 2 * entry B 1 * entry B 2 - 2 * entry A 1 * entry A 3 * entry B 1 * entry B 3 + entry A 2 ^ 2 * entry B 1 ^ 2 + entry A 2 ^ 2 * entry B 3 ^ 2 - 2 * entry A 2 * entry A 3 * entry B 2 * entry B 3 + entry A 3 ^ 2 * entry B 1 ^ 2 + entry A 3 ^ 2 * entry B 2 ^ 2 <> 0.
End sec_3_1_space.

Module eq_3_2.
(* gbt-developable/eq-3.2, Sect. 3.1, eq. (3.2)
   printed: H(x; μ, ν) = Σ g_{i,k}(x; μ, ν)(p_i, q_i, r_i, s_i) = {a0(x), a1(x), a2(x), a3(x)} = {Σ g_{i,k} p_i, Σ g_{i,k} q_i, Σ g_{i,k} r_i, Σ g_{i,k} s_i}
   stated: HT(x) == [sum(i, 0, k, g[i,k](x)*T[i][1]), sum(i, 0, k, g[i,k](x)*T[i][2]), sum(i, 0, k, g[i,k](x)*T[i][3]), sum(i, 0, k, g[i,k](x)*T[i][4])] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  HT T k mu nu x = [sum 0%Z k (fun i => g x mu nu i k * entry (T i) 1); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 2); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 3); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 4)].
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_2.

Module eq_3_3.
(* gbt-developable/eq-3.3, Sect. 3.1, eq. (3.3)
   printed: a0(x) = Σ_{i=0}^{k} g_{i,k}(x) p_i, a1(x) = Σ g_{i,k}(x) q_i, a2(x) = Σ g_{i,k}(x) r_i, a3(x) = Σ g_{i,k}(x) s_i
   read as: Compared with the coordinates of (3.1), the vector sum, one by one.
   stated: HT(x)[1] == sum(i, 0, k, g[i,k](x)*T[i][1]) and HT(x)[2] == sum(i, 0, k, g[i,k](x)*T[i][2]) and HT(x)[3] == sum(i, 0, k, g[i,k](x)*T[i][3]) and HT(x)[4] == sum(i, 0, k, g[i,k](x)*T[i][4]) *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  entry (HT T k mu nu x) 1 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 1) /\ entry (HT T k mu nu x) 2 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 2) /\ entry (HT T k mu nu x) 3 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 3) /\ entry (HT T k mu nu x) 4 = sum 0%Z k (fun i => g x mu nu i k * entry (T i) 4).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_3.

Module eq_3_4.
(* gbt-developable/eq-3.4, Sect. 3.1, eq. (3.4)
   printed: {Π_x}: H(x; μ, ν) = {a0(x), a1(x), a2(x), a3(x)}
   read as: The coordinates of (3.3), compared with (3.1).
   stated: HT(x) == [sum(i, 0, k, g[i,k](x)*T[i][1]), sum(i, 0, k, g[i,k](x)*T[i][2]), sum(i, 0, k, g[i,k](x)*T[i][3]), sum(i, 0, k, g[i,k](x)*T[i][4])] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  HT T k mu nu x = [sum 0%Z k (fun i => g x mu nu i k * entry (T i) 1); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 2); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 3); sum 0%Z k (fun i => g x mu nu i k * entry (T i) 4)].
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_4.
