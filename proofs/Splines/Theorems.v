(* The kernel's word: each theorem has the type of its statement. *)
From Splines Require Part_At_printed Part_At_printed_proofs.
From Splines Require Part_At Part_At_proofs.
From Splines Require Part_B_printed Part_B_printed_proofs.
From Splines Require Part_B Part_B_proofs.
From Splines Require Part_Cubic_printed Part_Cubic_printed_proofs.
From Splines Require Part_Cubic Part_Cubic_proofs.
From Splines Require Part_Derivatives_printed Part_Derivatives_printed_proofs.
From Splines Require Part_Derivatives Part_Derivatives_proofs.
From Splines Require Part_One_printed Part_One_printed_proofs.
From Splines Require Part_One Part_One_proofs.
From Splines Require Part_Partition_printed Part_Partition_printed_proofs.
From Splines Require Part_Partition Part_Partition_proofs.
From Splines Require Part_Polynomials_printed Part_Polynomials_printed_proofs.
From Splines Require Part_Polynomials Part_Polynomials_proofs.
From Splines Require Part_Quadratic_printed Part_Quadratic_printed_proofs.
From Splines Require Part_Quadratic Part_Quadratic_proofs.
From Splines Require Part_Shape_printed Part_Shape_printed_proofs.
From Splines Require Part_Shape Part_Shape_proofs.
From Splines Require Part_Signs_printed Part_Signs_printed_proofs.
From Splines Require Part_Signs Part_Signs_proofs.
From Splines Require Part_Symmetry_printed Part_Symmetry_printed_proofs.
From Splines Require Part_Symmetry Part_Symmetry_proofs.
From Splines Require Part_The_printed Part_The_printed_proofs.
From Splines Require Part_The Part_The_proofs.
From Splines Require Part_Two_printed Part_Two_printed_proofs.
From Splines Require Part_Two Part_Two_proofs.
Check (Splines.Part_At_printed_proofs.uniform_C1.proved : Splines.Part_At_printed.uniform_C1.statement).
Check (Splines.Part_At_printed_proofs.uniform_C1.met : Splines.Part_At_printed.uniform_C1.instance).
Check (Splines.Part_At_printed_proofs.uniform_C1_slip.refuted : ~ Splines.Part_At_printed.uniform_C1_slip.statement).
Check (Splines.Part_At_printed_proofs.uniform_C1_slip_corrected.proved : Splines.Part_At_printed.uniform_C1_slip_corrected.statement).
Check (Splines.Part_At_printed_proofs.uniform_C1_slip_corrected.met : Splines.Part_At_printed.uniform_C1_slip_corrected.instance).
Check (Splines.Part_At_printed_proofs.uniform_C2.proved : Splines.Part_At_printed.uniform_C2.statement).
Check (Splines.Part_At_printed_proofs.uniform_C2.met : Splines.Part_At_printed.uniform_C2.instance).
Check (Splines.Part_At_printed_proofs.uniform_jump.proved : Splines.Part_At_printed.uniform_jump.statement).
Check (Splines.Part_At_printed_proofs.uniform_jump.met : Splines.Part_At_printed.uniform_jump.instance).
Check (Splines.Part_At_printed_proofs.uniform_knot.proved : Splines.Part_At_printed.uniform_knot.statement).
Check (Splines.Part_At_printed_proofs.uniform_knot.met : Splines.Part_At_printed.uniform_knot.instance).
Check (Splines.Part_At_printed_proofs.uniform_knot_slip.refuted : ~ Splines.Part_At_printed.uniform_knot_slip.statement).
Check (Splines.Part_At_printed_proofs.uniform_knot_slip_corrected.proved : Splines.Part_At_printed.uniform_knot_slip_corrected.statement).
Check (Splines.Part_At_printed_proofs.uniform_knot_slip_corrected.met : Splines.Part_At_printed.uniform_knot_slip_corrected.instance).
Check (Splines.Part_At_printed_proofs.knots_C1.proved : Splines.Part_At_printed.knots_C1.statement).
Check (Splines.Part_At_printed_proofs.knots_C1.met : Splines.Part_At_printed.knots_C1.instance).
Check (Splines.Part_At_printed_proofs.knots_C1_value.proved : Splines.Part_At_printed.knots_C1_value.statement).
Check (Splines.Part_At_printed_proofs.knots_C1_value.met : Splines.Part_At_printed.knots_C1_value.instance).
Check (Splines.Part_At_printed_proofs.knots_C1_value_slip.refuted : ~ Splines.Part_At_printed.knots_C1_value_slip.statement).
Check (Splines.Part_At_printed_proofs.knots_C1_value_slip_corrected.proved : Splines.Part_At_printed.knots_C1_value_slip_corrected.statement).
Check (Splines.Part_At_printed_proofs.knots_C1_value_slip_corrected.met : Splines.Part_At_printed.knots_C1_value_slip_corrected.instance).
Check (Splines.Part_At_printed_proofs.knots_C2.proved : Splines.Part_At_printed.knots_C2.statement).
Check (Splines.Part_At_printed_proofs.knots_C2.met : Splines.Part_At_printed.knots_C2.instance).
Check (Splines.Part_At_printed_proofs.knots_convex.proved : Splines.Part_At_printed.knots_convex.statement).
Check (Splines.Part_At_printed_proofs.knots_convex.met : Splines.Part_At_printed.knots_convex.instance).
Check (Splines.Part_At_proofs.uniform_C1.proved : Splines.Part_At.uniform_C1.statement).
Check (Splines.Part_At_proofs.uniform_C1.met : Splines.Part_At.uniform_C1.instance).
Check (Splines.Part_At_proofs.uniform_C1_slip.refuted : ~ Splines.Part_At.uniform_C1_slip.statement).
Check (Splines.Part_At_proofs.uniform_C1_slip_corrected.proved : Splines.Part_At.uniform_C1_slip_corrected.statement).
Check (Splines.Part_At_proofs.uniform_C1_slip_corrected.met : Splines.Part_At.uniform_C1_slip_corrected.instance).
Check (Splines.Part_At_proofs.uniform_C2.proved : Splines.Part_At.uniform_C2.statement).
Check (Splines.Part_At_proofs.uniform_C2.met : Splines.Part_At.uniform_C2.instance).
Check (Splines.Part_At_proofs.uniform_jump.proved : Splines.Part_At.uniform_jump.statement).
Check (Splines.Part_At_proofs.uniform_jump.met : Splines.Part_At.uniform_jump.instance).
Check (Splines.Part_At_proofs.uniform_knot.proved : Splines.Part_At.uniform_knot.statement).
Check (Splines.Part_At_proofs.uniform_knot.met : Splines.Part_At.uniform_knot.instance).
Check (Splines.Part_At_proofs.uniform_knot_slip.refuted : ~ Splines.Part_At.uniform_knot_slip.statement).
Check (Splines.Part_At_proofs.uniform_knot_slip_corrected.proved : Splines.Part_At.uniform_knot_slip_corrected.statement).
Check (Splines.Part_At_proofs.uniform_knot_slip_corrected.met : Splines.Part_At.uniform_knot_slip_corrected.instance).
Check (Splines.Part_At_proofs.knots_C1.proved : Splines.Part_At.knots_C1.statement).
Check (Splines.Part_At_proofs.knots_C1.met : Splines.Part_At.knots_C1.instance).
Check (Splines.Part_At_proofs.knots_C1_value.proved : Splines.Part_At.knots_C1_value.statement).
Check (Splines.Part_At_proofs.knots_C1_value.met : Splines.Part_At.knots_C1_value.instance).
Check (Splines.Part_At_proofs.knots_C1_value_slip.refuted : ~ Splines.Part_At.knots_C1_value_slip.statement).
Check (Splines.Part_At_proofs.knots_C1_value_slip_corrected.proved : Splines.Part_At.knots_C1_value_slip_corrected.statement).
Check (Splines.Part_At_proofs.knots_C1_value_slip_corrected.met : Splines.Part_At.knots_C1_value_slip_corrected.instance).
Check (Splines.Part_At_proofs.knots_C2.proved : Splines.Part_At.knots_C2.statement).
Check (Splines.Part_At_proofs.knots_C2.met : Splines.Part_At.knots_C2.instance).
Check (Splines.Part_At_proofs.knots_convex.proved : Splines.Part_At.knots_convex.statement).
Check (Splines.Part_At_proofs.knots_convex.met : Splines.Part_At.knots_convex.instance).
Check (Splines.Part_B_printed_proofs.uniform_bezier.proved : Splines.Part_B_printed.uniform_bezier.statement).
Check (Splines.Part_B_printed_proofs.uniform_bezier.met : Splines.Part_B_printed.uniform_bezier.instance).
Check (Splines.Part_B_proofs.uniform_bezier.proved : Splines.Part_B.uniform_bezier.statement).
Check (Splines.Part_B_proofs.uniform_bezier.met : Splines.Part_B.uniform_bezier.instance).
Check (Splines.Part_Cubic_printed_proofs.uniform_cubic.proved : Splines.Part_Cubic_printed.uniform_cubic.statement).
Check (Splines.Part_Cubic_printed_proofs.uniform_cubic.met : Splines.Part_Cubic_printed.uniform_cubic.instance).
Check (Splines.Part_Cubic_printed_proofs.uniform_cubic_slip.refuted : ~ Splines.Part_Cubic_printed.uniform_cubic_slip.statement).
Check (Splines.Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.proved : Splines.Part_Cubic_printed.uniform_cubic_slip_corrected.statement).
Check (Splines.Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.met : Splines.Part_Cubic_printed.uniform_cubic_slip_corrected.instance).
Check (Splines.Part_Cubic_proofs.uniform_cubic.proved : Splines.Part_Cubic.uniform_cubic.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic.met : Splines.Part_Cubic.uniform_cubic.instance).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip.refuted : ~ Splines.Part_Cubic.uniform_cubic_slip.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.proved : Splines.Part_Cubic.uniform_cubic_slip_corrected.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.met : Splines.Part_Cubic.uniform_cubic_slip_corrected.instance).
Check (Splines.Part_Derivatives_printed_proofs.uniform_rate.proved : Splines.Part_Derivatives_printed.uniform_rate.statement).
Check (Splines.Part_Derivatives_printed_proofs.uniform_rate.met : Splines.Part_Derivatives_printed.uniform_rate.instance).
Check (Splines.Part_Derivatives_printed_proofs.knots_rate.proved : Splines.Part_Derivatives_printed.knots_rate.statement).
Check (Splines.Part_Derivatives_printed_proofs.knots_rate.met : Splines.Part_Derivatives_printed.knots_rate.instance).
Check (Splines.Part_Derivatives_printed_proofs.knots_rate_slip.refuted : ~ Splines.Part_Derivatives_printed.knots_rate_slip.statement).
Check (Splines.Part_Derivatives_printed_proofs.knots_rate_slip_corrected.proved : Splines.Part_Derivatives_printed.knots_rate_slip_corrected.statement).
Check (Splines.Part_Derivatives_printed_proofs.knots_rate_slip_corrected.met : Splines.Part_Derivatives_printed.knots_rate_slip_corrected.instance).
Check (Splines.Part_Derivatives_proofs.uniform_rate.proved : Splines.Part_Derivatives.uniform_rate.statement).
Check (Splines.Part_Derivatives_proofs.uniform_rate.met : Splines.Part_Derivatives.uniform_rate.instance).
Check (Splines.Part_Derivatives_proofs.knots_rate.proved : Splines.Part_Derivatives.knots_rate.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate.met : Splines.Part_Derivatives.knots_rate.instance).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip.refuted : ~ Splines.Part_Derivatives.knots_rate_slip.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.proved : Splines.Part_Derivatives.knots_rate_slip_corrected.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.met : Splines.Part_Derivatives.knots_rate_slip_corrected.instance).
Check (Splines.Part_One_printed_proofs.clamped_bernstein.proved : Splines.Part_One_printed.clamped_bernstein.statement).
Check (Splines.Part_One_proofs.clamped_bernstein.proved : Splines.Part_One.clamped_bernstein.statement).
Check (Splines.Part_Partition_printed_proofs.uniform_unity.proved : Splines.Part_Partition_printed.uniform_unity.statement).
Check (Splines.Part_Partition_printed_proofs.uniform_unity.met : Splines.Part_Partition_printed.uniform_unity.instance).
Check (Splines.Part_Partition_printed_proofs.knots_unity_quadratic.proved : Splines.Part_Partition_printed.knots_unity_quadratic.statement).
Check (Splines.Part_Partition_printed_proofs.knots_unity_quadratic.met : Splines.Part_Partition_printed.knots_unity_quadratic.instance).
Check (Splines.Part_Partition_printed_proofs.knots_unity_cubic.proved : Splines.Part_Partition_printed.knots_unity_cubic.statement).
Check (Splines.Part_Partition_printed_proofs.knots_unity_cubic.met : Splines.Part_Partition_printed.knots_unity_cubic.instance).
Check (Splines.Part_Partition_printed_proofs.knots_unity_equal.proved : Splines.Part_Partition_printed.knots_unity_equal.statement).
Check (Splines.Part_Partition_printed_proofs.knots_unity_equal.met : Splines.Part_Partition_printed.knots_unity_equal.instance).
Check (Splines.Part_Partition_proofs.uniform_unity.proved : Splines.Part_Partition.uniform_unity.statement).
Check (Splines.Part_Partition_proofs.uniform_unity.met : Splines.Part_Partition.uniform_unity.instance).
Check (Splines.Part_Partition_proofs.knots_unity_quadratic.proved : Splines.Part_Partition.knots_unity_quadratic.statement).
Check (Splines.Part_Partition_proofs.knots_unity_quadratic.met : Splines.Part_Partition.knots_unity_quadratic.instance).
Check (Splines.Part_Partition_proofs.knots_unity_cubic.proved : Splines.Part_Partition.knots_unity_cubic.statement).
Check (Splines.Part_Partition_proofs.knots_unity_cubic.met : Splines.Part_Partition.knots_unity_cubic.instance).
Check (Splines.Part_Partition_proofs.knots_unity_equal.proved : Splines.Part_Partition.knots_unity_equal.statement).
Check (Splines.Part_Partition_proofs.knots_unity_equal.met : Splines.Part_Partition.knots_unity_equal.instance).
Check (Splines.Part_Polynomials_printed_proofs.uniform_greville.proved : Splines.Part_Polynomials_printed.uniform_greville.statement).
Check (Splines.Part_Polynomials_printed_proofs.uniform_greville.met : Splines.Part_Polynomials_printed.uniform_greville.instance).
Check (Splines.Part_Polynomials_printed_proofs.uniform_marsden.proved : Splines.Part_Polynomials_printed.uniform_marsden.statement).
Check (Splines.Part_Polynomials_printed_proofs.uniform_marsden.met : Splines.Part_Polynomials_printed.uniform_marsden.instance).
Check (Splines.Part_Polynomials_printed_proofs.uniform_marsden_slip.refuted : ~ Splines.Part_Polynomials_printed.uniform_marsden_slip.statement).
Check (Splines.Part_Polynomials_printed_proofs.knots_greville.proved : Splines.Part_Polynomials_printed.knots_greville.statement).
Check (Splines.Part_Polynomials_printed_proofs.knots_greville.met : Splines.Part_Polynomials_printed.knots_greville.instance).
Check (Splines.Part_Polynomials_printed_proofs.knots_marsden.proved : Splines.Part_Polynomials_printed.knots_marsden.statement).
Check (Splines.Part_Polynomials_printed_proofs.knots_marsden.met : Splines.Part_Polynomials_printed.knots_marsden.instance).
Check (Splines.Part_Polynomials_printed_proofs.knots_marsden_cubic.proved : Splines.Part_Polynomials_printed.knots_marsden_cubic.statement).
Check (Splines.Part_Polynomials_printed_proofs.knots_marsden_cubic.met : Splines.Part_Polynomials_printed.knots_marsden_cubic.instance).
Check (Splines.Part_Polynomials_proofs.uniform_greville.proved : Splines.Part_Polynomials.uniform_greville.statement).
Check (Splines.Part_Polynomials_proofs.uniform_greville.met : Splines.Part_Polynomials.uniform_greville.instance).
Check (Splines.Part_Polynomials_proofs.uniform_marsden.proved : Splines.Part_Polynomials.uniform_marsden.statement).
Check (Splines.Part_Polynomials_proofs.uniform_marsden.met : Splines.Part_Polynomials.uniform_marsden.instance).
Check (Splines.Part_Polynomials_proofs.uniform_marsden_slip.refuted : ~ Splines.Part_Polynomials.uniform_marsden_slip.statement).
Check (Splines.Part_Polynomials_proofs.knots_greville.proved : Splines.Part_Polynomials.knots_greville.statement).
Check (Splines.Part_Polynomials_proofs.knots_greville.met : Splines.Part_Polynomials.knots_greville.instance).
Check (Splines.Part_Polynomials_proofs.knots_marsden.proved : Splines.Part_Polynomials.knots_marsden.statement).
Check (Splines.Part_Polynomials_proofs.knots_marsden.met : Splines.Part_Polynomials.knots_marsden.instance).
Check (Splines.Part_Polynomials_proofs.knots_marsden_cubic.proved : Splines.Part_Polynomials.knots_marsden_cubic.statement).
Check (Splines.Part_Polynomials_proofs.knots_marsden_cubic.met : Splines.Part_Polynomials.knots_marsden_cubic.instance).
Check (Splines.Part_Quadratic_printed_proofs.uniform_quadratic.proved : Splines.Part_Quadratic_printed.uniform_quadratic.statement).
Check (Splines.Part_Quadratic_printed_proofs.uniform_quadratic.met : Splines.Part_Quadratic_printed.uniform_quadratic.instance).
Check (Splines.Part_Quadratic_proofs.uniform_quadratic.proved : Splines.Part_Quadratic.uniform_quadratic.statement).
Check (Splines.Part_Quadratic_proofs.uniform_quadratic.met : Splines.Part_Quadratic.uniform_quadratic.instance).
Check (Splines.Part_Shape_printed_proofs.uniform_line.proved : Splines.Part_Shape_printed.uniform_line.statement).
Check (Splines.Part_Shape_printed_proofs.uniform_line.met : Splines.Part_Shape_printed.uniform_line.instance).
Check (Splines.Part_Shape_proofs.uniform_line.proved : Splines.Part_Shape.uniform_line.statement).
Check (Splines.Part_Shape_proofs.uniform_line.met : Splines.Part_Shape.uniform_line.instance).
Check (Splines.Part_Signs_printed_proofs.uniform_nonnegative.proved : Splines.Part_Signs_printed.uniform_nonnegative.statement).
Check (Splines.Part_Signs_printed_proofs.uniform_nonnegative.met : Splines.Part_Signs_printed.uniform_nonnegative.instance).
Check (Splines.Part_Signs_printed_proofs.uniform_bound.proved : Splines.Part_Signs_printed.uniform_bound.statement).
Check (Splines.Part_Signs_printed_proofs.uniform_bound.met : Splines.Part_Signs_printed.uniform_bound.instance).
Check (Splines.Part_Signs_printed_proofs.uniform_bound_slip.refuted : ~ Splines.Part_Signs_printed.uniform_bound_slip.statement).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_ends.proved : Splines.Part_Signs_printed.knots_nonnegative_ends.statement).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_ends.met : Splines.Part_Signs_printed.knots_nonnegative_ends.instance).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_middle.proved : Splines.Part_Signs_printed.knots_nonnegative_middle.statement).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_middle.met : Splines.Part_Signs_printed.knots_nonnegative_middle.instance).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_outside.refuted : ~ Splines.Part_Signs_printed.knots_nonnegative_outside.statement).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_cubic.proved : Splines.Part_Signs_printed.knots_nonnegative_cubic.statement).
Check (Splines.Part_Signs_printed_proofs.knots_nonnegative_cubic.met : Splines.Part_Signs_printed.knots_nonnegative_cubic.instance).
Check (Splines.Part_Signs_proofs.uniform_nonnegative.proved : Splines.Part_Signs.uniform_nonnegative.statement).
Check (Splines.Part_Signs_proofs.uniform_nonnegative.met : Splines.Part_Signs.uniform_nonnegative.instance).
Check (Splines.Part_Signs_proofs.uniform_bound.proved : Splines.Part_Signs.uniform_bound.statement).
Check (Splines.Part_Signs_proofs.uniform_bound.met : Splines.Part_Signs.uniform_bound.instance).
Check (Splines.Part_Signs_proofs.uniform_bound_slip.refuted : ~ Splines.Part_Signs.uniform_bound_slip.statement).
Check (Splines.Part_Signs_proofs.knots_nonnegative_ends.proved : Splines.Part_Signs.knots_nonnegative_ends.statement).
Check (Splines.Part_Signs_proofs.knots_nonnegative_ends.met : Splines.Part_Signs.knots_nonnegative_ends.instance).
Check (Splines.Part_Signs_proofs.knots_nonnegative_middle.proved : Splines.Part_Signs.knots_nonnegative_middle.statement).
Check (Splines.Part_Signs_proofs.knots_nonnegative_middle.met : Splines.Part_Signs.knots_nonnegative_middle.instance).
Check (Splines.Part_Signs_proofs.knots_nonnegative_outside.refuted : ~ Splines.Part_Signs.knots_nonnegative_outside.statement).
Check (Splines.Part_Signs_proofs.knots_nonnegative_cubic.proved : Splines.Part_Signs.knots_nonnegative_cubic.statement).
Check (Splines.Part_Signs_proofs.knots_nonnegative_cubic.met : Splines.Part_Signs.knots_nonnegative_cubic.instance).
Check (Splines.Part_Symmetry_printed_proofs.uniform_symmetry.proved : Splines.Part_Symmetry_printed.uniform_symmetry.statement).
Check (Splines.Part_Symmetry_printed_proofs.uniform_symmetry.met : Splines.Part_Symmetry_printed.uniform_symmetry.instance).
Check (Splines.Part_Symmetry_proofs.uniform_symmetry.proved : Splines.Part_Symmetry.uniform_symmetry.statement).
Check (Splines.Part_Symmetry_proofs.uniform_symmetry.met : Splines.Part_Symmetry.uniform_symmetry.instance).
Check (Splines.Part_The_printed_proofs.knots_linear.proved : Splines.Part_The_printed.knots_linear.statement).
Check (Splines.Part_The_printed_proofs.knots_linear.met : Splines.Part_The_printed.knots_linear.instance).
Check (Splines.Part_The_printed_proofs.knots_quadratic.proved : Splines.Part_The_printed.knots_quadratic.statement).
Check (Splines.Part_The_printed_proofs.knots_quadratic.met : Splines.Part_The_printed.knots_quadratic.instance).
Check (Splines.Part_The_printed_proofs.knots_quadratic_slip.refuted : ~ Splines.Part_The_printed.knots_quadratic_slip.statement).
Check (Splines.Part_The_printed_proofs.knots_quadratic_slip_corrected.proved : Splines.Part_The_printed.knots_quadratic_slip_corrected.statement).
Check (Splines.Part_The_printed_proofs.knots_quadratic_slip_corrected.met : Splines.Part_The_printed.knots_quadratic_slip_corrected.instance).
Check (Splines.Part_The_printed_proofs.knots_span.proved : Splines.Part_The_printed.knots_span.statement).
Check (Splines.Part_The_printed_proofs.knots_span.met : Splines.Part_The_printed.knots_span.instance).
Check (Splines.Part_The_proofs.knots_linear.proved : Splines.Part_The.knots_linear.statement).
Check (Splines.Part_The_proofs.knots_linear.met : Splines.Part_The.knots_linear.instance).
Check (Splines.Part_The_proofs.knots_quadratic.proved : Splines.Part_The.knots_quadratic.statement).
Check (Splines.Part_The_proofs.knots_quadratic.met : Splines.Part_The.knots_quadratic.instance).
Check (Splines.Part_The_proofs.knots_quadratic_slip.refuted : ~ Splines.Part_The.knots_quadratic_slip.statement).
Check (Splines.Part_The_proofs.knots_quadratic_slip_corrected.proved : Splines.Part_The.knots_quadratic_slip_corrected.statement).
Check (Splines.Part_The_proofs.knots_quadratic_slip_corrected.met : Splines.Part_The.knots_quadratic_slip_corrected.instance).
Check (Splines.Part_The_proofs.knots_span.proved : Splines.Part_The.knots_span.statement).
Check (Splines.Part_The_proofs.knots_span.met : Splines.Part_The.knots_span.instance).
Check (Splines.Part_Two_printed_proofs.uniform_two_scale_quadratic.proved : Splines.Part_Two_printed.uniform_two_scale_quadratic.statement).
Check (Splines.Part_Two_printed_proofs.uniform_two_scale_quadratic.met : Splines.Part_Two_printed.uniform_two_scale_quadratic.instance).
Check (Splines.Part_Two_printed_proofs.uniform_two_scale_cubic.proved : Splines.Part_Two_printed.uniform_two_scale_cubic.statement).
Check (Splines.Part_Two_printed_proofs.uniform_two_scale_cubic.met : Splines.Part_Two_printed.uniform_two_scale_cubic.instance).
Check (Splines.Part_Two_printed_proofs.uniform_two_scale_slip.refuted : ~ Splines.Part_Two_printed.uniform_two_scale_slip.statement).
Check (Splines.Part_Two_printed_proofs.clamped_unity.proved : Splines.Part_Two_printed.clamped_unity.statement).
Check (Splines.Part_Two_printed_proofs.clamped_unity.met : Splines.Part_Two_printed.clamped_unity.instance).
Check (Splines.Part_Two_printed_proofs.clamped_ends.proved : Splines.Part_Two_printed.clamped_ends.statement).
Check (Splines.Part_Two_printed_proofs.clamped_ends.met : Splines.Part_Two_printed.clamped_ends.instance).
Check (Splines.Part_Two_printed_proofs.clamped_tangents.proved : Splines.Part_Two_printed.clamped_tangents.statement).
Check (Splines.Part_Two_printed_proofs.clamped_tangents.met : Splines.Part_Two_printed.clamped_tangents.instance).
Check (Splines.Part_Two_printed_proofs.clamped_tangents_slip.refuted : ~ Splines.Part_Two_printed.clamped_tangents_slip.statement).
Check (Splines.Part_Two_printed_proofs.clamped_C1.proved : Splines.Part_Two_printed.clamped_C1.statement).
Check (Splines.Part_Two_printed_proofs.clamped_C1.met : Splines.Part_Two_printed.clamped_C1.instance).
Check (Splines.Part_Two_printed_proofs.clamped_knot.proved : Splines.Part_Two_printed.clamped_knot.statement).
Check (Splines.Part_Two_printed_proofs.clamped_knot.met : Splines.Part_Two_printed.clamped_knot.instance).
Check (Splines.Part_Two_printed_proofs.clamped_C2.refuted : ~ Splines.Part_Two_printed.clamped_C2.statement).
Check (Splines.Part_Two_proofs.uniform_two_scale_quadratic.proved : Splines.Part_Two.uniform_two_scale_quadratic.statement).
Check (Splines.Part_Two_proofs.uniform_two_scale_quadratic.met : Splines.Part_Two.uniform_two_scale_quadratic.instance).
Check (Splines.Part_Two_proofs.uniform_two_scale_cubic.proved : Splines.Part_Two.uniform_two_scale_cubic.statement).
Check (Splines.Part_Two_proofs.uniform_two_scale_cubic.met : Splines.Part_Two.uniform_two_scale_cubic.instance).
Check (Splines.Part_Two_proofs.uniform_two_scale_slip.refuted : ~ Splines.Part_Two.uniform_two_scale_slip.statement).
Check (Splines.Part_Two_proofs.clamped_unity.proved : Splines.Part_Two.clamped_unity.statement).
Check (Splines.Part_Two_proofs.clamped_unity.met : Splines.Part_Two.clamped_unity.instance).
Check (Splines.Part_Two_proofs.clamped_ends.proved : Splines.Part_Two.clamped_ends.statement).
Check (Splines.Part_Two_proofs.clamped_ends.met : Splines.Part_Two.clamped_ends.instance).
Check (Splines.Part_Two_proofs.clamped_tangents.proved : Splines.Part_Two.clamped_tangents.statement).
Check (Splines.Part_Two_proofs.clamped_tangents.met : Splines.Part_Two.clamped_tangents.instance).
Check (Splines.Part_Two_proofs.clamped_tangents_slip.refuted : ~ Splines.Part_Two.clamped_tangents_slip.statement).
Check (Splines.Part_Two_proofs.clamped_C1.proved : Splines.Part_Two.clamped_C1.statement).
Check (Splines.Part_Two_proofs.clamped_C1.met : Splines.Part_Two.clamped_C1.instance).
Check (Splines.Part_Two_proofs.clamped_knot.proved : Splines.Part_Two.clamped_knot.statement).
Check (Splines.Part_Two_proofs.clamped_knot.met : Splines.Part_Two.clamped_knot.instance).
Check (Splines.Part_Two_proofs.clamped_C2.refuted : ~ Splines.Part_Two.clamped_C2.statement).
Definition all_theorems : True :=
let _ := Splines.Part_At_printed_proofs.uniform_C1.proved in
let _ := Splines.Part_At_printed_proofs.uniform_C1.met in
let _ := Splines.Part_At_printed_proofs.uniform_C1_slip.refuted in
let _ := Splines.Part_At_printed_proofs.uniform_C1_slip_corrected.proved in
let _ := Splines.Part_At_printed_proofs.uniform_C1_slip_corrected.met in
let _ := Splines.Part_At_printed_proofs.uniform_C2.proved in
let _ := Splines.Part_At_printed_proofs.uniform_C2.met in
let _ := Splines.Part_At_printed_proofs.uniform_jump.proved in
let _ := Splines.Part_At_printed_proofs.uniform_jump.met in
let _ := Splines.Part_At_printed_proofs.uniform_knot.proved in
let _ := Splines.Part_At_printed_proofs.uniform_knot.met in
let _ := Splines.Part_At_printed_proofs.uniform_knot_slip.refuted in
let _ := Splines.Part_At_printed_proofs.uniform_knot_slip_corrected.proved in
let _ := Splines.Part_At_printed_proofs.uniform_knot_slip_corrected.met in
let _ := Splines.Part_At_printed_proofs.knots_C1.proved in
let _ := Splines.Part_At_printed_proofs.knots_C1.met in
let _ := Splines.Part_At_printed_proofs.knots_C1_value.proved in
let _ := Splines.Part_At_printed_proofs.knots_C1_value.met in
let _ := Splines.Part_At_printed_proofs.knots_C1_value_slip.refuted in
let _ := Splines.Part_At_printed_proofs.knots_C1_value_slip_corrected.proved in
let _ := Splines.Part_At_printed_proofs.knots_C1_value_slip_corrected.met in
let _ := Splines.Part_At_printed_proofs.knots_C2.proved in
let _ := Splines.Part_At_printed_proofs.knots_C2.met in
let _ := Splines.Part_At_printed_proofs.knots_convex.proved in
let _ := Splines.Part_At_printed_proofs.knots_convex.met in
let _ := Splines.Part_At_proofs.uniform_C1.proved in
let _ := Splines.Part_At_proofs.uniform_C1.met in
let _ := Splines.Part_At_proofs.uniform_C1_slip.refuted in
let _ := Splines.Part_At_proofs.uniform_C1_slip_corrected.proved in
let _ := Splines.Part_At_proofs.uniform_C1_slip_corrected.met in
let _ := Splines.Part_At_proofs.uniform_C2.proved in
let _ := Splines.Part_At_proofs.uniform_C2.met in
let _ := Splines.Part_At_proofs.uniform_jump.proved in
let _ := Splines.Part_At_proofs.uniform_jump.met in
let _ := Splines.Part_At_proofs.uniform_knot.proved in
let _ := Splines.Part_At_proofs.uniform_knot.met in
let _ := Splines.Part_At_proofs.uniform_knot_slip.refuted in
let _ := Splines.Part_At_proofs.uniform_knot_slip_corrected.proved in
let _ := Splines.Part_At_proofs.uniform_knot_slip_corrected.met in
let _ := Splines.Part_At_proofs.knots_C1.proved in
let _ := Splines.Part_At_proofs.knots_C1.met in
let _ := Splines.Part_At_proofs.knots_C1_value.proved in
let _ := Splines.Part_At_proofs.knots_C1_value.met in
let _ := Splines.Part_At_proofs.knots_C1_value_slip.refuted in
let _ := Splines.Part_At_proofs.knots_C1_value_slip_corrected.proved in
let _ := Splines.Part_At_proofs.knots_C1_value_slip_corrected.met in
let _ := Splines.Part_At_proofs.knots_C2.proved in
let _ := Splines.Part_At_proofs.knots_C2.met in
let _ := Splines.Part_At_proofs.knots_convex.proved in
let _ := Splines.Part_At_proofs.knots_convex.met in
let _ := Splines.Part_B_printed_proofs.uniform_bezier.proved in
let _ := Splines.Part_B_printed_proofs.uniform_bezier.met in
let _ := Splines.Part_B_proofs.uniform_bezier.proved in
let _ := Splines.Part_B_proofs.uniform_bezier.met in
let _ := Splines.Part_Cubic_printed_proofs.uniform_cubic.proved in
let _ := Splines.Part_Cubic_printed_proofs.uniform_cubic.met in
let _ := Splines.Part_Cubic_printed_proofs.uniform_cubic_slip.refuted in
let _ := Splines.Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.proved in
let _ := Splines.Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.met in
let _ := Splines.Part_Cubic_proofs.uniform_cubic.proved in
let _ := Splines.Part_Cubic_proofs.uniform_cubic.met in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip.refuted in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.proved in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.met in
let _ := Splines.Part_Derivatives_printed_proofs.uniform_rate.proved in
let _ := Splines.Part_Derivatives_printed_proofs.uniform_rate.met in
let _ := Splines.Part_Derivatives_printed_proofs.knots_rate.proved in
let _ := Splines.Part_Derivatives_printed_proofs.knots_rate.met in
let _ := Splines.Part_Derivatives_printed_proofs.knots_rate_slip.refuted in
let _ := Splines.Part_Derivatives_printed_proofs.knots_rate_slip_corrected.proved in
let _ := Splines.Part_Derivatives_printed_proofs.knots_rate_slip_corrected.met in
let _ := Splines.Part_Derivatives_proofs.uniform_rate.proved in
let _ := Splines.Part_Derivatives_proofs.uniform_rate.met in
let _ := Splines.Part_Derivatives_proofs.knots_rate.proved in
let _ := Splines.Part_Derivatives_proofs.knots_rate.met in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip.refuted in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.proved in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.met in
let _ := Splines.Part_One_printed_proofs.clamped_bernstein.proved in
let _ := Splines.Part_One_proofs.clamped_bernstein.proved in
let _ := Splines.Part_Partition_printed_proofs.uniform_unity.proved in
let _ := Splines.Part_Partition_printed_proofs.uniform_unity.met in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_quadratic.proved in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_quadratic.met in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_cubic.proved in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_cubic.met in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_equal.proved in
let _ := Splines.Part_Partition_printed_proofs.knots_unity_equal.met in
let _ := Splines.Part_Partition_proofs.uniform_unity.proved in
let _ := Splines.Part_Partition_proofs.uniform_unity.met in
let _ := Splines.Part_Partition_proofs.knots_unity_quadratic.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_quadratic.met in
let _ := Splines.Part_Partition_proofs.knots_unity_cubic.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_cubic.met in
let _ := Splines.Part_Partition_proofs.knots_unity_equal.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_equal.met in
let _ := Splines.Part_Polynomials_printed_proofs.uniform_greville.proved in
let _ := Splines.Part_Polynomials_printed_proofs.uniform_greville.met in
let _ := Splines.Part_Polynomials_printed_proofs.uniform_marsden.proved in
let _ := Splines.Part_Polynomials_printed_proofs.uniform_marsden.met in
let _ := Splines.Part_Polynomials_printed_proofs.uniform_marsden_slip.refuted in
let _ := Splines.Part_Polynomials_printed_proofs.knots_greville.proved in
let _ := Splines.Part_Polynomials_printed_proofs.knots_greville.met in
let _ := Splines.Part_Polynomials_printed_proofs.knots_marsden.proved in
let _ := Splines.Part_Polynomials_printed_proofs.knots_marsden.met in
let _ := Splines.Part_Polynomials_printed_proofs.knots_marsden_cubic.proved in
let _ := Splines.Part_Polynomials_printed_proofs.knots_marsden_cubic.met in
let _ := Splines.Part_Polynomials_proofs.uniform_greville.proved in
let _ := Splines.Part_Polynomials_proofs.uniform_greville.met in
let _ := Splines.Part_Polynomials_proofs.uniform_marsden.proved in
let _ := Splines.Part_Polynomials_proofs.uniform_marsden.met in
let _ := Splines.Part_Polynomials_proofs.uniform_marsden_slip.refuted in
let _ := Splines.Part_Polynomials_proofs.knots_greville.proved in
let _ := Splines.Part_Polynomials_proofs.knots_greville.met in
let _ := Splines.Part_Polynomials_proofs.knots_marsden.proved in
let _ := Splines.Part_Polynomials_proofs.knots_marsden.met in
let _ := Splines.Part_Polynomials_proofs.knots_marsden_cubic.proved in
let _ := Splines.Part_Polynomials_proofs.knots_marsden_cubic.met in
let _ := Splines.Part_Quadratic_printed_proofs.uniform_quadratic.proved in
let _ := Splines.Part_Quadratic_printed_proofs.uniform_quadratic.met in
let _ := Splines.Part_Quadratic_proofs.uniform_quadratic.proved in
let _ := Splines.Part_Quadratic_proofs.uniform_quadratic.met in
let _ := Splines.Part_Shape_printed_proofs.uniform_line.proved in
let _ := Splines.Part_Shape_printed_proofs.uniform_line.met in
let _ := Splines.Part_Shape_proofs.uniform_line.proved in
let _ := Splines.Part_Shape_proofs.uniform_line.met in
let _ := Splines.Part_Signs_printed_proofs.uniform_nonnegative.proved in
let _ := Splines.Part_Signs_printed_proofs.uniform_nonnegative.met in
let _ := Splines.Part_Signs_printed_proofs.uniform_bound.proved in
let _ := Splines.Part_Signs_printed_proofs.uniform_bound.met in
let _ := Splines.Part_Signs_printed_proofs.uniform_bound_slip.refuted in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_ends.proved in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_ends.met in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_middle.proved in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_middle.met in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_outside.refuted in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_cubic.proved in
let _ := Splines.Part_Signs_printed_proofs.knots_nonnegative_cubic.met in
let _ := Splines.Part_Signs_proofs.uniform_nonnegative.proved in
let _ := Splines.Part_Signs_proofs.uniform_nonnegative.met in
let _ := Splines.Part_Signs_proofs.uniform_bound.proved in
let _ := Splines.Part_Signs_proofs.uniform_bound.met in
let _ := Splines.Part_Signs_proofs.uniform_bound_slip.refuted in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_ends.proved in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_ends.met in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_middle.proved in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_middle.met in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_outside.refuted in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_cubic.proved in
let _ := Splines.Part_Signs_proofs.knots_nonnegative_cubic.met in
let _ := Splines.Part_Symmetry_printed_proofs.uniform_symmetry.proved in
let _ := Splines.Part_Symmetry_printed_proofs.uniform_symmetry.met in
let _ := Splines.Part_Symmetry_proofs.uniform_symmetry.proved in
let _ := Splines.Part_Symmetry_proofs.uniform_symmetry.met in
let _ := Splines.Part_The_printed_proofs.knots_linear.proved in
let _ := Splines.Part_The_printed_proofs.knots_linear.met in
let _ := Splines.Part_The_printed_proofs.knots_quadratic.proved in
let _ := Splines.Part_The_printed_proofs.knots_quadratic.met in
let _ := Splines.Part_The_printed_proofs.knots_quadratic_slip.refuted in
let _ := Splines.Part_The_printed_proofs.knots_quadratic_slip_corrected.proved in
let _ := Splines.Part_The_printed_proofs.knots_quadratic_slip_corrected.met in
let _ := Splines.Part_The_printed_proofs.knots_span.proved in
let _ := Splines.Part_The_printed_proofs.knots_span.met in
let _ := Splines.Part_The_proofs.knots_linear.proved in
let _ := Splines.Part_The_proofs.knots_linear.met in
let _ := Splines.Part_The_proofs.knots_quadratic.proved in
let _ := Splines.Part_The_proofs.knots_quadratic.met in
let _ := Splines.Part_The_proofs.knots_quadratic_slip.refuted in
let _ := Splines.Part_The_proofs.knots_quadratic_slip_corrected.proved in
let _ := Splines.Part_The_proofs.knots_quadratic_slip_corrected.met in
let _ := Splines.Part_The_proofs.knots_span.proved in
let _ := Splines.Part_The_proofs.knots_span.met in
let _ := Splines.Part_Two_printed_proofs.uniform_two_scale_quadratic.proved in
let _ := Splines.Part_Two_printed_proofs.uniform_two_scale_quadratic.met in
let _ := Splines.Part_Two_printed_proofs.uniform_two_scale_cubic.proved in
let _ := Splines.Part_Two_printed_proofs.uniform_two_scale_cubic.met in
let _ := Splines.Part_Two_printed_proofs.uniform_two_scale_slip.refuted in
let _ := Splines.Part_Two_printed_proofs.clamped_unity.proved in
let _ := Splines.Part_Two_printed_proofs.clamped_unity.met in
let _ := Splines.Part_Two_printed_proofs.clamped_ends.proved in
let _ := Splines.Part_Two_printed_proofs.clamped_ends.met in
let _ := Splines.Part_Two_printed_proofs.clamped_tangents.proved in
let _ := Splines.Part_Two_printed_proofs.clamped_tangents.met in
let _ := Splines.Part_Two_printed_proofs.clamped_tangents_slip.refuted in
let _ := Splines.Part_Two_printed_proofs.clamped_C1.proved in
let _ := Splines.Part_Two_printed_proofs.clamped_C1.met in
let _ := Splines.Part_Two_printed_proofs.clamped_knot.proved in
let _ := Splines.Part_Two_printed_proofs.clamped_knot.met in
let _ := Splines.Part_Two_printed_proofs.clamped_C2.refuted in
let _ := Splines.Part_Two_proofs.uniform_two_scale_quadratic.proved in
let _ := Splines.Part_Two_proofs.uniform_two_scale_quadratic.met in
let _ := Splines.Part_Two_proofs.uniform_two_scale_cubic.proved in
let _ := Splines.Part_Two_proofs.uniform_two_scale_cubic.met in
let _ := Splines.Part_Two_proofs.uniform_two_scale_slip.refuted in
let _ := Splines.Part_Two_proofs.clamped_unity.proved in
let _ := Splines.Part_Two_proofs.clamped_unity.met in
let _ := Splines.Part_Two_proofs.clamped_ends.proved in
let _ := Splines.Part_Two_proofs.clamped_ends.met in
let _ := Splines.Part_Two_proofs.clamped_tangents.proved in
let _ := Splines.Part_Two_proofs.clamped_tangents.met in
let _ := Splines.Part_Two_proofs.clamped_tangents_slip.refuted in
let _ := Splines.Part_Two_proofs.clamped_C1.proved in
let _ := Splines.Part_Two_proofs.clamped_C1.met in
let _ := Splines.Part_Two_proofs.clamped_knot.proved in
let _ := Splines.Part_Two_proofs.clamped_knot.met in
let _ := Splines.Part_Two_proofs.clamped_C2.refuted in
I.
