(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_4.
Import GbtSurfaces.Section_3_4.Definitions.
Open Scope R_scope.

Module eq_20_profile.
Import GbtSurfaces.Section_3_4.eq_20_profile.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_20_profile.

Module eq_20_trajectory.
Import GbtSurfaces.Section_3_4.eq_20_trajectory.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z (fun i0 i1 => if (Z.eqb i0 (0) && Z.eqb i1 (1))%bool then (0) else if (Z.eqb i0 (1) && Z.eqb i1 (0))%bool then (0) else if (Z.eqb i0 (1) && Z.eqb i1 (1))%bool then (0) else if (Z.eqb i0 (1) && Z.eqb i1 (2))%bool then (0) else if (Z.eqb i0 (2) && Z.eqb i1 (1))%bool then (1) else 0) (1) (1) (1/2)). Qed.
End eq_20_trajectory.

Module eq_20_trajectory_corrected.
Import GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 2 * i1 * i1 * i1 + 6 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_20_trajectory_corrected.

Module eq_21.
Import GbtSurfaces.Section_3_4.eq_21.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_21.

Module eq_22.
Import GbtSurfaces.Section_3_4.eq_22.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV profile trajectory swung]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV profile trajectory swung]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_22.

Module prop_3_5.
Import GbtSurfaces.Section_3_4.prop_3_5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement swung turn]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance swung turn]; first [(exists (1), (1), (4), (5), (6); met) | (exists (1), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8); met) | (exists (1), (1), (1), (1), (1); met) | (exists (1), (1), (1), (0), (0); met)]. Qed.
End prop_3_5.

Module prop_3_6_1.
Import GbtSurfaces.Section_3_4.prop_3_6_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement swung]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance swung]; first [(exists (1), (3), (4), (5), (6); met) | (exists (1), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8); met) | (exists (1), (1), (1), (1), (1); met) | (exists (1), (1), (0), (0), (0); met)]. Qed.
End prop_3_6_1.

Module prop_3_6_2.
Import GbtSurfaces.Section_3_4.prop_3_6_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement swung turn]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance swung turn]; first [(exists (1), (1), (4), (5), (6); met) | (exists (1), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8); met) | (exists (1), (1), (1), (1), (1); met) | (exists (1), (1), (1), (0), (0); met)]. Qed.
End prop_3_6_2.

Module eq_23.
Import GbtSurfaces.Section_3_4.eq_23.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV net swung]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV net swung]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_23.

Module thm_4_elements.
Import GbtSurfaces.Section_3_4.thm_4_elements.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement net] in no; refuting (no ((0))%Z ((1))%Z ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) (1)). Qed.
End thm_4_elements.

Module thm_4_elements_corrected.
Import GbtSurfaces.Section_3_4.thm_4_elements_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement net]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance net]; first [(exists (0)%Z, (0)%Z, (2)%Z, (2)%Z, (fun _ => 6), (fun _ => 7), (fun _ => 8), (fun _ => 9), (1); met) | (exists (0)%Z, (0)%Z, (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1); met) | (exists (0)%Z, (0)%Z, (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (7); met) | (exists (0)%Z, (0)%Z, (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1); met) | (exists (0)%Z, (0)%Z, (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1); met)]. Qed.
End thm_4_elements_corrected.

Module thm_4_parameters.
Import GbtSurfaces.Section_3_4.thm_4_parameters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FX_ FZ FU FU_ FV]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) | refuting (no (2)%Z (2)%Z (fun _ => 4) (fun _ => 5) (fun _ => 6) (fun _ => 7) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FX_ FZ FU FU_ FV]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End thm_4_parameters.

Module eq_24.
Import GbtSurfaces.Section_3_4.eq_24.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_24.

Module thm_4_unity.
Import GbtSurfaces.Section_3_4.thm_4_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_4_unity.

Module eq_25_1.
Import GbtSurfaces.Section_3_4.eq_25_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FU FV FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FU FV FX FZ]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_25_1.

Module eq_25_2_a.
Import GbtSurfaces.Section_3_4.eq_25_2_a.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (1) (1/2)). Qed.
End eq_25_2_a.

Module eq_25_2_a_corrected.
Import GbtSurfaces.Section_3_4.eq_25_2_a_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (1), ((-1) / 3), ((-1) / 3), (7), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8), ((-1) / 3), ((-1) / 3), (7), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), (1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), (1), (1 / 3); met)]. Qed.
End eq_25_2_a_corrected.

Module eq_25_2_b.
Import GbtSurfaces.Section_3_4.eq_25_2_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (1) (1/2)). Qed.
End eq_25_2_b.

Module eq_25_2_b_corrected.
Import GbtSurfaces.Section_3_4.eq_25_2_b_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (1), ((-1) / 3), ((-1) / 3), (7), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8), ((-1) / 3), ((-1) / 3), (7), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), (1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), (1), (1 / 3); met)]. Qed.
End eq_25_2_b_corrected.

Module eq_25_2_c.
Import GbtSurfaces.Section_3_4.eq_25_2_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_25_2_c.

Module eq_25_3.
Import GbtSurfaces.Section_3_4.eq_25_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_25_3.

Module eq_25_4_a.
Import GbtSurfaces.Section_3_4.eq_25_4_a.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement f not]; intro no; refuting (no 2%Z 2%Z (fun _ => 0) (fun _ => 1) 1 0 0 0 0 0 0). Qed.
End eq_25_4_a.

Module eq_25_4_a_corrected.
Import GbtSurfaces.Section_3_4.eq_25_4_a_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_25_4_a_corrected.

Module eq_25_4_b.
Import GbtSurfaces.Section_3_4.eq_25_4_b.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement f not]; intro no; refuting (no 2%Z 2%Z (fun _ => 0) (fun _ => 1) (fun _ => 1) 1 0 0 0 0 0 0). Qed.
End eq_25_4_b.

Module eq_25_4_b_corrected.
Import GbtSurfaces.Section_3_4.eq_25_4_b_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_25_4_b_corrected.

Module eq_25_4_c.
Import GbtSurfaces.Section_3_4.eq_25_4_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV swung]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV swung]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_25_4_c.

Module sec_3_4_features_a.
Import GbtSurfaces.Section_3_4.sec_3_4_features_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV swung net FX_ FX__ FU_ FU__]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z) (9) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) | refuting (no (2)%Z (2)%Z (fun _ => 4) (fun _ => 5) (fun _ => 6) (fun _ => 7) (1) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV swung net FX_ FX__ FU_ FU__]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_4_features_a.

Module sec_3_4_continuity_pc.
Import GbtSurfaces.Section_3_4.sec_3_4_continuity_pc.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement along_profiles f FX FX2 FZ2 FZ swung jumpX jumpZ]; lists; intros; conjuncts; parts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX2 FZ2 FX FZ jumpX jumpZ swung along_profiles]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (13), (14); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (4); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0); met)]. Qed.
End sec_3_4_continuity_pc.

Module sec_3_4_continuity_tc.
Import GbtSurfaces.Section_3_4.sec_3_4_continuity_tc.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FU2 FV2 FU FV swung along_trajectories jumpU jumpV]; lists; intros; conjuncts; parts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FU2 FV2 FU FV swung along_trajectories jumpU jumpV]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (13), (14); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (4); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0); met)]. Qed.
End sec_3_4_continuity_tc.

Module sec_3_4_closed.
Import GbtSurfaces.Section_3_4.sec_3_4_closed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement gapz gapz1 gapz_ gapz1_ swung]; lists; intros lambda r theta u0 u1 v0 v1 w w0 w1 x x0 x1 L R0 A B C D N X; pose proof (sin2_cos2 theta) as E; unfold Rsqr in E; assert (K : lambda <> 0) by lra; assert (A' : lambda * r * (x1 - x0) = 0) by (transitivity (lambda * r * (x1 - x0) * (sin theta * sin theta + cos theta * cos theta)); [ rewrite E; ring | rewrite <- A; cbn; ring ]); assert (x1 = x0) by (assert (G : x1 - x0 = 0) by (apply (Rmult_eq_reg_l (lambda * r)); [ rewrite A'; ring | apply Rmult_integral_contrapositive_currified; assumption ]); lra); assert (w1 = w0) by (cbn in B; lra); assert (P : lambda * x <> 0) by (apply Rmult_integral_contrapositive_currified; assumption); assert (u1 = u0) by (apply (Rmult_eq_reg_l (lambda * x)); [ cbn in C; lra | exact P ]); assert (v1 = v0) by (apply (Rmult_eq_reg_l (lambda * x)); [ cbn in D; lra | exact P ]); repeat split; try assumption; compute_goal; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance gapz gapz1 swung]; exists 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0; lists; conjuncts; first [ lra | cbn; ring ]. Qed.
End sec_3_4_closed.

Module sec_3_4_revolution.
Import GbtSurfaces.Section_3_4.sec_3_4_revolution.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement swung turn]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance swung turn]; first [(exists (1), (3), (4), (5); met) | (exists (1), (0), (0), (0); met) | (exists (1), (8), (8), (6); met) | (exists (1), (1), (1), (1); met) | (exists (1), (1), (0), (0); met)]. Qed.
End sec_3_4_revolution.

Module sec_3_4_revolution_not_tensor_quarter.
Import GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f swung]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f swung]; first [(exists (1), (3), (4), (1 / 3); met) | (exists (1), (0), (0), (1 / 2); met) | (exists (13), (8), (8), (1 / 3); met) | (exists (1), (1), (1), (1 / 3); met) | (exists (1), (1), (0), (1 / 3); met)]. Qed.
End sec_3_4_revolution_not_tensor_quarter.

Module sec_3_4_revolution_not_tensor_cubic.
Import GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; exists 1, 1, 1, 1, 0, 0, 0; met. Qed.
End sec_3_4_revolution_not_tensor_cubic.

Module alg_4_a.
Import GbtSurfaces.Section_3_4.alg_4_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f FX FZ FU FV net swung]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f FX FZ FU FV net swung]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End alg_4_a.

Module alg_4_b.
Import GbtSurfaces.Section_3_4.alg_4_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a1 a2 a3 third f FX2 FZ2 FX FZ FX2_ FZ2_ FX_ FZ_ swung second first second_ first_] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (8*(4 + PI)/(8 + PI)) else 0) (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (1) (1) (0) (1) (1)). Qed.
End alg_4_b.

Module eq_26.
Import GbtSurfaces.Section_3_4.eq_26.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement profile trajectory]; identity. Qed.
End eq_26.

Module ex_3_4_scaling.
Import GbtSurfaces.Section_3_4.ex_3_4_scaling.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement swung]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance swung]; first [(exists (1), (1), (4), (5), (6), (7); met) | (exists (1), (1), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7); met) | (exists (1), (1), (1), (1), (1), (1); met) | (exists (1), (1), (1), (0), (0), (0); met)]. Qed.
End ex_3_4_scaling.

Module fig_16_lambda_between_the_panels.
Import GbtSurfaces.Section_3_4.fig_16_lambda_between_the_panels.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement along_profiles swung FX FZ FX2 FZ2 f a]; lists; intros; split; parts; ends_of_sums; rewritten; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a]; exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), 1, 0, 0, 0, 0, 0, 0; conjuncts; first [ lia | intros; lia | lra | numeric | ring ]. Qed.
End fig_16_lambda_between_the_panels.

Module fig_16_lambda_between_the_surfaces.
Import GbtSurfaces.Section_3_4.fig_16_lambda_between_the_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f FX2 FX] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0) (1) (2) (0) (0) (0) (0) (1)). Qed.
End fig_16_lambda_between_the_surfaces.
