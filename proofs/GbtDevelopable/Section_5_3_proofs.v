(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
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
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends; intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros; assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * gamma * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck]; exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_4_c_corrected.

Module thm_4_c_true.
Import GbtDevelopable.Section_5_3.thm_4_c_true.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends; intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros; assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * gamma * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck]; exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
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
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck beta]; sums_at_ends; intros k l P1 P2 gamma lambda mu1 mu2 nu1 nu2; intros; split; [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 l mu2; split; [ assumption | third_point P2 l mu2 nu2 ] end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck beta]; exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_4_necessary_families.

Module thm_4_necessary_surfaces.
Import GbtDevelopable.Section_5_3.thm_4_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ c] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (2*(2 + 3*PI)/PI) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (2) else if (Z.eqb i0 (1))%bool then (0) else 0) (1) (1) (0) (1) (1) (1) (2)). Qed.
End thm_4_necessary_surfaces.

Module thm_4_true_necessary.
Import GbtDevelopable.Section_5_3.thm_4_true_necessary.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement g H2 H1 H2_ H1_ kappa2 cl c ck kappa1]; sums_at_ends; intros k l P1 P2 gamma mu1 mu2 nu1 nu2 rho s u v; intros; split; [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P2 l mu2; split; [ assumption | third_point P2 l mu2 nu2 ] end ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ kappa2 cl c ck kappa1]; exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_4_true_necessary.

Module thm_4_true_sufficient.
Import GbtDevelopable.Section_5_3.thm_4_true_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement kappa2 c cl ck kappa1 g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance kappa2 c cl ck kappa1 g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (11), (12), (13), (14); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (2), (11), (1), (4); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (1), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1), (0), (0), (0); met)]. Qed.
End thm_4_true_sufficient.

Module thm_4_true_sheets.
Import GbtDevelopable.Section_5_3.thm_4_true_sheets.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros; revert H0 H3 H4; clear; intros E L N; cbv beta iota zeta delta [vscale vadd zip map] in E; injection E as -> -> -> ->; assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) (direction (P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1; v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u; v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s]))) by (clear; intros a b cc z p q r s t u v w x L; pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t) (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T; cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b; cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q; r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0) (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u; v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z), (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split; [reflexivity|split; [exact T1|exact T2]]); assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w) eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a; b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl))))); assert (OP : forall a b cc z p q r s x : R, dot (direction [a; b; cc; z] [p; q; r; s]) (direction [a; b; cc; z] [p; q; r; s]) <> 0 -> dot [a; b; cc] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s])) = z /\ dot [p; q; r] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s])) = s) by (clear; intros a b cc z p q r s x N; revert N; cbv beta delta [direction normal foot moment]; lists; intro N; rewrite ?Rplus_0_r in *; split; field; exact N); destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x1 L) as (v1 & v2 & v3 & EA & A1 & A2); clear K L A1; rewrite PZ, VD in N; cbv beta delta [e1 e2 JA_]; rewrite PZ, VD; destruct (OP _ _ _ _ _ _ _ _ x1 N) as [O1 O2]; clear OP N PZ VD; split; [refine (eq_trans (f_equal _ EA) _); exact A2|]; clear EA A2; revert O1 O2; match goal with |- context [vadd (vscale ?x ?a) ?b] => generalize (eq_refl : vadd (vscale x a) b = [nth 0 (vadd (vscale x a) b) 0; nth 1 (vadd (vscale x a) b) 0; nth 2 (vadd (vscale x a) b) 0]); generalize (vadd (vscale x a) b) end; intros S ES O1 O2; revert ES O1 O2; generalize (nth 0 S 0) (nth 1 S 0) (nth 2 S 0); intros r0 r1 r2 ->; cbv beta delta [normal]; lists; intros <- <-; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0; assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w) eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P__ [p; q; r; s] [t; u; v; w] [a; b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl))))); assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0) (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0) eq_refl))))); rewrite ?PZ, ?VD; assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear; cbv beta delta [direction normal]; lists; lra); assert (L : locally (IZR 0) (fun e => dot (direction (P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) (direction (P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear; cbv beta delta [P direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field; lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L; clear L D; first [lia | reflexivity | cbv beta delta [direction normal foot moment]; lists; first [lra|parts; ring]]. Qed.
End thm_4_true_sheets.

Module thm_4_true_curvature.
Import GbtDevelopable.Section_5_3.thm_4_true_curvature.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros d1 d2 d3 d4 k1 k2 k3 k4 c1 c2 c3 c4 f1 f2 f3 f4 gamma h1 h2 h3 h4 l1 l2 l3 l4 rho s u v w x1 d d_ dd dd_ h h_ _ E F G N _ _; assert (A : P d dd h 0%Z = h) by (subst d dd h; cbv beta delta [P]; lists; parts; field); assert (B : vDerive 4 (fun e => P_ d dd h e) 1 (IZR 0) = d) by (subst d dd h; cbv beta delta [P_]; lists; parts; derivatives; field); cbv beta zeta delta [e2 e1 JA] in *; rewrite A, B in *; clear A B; assert (J : exists a b c, vadd (vscale x1 (direction h d)) (foot h d) = [a; b; c] /\ h1 * a + h2 * b + h3 * c = h4 /\ d1 * a + d2 * b + d3 * c = d4) by (clear -N; subst d h; cbv beta delta [foot direction moment normal] in *; revert N; lists; intro N; do 3 eexists; split; [ reflexivity | split; (field; intro Z; apply N; lra) ]); destruct J as (a & b & c & J & H & D); rewrite J; clear J N; cbv beta delta [direction normal]; rewrite E, F, G; subst d h dd; lists; split; [ rewrite <- H, <- D; ring | split; ring ]. Qed.
Theorem met : instance.
Proof. cbv beta delta [instance]; exists 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0; intros d d_ dd dd_ h h_; assert (A : P d dd h 0%Z = h) by (subst d dd h; cbv beta delta [P]; lists; parts; field); assert (B : vDerive 4 (fun e => P_ d dd h e) 1 (IZR 0) = d) by (subst d dd h; cbv beta delta [P_]; lists; parts; derivatives; field); cbv zeta; rewrite A, B; subst d d_ dd dd_ h h_; cbv beta delta [direction normal]; lists; conjuncts; parts; lra. Qed.
End thm_4_true_curvature.
