(* Functions of bases that are not negative, and sums of them: nobody has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- the seeds of the trigonometric functions ---- *)
Lemma outer_seed s m : 0 <= s <= 1 -> m <= 1 -> 0 <= (1 - s) * (1 - m * s).
Proof. intros [H1 H2] M. apply Rmult_le_pos; [lra|]. assert (m * s <= 1 * s) by (apply Rmult_le_compat_r; lra). lra. Qed.
(* from above: the rest is at least the square *)
Lemma outer_seed_most s m : 0 <= s <= 1 -> - 1 <= m -> (1 - s) * (1 - m * s) <= 1 - s ^ 2.
Proof.
  intros [H1 H2] M. replace (1 - s ^ 2) with ((1 - s) * (1 + s)) by ring. apply Rmult_le_compat_l; [lra|].
  assert (- 1 * s <= m * s) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma middle_seed s c m n : 0 <= s <= 1 -> 0 <= c <= 1 -> s ^ 2 + c ^ 2 = 1 -> - 1 <= m -> - 1 <= n ->
  0 <= 1 - (1 - s) * (1 - m * s) - (1 - c) * (1 - n * c).
Proof. intros S C E M N. pose proof (outer_seed_most s m S M). pose proof (outer_seed_most c n C N). lra. Qed.
Ltac trigonometric_seed := match goal with
  | |- 0 <= (1 - sin ?t) * (1 - ?m * sin ?t) => apply outer_seed; lra
  | |- 0 <= (1 - cos ?t) * (1 - ?m * cos ?t) => apply outer_seed; lra
  | |- 0 <= 1 - (1 - sin ?t) * (1 - ?m * sin ?t) - (1 - cos ?t) * (1 - ?n * cos ?t) =>
      apply middle_seed; [lra|lra|apply square_sum|lra|lra]
  end.
Ltac seed := first [ lra | trigonometric_seed | circles; roots; nra ].
Ltac nonnegative ::= apply basis_nonneg; [ lra | lra |
  let i := fresh in intro i; signs; do 5 (destruct i as [|i]; cbn [nth]; [seed|]); destruct i; cbn [nth]; lra ].

(* ---- products, sums ---- *)
Lemma sum_nonneg l h f : (forall i, (l <= i <= h)%Z -> 0 <= f i) -> 0 <= sum l h f.
Proof.
  intro H. unfold sum. assert (G : forall i, In i (range l h) -> 0 <= f i) by (intros; apply H, range_in; assumption).
  clear H. induction (range l h) as [|i r IH]; cbn [map fold_right]; [lra|].
  apply Rplus_le_le_0_compat; [apply G; left; reflexivity|apply IH; intros; apply G; right; assumption].
Qed.
Ltac not_negative := lazymatch goal with
  | |- _ >= 0 => apply Rle_ge; not_negative
  | |- 0 <= basis _ _ _ _ _ => nonnegative
  | |- 0 <= sum _ _ _ => apply sum_nonneg; intros; not_negative
  | |- 0 <= _ * _ => apply Rmult_le_pos; not_negative
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; not_negative
  | |- 0 <= _ ^ _ => apply pow_le; not_negative
  | |- 0 <= ?a => first [assumption | lra | match goal with H : forall _, _ |- _ => first [apply H | apply Rge_le, H]; lia end]
  end.

(* ---- signs of sines and cosines, of sums and quotients ---- *)
Ltac sign_of_sine a := lazymatch goal with
  | _ : 0 <= sin a <= 1 |- _ => fail | _ : 0 < sin a <= 1 |- _ => fail | _ : -1 <= sin a <= 1 |- _ => fail
  | _ => first
    [ assert (0 < sin a <= 1) by (split; [apply sin_gt_0; lra|apply SIN_bound])
    | assert (0 <= sin a <= 1) by (split; [apply sin_ge_0; lra|apply SIN_bound])
    | pose proof (SIN_bound a) ] end.
Ltac sign_of_cosine a := lazymatch goal with
  | _ : 0 <= cos a <= 1 |- _ => fail | _ : 0 < cos a <= 1 |- _ => fail | _ : -1 <= cos a <= 1 |- _ => fail
  | _ => first
    [ assert (0 < cos a <= 1) by (split; [apply cos_gt_0; lra|apply COS_bound])
    | assert (0 <= cos a <= 1) by (split; [apply cos_ge_0; lra|apply COS_bound])
    | pose proof (COS_bound a) ] end.
Ltac trigonometric_signs := pose proof PI_RGT_0; signs; repeat match goal with
  | |- context [sin ?a] => sign_of_sine a
  | |- context [cos ?a] => sign_of_cosine a
  end.
Lemma quotient_sign a b : 0 <= a -> 0 < b -> 0 <= a / b.
Proof. intros A B. apply Rmult_le_pos; [exact A|]. left. apply Rinv_0_lt_compat, B. Qed.
Ltac positive_parts := lazymatch goal with
  | |- _ >= 0 => apply Rle_ge; positive_parts
  | |- _ > 0 => apply Rlt_gt; positive_parts
  | |- 0 <= _ * _ => apply Rmult_le_pos; positive_parts
  | |- 0 < _ * _ => apply Rmult_lt_0_compat; positive_parts
  | |- 0 <= _ / _ => apply quotient_sign; positive_parts
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; positive_parts
  | |- 0 <= _ ^ 2 => apply pow2_ge_0
  | |- 0 < _ ^ _ => apply pow_lt; positive_parts
  | _ => first [trigonometric_seed | lra | nra]
  end.
Ltac order1 ::= lazymatch goal with
  | |- _ = _ => atoms; equal
  | |- _ => first
    [ not_negative
    | special; first [ numeric | lra
      | facts; trigonometric_signs; first [lra | positive_parts | exponentials; circles; roots; first [lra | nra | positive_parts]] ] ]
  end.
