(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Parts.
Open Scope R_scope.

Module fn_half.
Import Hyperbolic.Part_Parts.fn_half.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_half.

Module fn_half_slip.
Import Hyperbolic.Part_Parts.fn_half_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1)). Qed.
End fn_half_slip.

Module fn_half_slip_corrected.
Import Hyperbolic.Part_Parts.fn_half_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_half_slip_corrected.

Module fn_third.
Import Hyperbolic.Part_Parts.fn_third.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_third.

Module fn_tangent.
Import Hyperbolic.Part_Parts.fn_tangent.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End fn_tangent.
