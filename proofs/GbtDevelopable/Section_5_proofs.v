(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From GbtDevelopable Require Section_5.
Open Scope R_scope.

Module sec_5_weighted_b_four_coordinates.
Import GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g hat hat_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g hat hat_]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), (fun _ => 8), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (fun _ => 0), (1 / 3); met)]. Qed.
End sec_5_weighted_b_four_coordinates.

Module sec_5_weighted_b_after_division.
Import GbtDevelopable.Section_5.sec_5_weighted_b_after_division.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g rational] in no; refuting (no (2)%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1) (1) (1) (2) (1) (1/2)). Qed.
End sec_5_weighted_b_after_division.
