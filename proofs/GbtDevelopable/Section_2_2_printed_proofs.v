(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_2_2_printed Section_2_2_proofs.
Open Scope R_scope.

Module def_2_dim_one_letter.
Import GbtDevelopable.Section_2_2_printed.def_2_dim_one_letter.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.def_2_dim_one_letter.refuted. Qed.
End def_2_dim_one_letter.

Module def_2_dim_two_letters.
Import GbtDevelopable.Section_2_2_printed.def_2_dim_two_letters.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.met. Qed.
End def_2_dim_two_letters.

Module sec_2_2_endpoints.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_endpoints.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.met. Qed.
End sec_2_2_endpoints.

Module sec_2_2_convexity.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_convexity.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.met. Qed.
End sec_2_2_convexity.

Module sec_2_2_symmetry.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.met. Qed.
End sec_2_2_symmetry.

Module sec_2_2_symmetry_exchange.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry_exchange.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.met. Qed.
End sec_2_2_symmetry_exchange.

Module sec_2_2_vd_quadratic.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_vd_quadratic.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.met. Qed.
End sec_2_2_vd_quadratic.

Module sec_2_2_vd_operator.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_vd_operator.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.met. Qed.
End sec_2_2_vd_operator.

Module sec_2_2_geominv.
Import GbtDevelopable.Section_2_2_printed.sec_2_2_geominv.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.met. Qed.
End sec_2_2_geominv.
