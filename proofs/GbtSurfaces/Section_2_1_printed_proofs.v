(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_2_1_printed Section_2_1_proofs.
Open Scope R_scope.

Module eq_1_f0.
Import GbtSurfaces.Section_2_1_printed.eq_1_f0.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f0.met. Qed.
End eq_1_f0.

Module eq_1_f1.
Import GbtSurfaces.Section_2_1_printed.eq_1_f1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f1.met. Qed.
End eq_1_f1.

Module eq_1_f2.
Import GbtSurfaces.Section_2_1_printed.eq_1_f2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_1_f2.met. Qed.
End eq_1_f2.

Module eq_2.
Import GbtSurfaces.Section_2_1_printed.eq_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_2.met. Qed.
End eq_2.

Module eq_2_zero.
Import GbtSurfaces.Section_2_1_printed.eq_2_zero.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_2_zero.refuted. Qed.
End eq_2_zero.

Module eq_2_zero_true.
Import GbtSurfaces.Section_2_1_printed.eq_2_zero_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.met. Qed.
End eq_2_zero_true.

Module thm_1_1_formal.
Import GbtSurfaces.Section_2_1_printed.thm_1_1_formal.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.met. Qed.
End thm_1_1_formal.

Module thm_1_1_as_functions.
Import GbtSurfaces.Section_2_1_printed.thm_1_1_as_functions.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted. Qed.
End thm_1_1_as_functions.

Module thm_1_1_true.
Import GbtSurfaces.Section_2_1_printed.thm_1_1_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met. Qed.
End thm_1_1_true.

Module thm_1_1_blend.
Import GbtSurfaces.Section_2_1_printed.thm_1_1_blend.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.met. Qed.
End thm_1_1_blend.

Module thm_1_2_Definition_1.
Import GbtSurfaces.Section_2_1_printed.thm_1_2_Definition_1.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_2_Definition_1.refuted. Qed.
End thm_1_2_Definition_1.

Module thm_1_2_where_curves_are_defined.
Import GbtSurfaces.Section_2_1_printed.thm_1_2_where_curves_are_defined.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.met. Qed.
End thm_1_2_where_curves_are_defined.

Module thm_1_3.
Import GbtSurfaces.Section_2_1_printed.thm_1_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_3.met. Qed.
End thm_1_3.

Module thm_1_4.
Import GbtSurfaces.Section_2_1_printed.thm_1_4.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_4.met. Qed.
End thm_1_4.

Module thm_1_5_d1_0_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d1_0_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.met. Qed.
End thm_1_5_d1_0_values.

Module thm_1_5_d1_1_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d1_1_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met. Qed.
End thm_1_5_d1_1_values.

Module thm_1_5_d2_0_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d2_0_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.met. Qed.
End thm_1_5_d2_0_values.

Module thm_1_5_d2_1_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d2_1_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.met. Qed.
End thm_1_5_d2_1_values.

Module thm_1_5_d3_0_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d3_0_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.met. Qed.
End thm_1_5_d3_0_values.

Module thm_1_5_d3_1_values.
Import GbtSurfaces.Section_2_1_printed.thm_1_5_d3_1_values.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.met. Qed.
End thm_1_5_d3_1_values.
