(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Hodograph_printed Part_Hodograph_proofs.
Open Scope R_scope.

Module curve_hodograph.
Import Bezier.Part_Hodograph_printed.curve_hodograph.
Theorem proved : statement.
Proof. follows Bezier.Part_Hodograph_proofs.curve_hodograph.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Hodograph_proofs.curve_hodograph.met. Qed.
End curve_hodograph.
