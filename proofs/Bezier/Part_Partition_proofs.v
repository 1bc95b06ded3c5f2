(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Partition.
Open Scope R_scope.

Module bernstein_unity.
Import Bezier.Part_Partition.bernstein_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 2); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met)]. Qed.
End bernstein_unity.

Module trigonometric_unity.
Import Bezier.Part_Partition.trigonometric_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1) / 2), ((-1) / 2), (1 / 2); met) | (exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1)), ((-1)), (1 / 3); met)]. Qed.
End trigonometric_unity.
