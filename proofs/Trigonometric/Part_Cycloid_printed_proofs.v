(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Trigonometric Require Part_Cycloid_printed Part_Cycloid_proofs.
Open Scope R_scope.

Module cycloid_speed.
Import Trigonometric.Part_Cycloid_printed.cycloid_speed.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_speed.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_speed.met. Qed.
End cycloid_speed.

Module cycloid_regular.
Import Trigonometric.Part_Cycloid_printed.cycloid_regular.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_regular.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_regular.met. Qed.
End cycloid_regular.

Module cycloid_slope.
Import Trigonometric.Part_Cycloid_printed.cycloid_slope.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_slope.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_slope.met. Qed.
End cycloid_slope.

Module cycloid_slope_slip.
Import Trigonometric.Part_Cycloid_printed.cycloid_slope_slip.
Theorem refuted : ~ statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip.refuted. Qed.
End cycloid_slope_slip.

Module cycloid_slope_slip_corrected.
Import Trigonometric.Part_Cycloid_printed.cycloid_slope_slip_corrected.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.met. Qed.
End cycloid_slope_slip_corrected.

Module cycloid_bend.
Import Trigonometric.Part_Cycloid_printed.cycloid_bend.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_bend.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_bend.met. Qed.
End cycloid_bend.

Module cycloid_curvature.
Import Trigonometric.Part_Cycloid_printed.cycloid_curvature.
Theorem proved : statement.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_curvature.proved. Qed.
Theorem met : instance.
Proof. follows Trigonometric.Part_Cycloid_proofs.cycloid_curvature.met. Qed.
End cycloid_curvature.
