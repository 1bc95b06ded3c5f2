(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_2.
Import GbtDevelopable.Section_3_2.Definitions.
Open Scope R_scope.

Module eq_3_5.
Import GbtDevelopable.Section_3_2.eq_3_5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_5.

Module eq_3_6.
Import GbtDevelopable.Section_3_2.eq_3_6.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_6.

Module sec_3_2_phi.
Import GbtDevelopable.Section_3_2.sec_3_2_phi.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_phi.

Module sec_3_2_theta.
Import GbtDevelopable.Section_3_2.sec_3_2_theta.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a W a' phi theta]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a W a' phi theta]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_theta.

Module sec_3_2_phi_exp.
Import GbtDevelopable.Section_3_2.sec_3_2_phi_exp.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_phi_exp.

Module sec_3_2_psi_vec.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_vec.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta psi]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi theta psi]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_psi_vec.

Module sec_3_2_psi_nearest.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_nearest.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta psi]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi theta psi]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_psi_nearest.

Module sec_3_2_psi_x.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_x.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_x.

Module sec_3_2_psi_y.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_y.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_y.

Module sec_3_2_psi_z.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_z.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a' phi theta] in no; refuting (no (1) (1) (1) (1) (1) (2) (1) (1)). Qed.
End sec_3_2_psi_z.

Module sec_3_2_psi_z_corrected.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_z_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_z_corrected.

Module sec_3_2_psi_den.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_den.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_psi_den.

Module eq_3_7.
Import GbtDevelopable.Section_3_2.eq_3_7.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi W normal direction theta psi moment foot]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi W normal direction theta psi moment foot]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12), (13); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11), (1); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End eq_3_7.

Module sec_3_2_envelope.
Import GbtDevelopable.Section_3_2.sec_3_2_envelope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros; rename H1 into L, H4 into N; clear - L N; pose (PP := fun (d dd h : list R) (e : R) => vadd (vadd h (vscale e d)) (vscale (e ^ 2 / 2) dd)); pose (direction := fun P D_ : list R => cross (normal P) (normal D_)); pose (foot := fun P D_ : list R => vdiv (cross (direction P D_) (vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)))) (dot (direction P D_) (direction P D_))); assert (K : forall a b cc z p q r s t u v w x : R, locally (IZR 0) (fun e => dot (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e)) <> 0) -> exists v1 v2 v3, vDerive 3 (fun e => vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 e))) 1 (IZR 0) = [v1; v2; v3] /\ a * v1 + (b * v2 + (cc * v3 + 0)) = 0 /\ p * v1 + (q * v2 + (r * v3 + 0)) = w - dot [t; u; v] (vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s]))) by (clear; intros a b cc z p q r s t u v w x L; pose proof (tangent_plane (fun e => a + e * p + e ^ 2 / 2 * t) (fun e => b + e * q + e ^ 2 / 2 * u) (fun e => cc + e * r + e ^ 2 / 2 * v) (fun e => z + e * s + e ^ 2 / 2 * w) (smooth_quadratic a p t) (smooth_quadratic b q u) (smooth_quadratic cc r v) (smooth_quadratic z s w) x 0 L) as T; cbv beta zeta in T; rewrite ((f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 0 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 0 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 0 0] = [a; b; cc]), ((f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 1 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 1 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 1 0] = [p; q; r]), ((f_equal2 (@cons _) (quadratic_second a p t 0) (f_equal2 (@cons _) (quadratic_second b q u 0) (f_equal2 (@cons _) (quadratic_second cc r v 0) eq_refl))) : [Derive_n (fun e => a + e * p + e ^ 2 / 2 * t) 2 0; Derive_n (fun e => b + e * q + e ^ 2 / 2 * u) 2 0; Derive_n (fun e => cc + e * r + e ^ 2 / 2 * v) 2 0] = [t; u; v]), (quadratic_start z s w : Derive_n (fun e => z + e * s + e ^ 2 / 2 * w) 0 0 = z), (quadratic_start_rate z s w), (quadratic_second z s w 0) in T; destruct T as [T1 T2]; do 3 eexists; split; [reflexivity|split; [exact T1|exact T2]]); assert (VD : forall a b cc z p q r s t u v w : R, vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0) = [p; q; r; s]) by (clear; intros a b cc z p q r s t u v w; exact (f_equal2 (@cons _) (quadratic_start_rate a p t) (f_equal2 (@cons _) (quadratic_start_rate b q u) (f_equal2 (@cons _) (quadratic_start_rate cc r v) (f_equal2 (@cons _) (quadratic_start_rate z s w) eq_refl))))); assert (PZ : forall a b cc z p q r s t u v w : R, PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] 0 = [a; b; cc; z]) by (clear; intros a b cc z p q r s t u v w; exact (f_equal2 (@cons _) (quadratic_start a p t) (f_equal2 (@cons _) (quadratic_start b q u) (f_equal2 (@cons _) (quadratic_start cc r v) (f_equal2 (@cons _) (quadratic_start z s w) eq_refl))))); assert (JS : forall a b cc z p q r s t u v w x : R, vadd (vscale x (direction (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0)))) (foot (PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] (IZR 0)) (vDerive 4 (fun e => PP [p; q; r; s] [t; u; v; w] [a; b; cc; z] e) 1 (IZR 0))) = vadd (vscale x (direction [a; b; cc; z] [p; q; r; s])) (foot [a; b; cc; z] [p; q; r; s])) by (intros; rewrite PZ, VD; reflexivity); assert (CR : forall a b cc p q r v1 v2 v3 n : R, a * v1 + (b * v2 + (cc * v3 + 0)) = 0 -> p * v1 + (q * v2 + (r * v3 + 0)) = n -> cross (cross [a; b; cc] [p; q; r]) [v1; v2; v3] = vscale (- n) [a; b; cc]) by (clear; intros a b cc p q r v1 v2 v3 n E <-; lists; rewrite !Rplus_0_r in *; refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); [transitivity (p * (a * v1 + (b * v2 + cc * v3)) - a * (p * v1 + (q * v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (q * (a * v1 + (b * v2 + cc * v3)) - b * (p * v1 + (q * v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E; ring]|transitivity (r * (a * v1 + (b * v2 + cc * v3)) - cc * (p * v1 + (q * v2 + r * v3))); [ring|rewrite ?Rplus_0_r, E; ring]]); destruct (K a0 a1 a2 a3 a0' a1' a2' a3' a0'' a1'' a2'' a3'' x1 L) as (v1 & v2 & v3 & EA & A1 & A2); clear K L; pose proof (JS a0 a1 a2 a3 a0' a1' a2' a3' a0'' a1'' a2'' a3'' x1 : J a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' x1 0%Z = _) as EJ; clear JS VD PZ; rewrite EJ in *; clear EJ; generalize dependent (vadd (vscale x1 (direction [a0; a1; a2; a3] [a0'; a1'; a2'; a3'])) (foot [a0; a1; a2; a3] [a0'; a1'; a2'; a3'])); intros S N A2; split; [clear; cbv beta delta [phi a a']; lists; ring|split; [refine (eq_trans (f_equal _ EA) _); exact A1|]]; refine (eq_trans (f_equal (fun V => vdiv V _) (eq_trans (f_equal _ EA) (CR a0 a1 a2 a0' a1' a2' _ _ _ (a3'' - dot (a'' a0'' a1'' a2'') S) A1 A2))) _); clear - N; generalize dependent (dot (a'' a0'' a1'' a2'') S); intros m N; cbv beta iota delta [vdiv vscale map a]; refine (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ (f_equal2 (@cons _) _ eq_refl))); field; exact N. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A A_ A3 A3_ J J_ a a' a'' phi]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0; lists; start_values; split; [lra|split; [lra|split; [apply filter_forall; intro e; rewrite ?quadratic_rate; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; [apply filter_forall; intro e; rewrite ?quadratic_rate; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; [lra|split; [lra|lra]]]]]]. Qed.
End sec_3_2_envelope.
