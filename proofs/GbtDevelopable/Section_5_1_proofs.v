(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From GbtDevelopable Require Section_5_1.
Open Scope R_scope.

Module eq_5_3_a.
Import GbtDevelopable.Section_5_1.eq_5_3_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H1]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H1]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_5_3_a.

Module eq_5_3_b.
Import GbtDevelopable.Section_5_1.eq_5_3_b.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((0))%Z ((2))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else 0)). Qed.
End eq_5_3_b.

Module eq_5_3_b_corrected.
Import GbtDevelopable.Section_5_1.eq_5_3_b_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (0)%Z, (2)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (0)%Z, (2)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End eq_5_3_b_corrected.

Module eq_5_4.
Import GbtDevelopable.Section_5_1.eq_5_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g H2 H1 H1_ H2_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g H2 H1 H1_ H2_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End eq_5_4.

Module eq_5_4_nec_suf_curves_of_four_coordinates.
Import GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement across]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance across]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met)]. Qed.
End eq_5_4_nec_suf_curves_of_four_coordinates.

Module eq_5_4_nec_suf_curves_in_space.
Import GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_in_space.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement point velocity] in no; refuting (no 0 0 0 0 (1) (1) (0) (0) (1) (2) (0)). Qed.
End eq_5_4_nec_suf_curves_in_space.
