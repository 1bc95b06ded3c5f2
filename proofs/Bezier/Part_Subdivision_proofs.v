(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Subdivision.
Open Scope R_scope.

Module curve_midpoint.
Import Bezier.Part_Subdivision.curve_midpoint.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B K]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B K]; first [(exists (3)%Z, (fun _ => 3); met) | (exists (3)%Z, (fun _ => 0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z); met) | (exists (3)%Z, (fun _ => 1); met) | (exists (3)%Z, (fun _ => 0); met)]. Qed.
End curve_midpoint.
