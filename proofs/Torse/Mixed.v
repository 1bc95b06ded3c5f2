(* Statements of several parts, of which each has a proof of its own kind: nobody has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- signs of sums of products, by their form ---- *)
Lemma product_positive a b : 0 < a -> 0 < b -> 0 < a * b.
Proof. apply Rmult_lt_0_compat. Qed.
Lemma power_positive a n : 0 < a -> 0 < a ^ n.
Proof. apply pow_lt. Qed.
Lemma sum_positive_left a b : 0 < a -> 0 <= b -> 0 < a + b.
Proof. lra. Qed.
Lemma sum_positive_right a b : 0 <= a -> 0 < b -> 0 < a + b.
Proof. lra. Qed.
Ltac not_negative := first [ assumption | lra | lazymatch goal with
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; not_negative
  | |- 0 <= _ * _ => apply Rmult_le_pos; not_negative
  | |- 0 <= _ ^ _ => apply pow_le; not_negative
  end ].
Ltac is_positive := first [ assumption | lra | lazymatch goal with
  | |- 0 < _ + _ => first [ apply sum_positive_left; [is_positive | not_negative] | apply sum_positive_right; [not_negative | is_positive] ]
  | |- 0 < _ * _ => apply product_positive; is_positive
  | |- 0 < _ ^ _ => apply power_positive; is_positive
  end ].
Ltac by_form := computed; intros; equations; divisors; numbers; facts; pose proof PI_RGT_0; lazymatch goal with
  | |- 0 < _ => is_positive
  | |- _ > 0 => apply Rlt_gt; is_positive
  | |- 0 <= _ => not_negative
  | |- _ >= 0 => apply Rle_ge; not_negative
  end.

(* ---- parts ---- *)
Ltac back := repeat match goal with x : _ |- _ => revert x end.
Ltac alone := back; first
  [ solve [symbolic] | solve [by_form] | solve [ordered] | solve [identity] | solve [combined] | solve [computed; intros; nra] ].
Ltac mixed := cbv zeta; intros; conjuncts; alone.

(* ---- rational arcs at the parameter of an angle ---- *)
Lemma half_cos q : cos (PI * q) = cos (PI / 2 * q) ^ 2 - sin (PI / 2 * q) ^ 2.
Proof. replace (PI * q) with (2 * (PI / 2 * q)) by field. rewrite cos_2a. ring. Qed.
Lemma half_sin q : sin (PI * q) = 2 * sin (PI / 2 * q) * cos (PI / 2 * q).
Proof. replace (PI * q) with (2 * (PI / 2 * q)) by field. apply sin_2a. Qed.
Lemma arc s c : s ^ 2 + c ^ 2 = 1 -> s + c <> 0 ->
  2 * (s / (s + c)) ^ 2 - 2 * (s / (s + c)) + 1 = 1 / (s + c) ^ 2.
Proof.
  intros E N. replace (2 * (s / (s + c)) ^ 2 - 2 * (s / (s + c)) + 1) with ((s ^ 2 + c ^ 2) / (s + c) ^ 2)
    by (field; exact N). rewrite E. reflexivity.
Qed.
Lemma arc_cos s c : s ^ 2 + c ^ 2 = 1 -> s + c <> 0 ->
  (1 - 2 * (s / (s + c))) / (2 * (s / (s + c)) ^ 2 - 2 * (s / (s + c)) + 1) = c ^ 2 - s ^ 2.
Proof. intros E N. rewrite (arc s c E N). field. exact N. Qed.
Lemma arc_sin s c : s ^ 2 + c ^ 2 = 1 -> s + c <> 0 ->
  (2 * (s / (s + c)) - 2 * (s / (s + c)) ^ 2) / (2 * (s / (s + c)) ^ 2 - 2 * (s / (s + c)) + 1) = 2 * s * c.
Proof. intros E N. rewrite (arc s c E N). field. exact N. Qed.
Lemma arc_cos' s c : s ^ 2 + c ^ 2 = 1 -> s + c <> 0 ->
  (1 - 2 * (s / (s + c))) / (1 / (s + c) ^ 2) = c ^ 2 - s ^ 2.
Proof. intros E N. field. exact N. Qed.
Lemma arc_range q : 0 <= q <= 1 -> sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  0 <= sin (PI / 2 * q) / (sin (PI / 2 * q) + cos (PI / 2 * q)) /\
  sin (PI / 2 * q) / (sin (PI / 2 * q) + cos (PI / 2 * q)) <= 1.
Proof.
  intros Q N. pose proof (quarter_sine q Q) as S. pose proof (quarter_cosine q Q) as C.
  assert (P : 0 < sin (PI / 2 * q) + cos (PI / 2 * q)) by lra. split.
  - apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat, P.
  - apply Rmult_le_reg_r with (sin (PI / 2 * q) + cos (PI / 2 * q)); [exact P|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by exact N. lra.
Qed.
Lemma arc_rate q : sin (PI / 2 * q) + cos (PI / 2 * q) <> 0 ->
  Derive_n (fun q => sin (PI / 2 * q) / (sin (PI / 2 * q) + cos (PI / 2 * q))) 1 q > 0.
Proof.
  intro N. derivative.
  match goal with |- ?v > 0 => replace v with (PI / 2 / (sin (PI / 2 * q) + cos (PI / 2 * q)) ^ 2) end.
  - apply Rlt_gt. apply Rmult_lt_0_compat; [pose proof PI_RGT_0; lra|]. apply Rinv_0_lt_compat.
    assert (0 < (sin (PI / 2 * q) + cos (PI / 2 * q)) * (sin (PI / 2 * q) + cos (PI / 2 * q))) by (apply Rsqr_pos_lt; exact N).
    cbn [pow]. lra.
  - pose proof (square_sum (PI / 2 * q)) as E. revert E N. generalize (sin (PI / 2 * q)) (cos (PI / 2 * q)). intros s c E N.
    apply circle_rule in E. field_simplify_eq; [ring [E] | exact N].
Qed.
