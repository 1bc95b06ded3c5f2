(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Catenoid_printed Part_Catenoid_proofs.
Open Scope R_scope.

Module catenoid_conformal.
Import Hyperbolic.Part_Catenoid_printed.catenoid_conformal.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenoid_proofs.catenoid_conformal.proved. Qed.
End catenoid_conformal.

Module catenoid_minimal.
Import Hyperbolic.Part_Catenoid_printed.catenoid_minimal.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenoid_proofs.catenoid_minimal.proved. Qed.
End catenoid_minimal.

Module catenoid_gauss.
Import Hyperbolic.Part_Catenoid_printed.catenoid_gauss.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenoid_proofs.catenoid_gauss.proved. Qed.
End catenoid_gauss.

Module catenoid_regular.
Import Hyperbolic.Part_Catenoid_printed.catenoid_regular.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Catenoid_proofs.catenoid_regular.proved. Qed.
End catenoid_regular.
