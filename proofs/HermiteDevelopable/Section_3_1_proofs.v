(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From HermiteDevelopable Require Section_3_1.
Open Scope R_scope.

Module sec_3_1_polynomials.
Import HermiteDevelopable.Section_3_1.sec_3_1_polynomials.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement first second]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance first second]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 3); met)]. Qed.
End sec_3_1_polynomials.

Module sec_3_1_substituted.
Import HermiteDevelopable.Section_3_1.sec_3_1_substituted.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement second first]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0, (1 / 3); met)]. Qed.
End sec_3_1_substituted.

Module sec_3_1_coefficients.
Import HermiteDevelopable.Section_3_1.sec_3_1_coefficients.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement second first gap part]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance second first gap part]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (10), 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (0), 0; met)]. Qed.
End sec_3_1_coefficients.
