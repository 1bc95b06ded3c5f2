(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Hyperbolic Require Part_Catenoid.
Import Hyperbolic.Part_Catenoid.Definitions.
Open Scope R_scope.

Module catenoid_conformal.
Import Hyperbolic.Part_Catenoid.catenoid_conformal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_conformal.

Module catenoid_minimal.
Import Hyperbolic.Part_Catenoid.catenoid_minimal.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_minimal.

Module catenoid_gauss.
Import Hyperbolic.Part_Catenoid.catenoid_gauss.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; identity. Qed.
End catenoid_gauss.

Module catenoid_regular.
Import Hyperbolic.Part_Catenoid.catenoid_regular.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement X]; compute_goal; intros u v; derivatives; pose proof (exp_inverse v) as E; pose proof (sin2_cos2 u) as F; unfold Rsqr in F; pose proof (exp_pos v); pose proof (exp_pos (- v)); generalize dependent (exp v); generalize dependent (exp (- v)); generalize dependent (sin u); generalize dependent (cos u); intros c s F m M e E P; assert (G : s * s = 1 - c * c) by lra; apply Rlt_gt, Rlt_le_trans with (((e + m) / 2) ^ 4); [ apply pow_lt; lra | right; field_simplify_eq; ring [E G] ]. Qed.
End catenoid_regular.
