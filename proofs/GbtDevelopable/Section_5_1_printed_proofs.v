(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_1_printed Section_5_1_proofs.
Open Scope R_scope.

Module eq_5_3_b.
Import GbtDevelopable.Section_5_1_printed.eq_5_3_b.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_3_b.refuted. Qed.
End eq_5_3_b.

Module eq_5_3_b_corrected.
Import GbtDevelopable.Section_5_1_printed.eq_5_3_b_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.met. Qed.
End eq_5_3_b_corrected.

Module eq_5_4.
Import GbtDevelopable.Section_5_1_printed.eq_5_4.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_4.met. Qed.
End eq_5_4.

Module eq_5_4_nec_suf_curves_of_four_coordinates.
Import GbtDevelopable.Section_5_1_printed.eq_5_4_nec_suf_curves_of_four_coordinates.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met. Qed.
End eq_5_4_nec_suf_curves_of_four_coordinates.

Module eq_5_4_nec_suf_curves_in_space.
Import GbtDevelopable.Section_5_1_printed.eq_5_4_nec_suf_curves_in_space.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted. Qed.
End eq_5_4_nec_suf_curves_in_space.

Module sec_5_1_certify.
Import GbtDevelopable.Section_5_1_printed.sec_5_1_certify.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.met. Qed.
End sec_5_1_certify.

Module sec_5_1_certify_sheets.
Import GbtDevelopable.Section_5_1_printed.sec_5_1_certify_sheets.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.met. Qed.
End sec_5_1_certify_sheets.

Module sec_5_1_certify_cusp.
Import GbtDevelopable.Section_5_1_printed.sec_5_1_certify_cusp.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.met. Qed.
End sec_5_1_certify_cusp.

Module thm_2_inflection.
Import GbtDevelopable.Section_5_1_printed.thm_2_inflection.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_inflection.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_inflection.met. Qed.
End thm_2_inflection.

Module sec_5_1_G0_families.
Import GbtDevelopable.Section_5_1_printed.sec_5_1_G0_families.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.met. Qed.
End sec_5_1_G0_families.

Module sec_5_1_G0_surfaces.
Import GbtDevelopable.Section_5_1_printed.sec_5_1_G0_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_surfaces.refuted. Qed.
End sec_5_1_G0_surfaces.

Module thm_2_a.
Import GbtDevelopable.Section_5_1_printed.thm_2_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_a.met. Qed.
End thm_2_a.

Module thm_2_b.
Import GbtDevelopable.Section_5_1_printed.thm_2_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_b.met. Qed.
End thm_2_b.

Module eq_5_7_requirement.
Import GbtDevelopable.Section_5_1_printed.eq_5_7_requirement.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.met. Qed.
End eq_5_7_requirement.

Module eq_5_7_equivalence.
Import GbtDevelopable.Section_5_1_printed.eq_5_7_equivalence.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_7_equivalence.refuted. Qed.
End eq_5_7_equivalence.

Module eq_5_8_a.
Import GbtDevelopable.Section_5_1_printed.eq_5_8_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_8_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_8_a.met. Qed.
End eq_5_8_a.

Module eq_5_8_b.
Import GbtDevelopable.Section_5_1_printed.eq_5_8_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_8_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_8_b.met. Qed.
End eq_5_8_b.

Module eq_5_9.
Import GbtDevelopable.Section_5_1_printed.eq_5_9.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_9.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_9.met. Qed.
End eq_5_9.

Module eq_5_10.
Import GbtDevelopable.Section_5_1_printed.eq_5_10.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_10.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.eq_5_10.met. Qed.
End eq_5_10.

Module thm_2_sufficient.
Import GbtDevelopable.Section_5_1_printed.thm_2_sufficient.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.met. Qed.
End thm_2_sufficient.

Module thm_2_necessary_families.
Import GbtDevelopable.Section_5_1_printed.thm_2_necessary_families.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.met. Qed.
End thm_2_necessary_families.

Module thm_2_necessary_surfaces.
Import GbtDevelopable.Section_5_1_printed.thm_2_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_necessary_surfaces.refuted. Qed.
End thm_2_necessary_surfaces.

Module thm_2_true_necessary.
Import GbtDevelopable.Section_5_1_printed.thm_2_true_necessary.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.met. Qed.
End thm_2_true_necessary.

Module thm_2_true_sufficient.
Import GbtDevelopable.Section_5_1_printed.thm_2_true_sufficient.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.met. Qed.
End thm_2_true_sufficient.

Module thm_2_true_generator.
Import GbtDevelopable.Section_5_1_printed.thm_2_true_generator.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.met. Qed.
End thm_2_true_generator.

Module thm_2_true_sheets.
Import GbtDevelopable.Section_5_1_printed.thm_2_true_sheets.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.met. Qed.
End thm_2_true_sheets.
