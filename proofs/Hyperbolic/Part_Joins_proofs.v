(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Hyperbolic Require Part_Joins.
Open Scope R_scope.

Module join_C1.
Import Hyperbolic.Part_Joins.join_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h G f_ g_ h_ F G_]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h G f_ g_ h_ F G_]; first [(exists (fun _ => 2), (fun _ => 3), (1), (1); met) | (exists (fun _ => 0), (fun _ => 0), (1), (1); met)]. Qed.
End join_C1.

Module join_C1_slip.
Import Hyperbolic.Part_Joins.join_C1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f g h G f_ g_ h_ F G_] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2*(exp(1)^2*exp(1/2)^2 - 1)/((exp(1)^2 + 1)*(exp(1/2)^2 - 1))) else 0) (1) (2)). Qed.
End join_C1_slip.

Module join_C1_slip_corrected.
Import Hyperbolic.Part_Joins.join_C1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h G f_ g_ h_ F G_]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h G f_ g_ h_ F G_]; first [(exists (fun _ => 2), (fun _ => 3), (1), (1); met) | (exists (fun _ => 0), (fun _ => 0), (1), (1); met)]. Qed.
End join_C1_slip_corrected.

Module join_C2.
Import Hyperbolic.Part_Joins.join_C2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h G f_ g_ h_ F G_]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); unknown (R_ 2%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h G f_ g_ h_ F G_]; first [(exists (fun _ => 2), (fun _ => 3), (1), (1); met) | (exists (fun _ => 0), (fun _ => 0), (1), (1); met)]. Qed.
End join_C2.

Module shape_join.
Import Hyperbolic.Part_Joins.shape_join.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h G F G_ F_ s2 s]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance h G F G_ F_ s2 s]; first [(exists (2)%Z, (2)%Z, (fun _ => 4), (fun _ => 5), (1), (1); met) | (exists (2)%Z, (2)%Z, (fun _ => 0), (fun _ => 0), (1), (1); met)]. Qed.
End shape_join.
