(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Cubic.
Import Splines.Part_Cubic.Definitions.
Open Scope R_scope.

Module uniform_cubic.
Import Splines.Part_Cubic.uniform_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_cubic.

Module uniform_cubic_slip.
Import Splines.Part_Cubic.uniform_cubic_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U] in no; refuting (no (1)). Qed.
End uniform_cubic_slip.

Module uniform_cubic_slip_corrected.
Import Splines.Part_Cubic.uniform_cubic_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_cubic_slip_corrected.
