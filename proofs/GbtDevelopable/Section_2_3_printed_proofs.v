(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_2_3_printed Section_2_3_proofs.
Open Scope R_scope.

Module sec_2_3_local_part_of_a_curve.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_local_part_of_a_curve.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted. Qed.
End sec_2_3_local_part_of_a_curve.

Module sec_2_3_local_part_of_a_composite.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_local_part_of_a_composite.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met. Qed.
End sec_2_3_local_part_of_a_composite.

Module sec_2_3_linear.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_linear.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.met. Qed.
End sec_2_3_linear.

Module eq_2_3.
Import GbtDevelopable.Section_2_3_printed.eq_2_3.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_3.refuted. Qed.
End eq_2_3.

Module eq_2_3_corrected.
Import GbtDevelopable.Section_2_3_printed.eq_2_3_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.met. Qed.
End eq_2_3_corrected.

Module eq_2_4.
Import GbtDevelopable.Section_2_3_printed.eq_2_4.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_4.refuted. Qed.
End eq_2_4.

Module eq_2_4_corrected.
Import GbtDevelopable.Section_2_3_printed.eq_2_4_corrected.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.met. Qed.
End eq_2_4_corrected.

Module sec_2_3_indep_mu.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_indep_mu.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.met. Qed.
End sec_2_3_indep_mu.

Module sec_2_3_indep_nu.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_indep_nu.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.met. Qed.
End sec_2_3_indep_nu.

Module sec_2_3_move.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_move.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_move.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_move.met. Qed.
End sec_2_3_move.

Module sec_2_3_dir_mu.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.met. Qed.
End sec_2_3_dir_mu.

Module sec_2_3_dir_mu_single.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu_single.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.met. Qed.
End sec_2_3_dir_mu_single.

Module sec_2_3_dir_nu.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_dir_nu.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.met. Qed.
End sec_2_3_dir_nu.

Module sec_2_3_range.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_range.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_range.refuted. Qed.
End sec_2_3_range.

Module sec_2_3_concl_1.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_concl_1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.met. Qed.
End sec_2_3_concl_1.

Module sec_2_3_concl_2_boundary_of_the_hull.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_boundary_of_the_hull.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted. Qed.
End sec_2_3_concl_2_boundary_of_the_hull.

Module sec_2_3_concl_2_control_polygon.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_control_polygon.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted. Qed.
End sec_2_3_concl_2_control_polygon.

Module sec_2_3_concl_2_quadratic.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_quadratic.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.met. Qed.
End sec_2_3_concl_2_quadratic.

Module sec_2_3_concl_2_mean.
Import GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_mean.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.met. Qed.
End sec_2_3_concl_2_mean.
