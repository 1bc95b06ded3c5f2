(* Scripts of theorems of torses whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* torses/curve.torsion *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0; compute_goal;
  derivatives; repeat split; lra.
Qed.

(* torses/curve.torsion *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement tau]; intros a1 a2 a3 b1 b2 b3 c1 c2 c3 x y z f3 f2 f1 f0 u;
  match goal with |- context [vDerive 3 ?f 1 0] => replace (vDerive 3 f 1 0) with [f1 * c1; f1 * c2;
    f1 * c3] by (compute_goal; parts; derivatives; ring) end;
  match goal with |- context [vDerive 3 ?f 2 0] => replace (vDerive 3 f 2 0) with [f2 * c1 + f1 ^ 2 * b1;
    f2 * c2 + f1 ^ 2 * b2; f2 * c3 + f1 ^ 2 * b3] by (compute_goal; parts; derivatives; field) end;
  assert (T : forall w x y z, Derive_n (fun u => w + 1 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3
        * f3 - f0) * x + 1 / 2 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3 * f3 - f0) ^ 2 * y + 1
      / 6 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3 * f3 - f0) ^ 3 * z) 3 0 = f3 * x + 3 * f1 *
    f2 * y + f1 ^ 3 * z) by (clear; intros; set (a := f2 / 2); set (b := f3 / 6);
    rewrite (Derive_n_ext _ (poly [w; f1 * x; a * x + f1 ^ 2 / 2 * y; b * x + f1 * a * y + f1 ^ 3 / 6 * z;
          (a ^ 2 / 2 + f1 * b) * y + f1 ^ 2 * a / 2 * z; a * b * y + (f1 * a ^ 2 + f1 ^ 2 * b) / 2 * z;
          b ^ 2 / 2 * y + (a ^ 3 / 6 + f1 * a * b) * z; (a ^ 2 * b + f1 * b ^ 2) / 2 * z; a * b ^ 2 / 2 * z;
          b ^ 3 / 6 * z])); [rewrite poly_derive_n, poly_at_0;
      cbv beta iota zeta delta [slope_n slope slopes tl nth]; subst a b; field | intro t;
      replace (f0 + 1 * t * f1 + 1 / 2 * t ^ 2 * f2 + 1 / 6 * t ^ 3 * f3 - f0) with (t * f1 + t ^ 2 * a + t ^
        3 * b) by (subst a b; field); clearbody a b; cbn [poly]; field]);
  match goal with |- context [vDerive 3 ?f 3 0] => replace (vDerive 3 f 3 0) with [f3 * c1 + 3 * f1 * f2 * b1
    + f1 ^ 3 * a1; f3 * c2 + 3 * f1 * f2 * b2 + f1 ^ 3 * a2;
    f3 * c3 + 3 * f1 * f2 * b3 + f1 ^ 3 * a3] by (symmetry;
    refine (f_equal2 (@cons R) (T x c1 b1 a1) (f_equal2 (@cons R) (T y c2 b2 a2) (f_equal2 (@cons R) (T z c3
            b3 a3) eq_refl)))) end; clear T; compute_goal; intros _ F N D;
  match goal with |- ?a / ?b = ?c / ?d => replace a with (f1 ^ 6 * c) by ring;
  replace b with (f1 ^ 6 * d) by ring; let q := fresh in generalize dependent d; intros q ?; field; split;
  assumption end.
Qed.

(* torses/regression.tangent *)
Theorem met.
Proof.
  cbv beta zeta delta [instance delta]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0;
  compute_goal; repeat split; [ ring | lra | apply filter_forall; intro; nra ].
Qed.

(* torses/regression.tangent *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement S_]; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u H P N;
  apply locally_singleton in N; cbv beta in N;
  assert (B : dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]) <> 0) by lra; clear P;
  assert (F : ex_derive (fun t => s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] [r1; r2;
        r3] t) 0) by (cbv beta delta [s]; revert N; compute_goal; intro N; auto_derive; intro Z; apply N;
    eapply eq_trans; [ | exact Z ]; ring); assert (S0 : s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2;
      p3] [r1; r2; r3] 0 = - dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2;
        r3]) / dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2;
        r3])) by (cbv beta delta [s]; unfold Rdiv; apply f_equal2; [ | apply f_equal ]; compute_goal; ring);
  lists; rewrite !(rate_along (fun t => s [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2; p3] [r1; r2;
        r3] t)) by exact F; match goal with |- context [Derive ?f 0] => generalize (Derive f 0) end; cbv beta;
  clear F N; intro D; rewrite ?S0; clear S0; revert B H; cbv beta delta [delta]; compute_goal; intros B H;
  parts; match type of B with ?bb <> 0 => match type of H with ?d = 0 => let by_entry e := (transitivity (- d
      * e / bb); [ field; intro Z; apply B; rewrite ?Rplus_0_r; exact Z | rewrite H; unfold Rdiv;
      ring ]) in first [ reflexivity | by_entry ((p3 * r1 - p1 * r3) * r3 - (p1 * r2 - p2 * r1) * r2)
    | by_entry ((p1 * r2 - p2 * r1) * r1 - (p2 * r3 - p3 * r2) * r3)
    | by_entry ((p2 * r3 - p3 * r2) * r2 - (p3 * r1 - p1 * r3) * r1) ] end end.
Qed.

(* torses/ruled.gauss.curvature *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0;
  cbv beta delta [N_ E_ G F X X_]; compute_goal; derivatives; repeat split; lra.
Qed.

(* torses/ruled.gauss.curvature *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement L K M N_ E_ G F];
  intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u v;
  assert (U : vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2;
        r3] v u_) 1 0 = [c1 + v * p1; c2 + v * p2; c3 + v * p3]) by (cbv beta delta [X]; compute_goal; parts;
    derivatives; ring); assert (V : vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2; r3] (v + v_)) 1 0 = [r1; r2;
      r3]) by (cbv beta delta [X_]; compute_goal; parts; derivatives; ring);
  assert (VV : vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2; r3] (v + v_)) 2 0 = [0; 0;
      0]) by (cbv beta delta [X_]; compute_goal; parts; derivatives; ring);
  assert (UV : vDerive 3 (fun v_ => vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2;
          r3] (v + v_) u_) 1 0) 1 0 = [p1; p2; p3]) by (cbv beta delta [X]; compute_goal; parts;
    apply mixed_rate); rewrite ?U, ?V, ?VV, ?UV; clear U V VV UV;
  match goal with |- _ -> _ -> _ -> (dot ?a ?b * dot [0; 0;
      0] ?n - dot ?p ?n ^ 2) / (?d) ^ 2 = _ / ?e ^ 2 => intros _ N _;
  replace (dot [0; 0; 0] n) with 0 by (compute_goal; ring); assert (S : d = e) by (compute_goal; ring);
  rewrite S in N |- *; assert (W : dot p n = delta [c1; c2; c3] [p1; p2; p3] [r1; r2;
      r3]) by (cbv beta delta [delta]; compute_goal; ring); rewrite W end; unfold Rdiv; f_equal; ring.
Qed.

(* torses/ruled.gauss.sign *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement L K M N_]; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u v;
  assert (U : vDerive 3 (fun u_ => X_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2;
        r3] v u_) 1 0 = [c1 + v * p1; c2 + v * p2; c3 + v * p3]) by (cbv beta delta [X_]; compute_goal; parts;
    derivatives; ring); assert (V : vDerive 3 (fun v_ => X__ [x; y; z] [r1; r2; r3] (v + v_)) 1 0 = [r1; r2;
      r3]) by (cbv beta delta [X__]; compute_goal; parts; derivatives; ring);
  assert (VV : vDerive 3 (fun v_ => X__ [x; y; z] [r1; r2; r3] (v + v_)) 2 0 = [0; 0;
      0]) by (cbv beta delta [X__]; compute_goal; parts; derivatives; ring);
  assert (UV : vDerive 3 (fun v_ => vDerive 3 (fun u_ => X_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2;
          r3] (v + v_) u_) 1 0) 1 0 = [p1; p2; p3]) by (cbv beta delta [X_]; compute_goal; parts;
    apply mixed_rate); rewrite ?U, ?V, ?VV, ?UV;
  match goal with |- dot ?a ?b * dot [0; 0; 0] ?n - ?m ^ 2 <= 0 => generalize m; intro w;
  replace (dot [0; 0; 0] n) with 0 by (compute_goal; ring) end; pose proof (pow2_ge_0 w); lra.
Qed.

(* torses/striction.curvature *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0; compute_goal; repeat split;
  lra.
Qed.

(* torses/striction.curvature *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement N_ p delta]; intros c1 c2 c3 x y z p1 p2 p3 r1 r2 r3 u R0 _ B;
  set (t := s _ _ _); replace (vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2;
        r3] t u_) 1 0) with [c1 + t * p1; c2 + t * p2; c3 + t * p3] by (clearbody t; cbv beta delta [X];
    compute_goal; parts; derivatives; ring); replace (vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2;
        r3] (t + v_)) 1 0) with [r1; r2; r3] by (clearbody t; cbv beta delta [X_]; compute_goal; parts;
    derivatives; ring); subst t; cbv beta delta [s]; rewrite R0;
  set (bb := dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3])) in *;
  transitivity (det [[c1; c2; c3]; [r1; r2; r3]; [p1; p2; p3]] ^ 2 * dot [r1; r2; r3] [r1; r2; r3] / bb);
  [ set (ab := dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]));
    transitivity (dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [c1; c2; c3] [r1; r2;
          r3]) + 2 * (- ab / bb) * ab + (- ab / bb) ^ 2 * bb);
    [ subst ab; generalize (- dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]) / bb);
      subst bb; compute_goal; intro; ring | transitivity ((dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [c1;
              c2; c3] [r1; r2; r3]) * bb - ab ^ 2) / bb);
      [ field; exact B | unfold Rdiv; f_equal; subst ab bb; compute_goal; ring ] ] | rewrite R0; field;
    exact B ].
Qed.

(* torses/striction.growth *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros c1 c2 c3 x y z p1 p2 p3 r1 r2 r3 u v;
  assert (E : forall t, N_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] u t = cross [c1 + t * p1;
      c2 + t * p2; c3 + t * p3] [r1; r2; r3]) by (intro t; cbv beta delta [N_ X X_]; compute_goal; parts;
    derivatives; ring); rewrite (Derive_n_ext _ (fun t => dot (cross [c1 + (v + t) * p1; c2 + (v + t) * p2;
          c3 + (v + t) * p3] [r1; r2; r3]) (cross [c1 + (v + t) * p1; c2 + (v + t) * p2;
          c3 + (v + t) * p3] [r1; r2; r3]))) by (intro; rewrite E; reflexivity); clear E; compute_goal;
  derivatives; apply Rle_ge, Rle_trans with (2 * ((p2 * r3 - p3 * r2) ^ 2 + (p3 * r1 - p1 * r3) ^ 2 + (p1 * r2
        - p2 * r1) ^ 2)); [ repeat apply Rmult_le_pos; try apply Rplus_le_le_0_compat;
    try apply Rplus_le_le_0_compat; try apply pow2_ge_0; lra | right; ring ].
Qed.

(* torses/striction.unit *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0;
  compute_goal; repeat split; [ ring | lra | apply filter_forall; intro; lra ].
Qed.

(* torses/striction.unit *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement S1]; lists; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u H P
  N; apply locally_singleton in N; cbv beta in N;
  assert (F : ex_derive (fun t => s1 [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2;
        p3] t) 0) by (cbv beta delta [s1]; compute_goal; auto_derive; intro Z; apply N; eapply eq_trans;
    [ | exact Z ]; ring); rewrite !(rate_along (fun t => s1 [a1; a2; a3] [c1; c2; c3] [q1; q2; q3] [p1; p2;
        p3] t)) by exact F; match goal with |- context [Derive ?f 0] => generalize (Derive f 0) end; clear F;
  intro D; cbv beta delta [s1]; compute_goal; unfold fold_right in *;
  transitivity (D * (r1 * p1 + (r2 * p2 + (r3 * p3 + 0))));
  [ field; intro Z; apply N; eapply eq_trans; [ | exact Z ]; ring | cbn in H; rewrite H; ring ].
Qed.

(* torses/curve.torsion (printed) *)
Theorem met.
Proof.
  hnf; exists (fun t => t), (fun t => t * t), (fun _ => 0), (fun t => t), 0; values_by_jets.
Qed.

(* torses/curve.torsion (printed) *)
Theorem proved.
Proof.
  hnf; intros c'1 c'2 c'3 phi u; computed_by_jets;
  match goal with |- ?a / ?b = ?c / ?d => replace a with (Derive_n phi 1 u ^ 6 * c) by ring;
    replace b with (Derive_n phi 1 u ^ 6 * d) by ring; let q := fresh in generalize dependent d; intros q ?;
    intros; field; split; assumption end.
Qed.
