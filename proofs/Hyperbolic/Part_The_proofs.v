(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_The.
Import Hyperbolic.Part_The.Definitions.
Open Scope R_scope.

Module quadratic_unity.
Import Hyperbolic.Part_The.quadratic_unity.
Theorem proved : statement.
Proof. let halves := fun a t => (let is x v := (try replace (exp x) with v by (rewrite <- exp_plus; f_equal; field)) in is ((a - t) / 2) (exp (a / 2) * exp (- (t / 2))); is (- ((a - t) / 2)) (exp (- (a / 2)) * exp (t / 2)); is a (exp (a / 2) * exp (a / 2)); is (- a) (exp (- (a / 2)) * exp (- (a / 2))); is t (exp (t / 2) * exp (t / 2)); is (- t) (exp (- (t / 2)) * exp (- (t / 2))); pose proof (exp_inverse (a / 2)); pose proof (exp_inverse (t / 2)); generalize dependent (exp (a / 2)); generalize dependent (exp (- (a / 2))); generalize dependent (exp (t / 2)); generalize dependent (exp (- (t / 2))); intros; divisors; parts; match goal with E : ?e * ?m = 1, F : ?x * ?y = 1 |- _ => lazymatch e with x => fail | _ => idtac end; field_simplify_eq; [ring [E F] | nonzero] end) in cbv beta zeta delta [statement f g h]; compute_goal; intros a t A T N; halves a t. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two. Qed.
End quadratic_unity.

Module quadratic_symmetry.
Import Hyperbolic.Part_The.quadratic_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f h g]; intros a t A T N; replace (a - (a - t)) with t by ring; split; [reflexivity | unfold Rdiv; ring]. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), 0; of_exponentials powers_of_two. Qed.
End quadratic_symmetry.

Module quadratic_ends.
Import Hyperbolic.Part_The.quadratic_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; identity. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2); of_exponentials powers_of_two. Qed.
End quadratic_ends.

Module quadratic_nonnegative.
Import Hyperbolic.Part_The.quadratic_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; intros a t A T L N; assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra); pose proof (sinh_nonnegative (t / 2) ltac:(lra)) as S0; pose proof (sinh_nonnegative ((a - t) / 2) ltac:(lra)) as S1; pose proof (cosh_positive (a / 2)) as C; generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2); generalize dependent ((exp (t / 2) - exp (- (t / 2))) / 2); generalize dependent ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2); generalize dependent ((exp (a / 2) + exp (- (a / 2))) / 2); intros c C y Y x X d N D; assert (V : 0 < / d ^ 2) by (apply Rinv_0_lt_compat, pow_lt, D); repeat split; apply Rle_ge; unfold Rdiv; repeat apply Rmult_le_pos; first [ lra | apply pow_le; assumption ]. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts; first [ lra | powers_of_two tt; numeric ]. Qed.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
Import Hyperbolic.Part_The.quadratic_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in intro no; cbv beta zeta delta [statement g] in no; generalize (no (2 * ln 2) (4 * ln 2)); clear no; powers_of_two tt; pose proof ln_lt_2; intro no; refine (_ (no _ _ _)); [intro C; apply (Rge_not_lt _ _ C); numeric | lra | lra | numeric]. Qed.
End quadratic_nonnegative_slip.

Module quadratic_decreasing.
Import Hyperbolic.Part_The.quadratic_decreasing.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; intros a t A T L N; assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra); derivatives; pose proof (sinh_nonnegative ((a - t) / 2) ltac:(lra)) as S; pose proof (cosh_positive ((a - t) / 2)) as C; change ((a - t) * / 2) with ((a - t) / 2); generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2); intros d N D; generalize dependent (exp ((a - t) / 2)); generalize dependent (exp (- ((a - t) / 2))); intros m e S C; assert (Z : 0 <= (e - m) / 2 * ((e + m) / 2) * / d ^ 2) by (apply Rmult_le_pos; [ apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat, pow_lt, D ]); apply Rle_trans with (- ((e - m) / 2 * ((e + m) / 2) * / d ^ 2)); [ right; field; lra | lra ]. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts; first [ lra | powers_of_two tt; numeric ]. Qed.
End quadratic_decreasing.

Module quadratic_largest.
Import Hyperbolic.Part_The.quadratic_largest.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h]; intros a t A T L N; assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra); pose proof (sinh_at_most (t / 2) (a / 2) ltac:(lra)) as S; pose proof (sinh_nonnegative (t / 2) ltac:(lra)) as S0; generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2); generalize dependent ((exp (t / 2) - exp (- (t / 2))) / 2); intros x X d N D S; apply (Rmult_le_reg_r (d ^ 2)); [ apply pow_lt, D | replace (x ^ 2 / d ^ 2 * d ^ 2) with (x ^ 2) by (field; lra); rewrite Rmult_1_l; apply pow_incr; lra ]. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists (2 * ln 2), (ln 2); pose proof ln_lt_2; conjuncts; first [ lra | powers_of_two tt; numeric ]. Qed.
End quadratic_largest.

Module quadratic_space.
Import Hyperbolic.Part_The.quadratic_space.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End quadratic_space.

Module shape_unity.
Import Hyperbolic.Part_The.shape_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h]; intros k a t K A [T L] N; specialize (N 0%Z ltac:(lia)); apply unity_of_three; [ lia | lra | ]; pose proof (exp_inverse (a / 2)) as E; pose proof (exp_inverse (a * t / 2)) as F; replace (exp (a * (1 - t) / 2)) with (exp (a / 2) * exp (- (a * t / 2))) by (rewrite <- exp_plus; f_equal; field); replace (exp (- (a * (1 - t) / 2))) with (exp (- (a / 2)) * exp (a * t / 2)) by (rewrite <- exp_plus; f_equal; field); generalize dependent (exp (a / 2)); generalize dependent (exp (- (a / 2))); generalize dependent (exp (a * t / 2)); generalize dependent (exp (- (a * t / 2))); intros y x F m e N E; assert (M : e - m <> 0) by (intro Z; apply N; rewrite Z; field); field_simplify_eq; [ ring [E F] | exact M ]. Qed.
Theorem met : instance.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 2%Z, (2 * ln 2), 0; pose proof ln_lt_2; conjuncts; first [ lia | lra | intros; powers_of_two tt; numeric ]. Qed.
End shape_unity.

Module shape_symmetry.
Import Hyperbolic.Part_The.shape_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h]; intros; replace (1 - (1 - u)) with u by ring; symmetry; apply basis_mirror; [reflexivity | cbn [length]; lia | let i := fresh in intros i ?; cbn [length] in *; destruct i as [|[|[|i]]]; cbn [nth Nat.sub]; try lia; unfold Rdiv; ring | cbn [length]; lia]. Qed.
Theorem met : instance.
Proof. let of_exponentials := fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall; let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | |- forall _, _ => intros; powers tt; numeric | |- _ => first [lia | powers tt; first [numeric | lra]] end) in let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [instance]; exists 0%Z, (2 * ln 2), 0; of_exponentials powers_of_two. Qed.
End shape_symmetry.

Module shape_nonnegative.
Import Hyperbolic.Part_The.shape_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h]; intros a t A [T L] i k K; assert (D : 0 < (exp (a / 2) - exp (- (a / 2))) / 2) by (apply sinh_positive; lra); pose proof (sinh_nonnegative (a * t / 2) ltac:(nra)) as S0; pose proof (sinh_nonnegative (a * (1 - t) / 2) ltac:(nra)) as S1; pose proof (cosh_positive (a / 2)) as C; generalize dependent ((exp (a / 2) - exp (- (a / 2))) / 2); generalize dependent ((exp (a * t / 2) - exp (- (a * t / 2))) / 2); generalize dependent ((exp (a * (1 - t) / 2) - exp (- (a * (1 - t) / 2))) / 2); generalize dependent ((exp (a / 2) + exp (- (a / 2))) / 2); intros c C y Y x X d D; assert (V : 0 < / d ^ 2) by (apply Rinv_0_lt_compat, pow_lt, D); apply basis_nonneg; [ lra | lra | intro j; do 3 (destruct j as [|j]; cbn [nth]; [ unfold Rdiv; repeat apply Rmult_le_pos; first [ lra | apply pow_le; assumption ] | ]); destruct j; cbn [nth]; lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 0; lra. Qed.
End shape_nonnegative.
