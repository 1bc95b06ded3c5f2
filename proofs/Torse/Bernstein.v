(* Bernstein polynomials in closed form, and what follows from it: nobody has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- binomial coefficients ---- *)
Lemma not_zero j : INR (S j) <> 0.
Proof. apply not_0_INR. discriminate. Qed.
Lemma absorbed x j : falling (x + 1) j * (x + 1 - INR j) = falling x j * (x + 1).
Proof.
  induction j as [|j IH]; [cbn; ring|]. cbn [falling]. rewrite S_INR.
  replace (x + 1 - (INR j + 1)) with (x - INR j) by ring. pose proof (not_zero j) as N. rewrite S_INR in N.
  replace (falling (x + 1) j * (x + 1 - INR j) / (INR j + 1) * (x - INR j))
    with ((falling (x + 1) j * (x + 1 - INR j)) * (x - INR j) / (INR j + 1)) by (field; exact N).
  rewrite IH. field. exact N.
Qed.
Lemma pascal x j : falling (x + 1) (S j) = falling x (S j) + falling x j.
Proof.
  cbn [falling]. rewrite absorbed, S_INR. pose proof (not_zero j) as N. rewrite S_INR in N. field. exact N.
Qed.
Lemma lowered x j : falling (x + 1) (S j) * INR (S j) = (x + 1) * falling x j.
Proof. cbn [falling]. pose proof (not_zero j) as N. rewrite absorbed. field. exact N. Qed.

(* ---- the closed form ---- *)
Lemma bernstein a b n : forall j, (j <= n)%nat ->
  fam a b [1] n (Z.of_nat j) = falling (INR n) j * b ^ j * a ^ (n - j).
Proof.
  induction n as [|n IH]; intros j H.
  - replace j with O by lia. cbn. ring.
  - cbn [fam]. destruct j as [|j].
    + rewrite (fam_below _ _ _ _ (Z.of_nat 0 - 1)) by lia. rewrite IH by lia.
      replace (S n - 0)%nat with (S (n - 0)) by lia. cbn [falling pow]. ring.
    + replace (Z.of_nat (S j) - 1)%Z with (Z.of_nat j) by lia. rewrite (IH j) by lia.
      rewrite (S_INR n), pascal. destruct (Nat.eq_dec j n) as [->|N].
      * rewrite fam_above by (cbn [length]; lia).
        replace (falling (INR n) (S n)) with 0 by (cbn [falling]; unfold Rdiv; ring).
        replace (S n - S n)%nat with O by lia. replace (n - n)%nat with O by lia. cbn [pow]. ring.
      * rewrite IH by lia. replace (n - j)%nat with (S (n - S j)) by lia.
        replace (S n - S j)%nat with (S (n - S j)) by lia. cbn [pow]. ring.
Qed.
Lemma basis_bernstein a b i k : (0 <= i <= k)%Z ->
  basis a b [1] i k = binom (IZR k) i * b ^ Z.to_nat i * a ^ Z.to_nat (k - i).
Proof.
  intros H. unfold basis, binom. cbn [length]. destruct (Z.leb_spec 0 i); [|lia].
  replace (Z.to_nat (k - (Z.of_nat 1 - 1))) with (Z.to_nat k) by lia.
  rewrite <- (Z2Nat.id i) at 1 by lia. rewrite bernstein by lia.
  rewrite INR_IZR_INZ, Z2Nat.id by lia. replace (Z.to_nat k - Z.to_nat i)%nat with (Z.to_nat (k - i)) by lia. reflexivity.
Qed.
Lemma natural_power x i : (0 <= i)%Z -> powerRZ x i = x ^ Z.to_nat i.
Proof. intro H. rewrite <- (Z2Nat.id i) at 1 by exact H. symmetry. apply pow_powerRZ. Qed.
Lemma binom_absorbed m i : (0 <= i)%Z -> binom (IZR m + 1) i * (IZR m + 1 - IZR i) = binom (IZR m) i * (IZR m + 1).
Proof.
  intro H. unfold binom. destruct (Z.leb_spec 0 i); [|lia]. rewrite <- (absorbed (IZR m) (Z.to_nat i)).
  rewrite INR_IZR_INZ, Z2Nat.id by exact H. reflexivity.
Qed.
Lemma binom_lowered m i : (0 <= i)%Z -> binom (IZR m + 1) (i + 1) * (IZR i + 1) = (IZR m + 1) * binom (IZR m) i.
Proof.
  intro H. unfold binom. destruct (Z.leb_spec 0 i); [|lia]. destruct (Z.leb_spec 0 (i + 1)); [|lia].
  replace (Z.to_nat (i + 1)) with (S (Z.to_nat i)) by lia. rewrite <- lowered, S_INR.
  rewrite INR_IZR_INZ, Z2Nat.id by exact H. reflexivity.
Qed.

(* ---- sums ---- *)
Theorem curve_bernstein a b k P :
  sum 0 k (fun i => basis a b [1] i k * P i) =
  sum 0 k (fun i => binom (IZR k) i * powerRZ b i * powerRZ a (k - i) * P i).
Proof.
  apply sum_ext. intros i H. rewrite basis_bernstein by exact H. rewrite !natural_power by lia. reflexivity.
Qed.

(* ---- the degree ---- *)
Theorem raised x i m : (0 <= i <= m)%Z ->
  (IZR m + 1) * basis (1 - x) x [1] i m =
  (IZR m + 1 - IZR i) * basis (1 - x) x [1] i (m + 1) + (IZR i + 1) * basis (1 - x) x [1] (i + 1) (m + 1).
Proof.
  intro H. rewrite !basis_bernstein by lia. rewrite plus_IZR.
  replace (Z.to_nat (m + 1 - i)) with (S (Z.to_nat (m - i))) by lia.
  replace (Z.to_nat (m + 1 - (i + 1))) with (Z.to_nat (m - i)) by lia.
  replace (Z.to_nat (i + 1)) with (S (Z.to_nat i)) by lia. cbn [pow].
  pose proof (binom_absorbed m i) as A. pose proof (binom_lowered m i) as B. rewrite Rplus_comm in A.
  assert (A' := A ltac:(lia)). assert (B' := B ltac:(lia)).
  replace (IZR m + IZR 1) with (IZR m + 1) by reflexivity. rewrite (Rplus_comm 1) in A'.
  transitivity ((binom (IZR m + 1) i * (IZR m + 1 - IZR i)) * x ^ Z.to_nat i * ((1 - x) * (1 - x) ^ Z.to_nat (m - i)) +
    (binom (IZR m + 1) (i + 1) * (IZR i + 1)) * (x * x ^ Z.to_nat i) * (1 - x) ^ Z.to_nat (m - i)); [|ring].
  rewrite A', B'. ring.
Qed.
Theorem lower_index x i m : (1 <= i <= m)%Z ->
  IZR i * basis (1 - x) x [1] i m = IZR m * x * basis (1 - x) x [1] (i - 1) (m - 1).
Proof.
  intro H. rewrite !basis_bernstein by lia. pose proof (binom_lowered (m - 1) (i - 1)) as B.
  rewrite !minus_IZR in B. replace (IZR m - 1 + 1) with (IZR m) in B by ring. replace (IZR i - 1 + 1) with (IZR i) in B by ring.
  replace (i - 1 + 1)%Z with i in B by lia. assert (B' := B ltac:(lia)). rewrite minus_IZR.
  replace (m - 1 - (i - 1))%Z with (m - i)%Z by lia.
  replace (Z.to_nat i) with (S (Z.to_nat (i - 1))) by lia. cbn [pow].
  transitivity ((binom (IZR m) i * IZR i) * (x * x ^ Z.to_nat (i - 1)) * (1 - x) ^ Z.to_nat (m - i)); [ring|].
  rewrite B'. ring.
Qed.
Theorem linear_precision x m : (1 <= m)%Z -> sum 0 m (fun i => IZR i / IZR m * basis (1 - x) x [1] i m) = x.
Proof.
  intro H. assert (N : IZR m <> 0) by (apply not_0_IZR; lia). rewrite sum_first by lia.
  rewrite (sum_ext (0 + 1) m _ (fun i => x * basis (1 - x) x [1] (i - 1) (m - 1))).
  - rewrite sum_scal. pose proof (sum_shift 0 (m - 1) 1 (fun i => basis (1 - x) x [1] (i - 1) (m - 1))) as E.
    replace (m - 1 + 1)%Z with m in E by lia. rewrite E.
    rewrite (sum_ext 0 (m - 1) _ (fun i => basis (1 - x) x [1] i (m - 1))) by (intros; f_equal; lia).
    rewrite unity_of_one by (lia || lra). unfold Rdiv. ring.
  - intros i I. pose proof (lower_index x i m ltac:(lia)) as L.
    apply Rmult_eq_reg_l with (IZR m); [|exact N].
    replace (IZR m * (IZR i / IZR m * basis (1 - x) x [1] i m)) with (IZR i * basis (1 - x) x [1] i m) by (field; exact N).
    rewrite L. ring.
Qed.
Theorem curve_raised x m P : (0 <= m)%Z ->
  sum 0 m (fun i => basis (1 - x) x [1] i m * P i) =
  sum 0 (m + 1) (fun i => basis (1 - x) x [1] i (m + 1) * (IZR i / (IZR m + 1) * P (i - 1)%Z + (1 - IZR i / (IZR m + 1)) * P i)).
Proof.
  intro H. assert (N : IZR m + 1 <> 0) by (rewrite <- plus_IZR; apply not_0_IZR; lia).
  set (B := fun i => basis (1 - x) x [1] i (m + 1)).
  rewrite (sum_ext 0 m _ (fun i => B i * ((1 - IZR i / (IZR m + 1)) * P i) + B (i + 1)%Z * (IZR (i + 1) / (IZR m + 1) * P i))).
  - rewrite sum_plus.
    rewrite (sum_ext 0 (m + 1) _ (fun i => B i * ((1 - IZR i / (IZR m + 1)) * P i) + B i * (IZR i / (IZR m + 1) * P (i - 1)%Z)))
      by (intros; unfold B; ring).
    rewrite sum_plus. f_equal.
    + rewrite (sum_last 0 (m + 1)) by lia. replace (m + 1 - 1)%Z with m by lia. rewrite plus_IZR.
      replace (1 - (IZR m + 1) / (IZR m + 1)) with 0 by (field; exact N). ring.
    + rewrite (sum_first 0 (m + 1)) by lia.
      pose proof (sum_shift 0 m 1 (fun i => B i * (IZR i / (IZR m + 1) * P (i - 1)%Z))) as E. rewrite E.
      replace (0 / (IZR m + 1)) with 0 by (field; exact N).
      cbv beta.
      assert (F : sum 0 m (fun i => B (i + 1)%Z * (IZR (i + 1) / (IZR m + 1) * P i)) =
        sum 0 m (fun i => B (i + 1)%Z * (IZR (i + 1) / (IZR m + 1) * P (i + 1 - 1)%Z)))
        by (apply sum_ext; intros j J; replace (j + 1 - 1)%Z with j by lia; reflexivity).
      rewrite F. ring.
  - intros i I. pose proof (raised x i m I) as R. unfold B. rewrite plus_IZR.
    apply Rmult_eq_reg_l with (IZR m + 1); [|exact N].
    replace ((IZR m + 1) * (basis (1 - x) x [1] i m * P i)) with (((IZR m + 1) * basis (1 - x) x [1] i m) * P i) by ring.
    rewrite R. field. exact N.
Qed.

(* ---- the derivative ---- *)
Lemma one_of_one a b s i k : (0 <= k)%Z -> basis a b [s] i k = pw a b (Z.to_nat k) (seed3 s 0 0 (unit i)).
Proof.
  intro H. rewrite <- curve1 by exact H. rewrite (unit_sum i (fun i => basis a b [s] i k)).
  destruct (Z.leb_spec 0 i), (Z.leb_spec i k); cbn [andb]; try reflexivity;
    first [apply basis_below; lia | apply basis_above; cbn [length]; lia].
Qed.
Lemma pw_const_zero a b n : forall Q, (forall i, Q i = 0) -> pw a b n Q = 0.
Proof.
  induction n as [|n IH]; intros Q H; cbn [pw]; [apply H|]. rewrite !IH by (intro; apply H). ring.
Qed.
Theorem rate x i m : (1 <= m)%Z ->
  Derive_n (fun x => basis (1 - x) x [1] i m) 1 x =
  IZR m * (basis (1 - x) x [1] (i - 1) (m - 1) - basis (1 - x) x [1] i (m - 1)).
Proof.
  intro H. rewrite (derive_as _ (Se (K 1) (K 0) (K 0) m (unit i)) 1 x).
  - cbv beta iota zeta delta [ev dxn dx occurs orb].
    rewrite (one_of_one _ _ _ (i - 1)), (one_of_one _ _ _ i) by lia. rewrite Z.max_l by lia.
    rewrite <- pw_minus, (pw_const_zero (1 - x) x (Z.to_nat m)) by (intro; unfold seed3; ring).
    rewrite Rplus_0_r. f_equal. apply pw_ext. intro j. unfold seed3, dl.
    replace (unit i (j + 1)) with (unit (i - 1) j); [ring|].
    unfold unit. destruct (Z.eqb_spec j (i - 1)), (Z.eqb_spec (j + 1) i); try reflexivity; lia.
  - intro t. cbv beta iota delta [ev]. apply one_of_one. lia.
  - cbv beta iota delta [ok]. repeat split.
Qed.
Theorem binomial_form k x Q : (2 <= k)%Z ->
  sum 0 (k - 2) (fun i => binom (IZR k - 2) i * powerRZ x i * powerRZ (1 - x) (k - 2 - i) * Q i) =
  pw (1 - x) x (Z.to_nat (k - 2)) Q.
Proof.
  intro H. transitivity (sum 0 (k - 2) (fun i => basis (1 - x) x [1] i (k - 2) * Q i)).
  - rewrite curve_bernstein. rewrite minus_IZR. reflexivity.
  - rewrite curve1 by lia. apply pw_ext. intro. unfold seed3. ring.
Qed.
Lemma from_one k f : sum 1 (k - 1) f = sum 0 (k - 2) (fun i => f (i + 1)%Z).
Proof. rewrite <- (sum_shift 0 (k - 2) 1 f). f_equal; lia. Qed.
