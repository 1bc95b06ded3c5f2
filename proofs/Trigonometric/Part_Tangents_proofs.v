(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Tangents.
Open Scope R_scope.

Module angle_tangent.
Import Trigonometric.Part_Tangents.angle_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (((-1) / 3) * PI); met) | (exists (0 * PI); met) | (exists (((-1) / 3) * PI); met) | (exists (((-1) / 3) * PI); met) | (exists (((-1) / 3) * PI); met)]. Qed.
End angle_tangent.

Module angle_tangent_closed.
Import Trigonometric.Part_Tangents.angle_tangent_closed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (((-1) / 3) * PI); met) | (exists (0 * PI); met) | (exists (((-1) / 3) * PI); met) | (exists (((-1) / 3) * PI); met) | (exists (((-1) / 3) * PI); met)]. Qed.
End angle_tangent_closed.
