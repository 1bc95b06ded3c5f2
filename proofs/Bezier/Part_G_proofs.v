(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_G.
Open Scope R_scope.

Module join_G2.
Import Bezier.Part_G.join_G2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); unknown (R_ 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__ d1 d2]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (1), (7); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (1), (1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (1); met)]. Qed.
End join_G2.
