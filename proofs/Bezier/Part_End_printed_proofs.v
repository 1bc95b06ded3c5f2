(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_End_printed Part_End_proofs.
Open Scope R_scope.

Module curve_ends.
Import Bezier.Part_End_printed.curve_ends.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.curve_ends.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.curve_ends.met. Qed.
End curve_ends.

Module curve_d1.
Import Bezier.Part_End_printed.curve_d1.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.curve_d1.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.curve_d1.met. Qed.
End curve_d1.

Module curve_d2.
Import Bezier.Part_End_printed.curve_d2.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.curve_d2.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.curve_d2.met. Qed.
End curve_d2.

Module curve_d2_slip.
Import Bezier.Part_End_printed.curve_d2_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_End_proofs.curve_d2_slip.refuted. Qed.
End curve_d2_slip.

Module curve_d2_slip_corrected.
Import Bezier.Part_End_printed.curve_d2_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.curve_d2_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.curve_d2_slip_corrected.met. Qed.
End curve_d2_slip_corrected.

Module curve_d3.
Import Bezier.Part_End_printed.curve_d3.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.curve_d3.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.curve_d3.met. Qed.
End curve_d3.

Module trigonometric_d1.
Import Bezier.Part_End_printed.trigonometric_d1.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.trigonometric_d1.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.trigonometric_d1.met. Qed.
End trigonometric_d1.

Module trigonometric_d1_slip.
Import Bezier.Part_End_printed.trigonometric_d1_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_End_proofs.trigonometric_d1_slip.refuted. Qed.
End trigonometric_d1_slip.

Module trigonometric_d1_slip_corrected.
Import Bezier.Part_End_printed.trigonometric_d1_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.met. Qed.
End trigonometric_d1_slip_corrected.

Module trigonometric_d2.
Import Bezier.Part_End_printed.trigonometric_d2.
Theorem proved : statement.
Proof. follows Bezier.Part_End_proofs.trigonometric_d2.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_End_proofs.trigonometric_d2.met. Qed.
End trigonometric_d2.
