(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Distribution.
Import Torses.Part_Distribution.Definitions.
Open Scope R_scope.

Module striction_parameter.
Import Torses.Part_Distribution.striction_parameter.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement delta p]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance delta p]; first [(exists (2), (3), 4, 5, 6, 7, 8, 9, 10, 11, 12, (13); met) | (exists (0), (0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0); met) | (exists (13), (8), 8, 6, 8, 7, 9, 7, 7, 2, 11, (1); met) | (exists (1), (1), 7, 7, 2, 2, 11, 1, 2, 11, 1, (1); met) | (exists (1), (0), 1, 0, 0, 0, 1, 0, 0, 0, 1, (0); met)]. Qed.
End striction_parameter.

Module striction_curvature.
Import Torses.Part_Distribution.striction_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ p delta]; intros c1 c2 c3 x y z p1 p2 p3 r1 r2 r3 u R0 _ B; set (t := s _ _ _); replace (vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] t u_) 1 0) with [c1 + t * p1; c2 + t * p2; c3 + t * p3] by (clearbody t; cbv beta delta [X]; compute_goal; parts; derivatives; ring); replace (vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2; r3] (t + v_)) 1 0) with [r1; r2; r3] by (clearbody t; cbv beta delta [X_]; compute_goal; parts; derivatives; ring); subst t; cbv beta delta [s]; rewrite R0; set (bb := dot (cross [p1; p2; p3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3])) in *; transitivity (det [[c1; c2; c3]; [r1; r2; r3]; [p1; p2; p3]] ^ 2 * dot [r1; r2; r3] [r1; r2; r3] / bb); [ set (ab := dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3])); transitivity (dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [c1; c2; c3] [r1; r2; r3]) + 2 * (- ab / bb) * ab + (- ab / bb) ^ 2 * bb); [ subst ab; generalize (- dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [p1; p2; p3] [r1; r2; r3]) / bb); subst bb; compute_goal; intro; ring | transitivity ((dot (cross [c1; c2; c3] [r1; r2; r3]) (cross [c1; c2; c3] [r1; r2; r3]) * bb - ab ^ 2) / bb); [ field; exact B | unfold Rdiv; f_equal; subst ab bb; compute_goal; ring ] ] | rewrite R0; field; exact B ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0; compute_goal; repeat split; lra. Qed.
End striction_curvature.
