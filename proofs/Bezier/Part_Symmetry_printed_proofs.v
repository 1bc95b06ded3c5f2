(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Symmetry_printed Part_Symmetry_proofs.
Open Scope R_scope.

Module bernstein_symmetry.
Import Bezier.Part_Symmetry_printed.bernstein_symmetry.
Theorem proved : statement.
Proof. follows Bezier.Part_Symmetry_proofs.bernstein_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Symmetry_proofs.bernstein_symmetry.met. Qed.
End bernstein_symmetry.

Module trigonometric_symmetry.
Import Bezier.Part_Symmetry_printed.trigonometric_symmetry.
Theorem proved : statement.
Proof. follows Bezier.Part_Symmetry_proofs.trigonometric_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Symmetry_proofs.trigonometric_symmetry.met. Qed.
End trigonometric_symmetry.

Module trigonometric_symmetry_slip.
Import Bezier.Part_Symmetry_printed.trigonometric_symmetry_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted. Qed.
End trigonometric_symmetry_slip.

Module trigonometric_symmetry_slip_corrected.
Import Bezier.Part_Symmetry_printed.trigonometric_symmetry_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met. Qed.
End trigonometric_symmetry_slip_corrected.
