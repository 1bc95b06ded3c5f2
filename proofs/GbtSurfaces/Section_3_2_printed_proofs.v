(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_2_printed Section_3_2_proofs.
Open Scope R_scope.

Module eq_14.
Import GbtSurfaces.Section_3_2_printed.eq_14.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_14.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_14.met. Qed.
End eq_14.

Module sec_3_2_segments.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_segments.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met. Qed.
End sec_3_2_segments.

Module sec_3_2_linear.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_linear.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met. Qed.
End sec_3_2_linear.

Module prop_3_2_a.
Import GbtSurfaces.Section_3_2_printed.prop_3_2_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met. Qed.
End prop_3_2_a.

Module prop_3_2_b.
Import GbtSurfaces.Section_3_2_printed.prop_3_2_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met. Qed.
End prop_3_2_b.

Module prop_3_2_c.
Import GbtSurfaces.Section_3_2_printed.prop_3_2_c.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met. Qed.
End prop_3_2_c.

Module eq_15.
Import GbtSurfaces.Section_3_2_printed.eq_15.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_15.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_15.met. Qed.
End eq_15.

Module sec_3_2_fixed.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_fixed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met. Qed.
End sec_3_2_fixed.

Module sec_3_2_list_1.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_list_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.met. Qed.
End sec_3_2_list_1.

Module sec_3_2_list_2.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_list_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.met. Qed.
End sec_3_2_list_2.

Module sec_3_2_list_3.
Import GbtSurfaces.Section_3_2_printed.sec_3_2_list_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.met. Qed.
End sec_3_2_list_3.

Module alg_2_1.
Import GbtSurfaces.Section_3_2_printed.alg_2_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_1.met. Qed.
End alg_2_1.

Module alg_2_2.
Import GbtSurfaces.Section_3_2_printed.alg_2_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_2.met. Qed.
End alg_2_2.

Module alg_2_2_irregular.
Import GbtSurfaces.Section_3_2_printed.alg_2_2_irregular.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.met. Qed.
End alg_2_2_irregular.

Module eq_16.
Import GbtSurfaces.Section_3_2_printed.eq_16.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_16.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.eq_16.met. Qed.
End eq_16.

Module ex_3_2_corners.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_corners.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.met. Qed.
End ex_3_2_corners.

Module ex_3_2_division_z_lines.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_division_z_lines.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved. Qed.
End ex_3_2_division_z_lines.

Module ex_3_2_division_Q0l.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q0l.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved. Qed.
End ex_3_2_division_Q0l.

Module ex_3_2_division_Q3l.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q3l.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted. Qed.
End ex_3_2_division_Q3l.

Module ex_3_2_division_Q3l_corrected.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q3l_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved. Qed.
End ex_3_2_division_Q3l_corrected.

Module ex_3_2_equal_parts_a.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved. Qed.
End ex_3_2_equal_parts_a.

Module ex_3_2_equal_parts_b.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved. Qed.
End ex_3_2_equal_parts_b.

Module ex_3_2_equal_parts_c.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_c.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved. Qed.
End ex_3_2_equal_parts_c.

Module ex_3_2_equal_parts_d.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_d.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted. Qed.
End ex_3_2_equal_parts_d.

Module ex_3_2_equal_parts_d_corrected.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_d_corrected.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved. Qed.
End ex_3_2_equal_parts_d_corrected.

Module ex_3_2_interior.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_interior.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved. Qed.
End ex_3_2_interior.

Module ex_3_2_equation.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_equation.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted. Qed.
End ex_3_2_equation.

Module ex_3_2_sixteen.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_sixteen.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved. Qed.
End ex_3_2_sixteen.

Module ex_3_2_coplanar.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_coplanar.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved. Qed.
End ex_3_2_coplanar.

Module ex_3_2_noncoplanar_possible.
Import GbtSurfaces.Section_3_2_printed.ex_3_2_noncoplanar_possible.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.met. Qed.
End ex_3_2_noncoplanar_possible.
