(* The kernel's word: each theorem has the type of its statement, and what all of them assume. *)
From Bezier Require Part_A Part_A_proofs.
From Bezier Require Part_Algebraic Part_Algebraic_proofs.
From Bezier Require Part_Bounds Part_Bounds_proofs.
From Bezier Require Part_C Part_C_proofs.
From Bezier Require Part_Closed Part_Closed_proofs.
From Bezier Require Part_De Part_De_proofs.
From Bezier Require Part_Definition Part_Definition_proofs.
From Bezier Require Part_Degree Part_Degree_proofs.
From Bezier Require Part_Derivative Part_Derivative_proofs.
From Bezier Require Part_Divisors Part_Divisors_proofs.
From Bezier Require Part_End Part_End_proofs.
From Bezier Require Part_Families Part_Families_proofs.
From Bezier Require Part_G Part_G_proofs.
From Bezier Require Part_Hodograph Part_Hodograph_proofs.
From Bezier Require Part_Linear Part_Linear_proofs.
From Bezier Require Part_Lists Part_Lists_proofs.
From Bezier Require Part_Logic Part_Logic_proofs.
From Bezier Require Part_Nonnegativity Part_Nonnegativity_proofs.
From Bezier Require Part_Numbers Part_Numbers_proofs.
From Bezier Require Part_Partition Part_Partition_proofs.
From Bezier Require Part_Powers Part_Powers_proofs.
From Bezier Require Part_README Part_README_proofs.
From Bezier Require Part_Reflection Part_Reflection_proofs.
From Bezier Require Part_Roots Part_Roots_proofs.
From Bezier Require Part_Subdivision Part_Subdivision_proofs.
From Bezier Require Part_Sums Part_Sums_proofs.
From Bezier Require Part_Symmetry Part_Symmetry_proofs.
From Bezier Require Part_The Part_The_proofs.
From GbtDevelopable Require Part_Abstract Part_Abstract_proofs.
From GbtDevelopable Require Section_1 Section_1_proofs.
From GbtDevelopable Require Section_2_1 Section_2_1_proofs.
From GbtDevelopable Require Section_2_2 Section_2_2_proofs.
From GbtDevelopable Require Section_2_3 Section_2_3_proofs.
From GbtDevelopable Require Section_3_1 Section_3_1_proofs.
From GbtDevelopable Require Section_3_2 Section_3_2_proofs.
From GbtDevelopable Require Section_3_3 Section_3_3_proofs.
From GbtDevelopable Require Section_3_4 Section_3_4_proofs.
From GbtDevelopable Require Section_4_1 Section_4_1_proofs.
From GbtDevelopable Require Section_4_2 Section_4_2_proofs.
From GbtDevelopable Require Section_4 Section_4_proofs.
From GbtDevelopable Require Section_5_1 Section_5_1_proofs.
From GbtDevelopable Require Section_5_2 Section_5_2_proofs.
From GbtDevelopable Require Section_5_3 Section_5_3_proofs.
From GbtDevelopable Require Section_5_4 Section_5_4_proofs.
From GbtDevelopable Require Section_5_5 Section_5_5_proofs.
From GbtDevelopable Require Section_5 Section_5_proofs.
From GbtSurfaces Require Part_Abstract Part_Abstract_proofs.
From GbtSurfaces Require Part_Table Part_Table_proofs.
From GbtSurfaces Require Section_1 Section_1_proofs.
From GbtSurfaces Require Section_2_1 Section_2_1_proofs.
From GbtSurfaces Require Section_2_2 Section_2_2_proofs.
From GbtSurfaces Require Section_2_3 Section_2_3_proofs.
From GbtSurfaces Require Section_3_1 Section_3_1_proofs.
From GbtSurfaces Require Section_3_2 Section_3_2_proofs.
From GbtSurfaces Require Section_3_3 Section_3_3_proofs.
From GbtSurfaces Require Section_3_4 Section_3_4_proofs.
From GbtSurfaces Require Section_3_5 Section_3_5_proofs.
From GbtSurfaces Require Section_3_6 Section_3_6_proofs.
From GbtSurfaces Require Section_4 Section_4_proofs.
From HermiteDevelopable Require Part_Abstract Part_Abstract_proofs.
From HermiteDevelopable Require Section_1 Section_1_proofs.
From HermiteDevelopable Require Section_2 Section_2_proofs.
From HermiteDevelopable Require Section_3_1 Section_3_1_proofs.
From HermiteDevelopable Require Section_3_2 Section_3_2_proofs.
From HermiteDevelopable Require Section_3_3 Section_3_3_proofs.
From HermiteDevelopable Require Section_3 Section_3_proofs.
From HermiteDevelopable Require Section_4 Section_4_proofs.
From HermiteDevelopable Require Section_5 Section_5_proofs.
From Hyperbolic Require Part_Catenary Part_Catenary_proofs.
From Hyperbolic Require Part_Catenoid Part_Catenoid_proofs.
From Hyperbolic Require Part_Curves Part_Curves_proofs.
From Hyperbolic Require Part_Hyperbolas Part_Hyperbolas_proofs.
From Hyperbolic Require Part_Joins Part_Joins_proofs.
From Hyperbolic Require Part_Logarithmic Part_Logarithmic_proofs.
From Hyperbolic Require Part_Parts Part_Parts_proofs.
From Hyperbolic Require Part_Rates Part_Rates_proofs.
From Hyperbolic Require Part_Roots Part_Roots_proofs.
From Hyperbolic Require Part_Signs Part_Signs_proofs.
From Hyperbolic Require Part_Spiral Part_Spiral_proofs.
From Hyperbolic Require Part_Sums Part_Sums_proofs.
From Hyperbolic Require Part_The Part_The_proofs.
From Hyperbolic Require Part_Tractrix Part_Tractrix_proofs.
From Hyperbolic Require Part_Values Part_Values_proofs.
From Splines Require Part_At Part_At_proofs.
From Splines Require Part_B Part_B_proofs.
From Splines Require Part_Cubic Part_Cubic_proofs.
From Splines Require Part_Derivatives Part_Derivatives_proofs.
From Splines Require Part_One Part_One_proofs.
From Splines Require Part_Partition Part_Partition_proofs.
From Splines Require Part_Polynomials Part_Polynomials_proofs.
From Splines Require Part_Quadratic Part_Quadratic_proofs.
From Splines Require Part_Shape Part_Shape_proofs.
From Splines Require Part_Signs Part_Signs_proofs.
From Splines Require Part_Symmetry Part_Symmetry_proofs.
From Splines Require Part_The Part_The_proofs.
From Splines Require Part_Two Part_Two_proofs.
From Torses Require Part_Central Part_Central_proofs.
From Torses Require Part_Cones Part_Cones_proofs.
From Torses Require Part_Constant Part_Constant_proofs.
From Torses Require Part_Contact Part_Contact_proofs.
From Torses Require Part_Curvature Part_Curvature_proofs.
From Torses Require Part_Curves Part_Curves_proofs.
From Torses Require Part_Cylinders Part_Cylinders_proofs.
From Torses Require Part_Distribution Part_Distribution_proofs.
From Torses Require Part_Edge Part_Edge_proofs.
From Torses Require Part_Freedom Part_Freedom_proofs.
From Torses Require Part_Normal Part_Normal_proofs.
From Torses Require Part_Polar Part_Polar_proofs.
From Torses Require Part_Rectifying Part_Rectifying_proofs.
From Torses Require Part_Rulings Part_Rulings_proofs.
From Torses Require Part_Skew Part_Skew_proofs.
From Torses Require Part_Tangent Part_Tangent_proofs.
From Torses Require Part_Torses Part_Torses_proofs.
From Trigonometric Require Part_Cardioid Part_Cardioid_proofs.
From Trigonometric Require Part_Circles Part_Circles_proofs.
From Trigonometric Require Part_Curves Part_Curves_proofs.
From Trigonometric Require Part_Cycloid Part_Cycloid_proofs.
From Trigonometric Require Part_Half Part_Half_proofs.
From Trigonometric Require Part_Helicoid Part_Helicoid_proofs.
From Trigonometric Require Part_Helix Part_Helix_proofs.
From Trigonometric Require Part_Joins Part_Joins_proofs.
From Trigonometric Require Part_Known Part_Known_proofs.
From Trigonometric Require Part_Parts Part_Parts_proofs.
From Trigonometric Require Part_Roots Part_Roots_proofs.
From Trigonometric Require Part_Signs Part_Signs_proofs.
From Trigonometric Require Part_Tangent Part_Tangent_proofs.
From Trigonometric Require Part_Tangents Part_Tangents_proofs.
From Trigonometric Require Part_The Part_The_proofs.
Check (Bezier.Part_A_proofs.trigonometric_circle.proved : Bezier.Part_A.trigonometric_circle.statement).
Check (Bezier.Part_A_proofs.trigonometric_circle.met : Bezier.Part_A.trigonometric_circle.instance).
Check (Bezier.Part_Algebraic_proofs.reach_root.proved : Bezier.Part_Algebraic.reach_root.statement).
Check (Bezier.Part_Algebraic_proofs.reach_root.met : Bezier.Part_Algebraic.reach_root.instance).
Check (Bezier.Part_Algebraic_proofs.reach_square.proved : Bezier.Part_Algebraic.reach_square.statement).
Check (Bezier.Part_Algebraic_proofs.reach_square.met : Bezier.Part_Algebraic.reach_square.instance).
Check (Bezier.Part_Bounds_proofs.reach_surd.proved : Bezier.Part_Bounds.reach_surd.statement).
Check (Bezier.Part_Bounds_proofs.reach_surd.met : Bezier.Part_Bounds.reach_surd.instance).
Check (Bezier.Part_Bounds_proofs.reach_simplex.proved : Bezier.Part_Bounds.reach_simplex.statement).
Check (Bezier.Part_Bounds_proofs.reach_simplex.met : Bezier.Part_Bounds.reach_simplex.instance).
Check (Bezier.Part_Bounds_proofs.reach_between.proved : Bezier.Part_Bounds.reach_between.statement).
Check (Bezier.Part_Bounds_proofs.reach_between.met : Bezier.Part_Bounds.reach_between.instance).
Check (Bezier.Part_Bounds_proofs.reach_interval.proved : Bezier.Part_Bounds.reach_interval.statement).
Check (Bezier.Part_Bounds_proofs.reach_interval.met : Bezier.Part_Bounds.reach_interval.instance).
Check (Bezier.Part_Bounds_proofs.reach_interval_basis.proved : Bezier.Part_Bounds.reach_interval_basis.statement).
Check (Bezier.Part_Bounds_proofs.reach_interval_basis.met : Bezier.Part_Bounds.reach_interval_basis.instance).
Check (Bezier.Part_C_proofs.join_C0.proved : Bezier.Part_C.join_C0.statement).
Check (Bezier.Part_C_proofs.join_C0.met : Bezier.Part_C.join_C0.instance).
Check (Bezier.Part_C_proofs.join_C1.proved : Bezier.Part_C.join_C1.statement).
Check (Bezier.Part_C_proofs.join_C1.met : Bezier.Part_C.join_C1.instance).
Check (Bezier.Part_C_proofs.join_C1_slip.refuted : ~ Bezier.Part_C.join_C1_slip.statement).
Check (Bezier.Part_C_proofs.join_C1_slip_corrected.proved : Bezier.Part_C.join_C1_slip_corrected.statement).
Check (Bezier.Part_C_proofs.join_C1_slip_corrected.met : Bezier.Part_C.join_C1_slip_corrected.instance).
Check (Bezier.Part_C_proofs.join_C2.proved : Bezier.Part_C.join_C2.statement).
Check (Bezier.Part_C_proofs.join_C2.met : Bezier.Part_C.join_C2.instance).
Check (Bezier.Part_C_proofs.join_C2_slip.refuted : ~ Bezier.Part_C.join_C2_slip.statement).
Check (Bezier.Part_C_proofs.join_C2_slip_corrected.proved : Bezier.Part_C.join_C2_slip_corrected.statement).
Check (Bezier.Part_C_proofs.join_C2_slip_corrected.met : Bezier.Part_C.join_C2_slip_corrected.instance).
Check (Bezier.Part_C_proofs.join_C3.proved : Bezier.Part_C.join_C3.statement).
Check (Bezier.Part_C_proofs.join_C3.met : Bezier.Part_C.join_C3.instance).
Check (Bezier.Part_C_proofs.join_C2_sufficient.proved : Bezier.Part_C.join_C2_sufficient.statement).
Check (Bezier.Part_C_proofs.join_C2_sufficient.met : Bezier.Part_C.join_C2_sufficient.instance).
Check (Bezier.Part_C_proofs.join_knot.proved : Bezier.Part_C.join_knot.statement).
Check (Bezier.Part_C_proofs.join_knot.met : Bezier.Part_C.join_knot.instance).
Check (Bezier.Part_C_proofs.trigonometric_C1.proved : Bezier.Part_C.trigonometric_C1.statement).
Check (Bezier.Part_C_proofs.trigonometric_C1.met : Bezier.Part_C.trigonometric_C1.instance).
Check (Bezier.Part_C_proofs.trigonometric_C1_inside.proved : Bezier.Part_C.trigonometric_C1_inside.statement).
Check (Bezier.Part_C_proofs.trigonometric_C1_inside.met : Bezier.Part_C.trigonometric_C1_inside.instance).
Check (Bezier.Part_C_proofs.trigonometric_bezier.proved : Bezier.Part_C.trigonometric_bezier.statement).
Check (Bezier.Part_C_proofs.trigonometric_bezier.met : Bezier.Part_C.trigonometric_bezier.instance).
Check (Bezier.Part_Closed_proofs.bernstein_formula.proved : Bezier.Part_Closed.bernstein_formula.statement).
Check (Bezier.Part_Closed_proofs.bernstein_formula.met : Bezier.Part_Closed.bernstein_formula.instance).
Check (Bezier.Part_De_proofs.curve_casteljau.proved : Bezier.Part_De.curve_casteljau.statement).
Check (Bezier.Part_De_proofs.curve_casteljau.met : Bezier.Part_De.curve_casteljau.instance).
Check (Bezier.Part_Definition_proofs.bernstein_recursion.proved : Bezier.Part_Definition.bernstein_recursion.statement).
Check (Bezier.Part_Definition_proofs.bernstein_recursion.met : Bezier.Part_Definition.bernstein_recursion.instance).
Check (Bezier.Part_Degree_proofs.bernstein_elevation.proved : Bezier.Part_Degree.bernstein_elevation.statement).
Check (Bezier.Part_Degree_proofs.bernstein_elevation.met : Bezier.Part_Degree.bernstein_elevation.instance).
Check (Bezier.Part_Degree_proofs.curve_elevation.proved : Bezier.Part_Degree.curve_elevation.statement).
Check (Bezier.Part_Degree_proofs.curve_elevation.met : Bezier.Part_Degree.curve_elevation.instance).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative.proved : Bezier.Part_Derivative.bernstein_derivative.statement).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative.met : Bezier.Part_Derivative.bernstein_derivative.instance).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip.refuted : ~ Bezier.Part_Derivative.bernstein_derivative_slip.statement).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved : Bezier.Part_Derivative.bernstein_derivative_slip_corrected.statement).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.met : Bezier.Part_Derivative.bernstein_derivative_slip_corrected.instance).
Check (Bezier.Part_Divisors_proofs.reach_interval_open.proved : Bezier.Part_Divisors.reach_interval_open.statement).
Check (Bezier.Part_Divisors_proofs.reach_interval_open.met : Bezier.Part_Divisors.reach_interval_open.instance).
Check (Bezier.Part_Divisors_proofs.reach_interval_closed.proved : Bezier.Part_Divisors.reach_interval_closed.statement).
Check (Bezier.Part_Divisors_proofs.reach_interval_closed.met : Bezier.Part_Divisors.reach_interval_closed.instance).
Check (Bezier.Part_Divisors_proofs.reach_positive.proved : Bezier.Part_Divisors.reach_positive.statement).
Check (Bezier.Part_Divisors_proofs.reach_positive.met : Bezier.Part_Divisors.reach_positive.instance).
Check (Bezier.Part_Divisors_proofs.reach_open.proved : Bezier.Part_Divisors.reach_open.statement).
Check (Bezier.Part_Divisors_proofs.reach_open.met : Bezier.Part_Divisors.reach_open.instance).
Check (Bezier.Part_Divisors_proofs.reach_ordered.proved : Bezier.Part_Divisors.reach_ordered.statement).
Check (Bezier.Part_Divisors_proofs.reach_ordered.met : Bezier.Part_Divisors.reach_ordered.instance).
Check (Bezier.Part_Divisors_proofs.reach_vector.proved : Bezier.Part_Divisors.reach_vector.statement).
Check (Bezier.Part_Divisors_proofs.reach_vector.met : Bezier.Part_Divisors.reach_vector.instance).
Check (Bezier.Part_End_proofs.curve_ends.proved : Bezier.Part_End.curve_ends.statement).
Check (Bezier.Part_End_proofs.curve_ends.met : Bezier.Part_End.curve_ends.instance).
Check (Bezier.Part_End_proofs.curve_d1.proved : Bezier.Part_End.curve_d1.statement).
Check (Bezier.Part_End_proofs.curve_d1.met : Bezier.Part_End.curve_d1.instance).
Check (Bezier.Part_End_proofs.curve_d2.proved : Bezier.Part_End.curve_d2.statement).
Check (Bezier.Part_End_proofs.curve_d2.met : Bezier.Part_End.curve_d2.instance).
Check (Bezier.Part_End_proofs.curve_d2_slip.refuted : ~ Bezier.Part_End.curve_d2_slip.statement).
Check (Bezier.Part_End_proofs.curve_d2_slip_corrected.proved : Bezier.Part_End.curve_d2_slip_corrected.statement).
Check (Bezier.Part_End_proofs.curve_d2_slip_corrected.met : Bezier.Part_End.curve_d2_slip_corrected.instance).
Check (Bezier.Part_End_proofs.curve_d3.proved : Bezier.Part_End.curve_d3.statement).
Check (Bezier.Part_End_proofs.curve_d3.met : Bezier.Part_End.curve_d3.instance).
Check (Bezier.Part_End_proofs.trigonometric_d1.proved : Bezier.Part_End.trigonometric_d1.statement).
Check (Bezier.Part_End_proofs.trigonometric_d1.met : Bezier.Part_End.trigonometric_d1.instance).
Check (Bezier.Part_End_proofs.trigonometric_d1_slip.refuted : ~ Bezier.Part_End.trigonometric_d1_slip.statement).
Check (Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.proved : Bezier.Part_End.trigonometric_d1_slip_corrected.statement).
Check (Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.met : Bezier.Part_End.trigonometric_d1_slip_corrected.instance).
Check (Bezier.Part_End_proofs.trigonometric_d2.proved : Bezier.Part_End.trigonometric_d2.statement).
Check (Bezier.Part_End_proofs.trigonometric_d2.met : Bezier.Part_End.trigonometric_d2.instance).
Check (Bezier.Part_Families_proofs.family_corner.proved : Bezier.Part_Families.family_corner.statement).
Check (Bezier.Part_Families_proofs.family_corner.met : Bezier.Part_Families.family_corner.instance).
Check (Bezier.Part_Families_proofs.family_casteljau.proved : Bezier.Part_Families.family_casteljau.statement).
Check (Bezier.Part_Families_proofs.family_casteljau.met : Bezier.Part_Families.family_casteljau.instance).
Check (Bezier.Part_Families_proofs.family_casteljau_slip.refuted : ~ Bezier.Part_Families.family_casteljau_slip.statement).
Check (Bezier.Part_Families_proofs.family_weights.proved : Bezier.Part_Families.family_weights.statement).
Check (Bezier.Part_Families_proofs.family_weights.met : Bezier.Part_Families.family_weights.instance).
Check (Bezier.Part_G_proofs.join_G2.proved : Bezier.Part_G.join_G2.statement).
Check (Bezier.Part_G_proofs.join_G2.met : Bezier.Part_G.join_G2.instance).
Check (Bezier.Part_Hodograph_proofs.curve_hodograph.proved : Bezier.Part_Hodograph.curve_hodograph.statement).
Check (Bezier.Part_Hodograph_proofs.curve_hodograph.met : Bezier.Part_Hodograph.curve_hodograph.instance).
Check (Bezier.Part_Linear_proofs.bernstein_precision.proved : Bezier.Part_Linear.bernstein_precision.statement).
Check (Bezier.Part_Linear_proofs.bernstein_precision.met : Bezier.Part_Linear.bernstein_precision.instance).
Check (Bezier.Part_Lists_proofs.list_unity.proved : Bezier.Part_Lists.list_unity.statement).
Check (Bezier.Part_Lists_proofs.list_unity.met : Bezier.Part_Lists.list_unity.instance).
Check (Bezier.Part_Lists_proofs.list_nonnegative.proved : Bezier.Part_Lists.list_nonnegative.statement).
Check (Bezier.Part_Lists_proofs.list_nonnegative.met : Bezier.Part_Lists.list_nonnegative.instance).
Check (Bezier.Part_Lists_proofs.list_nonnegative_slip.refuted : ~ Bezier.Part_Lists.list_nonnegative_slip.statement).
Check (Bezier.Part_Logic_proofs.reach_implies.proved : Bezier.Part_Logic.reach_implies.statement).
Check (Bezier.Part_Logic_proofs.reach_length_zero.proved : Bezier.Part_Logic.reach_length_zero.statement).
Check (Bezier.Part_Logic_proofs.reach_product_zero.proved : Bezier.Part_Logic.reach_product_zero.statement).
Check (Bezier.Part_Logic_proofs.reach_roots.proved : Bezier.Part_Logic.reach_roots.statement).
Check (Bezier.Part_Logic_proofs.reach_roots_slip.refuted : ~ Bezier.Part_Logic.reach_roots_slip.statement).
Check (Bezier.Part_Logic_proofs.reach_weights_zero.proved : Bezier.Part_Logic.reach_weights_zero.statement).
Check (Bezier.Part_Logic_proofs.reach_weights_zero.met : Bezier.Part_Logic.reach_weights_zero.instance).
Check (Bezier.Part_Logic_proofs.reach_circle_bound.proved : Bezier.Part_Logic.reach_circle_bound.statement).
Check (Bezier.Part_Logic_proofs.reach_circle_bound.met : Bezier.Part_Logic.reach_circle_bound.instance).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.proved : Bezier.Part_Nonnegativity.bernstein_nonnegative.statement).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.met : Bezier.Part_Nonnegativity.bernstein_nonnegative.instance).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted : ~ Bezier.Part_Nonnegativity.bernstein_nonnegative_slip.statement).
Check (Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.proved : Bezier.Part_Nonnegativity.trigonometric_nonnegative.statement).
Check (Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.met : Bezier.Part_Nonnegativity.trigonometric_nonnegative.instance).
Check (Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted : ~ Bezier.Part_Nonnegativity.trigonometric_nonnegative_slip.statement).
Check (Bezier.Part_Numbers_proofs.exists_quotient_any.proved : Bezier.Part_Numbers.exists_quotient_any.statement).
Check (Bezier.Part_Numbers_proofs.exists_quotient_any.met : Bezier.Part_Numbers.exists_quotient_any.instance).
Check (Bezier.Part_Numbers_proofs.exists_above.proved : Bezier.Part_Numbers.exists_above.statement).
Check (Bezier.Part_Numbers_proofs.exists_above.met : Bezier.Part_Numbers.exists_above.instance).
Check (Bezier.Part_Numbers_proofs.exists_root.proved : Bezier.Part_Numbers.exists_root.statement).
Check (Bezier.Part_Numbers_proofs.exists_root.met : Bezier.Part_Numbers.exists_root.instance).
Check (Bezier.Part_Numbers_proofs.exists_none.refuted : ~ Bezier.Part_Numbers.exists_none.statement).
Check (Bezier.Part_Numbers_proofs.exists_parallel.proved : Bezier.Part_Numbers.exists_parallel.statement).
Check (Bezier.Part_Numbers_proofs.exists_parallel.met : Bezier.Part_Numbers.exists_parallel.instance).
Check (Bezier.Part_Numbers_proofs.exists_parallel_only.proved : Bezier.Part_Numbers.exists_parallel_only.statement).
Check (Bezier.Part_Numbers_proofs.exists_parallel_only.met : Bezier.Part_Numbers.exists_parallel_only.instance).
Check (Bezier.Part_Partition_proofs.bernstein_unity.proved : Bezier.Part_Partition.bernstein_unity.statement).
Check (Bezier.Part_Partition_proofs.bernstein_unity.met : Bezier.Part_Partition.bernstein_unity.instance).
Check (Bezier.Part_Partition_proofs.trigonometric_unity.proved : Bezier.Part_Partition.trigonometric_unity.statement).
Check (Bezier.Part_Partition_proofs.trigonometric_unity.met : Bezier.Part_Partition.trigonometric_unity.instance).
Check (Bezier.Part_Powers_proofs.power_next.proved : Bezier.Part_Powers.power_next.statement).
Check (Bezier.Part_Powers_proofs.power_next.met : Bezier.Part_Powers.power_next.instance).
Check (Bezier.Part_Powers_proofs.power_rate.proved : Bezier.Part_Powers.power_rate.statement).
Check (Bezier.Part_Powers_proofs.power_rate.met : Bezier.Part_Powers.power_rate.instance).
Check (Bezier.Part_Powers_proofs.power_rate_slip.refuted : ~ Bezier.Part_Powers.power_rate_slip.statement).
Check (Bezier.Part_Powers_proofs.power_rate_slip_corrected.proved : Bezier.Part_Powers.power_rate_slip_corrected.statement).
Check (Bezier.Part_Powers_proofs.power_rate_slip_corrected.met : Bezier.Part_Powers.power_rate_slip_corrected.instance).
Check (Bezier.Part_Powers_proofs.power_product.proved : Bezier.Part_Powers.power_product.statement).
Check (Bezier.Part_Powers_proofs.power_product.met : Bezier.Part_Powers.power_product.instance).
Check (Bezier.Part_Powers_proofs.power_ends.proved : Bezier.Part_Powers.power_ends.statement).
Check (Bezier.Part_Powers_proofs.power_ends.met : Bezier.Part_Powers.power_ends.instance).
Check (Bezier.Part_Powers_proofs.power_binomial.proved : Bezier.Part_Powers.power_binomial.statement).
Check (Bezier.Part_Powers_proofs.power_binomial.met : Bezier.Part_Powers.power_binomial.instance).
Check (Bezier.Part_README_proofs.language_numbers.proved : Bezier.Part_README.language_numbers.statement).
Check (Bezier.Part_README_proofs.language_numbers.met : Bezier.Part_README.language_numbers.instance).
Check (Bezier.Part_README_proofs.language_calculus.proved : Bezier.Part_README.language_calculus.statement).
Check (Bezier.Part_README_proofs.language_calculus.met : Bezier.Part_README.language_calculus.instance).
Check (Bezier.Part_README_proofs.language_vectors.proved : Bezier.Part_README.language_vectors.statement).
Check (Bezier.Part_README_proofs.language_matrices.proved : Bezier.Part_README.language_matrices.statement).
Check (Bezier.Part_README_proofs.language_matrices.met : Bezier.Part_README.language_matrices.instance).
Check (Bezier.Part_README_proofs.language_decimals.proved : Bezier.Part_README.language_decimals.statement).
Check (Bezier.Part_README_proofs.language_divisor.proved : Bezier.Part_README.language_divisor.statement).
Check (Bezier.Part_README_proofs.language_divisor.met : Bezier.Part_README.language_divisor.instance).
Check (Bezier.Part_README_proofs.language_degree.proved : Bezier.Part_README.language_degree.statement).
Check (Bezier.Part_README_proofs.language_degree.met : Bezier.Part_README.language_degree.instance).
Check (Bezier.Part_README_proofs.language_order.proved : Bezier.Part_README.language_order.statement).
Check (Bezier.Part_README_proofs.language_order.met : Bezier.Part_README.language_order.instance).
Check (Bezier.Part_README_proofs.language_order_false.refuted : ~ Bezier.Part_README.language_order_false.statement).
Check (Bezier.Part_README_proofs.language_assumed.proved : Bezier.Part_README.language_assumed.statement).
Check (Bezier.Part_README_proofs.language_assumed.met : Bezier.Part_README.language_assumed.instance).
Check (Bezier.Part_README_proofs.language_declared.proved : Bezier.Part_README.language_declared.statement).
Check (Bezier.Part_README_proofs.language_declared.met : Bezier.Part_README.language_declared.instance).
Check (Bezier.Part_README_proofs.language_decimals_false.refuted : ~ Bezier.Part_README.language_decimals_false.statement).
Check (Bezier.Part_Reflection_proofs.curve_reflection.proved : Bezier.Part_Reflection.curve_reflection.statement).
Check (Bezier.Part_Reflection_proofs.curve_reflection.met : Bezier.Part_Reflection.curve_reflection.instance).
Check (Bezier.Part_Roots_proofs.reach_unit.proved : Bezier.Part_Roots.reach_unit.statement).
Check (Bezier.Part_Roots_proofs.reach_unit.met : Bezier.Part_Roots.reach_unit.instance).
Check (Bezier.Part_Roots_proofs.reach_unit_zero.proved : Bezier.Part_Roots.reach_unit_zero.statement).
Check (Bezier.Part_Roots_proofs.reach_unit_zero.met : Bezier.Part_Roots.reach_unit_zero.instance).
Check (Bezier.Part_Roots_proofs.reach_size.proved : Bezier.Part_Roots.reach_size.statement).
Check (Bezier.Part_Roots_proofs.reach_size.met : Bezier.Part_Roots.reach_size.instance).
Check (Bezier.Part_Roots_proofs.reach_size_slip.refuted : ~ Bezier.Part_Roots.reach_size_slip.statement).
Check (Bezier.Part_Roots_proofs.reach_product.proved : Bezier.Part_Roots.reach_product.statement).
Check (Bezier.Part_Roots_proofs.reach_product.met : Bezier.Part_Roots.reach_product.instance).
Check (Bezier.Part_Roots_proofs.reach_least.proved : Bezier.Part_Roots.reach_least.statement).
Check (Bezier.Part_Roots_proofs.reach_least.met : Bezier.Part_Roots.reach_least.instance).
Check (Bezier.Part_Roots_proofs.reach_triangle.proved : Bezier.Part_Roots.reach_triangle.statement).
Check (Bezier.Part_Roots_proofs.reach_triangle_slip.refuted : ~ Bezier.Part_Roots.reach_triangle_slip.statement).
Check (Bezier.Part_Roots_proofs.reach_subadditive.proved : Bezier.Part_Roots.reach_subadditive.statement).
Check (Bezier.Part_Roots_proofs.reach_subadditive.met : Bezier.Part_Roots.reach_subadditive.instance).
Check (Bezier.Part_Roots_proofs.reach_above.proved : Bezier.Part_Roots.reach_above.statement).
Check (Bezier.Part_Roots_proofs.reach_above.met : Bezier.Part_Roots.reach_above.instance).
Check (Bezier.Part_Subdivision_proofs.curve_midpoint.proved : Bezier.Part_Subdivision.curve_midpoint.statement).
Check (Bezier.Part_Subdivision_proofs.curve_midpoint.met : Bezier.Part_Subdivision.curve_midpoint.instance).
Check (Bezier.Part_Sums_proofs.sum_powers.proved : Bezier.Part_Sums.sum_powers.statement).
Check (Bezier.Part_Sums_proofs.sum_powers.met : Bezier.Part_Sums.sum_powers.instance).
Check (Bezier.Part_Sums_proofs.sum_powers_slip.refuted : ~ Bezier.Part_Sums.sum_powers_slip.statement).
Check (Bezier.Part_Sums_proofs.sum_powers_slip_corrected.proved : Bezier.Part_Sums.sum_powers_slip_corrected.statement).
Check (Bezier.Part_Sums_proofs.sum_powers_slip_corrected.met : Bezier.Part_Sums.sum_powers_slip_corrected.instance).
Check (Bezier.Part_Sums_proofs.sum_swap.proved : Bezier.Part_Sums.sum_swap.statement).
Check (Bezier.Part_Sums_proofs.sum_swap.met : Bezier.Part_Sums.sum_swap.instance).
Check (Bezier.Part_Sums_proofs.sum_swap_weighted.proved : Bezier.Part_Sums.sum_swap_weighted.statement).
Check (Bezier.Part_Sums_proofs.sum_swap_weighted.met : Bezier.Part_Sums.sum_swap_weighted.instance).
Check (Bezier.Part_Sums_proofs.sum_swap_slip.refuted : ~ Bezier.Part_Sums.sum_swap_slip.statement).
Check (Bezier.Part_Symmetry_proofs.bernstein_symmetry.proved : Bezier.Part_Symmetry.bernstein_symmetry.statement).
Check (Bezier.Part_Symmetry_proofs.bernstein_symmetry.met : Bezier.Part_Symmetry.bernstein_symmetry.instance).
Check (Bezier.Part_Symmetry_proofs.trigonometric_symmetry.proved : Bezier.Part_Symmetry.trigonometric_symmetry.statement).
Check (Bezier.Part_Symmetry_proofs.trigonometric_symmetry.met : Bezier.Part_Symmetry.trigonometric_symmetry.instance).
Check (Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted : ~ Bezier.Part_Symmetry.trigonometric_symmetry_slip.statement).
Check (Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved : Bezier.Part_Symmetry.trigonometric_symmetry_slip_corrected.statement).
Check (Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met : Bezier.Part_Symmetry.trigonometric_symmetry_slip_corrected.instance).
Check (Bezier.Part_The_proofs.circle_kappa.proved : Bezier.Part_The.circle_kappa.statement).
Check (Bezier.Part_The_proofs.circle_kappa_cut.proved : Bezier.Part_The.circle_kappa_cut.statement).
Check (Bezier.Part_The_proofs.circle_kappa_slip.refuted : ~ Bezier.Part_The.circle_kappa_slip.statement).
Check (Bezier.Part_The_proofs.circle_middle.proved : Bezier.Part_The.circle_middle.statement).
Check (Bezier.Part_The_proofs.circle_outside.proved : Bezier.Part_The.circle_outside.statement).
Check (Bezier.Part_The_proofs.circle_outside.met : Bezier.Part_The.circle_outside.instance).
Check (Bezier.Part_The_proofs.circle_exact_slip.refuted : ~ Bezier.Part_The.circle_exact_slip.statement).
Check (Bezier.Part_The_proofs.reach_definite.proved : Bezier.Part_The.reach_definite.statement).
Check (Bezier.Part_The_proofs.reach_cauchy.proved : Bezier.Part_The.reach_cauchy.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_planes.refuted : ~ GbtDevelopable.Part_Abstract.abs_conics_planes.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved : GbtDevelopable.Part_Abstract.abs_conics_points.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_points.met : GbtDevelopable.Part_Abstract.abs_conics_points.instance).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved : GbtDevelopable.Part_Abstract.abs_4d_factor.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met : GbtDevelopable.Part_Abstract.abs_4d_factor.instance).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_a.proved : GbtDevelopable.Section_1.intro_continuity_free_a.statement).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_a.met : GbtDevelopable.Section_1.intro_continuity_free_a.instance).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted : ~ GbtDevelopable.Section_1.intro_continuity_free_b_any_values.statement).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_c_any_values.refuted : ~ GbtDevelopable.Section_1.intro_continuity_free_c_any_values.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g0.proved : GbtDevelopable.Section_2_1.def_1_g0.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g0.met : GbtDevelopable.Section_2_1.def_1_g0.instance).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g1.proved : GbtDevelopable.Section_2_1.def_1_g1.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g1.met : GbtDevelopable.Section_2_1.def_1_g1.instance).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g2.proved : GbtDevelopable.Section_2_1.def_1_g2.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_g2.met : GbtDevelopable.Section_2_1.def_1_g2.instance).
Check (GbtDevelopable.Section_2_1_proofs.def_1_range.proved : GbtDevelopable.Section_2_1.def_1_range.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_range.met : GbtDevelopable.Section_2_1.def_1_range.instance).
Check (GbtDevelopable.Section_2_1_proofs.eq_2_1.proved : GbtDevelopable.Section_2_1.eq_2_1.statement).
Check (GbtDevelopable.Section_2_1_proofs.eq_2_1.met : GbtDevelopable.Section_2_1.eq_2_1.instance).
Check (GbtDevelopable.Section_2_1_proofs.def_1_zero.proved : GbtDevelopable.Section_2_1.def_1_zero.statement).
Check (GbtDevelopable.Section_2_1_proofs.def_1_zero.met : GbtDevelopable.Section_2_1.def_1_zero.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_functions.refuted : ~ GbtDevelopable.Section_2_1.thm_1_1_k2_functions.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.proved : GbtDevelopable.Section_2_1.thm_1_1_k2_substitution.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.met : GbtDevelopable.Section_2_1.thm_1_1_k2_substitution.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_functions.refuted : ~ GbtDevelopable.Section_2_1.thm_1_1_k3plus_functions.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted : ~ GbtDevelopable.Section_2_1.thm_1_1_k3plus_substitution.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.proved : GbtDevelopable.Section_2_1.thm_1_1_k3plus_letters.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.met : GbtDevelopable.Section_2_1.thm_1_1_k3plus_letters.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.proved : GbtDevelopable.Section_2_1.thm_1_1_degeneration.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.met : GbtDevelopable.Section_2_1.thm_1_1_degeneration.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.proved : GbtDevelopable.Section_2_1.thm_1_1_degeneration_only.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.met : GbtDevelopable.Section_2_1.thm_1_1_degeneration_only.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.proved : GbtDevelopable.Section_2_1.thm_1_1_no_degeneration.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.met : GbtDevelopable.Section_2_1.thm_1_1_no_degeneration.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.proved : GbtDevelopable.Section_2_1.thm_1_1_jets.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.met : GbtDevelopable.Section_2_1.thm_1_1_jets.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_2.proved : GbtDevelopable.Section_2_1.thm_1_2.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_2.met : GbtDevelopable.Section_2_1.thm_1_2.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_3.proved : GbtDevelopable.Section_2_1.thm_1_3.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_3.met : GbtDevelopable.Section_2_1.thm_1_3.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_4.proved : GbtDevelopable.Section_2_1.thm_1_4.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_4.met : GbtDevelopable.Section_2_1.thm_1_4.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5.refuted : ~ GbtDevelopable.Section_2_1.thm_1_5.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.proved : GbtDevelopable.Section_2_1.thm_1_5_quadratic.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.met : GbtDevelopable.Section_2_1.thm_1_5_quadratic.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.proved : GbtDevelopable.Section_2_1.thm_1_5_cubic.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.met : GbtDevelopable.Section_2_1.thm_1_5_cubic.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_all.proved : GbtDevelopable.Section_2_1.thm_1_5_all.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_all.met : GbtDevelopable.Section_2_1.thm_1_5_all.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_a.proved : GbtDevelopable.Section_2_1.thm_1_6_a.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_a.met : GbtDevelopable.Section_2_1.thm_1_6_a.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_b.proved : GbtDevelopable.Section_2_1.thm_1_6_b.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_b.met : GbtDevelopable.Section_2_1.thm_1_6_b.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_c.proved : GbtDevelopable.Section_2_1.thm_1_6_c.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_c.met : GbtDevelopable.Section_2_1.thm_1_6_c.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_d.proved : GbtDevelopable.Section_2_1.thm_1_6_d.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_d.met : GbtDevelopable.Section_2_1.thm_1_6_d.instance).
Check (GbtDevelopable.Section_2_2_proofs.eq_2_2.proved : GbtDevelopable.Section_2_2.eq_2_2.statement).
Check (GbtDevelopable.Section_2_2_proofs.eq_2_2.met : GbtDevelopable.Section_2_2.eq_2_2.instance).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_one_letter.refuted : ~ GbtDevelopable.Section_2_2.def_2_dim_one_letter.statement).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.proved : GbtDevelopable.Section_2_2.def_2_dim_two_letters.statement).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.met : GbtDevelopable.Section_2_2.def_2_dim_two_letters.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.proved : GbtDevelopable.Section_2_2.sec_2_2_endpoints.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.met : GbtDevelopable.Section_2_2.sec_2_2_endpoints.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.proved : GbtDevelopable.Section_2_2.sec_2_2_convexity.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.met : GbtDevelopable.Section_2_2.sec_2_2_convexity.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.proved : GbtDevelopable.Section_2_2.sec_2_2_symmetry.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.met : GbtDevelopable.Section_2_2.sec_2_2_symmetry.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.proved : GbtDevelopable.Section_2_2.sec_2_2_symmetry_exchange.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.met : GbtDevelopable.Section_2_2.sec_2_2_symmetry_exchange.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.proved : GbtDevelopable.Section_2_2.sec_2_2_vd_quadratic.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.met : GbtDevelopable.Section_2_2.sec_2_2_vd_quadratic.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.proved : GbtDevelopable.Section_2_2.sec_2_2_vd_operator.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.met : GbtDevelopable.Section_2_2.sec_2_2_vd_operator.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.proved : GbtDevelopable.Section_2_2.sec_2_2_geominv.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.met : GbtDevelopable.Section_2_2.sec_2_2_geominv.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_curve.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved : GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_composite.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met : GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_composite.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.proved : GbtDevelopable.Section_2_3.sec_2_3_linear.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.met : GbtDevelopable.Section_2_3.sec_2_3_linear.instance).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_3.refuted : ~ GbtDevelopable.Section_2_3.eq_2_3.statement).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.proved : GbtDevelopable.Section_2_3.eq_2_3_corrected.statement).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.met : GbtDevelopable.Section_2_3.eq_2_3_corrected.instance).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_4.refuted : ~ GbtDevelopable.Section_2_3.eq_2_4.statement).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.proved : GbtDevelopable.Section_2_3.eq_2_4_corrected.statement).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.met : GbtDevelopable.Section_2_3.eq_2_4_corrected.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.proved : GbtDevelopable.Section_2_3.sec_2_3_indep_mu.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.met : GbtDevelopable.Section_2_3.sec_2_3_indep_mu.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.proved : GbtDevelopable.Section_2_3.sec_2_3_indep_nu.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.met : GbtDevelopable.Section_2_3.sec_2_3_indep_nu.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_move.proved : GbtDevelopable.Section_2_3.sec_2_3_move.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_move.met : GbtDevelopable.Section_2_3.sec_2_3_move.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.proved : GbtDevelopable.Section_2_3.sec_2_3_dir_mu.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.met : GbtDevelopable.Section_2_3.sec_2_3_dir_mu.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.proved : GbtDevelopable.Section_2_3.sec_2_3_dir_mu_single.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.met : GbtDevelopable.Section_2_3.sec_2_3_dir_mu_single.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.proved : GbtDevelopable.Section_2_3.sec_2_3_dir_nu.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.met : GbtDevelopable.Section_2_3.sec_2_3_dir_nu.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_range.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_range.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.proved : GbtDevelopable.Section_2_3.sec_2_3_concl_1.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.met : GbtDevelopable.Section_2_3.sec_2_3_concl_1.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_concl_2_boundary_of_the_hull.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_concl_2_control_polygon.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.proved : GbtDevelopable.Section_2_3.sec_2_3_concl_2_quadratic.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.met : GbtDevelopable.Section_2_3.sec_2_3_concl_2_quadratic.instance).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved : GbtDevelopable.Section_3_1.sec_3_1_space.statement).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met : GbtDevelopable.Section_3_1.sec_3_1_space.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_1.proved : GbtDevelopable.Section_3_1.eq_3_1.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_1.met : GbtDevelopable.Section_3_1.eq_3_1.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_2.proved : GbtDevelopable.Section_3_1.eq_3_2.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_2.met : GbtDevelopable.Section_3_1.eq_3_2.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_3.proved : GbtDevelopable.Section_3_1.eq_3_3.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_3.met : GbtDevelopable.Section_3_1.eq_3_3.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_4.proved : GbtDevelopable.Section_3_1.eq_3_4.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_4.met : GbtDevelopable.Section_3_1.eq_3_4.instance).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_5.proved : GbtDevelopable.Section_3_2.eq_3_5.statement).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_5.met : GbtDevelopable.Section_3_2.eq_3_5.instance).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_6.proved : GbtDevelopable.Section_3_2.eq_3_6.statement).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_6.met : GbtDevelopable.Section_3_2.eq_3_6.instance).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_phi.proved : GbtDevelopable.Section_3_2.sec_3_2_phi.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.proved : GbtDevelopable.Section_3_2.sec_3_2_theta.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.met : GbtDevelopable.Section_3_2.sec_3_2_theta.instance).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_phi_exp.proved : GbtDevelopable.Section_3_2.sec_3_2_phi_exp.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_vec.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.met : GbtDevelopable.Section_3_2.sec_3_2_psi_vec.instance).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_nearest.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.met : GbtDevelopable.Section_3_2.sec_3_2_psi_nearest.instance).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_x.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_x.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_y.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_y.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z.refuted : ~ GbtDevelopable.Section_3_2.sec_3_2_psi_z.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z_corrected.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_z_corrected.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_den.proved : GbtDevelopable.Section_3_2.sec_3_2_psi_den.statement).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_7.proved : GbtDevelopable.Section_3_2.eq_3_7.statement).
Check (GbtDevelopable.Section_3_2_proofs.eq_3_7.met : GbtDevelopable.Section_3_2.eq_3_7.instance).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.proved : GbtDevelopable.Section_3_2.sec_3_2_envelope.statement).
Check (GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.met : GbtDevelopable.Section_3_2.sec_3_2_envelope.instance).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_8.proved : GbtDevelopable.Section_3_3.eq_3_8.statement).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_8.met : GbtDevelopable.Section_3_3.eq_3_8.instance).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_9.proved : GbtDevelopable.Section_3_3.eq_3_9.statement).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_9.met : GbtDevelopable.Section_3_3.eq_3_9.instance).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec.refuted : ~ GbtDevelopable.Section_3_3.sec_3_3_S_vec.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.proved : GbtDevelopable.Section_3_3.sec_3_3_S_vec_corrected.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.met : GbtDevelopable.Section_3_3.sec_3_3_S_vec_corrected.instance).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_x.proved : GbtDevelopable.Section_3_3.sec_3_3_S_x.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_y.proved : GbtDevelopable.Section_3_3.sec_3_3_S_y.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_z.proved : GbtDevelopable.Section_3_3.sec_3_3_S_z.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_den.proved : GbtDevelopable.Section_3_3.sec_3_3_S_den.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.proved : GbtDevelopable.Section_3_3.sec_3_3_regression.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.met : GbtDevelopable.Section_3_3.sec_3_3_regression.instance).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.proved : GbtDevelopable.Section_3_3.sec_3_3_regression_velocity.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.met : GbtDevelopable.Section_3_3.sec_3_3_regression_velocity.instance).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.proved : GbtDevelopable.Section_3_3.sec_3_3_regression_quadratic.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.met : GbtDevelopable.Section_3_3.sec_3_3_regression_quadratic.instance).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_10.proved : GbtDevelopable.Section_3_3.eq_3_10.statement).
Check (GbtDevelopable.Section_3_3_proofs.eq_3_10.met : GbtDevelopable.Section_3_3.eq_3_10.instance).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.proved : GbtDevelopable.Section_3_3.sec_3_3_developable.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.met : GbtDevelopable.Section_3_3.sec_3_3_developable.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_a.proved : GbtDevelopable.Section_3_4.eq_3_11_a.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_a.met : GbtDevelopable.Section_3_4.eq_3_11_a.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_b.proved : GbtDevelopable.Section_3_4.eq_3_11_b.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_b.met : GbtDevelopable.Section_3_4.eq_3_11_b.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_c.proved : GbtDevelopable.Section_3_4.eq_3_11_c.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_11_c.met : GbtDevelopable.Section_3_4.eq_3_11_c.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_a.proved : GbtDevelopable.Section_3_4.eq_3_12_a.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_a.met : GbtDevelopable.Section_3_4.eq_3_12_a.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_b.proved : GbtDevelopable.Section_3_4.eq_3_12_b.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_b.met : GbtDevelopable.Section_3_4.eq_3_12_b.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_c.proved : GbtDevelopable.Section_3_4.eq_3_12_c.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_12_c.met : GbtDevelopable.Section_3_4.eq_3_12_c.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.proved : GbtDevelopable.Section_3_4.sec_3_4_tangent_ends.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.met : GbtDevelopable.Section_3_4.sec_3_4_tangent_ends.instance).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_13.proved : GbtDevelopable.Section_3_4.eq_3_13.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_13.met : GbtDevelopable.Section_3_4.eq_3_13.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.proved : GbtDevelopable.Section_3_4.sec_3_4_J0.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.met : GbtDevelopable.Section_3_4.sec_3_4_J0.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.proved : GbtDevelopable.Section_3_4.sec_3_4_dual.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.met : GbtDevelopable.Section_3_4.sec_3_4_dual.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.proved : GbtDevelopable.Section_3_4.sec_3_4_J1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.met : GbtDevelopable.Section_3_4.sec_3_4_J1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.proved : GbtDevelopable.Section_3_4.sec_3_4_k1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.met : GbtDevelopable.Section_3_4.sec_3_4_k1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.proved : GbtDevelopable.Section_3_4.sec_3_4_k2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.met : GbtDevelopable.Section_3_4.sec_3_4_k2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2.refuted : ~ GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2_corrected.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c2_corrected.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3.refuted : ~ GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3_corrected.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_c3_corrected.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2.refuted : ~ GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2_corrected.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c2_corrected.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c3.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_c3.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.proved : GbtDevelopable.Section_3_4.sec_3_4_S0.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.met : GbtDevelopable.Section_3_4.sec_3_4_S0.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.proved : GbtDevelopable.Section_3_4.sec_3_4_S0_gen.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.met : GbtDevelopable.Section_3_4.sec_3_4_S0_gen.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.proved : GbtDevelopable.Section_3_4.sec_3_4_S1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.met : GbtDevelopable.Section_3_4.sec_3_4_S1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.proved : GbtDevelopable.Section_3_4.sec_3_4_S1_gen.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.met : GbtDevelopable.Section_3_4.sec_3_4_S1_gen.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.proved : GbtDevelopable.Section_4_1.ex_4_1_Q0.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.met : GbtDevelopable.Section_4_1.ex_4_1_Q0.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.proved : GbtDevelopable.Section_4_1.ex_4_1_Q1.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.met : GbtDevelopable.Section_4_1.ex_4_1_Q1.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.proved : GbtDevelopable.Section_4_1.ex_4_1_Q2.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.met : GbtDevelopable.Section_4_1.ex_4_1_Q2.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.proved : GbtDevelopable.Section_4_1.ex_4_1_Q3.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.met : GbtDevelopable.Section_4_1.ex_4_1_Q3.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.proved : GbtDevelopable.Section_4_1.ex_4_1_distance.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.met : GbtDevelopable.Section_4_1.ex_4_1_distance.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.proved : GbtDevelopable.Section_4_1.ex_4_1_coplanar.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.met : GbtDevelopable.Section_4_1.ex_4_1_coplanar.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.proved : GbtDevelopable.Section_4_1.ex_4_1_c1_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.met : GbtDevelopable.Section_4_1.ex_4_1_c1_a.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.proved : GbtDevelopable.Section_4_1.ex_4_1_lengths.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.met : GbtDevelopable.Section_4_1.ex_4_1_lengths.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.proved : GbtDevelopable.Section_4_1.ex_4_1_lengths_exchanged.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.met : GbtDevelopable.Section_4_1.ex_4_1_lengths_exchanged.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.proved : GbtDevelopable.Section_4_1.ex_4_1_c1_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.met : GbtDevelopable.Section_4_1.ex_4_1_c1_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_c.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_e.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_e.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_f_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.proved : GbtDevelopable.Section_4_1.ex_4_1_c2_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.met : GbtDevelopable.Section_4_1.ex_4_1_c2_a.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.proved : GbtDevelopable.Section_4_1.ex_4_1_c2_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.met : GbtDevelopable.Section_4_1.ex_4_1_c2_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_c.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c2_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c2_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c2_e_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_a.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c3_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.proved : GbtDevelopable.Section_4_1.ex_4_1_c3_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.met : GbtDevelopable.Section_4_1.ex_4_1_c3_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.proved : GbtDevelopable.Section_4_1.ex_4_1_c3_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.met : GbtDevelopable.Section_4_1.ex_4_1_c3_c.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.proved : GbtDevelopable.Section_4_1.ex_4_1_c3_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.met : GbtDevelopable.Section_4_1.ex_4_1_c3_d.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.proved : GbtDevelopable.Section_4_1.ex_4_2_Q0.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.met : GbtDevelopable.Section_4_1.ex_4_2_Q0.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.proved : GbtDevelopable.Section_4_1.ex_4_2_Q1.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.met : GbtDevelopable.Section_4_1.ex_4_2_Q1.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.proved : GbtDevelopable.Section_4_1.ex_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.met : GbtDevelopable.Section_4_1.ex_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.proved : GbtDevelopable.Section_4_1.ex_4_2_Q3.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.met : GbtDevelopable.Section_4_1.ex_4_2_Q3.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_class.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_class.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.proved : GbtDevelopable.Section_4_1.ex_4_2_pencil.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.met : GbtDevelopable.Section_4_1.ex_4_2_pencil.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.proved : GbtDevelopable.Section_4_1.ex_4_2_lengths.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.met : GbtDevelopable.Section_4_1.ex_4_2_lengths.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_a.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c1_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.proved : GbtDevelopable.Section_4_1.ex_4_2_c1_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.met : GbtDevelopable.Section_4_1.ex_4_2_c1_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.proved : GbtDevelopable.Section_4_1.ex_4_2_c1_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.met : GbtDevelopable.Section_4_1.ex_4_2_c1_c.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c1_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_e.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c1_e.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_a.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c2_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.proved : GbtDevelopable.Section_4_1.ex_4_2_c2_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.met : GbtDevelopable.Section_4_1.ex_4_2_c2_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.proved : GbtDevelopable.Section_4_1.ex_4_2_c2_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.met : GbtDevelopable.Section_4_1.ex_4_2_c2_c.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.proved : GbtDevelopable.Section_4_1.ex_4_2_c2_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.met : GbtDevelopable.Section_4_1.ex_4_2_c2_d.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.proved : GbtDevelopable.Section_4_1.ex_4_2_c3_a.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.met : GbtDevelopable.Section_4_1.ex_4_2_c3_a.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.proved : GbtDevelopable.Section_4_1.ex_4_2_c3_b.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.met : GbtDevelopable.Section_4_1.ex_4_2_c3_b.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.proved : GbtDevelopable.Section_4_1.ex_4_2_c3_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.met : GbtDevelopable.Section_4_1.ex_4_2_c3_c.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c3_d.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.proved : GbtDevelopable.Section_4_2.sec_4_2_Q0.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.met : GbtDevelopable.Section_4_2.sec_4_2_Q0.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.proved : GbtDevelopable.Section_4_2.sec_4_2_Q1.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.met : GbtDevelopable.Section_4_2.sec_4_2_Q1.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1_lengths.proved : GbtDevelopable.Section_4_2.sec_4_2_Q1_lengths.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.proved : GbtDevelopable.Section_4_2.sec_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.met : GbtDevelopable.Section_4_2.sec_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.proved : GbtDevelopable.Section_4_2.sec_4_2_Q3.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.met : GbtDevelopable.Section_4_2.sec_4_2_Q3.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.proved : GbtDevelopable.Section_4_2.sec_4_2_quadrants.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.met : GbtDevelopable.Section_4_2.sec_4_2_quadrants.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.proved : GbtDevelopable.Section_4_2.sec_4_2_distances.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.met : GbtDevelopable.Section_4_2.sec_4_2_distances.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_class.proved : GbtDevelopable.Section_4_2.sec_4_2_class.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_class.met : GbtDevelopable.Section_4_2.sec_4_2_class.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.proved : GbtDevelopable.Section_4_2.sec_4_2_class_ends.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.met : GbtDevelopable.Section_4_2.sec_4_2_class_ends.instance).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved : GbtDevelopable.Section_4.sec_4_midpoints.statement).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.met : GbtDevelopable.Section_4.sec_4_midpoints.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved : GbtDevelopable.Section_4.ex_4_2_distance.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.met : GbtDevelopable.Section_4.ex_4_2_distance.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved : GbtDevelopable.Section_4.ex_4_2_coplanar.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met : GbtDevelopable.Section_4.ex_4_2_coplanar.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_3_a.proved : GbtDevelopable.Section_5_1.eq_5_3_a.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_3_a.met : GbtDevelopable.Section_5_1.eq_5_3_a.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_3_b.refuted : ~ GbtDevelopable.Section_5_1.eq_5_3_b.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.proved : GbtDevelopable.Section_5_1.eq_5_3_b_corrected.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.met : GbtDevelopable.Section_5_1.eq_5_3_b_corrected.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_4.proved : GbtDevelopable.Section_5_1.eq_5_4.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_4.met : GbtDevelopable.Section_5_1.eq_5_4.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved : GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met : GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted : ~ GbtDevelopable.Section_5_1.eq_5_4_nec_suf_curves_in_space.statement).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.proved : GbtDevelopable.Section_5_1.sec_5_1_certify.statement).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.met : GbtDevelopable.Section_5_1.sec_5_1_certify.instance).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.proved : GbtDevelopable.Section_5_1.sec_5_1_certify_sheets.statement).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.met : GbtDevelopable.Section_5_1.sec_5_1_certify_sheets.instance).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.proved : GbtDevelopable.Section_5_1.sec_5_1_certify_cusp.statement).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.met : GbtDevelopable.Section_5_1.sec_5_1_certify_cusp.instance).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.proved : GbtDevelopable.Section_5_1.sec_5_1_G0_families.statement).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.met : GbtDevelopable.Section_5_1.sec_5_1_G0_families.instance).
Check (GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_surfaces.refuted : ~ GbtDevelopable.Section_5_1.sec_5_1_G0_surfaces.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_a.proved : GbtDevelopable.Section_5_1.thm_2_a.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_a.met : GbtDevelopable.Section_5_1.thm_2_a.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_b.proved : GbtDevelopable.Section_5_1.thm_2_b.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_b.met : GbtDevelopable.Section_5_1.thm_2_b.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.proved : GbtDevelopable.Section_5_1.eq_5_7_requirement.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.met : GbtDevelopable.Section_5_1.eq_5_7_requirement.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_7_equivalence.refuted : ~ GbtDevelopable.Section_5_1.eq_5_7_equivalence.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_8_a.proved : GbtDevelopable.Section_5_1.eq_5_8_a.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_8_a.met : GbtDevelopable.Section_5_1.eq_5_8_a.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_8_b.proved : GbtDevelopable.Section_5_1.eq_5_8_b.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_8_b.met : GbtDevelopable.Section_5_1.eq_5_8_b.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_9.proved : GbtDevelopable.Section_5_1.eq_5_9.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_9.met : GbtDevelopable.Section_5_1.eq_5_9.instance).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_10.proved : GbtDevelopable.Section_5_1.eq_5_10.statement).
Check (GbtDevelopable.Section_5_1_proofs.eq_5_10.met : GbtDevelopable.Section_5_1.eq_5_10.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.proved : GbtDevelopable.Section_5_1.thm_2_sufficient.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.met : GbtDevelopable.Section_5_1.thm_2_sufficient.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.proved : GbtDevelopable.Section_5_1.thm_2_necessary_families.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.met : GbtDevelopable.Section_5_1.thm_2_necessary_families.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_1.thm_2_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.proved : GbtDevelopable.Section_5_1.thm_2_true_necessary.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.met : GbtDevelopable.Section_5_1.thm_2_true_necessary.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.proved : GbtDevelopable.Section_5_1.thm_2_true_sufficient.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.met : GbtDevelopable.Section_5_1.thm_2_true_sufficient.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.proved : GbtDevelopable.Section_5_1.thm_2_true_generator.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.met : GbtDevelopable.Section_5_1.thm_2_true_generator.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.proved : GbtDevelopable.Section_5_1.thm_2_true_sheets.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.met : GbtDevelopable.Section_5_1.thm_2_true_sheets.instance).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_11.proved : GbtDevelopable.Section_5_2.eq_5_11.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_11.met : GbtDevelopable.Section_5_2.eq_5_11.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.proved : GbtDevelopable.Section_5_2.sec_5_2_meaning.statement).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.met : GbtDevelopable.Section_5_2.sec_5_2_meaning.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_index.refuted : ~ GbtDevelopable.Section_5_2.sec_5_2_index.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_consts.proved : GbtDevelopable.Section_5_2.thm_3_consts.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_consts.met : GbtDevelopable.Section_5_2.thm_3_consts.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_a.proved : GbtDevelopable.Section_5_2.thm_3_a.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_a.met : GbtDevelopable.Section_5_2.thm_3_a.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_b.proved : GbtDevelopable.Section_5_2.thm_3_b.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_b.met : GbtDevelopable.Section_5_2.thm_3_b.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_c.proved : GbtDevelopable.Section_5_2.thm_3_c.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_c.met : GbtDevelopable.Section_5_2.thm_3_c.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.proved : GbtDevelopable.Section_5_2.thm_3_sufficient.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.met : GbtDevelopable.Section_5_2.thm_3_sufficient.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.proved : GbtDevelopable.Section_5_2.thm_3_necessary_families.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.met : GbtDevelopable.Section_5_2.thm_3_necessary_families.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_2.thm_3_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_13.proved : GbtDevelopable.Section_5_2.eq_5_13.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_13.met : GbtDevelopable.Section_5_2.eq_5_13.instance).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_15.proved : GbtDevelopable.Section_5_2.eq_5_15.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_15.met : GbtDevelopable.Section_5_2.eq_5_15.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_numbered.refuted : ~ GbtDevelopable.Section_5_2.thm_3_proofref_as_numbered.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_meant.proved : GbtDevelopable.Section_5_2.thm_3_proofref_as_meant.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_meant.met : GbtDevelopable.Section_5_2.thm_3_proofref_as_meant.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_consts.proved : GbtDevelopable.Section_5_3.thm_4_consts.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_consts.met : GbtDevelopable.Section_5_3.thm_4_consts.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_a.proved : GbtDevelopable.Section_5_3.thm_4_a.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_a.met : GbtDevelopable.Section_5_3.thm_4_a.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_b.proved : GbtDevelopable.Section_5_3.thm_4_b.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_b.met : GbtDevelopable.Section_5_3.thm_4_b.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_c.refuted : ~ GbtDevelopable.Section_5_3.thm_4_c.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.proved : GbtDevelopable.Section_5_3.thm_4_c_corrected.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.met : GbtDevelopable.Section_5_3.thm_4_c_corrected.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_c_true.proved : GbtDevelopable.Section_5_3.thm_4_c_true.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_c_true.met : GbtDevelopable.Section_5_3.thm_4_c_true.instance).
Check (GbtDevelopable.Section_5_3_proofs.eq_5_17.proved : GbtDevelopable.Section_5_3.eq_5_17.statement).
Check (GbtDevelopable.Section_5_3_proofs.eq_5_17.met : GbtDevelopable.Section_5_3.eq_5_17.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.proved : GbtDevelopable.Section_5_3.thm_4_sufficient.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.met : GbtDevelopable.Section_5_3.thm_4_sufficient.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.proved : GbtDevelopable.Section_5_3.thm_4_necessary_families.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.met : GbtDevelopable.Section_5_3.thm_4_necessary_families.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_3.thm_4_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.proved : GbtDevelopable.Section_5_3.thm_4_true_necessary.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.met : GbtDevelopable.Section_5_3.thm_4_true_necessary.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.proved : GbtDevelopable.Section_5_3.thm_4_true_sufficient.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.met : GbtDevelopable.Section_5_3.thm_4_true_sufficient.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.proved : GbtDevelopable.Section_5_3.thm_4_true_sheets.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.met : GbtDevelopable.Section_5_3.thm_4_true_sheets.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.proved : GbtDevelopable.Section_5_3.thm_4_true_curvature.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.met : GbtDevelopable.Section_5_3.thm_4_true_curvature.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.proved : GbtDevelopable.Section_5_4.alg_5_4_s1.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.met : GbtDevelopable.Section_5_4.alg_5_4_s1.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.proved : GbtDevelopable.Section_5_4.alg_5_4_s2_families.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.met : GbtDevelopable.Section_5_4.alg_5_4_s2_families.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_surfaces.refuted : ~ GbtDevelopable.Section_5_4.alg_5_4_s2_surfaces.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.proved : GbtDevelopable.Section_5_4.alg_5_4_s3.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.met : GbtDevelopable.Section_5_4.alg_5_4_s3.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.proved : GbtDevelopable.Section_5_4.alg_5_4_s4.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.met : GbtDevelopable.Section_5_4.alg_5_4_s4.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.proved : GbtDevelopable.Section_5_4.alg_5_4_s5.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.met : GbtDevelopable.Section_5_4.alg_5_4_s5.instance).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.proved : GbtDevelopable.Section_5_4.alg_5_4_iterate.statement).
Check (GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.met : GbtDevelopable.Section_5_4.alg_5_4_iterate.instance).
Check (GbtDevelopable.Section_5_5_proofs.eq_5_18.proved : GbtDevelopable.Section_5_5.eq_5_18.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.proved : GbtDevelopable.Section_5_5.ex_5_1_construct.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.met : GbtDevelopable.Section_5_5.ex_5_1_construct.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.proved : GbtDevelopable.Section_5_5.ex_5_1_shape_shape.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.met : GbtDevelopable.Section_5_5.ex_5_1_shape_shape.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_combined_surface.refuted : ~ GbtDevelopable.Section_5_5.ex_5_1_shape_combined_surface.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.proved : GbtDevelopable.Section_5_5.ex_5_2_Q02.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.met : GbtDevelopable.Section_5_5.ex_5_2_Q02.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.proved : GbtDevelopable.Section_5_5.ex_5_2_Q12.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.met : GbtDevelopable.Section_5_5.ex_5_2_Q12.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.proved : GbtDevelopable.Section_5_5.ex_5_2_Q22.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.met : GbtDevelopable.Section_5_5.ex_5_2_Q22.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.proved : GbtDevelopable.Section_5_5.ex_5_2_gamma_one.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.met : GbtDevelopable.Section_5_5.ex_5_2_gamma_one.instance).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_surfaces.refuted : ~ GbtDevelopable.Section_5_5.ex_5_2_gap_surfaces.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.proved : GbtDevelopable.Section_5_5.ex_5_2_gap_drawn_pieces.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.met : GbtDevelopable.Section_5_5.ex_5_2_gap_drawn_pieces.instance).
Check (GbtDevelopable.Section_5_proofs.eq_5_1.proved : GbtDevelopable.Section_5.eq_5_1.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_1.met : GbtDevelopable.Section_5.eq_5_1.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_a.proved : GbtDevelopable.Section_5.sec_5_weighted_a.statement).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_a.met : GbtDevelopable.Section_5.sec_5_weighted_a.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.proved : GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.statement).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.met : GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_after_division.refuted : ~ GbtDevelopable.Section_5.sec_5_weighted_b_after_division.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_2.proved : GbtDevelopable.Section_5.eq_5_2.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_2.met : GbtDevelopable.Section_5.eq_5_2.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_a.proved : GbtSurfaces.Part_Abstract.abs_basis_a.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_a.met : GbtSurfaces.Part_Abstract.abs_basis_a.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_b.refuted : ~ GbtSurfaces.Part_Abstract.abs_basis_b.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved : GbtSurfaces.Part_Abstract.abs_basis_order_2.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met : GbtSurfaces.Part_Abstract.abs_basis_order_2.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved : GbtSurfaces.Part_Abstract.abs_basis_cubic.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met : GbtSurfaces.Part_Abstract.abs_basis_cubic.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_all.proved : GbtSurfaces.Part_Abstract.abs_basis_all.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_all.met : GbtSurfaces.Part_Abstract.abs_basis_all.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.proved : GbtSurfaces.Part_Abstract.abs_continuity_a.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.met : GbtSurfaces.Part_Abstract.abs_continuity_a.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.proved : GbtSurfaces.Part_Abstract.abs_continuity_rows.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.met : GbtSurfaces.Part_Abstract.abs_continuity_rows.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.proved : GbtSurfaces.Part_Table.tab_1_1_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.met : GbtSurfaces.Part_Table.tab_1_1_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.proved : GbtSurfaces.Part_Table.tab_1_2_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.met : GbtSurfaces.Part_Table.tab_1_2_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.proved : GbtSurfaces.Part_Table.tab_1_3_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.met : GbtSurfaces.Part_Table.tab_1_3_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.proved : GbtSurfaces.Part_Table.tab_1_4_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.met : GbtSurfaces.Part_Table.tab_1_4_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.proved : GbtSurfaces.Part_Table.tab_1_5_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.met : GbtSurfaces.Part_Table.tab_1_5_proposed.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_1.proved : GbtSurfaces.Section_1.sec_1_contrib_1.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_1.met : GbtSurfaces.Section_1.sec_1_contrib_1.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_2.proved : GbtSurfaces.Section_1.sec_1_contrib_2.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_2.met : GbtSurfaces.Section_1.sec_1_contrib_2.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_1.sec_1_contrib_3_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved : GbtSurfaces.Section_1.sec_1_contrib_3_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met : GbtSurfaces.Section_1.sec_1_contrib_3_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved : GbtSurfaces.Section_2_1.eq_1_f0.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.met : GbtSurfaces.Section_2_1.eq_1_f0.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved : GbtSurfaces.Section_2_1.eq_1_f1.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.met : GbtSurfaces.Section_2_1.eq_1_f1.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved : GbtSurfaces.Section_2_1.eq_1_f2.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.met : GbtSurfaces.Section_2_1.eq_1_f2.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_2.proved : GbtSurfaces.Section_2_1.eq_2.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2.met : GbtSurfaces.Section_2_1.eq_2.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_literal.refuted : ~ GbtSurfaces.Section_2_1.eq_2_zero_literal.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.proved : GbtSurfaces.Section_2_1.eq_2_zero_n_is_the_order.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.met : GbtSurfaces.Section_2_1.eq_2_zero_n_is_the_order.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.proved : GbtSurfaces.Section_2_1.thm_1_1_formal.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.met : GbtSurfaces.Section_2_1.thm_1_1_formal.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted : ~ GbtSurfaces.Section_2_1.thm_1_1_as_functions.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved : GbtSurfaces.Section_2_1.thm_1_1_true.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met : GbtSurfaces.Section_2_1.thm_1_1_true.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.proved : GbtSurfaces.Section_2_1.thm_1_1_blend.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.met : GbtSurfaces.Section_2_1.thm_1_1_blend.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_Definition_1.refuted : ~ GbtSurfaces.Section_2_1.thm_1_2_Definition_1.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved : GbtSurfaces.Section_2_1.thm_1_2_where_curves_are_defined.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.met : GbtSurfaces.Section_2_1.thm_1_2_where_curves_are_defined.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.proved : GbtSurfaces.Section_2_1.thm_1_3.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.met : GbtSurfaces.Section_2_1.thm_1_3.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.proved : GbtSurfaces.Section_2_1.thm_1_4.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.met : GbtSurfaces.Section_2_1.thm_1_4.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d1_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d1_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d2_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d2_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d2_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d2_1_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d3_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d3_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d3_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d3_1_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_one_letter.refuted : ~ GbtSurfaces.Section_2_2.def_2_points_one_letter.statement).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.proved : GbtSurfaces.Section_2_2.def_2_points_two_letters.statement).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.met : GbtSurfaces.Section_2_2.def_2_points_two_letters.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_3.proved : GbtSurfaces.Section_2_2.eq_3.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_3.met : GbtSurfaces.Section_2_2.eq_3.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved : GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met : GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved : GbtSurfaces.Section_2_2.sec_2_2_symmetry_parameters_exchanged.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met : GbtSurfaces.Section_2_2.sec_2_2_symmetry_parameters_exchanged.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.proved : GbtSurfaces.Section_2_2.sec_2_2_convex_hull.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.met : GbtSurfaces.Section_2_2.sec_2_2_convex_hull.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved : GbtSurfaces.Section_2_2.sec_2_2_variation_diminishing_order_2.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met : GbtSurfaces.Section_2_2.sec_2_2_variation_diminishing_order_2.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.proved : GbtSurfaces.Section_2_2.sec_2_2_invariance.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.met : GbtSurfaces.Section_2_2.sec_2_2_invariance.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.proved : GbtSurfaces.Section_2_2.sec_2_2_shape_adjustable.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.met : GbtSurfaces.Section_2_2.sec_2_2_shape_adjustable.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.proved : GbtSurfaces.Section_2_2.sec_2_2_terminal_0_values.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.met : GbtSurfaces.Section_2_2.sec_2_2_terminal_0_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.proved : GbtSurfaces.Section_2_2.sec_2_2_terminal_1_values.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.met : GbtSurfaces.Section_2_2.sec_2_2_terminal_1_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved : GbtSurfaces.Section_2_2.sec_2_2_interpolation.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met : GbtSurfaces.Section_2_2.sec_2_2_interpolation.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.proved : GbtSurfaces.Section_2_2.sec_2_2_end_derivatives.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.met : GbtSurfaces.Section_2_2.sec_2_2_end_derivatives.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_setting.proved : GbtSurfaces.Section_2_2.thm_2_setting.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_setting.met : GbtSurfaces.Section_2_2.thm_2_setting.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.proved : GbtSurfaces.Section_2_2.thm_2_1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.met : GbtSurfaces.Section_2_2.thm_2_1.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved : GbtSurfaces.Section_2_2.eq_4_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met : GbtSurfaces.Section_2_2.eq_4_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_2.proved : GbtSurfaces.Section_2_2.thm_2_2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_2.met : GbtSurfaces.Section_2_2.thm_2_2.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted : ~ GbtSurfaces.Section_2_2.eq_5_Q12.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.proved : GbtSurfaces.Section_2_2.eq_5_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.met : GbtSurfaces.Section_2_2.eq_5_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.proved : GbtSurfaces.Section_2_2.eq_5_Q12_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.met : GbtSurfaces.Section_2_2.eq_5_Q12_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_a.refuted : ~ GbtSurfaces.Section_2_2.thm_2_3_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_b.refuted : ~ GbtSurfaces.Section_2_2.thm_2_3_b.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_true.proved : GbtSurfaces.Section_2_2.thm_2_3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_true.met : GbtSurfaces.Section_2_2.thm_2_3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.proved : GbtSurfaces.Section_2_2.thm_2_3_iff.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.met : GbtSurfaces.Section_2_2.thm_2_3_iff.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.proved : GbtSurfaces.Section_2_2.thm_2_3_necessary.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.met : GbtSurfaces.Section_2_2.thm_2_3_necessary.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.proved : GbtSurfaces.Section_2_2.thm_2_3_sufficient.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.met : GbtSurfaces.Section_2_2.thm_2_3_sufficient.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.proved : GbtSurfaces.Section_2_2.thm_2_3_jump.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.met : GbtSurfaces.Section_2_2.thm_2_3_jump.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_when.proved : GbtSurfaces.Section_2_2.thm_2_3_when.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_when.met : GbtSurfaces.Section_2_2.thm_2_3_when.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved : GbtSurfaces.Section_2_2.eq_6_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met : GbtSurfaces.Section_2_2.eq_6_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12.refuted : ~ GbtSurfaces.Section_2_2.eq_6_Q12.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.proved : GbtSurfaces.Section_2_2.eq_6_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.met : GbtSurfaces.Section_2_2.eq_6_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13.refuted : ~ GbtSurfaces.Section_2_2.eq_6_Q13.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.proved : GbtSurfaces.Section_2_2.eq_6_Q13_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.met : GbtSurfaces.Section_2_2.eq_6_Q13_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_a.refuted : ~ GbtSurfaces.Section_2_2.thm_2_4_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_b.refuted : ~ GbtSurfaces.Section_2_2.thm_2_4_b.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_true.proved : GbtSurfaces.Section_2_2.thm_2_4_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_true.met : GbtSurfaces.Section_2_2.thm_2_4_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.proved : GbtSurfaces.Section_2_2.thm_2_4_iff.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.met : GbtSurfaces.Section_2_2.thm_2_4_iff.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.proved : GbtSurfaces.Section_2_2.thm_2_4_necessary.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.met : GbtSurfaces.Section_2_2.thm_2_4_necessary.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.proved : GbtSurfaces.Section_2_2.thm_2_4_sufficient.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.met : GbtSurfaces.Section_2_2.thm_2_4_sufficient.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.proved : GbtSurfaces.Section_2_2.thm_2_4_sufficient_quintic.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.met : GbtSurfaces.Section_2_2.thm_2_4_sufficient_quintic.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.proved : GbtSurfaces.Section_2_2.thm_2_4_cubic.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.met : GbtSurfaces.Section_2_2.thm_2_4_cubic.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a.proved : GbtSurfaces.Section_2_2.thm_2_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a.met : GbtSurfaces.Section_2_2.thm_2_a.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1.proved : GbtSurfaces.Section_2_2.thm_2_a1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1.met : GbtSurfaces.Section_2_2.thm_2_a1.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.proved : GbtSurfaces.Section_2_2.thm_2_a1_sign.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.met : GbtSurfaces.Section_2_2.thm_2_a1_sign.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a2.proved : GbtSurfaces.Section_2_2.thm_2_a2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a2.met : GbtSurfaces.Section_2_2.thm_2_a2.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3.refuted : ~ GbtSurfaces.Section_2_2.thm_2_a3.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.proved : GbtSurfaces.Section_2_2.thm_2_a3_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.met : GbtSurfaces.Section_2_2.thm_2_a3_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.proved : GbtSurfaces.Section_2_2.thm_2_a3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.met : GbtSurfaces.Section_2_2.thm_2_a3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1.proved : GbtSurfaces.Section_2_2.thm_2_b1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1.met : GbtSurfaces.Section_2_2.thm_2_b1.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.proved : GbtSurfaces.Section_2_2.thm_2_b1_sign.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.met : GbtSurfaces.Section_2_2.thm_2_b1_sign.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.proved : GbtSurfaces.Section_2_2.thm_2_b2_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.met : GbtSurfaces.Section_2_2.thm_2_b2_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b3.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.proved : GbtSurfaces.Section_2_2.thm_2_b3_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.met : GbtSurfaces.Section_2_2.thm_2_b3_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.proved : GbtSurfaces.Section_2_2.thm_2_b3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.met : GbtSurfaces.Section_2_2.thm_2_b3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b4.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.proved : GbtSurfaces.Section_2_2.thm_2_b4_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.met : GbtSurfaces.Section_2_2.thm_2_b4_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.proved : GbtSurfaces.Section_2_2.thm_2_b4_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.met : GbtSurfaces.Section_2_2.thm_2_b4_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved : GbtSurfaces.Section_2_2.thm_2_c1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.met : GbtSurfaces.Section_2_2.thm_2_c1.instance).
Check (GbtSurfaces.Section_2_3_proofs.eq_7.proved : GbtSurfaces.Section_2_3.eq_7.statement).
Check (GbtSurfaces.Section_2_3_proofs.eq_7.met : GbtSurfaces.Section_2_3.eq_7.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.proved : GbtSurfaces.Section_2_3.sec_2_3_features_a.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.met : GbtSurfaces.Section_2_3.sec_2_3_features_a.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.proved : GbtSurfaces.Section_2_3.sec_2_3_features_b.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.met : GbtSurfaces.Section_2_3.sec_2_3_features_b.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.proved : GbtSurfaces.Section_2_3.sec_2_3_features_c.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.met : GbtSurfaces.Section_2_3.sec_2_3_features_c.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.proved : GbtSurfaces.Section_2_3.sec_2_3_features_d.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.met : GbtSurfaces.Section_2_3.sec_2_3_features_d.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met : GbtSurfaces.Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted : ~ GbtSurfaces.Section_2_3.sec_2_3_classical_every_property.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_i.proved : GbtSurfaces.Section_3_1.sec_3_1_i.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_i.met : GbtSurfaces.Section_3_1.sec_3_1_i.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_1.proved : GbtSurfaces.Section_3_1.eq_8_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_1.met : GbtSurfaces.Section_3_1.eq_8_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_2.proved : GbtSurfaces.Section_3_1.eq_8_2.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_2.met : GbtSurfaces.Section_3_1.eq_8_2.instance).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1.proved : GbtSurfaces.Section_3_1.prop_3_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1.met : GbtSurfaces.Section_3_1.prop_3_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.proved : GbtSurfaces.Section_3_1.sec_3_1_translating.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.met : GbtSurfaces.Section_3_1.sec_3_1_translating.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted : ~ GbtSurfaces.Section_3_1.sec_3_1_not_tensor_literal.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved : GbtSurfaces.Section_3_1.sec_3_1_not_tensor_as_it_stands.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met : GbtSurfaces.Section_3_1.sec_3_1_not_tensor_as_it_stands.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.proved : GbtSurfaces.Section_3_1.sec_3_1_order_one_missing_none.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.met : GbtSurfaces.Section_3_1.sec_3_1_order_one_missing_none.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.proved : GbtSurfaces.Section_3_1.eq_10.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.met : GbtSurfaces.Section_3_1.eq_10.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved : GbtSurfaces.Section_3_1.eq_10_bernstein.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met : GbtSurfaces.Section_3_1.eq_10_bernstein.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved : GbtSurfaces.Section_3_1.eq_10_extending.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.met : GbtSurfaces.Section_3_1.eq_10_extending.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11.refuted : ~ GbtSurfaces.Section_3_1.eq_11.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_corrected.proved : GbtSurfaces.Section_3_1.eq_11_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_corrected.met : GbtSurfaces.Section_3_1.eq_11_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted : ~ GbtSurfaces.Section_3_1.eq_11_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.proved : GbtSurfaces.Section_3_1.eq_11_points_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.met : GbtSurfaces.Section_3_1.eq_11_points_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_parameters.proved : GbtSurfaces.Section_3_1.eq_11_parameters.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_parameters.met : GbtSurfaces.Section_3_1.eq_11_parameters.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted : ~ GbtSurfaces.Section_3_1.eq_12_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.proved : GbtSurfaces.Section_3_1.eq_12_1_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.met : GbtSurfaces.Section_3_1.eq_12_1_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_2.proved : GbtSurfaces.Section_3_1.eq_12_2.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_2.met : GbtSurfaces.Section_3_1.eq_12_2.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_3.proved : GbtSurfaces.Section_3_1.eq_12_3.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_3.met : GbtSurfaces.Section_3_1.eq_12_3.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_4.proved : GbtSurfaces.Section_3_1.eq_12_4.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_4.met : GbtSurfaces.Section_3_1.eq_12_4.instance).
Check (GbtSurfaces.Section_3_1_proofs.thm_3.proved : GbtSurfaces.Section_3_1.thm_3.statement).
Check (GbtSurfaces.Section_3_1_proofs.thm_3.met : GbtSurfaces.Section_3_1.thm_3.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.proved : GbtSurfaces.Section_3_1.sec_3_1_benefits.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.met : GbtSurfaces.Section_3_1.sec_3_1_benefits.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted : ~ GbtSurfaces.Section_3_1.sec_3_1_any_shape_literal.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved : GbtSurfaces.Section_3_1.sec_3_1_any_shape_the_shape_changes.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met : GbtSurfaces.Section_3_1.sec_3_1_any_shape_the_shape_changes.instance).
Check (GbtSurfaces.Section_3_1_proofs.alg_1.proved : GbtSurfaces.Section_3_1.alg_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.alg_1.met : GbtSurfaces.Section_3_1.alg_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved : GbtSurfaces.Section_3_1.ex_3_1_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_normal.proved : GbtSurfaces.Section_3_1.ex_3_1_normal.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_13.proved : GbtSurfaces.Section_3_1.eq_13.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_13.met : GbtSurfaces.Section_3_1.eq_13.instance).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved : GbtSurfaces.Section_3_1.ex_3_1_net.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved : GbtSurfaces.Section_3_1.ex_3_1_mesh_count.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.proved : GbtSurfaces.Section_3_1.ex_3_1_hull.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.met : GbtSurfaces.Section_3_1.ex_3_1_hull.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.proved : GbtSurfaces.Section_3_1.sec_3_1_effect.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.met : GbtSurfaces.Section_3_1.sec_3_1_effect.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_14.proved : GbtSurfaces.Section_3_2.eq_14.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_14.met : GbtSurfaces.Section_3_2.eq_14.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved : GbtSurfaces.Section_3_2.sec_3_2_segments.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met : GbtSurfaces.Section_3_2.sec_3_2_segments.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved : GbtSurfaces.Section_3_2.sec_3_2_linear.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met : GbtSurfaces.Section_3_2.sec_3_2_linear.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved : GbtSurfaces.Section_3_2.prop_3_2_a.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met : GbtSurfaces.Section_3_2.prop_3_2_a.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved : GbtSurfaces.Section_3_2.prop_3_2_b.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met : GbtSurfaces.Section_3_2.prop_3_2_b.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved : GbtSurfaces.Section_3_2.prop_3_2_c.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met : GbtSurfaces.Section_3_2.prop_3_2_c.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_15.proved : GbtSurfaces.Section_3_2.eq_15.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_15.met : GbtSurfaces.Section_3_2.eq_15.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved : GbtSurfaces.Section_3_2.sec_3_2_fixed.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met : GbtSurfaces.Section_3_2.sec_3_2_fixed.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.proved : GbtSurfaces.Section_3_2.sec_3_2_list_1.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.met : GbtSurfaces.Section_3_2.sec_3_2_list_1.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.proved : GbtSurfaces.Section_3_2.sec_3_2_list_2.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.met : GbtSurfaces.Section_3_2.sec_3_2_list_2.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.proved : GbtSurfaces.Section_3_2.sec_3_2_list_3.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.met : GbtSurfaces.Section_3_2.sec_3_2_list_3.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_1.proved : GbtSurfaces.Section_3_2.alg_2_1.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_1.met : GbtSurfaces.Section_3_2.alg_2_1.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2.proved : GbtSurfaces.Section_3_2.alg_2_2.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2.met : GbtSurfaces.Section_3_2.alg_2_2.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.proved : GbtSurfaces.Section_3_2.alg_2_2_irregular.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.met : GbtSurfaces.Section_3_2.alg_2_2_irregular.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_16.proved : GbtSurfaces.Section_3_2.eq_16.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_16.met : GbtSurfaces.Section_3_2.eq_16.instance).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.proved : GbtSurfaces.Section_3_2.ex_3_2_corners.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.met : GbtSurfaces.Section_3_2.ex_3_2_corners.instance).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved : GbtSurfaces.Section_3_2.ex_3_2_division_z_lines.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved : GbtSurfaces.Section_3_2.ex_3_2_division_Q0l.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_division_Q3l.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved : GbtSurfaces.Section_3_2.ex_3_2_division_Q3l_corrected.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_a.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_b.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_c.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d_corrected.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved : GbtSurfaces.Section_3_2.ex_3_2_interior.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_equation.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved : GbtSurfaces.Section_3_2.ex_3_2_sixteen.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved : GbtSurfaces.Section_3_2.ex_3_2_coplanar.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved : GbtSurfaces.Section_3_2.ex_3_2_noncoplanar_possible.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.met : GbtSurfaces.Section_3_2.ex_3_2_noncoplanar_possible.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved : GbtSurfaces.Section_3_3.sec_3_3_generatrix.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met : GbtSurfaces.Section_3_3.sec_3_3_generatrix.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_literal.refuted : ~ GbtSurfaces.Section_3_3.sec_3_3_same_degree_literal.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.proved : GbtSurfaces.Section_3_3.sec_3_3_same_degree_in_general.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.met : GbtSurfaces.Section_3_3.sec_3_3_same_degree_in_general.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.proved : GbtSurfaces.Section_3_3.eq_17_0.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.met : GbtSurfaces.Section_3_3.eq_17_0.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.proved : GbtSurfaces.Section_3_3.eq_17_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.met : GbtSurfaces.Section_3_3.eq_17_1.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.proved : GbtSurfaces.Section_3_3.sec_3_3_condition_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.met : GbtSurfaces.Section_3_3.sec_3_3_condition_1.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_as_printed.refuted : ~ GbtSurfaces.Section_3_3.sec_3_3_condition_2_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.proved : GbtSurfaces.Section_3_3.sec_3_3_condition_2_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.met : GbtSurfaces.Section_3_3.sec_3_3_condition_2_with_f_l.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18.refuted : ~ GbtSurfaces.Section_3_3.eq_18.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved : GbtSurfaces.Section_3_3.eq_18_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met : GbtSurfaces.Section_3_3.eq_18_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_true.proved : GbtSurfaces.Section_3_3.eq_18_true.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_true.met : GbtSurfaces.Section_3_3.eq_18_true.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.proved : GbtSurfaces.Section_3_3.eq_18_sufficient.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.met : GbtSurfaces.Section_3_3.eq_18_sufficient.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved : GbtSurfaces.Section_3_3.eq_18_necessary.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met : GbtSurfaces.Section_3_3.eq_18_necessary.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_defect.proved : GbtSurfaces.Section_3_3.eq_18_defect.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_defect.met : GbtSurfaces.Section_3_3.eq_18_defect.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor_as_printed.proved : GbtSurfaces.Section_3_3.eq_18_tensor_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor_as_printed.met : GbtSurfaces.Section_3_3.eq_18_tensor_as_printed.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor_with_f_l.refuted : ~ GbtSurfaces.Section_3_3.eq_18_tensor_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.proved : GbtSurfaces.Section_3_3.sec_3_3_benefits_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.met : GbtSurfaces.Section_3_3.sec_3_3_benefits_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved : GbtSurfaces.Section_3_3.prop_3_3_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met : GbtSurfaces.Section_3_3.prop_3_3_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_b.proved : GbtSurfaces.Section_3_3.prop_3_3_b.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_b.met : GbtSurfaces.Section_3_3.prop_3_3_b.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_as_printed.proved : GbtSurfaces.Section_3_3.prop_3_4_a_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_as_printed.met : GbtSurfaces.Section_3_3.prop_3_4_a_as_printed.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_with_f_l.refuted : ~ GbtSurfaces.Section_3_3.prop_3_4_a_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.proved : GbtSurfaces.Section_3_3.prop_3_4_a_net.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.met : GbtSurfaces.Section_3_3.prop_3_4_a_net.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_b.proved : GbtSurfaces.Section_3_3.prop_3_4_b.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_b.met : GbtSurfaces.Section_3_3.prop_3_4_b.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed.refuted : ~ GbtSurfaces.Section_3_3.alg_3_a_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.proved : GbtSurfaces.Section_3_3.alg_3_a_as_printed_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.met : GbtSurfaces.Section_3_3.alg_3_a_as_printed_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.proved : GbtSurfaces.Section_3_3.alg_3_a_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.met : GbtSurfaces.Section_3_3.alg_3_a_with_f_l.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_3.alg_3_b_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_b_there_are_such_connections.proved : GbtSurfaces.Section_3_3.alg_3_b_there_are_such_connections.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_b_there_are_such_connections.met : GbtSurfaces.Section_3_3.alg_3_b_there_are_such_connections.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_curves.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_curves_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_curves_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_literal.refuted : ~ GbtSurfaces.Section_3_3.eq_19_literal.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.proved : GbtSurfaces.Section_3_3.eq_19_m_is_4.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.met : GbtSurfaces.Section_3_3.eq_19_m_is_4.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_tensor_as_printed.refuted : ~ GbtSurfaces.Section_3_3.eq_19_tensor_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.proved : GbtSurfaces.Section_3_3.eq_19_tensor_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.met : GbtSurfaces.Section_3_3.eq_19_tensor_with_f_l.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_gl_0.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_gl_0_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_gl_0_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_gl_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_gl_1_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_gl_1_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.proved : GbtSurfaces.Section_3_3.ex_3_3_composite.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.met : GbtSurfaces.Section_3_3.ex_3_3_composite.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_profile.proved : GbtSurfaces.Section_3_4.eq_20_profile.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_profile.met : GbtSurfaces.Section_3_4.eq_20_profile.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted : ~ GbtSurfaces.Section_3_4.eq_20_trajectory.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.proved : GbtSurfaces.Section_3_4.eq_21.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.met : GbtSurfaces.Section_3_4.eq_21.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_22.proved : GbtSurfaces.Section_3_4.eq_22.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_22.met : GbtSurfaces.Section_3_4.eq_22.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.proved : GbtSurfaces.Section_3_4.prop_3_5.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.met : GbtSurfaces.Section_3_4.prop_3_5.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved : GbtSurfaces.Section_3_4.prop_3_6_1.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met : GbtSurfaces.Section_3_4.prop_3_6_1.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved : GbtSurfaces.Section_3_4.prop_3_6_2.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met : GbtSurfaces.Section_3_4.prop_3_6_2.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_23.proved : GbtSurfaces.Section_3_4.eq_23.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_23.met : GbtSurfaces.Section_3_4.eq_23.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted : ~ GbtSurfaces.Section_3_4.thm_4_elements.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved : GbtSurfaces.Section_3_4.thm_4_elements_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met : GbtSurfaces.Section_3_4.thm_4_elements_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_parameters.proved : GbtSurfaces.Section_3_4.thm_4_parameters.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_parameters.met : GbtSurfaces.Section_3_4.thm_4_parameters.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_24.proved : GbtSurfaces.Section_3_4.eq_24.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_24.met : GbtSurfaces.Section_3_4.eq_24.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved : GbtSurfaces.Section_3_4.thm_4_unity.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.met : GbtSurfaces.Section_3_4.thm_4_unity.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_1.proved : GbtSurfaces.Section_3_4.eq_25_1.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_1.met : GbtSurfaces.Section_3_4.eq_25_1.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.proved : GbtSurfaces.Section_3_4.eq_25_2_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.met : GbtSurfaces.Section_3_4.eq_25_2_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.proved : GbtSurfaces.Section_3_4.eq_25_2_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.met : GbtSurfaces.Section_3_4.eq_25_2_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_c.proved : GbtSurfaces.Section_3_4.eq_25_2_c.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_c.met : GbtSurfaces.Section_3_4.eq_25_2_c.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_3.proved : GbtSurfaces.Section_3_4.eq_25_3.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_3.met : GbtSurfaces.Section_3_4.eq_25_3.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.proved : GbtSurfaces.Section_3_4.eq_25_4_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.met : GbtSurfaces.Section_3_4.eq_25_4_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_c.proved : GbtSurfaces.Section_3_4.eq_25_4_c.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_c.met : GbtSurfaces.Section_3_4.eq_25_4_c.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.proved : GbtSurfaces.Section_3_4.sec_3_4_features_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.met : GbtSurfaces.Section_3_4.sec_3_4_features_a.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.proved : GbtSurfaces.Section_3_4.sec_3_4_continuity_pc.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.met : GbtSurfaces.Section_3_4.sec_3_4_continuity_pc.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.proved : GbtSurfaces.Section_3_4.sec_3_4_continuity_tc.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.met : GbtSurfaces.Section_3_4.sec_3_4_continuity_tc.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.proved : GbtSurfaces.Section_3_4.sec_3_4_closed.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.met : GbtSurfaces.Section_3_4.sec_3_4_closed.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met : GbtSurfaces.Section_3_4.sec_3_4_revolution.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_cubic.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_cubic.instance).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_a.proved : GbtSurfaces.Section_3_4.alg_4_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_a.met : GbtSurfaces.Section_3_4.alg_4_a.instance).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_4.alg_4_b_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.proved : GbtSurfaces.Section_3_4.alg_4_b_there_are_such_connections.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.met : GbtSurfaces.Section_3_4.alg_4_b_there_are_such_connections.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_26.proved : GbtSurfaces.Section_3_4.eq_26.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved : GbtSurfaces.Section_3_4.ex_3_4_scaling.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met : GbtSurfaces.Section_3_4.ex_3_4_scaling.instance).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.proved : GbtSurfaces.Section_3_4.fig_16_lambda_between_the_panels.statement).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.met : GbtSurfaces.Section_3_4.fig_16_lambda_between_the_panels.instance).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ GbtSurfaces.Section_3_4.fig_16_lambda_between_the_surfaces.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.proved : GbtSurfaces.Section_3_5.eq_27.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.met : GbtSurfaces.Section_3_5.eq_27.instance).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved : GbtSurfaces.Section_3_5.sec_3_5_categories.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_29.proved : GbtSurfaces.Section_3_5.eq_29.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_29.met : GbtSurfaces.Section_3_5.eq_29.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_30.proved : GbtSurfaces.Section_3_5.eq_30.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_30.met : GbtSurfaces.Section_3_5.eq_30.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_2.proved : GbtSurfaces.Section_3_5.eq_31_2.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_2.met : GbtSurfaces.Section_3_5.eq_31_2.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_3.proved : GbtSurfaces.Section_3_5.eq_31_3.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_3.met : GbtSurfaces.Section_3_5.eq_31_3.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_4.proved : GbtSurfaces.Section_3_5.eq_31_4.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_4.met : GbtSurfaces.Section_3_5.eq_31_4.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_5.proved : GbtSurfaces.Section_3_5.eq_31_5.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_5.met : GbtSurfaces.Section_3_5.eq_31_5.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.proved : GbtSurfaces.Section_3_5.prop_3_7_1_a.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.met : GbtSurfaces.Section_3_5.prop_3_7_1_a.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.proved : GbtSurfaces.Section_3_5.prop_3_7_2a.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.met : GbtSurfaces.Section_3_5.prop_3_7_2a.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.proved : GbtSurfaces.Section_3_5.prop_3_7_2b.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.met : GbtSurfaces.Section_3_5.prop_3_7_2b.instance).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_a.proved : GbtSurfaces.Section_3_5.alg_5_a.statement).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_a.met : GbtSurfaces.Section_3_5.alg_5_a.instance).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_5.alg_5_b_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_b_there_are_such_connections.proved : GbtSurfaces.Section_3_5.alg_5_b_there_are_such_connections.statement).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_b_there_are_such_connections.met : GbtSurfaces.Section_3_5.alg_5_b_there_are_such_connections.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved : GbtSurfaces.Section_3_5.ex_3_5_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_c1_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.met : GbtSurfaces.Section_3_5.ex_3_5_c1_sections.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.proved : GbtSurfaces.Section_3_5.ex_3_5_c1_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.met : GbtSurfaces.Section_3_5.ex_3_5_c1_trajectories.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_c2_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.met : GbtSurfaces.Section_3_5.ex_3_5_c2_sections.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories.refuted : ~ GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_true.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.met : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_true.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted : ~ GbtSurfaces.Section_3_5.ex_3_5_contiguous_each_with_its_own.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_trajectory.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_trajectory.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.proved : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_section.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.met : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_section.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted : ~ GbtSurfaces.Section_3_6.eq_32_matrix.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_components.proved : GbtSurfaces.Section_3_6.eq_32_components.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_components.met : GbtSurfaces.Section_3_6.eq_32_components.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.proved : GbtSurfaces.Section_3_6.sec_3_6_c1c2.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.met : GbtSurfaces.Section_3_6.sec_3_6_c1c2.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_T.proved : GbtSurfaces.Section_3_6.eq_33_T.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_T.met : GbtSurfaces.Section_3_6.eq_33_T.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.proved : GbtSurfaces.Section_3_6.eq_33_Ttilde.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.met : GbtSurfaces.Section_3_6.eq_33_Ttilde.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_circle.proved : GbtSurfaces.Section_3_6.eq_33_circle.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_circle.met : GbtSurfaces.Section_3_6.eq_33_circle.instance).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved : GbtSurfaces.Section_3_6.thm_6_symmetric.statement).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met : GbtSurfaces.Section_3_6.thm_6_symmetric.instance).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_complete.proved : GbtSurfaces.Section_3_6.thm_6_complete.statement).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_complete.met : GbtSurfaces.Section_3_6.thm_6_complete.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.proved : GbtSurfaces.Section_3_6.eq_34.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.met : GbtSurfaces.Section_3_6.eq_34.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved : GbtSurfaces.Section_3_6.sec_3_6_other_axes.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met : GbtSurfaces.Section_3_6.sec_3_6_other_axes.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.proved : GbtSurfaces.Section_3_6.prop_3_8_a_linear.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.met : GbtSurfaces.Section_3_6.prop_3_8_a_linear.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.proved : GbtSurfaces.Section_3_6.prop_3_8_a_true.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.met : GbtSurfaces.Section_3_6.prop_3_8_a_true.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b.refuted : ~ GbtSurfaces.Section_3_6.prop_3_8_b.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.proved : GbtSurfaces.Section_3_6.prop_3_8_b_true.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.met : GbtSurfaces.Section_3_6.prop_3_8_b_true.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved : GbtSurfaces.Section_3_6.prop_3_8_b_exact.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met : GbtSurfaces.Section_3_6.prop_3_8_b_exact.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.proved : GbtSurfaces.Section_3_6.prop_3_9_a_composite_line.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.met : GbtSurfaces.Section_3_6.prop_3_9_a_composite_line.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted : ~ GbtSurfaces.Section_3_6.prop_3_9_a_one_segment.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_b.proved : GbtSurfaces.Section_3_6.prop_3_9_b.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_b.met : GbtSurfaces.Section_3_6.prop_3_9_b.instance).
Check (GbtSurfaces.Section_3_6_proofs.alg_6.proved : GbtSurfaces.Section_3_6.alg_6.statement).
Check (GbtSurfaces.Section_3_6_proofs.alg_6.met : GbtSurfaces.Section_3_6.alg_6.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_35.proved : GbtSurfaces.Section_3_6.eq_35.statement).
Check (GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.proved : GbtSurfaces.Section_3_6.ex_3_6_curve.statement).
Check (GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.met : GbtSurfaces.Section_3_6.ex_3_6_curve.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_36.proved : GbtSurfaces.Section_3_6.eq_36.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_36.met : GbtSurfaces.Section_3_6.eq_36.instance).
Check (GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_4.abs_features_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.met : GbtSurfaces.Section_4.abs_features_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted : ~ GbtSurfaces.Section_4.abs_features_every_feature.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ GbtSurfaces.Section_4.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.proved : GbtSurfaces.Section_4.sec_4_six_tensor_without.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.met : GbtSurfaces.Section_4.sec_4_six_tensor_without.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_4.sec_4_composite_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.proved : GbtSurfaces.Section_4.sec_4_composite_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.met : GbtSurfaces.Section_4.sec_4_composite_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor_as_printed.proved : GbtSurfaces.Section_4.sec_4_tensor_as_printed.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor_as_printed.met : GbtSurfaces.Section_4.sec_4_tensor_as_printed.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor_with_f_l.refuted : ~ GbtSurfaces.Section_4.sec_4_tensor_with_f_l.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved : GbtSurfaces.Section_4.sec_4_convex_hull.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.proved : HermiteDevelopable.Part_Abstract.abs_construct_a.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.met : HermiteDevelopable.Part_Abstract.abs_construct_a.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.proved : HermiteDevelopable.Part_Abstract.abs_construct_b.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.met : HermiteDevelopable.Part_Abstract.abs_construct_b.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.proved : HermiteDevelopable.Part_Abstract.abs_construct_c.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.met : HermiteDevelopable.Part_Abstract.abs_construct_c.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_d.refuted : ~ HermiteDevelopable.Part_Abstract.abs_construct_d.statement).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved : HermiteDevelopable.Section_1.sec_1_parallel_tangents.statement).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met : HermiteDevelopable.Section_1.sec_1_parallel_tangents.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.proved : HermiteDevelopable.Section_2.sec_2_cubic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.met : HermiteDevelopable.Section_2.sec_2_cubic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved : HermiteDevelopable.Section_2.sec_2_cubic_equations.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved : HermiteDevelopable.Section_2.sec_2_cubic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met : HermiteDevelopable.Section_2.sec_2_cubic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved : HermiteDevelopable.Section_2.sec_2_cubic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met : HermiteDevelopable.Section_2.sec_2_cubic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved : HermiteDevelopable.Section_2.sec_2_cubic_c1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met : HermiteDevelopable.Section_2.sec_2_cubic_c1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved : HermiteDevelopable.Section_2.sec_2_cubic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met : HermiteDevelopable.Section_2.sec_2_cubic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1a.proved : HermiteDevelopable.Section_2.eq_2_1a.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1a.met : HermiteDevelopable.Section_2.eq_2_1a.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b.proved : HermiteDevelopable.Section_2.eq_2_1b.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b.met : HermiteDevelopable.Section_2.eq_2_1b.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.proved : HermiteDevelopable.Section_2.eq_2_1b_H1.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.met : HermiteDevelopable.Section_2.eq_2_1b_H1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.proved : HermiteDevelopable.Section_2.eq_2_1b_H2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.met : HermiteDevelopable.Section_2.eq_2_1b_H2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.proved : HermiteDevelopable.Section_2.eq_2_1b_H3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.met : HermiteDevelopable.Section_2.eq_2_1b_H3.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.proved : HermiteDevelopable.Section_2.eq_2_1b_H4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.met : HermiteDevelopable.Section_2.eq_2_1b_H4.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.proved : HermiteDevelopable.Section_2.sec_2_quartic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.met : HermiteDevelopable.Section_2.sec_2_quartic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_solvable.proved : HermiteDevelopable.Section_2.sec_2_quartic_solvable.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved : HermiteDevelopable.Section_2.sec_2_quartic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met : HermiteDevelopable.Section_2.sec_2_quartic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved : HermiteDevelopable.Section_2.sec_2_quartic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met : HermiteDevelopable.Section_2.sec_2_quartic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted : ~ HermiteDevelopable.Section_2.sec_2_quartic_third.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved : HermiteDevelopable.Section_2.sec_2_quartic_third_corrected.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met : HermiteDevelopable.Section_2.sec_2_quartic_third_corrected.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved : HermiteDevelopable.Section_2.sec_2_quartic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met : HermiteDevelopable.Section_2.sec_2_quartic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved : HermiteDevelopable.Section_2.sec_2_quartic_e1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met : HermiteDevelopable.Section_2.sec_2_quartic_e1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_2.proved : HermiteDevelopable.Section_2.eq_2_2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_2.met : HermiteDevelopable.Section_2.eq_2_2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3.refuted : ~ HermiteDevelopable.Section_2.eq_2_3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved : HermiteDevelopable.Section_2.eq_2_3_corrected.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met : HermiteDevelopable.Section_2.eq_2_3_corrected.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H1.proved : HermiteDevelopable.Section_2.eq_2_3_H1.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H1.met : HermiteDevelopable.Section_2.eq_2_3_H1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H2.proved : HermiteDevelopable.Section_2.eq_2_3_H2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H2.met : HermiteDevelopable.Section_2.eq_2_3_H2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H3.proved : HermiteDevelopable.Section_2.eq_2_3_H3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H3.met : HermiteDevelopable.Section_2.eq_2_3_H3.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H4.proved : HermiteDevelopable.Section_2.eq_2_3_H4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H4.met : HermiteDevelopable.Section_2.eq_2_3_H4.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H5.proved : HermiteDevelopable.Section_2.eq_2_3_H5.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H5.met : HermiteDevelopable.Section_2.eq_2_3_H5.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.proved : HermiteDevelopable.Section_2.sec_2_quintic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.met : HermiteDevelopable.Section_2.sec_2_quintic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved : HermiteDevelopable.Section_2.sec_2_quintic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met : HermiteDevelopable.Section_2.sec_2_quintic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved : HermiteDevelopable.Section_2.sec_2_quintic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met : HermiteDevelopable.Section_2.sec_2_quintic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved : HermiteDevelopable.Section_2.sec_2_quintic_c1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met : HermiteDevelopable.Section_2.sec_2_quintic_c1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved : HermiteDevelopable.Section_2.sec_2_quintic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met : HermiteDevelopable.Section_2.sec_2_quintic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved : HermiteDevelopable.Section_2.sec_2_quintic_e1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met : HermiteDevelopable.Section_2.sec_2_quintic_e1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved : HermiteDevelopable.Section_2.sec_2_quintic_f1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met : HermiteDevelopable.Section_2.sec_2_quintic_f1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_4.proved : HermiteDevelopable.Section_2.eq_2_4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_4.met : HermiteDevelopable.Section_2.eq_2_4.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_control.proved : HermiteDevelopable.Section_2.sec_2_control.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_control.met : HermiteDevelopable.Section_2.sec_2_control.instance).
Check (HermiteDevelopable.Section_2_proofs.fig_1b_middle.proved : HermiteDevelopable.Section_2.fig_1b_middle.statement).
Check (HermiteDevelopable.Section_2_proofs.fig_1b_middle.met : HermiteDevelopable.Section_2.fig_1b_middle.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved : HermiteDevelopable.Section_3_1.sec_3_1_substituted.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met : HermiteDevelopable.Section_3_1.sec_3_1_substituted.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B.refuted : ~ HermiteDevelopable.Section_3_1.eq_3_5_B.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.proved : HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.met : HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.proved : HermiteDevelopable.Section_3_1.eq_3_5_unique.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.met : HermiteDevelopable.Section_3_1.eq_3_5_unique.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_det.proved : HermiteDevelopable.Section_3_1.eq_3_5_det.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.proved : HermiteDevelopable.Section_3_1.eq_3_5_k.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.met : HermiteDevelopable.Section_3_1.eq_3_5_k.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.proved : HermiteDevelopable.Section_3_1.sec_3_1_conclusion.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.met : HermiteDevelopable.Section_3_1.sec_3_1_conclusion.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.proved : HermiteDevelopable.Section_3_1.alg_3_1_step1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.met : HermiteDevelopable.Section_3_1.alg_3_1_step1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.proved : HermiteDevelopable.Section_3_1.alg_3_1_step2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.met : HermiteDevelopable.Section_3_1.alg_3_1_step2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.proved : HermiteDevelopable.Section_3_1.alg_3_1_step3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.met : HermiteDevelopable.Section_3_1.alg_3_1_step3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.proved : HermiteDevelopable.Section_3_1.sec_3_1_tension.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.met : HermiteDevelopable.Section_3_1.sec_3_1_tension.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.proved : HermiteDevelopable.Section_3_1.ex_3_1_arrange.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.met : HermiteDevelopable.Section_3_1.ex_3_1_arrange.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.proved : HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.met : HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.proved : HermiteDevelopable.Section_3_1.ex_3_1_p1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.met : HermiteDevelopable.Section_3_1.ex_3_1_p1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.proved : HermiteDevelopable.Section_3_1.ex_3_1_p0u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.met : HermiteDevelopable.Section_3_1.ex_3_1_p0u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.proved : HermiteDevelopable.Section_3_1.ex_3_1_p1u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.met : HermiteDevelopable.Section_3_1.ex_3_1_p1u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.proved : HermiteDevelopable.Section_3_1.ex_3_1_p0.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.met : HermiteDevelopable.Section_3_1.ex_3_1_p0.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.proved : HermiteDevelopable.Section_3_1.ex_3_1_parallel.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.met : HermiteDevelopable.Section_3_1.ex_3_1_parallel.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.proved : HermiteDevelopable.Section_3_1.ex_3_1_width.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.met : HermiteDevelopable.Section_3_1.ex_3_1_width.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.proved : HermiteDevelopable.Section_3_1.ex_3_1_shapes.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.met : HermiteDevelopable.Section_3_1.ex_3_1_shapes.instance).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.proved : HermiteDevelopable.Section_3_2.sec_3_2_curves.statement).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.met : HermiteDevelopable.Section_3_2.sec_3_2_curves.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r2.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r2.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r3.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r3.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r4.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r4.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r5.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r5.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_B.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_C_r2.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r3.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r3.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r4.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r4.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_C_r5.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_det.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_true.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.met : HermiteDevelopable.Section_3_2.eq_3_6_det_true.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_slip.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_slip.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_factored.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_factored.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.proved : HermiteDevelopable.Section_3_2.eq_3_6_k.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.met : HermiteDevelopable.Section_3_2.eq_3_6_k.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.proved : HermiteDevelopable.Section_3_2.eq_3_6_k_every.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.met : HermiteDevelopable.Section_3_2.eq_3_6_k_every.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.proved : HermiteDevelopable.Section_3_2.eq_3_6_k_135_136.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.met : HermiteDevelopable.Section_3_2.eq_3_6_k_135_136.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_q.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_q.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_o.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_o.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.proved : HermiteDevelopable.Section_3_2.eq_3_6_system.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.met : HermiteDevelopable.Section_3_2.eq_3_6_system.instance).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.proved : HermiteDevelopable.Section_3_2.sec_3_2_advantage.statement).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.met : HermiteDevelopable.Section_3_2.sec_3_2_advantage.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.proved : HermiteDevelopable.Section_3_2.ex_3_2_q.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.met : HermiteDevelopable.Section_3_2.ex_3_2_q.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.proved : HermiteDevelopable.Section_3_2.ex_3_2_p1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.met : HermiteDevelopable.Section_3_2.ex_3_2_p1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.proved : HermiteDevelopable.Section_3_2.ex_3_2_p0u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.met : HermiteDevelopable.Section_3_2.ex_3_2_p0u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.proved : HermiteDevelopable.Section_3_2.ex_3_2_p1u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.met : HermiteDevelopable.Section_3_2.ex_3_2_p1u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.proved : HermiteDevelopable.Section_3_2.ex_3_2_o.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.met : HermiteDevelopable.Section_3_2.ex_3_2_o.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.proved : HermiteDevelopable.Section_3_2.ex_3_2_parallel.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.met : HermiteDevelopable.Section_3_2.ex_3_2_parallel.instance).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.proved : HermiteDevelopable.Section_3_3.sec_3_3_curves.statement).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.met : HermiteDevelopable.Section_3_3.sec_3_3_curves.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r2.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r2.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r3.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r3.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r4.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r4.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r5.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r5.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r6.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r6.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B.refuted : ~ HermiteDevelopable.Section_3_3.eq_3_7_B.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.proved : HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.met : HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r2.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r2.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r3.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r3.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r4.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r4.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r5.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r5.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r6.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r6.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_det.proved : HermiteDevelopable.Section_3_3.eq_3_7_det.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.proved : HermiteDevelopable.Section_3_3.eq_3_7_k.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.met : HermiteDevelopable.Section_3_3.eq_3_7_k.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.proved : HermiteDevelopable.Section_3_3.eq_3_7_k_needed.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.met : HermiteDevelopable.Section_3_3.eq_3_7_k_needed.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_q.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_q.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_o.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_o.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.proved : HermiteDevelopable.Section_3_3.eq_3_7_system.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.met : HermiteDevelopable.Section_3_3.eq_3_7_system.instance).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.proved : HermiteDevelopable.Section_3_3.sec_3_3_advantage.statement).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.met : HermiteDevelopable.Section_3_3.sec_3_3_advantage.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation.refuted : ~ HermiteDevelopable.Section_3_3.ex_3_3_equation.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.proved : HermiteDevelopable.Section_3_3.ex_3_3_equation_true.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.met : HermiteDevelopable.Section_3_3.ex_3_3_equation_true.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.proved : HermiteDevelopable.Section_3_3.ex_3_3_p0u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.met : HermiteDevelopable.Section_3_3.ex_3_3_p0u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.proved : HermiteDevelopable.Section_3_3.ex_3_3_qu.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.met : HermiteDevelopable.Section_3_3.ex_3_3_qu.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.proved : HermiteDevelopable.Section_3_3.ex_3_3_p1u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.met : HermiteDevelopable.Section_3_3.ex_3_3_p1u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.proved : HermiteDevelopable.Section_3_3.ex_3_3_q.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.met : HermiteDevelopable.Section_3_3.ex_3_3_q.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.proved : HermiteDevelopable.Section_3_3.ex_3_3_p1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.met : HermiteDevelopable.Section_3_3.ex_3_3_p1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.proved : HermiteDevelopable.Section_3_3.ex_3_3_o.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.met : HermiteDevelopable.Section_3_3.ex_3_3_o.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.proved : HermiteDevelopable.Section_3_3.ex_3_3_parallel.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.met : HermiteDevelopable.Section_3_3.ex_3_3_parallel.instance).
Check (HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.proved : HermiteDevelopable.Section_3_3.fig_4d_constant.statement).
Check (HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.met : HermiteDevelopable.Section_3_3.fig_4d_constant.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_1.proved : HermiteDevelopable.Section_3.def_3_1.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_1.met : HermiteDevelopable.Section_3.def_3_1.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_1_normal.proved : HermiteDevelopable.Section_3.def_3_1_normal.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_1_normal.met : HermiteDevelopable.Section_3.def_3_1_normal.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_2.proved : HermiteDevelopable.Section_3.def_3_2.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_2_lincomb.proved : HermiteDevelopable.Section_3.def_3_2_lincomb.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.proved : HermiteDevelopable.Section_3.sec_3_g_boundary.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.met : HermiteDevelopable.Section_3.sec_3_g_boundary.instance).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime.refuted : ~ HermiteDevelopable.Section_3.sec_3_g_prime.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.proved : HermiteDevelopable.Section_3.sec_3_g_prime_corrected.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.met : HermiteDevelopable.Section_3.sec_3_g_prime_corrected.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1.proved : HermiteDevelopable.Section_3.eq_3_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1.met : HermiteDevelopable.Section_3.eq_3_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_must.proved : HermiteDevelopable.Section_3.eq_3_1_must.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_must.met : HermiteDevelopable.Section_3.eq_3_1_must.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.proved : HermiteDevelopable.Section_3.eq_3_1_types_a.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.met : HermiteDevelopable.Section_3.eq_3_1_types_a.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_b.proved : HermiteDevelopable.Section_3.eq_3_1_types_b.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.proved : HermiteDevelopable.Section_3.eq_3_1_parallel_planes.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.met : HermiteDevelopable.Section_3.eq_3_1_parallel_planes.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.proved : HermiteDevelopable.Section_3.eq_3_1_rho_constant.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.met : HermiteDevelopable.Section_3.eq_3_1_rho_constant.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.proved : HermiteDevelopable.Section_3.eq_3_1_difficulties_same.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.met : HermiteDevelopable.Section_3.eq_3_1_difficulties_same.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2.proved : HermiteDevelopable.Section_3.eq_3_2.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2.met : HermiteDevelopable.Section_3.eq_3_2.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_edge.proved : HermiteDevelopable.Section_3.eq_3_2_edge.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_edge.met : HermiteDevelopable.Section_3.eq_3_2_edge.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_a_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.proved : HermiteDevelopable.Section_3.eq_3_2_planes_a_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.met : HermiteDevelopable.Section_3.eq_3_2_planes_a_direction.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_b_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_direction.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_b_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across.proved : HermiteDevelopable.Section_3.eq_3_2_across.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across.met : HermiteDevelopable.Section_3.eq_3_2_across.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved : HermiteDevelopable.Section_3.eq_3_2_across_summit.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met : HermiteDevelopable.Section_3.eq_3_2_across_summit.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.proved : HermiteDevelopable.Section_3.eq_3_2_every_degree.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.met : HermiteDevelopable.Section_3.eq_3_2_every_degree.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_g_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_direction.proved : HermiteDevelopable.Section_3.eq_3_3_g_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_true.proved : HermiteDevelopable.Section_3.eq_3_3_g_true.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3a.proved : HermiteDevelopable.Section_3.eq_3_3a.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3a.met : HermiteDevelopable.Section_3.eq_3_3a.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3b.proved : HermiteDevelopable.Section_3.eq_3_3b.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3b.met : HermiteDevelopable.Section_3.eq_3_3b.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.proved : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.met : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.proved : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.met : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.proved : HermiteDevelopable.Section_3.eq_3_3_developable_Hermite.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.met : HermiteDevelopable.Section_3.eq_3_3_developable_Hermite.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_any.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_developable_any.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_exact.proved : HermiteDevelopable.Section_3.eq_3_3_exact.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_exact.met : HermiteDevelopable.Section_3.eq_3_3_exact.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.proved : HermiteDevelopable.Section_3.eq_3_3_multiples_cone.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.met : HermiteDevelopable.Section_3.eq_3_3_multiples_cone.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.proved : HermiteDevelopable.Section_3.eq_3_3_multiples_Hermite.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.met : HermiteDevelopable.Section_3.eq_3_3_multiples_Hermite.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_any.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_multiples_any.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_below_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.met : HermiteDevelopable.Section_3.eq_3_3_k_below_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_equal_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.met : HermiteDevelopable.Section_3.eq_3_3_k_equal_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_above_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.met : HermiteDevelopable.Section_3.eq_3_3_k_above_1.instance).
Check (HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.proved : HermiteDevelopable.Section_3.sec_3_summit_outside.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.met : HermiteDevelopable.Section_3.sec_3_summit_outside.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_4.proved : HermiteDevelopable.Section_3.eq_3_4.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_4.met : HermiteDevelopable.Section_3.eq_3_4.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_cone.proved : HermiteDevelopable.Section_4.sec_4_cone.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_cone.met : HermiteDevelopable.Section_4.sec_4_cone.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_1.proved : HermiteDevelopable.Section_4.eq_4_1.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_1.met : HermiteDevelopable.Section_4.eq_4_1.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_designed.refuted : ~ HermiteDevelopable.Section_4.sec_4_goal_designed.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_image.proved : HermiteDevelopable.Section_4.sec_4_goal_image.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_image.met : HermiteDevelopable.Section_4.sec_4_goal_image.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.proved : HermiteDevelopable.Section_4.sec_4_goal_leaves.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.met : HermiteDevelopable.Section_4.sec_4_goal_leaves.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.proved : HermiteDevelopable.Section_4.sec_4_goal_nodes.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.met : HermiteDevelopable.Section_4.sec_4_goal_nodes.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_only.proved : HermiteDevelopable.Section_4.sec_4_goal_only.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_only.met : HermiteDevelopable.Section_4.sec_4_goal_only.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.proved : HermiteDevelopable.Section_4.sec_4_goal_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.met : HermiteDevelopable.Section_4.sec_4_goal_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_in_plane.proved : HermiteDevelopable.Section_4.sec_4_in_plane.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_in_plane.met : HermiteDevelopable.Section_4.sec_4_in_plane.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_r0.proved : HermiteDevelopable.Section_4.sec_4_r0.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_r0.met : HermiteDevelopable.Section_4.sec_4_r0.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_I1.proved : HermiteDevelopable.Section_4.sec_4_I1.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_I1.met : HermiteDevelopable.Section_4.sec_4_I1.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_w.proved : HermiteDevelopable.Section_4.sec_4_w.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_w.met : HermiteDevelopable.Section_4.sec_4_w.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2.proved : HermiteDevelopable.Section_4.eq_4_2.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2.met : HermiteDevelopable.Section_4.eq_4_2.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4.eq_4_2_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.met : HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.met : HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_true.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.met : HermiteDevelopable.Section_4.eq_4_2_tangent_true.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_s.proved : HermiteDevelopable.Section_4.sec_4_s.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_s.met : HermiteDevelopable.Section_4.sec_4_s.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_3.proved : HermiteDevelopable.Section_4.eq_4_3.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_3.met : HermiteDevelopable.Section_4.eq_4_3.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_ru.proved : HermiteDevelopable.Section_4.eq_4_4_ru.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_ru.met : HermiteDevelopable.Section_4.eq_4_4_ru.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1.proved : HermiteDevelopable.Section_4.eq_4_4_r1.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1.met : HermiteDevelopable.Section_4.eq_4_4_r1.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.proved : HermiteDevelopable.Section_4.eq_4_4_r1u.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.met : HermiteDevelopable.Section_4.eq_4_4_r1u.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4.eq_4_4_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.proved : HermiteDevelopable.Section_4.eq_4_4_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.met : HermiteDevelopable.Section_4.eq_4_4_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.proved : HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.met : HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_oblique.proved : HermiteDevelopable.Section_4.sec_4_oblique.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_data.proved : HermiteDevelopable.Section_4.ex_4_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_data.met : HermiteDevelopable.Section_4.ex_4_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0.proved : HermiteDevelopable.Section_4.ex_4_r0.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0.met : HermiteDevelopable.Section_4.ex_4_r0.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0u.refuted : ~ HermiteDevelopable.Section_4.ex_4_r0u.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r.proved : HermiteDevelopable.Section_4.ex_4_r.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r.met : HermiteDevelopable.Section_4.ex_4_r.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_ru.refuted : ~ HermiteDevelopable.Section_4.ex_4_ru.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1.proved : HermiteDevelopable.Section_4.ex_4_r1.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1.met : HermiteDevelopable.Section_4.ex_4_r1.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.proved : HermiteDevelopable.Section_4.ex_4_r1_rounding.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.met : HermiteDevelopable.Section_4.ex_4_r1_rounding.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1u.refuted : ~ HermiteDevelopable.Section_4.ex_4_r1u.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data.proved : HermiteDevelopable.Section_4.ex_4_other_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data.met : HermiteDevelopable.Section_4.ex_4_other_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.proved : HermiteDevelopable.Section_4.ex_4_other_data_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.met : HermiteDevelopable.Section_4.ex_4_other_data_twist.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_stated_data.proved : HermiteDevelopable.Section_4.ex_4_stated_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_stated_data.met : HermiteDevelopable.Section_4.ex_4_stated_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.proved : HermiteDevelopable.Section_4.ex_4_true_tangents.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.met : HermiteDevelopable.Section_4.ex_4_true_tangents.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_developable_computed.refuted : ~ HermiteDevelopable.Section_4.ex_4_a_developable_computed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_developable_printed.refuted : ~ HermiteDevelopable.Section_4.ex_4_a_developable_printed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist.proved : HermiteDevelopable.Section_4.ex_4_a_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist.met : HermiteDevelopable.Section_4.ex_4_a_twist.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.proved : HermiteDevelopable.Section_4.ex_4_a_twist_most.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.met : HermiteDevelopable.Section_4.ex_4_a_twist_most.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.proved : HermiteDevelopable.Section_4.ex_4_a_twist_printed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.met : HermiteDevelopable.Section_4.ex_4_a_twist_printed.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_developable.refuted : ~ HermiteDevelopable.Section_4.ex_4_b_developable.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_twist.proved : HermiteDevelopable.Section_4.ex_4_b_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_twist.met : HermiteDevelopable.Section_4.ex_4_b_twist.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.proved : HermiteDevelopable.Section_5.sec_5_criteria_a.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.met : HermiteDevelopable.Section_5.sec_5_criteria_a.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.proved : HermiteDevelopable.Section_5.sec_5_criteria_reach.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.met : HermiteDevelopable.Section_5.sec_5_criteria_reach.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_a.proved : HermiteDevelopable.Section_5.sec_5_planes_a.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_a.met : HermiteDevelopable.Section_5.sec_5_planes_a.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_b.refuted : ~ HermiteDevelopable.Section_5.sec_5_planes_b.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_speed.proved : Hyperbolic.Part_Catenary.catenary_speed.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_length.proved : Hyperbolic.Part_Catenary.catenary_length.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature.proved : Hyperbolic.Part_Catenary.catenary_curvature.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature.met : Hyperbolic.Part_Catenary.catenary_curvature.instance).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip.refuted : ~ Hyperbolic.Part_Catenary.catenary_curvature_slip.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.proved : Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.met : Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.instance).
Check (Hyperbolic.Part_Catenary_proofs.catenary_load.proved : Hyperbolic.Part_Catenary.catenary_load.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_conformal.proved : Hyperbolic.Part_Catenoid.catenoid_conformal.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_minimal.proved : Hyperbolic.Part_Catenoid.catenoid_minimal.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_gauss.proved : Hyperbolic.Part_Catenoid.catenoid_gauss.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_regular.proved : Hyperbolic.Part_Catenoid.catenoid_regular.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_ends.proved : Hyperbolic.Part_Curves.curve_ends.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_ends.met : Hyperbolic.Part_Curves.curve_ends.instance).
Check (Hyperbolic.Part_Curves_proofs.curve_d1.proved : Hyperbolic.Part_Curves.curve_d1.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_d1.met : Hyperbolic.Part_Curves.curve_d1.instance).
Check (Hyperbolic.Part_Curves_proofs.curve_d1_slip.refuted : ~ Hyperbolic.Part_Curves.curve_d1_slip.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.proved : Hyperbolic.Part_Curves.curve_d1_slip_corrected.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.met : Hyperbolic.Part_Curves.curve_d1_slip_corrected.instance).
Check (Hyperbolic.Part_Curves_proofs.curve_d2.proved : Hyperbolic.Part_Curves.curve_d2.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_d2.met : Hyperbolic.Part_Curves.curve_d2.instance).
Check (Hyperbolic.Part_Curves_proofs.curve_middle.proved : Hyperbolic.Part_Curves.curve_middle.statement).
Check (Hyperbolic.Part_Curves_proofs.curve_middle.met : Hyperbolic.Part_Curves.curve_middle.instance).
Check (Hyperbolic.Part_Curves_proofs.curve_middle_slip.refuted : ~ Hyperbolic.Part_Curves.curve_middle_slip.statement).
Check (Hyperbolic.Part_Curves_proofs.shape_ends.proved : Hyperbolic.Part_Curves.shape_ends.statement).
Check (Hyperbolic.Part_Curves_proofs.shape_ends.met : Hyperbolic.Part_Curves.shape_ends.instance).
Check (Hyperbolic.Part_Curves_proofs.shape_d1.proved : Hyperbolic.Part_Curves.shape_d1.statement).
Check (Hyperbolic.Part_Curves_proofs.shape_d1.met : Hyperbolic.Part_Curves.shape_d1.instance).
Check (Hyperbolic.Part_Curves_proofs.shape_d1_slip.refuted : ~ Hyperbolic.Part_Curves.shape_d1_slip.statement).
Check (Hyperbolic.Part_Curves_proofs.shape_slope.proved : Hyperbolic.Part_Curves.shape_slope.statement).
Check (Hyperbolic.Part_Curves_proofs.shape_slope.met : Hyperbolic.Part_Curves.shape_slope.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C1.proved : Hyperbolic.Part_Joins.join_C1.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1.met : Hyperbolic.Part_Joins.join_C1.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip.refuted : ~ Hyperbolic.Part_Joins.join_C1_slip.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.proved : Hyperbolic.Part_Joins.join_C1_slip_corrected.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.met : Hyperbolic.Part_Joins.join_C1_slip_corrected.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C2.proved : Hyperbolic.Part_Joins.join_C2.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C2.met : Hyperbolic.Part_Joins.join_C2.instance).
Check (Hyperbolic.Part_Joins_proofs.shape_join.proved : Hyperbolic.Part_Joins.shape_join.statement).
Check (Hyperbolic.Part_Joins_proofs.shape_join.met : Hyperbolic.Part_Joins.shape_join.instance).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_angle.proved : Hyperbolic.Part_Logarithmic.spiral_angle.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_angle_slip.refuted : ~ Hyperbolic.Part_Logarithmic.spiral_angle_slip.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_regular.proved : Hyperbolic.Part_Logarithmic.spiral_regular.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.proved : Hyperbolic.Part_Logarithmic.spiral_curvature.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.met : Hyperbolic.Part_Logarithmic.spiral_curvature.instance).
Check (Hyperbolic.Part_Parts_proofs.fn_half.proved : Hyperbolic.Part_Parts.fn_half.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_half_slip.refuted : ~ Hyperbolic.Part_Parts.fn_half_slip.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_half_slip_corrected.proved : Hyperbolic.Part_Parts.fn_half_slip_corrected.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_third.proved : Hyperbolic.Part_Parts.fn_third.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_tangent.proved : Hyperbolic.Part_Parts.fn_tangent.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_tangent.met : Hyperbolic.Part_Parts.fn_tangent.instance).
Check (Hyperbolic.Part_Rates_proofs.fn_rate.proved : Hyperbolic.Part_Rates.fn_rate.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_rate.met : Hyperbolic.Part_Rates.fn_rate.instance).
Check (Hyperbolic.Part_Rates_proofs.fn_growth.proved : Hyperbolic.Part_Rates.fn_growth.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_bell.proved : Hyperbolic.Part_Rates.fn_bell.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped.proved : Hyperbolic.Part_Rates.fn_damped.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped_slip.refuted : ~ Hyperbolic.Part_Rates.fn_damped_slip.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped_slip_corrected.proved : Hyperbolic.Part_Rates.fn_damped_slip_corrected.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_norm.proved : Hyperbolic.Part_Roots.catenary_norm.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend.proved : Hyperbolic.Part_Roots.catenary_bend.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend.met : Hyperbolic.Part_Roots.catenary_bend.instance).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend_slip.refuted : ~ Hyperbolic.Part_Roots.catenary_bend_slip.statement).
Check (Hyperbolic.Part_Roots_proofs.tractrix_norm.proved : Hyperbolic.Part_Roots.tractrix_norm.statement).
Check (Hyperbolic.Part_Roots_proofs.tractrix_norm.met : Hyperbolic.Part_Roots.tractrix_norm.instance).
Check (Hyperbolic.Part_Signs_proofs.fn_positive.proved : Hyperbolic.Part_Signs.fn_positive.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_strict_slip.refuted : ~ Hyperbolic.Part_Signs.fn_strict_slip.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_bounded.proved : Hyperbolic.Part_Signs.fn_bounded.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_bounded.met : Hyperbolic.Part_Signs.fn_bounded.instance).
Check (Hyperbolic.Part_Signs_proofs.fn_tangent_line.proved : Hyperbolic.Part_Signs.fn_tangent_line.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_unit.proved : Hyperbolic.Part_Signs.fn_unit.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_unit.met : Hyperbolic.Part_Signs.fn_unit.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_slope.proved : Hyperbolic.Part_Spiral.cone_slope.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_slope.met : Hyperbolic.Part_Spiral.cone_slope.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_torsion.proved : Hyperbolic.Part_Spiral.cone_torsion.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_torsion.met : Hyperbolic.Part_Spiral.cone_torsion.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_torse.proved : Hyperbolic.Part_Spiral.cone_torse.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_torse.met : Hyperbolic.Part_Spiral.cone_torse.instance).
Check (Hyperbolic.Part_Sums_proofs.fn_pythagoras.proved : Hyperbolic.Part_Sums.fn_pythagoras.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip.refuted : ~ Hyperbolic.Part_Sums.fn_pythagoras_slip.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_sum.proved : Hyperbolic.Part_Sums.fn_sum.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_difference.proved : Hyperbolic.Part_Sums.fn_difference.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_unity.proved : Hyperbolic.Part_The.quadratic_unity.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_unity.met : Hyperbolic.Part_The.quadratic_unity.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_symmetry.proved : Hyperbolic.Part_The.quadratic_symmetry.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_symmetry.met : Hyperbolic.Part_The.quadratic_symmetry.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_ends.proved : Hyperbolic.Part_The.quadratic_ends.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_ends.met : Hyperbolic.Part_The.quadratic_ends.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_nonnegative.proved : Hyperbolic.Part_The.quadratic_nonnegative.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_nonnegative.met : Hyperbolic.Part_The.quadratic_nonnegative.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_nonnegative_slip.refuted : ~ Hyperbolic.Part_The.quadratic_nonnegative_slip.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_decreasing.proved : Hyperbolic.Part_The.quadratic_decreasing.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_decreasing.met : Hyperbolic.Part_The.quadratic_decreasing.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_largest.proved : Hyperbolic.Part_The.quadratic_largest.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_largest.met : Hyperbolic.Part_The.quadratic_largest.instance).
Check (Hyperbolic.Part_The_proofs.quadratic_space.proved : Hyperbolic.Part_The.quadratic_space.statement).
Check (Hyperbolic.Part_The_proofs.quadratic_space.met : Hyperbolic.Part_The.quadratic_space.instance).
Check (Hyperbolic.Part_The_proofs.shape_unity.proved : Hyperbolic.Part_The.shape_unity.statement).
Check (Hyperbolic.Part_The_proofs.shape_unity.met : Hyperbolic.Part_The.shape_unity.instance).
Check (Hyperbolic.Part_The_proofs.shape_symmetry.proved : Hyperbolic.Part_The.shape_symmetry.statement).
Check (Hyperbolic.Part_The_proofs.shape_symmetry.met : Hyperbolic.Part_The.shape_symmetry.instance).
Check (Hyperbolic.Part_The_proofs.shape_nonnegative.proved : Hyperbolic.Part_The.shape_nonnegative.statement).
Check (Hyperbolic.Part_The_proofs.shape_nonnegative.met : Hyperbolic.Part_The.shape_nonnegative.instance).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_pull.proved : Hyperbolic.Part_Tractrix.tractrix_pull.statement).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_pull.met : Hyperbolic.Part_Tractrix.tractrix_pull.instance).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_speed.proved : Hyperbolic.Part_Tractrix.tractrix_speed.statement).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_speed.met : Hyperbolic.Part_Tractrix.tractrix_speed.instance).
Check (Hyperbolic.Part_Values_proofs.fn_number.proved : Hyperbolic.Part_Values.fn_number.statement).
Check (Hyperbolic.Part_Values_proofs.fn_value.proved : Hyperbolic.Part_Values.fn_value.statement).
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
Check (Splines.Part_B_proofs.uniform_bezier.proved : Splines.Part_B.uniform_bezier.statement).
Check (Splines.Part_B_proofs.uniform_bezier.met : Splines.Part_B.uniform_bezier.instance).
Check (Splines.Part_Cubic_proofs.uniform_cubic.proved : Splines.Part_Cubic.uniform_cubic.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic.met : Splines.Part_Cubic.uniform_cubic.instance).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip.refuted : ~ Splines.Part_Cubic.uniform_cubic_slip.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.proved : Splines.Part_Cubic.uniform_cubic_slip_corrected.statement).
Check (Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.met : Splines.Part_Cubic.uniform_cubic_slip_corrected.instance).
Check (Splines.Part_Derivatives_proofs.uniform_rate.proved : Splines.Part_Derivatives.uniform_rate.statement).
Check (Splines.Part_Derivatives_proofs.uniform_rate.met : Splines.Part_Derivatives.uniform_rate.instance).
Check (Splines.Part_Derivatives_proofs.knots_rate.proved : Splines.Part_Derivatives.knots_rate.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate.met : Splines.Part_Derivatives.knots_rate.instance).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip.refuted : ~ Splines.Part_Derivatives.knots_rate_slip.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.proved : Splines.Part_Derivatives.knots_rate_slip_corrected.statement).
Check (Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.met : Splines.Part_Derivatives.knots_rate_slip_corrected.instance).
Check (Splines.Part_One_proofs.clamped_bernstein.proved : Splines.Part_One.clamped_bernstein.statement).
Check (Splines.Part_Partition_proofs.uniform_unity.proved : Splines.Part_Partition.uniform_unity.statement).
Check (Splines.Part_Partition_proofs.uniform_unity.met : Splines.Part_Partition.uniform_unity.instance).
Check (Splines.Part_Partition_proofs.knots_unity_quadratic.proved : Splines.Part_Partition.knots_unity_quadratic.statement).
Check (Splines.Part_Partition_proofs.knots_unity_quadratic.met : Splines.Part_Partition.knots_unity_quadratic.instance).
Check (Splines.Part_Partition_proofs.knots_unity_cubic.proved : Splines.Part_Partition.knots_unity_cubic.statement).
Check (Splines.Part_Partition_proofs.knots_unity_cubic.met : Splines.Part_Partition.knots_unity_cubic.instance).
Check (Splines.Part_Partition_proofs.knots_unity_equal.proved : Splines.Part_Partition.knots_unity_equal.statement).
Check (Splines.Part_Partition_proofs.knots_unity_equal.met : Splines.Part_Partition.knots_unity_equal.instance).
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
Check (Splines.Part_Quadratic_proofs.uniform_quadratic.proved : Splines.Part_Quadratic.uniform_quadratic.statement).
Check (Splines.Part_Quadratic_proofs.uniform_quadratic.met : Splines.Part_Quadratic.uniform_quadratic.instance).
Check (Splines.Part_Shape_proofs.uniform_line.proved : Splines.Part_Shape.uniform_line.statement).
Check (Splines.Part_Shape_proofs.uniform_line.met : Splines.Part_Shape.uniform_line.instance).
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
Check (Splines.Part_Symmetry_proofs.uniform_symmetry.proved : Splines.Part_Symmetry.uniform_symmetry.statement).
Check (Splines.Part_Symmetry_proofs.uniform_symmetry.met : Splines.Part_Symmetry.uniform_symmetry.instance).
Check (Splines.Part_The_proofs.knots_linear.proved : Splines.Part_The.knots_linear.statement).
Check (Splines.Part_The_proofs.knots_linear.met : Splines.Part_The.knots_linear.instance).
Check (Splines.Part_The_proofs.knots_quadratic.proved : Splines.Part_The.knots_quadratic.statement).
Check (Splines.Part_The_proofs.knots_quadratic.met : Splines.Part_The.knots_quadratic.instance).
Check (Splines.Part_The_proofs.knots_quadratic_slip.refuted : ~ Splines.Part_The.knots_quadratic_slip.statement).
Check (Splines.Part_The_proofs.knots_quadratic_slip_corrected.proved : Splines.Part_The.knots_quadratic_slip_corrected.statement).
Check (Splines.Part_The_proofs.knots_quadratic_slip_corrected.met : Splines.Part_The.knots_quadratic_slip_corrected.instance).
Check (Splines.Part_The_proofs.knots_span.proved : Splines.Part_The.knots_span.statement).
Check (Splines.Part_The_proofs.knots_span.met : Splines.Part_The.knots_span.instance).
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
Check (Torses.Part_Central_proofs.striction_shortest.proved : Torses.Part_Central.striction_shortest.statement).
Check (Torses.Part_Central_proofs.striction_shortest.met : Torses.Part_Central.striction_shortest.instance).
Check (Torses.Part_Central_proofs.striction_growth.proved : Torses.Part_Central.striction_growth.statement).
Check (Torses.Part_Central_proofs.striction_length.proved : Torses.Part_Central.striction_length.statement).
Check (Torses.Part_Central_proofs.striction_length.met : Torses.Part_Central.striction_length.instance).
Check (Torses.Part_Central_proofs.striction_scaled.proved : Torses.Part_Central.striction_scaled.statement).
Check (Torses.Part_Central_proofs.striction_scaled.met : Torses.Part_Central.striction_scaled.instance).
Check (Torses.Part_Central_proofs.striction_unit.proved : Torses.Part_Central.striction_unit.statement).
Check (Torses.Part_Central_proofs.striction_unit.met : Torses.Part_Central.striction_unit.instance).
Check (Torses.Part_Central_proofs.striction_unit_slip.refuted : ~ Torses.Part_Central.striction_unit_slip.statement).
Check (Torses.Part_Cones_proofs.cone_torse.proved : Torses.Part_Cones.cone_torse.statement).
Check (Torses.Part_Cones_proofs.cone_apex.proved : Torses.Part_Cones.cone_apex.statement).
Check (Torses.Part_Cones_proofs.cone_apex_slip.refuted : ~ Torses.Part_Cones.cone_apex_slip.statement).
Check (Torses.Part_Cones_proofs.planes_cone.proved : Torses.Part_Cones.planes_cone.statement).
Check (Torses.Part_Cones_proofs.planes_cone.met : Torses.Part_Cones.planes_cone.instance).
Check (Torses.Part_Constant_proofs.slope_torse.proved : Torses.Part_Constant.slope_torse.statement).
Check (Torses.Part_Constant_proofs.slope_torse.met : Torses.Part_Constant.slope_torse.instance).
Check (Torses.Part_Contact_proofs.ruled_touch.proved : Torses.Part_Contact.ruled_touch.statement).
Check (Torses.Part_Contact_proofs.ruled_touch.met : Torses.Part_Contact.ruled_touch.instance).
Check (Torses.Part_Curvature_proofs.ruled_asymptotic.proved : Torses.Part_Curvature.ruled_asymptotic.statement).
Check (Torses.Part_Curvature_proofs.ruled_mixed.proved : Torses.Part_Curvature.ruled_mixed.statement).
Check (Torses.Part_Curvature_proofs.ruled_lagrange.proved : Torses.Part_Curvature.ruled_lagrange.statement).
Check (Torses.Part_Curvature_proofs.ruled_gauss.proved : Torses.Part_Curvature.ruled_gauss.statement).
Check (Torses.Part_Curvature_proofs.ruled_gauss_curvature.proved : Torses.Part_Curvature.ruled_gauss_curvature.statement).
Check (Torses.Part_Curvature_proofs.ruled_gauss_curvature.met : Torses.Part_Curvature.ruled_gauss_curvature.instance).
Check (Torses.Part_Curvature_proofs.ruled_gauss_sign.proved : Torses.Part_Curvature.ruled_gauss_sign.statement).
Check (Torses.Part_Curvature_proofs.ruled_gauss_slip.refuted : ~ Torses.Part_Curvature.ruled_gauss_slip.statement).
Check (Torses.Part_Curvature_proofs.ruled_gauss_slip_corrected.proved : Torses.Part_Curvature.ruled_gauss_slip_corrected.statement).
Check (Torses.Part_Curves_proofs.curve_chain.proved : Torses.Part_Curves.curve_chain.statement).
Check (Torses.Part_Curves_proofs.curve_chain_slip.refuted : ~ Torses.Part_Curves.curve_chain_slip.statement).
Check (Torses.Part_Curves_proofs.curve_curvature.proved : Torses.Part_Curves.curve_curvature.statement).
Check (Torses.Part_Curves_proofs.curve_curvature.met : Torses.Part_Curves.curve_curvature.instance).
Check (Torses.Part_Curves_proofs.curve_torsion.proved : Torses.Part_Curves.curve_torsion.statement).
Check (Torses.Part_Curves_proofs.curve_torsion.met : Torses.Part_Curves.curve_torsion.instance).
Check (Torses.Part_Curves_proofs.curve_straight.proved : Torses.Part_Curves.curve_straight.statement).
Check (Torses.Part_Curves_proofs.curve_straight.met : Torses.Part_Curves.curve_straight.instance).
Check (Torses.Part_Cylinders_proofs.cylinder_torse.proved : Torses.Part_Cylinders.cylinder_torse.statement).
Check (Torses.Part_Cylinders_proofs.cylinder_torse.met : Torses.Part_Cylinders.cylinder_torse.instance).
Check (Torses.Part_Cylinders_proofs.cylinder_normal.proved : Torses.Part_Cylinders.cylinder_normal.statement).
Check (Torses.Part_Cylinders_proofs.cylinder_normal.met : Torses.Part_Cylinders.cylinder_normal.instance).
Check (Torses.Part_Cylinders_proofs.cylinder_converse_slip.refuted : ~ Torses.Part_Cylinders.cylinder_converse_slip.statement).
Check (Torses.Part_Distribution_proofs.striction_parameter.proved : Torses.Part_Distribution.striction_parameter.statement).
Check (Torses.Part_Distribution_proofs.striction_parameter.met : Torses.Part_Distribution.striction_parameter.instance).
Check (Torses.Part_Distribution_proofs.striction_curvature.proved : Torses.Part_Distribution.striction_curvature.statement).
Check (Torses.Part_Distribution_proofs.striction_curvature.met : Torses.Part_Distribution.striction_curvature.instance).
Check (Torses.Part_Edge_proofs.regression_singular.proved : Torses.Part_Edge.regression_singular.statement).
Check (Torses.Part_Edge_proofs.regression_singular.met : Torses.Part_Edge.regression_singular.instance).
Check (Torses.Part_Edge_proofs.regression_tangent.proved : Torses.Part_Edge.regression_tangent.statement).
Check (Torses.Part_Edge_proofs.regression_tangent.met : Torses.Part_Edge.regression_tangent.instance).
Check (Torses.Part_Edge_proofs.regression_tangent_slip.refuted : ~ Torses.Part_Edge.regression_tangent_slip.statement).
Check (Torses.Part_Edge_proofs.planes_edge.proved : Torses.Part_Edge.planes_edge.statement).
Check (Torses.Part_Edge_proofs.planes_edge.met : Torses.Part_Edge.planes_edge.instance).
Check (Torses.Part_Edge_proofs.planes_edge_in.proved : Torses.Part_Edge.planes_edge_in.statement).
Check (Torses.Part_Edge_proofs.planes_edge_in.met : Torses.Part_Edge.planes_edge_in.instance).
Check (Torses.Part_Edge_proofs.planes_edge_tangent.proved : Torses.Part_Edge.planes_edge_tangent.statement).
Check (Torses.Part_Edge_proofs.planes_edge_tangent.met : Torses.Part_Edge.planes_edge_tangent.instance).
Check (Torses.Part_Edge_proofs.planes_edge_osculating.proved : Torses.Part_Edge.planes_edge_osculating.statement).
Check (Torses.Part_Edge_proofs.planes_edge_osculating.met : Torses.Part_Edge.planes_edge_osculating.instance).
Check (Torses.Part_Freedom_proofs.ruled_directrix.proved : Torses.Part_Freedom.ruled_directrix.statement).
Check (Torses.Part_Freedom_proofs.ruled_scaled.proved : Torses.Part_Freedom.ruled_scaled.statement).
Check (Torses.Part_Freedom_proofs.ruled_parameter.proved : Torses.Part_Freedom.ruled_parameter.statement).
Check (Torses.Part_Freedom_proofs.ruled_parameter_slip.refuted : ~ Torses.Part_Freedom.ruled_parameter_slip.statement).
Check (Torses.Part_Freedom_proofs.ruled_ends.proved : Torses.Part_Freedom.ruled_ends.statement).
Check (Torses.Part_Freedom_proofs.ruled_start.proved : Torses.Part_Freedom.ruled_start.statement).
Check (Torses.Part_Normal_proofs.ruled_normal.proved : Torses.Part_Normal.ruled_normal.statement).
Check (Torses.Part_Normal_proofs.ruled_turn.proved : Torses.Part_Normal.ruled_turn.statement).
Check (Torses.Part_Normal_proofs.ruled_turn_slip.refuted : ~ Torses.Part_Normal.ruled_turn_slip.statement).
Check (Torses.Part_Normal_proofs.ruled_turn_slip_corrected.proved : Torses.Part_Normal.ruled_turn_slip_corrected.statement).
Check (Torses.Part_Normal_proofs.ruled_chasles.proved : Torses.Part_Normal.ruled_chasles.statement).
Check (Torses.Part_Polar_proofs.polar_first.proved : Torses.Part_Polar.polar_first.statement).
Check (Torses.Part_Polar_proofs.polar_second.proved : Torses.Part_Polar.polar_second.statement).
Check (Torses.Part_Polar_proofs.polar_second_slip.refuted : ~ Torses.Part_Polar.polar_second_slip.statement).
Check (Torses.Part_Polar_proofs.polar_second_slip_corrected.proved : Torses.Part_Polar.polar_second_slip_corrected.statement).
Check (Torses.Part_Rectifying_proofs.rectifying_contains.proved : Torses.Part_Rectifying.rectifying_contains.statement).
Check (Torses.Part_Rectifying_proofs.rectifying_geodesic.proved : Torses.Part_Rectifying.rectifying_geodesic.statement).
Check (Torses.Part_Rulings_proofs.planes_ruling.proved : Torses.Part_Rulings.planes_ruling.statement).
Check (Torses.Part_Rulings_proofs.planes_turn.proved : Torses.Part_Rulings.planes_turn.statement).
Check (Torses.Part_Rulings_proofs.planes_turn_slip.refuted : ~ Torses.Part_Rulings.planes_turn_slip.statement).
Check (Torses.Part_Rulings_proofs.planes_turn_slip_corrected.proved : Torses.Part_Rulings.planes_turn_slip_corrected.statement).
Check (Torses.Part_Rulings_proofs.planes_cylinder.proved : Torses.Part_Rulings.planes_cylinder.statement).
Check (Torses.Part_Rulings_proofs.planes_cylinder.met : Torses.Part_Rulings.planes_cylinder.instance).
Check (Torses.Part_Rulings_proofs.planes_scaled.proved : Torses.Part_Rulings.planes_scaled.statement).
Check (Torses.Part_Rulings_proofs.planes_scaled_slip.refuted : ~ Torses.Part_Rulings.planes_scaled_slip.statement).
Check (Torses.Part_Rulings_proofs.planes_scaled_slip_corrected.proved : Torses.Part_Rulings.planes_scaled_slip_corrected.statement).
Check (Torses.Part_Rulings_proofs.planes_dual.proved : Torses.Part_Rulings.planes_dual.statement).
Check (Torses.Part_Rulings_proofs.planes_dual.met : Torses.Part_Rulings.planes_dual.instance).
Check (Torses.Part_Skew_proofs.binormals_skew.proved : Torses.Part_Skew.binormals_skew.statement).
Check (Torses.Part_Skew_proofs.binormals_skew.met : Torses.Part_Skew.binormals_skew.instance).
Check (Torses.Part_Skew_proofs.conoid_skew.proved : Torses.Part_Skew.conoid_skew.statement).
Check (Torses.Part_Tangent_proofs.tangents_torse.proved : Torses.Part_Tangent.tangents_torse.statement).
Check (Torses.Part_Tangent_proofs.tangents_normal.proved : Torses.Part_Tangent.tangents_normal.statement).
Check (Torses.Part_Tangent_proofs.tangents_edge.proved : Torses.Part_Tangent.tangents_edge.statement).
Check (Torses.Part_Tangent_proofs.tangents_osculating.proved : Torses.Part_Tangent.tangents_osculating.statement).
Check (Torses.Part_Tangent_proofs.tangents_metric.proved : Torses.Part_Tangent.tangents_metric.statement).
Check (Torses.Part_Tangent_proofs.tangents_metric.met : Torses.Part_Tangent.tangents_metric.instance).
Check (Torses.Part_Tangent_proofs.tangents_metric_slip.refuted : ~ Torses.Part_Tangent.tangents_metric_slip.statement).
Check (Torses.Part_Torses_proofs.ruled_torse_sufficient.proved : Torses.Part_Torses.ruled_torse_sufficient.statement).
Check (Torses.Part_Torses_proofs.ruled_torse_sufficient.met : Torses.Part_Torses.ruled_torse_sufficient.instance).
Check (Torses.Part_Torses_proofs.ruled_torse_necessary.proved : Torses.Part_Torses.ruled_torse_necessary.statement).
Check (Torses.Part_Torses_proofs.ruled_torse_necessary.met : Torses.Part_Torses.ruled_torse_necessary.instance).
Check (Torses.Part_Torses_proofs.ruled_rodrigues.proved : Torses.Part_Torses.ruled_rodrigues.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved : Trigonometric.Part_Cardioid.cardioid_speed.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.met : Trigonometric.Part_Cardioid.cardioid_speed.instance).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved : Trigonometric.Part_Cardioid.cardioid_cusp.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_curvature.proved : Trigonometric.Part_Cardioid.cardioid_curvature.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_curvature.met : Trigonometric.Part_Cardioid.cardioid_curvature.instance).
Check (Trigonometric.Part_Circles_proofs.quadratic_circle.proved : Trigonometric.Part_Circles.quadratic_circle.statement).
Check (Trigonometric.Part_Circles_proofs.quadratic_circle.met : Trigonometric.Part_Circles.quadratic_circle.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_ends.proved : Trigonometric.Part_Curves.quadratic_ends.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_ends.met : Trigonometric.Part_Curves.quadratic_ends.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1.proved : Trigonometric.Part_Curves.quadratic_d1.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1.met : Trigonometric.Part_Curves.quadratic_d1.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d2.proved : Trigonometric.Part_Curves.quadratic_d2.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d2.met : Trigonometric.Part_Curves.quadratic_d2.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted : ~ Trigonometric.Part_Curves.quadratic_d1_slip.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved : Trigonometric.Part_Curves.quadratic_d1_slip_corrected.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met : Trigonometric.Part_Curves.quadratic_d1_slip_corrected.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_speed.proved : Trigonometric.Part_Cycloid.cycloid_speed.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_speed.met : Trigonometric.Part_Cycloid.cycloid_speed.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_regular.proved : Trigonometric.Part_Cycloid.cycloid_regular.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_regular.met : Trigonometric.Part_Cycloid.cycloid_regular.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope.proved : Trigonometric.Part_Cycloid.cycloid_slope.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope.met : Trigonometric.Part_Cycloid.cycloid_slope.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip.refuted : ~ Trigonometric.Part_Cycloid.cycloid_slope_slip.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.proved : Trigonometric.Part_Cycloid.cycloid_slope_slip_corrected.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.met : Trigonometric.Part_Cycloid.cycloid_slope_slip_corrected.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_bend.proved : Trigonometric.Part_Cycloid.cycloid_bend.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_bend.met : Trigonometric.Part_Cycloid.cycloid_bend.instance).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_curvature.proved : Trigonometric.Part_Cycloid.cycloid_curvature.statement).
Check (Trigonometric.Part_Cycloid_proofs.cycloid_curvature.met : Trigonometric.Part_Cycloid.cycloid_curvature.instance).
Check (Trigonometric.Part_Half_proofs.angle_half_sine.proved : Trigonometric.Part_Half.angle_half_sine.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_cosine.proved : Trigonometric.Part_Half.angle_half_cosine.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_slip.refuted : ~ Trigonometric.Part_Half.angle_half_slip.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_slip_corrected.proved : Trigonometric.Part_Half.angle_half_slip_corrected.statement).
Check (Trigonometric.Part_Half_proofs.half_unity.proved : Trigonometric.Part_Half.half_unity.statement).
Check (Trigonometric.Part_Half_proofs.half_unity.met : Trigonometric.Part_Half.half_unity.instance).
Check (Trigonometric.Part_Half_proofs.half_middle.proved : Trigonometric.Part_Half.half_middle.statement).
Check (Trigonometric.Part_Half_proofs.half_middle.met : Trigonometric.Part_Half.half_middle.instance).
Check (Trigonometric.Part_Half_proofs.half_sine.proved : Trigonometric.Part_Half.half_sine.statement).
Check (Trigonometric.Part_Half_proofs.half_sine.met : Trigonometric.Part_Half.half_sine.instance).
Check (Trigonometric.Part_Half_proofs.half_cosine.proved : Trigonometric.Part_Half.half_cosine.statement).
Check (Trigonometric.Part_Half_proofs.half_cosine.met : Trigonometric.Part_Half.half_cosine.instance).
Check (Trigonometric.Part_Half_proofs.half_cosine_slip.refuted : ~ Trigonometric.Part_Half.half_cosine_slip.statement).
Check (Trigonometric.Part_Half_proofs.half_powers.proved : Trigonometric.Part_Half.half_powers.statement).
Check (Trigonometric.Part_Half_proofs.half_powers.met : Trigonometric.Part_Half.half_powers.instance).
Check (Trigonometric.Part_Half_proofs.half_d1.proved : Trigonometric.Part_Half.half_d1.statement).
Check (Trigonometric.Part_Half_proofs.half_d1.met : Trigonometric.Part_Half.half_d1.instance).
Check (Trigonometric.Part_Half_proofs.half_d1_slip.refuted : ~ Trigonometric.Part_Half.half_d1_slip.statement).
Check (Trigonometric.Part_Half_proofs.half_d1_slip_corrected.proved : Trigonometric.Part_Half.half_d1_slip_corrected.statement).
Check (Trigonometric.Part_Half_proofs.half_d1_slip_corrected.met : Trigonometric.Part_Half.half_d1_slip_corrected.instance).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved : Trigonometric.Part_Helicoid.helicoid_skew.statement).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew.met : Trigonometric.Part_Helicoid.helicoid_skew.instance).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted : ~ Trigonometric.Part_Helicoid.helicoid_skew_slip.statement).
Check (Trigonometric.Part_Helix_proofs.helix_speed.proved : Trigonometric.Part_Helix.helix_speed.statement).
Check (Trigonometric.Part_Helix_proofs.helix_speed.met : Trigonometric.Part_Helix.helix_speed.instance).
Check (Trigonometric.Part_Helix_proofs.helix_torsion.proved : Trigonometric.Part_Helix.helix_torsion.statement).
Check (Trigonometric.Part_Helix_proofs.helix_torsion.met : Trigonometric.Part_Helix.helix_torsion.instance).
Check (Trigonometric.Part_Helix_proofs.helix_curvature.proved : Trigonometric.Part_Helix.helix_curvature.statement).
Check (Trigonometric.Part_Helix_proofs.helix_curvature.met : Trigonometric.Part_Helix.helix_curvature.instance).
Check (Trigonometric.Part_Joins_proofs.quadratic_join.proved : Trigonometric.Part_Joins.quadratic_join.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join.met : Trigonometric.Part_Joins.quadratic_join.instance).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted : ~ Trigonometric.Part_Joins.quadratic_join_slip.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved : Trigonometric.Part_Joins.quadratic_join_slip_corrected.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met : Trigonometric.Part_Joins.quadratic_join_slip_corrected.instance).
Check (Trigonometric.Part_Known_proofs.angle_known.proved : Trigonometric.Part_Known.angle_known.statement).
Check (Trigonometric.Part_Parts_proofs.angle_third.proved : Trigonometric.Part_Parts.angle_third.statement).
Check (Trigonometric.Part_Parts_proofs.angle_parts.proved : Trigonometric.Part_Parts.angle_parts.statement).
Check (Trigonometric.Part_Parts_proofs.angle_rate.proved : Trigonometric.Part_Parts.angle_rate.statement).
Check (Trigonometric.Part_Roots_proofs.helix_length.proved : Trigonometric.Part_Roots.helix_length.statement).
Check (Trigonometric.Part_Roots_proofs.helix_length.met : Trigonometric.Part_Roots.helix_length.instance).
Check (Trigonometric.Part_Roots_proofs.helix_bend.proved : Trigonometric.Part_Roots.helix_bend.statement).
Check (Trigonometric.Part_Roots_proofs.helix_bend.met : Trigonometric.Part_Roots.helix_bend.instance).
Check (Trigonometric.Part_Roots_proofs.helix_bend_slip.refuted : ~ Trigonometric.Part_Roots.helix_bend_slip.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_normal.proved : Trigonometric.Part_Roots.cylinder_normal.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_normal.met : Trigonometric.Part_Roots.cylinder_normal.instance).
Check (Trigonometric.Part_Roots_proofs.cylinder_offset.proved : Trigonometric.Part_Roots.cylinder_offset.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_offset.met : Trigonometric.Part_Roots.cylinder_offset.instance).
Check (Trigonometric.Part_Signs_proofs.angle_first.proved : Trigonometric.Part_Signs.angle_first.statement).
Check (Trigonometric.Part_Signs_proofs.angle_first.met : Trigonometric.Part_Signs.angle_first.instance).
Check (Trigonometric.Part_Signs_proofs.angle_first_turned.proved : Trigonometric.Part_Signs.angle_first_turned.statement).
Check (Trigonometric.Part_Signs_proofs.angle_first_turned.met : Trigonometric.Part_Signs.angle_first_turned.instance).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric.proved : Trigonometric.Part_Signs.angle_symmetric.statement).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric.met : Trigonometric.Part_Signs.angle_symmetric.instance).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted : ~ Trigonometric.Part_Signs.angle_symmetric_slip.statement).
Check (Trigonometric.Part_Signs_proofs.angle_turn.proved : Trigonometric.Part_Signs.angle_turn.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.proved : Trigonometric.Part_Tangent.helix_torse.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.met : Trigonometric.Part_Tangent.helix_torse.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.proved : Trigonometric.Part_Tangent.helix_normal.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.met : Trigonometric.Part_Tangent.helix_normal.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_regular.proved : Trigonometric.Part_Tangent.helix_regular.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_regular.met : Trigonometric.Part_Tangent.helix_regular.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.proved : Trigonometric.Part_Tangents.angle_tangent.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.met : Trigonometric.Part_Tangents.angle_tangent.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved : Trigonometric.Part_Tangents.angle_tangent_closed.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met : Trigonometric.Part_Tangents.angle_tangent_closed.instance).
Check (Trigonometric.Part_The_proofs.quadratic_middle.proved : Trigonometric.Part_The.quadratic_middle.statement).
Check (Trigonometric.Part_The_proofs.quadratic_middle.met : Trigonometric.Part_The.quadratic_middle.instance).
Check (Trigonometric.Part_The_proofs.quadratic_nonnegative.proved : Trigonometric.Part_The.quadratic_nonnegative.statement).
Check (Trigonometric.Part_The_proofs.quadratic_nonnegative.met : Trigonometric.Part_The.quadratic_nonnegative.instance).
Check (Trigonometric.Part_The_proofs.quadratic_nonnegative_slip.refuted : ~ Trigonometric.Part_The.quadratic_nonnegative_slip.statement).
Check (Trigonometric.Part_The_proofs.quadratic_symmetry.proved : Trigonometric.Part_The.quadratic_symmetry.statement).
Check (Trigonometric.Part_The_proofs.quadratic_symmetry.met : Trigonometric.Part_The.quadratic_symmetry.instance).
Check (Trigonometric.Part_The_proofs.quadratic_decreasing.proved : Trigonometric.Part_The.quadratic_decreasing.statement).
Check (Trigonometric.Part_The_proofs.quadratic_decreasing.met : Trigonometric.Part_The.quadratic_decreasing.instance).
Definition all_theorems : True :=
let _ := Bezier.Part_A_proofs.trigonometric_circle.proved in
let _ := Bezier.Part_A_proofs.trigonometric_circle.met in
let _ := Bezier.Part_Algebraic_proofs.reach_root.proved in
let _ := Bezier.Part_Algebraic_proofs.reach_root.met in
let _ := Bezier.Part_Algebraic_proofs.reach_square.proved in
let _ := Bezier.Part_Algebraic_proofs.reach_square.met in
let _ := Bezier.Part_Bounds_proofs.reach_surd.proved in
let _ := Bezier.Part_Bounds_proofs.reach_surd.met in
let _ := Bezier.Part_Bounds_proofs.reach_simplex.proved in
let _ := Bezier.Part_Bounds_proofs.reach_simplex.met in
let _ := Bezier.Part_Bounds_proofs.reach_between.proved in
let _ := Bezier.Part_Bounds_proofs.reach_between.met in
let _ := Bezier.Part_Bounds_proofs.reach_interval.proved in
let _ := Bezier.Part_Bounds_proofs.reach_interval.met in
let _ := Bezier.Part_Bounds_proofs.reach_interval_basis.proved in
let _ := Bezier.Part_Bounds_proofs.reach_interval_basis.met in
let _ := Bezier.Part_C_proofs.join_C0.proved in
let _ := Bezier.Part_C_proofs.join_C0.met in
let _ := Bezier.Part_C_proofs.join_C1.proved in
let _ := Bezier.Part_C_proofs.join_C1.met in
let _ := Bezier.Part_C_proofs.join_C1_slip.refuted in
let _ := Bezier.Part_C_proofs.join_C1_slip_corrected.proved in
let _ := Bezier.Part_C_proofs.join_C1_slip_corrected.met in
let _ := Bezier.Part_C_proofs.join_C2.proved in
let _ := Bezier.Part_C_proofs.join_C2.met in
let _ := Bezier.Part_C_proofs.join_C2_slip.refuted in
let _ := Bezier.Part_C_proofs.join_C2_slip_corrected.proved in
let _ := Bezier.Part_C_proofs.join_C2_slip_corrected.met in
let _ := Bezier.Part_C_proofs.join_C3.proved in
let _ := Bezier.Part_C_proofs.join_C3.met in
let _ := Bezier.Part_C_proofs.join_C2_sufficient.proved in
let _ := Bezier.Part_C_proofs.join_C2_sufficient.met in
let _ := Bezier.Part_C_proofs.join_knot.proved in
let _ := Bezier.Part_C_proofs.join_knot.met in
let _ := Bezier.Part_C_proofs.trigonometric_C1.proved in
let _ := Bezier.Part_C_proofs.trigonometric_C1.met in
let _ := Bezier.Part_C_proofs.trigonometric_C1_inside.proved in
let _ := Bezier.Part_C_proofs.trigonometric_C1_inside.met in
let _ := Bezier.Part_C_proofs.trigonometric_bezier.proved in
let _ := Bezier.Part_C_proofs.trigonometric_bezier.met in
let _ := Bezier.Part_Closed_proofs.bernstein_formula.proved in
let _ := Bezier.Part_Closed_proofs.bernstein_formula.met in
let _ := Bezier.Part_De_proofs.curve_casteljau.proved in
let _ := Bezier.Part_De_proofs.curve_casteljau.met in
let _ := Bezier.Part_Definition_proofs.bernstein_recursion.proved in
let _ := Bezier.Part_Definition_proofs.bernstein_recursion.met in
let _ := Bezier.Part_Degree_proofs.bernstein_elevation.proved in
let _ := Bezier.Part_Degree_proofs.bernstein_elevation.met in
let _ := Bezier.Part_Degree_proofs.curve_elevation.proved in
let _ := Bezier.Part_Degree_proofs.curve_elevation.met in
let _ := Bezier.Part_Derivative_proofs.bernstein_derivative.proved in
let _ := Bezier.Part_Derivative_proofs.bernstein_derivative.met in
let _ := Bezier.Part_Derivative_proofs.bernstein_derivative_slip.refuted in
let _ := Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved in
let _ := Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.met in
let _ := Bezier.Part_Divisors_proofs.reach_interval_open.proved in
let _ := Bezier.Part_Divisors_proofs.reach_interval_open.met in
let _ := Bezier.Part_Divisors_proofs.reach_interval_closed.proved in
let _ := Bezier.Part_Divisors_proofs.reach_interval_closed.met in
let _ := Bezier.Part_Divisors_proofs.reach_positive.proved in
let _ := Bezier.Part_Divisors_proofs.reach_positive.met in
let _ := Bezier.Part_Divisors_proofs.reach_open.proved in
let _ := Bezier.Part_Divisors_proofs.reach_open.met in
let _ := Bezier.Part_Divisors_proofs.reach_ordered.proved in
let _ := Bezier.Part_Divisors_proofs.reach_ordered.met in
let _ := Bezier.Part_Divisors_proofs.reach_vector.proved in
let _ := Bezier.Part_Divisors_proofs.reach_vector.met in
let _ := Bezier.Part_End_proofs.curve_ends.proved in
let _ := Bezier.Part_End_proofs.curve_ends.met in
let _ := Bezier.Part_End_proofs.curve_d1.proved in
let _ := Bezier.Part_End_proofs.curve_d1.met in
let _ := Bezier.Part_End_proofs.curve_d2.proved in
let _ := Bezier.Part_End_proofs.curve_d2.met in
let _ := Bezier.Part_End_proofs.curve_d2_slip.refuted in
let _ := Bezier.Part_End_proofs.curve_d2_slip_corrected.proved in
let _ := Bezier.Part_End_proofs.curve_d2_slip_corrected.met in
let _ := Bezier.Part_End_proofs.curve_d3.proved in
let _ := Bezier.Part_End_proofs.curve_d3.met in
let _ := Bezier.Part_End_proofs.trigonometric_d1.proved in
let _ := Bezier.Part_End_proofs.trigonometric_d1.met in
let _ := Bezier.Part_End_proofs.trigonometric_d1_slip.refuted in
let _ := Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.proved in
let _ := Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.met in
let _ := Bezier.Part_End_proofs.trigonometric_d2.proved in
let _ := Bezier.Part_End_proofs.trigonometric_d2.met in
let _ := Bezier.Part_Families_proofs.family_corner.proved in
let _ := Bezier.Part_Families_proofs.family_corner.met in
let _ := Bezier.Part_Families_proofs.family_casteljau.proved in
let _ := Bezier.Part_Families_proofs.family_casteljau.met in
let _ := Bezier.Part_Families_proofs.family_casteljau_slip.refuted in
let _ := Bezier.Part_Families_proofs.family_weights.proved in
let _ := Bezier.Part_Families_proofs.family_weights.met in
let _ := Bezier.Part_G_proofs.join_G2.proved in
let _ := Bezier.Part_G_proofs.join_G2.met in
let _ := Bezier.Part_Hodograph_proofs.curve_hodograph.proved in
let _ := Bezier.Part_Hodograph_proofs.curve_hodograph.met in
let _ := Bezier.Part_Linear_proofs.bernstein_precision.proved in
let _ := Bezier.Part_Linear_proofs.bernstein_precision.met in
let _ := Bezier.Part_Lists_proofs.list_unity.proved in
let _ := Bezier.Part_Lists_proofs.list_unity.met in
let _ := Bezier.Part_Lists_proofs.list_nonnegative.proved in
let _ := Bezier.Part_Lists_proofs.list_nonnegative.met in
let _ := Bezier.Part_Lists_proofs.list_nonnegative_slip.refuted in
let _ := Bezier.Part_Logic_proofs.reach_implies.proved in
let _ := Bezier.Part_Logic_proofs.reach_length_zero.proved in
let _ := Bezier.Part_Logic_proofs.reach_product_zero.proved in
let _ := Bezier.Part_Logic_proofs.reach_roots.proved in
let _ := Bezier.Part_Logic_proofs.reach_roots_slip.refuted in
let _ := Bezier.Part_Logic_proofs.reach_weights_zero.proved in
let _ := Bezier.Part_Logic_proofs.reach_weights_zero.met in
let _ := Bezier.Part_Logic_proofs.reach_circle_bound.proved in
let _ := Bezier.Part_Logic_proofs.reach_circle_bound.met in
let _ := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.proved in
let _ := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.met in
let _ := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted in
let _ := Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.proved in
let _ := Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative.met in
let _ := Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted in
let _ := Bezier.Part_Numbers_proofs.exists_quotient_any.proved in
let _ := Bezier.Part_Numbers_proofs.exists_quotient_any.met in
let _ := Bezier.Part_Numbers_proofs.exists_above.proved in
let _ := Bezier.Part_Numbers_proofs.exists_above.met in
let _ := Bezier.Part_Numbers_proofs.exists_root.proved in
let _ := Bezier.Part_Numbers_proofs.exists_root.met in
let _ := Bezier.Part_Numbers_proofs.exists_none.refuted in
let _ := Bezier.Part_Numbers_proofs.exists_parallel.proved in
let _ := Bezier.Part_Numbers_proofs.exists_parallel.met in
let _ := Bezier.Part_Numbers_proofs.exists_parallel_only.proved in
let _ := Bezier.Part_Numbers_proofs.exists_parallel_only.met in
let _ := Bezier.Part_Partition_proofs.bernstein_unity.proved in
let _ := Bezier.Part_Partition_proofs.bernstein_unity.met in
let _ := Bezier.Part_Partition_proofs.trigonometric_unity.proved in
let _ := Bezier.Part_Partition_proofs.trigonometric_unity.met in
let _ := Bezier.Part_Powers_proofs.power_next.proved in
let _ := Bezier.Part_Powers_proofs.power_next.met in
let _ := Bezier.Part_Powers_proofs.power_rate.proved in
let _ := Bezier.Part_Powers_proofs.power_rate.met in
let _ := Bezier.Part_Powers_proofs.power_rate_slip.refuted in
let _ := Bezier.Part_Powers_proofs.power_rate_slip_corrected.proved in
let _ := Bezier.Part_Powers_proofs.power_rate_slip_corrected.met in
let _ := Bezier.Part_Powers_proofs.power_product.proved in
let _ := Bezier.Part_Powers_proofs.power_product.met in
let _ := Bezier.Part_Powers_proofs.power_ends.proved in
let _ := Bezier.Part_Powers_proofs.power_ends.met in
let _ := Bezier.Part_Powers_proofs.power_binomial.proved in
let _ := Bezier.Part_Powers_proofs.power_binomial.met in
let _ := Bezier.Part_README_proofs.language_numbers.proved in
let _ := Bezier.Part_README_proofs.language_numbers.met in
let _ := Bezier.Part_README_proofs.language_calculus.proved in
let _ := Bezier.Part_README_proofs.language_calculus.met in
let _ := Bezier.Part_README_proofs.language_vectors.proved in
let _ := Bezier.Part_README_proofs.language_matrices.proved in
let _ := Bezier.Part_README_proofs.language_matrices.met in
let _ := Bezier.Part_README_proofs.language_decimals.proved in
let _ := Bezier.Part_README_proofs.language_divisor.proved in
let _ := Bezier.Part_README_proofs.language_divisor.met in
let _ := Bezier.Part_README_proofs.language_degree.proved in
let _ := Bezier.Part_README_proofs.language_degree.met in
let _ := Bezier.Part_README_proofs.language_order.proved in
let _ := Bezier.Part_README_proofs.language_order.met in
let _ := Bezier.Part_README_proofs.language_order_false.refuted in
let _ := Bezier.Part_README_proofs.language_assumed.proved in
let _ := Bezier.Part_README_proofs.language_assumed.met in
let _ := Bezier.Part_README_proofs.language_declared.proved in
let _ := Bezier.Part_README_proofs.language_declared.met in
let _ := Bezier.Part_README_proofs.language_decimals_false.refuted in
let _ := Bezier.Part_Reflection_proofs.curve_reflection.proved in
let _ := Bezier.Part_Reflection_proofs.curve_reflection.met in
let _ := Bezier.Part_Roots_proofs.reach_unit.proved in
let _ := Bezier.Part_Roots_proofs.reach_unit.met in
let _ := Bezier.Part_Roots_proofs.reach_unit_zero.proved in
let _ := Bezier.Part_Roots_proofs.reach_unit_zero.met in
let _ := Bezier.Part_Roots_proofs.reach_size.proved in
let _ := Bezier.Part_Roots_proofs.reach_size.met in
let _ := Bezier.Part_Roots_proofs.reach_size_slip.refuted in
let _ := Bezier.Part_Roots_proofs.reach_product.proved in
let _ := Bezier.Part_Roots_proofs.reach_product.met in
let _ := Bezier.Part_Roots_proofs.reach_least.proved in
let _ := Bezier.Part_Roots_proofs.reach_least.met in
let _ := Bezier.Part_Roots_proofs.reach_triangle.proved in
let _ := Bezier.Part_Roots_proofs.reach_triangle_slip.refuted in
let _ := Bezier.Part_Roots_proofs.reach_subadditive.proved in
let _ := Bezier.Part_Roots_proofs.reach_subadditive.met in
let _ := Bezier.Part_Roots_proofs.reach_above.proved in
let _ := Bezier.Part_Roots_proofs.reach_above.met in
let _ := Bezier.Part_Subdivision_proofs.curve_midpoint.proved in
let _ := Bezier.Part_Subdivision_proofs.curve_midpoint.met in
let _ := Bezier.Part_Sums_proofs.sum_powers.proved in
let _ := Bezier.Part_Sums_proofs.sum_powers.met in
let _ := Bezier.Part_Sums_proofs.sum_powers_slip.refuted in
let _ := Bezier.Part_Sums_proofs.sum_powers_slip_corrected.proved in
let _ := Bezier.Part_Sums_proofs.sum_powers_slip_corrected.met in
let _ := Bezier.Part_Sums_proofs.sum_swap.proved in
let _ := Bezier.Part_Sums_proofs.sum_swap.met in
let _ := Bezier.Part_Sums_proofs.sum_swap_weighted.proved in
let _ := Bezier.Part_Sums_proofs.sum_swap_weighted.met in
let _ := Bezier.Part_Sums_proofs.sum_swap_slip.refuted in
let _ := Bezier.Part_Symmetry_proofs.bernstein_symmetry.proved in
let _ := Bezier.Part_Symmetry_proofs.bernstein_symmetry.met in
let _ := Bezier.Part_Symmetry_proofs.trigonometric_symmetry.proved in
let _ := Bezier.Part_Symmetry_proofs.trigonometric_symmetry.met in
let _ := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted in
let _ := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved in
let _ := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met in
let _ := Bezier.Part_The_proofs.circle_kappa.proved in
let _ := Bezier.Part_The_proofs.circle_kappa_cut.proved in
let _ := Bezier.Part_The_proofs.circle_kappa_slip.refuted in
let _ := Bezier.Part_The_proofs.circle_middle.proved in
let _ := Bezier.Part_The_proofs.circle_outside.proved in
let _ := Bezier.Part_The_proofs.circle_outside.met in
let _ := Bezier.Part_The_proofs.circle_exact_slip.refuted in
let _ := Bezier.Part_The_proofs.reach_definite.proved in
let _ := Bezier.Part_The_proofs.reach_cauchy.proved in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_conics_planes.refuted in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_conics_points.met in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_a.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_a.met in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_c_any_values.refuted in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g0.proved in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g0.met in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g1.proved in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g1.met in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g2.proved in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_g2.met in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_range.proved in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_range.met in
let _ := GbtDevelopable.Section_2_1_proofs.eq_2_1.proved in
let _ := GbtDevelopable.Section_2_1_proofs.eq_2_1.met in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_zero.proved in
let _ := GbtDevelopable.Section_2_1_proofs.def_1_zero.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_functions.refuted in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_functions.refuted in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_letters.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_no_degeneration.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_1_jets.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_2.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_2.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_3.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_3.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_4.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_4.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5.refuted in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_cubic.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_all.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_5_all.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_a.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_a.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_b.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_b.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_c.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_c.met in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_d.proved in
let _ := GbtDevelopable.Section_2_1_proofs.thm_1_6_d.met in
let _ := GbtDevelopable.Section_2_2_proofs.eq_2_2.proved in
let _ := GbtDevelopable.Section_2_2_proofs.eq_2_2.met in
let _ := GbtDevelopable.Section_2_2_proofs.def_2_dim_one_letter.refuted in
let _ := GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.proved in
let _ := GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_convexity.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_symmetry_exchange.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_quadratic.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_vd_operator.met in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.proved in
let _ := GbtDevelopable.Section_2_2_proofs.sec_2_2_geominv.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_linear.met in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_3.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.proved in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_3_corrected.met in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_4.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.proved in
let _ := GbtDevelopable.Section_2_3_proofs.eq_2_4_corrected.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_mu.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_indep_nu.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_move.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_move.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_nu.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_range.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_1.met in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_quadratic.met in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_1.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_1.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_2.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_2.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_3.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_3.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_4.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_4.met in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_5.proved in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_5.met in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_6.proved in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_6.met in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_phi.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.met in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_phi_exp.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.met in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.met in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_x.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_y.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z.refuted in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z_corrected.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_den.proved in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_7.proved in
let _ := GbtDevelopable.Section_3_2_proofs.eq_3_7.met in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.proved in
let _ := GbtDevelopable.Section_3_2_proofs.sec_3_2_envelope.met in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_8.proved in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_8.met in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_9.proved in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_9.met in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec.refuted in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec_corrected.met in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_x.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_y.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_z.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_den.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression.met in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_velocity.met in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_regression_quadratic.met in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_10.proved in
let _ := GbtDevelopable.Section_3_3_proofs.eq_3_10.met in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.proved in
let _ := GbtDevelopable.Section_3_3_proofs.sec_3_3_developable.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_a.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_a.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_b.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_b.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_c.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_11_c.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_a.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_a.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_b.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_b.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_c.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_12_c.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_tangent_ends.met in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_13.proved in
let _ := GbtDevelopable.Section_3_4_proofs.eq_3_13.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_J0.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_J1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2.refuted in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3.refuted in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2.refuted in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_c3.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S0.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S0_gen.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S1.met in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.proved in
let _ := GbtDevelopable.Section_3_4_proofs.sec_3_4_S1_gen.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_a.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths_exchanged.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_c.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_d.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_e.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_a.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_c.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_d.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_a.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_c.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_1_c3_d.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_class.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_lengths.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_a.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_c.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_d.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_e.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_a.refuted in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_c.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c2_d.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_a.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_b.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.proved in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_c.met in
let _ := GbtDevelopable.Section_4_1_proofs.ex_4_2_c3_d.refuted in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q0.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1_lengths.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q3.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_class.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_class.met in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.proved in
let _ := GbtDevelopable.Section_4_2_proofs.sec_4_2_class_ends.met in
let _ := GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved in
let _ := GbtDevelopable.Section_4_proofs.sec_4_midpoints.met in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_distance.met in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_3_a.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_3_a.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_3_b.refuted in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_4.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_4.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.proved in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify.met in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.proved in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_sheets.met in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.proved in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_certify_cusp.met in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.proved in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_families.met in
let _ := GbtDevelopable.Section_5_1_proofs.sec_5_1_G0_surfaces.refuted in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_a.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_a.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_b.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_b.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_7_requirement.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_7_equivalence.refuted in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_8_a.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_8_a.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_8_b.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_8_b.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_9.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_9.met in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_10.proved in
let _ := GbtDevelopable.Section_5_1_proofs.eq_5_10.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_sufficient.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_necessary_families.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_necessary.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_sufficient.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_generator.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_true_sheets.met in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_11.proved in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_11.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.proved in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_index.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_consts.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_consts.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_a.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_a.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_b.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_b.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_c.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_c.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_sufficient.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_necessary_families.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_13.proved in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_13.met in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_15.proved in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_15.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_numbered.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_meant.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref_as_meant.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_consts.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_consts.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_a.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_a.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_b.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_b.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_c.refuted in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_c_corrected.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_c_true.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_c_true.met in
let _ := GbtDevelopable.Section_5_3_proofs.eq_5_17.proved in
let _ := GbtDevelopable.Section_5_3_proofs.eq_5_17.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_sufficient.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_necessary_families.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_necessary.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_sufficient.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_sheets.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_true_curvature.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s1.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_families.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s2_surfaces.refuted in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s3.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s4.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_s5.met in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.proved in
let _ := GbtDevelopable.Section_5_4_proofs.alg_5_4_iterate.met in
let _ := GbtDevelopable.Section_5_5_proofs.eq_5_18.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_1_construct.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_shape.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_1_shape_combined_surface.refuted in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q02.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q12.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_Q22.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_gamma_one.met in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_surfaces.refuted in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_gap_drawn_pieces.met in
let _ := GbtDevelopable.Section_5_proofs.eq_5_1.proved in
let _ := GbtDevelopable.Section_5_proofs.eq_5_1.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_a.proved in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_a.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.proved in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_after_division.refuted in
let _ := GbtDevelopable.Section_5_proofs.eq_5_2.proved in
let _ := GbtDevelopable.Section_5_proofs.eq_5_2.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_a.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_a.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_b.refuted in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_all.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_all.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_1.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_1.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_2.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_2.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f0.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f1.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f2.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero_literal.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_Definition_1.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_3.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_3.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_4.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_4.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.met in
let _ := GbtSurfaces.Section_2_2_proofs.def_2_points_one_letter.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.proved in
let _ := GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_3.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_3.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_setting.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_setting.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_1.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_2.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_a.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_b.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_when.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_when.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_a.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_b.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a2.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_c1.met in
let _ := GbtSurfaces.Section_2_3_proofs.eq_7.proved in
let _ := GbtSurfaces.Section_2_3_proofs.eq_7.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_i.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_i.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_2.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_2.met in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_extending.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_parameters.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_parameters.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_2.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_2.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_3.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_3.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_4.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_4.met in
let _ := GbtSurfaces.Section_3_1_proofs.thm_3.proved in
let _ := GbtSurfaces.Section_3_1_proofs.thm_3.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met in
let _ := GbtSurfaces.Section_3_1_proofs.alg_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.alg_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_normal.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_13.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_13.met in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_14.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_14.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_15.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_15.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_1.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_1.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_16.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_16.met in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.met in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_literal.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_0.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_0.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_1.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_1.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_as_printed.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_true.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_true.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_defect.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_defect.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_tensor_as_printed.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_tensor_as_printed.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_tensor_with_f_l.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_b.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_b.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_as_printed.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_as_printed.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_with_f_l.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_b.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_b.met in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.proved in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.met in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_b_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_b_there_are_such_connections.proved in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_b_there_are_such_connections.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_literal.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_as_printed.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_profile.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_profile.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_21.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_21.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_22.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_22.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_5.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_5.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_23.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_23.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_parameters.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_parameters.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_24.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_24.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_unity.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_1.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_1.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_c.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_c.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_3.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_3.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_c.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_c.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_a.proved in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_a.met in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_b_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.proved in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_26.proved in
let _ := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved in
let _ := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.proved in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.met in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.eq_27.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_27.met in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_29.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_29.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_30.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_30.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_2.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_2.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_3.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_3.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_4.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_4.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_5.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_5.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.met in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_a.met in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_b_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_b_there_are_such_connections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_b_there_are_such_connections.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_components.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_components.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_T.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_T.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_circle.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_circle.met in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_complete.proved in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_complete.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_34.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_34.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_b.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_b.met in
let _ := GbtSurfaces.Section_3_6_proofs.alg_6.proved in
let _ := GbtSurfaces.Section_3_6_proofs.alg_6.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_35.proved in
let _ := GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.proved in
let _ := GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_36.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_36.met in
let _ := GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_tensor_as_printed.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_tensor_as_printed.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_tensor_with_f_l.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_d.refuted in
let _ := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved in
let _ := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1a.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1a.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_solvable.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3.refuted in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H1.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H3.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H3.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H4.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H5.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H5.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_4.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_control.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_control.met in
let _ := HermiteDevelopable.Section_2_proofs.fig_1b_middle.proved in
let _ := HermiteDevelopable.Section_2_proofs.fig_1b_middle.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B.refuted in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_det.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.met in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_slip.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_factored.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.met in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.met in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B.refuted in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_det.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.met in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation.refuted in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.met in
let _ := HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1_normal.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1_normal.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_2.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_2_lincomb.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.met in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime.refuted in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_must.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_must.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_b.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_edge.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_edge.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_direction.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_true.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3a.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3a.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3b.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3b.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_any.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_exact.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_exact.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_any.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.met in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_4.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_4.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_cone.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_cone.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_1.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_1.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_designed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_image.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_image.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_only.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_only.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_in_plane.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_in_plane.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_r0.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_r0.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_I1.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_I1.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_w.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_w.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_s.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_s.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_3.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_3.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_ru.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_ru.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_oblique.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0u.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_ru.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1u.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_stated_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_stated_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_developable_computed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_developable_printed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_developable.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_twist.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_a.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_a.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_b.refuted in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_speed.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_length.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature.met in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip.refuted in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.met in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_load.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_conformal.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_minimal.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_gauss.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_regular.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_ends.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_ends.met in
let _ := Hyperbolic.Part_Curves_proofs.curve_d1.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_d1.met in
let _ := Hyperbolic.Part_Curves_proofs.curve_d1_slip.refuted in
let _ := Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_d1_slip_corrected.met in
let _ := Hyperbolic.Part_Curves_proofs.curve_d2.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_d2.met in
let _ := Hyperbolic.Part_Curves_proofs.curve_middle.proved in
let _ := Hyperbolic.Part_Curves_proofs.curve_middle.met in
let _ := Hyperbolic.Part_Curves_proofs.curve_middle_slip.refuted in
let _ := Hyperbolic.Part_Curves_proofs.shape_ends.proved in
let _ := Hyperbolic.Part_Curves_proofs.shape_ends.met in
let _ := Hyperbolic.Part_Curves_proofs.shape_d1.proved in
let _ := Hyperbolic.Part_Curves_proofs.shape_d1.met in
let _ := Hyperbolic.Part_Curves_proofs.shape_d1_slip.refuted in
let _ := Hyperbolic.Part_Curves_proofs.shape_slope.proved in
let _ := Hyperbolic.Part_Curves_proofs.shape_slope.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C1.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C1.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip.refuted in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C2.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C2.met in
let _ := Hyperbolic.Part_Joins_proofs.shape_join.proved in
let _ := Hyperbolic.Part_Joins_proofs.shape_join.met in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_angle.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_angle_slip.refuted in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_regular.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.met in
let _ := Hyperbolic.Part_Parts_proofs.fn_half.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_half_slip.refuted in
let _ := Hyperbolic.Part_Parts_proofs.fn_half_slip_corrected.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_third.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_tangent.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_tangent.met in
let _ := Hyperbolic.Part_Rates_proofs.fn_rate.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_rate.met in
let _ := Hyperbolic.Part_Rates_proofs.fn_growth.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_bell.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped_slip.refuted in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped_slip_corrected.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_norm.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend.met in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend_slip.refuted in
let _ := Hyperbolic.Part_Roots_proofs.tractrix_norm.proved in
let _ := Hyperbolic.Part_Roots_proofs.tractrix_norm.met in
let _ := Hyperbolic.Part_Signs_proofs.fn_positive.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_strict_slip.refuted in
let _ := Hyperbolic.Part_Signs_proofs.fn_bounded.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_bounded.met in
let _ := Hyperbolic.Part_Signs_proofs.fn_tangent_line.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_unit.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_unit.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_slope.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_slope.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torsion.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torsion.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torse.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torse.met in
let _ := Hyperbolic.Part_Sums_proofs.fn_pythagoras.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip.refuted in
let _ := Hyperbolic.Part_Sums_proofs.fn_sum.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_difference.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_unity.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_unity.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_symmetry.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_symmetry.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_ends.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_ends.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_nonnegative.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_nonnegative.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_nonnegative_slip.refuted in
let _ := Hyperbolic.Part_The_proofs.quadratic_decreasing.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_decreasing.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_largest.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_largest.met in
let _ := Hyperbolic.Part_The_proofs.quadratic_space.proved in
let _ := Hyperbolic.Part_The_proofs.quadratic_space.met in
let _ := Hyperbolic.Part_The_proofs.shape_unity.proved in
let _ := Hyperbolic.Part_The_proofs.shape_unity.met in
let _ := Hyperbolic.Part_The_proofs.shape_symmetry.proved in
let _ := Hyperbolic.Part_The_proofs.shape_symmetry.met in
let _ := Hyperbolic.Part_The_proofs.shape_nonnegative.proved in
let _ := Hyperbolic.Part_The_proofs.shape_nonnegative.met in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_pull.proved in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_pull.met in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_speed.proved in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_speed.met in
let _ := Hyperbolic.Part_Values_proofs.fn_number.proved in
let _ := Hyperbolic.Part_Values_proofs.fn_value.proved in
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
let _ := Splines.Part_B_proofs.uniform_bezier.proved in
let _ := Splines.Part_B_proofs.uniform_bezier.met in
let _ := Splines.Part_Cubic_proofs.uniform_cubic.proved in
let _ := Splines.Part_Cubic_proofs.uniform_cubic.met in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip.refuted in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.proved in
let _ := Splines.Part_Cubic_proofs.uniform_cubic_slip_corrected.met in
let _ := Splines.Part_Derivatives_proofs.uniform_rate.proved in
let _ := Splines.Part_Derivatives_proofs.uniform_rate.met in
let _ := Splines.Part_Derivatives_proofs.knots_rate.proved in
let _ := Splines.Part_Derivatives_proofs.knots_rate.met in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip.refuted in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.proved in
let _ := Splines.Part_Derivatives_proofs.knots_rate_slip_corrected.met in
let _ := Splines.Part_One_proofs.clamped_bernstein.proved in
let _ := Splines.Part_Partition_proofs.uniform_unity.proved in
let _ := Splines.Part_Partition_proofs.uniform_unity.met in
let _ := Splines.Part_Partition_proofs.knots_unity_quadratic.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_quadratic.met in
let _ := Splines.Part_Partition_proofs.knots_unity_cubic.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_cubic.met in
let _ := Splines.Part_Partition_proofs.knots_unity_equal.proved in
let _ := Splines.Part_Partition_proofs.knots_unity_equal.met in
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
let _ := Splines.Part_Quadratic_proofs.uniform_quadratic.proved in
let _ := Splines.Part_Quadratic_proofs.uniform_quadratic.met in
let _ := Splines.Part_Shape_proofs.uniform_line.proved in
let _ := Splines.Part_Shape_proofs.uniform_line.met in
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
let _ := Splines.Part_Symmetry_proofs.uniform_symmetry.proved in
let _ := Splines.Part_Symmetry_proofs.uniform_symmetry.met in
let _ := Splines.Part_The_proofs.knots_linear.proved in
let _ := Splines.Part_The_proofs.knots_linear.met in
let _ := Splines.Part_The_proofs.knots_quadratic.proved in
let _ := Splines.Part_The_proofs.knots_quadratic.met in
let _ := Splines.Part_The_proofs.knots_quadratic_slip.refuted in
let _ := Splines.Part_The_proofs.knots_quadratic_slip_corrected.proved in
let _ := Splines.Part_The_proofs.knots_quadratic_slip_corrected.met in
let _ := Splines.Part_The_proofs.knots_span.proved in
let _ := Splines.Part_The_proofs.knots_span.met in
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
let _ := Torses.Part_Central_proofs.striction_shortest.proved in
let _ := Torses.Part_Central_proofs.striction_shortest.met in
let _ := Torses.Part_Central_proofs.striction_growth.proved in
let _ := Torses.Part_Central_proofs.striction_length.proved in
let _ := Torses.Part_Central_proofs.striction_length.met in
let _ := Torses.Part_Central_proofs.striction_scaled.proved in
let _ := Torses.Part_Central_proofs.striction_scaled.met in
let _ := Torses.Part_Central_proofs.striction_unit.proved in
let _ := Torses.Part_Central_proofs.striction_unit.met in
let _ := Torses.Part_Central_proofs.striction_unit_slip.refuted in
let _ := Torses.Part_Cones_proofs.cone_torse.proved in
let _ := Torses.Part_Cones_proofs.cone_apex.proved in
let _ := Torses.Part_Cones_proofs.cone_apex_slip.refuted in
let _ := Torses.Part_Cones_proofs.planes_cone.proved in
let _ := Torses.Part_Cones_proofs.planes_cone.met in
let _ := Torses.Part_Constant_proofs.slope_torse.proved in
let _ := Torses.Part_Constant_proofs.slope_torse.met in
let _ := Torses.Part_Contact_proofs.ruled_touch.proved in
let _ := Torses.Part_Contact_proofs.ruled_touch.met in
let _ := Torses.Part_Curvature_proofs.ruled_asymptotic.proved in
let _ := Torses.Part_Curvature_proofs.ruled_mixed.proved in
let _ := Torses.Part_Curvature_proofs.ruled_lagrange.proved in
let _ := Torses.Part_Curvature_proofs.ruled_gauss.proved in
let _ := Torses.Part_Curvature_proofs.ruled_gauss_curvature.proved in
let _ := Torses.Part_Curvature_proofs.ruled_gauss_curvature.met in
let _ := Torses.Part_Curvature_proofs.ruled_gauss_sign.proved in
let _ := Torses.Part_Curvature_proofs.ruled_gauss_slip.refuted in
let _ := Torses.Part_Curvature_proofs.ruled_gauss_slip_corrected.proved in
let _ := Torses.Part_Curves_proofs.curve_chain.proved in
let _ := Torses.Part_Curves_proofs.curve_chain_slip.refuted in
let _ := Torses.Part_Curves_proofs.curve_curvature.proved in
let _ := Torses.Part_Curves_proofs.curve_curvature.met in
let _ := Torses.Part_Curves_proofs.curve_torsion.proved in
let _ := Torses.Part_Curves_proofs.curve_torsion.met in
let _ := Torses.Part_Curves_proofs.curve_straight.proved in
let _ := Torses.Part_Curves_proofs.curve_straight.met in
let _ := Torses.Part_Cylinders_proofs.cylinder_torse.proved in
let _ := Torses.Part_Cylinders_proofs.cylinder_torse.met in
let _ := Torses.Part_Cylinders_proofs.cylinder_normal.proved in
let _ := Torses.Part_Cylinders_proofs.cylinder_normal.met in
let _ := Torses.Part_Cylinders_proofs.cylinder_converse_slip.refuted in
let _ := Torses.Part_Distribution_proofs.striction_parameter.proved in
let _ := Torses.Part_Distribution_proofs.striction_parameter.met in
let _ := Torses.Part_Distribution_proofs.striction_curvature.proved in
let _ := Torses.Part_Distribution_proofs.striction_curvature.met in
let _ := Torses.Part_Edge_proofs.regression_singular.proved in
let _ := Torses.Part_Edge_proofs.regression_singular.met in
let _ := Torses.Part_Edge_proofs.regression_tangent.proved in
let _ := Torses.Part_Edge_proofs.regression_tangent.met in
let _ := Torses.Part_Edge_proofs.regression_tangent_slip.refuted in
let _ := Torses.Part_Edge_proofs.planes_edge.proved in
let _ := Torses.Part_Edge_proofs.planes_edge.met in
let _ := Torses.Part_Edge_proofs.planes_edge_in.proved in
let _ := Torses.Part_Edge_proofs.planes_edge_in.met in
let _ := Torses.Part_Edge_proofs.planes_edge_tangent.proved in
let _ := Torses.Part_Edge_proofs.planes_edge_tangent.met in
let _ := Torses.Part_Edge_proofs.planes_edge_osculating.proved in
let _ := Torses.Part_Edge_proofs.planes_edge_osculating.met in
let _ := Torses.Part_Freedom_proofs.ruled_directrix.proved in
let _ := Torses.Part_Freedom_proofs.ruled_scaled.proved in
let _ := Torses.Part_Freedom_proofs.ruled_parameter.proved in
let _ := Torses.Part_Freedom_proofs.ruled_parameter_slip.refuted in
let _ := Torses.Part_Freedom_proofs.ruled_ends.proved in
let _ := Torses.Part_Freedom_proofs.ruled_start.proved in
let _ := Torses.Part_Normal_proofs.ruled_normal.proved in
let _ := Torses.Part_Normal_proofs.ruled_turn.proved in
let _ := Torses.Part_Normal_proofs.ruled_turn_slip.refuted in
let _ := Torses.Part_Normal_proofs.ruled_turn_slip_corrected.proved in
let _ := Torses.Part_Normal_proofs.ruled_chasles.proved in
let _ := Torses.Part_Polar_proofs.polar_first.proved in
let _ := Torses.Part_Polar_proofs.polar_second.proved in
let _ := Torses.Part_Polar_proofs.polar_second_slip.refuted in
let _ := Torses.Part_Polar_proofs.polar_second_slip_corrected.proved in
let _ := Torses.Part_Rectifying_proofs.rectifying_contains.proved in
let _ := Torses.Part_Rectifying_proofs.rectifying_geodesic.proved in
let _ := Torses.Part_Rulings_proofs.planes_ruling.proved in
let _ := Torses.Part_Rulings_proofs.planes_turn.proved in
let _ := Torses.Part_Rulings_proofs.planes_turn_slip.refuted in
let _ := Torses.Part_Rulings_proofs.planes_turn_slip_corrected.proved in
let _ := Torses.Part_Rulings_proofs.planes_cylinder.proved in
let _ := Torses.Part_Rulings_proofs.planes_cylinder.met in
let _ := Torses.Part_Rulings_proofs.planes_scaled.proved in
let _ := Torses.Part_Rulings_proofs.planes_scaled_slip.refuted in
let _ := Torses.Part_Rulings_proofs.planes_scaled_slip_corrected.proved in
let _ := Torses.Part_Rulings_proofs.planes_dual.proved in
let _ := Torses.Part_Rulings_proofs.planes_dual.met in
let _ := Torses.Part_Skew_proofs.binormals_skew.proved in
let _ := Torses.Part_Skew_proofs.binormals_skew.met in
let _ := Torses.Part_Skew_proofs.conoid_skew.proved in
let _ := Torses.Part_Tangent_proofs.tangents_torse.proved in
let _ := Torses.Part_Tangent_proofs.tangents_normal.proved in
let _ := Torses.Part_Tangent_proofs.tangents_edge.proved in
let _ := Torses.Part_Tangent_proofs.tangents_osculating.proved in
let _ := Torses.Part_Tangent_proofs.tangents_metric.proved in
let _ := Torses.Part_Tangent_proofs.tangents_metric.met in
let _ := Torses.Part_Tangent_proofs.tangents_metric_slip.refuted in
let _ := Torses.Part_Torses_proofs.ruled_torse_sufficient.proved in
let _ := Torses.Part_Torses_proofs.ruled_torse_sufficient.met in
let _ := Torses.Part_Torses_proofs.ruled_torse_necessary.proved in
let _ := Torses.Part_Torses_proofs.ruled_torse_necessary.met in
let _ := Torses.Part_Torses_proofs.ruled_rodrigues.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_speed.met in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_curvature.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_curvature.met in
let _ := Trigonometric.Part_Circles_proofs.quadratic_circle.proved in
let _ := Trigonometric.Part_Circles_proofs.quadratic_circle.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_ends.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_ends.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d2.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d2.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_speed.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_speed.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_regular.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_regular.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_slope.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_slope.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip.refuted in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip_corrected.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_bend.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_bend.met in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_curvature.proved in
let _ := Trigonometric.Part_Cycloid_proofs.cycloid_curvature.met in
let _ := Trigonometric.Part_Half_proofs.angle_half_sine.proved in
let _ := Trigonometric.Part_Half_proofs.angle_half_cosine.proved in
let _ := Trigonometric.Part_Half_proofs.angle_half_slip.refuted in
let _ := Trigonometric.Part_Half_proofs.angle_half_slip_corrected.proved in
let _ := Trigonometric.Part_Half_proofs.half_unity.proved in
let _ := Trigonometric.Part_Half_proofs.half_unity.met in
let _ := Trigonometric.Part_Half_proofs.half_middle.proved in
let _ := Trigonometric.Part_Half_proofs.half_middle.met in
let _ := Trigonometric.Part_Half_proofs.half_sine.proved in
let _ := Trigonometric.Part_Half_proofs.half_sine.met in
let _ := Trigonometric.Part_Half_proofs.half_cosine.proved in
let _ := Trigonometric.Part_Half_proofs.half_cosine.met in
let _ := Trigonometric.Part_Half_proofs.half_cosine_slip.refuted in
let _ := Trigonometric.Part_Half_proofs.half_powers.proved in
let _ := Trigonometric.Part_Half_proofs.half_powers.met in
let _ := Trigonometric.Part_Half_proofs.half_d1.proved in
let _ := Trigonometric.Part_Half_proofs.half_d1.met in
let _ := Trigonometric.Part_Half_proofs.half_d1_slip.refuted in
let _ := Trigonometric.Part_Half_proofs.half_d1_slip_corrected.proved in
let _ := Trigonometric.Part_Half_proofs.half_d1_slip_corrected.met in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew.met in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted in
let _ := Trigonometric.Part_Helix_proofs.helix_speed.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_speed.met in
let _ := Trigonometric.Part_Helix_proofs.helix_torsion.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_torsion.met in
let _ := Trigonometric.Part_Helix_proofs.helix_curvature.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_curvature.met in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join.proved in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join.met in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met in
let _ := Trigonometric.Part_Known_proofs.angle_known.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_third.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_parts.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_rate.proved in
let _ := Trigonometric.Part_Roots_proofs.helix_length.proved in
let _ := Trigonometric.Part_Roots_proofs.helix_length.met in
let _ := Trigonometric.Part_Roots_proofs.helix_bend.proved in
let _ := Trigonometric.Part_Roots_proofs.helix_bend.met in
let _ := Trigonometric.Part_Roots_proofs.helix_bend_slip.refuted in
let _ := Trigonometric.Part_Roots_proofs.cylinder_normal.proved in
let _ := Trigonometric.Part_Roots_proofs.cylinder_normal.met in
let _ := Trigonometric.Part_Roots_proofs.cylinder_offset.proved in
let _ := Trigonometric.Part_Roots_proofs.cylinder_offset.met in
let _ := Trigonometric.Part_Signs_proofs.angle_first.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_first.met in
let _ := Trigonometric.Part_Signs_proofs.angle_first_turned.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_first_turned.met in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric.met in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted in
let _ := Trigonometric.Part_Signs_proofs.angle_turn.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_torse.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_torse.met in
let _ := Trigonometric.Part_Tangent_proofs.helix_normal.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_normal.met in
let _ := Trigonometric.Part_Tangent_proofs.helix_regular.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_regular.met in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent.proved in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent.met in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met in
let _ := Trigonometric.Part_The_proofs.quadratic_middle.proved in
let _ := Trigonometric.Part_The_proofs.quadratic_middle.met in
let _ := Trigonometric.Part_The_proofs.quadratic_nonnegative.proved in
let _ := Trigonometric.Part_The_proofs.quadratic_nonnegative.met in
let _ := Trigonometric.Part_The_proofs.quadratic_nonnegative_slip.refuted in
let _ := Trigonometric.Part_The_proofs.quadratic_symmetry.proved in
let _ := Trigonometric.Part_The_proofs.quadratic_symmetry.met in
let _ := Trigonometric.Part_The_proofs.quadratic_decreasing.proved in
let _ := Trigonometric.Part_The_proofs.quadratic_decreasing.met in
I.
Print Assumptions all_theorems.
