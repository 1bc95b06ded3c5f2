(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_2_1.
Import GbtDevelopable.Section_2_1.Definitions.
From GbtDevelopable Require Import Section_2_1_closed.
Open Scope R_scope.

Module def_1_g0.
Import GbtDevelopable.Section_2_1.def_1_g0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_1_g0.

Module def_1_g1.
Import GbtDevelopable.Section_2_1.def_1_g1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_1_g1.

Module def_1_g2.
Import GbtDevelopable.Section_2_1.def_1_g2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_1_g2.

Module def_1_range.
Import GbtDevelopable.Section_2_1.def_1_range.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_1_range.

Module eq_2_1.
Import GbtDevelopable.Section_2_1.eq_2_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (3)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_1.

Module def_1_zero.
Import GbtDevelopable.Section_2_1.def_1_zero.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_1_zero.

Module thm_1_1_k2_functions.
Import GbtDevelopable.Section_2_1.thm_1_1_k2_functions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g] in no; refuting (no (1) (1) (1/2)). Qed.
End thm_1_1_k2_functions.

Module thm_1_1_k2_substitution.
Import GbtDevelopable.Section_2_1.thm_1_1_k2_substitution.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g first last]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g first last]; first [(exists (1), (1), (1 / 3), (1 / 3); met) | (exists (1), (1), (1 / 2), (1 / 2); met) | (exists (1), (1), (1 / 3), (1 / 3); met) | (exists (1), (1), (1 / 3), (1 / 3); met) | (exists (1), (1), (1 / 3), (1 / 3); met)]. Qed.
End thm_1_1_k2_substitution.

Module thm_1_1_k3plus_functions.
Import GbtDevelopable.Section_2_1.thm_1_1_k3plus_functions.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g] in no; refuting (no ((3))%Z (1) (1) (1/2)). Qed.
End thm_1_1_k3plus_functions.

Module thm_1_1_k3plus_substitution.
Import GbtDevelopable.Section_2_1.thm_1_1_k3plus_substitution.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g seed0] in no; refuting (no (1) (1) (1) (0)). Qed.
End thm_1_1_k3plus_substitution.

Module thm_1_1_k3plus_letters.
Import GbtDevelopable.Section_2_1.thm_1_1_k3plus_letters.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement formal g b]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance formal g b]; first [(exists (0)%Z, (2)%Z, (1), (1), (1 / 3); met) | (exists (0)%Z, (2)%Z, (1), (1), (1 / 2); met) | (exists (0)%Z, (2)%Z, (1), (1), (1 / 3); met) | (exists (0)%Z, (2)%Z, (1), (1), (1 / 3); met) | (exists (0)%Z, (2)%Z, (1), (1), (1 / 3); met)]. Qed.
End thm_1_1_k3plus_letters.

Module thm_1_1_degeneration.
Import GbtDevelopable.Section_2_1.thm_1_1_degeneration.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g f0 s f2 c]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g f0 s f2 c]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_1_degeneration.

Module thm_1_1_degeneration_only.
Import GbtDevelopable.Section_2_1.thm_1_1_degeneration_only.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage g; stage at0; stage at1; staged_goal middle; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g at0 at1 middle]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_1_degeneration_only.

Module thm_1_1_no_degeneration.
Import GbtDevelopable.Section_2_1.thm_1_1_no_degeneration.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; intros k mu nu p; intros; replace (IZR k * (IZR k - 1) * (IZR k - 2) * (p - 1) ^ 3) with (IZR k * (IZR k - 1) * (IZR k - 2) * p ^ 3 - 3 * (IZR k - 2) * (IZR k * (IZR k - 1) * p ^ 2) + 3 * (IZR k - 1) * (IZR k - 2) * (IZR k * p) - IZR k * (IZR k - 1) * (IZR k - 2)) by ring; repeat match goal with E : _ = ?t |- context [?t] => rewrite <- E; clear E end; field. Qed.
Theorem met : instance.
Proof. exists 3%Z, (4 / PI - 1), (1 - 8 / PI ^ 2), 1; repeat split; first [ lia | numeric | field; apply PI_neq0 ]. Qed.
End thm_1_1_no_degeneration.

Module thm_1_1_jets.
Import GbtDevelopable.Section_2_1.thm_1_1_jets.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; intros; undifferentiated; members_at_ends; conjuncts; field. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, (0), (0); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (3)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_1_jets.

Module thm_1_2.
Import GbtDevelopable.Section_2_1.thm_1_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0), (0), (1 / 2); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_2.

Module thm_1_3.
Import GbtDevelopable.Section_2_1.thm_1_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (0), (0), (1 / 2); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_3.

Module thm_1_4.
Import GbtDevelopable.Section_2_1.thm_1_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_4.

Module thm_1_5.
Import GbtDevelopable.Section_2_1.thm_1_5.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not g]; intro no; specialize (no (-1) (-1) 0 ltac:(lra) ltac:(lra) ltac:(lra) 2%Z (unit 1) ltac:(lia)); assert (H : unit 1 1 = 0) by (apply no; [ intros; cbv delta [unit]; compute_goal; circles; equal | lia ]); rewrite unit_one in H by reflexivity; lra. Qed.
End thm_1_5.

Module thm_1_5_quadratic.
Import GbtDevelopable.Section_2_1.thm_1_5_quadratic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_5_quadratic.

Module thm_1_5_cubic.
Import GbtDevelopable.Section_2_1.thm_1_5_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; compute_goal; intros mu nu M N; replace (PI / 2 * (1 / 3)) with (PI / 6) by field; replace (PI / 2 * (2 / 3)) with (PI / 3) by field; rewrite sin_PI6, cos_PI6, sin_PI3, cos_PI3; assert (S : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra); pose proof (sqrt_pos 3) as Q; generalize dependent (sqrt 3); intros s S Q; assert (A : 172 / 100 < s < 175 / 100) by (split; nra); match goal with |- ?e > 0 => replace e with (mu^2*s/24 - mu^2/16 - mu*nu*s/4 + 7*mu*nu/16 - mu*s/18 + 11*mu/72 + nu^2*s/24 - nu^2/16 - nu*s/18 + 11*nu/72 + s/18 + 1/36 + (s * s - 3) * (-mu^2/48 + mu*nu*s^2/48 - mu*nu*s/12 + 7*mu*nu/48 - mu*s/24 + 5*mu/72 - nu^2/48 - nu*s/24 + 5*nu/72 + 1/12)) by field end; rewrite S; assert (0 <= (mu + 1) * (nu + 1) + (1 - mu) * (1 - nu)) by nra; assert (0 <= (s / 24 - 1 / 16) * (mu ^ 2 + nu ^ 2)) by nra; assert (0 <= (7 / 16 - s / 4) * (1 + mu * nu)) by nra; assert (0 <= (11 / 72 - s / 18) * (1 + mu)) by nra; assert (0 <= (11 / 72 - s / 18) * (1 + nu)) by nra; lra. Qed.
Theorem met : instance.
Proof. exists 0, 0; lra. Qed.
End thm_1_5_cubic.

Module thm_1_5_all.
Import GbtDevelopable.Section_2_1.thm_1_5_all.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G b A B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G b A B C_]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End thm_1_5_all.

Module thm_1_6_a.
Import GbtDevelopable.Section_2_1.thm_1_6_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (0), (0); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_6_a.

Module thm_1_6_b.
Import GbtDevelopable.Section_2_1.thm_1_6_b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (0), (0); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_6_b.

Module thm_1_6_c.
Import GbtDevelopable.Section_2_1.thm_1_6_c.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g]; first [(exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (1)%Z, (2)%Z, (0), (0); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met) | (exists (1)%Z, (2)%Z, ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_6_c.

Module thm_1_6_d.
Import GbtDevelopable.Section_2_1.thm_1_6_d.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End thm_1_6_d.
