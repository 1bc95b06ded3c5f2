(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtDevelopable Require Section_5_5.
Import GbtDevelopable.Section_5_5.Definitions.
Open Scope R_scope.

Module eq_5_18.
Import GbtDevelopable.Section_5_5.eq_5_18.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 E1_1 E1_2 E1_3]; identity. Qed.
End eq_5_18.

Module ex_5_1_shape_shape.
Import GbtDevelopable.Section_5_5.ex_5_1_shape_shape.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g N2 N2_]; intros; conjuncts; first [ intro no; first [ refuting (no (3)%Z (3)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (3)%Z (3)%Z (fun _ => 4) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g N2 N2_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End ex_5_1_shape_shape.

Module ex_5_1_shape_combined_surface.
Import GbtDevelopable.Section_5_5.ex_5_1_shape_combined_surface.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2 N2_] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1) (0)). Qed.
End ex_5_1_shape_combined_surface.
