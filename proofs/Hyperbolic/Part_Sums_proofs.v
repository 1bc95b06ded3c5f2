(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
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
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement] in no; generalize (no (ln 2)); clear no; powers_of_two tt; intro C; contradiction_in C. Qed.
End fn_pythagoras_slip.

Module fn_pythagoras_slip_corrected.
Import Hyperbolic.Part_Sums.fn_pythagoras_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_pythagoras_slip_corrected.

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
