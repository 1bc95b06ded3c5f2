(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Roots_printed Part_Roots_proofs.
Open Scope R_scope.

Module helix_length.
Import Trigonometric.Part_Roots_printed.helix_length.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Roots_proofs.helix_length.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Roots_proofs.helix_length.met. Qed.
End helix_length.

Module helix_bend.
Import Trigonometric.Part_Roots_printed.helix_bend.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Roots_proofs.helix_bend.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Roots_proofs.helix_bend.met. Qed.
End helix_bend.

Module helix_bend_slip.
Import Trigonometric.Part_Roots_printed.helix_bend_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Roots_proofs.helix_bend_slip.refuted. Qed.
End helix_bend_slip.

Module cylinder_normal.
Import Trigonometric.Part_Roots_printed.cylinder_normal.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Roots_proofs.cylinder_normal.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Roots_proofs.cylinder_normal.met. Qed.
End cylinder_normal.

Module cylinder_offset.
Import Trigonometric.Part_Roots_printed.cylinder_offset.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Roots_proofs.cylinder_offset.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Roots_proofs.cylinder_offset.met. Qed.
End cylinder_offset.
