(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Sums Stages.
From Trigonometric Require Part_Circles.
Open Scope R_scope.

Module quadratic_circle.
Import Trigonometric.Part_Circles.quadratic_circle.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement a c b]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance a c b]; first [(exists (1); met) | (exists (0); met)]. Qed.
End quadratic_circle.
