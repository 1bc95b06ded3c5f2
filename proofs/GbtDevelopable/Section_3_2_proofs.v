(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Section_3_2.
Import GbtDevelopable.Section_3_2.Definitions.
Open Scope R_scope.

Module eq_3_5.
Import GbtDevelopable.Section_3_2.eq_3_5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_5.

Module eq_3_6.
Import GbtDevelopable.Section_3_2.eq_3_6.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g HT normal W F]; lists; intros; spread; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g HT normal W F]; first [(exists (2)%Z, (fun _ => 3), (fun _ => 4), (fun _ => 5), (fun _ => 6), (7), (8), (9), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0), (0), (0), (0), (0), (0), (1 / 2); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 7 * i0 + 8)%Z), (7), (9), (7), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 7), (fun _ => 9), (fun _ => 7), (fun _ => 7), (1), (1), (1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (2)%Z, (fun _ => 1), (fun _ => 0), (fun _ => 0), (fun _ => 0), (1), (0), (0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End eq_3_6.

Module sec_3_2_phi.
Import GbtDevelopable.Section_3_2.sec_3_2_phi.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_phi.

Module sec_3_2_theta.
Import GbtDevelopable.Section_3_2.sec_3_2_theta.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a W a' phi theta]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a W a' phi theta]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_theta.

Module sec_3_2_phi_exp.
Import GbtDevelopable.Section_3_2.sec_3_2_phi_exp.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_phi_exp.

Module sec_3_2_psi_vec.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_vec.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta psi]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi theta psi]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_psi_vec.

Module sec_3_2_psi_nearest.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_nearest.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta psi]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi theta psi]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End sec_3_2_psi_nearest.

Module sec_3_2_psi_x.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_x.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_x.

Module sec_3_2_psi_y.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_y.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_y.

Module sec_3_2_psi_z.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_z.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a a' phi theta] in no; refuting (no (1) (1) (1) (1) (1) (2) (1) (1)). Qed.
End sec_3_2_psi_z.

Module sec_3_2_psi_z_corrected.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_z_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi theta]; identity. Qed.
End sec_3_2_psi_z_corrected.

Module sec_3_2_psi_den.
Import GbtDevelopable.Section_3_2.sec_3_2_psi_den.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi]; identity. Qed.
End sec_3_2_psi_den.

Module eq_3_7.
Import GbtDevelopable.Section_3_2.eq_3_7.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a a' phi W normal direction theta psi moment foot]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a a' phi W normal direction theta psi moment foot]; first [(exists (2), (3), (4), (5), (6), (7), (8), (9), (10), (11), (12), (13); met) | (exists (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met) | (exists (13), (8), (8), (6), (8), (7), (9), (7), (7), (2), (11), (1); met) | (exists (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1), (1); met) | (exists (1), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0), (0); met)]. Qed.
End eq_3_7.

Module sec_3_2_envelope.
Import GbtDevelopable.Section_3_2.sec_3_2_envelope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement A A_ A3 A3_ J J_ a a' a'' phi]; intros; clear H H2 H3 H5; pose proof (tangent_plane (fun e => a0 + e * a0' + e ^ 2 / 2 * a0'') (fun e => a1 + e * a1' + e ^ 2 / 2 * a1'') (fun e => a2 + e * a2' + e ^ 2 / 2 * a2'') (fun e => a3 + e * a3' + e ^ 2 / 2 * a3'') (smooth_quadratic a0 a0' a0'') (smooth_quadratic a1 a1' a1'') (smooth_quadratic a2 a2' a2'') (smooth_quadratic a3 a3' a3'') x1 0) as L; revert L H0 H1 H4; lists; start_values; intros L _ H1 H4; specialize (L H1); clear H1; revert L; repeat match goal with |- context [Derive_n ?f 1 0] => generalize (Derive_n f 1 0); intro end; intros [L1 L2]; match type of L1 with ?l = _ => match type of L2 with ?m = _ => split; [ring|split; [exact L1|]]; parts; [apply quotient_is; [exact H4|transitivity (a0' * l - a0 * m); [ring|rewrite L1, L2; ring]]|apply quotient_is; [exact H4|transitivity (a1' * l - a1 * m); [ring|rewrite L1, L2; ring]]|apply quotient_is; [exact H4|transitivity (a2' * l - a2 * m); [ring|rewrite L1, L2; ring]]] end end. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance A A_ A3 A3_ J J_ a a' a'' phi]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0; lists; start_values; split; [lra|split; [lra|split; [apply filter_forall; intro e; rewrite ?quadratic_rate; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; [apply filter_forall; intro e; rewrite ?quadratic_rate; match goal with |- ?d <> 0 => replace d with 1 by field; lra end|split; [lra|split; [lra|lra]]]]]]. Qed.
End sec_3_2_envelope.
