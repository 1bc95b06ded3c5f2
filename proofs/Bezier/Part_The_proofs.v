(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_The.
Import Bezier.Part_The.Definitions.
Open Scope R_scope.

Module circle_kappa.
Import Bezier.Part_The.circle_kappa.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement kappa]; ordered. Qed.
End circle_kappa.

Module circle_kappa_cut.
Import Bezier.Part_The.circle_kappa_cut.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement kappa]; ordered. Qed.
End circle_kappa_cut.

Module circle_kappa_slip.
Import Bezier.Part_The.circle_kappa_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement kappa] in no; refuting (no ). Qed.
End circle_kappa_slip.

Module circle_middle.
Import Bezier.Part_The.circle_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B kappa arc]; identity. Qed.
End circle_middle.

Module circle_outside.
Import Bezier.Part_The.circle_outside.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B kappa arc]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B kappa arc]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End circle_outside.

Module circle_exact_slip.
Import Bezier.Part_The.circle_exact_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B kappa arc] in no; refuting (no (1/3)). Qed.
End circle_exact_slip.

Module reach_definite.
Import Bezier.Part_The.reach_definite.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End reach_definite.

Module reach_cauchy.
Import Bezier.Part_The.reach_cauchy.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros a b c d e f; compute_goal; pose proof (pow2_ge_0 (a * e - b * d)); pose proof (pow2_ge_0 (a * f - c * d)); pose proof (pow2_ge_0 (b * f - c * e)); nra. Qed.
End reach_cauchy.
