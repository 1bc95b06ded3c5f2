(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_5_2.
Import GbtDevelopable.Section_5_2.Definitions.
Open Scope R_scope.

Module eq_5_11.
Import GbtDevelopable.Section_5_2.eq_5_11.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_11.

Module sec_5_2_meaning.
Import GbtDevelopable.Section_5_2.sec_5_2_meaning.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros d1 d2 d3 d4 k1 k2 k3 k4 c1 c2 c3 c4 f1 f2 f3 f4 h1 h2 h3 h4 l1 l2 l3 l4 d d_ dd dd_ h h_ E F G; intros; rewrite E, F, G; repeat split. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal midpoint direction moment meet]; first [(exists 2, 3, 4, 5, (((2)) / (1)), (((3)) / (1)), (((4)) / (1)), (((5)) / (1)), 10, 11, 12, 13, (((10)) / (1)), (((11)) / (1)), (((12)) / (1)), (((13)) / (1)), 18, 19, 20, 21, (((18)) / (1)), (((19)) / (1)), (((20)) / (1)), (((21)) / (1)); met) | (exists 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)); met) | (exists 13, 8, 8, 6, (((13)) / (1)), (((8)) / (1)), (((8)) / (1)), (((6)) / (1)), 7, 2, 11, 1, (((7)) / (1)), (((2)) / (1)), (((11)) / (1)), (((1)) / (1)), 6, 8, 7, 9, (((6)) / (1)), (((8)) / (1)), (((7)) / (1)), (((9)) / (1)); met) | (exists 7, 2, 11, 1, (((7)) / (1)), (((2)) / (1)), (((11)) / (1)), (((1)) / (1)), 8, 7, 9, 7, (((8)) / (1)), (((7)) / (1)), (((9)) / (1)), (((7)) / (1)), 4, 13, 8, 8, (((4)) / (1)), (((13)) / (1)), (((8)) / (1)), (((8)) / (1)); met) | (exists 1, 0, 0, 0, (((1)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 1, 0, (((0)) / (1)), (((0)) / (1)), (((1)) / (1)), (((0)) / (1)), 1, 0, 0, 0, (((1)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)); met)]. Qed.
End sec_5_2_meaning.

Module sec_5_2_ref.
Import GbtDevelopable.Section_5_2.sec_5_2_ref.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (2))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0) (0) (0) (0) (0)). Qed.
End sec_5_2_ref.

Module sec_5_2_ref_true.
Import GbtDevelopable.Section_5_2.sec_5_2_ref_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal midpoint direction moment meet]; unstaged; prepared; known (d2'1) (d'1) (1); known (d2'2) (d'2) (1); known (d2'3) (d'3) (1); known (d2'4) (d'4) (1); known (dd2'1) (dd'1) (1); known (dd2'2) (dd'2) (1); known (dd2'3) (dd'3) (1); known (dd2'4) (dd'4) (1); known (h2'1) (h'1) (1); known (h2'2) (h'2) (1); known (h2'3) (h'3) (1); known (h2'4) (h'4) (1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal midpoint direction moment meet]; first [(exists 2, 3, 4, 5, (((2)) / (1)), (((3)) / (1)), (((4)) / (1)), (((5)) / (1)), 10, 11, 12, 13, (((10)) / (1)), (((11)) / (1)), (((12)) / (1)), (((13)) / (1)), 18, 19, 20, 21, (((18)) / (1)), (((19)) / (1)), (((20)) / (1)), (((21)) / (1)); met) | (exists 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)); met) | (exists 13, 8, 8, 6, (((13)) / (1)), (((8)) / (1)), (((8)) / (1)), (((6)) / (1)), 7, 2, 11, 1, (((7)) / (1)), (((2)) / (1)), (((11)) / (1)), (((1)) / (1)), 6, 8, 7, 9, (((6)) / (1)), (((8)) / (1)), (((7)) / (1)), (((9)) / (1)); met) | (exists 7, 2, 11, 1, (((7)) / (1)), (((2)) / (1)), (((11)) / (1)), (((1)) / (1)), 8, 7, 9, 7, (((8)) / (1)), (((7)) / (1)), (((9)) / (1)), (((7)) / (1)), 4, 13, 8, 8, (((4)) / (1)), (((13)) / (1)), (((8)) / (1)), (((8)) / (1)); met) | (exists 1, 0, 0, 0, (((1)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 1, 0, (((0)) / (1)), (((0)) / (1)), (((1)) / (1)), (((0)) / (1)), 1, 0, 0, 0, (((1)) / (1)), (((0)) / (1)), (((0)) / (1)), (((0)) / (1)); met)]. Qed.
End sec_5_2_ref_true.

Module sec_5_2_index.
Import GbtDevelopable.Section_5_2.sec_5_2_index.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H1] in no; refuting (no ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (1) (1) (1/2)). Qed.
End sec_5_2_index.

Module thm_3_consts.
Import GbtDevelopable.Section_5_2.thm_3_consts.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c ck cl]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c ck cl]; first [(exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (0), (0); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_consts.

Module thm_3_a.
Import GbtDevelopable.Section_5_2.thm_3_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; prepared; unknown (P2 0%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_a.

Module thm_3_b.
Import GbtDevelopable.Section_5_2.thm_3_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ c]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ c]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_b.

Module thm_3_c.
Import GbtDevelopable.Section_5_2.thm_3_c.
Theorem proved : statement.
Proof. let second_point := fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end in let third_point := fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu))); [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4 * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z); [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end in cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck]; sums_at_ends; intros k l P1 P2 mu1 mu2 nu1 nu2; intros; assert (V : P2 1%Z = P1 k + (2 * (IZR k - 2) + PI * (1 + nu1)) / (2 * (IZR l - 2) + PI * (1 + mu2)) * (P1 k - P1 (k - 1)%Z)) by second_point P2 l mu2; third_point P2 l mu2 nu2. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck]; exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal; conjuncts; first [ lia | intros; lia | lra | numeric ]. Qed.
End thm_3_c.

Module thm_3_sufficient.
Import GbtDevelopable.Section_5_2.thm_3_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c cl ck farin_boehm g H2 H1 H2_ H1_]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c cl ck farin_boehm g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_sufficient.

Module thm_3_necessary_families.
Import GbtDevelopable.Section_5_2.thm_3_necessary_families.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck farin_boehm]; determined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_ cl c ck farin_boehm]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_necessary_families.

Module thm_3_necessary_surfaces.
Import GbtDevelopable.Section_5_2.thm_3_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ cl c ck farin_boehm] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (2) else if (Z.eqb i0 (1))%bool then (4) else if (Z.eqb i0 (2))%bool then (12) else 0) (1) (1) (1) (0) (2)). Qed.
End thm_3_necessary_surfaces.

Module eq_5_13.
Import GbtDevelopable.Section_5_2.eq_5_13.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H2_ H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H2_ H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_13.

Module eq_5_15.
Import GbtDevelopable.Section_5_2.eq_5_15.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_15.

Module thm_3_proofref.
Import GbtDevelopable.Section_5_2.thm_3_proofref.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement cl c ck farin_boehm] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (0) (1) (1) (0)). Qed.
End thm_3_proofref.

Module thm_3_proofref_true.
Import GbtDevelopable.Section_5_2.thm_3_proofref_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement c cl ck farin_boehm]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); unknown (P2 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance c cl ck farin_boehm]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_3_proofref_true.
