(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From HermiteDevelopable Require Section_3_1.
Open Scope R_scope.

Module sec_3_1_polynomials.
Import HermiteDevelopable.Section_3_1.sec_3_1_polynomials.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement first second]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance first second]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End sec_3_1_polynomials.

Module sec_3_1_substituted.
Import HermiteDevelopable.Section_3_1.sec_3_1_substituted.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement second first]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), 2, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1), 1, (1 / 3); met)]. Qed.
End sec_3_1_substituted.

Module sec_3_1_coefficients.
Import HermiteDevelopable.Section_3_1.sec_3_1_coefficients.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage second; stage first; stage gap; staged_goal part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first gap part]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1), 1; met)]. Qed.
End sec_3_1_coefficients.

Module sec_3_1_hermite_1.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_1.

Module sec_3_1_hermite_2.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_2.

Module sec_3_1_hermite_3.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_3.

Module sec_3_1_hermite_4.
Import HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_3_1_hermite_4.

Module eq_3_5_A_r1.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage cubic_part; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r1.

Module eq_3_5_A_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage cubic_part; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r2.

Module eq_3_5_A_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage cubic_part; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r3.

Module eq_3_5_A_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; stage cubic_part; staged_goal cubic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_A_r4.

Module eq_3_5_C_r1.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35 cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r1.

Module eq_3_5_C_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35 cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r2.

Module eq_3_5_C_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35 cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r3.

Module eq_3_5_C_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A35; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; stage cubic_gap; staged_goal cubic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35 cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap cubic_part]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15; met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_5_C_r4.

Module eq_3_5_det.
Import HermiteDevelopable.Section_3_1.eq_3_5_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A35]; identity. Qed.
End eq_3_5_det.

Module alg_3_1_step1.
Import HermiteDevelopable.Section_3_1.alg_3_1_step1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; staged_goal cubic_gap; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_ cubic_data cubic_basis blend4 hermite3 q3 p3 cubic_gap]; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15, (1 / 3); met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13, (1 / 3); met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End alg_3_1_step1.
