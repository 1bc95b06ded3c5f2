(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_2_3_printed Section_2_3_proofs.
Open Scope R_scope.

Module eq_7.
Import GbtSurfaces.Section_2_3_printed.eq_7.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.eq_7.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.eq_7.met. Qed.
End eq_7.

Module sec_2_3_features_a.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_features_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.met. Qed.
End sec_2_3_features_a.

Module sec_2_3_features_b.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_features_b.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.met. Qed.
End sec_2_3_features_b.

Module sec_2_3_features_c.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_features_c.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.met. Qed.
End sec_2_3_features_c.

Module sec_2_3_features_d.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_features_d.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.met. Qed.
End sec_2_3_features_d.

Module sec_2_3_classical_the_features_of_Sect__2_2.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_classical_the_features_of_Sect__2_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met. Qed.
End sec_2_3_classical_the_features_of_Sect__2_2.

Module sec_2_3_classical_every_property.
Import GbtSurfaces.Section_2_3_printed.sec_2_3_classical_every_property.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted. Qed.
End sec_2_3_classical_every_property.
