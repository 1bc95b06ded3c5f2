(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Splines Require Part_Two_printed Part_Two_proofs.
Open Scope R_scope.

Module uniform_two_scale_quadratic.
Import Splines.Part_Two_printed.uniform_two_scale_quadratic.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.uniform_two_scale_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.uniform_two_scale_quadratic.met. Qed.
End uniform_two_scale_quadratic.

Module uniform_two_scale_cubic.
Import Splines.Part_Two_printed.uniform_two_scale_cubic.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.uniform_two_scale_cubic.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.uniform_two_scale_cubic.met. Qed.
End uniform_two_scale_cubic.

Module uniform_two_scale_slip.
Import Splines.Part_Two_printed.uniform_two_scale_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Two_proofs.uniform_two_scale_slip.refuted. Qed.
End uniform_two_scale_slip.

Module clamped_unity.
Import Splines.Part_Two_printed.clamped_unity.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.clamped_unity.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.clamped_unity.met. Qed.
End clamped_unity.

Module clamped_ends.
Import Splines.Part_Two_printed.clamped_ends.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.clamped_ends.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.clamped_ends.met. Qed.
End clamped_ends.

Module clamped_tangents.
Import Splines.Part_Two_printed.clamped_tangents.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.clamped_tangents.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.clamped_tangents.met. Qed.
End clamped_tangents.

Module clamped_tangents_slip.
Import Splines.Part_Two_printed.clamped_tangents_slip.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Two_proofs.clamped_tangents_slip.refuted. Qed.
End clamped_tangents_slip.

Module clamped_C1.
Import Splines.Part_Two_printed.clamped_C1.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.clamped_C1.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.clamped_C1.met. Qed.
End clamped_C1.

Module clamped_knot.
Import Splines.Part_Two_printed.clamped_knot.
Theorem proved : statement.
Proof. follows Splines.Part_Two_proofs.clamped_knot.proved. Qed.
Theorem met : instance.
Proof. follows Splines.Part_Two_proofs.clamped_knot.met. Qed.
End clamped_knot.

Module clamped_C2.
Import Splines.Part_Two_printed.clamped_C2.
Theorem refuted : ~ statement.
Proof. follows Splines.Part_Two_proofs.clamped_C2.refuted. Qed.
End clamped_C2.
