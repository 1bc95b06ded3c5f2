(* The kernel's word: each theorem has the type of its statement. *)
From GbtDevelopable Require Part_Abstract_printed Part_Abstract_printed_proofs.
From GbtDevelopable Require Part_Abstract Part_Abstract_proofs.
From GbtDevelopable Require Section_1_printed Section_1_printed_proofs.
From GbtDevelopable Require Section_1 Section_1_proofs.
From GbtDevelopable Require Section_2_1_printed Section_2_1_printed_proofs.
From GbtDevelopable Require Section_2_1 Section_2_1_proofs.
From GbtDevelopable Require Section_2_2_printed Section_2_2_printed_proofs.
From GbtDevelopable Require Section_2_2 Section_2_2_proofs.
From GbtDevelopable Require Section_2_3_printed Section_2_3_printed_proofs.
From GbtDevelopable Require Section_2_3 Section_2_3_proofs.
From GbtDevelopable Require Section_3_1_printed Section_3_1_printed_proofs.
From GbtDevelopable Require Section_3_1 Section_3_1_proofs.
From GbtDevelopable Require Section_3_2_printed Section_3_2_printed_proofs.
From GbtDevelopable Require Section_3_2 Section_3_2_proofs.
From GbtDevelopable Require Section_3_3_printed Section_3_3_printed_proofs.
From GbtDevelopable Require Section_3_3 Section_3_3_proofs.
From GbtDevelopable Require Section_3_4_printed Section_3_4_printed_proofs.
From GbtDevelopable Require Section_3_4 Section_3_4_proofs.
From GbtDevelopable Require Section_4_1_printed Section_4_1_printed_proofs.
From GbtDevelopable Require Section_4_1 Section_4_1_proofs.
From GbtDevelopable Require Section_4_2_printed Section_4_2_printed_proofs.
From GbtDevelopable Require Section_4_2 Section_4_2_proofs.
From GbtDevelopable Require Section_4_printed Section_4_printed_proofs.
From GbtDevelopable Require Section_4 Section_4_proofs.
From GbtDevelopable Require Section_5_1_printed Section_5_1_printed_proofs.
From GbtDevelopable Require Section_5_1 Section_5_1_proofs.
From GbtDevelopable Require Section_5_2_printed Section_5_2_printed_proofs.
From GbtDevelopable Require Section_5_2 Section_5_2_proofs.
From GbtDevelopable Require Section_5_3_printed Section_5_3_printed_proofs.
From GbtDevelopable Require Section_5_3 Section_5_3_proofs.
From GbtDevelopable Require Section_5_4_printed Section_5_4_printed_proofs.
From GbtDevelopable Require Section_5_4 Section_5_4_proofs.
From GbtDevelopable Require Section_5_5_printed Section_5_5_printed_proofs.
From GbtDevelopable Require Section_5_5 Section_5_5_proofs.
From GbtDevelopable Require Section_5_printed Section_5_printed_proofs.
From GbtDevelopable Require Section_5 Section_5_proofs.
Check (Part_Abstract_printed_proofs.abs_conics_planes.refuted : ~ Part_Abstract_printed.abs_conics_planes.statement).
Check (Part_Abstract_printed_proofs.abs_conics_points.proved : Part_Abstract_printed.abs_conics_points.statement).
Check (Part_Abstract_printed_proofs.abs_4d_factor.proved : Part_Abstract_printed.abs_4d_factor.statement).
Check (Part_Abstract_printed_proofs.abs_4d_factor.met : Part_Abstract_printed.abs_4d_factor.instance).
Check (Part_Abstract_proofs.abs_conics_planes.refuted : ~ Part_Abstract.abs_conics_planes.statement).
Check (Part_Abstract_proofs.abs_conics_points.proved : Part_Abstract.abs_conics_points.statement).
Check (Part_Abstract_proofs.abs_4d_factor.proved : Part_Abstract.abs_4d_factor.statement).
Check (Part_Abstract_proofs.abs_4d_factor.met : Part_Abstract.abs_4d_factor.instance).
Check (Section_1_printed_proofs.intro_gk_by_the_printed_conditions.refuted : ~ Section_1_printed.intro_gk_by_the_printed_conditions.statement).
Check (Section_1_printed_proofs.intro_gk_there_are_such_compositions.proved : Section_1_printed.intro_gk_there_are_such_compositions.statement).
Check (Section_1_printed_proofs.intro_gk_there_are_such_compositions.met : Section_1_printed.intro_gk_there_are_such_compositions.instance).
Check (Section_1_printed_proofs.intro_continuity_free_a.proved : Section_1_printed.intro_continuity_free_a.statement).
Check (Section_1_printed_proofs.intro_continuity_free_a.met : Section_1_printed.intro_continuity_free_a.instance).
Check (Section_1_printed_proofs.intro_continuity_free_b_any_values.refuted : ~ Section_1_printed.intro_continuity_free_b_any_values.statement).
Check (Section_1_printed_proofs.intro_continuity_free_c_any_values.refuted : ~ Section_1_printed.intro_continuity_free_c_any_values.statement).
Check (Section_1_printed_proofs.intro_contrib_1.proved : Section_1_printed.intro_contrib_1.statement).
Check (Section_1_printed_proofs.intro_contrib_1.met : Section_1_printed.intro_contrib_1.instance).
Check (Section_1_printed_proofs.intro_contrib_2.proved : Section_1_printed.intro_contrib_2.statement).
Check (Section_1_printed_proofs.intro_contrib_2.met : Section_1_printed.intro_contrib_2.instance).
Check (Section_1_printed_proofs.intro_contrib_4.proved : Section_1_printed.intro_contrib_4.statement).
Check (Section_1_printed_proofs.intro_contrib_4.met : Section_1_printed.intro_contrib_4.instance).
Check (Section_1_printed_proofs.intro_gauss.proved : Section_1_printed.intro_gauss.statement).
Check (Section_1_printed_proofs.intro_gauss.met : Section_1_printed.intro_gauss.instance).
Check (Section_1_proofs.intro_gk_by_the_printed_conditions.refuted : ~ Section_1.intro_gk_by_the_printed_conditions.statement).
Check (Section_1_proofs.intro_gk_there_are_such_compositions.proved : Section_1.intro_gk_there_are_such_compositions.statement).
Check (Section_1_proofs.intro_gk_there_are_such_compositions.met : Section_1.intro_gk_there_are_such_compositions.instance).
Check (Section_1_proofs.intro_continuity_free_a.proved : Section_1.intro_continuity_free_a.statement).
Check (Section_1_proofs.intro_continuity_free_a.met : Section_1.intro_continuity_free_a.instance).
Check (Section_1_proofs.intro_continuity_free_b_any_values.refuted : ~ Section_1.intro_continuity_free_b_any_values.statement).
Check (Section_1_proofs.intro_continuity_free_c_any_values.refuted : ~ Section_1.intro_continuity_free_c_any_values.statement).
Check (Section_1_proofs.intro_contrib_1.proved : Section_1.intro_contrib_1.statement).
Check (Section_1_proofs.intro_contrib_1.met : Section_1.intro_contrib_1.instance).
Check (Section_1_proofs.intro_contrib_2.proved : Section_1.intro_contrib_2.statement).
Check (Section_1_proofs.intro_contrib_2.met : Section_1.intro_contrib_2.instance).
Check (Section_1_proofs.intro_contrib_4.proved : Section_1.intro_contrib_4.statement).
Check (Section_1_proofs.intro_contrib_4.met : Section_1.intro_contrib_4.instance).
Check (Section_1_proofs.intro_gauss.proved : Section_1.intro_gauss.statement).
Check (Section_1_proofs.intro_gauss.met : Section_1.intro_gauss.instance).
Check (Section_2_1_printed_proofs.def_1_g0.proved : Section_2_1_printed.def_1_g0.statement).
Check (Section_2_1_printed_proofs.def_1_g0.met : Section_2_1_printed.def_1_g0.instance).
Check (Section_2_1_printed_proofs.def_1_g1.proved : Section_2_1_printed.def_1_g1.statement).
Check (Section_2_1_printed_proofs.def_1_g1.met : Section_2_1_printed.def_1_g1.instance).
Check (Section_2_1_printed_proofs.def_1_g2.proved : Section_2_1_printed.def_1_g2.statement).
Check (Section_2_1_printed_proofs.def_1_g2.met : Section_2_1_printed.def_1_g2.instance).
Check (Section_2_1_printed_proofs.def_1_range.proved : Section_2_1_printed.def_1_range.statement).
Check (Section_2_1_printed_proofs.def_1_range.met : Section_2_1_printed.def_1_range.instance).
Check (Section_2_1_printed_proofs.eq_2_1.proved : Section_2_1_printed.eq_2_1.statement).
Check (Section_2_1_printed_proofs.eq_2_1.met : Section_2_1_printed.eq_2_1.instance).
Check (Section_2_1_printed_proofs.def_1_zero.proved : Section_2_1_printed.def_1_zero.statement).
Check (Section_2_1_printed_proofs.def_1_zero.met : Section_2_1_printed.def_1_zero.instance).
Check (Section_2_1_printed_proofs.thm_1_1_k2_functions.refuted : ~ Section_2_1_printed.thm_1_1_k2_functions.statement).
Check (Section_2_1_printed_proofs.thm_1_1_k2_substitution.proved : Section_2_1_printed.thm_1_1_k2_substitution.statement).
Check (Section_2_1_printed_proofs.thm_1_1_k2_substitution.met : Section_2_1_printed.thm_1_1_k2_substitution.instance).
Check (Section_2_1_printed_proofs.thm_1_1_k3plus_functions.refuted : ~ Section_2_1_printed.thm_1_1_k3plus_functions.statement).
Check (Section_2_1_printed_proofs.thm_1_1_k3plus_substitution.refuted : ~ Section_2_1_printed.thm_1_1_k3plus_substitution.statement).
Check (Section_2_1_printed_proofs.thm_1_1_k3plus_letters.proved : Section_2_1_printed.thm_1_1_k3plus_letters.statement).
Check (Section_2_1_printed_proofs.thm_1_1_k3plus_letters.met : Section_2_1_printed.thm_1_1_k3plus_letters.instance).
Check (Section_2_1_printed_proofs.thm_1_1_degeneration.proved : Section_2_1_printed.thm_1_1_degeneration.statement).
Check (Section_2_1_printed_proofs.thm_1_1_degeneration.met : Section_2_1_printed.thm_1_1_degeneration.instance).
Check (Section_2_1_printed_proofs.thm_1_1_degeneration_only.proved : Section_2_1_printed.thm_1_1_degeneration_only.statement).
Check (Section_2_1_printed_proofs.thm_1_1_degeneration_only.met : Section_2_1_printed.thm_1_1_degeneration_only.instance).
Check (Section_2_1_printed_proofs.thm_1_1_no_degeneration.proved : Section_2_1_printed.thm_1_1_no_degeneration.statement).
Check (Section_2_1_printed_proofs.thm_1_1_no_degeneration.met : Section_2_1_printed.thm_1_1_no_degeneration.instance).
Check (Section_2_1_printed_proofs.thm_1_1_jets.proved : Section_2_1_printed.thm_1_1_jets.statement).
Check (Section_2_1_printed_proofs.thm_1_1_jets.met : Section_2_1_printed.thm_1_1_jets.instance).
Check (Section_2_1_printed_proofs.thm_1_2.proved : Section_2_1_printed.thm_1_2.statement).
Check (Section_2_1_printed_proofs.thm_1_2.met : Section_2_1_printed.thm_1_2.instance).
Check (Section_2_1_printed_proofs.thm_1_3.proved : Section_2_1_printed.thm_1_3.statement).
Check (Section_2_1_printed_proofs.thm_1_3.met : Section_2_1_printed.thm_1_3.instance).
Check (Section_2_1_printed_proofs.thm_1_4.proved : Section_2_1_printed.thm_1_4.statement).
Check (Section_2_1_printed_proofs.thm_1_4.met : Section_2_1_printed.thm_1_4.instance).
Check (Section_2_1_printed_proofs.thm_1_5.refuted : ~ Section_2_1_printed.thm_1_5.statement).
Check (Section_2_1_printed_proofs.thm_1_5_quadratic.proved : Section_2_1_printed.thm_1_5_quadratic.statement).
Check (Section_2_1_printed_proofs.thm_1_5_quadratic.met : Section_2_1_printed.thm_1_5_quadratic.instance).
Check (Section_2_1_printed_proofs.thm_1_5_cubic.proved : Section_2_1_printed.thm_1_5_cubic.statement).
Check (Section_2_1_printed_proofs.thm_1_5_cubic.met : Section_2_1_printed.thm_1_5_cubic.instance).
Check (Section_2_1_printed_proofs.thm_1_5_all.proved : Section_2_1_printed.thm_1_5_all.statement).
Check (Section_2_1_printed_proofs.thm_1_5_all.met : Section_2_1_printed.thm_1_5_all.instance).
Check (Section_2_1_printed_proofs.thm_1_6_a.proved : Section_2_1_printed.thm_1_6_a.statement).
Check (Section_2_1_printed_proofs.thm_1_6_a.met : Section_2_1_printed.thm_1_6_a.instance).
Check (Section_2_1_printed_proofs.thm_1_6_b.proved : Section_2_1_printed.thm_1_6_b.statement).
Check (Section_2_1_printed_proofs.thm_1_6_b.met : Section_2_1_printed.thm_1_6_b.instance).
Check (Section_2_1_printed_proofs.thm_1_6_c.proved : Section_2_1_printed.thm_1_6_c.statement).
Check (Section_2_1_printed_proofs.thm_1_6_c.met : Section_2_1_printed.thm_1_6_c.instance).
Check (Section_2_1_printed_proofs.thm_1_6_d.proved : Section_2_1_printed.thm_1_6_d.statement).
Check (Section_2_1_printed_proofs.thm_1_6_d.met : Section_2_1_printed.thm_1_6_d.instance).
Check (Section_2_1_proofs.def_1_g0.proved : Section_2_1.def_1_g0.statement).
Check (Section_2_1_proofs.def_1_g0.met : Section_2_1.def_1_g0.instance).
Check (Section_2_1_proofs.def_1_g1.proved : Section_2_1.def_1_g1.statement).
Check (Section_2_1_proofs.def_1_g1.met : Section_2_1.def_1_g1.instance).
Check (Section_2_1_proofs.def_1_g2.proved : Section_2_1.def_1_g2.statement).
Check (Section_2_1_proofs.def_1_g2.met : Section_2_1.def_1_g2.instance).
Check (Section_2_1_proofs.def_1_range.proved : Section_2_1.def_1_range.statement).
Check (Section_2_1_proofs.def_1_range.met : Section_2_1.def_1_range.instance).
Check (Section_2_1_proofs.eq_2_1.proved : Section_2_1.eq_2_1.statement).
Check (Section_2_1_proofs.eq_2_1.met : Section_2_1.eq_2_1.instance).
Check (Section_2_1_proofs.def_1_zero.proved : Section_2_1.def_1_zero.statement).
Check (Section_2_1_proofs.def_1_zero.met : Section_2_1.def_1_zero.instance).
Check (Section_2_1_proofs.thm_1_1_k2_functions.refuted : ~ Section_2_1.thm_1_1_k2_functions.statement).
Check (Section_2_1_proofs.thm_1_1_k2_substitution.proved : Section_2_1.thm_1_1_k2_substitution.statement).
Check (Section_2_1_proofs.thm_1_1_k2_substitution.met : Section_2_1.thm_1_1_k2_substitution.instance).
Check (Section_2_1_proofs.thm_1_1_k3plus_functions.refuted : ~ Section_2_1.thm_1_1_k3plus_functions.statement).
Check (Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted : ~ Section_2_1.thm_1_1_k3plus_substitution.statement).
Check (Section_2_1_proofs.thm_1_1_k3plus_letters.proved : Section_2_1.thm_1_1_k3plus_letters.statement).
Check (Section_2_1_proofs.thm_1_1_k3plus_letters.met : Section_2_1.thm_1_1_k3plus_letters.instance).
Check (Section_2_1_proofs.thm_1_1_degeneration.proved : Section_2_1.thm_1_1_degeneration.statement).
Check (Section_2_1_proofs.thm_1_1_degeneration.met : Section_2_1.thm_1_1_degeneration.instance).
Check (Section_2_1_proofs.thm_1_1_degeneration_only.proved : Section_2_1.thm_1_1_degeneration_only.statement).
Check (Section_2_1_proofs.thm_1_1_degeneration_only.met : Section_2_1.thm_1_1_degeneration_only.instance).
Check (Section_2_1_proofs.thm_1_1_no_degeneration.proved : Section_2_1.thm_1_1_no_degeneration.statement).
Check (Section_2_1_proofs.thm_1_1_no_degeneration.met : Section_2_1.thm_1_1_no_degeneration.instance).
Check (Section_2_1_proofs.thm_1_1_jets.proved : Section_2_1.thm_1_1_jets.statement).
Check (Section_2_1_proofs.thm_1_1_jets.met : Section_2_1.thm_1_1_jets.instance).
Check (Section_2_1_proofs.thm_1_2.proved : Section_2_1.thm_1_2.statement).
Check (Section_2_1_proofs.thm_1_2.met : Section_2_1.thm_1_2.instance).
Check (Section_2_1_proofs.thm_1_3.proved : Section_2_1.thm_1_3.statement).
Check (Section_2_1_proofs.thm_1_3.met : Section_2_1.thm_1_3.instance).
Check (Section_2_1_proofs.thm_1_4.proved : Section_2_1.thm_1_4.statement).
Check (Section_2_1_proofs.thm_1_4.met : Section_2_1.thm_1_4.instance).
Check (Section_2_1_proofs.thm_1_5.refuted : ~ Section_2_1.thm_1_5.statement).
Check (Section_2_1_proofs.thm_1_5_quadratic.proved : Section_2_1.thm_1_5_quadratic.statement).
Check (Section_2_1_proofs.thm_1_5_quadratic.met : Section_2_1.thm_1_5_quadratic.instance).
Check (Section_2_1_proofs.thm_1_5_cubic.proved : Section_2_1.thm_1_5_cubic.statement).
Check (Section_2_1_proofs.thm_1_5_cubic.met : Section_2_1.thm_1_5_cubic.instance).
Check (Section_2_1_proofs.thm_1_5_all.proved : Section_2_1.thm_1_5_all.statement).
Check (Section_2_1_proofs.thm_1_5_all.met : Section_2_1.thm_1_5_all.instance).
Check (Section_2_1_proofs.thm_1_6_a.proved : Section_2_1.thm_1_6_a.statement).
Check (Section_2_1_proofs.thm_1_6_a.met : Section_2_1.thm_1_6_a.instance).
Check (Section_2_1_proofs.thm_1_6_b.proved : Section_2_1.thm_1_6_b.statement).
Check (Section_2_1_proofs.thm_1_6_b.met : Section_2_1.thm_1_6_b.instance).
Check (Section_2_1_proofs.thm_1_6_c.proved : Section_2_1.thm_1_6_c.statement).
Check (Section_2_1_proofs.thm_1_6_c.met : Section_2_1.thm_1_6_c.instance).
Check (Section_2_1_proofs.thm_1_6_d.proved : Section_2_1.thm_1_6_d.statement).
Check (Section_2_1_proofs.thm_1_6_d.met : Section_2_1.thm_1_6_d.instance).
Check (Section_2_2_printed_proofs.def_2_dim.refuted : ~ Section_2_2_printed.def_2_dim.statement).
Check (Section_2_2_printed_proofs.sec_2_2_endpoints.proved : Section_2_2_printed.sec_2_2_endpoints.statement).
Check (Section_2_2_printed_proofs.sec_2_2_endpoints.met : Section_2_2_printed.sec_2_2_endpoints.instance).
Check (Section_2_2_printed_proofs.sec_2_2_convexity.proved : Section_2_2_printed.sec_2_2_convexity.statement).
Check (Section_2_2_printed_proofs.sec_2_2_convexity.met : Section_2_2_printed.sec_2_2_convexity.instance).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry.proved : Section_2_2_printed.sec_2_2_symmetry.statement).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry.met : Section_2_2_printed.sec_2_2_symmetry.instance).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.proved : Section_2_2_printed.sec_2_2_symmetry_exchange.statement).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.met : Section_2_2_printed.sec_2_2_symmetry_exchange.instance).
Check (Section_2_2_printed_proofs.sec_2_2_vd_quadratic.proved : Section_2_2_printed.sec_2_2_vd_quadratic.statement).
Check (Section_2_2_printed_proofs.sec_2_2_vd_quadratic.met : Section_2_2_printed.sec_2_2_vd_quadratic.instance).
Check (Section_2_2_printed_proofs.sec_2_2_vd_operator.proved : Section_2_2_printed.sec_2_2_vd_operator.statement).
Check (Section_2_2_printed_proofs.sec_2_2_vd_operator.met : Section_2_2_printed.sec_2_2_vd_operator.instance).
Check (Section_2_2_printed_proofs.sec_2_2_geominv.proved : Section_2_2_printed.sec_2_2_geominv.statement).
Check (Section_2_2_printed_proofs.sec_2_2_geominv.met : Section_2_2_printed.sec_2_2_geominv.instance).
Check (Section_2_2_proofs.def_2_dim.refuted : ~ Section_2_2.def_2_dim.statement).
Check (Section_2_2_proofs.sec_2_2_endpoints.proved : Section_2_2.sec_2_2_endpoints.statement).
Check (Section_2_2_proofs.sec_2_2_endpoints.met : Section_2_2.sec_2_2_endpoints.instance).
Check (Section_2_2_proofs.sec_2_2_convexity.proved : Section_2_2.sec_2_2_convexity.statement).
Check (Section_2_2_proofs.sec_2_2_convexity.met : Section_2_2.sec_2_2_convexity.instance).
Check (Section_2_2_proofs.sec_2_2_symmetry.proved : Section_2_2.sec_2_2_symmetry.statement).
Check (Section_2_2_proofs.sec_2_2_symmetry.met : Section_2_2.sec_2_2_symmetry.instance).
Check (Section_2_2_proofs.sec_2_2_symmetry_exchange.proved : Section_2_2.sec_2_2_symmetry_exchange.statement).
Check (Section_2_2_proofs.sec_2_2_symmetry_exchange.met : Section_2_2.sec_2_2_symmetry_exchange.instance).
Check (Section_2_2_proofs.sec_2_2_vd_quadratic.proved : Section_2_2.sec_2_2_vd_quadratic.statement).
Check (Section_2_2_proofs.sec_2_2_vd_quadratic.met : Section_2_2.sec_2_2_vd_quadratic.instance).
Check (Section_2_2_proofs.sec_2_2_vd_operator.proved : Section_2_2.sec_2_2_vd_operator.statement).
Check (Section_2_2_proofs.sec_2_2_vd_operator.met : Section_2_2.sec_2_2_vd_operator.instance).
Check (Section_2_2_proofs.sec_2_2_geominv.proved : Section_2_2.sec_2_2_geominv.statement).
Check (Section_2_2_proofs.sec_2_2_geominv.met : Section_2_2.sec_2_2_geominv.instance).
Check (Section_2_3_printed_proofs.sec_2_3_local_part_of_a_curve.refuted : ~ Section_2_3_printed.sec_2_3_local_part_of_a_curve.statement).
Check (Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.proved : Section_2_3_printed.sec_2_3_local_part_of_a_composite.statement).
Check (Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.met : Section_2_3_printed.sec_2_3_local_part_of_a_composite.instance).
Check (Section_2_3_printed_proofs.sec_2_3_linear.proved : Section_2_3_printed.sec_2_3_linear.statement).
Check (Section_2_3_printed_proofs.sec_2_3_linear.met : Section_2_3_printed.sec_2_3_linear.instance).
Check (Section_2_3_printed_proofs.eq_2_3.refuted : ~ Section_2_3_printed.eq_2_3.statement).
Check (Section_2_3_printed_proofs.eq_2_3_corrected.proved : Section_2_3_printed.eq_2_3_corrected.statement).
Check (Section_2_3_printed_proofs.eq_2_3_corrected.met : Section_2_3_printed.eq_2_3_corrected.instance).
Check (Section_2_3_printed_proofs.eq_2_4.refuted : ~ Section_2_3_printed.eq_2_4.statement).
Check (Section_2_3_printed_proofs.eq_2_4_corrected.proved : Section_2_3_printed.eq_2_4_corrected.statement).
Check (Section_2_3_printed_proofs.eq_2_4_corrected.met : Section_2_3_printed.eq_2_4_corrected.instance).
Check (Section_2_3_printed_proofs.sec_2_3_indep_mu.proved : Section_2_3_printed.sec_2_3_indep_mu.statement).
Check (Section_2_3_printed_proofs.sec_2_3_indep_mu.met : Section_2_3_printed.sec_2_3_indep_mu.instance).
Check (Section_2_3_printed_proofs.sec_2_3_indep_nu.proved : Section_2_3_printed.sec_2_3_indep_nu.statement).
Check (Section_2_3_printed_proofs.sec_2_3_indep_nu.met : Section_2_3_printed.sec_2_3_indep_nu.instance).
Check (Section_2_3_printed_proofs.sec_2_3_move.proved : Section_2_3_printed.sec_2_3_move.statement).
Check (Section_2_3_printed_proofs.sec_2_3_move.met : Section_2_3_printed.sec_2_3_move.instance).
Check (Section_2_3_printed_proofs.sec_2_3_dir_mu.proved : Section_2_3_printed.sec_2_3_dir_mu.statement).
Check (Section_2_3_printed_proofs.sec_2_3_dir_mu.met : Section_2_3_printed.sec_2_3_dir_mu.instance).
Check (Section_2_3_printed_proofs.sec_2_3_dir_mu_single.proved : Section_2_3_printed.sec_2_3_dir_mu_single.statement).
Check (Section_2_3_printed_proofs.sec_2_3_dir_mu_single.met : Section_2_3_printed.sec_2_3_dir_mu_single.instance).
Check (Section_2_3_printed_proofs.sec_2_3_dir_nu.proved : Section_2_3_printed.sec_2_3_dir_nu.statement).
Check (Section_2_3_printed_proofs.sec_2_3_dir_nu.met : Section_2_3_printed.sec_2_3_dir_nu.instance).
Check (Section_2_3_printed_proofs.sec_2_3_range.refuted : ~ Section_2_3_printed.sec_2_3_range.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_1.proved : Section_2_3_printed.sec_2_3_concl_1.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_1.met : Section_2_3_printed.sec_2_3_concl_1.instance).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted : ~ Section_2_3_printed.sec_2_3_concl_2_boundary_of_the_hull.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_control_polygon.refuted : ~ Section_2_3_printed.sec_2_3_concl_2_control_polygon.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.proved : Section_2_3_printed.sec_2_3_concl_2_quadratic.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.met : Section_2_3_printed.sec_2_3_concl_2_quadratic.instance).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_mean.proved : Section_2_3_printed.sec_2_3_concl_2_mean.statement).
Check (Section_2_3_printed_proofs.sec_2_3_concl_2_mean.met : Section_2_3_printed.sec_2_3_concl_2_mean.instance).
Check (Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted : ~ Section_2_3.sec_2_3_local_part_of_a_curve.statement).
Check (Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved : Section_2_3.sec_2_3_local_part_of_a_composite.statement).
Check (Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met : Section_2_3.sec_2_3_local_part_of_a_composite.instance).
Check (Section_2_3_proofs.sec_2_3_linear.proved : Section_2_3.sec_2_3_linear.statement).
Check (Section_2_3_proofs.sec_2_3_linear.met : Section_2_3.sec_2_3_linear.instance).
Check (Section_2_3_proofs.eq_2_3.refuted : ~ Section_2_3.eq_2_3.statement).
Check (Section_2_3_proofs.eq_2_3_corrected.proved : Section_2_3.eq_2_3_corrected.statement).
Check (Section_2_3_proofs.eq_2_3_corrected.met : Section_2_3.eq_2_3_corrected.instance).
Check (Section_2_3_proofs.eq_2_4.refuted : ~ Section_2_3.eq_2_4.statement).
Check (Section_2_3_proofs.eq_2_4_corrected.proved : Section_2_3.eq_2_4_corrected.statement).
Check (Section_2_3_proofs.eq_2_4_corrected.met : Section_2_3.eq_2_4_corrected.instance).
Check (Section_2_3_proofs.sec_2_3_indep_mu.proved : Section_2_3.sec_2_3_indep_mu.statement).
Check (Section_2_3_proofs.sec_2_3_indep_mu.met : Section_2_3.sec_2_3_indep_mu.instance).
Check (Section_2_3_proofs.sec_2_3_indep_nu.proved : Section_2_3.sec_2_3_indep_nu.statement).
Check (Section_2_3_proofs.sec_2_3_indep_nu.met : Section_2_3.sec_2_3_indep_nu.instance).
Check (Section_2_3_proofs.sec_2_3_move.proved : Section_2_3.sec_2_3_move.statement).
Check (Section_2_3_proofs.sec_2_3_move.met : Section_2_3.sec_2_3_move.instance).
Check (Section_2_3_proofs.sec_2_3_dir_mu.proved : Section_2_3.sec_2_3_dir_mu.statement).
Check (Section_2_3_proofs.sec_2_3_dir_mu.met : Section_2_3.sec_2_3_dir_mu.instance).
Check (Section_2_3_proofs.sec_2_3_dir_mu_single.proved : Section_2_3.sec_2_3_dir_mu_single.statement).
Check (Section_2_3_proofs.sec_2_3_dir_mu_single.met : Section_2_3.sec_2_3_dir_mu_single.instance).
Check (Section_2_3_proofs.sec_2_3_dir_nu.proved : Section_2_3.sec_2_3_dir_nu.statement).
Check (Section_2_3_proofs.sec_2_3_dir_nu.met : Section_2_3.sec_2_3_dir_nu.instance).
Check (Section_2_3_proofs.sec_2_3_range.refuted : ~ Section_2_3.sec_2_3_range.statement).
Check (Section_2_3_proofs.sec_2_3_concl_1.proved : Section_2_3.sec_2_3_concl_1.statement).
Check (Section_2_3_proofs.sec_2_3_concl_1.met : Section_2_3.sec_2_3_concl_1.instance).
Check (Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted : ~ Section_2_3.sec_2_3_concl_2_boundary_of_the_hull.statement).
Check (Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted : ~ Section_2_3.sec_2_3_concl_2_control_polygon.statement).
Check (Section_2_3_proofs.sec_2_3_concl_2_quadratic.proved : Section_2_3.sec_2_3_concl_2_quadratic.statement).
Check (Section_2_3_proofs.sec_2_3_concl_2_quadratic.met : Section_2_3.sec_2_3_concl_2_quadratic.instance).
Check (Section_2_3_proofs.sec_2_3_concl_2_mean.proved : Section_2_3.sec_2_3_concl_2_mean.statement).
Check (Section_2_3_proofs.sec_2_3_concl_2_mean.met : Section_2_3.sec_2_3_concl_2_mean.instance).
Check (Section_3_1_printed_proofs.sec_3_1_space.proved : Section_3_1_printed.sec_3_1_space.statement).
Check (Section_3_1_printed_proofs.sec_3_1_space.met : Section_3_1_printed.sec_3_1_space.instance).
Check (Section_3_1_printed_proofs.eq_3_2.proved : Section_3_1_printed.eq_3_2.statement).
Check (Section_3_1_printed_proofs.eq_3_2.met : Section_3_1_printed.eq_3_2.instance).
Check (Section_3_1_printed_proofs.eq_3_3.proved : Section_3_1_printed.eq_3_3.statement).
Check (Section_3_1_printed_proofs.eq_3_3.met : Section_3_1_printed.eq_3_3.instance).
Check (Section_3_1_printed_proofs.eq_3_4.proved : Section_3_1_printed.eq_3_4.statement).
Check (Section_3_1_printed_proofs.eq_3_4.met : Section_3_1_printed.eq_3_4.instance).
Check (Section_3_1_printed_proofs.sec_3_1_ref.refuted : ~ Section_3_1_printed.sec_3_1_ref.statement).
Check (Section_3_1_printed_proofs.sec_3_1_ref_true.proved : Section_3_1_printed.sec_3_1_ref_true.statement).
Check (Section_3_1_printed_proofs.sec_3_1_ref_true.met : Section_3_1_printed.sec_3_1_ref_true.instance).
Check (Section_3_1_proofs.sec_3_1_space.proved : Section_3_1.sec_3_1_space.statement).
Check (Section_3_1_proofs.sec_3_1_space.met : Section_3_1.sec_3_1_space.instance).
Check (Section_3_1_proofs.eq_3_2.proved : Section_3_1.eq_3_2.statement).
Check (Section_3_1_proofs.eq_3_2.met : Section_3_1.eq_3_2.instance).
Check (Section_3_1_proofs.eq_3_3.proved : Section_3_1.eq_3_3.statement).
Check (Section_3_1_proofs.eq_3_3.met : Section_3_1.eq_3_3.instance).
Check (Section_3_1_proofs.eq_3_4.proved : Section_3_1.eq_3_4.statement).
Check (Section_3_1_proofs.eq_3_4.met : Section_3_1.eq_3_4.instance).
Check (Section_3_1_proofs.sec_3_1_ref.refuted : ~ Section_3_1.sec_3_1_ref.statement).
Check (Section_3_1_proofs.sec_3_1_ref_true.proved : Section_3_1.sec_3_1_ref_true.statement).
Check (Section_3_1_proofs.sec_3_1_ref_true.met : Section_3_1.sec_3_1_ref_true.instance).
Check (Section_3_2_printed_proofs.eq_3_5.proved : Section_3_2_printed.eq_3_5.statement).
Check (Section_3_2_printed_proofs.eq_3_5.met : Section_3_2_printed.eq_3_5.instance).
Check (Section_3_2_printed_proofs.eq_3_6.proved : Section_3_2_printed.eq_3_6.statement).
Check (Section_3_2_printed_proofs.eq_3_6.met : Section_3_2_printed.eq_3_6.instance).
Check (Section_3_2_printed_proofs.sec_3_2_phi.proved : Section_3_2_printed.sec_3_2_phi.statement).
Check (Section_3_2_printed_proofs.sec_3_2_theta.proved : Section_3_2_printed.sec_3_2_theta.statement).
Check (Section_3_2_printed_proofs.sec_3_2_theta.met : Section_3_2_printed.sec_3_2_theta.instance).
Check (Section_3_2_printed_proofs.sec_3_2_phi_exp.proved : Section_3_2_printed.sec_3_2_phi_exp.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_vec.proved : Section_3_2_printed.sec_3_2_psi_vec.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_vec.met : Section_3_2_printed.sec_3_2_psi_vec.instance).
Check (Section_3_2_printed_proofs.sec_3_2_psi_nearest.proved : Section_3_2_printed.sec_3_2_psi_nearest.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_nearest.met : Section_3_2_printed.sec_3_2_psi_nearest.instance).
Check (Section_3_2_printed_proofs.sec_3_2_psi_x.proved : Section_3_2_printed.sec_3_2_psi_x.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_y.proved : Section_3_2_printed.sec_3_2_psi_y.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_z.refuted : ~ Section_3_2_printed.sec_3_2_psi_z.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_z_corrected.proved : Section_3_2_printed.sec_3_2_psi_z_corrected.statement).
Check (Section_3_2_printed_proofs.sec_3_2_psi_den.proved : Section_3_2_printed.sec_3_2_psi_den.statement).
Check (Section_3_2_printed_proofs.eq_3_7.proved : Section_3_2_printed.eq_3_7.statement).
Check (Section_3_2_printed_proofs.eq_3_7.met : Section_3_2_printed.eq_3_7.instance).
Check (Section_3_2_printed_proofs.sec_3_2_envelope.proved : Section_3_2_printed.sec_3_2_envelope.statement).
Check (Section_3_2_printed_proofs.sec_3_2_envelope.met : Section_3_2_printed.sec_3_2_envelope.instance).
Check (Section_3_2_proofs.eq_3_5.proved : Section_3_2.eq_3_5.statement).
Check (Section_3_2_proofs.eq_3_5.met : Section_3_2.eq_3_5.instance).
Check (Section_3_2_proofs.eq_3_6.proved : Section_3_2.eq_3_6.statement).
Check (Section_3_2_proofs.eq_3_6.met : Section_3_2.eq_3_6.instance).
Check (Section_3_2_proofs.sec_3_2_phi.proved : Section_3_2.sec_3_2_phi.statement).
Check (Section_3_2_proofs.sec_3_2_theta.proved : Section_3_2.sec_3_2_theta.statement).
Check (Section_3_2_proofs.sec_3_2_theta.met : Section_3_2.sec_3_2_theta.instance).
Check (Section_3_2_proofs.sec_3_2_phi_exp.proved : Section_3_2.sec_3_2_phi_exp.statement).
Check (Section_3_2_proofs.sec_3_2_psi_vec.proved : Section_3_2.sec_3_2_psi_vec.statement).
Check (Section_3_2_proofs.sec_3_2_psi_vec.met : Section_3_2.sec_3_2_psi_vec.instance).
Check (Section_3_2_proofs.sec_3_2_psi_nearest.proved : Section_3_2.sec_3_2_psi_nearest.statement).
Check (Section_3_2_proofs.sec_3_2_psi_nearest.met : Section_3_2.sec_3_2_psi_nearest.instance).
Check (Section_3_2_proofs.sec_3_2_psi_x.proved : Section_3_2.sec_3_2_psi_x.statement).
Check (Section_3_2_proofs.sec_3_2_psi_y.proved : Section_3_2.sec_3_2_psi_y.statement).
Check (Section_3_2_proofs.sec_3_2_psi_z.refuted : ~ Section_3_2.sec_3_2_psi_z.statement).
Check (Section_3_2_proofs.sec_3_2_psi_z_corrected.proved : Section_3_2.sec_3_2_psi_z_corrected.statement).
Check (Section_3_2_proofs.sec_3_2_psi_den.proved : Section_3_2.sec_3_2_psi_den.statement).
Check (Section_3_2_proofs.eq_3_7.proved : Section_3_2.eq_3_7.statement).
Check (Section_3_2_proofs.eq_3_7.met : Section_3_2.eq_3_7.instance).
Check (Section_3_2_proofs.sec_3_2_envelope.proved : Section_3_2.sec_3_2_envelope.statement).
Check (Section_3_2_proofs.sec_3_2_envelope.met : Section_3_2.sec_3_2_envelope.instance).
Check (Section_3_3_printed_proofs.eq_3_8.proved : Section_3_3_printed.eq_3_8.statement).
Check (Section_3_3_printed_proofs.eq_3_8.met : Section_3_3_printed.eq_3_8.instance).
Check (Section_3_3_printed_proofs.eq_3_9.proved : Section_3_3_printed.eq_3_9.statement).
Check (Section_3_3_printed_proofs.eq_3_9.met : Section_3_3_printed.eq_3_9.instance).
Check (Section_3_3_printed_proofs.sec_3_3_S_vec.refuted : ~ Section_3_3_printed.sec_3_3_S_vec.statement).
Check (Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.proved : Section_3_3_printed.sec_3_3_S_vec_corrected.statement).
Check (Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.met : Section_3_3_printed.sec_3_3_S_vec_corrected.instance).
Check (Section_3_3_printed_proofs.sec_3_3_S_x.proved : Section_3_3_printed.sec_3_3_S_x.statement).
Check (Section_3_3_printed_proofs.sec_3_3_S_y.proved : Section_3_3_printed.sec_3_3_S_y.statement).
Check (Section_3_3_printed_proofs.sec_3_3_S_z.proved : Section_3_3_printed.sec_3_3_S_z.statement).
Check (Section_3_3_printed_proofs.sec_3_3_S_den.proved : Section_3_3_printed.sec_3_3_S_den.statement).
Check (Section_3_3_printed_proofs.sec_3_3_regression.proved : Section_3_3_printed.sec_3_3_regression.statement).
Check (Section_3_3_printed_proofs.sec_3_3_regression.met : Section_3_3_printed.sec_3_3_regression.instance).
Check (Section_3_3_printed_proofs.sec_3_3_regression_velocity.proved : Section_3_3_printed.sec_3_3_regression_velocity.statement).
Check (Section_3_3_printed_proofs.sec_3_3_regression_velocity.met : Section_3_3_printed.sec_3_3_regression_velocity.instance).
Check (Section_3_3_printed_proofs.sec_3_3_regression_quadratic.proved : Section_3_3_printed.sec_3_3_regression_quadratic.statement).
Check (Section_3_3_printed_proofs.sec_3_3_regression_quadratic.met : Section_3_3_printed.sec_3_3_regression_quadratic.instance).
Check (Section_3_3_printed_proofs.eq_3_10.proved : Section_3_3_printed.eq_3_10.statement).
Check (Section_3_3_printed_proofs.eq_3_10.met : Section_3_3_printed.eq_3_10.instance).
Check (Section_3_3_printed_proofs.sec_3_3_developable.proved : Section_3_3_printed.sec_3_3_developable.statement).
Check (Section_3_3_printed_proofs.sec_3_3_developable.met : Section_3_3_printed.sec_3_3_developable.instance).
Check (Section_3_3_proofs.eq_3_8.proved : Section_3_3.eq_3_8.statement).
Check (Section_3_3_proofs.eq_3_8.met : Section_3_3.eq_3_8.instance).
Check (Section_3_3_proofs.eq_3_9.proved : Section_3_3.eq_3_9.statement).
Check (Section_3_3_proofs.eq_3_9.met : Section_3_3.eq_3_9.instance).
Check (Section_3_3_proofs.sec_3_3_S_vec.refuted : ~ Section_3_3.sec_3_3_S_vec.statement).
Check (Section_3_3_proofs.sec_3_3_S_vec_corrected.proved : Section_3_3.sec_3_3_S_vec_corrected.statement).
Check (Section_3_3_proofs.sec_3_3_S_vec_corrected.met : Section_3_3.sec_3_3_S_vec_corrected.instance).
Check (Section_3_3_proofs.sec_3_3_S_x.proved : Section_3_3.sec_3_3_S_x.statement).
Check (Section_3_3_proofs.sec_3_3_S_y.proved : Section_3_3.sec_3_3_S_y.statement).
Check (Section_3_3_proofs.sec_3_3_S_z.proved : Section_3_3.sec_3_3_S_z.statement).
Check (Section_3_3_proofs.sec_3_3_S_den.proved : Section_3_3.sec_3_3_S_den.statement).
Check (Section_3_3_proofs.sec_3_3_regression.proved : Section_3_3.sec_3_3_regression.statement).
Check (Section_3_3_proofs.sec_3_3_regression.met : Section_3_3.sec_3_3_regression.instance).
Check (Section_3_3_proofs.sec_3_3_regression_velocity.proved : Section_3_3.sec_3_3_regression_velocity.statement).
Check (Section_3_3_proofs.sec_3_3_regression_velocity.met : Section_3_3.sec_3_3_regression_velocity.instance).
Check (Section_3_3_proofs.sec_3_3_regression_quadratic.proved : Section_3_3.sec_3_3_regression_quadratic.statement).
Check (Section_3_3_proofs.sec_3_3_regression_quadratic.met : Section_3_3.sec_3_3_regression_quadratic.instance).
Check (Section_3_3_proofs.eq_3_10.proved : Section_3_3.eq_3_10.statement).
Check (Section_3_3_proofs.eq_3_10.met : Section_3_3.eq_3_10.instance).
Check (Section_3_3_proofs.sec_3_3_developable.proved : Section_3_3.sec_3_3_developable.statement).
Check (Section_3_3_proofs.sec_3_3_developable.met : Section_3_3.sec_3_3_developable.instance).
Check (Section_3_4_printed_proofs.eq_3_11_a.proved : Section_3_4_printed.eq_3_11_a.statement).
Check (Section_3_4_printed_proofs.eq_3_11_a.met : Section_3_4_printed.eq_3_11_a.instance).
Check (Section_3_4_printed_proofs.eq_3_11_b.proved : Section_3_4_printed.eq_3_11_b.statement).
Check (Section_3_4_printed_proofs.eq_3_11_b.met : Section_3_4_printed.eq_3_11_b.instance).
Check (Section_3_4_printed_proofs.eq_3_11_c.proved : Section_3_4_printed.eq_3_11_c.statement).
Check (Section_3_4_printed_proofs.eq_3_11_c.met : Section_3_4_printed.eq_3_11_c.instance).
Check (Section_3_4_printed_proofs.eq_3_12_a.proved : Section_3_4_printed.eq_3_12_a.statement).
Check (Section_3_4_printed_proofs.eq_3_12_a.met : Section_3_4_printed.eq_3_12_a.instance).
Check (Section_3_4_printed_proofs.eq_3_12_b.proved : Section_3_4_printed.eq_3_12_b.statement).
Check (Section_3_4_printed_proofs.eq_3_12_b.met : Section_3_4_printed.eq_3_12_b.instance).
Check (Section_3_4_printed_proofs.eq_3_12_c.proved : Section_3_4_printed.eq_3_12_c.statement).
Check (Section_3_4_printed_proofs.eq_3_12_c.met : Section_3_4_printed.eq_3_12_c.instance).
Check (Section_3_4_printed_proofs.sec_3_4_tangent_ends.proved : Section_3_4_printed.sec_3_4_tangent_ends.statement).
Check (Section_3_4_printed_proofs.sec_3_4_tangent_ends.met : Section_3_4_printed.sec_3_4_tangent_ends.instance).
Check (Section_3_4_printed_proofs.eq_3_13.proved : Section_3_4_printed.eq_3_13.statement).
Check (Section_3_4_printed_proofs.eq_3_13.met : Section_3_4_printed.eq_3_13.instance).
Check (Section_3_4_printed_proofs.sec_3_4_J0.proved : Section_3_4_printed.sec_3_4_J0.statement).
Check (Section_3_4_printed_proofs.sec_3_4_J0.met : Section_3_4_printed.sec_3_4_J0.instance).
Check (Section_3_4_printed_proofs.sec_3_4_dual.proved : Section_3_4_printed.sec_3_4_dual.statement).
Check (Section_3_4_printed_proofs.sec_3_4_dual.met : Section_3_4_printed.sec_3_4_dual.instance).
Check (Section_3_4_printed_proofs.sec_3_4_J1.proved : Section_3_4_printed.sec_3_4_J1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_J1.met : Section_3_4_printed.sec_3_4_J1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r1.proved : Section_3_4_printed.sec_3_4_m0_r1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r1.met : Section_3_4_printed.sec_3_4_m0_r1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r2.proved : Section_3_4_printed.sec_3_4_m0_r2.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r2.met : Section_3_4_printed.sec_3_4_m0_r2.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.proved : Section_3_4_printed.sec_3_4_m0_r3_c1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.met : Section_3_4_printed.sec_3_4_m0_r3_c1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c2.refuted : ~ Section_3_4_printed.sec_3_4_m0_r3_c2.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.proved : Section_3_4_printed.sec_3_4_m0_r3_c2_corrected.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.met : Section_3_4_printed.sec_3_4_m0_r3_c2_corrected.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_true.proved : Section_3_4_printed.sec_3_4_m0_r3_true.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_true.met : Section_3_4_printed.sec_3_4_m0_r3_true.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c3.refuted : ~ Section_3_4_printed.sec_3_4_m0_r3_c3.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.proved : Section_3_4_printed.sec_3_4_m0_r3_c3_corrected.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.met : Section_3_4_printed.sec_3_4_m0_r3_c3_corrected.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r1.proved : Section_3_4_printed.sec_3_4_m1_r1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r1.met : Section_3_4_printed.sec_3_4_m1_r1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r2.proved : Section_3_4_printed.sec_3_4_m1_r2.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r2.met : Section_3_4_printed.sec_3_4_m1_r2.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.proved : Section_3_4_printed.sec_3_4_m1_r3_c1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.met : Section_3_4_printed.sec_3_4_m1_r3_c1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c2.refuted : ~ Section_3_4_printed.sec_3_4_m1_r3_c2.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.proved : Section_3_4_printed.sec_3_4_m1_r3_c2_corrected.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.met : Section_3_4_printed.sec_3_4_m1_r3_c2_corrected.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_true.proved : Section_3_4_printed.sec_3_4_m1_r3_true.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_true.met : Section_3_4_printed.sec_3_4_m1_r3_true.instance).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.proved : Section_3_4_printed.sec_3_4_m1_r3_c3.statement).
Check (Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.met : Section_3_4_printed.sec_3_4_m1_r3_c3.instance).
Check (Section_3_4_printed_proofs.sec_3_4_S0.proved : Section_3_4_printed.sec_3_4_S0.statement).
Check (Section_3_4_printed_proofs.sec_3_4_S0.met : Section_3_4_printed.sec_3_4_S0.instance).
Check (Section_3_4_printed_proofs.sec_3_4_S0_gen.proved : Section_3_4_printed.sec_3_4_S0_gen.statement).
Check (Section_3_4_printed_proofs.sec_3_4_S0_gen.met : Section_3_4_printed.sec_3_4_S0_gen.instance).
Check (Section_3_4_printed_proofs.sec_3_4_S1.proved : Section_3_4_printed.sec_3_4_S1.statement).
Check (Section_3_4_printed_proofs.sec_3_4_S1.met : Section_3_4_printed.sec_3_4_S1.instance).
Check (Section_3_4_printed_proofs.sec_3_4_S1_gen.proved : Section_3_4_printed.sec_3_4_S1_gen.statement).
Check (Section_3_4_printed_proofs.sec_3_4_S1_gen.met : Section_3_4_printed.sec_3_4_S1_gen.instance).
Check (Section_3_4_proofs.eq_3_11_a.proved : Section_3_4.eq_3_11_a.statement).
Check (Section_3_4_proofs.eq_3_11_a.met : Section_3_4.eq_3_11_a.instance).
Check (Section_3_4_proofs.eq_3_11_b.proved : Section_3_4.eq_3_11_b.statement).
Check (Section_3_4_proofs.eq_3_11_b.met : Section_3_4.eq_3_11_b.instance).
Check (Section_3_4_proofs.eq_3_11_c.proved : Section_3_4.eq_3_11_c.statement).
Check (Section_3_4_proofs.eq_3_11_c.met : Section_3_4.eq_3_11_c.instance).
Check (Section_3_4_proofs.eq_3_12_a.proved : Section_3_4.eq_3_12_a.statement).
Check (Section_3_4_proofs.eq_3_12_a.met : Section_3_4.eq_3_12_a.instance).
Check (Section_3_4_proofs.eq_3_12_b.proved : Section_3_4.eq_3_12_b.statement).
Check (Section_3_4_proofs.eq_3_12_b.met : Section_3_4.eq_3_12_b.instance).
Check (Section_3_4_proofs.eq_3_12_c.proved : Section_3_4.eq_3_12_c.statement).
Check (Section_3_4_proofs.eq_3_12_c.met : Section_3_4.eq_3_12_c.instance).
Check (Section_3_4_proofs.sec_3_4_tangent_ends.proved : Section_3_4.sec_3_4_tangent_ends.statement).
Check (Section_3_4_proofs.sec_3_4_tangent_ends.met : Section_3_4.sec_3_4_tangent_ends.instance).
Check (Section_3_4_proofs.eq_3_13.proved : Section_3_4.eq_3_13.statement).
Check (Section_3_4_proofs.eq_3_13.met : Section_3_4.eq_3_13.instance).
Check (Section_3_4_proofs.sec_3_4_J0.proved : Section_3_4.sec_3_4_J0.statement).
Check (Section_3_4_proofs.sec_3_4_J0.met : Section_3_4.sec_3_4_J0.instance).
Check (Section_3_4_proofs.sec_3_4_dual.proved : Section_3_4.sec_3_4_dual.statement).
Check (Section_3_4_proofs.sec_3_4_dual.met : Section_3_4.sec_3_4_dual.instance).
Check (Section_3_4_proofs.sec_3_4_J1.proved : Section_3_4.sec_3_4_J1.statement).
Check (Section_3_4_proofs.sec_3_4_J1.met : Section_3_4.sec_3_4_J1.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r1.proved : Section_3_4.sec_3_4_m0_r1.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r1.met : Section_3_4.sec_3_4_m0_r1.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r2.proved : Section_3_4.sec_3_4_m0_r2.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r2.met : Section_3_4.sec_3_4_m0_r2.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c1.proved : Section_3_4.sec_3_4_m0_r3_c1.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c1.met : Section_3_4.sec_3_4_m0_r3_c1.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c2.refuted : ~ Section_3_4.sec_3_4_m0_r3_c2.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.proved : Section_3_4.sec_3_4_m0_r3_c2_corrected.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.met : Section_3_4.sec_3_4_m0_r3_c2_corrected.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r3_true.proved : Section_3_4.sec_3_4_m0_r3_true.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_true.met : Section_3_4.sec_3_4_m0_r3_true.instance).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c3.refuted : ~ Section_3_4.sec_3_4_m0_r3_c3.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.proved : Section_3_4.sec_3_4_m0_r3_c3_corrected.statement).
Check (Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.met : Section_3_4.sec_3_4_m0_r3_c3_corrected.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r1.proved : Section_3_4.sec_3_4_m1_r1.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r1.met : Section_3_4.sec_3_4_m1_r1.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r2.proved : Section_3_4.sec_3_4_m1_r2.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r2.met : Section_3_4.sec_3_4_m1_r2.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c1.proved : Section_3_4.sec_3_4_m1_r3_c1.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c1.met : Section_3_4.sec_3_4_m1_r3_c1.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c2.refuted : ~ Section_3_4.sec_3_4_m1_r3_c2.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.proved : Section_3_4.sec_3_4_m1_r3_c2_corrected.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.met : Section_3_4.sec_3_4_m1_r3_c2_corrected.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r3_true.proved : Section_3_4.sec_3_4_m1_r3_true.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r3_true.met : Section_3_4.sec_3_4_m1_r3_true.instance).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c3.proved : Section_3_4.sec_3_4_m1_r3_c3.statement).
Check (Section_3_4_proofs.sec_3_4_m1_r3_c3.met : Section_3_4.sec_3_4_m1_r3_c3.instance).
Check (Section_3_4_proofs.sec_3_4_S0.proved : Section_3_4.sec_3_4_S0.statement).
Check (Section_3_4_proofs.sec_3_4_S0.met : Section_3_4.sec_3_4_S0.instance).
Check (Section_3_4_proofs.sec_3_4_S0_gen.proved : Section_3_4.sec_3_4_S0_gen.statement).
Check (Section_3_4_proofs.sec_3_4_S0_gen.met : Section_3_4.sec_3_4_S0_gen.instance).
Check (Section_3_4_proofs.sec_3_4_S1.proved : Section_3_4.sec_3_4_S1.statement).
Check (Section_3_4_proofs.sec_3_4_S1.met : Section_3_4.sec_3_4_S1.instance).
Check (Section_3_4_proofs.sec_3_4_S1_gen.proved : Section_3_4.sec_3_4_S1_gen.statement).
Check (Section_3_4_proofs.sec_3_4_S1_gen.met : Section_3_4.sec_3_4_S1_gen.instance).
Check (Section_4_1_printed_proofs.ex_4_1_Q0.proved : Section_4_1_printed.ex_4_1_Q0.statement).
Check (Section_4_1_printed_proofs.ex_4_1_Q0.met : Section_4_1_printed.ex_4_1_Q0.instance).
Check (Section_4_1_printed_proofs.ex_4_1_Q1.proved : Section_4_1_printed.ex_4_1_Q1.statement).
Check (Section_4_1_printed_proofs.ex_4_1_Q1.met : Section_4_1_printed.ex_4_1_Q1.instance).
Check (Section_4_1_printed_proofs.ex_4_1_Q2.proved : Section_4_1_printed.ex_4_1_Q2.statement).
Check (Section_4_1_printed_proofs.ex_4_1_Q2.met : Section_4_1_printed.ex_4_1_Q2.instance).
Check (Section_4_1_printed_proofs.ex_4_1_Q3.proved : Section_4_1_printed.ex_4_1_Q3.statement).
Check (Section_4_1_printed_proofs.ex_4_1_Q3.met : Section_4_1_printed.ex_4_1_Q3.instance).
Check (Section_4_1_printed_proofs.ex_4_1_distance.proved : Section_4_1_printed.ex_4_1_distance.statement).
Check (Section_4_1_printed_proofs.ex_4_1_distance.met : Section_4_1_printed.ex_4_1_distance.instance).
Check (Section_4_1_printed_proofs.ex_4_1_coplanar.proved : Section_4_1_printed.ex_4_1_coplanar.statement).
Check (Section_4_1_printed_proofs.ex_4_1_coplanar.met : Section_4_1_printed.ex_4_1_coplanar.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c1_a.proved : Section_4_1_printed.ex_4_1_c1_a.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c1_a.met : Section_4_1_printed.ex_4_1_c1_a.instance).
Check (Section_4_1_printed_proofs.ex_4_1_lengths.proved : Section_4_1_printed.ex_4_1_lengths.statement).
Check (Section_4_1_printed_proofs.ex_4_1_lengths.met : Section_4_1_printed.ex_4_1_lengths.instance).
Check (Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.proved : Section_4_1_printed.ex_4_1_lengths_exchanged.statement).
Check (Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.met : Section_4_1_printed.ex_4_1_lengths_exchanged.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c1_b.proved : Section_4_1_printed.ex_4_1_c1_b.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c1_b.met : Section_4_1_printed.ex_4_1_c1_b.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c1_c.refuted : ~ Section_4_1_printed.ex_4_1_c1_c.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c1_d.refuted : ~ Section_4_1_printed.ex_4_1_c1_d.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c1_e.refuted : ~ Section_4_1_printed.ex_4_1_c1_e.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted : ~ Section_4_1_printed.ex_4_1_c1_f_there_and_nowhere_else.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c2_a.proved : Section_4_1_printed.ex_4_1_c2_a.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c2_a.met : Section_4_1_printed.ex_4_1_c2_a.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c2_b.proved : Section_4_1_printed.ex_4_1_c2_b.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c2_b.met : Section_4_1_printed.ex_4_1_c2_b.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c2_c.refuted : ~ Section_4_1_printed.ex_4_1_c2_c.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c2_d.refuted : ~ Section_4_1_printed.ex_4_1_c2_d.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted : ~ Section_4_1_printed.ex_4_1_c2_e_there_and_nowhere_else.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c3_a.refuted : ~ Section_4_1_printed.ex_4_1_c3_a.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c3_b.proved : Section_4_1_printed.ex_4_1_c3_b.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c3_b.met : Section_4_1_printed.ex_4_1_c3_b.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c3_c.proved : Section_4_1_printed.ex_4_1_c3_c.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c3_c.met : Section_4_1_printed.ex_4_1_c3_c.instance).
Check (Section_4_1_printed_proofs.ex_4_1_c3_d.proved : Section_4_1_printed.ex_4_1_c3_d.statement).
Check (Section_4_1_printed_proofs.ex_4_1_c3_d.met : Section_4_1_printed.ex_4_1_c3_d.instance).
Check (Section_4_1_printed_proofs.ex_4_2_Q0.proved : Section_4_1_printed.ex_4_2_Q0.statement).
Check (Section_4_1_printed_proofs.ex_4_2_Q0.met : Section_4_1_printed.ex_4_2_Q0.instance).
Check (Section_4_1_printed_proofs.ex_4_2_Q1.proved : Section_4_1_printed.ex_4_2_Q1.statement).
Check (Section_4_1_printed_proofs.ex_4_2_Q1.met : Section_4_1_printed.ex_4_2_Q1.instance).
Check (Section_4_1_printed_proofs.ex_4_2_Q2.proved : Section_4_1_printed.ex_4_2_Q2.statement).
Check (Section_4_1_printed_proofs.ex_4_2_Q2.met : Section_4_1_printed.ex_4_2_Q2.instance).
Check (Section_4_1_printed_proofs.ex_4_2_Q3.proved : Section_4_1_printed.ex_4_2_Q3.statement).
Check (Section_4_1_printed_proofs.ex_4_2_Q3.met : Section_4_1_printed.ex_4_2_Q3.instance).
Check (Section_4_1_printed_proofs.ex_4_2_class.refuted : ~ Section_4_1_printed.ex_4_2_class.statement).
Check (Section_4_1_printed_proofs.ex_4_2_pencil.proved : Section_4_1_printed.ex_4_2_pencil.statement).
Check (Section_4_1_printed_proofs.ex_4_2_pencil.met : Section_4_1_printed.ex_4_2_pencil.instance).
Check (Section_4_1_printed_proofs.ex_4_2_lengths.proved : Section_4_1_printed.ex_4_2_lengths.statement).
Check (Section_4_1_printed_proofs.ex_4_2_lengths.met : Section_4_1_printed.ex_4_2_lengths.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c1_a.refuted : ~ Section_4_1_printed.ex_4_2_c1_a.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c1_b.proved : Section_4_1_printed.ex_4_2_c1_b.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c1_b.met : Section_4_1_printed.ex_4_2_c1_b.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c1_c.proved : Section_4_1_printed.ex_4_2_c1_c.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c1_c.met : Section_4_1_printed.ex_4_2_c1_c.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c1_d.refuted : ~ Section_4_1_printed.ex_4_2_c1_d.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c1_e.refuted : ~ Section_4_1_printed.ex_4_2_c1_e.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c2_a.refuted : ~ Section_4_1_printed.ex_4_2_c2_a.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c2_b.proved : Section_4_1_printed.ex_4_2_c2_b.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c2_b.met : Section_4_1_printed.ex_4_2_c2_b.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c2_c.proved : Section_4_1_printed.ex_4_2_c2_c.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c2_c.met : Section_4_1_printed.ex_4_2_c2_c.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c2_d.proved : Section_4_1_printed.ex_4_2_c2_d.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c2_d.met : Section_4_1_printed.ex_4_2_c2_d.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c3_a.proved : Section_4_1_printed.ex_4_2_c3_a.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c3_a.met : Section_4_1_printed.ex_4_2_c3_a.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c3_b.proved : Section_4_1_printed.ex_4_2_c3_b.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c3_b.met : Section_4_1_printed.ex_4_2_c3_b.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c3_c.proved : Section_4_1_printed.ex_4_2_c3_c.statement).
Check (Section_4_1_printed_proofs.ex_4_2_c3_c.met : Section_4_1_printed.ex_4_2_c3_c.instance).
Check (Section_4_1_printed_proofs.ex_4_2_c3_d.refuted : ~ Section_4_1_printed.ex_4_2_c3_d.statement).
Check (Section_4_1_proofs.ex_4_1_Q0.proved : Section_4_1.ex_4_1_Q0.statement).
Check (Section_4_1_proofs.ex_4_1_Q0.met : Section_4_1.ex_4_1_Q0.instance).
Check (Section_4_1_proofs.ex_4_1_Q1.proved : Section_4_1.ex_4_1_Q1.statement).
Check (Section_4_1_proofs.ex_4_1_Q1.met : Section_4_1.ex_4_1_Q1.instance).
Check (Section_4_1_proofs.ex_4_1_Q2.proved : Section_4_1.ex_4_1_Q2.statement).
Check (Section_4_1_proofs.ex_4_1_Q2.met : Section_4_1.ex_4_1_Q2.instance).
Check (Section_4_1_proofs.ex_4_1_Q3.proved : Section_4_1.ex_4_1_Q3.statement).
Check (Section_4_1_proofs.ex_4_1_Q3.met : Section_4_1.ex_4_1_Q3.instance).
Check (Section_4_1_proofs.ex_4_1_distance.proved : Section_4_1.ex_4_1_distance.statement).
Check (Section_4_1_proofs.ex_4_1_distance.met : Section_4_1.ex_4_1_distance.instance).
Check (Section_4_1_proofs.ex_4_1_coplanar.proved : Section_4_1.ex_4_1_coplanar.statement).
Check (Section_4_1_proofs.ex_4_1_coplanar.met : Section_4_1.ex_4_1_coplanar.instance).
Check (Section_4_1_proofs.ex_4_1_c1_a.proved : Section_4_1.ex_4_1_c1_a.statement).
Check (Section_4_1_proofs.ex_4_1_c1_a.met : Section_4_1.ex_4_1_c1_a.instance).
Check (Section_4_1_proofs.ex_4_1_lengths.proved : Section_4_1.ex_4_1_lengths.statement).
Check (Section_4_1_proofs.ex_4_1_lengths.met : Section_4_1.ex_4_1_lengths.instance).
Check (Section_4_1_proofs.ex_4_1_lengths_exchanged.proved : Section_4_1.ex_4_1_lengths_exchanged.statement).
Check (Section_4_1_proofs.ex_4_1_lengths_exchanged.met : Section_4_1.ex_4_1_lengths_exchanged.instance).
Check (Section_4_1_proofs.ex_4_1_c1_b.proved : Section_4_1.ex_4_1_c1_b.statement).
Check (Section_4_1_proofs.ex_4_1_c1_b.met : Section_4_1.ex_4_1_c1_b.instance).
Check (Section_4_1_proofs.ex_4_1_c1_c.refuted : ~ Section_4_1.ex_4_1_c1_c.statement).
Check (Section_4_1_proofs.ex_4_1_c1_d.refuted : ~ Section_4_1.ex_4_1_c1_d.statement).
Check (Section_4_1_proofs.ex_4_1_c1_e.refuted : ~ Section_4_1.ex_4_1_c1_e.statement).
Check (Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted : ~ Section_4_1.ex_4_1_c1_f_there_and_nowhere_else.statement).
Check (Section_4_1_proofs.ex_4_1_c2_a.proved : Section_4_1.ex_4_1_c2_a.statement).
Check (Section_4_1_proofs.ex_4_1_c2_a.met : Section_4_1.ex_4_1_c2_a.instance).
Check (Section_4_1_proofs.ex_4_1_c2_b.proved : Section_4_1.ex_4_1_c2_b.statement).
Check (Section_4_1_proofs.ex_4_1_c2_b.met : Section_4_1.ex_4_1_c2_b.instance).
Check (Section_4_1_proofs.ex_4_1_c2_c.refuted : ~ Section_4_1.ex_4_1_c2_c.statement).
Check (Section_4_1_proofs.ex_4_1_c2_d.refuted : ~ Section_4_1.ex_4_1_c2_d.statement).
Check (Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted : ~ Section_4_1.ex_4_1_c2_e_there_and_nowhere_else.statement).
Check (Section_4_1_proofs.ex_4_1_c3_a.refuted : ~ Section_4_1.ex_4_1_c3_a.statement).
Check (Section_4_1_proofs.ex_4_1_c3_b.proved : Section_4_1.ex_4_1_c3_b.statement).
Check (Section_4_1_proofs.ex_4_1_c3_b.met : Section_4_1.ex_4_1_c3_b.instance).
Check (Section_4_1_proofs.ex_4_1_c3_c.proved : Section_4_1.ex_4_1_c3_c.statement).
Check (Section_4_1_proofs.ex_4_1_c3_c.met : Section_4_1.ex_4_1_c3_c.instance).
Check (Section_4_1_proofs.ex_4_1_c3_d.proved : Section_4_1.ex_4_1_c3_d.statement).
Check (Section_4_1_proofs.ex_4_1_c3_d.met : Section_4_1.ex_4_1_c3_d.instance).
Check (Section_4_1_proofs.ex_4_2_Q0.proved : Section_4_1.ex_4_2_Q0.statement).
Check (Section_4_1_proofs.ex_4_2_Q0.met : Section_4_1.ex_4_2_Q0.instance).
Check (Section_4_1_proofs.ex_4_2_Q1.proved : Section_4_1.ex_4_2_Q1.statement).
Check (Section_4_1_proofs.ex_4_2_Q1.met : Section_4_1.ex_4_2_Q1.instance).
Check (Section_4_1_proofs.ex_4_2_Q2.proved : Section_4_1.ex_4_2_Q2.statement).
Check (Section_4_1_proofs.ex_4_2_Q2.met : Section_4_1.ex_4_2_Q2.instance).
Check (Section_4_1_proofs.ex_4_2_Q3.proved : Section_4_1.ex_4_2_Q3.statement).
Check (Section_4_1_proofs.ex_4_2_Q3.met : Section_4_1.ex_4_2_Q3.instance).
Check (Section_4_1_proofs.ex_4_2_class.refuted : ~ Section_4_1.ex_4_2_class.statement).
Check (Section_4_1_proofs.ex_4_2_pencil.proved : Section_4_1.ex_4_2_pencil.statement).
Check (Section_4_1_proofs.ex_4_2_pencil.met : Section_4_1.ex_4_2_pencil.instance).
Check (Section_4_1_proofs.ex_4_2_lengths.proved : Section_4_1.ex_4_2_lengths.statement).
Check (Section_4_1_proofs.ex_4_2_lengths.met : Section_4_1.ex_4_2_lengths.instance).
Check (Section_4_1_proofs.ex_4_2_c1_a.refuted : ~ Section_4_1.ex_4_2_c1_a.statement).
Check (Section_4_1_proofs.ex_4_2_c1_b.proved : Section_4_1.ex_4_2_c1_b.statement).
Check (Section_4_1_proofs.ex_4_2_c1_b.met : Section_4_1.ex_4_2_c1_b.instance).
Check (Section_4_1_proofs.ex_4_2_c1_c.proved : Section_4_1.ex_4_2_c1_c.statement).
Check (Section_4_1_proofs.ex_4_2_c1_c.met : Section_4_1.ex_4_2_c1_c.instance).
Check (Section_4_1_proofs.ex_4_2_c1_d.refuted : ~ Section_4_1.ex_4_2_c1_d.statement).
Check (Section_4_1_proofs.ex_4_2_c1_e.refuted : ~ Section_4_1.ex_4_2_c1_e.statement).
Check (Section_4_1_proofs.ex_4_2_c2_a.refuted : ~ Section_4_1.ex_4_2_c2_a.statement).
Check (Section_4_1_proofs.ex_4_2_c2_b.proved : Section_4_1.ex_4_2_c2_b.statement).
Check (Section_4_1_proofs.ex_4_2_c2_b.met : Section_4_1.ex_4_2_c2_b.instance).
Check (Section_4_1_proofs.ex_4_2_c2_c.proved : Section_4_1.ex_4_2_c2_c.statement).
Check (Section_4_1_proofs.ex_4_2_c2_c.met : Section_4_1.ex_4_2_c2_c.instance).
Check (Section_4_1_proofs.ex_4_2_c2_d.proved : Section_4_1.ex_4_2_c2_d.statement).
Check (Section_4_1_proofs.ex_4_2_c2_d.met : Section_4_1.ex_4_2_c2_d.instance).
Check (Section_4_1_proofs.ex_4_2_c3_a.proved : Section_4_1.ex_4_2_c3_a.statement).
Check (Section_4_1_proofs.ex_4_2_c3_a.met : Section_4_1.ex_4_2_c3_a.instance).
Check (Section_4_1_proofs.ex_4_2_c3_b.proved : Section_4_1.ex_4_2_c3_b.statement).
Check (Section_4_1_proofs.ex_4_2_c3_b.met : Section_4_1.ex_4_2_c3_b.instance).
Check (Section_4_1_proofs.ex_4_2_c3_c.proved : Section_4_1.ex_4_2_c3_c.statement).
Check (Section_4_1_proofs.ex_4_2_c3_c.met : Section_4_1.ex_4_2_c3_c.instance).
Check (Section_4_1_proofs.ex_4_2_c3_d.refuted : ~ Section_4_1.ex_4_2_c3_d.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q0.proved : Section_4_2_printed.sec_4_2_Q0.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q0.met : Section_4_2_printed.sec_4_2_Q0.instance).
Check (Section_4_2_printed_proofs.sec_4_2_Q1.proved : Section_4_2_printed.sec_4_2_Q1.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q1.met : Section_4_2_printed.sec_4_2_Q1.instance).
Check (Section_4_2_printed_proofs.sec_4_2_Q1_lengths.proved : Section_4_2_printed.sec_4_2_Q1_lengths.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q2.proved : Section_4_2_printed.sec_4_2_Q2.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q2.met : Section_4_2_printed.sec_4_2_Q2.instance).
Check (Section_4_2_printed_proofs.sec_4_2_Q3.proved : Section_4_2_printed.sec_4_2_Q3.statement).
Check (Section_4_2_printed_proofs.sec_4_2_Q3.met : Section_4_2_printed.sec_4_2_Q3.instance).
Check (Section_4_2_printed_proofs.sec_4_2_quadrants.proved : Section_4_2_printed.sec_4_2_quadrants.statement).
Check (Section_4_2_printed_proofs.sec_4_2_quadrants.met : Section_4_2_printed.sec_4_2_quadrants.instance).
Check (Section_4_2_printed_proofs.sec_4_2_distances.proved : Section_4_2_printed.sec_4_2_distances.statement).
Check (Section_4_2_printed_proofs.sec_4_2_distances.met : Section_4_2_printed.sec_4_2_distances.instance).
Check (Section_4_2_printed_proofs.sec_4_2_class.proved : Section_4_2_printed.sec_4_2_class.statement).
Check (Section_4_2_printed_proofs.sec_4_2_class.met : Section_4_2_printed.sec_4_2_class.instance).
Check (Section_4_2_printed_proofs.sec_4_2_class_ends.proved : Section_4_2_printed.sec_4_2_class_ends.statement).
Check (Section_4_2_printed_proofs.sec_4_2_class_ends.met : Section_4_2_printed.sec_4_2_class_ends.instance).
Check (Section_4_2_proofs.sec_4_2_Q0.proved : Section_4_2.sec_4_2_Q0.statement).
Check (Section_4_2_proofs.sec_4_2_Q0.met : Section_4_2.sec_4_2_Q0.instance).
Check (Section_4_2_proofs.sec_4_2_Q1.proved : Section_4_2.sec_4_2_Q1.statement).
Check (Section_4_2_proofs.sec_4_2_Q1.met : Section_4_2.sec_4_2_Q1.instance).
Check (Section_4_2_proofs.sec_4_2_Q1_lengths.proved : Section_4_2.sec_4_2_Q1_lengths.statement).
Check (Section_4_2_proofs.sec_4_2_Q2.proved : Section_4_2.sec_4_2_Q2.statement).
Check (Section_4_2_proofs.sec_4_2_Q2.met : Section_4_2.sec_4_2_Q2.instance).
Check (Section_4_2_proofs.sec_4_2_Q3.proved : Section_4_2.sec_4_2_Q3.statement).
Check (Section_4_2_proofs.sec_4_2_Q3.met : Section_4_2.sec_4_2_Q3.instance).
Check (Section_4_2_proofs.sec_4_2_quadrants.proved : Section_4_2.sec_4_2_quadrants.statement).
Check (Section_4_2_proofs.sec_4_2_quadrants.met : Section_4_2.sec_4_2_quadrants.instance).
Check (Section_4_2_proofs.sec_4_2_distances.proved : Section_4_2.sec_4_2_distances.statement).
Check (Section_4_2_proofs.sec_4_2_distances.met : Section_4_2.sec_4_2_distances.instance).
Check (Section_4_2_proofs.sec_4_2_class.proved : Section_4_2.sec_4_2_class.statement).
Check (Section_4_2_proofs.sec_4_2_class.met : Section_4_2.sec_4_2_class.instance).
Check (Section_4_2_proofs.sec_4_2_class_ends.proved : Section_4_2.sec_4_2_class_ends.statement).
Check (Section_4_2_proofs.sec_4_2_class_ends.met : Section_4_2.sec_4_2_class_ends.instance).
Check (Section_4_printed_proofs.sec_4_midpoints.proved : Section_4_printed.sec_4_midpoints.statement).
Check (Section_4_printed_proofs.sec_4_midpoints.met : Section_4_printed.sec_4_midpoints.instance).
Check (Section_4_printed_proofs.ex_4_2_distance.proved : Section_4_printed.ex_4_2_distance.statement).
Check (Section_4_printed_proofs.ex_4_2_distance.met : Section_4_printed.ex_4_2_distance.instance).
Check (Section_4_printed_proofs.ex_4_2_coplanar.proved : Section_4_printed.ex_4_2_coplanar.statement).
Check (Section_4_printed_proofs.ex_4_2_coplanar.met : Section_4_printed.ex_4_2_coplanar.instance).
Check (Section_4_proofs.sec_4_midpoints.proved : Section_4.sec_4_midpoints.statement).
Check (Section_4_proofs.sec_4_midpoints.met : Section_4.sec_4_midpoints.instance).
Check (Section_4_proofs.ex_4_2_distance.proved : Section_4.ex_4_2_distance.statement).
Check (Section_4_proofs.ex_4_2_distance.met : Section_4.ex_4_2_distance.instance).
Check (Section_4_proofs.ex_4_2_coplanar.proved : Section_4.ex_4_2_coplanar.statement).
Check (Section_4_proofs.ex_4_2_coplanar.met : Section_4.ex_4_2_coplanar.instance).
Check (Section_5_1_printed_proofs.eq_5_3_b.refuted : ~ Section_5_1_printed.eq_5_3_b.statement).
Check (Section_5_1_printed_proofs.eq_5_3_b_corrected.proved : Section_5_1_printed.eq_5_3_b_corrected.statement).
Check (Section_5_1_printed_proofs.eq_5_3_b_corrected.met : Section_5_1_printed.eq_5_3_b_corrected.instance).
Check (Section_5_1_printed_proofs.eq_5_4.proved : Section_5_1_printed.eq_5_4.statement).
Check (Section_5_1_printed_proofs.eq_5_4.met : Section_5_1_printed.eq_5_4.instance).
Check (Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved : Section_5_1_printed.eq_5_4_nec_suf_curves_of_four_coordinates.statement).
Check (Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met : Section_5_1_printed.eq_5_4_nec_suf_curves_of_four_coordinates.instance).
Check (Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_in_space.refuted : ~ Section_5_1_printed.eq_5_4_nec_suf_curves_in_space.statement).
Check (Section_5_1_printed_proofs.sec_5_1_certify.proved : Section_5_1_printed.sec_5_1_certify.statement).
Check (Section_5_1_printed_proofs.sec_5_1_certify.met : Section_5_1_printed.sec_5_1_certify.instance).
Check (Section_5_1_printed_proofs.sec_5_1_certify_sheets.proved : Section_5_1_printed.sec_5_1_certify_sheets.statement).
Check (Section_5_1_printed_proofs.sec_5_1_certify_sheets.met : Section_5_1_printed.sec_5_1_certify_sheets.instance).
Check (Section_5_1_printed_proofs.sec_5_1_certify_cusp.proved : Section_5_1_printed.sec_5_1_certify_cusp.statement).
Check (Section_5_1_printed_proofs.sec_5_1_certify_cusp.met : Section_5_1_printed.sec_5_1_certify_cusp.instance).
Check (Section_5_1_printed_proofs.thm_2_inflection.proved : Section_5_1_printed.thm_2_inflection.statement).
Check (Section_5_1_printed_proofs.thm_2_inflection.met : Section_5_1_printed.thm_2_inflection.instance).
Check (Section_5_1_printed_proofs.sec_5_1_G0_families.proved : Section_5_1_printed.sec_5_1_G0_families.statement).
Check (Section_5_1_printed_proofs.sec_5_1_G0_families.met : Section_5_1_printed.sec_5_1_G0_families.instance).
Check (Section_5_1_printed_proofs.sec_5_1_G0_surfaces.refuted : ~ Section_5_1_printed.sec_5_1_G0_surfaces.statement).
Check (Section_5_1_printed_proofs.thm_2_a.proved : Section_5_1_printed.thm_2_a.statement).
Check (Section_5_1_printed_proofs.thm_2_a.met : Section_5_1_printed.thm_2_a.instance).
Check (Section_5_1_printed_proofs.thm_2_b.proved : Section_5_1_printed.thm_2_b.statement).
Check (Section_5_1_printed_proofs.thm_2_b.met : Section_5_1_printed.thm_2_b.instance).
Check (Section_5_1_printed_proofs.eq_5_7_requirement.proved : Section_5_1_printed.eq_5_7_requirement.statement).
Check (Section_5_1_printed_proofs.eq_5_7_requirement.met : Section_5_1_printed.eq_5_7_requirement.instance).
Check (Section_5_1_printed_proofs.eq_5_7_equivalence.refuted : ~ Section_5_1_printed.eq_5_7_equivalence.statement).
Check (Section_5_1_printed_proofs.eq_5_8_a.proved : Section_5_1_printed.eq_5_8_a.statement).
Check (Section_5_1_printed_proofs.eq_5_8_a.met : Section_5_1_printed.eq_5_8_a.instance).
Check (Section_5_1_printed_proofs.eq_5_8_b.proved : Section_5_1_printed.eq_5_8_b.statement).
Check (Section_5_1_printed_proofs.eq_5_8_b.met : Section_5_1_printed.eq_5_8_b.instance).
Check (Section_5_1_printed_proofs.eq_5_9.proved : Section_5_1_printed.eq_5_9.statement).
Check (Section_5_1_printed_proofs.eq_5_9.met : Section_5_1_printed.eq_5_9.instance).
Check (Section_5_1_printed_proofs.eq_5_10.proved : Section_5_1_printed.eq_5_10.statement).
Check (Section_5_1_printed_proofs.eq_5_10.met : Section_5_1_printed.eq_5_10.instance).
Check (Section_5_1_printed_proofs.thm_2_sufficient.proved : Section_5_1_printed.thm_2_sufficient.statement).
Check (Section_5_1_printed_proofs.thm_2_sufficient.met : Section_5_1_printed.thm_2_sufficient.instance).
Check (Section_5_1_printed_proofs.thm_2_necessary_families.proved : Section_5_1_printed.thm_2_necessary_families.statement).
Check (Section_5_1_printed_proofs.thm_2_necessary_families.met : Section_5_1_printed.thm_2_necessary_families.instance).
Check (Section_5_1_printed_proofs.thm_2_necessary_surfaces.refuted : ~ Section_5_1_printed.thm_2_necessary_surfaces.statement).
Check (Section_5_1_printed_proofs.thm_2_true_necessary.proved : Section_5_1_printed.thm_2_true_necessary.statement).
Check (Section_5_1_printed_proofs.thm_2_true_necessary.met : Section_5_1_printed.thm_2_true_necessary.instance).
Check (Section_5_1_printed_proofs.thm_2_true_sufficient.proved : Section_5_1_printed.thm_2_true_sufficient.statement).
Check (Section_5_1_printed_proofs.thm_2_true_sufficient.met : Section_5_1_printed.thm_2_true_sufficient.instance).
Check (Section_5_1_printed_proofs.thm_2_true_generator.proved : Section_5_1_printed.thm_2_true_generator.statement).
Check (Section_5_1_printed_proofs.thm_2_true_generator.met : Section_5_1_printed.thm_2_true_generator.instance).
Check (Section_5_1_printed_proofs.thm_2_true_sheets.proved : Section_5_1_printed.thm_2_true_sheets.statement).
Check (Section_5_1_printed_proofs.thm_2_true_sheets.met : Section_5_1_printed.thm_2_true_sheets.instance).
Check (Section_5_1_printed_proofs.thm_2_proof_comprise_families.proved : Section_5_1_printed.thm_2_proof_comprise_families.statement).
Check (Section_5_1_printed_proofs.thm_2_proof_comprise_families.met : Section_5_1_printed.thm_2_proof_comprise_families.instance).
Check (Section_5_1_printed_proofs.thm_2_proof_comprise_surfaces.refuted : ~ Section_5_1_printed.thm_2_proof_comprise_surfaces.statement).
Check (Section_5_1_proofs.eq_5_3_b.refuted : ~ Section_5_1.eq_5_3_b.statement).
Check (Section_5_1_proofs.eq_5_3_b_corrected.proved : Section_5_1.eq_5_3_b_corrected.statement).
Check (Section_5_1_proofs.eq_5_3_b_corrected.met : Section_5_1.eq_5_3_b_corrected.instance).
Check (Section_5_1_proofs.eq_5_4.proved : Section_5_1.eq_5_4.statement).
Check (Section_5_1_proofs.eq_5_4.met : Section_5_1.eq_5_4.instance).
Check (Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved : Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.statement).
Check (Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met : Section_5_1.eq_5_4_nec_suf_curves_of_four_coordinates.instance).
Check (Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted : ~ Section_5_1.eq_5_4_nec_suf_curves_in_space.statement).
Check (Section_5_1_proofs.sec_5_1_certify.proved : Section_5_1.sec_5_1_certify.statement).
Check (Section_5_1_proofs.sec_5_1_certify.met : Section_5_1.sec_5_1_certify.instance).
Check (Section_5_1_proofs.sec_5_1_certify_sheets.proved : Section_5_1.sec_5_1_certify_sheets.statement).
Check (Section_5_1_proofs.sec_5_1_certify_sheets.met : Section_5_1.sec_5_1_certify_sheets.instance).
Check (Section_5_1_proofs.sec_5_1_certify_cusp.proved : Section_5_1.sec_5_1_certify_cusp.statement).
Check (Section_5_1_proofs.sec_5_1_certify_cusp.met : Section_5_1.sec_5_1_certify_cusp.instance).
Check (Section_5_1_proofs.thm_2_inflection.proved : Section_5_1.thm_2_inflection.statement).
Check (Section_5_1_proofs.thm_2_inflection.met : Section_5_1.thm_2_inflection.instance).
Check (Section_5_1_proofs.sec_5_1_G0_families.proved : Section_5_1.sec_5_1_G0_families.statement).
Check (Section_5_1_proofs.sec_5_1_G0_families.met : Section_5_1.sec_5_1_G0_families.instance).
Check (Section_5_1_proofs.sec_5_1_G0_surfaces.refuted : ~ Section_5_1.sec_5_1_G0_surfaces.statement).
Check (Section_5_1_proofs.thm_2_a.proved : Section_5_1.thm_2_a.statement).
Check (Section_5_1_proofs.thm_2_a.met : Section_5_1.thm_2_a.instance).
Check (Section_5_1_proofs.thm_2_b.proved : Section_5_1.thm_2_b.statement).
Check (Section_5_1_proofs.thm_2_b.met : Section_5_1.thm_2_b.instance).
Check (Section_5_1_proofs.eq_5_7_requirement.proved : Section_5_1.eq_5_7_requirement.statement).
Check (Section_5_1_proofs.eq_5_7_requirement.met : Section_5_1.eq_5_7_requirement.instance).
Check (Section_5_1_proofs.eq_5_7_equivalence.refuted : ~ Section_5_1.eq_5_7_equivalence.statement).
Check (Section_5_1_proofs.eq_5_8_a.proved : Section_5_1.eq_5_8_a.statement).
Check (Section_5_1_proofs.eq_5_8_a.met : Section_5_1.eq_5_8_a.instance).
Check (Section_5_1_proofs.eq_5_8_b.proved : Section_5_1.eq_5_8_b.statement).
Check (Section_5_1_proofs.eq_5_8_b.met : Section_5_1.eq_5_8_b.instance).
Check (Section_5_1_proofs.eq_5_9.proved : Section_5_1.eq_5_9.statement).
Check (Section_5_1_proofs.eq_5_9.met : Section_5_1.eq_5_9.instance).
Check (Section_5_1_proofs.eq_5_10.proved : Section_5_1.eq_5_10.statement).
Check (Section_5_1_proofs.eq_5_10.met : Section_5_1.eq_5_10.instance).
Check (Section_5_1_proofs.thm_2_sufficient.proved : Section_5_1.thm_2_sufficient.statement).
Check (Section_5_1_proofs.thm_2_sufficient.met : Section_5_1.thm_2_sufficient.instance).
Check (Section_5_1_proofs.thm_2_necessary_families.proved : Section_5_1.thm_2_necessary_families.statement).
Check (Section_5_1_proofs.thm_2_necessary_families.met : Section_5_1.thm_2_necessary_families.instance).
Check (Section_5_1_proofs.thm_2_necessary_surfaces.refuted : ~ Section_5_1.thm_2_necessary_surfaces.statement).
Check (Section_5_1_proofs.thm_2_true_necessary.proved : Section_5_1.thm_2_true_necessary.statement).
Check (Section_5_1_proofs.thm_2_true_necessary.met : Section_5_1.thm_2_true_necessary.instance).
Check (Section_5_1_proofs.thm_2_true_sufficient.proved : Section_5_1.thm_2_true_sufficient.statement).
Check (Section_5_1_proofs.thm_2_true_sufficient.met : Section_5_1.thm_2_true_sufficient.instance).
Check (Section_5_1_proofs.thm_2_true_generator.proved : Section_5_1.thm_2_true_generator.statement).
Check (Section_5_1_proofs.thm_2_true_generator.met : Section_5_1.thm_2_true_generator.instance).
Check (Section_5_1_proofs.thm_2_true_sheets.proved : Section_5_1.thm_2_true_sheets.statement).
Check (Section_5_1_proofs.thm_2_true_sheets.met : Section_5_1.thm_2_true_sheets.instance).
Check (Section_5_1_proofs.thm_2_proof_comprise_families.proved : Section_5_1.thm_2_proof_comprise_families.statement).
Check (Section_5_1_proofs.thm_2_proof_comprise_families.met : Section_5_1.thm_2_proof_comprise_families.instance).
Check (Section_5_1_proofs.thm_2_proof_comprise_surfaces.refuted : ~ Section_5_1.thm_2_proof_comprise_surfaces.statement).
Check (Section_5_2_printed_proofs.eq_5_11.proved : Section_5_2_printed.eq_5_11.statement).
Check (Section_5_2_printed_proofs.eq_5_11.met : Section_5_2_printed.eq_5_11.instance).
Check (Section_5_2_printed_proofs.sec_5_2_meaning.proved : Section_5_2_printed.sec_5_2_meaning.statement).
Check (Section_5_2_printed_proofs.sec_5_2_meaning.met : Section_5_2_printed.sec_5_2_meaning.instance).
Check (Section_5_2_printed_proofs.sec_5_2_ref.refuted : ~ Section_5_2_printed.sec_5_2_ref.statement).
Check (Section_5_2_printed_proofs.sec_5_2_ref_true.proved : Section_5_2_printed.sec_5_2_ref_true.statement).
Check (Section_5_2_printed_proofs.sec_5_2_ref_true.met : Section_5_2_printed.sec_5_2_ref_true.instance).
Check (Section_5_2_printed_proofs.sec_5_2_index.refuted : ~ Section_5_2_printed.sec_5_2_index.statement).
Check (Section_5_2_printed_proofs.thm_3_consts.proved : Section_5_2_printed.thm_3_consts.statement).
Check (Section_5_2_printed_proofs.thm_3_consts.met : Section_5_2_printed.thm_3_consts.instance).
Check (Section_5_2_printed_proofs.thm_3_a.proved : Section_5_2_printed.thm_3_a.statement).
Check (Section_5_2_printed_proofs.thm_3_a.met : Section_5_2_printed.thm_3_a.instance).
Check (Section_5_2_printed_proofs.thm_3_b.proved : Section_5_2_printed.thm_3_b.statement).
Check (Section_5_2_printed_proofs.thm_3_b.met : Section_5_2_printed.thm_3_b.instance).
Check (Section_5_2_printed_proofs.thm_3_c.proved : Section_5_2_printed.thm_3_c.statement).
Check (Section_5_2_printed_proofs.thm_3_c.met : Section_5_2_printed.thm_3_c.instance).
Check (Section_5_2_printed_proofs.thm_3_sufficient.proved : Section_5_2_printed.thm_3_sufficient.statement).
Check (Section_5_2_printed_proofs.thm_3_sufficient.met : Section_5_2_printed.thm_3_sufficient.instance).
Check (Section_5_2_printed_proofs.thm_3_necessary_families.proved : Section_5_2_printed.thm_3_necessary_families.statement).
Check (Section_5_2_printed_proofs.thm_3_necessary_families.met : Section_5_2_printed.thm_3_necessary_families.instance).
Check (Section_5_2_printed_proofs.thm_3_necessary_surfaces.refuted : ~ Section_5_2_printed.thm_3_necessary_surfaces.statement).
Check (Section_5_2_printed_proofs.eq_5_13.proved : Section_5_2_printed.eq_5_13.statement).
Check (Section_5_2_printed_proofs.eq_5_13.met : Section_5_2_printed.eq_5_13.instance).
Check (Section_5_2_printed_proofs.eq_5_15.proved : Section_5_2_printed.eq_5_15.statement).
Check (Section_5_2_printed_proofs.eq_5_15.met : Section_5_2_printed.eq_5_15.instance).
Check (Section_5_2_printed_proofs.thm_3_proofref.refuted : ~ Section_5_2_printed.thm_3_proofref.statement).
Check (Section_5_2_printed_proofs.thm_3_proofref_true.proved : Section_5_2_printed.thm_3_proofref_true.statement).
Check (Section_5_2_printed_proofs.thm_3_proofref_true.met : Section_5_2_printed.thm_3_proofref_true.instance).
Check (Section_5_2_printed_proofs.sec_5_2_must_families.proved : Section_5_2_printed.sec_5_2_must_families.statement).
Check (Section_5_2_printed_proofs.sec_5_2_must_families.met : Section_5_2_printed.sec_5_2_must_families.instance).
Check (Section_5_2_printed_proofs.sec_5_2_must_surfaces.refuted : ~ Section_5_2_printed.sec_5_2_must_surfaces.statement).
Check (Section_5_2_printed_proofs.thm_3_proof_implies_families.proved : Section_5_2_printed.thm_3_proof_implies_families.statement).
Check (Section_5_2_printed_proofs.thm_3_proof_implies_families.met : Section_5_2_printed.thm_3_proof_implies_families.instance).
Check (Section_5_2_printed_proofs.thm_3_proof_implies_surfaces.refuted : ~ Section_5_2_printed.thm_3_proof_implies_surfaces.statement).
Check (Section_5_2_proofs.eq_5_11.proved : Section_5_2.eq_5_11.statement).
Check (Section_5_2_proofs.eq_5_11.met : Section_5_2.eq_5_11.instance).
Check (Section_5_2_proofs.sec_5_2_meaning.proved : Section_5_2.sec_5_2_meaning.statement).
Check (Section_5_2_proofs.sec_5_2_meaning.met : Section_5_2.sec_5_2_meaning.instance).
Check (Section_5_2_proofs.sec_5_2_ref.refuted : ~ Section_5_2.sec_5_2_ref.statement).
Check (Section_5_2_proofs.sec_5_2_ref_true.proved : Section_5_2.sec_5_2_ref_true.statement).
Check (Section_5_2_proofs.sec_5_2_ref_true.met : Section_5_2.sec_5_2_ref_true.instance).
Check (Section_5_2_proofs.sec_5_2_index.refuted : ~ Section_5_2.sec_5_2_index.statement).
Check (Section_5_2_proofs.thm_3_consts.proved : Section_5_2.thm_3_consts.statement).
Check (Section_5_2_proofs.thm_3_consts.met : Section_5_2.thm_3_consts.instance).
Check (Section_5_2_proofs.thm_3_a.proved : Section_5_2.thm_3_a.statement).
Check (Section_5_2_proofs.thm_3_a.met : Section_5_2.thm_3_a.instance).
Check (Section_5_2_proofs.thm_3_b.proved : Section_5_2.thm_3_b.statement).
Check (Section_5_2_proofs.thm_3_b.met : Section_5_2.thm_3_b.instance).
Check (Section_5_2_proofs.thm_3_c.proved : Section_5_2.thm_3_c.statement).
Check (Section_5_2_proofs.thm_3_c.met : Section_5_2.thm_3_c.instance).
Check (Section_5_2_proofs.thm_3_sufficient.proved : Section_5_2.thm_3_sufficient.statement).
Check (Section_5_2_proofs.thm_3_sufficient.met : Section_5_2.thm_3_sufficient.instance).
Check (Section_5_2_proofs.thm_3_necessary_families.proved : Section_5_2.thm_3_necessary_families.statement).
Check (Section_5_2_proofs.thm_3_necessary_families.met : Section_5_2.thm_3_necessary_families.instance).
Check (Section_5_2_proofs.thm_3_necessary_surfaces.refuted : ~ Section_5_2.thm_3_necessary_surfaces.statement).
Check (Section_5_2_proofs.eq_5_13.proved : Section_5_2.eq_5_13.statement).
Check (Section_5_2_proofs.eq_5_13.met : Section_5_2.eq_5_13.instance).
Check (Section_5_2_proofs.eq_5_15.proved : Section_5_2.eq_5_15.statement).
Check (Section_5_2_proofs.eq_5_15.met : Section_5_2.eq_5_15.instance).
Check (Section_5_2_proofs.thm_3_proofref.refuted : ~ Section_5_2.thm_3_proofref.statement).
Check (Section_5_2_proofs.thm_3_proofref_true.proved : Section_5_2.thm_3_proofref_true.statement).
Check (Section_5_2_proofs.thm_3_proofref_true.met : Section_5_2.thm_3_proofref_true.instance).
Check (Section_5_2_proofs.sec_5_2_must_families.proved : Section_5_2.sec_5_2_must_families.statement).
Check (Section_5_2_proofs.sec_5_2_must_families.met : Section_5_2.sec_5_2_must_families.instance).
Check (Section_5_2_proofs.sec_5_2_must_surfaces.refuted : ~ Section_5_2.sec_5_2_must_surfaces.statement).
Check (Section_5_2_proofs.thm_3_proof_implies_families.proved : Section_5_2.thm_3_proof_implies_families.statement).
Check (Section_5_2_proofs.thm_3_proof_implies_families.met : Section_5_2.thm_3_proof_implies_families.instance).
Check (Section_5_2_proofs.thm_3_proof_implies_surfaces.refuted : ~ Section_5_2.thm_3_proof_implies_surfaces.statement).
Check (Section_5_3_printed_proofs.thm_4_consts.proved : Section_5_3_printed.thm_4_consts.statement).
Check (Section_5_3_printed_proofs.thm_4_consts.met : Section_5_3_printed.thm_4_consts.instance).
Check (Section_5_3_printed_proofs.thm_4_a.proved : Section_5_3_printed.thm_4_a.statement).
Check (Section_5_3_printed_proofs.thm_4_a.met : Section_5_3_printed.thm_4_a.instance).
Check (Section_5_3_printed_proofs.thm_4_b.proved : Section_5_3_printed.thm_4_b.statement).
Check (Section_5_3_printed_proofs.thm_4_b.met : Section_5_3_printed.thm_4_b.instance).
Check (Section_5_3_printed_proofs.thm_4_c.refuted : ~ Section_5_3_printed.thm_4_c.statement).
Check (Section_5_3_printed_proofs.thm_4_c_corrected.proved : Section_5_3_printed.thm_4_c_corrected.statement).
Check (Section_5_3_printed_proofs.thm_4_c_corrected.met : Section_5_3_printed.thm_4_c_corrected.instance).
Check (Section_5_3_printed_proofs.thm_4_c_true.proved : Section_5_3_printed.thm_4_c_true.statement).
Check (Section_5_3_printed_proofs.thm_4_c_true.met : Section_5_3_printed.thm_4_c_true.instance).
Check (Section_5_3_printed_proofs.eq_5_17.proved : Section_5_3_printed.eq_5_17.statement).
Check (Section_5_3_printed_proofs.eq_5_17.met : Section_5_3_printed.eq_5_17.instance).
Check (Section_5_3_printed_proofs.thm_4_sufficient.proved : Section_5_3_printed.thm_4_sufficient.statement).
Check (Section_5_3_printed_proofs.thm_4_sufficient.met : Section_5_3_printed.thm_4_sufficient.instance).
Check (Section_5_3_printed_proofs.thm_4_necessary_families.proved : Section_5_3_printed.thm_4_necessary_families.statement).
Check (Section_5_3_printed_proofs.thm_4_necessary_families.met : Section_5_3_printed.thm_4_necessary_families.instance).
Check (Section_5_3_printed_proofs.thm_4_necessary_surfaces.refuted : ~ Section_5_3_printed.thm_4_necessary_surfaces.statement).
Check (Section_5_3_printed_proofs.thm_4_true_necessary.proved : Section_5_3_printed.thm_4_true_necessary.statement).
Check (Section_5_3_printed_proofs.thm_4_true_necessary.met : Section_5_3_printed.thm_4_true_necessary.instance).
Check (Section_5_3_printed_proofs.thm_4_true_sufficient.proved : Section_5_3_printed.thm_4_true_sufficient.statement).
Check (Section_5_3_printed_proofs.thm_4_true_sufficient.met : Section_5_3_printed.thm_4_true_sufficient.instance).
Check (Section_5_3_printed_proofs.thm_4_true_sheets.proved : Section_5_3_printed.thm_4_true_sheets.statement).
Check (Section_5_3_printed_proofs.thm_4_true_sheets.met : Section_5_3_printed.thm_4_true_sheets.instance).
Check (Section_5_3_printed_proofs.thm_4_true_curvature.proved : Section_5_3_printed.thm_4_true_curvature.statement).
Check (Section_5_3_printed_proofs.thm_4_true_curvature.met : Section_5_3_printed.thm_4_true_curvature.instance).
Check (Section_5_3_printed_proofs.thm_4_proof_must_families.proved : Section_5_3_printed.thm_4_proof_must_families.statement).
Check (Section_5_3_printed_proofs.thm_4_proof_must_families.met : Section_5_3_printed.thm_4_proof_must_families.instance).
Check (Section_5_3_printed_proofs.thm_4_proof_must_surfaces.refuted : ~ Section_5_3_printed.thm_4_proof_must_surfaces.statement).
Check (Section_5_3_printed_proofs.thm_4_proof_establish_families.proved : Section_5_3_printed.thm_4_proof_establish_families.statement).
Check (Section_5_3_printed_proofs.thm_4_proof_establish_families.met : Section_5_3_printed.thm_4_proof_establish_families.instance).
Check (Section_5_3_printed_proofs.thm_4_proof_establish_surfaces.refuted : ~ Section_5_3_printed.thm_4_proof_establish_surfaces.statement).
Check (Section_5_3_proofs.thm_4_consts.proved : Section_5_3.thm_4_consts.statement).
Check (Section_5_3_proofs.thm_4_consts.met : Section_5_3.thm_4_consts.instance).
Check (Section_5_3_proofs.thm_4_a.proved : Section_5_3.thm_4_a.statement).
Check (Section_5_3_proofs.thm_4_a.met : Section_5_3.thm_4_a.instance).
Check (Section_5_3_proofs.thm_4_b.proved : Section_5_3.thm_4_b.statement).
Check (Section_5_3_proofs.thm_4_b.met : Section_5_3.thm_4_b.instance).
Check (Section_5_3_proofs.thm_4_c.refuted : ~ Section_5_3.thm_4_c.statement).
Check (Section_5_3_proofs.thm_4_c_corrected.proved : Section_5_3.thm_4_c_corrected.statement).
Check (Section_5_3_proofs.thm_4_c_corrected.met : Section_5_3.thm_4_c_corrected.instance).
Check (Section_5_3_proofs.thm_4_c_true.proved : Section_5_3.thm_4_c_true.statement).
Check (Section_5_3_proofs.thm_4_c_true.met : Section_5_3.thm_4_c_true.instance).
Check (Section_5_3_proofs.eq_5_17.proved : Section_5_3.eq_5_17.statement).
Check (Section_5_3_proofs.eq_5_17.met : Section_5_3.eq_5_17.instance).
Check (Section_5_3_proofs.thm_4_sufficient.proved : Section_5_3.thm_4_sufficient.statement).
Check (Section_5_3_proofs.thm_4_sufficient.met : Section_5_3.thm_4_sufficient.instance).
Check (Section_5_3_proofs.thm_4_necessary_families.proved : Section_5_3.thm_4_necessary_families.statement).
Check (Section_5_3_proofs.thm_4_necessary_families.met : Section_5_3.thm_4_necessary_families.instance).
Check (Section_5_3_proofs.thm_4_necessary_surfaces.refuted : ~ Section_5_3.thm_4_necessary_surfaces.statement).
Check (Section_5_3_proofs.thm_4_true_necessary.proved : Section_5_3.thm_4_true_necessary.statement).
Check (Section_5_3_proofs.thm_4_true_necessary.met : Section_5_3.thm_4_true_necessary.instance).
Check (Section_5_3_proofs.thm_4_true_sufficient.proved : Section_5_3.thm_4_true_sufficient.statement).
Check (Section_5_3_proofs.thm_4_true_sufficient.met : Section_5_3.thm_4_true_sufficient.instance).
Check (Section_5_3_proofs.thm_4_true_sheets.proved : Section_5_3.thm_4_true_sheets.statement).
Check (Section_5_3_proofs.thm_4_true_sheets.met : Section_5_3.thm_4_true_sheets.instance).
Check (Section_5_3_proofs.thm_4_true_curvature.proved : Section_5_3.thm_4_true_curvature.statement).
Check (Section_5_3_proofs.thm_4_true_curvature.met : Section_5_3.thm_4_true_curvature.instance).
Check (Section_5_3_proofs.thm_4_proof_must_families.proved : Section_5_3.thm_4_proof_must_families.statement).
Check (Section_5_3_proofs.thm_4_proof_must_families.met : Section_5_3.thm_4_proof_must_families.instance).
Check (Section_5_3_proofs.thm_4_proof_must_surfaces.refuted : ~ Section_5_3.thm_4_proof_must_surfaces.statement).
Check (Section_5_3_proofs.thm_4_proof_establish_families.proved : Section_5_3.thm_4_proof_establish_families.statement).
Check (Section_5_3_proofs.thm_4_proof_establish_families.met : Section_5_3.thm_4_proof_establish_families.instance).
Check (Section_5_3_proofs.thm_4_proof_establish_surfaces.refuted : ~ Section_5_3.thm_4_proof_establish_surfaces.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s1.proved : Section_5_4_printed.alg_5_4_s1.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s1.met : Section_5_4_printed.alg_5_4_s1.instance).
Check (Section_5_4_printed_proofs.alg_5_4_s2_families.proved : Section_5_4_printed.alg_5_4_s2_families.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s2_families.met : Section_5_4_printed.alg_5_4_s2_families.instance).
Check (Section_5_4_printed_proofs.alg_5_4_s2_surfaces.refuted : ~ Section_5_4_printed.alg_5_4_s2_surfaces.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s3.proved : Section_5_4_printed.alg_5_4_s3.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s3.met : Section_5_4_printed.alg_5_4_s3.instance).
Check (Section_5_4_printed_proofs.alg_5_4_s4.proved : Section_5_4_printed.alg_5_4_s4.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s4.met : Section_5_4_printed.alg_5_4_s4.instance).
Check (Section_5_4_printed_proofs.alg_5_4_s5.proved : Section_5_4_printed.alg_5_4_s5.statement).
Check (Section_5_4_printed_proofs.alg_5_4_s5.met : Section_5_4_printed.alg_5_4_s5.instance).
Check (Section_5_4_printed_proofs.alg_5_4_iterate.proved : Section_5_4_printed.alg_5_4_iterate.statement).
Check (Section_5_4_printed_proofs.alg_5_4_iterate.met : Section_5_4_printed.alg_5_4_iterate.instance).
Check (Section_5_4_proofs.alg_5_4_s1.proved : Section_5_4.alg_5_4_s1.statement).
Check (Section_5_4_proofs.alg_5_4_s1.met : Section_5_4.alg_5_4_s1.instance).
Check (Section_5_4_proofs.alg_5_4_s2_families.proved : Section_5_4.alg_5_4_s2_families.statement).
Check (Section_5_4_proofs.alg_5_4_s2_families.met : Section_5_4.alg_5_4_s2_families.instance).
Check (Section_5_4_proofs.alg_5_4_s2_surfaces.refuted : ~ Section_5_4.alg_5_4_s2_surfaces.statement).
Check (Section_5_4_proofs.alg_5_4_s3.proved : Section_5_4.alg_5_4_s3.statement).
Check (Section_5_4_proofs.alg_5_4_s3.met : Section_5_4.alg_5_4_s3.instance).
Check (Section_5_4_proofs.alg_5_4_s4.proved : Section_5_4.alg_5_4_s4.statement).
Check (Section_5_4_proofs.alg_5_4_s4.met : Section_5_4.alg_5_4_s4.instance).
Check (Section_5_4_proofs.alg_5_4_s5.proved : Section_5_4.alg_5_4_s5.statement).
Check (Section_5_4_proofs.alg_5_4_s5.met : Section_5_4.alg_5_4_s5.instance).
Check (Section_5_4_proofs.alg_5_4_iterate.proved : Section_5_4.alg_5_4_iterate.statement).
Check (Section_5_4_proofs.alg_5_4_iterate.met : Section_5_4.alg_5_4_iterate.instance).
Check (Section_5_5_printed_proofs.ex_5_1_construct.proved : Section_5_5_printed.ex_5_1_construct.statement).
Check (Section_5_5_printed_proofs.ex_5_1_construct.met : Section_5_5_printed.ex_5_1_construct.instance).
Check (Section_5_5_printed_proofs.ex_5_1_shape_shape.proved : Section_5_5_printed.ex_5_1_shape_shape.statement).
Check (Section_5_5_printed_proofs.ex_5_1_shape_shape.met : Section_5_5_printed.ex_5_1_shape_shape.instance).
Check (Section_5_5_printed_proofs.ex_5_1_shape_combined_surface.refuted : ~ Section_5_5_printed.ex_5_1_shape_combined_surface.statement).
Check (Section_5_5_printed_proofs.ex_5_2_Q02.proved : Section_5_5_printed.ex_5_2_Q02.statement).
Check (Section_5_5_printed_proofs.ex_5_2_Q02.met : Section_5_5_printed.ex_5_2_Q02.instance).
Check (Section_5_5_printed_proofs.ex_5_2_Q12.proved : Section_5_5_printed.ex_5_2_Q12.statement).
Check (Section_5_5_printed_proofs.ex_5_2_Q12.met : Section_5_5_printed.ex_5_2_Q12.instance).
Check (Section_5_5_printed_proofs.ex_5_2_Q22.proved : Section_5_5_printed.ex_5_2_Q22.statement).
Check (Section_5_5_printed_proofs.ex_5_2_Q22.met : Section_5_5_printed.ex_5_2_Q22.instance).
Check (Section_5_5_printed_proofs.ex_5_2_gamma_one.proved : Section_5_5_printed.ex_5_2_gamma_one.statement).
Check (Section_5_5_printed_proofs.ex_5_2_gamma_one.met : Section_5_5_printed.ex_5_2_gamma_one.instance).
Check (Section_5_5_printed_proofs.ex_5_2_gap_surfaces.refuted : ~ Section_5_5_printed.ex_5_2_gap_surfaces.statement).
Check (Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.proved : Section_5_5_printed.ex_5_2_gap_drawn_pieces.statement).
Check (Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.met : Section_5_5_printed.ex_5_2_gap_drawn_pieces.instance).
Check (Section_5_5_printed_proofs.ex_5_2_one_line.proved : Section_5_5_printed.ex_5_2_one_line.statement).
Check (Section_5_5_printed_proofs.ex_5_2_one_line.met : Section_5_5_printed.ex_5_2_one_line.instance).
Check (Section_5_5_proofs.ex_5_1_construct.proved : Section_5_5.ex_5_1_construct.statement).
Check (Section_5_5_proofs.ex_5_1_construct.met : Section_5_5.ex_5_1_construct.instance).
Check (Section_5_5_proofs.ex_5_1_shape_shape.proved : Section_5_5.ex_5_1_shape_shape.statement).
Check (Section_5_5_proofs.ex_5_1_shape_shape.met : Section_5_5.ex_5_1_shape_shape.instance).
Check (Section_5_5_proofs.ex_5_1_shape_combined_surface.refuted : ~ Section_5_5.ex_5_1_shape_combined_surface.statement).
Check (Section_5_5_proofs.ex_5_2_Q02.proved : Section_5_5.ex_5_2_Q02.statement).
Check (Section_5_5_proofs.ex_5_2_Q02.met : Section_5_5.ex_5_2_Q02.instance).
Check (Section_5_5_proofs.ex_5_2_Q12.proved : Section_5_5.ex_5_2_Q12.statement).
Check (Section_5_5_proofs.ex_5_2_Q12.met : Section_5_5.ex_5_2_Q12.instance).
Check (Section_5_5_proofs.ex_5_2_Q22.proved : Section_5_5.ex_5_2_Q22.statement).
Check (Section_5_5_proofs.ex_5_2_Q22.met : Section_5_5.ex_5_2_Q22.instance).
Check (Section_5_5_proofs.ex_5_2_gamma_one.proved : Section_5_5.ex_5_2_gamma_one.statement).
Check (Section_5_5_proofs.ex_5_2_gamma_one.met : Section_5_5.ex_5_2_gamma_one.instance).
Check (Section_5_5_proofs.ex_5_2_gap_surfaces.refuted : ~ Section_5_5.ex_5_2_gap_surfaces.statement).
Check (Section_5_5_proofs.ex_5_2_gap_drawn_pieces.proved : Section_5_5.ex_5_2_gap_drawn_pieces.statement).
Check (Section_5_5_proofs.ex_5_2_gap_drawn_pieces.met : Section_5_5.ex_5_2_gap_drawn_pieces.instance).
Check (Section_5_5_proofs.ex_5_2_one_line.proved : Section_5_5.ex_5_2_one_line.statement).
Check (Section_5_5_proofs.ex_5_2_one_line.met : Section_5_5.ex_5_2_one_line.instance).
Check (Section_5_printed_proofs.eq_5_1.proved : Section_5_printed.eq_5_1.statement).
Check (Section_5_printed_proofs.eq_5_1.met : Section_5_printed.eq_5_1.instance).
Check (Section_5_printed_proofs.sec_5_weighted_a.proved : Section_5_printed.sec_5_weighted_a.statement).
Check (Section_5_printed_proofs.sec_5_weighted_a.met : Section_5_printed.sec_5_weighted_a.instance).
Check (Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.proved : Section_5_printed.sec_5_weighted_b_four_coordinates.statement).
Check (Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.met : Section_5_printed.sec_5_weighted_b_four_coordinates.instance).
Check (Section_5_printed_proofs.sec_5_weighted_b_after_division.refuted : ~ Section_5_printed.sec_5_weighted_b_after_division.statement).
Check (Section_5_printed_proofs.eq_5_2.proved : Section_5_printed.eq_5_2.statement).
Check (Section_5_printed_proofs.eq_5_2.met : Section_5_printed.eq_5_2.instance).
Check (Section_5_proofs.eq_5_1.proved : Section_5.eq_5_1.statement).
Check (Section_5_proofs.eq_5_1.met : Section_5.eq_5_1.instance).
Check (Section_5_proofs.sec_5_weighted_a.proved : Section_5.sec_5_weighted_a.statement).
Check (Section_5_proofs.sec_5_weighted_a.met : Section_5.sec_5_weighted_a.instance).
Check (Section_5_proofs.sec_5_weighted_b_four_coordinates.proved : Section_5.sec_5_weighted_b_four_coordinates.statement).
Check (Section_5_proofs.sec_5_weighted_b_four_coordinates.met : Section_5.sec_5_weighted_b_four_coordinates.instance).
Check (Section_5_proofs.sec_5_weighted_b_after_division.refuted : ~ Section_5.sec_5_weighted_b_after_division.statement).
Check (Section_5_proofs.eq_5_2.proved : Section_5.eq_5_2.statement).
Check (Section_5_proofs.eq_5_2.met : Section_5.eq_5_2.instance).
Definition all_theorems : True :=
let _ := Part_Abstract_printed_proofs.abs_conics_planes.refuted in
let _ := Part_Abstract_printed_proofs.abs_conics_points.proved in
let _ := Part_Abstract_printed_proofs.abs_4d_factor.proved in
let _ := Part_Abstract_printed_proofs.abs_4d_factor.met in
let _ := Part_Abstract_proofs.abs_conics_planes.refuted in
let _ := Part_Abstract_proofs.abs_conics_points.proved in
let _ := Part_Abstract_proofs.abs_4d_factor.proved in
let _ := Part_Abstract_proofs.abs_4d_factor.met in
let _ := Section_1_printed_proofs.intro_gk_by_the_printed_conditions.refuted in
let _ := Section_1_printed_proofs.intro_gk_there_are_such_compositions.proved in
let _ := Section_1_printed_proofs.intro_gk_there_are_such_compositions.met in
let _ := Section_1_printed_proofs.intro_continuity_free_a.proved in
let _ := Section_1_printed_proofs.intro_continuity_free_a.met in
let _ := Section_1_printed_proofs.intro_continuity_free_b_any_values.refuted in
let _ := Section_1_printed_proofs.intro_continuity_free_c_any_values.refuted in
let _ := Section_1_printed_proofs.intro_contrib_1.proved in
let _ := Section_1_printed_proofs.intro_contrib_1.met in
let _ := Section_1_printed_proofs.intro_contrib_2.proved in
let _ := Section_1_printed_proofs.intro_contrib_2.met in
let _ := Section_1_printed_proofs.intro_contrib_4.proved in
let _ := Section_1_printed_proofs.intro_contrib_4.met in
let _ := Section_1_printed_proofs.intro_gauss.proved in
let _ := Section_1_printed_proofs.intro_gauss.met in
let _ := Section_1_proofs.intro_gk_by_the_printed_conditions.refuted in
let _ := Section_1_proofs.intro_gk_there_are_such_compositions.proved in
let _ := Section_1_proofs.intro_gk_there_are_such_compositions.met in
let _ := Section_1_proofs.intro_continuity_free_a.proved in
let _ := Section_1_proofs.intro_continuity_free_a.met in
let _ := Section_1_proofs.intro_continuity_free_b_any_values.refuted in
let _ := Section_1_proofs.intro_continuity_free_c_any_values.refuted in
let _ := Section_1_proofs.intro_contrib_1.proved in
let _ := Section_1_proofs.intro_contrib_1.met in
let _ := Section_1_proofs.intro_contrib_2.proved in
let _ := Section_1_proofs.intro_contrib_2.met in
let _ := Section_1_proofs.intro_contrib_4.proved in
let _ := Section_1_proofs.intro_contrib_4.met in
let _ := Section_1_proofs.intro_gauss.proved in
let _ := Section_1_proofs.intro_gauss.met in
let _ := Section_2_1_printed_proofs.def_1_g0.proved in
let _ := Section_2_1_printed_proofs.def_1_g0.met in
let _ := Section_2_1_printed_proofs.def_1_g1.proved in
let _ := Section_2_1_printed_proofs.def_1_g1.met in
let _ := Section_2_1_printed_proofs.def_1_g2.proved in
let _ := Section_2_1_printed_proofs.def_1_g2.met in
let _ := Section_2_1_printed_proofs.def_1_range.proved in
let _ := Section_2_1_printed_proofs.def_1_range.met in
let _ := Section_2_1_printed_proofs.eq_2_1.proved in
let _ := Section_2_1_printed_proofs.eq_2_1.met in
let _ := Section_2_1_printed_proofs.def_1_zero.proved in
let _ := Section_2_1_printed_proofs.def_1_zero.met in
let _ := Section_2_1_printed_proofs.thm_1_1_k2_functions.refuted in
let _ := Section_2_1_printed_proofs.thm_1_1_k2_substitution.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_k2_substitution.met in
let _ := Section_2_1_printed_proofs.thm_1_1_k3plus_functions.refuted in
let _ := Section_2_1_printed_proofs.thm_1_1_k3plus_substitution.refuted in
let _ := Section_2_1_printed_proofs.thm_1_1_k3plus_letters.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_k3plus_letters.met in
let _ := Section_2_1_printed_proofs.thm_1_1_degeneration.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_degeneration.met in
let _ := Section_2_1_printed_proofs.thm_1_1_degeneration_only.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_degeneration_only.met in
let _ := Section_2_1_printed_proofs.thm_1_1_no_degeneration.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_no_degeneration.met in
let _ := Section_2_1_printed_proofs.thm_1_1_jets.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_jets.met in
let _ := Section_2_1_printed_proofs.thm_1_2.proved in
let _ := Section_2_1_printed_proofs.thm_1_2.met in
let _ := Section_2_1_printed_proofs.thm_1_3.proved in
let _ := Section_2_1_printed_proofs.thm_1_3.met in
let _ := Section_2_1_printed_proofs.thm_1_4.proved in
let _ := Section_2_1_printed_proofs.thm_1_4.met in
let _ := Section_2_1_printed_proofs.thm_1_5.refuted in
let _ := Section_2_1_printed_proofs.thm_1_5_quadratic.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_quadratic.met in
let _ := Section_2_1_printed_proofs.thm_1_5_cubic.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_cubic.met in
let _ := Section_2_1_printed_proofs.thm_1_5_all.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_all.met in
let _ := Section_2_1_printed_proofs.thm_1_6_a.proved in
let _ := Section_2_1_printed_proofs.thm_1_6_a.met in
let _ := Section_2_1_printed_proofs.thm_1_6_b.proved in
let _ := Section_2_1_printed_proofs.thm_1_6_b.met in
let _ := Section_2_1_printed_proofs.thm_1_6_c.proved in
let _ := Section_2_1_printed_proofs.thm_1_6_c.met in
let _ := Section_2_1_printed_proofs.thm_1_6_d.proved in
let _ := Section_2_1_printed_proofs.thm_1_6_d.met in
let _ := Section_2_1_proofs.def_1_g0.proved in
let _ := Section_2_1_proofs.def_1_g0.met in
let _ := Section_2_1_proofs.def_1_g1.proved in
let _ := Section_2_1_proofs.def_1_g1.met in
let _ := Section_2_1_proofs.def_1_g2.proved in
let _ := Section_2_1_proofs.def_1_g2.met in
let _ := Section_2_1_proofs.def_1_range.proved in
let _ := Section_2_1_proofs.def_1_range.met in
let _ := Section_2_1_proofs.eq_2_1.proved in
let _ := Section_2_1_proofs.eq_2_1.met in
let _ := Section_2_1_proofs.def_1_zero.proved in
let _ := Section_2_1_proofs.def_1_zero.met in
let _ := Section_2_1_proofs.thm_1_1_k2_functions.refuted in
let _ := Section_2_1_proofs.thm_1_1_k2_substitution.proved in
let _ := Section_2_1_proofs.thm_1_1_k2_substitution.met in
let _ := Section_2_1_proofs.thm_1_1_k3plus_functions.refuted in
let _ := Section_2_1_proofs.thm_1_1_k3plus_substitution.refuted in
let _ := Section_2_1_proofs.thm_1_1_k3plus_letters.proved in
let _ := Section_2_1_proofs.thm_1_1_k3plus_letters.met in
let _ := Section_2_1_proofs.thm_1_1_degeneration.proved in
let _ := Section_2_1_proofs.thm_1_1_degeneration.met in
let _ := Section_2_1_proofs.thm_1_1_degeneration_only.proved in
let _ := Section_2_1_proofs.thm_1_1_degeneration_only.met in
let _ := Section_2_1_proofs.thm_1_1_no_degeneration.proved in
let _ := Section_2_1_proofs.thm_1_1_no_degeneration.met in
let _ := Section_2_1_proofs.thm_1_1_jets.proved in
let _ := Section_2_1_proofs.thm_1_1_jets.met in
let _ := Section_2_1_proofs.thm_1_2.proved in
let _ := Section_2_1_proofs.thm_1_2.met in
let _ := Section_2_1_proofs.thm_1_3.proved in
let _ := Section_2_1_proofs.thm_1_3.met in
let _ := Section_2_1_proofs.thm_1_4.proved in
let _ := Section_2_1_proofs.thm_1_4.met in
let _ := Section_2_1_proofs.thm_1_5.refuted in
let _ := Section_2_1_proofs.thm_1_5_quadratic.proved in
let _ := Section_2_1_proofs.thm_1_5_quadratic.met in
let _ := Section_2_1_proofs.thm_1_5_cubic.proved in
let _ := Section_2_1_proofs.thm_1_5_cubic.met in
let _ := Section_2_1_proofs.thm_1_5_all.proved in
let _ := Section_2_1_proofs.thm_1_5_all.met in
let _ := Section_2_1_proofs.thm_1_6_a.proved in
let _ := Section_2_1_proofs.thm_1_6_a.met in
let _ := Section_2_1_proofs.thm_1_6_b.proved in
let _ := Section_2_1_proofs.thm_1_6_b.met in
let _ := Section_2_1_proofs.thm_1_6_c.proved in
let _ := Section_2_1_proofs.thm_1_6_c.met in
let _ := Section_2_1_proofs.thm_1_6_d.proved in
let _ := Section_2_1_proofs.thm_1_6_d.met in
let _ := Section_2_2_printed_proofs.def_2_dim.refuted in
let _ := Section_2_2_printed_proofs.sec_2_2_endpoints.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_endpoints.met in
let _ := Section_2_2_printed_proofs.sec_2_2_convexity.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_convexity.met in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry.met in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.met in
let _ := Section_2_2_printed_proofs.sec_2_2_vd_quadratic.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_vd_quadratic.met in
let _ := Section_2_2_printed_proofs.sec_2_2_vd_operator.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_vd_operator.met in
let _ := Section_2_2_printed_proofs.sec_2_2_geominv.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_geominv.met in
let _ := Section_2_2_proofs.def_2_dim.refuted in
let _ := Section_2_2_proofs.sec_2_2_endpoints.proved in
let _ := Section_2_2_proofs.sec_2_2_endpoints.met in
let _ := Section_2_2_proofs.sec_2_2_convexity.proved in
let _ := Section_2_2_proofs.sec_2_2_convexity.met in
let _ := Section_2_2_proofs.sec_2_2_symmetry.proved in
let _ := Section_2_2_proofs.sec_2_2_symmetry.met in
let _ := Section_2_2_proofs.sec_2_2_symmetry_exchange.proved in
let _ := Section_2_2_proofs.sec_2_2_symmetry_exchange.met in
let _ := Section_2_2_proofs.sec_2_2_vd_quadratic.proved in
let _ := Section_2_2_proofs.sec_2_2_vd_quadratic.met in
let _ := Section_2_2_proofs.sec_2_2_vd_operator.proved in
let _ := Section_2_2_proofs.sec_2_2_vd_operator.met in
let _ := Section_2_2_proofs.sec_2_2_geominv.proved in
let _ := Section_2_2_proofs.sec_2_2_geominv.met in
let _ := Section_2_3_printed_proofs.sec_2_3_local_part_of_a_curve.refuted in
let _ := Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.met in
let _ := Section_2_3_printed_proofs.sec_2_3_linear.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_linear.met in
let _ := Section_2_3_printed_proofs.eq_2_3.refuted in
let _ := Section_2_3_printed_proofs.eq_2_3_corrected.proved in
let _ := Section_2_3_printed_proofs.eq_2_3_corrected.met in
let _ := Section_2_3_printed_proofs.eq_2_4.refuted in
let _ := Section_2_3_printed_proofs.eq_2_4_corrected.proved in
let _ := Section_2_3_printed_proofs.eq_2_4_corrected.met in
let _ := Section_2_3_printed_proofs.sec_2_3_indep_mu.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_indep_mu.met in
let _ := Section_2_3_printed_proofs.sec_2_3_indep_nu.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_indep_nu.met in
let _ := Section_2_3_printed_proofs.sec_2_3_move.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_move.met in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_mu.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_mu.met in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_mu_single.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_mu_single.met in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_nu.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_dir_nu.met in
let _ := Section_2_3_printed_proofs.sec_2_3_range.refuted in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_1.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_1.met in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_control_polygon.refuted in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.met in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_mean.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_concl_2_mean.met in
let _ := Section_2_3_proofs.sec_2_3_local_part_of_a_curve.refuted in
let _ := Section_2_3_proofs.sec_2_3_local_part_of_a_composite.proved in
let _ := Section_2_3_proofs.sec_2_3_local_part_of_a_composite.met in
let _ := Section_2_3_proofs.sec_2_3_linear.proved in
let _ := Section_2_3_proofs.sec_2_3_linear.met in
let _ := Section_2_3_proofs.eq_2_3.refuted in
let _ := Section_2_3_proofs.eq_2_3_corrected.proved in
let _ := Section_2_3_proofs.eq_2_3_corrected.met in
let _ := Section_2_3_proofs.eq_2_4.refuted in
let _ := Section_2_3_proofs.eq_2_4_corrected.proved in
let _ := Section_2_3_proofs.eq_2_4_corrected.met in
let _ := Section_2_3_proofs.sec_2_3_indep_mu.proved in
let _ := Section_2_3_proofs.sec_2_3_indep_mu.met in
let _ := Section_2_3_proofs.sec_2_3_indep_nu.proved in
let _ := Section_2_3_proofs.sec_2_3_indep_nu.met in
let _ := Section_2_3_proofs.sec_2_3_move.proved in
let _ := Section_2_3_proofs.sec_2_3_move.met in
let _ := Section_2_3_proofs.sec_2_3_dir_mu.proved in
let _ := Section_2_3_proofs.sec_2_3_dir_mu.met in
let _ := Section_2_3_proofs.sec_2_3_dir_mu_single.proved in
let _ := Section_2_3_proofs.sec_2_3_dir_mu_single.met in
let _ := Section_2_3_proofs.sec_2_3_dir_nu.proved in
let _ := Section_2_3_proofs.sec_2_3_dir_nu.met in
let _ := Section_2_3_proofs.sec_2_3_range.refuted in
let _ := Section_2_3_proofs.sec_2_3_concl_1.proved in
let _ := Section_2_3_proofs.sec_2_3_concl_1.met in
let _ := Section_2_3_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted in
let _ := Section_2_3_proofs.sec_2_3_concl_2_control_polygon.refuted in
let _ := Section_2_3_proofs.sec_2_3_concl_2_quadratic.proved in
let _ := Section_2_3_proofs.sec_2_3_concl_2_quadratic.met in
let _ := Section_2_3_proofs.sec_2_3_concl_2_mean.proved in
let _ := Section_2_3_proofs.sec_2_3_concl_2_mean.met in
let _ := Section_3_1_printed_proofs.sec_3_1_space.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_space.met in
let _ := Section_3_1_printed_proofs.eq_3_2.proved in
let _ := Section_3_1_printed_proofs.eq_3_2.met in
let _ := Section_3_1_printed_proofs.eq_3_3.proved in
let _ := Section_3_1_printed_proofs.eq_3_3.met in
let _ := Section_3_1_printed_proofs.eq_3_4.proved in
let _ := Section_3_1_printed_proofs.eq_3_4.met in
let _ := Section_3_1_printed_proofs.sec_3_1_ref.refuted in
let _ := Section_3_1_printed_proofs.sec_3_1_ref_true.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_ref_true.met in
let _ := Section_3_1_proofs.sec_3_1_space.proved in
let _ := Section_3_1_proofs.sec_3_1_space.met in
let _ := Section_3_1_proofs.eq_3_2.proved in
let _ := Section_3_1_proofs.eq_3_2.met in
let _ := Section_3_1_proofs.eq_3_3.proved in
let _ := Section_3_1_proofs.eq_3_3.met in
let _ := Section_3_1_proofs.eq_3_4.proved in
let _ := Section_3_1_proofs.eq_3_4.met in
let _ := Section_3_1_proofs.sec_3_1_ref.refuted in
let _ := Section_3_1_proofs.sec_3_1_ref_true.proved in
let _ := Section_3_1_proofs.sec_3_1_ref_true.met in
let _ := Section_3_2_printed_proofs.eq_3_5.proved in
let _ := Section_3_2_printed_proofs.eq_3_5.met in
let _ := Section_3_2_printed_proofs.eq_3_6.proved in
let _ := Section_3_2_printed_proofs.eq_3_6.met in
let _ := Section_3_2_printed_proofs.sec_3_2_phi.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_theta.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_theta.met in
let _ := Section_3_2_printed_proofs.sec_3_2_phi_exp.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_vec.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_vec.met in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_nearest.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_nearest.met in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_x.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_y.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_z.refuted in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_z_corrected.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_psi_den.proved in
let _ := Section_3_2_printed_proofs.eq_3_7.proved in
let _ := Section_3_2_printed_proofs.eq_3_7.met in
let _ := Section_3_2_printed_proofs.sec_3_2_envelope.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_envelope.met in
let _ := Section_3_2_proofs.eq_3_5.proved in
let _ := Section_3_2_proofs.eq_3_5.met in
let _ := Section_3_2_proofs.eq_3_6.proved in
let _ := Section_3_2_proofs.eq_3_6.met in
let _ := Section_3_2_proofs.sec_3_2_phi.proved in
let _ := Section_3_2_proofs.sec_3_2_theta.proved in
let _ := Section_3_2_proofs.sec_3_2_theta.met in
let _ := Section_3_2_proofs.sec_3_2_phi_exp.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_vec.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_vec.met in
let _ := Section_3_2_proofs.sec_3_2_psi_nearest.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_nearest.met in
let _ := Section_3_2_proofs.sec_3_2_psi_x.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_y.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_z.refuted in
let _ := Section_3_2_proofs.sec_3_2_psi_z_corrected.proved in
let _ := Section_3_2_proofs.sec_3_2_psi_den.proved in
let _ := Section_3_2_proofs.eq_3_7.proved in
let _ := Section_3_2_proofs.eq_3_7.met in
let _ := Section_3_2_proofs.sec_3_2_envelope.proved in
let _ := Section_3_2_proofs.sec_3_2_envelope.met in
let _ := Section_3_3_printed_proofs.eq_3_8.proved in
let _ := Section_3_3_printed_proofs.eq_3_8.met in
let _ := Section_3_3_printed_proofs.eq_3_9.proved in
let _ := Section_3_3_printed_proofs.eq_3_9.met in
let _ := Section_3_3_printed_proofs.sec_3_3_S_vec.refuted in
let _ := Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.met in
let _ := Section_3_3_printed_proofs.sec_3_3_S_x.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_S_y.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_S_z.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_S_den.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_regression.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_regression.met in
let _ := Section_3_3_printed_proofs.sec_3_3_regression_velocity.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_regression_velocity.met in
let _ := Section_3_3_printed_proofs.sec_3_3_regression_quadratic.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_regression_quadratic.met in
let _ := Section_3_3_printed_proofs.eq_3_10.proved in
let _ := Section_3_3_printed_proofs.eq_3_10.met in
let _ := Section_3_3_printed_proofs.sec_3_3_developable.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_developable.met in
let _ := Section_3_3_proofs.eq_3_8.proved in
let _ := Section_3_3_proofs.eq_3_8.met in
let _ := Section_3_3_proofs.eq_3_9.proved in
let _ := Section_3_3_proofs.eq_3_9.met in
let _ := Section_3_3_proofs.sec_3_3_S_vec.refuted in
let _ := Section_3_3_proofs.sec_3_3_S_vec_corrected.proved in
let _ := Section_3_3_proofs.sec_3_3_S_vec_corrected.met in
let _ := Section_3_3_proofs.sec_3_3_S_x.proved in
let _ := Section_3_3_proofs.sec_3_3_S_y.proved in
let _ := Section_3_3_proofs.sec_3_3_S_z.proved in
let _ := Section_3_3_proofs.sec_3_3_S_den.proved in
let _ := Section_3_3_proofs.sec_3_3_regression.proved in
let _ := Section_3_3_proofs.sec_3_3_regression.met in
let _ := Section_3_3_proofs.sec_3_3_regression_velocity.proved in
let _ := Section_3_3_proofs.sec_3_3_regression_velocity.met in
let _ := Section_3_3_proofs.sec_3_3_regression_quadratic.proved in
let _ := Section_3_3_proofs.sec_3_3_regression_quadratic.met in
let _ := Section_3_3_proofs.eq_3_10.proved in
let _ := Section_3_3_proofs.eq_3_10.met in
let _ := Section_3_3_proofs.sec_3_3_developable.proved in
let _ := Section_3_3_proofs.sec_3_3_developable.met in
let _ := Section_3_4_printed_proofs.eq_3_11_a.proved in
let _ := Section_3_4_printed_proofs.eq_3_11_a.met in
let _ := Section_3_4_printed_proofs.eq_3_11_b.proved in
let _ := Section_3_4_printed_proofs.eq_3_11_b.met in
let _ := Section_3_4_printed_proofs.eq_3_11_c.proved in
let _ := Section_3_4_printed_proofs.eq_3_11_c.met in
let _ := Section_3_4_printed_proofs.eq_3_12_a.proved in
let _ := Section_3_4_printed_proofs.eq_3_12_a.met in
let _ := Section_3_4_printed_proofs.eq_3_12_b.proved in
let _ := Section_3_4_printed_proofs.eq_3_12_b.met in
let _ := Section_3_4_printed_proofs.eq_3_12_c.proved in
let _ := Section_3_4_printed_proofs.eq_3_12_c.met in
let _ := Section_3_4_printed_proofs.sec_3_4_tangent_ends.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_tangent_ends.met in
let _ := Section_3_4_printed_proofs.eq_3_13.proved in
let _ := Section_3_4_printed_proofs.eq_3_13.met in
let _ := Section_3_4_printed_proofs.sec_3_4_J0.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_J0.met in
let _ := Section_3_4_printed_proofs.sec_3_4_dual.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_dual.met in
let _ := Section_3_4_printed_proofs.sec_3_4_J1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_J1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r2.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r2.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c2.refuted in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_true.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_true.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c3.refuted in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r2.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r2.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c2.refuted in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_true.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_true.met in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.met in
let _ := Section_3_4_printed_proofs.sec_3_4_S0.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_S0.met in
let _ := Section_3_4_printed_proofs.sec_3_4_S0_gen.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_S0_gen.met in
let _ := Section_3_4_printed_proofs.sec_3_4_S1.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_S1.met in
let _ := Section_3_4_printed_proofs.sec_3_4_S1_gen.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_S1_gen.met in
let _ := Section_3_4_proofs.eq_3_11_a.proved in
let _ := Section_3_4_proofs.eq_3_11_a.met in
let _ := Section_3_4_proofs.eq_3_11_b.proved in
let _ := Section_3_4_proofs.eq_3_11_b.met in
let _ := Section_3_4_proofs.eq_3_11_c.proved in
let _ := Section_3_4_proofs.eq_3_11_c.met in
let _ := Section_3_4_proofs.eq_3_12_a.proved in
let _ := Section_3_4_proofs.eq_3_12_a.met in
let _ := Section_3_4_proofs.eq_3_12_b.proved in
let _ := Section_3_4_proofs.eq_3_12_b.met in
let _ := Section_3_4_proofs.eq_3_12_c.proved in
let _ := Section_3_4_proofs.eq_3_12_c.met in
let _ := Section_3_4_proofs.sec_3_4_tangent_ends.proved in
let _ := Section_3_4_proofs.sec_3_4_tangent_ends.met in
let _ := Section_3_4_proofs.eq_3_13.proved in
let _ := Section_3_4_proofs.eq_3_13.met in
let _ := Section_3_4_proofs.sec_3_4_J0.proved in
let _ := Section_3_4_proofs.sec_3_4_J0.met in
let _ := Section_3_4_proofs.sec_3_4_dual.proved in
let _ := Section_3_4_proofs.sec_3_4_dual.met in
let _ := Section_3_4_proofs.sec_3_4_J1.proved in
let _ := Section_3_4_proofs.sec_3_4_J1.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r1.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r1.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r2.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r2.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c1.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c1.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c2.refuted in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c2_corrected.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_true.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_true.met in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c3.refuted in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.proved in
let _ := Section_3_4_proofs.sec_3_4_m0_r3_c3_corrected.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r1.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r1.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r2.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r2.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c1.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c1.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c2.refuted in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c2_corrected.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_true.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_true.met in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c3.proved in
let _ := Section_3_4_proofs.sec_3_4_m1_r3_c3.met in
let _ := Section_3_4_proofs.sec_3_4_S0.proved in
let _ := Section_3_4_proofs.sec_3_4_S0.met in
let _ := Section_3_4_proofs.sec_3_4_S0_gen.proved in
let _ := Section_3_4_proofs.sec_3_4_S0_gen.met in
let _ := Section_3_4_proofs.sec_3_4_S1.proved in
let _ := Section_3_4_proofs.sec_3_4_S1.met in
let _ := Section_3_4_proofs.sec_3_4_S1_gen.proved in
let _ := Section_3_4_proofs.sec_3_4_S1_gen.met in
let _ := Section_4_1_printed_proofs.ex_4_1_Q0.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_Q0.met in
let _ := Section_4_1_printed_proofs.ex_4_1_Q1.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_Q1.met in
let _ := Section_4_1_printed_proofs.ex_4_1_Q2.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_Q2.met in
let _ := Section_4_1_printed_proofs.ex_4_1_Q3.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_Q3.met in
let _ := Section_4_1_printed_proofs.ex_4_1_distance.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_distance.met in
let _ := Section_4_1_printed_proofs.ex_4_1_coplanar.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_coplanar.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_a.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_a.met in
let _ := Section_4_1_printed_proofs.ex_4_1_lengths.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_lengths.met in
let _ := Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_b.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_c.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_d.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_e.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_a.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_a.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_b.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_c.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_d.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_a.refuted in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_b.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_c.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_c.met in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_d.proved in
let _ := Section_4_1_printed_proofs.ex_4_1_c3_d.met in
let _ := Section_4_1_printed_proofs.ex_4_2_Q0.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_Q0.met in
let _ := Section_4_1_printed_proofs.ex_4_2_Q1.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_Q1.met in
let _ := Section_4_1_printed_proofs.ex_4_2_Q2.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_Q2.met in
let _ := Section_4_1_printed_proofs.ex_4_2_Q3.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_Q3.met in
let _ := Section_4_1_printed_proofs.ex_4_2_class.refuted in
let _ := Section_4_1_printed_proofs.ex_4_2_pencil.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_pencil.met in
let _ := Section_4_1_printed_proofs.ex_4_2_lengths.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_lengths.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_a.refuted in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_b.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_c.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_c.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_d.refuted in
let _ := Section_4_1_printed_proofs.ex_4_2_c1_e.refuted in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_a.refuted in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_b.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_c.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_c.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_d.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c2_d.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_a.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_a.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_b.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_b.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_c.proved in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_c.met in
let _ := Section_4_1_printed_proofs.ex_4_2_c3_d.refuted in
let _ := Section_4_1_proofs.ex_4_1_Q0.proved in
let _ := Section_4_1_proofs.ex_4_1_Q0.met in
let _ := Section_4_1_proofs.ex_4_1_Q1.proved in
let _ := Section_4_1_proofs.ex_4_1_Q1.met in
let _ := Section_4_1_proofs.ex_4_1_Q2.proved in
let _ := Section_4_1_proofs.ex_4_1_Q2.met in
let _ := Section_4_1_proofs.ex_4_1_Q3.proved in
let _ := Section_4_1_proofs.ex_4_1_Q3.met in
let _ := Section_4_1_proofs.ex_4_1_distance.proved in
let _ := Section_4_1_proofs.ex_4_1_distance.met in
let _ := Section_4_1_proofs.ex_4_1_coplanar.proved in
let _ := Section_4_1_proofs.ex_4_1_coplanar.met in
let _ := Section_4_1_proofs.ex_4_1_c1_a.proved in
let _ := Section_4_1_proofs.ex_4_1_c1_a.met in
let _ := Section_4_1_proofs.ex_4_1_lengths.proved in
let _ := Section_4_1_proofs.ex_4_1_lengths.met in
let _ := Section_4_1_proofs.ex_4_1_lengths_exchanged.proved in
let _ := Section_4_1_proofs.ex_4_1_lengths_exchanged.met in
let _ := Section_4_1_proofs.ex_4_1_c1_b.proved in
let _ := Section_4_1_proofs.ex_4_1_c1_b.met in
let _ := Section_4_1_proofs.ex_4_1_c1_c.refuted in
let _ := Section_4_1_proofs.ex_4_1_c1_d.refuted in
let _ := Section_4_1_proofs.ex_4_1_c1_e.refuted in
let _ := Section_4_1_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted in
let _ := Section_4_1_proofs.ex_4_1_c2_a.proved in
let _ := Section_4_1_proofs.ex_4_1_c2_a.met in
let _ := Section_4_1_proofs.ex_4_1_c2_b.proved in
let _ := Section_4_1_proofs.ex_4_1_c2_b.met in
let _ := Section_4_1_proofs.ex_4_1_c2_c.refuted in
let _ := Section_4_1_proofs.ex_4_1_c2_d.refuted in
let _ := Section_4_1_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted in
let _ := Section_4_1_proofs.ex_4_1_c3_a.refuted in
let _ := Section_4_1_proofs.ex_4_1_c3_b.proved in
let _ := Section_4_1_proofs.ex_4_1_c3_b.met in
let _ := Section_4_1_proofs.ex_4_1_c3_c.proved in
let _ := Section_4_1_proofs.ex_4_1_c3_c.met in
let _ := Section_4_1_proofs.ex_4_1_c3_d.proved in
let _ := Section_4_1_proofs.ex_4_1_c3_d.met in
let _ := Section_4_1_proofs.ex_4_2_Q0.proved in
let _ := Section_4_1_proofs.ex_4_2_Q0.met in
let _ := Section_4_1_proofs.ex_4_2_Q1.proved in
let _ := Section_4_1_proofs.ex_4_2_Q1.met in
let _ := Section_4_1_proofs.ex_4_2_Q2.proved in
let _ := Section_4_1_proofs.ex_4_2_Q2.met in
let _ := Section_4_1_proofs.ex_4_2_Q3.proved in
let _ := Section_4_1_proofs.ex_4_2_Q3.met in
let _ := Section_4_1_proofs.ex_4_2_class.refuted in
let _ := Section_4_1_proofs.ex_4_2_pencil.proved in
let _ := Section_4_1_proofs.ex_4_2_pencil.met in
let _ := Section_4_1_proofs.ex_4_2_lengths.proved in
let _ := Section_4_1_proofs.ex_4_2_lengths.met in
let _ := Section_4_1_proofs.ex_4_2_c1_a.refuted in
let _ := Section_4_1_proofs.ex_4_2_c1_b.proved in
let _ := Section_4_1_proofs.ex_4_2_c1_b.met in
let _ := Section_4_1_proofs.ex_4_2_c1_c.proved in
let _ := Section_4_1_proofs.ex_4_2_c1_c.met in
let _ := Section_4_1_proofs.ex_4_2_c1_d.refuted in
let _ := Section_4_1_proofs.ex_4_2_c1_e.refuted in
let _ := Section_4_1_proofs.ex_4_2_c2_a.refuted in
let _ := Section_4_1_proofs.ex_4_2_c2_b.proved in
let _ := Section_4_1_proofs.ex_4_2_c2_b.met in
let _ := Section_4_1_proofs.ex_4_2_c2_c.proved in
let _ := Section_4_1_proofs.ex_4_2_c2_c.met in
let _ := Section_4_1_proofs.ex_4_2_c2_d.proved in
let _ := Section_4_1_proofs.ex_4_2_c2_d.met in
let _ := Section_4_1_proofs.ex_4_2_c3_a.proved in
let _ := Section_4_1_proofs.ex_4_2_c3_a.met in
let _ := Section_4_1_proofs.ex_4_2_c3_b.proved in
let _ := Section_4_1_proofs.ex_4_2_c3_b.met in
let _ := Section_4_1_proofs.ex_4_2_c3_c.proved in
let _ := Section_4_1_proofs.ex_4_2_c3_c.met in
let _ := Section_4_1_proofs.ex_4_2_c3_d.refuted in
let _ := Section_4_2_printed_proofs.sec_4_2_Q0.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_Q0.met in
let _ := Section_4_2_printed_proofs.sec_4_2_Q1.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_Q1.met in
let _ := Section_4_2_printed_proofs.sec_4_2_Q1_lengths.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_Q2.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_Q2.met in
let _ := Section_4_2_printed_proofs.sec_4_2_Q3.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_Q3.met in
let _ := Section_4_2_printed_proofs.sec_4_2_quadrants.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_quadrants.met in
let _ := Section_4_2_printed_proofs.sec_4_2_distances.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_distances.met in
let _ := Section_4_2_printed_proofs.sec_4_2_class.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_class.met in
let _ := Section_4_2_printed_proofs.sec_4_2_class_ends.proved in
let _ := Section_4_2_printed_proofs.sec_4_2_class_ends.met in
let _ := Section_4_2_proofs.sec_4_2_Q0.proved in
let _ := Section_4_2_proofs.sec_4_2_Q0.met in
let _ := Section_4_2_proofs.sec_4_2_Q1.proved in
let _ := Section_4_2_proofs.sec_4_2_Q1.met in
let _ := Section_4_2_proofs.sec_4_2_Q1_lengths.proved in
let _ := Section_4_2_proofs.sec_4_2_Q2.proved in
let _ := Section_4_2_proofs.sec_4_2_Q2.met in
let _ := Section_4_2_proofs.sec_4_2_Q3.proved in
let _ := Section_4_2_proofs.sec_4_2_Q3.met in
let _ := Section_4_2_proofs.sec_4_2_quadrants.proved in
let _ := Section_4_2_proofs.sec_4_2_quadrants.met in
let _ := Section_4_2_proofs.sec_4_2_distances.proved in
let _ := Section_4_2_proofs.sec_4_2_distances.met in
let _ := Section_4_2_proofs.sec_4_2_class.proved in
let _ := Section_4_2_proofs.sec_4_2_class.met in
let _ := Section_4_2_proofs.sec_4_2_class_ends.proved in
let _ := Section_4_2_proofs.sec_4_2_class_ends.met in
let _ := Section_4_printed_proofs.sec_4_midpoints.proved in
let _ := Section_4_printed_proofs.sec_4_midpoints.met in
let _ := Section_4_printed_proofs.ex_4_2_distance.proved in
let _ := Section_4_printed_proofs.ex_4_2_distance.met in
let _ := Section_4_printed_proofs.ex_4_2_coplanar.proved in
let _ := Section_4_printed_proofs.ex_4_2_coplanar.met in
let _ := Section_4_proofs.sec_4_midpoints.proved in
let _ := Section_4_proofs.sec_4_midpoints.met in
let _ := Section_4_proofs.ex_4_2_distance.proved in
let _ := Section_4_proofs.ex_4_2_distance.met in
let _ := Section_4_proofs.ex_4_2_coplanar.proved in
let _ := Section_4_proofs.ex_4_2_coplanar.met in
let _ := Section_5_1_printed_proofs.eq_5_3_b.refuted in
let _ := Section_5_1_printed_proofs.eq_5_3_b_corrected.proved in
let _ := Section_5_1_printed_proofs.eq_5_3_b_corrected.met in
let _ := Section_5_1_printed_proofs.eq_5_4.proved in
let _ := Section_5_1_printed_proofs.eq_5_4.met in
let _ := Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved in
let _ := Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met in
let _ := Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_in_space.refuted in
let _ := Section_5_1_printed_proofs.sec_5_1_certify.proved in
let _ := Section_5_1_printed_proofs.sec_5_1_certify.met in
let _ := Section_5_1_printed_proofs.sec_5_1_certify_sheets.proved in
let _ := Section_5_1_printed_proofs.sec_5_1_certify_sheets.met in
let _ := Section_5_1_printed_proofs.sec_5_1_certify_cusp.proved in
let _ := Section_5_1_printed_proofs.sec_5_1_certify_cusp.met in
let _ := Section_5_1_printed_proofs.thm_2_inflection.proved in
let _ := Section_5_1_printed_proofs.thm_2_inflection.met in
let _ := Section_5_1_printed_proofs.sec_5_1_G0_families.proved in
let _ := Section_5_1_printed_proofs.sec_5_1_G0_families.met in
let _ := Section_5_1_printed_proofs.sec_5_1_G0_surfaces.refuted in
let _ := Section_5_1_printed_proofs.thm_2_a.proved in
let _ := Section_5_1_printed_proofs.thm_2_a.met in
let _ := Section_5_1_printed_proofs.thm_2_b.proved in
let _ := Section_5_1_printed_proofs.thm_2_b.met in
let _ := Section_5_1_printed_proofs.eq_5_7_requirement.proved in
let _ := Section_5_1_printed_proofs.eq_5_7_requirement.met in
let _ := Section_5_1_printed_proofs.eq_5_7_equivalence.refuted in
let _ := Section_5_1_printed_proofs.eq_5_8_a.proved in
let _ := Section_5_1_printed_proofs.eq_5_8_a.met in
let _ := Section_5_1_printed_proofs.eq_5_8_b.proved in
let _ := Section_5_1_printed_proofs.eq_5_8_b.met in
let _ := Section_5_1_printed_proofs.eq_5_9.proved in
let _ := Section_5_1_printed_proofs.eq_5_9.met in
let _ := Section_5_1_printed_proofs.eq_5_10.proved in
let _ := Section_5_1_printed_proofs.eq_5_10.met in
let _ := Section_5_1_printed_proofs.thm_2_sufficient.proved in
let _ := Section_5_1_printed_proofs.thm_2_sufficient.met in
let _ := Section_5_1_printed_proofs.thm_2_necessary_families.proved in
let _ := Section_5_1_printed_proofs.thm_2_necessary_families.met in
let _ := Section_5_1_printed_proofs.thm_2_necessary_surfaces.refuted in
let _ := Section_5_1_printed_proofs.thm_2_true_necessary.proved in
let _ := Section_5_1_printed_proofs.thm_2_true_necessary.met in
let _ := Section_5_1_printed_proofs.thm_2_true_sufficient.proved in
let _ := Section_5_1_printed_proofs.thm_2_true_sufficient.met in
let _ := Section_5_1_printed_proofs.thm_2_true_generator.proved in
let _ := Section_5_1_printed_proofs.thm_2_true_generator.met in
let _ := Section_5_1_printed_proofs.thm_2_true_sheets.proved in
let _ := Section_5_1_printed_proofs.thm_2_true_sheets.met in
let _ := Section_5_1_printed_proofs.thm_2_proof_comprise_families.proved in
let _ := Section_5_1_printed_proofs.thm_2_proof_comprise_families.met in
let _ := Section_5_1_printed_proofs.thm_2_proof_comprise_surfaces.refuted in
let _ := Section_5_1_proofs.eq_5_3_b.refuted in
let _ := Section_5_1_proofs.eq_5_3_b_corrected.proved in
let _ := Section_5_1_proofs.eq_5_3_b_corrected.met in
let _ := Section_5_1_proofs.eq_5_4.proved in
let _ := Section_5_1_proofs.eq_5_4.met in
let _ := Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved in
let _ := Section_5_1_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met in
let _ := Section_5_1_proofs.eq_5_4_nec_suf_curves_in_space.refuted in
let _ := Section_5_1_proofs.sec_5_1_certify.proved in
let _ := Section_5_1_proofs.sec_5_1_certify.met in
let _ := Section_5_1_proofs.sec_5_1_certify_sheets.proved in
let _ := Section_5_1_proofs.sec_5_1_certify_sheets.met in
let _ := Section_5_1_proofs.sec_5_1_certify_cusp.proved in
let _ := Section_5_1_proofs.sec_5_1_certify_cusp.met in
let _ := Section_5_1_proofs.thm_2_inflection.proved in
let _ := Section_5_1_proofs.thm_2_inflection.met in
let _ := Section_5_1_proofs.sec_5_1_G0_families.proved in
let _ := Section_5_1_proofs.sec_5_1_G0_families.met in
let _ := Section_5_1_proofs.sec_5_1_G0_surfaces.refuted in
let _ := Section_5_1_proofs.thm_2_a.proved in
let _ := Section_5_1_proofs.thm_2_a.met in
let _ := Section_5_1_proofs.thm_2_b.proved in
let _ := Section_5_1_proofs.thm_2_b.met in
let _ := Section_5_1_proofs.eq_5_7_requirement.proved in
let _ := Section_5_1_proofs.eq_5_7_requirement.met in
let _ := Section_5_1_proofs.eq_5_7_equivalence.refuted in
let _ := Section_5_1_proofs.eq_5_8_a.proved in
let _ := Section_5_1_proofs.eq_5_8_a.met in
let _ := Section_5_1_proofs.eq_5_8_b.proved in
let _ := Section_5_1_proofs.eq_5_8_b.met in
let _ := Section_5_1_proofs.eq_5_9.proved in
let _ := Section_5_1_proofs.eq_5_9.met in
let _ := Section_5_1_proofs.eq_5_10.proved in
let _ := Section_5_1_proofs.eq_5_10.met in
let _ := Section_5_1_proofs.thm_2_sufficient.proved in
let _ := Section_5_1_proofs.thm_2_sufficient.met in
let _ := Section_5_1_proofs.thm_2_necessary_families.proved in
let _ := Section_5_1_proofs.thm_2_necessary_families.met in
let _ := Section_5_1_proofs.thm_2_necessary_surfaces.refuted in
let _ := Section_5_1_proofs.thm_2_true_necessary.proved in
let _ := Section_5_1_proofs.thm_2_true_necessary.met in
let _ := Section_5_1_proofs.thm_2_true_sufficient.proved in
let _ := Section_5_1_proofs.thm_2_true_sufficient.met in
let _ := Section_5_1_proofs.thm_2_true_generator.proved in
let _ := Section_5_1_proofs.thm_2_true_generator.met in
let _ := Section_5_1_proofs.thm_2_true_sheets.proved in
let _ := Section_5_1_proofs.thm_2_true_sheets.met in
let _ := Section_5_1_proofs.thm_2_proof_comprise_families.proved in
let _ := Section_5_1_proofs.thm_2_proof_comprise_families.met in
let _ := Section_5_1_proofs.thm_2_proof_comprise_surfaces.refuted in
let _ := Section_5_2_printed_proofs.eq_5_11.proved in
let _ := Section_5_2_printed_proofs.eq_5_11.met in
let _ := Section_5_2_printed_proofs.sec_5_2_meaning.proved in
let _ := Section_5_2_printed_proofs.sec_5_2_meaning.met in
let _ := Section_5_2_printed_proofs.sec_5_2_ref.refuted in
let _ := Section_5_2_printed_proofs.sec_5_2_ref_true.proved in
let _ := Section_5_2_printed_proofs.sec_5_2_ref_true.met in
let _ := Section_5_2_printed_proofs.sec_5_2_index.refuted in
let _ := Section_5_2_printed_proofs.thm_3_consts.proved in
let _ := Section_5_2_printed_proofs.thm_3_consts.met in
let _ := Section_5_2_printed_proofs.thm_3_a.proved in
let _ := Section_5_2_printed_proofs.thm_3_a.met in
let _ := Section_5_2_printed_proofs.thm_3_b.proved in
let _ := Section_5_2_printed_proofs.thm_3_b.met in
let _ := Section_5_2_printed_proofs.thm_3_c.proved in
let _ := Section_5_2_printed_proofs.thm_3_c.met in
let _ := Section_5_2_printed_proofs.thm_3_sufficient.proved in
let _ := Section_5_2_printed_proofs.thm_3_sufficient.met in
let _ := Section_5_2_printed_proofs.thm_3_necessary_families.proved in
let _ := Section_5_2_printed_proofs.thm_3_necessary_families.met in
let _ := Section_5_2_printed_proofs.thm_3_necessary_surfaces.refuted in
let _ := Section_5_2_printed_proofs.eq_5_13.proved in
let _ := Section_5_2_printed_proofs.eq_5_13.met in
let _ := Section_5_2_printed_proofs.eq_5_15.proved in
let _ := Section_5_2_printed_proofs.eq_5_15.met in
let _ := Section_5_2_printed_proofs.thm_3_proofref.refuted in
let _ := Section_5_2_printed_proofs.thm_3_proofref_true.proved in
let _ := Section_5_2_printed_proofs.thm_3_proofref_true.met in
let _ := Section_5_2_printed_proofs.sec_5_2_must_families.proved in
let _ := Section_5_2_printed_proofs.sec_5_2_must_families.met in
let _ := Section_5_2_printed_proofs.sec_5_2_must_surfaces.refuted in
let _ := Section_5_2_printed_proofs.thm_3_proof_implies_families.proved in
let _ := Section_5_2_printed_proofs.thm_3_proof_implies_families.met in
let _ := Section_5_2_printed_proofs.thm_3_proof_implies_surfaces.refuted in
let _ := Section_5_2_proofs.eq_5_11.proved in
let _ := Section_5_2_proofs.eq_5_11.met in
let _ := Section_5_2_proofs.sec_5_2_meaning.proved in
let _ := Section_5_2_proofs.sec_5_2_meaning.met in
let _ := Section_5_2_proofs.sec_5_2_ref.refuted in
let _ := Section_5_2_proofs.sec_5_2_ref_true.proved in
let _ := Section_5_2_proofs.sec_5_2_ref_true.met in
let _ := Section_5_2_proofs.sec_5_2_index.refuted in
let _ := Section_5_2_proofs.thm_3_consts.proved in
let _ := Section_5_2_proofs.thm_3_consts.met in
let _ := Section_5_2_proofs.thm_3_a.proved in
let _ := Section_5_2_proofs.thm_3_a.met in
let _ := Section_5_2_proofs.thm_3_b.proved in
let _ := Section_5_2_proofs.thm_3_b.met in
let _ := Section_5_2_proofs.thm_3_c.proved in
let _ := Section_5_2_proofs.thm_3_c.met in
let _ := Section_5_2_proofs.thm_3_sufficient.proved in
let _ := Section_5_2_proofs.thm_3_sufficient.met in
let _ := Section_5_2_proofs.thm_3_necessary_families.proved in
let _ := Section_5_2_proofs.thm_3_necessary_families.met in
let _ := Section_5_2_proofs.thm_3_necessary_surfaces.refuted in
let _ := Section_5_2_proofs.eq_5_13.proved in
let _ := Section_5_2_proofs.eq_5_13.met in
let _ := Section_5_2_proofs.eq_5_15.proved in
let _ := Section_5_2_proofs.eq_5_15.met in
let _ := Section_5_2_proofs.thm_3_proofref.refuted in
let _ := Section_5_2_proofs.thm_3_proofref_true.proved in
let _ := Section_5_2_proofs.thm_3_proofref_true.met in
let _ := Section_5_2_proofs.sec_5_2_must_families.proved in
let _ := Section_5_2_proofs.sec_5_2_must_families.met in
let _ := Section_5_2_proofs.sec_5_2_must_surfaces.refuted in
let _ := Section_5_2_proofs.thm_3_proof_implies_families.proved in
let _ := Section_5_2_proofs.thm_3_proof_implies_families.met in
let _ := Section_5_2_proofs.thm_3_proof_implies_surfaces.refuted in
let _ := Section_5_3_printed_proofs.thm_4_consts.proved in
let _ := Section_5_3_printed_proofs.thm_4_consts.met in
let _ := Section_5_3_printed_proofs.thm_4_a.proved in
let _ := Section_5_3_printed_proofs.thm_4_a.met in
let _ := Section_5_3_printed_proofs.thm_4_b.proved in
let _ := Section_5_3_printed_proofs.thm_4_b.met in
let _ := Section_5_3_printed_proofs.thm_4_c.refuted in
let _ := Section_5_3_printed_proofs.thm_4_c_corrected.proved in
let _ := Section_5_3_printed_proofs.thm_4_c_corrected.met in
let _ := Section_5_3_printed_proofs.thm_4_c_true.proved in
let _ := Section_5_3_printed_proofs.thm_4_c_true.met in
let _ := Section_5_3_printed_proofs.eq_5_17.proved in
let _ := Section_5_3_printed_proofs.eq_5_17.met in
let _ := Section_5_3_printed_proofs.thm_4_sufficient.proved in
let _ := Section_5_3_printed_proofs.thm_4_sufficient.met in
let _ := Section_5_3_printed_proofs.thm_4_necessary_families.proved in
let _ := Section_5_3_printed_proofs.thm_4_necessary_families.met in
let _ := Section_5_3_printed_proofs.thm_4_necessary_surfaces.refuted in
let _ := Section_5_3_printed_proofs.thm_4_true_necessary.proved in
let _ := Section_5_3_printed_proofs.thm_4_true_necessary.met in
let _ := Section_5_3_printed_proofs.thm_4_true_sufficient.proved in
let _ := Section_5_3_printed_proofs.thm_4_true_sufficient.met in
let _ := Section_5_3_printed_proofs.thm_4_true_sheets.proved in
let _ := Section_5_3_printed_proofs.thm_4_true_sheets.met in
let _ := Section_5_3_printed_proofs.thm_4_true_curvature.proved in
let _ := Section_5_3_printed_proofs.thm_4_true_curvature.met in
let _ := Section_5_3_printed_proofs.thm_4_proof_must_families.proved in
let _ := Section_5_3_printed_proofs.thm_4_proof_must_families.met in
let _ := Section_5_3_printed_proofs.thm_4_proof_must_surfaces.refuted in
let _ := Section_5_3_printed_proofs.thm_4_proof_establish_families.proved in
let _ := Section_5_3_printed_proofs.thm_4_proof_establish_families.met in
let _ := Section_5_3_printed_proofs.thm_4_proof_establish_surfaces.refuted in
let _ := Section_5_3_proofs.thm_4_consts.proved in
let _ := Section_5_3_proofs.thm_4_consts.met in
let _ := Section_5_3_proofs.thm_4_a.proved in
let _ := Section_5_3_proofs.thm_4_a.met in
let _ := Section_5_3_proofs.thm_4_b.proved in
let _ := Section_5_3_proofs.thm_4_b.met in
let _ := Section_5_3_proofs.thm_4_c.refuted in
let _ := Section_5_3_proofs.thm_4_c_corrected.proved in
let _ := Section_5_3_proofs.thm_4_c_corrected.met in
let _ := Section_5_3_proofs.thm_4_c_true.proved in
let _ := Section_5_3_proofs.thm_4_c_true.met in
let _ := Section_5_3_proofs.eq_5_17.proved in
let _ := Section_5_3_proofs.eq_5_17.met in
let _ := Section_5_3_proofs.thm_4_sufficient.proved in
let _ := Section_5_3_proofs.thm_4_sufficient.met in
let _ := Section_5_3_proofs.thm_4_necessary_families.proved in
let _ := Section_5_3_proofs.thm_4_necessary_families.met in
let _ := Section_5_3_proofs.thm_4_necessary_surfaces.refuted in
let _ := Section_5_3_proofs.thm_4_true_necessary.proved in
let _ := Section_5_3_proofs.thm_4_true_necessary.met in
let _ := Section_5_3_proofs.thm_4_true_sufficient.proved in
let _ := Section_5_3_proofs.thm_4_true_sufficient.met in
let _ := Section_5_3_proofs.thm_4_true_sheets.proved in
let _ := Section_5_3_proofs.thm_4_true_sheets.met in
let _ := Section_5_3_proofs.thm_4_true_curvature.proved in
let _ := Section_5_3_proofs.thm_4_true_curvature.met in
let _ := Section_5_3_proofs.thm_4_proof_must_families.proved in
let _ := Section_5_3_proofs.thm_4_proof_must_families.met in
let _ := Section_5_3_proofs.thm_4_proof_must_surfaces.refuted in
let _ := Section_5_3_proofs.thm_4_proof_establish_families.proved in
let _ := Section_5_3_proofs.thm_4_proof_establish_families.met in
let _ := Section_5_3_proofs.thm_4_proof_establish_surfaces.refuted in
let _ := Section_5_4_printed_proofs.alg_5_4_s1.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_s1.met in
let _ := Section_5_4_printed_proofs.alg_5_4_s2_families.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_s2_families.met in
let _ := Section_5_4_printed_proofs.alg_5_4_s2_surfaces.refuted in
let _ := Section_5_4_printed_proofs.alg_5_4_s3.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_s3.met in
let _ := Section_5_4_printed_proofs.alg_5_4_s4.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_s4.met in
let _ := Section_5_4_printed_proofs.alg_5_4_s5.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_s5.met in
let _ := Section_5_4_printed_proofs.alg_5_4_iterate.proved in
let _ := Section_5_4_printed_proofs.alg_5_4_iterate.met in
let _ := Section_5_4_proofs.alg_5_4_s1.proved in
let _ := Section_5_4_proofs.alg_5_4_s1.met in
let _ := Section_5_4_proofs.alg_5_4_s2_families.proved in
let _ := Section_5_4_proofs.alg_5_4_s2_families.met in
let _ := Section_5_4_proofs.alg_5_4_s2_surfaces.refuted in
let _ := Section_5_4_proofs.alg_5_4_s3.proved in
let _ := Section_5_4_proofs.alg_5_4_s3.met in
let _ := Section_5_4_proofs.alg_5_4_s4.proved in
let _ := Section_5_4_proofs.alg_5_4_s4.met in
let _ := Section_5_4_proofs.alg_5_4_s5.proved in
let _ := Section_5_4_proofs.alg_5_4_s5.met in
let _ := Section_5_4_proofs.alg_5_4_iterate.proved in
let _ := Section_5_4_proofs.alg_5_4_iterate.met in
let _ := Section_5_5_printed_proofs.ex_5_1_construct.proved in
let _ := Section_5_5_printed_proofs.ex_5_1_construct.met in
let _ := Section_5_5_printed_proofs.ex_5_1_shape_shape.proved in
let _ := Section_5_5_printed_proofs.ex_5_1_shape_shape.met in
let _ := Section_5_5_printed_proofs.ex_5_1_shape_combined_surface.refuted in
let _ := Section_5_5_printed_proofs.ex_5_2_Q02.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_Q02.met in
let _ := Section_5_5_printed_proofs.ex_5_2_Q12.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_Q12.met in
let _ := Section_5_5_printed_proofs.ex_5_2_Q22.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_Q22.met in
let _ := Section_5_5_printed_proofs.ex_5_2_gamma_one.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_gamma_one.met in
let _ := Section_5_5_printed_proofs.ex_5_2_gap_surfaces.refuted in
let _ := Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.met in
let _ := Section_5_5_printed_proofs.ex_5_2_one_line.proved in
let _ := Section_5_5_printed_proofs.ex_5_2_one_line.met in
let _ := Section_5_5_proofs.ex_5_1_construct.proved in
let _ := Section_5_5_proofs.ex_5_1_construct.met in
let _ := Section_5_5_proofs.ex_5_1_shape_shape.proved in
let _ := Section_5_5_proofs.ex_5_1_shape_shape.met in
let _ := Section_5_5_proofs.ex_5_1_shape_combined_surface.refuted in
let _ := Section_5_5_proofs.ex_5_2_Q02.proved in
let _ := Section_5_5_proofs.ex_5_2_Q02.met in
let _ := Section_5_5_proofs.ex_5_2_Q12.proved in
let _ := Section_5_5_proofs.ex_5_2_Q12.met in
let _ := Section_5_5_proofs.ex_5_2_Q22.proved in
let _ := Section_5_5_proofs.ex_5_2_Q22.met in
let _ := Section_5_5_proofs.ex_5_2_gamma_one.proved in
let _ := Section_5_5_proofs.ex_5_2_gamma_one.met in
let _ := Section_5_5_proofs.ex_5_2_gap_surfaces.refuted in
let _ := Section_5_5_proofs.ex_5_2_gap_drawn_pieces.proved in
let _ := Section_5_5_proofs.ex_5_2_gap_drawn_pieces.met in
let _ := Section_5_5_proofs.ex_5_2_one_line.proved in
let _ := Section_5_5_proofs.ex_5_2_one_line.met in
let _ := Section_5_printed_proofs.eq_5_1.proved in
let _ := Section_5_printed_proofs.eq_5_1.met in
let _ := Section_5_printed_proofs.sec_5_weighted_a.proved in
let _ := Section_5_printed_proofs.sec_5_weighted_a.met in
let _ := Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.proved in
let _ := Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.met in
let _ := Section_5_printed_proofs.sec_5_weighted_b_after_division.refuted in
let _ := Section_5_printed_proofs.eq_5_2.proved in
let _ := Section_5_printed_proofs.eq_5_2.met in
let _ := Section_5_proofs.eq_5_1.proved in
let _ := Section_5_proofs.eq_5_1.met in
let _ := Section_5_proofs.sec_5_weighted_a.proved in
let _ := Section_5_proofs.sec_5_weighted_a.met in
let _ := Section_5_proofs.sec_5_weighted_b_four_coordinates.proved in
let _ := Section_5_proofs.sec_5_weighted_b_four_coordinates.met in
let _ := Section_5_proofs.sec_5_weighted_b_after_division.refuted in
let _ := Section_5_proofs.eq_5_2.proved in
let _ := Section_5_proofs.eq_5_2.met in
I.
