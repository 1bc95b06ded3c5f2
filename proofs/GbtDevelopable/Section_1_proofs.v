(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_1.
Import GbtDevelopable.Section_1.Definitions.
Open Scope R_scope.

Module intro_continuity_free_a.
Import GbtDevelopable.Section_1.intro_continuity_free_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g N2 H1 N2_ ratio H1_]; prepared; unknown (P2 0%Z); unknown (P2 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g N2 H1 N2_ ratio H1_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (0), (0), (0), (0), (0); met) | (exists (2)%Z, (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 1), (fun _ => 1), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End intro_continuity_free_a.

Module intro_continuity_free_b_any_values.
Import GbtDevelopable.Section_1.intro_continuity_free_b_any_values.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2] in no; refuting_at_ends (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1) (0)). Qed.
End intro_continuity_free_b_any_values.

Module intro_continuity_free_c_any_values.
Import GbtDevelopable.Section_1.intro_continuity_free_c_any_values.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement H1 H2 H1_ H2_ N2 g] in no; specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 0 0 (-1) (-1) (-1) 0 1 (fun _ => 0) (fun _ => 0) (fun t => t)); without_premises no; revert no; lists; match goal with |- [[Derive_n ?f 1 ?x]] = [[_ * Derive_n ?g 1 ?y]] -> _ => rewrite (slope_of_line f (fun t => 0 * t) x 0); [ rewrite (slope_of_line g (fun t => PI ^ 2 / 4 * t) y (PI ^ 2 / 4)); [ unfold ratio; lists; intro C; injection C; clear C; intro C; apply (pow_nonzero PI 2 PI_neq0); match type of C with ?l = ?r => transitivity (4 * r); [ | rewrite <- C ]; field end | intro; ends_of_sums; compute_goal; field | intro; ring ] | intro; ends_of_sums; compute_goal; field | intro; ring ] end. Qed.
End intro_continuity_free_c_any_values.

Module intro_contrib_4.
Import GbtDevelopable.Section_1.intro_contrib_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H H_ H__]; intros; conjuncts; first [ intro no; first [ refuting (no (2)%Z (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z) ((-1) / 3) ((-1) / 3) (1 / 3)) | refuting (no (2)%Z (fun _ => 3) ((-1) / 3) ((-1) / 3) (1 / 3)) ] | symbolic ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H H_ H__]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End intro_contrib_4.

Module intro_gauss.
Import GbtDevelopable.Section_1.intro_gauss.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage a; stage a'; stage a''; stage A; stage direction_at; stage phi; stage A3; staged_goal J; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' a'' A direction_at phi A3 J]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12), (13), (14); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11), (1), (4); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End intro_gauss.
