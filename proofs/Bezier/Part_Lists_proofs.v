(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From Bezier Require Part_Lists.
Import Bezier.Part_Lists.Definitions.
Open Scope R_scope.

Module list_unity.
Import Bezier.Part_Lists.list_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (2), (1 / 3); met) | (exists (0), (1 / 2); met) | (exists (13), (1 / 3); met) | (exists (1), (1 / 3); met) | (exists (1), (1 / 3); met)]. Qed.
End list_unity.

Module list_nonnegative.
Import Bezier.Part_Lists.list_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (0), (1 / 3); met) | (exists (1 / 2), (1 / 2); met) | (exists (0), (1 / 3); met) | (exists (0), (1 / 3); met) | (exists (0), (1 / 3); met)]. Qed.
End list_nonnegative.

Module list_nonnegative_slip.
Import Bezier.Part_Lists.list_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T] in no; refuting (no (3) (1/2)). Qed.
End list_nonnegative_slip.
