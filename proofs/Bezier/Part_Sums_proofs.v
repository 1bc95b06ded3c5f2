(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From Bezier Require Part_Sums.
Open Scope R_scope.

Module sum_powers.
Import Bezier.Part_Sums.sum_powers.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met)]. Qed.
End sum_powers.

Module sum_powers_slip.
Import Bezier.Part_Sums.sum_powers_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((3))%Z). Qed.
End sum_powers_slip.

Module sum_powers_slip_corrected.
Import Bezier.Part_Sums.sum_powers_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met) | (exists (3)%Z; met)]. Qed.
End sum_powers_slip_corrected.

Module sum_swap.
Import Bezier.Part_Sums.sum_swap.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End sum_swap.

Module sum_swap_weighted.
Import Bezier.Part_Sums.sum_swap_weighted.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End sum_swap_weighted.

Module sum_swap_slip.
Import Bezier.Part_Sums.sum_swap_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0)). Qed.
End sum_swap_slip.
