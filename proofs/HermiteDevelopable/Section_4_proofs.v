(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From HermiteDevelopable Require Section_4.
Import HermiteDevelopable.Section_4.Definitions.
Open Scope R_scope.

Module eq_4_1.
Import HermiteDevelopable.Section_4.eq_4_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement oblique oblique_ normal]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance oblique oblique_ normal]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (1 / 3), (12); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (1 / 3), (11); met) | (exists 7, 9, 7, 7, 2, 11, 7, 2, 11, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End eq_4_1.

Module eq_4_2_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord image r0u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (1) (1) (0)). Qed.
End eq_4_2_tangent_derivative.

Module eq_4_2_tangent_end_point.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image r0 r0u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image r0 r0u]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_end_point.

Module eq_4_2_tangent_parallel.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord r0u image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord r0u image]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_parallel.

Module eq_4_4_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord last image r ru r1 r1u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (0) (1) (1) (1) (0) (1) (0) (2) (0) (1) (1) (0)). Qed.
End eq_4_4_tangent_derivative.

Module ex_4_r0.
Import HermiteDevelopable.Section_4.ex_4_r0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o a d normal image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o a d normal image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r0.

Module ex_4_r0u.
Import HermiteDevelopable.Section_4.ex_4_r0u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q0 o q0u a d normal r0u] in no; refuting (no ). Qed.
End ex_4_r0u.

Module ex_4_r.
Import HermiteDevelopable.Section_4.ex_4_r.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement qm o a d normal q0 image r]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance qm o a d normal q0 image r]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r.

Module ex_4_ru.
Import HermiteDevelopable.Section_4.ex_4_ru.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement qm o qu a d normal q0 image r ru] in no; refuting (no ). Qed.
End ex_4_ru.

Module ex_4_r1.
Import HermiteDevelopable.Section_4.ex_4_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1.

Module ex_4_r1_rounding.
Import HermiteDevelopable.Section_4.ex_4_r1_rounding.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1_rounding.

Module ex_4_r1u.
Import HermiteDevelopable.Section_4.ex_4_r1u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q1 o q1u a d normal q0 image r1 r1u] in no; refuting (no ). Qed.
End ex_4_r1u.

Module ex_4_other_data.
Import HermiteDevelopable.Section_4.ex_4_other_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_other_data.

Module ex_4_stated_data.
Import HermiteDevelopable.Section_4.ex_4_stated_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_stated_data.

Module ex_4_true_tangents.
Import HermiteDevelopable.Section_4.ex_4_true_tangents.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 q0u first o a d normal qm qu middle q1 q1u last image]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 q0u first o a d normal qm qu middle q1 q1u last image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_true_tangents.
