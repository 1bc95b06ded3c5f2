(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_4_2_printed Section_4_2_proofs.
Open Scope R_scope.

Module sec_4_2_Q0.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_Q0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.met. Qed.
End sec_4_2_Q0.

Module sec_4_2_Q1.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_Q1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.met. Qed.
End sec_4_2_Q1.

Module sec_4_2_Q1_lengths.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_Q1_lengths.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1_lengths.proved. Qed.
End sec_4_2_Q1_lengths.

Module sec_4_2_Q2.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_Q2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.met. Qed.
End sec_4_2_Q2.

Module sec_4_2_Q3.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_Q3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.met. Qed.
End sec_4_2_Q3.

Module sec_4_2_quadrants.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_quadrants.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.met. Qed.
End sec_4_2_quadrants.

Module sec_4_2_distances.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_distances.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.met. Qed.
End sec_4_2_distances.

Module sec_4_2_class.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_class.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_class.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_class.met. Qed.
End sec_4_2_class.

Module sec_4_2_class_ends.
Import GbtDevelopable.Section_4_2_printed.sec_4_2_class_ends.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.met. Qed.
End sec_4_2_class_ends.
