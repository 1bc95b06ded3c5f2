(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From GbtSurfaces Require Section_3_1.
Open Scope R_scope.

Module eq_10.
Import GbtSurfaces.Section_3_1.eq_10.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End eq_10.

Module eq_10_bernstein.
Import GbtSurfaces.Section_3_1.eq_10_bernstein.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (2)%Z, (fun _ => 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (1 / 3); met)]. Qed.
End eq_10_bernstein.

Module eq_10_extending.
Import GbtSurfaces.Section_3_1.eq_10_extending.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement b]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance b]; first [(exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End eq_10_extending.

Module eq_11.
Import GbtSurfaces.Section_3_1.eq_11.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f T net printed_] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (1) (1) (1) (1) (1/2) (1/2)). Qed.
End eq_11.

Module eq_11_points.
Import GbtSurfaces.Section_3_1.eq_11_points.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f b] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (2) (1) (1) (1/2) (1)). Qed.
End eq_11_points.

Module eq_12_1.
Import GbtSurfaces.Section_3_1.eq_12_1.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f F] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (2) (1) (1) (1/2) (1)). Qed.
End eq_12_1.

Module sec_3_1_any_shape_literal.
Import GbtSurfaces.Section_3_1.sec_3_1_any_shape_literal.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement net f b tensor] in no; refuting (no (2)%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) 0 (1) (1) ((-1) / 3) ((-1) / 3)). Qed.
End sec_3_1_any_shape_literal.

Module ex_3_1_points.
Import GbtSurfaces.Section_3_1.ex_3_1_points.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement V31 alpha31]; ordered. Qed.
End ex_3_1_points.

Module ex_3_1_net.
Import GbtSurfaces.Section_3_1.ex_3_1_net.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement alpha31 V31]; identity. Qed.
End ex_3_1_net.

Module ex_3_1_mesh_count.
Import GbtSurfaces.Section_3_1.ex_3_1_mesh_count.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End ex_3_1_mesh_count.
