(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Normal.
Import Torses.Part_Normal.Definitions.
From Torses Require Import Part_Normal_closed.
Open Scope R_scope.

Module ruled_normal.
Import Torses.Part_Normal.ruled_normal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; staged_goal N_; identity. Qed.
End ruled_normal.

Module ruled_turn.
Import Torses.Part_Normal.ruled_turn.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
End ruled_turn.

Module ruled_turn_slip.
Import Torses.Part_Normal.ruled_turn_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X X_ N_ delta] in no; refuting (no (0) (0) (1) 0 0 0 (0) (1) (0) (1) (0) (0) (0) (1) (1)). Qed.
End ruled_turn_slip.

Module ruled_turn_slip_corrected.
Import Torses.Part_Normal.ruled_turn_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
End ruled_turn_slip_corrected.

Module ruled_chasles.
Import Torses.Part_Normal.ruled_chasles.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
End ruled_chasles.
