(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Derivatives.
Import Splines.Part_Derivatives.Definitions.
Open Scope R_scope.

Module uniform_rate.
Import Splines.Part_Derivatives.uniform_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_rate.

Module knots_rate.
Import Splines.Part_Derivatives.knots_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_rate.

Module knots_rate_slip.
Import Splines.Part_Derivatives.knots_rate_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement N_] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else if (Z.eqb i0 (3))%bool then (2) else if (Z.eqb i0 (4))%bool then (3) else 0) (1)). Qed.
End knots_rate_slip.

Module knots_rate_slip_corrected.
Import Splines.Part_Derivatives.knots_rate_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_rate_slip_corrected.
