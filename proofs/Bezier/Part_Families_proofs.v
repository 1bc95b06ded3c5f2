(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Families.
Import Bezier.Part_Families.Definitions.
Open Scope R_scope.

Module family_corner.
Import Bezier.Part_Families.family_corner.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B Q]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B Q]; first [(exists (3)%Z, (fun _ => 3), (4), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), (1), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (1), (1 / 3); met)]. Qed.
End family_corner.

Module family_casteljau.
Import Bezier.Part_Families.family_casteljau.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B Q]; symbolic. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, (fun _ => 0), 0, 0; repeat split; intros; (lra || lia). Qed.
End family_casteljau.

Module family_casteljau_slip.
Import Bezier.Part_Families.family_casteljau_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B Q] in no; refuting (no ((3))%Z (fun i0 => if (Z.eqb i0 (0))%bool then (0) else if (Z.eqb i0 (1))%bool then (1) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (0) else if (Z.eqb i0 (4))%bool then (0) else 0) (1) (0)). Qed.
End family_casteljau_slip.

Module family_weights.
Import Bezier.Part_Families.family_weights.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement W B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance W B]; first [(exists (3)%Z, (fun _ => 3), (1), (fun _ => 5), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (1), (fun _ => 0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), (8), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), (1), (fun _ => 1), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (1), (fun _ => 0), (1 / 3); met)]. Qed.
End family_weights.
