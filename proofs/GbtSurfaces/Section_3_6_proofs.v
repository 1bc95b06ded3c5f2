(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtSurfaces Require Section_3_6.
Open Scope R_scope.

Module eq_32_matrix.
Import GbtSurfaces.Section_3_6.eq_32_matrix.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement printed_] in no; refuting (no (1/3*PI) (1/2*PI)). Qed.
End eq_32_matrix.

Module eq_32_matrix_corrected.
Import GbtSurfaces.Section_3_6.eq_32_matrix_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1); met) | (exists (1); met)]. Qed.
End eq_32_matrix_corrected.

Module eq_32_components.
Import GbtSurfaces.Section_3_6.eq_32_components.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement printed_ f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance printed_ f FX FZ]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1), (8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1), (0), (1 / 3); met)]. Qed.
End eq_32_components.

Module sec_3_6_rounding_rational.
Import GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine]; first [(exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End sec_3_6_rounding_rational.

Module thm_6_symmetric.
Import GbtSurfaces.Section_3_6.thm_6_symmetric.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine T Tm]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine T Tm]; first [(exists (2), (3), (1 / 3); met) | (exists (0), (0), (1 / 3); met)]. Qed.
End thm_6_symmetric.

Module eq_34.
Import GbtSurfaces.Section_3_6.eq_34.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_34.

Module sec_3_6_other_axes.
Import GbtSurfaces.Section_3_6.sec_3_6_other_axes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle cosine sine aboutX aboutY at_angle_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine aboutX aboutY at_angle_]; first [(exists (1 / 3), (3), (4), (5); met) | (exists (1 / 3), (0), (0), (0); met)]. Qed.
End sec_3_6_other_axes.

Module prop_3_8_b_exact.
Import GbtSurfaces.Section_3_6.prop_3_8_b_exact.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine Tm cosine_ sine_ Tm_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine Tm cosine_ sine_ Tm_]; first [(exists (2), (3); met) | (exists (0), (0); met)]. Qed.
End prop_3_8_b_exact.

Module prop_3_9_a_one_segment.
Import GbtSurfaces.Section_3_6.prop_3_9_a_one_segment.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f FX] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) ((-1) / 3) ((-1) / 3)). Qed.
End prop_3_9_a_one_segment.

Module prop_3_9_b.
Import GbtSurfaces.Section_3_6.prop_3_9_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A f FX FZ]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (5), (6), (7), (8), (9), (10), (11), (12), (13), (14), ((-1) / 3), ((-1) / 3), 17, 18, 19, (20), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), ((-1) / 3), ((-1) / 3), 0, 0, 0, (0), (1 / 3); met)]. Qed.
End prop_3_9_b.

Module eq_35.
Import GbtSurfaces.Section_3_6.eq_35.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q36]; identity. Qed.
End eq_35.
