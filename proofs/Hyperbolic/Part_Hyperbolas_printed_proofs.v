(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Hyperbolas_printed Part_Hyperbolas_proofs.
Open Scope R_scope.

Module curve_hyperbola.
Import Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.met. Qed.
End curve_hyperbola.

Module curve_hyperbola_implicit.
Import Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_implicit.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.met. Qed.
End curve_hyperbola_implicit.

Module curve_hyperbola_tangent.
Import Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_tangent.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.met. Qed.
End curve_hyperbola_tangent.
