(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From Hyperbolic Require Part_The.
Import Hyperbolic.Part_The.Definitions.
Open Scope R_scope.

Module quadratic_unity.
Import Hyperbolic.Part_The.quadratic_unity.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End quadratic_unity.

Module quadratic_symmetry.
Import Hyperbolic.Part_The.quadratic_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f h g]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f h g]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End quadratic_symmetry.

Module quadratic_ends.
Import Hyperbolic.Part_The.quadratic_ends.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h]; first [(exists (1); met) | (exists (1); met) | (exists (13); met) | (exists (1); met) | (exists (1); met)]. Qed.
End quadratic_ends.

Module quadratic_nonnegative_slip.
Import Hyperbolic.Part_The.quadratic_nonnegative_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g] in no; refuting (no (1) (2)). Qed.
End quadratic_nonnegative_slip.

Module quadratic_space.
Import Hyperbolic.Part_The.quadratic_space.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement f g h]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance f g h]; first [(exists (1), (1); met) | (exists (1), (0); met) | (exists (13), (8); met) | (exists (1), (1); met) | (exists (1), (1); met)]. Qed.
End quadratic_space.

Module shape_symmetry.
Import Hyperbolic.Part_The.shape_symmetry.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement h]; symbolic. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance h]; first [(exists (0)%Z, (1), (1 / 3); met) | (exists (0)%Z, (1), (1 / 2); met) | (exists (0)%Z, (8), (1 / 3); met) | (exists (0)%Z, (1), (1 / 3); met) | (exists (0)%Z, (1), (1 / 3); met)]. Qed.
End shape_symmetry.
