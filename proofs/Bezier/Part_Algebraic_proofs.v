(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Bezier Require Part_Algebraic.
Open Scope R_scope.

Module reach_root.
Import Bezier.Part_Algebraic.reach_root.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), (1); met) | (exists (0), (0), (1); met)]. Qed.
End reach_root.

Module reach_square.
Import Bezier.Part_Algebraic.reach_square.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1); met) | (exists (1); met)]. Qed.
End reach_square.
