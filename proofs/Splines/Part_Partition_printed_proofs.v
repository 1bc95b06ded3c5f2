(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Partition_printed Part_Partition_proofs.
Open Scope R_scope.

Module uniform_unity.
Import Splines.Part_Partition_printed.uniform_unity.
Theorem proved : statement.
Proof. follows Splines.Part_Partition_proofs.uniform_unity.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Partition_proofs.uniform_unity.met. Qed.
End uniform_unity.

Module knots_unity_quadratic.
Import Splines.Part_Partition_printed.knots_unity_quadratic.
Theorem proved : statement.
Proof. follows Splines.Part_Partition_proofs.knots_unity_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Partition_proofs.knots_unity_quadratic.met. Qed.
End knots_unity_quadratic.

Module knots_unity_cubic.
Import Splines.Part_Partition_printed.knots_unity_cubic.
Theorem proved : statement.
Proof. follows Splines.Part_Partition_proofs.knots_unity_cubic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Partition_proofs.knots_unity_cubic.met. Qed.
End knots_unity_cubic.

Module knots_unity_equal.
Import Splines.Part_Partition_printed.knots_unity_equal.
Theorem proved : statement.
Proof. follows Splines.Part_Partition_proofs.knots_unity_equal.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Partition_proofs.knots_unity_equal.met. Qed.
End knots_unity_equal.
