(* The kernel's word: each theorem has the type of its statement, and what all of them assume. *)
From Bezier Require Part_A Part_A_proofs.
From Bezier Require Part_C Part_C_proofs.
From Bezier Require Part_Definition Part_Definition_proofs.
From Bezier Require Part_Derivative Part_Derivative_proofs.
From Bezier Require Part_End Part_End_proofs.
From Bezier Require Part_G Part_G_proofs.
From Bezier Require Part_Nonnegativity Part_Nonnegativity_proofs.
From Bezier Require Part_Partition Part_Partition_proofs.
From Bezier Require Part_README Part_README_proofs.
From Bezier Require Part_Subdivision Part_Subdivision_proofs.
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
From GbtDevelopable Require Section_4 Section_4_proofs.
From GbtDevelopable Require Section_4_1 Section_4_1_proofs.
From GbtDevelopable Require Section_4_2 Section_4_2_proofs.
From GbtDevelopable Require Section_5_1 Section_5_1_proofs.
From GbtSurfaces Require Part_Abstract Part_Abstract_proofs.
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
From HermiteDevelopable Require Section_1 Section_1_proofs.
From HermiteDevelopable Require Section_2 Section_2_proofs.
From HermiteDevelopable Require Section_3 Section_3_proofs.
From HermiteDevelopable Require Section_3_1 Section_3_1_proofs.
From Trigonometric Require Part_Cardioid Part_Cardioid_proofs.
From Trigonometric Require Part_Circles Part_Circles_proofs.
From Trigonometric Require Part_Curves Part_Curves_proofs.
From Trigonometric Require Part_Cycloid Part_Cycloid_proofs.
From Trigonometric Require Part_Half Part_Half_proofs.
From Trigonometric Require Part_Helicoid Part_Helicoid_proofs.
From Trigonometric Require Part_Helix Part_Helix_proofs.
From Trigonometric Require Part_Joins Part_Joins_proofs.
From Trigonometric Require Part_Parts Part_Parts_proofs.
From Trigonometric Require Part_Signs Part_Signs_proofs.
From Trigonometric Require Part_Tangent Part_Tangent_proofs.
From Trigonometric Require Part_Tangents Part_Tangents_proofs.
From Trigonometric Require Part_The Part_The_proofs.
Check (Bezier.Part_A_proofs.trigonometric_circle.proved : Bezier.Part_A.trigonometric_circle.statement).
Check (Bezier.Part_A_proofs.trigonometric_circle.met : Bezier.Part_A.trigonometric_circle.instance).
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
Check (Bezier.Part_C_proofs.join_C2_sufficient.proved : Bezier.Part_C.join_C2_sufficient.statement).
Check (Bezier.Part_C_proofs.join_C2_sufficient.met : Bezier.Part_C.join_C2_sufficient.instance).
Check (Bezier.Part_C_proofs.trigonometric_C1.proved : Bezier.Part_C.trigonometric_C1.statement).
Check (Bezier.Part_C_proofs.trigonometric_C1.met : Bezier.Part_C.trigonometric_C1.instance).
Check (Bezier.Part_C_proofs.trigonometric_C1_inside.proved : Bezier.Part_C.trigonometric_C1_inside.statement).
Check (Bezier.Part_C_proofs.trigonometric_C1_inside.met : Bezier.Part_C.trigonometric_C1_inside.instance).
Check (Bezier.Part_Definition_proofs.bernstein_recursion.proved : Bezier.Part_Definition.bernstein_recursion.statement).
Check (Bezier.Part_Definition_proofs.bernstein_recursion.met : Bezier.Part_Definition.bernstein_recursion.instance).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip.refuted : ~ Bezier.Part_Derivative.bernstein_derivative_slip.statement).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved : Bezier.Part_Derivative.bernstein_derivative_slip_corrected.statement).
Check (Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.met : Bezier.Part_Derivative.bernstein_derivative_slip_corrected.instance).
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
Check (Bezier.Part_G_proofs.join_G2.proved : Bezier.Part_G.join_G2.statement).
Check (Bezier.Part_G_proofs.join_G2.met : Bezier.Part_G.join_G2.instance).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.proved : Bezier.Part_Nonnegativity.bernstein_nonnegative.statement).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.met : Bezier.Part_Nonnegativity.bernstein_nonnegative.instance).
Check (Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted : ~ Bezier.Part_Nonnegativity.bernstein_nonnegative_slip.statement).
Check (Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted : ~ Bezier.Part_Nonnegativity.trigonometric_nonnegative_slip.statement).
Check (Bezier.Part_Partition_proofs.bernstein_unity.proved : Bezier.Part_Partition.bernstein_unity.statement).
Check (Bezier.Part_Partition_proofs.bernstein_unity.met : Bezier.Part_Partition.bernstein_unity.instance).
Check (Bezier.Part_Partition_proofs.trigonometric_unity.proved : Bezier.Part_Partition.trigonometric_unity.statement).
Check (Bezier.Part_Partition_proofs.trigonometric_unity.met : Bezier.Part_Partition.trigonometric_unity.instance).
Check (Bezier.Part_README_proofs.language_calculus.proved : Bezier.Part_README.language_calculus.statement).
Check (Bezier.Part_README_proofs.language_calculus.met : Bezier.Part_README.language_calculus.instance).
Check (Bezier.Part_README_proofs.language_matrices.proved : Bezier.Part_README.language_matrices.statement).
Check (Bezier.Part_README_proofs.language_matrices.met : Bezier.Part_README.language_matrices.instance).
Check (Bezier.Part_README_proofs.language_decimals.proved : Bezier.Part_README.language_decimals.statement).
Check (Bezier.Part_README_proofs.language_divisor.proved : Bezier.Part_README.language_divisor.statement).
Check (Bezier.Part_README_proofs.language_divisor.met : Bezier.Part_README.language_divisor.instance).
Check (Bezier.Part_README_proofs.language_order.proved : Bezier.Part_README.language_order.statement).
Check (Bezier.Part_README_proofs.language_order.met : Bezier.Part_README.language_order.instance).
Check (Bezier.Part_README_proofs.language_order_false.refuted : ~ Bezier.Part_README.language_order_false.statement).
Check (Bezier.Part_README_proofs.language_assumed.proved : Bezier.Part_README.language_assumed.statement).
Check (Bezier.Part_README_proofs.language_assumed.met : Bezier.Part_README.language_assumed.instance).
Check (Bezier.Part_README_proofs.language_declared.proved : Bezier.Part_README.language_declared.statement).
Check (Bezier.Part_README_proofs.language_declared.met : Bezier.Part_README.language_declared.instance).
Check (Bezier.Part_README_proofs.language_decimals_false.refuted : ~ Bezier.Part_README.language_decimals_false.statement).
Check (Bezier.Part_Subdivision_proofs.curve_midpoint.proved : Bezier.Part_Subdivision.curve_midpoint.statement).
Check (Bezier.Part_Subdivision_proofs.curve_midpoint.met : Bezier.Part_Subdivision.curve_midpoint.instance).
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
Check (Bezier.Part_The_proofs.circle_outside.proved : Bezier.Part_The.circle_outside.statement).
Check (Bezier.Part_The_proofs.circle_outside.met : Bezier.Part_The.circle_outside.instance).
Check (Bezier.Part_The_proofs.circle_exact_slip.refuted : ~ Bezier.Part_The.circle_exact_slip.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved : GbtDevelopable.Part_Abstract.abs_conics_points.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_points.met : GbtDevelopable.Part_Abstract.abs_conics_points.instance).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved : GbtDevelopable.Part_Abstract.abs_4d_factor.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met : GbtDevelopable.Part_Abstract.abs_4d_factor.instance).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted : ~ GbtDevelopable.Section_1.intro_continuity_free_b_any_values.statement).
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
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.proved : GbtDevelopable.Section_2_1.thm_1_1_degeneration.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.met : GbtDevelopable.Section_2_1.thm_1_1_degeneration.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.proved : GbtDevelopable.Section_2_1.thm_1_1_degeneration_only.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.met : GbtDevelopable.Section_2_1.thm_1_1_degeneration_only.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_3.proved : GbtDevelopable.Section_2_1.thm_1_3.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_3.met : GbtDevelopable.Section_2_1.thm_1_3.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_4.proved : GbtDevelopable.Section_2_1.thm_1_4.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_4.met : GbtDevelopable.Section_2_1.thm_1_4.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.proved : GbtDevelopable.Section_2_1.thm_1_5_quadratic.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.met : GbtDevelopable.Section_2_1.thm_1_5_quadratic.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_a.proved : GbtDevelopable.Section_2_1.thm_1_6_a.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_a.met : GbtDevelopable.Section_2_1.thm_1_6_a.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_b.proved : GbtDevelopable.Section_2_1.thm_1_6_b.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_b.met : GbtDevelopable.Section_2_1.thm_1_6_b.instance).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_d.proved : GbtDevelopable.Section_2_1.thm_1_6_d.statement).
Check (GbtDevelopable.Section_2_1_proofs.thm_1_6_d.met : GbtDevelopable.Section_2_1.thm_1_6_d.instance).
Check (GbtDevelopable.Section_2_2_proofs.eq_2_2.proved : GbtDevelopable.Section_2_2.eq_2_2.statement).
Check (GbtDevelopable.Section_2_2_proofs.eq_2_2.met : GbtDevelopable.Section_2_2.eq_2_2.instance).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_one_letter.refuted : ~ GbtDevelopable.Section_2_2.def_2_dim_one_letter.statement).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.proved : GbtDevelopable.Section_2_2.def_2_dim_two_letters.statement).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.met : GbtDevelopable.Section_2_2.def_2_dim_two_letters.instance).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.proved : GbtDevelopable.Section_2_2.sec_2_2_endpoints.statement).
Check (GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.met : GbtDevelopable.Section_2_2.sec_2_2_endpoints.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_curve.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved : GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_composite.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met : GbtDevelopable.Section_2_3.sec_2_3_local_part_of_a_composite.instance).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_3.refuted : ~ GbtDevelopable.Section_2_3.eq_2_3.statement).
Check (GbtDevelopable.Section_2_3_proofs.eq_2_4.refuted : ~ GbtDevelopable.Section_2_3.eq_2_4.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.proved : GbtDevelopable.Section_2_3.sec_2_3_dir_mu_single.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.met : GbtDevelopable.Section_2_3.sec_2_3_dir_mu_single.instance).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_range.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_range.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_concl_2_boundary_of_the_hull.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted : ~ GbtDevelopable.Section_2_3.sec_2_3_concl_2_control_polygon.statement).
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
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec.refuted : ~ GbtDevelopable.Section_3_3.sec_3_3_S_vec.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_x.proved : GbtDevelopable.Section_3_3.sec_3_3_S_x.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_y.proved : GbtDevelopable.Section_3_3.sec_3_3_S_y.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_z.proved : GbtDevelopable.Section_3_3.sec_3_3_S_z.statement).
Check (GbtDevelopable.Section_3_3_proofs.sec_3_3_S_den.proved : GbtDevelopable.Section_3_3.sec_3_3_S_den.statement).
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
Check (GbtDevelopable.Section_3_4_proofs.eq_3_13.proved : GbtDevelopable.Section_3_4.eq_3_13.statement).
Check (GbtDevelopable.Section_3_4_proofs.eq_3_13.met : GbtDevelopable.Section_3_4.eq_3_13.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.proved : GbtDevelopable.Section_3_4.sec_3_4_dual.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.met : GbtDevelopable.Section_3_4.sec_3_4_dual.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.proved : GbtDevelopable.Section_3_4.sec_3_4_k1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.met : GbtDevelopable.Section_3_4.sec_3_4_k1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.proved : GbtDevelopable.Section_3_4.sec_3_4_k2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.met : GbtDevelopable.Section_3_4.sec_3_4_k2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.proved : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.met : GbtDevelopable.Section_3_4.sec_3_4_m0_r3_true.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r1.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r1.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r2.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r2.instance).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.proved : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.statement).
Check (GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.met : GbtDevelopable.Section_3_4.sec_3_4_m1_r3_true.instance).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved : GbtDevelopable.Section_4.sec_4_midpoints.statement).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.met : GbtDevelopable.Section_4.sec_4_midpoints.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved : GbtDevelopable.Section_4.ex_4_2_distance.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.met : GbtDevelopable.Section_4.ex_4_2_distance.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved : GbtDevelopable.Section_4.ex_4_2_coplanar.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met : GbtDevelopable.Section_4.ex_4_2_coplanar.instance).
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
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.proved : GbtDevelopable.Section_4_1.ex_4_1_lengths.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.met : GbtDevelopable.Section_4_1.ex_4_1_lengths.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_c.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_c.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c1_f_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c2_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1.ex_4_1_c2_e_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.proved : GbtDevelopable.Section_4_1.ex_4_2_Q0.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.met : GbtDevelopable.Section_4_1.ex_4_2_Q0.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.proved : GbtDevelopable.Section_4_1.ex_4_2_Q1.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.met : GbtDevelopable.Section_4_1.ex_4_2_Q1.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.proved : GbtDevelopable.Section_4_1.ex_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.met : GbtDevelopable.Section_4_1.ex_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.proved : GbtDevelopable.Section_4_1.ex_4_2_Q3.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.met : GbtDevelopable.Section_4_1.ex_4_2_Q3.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.proved : GbtDevelopable.Section_4_1.ex_4_2_pencil.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.met : GbtDevelopable.Section_4_1.ex_4_2_pencil.instance).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_d.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c1_d.statement).
Check (GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_e.refuted : ~ GbtDevelopable.Section_4_1.ex_4_2_c1_e.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1_lengths.proved : GbtDevelopable.Section_4_2.sec_4_2_Q1_lengths.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.proved : GbtDevelopable.Section_4_2.sec_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.met : GbtDevelopable.Section_4_2.sec_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.proved : GbtDevelopable.Section_4_2.sec_4_2_quadrants.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.met : GbtDevelopable.Section_4_2.sec_4_2_quadrants.instance).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.proved : GbtDevelopable.Section_4_2.sec_4_2_distances.statement).
Check (GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.met : GbtDevelopable.Section_4_2.sec_4_2_distances.instance).
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
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved : GbtSurfaces.Part_Abstract.abs_basis_order_2.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met : GbtSurfaces.Part_Abstract.abs_basis_order_2.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved : GbtSurfaces.Part_Abstract.abs_basis_cubic.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met : GbtSurfaces.Part_Abstract.abs_basis_cubic.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved : GbtSurfaces.Section_2_1.eq_1_f0.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.met : GbtSurfaces.Section_2_1.eq_1_f0.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved : GbtSurfaces.Section_2_1.eq_1_f1.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.met : GbtSurfaces.Section_2_1.eq_1_f1.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved : GbtSurfaces.Section_2_1.eq_1_f2.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.met : GbtSurfaces.Section_2_1.eq_1_f2.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_literal.refuted : ~ GbtSurfaces.Section_2_1.eq_2_zero_literal.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.proved : GbtSurfaces.Section_2_1.eq_2_zero_n_is_the_order.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.met : GbtSurfaces.Section_2_1.eq_2_zero_n_is_the_order.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted : ~ GbtSurfaces.Section_2_1.thm_1_1_as_functions.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved : GbtSurfaces.Section_2_1.thm_1_1_true.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met : GbtSurfaces.Section_2_1.thm_1_1_true.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.proved : GbtSurfaces.Section_2_1.thm_1_3.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.met : GbtSurfaces.Section_2_1.thm_1_3.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.proved : GbtSurfaces.Section_2_1.thm_1_4.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.met : GbtSurfaces.Section_2_1.thm_1_4.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_one_letter.refuted : ~ GbtSurfaces.Section_2_2.def_2_points_one_letter.statement).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.proved : GbtSurfaces.Section_2_2.def_2_points_two_letters.statement).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.met : GbtSurfaces.Section_2_2.def_2_points_two_letters.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved : GbtSurfaces.Section_2_2.sec_2_2_interpolation.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met : GbtSurfaces.Section_2_2.sec_2_2_interpolation.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.proved : GbtSurfaces.Section_2_2.thm_2_1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.met : GbtSurfaces.Section_2_2.thm_2_1.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved : GbtSurfaces.Section_2_2.eq_4_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met : GbtSurfaces.Section_2_2.eq_4_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted : ~ GbtSurfaces.Section_2_2.eq_5_Q12.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved : GbtSurfaces.Section_2_2.eq_6_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met : GbtSurfaces.Section_2_2.eq_6_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved : GbtSurfaces.Section_2_2.thm_2_c1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.met : GbtSurfaces.Section_2_2.thm_2_c1.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted : ~ GbtSurfaces.Section_2_3.sec_2_3_classical_every_property.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.proved : GbtSurfaces.Section_3_1.eq_10.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.met : GbtSurfaces.Section_3_1.eq_10.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved : GbtSurfaces.Section_3_1.eq_10_bernstein.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met : GbtSurfaces.Section_3_1.eq_10_bernstein.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved : GbtSurfaces.Section_3_1.eq_10_extending.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.met : GbtSurfaces.Section_3_1.eq_10_extending.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11.refuted : ~ GbtSurfaces.Section_3_1.eq_11.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted : ~ GbtSurfaces.Section_3_1.eq_11_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted : ~ GbtSurfaces.Section_3_1.eq_12_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted : ~ GbtSurfaces.Section_3_1.sec_3_1_any_shape_literal.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved : GbtSurfaces.Section_3_1.ex_3_1_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved : GbtSurfaces.Section_3_1.ex_3_1_net.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved : GbtSurfaces.Section_3_1.ex_3_1_mesh_count.statement).
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
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved : GbtSurfaces.Section_3_3.sec_3_3_generatrix.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met : GbtSurfaces.Section_3_3.sec_3_3_generatrix.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.proved : GbtSurfaces.Section_3_3.eq_17_0.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.met : GbtSurfaces.Section_3_3.eq_17_0.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.proved : GbtSurfaces.Section_3_3.eq_17_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.met : GbtSurfaces.Section_3_3.eq_17_1.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_as_printed.refuted : ~ GbtSurfaces.Section_3_3.sec_3_3_condition_2_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.proved : GbtSurfaces.Section_3_3.sec_3_3_condition_2_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.met : GbtSurfaces.Section_3_3.sec_3_3_condition_2_with_f_l.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18.refuted : ~ GbtSurfaces.Section_3_3.eq_18.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved : GbtSurfaces.Section_3_3.eq_18_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met : GbtSurfaces.Section_3_3.eq_18_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved : GbtSurfaces.Section_3_3.eq_18_necessary.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met : GbtSurfaces.Section_3_3.eq_18_necessary.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor_with_f_l.refuted : ~ GbtSurfaces.Section_3_3.eq_18_tensor_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved : GbtSurfaces.Section_3_3.prop_3_3_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met : GbtSurfaces.Section_3_3.prop_3_3_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_with_f_l.refuted : ~ GbtSurfaces.Section_3_3.prop_3_4_a_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed.refuted : ~ GbtSurfaces.Section_3_3.alg_3_a_as_printed.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.proved : GbtSurfaces.Section_3_3.alg_3_a_as_printed_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.met : GbtSurfaces.Section_3_3.alg_3_a_as_printed_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.proved : GbtSurfaces.Section_3_3.alg_3_a_with_f_l.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.met : GbtSurfaces.Section_3_3.alg_3_a_with_f_l.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_3.alg_3_b_by_the_printed_conditions.statement).
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
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted : ~ GbtSurfaces.Section_3_4.eq_20_trajectory.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.proved : GbtSurfaces.Section_3_4.eq_21.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.met : GbtSurfaces.Section_3_4.eq_21.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.proved : GbtSurfaces.Section_3_4.prop_3_5.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.met : GbtSurfaces.Section_3_4.prop_3_5.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved : GbtSurfaces.Section_3_4.prop_3_6_1.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met : GbtSurfaces.Section_3_4.prop_3_6_1.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved : GbtSurfaces.Section_3_4.prop_3_6_2.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met : GbtSurfaces.Section_3_4.prop_3_6_2.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted : ~ GbtSurfaces.Section_3_4.thm_4_elements.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved : GbtSurfaces.Section_3_4.thm_4_elements_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met : GbtSurfaces.Section_3_4.thm_4_elements_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved : GbtSurfaces.Section_3_4.thm_4_unity.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.met : GbtSurfaces.Section_3_4.thm_4_unity.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met : GbtSurfaces.Section_3_4.sec_3_4_revolution.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.instance).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_4.alg_4_b_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.proved : GbtSurfaces.Section_3_4.alg_4_b_there_are_such_connections.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.met : GbtSurfaces.Section_3_4.alg_4_b_there_are_such_connections.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_26.proved : GbtSurfaces.Section_3_4.eq_26.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved : GbtSurfaces.Section_3_4.ex_3_4_scaling.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met : GbtSurfaces.Section_3_4.ex_3_4_scaling.instance).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ GbtSurfaces.Section_3_4.fig_16_lambda_between_the_surfaces.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.proved : GbtSurfaces.Section_3_5.eq_27.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.met : GbtSurfaces.Section_3_5.eq_27.instance).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved : GbtSurfaces.Section_3_5.sec_3_5_categories.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.instance).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_b_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_3_5.alg_5_b_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved : GbtSurfaces.Section_3_5.ex_3_5_trajectories.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted : ~ GbtSurfaces.Section_3_6.eq_32_matrix.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.instance).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved : GbtSurfaces.Section_3_6.thm_6_symmetric.statement).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met : GbtSurfaces.Section_3_6.thm_6_symmetric.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.proved : GbtSurfaces.Section_3_6.eq_34.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.met : GbtSurfaces.Section_3_6.eq_34.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved : GbtSurfaces.Section_3_6.sec_3_6_other_axes.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met : GbtSurfaces.Section_3_6.sec_3_6_other_axes.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved : GbtSurfaces.Section_3_6.prop_3_8_b_exact.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met : GbtSurfaces.Section_3_6.prop_3_8_b_exact.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted : ~ GbtSurfaces.Section_3_6.prop_3_9_a_one_segment.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_35.proved : GbtSurfaces.Section_3_6.eq_35.statement).
Check (GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted : ~ GbtSurfaces.Section_4.abs_features_every_feature.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ GbtSurfaces.Section_4.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_4.sec_4_composite_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor_with_f_l.refuted : ~ GbtSurfaces.Section_4.sec_4_tensor_with_f_l.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved : GbtSurfaces.Section_4.sec_4_convex_hull.statement).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved : HermiteDevelopable.Section_1.sec_1_parallel_tangents.statement).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met : HermiteDevelopable.Section_1.sec_1_parallel_tangents.instance).
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
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved : HermiteDevelopable.Section_3.eq_3_2_across_summit.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met : HermiteDevelopable.Section_3.eq_3_2_across_summit.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved : HermiteDevelopable.Section_3_1.sec_3_1_substituted.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met : HermiteDevelopable.Section_3_1.sec_3_1_substituted.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.instance).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved : Trigonometric.Part_Cardioid.cardioid_speed.statement).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_speed.met : Trigonometric.Part_Cardioid.cardioid_speed.instance).
Check (Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved : Trigonometric.Part_Cardioid.cardioid_cusp.statement).
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
Check (Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip.refuted : ~ Trigonometric.Part_Cycloid.cycloid_slope_slip.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_sine.proved : Trigonometric.Part_Half.angle_half_sine.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_cosine.proved : Trigonometric.Part_Half.angle_half_cosine.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_slip.refuted : ~ Trigonometric.Part_Half.angle_half_slip.statement).
Check (Trigonometric.Part_Half_proofs.angle_half_slip_corrected.proved : Trigonometric.Part_Half.angle_half_slip_corrected.statement).
Check (Trigonometric.Part_Half_proofs.half_unity.proved : Trigonometric.Part_Half.half_unity.statement).
Check (Trigonometric.Part_Half_proofs.half_unity.met : Trigonometric.Part_Half.half_unity.instance).
Check (Trigonometric.Part_Half_proofs.half_middle.proved : Trigonometric.Part_Half.half_middle.statement).
Check (Trigonometric.Part_Half_proofs.half_middle.met : Trigonometric.Part_Half.half_middle.instance).
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
Check (Trigonometric.Part_Parts_proofs.angle_rate.proved : Trigonometric.Part_Parts.angle_rate.statement).
Check (Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted : ~ Trigonometric.Part_Signs.angle_symmetric_slip.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.proved : Trigonometric.Part_Tangent.helix_torse.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_torse.met : Trigonometric.Part_Tangent.helix_torse.instance).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.proved : Trigonometric.Part_Tangent.helix_normal.statement).
Check (Trigonometric.Part_Tangent_proofs.helix_normal.met : Trigonometric.Part_Tangent.helix_normal.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.proved : Trigonometric.Part_Tangents.angle_tangent.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent.met : Trigonometric.Part_Tangents.angle_tangent.instance).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved : Trigonometric.Part_Tangents.angle_tangent_closed.statement).
Check (Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met : Trigonometric.Part_Tangents.angle_tangent_closed.instance).
Check (Trigonometric.Part_The_proofs.quadratic_middle.proved : Trigonometric.Part_The.quadratic_middle.statement).
Check (Trigonometric.Part_The_proofs.quadratic_middle.met : Trigonometric.Part_The.quadratic_middle.instance).
Check (Trigonometric.Part_The_proofs.quadratic_nonnegative_slip.refuted : ~ Trigonometric.Part_The.quadratic_nonnegative_slip.statement).
Check (Trigonometric.Part_The_proofs.quadratic_symmetry.proved : Trigonometric.Part_The.quadratic_symmetry.statement).
Check (Trigonometric.Part_The_proofs.quadratic_symmetry.met : Trigonometric.Part_The.quadratic_symmetry.instance).
Definition theorem_0 := Bezier.Part_A_proofs.trigonometric_circle.proved.
Definition theorem_1 := Bezier.Part_A_proofs.trigonometric_circle.met.
Definition theorem_2 := Bezier.Part_C_proofs.join_C0.proved.
Definition theorem_3 := Bezier.Part_C_proofs.join_C0.met.
Definition theorem_4 := Bezier.Part_C_proofs.join_C1.proved.
Definition theorem_5 := Bezier.Part_C_proofs.join_C1.met.
Definition theorem_6 := Bezier.Part_C_proofs.join_C1_slip.refuted.
Definition theorem_7 := Bezier.Part_C_proofs.join_C1_slip_corrected.proved.
Definition theorem_8 := Bezier.Part_C_proofs.join_C1_slip_corrected.met.
Definition theorem_9 := Bezier.Part_C_proofs.join_C2.proved.
Definition theorem_10 := Bezier.Part_C_proofs.join_C2.met.
Definition theorem_11 := Bezier.Part_C_proofs.join_C2_slip.refuted.
Definition theorem_12 := Bezier.Part_C_proofs.join_C2_slip_corrected.proved.
Definition theorem_13 := Bezier.Part_C_proofs.join_C2_slip_corrected.met.
Definition theorem_14 := Bezier.Part_C_proofs.join_C2_sufficient.proved.
Definition theorem_15 := Bezier.Part_C_proofs.join_C2_sufficient.met.
Definition theorem_16 := Bezier.Part_C_proofs.trigonometric_C1.proved.
Definition theorem_17 := Bezier.Part_C_proofs.trigonometric_C1.met.
Definition theorem_18 := Bezier.Part_C_proofs.trigonometric_C1_inside.proved.
Definition theorem_19 := Bezier.Part_C_proofs.trigonometric_C1_inside.met.
Definition theorem_20 := Bezier.Part_Definition_proofs.bernstein_recursion.proved.
Definition theorem_21 := Bezier.Part_Definition_proofs.bernstein_recursion.met.
Definition theorem_22 := Bezier.Part_Derivative_proofs.bernstein_derivative_slip.refuted.
Definition theorem_23 := Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.proved.
Definition theorem_24 := Bezier.Part_Derivative_proofs.bernstein_derivative_slip_corrected.met.
Definition theorem_25 := Bezier.Part_End_proofs.curve_ends.proved.
Definition theorem_26 := Bezier.Part_End_proofs.curve_ends.met.
Definition theorem_27 := Bezier.Part_End_proofs.curve_d1.proved.
Definition theorem_28 := Bezier.Part_End_proofs.curve_d1.met.
Definition theorem_29 := Bezier.Part_End_proofs.curve_d2.proved.
Definition theorem_30 := Bezier.Part_End_proofs.curve_d2.met.
Definition theorem_31 := Bezier.Part_End_proofs.curve_d2_slip.refuted.
Definition theorem_32 := Bezier.Part_End_proofs.curve_d2_slip_corrected.proved.
Definition theorem_33 := Bezier.Part_End_proofs.curve_d2_slip_corrected.met.
Definition theorem_34 := Bezier.Part_End_proofs.curve_d3.proved.
Definition theorem_35 := Bezier.Part_End_proofs.curve_d3.met.
Definition theorem_36 := Bezier.Part_End_proofs.trigonometric_d1.proved.
Definition theorem_37 := Bezier.Part_End_proofs.trigonometric_d1.met.
Definition theorem_38 := Bezier.Part_End_proofs.trigonometric_d1_slip.refuted.
Definition theorem_39 := Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.proved.
Definition theorem_40 := Bezier.Part_End_proofs.trigonometric_d1_slip_corrected.met.
Definition theorem_41 := Bezier.Part_End_proofs.trigonometric_d2.proved.
Definition theorem_42 := Bezier.Part_End_proofs.trigonometric_d2.met.
Definition theorem_43 := Bezier.Part_G_proofs.join_G2.proved.
Definition theorem_44 := Bezier.Part_G_proofs.join_G2.met.
Definition theorem_45 := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.proved.
Definition theorem_46 := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative.met.
Definition theorem_47 := Bezier.Part_Nonnegativity_proofs.bernstein_nonnegative_slip.refuted.
Definition theorem_48 := Bezier.Part_Nonnegativity_proofs.trigonometric_nonnegative_slip.refuted.
Definition theorem_49 := Bezier.Part_Partition_proofs.bernstein_unity.proved.
Definition theorem_50 := Bezier.Part_Partition_proofs.bernstein_unity.met.
Definition theorem_51 := Bezier.Part_Partition_proofs.trigonometric_unity.proved.
Definition theorem_52 := Bezier.Part_Partition_proofs.trigonometric_unity.met.
Definition theorem_53 := Bezier.Part_README_proofs.language_calculus.proved.
Definition theorem_54 := Bezier.Part_README_proofs.language_calculus.met.
Definition theorem_55 := Bezier.Part_README_proofs.language_matrices.proved.
Definition theorem_56 := Bezier.Part_README_proofs.language_matrices.met.
Definition theorem_57 := Bezier.Part_README_proofs.language_decimals.proved.
Definition theorem_58 := Bezier.Part_README_proofs.language_divisor.proved.
Definition theorem_59 := Bezier.Part_README_proofs.language_divisor.met.
Definition theorem_60 := Bezier.Part_README_proofs.language_order.proved.
Definition theorem_61 := Bezier.Part_README_proofs.language_order.met.
Definition theorem_62 := Bezier.Part_README_proofs.language_order_false.refuted.
Definition theorem_63 := Bezier.Part_README_proofs.language_assumed.proved.
Definition theorem_64 := Bezier.Part_README_proofs.language_assumed.met.
Definition theorem_65 := Bezier.Part_README_proofs.language_declared.proved.
Definition theorem_66 := Bezier.Part_README_proofs.language_declared.met.
Definition theorem_67 := Bezier.Part_README_proofs.language_decimals_false.refuted.
Definition theorem_68 := Bezier.Part_Subdivision_proofs.curve_midpoint.proved.
Definition theorem_69 := Bezier.Part_Subdivision_proofs.curve_midpoint.met.
Definition theorem_70 := Bezier.Part_Symmetry_proofs.bernstein_symmetry.proved.
Definition theorem_71 := Bezier.Part_Symmetry_proofs.bernstein_symmetry.met.
Definition theorem_72 := Bezier.Part_Symmetry_proofs.trigonometric_symmetry.proved.
Definition theorem_73 := Bezier.Part_Symmetry_proofs.trigonometric_symmetry.met.
Definition theorem_74 := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip.refuted.
Definition theorem_75 := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.proved.
Definition theorem_76 := Bezier.Part_Symmetry_proofs.trigonometric_symmetry_slip_corrected.met.
Definition theorem_77 := Bezier.Part_The_proofs.circle_kappa.proved.
Definition theorem_78 := Bezier.Part_The_proofs.circle_kappa_cut.proved.
Definition theorem_79 := Bezier.Part_The_proofs.circle_kappa_slip.refuted.
Definition theorem_80 := Bezier.Part_The_proofs.circle_outside.proved.
Definition theorem_81 := Bezier.Part_The_proofs.circle_outside.met.
Definition theorem_82 := Bezier.Part_The_proofs.circle_exact_slip.refuted.
Definition theorem_83 := GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved.
Definition theorem_84 := GbtDevelopable.Part_Abstract_proofs.abs_conics_points.met.
Definition theorem_85 := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved.
Definition theorem_86 := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met.
Definition theorem_87 := GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted.
Definition theorem_88 := GbtDevelopable.Section_2_1_proofs.def_1_g0.proved.
Definition theorem_89 := GbtDevelopable.Section_2_1_proofs.def_1_g0.met.
Definition theorem_90 := GbtDevelopable.Section_2_1_proofs.def_1_g1.proved.
Definition theorem_91 := GbtDevelopable.Section_2_1_proofs.def_1_g1.met.
Definition theorem_92 := GbtDevelopable.Section_2_1_proofs.def_1_g2.proved.
Definition theorem_93 := GbtDevelopable.Section_2_1_proofs.def_1_g2.met.
Definition theorem_94 := GbtDevelopable.Section_2_1_proofs.def_1_range.proved.
Definition theorem_95 := GbtDevelopable.Section_2_1_proofs.def_1_range.met.
Definition theorem_96 := GbtDevelopable.Section_2_1_proofs.eq_2_1.proved.
Definition theorem_97 := GbtDevelopable.Section_2_1_proofs.eq_2_1.met.
Definition theorem_98 := GbtDevelopable.Section_2_1_proofs.def_1_zero.proved.
Definition theorem_99 := GbtDevelopable.Section_2_1_proofs.def_1_zero.met.
Definition theorem_100 := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_functions.refuted.
Definition theorem_101 := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.proved.
Definition theorem_102 := GbtDevelopable.Section_2_1_proofs.thm_1_1_k2_substitution.met.
Definition theorem_103 := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_functions.refuted.
Definition theorem_104 := GbtDevelopable.Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted.
Definition theorem_105 := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.proved.
Definition theorem_106 := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration.met.
Definition theorem_107 := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.proved.
Definition theorem_108 := GbtDevelopable.Section_2_1_proofs.thm_1_1_degeneration_only.met.
Definition theorem_109 := GbtDevelopable.Section_2_1_proofs.thm_1_3.proved.
Definition theorem_110 := GbtDevelopable.Section_2_1_proofs.thm_1_3.met.
Definition theorem_111 := GbtDevelopable.Section_2_1_proofs.thm_1_4.proved.
Definition theorem_112 := GbtDevelopable.Section_2_1_proofs.thm_1_4.met.
Definition theorem_113 := GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.proved.
Definition theorem_114 := GbtDevelopable.Section_2_1_proofs.thm_1_5_quadratic.met.
Definition theorem_115 := GbtDevelopable.Section_2_1_proofs.thm_1_6_a.proved.
Definition theorem_116 := GbtDevelopable.Section_2_1_proofs.thm_1_6_a.met.
Definition theorem_117 := GbtDevelopable.Section_2_1_proofs.thm_1_6_b.proved.
Definition theorem_118 := GbtDevelopable.Section_2_1_proofs.thm_1_6_b.met.
Definition theorem_119 := GbtDevelopable.Section_2_1_proofs.thm_1_6_d.proved.
Definition theorem_120 := GbtDevelopable.Section_2_1_proofs.thm_1_6_d.met.
Definition theorem_121 := GbtDevelopable.Section_2_2_proofs.eq_2_2.proved.
Definition theorem_122 := GbtDevelopable.Section_2_2_proofs.eq_2_2.met.
Definition theorem_123 := GbtDevelopable.Section_2_2_proofs.def_2_dim_one_letter.refuted.
Definition theorem_124 := GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.proved.
Definition theorem_125 := GbtDevelopable.Section_2_2_proofs.def_2_dim_two_letters.met.
Definition theorem_126 := GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.proved.
Definition theorem_127 := GbtDevelopable.Section_2_2_proofs.sec_2_2_endpoints.met.
Definition theorem_128 := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted.
Definition theorem_129 := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved.
Definition theorem_130 := GbtDevelopable.Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met.
Definition theorem_131 := GbtDevelopable.Section_2_3_proofs.eq_2_3.refuted.
Definition theorem_132 := GbtDevelopable.Section_2_3_proofs.eq_2_4.refuted.
Definition theorem_133 := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.proved.
Definition theorem_134 := GbtDevelopable.Section_2_3_proofs.sec_2_3_dir_mu_single.met.
Definition theorem_135 := GbtDevelopable.Section_2_3_proofs.sec_2_3_range.refuted.
Definition theorem_136 := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted.
Definition theorem_137 := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted.
Definition theorem_138 := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved.
Definition theorem_139 := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met.
Definition theorem_140 := GbtDevelopable.Section_3_1_proofs.eq_3_1.proved.
Definition theorem_141 := GbtDevelopable.Section_3_1_proofs.eq_3_1.met.
Definition theorem_142 := GbtDevelopable.Section_3_1_proofs.eq_3_2.proved.
Definition theorem_143 := GbtDevelopable.Section_3_1_proofs.eq_3_2.met.
Definition theorem_144 := GbtDevelopable.Section_3_1_proofs.eq_3_3.proved.
Definition theorem_145 := GbtDevelopable.Section_3_1_proofs.eq_3_3.met.
Definition theorem_146 := GbtDevelopable.Section_3_1_proofs.eq_3_4.proved.
Definition theorem_147 := GbtDevelopable.Section_3_1_proofs.eq_3_4.met.
Definition theorem_148 := GbtDevelopable.Section_3_2_proofs.eq_3_5.proved.
Definition theorem_149 := GbtDevelopable.Section_3_2_proofs.eq_3_5.met.
Definition theorem_150 := GbtDevelopable.Section_3_2_proofs.eq_3_6.proved.
Definition theorem_151 := GbtDevelopable.Section_3_2_proofs.eq_3_6.met.
Definition theorem_152 := GbtDevelopable.Section_3_2_proofs.sec_3_2_phi.proved.
Definition theorem_153 := GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.proved.
Definition theorem_154 := GbtDevelopable.Section_3_2_proofs.sec_3_2_theta.met.
Definition theorem_155 := GbtDevelopable.Section_3_2_proofs.sec_3_2_phi_exp.proved.
Definition theorem_156 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.proved.
Definition theorem_157 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_vec.met.
Definition theorem_158 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.proved.
Definition theorem_159 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_nearest.met.
Definition theorem_160 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_x.proved.
Definition theorem_161 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_y.proved.
Definition theorem_162 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z.refuted.
Definition theorem_163 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_z_corrected.proved.
Definition theorem_164 := GbtDevelopable.Section_3_2_proofs.sec_3_2_psi_den.proved.
Definition theorem_165 := GbtDevelopable.Section_3_2_proofs.eq_3_7.proved.
Definition theorem_166 := GbtDevelopable.Section_3_2_proofs.eq_3_7.met.
Definition theorem_167 := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_vec.refuted.
Definition theorem_168 := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_x.proved.
Definition theorem_169 := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_y.proved.
Definition theorem_170 := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_z.proved.
Definition theorem_171 := GbtDevelopable.Section_3_3_proofs.sec_3_3_S_den.proved.
Definition theorem_172 := GbtDevelopable.Section_3_4_proofs.eq_3_11_a.proved.
Definition theorem_173 := GbtDevelopable.Section_3_4_proofs.eq_3_11_a.met.
Definition theorem_174 := GbtDevelopable.Section_3_4_proofs.eq_3_11_b.proved.
Definition theorem_175 := GbtDevelopable.Section_3_4_proofs.eq_3_11_b.met.
Definition theorem_176 := GbtDevelopable.Section_3_4_proofs.eq_3_11_c.proved.
Definition theorem_177 := GbtDevelopable.Section_3_4_proofs.eq_3_11_c.met.
Definition theorem_178 := GbtDevelopable.Section_3_4_proofs.eq_3_12_a.proved.
Definition theorem_179 := GbtDevelopable.Section_3_4_proofs.eq_3_12_a.met.
Definition theorem_180 := GbtDevelopable.Section_3_4_proofs.eq_3_12_b.proved.
Definition theorem_181 := GbtDevelopable.Section_3_4_proofs.eq_3_12_b.met.
Definition theorem_182 := GbtDevelopable.Section_3_4_proofs.eq_3_12_c.proved.
Definition theorem_183 := GbtDevelopable.Section_3_4_proofs.eq_3_12_c.met.
Definition theorem_184 := GbtDevelopable.Section_3_4_proofs.eq_3_13.proved.
Definition theorem_185 := GbtDevelopable.Section_3_4_proofs.eq_3_13.met.
Definition theorem_186 := GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.proved.
Definition theorem_187 := GbtDevelopable.Section_3_4_proofs.sec_3_4_dual.met.
Definition theorem_188 := GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.proved.
Definition theorem_189 := GbtDevelopable.Section_3_4_proofs.sec_3_4_k1.met.
Definition theorem_190 := GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.proved.
Definition theorem_191 := GbtDevelopable.Section_3_4_proofs.sec_3_4_k2.met.
Definition theorem_192 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.proved.
Definition theorem_193 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r1.met.
Definition theorem_194 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.proved.
Definition theorem_195 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r2.met.
Definition theorem_196 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.proved.
Definition theorem_197 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m0_r3_true.met.
Definition theorem_198 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.proved.
Definition theorem_199 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r1.met.
Definition theorem_200 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.proved.
Definition theorem_201 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r2.met.
Definition theorem_202 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.proved.
Definition theorem_203 := GbtDevelopable.Section_3_4_proofs.sec_3_4_m1_r3_true.met.
Definition theorem_204 := GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved.
Definition theorem_205 := GbtDevelopable.Section_4_proofs.sec_4_midpoints.met.
Definition theorem_206 := GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved.
Definition theorem_207 := GbtDevelopable.Section_4_proofs.ex_4_2_distance.met.
Definition theorem_208 := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved.
Definition theorem_209 := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met.
Definition theorem_210 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.proved.
Definition theorem_211 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q0.met.
Definition theorem_212 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.proved.
Definition theorem_213 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q1.met.
Definition theorem_214 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.proved.
Definition theorem_215 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q2.met.
Definition theorem_216 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.proved.
Definition theorem_217 := GbtDevelopable.Section_4_1_proofs.ex_4_1_Q3.met.
Definition theorem_218 := GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.proved.
Definition theorem_219 := GbtDevelopable.Section_4_1_proofs.ex_4_1_distance.met.
Definition theorem_220 := GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.proved.
Definition theorem_221 := GbtDevelopable.Section_4_1_proofs.ex_4_1_coplanar.met.
Definition theorem_222 := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.proved.
Definition theorem_223 := GbtDevelopable.Section_4_1_proofs.ex_4_1_lengths.met.
Definition theorem_224 := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_c.refuted.
Definition theorem_225 := GbtDevelopable.Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted.
Definition theorem_226 := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_d.refuted.
Definition theorem_227 := GbtDevelopable.Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted.
Definition theorem_228 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.proved.
Definition theorem_229 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q0.met.
Definition theorem_230 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.proved.
Definition theorem_231 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q1.met.
Definition theorem_232 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.proved.
Definition theorem_233 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q2.met.
Definition theorem_234 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.proved.
Definition theorem_235 := GbtDevelopable.Section_4_1_proofs.ex_4_2_Q3.met.
Definition theorem_236 := GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.proved.
Definition theorem_237 := GbtDevelopable.Section_4_1_proofs.ex_4_2_pencil.met.
Definition theorem_238 := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_d.refuted.
Definition theorem_239 := GbtDevelopable.Section_4_1_proofs.ex_4_2_c1_e.refuted.
Definition theorem_240 := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q1_lengths.proved.
Definition theorem_241 := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.proved.
Definition theorem_242 := GbtDevelopable.Section_4_2_proofs.sec_4_2_Q2.met.
Definition theorem_243 := GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.proved.
Definition theorem_244 := GbtDevelopable.Section_4_2_proofs.sec_4_2_quadrants.met.
Definition theorem_245 := GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.proved.
Definition theorem_246 := GbtDevelopable.Section_4_2_proofs.sec_4_2_distances.met.
Definition theorem_247 := GbtDevelopable.Section_5_1_proofs.eq_5_3_a.proved.
Definition theorem_248 := GbtDevelopable.Section_5_1_proofs.eq_5_3_a.met.
Definition theorem_249 := GbtDevelopable.Section_5_1_proofs.eq_5_3_b.refuted.
Definition theorem_250 := GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.proved.
Definition theorem_251 := GbtDevelopable.Section_5_1_proofs.eq_5_3_b_corrected.met.
Definition theorem_252 := GbtDevelopable.Section_5_1_proofs.eq_5_4.proved.
Definition theorem_253 := GbtDevelopable.Section_5_1_proofs.eq_5_4.met.
Definition theorem_254 := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved.
Definition theorem_255 := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met.
Definition theorem_256 := GbtDevelopable.Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted.
Definition theorem_257 := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved.
Definition theorem_258 := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met.
Definition theorem_259 := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved.
Definition theorem_260 := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met.
Definition theorem_261 := GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved.
Definition theorem_262 := GbtSurfaces.Section_2_1_proofs.eq_1_f0.met.
Definition theorem_263 := GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved.
Definition theorem_264 := GbtSurfaces.Section_2_1_proofs.eq_1_f1.met.
Definition theorem_265 := GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved.
Definition theorem_266 := GbtSurfaces.Section_2_1_proofs.eq_1_f2.met.
Definition theorem_267 := GbtSurfaces.Section_2_1_proofs.eq_2_zero_literal.refuted.
Definition theorem_268 := GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.proved.
Definition theorem_269 := GbtSurfaces.Section_2_1_proofs.eq_2_zero_n_is_the_order.met.
Definition theorem_270 := GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted.
Definition theorem_271 := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved.
Definition theorem_272 := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met.
Definition theorem_273 := GbtSurfaces.Section_2_1_proofs.thm_1_3.proved.
Definition theorem_274 := GbtSurfaces.Section_2_1_proofs.thm_1_3.met.
Definition theorem_275 := GbtSurfaces.Section_2_1_proofs.thm_1_4.proved.
Definition theorem_276 := GbtSurfaces.Section_2_1_proofs.thm_1_4.met.
Definition theorem_277 := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved.
Definition theorem_278 := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met.
Definition theorem_279 := GbtSurfaces.Section_2_2_proofs.def_2_points_one_letter.refuted.
Definition theorem_280 := GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.proved.
Definition theorem_281 := GbtSurfaces.Section_2_2_proofs.def_2_points_two_letters.met.
Definition theorem_282 := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted.
Definition theorem_283 := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved.
Definition theorem_284 := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met.
Definition theorem_285 := GbtSurfaces.Section_2_2_proofs.thm_2_1.proved.
Definition theorem_286 := GbtSurfaces.Section_2_2_proofs.thm_2_1.met.
Definition theorem_287 := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved.
Definition theorem_288 := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met.
Definition theorem_289 := GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted.
Definition theorem_290 := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved.
Definition theorem_291 := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met.
Definition theorem_292 := GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved.
Definition theorem_293 := GbtSurfaces.Section_2_2_proofs.thm_2_c1.met.
Definition theorem_294 := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted.
Definition theorem_295 := GbtSurfaces.Section_3_1_proofs.eq_10.proved.
Definition theorem_296 := GbtSurfaces.Section_3_1_proofs.eq_10.met.
Definition theorem_297 := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved.
Definition theorem_298 := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met.
Definition theorem_299 := GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved.
Definition theorem_300 := GbtSurfaces.Section_3_1_proofs.eq_10_extending.met.
Definition theorem_301 := GbtSurfaces.Section_3_1_proofs.eq_11.refuted.
Definition theorem_302 := GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted.
Definition theorem_303 := GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted.
Definition theorem_304 := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted.
Definition theorem_305 := GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved.
Definition theorem_306 := GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved.
Definition theorem_307 := GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved.
Definition theorem_308 := GbtSurfaces.Section_3_2_proofs.eq_14.proved.
Definition theorem_309 := GbtSurfaces.Section_3_2_proofs.eq_14.met.
Definition theorem_310 := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved.
Definition theorem_311 := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met.
Definition theorem_312 := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved.
Definition theorem_313 := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met.
Definition theorem_314 := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved.
Definition theorem_315 := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met.
Definition theorem_316 := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved.
Definition theorem_317 := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met.
Definition theorem_318 := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved.
Definition theorem_319 := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met.
Definition theorem_320 := GbtSurfaces.Section_3_2_proofs.eq_15.proved.
Definition theorem_321 := GbtSurfaces.Section_3_2_proofs.eq_15.met.
Definition theorem_322 := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved.
Definition theorem_323 := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met.
Definition theorem_324 := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved.
Definition theorem_325 := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved.
Definition theorem_326 := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted.
Definition theorem_327 := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved.
Definition theorem_328 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved.
Definition theorem_329 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved.
Definition theorem_330 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved.
Definition theorem_331 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted.
Definition theorem_332 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved.
Definition theorem_333 := GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved.
Definition theorem_334 := GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted.
Definition theorem_335 := GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved.
Definition theorem_336 := GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved.
Definition theorem_337 := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved.
Definition theorem_338 := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met.
Definition theorem_339 := GbtSurfaces.Section_3_3_proofs.eq_17_0.proved.
Definition theorem_340 := GbtSurfaces.Section_3_3_proofs.eq_17_0.met.
Definition theorem_341 := GbtSurfaces.Section_3_3_proofs.eq_17_1.proved.
Definition theorem_342 := GbtSurfaces.Section_3_3_proofs.eq_17_1.met.
Definition theorem_343 := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_as_printed.refuted.
Definition theorem_344 := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.proved.
Definition theorem_345 := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2_with_f_l.met.
Definition theorem_346 := GbtSurfaces.Section_3_3_proofs.eq_18.refuted.
Definition theorem_347 := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved.
Definition theorem_348 := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met.
Definition theorem_349 := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved.
Definition theorem_350 := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met.
Definition theorem_351 := GbtSurfaces.Section_3_3_proofs.eq_18_tensor_with_f_l.refuted.
Definition theorem_352 := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved.
Definition theorem_353 := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met.
Definition theorem_354 := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_with_f_l.refuted.
Definition theorem_355 := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed.refuted.
Definition theorem_356 := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.proved.
Definition theorem_357 := GbtSurfaces.Section_3_3_proofs.alg_3_a_as_printed_corrected.met.
Definition theorem_358 := GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.proved.
Definition theorem_359 := GbtSurfaces.Section_3_3_proofs.alg_3_a_with_f_l.met.
Definition theorem_360 := GbtSurfaces.Section_3_3_proofs.alg_3_b_by_the_printed_conditions.refuted.
Definition theorem_361 := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted.
Definition theorem_362 := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved.
Definition theorem_363 := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met.
Definition theorem_364 := GbtSurfaces.Section_3_3_proofs.eq_19_literal.refuted.
Definition theorem_365 := GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.proved.
Definition theorem_366 := GbtSurfaces.Section_3_3_proofs.eq_19_m_is_4.met.
Definition theorem_367 := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_as_printed.refuted.
Definition theorem_368 := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.proved.
Definition theorem_369 := GbtSurfaces.Section_3_3_proofs.eq_19_tensor_with_f_l.met.
Definition theorem_370 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted.
Definition theorem_371 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved.
Definition theorem_372 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met.
Definition theorem_373 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted.
Definition theorem_374 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved.
Definition theorem_375 := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met.
Definition theorem_376 := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted.
Definition theorem_377 := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved.
Definition theorem_378 := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met.
Definition theorem_379 := GbtSurfaces.Section_3_4_proofs.eq_21.proved.
Definition theorem_380 := GbtSurfaces.Section_3_4_proofs.eq_21.met.
Definition theorem_381 := GbtSurfaces.Section_3_4_proofs.prop_3_5.proved.
Definition theorem_382 := GbtSurfaces.Section_3_4_proofs.prop_3_5.met.
Definition theorem_383 := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved.
Definition theorem_384 := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met.
Definition theorem_385 := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved.
Definition theorem_386 := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met.
Definition theorem_387 := GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted.
Definition theorem_388 := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved.
Definition theorem_389 := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met.
Definition theorem_390 := GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved.
Definition theorem_391 := GbtSurfaces.Section_3_4_proofs.thm_4_unity.met.
Definition theorem_392 := GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted.
Definition theorem_393 := GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted.
Definition theorem_394 := GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted.
Definition theorem_395 := GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted.
Definition theorem_396 := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved.
Definition theorem_397 := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met.
Definition theorem_398 := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved.
Definition theorem_399 := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met.
Definition theorem_400 := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved.
Definition theorem_401 := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met.
Definition theorem_402 := GbtSurfaces.Section_3_4_proofs.alg_4_b_by_the_printed_conditions.refuted.
Definition theorem_403 := GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.proved.
Definition theorem_404 := GbtSurfaces.Section_3_4_proofs.alg_4_b_there_are_such_connections.met.
Definition theorem_405 := GbtSurfaces.Section_3_4_proofs.eq_26.proved.
Definition theorem_406 := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved.
Definition theorem_407 := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met.
Definition theorem_408 := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted.
Definition theorem_409 := GbtSurfaces.Section_3_5_proofs.eq_27.proved.
Definition theorem_410 := GbtSurfaces.Section_3_5_proofs.eq_27.met.
Definition theorem_411 := GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved.
Definition theorem_412 := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved.
Definition theorem_413 := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met.
Definition theorem_414 := GbtSurfaces.Section_3_5_proofs.alg_5_b_by_the_printed_conditions.refuted.
Definition theorem_415 := GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved.
Definition theorem_416 := GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved.
Definition theorem_417 := GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted.
Definition theorem_418 := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved.
Definition theorem_419 := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met.
Definition theorem_420 := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved.
Definition theorem_421 := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met.
Definition theorem_422 := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved.
Definition theorem_423 := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met.
Definition theorem_424 := GbtSurfaces.Section_3_6_proofs.eq_34.proved.
Definition theorem_425 := GbtSurfaces.Section_3_6_proofs.eq_34.met.
Definition theorem_426 := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved.
Definition theorem_427 := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met.
Definition theorem_428 := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved.
Definition theorem_429 := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met.
Definition theorem_430 := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted.
Definition theorem_431 := GbtSurfaces.Section_3_6_proofs.eq_35.proved.
Definition theorem_432 := GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted.
Definition theorem_433 := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted.
Definition theorem_434 := GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted.
Definition theorem_435 := GbtSurfaces.Section_4_proofs.sec_4_tensor_with_f_l.refuted.
Definition theorem_436 := GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved.
Definition theorem_437 := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved.
Definition theorem_438 := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met.
Definition theorem_439 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved.
Definition theorem_440 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved.
Definition theorem_441 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met.
Definition theorem_442 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved.
Definition theorem_443 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met.
Definition theorem_444 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved.
Definition theorem_445 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met.
Definition theorem_446 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved.
Definition theorem_447 := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met.
Definition theorem_448 := HermiteDevelopable.Section_2_proofs.eq_2_1a.proved.
Definition theorem_449 := HermiteDevelopable.Section_2_proofs.eq_2_1a.met.
Definition theorem_450 := HermiteDevelopable.Section_2_proofs.eq_2_1b.proved.
Definition theorem_451 := HermiteDevelopable.Section_2_proofs.eq_2_1b.met.
Definition theorem_452 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved.
Definition theorem_453 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met.
Definition theorem_454 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved.
Definition theorem_455 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met.
Definition theorem_456 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted.
Definition theorem_457 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved.
Definition theorem_458 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met.
Definition theorem_459 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved.
Definition theorem_460 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met.
Definition theorem_461 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved.
Definition theorem_462 := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met.
Definition theorem_463 := HermiteDevelopable.Section_2_proofs.eq_2_2.proved.
Definition theorem_464 := HermiteDevelopable.Section_2_proofs.eq_2_2.met.
Definition theorem_465 := HermiteDevelopable.Section_2_proofs.eq_2_3.refuted.
Definition theorem_466 := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved.
Definition theorem_467 := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met.
Definition theorem_468 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved.
Definition theorem_469 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met.
Definition theorem_470 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved.
Definition theorem_471 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met.
Definition theorem_472 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved.
Definition theorem_473 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met.
Definition theorem_474 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved.
Definition theorem_475 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met.
Definition theorem_476 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved.
Definition theorem_477 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met.
Definition theorem_478 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved.
Definition theorem_479 := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met.
Definition theorem_480 := HermiteDevelopable.Section_2_proofs.eq_2_4.proved.
Definition theorem_481 := HermiteDevelopable.Section_2_proofs.eq_2_4.met.
Definition theorem_482 := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved.
Definition theorem_483 := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met.
Definition theorem_484 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved.
Definition theorem_485 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met.
Definition theorem_486 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved.
Definition theorem_487 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met.
Definition theorem_488 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved.
Definition theorem_489 := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met.
Definition theorem_490 := Trigonometric.Part_Cardioid_proofs.cardioid_speed.proved.
Definition theorem_491 := Trigonometric.Part_Cardioid_proofs.cardioid_speed.met.
Definition theorem_492 := Trigonometric.Part_Cardioid_proofs.cardioid_cusp.proved.
Definition theorem_493 := Trigonometric.Part_Circles_proofs.quadratic_circle.proved.
Definition theorem_494 := Trigonometric.Part_Circles_proofs.quadratic_circle.met.
Definition theorem_495 := Trigonometric.Part_Curves_proofs.quadratic_ends.proved.
Definition theorem_496 := Trigonometric.Part_Curves_proofs.quadratic_ends.met.
Definition theorem_497 := Trigonometric.Part_Curves_proofs.quadratic_d1.proved.
Definition theorem_498 := Trigonometric.Part_Curves_proofs.quadratic_d1.met.
Definition theorem_499 := Trigonometric.Part_Curves_proofs.quadratic_d2.proved.
Definition theorem_500 := Trigonometric.Part_Curves_proofs.quadratic_d2.met.
Definition theorem_501 := Trigonometric.Part_Curves_proofs.quadratic_d1_slip.refuted.
Definition theorem_502 := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.proved.
Definition theorem_503 := Trigonometric.Part_Curves_proofs.quadratic_d1_slip_corrected.met.
Definition theorem_504 := Trigonometric.Part_Cycloid_proofs.cycloid_speed.proved.
Definition theorem_505 := Trigonometric.Part_Cycloid_proofs.cycloid_speed.met.
Definition theorem_506 := Trigonometric.Part_Cycloid_proofs.cycloid_slope_slip.refuted.
Definition theorem_507 := Trigonometric.Part_Half_proofs.angle_half_sine.proved.
Definition theorem_508 := Trigonometric.Part_Half_proofs.angle_half_cosine.proved.
Definition theorem_509 := Trigonometric.Part_Half_proofs.angle_half_slip.refuted.
Definition theorem_510 := Trigonometric.Part_Half_proofs.angle_half_slip_corrected.proved.
Definition theorem_511 := Trigonometric.Part_Half_proofs.half_unity.proved.
Definition theorem_512 := Trigonometric.Part_Half_proofs.half_unity.met.
Definition theorem_513 := Trigonometric.Part_Half_proofs.half_middle.proved.
Definition theorem_514 := Trigonometric.Part_Half_proofs.half_middle.met.
Definition theorem_515 := Trigonometric.Part_Half_proofs.half_cosine_slip.refuted.
Definition theorem_516 := Trigonometric.Part_Half_proofs.half_powers.proved.
Definition theorem_517 := Trigonometric.Part_Half_proofs.half_powers.met.
Definition theorem_518 := Trigonometric.Part_Half_proofs.half_d1.proved.
Definition theorem_519 := Trigonometric.Part_Half_proofs.half_d1.met.
Definition theorem_520 := Trigonometric.Part_Half_proofs.half_d1_slip.refuted.
Definition theorem_521 := Trigonometric.Part_Half_proofs.half_d1_slip_corrected.proved.
Definition theorem_522 := Trigonometric.Part_Half_proofs.half_d1_slip_corrected.met.
Definition theorem_523 := Trigonometric.Part_Helicoid_proofs.helicoid_skew.proved.
Definition theorem_524 := Trigonometric.Part_Helicoid_proofs.helicoid_skew.met.
Definition theorem_525 := Trigonometric.Part_Helicoid_proofs.helicoid_skew_slip.refuted.
Definition theorem_526 := Trigonometric.Part_Helix_proofs.helix_speed.proved.
Definition theorem_527 := Trigonometric.Part_Helix_proofs.helix_speed.met.
Definition theorem_528 := Trigonometric.Part_Helix_proofs.helix_torsion.proved.
Definition theorem_529 := Trigonometric.Part_Helix_proofs.helix_torsion.met.
Definition theorem_530 := Trigonometric.Part_Helix_proofs.helix_curvature.proved.
Definition theorem_531 := Trigonometric.Part_Helix_proofs.helix_curvature.met.
Definition theorem_532 := Trigonometric.Part_Joins_proofs.quadratic_join.proved.
Definition theorem_533 := Trigonometric.Part_Joins_proofs.quadratic_join.met.
Definition theorem_534 := Trigonometric.Part_Joins_proofs.quadratic_join_slip.refuted.
Definition theorem_535 := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.proved.
Definition theorem_536 := Trigonometric.Part_Joins_proofs.quadratic_join_slip_corrected.met.
Definition theorem_537 := Trigonometric.Part_Parts_proofs.angle_rate.proved.
Definition theorem_538 := Trigonometric.Part_Signs_proofs.angle_symmetric_slip.refuted.
Definition theorem_539 := Trigonometric.Part_Tangent_proofs.helix_torse.proved.
Definition theorem_540 := Trigonometric.Part_Tangent_proofs.helix_torse.met.
Definition theorem_541 := Trigonometric.Part_Tangent_proofs.helix_normal.proved.
Definition theorem_542 := Trigonometric.Part_Tangent_proofs.helix_normal.met.
Definition theorem_543 := Trigonometric.Part_Tangents_proofs.angle_tangent.proved.
Definition theorem_544 := Trigonometric.Part_Tangents_proofs.angle_tangent.met.
Definition theorem_545 := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.proved.
Definition theorem_546 := Trigonometric.Part_Tangents_proofs.angle_tangent_closed.met.
Definition theorem_547 := Trigonometric.Part_The_proofs.quadratic_middle.proved.
Definition theorem_548 := Trigonometric.Part_The_proofs.quadratic_middle.met.
Definition theorem_549 := Trigonometric.Part_The_proofs.quadratic_nonnegative_slip.refuted.
Definition theorem_550 := Trigonometric.Part_The_proofs.quadratic_symmetry.proved.
Definition theorem_551 := Trigonometric.Part_The_proofs.quadratic_symmetry.met.
Definition all_theorems := conj theorem_551 (conj theorem_550 (conj theorem_549 (conj theorem_548 (conj theorem_547 (conj theorem_546 (conj theorem_545 (conj theorem_544 (conj theorem_543 (conj theorem_542 (conj theorem_541 (conj theorem_540 (conj theorem_539 (conj theorem_538 (conj theorem_537 (conj theorem_536 (conj theorem_535 (conj theorem_534 (conj theorem_533 (conj theorem_532 (conj theorem_531 (conj theorem_530 (conj theorem_529 (conj theorem_528 (conj theorem_527 (conj theorem_526 (conj theorem_525 (conj theorem_524 (conj theorem_523 (conj theorem_522 (conj theorem_521 (conj theorem_520 (conj theorem_519 (conj theorem_518 (conj theorem_517 (conj theorem_516 (conj theorem_515 (conj theorem_514 (conj theorem_513 (conj theorem_512 (conj theorem_511 (conj theorem_510 (conj theorem_509 (conj theorem_508 (conj theorem_507 (conj theorem_506 (conj theorem_505 (conj theorem_504 (conj theorem_503 (conj theorem_502 (conj theorem_501 (conj theorem_500 (conj theorem_499 (conj theorem_498 (conj theorem_497 (conj theorem_496 (conj theorem_495 (conj theorem_494 (conj theorem_493 (conj theorem_492 (conj theorem_491 (conj theorem_490 (conj theorem_489 (conj theorem_488 (conj theorem_487 (conj theorem_486 (conj theorem_485 (conj theorem_484 (conj theorem_483 (conj theorem_482 (conj theorem_481 (conj theorem_480 (conj theorem_479 (conj theorem_478 (conj theorem_477 (conj theorem_476 (conj theorem_475 (conj theorem_474 (conj theorem_473 (conj theorem_472 (conj theorem_471 (conj theorem_470 (conj theorem_469 (conj theorem_468 (conj theorem_467 (conj theorem_466 (conj theorem_465 (conj theorem_464 (conj theorem_463 (conj theorem_462 (conj theorem_461 (conj theorem_460 (conj theorem_459 (conj theorem_458 (conj theorem_457 (conj theorem_456 (conj theorem_455 (conj theorem_454 (conj theorem_453 (conj theorem_452 (conj theorem_451 (conj theorem_450 (conj theorem_449 (conj theorem_448 (conj theorem_447 (conj theorem_446 (conj theorem_445 (conj theorem_444 (conj theorem_443 (conj theorem_442 (conj theorem_441 (conj theorem_440 (conj theorem_439 (conj theorem_438 (conj theorem_437 (conj theorem_436 (conj theorem_435 (conj theorem_434 (conj theorem_433 (conj theorem_432 (conj theorem_431 (conj theorem_430 (conj theorem_429 (conj theorem_428 (conj theorem_427 (conj theorem_426 (conj theorem_425 (conj theorem_424 (conj theorem_423 (conj theorem_422 (conj theorem_421 (conj theorem_420 (conj theorem_419 (conj theorem_418 (conj theorem_417 (conj theorem_416 (conj theorem_415 (conj theorem_414 (conj theorem_413 (conj theorem_412 (conj theorem_411 (conj theorem_410 (conj theorem_409 (conj theorem_408 (conj theorem_407 (conj theorem_406 (conj theorem_405 (conj theorem_404 (conj theorem_403 (conj theorem_402 (conj theorem_401 (conj theorem_400 (conj theorem_399 (conj theorem_398 (conj theorem_397 (conj theorem_396 (conj theorem_395 (conj theorem_394 (conj theorem_393 (conj theorem_392 (conj theorem_391 (conj theorem_390 (conj theorem_389 (conj theorem_388 (conj theorem_387 (conj theorem_386 (conj theorem_385 (conj theorem_384 (conj theorem_383 (conj theorem_382 (conj theorem_381 (conj theorem_380 (conj theorem_379 (conj theorem_378 (conj theorem_377 (conj theorem_376 (conj theorem_375 (conj theorem_374 (conj theorem_373 (conj theorem_372 (conj theorem_371 (conj theorem_370 (conj theorem_369 (conj theorem_368 (conj theorem_367 (conj theorem_366 (conj theorem_365 (conj theorem_364 (conj theorem_363 (conj theorem_362 (conj theorem_361 (conj theorem_360 (conj theorem_359 (conj theorem_358 (conj theorem_357 (conj theorem_356 (conj theorem_355 (conj theorem_354 (conj theorem_353 (conj theorem_352 (conj theorem_351 (conj theorem_350 (conj theorem_349 (conj theorem_348 (conj theorem_347 (conj theorem_346 (conj theorem_345 (conj theorem_344 (conj theorem_343 (conj theorem_342 (conj theorem_341 (conj theorem_340 (conj theorem_339 (conj theorem_338 (conj theorem_337 (conj theorem_336 (conj theorem_335 (conj theorem_334 (conj theorem_333 (conj theorem_332 (conj theorem_331 (conj theorem_330 (conj theorem_329 (conj theorem_328 (conj theorem_327 (conj theorem_326 (conj theorem_325 (conj theorem_324 (conj theorem_323 (conj theorem_322 (conj theorem_321 (conj theorem_320 (conj theorem_319 (conj theorem_318 (conj theorem_317 (conj theorem_316 (conj theorem_315 (conj theorem_314 (conj theorem_313 (conj theorem_312 (conj theorem_311 (conj theorem_310 (conj theorem_309 (conj theorem_308 (conj theorem_307 (conj theorem_306 (conj theorem_305 (conj theorem_304 (conj theorem_303 (conj theorem_302 (conj theorem_301 (conj theorem_300 (conj theorem_299 (conj theorem_298 (conj theorem_297 (conj theorem_296 (conj theorem_295 (conj theorem_294 (conj theorem_293 (conj theorem_292 (conj theorem_291 (conj theorem_290 (conj theorem_289 (conj theorem_288 (conj theorem_287 (conj theorem_286 (conj theorem_285 (conj theorem_284 (conj theorem_283 (conj theorem_282 (conj theorem_281 (conj theorem_280 (conj theorem_279 (conj theorem_278 (conj theorem_277 (conj theorem_276 (conj theorem_275 (conj theorem_274 (conj theorem_273 (conj theorem_272 (conj theorem_271 (conj theorem_270 (conj theorem_269 (conj theorem_268 (conj theorem_267 (conj theorem_266 (conj theorem_265 (conj theorem_264 (conj theorem_263 (conj theorem_262 (conj theorem_261 (conj theorem_260 (conj theorem_259 (conj theorem_258 (conj theorem_257 (conj theorem_256 (conj theorem_255 (conj theorem_254 (conj theorem_253 (conj theorem_252 (conj theorem_251 (conj theorem_250 (conj theorem_249 (conj theorem_248 (conj theorem_247 (conj theorem_246 (conj theorem_245 (conj theorem_244 (conj theorem_243 (conj theorem_242 (conj theorem_241 (conj theorem_240 (conj theorem_239 (conj theorem_238 (conj theorem_237 (conj theorem_236 (conj theorem_235 (conj theorem_234 (conj theorem_233 (conj theorem_232 (conj theorem_231 (conj theorem_230 (conj theorem_229 (conj theorem_228 (conj theorem_227 (conj theorem_226 (conj theorem_225 (conj theorem_224 (conj theorem_223 (conj theorem_222 (conj theorem_221 (conj theorem_220 (conj theorem_219 (conj theorem_218 (conj theorem_217 (conj theorem_216 (conj theorem_215 (conj theorem_214 (conj theorem_213 (conj theorem_212 (conj theorem_211 (conj theorem_210 (conj theorem_209 (conj theorem_208 (conj theorem_207 (conj theorem_206 (conj theorem_205 (conj theorem_204 (conj theorem_203 (conj theorem_202 (conj theorem_201 (conj theorem_200 (conj theorem_199 (conj theorem_198 (conj theorem_197 (conj theorem_196 (conj theorem_195 (conj theorem_194 (conj theorem_193 (conj theorem_192 (conj theorem_191 (conj theorem_190 (conj theorem_189 (conj theorem_188 (conj theorem_187 (conj theorem_186 (conj theorem_185 (conj theorem_184 (conj theorem_183 (conj theorem_182 (conj theorem_181 (conj theorem_180 (conj theorem_179 (conj theorem_178 (conj theorem_177 (conj theorem_176 (conj theorem_175 (conj theorem_174 (conj theorem_173 (conj theorem_172 (conj theorem_171 (conj theorem_170 (conj theorem_169 (conj theorem_168 (conj theorem_167 (conj theorem_166 (conj theorem_165 (conj theorem_164 (conj theorem_163 (conj theorem_162 (conj theorem_161 (conj theorem_160 (conj theorem_159 (conj theorem_158 (conj theorem_157 (conj theorem_156 (conj theorem_155 (conj theorem_154 (conj theorem_153 (conj theorem_152 (conj theorem_151 (conj theorem_150 (conj theorem_149 (conj theorem_148 (conj theorem_147 (conj theorem_146 (conj theorem_145 (conj theorem_144 (conj theorem_143 (conj theorem_142 (conj theorem_141 (conj theorem_140 (conj theorem_139 (conj theorem_138 (conj theorem_137 (conj theorem_136 (conj theorem_135 (conj theorem_134 (conj theorem_133 (conj theorem_132 (conj theorem_131 (conj theorem_130 (conj theorem_129 (conj theorem_128 (conj theorem_127 (conj theorem_126 (conj theorem_125 (conj theorem_124 (conj theorem_123 (conj theorem_122 (conj theorem_121 (conj theorem_120 (conj theorem_119 (conj theorem_118 (conj theorem_117 (conj theorem_116 (conj theorem_115 (conj theorem_114 (conj theorem_113 (conj theorem_112 (conj theorem_111 (conj theorem_110 (conj theorem_109 (conj theorem_108 (conj theorem_107 (conj theorem_106 (conj theorem_105 (conj theorem_104 (conj theorem_103 (conj theorem_102 (conj theorem_101 (conj theorem_100 (conj theorem_99 (conj theorem_98 (conj theorem_97 (conj theorem_96 (conj theorem_95 (conj theorem_94 (conj theorem_93 (conj theorem_92 (conj theorem_91 (conj theorem_90 (conj theorem_89 (conj theorem_88 (conj theorem_87 (conj theorem_86 (conj theorem_85 (conj theorem_84 (conj theorem_83 (conj theorem_82 (conj theorem_81 (conj theorem_80 (conj theorem_79 (conj theorem_78 (conj theorem_77 (conj theorem_76 (conj theorem_75 (conj theorem_74 (conj theorem_73 (conj theorem_72 (conj theorem_71 (conj theorem_70 (conj theorem_69 (conj theorem_68 (conj theorem_67 (conj theorem_66 (conj theorem_65 (conj theorem_64 (conj theorem_63 (conj theorem_62 (conj theorem_61 (conj theorem_60 (conj theorem_59 (conj theorem_58 (conj theorem_57 (conj theorem_56 (conj theorem_55 (conj theorem_54 (conj theorem_53 (conj theorem_52 (conj theorem_51 (conj theorem_50 (conj theorem_49 (conj theorem_48 (conj theorem_47 (conj theorem_46 (conj theorem_45 (conj theorem_44 (conj theorem_43 (conj theorem_42 (conj theorem_41 (conj theorem_40 (conj theorem_39 (conj theorem_38 (conj theorem_37 (conj theorem_36 (conj theorem_35 (conj theorem_34 (conj theorem_33 (conj theorem_32 (conj theorem_31 (conj theorem_30 (conj theorem_29 (conj theorem_28 (conj theorem_27 (conj theorem_26 (conj theorem_25 (conj theorem_24 (conj theorem_23 (conj theorem_22 (conj theorem_21 (conj theorem_20 (conj theorem_19 (conj theorem_18 (conj theorem_17 (conj theorem_16 (conj theorem_15 (conj theorem_14 (conj theorem_13 (conj theorem_12 (conj theorem_11 (conj theorem_10 (conj theorem_9 (conj theorem_8 (conj theorem_7 (conj theorem_6 (conj theorem_5 (conj theorem_4 (conj theorem_3 (conj theorem_2 (conj theorem_1 (conj theorem_0 (I)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))).
Print Assumptions all_theorems.
