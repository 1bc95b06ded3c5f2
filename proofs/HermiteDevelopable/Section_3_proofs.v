(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From HermiteDevelopable Require Section_3.
Open Scope R_scope.

Module eq_3_2_across_summit.
Import HermiteDevelopable.Section_3.eq_3_2_across_summit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; prepared; unknown dq'1; unknown dq'2; unknown dq'3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, (17), 18, 19, 20, 21, 22, 23; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_3_2_across_summit.
