(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Edge.
Import Torses.Part_Edge.Definitions.
From Torses Require Import Part_Edge_closed.
Open Scope R_scope.

Module regression_singular.
Import Torses.Part_Edge.regression_singular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage delta; stage s; stage X; stage X_; staged_goal N_; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta s X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1); met)]. Qed.
End regression_singular.

Module regression_tangent.
Import Torses.Part_Edge.regression_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u H P N; apply locally_singleton in N; cbv beta in N; assert (B : dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]) <> 0) by lra; clear P; assert (F : ex_derive (fun t => s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] [r1; r2; r3] t) 0) by (cbv beta delta [s]; revert N; compute_goal; intro N; auto_derive; intro Z; apply N; eapply eq_trans; [ | exact Z ]; ring); assert (S0 : s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] [r1; r2; r3] 0 = - dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]) / dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3])) by (cbv beta delta [s]; unfold Rdiv; apply f_equal2; [ | apply f_equal ]; compute_goal; ring); lists; rewrite !(rate_along (fun t => s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] [r1; r2; r3] t)) by exact F; match goal with |- context [Derive ?f 0] => generalize (Derive f 0) end; cbv beta; clear F N; intro D; rewrite ?S0; clear S0; revert B H; cbv beta delta [delta]; compute_goal; intros B H; parts; match type of B with ?bb <> 0 => match type of H with ?d = 0 => let by_entry e := (transitivity (- d * e / bb); [ field; intro Z; apply B; rewrite ?Rplus_0_r; exact Z | rewrite H; unfold Rdiv; ring ]) in first [ reflexivity | by_entry ((p3 * r1 - p1 * r3) * r3 - (p1 * r2 - p2 * r1) * r2) | by_entry ((p1 * r2 - p2 * r1) * r1 - (p2 * r3 - p3 * r2) * r3) | by_entry ((p2 * r3 - p3 * r2) * r2 - (p3 * r1 - p1 * r3) * r1) ] end end. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0; compute_goal; repeat split; [ ring | lra | apply filter_forall; intro; nra ]. Qed.
End regression_tangent.

Module regression_tangent_slip.
Import Torses.Part_Edge.regression_tangent_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement s S_] in no; refuting (no 0 0 0 (0) (0) (1) 0 0 0 0 0 0 (0) (1) (0) (1) (1) (0) (0)). Qed.
End regression_tangent_slip.

Module planes_edge.
Import Torses.Part_Edge.planes_edge.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W edge]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W edge]; first [(exists (2), (3), (4), 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), 15, 16, 17; met) | (exists (0), (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists (13), (8), (8), 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), 13, 8, 8; met) | (exists (1), (1), (1), 7, 9, 7, 7, 9, 7, 7, 9, 7, (1), 8, 6, 8; met) | (exists (1), (0), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0), 1, 0, 0; met)]. Qed.
End planes_edge.

Module planes_edge_in.
Import Torses.Part_Edge.planes_edge_in.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W edge]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W edge]; first [(exists (2), (3), (4), 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists (0), (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), (8), 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists (1), (1), (1), 7, 9, 7, 7, 9, 7, 7, 9, 7, (1); met) | (exists (1), (0), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0); met)]. Qed.
End planes_edge_in.

Module planes_edge_tangent.
Import Torses.Part_Edge.planes_edge_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W W_ edge]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W W_ edge]; first [(exists (2), (3), (4), (5), 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, (18); met) | (exists (0), (0), (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), (8), (6), 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, (6); met) | (exists (1), (1), (1), (1), 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, (1); met) | (exists (1), (0), (0), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (0); met)]. Qed.
End planes_edge_tangent.

Module planes_edge_osculating.
Import Torses.Part_Edge.planes_edge_osculating.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W W_ edge]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W W_ edge]; first [(exists (2), (3), (4), (5), (6), 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, (22); met) | (exists (0), (0), (0), (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), (8), (6), (8), 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, (7); met) | (exists (1), (1), (1), (1), (1), 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, 7, 9, 7, (1); met) | (exists (1), (0), (0), (0), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, (0); met)]. Qed.
End planes_edge_osculating.
