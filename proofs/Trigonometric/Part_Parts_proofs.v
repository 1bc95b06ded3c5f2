(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Parts.
Open Scope R_scope.

Module angle_third.
Import Trigonometric.Part_Parts.angle_third.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intro y; replace (sin y) with (sin (y / 3 + y / 3 + y / 3)) by (f_equal; field); rewrite !sin_plus, !cos_plus; pose proof (sin2_cos2 (y / 3)) as E; unfold Rsqr in E; generalize dependent (sin (y / 3)); generalize dependent (cos (y / 3)); intros c s E; assert (F : c * c = 1 - s * s) by lra; ring [F]. Qed.
End angle_third.

Module angle_parts.
Import Trigonometric.Part_Parts.angle_parts.
Theorem proved : statement.
Proof. cbv beta delta [statement]; intros y z; replace (sin y) with (sin ((y / 2 + z / 3) + (y / 2 - z / 3))) by (f_equal; field); replace (sin (2 * z / 3)) with (sin ((y / 2 + z / 3) - (y / 2 - z / 3))) by (f_equal; field); rewrite (sin_plus (y / 2 + z / 3) (y / 2 - z / 3)), (sin_minus (y / 2 + z / 3) (y / 2 - z / 3)); ring. Qed.
End angle_parts.

Module angle_rate.
Import Trigonometric.Part_Parts.angle_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; identity. Qed.
End angle_rate.
