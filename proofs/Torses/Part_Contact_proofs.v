(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Contact.
Open Scope R_scope.

Module ruled_touch.
Import Torses.Part_Contact.ruled_touch.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; staged_goal N_; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, (26), (27); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, (1), (4); met) | (exists 9, 7, 7, 9, 7, 7, 7, 7, 2, 7, 7, 2, 7, 2, 11, 7, 2, 11, 2, 11, 1, 2, 11, 1, (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, (1), (0); met)]. Qed.
End ruled_touch.
