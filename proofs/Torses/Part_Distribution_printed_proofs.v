(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Distribution_printed Part_Distribution_proofs.
Open Scope R_scope.

Module striction_parameter.
Import Torses.Part_Distribution_printed.striction_parameter.
Theorem proved : statement.
Proof. hnf; intros a c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Distribution_proofs.striction_parameter.proved (Derive_n a 1 u) (a u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Distribution_proofs.striction_parameter.met as [a'_u_ [a_u_ [c'_u_'1 [c'_u_'2 [c'_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * a'_u_ + a_u_), (fun t : R => (t - u) * c'_u_'1), (fun t : R => (t - u) * c'_u_'2), (fun t : R => (t - u) * c'_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_parameter.

Module striction_curvature.
Import Torses.Part_Distribution_printed.striction_curvature.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Distribution_proofs.striction_curvature.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Distribution_proofs.striction_curvature.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_curvature.
