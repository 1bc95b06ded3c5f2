(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
From Torses Require Part_Curves.
Open Scope R_scope.

Module curve_chain.
Import Torses.Part_Curves.curve_chain.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End curve_chain.

Module curve_chain_slip.
Import Torses.Part_Curves.curve_chain_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1) (0) (0) (0) (1) (0) 0 0 0 (1) (2) (0) (0)). Qed.
End curve_chain_slip.
