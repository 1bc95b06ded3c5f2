(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_3_3.
Import HermiteDevelopable.Section_3_3.Definitions.
From HermiteDevelopable Require Import Section_3_3_closed.
Open Scope R_scope.

Module sec_3_3_curves.
Import HermiteDevelopable.Section_3_3.sec_3_3_curves.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement right_ x]; intros; match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A37 k) by (cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system]; with_quintic_numbers quintic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra; assert (N : k - 1 <> 0) by nonzero; unfold solve; cbv beta delta [A37]; match goal with |- context [inverse ?A] => inverse_known A (256 * k ^ 3 * (k - 1)) [[- 120 / k; 24 / k; - 6 / k; 2 / k; - 1 / k; 0]; [1165 / 16; - 29 / 2; 15 / 4; - 1; 1; 0]; [- 45 / k; 8 / k; - 3 / k; 0; - 1 / k; 0]; [1511 / 32; - 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0]; [- 76 / k; 15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [- 120 / (k - 1); 24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end; compute_goal; conjuncts; parts; field; repeat split; assumption. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; match goal with |- context [det (quintic_system ?A ?B ?C ?E ?F ?G ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j ?l ?m)] => let S := constr:(quintic_system A B C E F G k o a b c d e f g h i j l m) in let E := fresh in assert (E : S = A37 k) by (cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system]; with_quintic_numbers quintic_basis system_joins); rewrite E; clear E end; cbv beta zeta delta [A37]; met_joins; determinants; numeric. Qed.
End sec_3_3_curves.

Module eq_3_7_A_r1.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r1.

Module eq_3_7_A_r2.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r2.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r2.

Module eq_3_7_A_r3.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r3.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r3.

Module eq_3_7_A_r4.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r4.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r4.

Module eq_3_7_A_r5.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r5.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r5.

Module eq_3_7_A_r6.
Import HermiteDevelopable.Section_3_3.eq_3_7_A_r6.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row]; cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_A_r6.

Module eq_3_7_B.
Import HermiteDevelopable.Section_3_3.eq_3_7_B.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0 0 1 0); clear no; premises_met; intro C; apply (f_equal (fun v => nth 5 v 0)) in C; revert C; cbv beta iota zeta delta [A37 quintic_system mvec map nth dot zip fold_right]; rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r; match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with 0 by (symmetry; cbv beta zeta delta [blend6 hermite5 q5 p5 quintic_gap quintic_part]; with_quintic_numbers quintic_basis system_joins) end; lra. Qed.
End eq_3_7_B.

Module eq_3_7_B_corrected.
Import HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intros; apply (f_equal2 mvec); [cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system]; with_quintic_numbers quintic_basis system_joins | reflexivity]. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_B_corrected.

Module eq_3_7_C_r1.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r1.

Module eq_3_7_C_r2.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r2.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r2.

Module eq_3_7_C_r3.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r3.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r3.

Module eq_3_7_C_r4.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r4.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r4.

Module eq_3_7_C_r5.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r5.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r5.

Module eq_3_7_C_r6.
Import HermiteDevelopable.Section_3_3.eq_3_7_C_r6.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part]; quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_C_r6.

Module eq_3_7_det.
Import HermiteDevelopable.Section_3_3.eq_3_7_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A37]; intros; sparse_det; ring. Qed.
End eq_3_7_det.

Module eq_3_7_k.
Import HermiteDevelopable.Section_3_3.eq_3_7_k.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_k.

Module eq_3_7_k_needed.
Import HermiteDevelopable.Section_3_3.eq_3_7_k_needed.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intros; match goal with |- det (quintic_system ?A ?B ?C ?E ?F ?G ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j ?l ?m _) = 0 /\ _ => assert (S : forall k : Z, quintic_system A B C E F G o a b c d e f g h i j l m k = A37 (IZR k)) by (intro k; cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system]; with_quintic_numbers quintic_basis system_joins) end; assert (D : forall k, det (A37 k) = 256 * k ^ 3 * (k - 1)) by (intro k; cbv beta delta [A37]; sparse_det; ring); rewrite !S, !D; split; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins. Qed.
End eq_3_7_k_needed.

Module eq_3_7_sol_p0u.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p0u.

Module eq_3_7_sol_qu.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_qu.

Module eq_3_7_sol_p1u.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p1u.

Module eq_3_7_sol_q.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_q.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_q.

Module eq_3_7_sol_p1.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_p1.

Module eq_3_7_sol_o.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_o.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; quintic_number_joins quintic_basis; found. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric]. Qed.
End eq_3_7_sol_o.

Module eq_3_7_system.
Import HermiteDevelopable.Section_3_3.eq_3_7_system.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A37 right_]; intros; unfold solve; match goal with |- context [inverse ?A] => inverse_known A (256 * k ^ 3 * (k - 1)) [[- 120 / k; 24 / k; - 6 / k; 2 / k; - 1 / k; 0]; [1165 / 16; - 29 / 2; 15 / 4; - 1; 1; 0]; [- 45 / k; 8 / k; - 3 / k; 0; - 1 / k; 0]; [1511 / 32; - 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0]; [- 76 / k; 15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [- 120 / (k - 1); 24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end; compute_goal; (parts; field; nonzero). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2, 0, 0, 0, 0, 0, 0, 0; cbv beta zeta delta [A37]; determinants; conjuncts; numeric. Qed.
End eq_3_7_system.

Module sec_3_3_advantage.
Import HermiteDevelopable.Section_3_3.sec_3_3_advantage.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement wave wave_ blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; assert (V : forall s, p0u_of_pu s = q0u / k /\ p1u_of_pu s = q1u / k /\ p1_of_pu s = (k * p0 + q1 - q0) / k /\ qm_of_pu s = - k * p0 + q0 + k * pm /\ qu_of_pu s = k * s) by (let s := fresh in intro s; match goal with K : _ > 0, H : forall _ : R, _, E : quintic_basis = _ |- _ => generalize (H s); clear - K E end; quintic_number_joins quintic_basis; intros; assert (k <> 0) by lra; found); conjuncts; [ (with_quintic_numbers quintic_basis ltac:(fun curve => parts; affine_by ltac:(match goal with s : R |- _ => destruct (V s) as (E1 & E2 & E3 & E4 & E5); rewrite ?E1, ?E2, ?E3, ?E4, ?E5; clear E1 E2 E3 E4 E5 end; values curve; cbv beta iota zeta delta [poly quintic_of]))) | (try ring; derivatives; field) ..]. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (fun _ => 0), (fun s => 2 * s), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0); (cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); with_quintic_numbers quintic_basis ltac:(fun curve => joins_of_numbers curve; conjuncts; lazymatch goal with |- forall _, _ => intro; joins_of_numbers curve | |- _ => idtac end); counted_joins; met_joins; first [lra | numeric]. Qed.
End sec_3_3_advantage.

Module ex_3_3_equation.
Import HermiteDevelopable.Section_3_3.ex_3_3_equation.
Theorem refuted : ~ statement.
Proof. unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part quartic_criterion quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____]; intro no; generalize (no 0 0 0 0 0 100 20 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) (-20) 5 35); clear no; with_quartics quartic_basis joins; with_quartics quartic_basis curves_at; fails. Qed.
End ex_3_3_equation.

Module ex_3_3_equation_true.
Import HermiteDevelopable.Section_3_3.ex_3_3_equation_true.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_equation_true.

Module ex_3_3_p0u.
Import HermiteDevelopable.Section_3_3.ex_3_3_p0u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_p0u.

Module ex_3_3_qu.
Import HermiteDevelopable.Section_3_3.ex_3_3_qu.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_qu.

Module ex_3_3_p1u.
Import HermiteDevelopable.Section_3_3.ex_3_3_p1u.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_p1u.

Module ex_3_3_q.
Import HermiteDevelopable.Section_3_3.ex_3_3_q.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_q.

Module ex_3_3_p1.
Import HermiteDevelopable.Section_3_3.ex_3_3_p1.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_p1.

Module ex_3_3_o.
Import HermiteDevelopable.Section_3_3.ex_3_3_o.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_o.

Module ex_3_3_parallel.
Import HermiteDevelopable.Section_3_3.ex_3_3_parallel.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; worth o'1 (100); worth p0u'1 (0); worth p1u'1 (0); worth p1'1 (40); worth qm'1 (-20); worth qu'1 (0); quintic_curves quintic_basis; parts; cbv beta iota delta [entry nth Nat.pred]; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, 0, 0, (-20), 5, 35, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End ex_3_3_parallel.

Module fig_4d_constant.
Import HermiteDevelopable.Section_3_3.fig_4d_constant.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ patch patch_ normal normal_]; intros; with_quintics quintic_basis joins; cbv beta iota delta [zeros repeat]; similarities 5%nat; with_quintics quintic_basis patches; images; compute_goal; parts; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), (-70), 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ patch patch_ normal normal_]); met_joins. Qed.
End fig_4d_constant.
