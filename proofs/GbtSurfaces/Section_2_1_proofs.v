(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_2_1.
Import GbtSurfaces.Section_2_1.Definitions.
Open Scope R_scope.

Module eq_1_f0.
Import GbtSurfaces.Section_2_1.eq_1_f0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_1_f0.

Module eq_1_f1.
Import GbtSurfaces.Section_2_1.eq_1_f1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_1_f1.

Module eq_1_f2.
Import GbtSurfaces.Section_2_1.eq_1_f2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_1_f2.

Module eq_2.
Import GbtSurfaces.Section_2_1.eq_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2.

Module eq_2_zero.
Import GbtSurfaces.Section_2_1.eq_2_zero.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((1))%Z ((3))%Z ((2))%Z (0) (1) (1/2)). Qed.
End eq_2_zero.

Module eq_2_zero_true.
Import GbtSurfaces.Section_2_1.eq_2_zero_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_zero_true.

Module thm_1_1_formal.
Import GbtSurfaces.Section_2_1.thm_1_1_formal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g f b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g f b]; first [(exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_1_formal.

Module thm_1_1_as_functions.
Import GbtSurfaces.Section_2_1.thm_1_1_as_functions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no (1) (1) (1/2)). Qed.
End thm_1_1_as_functions.

Module thm_1_1_true.
Import GbtSurfaces.Section_2_1.thm_1_1_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (1), (- 1), (1 / 3); met) | (exists (1), (- 1), (1 / 2); met) | (exists (1), (- 1), (1 / 3); met) | (exists (1), (- 1), (1 / 3); met) | (exists (1), (- 1), (1 / 3); met)]. Qed.
End thm_1_1_true.

Module thm_1_1_blend.
Import GbtSurfaces.Section_2_1.thm_1_1_blend.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f e]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f e]; first [(exists (2)%Z, (fun _ => 3), (1), (- 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), (- 1), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (1), (- 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (1), (- 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1), (- 1), (1 / 3); met)]. Qed.
End thm_1_1_blend.

Module thm_1_2_Definition_1.
Import GbtSurfaces.Section_2_1.thm_1_2_Definition_1.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement f]; intro no; destruct (no 0 0 1 ltac:(lra) ltac:(lra) ltac:(lra)) as [_ C]; revert C; compute_goal; replace (PI / 2 * (- (1))) with (- (PI / 2)) by field; rewrite ?sin_neg, ?cos_neg, ?sin_PI2, ?cos_PI2; intro C; lra. Qed.
End thm_1_2_Definition_1.

Module thm_1_2_where_curves_are_defined.
Import GbtSurfaces.Section_2_1.thm_1_2_where_curves_are_defined.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_2_where_curves_are_defined.

Module thm_1_3.
Import GbtSurfaces.Section_2_1.thm_1_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_3.

Module thm_1_4.
Import GbtSurfaces.Section_2_1.thm_1_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_4.

Module thm_1_5_d1_0_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d1_0_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f start]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f start]; first [(exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (0), (0); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d1_0_values.

Module thm_1_5_d1_1_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d1_1_values.

Module thm_1_5_d2_0_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d2_0_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f start second p0 p2]; intros; undifferentiated; members_at_ends; conjuncts; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f start second p0 p2]; first [(exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (0), (0); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d2_0_values.

Module thm_1_5_d2_1_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d2_1_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F second1 r0 r2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F second1 r0 r2]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d2_1_values.

Module thm_1_5_d3_0_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d3_0_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f start third p0 p2]; intros; undifferentiated; members_at_ends; conjuncts; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f start third p0 p2]; first [(exists (4)%Z, (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, (4)%Z, (0), (0); met) | (exists (4)%Z, (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, (4)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (4)%Z, (4)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d3_0_values.

Module thm_1_5_d3_1_values.
Import GbtSurfaces.Section_2_1.thm_1_5_d3_1_values.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F third1 r0 r2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F third1 r0 r2]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_d3_1_values.
