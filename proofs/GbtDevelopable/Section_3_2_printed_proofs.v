(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_3_2_printed Section_3_2_proofs.
Open Scope R_scope.

Module eq_3_5.
Import GbtDevelopable.Section_3_2_printed.eq_3_5.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_5.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_5.met. Qed.
End eq_3_5.

Module eq_3_6.
Import GbtDevelopable.Section_3_2_printed.eq_3_6.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_6.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_6.met. Qed.
End eq_3_6.

Module sec_3_2_phi.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_phi.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_phi.proved. Qed.
End sec_3_2_phi.

Module sec_3_2_theta.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_theta.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.met. Qed.
End sec_3_2_theta.

Module sec_3_2_phi_exp.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_phi_exp.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_phi_exp.proved. Qed.
End sec_3_2_phi_exp.

Module sec_3_2_psi_vec.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_vec.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.met. Qed.
End sec_3_2_psi_vec.

Module sec_3_2_psi_nearest.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_nearest.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.met. Qed.
End sec_3_2_psi_nearest.

Module sec_3_2_psi_x.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_x.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_x.proved. Qed.
End sec_3_2_psi_x.

Module sec_3_2_psi_y.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_y.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_y.proved. Qed.
End sec_3_2_psi_y.

Module sec_3_2_psi_z.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_z.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z.refuted. Qed.
End sec_3_2_psi_z.

Module sec_3_2_psi_z_corrected.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_z_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z_corrected.proved. Qed.
End sec_3_2_psi_z_corrected.

Module sec_3_2_psi_den.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_psi_den.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_den.proved. Qed.
End sec_3_2_psi_den.

Module eq_3_7.
Import GbtDevelopable.Section_3_2_printed.eq_3_7.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_7.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.eq_3_7.met. Qed.
End eq_3_7.

Module sec_3_2_envelope.
Import GbtDevelopable.Section_3_2_printed.sec_3_2_envelope.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.met. Qed.
End sec_3_2_envelope.
