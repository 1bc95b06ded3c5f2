(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtDevelopable Require Section_1.
Import GbtDevelopable.Section_1.Definitions.
Open Scope R_scope.

Module intro_continuity_free_b_any_values.
Import GbtDevelopable.Section_1.intro_continuity_free_b_any_values.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g H2 H1 H2_ H1_ N2] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4 + 1/2*PI) else 0) (1) (1) (0) (1) (1) (0)). Qed.
End intro_continuity_free_b_any_values.
