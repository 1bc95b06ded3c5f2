(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_5_3.
Import GbtDevelopable.Section_5_3.Definitions.
Open Scope R_scope.

Module thm_4_consts.
Import GbtDevelopable.Section_5_3.thm_4_consts.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c ck cl g H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c ck cl g H2]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_consts.

Module thm_4_a.
Import GbtDevelopable.Section_5_3.thm_4_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; prepared; unknown (P2 0%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_a.

Module thm_4_b.
Import GbtDevelopable.Section_5_3.thm_4_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ c]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ c]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_b.

Module thm_4_c.
Import GbtDevelopable.Section_5_3.thm_4_c.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (2*(2 + 3*PI)/PI) else 0) (1) (1) (1) (1) (1) (0)). Qed.
End thm_4_c.

Module thm_4_c_corrected.
Import GbtDevelopable.Section_5_3.thm_4_c_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_c_corrected.

Module thm_4_c_true.
Import GbtDevelopable.Section_5_3.thm_4_c_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_c_true.

Module eq_5_17.
Import GbtDevelopable.Section_5_3.eq_5_17.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl ck]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl ck]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_17.

Module thm_4_sufficient.
Import GbtDevelopable.Section_5_3.thm_4_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c cl ck beta g H2 H1 H2_ H1_]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c cl ck beta g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_sufficient.

Module thm_4_necessary_families.
Import GbtDevelopable.Section_5_3.thm_4_necessary_families.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck beta]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck beta]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_4_necessary_families.

Module thm_4_necessary_surfaces.
Import GbtDevelopable.Section_5_3.thm_4_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ c] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (2) else if (Z.eqb i0 (1))%bool then (4) else if (Z.eqb i0 (2))%bool then (4*(2 + 3*PI)/PI) else 0) (1) (1) (1) (1) (1) (0) (2)). Qed.
End thm_4_necessary_surfaces.

Module thm_4_true_necessary.
Import GbtDevelopable.Section_5_3.thm_4_true_necessary.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ kappa2 cl c ck kappa1]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ kappa2 cl c ck kappa1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (11), (12), (13), (14); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (2), (11), (1), (4); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0), (0), (0); met)]. Qed.
End thm_4_true_necessary.

Module thm_4_true_sufficient.
Import GbtDevelopable.Section_5_3.thm_4_true_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement kappa2 c cl ck kappa1 g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance kappa2 c cl ck kappa1 g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (11), (12), (13), (14); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (2), (11), (1), (4); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0), (0), (0); met)]. Qed.
End thm_4_true_sufficient.

Module thm_4_true_curvature.
Import GbtDevelopable.Section_5_3.thm_4_true_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage P; stage P_; stage normal; stage direction; stage moment; stage foot; stage_at JA [0]%Z; stage e2; staged_goal e1; unstaged; prepared; known (d2'1) (d'1*gamma*rho + h'1*s) (1); known (d2'2) (d'2*gamma*rho + h'2*s) (1); known (d2'3) (d'3*gamma*rho + h'3*s) (1); known (d2'4) (d'4*gamma*rho + h'4*s) (1); known (dd2'1) (d'1*v + dd'1*w + h'1*u) (1); known (dd2'2) (d'2*v + dd'2*w + h'2*u) (1); known (dd2'3) (d'3*v + dd'3*w + h'3*u) (1); known (dd2'4) (d'4*v + dd'4*w + h'4*u) (1); known (h2'1) (h'1*rho) (1); known (h2'2) (h'2*rho) (1); known (h2'3) (h'3*rho) (1); known (h2'4) (h'4*rho) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage P; stage P_; stage normal; stage direction; stage moment; stage foot; stage_at JA [0]%Z; stage e2; staged_goal e1; unstaged; first [(exists 2, 3, 4, 5, (((2)*((1))*((27)) + (19)*((28))) / (1)), (((3)*((1))*((27)) + (20)*((28))) / (1)), (((4)*((1))*((27)) + (21)*((28))) / (1)), (((5)*((1))*((27)) + (22)*((28))) / (1)), 10, 11, 12, 13, (((2)*((30)) + (10)*((31)) + (19)*((29))) / (1)), (((3)*((30)) + (11)*((31)) + (20)*((29))) / (1)), (((4)*((30)) + (12)*((31)) + (21)*((29))) / (1)), (((5)*((30)) + (13)*((31)) + (22)*((29))) / (1)), (1), 19, 20, 21, 22, (((19)*((27))) / (1)), (((20)*((27))) / (1)), (((21)*((27))) / (1)), (((22)*((27))) / (1)), (27), (28), (29), (30), (31), (32); met) | (exists 0, 0, 0, 0, (((0)*((1))*((0)) + (0)*((0))) / (1)), (((0)*((1))*((0)) + (0)*((0))) / (1)), (((0)*((1))*((0)) + (0)*((0))) / (1)), (((0)*((1))*((0)) + (0)*((0))) / (1)), 0, 0, 0, 0, (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (1), 0, 0, 0, 0, (((0)*((0))) / (1)), (((0)*((0))) / (1)), (((0)*((0))) / (1)), (((0)*((0))) / (1)), (0), (0), (0), (0), (0), (0); met) | (exists 13, 8, 8, 6, (((13)*((6))*((4)) + (8)*((13))) / (1)), (((8)*((6))*((4)) + (7)*((13))) / (1)), (((8)*((6))*((4)) + (9)*((13))) / (1)), (((6)*((6))*((4)) + (7)*((13))) / (1)), 7, 2, 11, 1, (((13)*((8)) + (7)*((6)) + (8)*((8))) / (1)), (((8)*((8)) + (2)*((6)) + (7)*((8))) / (1)), (((8)*((8)) + (11)*((6)) + (9)*((8))) / (1)), (((6)*((8)) + (1)*((6)) + (7)*((8))) / (1)), (6), 8, 7, 9, 7, (((8)*((4))) / (1)), (((7)*((4))) / (1)), (((9)*((4))) / (1)), (((7)*((4))) / (1)), (4), (13), (8), (8), (6), (8); met) | (exists 7, 2, 11, 1, (((7)*((1))*((1)) + (4)*((1))) / (1)), (((2)*((1))*((1)) + (13)*((1))) / (1)), (((11)*((1))*((1)) + (8)*((1))) / (1)), (((1)*((1))*((1)) + (8)*((1))) / (1)), 8, 7, 9, 7, (((7)*((1)) + (8)*((1)) + (4)*((1))) / (1)), (((2)*((1)) + (7)*((1)) + (13)*((1))) / (1)), (((11)*((1)) + (9)*((1)) + (8)*((1))) / (1)), (((1)*((1)) + (7)*((1)) + (8)*((1))) / (1)), (1), 4, 13, 8, 8, (((4)*((1))) / (1)), (((13)*((1))) / (1)), (((8)*((1))) / (1)), (((8)*((1))) / (1)), (1), (1), (1), (1), (1), (1); met) | (exists 1, 0, 0, 0, (((1)*((1))*((1)) + (1)*((0))) / (1)), (((0)*((1))*((1)) + (0)*((0))) / (1)), (((0)*((1))*((1)) + (0)*((0))) / (1)), (((0)*((1))*((1)) + (0)*((0))) / (1)), 0, 0, 1, 0, (((1)*((0)) + (0)*((0)) + (1)*((0))) / (1)), (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (((0)*((0)) + (1)*((0)) + (0)*((0))) / (1)), (((0)*((0)) + (0)*((0)) + (0)*((0))) / (1)), (1), 1, 0, 0, 0, (((1)*((1))) / (1)), (((0)*((1))) / (1)), (((0)*((1))) / (1)), (((0)*((1))) / (1)), (1), (0), (0), (0), (0), (0); met)]. Qed.
End thm_4_true_curvature.
