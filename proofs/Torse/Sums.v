(* Sums of symbolic length as linear combinations of sums that nothing can be taken out of: nobody has to read it. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs.
Open Scope R_scope.

Lemma unity_of_three a b s t u k : (2 <= k)%Z -> a + b = 1 -> s + t + u = 1 ->
  sum 0 k (fun i => basis a b [s; t; u] i k) = 1.
Proof. intros K H E. rewrite unity3 by exact K. apply pw_const; [exact H|]. intro i. unfold seed3. lra. Qed.
Lemma unity_of_one a b s k : (0 <= k)%Z -> a + b = 1 -> s = 1 -> sum 0 k (fun i => basis a b [s] i k) = 1.
Proof. intros K H E. rewrite unity1 by exact K. apply pw_const; [exact H|]. intro i. unfold seed3. lra. Qed.

(* [sum l h (fun k => a k * f k * g k * ...)] as a combination: [a], or nothing, is a product of what depends on k and
   cannot be split, the basis in front, and [todo] has the factors that are not looked at yet *)
Ltac times a f := lazymatch a with
  | tt => f
  | (fun i => basis ?u ?v ?s i ?k) =>
      constr:(fun i : Z => basis u v s i k * ltac:(let t := eval cbv beta in (f i) in exact t))
  | (fun i => basis ?u ?v ?s i ?k * @?g i) =>
      constr:(fun i : Z => basis u v s i k * ltac:(let t := eval cbv beta in (g i * f i) in exact t))
  | _ => lazymatch f with
    | (fun i => basis ?u ?v ?s i ?k) =>
        constr:(fun i : Z => basis u v s i k * ltac:(let t := eval cbv beta in (a i) in exact t))
    | _ => constr:(fun i : Z => ltac:(let t := eval cbv beta in (a i * f i) in exact t))
    end
  end.
(* a sum of fixed length in a sum *)
Ltac over g js := lazymatch js with
  | nil => constr:(fun _ : Z => 0)
  | cons ?j nil => constr:(fun i : Z => ltac:(let t := eval cbv beta in (g i j) in exact t))
  | cons ?j ?js => let r := over g js in
      constr:(fun i : Z => ltac:(let t := eval cbv beta in (g i j + r i) in exact t))
  end.
Ltac combination l h a todo := lazymatch todo with
  | tt => lazymatch a with tt => constr:(sum l h (fun _ => 1)) | _ => constr:(sum l h a) end
  | (?f, ?rest) => lazymatch f with
    | (fun _ => ?c) => let r := combination l h a rest in constr:(c * r)
    | (fun i => @?x i + @?y i) =>
        let r := combination l h a (x, rest) in let s := combination l h a (y, rest) in constr:(r + s)
    | (fun i => @?x i - @?y i) =>
        let r := combination l h a (x, rest) in let s := combination l h a (y, rest) in constr:(r - s)
    | (fun i => - @?x i) => let r := combination l h a (x, rest) in constr:(- r)
    | (fun i => @?x i / @?y i) => combination l h a (x, ((fun i : Z => ltac:(let t := eval cbv beta in (/ y i) in exact t)), rest))
    | (fun i => @?x i * @?y i) => combination l h a (x, (y, rest))
    | (fun i => sum ?low ?high (@?g i)) =>
        let c := match constr:(tt) with _ => closed_integer low; closed_integer high end in
        let js := eval vm_compute in (range low high) in
        let x := over g js in combination l h a (x, rest)
    | _ => let b := times a f in combination l h b rest
    end
  end.
(* a sum of which something can be taken out *)
Ltac fixed_ranges := repeat match goal with
  | |- context [range ?l ?h] => closed_integer l; closed_integer h;
      let v := eval vm_compute in (range l h) in change (range l h) with v
  end.
Ltac split_sum l h f :=
  tryif (closed_integer l; closed_integer h) then fail else idtac;
  let r := combination l h tt (f, tt) in
  lazymatch r with sum l h f => fail | _ => idtac end;
  replace (sum l h f) with r by
    (unfold sum; fixed_ranges; induction (range l h) as [|? ? IH]; cbn [map fold_right]; unfold Rdiv;
     [ring | unfold Rdiv in IH; cbn [map fold_right] in IH; rewrite <- IH; ring]).
Ltac unity := match goal with
  | |- context [sum 0 ?k (fun i => basis ?a ?b [?s; ?t; ?u] i ?k)] =>
      rewrite (unity_of_three a b s t u k) by first [lia | ring]
  | |- context [sum 0 ?k (fun i => basis ?a ?b [?s] i ?k)] =>
      rewrite (unity_of_one a b s k) by first [lia | ring]
  end.
Ltac linear_sums := repeat first
  [ match goal with |- context [sum ?l ?h ?f] => inner_sum l h f end
  | match goal with |- context [sum ?l ?h ?f] => split_sum l h f end
  | unity ]
(* sums in sums, from the inside *)
with inner_sum l h f :=
  lazymatch f with context [sum] => idtac end;
  erewrite (sum_ext l h f _);
  [|let i := fresh "i" in intros i ?; cbv beta; progress linear_sums; reflexivity]; cbv beta.
(* the same below derivatives *)
Ltac linear_derivatives := repeat match goal with
  | |- context [Derive_n ?f ?n ?p] =>
      lazymatch f with context [sum] => idtac | context [basis] => idtac end;
      erewrite (Derive_n_ext f _ n p);
      [|let y := fresh "y" in intro y; cbv beta; progress (linear_sums; closed_parts); reflexivity]; cbv beta
  end.
(* integers that are symbols, also those of a part of a statement *)
Ltac symbolic_integers := intros; match goal with
  | _ : Z |- _ => idtac
  | |- context [forall i : Z, @?P i] => lazymatch type of P with Z -> Prop => idtac end
  end.
Ltac computed ::= tryif assert_succeeds symbolic_integers then lists else compute_goal.
Ltac sums := linear_derivatives; linear_sums.
Ltac symbolic := computed; intros; equations; substituted; divisors; parts; intros; equations; closed_parts; sums; closed_parts;
  first [lazymatch goal with |- context [Derive_n _ _ _] => fail | _ => ring end | symbolic1].
