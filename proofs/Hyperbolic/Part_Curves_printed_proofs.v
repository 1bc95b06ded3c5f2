(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Curves_printed Part_Curves_proofs.
Open Scope R_scope.

Module curve_ends.
Import Hyperbolic.Part_Curves_printed.curve_ends.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_ends.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_ends.met. Qed.
End curve_ends.

Module curve_d1.
Import Hyperbolic.Part_Curves_printed.curve_d1.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d1.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d1.met. Qed.
End curve_d1.

Module curve_d1_slip.
Import Hyperbolic.Part_Curves_printed.curve_d1_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d1_slip.refuted. Qed.
End curve_d1_slip.

Module curve_d1_slip_corrected.
Import Hyperbolic.Part_Curves_printed.curve_d1_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.met. Qed.
End curve_d1_slip_corrected.

Module curve_d2.
Import Hyperbolic.Part_Curves_printed.curve_d2.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d2.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_d2.met. Qed.
End curve_d2.

Module curve_middle.
Import Hyperbolic.Part_Curves_printed.curve_middle.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_middle.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_middle.met. Qed.
End curve_middle.

Module curve_middle_slip.
Import Hyperbolic.Part_Curves_printed.curve_middle_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Curves_proofs.curve_middle_slip.refuted. Qed.
End curve_middle_slip.

Module shape_ends.
Import Hyperbolic.Part_Curves_printed.shape_ends.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_ends.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_ends.met. Qed.
End shape_ends.

Module shape_d1.
Import Hyperbolic.Part_Curves_printed.shape_d1.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_d1.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_d1.met. Qed.
End shape_d1.

Module shape_d1_slip.
Import Hyperbolic.Part_Curves_printed.shape_d1_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_d1_slip.refuted. Qed.
End shape_d1_slip.

Module shape_slope.
Import Hyperbolic.Part_Curves_printed.shape_slope.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_slope.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Curves_proofs.shape_slope.met. Qed.
End shape_slope.
