(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_5_4.
Import GbtDevelopable.Section_5_4.Definitions.
Open Scope R_scope.

Module alg_5_4_s1.
Import GbtDevelopable.Section_5_4.alg_5_4_s1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros k l P2 mu1 mu2 nu1 nu2 _ K _ _ _ _ _ L _ _ _; assert (E : matrix P2 l mu2 nu2 = _) by exact (start_matrix P2 l mu2 nu2 K); rewrite E, L; lists; conjuncts; derivatives; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H2_ matrix]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_5_4_s1.

Module alg_5_4_s2_families.
Import GbtDevelopable.Section_5_4.alg_5_4_s2_families.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; unstaged; prepared; known ((P2'1 (0)%Z)) ((P1'1 (3)%Z)) (1); known ((P2'2 (0)%Z)) ((P1'2 (3)%Z)) (1); known ((P2'3 (0)%Z)) ((P1'3 (3)%Z)) (1); known ((P2'4 (0)%Z)) ((P1'4 (3)%Z)) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (fun _ => 8), (fun _ => 9), (fun _ => 10), (fun _ => 11), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 2 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 11 * i0 + 2)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_5_4_s2_families.

Module alg_5_4_s2_surfaces.
Import GbtDevelopable.Section_5_4.alg_5_4_s2_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H1 H1_ H2 H2_ normal direction] in no; refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (2))%bool then (1) else if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (3))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) (0) (1) (1) (0)). Qed.
End alg_5_4_s2_surfaces.

Module alg_5_4_s3.
Import GbtDevelopable.Section_5_4.alg_5_4_s3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ c]; unstaged; prepared; known ((P2 (0)%Z)) ((P1 (3)%Z)) (1); known ((P2 (1)%Z)) (-(P1 (2)%Z)*gamma*nu1*PI - (P1 (2)%Z)*gamma*PI - 2*(P1 (2)%Z)*gamma + (P1 (3)%Z)*gamma*nu1*PI + (P1 (3)%Z)*gamma*PI + 2*(P1 (3)%Z)*gamma + (P1 (3)%Z)*mu2*PI + (P1 (3)%Z)*PI + 2*(P1 (3)%Z)) (mu2*PI + PI + 2); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ c]; exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End alg_5_4_s3.

Module alg_5_4_s4.
Import GbtDevelopable.Section_5_4.alg_5_4_s4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c cl ck beta g H2 H1 H2_ H1_]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c cl ck beta g H2 H1 H2_ H1_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_5_4_s4.

Module alg_5_4_s5.
Import GbtDevelopable.Section_5_4.alg_5_4_s5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H2_]; formed. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H2_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_5_4_s5.

Module alg_5_4_iterate.
Import GbtDevelopable.Section_5_4.alg_5_4_iterate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c cl ck beta c3 g H2 H1 H2_ H1_ H3 H3_]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c cl ck beta c3 g H2 H1 H2_ H1_ H3 H3_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (1), (1), (9), (10), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (1), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (fun _ => 1), (1), (1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (1), (1), (0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End alg_5_4_iterate.
