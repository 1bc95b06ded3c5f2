(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Torses_printed Part_Torses_proofs.
Open Scope R_scope.

Module ruled_torse_sufficient.
Import Torses.Part_Torses_printed.ruled_torse_sufficient.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Torses_proofs.ruled_torse_sufficient.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Torses_proofs.ruled_torse_sufficient.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v1 [v2 there]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u, v1, v2; there_by_jets there. Qed.
End ruled_torse_sufficient.

Module ruled_torse_necessary.
Import Torses.Part_Torses_printed.ruled_torse_necessary.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Torses_proofs.ruled_torse_necessary.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Torses_proofs.ruled_torse_necessary.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v1 [v2 there]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u, v1, v2; there_by_jets there. Qed.
End ruled_torse_necessary.

Module ruled_rodrigues.
Import Torses.Part_Torses_printed.ruled_rodrigues.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Torses_proofs.ruled_rodrigues.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End ruled_rodrigues.
