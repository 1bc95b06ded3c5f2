(* Proved once, by hand: nobody has to read it.
   Certified enclosures of closed numbers: rational arithmetic on both ends, pi from Machin's kind of series, roots by squares. *)
From Torse Require Import Defs.
From Coq Require Import Lra Lia QArith Qreals Qminmax Ratan.
Open Scope R_scope.

Lemma pi_between : 314159265 / 100000000 < PI < 314159266 / 100000000.
Proof.
  pose proof (PI_2_3_7_ineq 5) as [L H].
  cbn [sum_f_R0 Nat.mul Nat.add] in L, H.
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in L, H. cbn [pow Nat.mul Nat.add] in L, H.
  repeat rewrite INR_IZR_INZ in L. repeat rewrite INR_IZR_INZ in H.
  cbn [Z.of_nat Pos.of_succ_nat Pos.succ] in L, H. field_simplify in L. field_simplify in H. lra.
Qed.

Inductive num :=
  | NZ (z : Z) | NPi | NAdd (a b : num) | NSub (a b : num) | NMul (a b : num) | NDiv (a b : num) | NOpp (a : num)
  | NInv (a : num) | NPow (a : num) (n : nat) | NSqrt (a : num) | NExp (a : num).
Fixpoint nv (e : num) : R := match e with
  | NZ z => IZR z | NPi => PI | NAdd a b => nv a + nv b | NSub a b => nv a - nv b | NMul a b => nv a * nv b
  | NDiv a b => nv a / nv b | NOpp a => - nv a | NInv a => / nv a | NPow a n => nv a ^ n | NSqrt a => sqrt (nv a)
  | NExp a => exp (nv a) end.

Definition box := option (Q * Q).
Definition qmin (a b : Q) := if Qle_bool a b then a else b.
Definition qmax (a b : Q) := if Qle_bool a b then b else a.
Definition bmul (x y : box) : box := match x, y with
  | Some (a, b), Some (c, d) =>
      let p := Qred (a * c) in let q := Qred (a * d) in let r := Qred (b * c) in let s := Qred (b * d) in
      Some (qmin (qmin p q) (qmin r s), qmax (qmax p q) (qmax r s))
  | _, _ => None end.
Definition binv (x : box) : box := match x with
  | Some (a, b) => if orb (negb (Qle_bool a 0)) (negb (Qle_bool 0 b)) then Some (Qred (/ b), Qred (/ a)) else None
  | None => None end.
Definition scale := (10 ^ 12)%positive.
Definition root (q : Q) : Q := (Z.sqrt (Qnum q * Zpos scale * Zpos scale / Zpos (Qden q))) # scale.
Definition broot (x : box) : box := match x with
  | Some (a, b) =>
      let l := root a in let h := (root b + (1 # scale))%Q in
      if andb (andb (Qle_bool 0 l) (Qle_bool 0 h)) (andb (Qle_bool (l * l) a) (Qle_bool b (h * h)))
      then Some (l, Qred h) else None
  | None => None end.
(* e^q = (e^(q/2^40))^(2^40), and 1 + r <= e^r <= 1/(1 - r); the ends are rounded outwards *)
Definition fine := Eval vm_compute in (2 ^ 90)%positive.
Definition coarse := Eval vm_compute in (2 ^ 48)%positive.
Definition down (p : positive) (q : Q) : Q := (Qnum q * Zpos p / Zpos (Qden q))%Z # p.
Definition up (p : positive) (q : Q) : Q := Qopp (down p (Qopp q)).
Definition steps := Eval vm_compute in (2 ^ 40)%positive.
Fixpoint squared (n : nat) (round : Q -> Q) (q : Q) : Q :=
  match n with O => q | S n => squared n round (round (q * q)%Q) end.
Definition part (q : Q) : Q := (q * (1 # steps))%Q.
Definition exp_low (q : Q) : option Q :=
  let r := down fine (1 + part q)%Q in if Qle_bool 0 r then Some (down coarse (squared 40 (down fine) r)) else None.
Definition exp_high (q : Q) : option Q :=
  let r := (1 - part q)%Q in if Qle_bool r 0 then None else Some (up coarse (squared 40 (up fine) (up fine (/ r)))).
Definition bexp (x : box) : box := match x with
  | Some (a, b) => match exp_low a, exp_high b with Some l, Some h => Some (l, h) | _, _ => None end
  | None => None end.
Fixpoint bpow (x : box) (n : nat) : box := match n with O => Some (1 # 1, 1 # 1)%Q | S n => bmul x (bpow x n) end.
Definition badd (x y : box) : box := match x, y with
  | Some (a, b), Some (c, d) => Some (Qred (a + c), Qred (b + d)) | _, _ => None end.
Definition bopp (x : box) : box := match x with Some (a, b) => Some (Qopp b, Qopp a) | None => None end.
Fixpoint enclose (e : num) : box := match e with
  | NZ z => Some (z # 1, z # 1)%Q
  | NPi => Some (314159265 # 100000000, 314159266 # 100000000)%Q
  | NAdd a b => badd (enclose a) (enclose b) | NSub a b => badd (enclose a) (bopp (enclose b))
  | NMul a b => bmul (enclose a) (enclose b) | NDiv a b => bmul (enclose a) (binv (enclose b))
  | NOpp a => bopp (enclose a) | NInv a => binv (enclose a) | NPow a n => bpow (enclose a) n
  | NSqrt a => broot (enclose a) | NExp a => bexp (enclose a) end.

(* the arithmetic tactics read Q2R itself in their own way *)
Definition qr (q : Q) : R := Q2R q.
Lemma qr_plus a b : qr (a + b) = qr a + qr b. Proof. apply Q2R_plus. Qed.
Lemma qr_mult a b : qr (a * b) = qr a * qr b. Proof. apply Q2R_mult. Qed.
Lemma qr_opp a : qr (- a) = - qr a. Proof. apply Q2R_opp. Qed.
Lemma qr_inv a : ~ (a == 0)%Q -> qr (/ a) = / qr a. Proof. apply Q2R_inv. Qed.
Lemma qr_le a b : Qle_bool a b = true -> qr a <= qr b. Proof. intro H. apply Qle_Rle, Qle_bool_iff, H. Qed.
Lemma qr_lt a b : Qle_bool b a = false -> qr a < qr b.
Proof.
  intro E. assert (N : ~ (b <= a)%Q) by (rewrite <- Qle_bool_iff, E; discriminate). apply Qlt_Rlt, Qnot_le_lt, N.
Qed.
Lemma qr_z z : qr (z # 1) = IZR z. Proof. unfold qr, Q2R. cbn. field. Qed.
Definition inside (x : box) (r : R) : Prop := match x with Some (a, b) => qr a <= r <= qr b | None => True end.
Lemma red q : qr (Qred q) = qr q. Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma qmin_l a b : qr (qmin a b) <= qr a /\ qr (qmin a b) <= qr b.
Proof. unfold qmin. destruct (Qle_bool a b) eqn:E; [apply qr_le in E|apply qr_lt in E]; lra. Qed.
Lemma qmax_l a b : qr a <= qr (qmax a b) /\ qr b <= qr (qmax a b).
Proof. unfold qmax. destruct (Qle_bool a b) eqn:E; [apply qr_le in E|apply qr_lt in E]; lra. Qed.
Lemma mul_low a b c d m x y : a <= x <= b -> c <= y <= d -> m <= a * c -> m <= a * d -> m <= b * c -> m <= b * d -> m <= x * y.
Proof. 
  intros. destruct (Rle_dec 0 y); [|assert (y <= 0) by lra].
  - apply Rle_trans with (a * y); [|nra]. destruct (Rle_dec 0 a); nra.
  - apply Rle_trans with (b * y); [|nra]. destruct (Rle_dec 0 b); nra.
Qed.
Lemma inside_mul x y r s : inside x r -> inside y s -> inside (bmul x y) (r * s).
Proof.
  destruct x as [[a b]|], y as [[c d]|]; cbn [inside bmul]; auto. intros H1 H2.
  assert (E : forall v w, qr (Qred (v * w)) = qr v * qr w) by (intros; rewrite red; apply qr_mult).
  pose proof (E a c) as E1. pose proof (E a d) as E2. pose proof (E b c) as E3. pose proof (E b d) as E4. clear E. revert E1 E2 E3 E4.
  generalize (Qred (a * c)) (Qred (a * d)) (Qred (b * c)) (Qred (b * d)). intros p q t u E1 E2 E3 E4.
  pose proof (qmin_l p q). pose proof (qmin_l t u). pose proof (qmin_l (qmin p q) (qmin t u)).
  pose proof (qmax_l p q). pose proof (qmax_l t u). pose proof (qmax_l (qmax p q) (qmax t u)).
  split.
  - apply (mul_low (qr a) (qr b) (qr c) (qr d)); lra.
  - apply Ropp_le_cancel. replace (- (r * s)) with (- r * s) by ring.
    apply (mul_low (- qr b) (- qr a) (qr c) (qr d)); lra.
Qed.
Lemma inside_inv x r : inside x r -> inside (binv x) (/ r).
Proof.
  destruct x as [[a b]|]; cbn [inside binv]; auto. intro H.
  assert (Z0 : forall q, qr q <> 0 -> ~ (q == 0)%Q).
  { intros q E1 E2. apply E1. unfold qr. rewrite (Qeq_eqR _ _ E2). exact (qr_z 0). }
  pose proof (qr_z 0) as ZE.
  destruct (Qle_bool a 0) eqn:A; cbn [negb orb].
  - destruct (Qle_bool 0 b) eqn:B; cbn [negb]; [exact I|]. apply qr_lt in B. change (qr 0) with (qr (0 # 1)) in B.
    cbn [inside]. rewrite !red, !qr_inv by (apply Z0; lra). split.
    + apply Ropp_le_cancel. rewrite !Ropp_inv_permute by lra. apply Rinv_le_contravar; lra.
    + apply Ropp_le_cancel. rewrite !Ropp_inv_permute by lra. apply Rinv_le_contravar; lra.
  - apply qr_lt in A. change (qr 0) with (qr (0 # 1)) in A.
    cbn [inside]. rewrite !red, !qr_inv by (apply Z0; lra). split; apply Rinv_le_contravar; lra.
Qed.
Lemma inside_add x y r s : inside x r -> inside y s -> inside (badd x y) (r + s).
Proof. destruct x as [[a b]|], y as [[c d]|]; cbn [inside badd]; auto. intros. rewrite !red, !qr_plus. lra. Qed.
Lemma inside_opp x r : inside x r -> inside (bopp x) (- r).
Proof. destruct x as [[a b]|]; cbn [inside bopp]; auto. intros. rewrite !qr_opp. lra. Qed.
Lemma inside_root x r : inside x r -> inside (broot x) (sqrt r).
Proof.
  destruct x as [[a b]|]; cbn [inside broot]; auto. intro H.
  destruct (_ && _)%bool eqn:E; [|exact I].
  apply Bool.andb_true_iff in E as [E1 E2]. apply Bool.andb_true_iff in E1 as [L H0]. apply Bool.andb_true_iff in E2 as [E1 E2].
  apply qr_le in L, H0, E1, E2. rewrite qr_mult in E1, E2.
  pose proof (qr_z 0) as ZE. change (qr 0) with (qr (0 # 1)) in L, H0.
  cbn [inside]. split; [|rewrite red].
  - rewrite <- (sqrt_square (qr (root a))) by lra. apply sqrt_le_1_alt. lra.
  - rewrite <- (sqrt_square (qr (root b + (1 # scale)))) by lra. apply sqrt_le_1_alt. lra.
Qed.
Lemma down_le p q : qr (down p q) <= qr q.
Proof.
  destruct q as [n d]. unfold down, qr. cbn [Qnum Qden]. apply Qle_Rle. unfold Qle. cbn [Qnum Qden].
  rewrite (Z.mul_comm _ (Zpos d)). apply Z.mul_div_le. reflexivity.
Qed.
Lemma up_le p q : qr q <= qr (up p q).
Proof. unfold up. rewrite qr_opp. pose proof (down_le p (- q)) as H. rewrite qr_opp in H. lra. Qed.
Lemma down_nonneg p q : 0 <= qr q -> 0 <= qr (down p q).
Proof.
  destruct q as [n d]. unfold down, qr. intro H. replace 0 with (Q2R 0) in * by (unfold Q2R; cbn; lra).
  apply Rle_Qle in H. apply Qle_Rle. unfold Qle in *. cbn [Qnum Qden] in *.
  assert (0 <= n)%Z by lia. rewrite Z.mul_0_l, Z.mul_1_r. apply Z.div_pos; lia.
Qed.
Lemma squared_low n : forall q x, 0 <= qr q -> qr q <= exp x -> qr (squared n (down fine) q) <= exp (2 ^ n * x).
Proof.
  induction n as [|n IH]; intros q x P H; cbn [squared pow]; [rewrite Rmult_1_l; exact H|].
  replace (2 * 2 ^ n * x) with (2 ^ n * (x + x)) by ring.
  assert (S : 0 <= qr (q * q)) by (rewrite qr_mult; nra).
  apply IH; [apply down_nonneg, S|]. apply Rle_trans with (qr (q * q)); [apply down_le|].
  rewrite qr_mult, exp_plus. pose proof (exp_pos x). nra.
Qed.
Lemma squared_high n : forall q x, exp x <= qr q -> exp (2 ^ n * x) <= qr (squared n (up fine) q).
Proof.
  induction n as [|n IH]; intros q x H; cbn [squared pow]; [rewrite Rmult_1_l; exact H|].
  replace (2 * 2 ^ n * x) with (2 ^ n * (x + x)) by ring.
  apply IH. apply Rle_trans with (qr (q * q)); [|apply up_le].
  rewrite qr_mult, exp_plus. pose proof (exp_pos x). nra.
Qed.
Lemma qr_part q : 2 ^ 40 * qr (part q) = qr q.
Proof. unfold part. rewrite qr_mult. unfold qr at 2, Q2R, steps. cbn [Qnum Qden]. field. Qed.
Lemma exp_least x : 1 + x <= exp x.
Proof.
  destruct (Req_dec x 0) as [->|N]; [rewrite exp_0; lra|]. left. apply exp_ineq1, N.
Qed.
Lemma inside_exp x r : inside x r -> inside (bexp x) (exp r).
Proof.
  destruct x as [[a b]|]; cbn [inside bexp]; auto. intro H. unfold exp_low, exp_high.
  destruct (Qle_bool 0 (down fine (1 + part a))) eqn:L; [|exact I].
  destruct (Qle_bool (1 - part b) 0) eqn:U; [exact I|]. cbn [inside].
  pose proof (qr_z 0) as ZE. pose proof (qr_z 1) as OE.
  apply qr_le in L. apply qr_lt in U. change (qr 0) with (qr (0 # 1)) in L, U. split.
  - apply Rle_trans with (exp (qr a)); [|destruct (proj1 H) as [D| ->]; [left; apply exp_increasing, D|apply Rle_refl]].
    eapply Rle_trans; [apply down_le|].
    rewrite <- (qr_part a). apply squared_low; [lra|]. pose proof (down_le fine (1 + part a)) as D. rewrite qr_plus in D.
    change (qr 1) with (qr (1 # 1)) in D. pose proof (exp_least (qr (part a))). lra.
  - apply Rle_trans with (exp (qr b)); [destruct (proj2 H) as [D| ->]; [left; apply exp_increasing, D|apply Rle_refl]|].
    eapply Rle_trans; [|apply up_le].
    rewrite <- (qr_part b). apply squared_high. apply Rle_trans with (qr (/ (1 - part b))); [|apply up_le].
    assert (E : qr (1 - part b) = 1 - qr (part b)).
    { unfold Qminus. rewrite qr_plus, qr_opp. change (qr 1) with (qr (1 # 1)). lra. }
    rewrite qr_inv by (intro F; apply Qeq_eqR in F; fold (qr (1 - part b)) in F; fold (qr 0) in F; change (qr 0) with (qr (0 # 1)) in F; lra).
    rewrite E. rewrite E in U. pose proof (exp_least (- qr (part b))) as G. rewrite exp_Ropp in G. pose proof (exp_pos (qr (part b))).
    rewrite <- (Rinv_involutive (exp (qr (part b)))) by lra. apply Rinv_le_contravar; lra.
Qed.
Lemma inside_pow x r n : inside x r -> inside (bpow x n) (r ^ n).
Proof.
  intro H. induction n as [|n IH]; [cbn [bpow inside pow]; rewrite (qr_z 1); lra|]. apply inside_mul; assumption.
Qed.
Theorem enclosed e : inside (enclose e) (nv e).
Proof.
  induction e; cbn [enclose nv].
  - cbn [inside]. rewrite qr_z. lra.
  - cbn [inside]. unfold qr, Q2R. cbn [Qnum Qden]. pose proof pi_between. lra.
  - apply inside_add; assumption.
  - apply inside_add; [assumption|apply inside_opp; assumption].
  - apply inside_mul; assumption.
  - apply inside_mul; [assumption|apply inside_inv; assumption].
  - apply inside_opp; assumption.
  - apply inside_inv; assumption.
  - apply inside_pow; assumption.
  - apply inside_root; assumption.
  - apply inside_exp; assumption.
Qed.

(* what a computation decides *)
Definition above (e : num) : bool := match enclose e with Some (a, _) => negb (Qle_bool a (0 # 1)) | None => false end.
Definition not_below (e : num) : bool := match enclose e with Some (a, _) => Qle_bool (0 # 1) a | None => false end.
Lemma above_zero e : above e = true -> 0 < nv e.
Proof.
  unfold above. pose proof (enclosed e) as H. destruct (enclose e) as [[a b]|]; [|discriminate]. cbn [inside] in H. intro E.
  apply Bool.negb_true_iff, qr_lt in E. pose proof (qr_z 0). lra.
Qed.
Lemma not_below_zero e : not_below e = true -> 0 <= nv e.
Proof.
  unfold not_below. pose proof (enclosed e) as H. destruct (enclose e) as [[a b]|]; [|discriminate]. cbn [inside] in H. intro E.
  apply qr_le in E. pose proof (qr_z 0). lra.
Qed.
Lemma num_lt a b : above (NSub b a) = true -> nv a < nv b.
Proof. intro H. apply above_zero in H. cbn [nv] in H. lra. Qed.
Lemma num_le a b : not_below (NSub b a) = true -> nv a <= nv b.
Proof. intro H. apply not_below_zero in H. cbn [nv] in H. lra. Qed.
Lemma num_neq a b : orb (above (NSub a b)) (above (NSub b a)) = true -> nv a <> nv b.
Proof. intro H. apply Bool.orb_true_iff in H as [H|H]; apply above_zero in H; cbn [nv] in H; lra. Qed.
