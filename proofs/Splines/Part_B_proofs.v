(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_B.
Open Scope R_scope.

Module uniform_bezier.
Import Splines.Part_B.uniform_bezier.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F F_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F F_]; first [(exists (fun _ => 2); met) | (exists (fun _ => 0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z); met) | (exists (fun _ => 1); met) | (exists (fun _ => 0); met)]. Qed.
End uniform_bezier.
