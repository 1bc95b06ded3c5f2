(* Roots of formulas, and statements with connectives: nobody has to read it.
   A root is a number that is not negative and whose square is the radicand. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* sums of squares are not negative *)
Ltac sign := first [ assumption | lra | nra ].
Ltac radical r := let E := fresh "square" in let P := fresh "size" in let w := fresh "w" in
  assert (E : sqrt r * sqrt r = r) by (apply sqrt_sqrt; sign);
  pose proof (sqrt_pos r) as P; generalize dependent (sqrt r); intros w; intros.
Ltac radicals := repeat match goal with
  | |- context [sqrt ?r] => radical r
  | _ : context [sqrt ?r] |- _ => radical r
  end.
(* equal if their squares are and both are not negative *)
Lemma same_square a b : 0 <= a -> 0 <= b -> a * a = b * b -> a = b.
Proof. intros; nra. Qed.
Lemma less_square a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros; nra. Qed.
Lemma below_square a b : 0 <= b -> a * a < b * b -> a < b.
Proof. intros; nra. Qed.

(* ---- lengths in space ---- *)
Ltac squares := repeat apply Rplus_le_le_0_compat; first [apply Rle_0_sqr | lra].
Lemma unit_root a b c : sqrt (a * a + (b * b + (c * c + 0))) <> 0 ->
  sqrt (a / sqrt (a * a + (b * b + (c * c + 0))) * (a / sqrt (a * a + (b * b + (c * c + 0)))) +
    (b / sqrt (a * a + (b * b + (c * c + 0))) * (b / sqrt (a * a + (b * b + (c * c + 0)))) +
    (c / sqrt (a * a + (b * b + (c * c + 0))) * (c / sqrt (a * a + (b * b + (c * c + 0)))) + 0))) = 1.
Proof.
  assert (E : sqrt (a * a + (b * b + (c * c + 0))) * sqrt (a * a + (b * b + (c * c + 0))) = a * a + (b * b + (c * c + 0)))
    by (apply sqrt_sqrt; squares).
  revert E. generalize (sqrt (a * a + (b * b + (c * c + 0)))). intros w E N.
  replace (a / w * (a / w) + (b / w * (b / w) + (c / w * (c / w) + 0)))
    with ((a * a + (b * b + (c * c + 0))) / (w * w)) by (field; exact N).
  rewrite <- E. replace (w * w / (w * w)) with 1 by (field; exact N). apply sqrt_1.
Qed.
Lemma triangle a b c d e f :
  sqrt ((a + d) * (a + d) + ((b + e) * (b + e) + ((c + f) * (c + f) + 0))) <=
  sqrt (a * a + (b * b + (c * c + 0))) + sqrt (d * d + (e * e + (f * f + 0))).
Proof.
  assert (E : sqrt (a * a + (b * b + (c * c + 0))) * sqrt (a * a + (b * b + (c * c + 0))) = a * a + (b * b + (c * c + 0)))
    by (apply sqrt_sqrt; squares).
  assert (F : sqrt (d * d + (e * e + (f * f + 0))) * sqrt (d * d + (e * e + (f * f + 0))) = d * d + (e * e + (f * f + 0)))
    by (apply sqrt_sqrt; squares).
  assert (P := sqrt_pos (a * a + (b * b + (c * c + 0)))). assert (Q := sqrt_pos (d * d + (e * e + (f * f + 0)))).
  apply less_square; [lra|]. rewrite sqrt_sqrt by squares. revert E F P Q.
  generalize (sqrt (a * a + (b * b + (c * c + 0)))) (sqrt (d * d + (e * e + (f * f + 0)))). intros v w E F P Q.
  assert (C : a * d + b * e + c * f <= v * w).
  { apply less_square; [nra|]. replace (v * w * (v * w)) with ((v * v) * (w * w)) by ring. rewrite E, F.
    pose proof (pow2_ge_0 (a * e - b * d)). pose proof (pow2_ge_0 (a * f - c * d)). pose proof (pow2_ge_0 (b * f - c * e)).
    lra. }
  lra.
Qed.
