(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Bezier Require Part_Divisors.
Open Scope R_scope.

Module reach_positive.
Import Bezier.Part_Divisors.reach_positive.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met)]. Qed.
End reach_positive.
