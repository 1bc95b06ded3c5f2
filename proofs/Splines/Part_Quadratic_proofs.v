(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Quadratic.
Open Scope R_scope.

Module uniform_quadratic.
Import Splines.Part_Quadratic.uniform_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_quadratic.
