(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Sums_printed Part_Sums_proofs.
Open Scope R_scope.

Module sum_powers.
Import Bezier.Part_Sums_printed.sum_powers.
Theorem proved : statement.
Proof. follows Bezier.Part_Sums_proofs.sum_powers.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Sums_proofs.sum_powers.met. Qed.
End sum_powers.

Module sum_powers_slip.
Import Bezier.Part_Sums_printed.sum_powers_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Sums_proofs.sum_powers_slip.refuted. Qed.
End sum_powers_slip.

Module sum_powers_slip_corrected.
Import Bezier.Part_Sums_printed.sum_powers_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_Sums_proofs.sum_powers_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Sums_proofs.sum_powers_slip_corrected.met. Qed.
End sum_powers_slip_corrected.

Module sum_swap.
Import Bezier.Part_Sums_printed.sum_swap.
Theorem proved : statement.
Proof. follows Bezier.Part_Sums_proofs.sum_swap.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Sums_proofs.sum_swap.met. Qed.
End sum_swap.

Module sum_swap_weighted.
Import Bezier.Part_Sums_printed.sum_swap_weighted.
Theorem proved : statement.
Proof. follows Bezier.Part_Sums_proofs.sum_swap_weighted.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Sums_proofs.sum_swap_weighted.met. Qed.
End sum_swap_weighted.

Module sum_swap_slip.
Import Bezier.Part_Sums_printed.sum_swap_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Sums_proofs.sum_swap_slip.refuted. Qed.
End sum_swap_slip.
