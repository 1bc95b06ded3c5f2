(* The kernel's word: each theorem has the type of its statement. *)
From Hyperbolic Require Part_Catenary_printed Part_Catenary_printed_proofs.
From Hyperbolic Require Part_Catenary Part_Catenary_proofs.
From Hyperbolic Require Part_Catenoid_printed Part_Catenoid_printed_proofs.
From Hyperbolic Require Part_Catenoid Part_Catenoid_proofs.
From Hyperbolic Require Part_Curves_printed Part_Curves_printed_proofs.
From Hyperbolic Require Part_Curves Part_Curves_proofs.
From Hyperbolic Require Part_Hyperbolas_printed Part_Hyperbolas_printed_proofs.
From Hyperbolic Require Part_Hyperbolas Part_Hyperbolas_proofs.
From Hyperbolic Require Part_Joins_printed Part_Joins_printed_proofs.
From Hyperbolic Require Part_Joins Part_Joins_proofs.
From Hyperbolic Require Part_Logarithmic_printed Part_Logarithmic_printed_proofs.
From Hyperbolic Require Part_Logarithmic Part_Logarithmic_proofs.
From Hyperbolic Require Part_Parts_printed Part_Parts_printed_proofs.
From Hyperbolic Require Part_Parts Part_Parts_proofs.
From Hyperbolic Require Part_Rates_printed Part_Rates_printed_proofs.
From Hyperbolic Require Part_Rates Part_Rates_proofs.
From Hyperbolic Require Part_Roots_printed Part_Roots_printed_proofs.
From Hyperbolic Require Part_Roots Part_Roots_proofs.
From Hyperbolic Require Part_Signs_printed Part_Signs_printed_proofs.
From Hyperbolic Require Part_Signs Part_Signs_proofs.
From Hyperbolic Require Part_Spiral_printed Part_Spiral_printed_proofs.
From Hyperbolic Require Part_Spiral Part_Spiral_proofs.
From Hyperbolic Require Part_Sums_printed Part_Sums_printed_proofs.
From Hyperbolic Require Part_Sums Part_Sums_proofs.
From Hyperbolic Require Part_The_printed Part_The_printed_proofs.
From Hyperbolic Require Part_The Part_The_proofs.
From Hyperbolic Require Part_Tractrix_printed Part_Tractrix_printed_proofs.
From Hyperbolic Require Part_Tractrix Part_Tractrix_proofs.
From Hyperbolic Require Part_Values_printed Part_Values_printed_proofs.
From Hyperbolic Require Part_Values Part_Values_proofs.
Check (Part_Catenary_printed_proofs.catenary_speed.proved : Part_Catenary_printed.catenary_speed.statement).
Check (Part_Catenary_printed_proofs.catenary_length.proved : Part_Catenary_printed.catenary_length.statement).
Check (Part_Catenary_printed_proofs.catenary_curvature.proved : Part_Catenary_printed.catenary_curvature.statement).
Check (Part_Catenary_printed_proofs.catenary_curvature.met : Part_Catenary_printed.catenary_curvature.instance).
Check (Part_Catenary_printed_proofs.catenary_curvature_slip.refuted : ~ Part_Catenary_printed.catenary_curvature_slip.statement).
Check (Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.proved : Part_Catenary_printed.catenary_curvature_slip_corrected.statement).
Check (Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.met : Part_Catenary_printed.catenary_curvature_slip_corrected.instance).
Check (Part_Catenary_printed_proofs.catenary_load.proved : Part_Catenary_printed.catenary_load.statement).
Check (Part_Catenary_proofs.catenary_speed.proved : Part_Catenary.catenary_speed.statement).
Check (Part_Catenary_proofs.catenary_length.proved : Part_Catenary.catenary_length.statement).
Check (Part_Catenary_proofs.catenary_curvature.proved : Part_Catenary.catenary_curvature.statement).
Check (Part_Catenary_proofs.catenary_curvature.met : Part_Catenary.catenary_curvature.instance).
Check (Part_Catenary_proofs.catenary_curvature_slip.refuted : ~ Part_Catenary.catenary_curvature_slip.statement).
Check (Part_Catenary_proofs.catenary_curvature_slip_corrected.proved : Part_Catenary.catenary_curvature_slip_corrected.statement).
Check (Part_Catenary_proofs.catenary_curvature_slip_corrected.met : Part_Catenary.catenary_curvature_slip_corrected.instance).
Check (Part_Catenary_proofs.catenary_load.proved : Part_Catenary.catenary_load.statement).
Check (Part_Catenoid_printed_proofs.catenoid_conformal.proved : Part_Catenoid_printed.catenoid_conformal.statement).
Check (Part_Catenoid_printed_proofs.catenoid_minimal.proved : Part_Catenoid_printed.catenoid_minimal.statement).
Check (Part_Catenoid_printed_proofs.catenoid_gauss.proved : Part_Catenoid_printed.catenoid_gauss.statement).
Check (Part_Catenoid_printed_proofs.catenoid_regular.proved : Part_Catenoid_printed.catenoid_regular.statement).
Check (Part_Catenoid_proofs.catenoid_conformal.proved : Part_Catenoid.catenoid_conformal.statement).
Check (Part_Catenoid_proofs.catenoid_minimal.proved : Part_Catenoid.catenoid_minimal.statement).
Check (Part_Catenoid_proofs.catenoid_gauss.proved : Part_Catenoid.catenoid_gauss.statement).
Check (Part_Catenoid_proofs.catenoid_regular.proved : Part_Catenoid.catenoid_regular.statement).
Check (Part_Curves_printed_proofs.curve_ends.proved : Part_Curves_printed.curve_ends.statement).
Check (Part_Curves_printed_proofs.curve_ends.met : Part_Curves_printed.curve_ends.instance).
Check (Part_Curves_printed_proofs.curve_d1.proved : Part_Curves_printed.curve_d1.statement).
Check (Part_Curves_printed_proofs.curve_d1.met : Part_Curves_printed.curve_d1.instance).
Check (Part_Curves_printed_proofs.curve_d1_slip.refuted : ~ Part_Curves_printed.curve_d1_slip.statement).
Check (Part_Curves_printed_proofs.curve_d1_slip_corrected.proved : Part_Curves_printed.curve_d1_slip_corrected.statement).
Check (Part_Curves_printed_proofs.curve_d1_slip_corrected.met : Part_Curves_printed.curve_d1_slip_corrected.instance).
Check (Part_Curves_printed_proofs.curve_d2.proved : Part_Curves_printed.curve_d2.statement).
Check (Part_Curves_printed_proofs.curve_d2.met : Part_Curves_printed.curve_d2.instance).
Check (Part_Curves_printed_proofs.curve_middle.proved : Part_Curves_printed.curve_middle.statement).
Check (Part_Curves_printed_proofs.curve_middle.met : Part_Curves_printed.curve_middle.instance).
Check (Part_Curves_printed_proofs.curve_middle_slip.refuted : ~ Part_Curves_printed.curve_middle_slip.statement).
Check (Part_Curves_printed_proofs.shape_ends.proved : Part_Curves_printed.shape_ends.statement).
Check (Part_Curves_printed_proofs.shape_ends.met : Part_Curves_printed.shape_ends.instance).
Check (Part_Curves_printed_proofs.shape_d1.proved : Part_Curves_printed.shape_d1.statement).
Check (Part_Curves_printed_proofs.shape_d1.met : Part_Curves_printed.shape_d1.instance).
Check (Part_Curves_printed_proofs.shape_d1_slip.refuted : ~ Part_Curves_printed.shape_d1_slip.statement).
Check (Part_Curves_printed_proofs.shape_slope.proved : Part_Curves_printed.shape_slope.statement).
Check (Part_Curves_printed_proofs.shape_slope.met : Part_Curves_printed.shape_slope.instance).
Check (Part_Curves_proofs.curve_ends.proved : Part_Curves.curve_ends.statement).
Check (Part_Curves_proofs.curve_ends.met : Part_Curves.curve_ends.instance).
Check (Part_Curves_proofs.curve_d1.proved : Part_Curves.curve_d1.statement).
Check (Part_Curves_proofs.curve_d1.met : Part_Curves.curve_d1.instance).
Check (Part_Curves_proofs.curve_d1_slip.refuted : ~ Part_Curves.curve_d1_slip.statement).
Check (Part_Curves_proofs.curve_d1_slip_corrected.proved : Part_Curves.curve_d1_slip_corrected.statement).
Check (Part_Curves_proofs.curve_d1_slip_corrected.met : Part_Curves.curve_d1_slip_corrected.instance).
Check (Part_Curves_proofs.curve_d2.proved : Part_Curves.curve_d2.statement).
Check (Part_Curves_proofs.curve_d2.met : Part_Curves.curve_d2.instance).
Check (Part_Curves_proofs.curve_middle.proved : Part_Curves.curve_middle.statement).
Check (Part_Curves_proofs.curve_middle.met : Part_Curves.curve_middle.instance).
Check (Part_Curves_proofs.curve_middle_slip.refuted : ~ Part_Curves.curve_middle_slip.statement).
Check (Part_Curves_proofs.shape_ends.proved : Part_Curves.shape_ends.statement).
Check (Part_Curves_proofs.shape_ends.met : Part_Curves.shape_ends.instance).
Check (Part_Curves_proofs.shape_d1.proved : Part_Curves.shape_d1.statement).
Check (Part_Curves_proofs.shape_d1.met : Part_Curves.shape_d1.instance).
Check (Part_Curves_proofs.shape_d1_slip.refuted : ~ Part_Curves.shape_d1_slip.statement).
Check (Part_Curves_proofs.shape_slope.proved : Part_Curves.shape_slope.statement).
Check (Part_Curves_proofs.shape_slope.met : Part_Curves.shape_slope.instance).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola.proved : Part_Hyperbolas_printed.curve_hyperbola.statement).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola.met : Part_Hyperbolas_printed.curve_hyperbola.instance).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.proved : Part_Hyperbolas_printed.curve_hyperbola_implicit.statement).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.met : Part_Hyperbolas_printed.curve_hyperbola_implicit.instance).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.proved : Part_Hyperbolas_printed.curve_hyperbola_tangent.statement).
Check (Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.met : Part_Hyperbolas_printed.curve_hyperbola_tangent.instance).
Check (Part_Hyperbolas_proofs.curve_hyperbola.proved : Part_Hyperbolas.curve_hyperbola.statement).
Check (Part_Hyperbolas_proofs.curve_hyperbola.met : Part_Hyperbolas.curve_hyperbola.instance).
Check (Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved : Part_Hyperbolas.curve_hyperbola_implicit.statement).
Check (Part_Hyperbolas_proofs.curve_hyperbola_implicit.met : Part_Hyperbolas.curve_hyperbola_implicit.instance).
Check (Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved : Part_Hyperbolas.curve_hyperbola_tangent.statement).
Check (Part_Hyperbolas_proofs.curve_hyperbola_tangent.met : Part_Hyperbolas.curve_hyperbola_tangent.instance).
Check (Part_Joins_printed_proofs.join_C1.proved : Part_Joins_printed.join_C1.statement).
Check (Part_Joins_printed_proofs.join_C1.met : Part_Joins_printed.join_C1.instance).
Check (Part_Joins_printed_proofs.join_C1_slip.refuted : ~ Part_Joins_printed.join_C1_slip.statement).
Check (Part_Joins_printed_proofs.join_C1_slip_corrected.proved : Part_Joins_printed.join_C1_slip_corrected.statement).
Check (Part_Joins_printed_proofs.join_C1_slip_corrected.met : Part_Joins_printed.join_C1_slip_corrected.instance).
Check (Part_Joins_printed_proofs.join_C2.proved : Part_Joins_printed.join_C2.statement).
Check (Part_Joins_printed_proofs.join_C2.met : Part_Joins_printed.join_C2.instance).
Check (Part_Joins_printed_proofs.shape_join.proved : Part_Joins_printed.shape_join.statement).
Check (Part_Joins_printed_proofs.shape_join.met : Part_Joins_printed.shape_join.instance).
Check (Part_Joins_proofs.join_C1.proved : Part_Joins.join_C1.statement).
Check (Part_Joins_proofs.join_C1.met : Part_Joins.join_C1.instance).
Check (Part_Joins_proofs.join_C1_slip.refuted : ~ Part_Joins.join_C1_slip.statement).
Check (Part_Joins_proofs.join_C1_slip_corrected.proved : Part_Joins.join_C1_slip_corrected.statement).
Check (Part_Joins_proofs.join_C1_slip_corrected.met : Part_Joins.join_C1_slip_corrected.instance).
Check (Part_Joins_proofs.join_C2.proved : Part_Joins.join_C2.statement).
Check (Part_Joins_proofs.join_C2.met : Part_Joins.join_C2.instance).
Check (Part_Joins_proofs.shape_join.proved : Part_Joins.shape_join.statement).
Check (Part_Joins_proofs.shape_join.met : Part_Joins.shape_join.instance).
Check (Part_Logarithmic_printed_proofs.spiral_angle.proved : Part_Logarithmic_printed.spiral_angle.statement).
Check (Part_Logarithmic_printed_proofs.spiral_angle_slip.refuted : ~ Part_Logarithmic_printed.spiral_angle_slip.statement).
Check (Part_Logarithmic_printed_proofs.spiral_regular.proved : Part_Logarithmic_printed.spiral_regular.statement).
Check (Part_Logarithmic_printed_proofs.spiral_curvature.proved : Part_Logarithmic_printed.spiral_curvature.statement).
Check (Part_Logarithmic_printed_proofs.spiral_curvature.met : Part_Logarithmic_printed.spiral_curvature.instance).
Check (Part_Logarithmic_proofs.spiral_angle.proved : Part_Logarithmic.spiral_angle.statement).
Check (Part_Logarithmic_proofs.spiral_angle_slip.refuted : ~ Part_Logarithmic.spiral_angle_slip.statement).
Check (Part_Logarithmic_proofs.spiral_regular.proved : Part_Logarithmic.spiral_regular.statement).
Check (Part_Logarithmic_proofs.spiral_curvature.proved : Part_Logarithmic.spiral_curvature.statement).
Check (Part_Logarithmic_proofs.spiral_curvature.met : Part_Logarithmic.spiral_curvature.instance).
Check (Part_Parts_printed_proofs.fn_half.proved : Part_Parts_printed.fn_half.statement).
Check (Part_Parts_printed_proofs.fn_half_slip.refuted : ~ Part_Parts_printed.fn_half_slip.statement).
Check (Part_Parts_printed_proofs.fn_half_slip_corrected.proved : Part_Parts_printed.fn_half_slip_corrected.statement).
Check (Part_Parts_printed_proofs.fn_third.proved : Part_Parts_printed.fn_third.statement).
Check (Part_Parts_printed_proofs.fn_tangent.proved : Part_Parts_printed.fn_tangent.statement).
Check (Part_Parts_printed_proofs.fn_tangent.met : Part_Parts_printed.fn_tangent.instance).
Check (Part_Parts_proofs.fn_half.proved : Part_Parts.fn_half.statement).
Check (Part_Parts_proofs.fn_half_slip.refuted : ~ Part_Parts.fn_half_slip.statement).
Check (Part_Parts_proofs.fn_half_slip_corrected.proved : Part_Parts.fn_half_slip_corrected.statement).
Check (Part_Parts_proofs.fn_third.proved : Part_Parts.fn_third.statement).
Check (Part_Parts_proofs.fn_tangent.proved : Part_Parts.fn_tangent.statement).
Check (Part_Parts_proofs.fn_tangent.met : Part_Parts.fn_tangent.instance).
Check (Part_Rates_printed_proofs.fn_rate.proved : Part_Rates_printed.fn_rate.statement).
Check (Part_Rates_printed_proofs.fn_rate.met : Part_Rates_printed.fn_rate.instance).
Check (Part_Rates_printed_proofs.fn_growth.proved : Part_Rates_printed.fn_growth.statement).
Check (Part_Rates_printed_proofs.fn_bell.proved : Part_Rates_printed.fn_bell.statement).
Check (Part_Rates_printed_proofs.fn_damped.proved : Part_Rates_printed.fn_damped.statement).
Check (Part_Rates_printed_proofs.fn_damped_slip.refuted : ~ Part_Rates_printed.fn_damped_slip.statement).
Check (Part_Rates_printed_proofs.fn_damped_slip_corrected.proved : Part_Rates_printed.fn_damped_slip_corrected.statement).
Check (Part_Rates_proofs.fn_rate.proved : Part_Rates.fn_rate.statement).
Check (Part_Rates_proofs.fn_rate.met : Part_Rates.fn_rate.instance).
Check (Part_Rates_proofs.fn_growth.proved : Part_Rates.fn_growth.statement).
Check (Part_Rates_proofs.fn_bell.proved : Part_Rates.fn_bell.statement).
Check (Part_Rates_proofs.fn_damped.proved : Part_Rates.fn_damped.statement).
Check (Part_Rates_proofs.fn_damped_slip.refuted : ~ Part_Rates.fn_damped_slip.statement).
Check (Part_Rates_proofs.fn_damped_slip_corrected.proved : Part_Rates.fn_damped_slip_corrected.statement).
Check (Part_Roots_printed_proofs.catenary_norm.proved : Part_Roots_printed.catenary_norm.statement).
Check (Part_Roots_printed_proofs.catenary_bend.proved : Part_Roots_printed.catenary_bend.statement).
Check (Part_Roots_printed_proofs.catenary_bend.met : Part_Roots_printed.catenary_bend.instance).
Check (Part_Roots_printed_proofs.catenary_bend_slip.refuted : ~ Part_Roots_printed.catenary_bend_slip.statement).
Check (Part_Roots_printed_proofs.catenary_bend_slip_corrected.proved : Part_Roots_printed.catenary_bend_slip_corrected.statement).
Check (Part_Roots_printed_proofs.catenary_bend_slip_corrected.met : Part_Roots_printed.catenary_bend_slip_corrected.instance).
Check (Part_Roots_printed_proofs.tractrix_norm.proved : Part_Roots_printed.tractrix_norm.statement).
Check (Part_Roots_printed_proofs.tractrix_norm.met : Part_Roots_printed.tractrix_norm.instance).
Check (Part_Roots_proofs.catenary_norm.proved : Part_Roots.catenary_norm.statement).
Check (Part_Roots_proofs.catenary_bend.proved : Part_Roots.catenary_bend.statement).
Check (Part_Roots_proofs.catenary_bend.met : Part_Roots.catenary_bend.instance).
Check (Part_Roots_proofs.catenary_bend_slip.refuted : ~ Part_Roots.catenary_bend_slip.statement).
Check (Part_Roots_proofs.catenary_bend_slip_corrected.proved : Part_Roots.catenary_bend_slip_corrected.statement).
Check (Part_Roots_proofs.catenary_bend_slip_corrected.met : Part_Roots.catenary_bend_slip_corrected.instance).
Check (Part_Roots_proofs.tractrix_norm.proved : Part_Roots.tractrix_norm.statement).
Check (Part_Roots_proofs.tractrix_norm.met : Part_Roots.tractrix_norm.instance).
Check (Part_Signs_printed_proofs.fn_positive.proved : Part_Signs_printed.fn_positive.statement).
Check (Part_Signs_printed_proofs.fn_strict_slip.refuted : ~ Part_Signs_printed.fn_strict_slip.statement).
Check (Part_Signs_printed_proofs.fn_bounded.proved : Part_Signs_printed.fn_bounded.statement).
Check (Part_Signs_printed_proofs.fn_bounded.met : Part_Signs_printed.fn_bounded.instance).
Check (Part_Signs_printed_proofs.fn_tangent_line.proved : Part_Signs_printed.fn_tangent_line.statement).
Check (Part_Signs_printed_proofs.fn_unit.proved : Part_Signs_printed.fn_unit.statement).
Check (Part_Signs_printed_proofs.fn_unit.met : Part_Signs_printed.fn_unit.instance).
Check (Part_Signs_proofs.fn_positive.proved : Part_Signs.fn_positive.statement).
Check (Part_Signs_proofs.fn_strict_slip.refuted : ~ Part_Signs.fn_strict_slip.statement).
Check (Part_Signs_proofs.fn_bounded.proved : Part_Signs.fn_bounded.statement).
Check (Part_Signs_proofs.fn_bounded.met : Part_Signs.fn_bounded.instance).
Check (Part_Signs_proofs.fn_tangent_line.proved : Part_Signs.fn_tangent_line.statement).
Check (Part_Signs_proofs.fn_unit.proved : Part_Signs.fn_unit.statement).
Check (Part_Signs_proofs.fn_unit.met : Part_Signs.fn_unit.instance).
Check (Part_Spiral_printed_proofs.cone_slope.proved : Part_Spiral_printed.cone_slope.statement).
Check (Part_Spiral_printed_proofs.cone_slope.met : Part_Spiral_printed.cone_slope.instance).
Check (Part_Spiral_printed_proofs.cone_torsion.proved : Part_Spiral_printed.cone_torsion.statement).
Check (Part_Spiral_printed_proofs.cone_torsion.met : Part_Spiral_printed.cone_torsion.instance).
Check (Part_Spiral_printed_proofs.cone_torse.proved : Part_Spiral_printed.cone_torse.statement).
Check (Part_Spiral_printed_proofs.cone_torse.met : Part_Spiral_printed.cone_torse.instance).
Check (Part_Spiral_proofs.cone_slope.proved : Part_Spiral.cone_slope.statement).
Check (Part_Spiral_proofs.cone_slope.met : Part_Spiral.cone_slope.instance).
Check (Part_Spiral_proofs.cone_torsion.proved : Part_Spiral.cone_torsion.statement).
Check (Part_Spiral_proofs.cone_torsion.met : Part_Spiral.cone_torsion.instance).
Check (Part_Spiral_proofs.cone_torse.proved : Part_Spiral.cone_torse.statement).
Check (Part_Spiral_proofs.cone_torse.met : Part_Spiral.cone_torse.instance).
Check (Part_Sums_printed_proofs.fn_pythagoras.proved : Part_Sums_printed.fn_pythagoras.statement).
Check (Part_Sums_printed_proofs.fn_pythagoras_slip.refuted : ~ Part_Sums_printed.fn_pythagoras_slip.statement).
Check (Part_Sums_printed_proofs.fn_pythagoras_slip_corrected.proved : Part_Sums_printed.fn_pythagoras_slip_corrected.statement).
Check (Part_Sums_printed_proofs.fn_sum.proved : Part_Sums_printed.fn_sum.statement).
Check (Part_Sums_printed_proofs.fn_difference.proved : Part_Sums_printed.fn_difference.statement).
Check (Part_Sums_proofs.fn_pythagoras.proved : Part_Sums.fn_pythagoras.statement).
Check (Part_Sums_proofs.fn_pythagoras_slip.refuted : ~ Part_Sums.fn_pythagoras_slip.statement).
Check (Part_Sums_proofs.fn_pythagoras_slip_corrected.proved : Part_Sums.fn_pythagoras_slip_corrected.statement).
Check (Part_Sums_proofs.fn_sum.proved : Part_Sums.fn_sum.statement).
Check (Part_Sums_proofs.fn_difference.proved : Part_Sums.fn_difference.statement).
Check (Part_The_printed_proofs.quadratic_unity.proved : Part_The_printed.quadratic_unity.statement).
Check (Part_The_printed_proofs.quadratic_unity.met : Part_The_printed.quadratic_unity.instance).
Check (Part_The_printed_proofs.quadratic_symmetry.proved : Part_The_printed.quadratic_symmetry.statement).
Check (Part_The_printed_proofs.quadratic_symmetry.met : Part_The_printed.quadratic_symmetry.instance).
Check (Part_The_printed_proofs.quadratic_ends.proved : Part_The_printed.quadratic_ends.statement).
Check (Part_The_printed_proofs.quadratic_ends.met : Part_The_printed.quadratic_ends.instance).
Check (Part_The_printed_proofs.quadratic_nonnegative.proved : Part_The_printed.quadratic_nonnegative.statement).
Check (Part_The_printed_proofs.quadratic_nonnegative.met : Part_The_printed.quadratic_nonnegative.instance).
Check (Part_The_printed_proofs.quadratic_nonnegative_slip.refuted : ~ Part_The_printed.quadratic_nonnegative_slip.statement).
Check (Part_The_printed_proofs.quadratic_decreasing.proved : Part_The_printed.quadratic_decreasing.statement).
Check (Part_The_printed_proofs.quadratic_decreasing.met : Part_The_printed.quadratic_decreasing.instance).
Check (Part_The_printed_proofs.quadratic_largest.proved : Part_The_printed.quadratic_largest.statement).
Check (Part_The_printed_proofs.quadratic_largest.met : Part_The_printed.quadratic_largest.instance).
Check (Part_The_printed_proofs.quadratic_space.proved : Part_The_printed.quadratic_space.statement).
Check (Part_The_printed_proofs.quadratic_space.met : Part_The_printed.quadratic_space.instance).
Check (Part_The_printed_proofs.shape_unity.proved : Part_The_printed.shape_unity.statement).
Check (Part_The_printed_proofs.shape_unity.met : Part_The_printed.shape_unity.instance).
Check (Part_The_printed_proofs.shape_symmetry.proved : Part_The_printed.shape_symmetry.statement).
Check (Part_The_printed_proofs.shape_symmetry.met : Part_The_printed.shape_symmetry.instance).
Check (Part_The_printed_proofs.shape_nonnegative.proved : Part_The_printed.shape_nonnegative.statement).
Check (Part_The_printed_proofs.shape_nonnegative.met : Part_The_printed.shape_nonnegative.instance).
Check (Part_The_proofs.quadratic_unity.proved : Part_The.quadratic_unity.statement).
Check (Part_The_proofs.quadratic_unity.met : Part_The.quadratic_unity.instance).
Check (Part_The_proofs.quadratic_symmetry.proved : Part_The.quadratic_symmetry.statement).
Check (Part_The_proofs.quadratic_symmetry.met : Part_The.quadratic_symmetry.instance).
Check (Part_The_proofs.quadratic_ends.proved : Part_The.quadratic_ends.statement).
Check (Part_The_proofs.quadratic_ends.met : Part_The.quadratic_ends.instance).
Check (Part_The_proofs.quadratic_nonnegative.proved : Part_The.quadratic_nonnegative.statement).
Check (Part_The_proofs.quadratic_nonnegative.met : Part_The.quadratic_nonnegative.instance).
Check (Part_The_proofs.quadratic_nonnegative_slip.refuted : ~ Part_The.quadratic_nonnegative_slip.statement).
Check (Part_The_proofs.quadratic_decreasing.proved : Part_The.quadratic_decreasing.statement).
Check (Part_The_proofs.quadratic_decreasing.met : Part_The.quadratic_decreasing.instance).
Check (Part_The_proofs.quadratic_largest.proved : Part_The.quadratic_largest.statement).
Check (Part_The_proofs.quadratic_largest.met : Part_The.quadratic_largest.instance).
Check (Part_The_proofs.quadratic_space.proved : Part_The.quadratic_space.statement).
Check (Part_The_proofs.quadratic_space.met : Part_The.quadratic_space.instance).
Check (Part_The_proofs.shape_unity.proved : Part_The.shape_unity.statement).
Check (Part_The_proofs.shape_unity.met : Part_The.shape_unity.instance).
Check (Part_The_proofs.shape_symmetry.proved : Part_The.shape_symmetry.statement).
Check (Part_The_proofs.shape_symmetry.met : Part_The.shape_symmetry.instance).
Check (Part_The_proofs.shape_nonnegative.proved : Part_The.shape_nonnegative.statement).
Check (Part_The_proofs.shape_nonnegative.met : Part_The.shape_nonnegative.instance).
Check (Part_Tractrix_printed_proofs.tractrix_pull.proved : Part_Tractrix_printed.tractrix_pull.statement).
Check (Part_Tractrix_printed_proofs.tractrix_pull.met : Part_Tractrix_printed.tractrix_pull.instance).
Check (Part_Tractrix_printed_proofs.tractrix_speed.proved : Part_Tractrix_printed.tractrix_speed.statement).
Check (Part_Tractrix_printed_proofs.tractrix_speed.met : Part_Tractrix_printed.tractrix_speed.instance).
Check (Part_Tractrix_proofs.tractrix_pull.proved : Part_Tractrix.tractrix_pull.statement).
Check (Part_Tractrix_proofs.tractrix_pull.met : Part_Tractrix.tractrix_pull.instance).
Check (Part_Tractrix_proofs.tractrix_speed.proved : Part_Tractrix.tractrix_speed.statement).
Check (Part_Tractrix_proofs.tractrix_speed.met : Part_Tractrix.tractrix_speed.instance).
Check (Part_Values_printed_proofs.fn_number.proved : Part_Values_printed.fn_number.statement).
Check (Part_Values_printed_proofs.fn_value.proved : Part_Values_printed.fn_value.statement).
Check (Part_Values_proofs.fn_number.proved : Part_Values.fn_number.statement).
Check (Part_Values_proofs.fn_value.proved : Part_Values.fn_value.statement).
Definition all_theorems : True :=
let _ := Part_Catenary_printed_proofs.catenary_speed.proved in
let _ := Part_Catenary_printed_proofs.catenary_length.proved in
let _ := Part_Catenary_printed_proofs.catenary_curvature.proved in
let _ := Part_Catenary_printed_proofs.catenary_curvature.met in
let _ := Part_Catenary_printed_proofs.catenary_curvature_slip.refuted in
let _ := Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.proved in
let _ := Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.met in
let _ := Part_Catenary_printed_proofs.catenary_load.proved in
let _ := Part_Catenary_proofs.catenary_speed.proved in
let _ := Part_Catenary_proofs.catenary_length.proved in
let _ := Part_Catenary_proofs.catenary_curvature.proved in
let _ := Part_Catenary_proofs.catenary_curvature.met in
let _ := Part_Catenary_proofs.catenary_curvature_slip.refuted in
let _ := Part_Catenary_proofs.catenary_curvature_slip_corrected.proved in
let _ := Part_Catenary_proofs.catenary_curvature_slip_corrected.met in
let _ := Part_Catenary_proofs.catenary_load.proved in
let _ := Part_Catenoid_printed_proofs.catenoid_conformal.proved in
let _ := Part_Catenoid_printed_proofs.catenoid_minimal.proved in
let _ := Part_Catenoid_printed_proofs.catenoid_gauss.proved in
let _ := Part_Catenoid_printed_proofs.catenoid_regular.proved in
let _ := Part_Catenoid_proofs.catenoid_conformal.proved in
let _ := Part_Catenoid_proofs.catenoid_minimal.proved in
let _ := Part_Catenoid_proofs.catenoid_gauss.proved in
let _ := Part_Catenoid_proofs.catenoid_regular.proved in
let _ := Part_Curves_printed_proofs.curve_ends.proved in
let _ := Part_Curves_printed_proofs.curve_ends.met in
let _ := Part_Curves_printed_proofs.curve_d1.proved in
let _ := Part_Curves_printed_proofs.curve_d1.met in
let _ := Part_Curves_printed_proofs.curve_d1_slip.refuted in
let _ := Part_Curves_printed_proofs.curve_d1_slip_corrected.proved in
let _ := Part_Curves_printed_proofs.curve_d1_slip_corrected.met in
let _ := Part_Curves_printed_proofs.curve_d2.proved in
let _ := Part_Curves_printed_proofs.curve_d2.met in
let _ := Part_Curves_printed_proofs.curve_middle.proved in
let _ := Part_Curves_printed_proofs.curve_middle.met in
let _ := Part_Curves_printed_proofs.curve_middle_slip.refuted in
let _ := Part_Curves_printed_proofs.shape_ends.proved in
let _ := Part_Curves_printed_proofs.shape_ends.met in
let _ := Part_Curves_printed_proofs.shape_d1.proved in
let _ := Part_Curves_printed_proofs.shape_d1.met in
let _ := Part_Curves_printed_proofs.shape_d1_slip.refuted in
let _ := Part_Curves_printed_proofs.shape_slope.proved in
let _ := Part_Curves_printed_proofs.shape_slope.met in
let _ := Part_Curves_proofs.curve_ends.proved in
let _ := Part_Curves_proofs.curve_ends.met in
let _ := Part_Curves_proofs.curve_d1.proved in
let _ := Part_Curves_proofs.curve_d1.met in
let _ := Part_Curves_proofs.curve_d1_slip.refuted in
let _ := Part_Curves_proofs.curve_d1_slip_corrected.proved in
let _ := Part_Curves_proofs.curve_d1_slip_corrected.met in
let _ := Part_Curves_proofs.curve_d2.proved in
let _ := Part_Curves_proofs.curve_d2.met in
let _ := Part_Curves_proofs.curve_middle.proved in
let _ := Part_Curves_proofs.curve_middle.met in
let _ := Part_Curves_proofs.curve_middle_slip.refuted in
let _ := Part_Curves_proofs.shape_ends.proved in
let _ := Part_Curves_proofs.shape_ends.met in
let _ := Part_Curves_proofs.shape_d1.proved in
let _ := Part_Curves_proofs.shape_d1.met in
let _ := Part_Curves_proofs.shape_d1_slip.refuted in
let _ := Part_Curves_proofs.shape_slope.proved in
let _ := Part_Curves_proofs.shape_slope.met in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola.proved in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola.met in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.proved in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.met in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.proved in
let _ := Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.met in
let _ := Part_Hyperbolas_proofs.curve_hyperbola.proved in
let _ := Part_Hyperbolas_proofs.curve_hyperbola.met in
let _ := Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved in
let _ := Part_Hyperbolas_proofs.curve_hyperbola_implicit.met in
let _ := Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved in
let _ := Part_Hyperbolas_proofs.curve_hyperbola_tangent.met in
let _ := Part_Joins_printed_proofs.join_C1.proved in
let _ := Part_Joins_printed_proofs.join_C1.met in
let _ := Part_Joins_printed_proofs.join_C1_slip.refuted in
let _ := Part_Joins_printed_proofs.join_C1_slip_corrected.proved in
let _ := Part_Joins_printed_proofs.join_C1_slip_corrected.met in
let _ := Part_Joins_printed_proofs.join_C2.proved in
let _ := Part_Joins_printed_proofs.join_C2.met in
let _ := Part_Joins_printed_proofs.shape_join.proved in
let _ := Part_Joins_printed_proofs.shape_join.met in
let _ := Part_Joins_proofs.join_C1.proved in
let _ := Part_Joins_proofs.join_C1.met in
let _ := Part_Joins_proofs.join_C1_slip.refuted in
let _ := Part_Joins_proofs.join_C1_slip_corrected.proved in
let _ := Part_Joins_proofs.join_C1_slip_corrected.met in
let _ := Part_Joins_proofs.join_C2.proved in
let _ := Part_Joins_proofs.join_C2.met in
let _ := Part_Joins_proofs.shape_join.proved in
let _ := Part_Joins_proofs.shape_join.met in
let _ := Part_Logarithmic_printed_proofs.spiral_angle.proved in
let _ := Part_Logarithmic_printed_proofs.spiral_angle_slip.refuted in
let _ := Part_Logarithmic_printed_proofs.spiral_regular.proved in
let _ := Part_Logarithmic_printed_proofs.spiral_curvature.proved in
let _ := Part_Logarithmic_printed_proofs.spiral_curvature.met in
let _ := Part_Logarithmic_proofs.spiral_angle.proved in
let _ := Part_Logarithmic_proofs.spiral_angle_slip.refuted in
let _ := Part_Logarithmic_proofs.spiral_regular.proved in
let _ := Part_Logarithmic_proofs.spiral_curvature.proved in
let _ := Part_Logarithmic_proofs.spiral_curvature.met in
let _ := Part_Parts_printed_proofs.fn_half.proved in
let _ := Part_Parts_printed_proofs.fn_half_slip.refuted in
let _ := Part_Parts_printed_proofs.fn_half_slip_corrected.proved in
let _ := Part_Parts_printed_proofs.fn_third.proved in
let _ := Part_Parts_printed_proofs.fn_tangent.proved in
let _ := Part_Parts_printed_proofs.fn_tangent.met in
let _ := Part_Parts_proofs.fn_half.proved in
let _ := Part_Parts_proofs.fn_half_slip.refuted in
let _ := Part_Parts_proofs.fn_half_slip_corrected.proved in
let _ := Part_Parts_proofs.fn_third.proved in
let _ := Part_Parts_proofs.fn_tangent.proved in
let _ := Part_Parts_proofs.fn_tangent.met in
let _ := Part_Rates_printed_proofs.fn_rate.proved in
let _ := Part_Rates_printed_proofs.fn_rate.met in
let _ := Part_Rates_printed_proofs.fn_growth.proved in
let _ := Part_Rates_printed_proofs.fn_bell.proved in
let _ := Part_Rates_printed_proofs.fn_damped.proved in
let _ := Part_Rates_printed_proofs.fn_damped_slip.refuted in
let _ := Part_Rates_printed_proofs.fn_damped_slip_corrected.proved in
let _ := Part_Rates_proofs.fn_rate.proved in
let _ := Part_Rates_proofs.fn_rate.met in
let _ := Part_Rates_proofs.fn_growth.proved in
let _ := Part_Rates_proofs.fn_bell.proved in
let _ := Part_Rates_proofs.fn_damped.proved in
let _ := Part_Rates_proofs.fn_damped_slip.refuted in
let _ := Part_Rates_proofs.fn_damped_slip_corrected.proved in
let _ := Part_Roots_printed_proofs.catenary_norm.proved in
let _ := Part_Roots_printed_proofs.catenary_bend.proved in
let _ := Part_Roots_printed_proofs.catenary_bend.met in
let _ := Part_Roots_printed_proofs.catenary_bend_slip.refuted in
let _ := Part_Roots_printed_proofs.catenary_bend_slip_corrected.proved in
let _ := Part_Roots_printed_proofs.catenary_bend_slip_corrected.met in
let _ := Part_Roots_printed_proofs.tractrix_norm.proved in
let _ := Part_Roots_printed_proofs.tractrix_norm.met in
let _ := Part_Roots_proofs.catenary_norm.proved in
let _ := Part_Roots_proofs.catenary_bend.proved in
let _ := Part_Roots_proofs.catenary_bend.met in
let _ := Part_Roots_proofs.catenary_bend_slip.refuted in
let _ := Part_Roots_proofs.catenary_bend_slip_corrected.proved in
let _ := Part_Roots_proofs.catenary_bend_slip_corrected.met in
let _ := Part_Roots_proofs.tractrix_norm.proved in
let _ := Part_Roots_proofs.tractrix_norm.met in
let _ := Part_Signs_printed_proofs.fn_positive.proved in
let _ := Part_Signs_printed_proofs.fn_strict_slip.refuted in
let _ := Part_Signs_printed_proofs.fn_bounded.proved in
let _ := Part_Signs_printed_proofs.fn_bounded.met in
let _ := Part_Signs_printed_proofs.fn_tangent_line.proved in
let _ := Part_Signs_printed_proofs.fn_unit.proved in
let _ := Part_Signs_printed_proofs.fn_unit.met in
let _ := Part_Signs_proofs.fn_positive.proved in
let _ := Part_Signs_proofs.fn_strict_slip.refuted in
let _ := Part_Signs_proofs.fn_bounded.proved in
let _ := Part_Signs_proofs.fn_bounded.met in
let _ := Part_Signs_proofs.fn_tangent_line.proved in
let _ := Part_Signs_proofs.fn_unit.proved in
let _ := Part_Signs_proofs.fn_unit.met in
let _ := Part_Spiral_printed_proofs.cone_slope.proved in
let _ := Part_Spiral_printed_proofs.cone_slope.met in
let _ := Part_Spiral_printed_proofs.cone_torsion.proved in
let _ := Part_Spiral_printed_proofs.cone_torsion.met in
let _ := Part_Spiral_printed_proofs.cone_torse.proved in
let _ := Part_Spiral_printed_proofs.cone_torse.met in
let _ := Part_Spiral_proofs.cone_slope.proved in
let _ := Part_Spiral_proofs.cone_slope.met in
let _ := Part_Spiral_proofs.cone_torsion.proved in
let _ := Part_Spiral_proofs.cone_torsion.met in
let _ := Part_Spiral_proofs.cone_torse.proved in
let _ := Part_Spiral_proofs.cone_torse.met in
let _ := Part_Sums_printed_proofs.fn_pythagoras.proved in
let _ := Part_Sums_printed_proofs.fn_pythagoras_slip.refuted in
let _ := Part_Sums_printed_proofs.fn_pythagoras_slip_corrected.proved in
let _ := Part_Sums_printed_proofs.fn_sum.proved in
let _ := Part_Sums_printed_proofs.fn_difference.proved in
let _ := Part_Sums_proofs.fn_pythagoras.proved in
let _ := Part_Sums_proofs.fn_pythagoras_slip.refuted in
let _ := Part_Sums_proofs.fn_pythagoras_slip_corrected.proved in
let _ := Part_Sums_proofs.fn_sum.proved in
let _ := Part_Sums_proofs.fn_difference.proved in
let _ := Part_The_printed_proofs.quadratic_unity.proved in
let _ := Part_The_printed_proofs.quadratic_unity.met in
let _ := Part_The_printed_proofs.quadratic_symmetry.proved in
let _ := Part_The_printed_proofs.quadratic_symmetry.met in
let _ := Part_The_printed_proofs.quadratic_ends.proved in
let _ := Part_The_printed_proofs.quadratic_ends.met in
let _ := Part_The_printed_proofs.quadratic_nonnegative.proved in
let _ := Part_The_printed_proofs.quadratic_nonnegative.met in
let _ := Part_The_printed_proofs.quadratic_nonnegative_slip.refuted in
let _ := Part_The_printed_proofs.quadratic_decreasing.proved in
let _ := Part_The_printed_proofs.quadratic_decreasing.met in
let _ := Part_The_printed_proofs.quadratic_largest.proved in
let _ := Part_The_printed_proofs.quadratic_largest.met in
let _ := Part_The_printed_proofs.quadratic_space.proved in
let _ := Part_The_printed_proofs.quadratic_space.met in
let _ := Part_The_printed_proofs.shape_unity.proved in
let _ := Part_The_printed_proofs.shape_unity.met in
let _ := Part_The_printed_proofs.shape_symmetry.proved in
let _ := Part_The_printed_proofs.shape_symmetry.met in
let _ := Part_The_printed_proofs.shape_nonnegative.proved in
let _ := Part_The_printed_proofs.shape_nonnegative.met in
let _ := Part_The_proofs.quadratic_unity.proved in
let _ := Part_The_proofs.quadratic_unity.met in
let _ := Part_The_proofs.quadratic_symmetry.proved in
let _ := Part_The_proofs.quadratic_symmetry.met in
let _ := Part_The_proofs.quadratic_ends.proved in
let _ := Part_The_proofs.quadratic_ends.met in
let _ := Part_The_proofs.quadratic_nonnegative.proved in
let _ := Part_The_proofs.quadratic_nonnegative.met in
let _ := Part_The_proofs.quadratic_nonnegative_slip.refuted in
let _ := Part_The_proofs.quadratic_decreasing.proved in
let _ := Part_The_proofs.quadratic_decreasing.met in
let _ := Part_The_proofs.quadratic_largest.proved in
let _ := Part_The_proofs.quadratic_largest.met in
let _ := Part_The_proofs.quadratic_space.proved in
let _ := Part_The_proofs.quadratic_space.met in
let _ := Part_The_proofs.shape_unity.proved in
let _ := Part_The_proofs.shape_unity.met in
let _ := Part_The_proofs.shape_symmetry.proved in
let _ := Part_The_proofs.shape_symmetry.met in
let _ := Part_The_proofs.shape_nonnegative.proved in
let _ := Part_The_proofs.shape_nonnegative.met in
let _ := Part_Tractrix_printed_proofs.tractrix_pull.proved in
let _ := Part_Tractrix_printed_proofs.tractrix_pull.met in
let _ := Part_Tractrix_printed_proofs.tractrix_speed.proved in
let _ := Part_Tractrix_printed_proofs.tractrix_speed.met in
let _ := Part_Tractrix_proofs.tractrix_pull.proved in
let _ := Part_Tractrix_proofs.tractrix_pull.met in
let _ := Part_Tractrix_proofs.tractrix_speed.proved in
let _ := Part_Tractrix_proofs.tractrix_speed.met in
let _ := Part_Values_printed_proofs.fn_number.proved in
let _ := Part_Values_printed_proofs.fn_value.proved in
let _ := Part_Values_proofs.fn_number.proved in
let _ := Part_Values_proofs.fn_value.proved in
I.
