(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_3_1_printed Section_3_1_proofs.
Open Scope R_scope.

Module sec_3_1_polynomials.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_polynomials.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met. Qed.
End sec_3_1_polynomials.

Module sec_3_1_substituted.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_substituted.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met. Qed.
End sec_3_1_substituted.

Module sec_3_1_coefficients.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_coefficients.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met. Qed.
End sec_3_1_coefficients.

Module sec_3_1_hermite_1.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.met. Qed.
End sec_3_1_hermite_1.

Module sec_3_1_hermite_2.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.met. Qed.
End sec_3_1_hermite_2.

Module sec_3_1_hermite_3.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.met. Qed.
End sec_3_1_hermite_3.

Module sec_3_1_hermite_4.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.met. Qed.
End sec_3_1_hermite_4.

Module eq_3_5_A_r1.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.met. Qed.
End eq_3_5_A_r1.

Module eq_3_5_A_r2.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.met. Qed.
End eq_3_5_A_r2.

Module eq_3_5_A_r3.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.met. Qed.
End eq_3_5_A_r3.

Module eq_3_5_A_r4.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.met. Qed.
End eq_3_5_A_r4.

Module eq_3_5_B.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_B.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_B.refuted. Qed.
End eq_3_5_B.

Module eq_3_5_B_corrected.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_B_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.met. Qed.
End eq_3_5_B_corrected.

Module eq_3_5_C_r1.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.met. Qed.
End eq_3_5_C_r1.

Module eq_3_5_C_r2.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.met. Qed.
End eq_3_5_C_r2.

Module eq_3_5_C_r3.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.met. Qed.
End eq_3_5_C_r3.

Module eq_3_5_C_r4.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.met. Qed.
End eq_3_5_C_r4.

Module eq_3_5_unique.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_unique.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.met. Qed.
End eq_3_5_unique.

Module eq_3_5_det.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_det.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_det.proved. Qed.
End eq_3_5_det.

Module eq_3_5_k.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_k.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.met. Qed.
End eq_3_5_k.

Module eq_3_5_sol_p1.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.met. Qed.
End eq_3_5_sol_p1.

Module eq_3_5_sol_p0u.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.met. Qed.
End eq_3_5_sol_p0u.

Module eq_3_5_sol_p1u.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.met. Qed.
End eq_3_5_sol_p1u.

Module eq_3_5_sol_p0.
Import HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.met. Qed.
End eq_3_5_sol_p0.

Module sec_3_1_conclusion.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_conclusion.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.met. Qed.
End sec_3_1_conclusion.

Module alg_3_1_step1.
Import HermiteDevelopable.Section_3_1_printed.alg_3_1_step1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.met. Qed.
End alg_3_1_step1.

Module alg_3_1_step2.
Import HermiteDevelopable.Section_3_1_printed.alg_3_1_step2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.met. Qed.
End alg_3_1_step2.

Module alg_3_1_step3.
Import HermiteDevelopable.Section_3_1_printed.alg_3_1_step3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.met. Qed.
End alg_3_1_step3.

Module sec_3_1_tension.
Import HermiteDevelopable.Section_3_1_printed.sec_3_1_tension.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.met. Qed.
End sec_3_1_tension.

Module ex_3_1_arrange.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_arrange.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.met. Qed.
End ex_3_1_arrange.

Module ex_3_1_tension_effect.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_tension_effect.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.met. Qed.
End ex_3_1_tension_effect.

Module ex_3_1_p1.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_p1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.met. Qed.
End ex_3_1_p1.

Module ex_3_1_p0u.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_p0u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.met. Qed.
End ex_3_1_p0u.

Module ex_3_1_p1u.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_p1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.met. Qed.
End ex_3_1_p1u.

Module ex_3_1_p0.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_p0.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.met. Qed.
End ex_3_1_p0.

Module ex_3_1_parallel.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.met. Qed.
End ex_3_1_parallel.

Module ex_3_1_width.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_width.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.met. Qed.
End ex_3_1_width.

Module ex_3_1_shapes.
Import HermiteDevelopable.Section_3_1_printed.ex_3_1_shapes.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.met. Qed.
End ex_3_1_shapes.
