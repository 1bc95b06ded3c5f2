(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3_2.
Import HermiteDevelopable.Section_3_2.Definitions.
From HermiteDevelopable Require Import Section_3_2_closed.
Open Scope R_scope.

Module sec_3_2_curves.
Import HermiteDevelopable.Section_3_2.sec_3_2_curves.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement right_ x]; intros; match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A36 k) by (cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system]; with_quartic_numbers quartic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra; assert (N : k - 1 <> 0) by nonzero; unfold solve; cbv beta delta [A36]; match goal with |- context [inverse ?A] => inverse_known A (- 16 * k ^ 3 * (k - 1)) [[- 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0]; [15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [24 / k; - 6 / k; 2 / k; - 1 / k; 0]; [8 / k; - 3 / k; 0; - 1 / k; 0]; [24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end; compute_goal; conjuncts; parts; field; repeat split; assumption. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; match goal with |- context [det (quartic_system ?A ?B ?C ?E ?F ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j)] => let S := constr:(quartic_system A B C E F k o a b c d e f g h i j) in let E := fresh in assert (E : S = A36 k) by (cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system]; with_quartic_numbers quartic_basis system_joins); rewrite E; clear E end; cbv beta zeta delta [A36]; met_joins; determinants; numeric. Qed.
End sec_3_2_curves.

Module eq_3_6_A_r1.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r1.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_A_r1.

Module eq_3_6_A_r2.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r2.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_A_r2.

Module eq_3_6_A_r3.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r3.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_A_r3.

Module eq_3_6_A_r4.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r4.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_A_r4.

Module eq_3_6_A_r5.
Import HermiteDevelopable.Section_3_2.eq_3_6_A_r5.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_A_r5.

Module eq_3_6_B.
Import HermiteDevelopable.Section_3_2.eq_3_6_B.
Theorem refuted : ~ statement.
Proof. unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0 1); clear no; premises_met; intro C; apply (f_equal (fun v => nth 4 v 0)) in C; revert C; cbv beta iota zeta delta [A36 quartic_system mvec map nth dot zip fold_right]; rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r; match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with 0 by (symmetry; cbv beta zeta delta [blend5 hermite4 q4 p4 quartic_gap quartic_part]; with_quartic_numbers quartic_basis system_joins) end; lra. Qed.
End eq_3_6_B.

Module eq_3_6_B_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement]; intros; apply (f_equal2 mvec); [cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system]; with_quartic_numbers quartic_basis system_joins | reflexivity]. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_B_corrected.

Module eq_3_6_C_r1.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r1.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_C_r1.

Module eq_3_6_C_r2.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r2.
Theorem refuted : ~ statement.
Proof. unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; intro no; generalize (no 0 0 0 0 0 2 0 1 0 0 0 0 0 0 0 0 0); clear no; quartic_number_joins quartic_basis; fails. Qed.
End eq_3_6_C_r2.

Module eq_3_6_C_r2_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_C_r2_corrected.

Module eq_3_6_C_r3.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r3.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_C_r3.

Module eq_3_6_C_r4.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r4.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_6_C_r4.

Module eq_3_6_C_r5.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r5.
Theorem refuted : ~ statement.
Proof. unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; intro no; generalize (no 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 1 0); clear no; quartic_number_joins quartic_basis; fails. Qed.
End eq_3_6_C_r5.

Module eq_3_6_C_r5_corrected.
Import HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
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
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement]; intros; match goal with |- det ?A = ?v /\ det ?S = ?v => let E := fresh in assert (E : S = A) by (cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system]; with_quartic_numbers quartic_basis system_joins); rewrite E; clear E; assert (D : det A = v) by (cbv beta delta [A36]; sparse_det; ring); rewrite D end; split; reflexivity. Qed.
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
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; intros; with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins; first [lra | numeric]. Qed.
End eq_3_6_k.

Module eq_3_6_k_every.
Import HermiteDevelopable.Section_3_2.eq_3_6_k_every.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; intros; with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_parts quartic_basis ltac:(cbv beta zeta delta [blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins; first [lra | numeric]. Qed.
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
Proof. cbv beta zeta delta [statement A36 right_]; intros; unfold solve; match goal with |- context [inverse ?A] => inverse_known A (- 16 * k ^ 3 * (k - 1)) [[- 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0]; [15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [24 / k; - 6 / k; 2 / k; - 1 / k; 0]; [8 / k; - 3 / k; 0; - 1 / k; 0]; [24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end; compute_goal; (parts; field; nonzero). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2, 0, 0, 0, 0, 0, 0; cbv beta zeta delta [A36]; determinants; conjuncts; numeric. Qed.
End eq_3_6_system.

Module sec_3_2_advantage.
Import HermiteDevelopable.Section_3_2.sec_3_2_advantage.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; intros A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm u qm_of_pm p1_of_pm p0u_of_pm p1u_of_pm o_of_pm U K N DD _ _ _ _ _ _ _ _ _ _ CR e1 e2 e3 e4 e5 FN; clear CR e1 e2 e3 e4 e5; assert (KN : k <> 0) by lra; assert (V : forall s, qm_of_pm s = k * s + (q0 - k * p0) /\ p1_of_pm s = (q1 - q0 + k * p0) / k /\ p0u_of_pm s = q0u / k /\ p1u_of_pm s = q1u / k) by (intro s; specialize (FN s); with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; conjuncts; first [lra | (apply value_of; [assumption | lra])]); clear FN; let read := (let s := fresh in intro s; cbv beta; destruct (V s) as (V1 & V2 & V3 & V4); rewrite ?V1, ?V2, ?V3, ?V4; with_quartic_numbers quartic_basis values; reflexivity) in let told := (intro; cbv beta iota zeta delta [poly quartic_of bump]; field; assumption) in split; [parts; [apply (affine _ (fun s => poly (quartic_of p0 s ((q1 - q0 + k * p0) / k) (q0u / k) (q1u / k)) u)); [read | told] | apply (affine _ (fun s => poly (quartic_of q0 (k * s + (q0 - k * p0)) q1 q0u q1u) u)); [read | told]] |]; cbv beta zeta delta [bump bump_]; derivatives; repeat split; try field; [replace (16 * u ^ 2 * (1 - u) ^ 2) with ((4 * u * (1 - u)) ^ 2) by ring; apply pow2_ge_0 | assert (T : 0 <= u * (1 - u)) by (apply Rmult_le_pos; lra); assert (M : 4 * (u * (1 - u)) <= 1) by (pose proof (pow2_ge_0 (2 * u - 1)); lra); replace (16 * u ^ 2 * (1 - u) ^ 2) with ((4 * (u * (1 - u))) ^ 2) by ring; generalize dependent (u * (1 - u)); intros; nra]. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (fun s => 2 * s), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0); with_quartic_numbers quartic_basis ltac:(fun curve => conjuncts; intros; conjuncts; cbv beta zeta delta [blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; joins_of_numbers curve; counted_joins); met_joins; first [lra | numeric]. Qed.
End sec_3_2_advantage.

Module ex_3_2_q.
Import HermiteDevelopable.Section_3_2.ex_3_2_q.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_q.

Module ex_3_2_p1.
Import HermiteDevelopable.Section_3_2.ex_3_2_p1.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_p1.

Module ex_3_2_p0u.
Import HermiteDevelopable.Section_3_2.ex_3_2_p0u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_p0u.

Module ex_3_2_p1u.
Import HermiteDevelopable.Section_3_2.ex_3_2_p1u.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_p1u.

Module ex_3_2_o.
Import HermiteDevelopable.Section_3_2.ex_3_2_o.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; linearly. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_o.

Module ex_3_2_parallel.
Import HermiteDevelopable.Section_3_2.ex_3_2_parallel.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; quartic_joins quartic_basis; intros; equations; worth o'1 (100); worth p0u'1 (0); worth p1u'1 (0); worth p1'1 (40); worth qm'1 (-20); quartic_curves quartic_basis; parts; cbv beta iota delta [entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), (-20), (-45), 0, 0, 0; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]); met_joins. Qed.
End ex_3_2_parallel.
