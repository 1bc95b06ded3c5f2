(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Tractrix.
Import Hyperbolic.Part_Tractrix.Definitions.
Open Scope R_scope.

Module tractrix_pull.
Import Hyperbolic.Part_Tractrix.tractrix_pull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance T]; exists (ln 2); pose proof (exp_pos (ln 2)); pose proof (exp_pos (- ln 2)); compute_goal; derivatives; of_exponentials powers_of_two. Qed.
End tractrix_pull.

Module tractrix_speed.
Import Hyperbolic.Part_Tractrix.tractrix_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 0; of_exponentials powers_of_two. Qed.
End tractrix_speed.
