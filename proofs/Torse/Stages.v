(* Definitions of a statement in closed form, one after the other: nobody has to read it.
   A definition that is used by another is computed once, its derivatives and inverses included, and stands for itself below
   binders; unfolding all definitions at once would compute it anew at each use. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns.
From Coq Require Import FunctionalExtensionality QArith.
Open Scope R_scope.

(* ---- closed rational numbers ---- *)
Lemma number e q : enclose e = Some (q, q) -> nv e = IZR (Qnum q) / IZR (Zpos (Qden q)).
Proof.
  intro E. pose proof (enclosed e) as H. rewrite E in H. cbn [inside] in H.
  replace (nv e) with (qr q) by lra. unfold qr, Q2R, Rdiv. reflexivity.
Qed.
Lemma whole_number e z : enclose e = Some ((z # 1)%Q, (z # 1)%Q) -> nv e = IZR z.
Proof. intro E. rewrite (number e _ E). cbn [Qnum Qden]. field. Qed.
(* [t = ?v] for a closed number *)
Ltac value := match goal with |- ?t = _ =>
  let e := num t in let q := eval vm_compute in (enclose e) in
  lazymatch q with
  | Some (Qmake ?z 1, _) => exact (whole_number e z (@eq_refl box (Some ((z # 1)%Q, (z # 1)%Q)) <: enclose e = Some ((z # 1)%Q, (z # 1)%Q)))
  | Some (?q, ?q) => let z := eval cbv in (Qnum q) in let d := eval cbv in (Zpos (Qden q)) in
      exact ((number e q (@eq_refl box (Some (q, q)) <: enclose e = Some (q, q))) : nv e = IZR z / IZR d)
  end end.

(* ---- definitions ---- *)
(* a definition at some values of the integer that is its last argument *)
Definition by_case {T : Type} (z n : Z) (a b : T) : T := if Z.eqb n z then a else b.
Lemma cases_of {T : Type} (z n : Z) (x a b : T) : (n = z -> x = a) -> (n <> z -> x = b) -> x = by_case z n a b.
Proof. intros A B. unfold by_case. destruct (Z.eqb_spec n z); auto. Qed.
(* those that are known in closed form. A second occurrence of a variable of a pattern, and a failing rewrite, would compare
   all subterms up to conversion: the constant is looked for as it stands. *)
Ltac put_form c E := lazymatch goal with
  | |- context [c] => rewrite E; cbv beta; cbv beta iota delta [by_case Z.eqb Pos.eqb]
  end.
Ltac staged := repeat match goal with E : ?c = _ |- _ => is_const c; put_form c E end.
Ltac on_left := match goal with |- ?t = ?v => let u := whole t in change (u = v) end.
(* [t = ?v]: the closed form of t, or t itself where none is found *)
Ltac divided t := match t with
  | context [_ / ?d] => lazymatch d with IZR _ => fail | _ => idtac end
  | context [/ ?d] => lazymatch d with IZR _ => fail | _ => idtac end
  end.
Ltac closed_form := first [ value |
  let n := fresh in
  match goal with |- ?t = ?v => set (n := v); first
    [ divided t; field_simplify; [subst n; reflexivity | different..]
    | lazymatch t with context [_ / _] => fail | context [/ _] => fail | _ => idtac end; ring_simplify; subst n; reflexivity
    | subst n; reflexivity ] end ].
Ltac entries := lazymatch goal with
  | |- _ :: _ = _ => refine (f_equal2 (@cons _) _ _); [entries | entries]
  | |- nil = _ => reflexivity
  | |- @eq R _ _ => derivatives; closed_form
  | |- _ => reflexivity
  end.
(* determinants and inverses of matrices, each once *)
Lemma inverse_by A d : det A = d ->
  inverse A = map (fun j => map (fun i => cofactor A i j / d) (seq 0 (length A))) (seq 0 (length A)).
Proof. intros <-. reflexivity. Qed.
Ltac inverses := unfold solve; repeat match goal with
  | |- context [inverse ?A] =>
      let D := fresh in eassert (D : det A = _) by (etransitivity; [on_left; derivatives; closed_form | reflexivity]);
      let I := fresh in eassert (I : inverse A = _) by
        (rewrite (inverse_by A _ D); etransitivity; [on_left; entries | reflexivity]);
      rewrite I; clear I D
  end.
Ltac arguments := lazymatch goal with
  | |- @eq (_ -> _) _ _ => apply functional_extensionality; intro; arguments
  | |- _ => cbv beta
  end.
(* what integers are symbols of is left as it is *)
Ltac integers := match goal with _ : Z |- _ => idtac end.
(* what definitions are known to be, once for a section *)
Class Closed {T : Type} (d c : T) : Prop := closed : d = c.
Ltac closing D := arguments; cbv beta delta [D]; staged; cbv beta zeta;
  tryif integers then reflexivity else (etransitivity; [inverses; on_left; special; entries | reflexivity]).
(* a definition of a section in closed form *)
Ltac closed_once D := let E := fresh in eassert (E : D = _) by (closing D); exact E.
Ltac cases D l := lazymatch l with
  | ?z :: ?l => match goal with n : Z |- _ => apply (cases_of z n) end;
      [ let E := fresh in intro E; rewrite E; clear E; cbv beta delta [D]; staged; cbv beta zeta;
        etransitivity; [inverses; on_left; special; entries | reflexivity]
      | intros _; cases D l ]
  | _ => reflexivity
  end.
Ltac closed_at D l := let E := fresh in
  eassert (E : D = _) by (arguments; cases D l); exact E.
Ltac known_form D E := pose proof (closed (d := D)) as E; cbv beta in E.
Ltac stage D :=
  let E := fresh "stage" in first [ known_form D E | eassert (E : D = _) by closing D ].
Ltac stage_at D l :=
  let E := fresh "stage" in first [ known_form D E | eassert (E : D = _) by (arguments; cases D l) ].
(* the last definition is unfolded where it stands, and only what is left of it is looked at *)
Ltac staged_goal D := let E := fresh "stage" in first
  [ known_form D E; staged; cbv beta iota zeta delta [row entry nth pred]
  | cbv beta iota zeta delta [D row entry nth pred]; staged; cbv beta zeta ].
