(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_1.
Import GbtSurfaces.Section_3_1.Definitions.
Open Scope R_scope.

Module sec_3_1_i.
Import GbtSurfaces.Section_3_1.sec_3_1_i.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T F T_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T F T_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_1_i.

Module eq_8_1.
Import GbtSurfaces.Section_3_1.eq_8_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T F]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_8_1.

Module eq_8_2.
Import GbtSurfaces.Section_3_1.eq_8_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_8_2.

Module prop_3_1.
Import GbtSurfaces.Section_3_1.prop_3_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T F T_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T F T_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_1.

Module sec_3_1_translating.
Import GbtSurfaces.Section_3_1.sec_3_1_translating.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T F F_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T F F_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_1_translating.

Module sec_3_1_not_tensor_literal.
Import GbtSurfaces.Section_3_1.sec_3_1_not_tensor_literal.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; apply (no 2%Z (fun _ => 0) 0 1 0 0 0 0); [ lra | lia | lra | lra | lra | lra | ]; clear; intros m Q V alpha mu nu z z1 _ _ _ _ _ _ _; cbv beta delta [T net3]; apply sum_ext; intros k _; generalize (f z mu nu k m); intro g; rewrite Rmult_comm; f_equal; cbv beta delta [f]; compute_goal; pose proof (sin2_cos2 (PI / 2 * z1)) as E; unfold Rsqr in E; generalize dependent (sin (PI / 2 * z1)); generalize dependent (cos (PI / 2 * z1)); intros c s E; assert (F : s * s = 1 - c * c) by lra; ring [F]. Qed.
End sec_3_1_not_tensor_literal.

Module sec_3_1_not_tensor_as_it_stands.
Import GbtSurfaces.Section_3_1.sec_3_1_not_tensor_as_it_stands.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f net rows T F T_ rows_]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) 6 (8) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) | refuting (no (2)%Z (2)%Z (fun _ => 4) 5 (1) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f net rows T F T_ rows_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), 5, (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), 0, (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), 6, (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_1_not_tensor_as_it_stands.

Module sec_3_1_order_one_missing_none.
Import GbtSurfaces.Section_3_1.sec_3_1_order_one_missing_none.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; intros; conjuncts; first [ intro no; first [ refuting (no ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no ((-1) / 3) ((-1) / 3) (1 / 3)) ] | identity ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_3_1_order_one_missing_none.

Module eq_10.
Import GbtSurfaces.Section_3_1.eq_10.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End eq_10.

Module eq_10_bernstein.
Import GbtSurfaces.Section_3_1.eq_10_bernstein.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (2)%Z, (fun _ => 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1 / 3); met)]. Qed.
End eq_10_bernstein.

Module eq_10_extending.
Import GbtSurfaces.Section_3_1.eq_10_extending.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End eq_10_extending.

Module eq_11.
Import GbtSurfaces.Section_3_1.eq_11.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f T net printed_] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (1) (1) (1) (1) (1/2) (1/2)). Qed.
End eq_11.

Module eq_11_corrected.
Import GbtSurfaces.Section_3_1.eq_11_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T b net]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T b net]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_11_corrected.

Module eq_11_points.
Import GbtSurfaces.Section_3_1.eq_11_points.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f b] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (2) (1) (1) (1/2) (1)). Qed.
End eq_11_points.

Module eq_11_points_corrected.
Import GbtSurfaces.Section_3_1.eq_11_points_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f b]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_11_points_corrected.

Module eq_11_parameters.
Import GbtSurfaces.Section_3_1.eq_11_parameters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f b tensor tensor_]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) 8 (6) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (2)%Z (fun _ => 3) 4 (1) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f b tensor tensor_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_11_parameters.

Module eq_12_1.
Import GbtSurfaces.Section_3_1.eq_12_1.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (2) (1) (1) (1/2) (1)). Qed.
End eq_12_1.

Module eq_12_1_corrected.
Import GbtSurfaces.Section_3_1.eq_12_1_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_12_1_corrected.

Module eq_12_2.
Import GbtSurfaces.Section_3_1.eq_12_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f net]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f net]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_12_2.

Module eq_12_3.
Import GbtSurfaces.Section_3_1.eq_12_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_12_3.

Module eq_12_4.
Import GbtSurfaces.Section_3_1.eq_12_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f b tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f b tensor]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_12_4.

Module thm_3.
Import GbtSurfaces.Section_3_1.thm_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T net b tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T net b tensor]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End thm_3.

Module sec_3_1_benefits.
Import GbtSurfaces.Section_3_1.sec_3_1_benefits.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f b tensor tensor_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f b tensor tensor_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_1_benefits.

Module sec_3_1_any_shape_literal.
Import GbtSurfaces.Section_3_1.sec_3_1_any_shape_literal.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement net f b tensor] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) 0 (1) (1) (0) (0)). Qed.
End sec_3_1_any_shape_literal.

Module sec_3_1_any_shape_the_shape_changes.
Import GbtSurfaces.Section_3_1.sec_3_1_any_shape_the_shape_changes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f b tensor tensor_]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) 8 (6) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (2)%Z (fun _ => 3) 4 (1) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f b tensor tensor_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_3_1_any_shape_the_shape_changes.

Module alg_1.
Import GbtSurfaces.Section_3_1.alg_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net f b tensor T tensor_ tensor__]; mixed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net f b tensor T tensor_ tensor__]; first [(exists (2)%Z, (fun _ => 3), 4, 5, 6, 7, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, 0, 0, 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, 6, 8, 7, (9), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 9, 7, 7, 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 1, 0, 0, 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End alg_1.

Module ex_3_1_points.
Import GbtSurfaces.Section_3_1.ex_3_1_points.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement V31 alpha31]; ordered. Qed.
End ex_3_1_points.

Module ex_3_1_normal.
Import GbtSurfaces.Section_3_1.ex_3_1_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement V31 Q31]; compute_goal; conjuncts; [ ring | ring | ring | ring | transitivity (sqrt 1); [ f_equal; ring | apply sqrt_1 ] ]. Qed.
End ex_3_1_normal.

Module eq_13.
Import GbtSurfaces.Section_3_1.eq_13.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement Q31 f alpha31 V31 b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance Q31 f alpha31 V31 b]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (0), (0), (1 / 2), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_13.

Module ex_3_1_net.
Import GbtSurfaces.Section_3_1.ex_3_1_net.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement alpha31 V31]; identity. Qed.
End ex_3_1_net.

Module ex_3_1_mesh_count.
Import GbtSurfaces.Section_3_1.ex_3_1_mesh_count.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End ex_3_1_mesh_count.

Module ex_3_1_hull.
Import GbtSurfaces.Section_3_1.ex_3_1_hull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f b]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (0), (0), (1 / 2), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End ex_3_1_hull.

Module sec_3_1_effect.
Import GbtSurfaces.Section_3_1.sec_3_1_effect.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T F T_ F_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T F T_ F_]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_1_effect.

Module prop_3_1_translation.
Import GbtSurfaces.Section_3_1.prop_3_1_translation.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_1_translation.
