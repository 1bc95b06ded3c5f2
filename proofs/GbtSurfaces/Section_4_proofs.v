(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_4.
Import GbtSurfaces.Section_4.Definitions.
Open Scope R_scope.

Module abs_features_the_features_of_Sect__2_2.
Import GbtSurfaces.Section_4.abs_features_the_features_of_Sect__2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; intros; conjuncts; first [ intro no; first [ refuting (no (0)%Z (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (0)%Z (2)%Z (fun _ => 4) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (0)%Z, (2)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_features_the_features_of_Sect__2_2.

Module abs_features_every_feature.
Import GbtSurfaces.Section_4.abs_features_every_feature.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement b f] in no; refuting (no ((2))%Z (1) (1) (1/3)). Qed.
End abs_features_every_feature.

Module sec_4_six_tensor_with_rotation_surfaces.
Import GbtSurfaces.Section_4.sec_4_six_tensor_with_rotation_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f blend cosine blend_ cosine_] in no; refuting (no (1) (1) (-1) (-1) (1) (1) (1/3)). Qed.
End sec_4_six_tensor_with_rotation_surfaces.

Module sec_4_six_tensor_without.
Import GbtSurfaces.Section_4.sec_4_six_tensor_without.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b printed18 tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f b printed18 tensor]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), 8, (fun _ => 9), (fun _ => 10), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), 9, (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 2 * i0 + 7)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (fun _ => 1), 1, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_4_six_tensor_without.

Module sec_4_composite_by_the_printed_conditions.
Import GbtSurfaces.Section_4.sec_4_composite_by_the_printed_conditions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 1 (-1) (-1) 0). Qed.
End sec_4_composite_by_the_printed_conditions.

Module sec_4_composite_there_are_such_compositions.
Import GbtSurfaces.Section_4.sec_4_composite_there_are_such_compositions.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next F next_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next F next_ F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_4_composite_there_are_such_compositions.

Module sec_4_tensor.
Import GbtSurfaces.Section_4.sec_4_tensor.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b f printed18 tensor]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b f printed18 tensor]; first [(exists (3)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_4_tensor.

Module sec_4_convex_hull.
Import GbtSurfaces.Section_4.sec_4_convex_hull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b]; ordered. Qed.
End sec_4_convex_hull.
