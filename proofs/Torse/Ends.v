(* Curves of blended trigonometric functions at the ends of their interval, for every degree, with the derivatives up to the
   third: nobody has to read it. Statements about joins speak of nothing else, and each value is computed once here. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Smooth.
From Coq Require Import Lia.
Open Scope R_scope.

(* function i of degree k at x *)
Local Notation blend mu nu x i k := (basis (1 - x) x
  [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x));
   1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x));
   (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k) (only parsing).
Local Notation curve P k mu nu x := (sum 0 k (fun i => blend mu nu x i k * P i)) (only parsing).

(* from behind *)
Lemma pw_mirror a b n : forall Q, pw a b n Q = pw b a n (fun i => Q (Z.of_nat n - i)%Z).
Proof.
  induction n as [|n IH]; intro Q; [reflexivity|]. cbn [pw]. rewrite (IH Q), (IH (fun i => Q (i + 1)%Z)), Rplus_comm.
  f_equal; f_equal; apply pw_ext; intro i; f_equal; lia.
Qed.
Lemma curve_mirror P k mu nu x : (2 <= k)%Z -> curve P k mu nu x = curve (fun i => P (k - i)%Z) k nu mu (1 - x).
Proof.
  intro K. rewrite !series3 by exact K.
  replace (PI / 2 * (1 - x)) with (PI / 2 - PI / 2 * x) by field. rewrite sin_shift, cos_shift.
  replace (1 - (1 - x)) with x by ring. rewrite pw_mirror. apply pw_ext. intro i. unfold seed3.
  replace (Z.of_nat (Z.to_nat (k - 2)) - i)%Z with (k - (i + 2))%Z by lia.
  replace (k - (i + 2) + 1)%Z with (k - (i + 1))%Z by lia. replace (k - (i + 2) + 2)%Z with (k - i)%Z by lia. ring.
Qed.
Lemma rate_mirror f n : smooth f -> Derive_n (fun x => f (1 - x)) n 1 = (-1) ^ n * Derive_n f n 0.
Proof.
  intro F. rewrite (Derive_n_ext _ (fun x => f (- x + 1))) by (intro; f_equal; ring).
  rewrite (Derive_n_comp_opp (fun x => f (x + 1))).
  - rewrite Derive_n_comp_trans. do 2 f_equal. ring.
  - apply filter_forall. intros y m _. apply ex_derive_n_comp_trans, F.
Qed.
Lemma curve_rate_mirror P k mu nu n : (2 <= k)%Z -> Derive_n (fun x => curve P k mu nu x) n 1 =
  (-1) ^ n * Derive_n (fun x => curve (fun i => P (k - i)%Z) k nu mu x) n 0.
Proof.
  intro K. rewrite (Derive_n_ext _ _ n 1 (fun x => curve_mirror P k mu nu x K)).
  apply (rate_mirror (fun x => curve (fun i => P (k - i)%Z) k nu mu x)). smooth_curves.
Qed.

Section Ends.
Variables (P : Z -> R) (k : Z) (mu nu : R).
Hypothesis K : (2 <= k)%Z.
Lemma start_value : curve P k mu nu 0 = P 0%Z.
Proof. clear -K. symbolic. Qed.
Lemma end_value : curve P k mu nu 1 = P k.
Proof. clear -K. symbolic. Qed.
Lemma start_rate : Derive_n (fun x => curve P k mu nu x) 1 0 = (IZR k - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z).
Proof. clear -K. symbolic. Qed.
Lemma end_rate : Derive_n (fun x => curve P k mu nu x) 1 1 = (IZR k - 2 + PI / 2 * (1 + nu)) * (P k - P (k - 1)%Z).
Proof. clear -K. symbolic. Qed.
Lemma start_second : Derive_n (fun x => curve P k mu nu x) 2 0 =
  ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z
  + (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z
  + ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) * P 2%Z.
Proof. clear -K. symbolic. Qed.
Lemma start_third : Derive_n (fun x => curve P k mu nu x) 3 0 =
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4 + 3 * (PI / 2) * (1 + mu)) * (P 3%Z - 3 * P 2%Z + 3 * P 1%Z - P 0%Z)
  + 3 * (IZR k - 2) * (PI / 2) ^ 2 * ((1 - nu) * (P 3%Z - 2 * P 2%Z + P 1%Z) - 2 * mu * (P 2%Z - 2 * P 1%Z + P 0%Z))
  - (1 + mu) * (PI / 2) ^ 3 * (P 1%Z - P 0%Z).
Proof. clear -K. symbolic. Qed.
End Ends.
Section Mirrored.
Variables (P : Z -> R) (k : Z) (mu nu : R).
Hypothesis K : (2 <= k)%Z.
Lemma end_second : Derive_n (fun x => curve P k mu nu x) 2 1 =
  ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2) * P k
  + (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2) * P (k - 1)%Z
  + ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) * P (k - 2)%Z.
Proof. rewrite curve_rate_mirror by exact K. rewrite (start_second _ k nu mu K), Z.sub_0_r. ring. Qed.
Lemma end_third : Derive_n (fun x => curve P k mu nu x) 3 1 =
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4 + 3 * (PI / 2) * (1 + nu)) * (P k - 3 * P (k - 1)%Z + 3 * P (k - 2)%Z - P (k - 3)%Z)
  - 3 * (IZR k - 2) * (PI / 2) ^ 2 * ((1 - mu) * (P (k - 1)%Z - 2 * P (k - 2)%Z + P (k - 3)%Z) - 2 * nu * (P k - 2 * P (k - 1)%Z + P (k - 2)%Z))
  - (1 + nu) * (PI / 2) ^ 3 * (P k - P (k - 1)%Z).
Proof. rewrite curve_rate_mirror by exact K. rewrite (start_third _ k nu mu K), Z.sub_0_r. ring. Qed.
End Mirrored.

(* a cubic curve whose four terms are written out *)
Local Notation cubic mu nu a b c d x :=
  (blend mu nu x 0%Z 3%Z * a + blend mu nu x 1%Z 3%Z * b + blend mu nu x 2%Z 3%Z * c + blend mu nu x 3%Z 3%Z * d) (only parsing).
Section Cubic.
Variables mu nu a b c d : R.
Let P (i : Z) : R := nth (Z.to_nat i) [a; b; c; d] 0.
Lemma four f : f 0%Z * a + f 1%Z * b + f 2%Z * c + f 3%Z * d = sum 0 3 (fun i => f i * P i).
Proof. unfold P. compute_goal. ring. Qed.
Ltac as_curve E := eapply eq_trans; [first [apply (four (fun i => blend mu nu _ i 3%Z)) | apply Derive_n_ext; intro; apply (four (fun i => blend mu nu _ i 3%Z))] |];
  rewrite E by lia; unfold P; compute_goal; field.
Lemma cubic_start_value : cubic mu nu a b c d 0 = a.
Proof. as_curve start_value. Qed.
Lemma cubic_end_value : cubic mu nu a b c d 1 = d.
Proof. as_curve end_value. Qed.
Lemma cubic_start_rate : Derive_n (fun x => cubic mu nu a b c d x) 1 0 = (1 + PI / 2 * (1 + mu)) * (b - a).
Proof. as_curve start_rate. Qed.
Lemma cubic_end_rate : Derive_n (fun x => cubic mu nu a b c d x) 1 1 = (1 + PI / 2 * (1 + nu)) * (d - c).
Proof. as_curve end_rate. Qed.
Lemma cubic_start_second : Derive_n (fun x => cubic mu nu a b c d x) 2 0 =
  (PI * (1 + mu) + 2 * mu * (PI / 2) ^ 2) * a - (2 * PI * (1 + mu) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * b
  + (PI * (1 + mu) + (1 - nu) * (PI / 2) ^ 2) * c.
Proof. as_curve start_second. Qed.
Lemma cubic_end_second : Derive_n (fun x => cubic mu nu a b c d x) 2 1 =
  (PI * (1 + nu) + 2 * nu * (PI / 2) ^ 2) * d - (2 * PI * (1 + nu) + (2 * nu + 1 - mu) * (PI / 2) ^ 2) * c
  + (PI * (1 + nu) + (1 - mu) * (PI / 2) ^ 2) * b.
Proof. as_curve end_second. Qed.
Lemma cubic_start_third : Derive_n (fun x => cubic mu nu a b c d x) 3 0 =
  3 * (PI / 2) ^ 2 * ((1 - nu) * (d - 2 * c + b) - 2 * mu * (c - 2 * b + a)) - (1 + mu) * (PI / 2) ^ 3 * (b - a).
Proof. as_curve start_third. Qed.
Lemma cubic_end_third : Derive_n (fun x => cubic mu nu a b c d x) 3 1 =
  - (3 * (PI / 2) ^ 2 * ((1 - mu) * (c - 2 * b + a) - 2 * nu * (d - 2 * c + b))) - (1 + nu) * (PI / 2) ^ 3 * (d - c).
Proof. as_curve end_third. Qed.
End Cubic.

(* the same for points and planes: lists of numbers *)
Lemma nth_vadd u : forall v i, length v = length u -> nth i (vadd u v) 0 = nth i u 0 + nth i v 0.
Proof.
  induction u as [|x u IH]; intros [|y v] i L; try discriminate L; [destruct i; cbn; ring|].
  destruct i as [|i]; [reflexivity|]. apply (IH v i). injection L. auto.
Qed.
Lemma nth_vscale c u i : nth i (vscale c u) 0 = c * nth i u 0.
Proof. unfold vscale. replace 0 with (c * 0) at 1 by ring. apply map_nth. Qed.
Lemma vadd_length u : forall v, length v = length u -> length (vadd u v) = length u.
Proof. induction u as [|x u IH]; intros [|y v] L; try discriminate L; [reflexivity|]. cbn. f_equal. apply (IH v). injection L. auto. Qed.
Lemma vscale_length c u : length (vscale c u) = length u.
Proof. apply map_length. Qed.
Lemma entries_equal u : forall v, length u = length v -> (forall i, nth i u 0 = nth i v 0) -> u = v.
Proof. intros v L E. apply (nth_ext _ _ 0 0 L). auto. Qed.
Local Notation cubic_vector mu nu a b c d x := (vadd (vadd (vadd (vscale (blend mu nu x 0%Z 3%Z) a) (vscale (blend mu nu x 1%Z 3%Z) b))
  (vscale (blend mu nu x 2%Z 3%Z) c)) (vscale (blend mu nu x 3%Z 3%Z) d)) (only parsing).
Ltac lengths := repeat first [ rewrite vadd_length | rewrite vscale_length ].
Section Vectors.
Variables (mu nu : R) (a b c d : list R).
Hypotheses (B : length b = length a) (C : length c = length a) (D : length d = length a).
Let coordinate i r s t u : nth i (vadd (vadd (vadd (vscale r a) (vscale s b)) (vscale t c)) (vscale u d)) 0 =
  r * nth i a 0 + s * nth i b 0 + t * nth i c 0 + u * nth i d 0.
Proof. rewrite !nth_vadd, !nth_vscale; lengths; congruence. Qed.
Let rate_vector (w : R) (u v : list R) : length u = length a -> length v = length a ->
  map (fun i => w * (nth i u 0 - nth i v 0)) (seq 0 (length a)) = vscale w (vsub u v).
Proof.
  intros <-. clear. revert v. induction u as [|x u IH]; intros [|y v] L; try discriminate L; [reflexivity|].
  cbn [length seq map]. rewrite <- seq_shift, map_map. cbn. f_equal. apply (IH v). injection L. auto.
Qed.
Lemma vector_start_value : cubic_vector mu nu a b c d 0 = a.
Proof.
  apply entries_equal; [lengths; congruence|].
  intro i. rewrite coordinate. apply cubic_start_value.
Qed.
Lemma vector_end_value : cubic_vector mu nu a b c d 1 = d.
Proof.
  apply entries_equal; [lengths; congruence|].
  intro i. rewrite coordinate. apply cubic_end_value.
Qed.
Lemma vector_start_rate n : n = length a ->
  vDerive n (fun x => cubic_vector mu nu a b c d x) 1 0 = vscale (1 + PI / 2 * (1 + mu)) (vsub b a).
Proof.
  intros ->. rewrite <- rate_vector by congruence. apply map_ext. intro i.
  rewrite <- (cubic_start_rate mu nu (nth i a 0) (nth i b 0) (nth i c 0) (nth i d 0)). apply Derive_n_ext. intro x. apply coordinate.
Qed.
Lemma vector_end_rate n : n = length a ->
  vDerive n (fun x => cubic_vector mu nu a b c d x) 1 1 = vscale (1 + PI / 2 * (1 + nu)) (vsub d c).
Proof.
  intros ->. rewrite <- rate_vector by congruence. apply map_ext. intro i.
  rewrite <- (cubic_end_rate mu nu (nth i a 0) (nth i b 0) (nth i c 0) (nth i d 0)). apply Derive_n_ext. intro x. apply coordinate.
Qed.
End Vectors.

(* ---- in statements ---- *)
(* an equation whose left side stands in the goal word for word *)
Ltac put L := let E := fresh in pose proof L as E; cbv beta in E; lazymatch type of E with ?l = ?r =>
  pattern l; lazymatch goal with |- ?F _ => refine (@eq_ind_r _ r F _ l E) end end; cbv beta; clear E.
Ltac curve_at_end := match goal with
  | |- context [sum 0 ?k (fun i => blend ?mu ?nu ?x i ?k * @?P i)] => lazymatch x with
      | 0 => put (start_value P k mu nu ltac:(assumption || lia))
      | 1 => put (end_value P k mu nu ltac:(assumption || lia))
      end
  | |- context [Derive_n (fun x => sum 0 ?k (fun i => blend ?mu ?nu x i ?k * @?P i)) ?n ?x] => lazymatch constr:((n, x)) with
      | (1%nat, 0) => put (start_rate P k mu nu ltac:(assumption || lia))
      | (1%nat, 1) => put (end_rate P k mu nu ltac:(assumption || lia))
      | (2%nat, 0) => put (start_second P k mu nu ltac:(assumption || lia))
      | (2%nat, 1) => put (end_second P k mu nu ltac:(assumption || lia))
      | (3%nat, 0) => put (start_third P k mu nu ltac:(assumption || lia))
      | (3%nat, 1) => put (end_third P k mu nu ltac:(assumption || lia))
      end
  | |- context [blend ?mu ?nu ?x 0%Z 3%Z * ?a + basis _ _ _ 1 3 * ?b + basis _ _ _ 2 3 * ?c + basis _ _ _ 3 3 * ?d] =>
      lazymatch x with
      | 0 => put (cubic_start_value mu nu a b c d)
      | 1 => put (cubic_end_value mu nu a b c d)
      end
  | |- context [Derive_n (fun x => blend ?mu ?nu x 0%Z 3%Z * ?a + basis _ _ _ 1 3 * ?b + basis _ _ _ 2 3 * ?c + basis _ _ _ 3 3 * ?d) ?n ?x] =>
      lazymatch constr:((n, x)) with
      | (1%nat, 0) => put (cubic_start_rate mu nu a b c d)
      | (1%nat, 1) => put (cubic_end_rate mu nu a b c d)
      | (2%nat, 0) => put (cubic_start_second mu nu a b c d)
      | (2%nat, 1) => put (cubic_end_second mu nu a b c d)
      | (3%nat, 0) => put (cubic_start_third mu nu a b c d)
      | (3%nat, 1) => put (cubic_end_third mu nu a b c d)
      end
  end.
(* single functions of the basis are curves *)
Lemma member mu nu i k x : (2 <= k)%Z -> blend mu nu x i k = curve (unit i) k mu nu x.
Proof. intro K. rewrite one_of_three, series3 by exact K. reflexivity. Qed.
Lemma rate_of_member mu nu i k n p : (2 <= k)%Z ->
  Derive_n (fun x => blend mu nu x i k) n p = Derive_n (fun x => curve (unit i) k mu nu x) n p.
Proof. intro K. apply Derive_n_ext. intro x. apply member, K. Qed.
Ltac member_at_end := match goal with
  | |- context [Derive_n (fun x => blend ?mu ?nu x ?i ?k) ?n ?x] =>
      put (rate_of_member mu nu i k n x ltac:(assumption || lia))
  | |- context [blend ?mu ?nu ?x ?i ?k] =>
      put (member mu nu i k x ltac:(assumption || lia))
  end; curve_at_end.
Ltac members_at_ends := repeat member_at_end; units.
(* the same for vectors whose four terms are written out *)
Ltac vector_at_end := match goal with
  | |- context [vadd (vadd (vadd (vscale (blend ?mu ?nu ?x 0%Z 3%Z) ?a) (vscale (basis _ _ _ 1 3) ?b)) (vscale (basis _ _ _ 2 3) ?c))
      (vscale (basis _ _ _ 3 3) ?d)] => lazymatch x with
      | 0 => put (vector_start_value mu nu a b c d eq_refl eq_refl eq_refl)
      | 1 => put (vector_end_value mu nu a b c d eq_refl eq_refl eq_refl)
      end
  | |- context [vDerive ?n (fun x => vadd (vadd (vadd (vscale (blend ?mu ?nu x 0%Z 3%Z) ?a) (vscale (basis _ _ _ 1 3) ?b)) (vscale (basis _ _ _ 2 3) ?c))
      (vscale (basis _ _ _ 3 3) ?d)) 1 ?x] => lazymatch x with
      | 0 => put (vector_start_rate mu nu a b c d eq_refl eq_refl eq_refl n eq_refl)
      | 1 => put (vector_end_rate mu nu a b c d eq_refl eq_refl eq_refl n eq_refl)
      end
  end.
Ltac at_ends := cbv beta; progress (repeat curve_at_end).
(* premises are brought into the goal, and all that was introduced is put back *)
Definition mark := True.
Ltac back := repeat lazymatch goal with x : ?T |- _ => lazymatch T with mark => fail | _ => revert x end end.
Ltac brought := repeat match goal with
  | H : context [sum _ _ _] |- _ => revert H
  end.
Ltac premises_with tactic :=
  let M := fresh in pose proof (I : mark) as M; lists; intros; numbered; brought; tactic; back; clear M.
Ltac curves_at_ends := premises_with at_ends.
(* functions with derivatives of every order, single functions of a basis among them *)
Lemma smooth_member s t u i k : (2 <= k)%Z -> smooth s -> smooth t -> smooth u ->
  smooth (fun x => basis (1 - x) x [s x; t x; u x] i k).
Proof.
  intros K S T U. apply smooth_ext with (fun x => pw (1 - x) x (Z.to_nat (k - 2)) (seed3 (s x) (t x) (u x) (unit i))).
  - intro x. symmetry. apply one_of_three, K.
  - apply (smooth_pw (fun x => 1 - x) (fun x => x) _ ltac:(smooths) ltac:(smooths) (fun j x => seed3 (s x) (t x) (u x) (unit i) j)).
    intro j. unfold seed3. smooths.
Qed.
Ltac smooth_sum := smooths; lazymatch goal with
  | |- smooth (fun x => sum 0 ?k (fun i => basis (1 - x) x [@?s x; @?t x; @?u x] i ?k * @?P i)) =>
      apply (smooth_series s t u k P); [assumption || lia | smooths ..]
  | |- smooth (fun x => basis (1 - x) x [@?s x; @?t x; @?u x] ?i ?k) =>
      apply (smooth_member s t u i k); [assumption || lia | smooths ..]
  end.
Ltac rate_of_both L u v n p :=
  let F := fresh in let G := fresh in
  assert (F : smooth u) by smooth_sum; assert (G : smooth v) by smooth_sum; put (L u v n p F G); clear F G.
(* derivatives of multiples, the factor on either side, and of sums of them, as long as they are no derivatives of curves *)
Ltac multiple := match goal with
  | |- context [Derive_n (fun t => @?u t * ?c) ?n ?p] => put (rate_right c u n p)
  | |- context [Derive_n (fun t => ?c * @?u t) ?n ?p] => put (rate_left c u n p)
  | |- context [Derive_n (fun t => @?u t / ?c) ?n ?p] => put (rate_over c u n p)
  | |- context [Derive_n (fun t => - @?u t) ?n ?p] => put (rate_opp u n p)
  | |- context [Derive_n (fun _ => ?c) (S ?n) ?p] => put (rate_const c n p)
  end.
Ltac sum_of_two := match goal with
  | |- context [Derive_n (fun t => @?u t + @?v t) ?n ?p] => rate_of_both rate_plus u v n p
  | |- context [Derive_n (fun t => @?u t - @?v t) ?n ?p] => rate_of_both rate_minus u v n p
  end.
Ltac undifferentiated := orders; cbv beta; repeat match goal with
  | |- context [Derive_n ?f 0 ?p] => change (Derive_n f 0 p) with (f p); cbv beta
  end.
Ltac spread := undifferentiated; repeat first [ multiple | sum_of_two ].
(* the values and derivatives of sums of curves *)
Ltac ends_of_sums := undifferentiated; repeat first [ curve_at_end | multiple | sum_of_two ].
Ltac sums_at_ends := premises_with ends_of_sums.
(* sums of fixed length written out, the functions of the basis as they are *)
Ltac written_out := cbv beta iota zeta delta
  [sum range vsum vadd vsub vopp vscale vdiv zip zeros entry dot norm cross row vDerive
   map fold_right seq repeat nth length pred Nat.add Nat.sub
   Z.to_nat Z.of_nat Z.add Z.sub Z.opp Z.pos_sub Z.double Z.succ_double Z.pred_double
   Pos.add Pos.succ Pos.pred_double Pos.to_nat Pos.iter_op Pos.of_succ_nat Pos.add_carry].
(* the same below the derivative by a parameter *)
Ltac ends_inside := repeat match goal with
  | |- context [Derive_n ?f ?n ?p] => match f with context [Derive_n] => idtac end;
      let g := fresh "g" in let E := fresh in evar (g : R -> R);
      assert (E : forall t, f t = g t) by (let t := fresh "t" in intro t; ends_of_sums; subst g; reflexivity);
      subst g; rewrite (Derive_n_ext f _ n p E); clear E; cbv beta
  end.
(* the refutation of a statement about curves, by values of its variables *)
Ltac refuting_at_ends H0 := let H := fresh in pose proof H0 as H; cbv beta zeta in H; revert H; lists; ends_inside; ends_of_sums;
  intro H; premises H; compute_in H; revert H; derivatives; special; let C := fresh in intro C; contradiction_in C.
Ltac computed ::= try curves_at_ends; tryif assert_succeeds symbolic_integers then lists else compute_goal.
Ltac evaluated ::= cbv beta; try at_ends; derivatives; operators; ends; special; tidied; maxes; units; members; numbers.

(* ---- the matrices that take points to end values ---- *)
Lemma inverse_lower a b c d e f : det [[a; 0; 0]; [b; c; 0]; [d; e; f]] <> 0 ->
  a <> 0 /\ c <> 0 /\ f <> 0 /\
  inverse [[a; 0; 0]; [b; c; 0]; [d; e; f]] = [[1 / a; 0; 0]; [- b / (a * c); 1 / c; 0]; [(b * e - c * d) / (a * c * f); - e / (c * f); 1 / f]].
Proof.
  intro D. assert (N : a <> 0 /\ c <> 0 /\ f <> 0).
  { revert D. lists. intro D. repeat split; intro Z; apply D; rewrite Z; ring. }
  destruct N as (A & C & F). repeat split; try assumption. compute_goal. parts; field; repeat split; assumption.
Qed.
Section Matrices.
Variables (Q : Z -> R) (k : Z) (mu nu : R).
Hypothesis K : (2 <= k)%Z.
Local Notation by_member i f := (Derive_n (fun t => f (update1 Q i t)) 1 (Q i)) (only parsing).
Lemma start_matrix :
  [[by_member 0%Z (fun Q => curve Q k mu nu 0); by_member 1%Z (fun Q => curve Q k mu nu 0); by_member 2%Z (fun Q => curve Q k mu nu 0)];
   [by_member 0%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0); by_member 1%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0); by_member 2%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0)];
   [by_member 0%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0); by_member 1%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0); by_member 2%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0)]] =
  [[1; 0; 0];
   [- (IZR k - 2 + PI / 2 * (1 + mu)); IZR k - 2 + PI / 2 * (1 + mu); 0];
   [(IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2;
    - (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2;
    (IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2]].
Proof. clear -K. cbv beta. parts; slopes; changed; ring. Qed.
Lemma end_matrix :
  [[by_member k (fun Q => curve Q k mu nu 1); by_member (k - 1)%Z (fun Q => curve Q k mu nu 1); by_member (k - 2)%Z (fun Q => curve Q k mu nu 1)];
   [by_member k (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1); by_member (k - 1)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1); by_member (k - 2)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1)];
   [by_member k (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1); by_member (k - 1)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1); by_member (k - 2)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1)]] =
  [[1; 0; 0];
   [IZR k - 2 + PI / 2 * (1 + nu); - (IZR k - 2 + PI / 2 * (1 + nu)); 0];
   [(IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2;
    - (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2;
    (IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2]].
Proof. clear -K. cbv beta. parts; slopes; changed; ring. Qed.
End Matrices.
Ltac lower E := rewrite E in *;
  match goal with D : det [[?a; 0; 0]; [?b; ?c; 0]; [?d; ?e; ?f]] <> 0 |- _ =>
    let I := fresh in destruct (inverse_lower a b c d e f D) as (? & ? & ? & I); rewrite I; clear I D
  end; cbv beta iota delta [row entry nth pred].
(* the inverse of a matrix [m] of end values, by the lemma that knows the matrix *)
Ltac inverse_of_ends m known := match goal with |- context [m ?Q ?k ?mu ?nu] =>
  let E := fresh in assert (E : m Q k mu nu = _) by (exact (known Q k mu nu ltac:(assumption))); lower E; clear E end.
