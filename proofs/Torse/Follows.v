(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs.
From Coq Require Import Lra.
Open Scope R_scope.

(* rewriting by an equation, or by several, where they occur *)
Ltac use E := lazymatch E with (?A, ?B) => use A; use B | _ => try rewrite E end.
Ltac use_at E H := lazymatch E with (?A, ?B) => use_at A H; use_at B H | _ => try rewrite E in H end.
(* a tactic that begins with a match would run where it is passed, so that idtac stands before it *)
(* the definition P is C, where the definitions in it are replaced first; or P, if it is not *)
Ltac same_after P C tac := first [ exact (ltac:(unfold P; tac; reflexivity) : P = C) | exact (eq_refl P) ].
Tactic Notation "same" constr(P) constr(C) := same_after P C ltac:(idtac).
Tactic Notation "same" constr(P) constr(C) "by" constr(E) := same_after P C ltac:(idtac; use E).

(* what is assumed, or plain: divisors and radicands of witnesses *)
Ltac plain := first [ assumption | apply Rle_0_sqr | lra | nra ].

(* what is proved, at the values that are introduced *)
Ltac at_values H := lazymatch goal with
  | |- forall x : ?T, _ => lazymatch type of T with
      | Prop => intros
      | _ => let y := fresh x in intro y; specialize (H y); at_values H end
  | _ => idtac end.
Ltac by_premises H := lazymatch type of H with
  | ?A -> _ => let K := fresh in assert (K : A) by plain; specialize (H K); clear K; by_premises H
  | _ => idtac end.
Ltac witnessed H := lazymatch goal with
  | |- ex _ => eexists; witnessed H
  | _ => exact H end.
Ltac from H := hnf in H; cbv zeta in H; hnf; cbv zeta; at_values H; by_premises H;
  first [ exact H | witnessed H | apply H; assumption | lra | intuition lra ].
(* part by part, where what is quantified stands inside of the parts *)
Ltac by_parts H := hnf in H; cbv zeta in H; hnf; cbv zeta; intros;
  repeat match goal with |- _ /\ _ => split end; intros; eapply H; first [ eassumption | plain ].

(* the parts of a conjunction, and a conjunction of such parts *)
Ltac parted H := lazymatch type of H with
  | _ /\ _ => let A := fresh in destruct H as [A H]; parted H
  | _ => idtac end.
Ltac joined := first [ assumption | split; joined ].
(* values that meet the premises of what is proved meet those of what is printed *)
Ltac there H := lazymatch type of H with
  | ex _ => let x := fresh in destruct H as [x H]; exists x; there H
  | _ => parted H; joined end.

(* the same with other names for what is there *)
Ltac there_too H := hnf in H; hnf; repeat match type of H with ex _ => let x := fresh in destruct H as [x H] end;
  parted H; repeat match goal with |- ex _ => eexists end; repeat (split; [eassumption|]); eassumption.
(* nothing is there *)
Ltac nothing := let H := fresh in intro H; hnf in H;
  repeat match type of H with ex _ => let x := fresh in destruct H as [x H] end; parted H; nra.

(* with premises in another order, or written twice *)
Ltac reordered proved := let P := type of proved in
  let H := fresh in
  lazymatch eval hnf in P with
  | ex _ => pose proof proved as H; hnf in H; cbv zeta in H; hnf; cbv zeta; first [ there H | there_too H ]
  | _ /\ _ => pose proof proved as H; hnf in H; hnf; there H
  | _ -> False => intro H; apply proved; first [ from H | by_parts H ]
  | _ => pose proof proved as H; first [ from H | by_parts H ] end.

(* by conversion, else so *)
Ltac follows proved := first [ exact proved | reordered proved | nothing ].
