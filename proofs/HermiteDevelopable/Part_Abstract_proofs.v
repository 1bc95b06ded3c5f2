(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Part_Abstract.
Import HermiteDevelopable.Part_Abstract.Definitions.
From HermiteDevelopable Require Import Part_Abstract_closed.
Open Scope R_scope.

Module abs_construct_a.
Import HermiteDevelopable.Part_Abstract.abs_construct_a.
Theorem proved : statement.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion_ cubic_criterion__ cubic_criterion___ cubic_criterion____ p0]; similar_cubics cubic_basis; split; [by_coefficients | split; [apply (cancelled k); [nonzero | rewrite Rmult_0_r; unfold entry; cbn [nth Nat.pred]; match goal with T : forall x, _ = _ * poly (slope ?p) x |- _ * poly (slope ?p) ?u = _ => rewrite <- (T u) end; by_coefficients] | parallel_tangents]]. Qed.
Theorem met : instance.
Proof. stage cubic; stage cubic_; stage cubic_data; stage cubic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; cubic_parts cubic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u blend4 hermite3 q3 p3 cubic_gap cubic_part cubic_criterion cubic_criterion_ cubic_criterion__ cubic_criterion___ cubic_criterion____ p0]); met_joins. Qed.
End abs_construct_a.

Module abs_construct_b.
Import HermiteDevelopable.Part_Abstract.abs_construct_b.
Theorem proved : statement.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [statement blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____ q0 q1 q0u q1u p0 pm]; similar_quartics quartic_basis; assert (k <> 0) by lra; worth_times k p0u'1 0; worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; split; [by_coefficients | split; [by_coefficients | parallel_tangents]]. Qed.
Theorem met : instance.
Proof. stage quartic; stage quartic_; stage quartic_data; stage quartic_basis; cbv beta zeta delta [instance blend5 hermite4 q4 p4 quartic_gap quartic_part quartic_criterion quartic_criterion_ quartic_criterion__ quartic_criterion___ quartic_criterion____ quartic_criterion_____ q0 q1 q0u q1u p0 pm]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quartic_joins quartic_basis; met_joins. Qed.
End abs_construct_b.

Module abs_construct_c.
Import HermiteDevelopable.Part_Abstract.abs_construct_c.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement pu q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ q0 q1 q0u q1u p0 pm blend6 hermite5]; similar_quintics quintic_basis; assert (k <> 0) by lra; worth_times k p0u'1 0; worth_times k p1u'1 0; worth_times k p1'1 l; worth qm'1 h; worth qu'1 0; split; [by_coefficients | split; [by_coefficients | parallel_tangents]]. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [pu q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ q0 q1 q0u q1u p0 pm blend6 hermite5]); met_joins. Qed.
End abs_construct_c.

Module abs_construct_d.
Import HermiteDevelopable.Part_Abstract.abs_construct_d.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no; with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5]) curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r5 p5 p0 pm blend6 hermite5]) curve); compute_goal; intro C; contradiction_in C. Qed.
End abs_construct_d.
