(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Splines Require Part_Signs.
Import Splines.Part_Signs.Definitions.
Open Scope R_scope.

Module uniform_bound_slip.
Import Splines.Part_Signs.uniform_bound_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement U] in no; refuting (no ((1))%Z (0)). Qed.
End uniform_bound_slip.

Module knots_nonnegative_outside.
Import Splines.Part_Signs.knots_nonnegative_outside.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement N_] in no; refuting (no (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (2) else if (Z.eqb i0 (3))%bool then (3) else if (Z.eqb i0 (4))%bool then (5) else 0) (1)). Qed.
End knots_nonnegative_outside.
