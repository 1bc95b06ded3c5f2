(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Curves_printed Part_Curves_proofs.
Open Scope R_scope.

Module curve_chain.
Import Torses.Part_Curves_printed.curve_chain.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi u; by_jets (Torses.Part_Curves_proofs.curve_chain.proved (Derive_n c'1 2 (phi u)) (Derive_n c'2 2 (phi u)) (Derive_n c'3 2 (phi u)) (Derive_n c'1 1 (phi u)) (Derive_n c'2 1 (phi u)) (Derive_n c'3 1 (phi u)) (c'1 (phi u)) (c'2 (phi u)) (c'3 (phi u)) (Derive_n phi 2 u) (Derive_n phi 1 u) (phi u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End curve_chain.

Module curve_chain_slip.
Import Torses.Part_Curves_printed.curve_chain_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Curves_proofs.curve_chain_slip.refuted; hnf; intros c''_phi_u__'1 c''_phi_u__'2 c''_phi_u__'3 c'_phi_u__'1 c'_phi_u__'2 c'_phi_u__'3 c_phi_u__'1 c_phi_u__'2 c_phi_u__'3 phi''_u_ phi'_u_ phi_u_ u; by_jets (all (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'1 / 2) + (t - phi_u_) * c'_phi_u__'1 + c_phi_u__'1) (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'2 / 2) + (t - phi_u_) * c'_phi_u__'2 + c_phi_u__'2) (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'3 / 2) + (t - phi_u_) * c'_phi_u__'3 + c_phi_u__'3) (fun t : R => (t - u) * (t - u) * (phi''_u_ / 2) + (t - u) * phi'_u_ + phi_u_) u). Qed.
End curve_chain_slip.

Module curve_chain_slip_corrected.
Import Torses.Part_Curves_printed.curve_chain_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi u; by_jets (Torses.Part_Curves_proofs.curve_chain_slip_corrected.proved (Derive_n c'1 2 (phi u)) (Derive_n c'2 2 (phi u)) (Derive_n c'3 2 (phi u)) (Derive_n c'1 1 (phi u)) (Derive_n c'2 1 (phi u)) (Derive_n c'3 1 (phi u)) (c'1 (phi u)) (c'2 (phi u)) (c'3 (phi u)) (Derive_n phi 2 u) (Derive_n phi 1 u) (phi u) u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0; met_by_jets. Qed.
End curve_chain_slip_corrected.

Module curve_curvature.
Import Torses.Part_Curves_printed.curve_curvature.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi u; by_jets (Torses.Part_Curves_proofs.curve_curvature.proved (Derive_n c'1 2 (phi u)) (Derive_n c'2 2 (phi u)) (Derive_n c'3 2 (phi u)) (Derive_n c'1 1 (phi u)) (Derive_n c'2 1 (phi u)) (Derive_n c'3 1 (phi u)) (c'1 (phi u)) (c'2 (phi u)) (c'3 (phi u)) (Derive_n phi 2 u) (Derive_n phi 1 u) (phi u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Curves_proofs.curve_curvature.met as [c''_phi_u__'1 [c''_phi_u__'2 [c''_phi_u__'3 [c'_phi_u__'1 [c'_phi_u__'2 [c'_phi_u__'3 [c_phi_u__'1 [c_phi_u__'2 [c_phi_u__'3 [phi''_u_ [phi'_u_ [phi_u_ [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'1 / 2) + (t - phi_u_) * c'_phi_u__'1 + c_phi_u__'1), (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'2 / 2) + (t - phi_u_) * c'_phi_u__'2 + c_phi_u__'2), (fun t : R => (t - phi_u_) * (t - phi_u_) * (c''_phi_u__'3 / 2) + (t - phi_u_) * c'_phi_u__'3 + c_phi_u__'3), (fun t : R => (t - u) * (t - u) * (phi''_u_ / 2) + (t - u) * phi'_u_ + phi_u_), u; there_by_jets there. Qed.
End curve_curvature.

Module curve_torsion.
Import Torses.Part_Curves_printed.curve_torsion.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 phi u; computed_by_jets; match goal with |- ?a / ?b = ?c / ?d => replace a with (Derive_n phi 1 u ^ 6 * c) by ring; replace b with (Derive_n phi 1 u ^ 6 * d) by ring; let q := fresh in generalize dependent d; intros q ?; intros; field; split; assumption end. Qed.
Theorem met : instance.
Proof. hnf; exists (fun t => t), (fun t => t * t), (fun _ => 0), (fun t => t), 0; values_by_jets. Qed.
End curve_torsion.

Module curve_straight.
Import Torses.Part_Curves_printed.curve_straight.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 u; by_jets (Torses.Part_Curves_proofs.curve_straight.proved (Derive_n c'1 3 u) (Derive_n c'2 3 u) (Derive_n c'3 3 u) (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u)). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Curves_proofs.curve_straight.met as [c'''_u_'1 [c'''_u_'2 [c'''_u_'3 [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 there]]]]]]]]]; hnf; exists (fun t : R => (t - 0) * (t - 0) * (t - 0) * (c'''_u_'1 / 6) + (t - 0) * (t - 0) * (c''_u_'1 / 2) + (t - 0) * c'_u_'1), (fun t : R => (t - 0) * (t - 0) * (t - 0) * (c'''_u_'2 / 6) + (t - 0) * (t - 0) * (c''_u_'2 / 2) + (t - 0) * c'_u_'2), (fun t : R => (t - 0) * (t - 0) * (t - 0) * (c'''_u_'3 / 6) + (t - 0) * (t - 0) * (c''_u_'3 / 2) + (t - 0) * c'_u_'3), 0; there_by_jets there. Qed.
End curve_straight.
