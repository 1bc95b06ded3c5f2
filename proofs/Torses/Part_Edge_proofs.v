(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
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
