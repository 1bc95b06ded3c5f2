(* Polynomials with whole coefficients that are positive from 0 to 1, found by halving the interval, and by them the angle of the
   planes at the two ends of a generatrix. Nobody has to read it. *)
From Torse Require Import Defs.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* ---- as functions of one number ---- *)
Fixpoint whole_poly (c : list Z) (u : R) : R := match c with [] => 0 | x :: c => IZR x + u * whole_poly c u end.
Fixpoint plus_poly (c d : list Z) : list Z :=
  match c, d with [], d => d | c, [] => c | x :: c, y :: d => (x + y)%Z :: plus_poly c d end.
Definition times_number (k : Z) : list Z -> list Z := map (Z.mul k).
Fixpoint times_poly (c d : list Z) : list Z :=
  match c with [] => [] | x :: c => plus_poly (times_number x d) (0%Z :: times_poly c d) end.
Definition minus_poly c d := plus_poly c (times_number (-1) d).
Lemma whole_plus c u : forall d, whole_poly (plus_poly c d) u = whole_poly c u + whole_poly d u.
Proof.
  induction c as [|x c IH]; intros [|y d]; cbn [plus_poly whole_poly]; try ring. rewrite IH, plus_IZR. ring.
Qed.
Lemma whole_number k c u : whole_poly (times_number k c) u = IZR k * whole_poly c u.
Proof.
  induction c as [|x c IH]; [cbn; ring|]. change (times_number k (x :: c)) with ((k * x)%Z :: times_number k c).
  cbn [whole_poly]. rewrite IH, mult_IZR. ring.
Qed.
Lemma whole_times c d u : whole_poly (times_poly c d) u = whole_poly c u * whole_poly d u.
Proof.
  induction c as [|x c IH]; cbn [times_poly whole_poly]; [ring|].
  rewrite whole_plus, whole_number. cbn [whole_poly]. rewrite IH. ring.
Qed.
Lemma whole_minus c d u : whole_poly (minus_poly c d) u = whole_poly c u - whole_poly d u.
Proof. unfold minus_poly. rewrite whole_plus, whole_number. ring. Qed.

(* ---- as forms of two numbers, of the degree that the length of the list says ---- *)
Fixpoint form (c : list Z) (a b : R) : R :=
  match c with [] => 0 | x :: c => IZR x * b ^ length c + a * form c a b end.
Lemma form_whole c u : form c u 1 = whole_poly c u.
Proof. induction c as [|x c IH]; cbn [form whole_poly]; [reflexivity|]. rewrite IH, pow1. ring. Qed.
Lemma form_last c x a b : form (c ++ [x]) a b = b * form c a b + IZR x * a ^ length c.
Proof.
  induction c as [|y c IH]; cbn [app form length pow]; [ring|]. rewrite IH, app_length. cbn [length].
  replace (length c + 1)%nat with (S (length c)) by lia. cbn [pow]. ring.
Qed.
Lemma form_rev c a b : form (rev c) a b = form c b a.
Proof. induction c as [|x c IH]; cbn [rev form]; [reflexivity|]. rewrite form_last, IH, rev_length. ring. Qed.
(* a form times a + b, and x times a power of a added; so forms at a, a + b *)
Fixpoint moved_once (y : Z) (c : list Z) (x : Z) : list Z :=
  match c with [] => [(y + x)%Z] | z :: c => (y + z)%Z :: moved_once z c x end.
Definition moved (c : list Z) : list Z := fold_left (moved_once 0) c [].
Lemma moved_once_length c x : forall y, length (moved_once y c x) = S (length c).
Proof. induction c as [|z c IH]; intro y; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.
Lemma moved_once_form c x a b : forall y,
  form (moved_once y c x) a b = IZR y * b ^ length c + (a + b) * form c a b + IZR x * a ^ length c.
Proof.
  induction c as [|z c IH]; intro y; cbn [moved_once form length]; rewrite plus_IZR; [cbn; ring|].
  rewrite IH, moved_once_length. cbn [pow]. ring.
Qed.
Lemma moved_form c a b : form (moved c) a b = form c a (a + b).
Proof.
  unfold moved. enough (H : forall c d e, length e = length d -> form e a b = form d a (a + b) ->
    form (fold_left (moved_once 0) c e) a b = form (d ++ c) a (a + b)) by exact (H c [] [] eq_refl eq_refl).
  clear c. induction c as [|x c IH]; intros d e L E; cbn [fold_left]; [rewrite app_nil_r; exact E|].
  replace (d ++ x :: c) with ((d ++ [x]) ++ c) by (rewrite <- app_assoc; reflexivity). apply IH.
  - rewrite moved_once_length, app_length, L. cbn. lia.
  - rewrite moved_once_form, form_last, E, L. ring.
Qed.

(* ---- positive ---- *)
Fixpoint positive_form (halvings : nat) (c : list Z) : bool :=
  if forallb (fun x => 0 <? x)%Z c then match c with [] => false | _ => true end
  else match halvings with O => false | S n => if positive_form n (moved c) then positive_form n (moved (rev c)) else false end.
Lemma positive_coefficients c a b : forallb (fun x => 0 <? x)%Z c = true -> c <> [] ->
  0 <= a -> 0 <= b -> 0 < a + b -> 0 < form c a b.
Proof.
  intros F N A B S. induction c as [|x c IH]; [contradiction|]. cbn [forallb] in F. apply andb_prop in F. destruct F as [X F].
  apply Z.ltb_lt, IZR_lt in X. cbn [form]. destruct c as [|y c]; [cbn; lra|].
  specialize (IH F ltac:(discriminate)). pose proof (pow_le b (length (y :: c)) B).
  destruct (Rle_lt_or_eq_dec 0 a A) as [A'|<-].
  - apply Rplus_le_lt_0_compat; [apply Rmult_le_pos; lra | apply Rmult_lt_0_compat; assumption].
  - apply Rplus_lt_le_0_compat; [apply Rmult_lt_0_compat; [lra | apply pow_lt; lra] | lra].
Qed.
Theorem positive_form_is n : forall c a b, positive_form n c = true -> 0 <= a -> 0 <= b -> 0 < a + b -> 0 < form c a b.
Proof.
  induction n as [|n IH]; intros c a b H A B S; cbn [positive_form] in H;
    destruct (forallb (fun x => (0 <? x)%Z) c) eqn:F; try discriminate H.
  1,2: apply positive_coefficients; try assumption; intros ->; discriminate H.
  destruct (positive_form n (moved c)) eqn:L; [|discriminate H]. destruct (Rle_or_lt a b) as [C|C].
  - replace b with (a + (b - a)) by ring. rewrite <- moved_form. apply IH; [exact L | lra ..].
  - rewrite <- form_rev. replace a with (b + (a - b)) by ring. rewrite <- moved_form. apply IH; [exact H | lra ..].
Qed.
Theorem positive_poly n c u : positive_form n (moved c) = true -> 0 <= u <= 1 -> 0 < whole_poly c u.
Proof.
  intros H U. rewrite <- form_whole. replace 1 with (u + (1 - u)) at 1 by ring. rewrite <- moved_form.
  apply (positive_form_is n); [exact H | lra ..].
Qed.

(* ---- the angle of the planes through w and p, and through w and r ---- *)
Definition cross_poly (u v : list (list Z)) : list (list Z) :=
  let x i := nth i u [] in let y i := nth i v [] in
  [minus_poly (times_poly (x 1%nat) (y 2%nat)) (times_poly (x 2%nat) (y 1%nat));
   minus_poly (times_poly (x 2%nat) (y 0%nat)) (times_poly (x 0%nat) (y 2%nat));
   minus_poly (times_poly (x 0%nat) (y 1%nat)) (times_poly (x 1%nat) (y 0%nat))].
Definition dot_poly (u v : list (list Z)) : list Z :=
  let t i := times_poly (nth i u []) (nth i v []) in plus_poly (t 0%nat) (plus_poly (t 1%nat) (t 2%nat)).
Definition angle_poly (m n : Z) (p w r : list (list Z)) : list Z :=
  let a := cross_poly p w in let b := cross_poly r w in let d := dot_poly a r in
  minus_poly (times_number (m * m) (times_poly (dot_poly a a) (dot_poly b b)))
    (times_number (n * n) (times_poly (times_poly d d) (dot_poly w w))).
Definition at_number (p : list (list Z)) (u : R) : list R := map (fun c => whole_poly c u) p.
Lemma cross_at p w u : at_number (cross_poly p w) u = cross (at_number p u) (at_number w u).
Proof.
  unfold at_number, cross_poly, cross, entry. cbn [map Nat.pred].
  assert (E : forall i v, nth i (map (fun c => whole_poly c u) v) 0 = whole_poly (nth i v []) u)
    by (intros i v; exact (map_nth (fun c => whole_poly c u) v [] i)).
  rewrite !E, !whole_minus, !whole_times. reflexivity.
Qed.
Lemma dot_at p w u : length p = 3%nat -> length w = 3%nat -> whole_poly (dot_poly p w) u = dot (at_number p u) (at_number w u).
Proof.
  intros P W. destruct p as [|p1 [|p2 [|p3 [|]]]]; try discriminate P.
  destruct w as [|w1 [|w2 [|w3 [|]]]]; try discriminate W.
  unfold dot_poly. cbn [nth]. rewrite !whole_plus, !whole_times. cbn. ring.
Qed.
Lemma cross_of_crosses p1 p2 p3 w1 w2 w3 r1 r2 r3 :
  let p := [p1; p2; p3] in let w := [w1; w2; w3] in let r := [r1; r2; r3] in let n := cross (cross p w) (cross r w) in
  dot n n = dot (cross p w) r * dot (cross p w) r * dot w w.
Proof. cbv zeta. unfold cross, dot, entry. cbn. ring. Qed.
Lemma angle_scaled a b c p1 p2 p3 w1 w2 w3 r1 r2 r3 :
  let p := [p1; p2; p3] in let w := [w1; w2; w3] in let r := [r1; r2; r3] in
  let n x y := cross x y in
  dot (n (n (vscale a p) (vscale b w)) (n (vscale c r) (vscale b w)))
    (n (n (vscale a p) (vscale b w)) (n (vscale c r) (vscale b w))) =
    (a * b * c * b) ^ 2 * dot (n (n p w) (n r w)) (n (n p w) (n r w)) /\
  dot (n (vscale a p) (vscale b w)) (n (vscale a p) (vscale b w)) *
    dot (n (vscale c r) (vscale b w)) (n (vscale c r) (vscale b w)) =
    (a * b * c * b) ^ 2 * (dot (n p w) (n p w) * dot (n r w) (n r w)).
Proof.
  cbv zeta. unfold vscale. cbn [map].
  assert (N : forall s t x1 x2 x3 y1 y2 y3,
    cross [s * x1; s * x2; s * x3] [t * y1; t * y2; t * y3] = vscale (s * t) (cross [x1; x2; x3] [y1; y2; y3]))
    by (intros; unfold cross, vscale, entry; cbn; repeat apply (f_equal2 (@cons R)); try ring; reflexivity).
  rewrite !N. set (X := cross [p1; p2; p3] [w1; w2; w3]). set (Y := cross [r1; r2; r3] [w1; w2; w3]).
  assert (HX : exists x1 x2 x3, X = [x1; x2; x3]) by (subst X; unfold cross; eauto).
  assert (HY : exists y1 y2 y3, Y = [y1; y2; y3]) by (subst Y; unfold cross; eauto).
  destruct HX as (x1 & x2 & x3 & ->), HY as (y1 & y2 & y3 & ->). unfold vscale. cbn [map]. rewrite N.
  unfold vscale, cross, entry, dot. cbn. split; ring.
Qed.
Theorem angle_below halvings m n p w r a b c u : positive_form halvings (moved (angle_poly m n p w r)) = true ->
  length p = 3%nat -> length w = 3%nat -> length r = 3%nat -> (0 < n)%Z -> a <> 0 -> b <> 0 -> c <> 0 -> 0 <= u <= 1 ->
  let P := vscale a (at_number p u) in let W := vscale b (at_number w u) in let R := vscale c (at_number r u) in
  dot (cross (cross P W) (cross R W)) (cross (cross P W) (cross R W)) <
    (IZR m / IZR n) ^ 2 * (dot (cross P W) (cross P W) * dot (cross R W) (cross R W)).
Proof.
  intros H LP LW LR N A B C U. cbv zeta. apply (positive_poly _ _ u) in H; [|exact U]. unfold angle_poly in H. cbv zeta in H.
  rewrite whole_minus, !whole_number, !whole_times, !dot_at, !cross_at in H by (assumption || reflexivity).
  assert (T : forall v, length v = 3%nat -> exists x y z, at_number v u = [x; y; z]).
  { intros v L. destruct v as [|x [|y [|z [|]]]]; try discriminate L. cbn. eauto. }
  destruct (T p LP) as (p1 & p2 & p3 & EP), (T w LW) as (w1 & w2 & w3 & EW), (T r LR) as (r1 & r2 & r3 & ER).
  rewrite EP, EW, ER in H |- *. rewrite <- cross_of_crosses in H.
  destruct (angle_scaled a b c p1 p2 p3 w1 w2 w3 r1 r2 r3) as [E F]. cbv zeta in E, F. rewrite E, F. clear E F.
  match type of H with 0 < _ * ?s - _ * ?t => revert H; generalize t; generalize s end.
  intros s t H. rewrite !mult_IZR in H. apply IZR_lt in N. assert (K : 0 < (a * b * c * b) ^ 2).
  { rewrite <- Rsqr_pow2. apply Rsqr_pos_lt. repeat apply Rmult_integral_contrapositive_currified; assumption. }
  generalize dependent ((a * b * c * b) ^ 2). intros k K.
  apply Rmult_lt_reg_l with (IZR n * IZR n); [apply Rmult_lt_0_compat; exact N|].
  replace (IZR n * IZR n * ((IZR m / IZR n) ^ 2 * (k * s))) with (k * (IZR m * IZR m * s)) by (field; lra).
  replace (IZR n * IZR n * (k * t)) with (k * (IZR n * IZR n * t)) by ring. apply Rmult_lt_compat_l; [exact K|lra].
Qed.
