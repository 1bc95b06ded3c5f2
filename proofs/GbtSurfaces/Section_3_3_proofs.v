(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_3.
Import GbtSurfaces.Section_3_3.Definitions.
Open Scope R_scope.

Module sec_3_3_generatrix.
Import GbtSurfaces.Section_3_3.sec_3_3_generatrix.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f L0 L1 S_ S__]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f L0 L1 S_ S__]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_3_generatrix.

Module sec_3_3_same_degree_literal.
Import GbtSurfaces.Section_3_3.sec_3_3_same_degree_literal.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; apply (no (fun _ => 0) 0 0 0 0 0); [ lra | lra | clear; intros B P R_ W z z1 _ _; cbv beta delta [cubic quartic raised f b]; compute_goal; pose proof (sin2_cos2 (PI / 2 * z)) as E; unfold Rsqr in E; generalize dependent (sin (PI / 2 * z)); generalize dependent (cos (PI / 2 * z)); intros c s E; assert (F : s * s = 1 - c * c) by lra; field_simplify_eq; ring [F] ]. Qed.
End sec_3_3_same_degree_literal.

Module sec_3_3_same_degree_in_general.
Import GbtSurfaces.Section_3_3.sec_3_3_same_degree_in_general.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_ cubic cubic_ f]; intros; intro no; refuting_at_ends (no (fun i => nth (Z.to_nat i) [0; 0; 0; 1] 0) (fun i => nth (Z.to_nat i) [0; 0; 0; 2 / (4 + PI); 1] 0) (1 / 2)). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_ cubic cubic_ f]; exists (fun _ => 0), (fun _ => 0), 0; lists; conjuncts; first [ lra | ends_of_sums; ring ]. Qed.
End sec_3_3_same_degree_in_general.

Module eq_17_0.
Import GbtSurfaces.Section_3_3.eq_17_0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f L0 L0_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f L0 L0_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_17_0.

Module eq_17_1.
Import GbtSurfaces.Section_3_3.eq_17_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f L1 L1_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f L1 L1_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_17_1.

Module sec_3_3_condition_1.
Import GbtSurfaces.Section_3_3.sec_3_3_condition_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ with_own]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ with_own]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_3_condition_1.

Module sec_3_3_condition_2.
Import GbtSurfaces.Section_3_3.sec_3_3_condition_2.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f printed_ L0 L1] in no; refuting (no ((2))%Z (fun i0 => 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (0) (1/2)). Qed.
End sec_3_3_condition_2.

Module eq_18.
Import GbtSurfaces.Section_3_3.eq_18.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f printed_ L0 L1 S_] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (0) (1/2) (1)). Qed.
End eq_18.

Module eq_18_corrected.
Import GbtSurfaces.Section_3_3.eq_18_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f L0 L1 S_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f L0 L1 S_]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_18_corrected.

Module eq_18_true.
Import GbtSurfaces.Section_3_3.eq_18_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f with_own L0 L1 with_own_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f with_own L0 L1 with_own_]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_18_true.

Module eq_18_sufficient.
Import GbtSurfaces.Section_3_3.eq_18_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ L0 L1 printed__]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ L0 L1 printed__]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_18_sufficient.

Module eq_18_necessary.
Import GbtSurfaces.Section_3_3.eq_18_necessary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ L1]; intros; conjuncts; closed_parts; ends_of_sums; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ L1]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_18_necessary.

Module eq_18_defect.
Import GbtSurfaces.Section_3_3.eq_18_defect.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ L0 L1 S_ e]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ L0 L1 S_ e]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_18_defect.

Module eq_18_tensor.
Import GbtSurfaces.Section_3_3.eq_18_tensor.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ tensor]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_18_tensor.

Module sec_3_3_benefits_a.
Import GbtSurfaces.Section_3_3.sec_3_3_benefits_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b printed_ with_own printed__ printed___ with_own_ with_own__ with_own___ with_own____]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) | refuting (no (2)%Z (fun _ => 3) (fun _ => 4) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f b printed_ with_own printed__ printed___ with_own_ with_own__ with_own___ with_own____]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_3_3_benefits_a.

Module prop_3_3_a.
Import GbtSurfaces.Section_3_3.prop_3_3_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f L0 L1 S_ S__]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f L0 L1 S_ S__]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_3_a.

Module prop_3_3_b.
Import GbtSurfaces.Section_3_3.prop_3_3_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; intros; intro no; refuting (no 1 0 0 0 (1 / 2)). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End prop_3_3_b.

Module prop_3_4_a.
Import GbtSurfaces.Section_3_3.prop_3_4_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed_ tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed_ tensor]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_4_a.

Module prop_3_4_a_net.
Import GbtSurfaces.Section_3_3.prop_3_4_a_net.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement any any_ line line_ f]; intros; intro no; refuting_at_ends (no (fun i => nth (Z.to_nat i) [0; 1; 0] 0) (fun _ => 0) 0 (-1) 0 0 (1 / 2)). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance any any_ line line_ f]; exists (fun _ => 0), (fun _ => 0), 0, 0, 0, 0, 0; lists; conjuncts; first [ lra | ends_of_sums; ring ]. Qed.
End prop_3_4_a_net.

Module prop_3_4_b.
Import GbtSurfaces.Section_3_3.prop_3_4_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement M0 M1 S2 jump jump0 jump1 S2_ S__ jump_ f L0 L1 S_ S__ b printed_ with_own tensor a1 a2 b1 c1 F pair F_ pair_ b3_true own4]; lists; intros; conjuncts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f M0 M1 S2 L0 L1 S_ jump jump0 jump1 S2_ S__ jump_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End prop_3_4_b.

Module alg_3_a.
Import GbtSurfaces.Section_3_3.alg_3_a.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f printed_ L0 L1] in no; refuting (no ((2))%Z (fun i0 => 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (0) (1/2)). Qed.
End alg_3_a.

Module alg_3_a_corrected.
Import GbtSurfaces.Section_3_3.alg_3_a_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f L0 L1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f L0 L1]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End alg_3_a_corrected.

Module alg_3_b.
Import GbtSurfaces.Section_3_3.alg_3_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 third fourth f F1 other F pair F1_ other_ F_ pair_] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (-1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else if (Z.eqb i0 (2))%bool then ((32 + 7*PI)/(8 + PI)) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0) (1) (1) (1) (0) (1)). Qed.
End alg_3_b.

Module ex_3_3_curves.
Import GbtSurfaces.Section_3_3.ex_3_3_curves.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f own4] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else if (Z.eqb i0 (4))%bool then (1) else 0) (fun i0 => 0) (1) (1) (1) (0) (1/2)). Qed.
End ex_3_3_curves.

Module ex_3_3_curves_corrected.
Import GbtSurfaces.Section_3_3.ex_3_3_curves_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f own4]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f own4]; first [(exists (fun _ => 2), (fun _ => 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_3_curves_corrected.

Module eq_19_literal.
Import GbtSurfaces.Section_3_3.eq_19_literal.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else if (Z.eqb i0 (4))%bool then (1) else 0) (1) (1) (1/2)). Qed.
End eq_19_literal.

Module eq_19_m_is_4.
Import GbtSurfaces.Section_3_3.eq_19_m_is_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f own4 own4_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f own4 own4_]; first [(exists (fun _ => 2), (fun _ => 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_19_m_is_4.

Module eq_19_tensor.
Import GbtSurfaces.Section_3_3.eq_19_tensor.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f own4 tensor4] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else if (Z.eqb i0 (4))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else if (Z.eqb i0 (4))%bool then (1) else 0) (1) (1) (1) (0) (1/2) (1)). Qed.
End eq_19_tensor.

Module ex_3_3_gl_0.
Import GbtSurfaces.Section_3_3.ex_3_3_gl_0.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not f]; intro no; refuting (no 0 0 0 0 0 1 0 0 0). Qed.
End ex_3_3_gl_0.

Module ex_3_3_gl_0_corrected.
Import GbtSurfaces.Section_3_3.ex_3_3_gl_0_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists 2, 3, 4, 5, 6, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 0, 0, 0, 0, 0, (0), (0), (1 / 2); met) | (exists 13, 8, 8, 6, 8, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 1, 1, 1, 1, 1, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 0, 0, 0, 0, 0, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_3_gl_0_corrected.

Module ex_3_3_gl_1.
Import GbtSurfaces.Section_3_3.ex_3_3_gl_1.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not f]; intro no; refuting (no 0 1 0 0 0 0 0 0 0). Qed.
End ex_3_3_gl_1.

Module ex_3_3_gl_1_corrected.
Import GbtSurfaces.Section_3_3.ex_3_3_gl_1_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists 2, 3, 4, 5, 6, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 0, 0, 0, 0, 0, (0), (0), (1 / 2); met) | (exists 13, 8, 8, 6, 8, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 1, 1, 1, 1, 1, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists 0, 0, 0, 0, 0, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_3_gl_1_corrected.

Module ex_3_3_composite.
Import GbtSurfaces.Section_3_3.ex_3_3_composite.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f a join1 a1 a2 a3_true join2 next cubic left_ next_ cubic_ left__ quartic quartic_]; intros; conjuncts; ends_of_sums; members_at_ends; members; cbv beta delta [join3 b1 b2_true c1 b3_true b5_true b4_true a a1 a2 a3_true] in *; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next cubic left_ next_ cubic_ left__ quartic quartic_]; first [(exists (fun _ => 2), (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_3_3_composite.
