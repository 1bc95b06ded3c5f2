(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Torses Require Part_Curves.
Open Scope R_scope.

Module curve_chain.
Import Torses.Part_Curves.curve_chain.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End curve_chain.

Module curve_chain_slip.
Import Torses.Part_Curves.curve_chain_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1) (0) (0) (0) (1) (0) 0 0 0 (1) (2) (0) (0)). Qed.
End curve_chain_slip.

Module curve_curvature.
Import Torses.Part_Curves.curve_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12), (13), (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11), (1), (4); met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2, (1), (1), (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), (0), (0), (0); met)]. Qed.
End curve_curvature.

Module curve_straight.
Import Torses.Part_Curves.curve_straight.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7; met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1; met)]. Qed.
End curve_straight.
