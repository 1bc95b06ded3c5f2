(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed.
From GbtSurfaces Require Part_Abstract.
Import GbtSurfaces.Part_Abstract.Definitions.
Open Scope R_scope.

Module abs_basis_a.
Import GbtSurfaces.Part_Abstract.abs_basis_a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f]; first [(exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, (0), (0), (1 / 2); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (0)%Z, (2)%Z, ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_basis_a.

Module abs_basis_b.
Import GbtSurfaces.Part_Abstract.abs_basis_b.
Theorem refuted : ~ statement.
Proof. cbv beta zeta delta [statement not f]; intro no; specialize (no (-1) (-1) 0 ltac:(lra) ltac:(lra) ltac:(lra) 2%Z (unit 1) ltac:(lia)); assert (H : unit 1 1 = 0) by (apply no; [ intros; cbv delta [unit]; compute_goal; circles; equal | lia ]); rewrite unit_one in H by reflexivity; lra. Qed.
End abs_basis_b.

Module abs_basis_order_2.
Import GbtSurfaces.Part_Abstract.abs_basis_order_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_order_2.

Module abs_basis_cubic.
Import GbtSurfaces.Part_Abstract.abs_basis_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), (0), (0); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met) | (exists ((0) / (1)), ((0) / (1)), ((0) / (1)), ((0) / (1)), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_cubic.

Module abs_basis_all.
Import GbtSurfaces.Part_Abstract.abs_basis_all.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f F e A B C_]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f F e A B C_]; first [(exists (3)%Z, (fun _ => 3), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), (0), (0), (1 / 2); met) | (exists (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 1), ((-1) / 3), ((-1) / 3), (1 / 3); met) | (exists (3)%Z, (fun _ => 0), ((-1) / 3), ((-1) / 3), (1 / 3); met)]. Qed.
End abs_basis_all.
