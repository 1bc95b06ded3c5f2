(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Subdivision_printed Part_Subdivision_proofs.
Open Scope R_scope.

Module curve_midpoint.
Import Bezier.Part_Subdivision_printed.curve_midpoint.
Theorem proved : statement.
Proof. follows Bezier.Part_Subdivision_proofs.curve_midpoint.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Subdivision_proofs.curve_midpoint.met. Qed.
End curve_midpoint.
