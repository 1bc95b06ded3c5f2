(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_A_printed Part_A_proofs.
Open Scope R_scope.

Module trigonometric_circle.
Import Bezier.Part_A_printed.trigonometric_circle.
Theorem proved : statement.
Proof. follows Bezier.Part_A_proofs.trigonometric_circle.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_A_proofs.trigonometric_circle.met. Qed.
End trigonometric_circle.
