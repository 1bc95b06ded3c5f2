(* Joins of curves of blended trigonometric functions as their members change, for every degree: nobody has to read it. Equal
   ends say what the first members of the second curve are, one by one, so they move along lines when a member of the first
   curve moves, and the coefficients of that member are the slopes. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Smooth Ends.
From Coq Require Import Lra Lia.
Open Scope R_scope.

Local Notation curve P k mu nu x := (sum 0 k (fun i => basis (1 - x) x
  [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x));
   1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x));
   (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k * P i)) (only parsing).

Lemma updated_member P i t : update1 P i t i = t.
Proof. unfold update1. rewrite Z.eqb_refl. reflexivity. Qed.
Lemma other_member P i t j : j <> i -> update1 P i t j = P j.
Proof. intro N. unfold update1. rewrite (proj2 (Z.eqb_neq j i) N). reflexivity. Qed.
Ltac updated_in H := repeat first [ rewrite updated_member in H | rewrite other_member in H by lia ].
Ltac updated := repeat first [ rewrite updated_member | rewrite other_member by lia ].

Lemma slope_of_line f g x d : (forall t, f t = g t) -> (forall t, g t = g 0 + d * t) -> Derive_n f 1 x = d.
Proof.
  intros E L. rewrite (Derive_n_ext _ (fun t => g 0 + d * t)) by (intro t; rewrite E; apply L).
  cbn [Derive_n]. apply is_derive_unique. auto_derive; [exact I | ring].
Qed.

Section Joins.
Variables (P Q : Z -> R) (n m : Z) (mu1 nu1 mu nu : R).
Hypotheses (N : (2 <= n)%Z) (M : (2 <= m)%Z).
Hypothesis values : curve P n mu1 nu1 0 = curve Q m mu nu 1.
Lemma first_joined : P 0%Z = Q m.
Proof. rewrite <- (start_value P n mu1 nu1 N), <- (end_value Q m mu nu M). exact values. Qed.
Hypothesis rates : Derive_n (fun x => curve P n mu1 nu1 x) 1 0 = Derive_n (fun x => curve Q m mu nu x) 1 1.
Lemma second_joined :
  (2 * (IZR n - 2) + PI * (1 + mu1)) * (P 1%Z - Q m) = (2 * (IZR m - 2) + PI * (1 + nu)) * (Q m - Q (m - 1)%Z).
Proof.
  pose proof rates as E. rewrite (start_rate P n mu1 nu1 N), (end_rate Q m mu nu M), first_joined in E.
  match type of E with ?a = ?b => transitivity (2 * a); [field | rewrite E; field] end.
Qed.
Lemma second_joined_alone : 2 * (IZR n - 2) + PI * (1 + mu1) <> 0 ->
  P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z).
Proof.
  intro D. apply (Rmult_eq_reg_l (2 * (IZR n - 2) + PI * (1 + mu1))); [|exact D]. transitivity ((2 * (IZR n - 2) + PI * (1 + mu1)) * Q m +
    (2 * (IZR n - 2) + PI * (1 + mu1)) * (P 1%Z - Q m)); [ring|]. rewrite second_joined. field. exact D.
Qed.
Hypothesis seconds : Derive_n (fun x => curve P n mu1 nu1 x) 2 0 = Derive_n (fun x => curve Q m mu nu x) 2 1.
Lemma third_joined :
  (4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1)) * (P 2%Z - Q m) =
  (8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 * mu1 - nu1)) * (P 1%Z - Q m)
  + 4 * (IZR m - 2) * (IZR m - 3 + PI * (1 + nu)) * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z)
  + 2 * PI ^ 2 * nu * (Q m - Q (m - 1)%Z) - PI ^ 2 * (1 - mu) * (Q (m - 1)%Z - Q (m - 2)%Z).
Proof.
  pose proof seconds as E. rewrite (start_second P n mu1 nu1 N), (end_second Q m mu nu M), first_joined in E.
  match type of E with ?a = ?b => transitivity ((8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) +
    PI ^ 2 * (1 + 2 * mu1 - nu1)) * (P 1%Z - Q m) + 4 * a); [field | rewrite E; field] end.
Qed.
Hypothesis thirds : Derive_n (fun x => curve P n mu1 nu1 x) 3 0 = Derive_n (fun x => curve Q m mu nu x) 3 1.
Lemma fourth_joined :
  let c := 4 * (IZR n - 2) * (IZR n - 3) * (2 * (IZR n - 4) + 3 * PI * (1 + mu1)) in
  let d := 6 * (IZR n - 2) * PI ^ 2 in
  (c + d * (1 - nu1)) * (P 3%Z - Q m) =
  (3 * c + 2 * d * (1 + mu1 - nu1)) * (P 2%Z - Q m)
  - (3 * c + d * (1 + 4 * mu1 - nu1) - PI ^ 3 * (1 + mu1)) * (P 1%Z - Q m)
  + 4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3 * PI * (1 + nu)) * (Q m - 3 * Q (m - 1)%Z + 3 * Q (m - 2)%Z - Q (m - 3)%Z)
  - 6 * (IZR m - 2) * PI ^ 2 * ((1 - mu) * (Q (m - 1)%Z - 2 * Q (m - 2)%Z + Q (m - 3)%Z)
    - 2 * nu * (Q m - 2 * Q (m - 1)%Z + Q (m - 2)%Z))
  - PI ^ 3 * (1 + nu) * (Q m - Q (m - 1)%Z).
Proof.
  cbv zeta. pose proof thirds as E. rewrite (start_third P n mu1 nu1 N), (end_third Q m mu nu M), first_joined in E.
  match type of E with ?a = ?b => match goal with |- _ = ?r =>
    transitivity (r + 8 * (a - b)); [field | rewrite E; field] end end.
Qed.
End Joins.
(* premises at numbers: ranges, and equations of a join whose members are given *)
Ltac premise_of_join := first
  [ lia | intros; lia | lra | numeric
  | intros; ends_of_sums; compute_goal; first [ numeric | field ] ].
(* a statement without its premises *)
Ltac without_premises no := repeat match type of no with ?A -> _ =>
  let H := fresh in assert (H : A) by premise_of_join; specialize (no H); clear H end.
