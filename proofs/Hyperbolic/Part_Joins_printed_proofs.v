(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Joins_printed Part_Joins_proofs.
Open Scope R_scope.

Module join_C1.
Import Hyperbolic.Part_Joins_printed.join_C1.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C1.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C1.met. Qed.
End join_C1.

Module join_C1_slip.
Import Hyperbolic.Part_Joins_printed.join_C1_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C1_slip.refuted. Qed.
End join_C1_slip.

Module join_C1_slip_corrected.
Import Hyperbolic.Part_Joins_printed.join_C1_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.met. Qed.
End join_C1_slip_corrected.

Module join_C2.
Import Hyperbolic.Part_Joins_printed.join_C2.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C2.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Joins_proofs.join_C2.met. Qed.
End join_C2.

Module shape_join.
Import Hyperbolic.Part_Joins_printed.shape_join.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Joins_proofs.shape_join.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Joins_proofs.shape_join.met. Qed.
End shape_join.
