(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Symmetry_printed Part_Symmetry_proofs.
Open Scope R_scope.

Module uniform_symmetry.
Import Splines.Part_Symmetry_printed.uniform_symmetry.
Theorem proved : statement.
Proof. follows Splines.Part_Symmetry_proofs.uniform_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Symmetry_proofs.uniform_symmetry.met. Qed.
End uniform_symmetry.
