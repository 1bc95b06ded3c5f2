(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_5_1.
Import GbtDevelopable.Section_5_1.Definitions.
Open Scope R_scope.

Module eq_5_3_a.
Import GbtDevelopable.Section_5_1.eq_5_3_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_5_3_a.

Module eq_5_3_b.
Import GbtDevelopable.Section_5_1.eq_5_3_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((0))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0)). Qed.
End eq_5_3_b.

Module eq_5_3_b_corrected.
Import GbtDevelopable.Section_5_1.eq_5_3_b_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (0)%Z, (2)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (0)%Z, (2)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (0)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (0)%Z, (2)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (0)%Z, (2)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End eq_5_3_b_corrected.

Module eq_5_4.
Import GbtDevelopable.Section_5_1.eq_5_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H1_ H2_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H1_ H2_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_4.

Module eq_5_4_nec_suf_curves_of_four_coordinates.
Import GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement across]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance across]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7; met) | (exists 7, 2, 11, 1, 7, 2, 11, 1; met) | (exists 1, 0, 0, 0, 0, 1, 0, 0; met)]. Qed.
End eq_5_4_nec_suf_curves_of_four_coordinates.

Module eq_5_4_nec_suf_curves_in_space.
Import GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_in_space.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement point velocity] in no; refuting (no 0 0 0 0 (1) (1) (0) (0) (1) (2) (0)). Qed.
End eq_5_4_nec_suf_curves_in_space.

Module sec_5_1_G0_families.
Import GbtDevelopable.Section_5_1.sec_5_1_G0_families.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; prepared; unknown (P2 0%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_5_1_G0_families.

Module sec_5_1_G0_surfaces.
Import GbtDevelopable.Section_5_1.sec_5_1_G0_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal direction] in no; refuting (no (1) (0) (0) (0) (2) (0) (1) (0) (0) (0) (1) (0) (1) (0) (1) (0) (1) (1) (1) (2)). Qed.
End sec_5_1_G0_surfaces.

Module thm_2_a.
Import GbtDevelopable.Section_5_1.thm_2_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; prepared; unknown (P2 0%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_a.

Module thm_2_b.
Import GbtDevelopable.Section_5_1.thm_2_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_b.

Module eq_5_7_requirement.
Import GbtDevelopable.Section_5_1.eq_5_7_requirement.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal direction midpoint moment foot]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal direction midpoint moment foot]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1), 11, 12, 13, 14, 15, 16, 17, 18; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1), 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), 2, 11, 1, 4, 13, 8, 8, 6; met) | (exists 7, 2, 11, 1, 7, 2, 11, 1, (1), 4, 13, 8, 8, 4, 13, 8, 8; met) | (exists 1, 0, 0, 0, 0, 1, 0, 0, (1), 0, 0, 1, 0, 0, 0, 0, 1; met)]. Qed.
End eq_5_7_requirement.

Module eq_5_7_equivalence.
Import GbtDevelopable.Section_5_1.eq_5_7_equivalence.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0) (1) (0) (0) (1) (0) (0) (0) (1) (0) (0) (1) (0) (0) (0) (1) (0)). Qed.
End eq_5_7_equivalence.

Module eq_5_8_a.
Import GbtDevelopable.Section_5_1.eq_5_8_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_8_a.

Module eq_5_8_b.
Import GbtDevelopable.Section_5_1.eq_5_8_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_8_b.

Module eq_5_9.
Import GbtDevelopable.Section_5_1.eq_5_9.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1 H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1 H2]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_9.

Module eq_5_10.
Import GbtDevelopable.Section_5_1.eq_5_10.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_10.

Module thm_2_necessary_families.
Import GbtDevelopable.Section_5_1.thm_2_necessary_families.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_necessary_families.

Module thm_2_necessary_surfaces.
Import GbtDevelopable.Section_5_1.thm_2_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (2) else if (Z.eqb i0 (1))%bool then ((1 + 4*PI)/PI) else 0) (1) (0) (1) (1) (0) (2) (1)). Qed.
End thm_2_necessary_surfaces.

Module thm_2_true_necessary.
Import GbtDevelopable.Section_5_1.thm_2_true_necessary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ kappa2 c]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ kappa2 c]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (11), (12); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (2), (11); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0); met)]. Qed.
End thm_2_true_necessary.

Module thm_2_true_sufficient.
Import GbtDevelopable.Section_5_1.thm_2_true_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement kappa2 c g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance kappa2 c g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (11), (12); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (2), (11); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0); met)]. Qed.
End thm_2_true_sufficient.

Module thm_2_true_generator.
Import GbtDevelopable.Section_5_1.thm_2_true_generator.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal hh d0 hd direction n alpha omega moment foot]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal hh d0 hd direction n alpha omega moment foot]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 7, 2, 11, 1, 7, 2, 11, 1, 4, 13, 8, 8; met) | (exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0; met)]. Qed.
End thm_2_true_generator.
