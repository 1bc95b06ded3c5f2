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
Check (GbtDevelopable.Part_Abstract_printed_proofs.abs_conics_planes.refuted : ~ GbtDevelopable.Part_Abstract_printed.abs_conics_planes.statement).
Check (GbtDevelopable.Part_Abstract_printed_proofs.abs_conics_points.proved : GbtDevelopable.Part_Abstract_printed.abs_conics_points.statement).
Check (GbtDevelopable.Part_Abstract_printed_proofs.abs_4d_factor.proved : GbtDevelopable.Part_Abstract_printed.abs_4d_factor.statement).
Check (GbtDevelopable.Part_Abstract_printed_proofs.abs_4d_factor.met : GbtDevelopable.Part_Abstract_printed.abs_4d_factor.instance).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_planes.refuted : ~ GbtDevelopable.Part_Abstract.abs_conics_planes.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved : GbtDevelopable.Part_Abstract.abs_conics_points.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved : GbtDevelopable.Part_Abstract.abs_4d_factor.statement).
Check (GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met : GbtDevelopable.Part_Abstract.abs_4d_factor.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_gk_by_the_printed_conditions.refuted : ~ GbtDevelopable.Section_1_printed.intro_gk_by_the_printed_conditions.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_gk_there_are_such_compositions.proved : GbtDevelopable.Section_1_printed.intro_gk_there_are_such_compositions.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_gk_there_are_such_compositions.met : GbtDevelopable.Section_1_printed.intro_gk_there_are_such_compositions.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_a.proved : GbtDevelopable.Section_1_printed.intro_continuity_free_a.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_a.met : GbtDevelopable.Section_1_printed.intro_continuity_free_a.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_b_any_values.refuted : ~ GbtDevelopable.Section_1_printed.intro_continuity_free_b_any_values.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_c_any_values.refuted : ~ GbtDevelopable.Section_1_printed.intro_continuity_free_c_any_values.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_1.proved : GbtDevelopable.Section_1_printed.intro_contrib_1.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_1.met : GbtDevelopable.Section_1_printed.intro_contrib_1.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_2.proved : GbtDevelopable.Section_1_printed.intro_contrib_2.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_2.met : GbtDevelopable.Section_1_printed.intro_contrib_2.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_4.proved : GbtDevelopable.Section_1_printed.intro_contrib_4.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_contrib_4.met : GbtDevelopable.Section_1_printed.intro_contrib_4.instance).
Check (GbtDevelopable.Section_1_printed_proofs.intro_gauss.proved : GbtDevelopable.Section_1_printed.intro_gauss.statement).
Check (GbtDevelopable.Section_1_printed_proofs.intro_gauss.met : GbtDevelopable.Section_1_printed.intro_gauss.instance).
Check (GbtDevelopable.Section_1_proofs.intro_gk_by_the_printed_conditions.refuted : ~ GbtDevelopable.Section_1.intro_gk_by_the_printed_conditions.statement).
Check (GbtDevelopable.Section_1_proofs.intro_gk_there_are_such_compositions.proved : GbtDevelopable.Section_1.intro_gk_there_are_such_compositions.statement).
Check (GbtDevelopable.Section_1_proofs.intro_gk_there_are_such_compositions.met : GbtDevelopable.Section_1.intro_gk_there_are_such_compositions.instance).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_a.proved : GbtDevelopable.Section_1.intro_continuity_free_a.statement).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_a.met : GbtDevelopable.Section_1.intro_continuity_free_a.instance).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted : ~ GbtDevelopable.Section_1.intro_continuity_free_b_any_values.statement).
Check (GbtDevelopable.Section_1_proofs.intro_continuity_free_c_any_values.refuted : ~ GbtDevelopable.Section_1.intro_continuity_free_c_any_values.statement).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_1.proved : GbtDevelopable.Section_1.intro_contrib_1.statement).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_1.met : GbtDevelopable.Section_1.intro_contrib_1.instance).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_2.proved : GbtDevelopable.Section_1.intro_contrib_2.statement).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_2.met : GbtDevelopable.Section_1.intro_contrib_2.instance).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_4.proved : GbtDevelopable.Section_1.intro_contrib_4.statement).
Check (GbtDevelopable.Section_1_proofs.intro_contrib_4.met : GbtDevelopable.Section_1.intro_contrib_4.instance).
Check (GbtDevelopable.Section_1_proofs.intro_gauss.proved : GbtDevelopable.Section_1.intro_gauss.statement).
Check (GbtDevelopable.Section_1_proofs.intro_gauss.met : GbtDevelopable.Section_1.intro_gauss.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g0.proved : GbtDevelopable.Section_2_1_printed.def_1_g0.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g0.met : GbtDevelopable.Section_2_1_printed.def_1_g0.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g1.proved : GbtDevelopable.Section_2_1_printed.def_1_g1.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g1.met : GbtDevelopable.Section_2_1_printed.def_1_g1.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g2.proved : GbtDevelopable.Section_2_1_printed.def_1_g2.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_g2.met : GbtDevelopable.Section_2_1_printed.def_1_g2.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_range.proved : GbtDevelopable.Section_2_1_printed.def_1_range.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_range.met : GbtDevelopable.Section_2_1_printed.def_1_range.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.eq_2_1.proved : GbtDevelopable.Section_2_1_printed.eq_2_1.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.eq_2_1.met : GbtDevelopable.Section_2_1_printed.eq_2_1.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_zero.proved : GbtDevelopable.Section_2_1_printed.def_1_zero.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.def_1_zero.met : GbtDevelopable.Section_2_1_printed.def_1_zero.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_functions.refuted : ~ GbtDevelopable.Section_2_1_printed.thm_1_1_k2_functions.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_substitution.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_k2_substitution.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_substitution.met : GbtDevelopable.Section_2_1_printed.thm_1_1_k2_substitution.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_functions.refuted : ~ GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_functions.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_substitution.refuted : ~ GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_substitution.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_letters.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_letters.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_letters.met : GbtDevelopable.Section_2_1_printed.thm_1_1_k3plus_letters.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration.met : GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration_only.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration_only.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration_only.met : GbtDevelopable.Section_2_1_printed.thm_1_1_degeneration_only.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_no_degeneration.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_no_degeneration.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_no_degeneration.met : GbtDevelopable.Section_2_1_printed.thm_1_1_no_degeneration.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_jets.proved : GbtDevelopable.Section_2_1_printed.thm_1_1_jets.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_jets.met : GbtDevelopable.Section_2_1_printed.thm_1_1_jets.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_2.proved : GbtDevelopable.Section_2_1_printed.thm_1_2.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_2.met : GbtDevelopable.Section_2_1_printed.thm_1_2.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_3.proved : GbtDevelopable.Section_2_1_printed.thm_1_3.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_3.met : GbtDevelopable.Section_2_1_printed.thm_1_3.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_4.proved : GbtDevelopable.Section_2_1_printed.thm_1_4.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_4.met : GbtDevelopable.Section_2_1_printed.thm_1_4.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5.refuted : ~ GbtDevelopable.Section_2_1_printed.thm_1_5.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_quadratic.proved : GbtDevelopable.Section_2_1_printed.thm_1_5_quadratic.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_quadratic.met : GbtDevelopable.Section_2_1_printed.thm_1_5_quadratic.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_cubic.proved : GbtDevelopable.Section_2_1_printed.thm_1_5_cubic.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_cubic.met : GbtDevelopable.Section_2_1_printed.thm_1_5_cubic.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_all.proved : GbtDevelopable.Section_2_1_printed.thm_1_5_all.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_all.met : GbtDevelopable.Section_2_1_printed.thm_1_5_all.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_a.proved : GbtDevelopable.Section_2_1_printed.thm_1_6_a.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_a.met : GbtDevelopable.Section_2_1_printed.thm_1_6_a.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_b.proved : GbtDevelopable.Section_2_1_printed.thm_1_6_b.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_b.met : GbtDevelopable.Section_2_1_printed.thm_1_6_b.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_c.proved : GbtDevelopable.Section_2_1_printed.thm_1_6_c.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_c.met : GbtDevelopable.Section_2_1_printed.thm_1_6_c.instance).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_d.proved : GbtDevelopable.Section_2_1_printed.thm_1_6_d.statement).
Check (GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_d.met : GbtDevelopable.Section_2_1_printed.thm_1_6_d.instance).
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
Check (GbtDevelopable.Section_2_2_printed_proofs.def_2_dim.refuted : ~ GbtDevelopable.Section_2_2_printed.def_2_dim.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_endpoints.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_endpoints.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_endpoints.met : GbtDevelopable.Section_2_2_printed.sec_2_2_endpoints.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_convexity.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_convexity.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_convexity.met : GbtDevelopable.Section_2_2_printed.sec_2_2_convexity.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry.met : GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry_exchange.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.met : GbtDevelopable.Section_2_2_printed.sec_2_2_symmetry_exchange.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_quadratic.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_vd_quadratic.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_quadratic.met : GbtDevelopable.Section_2_2_printed.sec_2_2_vd_quadratic.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_operator.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_vd_operator.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_operator.met : GbtDevelopable.Section_2_2_printed.sec_2_2_vd_operator.instance).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_geominv.proved : GbtDevelopable.Section_2_2_printed.sec_2_2_geominv.statement).
Check (GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_geominv.met : GbtDevelopable.Section_2_2_printed.sec_2_2_geominv.instance).
Check (GbtDevelopable.Section_2_2_proofs.def_2_dim.refuted : ~ GbtDevelopable.Section_2_2.def_2_dim.statement).
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
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_curve.refuted : ~ GbtDevelopable.Section_2_3_printed.sec_2_3_local_part_of_a_curve.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_local_part_of_a_composite.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.met : GbtDevelopable.Section_2_3_printed.sec_2_3_local_part_of_a_composite.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_linear.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_linear.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_linear.met : GbtDevelopable.Section_2_3_printed.sec_2_3_linear.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_3.refuted : ~ GbtDevelopable.Section_2_3_printed.eq_2_3.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_3_corrected.proved : GbtDevelopable.Section_2_3_printed.eq_2_3_corrected.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_3_corrected.met : GbtDevelopable.Section_2_3_printed.eq_2_3_corrected.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_4.refuted : ~ GbtDevelopable.Section_2_3_printed.eq_2_4.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_4_corrected.proved : GbtDevelopable.Section_2_3_printed.eq_2_4_corrected.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.eq_2_4_corrected.met : GbtDevelopable.Section_2_3_printed.eq_2_4_corrected.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_mu.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_indep_mu.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_mu.met : GbtDevelopable.Section_2_3_printed.sec_2_3_indep_mu.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_nu.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_indep_nu.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_nu.met : GbtDevelopable.Section_2_3_printed.sec_2_3_indep_nu.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_move.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_move.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_move.met : GbtDevelopable.Section_2_3_printed.sec_2_3_move.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu.met : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu_single.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu_single.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu_single.met : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_mu_single.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_nu.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_nu.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_nu.met : GbtDevelopable.Section_2_3_printed.sec_2_3_dir_nu.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_range.refuted : ~ GbtDevelopable.Section_2_3_printed.sec_2_3_range.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_1.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_1.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_1.met : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_1.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted : ~ GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_boundary_of_the_hull.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_control_polygon.refuted : ~ GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_control_polygon.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_quadratic.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.met : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_quadratic.instance).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_mean.proved : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_mean.statement).
Check (GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_mean.met : GbtDevelopable.Section_2_3_printed.sec_2_3_concl_2_mean.instance).
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
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.proved : GbtDevelopable.Section_2_3.sec_2_3_concl_2_mean.statement).
Check (GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.met : GbtDevelopable.Section_2_3.sec_2_3_concl_2_mean.instance).
Check (GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_space.proved : GbtDevelopable.Section_3_1_printed.sec_3_1_space.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_space.met : GbtDevelopable.Section_3_1_printed.sec_3_1_space.instance).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_2.proved : GbtDevelopable.Section_3_1_printed.eq_3_2.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_2.met : GbtDevelopable.Section_3_1_printed.eq_3_2.instance).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_3.proved : GbtDevelopable.Section_3_1_printed.eq_3_3.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_3.met : GbtDevelopable.Section_3_1_printed.eq_3_3.instance).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_4.proved : GbtDevelopable.Section_3_1_printed.eq_3_4.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.eq_3_4.met : GbtDevelopable.Section_3_1_printed.eq_3_4.instance).
Check (GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref.refuted : ~ GbtDevelopable.Section_3_1_printed.sec_3_1_ref.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref_true.proved : GbtDevelopable.Section_3_1_printed.sec_3_1_ref_true.statement).
Check (GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref_true.met : GbtDevelopable.Section_3_1_printed.sec_3_1_ref_true.instance).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved : GbtDevelopable.Section_3_1.sec_3_1_space.statement).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met : GbtDevelopable.Section_3_1.sec_3_1_space.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_2.proved : GbtDevelopable.Section_3_1.eq_3_2.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_2.met : GbtDevelopable.Section_3_1.eq_3_2.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_3.proved : GbtDevelopable.Section_3_1.eq_3_3.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_3.met : GbtDevelopable.Section_3_1.eq_3_3.instance).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_4.proved : GbtDevelopable.Section_3_1.eq_3_4.statement).
Check (GbtDevelopable.Section_3_1_proofs.eq_3_4.met : GbtDevelopable.Section_3_1.eq_3_4.instance).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_ref.refuted : ~ GbtDevelopable.Section_3_1.sec_3_1_ref.statement).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_ref_true.proved : GbtDevelopable.Section_3_1.sec_3_1_ref_true.statement).
Check (GbtDevelopable.Section_3_1_proofs.sec_3_1_ref_true.met : GbtDevelopable.Section_3_1.sec_3_1_ref_true.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_5.proved : GbtDevelopable.Section_3_2_printed.eq_3_5.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_5.met : GbtDevelopable.Section_3_2_printed.eq_3_5.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_6.proved : GbtDevelopable.Section_3_2_printed.eq_3_6.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_6.met : GbtDevelopable.Section_3_2_printed.eq_3_6.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_phi.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_phi.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_theta.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_theta.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_theta.met : GbtDevelopable.Section_3_2_printed.sec_3_2_theta.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_phi_exp.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_phi_exp.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_vec.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_vec.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_vec.met : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_vec.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_nearest.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_nearest.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_nearest.met : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_nearest.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_x.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_x.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_y.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_y.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_z.refuted : ~ GbtDevelopable.Section_3_2_printed.sec_3_2_psi_z.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_z_corrected.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_z_corrected.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_den.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_psi_den.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_7.proved : GbtDevelopable.Section_3_2_printed.eq_3_7.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.eq_3_7.met : GbtDevelopable.Section_3_2_printed.eq_3_7.instance).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_envelope.proved : GbtDevelopable.Section_3_2_printed.sec_3_2_envelope.statement).
Check (GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_envelope.met : GbtDevelopable.Section_3_2_printed.sec_3_2_envelope.instance).
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
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_8.proved : GbtDevelopable.Section_3_3_printed.eq_3_8.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_8.met : GbtDevelopable.Section_3_3_printed.eq_3_8.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_9.proved : GbtDevelopable.Section_3_3_printed.eq_3_9.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_9.met : GbtDevelopable.Section_3_3_printed.eq_3_9.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec.refuted : ~ GbtDevelopable.Section_3_3_printed.sec_3_3_S_vec.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_S_vec_corrected.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.met : GbtDevelopable.Section_3_3_printed.sec_3_3_S_vec_corrected.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_x.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_S_x.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_y.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_S_y.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_z.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_S_z.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_den.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_S_den.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_regression.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression.met : GbtDevelopable.Section_3_3_printed.sec_3_3_regression.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_velocity.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_regression_velocity.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_velocity.met : GbtDevelopable.Section_3_3_printed.sec_3_3_regression_velocity.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_quadratic.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_regression_quadratic.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_quadratic.met : GbtDevelopable.Section_3_3_printed.sec_3_3_regression_quadratic.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_10.proved : GbtDevelopable.Section_3_3_printed.eq_3_10.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.eq_3_10.met : GbtDevelopable.Section_3_3_printed.eq_3_10.instance).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_developable.proved : GbtDevelopable.Section_3_3_printed.sec_3_3_developable.statement).
Check (GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_developable.met : GbtDevelopable.Section_3_3_printed.sec_3_3_developable.instance).
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
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_a.proved : GbtDevelopable.Section_3_4_printed.eq_3_11_a.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_a.met : GbtDevelopable.Section_3_4_printed.eq_3_11_a.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_b.proved : GbtDevelopable.Section_3_4_printed.eq_3_11_b.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_b.met : GbtDevelopable.Section_3_4_printed.eq_3_11_b.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_c.proved : GbtDevelopable.Section_3_4_printed.eq_3_11_c.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_c.met : GbtDevelopable.Section_3_4_printed.eq_3_11_c.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_a.proved : GbtDevelopable.Section_3_4_printed.eq_3_12_a.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_a.met : GbtDevelopable.Section_3_4_printed.eq_3_12_a.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_b.proved : GbtDevelopable.Section_3_4_printed.eq_3_12_b.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_b.met : GbtDevelopable.Section_3_4_printed.eq_3_12_b.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_c.proved : GbtDevelopable.Section_3_4_printed.eq_3_12_c.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_c.met : GbtDevelopable.Section_3_4_printed.eq_3_12_c.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_tangent_ends.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_tangent_ends.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_tangent_ends.met : GbtDevelopable.Section_3_4_printed.sec_3_4_tangent_ends.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_13.proved : GbtDevelopable.Section_3_4_printed.eq_3_13.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.eq_3_13.met : GbtDevelopable.Section_3_4_printed.eq_3_13.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J0.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_J0.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J0.met : GbtDevelopable.Section_3_4_printed.sec_3_4_J0.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_dual.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_dual.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_dual.met : GbtDevelopable.Section_3_4_printed.sec_3_4_dual.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_J1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_J1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r2.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r2.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r2.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r2.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2.refuted : ~ GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c2.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c2_corrected.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c2_corrected.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_true.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_true.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_true.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_true.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3.refuted : ~ GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c3.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c3_corrected.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m0_r3_c3_corrected.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r2.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r2.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r2.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r2.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2.refuted : ~ GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c2.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c2_corrected.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c2_corrected.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_true.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_true.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_true.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_true.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c3.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.met : GbtDevelopable.Section_3_4_printed.sec_3_4_m1_r3_c3.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_S0.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0.met : GbtDevelopable.Section_3_4_printed.sec_3_4_S0.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0_gen.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_S0_gen.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0_gen.met : GbtDevelopable.Section_3_4_printed.sec_3_4_S0_gen.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_S1.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1.met : GbtDevelopable.Section_3_4_printed.sec_3_4_S1.instance).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1_gen.proved : GbtDevelopable.Section_3_4_printed.sec_3_4_S1_gen.statement).
Check (GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1_gen.met : GbtDevelopable.Section_3_4_printed.sec_3_4_S1_gen.instance).
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
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q0.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_Q0.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q0.met : GbtDevelopable.Section_4_1_printed.ex_4_1_Q0.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q1.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_Q1.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q1.met : GbtDevelopable.Section_4_1_printed.ex_4_1_Q1.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q2.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_Q2.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q2.met : GbtDevelopable.Section_4_1_printed.ex_4_1_Q2.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q3.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_Q3.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q3.met : GbtDevelopable.Section_4_1_printed.ex_4_1_Q3.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_distance.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_distance.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_distance.met : GbtDevelopable.Section_4_1_printed.ex_4_1_distance.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_coplanar.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_coplanar.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_coplanar.met : GbtDevelopable.Section_4_1_printed.ex_4_1_coplanar.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_a.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c1_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_a.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c1_a.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_lengths.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths.met : GbtDevelopable.Section_4_1_printed.ex_4_1_lengths.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_lengths_exchanged.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.met : GbtDevelopable.Section_4_1_printed.ex_4_1_lengths_exchanged.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c1_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_b.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c1_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_c.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c1_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_d.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c1_d.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_e.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c1_e.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c1_f_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_a.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c2_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_a.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c2_a.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c2_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_b.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c2_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_c.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c2_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_d.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c2_d.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c2_e_there_and_nowhere_else.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_a.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_1_c3_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_b.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_c.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_c.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_c.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_d.proved : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_d.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_d.met : GbtDevelopable.Section_4_1_printed.ex_4_1_c3_d.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q0.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_Q0.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q0.met : GbtDevelopable.Section_4_1_printed.ex_4_2_Q0.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q1.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_Q1.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q1.met : GbtDevelopable.Section_4_1_printed.ex_4_2_Q1.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q2.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q2.met : GbtDevelopable.Section_4_1_printed.ex_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q3.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_Q3.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q3.met : GbtDevelopable.Section_4_1_printed.ex_4_2_Q3.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_class.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_class.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_pencil.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_pencil.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_pencil.met : GbtDevelopable.Section_4_1_printed.ex_4_2_pencil.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_lengths.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_lengths.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_lengths.met : GbtDevelopable.Section_4_1_printed.ex_4_2_lengths.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_a.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_c1_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c1_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_b.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c1_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_c.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c1_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_c.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c1_c.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_d.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_c1_d.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_e.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_c1_e.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_a.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_c2_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_b.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_c.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_c.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_c.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_d.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_d.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_d.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c2_d.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_a.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_a.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_a.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_a.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_b.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_b.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_b.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_b.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_c.proved : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_c.statement).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_c.met : GbtDevelopable.Section_4_1_printed.ex_4_2_c3_c.instance).
Check (GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_d.refuted : ~ GbtDevelopable.Section_4_1_printed.ex_4_2_c3_d.statement).
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
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q0.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_Q0.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q0.met : GbtDevelopable.Section_4_2_printed.sec_4_2_Q0.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_Q1.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1.met : GbtDevelopable.Section_4_2_printed.sec_4_2_Q1.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1_lengths.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_Q1_lengths.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q2.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_Q2.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q2.met : GbtDevelopable.Section_4_2_printed.sec_4_2_Q2.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q3.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_Q3.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q3.met : GbtDevelopable.Section_4_2_printed.sec_4_2_Q3.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_quadrants.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_quadrants.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_quadrants.met : GbtDevelopable.Section_4_2_printed.sec_4_2_quadrants.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_distances.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_distances.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_distances.met : GbtDevelopable.Section_4_2_printed.sec_4_2_distances.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_class.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class.met : GbtDevelopable.Section_4_2_printed.sec_4_2_class.instance).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class_ends.proved : GbtDevelopable.Section_4_2_printed.sec_4_2_class_ends.statement).
Check (GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class_ends.met : GbtDevelopable.Section_4_2_printed.sec_4_2_class_ends.instance).
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
Check (GbtDevelopable.Section_4_printed_proofs.sec_4_midpoints.proved : GbtDevelopable.Section_4_printed.sec_4_midpoints.statement).
Check (GbtDevelopable.Section_4_printed_proofs.sec_4_midpoints.met : GbtDevelopable.Section_4_printed.sec_4_midpoints.instance).
Check (GbtDevelopable.Section_4_printed_proofs.ex_4_2_distance.proved : GbtDevelopable.Section_4_printed.ex_4_2_distance.statement).
Check (GbtDevelopable.Section_4_printed_proofs.ex_4_2_distance.met : GbtDevelopable.Section_4_printed.ex_4_2_distance.instance).
Check (GbtDevelopable.Section_4_printed_proofs.ex_4_2_coplanar.proved : GbtDevelopable.Section_4_printed.ex_4_2_coplanar.statement).
Check (GbtDevelopable.Section_4_printed_proofs.ex_4_2_coplanar.met : GbtDevelopable.Section_4_printed.ex_4_2_coplanar.instance).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved : GbtDevelopable.Section_4.sec_4_midpoints.statement).
Check (GbtDevelopable.Section_4_proofs.sec_4_midpoints.met : GbtDevelopable.Section_4.sec_4_midpoints.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved : GbtDevelopable.Section_4.ex_4_2_distance.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_distance.met : GbtDevelopable.Section_4.ex_4_2_distance.instance).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved : GbtDevelopable.Section_4.ex_4_2_coplanar.statement).
Check (GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met : GbtDevelopable.Section_4.ex_4_2_coplanar.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b.refuted : ~ GbtDevelopable.Section_5_1_printed.eq_5_3_b.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b_corrected.proved : GbtDevelopable.Section_5_1_printed.eq_5_3_b_corrected.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b_corrected.met : GbtDevelopable.Section_5_1_printed.eq_5_3_b_corrected.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_4.proved : GbtDevelopable.Section_5_1_printed.eq_5_4.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_4.met : GbtDevelopable.Section_5_1_printed.eq_5_4.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved : GbtDevelopable.Section_5_1_printed.eq_5_4_nec_suf_curves_of_four_coordinates.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met : GbtDevelopable.Section_5_1_printed.eq_5_4_nec_suf_curves_of_four_coordinates.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_in_space.refuted : ~ GbtDevelopable.Section_5_1_printed.eq_5_4_nec_suf_curves_in_space.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify.proved : GbtDevelopable.Section_5_1_printed.sec_5_1_certify.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify.met : GbtDevelopable.Section_5_1_printed.sec_5_1_certify.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_sheets.proved : GbtDevelopable.Section_5_1_printed.sec_5_1_certify_sheets.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_sheets.met : GbtDevelopable.Section_5_1_printed.sec_5_1_certify_sheets.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_cusp.proved : GbtDevelopable.Section_5_1_printed.sec_5_1_certify_cusp.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_cusp.met : GbtDevelopable.Section_5_1_printed.sec_5_1_certify_cusp.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_inflection.proved : GbtDevelopable.Section_5_1_printed.thm_2_inflection.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_inflection.met : GbtDevelopable.Section_5_1_printed.thm_2_inflection.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_families.proved : GbtDevelopable.Section_5_1_printed.sec_5_1_G0_families.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_families.met : GbtDevelopable.Section_5_1_printed.sec_5_1_G0_families.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_surfaces.refuted : ~ GbtDevelopable.Section_5_1_printed.sec_5_1_G0_surfaces.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_a.proved : GbtDevelopable.Section_5_1_printed.thm_2_a.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_a.met : GbtDevelopable.Section_5_1_printed.thm_2_a.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_b.proved : GbtDevelopable.Section_5_1_printed.thm_2_b.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_b.met : GbtDevelopable.Section_5_1_printed.thm_2_b.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_requirement.proved : GbtDevelopable.Section_5_1_printed.eq_5_7_requirement.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_requirement.met : GbtDevelopable.Section_5_1_printed.eq_5_7_requirement.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_equivalence.refuted : ~ GbtDevelopable.Section_5_1_printed.eq_5_7_equivalence.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_a.proved : GbtDevelopable.Section_5_1_printed.eq_5_8_a.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_a.met : GbtDevelopable.Section_5_1_printed.eq_5_8_a.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_b.proved : GbtDevelopable.Section_5_1_printed.eq_5_8_b.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_b.met : GbtDevelopable.Section_5_1_printed.eq_5_8_b.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_9.proved : GbtDevelopable.Section_5_1_printed.eq_5_9.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_9.met : GbtDevelopable.Section_5_1_printed.eq_5_9.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_10.proved : GbtDevelopable.Section_5_1_printed.eq_5_10.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.eq_5_10.met : GbtDevelopable.Section_5_1_printed.eq_5_10.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_sufficient.proved : GbtDevelopable.Section_5_1_printed.thm_2_sufficient.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_sufficient.met : GbtDevelopable.Section_5_1_printed.thm_2_sufficient.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_families.proved : GbtDevelopable.Section_5_1_printed.thm_2_necessary_families.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_families.met : GbtDevelopable.Section_5_1_printed.thm_2_necessary_families.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_1_printed.thm_2_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_necessary.proved : GbtDevelopable.Section_5_1_printed.thm_2_true_necessary.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_necessary.met : GbtDevelopable.Section_5_1_printed.thm_2_true_necessary.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sufficient.proved : GbtDevelopable.Section_5_1_printed.thm_2_true_sufficient.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sufficient.met : GbtDevelopable.Section_5_1_printed.thm_2_true_sufficient.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_generator.proved : GbtDevelopable.Section_5_1_printed.thm_2_true_generator.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_generator.met : GbtDevelopable.Section_5_1_printed.thm_2_true_generator.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sheets.proved : GbtDevelopable.Section_5_1_printed.thm_2_true_sheets.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sheets.met : GbtDevelopable.Section_5_1_printed.thm_2_true_sheets.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_families.proved : GbtDevelopable.Section_5_1_printed.thm_2_proof_comprise_families.statement).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_families.met : GbtDevelopable.Section_5_1_printed.thm_2_proof_comprise_families.instance).
Check (GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_surfaces.refuted : ~ GbtDevelopable.Section_5_1_printed.thm_2_proof_comprise_surfaces.statement).
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
Check (GbtDevelopable.Section_5_1_proofs.thm_2_inflection.proved : GbtDevelopable.Section_5_1.thm_2_inflection.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_inflection.met : GbtDevelopable.Section_5_1.thm_2_inflection.instance).
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
Check (GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_families.proved : GbtDevelopable.Section_5_1.thm_2_proof_comprise_families.statement).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_families.met : GbtDevelopable.Section_5_1.thm_2_proof_comprise_families.instance).
Check (GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_surfaces.refuted : ~ GbtDevelopable.Section_5_1.thm_2_proof_comprise_surfaces.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_11.proved : GbtDevelopable.Section_5_2_printed.eq_5_11.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_11.met : GbtDevelopable.Section_5_2_printed.eq_5_11.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_meaning.proved : GbtDevelopable.Section_5_2_printed.sec_5_2_meaning.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_meaning.met : GbtDevelopable.Section_5_2_printed.sec_5_2_meaning.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref.refuted : ~ GbtDevelopable.Section_5_2_printed.sec_5_2_ref.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref_true.proved : GbtDevelopable.Section_5_2_printed.sec_5_2_ref_true.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref_true.met : GbtDevelopable.Section_5_2_printed.sec_5_2_ref_true.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_index.refuted : ~ GbtDevelopable.Section_5_2_printed.sec_5_2_index.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_consts.proved : GbtDevelopable.Section_5_2_printed.thm_3_consts.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_consts.met : GbtDevelopable.Section_5_2_printed.thm_3_consts.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_a.proved : GbtDevelopable.Section_5_2_printed.thm_3_a.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_a.met : GbtDevelopable.Section_5_2_printed.thm_3_a.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_b.proved : GbtDevelopable.Section_5_2_printed.thm_3_b.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_b.met : GbtDevelopable.Section_5_2_printed.thm_3_b.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_c.proved : GbtDevelopable.Section_5_2_printed.thm_3_c.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_c.met : GbtDevelopable.Section_5_2_printed.thm_3_c.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_sufficient.proved : GbtDevelopable.Section_5_2_printed.thm_3_sufficient.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_sufficient.met : GbtDevelopable.Section_5_2_printed.thm_3_sufficient.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_families.proved : GbtDevelopable.Section_5_2_printed.thm_3_necessary_families.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_families.met : GbtDevelopable.Section_5_2_printed.thm_3_necessary_families.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_2_printed.thm_3_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_13.proved : GbtDevelopable.Section_5_2_printed.eq_5_13.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_13.met : GbtDevelopable.Section_5_2_printed.eq_5_13.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_15.proved : GbtDevelopable.Section_5_2_printed.eq_5_15.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.eq_5_15.met : GbtDevelopable.Section_5_2_printed.eq_5_15.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref.refuted : ~ GbtDevelopable.Section_5_2_printed.thm_3_proofref.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref_true.proved : GbtDevelopable.Section_5_2_printed.thm_3_proofref_true.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref_true.met : GbtDevelopable.Section_5_2_printed.thm_3_proofref_true.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_families.proved : GbtDevelopable.Section_5_2_printed.sec_5_2_must_families.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_families.met : GbtDevelopable.Section_5_2_printed.sec_5_2_must_families.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_surfaces.refuted : ~ GbtDevelopable.Section_5_2_printed.sec_5_2_must_surfaces.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_families.proved : GbtDevelopable.Section_5_2_printed.thm_3_proof_implies_families.statement).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_families.met : GbtDevelopable.Section_5_2_printed.thm_3_proof_implies_families.instance).
Check (GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_surfaces.refuted : ~ GbtDevelopable.Section_5_2_printed.thm_3_proof_implies_surfaces.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_11.proved : GbtDevelopable.Section_5_2.eq_5_11.statement).
Check (GbtDevelopable.Section_5_2_proofs.eq_5_11.met : GbtDevelopable.Section_5_2.eq_5_11.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.proved : GbtDevelopable.Section_5_2.sec_5_2_meaning.statement).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.met : GbtDevelopable.Section_5_2.sec_5_2_meaning.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_ref.refuted : ~ GbtDevelopable.Section_5_2.sec_5_2_ref.statement).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.proved : GbtDevelopable.Section_5_2.sec_5_2_ref_true.statement).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.met : GbtDevelopable.Section_5_2.sec_5_2_ref_true.instance).
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
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref.refuted : ~ GbtDevelopable.Section_5_2.thm_3_proofref.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.proved : GbtDevelopable.Section_5_2.thm_3_proofref_true.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.met : GbtDevelopable.Section_5_2.thm_3_proofref_true.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_must_families.proved : GbtDevelopable.Section_5_2.sec_5_2_must_families.statement).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_must_families.met : GbtDevelopable.Section_5_2.sec_5_2_must_families.instance).
Check (GbtDevelopable.Section_5_2_proofs.sec_5_2_must_surfaces.refuted : ~ GbtDevelopable.Section_5_2.sec_5_2_must_surfaces.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_families.proved : GbtDevelopable.Section_5_2.thm_3_proof_implies_families.statement).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_families.met : GbtDevelopable.Section_5_2.thm_3_proof_implies_families.instance).
Check (GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_surfaces.refuted : ~ GbtDevelopable.Section_5_2.thm_3_proof_implies_surfaces.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_consts.proved : GbtDevelopable.Section_5_3_printed.thm_4_consts.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_consts.met : GbtDevelopable.Section_5_3_printed.thm_4_consts.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_a.proved : GbtDevelopable.Section_5_3_printed.thm_4_a.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_a.met : GbtDevelopable.Section_5_3_printed.thm_4_a.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_b.proved : GbtDevelopable.Section_5_3_printed.thm_4_b.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_b.met : GbtDevelopable.Section_5_3_printed.thm_4_b.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_c.refuted : ~ GbtDevelopable.Section_5_3_printed.thm_4_c.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_corrected.proved : GbtDevelopable.Section_5_3_printed.thm_4_c_corrected.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_corrected.met : GbtDevelopable.Section_5_3_printed.thm_4_c_corrected.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_true.proved : GbtDevelopable.Section_5_3_printed.thm_4_c_true.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_true.met : GbtDevelopable.Section_5_3_printed.thm_4_c_true.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.eq_5_17.proved : GbtDevelopable.Section_5_3_printed.eq_5_17.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.eq_5_17.met : GbtDevelopable.Section_5_3_printed.eq_5_17.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_sufficient.proved : GbtDevelopable.Section_5_3_printed.thm_4_sufficient.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_sufficient.met : GbtDevelopable.Section_5_3_printed.thm_4_sufficient.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_families.proved : GbtDevelopable.Section_5_3_printed.thm_4_necessary_families.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_families.met : GbtDevelopable.Section_5_3_printed.thm_4_necessary_families.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_surfaces.refuted : ~ GbtDevelopable.Section_5_3_printed.thm_4_necessary_surfaces.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_necessary.proved : GbtDevelopable.Section_5_3_printed.thm_4_true_necessary.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_necessary.met : GbtDevelopable.Section_5_3_printed.thm_4_true_necessary.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sufficient.proved : GbtDevelopable.Section_5_3_printed.thm_4_true_sufficient.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sufficient.met : GbtDevelopable.Section_5_3_printed.thm_4_true_sufficient.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sheets.proved : GbtDevelopable.Section_5_3_printed.thm_4_true_sheets.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sheets.met : GbtDevelopable.Section_5_3_printed.thm_4_true_sheets.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_curvature.proved : GbtDevelopable.Section_5_3_printed.thm_4_true_curvature.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_curvature.met : GbtDevelopable.Section_5_3_printed.thm_4_true_curvature.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_families.proved : GbtDevelopable.Section_5_3_printed.thm_4_proof_must_families.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_families.met : GbtDevelopable.Section_5_3_printed.thm_4_proof_must_families.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_surfaces.refuted : ~ GbtDevelopable.Section_5_3_printed.thm_4_proof_must_surfaces.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_families.proved : GbtDevelopable.Section_5_3_printed.thm_4_proof_establish_families.statement).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_families.met : GbtDevelopable.Section_5_3_printed.thm_4_proof_establish_families.instance).
Check (GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_surfaces.refuted : ~ GbtDevelopable.Section_5_3_printed.thm_4_proof_establish_surfaces.statement).
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
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_families.proved : GbtDevelopable.Section_5_3.thm_4_proof_must_families.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_families.met : GbtDevelopable.Section_5_3.thm_4_proof_must_families.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_surfaces.refuted : ~ GbtDevelopable.Section_5_3.thm_4_proof_must_surfaces.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_families.proved : GbtDevelopable.Section_5_3.thm_4_proof_establish_families.statement).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_families.met : GbtDevelopable.Section_5_3.thm_4_proof_establish_families.instance).
Check (GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_surfaces.refuted : ~ GbtDevelopable.Section_5_3.thm_4_proof_establish_surfaces.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s1.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_s1.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s1.met : GbtDevelopable.Section_5_4_printed.alg_5_4_s1.instance).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_families.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_s2_families.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_families.met : GbtDevelopable.Section_5_4_printed.alg_5_4_s2_families.instance).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_surfaces.refuted : ~ GbtDevelopable.Section_5_4_printed.alg_5_4_s2_surfaces.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s3.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_s3.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s3.met : GbtDevelopable.Section_5_4_printed.alg_5_4_s3.instance).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s4.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_s4.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s4.met : GbtDevelopable.Section_5_4_printed.alg_5_4_s4.instance).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s5.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_s5.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s5.met : GbtDevelopable.Section_5_4_printed.alg_5_4_s5.instance).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_iterate.proved : GbtDevelopable.Section_5_4_printed.alg_5_4_iterate.statement).
Check (GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_iterate.met : GbtDevelopable.Section_5_4_printed.alg_5_4_iterate.instance).
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
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_construct.proved : GbtDevelopable.Section_5_5_printed.ex_5_1_construct.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_construct.met : GbtDevelopable.Section_5_5_printed.ex_5_1_construct.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_shape.proved : GbtDevelopable.Section_5_5_printed.ex_5_1_shape_shape.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_shape.met : GbtDevelopable.Section_5_5_printed.ex_5_1_shape_shape.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_combined_surface.refuted : ~ GbtDevelopable.Section_5_5_printed.ex_5_1_shape_combined_surface.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q02.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_Q02.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q02.met : GbtDevelopable.Section_5_5_printed.ex_5_2_Q02.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q12.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_Q12.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q12.met : GbtDevelopable.Section_5_5_printed.ex_5_2_Q12.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q22.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_Q22.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q22.met : GbtDevelopable.Section_5_5_printed.ex_5_2_Q22.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gamma_one.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_gamma_one.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gamma_one.met : GbtDevelopable.Section_5_5_printed.ex_5_2_gamma_one.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_surfaces.refuted : ~ GbtDevelopable.Section_5_5_printed.ex_5_2_gap_surfaces.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_gap_drawn_pieces.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.met : GbtDevelopable.Section_5_5_printed.ex_5_2_gap_drawn_pieces.instance).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_one_line.proved : GbtDevelopable.Section_5_5_printed.ex_5_2_one_line.statement).
Check (GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_one_line.met : GbtDevelopable.Section_5_5_printed.ex_5_2_one_line.instance).
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
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.proved : GbtDevelopable.Section_5_5.ex_5_2_one_line.statement).
Check (GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.met : GbtDevelopable.Section_5_5.ex_5_2_one_line.instance).
Check (GbtDevelopable.Section_5_printed_proofs.eq_5_1.proved : GbtDevelopable.Section_5_printed.eq_5_1.statement).
Check (GbtDevelopable.Section_5_printed_proofs.eq_5_1.met : GbtDevelopable.Section_5_printed.eq_5_1.instance).
Check (GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_a.proved : GbtDevelopable.Section_5_printed.sec_5_weighted_a.statement).
Check (GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_a.met : GbtDevelopable.Section_5_printed.sec_5_weighted_a.instance).
Check (GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.proved : GbtDevelopable.Section_5_printed.sec_5_weighted_b_four_coordinates.statement).
Check (GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.met : GbtDevelopable.Section_5_printed.sec_5_weighted_b_four_coordinates.instance).
Check (GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_after_division.refuted : ~ GbtDevelopable.Section_5_printed.sec_5_weighted_b_after_division.statement).
Check (GbtDevelopable.Section_5_printed_proofs.eq_5_2.proved : GbtDevelopable.Section_5_printed.eq_5_2.statement).
Check (GbtDevelopable.Section_5_printed_proofs.eq_5_2.met : GbtDevelopable.Section_5_printed.eq_5_2.instance).
Check (GbtDevelopable.Section_5_proofs.eq_5_1.proved : GbtDevelopable.Section_5.eq_5_1.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_1.met : GbtDevelopable.Section_5.eq_5_1.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_a.proved : GbtDevelopable.Section_5.sec_5_weighted_a.statement).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_a.met : GbtDevelopable.Section_5.sec_5_weighted_a.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.proved : GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.statement).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.met : GbtDevelopable.Section_5.sec_5_weighted_b_four_coordinates.instance).
Check (GbtDevelopable.Section_5_proofs.sec_5_weighted_b_after_division.refuted : ~ GbtDevelopable.Section_5.sec_5_weighted_b_after_division.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_2.proved : GbtDevelopable.Section_5.eq_5_2.statement).
Check (GbtDevelopable.Section_5_proofs.eq_5_2.met : GbtDevelopable.Section_5.eq_5_2.instance).
Definition all_theorems : True :=
let _ := GbtDevelopable.Part_Abstract_printed_proofs.abs_conics_planes.refuted in
let _ := GbtDevelopable.Part_Abstract_printed_proofs.abs_conics_points.proved in
let _ := GbtDevelopable.Part_Abstract_printed_proofs.abs_4d_factor.proved in
let _ := GbtDevelopable.Part_Abstract_printed_proofs.abs_4d_factor.met in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_conics_planes.refuted in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_conics_points.proved in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.proved in
let _ := GbtDevelopable.Part_Abstract_proofs.abs_4d_factor.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_gk_by_the_printed_conditions.refuted in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_gk_there_are_such_compositions.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_gk_there_are_such_compositions.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_a.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_a.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_b_any_values.refuted in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_continuity_free_c_any_values.refuted in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_1.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_1.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_2.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_2.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_4.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_contrib_4.met in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_gauss.proved in
let _ := GbtDevelopable.Section_1_printed_proofs.intro_gauss.met in
let _ := GbtDevelopable.Section_1_proofs.intro_gk_by_the_printed_conditions.refuted in
let _ := GbtDevelopable.Section_1_proofs.intro_gk_there_are_such_compositions.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_gk_there_are_such_compositions.met in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_a.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_a.met in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_b_any_values.refuted in
let _ := GbtDevelopable.Section_1_proofs.intro_continuity_free_c_any_values.refuted in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_1.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_1.met in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_2.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_2.met in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_4.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_contrib_4.met in
let _ := GbtDevelopable.Section_1_proofs.intro_gauss.proved in
let _ := GbtDevelopable.Section_1_proofs.intro_gauss.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g0.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g0.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g1.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g1.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g2.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_g2.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_range.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_range.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.eq_2_1.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.eq_2_1.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_zero.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.def_1_zero.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_functions.refuted in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_substitution.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k2_substitution.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_functions.refuted in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_substitution.refuted in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_letters.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_k3plus_letters.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration_only.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_degeneration_only.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_no_degeneration.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_no_degeneration.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_jets.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_1_jets.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_2.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_2.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_3.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_3.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_4.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_4.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5.refuted in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_quadratic.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_quadratic.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_cubic.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_cubic.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_all.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_5_all.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_a.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_a.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_b.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_b.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_c.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_c.met in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_d.proved in
let _ := GbtDevelopable.Section_2_1_printed_proofs.thm_1_6_d.met in
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
let _ := GbtDevelopable.Section_2_2_printed_proofs.def_2_dim.refuted in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_endpoints.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_endpoints.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_convexity.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_convexity.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_symmetry_exchange.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_quadratic.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_quadratic.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_operator.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_vd_operator.met in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_geominv.proved in
let _ := GbtDevelopable.Section_2_2_printed_proofs.sec_2_2_geominv.met in
let _ := GbtDevelopable.Section_2_2_proofs.def_2_dim.refuted in
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
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_curve.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_local_part_of_a_composite.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_linear.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_linear.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_3.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_3_corrected.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_3_corrected.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_4.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_4_corrected.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.eq_2_4_corrected.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_mu.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_mu.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_nu.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_indep_nu.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_move.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_move.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu_single.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_mu_single.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_nu.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_dir_nu.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_range.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_1.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_1.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_boundary_of_the_hull.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_control_polygon.refuted in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_quadratic.met in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_mean.proved in
let _ := GbtDevelopable.Section_2_3_printed_proofs.sec_2_3_concl_2_mean.met in
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
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.proved in
let _ := GbtDevelopable.Section_2_3_proofs.sec_2_3_concl_2_mean.met in
let _ := GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_space.proved in
let _ := GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_space.met in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_2.proved in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_2.met in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_3.proved in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_3.met in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_4.proved in
let _ := GbtDevelopable.Section_3_1_printed_proofs.eq_3_4.met in
let _ := GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref.refuted in
let _ := GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref_true.proved in
let _ := GbtDevelopable.Section_3_1_printed_proofs.sec_3_1_ref_true.met in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.proved in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_space.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_2.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_2.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_3.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_3.met in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_4.proved in
let _ := GbtDevelopable.Section_3_1_proofs.eq_3_4.met in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_ref.refuted in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_ref_true.proved in
let _ := GbtDevelopable.Section_3_1_proofs.sec_3_1_ref_true.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_5.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_5.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_6.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_6.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_phi.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_theta.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_theta.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_phi_exp.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_vec.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_vec.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_nearest.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_nearest.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_x.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_y.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_z.refuted in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_z_corrected.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_psi_den.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_7.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.eq_3_7.met in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_envelope.proved in
let _ := GbtDevelopable.Section_3_2_printed_proofs.sec_3_2_envelope.met in
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
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_8.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_8.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_9.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_9.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec.refuted in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_vec_corrected.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_x.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_y.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_z.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_S_den.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_velocity.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_velocity.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_quadratic.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_regression_quadratic.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_10.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.eq_3_10.met in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_developable.proved in
let _ := GbtDevelopable.Section_3_3_printed_proofs.sec_3_3_developable.met in
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
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_a.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_a.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_b.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_b.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_c.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_11_c.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_a.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_a.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_b.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_b.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_c.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_12_c.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_tangent_ends.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_tangent_ends.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_13.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.eq_3_13.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J0.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J0.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_dual.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_dual.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_J1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r2.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r2.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2.refuted in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c2_corrected.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_true.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_true.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3.refuted in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m0_r3_c3_corrected.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r2.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r2.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2.refuted in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c2_corrected.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_true.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_true.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_m1_r3_c3.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0_gen.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S0_gen.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1.met in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1_gen.proved in
let _ := GbtDevelopable.Section_3_4_printed_proofs.sec_3_4_S1_gen.met in
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
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q0.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q0.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q1.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q1.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q2.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q2.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q3.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_Q3.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_distance.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_distance.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_coplanar.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_coplanar.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_a.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_a.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_lengths_exchanged.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_c.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_d.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_e.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c1_f_there_and_nowhere_else.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_a.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_a.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_c.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_d.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c2_e_there_and_nowhere_else.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_a.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_c.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_c.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_d.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_1_c3_d.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q0.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q0.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q1.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q1.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q2.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q2.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q3.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_Q3.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_class.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_pencil.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_pencil.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_lengths.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_lengths.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_a.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_c.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_c.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_d.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c1_e.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_a.refuted in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_c.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_c.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_d.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c2_d.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_a.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_a.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_b.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_b.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_c.proved in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_c.met in
let _ := GbtDevelopable.Section_4_1_printed_proofs.ex_4_2_c3_d.refuted in
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
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q0.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q0.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q1_lengths.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q2.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q2.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q3.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_Q3.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_quadrants.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_quadrants.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_distances.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_distances.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class.met in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class_ends.proved in
let _ := GbtDevelopable.Section_4_2_printed_proofs.sec_4_2_class_ends.met in
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
let _ := GbtDevelopable.Section_4_printed_proofs.sec_4_midpoints.proved in
let _ := GbtDevelopable.Section_4_printed_proofs.sec_4_midpoints.met in
let _ := GbtDevelopable.Section_4_printed_proofs.ex_4_2_distance.proved in
let _ := GbtDevelopable.Section_4_printed_proofs.ex_4_2_distance.met in
let _ := GbtDevelopable.Section_4_printed_proofs.ex_4_2_coplanar.proved in
let _ := GbtDevelopable.Section_4_printed_proofs.ex_4_2_coplanar.met in
let _ := GbtDevelopable.Section_4_proofs.sec_4_midpoints.proved in
let _ := GbtDevelopable.Section_4_proofs.sec_4_midpoints.met in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_distance.proved in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_distance.met in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.proved in
let _ := GbtDevelopable.Section_4_proofs.ex_4_2_coplanar.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b.refuted in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b_corrected.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_3_b_corrected.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_4.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_4.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_of_four_coordinates.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_4_nec_suf_curves_in_space.refuted in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_sheets.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_sheets.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_cusp.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_certify_cusp.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_inflection.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_inflection.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_families.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_families.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.sec_5_1_G0_surfaces.refuted in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_a.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_a.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_b.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_b.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_requirement.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_requirement.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_7_equivalence.refuted in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_a.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_a.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_b.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_8_b.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_9.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_9.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_10.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.eq_5_10.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_sufficient.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_sufficient.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_families.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_families.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_necessary.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_necessary.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sufficient.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sufficient.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_generator.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_generator.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sheets.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_true_sheets.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_families.proved in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_families.met in
let _ := GbtDevelopable.Section_5_1_printed_proofs.thm_2_proof_comprise_surfaces.refuted in
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
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_inflection.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_inflection.met in
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
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_families.proved in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_families.met in
let _ := GbtDevelopable.Section_5_1_proofs.thm_2_proof_comprise_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_11.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_11.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_meaning.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_meaning.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref_true.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_ref_true.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_index.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_consts.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_consts.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_a.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_a.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_b.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_b.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_c.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_c.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_sufficient.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_sufficient.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_families.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_families.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_13.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_13.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_15.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.eq_5_15.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref_true.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proofref_true.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_families.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_families.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.sec_5_2_must_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_families.proved in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_families.met in
let _ := GbtDevelopable.Section_5_2_printed_proofs.thm_3_proof_implies_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_11.proved in
let _ := GbtDevelopable.Section_5_2_proofs.eq_5_11.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.proved in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_meaning.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_ref.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.proved in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_ref_true.met in
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
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proofref_true.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_must_families.proved in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_must_families.met in
let _ := GbtDevelopable.Section_5_2_proofs.sec_5_2_must_surfaces.refuted in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_families.proved in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_families.met in
let _ := GbtDevelopable.Section_5_2_proofs.thm_3_proof_implies_surfaces.refuted in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_consts.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_consts.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_a.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_a.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_b.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_b.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_c.refuted in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_corrected.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_corrected.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_true.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_c_true.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.eq_5_17.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.eq_5_17.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_sufficient.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_sufficient.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_families.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_families.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_necessary_surfaces.refuted in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_necessary.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_necessary.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sufficient.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sufficient.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sheets.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_sheets.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_curvature.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_true_curvature.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_families.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_families.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_must_surfaces.refuted in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_families.proved in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_families.met in
let _ := GbtDevelopable.Section_5_3_printed_proofs.thm_4_proof_establish_surfaces.refuted in
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
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_families.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_families.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_must_surfaces.refuted in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_families.proved in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_families.met in
let _ := GbtDevelopable.Section_5_3_proofs.thm_4_proof_establish_surfaces.refuted in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s1.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s1.met in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_families.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_families.met in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s2_surfaces.refuted in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s3.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s3.met in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s4.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s4.met in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s5.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_s5.met in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_iterate.proved in
let _ := GbtDevelopable.Section_5_4_printed_proofs.alg_5_4_iterate.met in
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
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_construct.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_construct.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_shape.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_shape.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_1_shape_combined_surface.refuted in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q02.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q02.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q12.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q12.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q22.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_Q22.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gamma_one.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gamma_one.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_surfaces.refuted in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_gap_drawn_pieces.met in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_one_line.proved in
let _ := GbtDevelopable.Section_5_5_printed_proofs.ex_5_2_one_line.met in
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
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.proved in
let _ := GbtDevelopable.Section_5_5_proofs.ex_5_2_one_line.met in
let _ := GbtDevelopable.Section_5_printed_proofs.eq_5_1.proved in
let _ := GbtDevelopable.Section_5_printed_proofs.eq_5_1.met in
let _ := GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_a.proved in
let _ := GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_a.met in
let _ := GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.proved in
let _ := GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_four_coordinates.met in
let _ := GbtDevelopable.Section_5_printed_proofs.sec_5_weighted_b_after_division.refuted in
let _ := GbtDevelopable.Section_5_printed_proofs.eq_5_2.proved in
let _ := GbtDevelopable.Section_5_printed_proofs.eq_5_2.met in
let _ := GbtDevelopable.Section_5_proofs.eq_5_1.proved in
let _ := GbtDevelopable.Section_5_proofs.eq_5_1.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_a.proved in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_a.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.proved in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_four_coordinates.met in
let _ := GbtDevelopable.Section_5_proofs.sec_5_weighted_b_after_division.refuted in
let _ := GbtDevelopable.Section_5_proofs.eq_5_2.proved in
let _ := GbtDevelopable.Section_5_proofs.eq_5_2.met in
I.
