(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Cones.
Import Torses.Part_Cones.Definitions.
Open Scope R_scope.

Module cone_torse.
Import Torses.Part_Cones.cone_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End cone_torse.

Module cone_apex.
Import Torses.Part_Cones.cone_apex.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Y Y_]; identity. Qed.
End cone_apex.

Module cone_apex_slip.
Import Torses.Part_Cones.cone_apex_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement Y Y_] in no; refuting (no (0) (1) 0 0 0 (0) (0) (1) (0) (1) (0) (0)). Qed.
End cone_apex_slip.

Module planes_cone.
Import Torses.Part_Cones.planes_cone.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage W; stage dx; stage dx_; stage dx__; staged_goal ex; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W dx dx_ dx__ ex]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), 12, 13, 14; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), 11, 1, 4; met) | (exists 7, 9, 7, 7, 9, 7, 7, 9, 7, (1), 8, 6, 8; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), 1, 0, 0; met)]. Qed.
End planes_cone.
