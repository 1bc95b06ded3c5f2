(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Rectifying_printed Part_Rectifying_proofs.
Open Scope R_scope.

Module rectifying_contains.
Import Torses.Part_Rectifying_printed.rectifying_contains.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Rectifying_proofs.rectifying_contains.proved (Derive_n c'1 3 u) (Derive_n c'2 3 u) (Derive_n c'3 3 u) (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End rectifying_contains.

Module rectifying_geodesic.
Import Torses.Part_Rectifying_printed.rectifying_geodesic.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Rectifying_proofs.rectifying_geodesic.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End rectifying_geodesic.
