(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Trigonometric Require Part_Parts.
Open Scope R_scope.

Module angle_rate.
Import Trigonometric.Part_Parts.angle_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End angle_rate.
