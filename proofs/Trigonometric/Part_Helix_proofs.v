(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Helix.
Import Trigonometric.Part_Helix.Definitions.
Open Scope R_scope.

Module helix_speed.
Import Trigonometric.Part_Helix.helix_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helix_speed.

Module helix_torsion.
Import Trigonometric.Part_Helix.helix_torsion.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helix_torsion.

Module helix_curvature.
Import Trigonometric.Part_Helix.helix_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helix_curvature.
