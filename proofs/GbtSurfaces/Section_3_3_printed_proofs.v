(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_3_printed Section_3_3_proofs.
Open Scope R_scope.

Module sec_3_3_generatrix.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_generatrix.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met. Qed.
End sec_3_3_generatrix.

Module sec_3_3_same_degree_literal.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_same_degree_literal.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_literal.refuted. Qed.
End sec_3_3_same_degree_literal.

Module sec_3_3_same_degree_in_general.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_same_degree_in_general.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.met. Qed.
End sec_3_3_same_degree_in_general.

Module eq_17_0.
Import GbtSurfaces.Section_3_3_printed.eq_17_0.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_17_0.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_17_0.met. Qed.
End eq_17_0.

Module eq_17_1.
Import GbtSurfaces.Section_3_3_printed.eq_17_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_17_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_17_1.met. Qed.
End eq_17_1.

Module sec_3_3_condition_1.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_condition_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.met. Qed.
End sec_3_3_condition_1.

Module sec_3_3_condition_2.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_condition_2.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2.refuted. Qed.
End sec_3_3_condition_2.

Module eq_18.
Import GbtSurfaces.Section_3_3_printed.eq_18.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18.refuted. Qed.
End eq_18.

Module eq_18_corrected.
Import GbtSurfaces.Section_3_3_printed.eq_18_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met. Qed.
End eq_18_corrected.

Module eq_18_true.
Import GbtSurfaces.Section_3_3_printed.eq_18_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_true.met. Qed.
End eq_18_true.

Module eq_18_sufficient.
Import GbtSurfaces.Section_3_3_printed.eq_18_sufficient.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.met. Qed.
End eq_18_sufficient.

Module eq_18_necessary.
Import GbtSurfaces.Section_3_3_printed.eq_18_necessary.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met. Qed.
End eq_18_necessary.

Module eq_18_defect.
Import GbtSurfaces.Section_3_3_printed.eq_18_defect.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_defect.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_defect.met. Qed.
End eq_18_defect.

Module eq_18_tensor.
Import GbtSurfaces.Section_3_3_printed.eq_18_tensor.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_tensor.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_18_tensor.met. Qed.
End eq_18_tensor.

Module sec_3_3_benefits_a.
Import GbtSurfaces.Section_3_3_printed.sec_3_3_benefits_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.met. Qed.
End sec_3_3_benefits_a.

Module prop_3_3_a.
Import GbtSurfaces.Section_3_3_printed.prop_3_3_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met. Qed.
End prop_3_3_a.

Module prop_3_3_b.
Import GbtSurfaces.Section_3_3_printed.prop_3_3_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_3_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_3_b.met. Qed.
End prop_3_3_b.

Module prop_3_4_a.
Import GbtSurfaces.Section_3_3_printed.prop_3_4_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_a.met. Qed.
End prop_3_4_a.

Module prop_3_4_a_net.
Import GbtSurfaces.Section_3_3_printed.prop_3_4_a_net.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.met. Qed.
End prop_3_4_a_net.

Module prop_3_4_b.
Import GbtSurfaces.Section_3_3_printed.prop_3_4_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.prop_3_4_b.met. Qed.
End prop_3_4_b.

Module alg_3_a.
Import GbtSurfaces.Section_3_3_printed.alg_3_a.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.alg_3_a.refuted. Qed.
End alg_3_a.

Module alg_3_a_corrected.
Import GbtSurfaces.Section_3_3_printed.alg_3_a_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.met. Qed.
End alg_3_a_corrected.

Module alg_3_b.
Import GbtSurfaces.Section_3_3_printed.alg_3_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.alg_3_b.refuted. Qed.
End alg_3_b.

Module ex_3_3_curves.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_curves.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted. Qed.
End ex_3_3_curves.

Module ex_3_3_curves_corrected.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_curves_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met. Qed.
End ex_3_3_curves_corrected.

Module eq_19_literal.
Import GbtSurfaces.Section_3_3_printed.eq_19_literal.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_19_literal.refuted. Qed.
End eq_19_literal.

Module eq_19_m_is_4.
Import GbtSurfaces.Section_3_3_printed.eq_19_m_is_4.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.met. Qed.
End eq_19_m_is_4.

Module eq_19_tensor.
Import GbtSurfaces.Section_3_3_printed.eq_19_tensor.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.eq_19_tensor.refuted. Qed.
End eq_19_tensor.

Module ex_3_3_gl_0.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_gl_0.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted. Qed.
End ex_3_3_gl_0.

Module ex_3_3_gl_0_corrected.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_gl_0_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met. Qed.
End ex_3_3_gl_0_corrected.

Module ex_3_3_gl_1.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_gl_1.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted. Qed.
End ex_3_3_gl_1.

Module ex_3_3_gl_1_corrected.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_gl_1_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met. Qed.
End ex_3_3_gl_1_corrected.

Module ex_3_3_composite.
Import GbtSurfaces.Section_3_3_printed.ex_3_3_composite.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.met. Qed.
End ex_3_3_composite.
