(* Scripts of theorems of trigonometric whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* trigonometric/angle.known *)
Theorem proved.
Proof.
  cbv beta delta [statement]; replace (PI / 12) with (PI / 3 - PI / 4) by field;
  rewrite sin_minus, sin_PI3, cos_PI3, sin_PI4, cos_PI4; replace 6 with (2 * 3) by ring;
  rewrite sqrt_mult by lra; pose proof (sqrt_lt_R0 2 ltac:(lra));
  assert (E : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra); generalize dependent (sqrt 2); intros a A E;
  apply (Rmult_eq_reg_l a); [ | lra ]; field_simplify_eq; [ ring [E] | lra ].
Qed.

(* trigonometric/angle.parts *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros y z; replace (sin y) with (sin ((y / 2 + z / 3) + (y / 2 - z / 3))) by
  (f_equal; field); replace (sin (2 * z / 3)) with (sin ((y / 2 + z / 3) - (y / 2 - z / 3))) by (f_equal;
    field); rewrite (sin_plus (y / 2 + z / 3) (y / 2 - z / 3)), (sin_minus (y / 2 + z / 3) (y / 2 - z / 3));
  ring.
Qed.

(* trigonometric/angle.symmetric *)
Theorem met.
Proof.
  exists 0; pose proof PI_RGT_0; lra.
Qed.

(* trigonometric/angle.symmetric *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros u [A B]; apply Rle_ge; rewrite <- cos_PI3; pose proof PI_RGT_0;
  destruct (Rle_or_lt 0 u) as [C|C]; [ apply cos_decr_1; lra | rewrite <- (cos_neg u); apply cos_decr_1; lra ].
Qed.

(* trigonometric/angle.third *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intro y; replace (sin y) with (sin (y / 3 + y / 3 + y / 3)) by (f_equal; field);
  rewrite !sin_plus, !cos_plus; pose proof (sin2_cos2 (y / 3)) as E; unfold Rsqr in E;
  generalize dependent (sin (y / 3)); generalize dependent (cos (y / 3)); intros c s E;
  assert (F : c * c = 1 - s * s) by lra; ring [F].
Qed.

(* trigonometric/cycloid.bend *)
Theorem met.
Proof.
  exists PI; pose proof PI_RGT_0; lra.
Qed.

(* trigonometric/cycloid.bend *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement X]; compute_goal; intros t [P L]; derivatives;
  assert (S : 0 < sin (t / 2)) by (apply sin_gt_0; lra);
  assert (C : cos t < 1) by (replace t with (2 * (t / 2)) by field; rewrite cos_2a_sin; nra);
  pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t);
  intros c C s E; nra.
Qed.

(* trigonometric/cycloid.regular *)
Theorem met.
Proof.
  exists PI; pose proof PI_RGT_0; lra.
Qed.

(* trigonometric/cycloid.regular *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement X]; compute_goal; intros t [P L]; derivatives;
  assert (S : 0 < sin (t / 2)) by (apply sin_gt_0; lra);
  assert (C : cos t < 1) by (replace t with (2 * (t / 2)) by field; rewrite cos_2a_sin; nra);
  pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t);
  intros c C s E; nra.
Qed.

(* trigonometric/cylinder.normal *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 0, 0;
  assert (L : forall r t v, 0 < r -> norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ =>
          Z_ r t v_) 1 v)) = r) by (intros r t v ?;
    assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r)
    by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
      generalize dependent (sin t); generalize dependent (cos t); intros c s E;
      assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); exact L);
  rewrite L by lra; repeat split; lra.
Qed.

(* trigonometric/cylinder.normal *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement N_]; intros r t v A N;
  assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by
  (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
    generalize dependent (sin t); generalize dependent (cos t); intros c s E;
    assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); rewrite L; clear N L;
  cbv beta delta [Z_]; compute_goal; derivatives; parts; field; lra.
Qed.

(* trigonometric/cylinder.offset *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 1, 0, 0;
  assert (L : forall r t v, 0 < r -> norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ =>
          Z_ r t v_) 1 v)) = r) by (intros r t v ?;
    assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r)
    by (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
      generalize dependent (sin t); generalize dependent (cos t); intros c s E;
      assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); exact L);
  rewrite L by lra; repeat split; lra.
Qed.

(* trigonometric/cylinder.offset *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros h r t v H A N;
  assert (L : norm (cross (vDerive 3 (fun t_ => Z_ r t_ v) 1 t) (vDerive 3 (fun v_ => Z_ r t v_) 1 v)) = r) by
  (cbv beta delta [norm Z_]; compute_goal; derivatives; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
    generalize dependent (sin t); generalize dependent (cos t); intros c s E;
    assert (F : c * c = 1 - s * s) by lra; apply sqrt_lem_1; [ nra | lra | ring [F] ]); rewrite L; clear N L;
  cbv beta delta [Z_]; compute_goal; derivatives; parts; field; lra.
Qed.

(* trigonometric/helix.bend *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 1, 0;
  assert (L : forall h r t, norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (intros h r
    t; assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm
        X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
      generalize dependent (sin t); generalize dependent (cos t); intros c s E;
      assert (F : c * c = 1 - s * s) by lra; ring [F]); exact L); rewrite L;
  assert (0 < sqrt (1 ^ 2 + 1 ^ 2)) by (apply sqrt_lt_R0; lra); repeat split; try lra; apply pow_nonzero; lra.
Qed.

(* trigonometric/helix.bend *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros h r t H A _ N;
  assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X];
    compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
    generalize dependent (sin t); generalize dependent (cos t); intros c s E;
    assert (F : c * c = 1 - s * s) by lra; ring [F]);
  assert (M : norm (cross (vDerive 3 (fun t_ => X h r t_) 1 t) (vDerive 3 (fun t_ => X h r t_) 2 t)) = r *
    sqrt (r ^ 2 + h ^ 2)) by (transitivity (sqrt (r ^ 2 * (r ^ 2 + h ^ 2)));
    [ cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E;
      unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E;
      assert (F : c * c = 1 - s * s) by lra; ring [F] | rewrite sqrt_mult by nra; rewrite sqrt_pow2 by lra;
      reflexivity ]); rewrite L, M; assert (Q : 0 < r ^ 2 + h ^ 2) by nra; pose proof (sqrt_lt_R0 _ Q);
  assert (E : sqrt (r ^ 2 + h ^ 2) ^ 2 = r ^ 2 + h ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra);
  rewrite <- E at 3; field; lra.
Qed.

(* trigonometric/helix.bend.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; pose (h := 1); pose (r := 1); pose (t := 0);
  generalize (no h r t); clear no; assert (A : 0 < r) by (subst r; lra);
  assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X];
    compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
    generalize dependent (sin t); generalize dependent (cos t); intros c s E;
    assert (F : c * c = 1 - s * s) by lra; ring [F]);
  assert (M : norm (cross (vDerive 3 (fun t_ => X h r t_) 1 t) (vDerive 3 (fun t_ => X h r t_) 2 t)) = r *
    sqrt (r ^ 2 + h ^ 2)) by (transitivity (sqrt (r ^ 2 * (r ^ 2 + h ^ 2)));
    [ cbv beta delta [norm X]; compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E;
      unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t); intros c s E;
      assert (F : c * c = 1 - s * s) by lra; ring [F] | rewrite sqrt_mult by nra; rewrite sqrt_pow2 by lra;
      reflexivity ]); rewrite L, M; subst h r t; intro no; assert (Q : 0 < 1 ^ 2 + 1 ^ 2) by lra;
  pose proof (sqrt_lt_R0 _ Q) as S; assert (E : sqrt (1 ^ 2 + 1 ^ 2) ^ 2 = 1 ^ 2 + 1 ^ 2) by (rewrite <-
    Rsqr_pow2; apply Rsqr_sqrt; lra); assert (C := no ltac:(lra) ltac:(lra) ltac:(apply pow_nonzero;
      lra) ltac:(apply pow_nonzero; lra)); clear no L M; revert C;
  match goal with |- ?a = ?b -> False => replace a with (1 / sqrt (1 ^ 2 + 1 ^ 2) ^ 2) by (field; lra);
  rewrite E end; lra.
Qed.

(* trigonometric/helix.length *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 1, 0; repeat split; lra.
Qed.

(* trigonometric/helix.length *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros h r t H A _;
  assert (L : norm (vDerive 3 (fun t_ => X h r t_) 1 t) = sqrt (r ^ 2 + h ^ 2)) by (cbv beta delta [norm X];
    compute_goal; derivatives; f_equal; pose proof (sin2_cos2 t) as E; unfold Rsqr in E;
    generalize dependent (sin t); generalize dependent (cos t); intros c s E;
    assert (F : c * c = 1 - s * s) by lra; ring [F]); exact L.
Qed.

(* trigonometric/helix.regular *)
Theorem met.
Proof.
  exists 1, 1, 0; lra.
Qed.

(* trigonometric/helix.regular *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement X]; compute_goal; intros h r t H A; derivatives;
  pose proof (sin2_cos2 t) as E; unfold Rsqr in E; generalize dependent (sin t); generalize dependent (cos t);
  intros c s E; assert (F : c * c = 1 - s * s) by lra;
  apply Rlt_gt, Rlt_le_trans with (r * r * (h * h + r * r));
  [ repeat apply Rmult_lt_0_compat; nra | right; ring [F] ].
Qed.

(* trigonometric/quadratic.decreasing *)
Theorem met.
Proof.
  exists 0, 0; pose proof PI_RGT_0; lra.
Qed.

(* trigonometric/quadratic.decreasing *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a]; intros l t L [A B]; derivatives; pose proof PI_RGT_0;
  assert (S : 0 <= sin t) by (apply sin_ge_0; lra); assert (C : 0 <= cos t) by (apply cos_ge_0; lra);
  pose proof (SIN_bound t) as [_ S1]; generalize dependent (sin t); generalize dependent (cos t);
  intros c C s S S1; assert (0 <= c * ((1 + l) * (1 - s) + (1 - l) * s)) by (apply Rmult_le_pos;
    [ exact C | apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra ]); lra.
Qed.

(* trigonometric/quadratic.join *)
Theorem met.
Proof.
  cbv beta zeta delta [instance G F G_ a b c a_ b_ c_]; exists (fun _ => 0), (fun _ => 0), 0, 0, 0, 0;
  repeat split; try lra; derivatives; ring.
Qed.

(* trigonometric/quadratic.join *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement G F G_ a b c a_ b_ c_]; intros P R_ l l2 m m2 _ _ _ _; derivatives;
  rewrite ?sin_0, ?cos_0, ?sin_PI2, ?cos_PI2; intros A B N; apply (Rmult_eq_reg_l (1 + l2));
  [ replace ((1 + l2) * (P 2%Z + (1 + m) / (1 + l2) * (P 2%Z - P 1%Z))) with ((1 + l2) * P 2%Z + (1 + m) * (P
        2%Z - P 1%Z)) by (field; exact N); assert (E : R_ 0%Z = P 2%Z) by lra; rewrite E in B; lra | exact N ].
Qed.
