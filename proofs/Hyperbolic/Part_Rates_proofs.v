(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Rates.
Open Scope R_scope.

Module fn_rate.
Import Hyperbolic.Part_Rates.fn_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two. Qed.
End fn_rate.

Module fn_growth.
Import Hyperbolic.Part_Rates.fn_growth.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_growth.

Module fn_bell.
Import Hyperbolic.Part_Rates.fn_bell.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_bell.

Module fn_damped.
Import Hyperbolic.Part_Rates.fn_damped.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_damped.

Module fn_damped_slip.
Import Hyperbolic.Part_Rates.fn_damped_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0)). Qed.
End fn_damped_slip.

Module fn_damped_slip_corrected.
Import Hyperbolic.Part_Rates.fn_damped_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_damped_slip_corrected.
