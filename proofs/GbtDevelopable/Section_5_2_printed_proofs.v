(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_2_printed Section_5_2_proofs.
Open Scope R_scope.

Module eq_5_11.
Import GbtDevelopable.Section_5_2_printed.eq_5_11.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_11.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_11.met. Qed.
End eq_5_11.

Module sec_5_2_meaning.
Import GbtDevelopable.Section_5_2_printed.sec_5_2_meaning.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.met. Qed.
End sec_5_2_meaning.

Module sec_5_2_ref.
Import GbtDevelopable.Section_5_2_printed.sec_5_2_ref.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_ref.refuted. Qed.
End sec_5_2_ref.

Module sec_5_2_ref_true.
Import GbtDevelopable.Section_5_2_printed.sec_5_2_ref_true.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.met. Qed.
End sec_5_2_ref_true.

Module sec_5_2_index.
Import GbtDevelopable.Section_5_2_printed.sec_5_2_index.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.sec_5_2_index.refuted. Qed.
End sec_5_2_index.

Module thm_3_consts.
Import GbtDevelopable.Section_5_2_printed.thm_3_consts.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_consts.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_consts.met. Qed.
End thm_3_consts.

Module thm_3_a.
Import GbtDevelopable.Section_5_2_printed.thm_3_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_a.met. Qed.
End thm_3_a.

Module thm_3_b.
Import GbtDevelopable.Section_5_2_printed.thm_3_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_b.met. Qed.
End thm_3_b.

Module thm_3_c.
Import GbtDevelopable.Section_5_2_printed.thm_3_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_c.met. Qed.
End thm_3_c.

Module thm_3_sufficient.
Import GbtDevelopable.Section_5_2_printed.thm_3_sufficient.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.met. Qed.
End thm_3_sufficient.

Module thm_3_necessary_families.
Import GbtDevelopable.Section_5_2_printed.thm_3_necessary_families.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.met. Qed.
End thm_3_necessary_families.

Module thm_3_necessary_surfaces.
Import GbtDevelopable.Section_5_2_printed.thm_3_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_necessary_surfaces.refuted. Qed.
End thm_3_necessary_surfaces.

Module eq_5_13.
Import GbtDevelopable.Section_5_2_printed.eq_5_13.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_13.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_13.met. Qed.
End eq_5_13.

Module eq_5_15.
Import GbtDevelopable.Section_5_2_printed.eq_5_15.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_15.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.eq_5_15.met. Qed.
End eq_5_15.

Module thm_3_proofref.
Import GbtDevelopable.Section_5_2_printed.thm_3_proofref.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_proofref.refuted. Qed.
End thm_3_proofref.

Module thm_3_proofref_true.
Import GbtDevelopable.Section_5_2_printed.thm_3_proofref_true.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.met. Qed.
End thm_3_proofref_true.
