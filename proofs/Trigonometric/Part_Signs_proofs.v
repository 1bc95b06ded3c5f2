(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Trigonometric Require Part_Signs.
Open Scope R_scope.

Module angle_symmetric_slip.
Import Trigonometric.Part_Signs.angle_symmetric_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1/2*PI)). Qed.
End angle_symmetric_slip.
