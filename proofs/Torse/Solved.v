(* Equations with solutions that are known: nobody has to read it.
   The values of the unknowns come from the proof of the verdict; what is shown is that the equations have no others. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals.
From Coq Require Import FunctionalExtensionality Lra Lia.
Open Scope R_scope.

Lemma value_of x n d : d <> 0 -> x * d = n -> x = n / d.
Proof. intros N <-. field. exact N. Qed.
(* closed forms of definitions are not needed any more *)
Ltac unstaged := repeat match goal with E : ?c = _ |- _ => is_const c; clear E end.

(* ---- unknowns ---- *)
(* the unknown x is n / d: a linear combination of the equations, in which products of symbols count as one *)
Lemma cancelled c x y : c <> 0 -> c * x = c * y -> x = y.
Proof. intros N E. apply Rmult_eq_reg_l with c; assumption. Qed.
(* a factor that the value has lost *)
Ltac cancel := multimatch goal with
  | H : ?c <> 0 |- _ => apply (cancelled c); [exact H|]
  | H : ?c > 0 |- _ => apply (cancelled c); [lra|]
  | H : 0 < ?c |- _ => apply (cancelled c); [lra|]
  | H : ?a <> ?b |- _ => apply (cancelled (a - b)); [let E := fresh in intro E; apply H; lra|]
  end.
Ltac cancel_pi := apply (cancelled PI); [exact PI_neq0|].
(* values without divisors are put into the equations first *)
Ltac put_whole := progress repeat match goal with
  | E : ?x = ?v / 1 |- _ => unfold Rdiv in E; rewrite Rinv_1, Rmult_1_r in E; rewrite E in *; clear E
  end.
Ltac combination := first [lra | cancel; lra | cancel_pi; lra | cancel; cancel; lra].
Ltac determined := apply value_of; [different | first [combination | put_whole; combination]].
Ltac known x n d := let E := fresh "known" in assert (E : x = n / d) by determined.
(* the equations that determined x have done their work *)
Ltac spent x E := repeat match goal with H : ?A = ?B |- _ =>
  lazymatch H with E => fail | _ => match constr:(A = B) with context [x] => clear H end end end.
Ltac put_known := repeat match goal with E : ?x = _ / _ |- _ =>
  first [ is_var x; spent x E; subst x
        | let y := fresh "unknown" in set (y := x) in *; clearbody y; spent y E; subst y ]
  end.
Ltac concluded := parts; conjuncts; lazymatch goal with
  | |- agrees_up _ _ _ => rounded
  | |- agrees_down _ _ _ => rounded
  | |- _ <> _ => first [assumption | different]
  | |- _ = _ => first [assumption | atoms; equal | lra]
  | _ => order1
  end.

(* ---- unknowns as functions of a symbol ---- *)
(* what holds for all numbers holds for this one *)
Ltac at_value s := repeat match goal with
  | H : forall _ : R, _ |- _ => specialize (H s); cbv beta in H
  end.
Ltac along claim := assert claim by
  (let s := fresh "s" in intro s; at_value s;
   repeat match goal with H : context [Derive_n _ _ _] |- _ => revert H end;
   derivatives; special; intros; equations; repeat split; determined).
(* a function whose values are known *)
Ltac function f := let E := fresh in
  eassert (E : f = _) by
    (apply functional_extensionality; intro;
     match goal with H : forall _ : R, _ /\ _ |- _ => apply H | H : forall _ : R, f _ = _ |- _ => apply H end);
  subst f.
Ltac conclusion := cbv beta in *; repeat match goal with H : forall _ : R, _ |- _ => clear H end.
