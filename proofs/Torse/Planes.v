(* Planes that move: the generators and the spine curve of their envelope. Nobody has to read it.
   Velocities follow from what holds at all times: a point of the surface is on the plane and on its derivative. The planes are
   any smooth functions; in statements they are Taylor polynomials, the first part here. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Smooth.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* Taylor polynomials of planes *)
Lemma smooth_quadratic a b c : smooth (fun e => a + e * b + e ^ 2 / 2 * c).
Proof. apply smooth_ext with (fun e => a + e * b + e * e * (c / 2)); [intro; field|smooths]. Qed.
Lemma smooth_cubic a b c d : smooth (fun e => a + e * b + e ^ 2 / 2 * c + e ^ 3 / 6 * d).
Proof. apply smooth_ext with (fun e => a + e * b + e * e * (c / 2) + e * e * e * (d / 6)); [intro; field|smooths]. Qed.
Lemma smooth_quartic a b c d f : smooth (fun e => a + e * b + e ^ 2 / 2 * c + e ^ 3 / 6 * d + e ^ 4 / 24 * f).
Proof.
  apply smooth_ext with (fun e => a + e * b + e * e * (c / 2) + e * e * e * (d / 6) + e * e * e * e * (f / 24)); [intro; field|smooths].
Qed.
Lemma quartic_rate a b c d f e :
  Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 1 e = b + e * c + e ^ 2 / 2 * d + e ^ 3 / 6 * f.
Proof. apply is_derive_unique. auto_derive; [exact I|field]. Qed.
Lemma cubic_rate a b c d e : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d) 1 e = b + e * c + e ^ 2 / 2 * d.
Proof. apply is_derive_unique. auto_derive; [exact I|field]. Qed.
Lemma quadratic_rate a b c e : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c) 1 e = b + e * c.
Proof. apply is_derive_unique. auto_derive; [exact I|field]. Qed.
Lemma linear_rate a b e : Derive_n (fun t => a + t * b) 1 e = b.
Proof. apply is_derive_unique. auto_derive; [exact I|field]. Qed.
Lemma rate_of_rate f n e : Derive_n f (S n) e = Derive_n (Derive_n f 1) n e.
Proof. replace (S n) with (n + 1)%nat by lia. symmetry. apply Derive_n_comp. Qed.
Lemma quadratic_second a b c e : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c) 2 e = c.
Proof. rewrite rate_of_rate, (Derive_n_ext _ _ 1 e (quadratic_rate a b c)). apply linear_rate. Qed.
Lemma cubic_second a b c d e : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d) 2 e = c + e * d.
Proof. rewrite rate_of_rate, (Derive_n_ext _ _ 1 e (cubic_rate a b c d)). apply quadratic_rate. Qed.
Lemma cubic_third a b c d e : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d) 3 e = d.
Proof. rewrite rate_of_rate, (Derive_n_ext _ _ 2 e (cubic_rate a b c d)). apply quadratic_second. Qed.
Lemma quartic_second a b c d f e :
  Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 2 e = c + e * d + e ^ 2 / 2 * f.
Proof. rewrite rate_of_rate, (Derive_n_ext _ _ 1 e (quartic_rate a b c d f)). apply cubic_rate. Qed.
Lemma quartic_third a b c d f e :
  Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 3 e = d + e * f.
Proof. rewrite rate_of_rate, (Derive_n_ext _ _ 2 e (quartic_rate a b c d f)). apply cubic_second. Qed.

Lemma quadratic_start a b c : a + 0 * b + 0 ^ 2 / 2 * c = a.
Proof. field. Qed.
Lemma quadratic_start_rate a b c : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c) 1 0 = b.
Proof. rewrite quadratic_rate. ring. Qed.
Lemma cubic_start a b c d : a + 0 * b + 0 ^ 2 / 2 * c + 0 ^ 3 / 6 * d = a.
Proof. field. Qed.
Lemma taylor_start_rate a b c d : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d) 1 0 = b.
Proof. rewrite cubic_rate. field. Qed.
Lemma taylor_start_second a b c d : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d) 2 0 = c.
Proof. rewrite cubic_second. ring. Qed.
Lemma quartic_start a b c d f : a + 0 * b + 0 ^ 2 / 2 * c + 0 ^ 3 / 6 * d + 0 ^ 4 / 24 * f = a.
Proof. field. Qed.
Lemma quartic_start_rate a b c d f : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 1 0 = b.
Proof. rewrite quartic_rate. field. Qed.
Lemma quartic_start_second a b c d f : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 2 0 = c.
Proof. rewrite quartic_second. field. Qed.
Lemma quartic_start_third a b c d f : Derive_n (fun t => a + t * b + t ^ 2 / 2 * c + t ^ 3 / 6 * d + t ^ 4 / 24 * f) 3 0 = d.
Proof. rewrite quartic_third. ring. Qed.
(* values and derivatives of Taylor polynomials where they start *)
Ltac start_values := repeat match goal with |- context [Derive_n ?f 0] => change (Derive_n f 0) with f end; cbv beta;
  rewrite ?quartic_start_third, ?quartic_start_second, ?quartic_start_rate, ?quartic_start,
    ?cubic_third, ?taylor_start_second, ?taylor_start_rate, ?cubic_start, ?quadratic_second, ?quadratic_start_rate, ?quadratic_start.
Lemma scaled_back d f p : d <> 0 -> f <> 0 -> d ^ 2 / f * (f / d ^ 2 * p) = p.
Proof. intros. field. split; assumption. Qed.

Lemma scaled_over d f p : d <> 0 -> f <> 0 -> d ^ 2 * (f / d ^ 2 * p) / f = p.
Proof. intros. field. split; assumption. Qed.
Lemma scaled_plane d f x p : d <> 0 -> f <> 0 -> x <> 0 -> d ^ 3 * (x * f ^ 2 / d ^ 3 * p) / (x * f ^ 2) = p.
Proof. intros. field. repeat split; assumption. Qed.
Lemma same_ratio g a b c d : b <> 0 -> a = g * c -> b = g * d -> a / b = c / d.
Proof. intros N -> E. rewrite E in *. field. split; intro Z; apply N; rewrite Z; ring. Qed.
Lemma quotient_is n d q : d <> 0 -> n = d * q -> n / d = q.
Proof. intros N ->. field. exact N. Qed.
Lemma three_entries (a b c x y z : R) : [a; b; c] = [x; y; z] -> a = x /\ b = y /\ c = z.
Proof. intro E. injection E. auto. Qed.
Lemma four_entries (a b c d x y z t : R) : [a; b; c; d] = [x; y; z; t] -> a = x /\ b = y /\ c = z /\ d = t.
Proof. intro E. injection E. auto. Qed.

Lemma smooth_is_derive f n e : smooth f -> is_derive (Derive_n f n) e (Derive_n f (S n) e).
Proof. intro F. apply (Derive_correct (Derive_n f n)). exact (F (S n) e). Qed.

Lemma equal_rate (f : R -> R) (x a b : R) : is_derive f x a -> a = b -> is_derive f x b.
Proof. intros A <-. exact A. Qed.
Lemma sum_rate (f g : R -> R) (x a b : R) : is_derive f x a -> is_derive g x b -> is_derive (fun t => f t + g t) x (a + b).
Proof. intros A B. exact (is_derive_plus f g x a b A B). Qed.
Lemma product_rate (f g : R -> R) (x a b : R) : is_derive f x a -> is_derive g x b -> is_derive (fun t => f t * g t) x (a * g x + f x * b).
Proof. intros A B. exact (is_derive_mult f g x a b A B Rmult_comm). Qed.

Lemma determinant_rate (f0 f1 f2 g0 g1 g2 h0 h1 h2 : R -> R) p :
  ex_derive f0 p -> ex_derive f1 p -> ex_derive f2 p -> ex_derive g0 p -> ex_derive g1 p -> ex_derive g2 p ->
  ex_derive h0 p -> ex_derive h1 p -> ex_derive h2 p ->
  is_derive (fun e => det [[f0 e; g0 e; h0 e]; [f1 e; g1 e; h1 e]; [f2 e; g2 e; h2 e]]) p
    (det [[Derive f0 p; Derive g0 p; Derive h0 p]; [f1 p; g1 p; h1 p]; [f2 p; g2 p; h2 p]]
     + det [[f0 p; g0 p; h0 p]; [Derive f1 p; Derive g1 p; Derive h1 p]; [f2 p; g2 p; h2 p]]
     + det [[f0 p; g0 p; h0 p]; [f1 p; g1 p; h1 p]; [Derive f2 p; Derive g2 p; Derive h2 p]]).
Proof.
  intros. lists. auto_derive; [repeat split; first [exact I|assumption]|].
  repeat match goal with |- context [Derive (fun x => ?f x) p] => change (Derive (fun x => f x) p) with (Derive f p) end. ring.
Qed.
Lemma wronskian_rate f g h p : smooth f -> smooth g -> smooth h ->
  is_derive (fun e => det (map (fun k => [Derive_n f k e; Derive_n g k e; Derive_n h k e]) [0; 1; 2]%nat)) p
    (det (map (fun k => [Derive_n f k p; Derive_n g k p; Derive_n h k p]) [0; 1; 3]%nat)).
Proof.
  intros F G H. assert (D : forall f k, smooth f -> ex_derive (Derive_n f k) p)
    by (intros u k U; eexists; apply smooth_is_derive; exact U).
  eapply equal_rate; [exact (determinant_rate (Derive_n f 0) (Derive_n f 1) (Derive_n f 2) (Derive_n g 0) (Derive_n g 1) (Derive_n g 2)
    (Derive_n h 0) (Derive_n h 1) (Derive_n h 2) p (D f _ F) (D f _ F) (D f _ F) (D g _ G) (D g _ G) (D g _ G) (D h _ H) (D h _ H) (D h _ H))|].
  repeat match goal with |- context [Derive (Derive_n ?f ?k) p] => change (Derive (Derive_n f k) p) with (Derive_n f (S k) p) end.
  lists. ring.
Qed.
Lemma quotient_rate (f g : R -> R) (p a b : R) : is_derive f p a -> is_derive g p b -> g p <> 0 ->
  is_derive (fun e => f e / g e) p ((a * g p - f p * b) / g p ^ 2).
Proof. intros A B N. exact (is_derive_div f g p a b A B N). Qed.
Lemma cross_rate f g p : smooth f -> smooth g ->
  is_derive (fun e : R => Derive_n f 0 e * Derive_n g 1 e - Derive_n g 0 e * Derive_n f 1 e) p
    (Derive_n f 0 p * Derive_n g 2 p - Derive_n g 0 p * Derive_n f 2 p).
Proof.
  intros F G. eapply equal_rate; [exact (is_derive_minus _ _ p _ _
    (product_rate (Derive_n f 0) (Derive_n g 1) p _ _ (smooth_is_derive f 0 p F) (smooth_is_derive g 1 p G))
    (product_rate (Derive_n g 0) (Derive_n f 1) p _ _ (smooth_is_derive g 0 p G) (smooth_is_derive f 1 p F)))|].
  unfold minus, plus, opp. cbn. ring.
Qed.

(* the point of a generator does not depend on the planes through it: direction and moment have a common factor *)
Lemma same_point c x p1 p2 p3 t1 t2 t3 q1 q2 q3 u1 u2 u3 : c <> 0 -> p1 * p1 + (p2 * p2 + (p3 * p3 + 0)) <> 0 ->
  q1 = c * p1 -> q2 = c * p2 -> q3 = c * p3 -> u1 = c * t1 -> u2 = c * t2 -> u3 = c * t3 ->
  let q := q1 * q1 + (q2 * q2 + (q3 * q3 + 0)) in
  let p := p1 * p1 + (p2 * p2 + (p3 * p3 + 0)) in
  [x / c * q1 + (q2 * u3 - q3 * u2) / q; x / c * q2 + (q3 * u1 - q1 * u3) / q; x / c * q3 + (q1 * u2 - q2 * u1) / q] =
  [x * p1 + (p2 * t3 - p3 * t2) / p; x * p2 + (p3 * t1 - p1 * t3) / p; x * p3 + (p1 * t2 - p2 * t1) / p].
Proof.
  intros C N -> -> -> -> -> ->. rewrite !Rplus_0_r in *. cbv zeta.
  assert (M : c * p1 * (c * p1) + (c * p2 * (c * p2) + c * p3 * (c * p3)) <> 0).
  { replace (c * p1 * (c * p1) + (c * p2 * (c * p2) + c * p3 * (c * p3))) with (c * c * (p1 * p1 + (p2 * p2 + p3 * p3))) by ring.
    repeat apply Rmult_integral_contrapositive_currified; assumption. }
  repeat (refine (f_equal2 (@cons _) _ _); [field; repeat split; assumption|]). reflexivity.
Qed.

Lemma same_foot c p1 p2 p3 t1 t2 t3 q1 q2 q3 u1 u2 u3 : c <> 0 -> p1 * p1 + (p2 * p2 + (p3 * p3 + 0)) <> 0 ->
  q1 = c * p1 -> q2 = c * p2 -> q3 = c * p3 -> u1 = c * t1 -> u2 = c * t2 -> u3 = c * t3 ->
  let q := q1 * q1 + (q2 * q2 + (q3 * q3 + 0)) in
  let p := p1 * p1 + (p2 * p2 + (p3 * p3 + 0)) in
  [(q2 * u3 - q3 * u2) / q; (q3 * u1 - q1 * u3) / q; (q1 * u2 - q2 * u1) / q] =
  [(p2 * t3 - p3 * t2) / p; (p3 * t1 - p1 * t3) / p; (p1 * t2 - p2 * t1) / p].
Proof.
  intros C N Q1 Q2 Q3 U1 U2 U3 q p. pose proof (same_point c 0 p1 p2 p3 t1 t2 t3 q1 q2 q3 u1 u2 u3 C N Q1 Q2 Q3 U1 U2 U3) as E.
  fold q p in E. revert E. unfold Rdiv at 1 3 5. rewrite !Rmult_0_l, !Rplus_0_l. exact (fun E => E).
Qed.

Lemma stays (f : R -> R) p : ex_derive f p -> f p <> 0 -> locally p (fun e => f e <> 0).
Proof. intros D N. exact (ex_derive_continuous f p D (fun y => y <> 0) (open_neq 0 (f p) N)). Qed.
Lemma times_line u k l n y : smooth u ->
  Derive_n (fun x => u x * (k + l * x)) (S n) y = Derive_n u (S n) y * (k + l * y) + INR (S n) * l * Derive_n u n y.
Proof.
  intro U. revert y. induction n as [|n IH]; intro y.
  - apply is_derive_unique. eapply equal_rate; [apply (product_rate u (fun x => k + l * x) y); [exact (smooth_is_derive u 0 y U)|]|].
    + instantiate (1 := l). auto_derive; [exact I|ring].
    + cbn [INR Derive_n]. ring.
  - change (Derive (Derive_n (fun x => u x * (k + l * x)) (S n)) y = Derive_n u (S (S n)) y * (k + l * y) + INR (S (S n)) * l * Derive_n u (S n) y).
    rewrite (Derive_ext _ _ y IH). apply is_derive_unique. eapply equal_rate.
    + apply sum_rate; [apply (product_rate (Derive_n u (S n)) (fun x => k + l * x) y); [apply smooth_is_derive, U|]
        |apply (product_rate (fun _ => INR (S n) * l) (Derive_n u n) y); [apply @is_derive_const|apply smooth_is_derive, U]].
      instantiate (1 := l). auto_derive; [exact I|ring].
    + rewrite (S_INR (S n)). change (@zero R_AbelianGroup) with 0. cbv beta. unfold zero. cbn. ring.
Qed.

Section Planes.
Variables n1 n2 n3 n4 : R -> R.
Hypotheses (S1 : smooth n1) (S2 : smooth n2) (S3 : smooth n3) (S4 : smooth n4).
Let rows k e := [Derive_n n1 k e; Derive_n n2 k e; Derive_n n3 k e].

(* a point that stays on its plane *)
Lemma incident k (x y z : R -> R) p : ex_derive x p -> ex_derive y p -> ex_derive z p ->
  locally p (fun e => Derive_n n1 k e * x e + Derive_n n2 k e * y e + Derive_n n3 k e * z e = Derive_n n4 k e) ->
  Derive_n n1 k p * Derive x p + Derive_n n2 k p * Derive y p + Derive_n n3 k p * Derive z p =
  Derive_n n4 (S k) p - (Derive_n n1 (S k) p * x p + Derive_n n2 (S k) p * y p + Derive_n n3 (S k) p * z p).
Proof.
  intros X Y Z L.
  assert (A : is_derive (Derive_n n4 k) p (Derive_n n1 (S k) p * x p + Derive_n n1 k p * Derive x p
    + (Derive_n n2 (S k) p * y p + Derive_n n2 k p * Derive y p) + (Derive_n n3 (S k) p * z p + Derive_n n3 k p * Derive z p))).
  { eapply is_derive_ext_loc; [exact L|].
    apply sum_rate; [apply sum_rate|]; apply product_rate; first [apply Derive_correct; assumption|apply smooth_is_derive; assumption]. }
  pose proof (is_derive_unique _ _ _ A) as E. change (Derive (Derive_n n4 k) p) with (Derive_n n4 (S k) p) in E.
  rewrite E. ring.
Qed.

(* the generators *)
Let along e := cross (rows 0 e) (rows 1 e).
Let foot e := vdiv (cross (along e) (vsub (vscale (Derive_n n4 1 e) (rows 0 e)) (vscale (Derive_n n4 0 e) (rows 1 e)))) (dot (along e) (along e)).
Let J x e := vadd (vscale x (along e)) (foot e).
Lemma on_planes x e : dot (along e) (along e) <> 0 ->
  dot (rows 0 e) (J x e) = Derive_n n4 0 e /\ dot (rows 1 e) (J x e) = Derive_n n4 1 e.
Proof.
  unfold J, foot, along, rows.
  generalize (Derive_n n1 0 e) (Derive_n n2 0 e) (Derive_n n3 0 e) (Derive_n n4 0 e) (Derive_n n1 1 e) (Derive_n n2 1 e) (Derive_n n3 1 e) (Derive_n n4 1 e).
  intros a b c d a' b' c' d'. lists. intro N. rewrite !Rplus_0_r in N. split; field; exact N.
Qed.
Lemma moves x i p : dot (along p) (along p) <> 0 -> (i < 3)%nat -> ex_derive (fun e : R => nth i (J x e) 0) p.
Proof.
  unfold J, foot, along, rows. intros N I. revert N.
  assert (D : forall f, smooth f -> ex_derive (Derive_n f 0) p /\ ex_derive (Derive_n f 1) p)
    by (intros f F; split; [exact (F 1%nat p)|exact (F 2%nat p)]).
  destruct (D n1 S1) as [A A']. destruct (D n2 S2) as [B B']. destruct (D n3 S3) as [C C']. destruct (D n4 S4) as [F F'].
  revert A A' B B' C C' F F'. clear D S1 S2 S3 S4.
  generalize (Derive_n n1 0) (Derive_n n2 0) (Derive_n n3 0) (Derive_n n4 0) (Derive_n n1 1) (Derive_n n2 1) (Derive_n n3 1) (Derive_n n4 1).
  intros a b c d a' b' c' d' A A' B B' C C' F F'. lists. intro N.
  destruct i as [|[|[|i]]]; [| | |lia]; cbv beta iota; auto_derive; repeat split; first [exact I|assumption].
Qed.
Lemma tangent_plane x p : locally p (fun e => dot (along e) (along e) <> 0) ->
  dot (rows 0 p) (vDerive 3 (J x) 1 p) = 0 /\
  dot (rows 1 p) (vDerive 3 (J x) 1 p) = Derive_n n4 2 p - dot (rows 2 p) (J x p).
Proof.
  intro L. pose proof (locally_singleton _ _ L) as N. cbv beta in N.
  pose proof (moves x 0 p N ltac:(lia)) as X. pose proof (moves x 1 p N ltac:(lia)) as Y. pose proof (moves x 2 p N ltac:(lia)) as Z.
  destruct (on_planes x p N) as [P Q].
  assert (E0 := fun H => incident 0 (fun e : R => nth 0 (J x e) 0) (fun e : R => nth 1 (J x e) 0) (fun e : R => nth 2 (J x e) 0) p X Y Z (filter_imp _ _ H L)).
  assert (E1 := fun H => incident 1 (fun e : R => nth 0 (J x e) 0) (fun e : R => nth 1 (J x e) 0) (fun e : R => nth 2 (J x e) 0) p X Y Z (filter_imp _ _ H L)).
  assert (T : forall u x y z, dot (rows u p) [x; y; z] = Derive_n n1 u p * x + Derive_n n2 u p * y + Derive_n n3 u p * z)
    by (intros; unfold rows; lists; ring).
  assert (G : forall e, J x e = [nth 0 (J x e) 0; nth 1 (J x e) 0; nth 2 (J x e) 0]) by reflexivity.
  change (vDerive 3 (J x) 1 p) with [Derive (fun e : R => nth 0 (J x e) 0) p; Derive (fun e : R => nth 1 (J x e) 0) p; Derive (fun e : R => nth 2 (J x e) 0) p].
  assert (T' : forall u e, dot (rows u e) (J x e) = Derive_n n1 u e * nth 0 (J x e) 0 + Derive_n n2 u e * nth 1 (J x e) 0 + Derive_n n3 u e * nth 2 (J x e) 0).
  { intros. rewrite G at 1. unfold rows. generalize (nth 0 (J x e) 0) (nth 1 (J x e) 0) (nth 2 (J x e) 0). intros. lists. ring. }
  rewrite !T. rewrite !T' in *. split.
  - rewrite E0; [rewrite Q; ring|].
    intros e M. cbv beta. rewrite <- T'. apply (proj1 (on_planes x e M)).
  - apply E1. intros e M. rewrite <- T'. apply (proj2 (on_planes x e M)).
Qed.

(* the same for the foot points *)
Lemma foot_plane p : locally p (fun e => dot (along e) (along e) <> 0) ->
  (dot (rows 0 p) (foot p) = Derive_n n4 0 p /\ dot (rows 1 p) (foot p) = Derive_n n4 1 p) /\
  dot (rows 0 p) (vDerive 3 foot 1 p) = 0 /\ dot (rows 1 p) (vDerive 3 foot 1 p) = Derive_n n4 2 p - dot (rows 2 p) (foot p).
Proof.
  intro L. pose proof (locally_singleton _ _ L) as N. cbv beta in N.
  assert (E : forall e, J 0 e = foot e).
  { intro e. unfold J. assert (F : foot e = [nth 0 (foot e) 0; nth 1 (foot e) 0; nth 2 (foot e) 0]) by reflexivity.
    rewrite F. generalize (nth 0 (foot e) 0) (nth 1 (foot e) 0) (nth 2 (foot e) 0). intros a b c.
    unfold along, rows. lists. repeat (refine (f_equal2 (@cons _) _ _); [ring|]). reflexivity. }
  assert (V : vDerive 3 (J 0) 1 p = vDerive 3 foot 1 p)
    by (apply map_ext; intro i; apply Derive_n_ext; intro e; rewrite E; reflexivity).
  rewrite <- V, <- E. split; [apply on_planes; exact N|apply tangent_plane; exact L].
Qed.
Lemma generator_stays p : dot (along p) (along p) <> 0 -> locally p (fun e => dot (along e) (along e) <> 0).
Proof.
  apply (stays (fun e => dot (along e) (along e))).
  pose (c f g e := Derive_n f 0 e * Derive_n g 1 e - Derive_n g 0 e * Derive_n f 1 e : R).
  assert (C : forall f g, smooth f -> smooth g -> ex_derive (c f g) p) by (intros f g F G; eexists; exact (cross_rate f g p F G)).
  pose proof (C _ _ S2 S3) as X. pose proof (C _ _ S3 S1) as Y. pose proof (C _ _ S1 S2) as Z.
  apply (ex_derive_ext (fun e => c n2 n3 e * c n2 n3 e + (c n3 n1 e * c n3 n1 e + (c n1 n2 e * c n1 n2 e + 0)))); [intro; reflexivity|].
  revert X Y Z. generalize (c n2 n3) (c n3 n1) (c n1 n2). intros x y z X Y Z. auto_derive. repeat split; assumption.
Qed.

(* the spine curve *)
Let four e := det (map (fun k => rows k e ++ [Derive_n n4 k e]) (seq 0 4)).
Let D e := det [rows 0 e; rows 1 e; rows 2 e].
Let column j e := det (map (fun k => firstn j (rows k e) ++ Derive_n n4 k e :: skipn (S j) (rows k e)) (seq 0 3)).
Let spine e := vdiv [column 0 e; column 1 e; column 2 e] (D e).
Lemma spine_rate i p : D p <> 0 -> (i < 3)%nat ->
  is_derive (fun e : R => nth i (spine e) 0) p (four p / D p ^ 2 * nth i (along p) 0).
Proof.
  intros N I.
  assert (E : four p / D p ^ 2 * nth i (along p) 0 = four p * nth i (along p) 0 / D p ^ 2) by (field; exact N). rewrite E. clear E.
  pose proof (wronskian_rate n1 n2 n3 p S1 S2 S3) as W. destruct i as [|[|[|i]]]; [| | |lia].
  - eapply equal_rate; [exact (quotient_rate _ D p _ _ (wronskian_rate n4 n2 n3 p S4 S2 S3) W N)|].
    apply (f_equal (fun t => t / D p ^ 2)). unfold D, four, along, rows. lists. ring.
  - eapply equal_rate; [exact (quotient_rate _ D p _ _ (wronskian_rate n1 n4 n3 p S1 S4 S3) W N)|].
    apply (f_equal (fun t => t / D p ^ 2)). unfold D, four, along, rows. lists. ring.
  - eapply equal_rate; [exact (quotient_rate _ D p _ _ (wronskian_rate n1 n2 n4 p S1 S2 S4) W N)|].
    apply (f_equal (fun t => t / D p ^ 2)). unfold D, four, along, rows. lists. ring.
Qed.
Lemma spine_velocity p : D p <> 0 -> vDerive 3 spine 1 p = vscale (four p / D p ^ 2) (along p).
Proof.
  intro N. change (vDerive 3 spine 1 p) with (map (fun i => Derive (fun e : R => nth i (spine e) 0) p) (seq 0 3)).
  cbn [map seq].
  rewrite (is_derive_unique _ _ _ (spine_rate 0 p N ltac:(lia))), (is_derive_unique _ _ _ (spine_rate 1 p N ltac:(lia))),
    (is_derive_unique _ _ _ (spine_rate 2 p N ltac:(lia))). reflexivity.
Qed.
Lemma spine_plane x p : locally p (fun e => D e <> 0) ->
  cross (vDerive 3 spine 1 p) (vadd (vDerive 3 spine 1 p) (vscale x (vDerive 3 spine 2 p))) =
  vscale (x * four p ^ 2 / D p ^ 3) (rows 0 p).
Proof.
  intro L. pose proof (locally_singleton _ _ L) as N. cbv beta in N.
  assert (D4 : forall f k e, smooth f -> is_derive (fun x : R => Derive_n f k x) e (Derive_n f (S k) e))
    by (intros u k e U; apply smooth_is_derive; exact U).
  assert (W : ex_derive (fun e : R => four e / D e ^ 2) p).
  { assert (F : forall f k, smooth f -> ex_derive (Derive_n f k) p) by (intros u k U; eexists; apply smooth_is_derive; exact U).
    unfold four, D, rows in *. revert N.
    pose proof (F _ 0%nat S1). pose proof (F _ 1%nat S1). pose proof (F _ 2%nat S1). pose proof (F _ 3%nat S1).
    pose proof (F _ 0%nat S2). pose proof (F _ 1%nat S2). pose proof (F _ 2%nat S2). pose proof (F _ 3%nat S2).
    pose proof (F _ 0%nat S3). pose proof (F _ 1%nat S3). pose proof (F _ 2%nat S3). pose proof (F _ 3%nat S3).
    pose proof (F _ 0%nat S4). pose proof (F _ 1%nat S4). pose proof (F _ 2%nat S4). pose proof (F _ 3%nat S4).
    lists. clear - H H0 H1 H2 H3 H4 H5 H6 H7 H8 H9 H10 H11 H12 H13 H14.
    repeat match goal with H : ex_derive (Derive_n ?f ?k) p |- _ => generalize dependent (Derive_n f k) end. intros.
    auto_derive; repeat split; first [exact I | assumption | match goal with N : ?d <> 0 |- _ => exact (pow_nonzero d 2 N) end]. }
  assert (P : forall i, (i < 3)%nat -> Derive_n (fun e : R => nth i (spine e) 0) 2 p =
    Derive (fun e : R => four e / D e ^ 2) p * nth i (along p) 0 + four p / D p ^ 2 * nth i (cross (rows 0 p) (rows 2 p)) 0).
  { intros i I. change (Derive_n (fun e : R => nth i (spine e) 0) 2 p) with (Derive (Derive (fun e : R => nth i (spine e) 0)) p).
    rewrite (Derive_ext_loc _ (fun e : R => four e / D e ^ 2 * nth i (along e) 0)).
    - apply is_derive_unique. apply (product_rate (fun e : R => four e / D e ^ 2) (fun e : R => nth i (along e) 0)); [apply Derive_correct, W|].
      destruct i as [|[|[|i]]]; [| | |lia]; [apply (cross_rate n2 n3)|apply (cross_rate n3 n1)|apply (cross_rate n1 n2)]; assumption.
    - revert L. apply filter_imp. intros e M. apply is_derive_unique, spine_rate; [exact M|exact I]. }
  rewrite spine_velocity by exact N.
  change (vDerive 3 spine 2 p) with (map (fun i => Derive_n (fun e : R => nth i (spine e) 0) 2 p) (seq 0 3)).
  cbn [map seq]. rewrite !P by lia.
  generalize (Derive (fun e : R => four e / D e ^ 2) p). generalize (four p). intros q w. clear P W L.
  replace (x * q ^ 2 / D p ^ 3) with (x * (q / D p ^ 2) ^ 2 * D p) by (field; exact N).
  generalize (q / D p ^ 2). clear N. unfold D, along, rows. intro c. lists.
  repeat (refine (f_equal2 (@cons _) _ _); [ring|]). reflexivity.
Qed.
End Planes.
