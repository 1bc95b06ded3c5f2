(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_3_5.
Import GbtSurfaces.Section_3_5.Definitions.
Open Scope R_scope.

Module eq_27.
Import GbtSurfaces.Section_3_5.eq_27.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f section section_ trajectory trajectory_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f section section_ trajectory trajectory_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_27.

Module sec_3_5_categories.
Import GbtSurfaces.Section_3_5.sec_3_5_categories.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End sec_3_5_categories.

Module sec_3_5_not_expressible_sine.
Import GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End sec_3_5_not_expressible_sine.

Module eq_29.
Import GbtSurfaces.Section_3_5.eq_29.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f moved]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f moved]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (fun _ => 8), (fun _ => 9), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 13), (fun _ => 8), (fun _ => 13), (fun _ => 8), (fun _ => 8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 1), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_29.

Module eq_30.
Import GbtSurfaces.Section_3_5.eq_30.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f trajectory section T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f trajectory section T]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_30.

Module eq_31_2.
Import GbtSurfaces.Section_3_5.eq_31_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f trajectory section T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f trajectory section T]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_31_2.

Module eq_31_3.
Import GbtSurfaces.Section_3_5.eq_31_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_31_3.

Module eq_31_4.
Import GbtSurfaces.Section_3_5.eq_31_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_31_4.

Module eq_31_5.
Import GbtSurfaces.Section_3_5.eq_31_5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_31_5.

Module prop_3_7_1_a.
Import GbtSurfaces.Section_3_5.prop_3_7_1_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f trajectory section T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f trajectory section T]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_7_1_a.

Module prop_3_7_2a.
Import GbtSurfaces.Section_3_5.prop_3_7_2a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f trajectory section T section_ T_ trajectory_ T__ T___]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) | refuting (no (2)%Z (2)%Z (fun _ => 4) (fun _ => 5) ((-1) / 3) ((-1) / 3) ((-1) / 3) ((-1) / 3) (1 / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f trajectory section T section_ T_ trajectory_ T__ T___]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End prop_3_7_2a.

Module prop_3_7_2b.
Import GbtSurfaces.Section_3_5.prop_3_7_2b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement section2 along_sections jump_section trajectory2 along_trajectories jump_trajectory f section trajectory T a2 F before F_ before_ S1 S2 T1 T2 second first gap first_]; lists; intros; conjuncts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f section2 section along_sections jump_section trajectory2 trajectory along_trajectories jump_trajectory]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), 8, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), 9, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), 1, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End prop_3_7_2b.

Module alg_5_a.
Import GbtSurfaces.Section_3_5.alg_5_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f trajectory section T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f trajectory section T]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End alg_5_a.

Module alg_5_b.
Import GbtSurfaces.Section_3_5.alg_5_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 f F1 after F before F1_ after_ F_ before_] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (-1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else if (Z.eqb i0 (2))%bool then ((32 + 7*PI)/(8 + PI)) else 0) 0 (1) (1) (1) (0)). Qed.
End alg_5_b.

Module ex_3_5_sections.
Import GbtSurfaces.Section_3_5.ex_3_5_sections.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S1 S2]; identity. Qed.
End ex_3_5_sections.

Module ex_3_5_trajectories.
Import GbtSurfaces.Section_3_5.ex_3_5_trajectories.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T1 T2]; identity. Qed.
End ex_3_5_trajectories.

Module ex_3_5_c1_sections.
Import GbtSurfaces.Section_3_5.ex_3_5_c1_sections.
Theorem proved : statement.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 _ N _ _; rows_added first S1; rows_added second S2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intro E; equations; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); repeat split; parts; lra. Qed.
Theorem met : instance.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [instance gap]; exists 0, 0, 0, 0; conjuncts; first [ lra | intros; lia | rows_added first S1; rows_added second S2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders; cbn [row nth pred]; written_out; ends_of_sums; parts; field ]. Qed.
End ex_3_5_c1_sections.

Module ex_3_5_c1_trajectories.
Import GbtSurfaces.Section_3_5.ex_3_5_c1_trajectories.
Theorem proved : statement.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 _ N _ _; rows_added first T1; rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intro E; equations; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); repeat split; parts; lra. Qed.
Theorem met : instance.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [instance gap]; exists 0, 0, 0, 0; conjuncts; first [ lra | intros; lia | rows_added first T1; rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; parts; field ]. Qed.
End ex_3_5_c1_trajectories.

Module ex_3_5_c2_sections.
Import GbtSurfaces.Section_3_5.ex_3_5_c2_sections.
Theorem proved : statement.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 H N; rows_added first S1; rows_added second S2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intros E1 E2 D; injection E1; injection E2; clear E1 E2; intros; pose proof PI_RGT_0 as P; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); subst mu1; assert (Q : PI ^ 2 <> 0) by (apply pow_nonzero, PI_neq0); assert (M : nu1 = mu) by (apply Rmult_eq_reg_l with (PI ^ 2); [ lra | exact Q ]); assert (V : (2 + PI) * nu = - 2) by (subst nu1; apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); repeat split; try lra; [ parts; ring | apply Rmult_eq_reg_l with (2 + PI); [ rewrite V; field; exact D | exact D ] | nra | nra ]. Qed.
Theorem met : instance.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [instance gap]; exists 0, (- 2 / (2 + PI)), (- 2 / (2 + PI)), (0); pose proof PI_RGT_0; conjuncts; first [ lra | intros; lia | rows_added first S1; rows_added second S2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders; cbn [row nth pred]; written_out; ends_of_sums; parts; field; lra ]. Qed.
End ex_3_5_c2_sections.

Module ex_3_5_c2_trajectories.
Import GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories.
Theorem refuted : ~ statement.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [statement gap not]; intro no; specialize (no 1 (- 2 / (2 + PI)) (- 2 / (2 + PI)) ((10 + PI) / (2 + PI)) ltac:(lra) ltac:(intros; lia)); revert no; rows_added first T1; rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intro no; pose proof PI_RGT_0; destruct (no ltac:(parts; field; lra) ltac:(parts; field; lra)) as (_ & _ & _ & C); revert C; apply Rlt_not_le; numeric. Qed.
End ex_3_5_c2_trajectories.

Module ex_3_5_c2_trajectories_true.
Import GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_true.
Theorem proved : statement.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 H N; rows_added first T1; rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intros E1 E2 D; injection E1; injection E2; clear E1 E2; intros; pose proof PI_RGT_0 as P; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); subst mu1; assert (Q : PI ^ 2 <> 0) by (apply pow_nonzero, PI_neq0); assert (V : (2 + PI) * nu = - 2) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); assert (V' : nu = - 2 / (2 + PI)) by (apply Rmult_eq_reg_l with (2 + PI); [ rewrite V; field; exact D | exact D ]); assert (M : nu1 = 2 - 4 * nu - mu) by (apply Rmult_eq_reg_l with (PI ^ 2); [ lra | exact Q ]); repeat split; [ exact V' | rewrite M, V'; field; exact D | assert (nu < 0) by nra; lra ]. Qed.
Theorem met : instance.
Proof. let rows_added := fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M 1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality; intro; cbv beta delta [F M]; written_out; parts; ring) in cbv beta zeta delta [instance gap]; exists 0, (- 2 / (2 + PI)), (- 2 / (2 + PI)), (2 + 8 / (2 + PI)); pose proof PI_RGT_0; conjuncts; first [ lra | intros; lia | rows_added first T1; rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; parts; field; lra ]. Qed.
End ex_3_5_c2_trajectories_true.

Module ex_3_5_contiguous_each_with_its_own.
Import GbtSurfaces.Section_3_5.ex_3_5_contiguous_each_with_its_own.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement S1 T1 S2 T2 f first first_ second second_] in no; refuting (no (1) (1) (1) (1) (1/2)). Qed.
End ex_3_5_contiguous_each_with_its_own.

Module ex_3_5_contiguous_one_trajectory.
Import GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_trajectory.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S1 T1 S2 f first first_ second]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance S1 T1 S2 f first first_ second]; first [(exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_5_contiguous_one_trajectory.

Module ex_3_5_contiguous_one_section.
Import GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_section.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S1 T1 T2 f first first_ second]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance S1 T1 T2 f first first_ second]; first [(exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_3_5_contiguous_one_section.

Module sec_3_5_unnecessary.
Import GbtSurfaces.Section_3_5.sec_3_5_unnecessary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F by_ by__]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F by_ by__]; first [(exists (2)%Z, 3, (fun _ => 4), ((-1) / 3), ((-1) / 3), (7), (8), (1 / 3); met) | (exists (2)%Z, 0, (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, 8, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (7), (9), (1 / 3); met) | (exists (2)%Z, 1, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1), (1), (1 / 3); met) | (exists (2)%Z, 0, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1), (0), (1 / 3); met)]. Qed.
End sec_3_5_unnecessary.
