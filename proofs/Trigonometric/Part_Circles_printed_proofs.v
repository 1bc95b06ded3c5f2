(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Circles_printed Part_Circles_proofs.
Open Scope R_scope.

Module quadratic_circle.
Import Trigonometric.Part_Circles_printed.quadratic_circle.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Circles_proofs.quadratic_circle.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Circles_proofs.quadratic_circle.met. Qed.
End quadratic_circle.
