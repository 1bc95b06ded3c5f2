(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtSurfaces Require Section_4.
Open Scope R_scope.

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

Module sec_4_composite_by_the_printed_conditions.
Import GbtSurfaces.Section_4.sec_4_composite_by_the_printed_conditions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (-1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else if (Z.eqb i0 (2))%bool then ((32 + 7*PI)/(8 + PI)) else if (Z.eqb i0 (3))%bool then (0) else 0) (1) (1) (1) (0)). Qed.
End sec_4_composite_by_the_printed_conditions.

Module sec_4_tensor_with_f_l.
Import GbtSurfaces.Section_4.sec_4_tensor_with_f_l.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f ruled b tensor] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (1) (1) (1) (0) (1/2) (1)). Qed.
End sec_4_tensor_with_f_l.

Module sec_4_convex_hull.
Import GbtSurfaces.Section_4.sec_4_convex_hull.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f b]; ordered. Qed.
End sec_4_convex_hull.
