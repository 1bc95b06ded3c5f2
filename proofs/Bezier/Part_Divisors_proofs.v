(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Divisors.
Open Scope R_scope.

Module reach_interval_open.
Import Bezier.Part_Divisors.reach_interval_open.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. exists 0, 2, 1; repeat split; lra. Qed.
End reach_interval_open.

Module reach_interval_closed.
Import Bezier.Part_Divisors.reach_interval_closed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. exists 0, 2, 1; repeat split; lra. Qed.
End reach_interval_closed.

Module reach_positive.
Import Bezier.Part_Divisors.reach_positive.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End reach_positive.

Module reach_open.
Import Bezier.Part_Divisors.reach_open.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End reach_open.

Module reach_ordered.
Import Bezier.Part_Divisors.reach_ordered.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2), (3), (4), (5); met) | (exists (0), (0), (0), (0); met) | (exists (13), (8), (8), (6); met) | (exists (1), (1), (1), (1); met) | (exists (1), (0), (0), (0); met)]. Qed.
End reach_ordered.

Module reach_vector.
Import Bezier.Part_Divisors.reach_vector.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 1, 0, 0, 0, 0, 0; refine (conj (fun E => _) _); [ injection E as E; lra | compute_goal; lra ]. Qed.
End reach_vector.
