(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Trigonometric Require Part_Joins.
Import Trigonometric.Part_Joins.Definitions.
Open Scope R_scope.

Module quadratic_join.
Import Trigonometric.Part_Joins.quadratic_join.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement G F G_ a b c a_ b_ c_]; intros P R_ l l2 m m2 _ _ _ _; derivatives; rewrite ?sin_0, ?cos_0, ?sin_PI2, ?cos_PI2; intros A B N; apply (Rmult_eq_reg_l (1 + l2)); [ replace ((1 + l2) * (P 2%Z + (1 + m) / (1 + l2) * (P 2%Z - P 1%Z))) with ((1 + l2) * P 2%Z + (1 + m) * (P 2%Z - P 1%Z)) by (field; exact N); assert (E : R_ 0%Z = P 2%Z) by lra; rewrite E in B; lra | exact N ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance G F G_ a b c a_ b_ c_]; exists (fun _ => 0), (fun _ => 0), 0, 0, 0, 0; repeat split; try lra; derivatives; ring. Qed.
End quadratic_join.

Module quadratic_join_slip.
Import Trigonometric.Part_Joins.quadratic_join_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement a c b G a_ c_ b_ F G_] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (3/2) else 0) (0) (1) (0) (0)). Qed.
End quadratic_join_slip.

Module quadratic_join_slip_corrected.
Import Trigonometric.Part_Joins.quadratic_join_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b G a_ c_ b_ F G_]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b G a_ c_ b_ F G_]; first [(exists (fun _ => 2), (fun _ => 3), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 1), (fun _ => 1), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 3), ((-1) / 3), ((-1) / 3), ((-1) / 3); met)]. Qed.
End quadratic_join_slip_corrected.
