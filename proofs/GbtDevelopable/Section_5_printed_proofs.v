(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_printed Section_5_proofs.
Open Scope R_scope.

Module eq_5_1.
Import GbtDevelopable.Section_5_printed.eq_5_1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_proofs.eq_5_1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_proofs.eq_5_1.met. Qed.
End eq_5_1.

Module sec_5_weighted_a.
Import GbtDevelopable.Section_5_printed.sec_5_weighted_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_proofs.sec_5_weighted_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_proofs.sec_5_weighted_a.met. Qed.
End sec_5_weighted_a.

Module sec_5_weighted_b_four_coordinates.
Import GbtDevelopable.Section_5_printed.sec_5_weighted_b_four_coordinates.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.met. Qed.
End sec_5_weighted_b_four_coordinates.

Module sec_5_weighted_b_after_division.
Import GbtDevelopable.Section_5_printed.sec_5_weighted_b_after_division.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_proofs.sec_5_weighted_b_after_division.refuted. Qed.
End sec_5_weighted_b_after_division.

Module eq_5_2.
Import GbtDevelopable.Section_5_printed.eq_5_2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_proofs.eq_5_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_proofs.eq_5_2.met. Qed.
End eq_5_2.
