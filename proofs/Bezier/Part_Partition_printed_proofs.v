(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Partition_printed Part_Partition_proofs.
Open Scope R_scope.

Module bernstein_unity.
Import Bezier.Part_Partition_printed.bernstein_unity.
Theorem proved : statement.
Proof. follows Bezier.Part_Partition_proofs.bernstein_unity.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Partition_proofs.bernstein_unity.met. Qed.
End bernstein_unity.

Module trigonometric_unity.
Import Bezier.Part_Partition_printed.trigonometric_unity.
Theorem proved : statement.
Proof. follows Bezier.Part_Partition_proofs.trigonometric_unity.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Partition_proofs.trigonometric_unity.met. Qed.
End trigonometric_unity.
