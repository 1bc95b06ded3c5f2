(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Derivatives_printed Part_Derivatives_proofs.
Open Scope R_scope.

Module uniform_rate.
Import Splines.Part_Derivatives_printed.uniform_rate.
Theorem proved : statement.
Proof. follows Splines.Part_Derivatives_proofs.uniform_rate.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Derivatives_proofs.uniform_rate.met. Qed.
End uniform_rate.

Module knots_rate.
Import Splines.Part_Derivatives_printed.knots_rate.
Theorem proved : statement.
Proof. follows Splines.Part_Derivatives_proofs.knots_rate.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Derivatives_proofs.knots_rate.met. Qed.
End knots_rate.

Module knots_rate_slip.
Import Splines.Part_Derivatives_printed.knots_rate_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Derivatives_proofs.knots_rate_slip.refuted. Qed.
End knots_rate_slip.

Module knots_rate_slip_corrected.
Import Splines.Part_Derivatives_printed.knots_rate_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.met. Qed.
End knots_rate_slip_corrected.
