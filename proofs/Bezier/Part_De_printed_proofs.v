(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_De_printed Part_De_proofs.
Open Scope R_scope.

Module curve_casteljau.
Import Bezier.Part_De_printed.curve_casteljau.
Theorem proved : statement.
Proof. follows Bezier.Part_De_proofs.curve_casteljau.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_De_proofs.curve_casteljau.met. Qed.
End curve_casteljau.
