(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_5_5.
Import GbtDevelopable.Section_5_5.Definitions.
Open Scope R_scope.

Module eq_5_18.
Import GbtDevelopable.Section_5_5.eq_5_18.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 E1_1 E1_2 E1_3]; identity. Qed.
End eq_5_18.

Module ex_5_1_construct.
Import GbtDevelopable.Section_5_5.ex_5_1_construct.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck farin_boehm]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck farin_boehm]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_5_1_construct.

Module ex_5_1_shape_shape.
Import GbtDevelopable.Section_5_5.ex_5_1_shape_shape.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g N2 N2_]; intros; conjuncts; first [ intro no; first [ refuting (no (3)%Z (3)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (3)%Z (3)%Z (fun _ => 4) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g N2 N2_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_5_1_shape_shape.

Module ex_5_1_shape_combined_surface.
Import GbtDevelopable.Section_5_5.ex_5_1_shape_combined_surface.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2 N2_] in no; refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1) (0)). Qed.
End ex_5_1_shape_combined_surface.

Module ex_5_2_Q02.
Import GbtDevelopable.Section_5_5.ex_5_2_Q02.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 g]; computed; intros; equations; members; rewriting; conjuncts; lra. Qed.
Theorem met : instance.
Proof. let joined_planes := fun _ => (exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; ends_of_sums; compute_goal; try reflexivity; field) in cbv beta zeta delta [instance F2 F1 g]; joined_planes (). Qed.
End ex_5_2_Q02.

Module ex_5_2_Q12.
Import GbtDevelopable.Section_5_5.ex_5_2_Q12.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; computed; intros; equations; members; rewriting; unknown (B'1 1%Z); unknown (B'2 1%Z); unknown (B'3 1%Z); unknown (B'4 1%Z); put_in; repeat solve_one; conjuncts; field; different. Qed.
Theorem met : instance.
Proof. let joined_planes := fun _ => (exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; ends_of_sums; compute_goal; try reflexivity; field) in cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; joined_planes (). Qed.
End ex_5_2_Q12.

Module ex_5_2_Q22.
Import GbtDevelopable.Section_5_5.ex_5_2_Q22.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; sums_at_ends; intros; equations; rewriting; pose proof PI_RGT_0; let at_1 := fun P v => (assert (P 1%Z = v) by (apply (Rmult_eq_reg_l (1 + PI)); lra)) in let at_2 := fun P v => (assert (P 2%Z = v) by (apply (Rmult_eq_reg_l PI); lra)) in at_1 B'1 0; at_1 B'2 30; at_1 B'3 0; at_1 B'4 400; rewriting; at_2 B'1 0; at_2 B'2 (30 + 5 * PI); at_2 B'3 (- 20 - 5 * PI); at_2 B'4 400; lists; rewritten; conjuncts; rounded. Qed.
Theorem met : instance.
Proof. let joined_planes := fun _ => (exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; ends_of_sums; compute_goal; try reflexivity; field) in cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; joined_planes (). Qed.
End ex_5_2_Q22.

Module ex_5_2_gamma_one.
Import GbtDevelopable.Section_5_5.ex_5_2_gamma_one.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 G M1 M2 N1 N2 E P Q _ _; subst gamma; rewrite P; assert (V : forall v : list R, vscale 1 v = v) by (intro v; induction v as [|x v IH]; [reflexivity | change (vscale 1 (x :: v)) with (1 * x :: vscale 1 v); rewrite IH; f_equal; ring]); rewrite Q, V; split; reflexivity. Qed.
Theorem met : instance.
Proof. cbv beta delta [instance]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 0; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; 0; 0] 0), (fun _ => 400), 1, (-1), (-1), (-1), (-1); cbv beta zeta; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i; d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z; c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends; reflexivity); assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i; d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z; d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field); assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity); assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3 E1_2)) by (cbv beta delta [K1_ g]; vector_at_end; reflexivity); rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D; cbv beta delta [direction normal E1_3 E1_2]; compute_goal; conjuncts; parts; lra. Qed.
End ex_5_2_gamma_one.

Module ex_5_2_gap_surfaces.
Import GbtDevelopable.Section_5_5.ex_5_2_gap_surfaces.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i; d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z; c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends; reflexivity); assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i; d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z; d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field); assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity); assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3 E1_2)) by (cbv beta delta [K1_ g]; vector_at_end; reflexivity);  specialize (no (fun _ => 0) (fun i => nth (Z.to_nat i) [20; 40; 0; 0] 0) (fun i => nth (Z.to_nat i) [10; -10; 0; 0] 0) (fun _ => 400) 2 (-1) (-1) (-1) (-1)); cbv beta in no; rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D in no; clear A B C D; refine (no _ _ _ _ _ _ _ _ _); clear no; [lra|lra|lra|lra|lra|lra|cbv delta [E1_3]; compute_goal; reflexivity|cbv delta [E1_3 E1_2]; compute_goal; parts; lra|]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 G M1 M2 N1 N2 X P Q _ N; split; [rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity; assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4; clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3) (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear - G X; intros p1 p2 p3 p4 q1 q2 q3 q4; cbv delta [direction foot moment normal]; lists; intro N; apply (same_foot gamma); [lra|exact N|ring ..]|rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity; assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4; clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3) (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4; cbv delta [direction foot moment normal]; lists; intro N; parts; ring]. Qed.
End ex_5_2_gap_surfaces.

Module ex_5_2_gap_drawn_pieces.
Import GbtDevelopable.Section_5_5.ex_5_2_gap_drawn_pieces.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 x1 G M1 M2 N1 N2 E X P Q _ N; split; [|split; [|split]]; [rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity; assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4; clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3) (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4; cbv delta [direction foot moment normal]; lists; intro N; parts; ring|intro Z; apply E; apply (Rmult_eq_reg_l x1); [lra|exact X]|rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity; assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4; clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3) (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4; cbv delta [direction foot moment normal]; lists; intro N; match type of N with ?a * _ + (?b * _ + (?c * _ + 0)) <> 0 => pose proof (Rle_0_sqr a); pose proof (Rle_0_sqr b); pose proof (Rle_0_sqr c); unfold Rsqr in *; (generalize dependent (a * a); generalize dependent (b * b); generalize dependent (c * c); intros; lra) end|rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity; assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4; clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3) (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear - G X; intros p1 p2 p3 p4 q1 q2 q3 q4; cbv delta [direction foot moment normal]; lists; intro N; apply (same_foot gamma); [lra|exact N|ring ..]]. Qed.
Theorem met : instance.
Proof. cbv beta delta [instance]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 40; 0; 0] 0), (fun i => nth (Z.to_nat i) [10; -10; 0; 0] 0), (fun _ => 400), 2, (-1), (-1), (-1), (-1), 1; cbv beta zeta; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i; d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z; c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends; reflexivity); assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i; d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z; d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field); assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity); assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3 E1_2)) by (cbv beta delta [K1_ g]; vector_at_end; reflexivity);  rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D; cbv beta delta [direction normal E1_3 E1_2]; compute_goal; conjuncts; parts; lra. Qed.
End ex_5_2_gap_drawn_pieces.
