(* Statements whose hypotheses are equations, and integers with few values: nobody has to read it.
   That an equation follows from others is shown by a combination of them, which a search for ideals finds and the kernel
   multiplies out. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Coq Require Import Lra Lia.
From Coq Require NsatzTactic Nsatz.
Open Scope R_scope.

(* ---- combinations of equations ---- *)
Ltac equations_alone := repeat match goal with H : ?T |- _ =>
  lazymatch type of T with Prop => lazymatch T with @eq R _ _ => fail | _ => clear H end end end.
Ltac ideal := solve [equations_alone; cbn [pow] in *; NsatzTactic.nsatz_default].
(* what is not zero has an inverse, a number with an equation *)
Lemma inverse_of a : a <> 0 -> exists i, i * a = 1.
Proof. intro H. exists (/ a). apply Rinv_l, H. Qed.
Ltac inverted := repeat match goal with
  | H : ?a <> 0 |- _ => let i := fresh "i" in destruct (inverse_of a H) as [i ?]; clear H
  end.
(* equations without quotients *)
Ltac quotient_in t := match t with context [_ / _] => idtac | context [/ _] => idtac end.
Ltac cleared := repeat match goal with
  | H : @eq R ?a ?b |- _ => first [quotient_in a | quotient_in b]; field_simplify_eq in H; [nonzero.. | ]
  end.
Ltac cleared_goal := lazymatch goal with
  | |- context [_ / _] => field_simplify_eq; [|nonzero..]
  | |- context [/ _] => field_simplify_eq; [|nonzero..]
  | _ => idtac
  end.
Ltac follows := cleared; cleared_goal; first [ ideal | inverted; ideal ].

(* ---- members that hypotheses know ---- *)
Ltac rewriting := repeat match goal with
  | H : ?P ?a = _ |- _ => is_var P; lazymatch type of P with Z -> R => idtac end; try rewrite H in *; clear H
  end.

(* ---- the tactics of scripts ---- *)
Ltac consequence := lazymatch goal with
  | |- @eq R _ _ => first [ solve [equal] | atoms; first [solve [equal] | follows] ]
  | |- _ <> 0 => nonzero
  | |- agrees_up _ _ _ => rounded
  | |- agrees_down _ _ _ => rounded
  | |- _ => order1
  end.
(* what holds for each of some integers without naming it *)
Ltac constants := repeat match goal with
  | H : forall i : Z, (?a <= i <= ?b)%Z -> ?P |- _ =>
      let K := fresh in assert (K : P) by (apply (H a); lia); clear H
  end.
(* what holds near a point holds at the point *)
Ltac pointwise := cbv zeta; intros; constants; repeat match goal with
  | H : locally ?p ?P |- _ => apply locally_singleton in H; cbv beta in H
  end; repeat match goal with x : _ |- _ => revert x end.
Ltac combined := pointwise; prepared; rewriting; members; parts; consequence.

(* the sides of the conclusion are unknowns that the hypotheses determine *)
Ltac concluded := repeat match goal with
  | |- context [@eq R (?P ?i) _] => is_var P; lazymatch type of P with Z -> R => unknown (P i) end
  end.
Ltac determined := pointwise; prepared; concluded; finished.

(* derivatives at points that are numbers are brought into their normal form one after the other *)
Ltac simplified := match goal with |- ?t = ?v => let n := fresh in set (n := v);
  first [ field_simplify; [subst n; reflexivity | nonzero..] | subst n; reflexivity ] end.
Ltac closed_derivative := match goal with
  | |- context [Derive_n ?f ?n ?p] =>
      let q := rat p in
      let e := reify f in
      let v := opened (ev (dxn n e) p) in
      let E := fresh in eassert (E : v = _) by (special; simplified);
      match type of E with _ = ?w => replace (Derive_n f n p) with w
        by (rewrite <- E; symmetry; apply (derive_as f e n p);
            [ reified | cbv beta iota delta [ok ev]; repeat split; nonzero ]) end; clear E
  | |- context [Derive_n ?f ?n ?p] =>
      erewrite (Derive_n_ext f _ n p);
      [|let y := fresh "y" in intro y; progress (repeat closed_derivative); reflexivity]
  end.
Ltac at_points := pointwise; computed; orders; repeat closed_derivative; combined.

(* ---- integers with few values, one after the other ---- *)
Lemma first_value a b i : (a <= i <= b)%Z -> i = a \/ (a + 1 <= i <= b)%Z.
Proof. lia. Qed.
Ltac values H := apply first_value in H; destruct H as [H | H];
  [ match type of H with ?v = _ => subst v end | first [ exfalso; clear -H; lia | values H ] ].
Ltac apart := intros; repeat match goal with
  | H : (?a <= ?i <= ?b)%Z |- _ => is_var i; closed_integer a; closed_integer b; values H
  end; constants; repeat match goal with x : _ |- _ => revert x end.
