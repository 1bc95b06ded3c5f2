(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtDevelopable Require Section_3_4.
Import GbtDevelopable.Section_3_4.Definitions.
Open Scope R_scope.

Module eq_3_11_a.
Import GbtDevelopable.Section_3_4.eq_3_11_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_a.

Module eq_3_11_b.
Import GbtDevelopable.Section_3_4.eq_3_11_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_b.

Module eq_3_11_c.
Import GbtDevelopable.Section_3_4.eq_3_11_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_c.

Module eq_3_12_a.
Import GbtDevelopable.Section_3_4.eq_3_12_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_a.

Module eq_3_12_b.
Import GbtDevelopable.Section_3_4.eq_3_12_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_b.

Module eq_3_12_c.
Import GbtDevelopable.Section_3_4.eq_3_12_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_c.

Module eq_3_13.
Import GbtDevelopable.Section_3_4.eq_3_13.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal W]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal W]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_13.

Module sec_3_4_J0.
Import GbtDevelopable.Section_3_4.sec_3_4_J0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J0.

Module sec_3_4_dual.
Import GbtDevelopable.Section_3_4.sec_3_4_dual.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_dual.

Module sec_3_4_J1.
Import GbtDevelopable.Section_3_4.sec_3_4_J1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J1.

Module sec_3_4_k1.
Import GbtDevelopable.Section_3_4.sec_3_4_k1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k1]; first [(exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, (0); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met)]. Qed.
End sec_3_4_k1.

Module sec_3_4_k2.
Import GbtDevelopable.Section_3_4.sec_3_4_k2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2]; first [(exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, (0); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3); met)]. Qed.
End sec_3_4_k2.

Module sec_3_4_m0_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r1.

Module sec_3_4_m0_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r2.

Module sec_3_4_m0_r3_c1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_ start]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_ start]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r3_c1.

Module sec_3_4_m0_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H H_ start k1] in no; refuting (no ((2))%Z (fun i0 => 0) (1) (0)). Qed.
End sec_3_4_m0_r3_c2.

Module sec_3_4_m0_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k1 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r3_true.

Module sec_3_4_m0_r3_c3.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H H_ start k1] in no; refuting (no ((2))%Z (fun i0 => 0) (1) (0)). Qed.
End sec_3_4_m0_r3_c3.

Module sec_3_4_m1_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r1.

Module sec_3_4_m1_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r2.

Module sec_3_4_m1_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H H_ end_ k2] in no; refuting (no ((2))%Z (fun i0 => 0) (0) (1)). Qed.
End sec_3_4_m1_r3_c2.

Module sec_3_4_m1_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r3_true.

Module sec_3_4_S0_gen.
Import GbtDevelopable.Section_3_4.sec_3_4_S0_gen.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal kappa HT_ meet S0]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal kappa HT_ meet S0]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_S0_gen.
