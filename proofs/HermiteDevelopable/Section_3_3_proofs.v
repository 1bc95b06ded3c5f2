(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From HermiteDevelopable Require Section_3_3.
Open Scope R_scope.

Module eq_3_7_det.
Import HermiteDevelopable.Section_3_3.eq_3_7_det.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A37]; identity. Qed.
End eq_3_7_det.
