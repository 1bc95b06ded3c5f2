(* Curves with given values and tangents, and the condition that the joins of two curves are developable: nobody has to read it.
   The gap of the condition is a polynomial; its coefficients come from those of the curves without any derivative. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(* a polynomial, lowest coefficient first *)
Fixpoint poly (c : list R) (u : R) : R := match c with [] => 0 | a :: c => a + u * poly c u end.
Fixpoint pex (c : list R) : ex := match c with [] => K 0 | a :: c => Ad (K a) (Ml X (pex c)) end.
Lemma pex_ok c u : ok (pex c) u.
Proof. induction c; cbn; auto. Qed.
Lemma pex_ev c u : poly c u = ev (pex c) u.
Proof. induction c as [|a c IH]; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.
(* the derivative *)
Fixpoint slopes (n : R) (c : list R) : list R := match c with [] => [] | a :: c => n * a :: slopes (n + 1) c end.
Definition slope (c : list R) : list R := slopes 1 (tl c).
Lemma slopes_next n c u : poly (slopes (n + 1) c) u = poly (slopes n c) u + poly c u.
Proof. revert n. induction c as [|a c IH]; intro n; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma poly_derive c u : is_derive (poly c) u (poly (slope c) u).
Proof.
  induction c as [|a c IH]; [exact (is_derive_const 0 u)|].
  assert (E : poly (slope (a :: c)) u = 0 + (1 * poly c u + u * poly (slope c) u)).
  { unfold slope. cbn [tl]. clear. destruct c as [|b c]; cbn; [ring|]. rewrite slopes_next. ring. }
  rewrite E. apply (dplus (fun _ => a) (fun u => u * poly c u)); [exact (is_derive_const a u)|].
  apply (dmult (fun u => u) (poly c)); [exact (is_derive_id u)|exact IH].
Qed.
Fixpoint slope_n (n : nat) (c : list R) : list R := match n with O => c | S n => slope (slope_n n c) end.
Lemma poly_derive_n n c u : Derive_n (poly c) n u = poly (slope_n n c) u.
Proof.
  revert u. induction n as [|n IH]; intro u; [reflexivity|]. cbn [Derive_n slope_n].
  rewrite (Derive_ext _ (poly (slope_n n c))) by exact IH. apply is_derive_unique, poly_derive.
Qed.
Lemma slopes_nth c : forall m k, nth k (slopes m c) 0 = (m + INR k) * nth k c 0.
Proof.
  induction c as [|a c IH]; intros m k; cbn; [destruct k; ring|].
  destruct k as [|k]; cbn [nth]; [cbn; ring|]. rewrite IH, S_INR. ring.
Qed.
Lemma slope_nth c k : nth k (slope c) 0 = INR (S k) * nth (S k) c 0.
Proof. unfold slope. rewrite slopes_nth, S_INR. rewrite (Rplus_comm 1). destruct c as [|a c]; [destruct k; cbn [tl nth]; ring | cbn [tl nth]; ring]. Qed.
Lemma slope_n_nth n c : forall k, nth k (slope_n n c) 0 * INR (fact k) = INR (fact (n + k)) * nth (n + k) c 0.
Proof.
  induction n as [|n IH]; intro k; cbn [slope_n Nat.add]; [ring|].
  rewrite slope_nth. specialize (IH (S k)).
  replace (n + S k)%nat with (S (n + k)) in IH by lia. rewrite <- IH.
  change (fact (S k)) with (S k * fact k)%nat. rewrite mult_INR. ring.
Qed.
Lemma poly_at_0 c : poly c 0 = nth 0 c 0.
Proof. destruct c; cbn; ring. Qed.
Theorem coefficient_of f c n : (forall u, f u = poly c u) -> Derive_n f n 0 / INR (fact n) = nth n c 0.
Proof.
  intro E. rewrite (Derive_n_ext f (poly c) n 0 E), poly_derive_n, poly_at_0.
  pose proof (slope_n_nth n c 0) as H. rewrite Nat.add_0_r in H. cbn [fact] in H. change (INR 1) with 1 in H.
  rewrite Rmult_1_r in H. rewrite H. field. apply INR_fact_neq_0.
Qed.

(* ---- the curves ---- *)
(* from the values at the ends (and in the middle) and the tangents there *)
Definition cubic_of (a b s t : R) : list R := [a; s; 3 * b - 3 * a - 2 * s - t; 2 * a - 2 * b + s + t].
Definition quartic_of (a m b s t : R) : list R :=
  [a; s; 16 * m - 11 * a - 5 * b - 4 * s + t; 18 * a - 32 * m + 14 * b + 5 * s - 3 * t; 16 * m - 8 * a - 8 * b - 2 * s + 2 * t].
Definition quintic_of (a m b s r t : R) : list R :=
  [a; s; 16 * m - 23 * a + 7 * b - 6 * s - 8 * r - t; 66 * a - 32 * m - 34 * b + 13 * s + 32 * r + 5 * t;
   52 * b - 68 * a + 16 * m - 12 * s - 40 * r - 8 * t; 24 * a - 24 * b + 4 * s + 16 * r + 4 * t].
Definition cubic_weights (w : list R) (u : R) : Prop := w =
  [2 * u ^ 3 - 3 * u ^ 2 + 1; - 2 * u ^ 3 + 3 * u ^ 2; u ^ 3 - 2 * u ^ 2 + u; u ^ 3 - u ^ 2].
Definition quartic_weights (w : list R) (u : R) : Prop := w =
  [- 8 * u ^ 4 + 18 * u ^ 3 - 11 * u ^ 2 + 1; 16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2; - 8 * u ^ 4 + 14 * u ^ 3 - 5 * u ^ 2;
   - 2 * u ^ 4 + 5 * u ^ 3 - 4 * u ^ 2 + u; 2 * u ^ 4 - 3 * u ^ 3 + u ^ 2].
Definition quintic_weights (w : list R) (u : R) : Prop := w =
  [24 * u ^ 5 - 68 * u ^ 4 + 66 * u ^ 3 - 23 * u ^ 2 + 1; 16 * u ^ 4 - 32 * u ^ 3 + 16 * u ^ 2;
   - 24 * u ^ 5 + 52 * u ^ 4 - 34 * u ^ 3 + 7 * u ^ 2; 4 * u ^ 5 - 12 * u ^ 4 + 13 * u ^ 3 - 6 * u ^ 2 + u;
   16 * u ^ 5 - 40 * u ^ 4 + 32 * u ^ 3 - 8 * u ^ 2; 4 * u ^ 5 - 8 * u ^ 4 + 5 * u ^ 3 - u ^ 2].
Definition curve4 (w a b c d : list R) : list R :=
  vadd (vadd (vadd (vscale (entry w 1) a) (vscale (entry w 2) b)) (vscale (entry w 3) c)) (vscale (entry w 4) d).
Definition curve5 (w a b c d e : list R) : list R := vadd (curve4 w a b c d) (vscale (entry w 5) e).
Definition curve6 (w a b c d e f : list R) : list R := vadd (curve5 w a b c d e) (vscale (entry w 6) f).
Ltac blended := unfold curve6, curve5, curve4, vadd, vscale, entry, quintic_of, quartic_of, cubic_of;
  cbn [map zip nth Nat.pred poly]; repeat apply (f_equal2 (@cons R)); try reflexivity; ring.
Lemma cubic_curve w u a1 a2 a3 b1 b2 b3 s1 s2 s3 t1 t2 t3 : cubic_weights w u ->
  curve4 w [a1; a2; a3] [b1; b2; b3] [s1; s2; s3] [t1; t2; t3] =
  [poly (cubic_of a1 b1 s1 t1) u; poly (cubic_of a2 b2 s2 t2) u; poly (cubic_of a3 b3 s3 t3) u].
Proof. intros ->. blended. Qed.
Lemma quartic_curve w u a1 a2 a3 m1 m2 m3 b1 b2 b3 s1 s2 s3 t1 t2 t3 : quartic_weights w u ->
  curve5 w [a1; a2; a3] [m1; m2; m3] [b1; b2; b3] [s1; s2; s3] [t1; t2; t3] =
  [poly (quartic_of a1 m1 b1 s1 t1) u; poly (quartic_of a2 m2 b2 s2 t2) u; poly (quartic_of a3 m3 b3 s3 t3) u].
Proof. intros ->. blended. Qed.
Lemma quintic_curve w u a1 a2 a3 m1 m2 m3 b1 b2 b3 s1 s2 s3 r1 r2 r3 t1 t2 t3 : quintic_weights w u ->
  curve6 w [a1; a2; a3] [m1; m2; m3] [b1; b2; b3] [s1; s2; s3] [r1; r2; r3] [t1; t2; t3] =
  [poly (quintic_of a1 m1 b1 s1 r1 t1) u; poly (quintic_of a2 m2 b2 s2 r2 t2) u; poly (quintic_of a3 m3 b3 s3 r3 t3) u].
Proof. intros ->. blended. Qed.

Lemma quintic_along a m b s r t a' m' b' s' r' t' c u :
  poly (quintic_of (a - a' * c) (m - m' * c) (b - b' * c) (s - s' * c) (r - r' * c) (t - t' * c)) u =
  poly (quintic_of a m b s r t) u - poly (quintic_of a' m' b' s' r' t') u * c.
Proof. unfold quintic_of. cbn [poly]. ring. Qed.

(* ---- the condition ---- *)
(* coefficient n of q + q' - k (p + p') - (1 - k) o *)
Definition joined (k : R) (q p : list R) (o : R) (n : nat) : R :=
  nth n q 0 + INR (S n) * nth (S n) q 0 - k * (nth n p 0 + INR (S n) * nth (S n) p 0) -
  match n with O => (1 - k) * o | _ => 0 end.
Fixpoint sums (c d : list R) : list R := match c, d with
  | [], d => d | c, [] => c | a :: c, b :: d => (a + b) :: sums c d end.
Lemma poly_sums c u : forall d, poly (sums c d) u = poly c u + poly d u.
Proof. induction c as [|a c IH]; intros [|b d]; cbn; rewrite ?IH; ring. Qed.
Lemma poly_scaled c k u : poly (map (Rmult k) c) u = k * poly c u.
Proof. induction c as [|a c IH]; cbn; rewrite ?IH; ring. Qed.
Lemma nth_sums c : forall d n, nth n (sums c d) 0 = nth n c 0 + nth n d 0.
Proof.
  induction c as [|a c IH]; intros [|b d] [|n]; cbn; rewrite ?IH; try ring; destruct n; ring.
Qed.
Lemma nth_scaled c k n : nth n (map (Rmult k) c) 0 = k * nth n c 0.
Proof. revert n. induction c as [|a c IH]; intros [|n]; cbn; rewrite ?IH; try ring. Qed.
Lemma gap_part (q p : R -> R) cq cp k o n : (forall u, q u = poly cq u) -> (forall u, p u = poly cp u) ->
  Derive_n (fun u => q u + Derive_n q 1 u - k * (p u + Derive_n p 1 u) - (1 - k) * o) n 0 / INR (fact n) = joined k cq cp o n.
Proof.
  intros Q P.
  rewrite (coefficient_of _ (sums (sums (sums cq (slope cq)) (map (Rmult (- k)) (sums cp (slope cp)))) [- ((1 - k) * o)])).
  - rewrite !nth_sums, nth_scaled, nth_sums, !slope_nth. unfold joined. destruct n as [|n]; cbn [nth]; [|destruct n]; ring.
  - intro u. rewrite !poly_sums, poly_scaled, poly_sums. rewrite <- !(poly_derive_n 1).
    rewrite <- !(Derive_n_ext q (poly cq) 1 u Q), <- !(Derive_n_ext p (poly cp) 1 u P), Q, P. cbn [poly]. ring.
Qed.
Definition gap_of (q p : R -> list R) (k : R) (o : list R) (u : R) : list R :=
  vsub (vsub (vadd (q u) (vDerive 3 q 1 u)) (vscale k (vadd (p u) (vDerive 3 p 1 u)))) (vscale (1 - k) o).
Definition part_of (g : R -> list R) (z : Z) : list R := vdiv (vDerive 3 g (Z.to_nat z) 0) (factorial z).
Lemma part_is (q p : R -> list R) q1 q2 q3 p1 p2 p3 k o1 o2 o3 z :
  (forall u, q u = [poly q1 u; poly q2 u; poly q3 u]) -> (forall u, p u = [poly p1 u; poly p2 u; poly p3 u]) ->
  part_of (gap_of q p k [o1; o2; o3]) z =
  [joined k q1 p1 o1 (Z.to_nat z); joined k q2 p2 o2 (Z.to_nat z); joined k q3 p3 o3 (Z.to_nat z)].
Proof.
  intros Q P. unfold part_of, factorial. generalize (Z.to_nat z). intro n.
  unfold vDerive at 1, vdiv. cbn [seq map].
  assert (G : forall i u, (i < 3)%nat -> nth i (gap_of q p k [o1; o2; o3] u) 0 =
    nth i (q u) 0 + Derive_n (fun u => nth i (q u) 0) 1 u - k * (nth i (p u) 0 + Derive_n (fun u => nth i (p u) 0) 1 u)
      - (1 - k) * nth i [o1; o2; o3] 0).
  { intros i u I. unfold gap_of, vsub, vadd, vscale, vDerive. rewrite (Q u), (P u).
    do 3 (destruct i as [|i]; [reflexivity|]). lia. }
  repeat apply (f_equal2 (@cons R)); [| | |reflexivity].
  - rewrite (Derive_n_ext _ _ n 0 (fun u => G 0%nat u ltac:(lia))). apply gap_part; intro u; rewrite ?Q, ?P; reflexivity.
  - rewrite (Derive_n_ext _ _ n 0 (fun u => G 1%nat u ltac:(lia))). apply gap_part; intro u; rewrite ?Q, ?P; reflexivity.
  - rewrite (Derive_n_ext _ _ n 0 (fun u => G 2%nat u ltac:(lia))). apply gap_part; intro u; rewrite ?Q, ?P; reflexivity.
Qed.

(* where the condition holds, one curve is the image of the other under the similarity from o *)
Lemma nth_past (c : list R) n : (length c <= n)%nat -> nth n c 0 = 0.
Proof. apply nth_overflow. Qed.
Lemma similar_tails d k q p o : (length q <= S d)%nat -> (length p <= S d)%nat ->
  (forall n, (n <= d)%nat -> joined k q p o n = 0) -> forall m n, (n + m = S d)%nat ->
  nth n q 0 = k * nth n p 0 + match n with O => (1 - k) * o | _ => 0 end.
Proof.
  intros Q P H m. induction m as [|m IH]; intros n N.
  - rewrite !nth_past by lia. destruct n; [lia|ring].
  - specialize (H n ltac:(lia)). unfold joined in H. specialize (IH (S n) ltac:(lia)). cbn match in IH.
    rewrite IH in H. revert H. generalize (INR (S n)). intros r H. destruct n; lra.
Qed.
Lemma poly_nth c : forall d u, (forall n, nth n c 0 = nth n d 0) -> poly c u = poly d u.
Proof.
  assert (Z : forall c u, (forall n, nth n c 0 = 0) -> poly c u = 0).
  { clear. induction c as [|a c IH]; intros u H; [reflexivity|]. cbn. rewrite (IH u (fun n => H (S n))).
    specialize (H O). cbn in H. rewrite H. ring. }
  induction c as [|a c IH]; intros [|b d] u H.
  - reflexivity.
  - symmetry. apply Z. intro n. symmetry. rewrite <- H. destruct n; reflexivity.
  - apply Z. intro n. rewrite H. destruct n; reflexivity.
  - cbn. rewrite (IH d u (fun n => H (S n))). specialize (H O). cbn in H. rewrite H. reflexivity.
Qed.
Theorem similar d k q p o : (length q <= S d)%nat -> (length p <= S d)%nat ->
  (forall n, (n <= d)%nat -> joined k q p o n = 0) ->
  (forall u, poly q u = k * poly p u + (1 - k) * o) /\ (forall u, poly (slope q) u = k * poly (slope p) u).
Proof.
  intros Q P H.
  assert (E : forall n, nth n q 0 = k * nth n p 0 + match n with O => (1 - k) * o | _ => 0 end).
  { intro n. destruct (le_lt_dec n d) as [L|L].
    - apply (similar_tails d k q p o Q P H (S d - n)). lia.
    - rewrite !nth_past by lia. destruct n; [lia|ring]. }
  split; intro u.
  - rewrite (poly_nth q (sums (map (Rmult k) p) [(1 - k) * o]) u), poly_sums, poly_scaled; [cbn [poly]; ring|].
    intro n. rewrite E, nth_sums, nth_scaled. destruct n as [|[|n]]; cbn [nth]; ring.
  - rewrite <- poly_scaled. apply poly_nth. intro n. rewrite nth_scaled, !slope_nth, E. ring.
Qed.

(* and so are the data of the curves *)
Lemma cubic_similar k o a b s t a' b' s' t' :
  (forall n, (n <= 3)%nat -> joined k (cubic_of a b s t) (cubic_of a' b' s' t') o n = 0) ->
  a = k * a' + (1 - k) * o /\ b = k * b' + (1 - k) * o /\ s = k * s' /\ t = k * t'.
Proof.
  intro H. destruct (similar 3 k (cubic_of a b s t) (cubic_of a' b' s' t') o (le_n 4) (le_n 4) H) as [V T].
  pose proof (V 0) as V0. pose proof (V 1) as V1. pose proof (T 0) as T0. pose proof (T 1) as T1. clear H V T.
  unfold slope, cubic_of in *. cbn [slopes tl poly] in *. repeat split; lra.
Qed.
Lemma quartic_similar k o a m b s t a' m' b' s' t' :
  (forall n, (n <= 4)%nat -> joined k (quartic_of a m b s t) (quartic_of a' m' b' s' t') o n = 0) ->
  a = k * a' + (1 - k) * o /\ m = k * m' + (1 - k) * o /\ b = k * b' + (1 - k) * o /\ s = k * s' /\ t = k * t'.
Proof.
  intro H. destruct (similar 4 k (quartic_of a m b s t) (quartic_of a' m' b' s' t') o (le_n 5) (le_n 5) H) as [V T].
  pose proof (V 0) as V0. pose proof (V 1) as V1. pose proof (V (1 / 2)) as VM.
  pose proof (T 0) as T0. pose proof (T 1) as T1. clear H V T.
  unfold slope, quartic_of in *. cbn [slopes tl poly] in *. repeat split; lra.
Qed.
Lemma quintic_similar k o a m b s r t a' m' b' s' r' t' :
  (forall n, (n <= 5)%nat -> joined k (quintic_of a m b s r t) (quintic_of a' m' b' s' r' t') o n = 0) ->
  a = k * a' + (1 - k) * o /\ m = k * m' + (1 - k) * o /\ b = k * b' + (1 - k) * o /\ s = k * s' /\ r = k * r' /\ t = k * t'.
Proof.
  intro H. destruct (similar 5 k (quintic_of a m b s r t) (quintic_of a' m' b' s' r' t') o (le_n 6) (le_n 6) H) as [V T].
  pose proof (V 0) as V0. pose proof (V 1) as V1. pose proof (V (1 / 2)) as VM.
  pose proof (T 0) as T0. pose proof (T 1) as T1. pose proof (T (1 / 2)) as TM. clear H V T.
  unfold slope, quintic_of in *. cbn [slopes tl poly] in *. repeat split; lra.
Qed.

(* ---- the tactics of scripts ---- *)
(* the definition D gives the weights of the curves *)
Ltac weights form D := match goal with E : D = _ |- _ =>
  intros; unfold form; rewrite E; cbv beta; repeat apply (f_equal2 (@cons R)); try reflexivity; ring end.
Ltac counted_joins := cbv beta iota zeta delta
  [joined quintic_of quartic_of cubic_of nth Z.to_nat Pos.to_nat Pos.iter_op Nat.add INR zeros repeat].
(* what a part of the condition is: [go] gets the equation *)
Ltac join t curve go := lazymatch t with
  | vdiv (vDerive 3 (fun u => vsub (vsub (vadd (@?q u) (vDerive 3 _ 1 u)) (vscale ?k (vadd (@?p u) _))) (vscale _ [?o1; ?o2; ?o3])) _ _) (factorial ?z) =>
      let Q := fresh in eassert (Q : forall u, q u = _) by (let u := fresh in intro u; curve u);
      let P := fresh in eassert (P : forall u, p u = _) by (let u := fresh in intro u; curve u);
      let E := fresh in pose proof (part_is q p _ _ _ _ _ _ k o1 o2 o3 z Q P) as E;
      change (part_of _ _) with t in E; go E; clear E P Q
  end.
(* in each equation alone *)
Ltac joins curve :=
  repeat match goal with H : context [vDerive] |- _ => lazymatch type of H with _ /\ _ => destruct H end end;
  repeat match goal with H : context [vdiv (vDerive 3 ?f ?n ?x) (factorial ?z)] |- _ =>
    join (vdiv (vDerive 3 f n x) (factorial z)) curve ltac:(fun E => rewrite E in H) end;
  repeat match goal with H : context [joined] |- _ => revert H end;
  repeat match goal with |- context [vdiv (vDerive 3 ?f ?n ?x) (factorial ?z)] =>
    join (vdiv (vDerive 3 f n x) (factorial z)) curve ltac:(fun E => rewrite E) end.
(* a lemma says what the curves of these weights are *)
Ltac cubic_weighted lemma D go := let W := fresh "W" in
  assert (W : forall a b c d u, cubic_weights (D a b c d u) u) by weights cubic_weights D;
  go ltac:(fun u => apply (lemma _ u), W); clear W.
Ltac quartic_weighted lemma D go := let W := fresh "W" in
  assert (W : forall a b c d e u, quartic_weights (D a b c d e u) u) by weights quartic_weights D;
  go ltac:(fun u => apply (lemma _ u), W); clear W.
Ltac quintic_weighted lemma D go := let W := fresh "W" in
  assert (W : forall a b c d e f u, quintic_weights (D a b c d e f u) u) by weights quintic_weights D;
  go ltac:(fun u => apply (lemma _ u), W); clear W.
Ltac with_cubics D go := cubic_weighted cubic_curve D go.
Ltac with_quartics D go := quartic_weighted quartic_curve D go.
Ltac with_quintics D go := quintic_weighted quintic_curve D go.
Ltac cubic_joins D := intros; with_cubics D joins; counted_joins.
Ltac quartic_joins D := intros; with_quartics D joins; counted_joins.
Ltac quintic_joins D := intros; with_quintics D joins; counted_joins.
(* curves of numbers *)
Lemma cubic_value w u a b s t : cubic_weights w u ->
  entry w 1 * a + entry w 2 * b + entry w 3 * s + entry w 4 * t = poly (cubic_of a b s t) u.
Proof. intros ->. unfold entry, cubic_of. cbn [nth Nat.pred poly]. ring. Qed.
Lemma quartic_value w u a m b s t : quartic_weights w u ->
  entry w 1 * a + entry w 2 * m + entry w 3 * b + entry w 4 * s + entry w 5 * t = poly (quartic_of a m b s t) u.
Proof. intros ->. unfold entry, quartic_of. cbn [nth Nat.pred poly]. ring. Qed.
Lemma quintic_value w u a m b s r t : quintic_weights w u ->
  entry w 1 * a + entry w 2 * m + entry w 3 * b + entry w 4 * s + entry w 5 * r + entry w 6 * t =
  poly (quintic_of a m b s r t) u.
Proof. intros ->. unfold entry, quintic_of. cbn [nth Nat.pred poly]. ring. Qed.
Definition gap_at (q p : R -> R) (k o u : R) : R := q u + Derive_n q 1 u - k * (p u + Derive_n p 1 u) - (1 - k) * o.
Lemma scalar_part (q p : R -> R) cq cp k o z : (forall u, q u = poly cq u) -> (forall u, p u = poly cp u) ->
  Derive_n (gap_at q p k o) (Z.to_nat z) 0 / factorial z = joined k cq cp o (Z.to_nat z).
Proof. intros Q P. unfold factorial. apply (gap_part q p cq cp k o (Z.to_nat z) Q P). Qed.
Ltac join_numbers t curve go := lazymatch t with
  | Derive_n (fun u => @?q u + Derive_n _ 1 u - ?k * (@?p u + Derive_n _ 1 u) - _ * ?o) _ _ / factorial ?z =>
      let Q := fresh in eassert (Q : forall u, q u = _) by (let u := fresh in intro u; curve u);
      let P := fresh in eassert (P : forall u, p u = _) by (let u := fresh in intro u; curve u);
      let E := fresh in pose proof (scalar_part q p _ _ k o z Q P) as E;
      change (Derive_n (gap_at q p k o) (Z.to_nat z) 0 / factorial z) with t in E; go E; clear E P Q
  end.
Ltac joins_of_numbers curve :=
  repeat match goal with H : context [Derive_n] |- _ => lazymatch type of H with _ /\ _ => destruct H end end;
  repeat match goal with H : context [Derive_n ?f ?n ?x / factorial ?z] |- _ =>
    join_numbers (Derive_n f n x / factorial z) curve ltac:(fun E => rewrite E in H) end;
  repeat match goal with H : context [joined] |- _ => revert H end;
  repeat match goal with |- context [Derive_n ?f ?n ?x / factorial ?z] =>
    join_numbers (Derive_n f n x / factorial z) curve ltac:(fun E => rewrite E) end.
Ltac values curve := repeat lazymatch goal with |- context [entry _ _ * _] => match goal with
  | |- context [?a + entry ?w ?i * ?t] =>
      let u := match w with _ ?u => u end in
      let E := fresh in eassert (E : a + entry w i * t = _) by curve u; rewrite E; clear E
  end end.
Ltac with_cubic_numbers D go := cubic_weighted cubic_value D go.
Ltac with_quartic_numbers D go := quartic_weighted quartic_value D go.
Ltac with_quintic_numbers D go := quintic_weighted quintic_value D go.
(* the same, with what follows for the curves *)
Ltac similarities d := intros; equations; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add] in *;
  repeat match goal with H : joined ?k ?q ?p ?o O = 0 |- _ =>
    lazymatch goal with _ : forall u, poly q u = k * poly p u + _ |- _ => fail | _ =>
      let S := fresh "similar" in let V := fresh "values" in let T := fresh "tangents" in
      destruct (similar d k q p o ltac:(cbn [quintic_of quartic_of cubic_of length]; lia) ltac:(cbn [quintic_of quartic_of cubic_of length]; lia)
        ltac:(let n := fresh "n" in intros n ?; do 6 (destruct n as [|n]; [first [assumption | lia]|]); lia)) as [V T] end end;
  repeat match goal with H : joined _ _ _ _ _ = 0 |- _ => revert H end; counted_joins; intros.
(* what the condition says of the curves and of their data *)
Ltac data_of_joins := cbv beta iota delta [zeros repeat]; intros; equations; cbv beta iota delta [Z.to_nat Pos.to_nat Pos.iter_op Nat.add] in *;
  repeat match goal with H : joined ?k ?q ?p ?o O = 0 |- _ =>
    let D := fresh "D" in
    let all d := (assert (D : forall n, (n <= d)%nat -> joined k q p o n = 0) by
      (let n := fresh "n" in intros n ?; do 6 (destruct n as [|n]; [first [assumption | lia]|]); lia)) in
    let V := fresh "values" in let T := fresh "tangents" in
    lazymatch q with
    | quintic_of _ _ _ _ _ _ => all 5%nat; destruct (similar 5 k q p o (le_n 6) (le_n 6) D) as [V T]; apply quintic_similar in D
    | quartic_of _ _ _ _ _ => all 4%nat; destruct (similar 4 k q p o (le_n 5) (le_n 5) D) as [V T]; apply quartic_similar in D
    | cubic_of _ _ _ _ => all 3%nat; destruct (similar 3 k q p o (le_n 4) (le_n 4) D) as [V T]; apply cubic_similar in D
    end;
    repeat match goal with J : joined k q p o _ = 0 |- _ => clear J end end; equations.
Ltac linearly := intros; equations; cbv beta iota delta [entry nth Nat.pred]; parts; lra.
Lemma curve_derive (q : R -> list R) q1 q2 q3 n u : (forall u, q u = [poly q1 u; poly q2 u; poly q3 u]) ->
  vDerive 3 q n u = [poly (slope_n n q1) u; poly (slope_n n q2) u; poly (slope_n n q3) u].
Proof.
  intro Q. unfold vDerive. cbn [map seq]. repeat apply (f_equal2 (@cons R)); [| | |reflexivity].
  all: rewrite <- poly_derive_n; apply Derive_n_ext; intro t; rewrite Q; reflexivity.
Qed.
(* values and derivatives of the curves themselves *)
Ltac curve_at curve := match goal with
  | |- context [vDerive 3 ?f ?n ?x] =>
      let q := eval cbv beta in f in
      let Q := fresh in eassert (Q : forall u, f u = _) by (let u := fresh in intro u; curve u);
      rewrite (curve_derive f _ _ _ n x Q); clear Q
  end.
Ltac curve_value curve := match goal with
  | |- context [vadd ?a (vscale (entry ?w ?i) ?t)] =>
      let u := match w with _ ?u => u end in
      let E := fresh in eassert (E : vadd a (vscale (entry w i) t) = _) by curve u; rewrite E; clear E
  end.
Ltac curves curve := repeat lazymatch goal with |- context [vDerive] => curve_at curve end;
  repeat lazymatch goal with |- context [vscale (entry _ _)] => curve_value curve end; cbv beta iota delta [slope_n].
Ltac curves_at curve := curves curve; cbv beta iota zeta delta [slope slopes tl poly]; counted_joins.
Ltac met_joins := conjuncts; lazymatch goal with
  | |- det _ <> 0 => repeat match goal with E : ?c = _ |- _ => is_const c; rewrite E; clear E end; cbv beta iota zeta; determinants; numeric
  | |- context [factorial] => compute_goal; numeric
  | |- (_ <= _)%Z => lia
  | |- @eq (list R) _ _ => parts; lra
  | |- _ => try lra
  end.
Ltac similar_cubics D := intros; with_cubics D joins; data_of_joins; with_cubics D curves.
Ltac similar_quartics D := intros; with_quartics D joins; data_of_joins; with_quartics D curves.
Ltac similar_quintics D := intros; with_quintics D joins; data_of_joins; with_quintics D curves.
Ltac cubic_curves D := intros; with_cubics D curves_at.
Ltac quartic_curves D := intros; with_quartics D curves_at.
Ltac quintic_curves D := intros; with_quintics D curves_at.
(* the parts of a conjunction, each unfolded and joined alone *)
Ltac cubic_parts D unfolding := with_cubics D ltac:(fun curve => conjuncts; unfolding; joins curve; counted_joins).
Ltac quartic_parts D unfolding := with_quartics D ltac:(fun curve => conjuncts; unfolding; joins curve; counted_joins).
Ltac quintic_parts D unfolding := with_quintics D ltac:(fun curve => conjuncts; unfolding; joins curve; counted_joins).
Ltac cubic_number_parts D unfolding := with_cubic_numbers D ltac:(fun curve => conjuncts; unfolding; joins_of_numbers curve; counted_joins).
Ltac quartic_number_parts D unfolding := with_quartic_numbers D ltac:(fun curve => conjuncts; unfolding; joins_of_numbers curve; counted_joins).
Ltac quintic_number_parts D unfolding := with_quintic_numbers D ltac:(fun curve => conjuncts; unfolding; joins_of_numbers curve; counted_joins).
(* the unknown x has the value v, by the equations *)
Ltac worth x v := let E := fresh in assert (E : x = v) by lra; rewrite E in *; clear E.
Ltac worth_times k x v := let E := fresh in assert (E : x = v) by (apply (cancelled k); [nonzero | lra]); rewrite E in *; clear E.
(* developable: the tangents are parallel *)
Ltac parallel_tangents := compute_goal; repeat match goal with
  | T : forall u, poly (slope ?q) u = _ |- context [poly (slope ?q) ?x] => rewrite (T x) end; ring.
Ltac by_coefficients := cbv beta iota zeta delta [slope slopes tl poly quintic_of quartic_of cubic_of entry nth Nat.pred]; ring.
(* a statement at values where it fails *)
Ltac premise := met_joins; first [ lra | compute_goal; numeric | compute_goal; lra ].
Ltac premises_met := repeat lazymatch goal with |- (?A -> _) -> False =>
  let K := fresh in assert (K : A) by premise; let N := fresh in intro N; specialize (N K); clear K; revert N end.
Ltac fails := premises_met; compute_goal; let C := fresh in intro C; contradiction_in C.
(* the same, each premise unfolded and joined alone; C is the statement at these values *)
Ltac granted C unfolding curve := repeat lazymatch type of C with ?A -> _ =>
  let K := fresh in assert (K : A) by (conjuncts; unfolding; joins curve; counted_joins; premise); specialize (C K); clear K end.
(* points of the one curve by those of the other *)
Ltac preimages := repeat match goal with
  | V : forall u, poly ?q u = ?k * poly ?p u + ?c |- context [poly ?p ?x] =>
      replace (poly p x) with ((poly q x - c) / k) by (rewrite (V x); field; nonzero)
  | T : forall u, poly ?q u = ?k * poly ?p u |- context [poly ?p ?x] =>
      replace (poly p x) with (poly q x / k) by (rewrite (T x); field; nonzero)
  end.
(* points of curves of numbers, each worked out once *)
Ltac point_value := cbv beta iota zeta delta [slope slopes tl poly quintic_of quartic_of cubic_of]; on_left; value.
Ltac points := preimages; repeat match goal with |- context [poly ?c ?x] =>
    let E := fresh in eassert (E : poly c x = _) by point_value; rewrite E; clear E end.
Ltac images := repeat match goal with
  | V : forall u, poly ?q u = _ |- context [poly ?q ?x] => rewrite (V x)
  end.
(* the weights at integers *)
Ltac whole_points D_ D := intros; repeat match goal with H : context [vDerive] |- _ => revert H end;
  repeat match goal with
  | |- context [D_ ?a ?b ?c ?d ?e ?f ?u] => change (D_ a b c d e f u) with (D a b c d e f (IZR u))
  | |- context [D_ ?a ?b ?c ?d ?e ?u] => change (D_ a b c d e u) with (D a b c d e (IZR u))
  | |- context [D_ ?a ?b ?c ?d ?u] => change (D_ a b c d u) with (D a b c d (IZR u))
  end; intros.
(* each vector that is derived or subtracted, worked out once; unfolded it is a curve *)
Ltac vector_at t unfolding curve := lazymatch t with _ :: _ => fail | _ =>
  let E := fresh in eassert (E : t = _) by (unfolding; curves curve; points; etransitivity; [on_left; entries | reflexivity]);
  rewrite E; clear E end.
Ltac vectors unfolding curve := repeat match goal with
  | |- context [vDerive 3 ?f 1 ?x] => vector_at (vDerive 3 f 1 x) unfolding curve
  | |- context [vsub ?a ?b] => first [vector_at a unfolding curve | vector_at b unfolding curve]
  end.
Ltac closed_numbers := conjuncts; compute_goal; parts; lazymatch goal with
  | |- _ = _ => etransitivity; [value | reflexivity]
  | |- _ => numeric
  end.
Ltac similar_quintic_numbers D := intros; with_quintic_numbers D joins_of_numbers; data_of_joins; with_quintic_numbers D values.
Ltac quintic_number_joins D := intros; with_quintic_numbers D joins_of_numbers; counted_joins.
Ltac quartic_number_joins D := intros; with_quartic_numbers D joins_of_numbers; counted_joins.
Ltac cubic_number_joins D := intros; with_cubic_numbers D joins_of_numbers; counted_joins.
Ltac flat c v := repeat match goal with |- context [poly c ?x] => replace (poly c x) with v by by_coefficients end.
Ltac any_points := repeat match goal with |- context [poly ?c ?x] => generalize (poly c x) end; intros.
(* a vector that is longer than one in the same direction *)
Lemma longer c b : c < 1 -> 0 < b -> c * b < b.
Proof. intros C B. apply (Rmult_lt_compat_r b) in C; lra. Qed.
Lemma length_positive x y z : 0 < x * x -> 0 < x * x + (y * y + (z * z + 0)).
Proof. intro X. pose proof (Rle_0_sqr y). pose proof (Rle_0_sqr z). unfold Rsqr in *. lra. Qed.

(* ---- patches ---- *)
Lemma patch_along (p q : R -> list R) p1 p2 p3 q1 q2 q3 a b u :
  (forall u, p u = [poly p1 u; poly p2 u; poly p3 u]) -> (forall u, q u = [poly q1 u; poly q2 u; poly q3 u]) ->
  vDerive 3 (fun u => vadd (vscale a (p u)) (vscale b (q u))) 1 u =
  [a * poly (slope p1) u + b * poly (slope q1) u; a * poly (slope p2) u + b * poly (slope q2) u;
   a * poly (slope p3) u + b * poly (slope q3) u].
Proof.
  intros P Q.
  assert (S : forall t, vadd (vscale a (p t)) (vscale b (q t)) = [poly (sums (map (Rmult a) p1) (map (Rmult b) q1)) t;
    poly (sums (map (Rmult a) p2) (map (Rmult b) q2)) t; poly (sums (map (Rmult a) p3) (map (Rmult b) q3)) t]).
  { intro t. rewrite P, Q. unfold vadd, vscale. cbn [zip map]. rewrite !poly_sums, !poly_scaled. reflexivity. }
  rewrite (curve_derive _ _ _ _ 1 u S). cbn [slope_n]. repeat apply (f_equal2 (@cons R)); try reflexivity.
  all: rewrite <- !poly_scaled, <- poly_sums; apply poly_nth; intro n;
    rewrite !slope_nth, !nth_sums, !nth_scaled, !slope_nth; ring.
Qed.
Lemma patch_across P1 P2 P3 Q1 Q2 Q3 v :
  vDerive 3 (fun v => vadd (vscale (1 - v) [P1; P2; P3]) (vscale v [Q1; Q2; Q3])) 1 v = [Q1 - P1; Q2 - P2; Q3 - P3].
Proof.
  unfold vDerive, vadd, vscale. cbn [seq map zip nth]. repeat apply (f_equal2 (@cons R)); [| | |reflexivity].
  all: derivative; ring.
Qed.
Ltac patch_at curve := match goal with
  | |- context [vDerive 3 ?f 1 ?x] => lazymatch f with (fun u => vadd (vscale ?a (@?p u)) (vscale ?b (@?q u))) =>
      let t := constr:(vDerive 3 f 1 x) in
      let P := fresh in eassert (P : forall u, p u = _) by (let u := fresh in intro u; curve u);
      let Q := fresh in eassert (Q : forall u, q u = _) by (let u := fresh in intro u; curve u);
      let E := fresh in pose proof (patch_along p q _ _ _ _ _ _ a b x P Q) as E;
      change (vDerive 3 (fun u => vadd (vscale a (p u)) (vscale b (q u))) 1 x) with t in E; rewrite E; clear E P Q
  end end.
Ltac patches curve := repeat patch_at curve; repeat curve_value curve; rewrite ?patch_across.

(* ---- powers ---- *)
Lemma monomial_curve u a1 a2 a3 b1 b2 b3 c1 c2 c3 d1 d2 d3 e1 e2 e3 f1 f2 f3 :
  vadd (vadd (vadd (vadd (vadd (vscale (u ^ 5) [a1; a2; a3]) (vscale (u ^ 4) [b1; b2; b3])) (vscale (u ^ 3) [c1; c2; c3]))
    (vscale (u ^ 2) [d1; d2; d3])) (vscale u [e1; e2; e3])) [f1; f2; f3] =
  [poly [f1; e1; d1; c1; b1; a1] u; poly [f2; e2; d2; c2; b2; a2] u; poly [f3; e3; d3; c3; b3; a3] u].
Proof. unfold vadd, vscale. cbn [zip map poly]. repeat apply (f_equal2 (@cons R)); try reflexivity; ring. Qed.
Ltac number_curve_at curve := match goal with |- context [Derive_n ?f ?n ?x] =>
  let Q := fresh in eassert (Q : forall u, f u = _) by (let u := fresh in intro u; curve u);
  rewrite (Derive_n_ext f (poly _) n x Q), poly_derive_n; clear Q end.
Ltac number_curves curve := repeat lazymatch goal with |- context [Derive_n] => number_curve_at curve end; values curve.

(* ---- coefficients of numbers in the condition ---- *)
Lemma affine f g c x : (forall s, f s = g s) -> (forall s, g s = g 0 + s * c) -> Derive_n f 1 x = c.
Proof.
  intros E L. rewrite (Derive_n_ext f g 1 x E), (Forms.slope g x); [|intro s; rewrite (L s), (L 1)]; [rewrite (L 1)|]; ring.
Qed.
Ltac affine_by rewriting := match goal with |- Derive_n ?f 1 ?x = ?c =>
  let E := fresh in eassert (E : forall s, f s = _) by (let s := fresh in intro s; cbv beta; rewriting; reflexivity);
  apply (affine f _ c x E); intro; cbv beta; ring end.
Ltac system_joins curve := parts; affine_by ltac:(joins_of_numbers curve; counted_joins).

(* ---- tangents in one ratio ---- *)
Lemma ratio_part (q p : R -> list R) q1 q2 q3 p1 p2 p3 k z :
  (forall u, q u = [poly q1 u; poly q2 u; poly q3 u]) -> (forall u, p u = [poly p1 u; poly p2 u; poly p3 u]) ->
  part_of (fun u => vsub (vDerive 3 q 1 u) (vscale k (vDerive 3 p 1 u))) z =
  map (fun c => INR (S (Z.to_nat z)) * c) [nth (S (Z.to_nat z)) q1 0 - k * nth (S (Z.to_nat z)) p1 0;
    nth (S (Z.to_nat z)) q2 0 - k * nth (S (Z.to_nat z)) p2 0; nth (S (Z.to_nat z)) q3 0 - k * nth (S (Z.to_nat z)) p3 0].
Proof.
  intros Q P. unfold part_of, factorial. generalize (Z.to_nat z). intro n.
  assert (S : forall u, vsub (vDerive 3 q 1 u) (vscale k (vDerive 3 p 1 u)) =
    [poly (sums (slope q1) (map (Rmult (- k)) (slope p1))) u; poly (sums (slope q2) (map (Rmult (- k)) (slope p2))) u;
     poly (sums (slope q3) (map (Rmult (- k)) (slope p3))) u]).
  { intro u. rewrite (curve_derive q _ _ _ 1 u Q), (curve_derive p _ _ _ 1 u P). unfold vsub, vscale. cbn [zip map slope_n].
    rewrite !poly_sums, !poly_scaled. repeat apply (f_equal2 (@cons R)); try reflexivity; ring. }
  rewrite (curve_derive _ _ _ _ n 0 S). unfold vdiv. cbn [map].
  repeat apply (f_equal2 (@cons R)); [| | |reflexivity].
  all: rewrite <- poly_derive_n, (coefficient_of _ _ n (fun u => eq_refl)), nth_sums, nth_scaled, !slope_nth; ring.
Qed.
Lemma ratio_of m a b k : m <> 0 -> m * (b - k * a) = 0 -> b = k * a.
Proof. intros N H. apply Rmult_integral in H as [H|H]; [contradiction | lra]. Qed.
Ltac ratio curve := match goal with
  | |- context [vdiv (vDerive 3 (fun u => vsub (vDerive 3 ?q 1 u) (vscale ?k (vDerive 3 ?p 1 u))) _ _) (factorial ?z)] =>
      let Q := fresh in eassert (Q : forall u, q u = _) by (let u := fresh in intro u; curve u);
      let P := fresh in eassert (P : forall u, p u = _) by (let u := fresh in intro u; curve u);
      let E := fresh in pose proof (ratio_part q p _ _ _ _ _ _ k z Q P) as E; unfold part_of in E; rewrite E; clear E P Q
  end.
(* what the equations say of the coefficients *)
Ltac in_ratio := intros; equations; repeat match goal with
  H : ?m * (?b - ?k * ?a) = 0 |- _ => apply (ratio_of m a b k) in H; [subst b | numeric] end.
Ltac ratios curve := repeat match goal with H : context [vDerive] |- _ => revert H end; repeat ratio curve;
  cbv beta iota delta [map nth zeros repeat Z.to_nat Pos.to_nat Pos.iter_op Nat.add].

(* ---- unknowns of the equations between numbers ---- *)
Ltac found := intros; equations; conjuncts; lazymatch goal with
  | |- _ = _ / _ => apply value_of; [nonzero | lra]
  | |- _ => lra
  end.

(* ---- determinants of matrices with zeros, and inverses that are known ---- *)
(* numbers, of which those that are 0 take no part in the expansion *)
Definition oadd (a b : option R) : option R := match a, b with None, b => b | a, None => a | Some x, Some y => Some (x + y) end.
Definition omul (a b : option R) : option R := match a, b with Some x, Some y => Some (x * y) | _, _ => None end.
Definition onum (a : option R) : R := match a with Some x => x | None => 0 end.
Lemma onum_add a b : onum (oadd a b) = onum a + onum b. Proof. destruct a, b; cbn; ring. Qed.
Lemma onum_mul a b : onum (omul a b) = onum a * onum b. Proof. destruct a, b; cbn; ring. Qed.
Lemma onum_opp a : onum (option_map Ropp a) = - onum a. Proof. destruct a; cbn; ring. Qed.
Lemma expansion_sparse n : forall M,
  expansion 0 1 Rplus Rmult Ropp n (map (map onum) M) = onum (expansion None (Some 1) oadd omul (option_map Ropp) n M).
Proof.
  induction n as [|n IH]; intros [|r M]; cbn [expansion map]; try reflexivity.
  generalize O, true. induction r as [|e r IHr]; intros j plus; cbn [map]; [reflexivity|].
  rewrite onum_add, onum_mul, <- IHr, <- IH. f_equal. f_equal.
  - destruct plus; [reflexivity|symmetry; apply onum_opp].
  - f_equal. rewrite !map_map. apply map_ext. intro l. apply drop_map.
Qed.
Lemma det_sparse M : det (map (map onum) M) = onum (expansion None (Some 1) oadd omul (option_map Ropp) (length M) M).
Proof. unfold det. rewrite map_length. apply expansion_sparse. Qed.
Ltac sparse_row l := lazymatch l with
  | nil => constr:(@nil (option R))
  | 0 :: ?l => let r := sparse_row l in constr:(None :: r)
  | ?a :: ?l => let r := sparse_row l in constr:(Some a :: r)
  end.
Ltac sparse_rows A := lazymatch A with
  | nil => constr:(@nil (list (option R)))
  | ?u :: ?A => let r := sparse_row u in let m := sparse_rows A in constr:(r :: m)
  end.
Ltac sparse_det := match goal with |- context [det ?A] => let M := sparse_rows A in
  change (det A) with (det (map (map onum) M)); rewrite det_sparse;
  cbv beta iota delta [onum expansion oadd omul option_map length map drop firstn skipn app negb] end.
Definition cofactors (A : list (list R)) : list (list R) :=
  map (fun j => map (fun i => cofactor A i j) (seq 0 (length A))) (seq 0 (length A)).
Lemma inverse_is A B d : det A = d -> d <> 0 -> cofactors A = mscale d B -> inverse A = B.
Proof.
  intros D N C. rewrite (inverse_by A d D). transitivity (mdiv (cofactors A) d).
  - unfold mdiv, vdiv, cofactors. rewrite map_map. apply map_ext. intro j. rewrite map_map. reflexivity.
  - rewrite C. unfold mdiv, vdiv, mscale, vscale. rewrite map_map. rewrite <- (map_id B) at 2. apply map_ext. intro r.
    rewrite map_map. rewrite <- (map_id r) at 2. apply map_ext. intro x. field. exact N.
Qed.
(* the inverse of A, whose determinant is d *)
Ltac inverse_known A d B := let D := fresh in assert (D : det A = d) by (sparse_det; ring);
  let I := fresh in assert (I : inverse A = B) by
    (apply (inverse_is A B d D); [nonzero | cbv beta iota zeta delta [cofactors cofactor mscale vscale length seq map Nat.even Nat.add drop firstn skipn app];
      parts; sparse_det; field; nonzero]);
  rewrite I; clear D I.
