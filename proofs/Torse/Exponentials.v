(* Exponentials: those of sums and multiples become products of few of them, which are numbers e and m with e m = 1. Nobody
   has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From Coq Require Import Lra Lia.
Open Scope R_scope.

Lemma exp_minus a b : exp (a - b) = exp a * exp (- b). Proof. unfold Rminus. apply exp_plus. Qed.
Lemma exp_opp_plus a b : exp (- (a + b)) = exp (- a) * exp (- b). Proof. rewrite <- exp_plus. f_equal. ring. Qed.
Lemma exp_opp_minus a b : exp (- (a - b)) = exp (- a) * exp b. Proof. rewrite <- exp_plus. f_equal. ring. Qed.
Lemma exp_plus_part a b c : exp ((a + b) / c) = exp (a / c) * exp (b / c).
Proof. rewrite <- exp_plus. f_equal. unfold Rdiv. ring. Qed.
Lemma exp_minus_part a b c : exp ((a - b) / c) = exp (a / c) * exp (- (b / c)).
Proof. rewrite <- exp_plus. f_equal. unfold Rdiv. ring. Qed.
Lemma exp_opp_plus_part a b c : exp (- ((a + b) / c)) = exp (- (a / c)) * exp (- (b / c)).
Proof. rewrite <- exp_plus. f_equal. unfold Rdiv. ring. Qed.
Lemma exp_opp_minus_part a b c : exp (- ((a - b) / c)) = exp (- (a / c)) * exp (b / c).
Proof. rewrite <- exp_plus. f_equal. unfold Rdiv. ring. Qed.
Lemma exp_opp_opp a : exp (- - a) = exp a. Proof. f_equal. ring. Qed.
Lemma exp_opp_zero : exp (- 0) = 1. Proof. rewrite Ropp_0. apply exp_0. Qed.
Lemma exp_inverse a : exp a * exp (- a) = 1.
Proof. rewrite <- exp_plus, <- exp_0. f_equal. ring. Qed.

(* order, of hyperbolic sines and cosines too *)
Lemma exp_at_most x y : x <= y -> exp x <= exp y.
Proof. intro H. destruct (Rle_lt_or_eq_dec x y H) as [L|<-]; [left; apply exp_increasing, L | right; reflexivity]. Qed.
Lemma sinh_at_most x y : x <= y -> (exp x - exp (- x)) / 2 <= (exp y - exp (- y)) / 2.
Proof. intro H. pose proof (exp_at_most x y H). pose proof (exp_at_most (- y) (- x) ltac:(lra)). lra. Qed.
Lemma sinh_nonnegative x : 0 <= x -> 0 <= (exp x - exp (- x)) / 2.
Proof. intro H. pose proof (sinh_at_most 0 x H) as L. rewrite Ropp_0 in L. lra. Qed.
Lemma sinh_positive x : 0 < x -> 0 < (exp x - exp (- x)) / 2.
Proof. intro H. pose proof (exp_increasing (- x) x ltac:(lra)). lra. Qed.
Lemma cosh_positive x : 0 < (exp x + exp (- x)) / 2.
Proof. pose proof (exp_pos x). pose proof (exp_pos (- x)). lra. Qed.

Lemma exp_sum a : 2 <= exp a + exp (- a).
Proof.
  pose proof (exp_inverse a) as E. pose proof (exp_pos a). pose proof (exp_pos (- a)).
  generalize dependent (exp a). generalize dependent (exp (- a)). intros m M e E P.
  pose proof (Rle_0_sqr (e - m)) as S. unfold Rsqr in S. apply Rnot_lt_le. intro L.
  assert ((e + m) * (e + m) < 2 * 2) by (apply Rmult_le_0_lt_compat; lra). nra.
Qed.

Ltac exponents := repeat first
  [ rewrite exp_plus | rewrite exp_minus | rewrite exp_opp_plus | rewrite exp_opp_minus
  | rewrite exp_plus_part | rewrite exp_minus_part | rewrite exp_opp_plus_part | rewrite exp_opp_minus_part
  | rewrite exp_opp_opp | rewrite exp_0 | rewrite exp_opp_zero
  | match goal with |- context [exp ?a] => lazymatch a with 0 => fail | _ => idtac end;
      let E := fresh in assert (E : a = 0) by (field || ring); rewrite E; clear E end ].
(* a power of the exponential of b *)
Ltac exponential_by a b := first
  [ replace (exp a) with (exp b) by (f_equal; field)
  | replace (exp a) with (exp (- b)) by (f_equal; field)
  | replace (exp a) with (exp b * exp b) by (rewrite <- exp_plus; f_equal; field)
  | replace (exp a) with (exp (- b) * exp (- b)) by (rewrite <- exp_plus; f_equal; field)
  | replace (exp a) with (exp b * exp b * exp b) by (rewrite <- !exp_plus; f_equal; field)
  | replace (exp a) with (exp (- b) * exp (- b) * exp (- b)) by (rewrite <- !exp_plus; f_equal; field)
  | replace (exp a) with (exp b * exp b * exp b * exp b) by (rewrite <- !exp_plus; f_equal; field)
  | replace (exp a) with (exp (- b) * exp (- b) * exp (- b) * exp (- b)) by (rewrite <- !exp_plus; f_equal; field) ].
(* the exponent b without its sign, or a part of it that occurs *)
Ltac base b k := lazymatch b with
  | - ?c => base c k
  | _ => first
    [ match goal with |- context [exp ?a] => lazymatch a with b => fail | - _ => fail | _ => idtac end;
        first [ assert (b = 2 * a) by field | assert (b = 3 * a) by field | assert (b = 4 * a) by field
              | assert (b = - 2 * a) by field ]; base a k end
    | k b ]
  end.
Ltac exponential b :=
  repeat match goal with
  | |- context [exp ?a] => lazymatch a with b => fail | - b => fail | _ => exponential_by a b end
  end;
  pose proof (exp_inverse b); pose proof (exp_pos b); pose proof (exp_pos (- b)); pose proof (exp_sum b);
  pose proof (exp_least b);
  generalize dependent (exp b); generalize dependent (exp (- b)); intros.
Ltac exponentials ::= lazymatch goal with
  | |- context [exp _] =>
      repeat match goal with H : context [exp _] |- _ => revert H end;
      exponents; repeat match goal with |- context [exp ?a] => base a exponential end; intros; divisors
  | _ => idtac
  end.

(* modulo the relations of sines, cosines, roots and exponentials *)
Ltac relation E := lazymatch type of E with _ ^ 2 = _ => idtac | _ * _ = 1 => idtac end.
Ltac modulo ::= match goal with
  | E : @eq R _ _, F : @eq R _ _, G : @eq R _ _, H : @eq R _ _ |- _ => relation E; relation F; relation G; relation H;
      first [ring [E F G H] | field_simplify_eq; [ring [E F G H]|nonzero..]]
  | E : @eq R _ _, F : @eq R _ _, G : @eq R _ _ |- _ => relation E; relation F; relation G;
      first [ring [E F G] | field_simplify_eq; [ring [E F G]|nonzero..]]
  | E : @eq R _ _, F : @eq R _ _ |- _ => relation E; relation F; first [ring [E F] | field_simplify_eq; [ring [E F]|nonzero..]]
  | E : @eq R _ _ |- _ => relation E; first [ring [E] | field_simplify_eq; [ring [E]|nonzero..]]
  end.
