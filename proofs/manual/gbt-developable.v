(* Scripts of theorems of gbt-developable whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* gbt-developable/abs-conics.planes *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; apply (no 0 ltac:(lra)); clear no; intros u U _;
  assert (D : vDerive 4 (fun u_ => bernstein_family u_) 1 u = [- 2 * u; 2; 0;
      2 * u]) by (cbv delta [bernstein_family]; lists; parts; apply is_derive_unique; auto_derive;
    try exact I; ring); assert (V : bernstein_family u = [1 - u * u; 2 * u; 0;
      1 + u * u]) by (cbv delta [bernstein_family]; lists; parts; ring);
  cbv delta [profile foot direction moment normal]; cbv beta; rewrite D, V;
  assert (X : 1 + u * u <> 0) by nra; lists; split; field; (try exact X); nra.
Qed.

(* gbt-developable/alg-5.4.iterate *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement c cl ck beta c3 g H2 H1 H2_ H1_ H3 H3_]; sums_at_ends; intros P1 P2 P3;
  intros; conjuncts; [ rewritten; members; field; nonzero | rewritten; members; field; nonzero | rewritten;
    members; field; nonzero | assumption | repeat match goal with H : P3 ?i = _ |- context [P3 ?i] => rewrite
    H end; members; field; nonzero | repeat match goal with H : P3 ?i = _ |- context [P3 ?i] => rewrite H end;
    members; field; nonzero ].
Qed.

(* gbt-developable/alg-5.4.s1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros k l P2 mu1 mu2 nu1 nu2 _ K _ _ _ _ _ L _ _ _;
  assert (E : matrix P2 l mu2 nu2 = _) by exact (start_matrix P2 l mu2 nu2 K); rewrite E, L; lists; conjuncts;
  derivatives; field.
Qed.

(* gbt-developable/alg-5.4.s2.surfaces *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement g H1 H1_ H2 H2_ normal direction] in no;
  refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool
      then (1) else 0) (fun i0 => if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0)
    (fun i0 => if (Z.eqb i0 (2))%bool then (1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if
      (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0
        (1))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then
      (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else 0) (fun
      i0 => if (Z.eqb i0 (0))%bool then (0) else 0) (0) (1) (1) (0)).
Qed.

(* gbt-developable/alg-5.4.s3 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ c];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/eq-2.3 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g G]; intros;
  rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1
          - sin (PI / 2 * x)) * sin (PI / 2 * x) * (R_ (i + 1)%Z - R_ i)))) by (intros; ring);
  rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring.
Qed.

(* gbt-developable/eq-2.4 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g G]; intros; rewrite from_one;
  rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * ((1
          - cos (PI / 2 * x)) * cos (PI / 2 * x) * (R_ (i + 1)%Z - R_ (i + 2)%Z)))) by (intros i I;
    replace (i + 1 - 1)%Z with i by lia; replace (k - 1 - (i + 1))%Z with (k - 2 - i)%Z by lia;
    replace (i + 1 + 1)%Z with (i + 2)%Z by lia; ring); rewrite binomial_form by assumption; derivatives;
  apply pw_ext; intro; unfold seed3; ring.
Qed.

(* gbt-developable/eq-3.10 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal];
  exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0; split;
  [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split;
    [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|apply filter_forall; intro e;
      lists; rewrite ?cubic_rate, ?cubic_second; match goal with |- ?d <> 0 => replace d with 1 by field;
      lra end]].
Qed.

(* gbt-developable/eq-3.10 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H into D, H0 into N; clear - D N;
  assert (SV : vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3''
      a3''' e) 1 (IZR 0) = vscale (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3''
      a3''' / det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2) (phi a0 a0' a1 a1' a2 a2')) by (pose proof
    (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') (fun e => a1 + e * a1' + e
        ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''')
      (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0' a0'' a0''')
      (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3'' a3''') 0) as
    T; cbv beta iota zeta delta [map seq app] in T;
    rewrite (cubic_start a0 a0' a0'' a0''' : Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 *
        a0''') 0 0 = a0), (taylor_start_rate a0 a0' a0'' a0''' : Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 *
        a0'' + e ^ 3 / 6 * a0''') 1 0 = a0'), (taylor_start_second a0 a0' a0'' a0''' : Derive_n (fun e => a0 +
        e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') 2 0 = a0''), (cubic_third a0 a0' a0'' a0''' 0 :
      Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') 3 0 = a0'''), (cubic_start a1
      a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') 0 0 = a1),
    (taylor_start_rate a1 a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 *
        a1''') 1 0 = a1'), (taylor_start_second a1 a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 /
        2 * a1'' + e ^ 3 / 6 * a1''') 2 0 = a1''), (cubic_third a1 a1' a1'' a1''' 0 : Derive_n (fun e => a1 +
        e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') 3 0 = a1'''), (cubic_start a2 a2' a2'' a2''' :
      Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') 0 0 = a2), (taylor_start_rate a2
      a2' a2'' a2''' : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') 1 0 = a2'),
    (taylor_start_second a2 a2' a2'' a2''' : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 *
        a2''') 2 0 = a2''), (cubic_third a2 a2' a2'' a2''' 0 : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 *
        a2'' + e ^ 3 / 6 * a2''') 3 0 = a2'''), (cubic_start a3 a3' a3'' a3''' : Derive_n (fun e => a3 + e *
        a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 0 0 = a3), (taylor_start_rate a3 a3' a3'' a3''' : Derive_n
      (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 1 0 = a3'), (taylor_start_second a3 a3'
      a3'' a3''' : Derive_n (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 2 0 = a3''),
    (cubic_third a3 a3' a3'' a3''' 0 : Derive_n (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''')
      3 0 = a3''') in T; exact (T D)); assert (SP : forall a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' :
    R, det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 -> dot (a a0 a1 a2) (S_ a0 a0' a0'' a1 a1' a1''
      a2 a2' a2'' a3 a3' a3'') = a3 /\ dot (a' a0' a1' a2') (S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3'
      a3'') = a3') by (clear; intros a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' D; unfold S_;
    assert (Q : forall a b c x y z d, d <> 0 -> dot [a; b;
        c] (vdiv [x; y; z] d) = (a * x + (b * y + c * z)) / d) by (clear; intros; lists; field; assumption);
    split; refine (eq_trans (Q _ _ _ _ _ _ _ D) _); apply quotient_is;
    [exact D|clear; cbv beta delta [cramer1 cramer2 cramer3 system a a' a'']; lists; ring|exact D|clear;
      cbv beta delta [cramer1 cramer2 cramer3 system a a' a'']; lists; ring]);
  destruct (SP _ _ _ _ _ _ _ _ _ a3 a3' a3'' D) as [P1 P2]; clear SP; cbv beta zeta delta [V]; rewrite SV;
  clear SV; assert (O : forall p q r s t u v w z k l : R, dot [p; q;
      r] (vadd [s; t; u] (vscale k (vscale l [v; w; z]))) = dot [p; q; r] [s; t; u] + k * l * dot [p; q;
      r] [v; w; z]) by (clear; intros; lists; ring); split;
  [refine (eq_trans (O _ _ _ _ _ _ _ _ _ _ _) _);
    refine (eq_trans (f_equal2 Rplus P1 (f_equal _ (_ : dot (a a0 a1 a2) (phi a0 a0' a1 a1' a2 a2') = 0))) _);
    [clear; cbv beta delta [phi a a']; lists; ring|clear; ring]|split;
    [refine (eq_trans (O _ _ _ _ _ _ _ _ _ _ _) _);
      refine (eq_trans (f_equal2 Rplus P2 (f_equal _ (_ : dot (a' a0' a1' a2') (phi a0 a0' a1 a1' a2 a2') =
              0))) _); [clear; cbv beta delta [phi a a']; lists; ring|clear; ring]|]]; clear O P1 P2;
  generalize dependent (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2''));
  generalize dependent (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''');
  intros m M l L; cbv beta iota delta [vscale map phi cross];
  refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); apply scaled_back;
  assumption.
Qed.

(* gbt-developable/eq-3.6 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring.
Qed.

(* gbt-developable/eq-3.8 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring.
Qed.

(* gbt-developable/eq-3.9 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g HT normal W F]; lists; intros; parts; spread; ring.
Qed.

(* gbt-developable/ex-4.1.c1.a *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E1 E1_ 0%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.1.c1.a *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z; lines ().
Qed.

(* gbt-developable/ex-4.1.c1.b *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E1 E1_ 1%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.1.c1.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; line_at E1 E1_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.1.c1.c *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; line_at E1 E1_ 1%Z; intro no;
  specialize (no 0 0 ltac:(lra) ltac:(lra)); revert no; compute_goal; derivatives; pose proof PI_RGT_0; nra.
Qed.

(* gbt-developable/ex-4.1.c1.d *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no;
  line_at E1 E1_ 0%Z; compute_goal; intros; derivatives; ring.
Qed.

(* gbt-developable/ex-4.1.c1.e *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; line_at E1 E1_ 0%Z; intro no;
  specialize (no 0 0 ltac:(lra) ltac:(lra)); revert no; compute_goal; derivatives; pose proof PI_RGT_0; nra.
Qed.

(* gbt-developable/ex-4.1.c1.f.there and nowhere else *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not len len_]; change E1__ with (fun mu n => E1 mu (IZR n));
  change E1___ with (fun mu n => E1_ mu (IZR n)); cbv beta; line_at E1 E1_ 0%Z; intro no;
  apply (Rlt_irrefl _ (no 0 0 ltac:(lra) ltac:(lra))).
Qed.

(* gbt-developable/ex-4.1.c2.a *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E1 E1_ 0%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.1.c2.a *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E1__ E1___ E1 E1_; line_at E1 E1_ 0%Z; lines ().
Qed.

(* gbt-developable/ex-4.1.c2.b *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E1 E1_ 1%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.1.c2.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E1__ E1___ E1 E1_; line_at E1 E1_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.1.c2.c *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no;
  line_at E1 E1_ 1%Z; compute_goal; intros; derivatives; ring.
Qed.

(* gbt-developable/ex-4.1.c2.d *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; line_at E1 E1_ 1%Z; intro no;
  specialize (no 0 0 ltac:(lra) ltac:(lra)); revert no; compute_goal; derivatives; pose proof PI_RGT_0; nra.
Qed.

(* gbt-developable/ex-4.1.c2.e.there and nowhere else *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not len len_]; change E1__ with (fun nu n => E1 nu (IZR n));
  change E1___ with (fun nu n => E1_ nu (IZR n)); cbv beta; line_at E1 E1_ 1%Z; intro no;
  apply (Rlt_irrefl _ (no 0 0 ltac:(lra) ltac:(lra))).
Qed.

(* gbt-developable/ex-4.1.c3.a *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no;
  one_curve E1__ E1___ E1 E1_; line_at E1 E1_ 0%Z; line_at E1 E1_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.1.c3.b *)
Theorem met.
Proof.
  cbv delta [instance]; exists 0; lra.
Qed.

(* gbt-developable/ex-4.1.c3.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement not]; line_at E1 E1_ 0%Z; line_at E1 E1_ 1%Z; compute_goal; intros nu N;
  split; intro no; specialize (no 0 ltac:(lra)); revert no; derivatives; pose proof PI_RGT_0; nra.
Qed.

(* gbt-developable/ex-4.1.c3.c *)
Theorem met.
Proof.
  cbv delta [instance]; exists 0; lra.
Qed.

(* gbt-developable/ex-4.1.c3.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z; line_at E1 E1_ 1%Z; compute_goal; intros; split;
  derivatives; pose proof PI_RGT_0; nra.
Qed.

(* gbt-developable/ex-4.1.c3.d *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; assert (M : forall n, E1 n n (1 / 2) = [0; 0;
      (20 - 10 * (1 - 1 / sqrt 2) * (1 - n * (1 / sqrt 2))); 400]) by (intro n;
    cbv delta [E1 g E1_0 E1_1 E1_2 E1_3]; compute_goal; replace (PI / 2 * (1 / 2)) with (PI / 4) by field;
    rewrite sin_PI4, cos_PI4;  generalize (1 / sqrt 2); intro s; parts; field);
  assert (I : 1 / 2 < 1 / sqrt 2 < 3 / 4) by (assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
    pose proof (Rlt_sqrt2_0); assert (4 / 3 < sqrt 2 < 2) by (split; nra); split;
    [apply (Rmult_lt_reg_r (sqrt 2)); [lra|unfold Rdiv at 2; rewrite Rmult_assoc, Rinv_l;
        lra]|apply (Rmult_lt_reg_r (sqrt 2)); [lra|unfold Rdiv at 1; rewrite Rmult_assoc, Rinv_l; lra]]);
  assert (K : forall n, exists v, vDerive 4 (fun x => E1 n n x) 1 (1 / 2) = [0;
      (20 * (1 - (1 - (1 / sqrt 2)) * (1 - n * (1 / sqrt 2))) + 15 * PI * (1 / sqrt 2) * (1 + n - 2 * n * (1 /
            sqrt 2))); v; 0]) by (intro n; eexists; cbv delta [E1 g E1_0 E1_1 E1_2 E1_3]; lists;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _) _
            eq_refl))));  [rewrite (Derive_n_ext _ (fun _ => 0)) by (intro; ring);
      apply rate_const|compute_goal; apply is_derive_unique; auto_derive;
      [exact Logic.I|replace (PI / 2 * (1 / 2)) with (PI / 4) by field;
        rewrite sin_PI4, cos_PI4;  generalize (1 / sqrt 2); intro s;
        field]|rewrite (Derive_n_ext _ (fun _ => 400)) by (intro; compute_goal; ring); apply rate_const]);
  assert (T : forall n, -1 < n < 1 -> dot (direction (E1 n n (1 / 2)) (vDerive 4 (fun x => E1 n n x) 1 (1 /
          2))) (direction (E1 n n (1 / 2)) (vDerive 4 (fun x => E1 n n x) 1 (1 / 2))) <> 0) by (intros n N;
    destruct (K n) as (v & U); rewrite M, U; clear M K U; generalize dependent (1 / sqrt 2); intros s I;
    assert (X : 0 < 20 - 10 * (1 - s) * (1 - n * s)) by nra;
    assert (Y : 0 < (20 * (1 - (1 - s) * (1 - n * s)) + 15 * PI * s * (1 + n - 2 * n * s))) by (pose proof
      PI_RGT_0; assert (- (3 / 4) < n * s < 3 / 4) by (split; nra);
      assert (0 < (s - 1 / 2) * (1 - n * s)) by nra; assert (0 < 1 - (1 - s) * (1 - n * s)) by lra;
      assert (0 < 1 + n - 2 * n * s) by nra; assert (0 < PI * s) by nra;
      assert (0 < PI * s * (1 + n - 2 * n * s)) by (apply Rmult_lt_0_compat; assumption); lra);
    generalize dependent (20 * (1 - (1 - s) * (1 - n * s)) + 15 * PI * s * (1 + n - 2 * n * s)); intros q Y;
    generalize dependent (20 - 10 * (1 - s) * (1 - n * s)); intros r X; cbv delta [direction normal]; lists;
    assert (0 < r * q) by nra; apply Rgt_not_eq; nra);
  assert (T0 : forall n, -1 < n < 1 -> dot (direction (E1_ n n 0%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 0)))
    (direction (E1_ n n 0%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 0))) <> 0) by (intros n N;
    assert (S : E1_ n n 0%Z = E1_0) by exact (vector_start_value n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl
      eq_refl); assert (S' : vDerive 4 (fun x => E1 n n x) 1 (IZR 0) = vscale (1 + PI / 2 * (1 + n)) (vsub
        E1_1 E1_0)) by exact (vector_start_rate n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl);
    rewrite S, S'; clear S S'; assert (0 < 1 + PI / 2 * (1 + n)) by (pose proof PI_RGT_0; nra);
    generalize dependent (1 + PI / 2 * (1 + n)); intros k HK;
    cbv delta [direction normal E1_0 E1_1 E1_2 E1_3]; lists; apply Rgt_not_eq;
    nra);  assert (T1 : forall n, -1 < n < 1 -> dot (direction (E1_ n n 1%Z) (vDerive 4 (fun x => E1 n n x) 1
        (IZR 1))) (direction (E1_ n n 1%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 1))) <> 0) by (intros n N;
    assert (S : E1_ n n 1%Z = E1_3) by exact (vector_end_value n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl
      eq_refl); assert (S' : vDerive 4 (fun x => E1 n n x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + n)) (vsub
        E1_3 E1_2)) by exact (vector_end_rate n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl);
    rewrite S, S'; clear S S'; assert (0 < 1 + PI / 2 * (1 + n)) by (pose proof PI_RGT_0; nra);
    generalize dependent (1 + PI / 2 * (1 + n)); intros k HK;
    cbv delta [direction normal E1_0 E1_1 E1_2 E1_3]; lists; apply Rgt_not_eq; nra);  exists 0; split;
  [lra|split; [|split; [|split]]]; exists (mkposreal 1 Rlt_0_1); intros n B;
  assert (N : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball]; simpl;
    cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B; lra);  cbv beta; auto.
Qed.

(* gbt-developable/ex-4.1.c3.d *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement height other]; intros nu N A B A' B';
  assert (M : forall n, E1 n n (1 / 2) = [0; 0; (20 - 10 * (1 - 1 / sqrt 2) * (1 - n * (1 / sqrt 2)));
      400]) by (intro n; cbv delta [E1 g E1_0 E1_1 E1_2 E1_3]; compute_goal;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite sin_PI4, cos_PI4;  generalize (1 / sqrt 2);
    intro s; parts; field); assert (K : forall n, exists u v, vDerive 4 (fun x => E1 n n x) 1 (1 / 2) = [0; u;
      v; 0]) by (intro n; eexists; eexists; cbv delta [E1 g E1_0 E1_1 E1_2 E1_3]; lists;
    refine (f_equal2 (@cons _) _ _); [|refine (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _) eq_refl
          (f_equal2 (@cons _) _ eq_refl)))];  [rewrite (Derive_n_ext _ (fun _ => 0)) by (intro;
        ring)|rewrite (Derive_n_ext _ (fun _ => 400)) by (intro; compute_goal; ring)]; apply rate_const);
  assert (T : forall n, dot (direction (E1 n n (1 / 2)) (vDerive 4 (fun x => E1 n n x) 1 (1 / 2))) (direction
      (E1 n n (1 / 2)) (vDerive 4 (fun x => E1 n n x) 1 (1 / 2))) <> 0 -> entry (foot (E1 n n (1 / 2))
      (vDerive 4 (fun x => E1 n n x) 1 (1 / 2))) 3 = 400 / (20 - 10 * (1 - 1 / sqrt 2) * (1 - n * (1 / sqrt
          2)))) by (intro n; destruct (K n) as (u & v & U); rewrite M, U;
    generalize (20 - 10 * (1 - 1 / sqrt 2) * (1 - n * (1 / sqrt 2))); intro r;
    cbv delta [foot direction moment normal]; lists; intro Z; field; split; intro Y; apply Z; rewrite Y;
    ring);  assert (T0 : forall n, dot (direction (E1_ n n 0%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 0)))
    (direction (E1_ n n 0%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 0))) <> 0 -> entry (foot (E1_ n n 0%Z)
      (vDerive 4 (fun x => E1 n n x) 1 (IZR 0))) 3 = 40 / 3) by (intro n;  assert (S : E1_ n n 0%Z = E1_0) by
    exact (vector_start_value n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl);
    assert (S' : vDerive 4 (fun x => E1 n n x) 1 (IZR 0) = vscale (1 + PI / 2 * (1 + n)) (vsub E1_1 E1_0)) by
    exact (vector_start_rate n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl); rewrite S, S';
    clear S S'; generalize (1 + PI / 2 * (1 + n)); intro k;
    cbv delta [foot direction moment normal E1_0 E1_1 E1_2 E1_3]; lists; intro Z; field; repeat split;
    intro Y; apply Z; replace k with 0 by lra;
    ring);  assert (T1 : forall n, dot (direction (E1_ n n 1%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 1)))
    (direction (E1_ n n 1%Z) (vDerive 4 (fun x => E1 n n x) 1 (IZR 1))) <> 0 -> entry (foot (E1_ n n 1%Z)
      (vDerive 4 (fun x => E1 n n x) 1 (IZR 1))) 3 = 40 / 3) by (intro n;  assert (S : E1_ n n 1%Z = E1_3) by
    exact (vector_end_value n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl);
    assert (S' : vDerive 4 (fun x => E1 n n x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + n)) (vsub E1_3 E1_2)) by
    exact (vector_end_rate n n E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl); rewrite S, S';
    clear S S'; generalize (1 + PI / 2 * (1 + n)); intro k;
    cbv delta [foot direction moment normal E1_0 E1_1 E1_2 E1_3]; lists; intro Z; field; repeat split;
    intro Y; apply Z; replace k with 0 by lra;
    ring);  assert (I : 1 / 2 < 1 / sqrt 2 < 1) by (assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt;
      lra); pose proof (Rlt_sqrt2_0); assert (1 < sqrt 2 < 2) by (split; nra); split;
    [apply (Rmult_lt_reg_r (sqrt 2)); [lra|unfold Rdiv at 2; rewrite Rmult_assoc, Rinv_l;
        lra]|apply (Rmult_lt_reg_r (sqrt 2)); [lra|unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra]]);
  clear M K; revert T T0 T1 I; generalize (1 / sqrt 2); intros s T T0 T1 I;
  assert (W : 0 < 20 - 10 * (1 - s) * (1 - nu * s)) by nra;
  assert (V : is_derive (fun n => 400 / (20 - 10 * (1 - s) * (1 - n * s)) - 40 / 3) nu (- (4000 * (1 - s) * s
        / (20 - 10 * (1 - s) * (1 - nu * s)) ^ 2))) by (auto_derive; [lra|field; lra]);
  assert (Y : - (4000 * (1 - s) * s / (20 - 10 * (1 - s) * (1 - nu * s)) ^ 2) < 0) by (assert (0 < 4000 * (1 -
        s) * s / (20 - 10 * (1 - s) * (1 - nu * s)) ^ 2);
    [apply Rdiv_lt_0_compat; [nra|apply pow_lt; exact W]|lra]); split;
  refine (Rle_lt_trans _ _ _ (Req_le _ _ _) Y); apply is_derive_unique;
  refine (is_derive_ext_loc _ _ _ _ _ V); [generalize (filter_and _ _ A B)|generalize (filter_and _ _ A' B')];
  apply filter_imp; intros n [E F]; cbv beta; symmetry; [rewrite (T n E), (T0 n F)|rewrite (T n E), (T1 n F)];
  reflexivity.
Qed.

(* gbt-developable/ex-4.1.lengths *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z; line_at E1 E1_ 1%Z; compute_goal; intros; split; field.
Qed.

(* gbt-developable/ex-4.1.lengths.exchanged *)
Theorem met.
Proof.
  cbv delta [instance]; exists 0, 0; lra.
Qed.

(* gbt-developable/ex-4.1.lengths.exchanged *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E1__ E1___ E1 E1_; line_at E1 E1_ 0%Z; line_at E1 E1_ 1%Z;
  compute_goal; intros; conjuncts; derivatives; pose proof PI_RGT_0; first [ solve [field] | nra ].
Qed.

(* gbt-developable/ex-4.2.c1.a *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no;
  line_at E2 E2_ 1%Z; compute_goal; intros; derivatives; atoms; equal.
Qed.

(* gbt-developable/ex-4.2.c1.b *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E2 E2_ 1%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c1.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c1.c *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; line_at E2 E2_ 0%Z; exists 0, 0; compute_goal; conjuncts;
  first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c1.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c1.d *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; line_at E2 E2_ 0%Z; intro no;
  specialize (no 0 0 ltac:(lra) ltac:(lra)); revert no; compute_goal; derivatives; roots; pose proof PI_RGT_0;
  nra.
Qed.

(* gbt-developable/ex-4.2.c1.e *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; line_at E2 E2_ 1%Z; intro no;
  specialize (no 0 0 ltac:(lra) ltac:(lra)); revert no; compute_goal; derivatives; roots; pose proof PI_RGT_0;
  nra.
Qed.

(* gbt-developable/ex-4.2.c2.a *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; compute_goal;
  intro no; destruct (no (1 / 2) (1 / 2) ltac:(lra) ltac:(lra)) as [A B]; revert A B; derivatives; roots;
  pose proof PI_RGT_0; intros; nra.
Qed.

(* gbt-developable/ex-4.2.c2.b *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; exists 1, 1; compute_goal;
  conjuncts; first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c2.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c2.c *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; exists 1, 1; compute_goal;
  conjuncts; first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c2.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c2.d *)
Theorem met.
Proof.
  cbv delta [instance]; exists 1, 1; lra.
Qed.

(* gbt-developable/ex-4.2.c2.d *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement not]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; compute_goal;
  intros mu nu M N no; destruct (no (1 / 2) (1 / 2) ltac:(lra) ltac:(lra)) as [A B]; revert A B; derivatives;
  roots; pose proof PI_RGT_0; intros; nra.
Qed.

(* gbt-developable/ex-4.2.c3.a *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; exists (-1), (-1);
  compute_goal; conjuncts; first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c3.a *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 0%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c3.b *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; exists (-1), (-1);
  compute_goal; conjuncts; first [ lra | near ].
Qed.

(* gbt-developable/ex-4.2.c3.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; one_curve E2__ E2___ E2 E2_; line_at E2 E2_ 1%Z; lines ().
Qed.

(* gbt-developable/ex-4.2.c3.c *)
Theorem met.
Proof.
  cbv delta [instance]; exists (-1); lra.
Qed.

(* gbt-developable/ex-4.2.c3.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement not]; line_at E2 E2_ 0%Z; line_at E2 E2_ 1%Z; compute_goal; intros nu N;
  split; intro no; specialize (no (- (1 / 2)) ltac:(lra)); revert no; derivatives; roots; pose proof PI_RGT_0;
  nra.
Qed.

(* gbt-developable/ex-4.2.c3.d *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; apply (no (-1) 0 ltac:(lra) ltac:(lra)); clear no;
  intros nu x N X L; assert (M : forall n y, E2 n n y = [entry (E2 n n y) 1; - 5 * sqrt 2; 5;
      125]) by (intros n y; change (E2 n n y) with [entry (E2 n n y) 1; entry (E2 n n y) 2;
      entry (E2 n n y) 3; entry (E2 n n y) 4] at 1; refine (f_equal2 (@cons _) eq_refl _);
    cbv delta [E2 g E2_0 E2_1]; compute_goal; parts; ring);
  assert (D : forall n, vDerive 4 (fun y => E2 n n y) 1 x = [(Derive_n (fun y => entry (E2 n n y) 1) 1 x); 0;
      0; 0]) by (intro n; change (vDerive 4 (fun y => E2 n n y) 1 x) with [Derive_n (fun y => entry (E2 n n y)
        1) 1 x; Derive_n (fun y => entry (E2 n n y) 2) 1 x; Derive_n (fun y => entry (E2 n n y) 3) 1 x;
      Derive_n (fun y => entry (E2 n n y) 4) 1 x];  refine (f_equal2 (@cons _) eq_refl _);
    rewrite (Derive_n_ext (fun y => entry (E2 n n y) 2) (fun _ => - 5 * sqrt 2)) by (intro y; rewrite M;
      reflexivity); rewrite (Derive_n_ext (fun y => entry (E2 n n y) 3) (fun _ => 5)) by (intro y; rewrite M;
      reflexivity); rewrite (Derive_n_ext (fun y => entry (E2 n n y) 4) (fun _ => 125)) by (intro y;
      rewrite M; reflexivity); rewrite !rate_const; reflexivity);
  assert (A : forall n, along n x = [(Derive_n (fun y => entry (E2 n n y) 1) 1 x) * 0;
      (Derive_n (fun y => entry (E2 n n y) 1) 1 x) * 5;
      (Derive_n (fun y => entry (E2 n n y) 1) 1 x) * (5 * sqrt 2)]) by (intro n;
    cbv delta [along direction normal]; cbv beta; rewrite D, M;
    generalize (Derive_n (fun y => entry (E2 n n y) 1) 1 x) (entry (E2 n n x) 1); intros; lists; parts; ring);
  assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  assert (F : forall n, dot (direction (E2 n n x) (vDerive 4 (fun y => E2 n n y) 1 x)) (direction (E2 n n x)
      (vDerive 4 (fun y => E2 n n y) 1 x)) <> 0 -> line n x = [0; - 25 * sqrt 2 / (1 + sqrt 2 * sqrt 2);
      25 / (1 + sqrt 2 * sqrt 2)]) by (intro n; cbv delta [line foot direction moment normal]; cbv beta;
    rewrite D, M; generalize (Derive_n (fun y => entry (E2 n n y) 1) 1 x) (entry (E2 n n x) 1); intros w z;
    generalize dependent (sqrt 2); intros r _ _ Q; lists; intro Z; rewrite Q;
    assert (w <> 0) by (intro Y; apply Z; rewrite Y; ring);
    assert (O : forall c, c * c * (1 + r * r) = c * c * 3) by (intro; rewrite Q; ring); parts;
    match goal with |- _ / ?d = _ => replace d with (75 * (w * w)) by (transitivity (25 * (w * w * (1 + r *
            r))); [rewrite O; ring|ring]) end; field; assumption); split;
  [change (vDerive 3 (fun nu_ => line nu_ x) 1 nu) with [Derive_n (fun t => nth 0 (line t x) 0) 1 nu;
      Derive_n (fun t => nth 1 (line t x) 0) 1 nu;
      Derive_n (fun t => nth 2 (line t x) 0) 1 nu];  change (zeros 3) with [0; 0; 0]; parts;
    [rewrite (Derive_n_ext_loc _ (fun _ => 0))|rewrite (Derive_n_ext_loc _ (fun _ => - 25 * sqrt 2 / (1 + sqrt
            2 * sqrt 2)))|rewrite (Derive_n_ext_loc _ (fun _ => 25 / (1 + sqrt 2 * sqrt 2)))];
    try apply rate_const; revert L; apply filter_imp; intros n Z; rewrite (F n Z);
    reflexivity|change (vDerive 3 (fun nu_ => along nu_ x) 1 nu) with [Derive_n (fun t => nth 0 (along t x) 0)
      1 nu; Derive_n (fun t => nth 1 (along t x) 0) 1 nu;
      Derive_n (fun t => nth 2 (along t x) 0) 1 nu];  rewrite (Derive_n_ext (fun t => nth 0 (along t x) 0)
      (fun n => (Derive_n (fun y => entry (E2 n n y) 1) 1 x) * 0)) by (intro t; rewrite A; reflexivity);
    rewrite (Derive_n_ext (fun t => nth 1 (along t x) 0) (fun n => (Derive_n (fun y => entry (E2 n n y) 1) 1
          x) * 5)) by (intro t; rewrite A; reflexivity);
    rewrite (Derive_n_ext (fun t => nth 2 (along t x) 0) (fun n => (Derive_n (fun y => entry (E2 n n y) 1) 1
          x) * (5 * sqrt 2))) by (intro t; rewrite A;
      reflexivity);  rewrite !(fun c => rate_right c (fun n => (Derive_n (fun y => entry (E2 n n y) 1) 1 x)) 1
      nu), A; lists; parts; ring].
Qed.

(* gbt-developable/ex-4.2.class *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; apply (no 0 0 0 0 ltac:(lra) ltac:(lra) ltac:(lra)); clear no;
  intros mu nu x x1 B N X L; assert (M : forall y, E2 mu nu y = [entry (E2 mu nu y) 1; - 5 * sqrt 2; 5;
      125]) by (intros y; change (E2 mu nu y) with [entry (E2 mu nu y) 1; entry (E2 mu nu y) 2;
      entry (E2 mu nu y) 3; entry (E2 mu nu y) 4] at 1; refine (f_equal2 (@cons _) eq_refl _);
    cbv delta [E2 g E2_0 E2_1]; compute_goal; parts; ring);
  assert (D : forall x, vDerive 4 (fun y => E2 mu nu y) 1 x = [(Derive_n (fun y => entry (E2 mu nu y) 1) 1 x);
      0; 0; 0]) by (intro z; change (vDerive 4 (fun y => E2 mu nu y) 1 z) with [Derive_n (fun y => entry (E2
          mu nu y) 1) 1 z; Derive_n (fun y => entry (E2 mu nu y) 2) 1 z;
      Derive_n (fun y => entry (E2 mu nu y) 3) 1 z;
      Derive_n (fun y => entry (E2 mu nu y) 4) 1 z];  refine (f_equal2 (@cons _) eq_refl _);
    rewrite (Derive_n_ext (fun y => entry (E2 mu nu y) 2) (fun _ => - 5 * sqrt 2)) by (intro y; rewrite M;
      reflexivity); rewrite (Derive_n_ext (fun y => entry (E2 mu nu y) 3) (fun _ => 5)) by (intro y;
      rewrite M; reflexivity); rewrite (Derive_n_ext (fun y => entry (E2 mu nu y) 4) (fun _ => 125)) by (intro
      y; rewrite M; reflexivity); rewrite !rate_const; reflexivity);
  assert (A : forall x, direction (E2 mu nu x) (vDerive 4 (fun y => E2 mu nu y) 1 x) = [(Derive_n (fun y =>
          entry (E2 mu nu y) 1) 1 x) * 0; (Derive_n (fun y => entry (E2 mu nu y) 1) 1 x) * 5;
      (Derive_n (fun y => entry (E2 mu nu y) 1) 1 x) * (5 * sqrt 2)]) by (intro z;
    cbv delta [direction normal]; cbv beta; rewrite D, M;
    generalize (Derive_n (fun y => entry (E2 mu nu y) 1) 1 z) (entry (E2 mu nu z) 1); intros; lists; parts;
    ring); assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  assert (F : forall x, dot (direction (E2 mu nu x) (vDerive 4 (fun y => E2 mu nu y) 1 x)) (direction (E2 mu
        nu x) (vDerive 4 (fun y => E2 mu nu y) 1 x)) <> 0 -> J mu nu x1 x = [(Derive_n (fun y => entry (E2 mu
            nu y) 1) 1 x) * 0 + 0; (Derive_n (fun y => entry (E2 mu nu y) 1) 1 x) * (5 * x1) + - 25 * sqrt 2 /
      (1 + sqrt 2 * sqrt 2); (Derive_n (fun y => entry (E2 mu nu y) 1) 1 x) * (5 * sqrt 2 * x1) + 25 / (1 +
        sqrt 2 * sqrt 2)]) by (intro t; cbv delta [J foot direction moment normal]; cbv beta; rewrite D, M;
    generalize (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t) (entry (E2 mu nu t) 1); intros w z;
    generalize dependent (sqrt 2); intros r _ _ Q; lists; intro Z; rewrite Q;
    assert (w <> 0) by (intro Y; apply Z; rewrite Y; ring);
    assert (O : forall c, c * c * (1 + r * r) = c * c * 3) by (intro; rewrite Q; ring); parts;
    match goal with |- _ + _ / ?d = _ => replace d with (75 * (w * w)) by (transitivity (25 * (w * w * (1 + r
            * r))); [rewrite O; ring|ring]) end; field; assumption);
  assert (S : smooth (fun y => entry (E2 mu nu y) 1)) by (cbv delta [E2 g E2_0 E2_1]; lists; smooth_sum);
  assert (V : forall k c, Derive_n (fun t => (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t) * k + c) 1 x =
    Derive_n (fun t => (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t)) 1 x * k) by (intros k c;
    rewrite (rate_plus (fun t => (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t) * k) (fun _ => c));
    [rewrite rate_const, (rate_right k (fun t => (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t)));
      ring|apply (smooth_mult (fun t => (Derive_n (fun y => entry (E2 mu nu y) 1) 1 t)) (fun _ => k));
      [exact (smooth_rate _ S)|apply smooth_const]|apply smooth_const]);
  change (vDerive 3 (fun t => J mu nu x1 t) 1 x) with [Derive_n (fun t => nth 0 (J mu nu x1 t) 0) 1 x;
    Derive_n (fun t => nth 1 (J mu nu x1 t) 0) 1 x; Derive_n (fun t => nth 2 (J mu nu x1 t) 0) 1 x];
  rewrite (Derive_n_ext_loc (fun t => nth 0 (J mu nu x1 t) 0) (fun x => (Derive_n (fun y => entry (E2 mu nu y)
          1) 1 x) * 0 + 0)) by (revert L; apply filter_imp; intros t Z; rewrite (F t Z); reflexivity);
  rewrite (Derive_n_ext_loc (fun t => nth 1 (J mu nu x1 t) 0) (fun x => (Derive_n (fun y => entry (E2 mu nu y)
          1) 1 x) * (5 * x1) + - 25 * sqrt 2 / (1 + sqrt 2 * sqrt 2))) by (revert L; apply filter_imp;
    intros t Z; rewrite (F t Z); reflexivity);
  rewrite (Derive_n_ext_loc (fun t => nth 2 (J mu nu x1 t) 0) (fun x => (Derive_n (fun y => entry (E2 mu nu y)
          1) 1 x) * (5 * sqrt 2 * x1) + 25 / (1 + sqrt 2 * sqrt 2))) by (revert L; apply filter_imp;
    intros t Z; rewrite (F t Z); reflexivity); rewrite !V, A; lists; parts; ring.
Qed.

(* gbt-developable/ex-4.2.lengths *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; line_at E2 E2_ 0%Z; line_at E2 E2_ 1%Z; compute_goal; intros; split; roots;
  equal.
Qed.

(* gbt-developable/ex-5.1.construct *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck farin_boehm];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/ex-5.1.construct *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck farin_boehm]; sums_at_ends;
  intros P1 P2 mu1 mu2 nu1 nu2; intros; split;
  [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 3%Z mu2; split;
    [ assumption | third_point P2 3%Z mu2 nu2 ] end ].
Qed.

(* gbt-developable/ex-5.1.shape.combined surface *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2 N2_] in no;
  refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool
      then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if
      (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1)
    (0)).
Qed.

(* gbt-developable/ex-5.2.Q02 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance F2 F1 g]; joined_planes ().
Qed.

(* gbt-developable/ex-5.2.Q02 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement F2 F1 g]; computed; intros; equations; members; rewriting; conjuncts; lra.
Qed.

(* gbt-developable/ex-5.2.Q12 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; joined_planes ().
Qed.

(* gbt-developable/ex-5.2.Q12 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; computed; intros; equations; members; rewriting;
  unknown (B'1 1%Z); unknown (B'2 1%Z); unknown (B'3 1%Z); unknown (B'4 1%Z); put_in; repeat solve_one;
  conjuncts; field; different.
Qed.

(* gbt-developable/ex-5.2.Q22 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance F2 F1 F2_ F1_ g]; joined_planes ().
Qed.

(* gbt-developable/ex-5.2.Q22 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement F2 F1 F2_ F1_ g]; sums_at_ends; intros; equations; rewriting;
  pose proof PI_RGT_0; let at_1 := fun P v => (assert (P 1%Z = v) by (apply (Rmult_eq_reg_l (1 + PI));
      lra)) in let at_2 := fun P v => (assert (P 2%Z = v) by (apply (Rmult_eq_reg_l PI); lra)) in at_1 B'1 0;
  at_1 B'2 30; at_1 B'3 0; at_1 B'4 400; rewriting; at_2 B'1 0; at_2 B'2 (30 + 5 * PI);
  at_2 B'3 (- 20 - 5 * PI); at_2 B'4 400; lists; rewritten; conjuncts; rounded.
Qed.

(* gbt-developable/ex-5.2.gamma-one *)
Theorem met.
Proof.
  cbv beta delta [instance]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 0;
      0] 0), (fun i => nth (Z.to_nat i) [10; 0; 0; 0] 0), (fun _ => 400), 1, (-1), (-1), (-1), (-1);
  cbv beta zeta; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i; d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z;
      c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends; reflexivity);
  assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i;
          d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z;
      d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field);
  assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity);
  assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3
      E1_2)) by (cbv beta delta [K1_ g]; vector_at_end; reflexivity);
  rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D;
  cbv beta delta [direction normal E1_3 E1_2]; compute_goal; conjuncts; parts; lra.
Qed.

(* gbt-developable/ex-5.2.gamma-one *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 G M1 M2 N1 N2 E P Q _ _;
  subst gamma; rewrite P; assert (V : forall v : list R, vscale 1 v = v) by (intro v;
    induction v as [|x v IH]; [reflexivity | change (vscale 1 (x :: v)) with (1 * x :: vscale 1 v);
      rewrite IH; f_equal; ring]); rewrite Q, V; split; reflexivity.
Qed.

(* gbt-developable/ex-5.2.gap.drawn pieces *)
Theorem met.
Proof.
  cbv beta delta [instance]; exists (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 40; 0;
      0] 0), (fun i => nth (Z.to_nat i) [10; -10; 0; 0] 0), (fun _ => 400), 2, (-1), (-1), (-1), (-1), 1;
  cbv beta zeta; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i; d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z;
      c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends; reflexivity);
  assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i;
          d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z;
      d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field);
  assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity);
  assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3
      E1_2)) by (cbv beta delta [K1_ g]; vector_at_end;
    reflexivity);  rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D;
  cbv beta delta [direction normal E1_3 E1_2]; compute_goal; conjuncts; parts; lra.
Qed.

(* gbt-developable/ex-5.2.gap.drawn pieces *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 x1 G M1 M2 N1 N2 E X P Q _ N;
  split; [|split; [|split]]; [rewrite ?P, ?Q; clear P Q;
    assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2;
        entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity;
    assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1
          (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4;
    clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3)
    (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun
          x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry
      (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4;
    cbv delta [direction foot moment normal]; lists; intro N; parts; ring|intro Z; apply E;
    apply (Rmult_eq_reg_l x1); [lra|exact X]|rewrite ?P, ?Q; clear P Q;
    assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2;
        entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity;
    assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1
          (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4;
    clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3)
    (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun
          x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry
      (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4;
    cbv delta [direction foot moment normal]; lists; intro N;
    match type of N with ?a * _ + (?b * _ + (?c * _ + 0)) <> 0 => pose proof (Rle_0_sqr a);
    pose proof (Rle_0_sqr b); pose proof (Rle_0_sqr c); unfold Rsqr in *;
    (generalize dependent (a * a); generalize dependent (b * b); generalize dependent (c * c); intros;
      lra) end|rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1;
        entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity;
    assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1
          (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4;
    clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3)
    (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun
          x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry
      (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear - G X; intros p1 p2 p3 p4 q1 q2 q3 q4;
    cbv delta [direction foot moment normal]; lists; intro N; apply (same_foot gamma); [lra|exact N|ring ..]].
Qed.

(* gbt-developable/ex-5.2.gap.surfaces *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; assert (A : forall a b c d, K2 (fun i => [a i; b i; c i;
        d i]) (-1) (-1) 0%Z = [a 0%Z; b 0%Z; c 0%Z; d 0%Z]) by (intros; cbv beta delta [K2 g]; lists; at_ends;
    reflexivity); assert (B : forall a b c d, vDerive 4 (fun x => K2_ (fun i => [a i; b i; c i;
          d i]) (-1) (-1) x) 1 (IZR 0) = [a 1%Z - a 0%Z; b 1%Z - b 0%Z; c 1%Z - c 0%Z;
      d 1%Z - d 0%Z]) by (intros; cbv beta delta [K2_ g]; lists; at_ends; parts; field);
  assert (C : K1 (-1) (-1) 1%Z = E1_3) by (cbv beta delta [K1 g]; vector_at_end; reflexivity);
  assert (D : vDerive 4 (fun x => K1_ (-1) (-1) x) 1 (IZR 1) = vscale (1 + PI / 2 * (1 + -1)) (vsub E1_3
      E1_2)) by (cbv beta delta [K1_ g]; vector_at_end;
    reflexivity);  specialize (no (fun _ => 0) (fun i => nth (Z.to_nat i) [20; 40; 0;
        0] 0) (fun i => nth (Z.to_nat i) [10; -10; 0; 0] 0) (fun _ => 400) 2 (-1) (-1) (-1) (-1));
  cbv beta in no; rewrite (A (fun _ => 0) _ _ (fun _ => 400)), (B (fun _ => 0) _ _ (fun _ => 400)), C, D in
  no; clear A B C D; refine (no _ _ _ _ _ _ _ _ _); clear no;
  [lra|lra|lra|lra|lra|lra|cbv delta [E1_3]; compute_goal; reflexivity|cbv delta [E1_3 E1_2]; compute_goal;
    parts; lra|]; intros B1 B2 B3 B4 gamma mu1 mu2 nu1 nu2 G M1 M2 N1 N2 X P Q _ N; split;
  [rewrite ?P, ?Q; clear P Q; assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1;
        entry (K1 mu1 nu1 1%Z) 2; entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity;
    assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1
          (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4;
    clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3)
    (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun
          x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry
      (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear - G X; intros p1 p2 p3 p4 q1 q2 q3 q4;
    cbv delta [direction foot moment normal]; lists; intro N; apply (same_foot gamma);
    [lra|exact N|ring ..]|rewrite ?P, ?Q; clear P Q;
    assert (P4 : K1 mu1 nu1 1%Z = [entry (K1 mu1 nu1 1%Z) 1; entry (K1 mu1 nu1 1%Z) 2;
        entry (K1 mu1 nu1 1%Z) 3; entry (K1 mu1 nu1 1%Z) 4]) by reflexivity;
    assert (Q4 : vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1) = [entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1
          (IZR 1)) 1; entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 2;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3;
        entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4]) by reflexivity; revert N; rewrite P4, Q4;
    clear P4 Q4; generalize (entry (K1 mu1 nu1 1%Z) 1) (entry (K1 mu1 nu1 1%Z) 2) (entry (K1 mu1 nu1 1%Z) 3)
    (entry (K1 mu1 nu1 1%Z) 4) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 1) (entry (vDerive 4 (fun
          x => K1_ mu1 nu1 x) 1 (IZR 1)) 2) (entry (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 3) (entry
      (vDerive 4 (fun x => K1_ mu1 nu1 x) 1 (IZR 1)) 4); clear; intros p1 p2 p3 p4 q1 q2 q3 q4;
    cbv delta [direction foot moment normal]; lists; intro N; parts; ring].
Qed.

(* gbt-developable/intro-continuity-free.b.any values *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2] in no;
  refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool
      then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if
      (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1)
    (0)).
Qed.

(* gbt-developable/intro-continuity-free.c.any values *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement H1 H2 H1_ H2_ N2 g] in no;
  specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 0 0 (-1) (-1) (-1) 0 1 (fun _ => 0) (fun _ => 0) (fun t
      => t)); without_premises no; revert no; lists;
  match goal with |- [[Derive_n ?f 1 ?x]] = [[_ * Derive_n ?g 1 ?y]] -> _ => rewrite (slope_of_line f (fun t
      => 0 * t) x 0); [ rewrite (slope_of_line g (fun t => PI ^ 2 / 4 * t) y (PI ^ 2 / 4));
    [ unfold ratio; lists; intro C; injection C; clear C; intro C; apply (pow_nonzero PI 2 PI_neq0);
      match type of C with ?l = ?r => transitivity (4 * r); [ | rewrite <- C ]; field end | intro;
      ends_of_sums; compute_goal; field | intro; ring ] | intro; ends_of_sums; compute_goal; field | intro;
    ring ] end.
Qed.

(* gbt-developable/intro-gk.there are such compositions (printed) *)
Theorem met.
Proof.
  destruct proved_there as (k & P & mu & nu & c1 & c2 & c3 & c4 & c5 & c6 & c7 & c8 & c9 & c10); exists k,
    P, mu, nu; refine (conj c1 (conj c2 (conj c3 (conj c4 (conj c5 (conj c6 (conj c7 _))))))); repeat split;
    apply filter_forall; intro; assumption.
Qed.

(* gbt-developable/intro-gk.there are such compositions (printed) *)
Theorem proved.
Proof.
  hnf; intros k P mu nu c1 c2 c3 c4 c5 c6 c7 c8 c9 c10; exact (proved_there k P mu nu c1 c2 c3 c4 c5 c6 c7
    c5 c6 c7).
Qed.

(* gbt-developable/sec-2.2.vd.quadratic *)
Theorem met.
Proof.
  exists 0, 0, (1 / 2); lra.
Qed.

(* gbt-developable/sec-2.2.vd.quadratic *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros mu nu x M N X;
  assert (A1 : forall y, Derive_n (fun t => g t mu nu 0%Z 2%Z) 1 y = PI / 2 * (cos (PI / 2 * y) * (2 * mu *
        sin (PI / 2 * y) - (1 + mu)))) by (intro y; cbv delta [g]; compute_goal; apply is_derive_unique;
    auto_derive; [exact I|field]); assert (C1 : forall y, Derive_n (fun t => g t mu nu 2%Z 2%Z) 1 y = PI / 2 *
    (sin (PI / 2 * y) * (1 + nu - 2 * nu * cos (PI / 2 * y)))) by (intro y; cbv delta [g]; compute_goal;
    apply is_derive_unique; auto_derive; [exact I|field]);
  assert (A2 : forall y, Derive_n (fun t => g t mu nu 0%Z 2%Z) 2 y = (PI / 2) ^ 2 * ((1 + mu) * sin (PI / 2 *
        y) - 2 * mu * sin (PI / 2 * y) ^ 2 + 2 * mu * cos (PI / 2 * y) ^ 2)) by (intro y;
    change (Derive_n (fun t => g t mu nu 0%Z 2%Z) 2 y) with (Derive (Derive_n (fun t => g t mu nu 0%Z 2%Z) 1)
      y); rewrite (Derive_ext _ _ y A1); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (C2 : forall y, Derive_n (fun t => g t mu nu 2%Z 2%Z) 2 y = (PI / 2) ^ 2 * ((1 + nu) * cos (PI / 2 *
        y) - 2 * nu * cos (PI / 2 * y) ^ 2 + 2 * nu * sin (PI / 2 * y) ^ 2)) by (intro y;
    change (Derive_n (fun t => g t mu nu 2%Z 2%Z) 2 y) with (Derive (Derive_n (fun t => g t mu nu 2%Z 2%Z) 1)
      y); rewrite (Derive_ext _ _ y C1); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (B : Derive_n (fun t => g t mu nu 2%Z 2%Z - g t mu nu 0%Z 2%Z) 1 x = Derive_n (fun t => g t mu nu 2%Z
      2%Z) 1 x - Derive_n (fun t => g t mu nu 0%Z 2%Z) 1 x) by (apply (rate_minus (fun t => g t mu nu 2%Z 2%Z)
      (fun t => g t mu nu 0%Z 2%Z)); cbv delta [g]; smooth_sum); rewrite B, A2, C2, A1, C1;
  clear A1 A2 C1 C2 B; pose proof PI_RGT_0 as Q; assert (0 < sin (PI / 2 * x)) by (apply sin_gt_0; nra);
  assert (0 < cos (PI / 2 * x)) by (apply cos_gt_0; nra); pose proof (sin2_cos2 (PI / 2 * x)) as E;
  unfold Rsqr in E; generalize dependent (sin (PI / 2 * x)); generalize dependent (cos (PI / 2 * x));
  intros c K s H E; assert (s < 1) by nra; assert (c < 1) by nra; split;
  [replace ((PI / 2) ^ 2 * ((1 + mu) * s - 2 * mu * s ^ 2 + 2 * mu * c ^ 2) * (PI / 2 * (s * (1 + nu - 2 * nu
            * c))) - PI / 2 * (c * (2 * mu * s - (1 + mu))) * ((PI / 2) ^ 2 * ((1 + nu) * c - 2 * nu * c ^ 2 +
          2 * nu * s ^ 2))) with ((PI / 2) ^ 3 * ((1 + mu) * (1 + nu) * (s * (1 - c) * (s * (1 - s) + c ^ 2) +
          c * (1 - s) * (c * (1 - c) + s ^ 2)) + (1 + mu) * (1 - nu) * c ^ 3 + (1 - mu) * (1 + nu) * s ^ 3))
    by field; assert (0 < (PI / 2) ^ 3) by (apply pow_lt; lra); assert (0 < c ^ 3) by (apply pow_lt; lra);
    assert (0 < s ^ 3) by (apply pow_lt; lra); assert (0 < (1 + mu) * (1 - nu)) by nra;
    assert (0 < (1 - mu) * (1 + nu)) by nra; assert (0 < (1 + mu) * (1 + nu)) by nra;
    assert (0 < s * (1 - c)) by nra; assert (0 < c * (1 - s)) by nra; assert (0 < s * (1 - s) + c ^ 2) by nra;
    assert (0 < c * (1 - c) + s ^ 2) by nra; apply Rmult_lt_0_compat; [assumption|];
    repeat first [assumption|apply Rplus_lt_0_compat|apply Rmult_lt_0_compat]|replace (PI / 2 * (s * (1 + nu -
          2 * nu * c)) - PI / 2 * (c * (2 * mu * s - (1 + mu)))) with (PI / 2 * (s * ((1 - nu) * c + (1 + nu)
          * (1 - c)) + c * ((1 - mu) * s + (1 + mu) * (1 - s)))) by field; assert (0 < (1 - nu) * c) by nra;
    assert (0 < (1 + nu) * (1 - c)) by nra; assert (0 < (1 - mu) * s) by nra;
    assert (0 < (1 + mu) * (1 - s)) by nra; apply Rmult_lt_0_compat; [lra|]; apply Rplus_lt_0_compat;
    apply Rmult_lt_0_compat; lra].
Qed.

(* gbt-developable/sec-2.3.dir-mu *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g G]; intros; split;
  [ rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) *
        ((1 - sin (PI / 2 * x)) * sin (PI / 2 * x) * (R_ (i + 1)%Z - R_ i)))) by (intros; ring);
    rewrite binomial_form by assumption; derivatives; apply pw_ext; intro; unfold seed3; ring | signs; nra ].
Qed.

(* gbt-developable/sec-2.3.dir-nu *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g G]; intros; split;
  [ rewrite from_one; rewrite (sum_ext 0 (k - 2) _ (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 -
          x) (k - 2 - i) * ((1 - cos (PI / 2 * x)) * cos (PI / 2 * x) * (R_ (i + 1)%Z - R_ (i + 2)%Z)))) by
    (intros i I; replace (i + 1 - 1)%Z with i by lia; replace (k - 1 - (i + 1))%Z with (k - 2 - i)%Z by lia;
      replace (i + 1 + 1)%Z with (i + 2)%Z by lia; ring); rewrite binomial_form by assumption; derivatives;
    apply pw_ext; intro; unfold seed3; ring | signs; nra ].
Qed.

(* gbt-developable/sec-3.2.envelope *)
Theorem met.
Proof.
  cbv beta zeta delta [instance A A_ A3 A3_ J J_ a a' a'' phi]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0;
  lists; start_values; split; [lra|split; [lra|split;
      [apply filter_forall; intro e; rewrite ?quadratic_rate;
        match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split;
        [apply filter_forall; intro e; rewrite ?quadratic_rate;
          match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; [lra|split; [lra|lra]]]]]].
Qed.

(* gbt-developable/sec-3.2.envelope *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H1 into L, H4 into N; clear - L N;
  pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd));
  pose (direction := fun P D_ : list R => cross (normal P) (normal D_));
  pose (foot := fun P D_ : list R => vdiv (cross (direction P D_) (vsub (vscale (entry D_ 4) (normal P))
        (vscale (entry P 4) (normal D_)))) (dot (direction P D_) (direction P D_)));
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (PP [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros a b cc z p q r s t u v w;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, PP [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0 = [a; b; cc; z]) by (clear; intros a b cc z p q r s t u v w;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (JS : forall a b cc z p q r s t u v w x : R, vadd (vscale x (direction (PP [p; q; r; s] [t; u; v;
            w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
          z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) 1 (IZR 0))) = vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p;
        q; r; s])) by (intros; rewrite PZ, VD; reflexivity);
  assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 +
      (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b;
      cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl)));
    [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q *
            v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E;
        ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]]); destruct (K a0 a1 a2 a3 a0' a1' a2' a3' a0'' a1'' a2'' a3'' x1 L)
  as (v1 & v2 & v3 & EA & A1 & A2); clear K L;
  pose proof (JS a0 a1 a2 a3 a0' a1' a2' a3' a0'' a1'' a2'' a3'' x1 : J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3
    a3' a3'' x1 0%Z = _) as EJ; clear JS VD PZ; rewrite EJ in *; clear EJ;
  generalize dependent (vadd (vscale x1 (direction [a0; a1; a2; a3] [a0'; a1'; a2'; a3'])) (foot [a0; a1; a2;
        a3] [a0'; a1'; a2'; a3'])); intros S N A2; split;
  [clear; cbv beta delta [phi a a']; lists; ring|split; [refine (eq_trans (f_equal _ EA) _); exact A1|]];
  refine (eq_trans (f_equal (fun V => vdiv V _) (eq_trans (f_equal _ EA) (CR a0 a1 a2 a0' a1' a2' _ _ _ (a3''
            - dot (a'' a0'' a1'' a2'') S) A1 A2))) _); clear - N;
  generalize dependent (dot (a'' a0'' a1'' a2'') S); intros m N; cbv beta iota delta [vdiv vscale map a];
  refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); field; exact N.
Qed.

(* gbt-developable/sec-3.3.developable *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a a' a'' a''' system four A A3 meet phi normal B B3 curve];
  exists 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1; split;
  [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split;
    [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split;
      [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split;
        [apply filter_forall; intro e; lists; rewrite ?quartic_rate, ?quartic_second;
          match goal with |- ?d <> 0 => replace d with 1 by field; lra end|lists;
          match goal with |- ?d <> 0 => replace d with 1 by ring; lra end]]]].
Qed.

(* gbt-developable/sec-3.3.developable *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; match goal with |- vdiv (vscale _ ?X) _ = _ => assert (E : X =
    vscale (x2 * (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''') ^ 2 / (det
        (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'')) ^ 3) (a a0 a1 a2)) by (refine (eq_trans (spine_plane
        (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''' + e ^ 4 / 24 * a0'''') (fun e => a1 + e
          * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''' + e ^ 4 / 24 * a1'''') (fun e => a2 + e * a2' + e ^ 2 /
          2 * a2'' + e ^ 3 / 6 * a2''' + e ^ 4 / 24 * a2'''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^
          3 / 6 * a3''' + e ^ 4 / 24 * a3'''') (smooth_quartic a0 a0' a0'' a0''' a0'''') (smooth_quartic a1
          a1' a1'' a1''' a1'''') (smooth_quartic a2 a2' a2'' a2''' a2'''') (smooth_quartic a3 a3' a3'' a3'''
          a3'''') x2 0 H2) _); cbv beta zeta delta [a a' a'' a''' system four]; clear; lists; start_values;
    reflexivity) end; rewrite E; clear - H H0 H1;
  generalize dependent (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''');
  generalize dependent (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'')); intros; cbv delta [a]; lists;
  refine (f_equal2 (@cons _) _ _); [apply scaled_plane; assumption|]; refine (f_equal2 (@cons _) _ _);
  [apply scaled_plane; assumption|]; refine (f_equal2 (@cons _) _ _);
  [apply scaled_plane; assumption|reflexivity].
Qed.

(* gbt-developable/sec-3.3.regression *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal];
  exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1; split;
  [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split;
    [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|apply filter_forall; intro e;
      lists; rewrite ?cubic_rate, ?cubic_second; match goal with |- ?d <> 0 => replace d with 1 by field;
      lra end]].
Qed.

(* gbt-developable/sec-3.3.regression *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H into D, H0 into N; clear - D N;
  assert (SV : vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3''
      a3''' e) 1 (IZR 0) = vscale (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3''
      a3''' / det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2) (phi a0 a0' a1 a1' a2 a2')) by (pose proof
    (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') (fun e => a1 + e * a1' + e
        ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''')
      (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0' a0'' a0''')
      (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3'' a3''') 0) as
    T; cbv beta iota zeta delta [map seq app] in T;
    rewrite (cubic_start a0 a0' a0'' a0''' : Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 *
        a0''') 0 0 = a0), (taylor_start_rate a0 a0' a0'' a0''' : Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 *
        a0'' + e ^ 3 / 6 * a0''') 1 0 = a0'), (taylor_start_second a0 a0' a0'' a0''' : Derive_n (fun e => a0 +
        e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') 2 0 = a0''), (cubic_third a0 a0' a0'' a0''' 0 :
      Derive_n (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') 3 0 = a0'''), (cubic_start a1
      a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') 0 0 = a1),
    (taylor_start_rate a1 a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 *
        a1''') 1 0 = a1'), (taylor_start_second a1 a1' a1'' a1''' : Derive_n (fun e => a1 + e * a1' + e ^ 2 /
        2 * a1'' + e ^ 3 / 6 * a1''') 2 0 = a1''), (cubic_third a1 a1' a1'' a1''' 0 : Derive_n (fun e => a1 +
        e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') 3 0 = a1'''), (cubic_start a2 a2' a2'' a2''' :
      Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') 0 0 = a2), (taylor_start_rate a2
      a2' a2'' a2''' : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') 1 0 = a2'),
    (taylor_start_second a2 a2' a2'' a2''' : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 *
        a2''') 2 0 = a2''), (cubic_third a2 a2' a2'' a2''' 0 : Derive_n (fun e => a2 + e * a2' + e ^ 2 / 2 *
        a2'' + e ^ 3 / 6 * a2''') 3 0 = a2'''), (cubic_start a3 a3' a3'' a3''' : Derive_n (fun e => a3 + e *
        a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 0 0 = a3), (taylor_start_rate a3 a3' a3'' a3''' : Derive_n
      (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 1 0 = a3'), (taylor_start_second a3 a3'
      a3'' a3''' : Derive_n (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') 2 0 = a3''),
    (cubic_third a3 a3' a3'' a3''' 0 : Derive_n (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''')
      3 0 = a3''') in T; exact (T D)); assert (SP : forall a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' :
    R, det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 -> dot (a a0 a1 a2) (S_ a0 a0' a0'' a1 a1' a1''
      a2 a2' a2'' a3 a3' a3'') = a3 /\ dot (a' a0' a1' a2') (S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3'
      a3'') = a3') by (clear; intros a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' D; unfold S_;
    assert (Q : forall a b c x y z d, d <> 0 -> dot [a; b;
        c] (vdiv [x; y; z] d) = (a * x + (b * y + c * z)) / d) by (clear; intros; lists; field; assumption);
    split; refine (eq_trans (Q _ _ _ _ _ _ _ D) _); apply quotient_is;
    [exact D|clear; cbv beta delta [cramer1 cramer2 cramer3 system a a' a'']; lists; ring|exact D|clear;
      cbv beta delta [cramer1 cramer2 cramer3 system a a' a'']; lists; ring]);
  destruct (SP _ _ _ _ _ _ _ _ _ a3 a3' a3'' D) as [P1 P2]; clear SP; rewrite SV; clear SV; split;
  [exact P1|split; [exact P2|]]; clear P1 P2;
  generalize dependent (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2''));
  generalize dependent (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''');
  intros m M l L; cbv beta iota delta [vscale vdiv map phi cross];
  refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); apply scaled_over;
  assumption.
Qed.

(* gbt-developable/sec-3.3.regression.quadratic *)
Theorem met.
Proof.
  cbv beta delta [instance]; pose (U1 := fun i : Z => if (i =? 0)%Z then 1 else 0);
  pose (U2 := fun i : Z => if (i =? 1)%Z then 1 else 0);
  pose (U3 := fun i : Z => if (i =? 2)%Z then 1 else 0); pose (U4 := fun _ : Z => 0); pose (mu := 0);
  pose (nu := 0); pose (x := 0); exists U1, U2, U3, U4, mu, nu, x; intro U;
  pose (d := fun i k => Derive_n (fun t => g t mu nu i 2) k x);
  assert (S : forall i, smooth (fun t => g t mu nu i 2)) by (clear - mu nu; clearbody mu nu; intro i;
    unfold g; apply (smooth_member (fun x => (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x))) (fun x => 1
        - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI /
            2 * x))) (fun x => (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))));
    [apply Z.le_refl|smooths ..]); assert (C : forall c i, smooth (fun t => g t mu nu i 2 * c)) by (clear - S;
    intros c i; exact (smooth_mult _ _ (S i) (smooth_const c)));
  assert (R : forall u0 u1 u2 k, Derive_n (fun t => g t mu nu 0 2 * u0 + g t mu nu 1 2 * u1 + g t mu nu 2 2 *
      u2) k x = d 0%Z k * u0 + d 1%Z k * u1 + d 2%Z k * u2) by (intros u0 u1 u2 k;
    exact (eq_trans (rate_plus (fun t => g t mu nu 0 2 * u0 + g t mu nu 1 2 * u1) _ k x (smooth_plus _ _ (C u0
            0%Z) (C u1 1%Z)) (C u2 2%Z)) (f_equal2 Rplus (eq_trans (rate_plus _ _ k x (C u0 0%Z) (C u1 1%Z))
          (f_equal2 Rplus (rate_right u0 _ k x) (rate_right u1 _ k x))) (rate_right u2 _ k x))));
  assert (Q : forall k, vDerive 4 (fun t => quadratic U mu nu t) k x = vadd (vadd (vscale (d 0%Z k) (U 0%Z))
      (vscale (d 1%Z k) (U 1%Z))) (vscale (d 2%Z k) (U 2%Z))) by (intro k;
    exact (f_equal2 (@cons _) (R (U1 0%Z) (U1 1%Z) (U1 2%Z) k) (f_equal2 (@cons _) (R (U2 0%Z) (U2 1%Z) (U2
            2%Z) k) (f_equal2 (@cons _) (R (U3 0%Z) (U3 1%Z) (U3 2%Z) k) (f_equal2 (@cons _) (R (U4 0%Z) (U4
              1%Z) (U4 2%Z) k) (eq_refl)))))); rewrite !Q; clear Q R C S;
  assert (V : g x mu nu 0 2 = 1 /\ g x mu nu 1 2 = 0 /\ g x mu nu 2 2 = 0 /\ d 1%Z 1%nat = PI / 2 /\ d 2%Z
    1%nat = 0 /\ d 2%Z 2%nat = (PI / 2) ^ 2) by (clear; subst d; subst x; subst mu; subst nu; unfold g;
    members_at_ends; repeat split; field); destruct V as (V1 & V2 & V3 & V4 & V5 & V6); clearbody d;
  pose proof PI_RGT_0 as P; cbv beta iota zeta delta [normal quadratic U1 U2 U3 U4 Z.eqb Pos.eqb U]; lists;
  rewrite V1, V2, V3, V4, V5, V6; clear V1 V2 V3 V4 V5 V6; split;
  [clear; subst mu; lra|split; [clear; subst nu; lra|split;
      [clear; subst x; lra|split; [|split; [clear; lra|split; [clear; lra|]]]]]];
  [match goal with |- ?d <> 0 => replace d with ((PI / 2) ^ 3) by (clear; ring) end; apply pow_nonzero;
    clear - P; lra|clear; subst x; subst mu; subst nu; lra].
Qed.

(* gbt-developable/sec-3.3.regression.quadratic *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros U1 U2 U3 U4 mu nu x U _ _ _ D _ _ _;
  pose (d := fun i k => Derive_n (fun t => g t mu nu i 2) k x);
  assert (S : forall i, smooth (fun t => g t mu nu i 2)) by (clear; intro i; unfold g;
    apply (smooth_member (fun x => (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x))) (fun x => 1 - (1 -
          sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 *
            x))) (fun x => (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))));
    [apply Z.le_refl|smooths ..]); assert (C : forall c i, smooth (fun t => g t mu nu i 2 * c)) by (intros c
    i; exact (smooth_mult _ _ (S i) (smooth_const c)));
  assert (R : forall u0 u1 u2 k, Derive_n (fun t => g t mu nu 0 2 * u0 + g t mu nu 1 2 * u1 + g t mu nu 2 2 *
      u2) k x = d 0%Z k * u0 + d 1%Z k * u1 + d 2%Z k * u2) by (intros u0 u1 u2 k;
    exact (eq_trans (rate_plus (fun t => g t mu nu 0 2 * u0 + g t mu nu 1 2 * u1) _ k x (smooth_plus _ _ (C u0
            0%Z) (C u1 1%Z)) (C u2 2%Z)) (f_equal2 Rplus (eq_trans (rate_plus _ _ k x (C u0 0%Z) (C u1 1%Z))
          (f_equal2 Rplus (rate_right u0 _ k x) (rate_right u1 _ k x))) (rate_right u2 _ k x))));
  assert (Q : forall k, vDerive 4 (fun t => quadratic U mu nu t) k x = vadd (vadd (vscale (d 0%Z k) (U 0%Z))
      (vscale (d 1%Z k) (U 1%Z))) (vscale (d 2%Z k) (U 2%Z))) by (intro k;
    exact (f_equal2 (@cons _) (R (U1 0%Z) (U1 1%Z) (U1 2%Z) k) (f_equal2 (@cons _) (R (U2 0%Z) (U2 1%Z) (U2
            2%Z) k) (f_equal2 (@cons _) (R (U3 0%Z) (U3 1%Z) (U3 2%Z) k) (f_equal2 (@cons _) (R (U4 0%Z) (U4
              1%Z) (U4 2%Z) k) (eq_refl)))))); rewrite !Q in *; clear Q R C S;
  assert (DM : forall a b c d e f h k l x0 x1 x2 y0 y1 y2 z0 z1 z2 : R, det [[a * x0 + b * x1 + c * x2;
        a * y0 + b * y1 + c * y2; a * z0 + b * z1 + c * z2];
      [d * x0 + e * x1 + f * x2; d * y0 + e * y1 + f * y2; d * z0 + e * z1 + f * z2];
      [h * x0 + k * x1 + l * x2; h * y0 + k * y1 + l * y2; h * z0 + k * z1 + l * z2]] = det [[a; b; c];
      [d; e; f]; [h; k; l]] * det [[x0; y0; z0]; [x1; y1; z1]; [x2; y2; z2]]) by (clear; intros; lists; ring);
  exact (f_equal2 (@cons _) (same_ratio _ _ _ _ _ D (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x mu nu 2 2) (d 0%Z
          1%nat) (d 1%Z 1%nat) (d 2%Z 1%nat) (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U4 0%Z) (U4 1%Z) (U4
          2%Z) (U2 0%Z) (U2 1%Z) (U2 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z)) (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x
          mu nu 2 2) (d 0%Z 1%nat) (d 1%Z 1%nat) (d 2%Z 1%nat) (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U1
          0%Z) (U1 1%Z) (U1 2%Z) (U2 0%Z) (U2 1%Z) (U2 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z))) (f_equal2 (@cons _)
      (same_ratio _ _ _ _ _ D (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x mu nu 2 2) (d 0%Z 1%nat) (d 1%Z 1%nat)
          (d 2%Z 1%nat) (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U1 0%Z) (U1 1%Z) (U1 2%Z) (U4 0%Z) (U4 1%Z)
          (U4 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z)) (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x mu nu 2 2) (d 0%Z
            1%nat) (d 1%Z 1%nat) (d 2%Z 1%nat) (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U1 0%Z) (U1 1%Z) (U1
            2%Z) (U2 0%Z) (U2 1%Z) (U2 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z))) (f_equal2 (@cons _) (same_ratio _ _ _
          _ _ D (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x mu nu 2 2) (d 0%Z 1%nat) (d 1%Z 1%nat) (d 2%Z 1%nat)
            (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U1 0%Z) (U1 1%Z) (U1 2%Z) (U2 0%Z) (U2 1%Z) (U2 2%Z)
            (U4 0%Z) (U4 1%Z) (U4 2%Z)) (DM (g x mu nu 0 2) (g x mu nu 1 2) (g x mu nu 2 2) (d 0%Z 1%nat) (d
              1%Z 1%nat) (d 2%Z 1%nat) (d 0%Z 2%nat) (d 1%Z 2%nat) (d 2%Z 2%nat) (U1 0%Z) (U1 1%Z) (U1 2%Z)
            (U2 0%Z) (U2 1%Z) (U2 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z))) eq_refl))).
Qed.

(* gbt-developable/sec-3.3.regression.velocity *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal];
  exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1; split;
  [apply filter_forall; intro e; lists; rewrite ?cubic_rate, ?cubic_second;
    match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; lists;
    match goal with |- ?d <> 0 => replace d with 1 by ring; lra end].
Qed.

(* gbt-developable/sec-3.3.regression.velocity *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a a' a'' a''' system S_ cramer1 cramer2 cramer3 four A A3 meet spine phi
    normal]; intros; pose proof (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''')
    (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' +
      e ^ 3 / 6 * a2''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0'
      a0'' a0''') (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3''
      a3''') 0) as L; revert L; lists; start_values; intro L; apply L; intro Z; apply H1;
  refine (eq_trans _ Z); ring.
Qed.

(* gbt-developable/sec-3.4.S0 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal g HT HT_ meet];
  exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit];
  compute_goal; conjuncts; first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.S0 *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _;
  assert (A : HT T k mu nu 0%Z = (T 0%Z)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic);
  assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 0) = vscale (IZR k - 2 + PI / 2 * (1 + mu)) (vsub (T
        1%Z) (T 0%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic);
  assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 0) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 +
            PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) (T 0%Z)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI *
              (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2) (T 1%Z))) (vscale ((IZR k - 2) * (IZR k - 3 + PI
          * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (T 2%Z))) by (clear -K; subst T; cbv beta delta [HT_ g];
    symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C; revert D2;
  generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (IZR k - 2 + PI / 2 * (1 +
      mu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^
    2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2); revert D; subst T;
  cbv beta delta [normal]; cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.S1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal g HT HT_ meet];
  exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit];
  compute_goal; conjuncts; first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.S1 *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _;
  assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic);
  assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T
        k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic);
  assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 1) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 +
            PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2) (T k)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1
              + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2) (T (k - 1)%Z))) (vscale ((IZR k - 2) * (IZR k - 3 +
          PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (T (k - 2)%Z))) by (clear -K; subst T;
    cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C;
  revert D2; generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (IZR k - 2 + PI
    / 2 * (1 + nu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI
      / 2) ^ 2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2); revert D;
  subst T; cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3
    (k - 1)%Z) (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z);
  cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.S1-gen *)
Theorem proved.
Proof.
  cbv beta delta [statement kappa S1]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _;
  assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic);
  assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T
        k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *;
  rewrite A, B; clear A B; revert D2; generalize (IZR k - 2 + PI / 2 * (1 + nu)); revert D; subst T;
  cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3 (k - 1)%Z)
  (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z);
  cbv beta zeta delta [meet normal]; lists; intros; split; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m0-r3.c1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts;
  first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m0-r3.c1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m0-r3.c2 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no;
  end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no.
Qed.

(* gbt-developable/sec-3.4.m0-r3.c2 (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts;
  first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m0-r3.c2 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m0-r3.c3 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no;
  end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no.
Qed.

(* gbt-developable/sec-3.4.m0-r3.c3 (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts;
  first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m0-r3.c3 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m1-r3.c1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m1-r3.c1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m1-r3.c2 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement k2] in no; specialize (no 2%Z (fun _ => 0) 0 1); revert no;
  end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 1; intro no; refuting no.
Qed.

(* gbt-developable/sec-3.4.m1-r3.c2 (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m1-r3.c2 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.m1-r3.c3 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0;
  end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ].
Qed.

(* gbt-developable/sec-3.4.m1-r3.c3 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero.
Qed.

(* gbt-developable/sec-3.4.tangent-ends *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 1, 0,
  0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0;
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P [p; q; r; s] [t; u; v; w] [a; b;
      cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); change O__ with (fun e f ff t => P_ f ff e t);
  change O_ with (fun e f ff t => P f ff e t); cbv beta; rewrite ?PZ, ?VD;
  assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear;
    cbv beta delta [direction normal]; lists; lra);
  assert (L : locally (IZR 0) (fun e => dot (direction (P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
            0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) (direction (P_ [0;
            1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
              0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear;
    cbv beta delta [P_ direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field;
    lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L;
  clear L D; first [lia | cbv beta delta [HT g]; lists; at_ends; reflexivity
    | cbv beta delta [direction normal foot moment]; lists; first [lra|parts; ring]].
Qed.

(* gbt-developable/sec-3.4.tangent-ends *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; match goal with A : _ = HT ?T ?k ?mu ?nu 0%Z, B : _ = HT ?T ?k ?mu
  ?nu 1%Z |- _ => assert (C : HT T k mu nu 0%Z = T 0%Z) by (cbv beta delta [HT g]; lists; at_ends;
    reflexivity); assert (D : HT T k mu nu 1%Z = T k) by (cbv beta delta [HT g]; lists; at_ends; reflexivity);
  rewrite C in A; rewrite D in B; clear C D; rewrite <- A, <- B; clear A B end; clear - H6 H7 H9 H10;
  pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd));
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (PP [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, PP [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0 = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (JS : forall a b cc z p q r s t u v w x : R, vadd (vscale x (direction (PP [p; q; r; s] [t; u; v;
            w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
          z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) 1 (IZR 0))) = vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p;
        q; r; s])) by (intros; rewrite PZ, VD; reflexivity);
  assert (TL : forall a b cc z p q r s t u v w x : R, dot (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
          z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) 1 (IZR 0))) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
          z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) 1 (IZR 0))) <> 0 -> locally (IZR 0) (fun e => dot (direction (PP [p; q; r; s] [t; u; v;
            w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0) -> dot [a; b;
      cc] (vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 (IZR 0)))) = z /\ dot [a; b; cc] (direction [a; b; cc; z] [p; q; r; s]) = 0 /\ dot [a;
      b; cc] (vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (PP [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) 1 (IZR 0)) = 0) by (intros a b cc z p q r s t u v w x N L; rewrite JS;
    rewrite PZ, VD in N; destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x L) as (v1 & v2 & v3 & E & A1 & _); rewrite E;
    split; [clear - N; revert N; cbv beta delta [direction normal foot moment]; lists; intro N;
      rewrite ?Rplus_0_r in *; field; exact N|split;
      [clear; cbv beta delta [direction normal]; lists; ring|exact A1]]);
  destruct (TL _ _ _ _ _ _ _ _ _ _ _ _ x1 H6 H7) as (F1 & F2 & F3);
  destruct (TL _ _ _ _ _ _ _ _ _ _ _ _ x1 H9 H10) as (G1 & G2 & G3); clear TL K VD PZ JS H6 H7 H9 H10; split;
  [reflexivity|split; [exact F1|split; [exact F2|split;
        [exact F3|split; [reflexivity|split; [exact G1|split; [exact G2|exact G3]]]]]]].
Qed.

(* gbt-developable/sec-4.2.Q0 *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros mu nu _ _;
  assert (A : E3 mu nu 0%Z = E3_0) by (cbv beta delta [E3 g]; vector_at_end; reflexivity); rewrite A;
  intros _; cbv beta delta [E3_0 normal midpoint]; compute_goal; split; [ parts; field | split; numeric ].
Qed.

(* gbt-developable/sec-4.2.class *)
Theorem met.
Proof.
  exists 0, 0; lra.
Qed.

(* gbt-developable/sec-4.2.class *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; assert (FF : exists f0 f1 f2 f3 : R -> R, forall m, ((1 - (1 / sqrt 2)) *
      (1 - m * (1 / sqrt 2)) = f0 m /\ PI / 2 * (1 / sqrt 2) * (2 * m * (1 / sqrt 2) - 1 - m) = f1 m /\ (PI /
        2) ^ 2 * (1 / sqrt 2) * (1 + m) = f2 m /\ (PI / 2) ^ 3 * (1 / sqrt 2) * (1 + m - 8 * m * (1 / sqrt 2))
      = f3 m) /\ (f0 m = 1 - (1 / sqrt 2) - m * (1 / sqrt 2) + m / 2 /\ f1 m = PI / 2 * (m - (1 / sqrt 2) - m
        * (1 / sqrt 2)) /\ f2 m = (PI / 2) ^ 2 * (1 / sqrt 2) * (1 + m) /\ f3 m = (PI / 2) ^ 3 * ((1 / sqrt 2)
        * (1 + m) - 4 * m))) by (exists (fun m => 1 - (1 / sqrt 2) - m * (1 / sqrt 2) + m / 2), (fun m => PI /
      2 * (m - (1 / sqrt 2) - m * (1 / sqrt 2))), (fun m => (PI / 2) ^ 2 * (1 / sqrt 2) * (1 + m)), (fun m =>
      (PI / 2) ^ 3 * ((1 / sqrt 2) * (1 + m) - 4 * m)); intro m;
    assert (S2 : (1 / sqrt 2) * (1 / sqrt 2) = 1 / 2) by (transitivity (1 / (sqrt 2 * sqrt 2));
      [field; apply Rgt_not_eq, Rlt_sqrt2_0|rewrite sqrt_sqrt; lra]); revert S2; generalize (1 / sqrt 2);
    intros s S2; split; [|repeat split]; split;
    [transitivity (1 - s - m * s + m * (s * s)); [ring|rewrite S2; field]|split;
      [transitivity (PI / 2 * (m * 2 * (s * s) - s - m * s)); [ring|rewrite S2; field]|split;
        [reflexivity|transitivity ((PI / 2) ^ 3 * (s * (1 + m) - 8 * m * (s * s)));
          [ring|rewrite S2; field]]]]); destruct FF as (f0 & f1 & f2 & f3 & FF);
  assert (DA1 : forall m y, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 1 y = PI /
    2 * (cos (PI / 2 * y) * (2 * m * sin (PI / 2 * y) - 1 - m))) by (intros m y; apply is_derive_unique;
    auto_derive; [exact I|field]); assert (DA2 : forall m y, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 -
        m * sin (PI / 2 * t))) 2 y = (PI / 2) ^ 2 * ((1 + m) * sin (PI / 2 * y) - 2 * m * sin (PI / 2 * y) ^ 2
      + 2 * m * cos (PI / 2 * y) ^ 2)) by (intros m y;
    change (Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 2 y) with (Derive
      (Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 1) y);
    rewrite (Derive_ext _ _ y (DA1 m)); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (DA3 : forall m y, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 3 y = (PI
      / 2) ^ 3 * (cos (PI / 2 * y) * (1 + m - 8 * m * sin (PI / 2 * y)))) by (intros m y;
    change (Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 3 y) with (Derive
      (Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 2) y);
    rewrite (Derive_ext _ _ y (DA2 m)); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (HA0 : forall m, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 0 (1 / 2) =
    f0 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a0;
    change ((fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) (1 / 2) = (1 - (1 / sqrt 2)) * (1 -
        m * (1 / sqrt 2))); cbv beta; replace (PI / 2 * (1 / 2)) with (PI / 4) by field;
    rewrite ?sin_PI4, ?cos_PI4;  clear; generalize (1 / sqrt 2); intro s; field);
  assert (HA1 : forall m, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 1 (1 / 2) =
    f1 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a1; rewrite DA1;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (HA2 : forall m, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 2 (1 / 2) =
    f2 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a2; rewrite DA2;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (HA3 : forall m, Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t))) 3 (1 / 2) =
    f3 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a3; rewrite DA3;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (SA : forall m, smooth (fun t => (1 - sin (PI / 2 * t)) * (1 - m * sin (PI / 2 * t)))) by (intro m;
    smooths); assert (DC1 : forall m y, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 *
          t))) 1 y = PI / 2 * (sin (PI / 2 * y) * (1 + m - 2 * m * cos (PI / 2 * y)))) by (intros m y;
    apply is_derive_unique; auto_derive; [exact I|field]);
  assert (DC2 : forall m y, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 2 y = (PI
      / 2) ^ 2 * ((1 + m) * cos (PI / 2 * y) - 2 * m * cos (PI / 2 * y) ^ 2 + 2 * m * sin (PI / 2 * y) ^ 2))
  by (intros m y; change (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 2 y) with
    (Derive (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 1) y);
    rewrite (Derive_ext _ _ y (DC1 m)); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (DC3 : forall m y, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 3 y = (PI
      / 2) ^ 3 * (sin (PI / 2 * y) * (8 * m * cos (PI / 2 * y) - 1 - m))) by (intros m y;
    change (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 3 y) with (Derive
      (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 2) y);
    rewrite (Derive_ext _ _ y (DC2 m)); apply is_derive_unique; auto_derive; [exact I|field]);
  assert (HC0 : forall m, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 0 (1 / 2) =
    f0 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a0;
    change ((fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) (1 / 2) = (1 - (1 / sqrt 2)) * (1 -
        m * (1 / sqrt 2))); cbv beta; replace (PI / 2 * (1 / 2)) with (PI / 4) by field;
    rewrite ?sin_PI4, ?cos_PI4;  clear; generalize (1 / sqrt 2); intro s; field);
  assert (HC1 : forall m, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 1 (1 / 2) =
    - f1 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a1; rewrite DC1;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (HC2 : forall m, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 2 (1 / 2) =
    f2 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a2; rewrite DC2;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (HC3 : forall m, Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t))) 3 (1 / 2) =
    - f3 m) by (intro m; destruct (FF m) as ((a0 & a1 & a2 & a3) & _); rewrite <- a3; rewrite DC3;
    replace (PI / 2 * (1 / 2)) with (PI / 4) by field; rewrite ?sin_PI4, ?cos_PI4;  clear;
    generalize (1 / sqrt 2); intro s; field);
  assert (SC : forall m, smooth (fun t => (1 - cos (PI / 2 * t)) * (1 - m * cos (PI / 2 * t)))) by (intro m;
    smooths); assert (EE0 : forall mu nu t, nth 0 (E3 mu nu t) 0 = (fun t => (fun t => (1 - sin (PI / 2 * t))
        * (1 - mu * sin (PI / 2 * t))) t * ((12) + (-15/2) * t)) t + (fun t => (fun t => (fun t => (1 - cos
            (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((-9/2) + (27) * t)) t + (fun t => (fun _ : R =>
          1) t * ((-11/2) + (-9/2) * t)) t) t) by (intros mu nu t; cbv delta [E3 g E3_0 E3_1 E3_2 E3_3];
    compute_goal; field); assert (W0 : forall mu nu n, Derive_n (fun t => nth 0 (E3 mu nu t) 0) (S n) (1 / 2)
    = Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) (S n) (1 / 2) * ((12) + (-15/2)
      * (1 / 2)) + INR (S n) * (-15/2) * Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
          t))) n (1 / 2) + (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) (S n) (1
        / 2) * ((-9/2) + (27) * (1 / 2)) + INR (S n) * (27) * Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 -
          nu * cos (PI / 2 * t))) n (1 / 2) + (Derive_n (fun _ : R => 1) (S n) (1 / 2) * ((-11/2) + (-9/2) *
          (1 / 2)) + INR (S n) * (-9/2) * Derive_n (fun _ : R => 1) n (1 / 2)))) by (intros mu nu n;
    assert (s1 : smooth (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((12) +
          (-15/2) * t))) by (apply (smooth_mult (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
              t))) (fun t => (12) + (-15/2) * t)); [apply SA|smooths]);
    assert (s2 : smooth (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((-9/2)
          + (27) * t))) by (apply (smooth_mult (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t)))
        (fun t => (-9/2) + (27) * t)); [apply SC|smooths]);
    assert (s3 : smooth (fun t => (fun _ : R => 1) t * ((-11/2) + (-9/2) * t))) by (apply (smooth_mult (fun _
          => 1) (fun t => (-11/2) + (-9/2) * t)); smooths);
    rewrite (Derive_n_ext _ _ (S n) (1 / 2) (EE0 mu nu));
    rewrite (rate_plus (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((12) +
          (-15/2) * t)) (fun t => (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t
          * ((-9/2) + (27) * t)) t + (fun t => (fun _ : R => 1) t * ((-11/2) + (-9/2) * t)) t) (S n) (1 / 2)
      s1 (smooth_plus _ _ s2 s3)); rewrite (rate_plus (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu *
            cos (PI / 2 * t))) t * ((-9/2) + (27) * t)) (fun t => (fun _ : R => 1) t * ((-11/2) + (-9/2) * t))
      (S n) (1 / 2) s2 s3); rewrite (times_line (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
            t))) _ _ n (1 / 2) (SA mu)), (times_line (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2
            * t))) _ _ n (1 / 2) (SC nu)), (times_line (fun _ => 1) _ _ n (1 / 2) (smooth_const 1));
    reflexivity); assert (EE1 : forall mu nu t, nth 1 (E3 mu nu t) 0 = (fun t => (fun t => (1 - sin (PI / 2 *
            t)) * (1 - mu * sin (PI / 2 * t))) t * ((-1) + (37/2) * t)) t + (fun t => (fun t => (fun t => (1 -
            cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((-35/2) + (15) * t)) t + (fun t => (fun _ :
          R => 1) t * ((15/2) + (-35/2) * t)) t) t) by (intros mu nu t; cbv delta [E3 g E3_0 E3_1 E3_2 E3_3];
    compute_goal; field); assert (W1 : forall mu nu n, Derive_n (fun t => nth 1 (E3 mu nu t) 0) (S n) (1 / 2)
    = Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) (S n) (1 / 2) * ((-1) + (37/2)
      * (1 / 2)) + INR (S n) * (37/2) * Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
          t))) n (1 / 2) + (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) (S n) (1
        / 2) * ((-35/2) + (15) * (1 / 2)) + INR (S n) * (15) * Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1
          - nu * cos (PI / 2 * t))) n (1 / 2) + (Derive_n (fun _ : R => 1) (S n) (1 / 2) * ((15/2) + (-35/2) *
          (1 / 2)) + INR (S n) * (-35/2) * Derive_n (fun _ : R => 1) n (1 / 2)))) by (intros mu nu n;
    assert (s1 : smooth (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((-1) +
          (37/2) * t))) by (apply (smooth_mult (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t)))
        (fun t => (-1) + (37/2) * t)); [apply SA|smooths]);
    assert (s2 : smooth (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((-35/2)
          + (15) * t))) by (apply (smooth_mult (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t)))
        (fun t => (-35/2) + (15) * t)); [apply SC|smooths]);
    assert (s3 : smooth (fun t => (fun _ : R => 1) t * ((15/2) + (-35/2) * t))) by (apply (smooth_mult (fun _
          => 1) (fun t => (15/2) + (-35/2) * t)); smooths);
    rewrite (Derive_n_ext _ _ (S n) (1 / 2) (EE1 mu nu));
    rewrite (rate_plus (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((-1) +
          (37/2) * t)) (fun t => (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t *
          ((-35/2) + (15) * t)) t + (fun t => (fun _ : R => 1) t * ((15/2) + (-35/2) * t)) t) (S n) (1 / 2) s1
      (smooth_plus _ _ s2 s3)); rewrite (rate_plus (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos
            (PI / 2 * t))) t * ((-35/2) + (15) * t)) (fun t => (fun _ : R => 1) t * ((15/2) + (-35/2) * t)) (S
        n) (1 / 2) s2 s3); rewrite (times_line (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t)))
      _ _ n (1 / 2) (SA mu)), (times_line (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) _ _
      n (1 / 2) (SC nu)), (times_line (fun _ => 1) _ _ n (1 / 2) (smooth_const 1)); reflexivity);
  assert (EE2 : forall mu nu t, nth 2 (E3 mu nu t) 0 = (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu *
          sin (PI / 2 * t))) t * ((-sqrt 2) + (-3*sqrt 2/2) * t)) t + (fun t => (fun t => (fun t => (1 - cos
            (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((5*sqrt 2/2) + (0) * t)) t + (fun t => (fun _ :
          R => 1) t * ((15*sqrt 2/2) + (5*sqrt 2/2) * t)) t) t) by (intros mu nu t;
    cbv delta [E3 g E3_0 E3_1 E3_2 E3_3]; compute_goal; field);
  assert (W2 : forall mu nu n, Derive_n (fun t => nth 2 (E3 mu nu t) 0) (S n) (1 / 2) = Derive_n (fun t => (1
        - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) (S n) (1 / 2) * ((-sqrt 2) + (-3*sqrt 2/2) * (1 /
        2)) + INR (S n) * (-3*sqrt 2/2) * Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
          t))) n (1 / 2) + (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) (S n) (1
        / 2) * ((5*sqrt 2/2) + (0) * (1 / 2)) + INR (S n) * (0) * Derive_n (fun t => (1 - cos (PI / 2 * t)) *
        (1 - nu * cos (PI / 2 * t))) n (1 / 2) + (Derive_n (fun _ : R => 1) (S n) (1 / 2) * ((15*sqrt 2/2) +
          (5*sqrt 2/2) * (1 / 2)) + INR (S n) * (5*sqrt 2/2) * Derive_n (fun _ : R => 1) n (1 / 2)))) by
  (intros mu nu n; assert (s1 : smooth (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 *
              t))) t * ((-sqrt 2) + (-3*sqrt 2/2) * t))) by (apply (smooth_mult (fun t => (1 - sin (PI / 2 *
              t)) * (1 - mu * sin (PI / 2 * t))) (fun t => (-sqrt 2) + (-3*sqrt 2/2) * t));
      [apply SA|smooths]); assert (s2 : smooth (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI
              / 2 * t))) t * ((5*sqrt 2/2) + (0) * t))) by (apply (smooth_mult (fun t => (1 - cos (PI / 2 *
              t)) * (1 - nu * cos (PI / 2 * t))) (fun t => (5*sqrt 2/2) + (0) * t)); [apply SC|smooths]);
    assert (s3 : smooth (fun t => (fun _ : R => 1) t * ((15*sqrt 2/2) + (5*sqrt 2/2) * t))) by (apply
      (smooth_mult (fun _ => 1) (fun t => (15*sqrt 2/2) + (5*sqrt 2/2) * t)); smooths);
    rewrite (Derive_n_ext _ _ (S n) (1 / 2) (EE2 mu nu));
    rewrite (rate_plus (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((-sqrt
            2) + (-3*sqrt 2/2) * t)) (fun t => (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI
              / 2 * t))) t * ((5*sqrt 2/2) + (0) * t)) t + (fun t => (fun _ : R => 1) t * ((15*sqrt 2/2) +
            (5*sqrt 2/2) * t)) t) (S n) (1 / 2) s1 (smooth_plus _ _ s2 s3));
    rewrite (rate_plus (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((5*sqrt
            2/2) + (0) * t)) (fun t => (fun _ : R => 1) t * ((15*sqrt 2/2) + (5*sqrt 2/2) * t)) (S n) (1 / 2)
      s2 s3); rewrite (times_line (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) _ _ n (1 /
        2) (SA mu)), (times_line (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) _ _ n (1 / 2)
      (SC nu)), (times_line (fun _ => 1) _ _ n (1 / 2) (smooth_const 1)); reflexivity);
  assert (EE3 : forall mu nu t, nth 3 (E3 mu nu t) 0 = (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu *
          sin (PI / 2 * t))) t * ((-56) + (-119) * t)) t + (fun t => (fun t => (fun t => (1 - cos (PI / 2 *
              t)) * (1 - nu * cos (PI / 2 * t))) t * ((175) + (50) * t)) t + (fun t => (fun _ : R => 1) t *
        ((225) + (175) * t)) t) t) by (intros mu nu t; cbv delta [E3 g E3_0 E3_1 E3_2 E3_3]; compute_goal;
    field); assert (W3 : forall mu nu n, Derive_n (fun t => nth 3 (E3 mu nu t) 0) (S n) (1 / 2) = Derive_n
    (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) (S n) (1 / 2) * ((-56) + (-119) * (1 / 2))
    + INR (S n) * (-119) * Derive_n (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) n (1 / 2)
    + (Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) (S n) (1 / 2) * ((175) + (50)
        * (1 / 2)) + INR (S n) * (50) * Derive_n (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 *
            t))) n (1 / 2) + (Derive_n (fun _ : R => 1) (S n) (1 / 2) * ((225) + (175) * (1 / 2)) + INR (S n)
        * (175) * Derive_n (fun _ : R => 1) n (1 / 2)))) by (intros mu nu n;
    assert (s1 : smooth (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((-56) +
          (-119) * t))) by (apply (smooth_mult (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t)))
        (fun t => (-56) + (-119) * t)); [apply SA|smooths]);
    assert (s2 : smooth (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t * ((175) +
          (50) * t))) by (apply (smooth_mult (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t)))
        (fun t => (175) + (50) * t)); [apply SC|smooths]);
    assert (s3 : smooth (fun t => (fun _ : R => 1) t * ((225) + (175) * t))) by (apply (smooth_mult (fun _ =>
          1) (fun t => (225) + (175) * t)); smooths); rewrite (Derive_n_ext _ _ (S n) (1 / 2) (EE3 mu nu));
    rewrite (rate_plus (fun t => (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) t * ((-56) +
          (-119) * t)) (fun t => (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) t *
          ((175) + (50) * t)) t + (fun t => (fun _ : R => 1) t * ((225) + (175) * t)) t) (S n) (1 / 2) s1
      (smooth_plus _ _ s2 s3)); rewrite (rate_plus (fun t => (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos
            (PI / 2 * t))) t * ((175) + (50) * t)) (fun t => (fun _ : R => 1) t * ((225) + (175) * t)) (S n)
      (1 / 2) s2 s3); rewrite (times_line (fun t => (1 - sin (PI / 2 * t)) * (1 - mu * sin (PI / 2 * t))) _ _
      n (1 / 2) (SA mu)), (times_line (fun t => (1 - cos (PI / 2 * t)) * (1 - nu * cos (PI / 2 * t))) _ _ n (1
        / 2) (SC nu)), (times_line (fun _ => 1) _ _ n (1 / 2) (smooth_const 1)); reflexivity);
  assert (R0 : forall mu nu, E3 mu nu (1 / 2) = [(33*(f0 mu)/4 + 9*(f0 nu) - 31/4);
      (33*(f0 mu)/4 - 10*(f0 nu) - 5/4); (-7*(f0 mu)*sqrt 2/4 + 5*(f0 nu)*sqrt 2/2 + 35*sqrt 2/4);
      (-231*(f0 mu)/2 + 200*(f0 nu) + 625/2)]) by (intros mu nu;
    change (E3 mu nu (1 / 2)) with [nth 0 (E3 mu nu (1 / 2)) 0; nth 1 (E3 mu nu (1 / 2)) 0;
      nth 2 (E3 mu nu (1 / 2)) 0; nth 3 (E3 mu nu (1 / 2)) 0]; rewrite EE0, EE1, EE2, EE3; cbv beta;
    assert (A0 : (1 - sin (PI / 2 * (1 / 2))) * (1 - mu * sin (PI / 2 * (1 / 2))) = f0 mu) by exact (HA0 mu);
    assert (C0 : (1 - cos (PI / 2 * (1 / 2))) * (1 - nu * cos (PI / 2 * (1 / 2))) = f0 nu) by exact (HC0 nu);
    rewrite A0, C0; parts; clear; lra); assert (R1 : forall mu nu, vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2) =
    [(-15*(f0 mu)/2 + 33*(f1 mu)/4 + 27*(f0 nu) + 9*(- f1 nu) - 9/2);
      (37*(f0 mu)/2 + 33*(f1 mu)/4 + 15*(f0 nu) - 10*(- f1 nu) - 35/2);
      (-3*(f0 mu)*sqrt 2/2 - 7*(f1 mu)*sqrt 2/4 + 5*(- f1 nu)*sqrt 2/2 + 5*sqrt 2/2);
      (-119*(f0 mu) - 231*(f1 mu)/2 + 50*(f0 nu) + 200*(- f1 nu) + 175)]) by (intros mu nu;
    change (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)) with [Derive_n (fun t => nth 0 (E3 mu nu t) 0) 1 (1 /
        2); Derive_n (fun t => nth 1 (E3 mu nu t) 0) 1 (1 / 2);
      Derive_n (fun t => nth 2 (E3 mu nu t) 0) 1 (1 / 2); Derive_n (fun t => nth 3 (E3 mu nu t) 0) 1 (1 / 2)];
    rewrite W0, W1, W2, W3; change (Derive_n (fun _ : R => 1) 0 (1 / 2)) with 1;  rewrite ?rate_const, HA1,
    HA0, HC1, HC0; cbn [INR]; parts; clear; lra);
  assert (R2 : forall mu nu, vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2) = [(-15*(f1 mu) + 33*(f2 mu)/4 + 54*(-
          f1 nu) + 9*(f2 nu)); (37*(f1 mu) + 33*(f2 mu)/4 + 30*(- f1 nu) - 10*(f2 nu));
      (-3*(f1 mu)*sqrt 2 - 7*(f2 mu)*sqrt 2/4 + 5*(f2 nu)*sqrt 2/2);
      (-238*(f1 mu) - 231*(f2 mu)/2 + 100*(- f1 nu) + 200*(f2 nu))]) by (intros mu nu;
    change (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2)) with [Derive_n (fun t => nth 0 (E3 mu nu t) 0) 2 (1 /
        2); Derive_n (fun t => nth 1 (E3 mu nu t) 0) 2 (1 / 2);
      Derive_n (fun t => nth 2 (E3 mu nu t) 0) 2 (1 / 2); Derive_n (fun t => nth 3 (E3 mu nu t) 0) 2 (1 / 2)];
    rewrite W0, W1, W2, W3;  rewrite ?rate_const, HA2, HA1, HC2, HC1; cbn [INR]; parts; clear; lra);
  assert (R3 : forall mu nu, vDerive 4 (fun x => E3 mu nu x) 3 (1 / 2) = [(-45*(f2 mu)/2 + 33*(f3 mu)/4 +
        81*(f2 nu) + 9*(- f3 nu)); (111*(f2 mu)/2 + 33*(f3 mu)/4 + 45*(f2 nu) - 10*(- f3 nu));
      (-9*(f2 mu)*sqrt 2/2 - 7*(f3 mu)*sqrt 2/4 + 5*(- f3 nu)*sqrt 2/2);
      (-357*(f2 mu) - 231*(f3 mu)/2 + 150*(f2 nu) + 200*(- f3 nu))]) by (intros mu nu;
    change (vDerive 4 (fun x => E3 mu nu x) 3 (1 / 2)) with [Derive_n (fun t => nth 0 (E3 mu nu t) 0) 3 (1 /
        2); Derive_n (fun t => nth 1 (E3 mu nu t) 0) 3 (1 / 2);
      Derive_n (fun t => nth 2 (E3 mu nu t) 0) 3 (1 / 2); Derive_n (fun t => nth 3 (E3 mu nu t) 0) 3 (1 / 2)];
    rewrite W0, W1, W2, W3;  rewrite ?rate_const, HA3, HA2, HC3, HC2; cbn [INR]; parts; clear; lra);
  clear DA1 DA2 DA3 DC1 DC2 DC3 HA0 HA1 HA2 HA3 HC0 HC1 HC2 HC3 EE0 W0 EE1 W1 EE2 W2 EE3 W3 SA SC;  assert (X
    : exists c, c = -9225*PI^2*(1 / sqrt 2)/8 + 12915*PI^2/16 + 12915*PI*(1 / sqrt 2)/4 - 9225*PI/4 /\ -155 <
    c < -152) by (eexists; split; [reflexivity|split; numeric]); destruct X as (d21 & Qd21 & Bd21);
  assert (X : exists c, c = -189945*PI^2*(1 / sqrt 2)/64 + 144455*PI^2/64 + 23985*PI*(1 / sqrt 2)/8 -
    16605*PI/8 /\ 1702 < c) by (eexists; split; [reflexivity|numeric]); destruct X as (d20 & Qd20 & Bd20);
  assert (X : exists c, c = 9225*PI^2*(1 / sqrt 2)/8 - 12915*PI^2/16 - 12915*PI*(1 / sqrt 2)/4 + 9225*PI/4 /\
    152 < c < 155) by (eexists; split; [reflexivity|split; numeric]); destruct X as (d12 & Qd12 & Bd12);
  assert (X : exists c, c = -21605*PI^3*(1 / sqrt 2)/64 + 21605*PI^3/128 + 1085*PI^2*(1 / sqrt 2)/32 -
    775*PI^2/32 - 65745*PI*(1 / sqrt 2)/4 + 21915*PI/2 /\ -4260 < c < -4257) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (d11 & Qd11 & Bd11);
  assert (X : exists c, c = -21605*PI^3*(1 / sqrt 2)/128 + 21605*PI^3/128 - 2750*PI^2*(1 / sqrt 2) +
    28505*PI^2/16 - 9470*PI*(1 / sqrt 2) + 14845*PI/2 /\ 2204 < c < 2207) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (d10 & Qd10 & Bd10);
  assert (X : exists c, c = -201735*PI^2*(1 / sqrt 2)/64 + 160185*PI^2/64 - 23985*PI*(1 / sqrt 2)/8 +
    16605*PI/8 /\ 2564 < c) by (eexists; split; [reflexivity|numeric]); destruct X as (d02 & Qd02 & Bd02);
  assert (X : exists c, c = -21605*PI^3*(1 / sqrt 2)/128 + 21605*PI^3/128 - 128825*PI^2*(1 / sqrt 2)/32 +
    9155*PI^2/4 - 49935*PI*(1 / sqrt 2)/4 + 18105*PI/2 /\ -3268 < c < -3265) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (d01 & Qd01 & Bd01);
  assert (X : exists c, c = 21605*PI^3/128 - 11035*PI^2*(1 / sqrt 2)/16 + 65125*PI^2/32 - 11035*PI*(1 / sqrt
      2)/2 + 21915*PI/4 /\ 25460 < c < 25463) by (eexists; split; [reflexivity|split; numeric]);
  destruct X as (d00 & Qd00 & Bd00);  assert (X : exists c, c = -154375*PI^5*(1 / sqrt 2)/16 + 463125*PI^5/64
    - 771875*PI^4*(1 / sqrt 2)/4 + 1080625*PI^4/8 /\ -6940 < c < -6937) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (f21 & Qf21 & Bf21);
  assert (X : exists c, c = 463125*PI^5*(1 / sqrt 2)/16 - 154375*PI^5/16 - 463125*PI^4*(1 / sqrt 2)/2 +
    6329375*PI^4/32 /\ 6627948 < c) by (eexists; split; [reflexivity|numeric]);
  destruct X as (f20 & Qf20 & Bf20); pose (f12 := f21);
  assert (Qf12 : f12 = -154375*PI^5*(1 / sqrt 2)/16 + 463125*PI^5/64 - 771875*PI^4*(1 / sqrt 2)/4 +
    1080625*PI^4/8) by exact Qf21; assert (Bf12 : -6940 < f12 < -6937) by exact Bf21; clearbody f12;
  assert (X : exists c, c = -771875*PI^5*(1 / sqrt 2)/8 + 3550625*PI^5/64 - 771875*PI^4*(1 / sqrt 2)/4 +
    154375*PI^4/2 - 463125*PI^3*(1 / sqrt 2) + 463125*PI^3/2 /\ -12647269 < c < -12647266) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (f11 & Qf11 & Bf11);
  assert (X : exists c, c = 463125*PI^5/32 - 463125*PI^4*(1 / sqrt 2)/8 + 1080625*PI^4/16 - 463125*PI^3*(1 /
      sqrt 2)/2 + 463125*PI^3/2 /\ 9123349 < c < 9123352) by (eexists; split; [reflexivity|split; numeric]);
  destruct X as (f10 & Qf10 & Bf10); pose (f02 := f20);
  assert (Qf02 : f02 = 463125*PI^5*(1 / sqrt 2)/16 - 154375*PI^5/16 - 463125*PI^4*(1 / sqrt 2)/2 +
    6329375*PI^4/32) by exact Qf20; assert (Bf02 : 6627948 < f02) by exact Bf20; clearbody f02;
  pose (f01 := f10); assert (Qf01 : f01 = 463125*PI^5/32 - 463125*PI^4*(1 / sqrt 2)/8 + 1080625*PI^4/16 -
    463125*PI^3*(1 / sqrt 2)/2 + 463125*PI^3/2) by exact Qf10;
  assert (Bf01 : 9123349 < f01 < 9123352) by exact Bf10; clearbody f01;
  assert (X : exists c, c = 154375*PI^5*(1 / sqrt 2)/8 + 463125*PI^5/64 + 154375*PI^4*(1 / sqrt 2) +
    1389375*PI^4/16 + 463125*PI^3/2 /\ 32661720 < c) by (eexists; split; [reflexivity|numeric]);
  destruct X as (f00 & Qf00 & Bf00);  destruct (ex_intro (fun c => c = -7625*PI^2*(1 / sqrt 2)/4 +
      10675*PI^2/8 + 10675*PI*(1 / sqrt 2)/2 - 7625*PI/2) _ eq_refl) as (n21 & Qn21);
  destruct (ex_intro (fun c => c = 83975*PI^2*(1 / sqrt 2)/32 - 68025*PI^2/32 + 19825*PI*(1 / sqrt 2)/4 -
      13725*PI/4) _ eq_refl) as (n20 & Qn20);
  destruct (ex_intro (fun c => c = 7625*PI^2*(1 / sqrt 2)/4 - 10675*PI^2/8 - 10675*PI*(1 / sqrt 2)/2 +
      7625*PI/2) _ eq_refl) as (n12 & Qn12); destruct (ex_intro (fun c => c = -26225*PI^3*(1 / sqrt 2)/32 +
      26225*PI^3/64 + 24325*PI^2*(1 / sqrt 2)/16 - 17375*PI^2/16 - 99525*PI*(1 / sqrt 2)/2 + 33175*PI) _
    eq_refl) as (n11 & Qn11); assert (X : exists c, c = -26225*PI^3*(1 / sqrt 2)/64 + 26225*PI^3/64 +
    44375*PI^2*(1 / sqrt 2)/8 - 18275*PI^2/8 - 41175*PI*(1 / sqrt 2) + 34025*PI /\ 35310 < c < 35313) by
  (eexists; split; [reflexivity|split; numeric]); destruct X as (n10 & Qn10 & Bn10);
  destruct (ex_intro (fun c => c = -618575*PI^2*(1 / sqrt 2)/32 + 483825*PI^2/32 - 19825*PI*(1 / sqrt 2)/4 +
      13725*PI/4) _ eq_refl) as (n02 & Qn02);
  assert (X : exists c, c = -26225*PI^3*(1 / sqrt 2)/64 + 26225*PI^3/64 - 368375*PI^2*(1 / sqrt 2)/16 +
    25975*PI^2/2 - 53825*PI*(1 / sqrt 2)/2 + 17475*PI /\ -33661 < c < -33658) by (eexists; split;
    [reflexivity|split; numeric]); destruct X as (n01 & Qn01 & Bn01);
  assert (X : exists c, c = 26225*PI^3/64 - 18325*PI^2*(1 / sqrt 2)/8 + 85625*PI^2/16 - 18325*PI*(1 / sqrt 2)
    + 33175*PI/2 /\ 60939 < c < 60942) by (eexists; split; [reflexivity|split; numeric]);
  destruct X as (n00 & Qn00 & Bn00);  pose proof Rlt_sqrt2_0 as Q2;
  assert (S2 : (1 / sqrt 2) * (1 / sqrt 2) = 1 / 2) by (transitivity (1 / (sqrt 2 * sqrt 2));
    [field; lra|rewrite sqrt_sqrt; lra]); assert (D3 : forall mu nu, det [normal (E3 mu nu (1 / 2));
      normal (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2));
      normal (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2))] = sqrt 2 * (d21 * mu ^ 2 * nu ^ 1 + d20 * mu ^ 2 +
      d12 * mu ^ 1 * nu ^ 2 + d11 * mu ^ 1 * nu ^ 1 + d10 * mu ^ 1 + d02 * nu ^ 2 + d01 * nu ^ 1 + d00)) by
  (intros mu nu; transitivity (sqrt 2 * (1845*(f0 mu)^2*(- f1 nu) + 1845*(f0 mu)^2*(f2 nu)/4 - 1845*(f0
          mu)*(f1 mu)*(f0 nu) - 1845*(f0 mu)*(f1 mu)*(- f1 nu)/2 - 1845*(f0 mu)*(f2 mu)*(f0 nu)/4 - 1690*(f0
          mu)*(f2 mu) - 1845*(f0 mu)*(f0 nu)*(- f1 nu) + 1845*(f0 mu)*(f0 nu)*(f2 nu)/4 - 1845*(f0 mu)*(- f1
          nu)^2/2 - 11880*(f0 mu)*(- f1 nu) - 1280*(f0 mu)*(f2 nu) + 1845*(f1 mu)^2*(f0 nu)/2 + 3380*(f1 mu)^2
        + 1845*(f1 mu)*(f0 nu)^2 + 1845*(f1 mu)*(f0 nu)*(- f1 nu)/2 + 10035*(f1 mu)*(f0 nu) + 155*(f1 mu)*(-
          f1 nu)/2 - 21605*(f1 mu)*(f2 nu)/16 - 3380*(f1 mu) - 1845*(f2 mu)*(f0 nu)^2/4 + 4965*(f2 mu)*(f0
          nu)/4 + 21605*(f2 mu)*(- f1 nu)/16 + 845*(f2 mu) - 3750*(f0 nu)*(f2 nu) + 7500*(- f1 nu)^2 + 7500*(-
          f1 nu) + 1875*(f2 nu))); [rewrite R0, R1, R2;
      generalize (f0 mu) (f1 mu) (f2 mu) (f3 mu) (f0 nu) (f1 nu) (f2 nu) (f3 nu); intros; clear;
      cbv delta [normal]; lists; generalize (sqrt 2); intros; lra|];
    destruct (FF mu) as (_ & a0 & a1 & a2 & a3);
    destruct (FF nu) as (_ & b0 & b1 & b2 & b3);  rewrite ?a0, ?a1, ?a2, ?a3, ?b0, ?b1, ?b2, ?b3;
    rewrite Qd21, Qd20, Qd12, Qd11, Qd10, Qd02, Qd01, Qd00; revert S2; clear; generalize (1 / sqrt 2);
    generalize (sqrt 2); intros r0 s S2; apply (f_equal (Rmult r0));
    match goal with |- _ = ?e => transitivity (e + (s * s - 1 / 2) * (-1845*mu^2*nu*PI^2*s/4 +
        9225*mu^2*nu*PI^2/8 + 1845*mu^2*nu*PI*s - 3690*mu^2*nu*PI - 1845*mu^2*PI^2*s/4 + 75615*mu^2*PI^2/32 +
        1845*mu^2*PI*s - 12915*mu^2*PI/4 + 1845*mu*nu^2*PI^2*s/4 - 9225*mu*nu^2*PI^2/8 - 1845*mu*nu^2*PI*s +
        3690*mu*nu^2*PI + 21605*mu*nu*PI^3/64 - 155*mu*nu*PI^2/16 + 21915*mu*nu*PI/2 + 21605*mu*PI^3/64 -
        1845*mu*PI^2*s/4 + 28505*mu*PI^2/8 + 1845*mu*PI*s + 8190*mu*PI + 1845*nu^2*PI^2*s/4 +
        54945*nu^2*PI^2/32 - 1845*nu^2*PI*s + 12915*nu^2*PI/4 + 21605*nu*PI^3/64 + 1845*nu*PI^2*s/4 +
        9155*nu*PI^2/2 - 1845*nu*PI*s + 13725*nu*PI + 21605*PI^3/64 + 65125*PI^2/16 + 21915*PI/2)) end;
    [lra|rewrite S2, Rminus_eq_0, Rmult_0_l, Rplus_0_r; reflexivity]);
  assert (D4 : forall mu nu, det [E3 mu nu (1 / 2); vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2);
      vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2);
      vDerive 4 (fun x => E3 mu nu x) 3 (1 / 2)] = sqrt 2 * (f21 * mu ^ 2 * nu ^ 1 + f20 * mu ^ 2 + f12 * mu ^
      1 * nu ^ 2 + f11 * mu ^ 1 * nu ^ 1 + f10 * mu ^ 1 + f02 * nu ^ 2 + f01 * nu ^ 1 + f00)) by (intros mu
    nu; transitivity (sqrt 2 * (-926250*(f0 mu)*(f2 mu)*(f2 nu) - 154375*(f0 mu)*(f2 mu)*(- f3 nu) +
        617500*(f0 mu)*(f3 mu)*(- f1 nu) + 154375*(f0 mu)*(f3 mu)*(f2 nu) - 617500*(f0 mu)*(- f1 nu)*(- f3 nu)
        + 926250*(f0 mu)*(f2 nu)^2 + 1852500*(f1 mu)^2*(f2 nu) + 308750*(f1 mu)^2*(- f3 nu) - 1852500*(f1
          mu)*(f2 mu)*(- f1 nu) - 463125*(f1 mu)*(f2 mu)*(f2 nu) - 617500*(f1 mu)*(f3 mu)*(f0 nu) - 308750*(f1
          mu)*(f3 mu)*(- f1 nu) + 617500*(f1 mu)*(f0 nu)*(- f3 nu) - 1852500*(f1 mu)*(- f1 nu)*(f2 nu) +
        308750*(f1 mu)*(- f1 nu)*(- f3 nu) - 463125*(f1 mu)*(f2 nu)^2 - 1852500*(f1 mu)*(f2 nu) - 308750*(f1
          mu)*(- f3 nu) + 926250*(f2 mu)^2*(f0 nu) + 463125*(f2 mu)^2*(- f1 nu) - 926250*(f2 mu)*(f0 nu)*(f2
          nu) - 154375*(f2 mu)*(f0 nu)*(- f3 nu) + 1852500*(f2 mu)*(- f1 nu)^2 + 463125*(f2 mu)*(- f1 nu)*(f2
          nu) + 1852500*(f2 mu)*(- f1 nu) + 926250*(f2 mu)*(f2 nu) + 154375*(f2 mu)*(- f3 nu)/2 + 154375*(f3
          mu)*(f0 nu)*(f2 nu) - 308750*(f3 mu)*(- f1 nu)^2 - 308750*(f3 mu)*(- f1 nu) - 154375*(f3 mu)*(f2
          nu)/2)); [rewrite R0, R1, R2, R3; generalize (f0 mu) (f1 mu) (f2 mu) (f3 mu) (f0 nu) (f1 nu) (f2 nu)
      (f3 nu); intros; clear;  lists; generalize (sqrt 2); intros; lra|];
    destruct (FF mu) as (_ & a0 & a1 & a2 & a3);
    destruct (FF nu) as (_ & b0 & b1 & b2 & b3);  rewrite ?a0, ?a1, ?a2, ?a3, ?b0, ?b1, ?b2, ?b3;
    rewrite Qf21, Qf20, Qf12, Qf11, Qf10, Qf02, Qf01, Qf00; revert S2; clear; generalize (1 / sqrt 2);
    generalize (sqrt 2); intros r0 s S2; apply (f_equal (Rmult r0));
    match goal with |- _ = ?e => transitivity (e + (s * s - 1 / 2) * (154375*mu^2*nu*PI^5*s/8 +
        463125*mu^2*nu*PI^5/32 + 154375*mu^2*nu*PI^4*s - 154375*mu^2*nu*PI^4/4 + 154375*mu^2*PI^5*s/8 -
        154375*mu^2*PI^5/8 + 154375*mu^2*PI^4*s + 1389375*mu^2*PI^4/16 + 154375*mu*nu^2*PI^5*s/8 +
        463125*mu*nu^2*PI^5/32 + 154375*mu*nu^2*PI^4*s - 154375*mu*nu^2*PI^4/4 + 154375*mu*nu*PI^5*s/2 +
        3550625*mu*nu*PI^5/32 + 617500*mu*nu*PI^4*s - 154375*mu*nu*PI^4 + 463125*mu*nu*PI^3 +
        463125*mu*PI^5*s/8 + 463125*mu*PI^5/16 + 463125*mu*PI^4*s + 1080625*mu*PI^4/8 + 463125*mu*PI^3 +
        154375*nu^2*PI^5*s/8 - 154375*nu^2*PI^5/8 + 154375*nu^2*PI^4*s + 1389375*nu^2*PI^4/16 +
        463125*nu*PI^5*s/8 + 463125*nu*PI^5/16 + 463125*nu*PI^4*s + 1080625*nu*PI^4/8 + 463125*nu*PI^3 +
        154375*PI^5*s/4 + 463125*PI^5/32 + 308750*PI^4*s + 1389375*PI^4/8 + 463125*PI^3)) end;
    [lra|rewrite S2, Rminus_eq_0, Rmult_0_l, Rplus_0_r; reflexivity]);
  assert (MM : forall mu nu, nth 0 (middle_ mu nu) 0 = (sqrt 2 * (n21 * mu ^ 2 * nu ^ 1 + n20 * mu ^ 2 + n12 *
        mu ^ 1 * nu ^ 2 + n11 * mu ^ 1 * nu ^ 1 + n10 * mu ^ 1 + n02 * nu ^ 2 + n01 * nu ^ 1 + n00)) / (sqrt 2
      * (d21 * mu ^ 2 * nu ^ 1 + d20 * mu ^ 2 + d12 * mu ^ 1 * nu ^ 2 + d11 * mu ^ 1 * nu ^ 1 + d10 * mu ^ 1 +
        d02 * nu ^ 2 + d01 * nu ^ 1 + d00))) by (intros mu nu; rewrite <- D3;
    change (middle_ mu nu) with (meet (E3 mu nu (1 / 2)) (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2)) (vDerive
        4 (fun x => E3 mu nu x) 2 (1 / 2))); cbv delta [meet]; cbv beta; apply (f_equal (fun t => t / _));
    transitivity (sqrt 2 * (3050*(f0 mu)^2*(- f1 nu) + 1525*(f0 mu)^2*(f2 nu)/2 - 3050*(f0 mu)*(f1 mu)*(f0 nu)
        - 1525*(f0 mu)*(f1 mu)*(- f1 nu) - 1525*(f0 mu)*(f2 mu)*(f0 nu)/2 + 3900*(f0 mu)*(f2 mu) - 3050*(f0
          mu)*(f0 nu)*(- f1 nu) + 1525*(f0 mu)*(f0 nu)*(f2 nu)/2 - 1525*(f0 mu)*(- f1 nu)^2 - 34700*(f0 mu)*(-
          f1 nu) - 12575*(f0 mu)*(f2 nu) + 1525*(f1 mu)^2*(f0 nu) - 7800*(f1 mu)^2 + 3050*(f1 mu)*(f0 nu)^2 +
        1525*(f1 mu)*(f0 nu)*(- f1 nu) + 31650*(f1 mu)*(f0 nu) + 3475*(f1 mu)*(- f1 nu) - 26225*(f1 mu)*(f2
          nu)/8 + 7800*(f1 mu) - 1525*(f2 mu)*(f0 nu)^2/2 + 21675*(f2 mu)*(f0 nu)/2 + 26225*(f2 mu)*(- f1
          nu)/8 - 1950*(f2 mu) - 18750*(f0 nu)*(f2 nu) + 37500*(- f1 nu)^2 + 37500*(- f1 nu) + 9375*(f2 nu)));
    [rewrite R0, R1, R2; generalize (f0 mu) (f1 mu) (f2 mu) (f3 mu) (f0 nu) (f1 nu) (f2 nu) (f3 nu); intros;
      clear;  lists; generalize (sqrt 2); intros; lra|]; destruct (FF mu) as (_ & a0 & a1 & a2 & a3);
    destruct (FF nu) as (_ & b0 & b1 & b2 & b3);  rewrite ?a0, ?a1, ?a2, ?a3, ?b0, ?b1, ?b2, ?b3;
    rewrite Qn21, Qn20, Qn12, Qn11, Qn10, Qn02, Qn01, Qn00; revert S2; clear; generalize (1 / sqrt 2);
    generalize (sqrt 2); intros r0 s S2; apply (f_equal (Rmult r0));
    match goal with |- _ = ?e => transitivity (e + (s * s - 1 / 2) * (-1525*mu^2*nu*PI^2*s/2 +
        7625*mu^2*nu*PI^2/4 + 3050*mu^2*nu*PI*s - 6100*mu^2*nu*PI - 1525*mu^2*PI^2*s/2 - 17825*mu^2*PI^2/16 +
        3050*mu^2*PI*s - 10675*mu^2*PI/2 + 1525*mu*nu^2*PI^2*s/2 - 7625*mu*nu^2*PI^2/4 - 3050*mu*nu^2*PI*s +
        6100*mu*nu^2*PI + 26225*mu*nu*PI^3/32 - 3475*mu*nu*PI^2/8 + 33175*mu*nu*PI + 26225*mu*PI^3/32 -
        1525*mu*PI^2*s/2 - 18275*mu*PI^2/4 + 3050*mu*PI*s + 28600*mu*PI + 1525*nu^2*PI^2*s/2 +
        196025*nu^2*PI^2/16 - 3050*nu^2*PI*s + 10675*nu^2*PI/2 + 26225*nu*PI^3/32 + 1525*nu*PI^2*s/2 +
        25975*nu*PI^2 - 3050*nu*PI*s + 37750*nu*PI + 26225*PI^3/32 + 85625*PI^2/8 + 33175*PI)) end;
    [lra|rewrite S2, Rminus_eq_0, Rmult_0_l, Rplus_0_r; reflexivity]); clear R0 R1 R2 R3 FF; clear Qd21;
  clear Qd20; clear Qd12; clear Qd11; clear Qd10; clear Qd02; clear Qd01; clear Qd00; clear Qf21; clear Qf20;
  clear Qf12; clear Qf11; clear Qf10; clear Qf02; clear Qf01; clear Qf00; clear Qn21; clear Qn20; clear Qn12;
  clear Qn11; clear Qn10; clear Qn02; clear Qn01; clear Qn00;
  assert (T : forall B c t, - B <= c <= B -> -1 <= t <= 1 -> - B <= c * t <= B) by (clear; intros; split;
    nra); assert (T2 : forall a b, -1 <= a <= 1 -> -1 <= b <= 1 -> -1 <= a * b <= 1) by (clear; intros; split;
    nra); assert (P3 : forall mu nu, -1 <= mu <= 1 -> -1 <= nu <= 1 -> det [normal (E3 mu nu (1 / 2));
      normal (vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2));
      normal (vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2))] > 0) by (intros mu nu M N; rewrite D3;
    apply Rmult_lt_0_compat; [exact Q2|]; pose proof (T2 mu nu M N) as X1; pose proof (T2 mu mu M M) as X2;
    pose proof (T2 nu nu N N) as X3; pose proof (T2 (mu * mu) nu X2 N) as X4;
    pose proof (T2 mu (nu * nu) M X3) as X5; pose proof (Rle_0_sqr mu) as Y2; pose proof (Rle_0_sqr nu) as Y3;
    unfold Rsqr in Y2, Y3; pose proof (T 155 d21 (mu * mu * nu) ltac:(lra) X4);
    assert (0 <= d20 * (mu * mu)) by (apply Rmult_le_pos; lra);
    pose proof (T 155 d12 (mu * (nu * nu)) ltac:(lra) X5); pose proof (T 4260 d11 (mu * nu) ltac:(lra) X1);
    pose proof (T 2207 d10 (mu) ltac:(lra) M); assert (0 <= d02 * (nu * nu)) by (apply Rmult_le_pos; lra);
    pose proof (T 3268 d01 (nu) ltac:(lra) N); clear X1 X2 X3 X4 X5 Y2 Y3 M N; lra);
  assert (P4 : forall mu nu, -1 <= mu <= 1 -> -1 <= nu <= 1 -> det [E3 mu nu (1 / 2);
      vDerive 4 (fun x => E3 mu nu x) 1 (1 / 2); vDerive 4 (fun x => E3 mu nu x) 2 (1 / 2);
      vDerive 4 (fun x => E3 mu nu x) 3 (1 / 2)] > 0) by (intros mu nu M N; rewrite D4;
    apply Rmult_lt_0_compat; [exact Q2|]; pose proof (T2 mu nu M N) as X1; pose proof (T2 mu mu M M) as X2;
    pose proof (T2 nu nu N N) as X3; pose proof (T2 (mu * mu) nu X2 N) as X4;
    pose proof (T2 mu (nu * nu) M X3) as X5; pose proof (Rle_0_sqr mu) as Y2; pose proof (Rle_0_sqr nu) as Y3;
    unfold Rsqr in Y2, Y3; pose proof (T 6940 f21 (mu * mu * nu) ltac:(lra) X4);
    assert (0 <= f20 * (mu * mu)) by (apply Rmult_le_pos; lra);
    pose proof (T 6940 f12 (mu * (nu * nu)) ltac:(lra) X5);
    pose proof (T 12647269 f11 (mu * nu) ltac:(lra) X1); pose proof (T 9123352 f10 (mu) ltac:(lra) M);
    assert (0 <= f02 * (nu * nu)) by (apply Rmult_le_pos; lra); pose proof (T 9123352 f01 (nu) ltac:(lra) N);
    clear X1 X2 X3 X4 X5 Y2 Y3 M N; lra); intros mu nu M N; split;
  [exact (P3 mu nu M N)|split; [exact (P4 mu nu M N)|]]; clear P4 D4 T T2 M N mu nu; split; intro no;
  [assert (G : vDerive 3 (fun m => middle 0 m) 1 0 = zeros 3) by (apply (no 0 0); [lra|lra|];
      exists (mkposreal 1 Rlt_0_1); intros n B;
      assert (NN : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball];
        simpl; cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B;
        lra);  exact (Rgt_not_eq _ _ (P3 n 0 ltac:(lra) ltac:(lra)))); clear no P3 D3;
    apply (f_equal (fun v => nth 0 v 0)) in G;
    change (Derive_n (fun m => nth 0 (middle_ m 0) 0) 1 0 = 0) in G;
    rewrite (Derive_n_ext _ _ 1 0 (fun m => MM m 0)) in G;
    assert (V : is_derive (fun m => (sqrt 2 * (n21 * m ^ 2 * 0 ^ 1 + n20 * m ^ 2 + n12 * m ^ 1 * 0 ^ 2 + n11 *
            m ^ 1 * 0 ^ 1 + n10 * m ^ 1 + n02 * 0 ^ 2 + n01 * 0 ^ 1 + n00)) / (sqrt 2 * (d21 * m ^ 2 * 0 ^ 1 +
            d20 * m ^ 2 + d12 * m ^ 1 * 0 ^ 2 + d11 * m ^ 1 * 0 ^ 1 + d10 * m ^ 1 + d02 * 0 ^ 2 + d01 * 0 ^ 1
            + d00))) 0 ((n10 * d00 - n00 * d10) / d00 ^ 2)) by (auto_derive;
      [match goal with |- ?x <> 0 => replace x with (sqrt 2 * d00) by ring end;
        apply Rgt_not_eq, Rmult_lt_0_compat; lra|field; split; lra]); apply is_derive_unique in V;
    change (Derive_n (fun m => (sqrt 2 * (n21 * m ^ 2 * 0 ^ 1 + n20 * m ^ 2 + n12 * m ^ 1 * 0 ^ 2 + n11 * m ^
            1 * 0 ^ 1 + n10 * m ^ 1 + n02 * 0 ^ 2 + n01 * 0 ^ 1 + n00)) / (sqrt 2 * (d21 * m ^ 2 * 0 ^ 1 + d20
            * m ^ 2 + d12 * m ^ 1 * 0 ^ 2 + d11 * m ^ 1 * 0 ^ 1 + d10 * m ^ 1 + d02 * 0 ^ 2 + d01 * 0 ^ 1 +
            d00))) 1 0 = ((n10 * d00 - n00 * d10) / d00 ^ 2)) in V;  rewrite G in V; symmetry in V;
    assert (Z : n10 * d00 - n00 * d10 = 0) by (apply (Rmult_eq_reg_r (/ d00 ^ 2));
      [rewrite Rmult_0_l; exact V|apply Rinv_neq_0_compat, pow_nonzero; lra]);
    clear - Z Bn10 Bn01 Bn00 Bd00 Bd10 Bd01; nra|assert (G : vDerive 3 (fun m => middle_ 0 m) 1 0 = zeros 3)
    by (apply (no 0 0); [lra|lra|]; exists (mkposreal 1 Rlt_0_1); intros n B;
      assert (NN : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball];
        simpl; cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B;
        lra);  exact (Rgt_not_eq _ _ (P3 0 n ltac:(lra) ltac:(lra)))); clear no P3 D3;
    apply (f_equal (fun v => nth 0 v 0)) in G;
    change (Derive_n (fun m => nth 0 (middle_ 0 m) 0) 1 0 = 0) in G;
    rewrite (Derive_n_ext _ _ 1 0 (fun m => MM 0 m)) in G;
    assert (V : is_derive (fun m => (sqrt 2 * (n21 * 0 ^ 2 * m ^ 1 + n20 * 0 ^ 2 + n12 * 0 ^ 1 * m ^ 2 + n11 *
            0 ^ 1 * m ^ 1 + n10 * 0 ^ 1 + n02 * m ^ 2 + n01 * m ^ 1 + n00)) / (sqrt 2 * (d21 * 0 ^ 2 * m ^ 1 +
            d20 * 0 ^ 2 + d12 * 0 ^ 1 * m ^ 2 + d11 * 0 ^ 1 * m ^ 1 + d10 * 0 ^ 1 + d02 * m ^ 2 + d01 * m ^ 1
            + d00))) 0 ((n01 * d00 - n00 * d01) / d00 ^ 2)) by (auto_derive;
      [match goal with |- ?x <> 0 => replace x with (sqrt 2 * d00) by ring end;
        apply Rgt_not_eq, Rmult_lt_0_compat; lra|field; split; lra]); apply is_derive_unique in V;
    change (Derive_n (fun m => (sqrt 2 * (n21 * 0 ^ 2 * m ^ 1 + n20 * 0 ^ 2 + n12 * 0 ^ 1 * m ^ 2 + n11 * 0 ^
            1 * m ^ 1 + n10 * 0 ^ 1 + n02 * m ^ 2 + n01 * m ^ 1 + n00)) / (sqrt 2 * (d21 * 0 ^ 2 * m ^ 1 + d20
            * 0 ^ 2 + d12 * 0 ^ 1 * m ^ 2 + d11 * 0 ^ 1 * m ^ 1 + d10 * 0 ^ 1 + d02 * m ^ 2 + d01 * m ^ 1 +
            d00))) 1 0 = ((n01 * d00 - n00 * d01) / d00 ^ 2)) in V;  rewrite G in V; symmetry in V;
    assert (Z : n01 * d00 - n00 * d01 = 0) by (apply (Rmult_eq_reg_r (/ d00 ^ 2));
      [rewrite Rmult_0_l; exact V|apply Rinv_neq_0_compat, pow_nonzero; lra]);
    clear - Z Bn10 Bn01 Bn00 Bd00 Bd10 Bd01; nra].
Qed.

(* gbt-developable/sec-4.2.class.ends *)
Theorem met.
Proof.
  exists 0, 0; lra.
Qed.

(* gbt-developable/sec-4.2.class.ends *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros mu nu _ _;
  change (normal E3_0) with [13 / 2; 13 / 2; 13 / 2 * sqrt 2];
  assert (V0 : E3 mu nu 0%Z = E3_0) by exact (vector_start_value mu nu E3_0 E3_1 E3_2 E3_3 eq_refl eq_refl
    eq_refl); assert (V1 : E3 mu nu 1%Z = E3_3) by exact (vector_end_value mu nu E3_0 E3_1 E3_2 E3_3 eq_refl
    eq_refl eq_refl); assert (S1 : vDerive 4 (fun x => E3_ mu nu x) 1 0 = vscale (1 + PI / 2 * (1 + mu)) (vsub
      E3_1 E3_0)) by exact (vector_start_rate mu nu E3_0 E3_1 E3_2 E3_3 eq_refl eq_refl eq_refl 4 eq_refl);
  assert (T1 : vDerive 4 (fun x => E3_ mu nu x) 1 1 = vscale (1 + PI / 2 * (1 + nu)) (vsub E3_3 E3_2)) by
  exact (vector_end_rate mu nu E3_0 E3_1 E3_2 E3_3 eq_refl eq_refl eq_refl 4 eq_refl);
  eassert (S2 : vDerive 4 (fun x => E3_ mu nu x) 2 0 = [_; _; _; _]) by (repeat apply (f_equal2 (@cons R));
    [exact (cubic_start_second mu nu (13 / 2) (- (11 / 2)) (- 10) (25 / 2))
      | exact (cubic_start_second mu nu (13 / 2) (15 / 2) (- 10) (- (25 / 2)))
      | exact (cubic_start_second mu nu (13 / 2 * sqrt 2) (15 / 2 * sqrt 2) (10 * sqrt 2) (25 / 2 * sqrt 2))
      | exact (cubic_start_second mu nu 169 225 400 625) | reflexivity]);
  eassert (T2 : vDerive 4 (fun x => E3_ mu nu x) 2 1 = [_; _; _; _]) by (repeat apply (f_equal2 (@cons R));
    [exact (cubic_end_second mu nu (13 / 2) (- (11 / 2)) (- 10) (25 / 2))
      | exact (cubic_end_second mu nu (13 / 2) (15 / 2) (- 10) (- (25 / 2)))
      | exact (cubic_end_second mu nu (13 / 2 * sqrt 2) (15 / 2 * sqrt 2) (10 * sqrt 2) (25 / 2 * sqrt 2))
      | exact (cubic_end_second mu nu 169 225 400 625) | reflexivity]);
  eassert (S3 : vDerive 4 (fun x => E3_ mu nu x) 3 0 = [_; _; _; _]) by (repeat apply (f_equal2 (@cons R));
    [exact (cubic_start_third mu nu (13 / 2) (- (11 / 2)) (- 10) (25 / 2))
      | exact (cubic_start_third mu nu (13 / 2) (15 / 2) (- 10) (- (25 / 2)))
      | exact (cubic_start_third mu nu (13 / 2 * sqrt 2) (15 / 2 * sqrt 2) (10 * sqrt 2) (25 / 2 * sqrt 2))
      | exact (cubic_start_third mu nu 169 225 400 625) | reflexivity]); rewrite V0, V1, S1, T1, S2, T2, S3;
  clear V0 V1 S1 T1 S2 T2 S3; cbv beta zeta delta [normal E3_0 E3_1 E3_2 E3_3]; lists; generalize (sqrt 2);
  intro r; split; [lra|split; [lra|lra]].
Qed.

(* gbt-developable/sec-5.1.certify *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
  0, 0, 0; pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); pose proof (VE 1 0 0 0 0 1 0 0 0 0 0 (dot [0; 0;
        0] (start [0; 1; 0; 0] [1; 0; 0; 0] 0) + 1)) as V; clear VE;
  assert (VO : forall e0, vDerive 4 (fun e => O__ [0; 1; 0; 0] [0; 1; 0; 0] 1 [1; 0; 0; 0] [1; 0; 0; 0] [0; 0;
        0] 0 e) 1 e0 = _) by (exact V); assert (VP : forall e0, vDerive 4 (fun e => P__ [0; 1; 0; 0] 1 [1; 0;
        0; 0] [0; 0; 0] 0 e) 1 e0 = _) by (exact V); clear V PP;
  assert (D : forall e u w, dot (direction (vadd (vadd [1; 0; 0;
            0] (vscale e [0; 1; 0; 0])) (vscale (e ^ 2 / 2) [0; 0; 0; w])) [0 + e * 0; 1 + e * 0; 0 + e * 0;
        u]) (direction (vadd (vadd [1; 0; 0; 0] (vscale e [0; 1; 0; 0])) (vscale (e ^ 2 / 2) [0; 0; 0;
            w])) [0 + e * 0; 1 + e * 0; 0 + e * 0; u]) <> 0) by (clear; intros;
    cbv beta delta [direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field;
    lra end); rewrite VO, VP; split; [lra|split;
    [cbv beta delta [direction normal]; lists; lra|split;
      [lra|split; [reflexivity|split; [cbv beta iota delta [vscale map]; parts; ring|split;
            [lra|split; [exact (D 0 _ _)|split;
              [exact (D 0 _ _)|split; [apply filter_forall; intro e; rewrite VO; exact (D e _ _)|split;
              [lra|apply filter_forall; intro e; rewrite VP; exact (D e _ _)]]]]]]]]]].
Qed.

(* gbt-developable/sec-5.1.certify *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H6 into GN, H10 into F, H into GP, H3 into G;
  revert H0 H4 H5; clear - GN F GP G; intros NA Eh Ed; cbv beta iota zeta delta [vscale vadd zip map] in Ed;
  injection Eh as -> -> -> ->; injection Ed as -> -> -> ->;
  assert (F' : e1 <> 0) by (clear - F; intro Z; apply F; rewrite Z; ring);
  pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd));
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (PP [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, PP [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0 = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (GG : forall a b cc z p q r s t u v w : R, dot (direction [a; b; cc; z] [p; q; r; s]) (direction [a;
        b; cc; z] [p; q; r; s]) <> 0 -> locally (IZR 0) (fun e => dot (direction (PP [p; q; r; s] [t; u; v;
            w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0)) by (clear;
    intros a b cc z p q r s t u v w L; pose proof (generator_stays (fun e => a + e * p + e ^ 2 / 2 * t) (fun e
        => b + e * q + e ^ 2 / 2 * u) (fun e => cc + e * r + e ^ 2 / 2 * v) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) 0) as T; cbv beta zeta in T;
    rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
            (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 0
        0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q; r]) in T; exact (T L));
  assert (JS : forall a b cc z p q r s t u v w x : R, vadd (vscale x (direction (PP [p; q; r; s] [t; u; v;
            w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc;
          z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) 1 (IZR 0))) = vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p;
        q; r; s])) by (intros; rewrite PZ, VD; reflexivity);
  assert (NB : dot (direction [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2; gamma * d'3;
        gamma * d'4]) (direction [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2; gamma * d'3;
        gamma * d'4]) <> 0) by (clear - GN NA; revert NA; cbv beta delta [direction normal]; lists; intro NA;
    match type of NA with ?p <> 0 => match goal with |- ?q <> 0 => replace q with (gamma * gamma * p) by ring
    end end; repeat apply Rmult_integral_contrapositive_currified; assumption);
  destruct (K h'1 h'2 h'3 h'4 d'1 d'2 d'3 d'4 n'1 n'2 n'3 (dot [n'1; n'2;
        n'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3;
          h'4] x1) + e1) x1 (GG h'1 h'2 h'3 h'4 d'1 d'2 d'3 d'4 n'1 n'2 n'3 (dot [n'1; n'2;
          n'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3;
            h'4] x1) + e1) NA)) as (v1 & v2 & v3 & EA & A1 & A2);
  destruct (K h'1 h'2 h'3 h'4 (gamma * d'1) (gamma * d'2) (gamma * d'3) (gamma * d'4) n2'1 n2'2 n2'3 (dot
      [n2'1; n2'2; n2'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3;
          h'4] x1) + e2) (x1 / gamma) (GG h'1 h'2 h'3 h'4 (gamma * d'1) (gamma * d'2) (gamma * d'3) (gamma *
        d'4) n2'1 n2'2 n2'3 (dot [n2'1; n2'2;
          n2'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3;
            h'4] x1) + e2) NB)) as (w1 & w2 & w3 & EB & B1 & B2); clear K NB GG;
  assert (A : vadd (vscale (x1 / gamma) (direction [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2;
          gamma * d'3; gamma * d'4])) (foot [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2; gamma * d'3;
        gamma * d'4]) = vadd (vscale x1 (direction [h'1; h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) (foot [h'1;
        h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) by (apply (same_point gamma); [exact GN|exact NA|cbn;ring ..]);
  split; [exact (eq_trans (JS h'1 h'2 h'3 h'4 (gamma * d'1) (gamma * d'2) (gamma * d'3) (gamma * d'4) n2'1
        n2'2 n2'3 (dot [n2'1; n2'2; n2'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3;
              h'4] x1) + e2) (x1 / gamma)) (eq_trans A (eq_sym (JS h'1 h'2 h'3 h'4 d'1 d'2 d'3 d'4 n'1 n'2 n'3
            (dot [n'1; n'2; n'3] (start [d'1; d'2; d'3; d'4] [h'1; h'2; h'3; h'4] x1) + e1) x1))))|]; split;
  [|clear - GP G; apply Rdiv_lt_0_compat; assumption]; rewrite A in B2; clear A NA VD PZ JS;
  assert (CA : forall k e : R, k + e - k = e) by (clear; intros; ring);
  apply (fun E => eq_trans E (CA _ _)) in A2, B2; clear CA;
  assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 +
      (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b;
      cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl)));
    [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q *
            v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E;
        ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]]); assert (N2 : d'1 * w1 + (d'2 * w2 + (d'3 * w3 + 0)) = e2 / gamma)
  by (clear - B2 GN; apply (Rmult_eq_reg_l gamma); [|assumption]; apply (eq_trans (y := e2));
    [|symmetry; clear - GN; field; assumption]; refine (eq_trans _ B2); ring);
  refine (eq_trans (f_equal _ (EB : vDerive 3 (fun e => JB_ [d'1; d'2; d'3; d'4] [gamma * d'1; gamma * d'2;
            gamma * d'3; gamma * d'4] e2 gamma [h'1; h'2; h'3; h'4] [h'1; h'2; h'3; h'4] [n2'1; n2'2;
            n2'3] x1 e) 1 (IZR 0) = _)) (eq_trans _ (f_equal (fun V => vscale _ (cross _ V)) (eq_sym (EA :
            vDerive 3 (fun e => JA_ [d'1; d'2; d'3; d'4] e1 [h'1; h'2; h'3; h'4] [n'1; n'2;
              n'3] x1 e) 1 (IZR 0) = _))))); clear EA EB;
  refine (eq_trans (CR _ _ _ _ _ _ _ _ _ _ B1 N2) (eq_sym (eq_trans (f_equal (vscale _) (CR _ _ _ _ _ _ _ _ _
            _ A1 A2)) _))); clear - GN F'; cbv beta iota delta [vscale map];
  refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); field; split;
  assumption.
Qed.

(* gbt-developable/sec-5.1.certify.cusp *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; assert (Ua : F1_ 1 = [0; 20; 10;
      400]) by exact (vector_end_value 1 1 E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl);
  assert (Va : vDerive 4 (fun x => F1_ x) 1 1 = [0; (1 + PI) * 10; - ((1 + PI) * 10);
      0]) by (transitivity (vscale (1 + PI / 2 * (1 + 1)) (vsub [0; 20; 10; 400] [0; 10; 20; 400]));
    [exact (vector_end_rate 1 1 E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl)|lists; parts; field]);
  assert (Na : dot (direction (F1_ 1) (vDerive 4 (fun x => F1_ x) 1 1)) (direction (F1_ 1) (vDerive 4 (fun x
          => F1_ x) 1 1)) <> 0) by (rewrite Ua, Va; cbv delta [direction normal]; lists; pose proof PI_RGT_0;
    apply Rgt_not_eq; nra); assert (La : locally 1 (fun e => dot (direction (F1_ e) (vDerive 4 (fun x => F1_
            x) 1 e)) (direction (F1_ e) (vDerive 4 (fun x => F1_ x) 1 e)) <> 0)) by exact (generator_stays
    (fun x => entry (F1_ x) 1) (fun x => entry (F1_ x) 2) (fun x => entry (F1_ x) 3) ltac:(cbv delta [entry
        F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) 1 Na);  assert (Ub : F2_ 0 = [0; 20; 10; 400]) by exact (vector_start_value 1 1 [0; 20; 10;
      400] [0; 30; 0; 400] [0; 50; 0; 400] [0; 60; - 20; 400] eq_refl eq_refl eq_refl);
  assert (Vb : vDerive 4 (fun x => F2_ x) 1 0 = [0; (1 + PI) * 10; - ((1 + PI) * 10);
      0]) by (transitivity (vscale (1 + PI / 2 * (1 + 1)) (vsub [0; 30; 0; 400] [0; 20; 10; 400]));
    [exact (vector_start_rate 1 1 [0; 20; 10; 400] [0; 30; 0; 400] [0; 50; 0; 400] [0; 60; - 20;
          400] eq_refl eq_refl eq_refl 4 eq_refl)|lists; parts; field]);
  assert (Nb : dot (direction (F2_ 0) (vDerive 4 (fun x => F2_ x) 1 0)) (direction (F2_ 0) (vDerive 4 (fun x
          => F2_ x) 1 0)) <> 0) by (rewrite Ub, Vb; cbv delta [direction normal]; lists; pose proof PI_RGT_0;
    apply Rgt_not_eq; nra); assert (Lb : locally 0 (fun e => dot (direction (F2_ e) (vDerive 4 (fun x => F2_
            x) 1 e)) (direction (F2_ e) (vDerive 4 (fun x => F2_ x) 1 e)) <> 0)) by exact (generator_stays
    (fun x => entry (F2_ x) 1) (fun x => entry (F2_ x) 2) (fun x => entry (F2_ x) 3) ltac:(cbv delta [entry
        F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists; smooth_sum) 0 Nb);  split;
  [exact Na|split; [exact Nb|split; [exact La|split; [exact Lb|split; [exact La|exact Lb]]]]].
Qed.

(* gbt-developable/sec-5.1.certify.cusp *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros _ _ La Lb _ _;
  assert (Ua : F1_ 1 = [0; 20; 10; 400]) by exact (vector_end_value 1 1 E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl
    eq_refl); assert (Va : vDerive 4 (fun x => F1_ x) 1 1 = [0; (1 + PI) * 10; - ((1 + PI) * 10);
      0]) by (transitivity (vscale (1 + PI / 2 * (1 + 1)) (vsub [0; 20; 10; 400] [0; 10; 20; 400]));
    [exact (vector_end_rate 1 1 E1_0 E1_1 E1_2 E1_3 eq_refl eq_refl eq_refl 4 eq_refl)|lists; parts; field]);
  assert (Wa : exists s t, vDerive 4 (fun x => F1_ x) 2 1 = [0; s; t; 0] /\ s + t = - (40 * PI)) by (eexists;
    eexists; split; [cbv delta [F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists; at_ends;
      refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _)
              _ eq_refl)))); field|field]); assert (Za : forall x, nth 0 (profile1_ x) 0 = 0) by (intro x;
    assert (M : F1_ x = [0; entry (F1_ x) 2; entry (F1_ x) 3;
        entry (F1_ x) 4]) by (change (F1_ x) with [entry (F1_ x) 1; entry (F1_ x) 2; entry (F1_ x) 3;
        entry (F1_ x) 4] at 1; refine (f_equal2 (@cons _) _ eq_refl); cbv delta [F1_ F2_ E1_0 E1_1 E1_2 E1_3];
      lists; ring);  assert (D : vDerive 4 (fun x => F1_ x) 1 x = [0;
        entry (vDerive 4 (fun x => F1_ x) 1 x) 2; entry (vDerive 4 (fun x => F1_ x) 1 x) 3;
        entry (vDerive 4 (fun x => F1_ x) 1 x) 4]) by (change (vDerive 4 (fun x => F1_ x) 1 x) with [Derive_n
        (fun x => entry (F1_ x) 1) 1 x; entry (vDerive 4 (fun x => F1_ x) 1 x) 2;
        entry (vDerive 4 (fun x => F1_ x) 1 x) 3; entry (vDerive 4 (fun x => F1_ x) 1 x) 4] at 1;
      refine (f_equal2 (@cons _) _ eq_refl); rewrite (Derive_n_ext _ (fun _ => 0)) by (intro;
        cbv delta [F1_ F2_ E1_0 E1_1 E1_2 E1_3]; lists; ring);
      apply rate_const);  cbv delta [profile1_ foot direction moment normal]; cbv beta; rewrite D, M;
    generalize (entry (F1_ x) 2) (entry (F1_ x) 3) (entry (F1_ x) 4) (entry (vDerive 4 (fun x => F1_ x) 1 x)
      2) (entry (vDerive 4 (fun x => F1_ x) 1 x) 3) (entry (vDerive 4 (fun x => F1_ x) 1 x) 4); intros; lists;
    unfold Rdiv; ring); assert (Ka : (dot (normal (F1_ 1)) (profile1_ 1) = entry (F1_ 1) 4 /\ dot (normal
        (vDerive 4 (fun x => F1_ x) 1 1)) (profile1_ 1) = entry (vDerive 4 (fun x => F1_ x) 1 1) 4) /\ dot
    (normal (F1_ 1)) (vDerive 3 (fun x => profile1_ x) 1 1) = 0 /\ dot (normal (vDerive 4 (fun x => F1_ x) 1
        1)) (vDerive 3 (fun x => profile1_ x) 1 1) = entry (vDerive 4 (fun x => F1_ x) 2 1) 4 - dot (normal
      (vDerive 4 (fun x => F1_ x) 2 1)) (profile1_ 1)) by exact (foot_plane (fun x => entry (F1_ x) 1) (fun x
      => entry (F1_ x) 2) (fun x => entry (F1_ x) 3) (fun x => entry (F1_ x) 4) ltac:(cbv delta [entry F1_ F2_
        g E1_0 E1_1 E1_2 E1_3]; lists; smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3];
      lists; smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists; smooth_sum) 1 La);
  assert (Ya : exists v, profile1_ 1 = [0; 40 / 3; 40 / 3] /\ vDerive 3 (fun x => profile1_ x) 1 1 = [0; v;
      - 2 * v] /\ 30 * (1 + PI) * v = - (40 / 3) * (- (40 * PI))) by (destruct Wa as (s & t & W & ST);  assert
    (A : profile1_ 1 = [0; nth 1 (profile1_ 1) 0;
        nth 2 (profile1_ 1) 0]) by (change (profile1_ 1) with [nth 0 (profile1_ 1) 0; nth 1 (profile1_ 1) 0;
        nth 2 (profile1_ 1) 0] at 1; rewrite Za;
      reflexivity);  assert (B : vDerive 3 (fun x => profile1_ x) 1 1 = [0;
        Derive_n (fun x => nth 1 (profile1_ x) 0) 1 1;
        Derive_n (fun x => nth 2 (profile1_ x) 0) 1 1]) by (change (vDerive 3 (fun x => profile1_ x) 1 1) with
      [Derive_n (fun x => nth 0 (profile1_ x) 0) 1 1; Derive_n (fun x => nth 1 (profile1_ x) 0) 1 1;
        Derive_n (fun x => nth 2 (profile1_ x) 0) 1 1];
      rewrite (Derive_n_ext (fun x => nth 0 (profile1_ x) 0) (fun _ => 0)) by exact Za; rewrite rate_const;
      reflexivity);  rewrite Ua, Va, W, B, A in Ka; rewrite A, B; clear - Ka ST;
    generalize dependent (Derive_n (fun x => nth 1 (profile1_ x) 0) 1 1);
    generalize dependent (Derive_n (fun x => nth 2 (profile1_ x) 0) 1 1);
    generalize dependent (nth 1 (profile1_ 1) 0); generalize dependent (nth 2 (profile1_ 1) 0);
    intros z y w v; cbv delta [normal]; lists; intros [[K1 K2] [K3 K4]];
    pose proof PI_RGT_0;  assert (y = z) by (apply (Rmult_eq_reg_l ((1 + PI) * 10)); [lra|nra]);
    assert (y = 40 / 3) by lra; subst z y; assert (w = - 2 * v) by lra; subst w; exists v; split;
    [reflexivity|split; [reflexivity|]]; replace (- (40 * PI)) with (s + t); lra);
  assert (Ub : F2_ 0 = [0; 20; 10; 400]) by exact (vector_start_value 1 1 [0; 20; 10; 400] [0; 30; 0; 400] [0;
      50; 0; 400] [0; 60; - 20; 400] eq_refl eq_refl eq_refl);
  assert (Vb : vDerive 4 (fun x => F2_ x) 1 0 = [0; (1 + PI) * 10; - ((1 + PI) * 10);
      0]) by (transitivity (vscale (1 + PI / 2 * (1 + 1)) (vsub [0; 30; 0; 400] [0; 20; 10; 400]));
    [exact (vector_start_rate 1 1 [0; 20; 10; 400] [0; 30; 0; 400] [0; 50; 0; 400] [0; 60; - 20;
          400] eq_refl eq_refl eq_refl 4 eq_refl)|lists; parts; field]);
  assert (Wb : exists s t, vDerive 4 (fun x => F2_ x) 2 0 = [0; s; t; 0] /\ s + t = 40 * PI) by (eexists;
    eexists; split; [cbv delta [F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists; at_ends;
      refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _) eq_refl (f_equal2 (@cons _)
              _ eq_refl)))); field|field]); assert (Zb : forall x, nth 0 (profile2_ x) 0 = 0) by (intro x;
    assert (M : F2_ x = [0; entry (F2_ x) 2; entry (F2_ x) 3;
        entry (F2_ x) 4]) by (change (F2_ x) with [entry (F2_ x) 1; entry (F2_ x) 2; entry (F2_ x) 3;
        entry (F2_ x) 4] at 1; refine (f_equal2 (@cons _) _ eq_refl); cbv delta [F1_ F2_ E1_0 E1_1 E1_2 E1_3];
      lists; ring);  assert (D : vDerive 4 (fun x => F2_ x) 1 x = [0;
        entry (vDerive 4 (fun x => F2_ x) 1 x) 2; entry (vDerive 4 (fun x => F2_ x) 1 x) 3;
        entry (vDerive 4 (fun x => F2_ x) 1 x) 4]) by (change (vDerive 4 (fun x => F2_ x) 1 x) with [Derive_n
        (fun x => entry (F2_ x) 1) 1 x; entry (vDerive 4 (fun x => F2_ x) 1 x) 2;
        entry (vDerive 4 (fun x => F2_ x) 1 x) 3; entry (vDerive 4 (fun x => F2_ x) 1 x) 4] at 1;
      refine (f_equal2 (@cons _) _ eq_refl); rewrite (Derive_n_ext _ (fun _ => 0)) by (intro;
        cbv delta [F1_ F2_ E1_0 E1_1 E1_2 E1_3]; lists; ring);
      apply rate_const);  cbv delta [profile2_ foot direction moment normal]; cbv beta; rewrite D, M;
    generalize (entry (F2_ x) 2) (entry (F2_ x) 3) (entry (F2_ x) 4) (entry (vDerive 4 (fun x => F2_ x) 1 x)
      2) (entry (vDerive 4 (fun x => F2_ x) 1 x) 3) (entry (vDerive 4 (fun x => F2_ x) 1 x) 4); intros; lists;
    unfold Rdiv; ring); assert (Kb : (dot (normal (F2_ 0)) (profile2_ 0) = entry (F2_ 0) 4 /\ dot (normal
        (vDerive 4 (fun x => F2_ x) 1 0)) (profile2_ 0) = entry (vDerive 4 (fun x => F2_ x) 1 0) 4) /\ dot
    (normal (F2_ 0)) (vDerive 3 (fun x => profile2_ x) 1 0) = 0 /\ dot (normal (vDerive 4 (fun x => F2_ x) 1
        0)) (vDerive 3 (fun x => profile2_ x) 1 0) = entry (vDerive 4 (fun x => F2_ x) 2 0) 4 - dot (normal
      (vDerive 4 (fun x => F2_ x) 2 0)) (profile2_ 0)) by exact (foot_plane (fun x => entry (F2_ x) 1) (fun x
      => entry (F2_ x) 2) (fun x => entry (F2_ x) 3) (fun x => entry (F2_ x) 4) ltac:(cbv delta [entry F1_ F2_
        g E1_0 E1_1 E1_2 E1_3]; lists; smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3];
      lists; smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists;
      smooth_sum) ltac:(cbv delta [entry F1_ F2_ g E1_0 E1_1 E1_2 E1_3]; lists; smooth_sum) 0 Lb);
  assert (Yb : exists v, profile2_ 0 = [0; 40 / 3; 40 / 3] /\ vDerive 3 (fun x => profile2_ x) 1 0 = [0; v;
      - 2 * v] /\ 30 * (1 + PI) * v = - (40 / 3) * (40 * PI)) by (destruct Wb as (s & t & W & ST);  assert (A
      : profile2_ 0 = [0; nth 1 (profile2_ 0) 0;
        nth 2 (profile2_ 0) 0]) by (change (profile2_ 0) with [nth 0 (profile2_ 0) 0; nth 1 (profile2_ 0) 0;
        nth 2 (profile2_ 0) 0] at 1; rewrite Zb;
      reflexivity);  assert (B : vDerive 3 (fun x => profile2_ x) 1 0 = [0;
        Derive_n (fun x => nth 1 (profile2_ x) 0) 1 0;
        Derive_n (fun x => nth 2 (profile2_ x) 0) 1 0]) by (change (vDerive 3 (fun x => profile2_ x) 1 0) with
      [Derive_n (fun x => nth 0 (profile2_ x) 0) 1 0; Derive_n (fun x => nth 1 (profile2_ x) 0) 1 0;
        Derive_n (fun x => nth 2 (profile2_ x) 0) 1 0];
      rewrite (Derive_n_ext (fun x => nth 0 (profile2_ x) 0) (fun _ => 0)) by exact Zb; rewrite rate_const;
      reflexivity);  rewrite Ub, Vb, W, B, A in Kb; rewrite A, B; clear - Kb ST;
    generalize dependent (Derive_n (fun x => nth 1 (profile2_ x) 0) 1 0);
    generalize dependent (Derive_n (fun x => nth 2 (profile2_ x) 0) 1 0);
    generalize dependent (nth 1 (profile2_ 0) 0); generalize dependent (nth 2 (profile2_ 0) 0);
    intros z y w v; cbv delta [normal]; lists; intros [[K1 K2] [K3 K4]];
    pose proof PI_RGT_0;  assert (y = z) by (apply (Rmult_eq_reg_l ((1 + PI) * 10)); [lra|nra]);
    assert (y = 40 / 3) by lra; subst z y; assert (w = - 2 * v) by lra; subst w; exists v; split;
    [reflexivity|split; [reflexivity|]]; replace (40 * PI) with (s + t);
    lra);  destruct Ya as (v & A1 & A2 & A3); destruct Yb as (w & B1 & B2 & B3); change (F2 0%Z) with (F2_ 0);
  change (F1 1%Z) with (F1_ 1); change (profile1 1%Z) with (profile1_ 1);
  change (profile2 0%Z) with (profile2_ 0); rewrite Ua, Ub, Va, Vb, A1, A2, B1, B2; split;
  [reflexivity|split; [reflexivity|split; [reflexivity|split; [lists; parts; ring|]]]]; lists;
  pose proof PI_RGT_0; assert (0 < v) by nra; assert (w < 0) by nra; nra.
Qed.

(* gbt-developable/sec-5.1.certify.sheets *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0,
  0, 0, 0; assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v;
        w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); change O_ with P_; rewrite ?PZ, ?VD;
  assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear;
    cbv beta delta [direction normal]; lists; lra);
  assert (L : locally (IZR 0) (fun e => dot (direction (P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0;
            0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0; 0] e) 1 e)) (direction (P_ [0;
            1; 0; 0] [0; 0; 0; 1] [1; 0; 0; 0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0;
              0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear;
    cbv beta delta [P_ direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field;
    lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L;
  clear L D; first [lia | reflexivity | cbv beta delta [direction normal foot moment]; lists;
    first [lra|parts; ring]].
Qed.

(* gbt-developable/sec-5.1.certify.sheets *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H8 into GN; revert H0 H3 H5 H6 H9; clear - GN;
  intros Eh Ed NA LA LB; cbv beta iota zeta delta [vscale vadd zip map] in Ed; injection Eh as -> -> -> ->;
  injection Ed as -> -> -> ->; assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e =>
      dot (direction (P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) (direction (P_ [p;
            q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
              cc; z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (P_ [p;
              q; r; s] [t; u; v; w] [a; b; cc;
              z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (P_ [p; q;
            r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) 1 (IZR 0) = [v1; v2;
      v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x1 LA) as (v1 & v2 & v3 & EA & A1 & A2);
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ (x1 / gamma) LB) as (w1 & w2 & w3 & EB & B1 & B2); clear K LA LB; split;
  [clear; cbv beta delta [direction normal]; lists; parts; ring|split;
    [apply (same_foot gamma); [exact GN|exact NA|cbn;ring ..]|]];
  assert (A : vadd (vscale (x1 / gamma) (direction [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2;
          gamma * d'3; gamma * d'4])) (foot [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2; gamma * d'3;
        gamma * d'4]) = vadd (vscale x1 (direction [h'1; h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) (foot [h'1;
        h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) by (apply (same_point gamma); [exact GN|exact NA|cbn;ring ..]);
  cbv beta delta [e1 e2 JA_]; rewrite ?PZ, ?VD; rewrite A in B2; clear A NA VD PZ; revert A2 B2;
  match goal with |- context [vadd (vscale ?x ?a) ?b] => generalize (eq_refl : vadd (vscale x a) b = [nth 0
      (vadd (vscale x a) b) 0; nth 1 (vadd (vscale x a) b) 0; nth 2 (vadd (vscale x a) b) 0]);
  generalize (vadd (vscale x a) b) end; intros S ES A2 B2;
  assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 +
      (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b;
      cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl)));
    [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q *
            v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E;
        ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]]); split;
  [refine (eq_trans (f_equal _ (EA : vDerive 3 (fun e => JA _ _ _ x1 e) 1 (IZR 0) = _)) _); clear EA EB;
    revert ES A2; generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros; subst S;
    exact (CR _ _ _ _ _ _ _ _ _ _ A1 A2)|]; refine (eq_trans (f_equal _ (EB : vDerive 3 (fun e => JB _ _ gamma
          _ x1 e) 1 (IZR 0) = _)) _); clear EA EB A1 A2; revert ES B2;
  generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros; subst S;
  assert (N2 : d'1 * w1 + (d'2 * w2 + (d'3 * w3 + 0)) = (entry [dd2'1; dd2'2; dd2'3;
        dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0;
        r1]) / gamma) by (apply (Rmult_eq_reg_l gamma); [|assumption];
    apply (eq_trans (y := (entry [dd2'1; dd2'2; dd2'3;
            dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1])));
    [|symmetry; generalize (entry [dd2'1; dd2'2; dd2'3;
          dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1]); intro; clear - GN; field;
      assumption]; refine (eq_trans _ B2); ring); refine (eq_trans (CR _ _ _ _ _ _ _ _ _ _ B1 N2) _);
  exact (f_equal (fun u => vscale u _) (eq_sym (Ropp_div (entry [dd2'1; dd2'2; dd2'3;
            dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1]) gamma))).
Qed.

(* gbt-developable/sec-5.2.meaning *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros d1 d2 d3 d4 k1 k2 k3 k4 c1 c2 c3 c4 f1 f2 f3 f4 h1 h2 h3 h4 l1 l2 l3 l4 d
  d_ dd dd_ h h_ E F G; intros; rewrite E, F, G; repeat split.
Qed.

(* gbt-developable/sec-5.weighted.b.after division *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; assert (A : forall m, g (1 / 3) m 0 0%Z 2%Z = 1 / 2 - m / 4) by
  (intro m; cbv delta [g]; compute_goal; replace (PI / 2 * (1 / 3)) with (PI / 6) by field; rewrite sin_PI6;
    field); assert (C : forall m, g (1 / 3) m 0 0%Z 2%Z * 2 + g (1 / 3) m 0 1%Z 2%Z * 1 + g (1 / 3) m 0 2%Z
    2%Z * 1 = 3 / 2 - m / 4) by (intro m; transitivity (1 + g (1 / 3) m 0 0%Z 2%Z);
    [cbv delta [g]; compute_goal; ring|rewrite A; field]);
  specialize (no 2%Z (fun i => if (i =? 0)%Z then 1 else 0) 0 0 2 1 1 (1 / 3)); revert no;
  rewrite (Derive_n_ext _ (fun m => (1 - m / 2) / (3 / 2 - m / 4))) by (intro m; cbv delta [rational];
    cbv beta; rewrite C, A; apply (f_equal (fun t => t / _)); cbv beta iota delta [Z.eqb Pos.eqb]; field);
  intro no; assert (E : Derive_n (fun m => (1 - m / 2) / (3 / 2 - m / 4)) 2 0 = 0) by (apply no; try lia;
    try lra; exists (mkposreal 1 Rlt_0_1); intros n B;
    assert (N : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball]; simpl;
      cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B; lra);  rewrite C; lra);
  clear no; assert (F : Derive_n (fun m => (1 - m / 2) / (3 / 2 - m / 4)) 2 0 = - (2 / 27)) by (change (Derive
      (Derive (fun m => (1 - m / 2) / (3 / 2 - m / 4))) 0 = - (2 / 27));
    rewrite (Derive_ext_loc _ (fun m => - (1 / 2) / (3 / 2 - m / 4) ^ 2));
    [apply is_derive_unique; auto_derive; [lra|field]|exists (mkposreal 1 Rlt_0_1); intros n B;
      assert (N : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball];
        simpl; cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B;
        lra);  apply is_derive_unique; auto_derive; [lra|field; lra]]); rewrite F in E; lra.
Qed.

(* gbt-developable/thm-1.1.jets *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g]; intros; undifferentiated; members_at_ends; conjuncts; field.
Qed.

(* gbt-developable/thm-1.1.no-degeneration *)
Theorem met.
Proof.
  exists 3%Z, (4 / PI - 1), (1 - 8 / PI ^ 2), 1; repeat split; first [ lia | numeric | field; apply PI_neq0 ].
Qed.

(* gbt-developable/thm-1.1.no-degeneration *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros k mu nu p; intros;
  replace (IZR k * (IZR k - 1) * (IZR k - 2) * (p - 1) ^ 3) with (IZR k * (IZR k - 1) * (IZR k - 2) * p ^ 3 -
    3 * (IZR k - 2) * (IZR k * (IZR k - 1) * p ^ 2) + 3 * (IZR k - 1) * (IZR k - 2) * (IZR k * p) - IZR k *
    (IZR k - 1) * (IZR k - 2)) by ring; repeat match goal with E : _ = ?t |- context [?t] => rewrite <- E;
  clear E end; field.
Qed.

(* gbt-developable/thm-1.5 (printed) *)
Theorem refuted.
Proof.
  intro all; apply proved_there; hnf; intros mu nu x c1 c2 c3 k c c4 c5 i c6; exact (all mu nu c1 c2 k c
    c4 c5 i c6).
Qed.

(* gbt-developable/thm-1.5 *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not g]; intro no;
  specialize (no (-1) (-1) 0 ltac:(lra) ltac:(lra) ltac:(lra) 2%Z (unit 1) ltac:(lia));
  assert (H : unit 1 1 = 0) by (apply no; [ intros; cbv delta [unit]; compute_goal; circles; equal | lia ]);
  rewrite unit_one in H by reflexivity; lra.
Qed.

(* gbt-developable/thm-1.5.cubic *)
Theorem met.
Proof.
  exists 0, 0; lra.
Qed.

(* gbt-developable/thm-1.5.cubic *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g]; compute_goal; intros mu nu M N;
  replace (PI / 2 * (1 / 3)) with (PI / 6) by field; replace (PI / 2 * (2 / 3)) with (PI / 3) by field;
  rewrite sin_PI6, cos_PI6, sin_PI3, cos_PI3; assert (S : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra);
  pose proof (sqrt_pos 3) as Q; generalize dependent (sqrt 3); intros s S Q;
  assert (A : 172 / 100 < s < 175 / 100) by (split; nra);
  match goal with |- ?e > 0 => replace e with (mu^2*s/24 - mu^2/16 - mu*nu*s/4 + 7*mu*nu/16 - mu*s/18 +
    11*mu/72 + nu^2*s/24 - nu^2/16 - nu*s/18 + 11*nu/72 + s/18 + 1/36 + (s * s - 3) * (-mu^2/48 + mu*nu*s^2/48
      - mu*nu*s/12 + 7*mu*nu/48 - mu*s/24 + 5*mu/72 - nu^2/48 - nu*s/24 + 5*nu/72 + 1/12)) by field end;
  rewrite S; assert (0 <= (mu + 1) * (nu + 1) + (1 - mu) * (1 - nu)) by nra;
  assert (0 <= (s / 24 - 1 / 16) * (mu ^ 2 + nu ^ 2)) by nra;
  assert (0 <= (7 / 16 - s / 4) * (1 + mu * nu)) by nra; assert (0 <= (11 / 72 - s / 18) * (1 + mu)) by nra;
  assert (0 <= (11 / 72 - s / 18) * (1 + nu)) by nra; lra.
Qed.

(* gbt-developable/thm-2.sufficient *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, 2%Z, (fun _ => 0), (fun _ => 0), 0, 1, 0, 0, 0, 1, 0, 0, 0, 0,
  0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P [p; q; r; s] [t; u; v; w] [a; b;
      cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); change O__ with P_; change O_ with P;
  assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0;
        0]) <> 0) by (cbv beta delta [direction normal]; lists; lra); cbv beta delta [e1 e2 JA];
  rewrite ?PZ, ?VD; pose proof PI_RGT_0; assert (L : locally (IZR 0) (fun e => dot (direction (P_ [0; 1; 0;
            0] [0; 0; 0; 1] [1; 0; 0; 0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0;
              0] e) 1 e)) (direction (P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0;
            0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 1] [1; 0; 0;
              0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear;
    cbv beta iota zeta delta [P_ direction normal]; lists;
    match goal with |- ?d <> 0 => replace d with 1 by field; lra end); clear VD PZ VE;
  repeat match goal with |- _ /\ _ => split end; try exact D; try exact L; clear L; try clear D;
  first [lia | reflexivity | cbv delta [direction normal foot moment]; lists; first [lra|parts; ring]].
Qed.

(* gbt-developable/thm-2.sufficient *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; split;
  [cbv beta delta [H1 H2 g]; at_ends; exact H13|split;
    [cbv beta delta [H1_ H2_ g]; at_ends; clear - H13 H15 H17; rewrite H17, H13;
      generalize dependent (IZR l - 2 + PI / 2 * (1 + mu2)); intros;
      generalize dependent (IZR k - 2 + PI / 2 * (1 + nu1)); intros;  field; assumption|split;
      [cbv beta delta [H2 H2_ g]; at_ends; clear - H13 H15 H17 H20 H21; rewrite H17, H13;
        generalize dependent (IZR l - 2 + PI / 2 * (1 + mu2)); intros;
        generalize dependent (IZR k - 2 + PI / 2 * (1 + nu1)); intros;  field; repeat split;
        first [assumption|intro Z; apply H20; rewrite Z; ring]|]]]; cbv zeta in *;
  revert H18 H19 H22 H23 H24 H27 H28; clear - H21; intros Eh Ed NB NA LB F LA;
  cbv beta iota zeta delta [vscale map] in Ed; injection Eh as -> -> -> ->; injection Ed as -> -> -> ->;
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (P_ [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (P_ [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) (foot (P_ [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P [p; q; r; s] [t; u; v; w] [a; b;
      cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x1 LA) as (v1 & v2 & v3 & EA & A1 & A2);
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ (x1 / gamma) LB) as (w1 & w2 & w3 & EB & B1 & B2); clear K LA LB NB;
  rewrite PZ, VD in NA; revert F; cbv beta delta [e1 e2 JA]; rewrite ?PZ, ?VD; intro F;
  assert (A : vadd (vscale (x1 / gamma) (direction [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2;
          gamma * d'3; gamma * d'4])) (foot [h'1; h'2; h'3; h'4] [gamma * d'1; gamma * d'2; gamma * d'3;
        gamma * d'4]) = vadd (vscale x1 (direction [h'1; h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) (foot [h'1;
        h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) by (apply (same_point gamma); [exact H21|exact NA|cbn;ring ..]);
  split; [cbv delta [JB]; change O__ with P_; change O_ with P; cbv beta; rewrite PZ, VD; exact A|];
  rewrite A in B2; clear A NA VD PZ; revert A2 B2 F;
  match goal with |- context [vadd (vscale ?x ?a) ?b] => generalize (eq_refl : vadd (vscale x a) b = [nth 0
      (vadd (vscale x a) b) 0; nth 1 (vadd (vscale x a) b) 0; nth 2 (vadd (vscale x a) b) 0]);
  generalize (vadd (vscale x a) b) end; intros S ES A2 B2 F;
  refine (eq_trans (f_equal _ (EB : vDerive 3 (fun e => JB_ _ _ gamma _ x1 e) 1 (IZR 0) = _)) (eq_trans _
      (f_equal (fun V => vscale _ (cross _ V)) (eq_sym EA)))); clear EA EB; revert ES;
  generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros; subst S;
  assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 +
      (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b;
      cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl)));
    [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q *
            v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E;
        ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]]); assert (N2 : d'1 * w1 + (d'2 * w2 + (d'3 * w3 + 0)) = (entry
      [dd2'1; dd2'2; dd2'3; dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0;
        r1]) / gamma) by (apply (Rmult_eq_reg_l gamma);
    [refine (eq_trans _ (eq_trans B2 _)); [ring|symmetry; field_simplify_eq;
        [reflexivity|assumption]]|assumption]);
  refine (eq_trans (CR _ _ _ _ _ _ _ _ _ _ B1 N2) (eq_sym (eq_trans (f_equal (vscale _) (CR _ _ _ _ _ _ _ _ _
            (entry [dd'1; dd'2; dd'3; dd'4] 4 - dot (normal [dd'1; dd'2; dd'3; dd'4]) [r; r0;
              r1]) A1 A2)) _))); clear - H21 F; destruct (factors _ _ F) as [_ F']; clear F;
  generalize dependent (entry [dd'1; dd'2; dd'3; dd'4] 4 - dot (normal [dd'1; dd'2; dd'3; dd'4]) [r; r0; r1]);
  generalize (entry [dd2'1; dd2'2; dd2'3; dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1]);
  intros e f N; cbv beta iota delta [vscale map];
  refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); field; split;
  assumption.
Qed.

(* gbt-developable/thm-2.true.sheets *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0,
  0, 0, 1, 0, 0; assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P__ [p; q; r; s] [t; u;
        v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P_ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a;
        b; cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); change O__ with P__; change O_ with P_; rewrite ?PZ, ?VD;
  assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear;
    cbv beta delta [direction normal]; lists; lra);
  assert (L : locally (IZR 0) (fun e => dot (direction (P__ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
            0] e) (vDerive 4 (fun e => P__ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) (direction (P__ [0;
            1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P__ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
              0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear;
    cbv beta delta [P__ direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field;
    lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L;
  clear L D; first [lia | reflexivity | cbv beta delta [direction normal foot moment]; lists;
    first [lra|parts; ring]].
Qed.

(* gbt-developable/thm-2.true.sheets *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; rename H12 into RN, H10 into AN, H3 into RA; revert H H0 H5 H6 H8;
  clear - RN AN RA; intros Eh Ed NA LA LB; cbv beta iota zeta delta [vscale vadd zip map] in Ed, Eh;
  injection Eh as -> -> -> ->; injection Ed as -> -> -> ->;
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (P__ [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (P__ [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (P__ [p; q;
              r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a; b;
              cc; z] e) 1 e))) (foot (P__ [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P__ [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P_ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x1 LA) as (v1 & v2 & v3 & EA & A1 & A2);
  destruct (K _ _ _ _ _ _ _ _ _ _ _ _ (x1 / (rho * alpha)) LB) as (w1 & w2 & w3 & EB & B1 & B2);
  clear K LA LB; rewrite PZ, VD in NA; cbv beta delta [e1 e2 JA]; rewrite ?PZ, ?VD;
  assert (A : vadd (vscale (x1 / (rho * alpha)) (direction [rho * h'1; rho * h'2; rho * h'3;
          rho * h'4] [alpha * d'1 + s * h'1; alpha * d'2 + s * h'2; alpha * d'3 + s * h'3;
          alpha * d'4 + s * h'4])) (foot [rho * h'1; rho * h'2; rho * h'3; rho * h'4] [alpha * d'1 + s * h'1;
        alpha * d'2 + s * h'2; alpha * d'3 + s * h'3;
        alpha * d'4 + s * h'4]) = vadd (vscale x1 (direction [h'1; h'2; h'3; h'4] [d'1; d'2; d'3;
          d'4])) (foot [h'1; h'2; h'3; h'4] [d'1; d'2; d'3; d'4])) by (apply (same_point (rho * alpha));
    [exact RA|exact NA|cbn;ring ..]); split; [cbv delta [JB]; change O__ with P__; change O_ with P_;
    cbv beta; rewrite PZ, VD; exact A|]; rewrite A in B2; clear A NA VD PZ; revert A2 B2;
  match goal with |- context [vadd (vscale ?x ?a) ?b] => generalize (eq_refl : vadd (vscale x a) b = [nth 0
      (vadd (vscale x a) b) 0; nth 1 (vadd (vscale x a) b) 0; nth 2 (vadd (vscale x a) b) 0]);
  generalize (vadd (vscale x a) b) end; intros S ES A2 B2;
  assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 +
      (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b;
      cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *;
    refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl)));
    [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q *
            v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E;
        ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3)));
      [ring|rewrite ?Rplus_0_r, E; ring]]); split;
  [refine (eq_trans (f_equal _ EA) _); clear EA EB; revert ES A2;
    generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros; subst S; exact (CR _ _ _ _ _ _ _ _ _ _ A1 A2)|];
  refine (eq_trans (f_equal _ (EB : vDerive 3 (fun e => JB_ alpha _ _ _ rho x1 e) 1 (IZR 0) = _)) _);
  clear EA EB A1 A2; revert ES B2; generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros; subst S;
  assert (N2 : d'1 * w1 + (d'2 * w2 + (d'3 * w3 + 0)) = (entry [dd2'1; dd2'2; dd2'3;
        dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0;
        r1]) / alpha) by (apply (Rmult_eq_reg_l alpha); [|assumption];
    apply (eq_trans (y := (entry [dd2'1; dd2'2; dd2'3;
            dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1])));
    [|symmetry; generalize (entry [dd2'1; dd2'2; dd2'3;
          dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1]); intro; clear - AN; field;
      assumption]; assert (Z : rho * (h'1 * w1 + (h'2 * w2 + (h'3 * w3 + 0))) = 0) by (refine (eq_trans _ B1);
      ring); apply Rmult_integral in Z; destruct Z as [Z|Z]; [contradiction|]; refine (eq_trans _ B2);
    transitivity (alpha * (d'1 * w1 + (d'2 * w2 + (d'3 * w3 + 0))) + s * (h'1 * w1 + (h'2 * w2 + (h'3 * w3 +
            0)))); [rewrite Z; ring|ring]); assert (N1 : h'1 * w1 + (h'2 * w2 + (h'3 * w3 + 0)) = 0) by (apply
    (Rmult_eq_reg_l rho); [refine (eq_trans _ (eq_trans B1 _)); ring|assumption]);
  refine (eq_trans (CR _ _ _ _ _ _ _ _ _ _ N1 N2) _);
  exact (f_equal (fun u => vscale u _) (eq_sym (Ropp_div (entry [dd2'1; dd2'2; dd2'3;
            dd2'4] 4 - dot (normal [dd2'1; dd2'2; dd2'3; dd2'4]) [r; r0; r1]) alpha))).
Qed.

(* gbt-developable/thm-3.c *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-3.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends; intros k l P1 P2 mu1 mu2 nu1 nu2;
  intros; assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2))
    * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2.
Qed.

(* gbt-developable/thm-3.necessary.families *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck farin_boehm];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-3.necessary.families *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck farin_boehm]; sums_at_ends;
  intros k l P1 P2 mu1 mu2 nu1 nu2; intros; split;
  [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 l mu2; split;
    [ assumption | third_point P2 l mu2 nu2 ] end ].
Qed.

(* gbt-developable/thm-3.proofref.as meant *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement c cl ck farin_boehm];
  intros k l P1 P2 mu1 mu2 nu1 nu2 _ _ _ _ _ _ _ _ E _ N _ V _ _ G D _;
  apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) + PI ^ 2 * (1 - nu2)));
  [ match type of G with ?t = _ => transitivity (t - 4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu2)) * (P2 0%Z
        - 2 * P2 1%Z) - 2 * PI ^ 2 * mu2 * (P2 0%Z - P2 1%Z) + PI ^ 2 * (1 - nu2) * P2 1%Z) end;
    [ ring | rewrite G, V, E; field; split; assumption ] | exact D ].
Qed.

(* gbt-developable/thm-4.c (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums;
  compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-4.c (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends;
  intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros;
  assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * gamma
    * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2.
Qed.

(* gbt-developable/thm-4.c.true *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums;
  compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-4.c.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends;
  intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros;
  assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * gamma
    * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2.
Qed.

(* gbt-developable/thm-4.necessary.families *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck beta];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums;
  compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-4.necessary.families *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck beta]; sums_at_ends;
  intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros; split;
  [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 l mu2; split;
    [ assumption | third_point P2 l mu2 nu2 ] end ].
Qed.

(* gbt-developable/thm-4.true.curvature *)
Theorem met.
Proof.
  cbv beta delta [instance]; exists 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0,
  1, 0, 0, 0, 0, 0; intros d d_ dd dd_ h h_; assert (A : P d dd h 0%Z = h) by (subst d dd h;
    cbv beta delta [P]; lists; parts; field);
  assert (B : vDerive 4 (fun e => P_ d dd h e) 1 (IZR 0) = d) by (subst d dd h; cbv beta delta [P_]; lists;
    parts; derivatives; field); cbv zeta; rewrite A, B; subst d d_ dd dd_ h h_;
  cbv beta delta [direction normal]; lists; conjuncts; parts; lra.
Qed.

(* gbt-developable/thm-4.true.curvature *)
Theorem proved.
Proof.
  cbv beta delta [statement]; intros d1 d2 d3 d4 k1 k2 k3 k4 c1 c2 c3 c4 f1 f2 f3 f4 gamma h1 h2 h3 h4 l1 l2
  l3 l4 rho s u v w x1 d d_ dd dd_ h h_ _ E F G N _ _;
  assert (A : P d dd h 0%Z = h) by (subst d dd h; cbv beta delta [P]; lists; parts; field);
  assert (B : vDerive 4 (fun e => P_ d dd h e) 1 (IZR 0) = d) by (subst d dd h; cbv beta delta [P_]; lists;
    parts; derivatives; field); cbv beta zeta delta [e2 e1 JA] in *; rewrite A, B in *; clear A B;
  assert (J : exists a b c, vadd (vscale x1 (direction h d)) (foot h d) = [a; b;
      c] /\ h1 * a + h2 * b + h3 * c = h4 /\ d1 * a + d2 * b + d3 * c = d4) by (clear -N; subst d h;
    cbv beta delta [foot direction moment normal] in *; revert N; lists; intro N; do 3 eexists; split;
    [ reflexivity | split; (field; intro Z; apply N; lra) ]); destruct J as (a & b & c & J & H & D);
  rewrite J; clear J N; cbv beta delta [direction normal]; rewrite E, F, G; subst d h dd; lists; split;
  [ rewrite <- H, <- D; ring | split; ring ].
Qed.

(* gbt-developable/thm-4.true.necessary *)
Theorem met.
Proof.
  cbv beta zeta delta [instance g H2 H1 H2_ H1_ kappa2 cl c ck kappa1];
  exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0); lists;
  ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-developable/thm-4.true.necessary *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement g H2 H1 H2_ H1_ kappa2 cl c ck kappa1]; sums_at_ends;
  intros k l P1 P2 gamma mu1 mu2 nu1 nu2 rho s u v; intros; split;
  [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 l mu2; split;
    [ assumption | third_point P2 l mu2 nu2 ] end ].
Qed.

(* gbt-developable/thm-4.true.sheets *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0;
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc;
        z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b;
        cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0)
        (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0)
            eq_refl))))); rewrite ?PZ, ?VD; assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0;
        0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear; cbv beta delta [direction normal]; lists;
    lra); assert (L : locally (IZR 0) (fun e => dot (direction (P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
            0] e) (vDerive 4 (fun e => P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) (direction (P [0; 1;
            0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0;
              0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear;
    cbv beta delta [P direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field;
    lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L;
  clear L D; first [lia | reflexivity | cbv beta delta [direction normal foot moment]; lists;
    first [lra|parts; ring]].
Qed.

(* gbt-developable/thm-4.true.sheets *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros; revert H0 H3 H4; clear; intros E L N;
  cbv beta iota zeta delta [vscale vadd zip map] in E; injection E as -> -> -> ->;
  assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (P [p; q; r;
            s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) (direction (P [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (P [p; q; r;
              s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc;
              z] e) 1 e))) (foot (P [p; q; r; s] [t; u; v; w] [a; b; cc;
            z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1;
      v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u;
      v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s]))) by (clear; intros a b cc z p q r s t u v w x L;
    pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e
        => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t)
      (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T;
    cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _)
          (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e
          => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b;
        cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q
            u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p +
          e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q;
        r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0)
          (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 /
          2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0;
        Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u;
        v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z),
    (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split;
    [reflexivity|split; [exact T1|exact T2]]);
  assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc;
        z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u)
        (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w)
            eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a;
      b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros;
    exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2
          (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl)))));
  assert (OP : forall a b cc z p q r s x : R, dot (direction [a; b; cc; z] [p; q; r; s]) (direction [a; b; cc;
        z] [p; q; r; s]) <> 0 -> dot [a; b; cc] (vadd (vscale x (direction [a; b; cc; z] [p; q; r;
            s])) (foot [a; b; cc; z] [p; q; r; s])) = z /\ dot [p; q;
      r] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r;
          s])) = s) by (clear; intros a b cc z p q r s x N; revert N;
    cbv beta delta [direction normal foot moment]; lists; intro N; rewrite ?Rplus_0_r in *; split; field;
    exact N); destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x1 L) as (v1 & v2 & v3 & EA & A1 & A2); clear K L A1;
  rewrite PZ, VD in N; cbv beta delta [e1 e2 JA_]; rewrite PZ, VD;
  destruct (OP _ _ _ _ _ _ _ _ x1 N) as [O1 O2]; clear OP N PZ VD; split;
  [refine (eq_trans (f_equal _ EA) _); exact A2|]; clear EA A2; revert O1 O2;
  match goal with |- context [vadd (vscale ?x ?a) ?b] => generalize (eq_refl : vadd (vscale x a) b = [nth 0
      (vadd (vscale x a) b) 0; nth 1 (vadd (vscale x a) b) 0; nth 2 (vadd (vscale x a) b) 0]);
  generalize (vadd (vscale x a) b) end; intros S ES O1 O2; revert ES O1 O2;
  generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros r0 r1 r2 ->; cbv beta delta [normal]; lists;
  intros <- <-; ring.
Qed.
