(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Torses Require Part_Torses.
Open Scope R_scope.

Module ruled_rodrigues.
Import Torses.Part_Torses.ruled_rodrigues.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal delta; identity. Qed.
End ruled_rodrigues.
