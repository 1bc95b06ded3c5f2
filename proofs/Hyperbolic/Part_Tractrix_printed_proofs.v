(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Tractrix_printed Part_Tractrix_proofs.
Open Scope R_scope.

Module tractrix_pull.
Import Hyperbolic.Part_Tractrix_printed.tractrix_pull.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Tractrix_proofs.tractrix_pull.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Tractrix_proofs.tractrix_pull.met. Qed.
End tractrix_pull.

Module tractrix_speed.
Import Hyperbolic.Part_Tractrix_printed.tractrix_speed.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Tractrix_proofs.tractrix_speed.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Tractrix_proofs.tractrix_speed.met. Qed.
End tractrix_speed.
