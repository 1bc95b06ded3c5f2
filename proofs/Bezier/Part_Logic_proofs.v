(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Logic.
Open Scope R_scope.

Module reach_implies.
Import Bezier.Part_Logic.reach_implies.
Theorem proved : statement.
Proof. cbv delta [statement]; intros a b H; split; nra. Qed.
End reach_implies.

Module reach_length_zero.
Import Bezier.Part_Logic.reach_length_zero.
Theorem proved : statement.
Proof. cbv delta [statement]; intros a b c p H; compute_in H; subst p; replace a with 0 by nra; replace b with 0 by nra; replace c with 0 by nra; reflexivity. Qed.
End reach_length_zero.

Module reach_product_zero.
Import Bezier.Part_Logic.reach_product_zero.
Theorem proved : statement.
Proof. cbv delta [statement]; intros a b; split; [ apply Rmult_integral | intros [-> | ->]; ring ]. Qed.
End reach_product_zero.

Module reach_roots.
Import Bezier.Part_Logic.reach_roots.
Theorem proved : statement.
Proof. cbv delta [statement]; intros y H; destruct (Rmult_integral (y - 2) (y + 2)) as [E | E]; [ lra | left; lra | right; lra ]. Qed.
End reach_roots.

Module reach_roots_slip.
Import Bezier.Part_Logic.reach_roots_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (-2)). Qed.
End reach_roots_slip.

Module reach_weights_zero.
Import Bezier.Part_Logic.reach_weights_zero.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1), (1), (1); met) | (exists (0), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End reach_weights_zero.

Module reach_circle_bound.
Import Bezier.Part_Logic.reach_circle_bound.
Theorem proved : statement.
Proof. cbv delta [statement]; intros a b H; pose proof (pow2_ge_0 (a - b)); nra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (0); met)]. Qed.
End reach_circle_bound.
