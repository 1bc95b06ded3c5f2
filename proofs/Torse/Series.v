(* Curves of symbolic degree: sum of basis functions times control values is ((a + b E)^n seeds) P, with E the shift of the
   index. Proved once, by hand: nobody has to read it. *)
From Torse Require Import Defs.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- sums over integers ---- *)
Lemma range_empty lo hi : (hi < lo)%Z -> range lo hi = [].
Proof. intro H. unfold range. replace (Z.to_nat (hi - lo + 1)) with O by lia. reflexivity. Qed.
Lemma range_first lo hi : (lo <= hi)%Z -> range lo hi = lo :: range (lo + 1) hi.
Proof.
  intro H. unfold range. replace (Z.to_nat (hi - lo + 1)) with (S (Z.to_nat (hi - (lo + 1) + 1))) by lia.
  cbn [seq map]. f_equal; [lia|]. rewrite <- seq_shift, map_map. apply map_ext. intro. lia.
Qed.
Lemma range_last lo hi : (lo <= hi)%Z -> range lo hi = range lo (hi - 1) ++ [hi].
Proof.
  intro H. unfold range. replace (Z.to_nat (hi - lo + 1)) with (Z.to_nat (hi - 1 - lo + 1) + 1)%nat by lia.
  rewrite seq_app, map_app. f_equal. cbn. f_equal. lia.
Qed.
Lemma range_shift lo hi c : range (lo + c) (hi + c) = map (fun i => (i + c)%Z) (range lo hi).
Proof.
  unfold range. replace (hi + c - (lo + c) + 1)%Z with (hi - lo + 1)%Z by lia.
  rewrite map_map. apply map_ext. intro. lia.
Qed.
Lemma range_in lo hi i : In i (range lo hi) -> (lo <= i <= hi)%Z.
Proof. unfold range. intro H. apply in_map_iff in H as [j [<- H]]. apply in_seq in H. lia. Qed.
Lemma sum_empty lo hi f : (hi < lo)%Z -> sum lo hi f = 0.
Proof. intro H. unfold sum. rewrite range_empty by exact H. reflexivity. Qed.
Lemma sum_first lo hi f : (lo <= hi)%Z -> sum lo hi f = f lo + sum (lo + 1) hi f.
Proof. intro H. unfold sum. rewrite range_first by exact H. reflexivity. Qed.
Lemma fold_app (l m : list R) : fold_right Rplus 0 (l ++ m) = fold_right Rplus 0 l + fold_right Rplus 0 m.
Proof. induction l; cbn; [ring|]. rewrite IHl. ring. Qed.
Lemma sum_last lo hi f : (lo <= hi)%Z -> sum lo hi f = sum lo (hi - 1) f + f hi.
Proof. intro H. unfold sum. rewrite range_last, map_app, fold_app by exact H. cbn. ring. Qed.
Lemma sum_shift lo hi c f : sum (lo + c) (hi + c) f = sum lo hi (fun i => f (i + c)%Z).
Proof. unfold sum. rewrite range_shift, map_map. reflexivity. Qed.
Lemma sum_ext lo hi f g : (forall i, (lo <= i <= hi)%Z -> f i = g i) -> sum lo hi f = sum lo hi g.
Proof.
  intro H. unfold sum. f_equal. apply map_ext_in. intros i Hi. apply H, range_in, Hi.
Qed.
Lemma sum_plus lo hi f g : sum lo hi (fun i => f i + g i) = sum lo hi f + sum lo hi g.
Proof. unfold sum. induction (range lo hi); cbn; [ring|]. rewrite IHl. ring. Qed.
Lemma sum_scal lo hi c f : sum lo hi (fun i => c * f i) = c * sum lo hi f.
Proof. unfold sum. induction (range lo hi); cbn; [ring|]. rewrite IHl. ring. Qed.
Lemma sum_swap lo hi lo' hi' f :
  sum lo hi (fun i => sum lo' hi' (fun j => f i j)) = sum lo' hi' (fun j => sum lo hi (fun i => f i j)).
Proof.
  unfold sum at 1 4. induction (range lo hi) as [|i l IH]; cbn.
  - unfold sum. induction (range lo' hi'); cbn; [reflexivity|]. rewrite <- IHl. ring.
  - rewrite IH. symmetry. apply (sum_plus lo' hi' (f i) (fun j => fold_right Rplus 0 (map (fun i => f i j) l))).
Qed.

(* ---- the operator ---- *)
Fixpoint pw (a b : R) (n : nat) (Q : Z -> R) : R :=
  match n with O => Q 0%Z | S n => a * pw a b n Q + b * pw a b n (fun i => Q (i + 1)%Z) end.
Lemma pw_ext a b n : forall Q Q', (forall i, Q i = Q' i) -> pw a b n Q = pw a b n Q'.
Proof.
  induction n as [|n IH]; intros Q Q' H; cbn; [apply H|].
  f_equal; f_equal; apply IH; intro; apply H.
Qed.
Lemma pw_plus a b n : forall Q Q', pw a b n (fun i => Q i + Q' i) = pw a b n Q + pw a b n Q'.
Proof. induction n as [|n IH]; intros; cbn; [ring|]. rewrite !IH. ring. Qed.
Lemma pw_minus a b n : forall Q Q', pw a b n (fun i => Q i - Q' i) = pw a b n Q - pw a b n Q'.
Proof. induction n as [|n IH]; intros; cbn; [ring|]. rewrite !IH. ring. Qed.
Lemma pw_scal a b n c : forall Q, pw a b n (fun i => c * Q i) = c * pw a b n Q.
Proof. induction n as [|n IH]; intros; cbn; [ring|]. rewrite !IH. ring. Qed.
Lemma pw_const a b n : a + b = 1 -> forall c Q, (forall i, Q i = c) -> pw a b n Q = c.
Proof.
  intros H; induction n as [|n IH]; intros c Q HQ; cbn; [apply HQ|].
  rewrite (IH c Q), (IH c (fun i => Q (i + 1)%Z)) by (intro; apply HQ). replace a with (1-b) by lra. ring.
Qed.
Lemma pw_at0 n : forall Q, pw (1-0) 0 n Q = Q 0%Z.
Proof. induction n as [|n IH]; intro Q; cbn; [reflexivity|]. rewrite !IH. ring. Qed.
Lemma pw_at1 n : forall Q, pw (1-1) 1 n Q = Q (Z.of_nat n).
Proof.
  induction n as [|n IH]; intro Q; [reflexivity|].
  cbn [pw]. rewrite !IH. replace (Z.of_nat n + 1)%Z with (Z.of_nat (S n)) by lia. ring.
Qed.

(* ---- seeds ---- *)
Fixpoint seeded (ss : list R) (P : Z -> R) (i : Z) : R :=
  match ss with [] => 0 | s :: ss => s * P i + seeded ss P (i + 1)%Z end.
Definition seed1 (a : R) (P : Z -> R) (i : Z) := a * P i.
Definition seed3 (a b c : R) (P : Z -> R) (i : Z) := a * P i + b * P (i + 1)%Z + c * P (i + 2)%Z.
Definition dl (P : Z -> R) (i : Z) := P (i + 1)%Z - P i.

Lemma fam_below a b ss n : forall i, (i < 0)%Z -> fam a b ss n i = 0.
Proof.
  induction n as [|n IH]; intros i H; cbn.
  - destruct (Z.leb_spec 0 i); [lia|reflexivity].
  - rewrite !IH by lia. ring.
Qed.
Lemma fam_above a b ss n : forall i, (Z.of_nat (length ss + n) <= i)%Z -> fam a b ss n i = 0.
Proof.
  induction n as [|n IH]; intros i H; cbn.
  - destruct (Z.leb_spec 0 i); [|reflexivity]. apply nth_overflow. lia.
  - rewrite !IH by lia. ring.
Qed.
Lemma seeded_shift ss P c : forall i, seeded ss P (i + c)%Z = seeded ss (fun i => P (i + c)%Z) i.
Proof.
  induction ss as [|s ss IH]; intro i; cbn; [reflexivity|].
  rewrite <- IH. replace (i + c + 1)%Z with (i + 1 + c)%Z by lia. reflexivity.
Qed.
Lemma seeded_sum ss : forall P i,
  sum 0 (Z.of_nat (length ss) - 1) (fun j => (if (0 <=? j)%Z then nth (Z.to_nat j) ss 0 else 0) * P (i + j)%Z)
  = seeded ss P i.
Proof.
  induction ss as [|s ss IH]; intros P i; [reflexivity|].
  cbn [length seeded]. rewrite sum_first by lia. f_equal.
  - replace (i + 0)%Z with i by lia. reflexivity.
  - rewrite <- IH. replace (Z.of_nat (S (length ss)) - 1)%Z with (Z.of_nat (length ss) - 1 + 1)%Z by lia.
    rewrite (sum_shift 0 _ 1). apply sum_ext. intros j Hj.
    destruct (Z.leb_spec 0 j); [|lia]. destruct (Z.leb_spec 0 (j + 1)); [|lia].
    replace (Z.to_nat (j + 1)) with (S (Z.to_nat j)) by lia. cbn [nth]. f_equal. f_equal. lia.
Qed.
Lemma series_nat a b ss n : (1 <= length ss)%nat -> forall P,
  sum 0 (Z.of_nat (n + length ss) - 1) (fun i => fam a b ss n i * P i) = pw a b n (seeded ss P).
Proof.
  intros H. induction n as [|n IH]; intro P.
  - cbn [pw fam Nat.add]. rewrite <- seeded_sum. apply sum_ext. intros. f_equal.
  - cbn [pw fam]. rewrite <- IH. rewrite (pw_ext a b n _ (seeded ss (fun i => P (i + 1)%Z))) by (intro; apply seeded_shift).
    rewrite <- IH, <- !sum_scal.
    rewrite (sum_ext _ _ _ (fun i => a * (fam a b ss n i * P i) + b * (fam a b ss n (i - 1) * P i))) by (intros; ring).
    rewrite sum_plus. f_equal.
    + rewrite sum_last by lia. rewrite fam_above by lia.
      replace (Z.of_nat (S n + length ss) - 1 - 1)%Z with (Z.of_nat (n + length ss) - 1)%Z by lia. ring.
    + rewrite sum_first by lia. rewrite (fam_below _ _ _ _ (0 - 1)) by lia.
      replace (Z.of_nat (S n + length ss) - 1)%Z with (Z.of_nat (n + length ss) - 1 + 1)%Z by lia.
      rewrite (sum_shift 0 _ 1). rewrite Rmult_0_l, Rmult_0_r, Rplus_0_l. apply sum_ext. intros i Hi.
      replace (i + 1 - 1)%Z with i by lia. reflexivity.
Qed.
Lemma series1 a b s k P : (0 <= k)%Z ->
  sum 0 k (fun i => basis a b [s] i k * P i) = pw a b (Z.to_nat k) (seed1 s P).
Proof.
  intro H. rewrite (pw_ext _ _ _ (seed1 s P) (seeded [s] P)) by (intro; unfold seed1; cbn; ring).
  rewrite <- (series_nat a b [s]) by (cbn; lia). unfold basis. cbn [length].
  replace (k - (Z.of_nat 1 - 1))%Z with k by lia. replace (Z.of_nat (Z.to_nat k + 1) - 1)%Z with k by lia. reflexivity.
Qed.
Lemma series3 a b s t u k P : (2 <= k)%Z ->
  sum 0 k (fun i => basis a b [s; t; u] i k * P i) = pw a b (Z.to_nat (k - 2)) (seed3 s t u P).
Proof.
  intro H. rewrite (pw_ext _ _ _ (seed3 s t u P) (seeded [s; t; u] P))
    by (intro i; unfold seed3; cbn; replace (i + 1 + 1)%Z with (i + 2)%Z by lia; ring).
  rewrite <- (series_nat a b [s; t; u]) by (cbn; lia). unfold basis. cbn [length].
  replace (Z.of_nat 3 - 1)%Z with 2%Z by lia.
  replace (Z.of_nat (Z.to_nat (k - 2) + 3) - 1)%Z with k by lia. reflexivity.
Qed.
(* the recursion *)
Lemma basis_step a b ss i k : (Z.of_nat (length ss) <= k)%Z -> (1 <= length ss)%nat ->
  basis a b ss i k = a * basis a b ss i (k - 1) + b * basis a b ss (i - 1) (k - 1).
Proof.
  intros H1 H2. unfold basis.
  replace (Z.to_nat (k - (Z.of_nat (length ss) - 1))) with (S (Z.to_nat (k - 1 - (Z.of_nat (length ss) - 1)))) by lia.
  reflexivity.
Qed.
Lemma basis_below a b ss i k : (i < 0)%Z -> basis a b ss i k = 0.
Proof. apply fam_below. Qed.
Lemma basis_above a b ss i k : (Z.of_nat (length ss) - 1 <= k)%Z -> (k < i)%Z -> basis a b ss i k = 0.
Proof. intros H1 H2. unfold basis. apply fam_above. lia. Qed.
Lemma basis_nonneg a b ss : 0 <= a -> 0 <= b -> (forall i, 0 <= nth i ss 0) -> forall i k, 0 <= basis a b ss i k.
Proof.
  intros Ha Hb Hs i k. unfold basis. generalize (Z.to_nat (k - (Z.of_nat (length ss) - 1))). intro n. revert i.
  induction n as [|n IH]; intro i; cbn.
  - destruct (0 <=? i)%Z; [apply Hs|apply Rle_refl].
  - apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto.
Qed.
(* symmetry: seeds and step exchanged *)
Lemma basis_mirror a b ss ss' : length ss = length ss' -> (1 <= length ss)%nat ->
  (forall i, (i < length ss)%nat -> nth (length ss - 1 - i) ss 0 = nth i ss' 0) ->
  forall i k, (Z.of_nat (length ss) - 1 <= k)%Z -> basis a b ss (k - i) k = basis b a ss' i k.
Proof.
  intros L H1 Hs i k Hk. unfold basis. rewrite <- L.
  assert (E : k = (Z.of_nat (Z.to_nat (k - (Z.of_nat (length ss) - 1))) + (Z.of_nat (length ss) - 1))%Z) by lia.
  revert E. generalize (Z.to_nat (k - (Z.of_nat (length ss) - 1))). intros n ->. clear Hk. revert i.
  induction n as [|n IH]; intro i.
  - cbn [fam Z.of_nat]. replace (0 + (Z.of_nat (length ss) - 1) - i)%Z with (Z.of_nat (length ss) - 1 - i)%Z by lia.
    destruct (Z.leb_spec 0 i) as [Hi|Hi], (Z.leb_spec 0 (Z.of_nat (length ss) - 1 - i)) as [Hj|Hj]; try reflexivity.
    + rewrite <- (Hs (Z.to_nat i)) by lia.
      replace (Z.to_nat (Z.of_nat (length ss) - 1 - i)) with (length ss - 1 - Z.to_nat i)%nat by lia. reflexivity.
    + symmetry. apply nth_overflow. lia.
    + apply nth_overflow. lia.
  - cbn [fam]. rewrite <- (IH i), <- (IH (i - 1)%Z).
    replace (Z.of_nat (S n) + (Z.of_nat (length ss) - 1) - i)%Z with (Z.of_nat n + (Z.of_nat (length ss) - 1) - (i - 1))%Z by lia.
    replace (Z.of_nat n + (Z.of_nat (length ss) - 1) - (i - 1) - 1)%Z with (Z.of_nat n + (Z.of_nat (length ss) - 1) - i)%Z by lia.
    ring.
Qed.

(* ---- derivatives ---- *)
Lemma derive_times (f : R -> R) (x c l : R) : is_derive f x l -> is_derive (fun x => f x * c) x (l * c).
Proof.
  intro H. apply is_derive_ext with (fun x => c * f x); [intro; apply Rmult_comm|].
  rewrite Rmult_comm. exact (is_derive_scal f x c l H).
Qed.
Section Derivative.
  Variables (u v w u' v' w' : R -> R) (x : R).
  Hypotheses (Hu : is_derive u x (u' x)) (Hv : is_derive v x (v' x)) (Hw : is_derive w x (w' x)).
  Definition F u v w n P (x : R) := pw (1 - x) x n (seed3 (u x) (v x) (w x) P).
  Lemma F_step u0 v0 w0 n P y :
    F u0 v0 w0 (S n) P y = (1 - y) * F u0 v0 w0 n P y + y * F u0 v0 w0 n (fun i => P (i + 1)%Z) y.
  Proof.
    unfold F. cbn [pw]. f_equal. f_equal. apply pw_ext. intro i. unfold seed3.
    replace (i + 1 + 1)%Z with (i + 2)%Z by lia. replace (i + 1 + 2)%Z with (i + 2 + 1)%Z by lia. reflexivity.
  Qed.
  Lemma F_dl u0 v0 w0 n P y : F u0 v0 w0 n (dl P) y = F u0 v0 w0 n (fun i => P (i + 1)%Z) y - F u0 v0 w0 n P y.
  Proof.
    unfold F. rewrite <- pw_minus. apply pw_ext. intro i. unfold seed3, dl.
    replace (i + 1 + 1)%Z with (i + 2)%Z by lia. replace (i + 2 + 1)%Z with (i + 3)%Z by lia. ring.
  Qed.
  Lemma F_derive n : forall P,
    is_derive (F u v w n P) x (INR n * F u v w (pred n) (dl P) x + F u' v' w' n P x).
  Proof.
    induction n as [|n IH]; intro P.
    - cbn [INR Nat.pred]. rewrite Rmult_0_l, Rplus_0_l. unfold F, seed3. cbn [pw].
      apply (is_derive_plus (fun x => u x * P 0%Z + v x * P (0 + 1)%Z) (fun x => w x * P (0 + 2)%Z));
        [apply (is_derive_plus (fun x => u x * P 0%Z) (fun x => v x * P (0 + 1)%Z))|];
        apply derive_times; assumption.
    - apply is_derive_ext with (fun x => (1 - x) * F u v w n P x + x * F u v w n (fun i => P (i + 1)%Z) x).
      { intro t; rewrite F_step; reflexivity. }
      assert (C : forall f g a b c, is_derive f x a -> is_derive g x b -> (a * g x + f x * b) = c ->
                  is_derive (fun x => f x * g x) x c).
      { intros f g a b c Hf Hg <-. apply (is_derive_mult f g x a b); auto. intros; apply Rmult_comm. }
      pose proof (F_dl u v w n P x) as D0. pose proof (F_step u' v' w' n P x) as D1.
      evar_last.
      { apply (is_derive_plus (fun x => (1 - x) * F u v w n P x) (fun x => x * F u v w n (fun i => P (i + 1)%Z) x)).
        - apply (C (fun x => 1 - x) (F u v w n P) (0 - 1) _ _ (is_derive_minus (fun _ => 1) (fun x => x) x 0 1 (is_derive_const 1 x) (is_derive_id x)) (IH P) eq_refl).
        - apply (C (fun x => x) (F u v w n (fun i => P (i + 1)%Z)) 1 _ _ (is_derive_id x) (IH _) eq_refl). }
      change plus with Rplus. cbn [Nat.pred]. rewrite D1, D0, S_INR.
      destruct n as [|n]; [cbn [INR]; ring|].
      cbn [Nat.pred]. rewrite !F_step, !F_dl. ring.
  Qed.
End Derivative.
