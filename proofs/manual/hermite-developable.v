(* Scripts of theorems of hermite-developable whose proofs have an idea of their own: nobody has to read them.
  This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* hermite-developable/abs.construct.a *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0, 0, 0, 0, 0;
  cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part
      cubic_criterion cubic_criterion_ cubic_criterion__ cubic_criterion___ cubic_criterion____ p0]);
  met_joins.
Qed.

(* hermite-developable/abs.construct.a *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion
    cubic_criterion_ cubic_criterion__ cubic_criterion___ cubic_criterion____ p0]; similar_cubics cubic_basis;
  split; [by_coefficients | split; [apply (cancelled k);
      [nonzero | rewrite Rmult_0_r; unfold entry; cbn [nth Nat.pred];
        match goal with T : forall x, _ = _ * poly (slope ?p) x |- _ * poly (slope ?p) ?u = _ => rewrite <- (T
          u) end; by_coefficients] | parallel_tangents]].
Qed.

(* hermite-developable/abs.construct.b *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_criterion
    quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____
    q0 q1 q0u q1u p0 pm]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2),
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_joins quartic_basis; met_joins.
Qed.

(* hermite-developable/abs.construct.b *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_criterion
    quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____
    q0 q1 q0u q1u p0 pm]; similar_quartics quartic_basis; assert (k <> 0) by lra; worth_times k p0u'1 0;
  worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; split;
  [by_coefficients | split; [by_coefficients | parallel_tangents]].
Qed.

(* hermite-developable/abs.construct.c *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [pu q5 p5 quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ q0 q1 q0u q1u p0 pm blend6 hermite5]); met_joins.
Qed.

(* hermite-developable/abs.construct.c *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement pu q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__
    quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ q0 q1 q0u q1u p0
    pm blend6 hermite5]; similar_quintics quintic_basis; assert (k <> 0) by lra; worth_times k p0u'1 0;
  worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; worth qu'1 0; split;
  [by_coefficients | split; [by_coefficients | parallel_tangents]].
Qed.

(* hermite-developable/abs.construct.d *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0
    (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no;
  with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k
        o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
        quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5])
    curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r5 p5 p0 pm blend6
        hermite5]) curve); compute_goal; intro C; contradiction_in C.
Qed.

(* hermite-developable/alg-3.1.step2 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  match goal with |- context [det (cubic_system ?A ?B ?C ?E ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h)] => let S :=
  constr:(cubic_system A B C E k o a b c d e f g h) in let E := fresh in assert (E : S = A35 k) by (cbv beta
    zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system];
    with_cubic_numbers cubic_basis system_joins); rewrite E; clear E end; cbv beta zeta delta [A35];
  met_joins; determinants; numeric.
Qed.

(* hermite-developable/alg-3.1.step2 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement right_ x];
  intros; match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A35 k) by
  (cbv beta zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system];
    with_cubic_numbers cubic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra;
  unfold solve; cbv beta delta [A35]; match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 /
      k; - 1 / k; 0; - 1 / k]; [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0];
    [6 / k; - 2 / k; 1 / k; - 1 / k]] end; compute_goal; conjuncts; parts; field; assumption.
Qed.

(* hermite-developable/alg-3.1.step3 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance A35]; stage cubic; stage cubic_; stage cubic_data;
  exists 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, (1 / 2); met_joins; determinants; numeric.
Qed.

(* hermite-developable/alg-3.1.step3 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement p]; intros;
  assert (k <> 0) by lra; assert (E : X k o q0 q0u q1 q1u = [(q1 - (1 - k) * o) / k; q0u / k; q1u / k;
      (q0 - (1 - k) * o) / k]) by (unfold X, solve; cbv beta delta [A35];
    match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 / k; - 1 / k; 0; - 1 / k];
      [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0]; [6 / k; - 2 / k; 1 / k; - 1 / k]] end;
    compute_goal; parts; field; assumption); rewrite E; clear E; cbv beta zeta delta [q3 hermite3 blend4];
  with_cubic_numbers cubic_basis number_curves;
  cbv beta iota zeta delta [entry nth Nat.pred slope_n slope slopes tl poly cubic_of]; field; assumption.
Qed.

(* hermite-developable/eq-3.1.difficulties.same *)
Theorem met.
Proof.
  cbv beta zeta delta [instance q q_ p_ p gap part criterion criterion__ criterion___ criterion____
    criterion_____ criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); joins ltac:(fun u => apply monomial_curve);
  counted_joins; met_joins.
Qed.

(* hermite-developable/eq-3.1.difficulties.same *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement q q_ p_ p gap part criterion criterion__ criterion___ criterion____
    criterion_____ criterion______]; intros; joins ltac:(fun u => apply monomial_curve);
  cbv beta iota delta [zeros repeat]; similarities 5%nat;
  repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve;
  cbv beta iota delta [slope_n]; images; compute_goal; parts; ring.
Qed.

(* hermite-developable/eq-3.1.rho-constant *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); cbv beta zeta delta [parallel q p];
  ratios ltac:(fun u => apply monomial_curve); met_joins.
Qed.

(* hermite-developable/eq-3.1.rho-constant *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement parallel q q_ p p_]; intros; ratios ltac:(fun u => apply monomial_curve);
  in_ratio; compute_goal; parts; ring.
Qed.

(* hermite-developable/eq-3.2.every-degree *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1%Z, 0, (fun _ => 0); repeat match goal with |- _ /\ _ => split end;
  intros; try (left; lia); try lia; apply filter_forall; intros; left; lia.
Qed.

(* hermite-developable/eq-3.2.every-degree *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement leading H H_]; intros n c d N _ _ _ _;
  rewrite Rmult_0_r, Rmult_0_l, Rplus_0_r; rewrite sum_last by lia;
  rewrite (sum_ext 0 (n - 1) _ (fun _ => 0 * 0)) by (intros i I; rewrite (natural_power 0 (n - i)) by lia;
    replace (Z.to_nat (n - i)) with (S (Z.to_nat (n - i - 1))) by lia; cbn [pow]; ring);
  rewrite sum_scal, Rmult_0_l, Rplus_0_l; rewrite Z.sub_diag, !natural_power by lia; rewrite pow1;
  cbn [Z.to_nat pow]; assert (F : forall m, falling (INR m) m = 1) by (let m := fresh in intro m;
    induction m as [|m IH]; [ reflexivity | pose proof (not_zero m); apply Rmult_eq_reg_r with (INR (S m));
      [ rewrite S_INR at 1; rewrite lowered, IH, S_INR; ring | assumption ] ]);
  assert (B1 : binom (IZR n) n = 1) by (unfold binom; destruct (Z.leb_spec 0 n); [ | lia ];
    transitivity (falling (INR (Z.to_nat n)) (Z.to_nat n)); [ | apply F ]; f_equal;
    rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); rewrite B1; ring.
Qed.

(* hermite-developable/eq-3.2.planes.a.direction *)
Theorem met.
Proof.
  cbv beta zeta delta [instance P Q dp dq]; exists 1, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  refine (conj _ (conj _ _)); [ lra | lra | compute_goal; parts; ring ].
Qed.

(* hermite-developable/eq-3.2.planes.a.direction *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement P Q dp dq]; intros; intro no;
  assert (absurd : 1 = 0) by (apply (no 1 2 0 0 0 1 0 0 0 0 0 0 0 0);
    [ lra | lra | compute_goal; parts; ring ]); lra.
Qed.

(* hermite-developable/eq-3.2.planes.a.generatrix *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not P Q dp dq]; intro no;
  apply (no 0 2 0 0 0 0 0 0 0 0 0 ltac:(lra) ltac:(lra));
  [ compute_goal; parts; ring | intros h k x0 y0 y1 y2 y3 z0 z1 z2 z3 K N E; compute_in E; injection E;
    intros; lra ].
Qed.

(* hermite-developable/eq-3.2.planes.b.direction *)
Theorem refuted.
Proof.
  assert (C : forall f0 f1 f2 f3 f4 f5 k s u, across f0 f1 f2 f3 f4 f5 k s u = poly [k * f0 + k * f1 - (1 - k)
      * s; k * f1 + 2 * k * f2; k * f2 + 3 * k * f3; k * f3 + 4 * k * f4; k * f4 + 5 * k * f5;
      k * f5] u) by (intros; cbv beta delta [across f]; derivatives; cbn [poly]; ring);
  assert (P : forall f0 f1 f2 f3 f4 f5 k s z, part f0 f1 f2 f3 f4 f5 k s z = nth (Z.to_nat z) [k * f0 + k * f1
      - (1 - k) * s; k * f1 + 2 * k * f2; k * f2 + 3 * k * f3; k * f3 + 4 * k * f4; k * f4 + 5 * k * f5;
      k * f5] 0) by (intros; exact (coefficient_of _ _ (Z.to_nat z) (C f0 f1 f2 f3 f4 f5 k s)));
  cbv beta zeta delta [statement]; intro no; apply (no 0 0 0 0 0 0 1 0 (1 / 2)); clear no;
  [lra | lra | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia
    | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | rewrite !P;
    cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth]; repeat split; ring
    | intros f0 f1 f2 f3 f4 f5 k s u K U _ _ _ _ _ _ _ _ _ _ _ _ E; rewrite !P in E;
    cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth] in E;
    destruct E as (E5 & E4 & E3 & E2 & E1 & E0); assert (Z5 : f5 = 0) by (apply (cancelled k); [lra | lra]);
    subst f5; assert (Z4 : f4 = 0) by (apply (cancelled k); [lra | lra]); subst f4;
    assert (Z3 : f3 = 0) by (apply (cancelled k); [lra | lra]); subst f3;
    assert (Z2 : f2 = 0) by (apply (cancelled k); [lra | lra]); subst f2;
    assert (Z1 : f1 = 0) by (apply (cancelled k); [lra | lra]); subst f1; cbv beta delta [f]; derivatives;
    ring].
Qed.

(* hermite-developable/eq-3.2.planes.b.generatrix *)
Theorem refuted.
Proof.
  assert (C : forall f0 f1 f2 f3 f4 f5 k u, across f0 f1 f2 f3 f4 f5 k u = poly [f0 + k * f1; f1 + 2 * k * f2;
      f2 + 3 * k * f3; f3 + 4 * k * f4; f4 + 5 * k * f5; f5] u) by (intros; cbv beta delta [across f];
    derivatives; cbn [poly]; ring); assert (P : forall f0 f1 f2 f3 f4 f5 k z, part f0 f1 f2 f3 f4 f5 k z = nth
    (Z.to_nat z) [f0 + k * f1; f1 + 2 * k * f2; f2 + 3 * k * f3; f3 + 4 * k * f4; f4 + 5 * k * f5;
      f5] 0) by (intros; exact (coefficient_of _ _ (Z.to_nat z) (C f0 f1 f2 f3 f4 f5 k)));
  cbv beta zeta delta [statement]; intro no; apply (no 0 0 0 0 0 0 1 (1 / 2)); clear no;
  [lra | lra | lia | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | lia
    | compute_goal; numeric | lia | compute_goal; numeric | lia | compute_goal; numeric | rewrite !P;
    cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth]; repeat split; ring
    | intros f0 f1 f2 f3 f4 f5 k u K U _ _ _ _ _ _ _ _ _ _ _ _ E; rewrite !P in E;
    cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add nth] in E;
    destruct E as (E5 & E4 & E3 & E2 & E1 & E0); assert (Z5 : f5 = 0) by (lra); subst f5;
    assert (Z4 : f4 = 0) by (lra); subst f4; assert (Z3 : f3 = 0) by (lra); subst f3;
    assert (Z2 : f2 = 0) by (lra); subst f2; assert (Z1 : f1 = 0) by (lra); subst f1; cbv beta delta [f];
    derivatives; ring].
Qed.

(* hermite-developable/eq-3.3.developable.Hermite *)
Theorem met.
Proof.
  cbv beta zeta delta [instance q p gap part criterion criterion__ criterion___ criterion____ criterion_____
    criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); joins ltac:(fun u => apply monomial_curve); counted_joins;
  met_joins.
Qed.

(* hermite-developable/eq-3.3.developable.Hermite *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement q p gap part criterion criterion__ criterion___ criterion____ criterion_____
    criterion______]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat];
  similarities 5%nat; repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve;
  cbv beta iota delta [slope_n]; images; any_points; compute_goal; conjuncts; parts; ring.
Qed.

(* hermite-developable/eq-3.3.k-below-1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement P Q cone_gap cone_normal]; intros dlam a b c k lam d e f x y z; compute_goal;
  intros K N S G1 G2; assert (E : lam - k = 0) by (match type of N with ?n <> 0 => apply (Rmult_eq_reg_r n);
    [ rewrite Rmult_0_l; match type of G1 with ?g = 0 => replace ((lam - k) * n) with g by ring; exact G1 end
      | exact N ] end); replace lam with k by lra; split;
  [ parts; ring | match type of S with ?s > 0 => match goal with |- ?l < 0 => replace l with (- (k * (1 - k) *
        s)) by ring; assert (0 < k * (1 - k)) by nra;
    assert (0 < k * (1 - k) * s) by (apply Rmult_lt_0_compat; lra); lra end end ].
Qed.

(* hermite-developable/eq-3.3.k-equal-1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement P Q cone_gap cone_normal]; intros dlam a b c k lam d e f x y z; compute_goal;
  intros N S K G1 G2; assert (E : lam - k = 0) by (match type of N with ?n <> 0 => apply (Rmult_eq_reg_r n);
    [ rewrite Rmult_0_l; match type of G1 with ?g = 0 => replace ((lam - k) * n) with g by ring; exact G1 end
      | exact N ] end); replace lam with 1 by lra; parts; ring.
Qed.

(* hermite-developable/eq-3.3.multiples.Hermite *)
Theorem met.
Proof.
  cbv beta zeta delta [instance q p gap part criterion criterion__ criterion___ criterion____ criterion_____
    criterion______]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); joins ltac:(fun u => apply monomial_curve); counted_joins;
  met_joins.
Qed.

(* hermite-developable/eq-3.3.multiples.Hermite *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement q p gap part criterion criterion__ criterion___ criterion____ criterion_____
    criterion______]; intros; joins ltac:(fun u => apply monomial_curve); cbv beta iota delta [zeros repeat];
  similarities 5%nat; repeat curve_at ltac:(fun u => apply monomial_curve); rewrite !monomial_curve;
  cbv beta iota delta [slope_n]; images; any_points; compute_goal; conjuncts; parts; ring.
Qed.

(* hermite-developable/eq-3.5.A.r1 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.A.r1 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins.
Qed.

(* hermite-developable/eq-3.5.A.r2 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.A.r2 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins.
Qed.

(* hermite-developable/eq-3.5.A.r3 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.A.r3 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins.
Qed.

(* hermite-developable/eq-3.5.A.r4 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.A.r4 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_cubic_numbers cubic_basis system_joins.
Qed.

(* hermite-developable/eq-3.5.B *)
Theorem refuted.
Proof.
  unfold not; stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement];
  intro no; generalize (no 0 0 0 0 2 0 0 1 0 0 0 0 0 0); clear no; premises_met; intro C;
  apply (f_equal (fun v => nth 3 v 0)) in C; revert C;
  cbv beta iota zeta delta [A35 cubic_system mvec map nth dot zip fold_right];
  rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r;
  match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with (- 2) by (symmetry;
    cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part];
    with_cubic_numbers cubic_basis system_joins) end; lra.
Qed.

(* hermite-developable/eq-3.5.B (corrected) *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.B (corrected) *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement]; intros;
  apply (f_equal2 mvec); [cbv beta zeta delta [A35 blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_system];
    with_cubic_numbers cubic_basis system_joins | reflexivity].
Qed.

(* hermite-developable/eq-3.5.C.r1 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.C.r1 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part];
  cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.5.C.r2 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.C.r2 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part];
  cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.5.C.r3 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.C.r3 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part];
  cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.5.C.r4 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.5.C.r4 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement A35 blend4 hermite3 q3 p3 cubic_gap cubic_part];
  cubic_number_joins cubic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.5.k *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
  (1 / 2);
  cubic_parts cubic_basis ltac:(cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part
      cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]); met_joins.
Qed.

(* hermite-developable/eq-3.5.k *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__
    cubic_criterion___ cubic_criterion____]; similar_cubics cubic_basis; images; any_points; compute_goal;
  conjuncts; parts; ring.
Qed.

(* hermite-developable/eq-3.5.sol.p0 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.5.sol.p0 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found.
Qed.

(* hermite-developable/eq-3.5.sol.p0u *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.5.sol.p0u *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found.
Qed.

(* hermite-developable/eq-3.5.sol.p1 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.5.sol.p1 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found.
Qed.

(* hermite-developable/eq-3.5.sol.p1u *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_number_joins cubic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.5.sol.p1u *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_number_joins cubic_basis; found.
Qed.

(* hermite-developable/eq-3.5.unique *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 1, 0, 0, 0, 0; cbv beta zeta delta [A35]; determinants;
  numeric.
Qed.

(* hermite-developable/eq-3.5.unique *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement right_ x]; intros;
  assert (K : k <> 0) by (let E := fresh in intro E; match goal with H : det _ <> 0 |- _ => apply H;
    rewrite E; cbv beta delta [A35]; sparse_det; ring end); unfold solve; cbv beta delta [A35];
  match goal with |- context [inverse ?A] => inverse_known A (k ^ 4) [[2 / k; - 1 / k; 0; - 1 / k];
    [- 6 / k; 2 / k; - 1 / k; 0]; [- 3 / k; 0; - 1 / k; 0]; [6 / k; - 2 / k; 1 / k; - 1 / k]] end;
  compute_goal; conjuncts; parts; field; assumption.
Qed.

(* hermite-developable/eq-3.6.A.r1 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.A.r1 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins.
Qed.

(* hermite-developable/eq-3.6.A.r2 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.A.r2 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins.
Qed.

(* hermite-developable/eq-3.6.A.r3 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.A.r3 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins.
Qed.

(* hermite-developable/eq-3.6.A.r4 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.A.r4 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins.
Qed.

(* hermite-developable/eq-3.6.A.r5 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.A.r5 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quartic_numbers quartic_basis system_joins.
Qed.

(* hermite-developable/eq-3.6.B *)
Theorem refuted.
Proof.
  unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0 1); clear no;
  premises_met; intro C; apply (f_equal (fun v => nth 4 v 0)) in C; revert C;
  cbv beta iota zeta delta [A36 quartic_system mvec map nth dot zip fold_right];
  rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r;
  match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with 0 by (symmetry;
    cbv beta zeta delta [blend5 hermite4 q4 p4 quartic_gap quartic_part];
    with_quartic_numbers quartic_basis system_joins) end; lra.
Qed.

(* hermite-developable/eq-3.6.B (corrected) *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.B (corrected) *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement];
  intros; apply (f_equal2 mvec); [cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part
      quartic_system]; with_quartic_numbers quartic_basis system_joins | reflexivity].
Qed.

(* hermite-developable/eq-3.6.C.r1 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.C.r1 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part];
  quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.6.C.r2 *)
Theorem refuted.
Proof.
  unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; intro no;
  generalize (no 0 0 0 0 0 2 0 1 0 0 0 0 0 0 0 0 0); clear no; quartic_number_joins quartic_basis; fails.
Qed.

(* hermite-developable/eq-3.6.C.r2 (corrected) *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.C.r2 (corrected) *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part];
  quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.6.C.r3 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.C.r3 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part];
  quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.6.C.r4 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.C.r4 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part];
  quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.6.C.r5 *)
Theorem refuted.
Proof.
  unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part]; intro no;
  generalize (no 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 1 0); clear no; quartic_number_joins quartic_basis; fails.
Qed.

(* hermite-developable/eq-3.6.C.r5 (corrected) *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.C.r5 (corrected) *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement A36 blend5 hermite4 q4 p4 quartic_gap quartic_part];
  quartic_number_joins quartic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.6.det.true *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.6.det.true *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement];
  intros; match goal with |- det ?A = ?v /\ det ?S = ?v => let E := fresh in assert (E : S = A) by (cbv beta
    zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system];
    with_quartic_numbers quartic_basis system_joins); rewrite E; clear E;
  assert (D : det A = v) by (cbv beta delta [A36]; sparse_det; ring); rewrite D end; split; reflexivity.
Qed.

(* hermite-developable/eq-3.6.k *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.k *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  intros; with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; found.
Qed.

(* hermite-developable/eq-3.6.k.135-136 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance k quartic_gap quartic_part quartic_criterion quartic_criterion__
    quartic_criterion___ quartic_criterion____ quartic_criterion_____ A36 blend5 hermite4 quartic_criterion_
    q4 p4]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis;
  met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.k.135-136 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement k quartic_gap quartic_part quartic_criterion quartic_criterion__
    quartic_criterion___ quartic_criterion____ quartic_criterion_____ A36 blend5 hermite4 quartic_criterion_
    q4 p4]; quartic_number_joins quartic_basis; split; [determinants; numeric | found].
Qed.

(* hermite-developable/eq-3.6.k.every *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quartic_number_parts quartic_basis ltac:(cbv beta zeta delta [blend5 hermite4 quartic_criterion_ q4 p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.k.every *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  intros; with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; found.
Qed.

(* hermite-developable/eq-3.6.sol.o *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.sol.o *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_number_joins quartic_basis; found.
Qed.

(* hermite-developable/eq-3.6.sol.p0u *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.sol.p0u *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_number_joins quartic_basis; found.
Qed.

(* hermite-developable/eq-3.6.sol.p1 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.sol.p1 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_number_joins quartic_basis; found.
Qed.

(* hermite-developable/eq-3.6.sol.p1u *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.sol.p1u *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_number_joins quartic_basis; found.
Qed.

(* hermite-developable/eq-3.6.sol.q *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [instance blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_number_joins quartic_basis; met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/eq-3.6.sol.q *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_number_joins quartic_basis; found.
Qed.

(* hermite-developable/eq-3.6.system *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2, 0, 0, 0, 0, 0, 0; cbv beta zeta delta [A36]; determinants;
  conjuncts; numeric.
Qed.

(* hermite-developable/eq-3.6.system *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement A36 right_]; intros; unfold solve;
  match goal with |- context [inverse ?A] => inverse_known A (- 16 * k ^ 3 * (k - 1)) [[- 151 / 16; 19 / 8;
      - 3 / 4; 1 / 2; 0]; [15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [24 / k; - 6 / k; 2 / k; - 1 / k; 0];
    [8 / k; - 3 / k; 0; - 1 / k; 0]; [24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1);
      1 / (k - 1)]] end; compute_goal; (parts; field; nonzero).
Qed.

(* hermite-developable/eq-3.7.A.r1 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r1 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.A.r2 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r2 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.A.r3 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r3 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.A.r4 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r4 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.A.r5 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r5 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.A.r6 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.A.r6 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system row];
  cbv beta iota delta [nth Nat.pred]; intros; with_quintic_numbers quintic_basis system_joins.
Qed.

(* hermite-developable/eq-3.7.B *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0 0 1 0);
  clear no; premises_met; intro C; apply (f_equal (fun v => nth 5 v 0)) in C; revert C;
  cbv beta iota zeta delta [A37 quintic_system mvec map nth dot zip fold_right];
  rewrite !Rmult_0_r, !Rplus_0_l, !Rmult_1_r;
  match goal with |- context [Derive_n ?f 1 1] => replace (Derive_n f 1 1) with 0 by (symmetry;
    cbv beta zeta delta [blend6 hermite5 q5 p5 quintic_gap quintic_part];
    with_quintic_numbers quintic_basis system_joins) end; lra.
Qed.

(* hermite-developable/eq-3.7.B (corrected) *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.B (corrected) *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement];
  intros; apply (f_equal2 mvec); [cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part
      quintic_system]; with_quintic_numbers quintic_basis system_joins | reflexivity].
Qed.

(* hermite-developable/eq-3.7.C.r1 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r1 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.C.r2 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r2 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.C.r3 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r3 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.C.r4 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r4 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.C.r5 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r5 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.C.r6 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.C.r6 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement A37 blend6 hermite5 q5 p5 quintic_gap quintic_part];
  quintic_number_joins quintic_basis; intros; cbv beta iota delta [row entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/eq-3.7.det *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement A37]; intros; sparse_det; ring.
Qed.

(* hermite-developable/eq-3.7.k *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.k *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins;
  found.
Qed.

(* hermite-developable/eq-3.7.k.needed *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/eq-3.7.k.needed *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement];
  intros; match goal with |- det (quintic_system ?A ?B ?C ?E ?F ?G ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j ?l ?m _) =
  0 /\ _ => assert (S : forall k : Z, quintic_system A B C E F G o a b c d e f g h i j l m k = A37 (IZR k)) by
  (intro k; cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system];
    with_quintic_numbers quintic_basis system_joins) end;
  assert (D : forall k, det (A37 k) = 256 * k ^ 3 * (k - 1)) by (intro k; cbv beta delta [A37]; sparse_det;
    ring); rewrite !S, !D; split; ring.
Qed.

(* hermite-developable/eq-3.7.sol.o *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.o *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; quintic_number_joins quintic_basis; found.
Qed.

(* hermite-developable/eq-3.7.sol.p0u *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.p0u *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins;
  found.
Qed.

(* hermite-developable/eq-3.7.sol.p1 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.p1 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; quintic_number_joins quintic_basis; found.
Qed.

(* hermite-developable/eq-3.7.sol.p1u *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.p1u *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; quintic_number_joins quintic_basis; found.
Qed.

(* hermite-developable/eq-3.7.sol.q *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.q *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; quintic_number_joins quintic_basis; found.
Qed.

(* hermite-developable/eq-3.7.sol.qu *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/eq-3.7.sol.qu *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintic_numbers quintic_basis joins_of_numbers; data_of_joins;
  found.
Qed.

(* hermite-developable/eq-3.7.system *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2, 0, 0, 0, 0, 0, 0, 0; cbv beta zeta delta [A37]; determinants;
  conjuncts; numeric.
Qed.

(* hermite-developable/eq-3.7.system *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement A37 right_]; intros; unfold solve;
  match goal with |- context [inverse ?A] => inverse_known A (256 * k ^ 3 * (k - 1)) [[- 120 / k; 24 / k;
      - 6 / k; 2 / k; - 1 / k; 0]; [1165 / 16; - 29 / 2; 15 / 4; - 1; 1; 0];
    [- 45 / k; 8 / k; - 3 / k; 0; - 1 / k; 0]; [1511 / 32; - 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0];
    [- 76 / k; 15 / k; - 4 / k; 1 / k; - 1 / k; 0];
    [- 120 / (k - 1); 24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end;
  compute_goal; (parts; field; nonzero).
Qed.

(* hermite-developable/eq-4.2 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/eq-4.2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end;
  match goal with |- context [?n / ?d] => assert (W : w = n / d) by (apply value_of; [ assumption | lra ]);
  rewrite <- W; clear W end; parts; ring.
Qed.

(* hermite-developable/eq-4.2.tangent.true *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal chord first image];
  exists 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0; met.
Qed.

(* hermite-developable/eq-4.3 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/eq-4.3 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end;
  match goal with |- context [?n / ?d] => assert (W : s = n / d) by (apply value_of; [ assumption | lra ]);
  rewrite <- W; clear W end; parts; ring.
Qed.

(* hermite-developable/eq-4.4.r1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/eq-4.4.r1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end;
  match goal with |- context [?zz / ?d] => assert (W : n = zz / d) by (apply value_of; [ assumption | lra ]);
  rewrite <- W; clear W end; parts; ring.
Qed.

(* hermite-developable/eq-4.4.r1u *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal r1]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0,
  0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/eq-4.4.r1u *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal r1 image]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end;
  match goal with |- _ = (?z / ?d * _ - _) :: _ => assert (W : m = z / d) by (apply value_of;
    [ assumption | lra ]); rewrite <- W; clear W end; parts; ring.
Qed.

(* hermite-developable/eq-4.4.ru *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal r]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0,
  0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/eq-4.4.ru *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal r image]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end;
  match goal with |- _ = (?m / ?d * _ - _) :: _ => assert (W : t = m / d) by (apply value_of;
    [ assumption | lra ]); rewrite <- W; clear W end; parts; ring.
Qed.

(* hermite-developable/eq-4.4.tangent.end point *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1,
  0, 0, 0; met.
Qed.

(* hermite-developable/eq-4.4.tangent.end point *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement image ru r1u r r1];
  intros a'1 a'2 a'3 d'1 d'2 d'3 o'1 o'2 o'3 q0'1 q0'2 q0'3 q1'1 q1'2 q1'3 q1u'1 q1u'2 q1u'3 qm'1 qm'2 qm'3
  qu'1 qu'2 qu'3 _ _ _ _ _ _; assert (M : forall x y z x' y' z', vsub (vadd [x; y; z] [x'; y'; z']) [o'1; o'2;
      o'3] = vadd (vsub [x; y; z] [o'1; o'2; o'3]) [x'; y'; z']) by (intros; compute_goal; parts; ring);
  rewrite !M; clear M; repeat match goal with |- context [dot ?a ?b / dot ?c ?d] => generalize (dot a b / dot
    c d) end; intros; compute_goal; conjuncts; parts; ring.
Qed.

(* hermite-developable/eq-4.4.tangent.parallel *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal chord last image r ru r1 r1u];
  exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0; met.
Qed.

(* hermite-developable/ex-3.1.arrange *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (fun _ => 0), (fun _ => 0), (fun _ => 0),
  (fun _ => 0);
  with_cubic_numbers cubic_basis ltac:(fun curve => conjuncts; intros; conjuncts;
    cbv beta zeta delta [blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion__
      cubic_criterion___ cubic_criterion____ cubic_criterion_]; joins_of_numbers curve; counted_joins);
  met_joins; first [lra | numeric].
Qed.

(* hermite-developable/ex-3.1.arrange *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement solved0 solved1 solved0_ solved1_ blend4 hermite3 q3 p3 cubic_gap cubic_part
    cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_criterion_];
  intros A B C_ E_ k o p0 p0u p1 p1u q0 q0u q1 q1u u p1_of_o p0u_of_o p1u_of_o p0_of_o U K DD _ _ _ _ _ _ _ _
  CR KN e1 e2 e3 e4 FN; assert (F : forall s, p0_of_o s = (q0 + (k - 1) * s) / k /\ p1_of_o s = (q1 + (k - 1)
      * s) / k) by (intro s; clear CR e1 e2 e3 e4; specialize (FN s);
    with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; split;
    (apply value_of; [assumption | lra])); clear FN; split; [rewrite <- e4; apply F |]; split;
  [rewrite <- e1; apply F |]; split; [parts; [apply (affine _ (fun s => (q0 + (k - 1) * s) / k))
      | apply (affine _ (fun s => (q1 + (k - 1) * s) / k))];
    first [intro; apply F | intro; field; assumption] |];
  clear F e1 e2 e3 e4 p1_of_o p0u_of_o p1u_of_o p0_of_o;
  let away := (clear CR; let no := fresh in intro no; generalize (no 0 0 0 0 1 1 0 0 0 0 0 0 0 0 (1 / 2));
  clear no;
    with_cubic_numbers cubic_basis joins_of_numbers; counted_joins;
    repeat lazymatch goal with |- (?A -> _) -> False => let K := fresh in assert (K : A) by first [premise
      | near]; let N := fresh in intro N; specialize (N K); clear K; revert N end; derivatives;
    let C := fresh in intro C; contradiction_in C) in split; [away |]; split; [away |];
  with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; with_cubic_numbers cubic_basis values;
  images; field; assumption.
Qed.

(* hermite-developable/ex-3.1.p0 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis;
  met_joins.
Qed.

(* hermite-developable/ex-3.1.p0 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly.
Qed.

(* hermite-developable/ex-3.1.p0u *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis;
  met_joins.
Qed.

(* hermite-developable/ex-3.1.p0u *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly.
Qed.

(* hermite-developable/ex-3.1.p1 *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis;
  met_joins.
Qed.

(* hermite-developable/ex-3.1.p1 *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly.
Qed.

(* hermite-developable/ex-3.1.p1u *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [instance q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____];
  exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30); cubic_joins cubic_basis;
  met_joins.
Qed.

(* hermite-developable/ex-3.1.p1u *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; cubic_joins cubic_basis; linearly.
Qed.

(* hermite-developable/ex-3.1.parallel *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, (-10), 30, (45/2), 0, 0, 0, (-10), 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0, 0, 0;
  cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part
      cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ cubic_basis_ hermite3_ p3_ x]);
  met_joins.
Qed.

(* hermite-developable/ex-3.1.parallel *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____ hermite3_ p3_ x]; intros;
  repeat match goal with H : context [vDerive] |- _ => revert H end;
  repeat match goal with |- context [cubic_basis_ ?a ?b ?c ?d ?v] => change (cubic_basis_ a b c d v) with
  (cubic_basis a b c d (IZR v)) end; similar_cubics cubic_basis; split;
  [by_coefficients | split; preimages; cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth
      Nat.pred]; field; nonzero].
Qed.

(* hermite-developable/ex-3.1.tension-effect *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/ex-3.1.tension-effect *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 tense start tense_ start_ end_ tense__ end__]; intros;
  with_cubics cubic_basis ltac:(fun curve => let fails_at N := (generalize N; clear no; curves_at curve;
      fails) in conjuncts; lazymatch goal with |- ~ _ => intro no;
    first [fails_at (no 0 0 0 0 0 0 0 0 0 1 0 0 0 1 0 0 0 0)
      | fails_at (no 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0 1 0 0)] | |- _ => curves_at curve; compute_goal; parts;
    ring end).
Qed.

(* hermite-developable/ex-3.1.width *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 75, 30, 45, 0, (-15), 30, 75, (-25), 45, 0, (-25), (-30), (1 / 2), (130/3), 40, 45, 0,
  (-20), 40, (130/3), (-100/3), 45, 0, (-100/3), (-40);
  cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap
      cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap
      narrow_part narrow_criterion narrow_criterion_ narrow_criterion__ narrow_criterion___]); met_joins.
Qed.

(* hermite-developable/ex-3.1.width *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 k p3 o cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____ narrow narrow_gap narrow_part narrow_criterion
    narrow_criterion_ narrow_criterion__ narrow_criterion___]; similar_cubics cubic_basis; preimages;
  flat (cubic_of (-20) (-20) 0 0) (-20); any_points; compute_goal; split;
  [parts; field | match goal with |- ?x < ?y => replace x with (4 / 9 * y) by field end; apply longer;
    [lra | apply length_positive; numeric]].
Qed.

(* hermite-developable/ex-3.2.o *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75;
  quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.o *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; linearly.
Qed.

(* hermite-developable/ex-3.2.p0u *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75;
  quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.p0u *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; linearly.
Qed.

(* hermite-developable/ex-3.2.p1 *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75;
  quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.p1 *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; linearly.
Qed.

(* hermite-developable/ex-3.2.p1u *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75;
  quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.p1u *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; linearly.
Qed.

(* hermite-developable/ex-3.2.parallel *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), (-20), (-45),
  (1 / 2), 0,
  0; quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.parallel *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; intros; equations; worth o'1 (100); worth p0u'1 (0); worth p1u'1 (0);
  worth p1'1 (40); worth qm'1 (-20); quartic_curves quartic_basis; parts;
  cbv beta iota delta [entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/ex-3.2.q *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 100, 20, 45, 0, (-15), 30, 40, (-15), 45, 0, (-25), (-30), (-20), 5, 75;
  quartic_parts quartic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4
      quartic_gap quartic_part quartic_criterion quartic_criterion__ quartic_criterion___
      quartic_criterion____ quartic_criterion_____]); met_joins.
Qed.

(* hermite-developable/ex-3.2.q *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  quartic_joins quartic_basis; linearly.
Qed.

(* hermite-developable/ex-3.3.equation *)
Theorem refuted.
Proof.
  unfold not; stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm blend5 hermite4 q4 k p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____
    quartic_criterion_____]; intro no; generalize (no 0 0 0 0 0 100 20 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15)
    (-20) 5 35); clear no; with_quartics quartic_basis joins; with_quartics quartic_basis curves_at; fails.
Qed.

(* hermite-developable/ex-3.3.equation.true *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.equation.true *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.o *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.o *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.p0u *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.p0u *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.p1 *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.p1 *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.p1u *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.p1u *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.parallel *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, 0, 0, (-20), 5, 35, 0, 0, 0, (1 / 2),
  0, 0, 0,
  0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.parallel *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; worth o'1 (100);
  worth p0u'1 (0); worth p1u'1 (0); worth p1'1 (40); worth qm'1 (-20); worth qu'1 (0);
  quintic_curves quintic_basis; parts; cbv beta iota delta [entry nth Nat.pred]; ring.
Qed.

(* hermite-developable/ex-3.3.q *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.q *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-3.3.qu *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/ex-3.3.qu *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; with_quintics quintic_basis joins; data_of_joins; linearly.
Qed.

(* hermite-developable/ex-4.a.developable.computed *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5 r0 a_ normal image r_ r1 r0u ru r1u r5 d_]; intro no;
  generalize (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4));
  clear no; with_quintics quintic_basis joins; with_quintics quintic_basis curves_at; fails.
Qed.

(* hermite-developable/ex-4.a.developable.printed *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5 rp]; intro no;
  generalize (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4));
  clear no; with_quintics quintic_basis joins; with_quintics quintic_basis curves_at; fails.
Qed.

(* hermite-developable/ex-4.a.twist *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25),
  35; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins;
  compute_goal; numeric.
Qed.

(* hermite-developable/ex-4.a.twist *)
Theorem proved.
Proof.
  let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u
        o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data;
  stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u;
  with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn turn_ size near near_ far far_];
  with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end;
    conjuncts; vectors ltac:(cbv beta delta [p5 p5_ r5 r5_ hermite5 hermite5_ blend6 r0 q0];
      whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers.
Qed.

(* hermite-developable/ex-4.a.twist.most *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25),
  35, (1 / 2); quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins;
  compute_goal; numeric.
Qed.

(* hermite-developable/ex-4.a.twist.most *)
Theorem proved.
Proof.
  let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u
        o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data;
  stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u;
  with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far];
  with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end;
    assert (PP : forall u, vDerive 3 (fun u_ => p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2;
          p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2;
          pu'3] u_) 1 u = vscale 5 (at_number [[0; 0; 0; 0; 0]; [(-6); (-168); 861; (-1392); 700];
          [9; (-246); 1074; (-1520); 680]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0];
      staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth
        Nat.pred at_number whole_poly map vscale vsub zip]; parts; field);
    assert (RR : forall u, vDerive 3 (fun u_ => r5 A B C_ E_ F G u_) 1 u = vscale (10 / 17730167) (at_number
        [[(-16366308); (-445659120); 2306056896; (-3782863488); 1920830400];
          [(-109108720); (-2971060800); 15373712640; (-25219089920); 12805536000];
          [171846234; (-4786671174); 21030632415; (-29848375488); 13366862100]]%Z u)) by (intro;
      cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages;
      cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map
        vscale vsub zip]; parts; field); assert (WW : forall u, vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G
        [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2;
          pm'3] [pu'1; pu'2; pu'3] u) = vscale (5 / 17730167) (at_number [[(-212762004); (-32732616);
            (-445659120); 1537371264; (-1891431744); 768332160];
          [70920668; (-111836438); (-1481726772); 5160583831; (-6439446844); 2639991020];
          [0; 184120965; (-2605860633); 7673021824; (-8186724284); 2935442128]]%Z u)) by (intro;
      cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages;
      cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map
        vscale vsub zip]; parts; field)); rewrite !PP, !RR, !WW;
  (assert (LEM : forall al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3 y z v e c : R, al <> 0 -> be <> 0 -> ga <> 0 ->
      let p := [p1; p2; p3] in let w := [w1; w2; w3] in let r := [r1; r2;
        r3] in dot (cross p w) r = y -> dot (cross p w) (cross r w) = z -> dot w w < v * v -> 0 < e * z - y *
      v -> 0 < e * z + y * v -> c * c < 1 -> e * e * (1 - c * c) <= c * c -> dot (cross (cross (vscale al p)
          (vscale be w)) (cross (vscale ga r) (vscale be w))) (cross (cross (vscale al p) (vscale be w))
        (cross (vscale ga r) (vscale be w))) < c ^ 2 * (dot (cross (vscale al p) (vscale be w)) (cross (vscale
            al p) (vscale be w)) * dot (cross (vscale ga r) (vscale be w)) (cross (vscale ga r) (vscale be
            w)))) by (clear; intros al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3 y z v e c A B C p w r Y Z W V1 V2 I J;
      destruct (angle_scaled al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3) as [E F]; cbv zeta in E, F; subst p w r;
      rewrite E, F; clear E F; assert (K : 0 < (al * be * ga * be) ^ 2) by (rewrite <- Rsqr_pow2;
        apply Rsqr_pos_lt; repeat apply Rmult_integral_contrapositive_currified; assumption);
      assert (L : forall x1 x2 x3 y1 y2 y3, dot (cross [x1; x2; x3] [y1; y2; y3]) (cross [x1; x2; x3] [y1; y2;
            y3]) = dot [x1; x2; x3] [x1; x2; x3] * dot [y1; y2; y3] [y1; y2; y3] - dot [x1; x2; x3] [y1; y2;
          y3] * dot [x1; x2; x3] [y1; y2; y3]) by (intros; cbv [dot cross entry zip fold_right nth Nat.pred];
        ring); pose proof (cross_of_crosses p1 p2 p3 w1 w2 w3 r1 r2 r3) as M; cbv zeta in M;
      pose proof M as N; change (cross [p1; p2; p3] [w1; w2; w3]) with [p2 * w3 - p3 * w2; p3 * w1 - p1 * w3;
        p1 * w2 - p2 * w1] in N at 1 3; change (cross [r1; r2; r3] [w1; w2; w3]) with [r2 * w3 - r3 * w2;
        r3 * w1 - r1 * w3; r1 * w2 - r2 * w1] in N; rewrite L in N;
      change [p2 * w3 - p3 * w2; p3 * w1 - p1 * w3;
        p1 * w2 - p2 * w1] with (cross [p1; p2; p3] [w1; w2; w3]) in N;
      change [r2 * w3 - r3 * w2; r3 * w1 - r1 * w3;
        r1 * w2 - r2 * w1] with (cross [r1; r2; r3] [w1; w2; w3]) in N; rewrite Z, Y in N; rewrite M, Y;
      assert (P : 0 <= dot [w1; w2; w3] [w1; w2; w3]) by (cbv [dot zip fold_right]; pose proof (Rle_0_sqr w1);
        pose proof (Rle_0_sqr w2); pose proof (Rle_0_sqr w3); unfold Rsqr in *; lra); clear M L A B C;
      revert N W P; generalize (dot [w1; w2; w3] [w1; w2; w3]);
      generalize (dot (cross [p1; p2; p3] [w1; w2; w3]) (cross [p1; p2; p3] [w1; w2; w3]) * dot (cross [r1;
            r2; r3] [w1; w2; w3]) (cross [r1; r2; r3] [w1; w2; w3])); revert K;
      generalize ((al * be * ga * be) ^ 2); clear - V1 V2 I J; intros k K t w N W P;
      replace (c ^ 2 * (k * t)) with (k * (c ^ 2 * t)) by ring; apply Rmult_lt_compat_l; [exact K|];
      replace t with (z * z + y * y * w) by lra; pose proof (Rmult_lt_0_compat _ _ V1 V2) as V;
      assert (G : y * y * w <= y * y * (v * v)) by (apply Rmult_le_compat_l; [exact (Rle_0_sqr y) | lra]);
      replace ((e * z - y * v) * (e * z + y * v)) with (e * e * (z * z) - y * y * (v * v)) in V by ring;
      assert (G1 : 0 < (1 - c * c) * (e * e * (z * z) - y * y * w)) by (apply Rmult_lt_0_compat; lra);
      assert (G2 : 0 <= (c * c - e * e * (1 - c * c)) * (z * z)) by (apply Rmult_le_pos;
        [lra | exact (Rle_0_sqr z)]); clear - G1 G2; lra);
    lazymatch goal with |- dot (cross (cross (vscale ?al (at_number ?p ?u)) (vscale ?be (at_number ?w ?u)))
      (cross (vscale ?ga (at_number ?r ?u)) _)) _ < _ => assert (U : 0 <= u <= 1) by lra; clear - U LEM;
    cbv beta; assert (ED : dot_poly (cross_poly p w) r = times_number 425524008 [0; (-128199042); 19301622417;
        (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800);
        13195319915840; (-9160976708640); 3712605575296; (-643500844800);
        0]%Z) by exact_no_check (@eq_refl (list Z) (times_number 425524008 [0; (-128199042); 19301622417;
          (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800);
          13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z));
    assert (EQ : dot_poly (cross_poly p w) (cross_poly r w) = times_number 17730167 [6142474653116413248;
        (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080);
        183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660;
        (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851);
        31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192;
        (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984);
        12640035189084323977429760; (-2949140604289295354438400);
        314817326355802086720000]%Z) by exact_no_check (@eq_refl (list Z) (times_number 17730167
        [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080);
          183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660;
          (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851);
          31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192;
          (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984);
          12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z));
    assert (C1 : 0 < whole_poly (plus_poly (times_number 11 [6142474653116413248; (-143822632747739938272);
            5258452908812429853072; (-44187706537521358933080); 183727524408385479748392;
            (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698);
            10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502;
            (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456);
            57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760;
            (-2949140604289295354438400); 314817326355802086720000]%Z) (times_number (-432000000) (times_poly
            [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306);
              8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296;
              (-643500844800); 0]%Z [2535; (-960); 1700]%Z))) u) by (apply (positive_poly 1);
      [ exact_no_check (@eq_refl bool true) | exact U ]);
    assert (C2 : 0 < whole_poly (plus_poly (times_number 11 [6142474653116413248; (-143822632747739938272);
            5258452908812429853072; (-44187706537521358933080); 183727524408385479748392;
            (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698);
            10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502;
            (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456);
            57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760;
            (-2949140604289295354438400); 314817326355802086720000]%Z) (times_number 432000000 (times_poly [0;
              (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306);
              8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296;
              (-643500844800); 0]%Z [2535; (-960); 1700]%Z))) u) by (apply (positive_poly 3);
      [ exact_no_check (@eq_refl bool true) | exact U ]);
    assert (C3 : 0 < whole_poly (minus_poly (times_number 10000000000 (times_poly [2535; (-960);
              1700]%Z [2535; (-960); 1700]%Z)) (dot_poly w w)) u) by (apply (positive_poly 3);
      [ exact_no_check (@eq_refl bool true) | exact U ]); apply (f_equal (fun c => whole_poly c u)) in ED;
    apply (f_equal (fun c => whole_poly c u)) in EQ; cbv beta in ED, EQ;
    rewrite whole_number, dot_at, cross_at in ED by reflexivity;
    rewrite whole_number, dot_at, !cross_at in EQ by reflexivity;
    rewrite whole_plus, !whole_number, !whole_times in C1, C2;
    rewrite whole_minus, !whole_number, whole_times, dot_at in C3 by reflexivity;
    cbv beta iota delta [at_number map] in C3 |- *;
    refine (LEM _ _ _ _ _ _ _ _ _ _ _ _ _ _ (100000 * whole_poly [2535; (-960);
          1700]%Z u) (11 / 180) _ _ _ _ _ _ _ _ _ _ _);
    [lra | lra | lra | exact ED | exact EQ | revert C3; generalize (whole_poly [2535; (-960); 1700]%Z u);
      match goal with |- context [dot ?a ?b] => generalize (dot a b) end; clear; intros; lra | revert C1;
      generalize (whole_poly [2535; (-960); 1700]%Z u) (whole_poly [0; (-128199042); 19301622417;
          (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800);
          13195319915840; (-9160976708640); 3712605575296; (-643500844800);
          0]%Z u) (whole_poly [6142474653116413248; (-143822632747739938272); 5258452908812429853072;
          (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720);
          1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032;
          (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272);
          66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400;
          (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400);
          314817326355802086720000]%Z u); clear; intros; lra | revert C2;
      generalize (whole_poly [2535; (-960); 1700]%Z u) (whole_poly [0; (-128199042); 19301622417;
          (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800);
          13195319915840; (-9160976708640); 3712605575296; (-643500844800);
          0]%Z u) (whole_poly [6142474653116413248; (-143822632747739938272); 5258452908812429853072;
          (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720);
          1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032;
          (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272);
          66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400;
          (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400);
          314817326355802086720000]%Z u); clear; intros; lra | lra | lra ] end).
Qed.

(* hermite-developable/ex-4.a.twist.printed *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25),
  35; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]); met_joins.
Qed.

(* hermite-developable/ex-4.a.twist.printed *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5]; intros; with_quintics quintic_basis joins; data_of_joins;
  cbv beta delta [turn turn_ size near near_ far far_];
  with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end;
    conjuncts; vectors ltac:(cbv beta delta [p5 p5_ r5 r5_ rp rp_ hermite5 hermite5_ blend6];
      whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers.
Qed.

(* hermite-developable/ex-4.b.developable *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0
    (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no;
  with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k
        o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
        quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_])
    curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o r0 a_ d_ normal image r_ r1 r0u ru
        r1u r5 p5 blend6 hermite5]) curve); compute_goal; intro C; contradiction_in C.
Qed.

(* hermite-developable/ex-4.b.twist *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25),
  35, (1 / 2); quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins;
  compute_goal; numeric.
Qed.

(* hermite-developable/ex-4.b.twist *)
Theorem proved.
Proof.
  let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u
        o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data;
  stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u;
  with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far];
  with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end;
    assert (PP : forall u, vDerive 3 (fun u_ => p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2;
          p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2;
          pu'3] u_) 1 u = vscale 5 (at_number [[0; 0; 0; 0; 0]; [(-6); (-168); 861; (-1392); 700];
          [9; (-246); 1074; (-1520); 680]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0];
      staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth
        Nat.pred at_number whole_poly map vscale vsub zip]; parts; field);
    assert (RR : forall u, vDerive 3 (fun u_ => r5 A B C_ E_ F G u_) 1 u = vscale (10 / 26733) (at_number
        [[(-50652); (-1327440); 6932304; (-11544192); 5913600];
          [(-168840); (-4424800); 23107680; (-38480640); 19712000];
          [278586; (-7928226); 35064945; (-49890432); 22349100]]%Z u)) by (intro;
      cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages;
      cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map
        vscale vsub zip]; parts; field); assert (WW : forall u, vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G
        [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2;
          pm'3] [pu'1; pu'2; pu'3] u) = vscale (5 / 26733) (at_number [[(-320796); (-101304); (-1327440);
            4621536; (-5772096); 2365440]; [106932; (-177282); (-2179228); 7732749; (-9937236); 4142180];
          [0; 316575; (-4640067); 13806216; (-14786676); 5303952]]%Z u)) by (intro;
      cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages;
      cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map
        vscale vsub zip]; parts; field)); rewrite !PP, !RR, !WW; split;
  [ cbv beta iota zeta delta [at_number whole_poly map vscale cross dot entry zip fold_right nth Nat.pred];
    numeric | apply (angle_below 6 125 1000);
    [ exact_no_check (@eq_refl bool true) | first [ reflexivity | lia | lra ] .. ] ].
Qed.

(* hermite-developable/ex-4.data *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu q5 k p5 quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ q5_ blend6 hermite5 a quintic_basis_ hermite5_]);
  met_joins.
Qed.

(* hermite-developable/ex-4.data *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu q5 k p5 quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ q5_ blend6 hermite5 a hermite5_]; whole_points quintic_basis_ quintic_basis;
  intros; with_quintics quintic_basis joins; data_of_joins; worth o'1 (100); worth o'2 (20); worth o'3 (45);
  worth qm'1 (-20); worth qm'2 (5); worth qm'3 (35); worth qu'1 (0); worth qu'2 (-50); worth qu'3 (70);
  quintic_curves quintic_basis; parts; lra.
Qed.

(* hermite-developable/ex-4.other-data.twist *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-25), 30, 40, (-15), 45, 0, (-25), (-30), 40, (25/2), 40, 0, (-30),
  40; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap
      quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____
      quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins;
  compute_goal; numeric.
Qed.

(* hermite-developable/ex-4.other-data.twist *)
Theorem proved.
Proof.
  let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u
        o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data;
  stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u;
  with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far];
  with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end;
    conjuncts; vectors ltac:(cbv beta delta [p5 r5 hermite5 blend6 r0 q0];
      whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers.
Qed.

(* hermite-developable/fig-1b.middle *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quintic; stage quintic_; stage quintic_data;
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, (1 / 2); met_joins.
Qed.

(* hermite-developable/fig-1b.middle *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis_; stage quintic; stage quintic_;
  stage quintic_data; stage quintic_basis_; eassert (QB : forall A B C_ E_ F G u, fig1b_ A B C_ E_ F G u = _)
  by (intros; cbv beta delta [fig1b_ hermite5_ blend6];
    with_quintics quintic_basis_ ltac:(fun curve => match goal with u : R |- _ => curve u end));
  eassert (QA : forall A B C_ E_ F u, fig1a_ A B C_ E_ F u = _) by (intros;
    cbv beta delta [fig1a_ hermite4_ blend5];
    with_quartics quartic_basis_ ltac:(fun curve => match goal with u : R |- _ => curve u end));
  cbv beta zeta delta [statement]; intros; repeat match goal with |- context [fig1b ?a ?b ?c ?d ?e ?f ?u] =>
  change (fig1b a b c d e f u) with (fig1b_ a b c d e f (IZR u))
  | |- context [fig1a ?a ?b ?c ?d ?e ?u] => change (fig1a a b c d e u) with (fig1a_ a b c d e (IZR u)) end;
  let told := (repeat curve_at ltac:(fun u => first [apply QB | apply QA]); rewrite ?QB, ?QA;
    cbv beta iota zeta delta [slope_n slope slopes tl poly quintic_of quartic_of]) in conjuncts;
  lazymatch goal with |- ~ _ => let no := fresh in intro no;
  specialize (no 0 0 0 0 0 0 (1 / 2) ltac:(lra) ltac:(met_joins) ltac:(met_joins)); revert no; told;
  let C := fresh in intro C; contradiction_in C | |- _ => told; compute_goal; parts; field end.
Qed.

(* hermite-developable/fig-4d.constant *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50),
  (-70), (1 / 2),
  (1 / 2); quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu blend6 hermite5
      q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______ patch patch_ normal normal_]);
  met_joins.
Qed.

(* hermite-developable/fig-4d.constant *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu blend6 hermite5 q5 k p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ patch patch_ normal normal_]; intros; with_quintics quintic_basis joins;
  cbv beta iota delta [zeros repeat]; similarities 5%nat; with_quintics quintic_basis patches; images;
  compute_goal; parts; ring.
Qed.

(* hermite-developable/sec-2.control *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage quartic; stage quartic_; stage quartic_data;
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met_joins.
Qed.

(* hermite-developable/sec-2.control *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis_; stage quartic; stage quartic_;
  stage quartic_data; stage quartic_basis_; stage quintic; stage quintic_; stage quintic_data;
  stage quintic_basis_; cbv beta zeta delta [statement blend4 hermite3 p3 hermite3_ p3_ blend5 hermite4 p4
    hermite4_ p4_ blend6 hermite5 p5 hermite5_ p5_ identity mzeros zeros];
  let told curve := (match goal with |- Derive_n ?f 1 ?x = ?c => let E := fresh in eassert (E : forall s, f s
      = _) by (let s := fresh in intro s; cbv beta; values curve;
      cbv beta iota zeta delta [poly cubic_of quartic_of quintic_of]; reflexivity); apply (affine f _ c x E);
    intro; cbv beta; field end) in let known := fun _ => (whole_points cubic_basis cubic_basis_;
    whole_points quartic_basis quartic_basis_; whole_points quintic_basis quintic_basis_;
    lazymatch goal with |- context [cubic_basis_] => with_cubic_numbers cubic_basis_ told
    | |- context [quartic_basis_] => with_quartic_numbers quartic_basis_ told
    | |- _ => with_quintic_numbers quintic_basis_ told end) in let away v := (let no := fresh in intro no;
    specialize (no 0 0 0 0 0 0 0 0 0 0 0 0 (1 / 4) ltac:(lra) ltac:(met_joins));
    apply (f_equal (fun M => nth 0 (nth 0 M nil) 0)) in no; cbv beta iota delta [nth] in no; revert no;
    match goal with |- ?d = 0 -> False => assert (d = v) by known tt; let C := fresh in intro C;
    lra end) in intros; cbv [seq map repeat Nat.eqb]; conjuncts;
  [> parts; known tt | parts; known tt | parts; known tt | parts; known tt | parts; known tt | parts; known tt
    | away (9 / 64) | away (- 3 / 64) | away (9 / 128) | away (3 / 128) | away (9 / 256) | away (- 9 / 64)
    | away (- 3 / 256)].
Qed.

(* hermite-developable/sec-2.cubic.conditions *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis_;
  cbv beta zeta delta [statement blend4 hermite3 p3 hermite3_ p3_]; whole_points cubic_basis cubic_basis_;
  split; [assumption|]; with_cubic_numbers cubic_basis_ number_curves;
  cbv beta iota zeta delta [slope_n slope slopes tl poly cubic_of]; conjuncts; field.
Qed.

(* hermite-developable/sec-2.quartic.conditions *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis_;
  cbv beta zeta delta [statement blend5 hermite4 p4 hermite4_ p4_]; whole_points quartic_basis quartic_basis_;
  split; [assumption|]; with_quartic_numbers quartic_basis_ number_curves;
  cbv beta iota zeta delta [slope_n slope slopes tl poly quartic_of]; conjuncts; field.
Qed.

(* hermite-developable/sec-2.quartic.solvable *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; staged_goal statement; intros; determinants; numeric.
Qed.

(* hermite-developable/sec-2.quintic.conditions *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins.
Qed.

(* hermite-developable/sec-2.quintic.conditions *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis_;
  cbv beta zeta delta [statement blend6 hermite5 p5 hermite5_ p5_]; whole_points quintic_basis quintic_basis_;
  split; [assumption|]; with_quintic_numbers quintic_basis_ number_curves;
  cbv beta iota zeta delta [slope_n slope slopes tl poly quintic_of]; conjuncts; field.
Qed.

(* hermite-developable/sec-3.1.conclusion *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0, 0, 0, 0, 0;
  cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part
      cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____ x]); met_joins.
Qed.

(* hermite-developable/sec-3.1.conclusion *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____ x]; similar_cubics cubic_basis; split;
  [by_coefficients | split; [preimages; cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth
        Nat.pred]; field; nonzero | split; [preimages;
        cbv beta iota zeta delta [slope slopes tl poly cubic_of entry nth Nat.pred]; field; nonzero
        | parallel_tangents]]].
Qed.

(* hermite-developable/sec-3.1.tension *)
Theorem met.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  cubic_number_parts cubic_basis ltac:(cbv beta zeta delta [blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap
      cubic_part cubic_criterion cubic_criterion__ cubic_criterion___ cubic_criterion____]); met_joins;
  first [lra | numeric].
Qed.

(* hermite-developable/sec-3.1.tension *)
Theorem proved.
Proof.
  stage cubic; stage cubic_; stage cubic_data; stage cubic_basis;
  cbv beta zeta delta [statement blend4 hermite3 p3 cubic_criterion_ q3 cubic_gap cubic_part cubic_criterion
    cubic_criterion__ cubic_criterion___ cubic_criterion____]; intros;
  with_cubic_numbers cubic_basis joins_of_numbers; data_of_joins; found.
Qed.

(* hermite-developable/sec-3.2.advantage *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (fun s => 2 * s), (fun _ => 0),
  (fun _ => 0), (fun _ => 0),
  (fun _ => 0); with_quartic_numbers quartic_basis ltac:(fun curve => conjuncts; intros;
    conjuncts; cbv beta zeta delta [blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
      quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____
      quartic_criterion_____]; joins_of_numbers curve; counted_joins); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/sec-3.2.advantage *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement blend5 hermite4 quartic_criterion_ q4 p4 quartic_gap quartic_part
    quartic_criterion quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____];
  intros A B C_ E_ F k o p0 p0u p1 p1u pm q0 q0u q1 q1u qm u qm_of_pm p1_of_pm p0u_of_pm p1u_of_pm o_of_pm U K
  N DD _ _ _ _ _ _ _ _ _ _ CR e1 e2 e3 e4 e5 FN; clear CR e1 e2 e3 e4 e5; assert (KN : k <> 0) by lra;
  assert (V : forall s, qm_of_pm s = k * s + (q0 - k * p0) /\ p1_of_pm s = (q1 - q0 + k * p0) / k /\ p0u_of_pm
    s = q0u / k /\ p1u_of_pm s = q1u / k) by (intro s; specialize (FN s);
    with_quartic_numbers quartic_basis joins_of_numbers; data_of_joins; conjuncts;
    first [lra | (apply value_of; [assumption | lra])]); clear FN;
  let read := (let s := fresh in intro s; cbv beta; destruct (V s) as (V1 & V2 & V3 & V4);
    rewrite ?V1, ?V2, ?V3, ?V4; with_quartic_numbers quartic_basis values; reflexivity) in let told := (intro;
    cbv beta iota zeta delta [poly quartic_of bump]; field; assumption) in split;
  [parts; [apply (affine _ (fun s => poly (quartic_of p0 s ((q1 - q0 + k * p0) / k) (q0u / k) (q1u / k)) u));
      [read | told] | apply (affine _ (fun s => poly (quartic_of q0 (k * s + (q0 - k * p0)) q1 q0u q1u) u));
      [read | told]] |]; cbv beta zeta delta [bump bump_]; derivatives; repeat split; try field;
  [replace (16 * u ^ 2 * (1 - u) ^ 2) with ((4 * u * (1 - u)) ^ 2) by ring; apply pow2_ge_0
    | assert (T : 0 <= u * (1 - u)) by (apply Rmult_le_pos; lra);
    assert (M : 4 * (u * (1 - u)) <= 1) by (pose proof (pow2_ge_0 (2 * u - 1)); lra);
    replace (16 * u ^ 2 * (1 - u) ^ 2) with ((4 * (u * (1 - u))) ^ 2) by ring;
    generalize dependent (u * (1 - u)); intros; nra].
Qed.

(* hermite-developable/sec-3.2.curves *)
Theorem met.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  match goal with |- context [det (quartic_system ?A ?B ?C ?E ?F ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j)] => let
  S := constr:(quartic_system A B C E F k o a b c d e f g h i j) in let E := fresh in assert (E : S = A36 k)
  by (cbv beta zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system];
    with_quartic_numbers quartic_basis system_joins); rewrite E; clear E end; cbv beta zeta delta [A36];
  met_joins; determinants; numeric.
Qed.

(* hermite-developable/sec-3.2.curves *)
Theorem proved.
Proof.
  stage quartic; stage quartic_; stage quartic_data; stage quartic_basis;
  cbv beta zeta delta [statement right_ x]; intros;
  match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A36 k) by (cbv beta
    zeta delta [A36 blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_system];
    with_quartic_numbers quartic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra;
  assert (N : k - 1 <> 0) by nonzero; unfold solve; cbv beta delta [A36];
  match goal with |- context [inverse ?A] => inverse_known A (- 16 * k ^ 3 * (k - 1)) [[- 151 / 16; 19 / 8;
      - 3 / 4; 1 / 2; 0]; [15 / k; - 4 / k; 1 / k; - 1 / k; 0]; [24 / k; - 6 / k; 2 / k; - 1 / k; 0];
    [8 / k; - 3 / k; 0; - 1 / k; 0]; [24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1);
      1 / (k - 1)]] end; compute_goal; conjuncts; parts; field; repeat split; assumption.
Qed.

(* hermite-developable/sec-3.3.advantage *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (fun _ => 0), (fun s => 2 * s),
  (fun _
    => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0);
  (cbv beta zeta delta [blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part quintic_criterion
      quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
      quintic_criterion______]); with_quintic_numbers quintic_basis ltac:(fun curve => joins_of_numbers curve;
    conjuncts; lazymatch goal with |- forall _, _ => intro; joins_of_numbers curve | |- _ => idtac end);
  counted_joins; met_joins; first [lra | numeric].
Qed.

(* hermite-developable/sec-3.3.advantage *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement wave wave_ blend6 hermite5 quintic_criterion_ q5 p5 quintic_gap quintic_part
    quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; intros; assert (V : forall s, p0u_of_pu s = q0u / k /\ p1u_of_pu s = q1u / k /\
    p1_of_pu s = (k * p0 + q1 - q0) / k /\ qm_of_pu s = - k * p0 + q0 + k * pm /\ qu_of_pu s = k * s) by (let
    s := fresh in intro s; match goal with K : _ > 0, H : forall _ : R, _, E : quintic_basis = _ |- _ =>
    generalize (H s); clear - K E end; quintic_number_joins quintic_basis; intros; assert (k <> 0) by lra;
    found); conjuncts; [ (with_quintic_numbers quintic_basis ltac:(fun curve => parts;
        affine_by ltac:(match goal with s : R |- _ => destruct (V s) as (E1 & E2 & E3 & E4 & E5);
          rewrite ?E1, ?E2, ?E3, ?E4, ?E5; clear E1 E2 E3 E4 E5 end; values curve;
          cbv beta iota zeta delta [poly quintic_of]))) | (try ring; derivatives; field) ..].
Qed.

(* hermite-developable/sec-3.3.curves *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  match goal with |- context [det (quintic_system ?A ?B ?C ?E ?F ?G ?k ?o ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j ?l
      ?m)] => let S := constr:(quintic_system A B C E F G k o a b c d e f g h i j l m) in let E := fresh in
  assert (E : S = A37 k) by (cbv beta zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part
      quintic_system]; with_quintic_numbers quintic_basis system_joins); rewrite E; clear E end;
  cbv beta zeta delta [A37]; met_joins; determinants; numeric.
Qed.

(* hermite-developable/sec-3.3.curves *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement right_ x]; intros;
  match goal with |- context [mvec ?S (solve ?S _)] => let E := fresh in assert (E : S = A37 k) by (cbv beta
    zeta delta [A37 blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_system];
    with_quintic_numbers quintic_basis system_joins); rewrite E; clear E end; assert (K : k <> 0) by lra;
  assert (N : k - 1 <> 0) by nonzero; unfold solve; cbv beta delta [A37];
  match goal with |- context [inverse ?A] => inverse_known A (256 * k ^ 3 * (k - 1)) [[- 120 / k; 24 / k;
      - 6 / k; 2 / k; - 1 / k; 0]; [1165 / 16; - 29 / 2; 15 / 4; - 1; 1; 0];
    [- 45 / k; 8 / k; - 3 / k; 0; - 1 / k; 0]; [1511 / 32; - 151 / 16; 19 / 8; - 3 / 4; 1 / 2; 0];
    [- 76 / k; 15 / k; - 4 / k; 1 / k; - 1 / k; 0];
    [- 120 / (k - 1); 24 / (k - 1); - 6 / (k - 1); 2 / (k - 1); - 1 / (k - 1); 1 / (k - 1)]] end;
  compute_goal; conjuncts; parts; field; repeat split; assumption.
Qed.

(* hermite-developable/sec-3.summit-outside *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a5 a4 a3 a2 a1 a0 p gap part criterion criterion__ criterion___ criterion____
    criterion_____ criterion______ q]; exists 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0,
    0, (1 / 2), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; joins ltac:(fun u => apply monomial_curve); counted_joins;
  cbv beta iota delta [entry nth Nat.pred]; met_joins.
Qed.

(* hermite-developable/sec-3.summit-outside *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a5 a4 a3 a2 a1 a0 p gap part criterion criterion__ criterion___ criterion____
    criterion_____ criterion______ q]; intros; joins ltac:(fun u => apply monomial_curve);
  cbv beta iota delta [zeros repeat]; similarities 5%nat; curve_at ltac:(fun u => apply monomial_curve);
  rewrite !monomial_curve; cbv beta iota delta [slope_n]; images; cbv beta iota delta [entry nth Nat.pred];
  split; [cbv beta iota delta [slope slopes tl poly]; ring
    | match goal with K : 0 < ?k, N : ?h ^ 2 > 0 |- ?x > 0 => replace x with (k * h ^ 2) by (cbn [poly];
      ring); apply Rmult_lt_0_compat; [exact K | exact N] end].
Qed.

(* hermite-developable/sec-4.I1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/sec-4.I1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; split;
  [apply value_of; [ assumption | lra ] | lra ].
Qed.

(* hermite-developable/sec-4.cone *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2);
  quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 q5 p5 quintic_gap quintic_part
      quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
      quintic_criterion______ quintic_criterion_ a d normal image r]); met_joins; first [lra | numeric].
Qed.

(* hermite-developable/sec-4.cone *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ quintic_criterion_ a d normal image r]; similar_quintic_numbers quintic_basis;
  images; ring.
Qed.

(* hermite-developable/sec-4.goal.designed *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  assert (PP : forall u, p5 0 0 0 0 0 0 2 1 0 0 0 0 0 1 0 0 0 u = [poly [1 / 2] u; poly [0; 0; 8; - 16; 8] u;
      poly [0; 0; 7 / 2; - 17; 26; - 12] u]) by (intro u;
    cbv beta delta [p5 q5 hermite5 blend6 q0 qm q1 q0u qu q1u o]; staged; compute_goal;
    cbv beta iota delta [poly]; parts; field);
  assert (RR : forall u, r5 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 u = [poly [1; 0; - 8; 16; - 8] u;
      poly [0; 0; 8; - 16; 8] u; poly [0; 0; 7; - 34; 52; - 24] u]) by (intro u;
    cbv beta delta [r5 hermite5 blend6 r0 r r1 r0u ru r1u image normal q0 qm q1 q0u qu q1u o];
    cbv beta delta [image normal]; cbv beta delta [q0 qm q1 q0u qu q1u o]; staged; compute_goal;
    cbv beta iota delta [poly]; parts; field); cbv beta zeta delta [statement]; intro no;
  generalize (no 0 0 0 0 0 0 2 (1 / 4) 1 0 0 0 0 0 1 0 0 0); clear no;
  repeat curve_at ltac:(fun u => first [apply PP | apply RR]); rewrite ?PP, ?RR;
  cbv beta iota zeta delta [slope_n slope slopes tl poly qm q1 q0 q0u qu q1u o normal]; fails.
Qed.

(* hermite-developable/sec-4.goal.image *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal chord]; exists 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0;
  met.
Qed.

(* hermite-developable/sec-4.goal.image *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement dp dr p image chord];
  intros a'1 a'2 a'3 c'1 c'2 c'3 d'1 d'2 d'3 dc'1 dc'2 dc'3 k o'1 o'2 o'3 q0'1 q0'2 q0'3 W K L; clear L;
  assert (N : exists n1 n2 n3, normal [a'1; a'2; a'3] [d'1; d'2; d'3] = [n1; n2; n3]) by (do 3 eexists;
    reflexivity); destruct N as (n1 & n2 & n3 & N); rewrite N in *; clear N;
  assert (V : ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) <> 0) by (let E := fresh in intro E;
    apply W; compute_goal; lra); clear W; assert (D : forall o c d s, Derive_n (fun x => o + s / ((c'1 + x *
          dc'1 - o'1) * n1 + ((c'2 + x * dc'2 - o'2) * n2 + ((c'3 + x * dc'3 - o'3) * n3 + 0))) * (c + x * d -
        o)) 1 0 = s * (d / ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) - (dc'1 * n1 + dc'2 * n2 +
        dc'3 * n3) * (c - o) / ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) ^ 2)) by (intros;
    apply is_derive_unique; auto_derive; [let E := fresh in intro E; apply V; lra | field; repeat split;
      first [exact V | let E := fresh in intro E; apply V; lra]]); compute_goal; rewrite !D; clear D;
  conjuncts; parts; field; repeat split; try assumption; let E := fresh in intro E; apply V; lra.
Qed.

(* hermite-developable/sec-4.goal.leaves *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; lra.
Qed.

(* hermite-developable/sec-4.goal.leaves *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement];
  intros; intro no; pose proof (no 0 0 0 0 0 0 (1 / 4) 0 0 0 0 1 0 1 0 0 0) as C; clear no;
  with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u o
        normal]) curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r r0 r1 r0u
        ru r1u r5 q5 hermite5 blend6]) curve); compute_goal; intro C; contradiction_in C.
Qed.

(* hermite-developable/sec-4.goal.nodes *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement r0u r0 image r ru r1 r1u]; intros;
  repeat match goal with |- context [dot ?a ?b / dot ?c ?d] => generalize (dot a b / dot c d) end;
  compute_goal; intros; conjuncts; ring.
Qed.

(* hermite-developable/sec-4.goal.parallel *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal]; stage quintic; stage quintic_; stage quintic_data;
  exists 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
  0, 0, (1 / 2), 0, 0, 0; met_joins; first [lra | compute_goal; lra].
Qed.

(* hermite-developable/sec-4.goal.parallel *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement];
  intros; with_quintics quintic_basis ltac:(fun curve => match goal with |- context [p5 ?a ?b ?c ?d ?e ?f ?g
      ?h ?i ?j ?k ?l ?u] => eassert (P : p5 a b c d e f g h i j k l u = _) by (cbv beta delta [p5 hermite5
        blend6]; curve u); rewrite P; clear P end;
    match goal with |- ?r = ?s /\ _ => assert (E : r = s) by (cbv beta delta [r_ shadow turned normal cross];
      cbv beta iota zeta delta [vsub vscale map zip dot fold_right entry nth Nat.pred];
      cbv beta delta [hermite5 blend6]; curves curve;
      generalize (a'2 * d'3 - a'3 * d'2), (a'3 * d'1 - a'1 * d'3), (a'1 * d'2 - a'2 * d'1); intros;
      rewrite !quintic_along; match goal with |- _ - ?t * _ :: _ = _ - ?v * _ :: _ => replace t with v by (cbv
        beta iota zeta delta [poly quintic_of Rdiv];
        match goal with |- context [/ ?n] => generalize (/ n) end; intros; ring) end; reflexivity) end);
  rewrite E; clear E; match goal with N : dot _ _ <> 0 |- _ => revert N end;
  cbv beta delta [shadow turned normal]; any_points; match goal with N : dot _ _ <> 0 |- _ => revert N end;
  compute_goal; generalize (a'2 * d'3 - a'3 * d'2), (a'3 * d'1 - a'1 * d'3), (a'1 * d'2 - a'2 * d'1); intros;
  conjuncts; parts; (first [reflexivity | field; nonzero]).
Qed.

(* hermite-developable/sec-4.in-plane *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement r0 a d normal image r r1 r0u r1u ru]; intros;
  repeat match goal with H : det _ <> 0 |- _ => clear H end;
  match goal with E : quintic_basis = _ |- _ => rewrite E; clear E end; unstaged; conjuncts;
  lazymatch goal with |- dot _ _ = 0 => back; identity | |- _ => cbv beta iota delta [entry nth Nat.pred];
  ring end.
Qed.

(* hermite-developable/sec-4.oblique *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal normal2 a d not]; compute_goal; split; intro E; injection E; intros;
  lra.
Qed.

(* hermite-developable/sec-4.s *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/sec-4.s *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of;
  [ assumption | lra ].
Qed.

(* hermite-developable/sec-4.w *)
Theorem met.
Proof.
  cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0;
  compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ].
Qed.

(* hermite-developable/sec-4.w *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement normal]; compute_goal; intros;
  match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1;
  pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1);
  pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2);
  pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of;
  [ assumption | lra ].
Qed.

(* hermite-developable/sec-5.criteria.a *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); quintic_parts quintic_basis ltac:(cbv beta zeta delta [blend6
      hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/sec-5.criteria.a *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; similar_quintics quintic_basis; parallel_tangents.
Qed.

(* hermite-developable/sec-5.criteria.reach *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); quintic_parts quintic_basis ltac:(cbv beta zeta delta [blend6
      hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins.
Qed.

(* hermite-developable/sec-5.criteria.reach *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______]; similar_quintics quintic_basis; compute_goal; parts; images; ring.
Qed.

(* hermite-developable/sec-5.planes.a *)
Theorem met.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance];
  exists 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu q5 p5
      quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
      quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5]); met_joins.
Qed.

(* hermite-developable/sec-5.planes.a *)
Theorem proved.
Proof.
  stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu q5 p5 quintic_gap quintic_part quintic_criterion
    quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____
    quintic_criterion______ blend6 hermite5]; similar_quintics quintic_basis; assert (k <> 0) by lra;
  worth_times k p0u'1 0; worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; worth qu'1 0; split;
  [by_coefficients | split; [by_coefficients | parallel_tangents]].
Qed.

(* hermite-developable/sec-5.planes.b *)
Theorem refuted.
Proof.
  unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis;
  cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0
    (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no;
  with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k
        o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___
        quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5])
    curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r5 p5 blend6 hermite5])
    curve); compute_goal; intro C; contradiction_in C.
Qed.
