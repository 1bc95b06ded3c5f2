(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Splines Require Part_Partition.
Import Splines.Part_Partition.Definitions.
Open Scope R_scope.

Module uniform_unity.
Import Splines.Part_Partition.uniform_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement U]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance U]; first [(exists (1 / 3); met) | (exists (1 / 2); met) | (exists (1 / 3); met) | (exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End uniform_unity.

Module knots_unity_quadratic.
Import Splines.Part_Partition.knots_unity_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_unity_quadratic.

Module knots_unity_cubic.
Import Splines.Part_Partition.knots_unity_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_unity_cubic.

Module knots_unity_equal.
Import Splines.Part_Partition.knots_unity_equal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement N_]; apart; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance N_]; first [(exists (fun _ => 2), (3); met) | (exists (fun _ => 0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End knots_unity_equal.
