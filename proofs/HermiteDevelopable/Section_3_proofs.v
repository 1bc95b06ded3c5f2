(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3.
Import HermiteDevelopable.Section_3.Definitions.
From HermiteDevelopable Require Import Section_3_closed.
Open Scope R_scope.

Module def_3_1.
Import HermiteDevelopable.Section_3.def_3_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p g ruled ruled_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p g ruled ruled_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End def_3_1.

Module def_3_1_normal.
Import HermiteDevelopable.Section_3.def_3_1_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p g ruled]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p g ruled]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End def_3_1_normal.

Module def_3_2.
Import HermiteDevelopable.Section_3.def_3_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; identity. Qed.
End def_3_2.

Module def_3_2_lincomb.
Import HermiteDevelopable.Section_3.def_3_2_lincomb.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End def_3_2_lincomb.

Module sec_3_g_boundary.
Import HermiteDevelopable.Section_3.sec_3_g_boundary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p q g ruled ruled_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p q g ruled ruled_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End sec_3_g_boundary.

Module sec_3_g_prime.
Import HermiteDevelopable.Section_3.sec_3_g_prime.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1) (1) (1) (1) (0) (1) (0) (0) (2) (1) (0) (0) (1) (0)). Qed.
End sec_3_g_prime.

Module sec_3_g_prime_corrected.
Import HermiteDevelopable.Section_3.sec_3_g_prime_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dg'1; unknown dg'2; unknown dg'3; unknown dq'1; unknown dq'2; unknown dq'3; put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists (1), (1), 7, 7, 2, 6, 8, 7, 8, 7, 9, 9, 7, 7; met) | (exists (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0; met)]. Qed.
End sec_3_g_prime_corrected.

Module eq_3_1.
Import HermiteDevelopable.Section_3.eq_3_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement rho]; unstaged; prepared; known (dg'1) (alpha*dp'1 + beta*ruling'1) (1); known (dg'2) (alpha*dp'2 + beta*ruling'2) (1); known (dg'3) (alpha*dp'3 + beta*ruling'3) (1); known (dq'1) (alpha*dp'1 + beta*ruling'1 + dp'1) (1); known (dq'2) (alpha*dp'2 + beta*ruling'2 + dp'2) (1); known (dq'3) (alpha*dp'3 + beta*ruling'3 + dp'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance rho]; first [(exists (2), (3), ((((2))*(7) + ((3))*(13)) / (1)), ((((2))*(8) + ((3))*(14)) / (1)), ((((2))*(9) + ((3))*(15)) / (1)), 7, 8, 9, ((((2))*(7) + ((3))*(13) + (7)) / (1)), ((((2))*(8) + ((3))*(14) + (8)) / (1)), ((((2))*(9) + ((3))*(15) + (9)) / (1)), 13, 14, 15; met) | (exists (0), (0), ((((0))*(0) + ((0))*(0)) / (1)), ((((0))*(0) + ((0))*(0)) / (1)), ((((0))*(0) + ((0))*(0)) / (1)), 0, 0, 0, ((((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0) + ((0))*(0) + (0)) / (1)), 0, 0, 0; met) | (exists (13), (8), ((((13))*(7) + ((8))*(1)) / (1)), ((((13))*(9) + ((8))*(4)) / (1)), ((((13))*(7) + ((8))*(13)) / (1)), 7, 9, 7, ((((13))*(7) + ((8))*(1) + (7)) / (1)), ((((13))*(9) + ((8))*(4) + (9)) / (1)), ((((13))*(7) + ((8))*(13) + (7)) / (1)), 1, 4, 13; met) | (exists (1), (1), ((((1))*(6) + ((1))*(9)) / (1)), ((((1))*(8) + ((1))*(7)) / (1)), ((((1))*(7) + ((1))*(7)) / (1)), 6, 8, 7, ((((1))*(6) + ((1))*(9) + (6)) / (1)), ((((1))*(8) + ((1))*(7) + (8)) / (1)), ((((1))*(7) + ((1))*(7) + (7)) / (1)), 9, 7, 7; met) | (exists (1), (0), ((((1))*(0) + ((0))*(1)) / (1)), ((((1))*(1) + ((0))*(0)) / (1)), ((((1))*(0) + ((0))*(0)) / (1)), 0, 1, 0, ((((1))*(0) + ((0))*(1) + (0)) / (1)), ((((1))*(1) + ((0))*(0) + (1)) / (1)), ((((1))*(0) + ((0))*(0) + (0)) / (1)), 1, 0, 0; met)]. Qed.
End eq_3_1.

Module eq_3_1_must.
Import HermiteDevelopable.Section_3.eq_3_1_must.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal rho beta]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal rho beta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7; met) | (exists 6, 8, 7, 8, 7, 9, 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1; met)]. Qed.
End eq_3_1_must.

Module eq_3_1_types_a.
Import HermiteDevelopable.Section_3.eq_3_1_types_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement d_cylinder cylinder d_cone cone d_second d_first second first]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance d_cylinder cylinder d_cone cone d_second d_first second first]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12), 13, 14, 15, (16), (17), 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), 0, 0, 0, (0), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11), 1, 4, 13, (8), (8), 6, 8, 7; met) | (exists 8, 8, 6, 7, 7, 2, 4, 13, 8, (1), (1), 6, 8, 7, (1), (1), 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), (0), 1, 0, 0, (0), (0), 0, 1, 0; met)]. Qed.
End eq_3_1_types_a.

Module eq_3_1_types_b.
Import HermiteDevelopable.Section_3.eq_3_1_types_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement weight dg d_point point dg_]; identity. Qed.
End eq_3_1_types_b.

Module eq_3_1_parallel_planes.
Import HermiteDevelopable.Section_3.eq_3_1_parallel_planes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement dq dp ruling]; unstaged; prepared; known (beta) (0) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance dq dp ruling]; first [(exists ((0) / (1)), (3), (4), (5), (6), (7), (8), (9), (10); met) | (exists ((0) / (1)), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists ((0) / (1)), (8), (8), (6), (8), (7), (9), (7), (7); met) | (exists ((0) / (1)), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists ((0) / (1)), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End eq_3_1_parallel_planes.

Module eq_3_1_rho_constant.
Import HermiteDevelopable.Section_3.eq_3_1_rho_constant.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement parallel q q_ p p_]; intros; ratios ltac:(fun u => apply monomial_curve); in_ratio; compute_goal; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cbv beta zeta delta [parallel q p]; ratios ltac:(fun u => apply monomial_curve); met_joins. Qed.
End eq_3_1_rho_constant.

Module eq_3_1_rho_quadratic.
Import HermiteDevelopable.Section_3.eq_3_1_rho_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12), (13), (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0), (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11), (1), (1 / 3); met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (1), (1), (1), (1 / 3); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), (0), (0), (1 / 3); met)]. Qed.
End eq_3_1_rho_quadratic.

Module eq_3_1_difficulties_same.
Import HermiteDevelopable.Section_3.eq_3_1_difficulties_same.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q q_ p_ p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat]; similarities 5%nat; repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve; cbv beta iota delta [slope_n]; images; compute_goal; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q q_ p_ p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; joins ltac:(fun u => apply monomial_curve); counted_joins; met_joins. Qed.
End eq_3_1_difficulties_same.

Module eq_3_2.
Import HermiteDevelopable.Section_3.eq_3_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (dp'1*k - ruling'1) (1); known (dq'2) (dp'2*k - ruling'2) (1); known (dq'3) (dp'3*k - ruling'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, (((2)*((8)) - (9)) / (1)), (((3)*((8)) - (10)) / (1)), (((4)*((8)) - (11)) / (1)), (8), 9, 10, 11; met) | (exists 0, 0, 0, (((0)*((0)) - (0)) / (1)), (((0)*((0)) - (0)) / (1)), (((0)*((0)) - (0)) / (1)), (0), 0, 0, 0; met) | (exists 13, 8, 8, (((13)*((9)) - (7)) / (1)), (((8)*((9)) - (7)) / (1)), (((8)*((9)) - (2)) / (1)), (9), 7, 7, 2; met) | (exists 6, 8, 7, (((6)*((1)) - (9)) / (1)), (((8)*((1)) - (7)) / (1)), (((7)*((1)) - (7)) / (1)), (1), 9, 7, 7; met) | (exists 1, 0, 0, (((1)*((1)) - (0)) / (1)), (((0)*((1)) - (0)) / (1)), (((0)*((1)) - (1)) / (1)), (1), 0, 0, 1; met)]. Qed.
End eq_3_2.

Module eq_3_2_edge.
Import HermiteDevelopable.Section_3.eq_3_2_edge.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dg'1) (dp'1*k - dp'1 - ruling'1) (1); known (dg'2) (dp'2*k - dp'2 - ruling'2) (1); known (dg'3) (dp'3*k - dp'3 - ruling'3) (1); known (dq'1) (dp'1*k - ruling'1) (1); known (dq'2) (dp'2*k - ruling'2) (1); known (dq'3) (dp'3*k - ruling'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (((5)*((11)) - (5) - (12)) / (1)), (((6)*((11)) - (6) - (13)) / (1)), (((7)*((11)) - (7) - (14)) / (1)), 5, 6, 7, (((5)*((11)) - (12)) / (1)), (((6)*((11)) - (13)) / (1)), (((7)*((11)) - (14)) / (1)), (11), 12, 13, 14; met) | (exists (((0)*((0)) - (0) - (0)) / (1)), (((0)*((0)) - (0) - (0)) / (1)), (((0)*((0)) - (0) - (0)) / (1)), 0, 0, 0, (((0)*((0)) - (0)) / (1)), (((0)*((0)) - (0)) / (1)), (((0)*((0)) - (0)) / (1)), (0), 0, 0, 0; met) | (exists (((6)*((2)) - (6) - (11)) / (1)), (((8)*((2)) - (8) - (1)) / (1)), (((7)*((2)) - (7) - (4)) / (1)), 6, 8, 7, (((6)*((2)) - (11)) / (1)), (((8)*((2)) - (1)) / (1)), (((7)*((2)) - (4)) / (1)), (2), 11, 1, 4; met) | (exists (((6)*((1)) - (6) - (9)) / (1)), (((8)*((1)) - (8) - (7)) / (1)), (((7)*((1)) - (7) - (7)) / (1)), 6, 8, 7, (((6)*((1)) - (9)) / (1)), (((8)*((1)) - (7)) / (1)), (((7)*((1)) - (7)) / (1)), (1), 9, 7, 7; met) | (exists (((0)*((1)) - (0) - (1)) / (1)), (((1)*((1)) - (1) - (0)) / (1)), (((0)*((1)) - (0) - (0)) / (1)), 0, 1, 0, (((0)*((1)) - (1)) / (1)), (((1)*((1)) - (0)) / (1)), (((0)*((1)) - (0)) / (1)), (1), 1, 0, 0; met)]. Qed.
End eq_3_2_edge.

Module eq_3_2_planes_a_generatrix.
Import HermiteDevelopable.Section_3.eq_3_2_planes_a_generatrix.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not P Q dp dq]; intro no; apply (no 0 2 0 0 0 0 0 0 0 0 0 ltac:(lra) ltac:(lra)); [ compute_goal; parts; ring | intros h k x0 y0 y1 y2 y3 z0 z1 z2 z3 K N E; compute_in E; injection E; intros; lra ]. Qed.
End eq_3_2_planes_a_generatrix.

Module eq_3_2_planes_a_direction.
Import HermiteDevelopable.Section_3.eq_3_2_planes_a_direction.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement P Q dp dq]; intros; intro no; assert (absurd : 1 = 0) by (apply (no 1 2 0 0 0 1 0 0 0 0 0 0 0 0); [ lra | lra | compute_goal; parts; ring ]); lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance P Q dp dq]; exists 1, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0; refine (conj _ (conj _ _)); [ lra | lra | compute_goal; parts; ring ]. Qed.
End eq_3_2_planes_a_direction.

Module eq_3_2_planes_b_generatrix.
Import HermiteDevelopable.Section_3.eq_3_2_planes_b_generatrix.
Theorem refuted : ~ statement.
Proof. assert (C : forall f0 f1 f2 f3 f4 f5 k u, across f0 f1 f2 f3 f4 f5 k u = poly [f0 + k * f1; f1 + 2 * k * f2; f2 + 3 * k * f3; f3 + 4 * k * f4; f4 + 5 * k * f5; f5] u) by (intros; cbv beta delta [across f]; derivatives; cbn [poly]; ring); assert (P : forall f0 f1 f2 f3 f4 f5 k z, part f0 f1 f2 f3 f4 f5 k z = nth (Z.to_nat z) [f0 + k * f1; f1 + 2 * k * f2; f2 + 3 * k * f3; f3 + 4 * k * f4; f4 + 5 * k * f5; f5] 0) by (intros; exact (coefficient_of _ _ (Z.to_nat z) (C f0 f1 f2 f3 f4 f5 k))); cbv beta zeta delta [statement]; intro no; apply (no 0 0 0 0 0 0 1 0); clear no; [lra | lra | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | rewrite !P; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth]; repeat split; ring | intros f0 f1 f2 f3 f4 f5 k u K U _ _ _ _ _ _ _ _ _ _ _ _ E; rewrite !P in E; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth] in E; destruct E as (E5 & E4 & E3 & E2 & E1 & E0); assert (Z5 : f5 = 0) by (lra); subst f5; assert (Z4 : f4 = 0) by (lra); subst f4; assert (Z3 : f3 = 0) by (lra); subst f3; assert (Z2 : f2 = 0) by (lra); subst f2; assert (Z1 : f1 = 0) by (lra); subst f1; cbv beta delta [f]; derivatives; ring]. Qed.
End eq_3_2_planes_b_generatrix.

Module eq_3_2_planes_b_direction.
Import HermiteDevelopable.Section_3.eq_3_2_planes_b_direction.
Theorem refuted : ~ statement.
Proof. assert (C : forall f0 f1 f2 f3 f4 f5 k s u, across f0 f1 f2 f3 f4 f5 k s u = poly [k * f0 + k * f1 - (1 - k) * s; k * f1 + 2 * k * f2; k * f2 + 3 * k * f3; k * f3 + 4 * k * f4; k * f4 + 5 * k * f5; k * f5] u) by (intros; cbv beta delta [across f]; derivatives; cbn [poly]; ring); assert (P : forall f0 f1 f2 f3 f4 f5 k s z, part f0 f1 f2 f3 f4 f5 k s z = nth (Z.to_nat z) [k * f0 + k * f1 - (1 - k) * s; k * f1 + 2 * k * f2; k * f2 + 3 * k * f3; k * f3 + 4 * k * f4; k * f4 + 5 * k * f5; k * f5] 0) by (intros; exact (coefficient_of _ _ (Z.to_nat z) (C f0 f1 f2 f3 f4 f5 k s))); cbv beta zeta delta [statement]; intro no; apply (no 0 0 0 0 0 0 1 0 0); clear no; [lra | lra | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | rewrite !P; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth]; repeat split; ring | intros f0 f1 f2 f3 f4 f5 k s u K U _ _ _ _ _ _ _ _ _ _ _ _ E; rewrite !P in E; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth] in E; destruct E as (E5 & E4 & E3 & E2 & E1 & E0); assert (Z5 : f5 = 0) by (apply (cancelled k); [lra | lra]); subst f5; assert (Z4 : f4 = 0) by (apply (cancelled k); [lra | lra]); subst f4; assert (Z3 : f3 = 0) by (apply (cancelled k); [lra | lra]); subst f3; assert (Z2 : f2 = 0) by (apply (cancelled k); [lra | lra]); subst f2; assert (Z1 : f1 = 0) by (apply (cancelled k); [lra | lra]); subst f1; cbv beta delta [f]; derivatives; ring]. Qed.
End eq_3_2_planes_b_direction.

Module eq_3_2_planes_parallel.
Import HermiteDevelopable.Section_3.eq_3_2_planes_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage f; stage across; staged_goal part; unstaged; prepared; known (f0) (k*s - s) (k); known (f1) (0) (1); known (f2) (0) (1); known (f3) (0) (1); known (f4) (0) (1); known (f5) (0) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage f; stage across; staged_goal part; unstaged; first [(exists ((((8))*((9)) - ((9))) / (((8)))), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (8), (9), (1 / 3); met) | (exists ((((0))*((0)) - ((0))) / (((0)))), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0), (1 / 2); met) | (exists ((((9))*((7)) - ((7))) / (((9)))), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (9), (7), (1 / 3); met) | (exists ((((1))*((1)) - ((1))) / (((1)))), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (1), (1), (1 / 3); met) | (exists ((((0))*((0)) - ((0))) / (((0)))), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0), (1 / 3); met)]. Qed.
End eq_3_2_planes_parallel.

Module eq_3_2_with_h.
Import HermiteDevelopable.Section_3.eq_3_2_with_h.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); known (hv'1) (-P'1*k + Q'1 + k*o'1 - o'1) (1); known (hv'2) (-P'2*k + Q'2 + k*o'2 - o'2) (1); known (hv'3) (-P'3*k + Q'3 + k*o'3 - o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2)*((17)) - (5) + (8)*((17)) - ((17))*(19) + (19)) / (1)), (((3)*((17)) - (6) + (9)*((17)) - ((17))*(20) + (20)) / (1)), (((4)*((17)) - (7) + (10)*((17)) - ((17))*(21) + (21)) / (1)), ((-(2)*((17)) + (5) + ((17))*(19) - (19)) / (1)), ((-(3)*((17)) + (6) + ((17))*(20) - (20)) / (1)), ((-(4)*((17)) + (7) + ((17))*(21) - (21)) / (1)), (17), (18), 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), (0), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13)*((8)) - (6) + (9)*((8)) - ((8))*(8) + (8)) / (1)), (((8)*((8)) - (8) + (7)*((8)) - ((8))*(7) + (7)) / (1)), (((8)*((8)) - (7) + (7)*((8)) - ((8))*(9) + (9)) / (1)), ((-(13)*((8)) + (6) + ((8))*(8) - (8)) / (1)), ((-(8)*((8)) + (8) + ((8))*(7) - (7)) / (1)), ((-(8)*((8)) + (7) + ((8))*(9) - (9)) / (1)), (8), (6), 8, 7, 9; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), ((-(8)*((1)) + (8) + ((1))*(9) - (9)) / (1)), ((-(8)*((1)) + (6) + ((1))*(7) - (7)) / (1)), ((-(6)*((1)) + (8) + ((1))*(7) - (7)) / (1)), (1), (1), 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (0) + (1)*((1)) - ((1))*(1) + (1)) / (1)), ((-(1)*((1)) + (0) + ((1))*(0) - (0)) / (1)), ((-(0)*((1)) + (1) + ((1))*(0) - (0)) / (1)), ((-(0)*((1)) + (0) + ((1))*(1) - (1)) / (1)), (1), (0), 0, 0, 1; met)]. Qed.
End eq_3_2_with_h.

Module eq_3_2_across.
Import HermiteDevelopable.Section_3.eq_3_2_across.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1 - Q'1 + dp'1*k) (1); known (dq'2) (P'2 - Q'2 + dp'2*k) (1); known (dq'3) (P'3 - Q'3 + dp'3*k) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (((2) - (5) + (11)*((17))) / (1)), (((3) - (6) + (12)*((17))) / (1)), (((4) - (7) + (13)*((17))) / (1)), (17), 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0) - (0) + (0)*((0))) / (1)), (((0) - (0) + (0)*((0))) / (1)), (((0) - (0) + (0)*((0))) / (1)), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (((13) - (6) + (2)*((8))) / (1)), (((8) - (8) + (11)*((8))) / (1)), (((8) - (7) + (1)*((8))) / (1)), (8), 6, 8, 7; met) | (exists 8, 8, 6, 8, 6, 8, 7, 7, 2, 6, 8, 7, (((8) - (8) + (6)*((1))) / (1)), (((8) - (6) + (8)*((1))) / (1)), (((6) - (8) + (7)*((1))) / (1)), (1), 8, 7, 9; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (((1) - (0) + (1)*((1))) / (1)), (((0) - (1) + (0)*((1))) / (1)), (((0) - (0) + (0)*((1))) / (1)), (1), 0, 0, 1; met)]. Qed.
End eq_3_2_across.

Module eq_3_2_across_summit.
Import HermiteDevelopable.Section_3.eq_3_2_across_summit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (((2)*((17)) - (5) + (11)*((17)) - ((17))*(21) + (21)) / (1)), (((3)*((17)) - (6) + (12)*((17)) - ((17))*(22) + (22)) / (1)), (((4)*((17)) - (7) + (13)*((17)) - ((17))*(23) + (23)) / (1)), (17), 18, 19, 20, 21, 22, 23; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (0), 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (((13)*((8)) - (6) + (2)*((8)) - ((8))*(9) + (9)) / (1)), (((8)*((8)) - (8) + (11)*((8)) - ((8))*(7) + (7)) / (1)), (((8)*((8)) - (7) + (1)*((8)) - ((8))*(7) + (7)) / (1)), (8), 6, 8, 7, 9, 7, 7; met) | (exists 8, 8, 6, 8, 6, 8, 7, 7, 2, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), (1), 8, 7, 9, 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (((1)*((1)) - (0) + (1)*((1)) - ((1))*(1) + (1)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (1), 0, 0, 1, 1, 0, 0; met)]. Qed.
End eq_3_2_across_summit.

Module eq_3_2_every_degree.
Import HermiteDevelopable.Section_3.eq_3_2_every_degree.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement leading H H_]; intros n c d N _ _ _ _; rewrite Rmult_0_r, Rmult_0_l, Rplus_0_r; rewrite sum_last by lia; rewrite (sum_ext 0 (n - 1) _ (fun _ => 0 * 0)) by (intros i I; rewrite (natural_power 0 (n - i)) by lia; replace (Z.to_nat (n - i)) with (S (Z.to_nat (n - i - 1))) by lia; cbn [pow]; ring); rewrite sum_scal, Rmult_0_l, Rplus_0_l; rewrite Z.sub_diag, !natural_power by lia; rewrite pow1; cbn [Z.to_nat pow]; assert (F : forall m, falling (INR m) m = 1) by (let m := fresh in intro m; induction m as [|m IH]; [ reflexivity | pose proof (not_zero m); apply Rmult_eq_reg_r with (INR (S m)); [ rewrite S_INR at 1; rewrite lowered, IH, S_INR; ring | assumption ] ]); assert (B1 : binom (IZR n) n = 1) by (unfold binom; destruct (Z.leb_spec 0 n); [ | lia ]; transitivity (falling (INR (Z.to_nat n)) (Z.to_nat n)); [ | apply F ]; f_equal; rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); rewrite B1; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1%Z, 0, (fun _ => 0); repeat match goal with |- _ /\ _ => split end; intros; try (left; lia); try lia; apply filter_forall; intros; left; lia. Qed.
End eq_3_2_every_degree.

Module eq_3_3_g_generatrix.
Import HermiteDevelopable.Section_3.eq_3_3_g_generatrix.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement Q] in no; refuting (no (0) (0) (0) (0) (0) (1) (2) (2) (1) (0) (0)). Qed.
End eq_3_3_g_generatrix.

Module eq_3_3_g_direction.
Import HermiteDevelopable.Section_3.eq_3_3_g_direction.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q]; identity. Qed.
End eq_3_3_g_direction.

Module eq_3_3_g_true.
Import HermiteDevelopable.Section_3.eq_3_3_g_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q]; identity. Qed.
End eq_3_3_g_true.

Module eq_3_3a.
Import HermiteDevelopable.Section_3.eq_3_3a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); known (ruling'1) (-P'1*k + Q'1 + k*o'1 - o'1) (1); known (ruling'2) (-P'2*k + Q'2 + k*o'2 - o'2) (1); known (ruling'3) (-P'3*k + Q'3 + k*o'3 - o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2)*((14)) - (5) + (8)*((14)) - ((14))*(15) + (15)) / (1)), (((3)*((14)) - (6) + (9)*((14)) - ((14))*(16) + (16)) / (1)), (((4)*((14)) - (7) + (10)*((14)) - ((14))*(17) + (17)) / (1)), (14), 15, 16, 17, ((-(2)*((14)) + (5) + ((14))*(15) - (15)) / (1)), ((-(3)*((14)) + (6) + ((14))*(16) - (16)) / (1)), ((-(4)*((14)) + (7) + ((14))*(17) - (17)) / (1)); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (0), 0, 0, 0, ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13)*((4)) - (6) + (9)*((4)) - ((4))*(13) + (13)) / (1)), (((8)*((4)) - (8) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (((8)*((4)) - (7) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (4), 13, 8, 8, ((-(13)*((4)) + (6) + ((4))*(13) - (13)) / (1)), ((-(8)*((4)) + (8) + ((4))*(8) - (8)) / (1)), ((-(8)*((4)) + (7) + ((4))*(8) - (8)) / (1)); met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), (1), 9, 7, 7, ((-(8)*((1)) + (8) + ((1))*(9) - (9)) / (1)), ((-(8)*((1)) + (6) + ((1))*(7) - (7)) / (1)), ((-(6)*((1)) + (8) + ((1))*(7) - (7)) / (1)); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(1) + (1)) / (1)), (((0)*((1)) - (0) + (1)*((1)) - ((1))*(0) + (0)) / (1)), (1), 0, 1, 0, ((-(1)*((1)) + (0) + ((1))*(0) - (0)) / (1)), ((-(0)*((1)) + (1) + ((1))*(1) - (1)) / (1)), ((-(0)*((1)) + (0) + ((1))*(0) - (0)) / (1)); met)]. Qed.
End eq_3_3a.

Module eq_3_3b.
Import HermiteDevelopable.Section_3.eq_3_3b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2)*((14)) - (5) + (8)*((14)) - ((14))*(15) + (15)) / (1)), (((3)*((14)) - (6) + (9)*((14)) - ((14))*(16) + (16)) / (1)), (((4)*((14)) - (7) + (10)*((14)) - ((14))*(17) + (17)) / (1)), (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13)*((4)) - (6) + (9)*((4)) - ((4))*(13) + (13)) / (1)), (((8)*((4)) - (8) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (((8)*((4)) - (7) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), (1), 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(1) + (1)) / (1)), (((0)*((1)) - (0) + (1)*((1)) - ((1))*(0) + (0)) / (1)), (1), 0, 1, 0; met)]. Qed.
End eq_3_3b.

Module eq_3_3_same_as_3_2_generatrix.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_generatrix.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (0) (2) (-1) (2) (1) (0) (0)). Qed.
End eq_3_3_same_as_3_2_generatrix.

Module eq_3_3_same_as_3_2_direction.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); known (ruling'1) (-P'1*k + Q'1 + k*o'1 - o'1) (1); known (ruling'2) (-P'2*k + Q'2 + k*o'2 - o'2) (1); known (ruling'3) (-P'3*k + Q'3 + k*o'3 - o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2)*((14)) - (5) + (8)*((14)) - ((14))*(15) + (15)) / (1)), (((3)*((14)) - (6) + (9)*((14)) - ((14))*(16) + (16)) / (1)), (((4)*((14)) - (7) + (10)*((14)) - ((14))*(17) + (17)) / (1)), (14), 15, 16, 17, ((-(2)*((14)) + (5) + ((14))*(15) - (15)) / (1)), ((-(3)*((14)) + (6) + ((14))*(16) - (16)) / (1)), ((-(4)*((14)) + (7) + ((14))*(17) - (17)) / (1)); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (0), 0, 0, 0, ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)), ((-(0)*((0)) + (0) + ((0))*(0) - (0)) / (1)); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13)*((4)) - (6) + (9)*((4)) - ((4))*(13) + (13)) / (1)), (((8)*((4)) - (8) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (((8)*((4)) - (7) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (4), 13, 8, 8, ((-(13)*((4)) + (6) + ((4))*(13) - (13)) / (1)), ((-(8)*((4)) + (8) + ((4))*(8) - (8)) / (1)), ((-(8)*((4)) + (7) + ((4))*(8) - (8)) / (1)); met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), (1), 9, 7, 7, ((-(8)*((1)) + (8) + ((1))*(9) - (9)) / (1)), ((-(8)*((1)) + (6) + ((1))*(7) - (7)) / (1)), ((-(6)*((1)) + (8) + ((1))*(7) - (7)) / (1)); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(1) + (1)) / (1)), (((0)*((1)) - (0) + (1)*((1)) - ((1))*(0) + (0)) / (1)), (1), 0, 1, 0, ((-(1)*((1)) + (0) + ((1))*(0) - (0)) / (1)), ((-(0)*((1)) + (1) + ((1))*(1) - (1)) / (1)), ((-(0)*((1)) + (0) + ((1))*(0) - (0)) / (1)); met)]. Qed.
End eq_3_3_same_as_3_2_direction.

Module eq_3_3_same_as_3_2_true.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; unstaged; prepared; known (dq'1) (P'1 - Q'1 + dp'1*k) (1); known (dq'2) (P'2 - Q'2 + dp'2*k) (1); known (dq'3) (P'3 - Q'3 + dp'3*k) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2) - (5) + (8)*((14))) / (1)), (((3) - (6) + (9)*((14))) / (1)), (((4) - (7) + (10)*((14))) / (1)), (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0) - (0) + (0)*((0))) / (1)), (((0) - (0) + (0)*((0))) / (1)), (((0) - (0) + (0)*((0))) / (1)), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13) - (6) + (9)*((4))) / (1)), (((8) - (8) + (7)*((4))) / (1)), (((8) - (7) + (7)*((4))) / (1)), (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8) - (8) + (6)*((1))) / (1)), (((8) - (6) + (8)*((1))) / (1)), (((6) - (8) + (7)*((1))) / (1)), (1), 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1) - (0) + (0)*((1))) / (1)), (((0) - (1) + (0)*((1))) / (1)), (((0) - (0) + (1)*((1))) / (1)), (1), 0, 1, 0; met)]. Qed.
End eq_3_3_same_as_3_2_true.

Module eq_3_3_developable_Hermite.
Import HermiteDevelopable.Section_3.eq_3_3_developable_Hermite.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat]; similarities 5%nat; repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve; cbv beta iota delta [slope_n]; images; any_points; compute_goal; conjuncts; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; joins ltac:(fun u => apply monomial_curve); counted_joins; met_joins. Qed.
End eq_3_3_developable_Hermite.

Module eq_3_3_developable_any.
Import HermiteDevelopable.Section_3.eq_3_3_developable_any.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (-1) (2) (-1) (2) (1) (0) (0)). Qed.
End eq_3_3_developable_any.

Module eq_3_3_exact.
Import HermiteDevelopable.Section_3.eq_3_3_exact.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement gap]; unstaged; prepared; known (dq'1) (P'1*k - Q'1 + dp'1*k - k*o'1 + o'1) (1); known (dq'2) (P'2*k - Q'2 + dp'2*k - k*o'2 + o'2) (1); known (dq'3) (P'3*k - Q'3 + dp'3*k - k*o'3 + o'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance gap]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (((2)*((14)) - (5) + (8)*((14)) - ((14))*(15) + (15)) / (1)), (((3)*((14)) - (6) + (9)*((14)) - ((14))*(16) + (16)) / (1)), (((4)*((14)) - (7) + (10)*((14)) - ((14))*(17) + (17)) / (1)), (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (((0)*((0)) - (0) + (0)*((0)) - ((0))*(0) + (0)) / (1)), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (((13)*((4)) - (6) + (9)*((4)) - ((4))*(13) + (13)) / (1)), (((8)*((4)) - (8) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (((8)*((4)) - (7) + (7)*((4)) - ((4))*(8) + (8)) / (1)), (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, (((8)*((1)) - (8) + (6)*((1)) - ((1))*(9) + (9)) / (1)), (((8)*((1)) - (6) + (8)*((1)) - ((1))*(7) + (7)) / (1)), (((6)*((1)) - (8) + (7)*((1)) - ((1))*(7) + (7)) / (1)), (1), 9, 7, 7; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (((1)*((1)) - (0) + (0)*((1)) - ((1))*(0) + (0)) / (1)), (((0)*((1)) - (1) + (0)*((1)) - ((1))*(1) + (1)) / (1)), (((0)*((1)) - (0) + (1)*((1)) - ((1))*(0) + (0)) / (1)), (1), 0, 1, 0; met)]. Qed.
End eq_3_3_exact.

Module eq_3_3_multiples_cone.
Import HermiteDevelopable.Section_3.eq_3_3_multiples_cone.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cone_normal cone_gap]; unstaged; prepared; known (dlam) (0) (1); known (lam) (k) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cone_normal cone_gap]; first [(exists ((0) / (1)), 3, 4, 5, (6), ((((6))) / (1)), 8, 9, 10; met) | (exists ((0) / (1)), 0, 0, 0, (0), ((((0))) / (1)), 0, 0, 0; met) | (exists ((0) / (1)), 8, 8, 6, (8), ((((8))) / (1)), 9, 7, 7; met) | (exists ((0) / (1)), 1, 4, 13, (1), ((((1))) / (1)), 8, 6, 8; met) | (exists ((0) / (1)), 1, 0, 0, (0), ((((0))) / (1)), 0, 1, 0; met)]. Qed.
End eq_3_3_multiples_cone.

Module eq_3_3_multiples_Hermite.
Import HermiteDevelopable.Section_3.eq_3_3_multiples_Hermite.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat]; similarities 5%nat; repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve; cbv beta iota delta [slope_n]; images; any_points; compute_goal; conjuncts; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; joins ltac:(fun u => apply monomial_curve); counted_joins; met_joins. Qed.
End eq_3_3_multiples_Hermite.

Module eq_3_3_multiples_any.
Import HermiteDevelopable.Section_3.eq_3_3_multiples_any.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (-1) (1) (-1) (2) (1) (1) (0)). Qed.
End eq_3_3_multiples_any.

Module eq_3_3_k_below_1.
Import HermiteDevelopable.Section_3.eq_3_3_k_below_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement P Q cone_gap cone_normal]; intros dlam a b c k lam d e f x y z; compute_goal; intros K N S G1 G2; assert (E : lam - k = 0) by (match type of N with ?n <> 0 => apply (Rmult_eq_reg_r n); [ rewrite Rmult_0_l; match type of G1 with ?g = 0 => replace ((lam - k) * n) with g by ring; exact G1 end | exact N ] end); replace lam with k by lra; split; [ parts; ring | match type of S with ?s > 0 => match goal with |- ?l < 0 => replace l with (- (k * (1 - k) * s)) by ring; assert (0 < k * (1 - k)) by nra; assert (0 < k * (1 - k) * s) by (apply Rmult_lt_0_compat; lra); lra end end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cone_normal cone_gap Q P]; first [(exists ((0) / (1)), 3, 4, 5, (1 / 3), ((((1 / 3))) / (1)), 8, 9, 10, 11, 12, 13; met) | (exists ((0) / (1)), 0, 0, 0, (1 / 2), ((((1 / 2))) / (1)), 0, 0, 0, 0, 0, 0; met) | (exists ((0) / (1)), 8, 8, 6, (1 / 3), ((((1 / 3))) / (1)), 9, 7, 7, 2, 11, 1; met) | (exists ((0) / (1)), 1, 4, 13, (1 / 3), ((((1 / 3))) / (1)), 9, 7, 7, 8, 6, 8; met) | (exists ((0) / (1)), 1, 0, 0, (1 / 3), ((((1 / 3))) / (1)), 0, 1, 0, 0, 0, 1; met)]. Qed.
End eq_3_3_k_below_1.

Module eq_3_3_k_equal_1.
Import HermiteDevelopable.Section_3.eq_3_3_k_equal_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement P Q cone_gap cone_normal]; intros dlam a b c k lam d e f x y z; compute_goal; intros N S K G1 G2; assert (E : lam - k = 0) by (match type of N with ?n <> 0 => apply (Rmult_eq_reg_r n); [ rewrite Rmult_0_l; match type of G1 with ?g = 0 => replace ((lam - k) * n) with g by ring; exact G1 end | exact N ] end); replace lam with 1 by lra; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cone_normal cone_gap Q P]; first [(exists ((0) / (1)), 3, 4, 5, (1), ((1) / (1)), 8, 9, 10, 11, 12, 13; met) | (exists ((0) / (1)), 0, 0, 0, (1), ((1) / (1)), 0, 0, 0, 0, 0, 0; met) | (exists ((0) / (1)), 8, 8, 6, (1), ((1) / (1)), 9, 7, 7, 2, 11, 1; met) | (exists ((0) / (1)), 1, 4, 13, (1), ((1) / (1)), 9, 7, 7, 8, 6, 8; met) | (exists ((0) / (1)), 1, 0, 0, (1), ((1) / (1)), 0, 1, 0, 0, 0, 1; met)]. Qed.
End eq_3_3_k_equal_1.

Module eq_3_3_k_above_1.
Import HermiteDevelopable.Section_3.eq_3_3_k_above_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cone_normal cone_gap P Q]; unstaged; prepared; known (dlam) (0) (1); known (lam) (k) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cone_normal cone_gap P Q]; first [(exists ((0) / (1)), 3, 4, 5, (2), ((((2))) / (1)), 8, 9, 10, 11, 12, 13; met) | (exists ((0) / (1)), 0, 0, 0, (2), ((((2))) / (1)), 0, 0, 0, 0, 0, 0; met) | (exists ((0) / (1)), 8, 8, 6, (9), ((((9))) / (1)), 9, 7, 7, 2, 11, 1; met) | (exists ((0) / (1)), 1, 4, 13, (2), ((((2))) / (1)), 9, 7, 7, 8, 6, 8; met) | (exists ((0) / (1)), 1, 0, 0, (2), ((((2))) / (1)), 0, 1, 0, 0, 0, 1; met)]. Qed.
End eq_3_3_k_above_1.

Module sec_3_summit_outside.
Import HermiteDevelopable.Section_3.sec_3_summit_outside.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a5 a4 a3 a2 a1 a0 p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______ q]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat]; similarities 5%nat; curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve; cbv beta iota delta [slope_n]; images; cbv beta iota delta [entry nth Nat.pred]; split; [cbv beta iota delta [slope slopes tl poly]; ring | match goal with K : 0 < ?k, N : ?h ^ 2 > 0 |- ?x > 0 => replace x with (k * h ^ 2) by (cbn [poly]; ring); apply Rmult_lt_0_compat; [exact K | exact N] end]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a5 a4 a3 a2 a1 a0 p gap part criterion criterion__ criterion___ criterion____ criterion_____ criterion______ q]; exists 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; joins ltac:(fun u => apply monomial_curve); counted_joins; cbv beta iota delta [entry nth Nat.pred]; met_joins. Qed.
End sec_3_summit_outside.

Module eq_3_4.
Import HermiteDevelopable.Section_3.eq_3_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p q g ruled]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p q g ruled]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End eq_3_4.
