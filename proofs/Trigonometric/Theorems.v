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
Check (Part_Cardioid_printed_proofs.cardioid_speed.proved : Part_Cardioid_printed.cardioid_speed.statement).
Check (Part_Cardioid_printed_proofs.cardioid_speed.met : Part_Cardioid_printed.cardioid_speed.instance).
Check (Part_Cardioid_printed_proofs.cardioid_cusp.proved : Part_Cardioid_printed.cardioid_cusp.statement).
Check (Part_Cardioid_printed_proofs.cardioid_curvature.proved : Part_Cardioid_printed.cardioid_curvature.statement).
Check (Part_Cardioid_printed_proofs.cardioid_curvature.met : Part_Cardioid_printed.cardioid_curvature.instance).
Check (Part_Cardioid_proofs.cardioid_speed.proved : Part_Cardioid.cardioid_speed.statement).
Check (Part_Cardioid_proofs.cardioid_speed.met : Part_Cardioid.cardioid_speed.instance).
Check (Part_Cardioid_proofs.cardioid_cusp.proved : Part_Cardioid.cardioid_cusp.statement).
Check (Part_Cardioid_proofs.cardioid_curvature.proved : Part_Cardioid.cardioid_curvature.statement).
Check (Part_Cardioid_proofs.cardioid_curvature.met : Part_Cardioid.cardioid_curvature.instance).
Check (Part_Circles_printed_proofs.quadratic_circle.proved : Part_Circles_printed.quadratic_circle.statement).
Check (Part_Circles_printed_proofs.quadratic_circle.met : Part_Circles_printed.quadratic_circle.instance).
Check (Part_Circles_proofs.quadratic_circle.proved : Part_Circles.quadratic_circle.statement).
Check (Part_Circles_proofs.quadratic_circle.met : Part_Circles.quadratic_circle.instance).
Check (Part_Curves_printed_proofs.quadratic_ends.proved : Part_Curves_printed.quadratic_ends.statement).
Check (Part_Curves_printed_proofs.quadratic_ends.met : Part_Curves_printed.quadratic_ends.instance).
Check (Part_Curves_printed_proofs.quadratic_d1.proved : Part_Curves_printed.quadratic_d1.statement).
Check (Part_Curves_printed_proofs.quadratic_d1.met : Part_Curves_printed.quadratic_d1.instance).
Check (Part_Curves_printed_proofs.quadratic_d2.proved : Part_Curves_printed.quadratic_d2.statement).
Check (Part_Curves_printed_proofs.quadratic_d2.met : Part_Curves_printed.quadratic_d2.instance).
Check (Part_Curves_printed_proofs.quadratic_d1_slip.refuted : ~ Part_Curves_printed.quadratic_d1_slip.statement).
Check (Part_Curves_printed_proofs.quadratic_d1_slip_corrected.proved : Part_Curves_printed.quadratic_d1_slip_corrected.statement).
Check (Part_Curves_printed_proofs.quadratic_d1_slip_corrected.met : Part_Curves_printed.quadratic_d1_slip_corrected.instance).
Check (Part_Curves_proofs.quadratic_ends.proved : Part_Curves.quadratic_ends.statement).
Check (Part_Curves_proofs.quadratic_ends.met : Part_Curves.quadratic_ends.instance).
Check (Part_Curves_proofs.quadratic_d1.proved : Part_Curves.quadratic_d1.statement).
Check (Part_Curves_proofs.quadratic_d1.met : Part_Curves.quadratic_d1.instance).
Check (Part_Curves_proofs.quadratic_d2.proved : Part_Curves.quadratic_d2.statement).
Check (Part_Curves_proofs.quadratic_d2.met : Part_Curves.quadratic_d2.instance).
Check (Part_Curves_proofs.quadratic_d1_slip.refuted : ~ Part_Curves.quadratic_d1_slip.statement).
Check (Part_Curves_proofs.quadratic_d1_slip_corrected.proved : Part_Curves.quadratic_d1_slip_corrected.statement).
Check (Part_Curves_proofs.quadratic_d1_slip_corrected.met : Part_Curves.quadratic_d1_slip_corrected.instance).
Check (Part_Cycloid_printed_proofs.cycloid_speed.proved : Part_Cycloid_printed.cycloid_speed.statement).
Check (Part_Cycloid_printed_proofs.cycloid_speed.met : Part_Cycloid_printed.cycloid_speed.instance).
Check (Part_Cycloid_printed_proofs.cycloid_regular.proved : Part_Cycloid_printed.cycloid_regular.statement).
Check (Part_Cycloid_printed_proofs.cycloid_regular.met : Part_Cycloid_printed.cycloid_regular.instance).
Check (Part_Cycloid_printed_proofs.cycloid_slope.proved : Part_Cycloid_printed.cycloid_slope.statement).
Check (Part_Cycloid_printed_proofs.cycloid_slope.met : Part_Cycloid_printed.cycloid_slope.instance).
Check (Part_Cycloid_printed_proofs.cycloid_slope_slip.refuted : ~ Part_Cycloid_printed.cycloid_slope_slip.statement).
Check (Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.proved : Part_Cycloid_printed.cycloid_slope_slip_corrected.statement).
Check (Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.met : Part_Cycloid_printed.cycloid_slope_slip_corrected.instance).
Check (Part_Cycloid_printed_proofs.cycloid_bend.proved : Part_Cycloid_printed.cycloid_bend.statement).
Check (Part_Cycloid_printed_proofs.cycloid_bend.met : Part_Cycloid_printed.cycloid_bend.instance).
Check (Part_Cycloid_printed_proofs.cycloid_curvature.proved : Part_Cycloid_printed.cycloid_curvature.statement).
Check (Part_Cycloid_printed_proofs.cycloid_curvature.met : Part_Cycloid_printed.cycloid_curvature.instance).
Check (Part_Cycloid_proofs.cycloid_speed.proved : Part_Cycloid.cycloid_speed.statement).
Check (Part_Cycloid_proofs.cycloid_speed.met : Part_Cycloid.cycloid_speed.instance).
Check (Part_Cycloid_proofs.cycloid_regular.proved : Part_Cycloid.cycloid_regular.statement).
Check (Part_Cycloid_proofs.cycloid_regular.met : Part_Cycloid.cycloid_regular.instance).
Check (Part_Cycloid_proofs.cycloid_slope.proved : Part_Cycloid.cycloid_slope.statement).
Check (Part_Cycloid_proofs.cycloid_slope.met : Part_Cycloid.cycloid_slope.instance).
Check (Part_Cycloid_proofs.cycloid_slope_slip.refuted : ~ Part_Cycloid.cycloid_slope_slip.statement).
Check (Part_Cycloid_proofs.cycloid_slope_slip_corrected.proved : Part_Cycloid.cycloid_slope_slip_corrected.statement).
Check (Part_Cycloid_proofs.cycloid_slope_slip_corrected.met : Part_Cycloid.cycloid_slope_slip_corrected.instance).
Check (Part_Cycloid_proofs.cycloid_bend.proved : Part_Cycloid.cycloid_bend.statement).
Check (Part_Cycloid_proofs.cycloid_bend.met : Part_Cycloid.cycloid_bend.instance).
Check (Part_Cycloid_proofs.cycloid_curvature.proved : Part_Cycloid.cycloid_curvature.statement).
Check (Part_Cycloid_proofs.cycloid_curvature.met : Part_Cycloid.cycloid_curvature.instance).
Check (Part_Half_printed_proofs.angle_half_sine.proved : Part_Half_printed.angle_half_sine.statement).
Check (Part_Half_printed_proofs.angle_half_cosine.proved : Part_Half_printed.angle_half_cosine.statement).
Check (Part_Half_printed_proofs.angle_half_slip.refuted : ~ Part_Half_printed.angle_half_slip.statement).
Check (Part_Half_printed_proofs.angle_half_slip_corrected.proved : Part_Half_printed.angle_half_slip_corrected.statement).
Check (Part_Half_printed_proofs.half_unity.proved : Part_Half_printed.half_unity.statement).
Check (Part_Half_printed_proofs.half_unity.met : Part_Half_printed.half_unity.instance).
Check (Part_Half_printed_proofs.half_middle.proved : Part_Half_printed.half_middle.statement).
Check (Part_Half_printed_proofs.half_middle.met : Part_Half_printed.half_middle.instance).
Check (Part_Half_printed_proofs.half_sine.proved : Part_Half_printed.half_sine.statement).
Check (Part_Half_printed_proofs.half_sine.met : Part_Half_printed.half_sine.instance).
Check (Part_Half_printed_proofs.half_cosine.proved : Part_Half_printed.half_cosine.statement).
Check (Part_Half_printed_proofs.half_cosine.met : Part_Half_printed.half_cosine.instance).
Check (Part_Half_printed_proofs.half_cosine_slip.refuted : ~ Part_Half_printed.half_cosine_slip.statement).
Check (Part_Half_printed_proofs.half_powers.proved : Part_Half_printed.half_powers.statement).
Check (Part_Half_printed_proofs.half_powers.met : Part_Half_printed.half_powers.instance).
Check (Part_Half_printed_proofs.half_d1.proved : Part_Half_printed.half_d1.statement).
Check (Part_Half_printed_proofs.half_d1.met : Part_Half_printed.half_d1.instance).
Check (Part_Half_printed_proofs.half_d1_slip.refuted : ~ Part_Half_printed.half_d1_slip.statement).
Check (Part_Half_printed_proofs.half_d1_slip_corrected.proved : Part_Half_printed.half_d1_slip_corrected.statement).
Check (Part_Half_printed_proofs.half_d1_slip_corrected.met : Part_Half_printed.half_d1_slip_corrected.instance).
Check (Part_Half_proofs.angle_half_sine.proved : Part_Half.angle_half_sine.statement).
Check (Part_Half_proofs.angle_half_cosine.proved : Part_Half.angle_half_cosine.statement).
Check (Part_Half_proofs.angle_half_slip.refuted : ~ Part_Half.angle_half_slip.statement).
Check (Part_Half_proofs.angle_half_slip_corrected.proved : Part_Half.angle_half_slip_corrected.statement).
Check (Part_Half_proofs.half_unity.proved : Part_Half.half_unity.statement).
Check (Part_Half_proofs.half_unity.met : Part_Half.half_unity.instance).
Check (Part_Half_proofs.half_middle.proved : Part_Half.half_middle.statement).
Check (Part_Half_proofs.half_middle.met : Part_Half.half_middle.instance).
Check (Part_Half_proofs.half_sine.proved : Part_Half.half_sine.statement).
Check (Part_Half_proofs.half_sine.met : Part_Half.half_sine.instance).
Check (Part_Half_proofs.half_cosine.proved : Part_Half.half_cosine.statement).
Check (Part_Half_proofs.half_cosine.met : Part_Half.half_cosine.instance).
Check (Part_Half_proofs.half_cosine_slip.refuted : ~ Part_Half.half_cosine_slip.statement).
Check (Part_Half_proofs.half_powers.proved : Part_Half.half_powers.statement).
Check (Part_Half_proofs.half_powers.met : Part_Half.half_powers.instance).
Check (Part_Half_proofs.half_d1.proved : Part_Half.half_d1.statement).
Check (Part_Half_proofs.half_d1.met : Part_Half.half_d1.instance).
Check (Part_Half_proofs.half_d1_slip.refuted : ~ Part_Half.half_d1_slip.statement).
Check (Part_Half_proofs.half_d1_slip_corrected.proved : Part_Half.half_d1_slip_corrected.statement).
Check (Part_Half_proofs.half_d1_slip_corrected.met : Part_Half.half_d1_slip_corrected.instance).
Check (Part_Helicoid_printed_proofs.helicoid_skew.proved : Part_Helicoid_printed.helicoid_skew.statement).
Check (Part_Helicoid_printed_proofs.helicoid_skew.met : Part_Helicoid_printed.helicoid_skew.instance).
Check (Part_Helicoid_printed_proofs.helicoid_skew_slip.refuted : ~ Part_Helicoid_printed.helicoid_skew_slip.statement).
Check (Part_Helicoid_proofs.helicoid_skew.proved : Part_Helicoid.helicoid_skew.statement).
Check (Part_Helicoid_proofs.helicoid_skew.met : Part_Helicoid.helicoid_skew.instance).
Check (Part_Helicoid_proofs.helicoid_skew_slip.refuted : ~ Part_Helicoid.helicoid_skew_slip.statement).
Check (Part_Helix_printed_proofs.helix_speed.proved : Part_Helix_printed.helix_speed.statement).
Check (Part_Helix_printed_proofs.helix_speed.met : Part_Helix_printed.helix_speed.instance).
Check (Part_Helix_printed_proofs.helix_torsion.proved : Part_Helix_printed.helix_torsion.statement).
Check (Part_Helix_printed_proofs.helix_torsion.met : Part_Helix_printed.helix_torsion.instance).
Check (Part_Helix_printed_proofs.helix_curvature.proved : Part_Helix_printed.helix_curvature.statement).
Check (Part_Helix_printed_proofs.helix_curvature.met : Part_Helix_printed.helix_curvature.instance).
Check (Part_Helix_proofs.helix_speed.proved : Part_Helix.helix_speed.statement).
Check (Part_Helix_proofs.helix_speed.met : Part_Helix.helix_speed.instance).
Check (Part_Helix_proofs.helix_torsion.proved : Part_Helix.helix_torsion.statement).
Check (Part_Helix_proofs.helix_torsion.met : Part_Helix.helix_torsion.instance).
Check (Part_Helix_proofs.helix_curvature.proved : Part_Helix.helix_curvature.statement).
Check (Part_Helix_proofs.helix_curvature.met : Part_Helix.helix_curvature.instance).
Check (Part_Joins_printed_proofs.quadratic_join.proved : Part_Joins_printed.quadratic_join.statement).
Check (Part_Joins_printed_proofs.quadratic_join.met : Part_Joins_printed.quadratic_join.instance).
Check (Part_Joins_printed_proofs.quadratic_join_slip.refuted : ~ Part_Joins_printed.quadratic_join_slip.statement).
Check (Part_Joins_printed_proofs.quadratic_join_slip_corrected.proved : Part_Joins_printed.quadratic_join_slip_corrected.statement).
Check (Part_Joins_printed_proofs.quadratic_join_slip_corrected.met : Part_Joins_printed.quadratic_join_slip_corrected.instance).
Check (Part_Joins_proofs.quadratic_join.proved : Part_Joins.quadratic_join.statement).
Check (Part_Joins_proofs.quadratic_join.met : Part_Joins.quadratic_join.instance).
Check (Part_Joins_proofs.quadratic_join_slip.refuted : ~ Part_Joins.quadratic_join_slip.statement).
Check (Part_Joins_proofs.quadratic_join_slip_corrected.proved : Part_Joins.quadratic_join_slip_corrected.statement).
Check (Part_Joins_proofs.quadratic_join_slip_corrected.met : Part_Joins.quadratic_join_slip_corrected.instance).
Check (Part_Known_printed_proofs.angle_known.proved : Part_Known_printed.angle_known.statement).
Check (Part_Known_proofs.angle_known.proved : Part_Known.angle_known.statement).
Check (Part_Parts_printed_proofs.angle_third.proved : Part_Parts_printed.angle_third.statement).
Check (Part_Parts_printed_proofs.angle_parts.proved : Part_Parts_printed.angle_parts.statement).
Check (Part_Parts_printed_proofs.angle_rate.proved : Part_Parts_printed.angle_rate.statement).
Check (Part_Parts_proofs.angle_third.proved : Part_Parts.angle_third.statement).
Check (Part_Parts_proofs.angle_parts.proved : Part_Parts.angle_parts.statement).
Check (Part_Parts_proofs.angle_rate.proved : Part_Parts.angle_rate.statement).
Check (Part_Roots_printed_proofs.helix_length.proved : Part_Roots_printed.helix_length.statement).
Check (Part_Roots_printed_proofs.helix_length.met : Part_Roots_printed.helix_length.instance).
Check (Part_Roots_printed_proofs.helix_bend.proved : Part_Roots_printed.helix_bend.statement).
Check (Part_Roots_printed_proofs.helix_bend.met : Part_Roots_printed.helix_bend.instance).
Check (Part_Roots_printed_proofs.helix_bend_slip.refuted : ~ Part_Roots_printed.helix_bend_slip.statement).
Check (Part_Roots_printed_proofs.cylinder_normal.proved : Part_Roots_printed.cylinder_normal.statement).
Check (Part_Roots_printed_proofs.cylinder_normal.met : Part_Roots_printed.cylinder_normal.instance).
Check (Part_Roots_printed_proofs.cylinder_offset.proved : Part_Roots_printed.cylinder_offset.statement).
Check (Part_Roots_printed_proofs.cylinder_offset.met : Part_Roots_printed.cylinder_offset.instance).
Check (Part_Roots_proofs.helix_length.proved : Part_Roots.helix_length.statement).
Check (Part_Roots_proofs.helix_length.met : Part_Roots.helix_length.instance).
Check (Part_Roots_proofs.helix_bend.proved : Part_Roots.helix_bend.statement).
Check (Part_Roots_proofs.helix_bend.met : Part_Roots.helix_bend.instance).
Check (Part_Roots_proofs.helix_bend_slip.refuted : ~ Part_Roots.helix_bend_slip.statement).
Check (Part_Roots_proofs.cylinder_normal.proved : Part_Roots.cylinder_normal.statement).
Check (Part_Roots_proofs.cylinder_normal.met : Part_Roots.cylinder_normal.instance).
Check (Part_Roots_proofs.cylinder_offset.proved : Part_Roots.cylinder_offset.statement).
Check (Part_Roots_proofs.cylinder_offset.met : Part_Roots.cylinder_offset.instance).
Check (Part_Signs_printed_proofs.angle_first.proved : Part_Signs_printed.angle_first.statement).
Check (Part_Signs_printed_proofs.angle_first.met : Part_Signs_printed.angle_first.instance).
Check (Part_Signs_printed_proofs.angle_first_turned.proved : Part_Signs_printed.angle_first_turned.statement).
Check (Part_Signs_printed_proofs.angle_first_turned.met : Part_Signs_printed.angle_first_turned.instance).
Check (Part_Signs_printed_proofs.angle_symmetric.proved : Part_Signs_printed.angle_symmetric.statement).
Check (Part_Signs_printed_proofs.angle_symmetric.met : Part_Signs_printed.angle_symmetric.instance).
Check (Part_Signs_printed_proofs.angle_symmetric_slip.refuted : ~ Part_Signs_printed.angle_symmetric_slip.statement).
Check (Part_Signs_printed_proofs.angle_turn.proved : Part_Signs_printed.angle_turn.statement).
Check (Part_Signs_proofs.angle_first.proved : Part_Signs.angle_first.statement).
Check (Part_Signs_proofs.angle_first.met : Part_Signs.angle_first.instance).
Check (Part_Signs_proofs.angle_first_turned.proved : Part_Signs.angle_first_turned.statement).
Check (Part_Signs_proofs.angle_first_turned.met : Part_Signs.angle_first_turned.instance).
Check (Part_Signs_proofs.angle_symmetric.proved : Part_Signs.angle_symmetric.statement).
Check (Part_Signs_proofs.angle_symmetric.met : Part_Signs.angle_symmetric.instance).
Check (Part_Signs_proofs.angle_symmetric_slip.refuted : ~ Part_Signs.angle_symmetric_slip.statement).
Check (Part_Signs_proofs.angle_turn.proved : Part_Signs.angle_turn.statement).
Check (Part_Tangent_printed_proofs.helix_torse.proved : Part_Tangent_printed.helix_torse.statement).
Check (Part_Tangent_printed_proofs.helix_torse.met : Part_Tangent_printed.helix_torse.instance).
Check (Part_Tangent_printed_proofs.helix_normal.proved : Part_Tangent_printed.helix_normal.statement).
Check (Part_Tangent_printed_proofs.helix_normal.met : Part_Tangent_printed.helix_normal.instance).
Check (Part_Tangent_printed_proofs.helix_regular.proved : Part_Tangent_printed.helix_regular.statement).
Check (Part_Tangent_printed_proofs.helix_regular.met : Part_Tangent_printed.helix_regular.instance).
Check (Part_Tangent_proofs.helix_torse.proved : Part_Tangent.helix_torse.statement).
Check (Part_Tangent_proofs.helix_torse.met : Part_Tangent.helix_torse.instance).
Check (Part_Tangent_proofs.helix_normal.proved : Part_Tangent.helix_normal.statement).
Check (Part_Tangent_proofs.helix_normal.met : Part_Tangent.helix_normal.instance).
Check (Part_Tangent_proofs.helix_regular.proved : Part_Tangent.helix_regular.statement).
Check (Part_Tangent_proofs.helix_regular.met : Part_Tangent.helix_regular.instance).
Check (Part_Tangents_printed_proofs.angle_tangent.proved : Part_Tangents_printed.angle_tangent.statement).
Check (Part_Tangents_printed_proofs.angle_tangent.met : Part_Tangents_printed.angle_tangent.instance).
Check (Part_Tangents_printed_proofs.angle_tangent_closed.proved : Part_Tangents_printed.angle_tangent_closed.statement).
Check (Part_Tangents_printed_proofs.angle_tangent_closed.met : Part_Tangents_printed.angle_tangent_closed.instance).
Check (Part_Tangents_proofs.angle_tangent.proved : Part_Tangents.angle_tangent.statement).
Check (Part_Tangents_proofs.angle_tangent.met : Part_Tangents.angle_tangent.instance).
Check (Part_Tangents_proofs.angle_tangent_closed.proved : Part_Tangents.angle_tangent_closed.statement).
Check (Part_Tangents_proofs.angle_tangent_closed.met : Part_Tangents.angle_tangent_closed.instance).
Check (Part_The_printed_proofs.quadratic_middle.proved : Part_The_printed.quadratic_middle.statement).
Check (Part_The_printed_proofs.quadratic_middle.met : Part_The_printed.quadratic_middle.instance).
Check (Part_The_printed_proofs.quadratic_nonnegative.proved : Part_The_printed.quadratic_nonnegative.statement).
Check (Part_The_printed_proofs.quadratic_nonnegative.met : Part_The_printed.quadratic_nonnegative.instance).
Check (Part_The_printed_proofs.quadratic_nonnegative_slip.refuted : ~ Part_The_printed.quadratic_nonnegative_slip.statement).
Check (Part_The_printed_proofs.quadratic_symmetry.proved : Part_The_printed.quadratic_symmetry.statement).
Check (Part_The_printed_proofs.quadratic_symmetry.met : Part_The_printed.quadratic_symmetry.instance).
Check (Part_The_printed_proofs.quadratic_decreasing.proved : Part_The_printed.quadratic_decreasing.statement).
Check (Part_The_printed_proofs.quadratic_decreasing.met : Part_The_printed.quadratic_decreasing.instance).
Check (Part_The_proofs.quadratic_middle.proved : Part_The.quadratic_middle.statement).
Check (Part_The_proofs.quadratic_middle.met : Part_The.quadratic_middle.instance).
Check (Part_The_proofs.quadratic_nonnegative.proved : Part_The.quadratic_nonnegative.statement).
Check (Part_The_proofs.quadratic_nonnegative.met : Part_The.quadratic_nonnegative.instance).
Check (Part_The_proofs.quadratic_nonnegative_slip.refuted : ~ Part_The.quadratic_nonnegative_slip.statement).
Check (Part_The_proofs.quadratic_symmetry.proved : Part_The.quadratic_symmetry.statement).
Check (Part_The_proofs.quadratic_symmetry.met : Part_The.quadratic_symmetry.instance).
Check (Part_The_proofs.quadratic_decreasing.proved : Part_The.quadratic_decreasing.statement).
Check (Part_The_proofs.quadratic_decreasing.met : Part_The.quadratic_decreasing.instance).
Definition all_theorems : True :=
let _ := Part_Cardioid_printed_proofs.cardioid_speed.proved in
let _ := Part_Cardioid_printed_proofs.cardioid_speed.met in
let _ := Part_Cardioid_printed_proofs.cardioid_cusp.proved in
let _ := Part_Cardioid_printed_proofs.cardioid_curvature.proved in
let _ := Part_Cardioid_printed_proofs.cardioid_curvature.met in
let _ := Part_Cardioid_proofs.cardioid_speed.proved in
let _ := Part_Cardioid_proofs.cardioid_speed.met in
let _ := Part_Cardioid_proofs.cardioid_cusp.proved in
let _ := Part_Cardioid_proofs.cardioid_curvature.proved in
let _ := Part_Cardioid_proofs.cardioid_curvature.met in
let _ := Part_Circles_printed_proofs.quadratic_circle.proved in
let _ := Part_Circles_printed_proofs.quadratic_circle.met in
let _ := Part_Circles_proofs.quadratic_circle.proved in
let _ := Part_Circles_proofs.quadratic_circle.met in
let _ := Part_Curves_printed_proofs.quadratic_ends.proved in
let _ := Part_Curves_printed_proofs.quadratic_ends.met in
let _ := Part_Curves_printed_proofs.quadratic_d1.proved in
let _ := Part_Curves_printed_proofs.quadratic_d1.met in
let _ := Part_Curves_printed_proofs.quadratic_d2.proved in
let _ := Part_Curves_printed_proofs.quadratic_d2.met in
let _ := Part_Curves_printed_proofs.quadratic_d1_slip.refuted in
let _ := Part_Curves_printed_proofs.quadratic_d1_slip_corrected.proved in
let _ := Part_Curves_printed_proofs.quadratic_d1_slip_corrected.met in
let _ := Part_Curves_proofs.quadratic_ends.proved in
let _ := Part_Curves_proofs.quadratic_ends.met in
let _ := Part_Curves_proofs.quadratic_d1.proved in
let _ := Part_Curves_proofs.quadratic_d1.met in
let _ := Part_Curves_proofs.quadratic_d2.proved in
let _ := Part_Curves_proofs.quadratic_d2.met in
let _ := Part_Curves_proofs.quadratic_d1_slip.refuted in
let _ := Part_Curves_proofs.quadratic_d1_slip_corrected.proved in
let _ := Part_Curves_proofs.quadratic_d1_slip_corrected.met in
let _ := Part_Cycloid_printed_proofs.cycloid_speed.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_speed.met in
let _ := Part_Cycloid_printed_proofs.cycloid_regular.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_regular.met in
let _ := Part_Cycloid_printed_proofs.cycloid_slope.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_slope.met in
let _ := Part_Cycloid_printed_proofs.cycloid_slope_slip.refuted in
let _ := Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_slope_slip_corrected.met in
let _ := Part_Cycloid_printed_proofs.cycloid_bend.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_bend.met in
let _ := Part_Cycloid_printed_proofs.cycloid_curvature.proved in
let _ := Part_Cycloid_printed_proofs.cycloid_curvature.met in
let _ := Part_Cycloid_proofs.cycloid_speed.proved in
let _ := Part_Cycloid_proofs.cycloid_speed.met in
let _ := Part_Cycloid_proofs.cycloid_regular.proved in
let _ := Part_Cycloid_proofs.cycloid_regular.met in
let _ := Part_Cycloid_proofs.cycloid_slope.proved in
let _ := Part_Cycloid_proofs.cycloid_slope.met in
let _ := Part_Cycloid_proofs.cycloid_slope_slip.refuted in
let _ := Part_Cycloid_proofs.cycloid_slope_slip_corrected.proved in
let _ := Part_Cycloid_proofs.cycloid_slope_slip_corrected.met in
let _ := Part_Cycloid_proofs.cycloid_bend.proved in
let _ := Part_Cycloid_proofs.cycloid_bend.met in
let _ := Part_Cycloid_proofs.cycloid_curvature.proved in
let _ := Part_Cycloid_proofs.cycloid_curvature.met in
let _ := Part_Half_printed_proofs.angle_half_sine.proved in
let _ := Part_Half_printed_proofs.angle_half_cosine.proved in
let _ := Part_Half_printed_proofs.angle_half_slip.refuted in
let _ := Part_Half_printed_proofs.angle_half_slip_corrected.proved in
let _ := Part_Half_printed_proofs.half_unity.proved in
let _ := Part_Half_printed_proofs.half_unity.met in
let _ := Part_Half_printed_proofs.half_middle.proved in
let _ := Part_Half_printed_proofs.half_middle.met in
let _ := Part_Half_printed_proofs.half_sine.proved in
let _ := Part_Half_printed_proofs.half_sine.met in
let _ := Part_Half_printed_proofs.half_cosine.proved in
let _ := Part_Half_printed_proofs.half_cosine.met in
let _ := Part_Half_printed_proofs.half_cosine_slip.refuted in
let _ := Part_Half_printed_proofs.half_powers.proved in
let _ := Part_Half_printed_proofs.half_powers.met in
let _ := Part_Half_printed_proofs.half_d1.proved in
let _ := Part_Half_printed_proofs.half_d1.met in
let _ := Part_Half_printed_proofs.half_d1_slip.refuted in
let _ := Part_Half_printed_proofs.half_d1_slip_corrected.proved in
let _ := Part_Half_printed_proofs.half_d1_slip_corrected.met in
let _ := Part_Half_proofs.angle_half_sine.proved in
let _ := Part_Half_proofs.angle_half_cosine.proved in
let _ := Part_Half_proofs.angle_half_slip.refuted in
let _ := Part_Half_proofs.angle_half_slip_corrected.proved in
let _ := Part_Half_proofs.half_unity.proved in
let _ := Part_Half_proofs.half_unity.met in
let _ := Part_Half_proofs.half_middle.proved in
let _ := Part_Half_proofs.half_middle.met in
let _ := Part_Half_proofs.half_sine.proved in
let _ := Part_Half_proofs.half_sine.met in
let _ := Part_Half_proofs.half_cosine.proved in
let _ := Part_Half_proofs.half_cosine.met in
let _ := Part_Half_proofs.half_cosine_slip.refuted in
let _ := Part_Half_proofs.half_powers.proved in
let _ := Part_Half_proofs.half_powers.met in
let _ := Part_Half_proofs.half_d1.proved in
let _ := Part_Half_proofs.half_d1.met in
let _ := Part_Half_proofs.half_d1_slip.refuted in
let _ := Part_Half_proofs.half_d1_slip_corrected.proved in
let _ := Part_Half_proofs.half_d1_slip_corrected.met in
let _ := Part_Helicoid_printed_proofs.helicoid_skew.proved in
let _ := Part_Helicoid_printed_proofs.helicoid_skew.met in
let _ := Part_Helicoid_printed_proofs.helicoid_skew_slip.refuted in
let _ := Part_Helicoid_proofs.helicoid_skew.proved in
let _ := Part_Helicoid_proofs.helicoid_skew.met in
let _ := Part_Helicoid_proofs.helicoid_skew_slip.refuted in
let _ := Part_Helix_printed_proofs.helix_speed.proved in
let _ := Part_Helix_printed_proofs.helix_speed.met in
let _ := Part_Helix_printed_proofs.helix_torsion.proved in
let _ := Part_Helix_printed_proofs.helix_torsion.met in
let _ := Part_Helix_printed_proofs.helix_curvature.proved in
let _ := Part_Helix_printed_proofs.helix_curvature.met in
let _ := Part_Helix_proofs.helix_speed.proved in
let _ := Part_Helix_proofs.helix_speed.met in
let _ := Part_Helix_proofs.helix_torsion.proved in
let _ := Part_Helix_proofs.helix_torsion.met in
let _ := Part_Helix_proofs.helix_curvature.proved in
let _ := Part_Helix_proofs.helix_curvature.met in
let _ := Part_Joins_printed_proofs.quadratic_join.proved in
let _ := Part_Joins_printed_proofs.quadratic_join.met in
let _ := Part_Joins_printed_proofs.quadratic_join_slip.refuted in
let _ := Part_Joins_printed_proofs.quadratic_join_slip_corrected.proved in
let _ := Part_Joins_printed_proofs.quadratic_join_slip_corrected.met in
let _ := Part_Joins_proofs.quadratic_join.proved in
let _ := Part_Joins_proofs.quadratic_join.met in
let _ := Part_Joins_proofs.quadratic_join_slip.refuted in
let _ := Part_Joins_proofs.quadratic_join_slip_corrected.proved in
let _ := Part_Joins_proofs.quadratic_join_slip_corrected.met in
let _ := Part_Known_printed_proofs.angle_known.proved in
let _ := Part_Known_proofs.angle_known.proved in
let _ := Part_Parts_printed_proofs.angle_third.proved in
let _ := Part_Parts_printed_proofs.angle_parts.proved in
let _ := Part_Parts_printed_proofs.angle_rate.proved in
let _ := Part_Parts_proofs.angle_third.proved in
let _ := Part_Parts_proofs.angle_parts.proved in
let _ := Part_Parts_proofs.angle_rate.proved in
let _ := Part_Roots_printed_proofs.helix_length.proved in
let _ := Part_Roots_printed_proofs.helix_length.met in
let _ := Part_Roots_printed_proofs.helix_bend.proved in
let _ := Part_Roots_printed_proofs.helix_bend.met in
let _ := Part_Roots_printed_proofs.helix_bend_slip.refuted in
let _ := Part_Roots_printed_proofs.cylinder_normal.proved in
let _ := Part_Roots_printed_proofs.cylinder_normal.met in
let _ := Part_Roots_printed_proofs.cylinder_offset.proved in
let _ := Part_Roots_printed_proofs.cylinder_offset.met in
let _ := Part_Roots_proofs.helix_length.proved in
let _ := Part_Roots_proofs.helix_length.met in
let _ := Part_Roots_proofs.helix_bend.proved in
let _ := Part_Roots_proofs.helix_bend.met in
let _ := Part_Roots_proofs.helix_bend_slip.refuted in
let _ := Part_Roots_proofs.cylinder_normal.proved in
let _ := Part_Roots_proofs.cylinder_normal.met in
let _ := Part_Roots_proofs.cylinder_offset.proved in
let _ := Part_Roots_proofs.cylinder_offset.met in
let _ := Part_Signs_printed_proofs.angle_first.proved in
let _ := Part_Signs_printed_proofs.angle_first.met in
let _ := Part_Signs_printed_proofs.angle_first_turned.proved in
let _ := Part_Signs_printed_proofs.angle_first_turned.met in
let _ := Part_Signs_printed_proofs.angle_symmetric.proved in
let _ := Part_Signs_printed_proofs.angle_symmetric.met in
let _ := Part_Signs_printed_proofs.angle_symmetric_slip.refuted in
let _ := Part_Signs_printed_proofs.angle_turn.proved in
let _ := Part_Signs_proofs.angle_first.proved in
let _ := Part_Signs_proofs.angle_first.met in
let _ := Part_Signs_proofs.angle_first_turned.proved in
let _ := Part_Signs_proofs.angle_first_turned.met in
let _ := Part_Signs_proofs.angle_symmetric.proved in
let _ := Part_Signs_proofs.angle_symmetric.met in
let _ := Part_Signs_proofs.angle_symmetric_slip.refuted in
let _ := Part_Signs_proofs.angle_turn.proved in
let _ := Part_Tangent_printed_proofs.helix_torse.proved in
let _ := Part_Tangent_printed_proofs.helix_torse.met in
let _ := Part_Tangent_printed_proofs.helix_normal.proved in
let _ := Part_Tangent_printed_proofs.helix_normal.met in
let _ := Part_Tangent_printed_proofs.helix_regular.proved in
let _ := Part_Tangent_printed_proofs.helix_regular.met in
let _ := Part_Tangent_proofs.helix_torse.proved in
let _ := Part_Tangent_proofs.helix_torse.met in
let _ := Part_Tangent_proofs.helix_normal.proved in
let _ := Part_Tangent_proofs.helix_normal.met in
let _ := Part_Tangent_proofs.helix_regular.proved in
let _ := Part_Tangent_proofs.helix_regular.met in
let _ := Part_Tangents_printed_proofs.angle_tangent.proved in
let _ := Part_Tangents_printed_proofs.angle_tangent.met in
let _ := Part_Tangents_printed_proofs.angle_tangent_closed.proved in
let _ := Part_Tangents_printed_proofs.angle_tangent_closed.met in
let _ := Part_Tangents_proofs.angle_tangent.proved in
let _ := Part_Tangents_proofs.angle_tangent.met in
let _ := Part_Tangents_proofs.angle_tangent_closed.proved in
let _ := Part_Tangents_proofs.angle_tangent_closed.met in
let _ := Part_The_printed_proofs.quadratic_middle.proved in
let _ := Part_The_printed_proofs.quadratic_middle.met in
let _ := Part_The_printed_proofs.quadratic_nonnegative.proved in
let _ := Part_The_printed_proofs.quadratic_nonnegative.met in
let _ := Part_The_printed_proofs.quadratic_nonnegative_slip.refuted in
let _ := Part_The_printed_proofs.quadratic_symmetry.proved in
let _ := Part_The_printed_proofs.quadratic_symmetry.met in
let _ := Part_The_printed_proofs.quadratic_decreasing.proved in
let _ := Part_The_printed_proofs.quadratic_decreasing.met in
let _ := Part_The_proofs.quadratic_middle.proved in
let _ := Part_The_proofs.quadratic_middle.met in
let _ := Part_The_proofs.quadratic_nonnegative.proved in
let _ := Part_The_proofs.quadratic_nonnegative.met in
let _ := Part_The_proofs.quadratic_nonnegative_slip.refuted in
let _ := Part_The_proofs.quadratic_symmetry.proved in
let _ := Part_The_proofs.quadratic_symmetry.met in
let _ := Part_The_proofs.quadratic_decreasing.proved in
let _ := Part_The_proofs.quadratic_decreasing.met in
I.
