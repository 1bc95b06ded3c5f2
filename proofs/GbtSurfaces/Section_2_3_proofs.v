(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Section_2_3.
Import GbtSurfaces.Section_2_3.Definitions.
Open Scope R_scope.

Module eq_7.
Import GbtSurfaces.Section_2_3.eq_7.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_7.

Module sec_2_3_features_a.
Import GbtSurfaces.Section_2_3.sec_2_3_features_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_2_3_features_a.

Module sec_2_3_features_b.
Import GbtSurfaces.Section_2_3.sec_2_3_features_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_3_features_b.

Module sec_2_3_features_c.
Import GbtSurfaces.Section_2_3.sec_2_3_features_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f Tz0 Tz1 Tu0 Tu1]; intros; conjuncts; intro no; refuting_at_ends (no 2%Z 2%Z (fun i j => IZR (i + j)) 0 0 0 0). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f Tz0 Tz1 Tu0 Tu1]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_3_features_c.

Module sec_2_3_features_d.
Import GbtSurfaces.Section_2_3.sec_2_3_features_d.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_2_3_features_d.

Module sec_2_3_classical_the_features_of_Sect__2_2.
Import GbtSurfaces.Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f T T_ Tz0 Tz1 Tu0 Tu1]; intros; conjuncts; first [ intro no; refuting_at_ends (no 2%Z 2%Z (fun i j => IZR (i + j)) 0 0 0 0 0 0) | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f T T_ Tz0 Tz1 Tu0 Tu1]; first [(exists (2)%Z, (2)%Z, (fun _ _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), (0), (0), (0), (0), (1 / 2), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 i1 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 2 * i1 * i1 * i1 + 8 * i1 + 5 * i0 * i1 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End sec_2_3_classical_the_features_of_Sect__2_2.

Module sec_2_3_classical_every_property.
Import GbtSurfaces.Section_2_3.sec_2_3_classical_every_property.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f] in no; refuting (no ((2))%Z ((2))%Z (1) (1) (1) (1) (1/3) (1/2)). Qed.
End sec_2_3_classical_every_property.
