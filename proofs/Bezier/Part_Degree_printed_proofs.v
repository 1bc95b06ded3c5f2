(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Bezier Require Part_Degree_printed Part_Degree_proofs.
Open Scope R_scope.

Module bernstein_elevation.
Import Bezier.Part_Degree_printed.bernstein_elevation.
Theorem proved : statement.
Proof. follows Bezier.Part_Degree_proofs.bernstein_elevation.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Degree_proofs.bernstein_elevation.met. Qed.
End bernstein_elevation.

Module curve_elevation.
Import Bezier.Part_Degree_printed.curve_elevation.
Theorem proved : statement.
Proof. follows Bezier.Part_Degree_proofs.curve_elevation.proved. Qed.
Theorem met : instance.
Proof. follows Bezier.Part_Degree_proofs.curve_elevation.met. Qed.
End curve_elevation.
