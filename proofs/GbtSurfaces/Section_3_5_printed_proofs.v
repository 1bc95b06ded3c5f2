(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_3_5_printed Section_3_5_proofs.
Open Scope R_scope.

Module eq_27.
Import GbtSurfaces.Section_3_5_printed.eq_27.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_27.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_27.met. Qed.
End eq_27.

Module sec_3_5_categories.
Import GbtSurfaces.Section_3_5_printed.sec_3_5_categories.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved. Qed.
End sec_3_5_categories.

Module sec_3_5_not_expressible_sine.
Import GbtSurfaces.Section_3_5_printed.sec_3_5_not_expressible_sine.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met. Qed.
End sec_3_5_not_expressible_sine.

Module eq_29.
Import GbtSurfaces.Section_3_5_printed.eq_29.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_29.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_29.met. Qed.
End eq_29.

Module eq_30.
Import GbtSurfaces.Section_3_5_printed.eq_30.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_30.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_30.met. Qed.
End eq_30.

Module eq_31_2.
Import GbtSurfaces.Section_3_5_printed.eq_31_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_2.met. Qed.
End eq_31_2.

Module eq_31_3.
Import GbtSurfaces.Section_3_5_printed.eq_31_3.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_3.met. Qed.
End eq_31_3.

Module eq_31_4.
Import GbtSurfaces.Section_3_5_printed.eq_31_4.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_4.met. Qed.
End eq_31_4.

Module eq_31_5.
Import GbtSurfaces.Section_3_5_printed.eq_31_5.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_5.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.eq_31_5.met. Qed.
End eq_31_5.

Module prop_3_7_1_a.
Import GbtSurfaces.Section_3_5_printed.prop_3_7_1_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.met. Qed.
End prop_3_7_1_a.

Module prop_3_7_2a.
Import GbtSurfaces.Section_3_5_printed.prop_3_7_2a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.met. Qed.
End prop_3_7_2a.

Module prop_3_7_2b.
Import GbtSurfaces.Section_3_5_printed.prop_3_7_2b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.met. Qed.
End prop_3_7_2b.

Module alg_5_a.
Import GbtSurfaces.Section_3_5_printed.alg_5_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.alg_5_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.alg_5_a.met. Qed.
End alg_5_a.

Module alg_5_b.
Import GbtSurfaces.Section_3_5_printed.alg_5_b.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.alg_5_b.refuted. Qed.
End alg_5_b.

Module ex_3_5_sections.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_sections.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved. Qed.
End ex_3_5_sections.

Module ex_3_5_trajectories.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_trajectories.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved. Qed.
End ex_3_5_trajectories.

Module ex_3_5_c1_sections.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_c1_sections.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.met. Qed.
End ex_3_5_c1_sections.

Module ex_3_5_c1_trajectories.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_c1_trajectories.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.met. Qed.
End ex_3_5_c1_trajectories.

Module ex_3_5_c2_sections.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_c2_sections.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.met. Qed.
End ex_3_5_c2_sections.

Module ex_3_5_c2_trajectories.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories.refuted. Qed.
End ex_3_5_c2_trajectories.

Module ex_3_5_c2_trajectories_true.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories_true.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.met. Qed.
End ex_3_5_c2_trajectories_true.

Module ex_3_5_contiguous_each_with_its_own.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_each_with_its_own.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted. Qed.
End ex_3_5_contiguous_each_with_its_own.

Module ex_3_5_contiguous_one_trajectory.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_trajectory.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met. Qed.
End ex_3_5_contiguous_one_trajectory.

Module ex_3_5_contiguous_one_section.
Import GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_section.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.met. Qed.
End ex_3_5_contiguous_one_section.

Module sec_3_5_unnecessary.
Import GbtSurfaces.Section_3_5_printed.sec_3_5_unnecessary.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.met. Qed.
End sec_3_5_unnecessary.
