(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Bounds_printed Part_Bounds_proofs.
Open Scope R_scope.

Module reach_surd.
Import Bezier.Part_Bounds_printed.reach_surd.
Theorem proved : statement.
Proof. follows Bezier.Part_Bounds_proofs.reach_surd.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Bounds_proofs.reach_surd.met. Qed.
End reach_surd.

Module reach_simplex.
Import Bezier.Part_Bounds_printed.reach_simplex.
Theorem proved : statement.
Proof. follows Bezier.Part_Bounds_proofs.reach_simplex.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Bounds_proofs.reach_simplex.met. Qed.
End reach_simplex.

Module reach_between.
Import Bezier.Part_Bounds_printed.reach_between.
Theorem proved : statement.
Proof. follows Bezier.Part_Bounds_proofs.reach_between.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Bounds_proofs.reach_between.met. Qed.
End reach_between.

Module reach_interval.
Import Bezier.Part_Bounds_printed.reach_interval.
Theorem proved : statement.
Proof. follows Bezier.Part_Bounds_proofs.reach_interval.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Bounds_proofs.reach_interval.met. Qed.
End reach_interval.

Module reach_interval_basis.
Import Bezier.Part_Bounds_printed.reach_interval_basis.
Theorem proved : statement.
Proof. follows Bezier.Part_Bounds_proofs.reach_interval_basis.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Bounds_proofs.reach_interval_basis.met. Qed.
End reach_interval_basis.
