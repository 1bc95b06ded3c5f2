(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
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

Module thm_2_4_a.
Import GbtSurfaces.Section_2_2.thm_2_4_a.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 1 (-1) (-1) 0). Qed.
End thm_2_4_a.

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

Module thm_2_c1.
Import GbtSurfaces.Section_2_2.thm_2_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b1]; first [(exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (0), (0); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_c1.
