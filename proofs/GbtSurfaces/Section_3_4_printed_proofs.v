(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_4_printed Section_3_4_proofs.
Open Scope R_scope.

Module eq_20_profile.
Import GbtSurfaces.Section_3_4_printed.eq_20_profile.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_20_profile.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_20_profile.met. Qed.
End eq_20_profile.

Module eq_20_trajectory.
Import GbtSurfaces.Section_3_4_printed.eq_20_trajectory.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted. Qed.
End eq_20_trajectory.

Module eq_20_trajectory_corrected.
Import GbtSurfaces.Section_3_4_printed.eq_20_trajectory_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met. Qed.
End eq_20_trajectory_corrected.

Module eq_21.
Import GbtSurfaces.Section_3_4_printed.eq_21.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_21.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_21.met. Qed.
End eq_21.

Module eq_22.
Import GbtSurfaces.Section_3_4_printed.eq_22.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_22.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_22.met. Qed.
End eq_22.

Module prop_3_5.
Import GbtSurfaces.Section_3_4_printed.prop_3_5.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_5.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_5.met. Qed.
End prop_3_5.

Module prop_3_6_1.
Import GbtSurfaces.Section_3_4_printed.prop_3_6_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met. Qed.
End prop_3_6_1.

Module prop_3_6_2.
Import GbtSurfaces.Section_3_4_printed.prop_3_6_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met. Qed.
End prop_3_6_2.

Module eq_23.
Import GbtSurfaces.Section_3_4_printed.eq_23.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_23.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_23.met. Qed.
End eq_23.

Module thm_4_elements.
Import GbtSurfaces.Section_3_4_printed.thm_4_elements.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted. Qed.
End thm_4_elements.

Module thm_4_elements_corrected.
Import GbtSurfaces.Section_3_4_printed.thm_4_elements_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met. Qed.
End thm_4_elements_corrected.

Module thm_4_parameters.
Import GbtSurfaces.Section_3_4_printed.thm_4_parameters.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_parameters.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_parameters.met. Qed.
End thm_4_parameters.

Module eq_24.
Import GbtSurfaces.Section_3_4_printed.eq_24.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_24.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_24.met. Qed.
End eq_24.

Module thm_4_unity.
Import GbtSurfaces.Section_3_4_printed.thm_4_unity.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.thm_4_unity.met. Qed.
End thm_4_unity.

Module eq_25_1.
Import GbtSurfaces.Section_3_4_printed.eq_25_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_1.met. Qed.
End eq_25_1.

Module eq_25_2_a.
Import GbtSurfaces.Section_3_4_printed.eq_25_2_a.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted. Qed.
End eq_25_2_a.

Module eq_25_2_a_corrected.
Import GbtSurfaces.Section_3_4_printed.eq_25_2_a_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.met. Qed.
End eq_25_2_a_corrected.

Module eq_25_2_b.
Import GbtSurfaces.Section_3_4_printed.eq_25_2_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted. Qed.
End eq_25_2_b.

Module eq_25_2_b_corrected.
Import GbtSurfaces.Section_3_4_printed.eq_25_2_b_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.met. Qed.
End eq_25_2_b_corrected.

Module eq_25_2_c.
Import GbtSurfaces.Section_3_4_printed.eq_25_2_c.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_2_c.met. Qed.
End eq_25_2_c.

Module eq_25_3.
Import GbtSurfaces.Section_3_4_printed.eq_25_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_3.met. Qed.
End eq_25_3.

Module eq_25_4_a.
Import GbtSurfaces.Section_3_4_printed.eq_25_4_a.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted. Qed.
End eq_25_4_a.

Module eq_25_4_a_corrected.
Import GbtSurfaces.Section_3_4_printed.eq_25_4_a_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.met. Qed.
End eq_25_4_a_corrected.

Module eq_25_4_b.
Import GbtSurfaces.Section_3_4_printed.eq_25_4_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted. Qed.
End eq_25_4_b.

Module eq_25_4_b_corrected.
Import GbtSurfaces.Section_3_4_printed.eq_25_4_b_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met. Qed.
End eq_25_4_b_corrected.

Module eq_25_4_c.
Import GbtSurfaces.Section_3_4_printed.eq_25_4_c.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_25_4_c.met. Qed.
End eq_25_4_c.

Module sec_3_4_features_a.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_features_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.met. Qed.
End sec_3_4_features_a.

Module sec_3_4_continuity_pc.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_pc.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.met. Qed.
End sec_3_4_continuity_pc.

Module sec_3_4_continuity_tc.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_tc.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.met. Qed.
End sec_3_4_continuity_tc.

Module sec_3_4_closed.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_closed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.met. Qed.
End sec_3_4_closed.

Module sec_3_4_revolution.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_revolution.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met. Qed.
End sec_3_4_revolution.

Module sec_3_4_revolution_not_tensor_quarter.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_quarter.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met. Qed.
End sec_3_4_revolution_not_tensor_quarter.

Module sec_3_4_revolution_not_tensor_cubic.
Import GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_cubic.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met. Qed.
End sec_3_4_revolution_not_tensor_cubic.

Module alg_4_a.
Import GbtSurfaces.Section_3_4_printed.alg_4_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.alg_4_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.alg_4_a.met. Qed.
End alg_4_a.

Module alg_4_b.
Import GbtSurfaces.Section_3_4_printed.alg_4_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.alg_4_b.refuted. Qed.
End alg_4_b.

Module eq_26.
Import GbtSurfaces.Section_3_4_printed.eq_26.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.eq_26.proved. Qed.
End eq_26.

Module ex_3_4_scaling.
Import GbtSurfaces.Section_3_4_printed.ex_3_4_scaling.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met. Qed.
End ex_3_4_scaling.

Module fig_16_lambda_between_the_panels.
Import GbtSurfaces.Section_3_4_printed.fig_16_lambda_between_the_panels.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.met. Qed.
End fig_16_lambda_between_the_panels.

Module fig_16_lambda_between_the_surfaces.
Import GbtSurfaces.Section_3_4_printed.fig_16_lambda_between_the_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted. Qed.
End fig_16_lambda_between_the_surfaces.
