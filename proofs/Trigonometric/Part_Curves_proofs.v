(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Curves.
Import Trigonometric.Part_Curves.Definitions.
Open Scope R_scope.

Module quadratic_ends.
Import Trigonometric.Part_Curves.quadratic_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b F a_ c_ b_ F_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b F a_ c_ b_ F_]; first [(exists (fun _ => 2), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End quadratic_ends.

Module quadratic_d1.
Import Trigonometric.Part_Curves.quadratic_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b F]; first [(exists (fun _ => 2), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End quadratic_d1.

Module quadratic_d2.
Import Trigonometric.Part_Curves.quadratic_d2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b F]; first [(exists (fun _ => 2), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End quadratic_d2.

Module quadratic_d1_slip.
Import Trigonometric.Part_Curves.quadratic_d1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a c b F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (1) (0)). Qed.
End quadratic_d1_slip.

Module quadratic_d1_slip_corrected.
Import Trigonometric.Part_Curves.quadratic_d1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b F]; first [(exists (fun _ => 2), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End quadratic_d1_slip_corrected.
