(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Cubic_printed Part_Cubic_proofs.
Open Scope R_scope.

Module uniform_cubic.
Import Splines.Part_Cubic_printed.uniform_cubic.
Theorem proved : statement.
Proof. follows Splines.Part_Cubic_proofs.uniform_cubic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Cubic_proofs.uniform_cubic.met. Qed.
End uniform_cubic.

Module uniform_cubic_slip.
Import Splines.Part_Cubic_printed.uniform_cubic_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Cubic_proofs.uniform_cubic_slip.refuted. Qed.
End uniform_cubic_slip.

Module uniform_cubic_slip_corrected.
Import Splines.Part_Cubic_printed.uniform_cubic_slip_corrected.
Theorem proved : statement.
Proof. follows Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.met. Qed.
End uniform_cubic_slip_corrected.
