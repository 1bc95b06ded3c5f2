(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Derivative_printed Part_Derivative_proofs.
Open Scope R_scope.

Module bernstein_derivative.
Import Bezier.Part_Derivative_printed.bernstein_derivative.
Theorem proved : statement.
Proof. follows Bezier.Part_Derivative_proofs.bernstein_derivative.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Derivative_proofs.bernstein_derivative.met. Qed.
End bernstein_derivative.

Module bernstein_derivative_slip.
Import Bezier.Part_Derivative_printed.bernstein_derivative_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Derivative_proofs.bernstein_derivative_slip.refuted. Qed.
End bernstein_derivative_slip.

Module bernstein_derivative_slip_corrected.
Import Bezier.Part_Derivative_printed.bernstein_derivative_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.met. Qed.
End bernstein_derivative_slip_corrected.
