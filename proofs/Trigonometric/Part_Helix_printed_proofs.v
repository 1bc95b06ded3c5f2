(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Helix_printed Part_Helix_proofs.
Open Scope R_scope.

Module helix_speed.
Import Trigonometric.Part_Helix_printed.helix_speed.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Helix_proofs.helix_speed.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Helix_proofs.helix_speed.met. Qed.
End helix_speed.

Module helix_torsion.
Import Trigonometric.Part_Helix_printed.helix_torsion.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Helix_proofs.helix_torsion.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Helix_proofs.helix_torsion.met. Qed.
End helix_torsion.

Module helix_curvature.
Import Trigonometric.Part_Helix_printed.helix_curvature.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Helix_proofs.helix_curvature.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Helix_proofs.helix_curvature.met. Qed.
End helix_curvature.
