(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From GbtSurfaces Require Part_Abstract.
Open Scope R_scope.

Module abs_basis_order_2.
Import GbtSurfaces.Part_Abstract.abs_basis_order_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists (2), (3), (4), ((-1) / 3), ((-1) / 3); met) | (exists (0), (0), (0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_order_2.

Module abs_basis_cubic.
Import GbtSurfaces.Part_Abstract.abs_basis_cubic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f K K_]; first [(exists (2), (3), (4), (5), ((-1) / 3), ((-1) / 3); met) | (exists (0), (0), (0), (0), ((-1) / 3), ((-1) / 3); met)]. Qed.
End abs_basis_cubic.
