(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From GbtDevelopable Require Part_Abstract.
Import GbtDevelopable.Part_Abstract.Definitions.
Open Scope R_scope.

Module abs_conics_planes.
Import GbtDevelopable.Part_Abstract.abs_conics_planes.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement]; intro no; apply (no 0 ltac:(lra)); clear no; intros u U _; assert (D : vDerive 4 (fun u_ => bernstein_family u_) 1 u = [- 2 * u; 2; 0; 2 * u]) by (cbv delta [bernstein_family]; lists; parts; apply is_derive_unique; auto_derive; try exact I; ring); assert (V : bernstein_family u = [1 - u * u; 2 * u; 0; 1 + u * u]) by (cbv delta [bernstein_family]; lists; parts; ring); cbv delta [profile foot direction moment normal]; cbv beta; rewrite D, V; assert (X : 1 + u * u <> 0) by nra; lists; split; field; (try exact X); nra. Qed.
End abs_conics_planes.

Module abs_conics_points.
Import GbtDevelopable.Part_Abstract.abs_conics_points.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement points]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance points]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (1 / 3); met) | (exists 7, 7, 2, 7, 7, 2, 7, 7, 2, (1 / 3); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3); met)]. Qed.
End abs_conics_points.

Module abs_4d_factor.
Import GbtDevelopable.Part_Abstract.abs_4d_factor.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal direction moment foot midpoint]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal direction moment foot midpoint]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (7); met) | (exists 4, 13, 8, 8, 13, 8, 8, 6, (1); met) | (exists 1, 0, 0, 0, 0, 1, 0, 0, (1); met)]. Qed.
End abs_4d_factor.
