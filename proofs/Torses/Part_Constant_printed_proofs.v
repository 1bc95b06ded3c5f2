(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows Jets.
From Torses Require Part_Constant_printed Part_Constant_proofs.
Open Scope R_scope.

Module slope_torse.
Import Torses.Part_Constant_printed.slope_torse.
Theorem proved : statement.
Proof. hnf; intros w x y h u; by_jets (Torses.Part_Constant_proofs.slope_torse.proved h u (Derive_n w 1 u) (w u) (Derive_n x 2 u) (Derive_n x 1 u) (Derive_n y 2 u) (Derive_n y 1 u)). Qed.
Theorem met : instance.
Proof. destruct Torses.Part_Constant_proofs.slope_torse.met as [h [u [w'_u_ [w_u_ [x''_u_ [x'_u_ [y''_u_ [y'_u_ there]]]]]]]]; hnf; exists (fun t : R => (t - u) * w'_u_ + w_u_), (fun t : R => (t - u) * (t - u) * (x''_u_ / 2) + (t - u) * x'_u_), (fun t : R => (t - u) * (t - u) * (y''_u_ / 2) + (t - u) * y'_u_), h, u; there_by_jets there. Qed.
End slope_torse.
