(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Edge_printed Part_Edge_proofs.
Open Scope R_scope.

Module regression_singular.
Import Torses.Part_Edge_printed.regression_singular.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Edge_proofs.regression_singular.proved (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.regression_singular.met as [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End regression_singular.

Module regression_tangent.
Import Torses.Part_Edge_printed.regression_tangent.
Theorem proved : statement.
Proof. hnf; intros c'1 c'2 c'3 r'1 r'2 r'3 u; by_jets (Torses.Part_Edge_proofs.regression_tangent.proved (Derive_n c'1 2 u) (Derive_n c'2 2 u) (Derive_n c'3 2 u) (Derive_n c'1 1 u) (Derive_n c'2 1 u) (Derive_n c'3 1 u) (c'1 u) (c'2 u) (c'3 u) (Derive_n r'1 2 u) (Derive_n r'2 2 u) (Derive_n r'3 2 u) (Derive_n r'1 1 u) (Derive_n r'2 1 u) (Derive_n r'3 1 u) (r'1 u) (r'2 u) (r'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.regression_tangent.met as [c''_u_'1 [c''_u_'2 [c''_u_'3 [c'_u_'1 [c'_u_'2 [c'_u_'3 [c_u_'1 [c_u_'2 [c_u_'3 [r''_u_'1 [r''_u_'2 [r''_u_'3 [r'_u_'1 [r'_u_'2 [r'_u_'3 [r_u_'1 [r_u_'2 [r_u_'3 [u there]]]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1), (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2), (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3), (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1), (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2), (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3), u; there_by_jets there. Qed.
End regression_tangent.

Module regression_tangent_slip.
Import Torses.Part_Edge_printed.regression_tangent_slip.
Theorem refuted : ~ statement.
Proof. intro all; apply Torses.Part_Edge_proofs.regression_tangent_slip.refuted; hnf; intros c''_u_'1 c''_u_'2 c''_u_'3 c'_u_'1 c'_u_'2 c'_u_'3 c_u_'1 c_u_'2 c_u_'3 r''_u_'1 r''_u_'2 r''_u_'3 r'_u_'1 r'_u_'2 r'_u_'3 r_u_'1 r_u_'2 r_u_'3 u; by_jets (all (fun t : R => (t - u) * (t - u) * (c''_u_'1 / 2) + (t - u) * c'_u_'1 + c_u_'1) (fun t : R => (t - u) * (t - u) * (c''_u_'2 / 2) + (t - u) * c'_u_'2 + c_u_'2) (fun t : R => (t - u) * (t - u) * (c''_u_'3 / 2) + (t - u) * c'_u_'3 + c_u_'3) (fun t : R => (t - u) * (t - u) * (r''_u_'1 / 2) + (t - u) * r'_u_'1 + r_u_'1) (fun t : R => (t - u) * (t - u) * (r''_u_'2 / 2) + (t - u) * r'_u_'2 + r_u_'2) (fun t : R => (t - u) * (t - u) * (r''_u_'3 / 2) + (t - u) * r'_u_'3 + r_u_'3) u). Qed.
End regression_tangent_slip.

Module planes_edge.
Import Torses.Part_Edge_printed.planes_edge.
Theorem proved : statement.
Proof. hnf; intros d n'1 n'2 n'3 u x'1 x'2 x'3; by_jets (Torses.Part_Edge_proofs.planes_edge.proved (Derive_n d 2 u) (Derive_n d 1 u) (d u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u x'1 x'2 x'3). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.planes_edge.met as [d''_u_ [d'_u_ [d_u_ [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u [x'1 [x'2 [x'3 there]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (d''_u_ / 2) + (t - u) * d'_u_ + d_u_), (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u, x'1, x'2, x'3; there_by_jets there. Qed.
End planes_edge.

Module planes_edge_in.
Import Torses.Part_Edge_printed.planes_edge_in.
Theorem proved : statement.
Proof. hnf; intros d n'1 n'2 n'3 u; by_jets (Torses.Part_Edge_proofs.planes_edge_in.proved (Derive_n d 2 u) (Derive_n d 1 u) (d u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.planes_edge_in.met as [d''_u_ [d'_u_ [d_u_ [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u there]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (d''_u_ / 2) + (t - u) * d'_u_ + d_u_), (fun t : R => (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u; there_by_jets there. Qed.
End planes_edge_in.

Module planes_edge_tangent.
Import Torses.Part_Edge_printed.planes_edge_tangent.
Theorem proved : statement.
Proof. hnf; intros d n'1 n'2 n'3 u; by_jets (Torses.Part_Edge_proofs.planes_edge_tangent.proved (Derive_n d 3 u) (Derive_n d 2 u) (Derive_n d 1 u) (d u) (Derive_n n'1 3 u) (Derive_n n'2 3 u) (Derive_n n'3 3 u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.planes_edge_tangent.met as [d'''_u_ [d''_u_ [d'_u_ [d_u_ [n'''_u_'1 [n'''_u_'2 [n'''_u_'3 [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u there]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (t - u) * (d'''_u_ / 6) + (t - u) * (t - u) * (d''_u_ / 2) + (t - u) * d'_u_ + d_u_), (fun t : R => (t - u) * (t - u) * (t - u) * (n'''_u_'1 / 6) + (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (t - u) * (n'''_u_'2 / 6) + (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (t - u) * (n'''_u_'3 / 6) + (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u; there_by_jets there. Qed.
End planes_edge_tangent.

Module planes_edge_osculating.
Import Torses.Part_Edge_printed.planes_edge_osculating.
Theorem proved : statement.
Proof. hnf; intros d n'1 n'2 n'3 u; by_jets (Torses.Part_Edge_proofs.planes_edge_osculating.proved (Derive_n d 4 u) (Derive_n d 3 u) (Derive_n d 2 u) (Derive_n d 1 u) (d u) (Derive_n n'1 4 u) (Derive_n n'2 4 u) (Derive_n n'3 4 u) (Derive_n n'1 3 u) (Derive_n n'2 3 u) (Derive_n n'3 3 u) (Derive_n n'1 2 u) (Derive_n n'2 2 u) (Derive_n n'3 2 u) (Derive_n n'1 1 u) (Derive_n n'2 1 u) (Derive_n n'3 1 u) (n'1 u) (n'2 u) (n'3 u) u). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Edge_proofs.planes_edge_osculating.met as [d''''_u_ [d'''_u_ [d''_u_ [d'_u_ [d_u_ [n''''_u_'1 [n''''_u_'2 [n''''_u_'3 [n'''_u_'1 [n'''_u_'2 [n'''_u_'3 [n''_u_'1 [n''_u_'2 [n''_u_'3 [n'_u_'1 [n'_u_'2 [n'_u_'3 [n_u_'1 [n_u_'2 [n_u_'3 [u there]]]]]]]]]]]]]]]]]]]]]; hnf; exists (fun t : R => (t - u) * (t - u) * (t - u) * (t - u) * (d''''_u_ / 24) + (t - u) * (t - u) * (t - u) * (d'''_u_ / 6) + (t - u) * (t - u) * (d''_u_ / 2) + (t - u) * d'_u_ + d_u_), (fun t : R => (t - u) * (t - u) * (t - u) * (t - u) * (n''''_u_'1 / 24) + (t - u) * (t - u) * (t - u) * (n'''_u_'1 / 6) + (t - u) * (t - u) * (n''_u_'1 / 2) + (t - u) * n'_u_'1 + n_u_'1), (fun t : R => (t - u) * (t - u) * (t - u) * (t - u) * (n''''_u_'2 / 24) + (t - u) * (t - u) * (t - u) * (n'''_u_'2 / 6) + (t - u) * (t - u) * (n''_u_'2 / 2) + (t - u) * n'_u_'2 + n_u_'2), (fun t : R => (t - u) * (t - u) * (t - u) * (t - u) * (n''''_u_'3 / 24) + (t - u) * (t - u) * (t - u) * (n'''_u_'3 / 6) + (t - u) * (t - u) * (n''_u_'3 / 2) + (t - u) * n'_u_'3 + n_u_'3), u; there_by_jets there. Qed.
End planes_edge_osculating.
