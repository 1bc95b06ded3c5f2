(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Logarithmic.
Import Hyperbolic.Part_Logarithmic.Definitions.
Open Scope R_scope.

Module spiral_angle.
Import Hyperbolic.Part_Logarithmic.spiral_angle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
End spiral_angle.

Module spiral_angle_slip.
Import Hyperbolic.Part_Logarithmic.spiral_angle_slip.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement S_]; intro no; generalize (no 1 0); compute_goal; derivatives; rewrite ?Rmult_0_r, ?cos_0, ?sin_0, ?exp_0; intro C; lra. Qed.
End spiral_angle_slip.

Module spiral_regular.
Import Hyperbolic.Part_Logarithmic.spiral_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; ordered. Qed.
End spiral_regular.

Module spiral_curvature.
Import Hyperbolic.Part_Logarithmic.spiral_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance S_]; exists 0, 0; compute_goal; derivatives; special; powers_of_two tt; split; numeric. Qed.
End spiral_curvature.
