(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_Curves.
Import Hyperbolic.Part_Curves.Definitions.
Open Scope R_scope.

Module curve_ends.
Import Hyperbolic.Part_Curves.curve_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F f_ g_ h_ F_]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h F f_ g_ h_ F_]; first [(exists (fun _ => 2), (1); met) | (exists (fun _ => 0), (1); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End curve_ends.

Module curve_d1.
Import Hyperbolic.Part_Curves.curve_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h F]; first [(exists (fun _ => 2), (1); met) | (exists (fun _ => 0), (1); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End curve_d1.

Module curve_d1_slip.
Import Hyperbolic.Part_Curves.curve_d1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f g h F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else 0) (1)). Qed.
End curve_d1_slip.

Module curve_d1_slip_corrected.
Import Hyperbolic.Part_Curves.curve_d1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h F]; first [(exists (fun _ => 2), (1); met) | (exists (fun _ => 0), (1); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End curve_d1_slip_corrected.

Module curve_d2.
Import Hyperbolic.Part_Curves.curve_d2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h F]; first [(exists (fun _ => 2), (1); met) | (exists (fun _ => 0), (1); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End curve_d2.

Module curve_middle.
Import Hyperbolic.Part_Curves.curve_middle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h F]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h F]; first [(exists (fun _ => 2), (1); met) | (exists (fun _ => 0), (1); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (8); met) | (exists (fun _ => 1), (1); met) | (exists (fun _ => 0), (1); met)]. Qed.
End curve_middle.

Module curve_middle_slip.
Import Hyperbolic.Part_Curves.curve_middle_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement f g h F] in no; refuting (no (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (1) else 0) (1)). Qed.
End curve_middle_slip.

Module shape_ends.
Import Hyperbolic.Part_Curves.shape_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h F]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance h F]; first [(exists (2)%Z, (fun _ => 3), (1); met) | (exists (2)%Z, (fun _ => 0), (1); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8); met) | (exists (2)%Z, (fun _ => 1), (1); met) | (exists (2)%Z, (fun _ => 0), (1); met)]. Qed.
End shape_ends.

Module shape_d1.
Import Hyperbolic.Part_Curves.shape_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h F s]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance h F s]; first [(exists (2)%Z, (fun _ => 3), (1); met) | (exists (2)%Z, (fun _ => 0), (1); met) | (exists (2)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8); met) | (exists (2)%Z, (fun _ => 1), (1); met) | (exists (2)%Z, (fun _ => 0), (1); met)]. Qed.
End shape_d1.

Module shape_slope.
Import Hyperbolic.Part_Curves.shape_slope.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement s]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance s]; first [(exists (1); met) | (exists (1); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End shape_slope.
