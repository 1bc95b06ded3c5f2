(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Freedom.
Import Torses.Part_Freedom.Definitions.
Open Scope R_scope.

Module ruled_directrix.
Import Torses.Part_Freedom.ruled_directrix.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta]; identity. Qed.
End ruled_directrix.

Module ruled_scaled.
Import Torses.Part_Freedom.ruled_scaled.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta]; identity. Qed.
End ruled_scaled.

Module ruled_parameter.
Import Torses.Part_Freedom.ruled_parameter.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta]; identity. Qed.
End ruled_parameter.

Module ruled_parameter_slip.
Import Torses.Part_Freedom.ruled_parameter_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement delta] in no; refuting (no (0) (0) (1) 0 0 0 (2) (0) (0) (1) (0) (1) (0) (0) (0)). Qed.
End ruled_parameter_slip.

Module ruled_parameter_slip_corrected.
Import Torses.Part_Freedom.ruled_parameter_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta]; identity. Qed.
End ruled_parameter_slip_corrected.

Module ruled_ends.
Import Torses.Part_Freedom.ruled_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End ruled_ends.

Module ruled_start.
Import Torses.Part_Freedom.ruled_start.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End ruled_start.
