(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Helicoid_printed Part_Helicoid_proofs.
Open Scope R_scope.

Module helicoid_skew.
Import Trigonometric.Part_Helicoid_printed.helicoid_skew.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Helicoid_proofs.helicoid_skew.met. Qed.
End helicoid_skew.

Module helicoid_skew_slip.
Import Trigonometric.Part_Helicoid_printed.helicoid_skew_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted. Qed.
End helicoid_skew_slip.
