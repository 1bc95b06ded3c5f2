(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Sums.
Open Scope R_scope.

Module sum_powers.
Import Bezier.Part_Sums.sum_powers.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m M; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n; induction n as [|n IH]; [ rewrite sum_empty by lia; cbn [Z.of_nat]; field | rewrite sum_last by lia; replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; field ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z; lia. Qed.
End sum_powers.

Module sum_powers_slip.
Import Bezier.Part_Sums.sum_powers_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((3))%Z). Qed.
End sum_powers_slip.

Module sum_powers_slip_corrected.
Import Bezier.Part_Sums.sum_powers_slip_corrected.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m M; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n; induction n as [|n IH]; [ rewrite sum_empty by lia; cbn [Z.of_nat]; field | rewrite sum_last by lia; replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; field ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z; lia. Qed.
End sum_powers_slip_corrected.

Module sum_swap.
Import Bezier.Part_Sums.sum_swap.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m P M _; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n; induction n as [|n IH]; [ compute_goal; ring | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P j)) by lia; cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => P l)) by lia; replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 + 1 - IZR j) * P j) (fun j => (IZR (Z.of_nat n) + 1 - IZR j) * P j + P j)) by (intros; ring); rewrite sum_plus; change (sum 0 (Z.of_nat n) (fun l : Z => P l)) with (sum 0 (Z.of_nat n) P); ring ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, (fun _ => 0); repeat split; lia. Qed.
End sum_swap.

Module sum_swap_weighted.
Import Bezier.Part_Sums.sum_swap_weighted.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m P M _; rewrite <- (Z2Nat.id m) by lia; generalize (Z.to_nat m); clear; intro n; assert (L : sum 0 (Z.of_nat n) (fun j => sum 0 j (fun l => P l)) = sum 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 - IZR j) * P j)) by (induction n as [|n IH]; [ compute_goal; ring | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P j)) by lia; cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => P l)) by lia; replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 + 1 - IZR j) * P j) (fun j => (IZR (Z.of_nat n) + 1 - IZR j) * P j + P j)) by (intros; ring); rewrite sum_plus; change (sum 0 (Z.of_nat n) (fun l : Z => P l)) with (sum 0 (Z.of_nat n) P); ring ]); clear L; induction n as [|n IH]; [ compute_goal; field | rewrite (sum_last 0 (Z.of_nat (S n))), (sum_last 0 (Z.of_nat (S n)) (fun j => _ * P j)) by lia; cbv beta; rewrite (sum_last 0 (Z.of_nat (S n)) (fun l => _ * P l)) by lia; replace (Z.of_nat (S n) - 1)%Z with (Z.of_nat n) by lia; rewrite IH, Nat2Z.inj_succ, succ_IZR; rewrite (sum_ext 0 (Z.of_nat n) (fun j => (IZR (Z.of_nat n) + 1 - IZR j) * (IZR (Z.of_nat n) + 1 + 1 - IZR j) / 2 * P j) (fun j => (IZR (Z.of_nat n) - IZR j) * (IZR (Z.of_nat n) + 1 - IZR j) / 2 * P j + (IZR (Z.of_nat n) + 1 - IZR j) * P j)) by (intros; field); rewrite sum_plus; field ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, (fun _ => 0); repeat split; lia. Qed.
End sum_swap_weighted.

Module sum_swap_slip.
Import Bezier.Part_Sums.sum_swap_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0)). Qed.
End sum_swap_slip.
