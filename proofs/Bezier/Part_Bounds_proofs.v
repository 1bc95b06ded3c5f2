(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Bounds.
Open Scope R_scope.

Module reach_surd.
Import Bezier.Part_Bounds.reach_surd.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End reach_surd.

Module reach_simplex.
Import Bezier.Part_Bounds.reach_simplex.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1), (1), (1), (1 / 3), (1 / 3); met) | (exists (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (13), (8), (8), (1 / 3), (1 / 3); met) | (exists (1), (1), (1), (1 / 3), (1 / 3); met) | (exists (1), (1), (1), (1 / 3), (1 / 3); met)]. Qed.
End reach_simplex.

Module reach_between.
Import Bezier.Part_Bounds.reach_between.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), (4), (5); met) | (exists (0), (0), (0), (0); met) | (exists (13), (8), (8), (6); met) | (exists (1), (1), (1), (1); met) | (exists (1), (0), (0), (0); met)]. Qed.
End reach_between.

Module reach_interval.
Import Bezier.Part_Bounds.reach_interval.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), (4); met) | (exists (0), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (0), (0); met)]. Qed.
End reach_interval.

Module reach_interval_basis.
Import Bezier.Part_Bounds.reach_interval_basis.
Theorem proved : statement.
Proof. cbv delta [statement]; intros r s y A B C D; assert (P : 0 < (s - r) ^ 2) by nra; split; [ apply Rmult_le_pos; [ nra | left; apply Rinv_0_lt_compat, P ] | apply Rmult_le_reg_r with ((s - r) ^ 2); [ exact P | unfold Rdiv; rewrite Rmult_assoc, Rinv_l by exact D; pose proof (pow2_ge_0 (2 * y - r - s)); nra ] ]. Qed.
Theorem met : instance.
Proof. exists 0, 2, 1; repeat split; lra. Qed.
End reach_interval_basis.
