(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Normal_printed Part_Normal_proofs.
Open Scope R_scope.

Module ruled_normal.
Import Torses.Part_Normal_printed.ruled_normal.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Normal_proofs.ruled_normal.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_normal.

Module ruled_turn.
Import Torses.Part_Normal_printed.ruled_turn.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Normal_proofs.ruled_turn.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0; met_by_jets. Qed.
End ruled_turn.

Module ruled_turn_slip.
Import Torses.Part_Normal_printed.ruled_turn_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Normal_proofs.ruled_turn_slip.refuted; hnf; intros c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u v1 v2; by_jets (all (fun t : R => (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * c'_u_'3 + c_u_'3) (fun t : R => (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * r'_u_'3 + r_u_'3) u v1 v2). Qed.
End ruled_turn_slip.

Module ruled_turn_slip_corrected.
Import Torses.Part_Normal_printed.ruled_turn_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Normal_proofs.ruled_turn_slip_corrected.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0; met_by_jets. Qed.
End ruled_turn_slip_corrected.

Module ruled_chasles.
Import Torses.Part_Normal_printed.ruled_chasles.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Normal_proofs.ruled_chasles.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0; met_by_jets. Qed.
End ruled_chasles.
