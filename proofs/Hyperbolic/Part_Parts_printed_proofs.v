(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Parts_printed Part_Parts_proofs.
Open Scope R_scope.

Module fn_half.
Import Hyperbolic.Part_Parts_printed.fn_half.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_half.proved. Qed.
End fn_half.

Module fn_half_slip.
Import Hyperbolic.Part_Parts_printed.fn_half_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_half_slip.refuted. Qed.
End fn_half_slip.

Module fn_half_slip_corrected.
Import Hyperbolic.Part_Parts_printed.fn_half_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_half_slip_corrected.proved. Qed.
End fn_half_slip_corrected.

Module fn_third.
Import Hyperbolic.Part_Parts_printed.fn_third.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_third.proved. Qed.
End fn_third.

Module fn_tangent.
Import Hyperbolic.Part_Parts_printed.fn_tangent.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_tangent.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Parts_proofs.fn_tangent.met. Qed.
End fn_tangent.
