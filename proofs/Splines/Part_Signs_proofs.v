(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Signs.
Import Splines.Part_Signs.Definitions.
Open Scope R_scope.

Module uniform_nonnegative.
Import Splines.Part_Signs.uniform_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; intros i s I S; assert (J : (i = 0 \/ i = 1 \/ i = 2 \/ i = 3)%Z) by lia; assert (0 <= s * s * (2 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * (1 + s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * s * s) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * (1 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * s * (1 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * s) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra); destruct J as [J|[J|[J|J]]]; subst i; compute_goal; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0%Z, 0; split; [ lia | lra ]. Qed.
End uniform_nonnegative.

Module uniform_bound.
Import Splines.Part_Signs.uniform_bound.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; intros i s I S; assert (J : (i = 0 \/ i = 1 \/ i = 2 \/ i = 3)%Z) by lia; assert (0 <= s * s * (2 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * (1 + s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * s * s) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * (1 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * s * (1 - s)) by (repeat apply Rmult_le_pos; lra); assert (0 <= (1 - s) * (1 - s) * s) by (repeat apply Rmult_le_pos; lra); assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra); destruct J as [J|[J|[J|J]]]; subst i; compute_goal; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0%Z, 0; split; [ lia | lra ]. Qed.
End uniform_bound.

Module uniform_bound_slip.
Import Splines.Part_Signs.uniform_bound_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U] in no; refuting (no ((1))%Z (0)). Qed.
End uniform_bound_slip.

Module knots_nonnegative_ends.
Import Splines.Part_Signs.knots_nonnegative_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; compute_goal; intros; split; apply Rle_ge; repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos | |- 0 <= _ / _ => apply Rmult_le_pos | |- 0 <= / _ => left; apply Rinv_0_lt_compat end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists IZR, 2; conjuncts; lra. Qed.
End knots_nonnegative_ends.

Module knots_nonnegative_middle.
Import Splines.Part_Signs.knots_nonnegative_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; compute_goal; intros; apply Rlt_gt; rewrite ?Rplus_0_l, ?Rplus_0_r, ?Rmult_1_r; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; apply Rdiv_lt_0_compat; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, (1 / 2), (1 / 2), IZR, 1, (5 / 2); conjuncts; lra. Qed.
End knots_nonnegative_middle.

Module knots_nonnegative_outside.
Import Splines.Part_Signs.knots_nonnegative_outside.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement N_] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (2) else if (Z.eqb i0 (3))%bool then (3) else if (Z.eqb i0 (4))%bool then (5) else 0) (1)). Qed.
End knots_nonnegative_outside.

Module knots_nonnegative_cubic.
Import Splines.Part_Signs.knots_nonnegative_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; compute_goal; intros; split; apply Rle_ge; repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos | |- 0 <= _ / _ => apply Rmult_le_pos | |- 0 <= / _ => left; apply Rinv_0_lt_compat end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists IZR, 3; conjuncts; lra. Qed.
End knots_nonnegative_cubic.
