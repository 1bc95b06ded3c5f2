(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Catenary_printed Part_Catenary_proofs.
Open Scope R_scope.

Module catenary_speed.
Import Hyperbolic.Part_Catenary_printed.catenary_speed.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_speed.proved. Qed.
End catenary_speed.

Module catenary_length.
Import Hyperbolic.Part_Catenary_printed.catenary_length.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_length.proved. Qed.
End catenary_length.

Module catenary_curvature.
Import Hyperbolic.Part_Catenary_printed.catenary_curvature.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_curvature.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_curvature.met. Qed.
End catenary_curvature.

Module catenary_curvature_slip.
Import Hyperbolic.Part_Catenary_printed.catenary_curvature_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip.refuted. Qed.
End catenary_curvature_slip.

Module catenary_curvature_slip_corrected.
Import Hyperbolic.Part_Catenary_printed.catenary_curvature_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.met. Qed.
End catenary_curvature_slip_corrected.

Module catenary_load.
Import Hyperbolic.Part_Catenary_printed.catenary_load.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenary_proofs.catenary_load.proved. Qed.
End catenary_load.
