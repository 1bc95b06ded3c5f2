(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Signs_printed Part_Signs_proofs.
Open Scope R_scope.

Module fn_positive.
Import Hyperbolic.Part_Signs_printed.fn_positive.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_positive.proved. Qed.
End fn_positive.

Module fn_strict_slip.
Import Hyperbolic.Part_Signs_printed.fn_strict_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_strict_slip.refuted. Qed.
End fn_strict_slip.

Module fn_bounded.
Import Hyperbolic.Part_Signs_printed.fn_bounded.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_bounded.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_bounded.met. Qed.
End fn_bounded.

Module fn_tangent_line.
Import Hyperbolic.Part_Signs_printed.fn_tangent_line.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_tangent_line.proved. Qed.
End fn_tangent_line.

Module fn_unit.
Import Hyperbolic.Part_Signs_printed.fn_unit.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_unit.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Signs_proofs.fn_unit.met. Qed.
End fn_unit.
