(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Signs.
Open Scope R_scope.

Module angle_first.
Import Trigonometric.Part_Signs.angle_first.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 6) * PI); met) | (exists ((1 / 4) * PI); met) | (exists ((1 / 6) * PI); met) | (exists ((1 / 6) * PI); met) | (exists ((1 / 6) * PI); met)]. Qed.
End angle_first.

Module angle_first_turned.
Import Trigonometric.Part_Signs.angle_first_turned.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End angle_first_turned.

Module angle_symmetric.
Import Trigonometric.Part_Signs.angle_symmetric.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros u [A B]; apply Rle_ge; rewrite <- cos_PI3; pose proof PI_RGT_0; destruct (Rle_or_lt 0 u) as [C|C]; [ apply cos_decr_1; lra | rewrite <- (cos_neg u); apply cos_decr_1; lra ]. Qed.
Theorem met : instance.
Proof. exists 0; pose proof PI_RGT_0; lra. Qed.
End angle_symmetric.

Module angle_symmetric_slip.
Import Trigonometric.Part_Signs.angle_symmetric_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1/2*PI)). Qed.
End angle_symmetric_slip.

Module angle_turn.
Import Trigonometric.Part_Signs.angle_turn.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End angle_turn.
