(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtDevelopable Require Section_5_5_printed Section_5_5_proofs.
Open Scope R_scope.

Module ex_5_1_construct.
Import GbtDevelopable.Section_5_5_printed.ex_5_1_construct.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.met. Qed.
End ex_5_1_construct.

Module ex_5_1_shape_shape.
Import GbtDevelopable.Section_5_5_printed.ex_5_1_shape_shape.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.met. Qed.
End ex_5_1_shape_shape.

Module ex_5_1_shape_combined_surface.
Import GbtDevelopable.Section_5_5_printed.ex_5_1_shape_combined_surface.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_combined_surface.refuted. Qed.
End ex_5_1_shape_combined_surface.

Module ex_5_2_Q02.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_Q02.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.met. Qed.
End ex_5_2_Q02.

Module ex_5_2_Q12.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_Q12.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.met. Qed.
End ex_5_2_Q12.

Module ex_5_2_Q22.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_Q22.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.met. Qed.
End ex_5_2_Q22.

Module ex_5_2_gamma_one.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_gamma_one.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.met. Qed.
End ex_5_2_gamma_one.

Module ex_5_2_gap_surfaces.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_gap_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_surfaces.refuted. Qed.
End ex_5_2_gap_surfaces.

Module ex_5_2_gap_drawn_pieces.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_gap_drawn_pieces.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.met. Qed.
End ex_5_2_gap_drawn_pieces.

Module ex_5_2_one_line.
Import GbtDevelopable.Section_5_5_printed.ex_5_2_one_line.
Theorem proved : statement.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.proved. Qed.
Theorem met : instance.
Proof. follows GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.met. Qed.
End ex_5_2_one_line.
