(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Part_Abstract.
Import GbtSurfaces.Part_Abstract.Definitions.
Open Scope R_scope.

Module abs_basis_a.
Import GbtSurfaces.Part_Abstract.abs_basis_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_basis_a.

Module abs_basis_b_name.
Import GbtSurfaces.Part_Abstract.abs_basis_b_name.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (0), (0), (1 / 2); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_basis_b_name.

Module abs_basis_b_basis.
Import GbtSurfaces.Part_Abstract.abs_basis_b_basis.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no (-1) (-1) (1 / 2)). Qed.
End abs_basis_b_basis.

Module abs_basis_order_2.
Import GbtSurfaces.Part_Abstract.abs_basis_order_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_order_2.

Module abs_basis_cubic.
Import GbtSurfaces.Part_Abstract.abs_basis_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_cubic.

Module abs_basis_all.
Import GbtSurfaces.Part_Abstract.abs_basis_all.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F e A B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F e A B C_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_basis_all.

Module abs_continuity_a.
Import GbtSurfaces.Part_Abstract.abs_continuity_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_continuity_a.

Module abs_continuity_rows.
Import GbtSurfaces.Part_Abstract.abs_continuity_rows.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f second s first r second_ first_ a1 a2 b1 c1 b3_true b2_true b5_true]; intros; conjuncts; ends_of_sums; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f second s first r second_ first_ a1 a2 b1 c1 b3_true b2_true b5_true]; first [(exists (2)%Z, (3)%Z, (3)%Z, (fun _ _ => 5), (fun _ _ => 6), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (3)%Z, (3)%Z, (fun _ _ => 0), (fun _ _ => 0), (0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (3)%Z, (3)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 2 * i1 * i1 * i1 + 7 * i1 + 5 * i0 * i1 + 6)%Z), (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 2 * i1 * i1 * i1 + 9 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (3)%Z, (3)%Z, (fun _ _ => 1), (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (3)%Z, (3)%Z, (fun _ _ => 0), (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_continuity_rows.
