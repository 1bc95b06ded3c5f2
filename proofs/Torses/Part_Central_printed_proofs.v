(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Central_printed Part_Central_proofs.
Open Scope R_scope.

Module striction_shortest.
Import Torses.Part_Central_printed.striction_shortest.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Central_proofs.striction_shortest.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Central_proofs.striction_shortest.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_shortest.

Module striction_growth.
Import Torses.Part_Central_printed.striction_growth.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u v; by_jets (Torses.Part_Central_proofs.striction_growth.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u v). Qed.
Theorem met : instance.
Proof. hnf; exists (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), (fun _ : R => 0), 0, 0; met_by_jets. Qed.
End striction_growth.

Module striction_length.
Import Torses.Part_Central_printed.striction_length.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Central_proofs.striction_length.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Central_proofs.striction_length.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_length.

Module striction_scaled.
Import Torses.Part_Central_printed.striction_scaled.
Theorem proved : statement.
Proof. hnf; intros a c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Central_proofs.striction_scaled.proved (Derive_n a 1 u) (a u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Central_proofs.striction_scaled.met as [a'_u_ [a_u_ [c'_u_'1 [c'_u_'2 [c'_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * a'_u_ + a_u_), (fun t : R => (t - u) * c'_u_'1), (fun t : R => (t - u) * c'_u_'2), (fun t : R => (t - u) * c'_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_scaled.

Module striction_unit.
Import Torses.Part_Central_printed.striction_unit.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Central_proofs.striction_unit.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Central_proofs.striction_unit.met as [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r''_u_'1 [r''_u_'2 [r''_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End striction_unit.

Module striction_unit_slip.
Import Torses.Part_Central_printed.striction_unit_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Central_proofs.striction_unit_slip.refuted; hnf; intros c''_u_'1 c''_u_'2 c''_u_'3 c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 r''_u_'1 r''_u_'2 r''_u_'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u; by_jets (all (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3) (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3) u). Qed.
End striction_unit_slip.
