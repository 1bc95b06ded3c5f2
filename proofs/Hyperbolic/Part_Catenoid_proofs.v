(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Catenoid.
Import Hyperbolic.Part_Catenoid.Definitions.
Open Scope R_scope.

Module catenoid_conformal.
Import Hyperbolic.Part_Catenoid.catenoid_conformal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_conformal.

Module catenoid_minimal.
Import Hyperbolic.Part_Catenoid.catenoid_minimal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_minimal.

Module catenoid_gauss.
Import Hyperbolic.Part_Catenoid.catenoid_gauss.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_gauss.
