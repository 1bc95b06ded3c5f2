(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Symmetry.
Open Scope R_scope.

Module uniform_symmetry.
Import Splines.Part_Symmetry.uniform_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (0)%Z, (1 / 3); met) | (exists (0)%Z, (1 / 2); met) | (exists (0)%Z, (1 / 3); met) | (exists (0)%Z, (1 / 3); met) | (exists (0)%Z, (1 / 3); met)]. Qed.
End uniform_symmetry.
