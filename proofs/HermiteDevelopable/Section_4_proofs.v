(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From HermiteDevelopable Require Section_4.
Import HermiteDevelopable.Section_4.Definitions.
From HermiteDevelopable Require Import Section_4_closed.
Open Scope R_scope.

Module sec_4_cone.
Import HermiteDevelopable.Section_4.sec_4_cone.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; staged_goal quintic_criterion______; unstaged; prepared; known (o) (k*p0 - q0) (k - 1); known (p0u) (q0u) (k); known (p1) (k*p0 - q0 + q1) (k); known (p1u) (q1u) (k); known (qm) (-k*p0 + k*pm + q0) (1); known (qu) (k*pu) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; staged_goal quintic_criterion______; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), ((((8))*(10) - (16)) / (((8)) - 1)), 10, (((17)) / (((8)))), ((((8))*(10) - (16) + (18)) / (((8)))), (((19)) / (((8)))), 14, 15, 16, 17, 18, 19, ((-((8))*(10) + ((8))*(14) + (16)) / (1)), ((((8))*(15)) / (1)), (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, (0), ((((0))*(0) - (0)) / (((0)) - 1)), 0, (((0)) / (((0)))), ((((0))*(0) - (0) + (0)) / (((0)))), (((0)) / (((0)))), 0, 0, 0, 0, 0, 0, ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0)) / (1)), (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, (9), ((((9))*(7) - (8)) / (((9)) - 1)), 7, (((8)) / (((9)))), ((((9))*(7) - (8) + (6)) / (((9)))), (((8)) / (((9)))), 4, 13, 8, 8, 6, 8, ((-((9))*(7) + ((9))*(4) + (8)) / (1)), ((((9))*(13)) / (1)), (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)), (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)), (1 / 3); met)]. Qed.
End sec_4_cone.

Module eq_4_1.
Import HermiteDevelopable.Section_4.eq_4_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement oblique oblique_ normal]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance oblique oblique_ normal]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (1 / 3), (12); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (1 / 3), (11); met) | (exists 7, 9, 7, 7, 2, 11, 7, 2, 11, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End eq_4_1.

Module sec_4_goal_leaves.
Import HermiteDevelopable.Section_4.sec_4_goal_leaves.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage q0; stage r0; stage qm; stage o; stage normal; stage image; stage r; stage q1; stage r1; stage q0u; stage r0u; stage qu; stage ru; stage q1u; stage r1u; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage r5; staged_goal q5; unstaged; intros; conjuncts; first [ intro no; first [ refuting (no 13 8 8 6 8 7 (1 / 3) (7) (7) (2) (11) (1) (4) (13) (8) (8) (6)) | refuting (no 2 3 4 5 6 7 (1 / 3) (9) (10) (11) (12) (13) (14) (15) (16) (17) (18)) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage q0; stage r0; stage qm; stage o; stage normal; stage image; stage r; stage q1; stage r1; stage q0u; stage r0u; stage qu; stage ru; stage q1u; stage r1u; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage r5; staged_goal q5; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (1 / 3), (9), (10), (11), (12), (13), (14), (15), (16), (17), (18); met) | (exists 0, 0, 0, 0, 0, 0, (1 / 2), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, (1 / 3), (7), (7), (2), (11), (1), (4), (13), (8), (8), (6); met) | (exists 1, 1, 1, 1, 1, 1, (1 / 3), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists 0, 0, 0, 0, 0, 0, (1 / 3), (1), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_4_goal_leaves.

Module sec_4_goal_nodes.
Import HermiteDevelopable.Section_4.sec_4_goal_nodes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal r0u r0 image r ru r1 r1u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r0u r0 image r ru r1 r1u]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11, 7, 2, 11, 7, 2, 11, 13, 8, 8, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1; met)]. Qed.
End sec_4_goal_nodes.

Module sec_4_goal_only.
Import HermiteDevelopable.Section_4.sec_4_goal_only.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image]; unstaged; prepared; known (w) (a'1*d'2*o'3 - a'1*d'2*q0'3 - a'1*d'3*o'2 + a'1*d'3*q0'2 - a'2*d'1*o'3 + a'2*d'1*q0'3 + a'2*d'3*o'1 - a'2*d'3*q0'1 + a'3*d'1*o'2 - a'3*d'1*q0'2 - a'3*d'2*o'1 + a'3*d'2*q0'1) (a'1*c'2*d'3 - a'1*c'3*d'2 + a'1*d'2*o'3 - a'1*d'3*o'2 - a'2*c'1*d'3 + a'2*c'3*d'1 - a'2*d'1*o'3 + a'2*d'3*o'1 + a'3*c'1*d'2 - a'3*c'2*d'1 + a'3*d'1*o'2 - a'3*d'2*o'1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, (((2)*(9)*(13) - (2)*(9)*(16) - (2)*(10)*(12) + (2)*(10)*(15) - (3)*(8)*(13) + (3)*(8)*(16) + (3)*(10)*(11) - (3)*(10)*(14) + (4)*(8)*(12) - (4)*(8)*(15) - (4)*(9)*(11) + (4)*(9)*(14)) / ((2)*(6)*(10) - (2)*(7)*(9) + (2)*(9)*(13) - (2)*(10)*(12) - (3)*(5)*(10) + (3)*(7)*(8) - (3)*(8)*(13) + (3)*(10)*(11) + (4)*(5)*(9) - (4)*(6)*(8) + (4)*(8)*(12) - (4)*(9)*(11))); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0)) / ((0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0))); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, (((13)*(7)*(1) - (13)*(7)*(8) - (13)*(7)*(11) + (13)*(7)*(13) - (8)*(9)*(1) + (8)*(9)*(8) + (8)*(7)*(2) - (8)*(7)*(4) + (8)*(9)*(11) - (8)*(9)*(13) - (8)*(7)*(2) + (8)*(7)*(4)) / ((13)*(8)*(7) - (13)*(7)*(7) + (13)*(7)*(1) - (13)*(7)*(11) - (8)*(6)*(7) + (8)*(7)*(9) - (8)*(9)*(1) + (8)*(7)*(2) + (8)*(6)*(7) - (8)*(8)*(9) + (8)*(9)*(11) - (8)*(7)*(2))); met) | (exists 7, 9, 7, 7, 7, 2, 7, 2, 11, 9, 7, 7, 7, 2, 11, (((7)*(2)*(7) - (7)*(2)*(11) - (7)*(11)*(7) + (7)*(11)*(2) - (9)*(7)*(7) + (9)*(7)*(11) + (9)*(11)*(9) - (9)*(11)*(7) + (7)*(7)*(7) - (7)*(7)*(2) - (7)*(2)*(9) + (7)*(2)*(7)) / ((7)*(7)*(11) - (7)*(2)*(2) + (7)*(2)*(7) - (7)*(11)*(7) - (9)*(7)*(11) + (9)*(2)*(7) - (9)*(7)*(7) + (9)*(11)*(9) + (7)*(7)*(2) - (7)*(7)*(7) + (7)*(7)*(7) - (7)*(2)*(9))); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, (((1)*(0)*(0) - (1)*(0)*(0) - (1)*(1)*(0) + (1)*(1)*(1) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(1)*(1) - (0)*(1)*(0) + (0)*(0)*(0) - (0)*(0)*(1) - (0)*(0)*(1) + (0)*(0)*(0)) / ((1)*(1)*(1) - (1)*(0)*(0) + (1)*(0)*(0) - (1)*(1)*(0) - (0)*(0)*(1) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(1)*(1) + (0)*(0)*(0) - (0)*(1)*(0) + (0)*(0)*(0) - (0)*(0)*(1))); met)]. Qed.
End sec_4_goal_only.

Module sec_4_goal_parallel.
Import HermiteDevelopable.Section_4.sec_4_goal_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage normal; stage shadow; stage turned; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage p5; staged_goal r_; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage normal; stage shadow; stage turned; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage p5; staged_goal r_; unstaged; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, (1 / 3), 39, 40, 41; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3), 1, 4, 13; met) | (exists 1, 1, 1, 1, 1, 1, 7, 9, 7, 7, 7, 2, 7, 2, 11, 7, 7, 2, 7, 7, 2, 7, 7, 2, 7, 7, 2, 4, 13, 8, 7, 7, 2, 7, 2, 11, (1 / 3), 8, 6, 8; met) | (exists 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1 / 3), 0, 1, 0; met)]. Qed.
End sec_4_goal_parallel.

Module sec_4_r0.
Import HermiteDevelopable.Section_4.sec_4_r0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image r0]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image r0]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0; met)]. Qed.
End sec_4_r0.

Module sec_4_I1.
Import HermiteDevelopable.Section_4.sec_4_I1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; split; [apply value_of; [ assumption | lra ] | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_I1.

Module sec_4_w.
Import HermiteDevelopable.Section_4.sec_4_w.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of; [ assumption | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_w.

Module eq_4_2.
Import HermiteDevelopable.Section_4.eq_4_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?n / ?d] => assert (W : w = n / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_2.

Module eq_4_2_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord image r0u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (1) (1) (0)). Qed.
End eq_4_2_tangent_derivative.

Module eq_4_2_tangent_end_point.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image r0 r0u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image r0 r0u]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_end_point.

Module eq_4_2_tangent_parallel.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord r0u image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord r0u image]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_parallel.

Module eq_4_2_tangent_true.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord first image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord first image]; exists 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0; met. Qed.
End eq_4_2_tangent_true.

Module sec_4_s.
Import HermiteDevelopable.Section_4.sec_4_s.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of; [ assumption | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_s.

Module eq_4_3.
Import HermiteDevelopable.Section_4.eq_4_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?n / ?d] => assert (W : s = n / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_3.

Module eq_4_4_ru.
Import HermiteDevelopable.Section_4.eq_4_4_ru.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal r image]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- _ = (?m / ?d * _ - _) :: _ => assert (W : t = m / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_ru.

Module eq_4_4_r1.
Import HermiteDevelopable.Section_4.eq_4_4_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?zz / ?d] => assert (W : n = zz / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_r1.

Module eq_4_4_r1u.
Import HermiteDevelopable.Section_4.eq_4_4_r1u.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal r1 image]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- _ = (?z / ?d * _ - _) :: _ => assert (W : m = z / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r1]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_r1u.

Module eq_4_4_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord last image r ru r1 r1u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (0) (1) (1) (1) (0) (1) (0) (2) (0) (1) (1) (0)). Qed.
End eq_4_4_tangent_derivative.

Module eq_4_4_tangent_parallel.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord last image r ru r1 r1u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord last image r ru r1 r1u]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0; met. Qed.
End eq_4_4_tangent_parallel.

Module sec_4_oblique.
Import HermiteDevelopable.Section_4.sec_4_oblique.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal normal2 a d not]; compute_goal; split; intro E; injection E; intros; lra. Qed.
End sec_4_oblique.

Module ex_4_r0.
Import HermiteDevelopable.Section_4.ex_4_r0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o a d normal image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o a d normal image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r0.

Module ex_4_r0u.
Import HermiteDevelopable.Section_4.ex_4_r0u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q0 o q0u a d normal r0u] in no; refuting (no ). Qed.
End ex_4_r0u.

Module ex_4_r.
Import HermiteDevelopable.Section_4.ex_4_r.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement qm o a d normal q0 image r]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance qm o a d normal q0 image r]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r.

Module ex_4_ru.
Import HermiteDevelopable.Section_4.ex_4_ru.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement qm o qu a d normal q0 image r ru] in no; refuting (no ). Qed.
End ex_4_ru.

Module ex_4_r1.
Import HermiteDevelopable.Section_4.ex_4_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1.

Module ex_4_r1_rounding.
Import HermiteDevelopable.Section_4.ex_4_r1_rounding.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1_rounding.

Module ex_4_r1u.
Import HermiteDevelopable.Section_4.ex_4_r1u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q1 o q1u a d normal q0 image r1 r1u] in no; refuting (no ). Qed.
End ex_4_r1u.

Module ex_4_other_data.
Import HermiteDevelopable.Section_4.ex_4_other_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_other_data.

Module ex_4_stated_data.
Import HermiteDevelopable.Section_4.ex_4_stated_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_stated_data.

Module ex_4_true_tangents.
Import HermiteDevelopable.Section_4.ex_4_true_tangents.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 q0u first o a d normal qm qu middle q1 q1u last image]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 q0u first o a d normal qm qu middle q1 q1u last image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_true_tangents.
