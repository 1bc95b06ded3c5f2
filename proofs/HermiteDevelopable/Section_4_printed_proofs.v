(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_4_printed Section_4_proofs.
Open Scope R_scope.

Module sec_4_cone.
Import HermiteDevelopable.Section_4_printed.sec_4_cone.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_cone.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_cone.met. Qed.
End sec_4_cone.

Module eq_4_1.
Import HermiteDevelopable.Section_4_printed.eq_4_1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_1.met. Qed.
End eq_4_1.

Module sec_4_goal_designed.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_designed.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_designed.refuted. Qed.
End sec_4_goal_designed.

Module sec_4_goal_image.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_image.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_image.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_image.met. Qed.
End sec_4_goal_image.

Module sec_4_goal_leaves.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_leaves.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.met. Qed.
End sec_4_goal_leaves.

Module sec_4_goal_nodes.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_nodes.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.met. Qed.
End sec_4_goal_nodes.

Module sec_4_goal_only.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_only.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_only.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_only.met. Qed.
End sec_4_goal_only.

Module sec_4_goal_parallel.
Import HermiteDevelopable.Section_4_printed.sec_4_goal_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.met. Qed.
End sec_4_goal_parallel.

Module sec_4_in_plane.
Import HermiteDevelopable.Section_4_printed.sec_4_in_plane.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_in_plane.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_in_plane.met. Qed.
End sec_4_in_plane.

Module sec_4_r0.
Import HermiteDevelopable.Section_4_printed.sec_4_r0.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_r0.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_r0.met. Qed.
End sec_4_r0.

Module sec_4_I1.
Import HermiteDevelopable.Section_4_printed.sec_4_I1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_I1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_I1.met. Qed.
End sec_4_I1.

Module sec_4_w.
Import HermiteDevelopable.Section_4_printed.sec_4_w.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_w.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_w.met. Qed.
End sec_4_w.

Module eq_4_2.
Import HermiteDevelopable.Section_4_printed.eq_4_2.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2.met. Qed.
End eq_4_2.

Module eq_4_2_tangent_derivative.
Import HermiteDevelopable.Section_4_printed.eq_4_2_tangent_derivative.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_derivative.refuted. Qed.
End eq_4_2_tangent_derivative.

Module eq_4_2_tangent_end_point.
Import HermiteDevelopable.Section_4_printed.eq_4_2_tangent_end_point.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.met. Qed.
End eq_4_2_tangent_end_point.

Module eq_4_2_tangent_parallel.
Import HermiteDevelopable.Section_4_printed.eq_4_2_tangent_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.met. Qed.
End eq_4_2_tangent_parallel.

Module eq_4_2_tangent_true.
Import HermiteDevelopable.Section_4_printed.eq_4_2_tangent_true.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.met. Qed.
End eq_4_2_tangent_true.

Module sec_4_s.
Import HermiteDevelopable.Section_4_printed.sec_4_s.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_s.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_s.met. Qed.
End sec_4_s.

Module eq_4_3.
Import HermiteDevelopable.Section_4_printed.eq_4_3.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_3.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_3.met. Qed.
End eq_4_3.

Module eq_4_4_ru.
Import HermiteDevelopable.Section_4_printed.eq_4_4_ru.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_ru.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_ru.met. Qed.
End eq_4_4_ru.

Module eq_4_4_r1.
Import HermiteDevelopable.Section_4_printed.eq_4_4_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_r1.met. Qed.
End eq_4_4_r1.

Module eq_4_4_r1u.
Import HermiteDevelopable.Section_4_printed.eq_4_4_r1u.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.met. Qed.
End eq_4_4_r1u.

Module eq_4_4_tangent_derivative.
Import HermiteDevelopable.Section_4_printed.eq_4_4_tangent_derivative.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_derivative.refuted. Qed.
End eq_4_4_tangent_derivative.

Module eq_4_4_tangent_end_point.
Import HermiteDevelopable.Section_4_printed.eq_4_4_tangent_end_point.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.met. Qed.
End eq_4_4_tangent_end_point.

Module eq_4_4_tangent_parallel.
Import HermiteDevelopable.Section_4_printed.eq_4_4_tangent_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.met. Qed.
End eq_4_4_tangent_parallel.

Module sec_4_oblique.
Import HermiteDevelopable.Section_4_printed.sec_4_oblique.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.sec_4_oblique.proved. Qed.
End sec_4_oblique.

Module ex_4_data.
Import HermiteDevelopable.Section_4_printed.ex_4_data.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_data.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_data.met. Qed.
End ex_4_data.

Module ex_4_r0.
Import HermiteDevelopable.Section_4_printed.ex_4_r0.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r0.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r0.met. Qed.
End ex_4_r0.

Module ex_4_r0u.
Import HermiteDevelopable.Section_4_printed.ex_4_r0u.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r0u.refuted. Qed.
End ex_4_r0u.

Module ex_4_r.
Import HermiteDevelopable.Section_4_printed.ex_4_r.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r.met. Qed.
End ex_4_r.

Module ex_4_ru.
Import HermiteDevelopable.Section_4_printed.ex_4_ru.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_ru.refuted. Qed.
End ex_4_ru.

Module ex_4_r1.
Import HermiteDevelopable.Section_4_printed.ex_4_r1.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r1.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r1.met. Qed.
End ex_4_r1.

Module ex_4_r1_rounding.
Import HermiteDevelopable.Section_4_printed.ex_4_r1_rounding.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.met. Qed.
End ex_4_r1_rounding.

Module ex_4_r1u.
Import HermiteDevelopable.Section_4_printed.ex_4_r1u.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_r1u.refuted. Qed.
End ex_4_r1u.

Module ex_4_other_data.
Import HermiteDevelopable.Section_4_printed.ex_4_other_data.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_other_data.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_other_data.met. Qed.
End ex_4_other_data.

Module ex_4_other_data_twist.
Import HermiteDevelopable.Section_4_printed.ex_4_other_data_twist.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.met. Qed.
End ex_4_other_data_twist.

Module ex_4_stated_data.
Import HermiteDevelopable.Section_4_printed.ex_4_stated_data.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_stated_data.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_stated_data.met. Qed.
End ex_4_stated_data.

Module ex_4_true_tangents.
Import HermiteDevelopable.Section_4_printed.ex_4_true_tangents.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.met. Qed.
End ex_4_true_tangents.

Module ex_4_a_developable_computed.
Import HermiteDevelopable.Section_4_printed.ex_4_a_developable_computed.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_developable_computed.refuted. Qed.
End ex_4_a_developable_computed.

Module ex_4_a_developable_printed.
Import HermiteDevelopable.Section_4_printed.ex_4_a_developable_printed.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_developable_printed.refuted. Qed.
End ex_4_a_developable_printed.

Module ex_4_a_twist.
Import HermiteDevelopable.Section_4_printed.ex_4_a_twist.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist.met. Qed.
End ex_4_a_twist.

Module ex_4_a_twist_most.
Import HermiteDevelopable.Section_4_printed.ex_4_a_twist_most.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.met. Qed.
End ex_4_a_twist_most.

Module ex_4_a_twist_printed.
Import HermiteDevelopable.Section_4_printed.ex_4_a_twist_printed.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.met. Qed.
End ex_4_a_twist_printed.

Module ex_4_b_developable.
Import HermiteDevelopable.Section_4_printed.ex_4_b_developable.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_b_developable.refuted. Qed.
End ex_4_b_developable.

Module ex_4_b_twist.
Import HermiteDevelopable.Section_4_printed.ex_4_b_twist.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_b_twist.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_4_proofs.ex_4_b_twist.met. Qed.
End ex_4_b_twist.
