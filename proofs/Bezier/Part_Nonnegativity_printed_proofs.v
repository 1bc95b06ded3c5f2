(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Nonnegativity_printed Part_Nonnegativity_proofs.
Open Scope R_scope.

Module bernstein_nonnegative.
Import Bezier.Part_Nonnegativity_printed.bernstein_nonnegative.
Theorem proved : statement.
Proof. follows Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.proved. Qed.
End bernstein_nonnegative.

Module bernstein_nonnegative_slip.
Import Bezier.Part_Nonnegativity_printed.bernstein_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted. Qed.
End bernstein_nonnegative_slip.

Module trigonometric_nonnegative.
Import Bezier.Part_Nonnegativity_printed.trigonometric_nonnegative.
Theorem proved : statement.
Proof. follows Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.met. Qed.
End trigonometric_nonnegative.

Module trigonometric_nonnegative_slip.
Import Bezier.Part_Nonnegativity_printed.trigonometric_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted. Qed.
End trigonometric_nonnegative_slip.
