(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_3_printed Section_5_3_proofs.
Open Scope R_scope.

Module thm_4_consts.
Import GbtDevelopable.Section_5_3_printed.thm_4_consts.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_consts.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_consts.met. Qed.
End thm_4_consts.

Module thm_4_a.
Import GbtDevelopable.Section_5_3_printed.thm_4_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_a.met. Qed.
End thm_4_a.

Module thm_4_b.
Import GbtDevelopable.Section_5_3_printed.thm_4_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_b.met. Qed.
End thm_4_b.

Module thm_4_c.
Import GbtDevelopable.Section_5_3_printed.thm_4_c.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_c.refuted. Qed.
End thm_4_c.

Module thm_4_c_corrected.
Import GbtDevelopable.Section_5_3_printed.thm_4_c_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.met. Qed.
End thm_4_c_corrected.

Module thm_4_c_true.
Import GbtDevelopable.Section_5_3_printed.thm_4_c_true.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_c_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_c_true.met. Qed.
End thm_4_c_true.

Module eq_5_17.
Import GbtDevelopable.Section_5_3_printed.eq_5_17.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.eq_5_17.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.eq_5_17.met. Qed.
End eq_5_17.

Module thm_4_sufficient.
Import GbtDevelopable.Section_5_3_printed.thm_4_sufficient.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.met. Qed.
End thm_4_sufficient.

Module thm_4_necessary_families.
Import GbtDevelopable.Section_5_3_printed.thm_4_necessary_families.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.met. Qed.
End thm_4_necessary_families.

Module thm_4_necessary_surfaces.
Import GbtDevelopable.Section_5_3_printed.thm_4_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_necessary_surfaces.refuted. Qed.
End thm_4_necessary_surfaces.

Module thm_4_true_necessary.
Import GbtDevelopable.Section_5_3_printed.thm_4_true_necessary.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.met. Qed.
End thm_4_true_necessary.

Module thm_4_true_sufficient.
Import GbtDevelopable.Section_5_3_printed.thm_4_true_sufficient.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.met. Qed.
End thm_4_true_sufficient.

Module thm_4_true_sheets.
Import GbtDevelopable.Section_5_3_printed.thm_4_true_sheets.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.met. Qed.
End thm_4_true_sheets.

Module thm_4_true_curvature.
Import GbtDevelopable.Section_5_3_printed.thm_4_true_curvature.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.met. Qed.
End thm_4_true_curvature.
