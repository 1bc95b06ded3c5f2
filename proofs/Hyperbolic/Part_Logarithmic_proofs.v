(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Logarithmic.
Import Hyperbolic.Part_Logarithmic.Definitions.
Open Scope R_scope.

Module spiral_angle.
Import Hyperbolic.Part_Logarithmic.spiral_angle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
End spiral_angle.

Module spiral_regular.
Import Hyperbolic.Part_Logarithmic.spiral_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; ordered. Qed.
End spiral_regular.

Module spiral_curvature.
Import Hyperbolic.Part_Logarithmic.spiral_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance S_]; first [(exists (2), (3); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (0); met)]. Qed.
End spiral_curvature.
