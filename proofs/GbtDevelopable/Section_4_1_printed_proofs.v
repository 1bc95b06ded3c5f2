(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_4_1_printed Section_4_1_proofs.
Open Scope R_scope.

Module ex_4_1_Q0.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_Q0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.met. Qed.
End ex_4_1_Q0.

Module ex_4_1_Q1.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_Q1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.met. Qed.
End ex_4_1_Q1.

Module ex_4_1_Q2.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_Q2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.met. Qed.
End ex_4_1_Q2.

Module ex_4_1_Q3.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_Q3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.met. Qed.
End ex_4_1_Q3.

Module ex_4_1_distance.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_distance.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.met. Qed.
End ex_4_1_distance.

Module ex_4_1_coplanar.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_coplanar.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.met. Qed.
End ex_4_1_coplanar.

Module ex_4_1_c1_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.met. Qed.
End ex_4_1_c1_a.

Module ex_4_1_lengths.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_lengths.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.met. Qed.
End ex_4_1_lengths.

Module ex_4_1_lengths_exchanged.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_lengths_exchanged.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.met. Qed.
End ex_4_1_lengths_exchanged.

Module ex_4_1_c1_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.met. Qed.
End ex_4_1_c1_b.

Module ex_4_1_c1_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_c.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_c.refuted. Qed.
End ex_4_1_c1_c.

Module ex_4_1_c1_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_d.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_d.refuted. Qed.
End ex_4_1_c1_d.

Module ex_4_1_c1_e.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_e.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_e.refuted. Qed.
End ex_4_1_c1_e.

Module ex_4_1_c1_f_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c1_f_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted. Qed.
End ex_4_1_c1_f_there_and_nowhere_else.

Module ex_4_1_c2_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c2_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.met. Qed.
End ex_4_1_c2_a.

Module ex_4_1_c2_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c2_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.met. Qed.
End ex_4_1_c2_b.

Module ex_4_1_c2_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c2_c.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_c.refuted. Qed.
End ex_4_1_c2_c.

Module ex_4_1_c2_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c2_d.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_d.refuted. Qed.
End ex_4_1_c2_d.

Module ex_4_1_c2_e_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c2_e_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted. Qed.
End ex_4_1_c2_e_there_and_nowhere_else.

Module ex_4_1_c3_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c3_a.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_a.refuted. Qed.
End ex_4_1_c3_a.

Module ex_4_1_c3_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c3_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.met. Qed.
End ex_4_1_c3_b.

Module ex_4_1_c3_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c3_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.met. Qed.
End ex_4_1_c3_c.

Module ex_4_1_c3_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_1_c3_d.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.met. Qed.
End ex_4_1_c3_d.

Module ex_4_2_Q0.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_Q0.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.met. Qed.
End ex_4_2_Q0.

Module ex_4_2_Q1.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_Q1.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.met. Qed.
End ex_4_2_Q1.

Module ex_4_2_Q2.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_Q2.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.met. Qed.
End ex_4_2_Q2.

Module ex_4_2_Q3.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_Q3.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.met. Qed.
End ex_4_2_Q3.

Module ex_4_2_class.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_class.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_class.refuted. Qed.
End ex_4_2_class.

Module ex_4_2_pencil.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_pencil.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.met. Qed.
End ex_4_2_pencil.

Module ex_4_2_lengths.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_lengths.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.met. Qed.
End ex_4_2_lengths.

Module ex_4_2_c1_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c1_a.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_a.refuted. Qed.
End ex_4_2_c1_a.

Module ex_4_2_c1_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c1_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.met. Qed.
End ex_4_2_c1_b.

Module ex_4_2_c1_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c1_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.met. Qed.
End ex_4_2_c1_c.

Module ex_4_2_c1_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c1_d.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_d.refuted. Qed.
End ex_4_2_c1_d.

Module ex_4_2_c1_e.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c1_e.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_e.refuted. Qed.
End ex_4_2_c1_e.

Module ex_4_2_c2_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c2_a.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_a.refuted. Qed.
End ex_4_2_c2_a.

Module ex_4_2_c2_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c2_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.met. Qed.
End ex_4_2_c2_b.

Module ex_4_2_c2_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c2_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.met. Qed.
End ex_4_2_c2_c.

Module ex_4_2_c2_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c2_d.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.met. Qed.
End ex_4_2_c2_d.

Module ex_4_2_c3_a.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c3_a.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.met. Qed.
End ex_4_2_c3_a.

Module ex_4_2_c3_b.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c3_b.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.met. Qed.
End ex_4_2_c3_b.

Module ex_4_2_c3_c.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c3_c.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.met. Qed.
End ex_4_2_c3_c.

Module ex_4_2_c3_d.
Import GbtDevelopable.Section_4_1_printed.ex_4_2_c3_d.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_d.refuted. Qed.
End ex_4_2_c3_d.
