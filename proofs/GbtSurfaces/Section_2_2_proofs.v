(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_2_2.
Import GbtSurfaces.Section_2_2.Definitions.
Open Scope R_scope.

Module def_2_points_one_letter.
Import GbtSurfaces.Section_2_2.def_2_points_one_letter.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((4))%Z). Qed.
End def_2_points_one_letter.

Module def_2_points_two_letters.
Import GbtSurfaces.Section_2_2.def_2_points_two_letters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 8), (fun _ => 8), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_2_points_two_letters.

Module eq_3.
Import GbtSurfaces.Section_2_2.eq_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3.

Module sec_2_2_symmetry_as_in_Theorem_1.
Import GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry_as_in_Theorem_1.

Module sec_2_2_symmetry_parameters_exchanged.
Import GbtSurfaces.Section_2_2.sec_2_2_symmetry_parameters_exchanged.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry_parameters_exchanged.

Module sec_2_2_symmetry_as_for_B_zier_curves.
Import GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (0) (1/2)). Qed.
End sec_2_2_symmetry_as_for_B_zier_curves.

Module sec_2_2_convex_hull.
Import GbtSurfaces.Section_2_2.sec_2_2_convex_hull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_convex_hull.

Module sec_2_2_variation_diminishing_order_2.
Import GbtSurfaces.Section_2_2.sec_2_2_variation_diminishing_order_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement w f]; compute_goal; intros mu nu z; intros; derivatives; pose proof (sin2_cos2 (PI / 2 * z)) as E; unfold Rsqr in E; pose proof PI_RGT_0; assert (S : 0 <= sin (PI / 2 * z)) by (apply sin_ge_0; nra); assert (C : 0 <= cos (PI / 2 * z)) by (apply cos_ge_0; nra); assert (S1 : sin (PI / 2 * z) <= 1) by apply SIN_bound; assert (C1 : cos (PI / 2 * z) <= 1) by apply COS_bound; generalize dependent (sin (PI / 2 * z)); generalize dependent (cos (PI / 2 * z)); generalize dependent PI; intros p P c C C1 s E S S1; assert (F : c * c = 1 - s * s) by lra; repeat split; apply Rle_ge; [ apply Rle_trans with (p / 8 * (((1 + mu) * (1 + nu)) * (2 * ((1 - s) * (1 - s)) * (2 - c + s)) + ((1 + mu) * (1 - nu)) * (2 * c * ((1 - s) * (1 - s))) + ((1 - mu) * (1 + nu)) * (2 * s * (c * c)))); [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ] | apply Rle_trans with (p / 8 * (((1 + mu) * (1 + nu)) * (2 * ((1 - c) * (1 - c)) * (2 - s + c)) + ((1 - mu) * (1 + nu)) * (2 * s * ((1 - c) * (1 - c))) + ((1 + mu) * (1 - nu)) * (2 * c * (s * s)))); [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ] | apply Rle_trans with (p / 4 * ((1 - s) * ((1 + mu) * (1 - s) + (1 - mu) * (1 + s)) * s * ((1 + nu) * (1 - c) + (1 - nu) * c) + (1 - c) * ((1 + nu) * (1 - c) + (1 - nu) * (1 + c)) * c * ((1 + mu) * (1 - s) + (1 - mu) * s))); [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ] | apply Rle_trans with (1 / 32 * (p * p * p) * (((1 + mu) * (1 + nu)) * (4 * (1 - s) * (1 - c) + 4 * s * (c * c) * (1 - c) + 4 * (s * s) * c * (1 - s)) + ((1 + mu) * (1 - nu)) * (4 * c * (1 - s) * (1 + s)) + ((1 - mu) * (1 + nu)) * (4 * s * (1 - c) * (1 + c)))); [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ] ]. Qed.
Theorem met : instance.
Proof. exists 0, 0, 0; repeat split; lra. Qed.
End sec_2_2_variation_diminishing_order_2.

Module sec_2_2_invariance.
Import GbtSurfaces.Section_2_2.sec_2_2_invariance.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f A]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f A]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (6), (7), (8), (9), (10), (11), (12), (13), (14), ((-1) / 3), ((-1) / 3), 17, 18, 19, (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), 0, 0, 0, (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), (9), (7), (7), (2), (11), (1), (4), ((-1) / 3), ((-1) / 3), 8, 6, 8, (1 / 3); met) | (exists (2)%Z, (fun _ => 8), (fun _ => 8), (fun _ => 6), (1), (1), (1), (1), (1), (1), (1), (1), (1), ((-1) / 3), ((-1) / 3), 2, 11, 1, (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0), ((-1) / 3), ((-1) / 3), 0, 1, 0, (1 / 3); met)]. Qed.
End sec_2_2_invariance.

Module sec_2_2_shape_adjustable.
Import GbtSurfaces.Section_2_2.sec_2_2_shape_adjustable.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3)) | refuting (no (2)%Z (fun _ => 3) ((-1) / 3) ((-1) / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_shape_adjustable.

Module sec_2_2_terminal_0_values.
Import GbtSurfaces.Section_2_2.sec_2_2_terminal_0_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_terminal_0_values.

Module sec_2_2_terminal_1_values.
Import GbtSurfaces.Section_2_2.sec_2_2_terminal_1_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_terminal_1_values.

Module sec_2_2_interpolation.
Import GbtSurfaces.Section_2_2.sec_2_2_interpolation.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_interpolation.

Module sec_2_2_end_derivatives.
Import GbtSurfaces.Section_2_2.sec_2_2_end_derivatives.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; intros; conjuncts; first [ intro no; refuting_at_ends (no 2%Z (fun i => IZR i) 0 0) | ends_of_sums; field ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_end_derivatives.

Module thm_2_setting.
Import GbtSurfaces.Section_2_2.thm_2_setting.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F1 F_ F1_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F1 F_ F1_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_2_setting.

Module thm_2_1.
Import GbtSurfaces.Section_2_2.thm_2_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_1.

Module eq_4_Q11.
Import GbtSurfaces.Section_2_2.eq_4_Q11.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_4_Q11.

Module thm_2_2.
Import GbtSurfaces.Section_2_2.thm_2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F a printed11]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F a printed11]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_2.

Module eq_5_Q12.
Import GbtSurfaces.Section_2_2.eq_5_Q12.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a3] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0). Qed.
End eq_5_Q12.

Module eq_5_Q12_corrected.
Import GbtSurfaces.Section_2_2.eq_5_Q12_corrected.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End eq_5_Q12_corrected.

Module eq_5_Q12_true.
Import GbtSurfaces.Section_2_2.eq_5_Q12_true.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a a3_true join2 join12]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a a3_true join2 join12]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End eq_5_Q12_true.

Module thm_2_3_a.
Import GbtSurfaces.Section_2_2.thm_2_3_a.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 f F1 F] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 1 (-1) (-1) 0). Qed.
End thm_2_3_a.

Module thm_2_3_b.
Import GbtSurfaces.Section_2_2.thm_2_3_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a printed11 a2 a3 printed12] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0). Qed.
End thm_2_3_b.

Module thm_2_3_true.
Import GbtSurfaces.Section_2_2.thm_2_3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F a1 a2]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F a1 a2]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_3_true.

Module thm_2_3_iff.
Import GbtSurfaces.Section_2_2.thm_2_3_iff.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 f F1 F a2 a3_true join2 join12]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 f F1 F a2 a3_true join2 join12]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_3_iff.

Module thm_2_3_necessary.
Import GbtSurfaces.Section_2_2.thm_2_3_necessary.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F1 F F1_ F_ a1 a join1 join11 a2 a3_true join2 join12]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; split; [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P n mu1; split; [ assumption | third_point P n mu1 nu1 ] end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a join1 join11 a2 a3_true join2 join12]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_2_3_necessary.

Module thm_2_3_sufficient.
Import GbtSurfaces.Section_2_2.thm_2_3_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 a2 a3_true join2 join12 f F1 F]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 a2 a3_true join2 join12 f F1 F]; first [(exists (3)%Z, (4)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (4)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (4)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (4)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (4)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_3_sufficient.

Module thm_2_3_jump.
Import GbtSurfaces.Section_2_2.thm_2_3_jump.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 a2 a3 printed12 f F1 F a3_true]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 a2 a3 printed12 f F1 F a3_true]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_3_jump.

Module thm_2_3_when.
Import GbtSurfaces.Section_2_2.thm_2_3_when.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a1 a3_true a3]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a1 a3_true a3]; first [(exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1); met) | (exists (3)%Z, (3)%Z, (0), (0), (1); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1); met)]. Qed.
End thm_2_3_when.

Module eq_6_Q11.
Import GbtSurfaces.Section_2_2.eq_6_Q11.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_ a]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_6_Q11.

Module eq_6_Q12.
Import GbtSurfaces.Section_2_2.eq_6_Q12.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a3] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0). Qed.
End eq_6_Q12.

Module eq_6_Q12_corrected.
Import GbtSurfaces.Section_2_2.eq_6_Q12_corrected.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End eq_6_Q12_corrected.

Module eq_6_Q13.
Import GbtSurfaces.Section_2_2.eq_6_Q13.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ b1 a1 b2 a2 c1 b3 a3 a b4 printed13] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0). Qed.
End eq_6_Q13.

Module eq_6_Q13_true.
Import GbtSurfaces.Section_2_2.eq_6_Q13_true.
Theorem proved : statement.
Proof. let fourth_point := fun P l mu nu Q m w => match goal with |- P 3%Z = Q m + 1 / ?b * ?t => let B := fresh in assert (B : b <> 0) by assumption; apply (Rmult_eq_reg_l b); [ transitivity (b * Q m + t); [ match goal with E : P 0%Z = _, V : P 1%Z = _, W : P 2%Z = _, G : _ - (1 + mu) * (PI / 2) ^ 3 * (P 1%Z - P 0%Z) = ?r |- _ => transitivity (b * Q m + (8 * r - 6 * (IZR l - 2) * PI ^ 2 * (1 - nu - 2 * mu) * (P 2%Z - Q m - 2 * (P 1%Z - Q m)) + (1 + mu) * PI ^ 3 * (P 1%Z - Q m) + 3 * b * (P 2%Z - Q m - (P 1%Z - Q m)))); [ rewrite <- G, E; unfold b1; field | rewrite V, W; unfold b1, b2_true, b3_true, b5_true; change (4 * (IZR l - 2) * (IZR l - 3) * (2 * (IZR l - 4) + 3 * PI * (1 + mu))) with (c1 mu l); generalize dependent w; generalize dependent (a1 mu l nu); generalize dependent (c1 mu l); unfold a2; intros; field; assumption ] end | field; repeat split; assumption ] | exact B ] end in let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F F1 F1_ F_ a3_true b4_true join3 join13]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z)) by (unfold a; second_point P n mu1); assert (W : P 2%Z = join12 Q m mu mu1 n nu nu1) by (unfold join12, join2, Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true, a1, a2, a in *; third_point P n mu1 nu1); unfold join12, join2, Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true in W; unfold a3_true, Section_2_2.Definitions.a3_true; fourth_point P n mu1 nu1 Q m (a m mu1 n nu). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 b1]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End eq_6_Q13_true.

Module thm_2_4_a.
Import GbtSurfaces.Section_2_2.thm_2_4_a.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 1 (-1) (-1) 0). Qed.
End thm_2_4_a.

Module thm_2_4_c.
Import GbtSurfaces.Section_2_2.thm_2_4_c.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (-1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else if (Z.eqb i0 (2))%bool then ((32 + 7*PI)/(8 + PI)) else if (Z.eqb i0 (3))%bool then (0) else 0) (1) (1) (1) (0)). Qed.
End thm_2_4_c.

Module thm_2_4_b.
Import GbtSurfaces.Section_2_2.thm_2_4_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 b1 a printed11 a2 a3 printed12 b2 c1 b3 b4 printed13] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0). Qed.
End thm_2_4_b.

Module thm_2_4_true.
Import GbtSurfaces.Section_2_2.thm_2_4_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F b1 c1 b3_true b2_true b5_true]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F b1 c1 b3_true b2_true b5_true]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_4_true.

Module thm_2_4_iff.
Import GbtSurfaces.Section_2_2.thm_2_4_iff.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 a2 a3_true join2 join12 b1 f F1 F b2_true c1 b3_true b5_true b4_true join3 join13]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); unknown (Q1 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 a2 a3_true join2 join12 b1 f F1 F b2_true c1 b3_true b5_true b4_true join3 join13]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_4_iff.

Module thm_2_4_necessary.
Import GbtSurfaces.Section_2_2.thm_2_4_necessary.
Theorem proved : statement.
Proof. let fourth_point := fun P l mu nu Q m w => match goal with |- P 3%Z = Q m + 1 / ?b * ?t => let B := fresh in assert (B : b <> 0) by assumption; apply (Rmult_eq_reg_l b); [ transitivity (b * Q m + t); [ match goal with E : P 0%Z = _, V : P 1%Z = _, W : P 2%Z = _, G : _ - (1 + mu) * (PI / 2) ^ 3 * (P 1%Z - P 0%Z) = ?r |- _ => transitivity (b * Q m + (8 * r - 6 * (IZR l - 2) * PI ^ 2 * (1 - nu - 2 * mu) * (P 2%Z - Q m - 2 * (P 1%Z - Q m)) + (1 + mu) * PI ^ 3 * (P 1%Z - Q m) + 3 * b * (P 2%Z - Q m - (P 1%Z - Q m)))); [ rewrite <- G, E; unfold b1; field | rewrite V, W; unfold b1, b2_true, b3_true, b5_true; change (4 * (IZR l - 2) * (IZR l - 3) * (2 * (IZR l - 4) + 3 * PI * (1 + mu))) with (c1 mu l); generalize dependent w; generalize dependent (a1 mu l nu); generalize dependent (c1 mu l); unfold a2; intros; field; assumption ] end | field; repeat split; assumption ] | exact B ] end in let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement f F F1 F1_ F_ a3_true b4_true join1 join11 join3 join13]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z)) by (unfold a; second_point P n mu1); assert (W : P 2%Z = join12 Q m mu mu1 n nu nu1) by (unfold join12, join2, Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true, a1, a2, a in *; third_point P n mu1 nu1); repeat split; [ assumption | exact V | exact W | unfold join12, join2, Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true in W; unfold a3_true, Section_2_2.Definitions.a3_true; fourth_point P n mu1 nu1 Q m (a m mu1 n nu) ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 b1]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_2_4_necessary.

Module thm_2_4_sufficient.
Import GbtSurfaces.Section_2_2.thm_2_4_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 a2 a3_true join2 join12 b1 b2_true c1 b3_true b5_true b4_true join3 join13 f F1 F F1_ F_]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); unknown (Q1 2%Z); unknown (Q1 3%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 a2 a3_true join2 join12 b1 b2_true c1 b3_true b5_true b4_true join3 join13 f F1 F F1_ F_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_4_sufficient.

Module thm_2_4_sufficient_quintic.
Import GbtSurfaces.Section_2_2.thm_2_4_sufficient_quintic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a join1 join11 a1 a2 a3_true join2 join12 b1 b2_true c1 b3_true b5_true b4_true join3 join13 f F1 F F1_ F_]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); unknown (Q1 2%Z); unknown (Q1 3%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a join1 join11 a1 a2 a3_true join2 join12 b1 b2_true c1 b3_true b5_true b4_true join3 join13 f F1 F F1_ F_]; first [(exists (3)%Z, (5)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (5)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (5)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (5)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (5)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_4_sufficient_quintic.

Module thm_2_4_cubic.
Import GbtSurfaces.Section_2_2.thm_2_4_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b1 f F1]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b1 f F1]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), (1); met) | (exists (3)%Z, (fun _ => 0), (0), (1); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), (1); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), (1); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), (1); met)]. Qed.
End thm_2_4_cubic.

Module thm_2_a.
Import GbtSurfaces.Section_2_2.thm_2_a.
Theorem proved : statement.
Proof. intros m n Q P mu mu1 nu nu1 p0 p1 ? ? ? ? ? ? _ _ _ _ _ _ D _ _ V W; lists; match goal with |- - Derive_n ?f 1 ?x = ?w => transitivity (- - w); [ apply f_equal, (slope_of_line f (fun t => Q m + w * (Q m - t))); [ intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as E; updated_in E; updated; exact E | intro; ring ] | ring ] end. Qed.
Theorem met : instance.
Proof. exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), Ropp; cbv beta zeta delta [F F1 F_ F1_ f]; conjuncts; premise_of_join. Qed.
End thm_2_a.

Module thm_2_a1.
Import GbtSurfaces.Section_2_2.thm_2_a1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_a1.

Module thm_2_a1_sign.
Import GbtSurfaces.Section_2_2.thm_2_a1_sign.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a1 a1_]; mixed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 a1_]; first [(exists (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, (0), (0); met) | (exists (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_a1_sign.

Module thm_2_a2.
Import GbtSurfaces.Section_2_2.thm_2_a2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_a2.

Module thm_2_a3.
Import GbtSurfaces.Section_2_2.thm_2_a3.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement F F1 F_ F1_ f a1] in no; specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 (-1) (-1) 0 (fun t => t) (fun t => 2 * t) (fun t => - 2 * t)); without_premises no; revert no; lists; match goal with |- Derive_n ?f 1 ?x = _ -> _ => rewrite (slope_of_line f (fun t => - 3 * PI ^ 2 * t) x (- 3 * PI ^ 2)); [ unfold a1; intro C; apply (pow_nonzero PI 2 PI_neq0); lra | unfold a1, a2; intro; compute_goal; field | intro; ring ] end. Qed.
End thm_2_a3.

Module thm_2_a3_corrected.
Import GbtSurfaces.Section_2_2.thm_2_a3_corrected.
Theorem proved : statement.
Proof. let third_coefficient := fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 ? ? ? ? ? ? _ _ _ _ _ _ _ _ _ D _ _ _ _ V W U; unfold a3_true; lists; match goal with |- Derive_n ?f 1 ?x = ?d => apply (slope_of_line f (fun t => d * t - d * Q (m - 1)%Z)); [ intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (U t)) as G; updated_in E; updated_in G; updated; unfold a1, a2; rewrite G, E; unfold a; field; exact D | intro; ring ] end) in third_coefficient (). Qed.
Theorem met : instance.
Proof. exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun t => t), (fun t => 2 * t), (fun t => - 2 * t); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join. Qed.
End thm_2_a3_corrected.

Module thm_2_a3_true.
Import GbtSurfaces.Section_2_2.thm_2_a3_true.
Theorem proved : statement.
Proof. let third_coefficient := fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 ? ? ? ? ? ? _ _ _ _ _ _ _ _ _ D _ _ _ _ V W U; unfold a3_true; lists; match goal with |- Derive_n ?f 1 ?x = ?d => apply (slope_of_line f (fun t => d * t - d * Q (m - 1)%Z)); [ intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (U t)) as G; updated_in E; updated_in G; updated; unfold a1, a2; rewrite G, E; unfold a; field; exact D | intro; ring ] end) in third_coefficient (). Qed.
Theorem met : instance.
Proof. exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun t => t), (fun t => 2 * t), (fun t => - 2 * t); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join. Qed.
End thm_2_a3_true.

Module thm_2_b1.
Import GbtSurfaces.Section_2_2.thm_2_b1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b1.

Module thm_2_b1_sign.
Import GbtSurfaces.Section_2_2.thm_2_b1_sign.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b1 b1_]; mixed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b1 b1_]; first [(exists (5)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (5)%Z, (0), (0); met) | (exists (5)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (5)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (5)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b1_sign.

Module thm_2_b2.
Import GbtSurfaces.Section_2_2.thm_2_b2.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F] in no; refuting (no ((3))%Z (fun i0 => 0) (0) (1)). Qed.
End thm_2_b2.

Module thm_2_b2_true.
Import GbtSurfaces.Section_2_2.thm_2_b2_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F b2_true]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F b2_true]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b2_true.

Module thm_2_b3.
Import GbtSurfaces.Section_2_2.thm_2_b3.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 c1] in no; refuting_at_ends (no 3%Z (fun _ => 0) 1 1). Qed.
End thm_2_b3.

Module thm_2_b3_corrected.
Import GbtSurfaces.Section_2_2.thm_2_b3_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 c1]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 c1]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b3_corrected.

Module thm_2_b3_true.
Import GbtSurfaces.Section_2_2.thm_2_b3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 c1 b3_true]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 c1 b3_true]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b3_true.

Module thm_2_b4.
Import GbtSurfaces.Section_2_2.thm_2_b4.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement F F1 F_ F1_ f b3 a3 a1] in no; specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 (-1) (-1) 0 (fun _ => 0) (fun t => - t) (fun t => 3 * t) (fun t => t) (fun _ => 0) (fun _ => 0) (fun _ => 0) (fun t => - 2 * t) (fun _ => 0) (fun _ => 0) (fun _ => 0) (fun _ => 0)); without_premises no; revert no; lists; let formed f x d := rewrite (slope_of_line f (fun t => d * t) x d); [ | unfold b1; intro; compute_goal; field | intro; ring ] in match goal with |- Derive_n ?f 1 ?x * _ + (Derive_n ?g 1 ?y * _ + (Derive_n ?h 1 ?z * _ + _)) - _ = _ -> _ => formed f x (6 * PI ^ 2); formed g y (- 12 * PI ^ 2); formed h z 0 end; unfold b3_true, a3_true, a, c1, a1; intro C; apply (pow_nonzero PI 2 PI_neq0); pose proof PI_neq0 as N; match type of C with ?l = ?r => transitivity ((l - r) / 6); [ | rewrite C ]; field; exact N end. Qed.
End thm_2_b4.

Module thm_2_b4_corrected.
Import GbtSurfaces.Section_2_2.thm_2_b4_corrected.
Theorem proved : statement.
Proof. let fourth_coefficients := fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 p3 r0 r1 r2 r3 s0 s1 s2 s3 Hm ? ? Hn ? ? _ _ _ _ _ _ _ _ _ _ _ B D _ _ _ _ _ _ V W U T _ _ _ _ V' W' U' T' _ _ _ _ V'' W'' U'' T''; set (w := (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1))); pose (L := fun x y z v : R => b3_true mu1 n nu1 * ((8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 * mu1 - nu1)) * (w * (x - y)) + a2 m nu * (x - 2 * y + z) + 2 * PI ^ 2 * nu * (x - y) - PI ^ 2 * (1 - mu) * (y - z)) / a1 mu1 n nu1 - (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) * (w * (x - y)) + 4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) * (x - 3 * y + 3 * z - v) - 6 * (IZR m - 2) * PI ^ 2 * ((1 - mu) * (y - 2 * z + v) - 2 * nu * (x - 2 * y + z)) - PI ^ 3 * (1 + nu) * (x - y)); let formed V W U T f x g d := rewrite (slope_of_line f g x d); [ | let t := fresh in intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (U t)) as G; pose proof (fourth_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (T t)) as J; cbv zeta in J; updated_in E; updated_in G; updated_in J; updated; change (4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1)) with (a1 mu1 n nu1) in G; rewrite E in G, J; match type of G with ?b * (?p - ?q) = ?r => assert (K : p - q = r / b) by (rewrite <- G; field; exact B); rewrite K in J; clear K end; unfold b1; rewrite J; unfold L, b3_true, c1, a2; fold w; field; exact B | intro; unfold L; field; exact B ] in unfold b3, a3, b4_true; lists; match goal with |- context [Derive_n ?f 1 (Q (m - 1)%Z)] => formed V W U T f (Q (m - 1)%Z) (fun t => L (Q m) t (Q (m - 2)%Z) (Q (m - 3)%Z)) (L 0 1 0 0) end; match goal with |- context [Derive_n ?f 1 (Q (m - 2)%Z)] => formed V' W' U' T' f (Q (m - 2)%Z) (fun t => L (Q m) (Q (m - 1)%Z) t (Q (m - 3)%Z)) (L 0 0 1 0) end; match goal with |- context [Derive_n ?f 1 (Q (m - 3)%Z)] => formed V'' W'' U'' T'' f (Q (m - 3)%Z) (fun t => L (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) t) (L 0 0 0 1) end; unfold L, a3_true; change (a m mu1 n nu) with w; replace (8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 * mu1 - nu1)) with (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) by (unfold a1; ring); field; exact B) in fourth_coefficients (). Qed.
Theorem met : instance.
Proof. exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), (fun t => - t), (fun t => 3 * t), (fun t => t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun t => - 2 * t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join. Qed.
End thm_2_b4_corrected.

Module thm_2_b4_true.
Import GbtSurfaces.Section_2_2.thm_2_b4_true.
Theorem proved : statement.
Proof. let fourth_coefficients := fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 p3 r0 r1 r2 r3 s0 s1 s2 s3 Hm ? ? Hn ? ? _ _ _ _ _ _ _ _ _ _ _ B D _ _ _ _ _ _ V W U T _ _ _ _ V' W' U' T' _ _ _ _ V'' W'' U'' T''; set (w := (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1))); pose (L := fun x y z v : R => b3_true mu1 n nu1 * ((8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 * mu1 - nu1)) * (w * (x - y)) + a2 m nu * (x - 2 * y + z) + 2 * PI ^ 2 * nu * (x - y) - PI ^ 2 * (1 - mu) * (y - z)) / a1 mu1 n nu1 - (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) * (w * (x - y)) + 4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) * (x - 3 * y + 3 * z - v) - 6 * (IZR m - 2) * PI ^ 2 * ((1 - mu) * (y - 2 * z + v) - 2 * nu * (x - 2 * y + z)) - PI ^ 3 * (1 + nu) * (x - y)); let formed V W U T f x g d := rewrite (slope_of_line f g x d); [ | let t := fresh in intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (U t)) as G; pose proof (fourth_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (T t)) as J; cbv zeta in J; updated_in E; updated_in G; updated_in J; updated; change (4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1)) with (a1 mu1 n nu1) in G; rewrite E in G, J; match type of G with ?b * (?p - ?q) = ?r => assert (K : p - q = r / b) by (rewrite <- G; field; exact B); rewrite K in J; clear K end; unfold b1; rewrite J; unfold L, b3_true, c1, a2; fold w; field; exact B | intro; unfold L; field; exact B ] in unfold b3, a3, b4_true; lists; match goal with |- context [Derive_n ?f 1 (Q (m - 1)%Z)] => formed V W U T f (Q (m - 1)%Z) (fun t => L (Q m) t (Q (m - 2)%Z) (Q (m - 3)%Z)) (L 0 1 0 0) end; match goal with |- context [Derive_n ?f 1 (Q (m - 2)%Z)] => formed V' W' U' T' f (Q (m - 2)%Z) (fun t => L (Q m) (Q (m - 1)%Z) t (Q (m - 3)%Z)) (L 0 0 1 0) end; match goal with |- context [Derive_n ?f 1 (Q (m - 3)%Z)] => formed V'' W'' U'' T'' f (Q (m - 3)%Z) (fun t => L (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) t) (L 0 0 0 1) end; unfold L, a3_true; change (a m mu1 n nu) with w; replace (8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 * mu1 - nu1)) with (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) by (unfold a1; ring); field; exact B) in fourth_coefficients (). Qed.
Theorem met : instance.
Proof. exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), (fun t => - t), (fun t => 3 * t), (fun t => t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun t => - 2 * t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join. Qed.
End thm_2_b4_true.

Module thm_2_c1.
Import GbtSurfaces.Section_2_2.thm_2_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b1]; first [(exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (0), (0); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_c1.
