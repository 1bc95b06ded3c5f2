(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_2_3.
Import GbtDevelopable.Section_2_3.Definitions.
From GbtDevelopable Require Import Section_2_3_closed.
Open Scope R_scope.

Module sec_2_3_local_part_of_a_curve.
Import GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_curve.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g G] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (0) (0) (1/2)). Qed.
End sec_2_3_local_part_of_a_curve.

Module sec_2_3_local_part_of_a_composite.
Import GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_composite.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1 H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1 H2]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_local_part_of_a_composite.

Module sec_2_3_linear.
Import GbtDevelopable.Section_2_3.sec_2_3_linear.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G G_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G G_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_linear.

Module eq_2_3.
Import GbtDevelopable.Section_2_3.eq_2_3.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g G] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (0) (0) (1/2)). Qed.
End eq_2_3.

Module eq_2_3_corrected.
Import GbtDevelopable.Section_2_3.eq_2_3_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; intros; rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1 - sin (PI / 2 * x)) * sin (PI / 2 * x) * (R_ (i + 1)%Z - R_ i)))) by (intros; ring); rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_3_corrected.

Module eq_2_4.
Import GbtDevelopable.Section_2_3.eq_2_4.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g G] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (0) (0) (1/2)). Qed.
End eq_2_4.

Module eq_2_4_corrected.
Import GbtDevelopable.Section_2_3.eq_2_4_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; intros; rewrite from_one; rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1 - cos (PI / 2 * x)) * cos (PI / 2 * x) * (R_ (i + 1)%Z - R_ (i + 2)%Z)))) by (intros i I; replace (i + 1 - 1)%Z with i by lia; replace (k - 1 - (i + 1))%Z with (k - 2 - i)%Z by lia; replace (i + 1 + 1)%Z with (i + 2)%Z by lia; ring); rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_4_corrected.

Module sec_2_3_indep_mu.
Import GbtDevelopable.Section_2_3.sec_2_3_indep_mu.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_indep_mu.

Module sec_2_3_indep_nu.
Import GbtDevelopable.Section_2_3.sec_2_3_indep_nu.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_indep_nu.

Module sec_2_3_move.
Import GbtDevelopable.Section_2_3.sec_2_3_move.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g C_ G G_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g C_ G G_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_move.

Module sec_2_3_dir_mu.
Import GbtDevelopable.Section_2_3.sec_2_3_dir_mu.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; intros; split; [ rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1 - sin (PI / 2 * x)) * sin (PI / 2 * x) * (R_ (i + 1)%Z - R_ i)))) by (intros; ring); rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring | signs; nra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_dir_mu.

Module sec_2_3_dir_mu_single.
Import GbtDevelopable.Section_2_3.sec_2_3_dir_mu_single.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage g; stage quadratic; stage quadratic_; stage cubic; staged_goal change; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g quadratic quadratic_ cubic change]; first [(exists (fun _ => 2), (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_dir_mu_single.

Module sec_2_3_dir_nu.
Import GbtDevelopable.Section_2_3.sec_2_3_dir_nu.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; intros; split; [ rewrite from_one; rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1 - cos (PI / 2 * x)) * cos (PI / 2 * x) * (R_ (i + 1)%Z - R_ (i + 2)%Z)))) by (intros i I; replace (i + 1 - 1)%Z with i by lia; replace (k - 1 - (i + 1))%Z with (k - 2 - i)%Z by lia; replace (i + 1 + 1)%Z with (i + 2)%Z by lia; ring); rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring | signs; nra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_dir_nu.

Module sec_2_3_range.
Import GbtDevelopable.Section_2_3.sec_2_3_range.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (-1) (0)). Qed.
End sec_2_3_range.

Module sec_2_3_concl_1.
Import GbtDevelopable.Section_2_3.sec_2_3_concl_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G G_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G G_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_concl_1.

Module sec_2_3_concl_2_boundary_of_the_hull.
Import GbtDevelopable.Section_2_3.sec_2_3_concl_2_boundary_of_the_hull.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g zigzag to_hull] in no; refuting (no ((-3) / 4)). Qed.
End sec_2_3_concl_2_boundary_of_the_hull.

Module sec_2_3_concl_2_control_polygon.
Import GbtDevelopable.Section_2_3.sec_2_3_concl_2_control_polygon.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g loop to_leg2] in no; refuting (no (-1)). Qed.
End sec_2_3_concl_2_control_polygon.

Module sec_2_3_concl_2_quadratic.
Import GbtDevelopable.Section_2_3.sec_2_3_concl_2_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), (1 / 3); met) | (exists (0), (1 / 2); met) | (exists ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_concl_2_quadratic.

Module sec_2_3_concl_2_mean.
Import GbtDevelopable.Section_2_3.sec_2_3_concl_2_mean.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G b]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_3_concl_2_mean.
