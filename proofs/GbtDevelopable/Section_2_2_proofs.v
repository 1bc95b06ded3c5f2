(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtDevelopable Require Section_2_2.
Open Scope R_scope.

Module eq_2_2.
Import GbtDevelopable.Section_2_2.eq_2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_2_2.

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
Proof. cbv beta zeta delta [instance g HT]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End def_2_dim_two_letters.

Module sec_2_2_endpoints.
Import GbtDevelopable.Section_2_2.sec_2_2_endpoints.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g G]; first [(exists (2)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3); met) | (exists (2)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End sec_2_2_endpoints.

Module sec_2_2_geominv.
Import GbtDevelopable.Section_2_2.sec_2_2_geominv.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g M G]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g M G]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), 6, 7, 8, 9, 10, 11, 12, 13, 14, ((-1) / 3), ((-1) / 3), 17, 18, 19, (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), 0, 0, 0, 0, 0, 0, 0, 0, 0, ((-1) / 3), ((-1) / 3), 0, 0, 0, (1 / 3); met)]. Qed.
End sec_2_2_geominv.
