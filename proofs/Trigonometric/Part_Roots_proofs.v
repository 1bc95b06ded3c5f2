(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Roots.
Import Trigonometric.Part_Roots.Definitions.
Open Scope R_scope.

Module helix_length.
Import Trigonometric.Part_Roots.helix_length.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros h r t H A _; assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F]); exact L. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 1, 0; repeat split; lra. Qed.
End helix_length.

Module helix_bend.
Import Trigonometric.Part_Roots.helix_bend.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros h r t H A _ N; assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F]); assert (M : norm (cross (vDerive 3 (fun t_ => X h r t_) 1 t) (vDerive 3 (fun t_ => X h r t_) 2 t)) = r * sqrt (r ^ 2 + h ^ 2)) by (transitivity (sqrt (r ^ 2 * (r ^ 2 + h ^ 2))); [ cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F] | rewrite sqrt_mult by nra; rewrite sqrt_pow2 by lra; reflexivity ]); rewrite L, M; assert (Q : 0 < r ^ 2 + h ^ 2) by nra; pose proof (sqrt_lt_R0 _ Q); assert (E : sqrt (r ^ 2 + h ^ 2) ^ 2 = r ^ 2 + h ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra); rewrite <- E at 3; field; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 1, 0; assert (L : forall h r t, norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (intros h r t; assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F]); exact L); rewrite L; assert (0 < sqrt (1 ^ 2 + 1 ^ 2)) by (apply sqrt_lt_R0; lra); repeat split; try lra; apply pow_nonzero; lra. Qed.
End helix_bend.

Module helix_bend_slip.
Import Trigonometric.Part_Roots.helix_bend_slip.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; pose (h := 1); pose (r := 1); pose (t := 0); generalize (no h r t); clear no; assert (A : 0 < r) by (subst r; lra); assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F]); assert (M : norm (cross (vDerive 3 (fun t_ => X h r t_) 1 t) (vDerive 3 (fun t_ => X h r t_) 2 t)) = r * sqrt (r ^ 2 + h ^ 2)) by (transitivity (sqrt (r ^ 2 * (r ^ 2 + h ^ 2))); [ cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F] | rewrite sqrt_mult by nra; rewrite sqrt_pow2 by lra; reflexivity ]); rewrite L, M; subst h r t; intro no; assert (Q : 0 < 1 ^ 2 + 1 ^ 2) by lra; pose proof (sqrt_lt_R0 _ Q) as S; assert (E : sqrt (1 ^ 2 + 1 ^ 2) ^ 2 = 1 ^ 2 + 1 ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra); assert (C := no ltac:(lra) ltac:(lra) ltac:(apply pow_nonzero; lra) ltac:(apply pow_nonzero; lra)); clear no L M; revert C; match goal with |- ?a = ?b -> False => replace a with (1 / sqrt (1 ^ 2 + 1 ^ 2) ^ 2) by (field; lra); rewrite E end; lra. Qed.
End helix_bend_slip.

Module cylinder_normal.
Import Trigonometric.Part_Roots.cylinder_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; intros r t v A N; assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); rewrite L; clear N L; cbv beta delta [Z_]; compute_goal; derivatives; parts; field; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 0, 0; assert (L : forall r t v, 0 < r -> norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (intros r t v ?; assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); exact L); rewrite L by lra; repeat split; lra. Qed.
End cylinder_normal.

Module cylinder_offset.
Import Trigonometric.Part_Roots.cylinder_offset.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros h r t v H A N; assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); rewrite L; clear N L; cbv beta delta [Z_]; compute_goal; derivatives; parts; field; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 1, 0, 0; assert (L : forall r t v, 0 < r -> norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (intros r t v ?; assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E; assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); exact L); rewrite L by lra; repeat split; lra. Qed.
End cylinder_offset.
