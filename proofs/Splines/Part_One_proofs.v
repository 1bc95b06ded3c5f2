(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_One.
Open Scope R_scope.

Module clamped_bernstein.
Import Splines.Part_One.clamped_bernstein.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; apart; identity. Qed.
End clamped_bernstein.
