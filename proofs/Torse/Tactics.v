(* The tactics of generated proofs: nobody has to read them, the kernel checks what they find.
   Nothing here searches: each tactic does the steps that the verdict names. *)
From Torse Require Import Defs Series Theory.
From Coq Require Export Lra Lia.
Open Scope R_scope.

(* ---- computing what has no symbols in it: sums of fixed length, bases of fixed degree, vectors, determinants ---- *)
Ltac whole t := eval cbv beta iota zeta delta
  [sum vsum range vadd vsub vopp vscale vdiv zip zeros entry dot norm cross mzeros mzip madd msub mopp mscale mdiv row
   mvec transpose mmul identity drop expansion det cofactor inverse solve basis fam binom falling factorial vDerive
   map fold_right seq repeat nth firstn skipn app hd tl length pred negb Nat.even Nat.eqb Nat.add Nat.sub Nat.mul fact
   Z.to_nat Z.of_nat Z.add Z.sub Z.mul Z.opp Z.leb Z.compare Z.pos_sub Z.double Z.succ_double Z.pred_double
   Pos.add Pos.succ Pos.mul Pos.compare Pos.compare_cont Pos.pred_double Pos.to_nat Pos.iter_op Pos.of_succ_nat
   Pos.add_carry CompOpp slope] in t.
Ltac compute_goal := match goal with |- ?g => let h := whole g in change h end.
Ltac compute_in H := let T := type of H in let U := whole T in change U in H.

(* the same where integers are symbols: vectors and matrices only *)
Ltac lists := cbv beta iota zeta delta
  [vadd vsub vopp vscale vdiv zip zeros entry dot norm cross mzeros mzip madd msub mopp mscale mdiv row
   mvec transpose mmul identity drop expansion det cofactor inverse solve vDerive
   map fold_right seq repeat nth firstn skipn app hd tl length pred negb Nat.even Nat.eqb Nat.add Nat.sub slope].

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
  | (fun x => sum 0 ?k (fun i => basis (1 - x) x [@?a x; @?b x; @?c x] i ?k * @?P i)) =>
      let a := reify a in let b := reify b in let c := reify c in constr:(Se a b c (k - 2) P)
  | (fun x => sum 0 ?k (fun i => basis (1 - x) x [@?a x] i ?k * @?P i)) =>
      let a := reify a in constr:(Se a (K 0) (K 0) k P)
  end.
(* sums of a basis times control values as the operator *)
Ltac operators := repeat first
  [ rewrite series3 by lia | rewrite curve1 by lia | rewrite unity3 by lia | rewrite unity1 by lia ].
Ltac opened t := eval cbv beta iota zeta delta
  [ev dxn dx occurs orb Z.of_nat Pos.of_succ_nat Pos.succ] in t.
Ltac nonzero := idtac.
Ltac derivative :=
  match goal with
  | |- context [Derive_n ?f ?n ?p] =>
      let e := reify f in
      let v := opened (ev (dxn n e) p) in
      replace (Derive_n f n p) with v
        by (symmetry; apply (derive_as f e n p);
            [ first [ intro; reflexivity | intro; cbv beta iota delta [ev]; operators; reflexivity ]
            | cbv beta iota delta [ok ev]; repeat split; nonzero ])
  | |- context [Derive_n ?f ?n ?p] =>
      erewrite (Derive_n_ext f _ n p);
      [|let y := fresh "y" in intro y; repeat derivative; reflexivity]
  end.
Ltac derivatives := repeat derivative; cbv beta.

(* ---- angles ---- *)
Ltac angle a b l :=
  let E := fresh in assert (E : a = b) by (field); rewrite ?E; clear E; rewrite ?l.
Ltac special :=
  repeat match goal with
  | |- context [sin ?a] => first
      [ replace (sin a) with 0 by (replace a with 0 by field; symmetry; exact sin_0)
      | replace (sin a) with 1 by (replace a with (PI/2) by field; symmetry; exact sin_PI2)
      | replace (sin a) with 0 by (replace a with PI by field; symmetry; exact sin_PI)
      | replace (sin a) with (sqrt 2 / 2) by (replace a with (PI/4) by field; symmetry; exact sin_pi4)
      | replace (sin a) with (1 / 2) by (replace a with (PI/6) by field; symmetry; exact sin_PI6)
      | replace (sin a) with (sqrt 3 / 2) by (replace a with (PI/3) by field; symmetry; exact sin_PI3)
      | replace (sin a) with (-1) by (replace a with (3*(PI/2)) by field; symmetry; exact sin_3PI2)
      | replace (sin a) with 0 by (replace a with (2*PI) by field; symmetry; exact sin_2PI) ]
  | |- context [cos ?a] => first
      [ replace (cos a) with 1 by (replace a with 0 by field; symmetry; exact cos_0)
      | replace (cos a) with 0 by (replace a with (PI/2) by field; symmetry; exact cos_PI2)
      | replace (cos a) with (-1) by (replace a with PI by field; symmetry; exact cos_PI)
      | replace (cos a) with (sqrt 2 / 2) by (replace a with (PI/4) by field; symmetry; exact cos_pi4)
      | replace (cos a) with (sqrt 3 / 2) by (replace a with (PI/6) by field; symmetry; exact cos_PI6)
      | replace (cos a) with (1 / 2) by (replace a with (PI/3) by field; symmetry; exact cos_PI3)
      | replace (cos a) with 0 by (replace a with (3*(PI/2)) by field; symmetry; exact cos_3PI2)
      | replace (cos a) with 1 by (replace a with (2*PI) by field; symmetry; exact cos_2PI) ]
  end.
(* a = PI/2 - b for an angle b that occurs too; a = 2 b likewise *)
Ltac related :=
  repeat match goal with
  | |- context [sin ?a] =>
      match goal with
      | |- context [sin ?b] => lazymatch a with b => fail | _ =>
          first [ replace (sin a) with (cos b) by (rewrite <- sin_shift; f_equal; field)
                | replace (sin a) with (2 * sin b * cos b) by (rewrite <- sin_2a; f_equal; field)
                | replace (sin a) with (sin b) by (f_equal; field) ] end
      | |- context [cos ?b] => lazymatch a with b => fail | _ =>
          first [ replace (sin a) with (cos b) by (rewrite <- sin_shift; f_equal; field)
                | replace (sin a) with (2 * sin b * cos b) by (rewrite <- sin_2a; f_equal; field)
                | replace (sin a) with (sin b) by (f_equal; field) ] end
      end
  | |- context [cos ?a] =>
      match goal with
      | |- context [sin ?b] => lazymatch a with b => fail | _ =>
          first [ replace (cos a) with (sin b) by (rewrite <- cos_shift; f_equal; field)
                | replace (cos a) with (cos b * cos b - sin b * sin b) by (rewrite <- cos_2a; f_equal; field)
                | replace (cos a) with (cos b) by (f_equal; field) ] end
      | |- context [cos ?b] => lazymatch a with b => fail | _ =>
          first [ replace (cos a) with (sin b) by (rewrite <- cos_shift; f_equal; field)
                | replace (cos a) with (cos b * cos b - sin b * sin b) by (rewrite <- cos_2a; f_equal; field)
                | replace (cos a) with (cos b) by (f_equal; field) ] end
      end
  end.
(* sines and cosines become variables with the one relation that they have *)
Ltac circles :=
  repeat match goal with
  | |- context [sin ?a] => let E := fresh "circle" in pose proof (square_sum a) as E;
      generalize dependent (sin a); generalize dependent (cos a); intros
  | |- context [cos ?a] => let E := fresh "circle" in pose proof (square_sum a) as E;
      generalize dependent (sin a); generalize dependent (cos a); intros
  end.
Lemma square_root q : 0 <= q -> sqrt q ^ 2 = q.
Proof. intro H. simpl. rewrite Rmult_1_r. apply sqrt_sqrt, H. Qed.
Lemma circle_rule s c : s ^ 2 + c ^ 2 = 1 -> c ^ 2 = 1 - s ^ 2.
Proof. intro; lra. Qed.
Ltac roots :=
  repeat match goal with
  | |- context [sqrt ?q] => let E := fresh "root" in assert (E : sqrt q ^ 2 = q) by (apply square_root; lra);
      let P := fresh in assert (P : 0 <= sqrt q) by apply sqrt_pos;
      generalize dependent (sqrt q); intros
  end.
Ltac rules := repeat match goal with E : ?s ^ 2 + ?c ^ 2 = 1 |- _ => apply circle_rule in E end.

(* ---- what is not zero ---- *)
Ltac nonzero ::= repeat split; first
  [ assumption | lra | apply PI_neq0
  | match goal with H : ?a <> 0 |- _ => let E := fresh in intro E; apply H; first [lra | nra] end
  | pose proof PI_RGT_0; apply Rgt_not_eq; first [lra | nra]
  | pose proof PI_RGT_0; apply Rlt_not_eq; first [lra | nra] ].

(* ---- equations ---- *)
Ltac equal :=
  first
  [ reflexivity
  | ring
  | field; nonzero
  | rules; first
    [ match goal with
      | E : _ ^ 2 = _, F : _ ^ 2 = _, G : _ ^ 2 = _ |- _ => first [ring [E F G] | field_simplify_eq; [ring [E F G]|nonzero..]]
      | E : _ ^ 2 = _, F : _ ^ 2 = _ |- _ => first [ring [E F] | field_simplify_eq; [ring [E F]|nonzero..]]
      | E : _ ^ 2 = _ |- _ => first [ring [E] | field_simplify_eq; [ring [E]|nonzero..]]
      end ] ].
Ltac parts := repeat match goal with
  | |- _ /\ _ => split
  | |- _ :: _ = _ :: _ => apply f_equal2
  | |- @nil _ = _ => reflexivity
  end.
Ltac atoms := special; related; circles; roots.
Ltac identity := compute_goal; parts; derivatives; atoms; equal.

(* ---- symbolic degree ---- *)
(* the operator at the ends *)
Ltac ends := repeat first
  [ rewrite pw_at0 | rewrite pw_end
  | match goal with |- context [pw (1 - ?a) ?b ?n ?Q] =>
      first [ progress replace (pw (1 - a) b n Q) with (Q 0%Z) by (symmetry; replace a with 0 by field; apply pw_at0) ] end ];
  cbv beta delta [seed3 dl].
(* integers as numbers *)
Ltac numbers := rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR, ?opp_IZR.
(* small degrees apart, where a difference is cut off at zero *)
Ltac maxes := repeat match goal with
  | |- context [Z.max ?a 0] =>
      destruct (Z.max_spec a 0) as [[? ->]|[? ->]]; try (exfalso; lia)
  end;
  repeat match goal with
  | k : Z |- _ => first
      [ assert (k = 0)%Z by lia; subst k | assert (k = 1)%Z by lia; subst k | assert (k = 2)%Z by lia; subst k
      | assert (k = 3)%Z by lia; subst k | assert (k = 4)%Z by lia; subst k ]
  end.
(* indices without symbols are computed *)
Ltac indices := repeat match goal with
  | |- context [?P ?a] => is_var P;
      let v := eval vm_compute in a in
      lazymatch v with Z0 => idtac | Zpos _ => idtac | Zneg _ => idtac end;
      lazymatch a with v => fail | _ => idtac end; change (P a) with (P v)
  end.
(* members with equal indices are the same member *)
Ltac members := repeat match goal with
  | |- context [?P ?a] => is_var P;
      lazymatch type of P with Z -> R => idtac | Z -> Z -> R => idtac end;
      match goal with |- context [P ?b] =>
        lazymatch b with a => fail | _ => idtac end;
        replace (P b) with (P a) by (f_equal; lia) end
  end.
Ltac recursion := first
  [ rewrite basis_step by (cbn [length]; lia); ring
  | rewrite basis_below by lia; ring | rewrite basis_above by (cbn [length]; lia); ring ].
Ltac unities := first
  [ operators; apply pw_const; [ring|intro; unfold seed3; ring] ].
Ltac mirrored := apply basis_mirror;
  [ reflexivity | cbn [length]; lia
  | intros i Hi; cbn [length] in *; destruct i as [|[|[|i]]]; cbn [nth Nat.sub]; try lia; atoms; equal
  | cbn [length]; lia ].
Ltac settle := ends; maxes; indices; members; numbers; atoms; equal.
Ltac symbolic1 := first
  [ recursion | unities | mirrored
  | derivatives; operators; settle ].
Ltac symbolic := lists; parts; symbolic1.

(* ---- equations solved for unknowns ---- *)
Ltac isolate x :=
  match goal with
  | E : ?A = ?B |- _ =>
      let d := eval pattern x in (A - B) in
      lazymatch d with
      | ?F _ =>
          lazymatch F with (fun _ => ?c) => fail | _ => idtac end;
          let H := fresh "value" in
          assert (H : x = - F 0 / (F 1 - F 0)) by
            (apply (solved F); [cbv beta; rewrite E; ring | cbv beta; first [ring | field; nonzero] | cbv beta; nonzero]);
          cbv beta in H; clear E; subst x
      end
  end.
(* ---- refutations: the statement at the witness, its premises proved, computes to something false ---- *)
Ltac false_equation := match goal with
  | |- ?a = ?b -> False => let E := fresh in intro E; first
      [ lra
      | pose proof PI_RGT_0; nra
      | apply Rminus_diag_eq in E; field_simplify in E; [pose proof PI_RGT_0; first [lra | nra] | nonzero..] ]
  | |- _ => intro; first [lra | nra]
  end.
Ltac discharge := first [lia | lra | nonzero | (compute_goal; derivatives; atoms; equal) | nra].
Ltac premises H := repeat match type of H with
  | ?A -> ?B => match type of A with Prop => let K := fresh in assert (K : A) by (intros; discharge); specialize (H K); clear K end
  | let _ := _ in _ => cbv zeta in H
  end.
Ltac refuting H0 :=
  let H := fresh in pose proof H0 as H; cbv beta zeta in H; premises H;
  revert H; compute_goal; derivatives; special; roots;
  repeat match goal with |- (_ /\ _) -> False => let A := fresh in let B := fresh in intros [A B]; first [revert A; clear B; false_equation | revert B; clear A] end;
  false_equation.
Ltac met := compute_goal; repeat split; intros; derivatives; first [lra | lia | nonzero | atoms; equal | nra].
Ltac ordered := compute_goal; parts; derivatives; first [assumption | lra | atoms; equal | nra].
Ltac equations := repeat match goal with
  | H : _ /\ _ |- _ => destruct H
  | H : _ :: _ = _ :: _ |- _ => injection H as H
  end.
(* without integer symbols everything computes *)
Ltac compute_or_lists := lazymatch goal with k : Z |- _ => lists | _ => compute_goal end.
(* members that equations determine become numbers *)
Ltac unknown u := let x := fresh "unknown" in set (x := u) in *; clearbody x; isolate x.
Ltac prepared := repeat match goal with
  | H : context [Derive_n _ _ _] |- _ => revert H
  | H : context [sum _ _ _] |- _ => revert H
  end; compute_or_lists; derivatives; operators; ends; maxes; indices; members; numbers; special; intros; equations.
Ltac finished := parts; first [assumption | lra | atoms; equal].
