(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From HermiteDevelopable Require Section_3_3.
Import HermiteDevelopable.Section_3_3.Definitions.
From HermiteDevelopable Require Import Section_3_3_closed.
Open Scope R_scope.

Module eq_3_7_A_r1.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r1.

Module eq_3_7_A_r2.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r2.

Module eq_3_7_A_r3.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r3.

Module eq_3_7_A_r4.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r4.

Module eq_3_7_A_r5.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r5.

Module eq_3_7_A_r6.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r6.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; staged_goal quintic_system; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_A_r6.

Module eq_3_7_B.
Import HermiteDevelopable.Section_3_3.eq_3_7_B.
Theorem refuted : ~ statement.
Proof. unfold not; cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_system; staged_goal A37; unstaged; intro no; refuting (no 0 0 0 0 0 0 (2) (0) 0 (0) (0) (0) 0 0 0 0 0 0 (1) (0)). Qed.
End eq_3_7_B.

Module eq_3_7_B_corrected.
Import HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_system; staged_goal A37; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_system; staged_goal A37; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (1), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_7_B_corrected.

Module eq_3_7_C_r1.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r1.

Module eq_3_7_C_r2.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r2.

Module eq_3_7_C_r3.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r3.

Module eq_3_7_C_r4.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r4.

Module eq_3_7_C_r5.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r5.

Module eq_3_7_C_r6.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r6.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A37; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; staged_goal quintic_part; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21; met) | (exists 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, (9), 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9; met) | (exists 1, 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_7_C_r6.

Module eq_3_7_det.
Import HermiteDevelopable.Section_3_3.eq_3_7_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A37]; identity. Qed.
End eq_3_7_det.

Module eq_3_7_k.
Import HermiteDevelopable.Section_3_3.eq_3_7_k.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_k.

Module eq_3_7_sol_p0u.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p0u.

Module eq_3_7_sol_qu.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_qu.

Module eq_3_7_sol_p1u.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p1u.

Module eq_3_7_sol_q.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_q.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_q.

Module eq_3_7_sol_p1.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p1.

Module eq_3_7_sol_o.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_o.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_joins quintic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_o.

Module sec_3_3_advantage.
Import HermiteDevelopable.Section_3_3.sec_3_3_advantage.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; stage quintic_criterion______; stage wave; staged_goal wave_; unstaged; computed; intros; along (forall pu : R, p0u_of_pu pu = ((q0u) / (k)) /\ qu_of_pu pu = ((k*pu) / (1)) /\ p1u_of_pu pu = ((q1u) / (k)) /\ qm_of_pu pu = ((-k*p0 + k*pm + q0) / (1)) /\ p1_of_pu pu = ((k*p0 - q0 + q1) / (k)) /\ o_of_pu pu = ((k*p0 - q0) / (k - 1))); function p0u_of_pu; function qu_of_pu; function p1u_of_pu; function qm_of_pu; function p1_of_pu; function o_of_pu; conclusion; prepared; known (o) (k*p0 - q0) (k - 1); known (p0u) (q0u) (k); known (p1) (k*p0 - q0 + q1) (k); known (p1u) (q1u) (k); known (qm) (-k*p0 + k*pm + q0) (1); known (qu) (k*pu) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage_at quintic_part [0; 1; 2; 3; 4; 5]%Z; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; stage quintic_criterion______; stage wave; staged_goal wave_; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), ((((8))*(10) - (16)) / (((8)) - 1)), 10, (((17)) / (((8)))), ((((8))*(10) - (16) + (18)) / (((8)))), (((19)) / (((8)))), 14, 15, 16, 17, 18, 19, ((-((8))*(10) + ((8))*(14) + (16)) / (1)), ((((8))*(15)) / (1)), (1 / 3), (fun pu => (((17)) / (((8))))), (fun pu => ((((8))*pu) / (1))), (fun pu => (((19)) / (((8))))), (fun pu => ((-((8))*(10) + ((8))*(14) + (16)) / (1))), (fun pu => ((((8))*(10) - (16) + (18)) / (((8))))), (fun pu => ((((8))*(10) - (16)) / (((8)) - 1))); met) | (exists 0, 0, 0, 0, 0, 0, (0), ((((0))*(0) - (0)) / (((0)) - 1)), 0, (((0)) / (((0)))), ((((0))*(0) - (0) + (0)) / (((0)))), (((0)) / (((0)))), 0, 0, 0, 0, 0, 0, ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0)) / (1)), (1 / 2), (fun pu => (((0)) / (((0))))), (fun pu => ((((0))*pu) / (1))), (fun pu => (((0)) / (((0))))), (fun pu => ((-((0))*(0) + ((0))*(0) + (0)) / (1))), (fun pu => ((((0))*(0) - (0) + (0)) / (((0))))), (fun pu => ((((0))*(0) - (0)) / (((0)) - 1))); met) | (exists 13, 8, 8, 6, 8, 7, (9), ((((9))*(7) - (8)) / (((9)) - 1)), 7, (((8)) / (((9)))), ((((9))*(7) - (8) + (6)) / (((9)))), (((8)) / (((9)))), 4, 13, 8, 8, 6, 8, ((-((9))*(7) + ((9))*(4) + (8)) / (1)), ((((9))*(13)) / (1)), (1 / 3), (fun pu => (((8)) / (((9))))), (fun pu => ((((9))*pu) / (1))), (fun pu => (((8)) / (((9))))), (fun pu => ((-((9))*(7) + ((9))*(4) + (8)) / (1))), (fun pu => ((((9))*(7) - (8) + (6)) / (((9))))), (fun pu => ((((9))*(7) - (8)) / (((9)) - 1))); met) | (exists 1, 1, 1, 1, 1, 1, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)), (1 / 3), (fun pu => (((1)) / (((1))))), (fun pu => ((((1))*pu) / (1))), (fun pu => (((1)) / (((1))))), (fun pu => ((-((1))*(1) + ((1))*(1) + (1)) / (1))), (fun pu => ((((1))*(1) - (1) + (1)) / (((1))))), (fun pu => ((((1))*(1) - (1)) / (((1)) - 1))); met) | (exists 0, 0, 0, 0, 0, 0, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)), (1 / 3), (fun pu => (((1)) / (((1))))), (fun pu => ((((1))*pu) / (1))), (fun pu => (((1)) / (((1))))), (fun pu => ((-((1))*(1) + ((1))*(1) + (1)) / (1))), (fun pu => ((((1))*(1) - (1) + (1)) / (((1))))), (fun pu => ((((1))*(1) - (1)) / (((1)) - 1))); met)]. Qed.
End sec_3_3_advantage.

Module ex_3_3_equation.
Import HermiteDevelopable.Section_3_3.ex_3_3_equation.
Theorem refuted : ~ statement.
Proof. unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; intro no; generalize (no 0 0 0 0 0 100 20 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) (-20) 5 35); clear no; with_quartics quartic_basis joins; with_quartics quartic_basis curves_at; fails. Qed.
End ex_3_3_equation.

Module ex_3_3_equation_true.
Import HermiteDevelopable.Section_3_3.ex_3_3_equation_true.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_equation_true.

Module ex_3_3_p0u.
Import HermiteDevelopable.Section_3_3.ex_3_3_p0u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_p0u.

Module ex_3_3_qu.
Import HermiteDevelopable.Section_3_3.ex_3_3_qu.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_qu.

Module ex_3_3_p1u.
Import HermiteDevelopable.Section_3_3.ex_3_3_p1u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_p1u.

Module ex_3_3_q.
Import HermiteDevelopable.Section_3_3.ex_3_3_q.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_q.

Module ex_3_3_p1.
Import HermiteDevelopable.Section_3_3.ex_3_3_p1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_p1.

Module ex_3_3_o.
Import HermiteDevelopable.Section_3_3.ex_3_3_o.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_o.

Module ex_3_3_parallel.
Import HermiteDevelopable.Section_3_3.ex_3_3_parallel.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_joins quintic_basis; intros; equations; worth o'1 (100); worth p0u'1 (0); worth p1u'1 (0); worth p1'1 (40); worth qm'1 (-20); worth qu'1 (0); quintic_curves quintic_basis; parts; cbv beta iota delta [entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, 0, 0, (-20), 5, 35, 0, 0, 0, 0, 0, 0, 0, 0; quintic_joins quintic_basis; met_joins. Qed.
End ex_3_3_parallel.

Module fig_4d_constant.
Import HermiteDevelopable.Section_3_3.fig_4d_constant.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ patch patch_ normal normal_]; intros; with_quintics quintic_basis joins; cbv beta iota delta [zeros repeat]; similarities 5%nat; with_quintics quintic_basis patches; images; compute_goal; parts; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ patch patch_ normal normal_]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), (-70), 0, 0; quintic_joins quintic_basis; met_joins. Qed.
End fig_4d_constant.
