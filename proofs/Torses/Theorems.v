(* The kernel's word: each theorem has the type of its statement. *)
From Torses Require Part_Central_printed Part_Central_printed_proofs.
From Torses Require Part_Central Part_Central_proofs.
From Torses Require Part_Cones_printed Part_Cones_printed_proofs.
From Torses Require Part_Cones Part_Cones_proofs.
From Torses Require Part_Constant_printed Part_Constant_printed_proofs.
From Torses Require Part_Constant Part_Constant_proofs.
From Torses Require Part_Contact_printed Part_Contact_printed_proofs.
From Torses Require Part_Contact Part_Contact_proofs.
From Torses Require Part_Curvature_printed Part_Curvature_printed_proofs.
From Torses Require Part_Curvature Part_Curvature_proofs.
From Torses Require Part_Curves_printed Part_Curves_printed_proofs.
From Torses Require Part_Curves Part_Curves_proofs.
From Torses Require Part_Cylinders_printed Part_Cylinders_printed_proofs.
From Torses Require Part_Cylinders Part_Cylinders_proofs.
From Torses Require Part_Distribution_printed Part_Distribution_printed_proofs.
From Torses Require Part_Distribution Part_Distribution_proofs.
From Torses Require Part_Edge_printed Part_Edge_printed_proofs.
From Torses Require Part_Edge Part_Edge_proofs.
From Torses Require Part_Freedom_printed Part_Freedom_printed_proofs.
From Torses Require Part_Freedom Part_Freedom_proofs.
From Torses Require Part_Normal_printed Part_Normal_printed_proofs.
From Torses Require Part_Normal Part_Normal_proofs.
From Torses Require Part_Polar_printed Part_Polar_printed_proofs.
From Torses Require Part_Polar Part_Polar_proofs.
From Torses Require Part_Rectifying_printed Part_Rectifying_printed_proofs.
From Torses Require Part_Rectifying Part_Rectifying_proofs.
From Torses Require Part_Rulings_printed Part_Rulings_printed_proofs.
From Torses Require Part_Rulings Part_Rulings_proofs.
From Torses Require Part_Skew_printed Part_Skew_printed_proofs.
From Torses Require Part_Skew Part_Skew_proofs.
From Torses Require Part_Tangent_printed Part_Tangent_printed_proofs.
From Torses Require Part_Tangent Part_Tangent_proofs.
From Torses Require Part_Torses_printed Part_Torses_printed_proofs.
From Torses Require Part_Torses Part_Torses_proofs.
Check (Part_Central_printed_proofs.striction_shortest.proved : Part_Central_printed.striction_shortest.statement).
Check (Part_Central_printed_proofs.striction_shortest.met : Part_Central_printed.striction_shortest.instance).
Check (Part_Central_printed_proofs.striction_growth.proved : Part_Central_printed.striction_growth.statement).
Check (Part_Central_printed_proofs.striction_growth.met : Part_Central_printed.striction_growth.instance).
Check (Part_Central_printed_proofs.striction_length.proved : Part_Central_printed.striction_length.statement).
Check (Part_Central_printed_proofs.striction_length.met : Part_Central_printed.striction_length.instance).
Check (Part_Central_printed_proofs.striction_scaled.proved : Part_Central_printed.striction_scaled.statement).
Check (Part_Central_printed_proofs.striction_scaled.met : Part_Central_printed.striction_scaled.instance).
Check (Part_Central_printed_proofs.striction_unit.proved : Part_Central_printed.striction_unit.statement).
Check (Part_Central_printed_proofs.striction_unit.met : Part_Central_printed.striction_unit.instance).
Check (Part_Central_printed_proofs.striction_unit_slip.refuted : ~ Part_Central_printed.striction_unit_slip.statement).
Check (Part_Central_proofs.striction_shortest.proved : Part_Central.striction_shortest.statement).
Check (Part_Central_proofs.striction_shortest.met : Part_Central.striction_shortest.instance).
Check (Part_Central_proofs.striction_growth.proved : Part_Central.striction_growth.statement).
Check (Part_Central_proofs.striction_length.proved : Part_Central.striction_length.statement).
Check (Part_Central_proofs.striction_length.met : Part_Central.striction_length.instance).
Check (Part_Central_proofs.striction_scaled.proved : Part_Central.striction_scaled.statement).
Check (Part_Central_proofs.striction_scaled.met : Part_Central.striction_scaled.instance).
Check (Part_Central_proofs.striction_unit.proved : Part_Central.striction_unit.statement).
Check (Part_Central_proofs.striction_unit.met : Part_Central.striction_unit.instance).
Check (Part_Central_proofs.striction_unit_slip.refuted : ~ Part_Central.striction_unit_slip.statement).
Check (Part_Cones_printed_proofs.cone_torse.proved : Part_Cones_printed.cone_torse.statement).
Check (Part_Cones_printed_proofs.cone_torse.met : Part_Cones_printed.cone_torse.instance).
Check (Part_Cones_printed_proofs.cone_apex.proved : Part_Cones_printed.cone_apex.statement).
Check (Part_Cones_printed_proofs.cone_apex.met : Part_Cones_printed.cone_apex.instance).
Check (Part_Cones_printed_proofs.cone_apex_slip.refuted : ~ Part_Cones_printed.cone_apex_slip.statement).
Check (Part_Cones_printed_proofs.planes_cone.proved : Part_Cones_printed.planes_cone.statement).
Check (Part_Cones_printed_proofs.planes_cone.met : Part_Cones_printed.planes_cone.instance).
Check (Part_Cones_proofs.cone_torse.proved : Part_Cones.cone_torse.statement).
Check (Part_Cones_proofs.cone_apex.proved : Part_Cones.cone_apex.statement).
Check (Part_Cones_proofs.cone_apex_slip.refuted : ~ Part_Cones.cone_apex_slip.statement).
Check (Part_Cones_proofs.planes_cone.proved : Part_Cones.planes_cone.statement).
Check (Part_Cones_proofs.planes_cone.met : Part_Cones.planes_cone.instance).
Check (Part_Constant_printed_proofs.slope_torse.proved : Part_Constant_printed.slope_torse.statement).
Check (Part_Constant_printed_proofs.slope_torse.met : Part_Constant_printed.slope_torse.instance).
Check (Part_Constant_proofs.slope_torse.proved : Part_Constant.slope_torse.statement).
Check (Part_Constant_proofs.slope_torse.met : Part_Constant.slope_torse.instance).
Check (Part_Contact_printed_proofs.ruled_touch.proved : Part_Contact_printed.ruled_touch.statement).
Check (Part_Contact_printed_proofs.ruled_touch.met : Part_Contact_printed.ruled_touch.instance).
Check (Part_Contact_proofs.ruled_touch.proved : Part_Contact.ruled_touch.statement).
Check (Part_Contact_proofs.ruled_touch.met : Part_Contact.ruled_touch.instance).
Check (Part_Curvature_printed_proofs.ruled_asymptotic.proved : Part_Curvature_printed.ruled_asymptotic.statement).
Check (Part_Curvature_printed_proofs.ruled_asymptotic.met : Part_Curvature_printed.ruled_asymptotic.instance).
Check (Part_Curvature_printed_proofs.ruled_mixed.proved : Part_Curvature_printed.ruled_mixed.statement).
Check (Part_Curvature_printed_proofs.ruled_mixed.met : Part_Curvature_printed.ruled_mixed.instance).
Check (Part_Curvature_printed_proofs.ruled_lagrange.proved : Part_Curvature_printed.ruled_lagrange.statement).
Check (Part_Curvature_printed_proofs.ruled_lagrange.met : Part_Curvature_printed.ruled_lagrange.instance).
Check (Part_Curvature_printed_proofs.ruled_gauss.proved : Part_Curvature_printed.ruled_gauss.statement).
Check (Part_Curvature_printed_proofs.ruled_gauss.met : Part_Curvature_printed.ruled_gauss.instance).
Check (Part_Curvature_printed_proofs.ruled_gauss_curvature.proved : Part_Curvature_printed.ruled_gauss_curvature.statement).
Check (Part_Curvature_printed_proofs.ruled_gauss_curvature.met : Part_Curvature_printed.ruled_gauss_curvature.instance).
Check (Part_Curvature_printed_proofs.ruled_gauss_sign.proved : Part_Curvature_printed.ruled_gauss_sign.statement).
Check (Part_Curvature_printed_proofs.ruled_gauss_sign.met : Part_Curvature_printed.ruled_gauss_sign.instance).
Check (Part_Curvature_printed_proofs.ruled_gauss_slip.refuted : ~ Part_Curvature_printed.ruled_gauss_slip.statement).
Check (Part_Curvature_printed_proofs.ruled_gauss_slip_corrected.proved : Part_Curvature_printed.ruled_gauss_slip_corrected.statement).
Check (Part_Curvature_printed_proofs.ruled_gauss_slip_corrected.met : Part_Curvature_printed.ruled_gauss_slip_corrected.instance).
Check (Part_Curvature_proofs.ruled_asymptotic.proved : Part_Curvature.ruled_asymptotic.statement).
Check (Part_Curvature_proofs.ruled_mixed.proved : Part_Curvature.ruled_mixed.statement).
Check (Part_Curvature_proofs.ruled_lagrange.proved : Part_Curvature.ruled_lagrange.statement).
Check (Part_Curvature_proofs.ruled_gauss.proved : Part_Curvature.ruled_gauss.statement).
Check (Part_Curvature_proofs.ruled_gauss_curvature.proved : Part_Curvature.ruled_gauss_curvature.statement).
Check (Part_Curvature_proofs.ruled_gauss_curvature.met : Part_Curvature.ruled_gauss_curvature.instance).
Check (Part_Curvature_proofs.ruled_gauss_sign.proved : Part_Curvature.ruled_gauss_sign.statement).
Check (Part_Curvature_proofs.ruled_gauss_slip.refuted : ~ Part_Curvature.ruled_gauss_slip.statement).
Check (Part_Curvature_proofs.ruled_gauss_slip_corrected.proved : Part_Curvature.ruled_gauss_slip_corrected.statement).
Check (Part_Curves_printed_proofs.curve_chain.proved : Part_Curves_printed.curve_chain.statement).
Check (Part_Curves_printed_proofs.curve_chain.met : Part_Curves_printed.curve_chain.instance).
Check (Part_Curves_printed_proofs.curve_chain_slip.refuted : ~ Part_Curves_printed.curve_chain_slip.statement).
Check (Part_Curves_printed_proofs.curve_chain_slip_corrected.proved : Part_Curves_printed.curve_chain_slip_corrected.statement).
Check (Part_Curves_printed_proofs.curve_chain_slip_corrected.met : Part_Curves_printed.curve_chain_slip_corrected.instance).
Check (Part_Curves_printed_proofs.curve_curvature.proved : Part_Curves_printed.curve_curvature.statement).
Check (Part_Curves_printed_proofs.curve_curvature.met : Part_Curves_printed.curve_curvature.instance).
Check (Part_Curves_printed_proofs.curve_torsion.proved : Part_Curves_printed.curve_torsion.statement).
Check (Part_Curves_printed_proofs.curve_torsion.met : Part_Curves_printed.curve_torsion.instance).
Check (Part_Curves_printed_proofs.curve_straight.proved : Part_Curves_printed.curve_straight.statement).
Check (Part_Curves_printed_proofs.curve_straight.met : Part_Curves_printed.curve_straight.instance).
Check (Part_Curves_proofs.curve_chain.proved : Part_Curves.curve_chain.statement).
Check (Part_Curves_proofs.curve_chain_slip.refuted : ~ Part_Curves.curve_chain_slip.statement).
Check (Part_Curves_proofs.curve_chain_slip_corrected.proved : Part_Curves.curve_chain_slip_corrected.statement).
Check (Part_Curves_proofs.curve_curvature.proved : Part_Curves.curve_curvature.statement).
Check (Part_Curves_proofs.curve_curvature.met : Part_Curves.curve_curvature.instance).
Check (Part_Curves_proofs.curve_torsion.proved : Part_Curves.curve_torsion.statement).
Check (Part_Curves_proofs.curve_torsion.met : Part_Curves.curve_torsion.instance).
Check (Part_Curves_proofs.curve_straight.proved : Part_Curves.curve_straight.statement).
Check (Part_Curves_proofs.curve_straight.met : Part_Curves.curve_straight.instance).
Check (Part_Cylinders_printed_proofs.cylinder_torse.proved : Part_Cylinders_printed.cylinder_torse.statement).
Check (Part_Cylinders_printed_proofs.cylinder_torse.met : Part_Cylinders_printed.cylinder_torse.instance).
Check (Part_Cylinders_printed_proofs.cylinder_normal.proved : Part_Cylinders_printed.cylinder_normal.statement).
Check (Part_Cylinders_printed_proofs.cylinder_normal.met : Part_Cylinders_printed.cylinder_normal.instance).
Check (Part_Cylinders_printed_proofs.cylinder_converse_slip.refuted : ~ Part_Cylinders_printed.cylinder_converse_slip.statement).
Check (Part_Cylinders_proofs.cylinder_torse.proved : Part_Cylinders.cylinder_torse.statement).
Check (Part_Cylinders_proofs.cylinder_torse.met : Part_Cylinders.cylinder_torse.instance).
Check (Part_Cylinders_proofs.cylinder_normal.proved : Part_Cylinders.cylinder_normal.statement).
Check (Part_Cylinders_proofs.cylinder_normal.met : Part_Cylinders.cylinder_normal.instance).
Check (Part_Cylinders_proofs.cylinder_converse_slip.refuted : ~ Part_Cylinders.cylinder_converse_slip.statement).
Check (Part_Distribution_printed_proofs.striction_parameter.proved : Part_Distribution_printed.striction_parameter.statement).
Check (Part_Distribution_printed_proofs.striction_parameter.met : Part_Distribution_printed.striction_parameter.instance).
Check (Part_Distribution_printed_proofs.striction_curvature.proved : Part_Distribution_printed.striction_curvature.statement).
Check (Part_Distribution_printed_proofs.striction_curvature.met : Part_Distribution_printed.striction_curvature.instance).
Check (Part_Distribution_proofs.striction_parameter.proved : Part_Distribution.striction_parameter.statement).
Check (Part_Distribution_proofs.striction_parameter.met : Part_Distribution.striction_parameter.instance).
Check (Part_Distribution_proofs.striction_curvature.proved : Part_Distribution.striction_curvature.statement).
Check (Part_Distribution_proofs.striction_curvature.met : Part_Distribution.striction_curvature.instance).
Check (Part_Edge_printed_proofs.regression_singular.proved : Part_Edge_printed.regression_singular.statement).
Check (Part_Edge_printed_proofs.regression_singular.met : Part_Edge_printed.regression_singular.instance).
Check (Part_Edge_printed_proofs.regression_tangent.proved : Part_Edge_printed.regression_tangent.statement).
Check (Part_Edge_printed_proofs.regression_tangent.met : Part_Edge_printed.regression_tangent.instance).
Check (Part_Edge_printed_proofs.regression_tangent_slip.refuted : ~ Part_Edge_printed.regression_tangent_slip.statement).
Check (Part_Edge_printed_proofs.planes_edge.proved : Part_Edge_printed.planes_edge.statement).
Check (Part_Edge_printed_proofs.planes_edge.met : Part_Edge_printed.planes_edge.instance).
Check (Part_Edge_printed_proofs.planes_edge_in.proved : Part_Edge_printed.planes_edge_in.statement).
Check (Part_Edge_printed_proofs.planes_edge_in.met : Part_Edge_printed.planes_edge_in.instance).
Check (Part_Edge_printed_proofs.planes_edge_tangent.proved : Part_Edge_printed.planes_edge_tangent.statement).
Check (Part_Edge_printed_proofs.planes_edge_tangent.met : Part_Edge_printed.planes_edge_tangent.instance).
Check (Part_Edge_printed_proofs.planes_edge_osculating.proved : Part_Edge_printed.planes_edge_osculating.statement).
Check (Part_Edge_printed_proofs.planes_edge_osculating.met : Part_Edge_printed.planes_edge_osculating.instance).
Check (Part_Edge_proofs.regression_singular.proved : Part_Edge.regression_singular.statement).
Check (Part_Edge_proofs.regression_singular.met : Part_Edge.regression_singular.instance).
Check (Part_Edge_proofs.regression_tangent.proved : Part_Edge.regression_tangent.statement).
Check (Part_Edge_proofs.regression_tangent.met : Part_Edge.regression_tangent.instance).
Check (Part_Edge_proofs.regression_tangent_slip.refuted : ~ Part_Edge.regression_tangent_slip.statement).
Check (Part_Edge_proofs.planes_edge.proved : Part_Edge.planes_edge.statement).
Check (Part_Edge_proofs.planes_edge.met : Part_Edge.planes_edge.instance).
Check (Part_Edge_proofs.planes_edge_in.proved : Part_Edge.planes_edge_in.statement).
Check (Part_Edge_proofs.planes_edge_in.met : Part_Edge.planes_edge_in.instance).
Check (Part_Edge_proofs.planes_edge_tangent.proved : Part_Edge.planes_edge_tangent.statement).
Check (Part_Edge_proofs.planes_edge_tangent.met : Part_Edge.planes_edge_tangent.instance).
Check (Part_Edge_proofs.planes_edge_osculating.proved : Part_Edge.planes_edge_osculating.statement).
Check (Part_Edge_proofs.planes_edge_osculating.met : Part_Edge.planes_edge_osculating.instance).
Check (Part_Freedom_printed_proofs.ruled_directrix.proved : Part_Freedom_printed.ruled_directrix.statement).
Check (Part_Freedom_printed_proofs.ruled_directrix.met : Part_Freedom_printed.ruled_directrix.instance).
Check (Part_Freedom_printed_proofs.ruled_scaled.proved : Part_Freedom_printed.ruled_scaled.statement).
Check (Part_Freedom_printed_proofs.ruled_scaled.met : Part_Freedom_printed.ruled_scaled.instance).
Check (Part_Freedom_printed_proofs.ruled_parameter.proved : Part_Freedom_printed.ruled_parameter.statement).
Check (Part_Freedom_printed_proofs.ruled_parameter.met : Part_Freedom_printed.ruled_parameter.instance).
Check (Part_Freedom_printed_proofs.ruled_parameter_slip.refuted : ~ Part_Freedom_printed.ruled_parameter_slip.statement).
Check (Part_Freedom_printed_proofs.ruled_parameter_slip_corrected.proved : Part_Freedom_printed.ruled_parameter_slip_corrected.statement).
Check (Part_Freedom_printed_proofs.ruled_parameter_slip_corrected.met : Part_Freedom_printed.ruled_parameter_slip_corrected.instance).
Check (Part_Freedom_printed_proofs.ruled_ends.proved : Part_Freedom_printed.ruled_ends.statement).
Check (Part_Freedom_printed_proofs.ruled_ends.met : Part_Freedom_printed.ruled_ends.instance).
Check (Part_Freedom_printed_proofs.ruled_start.proved : Part_Freedom_printed.ruled_start.statement).
Check (Part_Freedom_printed_proofs.ruled_start.met : Part_Freedom_printed.ruled_start.instance).
Check (Part_Freedom_proofs.ruled_directrix.proved : Part_Freedom.ruled_directrix.statement).
Check (Part_Freedom_proofs.ruled_scaled.proved : Part_Freedom.ruled_scaled.statement).
Check (Part_Freedom_proofs.ruled_parameter.proved : Part_Freedom.ruled_parameter.statement).
Check (Part_Freedom_proofs.ruled_parameter_slip.refuted : ~ Part_Freedom.ruled_parameter_slip.statement).
Check (Part_Freedom_proofs.ruled_parameter_slip_corrected.proved : Part_Freedom.ruled_parameter_slip_corrected.statement).
Check (Part_Freedom_proofs.ruled_ends.proved : Part_Freedom.ruled_ends.statement).
Check (Part_Freedom_proofs.ruled_start.proved : Part_Freedom.ruled_start.statement).
Check (Part_Normal_printed_proofs.ruled_normal.proved : Part_Normal_printed.ruled_normal.statement).
Check (Part_Normal_printed_proofs.ruled_normal.met : Part_Normal_printed.ruled_normal.instance).
Check (Part_Normal_printed_proofs.ruled_turn.proved : Part_Normal_printed.ruled_turn.statement).
Check (Part_Normal_printed_proofs.ruled_turn.met : Part_Normal_printed.ruled_turn.instance).
Check (Part_Normal_printed_proofs.ruled_turn_slip.refuted : ~ Part_Normal_printed.ruled_turn_slip.statement).
Check (Part_Normal_printed_proofs.ruled_turn_slip_corrected.proved : Part_Normal_printed.ruled_turn_slip_corrected.statement).
Check (Part_Normal_printed_proofs.ruled_turn_slip_corrected.met : Part_Normal_printed.ruled_turn_slip_corrected.instance).
Check (Part_Normal_printed_proofs.ruled_chasles.proved : Part_Normal_printed.ruled_chasles.statement).
Check (Part_Normal_printed_proofs.ruled_chasles.met : Part_Normal_printed.ruled_chasles.instance).
Check (Part_Normal_proofs.ruled_normal.proved : Part_Normal.ruled_normal.statement).
Check (Part_Normal_proofs.ruled_turn.proved : Part_Normal.ruled_turn.statement).
Check (Part_Normal_proofs.ruled_turn_slip.refuted : ~ Part_Normal.ruled_turn_slip.statement).
Check (Part_Normal_proofs.ruled_turn_slip_corrected.proved : Part_Normal.ruled_turn_slip_corrected.statement).
Check (Part_Normal_proofs.ruled_chasles.proved : Part_Normal.ruled_chasles.statement).
Check (Part_Polar_printed_proofs.polar_first.proved : Part_Polar_printed.polar_first.statement).
Check (Part_Polar_printed_proofs.polar_first.met : Part_Polar_printed.polar_first.instance).
Check (Part_Polar_printed_proofs.polar_second.proved : Part_Polar_printed.polar_second.statement).
Check (Part_Polar_printed_proofs.polar_second.met : Part_Polar_printed.polar_second.instance).
Check (Part_Polar_printed_proofs.polar_second_slip.refuted : ~ Part_Polar_printed.polar_second_slip.statement).
Check (Part_Polar_printed_proofs.polar_second_slip_corrected.proved : Part_Polar_printed.polar_second_slip_corrected.statement).
Check (Part_Polar_printed_proofs.polar_second_slip_corrected.met : Part_Polar_printed.polar_second_slip_corrected.instance).
Check (Part_Polar_proofs.polar_first.proved : Part_Polar.polar_first.statement).
Check (Part_Polar_proofs.polar_second.proved : Part_Polar.polar_second.statement).
Check (Part_Polar_proofs.polar_second_slip.refuted : ~ Part_Polar.polar_second_slip.statement).
Check (Part_Polar_proofs.polar_second_slip_corrected.proved : Part_Polar.polar_second_slip_corrected.statement).
Check (Part_Rectifying_printed_proofs.rectifying_contains.proved : Part_Rectifying_printed.rectifying_contains.statement).
Check (Part_Rectifying_printed_proofs.rectifying_contains.met : Part_Rectifying_printed.rectifying_contains.instance).
Check (Part_Rectifying_printed_proofs.rectifying_geodesic.proved : Part_Rectifying_printed.rectifying_geodesic.statement).
Check (Part_Rectifying_printed_proofs.rectifying_geodesic.met : Part_Rectifying_printed.rectifying_geodesic.instance).
Check (Part_Rectifying_proofs.rectifying_contains.proved : Part_Rectifying.rectifying_contains.statement).
Check (Part_Rectifying_proofs.rectifying_geodesic.proved : Part_Rectifying.rectifying_geodesic.statement).
Check (Part_Rulings_printed_proofs.planes_ruling.proved : Part_Rulings_printed.planes_ruling.statement).
Check (Part_Rulings_printed_proofs.planes_ruling.met : Part_Rulings_printed.planes_ruling.instance).
Check (Part_Rulings_printed_proofs.planes_turn.proved : Part_Rulings_printed.planes_turn.statement).
Check (Part_Rulings_printed_proofs.planes_turn.met : Part_Rulings_printed.planes_turn.instance).
Check (Part_Rulings_printed_proofs.planes_turn_slip.refuted : ~ Part_Rulings_printed.planes_turn_slip.statement).
Check (Part_Rulings_printed_proofs.planes_turn_slip_corrected.proved : Part_Rulings_printed.planes_turn_slip_corrected.statement).
Check (Part_Rulings_printed_proofs.planes_turn_slip_corrected.met : Part_Rulings_printed.planes_turn_slip_corrected.instance).
Check (Part_Rulings_printed_proofs.planes_cylinder.proved : Part_Rulings_printed.planes_cylinder.statement).
Check (Part_Rulings_printed_proofs.planes_cylinder.met : Part_Rulings_printed.planes_cylinder.instance).
Check (Part_Rulings_printed_proofs.planes_scaled.proved : Part_Rulings_printed.planes_scaled.statement).
Check (Part_Rulings_printed_proofs.planes_scaled.met : Part_Rulings_printed.planes_scaled.instance).
Check (Part_Rulings_printed_proofs.planes_scaled_slip.refuted : ~ Part_Rulings_printed.planes_scaled_slip.statement).
Check (Part_Rulings_printed_proofs.planes_scaled_slip_corrected.proved : Part_Rulings_printed.planes_scaled_slip_corrected.statement).
Check (Part_Rulings_printed_proofs.planes_scaled_slip_corrected.met : Part_Rulings_printed.planes_scaled_slip_corrected.instance).
Check (Part_Rulings_printed_proofs.planes_dual.proved : Part_Rulings_printed.planes_dual.statement).
Check (Part_Rulings_printed_proofs.planes_dual.met : Part_Rulings_printed.planes_dual.instance).
Check (Part_Rulings_proofs.planes_ruling.proved : Part_Rulings.planes_ruling.statement).
Check (Part_Rulings_proofs.planes_turn.proved : Part_Rulings.planes_turn.statement).
Check (Part_Rulings_proofs.planes_turn_slip.refuted : ~ Part_Rulings.planes_turn_slip.statement).
Check (Part_Rulings_proofs.planes_turn_slip_corrected.proved : Part_Rulings.planes_turn_slip_corrected.statement).
Check (Part_Rulings_proofs.planes_cylinder.proved : Part_Rulings.planes_cylinder.statement).
Check (Part_Rulings_proofs.planes_cylinder.met : Part_Rulings.planes_cylinder.instance).
Check (Part_Rulings_proofs.planes_scaled.proved : Part_Rulings.planes_scaled.statement).
Check (Part_Rulings_proofs.planes_scaled_slip.refuted : ~ Part_Rulings.planes_scaled_slip.statement).
Check (Part_Rulings_proofs.planes_scaled_slip_corrected.proved : Part_Rulings.planes_scaled_slip_corrected.statement).
Check (Part_Rulings_proofs.planes_dual.proved : Part_Rulings.planes_dual.statement).
Check (Part_Rulings_proofs.planes_dual.met : Part_Rulings.planes_dual.instance).
Check (Part_Skew_printed_proofs.binormals_skew.proved : Part_Skew_printed.binormals_skew.statement).
Check (Part_Skew_printed_proofs.binormals_skew.met : Part_Skew_printed.binormals_skew.instance).
Check (Part_Skew_printed_proofs.conoid_skew.proved : Part_Skew_printed.conoid_skew.statement).
Check (Part_Skew_printed_proofs.conoid_skew.met : Part_Skew_printed.conoid_skew.instance).
Check (Part_Skew_proofs.binormals_skew.proved : Part_Skew.binormals_skew.statement).
Check (Part_Skew_proofs.binormals_skew.met : Part_Skew.binormals_skew.instance).
Check (Part_Skew_proofs.conoid_skew.proved : Part_Skew.conoid_skew.statement).
Check (Part_Tangent_printed_proofs.tangents_torse.proved : Part_Tangent_printed.tangents_torse.statement).
Check (Part_Tangent_printed_proofs.tangents_torse.met : Part_Tangent_printed.tangents_torse.instance).
Check (Part_Tangent_printed_proofs.tangents_normal.proved : Part_Tangent_printed.tangents_normal.statement).
Check (Part_Tangent_printed_proofs.tangents_normal.met : Part_Tangent_printed.tangents_normal.instance).
Check (Part_Tangent_printed_proofs.tangents_edge.proved : Part_Tangent_printed.tangents_edge.statement).
Check (Part_Tangent_printed_proofs.tangents_edge.met : Part_Tangent_printed.tangents_edge.instance).
Check (Part_Tangent_printed_proofs.tangents_osculating.proved : Part_Tangent_printed.tangents_osculating.statement).
Check (Part_Tangent_printed_proofs.tangents_osculating.met : Part_Tangent_printed.tangents_osculating.instance).
Check (Part_Tangent_printed_proofs.tangents_metric.proved : Part_Tangent_printed.tangents_metric.statement).
Check (Part_Tangent_printed_proofs.tangents_metric.met : Part_Tangent_printed.tangents_metric.instance).
Check (Part_Tangent_printed_proofs.tangents_metric_slip.refuted : ~ Part_Tangent_printed.tangents_metric_slip.statement).
Check (Part_Tangent_proofs.tangents_torse.proved : Part_Tangent.tangents_torse.statement).
Check (Part_Tangent_proofs.tangents_normal.proved : Part_Tangent.tangents_normal.statement).
Check (Part_Tangent_proofs.tangents_edge.proved : Part_Tangent.tangents_edge.statement).
Check (Part_Tangent_proofs.tangents_osculating.proved : Part_Tangent.tangents_osculating.statement).
Check (Part_Tangent_proofs.tangents_metric.proved : Part_Tangent.tangents_metric.statement).
Check (Part_Tangent_proofs.tangents_metric.met : Part_Tangent.tangents_metric.instance).
Check (Part_Tangent_proofs.tangents_metric_slip.refuted : ~ Part_Tangent.tangents_metric_slip.statement).
Check (Part_Torses_printed_proofs.ruled_torse_sufficient.proved : Part_Torses_printed.ruled_torse_sufficient.statement).
Check (Part_Torses_printed_proofs.ruled_torse_sufficient.met : Part_Torses_printed.ruled_torse_sufficient.instance).
Check (Part_Torses_printed_proofs.ruled_torse_necessary.proved : Part_Torses_printed.ruled_torse_necessary.statement).
Check (Part_Torses_printed_proofs.ruled_torse_necessary.met : Part_Torses_printed.ruled_torse_necessary.instance).
Check (Part_Torses_printed_proofs.ruled_rodrigues.proved : Part_Torses_printed.ruled_rodrigues.statement).
Check (Part_Torses_printed_proofs.ruled_rodrigues.met : Part_Torses_printed.ruled_rodrigues.instance).
Check (Part_Torses_proofs.ruled_torse_sufficient.proved : Part_Torses.ruled_torse_sufficient.statement).
Check (Part_Torses_proofs.ruled_torse_sufficient.met : Part_Torses.ruled_torse_sufficient.instance).
Check (Part_Torses_proofs.ruled_torse_necessary.proved : Part_Torses.ruled_torse_necessary.statement).
Check (Part_Torses_proofs.ruled_torse_necessary.met : Part_Torses.ruled_torse_necessary.instance).
Check (Part_Torses_proofs.ruled_rodrigues.proved : Part_Torses.ruled_rodrigues.statement).
Definition all_theorems : True :=
let _ := Part_Central_printed_proofs.striction_shortest.proved in
let _ := Part_Central_printed_proofs.striction_shortest.met in
let _ := Part_Central_printed_proofs.striction_growth.proved in
let _ := Part_Central_printed_proofs.striction_growth.met in
let _ := Part_Central_printed_proofs.striction_length.proved in
let _ := Part_Central_printed_proofs.striction_length.met in
let _ := Part_Central_printed_proofs.striction_scaled.proved in
let _ := Part_Central_printed_proofs.striction_scaled.met in
let _ := Part_Central_printed_proofs.striction_unit.proved in
let _ := Part_Central_printed_proofs.striction_unit.met in
let _ := Part_Central_printed_proofs.striction_unit_slip.refuted in
let _ := Part_Central_proofs.striction_shortest.proved in
let _ := Part_Central_proofs.striction_shortest.met in
let _ := Part_Central_proofs.striction_growth.proved in
let _ := Part_Central_proofs.striction_length.proved in
let _ := Part_Central_proofs.striction_length.met in
let _ := Part_Central_proofs.striction_scaled.proved in
let _ := Part_Central_proofs.striction_scaled.met in
let _ := Part_Central_proofs.striction_unit.proved in
let _ := Part_Central_proofs.striction_unit.met in
let _ := Part_Central_proofs.striction_unit_slip.refuted in
let _ := Part_Cones_printed_proofs.cone_torse.proved in
let _ := Part_Cones_printed_proofs.cone_torse.met in
let _ := Part_Cones_printed_proofs.cone_apex.proved in
let _ := Part_Cones_printed_proofs.cone_apex.met in
let _ := Part_Cones_printed_proofs.cone_apex_slip.refuted in
let _ := Part_Cones_printed_proofs.planes_cone.proved in
let _ := Part_Cones_printed_proofs.planes_cone.met in
let _ := Part_Cones_proofs.cone_torse.proved in
let _ := Part_Cones_proofs.cone_apex.proved in
let _ := Part_Cones_proofs.cone_apex_slip.refuted in
let _ := Part_Cones_proofs.planes_cone.proved in
let _ := Part_Cones_proofs.planes_cone.met in
let _ := Part_Constant_printed_proofs.slope_torse.proved in
let _ := Part_Constant_printed_proofs.slope_torse.met in
let _ := Part_Constant_proofs.slope_torse.proved in
let _ := Part_Constant_proofs.slope_torse.met in
let _ := Part_Contact_printed_proofs.ruled_touch.proved in
let _ := Part_Contact_printed_proofs.ruled_touch.met in
let _ := Part_Contact_proofs.ruled_touch.proved in
let _ := Part_Contact_proofs.ruled_touch.met in
let _ := Part_Curvature_printed_proofs.ruled_asymptotic.proved in
let _ := Part_Curvature_printed_proofs.ruled_asymptotic.met in
let _ := Part_Curvature_printed_proofs.ruled_mixed.proved in
let _ := Part_Curvature_printed_proofs.ruled_mixed.met in
let _ := Part_Curvature_printed_proofs.ruled_lagrange.proved in
let _ := Part_Curvature_printed_proofs.ruled_lagrange.met in
let _ := Part_Curvature_printed_proofs.ruled_gauss.proved in
let _ := Part_Curvature_printed_proofs.ruled_gauss.met in
let _ := Part_Curvature_printed_proofs.ruled_gauss_curvature.proved in
let _ := Part_Curvature_printed_proofs.ruled_gauss_curvature.met in
let _ := Part_Curvature_printed_proofs.ruled_gauss_sign.proved in
let _ := Part_Curvature_printed_proofs.ruled_gauss_sign.met in
let _ := Part_Curvature_printed_proofs.ruled_gauss_slip.refuted in
let _ := Part_Curvature_printed_proofs.ruled_gauss_slip_corrected.proved in
let _ := Part_Curvature_printed_proofs.ruled_gauss_slip_corrected.met in
let _ := Part_Curvature_proofs.ruled_asymptotic.proved in
let _ := Part_Curvature_proofs.ruled_mixed.proved in
let _ := Part_Curvature_proofs.ruled_lagrange.proved in
let _ := Part_Curvature_proofs.ruled_gauss.proved in
let _ := Part_Curvature_proofs.ruled_gauss_curvature.proved in
let _ := Part_Curvature_proofs.ruled_gauss_curvature.met in
let _ := Part_Curvature_proofs.ruled_gauss_sign.proved in
let _ := Part_Curvature_proofs.ruled_gauss_slip.refuted in
let _ := Part_Curvature_proofs.ruled_gauss_slip_corrected.proved in
let _ := Part_Curves_printed_proofs.curve_chain.proved in
let _ := Part_Curves_printed_proofs.curve_chain.met in
let _ := Part_Curves_printed_proofs.curve_chain_slip.refuted in
let _ := Part_Curves_printed_proofs.curve_chain_slip_corrected.proved in
let _ := Part_Curves_printed_proofs.curve_chain_slip_corrected.met in
let _ := Part_Curves_printed_proofs.curve_curvature.proved in
let _ := Part_Curves_printed_proofs.curve_curvature.met in
let _ := Part_Curves_printed_proofs.curve_torsion.proved in
let _ := Part_Curves_printed_proofs.curve_torsion.met in
let _ := Part_Curves_printed_proofs.curve_straight.proved in
let _ := Part_Curves_printed_proofs.curve_straight.met in
let _ := Part_Curves_proofs.curve_chain.proved in
let _ := Part_Curves_proofs.curve_chain_slip.refuted in
let _ := Part_Curves_proofs.curve_chain_slip_corrected.proved in
let _ := Part_Curves_proofs.curve_curvature.proved in
let _ := Part_Curves_proofs.curve_curvature.met in
let _ := Part_Curves_proofs.curve_torsion.proved in
let _ := Part_Curves_proofs.curve_torsion.met in
let _ := Part_Curves_proofs.curve_straight.proved in
let _ := Part_Curves_proofs.curve_straight.met in
let _ := Part_Cylinders_printed_proofs.cylinder_torse.proved in
let _ := Part_Cylinders_printed_proofs.cylinder_torse.met in
let _ := Part_Cylinders_printed_proofs.cylinder_normal.proved in
let _ := Part_Cylinders_printed_proofs.cylinder_normal.met in
let _ := Part_Cylinders_printed_proofs.cylinder_converse_slip.refuted in
let _ := Part_Cylinders_proofs.cylinder_torse.proved in
let _ := Part_Cylinders_proofs.cylinder_torse.met in
let _ := Part_Cylinders_proofs.cylinder_normal.proved in
let _ := Part_Cylinders_proofs.cylinder_normal.met in
let _ := Part_Cylinders_proofs.cylinder_converse_slip.refuted in
let _ := Part_Distribution_printed_proofs.striction_parameter.proved in
let _ := Part_Distribution_printed_proofs.striction_parameter.met in
let _ := Part_Distribution_printed_proofs.striction_curvature.proved in
let _ := Part_Distribution_printed_proofs.striction_curvature.met in
let _ := Part_Distribution_proofs.striction_parameter.proved in
let _ := Part_Distribution_proofs.striction_parameter.met in
let _ := Part_Distribution_proofs.striction_curvature.proved in
let _ := Part_Distribution_proofs.striction_curvature.met in
let _ := Part_Edge_printed_proofs.regression_singular.proved in
let _ := Part_Edge_printed_proofs.regression_singular.met in
let _ := Part_Edge_printed_proofs.regression_tangent.proved in
let _ := Part_Edge_printed_proofs.regression_tangent.met in
let _ := Part_Edge_printed_proofs.regression_tangent_slip.refuted in
let _ := Part_Edge_printed_proofs.planes_edge.proved in
let _ := Part_Edge_printed_proofs.planes_edge.met in
let _ := Part_Edge_printed_proofs.planes_edge_in.proved in
let _ := Part_Edge_printed_proofs.planes_edge_in.met in
let _ := Part_Edge_printed_proofs.planes_edge_tangent.proved in
let _ := Part_Edge_printed_proofs.planes_edge_tangent.met in
let _ := Part_Edge_printed_proofs.planes_edge_osculating.proved in
let _ := Part_Edge_printed_proofs.planes_edge_osculating.met in
let _ := Part_Edge_proofs.regression_singular.proved in
let _ := Part_Edge_proofs.regression_singular.met in
let _ := Part_Edge_proofs.regression_tangent.proved in
let _ := Part_Edge_proofs.regression_tangent.met in
let _ := Part_Edge_proofs.regression_tangent_slip.refuted in
let _ := Part_Edge_proofs.planes_edge.proved in
let _ := Part_Edge_proofs.planes_edge.met in
let _ := Part_Edge_proofs.planes_edge_in.proved in
let _ := Part_Edge_proofs.planes_edge_in.met in
let _ := Part_Edge_proofs.planes_edge_tangent.proved in
let _ := Part_Edge_proofs.planes_edge_tangent.met in
let _ := Part_Edge_proofs.planes_edge_osculating.proved in
let _ := Part_Edge_proofs.planes_edge_osculating.met in
let _ := Part_Freedom_printed_proofs.ruled_directrix.proved in
let _ := Part_Freedom_printed_proofs.ruled_directrix.met in
let _ := Part_Freedom_printed_proofs.ruled_scaled.proved in
let _ := Part_Freedom_printed_proofs.ruled_scaled.met in
let _ := Part_Freedom_printed_proofs.ruled_parameter.proved in
let _ := Part_Freedom_printed_proofs.ruled_parameter.met in
let _ := Part_Freedom_printed_proofs.ruled_parameter_slip.refuted in
let _ := Part_Freedom_printed_proofs.ruled_parameter_slip_corrected.proved in
let _ := Part_Freedom_printed_proofs.ruled_parameter_slip_corrected.met in
let _ := Part_Freedom_printed_proofs.ruled_ends.proved in
let _ := Part_Freedom_printed_proofs.ruled_ends.met in
let _ := Part_Freedom_printed_proofs.ruled_start.proved in
let _ := Part_Freedom_printed_proofs.ruled_start.met in
let _ := Part_Freedom_proofs.ruled_directrix.proved in
let _ := Part_Freedom_proofs.ruled_scaled.proved in
let _ := Part_Freedom_proofs.ruled_parameter.proved in
let _ := Part_Freedom_proofs.ruled_parameter_slip.refuted in
let _ := Part_Freedom_proofs.ruled_parameter_slip_corrected.proved in
let _ := Part_Freedom_proofs.ruled_ends.proved in
let _ := Part_Freedom_proofs.ruled_start.proved in
let _ := Part_Normal_printed_proofs.ruled_normal.proved in
let _ := Part_Normal_printed_proofs.ruled_normal.met in
let _ := Part_Normal_printed_proofs.ruled_turn.proved in
let _ := Part_Normal_printed_proofs.ruled_turn.met in
let _ := Part_Normal_printed_proofs.ruled_turn_slip.refuted in
let _ := Part_Normal_printed_proofs.ruled_turn_slip_corrected.proved in
let _ := Part_Normal_printed_proofs.ruled_turn_slip_corrected.met in
let _ := Part_Normal_printed_proofs.ruled_chasles.proved in
let _ := Part_Normal_printed_proofs.ruled_chasles.met in
let _ := Part_Normal_proofs.ruled_normal.proved in
let _ := Part_Normal_proofs.ruled_turn.proved in
let _ := Part_Normal_proofs.ruled_turn_slip.refuted in
let _ := Part_Normal_proofs.ruled_turn_slip_corrected.proved in
let _ := Part_Normal_proofs.ruled_chasles.proved in
let _ := Part_Polar_printed_proofs.polar_first.proved in
let _ := Part_Polar_printed_proofs.polar_first.met in
let _ := Part_Polar_printed_proofs.polar_second.proved in
let _ := Part_Polar_printed_proofs.polar_second.met in
let _ := Part_Polar_printed_proofs.polar_second_slip.refuted in
let _ := Part_Polar_printed_proofs.polar_second_slip_corrected.proved in
let _ := Part_Polar_printed_proofs.polar_second_slip_corrected.met in
let _ := Part_Polar_proofs.polar_first.proved in
let _ := Part_Polar_proofs.polar_second.proved in
let _ := Part_Polar_proofs.polar_second_slip.refuted in
let _ := Part_Polar_proofs.polar_second_slip_corrected.proved in
let _ := Part_Rectifying_printed_proofs.rectifying_contains.proved in
let _ := Part_Rectifying_printed_proofs.rectifying_contains.met in
let _ := Part_Rectifying_printed_proofs.rectifying_geodesic.proved in
let _ := Part_Rectifying_printed_proofs.rectifying_geodesic.met in
let _ := Part_Rectifying_proofs.rectifying_contains.proved in
let _ := Part_Rectifying_proofs.rectifying_geodesic.proved in
let _ := Part_Rulings_printed_proofs.planes_ruling.proved in
let _ := Part_Rulings_printed_proofs.planes_ruling.met in
let _ := Part_Rulings_printed_proofs.planes_turn.proved in
let _ := Part_Rulings_printed_proofs.planes_turn.met in
let _ := Part_Rulings_printed_proofs.planes_turn_slip.refuted in
let _ := Part_Rulings_printed_proofs.planes_turn_slip_corrected.proved in
let _ := Part_Rulings_printed_proofs.planes_turn_slip_corrected.met in
let _ := Part_Rulings_printed_proofs.planes_cylinder.proved in
let _ := Part_Rulings_printed_proofs.planes_cylinder.met in
let _ := Part_Rulings_printed_proofs.planes_scaled.proved in
let _ := Part_Rulings_printed_proofs.planes_scaled.met in
let _ := Part_Rulings_printed_proofs.planes_scaled_slip.refuted in
let _ := Part_Rulings_printed_proofs.planes_scaled_slip_corrected.proved in
let _ := Part_Rulings_printed_proofs.planes_scaled_slip_corrected.met in
let _ := Part_Rulings_printed_proofs.planes_dual.proved in
let _ := Part_Rulings_printed_proofs.planes_dual.met in
let _ := Part_Rulings_proofs.planes_ruling.proved in
let _ := Part_Rulings_proofs.planes_turn.proved in
let _ := Part_Rulings_proofs.planes_turn_slip.refuted in
let _ := Part_Rulings_proofs.planes_turn_slip_corrected.proved in
let _ := Part_Rulings_proofs.planes_cylinder.proved in
let _ := Part_Rulings_proofs.planes_cylinder.met in
let _ := Part_Rulings_proofs.planes_scaled.proved in
let _ := Part_Rulings_proofs.planes_scaled_slip.refuted in
let _ := Part_Rulings_proofs.planes_scaled_slip_corrected.proved in
let _ := Part_Rulings_proofs.planes_dual.proved in
let _ := Part_Rulings_proofs.planes_dual.met in
let _ := Part_Skew_printed_proofs.binormals_skew.proved in
let _ := Part_Skew_printed_proofs.binormals_skew.met in
let _ := Part_Skew_printed_proofs.conoid_skew.proved in
let _ := Part_Skew_printed_proofs.conoid_skew.met in
let _ := Part_Skew_proofs.binormals_skew.proved in
let _ := Part_Skew_proofs.binormals_skew.met in
let _ := Part_Skew_proofs.conoid_skew.proved in
let _ := Part_Tangent_printed_proofs.tangents_torse.proved in
let _ := Part_Tangent_printed_proofs.tangents_torse.met in
let _ := Part_Tangent_printed_proofs.tangents_normal.proved in
let _ := Part_Tangent_printed_proofs.tangents_normal.met in
let _ := Part_Tangent_printed_proofs.tangents_edge.proved in
let _ := Part_Tangent_printed_proofs.tangents_edge.met in
let _ := Part_Tangent_printed_proofs.tangents_osculating.proved in
let _ := Part_Tangent_printed_proofs.tangents_osculating.met in
let _ := Part_Tangent_printed_proofs.tangents_metric.proved in
let _ := Part_Tangent_printed_proofs.tangents_metric.met in
let _ := Part_Tangent_printed_proofs.tangents_metric_slip.refuted in
let _ := Part_Tangent_proofs.tangents_torse.proved in
let _ := Part_Tangent_proofs.tangents_normal.proved in
let _ := Part_Tangent_proofs.tangents_edge.proved in
let _ := Part_Tangent_proofs.tangents_osculating.proved in
let _ := Part_Tangent_proofs.tangents_metric.proved in
let _ := Part_Tangent_proofs.tangents_metric.met in
let _ := Part_Tangent_proofs.tangents_metric_slip.refuted in
let _ := Part_Torses_printed_proofs.ruled_torse_sufficient.proved in
let _ := Part_Torses_printed_proofs.ruled_torse_sufficient.met in
let _ := Part_Torses_printed_proofs.ruled_torse_necessary.proved in
let _ := Part_Torses_printed_proofs.ruled_torse_necessary.met in
let _ := Part_Torses_printed_proofs.ruled_rodrigues.proved in
let _ := Part_Torses_printed_proofs.ruled_rodrigues.met in
let _ := Part_Torses_proofs.ruled_torse_sufficient.proved in
let _ := Part_Torses_proofs.ruled_torse_sufficient.met in
let _ := Part_Torses_proofs.ruled_torse_necessary.proved in
let _ := Part_Torses_proofs.ruled_torse_necessary.met in
let _ := Part_Torses_proofs.ruled_rodrigues.proved in
I.
