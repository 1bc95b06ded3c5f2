(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Part_Table_printed Part_Table_proofs.
Open Scope R_scope.

Module tab_1_1_proposed.
Import GbtSurfaces.Part_Table_printed.tab_1_1_proposed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.met. Qed.
End tab_1_1_proposed.

Module tab_1_2_proposed.
Import GbtSurfaces.Part_Table_printed.tab_1_2_proposed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.met. Qed.
End tab_1_2_proposed.

Module tab_1_3_proposed.
Import GbtSurfaces.Part_Table_printed.tab_1_3_proposed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.met. Qed.
End tab_1_3_proposed.

Module tab_1_4_proposed.
Import GbtSurfaces.Part_Table_printed.tab_1_4_proposed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.met. Qed.
End tab_1_4_proposed.

Module tab_1_5_proposed.
Import GbtSurfaces.Part_Table_printed.tab_1_5_proposed.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.met. Qed.
End tab_1_5_proposed.
