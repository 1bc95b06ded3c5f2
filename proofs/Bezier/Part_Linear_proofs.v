(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Linear.
Open Scope R_scope.

Module bernstein_precision.
Import Bezier.Part_Linear.bernstein_precision.
Theorem proved : statement.
Proof. cbv delta [statement B]; intros; apply linear_precision; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 2); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met)]. Qed.
End bernstein_precision.
