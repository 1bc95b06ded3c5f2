(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Roots.
Import Hyperbolic.Part_Roots.Definitions.
Open Scope R_scope.

Module catenary_norm.
Import Hyperbolic.Part_Roots.catenary_norm.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives; pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1; [ nra | lra | field_simplify_eq; ring [E] ]); exact L. Qed.
End catenary_norm.

Module catenary_bend.
Import Hyperbolic.Part_Roots.catenary_bend.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros t N0 N; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives; pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1; [ nra | lra | field_simplify_eq; ring [E] ]); rewrite L; clear L N0 N; cbv beta delta [K]; compute_goal; derivatives; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t); generalize dependent (exp (- t)); intros; field; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives; pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1; [ nra | lra | field_simplify_eq; ring [E] ]); exists 0; rewrite L, Ropp_0, exp_0; split; apply pow_nonzero; lra. Qed.
End catenary_bend.

Module catenary_bend_slip.
Import Hyperbolic.Part_Roots.catenary_bend_slip.
Theorem refuted : ~ statement.
Proof. let powers_of_two := fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra); let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y); [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E; field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2) | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2)) | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E) in cbv beta zeta delta [statement]; intro no; assert (L : forall t, norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2) by (clear; intro t; cbv beta zeta delta [K norm]; compute_goal; derivatives; pose proof (exp_inverse t) as E; pose proof (exp_pos t); pose proof (exp_pos (- t)); generalize dependent (exp t); generalize dependent (exp (- t)); intros m M e E P; apply sqrt_lem_1; [ nra | lra | field_simplify_eq; ring [E] ]); generalize (no (ln 2)); clear no; rewrite L; clear L; cbv beta delta [K]; compute_goal; derivatives; powers_of_two tt; intro no; refine (_ (no _ _)); [ intro C; revert C; match goal with |- ?a = ?b -> False => change (a <> b) end; numeric | numeric | numeric ]. Qed.
End catenary_bend_slip.

Module catenary_bend_slip_corrected.
Import Hyperbolic.Part_Roots.catenary_bend_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End catenary_bend_slip_corrected.

Module tractrix_norm.
Import Hyperbolic.Part_Roots.tractrix_norm.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T norm]; compute_goal; intros t N1 N2 N3 P; apply locally_singleton in N1; apply locally_singleton in N2; derivatives; f_equal; pose proof (exp_inverse t) as E; clear P N2; generalize dependent (exp t); generalize dependent (exp (- t)); intros m e N N' E; field_simplify_eq; [ ring [E] | repeat split; assumption ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0; repeat split; first [ apply filter_forall; intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra | pose proof (exp_pos 0); pose proof (exp_pos (- 0)); lra | apply Rle_0_sqr ]. Qed.
End tractrix_norm.
