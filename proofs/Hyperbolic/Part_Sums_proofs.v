(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Sums.
Open Scope R_scope.

Module fn_pythagoras.
Import Hyperbolic.Part_Sums.fn_pythagoras.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_pythagoras.

Module fn_pythagoras_slip.
Import Hyperbolic.Part_Sums.fn_pythagoras_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1)). Qed.
End fn_pythagoras_slip.

Module fn_sum.
Import Hyperbolic.Part_Sums.fn_sum.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_sum.

Module fn_difference.
Import Hyperbolic.Part_Sums.fn_difference.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_difference.
