(* Statements about functions, from those about their values and the values of their derivatives at a place: nothing here has to
   be read. What is proved is taken at the numbers f u, f' u, ..., and what is refuted at polynomials with these numbers; then all
   derivatives are computed on both sides, and both say the same of the same numbers. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Smooth Functions.
Open Scope R_scope.

(* ---- derivatives of formulas in which functions occur: like those of Theory.v, without series ---- *)
Inductive jet :=
  | Zero | One | Const (r : R) | Var | Plus (e f : jet) | Opp (e : jet) | Times (e f : jet) | Inv (e : jet) | Pow (e : jet) (n : nat)
  | Sin (e : jet) | Cos (e : jet) | Exp (e : jet) | Func (f : R -> R) (j : nat) (e : jet).
(* a derivative of a declared function *)
Definition nth_rate (f : R -> R) (j : nat) (x : R) : R := match j with O => f x | _ => Derive_n f j x end.
Fixpoint worth (e : jet) (x : R) : R := match e with
  | Zero => 0 | One => 1 | Const r => r | Var => x | Plus e f => worth e x + worth f x | Opp e => - worth e x
  | Times e f => worth e x * worth f x | Inv e => / worth e x | Pow e n => worth e x ^ n
  | Sin e => sin (worth e x) | Cos e => cos (worth e x) | Exp e => exp (worth e x)
  | Func f j e => nth_rate f j (worth e x) end.
Definition plus (e f : jet) : jet := match e, f with Zero, f => f | e, Zero => e | e, f => Plus e f end.
Definition opp (e : jet) : jet := match e with Zero => Zero | e => Opp e end.
Definition times (e f : jet) : jet := match e, f with
  | Zero, _ | _, Zero => Zero | One, f => f | e, One => e | e, f => Times e f end.
Fixpoint rate (e : jet) : jet := match e with
  | Zero | One | Const _ => Zero | Var => One | Plus e f => plus (rate e) (rate f) | Opp e => opp (rate e)
  | Times e f => plus (times (rate e) f) (times e (rate f))
  | Inv e => opp (times (rate e) (Inv (Times e e)))
  | Pow e n => match n with O => Zero | S n => times (Const (IZR (Z.of_nat (S n)))) (times (rate e) (Pow e n)) end
  | Sin e => times (rate e) (Cos e) | Cos e => opp (times (rate e) (Sin e)) | Exp e => times (rate e) (Exp e)
  | Func f j e => times (rate e) (Func f (S j) e) end.
(* no divisor is zero, and functions are smooth *)
Fixpoint fine (e : jet) (x : R) : Prop := match e with
  | Zero | One | Const _ | Var => True | Plus e f | Times e f => fine e x /\ fine f x
  | Opp e | Pow e _ | Sin e | Cos e | Exp e => fine e x
  | Inv e => fine e x /\ worth e x <> 0 | Func f _ e => smooth f /\ fine e x end.
Lemma worth_plus e f x : worth (plus e f) x = worth e x + worth f x.
Proof. destruct e, f; simpl; ring. Qed.
Lemma worth_opp e x : worth (opp e) x = - worth e x.
Proof. destruct e; simpl; ring. Qed.
Lemma worth_times e f x : worth (times e f) x = worth e x * worth f x.
Proof. destruct e, f; simpl; ring. Qed.
Lemma fine_plus e f x : fine e x -> fine f x -> fine (plus e f) x.
Proof. destruct e, f; simpl; tauto. Qed.
Lemma fine_opp e x : fine e x -> fine (opp e) x.
Proof. destruct e; simpl; tauto. Qed.
Lemma fine_times e f x : fine e x -> fine f x -> fine (times e f) x.
Proof. destruct e, f; simpl; tauto. Qed.
Ltac worths := rewrite ?worth_plus, ?worth_opp, ?worth_times; cbn [worth]; rewrite ?worth_plus, ?worth_opp, ?worth_times; cbn [worth].
Lemma rated e x : fine e x -> is_derive (worth e) x (worth (rate e) x).
Proof.
  induction e as [| |r| |e He f Hf|e He|e He f Hf|e He|e He n|e He|e He|e He|f j e He]; intro H; cbn [rate fine] in *.
  1-3: apply @is_derive_const.
  - apply @is_derive_id.
  - rewrite worth_plus. apply (dplus (worth e) (worth f)); tauto.
  - rewrite worth_opp. apply @is_derive_opp. auto.
  - worths. apply (dmult (worth e) (worth f)); tauto.
  - destruct H as [H N]. eapply deq; [apply (is_derive_inv (worth e) x _ (He H) N)|worths; field; exact N].
  - destruct n as [|n]; [apply @is_derive_const|].
    eapply deq; [apply (is_derive_pow (worth e) (S n) x _ (He H))|]. worths. cbn [Nat.pred]. rewrite <- INR_IZR_INZ. ring.
  - worths. apply (dcomp sin (worth e)); [apply is_derive_sin|auto].
  - eapply deq; [apply (dcomp cos (worth e)); [apply is_derive_cos|apply He, H]|worths; ring].
  - worths. apply (dcomp exp (worth e)); [apply is_derive_exp|auto].
  - destruct H as [F H]. worths. apply (dcomp (nth_rate f j) (worth e)); [|apply He, H].
    apply is_derive_ext with (Derive_n f j); [intro t; destruct j; reflexivity|].
    apply (Derive_correct (Derive_n f j)), (F (S j)).
Qed.
Lemma fine_rate e x : fine e x -> fine (rate e) x.
Proof.
  induction e as [| |r| |e He f Hf|e He|e He f Hf|e He|e He n|e He|e He|e He|f j e He]; intro H; cbn [rate fine] in *; auto;
    try solve [repeat first [apply fine_plus | apply fine_opp | apply fine_times]; cbn [fine]; tauto].
  - apply fine_opp, fine_times; [tauto|]. cbn [fine worth]. repeat split; try tauto. apply Rmult_integral_contrapositive; tauto.
  - destruct n; [exact I|]. apply fine_times; [exact I|]. apply fine_times; [auto|exact H].
Qed.
Lemma fine_near e x : fine e x -> locally x (fine e).
Proof.
  induction e as [| |r| |e He f Hf|e He|e He f Hf|e He|e He n|e He|e He|e He|f j e He]; intro H; cbn [fine] in *; auto;
    try (apply filter_forall; intro; exact I); try (apply filter_and; tauto).
  - destruct H as [H N]. apply filter_and; [auto|].
    assert (C : continuous (worth e) x) by (apply @ex_derive_continuous; eexists; apply rated, H).
    apply (C (fun y => y <> 0)). destruct (Rdichotomy _ _ N) as [L|L].
    + apply (filter_imp (fun y => y < 0)); [intros; lra|]. apply (open_lt 0), L.
    + apply (filter_imp (fun y => 0 < y)); [intros; lra|]. apply (open_gt 0), L.
  - destruct H as [F H]. apply filter_and; [apply filter_forall; intro; exact F|auto].
Qed.
Fixpoint rates (n : nat) (e : jet) : jet := match n with O => e | S n => rate (rates n e) end.
Lemma rates_worth n : forall e x, fine e x -> Derive_n (worth e) n x = worth (rates n e) x /\ fine (rates n e) x.
Proof.
  induction n as [|n IH]; intros e x H; [split; [reflexivity|exact H]|]. cbn [rates].
  destruct (IH e x H) as [_ F]. split; [|apply fine_rate, F].
  cbn [Derive_n]. apply is_derive_unique. apply is_derive_ext_loc with (worth (rates n e)); [|apply rated, F].
  apply (filter_imp (fine e)); [intros y Y; symmetry; apply IH, Y|apply fine_near, H].
Qed.
Lemma rate_as f e n x : (forall t, f t = worth e t) -> fine e x -> Derive_n f n x = worth (rates n e) x.
Proof. intros E H. rewrite (Derive_n_ext f (worth e) n x E). apply rates_worth, H. Qed.
Lemma near_fine f e x : (forall t, f t = worth e t) -> fine e x -> worth e x <> 0 -> locally x (fun t => f t <> 0).
Proof.
  intros E H N. apply (filter_imp (fine (Inv e))); [intros t [_ T]; rewrite E; exact T|].
  apply fine_near. split; assumption.
Qed.
Ltac read f := lazymatch f with
  | (fun x => x) => constr:(Var)
  | (fun _ => ?r) => constr:(Const r)
  | (fun x => @?a x + @?b x) => let a := read a in let b := read b in constr:(Plus a b)
  | (fun x => @?a x - @?b x) => let a := read a in let b := read b in constr:(Plus a (Opp b))
  | (fun x => @?a x * @?b x) => let a := read a in let b := read b in constr:(Times a b)
  | (fun x => @?a x / @?b x) => let a := read a in let b := read b in constr:(Times a (Inv b))
  | (fun x => - @?a x) => let a := read a in constr:(Opp a)
  | (fun x => / @?a x) => let a := read a in constr:(Inv a)
  | (fun x => @?a x ^ ?n) => let a := read a in constr:(Pow a n)
  | (fun x => sin (@?a x)) => let a := read a in constr:(Sin a)
  | (fun x => cos (@?a x)) => let a := read a in constr:(Cos a)
  | (fun x => exp (@?a x)) => let a := read a in constr:(Exp a)
  | (fun x => Derive_n ?f ?n (@?a x)) => let _ := match goal with _ => is_var f end in let a := read a in constr:(Func f n a)
  | (fun x => ?f (@?a x)) => let _ := match goal with _ => is_var f end in let a := read a in constr:(Func f O a)
  end.
Ltac finely := cbv beta iota delta [fine worth nth_rate]; repeat split; first [ assumption | nonzero ].
Ltac derived := match goal with
  | |- context [Derive_n ?f ?n ?p] =>
      tryif is_var f then fail else idtac;
      let e := read f in
      let v := eval cbv beta iota zeta delta
        [worth nth_rate rates rate plus opp times Z.of_nat Pos.of_succ_nat Pos.succ] in (worth (rates n e) p) in
      replace (Derive_n f n p) with v by (symmetry; apply (rate_as f e n p); [intro; reflexivity | finely])
  | |- context [Derive_n ?f ?n ?p] =>
      tryif is_var f then fail else idtac;
      erewrite (Derive_n_ext f _ n p); [|let y := fresh "y" in intro y; repeat derived; reflexivity]
  end.
Ltac all_derived := repeat derived; cbv beta.

(* what Smooth.v shows of the same property *)
Ltac made_smooth := lazymatch goal with |- smooth ?f => change (Torse.Smooth.smooth f) end; solve [smooths].

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
  | smooth ?f -> _ => let F := fresh in assert (F : smooth f) by made_smooth; specialize (H F); clear F end.
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
  try (eapply near_ext; [let x := fresh "x" in intro x; progress (repeat derived); reflexivity|]; cbv beta);
  match goal with
  | |- locally ?p (fun x => @?f x <> 0) => let e := read f in
      apply (near_fine f e p); [intro; reflexivity | finely | cbv beta iota delta [worth nth_rate]]
  end.
Ltac premise := first [ assumption | by_same | near_place; first [ by_same | nonzero ] | nonzero | lra ].
Ltac concluded := match goal with H : used ?T |- _ => change T in H;
  repeat lazymatch type of H with ?A -> _ => let K := fresh in assert (K : A) by premise; specialize (H K); clear K end end;
  repeat match goal with |- _ /\ _ => split end; premise.
Ltac compared H := bare_in H; smoothness H; eta H;
  let T := type of H in change (used T) in H; with_rates; all_derived; intros.
(* the goal, from what is proved at the numbers of its functions *)
Ltac by_jets proved := bare_goal; introduced; let H := fresh "H" in pose proof proved as H; compared H; concluded.
(* the goal, that something is there, from what is there *)
Ltac there_by_jets H := cbv zeta; repeat (split; [ made_smooth |]); bare_goal; bare_in H; apart_in H; with_rates; all_derived; intros;
  repeat match goal with |- _ /\ _ => split end; premise.
(* that functions are smooth *)
Ltac met_by_jets := cbv zeta; repeat (split; [ made_smooth |]); made_smooth.
(* the goal with all derivatives computed, without what is proved *)
Ltac computed_by_jets := bare_goal; introduced; with_rates; all_derived; intros.
(* premises at values *)
Ltac values_by_jets := cbv zeta; repeat (split; [ made_smooth |]); bare_goal; all_derived;
  repeat match goal with |- _ /\ _ => split end; lra.
