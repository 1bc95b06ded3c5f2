(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_5.
Import GbtDevelopable.Section_5.Definitions.
Open Scope R_scope.

Module eq_5_1.
Import GbtDevelopable.Section_5.eq_5_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g hat]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g hat]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (fun _ => 8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (1 / 3); met) | (exists (2)%Z, (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End eq_5_1.

Module sec_5_weighted_a.
Import GbtDevelopable.Section_5.sec_5_weighted_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g rational]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g rational]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), ((-1) / 3), ((-1) / 3), (fun _ => 7); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), (fun _ => 1); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0); met)]. Qed.
End sec_5_weighted_a.

Module sec_5_weighted_b_four_coordinates.
Import GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g hat hat_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g hat hat_]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (fun _ => 8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (fun _ => 0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), ((-1) / 3), ((-1) / 3), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (1 / 3); met) | (exists (2)%Z, (fun _ => 9), (fun _ => 7), (fun _ => 7), ((-1) / 3), ((-1) / 3), (fun _ => 1), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End sec_5_weighted_b_four_coordinates.

Module sec_5_weighted_b_after_division.
Import GbtDevelopable.Section_5.sec_5_weighted_b_after_division.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; assert (A : forall m, g (1 / 3) m 0 0%Z 2%Z = 1 / 2 - m / 4) by (intro m; cbv delta [g]; compute_goal; replace (PI / 2 * (1 / 3)) with (PI / 6) by field; rewrite sin_PI6; field); assert (C : forall m, g (1 / 3) m 0 0%Z 2%Z * 2 + g (1 / 3) m 0 1%Z 2%Z * 1 + g (1 / 3) m 0 2%Z 2%Z * 1 = 3 / 2 - m / 4) by (intro m; transitivity (1 + g (1 / 3) m 0 0%Z 2%Z); [cbv delta [g]; compute_goal; ring|rewrite A; field]); specialize (no 2%Z (fun i => if (i =? 0)%Z then 1 else 0) 0 0 2 1 1 (1 / 3)); revert no; rewrite (Derive_n_ext _ (fun m => (1 - m / 2) / (3 / 2 - m / 4))) by (intro m; cbv delta [rational]; cbv beta; rewrite C, A; apply (f_equal (fun t => t / _)); cbv beta iota delta [Z.eqb Pos.eqb]; field); intro no; assert (E : Derive_n (fun m => (1 - m / 2) / (3 / 2 - m / 4)) 2 0 = 0) by (apply no; try lia; try lra; exists (mkposreal 1 Rlt_0_1); intros n B; assert (N : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball]; simpl; cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B; lra);  rewrite C; lra); clear no; assert (F : Derive_n (fun m => (1 - m / 2) / (3 / 2 - m / 4)) 2 0 = - (2 / 27)) by (change (Derive (Derive (fun m => (1 - m / 2) / (3 / 2 - m / 4))) 0 = - (2 / 27)); rewrite (Derive_ext_loc _ (fun m => - (1 / 2) / (3 / 2 - m / 4) ^ 2)); [apply is_derive_unique; auto_derive; [lra|field]|exists (mkposreal 1 Rlt_0_1); intros n B; assert (N : -1 < n < 1) by (revert B; cbv [ball AbsRing_ball abs minus plus opp UniformSpace.ball]; simpl; cbv [AbsRing_ball abs minus plus opp]; simpl; intro B; apply Rabs_def2 in B; lra);  apply is_derive_unique; auto_derive; [lra|field; lra]]); rewrite F in E; lra. Qed.
End sec_5_weighted_b_after_division.

Module eq_5_2.
Import GbtDevelopable.Section_5.eq_5_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1 H2]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1 H2]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (fun _ => 6), (fun _ => 7), (fun _ => 8), (fun _ => 9), (fun _ => 10), (fun _ => 11), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 9 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 9)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 2 * i0 + 7)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 11 * i0 + 2)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), (fun _ => 8), (fun _ => 8), (fun _ => 6), (fun _ => 8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 1), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_5_2.
