(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Half.
Import Trigonometric.Part_Half.Definitions.
Open Scope R_scope.

Module angle_half_sine.
Import Trigonometric.Part_Half.angle_half_sine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End angle_half_sine.

Module angle_half_cosine.
Import Trigonometric.Part_Half.angle_half_cosine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End angle_half_cosine.

Module angle_half_slip.
Import Trigonometric.Part_Half.angle_half_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (1/3*PI)). Qed.
End angle_half_slip.

Module angle_half_slip_corrected.
Import Trigonometric.Part_Half.angle_half_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End angle_half_slip_corrected.

Module half_unity.
Import Trigonometric.Part_Half.half_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End half_unity.

Module half_middle.
Import Trigonometric.Part_Half.half_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End half_middle.

Module half_sine.
Import Trigonometric.Part_Half.half_sine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End half_sine.

Module half_cosine.
Import Trigonometric.Part_Half.half_cosine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((1 / 3) * PI); met) | (exists ((1 / 2) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met) | (exists ((1 / 3) * PI); met)]. Qed.
End half_cosine.

Module half_cosine_slip.
Import Trigonometric.Part_Half.half_cosine_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no (PI)). Qed.
End half_cosine_slip.

Module half_powers.
Import Trigonometric.Part_Half.half_powers.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E_]; first [(exists (fun _ => 2), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 2) * PI); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((1 / 3) * PI); met) | (exists (fun _ => 1), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 3) * PI); met)]. Qed.
End half_powers.

Module half_d1.
Import Trigonometric.Part_Half.half_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E_]; first [(exists (fun _ => 2), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 2) * PI); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((1 / 3) * PI); met) | (exists (fun _ => 1), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 3) * PI); met)]. Qed.
End half_d1.

Module half_d1_slip.
Import Trigonometric.Part_Half.half_d1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement E_] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1/3*PI)). Qed.
End half_d1_slip.

Module half_d1_slip_corrected.
Import Trigonometric.Part_Half.half_d1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E_]; first [(exists (fun _ => 2), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 2) * PI); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((1 / 3) * PI); met) | (exists (fun _ => 1), ((1 / 3) * PI); met) | (exists (fun _ => 0), ((1 / 3) * PI); met)]. Qed.
End half_d1_slip_corrected.
