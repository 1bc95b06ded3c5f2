(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Part_Abstract_printed Part_Abstract_proofs.
Open Scope R_scope.

Module abs_conics_planes.
Import GbtDevelopable.Part_Abstract_printed.abs_conics_planes.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Part_Abstract_proofs.abs_conics_planes.refuted. Qed.
End abs_conics_planes.

Module abs_conics_points.
Import GbtDevelopable.Part_Abstract_printed.abs_conics_points.
Theorem proved : statement.
Proof. follows GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Part_Abstract_proofs.abs_conics_points.met. Qed.
End abs_conics_points.

Module abs_4d_factor.
Import GbtDevelopable.Part_Abstract_printed.abs_4d_factor.
Theorem proved : statement.
Proof. follows GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met. Qed.
End abs_4d_factor.
