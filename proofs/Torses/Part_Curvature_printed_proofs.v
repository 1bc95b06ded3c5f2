(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Curvature_printed Part_Curvature_proofs.
Open Scope R_scope.

Module ruled_asymptotic.
Import Torses.Part_Curvature_printed.ruled_asymptotic.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_asymptotic.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_asymptotic.

Module ruled_mixed.
Import Torses.Part_Curvature_printed.ruled_mixed.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_mixed.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_mixed.

Module ruled_lagrange.
Import Torses.Part_Curvature_printed.ruled_lagrange.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_lagrange.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_lagrange.

Module ruled_gauss.
Import Torses.Part_Curvature_printed.ruled_gauss.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_gauss.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_gauss.

Module ruled_gauss_curvature.
Import Torses.Part_Curvature_printed.ruled_gauss_curvature.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_gauss_curvature.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Curvature_proofs.ruled_gauss_curvature.met as [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r''_u_'1 [r''_u_'2 [r''_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v there]]]]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3), u, v; there_by_jets there. Qed.
End ruled_gauss_curvature.

Module ruled_gauss_sign.
Import Torses.Part_Curvature_printed.ruled_gauss_sign.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_gauss_sign.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_gauss_sign.

Module ruled_gauss_slip.
Import Torses.Part_Curvature_printed.ruled_gauss_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Curvature_proofs.ruled_gauss_slip.refuted; hnf; intros c''_u_'1 c''_u_'2 c''_u_'3 c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 r''_u_'1 r''_u_'2 r''_u_'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u v; by_jets (all (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3) (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3) u v). Qed.
End ruled_gauss_slip.

Module ruled_gauss_slip_corrected.
Import Torses.Part_Curvature_printed.ruled_gauss_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Curvature_proofs.ruled_gauss_slip_corrected.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_gauss_slip_corrected.
