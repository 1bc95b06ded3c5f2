(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtSurfaces Require Section_2_2.
Open Scope R_scope.

Module def_2_points_one_letter.
Import GbtSurfaces.Section_2_2.def_2_points_one_letter.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((4))%Z). Qed.
End def_2_points_one_letter.

Module def_2_points_two_letters.
Import GbtSurfaces.Section_2_2.def_2_points_two_letters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_2_points_two_letters.

Module sec_2_2_symmetry_as_for_B_zier_curves.
Import GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (0) (1/2)). Qed.
End sec_2_2_symmetry_as_for_B_zier_curves.

Module sec_2_2_interpolation.
Import GbtSurfaces.Section_2_2.sec_2_2_interpolation.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_interpolation.

Module thm_2_1.
Import GbtSurfaces.Section_2_2.thm_2_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_1.

Module eq_4_Q11.
Import GbtSurfaces.Section_2_2.eq_4_Q11.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_4_Q11.

Module eq_5_Q12.
Import GbtSurfaces.Section_2_2.eq_5_Q12.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a3] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (2*(16 + 3*PI)/(8 + PI)) else 0) (1) (1) (1) (0)). Qed.
End eq_5_Q12.

Module eq_5_Q12_corrected.
Import GbtSurfaces.Section_2_2.eq_5_Q12_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); unknown (Q1 2%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_Q12_corrected.

Module eq_5_Q12_true.
Import GbtSurfaces.Section_2_2.eq_5_Q12_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a a3_true join2 join12]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); unknown (Q1 2%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a a3_true join2 join12]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_Q12_true.

Module eq_6_Q11.
Import GbtSurfaces.Section_2_2.eq_6_Q11.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F1 F F1_ F_ a]; prepared; unknown (Q1 0%Z); unknown (Q1 1%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F1 F F1_ F_ a]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_6_Q11.

Module thm_2_c1.
Import GbtSurfaces.Section_2_2.thm_2_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b1]; first [(exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_2_c1.
