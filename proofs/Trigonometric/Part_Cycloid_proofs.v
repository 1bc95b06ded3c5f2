(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Trigonometric Require Part_Cycloid.
Import Trigonometric.Part_Cycloid.Definitions.
Open Scope R_scope.

Module cycloid_speed.
Import Trigonometric.Part_Cycloid.cycloid_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_speed.

Module cycloid_slope.
Import Trigonometric.Part_Cycloid.cycloid_slope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_slope.

Module cycloid_slope_slip.
Import Trigonometric.Part_Cycloid.cycloid_slope_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X] in no; refuting (no (1/3*PI)). Qed.
End cycloid_slope_slip.

Module cycloid_slope_slip_corrected.
Import Trigonometric.Part_Cycloid.cycloid_slope_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_slope_slip_corrected.

Module cycloid_curvature.
Import Trigonometric.Part_Cycloid.cycloid_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_curvature.
