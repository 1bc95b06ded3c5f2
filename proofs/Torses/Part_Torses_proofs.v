(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Torses.
Import Torses.Part_Torses.Definitions.
From Torses Require Import Part_Torses_closed.
Open Scope R_scope.

Module ruled_torse_sufficient.
Import Torses.Part_Torses.ruled_torse_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage delta; stage X; stage X_; staged_goal N_; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), (15), (16); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), (13), (8); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1), (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1), (0), (0); met)]. Qed.
End ruled_torse_sufficient.

Module ruled_torse_necessary.
Import Torses.Part_Torses.ruled_torse_necessary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X X_ N_ delta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), (15), (16); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), (13), (8); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1), (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1), (0), (0); met)]. Qed.
End ruled_torse_necessary.

Module ruled_rodrigues.
Import Torses.Part_Torses.ruled_rodrigues.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
End ruled_rodrigues.
