(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Symmetry.
Import Bezier.Part_Symmetry.Definitions.
Open Scope R_scope.

Module bernstein_symmetry.
Import Bezier.Part_Symmetry.bernstein_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 2); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met)]. Qed.
End bernstein_symmetry.

Module trigonometric_symmetry.
Import Bezier.Part_Symmetry.trigonometric_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (fun _ => 2), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 0), ((-1) / 2), ((-1) / 2), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 1), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 0), ((-1)), ((-1)), (1 / 3); met)]. Qed.
End trigonometric_symmetry.

Module trigonometric_symmetry_slip.
Import Bezier.Part_Symmetry.trigonometric_symmetry_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement T] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (1) (0) (1/2)). Qed.
End trigonometric_symmetry_slip.

Module trigonometric_symmetry_slip_corrected.
Import Bezier.Part_Symmetry.trigonometric_symmetry_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T]; first [(exists (fun _ => 2), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 0), ((-1) / 2), ((-1) / 2), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 1), ((-1)), ((-1)), (1 / 3); met) | (exists (fun _ => 0), ((-1)), ((-1)), (1 / 3); met)]. Qed.
End trigonometric_symmetry_slip_corrected.
