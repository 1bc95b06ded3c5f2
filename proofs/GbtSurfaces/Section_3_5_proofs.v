(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics.
From GbtSurfaces Require Section_3_5.
Open Scope R_scope.

Module eq_27.
Import GbtSurfaces.Section_3_5.eq_27.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f section section_ trajectory trajectory_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f section section_ trajectory trajectory_]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), (1 / 3), (1 / 3); met)]. Qed.
End eq_27.

Module sec_3_5_categories.
Import GbtSurfaces.Section_3_5.sec_3_5_categories.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End sec_3_5_categories.

Module sec_3_5_not_expressible_sine.
Import GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (1 / 3); met) | (exists (1 / 3); met)]. Qed.
End sec_3_5_not_expressible_sine.

Module ex_3_5_sections.
Import GbtSurfaces.Section_3_5.ex_3_5_sections.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S1 S2]; identity. Qed.
End ex_3_5_sections.

Module ex_3_5_trajectories.
Import GbtSurfaces.Section_3_5.ex_3_5_trajectories.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T1 T2]; identity. Qed.
End ex_3_5_trajectories.
