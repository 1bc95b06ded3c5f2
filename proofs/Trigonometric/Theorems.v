(* The kernel's word: each theorem has the type of its statement. *)
From Trigonometric Require Part_Cardioid_printed Part_Cardioid_printed_proofs.
From Trigonometric Require Part_Cardioid Part_Cardioid_proofs.
From Trigonometric Require Part_Circles_printed Part_Circles_printed_proofs.
From Trigonometric Require Part_Circles Part_Circles_proofs.
From Trigonometric Require Part_Curves_printed Part_Curves_printed_proofs.
From Trigonometric Require Part_Curves Part_Curves_proofs.
From Trigonometric Require Part_Cycloid_printed Part_Cycloid_printed_proofs.
From Trigonometric Require Part_Cycloid Part_Cycloid_proofs.
From Trigonometric Require Part_Half_printed Part_Half_printed_proofs.
From Trigonometric Require Part_Half Part_Half_proofs.
From Trigonometric Require Part_Helicoid_printed Part_Helicoid_printed_proofs.
From Trigonometric Require Part_Helicoid Part_Helicoid_proofs.
From Trigonometric Require Part_Helix_printed Part_Helix_printed_proofs.
From Trigonometric Require Part_Helix Part_Helix_proofs.
From Trigonometric Require Part_Joins_printed Part_Joins_printed_proofs.
From Trigonometric Require Part_Joins Part_Joins_proofs.
From Trigonometric Require Part_Known_printed Part_Known_printed_proofs.
From Trigonometric Require Part_Known Part_Known_proofs.
From Trigonometric Require Part_Parts_printed Part_Parts_printed_proofs.
From Trigonometric Require Part_Parts Part_Parts_proofs.
From Trigonometric Require Part_Roots_printed Part_Roots_printed_proofs.
From Trigonometric Require Part_Roots Part_Roots_proofs.
From Trigonometric Require Part_Signs_printed Part_Signs_printed_proofs.
From Trigonometric Require Part_Signs Part_Signs_proofs.
From Trigonometric Require Part_Tangent_printed Part_Tangent_printed_proofs.
From Trigonometric Require Part_Tangent Part_Tangent_proofs.
From Trigonometric Require Part_Tangents_printed Part_Tangents_printed_proofs.
From Trigonometric Require Part_Tangents Part_Tangents_proofs.
From Trigonometric Require Part_The_printed Part_The_printed_proofs.
From Trigonometric Require Part_The Part_The_proofs.
Check (Trigonometric.Part_Cardioid_printed_proofs.cardioid_speed.proved : Trigonometric.Part_Cardioid_printed.cardioid_speed.statement).
Check (Trigonometric.Part_Cardioid_printed_proofs.cardioid_speed.met : Trigonometric.Part_Cardioid_printed.cardioid_speed.instance).
Check (Trigonometric.Part_Cardioid_printed_proofs.cardioid_cusp.proved : Trigonometric.Part_Cardioid_printed.cardioid_cusp.statement).
Check (Trigonometric.Part_Cardioid_printed_proofs.cardioid_curvature.proved : Trigonometric.Part_Cardioid_printed.cardioid_curvature.statement).
Check (Trigonometric.Part_Cardioid_printed_proofs.cardioid_curvature.met : Trigonometric.Part_Cardioid_printed.cardioid_curvature.instance).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved : Trigonometric.Part_Cardioid.cardioid_speed.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.met : Trigonometric.Part_Cardioid.cardioid_speed.instance).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved : Trigonometric.Part_Cardioid.cardioid_cusp.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_curvature.proved : Trigonometric.Part_Cardioid.cardioid_curvature.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_curvature.met : Trigonometric.Part_Cardioid.cardioid_curvature.instance).
Check (Trigonometric.Part_Circles_printed_proofs.quadratic_circle.proved : Trigonometric.Part_Circles_printed.quadratic_circle.statement).
Check (Trigonometric.Part_Circles_printed_proofs.quadratic_circle.met : Trigonometric.Part_Circles_printed.quadratic_circle.instance).
Check (Trigonometric.Part_Circles_proofs.quadratic_circle.proved : Trigonometric.Part_Circles.quadratic_circle.statement).
Check (Trigonometric.Part_Circles_proofs.quadratic_circle.met : Trigonometric.Part_Circles.quadratic_circle.instance).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_ends.proved : Trigonometric.Part_Curves_printed.quadratic_ends.statement).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_ends.met : Trigonometric.Part_Curves_printed.quadratic_ends.instance).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d1.proved : Trigonometric.Part_Curves_printed.quadratic_d1.statement).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d1.met : Trigonometric.Part_Curves_printed.quadratic_d1.instance).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d2.proved : Trigonometric.Part_Curves_printed.quadratic_d2.statement).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d2.met : Trigonometric.Part_Curves_printed.quadratic_d2.instance).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip.refuted : ~ Trigonometric.Part_Curves_printed.quadratic_d1_slip.statement).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip_corrected.proved : Trigonometric.Part_Curves_printed.quadratic_d1_slip_corrected.statement).
Check (Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip_corrected.met : Trigonometric.Part_Curves_printed.quadratic_d1_slip_corrected.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_ends.proved : Trigonometric.Part_Curves.quadratic_ends.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_ends.met : Trigonometric.Part_Curves.quadratic_ends.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1.proved : Trigonometric.Part_Curves.quadratic_d1.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1.met : Trigonometric.Part_Curves.quadratic_d1.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d2.proved : Trigonometric.Part_Curves.quadratic_d2.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d2.met : Trigonometric.Part_Curves.quadratic_d2.instance).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted : ~ Trigonometric.Part_Curves.quadratic_d1_slip.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved : Trigonometric.Part_Curves.quadratic_d1_slip_corrected.statement).
Check (Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met : Trigonometric.Part_Curves.quadratic_d1_slip_corrected.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_speed.proved : Trigonometric.Part_Cycloid_printed.cycloid_speed.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_speed.met : Trigonometric.Part_Cycloid_printed.cycloid_speed.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_regular.proved : Trigonometric.Part_Cycloid_printed.cycloid_regular.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_regular.met : Trigonometric.Part_Cycloid_printed.cycloid_regular.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope.proved : Trigonometric.Part_Cycloid_printed.cycloid_slope.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope.met : Trigonometric.Part_Cycloid_printed.cycloid_slope.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip.refuted : ~ Trigonometric.Part_Cycloid_printed.cycloid_slope_slip.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.proved : Trigonometric.Part_Cycloid_printed.cycloid_slope_slip_corrected.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.met : Trigonometric.Part_Cycloid_printed.cycloid_slope_slip_corrected.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_bend.proved : Trigonometric.Part_Cycloid_printed.cycloid_bend.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_bend.met : Trigonometric.Part_Cycloid_printed.cycloid_bend.instance).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_curvature.proved : Trigonometric.Part_Cycloid_printed.cycloid_curvature.statement).
Check (Trigonometric.Part_Cycloid_printed_proofs.cycloid_curvature.met : Trigonometric.Part_Cycloid_printed.cycloid_curvature.instance).
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
Check (Trigonometric.Part_Half_printed_proofs.angle_half_sine.proved : Trigonometric.Part_Half_printed.angle_half_sine.statement).
Check (Trigonometric.Part_Half_printed_proofs.angle_half_cosine.proved : Trigonometric.Part_Half_printed.angle_half_cosine.statement).
Check (Trigonometric.Part_Half_printed_proofs.angle_half_slip.refuted : ~ Trigonometric.Part_Half_printed.angle_half_slip.statement).
Check (Trigonometric.Part_Half_printed_proofs.angle_half_slip_corrected.proved : Trigonometric.Part_Half_printed.angle_half_slip_corrected.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_unity.proved : Trigonometric.Part_Half_printed.half_unity.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_unity.met : Trigonometric.Part_Half_printed.half_unity.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_middle.proved : Trigonometric.Part_Half_printed.half_middle.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_middle.met : Trigonometric.Part_Half_printed.half_middle.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_sine.proved : Trigonometric.Part_Half_printed.half_sine.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_sine.met : Trigonometric.Part_Half_printed.half_sine.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_cosine.proved : Trigonometric.Part_Half_printed.half_cosine.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_cosine.met : Trigonometric.Part_Half_printed.half_cosine.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_cosine_slip.refuted : ~ Trigonometric.Part_Half_printed.half_cosine_slip.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_powers.proved : Trigonometric.Part_Half_printed.half_powers.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_powers.met : Trigonometric.Part_Half_printed.half_powers.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_d1.proved : Trigonometric.Part_Half_printed.half_d1.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_d1.met : Trigonometric.Part_Half_printed.half_d1.instance).
Check (Trigonometric.Part_Half_printed_proofs.half_d1_slip.refuted : ~ Trigonometric.Part_Half_printed.half_d1_slip.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_d1_slip_corrected.proved : Trigonometric.Part_Half_printed.half_d1_slip_corrected.statement).
Check (Trigonometric.Part_Half_printed_proofs.half_d1_slip_corrected.met : Trigonometric.Part_Half_printed.half_d1_slip_corrected.instance).
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
Check (Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew.proved : Trigonometric.Part_Helicoid_printed.helicoid_skew.statement).
Check (Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew.met : Trigonometric.Part_Helicoid_printed.helicoid_skew.instance).
Check (Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew_slip.refuted : ~ Trigonometric.Part_Helicoid_printed.helicoid_skew_slip.statement).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved : Trigonometric.Part_Helicoid.helicoid_skew.statement).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew.met : Trigonometric.Part_Helicoid.helicoid_skew.instance).
Check (Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted : ~ Trigonometric.Part_Helicoid.helicoid_skew_slip.statement).
Check (Trigonometric.Part_Helix_printed_proofs.helix_speed.proved : Trigonometric.Part_Helix_printed.helix_speed.statement).
Check (Trigonometric.Part_Helix_printed_proofs.helix_speed.met : Trigonometric.Part_Helix_printed.helix_speed.instance).
Check (Trigonometric.Part_Helix_printed_proofs.helix_torsion.proved : Trigonometric.Part_Helix_printed.helix_torsion.statement).
Check (Trigonometric.Part_Helix_printed_proofs.helix_torsion.met : Trigonometric.Part_Helix_printed.helix_torsion.instance).
Check (Trigonometric.Part_Helix_printed_proofs.helix_curvature.proved : Trigonometric.Part_Helix_printed.helix_curvature.statement).
Check (Trigonometric.Part_Helix_printed_proofs.helix_curvature.met : Trigonometric.Part_Helix_printed.helix_curvature.instance).
Check (Trigonometric.Part_Helix_proofs.helix_speed.proved : Trigonometric.Part_Helix.helix_speed.statement).
Check (Trigonometric.Part_Helix_proofs.helix_speed.met : Trigonometric.Part_Helix.helix_speed.instance).
Check (Trigonometric.Part_Helix_proofs.helix_torsion.proved : Trigonometric.Part_Helix.helix_torsion.statement).
Check (Trigonometric.Part_Helix_proofs.helix_torsion.met : Trigonometric.Part_Helix.helix_torsion.instance).
Check (Trigonometric.Part_Helix_proofs.helix_curvature.proved : Trigonometric.Part_Helix.helix_curvature.statement).
Check (Trigonometric.Part_Helix_proofs.helix_curvature.met : Trigonometric.Part_Helix.helix_curvature.instance).
Check (Trigonometric.Part_Joins_printed_proofs.quadratic_join.proved : Trigonometric.Part_Joins_printed.quadratic_join.statement).
Check (Trigonometric.Part_Joins_printed_proofs.quadratic_join.met : Trigonometric.Part_Joins_printed.quadratic_join.instance).
Check (Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip.refuted : ~ Trigonometric.Part_Joins_printed.quadratic_join_slip.statement).
Check (Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip_corrected.proved : Trigonometric.Part_Joins_printed.quadratic_join_slip_corrected.statement).
Check (Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip_corrected.met : Trigonometric.Part_Joins_printed.quadratic_join_slip_corrected.instance).
Check (Trigonometric.Part_Joins_proofs.quadratic_join.proved : Trigonometric.Part_Joins.quadratic_join.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join.met : Trigonometric.Part_Joins.quadratic_join.instance).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted : ~ Trigonometric.Part_Joins.quadratic_join_slip.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved : Trigonometric.Part_Joins.quadratic_join_slip_corrected.statement).
Check (Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met : Trigonometric.Part_Joins.quadratic_join_slip_corrected.instance).
Check (Trigonometric.Part_Known_printed_proofs.angle_known.proved : Trigonometric.Part_Known_printed.angle_known.statement).
Check (Trigonometric.Part_Known_proofs.angle_known.proved : Trigonometric.Part_Known.angle_known.statement).
Check (Trigonometric.Part_Parts_printed_proofs.angle_third.proved : Trigonometric.Part_Parts_printed.angle_third.statement).
Check (Trigonometric.Part_Parts_printed_proofs.angle_parts.proved : Trigonometric.Part_Parts_printed.angle_parts.statement).
Check (Trigonometric.Part_Parts_printed_proofs.angle_rate.proved : Trigonometric.Part_Parts_printed.angle_rate.statement).
Check (Trigonometric.Part_Parts_proofs.angle_third.proved : Trigonometric.Part_Parts.angle_third.statement).
Check (Trigonometric.Part_Parts_proofs.angle_parts.proved : Trigonometric.Part_Parts.angle_parts.statement).
Check (Trigonometric.Part_Parts_proofs.angle_rate.proved : Trigonometric.Part_Parts.angle_rate.statement).
Check (Trigonometric.Part_Roots_printed_proofs.helix_length.proved : Trigonometric.Part_Roots_printed.helix_length.statement).
Check (Trigonometric.Part_Roots_printed_proofs.helix_length.met : Trigonometric.Part_Roots_printed.helix_length.instance).
Check (Trigonometric.Part_Roots_printed_proofs.helix_bend.proved : Trigonometric.Part_Roots_printed.helix_bend.statement).
Check (Trigonometric.Part_Roots_printed_proofs.helix_bend.met : Trigonometric.Part_Roots_printed.helix_bend.instance).
Check (Trigonometric.Part_Roots_printed_proofs.helix_bend_slip.refuted : ~ Trigonometric.Part_Roots_printed.helix_bend_slip.statement).
Check (Trigonometric.Part_Roots_printed_proofs.cylinder_normal.proved : Trigonometric.Part_Roots_printed.cylinder_normal.statement).
Check (Trigonometric.Part_Roots_printed_proofs.cylinder_normal.met : Trigonometric.Part_Roots_printed.cylinder_normal.instance).
Check (Trigonometric.Part_Roots_printed_proofs.cylinder_offset.proved : Trigonometric.Part_Roots_printed.cylinder_offset.statement).
Check (Trigonometric.Part_Roots_printed_proofs.cylinder_offset.met : Trigonometric.Part_Roots_printed.cylinder_offset.instance).
Check (Trigonometric.Part_Roots_proofs.helix_length.proved : Trigonometric.Part_Roots.helix_length.statement).
Check (Trigonometric.Part_Roots_proofs.helix_length.met : Trigonometric.Part_Roots.helix_length.instance).
Check (Trigonometric.Part_Roots_proofs.helix_bend.proved : Trigonometric.Part_Roots.helix_bend.statement).
Check (Trigonometric.Part_Roots_proofs.helix_bend.met : Trigonometric.Part_Roots.helix_bend.instance).
Check (Trigonometric.Part_Roots_proofs.helix_bend_slip.refuted : ~ Trigonometric.Part_Roots.helix_bend_slip.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_normal.proved : Trigonometric.Part_Roots.cylinder_normal.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_normal.met : Trigonometric.Part_Roots.cylinder_normal.instance).
Check (Trigonometric.Part_Roots_proofs.cylinder_offset.proved : Trigonometric.Part_Roots.cylinder_offset.statement).
Check (Trigonometric.Part_Roots_proofs.cylinder_offset.met : Trigonometric.Part_Roots.cylinder_offset.instance).
Check (Trigonometric.Part_Signs_printed_proofs.angle_first.proved : Trigonometric.Part_Signs_printed.angle_first.statement).
Check (Trigonometric.Part_Signs_printed_proofs.angle_first.met : Trigonometric.Part_Signs_printed.angle_first.instance).
Check (Trigonometric.Part_Signs_printed_proofs.angle_first_turned.proved : Trigonometric.Part_Signs_printed.angle_first_turned.statement).
Check (Trigonometric.Part_Signs_printed_proofs.angle_first_turned.met : Trigonometric.Part_Signs_printed.angle_first_turned.instance).
Check (Trigonometric.Part_Signs_printed_proofs.angle_symmetric.proved : Trigonometric.Part_Signs_printed.angle_symmetric.statement).
Check (Trigonometric.Part_Signs_printed_proofs.angle_symmetric.met : Trigonometric.Part_Signs_printed.angle_symmetric.instance).
Check (Trigonometric.Part_Signs_printed_proofs.angle_symmetric_slip.refuted : ~ Trigonometric.Part_Signs_printed.angle_symmetric_slip.statement).
Check (Trigonometric.Part_Signs_printed_proofs.angle_turn.proved : Trigonometric.Part_Signs_printed.angle_turn.statement).
Check (Trigonometric.Part_Signs_proofs.angle_first.proved : Trigonometric.Part_Signs.angle_first.statement).
Check (Trigonometric.Part_Signs_proofs.angle_first.met : Trigonometric.Part_Signs.angle_first.instance).
Check (Trigonometric.Part_Signs_proofs.angle_first_turned.proved : Trigonometric.Part_Signs.angle_first_turned.statement).
Check (Trigonometric.Part_Signs_proofs.angle_first_turned.met : Trigonometric.Part_Signs.angle_first_turned.instance).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric.proved : Trigonometric.Part_Signs.angle_symmetric.statement).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric.met : Trigonometric.Part_Signs.angle_symmetric.instance).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted : ~ Trigonometric.Part_Signs.angle_symmetric_slip.statement).
Check (Trigonometric.Part_Signs_proofs.angle_turn.proved : Trigonometric.Part_Signs.angle_turn.statement).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_torse.proved : Trigonometric.Part_Tangent_printed.helix_torse.statement).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_torse.met : Trigonometric.Part_Tangent_printed.helix_torse.instance).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_normal.proved : Trigonometric.Part_Tangent_printed.helix_normal.statement).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_normal.met : Trigonometric.Part_Tangent_printed.helix_normal.instance).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_regular.proved : Trigonometric.Part_Tangent_printed.helix_regular.statement).
Check (Trigonometric.Part_Tangent_printed_proofs.helix_regular.met : Trigonometric.Part_Tangent_printed.helix_regular.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.proved : Trigonometric.Part_Tangent.helix_torse.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.met : Trigonometric.Part_Tangent.helix_torse.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.proved : Trigonometric.Part_Tangent.helix_normal.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.met : Trigonometric.Part_Tangent.helix_normal.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_regular.proved : Trigonometric.Part_Tangent.helix_regular.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_regular.met : Trigonometric.Part_Tangent.helix_regular.instance).
Check (Trigonometric.Part_Tangents_printed_proofs.angle_tangent.proved : Trigonometric.Part_Tangents_printed.angle_tangent.statement).
Check (Trigonometric.Part_Tangents_printed_proofs.angle_tangent.met : Trigonometric.Part_Tangents_printed.angle_tangent.instance).
Check (Trigonometric.Part_Tangents_printed_proofs.angle_tangent_closed.proved : Trigonometric.Part_Tangents_printed.angle_tangent_closed.statement).
Check (Trigonometric.Part_Tangents_printed_proofs.angle_tangent_closed.met : Trigonometric.Part_Tangents_printed.angle_tangent_closed.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.proved : Trigonometric.Part_Tangents.angle_tangent.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.met : Trigonometric.Part_Tangents.angle_tangent.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved : Trigonometric.Part_Tangents.angle_tangent_closed.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met : Trigonometric.Part_Tangents.angle_tangent_closed.instance).
Check (Trigonometric.Part_The_printed_proofs.quadratic_middle.proved : Trigonometric.Part_The_printed.quadratic_middle.statement).
Check (Trigonometric.Part_The_printed_proofs.quadratic_middle.met : Trigonometric.Part_The_printed.quadratic_middle.instance).
Check (Trigonometric.Part_The_printed_proofs.quadratic_nonnegative.proved : Trigonometric.Part_The_printed.quadratic_nonnegative.statement).
Check (Trigonometric.Part_The_printed_proofs.quadratic_nonnegative.met : Trigonometric.Part_The_printed.quadratic_nonnegative.instance).
Check (Trigonometric.Part_The_printed_proofs.quadratic_nonnegative_slip.refuted : ~ Trigonometric.Part_The_printed.quadratic_nonnegative_slip.statement).
Check (Trigonometric.Part_The_printed_proofs.quadratic_symmetry.proved : Trigonometric.Part_The_printed.quadratic_symmetry.statement).
Check (Trigonometric.Part_The_printed_proofs.quadratic_symmetry.met : Trigonometric.Part_The_printed.quadratic_symmetry.instance).
Check (Trigonometric.Part_The_printed_proofs.quadratic_decreasing.proved : Trigonometric.Part_The_printed.quadratic_decreasing.statement).
Check (Trigonometric.Part_The_printed_proofs.quadratic_decreasing.met : Trigonometric.Part_The_printed.quadratic_decreasing.instance).
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
let _ := Trigonometric.Part_Cardioid_printed_proofs.cardioid_speed.proved in
let _ := Trigonometric.Part_Cardioid_printed_proofs.cardioid_speed.met in
let _ := Trigonometric.Part_Cardioid_printed_proofs.cardioid_cusp.proved in
let _ := Trigonometric.Part_Cardioid_printed_proofs.cardioid_curvature.proved in
let _ := Trigonometric.Part_Cardioid_printed_proofs.cardioid_curvature.met in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_speed.met in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_curvature.proved in
let _ := Trigonometric.Part_Cardioid_proofs.cardioid_curvature.met in
let _ := Trigonometric.Part_Circles_printed_proofs.quadratic_circle.proved in
let _ := Trigonometric.Part_Circles_printed_proofs.quadratic_circle.met in
let _ := Trigonometric.Part_Circles_proofs.quadratic_circle.proved in
let _ := Trigonometric.Part_Circles_proofs.quadratic_circle.met in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_ends.proved in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_ends.met in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d1.proved in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d1.met in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d2.proved in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d2.met in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip.refuted in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip_corrected.proved in
let _ := Trigonometric.Part_Curves_printed_proofs.quadratic_d1_slip_corrected.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_ends.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_ends.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d2.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d2.met in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved in
let _ := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_speed.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_speed.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_regular.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_regular.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip.refuted in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_bend.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_bend.met in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_curvature.proved in
let _ := Trigonometric.Part_Cycloid_printed_proofs.cycloid_curvature.met in
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
let _ := Trigonometric.Part_Half_printed_proofs.angle_half_sine.proved in
let _ := Trigonometric.Part_Half_printed_proofs.angle_half_cosine.proved in
let _ := Trigonometric.Part_Half_printed_proofs.angle_half_slip.refuted in
let _ := Trigonometric.Part_Half_printed_proofs.angle_half_slip_corrected.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_unity.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_unity.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_middle.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_middle.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_sine.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_sine.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_cosine.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_cosine.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_cosine_slip.refuted in
let _ := Trigonometric.Part_Half_printed_proofs.half_powers.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_powers.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_d1.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_d1.met in
let _ := Trigonometric.Part_Half_printed_proofs.half_d1_slip.refuted in
let _ := Trigonometric.Part_Half_printed_proofs.half_d1_slip_corrected.proved in
let _ := Trigonometric.Part_Half_printed_proofs.half_d1_slip_corrected.met in
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
let _ := Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew.proved in
let _ := Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew.met in
let _ := Trigonometric.Part_Helicoid_printed_proofs.helicoid_skew_slip.refuted in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew.met in
let _ := Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_speed.proved in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_speed.met in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_torsion.proved in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_torsion.met in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_curvature.proved in
let _ := Trigonometric.Part_Helix_printed_proofs.helix_curvature.met in
let _ := Trigonometric.Part_Helix_proofs.helix_speed.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_speed.met in
let _ := Trigonometric.Part_Helix_proofs.helix_torsion.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_torsion.met in
let _ := Trigonometric.Part_Helix_proofs.helix_curvature.proved in
let _ := Trigonometric.Part_Helix_proofs.helix_curvature.met in
let _ := Trigonometric.Part_Joins_printed_proofs.quadratic_join.proved in
let _ := Trigonometric.Part_Joins_printed_proofs.quadratic_join.met in
let _ := Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip.refuted in
let _ := Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip_corrected.proved in
let _ := Trigonometric.Part_Joins_printed_proofs.quadratic_join_slip_corrected.met in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join.proved in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join.met in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved in
let _ := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met in
let _ := Trigonometric.Part_Known_printed_proofs.angle_known.proved in
let _ := Trigonometric.Part_Known_proofs.angle_known.proved in
let _ := Trigonometric.Part_Parts_printed_proofs.angle_third.proved in
let _ := Trigonometric.Part_Parts_printed_proofs.angle_parts.proved in
let _ := Trigonometric.Part_Parts_printed_proofs.angle_rate.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_third.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_parts.proved in
let _ := Trigonometric.Part_Parts_proofs.angle_rate.proved in
let _ := Trigonometric.Part_Roots_printed_proofs.helix_length.proved in
let _ := Trigonometric.Part_Roots_printed_proofs.helix_length.met in
let _ := Trigonometric.Part_Roots_printed_proofs.helix_bend.proved in
let _ := Trigonometric.Part_Roots_printed_proofs.helix_bend.met in
let _ := Trigonometric.Part_Roots_printed_proofs.helix_bend_slip.refuted in
let _ := Trigonometric.Part_Roots_printed_proofs.cylinder_normal.proved in
let _ := Trigonometric.Part_Roots_printed_proofs.cylinder_normal.met in
let _ := Trigonometric.Part_Roots_printed_proofs.cylinder_offset.proved in
let _ := Trigonometric.Part_Roots_printed_proofs.cylinder_offset.met in
let _ := Trigonometric.Part_Roots_proofs.helix_length.proved in
let _ := Trigonometric.Part_Roots_proofs.helix_length.met in
let _ := Trigonometric.Part_Roots_proofs.helix_bend.proved in
let _ := Trigonometric.Part_Roots_proofs.helix_bend.met in
let _ := Trigonometric.Part_Roots_proofs.helix_bend_slip.refuted in
let _ := Trigonometric.Part_Roots_proofs.cylinder_normal.proved in
let _ := Trigonometric.Part_Roots_proofs.cylinder_normal.met in
let _ := Trigonometric.Part_Roots_proofs.cylinder_offset.proved in
let _ := Trigonometric.Part_Roots_proofs.cylinder_offset.met in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_first.proved in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_first.met in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_first_turned.proved in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_first_turned.met in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_symmetric.proved in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_symmetric.met in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_symmetric_slip.refuted in
let _ := Trigonometric.Part_Signs_printed_proofs.angle_turn.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_first.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_first.met in
let _ := Trigonometric.Part_Signs_proofs.angle_first_turned.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_first_turned.met in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric.proved in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric.met in
let _ := Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted in
let _ := Trigonometric.Part_Signs_proofs.angle_turn.proved in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_torse.proved in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_torse.met in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_normal.proved in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_normal.met in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_regular.proved in
let _ := Trigonometric.Part_Tangent_printed_proofs.helix_regular.met in
let _ := Trigonometric.Part_Tangent_proofs.helix_torse.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_torse.met in
let _ := Trigonometric.Part_Tangent_proofs.helix_normal.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_normal.met in
let _ := Trigonometric.Part_Tangent_proofs.helix_regular.proved in
let _ := Trigonometric.Part_Tangent_proofs.helix_regular.met in
let _ := Trigonometric.Part_Tangents_printed_proofs.angle_tangent.proved in
let _ := Trigonometric.Part_Tangents_printed_proofs.angle_tangent.met in
let _ := Trigonometric.Part_Tangents_printed_proofs.angle_tangent_closed.proved in
let _ := Trigonometric.Part_Tangents_printed_proofs.angle_tangent_closed.met in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent.proved in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent.met in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved in
let _ := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_middle.proved in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_middle.met in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_nonnegative.proved in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_nonnegative.met in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_nonnegative_slip.refuted in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_symmetry.proved in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_symmetry.met in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_decreasing.proved in
let _ := Trigonometric.Part_The_printed_proofs.quadratic_decreasing.met in
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
