(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Signs.
Open Scope R_scope.

Module fn_positive.
Import Hyperbolic.Part_Signs.fn_positive.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_positive.

Module fn_strict_slip.
Import Hyperbolic.Part_Signs.fn_strict_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0)). Qed.
End fn_strict_slip.

Module fn_tangent_line.
Import Hyperbolic.Part_Signs.fn_tangent_line.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_tangent_line.
