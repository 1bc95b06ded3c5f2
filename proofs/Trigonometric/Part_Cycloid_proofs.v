(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Cycloid.
Import Trigonometric.Part_Cycloid.Definitions.
Open Scope R_scope.

Module cycloid_speed.
Import Trigonometric.Part_Cycloid.cycloid_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_speed.

Module cycloid_regular.
Import Trigonometric.Part_Cycloid.cycloid_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; compute_goal; intros t [P L]; derivatives; assert (S : 0 < sin (t / 2)) by (apply sin_gt_0; lra); assert (C : cos t < 1) by (replace t with (2 * (t / 2)) by field; rewrite cos_2a_sin; nra); pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c C s E; nra. Qed.
Theorem met : instance.
Proof. exists PI; pose proof PI_RGT_0; lra. Qed.
End cycloid_regular.

Module cycloid_slope.
Import Trigonometric.Part_Cycloid.cycloid_slope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_slope.

Module cycloid_slope_slip.
Import Trigonometric.Part_Cycloid.cycloid_slope_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X] in no; refuting (no (1/3*PI)). Qed.
End cycloid_slope_slip.

Module cycloid_slope_slip_corrected.
Import Trigonometric.Part_Cycloid.cycloid_slope_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_slope_slip_corrected.

Module cycloid_bend.
Import Trigonometric.Part_Cycloid.cycloid_bend.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; compute_goal; intros t [P L]; derivatives; assert (S : 0 < sin (t / 2)) by (apply sin_gt_0; lra); assert (C : cos t < 1) by (replace t with (2 * (t / 2)) by field; rewrite cos_2a_sin; nra); pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c C s E; nra. Qed.
Theorem met : instance.
Proof. exists PI; pose proof PI_RGT_0; lra. Qed.
End cycloid_bend.

Module cycloid_curvature.
Import Trigonometric.Part_Cycloid.cycloid_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X]; first [(exists ((2 / 3) * PI); met) | (exists (1 * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met) | (exists ((2 / 3) * PI); met)]. Qed.
End cycloid_curvature.
