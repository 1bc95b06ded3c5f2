(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Circles.
Open Scope R_scope.

Module quadratic_circle.
Import Trigonometric.Part_Circles.quadratic_circle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b]; first [(exists ((1 / 6) * PI); met) | (exists ((1 / 4) * PI); met) | (exists ((1 / 6) * PI); met) | (exists ((1 / 6) * PI); met) | (exists ((1 / 6) * PI); met)]. Qed.
End quadratic_circle.
