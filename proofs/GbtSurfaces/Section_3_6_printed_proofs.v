(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_6_printed Section_3_6_proofs.
Open Scope R_scope.

Module eq_32_matrix.
Import GbtSurfaces.Section_3_6_printed.eq_32_matrix.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted. Qed.
End eq_32_matrix.

Module eq_32_matrix_corrected.
Import GbtSurfaces.Section_3_6_printed.eq_32_matrix_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met. Qed.
End eq_32_matrix_corrected.

Module eq_32_components.
Import GbtSurfaces.Section_3_6_printed.eq_32_components.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_32_components.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_32_components.met. Qed.
End eq_32_components.

Module sec_3_6_rounding_rational.
Import GbtSurfaces.Section_3_6_printed.sec_3_6_rounding_rational.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met. Qed.
End sec_3_6_rounding_rational.

Module sec_3_6_c1c2.
Import GbtSurfaces.Section_3_6_printed.sec_3_6_c1c2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.met. Qed.
End sec_3_6_c1c2.

Module eq_33_T.
Import GbtSurfaces.Section_3_6_printed.eq_33_T.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_T.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_T.met. Qed.
End eq_33_T.

Module eq_33_Ttilde.
Import GbtSurfaces.Section_3_6_printed.eq_33_Ttilde.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.met. Qed.
End eq_33_Ttilde.

Module eq_33_circle.
Import GbtSurfaces.Section_3_6_printed.eq_33_circle.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_circle.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_33_circle.met. Qed.
End eq_33_circle.

Module thm_6_symmetric.
Import GbtSurfaces.Section_3_6_printed.thm_6_symmetric.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met. Qed.
End thm_6_symmetric.

Module thm_6_complete.
Import GbtSurfaces.Section_3_6_printed.thm_6_complete.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.thm_6_complete.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.thm_6_complete.met. Qed.
End thm_6_complete.

Module eq_34.
Import GbtSurfaces.Section_3_6_printed.eq_34.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_34.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_34.met. Qed.
End eq_34.

Module sec_3_6_other_axes.
Import GbtSurfaces.Section_3_6_printed.sec_3_6_other_axes.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met. Qed.
End sec_3_6_other_axes.

Module prop_3_8_a_linear.
Import GbtSurfaces.Section_3_6_printed.prop_3_8_a_linear.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.met. Qed.
End prop_3_8_a_linear.

Module prop_3_8_a_true.
Import GbtSurfaces.Section_3_6_printed.prop_3_8_a_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.met. Qed.
End prop_3_8_a_true.

Module prop_3_8_b.
Import GbtSurfaces.Section_3_6_printed.prop_3_8_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_b.refuted. Qed.
End prop_3_8_b.

Module prop_3_8_b_true.
Import GbtSurfaces.Section_3_6_printed.prop_3_8_b_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.met. Qed.
End prop_3_8_b_true.

Module prop_3_8_b_exact.
Import GbtSurfaces.Section_3_6_printed.prop_3_8_b_exact.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met. Qed.
End prop_3_8_b_exact.

Module prop_3_9_a_composite_line.
Import GbtSurfaces.Section_3_6_printed.prop_3_9_a_composite_line.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.met. Qed.
End prop_3_9_a_composite_line.

Module prop_3_9_a_one_segment.
Import GbtSurfaces.Section_3_6_printed.prop_3_9_a_one_segment.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted. Qed.
End prop_3_9_a_one_segment.

Module prop_3_9_b.
Import GbtSurfaces.Section_3_6_printed.prop_3_9_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_9_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.prop_3_9_b.met. Qed.
End prop_3_9_b.

Module alg_6.
Import GbtSurfaces.Section_3_6_printed.alg_6.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.alg_6.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.alg_6.met. Qed.
End alg_6.

Module eq_35.
Import GbtSurfaces.Section_3_6_printed.eq_35.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_35.proved. Qed.
End eq_35.

Module ex_3_6_curve.
Import GbtSurfaces.Section_3_6_printed.ex_3_6_curve.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.met. Qed.
End ex_3_6_curve.

Module eq_36.
Import GbtSurfaces.Section_3_6_printed.eq_36.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_36.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_6_proofs.eq_36.met. Qed.
End eq_36.
