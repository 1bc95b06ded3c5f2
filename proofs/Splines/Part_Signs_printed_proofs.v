(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Signs_printed Part_Signs_proofs.
Open Scope R_scope.

Module uniform_nonnegative.
Import Splines.Part_Signs_printed.uniform_nonnegative.
Theorem proved : statement.
Proof. follows Splines.Part_Signs_proofs.uniform_nonnegative.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Signs_proofs.uniform_nonnegative.met. Qed.
End uniform_nonnegative.

Module uniform_bound.
Import Splines.Part_Signs_printed.uniform_bound.
Theorem proved : statement.
Proof. follows Splines.Part_Signs_proofs.uniform_bound.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Signs_proofs.uniform_bound.met. Qed.
End uniform_bound.

Module uniform_bound_slip.
Import Splines.Part_Signs_printed.uniform_bound_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Signs_proofs.uniform_bound_slip.refuted. Qed.
End uniform_bound_slip.

Module knots_nonnegative_ends.
Import Splines.Part_Signs_printed.knots_nonnegative_ends.
Theorem proved : statement.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_ends.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_ends.met. Qed.
End knots_nonnegative_ends.

Module knots_nonnegative_middle.
Import Splines.Part_Signs_printed.knots_nonnegative_middle.
Theorem proved : statement.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_middle.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_middle.met. Qed.
End knots_nonnegative_middle.

Module knots_nonnegative_outside.
Import Splines.Part_Signs_printed.knots_nonnegative_outside.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_outside.refuted. Qed.
End knots_nonnegative_outside.

Module knots_nonnegative_cubic.
Import Splines.Part_Signs_printed.knots_nonnegative_cubic.
Theorem proved : statement.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_cubic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Signs_proofs.knots_nonnegative_cubic.met. Qed.
End knots_nonnegative_cubic.
