(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences.
From HermiteDevelopable Require Section_3_3.
Open Scope R_scope.

Module eq_3_7_det.
Import HermiteDevelopable.Section_3_3.eq_3_7_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A37]; identity. Qed.
End eq_3_7_det.

Module eq_3_7_sol_o.
Import HermiteDevelopable.Section_3_3.eq_3_7_sol_o.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage quintic_part; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; staged_goal quintic_criterion______; unstaged; prepared; known (o) (k*p0 - q0) (k - 1); known (p0u) (q0u) (k); known (p1) (k*p0 - q0 + q1) (k); known (p1u) (q1u) (k); known (qm) (-k*p0 + k*pm + q0) (1); known (qu) (k*pu) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; stage blend6; stage hermite5; stage q5; stage p5; stage quintic_gap; stage quintic_part; stage quintic_criterion; stage quintic_criterion_; stage quintic_criterion__; stage quintic_criterion___; stage quintic_criterion____; stage quintic_criterion_____; staged_goal quintic_criterion______; unstaged; first [(exists 2, 3, 4, 5, 6, 7, (8), ((((8))*(10) - (16)) / (((8)) - 1)), 10, (((17)) / (((8)))), ((((8))*(10) - (16) + (18)) / (((8)))), (((19)) / (((8)))), 14, 15, 16, 17, 18, 19, ((-((8))*(10) + ((8))*(14) + (16)) / (1)), ((((8))*(15)) / (1)); met) | (exists 0, 0, 0, 0, 0, 0, (0), ((((0))*(0) - (0)) / (((0)) - 1)), 0, (((0)) / (((0)))), ((((0))*(0) - (0) + (0)) / (((0)))), (((0)) / (((0)))), 0, 0, 0, 0, 0, 0, ((-((0))*(0) + ((0))*(0) + (0)) / (1)), ((((0))*(0)) / (1)); met) | (exists 13, 8, 8, 6, 8, 7, (9), ((((9))*(7) - (8)) / (((9)) - 1)), 7, (((8)) / (((9)))), ((((9))*(7) - (8) + (6)) / (((9)))), (((8)) / (((9)))), 4, 13, 8, 8, 6, 8, ((-((9))*(7) + ((9))*(4) + (8)) / (1)), ((((9))*(13)) / (1)); met) | (exists 1, 1, 1, 1, 1, 1, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)); met) | (exists 0, 0, 0, 0, 0, 0, (1), ((((1))*(1) - (1)) / (((1)) - 1)), 1, (((1)) / (((1)))), ((((1))*(1) - (1) + (1)) / (((1)))), (((1)) / (((1)))), 1, 1, 1, 1, 1, 1, ((-((1))*(1) + ((1))*(1) + (1)) / (1)), ((((1))*(1)) / (1)); met)]. Qed.
End eq_3_7_sol_o.
