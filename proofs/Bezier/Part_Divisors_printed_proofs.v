(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Divisors_printed Part_Divisors_proofs.
Open Scope R_scope.

Module reach_interval_open.
Import Bezier.Part_Divisors_printed.reach_interval_open.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_interval_open.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_interval_open.met. Qed.
End reach_interval_open.

Module reach_interval_closed.
Import Bezier.Part_Divisors_printed.reach_interval_closed.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_interval_closed.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_interval_closed.met. Qed.
End reach_interval_closed.

Module reach_positive.
Import Bezier.Part_Divisors_printed.reach_positive.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_positive.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_positive.met. Qed.
End reach_positive.

Module reach_open.
Import Bezier.Part_Divisors_printed.reach_open.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_open.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_open.met. Qed.
End reach_open.

Module reach_ordered.
Import Bezier.Part_Divisors_printed.reach_ordered.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_ordered.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_ordered.met. Qed.
End reach_ordered.

Module reach_vector.
Import Bezier.Part_Divisors_printed.reach_vector.
Theorem proved : statement.
Proof. follows Bezier.Part_Divisors_proofs.reach_vector.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Divisors_proofs.reach_vector.met. Qed.
End reach_vector.
