(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Polar.
Open Scope R_scope.

Module polar_first.
Import Torses.Part_Polar.polar_first.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End polar_first.

Module polar_second.
Import Torses.Part_Polar.polar_second.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End polar_second.

Module polar_second_slip.
Import Torses.Part_Polar.polar_second_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (0) (0) (0) (0) (1) (1) (0) (1) (1) (0) (0) (0) (1) (0) (0)). Qed.
End polar_second_slip.

Module polar_second_slip_corrected.
Import Torses.Part_Polar.polar_second_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End polar_second_slip_corrected.
