(* Statements of gbt-developable, Section 5 5. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition N2 (P2 : Z -> R) (mu3 : R) (nu3 : R) (x : R) : R :=
  sum 0%Z 3%Z (fun i => g x mu3 nu3 i 3%Z * P2 i).
Definition F2 (B : Z -> list R) (x : R) : list R :=
  vsum 4 0%Z 3%Z (fun i => vscale (g x 1 1 i 3%Z) (B i)).
Definition F1 (A : Z -> list R) (x : R) : list R :=
  vsum 4 0%Z 3%Z (fun i => vscale (g x 1 1 i 3%Z) (A i)).
Definition K2 (B : Z -> list R) (mu2 : R) (nu2 : R) (x : R) : list R :=
  vsum 4 0%Z 3%Z (fun i => vscale (g x mu2 nu2 i 3%Z) (B i)).
Definition E1_0 : list R :=
  [0; - 20; 10; 400].
Definition E1_1 : list R :=
  [0; - 10; 20; 400].
Definition E1_2 : list R :=
  [0; 10; 20; 400].
Definition E1_3 : list R :=
  [0; 20; 10; 400].
Definition K1 (mu1 : R) (nu1 : R) (x : R) : list R :=
  vadd (vadd (vadd (vscale (g x mu1 nu1 0%Z 3%Z) E1_0) (vscale (g x mu1 nu1 1%Z 3%Z) E1_1)) (vscale (g x mu1 nu1 2%Z 3%Z) E1_2)) (vscale (g x mu1 nu1 3%Z 3%Z) E1_3).
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

Module ex_5_1_construct.
(* gbt-developable/ex-5.1.construct, Sect. 5.5, Example 5.1
   printed: For all spliced surfaces, the last control plane Q_{3,2} is given openly, and the first three control planes are derived from Farin–Boehm G2 continuity conditions.
   stated: P2[0] == P1[k] and P2[1] == P1[k] + c*(P1[k] - P1[k-1]) and P2[2] == farin_boehm *)
Definition cl (l : Z) (mu2 : R) : R :=
  4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)).
Definition c (k : Z) (l : Z) (mu2 : R) (nu1 : R) : R :=
  (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition ck (k : Z) (nu1 : R) : R :=
  4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu1)).
Definition farin_boehm (P1 : Z -> R) (k : Z) (l : Z) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) : R :=
  P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) + 1 / (cl l mu2 + PI ^ 2 * (1 - nu2)) * (ck k nu1 * (P1 k - 2 * P1 (k - 1)%Z + P1 (k - 2)%Z) - PI ^ 2 * (1 - mu1) * (P1 (k - 1)%Z - P1 (k - 2)%Z) + (2 * PI ^ 2 * nu1 + c k l mu2 nu1 * (cl l mu2 + 2 * PI ^ 2 * mu2)) * (P1 k - P1 (k - 1)%Z)).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  (0 <= 1 <= l)%Z ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= 2 <= l)%Z ->
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 ->
  (0 <= k - 2 <= k)%Z ->
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0 ->
  P2 0%Z = P1 k /\ P2 1%Z = P1 k + c k l mu2 nu1 * (P1 k - P1 (k - 1)%Z) /\ P2 2%Z = farin_boehm P1 k l mu1 mu2 nu1 nu2.
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  IZR k = 3 /\
  IZR l = 3 /\
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  (0 <= 1 <= l)%Z /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= 2 <= l)%Z /\
  cl l mu2 + PI ^ 2 * (1 - nu2) <> 0 /\
  (0 <= k - 2 <= k)%Z /\
  4 * (IZR l - 2) * (IZR l - 3) + 4 * PI * (IZR l - 2) * (1 + mu2) + PI ^ 2 * (1 - nu2) <> 0.
End ex_5_1_construct.

Module ex_5_1_shape_shape.
(* gbt-developable/ex-5.1.shape.shape, Sect. 5.5, Example 5.1
   printed: These four graphs indicate that without disturbing control planes, the shape of the combined developable GBT-Bézier surface can be simply modified by amending the shape parameters.
   read as: The family of planes changes with the shape parameters, the control planes fixed.
   stated: fails(D(N2(x), mu3) == 0) and fails(D(N2(x), nu3) == 0) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P2 : Z -> R) (mu3 : R) (nu3 : R) (x : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu3 <= 1 ->
  0 <= x <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  ~ (forall (k : Z) (l : Z) (P2 : Z -> R) (mu3 : R) (nu3 : R) (x : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu3 <= 1 ->
  0 <= x <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= l)%Z) ->
  Derive_n (fun mu3 => N2 P2 mu3 nu3 x) 1 mu3 = 0) /\ ~ (forall (k : Z) (l : Z) (P2 : Z -> R) (mu3 : R) (nu3 : R) (x : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu3 <= 1 ->
  0 <= x <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= l)%Z) ->
  Derive_n (fun nu3 => N2 P2 mu3 nu3 x) 1 nu3 = 0).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P2 : Z -> R) (mu3 : R) (nu3 : R) (x : R),
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu3 <= 1 /\
  (-1) <= nu3 <= 1 /\
  0 <= x <= 1 /\
  IZR k = 3 /\
  IZR l = 3.
End ex_5_1_shape_shape.

Module ex_5_1_shape_combined_surface.
(* gbt-developable/ex-5.1.shape.combined surface, Sect. 5.5, Example 5.1
   printed: These four graphs indicate that without disturbing control planes, the shape of the combined developable GBT-Bézier surface can be simply modified by amending the shape parameters.
   read as: It also stays one combined surface: the control planes fit mu2 and nu2 by (5.11), and (5.11) still holds with other values mu3, nu3.
   stated: N2(0) == H1(1) and N2'(0) == H1'(1) and N2''(0) == H1''(1) *)
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (-1) <= nu3 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0 = H1 P1 k mu1 nu1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 ->
  Derive_n (fun x => H2 P2 l mu2 nu2 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1 ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= l)%Z) ->
  N2 P2 mu3 nu3 0 = H1 P1 k mu1 nu1 1 /\ Derive_n (fun x => N2 P2 mu3 nu3 x) 1 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 1 1 /\ Derive_n (fun x => N2 P2 mu3 nu3 x) 2 0 = Derive_n (fun x => H1 P1 k mu1 nu1 x) 2 1.
End ex_5_1_shape_combined_surface.

Module ex_5_2_Q02.
(* gbt-developable/ex-5.2.Q02, Sect. 5.5, Example 5.2
   printed: Q_{0,2} = (0, 20, 10, 400)
   stated: agrees(B[0], [0, 20, 10, 400]) *)
Definition statement : Prop :=
forall (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] ->
  A 1%Z = [0; - 10; 20; 400] ->
  A 2%Z = [0; 10; 20; 400] ->
  A 3%Z = [0; 20; 10; 400] ->
  F2 B 0 = F1 A 1 ->
  ((entry (B 0%Z) 1 = 0 /\ entry (B 0%Z) 2 = 20) /\ entry (B 0%Z) 3 = 10) /\ entry (B 0%Z) 4 = 400.
Definition instance : Prop :=
exists (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] /\
  A 1%Z = [0; - 10; 20; 400] /\
  A 2%Z = [0; 10; 20; 400] /\
  A 3%Z = [0; 20; 10; 400] /\
  F2 B 0 = F1 A 1.
End ex_5_2_Q02.

Module ex_5_2_Q12.
(* gbt-developable/ex-5.2.Q12, Sect. 5.5, Example 5.2
   printed: Q_{1,2} = (0, 30, 0, 400)
   read as: 'according to (5.16) (γ = 1, λ = 0)': with these constants (5.17) is (5.11).
   stated: agrees(B[1], [0, 30, 0, 400]) *)
Definition statement : Prop :=
forall (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] ->
  A 1%Z = [0; - 10; 20; 400] ->
  A 2%Z = [0; 10; 20; 400] ->
  A 3%Z = [0; 20; 10; 400] ->
  F2 B 0 = F1 A 1 ->
  vDerive 4 (fun x => F2 B x) 1 0 = vDerive 4 (fun x => F1 A x) 1 1 ->
  ((entry (B 1%Z) 1 = 0 /\ entry (B 1%Z) 2 = 30) /\ entry (B 1%Z) 3 = 0) /\ entry (B 1%Z) 4 = 400.
Definition instance : Prop :=
exists (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] /\
  A 1%Z = [0; - 10; 20; 400] /\
  A 2%Z = [0; 10; 20; 400] /\
  A 3%Z = [0; 20; 10; 400] /\
  F2 B 0 = F1 A 1 /\
  vDerive 4 (fun x => F2 B x) 1 0 = vDerive 4 (fun x => F1 A x) 1 1.
End ex_5_2_Q12.

Module ex_5_2_Q22.
(* gbt-developable/ex-5.2.Q22, Sect. 5.5, Example 5.2
   printed: Q_{2,2} = (0, 45.708, −35.708, 400)
   read as: 'according to (5.16) (γ = 1, λ = 0)': with these constants (5.17) is (5.11), and the misprint of (5.16) has no effect.
   stated: agrees(B[2], [0, 45.708, -35.708, 400]) *)
Definition statement : Prop :=
forall (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] ->
  A 1%Z = [0; - 10; 20; 400] ->
  A 2%Z = [0; 10; 20; 400] ->
  A 3%Z = [0; 20; 10; 400] ->
  F2 B 0 = F1 A 1 ->
  vDerive 4 (fun x => F2 B x) 1 0 = vDerive 4 (fun x => F1 A x) 1 1 ->
  vDerive 4 (fun x => F2 B x) 2 0 = vDerive 4 (fun x => F1 A x) 2 1 ->
  ((agrees_up (entry (B 2%Z) 1) 0 3 /\ agrees_up (entry (B 2%Z) 2) (11427 / 250) 3) /\ agrees_down (entry (B 2%Z) 3) ((-8927) / 250) 3) /\ agrees_up (entry (B 2%Z) 4) 400 3.
Definition instance : Prop :=
exists (A'1 A'2 A'3 A'4 : Z -> R) (B'1 B'2 B'3 B'4 : Z -> R),
  let A := fun i0 => [A'1 i0; A'2 i0; A'3 i0; A'4 i0] in
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  A 0%Z = [0; - 20; 10; 400] /\
  A 1%Z = [0; - 10; 20; 400] /\
  A 2%Z = [0; 10; 20; 400] /\
  A 3%Z = [0; 20; 10; 400] /\
  F2 B 0 = F1 A 1 /\
  vDerive 4 (fun x => F2 B x) 1 0 = vDerive 4 (fun x => F1 A x) 1 1 /\
  vDerive 4 (fun x => F2 B x) 2 0 = vDerive 4 (fun x => F1 A x) 2 1.
End ex_5_2_Q22.

Module ex_5_2_gamma_one.
(* gbt-developable/ex-5.2.gamma-one, Sect. 5.5, Example 5.2
   printed: Figure 18 indicates that a unified merged developable GBT-Bézier surface can be achieved by setting scaling factor γ = 1, unconcerned of modifying the shape parameter
   read as: The planes Q_{1,2}, Q_{2,2} are recomputed from (5.16) for the changed shape parameters. The parametrised generators (3.7) of both surfaces are the same for the same x1.
   stated: foot(K2(0), K2'(0)) == foot(K1(1), K1'(1)) and direction(K2(0), K2'(0)) == direction(K1(1), K1'(1)) *)
Definition statement : Prop :=
forall (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  gamma = 1 ->
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 ->
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) ->
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 ->
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0 ->
  foot (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = foot (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\ direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1).
Definition instance : Prop :=
exists (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  gamma = 1 /\
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 /\
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 /\
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0.
End ex_5_2_gamma_one.

Module ex_5_2_gap_surfaces.
(* gbt-developable/ex-5.2.gap.surfaces, Sect. 5.5, Example 5.2
   printed: at connection a gap will be achieved on merged developable GBT-Bézier surfaces when γ ≠ 1
   read as: The surfaces of (3.7), with generators that are lines, do not meet in one line.
   stated: fails(foot(K2(0), K2'(0)) == foot(K1(1), K1'(1)) and cross(direction(K2(0), K2'(0)), direction(K1(1), K1'(1))) == 0) *)
Definition statement : Prop :=
forall (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  gamma <> 1 ->
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 ->
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) ->
  ~ (forall (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  gamma <> 1 ->
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 ->
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) ->
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 ->
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0 ->
  foot (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = foot (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\ cross (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) = zeros 3).
End ex_5_2_gap_surfaces.

Module ex_5_2_gap_drawn_pieces.
(* gbt-developable/ex-5.2.gap.drawn pieces, Sect. 5.5, Example 5.2
   printed: at connection a gap will be achieved on merged developable GBT-Bézier surfaces when γ ≠ 1
   read as: With generators cut off at the same values of x1 the pieces drawn do not end at the same points.
   stated: x1*direction(K2(0), K2'(0)) - x1*direction(K1(1), K1'(1)) == x1*(gamma - 1)*direction(K1(1), K1'(1)) and x1*(gamma - 1) != 0 and dot(direction(K1(1), K1'(1)), direction(K1(1), K1'(1))) > 0 and foot(K2(0), K2'(0)) == foot(K1(1), K1'(1)) *)
Definition statement : Prop :=
forall (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x1 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  gamma <> 1 ->
  x1 <> 0 ->
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 ->
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) ->
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 ->
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0 ->
  vsub (vscale x1 (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0))) (vscale x1 (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1))) = vscale (x1 * (gamma - 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) /\ x1 * (gamma - 1) <> 0 /\ dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) > 0 /\ foot (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = foot (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1).
Definition instance : Prop :=
exists (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R) (x1 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  gamma <> 1 /\
  x1 <> 0 /\
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 /\
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 /\
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0.
End ex_5_2_gap_drawn_pieces.

Module ex_5_2_one_line.
(* gbt-developable/ex-5.2.one-line, Sect. 5.5, Example 5.2
   printed: The end generators of both surfaces are one line for every γ, and their lengths for one range of x1 are in the ratio γ.
   stated: foot(K2(0), K2'(0)) == foot(K1(1), K1'(1)) and direction(K2(0), K2'(0)) == gamma*direction(K1(1), K1'(1)) and foot(K1(1), K1'(1)) == [0, 40/3, 40/3] and at(direction(K1(1), K1'(1)), nu1, 1) == [-300*(1 + pi), 0, 0] *)
Definition statement : Prop :=
forall (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 ->
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) ->
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 ->
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0 ->
  foot (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = foot (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\ direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0) = vscale gamma (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) /\ foot (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) = [0; 40 / 3; 40 / 3] /\ (fun nu1 : R => direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) 1 = [- 300 * (1 + PI); 0; 0].
Definition instance : Prop :=
exists (B'1 B'2 B'3 B'4 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (nu1 : R) (nu2 : R),
  let B := fun i0 => [B'1 i0; B'2 i0; B'3 i0; B'4 i0] in
  0 < gamma /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu2 <= 1 /\
  K2 B mu2 nu2 0 = K1 mu1 nu1 1 /\
  vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0 = vscale gamma (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1) /\
  dot (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) (direction (K2 B mu2 nu2 0) (vDerive 4 (fun x => K2 B mu2 nu2 x) 1 0)) <> 0 /\
  dot (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) (direction (K1 mu1 nu1 1) (vDerive 4 (fun x => K1 mu1 nu1 x) 1 1)) <> 0.
End ex_5_2_one_line.
