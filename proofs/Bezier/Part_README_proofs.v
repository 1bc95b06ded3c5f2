(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_README.
Open Scope R_scope.

Module language_numbers.
Import Bezier.Part_README.language_numbers.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m x P Q; refine (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ _)))))); [ compute_goal; lra | compute_goal; field | compute_goal; lra | replace 8 with (2 * 2 * 2) by ring; rewrite sqrt_mult by lra; rewrite sqrt_square by lra; ring | rewrite <- sqrt_mult by lra; f_equal; ring | apply sin_PI6 | replace (PI * x) with (2 * (PI / 2 * x)) by field; apply sin_2a ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 2); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met) | (exists (1)%Z, (1 / 3); met)]. Qed.
End language_numbers.

Module language_calculus.
Import Bezier.Part_README.language_calculus.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E_]; first [(exists (1 / 3), (3); met) | (exists (1 / 2), (0); met) | (exists (1 / 3), (8); met) | (exists (1 / 3), (1); met) | (exists (1 / 3), (1); met)]. Qed.
End language_calculus.

Module language_vectors.
Import Bezier.Part_README.language_vectors.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros a b c d e f; compute_goal; refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))); [ ring | repeat f_equal; ring | replace (3 * 3 + (4 * 4 + 0)) with (5 * 5) by ring; apply sqrt_square; lra | f_equal; ring | reflexivity | ring ]. Qed.
End language_vectors.

Module language_matrices.
Import Bezier.Part_README.language_matrices.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7); met) | (exists 1, 1, 7, 7, 2, 7, 2, 11, (1); met) | (exists 0, 0, 1, 0, 0, 0, 1, 0, (1); met)]. Qed.
End language_matrices.

Module language_decimals.
Import Bezier.Part_README.language_decimals.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
End language_decimals.

Module language_divisor.
Import Bezier.Part_README.language_divisor.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End language_divisor.

Module language_degree.
Import Bezier.Part_README.language_degree.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (1)%Z, (fun _ => 3), (1 / 3); met) | (exists (1)%Z, (fun _ => 0), (1 / 2); met) | (exists (1)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (1 / 3); met) | (exists (1)%Z, (fun _ => 1), (1 / 3); met) | (exists (1)%Z, (fun _ => 0), (1 / 3); met)]. Qed.
End language_degree.

Module language_order.
Import Bezier.Part_README.language_order.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End language_order.

Module language_order_false.
Import Bezier.Part_README.language_order_false.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0)). Qed.
End language_order_false.

Module language_assumed.
Import Bezier.Part_README.language_assumed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End language_assumed.

Module language_declared.
Import Bezier.Part_README.language_declared.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (6); met) | (exists (6); met) | (exists (18); met) | (exists (6); met) | (exists (6); met)]. Qed.
End language_declared.

Module language_decimals_false.
Import Bezier.Part_README.language_decimals_false.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ). Qed.
End language_decimals_false.
