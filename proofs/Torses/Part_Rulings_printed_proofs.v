(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Rulings_printed Part_Rulings_proofs.
Open Scope R_scope.

Module planes_ruling.
Import Torses.Part_Rulings_printed.planes_ruling.
Theorem proved : statement.
Proof. hnf; intros n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_ruling.proved (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u)). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End planes_ruling.

Module planes_turn.
Import Torses.Part_Rulings_printed.planes_turn.
Theorem proved : statement.
Proof. hnf; intros n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_turn.proved (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End planes_turn.

Module planes_turn_slip.
Import Torses.Part_Rulings_printed.planes_turn_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Rulings_proofs.planes_turn_slip.refuted; hnf; intros n''_u_'1 n''_u_'2 n''_u_'3 n'_u_'1 n'_u_'2 n'_u_'3 n_u_'1 n_u_'2 n_u_'3 u; by_jets (all (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1) (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2) (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3) u). Qed.
End planes_turn_slip.

Module planes_turn_slip_corrected.
Import Torses.Part_Rulings_printed.planes_turn_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_turn_slip_corrected.proved (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End planes_turn_slip_corrected.

Module planes_cylinder.
Import Torses.Part_Rulings_printed.planes_cylinder.
Theorem proved : statement.
Proof. hnf; intros n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_cylinder.proved (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Rulings_proofs.planes_cylinder.met as [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u there]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u; there_by_jets there. Qed.
End planes_cylinder.

Module planes_scaled.
Import Torses.Part_Rulings_printed.planes_scaled.
Theorem proved : statement.
Proof. hnf; intros a n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_scaled.proved (Derive_n a 2 u) (Derive_n a 1 u) (a u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End planes_scaled.

Module planes_scaled_slip.
Import Torses.Part_Rulings_printed.planes_scaled_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Rulings_proofs.planes_scaled_slip.refuted; hnf; intros a''_u_ a'_u_ a_u_ n''_u_'1 n''_u_'2 n''_u_'3 n'_u_'1 n'_u_'2 n'_u_'3 n_u_'1 n_u_'2 n_u_'3 u; by_jets (all (fun t : R => (t - u) * (t - u) * (a''_u_ / 2) + (t - u) * a'_u_ + a_u_) (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1) (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2) (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3) u). Qed.
End planes_scaled_slip.

Module planes_scaled_slip_corrected.
Import Torses.Part_Rulings_printed.planes_scaled_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros a n'1 n'2 n'3 u; by_jets (Torses.Part_Rulings_proofs.planes_scaled_slip_corrected.proved (Derive_n a 2 u) (Derive_n a 1 u) (a u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End planes_scaled_slip_corrected.

Module planes_dual.
Import Torses.Part_Rulings_printed.planes_dual.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Rulings_proofs.planes_dual.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Rulings_proofs.planes_dual.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v there]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u, v; there_by_jets there. Qed.
End planes_dual.
