(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Values_printed Part_Values_proofs.
Open Scope R_scope.

Module fn_number.
Import Hyperbolic.Part_Values_printed.fn_number.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Values_proofs.fn_number.proved. Qed.
End fn_number.

Module fn_value.
Import Hyperbolic.Part_Values_printed.fn_value.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Values_proofs.fn_value.proved. Qed.
End fn_value.
