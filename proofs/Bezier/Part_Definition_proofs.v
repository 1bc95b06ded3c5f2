(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Definition.
Open Scope R_scope.

Module bernstein_recursion.
Import Bezier.Part_Definition.bernstein_recursion.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 2); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met)]. Qed.
End bernstein_recursion.
