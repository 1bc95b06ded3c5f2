(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_2.
Import GbtSurfaces.Section_3_2.Definitions.
Open Scope R_scope.

Module eq_14.
Import GbtSurfaces.Section_3_2.eq_14.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N1 bilinear]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N1 bilinear]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End eq_14.

Module sec_3_2_segments.
Import GbtSurfaces.Section_3_2.sec_3_2_segments.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N0_ N1 N1_ bilinear bilinear_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N0_ N1 N1_ bilinear bilinear_]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_2_segments.

Module sec_3_2_linear.
Import GbtSurfaces.Section_3_2.sec_3_2_linear.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N1 bilinear N0_ N1_ bilinear_ bilinear__]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N1 bilinear N0_ N1_ bilinear_ bilinear__]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_2_linear.

Module prop_3_2_a.
Import GbtSurfaces.Section_3_2.prop_3_2_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N1 bilinear]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N1 bilinear]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0); met)]. Qed.
End prop_3_2_a.

Module prop_3_2_b.
Import GbtSurfaces.Section_3_2.prop_3_2_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N0_ N1 N1_ bilinear bilinear_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N0_ N1 N1_ bilinear bilinear_]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_2_b.

Module prop_3_2_c.
Import GbtSurfaces.Section_3_2.prop_3_2_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N1 bilinear]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N1 bilinear]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_2_c.

Module eq_15.
Import GbtSurfaces.Section_3_2.eq_15.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N0 N1 bilinear b product]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N0 N1 bilinear b product]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End eq_15.

Module sec_3_2_fixed.
Import GbtSurfaces.Section_3_2.sec_3_2_fixed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b product product_ N0 N1 bilinear]; unstaged; prepared; known ((G (0)%Z (0)%Z)) (p00) (1); known ((G (0)%Z (1)%Z)) (p01) (1); known ((G (1)%Z (0)%Z)) (p10) (1); known ((G (1)%Z (1)%Z)) (p11) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b product product_ N0 N1 bilinear]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), 5, 6, 7, 8, (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), 0, 0, 0, 0, (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), 6, 8, 7, 9, (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), 1, 1, 1, 1, (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), 0, 0, 0, 0, (1 / 3), (1 / 3); met)]. Qed.
End sec_3_2_fixed.

Module sec_3_2_list_1.
Import GbtSurfaces.Section_3_2.sec_3_2_list_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_2_list_1.

Module sec_3_2_list_2.
Import GbtSurfaces.Section_3_2.sec_3_2_list_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement R_ T f]; intros; repeat split; [ apply sum_ext; intros; f_equal; curve_at_end; reflexivity .. | | ]; [ rewrite (sum_ext 0 m _ (fun k => A * basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] k m + (B - A) * (basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] k m * t k))) by (intros; ring); rewrite sum_plus, !sum_scal; rewrite unity_of_three by (lia || lra); ring | intros; nonnegative ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2%Z, 2%Z, 0, 0, (fun _ _ => 0), 0, 0, 0, 0, (fun _ => 0), 0, 0; conjuncts; first [ lia | intros; lia | lra ]. Qed.
End sec_3_2_list_2.

Module sec_3_2_list_3.
Import GbtSurfaces.Section_3_2.sec_3_2_list_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T R_]; intros m n G mu mu1 nu nu1 z z1; intros; transitivity (sum 0 n (fun l => sum 0 m (fun k => f z1 mu1 nu1 l n * (f z mu nu k m * G k l)))); [ apply sum_ext; intros; symmetry; apply sum_scal | rewrite sum_swap; apply sum_ext; intros; rewrite <- sum_scal; apply sum_ext; intros; ring ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2%Z, 2%Z, (fun _ _ => 0), 0, 0, 0, 0, 0, 0; conjuncts; first [ lia | intros; lia | lra ]. Qed.
End sec_3_2_list_3.

Module alg_2_1.
Import GbtSurfaces.Section_3_2.alg_2_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_2_1.

Module alg_2_2.
Import GbtSurfaces.Section_3_2.alg_2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement point f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance point f]; first [(exists (1)%Z, (1)%Z, (2)%Z, (2)%Z, 6, 7, 8, 9, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (1)%Z, (1)%Z, (2)%Z, (2)%Z, 0, 0, 0, 0, (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (1)%Z, (1)%Z, (2)%Z, (2)%Z, 8, 7, 9, 7, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (1)%Z, (1)%Z, (2)%Z, (2)%Z, 1, 1, 1, 1, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (1)%Z, (1)%Z, (2)%Z, (2)%Z, 0, 0, 0, 0, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End alg_2_2.

Module alg_2_2_irregular.
Import GbtSurfaces.Section_3_2.alg_2_2_irregular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, 3, 4, ((-1) / 3), ((-1) / 3), (fun _ => 7), (1 / 3); met) | (exists (2)%Z, 0, 0, (0), (0), (fun _ => 0), (1 / 2); met) | (exists (2)%Z, 8, 8, ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (1 / 3); met) | (exists (2)%Z, 1, 1, ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3); met) | (exists (2)%Z, 0, 0, ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End alg_2_2_irregular.

Module eq_16.
Import GbtSurfaces.Section_3_2.eq_16.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T T_ R_]; intros m n G mu mu1 nu nu1 z z1; intros; split; [ rewrite sum_swap; apply sum_ext; intros; rewrite <- sum_scal; apply sum_ext; intros; ring | conjuncts; cbv beta delta [f]; first [ apply sum_ext; intros; f_equal | idtac ]; at_ends; reflexivity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2%Z, 2%Z, (fun _ _ => 0), 0, 0, 0, 0, 0, 0; conjuncts; first [ lia | intros; lia | lra ]. Qed.
End eq_16.

Module ex_3_2_corners.
Import GbtSurfaces.Section_3_2.ex_3_2_corners.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q00 Q10 Q20 Q30 Q01 Q11 Q21 Q31 Q02 Q12 Q22 Q03 Q13 Q23 Q33 f row_ sixteen]; intros; repeat vector_at_end; repeat split. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance Q00 Q10 Q20 Q30 Q01 Q11 Q21 Q31 Q02 Q12 Q22 Q03 Q13 Q23 Q33 f row_ sixteen]; first [(exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (0), (0), (0), (0); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_3_2_corners.

Module ex_3_2_division_z_lines.
Import GbtSurfaces.Section_3_2.ex_3_2_division_z_lines.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q00 Q30 Q10 Q20 Q03 Q33 Q13 Q23]; identity. Qed.
End ex_3_2_division_z_lines.

Module ex_3_2_division_Q0l.
Import GbtSurfaces.Section_3_2.ex_3_2_division_Q0l.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q00 Q03 Q01 Q02]; identity. Qed.
End ex_3_2_division_Q0l.

Module ex_3_2_division_Q3l.
Import GbtSurfaces.Section_3_2.ex_3_2_division_Q3l.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement Q30 Q33] in no; refuting (no ). Qed.
End ex_3_2_division_Q3l.

Module ex_3_2_division_Q3l_corrected.
Import GbtSurfaces.Section_3_2.ex_3_2_division_Q3l_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q30 Q33]; identity. Qed.
End ex_3_2_division_Q3l_corrected.

Module ex_3_2_equal_parts_a.
Import GbtSurfaces.Section_3_2.ex_3_2_equal_parts_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q10 Q00 Q20 Q30]; identity. Qed.
End ex_3_2_equal_parts_a.

Module ex_3_2_equal_parts_b.
Import GbtSurfaces.Section_3_2.ex_3_2_equal_parts_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q13 Q03 Q23 Q33]; identity. Qed.
End ex_3_2_equal_parts_b.

Module ex_3_2_equal_parts_c.
Import GbtSurfaces.Section_3_2.ex_3_2_equal_parts_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q01 Q00 Q02 Q03]; identity. Qed.
End ex_3_2_equal_parts_c.

Module ex_3_2_equal_parts_d.
Import GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement Q30 Q33] in no; refuting (no ). Qed.
End ex_3_2_equal_parts_d.

Module ex_3_2_equal_parts_d_corrected.
Import GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q30 Q33]; identity. Qed.
End ex_3_2_equal_parts_d_corrected.

Module ex_3_2_interior.
Import GbtSurfaces.Section_3_2.ex_3_2_interior.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q10 Q01 Q20 Q02]; identity. Qed.
End ex_3_2_interior.

Module ex_3_2_equation.
Import GbtSurfaces.Section_3_2.ex_3_2_equation.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not row_ sixteen four]; intro no; specialize (no 0 1 0 0 0 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)); revert no; cbv beta delta [f]; repeat vector_at_end; cbv beta delta [Q00 Q01 Q02 Q03 Q30 Q33 b]; compute_goal; special; intro C; contradiction_in C. Qed.
End ex_3_2_equation.

Module ex_3_2_sixteen.
Import GbtSurfaces.Section_3_2.ex_3_2_sixteen.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End ex_3_2_sixteen.

Module ex_3_2_coplanar.
Import GbtSurfaces.Section_3_2.ex_3_2_coplanar.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q00 Q10 Q20 Q30 Q03 Q13 Q23 Q33 Q01 Q02 Q31]; identity. Qed.
End ex_3_2_coplanar.

Module ex_3_2_noncoplanar_possible.
Import GbtSurfaces.Section_3_2.ex_3_2_noncoplanar_possible.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (2)%Z 8 6 8 7 9 7 7 2 11 1 4 13 ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z) (1 / 3) (1 / 3)) | refuting (no (2)%Z (2)%Z 4 5 6 7 8 9 10 11 12 13 14 15 ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (fun _ => 20) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (fun _ => 20), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0), (0), (fun _ => 0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, 2, 11, 1, 2, 11, 1, 8, 8, 6, 7, 7, 2, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3), (1 / 3); met)]. Qed.
End ex_3_2_noncoplanar_possible.
