(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtDevelopable Require Section_4_1.
Import GbtDevelopable.Section_4_1.Definitions.
Open Scope R_scope.

Module ex_4_1_Q0.
Import GbtDevelopable.Section_4_1.ex_4_1_Q0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E1_0 E1_1 E1_2 E1_3 E1]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q0.

Module ex_4_1_Q1.
Import GbtDevelopable.Section_4_1.ex_4_1_Q1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q1.

Module ex_4_1_Q2.
Import GbtDevelopable.Section_4_1.ex_4_1_Q2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q2.

Module ex_4_1_Q3.
Import GbtDevelopable.Section_4_1.ex_4_1_Q3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q3.

Module ex_4_1_distance.
Import GbtDevelopable.Section_4_1.ex_4_1_distance.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 normal E1_1 E1_2 E1_3 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E1_0 normal E1_1 E1_2 E1_3 distance2]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_1_distance.

Module ex_4_1_coplanar.
Import GbtDevelopable.Section_4_1.ex_4_1_coplanar.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 E1_1 E1_2 E1_3 normal midpoint volume]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E1_0 E1_1 E1_2 E1_3 normal midpoint volume]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_1_coplanar.

Module ex_4_1_lengths.
Import GbtDevelopable.Section_4_1.ex_4_1_lengths.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_lengths.

Module ex_4_1_c1_c.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_c.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (1)). Qed.
End ex_4_1_c1_c.

Module ex_4_1_c1_e.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_e.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_1_c1_e.

Module ex_4_1_c1_f_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_f_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ E1__ E1___ normal direction length2 len len_] in no; refuting (no (1) (0)). Qed.
End ex_4_1_c1_f_there_and_nowhere_else.

Module ex_4_1_c2_d.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_d.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_1_c2_d.

Module ex_4_1_c2_e_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_e_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ E1__ E1___ normal direction length2 len len_] in no; refuting (no (0) (1)). Qed.
End ex_4_1_c2_e_there_and_nowhere_else.

Module ex_4_2_Q0.
Import GbtDevelopable.Section_4_1.ex_4_2_Q0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q0.

Module ex_4_2_Q1.
Import GbtDevelopable.Section_4_1.ex_4_2_Q1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q1.

Module ex_4_2_Q2.
Import GbtDevelopable.Section_4_1.ex_4_2_Q2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q2.

Module ex_4_2_Q3.
Import GbtDevelopable.Section_4_1.ex_4_2_Q3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q3.

Module ex_4_2_pencil.
Import GbtDevelopable.Section_4_1.ex_4_2_pencil.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2 normal]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2 normal]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3), (5); met) | (exists (0), (0), (1 / 2), (0); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (6); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1); met)]. Qed.
End ex_4_2_pencil.

Module ex_4_2_lengths.
Import GbtDevelopable.Section_4_1.ex_4_2_lengths.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2]; at_points. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2 E2_ normal direction length2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_lengths.

Module ex_4_2_c1_d.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_d.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2] in no; refuting (no (1) (0)). Qed.
End ex_4_2_c1_d.

Module ex_4_2_c1_e.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_e.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_2_c1_e.
