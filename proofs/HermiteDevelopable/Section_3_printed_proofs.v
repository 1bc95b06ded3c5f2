(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_3_printed Section_3_proofs.
Open Scope R_scope.

Module def_3_1.
Import HermiteDevelopable.Section_3_printed.def_3_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_1.met. Qed.
End def_3_1.

Module def_3_1_normal.
Import HermiteDevelopable.Section_3_printed.def_3_1_normal.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_1_normal.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_1_normal.met. Qed.
End def_3_1_normal.

Module def_3_2.
Import HermiteDevelopable.Section_3_printed.def_3_2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_2.proved. Qed.
End def_3_2.

Module def_3_2_lincomb.
Import HermiteDevelopable.Section_3_printed.def_3_2_lincomb.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.def_3_2_lincomb.proved. Qed.
End def_3_2_lincomb.

Module sec_3_g_boundary.
Import HermiteDevelopable.Section_3_printed.sec_3_g_boundary.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.met. Qed.
End sec_3_g_boundary.

Module sec_3_g_prime.
Import HermiteDevelopable.Section_3_printed.sec_3_g_prime.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_g_prime.refuted. Qed.
End sec_3_g_prime.

Module sec_3_g_prime_corrected.
Import HermiteDevelopable.Section_3_printed.sec_3_g_prime_corrected.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.met. Qed.
End sec_3_g_prime_corrected.

Module eq_3_1.
Import HermiteDevelopable.Section_3_printed.eq_3_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1.met. Qed.
End eq_3_1.

Module eq_3_1_must.
Import HermiteDevelopable.Section_3_printed.eq_3_1_must.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_must.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_must.met. Qed.
End eq_3_1_must.

Module eq_3_1_types_a.
Import HermiteDevelopable.Section_3_printed.eq_3_1_types_a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.met. Qed.
End eq_3_1_types_a.

Module eq_3_1_types_b.
Import HermiteDevelopable.Section_3_printed.eq_3_1_types_b.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_types_b.proved. Qed.
End eq_3_1_types_b.

Module eq_3_1_parallel_planes.
Import HermiteDevelopable.Section_3_printed.eq_3_1_parallel_planes.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.met. Qed.
End eq_3_1_parallel_planes.

Module eq_3_1_rho_constant.
Import HermiteDevelopable.Section_3_printed.eq_3_1_rho_constant.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.met. Qed.
End eq_3_1_rho_constant.

Module eq_3_1_rho_quadratic.
Import HermiteDevelopable.Section_3_printed.eq_3_1_rho_quadratic.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.met. Qed.
End eq_3_1_rho_quadratic.

Module eq_3_1_difficulties_same.
Import HermiteDevelopable.Section_3_printed.eq_3_1_difficulties_same.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.met. Qed.
End eq_3_1_difficulties_same.

Module eq_3_2.
Import HermiteDevelopable.Section_3_printed.eq_3_2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2.met. Qed.
End eq_3_2.

Module eq_3_2_edge.
Import HermiteDevelopable.Section_3_printed.eq_3_2_edge.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_edge.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_edge.met. Qed.
End eq_3_2_edge.

Module eq_3_2_planes_a_generatrix.
Import HermiteDevelopable.Section_3_printed.eq_3_2_planes_a_generatrix.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_generatrix.refuted. Qed.
End eq_3_2_planes_a_generatrix.

Module eq_3_2_planes_a_direction.
Import HermiteDevelopable.Section_3_printed.eq_3_2_planes_a_direction.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.met. Qed.
End eq_3_2_planes_a_direction.

Module eq_3_2_planes_b_generatrix.
Import HermiteDevelopable.Section_3_printed.eq_3_2_planes_b_generatrix.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_generatrix.refuted. Qed.
End eq_3_2_planes_b_generatrix.

Module eq_3_2_planes_b_direction.
Import HermiteDevelopable.Section_3_printed.eq_3_2_planes_b_direction.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_direction.refuted. Qed.
End eq_3_2_planes_b_direction.

Module eq_3_2_planes_parallel.
Import HermiteDevelopable.Section_3_printed.eq_3_2_planes_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.met. Qed.
End eq_3_2_planes_parallel.

Module eq_3_2_with_h.
Import HermiteDevelopable.Section_3_printed.eq_3_2_with_h.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.met. Qed.
End eq_3_2_with_h.

Module eq_3_2_across.
Import HermiteDevelopable.Section_3_printed.eq_3_2_across.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_across.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_across.met. Qed.
End eq_3_2_across.

Module eq_3_2_across_summit.
Import HermiteDevelopable.Section_3_printed.eq_3_2_across_summit.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met. Qed.
End eq_3_2_across_summit.

Module eq_3_2_every_degree.
Import HermiteDevelopable.Section_3_printed.eq_3_2_every_degree.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.met. Qed.
End eq_3_2_every_degree.

Module eq_3_3_g_generatrix.
Import HermiteDevelopable.Section_3_printed.eq_3_3_g_generatrix.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_g_generatrix.refuted. Qed.
End eq_3_3_g_generatrix.

Module eq_3_3_g_direction.
Import HermiteDevelopable.Section_3_printed.eq_3_3_g_direction.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_g_direction.proved. Qed.
End eq_3_3_g_direction.

Module eq_3_3_g_true.
Import HermiteDevelopable.Section_3_printed.eq_3_3_g_true.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_g_true.proved. Qed.
End eq_3_3_g_true.

Module eq_3_3a.
Import HermiteDevelopable.Section_3_printed.eq_3_3a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3a.met. Qed.
End eq_3_3a.

Module eq_3_3b.
Import HermiteDevelopable.Section_3_printed.eq_3_3b.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3b.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3b.met. Qed.
End eq_3_3b.

Module eq_3_3_same_as_3_2_generatrix.
Import HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_generatrix.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted. Qed.
End eq_3_3_same_as_3_2_generatrix.

Module eq_3_3_same_as_3_2_direction.
Import HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_direction.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.met. Qed.
End eq_3_3_same_as_3_2_direction.

Module eq_3_3_same_as_3_2_true.
Import HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_true.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.met. Qed.
End eq_3_3_same_as_3_2_true.

Module eq_3_3_developable_Hermite.
Import HermiteDevelopable.Section_3_printed.eq_3_3_developable_Hermite.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.met. Qed.
End eq_3_3_developable_Hermite.

Module eq_3_3_developable_any.
Import HermiteDevelopable.Section_3_printed.eq_3_3_developable_any.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_developable_any.refuted. Qed.
End eq_3_3_developable_any.

Module eq_3_3_exact.
Import HermiteDevelopable.Section_3_printed.eq_3_3_exact.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_exact.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_exact.met. Qed.
End eq_3_3_exact.

Module eq_3_3_multiples_cone.
Import HermiteDevelopable.Section_3_printed.eq_3_3_multiples_cone.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.met. Qed.
End eq_3_3_multiples_cone.

Module eq_3_3_multiples_Hermite.
Import HermiteDevelopable.Section_3_printed.eq_3_3_multiples_Hermite.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.met. Qed.
End eq_3_3_multiples_Hermite.

Module eq_3_3_multiples_any.
Import HermiteDevelopable.Section_3_printed.eq_3_3_multiples_any.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_any.refuted. Qed.
End eq_3_3_multiples_any.

Module eq_3_3_k_below_1.
Import HermiteDevelopable.Section_3_printed.eq_3_3_k_below_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.met. Qed.
End eq_3_3_k_below_1.

Module eq_3_3_k_equal_1.
Import HermiteDevelopable.Section_3_printed.eq_3_3_k_equal_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.met. Qed.
End eq_3_3_k_equal_1.

Module eq_3_3_k_above_1.
Import HermiteDevelopable.Section_3_printed.eq_3_3_k_above_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.met. Qed.
End eq_3_3_k_above_1.

Module sec_3_summit_outside.
Import HermiteDevelopable.Section_3_printed.sec_3_summit_outside.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.met. Qed.
End sec_3_summit_outside.

Module eq_3_4.
Import HermiteDevelopable.Section_3_printed.eq_3_4.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_4.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_3_proofs.eq_3_4.met. Qed.
End eq_3_4.
