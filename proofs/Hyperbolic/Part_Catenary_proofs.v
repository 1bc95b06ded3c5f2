(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Catenary.
Import Hyperbolic.Part_Catenary.Definitions.
Open Scope R_scope.

Module catenary_speed.
Import Hyperbolic.Part_Catenary.catenary_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End catenary_speed.

Module catenary_length.
Import Hyperbolic.Part_Catenary.catenary_length.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End catenary_length.

Module catenary_curvature.
Import Hyperbolic.Part_Catenary.catenary_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance K]; exists 0; compute_goal; derivatives; powers_of_two tt; split; numeric. Qed.
End catenary_curvature.

Module catenary_curvature_slip.
Import Hyperbolic.Part_Catenary.catenary_curvature_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement K] in no; generalize (no (ln 2)); clear no; compute_goal; derivatives; powers_of_two tt; intro no; refine (_ (no _ _)); [intro C; contradiction_in C | numeric | numeric]. Qed.
End catenary_curvature_slip.

Module catenary_curvature_slip_corrected.
Import Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance K]; exists 0; compute_goal; derivatives; powers_of_two tt; split; numeric. Qed.
End catenary_curvature_slip_corrected.

Module catenary_load.
Import Hyperbolic.Part_Catenary.catenary_load.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End catenary_load.
