(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_4.
Import GbtDevelopable.Section_3_4.Definitions.
Open Scope R_scope.

Module eq_3_11_a.
Import GbtDevelopable.Section_3_4.eq_3_11_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_a.

Module eq_3_11_b.
Import GbtDevelopable.Section_3_4.eq_3_11_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_b.

Module eq_3_11_c.
Import GbtDevelopable.Section_3_4.eq_3_11_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_11_c.

Module eq_3_12_a.
Import GbtDevelopable.Section_3_4.eq_3_12_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_a.

Module eq_3_12_b.
Import GbtDevelopable.Section_3_4.eq_3_12_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_b.

Module eq_3_12_c.
Import GbtDevelopable.Section_3_4.eq_3_12_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_12_c.

Module sec_3_4_tangent_ends.
Import GbtDevelopable.Section_3_4.sec_3_4_tangent_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros; match goal with A : _ = HT ?T ?k ?mu ?nu 0%Z, B : _ = HT ?T ?k ?mu ?nu 1%Z |- _ => assert (C : HT T k mu nu 0%Z = T 0%Z) by (cbv beta delta [HT g]; lists; at_ends; reflexivity); assert (D : HT T k mu nu 1%Z = T k) by (cbv beta delta [HT g]; lists; at_ends; reflexivity); rewrite C in A; rewrite D in B; clear C D; rewrite <- A, <- B; clear A B end; clear - H6 H7 H9 H10; pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd)); assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1; v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u; v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s]))) by (clear; intros a b cc z p q r s t u v w x L; pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t) (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T; cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b; cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q; r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0) (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u; v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z), (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split; [reflexivity|split; [exact T1|exact T2]]); assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w) eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] 0 = [a; b; cc; z]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl))))); assert (JS : forall a b cc z p q r s t u v w x : R, vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0))) = vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s])) by (intros; rewrite PZ, VD; reflexivity); assert (TL : forall a b cc z p q r s t u v w x : R, dot (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0))) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0))) <> 0 -> locally (IZR 0) (fun e => dot (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0) -> dot [a; b; cc] (vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0)))) = z /\ dot [a; b; cc] (direction [a; b; cc; z] [p; q; r; s]) = 0 /\ dot [a; b; cc] (vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0)) = 0) by (intros a b cc z p q r s t u v w x N L; rewrite JS; rewrite PZ, VD in N; destruct (K _ _ _ _ _ _ _ _ _ _ _ _ x L) as (v1 & v2 & v3 & E & A1 & _); rewrite E; split; [clear - N; revert N; cbv beta delta [direction normal foot moment]; lists; intro N; rewrite ?Rplus_0_r in *; field; exact N|split; [clear; cbv beta delta [direction normal]; lists; ring|exact A1]]); destruct (TL _ _ _ _ _ _ _ _ _ _ _ _ x1 H6 H7) as (F1 & F2 & F3); destruct (TL _ _ _ _ _ _ _ _ _ _ _ _ x1 H9 H10) as (G1 & G2 & G3); clear TL K VD PZ JS H6 H7 H9 H10; split; [reflexivity|split; [exact F1|split; [exact F2|split; [exact F3|split; [reflexivity|split; [exact G1|split; [exact G2|exact G3]]]]]]]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 2%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0; assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w) eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, P [p; q; r; s] [t; u; v; w] [a; b; cc; z] 0%Z = [a; b; cc; z]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl))))); assert (VE : forall a b cc z p q r s t u v w e0 : R, vDerive 4 (fun e => P_ [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e0 = [p + e0 * t; q + e0 * u; r + e0 * v; s + e0 * w]) by (clear; intros; exact (f_equal2 (@cons _) (quadratic_rate a p t e0) (f_equal2 (@cons _) (quadratic_rate b q u e0) (f_equal2 (@cons _) (quadratic_rate cc r v e0) (f_equal2 (@cons _) (quadratic_rate z s w e0) eq_refl))))); change O__ with (fun e f ff t => P_ f ff e t); change O_ with (fun e f ff t => P f ff e t); cbv beta; rewrite ?PZ, ?VD; assert (D : dot (direction [1; 0; 0; 0] [0; 1; 0; 0]) (direction [1; 0; 0; 0] [0; 1; 0; 0]) <> 0) by (clear; cbv beta delta [direction normal]; lists; lra); assert (L : locally (IZR 0) (fun e => dot (direction (P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) (direction (P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) (vDerive 4 (fun e => P_ [0; 1; 0; 0] [0; 0; 0; 0] [1; 0; 0; 0] e) 1 e)) <> 0)) by (apply filter_forall; intro e; rewrite VE; clear; cbv beta delta [P_ direction normal]; lists; match goal with |- ?d <> 0 => replace d with 1 by field; lra end); clear VD PZ VE; repeat match goal with |- _ /\ _ => split end; try exact D; try exact L; clear L D; first [lia | cbv beta delta [HT g]; lists; at_ends; reflexivity | cbv beta delta [direction normal foot moment]; lists; first [lra|parts; ring]]. Qed.
End sec_3_4_tangent_ends.

Module eq_3_13.
Import GbtDevelopable.Section_3_4.eq_3_13.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal W]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal W]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_3_13.

Module sec_3_4_J0.
Import GbtDevelopable.Section_3_4.sec_3_4_J0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J0.

Module sec_3_4_dual.
Import GbtDevelopable.Section_3_4.sec_3_4_dual.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_dual.

Module sec_3_4_J1.
Import GbtDevelopable.Section_3_4.sec_3_4_J1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT HT_ normal direction moment]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT HT_ normal direction moment]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_J1.

Module sec_3_4_m0_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r1.

Module sec_3_4_m0_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r2.

Module sec_3_4_m0_r3_c1.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c1.

Module sec_3_4_m0_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no; end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no. Qed.
End sec_3_4_m0_r3_c2.

Module sec_3_4_m0_r3_c2_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c2_corrected.

Module sec_3_4_m0_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k1 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m0_r3_true.

Module sec_3_4_m0_r3_c3.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k1] in no; specialize (no 2%Z (fun _ => 0) 1 0); revert no; end_values start start_matrix (fun _ : Z => 0) 2%Z 1 0; intro no; refuting no. Qed.
End sec_3_4_m0_r3_c3.

Module sec_3_4_m0_r3_c3_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends start start_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k1]; exists 2%Z, (fun _ => 0), 0, 0; end_values start start_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m0_r3_c3_corrected.

Module sec_3_4_m1_r1.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r1.

Module sec_3_4_m1_r2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r2.

Module sec_3_4_m1_r3_c1.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c1.

Module sec_3_4_m1_r3_c2.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2.
Theorem refuted : ~ statement.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in intro no; cbv beta zeta delta [statement k2] in no; specialize (no 2%Z (fun _ => 0) 0 1); revert no; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 1; intro no; refuting no. Qed.
End sec_3_4_m1_r3_c2.

Module sec_3_4_m1_r3_c2_corrected.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c2_corrected.

Module sec_3_4_m1_r3_true.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k2 g H H_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance k2 g H H_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_m1_r3_true.

Module sec_3_4_m1_r3_c3.
Import GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement k1 k2]; intros; inverse_of_ends end_ end_matrix; field; nonzero. Qed.
Theorem met : instance.
Proof. let end_values := fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu ltac:(lia)); rewrite E; clear E in cbv beta zeta delta [instance k2]; exists 2%Z, (fun _ => 0), 0, 0; end_values end_ end_matrix (fun _ : Z => 0) 2%Z 0 0; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_m1_r3_c3.

Module sec_3_4_S0.
Import GbtDevelopable.Section_3_4.sec_3_4_S0.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _; assert (A : HT T k mu nu 0%Z = (T 0%Z)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 0) = vscale (IZR k - 2 + PI / 2 * (1 + mu)) (vsub (T 1%Z) (T 0%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 0) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) (T 0%Z)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2) (T 1%Z))) (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (T 2%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C; revert D2; generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + (1 - nu) * (PI / 2) ^ 2) (IZR k - 2 + PI / 2 * (1 + mu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)))) - (2 * mu + 1 - nu) * (PI / 2) ^ 2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2); revert D; subst T; cbv beta delta [normal]; cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g HT HT_ meet]; exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit]; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_S0.

Module sec_3_4_S0_gen.
Import GbtDevelopable.Section_3_4.sec_3_4_S0_gen.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal kappa HT_ meet S0]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal kappa HT_ meet S0]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_S0_gen.

Module sec_3_4_S1.
Import GbtDevelopable.Section_3_4.sec_3_4_S1.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _ _; assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); assert (C : vDerive 4 (fun x => HT_ T k mu nu x) 2 (IZR 1) = vadd (vadd (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2) (T k)) (vscale (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2) (T (k - 1)%Z))) (vscale ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (T (k - 2)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B, C in D2 |- *; clear A B C; revert D2; generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + (1 - mu) * (PI / 2) ^ 2) (IZR k - 2 + PI / 2 * (1 + nu)); generalize (- (2 * ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)))) - (2 * nu + 1 - mu) * (PI / 2) ^ 2); generalize ((IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) + 2 * nu * (PI / 2) ^ 2); revert D; subst T; cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3 (k - 1)%Z) (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z); cbv beta zeta delta [meet normal]; lists; intros; parts; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g HT HT_ meet]; exists 2%Z, (unit 0), (unit 1), (unit 2), (fun _ => 0), 0, 0; lists; ends_of_sums; cbv delta [unit]; compute_goal; conjuncts; first [ lia | lra | numeric ]. Qed.
End sec_3_4_S1.

Module sec_3_4_S1_gen.
Import GbtDevelopable.Section_3_4.sec_3_4_S1_gen.
Theorem proved : statement.
Proof. cbv beta delta [statement kappa S1]; intros k T1 T2 T3 T4 mu nu T K M N _ _ _ D D2 _ _; assert (A : HT T k mu nu 1%Z = (T k)) by (clear -K; subst T; cbv beta delta [HT g]; symbolic); assert (B : vDerive 4 (fun x => HT_ T k mu nu x) 1 (IZR 1) = vscale (IZR k - 2 + PI / 2 * (1 + nu)) (vsub (T k) (T (k - 1)%Z))) by (clear -K; subst T; cbv beta delta [HT_ g]; symbolic); cbv beta zeta in D2 |- *; rewrite A, B; clear A B; revert D2; generalize (IZR k - 2 + PI / 2 * (1 + nu)); revert D; subst T; cbv beta delta [normal]; generalize (T1 k) (T2 k) (T3 k) (T4 k) (T1 (k - 1)%Z) (T2 (k - 1)%Z) (T3 (k - 1)%Z) (T4 (k - 1)%Z) (T1 (k - 2)%Z) (T2 (k - 2)%Z) (T3 (k - 2)%Z) (T4 (k - 2)%Z); cbv beta zeta delta [meet normal]; lists; intros; split; field; nonzero. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal kappa HT_ meet S1]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_3_4_S1_gen.
