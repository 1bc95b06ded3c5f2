(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_The.
Import Trigonometric.Part_The.Definitions.
Open Scope R_scope.

Module quadratic_middle.
Import Trigonometric.Part_The.quadratic_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b]; first [(exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists (0), (0), ((1 / 4) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met)]. Qed.
End quadratic_middle.

Module quadratic_nonnegative.
Import Trigonometric.Part_The.quadratic_nonnegative.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b]; first [(exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists (0), (0), ((1 / 4) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((-1) / 3), ((1 / 6) * PI); met)]. Qed.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
Import Trigonometric.Part_The.quadratic_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a] in no; refuting (no (2) (1/3*PI)). Qed.
End quadratic_nonnegative_slip.

Module quadratic_symmetry.
Import Trigonometric.Part_The.quadratic_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c a]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c a]; first [(exists ((-1) / 3), ((1 / 6) * PI); met) | (exists (0), ((1 / 4) * PI); met) | (exists ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((1 / 6) * PI); met) | (exists ((-1) / 3), ((1 / 6) * PI); met)]. Qed.
End quadratic_symmetry.

Module quadratic_decreasing.
Import Trigonometric.Part_The.quadratic_decreasing.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a]; intros l t L [A B]; derivatives; pose proof PI_RGT_0; assert (S : 0 <= sin t) by (apply sin_ge_0; lra); assert (C : 0 <= cos t) by (apply cos_ge_0; lra); pose proof (SIN_bound t) as [_ S1]; generalize dependent (sin t); generalize dependent (cos t); intros c C s S S1; assert (0 <= c * ((1 + l) * (1 - s) + (1 - l) * s)) by (apply Rmult_le_pos; [ exact C | apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra ]); lra. Qed.
Theorem met : instance.
Proof. exists 0, 0; pose proof PI_RGT_0; lra. Qed.
End quadratic_decreasing.
