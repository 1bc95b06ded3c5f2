(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Cylinders_printed Part_Cylinders_proofs.
Open Scope R_scope.

Module cylinder_torse.
Import Torses.Part_Cylinders_printed.cylinder_torse.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Cylinders_proofs.cylinder_torse.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Cylinders_proofs.cylinder_torse.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1), (fun t : R => (t - u) * c'_u_'2), (fun t : R => (t - u) * c'_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End cylinder_torse.

Module cylinder_normal.
Import Torses.Part_Cylinders_printed.cylinder_normal.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v1 v2; by_jets (Torses.Part_Cylinders_proofs.cylinder_normal.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v1 v2). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Cylinders_proofs.cylinder_normal.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v1 [v2 there]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u, v1, v2; there_by_jets there. Qed.
End cylinder_normal.

Module cylinder_converse_slip.
Import Torses.Part_Cylinders_printed.cylinder_converse_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Cylinders_proofs.cylinder_converse_slip.refuted; hnf; intros c'_u_'1 c'_u_'2 c'_u_'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u; by_jets (all (fun t : R => (t - u) * c'_u_'1) (fun t : R => (t - u) * c'_u_'2) (fun t : R => (t - u) * c'_u_'3) (fun t : R => (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * r'_u_'3 + r_u_'3) u). Qed.
End cylinder_converse_slip.
