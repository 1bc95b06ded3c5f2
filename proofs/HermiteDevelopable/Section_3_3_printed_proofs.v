(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_3_3_printed Section_3_3_proofs.
Open Scope R_scope.

Module sec_3_3_curves.
Import HermiteDevelopable.Section_3_3_printed.sec_3_3_curves.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.met. Qed.
End sec_3_3_curves.

Module eq_3_7_A_r1.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.met. Qed.
End eq_3_7_A_r1.

Module eq_3_7_A_r2.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.met. Qed.
End eq_3_7_A_r2.

Module eq_3_7_A_r3.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.met. Qed.
End eq_3_7_A_r3.

Module eq_3_7_A_r4.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.met. Qed.
End eq_3_7_A_r4.

Module eq_3_7_A_r5.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r5.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.met. Qed.
End eq_3_7_A_r5.

Module eq_3_7_A_r6.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r6.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.met. Qed.
End eq_3_7_A_r6.

Module eq_3_7_B.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_B.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_B.refuted. Qed.
End eq_3_7_B.

Module eq_3_7_B_corrected.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_B_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.met. Qed.
End eq_3_7_B_corrected.

Module eq_3_7_C_r1.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.met. Qed.
End eq_3_7_C_r1.

Module eq_3_7_C_r2.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.met. Qed.
End eq_3_7_C_r2.

Module eq_3_7_C_r3.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.met. Qed.
End eq_3_7_C_r3.

Module eq_3_7_C_r4.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.met. Qed.
End eq_3_7_C_r4.

Module eq_3_7_C_r5.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r5.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.met. Qed.
End eq_3_7_C_r5.

Module eq_3_7_C_r6.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r6.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.met. Qed.
End eq_3_7_C_r6.

Module eq_3_7_det.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_det.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_det.proved. Qed.
End eq_3_7_det.

Module eq_3_7_k.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_k.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.met. Qed.
End eq_3_7_k.

Module eq_3_7_k_needed.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_k_needed.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.met. Qed.
End eq_3_7_k_needed.

Module eq_3_7_sol_p0u.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.met. Qed.
End eq_3_7_sol_p0u.

Module eq_3_7_sol_qu.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_qu.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.met. Qed.
End eq_3_7_sol_qu.

Module eq_3_7_sol_p1u.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.met. Qed.
End eq_3_7_sol_p1u.

Module eq_3_7_sol_q.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_q.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.met. Qed.
End eq_3_7_sol_q.

Module eq_3_7_sol_p1.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.met. Qed.
End eq_3_7_sol_p1.

Module eq_3_7_sol_o.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_o.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.met. Qed.
End eq_3_7_sol_o.

Module eq_3_7_system.
Import HermiteDevelopable.Section_3_3_printed.eq_3_7_system.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.met. Qed.
End eq_3_7_system.

Module sec_3_3_advantage.
Import HermiteDevelopable.Section_3_3_printed.sec_3_3_advantage.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.met. Qed.
End sec_3_3_advantage.

Module ex_3_3_equation.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_equation.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation.refuted. Qed.
End ex_3_3_equation.

Module ex_3_3_equation_true.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_equation_true.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.met. Qed.
End ex_3_3_equation_true.

Module ex_3_3_p0u.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.met. Qed.
End ex_3_3_p0u.

Module ex_3_3_qu.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_qu.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.met. Qed.
End ex_3_3_qu.

Module ex_3_3_p1u.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.met. Qed.
End ex_3_3_p1u.

Module ex_3_3_q.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_q.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.met. Qed.
End ex_3_3_q.

Module ex_3_3_p1.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.met. Qed.
End ex_3_3_p1.

Module ex_3_3_o.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_o.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.met. Qed.
End ex_3_3_o.

Module ex_3_3_parallel.
Import HermiteDevelopable.Section_3_3_printed.ex_3_3_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.met. Qed.
End ex_3_3_parallel.

Module fig_4d_constant.
Import HermiteDevelopable.Section_3_3_printed.fig_4d_constant.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.met. Qed.
End fig_4d_constant.
