(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Tractrix.
Import Hyperbolic.Part_Tractrix.Definitions.
Open Scope R_scope.

Module tractrix_pull.
Import Hyperbolic.Part_Tractrix.tractrix_pull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (1); met) | (exists (1); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End tractrix_pull.

Module tractrix_speed.
Import Hyperbolic.Part_Tractrix.tractrix_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End tractrix_speed.
