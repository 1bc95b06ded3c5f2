(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Tangent_printed Part_Tangent_proofs.
Open Scope R_scope.

Module tangents_torse.
Import Torses.Part_Tangent_printed.tangents_torse.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Tangent_proofs.tangents_torse.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u)). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End tangents_torse.

Module tangents_normal.
Import Torses.Part_Tangent_printed.tangents_normal.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u v; by_jets (Torses.Part_Tangent_proofs.tangents_normal.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End tangents_normal.

Module tangents_edge.
Import Torses.Part_Tangent_printed.tangents_edge.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Tangent_proofs.tangents_edge.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End tangents_edge.

Module tangents_osculating.
Import Torses.Part_Tangent_printed.tangents_osculating.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u v; by_jets (Torses.Part_Tangent_proofs.tangents_osculating.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End tangents_osculating.

Module tangents_metric.
Import Torses.Part_Tangent_printed.tangents_metric.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u v; by_jets (Torses.Part_Tangent_proofs.tangents_metric.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) u v). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Tangent_proofs.tangents_metric.met as [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [u [v there]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3), u, v; there_by_jets there. Qed.
End tangents_metric.

Module tangents_metric_slip.
Import Torses.Part_Tangent_printed.tangents_metric_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Tangent_proofs.tangents_metric_slip.refuted; hnf; intros c''_u_'1 c''_u_'2 c''_u_'3 c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 u v; by_jets (all (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3) u v). Qed.
End tangents_metric_slip.
