(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_At.
Import Splines.Part_At.Definitions.
Open Scope R_scope.

Module uniform_C1.
Import Splines.Part_At.uniform_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U A B A_ B_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U A B A_ B_]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_C1.

Module uniform_C1_slip.
Import Splines.Part_At.uniform_C1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U A B] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0)). Qed.
End uniform_C1_slip.

Module uniform_C1_slip_corrected.
Import Splines.Part_At.uniform_C1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U A]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U A]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_C1_slip_corrected.

Module uniform_C2.
Import Splines.Part_At.uniform_C2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F G F_ G_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F G F_ G_]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_C2.

Module uniform_jump.
Import Splines.Part_At.uniform_jump.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U G F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U G F]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_jump.

Module uniform_knot.
Import Splines.Part_At.uniform_knot.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F F_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F F_]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_knot.

Module uniform_knot_slip.
Import Splines.Part_At.uniform_knot_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0)). Qed.
End uniform_knot_slip.

Module uniform_knot_slip_corrected.
Import Splines.Part_At.uniform_knot_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_knot_slip_corrected.

Module knots_C1.
Import Splines.Part_At.knots_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ F G]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_ F G]; first [(exists (fun _ => 2), (fun _ => 3); met) | (exists (fun _ => 0), (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (fun _ => 1), (fun _ => 1); met) | (exists (fun _ => 0), (fun _ => 0); met)]. Qed.
End knots_C1.

Module knots_C1_value.
Import Splines.Part_At.knots_C1_value.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_ F]; first [(exists (fun _ => 2), (fun _ => 3); met) | (exists (fun _ => 0), (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (fun _ => 1), (fun _ => 1); met) | (exists (fun _ => 0), (fun _ => 0); met)]. Qed.
End knots_C1_value.

Module knots_C1_value_slip.
Import Splines.Part_At.knots_C1_value_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement N_ F] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else if (Z.eqb i0 (3))%bool then (2) else if (Z.eqb i0 (4))%bool then (3) else 0)). Qed.
End knots_C1_value_slip.

Module knots_C1_value_slip_corrected.
Import Splines.Part_At.knots_C1_value_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_ F]; first [(exists (fun _ => 2), (fun _ => 3); met) | (exists (fun _ => 0), (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (fun _ => 1), (fun _ => 1); met) | (exists (fun _ => 0), (fun _ => 0); met)]. Qed.
End knots_C1_value_slip_corrected.

Module knots_C2.
Import Splines.Part_At.knots_C2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ C_ E_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_ C_ E_]; first [(exists (fun _ => 2), (fun _ => 3); met) | (exists (fun _ => 0), (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (fun _ => 1), (fun _ => 1); met) | (exists (fun _ => 0), (fun _ => 0); met)]. Qed.
End knots_C2.

Module knots_convex.
Import Splines.Part_At.knots_convex.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_ F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_ F]; first [(exists (fun _ => 2), (fun _ => 3); met) | (exists (fun _ => 0), (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (fun _ => 1), (fun _ => 1); met) | (exists (fun _ => 0), (fun _ => 0); met)]. Qed.
End knots_convex.
