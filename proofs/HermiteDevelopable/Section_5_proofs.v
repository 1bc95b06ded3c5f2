(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_5.
Import HermiteDevelopable.Section_5.Definitions.
From HermiteDevelopable Require Import Section_5_closed.
Open Scope R_scope.

Module sec_5_criteria_a.
Import HermiteDevelopable.Section_5.sec_5_criteria_a.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; similar_quintics quintic_basis; parallel_tangents. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End sec_5_criteria_a.

Module sec_5_criteria_reach.
Import HermiteDevelopable.Section_5.sec_5_criteria_reach.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]; similar_quintics quintic_basis; compute_goal; parts; images; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 p5 q5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______]); met_joins. Qed.
End sec_5_criteria_reach.

Module sec_5_planes_a.
Import HermiteDevelopable.Section_5.sec_5_planes_a.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5]; similar_quintics quintic_basis; assert (k <> 0) by lra; worth_times k p0u'1 0; worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; worth qu'1 0; split; [by_coefficients | split; [by_coefficients | parallel_tangents]]. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5]); met_joins. Qed.
End sec_5_planes_a.

Module sec_5_planes_b.
Import HermiteDevelopable.Section_5.sec_5_planes_b.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no; with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5]) curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r5 p5 blend6 hermite5]) curve); compute_goal; intro C; contradiction_in C. Qed.
End sec_5_planes_b.
