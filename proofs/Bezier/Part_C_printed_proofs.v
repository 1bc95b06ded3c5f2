(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_C_printed Part_C_proofs.
Open Scope R_scope.

Module join_C0.
Import Bezier.Part_C_printed.join_C0.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C0.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C0.met. Qed.
End join_C0.

Module join_C1.
Import Bezier.Part_C_printed.join_C1.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C1.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C1.met. Qed.
End join_C1.

Module join_C1_slip.
Import Bezier.Part_C_printed.join_C1_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_C_proofs.join_C1_slip.refuted. Qed.
End join_C1_slip.

Module join_C1_slip_corrected.
Import Bezier.Part_C_printed.join_C1_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C1_slip_corrected.met. Qed.
End join_C1_slip_corrected.

Module join_C2.
Import Bezier.Part_C_printed.join_C2.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C2.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C2.met. Qed.
End join_C2.

Module join_C2_slip.
Import Bezier.Part_C_printed.join_C2_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_C_proofs.join_C2_slip.refuted. Qed.
End join_C2_slip.

Module join_C2_slip_corrected.
Import Bezier.Part_C_printed.join_C2_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C2_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C2_slip_corrected.met. Qed.
End join_C2_slip_corrected.

Module join_C3.
Import Bezier.Part_C_printed.join_C3.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C3.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C3.met. Qed.
End join_C3.

Module join_C2_sufficient.
Import Bezier.Part_C_printed.join_C2_sufficient.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_C2_sufficient.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_C2_sufficient.met. Qed.
End join_C2_sufficient.

Module join_knot.
Import Bezier.Part_C_printed.join_knot.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.join_knot.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.join_knot.met. Qed.
End join_knot.

Module trigonometric_C1.
Import Bezier.Part_C_printed.trigonometric_C1.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.trigonometric_C1.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.trigonometric_C1.met. Qed.
End trigonometric_C1.

Module trigonometric_C1_inside.
Import Bezier.Part_C_printed.trigonometric_C1_inside.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.trigonometric_C1_inside.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.trigonometric_C1_inside.met. Qed.
End trigonometric_C1_inside.

Module trigonometric_bezier.
Import Bezier.Part_C_printed.trigonometric_bezier.
Theorem proved : statement.
Proof. follows Bezier.Part_C_proofs.trigonometric_bezier.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_C_proofs.trigonometric_bezier.met. Qed.
End trigonometric_bezier.
