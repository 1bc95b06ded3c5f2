(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Section_5_printed Section_5_proofs.
Open Scope R_scope.

Module sec_5_criteria_a.
Import HermiteDevelopable.Section_5_printed.sec_5_criteria_a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.met. Qed.
End sec_5_criteria_a.

Module sec_5_criteria_reach.
Import HermiteDevelopable.Section_5_printed.sec_5_criteria_reach.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.met. Qed.
End sec_5_criteria_reach.

Module sec_5_planes_a.
Import HermiteDevelopable.Section_5_printed.sec_5_planes_a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_planes_a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_planes_a.met. Qed.
End sec_5_planes_a.

Module sec_5_planes_parallel.
Import HermiteDevelopable.Section_5_printed.sec_5_planes_parallel.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.met. Qed.
End sec_5_planes_parallel.

Module sec_5_planes_b.
Import HermiteDevelopable.Section_5_printed.sec_5_planes_b.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Section_5_proofs.sec_5_planes_b.refuted. Qed.
End sec_5_planes_b.
