(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Rates_printed Part_Rates_proofs.
Open Scope R_scope.

Module fn_rate.
Import Hyperbolic.Part_Rates_printed.fn_rate.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_rate.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_rate.met. Qed.
End fn_rate.

Module fn_growth.
Import Hyperbolic.Part_Rates_printed.fn_growth.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_growth.proved. Qed.
End fn_growth.

Module fn_bell.
Import Hyperbolic.Part_Rates_printed.fn_bell.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_bell.proved. Qed.
End fn_bell.

Module fn_damped.
Import Hyperbolic.Part_Rates_printed.fn_damped.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_damped.proved. Qed.
End fn_damped.

Module fn_damped_slip.
Import Hyperbolic.Part_Rates_printed.fn_damped_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_damped_slip.refuted. Qed.
End fn_damped_slip.

Module fn_damped_slip_corrected.
Import Hyperbolic.Part_Rates_printed.fn_damped_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Rates_proofs.fn_damped_slip_corrected.proved. Qed.
End fn_damped_slip_corrected.
