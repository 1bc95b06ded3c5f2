(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Tangent.
Import Trigonometric.Part_Tangent.Definitions.
Open Scope R_scope.

Module helix_torse.
Import Trigonometric.Part_Tangent.helix_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helix_torse.

Module helix_normal.
Import Trigonometric.Part_Tangent.helix_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4), (5); met) | (exists (1), (1), (0), (0); met) | (exists (13), (8), (8), (6); met) | (exists (1), (1), (1), (1); met) | (exists (1), (1), (1), (0); met)]. Qed.
End helix_normal.

Module helix_regular.
Import Trigonometric.Part_Tangent.helix_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; compute_goal; intros h r t H A; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; apply Rlt_gt, Rlt_le_trans with (r * r * (h * h + r * r)); [ repeat apply Rmult_lt_0_compat; nra | right; ring [F] ]. Qed.
Theorem met : instance.
Proof. exists 1, 1, 0; lra. Qed.
End helix_regular.
