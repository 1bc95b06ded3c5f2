(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_3.
Import GbtDevelopable.Section_3_3.Definitions.
Open Scope R_scope.

Module eq_3_8.
Import GbtDevelopable.Section_3_3.eq_3_8.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_8.

Module eq_3_9.
Import GbtDevelopable.Section_3_3.eq_3_9.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; parts; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_9.

Module sec_3_3_S_vec.
Import GbtDevelopable.Section_3_3.sec_3_3_S_vec.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a' a'' system cramer1 cramer2 cramer3 S_] in no; refuting (no (1) (1) (1) (1) (1) (2) (1) (2) (1) (1) (1) (1)). Qed.
End sec_3_3_S_vec.

Module sec_3_3_S_vec_corrected.
Import GbtDevelopable.Section_3_3.sec_3_3_S_vec_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' system cramer1 cramer2 cramer3 S_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' system cramer1 cramer2 cramer3 S_]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12), (13); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11), (1); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_3_S_vec_corrected.

Module sec_3_3_S_x.
Import GbtDevelopable.Section_3_3.sec_3_3_S_x.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer1]; identity. Qed.
End sec_3_3_S_x.

Module sec_3_3_S_y.
Import GbtDevelopable.Section_3_3.sec_3_3_S_y.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer2]; identity. Qed.
End sec_3_3_S_y.

Module sec_3_3_S_z.
Import GbtDevelopable.Section_3_3.sec_3_3_S_z.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cramer3]; identity. Qed.
End sec_3_3_S_z.

Module sec_3_3_S_den.
Import GbtDevelopable.Section_3_3.sec_3_3_S_den.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' system]; identity. Qed.
End sec_3_3_S_den.

Module sec_3_3_regression.
Import GbtDevelopable.Section_3_3.sec_3_3_regression.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' a''' system S_ cramer1 cramer2 cramer3 four A A3 meet spine phi normal]; intros; pose proof (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0' a0'' a0''') (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3'' a3''') 0) as L; revert L; lists; start_values; intro L; clear - H H0 L; revert H; lists; intro D; revert H0; lists; intro F; specialize (L D); destruct (three_entries _ _ _ _ _ _ L) as (E1 & E2 & E3); rewrite E1, E2, E3; clear L E1 E2 E3; split; [field; (let Z := fresh in intro Z; apply D; refine (eq_trans _ Z); ring)|split; [field; (let Z := fresh in intro Z; apply D; refine (eq_trans _ Z); ring)|]]; refine (f_equal2 (@cons _) _ _); [apply scaled_over; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_over; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_over; assumption|reflexivity]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal]; exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1; split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|apply filter_forall; intro e; lists; rewrite ?cubic_rate, ?cubic_second; match goal with |- ?d <> 0 => replace d with 1 by field; lra end]]. Qed.
End sec_3_3_regression.

Module sec_3_3_regression_velocity.
Import GbtDevelopable.Section_3_3.sec_3_3_regression_velocity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' a'' a''' system S_ cramer1 cramer2 cramer3 four A A3 meet spine phi normal]; intros; pose proof (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0' a0'' a0''') (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3'' a3''') 0) as L; revert L; lists; start_values; intro L; apply L; intro Z; apply H1; refine (eq_trans _ Z); ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal]; exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1; split; [apply filter_forall; intro e; lists; rewrite ?cubic_rate, ?cubic_second; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end]. Qed.
End sec_3_3_regression_velocity.

Module sec_3_3_regression_quadratic.
Import GbtDevelopable.Section_3_3.sec_3_3_regression_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quadratic meet normal g]; lists; intros U1 U2 U3 U4 mu nu x _ _ _ D _ _ _; revert D; undifferentiated; repeat match goal with |- context [Derive_n (fun t => @?u t + @?w t) ?k x] => let E := fresh in let v := fresh in evar (v : R); assert (E : Derive_n (fun t => u t + w t) k x = v) by (subst v; spread; reflexivity); cbv beta in E; rewrite E; subst v; clear E end; repeat match goal with |- context [Derive_n ?f ?k x] => generalize (Derive_n f k x); intro end; repeat match goal with |- context [basis ?a ?b ?s ?i ?k] => generalize (basis a b s i k); intro end; generalize (U1 0%Z) (U1 1%Z) (U1 2%Z) (U2 0%Z) (U2 1%Z) (U2 2%Z) (U3 0%Z) (U3 1%Z) (U3 2%Z) (U4 0%Z) (U4 1%Z) (U4 2%Z); intros; match goal with D : (?a * _ + ?b * _ + ?c * _) * ((?d * _ + ?e * _ + ?f * _) * ((?g * _ + ?h * _ + ?k * _) * 1 + 0) + _) + _ <> 0 |- _ => parts; (apply (same_ratio (a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g))); [exact D | ring | ring]) end. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quadratic normal g]; exists (fun i => if (i =? 0)%Z then 1 else 0), (fun i => if (i =? 1)%Z then 1 else 0), (fun i => if (i =? 2)%Z then 1 else 0), (fun _ => 0), 0, 0, 0; lists; cbv beta iota delta [Z.eqb Pos.eqb]; spread; members_at_ends; pose proof PI_RGT_0; split; [lra|split; [lra|split; [lra|split; [|split; [lra|split; [lra|lra]]]]]]; match goal with |- ?d <> 0 => replace d with ((PI / 2) ^ 3) by field; apply pow_nonzero; lra end. Qed.
End sec_3_3_regression_quadratic.

Module eq_3_10.
Import GbtDevelopable.Section_3_3.eq_3_10.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement V a a' a'' a''' system S_ cramer1 cramer2 cramer3 four A A3 meet spine phi normal]; intros; pose proof (spine_velocity (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''') (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''') (smooth_cubic a0 a0' a0'' a0''') (smooth_cubic a1 a1' a1'' a1''') (smooth_cubic a2 a2' a2'' a2''') (smooth_cubic a3 a3' a3'' a3''') 0) as L; revert L; lists; start_values; intro L; clear - H H0 L; revert H; lists; intro D; revert H0; lists; intro F; specialize (L D); destruct (three_entries _ _ _ _ _ _ L) as (E1 & E2 & E3); rewrite E1, E2, E3; clear L E1 E2 E3; split; [field; (let Z := fresh in intro Z; apply D; refine (eq_trans _ Z); ring)|split; [field; (let Z := fresh in intro Z; apply D; refine (eq_trans _ Z); ring)|]]; refine (f_equal2 (@cons _) _ _); [apply scaled_back; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_back; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_back; assumption|reflexivity]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' a''' system four A A3 normal]; exists 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0; split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|apply filter_forall; intro e; lists; rewrite ?cubic_rate, ?cubic_second; match goal with |- ?d <> 0 => replace d with 1 by field; lra end]]. Qed.
End eq_3_10.

Module sec_3_3_developable.
Import GbtDevelopable.Section_3_3.sec_3_3_developable.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros; match goal with |- vdiv (vscale _ ?X) _ = _ => assert (E : X = vscale (x2 * (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''') ^ 2 / (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'')) ^ 3) (a a0 a1 a2)) by (refine (eq_trans (spine_plane (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'' + e ^ 3 / 6 * a0''' + e ^ 4 / 24 * a0'''') (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'' + e ^ 3 / 6 * a1''' + e ^ 4 / 24 * a1'''') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'' + e ^ 3 / 6 * a2''' + e ^ 4 / 24 * a2'''') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3''' + e ^ 4 / 24 * a3'''') (smooth_quartic a0 a0' a0'' a0''' a0'''') (smooth_quartic a1 a1' a1'' a1''' a1'''') (smooth_quartic a2 a2' a2'' a2''' a2'''') (smooth_quartic a3 a3' a3'' a3''' a3'''') x2 0 H2) _); cbv beta zeta delta [a a' a'' a''' system four]; clear; lists; start_values; reflexivity) end; rewrite E; clear - H H0 H1; generalize dependent (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3'''); generalize dependent (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'')); intros; cbv delta [a]; lists; refine (f_equal2 (@cons _) _ _); [apply scaled_plane; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_plane; assumption|]; refine (f_equal2 (@cons _) _ _); [apply scaled_plane; assumption|reflexivity]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' a''' system four A A3 meet phi normal B B3 curve]; exists 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1; split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split; [lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end|split; [apply filter_forall; intro e; lists; rewrite ?quartic_rate, ?quartic_second; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|lists; match goal with |- ?d <> 0 => replace d with 1 by ring; lra end]]]]. Qed.
End sec_3_3_developable.
