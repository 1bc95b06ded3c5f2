(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Tangent_printed Part_Tangent_proofs.
Open Scope R_scope.

Module helix_torse.
Import Trigonometric.Part_Tangent_printed.helix_torse.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_torse.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_torse.met. Qed.
End helix_torse.

Module helix_normal.
Import Trigonometric.Part_Tangent_printed.helix_normal.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_normal.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_normal.met. Qed.
End helix_normal.

Module helix_regular.
Import Trigonometric.Part_Tangent_printed.helix_regular.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_regular.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Tangent_proofs.helix_regular.met. Qed.
End helix_regular.
