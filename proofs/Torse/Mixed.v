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
