(* Equations between linear combinations of curves: nobody has to read it.
   All curves of a combination are brought to one number of steps, and the combination to one curve of combined points. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums.
From Coq Require Import Lra Lia.
Open Scope R_scope.

Lemma pw_down a b n Q : (0 < n)%Z ->
  pw a b (Z.to_nat n) Q = a * pw a b (Z.to_nat (n - 1)) Q + b * pw a b (Z.to_nat (n - 1)) (fun i => Q (i + 1)%Z).
Proof. intro H. replace (Z.to_nat n) with (S (Z.to_nat (n - 1))) by lia. reflexivity. Qed.
Lemma pw_opp a b n Q : pw a b n (fun i => - Q i) = - pw a b n Q.
Proof. rewrite (pw_ext a b n _ (fun i => -1 * Q i)) by (intro; ring). rewrite pw_scal. ring. Qed.
Lemma pw_scal_right a b n c Q : pw a b n (fun i => Q i * c) = pw a b n Q * c.
Proof. rewrite (pw_ext a b n _ (fun i => c * Q i)) by (intro; ring). rewrite pw_scal. ring. Qed.
Lemma sum_reverse k f : sum 0 k f = sum 0 k (fun i => f (k - i)%Z).
Proof.
  destruct (Z_lt_le_dec k 0) as [H|H]; [rewrite !sum_empty by exact H; reflexivity|].
  rewrite <- (Z2Nat.id k H). generalize (Z.to_nat k). clear k H. intro n. induction n as [|n IH].
  - unfold sum. cbn. reflexivity.
  - rewrite sum_last by lia. rewrite (sum_first 0 (Z.of_nat (S n)) (fun i => f (Z.of_nat (S n) - i)%Z)) by lia.
    replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia. rewrite IH.
    replace (Z.of_nat (S n)) with (Z.of_nat n + 1)%Z at 3 by lia. rewrite (sum_shift 0 (Z.of_nat n) 1).
    replace (Z.of_nat (S n) - 0)%Z with (Z.of_nat (S n)) by lia. rewrite Rplus_comm. f_equal.
    apply sum_ext. intros i Hi. f_equal. lia.
Qed.

(* one number of steps *)
Ltac lowered := repeat match goal with
  | |- context [pw ?a ?b (Z.to_nat ?n) ?Q] =>
      match goal with |- context [pw _ _ (Z.to_nat ?m) _] =>
        lazymatch m with n => fail | _ => idtac end;
        first [ assert (n = m) as -> by lia
              | assert (m < n)%Z by lia; rewrite (pw_down a b n Q) by lia;
                try replace (n - 1)%Z with m by lia ]
      end
  end.
(* the points of the one curve that a combination is *)
Ltac points a b n t := lazymatch t with
  | pw a b n ?Q => Q
  | ?x + ?y => let X := points a b n x in let Y := points a b n y in
      constr:(fun i : Z => ltac:(let t := eval cbv beta in (X i + Y i) in exact t))
  | ?x - ?y => let X := points a b n x in let Y := points a b n y in
      constr:(fun i : Z => ltac:(let t := eval cbv beta in (X i - Y i) in exact t))
  | - ?x => let X := points a b n x in constr:(fun i : Z => ltac:(let t := eval cbv beta in (- X i) in exact t))
  | ?x * ?y => lazymatch y with
      | context [pw] => let Y := points a b n y in
          constr:(fun i : Z => ltac:(let t := eval cbv beta in (x * Y i) in exact t))
      | _ => let X := points a b n x in
          constr:(fun i : Z => ltac:(let t := eval cbv beta in (X i * y) in exact t)) end
  | ?x / ?y => let X := points a b n x in
      constr:(fun i : Z => ltac:(let t := eval cbv beta in (X i * / y) in exact t))
  end.
Ltac spread := repeat first
  [ rewrite pw_plus | rewrite pw_minus | rewrite pw_opp | rewrite pw_scal | rewrite pw_scal_right ].
Ltac gathered a b n t := lazymatch t with
  | pw a b n _ => idtac
  | _ => let Q := points a b n t in
      replace t with (pw a b n Q) by
        (let E := fresh in assert (E : pw a b n Q = t); [spread; unfold Rdiv; try reflexivity; ring|exact E])
  end.
Ltac one_curve := lowered;
  match goal with |- ?l = ?r =>
    match constr:((l, r)) with context [pw ?a ?b ?n _] =>
      gathered a b n l; gathered a b n r; apply pw_ext; let i := fresh "i" in intro i; unfold seed3, dl; cbv beta;
      members; special; maxes; numbers; members; exponentials; circles; roots; equal
    end
  end.
(* from the other end *)
Ltac turned1 := match goal with |- sum 0 ?k _ = sum 0 ?k _ => rewrite (sum_reverse k) end;
  apply sum_ext; intros; cbv beta; members;
  match goal with |- basis _ _ _ _ _ * ?p = _ * ?q =>
    replace p with q by (first [reflexivity | f_equal; lia | apply sum_ext; intros; f_equal; f_equal; lia]); f_equal end;
  mirrored'.
Ltac turned := first
  [ turned1
  | match goal with |- sum ?l ?h ?f = sum ?l ?h _ => lazymatch f with context [sum] => idtac end end;
    apply sum_ext; intros; cbv beta; f_equal; turned ].
(* double sums in the other order *)
Ltac swapped := rewrite sum_swap; apply sum_ext; intros; cbv beta; rewrite <- ?sum_scal; apply sum_ext; intros; ring.

(* ---- functions of bases ---- *)
Lemma first_of_three a b s t u i : fam a b [s; t; u] O i = s * unit 0 i + t * unit 1 i + u * unit 2 i.
Proof.
  cbn [fam]. destruct (Z.leb_spec 0 i).
  - destruct (Z.eq_dec i 0) as [->|]; [unfold unit; compute_goal; ring|].
    destruct (Z.eq_dec i 1) as [->|]; [unfold unit; compute_goal; ring|].
    destruct (Z.eq_dec i 2) as [->|]; [unfold unit; compute_goal; ring|].
    rewrite !unit_zero by lia. rewrite nth_overflow by (cbn [length]; lia). ring.
  - rewrite !unit_zero by lia. ring.
Qed.
Ltac function_at_end := first [ rewrite basis_at0 | rewrite basis_at1 by (cbn [length]; lia) ];
  cbn [length]; rewrite first_of_three; special; units; ring.
(* seeds that are steps themselves *)
Lemma fam_step a b ss ss' : (forall i, fam a b ss' O i = fam a b ss 1 i) -> forall n i, fam a b ss' n i = fam a b ss (S n) i.
Proof.
  intros H n. induction n as [|n IH]; intro i; [apply H|].
  change (a * fam a b ss' n i + b * fam a b ss' n (i - 1) = fam a b ss (S (S n)) i). rewrite !IH. reflexivity.
Qed.
Lemma two_of_three a b s t i k : (2 <= k)%Z -> basis a b [a * s; a * t + b * s; b * t] i k = basis a b [s; t] i k.
Proof.
  intro K. unfold basis. cbn [length]. replace (Z.to_nat (k - (Z.of_nat 2 - 1))) with (S (Z.to_nat (k - (Z.of_nat 3 - 1)))) by lia.
  apply fam_step. clear. intro i. rewrite first_of_three. cbn [fam].
  destruct (Z.leb_spec 0 i), (Z.leb_spec 0 (i - 1)); try lia.
  - destruct (Z.eq_dec i 1) as [->|]; [unfold unit; compute_goal; ring|].
    destruct (Z.eq_dec i 2) as [->|]; [unfold unit; compute_goal; ring|].
    rewrite !unit_zero by lia. rewrite !nth_overflow by (cbn [length]; lia). ring.
  - replace i with 0%Z by lia. unfold unit. compute_goal. ring.
  - rewrite !unit_zero by lia. ring.
Qed.
Lemma one_of_two a b s i k : (1 <= k)%Z -> basis a b [a * s; b * s] i k = basis a b [s] i k.
Proof.
  intro K. unfold basis. cbn [length]. replace (Z.to_nat (k - (Z.of_nat 1 - 1))) with (S (Z.to_nat (k - (Z.of_nat 2 - 1)))) by lia.
  apply fam_step. clear. intro i. cbn [fam].
  destruct (Z.leb_spec 0 i), (Z.leb_spec 0 (i - 1)); try lia.
  - destruct (Z.eq_dec i 1) as [->|]; [compute_goal; ring|]. rewrite !nth_overflow by (cbn [length]; lia). ring.
  - replace i with 0%Z by lia. compute_goal. ring.
  - ring.
Qed.
Ltac fewer_seeds := match goal with
  | |- basis ?a ?b [?p; ?q; ?r] ?i ?k = basis ?a ?b [?s; ?t] ?i ?k =>
      rewrite <- (two_of_three a b s t i k) by lia; f_equal; repeat (apply f_equal2; [ring|]); reflexivity
  | |- basis ?a ?b [?p; ?q; ?r] ?i ?k = basis ?a ?b [?s] ?i ?k =>
      rewrite <- (one_of_two a b s i k) by lia; rewrite <- (two_of_three a b (a * s) (b * s) i k) by lia;
      f_equal; repeat (apply f_equal2; [ring|]); reflexivity
  end.
(* the step, and the same from the other end *)
Ltac stepped := match goal with |- ?a * basis ?a ?b ?s ?i (?k - 1) + ?b * basis ?a ?b ?s (?i - 1) (?k - 1) = _ =>
  rewrite <- (basis_step a b s i k) by (cbn [length]; lia) end; mirrored'.

(* curves at a parameter are compared as curves, at the ends by their points *)
Ltac curves_or_points := tryif (match goal with |- context [pw (1 - ?x) ?x _ _] => is_var x end)
  then first [one_curve | settle] else settle.
Ltac symbolic ::= computed; intros; equations; substituted; divisors; parts; intros; equations; closed_parts;
  first
  [ turned | swapped | fewer_seeds | function_at_end | stepped | not_negative
  | sums; closed_parts;
    lazymatch goal with
    | |- context [Derive_n _ _ _] => derivatives; operators; curves_or_points
    | |- context [sum _ _ _] => first [ ring | unities | operators; curves_or_points | symbolic1 ]
    | _ => first [ ring | symbolic1 ]
    end ].
