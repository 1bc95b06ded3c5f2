(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From HermiteDevelopable Require Part_Abstract_printed Part_Abstract_proofs.
Open Scope R_scope.

Module abs_construct_a.
Import HermiteDevelopable.Part_Abstract_printed.abs_construct_a.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.met. Qed.
End abs_construct_a.

Module abs_construct_b.
Import HermiteDevelopable.Part_Abstract_printed.abs_construct_b.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.met. Qed.
End abs_construct_b.

Module abs_construct_c.
Import HermiteDevelopable.Part_Abstract_printed.abs_construct_c.
Theorem proved : statement.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.proved. Qed.
Theorem met : instance.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.met. Qed.
End abs_construct_c.

Module abs_construct_d.
Import HermiteDevelopable.Part_Abstract_printed.abs_construct_d.
Theorem refuted : ~ statement.
Proof. follows HermiteDevelopable.Part_Abstract_proofs.abs_construct_d.refuted. Qed.
End abs_construct_d.
