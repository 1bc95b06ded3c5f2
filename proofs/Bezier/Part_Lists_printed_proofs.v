(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Lists_printed Part_Lists_proofs.
Open Scope R_scope.

Module list_unity.
Import Bezier.Part_Lists_printed.list_unity.
Theorem proved : statement.
Proof. follows Bezier.Part_Lists_proofs.list_unity.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Lists_proofs.list_unity.met. Qed.
End list_unity.

Module list_nonnegative.
Import Bezier.Part_Lists_printed.list_nonnegative.
Theorem proved : statement.
Proof. follows Bezier.Part_Lists_proofs.list_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Lists_proofs.list_nonnegative.met. Qed.
End list_nonnegative.

Module list_nonnegative_slip.
Import Bezier.Part_Lists_printed.list_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Lists_proofs.list_nonnegative_slip.refuted. Qed.
End list_nonnegative_slip.
