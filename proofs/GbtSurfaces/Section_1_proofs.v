(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_1.
Import GbtSurfaces.Section_1.Definitions.
Open Scope R_scope.

Module sec_1_contrib_1.
Import GbtSurfaces.Section_1.sec_1_contrib_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f Tz0 Tz1end Tz1 Tzz1end]; intros; conjuncts; intro no; refuting_at_ends (no 3%Z 3%Z (fun i j => IZR (i + j)) 0 0 0 0). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f Tz0 Tz1end Tz1 Tzz1end]; first [(exists (3)%Z, (3)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_1_contrib_1.

Module sec_1_contrib_2.
Import GbtSurfaces.Section_1.sec_1_contrib_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F cylinder F_ G ruled G_ swept FX FZ swung FX_ FZ_ N_ N__]; intros; conjuncts; intro no; refuting_at_ends (no 3%Z 3%Z (fun i _ => IZR i) (fun i => IZR i) (fun i => IZR i) 0 0 (fun i => IZR i) (fun i => IZR i) 1 1 0 0 1 1 0). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F cylinder F_ G ruled G_ swept FX FZ swung FX_ FZ_ N_ N__]; first [(exists (3)%Z, (3)%Z, (fun _ _ => 4), (fun _ => 5), (fun _ => 6), 7, 8, (fun _ => 9), (fun _ => 10), (1), (1), ((-1) / 3), ((-1) / 3), (15), (16), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 0), (fun _ => 0), (fun _ => 0), 0, 0, (fun _ => 0), (fun _ => 0), (1), (1), (0), (0), (0), (0), (1 / 2); met) | (exists (3)%Z, (3)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), 7, 9, (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 2 * i0 + 7)%Z), (2), (11), ((-1) / 3), ((-1) / 3), (13), (8), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 1), (fun _ => 1), (fun _ => 1), 1, 1, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), (1), (1), (1 / 3); met) | (exists (3)%Z, (3)%Z, (fun _ _ => 0), (fun _ => 0), (fun _ => 0), 0, 0, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), (1), (0), (1 / 3); met)]. Qed.
End sec_1_contrib_2.

Module sec_1_contrib_3_by_the_printed_conditions.
Import GbtSurfaces.Section_1.sec_1_contrib_3_by_the_printed_conditions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 1 (-1) (-1) 0). Qed.
End sec_1_contrib_3_by_the_printed_conditions.

Module sec_1_contrib_3_there_are_such_compositions.
Import GbtSurfaces.Section_1.sec_1_contrib_3_there_are_such_compositions.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_1_contrib_3_there_are_such_compositions.
