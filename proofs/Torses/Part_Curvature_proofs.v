(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Torses Require Part_Curvature.
Import Torses.Part_Curvature.Definitions.
From Torses Require Import Part_Curvature_closed.
Open Scope R_scope.

Module ruled_asymptotic.
Import Torses.Part_Curvature.ruled_asymptotic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal K; identity. Qed.
End ruled_asymptotic.

Module ruled_mixed.
Import Torses.Part_Curvature.ruled_mixed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; stage M; staged_goal delta; identity. Qed.
End ruled_mixed.

Module ruled_lagrange.
Import Torses.Part_Curvature.ruled_lagrange.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage E_; stage X_; stage G; stage F; staged_goal N_; identity. Qed.
End ruled_lagrange.

Module ruled_gauss.
Import Torses.Part_Curvature.ruled_gauss.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage X__; stage N_; stage L; stage K; stage M; staged_goal delta; identity. Qed.
End ruled_gauss.

Module ruled_gauss_slip.
Import Torses.Part_Curvature.ruled_gauss_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X X_ X__ N_ L K M delta] in no; refuting (no 0 0 0 (0) (0) (1) 0 0 0 0 0 0 (0) (1) (0) (1) (0) (0) (0) (0)). Qed.
End ruled_gauss_slip.

Module ruled_gauss_slip_corrected.
Import Torses.Part_Curvature.ruled_gauss_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage X__; stage N_; stage L; stage K; stage M; staged_goal delta; identity. Qed.
End ruled_gauss_slip_corrected.
