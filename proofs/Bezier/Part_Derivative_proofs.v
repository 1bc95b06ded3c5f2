(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Derivative.
Import Bezier.Part_Derivative.Definitions.
Open Scope R_scope.

Module bernstein_derivative.
Import Bezier.Part_Derivative.bernstein_derivative.
Theorem proved : statement.
Proof. cbv delta [statement B]; intros; apply rate; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 2); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met)]. Qed.
End bernstein_derivative.

Module bernstein_derivative_slip.
Import Bezier.Part_Derivative.bernstein_derivative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B] in no; refuting (no (0)). Qed.
End bernstein_derivative_slip.

Module bernstein_derivative_slip_corrected.
Import Bezier.Part_Derivative.bernstein_derivative_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End bernstein_derivative_slip_corrected.
