(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_End.
Import Bezier.Part_End.Definitions.
Open Scope R_scope.

Module curve_ends.
Import Bezier.Part_End.curve_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_ends.

Module curve_d1.
Import Bezier.Part_End.curve_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_d1.

Module curve_d2.
Import Bezier.Part_End.curve_d2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_d2.

Module curve_d2_slip.
Import Bezier.Part_End.curve_d2_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B C_] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0)). Qed.
End curve_d2_slip.

Module curve_d2_slip_corrected.
Import Bezier.Part_End.curve_d2_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_d2_slip_corrected.

Module curve_d3.
Import Bezier.Part_End.curve_d3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_d3.

Module trigonometric_d1.
Import Bezier.Part_End.trigonometric_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T F]; first [(exists (fun _ => 2), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1) / 2), ((-1) / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1)), ((-1)); met) | (exists (fun _ => 1), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1)), ((-1)); met)]. Qed.
End trigonometric_d1.

Module trigonometric_d1_slip.
Import Bezier.Part_End.trigonometric_d1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (1) ((-1) / 2)). Qed.
End trigonometric_d1_slip.

Module trigonometric_d1_slip_corrected.
Import Bezier.Part_End.trigonometric_d1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T F]; first [(exists (fun _ => 2), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1) / 2), ((-1) / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1)), ((-1)); met) | (exists (fun _ => 1), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1)), ((-1)); met)]. Qed.
End trigonometric_d1_slip_corrected.

Module trigonometric_d2.
Import Bezier.Part_End.trigonometric_d2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T F]; first [(exists (fun _ => 2), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1) / 2), ((-1) / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1)), ((-1)); met) | (exists (fun _ => 1), ((-1)), ((-1)); met) | (exists (fun _ => 0), ((-1)), ((-1)); met)]. Qed.
End trigonometric_d2.
