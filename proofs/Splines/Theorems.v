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
Check (Part_At_printed_proofs.uniform_C1.proved : Part_At_printed.uniform_C1.statement).
Check (Part_At_printed_proofs.uniform_C1.met : Part_At_printed.uniform_C1.instance).
Check (Part_At_printed_proofs.uniform_C1_slip.refuted : ~ Part_At_printed.uniform_C1_slip.statement).
Check (Part_At_printed_proofs.uniform_C1_slip_corrected.proved : Part_At_printed.uniform_C1_slip_corrected.statement).
Check (Part_At_printed_proofs.uniform_C1_slip_corrected.met : Part_At_printed.uniform_C1_slip_corrected.instance).
Check (Part_At_printed_proofs.uniform_C2.proved : Part_At_printed.uniform_C2.statement).
Check (Part_At_printed_proofs.uniform_C2.met : Part_At_printed.uniform_C2.instance).
Check (Part_At_printed_proofs.uniform_jump.proved : Part_At_printed.uniform_jump.statement).
Check (Part_At_printed_proofs.uniform_jump.met : Part_At_printed.uniform_jump.instance).
Check (Part_At_printed_proofs.uniform_knot.proved : Part_At_printed.uniform_knot.statement).
Check (Part_At_printed_proofs.uniform_knot.met : Part_At_printed.uniform_knot.instance).
Check (Part_At_printed_proofs.uniform_knot_slip.refuted : ~ Part_At_printed.uniform_knot_slip.statement).
Check (Part_At_printed_proofs.uniform_knot_slip_corrected.proved : Part_At_printed.uniform_knot_slip_corrected.statement).
Check (Part_At_printed_proofs.uniform_knot_slip_corrected.met : Part_At_printed.uniform_knot_slip_corrected.instance).
Check (Part_At_printed_proofs.knots_C1.proved : Part_At_printed.knots_C1.statement).
Check (Part_At_printed_proofs.knots_C1.met : Part_At_printed.knots_C1.instance).
Check (Part_At_printed_proofs.knots_C1_value.proved : Part_At_printed.knots_C1_value.statement).
Check (Part_At_printed_proofs.knots_C1_value.met : Part_At_printed.knots_C1_value.instance).
Check (Part_At_printed_proofs.knots_C1_value_slip.refuted : ~ Part_At_printed.knots_C1_value_slip.statement).
Check (Part_At_printed_proofs.knots_C1_value_slip_corrected.proved : Part_At_printed.knots_C1_value_slip_corrected.statement).
Check (Part_At_printed_proofs.knots_C1_value_slip_corrected.met : Part_At_printed.knots_C1_value_slip_corrected.instance).
Check (Part_At_printed_proofs.knots_C2.proved : Part_At_printed.knots_C2.statement).
Check (Part_At_printed_proofs.knots_C2.met : Part_At_printed.knots_C2.instance).
Check (Part_At_printed_proofs.knots_convex.proved : Part_At_printed.knots_convex.statement).
Check (Part_At_printed_proofs.knots_convex.met : Part_At_printed.knots_convex.instance).
Check (Part_At_proofs.uniform_C1.proved : Part_At.uniform_C1.statement).
Check (Part_At_proofs.uniform_C1.met : Part_At.uniform_C1.instance).
Check (Part_At_proofs.uniform_C1_slip.refuted : ~ Part_At.uniform_C1_slip.statement).
Check (Part_At_proofs.uniform_C1_slip_corrected.proved : Part_At.uniform_C1_slip_corrected.statement).
Check (Part_At_proofs.uniform_C1_slip_corrected.met : Part_At.uniform_C1_slip_corrected.instance).
Check (Part_At_proofs.uniform_C2.proved : Part_At.uniform_C2.statement).
Check (Part_At_proofs.uniform_C2.met : Part_At.uniform_C2.instance).
Check (Part_At_proofs.uniform_jump.proved : Part_At.uniform_jump.statement).
Check (Part_At_proofs.uniform_jump.met : Part_At.uniform_jump.instance).
Check (Part_At_proofs.uniform_knot.proved : Part_At.uniform_knot.statement).
Check (Part_At_proofs.uniform_knot.met : Part_At.uniform_knot.instance).
Check (Part_At_proofs.uniform_knot_slip.refuted : ~ Part_At.uniform_knot_slip.statement).
Check (Part_At_proofs.uniform_knot_slip_corrected.proved : Part_At.uniform_knot_slip_corrected.statement).
Check (Part_At_proofs.uniform_knot_slip_corrected.met : Part_At.uniform_knot_slip_corrected.instance).
Check (Part_At_proofs.knots_C1.proved : Part_At.knots_C1.statement).
Check (Part_At_proofs.knots_C1.met : Part_At.knots_C1.instance).
Check (Part_At_proofs.knots_C1_value.proved : Part_At.knots_C1_value.statement).
Check (Part_At_proofs.knots_C1_value.met : Part_At.knots_C1_value.instance).
Check (Part_At_proofs.knots_C1_value_slip.refuted : ~ Part_At.knots_C1_value_slip.statement).
Check (Part_At_proofs.knots_C1_value_slip_corrected.proved : Part_At.knots_C1_value_slip_corrected.statement).
Check (Part_At_proofs.knots_C1_value_slip_corrected.met : Part_At.knots_C1_value_slip_corrected.instance).
Check (Part_At_proofs.knots_C2.proved : Part_At.knots_C2.statement).
Check (Part_At_proofs.knots_C2.met : Part_At.knots_C2.instance).
Check (Part_At_proofs.knots_convex.proved : Part_At.knots_convex.statement).
Check (Part_At_proofs.knots_convex.met : Part_At.knots_convex.instance).
Check (Part_B_printed_proofs.uniform_bezier.proved : Part_B_printed.uniform_bezier.statement).
Check (Part_B_printed_proofs.uniform_bezier.met : Part_B_printed.uniform_bezier.instance).
Check (Part_B_proofs.uniform_bezier.proved : Part_B.uniform_bezier.statement).
Check (Part_B_proofs.uniform_bezier.met : Part_B.uniform_bezier.instance).
Check (Part_Cubic_printed_proofs.uniform_cubic.proved : Part_Cubic_printed.uniform_cubic.statement).
Check (Part_Cubic_printed_proofs.uniform_cubic.met : Part_Cubic_printed.uniform_cubic.instance).
Check (Part_Cubic_printed_proofs.uniform_cubic_slip.refuted : ~ Part_Cubic_printed.uniform_cubic_slip.statement).
Check (Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.proved : Part_Cubic_printed.uniform_cubic_slip_corrected.statement).
Check (Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.met : Part_Cubic_printed.uniform_cubic_slip_corrected.instance).
Check (Part_Cubic_proofs.uniform_cubic.proved : Part_Cubic.uniform_cubic.statement).
Check (Part_Cubic_proofs.uniform_cubic.met : Part_Cubic.uniform_cubic.instance).
Check (Part_Cubic_proofs.uniform_cubic_slip.refuted : ~ Part_Cubic.uniform_cubic_slip.statement).
Check (Part_Cubic_proofs.uniform_cubic_slip_corrected.proved : Part_Cubic.uniform_cubic_slip_corrected.statement).
Check (Part_Cubic_proofs.uniform_cubic_slip_corrected.met : Part_Cubic.uniform_cubic_slip_corrected.instance).
Check (Part_Derivatives_printed_proofs.uniform_rate.proved : Part_Derivatives_printed.uniform_rate.statement).
Check (Part_Derivatives_printed_proofs.uniform_rate.met : Part_Derivatives_printed.uniform_rate.instance).
Check (Part_Derivatives_printed_proofs.knots_rate.proved : Part_Derivatives_printed.knots_rate.statement).
Check (Part_Derivatives_printed_proofs.knots_rate.met : Part_Derivatives_printed.knots_rate.instance).
Check (Part_Derivatives_printed_proofs.knots_rate_slip.refuted : ~ Part_Derivatives_printed.knots_rate_slip.statement).
Check (Part_Derivatives_printed_proofs.knots_rate_slip_corrected.proved : Part_Derivatives_printed.knots_rate_slip_corrected.statement).
Check (Part_Derivatives_printed_proofs.knots_rate_slip_corrected.met : Part_Derivatives_printed.knots_rate_slip_corrected.instance).
Check (Part_Derivatives_proofs.uniform_rate.proved : Part_Derivatives.uniform_rate.statement).
Check (Part_Derivatives_proofs.uniform_rate.met : Part_Derivatives.uniform_rate.instance).
Check (Part_Derivatives_proofs.knots_rate.proved : Part_Derivatives.knots_rate.statement).
Check (Part_Derivatives_proofs.knots_rate.met : Part_Derivatives.knots_rate.instance).
Check (Part_Derivatives_proofs.knots_rate_slip.refuted : ~ Part_Derivatives.knots_rate_slip.statement).
Check (Part_Derivatives_proofs.knots_rate_slip_corrected.proved : Part_Derivatives.knots_rate_slip_corrected.statement).
Check (Part_Derivatives_proofs.knots_rate_slip_corrected.met : Part_Derivatives.knots_rate_slip_corrected.instance).
Check (Part_One_printed_proofs.clamped_bernstein.proved : Part_One_printed.clamped_bernstein.statement).
Check (Part_One_proofs.clamped_bernstein.proved : Part_One.clamped_bernstein.statement).
Check (Part_Partition_printed_proofs.uniform_unity.proved : Part_Partition_printed.uniform_unity.statement).
Check (Part_Partition_printed_proofs.uniform_unity.met : Part_Partition_printed.uniform_unity.instance).
Check (Part_Partition_printed_proofs.knots_unity_quadratic.proved : Part_Partition_printed.knots_unity_quadratic.statement).
Check (Part_Partition_printed_proofs.knots_unity_quadratic.met : Part_Partition_printed.knots_unity_quadratic.instance).
Check (Part_Partition_printed_proofs.knots_unity_cubic.proved : Part_Partition_printed.knots_unity_cubic.statement).
Check (Part_Partition_printed_proofs.knots_unity_cubic.met : Part_Partition_printed.knots_unity_cubic.instance).
Check (Part_Partition_printed_proofs.knots_unity_equal.proved : Part_Partition_printed.knots_unity_equal.statement).
Check (Part_Partition_printed_proofs.knots_unity_equal.met : Part_Partition_printed.knots_unity_equal.instance).
Check (Part_Partition_proofs.uniform_unity.proved : Part_Partition.uniform_unity.statement).
Check (Part_Partition_proofs.uniform_unity.met : Part_Partition.uniform_unity.instance).
Check (Part_Partition_proofs.knots_unity_quadratic.proved : Part_Partition.knots_unity_quadratic.statement).
Check (Part_Partition_proofs.knots_unity_quadratic.met : Part_Partition.knots_unity_quadratic.instance).
Check (Part_Partition_proofs.knots_unity_cubic.proved : Part_Partition.knots_unity_cubic.statement).
Check (Part_Partition_proofs.knots_unity_cubic.met : Part_Partition.knots_unity_cubic.instance).
Check (Part_Partition_proofs.knots_unity_equal.proved : Part_Partition.knots_unity_equal.statement).
Check (Part_Partition_proofs.knots_unity_equal.met : Part_Partition.knots_unity_equal.instance).
Check (Part_Polynomials_printed_proofs.uniform_greville.proved : Part_Polynomials_printed.uniform_greville.statement).
Check (Part_Polynomials_printed_proofs.uniform_greville.met : Part_Polynomials_printed.uniform_greville.instance).
Check (Part_Polynomials_printed_proofs.uniform_marsden.proved : Part_Polynomials_printed.uniform_marsden.statement).
Check (Part_Polynomials_printed_proofs.uniform_marsden.met : Part_Polynomials_printed.uniform_marsden.instance).
Check (Part_Polynomials_printed_proofs.uniform_marsden_slip.refuted : ~ Part_Polynomials_printed.uniform_marsden_slip.statement).
Check (Part_Polynomials_printed_proofs.knots_greville.proved : Part_Polynomials_printed.knots_greville.statement).
Check (Part_Polynomials_printed_proofs.knots_greville.met : Part_Polynomials_printed.knots_greville.instance).
Check (Part_Polynomials_printed_proofs.knots_marsden.proved : Part_Polynomials_printed.knots_marsden.statement).
Check (Part_Polynomials_printed_proofs.knots_marsden.met : Part_Polynomials_printed.knots_marsden.instance).
Check (Part_Polynomials_printed_proofs.knots_marsden_cubic.proved : Part_Polynomials_printed.knots_marsden_cubic.statement).
Check (Part_Polynomials_printed_proofs.knots_marsden_cubic.met : Part_Polynomials_printed.knots_marsden_cubic.instance).
Check (Part_Polynomials_proofs.uniform_greville.proved : Part_Polynomials.uniform_greville.statement).
Check (Part_Polynomials_proofs.uniform_greville.met : Part_Polynomials.uniform_greville.instance).
Check (Part_Polynomials_proofs.uniform_marsden.proved : Part_Polynomials.uniform_marsden.statement).
Check (Part_Polynomials_proofs.uniform_marsden.met : Part_Polynomials.uniform_marsden.instance).
Check (Part_Polynomials_proofs.uniform_marsden_slip.refuted : ~ Part_Polynomials.uniform_marsden_slip.statement).
Check (Part_Polynomials_proofs.knots_greville.proved : Part_Polynomials.knots_greville.statement).
Check (Part_Polynomials_proofs.knots_greville.met : Part_Polynomials.knots_greville.instance).
Check (Part_Polynomials_proofs.knots_marsden.proved : Part_Polynomials.knots_marsden.statement).
Check (Part_Polynomials_proofs.knots_marsden.met : Part_Polynomials.knots_marsden.instance).
Check (Part_Polynomials_proofs.knots_marsden_cubic.proved : Part_Polynomials.knots_marsden_cubic.statement).
Check (Part_Polynomials_proofs.knots_marsden_cubic.met : Part_Polynomials.knots_marsden_cubic.instance).
Check (Part_Quadratic_printed_proofs.uniform_quadratic.proved : Part_Quadratic_printed.uniform_quadratic.statement).
Check (Part_Quadratic_printed_proofs.uniform_quadratic.met : Part_Quadratic_printed.uniform_quadratic.instance).
Check (Part_Quadratic_proofs.uniform_quadratic.proved : Part_Quadratic.uniform_quadratic.statement).
Check (Part_Quadratic_proofs.uniform_quadratic.met : Part_Quadratic.uniform_quadratic.instance).
Check (Part_Shape_printed_proofs.uniform_line.proved : Part_Shape_printed.uniform_line.statement).
Check (Part_Shape_printed_proofs.uniform_line.met : Part_Shape_printed.uniform_line.instance).
Check (Part_Shape_proofs.uniform_line.proved : Part_Shape.uniform_line.statement).
Check (Part_Shape_proofs.uniform_line.met : Part_Shape.uniform_line.instance).
Check (Part_Signs_printed_proofs.uniform_nonnegative.proved : Part_Signs_printed.uniform_nonnegative.statement).
Check (Part_Signs_printed_proofs.uniform_nonnegative.met : Part_Signs_printed.uniform_nonnegative.instance).
Check (Part_Signs_printed_proofs.uniform_bound.proved : Part_Signs_printed.uniform_bound.statement).
Check (Part_Signs_printed_proofs.uniform_bound.met : Part_Signs_printed.uniform_bound.instance).
Check (Part_Signs_printed_proofs.uniform_bound_slip.refuted : ~ Part_Signs_printed.uniform_bound_slip.statement).
Check (Part_Signs_printed_proofs.knots_nonnegative_ends.proved : Part_Signs_printed.knots_nonnegative_ends.statement).
Check (Part_Signs_printed_proofs.knots_nonnegative_ends.met : Part_Signs_printed.knots_nonnegative_ends.instance).
Check (Part_Signs_printed_proofs.knots_nonnegative_middle.proved : Part_Signs_printed.knots_nonnegative_middle.statement).
Check (Part_Signs_printed_proofs.knots_nonnegative_middle.met : Part_Signs_printed.knots_nonnegative_middle.instance).
Check (Part_Signs_printed_proofs.knots_nonnegative_outside.refuted : ~ Part_Signs_printed.knots_nonnegative_outside.statement).
Check (Part_Signs_printed_proofs.knots_nonnegative_cubic.proved : Part_Signs_printed.knots_nonnegative_cubic.statement).
Check (Part_Signs_printed_proofs.knots_nonnegative_cubic.met : Part_Signs_printed.knots_nonnegative_cubic.instance).
Check (Part_Signs_proofs.uniform_nonnegative.proved : Part_Signs.uniform_nonnegative.statement).
Check (Part_Signs_proofs.uniform_nonnegative.met : Part_Signs.uniform_nonnegative.instance).
Check (Part_Signs_proofs.uniform_bound.proved : Part_Signs.uniform_bound.statement).
Check (Part_Signs_proofs.uniform_bound.met : Part_Signs.uniform_bound.instance).
Check (Part_Signs_proofs.uniform_bound_slip.refuted : ~ Part_Signs.uniform_bound_slip.statement).
Check (Part_Signs_proofs.knots_nonnegative_ends.proved : Part_Signs.knots_nonnegative_ends.statement).
Check (Part_Signs_proofs.knots_nonnegative_ends.met : Part_Signs.knots_nonnegative_ends.instance).
Check (Part_Signs_proofs.knots_nonnegative_middle.proved : Part_Signs.knots_nonnegative_middle.statement).
Check (Part_Signs_proofs.knots_nonnegative_middle.met : Part_Signs.knots_nonnegative_middle.instance).
Check (Part_Signs_proofs.knots_nonnegative_outside.refuted : ~ Part_Signs.knots_nonnegative_outside.statement).
Check (Part_Signs_proofs.knots_nonnegative_cubic.proved : Part_Signs.knots_nonnegative_cubic.statement).
Check (Part_Signs_proofs.knots_nonnegative_cubic.met : Part_Signs.knots_nonnegative_cubic.instance).
Check (Part_Symmetry_printed_proofs.uniform_symmetry.proved : Part_Symmetry_printed.uniform_symmetry.statement).
Check (Part_Symmetry_printed_proofs.uniform_symmetry.met : Part_Symmetry_printed.uniform_symmetry.instance).
Check (Part_Symmetry_proofs.uniform_symmetry.proved : Part_Symmetry.uniform_symmetry.statement).
Check (Part_Symmetry_proofs.uniform_symmetry.met : Part_Symmetry.uniform_symmetry.instance).
Check (Part_The_printed_proofs.knots_linear.proved : Part_The_printed.knots_linear.statement).
Check (Part_The_printed_proofs.knots_linear.met : Part_The_printed.knots_linear.instance).
Check (Part_The_printed_proofs.knots_quadratic.proved : Part_The_printed.knots_quadratic.statement).
Check (Part_The_printed_proofs.knots_quadratic.met : Part_The_printed.knots_quadratic.instance).
Check (Part_The_printed_proofs.knots_quadratic_slip.refuted : ~ Part_The_printed.knots_quadratic_slip.statement).
Check (Part_The_printed_proofs.knots_quadratic_slip_corrected.proved : Part_The_printed.knots_quadratic_slip_corrected.statement).
Check (Part_The_printed_proofs.knots_quadratic_slip_corrected.met : Part_The_printed.knots_quadratic_slip_corrected.instance).
Check (Part_The_printed_proofs.knots_span.proved : Part_The_printed.knots_span.statement).
Check (Part_The_printed_proofs.knots_span.met : Part_The_printed.knots_span.instance).
Check (Part_The_proofs.knots_linear.proved : Part_The.knots_linear.statement).
Check (Part_The_proofs.knots_linear.met : Part_The.knots_linear.instance).
Check (Part_The_proofs.knots_quadratic.proved : Part_The.knots_quadratic.statement).
Check (Part_The_proofs.knots_quadratic.met : Part_The.knots_quadratic.instance).
Check (Part_The_proofs.knots_quadratic_slip.refuted : ~ Part_The.knots_quadratic_slip.statement).
Check (Part_The_proofs.knots_quadratic_slip_corrected.proved : Part_The.knots_quadratic_slip_corrected.statement).
Check (Part_The_proofs.knots_quadratic_slip_corrected.met : Part_The.knots_quadratic_slip_corrected.instance).
Check (Part_The_proofs.knots_span.proved : Part_The.knots_span.statement).
Check (Part_The_proofs.knots_span.met : Part_The.knots_span.instance).
Check (Part_Two_printed_proofs.uniform_two_scale_quadratic.proved : Part_Two_printed.uniform_two_scale_quadratic.statement).
Check (Part_Two_printed_proofs.uniform_two_scale_quadratic.met : Part_Two_printed.uniform_two_scale_quadratic.instance).
Check (Part_Two_printed_proofs.uniform_two_scale_cubic.proved : Part_Two_printed.uniform_two_scale_cubic.statement).
Check (Part_Two_printed_proofs.uniform_two_scale_cubic.met : Part_Two_printed.uniform_two_scale_cubic.instance).
Check (Part_Two_printed_proofs.uniform_two_scale_slip.refuted : ~ Part_Two_printed.uniform_two_scale_slip.statement).
Check (Part_Two_printed_proofs.clamped_unity.proved : Part_Two_printed.clamped_unity.statement).
Check (Part_Two_printed_proofs.clamped_unity.met : Part_Two_printed.clamped_unity.instance).
Check (Part_Two_printed_proofs.clamped_ends.proved : Part_Two_printed.clamped_ends.statement).
Check (Part_Two_printed_proofs.clamped_ends.met : Part_Two_printed.clamped_ends.instance).
Check (Part_Two_printed_proofs.clamped_tangents.proved : Part_Two_printed.clamped_tangents.statement).
Check (Part_Two_printed_proofs.clamped_tangents.met : Part_Two_printed.clamped_tangents.instance).
Check (Part_Two_printed_proofs.clamped_tangents_slip.refuted : ~ Part_Two_printed.clamped_tangents_slip.statement).
Check (Part_Two_printed_proofs.clamped_C1.proved : Part_Two_printed.clamped_C1.statement).
Check (Part_Two_printed_proofs.clamped_C1.met : Part_Two_printed.clamped_C1.instance).
Check (Part_Two_printed_proofs.clamped_knot.proved : Part_Two_printed.clamped_knot.statement).
Check (Part_Two_printed_proofs.clamped_knot.met : Part_Two_printed.clamped_knot.instance).
Check (Part_Two_printed_proofs.clamped_C2.refuted : ~ Part_Two_printed.clamped_C2.statement).
Check (Part_Two_proofs.uniform_two_scale_quadratic.proved : Part_Two.uniform_two_scale_quadratic.statement).
Check (Part_Two_proofs.uniform_two_scale_quadratic.met : Part_Two.uniform_two_scale_quadratic.instance).
Check (Part_Two_proofs.uniform_two_scale_cubic.proved : Part_Two.uniform_two_scale_cubic.statement).
Check (Part_Two_proofs.uniform_two_scale_cubic.met : Part_Two.uniform_two_scale_cubic.instance).
Check (Part_Two_proofs.uniform_two_scale_slip.refuted : ~ Part_Two.uniform_two_scale_slip.statement).
Check (Part_Two_proofs.clamped_unity.proved : Part_Two.clamped_unity.statement).
Check (Part_Two_proofs.clamped_unity.met : Part_Two.clamped_unity.instance).
Check (Part_Two_proofs.clamped_ends.proved : Part_Two.clamped_ends.statement).
Check (Part_Two_proofs.clamped_ends.met : Part_Two.clamped_ends.instance).
Check (Part_Two_proofs.clamped_tangents.proved : Part_Two.clamped_tangents.statement).
Check (Part_Two_proofs.clamped_tangents.met : Part_Two.clamped_tangents.instance).
Check (Part_Two_proofs.clamped_tangents_slip.refuted : ~ Part_Two.clamped_tangents_slip.statement).
Check (Part_Two_proofs.clamped_C1.proved : Part_Two.clamped_C1.statement).
Check (Part_Two_proofs.clamped_C1.met : Part_Two.clamped_C1.instance).
Check (Part_Two_proofs.clamped_knot.proved : Part_Two.clamped_knot.statement).
Check (Part_Two_proofs.clamped_knot.met : Part_Two.clamped_knot.instance).
Check (Part_Two_proofs.clamped_C2.refuted : ~ Part_Two.clamped_C2.statement).
Definition all_theorems : True :=
let _ := Part_At_printed_proofs.uniform_C1.proved in
let _ := Part_At_printed_proofs.uniform_C1.met in
let _ := Part_At_printed_proofs.uniform_C1_slip.refuted in
let _ := Part_At_printed_proofs.uniform_C1_slip_corrected.proved in
let _ := Part_At_printed_proofs.uniform_C1_slip_corrected.met in
let _ := Part_At_printed_proofs.uniform_C2.proved in
let _ := Part_At_printed_proofs.uniform_C2.met in
let _ := Part_At_printed_proofs.uniform_jump.proved in
let _ := Part_At_printed_proofs.uniform_jump.met in
let _ := Part_At_printed_proofs.uniform_knot.proved in
let _ := Part_At_printed_proofs.uniform_knot.met in
let _ := Part_At_printed_proofs.uniform_knot_slip.refuted in
let _ := Part_At_printed_proofs.uniform_knot_slip_corrected.proved in
let _ := Part_At_printed_proofs.uniform_knot_slip_corrected.met in
let _ := Part_At_printed_proofs.knots_C1.proved in
let _ := Part_At_printed_proofs.knots_C1.met in
let _ := Part_At_printed_proofs.knots_C1_value.proved in
let _ := Part_At_printed_proofs.knots_C1_value.met in
let _ := Part_At_printed_proofs.knots_C1_value_slip.refuted in
let _ := Part_At_printed_proofs.knots_C1_value_slip_corrected.proved in
let _ := Part_At_printed_proofs.knots_C1_value_slip_corrected.met in
let _ := Part_At_printed_proofs.knots_C2.proved in
let _ := Part_At_printed_proofs.knots_C2.met in
let _ := Part_At_printed_proofs.knots_convex.proved in
let _ := Part_At_printed_proofs.knots_convex.met in
let _ := Part_At_proofs.uniform_C1.proved in
let _ := Part_At_proofs.uniform_C1.met in
let _ := Part_At_proofs.uniform_C1_slip.refuted in
let _ := Part_At_proofs.uniform_C1_slip_corrected.proved in
let _ := Part_At_proofs.uniform_C1_slip_corrected.met in
let _ := Part_At_proofs.uniform_C2.proved in
let _ := Part_At_proofs.uniform_C2.met in
let _ := Part_At_proofs.uniform_jump.proved in
let _ := Part_At_proofs.uniform_jump.met in
let _ := Part_At_proofs.uniform_knot.proved in
let _ := Part_At_proofs.uniform_knot.met in
let _ := Part_At_proofs.uniform_knot_slip.refuted in
let _ := Part_At_proofs.uniform_knot_slip_corrected.proved in
let _ := Part_At_proofs.uniform_knot_slip_corrected.met in
let _ := Part_At_proofs.knots_C1.proved in
let _ := Part_At_proofs.knots_C1.met in
let _ := Part_At_proofs.knots_C1_value.proved in
let _ := Part_At_proofs.knots_C1_value.met in
let _ := Part_At_proofs.knots_C1_value_slip.refuted in
let _ := Part_At_proofs.knots_C1_value_slip_corrected.proved in
let _ := Part_At_proofs.knots_C1_value_slip_corrected.met in
let _ := Part_At_proofs.knots_C2.proved in
let _ := Part_At_proofs.knots_C2.met in
let _ := Part_At_proofs.knots_convex.proved in
let _ := Part_At_proofs.knots_convex.met in
let _ := Part_B_printed_proofs.uniform_bezier.proved in
let _ := Part_B_printed_proofs.uniform_bezier.met in
let _ := Part_B_proofs.uniform_bezier.proved in
let _ := Part_B_proofs.uniform_bezier.met in
let _ := Part_Cubic_printed_proofs.uniform_cubic.proved in
let _ := Part_Cubic_printed_proofs.uniform_cubic.met in
let _ := Part_Cubic_printed_proofs.uniform_cubic_slip.refuted in
let _ := Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.proved in
let _ := Part_Cubic_printed_proofs.uniform_cubic_slip_corrected.met in
let _ := Part_Cubic_proofs.uniform_cubic.proved in
let _ := Part_Cubic_proofs.uniform_cubic.met in
let _ := Part_Cubic_proofs.uniform_cubic_slip.refuted in
let _ := Part_Cubic_proofs.uniform_cubic_slip_corrected.proved in
let _ := Part_Cubic_proofs.uniform_cubic_slip_corrected.met in
let _ := Part_Derivatives_printed_proofs.uniform_rate.proved in
let _ := Part_Derivatives_printed_proofs.uniform_rate.met in
let _ := Part_Derivatives_printed_proofs.knots_rate.proved in
let _ := Part_Derivatives_printed_proofs.knots_rate.met in
let _ := Part_Derivatives_printed_proofs.knots_rate_slip.refuted in
let _ := Part_Derivatives_printed_proofs.knots_rate_slip_corrected.proved in
let _ := Part_Derivatives_printed_proofs.knots_rate_slip_corrected.met in
let _ := Part_Derivatives_proofs.uniform_rate.proved in
let _ := Part_Derivatives_proofs.uniform_rate.met in
let _ := Part_Derivatives_proofs.knots_rate.proved in
let _ := Part_Derivatives_proofs.knots_rate.met in
let _ := Part_Derivatives_proofs.knots_rate_slip.refuted in
let _ := Part_Derivatives_proofs.knots_rate_slip_corrected.proved in
let _ := Part_Derivatives_proofs.knots_rate_slip_corrected.met in
let _ := Part_One_printed_proofs.clamped_bernstein.proved in
let _ := Part_One_proofs.clamped_bernstein.proved in
let _ := Part_Partition_printed_proofs.uniform_unity.proved in
let _ := Part_Partition_printed_proofs.uniform_unity.met in
let _ := Part_Partition_printed_proofs.knots_unity_quadratic.proved in
let _ := Part_Partition_printed_proofs.knots_unity_quadratic.met in
let _ := Part_Partition_printed_proofs.knots_unity_cubic.proved in
let _ := Part_Partition_printed_proofs.knots_unity_cubic.met in
let _ := Part_Partition_printed_proofs.knots_unity_equal.proved in
let _ := Part_Partition_printed_proofs.knots_unity_equal.met in
let _ := Part_Partition_proofs.uniform_unity.proved in
let _ := Part_Partition_proofs.uniform_unity.met in
let _ := Part_Partition_proofs.knots_unity_quadratic.proved in
let _ := Part_Partition_proofs.knots_unity_quadratic.met in
let _ := Part_Partition_proofs.knots_unity_cubic.proved in
let _ := Part_Partition_proofs.knots_unity_cubic.met in
let _ := Part_Partition_proofs.knots_unity_equal.proved in
let _ := Part_Partition_proofs.knots_unity_equal.met in
let _ := Part_Polynomials_printed_proofs.uniform_greville.proved in
let _ := Part_Polynomials_printed_proofs.uniform_greville.met in
let _ := Part_Polynomials_printed_proofs.uniform_marsden.proved in
let _ := Part_Polynomials_printed_proofs.uniform_marsden.met in
let _ := Part_Polynomials_printed_proofs.uniform_marsden_slip.refuted in
let _ := Part_Polynomials_printed_proofs.knots_greville.proved in
let _ := Part_Polynomials_printed_proofs.knots_greville.met in
let _ := Part_Polynomials_printed_proofs.knots_marsden.proved in
let _ := Part_Polynomials_printed_proofs.knots_marsden.met in
let _ := Part_Polynomials_printed_proofs.knots_marsden_cubic.proved in
let _ := Part_Polynomials_printed_proofs.knots_marsden_cubic.met in
let _ := Part_Polynomials_proofs.uniform_greville.proved in
let _ := Part_Polynomials_proofs.uniform_greville.met in
let _ := Part_Polynomials_proofs.uniform_marsden.proved in
let _ := Part_Polynomials_proofs.uniform_marsden.met in
let _ := Part_Polynomials_proofs.uniform_marsden_slip.refuted in
let _ := Part_Polynomials_proofs.knots_greville.proved in
let _ := Part_Polynomials_proofs.knots_greville.met in
let _ := Part_Polynomials_proofs.knots_marsden.proved in
let _ := Part_Polynomials_proofs.knots_marsden.met in
let _ := Part_Polynomials_proofs.knots_marsden_cubic.proved in
let _ := Part_Polynomials_proofs.knots_marsden_cubic.met in
let _ := Part_Quadratic_printed_proofs.uniform_quadratic.proved in
let _ := Part_Quadratic_printed_proofs.uniform_quadratic.met in
let _ := Part_Quadratic_proofs.uniform_quadratic.proved in
let _ := Part_Quadratic_proofs.uniform_quadratic.met in
let _ := Part_Shape_printed_proofs.uniform_line.proved in
let _ := Part_Shape_printed_proofs.uniform_line.met in
let _ := Part_Shape_proofs.uniform_line.proved in
let _ := Part_Shape_proofs.uniform_line.met in
let _ := Part_Signs_printed_proofs.uniform_nonnegative.proved in
let _ := Part_Signs_printed_proofs.uniform_nonnegative.met in
let _ := Part_Signs_printed_proofs.uniform_bound.proved in
let _ := Part_Signs_printed_proofs.uniform_bound.met in
let _ := Part_Signs_printed_proofs.uniform_bound_slip.refuted in
let _ := Part_Signs_printed_proofs.knots_nonnegative_ends.proved in
let _ := Part_Signs_printed_proofs.knots_nonnegative_ends.met in
let _ := Part_Signs_printed_proofs.knots_nonnegative_middle.proved in
let _ := Part_Signs_printed_proofs.knots_nonnegative_middle.met in
let _ := Part_Signs_printed_proofs.knots_nonnegative_outside.refuted in
let _ := Part_Signs_printed_proofs.knots_nonnegative_cubic.proved in
let _ := Part_Signs_printed_proofs.knots_nonnegative_cubic.met in
let _ := Part_Signs_proofs.uniform_nonnegative.proved in
let _ := Part_Signs_proofs.uniform_nonnegative.met in
let _ := Part_Signs_proofs.uniform_bound.proved in
let _ := Part_Signs_proofs.uniform_bound.met in
let _ := Part_Signs_proofs.uniform_bound_slip.refuted in
let _ := Part_Signs_proofs.knots_nonnegative_ends.proved in
let _ := Part_Signs_proofs.knots_nonnegative_ends.met in
let _ := Part_Signs_proofs.knots_nonnegative_middle.proved in
let _ := Part_Signs_proofs.knots_nonnegative_middle.met in
let _ := Part_Signs_proofs.knots_nonnegative_outside.refuted in
let _ := Part_Signs_proofs.knots_nonnegative_cubic.proved in
let _ := Part_Signs_proofs.knots_nonnegative_cubic.met in
let _ := Part_Symmetry_printed_proofs.uniform_symmetry.proved in
let _ := Part_Symmetry_printed_proofs.uniform_symmetry.met in
let _ := Part_Symmetry_proofs.uniform_symmetry.proved in
let _ := Part_Symmetry_proofs.uniform_symmetry.met in
let _ := Part_The_printed_proofs.knots_linear.proved in
let _ := Part_The_printed_proofs.knots_linear.met in
let _ := Part_The_printed_proofs.knots_quadratic.proved in
let _ := Part_The_printed_proofs.knots_quadratic.met in
let _ := Part_The_printed_proofs.knots_quadratic_slip.refuted in
let _ := Part_The_printed_proofs.knots_quadratic_slip_corrected.proved in
let _ := Part_The_printed_proofs.knots_quadratic_slip_corrected.met in
let _ := Part_The_printed_proofs.knots_span.proved in
let _ := Part_The_printed_proofs.knots_span.met in
let _ := Part_The_proofs.knots_linear.proved in
let _ := Part_The_proofs.knots_linear.met in
let _ := Part_The_proofs.knots_quadratic.proved in
let _ := Part_The_proofs.knots_quadratic.met in
let _ := Part_The_proofs.knots_quadratic_slip.refuted in
let _ := Part_The_proofs.knots_quadratic_slip_corrected.proved in
let _ := Part_The_proofs.knots_quadratic_slip_corrected.met in
let _ := Part_The_proofs.knots_span.proved in
let _ := Part_The_proofs.knots_span.met in
let _ := Part_Two_printed_proofs.uniform_two_scale_quadratic.proved in
let _ := Part_Two_printed_proofs.uniform_two_scale_quadratic.met in
let _ := Part_Two_printed_proofs.uniform_two_scale_cubic.proved in
let _ := Part_Two_printed_proofs.uniform_two_scale_cubic.met in
let _ := Part_Two_printed_proofs.uniform_two_scale_slip.refuted in
let _ := Part_Two_printed_proofs.clamped_unity.proved in
let _ := Part_Two_printed_proofs.clamped_unity.met in
let _ := Part_Two_printed_proofs.clamped_ends.proved in
let _ := Part_Two_printed_proofs.clamped_ends.met in
let _ := Part_Two_printed_proofs.clamped_tangents.proved in
let _ := Part_Two_printed_proofs.clamped_tangents.met in
let _ := Part_Two_printed_proofs.clamped_tangents_slip.refuted in
let _ := Part_Two_printed_proofs.clamped_C1.proved in
let _ := Part_Two_printed_proofs.clamped_C1.met in
let _ := Part_Two_printed_proofs.clamped_knot.proved in
let _ := Part_Two_printed_proofs.clamped_knot.met in
let _ := Part_Two_printed_proofs.clamped_C2.refuted in
let _ := Part_Two_proofs.uniform_two_scale_quadratic.proved in
let _ := Part_Two_proofs.uniform_two_scale_quadratic.met in
let _ := Part_Two_proofs.uniform_two_scale_cubic.proved in
let _ := Part_Two_proofs.uniform_two_scale_cubic.met in
let _ := Part_Two_proofs.uniform_two_scale_slip.refuted in
let _ := Part_Two_proofs.clamped_unity.proved in
let _ := Part_Two_proofs.clamped_unity.met in
let _ := Part_Two_proofs.clamped_ends.proved in
let _ := Part_Two_proofs.clamped_ends.met in
let _ := Part_Two_proofs.clamped_tangents.proved in
let _ := Part_Two_proofs.clamped_tangents.met in
let _ := Part_Two_proofs.clamped_tangents_slip.refuted in
let _ := Part_Two_proofs.clamped_C1.proved in
let _ := Part_Two_proofs.clamped_C1.met in
let _ := Part_Two_proofs.clamped_knot.proved in
let _ := Part_Two_proofs.clamped_knot.met in
let _ := Part_Two_proofs.clamped_C2.refuted in
I.
