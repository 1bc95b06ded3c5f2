(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Cylinders.
Import Torses.Part_Cylinders.Definitions.
Open Scope R_scope.

Module cylinder_torse.
Import Torses.Part_Cylinders.cylinder_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2); met) | (exists 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1); met)]. Qed.
End cylinder_torse.

Module cylinder_normal.
Import Torses.Part_Cylinders.cylinder_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; staged_goal N_; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X X_ N_]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (14), (15), (16); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (4), (13), (8); met) | (exists 7, 7, 2, 7, 7, 2, 2, 11, 1, 2, 11, 1, (1), (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, (1), (0), (0); met)]. Qed.
End cylinder_normal.

Module cylinder_converse_slip.
Import Torses.Part_Cylinders.cylinder_converse_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement delta] in no; refuting (no (0) (0) (0) (0) (0) (1) (0) (1) (0) (0)). Qed.
End cylinder_converse_slip.
