(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Parts_printed Part_Parts_proofs.
Open Scope R_scope.

Module angle_third.
Import Trigonometric.Part_Parts_printed.angle_third.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Parts_proofs.angle_third.proved. Qed.
End angle_third.

Module angle_parts.
Import Trigonometric.Part_Parts_printed.angle_parts.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Parts_proofs.angle_parts.proved. Qed.
End angle_parts.

Module angle_rate.
Import Trigonometric.Part_Parts_printed.angle_rate.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Parts_proofs.angle_rate.proved. Qed.
End angle_rate.
