(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_1.
Import GbtDevelopable.Section_3_1.Definitions.
Open Scope R_scope.

Module sec_3_1_space.
Import GbtDevelopable.Section_3_1.sec_3_1_space.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal direction moment foot midpoint]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal direction moment foot midpoint]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1), (1); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1), (1); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7), (2); met) | (exists 4, 13, 8, 8, 13, 8, 8, 6, (1), (1); met) | (exists 1, 0, 0, 0, 0, 1, 0, 0, (1), (1); met)]. Qed.
End sec_3_1_space.

Module eq_3_2.
Import GbtDevelopable.Section_3_1.eq_3_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_2.

Module eq_3_3.
Import GbtDevelopable.Section_3_1.eq_3_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_3.

Module eq_3_4.
Import GbtDevelopable.Section_3_1.eq_3_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_4.
