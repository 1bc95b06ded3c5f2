(* Scripts of theorems of bezier whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* bezier/bernstein.derivative *)
Theorem proved.
Proof.
  cbv delta [statement B]; intros; apply rate; assumption.
Qed.

(* bezier/bernstein.elevation *)
Theorem proved.
Proof.
  cbv delta [statement B]; intros; apply raised; assumption.
Qed.

(* bezier/bernstein.formula *)
Theorem proved.
Proof.
  cbv delta [statement B C_]; intros; apply curve_bernstein.
Qed.

(* bezier/bernstein.precision *)
Theorem proved.
Proof.
  cbv delta [statement B]; intros; apply linear_precision; assumption.
Qed.

(* bezier/curve.elevation *)
Theorem proved.
Proof.
  cbv delta [statement B C_]; intros; apply curve_raised; lia.
Qed.

(* bezier/exists.parallel *)
Theorem met.
Proof.
  cbv delta [instance]; exists 1, 0, 1, 0; compute_goal; repeat split; lra.
Qed.

(* bezier/exists.parallel *)
Theorem proved.
Proof.
  cbv delta [statement]; intros p1 p2 q1 q2; compute_goal; intros S E N; parts;
  pose proof (f_equal (Rmult p1) E); pose proof (f_equal (Rmult p2) E); field_simplify_eq;
  [ lra | intro Z; apply N; lra | lra | intro Z; apply N; lra ].
Qed.

(* bezier/family.casteljau *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, (fun _ => 0), 0, 0; repeat split; intros; (lra || lia).
Qed.

(* bezier/join.C3 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2 d3]; intros m n P Q M N _ _ E F G H _ _ A _ B _ C _;
  revert E F G H; lists; derivatives; operators; ends; tidied; maxes; members; numbers; intros E F G H;
  apply (Rmult_eq_reg_l (IZR n * (IZR n - 1) * (IZR n - 2)));
  [ match type of F with ?f = _ => match type of G with ?g = _ => match type of H with ?h = _ => transitivity
    (h + 3 * (IZR n - 2) * g + 3 * (IZR n - 1) * (IZR n - 2) * f + IZR n * (IZR n - 1) * (IZR n - 2) * Q 0%Z)
    end end end; [ ring | rewrite F, G, H, E; field; nonzero ] | exact C ].
Qed.

(* bezier/language.numbers *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m x P Q; refine (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ _))))));
  [ compute_goal; lra | compute_goal; field | compute_goal; lra | replace 8 with (2 * 2 * 2) by ring;
    rewrite sqrt_mult by lra; rewrite sqrt_square by lra; ring | rewrite <- sqrt_mult by lra; f_equal; ring
    | apply sin_PI6 | replace (PI * x) with (2 * (PI / 2 * x)) by field; apply sin_2a ].
Qed.

(* bezier/language.vectors *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros a b c d e f; compute_goal;
  refine (conj _ (conj _ (conj _ (conj _ (conj _ _)))));
  [ ring | repeat f_equal; ring | replace (3 * 3 + (4 * 4 + 0)) with (5 * 5) by ring; apply sqrt_square; lra
    | f_equal; ring | reflexivity | ring ].
Qed.

(* bezier/list.nonnegative *)
Theorem met.
Proof.
  cbv delta [instance]; exists 0, 0; lra.
Qed.

(* bezier/list.nonnegative *)
Theorem proved.
Proof.
  cbv beta delta [statement T]; intros v x V X; compute_goal; assert (0 <= 1 + v * x) by nra;
  assert (0 <= 1 + v * (1 - x)) by nra; refine (conj _ (conj _ _)); apply Rle_ge;
  [ repeat apply Rmult_le_pos; lra | match goal with |- 0 <= ?t => replace t with (x * (1 - x) * (2 - v)) by
    ring end; repeat apply Rmult_le_pos; lra | repeat apply Rmult_le_pos; lra ].
Qed.

(* bezier/power.binomial *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, 1, 1; repeat split; intros; (lia || (left; lia)).
Qed.

(* bezier/power.binomial *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m u v M _ _ _;
  assert (S : forall n c, pw u v n (fun _ => c) = c * (u + v) ^ n) by (let n := fresh in intro n;
    induction n as [|n IH]; intro c; cbn [pw pow]; [ ring | rewrite IH; ring ]); rewrite natural_power by lia;
  transitivity (sum 0 m (fun i => basis u v [1] i m * 1));
  [ rewrite curve_bernstein; apply sum_ext; intros; ring | rewrite curve1 by lia;
    rewrite (pw_ext _ _ _ _ (fun _ => 1)) by (intro; unfold seed3; ring); rewrite S; ring ].
Qed.

(* bezier/power.ends *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, 0; repeat split; (lra || lia || (left; lia)).
Qed.

(* bezier/power.ends *)
Theorem proved.
Proof.
  cbv beta delta [statement B]; intros m x M; intros; rewrite !basis_bernstein by lia;
  rewrite !natural_power by lia; rewrite Z.sub_0_r, Z.sub_diag;
  assert (F : forall n, falling (INR n) n = 1) by (let n := fresh in intro n; induction n as [|n IH];
    [ reflexivity | pose proof (not_zero n); apply Rmult_eq_reg_r with (INR (S n));
      [ rewrite S_INR at 1; rewrite lowered, IH, S_INR; ring | assumption ] ]);
  assert (B0 : binom (IZR m) 0 = 1) by reflexivity;
  assert (B1 : binom (IZR m) m = 1) by (unfold binom; destruct (Z.leb_spec 0 m); [ | lia ];
    transitivity (falling (INR (Z.to_nat m)) (Z.to_nat m)); [ | apply F ]; f_equal;
    rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); rewrite B0, B1; cbn [Z.to_nat pow]; split; ring.
Qed.

(* bezier/power.next *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, 0; repeat split; (lra || lia || (left; lia)).
Qed.

(* bezier/power.next *)
Theorem proved.
Proof.
  cbv delta [statement]; intros; rewrite !natural_power by lia;
  replace (Z.to_nat (m + 1)) with (S (Z.to_nat m)) by lia; cbn [pow]; ring.
Qed.

(* bezier/power.product *)
Theorem met.
Proof.
  cbv delta [instance]; exists 0%Z, 3%Z, 1, 1; repeat split; (lia || (left; lia)).
Qed.

(* bezier/power.product *)
Theorem proved.
Proof.
  cbv delta [statement]; intros; rewrite !natural_power by lia;
  rewrite Z2Nat.inj_add, pow_add, Rpow_mult_distr by lia; ring.
Qed.

(* bezier/power.rate *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, 0; refine (conj _ (conj _ (conj _ (conj _ _))));
  [ lia | lra | apply filter_forall; intro; left; lia | apply ex_derive_ext with (fun t => (1 - t) ^ 3);
    [ intro; reflexivity | auto_derive; exact I ] | left; lia ].
Qed.

(* bezier/power.rate *)
Theorem proved.
Proof.
  cbv delta [statement]; intros; rewrite (Derive_n_ext _ (fun t => (1 - t) ^ Z.to_nat m)) by (intro;
    apply natural_power; lia); rewrite natural_power by lia; apply is_derive_unique; auto_derive;
  [ exact I | rewrite INR_IZR_INZ, Z2Nat.id by lia;
    replace (pred (Z.to_nat m)) with (Z.to_nat (m - 1)) by lia; replace (1 + - x) with (1 - x) by ring; ring ].
Qed.

(* bezier/power.rate.slip *)
Theorem refuted.
Proof.
  cbv delta [statement not]; intro no; assert (E : Derive_n (fun x_ => powerRZ (1 - x_) 3) 1 0 = IZR 3 *
    powerRZ (1 - 0) (3 - 1)) by (apply no; [ lia | lra | apply filter_forall; intro; left; lia
      | apply ex_derive_ext with (fun t => (1 - t) ^ 3); [ intro; reflexivity | auto_derive; exact I ] | left;
      lia ]); assert (F : Derive_n (fun x_ => powerRZ (1 - x_) 3) 1 0 = - 3) by (apply is_derive_unique;
    apply is_derive_ext with (fun t => (1 - t) ^ 3);
    [ intro; reflexivity | auto_derive; [ exact I | cbn; ring ] ]); rewrite F in E;
  change (powerRZ (1 - 0) (3 - 1)) with ((1 - 0) * ((1 - 0) * 1)) in E; lra.
Qed.

(* bezier/power.rate.slip (corrected) *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, 0; refine (conj _ (conj _ (conj _ (conj _ _))));
  [ lia | lra | apply filter_forall; intro; left; lia | apply ex_derive_ext with (fun t => (1 - t) ^ 3);
    [ intro; reflexivity | auto_derive; exact I ] | left; lia ].
Qed.

(* bezier/power.rate.slip (corrected) *)
Theorem proved.
Proof.
  cbv delta [statement]; intros; rewrite (Derive_n_ext _ (fun t => (1 - t) ^ Z.to_nat m)) by (intro;
    apply natural_power; lia); rewrite natural_power by lia; apply is_derive_unique; auto_derive;
  [ exact I | rewrite INR_IZR_INZ, Z2Nat.id by lia;
    replace (pred (Z.to_nat m)) with (Z.to_nat (m - 1)) by lia; replace (1 + - x) with (1 - x) by ring; ring ].
Qed.

(* bezier/reach.above *)
Theorem proved.
Proof.
  cbv delta [statement]; intros y P Q; split; [ apply sqrt_lt_1_alt; lra | radicals; nra ].
Qed.

(* bezier/reach.cauchy *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros a b c d e f; compute_goal; pose proof (pow2_ge_0 (a * e - b * d));
  pose proof (pow2_ge_0 (a * f - c * d)); pose proof (pow2_ge_0 (b * f - c * e)); nra.
Qed.

(* bezier/reach.circle.bound *)
Theorem proved.
Proof.
  cbv delta [statement]; intros a b H; pose proof (pow2_ge_0 (a - b)); nra.
Qed.

(* bezier/reach.implies *)
Theorem proved.
Proof.
  cbv delta [statement]; intros a b H; split; nra.
Qed.

(* bezier/reach.interval.basis *)
Theorem met.
Proof.
  exists 0, 2, 1; repeat split; lra.
Qed.

(* bezier/reach.interval.basis *)
Theorem proved.
Proof.
  cbv delta [statement]; intros r s y A B C D; assert (P : 0 < (s - r) ^ 2) by nra; split;
  [ apply Rmult_le_pos; [ nra | left; apply Rinv_0_lt_compat, P ] | apply Rmult_le_reg_r with ((s - r) ^ 2);
    [ exact P | unfold Rdiv; rewrite Rmult_assoc, Rinv_l by exact D; pose proof (pow2_ge_0 (2 * y - r - s));
      nra ] ].
Qed.

(* bezier/reach.interval.closed *)
Theorem met.
Proof.
  exists 0, 2, 1; repeat split; lra.
Qed.

(* bezier/reach.interval.open *)
Theorem met.
Proof.
  exists 0, 2, 1; repeat split; lra.
Qed.

(* bezier/reach.least *)
Theorem proved.
Proof.
  cbv delta [statement]; intros y P Q; split; [ apply sqrt_lt_R0; nra | apply Rle_ge, sqrt_pos ].
Qed.

(* bezier/reach.length.zero *)
Theorem proved.
Proof.
  cbv delta [statement]; intros a b c p H; compute_in H; subst p; replace a with 0 by nra;
  replace b with 0 by nra; replace c with 0 by nra; reflexivity.
Qed.

(* bezier/reach.product *)
Theorem proved.
Proof.
  cbv delta [statement]; intros A B P Q S; symmetry; apply sqrt_mult; assumption.
Qed.

(* bezier/reach.product.zero *)
Theorem proved.
Proof.
  cbv delta [statement]; intros a b; split; [ apply Rmult_integral | intros [-> | ->]; ring ].
Qed.

(* bezier/reach.roots *)
Theorem proved.
Proof.
  cbv delta [statement]; intros y H; destruct (Rmult_integral (y - 2) (y + 2)) as [E | E];
  [ lra | left; lra | right; lra ].
Qed.

(* bezier/reach.size *)
Theorem proved.
Proof.
  cbv delta [statement]; intros y z A B C D; split;
  [ apply same_square; [ apply sqrt_pos | apply Rmult_le_pos; apply sqrt_pos | radicals; nra ] | f_equal;
    ring ].
Qed.

(* bezier/reach.size.slip *)
Theorem refuted.
Proof.
  cbv delta [statement not]; intro no; specialize (no (-1) ltac:(lra)); pose proof (sqrt_pos ((-1) ^ 2)); lra.
Qed.

(* bezier/reach.square *)
Theorem met.
Proof.
  exists (sqrt (1 / 2)); split; [ apply sqrt_lt_R0; lra | apply square_root; lra ].
Qed.

(* bezier/reach.square *)
Theorem proved.
Proof.
  cbv delta [statement]; intros w P H; replace (w ^ 4) with (w ^ 2 * w ^ 2) by ring; rewrite H; field.
Qed.

(* bezier/reach.subadditive *)
Theorem proved.
Proof.
  cbv delta [statement]; intros A B P Q S; radicals; apply less_square; nra.
Qed.

(* bezier/reach.triangle *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros a b c d e f; compute_goal; apply triangle.
Qed.

(* bezier/reach.triangle.slip *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not]; intro no; specialize (no 0 0 0 0 0 0); compute_in no; revert no;
  replace ((0 + 0) * (0 + 0) + ((0 + 0) * (0 + 0) + ((0 + 0) * (0 + 0) + 0))) with 0 by ring;
  replace (0 * 0 + (0 * 0 + (0 * 0 + 0))) with 0 by ring; rewrite sqrt_0; lra.
Qed.

(* bezier/reach.unit *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 0, 0; refine (conj (fun E => _) _);
  [ injection E as E; lra | compute_goal; replace (1 * 1 + (0 * 0 + (0 * 0 + 0))) with 1 by ring;
    rewrite sqrt_1; lra ].
Qed.

(* bezier/reach.unit *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros a b c N; compute_goal; apply unit_root.
Qed.

(* bezier/reach.unit.zero *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros a b c M N; revert M; compute_goal; apply unit_root.
Qed.

(* bezier/reach.vector *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, 0, 0, 0, 0, 0; refine (conj (fun E => _) _);
  [ injection E as E; lra | compute_goal; lra ].
Qed.

(* bezier/sum.powers *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z; lia.
Qed.

(* bezier/sum.powers *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m M; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n;
  induction n as [|n IH]; [ rewrite sum_empty by lia; cbn [Z.of_nat]; field | rewrite sum_last by lia;
    replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; field ].
Qed.

(* bezier/sum.powers.slip (corrected) *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z; lia.
Qed.

(* bezier/sum.powers.slip (corrected) *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m M; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n;
  induction n as [|n IH]; [ rewrite sum_empty by lia; cbn [Z.of_nat]; field | rewrite sum_last by lia;
    replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; field ].
Qed.

(* bezier/sum.swap *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, (fun _ => 0); repeat split; lia.
Qed.

(* bezier/sum.swap *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m P M _; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear;
  intro n; induction n as [|n IH]; [ compute_goal; ring
    | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P j)) by lia;
    cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => P l)) by lia;
    replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR;
    rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 + 1 - IZR j) * P j) (fun j => (IZR
          (Z.of_nat n) + 1 - IZR j) * P j + P j)) by (intros; ring); rewrite sum_plus;
    change (sum 0 (Z.of_nat n) (fun l : Z => P l)) with (sum 0 (Z.of_nat n) P); ring ].
Qed.

(* bezier/sum.swap.weighted *)
Theorem met.
Proof.
  cbv delta [instance]; exists 3%Z, (fun _ => 0); repeat split; lia.
Qed.

(* bezier/sum.swap.weighted *)
Theorem proved.
Proof.
  cbv delta [statement]; intros m P M _; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear;
  intro n; assert (L : sum 0 (Z.of_nat n) (fun j => sum 0 j (fun l => P l)) = sum 0 (Z.of_nat n) (fun j =>
      (IZR (Z.of_nat n) + 1 - IZR j) * P j)) by (induction n as [|n IH];
    [ compute_goal; ring | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P
          j)) by lia; cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => P l)) by lia;
      replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR;
      rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 + 1 - IZR j) * P j) (fun j => (IZR
            (Z.of_nat n) + 1 - IZR j) * P j + P j)) by (intros; ring); rewrite sum_plus;
      change (sum 0 (Z.of_nat n) (fun l : Z => P l)) with (sum 0 (Z.of_nat n) P); ring ]); clear L;
  induction n as [|n IH]; [ compute_goal; field
    | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P j)) by lia;
    cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => _ * P l)) by lia;
    replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR;
    rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 - IZR j) * (IZR (Z.of_nat n) + 1 + 1 - IZR
          j) / 2 * P j) (fun j => (IZR (Z.of_nat n) - IZR j) * (IZR (Z.of_nat n) + 1 - IZR j) / 2 * P j + (IZR
          (Z.of_nat n) + 1 - IZR j) * P j)) by (intros; field); rewrite sum_plus; field ].
Qed.

(* bezier/trigonometric.bezier *)
Theorem met.
Proof.
  cbv beta zeta delta [instance S_ S__ F F_ B T]; exists 3%Z, (fun _ => 0), (fun _ => 0), 0, 0;
  repeat match goal with |- _ /\ _ => split end; intros; try lra; try lia; compute_goal; derivatives; special;
  ring.
Qed.

(* bezier/trigonometric.bezier *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement S_ S__ F F_ B T]; intros n P R_ l m L M N _ A D _ Z; revert A D;
  closed_parts; derivatives; operators; ends; special; compute_goal; derivatives; special;
  rewrite (Z.max_l n 0) by lia; intros A D; assert (A' : R_ 0%Z = P 3%Z) by lra; rewrite A' in D;
  apply (Rmult_eq_reg_l (2 * IZR n)); [ | exact Z ];
  match goal with |- _ = ?r => replace r with (2 * IZR n * P 3%Z + PI * (2 + m) * (P 3%Z - P 2%Z)) by (field;
    intro E; apply Z; rewrite E; ring) end; lra.
Qed.
