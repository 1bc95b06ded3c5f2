(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Tangents_printed Part_Tangents_proofs.
Open Scope R_scope.

Module angle_tangent.
Import Trigonometric.Part_Tangents_printed.angle_tangent.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Tangents_proofs.angle_tangent.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Tangents_proofs.angle_tangent.met. Qed.
End angle_tangent.

Module angle_tangent_closed.
Import Trigonometric.Part_Tangents_printed.angle_tangent_closed.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met. Qed.
End angle_tangent_closed.
