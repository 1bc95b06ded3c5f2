(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_2_1_printed Section_2_1_proofs.
Open Scope R_scope.

Module def_1_g0.
Import GbtDevelopable.Section_2_1_printed.def_1_g0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g0.met. Qed.
End def_1_g0.

Module def_1_g1.
Import GbtDevelopable.Section_2_1_printed.def_1_g1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g1.met. Qed.
End def_1_g1.

Module def_1_g2.
Import GbtDevelopable.Section_2_1_printed.def_1_g2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_g2.met. Qed.
End def_1_g2.

Module def_1_range.
Import GbtDevelopable.Section_2_1_printed.def_1_range.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_range.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_range.met. Qed.
End def_1_range.

Module eq_2_1.
Import GbtDevelopable.Section_2_1_printed.eq_2_1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.eq_2_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.eq_2_1.met. Qed.
End eq_2_1.

Module def_1_zero.
Import GbtDevelopable.Section_2_1_printed.def_1_zero.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_zero.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.def_1_zero.met. Qed.
End def_1_zero.

Module thm_1_1_k2_functions.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_k2_functions.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_functions.refuted. Qed.
End thm_1_1_k2_functions.

Module thm_1_1_k2_substitution.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_k2_substitution.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.met. Qed.
End thm_1_1_k2_substitution.

Module thm_1_1_k3plus_functions.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_functions.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_functions.refuted. Qed.
End thm_1_1_k3plus_functions.

Module thm_1_1_k3plus_substitution.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_substitution.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted. Qed.
End thm_1_1_k3plus_substitution.

Module thm_1_1_k3plus_letters.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_letters.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.met. Qed.
End thm_1_1_k3plus_letters.

Module thm_1_1_degeneration.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.met. Qed.
End thm_1_1_degeneration.

Module thm_1_1_degeneration_only.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration_only.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.met. Qed.
End thm_1_1_degeneration_only.

Module thm_1_1_no_degeneration.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_no_degeneration.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.met. Qed.
End thm_1_1_no_degeneration.

Module thm_1_1_jets.
Import GbtDevelopable.Section_2_1_printed.thm_1_1_jets.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.met. Qed.
End thm_1_1_jets.

Module thm_1_2.
Import GbtDevelopable.Section_2_1_printed.thm_1_2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_2.met. Qed.
End thm_1_2.

Module thm_1_3.
Import GbtDevelopable.Section_2_1_printed.thm_1_3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_3.met. Qed.
End thm_1_3.

Module thm_1_4.
Import GbtDevelopable.Section_2_1_printed.thm_1_4.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_4.met. Qed.
End thm_1_4.

Module thm_1_5.
Import GbtDevelopable.Section_2_1_printed.thm_1_5.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5.refuted. Qed.
End thm_1_5.

Module thm_1_5_quadratic.
Import GbtDevelopable.Section_2_1_printed.thm_1_5_quadratic.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.met. Qed.
End thm_1_5_quadratic.

Module thm_1_5_cubic.
Import GbtDevelopable.Section_2_1_printed.thm_1_5_cubic.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.met. Qed.
End thm_1_5_cubic.

Module thm_1_5_all.
Import GbtDevelopable.Section_2_1_printed.thm_1_5_all.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_all.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_5_all.met. Qed.
End thm_1_5_all.

Module thm_1_6_a.
Import GbtDevelopable.Section_2_1_printed.thm_1_6_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_a.met. Qed.
End thm_1_6_a.

Module thm_1_6_b.
Import GbtDevelopable.Section_2_1_printed.thm_1_6_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_b.met. Qed.
End thm_1_6_b.

Module thm_1_6_c.
Import GbtDevelopable.Section_2_1_printed.thm_1_6_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_c.met. Qed.
End thm_1_6_c.

Module thm_1_6_d.
Import GbtDevelopable.Section_2_1_printed.thm_1_6_d.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_d.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_1_proofs.thm_1_6_d.met. Qed.
End thm_1_6_d.
