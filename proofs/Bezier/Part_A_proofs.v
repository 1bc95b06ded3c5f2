(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_A.
Open Scope R_scope.

Module trigonometric_circle.
Import Bezier.Part_A.trigonometric_circle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T Q]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T Q]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End trigonometric_circle.
