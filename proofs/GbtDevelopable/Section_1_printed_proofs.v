(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_1_printed Section_1_proofs.
Open Scope R_scope.

Module intro_continuity_free_a.
Import GbtDevelopable.Section_1_printed.intro_continuity_free_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_1_proofs.intro_continuity_free_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_1_proofs.intro_continuity_free_a.met. Qed.
End intro_continuity_free_a.

Module intro_continuity_free_b_any_values.
Import GbtDevelopable.Section_1_printed.intro_continuity_free_b_any_values.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted. Qed.
End intro_continuity_free_b_any_values.

Module intro_continuity_free_c_any_values.
Import GbtDevelopable.Section_1_printed.intro_continuity_free_c_any_values.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_1_proofs.intro_continuity_free_c_any_values.refuted. Qed.
End intro_continuity_free_c_any_values.

Module intro_contrib_4.
Import GbtDevelopable.Section_1_printed.intro_contrib_4.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_1_proofs.intro_contrib_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_1_proofs.intro_contrib_4.met. Qed.
End intro_contrib_4.

Module intro_gauss.
Import GbtDevelopable.Section_1_printed.intro_gauss.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_1_proofs.intro_gauss.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_1_proofs.intro_gauss.met. Qed.
End intro_gauss.
