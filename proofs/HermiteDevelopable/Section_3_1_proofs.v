(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From HermiteDevelopable Require Section_3_1.
Import HermiteDevelopable.Section_3_1.Definitions.
From HermiteDevelopable Require Import Section_3_1_closed.
Open Scope R_scope.

Module sec_3_1_polynomials.
Import HermiteDevelopable.Section_3_1.sec_3_1_polynomials.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement first second]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance first second]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 3); met)]. Qed.
End sec_3_1_polynomials.

Module sec_3_1_substituted.
Import HermiteDevelopable.Section_3_1.sec_3_1_substituted.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement second first]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), 2, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1), 1, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1), 1, (1 / 3); met)]. Qed.
End sec_3_1_substituted.

Module sec_3_1_coefficients.
Import HermiteDevelopable.Section_3_1.sec_3_1_coefficients.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage second; stage first; stage gap; staged_goal part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first gap part]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1), 1; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1), 1; met)]. Qed.
End sec_3_1_coefficients.

Module sec_3_1_hermite_1.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_1.

Module sec_3_1_hermite_2.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_2.

Module sec_3_1_hermite_3.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_3.

Module sec_3_1_hermite_4.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_4.

Module eq_3_5_A_r1.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r1.

Module eq_3_5_A_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r2.

Module eq_3_5_A_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r3.

Module eq_3_5_A_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; staged_goal cubic_system; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r4.

Module eq_3_5_B.
Import HermiteDevelopable.Section_3_1.eq_3_5_B.
Theorem refuted : ~ statement.
Proof. unfold not; cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_system; staged_goal A35; unstaged; intro no; refuting (no 0 0 0 0 (2) 0 (0) (1) (0) (0) 0 0 0 0). Qed.
End eq_3_5_B.

Module eq_3_5_B_corrected.
Import HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_system; staged_goal A35; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_system; staged_goal A35; unstaged; first [(exists 2, 3, 4, 5, (1), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_5_B_corrected.

Module eq_3_5_C_r1.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r1.

Module eq_3_5_C_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r2.

Module eq_3_5_C_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r3.

Module eq_3_5_C_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r4.

Module eq_3_5_unique.
Import HermiteDevelopable.Section_3_1.eq_3_5_unique.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A35 right_ x]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35 right_ x]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End eq_3_5_unique.

Module eq_3_5_det.
Import HermiteDevelopable.Section_3_1.eq_3_5_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A35]; identity. Qed.
End eq_3_5_det.

Module eq_3_5_k.
Import HermiteDevelopable.Section_3_1.eq_3_5_k.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_criterion; stage cubic_criterion_; stage cubic_criterion__; stage cubic_criterion___; staged_goal cubic_criterion____; unstaged; prepared; known (q0'1) (-k*o'1 + k*p0'1 + o'1) (1); known (q0'2) (-k*o'2 + k*p0'2 + o'2) (1); known (q0'3) (-k*o'3 + k*p0'3 + o'3) (1); known (q0u'1) (k*p0u'1) (1); known (q0u'2) (k*p0u'2) (1); known (q0u'3) (k*p0u'3) (1); known (q1'1) (-k*o'1 + k*p1'1 + o'1) (1); known (q1'2) (-k*o'2 + k*p1'2 + o'2) (1); known (q1'3) (-k*o'3 + k*p1'3 + o'3) (1); known (q1u'1) (k*p1u'1) (1); known (q1u'2) (k*p1u'2) (1); known (q1u'3) (k*p1u'3) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_criterion; stage cubic_criterion_; stage cubic_criterion__; stage cubic_criterion___; staged_goal cubic_criterion____; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, ((-((6))*(7) + ((6))*(10) + (7)) / (1)), ((-((6))*(8) + ((6))*(11) + (8)) / (1)), ((-((6))*(9) + ((6))*(12) + (9)) / (1)), ((((6))*(13)) / (1)), ((((6))*(14)) / (1)), ((((6))*(15)) / (1)), ((-((6))*(7) + ((6))*(16) + (7)) / (1)), ((-((6))*(8) + ((6))*(17) + (8)) / (1)), ((-((6))*(9) + ((6))*(18) + (9)) / (1)), ((((6))*(19)) / (1)), ((((6))*(20)) / (1)), ((((6))*(21)) / (1)), (1 / 3); met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0)) / (1)), ((((0))*(0)) / (1)), ((((0))*(0)) / (1)), ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0)) / (1)), ((((0))*(0)) / (1)), ((((0))*(0)) / (1)), (1 / 2); met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, ((-((8))*(7) + ((8))*(7) + (7)) / (1)), ((-((8))*(9) + ((8))*(2) + (9)) / (1)), ((-((8))*(7) + ((8))*(11) + (7)) / (1)), ((((8))*(1)) / (1)), ((((8))*(4)) / (1)), ((((8))*(13)) / (1)), ((-((8))*(7) + ((8))*(8) + (7)) / (1)), ((-((8))*(9) + ((8))*(8) + (9)) / (1)), ((-((8))*(7) + ((8))*(6) + (7)) / (1)), ((((8))*(8)) / (1)), ((((8))*(7)) / (1)), ((((8))*(9)) / (1)), (1 / 3); met) | (exists 1, 1, 1, 1, (1), 9, 7, 7, 7, 7, 2, 7, 7, 2, 7, 7, 2, 7, 7, 2, ((-((1))*(9) + ((1))*(7) + (9)) / (1)), ((-((1))*(7) + ((1))*(7) + (7)) / (1)), ((-((1))*(7) + ((1))*(2) + (7)) / (1)), ((((1))*(7)) / (1)), ((((1))*(7)) / (1)), ((((1))*(2)) / (1)), ((-((1))*(9) + ((1))*(7) + (9)) / (1)), ((-((1))*(7) + ((1))*(7) + (7)) / (1)), ((-((1))*(7) + ((1))*(2) + (7)) / (1)), ((((1))*(7)) / (1)), ((((1))*(7)) / (1)), ((((1))*(2)) / (1)), (1 / 3); met) | (exists 0, 0, 0, 0, (1), 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, ((-((1))*(1) + ((1))*(0) + (1)) / (1)), ((-((1))*(0) + ((1))*(1) + (0)) / (1)), ((-((1))*(0) + ((1))*(0) + (0)) / (1)), ((((1))*(0)) / (1)), ((((1))*(0)) / (1)), ((((1))*(1)) / (1)), ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((-((1))*(0) + ((1))*(0) + (0)) / (1)), ((-((1))*(0) + ((1))*(0) + (0)) / (1)), ((((1))*(0)) / (1)), ((((1))*(1)) / (1)), ((((1))*(0)) / (1)), (1 / 3); met)]. Qed.
End eq_3_5_k.

Module eq_3_5_sol_p1.
Import HermiteDevelopable.Section_3_1.eq_3_5_sol_p1.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_5_sol_p1.

Module eq_3_5_sol_p0u.
Import HermiteDevelopable.Section_3_1.eq_3_5_sol_p0u.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_5_sol_p0u.

Module eq_3_5_sol_p1u.
Import HermiteDevelopable.Section_3_1.eq_3_5_sol_p1u.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_5_sol_p1u.

Module eq_3_5_sol_p0.
Import HermiteDevelopable.Section_3_1.eq_3_5_sol_p0.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_5_sol_p0.

Module sec_3_1_conclusion.
Import HermiteDevelopable.Section_3_1.sec_3_1_conclusion.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ x]; similar_cubics cubic_basis; split; [by_coefficients | split; [preimages; cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth Nat.pred]; field; nonzero | split; [preimages; cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth Nat.pred]; field; nonzero | parallel_tangents]]]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ x]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_joins cubic_basis; met_joins. Qed.
End sec_3_1_conclusion.

Module alg_3_1_step1.
Import HermiteDevelopable.Section_3_1.alg_3_1_step1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; staged_goal cubic_gap; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; staged_goal cubic_gap; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15, (1 / 3); met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13, (1 / 3); met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End alg_3_1_step1.

Module alg_3_1_step3.
Import HermiteDevelopable.Section_3_1.alg_3_1_step3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage A35; stage X; stage blend4; stage hermite3; stage q3; staged_goal p; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage A35; stage X; stage blend4; stage hermite3; stage q3; staged_goal p; unstaged; first [(exists 2, 3, 4, 5, (1), (7), (8), (9), (10), (11), (1 / 3); met) | (exists 0, 0, 0, 0, (1), (0), (0), (0), (0), (0), (1 / 2); met) | (exists 13, 8, 8, 6, (8), (7), (9), (7), (7), (2), (1 / 3); met) | (exists 1, 1, 1, 1, (1), (1), (1), (1), (1), (1), (1 / 3); met) | (exists 0, 0, 0, 0, (1), (1), (0), (0), (0), (0), (1 / 3); met)]. Qed.
End alg_3_1_step3.

Module sec_3_1_tension.
Import HermiteDevelopable.Section_3_1.sec_3_1_tension.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_criterion; stage cubic_criterion_; stage cubic_criterion__; stage cubic_criterion___; staged_goal cubic_criterion____; unstaged; prepared; known (p0) (k*o - o + q0) (k); known (p0u) (k1*q0u) (k); known (p1) (k*o - o + q1) (k); known (p1u) (k2*q1u) (k); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage_at cubic_part [0; 1; 2; 3]%Z; stage cubic_criterion; stage cubic_criterion_; stage cubic_criterion__; stage cubic_criterion___; staged_goal cubic_criterion____; unstaged; first [(exists 2, 3, 4, 5, (6), (7), (8), 9, ((((6))*(9) - (9) + (14)) / (((6)))), ((((7))*(15)) / (((6)))), ((((6))*(9) - (9) + (16)) / (((6)))), ((((8))*(17)) / (((6)))), 14, 15, 16, 17; met) | (exists 0, 0, 0, 0, (0), (0), (0), 0, ((((0))*(0) - (0) + (0)) / (((0)))), ((((0))*(0)) / (((0)))), ((((0))*(0) - (0) + (0)) / (((0)))), ((((0))*(0)) / (((0)))), 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), (7), (9), 7, ((((8))*(7) - (7) + (4)) / (((8)))), ((((7))*(13)) / (((8)))), ((((8))*(7) - (7) + (8)) / (((8)))), ((((9))*(8)) / (((8)))), 4, 13, 8, 8; met) | (exists 1, 1, 1, 1, (1), (1), (1), 1, ((((1))*(1) - (1) + (1)) / (((1)))), ((((1))*(1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), ((((1))*(1)) / (((1)))), 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, (1), (0), (0), 0, ((((1))*(0) - (0) + (0)) / (((1)))), ((((0))*(0)) / (((1)))), ((((1))*(0) - (0) + (0)) / (((1)))), ((((0))*(0)) / (((1)))), 0, 0, 0, 0; met)]. Qed.
End sec_3_1_tension.

Module ex_3_1_tension_effect.
Import HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage tense; stage start; stage tense_; stage_at start_ [1]%Z; stage end_; stage tense__; staged_goal end__; unstaged; intros; conjuncts; first [ intro no; first [ refuting (no 13 8 8 6 (8) (7) 9 7 7 2 11 1 4 13 8 8 6 8) | refuting (no 2 3 4 5 (6) (7) 8 9 10 11 12 13 14 15 16 17 18 19) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage tense; stage start; stage tense_; stage_at start_ [1]%Z; stage end_; stage tense__; staged_goal end__; unstaged; first [(exists 2, 3, 4, 5, (6), (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19; met) | (exists 0, 0, 0, 0, (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8; met) | (exists 1, 1, 1, 1, (1), (1), 7, 2, 11, 7, 2, 11, 7, 2, 11, 7, 2, 11; met) | (exists 0, 0, 0, 0, (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0; met)]. Qed.
End ex_3_1_tension_effect.

Module ex_3_1_p1.
Import HermiteDevelopable.Section_3_1.ex_3_1_p1.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_p1.

Module ex_3_1_p0u.
Import HermiteDevelopable.Section_3_1.ex_3_1_p0u.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_p0u.

Module ex_3_1_p1u.
Import HermiteDevelopable.Section_3_1.ex_3_1_p1u.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_p1u.

Module ex_3_1_p0.
Import HermiteDevelopable.Section_3_1.ex_3_1_p0.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_p0.

Module ex_3_1_parallel.
Import HermiteDevelopable.Section_3_1.ex_3_1_parallel.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ hermite3_ p3_ x]; intros; repeat match goal with H : context [vDerive] |- _ => revert H end; repeat match goal with |- context [cubic_basis_ ?a ?b ?c ?d ?v] => change (cubic_basis_ a b c d v) with (cubic_basis a b c d (IZR v)) end; similar_cubics cubic_basis; split; [by_coefficients | split; preimages; cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth Nat.pred]; field; nonzero]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_basis_ hermite3_ p3_ x]; exists 0, 0, 0, 0, 2, 0, 0, 0, (-10), 30, (45/2), 0, 0, 0, (-10), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_parallel.

Module ex_3_1_width.
Import HermiteDevelopable.Section_3_1.ex_3_1_width.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap narrow_part narrow_criterion narrow_criterion_ narrow_criterion__ narrow_criterion___]; similar_cubics cubic_basis; preimages; flat (cubic_of (-20) (-20) 0 0) (-20); any_points; compute_goal; split; [parts; field | match goal with |- ?x < ?y => replace x with (4 / 9 * y) by field end; apply longer; [lra | apply length_positive; numeric]]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap narrow_part narrow_criterion narrow_criterion_ narrow_criterion__ narrow_criterion___]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30), 0, (130/3), 40, 45, 0, (-20), 40, (130/3), (-100/3), 45, 0, (-100/3), (-40); cubic_joins cubic_basis; met_joins. Qed.
End ex_3_1_width.

Module ex_3_1_shapes.
Import HermiteDevelopable.Section_3_1.ex_3_1_shapes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage q0; stage q1; stage q0u; stage q1u; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage q2a; stage q2c; stage blend4_; stage hermite3_; staged_goal generic; unstaged; intros; conjuncts; first [ intro no; first [ refuting (no 13 8 8 6 8 7 9 7 (1 / 3)) | refuting (no 2 3 4 5 6 7 8 9 (1 / 3)) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage q0; stage q1; stage q0u; stage q1u; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage q2a; stage q2c; stage blend4_; stage hermite3_; staged_goal generic; unstaged; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 3); met)]. Qed.
End ex_3_1_shapes.
