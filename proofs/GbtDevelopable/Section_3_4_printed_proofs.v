(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_3_4_printed Section_3_4_proofs.
Open Scope R_scope.

Module eq_3_11_a.
Import GbtDevelopable.Section_3_4_printed.eq_3_11_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_a.met. Qed.
End eq_3_11_a.

Module eq_3_11_b.
Import GbtDevelopable.Section_3_4_printed.eq_3_11_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_b.met. Qed.
End eq_3_11_b.

Module eq_3_11_c.
Import GbtDevelopable.Section_3_4_printed.eq_3_11_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_11_c.met. Qed.
End eq_3_11_c.

Module eq_3_12_a.
Import GbtDevelopable.Section_3_4_printed.eq_3_12_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_a.met. Qed.
End eq_3_12_a.

Module eq_3_12_b.
Import GbtDevelopable.Section_3_4_printed.eq_3_12_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_b.met. Qed.
End eq_3_12_b.

Module eq_3_12_c.
Import GbtDevelopable.Section_3_4_printed.eq_3_12_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_12_c.met. Qed.
End eq_3_12_c.

Module sec_3_4_tangent_ends.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_tangent_ends.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.met. Qed.
End sec_3_4_tangent_ends.

Module eq_3_13.
Import GbtDevelopable.Section_3_4_printed.eq_3_13.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_13.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.eq_3_13.met. Qed.
End eq_3_13.

Module sec_3_4_J0.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_J0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.met. Qed.
End sec_3_4_J0.

Module sec_3_4_dual.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_dual.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.met. Qed.
End sec_3_4_dual.

Module sec_3_4_J1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_J1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.met. Qed.
End sec_3_4_J1.

Module sec_3_4_m0_r1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.met. Qed.
End sec_3_4_m0_r1.

Module sec_3_4_m0_r2.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.met. Qed.
End sec_3_4_m0_r2.

Module sec_3_4_m0_r3_c1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.met. Qed.
End sec_3_4_m0_r3_c1.

Module sec_3_4_m0_r3_c2.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c2.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2.refuted. Qed.
End sec_3_4_m0_r3_c2.

Module sec_3_4_m0_r3_c2_corrected.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c2_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.met. Qed.
End sec_3_4_m0_r3_c2_corrected.

Module sec_3_4_m0_r3_true.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_true.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.met. Qed.
End sec_3_4_m0_r3_true.

Module sec_3_4_m0_r3_c3.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c3.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3.refuted. Qed.
End sec_3_4_m0_r3_c3.

Module sec_3_4_m0_r3_c3_corrected.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c3_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.met. Qed.
End sec_3_4_m0_r3_c3_corrected.

Module sec_3_4_m1_r1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.met. Qed.
End sec_3_4_m1_r1.

Module sec_3_4_m1_r2.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.met. Qed.
End sec_3_4_m1_r2.

Module sec_3_4_m1_r3_c1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.met. Qed.
End sec_3_4_m1_r3_c1.

Module sec_3_4_m1_r3_c2.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c2.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2.refuted. Qed.
End sec_3_4_m1_r3_c2.

Module sec_3_4_m1_r3_c2_corrected.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c2_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.met. Qed.
End sec_3_4_m1_r3_c2_corrected.

Module sec_3_4_m1_r3_true.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_true.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.met. Qed.
End sec_3_4_m1_r3_true.

Module sec_3_4_m1_r3_c3.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.met. Qed.
End sec_3_4_m1_r3_c3.

Module sec_3_4_S0.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_S0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.met. Qed.
End sec_3_4_S0.

Module sec_3_4_S0_gen.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_S0_gen.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.met. Qed.
End sec_3_4_S0_gen.

Module sec_3_4_S1.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_S1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.met. Qed.
End sec_3_4_S1.

Module sec_3_4_S1_gen.
Import GbtDevelopable.Section_3_4_printed.sec_3_4_S1_gen.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.met. Qed.
End sec_3_4_S1_gen.
