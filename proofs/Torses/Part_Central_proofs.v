(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Torses Require Part_Central.
Import Torses.Part_Central.Definitions.
From Torses Require Import Part_Central_closed.
Open Scope R_scope.

Module striction_shortest.
Import Torses.Part_Central.striction_shortest.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage s; stage X; stage X_; staged_goal N_; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1); met)]. Qed.
End striction_shortest.

Module striction_length.
Import Torses.Part_Central.striction_length.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage s; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s X X_ N_ delta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1); met)]. Qed.
End striction_length.

Module striction_scaled.
Import Torses.Part_Central.striction_scaled.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement s]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, (13); met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, (1); met) | (exists (1), (1), 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0); met)]. Qed.
End striction_scaled.

Module striction_unit_slip.
Import Torses.Part_Central.striction_unit_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement s1 S1] in no; refuting (no (0) (0) (0) (0) (0) (1) 0 0 0 (1) (0) (1) (0) (0) (2) (0) (1) (1) (0)). Qed.
End striction_unit_slip.
