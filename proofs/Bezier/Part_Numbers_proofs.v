(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Numbers.
Open Scope R_scope.

Module exists_quotient_any.
Import Bezier.Part_Numbers.exists_quotient_any.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3); met) | (exists (0), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (0); met)]. Qed.
End exists_quotient_any.

Module exists_above.
Import Bezier.Part_Numbers.exists_above.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End exists_above.

Module exists_root.
Import Bezier.Part_Numbers.exists_root.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End exists_root.

Module exists_none.
Import Bezier.Part_Numbers.exists_none.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ). Qed.
End exists_none.

Module exists_parallel.
Import Bezier.Part_Numbers.exists_parallel.
Theorem proved : statement.
Proof. cbv delta [statement]; intros p1 p2 q1 q2; compute_goal; intros S E N; parts; pose proof (f_equal (Rmult p1) E); pose proof (f_equal (Rmult p2) E); field_simplify_eq; [ lra | intro Z; apply N; lra | lra | intro Z; apply N; lra ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 1, 0, 1, 0; compute_goal; repeat split; lra. Qed.
End exists_parallel.

Module exists_parallel_only.
Import Bezier.Part_Numbers.exists_parallel_only.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, (6); met) | (exists 0, 0, 0, 0, (0); met) | (exists 13, 8, 8, 6, (8); met) | (exists 7, 7, 7, 2, (1); met) | (exists 1, 0, 0, 1, (1); met)]. Qed.
End exists_parallel_only.
