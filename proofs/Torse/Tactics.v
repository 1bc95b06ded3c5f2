(* The tactics of generated proofs: nobody has to read them, the kernel checks what they find.
   Nothing here searches far: each tactic does the steps that the verdict names. *)
From Torse Require Import Defs Series Theory Bounds.
From Coq Require Export Lra Lia.
From Coq Require Import QArith.
Open Scope R_scope.

(* ---- computing what has no symbols in it: sums of fixed length, bases of fixed degree, vectors, determinants ---- *)
Ltac whole t := eval cbv beta iota zeta delta
  [sum vsum range vadd vsub vopp vscale vdiv zip zeros entry dot norm cross mzeros mzip madd msub mopp mscale mdiv row
   mvec transpose mmul identity drop expansion det cofactor inverse solve basis fam counted counted_fam binom falling factorial vDerive
    update1 update2
   map fold_right seq repeat nth firstn skipn app hd tl length pred negb andb Nat.even Nat.eqb Nat.add Nat.sub Nat.mul fact
   Z.to_nat Z.of_nat Z.add Z.sub Z.mul Z.opp Z.leb Z.ltb Z.eqb Z.compare Z.pos_sub Z.double Z.succ_double Z.pred_double
   Pos.add Pos.succ Pos.mul Pos.compare Pos.compare_cont Pos.eqb Pos.pred_double Pos.to_nat Pos.iter_op Pos.of_succ_nat
   Pos.add_carry CompOpp powerRZ pow INR] in t.
Ltac compute_goal := match goal with |- ?g => let h := whole g in change h end.
Ltac compute_in H := let T := type of H in let U := whole T in change U in H.

(* the same where integers are symbols: vectors and matrices only, and sums and bases of fixed places *)
Ltac lists := cbv beta iota zeta delta
  [vsum vadd vsub vopp vscale vdiv zip zeros entry dot norm cross mzeros mzip madd msub mopp mscale mdiv row
   mvec transpose mmul identity drop expansion det cofactor inverse solve vDerive
   map fold_right seq repeat nth firstn skipn app hd tl length pred negb Nat.even Nat.eqb Nat.add Nat.sub].
Ltac closed_integer a := let v := eval vm_compute in a in
  lazymatch v with Z0 => idtac | Zpos _ => idtac | Zneg _ => idtac end.
Ltac closed_parts := repeat match goal with
  | |- context [basis ?a ?b ?s ?i ?k] => closed_integer i; closed_integer k;
      let t := constr:(basis a b s i k) in let v := whole t in change t with v
  | |- context [sum ?i ?k ?f] => closed_integer i; closed_integer k;
      let t := constr:(sum i k f) in let v := whole t in change t with v
  end.
(* without integer symbols everything computes *)
Ltac computed := lazymatch goal with |- forall _ : Z, _ => lists | _ => compute_goal end.

(* ---- closed numbers are enclosed ---- *)
Ltac num t := lazymatch t with
  | IZR ?z => constr:(NZ z)
  | PI => constr:(NPi)
  | ?a + ?b => let a := num a in let b := num b in constr:(NAdd a b)
  | ?a - ?b => let a := num a in let b := num b in constr:(NSub a b)
  | ?a * ?b => let a := num a in let b := num b in constr:(NMul a b)
  | ?a / ?b => let a := num a in let b := num b in constr:(NDiv a b)
  | - ?a => let a := num a in constr:(NOpp a)
  | / ?a => let a := num a in constr:(NInv a)
  | ?a ^ ?n => let a := num a in constr:(NPow a n)
  | sqrt ?a => let a := num a in constr:(NSqrt a)
  | exp ?a => let a := num a in constr:(NExp a)
  end.
Ltac less a b := let a := num a in let b := num b in
  exact (num_lt a b (@eq_refl bool true <: above (NSub b a) = true)).
Ltac at_most a b := let a := num a in let b := num b in
  exact (num_le a b (@eq_refl bool true <: not_below (NSub b a) = true)).
Ltac numeric := lazymatch goal with
  | |- ?a < ?b => less a b
  | |- ?a > ?b => less b a
  | |- ?a <= ?b => at_most a b
  | |- ?a >= ?b => apply Rle_ge; at_most b a
  | |- ?a <> ?b => let a := num a in let b := num b in
      exact (num_neq a b (@eq_refl bool true <: orb (above (NSub a b)) (above (NSub b a)) = true))
  end.

(* ---- derivatives ---- *)
Ltac reify f :=
  lazymatch f with
  | (fun x => x) => constr:(X)
  | (fun _ => ?r) => constr:(K r)
  | (fun x => @?a x + @?b x) => let a := reify a in let b := reify b in constr:(Ad a b)
  | (fun x => @?a x - @?b x) => let a := reify a in let b := reify b in constr:(Sb a b)
  | (fun x => @?a x * @?b x) => let a := reify a in let b := reify b in constr:(Ml a b)
  | (fun x => @?a x / @?b x) => let a := reify a in let b := reify b in constr:(Ml a (Iv b))
  | (fun x => - @?a x) => let a := reify a in constr:(Op a)
  | (fun x => / @?a x) => let a := reify a in constr:(Iv a)
  | (fun x => @?a x ^ ?n) => let a := reify a in constr:(Pw a n)
  | (fun x => sin (@?a x)) => let a := reify a in constr:(Si a)
  | (fun x => cos (@?a x)) => let a := reify a in constr:(Co a)
  | (fun x => exp (@?a x)) => let a := reify a in constr:(Ep a)
  | (fun x => sum 0 ?k (fun i => basis (1 - x) x [@?a x; @?b x; @?c x] i ?k * @?P i)) =>
      let a := reify a in let b := reify b in let c := reify c in constr:(Se a b c (k - 2) P)
  | (fun x => sum 0 ?k (fun i => basis (1 - x) x [@?a x] i ?k * @?P i)) =>
      let a := reify a in constr:(Se a (K 0) (K 0) k P)
  | (fun x => sum 0 ?k (fun i => basis ?u ?v [@?a x; @?b x; @?c x] i ?k * @?P i)) =>
      let a := reify a in let b := reify b in let c := reify c in constr:(Ss u v a b c (k - 2) P)
  | (fun x => basis (1 - x) x [@?a x; @?b x; @?c x] ?i ?k) =>
      let a := reify a in let b := reify b in let c := reify c in constr:(Se a b c (k - 2) (unit i))
  | (fun x => basis ?u ?v [@?a x; @?b x; @?c x] ?i ?k) =>
      let a := reify a in let b := reify b in let c := reify c in constr:(Ss u v a b c (k - 2) (unit i))
  end.
(* sums of a basis times control values as the operator *)
Ltac operators := repeat first
  [ rewrite series3 by lia | rewrite curve1 by lia | rewrite unity3 by lia | rewrite unity1 by lia
  | rewrite one_of_three by lia ].
Ltac opened t := eval cbv beta iota zeta delta
  [ev dxn dx occurs orb Z.of_nat Pos.of_succ_nat Pos.succ] in t.
Ltac nonzero := idtac.
Ltac reified := first [ intro; reflexivity | intro; cbv beta iota delta [ev]; operators; reflexivity ].
(* orders are numbers *)
Ltac orders := repeat match goal with
  | |- context [Derive_n ?f (Z.to_nat ?n) ?p] => closed_integer n;
      let k := eval vm_compute in (Z.to_nat n) in change (Z.to_nat n) with k
  end.
Ltac derivative :=
  match goal with
  | |- context [Derive_n ?f ?n ?p] =>
      let e := reify f in
      let v := opened (ev (dxn n e) p) in
      replace (Derive_n f n p) with v
        by (symmetry; apply (derive_as f e n p);
            [ reified | cbv beta iota delta [ok ev]; repeat split; nonzero ])
  | |- context [Derive_n ?f ?n ?p] =>
      erewrite (Derive_n_ext f _ n p);
      [|let y := fresh "y" in intro y; repeat derivative; reflexivity]
  end.
Ltac derivatives := orders; repeat derivative; cbv beta.

(* ---- angles ---- *)
Ltac rat t := lazymatch t with
  | IZR ?z => constr:((z # 1)%Q)
  | ?a + ?b => let a := rat a in let b := rat b in constr:((a + b)%Q)
  | ?a - ?b => let a := rat a in let b := rat b in constr:((a - b)%Q)
  | ?a * ?b => let a := rat a in let b := rat b in constr:((a * b)%Q)
  | ?a / ?b => let a := rat a in let b := rat b in constr:((a / b)%Q)
  | - ?a => let a := rat a in constr:((- a)%Q)
  | / ?a => let a := rat a in constr:((/ a)%Q)
  end.
(* the multiple of pi that an angle without symbols is *)
Ltac turns t := lazymatch t with
  | PI => constr:((1 # 1)%Q)
  | IZR 0 => constr:((0 # 1)%Q)
  | ?a + ?b => let a := turns a in let b := turns b in constr:((a + b)%Q)
  | ?a - ?b => let a := turns a in let b := turns b in constr:((a - b)%Q)
  | - ?a => let a := turns a in constr:((- a)%Q)
  | ?a / ?b => let a := turns a in let b := rat b in constr:((a / b)%Q)
  | ?a * ?b => match constr:(tt) with
      | _ => let a := turns a in let b := rat b in constr:((a * b)%Q)
      | _ => let a := rat a in let b := turns b in constr:((a * b)%Q) end
  end.
Ltac known f a b v l := replace (f a) with v by (replace a with b by (field || lra); symmetry; exact l).
Ltac sine a := let q := turns a in let q := eval vm_compute in (Qred q) in
  lazymatch q with
  | Qmake 0 1 => known sin a 0 0 sin_0
  | Qmake 1 2 => known sin a (PI/2) 1 sin_PI2
  | Qmake 1 1 => known sin a PI 0 sin_PI
  | Qmake 1 4 => known sin a (PI/4) (sqrt 2 / 2) sin_pi4
  | Qmake 1 6 => known sin a (PI/6) (1/2) sin_PI6
  | Qmake 1 3 => known sin a (PI/3) (sqrt 3 / 2) sin_PI3
  | Qmake 2 3 => known sin a (PI - PI/3) (sqrt 3 / 2) sin_2PI3'
  | Qmake 3 4 => known sin a (PI - PI/4) (sqrt 2 / 2) sin_3PI4'
  | Qmake 5 6 => known sin a (PI - PI/6) (1/2) sin_5PI6'
  | Qmake 3 2 => known sin a (3*(PI/2)) (-1) sin_3PI2
  | Qmake 2 1 => known sin a (2*PI) 0 sin_2PI
  | Qmake (-1) 2 => known sin a (-(PI/2)) (-1) sin_mPI2
  | Qmake (-1) 1 => known sin a (-PI) 0 sin_mPI
  end.
Ltac cosine a := let q := turns a in let q := eval vm_compute in (Qred q) in
  lazymatch q with
  | Qmake 0 1 => known cos a 0 1 cos_0
  | Qmake 1 2 => known cos a (PI/2) 0 cos_PI2
  | Qmake 1 1 => known cos a PI (-1) cos_PI
  | Qmake 1 4 => known cos a (PI/4) (sqrt 2 / 2) cos_pi4
  | Qmake 1 6 => known cos a (PI/6) (sqrt 3 / 2) cos_PI6
  | Qmake 1 3 => known cos a (PI/3) (1/2) cos_PI3
  | Qmake 2 3 => known cos a (PI - PI/3) (-(1/2)) cos_2PI3'
  | Qmake 3 4 => known cos a (PI - PI/4) (-(sqrt 2 / 2)) cos_3PI4'
  | Qmake 5 6 => known cos a (PI - PI/6) (-(sqrt 3 / 2)) cos_5PI6'
  | Qmake 3 2 => known cos a (3*(PI/2)) 0 cos_3PI2
  | Qmake 2 1 => known cos a (2*PI) 1 cos_2PI
  | Qmake (-1) 2 => known cos a (-(PI/2)) 0 cos_mPI2
  | Qmake (-1) 1 => known cos a (-PI) (-1) cos_mPI
  end.
Ltac special := repeat match goal with
  | |- context [sin ?a] => sine a
  | |- context [cos ?a] => cosine a
  end.
(* other angles that follow from one *)
Ltac same a b := replace a with b by (field || lra).
Ltac sine_by a b := first
  [ replace (sin a) with (sin b) by (f_equal; field)
  | replace (sin a) with (cos b) by (rewrite <- sin_shift; f_equal; field)
  | replace (sin a) with (2 * sin b * cos b) by (rewrite <- sin_2a; f_equal; field)
  | replace (sin a) with (- sin b) by (rewrite <- sin_neg; f_equal; field)
  | replace (sin a) with (sin b) by (symmetry; replace a with (PI - b) by field; apply sin_PI_x')
  | replace (sin a) with (cos b) by (symmetry; replace a with (PI/2 + b) by field; apply sin_PI2_plus)
  | replace (sin a) with (- (2 * sin b * cos b)) by (rewrite <- sin_2a, <- sin_2PI_minus; f_equal; field) ].
Ltac cosine_by a b := first
  [ replace (cos a) with (cos b) by (f_equal; field)
  | replace (cos a) with (sin b) by (rewrite <- cos_shift; f_equal; field)
  | replace (cos a) with (cos b * cos b - sin b * sin b) by (rewrite <- cos_2a; f_equal; field)
  | replace (cos a) with (cos b) by (rewrite <- (cos_neg b); f_equal; field)
  | replace (cos a) with (- cos b) by (symmetry; replace a with (PI - b) by field; apply cos_PI_x')
  | replace (cos a) with (- sin b) by (symmetry; replace a with (PI/2 + b) by field; apply cos_PI2_plus)
  | replace (cos a) with (cos b * cos b - sin b * sin b) by (rewrite <- cos_2a, <- cos_2PI_minus; f_equal; field) ].
Ltac relate b := repeat match goal with
  | |- context [sin ?a] => lazymatch a with b => fail | _ => sine_by a b end
  | |- context [cos ?a] => lazymatch a with b => fail | _ => cosine_by a b end
  end.
(* the angle b, or half of it if that occurs *)
Ltac smaller b k := first
  [ match goal with
    | |- context [sin ?a] => lazymatch a with b => fail | _ =>
        let E := fresh in assert (E : b = 2 * a) by field; clear E; k a end
    | |- context [cos ?a] => lazymatch a with b => fail | _ =>
        let E := fresh in assert (E : b = 2 * a) by field; clear E; k a end end
  | k b ].
(* sines and cosines become variables with the one relation that they have *)
Ltac circle b := let E := fresh "circle" in pose proof (circle_rule (sin b) (cos b) (square_sum b)) as E;
  generalize dependent (sin b); generalize dependent (cos b); intros.
Ltac settled b := relate b; circle b.
Ltac circles := repeat match goal with
  | |- context [sin ?b] => smaller b settled
  | |- context [cos ?b] => smaller b settled
  end.
Ltac roots :=
  repeat match goal with
  | |- context [sqrt ?q] => let E := fresh "root" in assert (E : sqrt q ^ 2 = q) by (apply square_root; (lra || numeric));
      let P := fresh in assert (P : 0 <= sqrt q) by apply sqrt_pos;
      generalize dependent (sqrt q); intros
  end.
(* those of later files *)
Ltac exponentials := idtac.
Ltac atoms := special; exponentials; circles; roots.

(* ---- what is not zero ---- *)
(* integers are known as numbers too *)
Ltac facts := repeat match goal with
  | H : (?a <= ?k)%Z |- _ => is_var k; lazymatch goal with _ : IZR a <= IZR k |- _ => fail | _ => pose proof (IZR_le _ _ H) end
  | H : (?a <= ?k <= ?b)%Z |- _ => is_var k; lazymatch goal with _ : IZR a <= IZR k |- _ => fail
      | _ => pose proof (IZR_le _ _ (proj1 H)); pose proof (IZR_le _ _ (proj2 H)) end
  end.
(* what is not zero and not negative is positive *)
Ltac positive := repeat match goal with
  | H : ?a <> 0 |- _ => lazymatch goal with _ : 0 < a |- _ => fail | _ : a < 0 |- _ => fail | _ => idtac end;
      first [ assert (0 < a) by (apply Rnot_le_lt; let E := fresh in intro E; apply H; lra)
            | assert (a < 0) by (apply Rnot_le_lt; let E := fresh in intro E; apply H; lra) ]
  end.
Ltac divisors := repeat match goal with
  | H : ?a * ?b <> 0 |- _ => apply factors in H as [? ?]
  | H : ?a / ?b <> 0 |- _ => apply quotient in H
  | H : ?a ^ S ?n <> 0 |- _ => apply power_base in H
  | H : - ?a <> 0 |- _ => apply opposite in H
  end.
Ltac nonzero ::= intros; repeat split; first
  [ assumption | numeric | apply PI_neq0
  | match goal with H : ?a <> 0 |- _ => let E := fresh in intro E; apply H; first [lra | rewrite E; ring] end
  | apply not_0_IZR; lia
  | facts; positive; pose proof PI_RGT_0; first
    [ apply Rgt_not_eq; lra | apply Rlt_not_eq; lra | apply Rgt_not_eq; nra | apply Rlt_not_eq; nra ]
  | apply product; nonzero
  | match goal with H : ?a <> 0 |- _ => let E := fresh in intro E; apply H; nra end ].

(* ---- equations ---- *)
Ltac modulo := match goal with
  | E : _ ^ 2 = _, F : _ ^ 2 = _, G : _ ^ 2 = _ |- _ => first [ring [E F G] | field_simplify_eq; [ring [E F G]|nonzero..]]
  | E : _ ^ 2 = _, F : _ ^ 2 = _ |- _ => first [ring [E F] | field_simplify_eq; [ring [E F]|nonzero..]]
  | E : _ ^ 2 = _ |- _ => first [ring [E] | field_simplify_eq; [ring [E]|nonzero..]]
  end.
Ltac equal := lazymatch goal with
  | |- ?a = ?a => reflexivity
  | |- ?a = ?b => first
    [ assumption
    | lazymatch goal with
      | |- context [_ / _] => field; nonzero
      | |- context [/ _] => field; nonzero
      | _ => ring end
    | modulo | symmetry; assumption | lra ]
  end.
Ltac parts := repeat match goal with
  | |- _ /\ _ => split
  | |- _ :: _ = _ :: _ => apply f_equal2
  | |- @nil _ = _ => reflexivity
  end.
Ltac conjuncts := repeat match goal with |- _ /\ _ => split end.
Ltac equations := repeat match goal with
  | H : _ /\ _ |- _ => lazymatch type of H with (_ <= _ <= _)%Z => fail | _ => destruct H end
  | H : _ :: _ = _ :: _ |- _ => injection H; clear H; intros
  end.
Ltac substituted := repeat match goal with H : ?x = _ |- _ => is_var x; subst x | H : _ = ?x |- _ => is_var x; subst x end.
Ltac identity := computed; intros; equations; substituted; divisors; parts; derivatives; atoms; equal.

(* ---- symbolic degree ---- *)
(* the operator at the ends *)
Ltac ends := repeat first
  [ rewrite pw_at0 | rewrite pw_end
  | match goal with |- context [pw (1 - ?a) ?b ?n ?Q] =>
      let q := rat a in let q := eval vm_compute in (Qred q) in lazymatch q with
      | Qmake 0 1 => replace (pw (1 - a) b n Q) with (Q 0%Z) by (symmetry; replace a with 0 by field; replace b with 0 by field; apply pw_at0)
      | Qmake 1 1 => replace (pw (1 - a) b n Q) with (pw (1 - 1) 1 n Q) by (f_equal; field)
      end end ];
  cbv beta delta [seed3 dl].
(* integers as numbers *)
Ltac numbers := rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR, ?opp_IZR.
(* small degrees apart, where a difference is cut off at zero *)
Ltac maxes := repeat match goal with
  | |- context [Z.max ?a 0] => first
      [ rewrite (Z.max_l a 0) by lia | rewrite (Z.max_r a 0) by lia
      | destruct (Z.max_spec a 0) as [[? ->]|[? ->]] ]
  end;
  repeat match goal with
  | k : Z |- _ => first
      [ assert (k = 0)%Z by lia; subst k | assert (k = 1)%Z by lia; subst k | assert (k = 2)%Z by lia; subst k
      | assert (k = 3)%Z by lia; subst k | assert (k = 4)%Z by lia; subst k ]
  end.
(* products with zero and one *)
Ltac tidy := rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rmult_1_l, ?Rmult_1_r, ?Rplus_0_l, ?Rplus_0_r, ?Rminus_0_r, ?Rminus_0_l, ?Ropp_0.
Ltac tidied := repeat progress (tidy; rewrite ?Rminus_eq_0, ?Rplus_opp_r).
(* indices in the form symbol plus number *)
Ltac form t := lazymatch t with
  | Z0 => constr:((Z0, t)) | Zpos _ => constr:((Z0, t)) | Zneg _ => constr:((Z0, t))
  | (?a + ?b)%Z => let x := form a in let y := form b in
      lazymatch x with (?u, ?c) => lazymatch y with (?v, ?d) =>
        let e := eval vm_compute in (c + d)%Z in
        lazymatch u with Z0 => constr:((v, e)) | _ => lazymatch v with Z0 => constr:((u, e)) end end end end
  | (?a - ?b)%Z => let x := form a in let y := form b in
      lazymatch x with (?u, ?c) => lazymatch y with (?v, ?d) =>
        let e := eval vm_compute in (c - d)%Z in
        lazymatch v with Z0 => constr:((u, e)) | u => constr:((Z0, e)) end end end
  | _ => let v := eval vm_compute in t in
      lazymatch v with Z0 => constr:((Z0, v)) | Zpos _ => constr:((Z0, v)) | Zneg _ => constr:((Z0, v)) | _ => constr:((t, Z0)) end
  end.
Ltac place a := let p := form a in lazymatch p with
  | (Z0, ?c) => c | (?v, Z0) => v | (?v, Zpos ?c) => constr:((v + Zpos c)%Z) | (?v, Zneg ?c) => constr:((v - Zpos c)%Z) end.
Ltac members := repeat match goal with
  | |- context [?P ?a] => is_var P; lazymatch type of P with Z -> _ => idtac end;
      let b := place a in lazymatch a with b => fail | _ => replace a with b by lia end
  | |- context [?P _ ?a] => is_var P; lazymatch type of P with Z -> Z -> _ => idtac end;
      let b := place a in lazymatch a with b => fail | _ => replace a with b by lia end
  end.
Ltac recursion := first
  [ rewrite basis_step by (cbn [length]; lia); ring
  | rewrite basis_below by lia; ring | rewrite basis_above by (cbn [length]; lia); ring ].
Ltac unities := first
  [ operators; apply pw_const; [ring|intro; unfold seed3; ring] ].
Ltac mirrored := apply basis_mirror;
  [ reflexivity | cbn [length]; lia
  | let i := fresh in intros i ?; cbn [length] in *; destruct i as [|[|[|i]]]; cbn [nth Nat.sub]; try lia; atoms; equal
  | cbn [length]; lia ].
(* functions of the basis at the ends *)
Ltac corners := repeat first
  [ rewrite basis_at0
  | rewrite basis_at1 by (cbn [length]; lia);
    match goal with |- context [fam _ _ _ O ?i] => let v := place i in lazymatch v with i => fail | _ => replace i with v by (cbn [length]; lia) end end ];
  repeat match goal with |- context [fam ?a ?b ?s O ?i] => closed_integer i; let t := constr:(fam a b s O i) in let v := whole t in change t with v end.
(* members that are known *)
Ltac rewritten := repeat match goal with
  | H : ?P ?a = _ |- context [?P ?a] => is_var P; lazymatch type of P with Z -> R => idtac end; rewrite H
  end.
Ltac mirrored' :=
  repeat match goal with |- context [1 - (1 - ?x)] => replace (1 - (1 - x)) with x by ring end;
  first [ mirrored | symmetry; mirrored ].
(* members of a unit sequence *)
Ltac units := repeat match goal with
  | |- context [unit ?i ?j] => first [ rewrite (unit_one i j) by lia | rewrite (unit_zero i j) by lia ]
  end.
(* sums in sums come to light one after the other *)
Ltac corner_sums := repeat (progress operators; ends).
(* series of the same step *)
Ltac one_series := rewrite <- ?pw_scal, <- ?pw_plus, <- ?pw_minus; apply pw_ext; intro; unfold seed3; ring.
Ltac settle := corners; ends; try corner_sums; special; tidied; maxes; units; members; rewritten; numbers; exponentials; circles; roots; equal.
Ltac quarter x := lazymatch goal with
  | _ : 0 <= sin (PI / 2 * x) <= 1 |- _ => fail
  | _ => let U := fresh in assert (U : 0 <= x <= 1) by lra;
      pose proof (quarter_sine x U); pose proof (quarter_cosine x U); clear U
  end.
Ltac signs := repeat match goal with
  | |- context [sin (PI / 2 * ?x)] => quarter x
  | |- context [cos (PI / 2 * ?x)] => quarter x
  end.
(* functions of a basis with seeds and step that are not negative *)
Ltac nonnegative := apply basis_nonneg; [ lra | lra |
  let i := fresh in intro i; signs; do 5 (destruct i as [|i]; cbn [nth]; [circles; nra|]); destruct i; cbn [nth]; lra ].
Ltac corner := first
  [ rewrite basis_at0; compute_goal; special; equal
  | rewrite basis_at1 by (cbn [length]; lia); match goal with |- context [fam _ _ _ O ?i] => let v := place i in replace i with v by (cbn [length]; lia) end;
    compute_goal; special; equal ].
Ltac symbolic1 := lazymatch goal with
  | |- context [Derive_n _ _ _] => derivatives; operators; settle
  | |- context [sum _ _ _] => first [ unities | operators; first [one_series | settle] ]
  | _ => first [ corner | recursion | mirrored | settle | mirrored' | nonnegative ]
  end.
Ltac symbolic := computed; intros; equations; substituted; divisors; parts; closed_parts; symbolic1.

(* ---- equations solved for unknowns ---- *)
(* a sum is not zero because its normal form is not *)
Ltac different := first [ nonzero | let E := fresh in intro E; first [ ring_simplify in E | field_simplify in E; [|nonzero..] ];
  revert E; match goal with |- ?t = 0 -> False => change (t <> 0) end; divisors; nonzero ].
(* [v] becomes the normal form of [t] *)
Ltac normal t name :=
  let n := fresh in evar (n : R);
  assert (name : t = n) by (cbv beta;
    lazymatch goal with
    | |- context [_ / _] => field_simplify; [subst n; reflexivity | different..]
    | |- context [/ _] => field_simplify; [subst n; reflexivity | different..]
    | _ => ring_simplify; subst n; reflexivity end); subst n.
(* x from the equation E *)
Ltac solving x E :=
  let T := type of E in lazymatch T with ?A = ?B =>
    let d := eval pattern x in (A - B) in
    lazymatch d with ?F _ =>
      lazymatch F with (fun _ => ?c) => fail | _ => idtac end;
      let N := fresh in let D := fresh in let H := fresh "value" in
      normal (F 0) N; normal (F 1 - F 0) D;
      match type of N with _ = ?n => match type of D with _ = ?d =>
        assert (d <> 0) by different;
        assert (H : x = - n / d) by
          (apply (solved F); [cbv beta; rewrite E; ring | cbv beta; first [ring | field; different] | assumption])
      end end; clear E N D; divisors; subst x
    end end.
(* the equations one after the other, each for the only unknown that is left in it *)
Ltac others x A := match goal with M : unknown_value ?y |- _ =>
  lazymatch y with x => fail | _ => match A with context [y] => idtac end end end.
Ltac solve_one := match goal with
  | M : unknown_value ?x, E : ?A = ?B |- _ =>
      lazymatch type of A with R => idtac end;
      match constr:(A = B) with context [x] => idtac end;
      tryif others x constr:(A = B) then fail else idtac;
      clear M; solving x E
  | M : unknown_value ?x, E : ?A = ?B |- _ =>
      lazymatch type of A with R => idtac end;
      match constr:(A = B) with context [x] => idtac end;
      clear M; solving x E
  end.
Ltac unknown u := let x := fresh "unknown" in set (x := u) in *; clearbody x;
  let M := fresh in assert (M : unknown_value x) by exact I.
Ltac prepared := computed; intros; repeat match goal with
  | H : context [Derive_n _ _ _] |- _ => revert H
  | H : context [sum _ _ _] |- _ => revert H
  | H : context [sin _] |- _ => revert H
  | H : context [cos _] |- _ => revert H
  end; closed_parts; derivatives; operators; ends; special; tidied; maxes; members; numbers; intros; equations; divisors; facts.
Ltac finished := repeat solve_one; parts; first [assumption | lra | field; different | atoms; equal].

(* ---- statements at a point ---- *)
Ltac near := match goal with
  | |- locally ?p (fun x => @?f x <> 0) => let e := reify f in
      apply (near_nonzero f e p); [reified | cbv beta iota delta [ok ev]; repeat split; special; nonzero | cbv beta iota delta [ev]; special; nonzero]
  end.
Ltac discharge := intros; repeat split; intros; first
  [ lia | left; lia | compute_goal; parts; first [ near | derivatives; special; first [ numeric | lra | equal | nonzero | left; lra | right; nonzero ] ] ].
Ltac premises H := repeat match type of H with
  | ?A -> ?B => match type of A with Prop =>
      let K := fresh in assert (K : A) by discharge; specialize (H K); clear K end
  | let _ := _ in _ => cbv zeta in H
  end.
(* an absolute value that is too large *)
Ltac far C := revert C; apply Rlt_not_le; match goal with |- _ < Rabs ?v => first
  [ apply Rlt_le_trans with v; [numeric|apply Rle_abs]
  | rewrite <- Rabs_Ropp; apply Rlt_le_trans with (- v); [numeric|apply Rle_abs] ] end.
Ltac contradiction_in C := lazymatch type of C with
  | _ /\ _ => let A := fresh in let B := fresh in destruct C as [A B]; first [contradiction_in A | contradiction_in B]
  | _ :: _ = _ :: _ => injection C; clear C; intros;
      match goal with H : _ = _ |- False => contradiction_in H end
  | agrees_up _ _ _ => destruct C as [C|[C D]]; [far C | first [contradiction_in C | contradiction_in D]]
  | agrees_down _ _ _ => destruct C as [C|[C D]]; [far C | first [contradiction_in C | contradiction_in D]]
  | ?a = ?b => first
      [ revert C; change (a <> b); numeric
      | revert C; exponentials; roots; intro C; pose proof PI_RGT_0; first [lra | nra] ]
  | _ => first [ apply C; first [numeric | equal]
      | match type of C with ?a < ?b => apply (Rlt_not_le _ _ C); numeric | ?a > ?b => apply (Rlt_not_le _ _ C); numeric
        | ?a <= ?b => apply (Rle_not_lt _ _ C); numeric | ?a >= ?b => apply (Rge_not_lt _ _ C); numeric end
      | lra | nra ]
  end.
Ltac refuting H0 :=
  let H := fresh in pose proof H0 as H; cbv beta zeta in H; premises H; compute_in H;
  revert H; derivatives; special; let C := fresh in intro C; contradiction_in C.
Ltac met := cbv beta zeta; discharge.

(* ---- order ---- *)
Ltac order1 := lazymatch goal with
  | |- _ = _ => atoms; equal
  | |- 0 <= basis _ _ _ _ _ => nonnegative
  | |- basis _ _ _ _ _ >= 0 => apply Rle_ge; nonnegative
  | _ => special; first [ numeric | lra | facts; signs; exponentials; circles; roots; pose proof PI_RGT_0; first [lra | nra] ]
  end.
Ltac rounded := cbv beta delta [agrees_up agrees_down]; special; first
  [ right; split; numeric | left; apply Rabs_le; split; numeric ].
Ltac ordered := computed; intros; equations; substituted; divisors; closed_parts; parts; derivatives; operators; ends; maxes; members; numbers;
  lazymatch goal with
  | |- agrees_up _ _ _ => rounded | |- agrees_down _ _ _ => rounded
  | _ => order1
  end.
