(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Part_Abstract_printed Part_Abstract_proofs.
Open Scope R_scope.

Module abs_basis_a.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_a.met. Qed.
End abs_basis_a.

Module abs_basis_b_name.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_b_name.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.met. Qed.
End abs_basis_b_name.

Module abs_basis_b_basis.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_b_basis.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_b_basis.refuted. Qed.
End abs_basis_b_basis.

Module abs_basis_order_2.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_order_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met. Qed.
End abs_basis_order_2.

Module abs_basis_cubic.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_cubic.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met. Qed.
End abs_basis_cubic.

Module abs_basis_all.
Import GbtSurfaces.Part_Abstract_printed.abs_basis_all.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_all.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_basis_all.met. Qed.
End abs_basis_all.

Module abs_continuity_a.
Import GbtSurfaces.Part_Abstract_printed.abs_continuity_a.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.met. Qed.
End abs_continuity_a.

Module abs_continuity_rows.
Import GbtSurfaces.Part_Abstract_printed.abs_continuity_rows.
Theorem proved : statement.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.met. Qed.
End abs_continuity_rows.
