(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Hyperbolas.
Import Hyperbolic.Part_Hyperbolas.Definitions.
Open Scope R_scope.

Module curve_hyperbola.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h E_]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End curve_hyperbola.

Module curve_hyperbola_implicit.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h E_]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End curve_hyperbola_implicit.

Module curve_hyperbola_tangent.
Import Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h E_]; first [(exists (1); met) | (exists (1); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End curve_hyperbola_tangent.
