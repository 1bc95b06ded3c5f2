(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Sums_printed Part_Sums_proofs.
Open Scope R_scope.

Module fn_pythagoras.
Import Hyperbolic.Part_Sums_printed.fn_pythagoras.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Sums_proofs.fn_pythagoras.proved. Qed.
End fn_pythagoras.

Module fn_pythagoras_slip.
Import Hyperbolic.Part_Sums_printed.fn_pythagoras_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip.refuted. Qed.
End fn_pythagoras_slip.

Module fn_pythagoras_slip_corrected.
Import Hyperbolic.Part_Sums_printed.fn_pythagoras_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip_corrected.proved. Qed.
End fn_pythagoras_slip_corrected.

Module fn_sum.
Import Hyperbolic.Part_Sums_printed.fn_sum.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Sums_proofs.fn_sum.proved. Qed.
End fn_sum.

Module fn_difference.
Import Hyperbolic.Part_Sums_printed.fn_difference.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Sums_proofs.fn_difference.proved. Qed.
End fn_difference.
