(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Spiral.
Import Hyperbolic.Part_Spiral.Definitions.
Open Scope R_scope.

Module cone_slope.
Import Hyperbolic.Part_Spiral.cone_slope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement L]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance L]; first [(exists (1), (3), (4); met) | (exists (1), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (0); met)]. Qed.
End cone_slope.

Module cone_torsion.
Import Hyperbolic.Part_Spiral.cone_torsion.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement L]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance L]; first [(exists (1), (3), (4); met) | (exists (1), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (0); met)]. Qed.
End cone_torsion.

Module cone_torse.
Import Hyperbolic.Part_Spiral.cone_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement L]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance L]; first [(exists (1), (3), (4); met) | (exists (1), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (0); met)]. Qed.
End cone_torse.
