(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Skew_printed Part_Skew_proofs.
Open Scope R_scope.

Module binormals_skew.
Import Torses.Part_Skew_printed.binormals_skew.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Skew_proofs.binormals_skew.proved (Derive_n c'1 3 u) (Derive_n c'2 3 u) (Derive_n c'3 3 u) (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Skew_proofs.binormals_skew.met as [c'''_u_'1 [c'''_u_'2 [c'''_u_'3 [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [u there]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'1 / 6) + (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1), (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'2 / 6) + (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2), (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'3 / 6) + (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3), u; there_by_jets there. Qed.
End binormals_skew.

Module conoid_skew.
Import Torses.Part_Skew_printed.conoid_skew.
Theorem proved : statement.
Proof. hnf; intros a u; by_jets (Torses.Part_Skew_proofs.conoid_skew.proved (Derive_n a 1 u) (a u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), 0; met_by_jets. Qed.
End conoid_skew.
