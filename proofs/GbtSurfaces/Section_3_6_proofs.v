(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_6.
Import GbtSurfaces.Section_3_6.Definitions.
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
Proof. cbv beta zeta delta [instance]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End eq_32_matrix_corrected.

Module eq_32_components.
Import GbtSurfaces.Section_3_6.eq_32_components.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement printed_ f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance printed_ f FX FZ]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((2 / 3) * PI), (8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 * PI), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((2 / 3) * PI), (9), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((2 / 3) * PI), (1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((2 / 3) * PI), (1), (1 / 3); met)]. Qed.
End eq_32_components.

Module sec_3_6_rounding_rational.
Import GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End sec_3_6_rounding_rational.

Module sec_3_6_c1c2.
Import GbtSurfaces.Section_3_6.sec_3_6_c1c2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f line2X line2Z FX FZ jumpX jumpZ turned jump]; lists; intros; conjuncts; parts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f line2X line2Z FX FZ jumpX jumpZ turned jump]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (13); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (0); met)]. Qed.
End sec_3_6_c1c2.

Module eq_33_T.
Import GbtSurfaces.Section_3_6.eq_33_T.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle at_angle_ T cosine sine]; intros q w x Q N M A B; refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra | apply arc_range; assumption ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine T at_angle_]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End eq_33_T.

Module eq_33_Ttilde.
Import GbtSurfaces.Section_3_6.eq_33_Ttilde.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle at_angle_ Tm cosine sine]; intros q w x Q N M A B; refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra | apply arc_range; assumption ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine Tm at_angle_]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End eq_33_Ttilde.

Module eq_33_circle.
Import GbtSurfaces.Section_3_6.eq_33_circle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End eq_33_circle.

Module thm_6_symmetric.
Import GbtSurfaces.Section_3_6.thm_6_symmetric.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine T Tm]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine T Tm]; first [(exists (2), (3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists (13), (8), (1 / 3); met) | (exists (1), (1), (1 / 3); met) | (exists (1), (0), (1 / 3); met)]. Qed.
End thm_6_symmetric.

Module thm_6_complete.
Import GbtSurfaces.Section_3_6.thm_6_complete.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle T Tm cosine sine]; intros q w x Q N M L; refine (conj _ (conj _ _)); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity | rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity | destruct (arc_range q Q N); repeat split; try assumption; apply arc_rate; exact N ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine T Tm]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End thm_6_complete.

Module eq_34.
Import GbtSurfaces.Section_3_6.eq_34.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_34.

Module sec_3_6_other_axes.
Import GbtSurfaces.Section_3_6.sec_3_6_other_axes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle cosine sine aboutX aboutY at_angle_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine aboutX aboutY at_angle_]; first [(exists (1 / 3), (3), (4), (5); met) | (exists (1 / 2), (0), (0), (0); met) | (exists (1 / 3), (8), (8), (6); met) | (exists (1 / 3), (1), (1), (1); met) | (exists (1 / 3), (1), (0), (0); met)]. Qed.
End sec_3_6_other_axes.

Module prop_3_8_a_linear.
Import GbtSurfaces.Section_3_6.prop_3_8_a_linear.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine T]; intros; conjuncts; first [ intro no; first [ refuting (no (1 / 3) (8) (8)) | refuting (no (1 / 3) (3) (4)) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine T]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End prop_3_8_a_linear.

Module prop_3_8_a_true.
Import GbtSurfaces.Section_3_6.prop_3_8_a_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle at_angle_ T cosine sine]; intros q w x Q N M A B L; refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra | apply arc_rate; assumption ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine T at_angle_]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End prop_3_8_a_true.

Module prop_3_8_b.
Import GbtSurfaces.Section_3_6.prop_3_8_b.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not Tm cosine sine]; intro no; specialize (no (1 / 3) 0 1 ltac:(lra) ltac:(lra)); injection no; intros _ H; revert H; replace (PI * (2 - 1 / 3)) with (2 * PI - PI / 3) by field; rewrite cos_2PI_minus, cos_PI3; match goal with |- ?a = ?b -> _ => change (a <> b) end; numeric. Qed.
End prop_3_8_b.

Module prop_3_8_b_true.
Import GbtSurfaces.Section_3_6.prop_3_8_b_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle at_angle_ Tm cosine sine]; intros q w x Q N M A B L; refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N); replace (PI * (2 - q)) with (2 * PI - PI * q) by ring; rewrite cos_2PI_minus, sin_2PI_minus, half_cos, half_sin; parts; ring | special; field; special; lra | special; field; special; lra | apply arc_rate; assumption ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance at_angle cosine sine Tm at_angle_]; first [(exists (1 / 3), (3), (4); met) | (exists (1 / 2), (0), (0); met) | (exists (1 / 3), (8), (8); met) | (exists (1 / 3), (1), (1); met) | (exists (1 / 3), (1), (0); met)]. Qed.
End prop_3_8_b_true.

Module prop_3_8_b_exact.
Import GbtSurfaces.Section_3_6.prop_3_8_b_exact.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cosine sine Tm cosine_ sine_ Tm_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cosine sine Tm cosine_ sine_ Tm_]; first [(exists (2), (3); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (0); met)]. Qed.
End prop_3_8_b_exact.

Module prop_3_9_a_composite_line.
Import GbtSurfaces.Section_3_6.prop_3_9_a_composite_line.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FX_]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3)) | refuting (no (2)%Z (fun _ => 3) ((-1) / 3) ((-1) / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FX_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End prop_3_9_a_composite_line.

Module prop_3_9_a_one_segment.
Import GbtSurfaces.Section_3_6.prop_3_9_a_one_segment.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f FX] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (0) (0)). Qed.
End prop_3_9_a_one_segment.

Module prop_3_9_b.
Import GbtSurfaces.Section_3_6.prop_3_9_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A f FX FZ]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (5), (6), (7), (8), (9), (10), (11), (12), (13), (14), ((-1) / 3), ((-1) / 3), 17, 18, 19, (20), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), 0, 0, 0, (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (6), (8), (7), (9), (7), (7), (2), (11), (1), (4), ((-1) / 3), ((-1) / 3), 8, 6, 8, (7), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), ((-1) / 3), ((-1) / 3), 2, 11, 1, (1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), ((-1) / 3), ((-1) / 3), 1, 0, 0, (0), (1 / 3); met)]. Qed.
End prop_3_9_b.

Module alg_6.
Import GbtSurfaces.Section_3_6.alg_6.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros m X Z_ mu nu q z _ _ _ _ _ N _; generalize (FX X m mu nu z) (FZ Z_ m mu nu z); intros x w; cbv beta zeta delta [at_angle T Tm cosine sine]; rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; split; reflexivity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ at_angle cosine sine T Tm]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End alg_6.

Module eq_35.
Import GbtSurfaces.Section_3_6.eq_35.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q36]; identity. Qed.
End eq_35.

Module ex_3_6_curve.
Import GbtSurfaces.Section_3_6.ex_3_6_curve.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q36 f F4 F4_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance Q36 f F4 F4_]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_6_curve.

Module eq_36.
Import GbtSurfaces.Section_3_6.eq_36.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement at_angle T Tm cosine sine]; intros mu nu q z M N Q Z K S D; generalize (entry (F4 mu nu z) 1) (entry (F4 mu nu z) 3); intros x w; split; rewrite (arc_cos _ _ (square_sum _) S), (arc_sin _ _ (square_sum _) S), half_cos, half_sin; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance Q36 f F4 at_angle cosine sine T Tm]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (0), (0), (1 / 2), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_36.
