(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Torses Require Part_Distribution.
Import Torses.Part_Distribution.Definitions.
Open Scope R_scope.

Module striction_parameter.
Import Torses.Part_Distribution.striction_parameter.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta p]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta p]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, (13); met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, (1); met) | (exists (1), (1), 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0); met)]. Qed.
End striction_parameter.
