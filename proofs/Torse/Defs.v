(* The definitions that statements use: all that a reader has to know besides the standard library and Coquelicot.
   A vector is a list of numbers, a matrix a list of rows; places are counted from 1. *)
From Coq Require Export Reals List ZArith.
From Coquelicot Require Export Coquelicot.
Export ListNotations.
Open Scope R_scope.

(* ---- sums ---- *)

(* low, low + 1, ..., high; nothing if high < low *)
Definition range (low high : Z) : list Z :=
  map (fun i => (low + Z.of_nat i)%Z) (seq 0 (Z.to_nat (high - low + 1))).

Definition sum (low high : Z) (f : Z -> R) : R := fold_right Rplus 0 (map f (range low high)).

(* ---- vectors ---- *)

Definition zeros (n : nat) : list R := repeat 0 n.
Fixpoint zip (f : R -> R -> R) (u v : list R) : list R :=
  match u, v with x :: u, y :: v => f x y :: zip f u v | _, _ => [] end.
Definition vadd := zip Rplus.
Definition vsub := zip Rminus.
Definition vopp := map Ropp.
Definition vscale (c : R) := map (Rmult c).
Definition vdiv (v : list R) (c : R) := map (fun x => x / c) v.
Definition entry (v : list R) (i : nat) : R := nth (pred i) v 0.
Definition dot (u v : list R) : R := fold_right Rplus 0 (zip Rmult u v).
Definition norm (v : list R) : R := sqrt (dot v v).
Definition cross (u v : list R) : list R :=
  [entry u 2 * entry v 3 - entry u 3 * entry v 2;
   entry u 3 * entry v 1 - entry u 1 * entry v 3;
   entry u 1 * entry v 2 - entry u 2 * entry v 1].

(* the sum of vectors of n numbers, entry by entry *)
Definition vsum (n : nat) (low high : Z) (f : Z -> list R) : list R :=
  map (fun i => sum low high (fun k => nth i (f k) 0)) (seq 0 n).

(* ---- matrices ---- *)

Definition mzeros (n m : nat) : list (list R) := repeat (zeros m) n.
Fixpoint mzip (f : list R -> list R -> list R) (A B : list (list R)) : list (list R) :=
  match A, B with u :: A, v :: B => f u v :: mzip f A B | _, _ => [] end.
Definition madd := mzip vadd.
Definition msub := mzip vsub.
Definition mopp := map vopp.
Definition mscale (c : R) := map (vscale c).
Definition mdiv (A : list (list R)) (c : R) := map (fun v => vdiv v c) A.
Definition row (A : list (list R)) (i : nat) : list R := nth (pred i) A [].
Definition mvec (A : list (list R)) (v : list R) : list R := map (fun u => dot u v) A.
Definition transpose (A : list (list R)) : list (list R) :=
  map (fun j => map (fun u => nth j u 0) A) (seq 0 (length (hd [] A))).
Definition mmul (A B : list (list R)) : list (list R) := map (mvec (transpose B)) A.
Definition identity (n : nat) : list (list R) :=
  map (fun i => map (fun j => if Nat.eqb i j then 1 else 0) (seq 0 n)) (seq 0 n).

(* a list without its member j, counted from 0 *)
Definition drop {T : Type} (j : nat) (l : list T) : list T := firstn j l ++ skipn (S j) l.

(* the determinant by expansion along the first row, over any carrier *)
Section Determinant.
  Context {T : Type} (zero one : T) (add mul : T -> T -> T) (opp : T -> T).
  Fixpoint expansion (n : nat) (M : list (list T)) : T :=
    match n, M with
    | S n, r :: M =>
        (fix go (j : nat) (row : list T) (plus : bool) : T :=
           match row with
           | [] => zero
           | e :: row => add (mul (if plus then e else opp e) (expansion n (map (drop j) M)))
                             (go (S j) row (negb plus))
           end) O r true
    | _, _ => one
    end.
End Determinant.
Definition det (A : list (list R)) : R := expansion 0 1 Rplus Rmult Ropp (length A) A.

(* the inverse by cofactors; the statements have the premise that the determinant is not zero *)
Definition cofactor (A : list (list R)) (i j : nat) : R :=
  (if Nat.even (i + j) then 1 else -1) * det (map (drop j) (drop i A)).
Definition inverse (A : list (list R)) : list (list R) :=
  map (fun j => map (fun i => cofactor A i j / det A) (seq 0 (length A))) (seq 0 (length A)).
Definition solve (A : list (list R)) (v : list R) : list R := mvec (inverse A) v.

(* ---- bases ---- *)

(* Seeds s_0, ..., s_d, functions of degree d, and the step f[i,k] = a f[i,k-1] + b f[i-1,k-1], all at one argument;
   zero outside of 0 <= i <= k. [fam a b seeds n i] is function i after n steps. *)
Fixpoint fam (a b : R) (seeds : list R) (n : nat) (i : Z) : R :=
  match n with
  | O => if (0 <=? i)%Z then nth (Z.to_nat i) seeds 0 else 0
  | S n => a * fam a b seeds n i + b * fam a b seeds n (i - 1)
  end.

(* function i of degree k; the statements have the premise d <= k *)
Definition basis (a b : R) (seeds : list R) (i k : Z) : R :=
  fam a b seeds (Z.to_nat (k - (Z.of_nat (length seeds) - 1))) i.

(* The same where the step depends on the function that is made: f[i,k] = a i k f[i,k-1] + b i k f[i-1,k-1], where a counts
   for i from 0 to k - 1 and b for i from 1 to k. *)
Fixpoint counted_fam (a b : Z -> Z -> R) (seeds : list R) (n : nat) (i : Z) : R :=
  match n with
  | O => if (0 <=? i)%Z then nth (Z.to_nat i) seeds 0 else 0
  | S n =>
      let k := Z.of_nat (length seeds + n) in
      (if ((0 <=? i) && (i <? k))%Z%bool then a i k * counted_fam a b seeds n i else 0) +
      (if ((0 <? i) && (i <=? k))%Z%bool then b i k * counted_fam a b seeds n (i - 1) else 0)
  end.
Definition counted (a b : Z -> Z -> R) (seeds : list R) (i k : Z) : R :=
  counted_fam a b seeds (Z.to_nat (k - (Z.of_nat (length seeds) - 1))) i.

(* ---- numbers ---- *)

(* n (n - 1) ... (n - j + 1) / j!, zero for a negative j *)
Fixpoint falling (n : R) (j : nat) : R :=
  match j with O => 1 | S j => falling n j * (n - INR j) / INR (S j) end.
Definition binom (n : R) (j : Z) : R := if (0 <=? j)%Z then falling n (Z.to_nat j) else 0.
Definition factorial (n : Z) : R := INR (fact (Z.to_nat n)).

(* the derivative of a vector of n numbers, entry by entry *)
Definition vDerive (n : nat) (f : R -> list R) (order : nat) (x : R) : list R :=
  map (fun i => Derive_n (fun t => nth i (f t) 0) order x) (seq 0 n).

(* a family of numbers with another number for one of its members *)
Definition update1 (P : Z -> R) (i : Z) (t : R) : Z -> R := fun j => if (j =? i)%Z then t else P j.
Definition update2 (P : Z -> Z -> R) (i j : Z) (t : R) : Z -> Z -> R :=
  fun k l => if ((k =? i) && (l =? j))%Z%bool then t else P k l.

(* ---- printed decimals: the value rounded, or cut off ---- *)

(* p is printed without a minus sign and with d digits after the point *)
Definition agrees_up (v p : R) (d : nat) : Prop :=
  Rabs (v - p) <= / 10 ^ d / 2 \/ p <= v < p + / 10 ^ d.
(* p is printed with a minus sign *)
Definition agrees_down (v p : R) (d : nat) : Prop :=
  Rabs (v - p) <= / 10 ^ d / 2 \/ p - / 10 ^ d < v <= p.
