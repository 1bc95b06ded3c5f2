(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_The_printed Part_The_proofs.
Open Scope R_scope.

Module knots_linear.
Import Splines.Part_The_printed.knots_linear.
Theorem proved : statement.
Proof. follows Splines.Part_The_proofs.knots_linear.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_The_proofs.knots_linear.met. Qed.
End knots_linear.

Module knots_quadratic.
Import Splines.Part_The_printed.knots_quadratic.
Theorem proved : statement.
Proof. follows Splines.Part_The_proofs.knots_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_The_proofs.knots_quadratic.met. Qed.
End knots_quadratic.

Module knots_quadratic_slip.
Import Splines.Part_The_printed.knots_quadratic_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_The_proofs.knots_quadratic_slip.refuted. Qed.
End knots_quadratic_slip.

Module knots_quadratic_slip_corrected.
Import Splines.Part_The_printed.knots_quadratic_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_The_proofs.knots_quadratic_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_The_proofs.knots_quadratic_slip_corrected.met. Qed.
End knots_quadratic_slip_corrected.

Module knots_span.
Import Splines.Part_The_printed.knots_span.
Theorem proved : statement.
Proof. follows Splines.Part_The_proofs.knots_span.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_The_proofs.knots_span.met. Qed.
End knots_span.
