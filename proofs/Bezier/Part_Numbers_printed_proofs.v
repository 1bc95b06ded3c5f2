(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Numbers_printed Part_Numbers_proofs.
Open Scope R_scope.

Module exists_quotient_any.
Import Bezier.Part_Numbers_printed.exists_quotient_any.
Theorem proved : statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_quotient_any.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Numbers_proofs.exists_quotient_any.met. Qed.
End exists_quotient_any.

Module exists_above.
Import Bezier.Part_Numbers_printed.exists_above.
Theorem proved : statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_above.proved. Qed.
End exists_above.

Module exists_root.
Import Bezier.Part_Numbers_printed.exists_root.
Theorem proved : statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_root.proved. Qed.
End exists_root.

Module exists_none.
Import Bezier.Part_Numbers_printed.exists_none.
Theorem refuted : ~ statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_none.refuted. Qed.
End exists_none.

Module exists_parallel.
Import Bezier.Part_Numbers_printed.exists_parallel.
Theorem proved : statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_parallel.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Numbers_proofs.exists_parallel.met. Qed.
End exists_parallel.

Module exists_parallel_only.
Import Bezier.Part_Numbers_printed.exists_parallel_only.
Theorem proved : statement.
Proof. follows Bezier.Part_Numbers_proofs.exists_parallel_only.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Numbers_proofs.exists_parallel_only.met. Qed.
End exists_parallel_only.
