(* Coefficients of members of families in linear forms: nobody has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved.
From Coq Require Import FunctionalExtensionality Lra Lia.
Open Scope R_scope.

(* a function that is seen to be linear has the difference of two values as its derivative *)
Lemma slope f p : (forall t, f t - f 0 = t * (f 1 - f 0)) -> Derive_n f 1 p = f 1 - f 0.
Proof.
  intro L. change (Derive f p = f 1 - f 0). apply is_derive_unique.
  apply is_derive_ext with (f := fun t => f 0 + t * (f 1 - f 0)).
  - intro t. pose proof (L t). lra.
  - auto_derive; [exact I|ring].
Qed.
Lemma update1_at P i t : update1 P i t i = t.
Proof. unfold update1. rewrite Z.eqb_refl. reflexivity. Qed.
Lemma update1_off P i t j : j <> i -> update1 P i t j = P j.
Proof. intro N. unfold update1. destruct (Z.eqb_spec j i); [contradiction|reflexivity]. Qed.
Lemma update2_at P i j t : update2 P i j t i j = t.
Proof. unfold update2. rewrite !Z.eqb_refl. reflexivity. Qed.
Lemma update2_off P i j t k l : k <> i \/ l <> j -> update2 P i j t k l = P k l.
Proof.
  intro N. unfold update2. destruct (Z.eqb_spec k i), (Z.eqb_spec l j); cbn [andb]; try reflexivity.
  destruct N; contradiction.
Qed.

(* which member it is *)
Ltac changed := repeat match goal with
  | |- context [update1 ?P ?i ?t ?j] => first
      [ replace (update1 P i t j) with t by (replace j with i by lia; symmetry; apply update1_at)
      | rewrite (update1_off P i t j) by lia ]
  | |- context [update2 ?P ?i ?j ?t ?k ?l] => first
      [ replace (update2 P i j t k l) with t by (replace k with i by lia; replace l with j by lia; symmetry; apply update2_at)
      | rewrite (update2_off P i j t k l) by lia ]
  end.
Ltac units ::= repeat match goal with
  | |- context [unit ?i ?j] => first [ rewrite (unit_one i j) by lia | rewrite (unit_zero i j) by lia ]
  end; changed.
Ltac evaluated := cbv beta; derivatives; operators; ends; special; tidied; maxes; units; members; numbers.
(* each form with its members told apart, as a function of the one that moves, and its derivative; where small degrees are
   told apart the coefficient is the difference of two values of its form *)
Ltac slope_as f p :=
  let g := fresh "g" in let E := fresh in
  evar (g : R -> R);
  assert (E : forall t, f t = g t) by (let t := fresh "t" in intro t; evaluated; subst g; reflexivity);
  subst g; rewrite (Derive_n_ext f _ 1 p E); clear E; cbv beta; derivatives.
Ltac slopes := repeat match goal with
  | |- context [Derive_n ?f 1 ?p] =>
      match f with context [update1] => idtac | context [update2] => idtac end;
      first [ slope_as f p
            | rewrite (slope f p) by (let t := fresh "t" in intro t; evaluated; equal) ]
  end.
(* integers that are given as numbers *)
Ltac numbered := repeat match goal with
  | H : IZR ?n = IZR _ |- _ => is_var n; apply eq_IZR in H; subst n
  end.
Ltac formed := computed; intros; numbered;
  repeat match goal with H : context [Derive_n _ _ _] |- _ => revert H end;
  closed_parts; slopes; evaluated; intros; equations; substituted; divisors; facts; parts; conjuncts;
  lazymatch goal with
  | |- _ <> _ => different
  | _ => settle
  end.
