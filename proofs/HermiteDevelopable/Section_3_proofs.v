(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From HermiteDevelopable Require Section_3.
Open Scope R_scope.

Module def_3_1.
Import HermiteDevelopable.Section_3.def_3_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p g ruled ruled_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p g ruled ruled_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, (1 / 3), (1); met)]. Qed.
End def_3_1.

Module def_3_1_normal.
Import HermiteDevelopable.Section_3.def_3_1_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p g ruled]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p g ruled]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, 1, 4, 13, (1 / 3), (1); met)]. Qed.
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
Proof. cbv beta zeta delta [instance p q g ruled ruled_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, (1 / 3), (1); met)]. Qed.
End sec_3_g_boundary.

Module sec_3_g_prime.
Import HermiteDevelopable.Section_3.sec_3_g_prime.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1) (1) (1) (1) (0) (1) (0) (0) (2) (1) (0) (0) (1) (0)). Qed.
End sec_3_g_prime.

Module sec_3_g_prime_corrected.
Import HermiteDevelopable.Section_3.sec_3_g_prime_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dg'1; unknown dg'2; unknown dg'3; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists (1), (1), 7, 7, 2, 6, 8, 7, 8, 7, 9, 9, 7, 7; met)]. Qed.
End sec_3_g_prime_corrected.

Module eq_3_1.
Import HermiteDevelopable.Section_3.eq_3_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement rho]; prepared; unknown dg'1; unknown dg'2; unknown dg'3; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance rho]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists (1), (1), 7, 7, 2, 6, 8, 7, 8, 7, 9, 9, 7, 7; met)]. Qed.
End eq_3_1.

Module eq_3_1_must.
Import HermiteDevelopable.Section_3.eq_3_1_must.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal rho beta]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal rho beta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7; met) | (exists 6, 8, 7, 8, 7, 9, 9, 7, 7; met)]. Qed.
End eq_3_1_must.

Module eq_3_1_types_a.
Import HermiteDevelopable.Section_3.eq_3_1_types_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement d_cylinder cylinder d_cone cone d_second d_first second first]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance d_cylinder cylinder d_cone cone d_second d_first second first]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12), 13, 14, 15, (16), (17), 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), 0, 0, 0, (0), (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11), 1, 4, 13, (8), (8), 6, 8, 7; met) | (exists 8, 8, 6, 7, 7, 2, 4, 13, 8, (1), (1), 6, 8, 7, (1), (1), 9, 7, 7; met)]. Qed.
End eq_3_1_types_a.

Module eq_3_1_types_b.
Import HermiteDevelopable.Section_3.eq_3_1_types_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement weight dg d_point point dg_]; identity. Qed.
End eq_3_1_types_b.

Module eq_3_1_rho_constant.
Import HermiteDevelopable.Section_3.eq_3_1_rho_constant.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q p parallel q_ p_]; prepared; unknown b5'1; unknown b5'2; unknown b5'3; unknown b4'1; unknown b4'2; unknown b4'3; unknown b3'1; unknown b3'2; unknown b3'3; unknown b2'1; unknown b2'2; unknown b2'3; unknown b1'1; unknown b1'2; unknown b1'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q p parallel q_ p_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (38), (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (11), (1 / 3); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, (1), (1 / 3); met)]. Qed.
End eq_3_1_rho_constant.

Module eq_3_2.
Import HermiteDevelopable.Section_3.eq_3_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2; met) | (exists 6, 8, 7, 8, 7, 9, (1), 9, 7, 7; met)]. Qed.
End eq_3_2.

Module eq_3_2_edge.
Import HermiteDevelopable.Section_3.eq_3_2_edge.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; unknown dg'1; unknown dg'2; unknown dg'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), 12, 13, 14; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), 11, 1, 4; met) | (exists 7, 7, 2, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7; met)]. Qed.
End eq_3_2_edge.

Module eq_3_2_across.
Import HermiteDevelopable.Section_3.eq_3_2_across.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, (17), 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, (8), 6, 8, 7; met) | (exists 8, 8, 6, 8, 6, 8, 7, 7, 2, 6, 8, 7, 8, 7, 9, (1), 8, 7, 9; met)]. Qed.
End eq_3_2_across.

Module eq_3_2_across_summit.
Import HermiteDevelopable.Section_3.eq_3_2_across_summit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, (17), 18, 19, 20, 21, 22, 23; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, (8), 6, 8, 7, 9, 7, 7; met) | (exists 8, 8, 6, 8, 6, 8, 7, 7, 2, 6, 8, 7, 8, 7, 9, (1), 8, 7, 9, 9, 7, 7; met)]. Qed.
End eq_3_2_across_summit.

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
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; unknown ruling'1; unknown ruling'2; unknown ruling'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17, 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8, 6, 8, 7; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7, 9, 7, 7; met)]. Qed.
End eq_3_3a.

Module eq_3_3b.
Import HermiteDevelopable.Section_3.eq_3_3b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7; met)]. Qed.
End eq_3_3b.

Module eq_3_3_same_as_3_2_generatrix.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_generatrix.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (0) (2) (-1) (2) (1) (0) (0)). Qed.
End eq_3_3_same_as_3_2_generatrix.

Module eq_3_3_same_as_3_2_direction.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; unknown ruling'1; unknown ruling'2; unknown ruling'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17, 18, 19, 20; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8, 6, 8, 7; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7, 9, 7, 7; met)]. Qed.
End eq_3_3_same_as_3_2_direction.

Module eq_3_3_same_as_3_2_true.
Import HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7; met)]. Qed.
End eq_3_3_same_as_3_2_true.

Module eq_3_3_developable_any.
Import HermiteDevelopable.Section_3.eq_3_3_developable_any.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (-1) (2) (-1) (2) (1) (0) (0)). Qed.
End eq_3_3_developable_any.

Module eq_3_3_exact.
Import HermiteDevelopable.Section_3.eq_3_3_exact.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement gap]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance gap]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8; met) | (exists 8, 8, 6, 8, 6, 8, 6, 8, 7, 8, 7, 9, (1), 9, 7, 7; met)]. Qed.
End eq_3_3_exact.

Module eq_3_3_multiples_any.
Import HermiteDevelopable.Section_3.eq_3_3_multiples_any.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (-1) (1) (-1) (2) (1) (1) (0)). Qed.
End eq_3_3_multiples_any.

Module eq_3_4.
Import HermiteDevelopable.Section_3.eq_3_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement p q g ruled]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance p q g ruled]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), (39); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), (1); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, (1 / 3), (1); met)]. Qed.
End eq_3_4.
