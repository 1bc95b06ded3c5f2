(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Rectifying.
Open Scope R_scope.

Module rectifying_contains.
Import Torses.Part_Rectifying.rectifying_contains.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement H]; identity. Qed.
End rectifying_contains.

Module rectifying_geodesic.
Import Torses.Part_Rectifying.rectifying_geodesic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement H]; identity. Qed.
End rectifying_geodesic.
