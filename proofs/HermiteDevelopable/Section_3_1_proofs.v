(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
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
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_A_r1.

Module eq_3_5_A_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r2.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_A_r2.

Module eq_3_5_A_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r3.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_A_r3.

Module eq_3_5_A_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_A_r4.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_A_r4.

Module eq_3_5_B.
Import HermiteDevelopable.Section_3_1.eq_3_5_B.
Theorem refuted : ~ statement.
Proof. unfold not; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 2 0 0 1 0 0 0 0 0 0); clear no; premises_met; intro C; apply (f_equal (fun v => nth 3 v 0)) in C; revert C; cbv beta iota zeta delta [A35 cubic_system mvec map nth dot zip fold_right]; rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r; match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with (- 2) by (symmetry; cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part]; with_cubic_numbers cubic_basis system_joins) end; lra. Qed.
End eq_3_5_B.

Module eq_3_5_B_corrected.
Import HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement]; intros; apply (f_equal2 mvec); [cbv beta zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; with_cubic_numbers cubic_basis system_joins | reflexivity]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_B_corrected.

Module eq_3_5_C_r1.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r1.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part]; cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_C_r1.

Module eq_3_5_C_r2.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r2.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part]; cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_C_r2.

Module eq_3_5_C_r3.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r3.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part]; cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_C_r3.

Module eq_3_5_C_r4.
Import HermiteDevelopable.Section_3_1.eq_3_5_C_r4.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part]; cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_5_C_r4.

Module eq_3_5_unique.
Import HermiteDevelopable.Section_3_1.eq_3_5_unique.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement right_ x]; intros; assert (K : k <> 0) by (let E := fresh in intro E; match goal with H : det _ <> 0 |- _ => apply H; rewrite E; cbv beta delta [A35]; sparse_det; ring end); unfold solve; cbv beta delta [A35]; match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 / k; - 1 / k; 0; - 1 / k]; [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0]; [6 / k; - 2 / k; 1 / k; - 1 / k]] end; compute_goal; conjuncts; parts; field; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 1, 0, 0, 0, 0; cbv beta zeta delta [A35]; determinants; numeric. Qed.
End eq_3_5_unique.

Module eq_3_5_det.
Import HermiteDevelopable.Section_3_1.eq_3_5_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A35]; identity. Qed.
End eq_3_5_det.

Module eq_3_5_k.
Import HermiteDevelopable.Section_3_1.eq_3_5_k.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; similar_cubics cubic_basis; images; any_points; compute_goal; conjuncts; parts; ring. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_parts cubic_basis ltac:(cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]); met_joins. Qed.
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
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ x]); met_joins. Qed.
End sec_3_1_conclusion.

Module alg_3_1_step1.
Import HermiteDevelopable.Section_3_1.alg_3_1_step1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; staged_goal cubic_gap; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage p3; staged_goal cubic_gap; unstaged; first [(exists 2, 3, 4, 5, (6), 7, 8, 9, 10, 11, 12, 13, 14, 15, (1 / 3); met) | (exists 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, (8), 7, 9, 7, 7, 2, 11, 1, 4, 13, (1 / 3); met) | (exists 1, 1, 1, 1, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met) | (exists 0, 0, 0, 0, (1), 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End alg_3_1_step1.

Module alg_3_1_step2.
Import HermiteDevelopable.Section_3_1.alg_3_1_step2.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement right_ x]; intros; match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A35 k) by (cbv beta zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; with_cubic_numbers cubic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra; unfold solve; cbv beta delta [A35]; match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 / k; - 1 / k; 0; - 1 / k]; [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0]; [6 / k; - 2 / k; 1 / k; - 1 / k]] end; compute_goal; conjuncts; parts; field; assumption. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; match goal with |- context [det (cubic_system ?A ?B ?C ?E ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h)] => let S := constr:(cubic_system A B C E k o a b c d e f g h) in let E := fresh in assert (E : S = A35 k) by (cbv beta zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system]; with_cubic_numbers cubic_basis system_joins); rewrite E; clear E end; cbv beta zeta delta [A35]; met_joins; determinants; numeric. Qed.
End alg_3_1_step2.

Module alg_3_1_step3.
Import HermiteDevelopable.Section_3_1.alg_3_1_step3.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement p]; intros; assert (k <> 0) by lra; assert (E : X k o q0 q0u q1 q1u = [(q1 - (1 - k) * o) / k; q0u / k; q1u / k; (q0 - (1 - k) * o) / k]) by (unfold X, solve; cbv beta delta [A35]; match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 / k; - 1 / k; 0; - 1 / k]; [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0]; [6 / k; - 2 / k; 1 / k; - 1 / k]] end; compute_goal; parts; field; assumption); rewrite E; clear E; cbv beta zeta delta [q3 hermite3 blend4]; with_cubic_numbers cubic_basis number_curves; cbv beta iota zeta delta [entry nth Nat.pred slope_n slope slopes tl poly cubic_of]; field; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A35]; stage cubic; stage cubic_; stage cubic_data; exists 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0; met_joins; determinants; numeric. Qed.
End alg_3_1_step3.

Module sec_3_1_tension.
Import HermiteDevelopable.Section_3_1.sec_3_1_tension.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]; intros; with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_parts cubic_basis ltac:(cbv beta zeta delta [blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]); met_joins; first [lra | numeric]. Qed.
End sec_3_1_tension.

Module ex_3_1_arrange.
Import HermiteDevelopable.Section_3_1.ex_3_1_arrange.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement solved0 solved1 solved0_ solved1_ blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_criterion_]; intros A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u u p1_of_o p0u_of_o p1u_of_o p0_of_o U K DD _ _ _ _ _ _ _ _ CR KN e1 e2 e3 e4 FN; assert (F : forall s, p0_of_o s = (q0 + (k - 1) * s) / k /\ p1_of_o s = (q1 + (k - 1) * s) / k) by (intro s; clear CR e1 e2 e3 e4; specialize (FN s); with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; split; (apply value_of; [assumption | lra])); clear FN; split; [rewrite <- e4; apply F |]; split; [rewrite <- e1; apply F |]; split; [parts; [apply (affine _ (fun s => (q0 + (k - 1) * s) / k)) | apply (affine _ (fun s => (q1 + (k - 1) * s) / k))]; first [intro; apply F | intro; field; assumption] |]; clear F e1 e2 e3 e4 p1_of_o p0u_of_o p1u_of_o p0_of_o; let away := (clear CR; let no := fresh in intro no; generalize (no 0 0 0 0 1 1 0 0 0 0 0 0 0 0 0); clear no; with_cubic_numbers cubic_basis joins_of_numbers; counted_joins; repeat lazymatch goal with |- (?A -> _) -> False => let K := fresh in assert (K : A) by first [premise | near]; let N := fresh in intro N; specialize (N K); clear K; revert N end; derivatives; let C := fresh in intro C; contradiction_in C) in split; [away |]; split; [away |]; with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; with_cubic_numbers cubic_basis values; images; field; assumption. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0); with_cubic_numbers cubic_basis ltac:(fun curve => conjuncts; intros; conjuncts; cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_criterion_]; joins_of_numbers curve; counted_joins); met_joins; first [lra | numeric]. Qed.
End ex_3_1_arrange.

Module ex_3_1_tension_effect.
Import HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement blend4 hermite3 tense start tense_ start_ end_ tense__ end__]; intros; with_cubics cubic_basis ltac:(fun curve => let fails_at N := (generalize N; clear no; curves_at curve; fails) in conjuncts; lazymatch goal with |- ~ _ => intro no; first [fails_at (no 0 0 0 0 0 0 0 0 0 1 0 0 0 1 0 0 0 0) | fails_at (no 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0 1 0 0)] | |- _ => curves_at curve; compute_goal; parts; ring end). Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
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
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 2, 0, 0, 0, (-10), 30, (45/2), 0, 0, 0, (-10), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_basis_ hermite3_ p3_ x]); met_joins. Qed.
End ex_3_1_parallel.

Module ex_3_1_width.
Import HermiteDevelopable.Section_3_1.ex_3_1_width.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap narrow_part narrow_criterion narrow_criterion_ narrow_criterion__ narrow_criterion___]; similar_cubics cubic_basis; preimages; flat (cubic_of (-20) (-20) 0 0) (-20); any_points; compute_goal; split; [parts; field | match goal with |- ?x < ?y => replace x with (4 / 9 * y) by field end; apply longer; [lra | apply length_positive; numeric]]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30), 0, (130/3), 40, 45, 0, (-20), 40, (130/3), (-100/3), 45, 0, (-100/3), (-40); cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap narrow_part narrow_criterion narrow_criterion_ narrow_criterion__ narrow_criterion___]); met_joins. Qed.
End ex_3_1_width.

Module ex_3_1_shapes.
Import HermiteDevelopable.Section_3_1.ex_3_1_shapes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage q0; stage q1; stage q0u; stage q1u; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage q2a; stage q2c; stage blend4_; stage hermite3_; staged_goal generic; unstaged; intros; conjuncts; first [ intro no; first [ refuting (no 13 8 8 6 8 7 9 7 (1 / 3)) | refuting (no 2 3 4 5 6 7 8 9 (1 / 3)) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage q0; stage q1; stage q0u; stage q1u; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; stage blend4; stage hermite3; stage q3; stage q2a; stage q2c; stage blend4_; stage hermite3_; staged_goal generic; unstaged; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 3); met)]. Qed.
End ex_3_1_shapes.
