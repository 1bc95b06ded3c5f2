(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_1.
Open Scope R_scope.

Module sec_1_parallel_tangents.
Import HermiteDevelopable.Section_1.sec_1_parallel_tangents.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement dp dq ruling]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance dp dq ruling]; first [(exists (2), (3), (4), (5), (6), (7), (8); met) | (exists (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9); met) | (exists (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_1_parallel_tangents.
