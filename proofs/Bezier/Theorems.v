(* The kernel's word: each theorem has the type of its statement. *)
From Bezier Require Part_A_printed Part_A_printed_proofs.
From Bezier Require Part_A Part_A_proofs.
From Bezier Require Part_Algebraic_printed Part_Algebraic_printed_proofs.
From Bezier Require Part_Algebraic Part_Algebraic_proofs.
From Bezier Require Part_Bounds_printed Part_Bounds_printed_proofs.
From Bezier Require Part_Bounds Part_Bounds_proofs.
From Bezier Require Part_C_printed Part_C_printed_proofs.
From Bezier Require Part_C Part_C_proofs.
From Bezier Require Part_Closed_printed Part_Closed_printed_proofs.
From Bezier Require Part_Closed Part_Closed_proofs.
From Bezier Require Part_De_printed Part_De_printed_proofs.
From Bezier Require Part_De Part_De_proofs.
From Bezier Require Part_Definition_printed Part_Definition_printed_proofs.
From Bezier Require Part_Definition Part_Definition_proofs.
From Bezier Require Part_Degree_printed Part_Degree_printed_proofs.
From Bezier Require Part_Degree Part_Degree_proofs.
From Bezier Require Part_Derivative_printed Part_Derivative_printed_proofs.
From Bezier Require Part_Derivative Part_Derivative_proofs.
From Bezier Require Part_Divisors_printed Part_Divisors_printed_proofs.
From Bezier Require Part_Divisors Part_Divisors_proofs.
From Bezier Require Part_End_printed Part_End_printed_proofs.
From Bezier Require Part_End Part_End_proofs.
From Bezier Require Part_Families_printed Part_Families_printed_proofs.
From Bezier Require Part_Families Part_Families_proofs.
From Bezier Require Part_G_printed Part_G_printed_proofs.
From Bezier Require Part_G Part_G_proofs.
From Bezier Require Part_Hodograph_printed Part_Hodograph_printed_proofs.
From Bezier Require Part_Hodograph Part_Hodograph_proofs.
From Bezier Require Part_Linear_printed Part_Linear_printed_proofs.
From Bezier Require Part_Linear Part_Linear_proofs.
From Bezier Require Part_Lists_printed Part_Lists_printed_proofs.
From Bezier Require Part_Lists Part_Lists_proofs.
From Bezier Require Part_Logic_printed Part_Logic_printed_proofs.
From Bezier Require Part_Logic Part_Logic_proofs.
From Bezier Require Part_Nonnegativity_printed Part_Nonnegativity_printed_proofs.
From Bezier Require Part_Nonnegativity Part_Nonnegativity_proofs.
From Bezier Require Part_Numbers_printed Part_Numbers_printed_proofs.
From Bezier Require Part_Numbers Part_Numbers_proofs.
From Bezier Require Part_Partition_printed Part_Partition_printed_proofs.
From Bezier Require Part_Partition Part_Partition_proofs.
From Bezier Require Part_Powers_printed Part_Powers_printed_proofs.
From Bezier Require Part_Powers Part_Powers_proofs.
From Bezier Require Part_README_printed Part_README_printed_proofs.
From Bezier Require Part_README Part_README_proofs.
From Bezier Require Part_Reflection_printed Part_Reflection_printed_proofs.
From Bezier Require Part_Reflection Part_Reflection_proofs.
From Bezier Require Part_Roots_printed Part_Roots_printed_proofs.
From Bezier Require Part_Roots Part_Roots_proofs.
From Bezier Require Part_Subdivision_printed Part_Subdivision_printed_proofs.
From Bezier Require Part_Subdivision Part_Subdivision_proofs.
From Bezier Require Part_Sums_printed Part_Sums_printed_proofs.
From Bezier Require Part_Sums Part_Sums_proofs.
From Bezier Require Part_Symmetry_printed Part_Symmetry_printed_proofs.
From Bezier Require Part_Symmetry Part_Symmetry_proofs.
From Bezier Require Part_The_printed Part_The_printed_proofs.
From Bezier Require Part_The Part_The_proofs.
Check (Part_A_printed_proofs.trigonometric_circle.proved : Part_A_printed.trigonometric_circle.statement).
Check (Part_A_printed_proofs.trigonometric_circle.met : Part_A_printed.trigonometric_circle.instance).
Check (Part_A_proofs.trigonometric_circle.proved : Part_A.trigonometric_circle.statement).
Check (Part_A_proofs.trigonometric_circle.met : Part_A.trigonometric_circle.instance).
Check (Part_Algebraic_printed_proofs.reach_root.proved : Part_Algebraic_printed.reach_root.statement).
Check (Part_Algebraic_printed_proofs.reach_root.met : Part_Algebraic_printed.reach_root.instance).
Check (Part_Algebraic_printed_proofs.reach_square.proved : Part_Algebraic_printed.reach_square.statement).
Check (Part_Algebraic_printed_proofs.reach_square.met : Part_Algebraic_printed.reach_square.instance).
Check (Part_Algebraic_proofs.reach_root.proved : Part_Algebraic.reach_root.statement).
Check (Part_Algebraic_proofs.reach_root.met : Part_Algebraic.reach_root.instance).
Check (Part_Algebraic_proofs.reach_square.proved : Part_Algebraic.reach_square.statement).
Check (Part_Algebraic_proofs.reach_square.met : Part_Algebraic.reach_square.instance).
Check (Part_Bounds_printed_proofs.reach_surd.proved : Part_Bounds_printed.reach_surd.statement).
Check (Part_Bounds_printed_proofs.reach_surd.met : Part_Bounds_printed.reach_surd.instance).
Check (Part_Bounds_printed_proofs.reach_simplex.proved : Part_Bounds_printed.reach_simplex.statement).
Check (Part_Bounds_printed_proofs.reach_simplex.met : Part_Bounds_printed.reach_simplex.instance).
Check (Part_Bounds_printed_proofs.reach_between.proved : Part_Bounds_printed.reach_between.statement).
Check (Part_Bounds_printed_proofs.reach_between.met : Part_Bounds_printed.reach_between.instance).
Check (Part_Bounds_printed_proofs.reach_interval.proved : Part_Bounds_printed.reach_interval.statement).
Check (Part_Bounds_printed_proofs.reach_interval.met : Part_Bounds_printed.reach_interval.instance).
Check (Part_Bounds_printed_proofs.reach_interval_basis.proved : Part_Bounds_printed.reach_interval_basis.statement).
Check (Part_Bounds_printed_proofs.reach_interval_basis.met : Part_Bounds_printed.reach_interval_basis.instance).
Check (Part_Bounds_proofs.reach_surd.proved : Part_Bounds.reach_surd.statement).
Check (Part_Bounds_proofs.reach_surd.met : Part_Bounds.reach_surd.instance).
Check (Part_Bounds_proofs.reach_simplex.proved : Part_Bounds.reach_simplex.statement).
Check (Part_Bounds_proofs.reach_simplex.met : Part_Bounds.reach_simplex.instance).
Check (Part_Bounds_proofs.reach_between.proved : Part_Bounds.reach_between.statement).
Check (Part_Bounds_proofs.reach_between.met : Part_Bounds.reach_between.instance).
Check (Part_Bounds_proofs.reach_interval.proved : Part_Bounds.reach_interval.statement).
Check (Part_Bounds_proofs.reach_interval.met : Part_Bounds.reach_interval.instance).
Check (Part_Bounds_proofs.reach_interval_basis.proved : Part_Bounds.reach_interval_basis.statement).
Check (Part_Bounds_proofs.reach_interval_basis.met : Part_Bounds.reach_interval_basis.instance).
Check (Part_C_printed_proofs.join_C0.proved : Part_C_printed.join_C0.statement).
Check (Part_C_printed_proofs.join_C0.met : Part_C_printed.join_C0.instance).
Check (Part_C_printed_proofs.join_C1.proved : Part_C_printed.join_C1.statement).
Check (Part_C_printed_proofs.join_C1.met : Part_C_printed.join_C1.instance).
Check (Part_C_printed_proofs.join_C1_slip.refuted : ~ Part_C_printed.join_C1_slip.statement).
Check (Part_C_printed_proofs.join_C1_slip_corrected.proved : Part_C_printed.join_C1_slip_corrected.statement).
Check (Part_C_printed_proofs.join_C1_slip_corrected.met : Part_C_printed.join_C1_slip_corrected.instance).
Check (Part_C_printed_proofs.join_C2.proved : Part_C_printed.join_C2.statement).
Check (Part_C_printed_proofs.join_C2.met : Part_C_printed.join_C2.instance).
Check (Part_C_printed_proofs.join_C2_slip.refuted : ~ Part_C_printed.join_C2_slip.statement).
Check (Part_C_printed_proofs.join_C2_slip_corrected.proved : Part_C_printed.join_C2_slip_corrected.statement).
Check (Part_C_printed_proofs.join_C2_slip_corrected.met : Part_C_printed.join_C2_slip_corrected.instance).
Check (Part_C_printed_proofs.join_C3.proved : Part_C_printed.join_C3.statement).
Check (Part_C_printed_proofs.join_C3.met : Part_C_printed.join_C3.instance).
Check (Part_C_printed_proofs.join_C2_sufficient.proved : Part_C_printed.join_C2_sufficient.statement).
Check (Part_C_printed_proofs.join_C2_sufficient.met : Part_C_printed.join_C2_sufficient.instance).
Check (Part_C_printed_proofs.join_knot.proved : Part_C_printed.join_knot.statement).
Check (Part_C_printed_proofs.join_knot.met : Part_C_printed.join_knot.instance).
Check (Part_C_printed_proofs.trigonometric_C1.proved : Part_C_printed.trigonometric_C1.statement).
Check (Part_C_printed_proofs.trigonometric_C1.met : Part_C_printed.trigonometric_C1.instance).
Check (Part_C_printed_proofs.trigonometric_C1_inside.proved : Part_C_printed.trigonometric_C1_inside.statement).
Check (Part_C_printed_proofs.trigonometric_C1_inside.met : Part_C_printed.trigonometric_C1_inside.instance).
Check (Part_C_printed_proofs.trigonometric_bezier.proved : Part_C_printed.trigonometric_bezier.statement).
Check (Part_C_printed_proofs.trigonometric_bezier.met : Part_C_printed.trigonometric_bezier.instance).
Check (Part_C_proofs.join_C0.proved : Part_C.join_C0.statement).
Check (Part_C_proofs.join_C0.met : Part_C.join_C0.instance).
Check (Part_C_proofs.join_C1.proved : Part_C.join_C1.statement).
Check (Part_C_proofs.join_C1.met : Part_C.join_C1.instance).
Check (Part_C_proofs.join_C1_slip.refuted : ~ Part_C.join_C1_slip.statement).
Check (Part_C_proofs.join_C1_slip_corrected.proved : Part_C.join_C1_slip_corrected.statement).
Check (Part_C_proofs.join_C1_slip_corrected.met : Part_C.join_C1_slip_corrected.instance).
Check (Part_C_proofs.join_C2.proved : Part_C.join_C2.statement).
Check (Part_C_proofs.join_C2.met : Part_C.join_C2.instance).
Check (Part_C_proofs.join_C2_slip.refuted : ~ Part_C.join_C2_slip.statement).
Check (Part_C_proofs.join_C2_slip_corrected.proved : Part_C.join_C2_slip_corrected.statement).
Check (Part_C_proofs.join_C2_slip_corrected.met : Part_C.join_C2_slip_corrected.instance).
Check (Part_C_proofs.join_C3.proved : Part_C.join_C3.statement).
Check (Part_C_proofs.join_C3.met : Part_C.join_C3.instance).
Check (Part_C_proofs.join_C2_sufficient.proved : Part_C.join_C2_sufficient.statement).
Check (Part_C_proofs.join_C2_sufficient.met : Part_C.join_C2_sufficient.instance).
Check (Part_C_proofs.join_knot.proved : Part_C.join_knot.statement).
Check (Part_C_proofs.join_knot.met : Part_C.join_knot.instance).
Check (Part_C_proofs.trigonometric_C1.proved : Part_C.trigonometric_C1.statement).
Check (Part_C_proofs.trigonometric_C1.met : Part_C.trigonometric_C1.instance).
Check (Part_C_proofs.trigonometric_C1_inside.proved : Part_C.trigonometric_C1_inside.statement).
Check (Part_C_proofs.trigonometric_C1_inside.met : Part_C.trigonometric_C1_inside.instance).
Check (Part_C_proofs.trigonometric_bezier.proved : Part_C.trigonometric_bezier.statement).
Check (Part_C_proofs.trigonometric_bezier.met : Part_C.trigonometric_bezier.instance).
Check (Part_Closed_printed_proofs.bernstein_formula.proved : Part_Closed_printed.bernstein_formula.statement).
Check (Part_Closed_printed_proofs.bernstein_formula.met : Part_Closed_printed.bernstein_formula.instance).
Check (Part_Closed_proofs.bernstein_formula.proved : Part_Closed.bernstein_formula.statement).
Check (Part_Closed_proofs.bernstein_formula.met : Part_Closed.bernstein_formula.instance).
Check (Part_De_printed_proofs.curve_casteljau.proved : Part_De_printed.curve_casteljau.statement).
Check (Part_De_printed_proofs.curve_casteljau.met : Part_De_printed.curve_casteljau.instance).
Check (Part_De_proofs.curve_casteljau.proved : Part_De.curve_casteljau.statement).
Check (Part_De_proofs.curve_casteljau.met : Part_De.curve_casteljau.instance).
Check (Part_Definition_printed_proofs.bernstein_recursion.proved : Part_Definition_printed.bernstein_recursion.statement).
Check (Part_Definition_printed_proofs.bernstein_recursion.met : Part_Definition_printed.bernstein_recursion.instance).
Check (Part_Definition_proofs.bernstein_recursion.proved : Part_Definition.bernstein_recursion.statement).
Check (Part_Definition_proofs.bernstein_recursion.met : Part_Definition.bernstein_recursion.instance).
Check (Part_Degree_printed_proofs.bernstein_elevation.proved : Part_Degree_printed.bernstein_elevation.statement).
Check (Part_Degree_printed_proofs.bernstein_elevation.met : Part_Degree_printed.bernstein_elevation.instance).
Check (Part_Degree_printed_proofs.curve_elevation.proved : Part_Degree_printed.curve_elevation.statement).
Check (Part_Degree_printed_proofs.curve_elevation.met : Part_Degree_printed.curve_elevation.instance).
Check (Part_Degree_proofs.bernstein_elevation.proved : Part_Degree.bernstein_elevation.statement).
Check (Part_Degree_proofs.bernstein_elevation.met : Part_Degree.bernstein_elevation.instance).
Check (Part_Degree_proofs.curve_elevation.proved : Part_Degree.curve_elevation.statement).
Check (Part_Degree_proofs.curve_elevation.met : Part_Degree.curve_elevation.instance).
Check (Part_Derivative_printed_proofs.bernstein_derivative.proved : Part_Derivative_printed.bernstein_derivative.statement).
Check (Part_Derivative_printed_proofs.bernstein_derivative.met : Part_Derivative_printed.bernstein_derivative.instance).
Check (Part_Derivative_printed_proofs.bernstein_derivative_slip.refuted : ~ Part_Derivative_printed.bernstein_derivative_slip.statement).
Check (Part_Derivative_printed_proofs.bernstein_derivative_slip_corrected.proved : Part_Derivative_printed.bernstein_derivative_slip_corrected.statement).
Check (Part_Derivative_printed_proofs.bernstein_derivative_slip_corrected.met : Part_Derivative_printed.bernstein_derivative_slip_corrected.instance).
Check (Part_Derivative_proofs.bernstein_derivative.proved : Part_Derivative.bernstein_derivative.statement).
Check (Part_Derivative_proofs.bernstein_derivative.met : Part_Derivative.bernstein_derivative.instance).
Check (Part_Derivative_proofs.bernstein_derivative_slip.refuted : ~ Part_Derivative.bernstein_derivative_slip.statement).
Check (Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved : Part_Derivative.bernstein_derivative_slip_corrected.statement).
Check (Part_Derivative_proofs.bernstein_derivative_slip_corrected.met : Part_Derivative.bernstein_derivative_slip_corrected.instance).
Check (Part_Divisors_printed_proofs.reach_interval_open.proved : Part_Divisors_printed.reach_interval_open.statement).
Check (Part_Divisors_printed_proofs.reach_interval_open.met : Part_Divisors_printed.reach_interval_open.instance).
Check (Part_Divisors_printed_proofs.reach_interval_closed.proved : Part_Divisors_printed.reach_interval_closed.statement).
Check (Part_Divisors_printed_proofs.reach_interval_closed.met : Part_Divisors_printed.reach_interval_closed.instance).
Check (Part_Divisors_printed_proofs.reach_positive.proved : Part_Divisors_printed.reach_positive.statement).
Check (Part_Divisors_printed_proofs.reach_positive.met : Part_Divisors_printed.reach_positive.instance).
Check (Part_Divisors_printed_proofs.reach_open.proved : Part_Divisors_printed.reach_open.statement).
Check (Part_Divisors_printed_proofs.reach_open.met : Part_Divisors_printed.reach_open.instance).
Check (Part_Divisors_printed_proofs.reach_ordered.proved : Part_Divisors_printed.reach_ordered.statement).
Check (Part_Divisors_printed_proofs.reach_ordered.met : Part_Divisors_printed.reach_ordered.instance).
Check (Part_Divisors_printed_proofs.reach_vector.proved : Part_Divisors_printed.reach_vector.statement).
Check (Part_Divisors_printed_proofs.reach_vector.met : Part_Divisors_printed.reach_vector.instance).
Check (Part_Divisors_proofs.reach_interval_open.proved : Part_Divisors.reach_interval_open.statement).
Check (Part_Divisors_proofs.reach_interval_open.met : Part_Divisors.reach_interval_open.instance).
Check (Part_Divisors_proofs.reach_interval_closed.proved : Part_Divisors.reach_interval_closed.statement).
Check (Part_Divisors_proofs.reach_interval_closed.met : Part_Divisors.reach_interval_closed.instance).
Check (Part_Divisors_proofs.reach_positive.proved : Part_Divisors.reach_positive.statement).
Check (Part_Divisors_proofs.reach_positive.met : Part_Divisors.reach_positive.instance).
Check (Part_Divisors_proofs.reach_open.proved : Part_Divisors.reach_open.statement).
Check (Part_Divisors_proofs.reach_open.met : Part_Divisors.reach_open.instance).
Check (Part_Divisors_proofs.reach_ordered.proved : Part_Divisors.reach_ordered.statement).
Check (Part_Divisors_proofs.reach_ordered.met : Part_Divisors.reach_ordered.instance).
Check (Part_Divisors_proofs.reach_vector.proved : Part_Divisors.reach_vector.statement).
Check (Part_Divisors_proofs.reach_vector.met : Part_Divisors.reach_vector.instance).
Check (Part_End_printed_proofs.curve_ends.proved : Part_End_printed.curve_ends.statement).
Check (Part_End_printed_proofs.curve_ends.met : Part_End_printed.curve_ends.instance).
Check (Part_End_printed_proofs.curve_d1.proved : Part_End_printed.curve_d1.statement).
Check (Part_End_printed_proofs.curve_d1.met : Part_End_printed.curve_d1.instance).
Check (Part_End_printed_proofs.curve_d2.proved : Part_End_printed.curve_d2.statement).
Check (Part_End_printed_proofs.curve_d2.met : Part_End_printed.curve_d2.instance).
Check (Part_End_printed_proofs.curve_d2_slip.refuted : ~ Part_End_printed.curve_d2_slip.statement).
Check (Part_End_printed_proofs.curve_d2_slip_corrected.proved : Part_End_printed.curve_d2_slip_corrected.statement).
Check (Part_End_printed_proofs.curve_d2_slip_corrected.met : Part_End_printed.curve_d2_slip_corrected.instance).
Check (Part_End_printed_proofs.curve_d3.proved : Part_End_printed.curve_d3.statement).
Check (Part_End_printed_proofs.curve_d3.met : Part_End_printed.curve_d3.instance).
Check (Part_End_printed_proofs.trigonometric_d1.proved : Part_End_printed.trigonometric_d1.statement).
Check (Part_End_printed_proofs.trigonometric_d1.met : Part_End_printed.trigonometric_d1.instance).
Check (Part_End_printed_proofs.trigonometric_d1_slip.refuted : ~ Part_End_printed.trigonometric_d1_slip.statement).
Check (Part_End_printed_proofs.trigonometric_d1_slip_corrected.proved : Part_End_printed.trigonometric_d1_slip_corrected.statement).
Check (Part_End_printed_proofs.trigonometric_d1_slip_corrected.met : Part_End_printed.trigonometric_d1_slip_corrected.instance).
Check (Part_End_printed_proofs.trigonometric_d2.proved : Part_End_printed.trigonometric_d2.statement).
Check (Part_End_printed_proofs.trigonometric_d2.met : Part_End_printed.trigonometric_d2.instance).
Check (Part_End_proofs.curve_ends.proved : Part_End.curve_ends.statement).
Check (Part_End_proofs.curve_ends.met : Part_End.curve_ends.instance).
Check (Part_End_proofs.curve_d1.proved : Part_End.curve_d1.statement).
Check (Part_End_proofs.curve_d1.met : Part_End.curve_d1.instance).
Check (Part_End_proofs.curve_d2.proved : Part_End.curve_d2.statement).
Check (Part_End_proofs.curve_d2.met : Part_End.curve_d2.instance).
Check (Part_End_proofs.curve_d2_slip.refuted : ~ Part_End.curve_d2_slip.statement).
Check (Part_End_proofs.curve_d2_slip_corrected.proved : Part_End.curve_d2_slip_corrected.statement).
Check (Part_End_proofs.curve_d2_slip_corrected.met : Part_End.curve_d2_slip_corrected.instance).
Check (Part_End_proofs.curve_d3.proved : Part_End.curve_d3.statement).
Check (Part_End_proofs.curve_d3.met : Part_End.curve_d3.instance).
Check (Part_End_proofs.trigonometric_d1.proved : Part_End.trigonometric_d1.statement).
Check (Part_End_proofs.trigonometric_d1.met : Part_End.trigonometric_d1.instance).
Check (Part_End_proofs.trigonometric_d1_slip.refuted : ~ Part_End.trigonometric_d1_slip.statement).
Check (Part_End_proofs.trigonometric_d1_slip_corrected.proved : Part_End.trigonometric_d1_slip_corrected.statement).
Check (Part_End_proofs.trigonometric_d1_slip_corrected.met : Part_End.trigonometric_d1_slip_corrected.instance).
Check (Part_End_proofs.trigonometric_d2.proved : Part_End.trigonometric_d2.statement).
Check (Part_End_proofs.trigonometric_d2.met : Part_End.trigonometric_d2.instance).
Check (Part_Families_printed_proofs.family_corner.proved : Part_Families_printed.family_corner.statement).
Check (Part_Families_printed_proofs.family_corner.met : Part_Families_printed.family_corner.instance).
Check (Part_Families_printed_proofs.family_casteljau.proved : Part_Families_printed.family_casteljau.statement).
Check (Part_Families_printed_proofs.family_casteljau.met : Part_Families_printed.family_casteljau.instance).
Check (Part_Families_printed_proofs.family_casteljau_slip.refuted : ~ Part_Families_printed.family_casteljau_slip.statement).
Check (Part_Families_printed_proofs.family_weights.proved : Part_Families_printed.family_weights.statement).
Check (Part_Families_printed_proofs.family_weights.met : Part_Families_printed.family_weights.instance).
Check (Part_Families_proofs.family_corner.proved : Part_Families.family_corner.statement).
Check (Part_Families_proofs.family_corner.met : Part_Families.family_corner.instance).
Check (Part_Families_proofs.family_casteljau.proved : Part_Families.family_casteljau.statement).
Check (Part_Families_proofs.family_casteljau.met : Part_Families.family_casteljau.instance).
Check (Part_Families_proofs.family_casteljau_slip.refuted : ~ Part_Families.family_casteljau_slip.statement).
Check (Part_Families_proofs.family_weights.proved : Part_Families.family_weights.statement).
Check (Part_Families_proofs.family_weights.met : Part_Families.family_weights.instance).
Check (Part_G_printed_proofs.join_G2.proved : Part_G_printed.join_G2.statement).
Check (Part_G_printed_proofs.join_G2.met : Part_G_printed.join_G2.instance).
Check (Part_G_proofs.join_G2.proved : Part_G.join_G2.statement).
Check (Part_G_proofs.join_G2.met : Part_G.join_G2.instance).
Check (Part_Hodograph_printed_proofs.curve_hodograph.proved : Part_Hodograph_printed.curve_hodograph.statement).
Check (Part_Hodograph_printed_proofs.curve_hodograph.met : Part_Hodograph_printed.curve_hodograph.instance).
Check (Part_Hodograph_proofs.curve_hodograph.proved : Part_Hodograph.curve_hodograph.statement).
Check (Part_Hodograph_proofs.curve_hodograph.met : Part_Hodograph.curve_hodograph.instance).
Check (Part_Linear_printed_proofs.bernstein_precision.proved : Part_Linear_printed.bernstein_precision.statement).
Check (Part_Linear_printed_proofs.bernstein_precision.met : Part_Linear_printed.bernstein_precision.instance).
Check (Part_Linear_proofs.bernstein_precision.proved : Part_Linear.bernstein_precision.statement).
Check (Part_Linear_proofs.bernstein_precision.met : Part_Linear.bernstein_precision.instance).
Check (Part_Lists_printed_proofs.list_unity.proved : Part_Lists_printed.list_unity.statement).
Check (Part_Lists_printed_proofs.list_unity.met : Part_Lists_printed.list_unity.instance).
Check (Part_Lists_printed_proofs.list_nonnegative.proved : Part_Lists_printed.list_nonnegative.statement).
Check (Part_Lists_printed_proofs.list_nonnegative.met : Part_Lists_printed.list_nonnegative.instance).
Check (Part_Lists_printed_proofs.list_nonnegative_slip.refuted : ~ Part_Lists_printed.list_nonnegative_slip.statement).
Check (Part_Lists_proofs.list_unity.proved : Part_Lists.list_unity.statement).
Check (Part_Lists_proofs.list_unity.met : Part_Lists.list_unity.instance).
Check (Part_Lists_proofs.list_nonnegative.proved : Part_Lists.list_nonnegative.statement).
Check (Part_Lists_proofs.list_nonnegative.met : Part_Lists.list_nonnegative.instance).
Check (Part_Lists_proofs.list_nonnegative_slip.refuted : ~ Part_Lists.list_nonnegative_slip.statement).
Check (Part_Logic_printed_proofs.reach_implies.proved : Part_Logic_printed.reach_implies.statement).
Check (Part_Logic_printed_proofs.reach_length_zero.proved : Part_Logic_printed.reach_length_zero.statement).
Check (Part_Logic_printed_proofs.reach_product_zero.proved : Part_Logic_printed.reach_product_zero.statement).
Check (Part_Logic_printed_proofs.reach_roots.proved : Part_Logic_printed.reach_roots.statement).
Check (Part_Logic_printed_proofs.reach_roots_slip.refuted : ~ Part_Logic_printed.reach_roots_slip.statement).
Check (Part_Logic_printed_proofs.reach_weights_zero.proved : Part_Logic_printed.reach_weights_zero.statement).
Check (Part_Logic_printed_proofs.reach_weights_zero.met : Part_Logic_printed.reach_weights_zero.instance).
Check (Part_Logic_printed_proofs.reach_circle_bound.proved : Part_Logic_printed.reach_circle_bound.statement).
Check (Part_Logic_printed_proofs.reach_circle_bound.met : Part_Logic_printed.reach_circle_bound.instance).
Check (Part_Logic_proofs.reach_implies.proved : Part_Logic.reach_implies.statement).
Check (Part_Logic_proofs.reach_length_zero.proved : Part_Logic.reach_length_zero.statement).
Check (Part_Logic_proofs.reach_product_zero.proved : Part_Logic.reach_product_zero.statement).
Check (Part_Logic_proofs.reach_roots.proved : Part_Logic.reach_roots.statement).
Check (Part_Logic_proofs.reach_roots_slip.refuted : ~ Part_Logic.reach_roots_slip.statement).
Check (Part_Logic_proofs.reach_weights_zero.proved : Part_Logic.reach_weights_zero.statement).
Check (Part_Logic_proofs.reach_weights_zero.met : Part_Logic.reach_weights_zero.instance).
Check (Part_Logic_proofs.reach_circle_bound.proved : Part_Logic.reach_circle_bound.statement).
Check (Part_Logic_proofs.reach_circle_bound.met : Part_Logic.reach_circle_bound.instance).
Check (Part_Nonnegativity_printed_proofs.bernstein_nonnegative.proved : Part_Nonnegativity_printed.bernstein_nonnegative.statement).
Check (Part_Nonnegativity_printed_proofs.bernstein_nonnegative_slip.refuted : ~ Part_Nonnegativity_printed.bernstein_nonnegative_slip.statement).
Check (Part_Nonnegativity_printed_proofs.trigonometric_nonnegative.proved : Part_Nonnegativity_printed.trigonometric_nonnegative.statement).
Check (Part_Nonnegativity_printed_proofs.trigonometric_nonnegative.met : Part_Nonnegativity_printed.trigonometric_nonnegative.instance).
Check (Part_Nonnegativity_printed_proofs.trigonometric_nonnegative_slip.refuted : ~ Part_Nonnegativity_printed.trigonometric_nonnegative_slip.statement).
Check (Part_Nonnegativity_proofs.bernstein_nonnegative.proved : Part_Nonnegativity.bernstein_nonnegative.statement).
Check (Part_Nonnegativity_proofs.bernstein_nonnegative.met : Part_Nonnegativity.bernstein_nonnegative.instance).
Check (Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted : ~ Part_Nonnegativity.bernstein_nonnegative_slip.statement).
Check (Part_Nonnegativity_proofs.trigonometric_nonnegative.proved : Part_Nonnegativity.trigonometric_nonnegative.statement).
Check (Part_Nonnegativity_proofs.trigonometric_nonnegative.met : Part_Nonnegativity.trigonometric_nonnegative.instance).
Check (Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted : ~ Part_Nonnegativity.trigonometric_nonnegative_slip.statement).
Check (Part_Numbers_printed_proofs.exists_quotient_any.proved : Part_Numbers_printed.exists_quotient_any.statement).
Check (Part_Numbers_printed_proofs.exists_quotient_any.met : Part_Numbers_printed.exists_quotient_any.instance).
Check (Part_Numbers_printed_proofs.exists_above.proved : Part_Numbers_printed.exists_above.statement).
Check (Part_Numbers_printed_proofs.exists_root.proved : Part_Numbers_printed.exists_root.statement).
Check (Part_Numbers_printed_proofs.exists_none.refuted : ~ Part_Numbers_printed.exists_none.statement).
Check (Part_Numbers_printed_proofs.exists_parallel.proved : Part_Numbers_printed.exists_parallel.statement).
Check (Part_Numbers_printed_proofs.exists_parallel.met : Part_Numbers_printed.exists_parallel.instance).
Check (Part_Numbers_printed_proofs.exists_parallel_only.proved : Part_Numbers_printed.exists_parallel_only.statement).
Check (Part_Numbers_printed_proofs.exists_parallel_only.met : Part_Numbers_printed.exists_parallel_only.instance).
Check (Part_Numbers_proofs.exists_quotient_any.proved : Part_Numbers.exists_quotient_any.statement).
Check (Part_Numbers_proofs.exists_quotient_any.met : Part_Numbers.exists_quotient_any.instance).
Check (Part_Numbers_proofs.exists_above.proved : Part_Numbers.exists_above.statement).
Check (Part_Numbers_proofs.exists_above.met : Part_Numbers.exists_above.instance).
Check (Part_Numbers_proofs.exists_root.proved : Part_Numbers.exists_root.statement).
Check (Part_Numbers_proofs.exists_root.met : Part_Numbers.exists_root.instance).
Check (Part_Numbers_proofs.exists_none.refuted : ~ Part_Numbers.exists_none.statement).
Check (Part_Numbers_proofs.exists_parallel.proved : Part_Numbers.exists_parallel.statement).
Check (Part_Numbers_proofs.exists_parallel.met : Part_Numbers.exists_parallel.instance).
Check (Part_Numbers_proofs.exists_parallel_only.proved : Part_Numbers.exists_parallel_only.statement).
Check (Part_Numbers_proofs.exists_parallel_only.met : Part_Numbers.exists_parallel_only.instance).
Check (Part_Partition_printed_proofs.bernstein_unity.proved : Part_Partition_printed.bernstein_unity.statement).
Check (Part_Partition_printed_proofs.bernstein_unity.met : Part_Partition_printed.bernstein_unity.instance).
Check (Part_Partition_printed_proofs.trigonometric_unity.proved : Part_Partition_printed.trigonometric_unity.statement).
Check (Part_Partition_printed_proofs.trigonometric_unity.met : Part_Partition_printed.trigonometric_unity.instance).
Check (Part_Partition_proofs.bernstein_unity.proved : Part_Partition.bernstein_unity.statement).
Check (Part_Partition_proofs.bernstein_unity.met : Part_Partition.bernstein_unity.instance).
Check (Part_Partition_proofs.trigonometric_unity.proved : Part_Partition.trigonometric_unity.statement).
Check (Part_Partition_proofs.trigonometric_unity.met : Part_Partition.trigonometric_unity.instance).
Check (Part_Powers_printed_proofs.power_next.proved : Part_Powers_printed.power_next.statement).
Check (Part_Powers_printed_proofs.power_next.met : Part_Powers_printed.power_next.instance).
Check (Part_Powers_printed_proofs.power_rate.proved : Part_Powers_printed.power_rate.statement).
Check (Part_Powers_printed_proofs.power_rate.met : Part_Powers_printed.power_rate.instance).
Check (Part_Powers_printed_proofs.power_rate_slip.refuted : ~ Part_Powers_printed.power_rate_slip.statement).
Check (Part_Powers_printed_proofs.power_rate_slip_corrected.proved : Part_Powers_printed.power_rate_slip_corrected.statement).
Check (Part_Powers_printed_proofs.power_rate_slip_corrected.met : Part_Powers_printed.power_rate_slip_corrected.instance).
Check (Part_Powers_printed_proofs.power_product.proved : Part_Powers_printed.power_product.statement).
Check (Part_Powers_printed_proofs.power_product.met : Part_Powers_printed.power_product.instance).
Check (Part_Powers_printed_proofs.power_ends.proved : Part_Powers_printed.power_ends.statement).
Check (Part_Powers_printed_proofs.power_ends.met : Part_Powers_printed.power_ends.instance).
Check (Part_Powers_printed_proofs.power_binomial.proved : Part_Powers_printed.power_binomial.statement).
Check (Part_Powers_printed_proofs.power_binomial.met : Part_Powers_printed.power_binomial.instance).
Check (Part_Powers_proofs.power_next.proved : Part_Powers.power_next.statement).
Check (Part_Powers_proofs.power_next.met : Part_Powers.power_next.instance).
Check (Part_Powers_proofs.power_rate.proved : Part_Powers.power_rate.statement).
Check (Part_Powers_proofs.power_rate.met : Part_Powers.power_rate.instance).
Check (Part_Powers_proofs.power_rate_slip.refuted : ~ Part_Powers.power_rate_slip.statement).
Check (Part_Powers_proofs.power_rate_slip_corrected.proved : Part_Powers.power_rate_slip_corrected.statement).
Check (Part_Powers_proofs.power_rate_slip_corrected.met : Part_Powers.power_rate_slip_corrected.instance).
Check (Part_Powers_proofs.power_product.proved : Part_Powers.power_product.statement).
Check (Part_Powers_proofs.power_product.met : Part_Powers.power_product.instance).
Check (Part_Powers_proofs.power_ends.proved : Part_Powers.power_ends.statement).
Check (Part_Powers_proofs.power_ends.met : Part_Powers.power_ends.instance).
Check (Part_Powers_proofs.power_binomial.proved : Part_Powers.power_binomial.statement).
Check (Part_Powers_proofs.power_binomial.met : Part_Powers.power_binomial.instance).
Check (Part_README_printed_proofs.language_numbers.proved : Part_README_printed.language_numbers.statement).
Check (Part_README_printed_proofs.language_numbers.met : Part_README_printed.language_numbers.instance).
Check (Part_README_printed_proofs.language_calculus.proved : Part_README_printed.language_calculus.statement).
Check (Part_README_printed_proofs.language_calculus.met : Part_README_printed.language_calculus.instance).
Check (Part_README_printed_proofs.language_vectors.proved : Part_README_printed.language_vectors.statement).
Check (Part_README_printed_proofs.language_matrices.proved : Part_README_printed.language_matrices.statement).
Check (Part_README_printed_proofs.language_matrices.met : Part_README_printed.language_matrices.instance).
Check (Part_README_printed_proofs.language_decimals.proved : Part_README_printed.language_decimals.statement).
Check (Part_README_printed_proofs.language_divisor.proved : Part_README_printed.language_divisor.statement).
Check (Part_README_printed_proofs.language_divisor.met : Part_README_printed.language_divisor.instance).
Check (Part_README_printed_proofs.language_degree.proved : Part_README_printed.language_degree.statement).
Check (Part_README_printed_proofs.language_degree.met : Part_README_printed.language_degree.instance).
Check (Part_README_printed_proofs.language_order.proved : Part_README_printed.language_order.statement).
Check (Part_README_printed_proofs.language_order.met : Part_README_printed.language_order.instance).
Check (Part_README_printed_proofs.language_order_false.refuted : ~ Part_README_printed.language_order_false.statement).
Check (Part_README_printed_proofs.language_assumed.proved : Part_README_printed.language_assumed.statement).
Check (Part_README_printed_proofs.language_assumed.met : Part_README_printed.language_assumed.instance).
Check (Part_README_printed_proofs.language_declared.proved : Part_README_printed.language_declared.statement).
Check (Part_README_printed_proofs.language_declared.met : Part_README_printed.language_declared.instance).
Check (Part_README_printed_proofs.language_decimals_false.refuted : ~ Part_README_printed.language_decimals_false.statement).
Check (Part_README_proofs.language_numbers.proved : Part_README.language_numbers.statement).
Check (Part_README_proofs.language_numbers.met : Part_README.language_numbers.instance).
Check (Part_README_proofs.language_calculus.proved : Part_README.language_calculus.statement).
Check (Part_README_proofs.language_calculus.met : Part_README.language_calculus.instance).
Check (Part_README_proofs.language_vectors.proved : Part_README.language_vectors.statement).
Check (Part_README_proofs.language_matrices.proved : Part_README.language_matrices.statement).
Check (Part_README_proofs.language_matrices.met : Part_README.language_matrices.instance).
Check (Part_README_proofs.language_decimals.proved : Part_README.language_decimals.statement).
Check (Part_README_proofs.language_divisor.proved : Part_README.language_divisor.statement).
Check (Part_README_proofs.language_divisor.met : Part_README.language_divisor.instance).
Check (Part_README_proofs.language_degree.proved : Part_README.language_degree.statement).
Check (Part_README_proofs.language_degree.met : Part_README.language_degree.instance).
Check (Part_README_proofs.language_order.proved : Part_README.language_order.statement).
Check (Part_README_proofs.language_order.met : Part_README.language_order.instance).
Check (Part_README_proofs.language_order_false.refuted : ~ Part_README.language_order_false.statement).
Check (Part_README_proofs.language_assumed.proved : Part_README.language_assumed.statement).
Check (Part_README_proofs.language_assumed.met : Part_README.language_assumed.instance).
Check (Part_README_proofs.language_declared.proved : Part_README.language_declared.statement).
Check (Part_README_proofs.language_declared.met : Part_README.language_declared.instance).
Check (Part_README_proofs.language_decimals_false.refuted : ~ Part_README.language_decimals_false.statement).
Check (Part_Reflection_printed_proofs.curve_reflection.proved : Part_Reflection_printed.curve_reflection.statement).
Check (Part_Reflection_printed_proofs.curve_reflection.met : Part_Reflection_printed.curve_reflection.instance).
Check (Part_Reflection_proofs.curve_reflection.proved : Part_Reflection.curve_reflection.statement).
Check (Part_Reflection_proofs.curve_reflection.met : Part_Reflection.curve_reflection.instance).
Check (Part_Roots_printed_proofs.reach_unit.proved : Part_Roots_printed.reach_unit.statement).
Check (Part_Roots_printed_proofs.reach_unit.met : Part_Roots_printed.reach_unit.instance).
Check (Part_Roots_printed_proofs.reach_unit_zero.proved : Part_Roots_printed.reach_unit_zero.statement).
Check (Part_Roots_printed_proofs.reach_unit_zero.met : Part_Roots_printed.reach_unit_zero.instance).
Check (Part_Roots_printed_proofs.reach_size.proved : Part_Roots_printed.reach_size.statement).
Check (Part_Roots_printed_proofs.reach_size.met : Part_Roots_printed.reach_size.instance).
Check (Part_Roots_printed_proofs.reach_size_slip.refuted : ~ Part_Roots_printed.reach_size_slip.statement).
Check (Part_Roots_printed_proofs.reach_product.proved : Part_Roots_printed.reach_product.statement).
Check (Part_Roots_printed_proofs.reach_product.met : Part_Roots_printed.reach_product.instance).
Check (Part_Roots_printed_proofs.reach_least.proved : Part_Roots_printed.reach_least.statement).
Check (Part_Roots_printed_proofs.reach_least.met : Part_Roots_printed.reach_least.instance).
Check (Part_Roots_printed_proofs.reach_triangle.proved : Part_Roots_printed.reach_triangle.statement).
Check (Part_Roots_printed_proofs.reach_triangle_slip.refuted : ~ Part_Roots_printed.reach_triangle_slip.statement).
Check (Part_Roots_printed_proofs.reach_subadditive.proved : Part_Roots_printed.reach_subadditive.statement).
Check (Part_Roots_printed_proofs.reach_subadditive.met : Part_Roots_printed.reach_subadditive.instance).
Check (Part_Roots_printed_proofs.reach_above.proved : Part_Roots_printed.reach_above.statement).
Check (Part_Roots_printed_proofs.reach_above.met : Part_Roots_printed.reach_above.instance).
Check (Part_Roots_proofs.reach_unit.proved : Part_Roots.reach_unit.statement).
Check (Part_Roots_proofs.reach_unit.met : Part_Roots.reach_unit.instance).
Check (Part_Roots_proofs.reach_unit_zero.proved : Part_Roots.reach_unit_zero.statement).
Check (Part_Roots_proofs.reach_unit_zero.met : Part_Roots.reach_unit_zero.instance).
Check (Part_Roots_proofs.reach_size.proved : Part_Roots.reach_size.statement).
Check (Part_Roots_proofs.reach_size.met : Part_Roots.reach_size.instance).
Check (Part_Roots_proofs.reach_size_slip.refuted : ~ Part_Roots.reach_size_slip.statement).
Check (Part_Roots_proofs.reach_product.proved : Part_Roots.reach_product.statement).
Check (Part_Roots_proofs.reach_product.met : Part_Roots.reach_product.instance).
Check (Part_Roots_proofs.reach_least.proved : Part_Roots.reach_least.statement).
Check (Part_Roots_proofs.reach_least.met : Part_Roots.reach_least.instance).
Check (Part_Roots_proofs.reach_triangle.proved : Part_Roots.reach_triangle.statement).
Check (Part_Roots_proofs.reach_triangle_slip.refuted : ~ Part_Roots.reach_triangle_slip.statement).
Check (Part_Roots_proofs.reach_subadditive.proved : Part_Roots.reach_subadditive.statement).
Check (Part_Roots_proofs.reach_subadditive.met : Part_Roots.reach_subadditive.instance).
Check (Part_Roots_proofs.reach_above.proved : Part_Roots.reach_above.statement).
Check (Part_Roots_proofs.reach_above.met : Part_Roots.reach_above.instance).
Check (Part_Subdivision_printed_proofs.curve_midpoint.proved : Part_Subdivision_printed.curve_midpoint.statement).
Check (Part_Subdivision_printed_proofs.curve_midpoint.met : Part_Subdivision_printed.curve_midpoint.instance).
Check (Part_Subdivision_proofs.curve_midpoint.proved : Part_Subdivision.curve_midpoint.statement).
Check (Part_Subdivision_proofs.curve_midpoint.met : Part_Subdivision.curve_midpoint.instance).
Check (Part_Sums_printed_proofs.sum_powers.proved : Part_Sums_printed.sum_powers.statement).
Check (Part_Sums_printed_proofs.sum_powers.met : Part_Sums_printed.sum_powers.instance).
Check (Part_Sums_printed_proofs.sum_powers_slip.refuted : ~ Part_Sums_printed.sum_powers_slip.statement).
Check (Part_Sums_printed_proofs.sum_powers_slip_corrected.proved : Part_Sums_printed.sum_powers_slip_corrected.statement).
Check (Part_Sums_printed_proofs.sum_powers_slip_corrected.met : Part_Sums_printed.sum_powers_slip_corrected.instance).
Check (Part_Sums_printed_proofs.sum_swap.proved : Part_Sums_printed.sum_swap.statement).
Check (Part_Sums_printed_proofs.sum_swap.met : Part_Sums_printed.sum_swap.instance).
Check (Part_Sums_printed_proofs.sum_swap_weighted.proved : Part_Sums_printed.sum_swap_weighted.statement).
Check (Part_Sums_printed_proofs.sum_swap_weighted.met : Part_Sums_printed.sum_swap_weighted.instance).
Check (Part_Sums_printed_proofs.sum_swap_slip.refuted : ~ Part_Sums_printed.sum_swap_slip.statement).
Check (Part_Sums_proofs.sum_powers.proved : Part_Sums.sum_powers.statement).
Check (Part_Sums_proofs.sum_powers.met : Part_Sums.sum_powers.instance).
Check (Part_Sums_proofs.sum_powers_slip.refuted : ~ Part_Sums.sum_powers_slip.statement).
Check (Part_Sums_proofs.sum_powers_slip_corrected.proved : Part_Sums.sum_powers_slip_corrected.statement).
Check (Part_Sums_proofs.sum_powers_slip_corrected.met : Part_Sums.sum_powers_slip_corrected.instance).
Check (Part_Sums_proofs.sum_swap.proved : Part_Sums.sum_swap.statement).
Check (Part_Sums_proofs.sum_swap.met : Part_Sums.sum_swap.instance).
Check (Part_Sums_proofs.sum_swap_weighted.proved : Part_Sums.sum_swap_weighted.statement).
Check (Part_Sums_proofs.sum_swap_weighted.met : Part_Sums.sum_swap_weighted.instance).
Check (Part_Sums_proofs.sum_swap_slip.refuted : ~ Part_Sums.sum_swap_slip.statement).
Check (Part_Symmetry_printed_proofs.bernstein_symmetry.proved : Part_Symmetry_printed.bernstein_symmetry.statement).
Check (Part_Symmetry_printed_proofs.bernstein_symmetry.met : Part_Symmetry_printed.bernstein_symmetry.instance).
Check (Part_Symmetry_printed_proofs.trigonometric_symmetry.proved : Part_Symmetry_printed.trigonometric_symmetry.statement).
Check (Part_Symmetry_printed_proofs.trigonometric_symmetry.met : Part_Symmetry_printed.trigonometric_symmetry.instance).
Check (Part_Symmetry_printed_proofs.trigonometric_symmetry_slip.refuted : ~ Part_Symmetry_printed.trigonometric_symmetry_slip.statement).
Check (Part_Symmetry_printed_proofs.trigonometric_symmetry_slip_corrected.proved : Part_Symmetry_printed.trigonometric_symmetry_slip_corrected.statement).
Check (Part_Symmetry_printed_proofs.trigonometric_symmetry_slip_corrected.met : Part_Symmetry_printed.trigonometric_symmetry_slip_corrected.instance).
Check (Part_Symmetry_proofs.bernstein_symmetry.proved : Part_Symmetry.bernstein_symmetry.statement).
Check (Part_Symmetry_proofs.bernstein_symmetry.met : Part_Symmetry.bernstein_symmetry.instance).
Check (Part_Symmetry_proofs.trigonometric_symmetry.proved : Part_Symmetry.trigonometric_symmetry.statement).
Check (Part_Symmetry_proofs.trigonometric_symmetry.met : Part_Symmetry.trigonometric_symmetry.instance).
Check (Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted : ~ Part_Symmetry.trigonometric_symmetry_slip.statement).
Check (Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved : Part_Symmetry.trigonometric_symmetry_slip_corrected.statement).
Check (Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met : Part_Symmetry.trigonometric_symmetry_slip_corrected.instance).
Check (Part_The_printed_proofs.circle_kappa.proved : Part_The_printed.circle_kappa.statement).
Check (Part_The_printed_proofs.circle_kappa_cut.proved : Part_The_printed.circle_kappa_cut.statement).
Check (Part_The_printed_proofs.circle_kappa_slip.refuted : ~ Part_The_printed.circle_kappa_slip.statement).
Check (Part_The_printed_proofs.circle_middle.proved : Part_The_printed.circle_middle.statement).
Check (Part_The_printed_proofs.circle_outside.proved : Part_The_printed.circle_outside.statement).
Check (Part_The_printed_proofs.circle_outside.met : Part_The_printed.circle_outside.instance).
Check (Part_The_printed_proofs.circle_exact_slip.refuted : ~ Part_The_printed.circle_exact_slip.statement).
Check (Part_The_printed_proofs.reach_definite.proved : Part_The_printed.reach_definite.statement).
Check (Part_The_printed_proofs.reach_cauchy.proved : Part_The_printed.reach_cauchy.statement).
Check (Part_The_proofs.circle_kappa.proved : Part_The.circle_kappa.statement).
Check (Part_The_proofs.circle_kappa_cut.proved : Part_The.circle_kappa_cut.statement).
Check (Part_The_proofs.circle_kappa_slip.refuted : ~ Part_The.circle_kappa_slip.statement).
Check (Part_The_proofs.circle_middle.proved : Part_The.circle_middle.statement).
Check (Part_The_proofs.circle_outside.proved : Part_The.circle_outside.statement).
Check (Part_The_proofs.circle_outside.met : Part_The.circle_outside.instance).
Check (Part_The_proofs.circle_exact_slip.refuted : ~ Part_The.circle_exact_slip.statement).
Check (Part_The_proofs.reach_definite.proved : Part_The.reach_definite.statement).
Check (Part_The_proofs.reach_cauchy.proved : Part_The.reach_cauchy.statement).
Definition all_theorems : True :=
let _ := Part_A_printed_proofs.trigonometric_circle.proved in
let _ := Part_A_printed_proofs.trigonometric_circle.met in
let _ := Part_A_proofs.trigonometric_circle.proved in
let _ := Part_A_proofs.trigonometric_circle.met in
let _ := Part_Algebraic_printed_proofs.reach_root.proved in
let _ := Part_Algebraic_printed_proofs.reach_root.met in
let _ := Part_Algebraic_printed_proofs.reach_square.proved in
let _ := Part_Algebraic_printed_proofs.reach_square.met in
let _ := Part_Algebraic_proofs.reach_root.proved in
let _ := Part_Algebraic_proofs.reach_root.met in
let _ := Part_Algebraic_proofs.reach_square.proved in
let _ := Part_Algebraic_proofs.reach_square.met in
let _ := Part_Bounds_printed_proofs.reach_surd.proved in
let _ := Part_Bounds_printed_proofs.reach_surd.met in
let _ := Part_Bounds_printed_proofs.reach_simplex.proved in
let _ := Part_Bounds_printed_proofs.reach_simplex.met in
let _ := Part_Bounds_printed_proofs.reach_between.proved in
let _ := Part_Bounds_printed_proofs.reach_between.met in
let _ := Part_Bounds_printed_proofs.reach_interval.proved in
let _ := Part_Bounds_printed_proofs.reach_interval.met in
let _ := Part_Bounds_printed_proofs.reach_interval_basis.proved in
let _ := Part_Bounds_printed_proofs.reach_interval_basis.met in
let _ := Part_Bounds_proofs.reach_surd.proved in
let _ := Part_Bounds_proofs.reach_surd.met in
let _ := Part_Bounds_proofs.reach_simplex.proved in
let _ := Part_Bounds_proofs.reach_simplex.met in
let _ := Part_Bounds_proofs.reach_between.proved in
let _ := Part_Bounds_proofs.reach_between.met in
let _ := Part_Bounds_proofs.reach_interval.proved in
let _ := Part_Bounds_proofs.reach_interval.met in
let _ := Part_Bounds_proofs.reach_interval_basis.proved in
let _ := Part_Bounds_proofs.reach_interval_basis.met in
let _ := Part_C_printed_proofs.join_C0.proved in
let _ := Part_C_printed_proofs.join_C0.met in
let _ := Part_C_printed_proofs.join_C1.proved in
let _ := Part_C_printed_proofs.join_C1.met in
let _ := Part_C_printed_proofs.join_C1_slip.refuted in
let _ := Part_C_printed_proofs.join_C1_slip_corrected.proved in
let _ := Part_C_printed_proofs.join_C1_slip_corrected.met in
let _ := Part_C_printed_proofs.join_C2.proved in
let _ := Part_C_printed_proofs.join_C2.met in
let _ := Part_C_printed_proofs.join_C2_slip.refuted in
let _ := Part_C_printed_proofs.join_C2_slip_corrected.proved in
let _ := Part_C_printed_proofs.join_C2_slip_corrected.met in
let _ := Part_C_printed_proofs.join_C3.proved in
let _ := Part_C_printed_proofs.join_C3.met in
let _ := Part_C_printed_proofs.join_C2_sufficient.proved in
let _ := Part_C_printed_proofs.join_C2_sufficient.met in
let _ := Part_C_printed_proofs.join_knot.proved in
let _ := Part_C_printed_proofs.join_knot.met in
let _ := Part_C_printed_proofs.trigonometric_C1.proved in
let _ := Part_C_printed_proofs.trigonometric_C1.met in
let _ := Part_C_printed_proofs.trigonometric_C1_inside.proved in
let _ := Part_C_printed_proofs.trigonometric_C1_inside.met in
let _ := Part_C_printed_proofs.trigonometric_bezier.proved in
let _ := Part_C_printed_proofs.trigonometric_bezier.met in
let _ := Part_C_proofs.join_C0.proved in
let _ := Part_C_proofs.join_C0.met in
let _ := Part_C_proofs.join_C1.proved in
let _ := Part_C_proofs.join_C1.met in
let _ := Part_C_proofs.join_C1_slip.refuted in
let _ := Part_C_proofs.join_C1_slip_corrected.proved in
let _ := Part_C_proofs.join_C1_slip_corrected.met in
let _ := Part_C_proofs.join_C2.proved in
let _ := Part_C_proofs.join_C2.met in
let _ := Part_C_proofs.join_C2_slip.refuted in
let _ := Part_C_proofs.join_C2_slip_corrected.proved in
let _ := Part_C_proofs.join_C2_slip_corrected.met in
let _ := Part_C_proofs.join_C3.proved in
let _ := Part_C_proofs.join_C3.met in
let _ := Part_C_proofs.join_C2_sufficient.proved in
let _ := Part_C_proofs.join_C2_sufficient.met in
let _ := Part_C_proofs.join_knot.proved in
let _ := Part_C_proofs.join_knot.met in
let _ := Part_C_proofs.trigonometric_C1.proved in
let _ := Part_C_proofs.trigonometric_C1.met in
let _ := Part_C_proofs.trigonometric_C1_inside.proved in
let _ := Part_C_proofs.trigonometric_C1_inside.met in
let _ := Part_C_proofs.trigonometric_bezier.proved in
let _ := Part_C_proofs.trigonometric_bezier.met in
let _ := Part_Closed_printed_proofs.bernstein_formula.proved in
let _ := Part_Closed_printed_proofs.bernstein_formula.met in
let _ := Part_Closed_proofs.bernstein_formula.proved in
let _ := Part_Closed_proofs.bernstein_formula.met in
let _ := Part_De_printed_proofs.curve_casteljau.proved in
let _ := Part_De_printed_proofs.curve_casteljau.met in
let _ := Part_De_proofs.curve_casteljau.proved in
let _ := Part_De_proofs.curve_casteljau.met in
let _ := Part_Definition_printed_proofs.bernstein_recursion.proved in
let _ := Part_Definition_printed_proofs.bernstein_recursion.met in
let _ := Part_Definition_proofs.bernstein_recursion.proved in
let _ := Part_Definition_proofs.bernstein_recursion.met in
let _ := Part_Degree_printed_proofs.bernstein_elevation.proved in
let _ := Part_Degree_printed_proofs.bernstein_elevation.met in
let _ := Part_Degree_printed_proofs.curve_elevation.proved in
let _ := Part_Degree_printed_proofs.curve_elevation.met in
let _ := Part_Degree_proofs.bernstein_elevation.proved in
let _ := Part_Degree_proofs.bernstein_elevation.met in
let _ := Part_Degree_proofs.curve_elevation.proved in
let _ := Part_Degree_proofs.curve_elevation.met in
let _ := Part_Derivative_printed_proofs.bernstein_derivative.proved in
let _ := Part_Derivative_printed_proofs.bernstein_derivative.met in
let _ := Part_Derivative_printed_proofs.bernstein_derivative_slip.refuted in
let _ := Part_Derivative_printed_proofs.bernstein_derivative_slip_corrected.proved in
let _ := Part_Derivative_printed_proofs.bernstein_derivative_slip_corrected.met in
let _ := Part_Derivative_proofs.bernstein_derivative.proved in
let _ := Part_Derivative_proofs.bernstein_derivative.met in
let _ := Part_Derivative_proofs.bernstein_derivative_slip.refuted in
let _ := Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved in
let _ := Part_Derivative_proofs.bernstein_derivative_slip_corrected.met in
let _ := Part_Divisors_printed_proofs.reach_interval_open.proved in
let _ := Part_Divisors_printed_proofs.reach_interval_open.met in
let _ := Part_Divisors_printed_proofs.reach_interval_closed.proved in
let _ := Part_Divisors_printed_proofs.reach_interval_closed.met in
let _ := Part_Divisors_printed_proofs.reach_positive.proved in
let _ := Part_Divisors_printed_proofs.reach_positive.met in
let _ := Part_Divisors_printed_proofs.reach_open.proved in
let _ := Part_Divisors_printed_proofs.reach_open.met in
let _ := Part_Divisors_printed_proofs.reach_ordered.proved in
let _ := Part_Divisors_printed_proofs.reach_ordered.met in
let _ := Part_Divisors_printed_proofs.reach_vector.proved in
let _ := Part_Divisors_printed_proofs.reach_vector.met in
let _ := Part_Divisors_proofs.reach_interval_open.proved in
let _ := Part_Divisors_proofs.reach_interval_open.met in
let _ := Part_Divisors_proofs.reach_interval_closed.proved in
let _ := Part_Divisors_proofs.reach_interval_closed.met in
let _ := Part_Divisors_proofs.reach_positive.proved in
let _ := Part_Divisors_proofs.reach_positive.met in
let _ := Part_Divisors_proofs.reach_open.proved in
let _ := Part_Divisors_proofs.reach_open.met in
let _ := Part_Divisors_proofs.reach_ordered.proved in
let _ := Part_Divisors_proofs.reach_ordered.met in
let _ := Part_Divisors_proofs.reach_vector.proved in
let _ := Part_Divisors_proofs.reach_vector.met in
let _ := Part_End_printed_proofs.curve_ends.proved in
let _ := Part_End_printed_proofs.curve_ends.met in
let _ := Part_End_printed_proofs.curve_d1.proved in
let _ := Part_End_printed_proofs.curve_d1.met in
let _ := Part_End_printed_proofs.curve_d2.proved in
let _ := Part_End_printed_proofs.curve_d2.met in
let _ := Part_End_printed_proofs.curve_d2_slip.refuted in
let _ := Part_End_printed_proofs.curve_d2_slip_corrected.proved in
let _ := Part_End_printed_proofs.curve_d2_slip_corrected.met in
let _ := Part_End_printed_proofs.curve_d3.proved in
let _ := Part_End_printed_proofs.curve_d3.met in
let _ := Part_End_printed_proofs.trigonometric_d1.proved in
let _ := Part_End_printed_proofs.trigonometric_d1.met in
let _ := Part_End_printed_proofs.trigonometric_d1_slip.refuted in
let _ := Part_End_printed_proofs.trigonometric_d1_slip_corrected.proved in
let _ := Part_End_printed_proofs.trigonometric_d1_slip_corrected.met in
let _ := Part_End_printed_proofs.trigonometric_d2.proved in
let _ := Part_End_printed_proofs.trigonometric_d2.met in
let _ := Part_End_proofs.curve_ends.proved in
let _ := Part_End_proofs.curve_ends.met in
let _ := Part_End_proofs.curve_d1.proved in
let _ := Part_End_proofs.curve_d1.met in
let _ := Part_End_proofs.curve_d2.proved in
let _ := Part_End_proofs.curve_d2.met in
let _ := Part_End_proofs.curve_d2_slip.refuted in
let _ := Part_End_proofs.curve_d2_slip_corrected.proved in
let _ := Part_End_proofs.curve_d2_slip_corrected.met in
let _ := Part_End_proofs.curve_d3.proved in
let _ := Part_End_proofs.curve_d3.met in
let _ := Part_End_proofs.trigonometric_d1.proved in
let _ := Part_End_proofs.trigonometric_d1.met in
let _ := Part_End_proofs.trigonometric_d1_slip.refuted in
let _ := Part_End_proofs.trigonometric_d1_slip_corrected.proved in
let _ := Part_End_proofs.trigonometric_d1_slip_corrected.met in
let _ := Part_End_proofs.trigonometric_d2.proved in
let _ := Part_End_proofs.trigonometric_d2.met in
let _ := Part_Families_printed_proofs.family_corner.proved in
let _ := Part_Families_printed_proofs.family_corner.met in
let _ := Part_Families_printed_proofs.family_casteljau.proved in
let _ := Part_Families_printed_proofs.family_casteljau.met in
let _ := Part_Families_printed_proofs.family_casteljau_slip.refuted in
let _ := Part_Families_printed_proofs.family_weights.proved in
let _ := Part_Families_printed_proofs.family_weights.met in
let _ := Part_Families_proofs.family_corner.proved in
let _ := Part_Families_proofs.family_corner.met in
let _ := Part_Families_proofs.family_casteljau.proved in
let _ := Part_Families_proofs.family_casteljau.met in
let _ := Part_Families_proofs.family_casteljau_slip.refuted in
let _ := Part_Families_proofs.family_weights.proved in
let _ := Part_Families_proofs.family_weights.met in
let _ := Part_G_printed_proofs.join_G2.proved in
let _ := Part_G_printed_proofs.join_G2.met in
let _ := Part_G_proofs.join_G2.proved in
let _ := Part_G_proofs.join_G2.met in
let _ := Part_Hodograph_printed_proofs.curve_hodograph.proved in
let _ := Part_Hodograph_printed_proofs.curve_hodograph.met in
let _ := Part_Hodograph_proofs.curve_hodograph.proved in
let _ := Part_Hodograph_proofs.curve_hodograph.met in
let _ := Part_Linear_printed_proofs.bernstein_precision.proved in
let _ := Part_Linear_printed_proofs.bernstein_precision.met in
let _ := Part_Linear_proofs.bernstein_precision.proved in
let _ := Part_Linear_proofs.bernstein_precision.met in
let _ := Part_Lists_printed_proofs.list_unity.proved in
let _ := Part_Lists_printed_proofs.list_unity.met in
let _ := Part_Lists_printed_proofs.list_nonnegative.proved in
let _ := Part_Lists_printed_proofs.list_nonnegative.met in
let _ := Part_Lists_printed_proofs.list_nonnegative_slip.refuted in
let _ := Part_Lists_proofs.list_unity.proved in
let _ := Part_Lists_proofs.list_unity.met in
let _ := Part_Lists_proofs.list_nonnegative.proved in
let _ := Part_Lists_proofs.list_nonnegative.met in
let _ := Part_Lists_proofs.list_nonnegative_slip.refuted in
let _ := Part_Logic_printed_proofs.reach_implies.proved in
let _ := Part_Logic_printed_proofs.reach_length_zero.proved in
let _ := Part_Logic_printed_proofs.reach_product_zero.proved in
let _ := Part_Logic_printed_proofs.reach_roots.proved in
let _ := Part_Logic_printed_proofs.reach_roots_slip.refuted in
let _ := Part_Logic_printed_proofs.reach_weights_zero.proved in
let _ := Part_Logic_printed_proofs.reach_weights_zero.met in
let _ := Part_Logic_printed_proofs.reach_circle_bound.proved in
let _ := Part_Logic_printed_proofs.reach_circle_bound.met in
let _ := Part_Logic_proofs.reach_implies.proved in
let _ := Part_Logic_proofs.reach_length_zero.proved in
let _ := Part_Logic_proofs.reach_product_zero.proved in
let _ := Part_Logic_proofs.reach_roots.proved in
let _ := Part_Logic_proofs.reach_roots_slip.refuted in
let _ := Part_Logic_proofs.reach_weights_zero.proved in
let _ := Part_Logic_proofs.reach_weights_zero.met in
let _ := Part_Logic_proofs.reach_circle_bound.proved in
let _ := Part_Logic_proofs.reach_circle_bound.met in
let _ := Part_Nonnegativity_printed_proofs.bernstein_nonnegative.proved in
let _ := Part_Nonnegativity_printed_proofs.bernstein_nonnegative_slip.refuted in
let _ := Part_Nonnegativity_printed_proofs.trigonometric_nonnegative.proved in
let _ := Part_Nonnegativity_printed_proofs.trigonometric_nonnegative.met in
let _ := Part_Nonnegativity_printed_proofs.trigonometric_nonnegative_slip.refuted in
let _ := Part_Nonnegativity_proofs.bernstein_nonnegative.proved in
let _ := Part_Nonnegativity_proofs.bernstein_nonnegative.met in
let _ := Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted in
let _ := Part_Nonnegativity_proofs.trigonometric_nonnegative.proved in
let _ := Part_Nonnegativity_proofs.trigonometric_nonnegative.met in
let _ := Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted in
let _ := Part_Numbers_printed_proofs.exists_quotient_any.proved in
let _ := Part_Numbers_printed_proofs.exists_quotient_any.met in
let _ := Part_Numbers_printed_proofs.exists_above.proved in
let _ := Part_Numbers_printed_proofs.exists_root.proved in
let _ := Part_Numbers_printed_proofs.exists_none.refuted in
let _ := Part_Numbers_printed_proofs.exists_parallel.proved in
let _ := Part_Numbers_printed_proofs.exists_parallel.met in
let _ := Part_Numbers_printed_proofs.exists_parallel_only.proved in
let _ := Part_Numbers_printed_proofs.exists_parallel_only.met in
let _ := Part_Numbers_proofs.exists_quotient_any.proved in
let _ := Part_Numbers_proofs.exists_quotient_any.met in
let _ := Part_Numbers_proofs.exists_above.proved in
let _ := Part_Numbers_proofs.exists_above.met in
let _ := Part_Numbers_proofs.exists_root.proved in
let _ := Part_Numbers_proofs.exists_root.met in
let _ := Part_Numbers_proofs.exists_none.refuted in
let _ := Part_Numbers_proofs.exists_parallel.proved in
let _ := Part_Numbers_proofs.exists_parallel.met in
let _ := Part_Numbers_proofs.exists_parallel_only.proved in
let _ := Part_Numbers_proofs.exists_parallel_only.met in
let _ := Part_Partition_printed_proofs.bernstein_unity.proved in
let _ := Part_Partition_printed_proofs.bernstein_unity.met in
let _ := Part_Partition_printed_proofs.trigonometric_unity.proved in
let _ := Part_Partition_printed_proofs.trigonometric_unity.met in
let _ := Part_Partition_proofs.bernstein_unity.proved in
let _ := Part_Partition_proofs.bernstein_unity.met in
let _ := Part_Partition_proofs.trigonometric_unity.proved in
let _ := Part_Partition_proofs.trigonometric_unity.met in
let _ := Part_Powers_printed_proofs.power_next.proved in
let _ := Part_Powers_printed_proofs.power_next.met in
let _ := Part_Powers_printed_proofs.power_rate.proved in
let _ := Part_Powers_printed_proofs.power_rate.met in
let _ := Part_Powers_printed_proofs.power_rate_slip.refuted in
let _ := Part_Powers_printed_proofs.power_rate_slip_corrected.proved in
let _ := Part_Powers_printed_proofs.power_rate_slip_corrected.met in
let _ := Part_Powers_printed_proofs.power_product.proved in
let _ := Part_Powers_printed_proofs.power_product.met in
let _ := Part_Powers_printed_proofs.power_ends.proved in
let _ := Part_Powers_printed_proofs.power_ends.met in
let _ := Part_Powers_printed_proofs.power_binomial.proved in
let _ := Part_Powers_printed_proofs.power_binomial.met in
let _ := Part_Powers_proofs.power_next.proved in
let _ := Part_Powers_proofs.power_next.met in
let _ := Part_Powers_proofs.power_rate.proved in
let _ := Part_Powers_proofs.power_rate.met in
let _ := Part_Powers_proofs.power_rate_slip.refuted in
let _ := Part_Powers_proofs.power_rate_slip_corrected.proved in
let _ := Part_Powers_proofs.power_rate_slip_corrected.met in
let _ := Part_Powers_proofs.power_product.proved in
let _ := Part_Powers_proofs.power_product.met in
let _ := Part_Powers_proofs.power_ends.proved in
let _ := Part_Powers_proofs.power_ends.met in
let _ := Part_Powers_proofs.power_binomial.proved in
let _ := Part_Powers_proofs.power_binomial.met in
let _ := Part_README_printed_proofs.language_numbers.proved in
let _ := Part_README_printed_proofs.language_numbers.met in
let _ := Part_README_printed_proofs.language_calculus.proved in
let _ := Part_README_printed_proofs.language_calculus.met in
let _ := Part_README_printed_proofs.language_vectors.proved in
let _ := Part_README_printed_proofs.language_matrices.proved in
let _ := Part_README_printed_proofs.language_matrices.met in
let _ := Part_README_printed_proofs.language_decimals.proved in
let _ := Part_README_printed_proofs.language_divisor.proved in
let _ := Part_README_printed_proofs.language_divisor.met in
let _ := Part_README_printed_proofs.language_degree.proved in
let _ := Part_README_printed_proofs.language_degree.met in
let _ := Part_README_printed_proofs.language_order.proved in
let _ := Part_README_printed_proofs.language_order.met in
let _ := Part_README_printed_proofs.language_order_false.refuted in
let _ := Part_README_printed_proofs.language_assumed.proved in
let _ := Part_README_printed_proofs.language_assumed.met in
let _ := Part_README_printed_proofs.language_declared.proved in
let _ := Part_README_printed_proofs.language_declared.met in
let _ := Part_README_printed_proofs.language_decimals_false.refuted in
let _ := Part_README_proofs.language_numbers.proved in
let _ := Part_README_proofs.language_numbers.met in
let _ := Part_README_proofs.language_calculus.proved in
let _ := Part_README_proofs.language_calculus.met in
let _ := Part_README_proofs.language_vectors.proved in
let _ := Part_README_proofs.language_matrices.proved in
let _ := Part_README_proofs.language_matrices.met in
let _ := Part_README_proofs.language_decimals.proved in
let _ := Part_README_proofs.language_divisor.proved in
let _ := Part_README_proofs.language_divisor.met in
let _ := Part_README_proofs.language_degree.proved in
let _ := Part_README_proofs.language_degree.met in
let _ := Part_README_proofs.language_order.proved in
let _ := Part_README_proofs.language_order.met in
let _ := Part_README_proofs.language_order_false.refuted in
let _ := Part_README_proofs.language_assumed.proved in
let _ := Part_README_proofs.language_assumed.met in
let _ := Part_README_proofs.language_declared.proved in
let _ := Part_README_proofs.language_declared.met in
let _ := Part_README_proofs.language_decimals_false.refuted in
let _ := Part_Reflection_printed_proofs.curve_reflection.proved in
let _ := Part_Reflection_printed_proofs.curve_reflection.met in
let _ := Part_Reflection_proofs.curve_reflection.proved in
let _ := Part_Reflection_proofs.curve_reflection.met in
let _ := Part_Roots_printed_proofs.reach_unit.proved in
let _ := Part_Roots_printed_proofs.reach_unit.met in
let _ := Part_Roots_printed_proofs.reach_unit_zero.proved in
let _ := Part_Roots_printed_proofs.reach_unit_zero.met in
let _ := Part_Roots_printed_proofs.reach_size.proved in
let _ := Part_Roots_printed_proofs.reach_size.met in
let _ := Part_Roots_printed_proofs.reach_size_slip.refuted in
let _ := Part_Roots_printed_proofs.reach_product.proved in
let _ := Part_Roots_printed_proofs.reach_product.met in
let _ := Part_Roots_printed_proofs.reach_least.proved in
let _ := Part_Roots_printed_proofs.reach_least.met in
let _ := Part_Roots_printed_proofs.reach_triangle.proved in
let _ := Part_Roots_printed_proofs.reach_triangle_slip.refuted in
let _ := Part_Roots_printed_proofs.reach_subadditive.proved in
let _ := Part_Roots_printed_proofs.reach_subadditive.met in
let _ := Part_Roots_printed_proofs.reach_above.proved in
let _ := Part_Roots_printed_proofs.reach_above.met in
let _ := Part_Roots_proofs.reach_unit.proved in
let _ := Part_Roots_proofs.reach_unit.met in
let _ := Part_Roots_proofs.reach_unit_zero.proved in
let _ := Part_Roots_proofs.reach_unit_zero.met in
let _ := Part_Roots_proofs.reach_size.proved in
let _ := Part_Roots_proofs.reach_size.met in
let _ := Part_Roots_proofs.reach_size_slip.refuted in
let _ := Part_Roots_proofs.reach_product.proved in
let _ := Part_Roots_proofs.reach_product.met in
let _ := Part_Roots_proofs.reach_least.proved in
let _ := Part_Roots_proofs.reach_least.met in
let _ := Part_Roots_proofs.reach_triangle.proved in
let _ := Part_Roots_proofs.reach_triangle_slip.refuted in
let _ := Part_Roots_proofs.reach_subadditive.proved in
let _ := Part_Roots_proofs.reach_subadditive.met in
let _ := Part_Roots_proofs.reach_above.proved in
let _ := Part_Roots_proofs.reach_above.met in
let _ := Part_Subdivision_printed_proofs.curve_midpoint.proved in
let _ := Part_Subdivision_printed_proofs.curve_midpoint.met in
let _ := Part_Subdivision_proofs.curve_midpoint.proved in
let _ := Part_Subdivision_proofs.curve_midpoint.met in
let _ := Part_Sums_printed_proofs.sum_powers.proved in
let _ := Part_Sums_printed_proofs.sum_powers.met in
let _ := Part_Sums_printed_proofs.sum_powers_slip.refuted in
let _ := Part_Sums_printed_proofs.sum_powers_slip_corrected.proved in
let _ := Part_Sums_printed_proofs.sum_powers_slip_corrected.met in
let _ := Part_Sums_printed_proofs.sum_swap.proved in
let _ := Part_Sums_printed_proofs.sum_swap.met in
let _ := Part_Sums_printed_proofs.sum_swap_weighted.proved in
let _ := Part_Sums_printed_proofs.sum_swap_weighted.met in
let _ := Part_Sums_printed_proofs.sum_swap_slip.refuted in
let _ := Part_Sums_proofs.sum_powers.proved in
let _ := Part_Sums_proofs.sum_powers.met in
let _ := Part_Sums_proofs.sum_powers_slip.refuted in
let _ := Part_Sums_proofs.sum_powers_slip_corrected.proved in
let _ := Part_Sums_proofs.sum_powers_slip_corrected.met in
let _ := Part_Sums_proofs.sum_swap.proved in
let _ := Part_Sums_proofs.sum_swap.met in
let _ := Part_Sums_proofs.sum_swap_weighted.proved in
let _ := Part_Sums_proofs.sum_swap_weighted.met in
let _ := Part_Sums_proofs.sum_swap_slip.refuted in
let _ := Part_Symmetry_printed_proofs.bernstein_symmetry.proved in
let _ := Part_Symmetry_printed_proofs.bernstein_symmetry.met in
let _ := Part_Symmetry_printed_proofs.trigonometric_symmetry.proved in
let _ := Part_Symmetry_printed_proofs.trigonometric_symmetry.met in
let _ := Part_Symmetry_printed_proofs.trigonometric_symmetry_slip.refuted in
let _ := Part_Symmetry_printed_proofs.trigonometric_symmetry_slip_corrected.proved in
let _ := Part_Symmetry_printed_proofs.trigonometric_symmetry_slip_corrected.met in
let _ := Part_Symmetry_proofs.bernstein_symmetry.proved in
let _ := Part_Symmetry_proofs.bernstein_symmetry.met in
let _ := Part_Symmetry_proofs.trigonometric_symmetry.proved in
let _ := Part_Symmetry_proofs.trigonometric_symmetry.met in
let _ := Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted in
let _ := Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved in
let _ := Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met in
let _ := Part_The_printed_proofs.circle_kappa.proved in
let _ := Part_The_printed_proofs.circle_kappa_cut.proved in
let _ := Part_The_printed_proofs.circle_kappa_slip.refuted in
let _ := Part_The_printed_proofs.circle_middle.proved in
let _ := Part_The_printed_proofs.circle_outside.proved in
let _ := Part_The_printed_proofs.circle_outside.met in
let _ := Part_The_printed_proofs.circle_exact_slip.refuted in
let _ := Part_The_printed_proofs.reach_definite.proved in
let _ := Part_The_printed_proofs.reach_cauchy.proved in
let _ := Part_The_proofs.circle_kappa.proved in
let _ := Part_The_proofs.circle_kappa_cut.proved in
let _ := Part_The_proofs.circle_kappa_slip.refuted in
let _ := Part_The_proofs.circle_middle.proved in
let _ := Part_The_proofs.circle_outside.proved in
let _ := Part_The_proofs.circle_outside.met in
let _ := Part_The_proofs.circle_exact_slip.refuted in
let _ := Part_The_proofs.reach_definite.proved in
let _ := Part_The_proofs.reach_cauchy.proved in
I.
