(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_4_printed Section_4_proofs.
Open Scope R_scope.

Module sec_4_midpoints.
Import GbtDevelopable.Section_4_printed.sec_4_midpoints.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_proofs.sec_4_midpoints.met. Qed.
End sec_4_midpoints.

Module ex_4_2_distance.
Import GbtDevelopable.Section_4_printed.ex_4_2_distance.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_proofs.ex_4_2_distance.met. Qed.
End ex_4_2_distance.

Module ex_4_2_coplanar.
Import GbtDevelopable.Section_4_printed.ex_4_2_coplanar.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met. Qed.
End ex_4_2_coplanar.
