(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Lists.
Import Bezier.Part_Lists.Definitions.
Open Scope R_scope.

Module list_unity.
Import Bezier.Part_Lists.list_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (2), (1 / 3); met) | (exists (0), (1 / 2); met) | (exists (13), (1 / 3); met) | (exists (1), (1 / 3); met) | (exists (1), (1 / 3); met)]. Qed.
End list_unity.

Module list_nonnegative.
Import Bezier.Part_Lists.list_nonnegative.
Theorem proved : statement.
Proof. cbv beta delta [statement T]; intros v x V X; compute_goal; assert (0 <= 1 + v * x) by nra; assert (0 <= 1 + v * (1 - x)) by nra; refine (conj _ (conj _ _)); apply Rle_ge; [ repeat apply Rmult_le_pos; lra | match goal with |- 0 <= ?t => replace t with (x * (1 - x) * (2 - v)) by ring end; repeat apply Rmult_le_pos; lra | repeat apply Rmult_le_pos; lra ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 0, 0; lra. Qed.
End list_nonnegative.

Module list_nonnegative_slip.
Import Bezier.Part_Lists.list_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T] in no; refuting (no (3) (1/2)). Qed.
End list_nonnegative_slip.
