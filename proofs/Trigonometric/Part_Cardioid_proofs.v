(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Trigonometric Require Part_Cardioid.
Open Scope R_scope.

Module cardioid_speed.
Import Trigonometric.Part_Cardioid.cardioid_speed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance K]; first [(exists (1); met) | (exists (1); met)]. Qed.
End cardioid_speed.

Module cardioid_cusp.
Import Trigonometric.Part_Cardioid.cardioid_cusp.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement K]; identity. Qed.
End cardioid_cusp.
