(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_5.
Import GbtDevelopable.Section_5.Definitions.
Open Scope R_scope.

Module eq_5_1.
Import GbtDevelopable.Section_5.eq_5_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g hat]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g hat]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (fun _ => 8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (1 / 3); met) | (exists (2)%Z, (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End eq_5_1.

Module sec_5_weighted_a.
Import GbtDevelopable.Section_5.sec_5_weighted_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g rational]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g rational]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (fun _ => 7); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (fun _ => 1); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0); met)]. Qed.
End sec_5_weighted_a.

Module sec_5_weighted_b_four_coordinates.
Import GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g hat hat_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g hat hat_]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (fun _ => 8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (1 / 3); met) | (exists (2)%Z, (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End sec_5_weighted_b_four_coordinates.

Module eq_5_2.
Import GbtDevelopable.Section_5.eq_5_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1 H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1 H2]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (fun _ => 8), (fun _ => 9), (fun _ => 10), (fun _ => 11), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 2 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 11 * i0 + 2)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_5_2.
