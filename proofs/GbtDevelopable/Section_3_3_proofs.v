(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_3_3.
Import GbtDevelopable.Section_3_3.Definitions.
Open Scope R_scope.

Module eq_3_8.
Import GbtDevelopable.Section_3_3.eq_3_8.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_8.

Module eq_3_9.
Import GbtDevelopable.Section_3_3.eq_3_9.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; parts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_9.

Module sec_3_3_S_vec.
Import GbtDevelopable.Section_3_3.sec_3_3_S_vec.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a' a'' system cramer1 cramer2 cramer3 S_] in no; refuting (no (1) (1) (1) (1) (1) (2) (1) (2) (1) (1) (1) (1)). Qed.
End sec_3_3_S_vec.

Module sec_3_3_S_vec_corrected.
Import GbtDevelopable.Section_3_3.sec_3_3_S_vec_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' system cramer1 cramer2 cramer3 S_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' system cramer1 cramer2 cramer3 S_]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12), (13); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11), (1); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_3_S_vec_corrected.

Module sec_3_3_S_x.
Import GbtDevelopable.Section_3_3.sec_3_3_S_x.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer1]; identity. Qed.
End sec_3_3_S_x.

Module sec_3_3_S_y.
Import GbtDevelopable.Section_3_3.sec_3_3_S_y.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer2]; identity. Qed.
End sec_3_3_S_y.

Module sec_3_3_S_z.
Import GbtDevelopable.Section_3_3.sec_3_3_S_z.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer3]; identity. Qed.
End sec_3_3_S_z.

Module sec_3_3_S_den.
Import GbtDevelopable.Section_3_3.sec_3_3_S_den.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' system]; identity. Qed.
End sec_3_3_S_den.
