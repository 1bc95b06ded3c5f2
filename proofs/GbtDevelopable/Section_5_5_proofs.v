(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
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
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2 N2_] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1) (0)). Qed.
End ex_5_1_shape_combined_surface.

Module ex_5_2_Q02.
Import GbtDevelopable.Section_5_5.ex_5_2_Q02.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 g]; computed; intros; equations; members; rewriting; conjuncts; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F2 F1 g]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; try at_ends; compute_goal; field. Qed.
End ex_5_2_Q02.

Module ex_5_2_Q12.
Import GbtDevelopable.Section_5_5.ex_5_2_Q12.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; computed; intros; equations; members; rewriting; unknown (B'1 1%Z); unknown (B'2 1%Z); unknown (B'3 1%Z); unknown (B'4 1%Z); put_in; repeat solve_one; conjuncts; field; different. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; try at_ends; compute_goal; field. Qed.
End ex_5_2_Q12.

Module ex_5_2_Q22.
Import GbtDevelopable.Section_5_5.ex_5_2_Q22.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; computed; intros; equations; members; rewriting; unknown (B'1 1%Z); unknown (B'2 1%Z); unknown (B'3 1%Z); unknown (B'4 1%Z); unknown (B'1 2%Z); unknown (B'2 2%Z); unknown (B'3 2%Z); unknown (B'4 2%Z); put_in; repeat solve_one; conjuncts; rounded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10; 20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20; 10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts; parts; try at_ends; compute_goal; field. Qed.
End ex_5_2_Q22.

Module ex_5_2_gamma_one.
Import GbtDevelopable.Section_5_5.ex_5_2_gamma_one.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 G M1 M2 N1 N2 E P Q _ _; subst gamma; rewrite P; assert (V : forall v : list R, vscale 1 v = v) by (intro v; induction v as [|x v IH]; [reflexivity | change (vscale 1 (x :: v)) with (1 * x :: vscale 1 v); rewrite IH; f_equal; ring]); rewrite Q, V; split; reflexivity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance direction normal K2 K1 K2_ K1_ g E1_0 E1_1 E1_2 E1_3]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 0; 0] 0), (fun i => nth (Z.to_nat i) [10; 0; 0; 0] 0), (fun _ => 400), 1, (-1), (-1), (-1), (-1); met. Qed.
End ex_5_2_gamma_one.
