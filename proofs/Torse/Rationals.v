(* Determinants and inverses of matrices of rational numbers, computed: nobody has to read it.
   The kernel expands them over the rationals, which takes no time, where a normal form of real numbers takes minutes. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Coq Require Import QArith Qreals Lra Lia.
Open Scope R_scope.

Definition qadd (a b : Q) : Q := Qred (a + b).
Definition qmul (a b : Q) : Q := Qred (a * b).
Definition detq (M : list (list Q)) : Q := expansion 0%Q 1%Q qadd qmul Qopp (length M) M.
Definition inverseq (M : list (list Q)) : list (list Q) :=
  map (fun j => map (fun i =>
    qmul (qmul (if Nat.even (i + j) then 1 else -1) (detq (map (drop j) (drop i M)))) (/ detq M))
    (seq 0 (length M))) (seq 0 (length M)).

Lemma drop_map {S T} (f : S -> T) j l : drop j (map f l) = map f (drop j l).
Proof. unfold drop. rewrite firstn_map, skipn_map, map_app. reflexivity. Qed.
Lemma qr_0 : qr 0 = 0. Proof. exact (qr_z 0). Qed.
Lemma qr_1 : qr 1 = 1. Proof. exact (qr_z 1). Qed.
Lemma qr_qadd a b : qr (qadd a b) = qr a + qr b. Proof. unfold qadd. rewrite red. apply qr_plus. Qed.
Lemma qr_qmul a b : qr (qmul a b) = qr a * qr b. Proof. unfold qmul. rewrite red. apply qr_mult. Qed.

Lemma expansion_rational n : forall M,
  expansion 0 1 Rplus Rmult Ropp n (map (map qr) M) = qr (expansion 0%Q 1%Q qadd qmul Qopp n M).
Proof.
  induction n as [|n IH]; intros [|r M]; cbn [expansion map]; try (symmetry; apply qr_1).
  generalize O, true. induction r as [|e r IHr]; intros j plus; cbn [map].
  - symmetry. apply qr_0.
  - rewrite qr_qadd, qr_qmul, <- IHr, <- IH. f_equal. f_equal.
    + destruct plus; [reflexivity|symmetry; apply qr_opp].
    + f_equal. rewrite !map_map. apply map_ext. intro l. apply drop_map.
Qed.
Lemma det_rational M : det (map (map qr) M) = qr (detq M).
Proof. unfold det, detq. rewrite map_length. apply expansion_rational. Qed.
Lemma inverse_rational M : Qeq_bool (detq M) 0 = false ->
  inverse (map (map qr) M) = map (map qr) (inverseq M).
Proof.
  intro N. assert (D : ~ (detq M == 0)%Q) by (intro E; apply Qeq_bool_iff in E; congruence).
  unfold inverse, inverseq. rewrite map_length, map_map. apply map_ext. intro j. rewrite map_map. apply map_ext. intro i.
  unfold cofactor. rewrite !qr_qmul, qr_inv by exact D. rewrite det_rational. unfold Rdiv. f_equal. f_equal.
  - destruct (Nat.even (i + j)); [symmetry; apply qr_1|]. symmetry. exact (qr_z (-1)).
  - rewrite drop_map, <- det_rational. f_equal. rewrite !map_map. apply map_ext. intro l. apply drop_map.
Qed.

(* a matrix of closed numbers *)
Ltac rational_row l := lazymatch l with
  | nil => constr:(@nil Q)
  | ?a :: ?l => let q := rat a in let q := eval vm_compute in (Qred q) in let r := rational_row l in constr:(q :: r)
  end.
Ltac rational_rows A := lazymatch A with
  | nil => constr:(@nil (list Q))
  | ?u :: ?A => let r := rational_row u in let m := rational_rows A in constr:(r :: m)
  end.
Ltac as_real q := lazymatch q with
  | Qmake ?z 1 => constr:(IZR z)
  | Qmake ?z ?d => constr:(IZR z / IZR (Zpos d))
  end.
Ltac real_row l := lazymatch l with
  | nil => constr:(@nil R)
  | ?q :: ?l => let a := as_real q in let r := real_row l in constr:(a :: r)
  end.
Ltac real_rows A := lazymatch A with
  | nil => constr:(@nil (list R))
  | ?u :: ?A => let r := real_row u in let m := real_rows A in constr:(r :: m)
  end.
Ltac same_entries := cbv beta iota delta [map]; unfold qr, Q2R; cbn [Qnum Qden];
  repeat match goal with
  | |- _ :: _ = _ :: _ => apply f_equal2
  | |- nil = _ => reflexivity
  end; first [reflexivity | lra].
Ltac rational_inverse A :=
  let M := rational_rows A in
  let I := eval vm_compute in (inverseq M) in
  let B := real_rows I in
  let E := fresh in
  assert (E : inverse A = B) by
    (transitivity (inverse (map (map qr) M)); [apply f_equal; same_entries|];
     rewrite (inverse_rational M) by (vm_compute; reflexivity);
     transitivity (map (map qr) I); [apply f_equal; vm_compute; reflexivity | same_entries]);
  rewrite E; clear E.
Ltac rational_det A :=
  let M := rational_rows A in
  let d := eval vm_compute in (Qred (detq M)) in
  let b := as_real d in
  let E := fresh in
  assert (E : det A = b) by
    (transitivity (det (map (map qr) M)); [apply f_equal; same_entries|];
     rewrite det_rational, <- red; transitivity (qr d); [apply f_equal; vm_compute; reflexivity | same_entries]);
  rewrite E; clear E.
Ltac determinants := repeat match goal with |- context [det ?A] => rational_det A end.

Ltac inverses ::= unfold solve; repeat match goal with
  | |- context [inverse ?A] => first
      [ rational_inverse A
      | let D := fresh in eassert (D : det A = _) by (etransitivity; [on_left; derivatives; closed_form | reflexivity]);
        let I := fresh in eassert (I : inverse A = _) by
          (rewrite (inverse_by A _ D); etransitivity; [on_left; entries | reflexivity]);
        rewrite I; clear I D ]
  end.
Ltac staged_goal D ::= cbv beta iota zeta delta [D row entry nth pred]; staged; cbv beta zeta; determinants.
