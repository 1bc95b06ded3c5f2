(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_4.
Import GbtDevelopable.Section_3_4.Definitions.
Open Scope R_scope.

Module eq_3_11_a.
Import GbtDevelopable.Section_3_4.eq_3_11_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_a.

Module eq_3_11_b.
Import GbtDevelopable.Section_3_4.eq_3_11_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_b.

Module eq_3_11_c.
Import GbtDevelopable.Section_3_4.eq_3_11_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_c.

Module eq_3_12_a.
Import GbtDevelopable.Section_3_4.eq_3_12_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_a.

Module eq_3_12_b.
Import GbtDevelopable.Section_3_4.eq_3_12_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_b.

Module eq_3_12_c.
Import GbtDevelopable.Section_3_4.eq_3_12_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_c.

Module sec_3_4_tangent_ends.
Import GbtDevelopable.Section_3_4.sec_3_4_tangent_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros; match goal with A : _ = HT ?T ?k ?mu ?nu 0%Z, B : _ = HT ?T ?k ?mu ?nu 1%Z |- _ => assert (C : HT T k mu nu 0%Z = T 0%Z) by (cbv beta delta [HT g]; lists; at_ends; reflexivity); assert (D : HT T k mu nu 1%Z = T k) by (cbv beta delta [HT g]; lists; at_ends; reflexivity); rewrite C in A; rewrite D in B; clear C D; rewrite <- A, <- B; clear A B end; clear - H6 H7 H9 H10; revert H6 H7 H9 H10; cbv beta zeta delta [P P_ O_ O__ normal direction moment foot J0 J0_ J1 J1_]; intros N L N' L'; match goal with |- ?A /\ ?B /\ ?C /\ ?D /\ ?E => assert (F : B /\ C /\ D) by (clear N' L'; (pose proof (on_planes (fun e => h'1 + e * d'1 + e ^ 2 / 2 * dd'1) (fun e => h'2 + e * d'2 + e ^ 2 / 2 * dd'2) (fun e => h'3 + e * d'3 + e ^ 2 / 2 * dd'3) (fun e => h'4 + e * d'4 + e ^ 2 / 2 * dd'4) x1 0) as V; pose proof (tangent_plane (fun e => h'1 + e * d'1 + e ^ 2 / 2 * dd'1) (fun e => h'2 + e * d'2 + e ^ 2 / 2 * dd'2) (fun e => h'3 + e * d'3 + e ^ 2 / 2 * dd'3) (fun e => h'4 + e * d'4 + e ^ 2 / 2 * dd'4) (smooth_quadratic h'1 d'1 dd'1) (smooth_quadratic h'2 d'2 dd'2) (smooth_quadratic h'3 d'3 dd'3) (smooth_quadratic h'4 d'4 dd'4) x1 0) as W; revert V W N L; lists; start_values; intros V W N L; split; [exact (proj1 (V N))|split; [ring|exact (proj1 (W L))]])); assert (F' : E) by (clear F N L; split; [reflexivity|]; (pose proof (on_planes (fun e => e'1 + e * f'1 + e ^ 2 / 2 * ff'1) (fun e => e'2 + e * f'2 + e ^ 2 / 2 * ff'2) (fun e => e'3 + e * f'3 + e ^ 2 / 2 * ff'3) (fun e => e'4 + e * f'4 + e ^ 2 / 2 * ff'4) x1 0) as V; pose proof (tangent_plane (fun e => e'1 + e * f'1 + e ^ 2 / 2 * ff'1) (fun e => e'2 + e * f'2 + e ^ 2 / 2 * ff'2) (fun e => e'3 + e * f'3 + e ^ 2 / 2 * ff'3) (fun e => e'4 + e * f'4 + e ^ 2 / 2 * ff'4) (smooth_quadratic e'1 f'1 ff'1) (smooth_quadratic e'2 f'2 ff'2) (smooth_quadratic e'3 f'3 ff'3) (smooth_quadratic e'4 f'4 ff'4) x1 0) as W; revert V W N' L'; lists; start_values; intros V W N L; split; [exact (proj1 (V N))|split; [ring|exact (proj1 (W L))]])) end; destruct F as (F1 & F2 & F3); split; [reflexivity|split; [exact F1|split; [exact F2|split; [exact F3|exact F']]]]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance P P_ O_ O__ normal direction moment foot J0 J0_ J1 J1_ HT g]; exists 2%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0; repeat match goal with |- _ /\ _ => split end; lazymatch goal with |- locally _ _ => apply filter_forall; intro e; lists; rewrite ?quadratic_rate; match goal with |- ?d <> 0 => replace d with 1 by field; lra end | |- _ => first [lia|lra|lists; at_ends; reflexivity|lists; start_values; lra] end. Qed.
End sec_3_4_tangent_ends.

Module eq_3_13.
Import GbtDevelopable.Section_3_4.eq_3_13.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal W]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal W]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_13.

Module sec_3_4_J0.
Import GbtDevelopable.Section_3_4.sec_3_4_J0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J0.

Module sec_3_4_dual.
Import GbtDevelopable.Section_3_4.sec_3_4_dual.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_dual.

Module sec_3_4_J1.
Import GbtDevelopable.Section_3_4.sec_3_4_J1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J1.

Module sec_3_4_k1.
Import GbtDevelopable.Section_3_4.sec_3_4_k1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k1]; first [(exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, (0); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met)]. Qed.
End sec_3_4_k1.

Module sec_3_4_k2.
Import GbtDevelopable.Section_3_4.sec_3_4_k2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2]; first [(exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, (0); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met)]. Qed.
End sec_3_4_k2.

Module sec_3_4_m0_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r1.

Module sec_3_4_m0_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r2.

Module sec_3_4_m0_r3_c1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c1.

Module sec_3_4_m0_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no; end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no. Qed.
End sec_3_4_m0_r3_c2.

Module sec_3_4_m0_r3_c2_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c2_corrected.

Module sec_3_4_m0_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k1 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r3_true.

Module sec_3_4_m0_r3_c3.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no; end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no. Qed.
End sec_3_4_m0_r3_c3.

Module sec_3_4_m0_r3_c3_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c3_corrected.

Module sec_3_4_m1_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r1.

Module sec_3_4_m1_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r2.

Module sec_3_4_m1_r3_c1.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c1.

Module sec_3_4_m1_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k2] in no; specialize (no 2%Z (fun _ => 0) 0 1); revert no; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 1; intro no; refuting no. Qed.
End sec_3_4_m1_r3_c2.

Module sec_3_4_m1_r3_c2_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c2_corrected.

Module sec_3_4_m1_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r3_true.

Module sec_3_4_m1_r3_c3.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c3.

Module sec_3_4_S0.
Import GbtDevelopable.Section_3_4.sec_3_4_S0.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _; assert (A : HT T k mu nu 0%Z = (T 0%Z)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 0) = vscale (IZR k - 2 + PI / 2 * (1 + mu)) (vsub (T 1%Z) (T 0%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 0) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) (T 0%Z)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2) (T 1%Z))) (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (T 2%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C; revert D2; generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (IZR k - 2 + PI / 2 * (1 + mu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2); revert D; subst T; cbv beta delta [normal]; cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g HT HT_ meet]; exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit]; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_S0.

Module sec_3_4_S0_gen.
Import GbtDevelopable.Section_3_4.sec_3_4_S0_gen.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal kappa HT_ meet S0]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal kappa HT_ meet S0]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_S0_gen.

Module sec_3_4_S1.
Import GbtDevelopable.Section_3_4.sec_3_4_S1.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _; assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 1) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2) (T k)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2) (T (k - 1)%Z))) (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (T (k - 2)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C; revert D2; generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (IZR k - 2 + PI / 2 * (1 + nu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2); revert D; subst T; cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3 (k - 1)%Z) (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z); cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g HT HT_ meet]; exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit]; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_S1.

Module sec_3_4_S1_gen.
Import GbtDevelopable.Section_3_4.sec_3_4_S1_gen.
Theorem proved : statement.
Proof. cbv beta delta [statement kappa S1]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _; assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B; clear A B; revert D2; generalize (IZR k - 2 + PI / 2 * (1 + nu)); revert D; subst T; cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3 (k - 1)%Z) (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z); cbv beta zeta delta [meet normal]; lists; intros; split; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal kappa HT_ meet S1]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_S1_gen.
