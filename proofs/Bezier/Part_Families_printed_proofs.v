(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Families_printed Part_Families_proofs.
Open Scope R_scope.

Module family_corner.
Import Bezier.Part_Families_printed.family_corner.
Theorem proved : statement.
Proof. follows Bezier.Part_Families_proofs.family_corner.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Families_proofs.family_corner.met. Qed.
End family_corner.

Module family_casteljau.
Import Bezier.Part_Families_printed.family_casteljau.
Theorem proved : statement.
Proof. follows Bezier.Part_Families_proofs.family_casteljau.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Families_proofs.family_casteljau.met. Qed.
End family_casteljau.

Module family_casteljau_slip.
Import Bezier.Part_Families_printed.family_casteljau_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Families_proofs.family_casteljau_slip.refuted. Qed.
End family_casteljau_slip.

Module family_weights.
Import Bezier.Part_Families_printed.family_weights.
Theorem proved : statement.
Proof. follows Bezier.Part_Families_proofs.family_weights.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Families_proofs.family_weights.met. Qed.
End family_weights.
