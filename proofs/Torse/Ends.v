(* Curves of blended trigonometric functions at the ends of their interval, for every degree, with the derivatives up to the
   third: nobody has to read it. Statements about joins speak of nothing else, and each value is computed once here. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Smooth.
From Coq Require Import Lia.
Open Scope R_scope.

Local Notation curve P k mu nu x := (sum 0 k (fun i => basis (1 - x) x
  [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x));
   1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x));
   (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k * P i)) (only parsing).
Section Ends.
Variables (P : Z -> R) (k : Z) (mu nu : R).
Hypothesis K : (2 <= k)%Z.
Lemma start_value : curve P k mu nu 0 = P 0%Z.
Proof. clear -K. symbolic. Qed.
Lemma end_value : curve P k mu nu 1 = P k.
Proof. clear -K. symbolic. Qed.
Lemma start_rate : Derive_n (fun x => curve P k mu nu x) 1 0 = (IZR k - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z).
Proof. clear -K. symbolic. Qed.
Lemma end_rate : Derive_n (fun x => curve P k mu nu x) 1 1 = (IZR k - 2 + PI / 2 * (1 + nu)) * (P k - P (k - 1)%Z).
Proof. clear -K. symbolic. Qed.
Lemma start_second : Derive_n (fun x => curve P k mu nu x) 2 0 =
  ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z
  + (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z
  + ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) * P 2%Z.
Proof. clear -K. symbolic. Qed.
Lemma end_second : Derive_n (fun x => curve P k mu nu x) 2 1 =
  ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2) * P k
  + (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2) * P (k - 1)%Z
  + ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) * P (k - 2)%Z.
Proof. clear -K. symbolic. Qed.
Lemma start_third : Derive_n (fun x => curve P k mu nu x) 3 0 =
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4 + 3 * (PI / 2) * (1 + mu)) * (P 3%Z - 3 * P 2%Z + 3 * P 1%Z - P 0%Z)
  + 3 * (IZR k - 2) * (PI / 2) ^ 2 * ((1 - nu) * (P 3%Z - 2 * P 2%Z + P 1%Z) - 2 * mu * (P 2%Z - 2 * P 1%Z + P 0%Z))
  - (1 + mu) * (PI / 2) ^ 3 * (P 1%Z - P 0%Z).
Proof. clear -K. symbolic. Qed.
Lemma end_third : Derive_n (fun x => curve P k mu nu x) 3 1 =
  (IZR k - 2) * (IZR k - 3) * (IZR k - 4 + 3 * (PI / 2) * (1 + nu)) * (P k - 3 * P (k - 1)%Z + 3 * P (k - 2)%Z - P (k - 3)%Z)
  - 3 * (IZR k - 2) * (PI / 2) ^ 2 * ((1 - mu) * (P (k - 1)%Z - 2 * P (k - 2)%Z + P (k - 3)%Z) - 2 * nu * (P k - 2 * P (k - 1)%Z + P (k - 2)%Z))
  - (1 + nu) * (PI / 2) ^ 3 * (P k - P (k - 1)%Z).
Proof. clear -K. symbolic. Qed.
End Ends.


(* a cubic curve whose four terms are written out *)
Local Notation blend mu nu x i := (basis (1 - x) x
  [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x));
   1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x));
   (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i 3%Z) (only parsing).
Local Notation cubic mu nu a b c d x :=
  (blend mu nu x 0%Z * a + blend mu nu x 1%Z * b + blend mu nu x 2%Z * c + blend mu nu x 3%Z * d) (only parsing).
Section Cubic.
Variables mu nu a b c d : R.
Let P (i : Z) : R := nth (Z.to_nat i) [a; b; c; d] 0.
Lemma four f : f 0%Z * a + f 1%Z * b + f 2%Z * c + f 3%Z * d = sum 0 3 (fun i => f i * P i).
Proof. unfold P. compute_goal. ring. Qed.
Ltac as_curve E := eapply eq_trans; [first [apply (four (fun i => blend mu nu _ i)) | apply Derive_n_ext; intro; apply (four (fun i => blend mu nu _ i))] |];
  rewrite E by lia; unfold P; compute_goal; field.
Lemma cubic_start_value : cubic mu nu a b c d 0 = a.
Proof. as_curve start_value. Qed.
Lemma cubic_end_value : cubic mu nu a b c d 1 = d.
Proof. as_curve end_value. Qed.
Lemma cubic_start_rate : Derive_n (fun x => cubic mu nu a b c d x) 1 0 = (1 + PI / 2 * (1 + mu)) * (b - a).
Proof. as_curve start_rate. Qed.
Lemma cubic_end_rate : Derive_n (fun x => cubic mu nu a b c d x) 1 1 = (1 + PI / 2 * (1 + nu)) * (d - c).
Proof. as_curve end_rate. Qed.
Lemma cubic_start_second : Derive_n (fun x => cubic mu nu a b c d x) 2 0 =
  (PI * (1 + mu) + 2 * mu * (PI / 2) ^ 2) * a - (2 * PI * (1 + mu) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * b
  + (PI * (1 + mu) + (1 - nu) * (PI / 2) ^ 2) * c.
Proof. as_curve start_second. Qed.
Lemma cubic_end_second : Derive_n (fun x => cubic mu nu a b c d x) 2 1 =
  (PI * (1 + nu) + 2 * nu * (PI / 2) ^ 2) * d - (2 * PI * (1 + nu) + (2 * nu + 1 - mu) * (PI / 2) ^ 2) * c
  + (PI * (1 + nu) + (1 - mu) * (PI / 2) ^ 2) * b.
Proof. as_curve end_second. Qed.
End Cubic.

(* ---- in statements ---- *)
Ltac every L := repeat rewrite L by (assumption || lia).
Ltac at_ends := progress (
  every start_value; every end_value; every start_rate; every end_rate;
  every start_second; every end_second; every start_third; every end_third;
  every cubic_start_value; every cubic_end_value; every cubic_start_rate; every cubic_end_rate;
  every cubic_start_second; every cubic_end_second).
(* integers that are numbers *)
Ltac whole_numbers := repeat match goal with
  | H : IZR ?k = IZR _ |- _ => is_var k; apply eq_IZR in H; subst k
  end.
(* premises are brought into the goal, and all that was introduced is put back *)
Definition mark := True.
Ltac back := repeat lazymatch goal with x : ?T |- _ => lazymatch T with mark => fail | _ => revert x end end.
Ltac brought := repeat match goal with
  | H : context [sum _ _ _] |- _ => revert H
  end.
Ltac premises_with tactic :=
  let M := fresh in pose proof (I : mark) as M; lists; intros; whole_numbers; brought; tactic; back; clear M.
Ltac curves_at_ends := premises_with at_ends.
(* the same for sums of curves *)
Ltac sums_at_ends := premises_with ltac:(try at_ends; spread_derivatives; try at_ends).
Ltac computed ::= try curves_at_ends; tryif assert_succeeds symbolic_integers then lists else compute_goal.
Ltac evaluated ::= cbv beta; try at_ends; derivatives; operators; ends; special; tidied; maxes; units; members; numbers.

(* ---- the matrices that take points to end values ---- *)
Lemma inverse_lower a b c d e f : det [[a; 0; 0]; [b; c; 0]; [d; e; f]] <> 0 ->
  a <> 0 /\ c <> 0 /\ f <> 0 /\
  inverse [[a; 0; 0]; [b; c; 0]; [d; e; f]] = [[1 / a; 0; 0]; [- b / (a * c); 1 / c; 0]; [(b * e - c * d) / (a * c * f); - e / (c * f); 1 / f]].
Proof.
  intro D. assert (N : a <> 0 /\ c <> 0 /\ f <> 0).
  { revert D. lists. intro D. repeat split; intro Z; apply D; rewrite Z; ring. }
  destruct N as (A & C & F). repeat split; try assumption. compute_goal. parts; field; repeat split; assumption.
Qed.
Section Matrices.
Variables (Q : Z -> R) (k : Z) (mu nu : R).
Hypothesis K : (2 <= k)%Z.
Local Notation by_member i f := (Derive_n (fun t => f (update1 Q i t)) 1 (Q i)) (only parsing).
Lemma start_matrix :
  [[by_member 0%Z (fun Q => curve Q k mu nu 0); by_member 1%Z (fun Q => curve Q k mu nu 0); by_member 2%Z (fun Q => curve Q k mu nu 0)];
   [by_member 0%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0); by_member 1%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0); by_member 2%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 0)];
   [by_member 0%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0); by_member 1%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0); by_member 2%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 0)]] =
  [[1; 0; 0];
   [- (IZR k - 2 + PI / 2 * (1 + mu)); IZR k - 2 + PI / 2 * (1 + mu); 0];
   [(IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2;
    - (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2;
    (IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2]].
Proof. clear -K. cbv beta. parts; slopes; changed; ring. Qed.
Lemma end_matrix :
  [[by_member k (fun Q => curve Q k mu nu 1); by_member (k - 1)%Z (fun Q => curve Q k mu nu 1); by_member (k - 2)%Z (fun Q => curve Q k mu nu 1)];
   [by_member k (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1); by_member (k - 1)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1); by_member (k - 2)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 1 1)];
   [by_member k (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1); by_member (k - 1)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1); by_member (k - 2)%Z (fun Q => Derive_n (fun x => curve Q k mu nu x) 2 1)]] =
  [[1; 0; 0];
   [IZR k - 2 + PI / 2 * (1 + nu); - (IZR k - 2 + PI / 2 * (1 + nu)); 0];
   [(IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2;
    - (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2;
    (IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2]].
Proof. clear -K. cbv beta. parts; slopes; changed; ring. Qed.
End Matrices.
Ltac lower E := rewrite E in *;
  match goal with D : det [[?a; 0; 0]; [?b; ?c; 0]; [?d; ?e; ?f]] <> 0 |- _ =>
    let I := fresh in destruct (inverse_lower a b c d e f D) as (? & ? & ? & I); rewrite I; clear I D
  end; cbv beta iota delta [row entry nth pred].
(* the inverse of a matrix [m] of end values, by the lemma that knows the matrix *)
Ltac inverse_of_ends m known := match goal with |- context [m ?Q ?k ?mu ?nu] =>
  let E := fresh in assert (E : m Q k mu nu = _) by (exact (known Q k mu nu ltac:(assumption))); lower E; clear E end.
