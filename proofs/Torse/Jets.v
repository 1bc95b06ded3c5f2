(* Statements about functions, from those about their values and the values of their derivatives at a place: nothing here has to
   be read. What is proved is taken at the numbers f u, f' u, ..., and what is refuted at polynomials with these numbers; then all
   derivatives are computed on both sides, and both say the same of the same numbers. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Smooth.
Open Scope R_scope.

(* the mark of what is used *)
Definition used (P : Prop) : Prop := P.

Ltac bare t := eval cbv -[Rplus Rminus Rmult Rdiv Rinv Ropp IZR PI sin cos exp sqrt pow Derive_n ex_derive_n locally smooth
  Rlt Rle Rgt Rge not used] in t.
Ltac bare_goal := match goal with |- ?g => let h := bare g in change h end.
Ltac bare_in H := let T := type of H in let U := bare T in change U in H.

Lemma applied {A B : Type} (f g : A -> B) (x y : A) : f = g -> x = y -> f x = g y.
Proof. intros -> ->. reflexivity. Qed.
(* both are the same but for the form of numbers *)
Ltac same := lazymatch goal with
  | |- ?x = ?x => reflexivity
  | |- @eq R _ _ => first [ ring | apply applied; same | field; nonzero ]
  | |- _ = _ => apply applied; same
  end.
Ltac by_same := match goal with K : ?T |- ?A => refine (@eq_rect Prop T (fun P => P) K A _); solve [same] end.

Ltac smoothness H := repeat lazymatch type of H with
  | smooth ?f -> _ => let F := fresh in assert (F : smooth f) by smooths; specialize (H F); clear F end.
Ltac eta H := repeat match goal with F : smooth ?f |- _ => progress change (fun x : R => f x) with f in H end.
Ltac apart_in P := lazymatch type of P with
  | locally _ _ => apply locally_singleton in P; cbv beta in P
  | _ /\ _ => let Q := fresh "Q" in destruct P as [P Q]; apart_in P; apart_in Q
  | _ => idtac end.
Ltac introduced := lazymatch goal with
  | |- smooth ?f -> _ => let F := fresh "F" in intro F; try change (fun x : R => f x) with f; introduced
  | |- ?A -> ?B => let P := fresh "P" in intro P; apart_in P; introduced
  | _ => idtac end.
(* what has derivatives that are to be computed *)
Ltac with_rates := repeat match goal with P : ?T |- _ =>
  match T with context [Derive_n ?g _ _] => tryif is_var g then fail else revert P end end.
Lemma near_ext (f g : R -> R) p : (forall x, f x = g x) -> locally p (fun x => g x <> 0) -> locally p (fun x => f x <> 0).
Proof. intros E. apply filter_imp. intros x N. rewrite E. exact N. Qed.
Ltac near_place :=
  try (eapply near_ext; [let x := fresh "x" in intro x; progress (repeat derivative); reflexivity|]; cbv beta);
  match goal with
  | |- locally ?p (fun x => @?f x <> 0) => let e := reify f in
      apply (near_nonzero f e p); [reified | cbv beta iota delta [ok ev dn]; repeat split; first [assumption | nonzero] | cbv beta iota delta [ev dn]]
  end.
Ltac premise := first [ assumption | by_same | near_place; first [ by_same | nonzero ] | nonzero | lra ].
Ltac concluded := match goal with H : used ?T |- _ => change T in H;
  repeat lazymatch type of H with ?A -> _ => let K := fresh in assert (K : A) by premise; specialize (H K); clear K end end;
  repeat match goal with |- _ /\ _ => split end; premise.
Ltac compared H := bare_in H; smoothness H; eta H;
  let T := type of H in change (used T) in H; with_rates; derivatives; intros.
(* the goal, from what is proved at the numbers of its functions *)
Ltac by_jets proved := bare_goal; introduced; let H := fresh "H" in pose proof proved as H; compared H; concluded.
(* the goal, that something is there, from what is there *)
Ltac there_by_jets H := cbv zeta; repeat (split; [ solve [smooths] |]); bare_goal; bare_in H; apart_in H; with_rates; derivatives; intros;
  repeat match goal with |- _ /\ _ => split end; premise.
(* that functions are smooth *)
Ltac met_by_jets := cbv zeta; repeat split; solve [smooths].
(* the goal with all derivatives computed, without what is proved *)
Ltac computed_by_jets := bare_goal; introduced; with_rates; derivatives; intros.
(* premises at values *)
Ltac values_by_jets := cbv zeta; repeat (split; [ solve [smooths] |]); bare_goal; derivatives;
  repeat match goal with |- _ /\ _ => split end; lra.
