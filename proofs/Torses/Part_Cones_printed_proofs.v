(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Cones_printed Part_Cones_proofs.
Open Scope R_scope.

Module cone_torse.
Import Torses.Part_Cones_printed.cone_torse.
Theorem proved : statement.
Proof. hnf; intros a r'1 r'2 r'3 p'1 p'2 p'3 u; by_jets (Torses.Part_Cones_proofs.cone_torse.proved (Derive_n a 1 u) (a u) p'1 p'2 p'3 (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0, 0; met_by_jets. Qed.
End cone_torse.

Module cone_apex.
Import Torses.Part_Cones_printed.cone_apex.
Theorem proved : statement.
Proof. hnf; intros a r'1 r'2 r'3 p'1 p'2 p'3 u; by_jets (Torses.Part_Cones_proofs.cone_apex.proved (Derive_n a 1 u) (a u) p'1 p'2 p'3 (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0, 0; met_by_jets. Qed.
End cone_apex.

Module cone_apex_slip.
Import Torses.Part_Cones_printed.cone_apex_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Cones_proofs.cone_apex_slip.refuted; hnf; intros a'_u_ a_u_ p'1 p'2 p'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u; by_jets (all (fun t : R => (t - u) * a'_u_ + a_u_) (fun t : R => (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * r'_u_'3 + r_u_'3) p'1 p'2 p'3 u). Qed.
End cone_apex_slip.

Module planes_cone.
Import Torses.Part_Cones_printed.planes_cone.
Theorem proved : statement.
Proof. hnf; intros n'1 n'2 n'3 u x'1 x'2 x'3; by_jets (Torses.Part_Cones_proofs.planes_cone.proved (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u x'1 x'2 x'3). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Cones_proofs.planes_cone.met as [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u [x'1 [x'2 [x'3 there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u, x'1, x'2, x'3; there_by_jets there. Qed.
End planes_cone.
