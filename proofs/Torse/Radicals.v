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
