(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Cardioid.
Import Trigonometric.Part_Cardioid.Definitions.
Open Scope R_scope.

Module cardioid_speed.
Import Trigonometric.Part_Cardioid.cardioid_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cardioid_speed.

Module cardioid_cusp.
Import Trigonometric.Part_Cardioid.cardioid_cusp.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End cardioid_cusp.

Module cardioid_curvature.
Import Trigonometric.Part_Cardioid.cardioid_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End cardioid_curvature.
