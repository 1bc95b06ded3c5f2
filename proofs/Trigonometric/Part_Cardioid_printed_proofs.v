(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Cardioid_printed Part_Cardioid_proofs.
Open Scope R_scope.

Module cardioid_speed.
Import Trigonometric.Part_Cardioid_printed.cardioid_speed.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cardioid_proofs.cardioid_speed.met. Qed.
End cardioid_speed.

Module cardioid_cusp.
Import Trigonometric.Part_Cardioid_printed.cardioid_cusp.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved. Qed.
End cardioid_cusp.

Module cardioid_curvature.
Import Trigonometric.Part_Cardioid_printed.cardioid_curvature.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cardioid_proofs.cardioid_curvature.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cardioid_proofs.cardioid_curvature.met. Qed.
End cardioid_curvature.
