(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Two.
Import Splines.Part_Two.Definitions.
Open Scope R_scope.

Module uniform_two_scale_quadratic.
Import Splines.Part_Two.uniform_two_scale_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U A]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U A]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End uniform_two_scale_quadratic.

Module uniform_two_scale_cubic.
Import Splines.Part_Two.uniform_two_scale_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End uniform_two_scale_cubic.

Module uniform_two_scale_slip.
Import Splines.Part_Two.uniform_two_scale_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U A] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1)). Qed.
End uniform_two_scale_slip.

Module clamped_unity.
Import Splines.Part_Two.clamped_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (1 / 3), (3); met) | (exists (1 / 2), (0); met) | (exists (1 / 3), (8); met) | (exists (1 / 3), (1); met) | (exists (1 / 3), (1); met)]. Qed.
End clamped_unity.

Module clamped_ends.
Import Splines.Part_Two.clamped_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F G]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F G]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End clamped_ends.

Module clamped_tangents.
Import Splines.Part_Two.clamped_tangents.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F G]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F G]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End clamped_tangents.

Module clamped_tangents_slip.
Import Splines.Part_Two.clamped_tangents_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (1/2)). Qed.
End clamped_tangents_slip.

Module clamped_C1.
Import Splines.Part_Two.clamped_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F G]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F G]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End clamped_C1.

Module clamped_knot.
Import Splines.Part_Two.clamped_knot.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance F]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End clamped_knot.

Module clamped_C2.
Import Splines.Part_Two.clamped_C2.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement F G] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (1/2)). Qed.
End clamped_C2.
