(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Torses Require Part_Skew.
Open Scope R_scope.

Module conoid_skew.
Import Torses.Part_Skew.conoid_skew.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End conoid_skew.
