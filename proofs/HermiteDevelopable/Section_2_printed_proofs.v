(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_2_printed Section_2_proofs.
Open Scope R_scope.

Module sec_2_cubic_conditions.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_conditions.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.met. Qed.
End sec_2_cubic_conditions.

Module sec_2_cubic_equations.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_equations.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved. Qed.
End sec_2_cubic_equations.

Module sec_2_cubic_a1.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_a1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met. Qed.
End sec_2_cubic_a1.

Module sec_2_cubic_b1.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_b1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met. Qed.
End sec_2_cubic_b1.

Module sec_2_cubic_c1.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_c1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met. Qed.
End sec_2_cubic_c1.

Module sec_2_cubic_d1.
Import HermiteDevelopable.Section_2_printed.sec_2_cubic_d1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met. Qed.
End sec_2_cubic_d1.

Module eq_2_1a.
Import HermiteDevelopable.Section_2_printed.eq_2_1a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1a.met. Qed.
End eq_2_1a.

Module eq_2_1b.
Import HermiteDevelopable.Section_2_printed.eq_2_1b.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b.met. Qed.
End eq_2_1b.

Module eq_2_1b_H1.
Import HermiteDevelopable.Section_2_printed.eq_2_1b_H1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.met. Qed.
End eq_2_1b_H1.

Module eq_2_1b_H2.
Import HermiteDevelopable.Section_2_printed.eq_2_1b_H2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.met. Qed.
End eq_2_1b_H2.

Module eq_2_1b_H3.
Import HermiteDevelopable.Section_2_printed.eq_2_1b_H3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.met. Qed.
End eq_2_1b_H3.

Module eq_2_1b_H4.
Import HermiteDevelopable.Section_2_printed.eq_2_1b_H4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.met. Qed.
End eq_2_1b_H4.

Module sec_2_quartic_conditions.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_conditions.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.met. Qed.
End sec_2_quartic_conditions.

Module sec_2_quartic_solvable.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_solvable.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_solvable.proved. Qed.
End sec_2_quartic_solvable.

Module sec_2_quartic_a1.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_a1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met. Qed.
End sec_2_quartic_a1.

Module sec_2_quartic_b1.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_b1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met. Qed.
End sec_2_quartic_b1.

Module sec_2_quartic_third.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_third.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted. Qed.
End sec_2_quartic_third.

Module sec_2_quartic_third_corrected.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_third_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met. Qed.
End sec_2_quartic_third_corrected.

Module sec_2_quartic_d1.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_d1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met. Qed.
End sec_2_quartic_d1.

Module sec_2_quartic_e1.
Import HermiteDevelopable.Section_2_printed.sec_2_quartic_e1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met. Qed.
End sec_2_quartic_e1.

Module eq_2_2.
Import HermiteDevelopable.Section_2_printed.eq_2_2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_2.met. Qed.
End eq_2_2.

Module eq_2_3.
Import HermiteDevelopable.Section_2_printed.eq_2_3.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3.refuted. Qed.
End eq_2_3.

Module eq_2_3_corrected.
Import HermiteDevelopable.Section_2_printed.eq_2_3_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met. Qed.
End eq_2_3_corrected.

Module eq_2_3_H1.
Import HermiteDevelopable.Section_2_printed.eq_2_3_H1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H1.met. Qed.
End eq_2_3_H1.

Module eq_2_3_H2.
Import HermiteDevelopable.Section_2_printed.eq_2_3_H2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H2.met. Qed.
End eq_2_3_H2.

Module eq_2_3_H3.
Import HermiteDevelopable.Section_2_printed.eq_2_3_H3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H3.met. Qed.
End eq_2_3_H3.

Module eq_2_3_H4.
Import HermiteDevelopable.Section_2_printed.eq_2_3_H4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H4.met. Qed.
End eq_2_3_H4.

Module eq_2_3_H5.
Import HermiteDevelopable.Section_2_printed.eq_2_3_H5.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H5.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_3_H5.met. Qed.
End eq_2_3_H5.

Module sec_2_quintic_conditions.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_conditions.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.met. Qed.
End sec_2_quintic_conditions.

Module sec_2_quintic_a1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_a1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met. Qed.
End sec_2_quintic_a1.

Module sec_2_quintic_b1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_b1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met. Qed.
End sec_2_quintic_b1.

Module sec_2_quintic_c1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_c1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met. Qed.
End sec_2_quintic_c1.

Module sec_2_quintic_d1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_d1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met. Qed.
End sec_2_quintic_d1.

Module sec_2_quintic_e1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_e1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met. Qed.
End sec_2_quintic_e1.

Module sec_2_quintic_f1.
Import HermiteDevelopable.Section_2_printed.sec_2_quintic_f1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met. Qed.
End sec_2_quintic_f1.

Module eq_2_4.
Import HermiteDevelopable.Section_2_printed.eq_2_4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.eq_2_4.met. Qed.
End eq_2_4.

Module sec_2_control.
Import HermiteDevelopable.Section_2_printed.sec_2_control.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_control.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.sec_2_control.met. Qed.
End sec_2_control.

Module fig_1b_middle.
Import HermiteDevelopable.Section_2_printed.fig_1b_middle.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_2_proofs.fig_1b_middle.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_2_proofs.fig_1b_middle.met. Qed.
End fig_1b_middle.
