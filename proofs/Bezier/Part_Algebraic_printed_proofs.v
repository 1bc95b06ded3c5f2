(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Algebraic_printed Part_Algebraic_proofs.
Open Scope R_scope.

Module reach_root.
Import Bezier.Part_Algebraic_printed.reach_root.
Theorem proved : statement.
Proof. follows Bezier.Part_Algebraic_proofs.reach_root.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Algebraic_proofs.reach_root.met. Qed.
End reach_root.

Module reach_square.
Import Bezier.Part_Algebraic_printed.reach_square.
Theorem proved : statement.
Proof. follows Bezier.Part_Algebraic_proofs.reach_square.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Algebraic_proofs.reach_square.met. Qed.
End reach_square.
