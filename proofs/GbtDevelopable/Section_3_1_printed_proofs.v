(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_3_1_printed Section_3_1_proofs.
Open Scope R_scope.

Module sec_3_1_space.
Import GbtDevelopable.Section_3_1_printed.sec_3_1_space.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met. Qed.
End sec_3_1_space.

Module eq_3_2.
Import GbtDevelopable.Section_3_1_printed.eq_3_2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_2.met. Qed.
End eq_3_2.

Module eq_3_3.
Import GbtDevelopable.Section_3_1_printed.eq_3_3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_3.met. Qed.
End eq_3_3.

Module eq_3_4.
Import GbtDevelopable.Section_3_1_printed.eq_3_4.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_4.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_3_1_proofs.eq_3_4.met. Qed.
End eq_3_4.
