(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Rates.
Open Scope R_scope.

Module fn_rate.
Import Hyperbolic.Part_Rates.fn_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (2); met) | (exists (0); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End fn_rate.

Module fn_growth.
Import Hyperbolic.Part_Rates.fn_growth.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_growth.

Module fn_bell.
Import Hyperbolic.Part_Rates.fn_bell.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_bell.

Module fn_damped.
Import Hyperbolic.Part_Rates.fn_damped.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_damped.

Module fn_damped_slip.
Import Hyperbolic.Part_Rates.fn_damped_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (0)). Qed.
End fn_damped_slip.

Module fn_damped_slip_corrected.
Import Hyperbolic.Part_Rates.fn_damped_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End fn_damped_slip_corrected.
