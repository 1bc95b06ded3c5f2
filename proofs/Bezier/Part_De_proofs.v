(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_De.
Open Scope R_scope.

Module curve_casteljau.
Import Bezier.Part_De.curve_casteljau.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B C_]; first [(exists (3)%Z, (fun _ => 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (1 / 3); met)]. Qed.
End curve_casteljau.
