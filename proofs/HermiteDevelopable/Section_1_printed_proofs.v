(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_1_printed Section_1_proofs.
Open Scope R_scope.

Module sec_1_parallel_tangents.
Import HermiteDevelopable.Section_1_printed.sec_1_parallel_tangents.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met. Qed.
End sec_1_parallel_tangents.
