(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_At_printed Part_At_proofs.
Open Scope R_scope.

Module uniform_C1.
Import Splines.Part_At_printed.uniform_C1.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_C1.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_C1.met. Qed.
End uniform_C1.

Module uniform_C1_slip.
Import Splines.Part_At_printed.uniform_C1_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_At_proofs.uniform_C1_slip.refuted. Qed.
End uniform_C1_slip.

Module uniform_C1_slip_corrected.
Import Splines.Part_At_printed.uniform_C1_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_C1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_C1_slip_corrected.met. Qed.
End uniform_C1_slip_corrected.

Module uniform_C2.
Import Splines.Part_At_printed.uniform_C2.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_C2.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_C2.met. Qed.
End uniform_C2.

Module uniform_jump.
Import Splines.Part_At_printed.uniform_jump.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_jump.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_jump.met. Qed.
End uniform_jump.

Module uniform_knot.
Import Splines.Part_At_printed.uniform_knot.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_knot.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_knot.met. Qed.
End uniform_knot.

Module uniform_knot_slip.
Import Splines.Part_At_printed.uniform_knot_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_At_proofs.uniform_knot_slip.refuted. Qed.
End uniform_knot_slip.

Module uniform_knot_slip_corrected.
Import Splines.Part_At_printed.uniform_knot_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.uniform_knot_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.uniform_knot_slip_corrected.met. Qed.
End uniform_knot_slip_corrected.

Module knots_C1.
Import Splines.Part_At_printed.knots_C1.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.knots_C1.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.knots_C1.met. Qed.
End knots_C1.

Module knots_C1_value.
Import Splines.Part_At_printed.knots_C1_value.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.knots_C1_value.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.knots_C1_value.met. Qed.
End knots_C1_value.

Module knots_C1_value_slip.
Import Splines.Part_At_printed.knots_C1_value_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_At_proofs.knots_C1_value_slip.refuted. Qed.
End knots_C1_value_slip.

Module knots_C1_value_slip_corrected.
Import Splines.Part_At_printed.knots_C1_value_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.knots_C1_value_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.knots_C1_value_slip_corrected.met. Qed.
End knots_C1_value_slip_corrected.

Module knots_C2.
Import Splines.Part_At_printed.knots_C2.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.knots_C2.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.knots_C2.met. Qed.
End knots_C2.

Module knots_convex.
Import Splines.Part_At_printed.knots_convex.
Theorem proved : statement.
Proof. follows Splines.Part_At_proofs.knots_convex.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_At_proofs.knots_convex.met. Qed.
End knots_convex.
