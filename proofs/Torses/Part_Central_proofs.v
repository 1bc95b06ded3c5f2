(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Central.
Import Torses.Part_Central.Definitions.
From Torses Require Import Part_Central_closed.
Open Scope R_scope.

Module striction_shortest.
Import Torses.Part_Central.striction_shortest.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage s; stage X; stage X_; staged_goal N_; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1); met)]. Qed.
End striction_shortest.

Module striction_growth.
Import Torses.Part_Central.striction_growth.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros c1 c2 c3 x y z p1 p2 p3 r1 r2 r3 u v; assert (E : forall t, N_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] u t = cross [c1 + t * p1; c2 + t * p2; c3 + t * p3] [r1; r2; r3]) by (intro t; cbv beta delta [N_ X X_]; compute_goal; parts; derivatives; ring); rewrite (Derive_n_ext _ (fun t => dot (cross [c1 + (v + t) * p1; c2 + (v + t) * p2; c3 + (v + t) * p3] [r1; r2; r3]) (cross [c1 + (v + t) * p1; c2 + (v + t) * p2; c3 + (v + t) * p3] [r1; r2; r3]))) by (intro; rewrite E; reflexivity); clear E; compute_goal; derivatives; apply Rle_ge, Rle_trans with (2 * ((p2 * r3 - p3 * r2) ^ 2 + (p3 * r1 - p1 * r3) ^ 2 + (p1 * r2 - p2 * r1) ^ 2)); [ repeat apply Rmult_le_pos; try apply Rplus_le_le_0_compat; try apply Rplus_le_le_0_compat; try apply pow2_ge_0; lra | right; ring ]. Qed.
End striction_growth.

Module striction_length.
Import Torses.Part_Central.striction_length.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage s; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s X X_ N_ delta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1); met)]. Qed.
End striction_length.

Module striction_scaled.
Import Torses.Part_Central.striction_scaled.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement s]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, (13); met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, (1); met) | (exists (1), (1), 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0); met)]. Qed.
End striction_scaled.

Module striction_unit.
Import Torses.Part_Central.striction_unit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S1]; lists; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u H P N; apply locally_singleton in N; cbv beta in N; assert (F : ex_derive (fun t => s1 [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] t) 0) by (cbv beta delta [s1]; compute_goal; auto_derive; intro Z; apply N; eapply eq_trans; [ | exact Z ]; ring); rewrite !(rate_along (fun t => s1 [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] t)) by exact F; match goal with |- context [Derive ?f 0] => generalize (Derive f 0) end; clear F; intro D; cbv beta delta [s1]; compute_goal; unfold fold_right in *; transitivity (D * (r1 * p1 + (r2 * p2 + (r3 * p3 + 0)))); [ field; intro Z; apply N; eapply eq_trans; [ | exact Z ]; ring | cbn in H; rewrite H; ring ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat split; [ ring | lra | apply filter_forall; intro; lra ]. Qed.
End striction_unit.

Module striction_unit_slip.
Import Torses.Part_Central.striction_unit_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement s1 S1] in no; refuting (no (0) (0) (0) (0) (0) (1) 0 0 0 (1) (0) (1) (0) (0) (2) (0) (1) (1) (0)). Qed.
End striction_unit_slip.
