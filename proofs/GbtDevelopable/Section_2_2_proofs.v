(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_2_2.
Import GbtDevelopable.Section_2_2.Definitions.
Open Scope R_scope.

Module def_2_dim_one_letter.
Import GbtDevelopable.Section_2_2.def_2_dim_one_letter.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((4))%Z). Qed.
End def_2_dim_one_letter.

Module def_2_dim_two_letters.
Import GbtDevelopable.Section_2_2.def_2_dim_two_letters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_2_dim_two_letters.

Module sec_2_2_endpoints.
Import GbtDevelopable.Section_2_2.sec_2_2_endpoints.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_endpoints.

Module sec_2_2_convexity.
Import GbtDevelopable.Section_2_2.sec_2_2_convexity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_convexity.

Module sec_2_2_symmetry.
Import GbtDevelopable.Section_2_2.sec_2_2_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry.

Module sec_2_2_symmetry_exchange.
Import GbtDevelopable.Section_2_2.sec_2_2_symmetry_exchange.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_symmetry_exchange.

Module sec_2_2_vd_quadratic.
Import GbtDevelopable.Section_2_2.sec_2_2_vd_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros mu nu x M N X; assert (A1 : forall y, Derive_n (fun t => g t mu nu 0%Z 2%Z) 1 y = PI / 2 * (cos (PI / 2 * y) * (2 * mu * sin (PI / 2 * y) - (1 + mu)))) by (intro y; cbv delta [g]; compute_goal; apply is_derive_unique; auto_derive; [exact I|field]); assert (C1 : forall y, Derive_n (fun t => g t mu nu 2%Z 2%Z) 1 y = PI / 2 * (sin (PI / 2 * y) * (1 + nu - 2 * nu * cos (PI / 2 * y)))) by (intro y; cbv delta [g]; compute_goal; apply is_derive_unique; auto_derive; [exact I|field]); assert (A2 : forall y, Derive_n (fun t => g t mu nu 0%Z 2%Z) 2 y = (PI / 2) ^ 2 * ((1 + mu) * sin (PI / 2 * y) - 2 * mu * sin (PI / 2 * y) ^ 2 + 2 * mu * cos (PI / 2 * y) ^ 2)) by (intro y; change (Derive_n (fun t => g t mu nu 0%Z 2%Z) 2 y) with (Derive (Derive_n (fun t => g t mu nu 0%Z 2%Z) 1) y); rewrite (Derive_ext _ _ y A1); apply is_derive_unique; auto_derive; [exact I|field]); assert (C2 : forall y, Derive_n (fun t => g t mu nu 2%Z 2%Z) 2 y = (PI / 2) ^ 2 * ((1 + nu) * cos (PI / 2 * y) - 2 * nu * cos (PI / 2 * y) ^ 2 + 2 * nu * sin (PI / 2 * y) ^ 2)) by (intro y; change (Derive_n (fun t => g t mu nu 2%Z 2%Z) 2 y) with (Derive (Derive_n (fun t => g t mu nu 2%Z 2%Z) 1) y); rewrite (Derive_ext _ _ y C1); apply is_derive_unique; auto_derive; [exact I|field]); assert (B : Derive_n (fun t => g t mu nu 2%Z 2%Z - g t mu nu 0%Z 2%Z) 1 x = Derive_n (fun t => g t mu nu 2%Z 2%Z) 1 x - Derive_n (fun t => g t mu nu 0%Z 2%Z) 1 x) by (apply (rate_minus (fun t => g t mu nu 2%Z 2%Z) (fun t => g t mu nu 0%Z 2%Z)); cbv delta [g]; smooth_sum); rewrite B, A2, C2, A1, C1; clear A1 A2 C1 C2 B; pose proof PI_RGT_0 as Q; assert (0 < sin (PI / 2 * x)) by (apply sin_gt_0; nra); assert (0 < cos (PI / 2 * x)) by (apply cos_gt_0; nra); pose proof (sin2_cos2 (PI / 2 * x)) as E; unfold Rsqr in E; generalize dependent (sin (PI / 2 * x)); generalize dependent (cos (PI / 2 * x)); intros c K s H E; assert (s < 1) by nra; assert (c < 1) by nra; split; [replace ((PI / 2) ^ 2 * ((1 + mu) * s - 2 * mu * s ^ 2 + 2 * mu * c ^ 2) * (PI / 2 * (s * (1 + nu - 2 * nu * c))) - PI / 2 * (c * (2 * mu * s - (1 + mu))) * ((PI / 2) ^ 2 * ((1 + nu) * c - 2 * nu * c ^ 2 + 2 * nu * s ^ 2))) with ((PI / 2) ^ 3 * ((1 + mu) * (1 + nu) * (s * (1 - c) * (s * (1 - s) + c ^ 2) + c * (1 - s) * (c * (1 - c) + s ^ 2)) + (1 + mu) * (1 - nu) * c ^ 3 + (1 - mu) * (1 + nu) * s ^ 3)) by field; assert (0 < (PI / 2) ^ 3) by (apply pow_lt; lra); assert (0 < c ^ 3) by (apply pow_lt; lra); assert (0 < s ^ 3) by (apply pow_lt; lra); assert (0 < (1 + mu) * (1 - nu)) by nra; assert (0 < (1 - mu) * (1 + nu)) by nra; assert (0 < (1 + mu) * (1 + nu)) by nra; assert (0 < s * (1 - c)) by nra; assert (0 < c * (1 - s)) by nra; assert (0 < s * (1 - s) + c ^ 2) by nra; assert (0 < c * (1 - c) + s ^ 2) by nra; apply Rmult_lt_0_compat; [assumption|]; repeat first [assumption|apply Rplus_lt_0_compat|apply Rmult_lt_0_compat]|replace (PI / 2 * (s * (1 + nu - 2 * nu * c)) - PI / 2 * (c * (2 * mu * s - (1 + mu)))) with (PI / 2 * (s * ((1 - nu) * c + (1 + nu) * (1 - c)) + c * ((1 - mu) * s + (1 + mu) * (1 - s)))) by field; assert (0 < (1 - nu) * c) by nra; assert (0 < (1 + nu) * (1 - c)) by nra; assert (0 < (1 - mu) * s) by nra; assert (0 < (1 + mu) * (1 - s)) by nra; apply Rmult_lt_0_compat; [lra|]; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra]. Qed.
Theorem met : instance.
Proof. exists 0, 0, (1 / 2); lra. Qed.
End sec_2_2_vd_quadratic.

Module sec_2_2_vd_operator.
Import GbtDevelopable.Section_2_2.sec_2_2_vd_operator.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G b F first second]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G b F first second]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End sec_2_2_vd_operator.

Module sec_2_2_geominv.
Import GbtDevelopable.Section_2_2.sec_2_2_geominv.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g M G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g M G]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), 6, 7, 8, 9, 10, 11, 12, 13, 14, ((-1) / 3), ((-1) / 3), 17, 18, 19, (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 0, 0, 0, 0, 0, 0, 0, 0, (0), (0), 0, 0, 0, (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), 8, 7, 9, 7, 7, 2, 11, 1, 4, ((-1) / 3), ((-1) / 3), 8, 6, 8, (1 / 3); met) | (exists (2)%Z, (fun _ => 6), (fun _ => 8), (fun _ => 7), 8, 7, 9, 8, 7, 9, 8, 7, 9, ((-1) / 3), ((-1) / 3), 7, 2, 11, (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), 0, 1, 0, 0, 0, 1, 1, 0, 0, ((-1) / 3), ((-1) / 3), 0, 1, 0, (1 / 3); met)]. Qed.
End sec_2_2_geominv.
