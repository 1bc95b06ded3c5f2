(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Nonnegativity.
Import Bezier.Part_Nonnegativity.Definitions.
Open Scope R_scope.

Module bernstein_nonnegative.
Import Bezier.Part_Nonnegativity.bernstein_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End bernstein_nonnegative.

Module bernstein_nonnegative_slip.
Import Bezier.Part_Nonnegativity.bernstein_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B] in no; refuting (no (2)). Qed.
End bernstein_nonnegative_slip.

Module trigonometric_nonnegative.
Import Bezier.Part_Nonnegativity.trigonometric_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1) / 2), ((-1) / 2), (1 / 2); met) | (exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1)), ((-1)), (1 / 3); met) | (exists ((-1)), ((-1)), (1 / 3); met)]. Qed.
End trigonometric_nonnegative.

Module trigonometric_nonnegative_slip.
Import Bezier.Part_Nonnegativity.trigonometric_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T] in no; refuting (no (2) ((-1) / 2) (1/2)). Qed.
End trigonometric_nonnegative_slip.
