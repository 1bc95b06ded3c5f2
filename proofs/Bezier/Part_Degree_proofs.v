(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Degree.
Import Bezier.Part_Degree.Definitions.
Open Scope R_scope.

Module bernstein_elevation.
Import Bezier.Part_Degree.bernstein_elevation.
Theorem proved : statement.
Proof. cbv delta [statement B]; intros; apply raised; assumption. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 2); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met) | (exists (0)%Z, (1)%Z, (1 / 3); met)]. Qed.
End bernstein_elevation.

Module curve_elevation.
Import Bezier.Part_Degree.curve_elevation.
Theorem proved : statement.
Proof. cbv delta [statement B C_]; intros; apply curve_raised; lia. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (1)%Z, (fun _ => 3), (1 / 3); met) | (exists (1)%Z, (fun _ => 0), (1 / 2); met) | (exists (1)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (1 / 3); met) | (exists (1)%Z, (fun _ => 1), (1 / 3); met) | (exists (1)%Z, (fun _ => 0), (1 / 3); met)]. Qed.
End curve_elevation.
