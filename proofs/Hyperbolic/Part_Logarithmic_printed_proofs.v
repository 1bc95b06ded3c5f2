(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From Hyperbolic Require Part_Logarithmic_printed Part_Logarithmic_proofs.
Open Scope R_scope.

Module spiral_angle.
Import Hyperbolic.Part_Logarithmic_printed.spiral_angle.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Logarithmic_proofs.spiral_angle.proved. Qed.
End spiral_angle.

Module spiral_angle_slip.
Import Hyperbolic.Part_Logarithmic_printed.spiral_angle_slip.
Theorem refuted : ~ statement.
Proof. follows Hyperbolic.Part_Logarithmic_proofs.spiral_angle_slip.refuted. Qed.
End spiral_angle_slip.

Module spiral_regular.
Import Hyperbolic.Part_Logarithmic_printed.spiral_regular.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Logarithmic_proofs.spiral_regular.proved. Qed.
End spiral_regular.

Module spiral_curvature.
Import Hyperbolic.Part_Logarithmic_printed.spiral_curvature.
Theorem proved : statement.
Proof. follows Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.proved. Qed.
Theorem met : instance.
Proof. follows Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.met. Qed.
End spiral_curvature.
