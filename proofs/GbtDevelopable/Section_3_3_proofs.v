(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtDevelopable Require Section_3_3.
Import GbtDevelopable.Section_3_3.Definitions.
Open Scope R_scope.

Module sec_3_3_S_vec.
Import GbtDevelopable.Section_3_3.sec_3_3_S_vec.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a' a'' system cramer1 cramer2 cramer3 S_] in no; refuting (no (1) (1) (1) (1) (1) (2) (1) (2) (1) (1) (1) (1)). Qed.
End sec_3_3_S_vec.

Module sec_3_3_S_x.
Import GbtDevelopable.Section_3_3.sec_3_3_S_x.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer1]; identity. Qed.
End sec_3_3_S_x.

Module sec_3_3_S_y.
Import GbtDevelopable.Section_3_3.sec_3_3_S_y.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer2]; identity. Qed.
End sec_3_3_S_y.

Module sec_3_3_S_z.
Import GbtDevelopable.Section_3_3.sec_3_3_S_z.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer3]; identity. Qed.
End sec_3_3_S_z.

Module sec_3_3_S_den.
Import GbtDevelopable.Section_3_3.sec_3_3_S_den.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' system]; identity. Qed.
End sec_3_3_S_den.
