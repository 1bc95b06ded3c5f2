(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From HermiteDevelopable Require Section_3_2.
Import HermiteDevelopable.Section_3_2.Definitions.
From HermiteDevelopable Require Import Section_3_2_closed.
Open Scope R_scope.

Module eq_3_6_A_r1.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_A_r1.

Module eq_3_6_A_r2.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_A_r2.

Module eq_3_6_A_r3.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_A_r3.

Module eq_3_6_A_r4.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_A_r4.

Module eq_3_6_A_r5.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; staged_goal quartic_system; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_A_r5.

Module eq_3_6_B.
Import HermiteDevelopable.Section_3_2.eq_3_6_B.
Theorem refuted : ~ statement.
Proof. unfold not; cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_system; staged_goal A36; unstaged; intro no; refuting (no 0 0 0 0 0 (2) (0) 0 (0) (0) (0) 0 0 0 0 0 (1)). Qed.
End eq_3_6_B.

Module eq_3_6_B_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_system; staged_goal A36; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_system; staged_goal A36; unstaged; first [(exists 2, 3, 4, 5, 6, (1), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_6_B_corrected.

Module eq_3_6_C_r1.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_C_r1.

Module eq_3_6_C_r2.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r2.
Theorem refuted : ~ statement.
Proof. unfold not; cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; intro no; refuting (no 0 0 0 0 0 (2) 0 (1) 0 0 0 (0) (0) (0) (0) (0) 0). Qed.
End eq_3_6_C_r2.

Module eq_3_6_C_r2_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; first [(exists 2, 3, 4, 5, 6, (1), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_6_C_r2_corrected.

Module eq_3_6_C_r3.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_C_r3.

Module eq_3_6_C_r4.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; first [(exists 2, 3, 4, 5, 6, (7), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End eq_3_6_C_r4.

Module eq_3_6_C_r5.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r5.
Theorem refuted : ~ statement.
Proof. unfold not; cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; intro no; refuting (no 0 0 0 0 0 (2) 0 (0) 0 0 0 0 (0) (0) 0 (1) 0). Qed.
End eq_3_6_C_r5.

Module eq_3_6_C_r5_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage A36; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; staged_goal quartic_part; unstaged; first [(exists 2, 3, 4, 5, 6, (1), 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, (7), 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 1, 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met) | (exists 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_6_C_r5_corrected.

Module eq_3_6_det.
Import HermiteDevelopable.Section_3_2.eq_3_6_det.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement A36] in no; refuting (no (2)). Qed.
End eq_3_6_det.

Module eq_3_6_det_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_det_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A36]; identity. Qed.
End eq_3_6_det_corrected.

Module eq_3_6_det_true.
Import HermiteDevelopable.Section_3_2.eq_3_6_det_true.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_system; cbv beta zeta delta [statement]; intros; match goal with E : quartic_system = _ |- _ => rewrite E end; unstaged; cbv beta delta [A36]; match goal with |- det ?A = ?v /\ det ?S = ?v => let E := fresh in assert (E : S = A) by (repeat first [reflexivity | apply (f_equal2 (@cons (list R))) | apply (f_equal2 (@cons R))]; field); rewrite E end; split; compute_goal; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_det_true.

Module eq_3_6_det_slip.
Import HermiteDevelopable.Section_3_2.eq_3_6_det_slip.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement slip]; identity. Qed.
End eq_3_6_det_slip.

Module eq_3_6_det_factored.
Import HermiteDevelopable.Section_3_2.eq_3_6_det_factored.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End eq_3_6_det_factored.

Module eq_3_6_k.
Import HermiteDevelopable.Section_3_2.eq_3_6_k.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_k.

Module eq_3_6_k_every.
Import HermiteDevelopable.Section_3_2.eq_3_6_k_every.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_criterion; stage quartic_criterion_; stage quartic_criterion__; stage quartic_criterion___; stage quartic_criterion____; staged_goal quartic_criterion_____; unstaged; prepared; known (o) (k*p0 - q0) (k - 1); known (p0u) (q0u) (k); known (p1) (k*p0 - q0 + q1) (k); known (p1u) (q1u) (k); known (qm) (-k*p0 + k*pm + q0) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; stage blend5; stage hermite4; stage q4; stage p4; stage quartic_gap; stage_at quartic_part [0; 1; 2; 3; 4]%Z; stage quartic_criterion; stage quartic_criterion_; stage quartic_criterion__; stage quartic_criterion___; stage quartic_criterion____; staged_goal quartic_criterion_____; unstaged; first [(exists 2, 3, 4, 5, 6, (7), ((((7))*(9) - (14)) / (((7)) - 1)), 9, (((15)) / (((7)))), ((((7))*(9) - (14) + (16)) / (((7)))), (((17)) / (((7)))), 13, 14, 15, 16, 17, ((-((7))*(9) + ((7))*(13) + (14)) / (1)); met) | (exists 0, 0, 0, 0, 0, (0), ((((0))*(0) - (0)) / (((0)) - 1)), 0, (((0)) / (((0)))), ((((0))*(0) - (0) + (0)) / (((0)))), (((0)) / (((0)))), 0, 0, 0, 0, 0, ((-((0))*(0) + ((0))*(0) + (0)) / (1)); met) | (exists 13, 8, 8, 6, 8, (7), ((((7))*(7) - (4)) / (((7)) - 1)), 7, (((13)) / (((7)))), ((((7))*(7) - (4) + (8)) / (((7)))), (((8)) / (((7)))), 1, 4, 13, 8, 8, ((-((7))*(7) + ((7))*(1) + (4)) / (1)); met) | (exists 1, 1, 1, 1, 1, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)); met) | (exists 0, 0, 0, 0, 0, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)); met)]. Qed.
End eq_3_6_k_every.

Module eq_3_6_k_135_136.
Import HermiteDevelopable.Section_3_2.eq_3_6_k_135_136.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement k quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____ A36 blend5 hermite4 quartic_criterion_ q4 p4]; quartic_number_joins quartic_basis; split; [determinants; numeric | found]. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance k quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____ A36 blend5 hermite4 quartic_criterion_ q4 p4]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_k_135_136.

Module eq_3_6_sol_q.
Import HermiteDevelopable.Section_3_2.eq_3_6_sol_q.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_sol_q.

Module eq_3_6_sol_p1.
Import HermiteDevelopable.Section_3_2.eq_3_6_sol_p1.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_sol_p1.

Module eq_3_6_sol_p0u.
Import HermiteDevelopable.Section_3_2.eq_3_6_sol_p0u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_sol_p0u.

Module eq_3_6_sol_p1u.
Import HermiteDevelopable.Section_3_2.eq_3_6_sol_p1u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_sol_p1u.

Module eq_3_6_sol_o.
Import HermiteDevelopable.Section_3_2.eq_3_6_sol_o.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_number_joins quartic_basis; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_sol_o.

Module eq_3_6_system.
Import HermiteDevelopable.Section_3_2.eq_3_6_system.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A36 right_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A36 right_]; first [(exists (2), (3), (4), (5), (6), (7), (8); met) | (exists (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9); met) | (exists (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0); met)]. Qed.
End eq_3_6_system.

Module ex_3_2_q.
Import HermiteDevelopable.Section_3_2.ex_3_2_q.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_q.

Module ex_3_2_p1.
Import HermiteDevelopable.Section_3_2.ex_3_2_p1.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_p1.

Module ex_3_2_p0u.
Import HermiteDevelopable.Section_3_2.ex_3_2_p0u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_p0u.

Module ex_3_2_p1u.
Import HermiteDevelopable.Section_3_2.ex_3_2_p1u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_p1u.

Module ex_3_2_o.
Import HermiteDevelopable.Section_3_2.ex_3_2_o.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_o.

Module ex_3_2_parallel.
Import HermiteDevelopable.Section_3_2.ex_3_2_parallel.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; intros; equations; worth o'1 (100); worth p0u'1 (0); worth p1u'1 (0); worth p1'1 (40); worth qm'1 (-20); quartic_curves quartic_basis; parts; cbv beta iota delta [entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), (-20), (-45), 0, 0, 0; quartic_joins quartic_basis; met_joins. Qed.
End ex_3_2_parallel.
