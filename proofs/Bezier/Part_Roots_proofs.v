(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Roots.
Open Scope R_scope.

Module reach_unit.
Import Bezier.Part_Roots.reach_unit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros a b c N; compute_goal; apply unit_root. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 0, 0; refine (conj (fun E => _) _); [ injection E as E; lra | compute_goal; replace (1 * 1 + (0 * 0 + (0 * 0 + 0))) with 1 by ring; rewrite sqrt_1; lra ]. Qed.
End reach_unit.

Module reach_unit_zero.
Import Bezier.Part_Roots.reach_unit_zero.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros a b c M N; revert M; compute_goal; apply unit_root. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4; met) | (exists 0, 0, 0; met) | (exists 13, 8, 8; met) | (exists 7, 7, 2; met) | (exists 1, 0, 0; met)]. Qed.
End reach_unit_zero.

Module reach_size.
Import Bezier.Part_Roots.reach_size.
Theorem proved : statement.
Proof. cbv delta [statement]; intros y z A B C D; split; [ apply same_square; [ apply sqrt_pos | apply Rmult_le_pos; apply sqrt_pos | radicals; nra ] | f_equal; ring ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (0); met)]. Qed.
End reach_size.

Module reach_size_slip.
Import Bezier.Part_Roots.reach_size_slip.
Theorem refuted : ~ statement.
Proof. cbv delta [statement not]; intro no; specialize (no (-1) ltac:(lra)); pose proof (sqrt_pos ((-1) ^ 2)); lra. Qed.
End reach_size_slip.

Module reach_product.
Import Bezier.Part_Roots.reach_product.
Theorem proved : statement.
Proof. cbv delta [statement]; intros A B P Q S; symmetry; apply sqrt_mult; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1), (1); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End reach_product.

Module reach_least.
Import Bezier.Part_Roots.reach_least.
Theorem proved : statement.
Proof. cbv delta [statement]; intros y P Q; split; [ apply sqrt_lt_R0; nra | apply Rle_ge, sqrt_pos ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End reach_least.

Module reach_triangle.
Import Bezier.Part_Roots.reach_triangle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros a b c d e f; compute_goal; apply triangle. Qed.
End reach_triangle.

Module reach_triangle_slip.
Import Bezier.Part_Roots.reach_triangle_slip.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not]; intro no; specialize (no 0 0 0 0 0 0); compute_in no; revert no; replace ((0 + 0) * (0 + 0) + ((0 + 0) * (0 + 0) + ((0 + 0) * (0 + 0) + 0))) with 0 by ring; replace (0 * 0 + (0 * 0 + (0 * 0 + 0))) with 0 by ring; rewrite sqrt_0; lra. Qed.
End reach_triangle_slip.

Module reach_subadditive.
Import Bezier.Part_Roots.reach_subadditive.
Theorem proved : statement.
Proof. cbv delta [statement]; intros A B P Q S; radicals; apply less_square; nra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1), (1); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End reach_subadditive.

Module reach_above.
Import Bezier.Part_Roots.reach_above.
Theorem proved : statement.
Proof. cbv delta [statement]; intros y P Q; split; [ apply sqrt_lt_1_alt; lra | radicals; nra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End reach_above.
