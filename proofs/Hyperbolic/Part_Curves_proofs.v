(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Curves.
Import Hyperbolic.Part_Curves.Definitions.
Open Scope R_scope.

Module curve_ends.
Import Hyperbolic.Part_Curves.curve_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F f_ g_ h_ F_]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_ends.

Module curve_d1.
Import Hyperbolic.Part_Curves.curve_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_d1.

Module curve_d1_slip.
Import Hyperbolic.Part_Curves.curve_d1_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement f g h F] in no; assert (A : 0 < 2 * ln 2) by (pose proof (ln_lt_2); lra); generalize (no (fun i => if Z.eqb i 1 then 1 else 0) (2 * ln 2) A); clear no; compute_goal; powers_of_two tt; intro no; assert (N : 3 <> 0) by numeric; assert (C := no ltac:(numeric) ltac:(numeric)); clear no; revert C; derivatives; powers_of_two tt; intro C; contradiction_in C. Qed.
End curve_d1_slip.

Module curve_d1_slip_corrected.
Import Hyperbolic.Part_Curves.curve_d1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_d1_slip_corrected.

Module curve_d2.
Import Hyperbolic.Part_Curves.curve_d2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_d2.

Module curve_middle.
Import Hyperbolic.Part_Curves.curve_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End curve_middle.

Module curve_middle_slip.
Import Hyperbolic.Part_Curves.curve_middle_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement f g h F] in no; assert (A : 0 < 4 * ln 2) by (pose proof (ln_lt_2); lra); generalize (no (fun i => if Z.eqb i 2 then 1 else 0) (4 * ln 2) A); clear no; compute_goal; powers_of_two tt; intro no; refine (_ (no _ _)); [intro C; contradiction_in C | numeric | numeric]. Qed.
End curve_middle_slip.

Module shape_ends.
Import Hyperbolic.Part_Curves.shape_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h F]; symbolic. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End shape_ends.

Module shape_d1.
Import Hyperbolic.Part_Curves.shape_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h F s]; symbolic. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 0), (2 * ln 2); of_exponentials powers_of_two. Qed.
End shape_d1.

Module shape_d1_slip.
Import Hyperbolic.Part_Curves.shape_d1_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [statement F h s]; intro no; assert (L : 0 < ln 2) by (pose proof ln_lt_2; lra); assert (C := no 2%Z (fun i => if Z.eqb i 1 then 1 else 0) (2 * ln 2) ltac:(lia) ltac:(lra) ltac:(intros; powers_of_two tt; numeric) ltac:(powers_of_two tt; numeric) ltac:(lia) ltac:(lia)); clear no; revert C; compute_goal; assert (N : ((exp (2 * ln 2 / 2) - exp (- (2 * ln 2 / 2))) / 2) ^ 2 <> 0) by (powers_of_two tt; numeric); derivatives; powers_of_two tt; intro C; lra. Qed.
End shape_d1_slip.

Module shape_slope.
Import Hyperbolic.Part_Curves.shape_slope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement s]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s]; first [(exists (1); met) | (exists (1); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End shape_slope.
