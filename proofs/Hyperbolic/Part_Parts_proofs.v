(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Parts.
Open Scope R_scope.

Module fn_half.
Import Hyperbolic.Part_Parts.fn_half.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_half.

Module fn_half_slip.
Import Hyperbolic.Part_Parts.fn_half_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement] in no; generalize (no (2 * ln 2)); clear no; powers_of_two tt; intro C; contradiction_in C. Qed.
End fn_half_slip.

Module fn_half_slip_corrected.
Import Hyperbolic.Part_Parts.fn_half_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_half_slip_corrected.

Module fn_third.
Import Hyperbolic.Part_Parts.fn_third.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_third.

Module fn_tangent.
Import Hyperbolic.Part_Parts.fn_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two. Qed.
End fn_tangent.
