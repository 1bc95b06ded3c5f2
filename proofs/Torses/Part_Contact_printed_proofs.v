(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Contact_printed Part_Contact_proofs.
Open Scope R_scope.

Module ruled_touch.
Import Torses.Part_Contact_printed.ruled_touch.
Theorem proved : statement.
Proof. hnf; intros b'1 b'2 b'3 c'1 c'2 c'3 q'1 q'2 q'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Contact_proofs.ruled_touch.proved (Derive_n b'1 1 u) (Derive_n b'2 1 u) (Derive_n b'3 1 u) (b'1 u) (b'2 u) (b'3 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n q'1 1 u) (Derive_n q'2 1 u) (Derive_n q'3 1 u) (q'1 u) (q'2 u) (q'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Contact_proofs.ruled_touch.met as [b'_u_'1 [b'_u_'2 [b'_u_'3 [b_u_'1 [b_u_'2 [b_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [q'_u_'1 [q'_u_'2 [q'_u_'3 [q_u_'1 [q_u_'2 [q_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u [v there]]]]]]]]]]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * b'_u_'1 + b_u_'1), (fun t : R => (t - u) * b'_u_'2 + b_u_'2), (fun t : R => (t - u) * b'_u_'3 + b_u_'3), (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * q'_u_'1 + q_u_'1), (fun t : R => (t - u) * q'_u_'2 + q_u_'2), (fun t : R => (t - u) * q'_u_'3 + q_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u, v; there_by_jets there. Qed.
End ruled_touch.
