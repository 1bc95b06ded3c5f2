(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_4_2.
Import GbtDevelopable.Section_4_2.Definitions.
Open Scope R_scope.

Module sec_4_2_Q0.
Import GbtDevelopable.Section_4_2.sec_4_2_Q0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E3_0 E3_1 E3_2 E3_3 E3 normal midpoint]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E3_0 E3_1 E3_2 E3_3 E3 normal midpoint]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_4_2_Q0.

Module sec_4_2_Q1.
Import GbtDevelopable.Section_4_2.sec_4_2_Q1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E3_0 E3_1 E3_2 E3_3 E3 midpoint distance2]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E3_0 E3_1 E3_2 E3_3 E3 midpoint distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_4_2_Q1.

Module sec_4_2_Q1_lengths.
Import GbtDevelopable.Section_4_2.sec_4_2_Q1_lengths.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E3_0 E3_1 E3_2 E3_3 normal]; identity. Qed.
End sec_4_2_Q1_lengths.

Module sec_4_2_Q2.
Import GbtDevelopable.Section_4_2.sec_4_2_Q2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal E3_2 midpoint]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal E3_2 midpoint]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End sec_4_2_Q2.

Module sec_4_2_Q3.
Import GbtDevelopable.Section_4_2.sec_4_2_Q3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E3_0 E3_1 E3_2 E3_3 E3 normal midpoint]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E3_0 E3_1 E3_2 E3_3 E3 normal midpoint]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_4_2_Q3.

Module sec_4_2_quadrants.
Import GbtDevelopable.Section_4_2.sec_4_2_quadrants.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E3_0 normal E3_1 E3_2 E3_3 midpoint]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E3_0 normal E3_1 E3_2 E3_3 midpoint]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End sec_4_2_quadrants.

Module sec_4_2_distances.
Import GbtDevelopable.Section_4_2.sec_4_2_distances.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E3_0 normal E3_1 E3_2 E3_3 distance2]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E3_0 normal E3_1 E3_2 E3_3 distance2]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End sec_4_2_distances.
