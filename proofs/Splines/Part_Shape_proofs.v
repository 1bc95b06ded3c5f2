(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Shape.
Open Scope R_scope.

Module uniform_line.
Import Splines.Part_Shape.uniform_line.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U F]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U F]; first [(exists (fun _ => 2), (1 / 3); met) | (exists (fun _ => 0), (1 / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (1 / 3); met) | (exists (fun _ => 1), (1 / 3); met) | (exists (fun _ => 0), (1 / 3); met)]. Qed.
End uniform_line.
