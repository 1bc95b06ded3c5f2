(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Spiral_printed Part_Spiral_proofs.
Open Scope R_scope.

Module cone_slope.
Import Hyperbolic.Part_Spiral_printed.cone_slope.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_slope.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_slope.met. Qed.
End cone_slope.

Module cone_torsion.
Import Hyperbolic.Part_Spiral_printed.cone_torsion.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_torsion.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_torsion.met. Qed.
End cone_torsion.

Module cone_torse.
Import Hyperbolic.Part_Spiral_printed.cone_torse.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_torse.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Spiral_proofs.cone_torse.met. Qed.
End cone_torse.
