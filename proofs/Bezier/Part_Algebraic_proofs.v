(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Algebraic.
Open Scope R_scope.

Module reach_root.
Import Bezier.Part_Algebraic.reach_root.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), (1); met) | (exists (0), (0), (1); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (0), (1); met)]. Qed.
End reach_root.

Module reach_square.
Import Bezier.Part_Algebraic.reach_square.
Theorem proved : statement.
Proof. cbv delta [statement]; intros w P H; replace (w ^ 4) with (w ^ 2 * w ^ 2) by ring; rewrite H; field. Qed.
Theorem met : instance.
Proof. exists (sqrt (1 / 2)); split; [ apply sqrt_lt_R0; lra | apply square_root; lra ]. Qed.
End reach_square.
