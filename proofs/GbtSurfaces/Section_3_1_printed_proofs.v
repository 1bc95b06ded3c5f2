(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_1_printed Section_3_1_proofs.
Open Scope R_scope.

Module sec_3_1_i.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_i.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_i.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_i.met. Qed.
End sec_3_1_i.

Module eq_8_1.
Import GbtSurfaces.Section_3_1_printed.eq_8_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_8_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_8_1.met. Qed.
End eq_8_1.

Module eq_8_2.
Import GbtSurfaces.Section_3_1_printed.eq_8_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_8_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_8_2.met. Qed.
End eq_8_2.

Module prop_3_1.
Import GbtSurfaces.Section_3_1_printed.prop_3_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.prop_3_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.prop_3_1.met. Qed.
End prop_3_1.

Module sec_3_1_translating.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_translating.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.met. Qed.
End sec_3_1_translating.

Module sec_3_1_not_tensor_literal.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_not_tensor_literal.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted. Qed.
End sec_3_1_not_tensor_literal.

Module sec_3_1_not_tensor_as_it_stands.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_not_tensor_as_it_stands.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met. Qed.
End sec_3_1_not_tensor_as_it_stands.

Module sec_3_1_order_one_missing_none.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_order_one_missing_none.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.met. Qed.
End sec_3_1_order_one_missing_none.

Module eq_10.
Import GbtSurfaces.Section_3_1_printed.eq_10.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10.met. Qed.
End eq_10.

Module eq_10_bernstein.
Import GbtSurfaces.Section_3_1_printed.eq_10_bernstein.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met. Qed.
End eq_10_bernstein.

Module eq_10_extending.
Import GbtSurfaces.Section_3_1_printed.eq_10_extending.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_10_extending.met. Qed.
End eq_10_extending.

Module eq_11.
Import GbtSurfaces.Section_3_1_printed.eq_11.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11.refuted. Qed.
End eq_11.

Module eq_11_corrected.
Import GbtSurfaces.Section_3_1_printed.eq_11_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_corrected.met. Qed.
End eq_11_corrected.

Module eq_11_points.
Import GbtSurfaces.Section_3_1_printed.eq_11_points.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted. Qed.
End eq_11_points.

Module eq_11_points_corrected.
Import GbtSurfaces.Section_3_1_printed.eq_11_points_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.met. Qed.
End eq_11_points_corrected.

Module eq_11_parameters.
Import GbtSurfaces.Section_3_1_printed.eq_11_parameters.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_parameters.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_11_parameters.met. Qed.
End eq_11_parameters.

Module eq_12_1.
Import GbtSurfaces.Section_3_1_printed.eq_12_1.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted. Qed.
End eq_12_1.

Module eq_12_1_corrected.
Import GbtSurfaces.Section_3_1_printed.eq_12_1_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.met. Qed.
End eq_12_1_corrected.

Module eq_12_2.
Import GbtSurfaces.Section_3_1_printed.eq_12_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_2.met. Qed.
End eq_12_2.

Module eq_12_3.
Import GbtSurfaces.Section_3_1_printed.eq_12_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_3.met. Qed.
End eq_12_3.

Module eq_12_4.
Import GbtSurfaces.Section_3_1_printed.eq_12_4.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_12_4.met. Qed.
End eq_12_4.

Module thm_3.
Import GbtSurfaces.Section_3_1_printed.thm_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.thm_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.thm_3.met. Qed.
End thm_3.

Module sec_3_1_benefits.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_benefits.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.met. Qed.
End sec_3_1_benefits.

Module sec_3_1_any_shape_literal.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_any_shape_literal.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted. Qed.
End sec_3_1_any_shape_literal.

Module sec_3_1_any_shape_the_shape_changes.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_any_shape_the_shape_changes.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met. Qed.
End sec_3_1_any_shape_the_shape_changes.

Module alg_1.
Import GbtSurfaces.Section_3_1_printed.alg_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.alg_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.alg_1.met. Qed.
End alg_1.

Module ex_3_1_points.
Import GbtSurfaces.Section_3_1_printed.ex_3_1_points.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved. Qed.
End ex_3_1_points.

Module ex_3_1_normal.
Import GbtSurfaces.Section_3_1_printed.ex_3_1_normal.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_normal.proved. Qed.
End ex_3_1_normal.

Module eq_13.
Import GbtSurfaces.Section_3_1_printed.eq_13.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_13.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.eq_13.met. Qed.
End eq_13.

Module ex_3_1_net.
Import GbtSurfaces.Section_3_1_printed.ex_3_1_net.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved. Qed.
End ex_3_1_net.

Module ex_3_1_mesh_count.
Import GbtSurfaces.Section_3_1_printed.ex_3_1_mesh_count.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved. Qed.
End ex_3_1_mesh_count.

Module ex_3_1_hull.
Import GbtSurfaces.Section_3_1_printed.ex_3_1_hull.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.met. Qed.
End ex_3_1_hull.

Module sec_3_1_effect.
Import GbtSurfaces.Section_3_1_printed.sec_3_1_effect.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.met. Qed.
End sec_3_1_effect.

Module prop_3_1_translation.
Import GbtSurfaces.Section_3_1_printed.prop_3_1_translation.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.met. Qed.
End prop_3_1_translation.
