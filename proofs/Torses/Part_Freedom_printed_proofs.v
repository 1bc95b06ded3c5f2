(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Freedom_printed Part_Freedom_proofs.
Open Scope R_scope.

Module ruled_directrix.
Import Torses.Part_Freedom_printed.ruled_directrix.
Theorem proved : statement.
Proof. hnf; intros a c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Freedom_proofs.ruled_directrix.proved (Derive_n a 1 u) (a u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End ruled_directrix.

Module ruled_scaled.
Import Torses.Part_Freedom_printed.ruled_scaled.
Theorem proved : statement.
Proof. hnf; intros a c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Freedom_proofs.ruled_scaled.proved (Derive_n a 1 u) (a u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End ruled_scaled.

Module ruled_parameter.
Import Torses.Part_Freedom_printed.ruled_parameter.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi r'1 r'2 r'3 u; by_jets (Torses.Part_Freedom_proofs.ruled_parameter.proved (Derive_n c'1 1 (phi u)) (Derive_n c'2 1 (phi u)) (Derive_n c'3 1 (phi u)) (c'1 (phi u)) (c'2 (phi u)) (c'3 (phi u)) (Derive_n phi 1 u) (phi u) (Derive_n r'1 1 (phi u)) (Derive_n r'2 1 (phi u)) (Derive_n r'3 1 (phi u)) (r'1 (phi u)) (r'2 (phi u)) (r'3 (phi u)) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End ruled_parameter.

Module ruled_parameter_slip.
Import Torses.Part_Freedom_printed.ruled_parameter_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Freedom_proofs.ruled_parameter_slip.refuted; hnf; intros c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 phi'_u_ phi_u_ r'_phi_u__'1 r'_phi_u__'2 r'_phi_u__'3 r_phi_u__'1 r_phi_u__'2 r_phi_u__'3 u; by_jets (all (fun t : R => (t - phi_u_) * c'_phi_u__'1 + c_phi_u__'1) (fun t : R => (t - phi_u_) * c'_phi_u__'2 + c_phi_u__'2) (fun t : R => (t - phi_u_) * c'_phi_u__'3 + c_phi_u__'3) (fun t : R => (t - u) * phi'_u_ + phi_u_) (fun t : R => (t - phi_u_) * r'_phi_u__'1 + r_phi_u__'1) (fun t : R => (t - phi_u_) * r'_phi_u__'2 + r_phi_u__'2) (fun t : R => (t - phi_u_) * r'_phi_u__'3 + r_phi_u__'3) u). Qed.
End ruled_parameter_slip.

Module ruled_parameter_slip_corrected.
Import Torses.Part_Freedom_printed.ruled_parameter_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi r'1 r'2 r'3 u; by_jets (Torses.Part_Freedom_proofs.ruled_parameter_slip_corrected.proved (Derive_n c'1 1 (phi u)) (Derive_n c'2 1 (phi u)) (Derive_n c'3 1 (phi u)) (c'1 (phi u)) (c'2 (phi u)) (c'3 (phi u)) (Derive_n phi 1 u) (phi u) (Derive_n r'1 1 (phi u)) (Derive_n r'2 1 (phi u)) (Derive_n r'3 1 (phi u)) (r'1 (phi u)) (r'2 (phi u)) (r'3 (phi u)) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End ruled_parameter_slip_corrected.

Module ruled_ends.
Import Torses.Part_Freedom_printed.ruled_ends.
Theorem proved : statement.
Proof. hnf; intros b'1 b'2 b'3 c'1 c'2 c'3 u; by_jets (Torses.Part_Freedom_proofs.ruled_ends.proved (Derive_n b'1 1 u) (Derive_n b'2 1 u) (Derive_n b'3 1 u) (b'1 u) (b'2 u) (b'3 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End ruled_ends.

Module ruled_start.
Import Torses.Part_Freedom_printed.ruled_start.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3; by_jets (Torses.Part_Freedom_proofs.ruled_start.proved (Derive_n c'1 1 0) (Derive_n c'2 1 0) (Derive_n c'3 1 0) (c'1 0) (c'2 0) (c'3 0) (Derive_n r'1 1 0) (Derive_n r'2 1 0) (Derive_n r'3 1 0) (r'1 0) (r'2 0) (r'3 0)). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0); met_by_jets. Qed.
End ruled_start.
