(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Hyperbolas.
Import Hyperbolic.Part_Hyperbolas.Definitions.
Open Scope R_scope.

Module curve_hyperbola.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola.
Theorem proved : statement.
Proof. let halves := fun a t => (let is x v := (try replace (exp x) with v by (rewrite <- exp_plus; f_equal; field)) in is ((a - t) / 2) (exp (a / 2) * exp (- (t / 2))); is (- ((a - t) / 2)) (exp (- (a / 2)) * exp (t / 2)); is a (exp (a / 2) * exp (a / 2)); is (- a) (exp (- (a / 2)) * exp (- (a / 2))); is t (exp (t / 2) * exp (t / 2)); is (- t) (exp (- (t / 2)) * exp (- (t / 2))); pose proof (exp_inverse (a / 2)); pose proof (exp_inverse (t / 2)); generalize dependent (exp (a / 2)); generalize dependent (exp (- (a / 2))); generalize dependent (exp (t / 2)); generalize dependent (exp (- (t / 2))); intros; divisors; parts; match goal with E : ?e * ?m = 1, F : ?x * ?y = 1 |- _ => lazymatch e with x => fail | _ => idtac end; field_simplify_eq; [ring [E F] | nonzero] end) in cbv beta zeta delta [statement f g h E_]; compute_goal; intros a t A T N S; halves a t. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two. Qed.
End curve_hyperbola.

Module curve_hyperbola_implicit.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.
Theorem proved : statement.
Proof. let halves := fun a t => (let is x v := (try replace (exp x) with v by (rewrite <- exp_plus; f_equal; field)) in is ((a - t) / 2) (exp (a / 2) * exp (- (t / 2))); is (- ((a - t) / 2)) (exp (- (a / 2)) * exp (t / 2)); is a (exp (a / 2) * exp (a / 2)); is (- a) (exp (- (a / 2)) * exp (- (a / 2))); is t (exp (t / 2) * exp (t / 2)); is (- t) (exp (- (t / 2)) * exp (- (t / 2))); pose proof (exp_inverse (a / 2)); pose proof (exp_inverse (t / 2)); generalize dependent (exp (a / 2)); generalize dependent (exp (- (a / 2))); generalize dependent (exp (t / 2)); generalize dependent (exp (- (t / 2))); intros; divisors; parts; match goal with E : ?e * ?m = 1, F : ?x * ?y = 1 |- _ => lazymatch e with x => fail | _ => idtac end; field_simplify_eq; [ring [E F] | nonzero] end) in cbv beta zeta delta [statement f g h E_]; compute_goal; intros a t A T N S; halves a t. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two. Qed.
End curve_hyperbola_implicit.

Module curve_hyperbola_tangent.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h E_]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_hyperbola_tangent.
