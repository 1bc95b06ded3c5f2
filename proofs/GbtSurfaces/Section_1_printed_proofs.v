(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_1_printed Section_1_proofs.
Open Scope R_scope.

Module sec_1_contrib_1.
Import GbtSurfaces.Section_1_printed.sec_1_contrib_1.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_1.met. Qed.
End sec_1_contrib_1.

Module sec_1_contrib_2.
Import GbtSurfaces.Section_1_printed.sec_1_contrib_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_2.met. Qed.
End sec_1_contrib_2.

Module sec_1_contrib_3_by_the_printed_conditions.
Import GbtSurfaces.Section_1_printed.sec_1_contrib_3_by_the_printed_conditions.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted. Qed.
End sec_1_contrib_3_by_the_printed_conditions.

Module sec_1_contrib_3_there_are_such_compositions.
Import GbtSurfaces.Section_1_printed.sec_1_contrib_3_there_are_such_compositions.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met. Qed.
End sec_1_contrib_3_there_are_such_compositions.
