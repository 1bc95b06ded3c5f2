(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Polar_printed Part_Polar_proofs.
Open Scope R_scope.

Module polar_first.
Import Torses.Part_Polar_printed.polar_first.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 p'1 p'2 p'3 u; by_jets (Torses.Part_Polar_proofs.polar_first.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) p'1 p'2 p'3 u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0, 0; met_by_jets. Qed.
End polar_first.

Module polar_second.
Import Torses.Part_Polar_printed.polar_second.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 p'1 p'2 p'3 u; by_jets (Torses.Part_Polar_proofs.polar_second.proved (Derive_n c'1 3 u) (Derive_n c'2 3 u) (Derive_n c'3 3 u) (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) p'1 p'2 p'3 u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0, 0; met_by_jets. Qed.
End polar_second.

Module polar_second_slip.
Import Torses.Part_Polar_printed.polar_second_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Polar_proofs.polar_second_slip.refuted; hnf; intros c'''_u_'1 c'''_u_'2 c'''_u_'3 c''_u_'1 c''_u_'2 c''_u_'3 c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 p'1 p'2 p'3 u; by_jets (all (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'1 / 6) + (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'2 / 6) + (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * (t - u) * (t - u) * (c'''_u_'3 / 6) + (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3) p'1 p'2 p'3 u). Qed.
End polar_second_slip.

Module polar_second_slip_corrected.
Import Torses.Part_Polar_printed.polar_second_slip_corrected.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 p'1 p'2 p'3 u; by_jets (Torses.Part_Polar_proofs.polar_second_slip_corrected.proved (Derive_n c'1 3 u) (Derive_n c'2 3 u) (Derive_n c'3 3 u) (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) p'1 p'2 p'3 u). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0, 0, 0; met_by_jets. Qed.
End polar_second_slip_corrected.
