(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Hyperbolic Require Part_Logarithmic.
Open Scope R_scope.

Module spiral_angle.
Import Hyperbolic.Part_Logarithmic.spiral_angle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
End spiral_angle.

Module spiral_angle_slip.
Import Hyperbolic.Part_Logarithmic.spiral_angle_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement S_] in no; refuting (no (1) (1)). Qed.
End spiral_angle_slip.

Module spiral_regular.
Import Hyperbolic.Part_Logarithmic.spiral_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; ordered. Qed.
End spiral_regular.

Module spiral_curvature.
Import Hyperbolic.Part_Logarithmic.spiral_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance S_]; first [(exists (2), (3); met) | (exists (0), (0); met)]. Qed.
End spiral_curvature.
