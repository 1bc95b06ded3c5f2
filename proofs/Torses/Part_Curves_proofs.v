(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Curves.
Open Scope R_scope.

Module curve_chain.
Import Torses.Part_Curves.curve_chain.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End curve_chain.

Module curve_chain_slip.
Import Torses.Part_Curves.curve_chain_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1) (0) (0) (0) (1) (0) 0 0 0 (1) (2) (0) (0)). Qed.
End curve_chain_slip.

Module curve_chain_slip_corrected.
Import Torses.Part_Curves.curve_chain_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End curve_chain_slip_corrected.

Module curve_curvature.
Import Torses.Part_Curves.curve_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (11), (12), (13), (14); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), (0), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (2), (11), (1), (4); met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2, (1), (1), (1), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1), (0), (0), (0); met)]. Qed.
End curve_curvature.

Module curve_torsion.
Import Torses.Part_Curves.curve_torsion.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement tau]; intros a1 a2 a3 b1 b2 b3 c1 c2 c3 x y z f3 f2 f1 f0 u; match goal with |- context [vDerive 3 ?f 1 0] => replace (vDerive 3 f 1 0) with [f1 * c1; f1 * c2; f1 * c3] by (compute_goal; parts; derivatives; ring) end; match goal with |- context [vDerive 3 ?f 2 0] => replace (vDerive 3 f 2 0) with [f2 * c1 + f1 ^ 2 * b1; f2 * c2 + f1 ^ 2 * b2; f2 * c3 + f1 ^ 2 * b3] by (compute_goal; parts; derivatives; field) end; assert (T : forall w x y z, Derive_n (fun u => w + 1 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3 * f3 - f0) * x + 1 / 2 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3 * f3 - f0) ^ 2 * y + 1 / 6 * (f0 + 1 * u * f1 + 1 / 2 * u ^ 2 * f2 + 1 / 6 * u ^ 3 * f3 - f0) ^ 3 * z) 3 0 = f3 * x + 3 * f1 * f2 * y + f1 ^ 3 * z) by (clear; intros; set (a := f2 / 2); set (b := f3 / 6); rewrite (Derive_n_ext _ (poly [w; f1 * x; a * x + f1 ^ 2 / 2 * y; b * x + f1 * a * y + f1 ^ 3 / 6 * z; (a ^ 2 / 2 + f1 * b) * y + f1 ^ 2 * a / 2 * z; a * b * y + (f1 * a ^ 2 + f1 ^ 2 * b) / 2 * z; b ^ 2 / 2 * y + (a ^ 3 / 6 + f1 * a * b) * z; (a ^ 2 * b + f1 * b ^ 2) / 2 * z; a * b ^ 2 / 2 * z; b ^ 3 / 6 * z])); [rewrite poly_derive_n, poly_at_0; cbv beta iota zeta delta [slope_n slope slopes tl nth]; subst a b; field | intro t; replace (f0 + 1 * t * f1 + 1 / 2 * t ^ 2 * f2 + 1 / 6 * t ^ 3 * f3 - f0) with (t * f1 + t ^ 2 * a + t ^ 3 * b) by (subst a b; field); clearbody a b; cbn [poly]; field]); match goal with |- context [vDerive 3 ?f 3 0] => replace (vDerive 3 f 3 0) with [f3 * c1 + 3 * f1 * f2 * b1 + f1 ^ 3 * a1; f3 * c2 + 3 * f1 * f2 * b2 + f1 ^ 3 * a2; f3 * c3 + 3 * f1 * f2 * b3 + f1 ^ 3 * a3] by (symmetry; refine (f_equal2 (@cons R) (T x c1 b1 a1) (f_equal2 (@cons R) (T y c2 b2 a2) (f_equal2 (@cons R) (T z c3 b3 a3) eq_refl)))) end; clear T; compute_goal; intros _ F N D; match goal with |- ?a / ?b = ?c / ?d => replace a with (f1 ^ 6 * c) by ring; replace b with (f1 ^ 6 * d) by ring; let q := fresh in generalize dependent d; intros q ?; field; split; assumption end. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0; compute_goal; derivatives; repeat split; lra. Qed.
End curve_torsion.

Module curve_straight.
Import Torses.Part_Curves.curve_straight.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7; met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1; met)]. Qed.
End curve_straight.
