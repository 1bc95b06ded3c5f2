(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
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

Module thm_4_necessary_surfaces.
Import GbtDevelopable.Section_5_3.thm_4_necessary_surfaces.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ c] in no; refuting (no ((2))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (2) else if (Z.eqb i0 (1))%bool then (4) else if (Z.eqb i0 (2))%bool then (4*(2 + 3*PI)/PI) else 0) (1) (1) (1) (1) (1) (0) (2)). Qed.
End thm_4_necessary_surfaces.
