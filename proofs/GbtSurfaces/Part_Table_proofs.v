(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtSurfaces Require Part_Table.
Import GbtSurfaces.Part_Table.Definitions.
Open Scope R_scope.

Module tab_1_1_proposed.
Import GbtSurfaces.Part_Table.tab_1_1_proposed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F F_]; intros; conjuncts; first [ intro no; first [ refuting (no (3)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3)) | refuting (no (3)%Z (fun _ => 3) ((-1) / 3) ((-1) / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F F_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End tab_1_1_proposed.

Module tab_1_2_proposed.
Import GbtSurfaces.Part_Table.tab_1_2_proposed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onF F next_ onF_ F_ cylinder]; intros; conjuncts; ends_of_sums; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_ cylinder]; first [(exists (3)%Z, (fun _ => 3), 4, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), 0, (1), (0), (0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, (6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), 1, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), 0, (1), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End tab_1_2_proposed.

Module tab_1_3_proposed.
Import GbtSurfaces.Part_Table.tab_1_3_proposed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF onG F G next_ onF_ onG_ F_ G_ ruled]; intros; conjuncts; ends_of_sums; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1]; exists 3%Z, (fun _ => 0), (fun _ => 0), 0, 0, 0; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End tab_1_3_proposed.

Module tab_1_4_proposed.
Import GbtSurfaces.Part_Table.tab_1_4_proposed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onX onZ FX FZ next_ onX_ onZ_ FX_ FZ_ swung]; lists; intros; conjuncts; parts; ends_of_sums; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onX onZ FX FZ next_ onX_ onZ_ FX_ FZ_ swung]; first [(exists (3)%Z, (fun _ => 3), (fun _ => 4), (1), ((-1) / 3), ((-1) / 3), (8), (9); met) | (exists (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (6), ((-1) / 3), ((-1) / 3), (9), (7); met) | (exists (3)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), (1), (1); met) | (exists (3)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), (1), (0); met)]. Qed.
End tab_1_4_proposed.

Module tab_1_5_proposed.
Import GbtSurfaces.Part_Table.tab_1_5_proposed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onF F next_ onF_ F_ swept]; intros; conjuncts; ends_of_sums; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3 next onF F next_ onF_ F_ swept]; first [(exists (3)%Z, (fun _ => 3), 4, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), 0, (0), (0); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), 8, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 1), 1, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (fun _ => 0), 0, ((-1) / 3), ((-1) / 3); met)]. Qed.
End tab_1_5_proposed.
