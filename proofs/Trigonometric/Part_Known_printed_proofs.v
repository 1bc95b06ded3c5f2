(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Known_printed Part_Known_proofs.
Open Scope R_scope.

Module angle_known.
Import Trigonometric.Part_Known_printed.angle_known.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Known_proofs.angle_known.proved. Qed.
End angle_known.
