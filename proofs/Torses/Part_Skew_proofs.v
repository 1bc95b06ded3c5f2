(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Skew.
Open Scope R_scope.

Module binormals_skew.
Import Torses.Part_Skew.binormals_skew.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2); met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1); met)]. Qed.
End binormals_skew.

Module conoid_skew.
Import Torses.Part_Skew.conoid_skew.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End conoid_skew.
