(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_The_printed Part_The_proofs.
Open Scope R_scope.

Module circle_kappa.
Import Bezier.Part_The_printed.circle_kappa.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.circle_kappa.proved. Qed.
End circle_kappa.

Module circle_kappa_cut.
Import Bezier.Part_The_printed.circle_kappa_cut.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.circle_kappa_cut.proved. Qed.
End circle_kappa_cut.

Module circle_kappa_slip.
Import Bezier.Part_The_printed.circle_kappa_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_The_proofs.circle_kappa_slip.refuted. Qed.
End circle_kappa_slip.

Module circle_middle.
Import Bezier.Part_The_printed.circle_middle.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.circle_middle.proved. Qed.
End circle_middle.

Module circle_outside.
Import Bezier.Part_The_printed.circle_outside.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.circle_outside.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_The_proofs.circle_outside.met. Qed.
End circle_outside.

Module circle_exact_slip.
Import Bezier.Part_The_printed.circle_exact_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_The_proofs.circle_exact_slip.refuted. Qed.
End circle_exact_slip.

Module reach_definite.
Import Bezier.Part_The_printed.reach_definite.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.reach_definite.proved. Qed.
End reach_definite.

Module reach_cauchy.
Import Bezier.Part_The_printed.reach_cauchy.
Theorem proved : statement.
Proof. follows Bezier.Part_The_proofs.reach_cauchy.proved. Qed.
End reach_cauchy.
