(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Reflection_printed Part_Reflection_proofs.
Open Scope R_scope.

Module curve_reflection.
Import Bezier.Part_Reflection_printed.curve_reflection.
Theorem proved : statement.
Proof. follows Bezier.Part_Reflection_proofs.curve_reflection.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Reflection_proofs.curve_reflection.met. Qed.
End curve_reflection.
