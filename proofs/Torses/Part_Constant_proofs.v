(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Constant.
Open Scope R_scope.

Module slope_torse.
Import Torses.Part_Constant.slope_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement R_ R__]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance R_ R__]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End slope_torse.
