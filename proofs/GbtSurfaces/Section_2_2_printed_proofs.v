(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_2_2_printed Section_2_2_proofs.
Open Scope R_scope.

Module def_2_points_one_letter.
Import GbtSurfaces.Section_2_2_printed.def_2_points_one_letter.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.def_2_points_one_letter.refuted. Qed.
End def_2_points_one_letter.

Module def_2_points_two_letters.
Import GbtSurfaces.Section_2_2_printed.def_2_points_two_letters.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.met. Qed.
End def_2_points_two_letters.

Module eq_3.
Import GbtSurfaces.Section_2_2_printed.eq_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_3.met. Qed.
End eq_3.

Module sec_2_2_symmetry_as_in_Theorem_1.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_as_in_Theorem_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met. Qed.
End sec_2_2_symmetry_as_in_Theorem_1.

Module sec_2_2_symmetry_parameters_exchanged.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_parameters_exchanged.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met. Qed.
End sec_2_2_symmetry_parameters_exchanged.

Module sec_2_2_symmetry_as_for_B_zier_curves.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_as_for_B_zier_curves.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted. Qed.
End sec_2_2_symmetry_as_for_B_zier_curves.

Module sec_2_2_convex_hull.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_convex_hull.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.met. Qed.
End sec_2_2_convex_hull.

Module sec_2_2_variation_diminishing_order_2.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_variation_diminishing_order_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met. Qed.
End sec_2_2_variation_diminishing_order_2.

Module sec_2_2_invariance.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_invariance.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.met. Qed.
End sec_2_2_invariance.

Module sec_2_2_shape_adjustable.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_shape_adjustable.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.met. Qed.
End sec_2_2_shape_adjustable.

Module sec_2_2_terminal_0_values.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_0_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.met. Qed.
End sec_2_2_terminal_0_values.

Module sec_2_2_terminal_1_values.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_1_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.met. Qed.
End sec_2_2_terminal_1_values.

Module sec_2_2_interpolation.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_interpolation.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met. Qed.
End sec_2_2_interpolation.

Module sec_2_2_end_derivatives.
Import GbtSurfaces.Section_2_2_printed.sec_2_2_end_derivatives.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.met. Qed.
End sec_2_2_end_derivatives.

Module thm_2_setting.
Import GbtSurfaces.Section_2_2_printed.thm_2_setting.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_setting.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_setting.met. Qed.
End thm_2_setting.

Module thm_2_1.
Import GbtSurfaces.Section_2_2_printed.thm_2_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_1.met. Qed.
End thm_2_1.

Module eq_4_Q11.
Import GbtSurfaces.Section_2_2_printed.eq_4_Q11.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met. Qed.
End eq_4_Q11.

Module thm_2_2.
Import GbtSurfaces.Section_2_2_printed.thm_2_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_2.met. Qed.
End thm_2_2.

Module eq_5_Q12.
Import GbtSurfaces.Section_2_2_printed.eq_5_Q12.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted. Qed.
End eq_5_Q12.

Module eq_5_Q12_corrected.
Import GbtSurfaces.Section_2_2_printed.eq_5_Q12_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.met. Qed.
End eq_5_Q12_corrected.

Module eq_5_Q12_true.
Import GbtSurfaces.Section_2_2_printed.eq_5_Q12_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.met. Qed.
End eq_5_Q12_true.

Module thm_2_3_a.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_a.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_a.refuted. Qed.
End thm_2_3_a.

Module thm_2_3_b.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_b.refuted. Qed.
End thm_2_3_b.

Module thm_2_3_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_true.met. Qed.
End thm_2_3_true.

Module thm_2_3_iff.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_iff.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.met. Qed.
End thm_2_3_iff.

Module thm_2_3_necessary.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_necessary.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.met. Qed.
End thm_2_3_necessary.

Module thm_2_3_sufficient.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_sufficient.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.met. Qed.
End thm_2_3_sufficient.

Module thm_2_3_jump.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_jump.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.met. Qed.
End thm_2_3_jump.

Module thm_2_3_when.
Import GbtSurfaces.Section_2_2_printed.thm_2_3_when.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_when.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_3_when.met. Qed.
End thm_2_3_when.

Module eq_6_Q11.
Import GbtSurfaces.Section_2_2_printed.eq_6_Q11.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met. Qed.
End eq_6_Q11.

Module eq_6_Q12.
Import GbtSurfaces.Section_2_2_printed.eq_6_Q12.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q12.refuted. Qed.
End eq_6_Q12.

Module eq_6_Q12_corrected.
Import GbtSurfaces.Section_2_2_printed.eq_6_Q12_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.met. Qed.
End eq_6_Q12_corrected.

Module eq_6_Q13.
Import GbtSurfaces.Section_2_2_printed.eq_6_Q13.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q13.refuted. Qed.
End eq_6_Q13.

Module eq_6_Q13_true.
Import GbtSurfaces.Section_2_2_printed.eq_6_Q13_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.met. Qed.
End eq_6_Q13_true.

Module thm_2_4_a.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_a.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_a.refuted. Qed.
End thm_2_4_a.

Module thm_2_4_c.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_c.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_c.refuted. Qed.
End thm_2_4_c.

Module thm_2_4_b.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_b.refuted. Qed.
End thm_2_4_b.

Module thm_2_4_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_true.met. Qed.
End thm_2_4_true.

Module thm_2_4_iff.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_iff.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.met. Qed.
End thm_2_4_iff.

Module thm_2_4_necessary.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_necessary.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.met. Qed.
End thm_2_4_necessary.

Module thm_2_4_sufficient.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.met. Qed.
End thm_2_4_sufficient.

Module thm_2_4_sufficient_quintic.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient_quintic.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.met. Qed.
End thm_2_4_sufficient_quintic.

Module thm_2_4_cubic.
Import GbtSurfaces.Section_2_2_printed.thm_2_4_cubic.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.met. Qed.
End thm_2_4_cubic.

Module thm_2_a.
Import GbtSurfaces.Section_2_2_printed.thm_2_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a.met. Qed.
End thm_2_a.

Module thm_2_a1.
Import GbtSurfaces.Section_2_2_printed.thm_2_a1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a1.met. Qed.
End thm_2_a1.

Module thm_2_a1_sign.
Import GbtSurfaces.Section_2_2_printed.thm_2_a1_sign.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.met. Qed.
End thm_2_a1_sign.

Module thm_2_a2.
Import GbtSurfaces.Section_2_2_printed.thm_2_a2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a2.met. Qed.
End thm_2_a2.

Module thm_2_a3.
Import GbtSurfaces.Section_2_2_printed.thm_2_a3.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a3.refuted. Qed.
End thm_2_a3.

Module thm_2_a3_corrected.
Import GbtSurfaces.Section_2_2_printed.thm_2_a3_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.met. Qed.
End thm_2_a3_corrected.

Module thm_2_a3_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_a3_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.met. Qed.
End thm_2_a3_true.

Module thm_2_b1.
Import GbtSurfaces.Section_2_2_printed.thm_2_b1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b1.met. Qed.
End thm_2_b1.

Module thm_2_b1_sign.
Import GbtSurfaces.Section_2_2_printed.thm_2_b1_sign.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.met. Qed.
End thm_2_b1_sign.

Module thm_2_b2.
Import GbtSurfaces.Section_2_2_printed.thm_2_b2.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b2.refuted. Qed.
End thm_2_b2.

Module thm_2_b2_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_b2_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.met. Qed.
End thm_2_b2_true.

Module thm_2_b3.
Import GbtSurfaces.Section_2_2_printed.thm_2_b3.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b3.refuted. Qed.
End thm_2_b3.

Module thm_2_b3_corrected.
Import GbtSurfaces.Section_2_2_printed.thm_2_b3_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.met. Qed.
End thm_2_b3_corrected.

Module thm_2_b3_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_b3_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.met. Qed.
End thm_2_b3_true.

Module thm_2_b4.
Import GbtSurfaces.Section_2_2_printed.thm_2_b4.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b4.refuted. Qed.
End thm_2_b4.

Module thm_2_b4_corrected.
Import GbtSurfaces.Section_2_2_printed.thm_2_b4_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.met. Qed.
End thm_2_b4_corrected.

Module thm_2_b4_true.
Import GbtSurfaces.Section_2_2_printed.thm_2_b4_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.met. Qed.
End thm_2_b4_true.

Module thm_2_c1.
Import GbtSurfaces.Section_2_2_printed.thm_2_c1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_2_proofs.thm_2_c1.met. Qed.
End thm_2_c1.
