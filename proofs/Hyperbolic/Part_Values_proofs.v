(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Values.
Open Scope R_scope.

Module fn_number.
Import Hyperbolic.Part_Values.fn_number.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_number.

Module fn_value.
Import Hyperbolic.Part_Values.fn_value.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_value.
