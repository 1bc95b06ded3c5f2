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
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_speed.proved : Hyperbolic.Part_Catenary_printed.catenary_speed.statement).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_length.proved : Hyperbolic.Part_Catenary_printed.catenary_length.statement).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature.proved : Hyperbolic.Part_Catenary_printed.catenary_curvature.statement).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature.met : Hyperbolic.Part_Catenary_printed.catenary_curvature.instance).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip.refuted : ~ Hyperbolic.Part_Catenary_printed.catenary_curvature_slip.statement).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.proved : Hyperbolic.Part_Catenary_printed.catenary_curvature_slip_corrected.statement).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.met : Hyperbolic.Part_Catenary_printed.catenary_curvature_slip_corrected.instance).
Check (Hyperbolic.Part_Catenary_printed_proofs.catenary_load.proved : Hyperbolic.Part_Catenary_printed.catenary_load.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_speed.proved : Hyperbolic.Part_Catenary.catenary_speed.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_length.proved : Hyperbolic.Part_Catenary.catenary_length.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature.proved : Hyperbolic.Part_Catenary.catenary_curvature.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature.met : Hyperbolic.Part_Catenary.catenary_curvature.instance).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip.refuted : ~ Hyperbolic.Part_Catenary.catenary_curvature_slip.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.proved : Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.statement).
Check (Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.met : Hyperbolic.Part_Catenary.catenary_curvature_slip_corrected.instance).
Check (Hyperbolic.Part_Catenary_proofs.catenary_load.proved : Hyperbolic.Part_Catenary.catenary_load.statement).
Check (Hyperbolic.Part_Catenoid_printed_proofs.catenoid_conformal.proved : Hyperbolic.Part_Catenoid_printed.catenoid_conformal.statement).
Check (Hyperbolic.Part_Catenoid_printed_proofs.catenoid_minimal.proved : Hyperbolic.Part_Catenoid_printed.catenoid_minimal.statement).
Check (Hyperbolic.Part_Catenoid_printed_proofs.catenoid_gauss.proved : Hyperbolic.Part_Catenoid_printed.catenoid_gauss.statement).
Check (Hyperbolic.Part_Catenoid_printed_proofs.catenoid_regular.proved : Hyperbolic.Part_Catenoid_printed.catenoid_regular.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_conformal.proved : Hyperbolic.Part_Catenoid.catenoid_conformal.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_minimal.proved : Hyperbolic.Part_Catenoid.catenoid_minimal.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_gauss.proved : Hyperbolic.Part_Catenoid.catenoid_gauss.statement).
Check (Hyperbolic.Part_Catenoid_proofs.catenoid_regular.proved : Hyperbolic.Part_Catenoid.catenoid_regular.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_ends.proved : Hyperbolic.Part_Curves_printed.curve_ends.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_ends.met : Hyperbolic.Part_Curves_printed.curve_ends.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d1.proved : Hyperbolic.Part_Curves_printed.curve_d1.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d1.met : Hyperbolic.Part_Curves_printed.curve_d1.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip.refuted : ~ Hyperbolic.Part_Curves_printed.curve_d1_slip.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip_corrected.proved : Hyperbolic.Part_Curves_printed.curve_d1_slip_corrected.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip_corrected.met : Hyperbolic.Part_Curves_printed.curve_d1_slip_corrected.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d2.proved : Hyperbolic.Part_Curves_printed.curve_d2.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_d2.met : Hyperbolic.Part_Curves_printed.curve_d2.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_middle.proved : Hyperbolic.Part_Curves_printed.curve_middle.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_middle.met : Hyperbolic.Part_Curves_printed.curve_middle.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.curve_middle_slip.refuted : ~ Hyperbolic.Part_Curves_printed.curve_middle_slip.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_ends.proved : Hyperbolic.Part_Curves_printed.shape_ends.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_ends.met : Hyperbolic.Part_Curves_printed.shape_ends.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_d1.proved : Hyperbolic.Part_Curves_printed.shape_d1.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_d1.met : Hyperbolic.Part_Curves_printed.shape_d1.instance).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_d1_slip.refuted : ~ Hyperbolic.Part_Curves_printed.shape_d1_slip.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_slope.proved : Hyperbolic.Part_Curves_printed.shape_slope.statement).
Check (Hyperbolic.Part_Curves_printed_proofs.shape_slope.met : Hyperbolic.Part_Curves_printed.shape_slope.instance).
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
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola.proved : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola.statement).
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola.met : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola.instance).
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.proved : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_implicit.statement).
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.met : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_implicit.instance).
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.proved : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_tangent.statement).
Check (Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.met : Hyperbolic.Part_Hyperbolas_printed.curve_hyperbola_tangent.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola_implicit.instance).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved : Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.statement).
Check (Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.met : Hyperbolic.Part_Hyperbolas.curve_hyperbola_tangent.instance).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C1.proved : Hyperbolic.Part_Joins_printed.join_C1.statement).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C1.met : Hyperbolic.Part_Joins_printed.join_C1.instance).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C1_slip.refuted : ~ Hyperbolic.Part_Joins_printed.join_C1_slip.statement).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C1_slip_corrected.proved : Hyperbolic.Part_Joins_printed.join_C1_slip_corrected.statement).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C1_slip_corrected.met : Hyperbolic.Part_Joins_printed.join_C1_slip_corrected.instance).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C2.proved : Hyperbolic.Part_Joins_printed.join_C2.statement).
Check (Hyperbolic.Part_Joins_printed_proofs.join_C2.met : Hyperbolic.Part_Joins_printed.join_C2.instance).
Check (Hyperbolic.Part_Joins_printed_proofs.shape_join.proved : Hyperbolic.Part_Joins_printed.shape_join.statement).
Check (Hyperbolic.Part_Joins_printed_proofs.shape_join.met : Hyperbolic.Part_Joins_printed.shape_join.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C1.proved : Hyperbolic.Part_Joins.join_C1.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1.met : Hyperbolic.Part_Joins.join_C1.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip.refuted : ~ Hyperbolic.Part_Joins.join_C1_slip.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.proved : Hyperbolic.Part_Joins.join_C1_slip_corrected.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.met : Hyperbolic.Part_Joins.join_C1_slip_corrected.instance).
Check (Hyperbolic.Part_Joins_proofs.join_C2.proved : Hyperbolic.Part_Joins.join_C2.statement).
Check (Hyperbolic.Part_Joins_proofs.join_C2.met : Hyperbolic.Part_Joins.join_C2.instance).
Check (Hyperbolic.Part_Joins_proofs.shape_join.proved : Hyperbolic.Part_Joins.shape_join.statement).
Check (Hyperbolic.Part_Joins_proofs.shape_join.met : Hyperbolic.Part_Joins.shape_join.instance).
Check (Hyperbolic.Part_Logarithmic_printed_proofs.spiral_angle.proved : Hyperbolic.Part_Logarithmic_printed.spiral_angle.statement).
Check (Hyperbolic.Part_Logarithmic_printed_proofs.spiral_angle_slip.refuted : ~ Hyperbolic.Part_Logarithmic_printed.spiral_angle_slip.statement).
Check (Hyperbolic.Part_Logarithmic_printed_proofs.spiral_regular.proved : Hyperbolic.Part_Logarithmic_printed.spiral_regular.statement).
Check (Hyperbolic.Part_Logarithmic_printed_proofs.spiral_curvature.proved : Hyperbolic.Part_Logarithmic_printed.spiral_curvature.statement).
Check (Hyperbolic.Part_Logarithmic_printed_proofs.spiral_curvature.met : Hyperbolic.Part_Logarithmic_printed.spiral_curvature.instance).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_angle.proved : Hyperbolic.Part_Logarithmic.spiral_angle.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_angle_slip.refuted : ~ Hyperbolic.Part_Logarithmic.spiral_angle_slip.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_regular.proved : Hyperbolic.Part_Logarithmic.spiral_regular.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.proved : Hyperbolic.Part_Logarithmic.spiral_curvature.statement).
Check (Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.met : Hyperbolic.Part_Logarithmic.spiral_curvature.instance).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_half.proved : Hyperbolic.Part_Parts_printed.fn_half.statement).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_half_slip.refuted : ~ Hyperbolic.Part_Parts_printed.fn_half_slip.statement).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_half_slip_corrected.proved : Hyperbolic.Part_Parts_printed.fn_half_slip_corrected.statement).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_third.proved : Hyperbolic.Part_Parts_printed.fn_third.statement).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_tangent.proved : Hyperbolic.Part_Parts_printed.fn_tangent.statement).
Check (Hyperbolic.Part_Parts_printed_proofs.fn_tangent.met : Hyperbolic.Part_Parts_printed.fn_tangent.instance).
Check (Hyperbolic.Part_Parts_proofs.fn_half.proved : Hyperbolic.Part_Parts.fn_half.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_half_slip.refuted : ~ Hyperbolic.Part_Parts.fn_half_slip.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_half_slip_corrected.proved : Hyperbolic.Part_Parts.fn_half_slip_corrected.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_third.proved : Hyperbolic.Part_Parts.fn_third.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_tangent.proved : Hyperbolic.Part_Parts.fn_tangent.statement).
Check (Hyperbolic.Part_Parts_proofs.fn_tangent.met : Hyperbolic.Part_Parts.fn_tangent.instance).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_rate.proved : Hyperbolic.Part_Rates_printed.fn_rate.statement).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_rate.met : Hyperbolic.Part_Rates_printed.fn_rate.instance).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_growth.proved : Hyperbolic.Part_Rates_printed.fn_growth.statement).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_bell.proved : Hyperbolic.Part_Rates_printed.fn_bell.statement).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_damped.proved : Hyperbolic.Part_Rates_printed.fn_damped.statement).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_damped_slip.refuted : ~ Hyperbolic.Part_Rates_printed.fn_damped_slip.statement).
Check (Hyperbolic.Part_Rates_printed_proofs.fn_damped_slip_corrected.proved : Hyperbolic.Part_Rates_printed.fn_damped_slip_corrected.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_rate.proved : Hyperbolic.Part_Rates.fn_rate.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_rate.met : Hyperbolic.Part_Rates.fn_rate.instance).
Check (Hyperbolic.Part_Rates_proofs.fn_growth.proved : Hyperbolic.Part_Rates.fn_growth.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_bell.proved : Hyperbolic.Part_Rates.fn_bell.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped.proved : Hyperbolic.Part_Rates.fn_damped.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped_slip.refuted : ~ Hyperbolic.Part_Rates.fn_damped_slip.statement).
Check (Hyperbolic.Part_Rates_proofs.fn_damped_slip_corrected.proved : Hyperbolic.Part_Rates.fn_damped_slip_corrected.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_norm.proved : Hyperbolic.Part_Roots_printed.catenary_norm.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_bend.proved : Hyperbolic.Part_Roots_printed.catenary_bend.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_bend.met : Hyperbolic.Part_Roots_printed.catenary_bend.instance).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip.refuted : ~ Hyperbolic.Part_Roots_printed.catenary_bend_slip.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip_corrected.proved : Hyperbolic.Part_Roots_printed.catenary_bend_slip_corrected.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip_corrected.met : Hyperbolic.Part_Roots_printed.catenary_bend_slip_corrected.instance).
Check (Hyperbolic.Part_Roots_printed_proofs.tractrix_norm.proved : Hyperbolic.Part_Roots_printed.tractrix_norm.statement).
Check (Hyperbolic.Part_Roots_printed_proofs.tractrix_norm.met : Hyperbolic.Part_Roots_printed.tractrix_norm.instance).
Check (Hyperbolic.Part_Roots_proofs.catenary_norm.proved : Hyperbolic.Part_Roots.catenary_norm.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend.proved : Hyperbolic.Part_Roots.catenary_bend.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend.met : Hyperbolic.Part_Roots.catenary_bend.instance).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend_slip.refuted : ~ Hyperbolic.Part_Roots.catenary_bend_slip.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.proved : Hyperbolic.Part_Roots.catenary_bend_slip_corrected.statement).
Check (Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.met : Hyperbolic.Part_Roots.catenary_bend_slip_corrected.instance).
Check (Hyperbolic.Part_Roots_proofs.tractrix_norm.proved : Hyperbolic.Part_Roots.tractrix_norm.statement).
Check (Hyperbolic.Part_Roots_proofs.tractrix_norm.met : Hyperbolic.Part_Roots.tractrix_norm.instance).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_positive.proved : Hyperbolic.Part_Signs_printed.fn_positive.statement).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_strict_slip.refuted : ~ Hyperbolic.Part_Signs_printed.fn_strict_slip.statement).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_bounded.proved : Hyperbolic.Part_Signs_printed.fn_bounded.statement).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_bounded.met : Hyperbolic.Part_Signs_printed.fn_bounded.instance).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_tangent_line.proved : Hyperbolic.Part_Signs_printed.fn_tangent_line.statement).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_unit.proved : Hyperbolic.Part_Signs_printed.fn_unit.statement).
Check (Hyperbolic.Part_Signs_printed_proofs.fn_unit.met : Hyperbolic.Part_Signs_printed.fn_unit.instance).
Check (Hyperbolic.Part_Signs_proofs.fn_positive.proved : Hyperbolic.Part_Signs.fn_positive.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_strict_slip.refuted : ~ Hyperbolic.Part_Signs.fn_strict_slip.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_bounded.proved : Hyperbolic.Part_Signs.fn_bounded.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_bounded.met : Hyperbolic.Part_Signs.fn_bounded.instance).
Check (Hyperbolic.Part_Signs_proofs.fn_tangent_line.proved : Hyperbolic.Part_Signs.fn_tangent_line.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_unit.proved : Hyperbolic.Part_Signs.fn_unit.statement).
Check (Hyperbolic.Part_Signs_proofs.fn_unit.met : Hyperbolic.Part_Signs.fn_unit.instance).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_slope.proved : Hyperbolic.Part_Spiral_printed.cone_slope.statement).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_slope.met : Hyperbolic.Part_Spiral_printed.cone_slope.instance).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_torsion.proved : Hyperbolic.Part_Spiral_printed.cone_torsion.statement).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_torsion.met : Hyperbolic.Part_Spiral_printed.cone_torsion.instance).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_torse.proved : Hyperbolic.Part_Spiral_printed.cone_torse.statement).
Check (Hyperbolic.Part_Spiral_printed_proofs.cone_torse.met : Hyperbolic.Part_Spiral_printed.cone_torse.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_slope.proved : Hyperbolic.Part_Spiral.cone_slope.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_slope.met : Hyperbolic.Part_Spiral.cone_slope.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_torsion.proved : Hyperbolic.Part_Spiral.cone_torsion.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_torsion.met : Hyperbolic.Part_Spiral.cone_torsion.instance).
Check (Hyperbolic.Part_Spiral_proofs.cone_torse.proved : Hyperbolic.Part_Spiral.cone_torse.statement).
Check (Hyperbolic.Part_Spiral_proofs.cone_torse.met : Hyperbolic.Part_Spiral.cone_torse.instance).
Check (Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras.proved : Hyperbolic.Part_Sums_printed.fn_pythagoras.statement).
Check (Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras_slip.refuted : ~ Hyperbolic.Part_Sums_printed.fn_pythagoras_slip.statement).
Check (Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras_slip_corrected.proved : Hyperbolic.Part_Sums_printed.fn_pythagoras_slip_corrected.statement).
Check (Hyperbolic.Part_Sums_printed_proofs.fn_sum.proved : Hyperbolic.Part_Sums_printed.fn_sum.statement).
Check (Hyperbolic.Part_Sums_printed_proofs.fn_difference.proved : Hyperbolic.Part_Sums_printed.fn_difference.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_pythagoras.proved : Hyperbolic.Part_Sums.fn_pythagoras.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip.refuted : ~ Hyperbolic.Part_Sums.fn_pythagoras_slip.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip_corrected.proved : Hyperbolic.Part_Sums.fn_pythagoras_slip_corrected.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_sum.proved : Hyperbolic.Part_Sums.fn_sum.statement).
Check (Hyperbolic.Part_Sums_proofs.fn_difference.proved : Hyperbolic.Part_Sums.fn_difference.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_unity.proved : Hyperbolic.Part_The_printed.quadratic_unity.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_unity.met : Hyperbolic.Part_The_printed.quadratic_unity.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_symmetry.proved : Hyperbolic.Part_The_printed.quadratic_symmetry.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_symmetry.met : Hyperbolic.Part_The_printed.quadratic_symmetry.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_ends.proved : Hyperbolic.Part_The_printed.quadratic_ends.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_ends.met : Hyperbolic.Part_The_printed.quadratic_ends.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative.proved : Hyperbolic.Part_The_printed.quadratic_nonnegative.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative.met : Hyperbolic.Part_The_printed.quadratic_nonnegative.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative_slip.refuted : ~ Hyperbolic.Part_The_printed.quadratic_nonnegative_slip.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_decreasing.proved : Hyperbolic.Part_The_printed.quadratic_decreasing.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_decreasing.met : Hyperbolic.Part_The_printed.quadratic_decreasing.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_largest.proved : Hyperbolic.Part_The_printed.quadratic_largest.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_largest.met : Hyperbolic.Part_The_printed.quadratic_largest.instance).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_space.proved : Hyperbolic.Part_The_printed.quadratic_space.statement).
Check (Hyperbolic.Part_The_printed_proofs.quadratic_space.met : Hyperbolic.Part_The_printed.quadratic_space.instance).
Check (Hyperbolic.Part_The_printed_proofs.shape_unity.proved : Hyperbolic.Part_The_printed.shape_unity.statement).
Check (Hyperbolic.Part_The_printed_proofs.shape_unity.met : Hyperbolic.Part_The_printed.shape_unity.instance).
Check (Hyperbolic.Part_The_printed_proofs.shape_symmetry.proved : Hyperbolic.Part_The_printed.shape_symmetry.statement).
Check (Hyperbolic.Part_The_printed_proofs.shape_symmetry.met : Hyperbolic.Part_The_printed.shape_symmetry.instance).
Check (Hyperbolic.Part_The_printed_proofs.shape_nonnegative.proved : Hyperbolic.Part_The_printed.shape_nonnegative.statement).
Check (Hyperbolic.Part_The_printed_proofs.shape_nonnegative.met : Hyperbolic.Part_The_printed.shape_nonnegative.instance).
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
Check (Hyperbolic.Part_Tractrix_printed_proofs.tractrix_pull.proved : Hyperbolic.Part_Tractrix_printed.tractrix_pull.statement).
Check (Hyperbolic.Part_Tractrix_printed_proofs.tractrix_pull.met : Hyperbolic.Part_Tractrix_printed.tractrix_pull.instance).
Check (Hyperbolic.Part_Tractrix_printed_proofs.tractrix_speed.proved : Hyperbolic.Part_Tractrix_printed.tractrix_speed.statement).
Check (Hyperbolic.Part_Tractrix_printed_proofs.tractrix_speed.met : Hyperbolic.Part_Tractrix_printed.tractrix_speed.instance).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_pull.proved : Hyperbolic.Part_Tractrix.tractrix_pull.statement).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_pull.met : Hyperbolic.Part_Tractrix.tractrix_pull.instance).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_speed.proved : Hyperbolic.Part_Tractrix.tractrix_speed.statement).
Check (Hyperbolic.Part_Tractrix_proofs.tractrix_speed.met : Hyperbolic.Part_Tractrix.tractrix_speed.instance).
Check (Hyperbolic.Part_Values_printed_proofs.fn_number.proved : Hyperbolic.Part_Values_printed.fn_number.statement).
Check (Hyperbolic.Part_Values_printed_proofs.fn_value.proved : Hyperbolic.Part_Values_printed.fn_value.statement).
Check (Hyperbolic.Part_Values_proofs.fn_number.proved : Hyperbolic.Part_Values.fn_number.statement).
Check (Hyperbolic.Part_Values_proofs.fn_value.proved : Hyperbolic.Part_Values.fn_value.statement).
Definition all_theorems : True :=
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_speed.proved in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_length.proved in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature.proved in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature.met in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip.refuted in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.proved in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_curvature_slip_corrected.met in
let _ := Hyperbolic.Part_Catenary_printed_proofs.catenary_load.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_speed.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_length.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature.met in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip.refuted in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.proved in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_curvature_slip_corrected.met in
let _ := Hyperbolic.Part_Catenary_proofs.catenary_load.proved in
let _ := Hyperbolic.Part_Catenoid_printed_proofs.catenoid_conformal.proved in
let _ := Hyperbolic.Part_Catenoid_printed_proofs.catenoid_minimal.proved in
let _ := Hyperbolic.Part_Catenoid_printed_proofs.catenoid_gauss.proved in
let _ := Hyperbolic.Part_Catenoid_printed_proofs.catenoid_regular.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_conformal.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_minimal.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_gauss.proved in
let _ := Hyperbolic.Part_Catenoid_proofs.catenoid_regular.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_ends.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_ends.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d1.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d1.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip.refuted in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip_corrected.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d1_slip_corrected.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d2.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_d2.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_middle.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_middle.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.curve_middle_slip.refuted in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_ends.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_ends.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_d1.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_d1.met in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_d1_slip.refuted in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_slope.proved in
let _ := Hyperbolic.Part_Curves_printed_proofs.shape_slope.met in
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
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola.proved in
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola.met in
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.proved in
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_implicit.met in
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.proved in
let _ := Hyperbolic.Part_Hyperbolas_printed_proofs.curve_hyperbola_tangent.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_implicit.met in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.proved in
let _ := Hyperbolic.Part_Hyperbolas_proofs.curve_hyperbola_tangent.met in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C1.proved in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C1.met in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C1_slip.refuted in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C1_slip_corrected.proved in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C1_slip_corrected.met in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C2.proved in
let _ := Hyperbolic.Part_Joins_printed_proofs.join_C2.met in
let _ := Hyperbolic.Part_Joins_printed_proofs.shape_join.proved in
let _ := Hyperbolic.Part_Joins_printed_proofs.shape_join.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C1.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C1.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip.refuted in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C1_slip_corrected.met in
let _ := Hyperbolic.Part_Joins_proofs.join_C2.proved in
let _ := Hyperbolic.Part_Joins_proofs.join_C2.met in
let _ := Hyperbolic.Part_Joins_proofs.shape_join.proved in
let _ := Hyperbolic.Part_Joins_proofs.shape_join.met in
let _ := Hyperbolic.Part_Logarithmic_printed_proofs.spiral_angle.proved in
let _ := Hyperbolic.Part_Logarithmic_printed_proofs.spiral_angle_slip.refuted in
let _ := Hyperbolic.Part_Logarithmic_printed_proofs.spiral_regular.proved in
let _ := Hyperbolic.Part_Logarithmic_printed_proofs.spiral_curvature.proved in
let _ := Hyperbolic.Part_Logarithmic_printed_proofs.spiral_curvature.met in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_angle.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_angle_slip.refuted in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_regular.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.proved in
let _ := Hyperbolic.Part_Logarithmic_proofs.spiral_curvature.met in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_half.proved in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_half_slip.refuted in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_half_slip_corrected.proved in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_third.proved in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_tangent.proved in
let _ := Hyperbolic.Part_Parts_printed_proofs.fn_tangent.met in
let _ := Hyperbolic.Part_Parts_proofs.fn_half.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_half_slip.refuted in
let _ := Hyperbolic.Part_Parts_proofs.fn_half_slip_corrected.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_third.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_tangent.proved in
let _ := Hyperbolic.Part_Parts_proofs.fn_tangent.met in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_rate.proved in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_rate.met in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_growth.proved in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_bell.proved in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_damped.proved in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_damped_slip.refuted in
let _ := Hyperbolic.Part_Rates_printed_proofs.fn_damped_slip_corrected.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_rate.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_rate.met in
let _ := Hyperbolic.Part_Rates_proofs.fn_growth.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_bell.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped.proved in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped_slip.refuted in
let _ := Hyperbolic.Part_Rates_proofs.fn_damped_slip_corrected.proved in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_norm.proved in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_bend.proved in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_bend.met in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip.refuted in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip_corrected.proved in
let _ := Hyperbolic.Part_Roots_printed_proofs.catenary_bend_slip_corrected.met in
let _ := Hyperbolic.Part_Roots_printed_proofs.tractrix_norm.proved in
let _ := Hyperbolic.Part_Roots_printed_proofs.tractrix_norm.met in
let _ := Hyperbolic.Part_Roots_proofs.catenary_norm.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend.met in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend_slip.refuted in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.proved in
let _ := Hyperbolic.Part_Roots_proofs.catenary_bend_slip_corrected.met in
let _ := Hyperbolic.Part_Roots_proofs.tractrix_norm.proved in
let _ := Hyperbolic.Part_Roots_proofs.tractrix_norm.met in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_positive.proved in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_strict_slip.refuted in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_bounded.proved in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_bounded.met in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_tangent_line.proved in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_unit.proved in
let _ := Hyperbolic.Part_Signs_printed_proofs.fn_unit.met in
let _ := Hyperbolic.Part_Signs_proofs.fn_positive.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_strict_slip.refuted in
let _ := Hyperbolic.Part_Signs_proofs.fn_bounded.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_bounded.met in
let _ := Hyperbolic.Part_Signs_proofs.fn_tangent_line.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_unit.proved in
let _ := Hyperbolic.Part_Signs_proofs.fn_unit.met in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_slope.proved in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_slope.met in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_torsion.proved in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_torsion.met in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_torse.proved in
let _ := Hyperbolic.Part_Spiral_printed_proofs.cone_torse.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_slope.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_slope.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torsion.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torsion.met in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torse.proved in
let _ := Hyperbolic.Part_Spiral_proofs.cone_torse.met in
let _ := Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras.proved in
let _ := Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras_slip.refuted in
let _ := Hyperbolic.Part_Sums_printed_proofs.fn_pythagoras_slip_corrected.proved in
let _ := Hyperbolic.Part_Sums_printed_proofs.fn_sum.proved in
let _ := Hyperbolic.Part_Sums_printed_proofs.fn_difference.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_pythagoras.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip.refuted in
let _ := Hyperbolic.Part_Sums_proofs.fn_pythagoras_slip_corrected.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_sum.proved in
let _ := Hyperbolic.Part_Sums_proofs.fn_difference.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_unity.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_unity.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_symmetry.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_symmetry.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_ends.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_ends.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_nonnegative_slip.refuted in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_decreasing.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_decreasing.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_largest.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_largest.met in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_space.proved in
let _ := Hyperbolic.Part_The_printed_proofs.quadratic_space.met in
let _ := Hyperbolic.Part_The_printed_proofs.shape_unity.proved in
let _ := Hyperbolic.Part_The_printed_proofs.shape_unity.met in
let _ := Hyperbolic.Part_The_printed_proofs.shape_symmetry.proved in
let _ := Hyperbolic.Part_The_printed_proofs.shape_symmetry.met in
let _ := Hyperbolic.Part_The_printed_proofs.shape_nonnegative.proved in
let _ := Hyperbolic.Part_The_printed_proofs.shape_nonnegative.met in
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
let _ := Hyperbolic.Part_Tractrix_printed_proofs.tractrix_pull.proved in
let _ := Hyperbolic.Part_Tractrix_printed_proofs.tractrix_pull.met in
let _ := Hyperbolic.Part_Tractrix_printed_proofs.tractrix_speed.proved in
let _ := Hyperbolic.Part_Tractrix_printed_proofs.tractrix_speed.met in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_pull.proved in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_pull.met in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_speed.proved in
let _ := Hyperbolic.Part_Tractrix_proofs.tractrix_speed.met in
let _ := Hyperbolic.Part_Values_printed_proofs.fn_number.proved in
let _ := Hyperbolic.Part_Values_printed_proofs.fn_value.proved in
let _ := Hyperbolic.Part_Values_proofs.fn_number.proved in
let _ := Hyperbolic.Part_Values_proofs.fn_value.proved in
I.
