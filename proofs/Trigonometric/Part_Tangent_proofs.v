(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Trigonometric Require Part_Tangent.
Import Trigonometric.Part_Tangent.Definitions.
Open Scope R_scope.

Module helix_torse.
Import Trigonometric.Part_Tangent.helix_torse.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helix_torse.

Module helix_normal.
Import Trigonometric.Part_Tangent.helix_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists (1), (1), (4), (5); met) | (exists (1), (1), (0), (0); met) | (exists (13), (8), (8), (6); met) | (exists (1), (1), (1), (1); met) | (exists (1), (1), (1), (0); met)]. Qed.
End helix_normal.
