(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Helicoid.
Import Trigonometric.Part_Helicoid.Definitions.
Open Scope R_scope.

Module helicoid_skew.
Import Trigonometric.Part_Helicoid.helicoid_skew.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X N_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance X N_]; first [(exists (1), (1), (4); met) | (exists (1), (1), (0); met) | (exists (13), (8), (8); met) | (exists (1), (1), (1); met) | (exists (1), (1), (1); met)]. Qed.
End helicoid_skew.

Module helicoid_skew_slip.
Import Trigonometric.Part_Helicoid.helicoid_skew_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X N_] in no; refuting (no (1) (1) (0)). Qed.
End helicoid_skew_slip.
