(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Known.
Open Scope R_scope.

Module angle_known.
Import Trigonometric.Part_Known.angle_known.
Theorem proved : statement.
Proof. cbv beta delta [statement]; replace (PI / 12) with (PI / 3 - PI / 4) by field; rewrite sin_minus, sin_PI3, cos_PI3, sin_PI4, cos_PI4; replace 6 with (2 * 3) by ring; rewrite sqrt_mult by lra; pose proof (sqrt_lt_R0 2 ltac:(lra)); assert (E : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra); generalize dependent (sqrt 2); intros a A E; apply (Rmult_eq_reg_l a); [ | lra ]; field_simplify_eq; [ ring [E] | lra ]. Qed.
End angle_known.
