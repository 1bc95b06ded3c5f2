(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_2_2.
Import GbtDevelopable.Section_2_2.Definitions.
Open Scope R_scope.

Module eq_2_2.
Import GbtDevelopable.Section_2_2.eq_2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_2.

Module def_2_dim_one_letter.
Import GbtDevelopable.Section_2_2.def_2_dim_one_letter.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((4))%Z). Qed.
End def_2_dim_one_letter.

Module def_2_dim_two_letters.
Import GbtDevelopable.Section_2_2.def_2_dim_two_letters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_2_dim_two_letters.

Module sec_2_2_endpoints.
Import GbtDevelopable.Section_2_2.sec_2_2_endpoints.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_endpoints.

Module sec_2_2_convexity.
Import GbtDevelopable.Section_2_2.sec_2_2_convexity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_convexity.

Module sec_2_2_symmetry.
Import GbtDevelopable.Section_2_2.sec_2_2_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry.

Module sec_2_2_symmetry_exchange.
Import GbtDevelopable.Section_2_2.sec_2_2_symmetry_exchange.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry_exchange.

Module sec_2_2_vd_operator.
Import GbtDevelopable.Section_2_2.sec_2_2_vd_operator.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G b F first second]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G b F first second]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_vd_operator.

Module sec_2_2_geominv.
Import GbtDevelopable.Section_2_2.sec_2_2_geominv.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g M G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g M G]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), 6, 7, 8, 9, 10, 11, 12, 13, 14, ((-1) / 3), ((-1) / 3), 17, 18, 19, (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), 0, 0, 0, (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), 8, 7, 9, 7, 7, 2, 11, 1, 4, ((-1) / 3), ((-1) / 3), 8, 6, 8, (1 / 3); met) | (exists (2)%Z, (fun _ => 6), (fun _ => 8), (fun _ => 7), 8, 7, 9, 8, 7, 9, 8, 7, 9, ((-1) / 3), ((-1) / 3), 7, 2, 11, (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), 0, 1, 0, 0, 0, 1, 1, 0, 0, ((-1) / 3), ((-1) / 3), 0, 1, 0, (1 / 3); met)]. Qed.
End sec_2_2_geominv.
