(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Powers_printed Part_Powers_proofs.
Open Scope R_scope.

Module power_next.
Import Bezier.Part_Powers_printed.power_next.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_next.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_next.met. Qed.
End power_next.

Module power_rate.
Import Bezier.Part_Powers_printed.power_rate.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_rate.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_rate.met. Qed.
End power_rate.

Module power_rate_slip.
Import Bezier.Part_Powers_printed.power_rate_slip.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Powers_proofs.power_rate_slip.refuted. Qed.
End power_rate_slip.

Module power_rate_slip_corrected.
Import Bezier.Part_Powers_printed.power_rate_slip_corrected.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_rate_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_rate_slip_corrected.met. Qed.
End power_rate_slip_corrected.

Module power_product.
Import Bezier.Part_Powers_printed.power_product.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_product.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_product.met. Qed.
End power_product.

Module power_ends.
Import Bezier.Part_Powers_printed.power_ends.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_ends.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_ends.met. Qed.
End power_ends.

Module power_binomial.
Import Bezier.Part_Powers_printed.power_binomial.
Theorem proved : statement.
Proof. follows Bezier.Part_Powers_proofs.power_binomial.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Powers_proofs.power_binomial.met. Qed.
End power_binomial.
