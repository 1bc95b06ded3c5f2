(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Roots_printed Part_Roots_proofs.
Open Scope R_scope.

Module catenary_norm.
Import Hyperbolic.Part_Roots_printed.catenary_norm.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_norm.proved. Qed.
End catenary_norm.

Module catenary_bend.
Import Hyperbolic.Part_Roots_printed.catenary_bend.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_bend.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_bend.met. Qed.
End catenary_bend.

Module catenary_bend_slip.
Import Hyperbolic.Part_Roots_printed.catenary_bend_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_bend_slip.refuted. Qed.
End catenary_bend_slip.

Module catenary_bend_slip_corrected.
Import Hyperbolic.Part_Roots_printed.catenary_bend_slip_corrected.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.met. Qed.
End catenary_bend_slip_corrected.

Module tractrix_norm.
Import Hyperbolic.Part_Roots_printed.tractrix_norm.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Roots_proofs.tractrix_norm.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Roots_proofs.tractrix_norm.met. Qed.
End tractrix_norm.
