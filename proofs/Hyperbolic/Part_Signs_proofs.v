(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Signs.
Open Scope R_scope.

Module fn_positive.
Import Hyperbolic.Part_Signs.fn_positive.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_positive.

Module fn_strict_slip.
Import Hyperbolic.Part_Signs.fn_strict_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0)). Qed.
End fn_strict_slip.

Module fn_bounded.
Import Hyperbolic.Part_Signs.fn_bounded.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros y N; pose proof (exp_pos y); pose proof (exp_pos (- y)); generalize dependent (exp y); generalize dependent (exp (- y)); intros m M e E P; split; [ apply (Rmult_lt_reg_r (e + m)); [ lra | replace ((e - m) / (e + m) * (e + m)) with (e - m) by (field; lra); lra ] | apply (Rmult_lt_reg_r (e + m)); [ lra | replace ((e - m) / (e + m) * (e + m)) with (e - m) by (field; lra); lra ] ]. Qed.
Theorem met : instance.
Proof. exists 0; pose proof (exp_pos 0); pose proof (exp_pos (- 0)); lra. Qed.
End fn_bounded.

Module fn_tangent_line.
Import Hyperbolic.Part_Signs.fn_tangent_line.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End fn_tangent_line.

Module fn_unit.
Import Hyperbolic.Part_Signs.fn_unit.
Theorem proved : statement.
Proof. intros x X; split; [ rewrite <- exp_0 at 1; apply exp_at_most; lra | apply exp_at_most; lra ]. Qed.
Theorem met : instance.
Proof. exists 0; lra. Qed.
End fn_unit.
