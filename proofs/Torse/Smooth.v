(* Functions with derivatives of every order: nobody has to read it.
   Curves of bases have them, whatever the degree, so the derivatives of a sum of curves are sums of their derivatives. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations.
From Coq Require Import Lra Lia FunctionalExtensionality.
Open Scope R_scope.

Definition smooth (f : R -> R) : Prop := forall n x, ex_derive_n f n x.

Lemma smooth_ext f g : (forall x, f x = g x) -> smooth f -> smooth g.
Proof. intros E F n x. apply ex_derive_n_ext with f; [exact E|apply F]. Qed.
Lemma smooth_rate f : smooth f -> smooth (Derive f).
Proof.
  intros F n x. destruct n as [|n]; [exact I|]. cbn [ex_derive_n].
  apply ex_derive_ext with (Derive_n f (n + 1)); [|apply (F (S (n + 1)))].
  intro t. symmetry. apply (Derive_n_comp f n 1).
Qed.
(* by its derivative *)
Lemma smooth_by f g : (forall x, is_derive f x (g x)) -> smooth g -> smooth f.
Proof.
  intros D G n x. destruct n as [|[|n]]; [exact I|exists (g x); apply D|]. cbn [ex_derive_n].
  apply ex_derive_ext with (Derive_n g n); [|apply (G (S n))].
  intro t. replace (S n) with (n + 1)%nat by lia.
  rewrite <- (Derive_n_comp f n 1). apply Derive_n_ext. intro y. symmetry. apply is_derive_unique, D.
Qed.
Lemma smooth_const c : smooth (fun _ => c).
Proof. intros n x. apply ex_derive_n_const. Qed.
Lemma smooth_id : smooth (fun x => x).
Proof. apply smooth_by with (fun _ => 1); [intro x; apply @is_derive_id|apply smooth_const]. Qed.
Lemma smooth_plus f g : smooth f -> smooth g -> smooth (fun x => f x + g x).
Proof. intros F G n x. apply ex_derive_n_plus; exists (mkposreal 1 Rlt_0_1); intros; [apply F|apply G]. Qed.
Lemma smooth_opp f : smooth f -> smooth (fun x => - f x).
Proof. intros F n x. apply ex_derive_n_opp, F. Qed.
Lemma smooth_minus f g : smooth f -> smooth g -> smooth (fun x => f x - g x).
Proof. intros F G n x. apply ex_derive_n_minus; exists (mkposreal 1 Rlt_0_1); intros; [apply F|apply G]. Qed.
Lemma smooth_mult f g : smooth f -> smooth g -> smooth (fun x => f x * g x).
Proof.
  intros F G n.
  enough (H : forall f g, smooth f -> smooth g -> forall k, (k <= n)%nat -> forall x, ex_derive_n (fun x => f x * g x) k x)
    by (intro x; apply (H f g F G n), Nat.le_refl).
  clear f g F G. induction n as [|n IH]; intros f g F G k K x.
  - replace k with O by lia. exact I.
  - destruct k as [|k]; [exact I|].
    assert (D : forall t, is_derive (fun x => f x * g x) t (Derive f t * g t + f t * Derive g t)).
    { intro t. apply @is_derive_mult; [apply Derive_correct, (F 1%nat)|apply Derive_correct, (G 1%nat)|intros; apply Rmult_comm]. }
    destruct k as [|k]; [eexists; apply D|]. cbn [ex_derive_n].
    apply ex_derive_ext with (Derive_n (fun x => Derive f x * g x + f x * Derive g x) k).
    + intro t. replace (S k) with (k + 1)%nat by lia.
      rewrite <- (Derive_n_comp _ k 1). apply Derive_n_ext. intro y. symmetry. apply is_derive_unique, D.
    + change (ex_derive_n (fun x => Derive f x * g x + f x * Derive g x) (S k) x).
assert (A : locally x (fun y => forall j : nat, (j <= S k)%nat -> ex_derive_n (fun x => Derive f x * g x) j y)).
      { exists (mkposreal 1 Rlt_0_1). intros y _ j J. apply (IH (Derive f) g); [apply smooth_rate, F|exact G|lia]. }
      assert (B : locally x (fun y => forall j : nat, (j <= S k)%nat -> ex_derive_n (fun x => f x * Derive g x) j y)).
      { exists (mkposreal 1 Rlt_0_1). intros y _ j J. apply (IH f (Derive g)); [exact F|apply smooth_rate, G|lia]. }
      exact (ex_derive_n_plus _ _ (S k) x A B).

Qed.
Lemma smooth_turn h : smooth (fun x => sin (h * x)) /\ smooth (fun x => cos (h * x)).
Proof.
  enough (H : forall n, (forall x, ex_derive_n (fun x => sin (h * x)) n x) /\ (forall x, ex_derive_n (fun x => cos (h * x)) n x))
    by (split; intro n; apply H).
  assert (S : forall t, is_derive (fun x => sin (h * x)) t (h * cos (h * t))) by (intro; auto_derive; [exact I|ring]).
  assert (C : forall t, is_derive (fun x => cos (h * x)) t (- h * sin (h * t))) by (intro; auto_derive; [exact I|ring]).
  induction n as [|n [IS IC]]; [split; intro; exact I|].
  destruct n as [|n]; [split; intro x; [exists (h * cos (h * x)); apply S|exists (- h * sin (h * x)); apply C]|].
  split; intro x; cbn [ex_derive_n].
  - apply ex_derive_ext with (fun t => h * Derive_n (fun x => cos (h * x)) n t).
    + intro t. replace (Datatypes.S n) with (n + 1)%nat by lia. rewrite <- (Derive_n_comp _ n 1), <- Derive_n_scal_l.
      apply Derive_n_ext. intro y. symmetry. apply is_derive_unique, S.
    + apply @ex_derive_scal with (1 := IC x).
  - apply ex_derive_ext with (fun t => - h * Derive_n (fun x => sin (h * x)) n t).
    + intro t. replace (Datatypes.S n) with (n + 1)%nat by lia. rewrite <- (Derive_n_comp _ n 1), <- Derive_n_scal_l.
      apply Derive_n_ext. intro y. symmetry. apply is_derive_unique, C.
    + apply @ex_derive_scal with (1 := IS x).
Qed.
Lemma smooth_pw a b n : smooth a -> smooth b -> forall Q : Z -> R -> R, (forall i, smooth (Q i)) ->
  smooth (fun x => pw (a x) (b x) n (fun i => Q i x)).
Proof.
  intros A B. induction n as [|n IH]; intros Q H; [apply H|]. cbn [pw].
  apply smooth_plus; apply smooth_mult; try assumption; [apply (IH Q H)|apply (IH (fun i => Q (i + 1)%Z)); intro; apply H].
Qed.
Ltac smooths := cbv beta; lazymatch goal with
  | |- smooth (fun _ => ?c) => apply smooth_const
  | |- smooth (fun x => x) => apply smooth_id
  | |- smooth (fun x => @?f x + @?g x) => apply (smooth_plus f g); smooths
  | |- smooth (fun x => @?f x - @?g x) => apply (smooth_minus f g); smooths
  | |- smooth (fun x => @?f x * @?g x) => apply (smooth_mult f g); smooths
  | |- smooth (fun x => - @?f x) => apply (smooth_opp f); smooths
  | |- smooth (fun x => sin (?h * x)) => exact (proj1 (smooth_turn h))
  | |- smooth (fun x => cos (?h * x)) => exact (proj2 (smooth_turn h))
  | |- smooth (fun x => ?f x) => try assumption
  | |- _ => idtac
  end.
Lemma smooth_series s t u k P : (2 <= k)%Z -> smooth s -> smooth t -> smooth u ->
  smooth (fun x => sum 0 k (fun i => basis (1 - x) x [s x; t x; u x] i k * P i)).
Proof.
  intros K S T U.
  apply smooth_ext with (fun x => pw (1 - x) x (Z.to_nat (k - 2)) (seed3 (s x) (t x) (u x) P)).
  - intro x. symmetry. apply series3, K.
  - apply (smooth_pw (fun x => 1 - x) (fun x => x) _ ltac:(smooths) ltac:(smooths) (fun i x => seed3 (s x) (t x) (u x) P i)).
    intro i. unfold seed3. smooths.
Qed.

(* ---- derivatives of sums ---- *)
Section Sums.
Variables (f g : R -> R) (n : nat) (p c : R).
Hypotheses (F : smooth f) (G : smooth g).
Let near (h : R -> R) (H : smooth h) : locally p (fun y => forall k : nat, (k <= n)%nat -> ex_derive_n h k y).
Proof. exists (mkposreal 1 Rlt_0_1). intros. apply H. Qed.
Lemma rate_plus : Derive_n (fun x => f x + g x) n p = Derive_n f n p + Derive_n g n p.
Proof. apply Derive_n_plus; apply near; assumption. Qed.
Lemma rate_minus : Derive_n (fun x => f x - g x) n p = Derive_n f n p - Derive_n g n p.
Proof. apply Derive_n_minus; apply near; assumption. Qed.
End Sums.
Lemma rate_opp f n p : Derive_n (fun x => - f x) n p = - Derive_n f n p.
Proof. apply Derive_n_opp. Qed.
Lemma rate_left c f n p : Derive_n (fun x => c * f x) n p = c * Derive_n f n p.
Proof. apply Derive_n_scal_l. Qed.
Lemma rate_right c f n p : Derive_n (fun x => f x * c) n p = Derive_n f n p * c.
Proof. apply Derive_n_scal_r. Qed.
Lemma rate_over c f n p : Derive_n (fun x => f x / c) n p = Derive_n f n p / c.
Proof. apply Derive_n_scal_r. Qed.
Lemma rate_const c n p : Derive_n (fun _ => c) (S n) p = 0.
Proof. apply Derive_n_const. Qed.
(* which functions they are: those with a curve of a symbolic degree in them *)
Ltac smooth_curves := smooths; try (apply smooth_series; [assumption || lia | smooths ..]).
(* the equation of a derivative, in the form in which it stands in the goal *)
Ltac by_rate L := let E := fresh in pose proof L as E; cbv beta in E; rewrite E; clear E.
Ltac both_smooth u v L n p :=
  let F := fresh in let G := fresh in
  assert (F : smooth u) by smooth_curves; assert (G : smooth v) by smooth_curves;
  by_rate (L u v n p F G); clear F G.
Ltac spread_derivatives := orders; repeat match goal with
  | |- context [Derive_n ?f 0 ?p] => change (Derive_n f 0 p) with (f p); cbv beta
  | |- context [Derive_n (fun _ => ?c) (S ?n) ?p] => rewrite (rate_const c n p)
  | |- context [Derive_n ?f ?n ?p] =>
      match f with context [basis] => idtac end;
      lazymatch f with
      | fun x => @?u x + @?v x => both_smooth u v rate_plus n p
      | fun x => @?u x - @?v x => both_smooth u v rate_minus n p
      | fun x => - @?u x => by_rate (rate_opp u n p)
      | fun x => ?c * @?u x => by_rate (rate_left c u n p)
      | fun x => @?u x * ?c => by_rate (rate_right c u n p)
      | fun x => @?u x / ?c => by_rate (rate_over c u n p)
      end
  end.

(* points of ruled surfaces, along a directrix whose velocity is known *)
Lemma rate_along f c c1 r r1 : ex_derive f 0 ->
  Derive_n (fun t => c + 1 * t * c1 + f t * (r + 1 * t * r1)) 1 0 = c1 + Derive f 0 * r + f 0 * r1.
Proof.
  intro F. cbn [Derive_n]. apply is_derive_unique. auto_derive; [repeat split; exact F|].
  change (fun x : R => f x) with f. ring.
Qed.
Lemma mixed_rate a b c d v :
  Derive_n (fun s => Derive_n (fun t => a + 1 * t * b + (v + s) * (c + 1 * t * d)) 1 0) 1 0 = d.
Proof.
  cbn [Derive_n].
  rewrite (Derive_ext _ (fun s => b + (v + s) * d)) by (intro s; apply is_derive_unique; auto_derive; [exact I | ring]).
  apply is_derive_unique. auto_derive; [exact I | ring].
Qed.
