(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Torses Require Part_Rulings.
Open Scope R_scope.

Module planes_ruling.
Import Torses.Part_Rulings.planes_ruling.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End planes_ruling.

Module planes_turn.
Import Torses.Part_Rulings.planes_turn.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_turn.

Module planes_turn_slip.
Import Torses.Part_Rulings.planes_turn_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement W] in no; refuting (no (0) (0) (1) (0) (1) (0) (1) (0) (0) (0)). Qed.
End planes_turn_slip.

Module planes_turn_slip_corrected.
Import Torses.Part_Rulings.planes_turn_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_turn_slip_corrected.

Module planes_scaled.
Import Torses.Part_Rulings.planes_scaled.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_scaled.

Module planes_scaled_slip.
Import Torses.Part_Rulings.planes_scaled_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement W] in no; refuting (no (0) (0) (2) (0) (0) (1) (0) (1) (0) (1) (0) (0) (0)). Qed.
End planes_scaled_slip.

Module planes_scaled_slip_corrected.
Import Torses.Part_Rulings.planes_scaled_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W]; identity. Qed.
End planes_scaled_slip_corrected.
