(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_3_2_printed Section_3_2_proofs.
Open Scope R_scope.

Module sec_3_2_curves.
Import HermiteDevelopable.Section_3_2_printed.sec_3_2_curves.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.met. Qed.
End sec_3_2_curves.

Module eq_3_6_A_r1.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.met. Qed.
End eq_3_6_A_r1.

Module eq_3_6_A_r2.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.met. Qed.
End eq_3_6_A_r2.

Module eq_3_6_A_r3.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.met. Qed.
End eq_3_6_A_r3.

Module eq_3_6_A_r4.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.met. Qed.
End eq_3_6_A_r4.

Module eq_3_6_A_r5.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r5.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.met. Qed.
End eq_3_6_A_r5.

Module eq_3_6_B.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_B.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_B.refuted. Qed.
End eq_3_6_B.

Module eq_3_6_B_corrected.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_B_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.met. Qed.
End eq_3_6_B_corrected.

Module eq_3_6_C_r1.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.met. Qed.
End eq_3_6_C_r1.

Module eq_3_6_C_r2.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r2.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2.refuted. Qed.
End eq_3_6_C_r2.

Module eq_3_6_C_r2_corrected.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r2_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.met. Qed.
End eq_3_6_C_r2_corrected.

Module eq_3_6_C_r3.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.met. Qed.
End eq_3_6_C_r3.

Module eq_3_6_C_r4.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.met. Qed.
End eq_3_6_C_r4.

Module eq_3_6_C_r5.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r5.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5.refuted. Qed.
End eq_3_6_C_r5.

Module eq_3_6_C_r5_corrected.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r5_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.met. Qed.
End eq_3_6_C_r5_corrected.

Module eq_3_6_det.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_det.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det.refuted. Qed.
End eq_3_6_det.

Module eq_3_6_det_corrected.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_det_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_corrected.proved. Qed.
End eq_3_6_det_corrected.

Module eq_3_6_det_true.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_det_true.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.met. Qed.
End eq_3_6_det_true.

Module eq_3_6_det_slip.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_det_slip.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_slip.proved. Qed.
End eq_3_6_det_slip.

Module eq_3_6_det_factored.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_det_factored.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_factored.proved. Qed.
End eq_3_6_det_factored.

Module eq_3_6_k.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_k.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.met. Qed.
End eq_3_6_k.

Module eq_3_6_k_every.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_k_every.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.met. Qed.
End eq_3_6_k_every.

Module eq_3_6_k_135_136.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_k_135_136.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.met. Qed.
End eq_3_6_k_135_136.

Module eq_3_6_sol_q.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_q.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.met. Qed.
End eq_3_6_sol_q.

Module eq_3_6_sol_p1.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.met. Qed.
End eq_3_6_sol_p1.

Module eq_3_6_sol_p0u.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.met. Qed.
End eq_3_6_sol_p0u.

Module eq_3_6_sol_p1u.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.met. Qed.
End eq_3_6_sol_p1u.

Module eq_3_6_sol_o.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_o.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.met. Qed.
End eq_3_6_sol_o.

Module eq_3_6_system.
Import HermiteDevelopable.Section_3_2_printed.eq_3_6_system.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.met. Qed.
End eq_3_6_system.

Module sec_3_2_advantage.
Import HermiteDevelopable.Section_3_2_printed.sec_3_2_advantage.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.met. Qed.
End sec_3_2_advantage.

Module ex_3_2_q.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_q.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.met. Qed.
End ex_3_2_q.

Module ex_3_2_p1.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.met. Qed.
End ex_3_2_p1.

Module ex_3_2_p0u.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.met. Qed.
End ex_3_2_p0u.

Module ex_3_2_p1u.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.met. Qed.
End ex_3_2_p1u.

Module ex_3_2_o.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_o.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.met. Qed.
End ex_3_2_o.

Module ex_3_2_parallel.
Import HermiteDevelopable.Section_3_2_printed.ex_3_2_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.met. Qed.
End ex_3_2_parallel.
