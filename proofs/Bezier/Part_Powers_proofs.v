(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From Bezier Require Part_Powers.
Open Scope R_scope.

Module power_next.
Import Bezier.Part_Powers.power_next.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 2); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met)]. Qed.
End power_next.

Module power_rate.
Import Bezier.Part_Powers.power_rate.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 2); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met)]. Qed.
End power_rate.

Module power_rate_slip.
Import Bezier.Part_Powers.power_rate_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement] in no; refuting (no ((3))%Z (0)). Qed.
End power_rate_slip.

Module power_rate_slip_corrected.
Import Bezier.Part_Powers.power_rate_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 2); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met)]. Qed.
End power_rate_slip_corrected.

Module power_product.
Import Bezier.Part_Powers.power_product.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (0)%Z, (3)%Z, (4), (5); met) | (exists (0)%Z, (3)%Z, (0), (0); met) | (exists (0)%Z, (3)%Z, (8), (6); met) | (exists (0)%Z, (3)%Z, (1), (1); met) | (exists (0)%Z, (3)%Z, (1), (0); met)]. Qed.
End power_product.

Module power_ends.
Import Bezier.Part_Powers.power_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B]; first [(exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 2); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met) | (exists (3)%Z, (1 / 3); met)]. Qed.
End power_ends.

Module power_binomial.
Import Bezier.Part_Powers.power_binomial.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; first [(exists (3)%Z, (3), (4); met) | (exists (3)%Z, (0), (0); met) | (exists (3)%Z, (8), (8); met) | (exists (3)%Z, (1), (1); met) | (exists (3)%Z, (1), (0); met)]. Qed.
End power_binomial.
