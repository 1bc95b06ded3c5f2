(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_3_3_printed Section_3_3_proofs.
Open Scope R_scope.

Module eq_3_8.
Import GbtDevelopable.Section_3_3_printed.eq_3_8.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_8.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_8.met. Qed.
End eq_3_8.

Module eq_3_9.
Import GbtDevelopable.Section_3_3_printed.eq_3_9.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_9.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_9.met. Qed.
End eq_3_9.

Module sec_3_3_S_vec.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_vec.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec.refuted. Qed.
End sec_3_3_S_vec.

Module sec_3_3_S_vec_corrected.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_vec_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.met. Qed.
End sec_3_3_S_vec_corrected.

Module sec_3_3_S_x.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_x.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_x.proved. Qed.
End sec_3_3_S_x.

Module sec_3_3_S_y.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_y.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_y.proved. Qed.
End sec_3_3_S_y.

Module sec_3_3_S_z.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_z.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_z.proved. Qed.
End sec_3_3_S_z.

Module sec_3_3_S_den.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_S_den.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_S_den.proved. Qed.
End sec_3_3_S_den.

Module sec_3_3_regression.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_regression.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.met. Qed.
End sec_3_3_regression.

Module sec_3_3_regression_velocity.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_regression_velocity.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.met. Qed.
End sec_3_3_regression_velocity.

Module sec_3_3_regression_quadratic.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_regression_quadratic.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.met. Qed.
End sec_3_3_regression_quadratic.

Module eq_3_10.
Import GbtDevelopable.Section_3_3_printed.eq_3_10.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_10.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.eq_3_10.met. Qed.
End eq_3_10.

Module sec_3_3_developable.
Import GbtDevelopable.Section_3_3_printed.sec_3_3_developable.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.met. Qed.
End sec_3_3_developable.
