(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Catenary.
Import Hyperbolic.Part_Catenary.Definitions.
Open Scope R_scope.

Module catenary_speed.
Import Hyperbolic.Part_Catenary.catenary_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End catenary_speed.

Module catenary_length.
Import Hyperbolic.Part_Catenary.catenary_length.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End catenary_length.

Module catenary_curvature.
Import Hyperbolic.Part_Catenary.catenary_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End catenary_curvature.

Module catenary_curvature_slip.
Import Hyperbolic.Part_Catenary.catenary_curvature_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement K] in no; refuting (no (1)). Qed.
End catenary_curvature_slip.

Module catenary_curvature_slip_corrected.
Import Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End catenary_curvature_slip_corrected.

Module catenary_load.
Import Hyperbolic.Part_Catenary.catenary_load.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End catenary_load.
