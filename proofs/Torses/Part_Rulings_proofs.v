(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Rulings.
Import Torses.Part_Rulings.Definitions.
Open Scope R_scope.

Module planes_ruling.
Import Torses.Part_Rulings.planes_ruling.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End planes_ruling.

Module planes_turn.
Import Torses.Part_Rulings.planes_turn.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_turn.

Module planes_turn_slip.
Import Torses.Part_Rulings.planes_turn_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement W] in no; refuting (no (0) (0) (1) (0) (1) (0) (1) (0) (0) (0)). Qed.
End planes_turn_slip.

Module planes_turn_slip_corrected.
Import Torses.Part_Rulings.planes_turn_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_turn_slip_corrected.

Module planes_cylinder.
Import Torses.Part_Rulings.planes_cylinder.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2); met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1); met)]. Qed.
End planes_cylinder.

Module planes_scaled.
Import Torses.Part_Rulings.planes_scaled.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_scaled.

Module planes_scaled_slip.
Import Torses.Part_Rulings.planes_scaled_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement W] in no; refuting (no (0) (0) (2) (0) (0) (1) (0) (1) (0) (1) (0) (0) (0)). Qed.
End planes_scaled_slip.

Module planes_scaled_slip_corrected.
Import Torses.Part_Rulings.planes_scaled_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_scaled_slip_corrected.

Module planes_dual.
Import Torses.Part_Rulings.planes_dual.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta X]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta X]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), (15); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), (13); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1), (0); met)]. Qed.
End planes_dual.
