(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_4.
Import GbtDevelopable.Section_4.Definitions.
Open Scope R_scope.

Module sec_4_midpoints.
Import GbtDevelopable.Section_4.sec_4_midpoints.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 normal E1_1 E1_2 E1_3 E2_0 E2_1 distance2 midpoint volume]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E1_0 normal E1_1 E1_2 E1_3 E2_0 E2_1 distance2 midpoint volume]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End sec_4_midpoints.

Module ex_4_2_distance.
Import GbtDevelopable.Section_4.ex_4_2_distance.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E2_0 normal E2_1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E2_0 normal E2_1 distance2]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_2_distance.

Module ex_4_2_coplanar.
Import GbtDevelopable.Section_4.ex_4_2_coplanar.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E2_0 E2_1 normal midpoint volume]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E2_0 E2_1 normal midpoint volume]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_2_coplanar.
