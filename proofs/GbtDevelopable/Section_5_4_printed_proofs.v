(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_4_printed Section_5_4_proofs.
Open Scope R_scope.

Module alg_5_4_s1.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.met. Qed.
End alg_5_4_s1.

Module alg_5_4_s2_families.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s2_families.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.met. Qed.
End alg_5_4_s2_families.

Module alg_5_4_s2_surfaces.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s2_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_surfaces.refuted. Qed.
End alg_5_4_s2_surfaces.

Module alg_5_4_s3.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.met. Qed.
End alg_5_4_s3.

Module alg_5_4_s4.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s4.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.met. Qed.
End alg_5_4_s4.

Module alg_5_4_s5.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_s5.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.met. Qed.
End alg_5_4_s5.

Module alg_5_4_iterate.
Import GbtDevelopable.Section_5_4_printed.alg_5_4_iterate.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.met. Qed.
End alg_5_4_iterate.
