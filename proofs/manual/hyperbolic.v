(* Scripts of theorems of hyperbolic whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* hyperbolic/catenary.bend *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp
      (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives;
    pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t));
    generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1;
    [ nra | lra | field_simplify_eq; ring [E] ]); exists 0; rewrite L, Ropp_0, exp_0; split;
  apply pow_nonzero; lra.
Qed.

(* hyperbolic/catenary.bend *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros t N0 N;
  assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2) by (clear; intro t;
    cbv beta zeta delta [K norm]; compute_goal; derivatives; pose proof (exp_inverse t) as E;
    pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t);
    generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1;
    [ nra | lra | field_simplify_eq; ring [E] ]); rewrite L; clear L N0 N; cbv beta delta [K]; compute_goal;
  derivatives; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t);
  generalize dependent (exp (- t)); intros; field; lra.
Qed.

(* hyperbolic/catenary.bend.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) =
    (exp t + exp (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives;
    pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t));
    generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1;
    [ nra | lra | field_simplify_eq; ring [E] ]); generalize (no (ln 2)); clear no; rewrite L; clear L;
  cbv beta delta [K]; compute_goal; derivatives; powers_of_two tt; intro no; refine (_ (no _ _));
  [ intro C; revert C; match goal with |- ?a = ?b -> False => change (a <> b) end; numeric | numeric
    | numeric ].
Qed.

(* hyperbolic/catenary.curvature *)
Theorem met.
Proof.
  cbv beta zeta delta [instance K]; exists 0; compute_goal; derivatives; powers_of_two tt; split; numeric.
Qed.

(* hyperbolic/catenary.curvature.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement K] in no; generalize (no (ln 2)); clear no; compute_goal;
  derivatives; powers_of_two tt; intro no; refine (_ (no _ _));
  [intro C; contradiction_in C | numeric | numeric].
Qed.

(* hyperbolic/catenary.curvature.slip (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance K]; exists 0; compute_goal; derivatives; powers_of_two tt; split; numeric.
Qed.

(* hyperbolic/catenary.norm *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp
      (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives;
    pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t));
    generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1;
    [ nra | lra | field_simplify_eq; ring [E] ]); exact L.
Qed.

(* hyperbolic/catenoid.regular *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement X]; compute_goal; intros u v; derivatives; pose proof (exp_inverse v) as E;
  pose proof (sin2_cos2 u) as F; unfold Rsqr in F; pose proof (exp_pos v); pose proof (exp_pos (- v));
  generalize dependent (exp v); generalize dependent (exp (- v)); generalize dependent (sin u);
  generalize dependent (cos u); intros c s F m M e E P; assert (G : s * s = 1 - c * c) by lra;
  apply Rlt_gt, Rlt_le_trans with (((e + m) / 2) ^ 4);
  [ apply pow_lt; lra | right; field_simplify_eq; ring [E G] ].
Qed.

(* hyperbolic/curve.d1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.d1.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f g h F] in no;
  assert (A : 0 < 2 * ln 2) by (pose proof (ln_lt_2); lra);
  generalize (no (fun i => if Z.eqb i 1 then 1 else 0) (2 * ln 2) A); clear no; compute_goal;
  powers_of_two tt; intro no; assert (N : 3 <> 0) by numeric; assert (C := no ltac:(numeric) ltac:(numeric));
  clear no; revert C; derivatives; powers_of_two tt; intro C; contradiction_in C.
Qed.

(* hyperbolic/curve.d1.slip (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.d2 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.ends *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.hyperbola *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.hyperbola *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f g h E_]; compute_goal; intros a t A T N S; halves a t.
Qed.

(* hyperbolic/curve.hyperbola.implicit *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.hyperbola.implicit *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f g h E_]; compute_goal; intros a t A T N S; halves a t.
Qed.

(* hyperbolic/curve.hyperbola.tangent *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.middle *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/curve.middle.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f g h F] in no;
  assert (A : 0 < 4 * ln 2) by (pose proof (ln_lt_2); lra);
  generalize (no (fun i => if Z.eqb i 2 then 1 else 0) (4 * ln 2) A); clear no; compute_goal;
  powers_of_two tt; intro no; refine (_ (no _ _)); [intro C; contradiction_in C | numeric | numeric].
Qed.

(* hyperbolic/fn.bounded *)
Theorem met.
Proof.
  exists 0; pose proof (exp_pos 0); pose proof (exp_pos (- 0)); lra.
Qed.

(* hyperbolic/fn.bounded *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros y N; pose proof (exp_pos y); pose proof (exp_pos (- y));
  generalize dependent (exp y); generalize dependent (exp (- y)); intros m M e E P; split;
  [ apply (Rmult_lt_reg_r (e + m)); [ lra | replace ((e - m) / (e + m) * (e + m)) with (e - m) by (field;
        lra); lra ] | apply (Rmult_lt_reg_r (e + m));
    [ lra | replace ((e - m) / (e + m) * (e + m)) with (e - m) by (field; lra); lra ] ].
Qed.

(* hyperbolic/fn.half.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement] in no; generalize (no (2 * ln 2)); clear no; powers_of_two tt;
  intro C; contradiction_in C.
Qed.

(* hyperbolic/fn.pythagoras.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement] in no; generalize (no (ln 2)); clear no; powers_of_two tt;
  intro C; contradiction_in C.
Qed.

(* hyperbolic/fn.rate *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/fn.tangent *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/fn.unit *)
Theorem met.
Proof.
  exists 0; lra.
Qed.

(* hyperbolic/fn.unit *)
Theorem proved.
Proof.
  intros x X; split; [ rewrite <- exp_0 at 1; apply exp_at_most; lra | apply exp_at_most; lra ].
Qed.

(* hyperbolic/join.C1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance G F G_ f g h f_ g_ h_];
  exists (fun _ => 0), (fun _ => 0), (2 * ln 2), (2 * ln 2); conjuncts;
  first [ pose proof ln_lt_2; lra | unfold Rdiv; ring
    | match goal with |- Derive_n _ _ _ = _ => transitivity 0; [ | symmetry ];
    (rewrite (Derive_n_ext _ (fun _ => 0)) by (intro; unfold Rdiv; ring)); apply rate_const end
    | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/join.C1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement G F G_ f g h f_ g_ h_]; intros P R_ a b Ha Hb N1 N2; derivatives;
  revert N1 N2; unfold Rdiv; rewrite ?Rminus_0_r, ?Rminus_eq_0, ?Rmult_0_l, ?Ropp_0, ?exp_0;
  pose proof (exp_inverse (a * / 2)) as A0; pose proof (exp_inverse (b * / 2)) as B0;
  generalize dependent (exp (a * / 2)); generalize dependent (exp (- (a * / 2)));
  generalize dependent (exp (b * / 2)); generalize dependent (exp (- (b * / 2))); intros v w B0 m e A0;
  intros N1 N2 E0 E1 D1 D2 D3; assert (M1 : w - v <> 0) by (intro Z; apply N1; rewrite Z; field);
  assert (M2 : e - m <> 0) by (intro Z; apply N2; rewrite Z; field);
  assert (E : R_ 0%Z = P 2%Z) by (transitivity (((w - v) / 2) ^ 2 / ((w - v) / 2) ^ 2 * R_ 0%Z);
    [ field; exact M1 | etransitivity; [ etransitivity; [ | exact E0 ]; field; exact M1 | field;
        exact M2 ] ]); assert (F : (w + v) / (w - v) * (R_ 1%Z - R_ 0%Z) = (e + m) / (e - m) * (P 2%Z - P
      1%Z)) by (etransitivity; [ etransitivity; [ | exact E1 ]; field; exact M1 | field; exact M2 ]);
  apply (Rmult_eq_reg_l ((w + v) / (w - v)));
  [ transitivity ((w + v) / (w - v) * (R_ 1%Z - R_ 0%Z) + (w + v) / (w - v) * R_ 0%Z);
    [ ring | rewrite F, E; field; repeat split; assumption ] | apply Rmult_integral_contrapositive_currified;
    [ assumption | apply Rinv_neq_0_compat; assumption ] ].
Qed.

(* hyperbolic/join.C1.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement G F G_ f g h f_ g_ h_]; intro no;
  assert (L : 0 < ln 2) by (pose proof ln_lt_2; lra);
  generalize (no (fun i => if Z.eqb i 2 then 0 else - 1) (fun i => nth (Z.to_nat i) [0; 25 / 17;
        0] 0) (2 * ln 2) (4 * ln 2) ltac:(lra) ltac:(lra)); clear no; compute_goal; powers_of_two tt;
  intro no; assert (C := no ltac:(numeric) ltac:(numeric)); clear no; revert C; derivatives; unfold Rdiv;
  rewrite ?Rminus_0_r, ?Rminus_eq_0, ?Rmult_0_l, ?Ropp_0, ?exp_0; powers_of_two tt; intro no;
  refine (_ (no _ _ _ _ _)); [intro C; contradiction_in C | field | field | numeric | numeric | numeric].
Qed.

(* hyperbolic/join.C1.slip (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance G F G_ f g h f_ g_ h_];
  exists (fun _ => 0), (fun _ => 0), (2 * ln 2), (2 * ln 2); conjuncts;
  first [ pose proof ln_lt_2; lra | unfold Rdiv; ring
    | match goal with |- Derive_n _ _ _ = _ => transitivity 0; [ | symmetry ];
    (rewrite (Derive_n_ext _ (fun _ => 0)) by (intro; unfold Rdiv; ring)); apply rate_const end
    | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/join.C1.slip (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement G F G_ f g h f_ g_ h_]; intros P R_ a b Ha Hb N1 N2; derivatives;
  revert N1 N2; unfold Rdiv; rewrite ?Rminus_0_r, ?Rminus_eq_0, ?Rmult_0_l, ?Ropp_0, ?exp_0;
  pose proof (exp_inverse (a * / 2)) as A0; pose proof (exp_inverse (b * / 2)) as B0;
  generalize dependent (exp (a * / 2)); generalize dependent (exp (- (a * / 2)));
  generalize dependent (exp (b * / 2)); generalize dependent (exp (- (b * / 2))); intros v w B0 m e A0;
  intros N1 N2 E0 E1 D1 D2 D3; assert (M1 : w - v <> 0) by (intro Z; apply N1; rewrite Z; field);
  assert (M2 : e - m <> 0) by (intro Z; apply N2; rewrite Z; field);
  assert (E : R_ 0%Z = P 2%Z) by (transitivity (((w - v) / 2) ^ 2 / ((w - v) / 2) ^ 2 * R_ 0%Z);
    [ field; exact M1 | etransitivity; [ etransitivity; [ | exact E0 ]; field; exact M1 | field;
        exact M2 ] ]); assert (F : (w + v) / (w - v) * (R_ 1%Z - R_ 0%Z) = (e + m) / (e - m) * (P 2%Z - P
      1%Z)) by (etransitivity; [ etransitivity; [ | exact E1 ]; field; exact M1 | field; exact M2 ]);
  apply (Rmult_eq_reg_l ((w + v) / (w - v)));
  [ transitivity ((w + v) / (w - v) * (R_ 1%Z - R_ 0%Z) + (w + v) / (w - v) * R_ 0%Z);
    [ ring | rewrite F, E; field; repeat split; assumption ] | apply Rmult_integral_contrapositive_currified;
    [ assumption | apply Rinv_neq_0_compat; assumption ] ].
Qed.

(* hyperbolic/join.C2 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance G F G_ f g h f_ g_ h_];
  exists (fun _ => 0), (fun _ => 0), (2 * ln 2), (2 * ln 2); conjuncts;
  first [ pose proof ln_lt_2; lra | unfold Rdiv; ring
    | match goal with |- Derive_n _ _ _ = _ => transitivity 0; [ | symmetry ];
    (rewrite (Derive_n_ext _ (fun _ => 0)) by (intro; unfold Rdiv; ring)); apply rate_const end
    | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/join.C2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement G F G_ f g h f_ g_ h_]; intros P R_ a b Ha Hb N1 N2; derivatives;
  revert N1 N2; unfold Rdiv; rewrite ?Rminus_0_r, ?Rminus_eq_0, ?Rmult_0_l, ?Ropp_0, ?exp_0;
  (let twice x := replace (exp x) with (exp (x * / 2) * exp (x * / 2)) by (rewrite <- exp_plus; f_equal;
      field) in twice a; twice b); (let twice x := replace (exp (- x)) with (exp (- (x * / 2)) * exp (- (x * /
          2))) by (rewrite <- exp_plus; f_equal; field) in twice a; twice b);
  pose proof (exp_inverse (a * / 2)) as A0; pose proof (exp_inverse (b * / 2)) as B0;
  generalize dependent (exp (a * / 2)); generalize dependent (exp (- (a * / 2)));
  generalize dependent (exp (b * / 2)); generalize dependent (exp (- (b * / 2))); intros v w B0 m e A0;
  intros N1 N2 E0 E1 E2; assert (M1 : w - v <> 0) by (intro Z; apply N1; rewrite Z; field);
  assert (M2 : e - m <> 0) by (intro Z; apply N2; rewrite Z; field);
  assert (E : R_ 0%Z = P 2%Z) by (etransitivity;
    [ etransitivity; [ | exact E0 ]; field; exact M1 | field; exact M2 ]);
  assert (F : (R_ 0%Z * (w * w + v * v) / 2 - (w + v) ^ 2 / 2 * R_ 1%Z + R_ 2%Z) / (2 * ((w - v) / 2) ^ 2) =
    (P 2%Z * (e * e + m * m) / 2 - (e + m) ^ 2 / 2 * P 1%Z + P 0%Z) / (2 * ((e - m) / 2) ^ 2)) by
  (etransitivity; [ etransitivity; [ | exact E2 ]; field; exact M1 | field; exact M2 ]);
  assert (W : (w + v) ^ 2 / 2 = 1 + (w * w + v * v) / 2) by (field_simplify_eq; ring [B0]);
  assert (W' : (e + m) ^ 2 / 2 = 1 + (e * e + m * m) / 2) by (field_simplify_eq; ring [A0]);
  rewrite W, W' in F; clear W W' E0 E1 E2 A0 B0; rewrite E in F;
  apply (Rmult_eq_compat_l (2 * ((w - v) / 2) ^ 2)) in F;
  match type of F with ?l = ?r => transitivity (l - (P 2%Z * (w * w + v * v) / 2 - (1 + (w * w + v * v) / 2) *
      R_ 1%Z)); [ field; exact M1 | rewrite F; field; repeat split; assumption ] end.
Qed.

(* hyperbolic/quadratic.decreasing *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts;
  first [ lra | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/quadratic.decreasing *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f]; intros a t A T L N;
  assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra); derivatives;
  pose proof (sinh_nonnegative ((a - t) / 2) ltac:(lra)) as S; pose proof (cosh_positive ((a - t) / 2)) as C;
  change ((a - t) * / 2) with ((a - t) / 2); generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2);
  intros d N D; generalize dependent (exp ((a - t) / 2)); generalize dependent (exp (- ((a - t) / 2)));
  intros m e S C; assert (Z : 0 <= (e - m) / 2 * ((e + m) / 2) * / d ^ 2) by (apply Rmult_le_pos;
    [ apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat, pow_lt, D ]);
  apply Rle_trans with (- ((e - m) / 2 * ((e + m) / 2) * / d ^ 2)); [ right; field; lra | lra ].
Qed.

(* hyperbolic/quadratic.ends *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/quadratic.largest *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts;
  first [ lra | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/quadratic.largest *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement h]; intros a t A T L N;
  assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra);
  pose proof (sinh_at_most (t / 2) (a / 2) ltac:(lra)) as S;
  pose proof (sinh_nonnegative (t / 2) ltac:(lra)) as S0;
  generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2);
  generalize dependent ((exp (t / 2) - exp (- (t / 2))) / 2); intros x X d N D S;
  apply (Rmult_le_reg_r (d ^ 2)); [ apply pow_lt, D
    | replace (x ^ 2 / d ^ 2 * d ^ 2) with (x ^ 2) by (field; lra); rewrite Rmult_1_l; apply pow_incr; lra ].
Qed.

(* hyperbolic/quadratic.nonnegative *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts;
  first [ lra | powers_of_two tt; numeric ].
Qed.

(* hyperbolic/quadratic.nonnegative *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f g h]; intros a t A T L N;
  assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra);
  pose proof (sinh_nonnegative (t / 2) ltac:(lra)) as S0;
  pose proof (sinh_nonnegative ((a - t) / 2) ltac:(lra)) as S1; pose proof (cosh_positive (a / 2)) as C;
  generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2);
  generalize dependent ((exp (t / 2) - exp (- (t / 2))) / 2);
  generalize dependent ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2);
  generalize dependent ((exp (a / 2) + exp (- (a / 2))) / 2); intros c C y Y x X d N D;
  assert (V : 0 < / d ^ 2) by (apply Rinv_0_lt_compat, pow_lt, D); repeat split; apply Rle_ge; unfold Rdiv;
  repeat apply Rmult_le_pos; first [ lra | apply pow_le; assumption ].
Qed.

(* hyperbolic/quadratic.nonnegative.slip *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement g] in no; generalize (no (2 * ln 2) (4 * ln 2)); clear no;
  powers_of_two tt; pose proof ln_lt_2; intro no; refine (_ (no _ _ _));
  [intro C; apply (Rge_not_lt _ _ C); numeric | lra | lra | numeric].
Qed.

(* hyperbolic/quadratic.space *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/quadratic.symmetry *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/quadratic.symmetry *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f h g]; intros a t A T N; replace (a - (a - t)) with t by ring; split;
  [reflexivity | unfold Rdiv; ring].
Qed.

(* hyperbolic/quadratic.unity *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/quadratic.unity *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f g h]; compute_goal; intros a t A T N; halves a t.
Qed.

(* hyperbolic/shape.d1 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/shape.d1.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement F h s]; intro no; assert (L : 0 < ln 2) by (pose proof ln_lt_2; lra);
  assert (C := no 2%Z (fun i => if Z.eqb i 1 then 1 else 0) (2 * ln 2) ltac:(lia) ltac:(lra) ltac:(intros;
      powers_of_two tt; numeric) ltac:(powers_of_two tt; numeric) ltac:(lia) ltac:(lia)); clear no; revert C;
  compute_goal; assert (N : ((exp (2 * ln 2 / 2) - exp (- (2 * ln 2 / 2))) / 2) ^ 2 <> 0) by (powers_of_two
    tt; numeric); derivatives; powers_of_two tt; intro C; lra.
Qed.

(* hyperbolic/shape.ends *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two.
Qed.

(* hyperbolic/shape.join *)
Theorem met.
Proof.
  cbv beta zeta delta [instance G F G_ F_ h s s2];
  exists 2%Z, 2%Z, (fun _ => 0), (fun _ => 0), (2 * ln 2), (2 * ln 2); conjuncts;
  first [ lia | intros; lia | pose proof ln_lt_2; lra | intros; powers_of_two tt; numeric | compute_goal;
    unfold Rdiv; ring | compute_goal; match goal with |- Derive_n _ _ _ = _ => transitivity 0; [ | symmetry ];
    (rewrite (Derive_n_ext _ (fun _ => 0)) by (intro; unfold Rdiv; ring)); apply rate_const end
    | powers_of_two tt; pose proof ln_lt_2; apply Rgt_not_eq; lra ].
Qed.

(* hyperbolic/shape.join *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement G F G_ F_ h s s2]; intros m n P R_ o q M N O Q N1 N2 E0 E1 I1 I2 D1 D2 D3 I3;
  assert (Z1 : ((exp (q / 2) - exp (- (q / 2))) / 2) ^ 2 <> 0) by (apply (N1 0%Z); lia);
  assert (Z2 : ((exp (o / 2) - exp (- (o / 2))) / 2) ^ 2 <> 0) by (apply (N2 0%Z); lia); clear N1 N2;
  revert E0 E1; derivatives; operators; ends; special; tidied; maxes; units; members; numbers;
  revert D1 D2 D3 Z1 Z2; unfold Rdiv; rewrite ?Rmult_0_l, ?Ropp_0, ?exp_0;
  pose proof (exp_inverse (o * / 2)) as A0; pose proof (exp_inverse (q * / 2)) as B0;
  generalize dependent (exp (o * / 2)); generalize dependent (exp (- (o * / 2)));
  generalize dependent (exp (q * / 2)); generalize dependent (exp (- (q * / 2))); intros v w B0 m1 e A0;
  intros D1 D2 D3 Z1 Z2 E0 E1; assert (M1 : w - v <> 0) by (intro Z; apply D2; rewrite Z; ring);
  assert (M2 : e - m1 <> 0) by (intro Z; apply D1; rewrite Z; ring);
  match goal with |- R_ 1%Z = ?p + (?x - 2 + _) * / ?d * (?p - ?r) => assert (E : R_ 0%Z = p) by
  (etransitivity; [ etransitivity; [ | exact E0 ]; field; exact M1 | field; exact M2 ]);
  assert (F : d * (R_ 1%Z - R_ 0%Z) = (x - 2 + o * ((e + m1) / 2) / ((e - m1) / 2)) * (p - r)) by
  (etransitivity; [ etransitivity; [ | exact E1 ]; field; exact M1 | field; exact M2 ]);
  apply (Rmult_eq_reg_l d); [ transitivity (d * (R_ 1%Z - R_ 0%Z) + d * R_ 0%Z);
    [ ring | rewrite F, E; revert D3; generalize d; intros y Y; field; split; assumption ] | exact D3 ] end.
Qed.

(* hyperbolic/shape.nonnegative *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 0; lra.
Qed.

(* hyperbolic/shape.nonnegative *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement h]; intros a t A [T L] i k K;
  assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra);
  pose proof (sinh_nonnegative (a * t / 2) ltac:(nra)) as S0;
  pose proof (sinh_nonnegative (a * (1 - t) / 2) ltac:(nra)) as S1; pose proof (cosh_positive (a / 2)) as C;
  generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2);
  generalize dependent ((exp (a * t / 2) - exp (- (a * t / 2))) / 2);
  generalize dependent ((exp (a * (1 - t) / 2) - exp (- (a * (1 - t) / 2))) / 2);
  generalize dependent ((exp (a / 2) + exp (- (a / 2))) / 2); intros c C y Y x X d D;
  assert (V : 0 < / d ^ 2) by (apply Rinv_0_lt_compat, pow_lt, D); apply basis_nonneg;
  [ lra | lra | intro j; do 3 (destruct j as [|j]; cbn [nth];
      [ unfold Rdiv; repeat apply Rmult_le_pos; first [ lra | apply pow_le; assumption ] | ]); destruct j;
    cbn [nth]; lra ].
Qed.

(* hyperbolic/shape.symmetry *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0%Z, (2 * ln 2), 0; of_exponentials powers_of_two.
Qed.

(* hyperbolic/shape.symmetry *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement h]; intros; replace (1 - (1 - u)) with u by ring; symmetry;
  apply basis_mirror; [reflexivity | cbn [length]; lia | let i := fresh in intros i ?; cbn [length] in *;
    destruct i as [|[|[|i]]]; cbn [nth Nat.sub]; try lia; unfold Rdiv; ring | cbn [length]; lia].
Qed.

(* hyperbolic/shape.unity *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, (2 * ln 2), 0; pose proof ln_lt_2; conjuncts;
  first [ lia | lra | intros; powers_of_two tt; numeric ].
Qed.

(* hyperbolic/shape.unity *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement h]; intros k a t K A [T L] N; specialize (N 0%Z ltac:(lia));
  apply unity_of_three; [ lia | lra | ]; pose proof (exp_inverse (a / 2)) as E;
  pose proof (exp_inverse (a * t / 2)) as F; replace (exp (a * (1 - t) / 2)) with (exp (a / 2) * exp (- (a * t
        / 2))) by (rewrite <- exp_plus; f_equal; field);
  replace (exp (- (a * (1 - t) / 2))) with (exp (- (a / 2)) * exp (a * t / 2)) by (rewrite <- exp_plus;
    f_equal; field); generalize dependent (exp (a / 2)); generalize dependent (exp (- (a / 2)));
  generalize dependent (exp (a * t / 2)); generalize dependent (exp (- (a * t / 2))); intros y x F m e N E;
  assert (M : e - m <> 0) by (intro Z; apply N; rewrite Z; field); field_simplify_eq; [ ring [E F] | exact M ].
Qed.

(* hyperbolic/spiral.angle.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement S_]; intro no; generalize (no 1 0); compute_goal; derivatives;
  rewrite ?Rmult_0_r, ?cos_0, ?sin_0, ?exp_0; intro C; lra.
Qed.

(* hyperbolic/spiral.curvature *)
Theorem met.
Proof.
  cbv beta zeta delta [instance S_]; exists 0, 0; compute_goal; derivatives; special; powers_of_two tt; split;
  numeric.
Qed.

(* hyperbolic/tractrix.norm *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0; repeat split;
  first [ apply filter_forall; intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra
    | pose proof (exp_pos 0); pose proof (exp_pos (- 0)); lra | apply Rle_0_sqr ].
Qed.

(* hyperbolic/tractrix.norm *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement T norm]; compute_goal; intros t N1 N2 N3 P; apply locally_singleton in N1;
  apply locally_singleton in N2; derivatives; f_equal; pose proof (exp_inverse t) as E; clear P N2;
  generalize dependent (exp t); generalize dependent (exp (- t)); intros m e N N' E; field_simplify_eq;
  [ ring [E] | repeat split; assumption ].
Qed.

(* hyperbolic/tractrix.pull *)
Theorem met.
Proof.
  cbv beta zeta delta [instance T]; exists (ln 2); pose proof (exp_pos (ln 2)); pose proof (exp_pos (- ln 2));
  compute_goal; derivatives; of_exponentials powers_of_two.
Qed.

(* hyperbolic/tractrix.speed *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two.
Qed.
