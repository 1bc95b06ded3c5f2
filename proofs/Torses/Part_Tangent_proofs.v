(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Tangent.
Import Torses.Part_Tangent.Definitions.
From Torses Require Import Part_Tangent_closed.
Open Scope R_scope.

Module tangents_torse.
Import Torses.Part_Tangent.tangents_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End tangents_torse.

Module tangents_normal.
Import Torses.Part_Tangent.tangents_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage T; stage T_; staged_goal NT; identity. Qed.
End tangents_normal.

Module tangents_edge.
Import Torses.Part_Tangent.tangents_edge.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage T; stage T_; staged_goal NT; identity. Qed.
End tangents_edge.

Module tangents_osculating.
Import Torses.Part_Tangent.tangents_osculating.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage T; stage T_; staged_goal NT; identity. Qed.
End tangents_osculating.

Module tangents_metric.
Import Torses.Part_Tangent.tangents_metric.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11); met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2, (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), (0); met)]. Qed.
End tangents_metric.

Module tangents_metric_slip.
Import Torses.Part_Tangent.tangents_metric_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T] in no; refuting (no (0) (0) (1) (1) (0) (1) 0 0 0 (0) (1)). Qed.
End tangents_metric_slip.
