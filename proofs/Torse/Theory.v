(* Proved once, by hand: nobody has to read it.
   Expressions in one variable with a derivative that computes; Rocq's total [Derive_n] is what it computes to. *)
From Torse Require Import Defs Series.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- expressions ---- *)
Inductive ex :=
  | K (r : R) | X | Ad (e f : ex) | Sb (e f : ex) | Op (e : ex) | Ml (e f : ex) | Iv (e : ex) | Pw (e : ex) (n : nat)
  | Si (e : ex) | Co (e : ex) | Ep (e : ex) | Se (a b c : ex) (m : Z) (P : Z -> R) | Ss (u v : R) (a b c : ex) (m : Z) (P : Z -> R).
Fixpoint ev (e : ex) (x : R) : R := match e with
  | K r => r | X => x | Ad e f => ev e x + ev f x | Sb e f => ev e x - ev f x | Op e => - ev e x
  | Ml e f => ev e x * ev f x | Iv e => / ev e x | Pw e n => ev e x ^ n
  | Si e => sin (ev e x) | Co e => cos (ev e x) | Ep e => exp (ev e x)
  | Se a b c m P => pw (1 - x) x (Z.to_nat m) (seed3 (ev a x) (ev b x) (ev c x) P)
  | Ss u v a b c m P => pw u v (Z.to_nat m) (seed3 (ev a x) (ev b x) (ev c x) P) end.
(* whether the variable occurs *)
Fixpoint occurs (e : ex) : bool := match e with
  | K _ => false | X => true | Ad e f | Sb e f | Ml e f => occurs e || occurs f
  | Op e | Iv e | Pw e _ | Si e | Co e | Ep e => occurs e | Se _ _ _ _ _ => true
  | Ss _ _ a b c _ _ => occurs a || occurs b || occurs c end.
Fixpoint dx (e : ex) : ex :=
  if occurs e then match e with
  | K _ => K 0 | X => K 1
  | Ad e f => if occurs e then if occurs f then Ad (dx e) (dx f) else dx e else dx f
  | Sb e f => if occurs e then if occurs f then Sb (dx e) (dx f) else dx e else Op (dx f)
  | Op e => Op (dx e)
  | Ml e f => if occurs e then if occurs f then Ad (Ml (dx e) f) (Ml e (dx f)) else Ml (dx e) f else Ml e (dx f)
  | Iv e => Op (Ml (dx e) (Iv (Ml e e)))
  | Pw e n => match n with O => K 0 | S n => Ml (K (IZR (Z.of_nat (S n)))) (Ml (dx e) (Pw e n)) end
  | Si e => Ml (dx e) (Co e) | Co e => Op (Ml (dx e) (Si e)) | Ep e => Ml (dx e) (Ep e)
  | Se a b c m P => Ad (Ml (K (IZR (Z.max m 0))) (Se a b c (m - 1) (dl P))) (Se (dx a) (dx b) (dx c) m P)
  | Ss u v a b c m P => Ss u v (dx a) (dx b) (dx c) m P end
  else K 0.
(* no divisor is zero *)
Fixpoint ok (e : ex) (x : R) : Prop := match e with
  | K _ | X => True | Ad e f | Sb e f | Ml e f => ok e x /\ ok f x
  | Op e | Pw e _ | Si e | Co e | Ep e => ok e x
  | Iv e => ok e x /\ ev e x <> 0
  | Se a b c _ _ | Ss _ _ a b c _ _ => ok a x /\ ok b x /\ ok c x end.

Lemma no_x e : occurs e = false -> forall x y, ev e x = ev e y.
Proof.
  induction e; simpl; intros H x y; try discriminate; auto;
    first [apply Bool.orb_false_elim in H as [H H3]; apply Bool.orb_false_elim in H as [H1 H2];
           rewrite (IHe1 H1 x y), (IHe2 H2 x y), (IHe3 H3 x y); reflexivity
          |apply Bool.orb_false_elim in H as [H1 H2]; rewrite (IHe1 H1 x y), (IHe2 H2 x y); reflexivity
          |rewrite (IHe H x y); reflexivity].
Qed.
Lemma flat e x : occurs e = false -> is_derive (ev e) x 0.
Proof.
  intro H. apply is_derive_ext with (fun _ => ev e x); [intro; apply no_x, H|exact (is_derive_const (ev e x) x)].
Qed.
Lemma deq (f : R -> R) (x a b : R) : is_derive f x a -> a = b -> is_derive f x b.
Proof. intros H <-; exact H. Qed.
Lemma dplus (f g : R -> R) (x a b : R) : is_derive f x a -> is_derive g x b -> is_derive (fun x => f x + g x) x (a + b).
Proof. exact (is_derive_plus f g x a b). Qed.
Lemma dminus (f g : R -> R) (x a b : R) : is_derive f x a -> is_derive g x b -> is_derive (fun x => f x - g x) x (a - b).
Proof. exact (is_derive_minus f g x a b). Qed.
Lemma dmult (f g : R -> R) (x a b : R) :
  is_derive f x a -> is_derive g x b -> is_derive (fun x => f x * g x) x (a * g x + f x * b).
Proof. intros; apply (is_derive_mult f g x a b); auto. intros; apply Rmult_comm. Qed.
Lemma dcomp (f g : R -> R) (x a b : R) : is_derive f (g x) a -> is_derive g x b -> is_derive (fun x => f (g x)) x (b * a).
Proof. intros; apply (is_derive_comp f g x a b); auto. Qed.

(* a series of fixed step in its seeds *)
Lemma seeds_derive u v (a b c a' b' c' : R -> R) x :
  is_derive a x (a' x) -> is_derive b x (b' x) -> is_derive c x (c' x) -> forall n P,
  is_derive (fun x => pw u v n (seed3 (a x) (b x) (c x) P)) x (pw u v n (seed3 (a' x) (b' x) (c' x) P)).
Proof.
  intros Ha Hb Hc n. induction n as [|n IH]; intro P.
  - unfold seed3. cbn [pw].
    apply (dplus (fun x => a x * P 0%Z + b x * P (0 + 1)%Z) (fun x => c x * P (0 + 2)%Z));
      [apply (dplus (fun x => a x * P 0%Z) (fun x => b x * P (0 + 1)%Z))|]; apply derive_times; assumption.
  - assert (S : forall r s t, pw u v (S n) (seed3 r s t P) =
      u * pw u v n (seed3 r s t P) + v * pw u v n (seed3 r s t (fun i => P (i + 1)%Z))).
    { intros. cbn [pw]. f_equal. f_equal. apply pw_ext. intro i. unfold seed3.
      replace (i + 1 + 1)%Z with (i + 2)%Z by lia. replace (i + 1 + 2)%Z with (i + 2 + 1)%Z by lia. reflexivity. }
    rewrite S. apply is_derive_ext with (fun x => u * pw u v n (seed3 (a x) (b x) (c x) P) +
      v * pw u v n (seed3 (a x) (b x) (c x) (fun i => P (i + 1)%Z))); [intro; rewrite S; reflexivity|].
    apply (dplus (fun x => u * pw u v n (seed3 (a x) (b x) (c x) P))
      (fun x => v * pw u v n (seed3 (a x) (b x) (c x) (fun i => P (i + 1)%Z)))).
    + exact (is_derive_scal (fun x => pw u v n (seed3 (a x) (b x) (c x) P)) x u _ (IH P)).
    + exact (is_derive_scal (fun x => pw u v n (seed3 (a x) (b x) (c x) (fun i => P (i + 1)%Z))) x v _ (IH _)).
Qed.

Lemma evK r x : ev (K r) x = r. Proof. reflexivity. Qed.
Lemma evAd e f x : ev (Ad e f) x = ev e x + ev f x. Proof. reflexivity. Qed.
Lemma evSb e f x : ev (Sb e f) x = ev e x - ev f x. Proof. reflexivity. Qed.
Lemma evMl e f x : ev (Ml e f) x = ev e x * ev f x. Proof. reflexivity. Qed.
Lemma evOp e x : ev (Op e) x = - ev e x. Proof. reflexivity. Qed.
Lemma evIv e x : ev (Iv e) x = / ev e x. Proof. reflexivity. Qed.
Lemma evPw e n x : ev (Pw e n) x = ev e x ^ n. Proof. reflexivity. Qed.
Lemma evSi e x : ev (Si e) x = sin (ev e x). Proof. reflexivity. Qed.
Lemma evCo e x : ev (Co e) x = cos (ev e x). Proof. reflexivity. Qed.
Lemma evEp e x : ev (Ep e) x = exp (ev e x). Proof. reflexivity. Qed.
Ltac evs := cbv beta; repeat (progress (rewrite ?evK, ?evAd, ?evSb, ?evMl, ?evOp, ?evIv, ?evPw, ?evSi, ?evCo, ?evEp)).
Lemma INR_IZR_INZ_max m : INR (Z.to_nat m) = IZR (Z.max m 0).
Proof. rewrite INR_IZR_INZ. f_equal. lia. Qed.
Lemma to_nat_pred m : Z.to_nat (m - 1) = pred (Z.to_nat m).
Proof. lia. Qed.
Lemma ev_dx e x : ok e x -> is_derive (ev e) x (ev (dx e) x).
Proof.
  induction e; intro H.
  1: exact (is_derive_const r x).
  1: exact (is_derive_id x).
  - destruct H as [H1 H2]. specialize (IHe1 H1). specialize (IHe2 H2).
    cbn [dx occurs]. destruct (occurs e1) eqn:O1, (occurs e2) eqn:O2; cbn [orb].
    + apply (dplus (ev e1) (ev e2)); assumption.
    + eapply deq; [apply (dplus (ev e1) (ev e2)); [exact IHe1|apply flat, O2]|evs; ring].
    + eapply deq; [apply (dplus (ev e1) (ev e2)); [apply flat, O1|exact IHe2]|evs; ring].
    + eapply deq; [apply (dplus (ev e1) (ev e2)); apply flat; assumption|evs; ring].
  - destruct H as [H1 H2]. specialize (IHe1 H1). specialize (IHe2 H2).
    cbn [dx occurs]. destruct (occurs e1) eqn:O1, (occurs e2) eqn:O2; cbn [orb].
    + apply (dminus (ev e1) (ev e2)); assumption.
    + eapply deq; [apply (dminus (ev e1) (ev e2)); [exact IHe1|apply flat, O2]|evs; ring].
    + eapply deq; [apply (dminus (ev e1) (ev e2)); [apply flat, O1|exact IHe2]|evs; ring].
    + eapply deq; [apply (dminus (ev e1) (ev e2)); apply flat; assumption|evs; ring].
  - specialize (IHe H). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + exact (is_derive_opp (ev e) x _ IHe).
    + eapply deq; [apply (is_derive_opp (ev e) x 0), flat, O1|evs; apply Ropp_0].
  - destruct H as [H1 H2]. specialize (IHe1 H1). specialize (IHe2 H2).
    cbn [dx occurs]. destruct (occurs e1) eqn:O1, (occurs e2) eqn:O2; cbn [orb].
    + apply (dmult (ev e1) (ev e2)); assumption.
    + eapply deq; [apply (dmult (ev e1) (ev e2)); [exact IHe1|apply flat, O2]|evs; ring].
    + eapply deq; [apply (dmult (ev e1) (ev e2)); [apply flat, O1|exact IHe2]|evs; ring].
    + eapply deq; [apply (dmult (ev e1) (ev e2)); apply flat; assumption|evs; ring].
  - destruct H as [H1 H2]. specialize (IHe H1). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + eapply deq; [apply (is_derive_inv (ev e) x _ IHe H2)|evs; field; exact H2].
    + eapply deq; [apply (is_derive_inv (ev e) x 0 (flat e x O1) H2)|evs; field; exact H2].
  - specialize (IHe H). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + destruct n as [|n]; [exact (is_derive_const 1 x)|].
      eapply deq; [apply (is_derive_pow (ev e) (S n) x _ IHe)|]. cbn [Nat.pred]. evs. rewrite <- INR_IZR_INZ. ring.
    + apply (flat (Pw e n)). exact O1.
  - specialize (IHe H). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + apply (dcomp sin (ev e)); [apply is_derive_sin|exact IHe].
    + apply (flat (Si e)). exact O1.
  - specialize (IHe H). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + eapply deq; [apply (dcomp cos (ev e)); [apply is_derive_cos|exact IHe]|evs; ring].
    + apply (flat (Co e)). exact O1.
  - specialize (IHe H). cbn [dx occurs]. destruct (occurs e) eqn:O1.
    + apply (dcomp exp (ev e)); [apply is_derive_exp|exact IHe].
    + apply (flat (Ep e)). exact O1.
  - destruct H as [H1 [H2 H3]]. cbn [dx occurs]. evs.
    rewrite <- INR_IZR_INZ_max. cbn [ev]. rewrite to_nat_pred.
    exact (F_derive (ev e1) (ev e2) (ev e3) (ev (dx e1)) (ev (dx e2)) (ev (dx e3)) x (IHe1 H1) (IHe2 H2) (IHe3 H3) (Z.to_nat m) P).
  - destruct H as [H1 [H2 H3]]. cbn [dx]. destruct (occurs _) eqn:O.
    + cbn [ev]. exact (seeds_derive u v (ev e1) (ev e2) (ev e3) (ev (dx e1)) (ev (dx e2)) (ev (dx e3)) x
        (IHe1 H1) (IHe2 H2) (IHe3 H3) (Z.to_nat m) P).
    + apply (flat (Ss u v e1 e2 e3 m P)). exact O.
Qed.

Lemma ok_dx e x : ok e x -> ok (dx e) x.
Proof.
  induction e; intro H; cbn [dx]; destruct (occurs _); try exact I; cbn [ok] in *;
    repeat match goal with H : _ /\ _ |- _ => destruct H end;
    repeat match goal with |- context [if occurs ?e then _ else _] => destruct (occurs e) end;
    try solve [cbn [ok]; repeat split; auto].
  - cbn [ok]. repeat split; auto. rewrite evMl. intro E. apply Rmult_integral in E. tauto.
  - destruct n; cbn [ok]; repeat split; auto.
Qed.

Lemma ok_open e x : ok e x -> locally x (ok e).
Proof.
  induction e; intro H; cbn [ok] in *; try (apply filter_forall; intro; exact I); auto;
    try (apply filter_and; tauto).
  - destruct H as [H1 H2]. apply filter_and; [auto|].
    assert (C : continuous (ev e) x) by (apply @ex_derive_continuous; eexists; apply ev_dx, H1).
    apply (C (fun y => y <> 0)). destruct (Rdichotomy _ _ H2) as [L|L].
    + apply (filter_imp (fun y => y < 0)); [intros; lra|]. apply (open_lt 0), L.
    + apply (filter_imp (fun y => 0 < y)); [intros; lra|]. apply (open_gt 0), L.
  - destruct H as [H1 [H2 H3]]. apply filter_and; [auto|apply filter_and; auto].
  - destruct H as [H1 [H2 H3]]. apply filter_and; [auto|apply filter_and; auto].
Qed.

Fixpoint dxn (n : nat) (e : ex) : ex := match n with O => e | S n => dx (dxn n e) end.
Lemma ok_dxn n e x : ok e x -> ok (dxn n e) x.
Proof. induction n; simpl; auto using ok_dx. Qed.
(* what generated proofs call *)
Lemma pw_end m Q : pw (1-1) 1 (Z.to_nat m) Q = Q (Z.max m 0).
Proof. rewrite pw_at1. f_equal. lia. Qed.
Lemma curve1 a b s k P : (0 <= k)%Z ->
  sum 0 k (fun i => basis a b [s] i k * P i) = pw a b (Z.to_nat k) (seed3 s 0 0 P).
Proof. intro H. rewrite series1 by exact H. apply pw_ext. intro i. unfold seed1, seed3. ring. Qed.
Lemma unity1 a b s k : (0 <= k)%Z ->
  sum 0 k (fun i => basis a b [s] i k) = pw a b (Z.to_nat k) (seed3 s 0 0 (fun _ => 1)).
Proof. intro H. rewrite <- curve1 by exact H. apply sum_ext. intros; ring. Qed.
Lemma unity3 a b s t u k : (2 <= k)%Z ->
  sum 0 k (fun i => basis a b [s; t; u] i k) = pw a b (Z.to_nat (k - 2)) (seed3 s t u (fun _ => 1)).
Proof. intro H. rewrite <- series3 by exact H. apply sum_ext. intros; ring. Qed.
Theorem derive_ex n : forall e x, ok e x -> Derive_n (ev e) n x = ev (dxn n e) x.
Proof.
  induction n as [|n IH]; intros e x H; [reflexivity|].
  simpl Derive_n. apply is_derive_unique.
  apply is_derive_ext_loc with (ev (dxn n e)).
  - apply (filter_imp (ok e)); [intros y Hy; symmetry; apply IH, Hy|apply ok_open, H].
  - apply ev_dx, ok_dxn, H.
Qed.

Theorem derive_as f e n x : (forall t, f t = ev e t) -> ok e x -> Derive_n f n x = ev (dxn n e) x.
Proof. intros E H. rewrite (Derive_n_ext f (ev e) n x E). apply derive_ex, H. Qed.

(* an equation that is linear in an unknown *)
Lemma solved (F : R -> R) x n d : F x = 0 -> F x = n + x * d -> d <> 0 -> x = - n / d.
Proof.
  intros H1 H2 H3. rewrite H1 in H2. apply (Rmult_eq_reg_r d); [|exact H3].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by exact H3. lra.
Qed.

(* ---- one function of a basis ---- *)
Definition unit (i j : Z) : R := if (j =? i)%Z then 1 else 0.
Lemma unit_one i j : j = i -> unit i j = 1.
Proof. intros ->. unfold unit. rewrite Z.eqb_refl. reflexivity. Qed.
Lemma unit_zero i j : j <> i -> unit i j = 0.
Proof. intro H. unfold unit. destruct (Z.eqb_spec j i); [contradiction|reflexivity]. Qed.
Lemma unit_sum i f l h : sum l h (fun j => f j * unit i j) = if ((l <=? i) && (i <=? h))%bool%Z then f i else 0.
Proof.
  unfold sum, range. set (n := Z.to_nat (h - l + 1)).
  assert (E : ((l <=? i) && (i <=? h))%bool%Z = ((l <=? i) && (i <? l + Z.of_nat n))%bool%Z).
  { subst n. destruct (Z.leb_spec l i), (Z.leb_spec i h), (Z.ltb_spec i (l + Z.of_nat (Z.to_nat (h - l + 1)))); cbn; try reflexivity; lia. }
  rewrite E. clear E. generalize n. clear n h. intro n. induction n as [|n IH].
  - cbn. destruct (Z.leb_spec l i), (Z.ltb_spec i (l + 0)); cbn; try reflexivity; lia.
  - rewrite seq_S, !map_app, fold_app, IH. cbn [map fold_right Nat.add]. rewrite Rplus_0_r.
    destruct (Z.eq_dec (l + Z.of_nat n) i) as [<-|N].
    + rewrite unit_one by reflexivity.
      destruct (Z.leb_spec l (l + Z.of_nat n)), (Z.ltb_spec (l + Z.of_nat n) (l + Z.of_nat n)),
        (Z.ltb_spec (l + Z.of_nat n) (l + Z.of_nat (S n))); cbn [andb]; try lia; ring.
    + rewrite unit_zero by exact N.
      destruct (Z.leb_spec l i), (Z.ltb_spec i (l + Z.of_nat n)), (Z.ltb_spec i (l + Z.of_nat (S n))); cbn [andb]; try lia; ring.
Qed.
Lemma one_of_three a b s t u i k : (2 <= k)%Z ->
  basis a b [s; t; u] i k = pw a b (Z.to_nat (k - 2)) (seed3 s t u (unit i)).
Proof.
  intro H. rewrite <- series3 by exact H. rewrite (unit_sum i (fun i => basis a b [s; t; u] i k)).
  destruct (Z.leb_spec 0 i), (Z.leb_spec i k); cbn [andb]; try reflexivity.
  - apply basis_above; cbn [length]; lia.
  - apply basis_below. lia.
  - apply basis_below. lia.
Qed.

(* ---- special angles ---- *)
Lemma sin_pi4 : sin (PI/4) = sqrt 2 / 2.
Proof.
  rewrite sin_PI4. assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  apply (Rmult_eq_reg_l (sqrt 2)); [|lra]. unfold Rdiv. rewrite Rmult_1_l, Rinv_r by lra. lra.
Qed.
Lemma cos_pi4 : cos (PI/4) = sqrt 2 / 2.
Proof. rewrite cos_PI4, <- sin_PI4. apply sin_pi4. Qed.
Lemma square_sum t : sin t ^ 2 + cos t ^ 2 = 1.
Proof. pose proof (sin2_cos2 t) as E. unfold Rsqr in E. simpl. lra. Qed.
Lemma circle_rule s c : s ^ 2 + c ^ 2 = 1 -> c ^ 2 = 1 - s ^ 2.
Proof. intro; lra. Qed.
Lemma square_root q : 0 <= q -> sqrt q ^ 2 = q.
Proof. intro H. simpl. rewrite Rmult_1_r. apply sqrt_sqrt, H. Qed.
Lemma sin_2PI3' : sin (PI - PI/3) = sqrt 3 / 2. Proof. rewrite sin_PI_x, sin_PI3. reflexivity. Qed.
Lemma sin_3PI4' : sin (PI - PI/4) = sqrt 2 / 2. Proof. rewrite sin_PI_x. apply sin_pi4. Qed.
Lemma sin_5PI6' : sin (PI - PI/6) = 1 / 2. Proof. rewrite sin_PI_x, sin_PI6. reflexivity. Qed.
Lemma cos_PI_x' x : cos (PI - x) = - cos x. Proof. rewrite cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma sin_PI_x' x : sin (PI - x) = sin x. Proof. apply sin_PI_x. Qed.
Lemma cos_2PI3' : cos (PI - PI/3) = - (1 / 2). Proof. rewrite cos_PI_x', cos_PI3. reflexivity. Qed.
Lemma cos_3PI4' : cos (PI - PI/4) = - (sqrt 2 / 2). Proof. rewrite cos_PI_x', cos_pi4. reflexivity. Qed.
Lemma cos_5PI6' : cos (PI - PI/6) = - (sqrt 3 / 2). Proof. rewrite cos_PI_x', cos_PI6. reflexivity. Qed.
Lemma sin_mPI2 : sin (- (PI/2)) = -1. Proof. rewrite sin_neg, sin_PI2. reflexivity. Qed.
Lemma cos_mPI2 : cos (- (PI/2)) = 0. Proof. rewrite cos_neg. apply cos_PI2. Qed.
Lemma sin_mPI : sin (- PI) = 0. Proof. rewrite sin_neg, sin_PI. ring. Qed.
Lemma cos_mPI : cos (- PI) = -1. Proof. rewrite cos_neg. apply cos_PI. Qed.
Lemma sin_PI2_plus x : sin (PI/2 + x) = cos x. Proof. rewrite sin_plus, sin_PI2, cos_PI2. ring. Qed.
Lemma cos_PI2_plus x : cos (PI/2 + x) = - sin x. Proof. rewrite cos_plus, sin_PI2, cos_PI2. ring. Qed.
Lemma sin_2PI_minus x : sin (2*PI - x) = - sin x. Proof. rewrite sin_minus, sin_2PI, cos_2PI. ring. Qed.
Lemma cos_2PI_minus x : cos (2*PI - x) = cos x. Proof. rewrite cos_minus, sin_2PI, cos_2PI. ring. Qed.
Lemma quarter_sine x : 0 <= x <= 1 -> 0 <= sin (PI / 2 * x) <= 1.
Proof. intro H. pose proof PI_RGT_0. split; [apply sin_ge_0; nra|apply SIN_bound]. Qed.
Lemma quarter_cosine x : 0 <= x <= 1 -> 0 <= cos (PI / 2 * x) <= 1.
Proof. intro H. pose proof PI_RGT_0. split; [apply cos_ge_0; nra|apply COS_bound]. Qed.

(* ---- what is not zero ---- *)
Lemma factors a b : a * b <> 0 -> a <> 0 /\ b <> 0.
Proof. intro H. split; intro E; apply H; rewrite E; ring. Qed.
Lemma product a b : a <> 0 /\ b <> 0 -> a * b <> 0.
Proof. intros [H1 H2] E. apply Rmult_integral in E. tauto. Qed.
Lemma quotient a b : a / b <> 0 -> a <> 0.
Proof. intros H E. apply H. rewrite E. unfold Rdiv. ring. Qed.
Lemma power_base a n : a ^ S n <> 0 -> a <> 0.
Proof. intros H E. apply H. rewrite E. cbn. ring. Qed.
Lemma opposite a : - a <> 0 -> a <> 0.
Proof. intros H E. apply H. rewrite E. ring. Qed.
Lemma near_nonzero f e x : (forall t, f t = ev e t) -> ok e x -> ev e x <> 0 -> locally x (fun t => f t <> 0).
Proof.
  intros E H N. apply (filter_imp (ok (Iv e))).
  - intros t [_ Ht]. rewrite E. exact Ht.
  - apply ok_open. split; assumption.
Qed.

(* the mark of a number that equations determine *)
Definition unknown_value (x : R) : Prop := True.


(* ---- the ends of the interval ---- *)
Lemma fam_at0 ss n : forall i, fam (1 - 0) 0 ss n i = fam (1 - 0) 0 ss 0 i.
Proof. induction n as [|n IH]; intro i; [reflexivity|]. cbn [fam]. rewrite IH. cbn [fam]. ring. Qed.
Lemma fam_at1 ss n : forall i, fam (1 - 1) 1 ss n i = fam (1 - 1) 1 ss 0 (i - Z.of_nat n).
Proof.
  induction n as [|n IH]; intro i; [cbn [fam]; rewrite Z.sub_0_r; reflexivity|].
  cbn [fam]. rewrite (IH i), (IH (i - 1)%Z). replace (i - Z.of_nat (S n))%Z with (i - 1 - Z.of_nat n)%Z by lia. cbn [fam]. ring.
Qed.
Lemma basis_at0 ss i k : basis (1 - 0) 0 ss i k = fam (1 - 0) 0 ss 0 i.
Proof. apply fam_at0. Qed.
Lemma basis_at1 ss i k : (Z.of_nat (length ss) - 1 <= k)%Z ->
  basis (1 - 1) 1 ss i k = fam (1 - 1) 1 ss 0 (i - (k - (Z.of_nat (length ss) - 1))).
Proof. intro H. unfold basis. rewrite fam_at1. f_equal. lia. Qed.
