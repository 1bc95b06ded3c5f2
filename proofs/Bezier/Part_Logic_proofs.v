(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences.
From Bezier Require Part_Logic.
Open Scope R_scope.

Module reach_roots_slip.
Import Bezier.Part_Logic.reach_roots_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (-2)). Qed.
End reach_roots_slip.

Module reach_weights_zero.
Import Bezier.Part_Logic.reach_weights_zero.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1), (1), (1); met) | (exists (0), (0), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End reach_weights_zero.
