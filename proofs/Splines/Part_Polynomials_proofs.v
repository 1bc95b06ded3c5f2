(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Polynomials.
Import Splines.Part_Polynomials.Definitions.
Open Scope R_scope.

Module uniform_greville.
Import Splines.Part_Polynomials.uniform_greville.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_greville.

Module uniform_marsden.
Import Splines.Part_Polynomials.uniform_marsden.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_marsden.

Module uniform_marsden_slip.
Import Splines.Part_Polynomials.uniform_marsden_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U] in no; refuting (no (1)). Qed.
End uniform_marsden_slip.

Module knots_greville.
Import Splines.Part_Polynomials.knots_greville.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_greville.

Module knots_marsden.
Import Splines.Part_Polynomials.knots_marsden.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3), (4); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8), (8); met) | (exists (fun _ => 1), (1), (1); met) | (exists (fun _ => 0), (1), (0); met)]. Qed.
End knots_marsden.

Module knots_marsden_cubic.
Import Splines.Part_Polynomials.knots_marsden_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3), (4); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8), (8); met) | (exists (fun _ => 1), (1), (1); met) | (exists (fun _ => 0), (1), (0); met)]. Qed.
End knots_marsden_cubic.
